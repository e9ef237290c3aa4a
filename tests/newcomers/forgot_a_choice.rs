//! An enum with payload without an attribute, in an option.
use bessemer::prelude::*;

#[derive(Clone, Copy)]
pub enum Order {
    Hold,
    Move(f64),
}

#[component]
#[derive(Default)]
pub struct ForgotAChoice {
    pub last: Option<Order>,
}

#[component]
impl ForgotAChoice {
    #[entry]
    pub fn step(&mut self, x: f64) -> f64 {
        self.last = Some(Order::Move(x));
        match self.last {
            Some(Order::Move(by)) => by,
            _ => 0.0,
        }
    }
}
