//! A misspelt attribute.
use bessemer::prelude::*;

#[componet]
#[derive(Default)]
pub struct Misspelt {
    pub last: f64,
}
