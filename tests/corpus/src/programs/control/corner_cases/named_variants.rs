//! Constants and variants with the names of other variants.

use bessemer::prelude::*;

#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Mode {
    #[default]
    Idle,
    Hover,
    Land,
}

#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Order {
    #[default]
    Stay,
    Move(i32),
    Stop,
}

/// Constants with the names of the variants, but other values.
#[allow(non_upper_case_globals)]
mod presets {
    use super::{Mode, Order};

    pub const Idle: Mode = Mode::Hover;
    pub const Stay: Order = Order::Stop;
    pub const LAND: Mode = Mode::Idle;
    pub use super::Mode::{Hover as Land, Land as Hover};
    pub use super::Order::{Stay as Stop, Stop as Still};
}

#[function]
pub fn by_constant(mode: Mode) -> u8 {
    match mode {
        presets::Idle => 1,
        Mode::Idle => 2,
        _ => 3,
    }
}

#[function]
pub fn by_other_name(mode: Mode) -> u8 {
    match mode {
        presets::Land => 1,
        presets::Hover => 2,
        presets::LAND => 3,
    }
}

#[function]
pub fn of_payload(order: Order) -> i32 {
    match order {
        presets::Stay => 1,
        Order::Move(by) => by,
        Order::Stay => 2,
    }
}

#[function]
pub fn of_payload_by_other_name(order: &Order) -> i32 {
    use presets::{Still, Stop};
    match *order {
        Stop => 1,
        Still => 2,
        Order::Move(by) => by,
    }
}

#[function]
pub fn asked(pair: (Mode, Order)) -> u8 {
    if matches!(pair, (presets::Idle, presets::Stay)) {
        return 1;
    }
    if let (presets::Land | Mode::Land, Order::Stay) = pair {
        return 2;
    }
    u8::from(pair.0 == presets::Idle) + 4 * u8::from(pair.1 == presets::Stay)
}
