//! Even and odd, each by the other.
use bessemer::prelude::*;

#[function]
fn is_even(n: u8) -> bool {
    if n == 0 { true } else { is_odd(n - 1) }
}

#[function]
fn is_odd(n: u8) -> bool {
    if n == 0 { false } else { is_even(n - 1) }
}

#[component]
#[derive(Default)]
pub struct MutualRecursion {
    pub last: bool,
}

#[component]
impl MutualRecursion {
    #[entry]
    pub fn step(&mut self, n: u8) -> bool {
        self.last = is_even(n);
        self.last
    }
}
