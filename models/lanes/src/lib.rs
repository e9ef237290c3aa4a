//! The onboard software for eight flights at once: the models, emitted by `bessemer-vectors` for vectors of eight lanes.
//!
//! A test compares `onboard.in` with the models; `UPDATE_DOCS=1 cargo test -p bessemer-tests vectors::` writes it.

#[rustfmt::skip]
#[allow(unused, missing_docs, nonstandard_style, clippy::all)]
mod onboard {
    include!("onboard.in");
}

pub use onboard::*;
