//! A factorial.
use bessemer::prelude::*;

#[function]
fn factorial(n: u64) -> u64 {
    if n == 0 { 1 } else { n * factorial(n - 1) }
}

#[component]
#[derive(Default)]
pub struct Recursion {
    pub last: u64,
}

#[component]
impl Recursion {
    #[entry]
    pub fn step(&mut self, n: u64) -> u64 {
        self.last = factorial(n);
        self.last
    }
}
