//! A test without an attribute, called in the guard of a `match`.
use bessemer::prelude::*;

fn is_odd(n: u8) -> bool {
    n % 2 == 1
}

#[component]
#[derive(Default)]
pub struct ForgotInAGuard {
    pub last: f64,
}

#[component]
impl ForgotInAGuard {
    #[entry]
    pub fn step(&mut self, n: u8) -> f64 {
        self.last = match n {
            0 => 0.0,
            n if is_odd(n) => 1.0,
            _ => 2.0,
        };
        self.last
    }
}
