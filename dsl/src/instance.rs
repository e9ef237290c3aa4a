//! Traits by which a named instance of a generic type is visible to the generator.

/// A generic type whose methods are in the C for a named instance: `#[component] pub type PidF32 = Pid<f32>;`.
///
/// Only the attribute of the `impl` block implements it. So all entry points of a generic component, and all public
/// methods of generic data, must be in one annotated block; for a second one rustc reports an error that names this
/// trait. A block for some instances, `impl Pid<f32>` beside `impl<T> Pid<T>`, is allowed.
pub trait EntriesInOneBlock {
    /// Builds them.
    #[cfg(feature = "generate")]
    #[doc(hidden)]
    fn build(cx: &mut crate::generate::Builder);
}

/// Entry points of an `impl` block for some of the instances.
pub trait EntriesOfSomeInstances {
    /// Builds them.
    #[cfg(feature = "generate")]
    #[doc(hidden)]
    fn build(cx: &mut crate::generate::Builder);
}
