//! Attribute of a type: persistent state or values.

/// Attribute of the item.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// `#[data]`, for values.
    Data,
    /// `#[component]`, for persistent state.
    Component,
}
