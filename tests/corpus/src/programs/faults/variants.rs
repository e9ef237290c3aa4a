//! A number that is no variant of an enum is a fault of the entry point that it is passed to.

use bessemer::prelude::*;

/// Commands of the pilot.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Wish {
    #[default]
    Stay,
    Climb,
    Sink,
}

/// Follows the pilot.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Follower {
    height: f64,
}

#[component]
impl Follower {
    /// The height to hold, m.
    #[entry]
    pub fn step(&mut self, wish: Wish) -> f64 {
        self.height += match wish {
            Wish::Stay => 0.0,
            Wish::Climb => 0.1,
            Wish::Sink => -0.1,
        };
        self.height
    }
}
