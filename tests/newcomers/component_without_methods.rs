//! A component that is only a struct so far.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct WithoutMethods {
    pub last: f64,
}
