//! Templates of companions, one for each method and function of std and nalgebra that the DSL supports.
//!
//! There is a trait for each kind of receiver, which rustc resolves as it resolves the method itself. The marker
//! names the operation; the front end knows its meaning.

/// Defines the markers of operations.
macro_rules! markers {
    ($($marker:ident: $kind:ident$(($operation:expr))?;)*) => {$(
        #[doc = concat!("The marker of `", stringify!($kind$(($operation))?), "`.")]
        pub struct $marker;
        impl Callee for $marker {
            fn callee(_: &mut Builder) -> tree::Callee {
                tree::Callee::Builtin(tree::Builtin::$kind$(($operation))?)
            }
        }
    )*};
}
pub(super) use markers;

/// Defines traits of companions, which are used only for their types and never run. A trait is written as the `impl`
/// of the type with the methods, or as a trait if there are several types. Generic parameters are in square brackets,
/// also those of a method. Each companion has a marker; its meaning is stated unless another marker states it. A
/// marker with a path is in square brackets, and a marker that each type defines is in angle brackets. The prelude
/// imports the traits from `traits`, which collects them.
macro_rules! companions {
    () => {};
    (pub mod traits[$($known:ident)*];) => {
        /// Module of the traits, for the prelude.
        pub mod traits {
            $(pub use super::$known as _;)*
        }
    };
    (
        $(pub mod traits $known:tt;)?
        $(#[$doc:meta])*
        impl[$($g:tt)*] $trait:ident $(<$($argument:ident),+>)? for [$element:ty] { $($companions:tt)* }
        $($more:tt)*
    ) => {
        $crate::generate::companions::companions! {
            $(pub mod traits $known;)?
            $(#[$doc])*
            pub trait $trait[$($g)*] { $($companions)* }
            $($more)*
        }
        impl<$($g)*> $trait $(<$($argument),+>)? for [$element] {}
    };
    (
        $(pub mod traits $known:tt;)?
        $(#[$doc:meta])*
        impl[$($g:tt)*] $trait:ident $(<$($argument:ident),+>)? for $of:ty
            $(where $place:ty: $bound:path)? { $($companions:tt)* }
        $($more:tt)*
    ) => {
        $crate::generate::companions::companions! {
            $(pub mod traits $known;)?
            $(#[$doc])*
            pub trait $trait[$($g)*]: Sized $(where $place: $bound)? { $($companions)* }
            $($more)*
        }
        impl<$($g)*> $trait $(<$($argument),+>)? for $of $(where $place: $bound)? {}
    };
    (
        $(pub mod traits[$($known:ident)*];)?
        $(#[$doc:meta])*
        pub trait $trait:ident $([$($g:tt)*])? $(: $($super:path),+)? $(where $place:ty: $limit:path)? {
            $($(#[$told:meta])* type $associated:ident $(: $kept:ident)?;)*
            $(
                fn $name:ident $([$($own:tt)*])? ($($parameters:tt)*) -> $result:ty
                    $(where $($of:ty: $bound:path),+)?
                    = $($marker:ident $(: $kind:ident$(($operation:expr))?)?)? $([$other:ty])? $(<$each:ident>)?;
            )*
        }
        $($more:tt)*
    ) => {
        $($($($crate::generate::companions::markers! { $marker: $kind$(($operation))?; })?)?)*

        $(#[$doc])*
        #[allow(missing_docs, unused_variables, clippy::type_complexity, clippy::too_many_arguments)]
        pub trait $trait $(<$($g)*>)? $(: $($super +)+)? $(where $place: $limit)? {
            $($(#[$told])* type $associated $(: $kept)?;)*
            $($(type $each: $crate::generate::Callee;)?)*
            $(
                fn $name $(<$($own)*>)? ($($parameters)*)
                    -> Called<$($marker)? $($other)? $(Self::$each)?, $result>
                $(where $($of: $bound),+)?
                {
                    unreachable!("a witness copy is never run")
                }
            )*
        }

        $crate::generate::companions::companions! { $(pub mod traits[$($known)* $trait];)? $($more)* }
    };
}
pub(super) use companions;

/// Defines companions of functions, in the same form.
macro_rules! calls {
    ($(
        $($function:ident)::+ [$($g:tt)*] ($($parameters:tt)*) -> $result:ty
            = $($marker:ident $(: $kind:ident$(($operation:expr))?)?)? $([$other:ty])?;
    )*) => {$(
        $($($crate::generate::companions::markers! { $marker: $kind$(($operation))?; })?)?

        impl $($function)::+ {
            pub fn __call<$($g)*>($($parameters)*) -> Called<$($marker)? $($other)?, $result> {
                unreachable!("a witness copy is never run")
            }
        }
    )*};
}
pub(super) use calls;
