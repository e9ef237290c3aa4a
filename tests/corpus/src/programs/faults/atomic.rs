//! An entry point that rolls back: after a fault the state is as before the call, and further calls are possible.

use bessemer::prelude::*;

/// Transfers between two tanks.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Tanks {
    levels: [u8; 2],
    transfers: u32,
}

#[component]
impl Tanks {
    /// Moves `amount` to the tank `to`; if that tank would overflow, nothing is moved.
    #[entry(atomic)]
    pub fn transfer(&mut self, to: usize, amount: u8, log: &mut u8) -> u8 {
        self.transfers += 1;
        *log = amount;
        self.levels[1 - to] -= amount;
        self.levels[to] += amount;
        if amount == 0 {
            return 0;
        }
        self.levels[to] / amount
    }
}
