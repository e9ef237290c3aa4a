//! A case.
#![no_std]
use bessemer::prelude::*;

/// A word of C.
#[function]
#[c(name = "switch")]
pub fn chosen(x: f64) -> f64 {
    x
}

/// A name of POSIX.
#[function]
#[c(name = "mode_t")]
pub fn mode(x: f64) -> f64 {
    x
}

/// A name that another function has by itself.
#[function]
#[c(name = "models_plain")]
pub fn given(x: f64) -> f64 {
    x
}

/// Has it.
#[function]
pub fn plain(x: f64) -> f64 {
    x
}
