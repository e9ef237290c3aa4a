#![no_std]
extern crate std;

use bessemer::prelude::*;

/// A law.
pub trait Law {
    /// Its answer.
    fn respond(&self, x: f64) -> f64;
}

/// Chooses by a table.
#[function]
pub fn trait_object(law: &dyn Law, x: f64) -> f64 {
    law.respond(x)
}

fn main() {}
