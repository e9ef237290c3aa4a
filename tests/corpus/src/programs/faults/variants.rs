//! A number that is not a variant of the enum is a fault of the entry point that gets it.

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

/// Executes the pilot's commands.
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
