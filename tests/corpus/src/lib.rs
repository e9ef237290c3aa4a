//! Programs that are hard on a compiler, one file for each kind of trouble.
//!
//! `tests/tests/corpus.rs` runs every entry point natively, in the interpreter and as C. A new program
//! goes into the file of its kind and into the list at that file's end.

#![no_std]
#![allow(
    missing_docs,
    non_snake_case,
    mixed_script_confusables,
    non_upper_case_globals,
    clippy::all,
    unused_parens
)]

pub mod aliasing;
pub mod clash;
pub mod loops;
pub mod matching;
pub mod names;
pub mod order;
pub mod shapes;
pub mod unused;

/// An entry point, callable by words.
pub struct Entry {
    /// The component's name.
    pub component: &'static str,
    /// The entry point's.
    pub name: &'static str,
    /// Takes the words of the state and the arguments, gives those of the result, the state and what
    /// the arguments were changed to.
    pub run: fn(&mut dyn FnMut() -> u64, &mut dyn FnMut(u64)),
}

/// Every entry point.
pub fn entries() -> impl Iterator<Item = &'static Entry> {
    [
        aliasing::ENTRIES,
        clash::ENTRIES,
        loops::ENTRIES,
        matching::ENTRIES,
        names::ENTRIES,
        order::ENTRIES,
        shapes::ENTRIES,
        unused::ENTRIES,
    ]
    .into_iter()
    .flatten()
}

/// The list of a file's entry points: `Component::entry(type, &type, &mut type);`, and `unit` before
/// those without a result.
macro_rules! entry_points {
    (@argument mut $name:ident) => { &mut $name };
    (@argument ref $name:ident) => { &$name };
    (@argument val $name:ident) => { $name };
    (@result unit $call:expr, $out:ident) => { $call };
    (@result value $call:expr, $out:ident) => { bessemer::Plain::store(&$call, $out) };
    ($($kind:ident $component:ident :: $entry:ident ( $($pass:tt $name:ident : $ty:ty),* );)*) => {
        pub const ENTRIES: &[crate::Entry] = &[$(crate::Entry {
            component: stringify!($component),
            name: stringify!($entry),
            run: |next, out| {
                #[allow(unused_mut)]
                let mut this = <$component as bessemer::Plain>::load(next);
                $(#[allow(unused_mut)]
                let mut $name = <$ty as bessemer::Plain>::load(next);)*
                crate::entry_points!(@result $kind
                    this.$entry($(crate::entry_points!(@argument $pass $name)),*), out);
                bessemer::Plain::store(&this, out);
                $(crate::entry_points!(@changed $pass $name, out);)*
                let _ = (&next, &out);
            },
        }),*];
    };
    (@changed mut $name:ident, $out:ident) => { bessemer::Plain::store(&$name, $out) };
    (@changed $pass:tt $name:ident, $out:ident) => {};
}
pub(crate) use entry_points;
