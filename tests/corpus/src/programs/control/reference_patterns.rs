//! `ref` and `ref mut` in a pattern bind a reference to a part of the matched place.

use bessemer::prelude::*;

/// Commands of a valve.
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Order {
    Hold,
    Open { to: f64, ramp: [f64; 2] },
    Pulse(u16),
}

/// A valve.
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Valve {
    order: Order,
    last: Option<u16>,
    open: f64,
}

#[data]
impl Valve {
    /// Executes one step of the current command.
    pub fn advance(&mut self) -> f64 {
        match self.order {
            Order::Hold => {}
            Order::Open { to, ref mut ramp } => {
                ramp[0] += 0.5;
                self.open = (self.open + ramp[0]).min(to);
            }
            Order::Pulse(ref mut left) if *left > 0 => *left -= 1,
            Order::Pulse(_) => self.order = Order::Hold,
        }
        self.open
    }
}

/// Advances the valve by one step and returns the rest.
#[function]
pub fn advanced(valve: &mut Valve) -> f64 {
    let open = valve.advance();
    if let Some(ref mut last) = valve.last {
        *last = last.wrapping_add(3);
    }
    let Valve { order: ref told, ref last, .. } = *valve;
    match told {
        Order::Pulse(n) => open + f64::from(*n) + f64::from(last.unwrap_or(0)),
        _ => open,
    }
}
