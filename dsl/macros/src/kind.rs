//! Which attribute stands on a type: state that lives on, or values.

/// Which attribute stands on the item.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// `#[data]`.
    Data,
    /// `#[component]`.
    Component,
}
