//! `#[c(name)]` sets the C names of items, fields and parameters, as a firmware's convention requires.
//! `#[c(section)]` sets the section of a table or a function. Methods, initialisers and variants follow their type's
//! name, unless they have their own.

use bessemer::prelude::*;

/// Commands of the valve.
#[data]
#[c(name = "ValveOrder_t")]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Order {
    #[default]
    #[c(name = "VALVE_HOLD")]
    Hold,
    /// Move to a fraction of the opening.
    Move(#[c(name = "wanted")] f32),
    /// Open or close as fast as possible.
    #[c(name = "VALVE_SLAM")]
    Slam { open: bool },
}

/// The flow at each eighth of the opening, l/min.
#[data]
#[c(name = "kValveFlow", section = ".rodata.curves")]
static FLOW: [f32; 9] = [0.0, 0.5, 1.75, 3.5, 5.5, 7.25, 8.5, 9.25, 9.5];

/// Fraction of the opening that it moves in a period.
#[data]
#[c(name = "kValveStep")]
const STEP: f32 = 0.125;

/// A valve that moves in steps.
#[component]
#[c(name = "Valve_t")]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MotorValve {
    /// Opening, 0 to 1.
    #[c(name = "fPosition")]
    pub position: f32,
    /// Number of movements.
    #[c(name = "u32Moves")]
    pub moves: u32,
}

#[component]
impl MotorValve {
    /// One period; returns the flow according to the curve, l/min.
    #[entry]
    #[c(result = "pFlow")]
    pub fn step(#[c(name = "pThis")] &mut self, #[c(name = "pOrder")] order: Order) -> f32 {
        let target = match order {
            Order::Hold => self.position,
            Order::Move(share) => share.clamp(0.0, 1.0),
            Order::Slam { open } => f32::from(u8::from(open)),
        };
        let change = (target - self.position).clamp(-STEP, STEP);
        if change != 0.0 {
            self.moves += 1;
        }
        self.position = (self.position + change).clamp(0.0, 1.0);
        FLOW[(self.position * 8.0) as usize]
    }

    /// Returns true if the valve is closed.
    #[entry(infallible)]
    pub fn closed(&self) -> bool {
        self.position <= 0.0
    }
}
