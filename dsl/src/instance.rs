//! The traits by which an instance of a generic type, once it has a name, shows itself to the generator.

/// A generic type whose methods an instance with a name of its own shows to C:
/// `#[component] pub type PidF32 = Pid<f32>;`.
///
/// The attribute of the `impl` block implements it, and nobody else. So all entry points of a generic
/// component, and all public methods of generic data, stand in one annotated block: a second one is
/// an error of rustc's that names this trait. A block for some instances, `impl Pid<f32>` beside `impl<T> Pid<T>`, adds
/// to theirs.
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
