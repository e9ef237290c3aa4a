//! A tuple struct is a struct whose parts are numbered; with one part, a newtype.

use bessemer::prelude::*;

/// A length, m.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Metres(pub f64);

/// A length, foot.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Feet(pub f64);

/// A way and the time that it took, s.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Leg(pub Metres, pub f64);

/// Conversion to metres.
#[function]
pub fn metres(feet: Feet) -> Metres {
    Metres(feet.0 * 0.3048)
}

/// Speed on a leg, m/s.
#[function]
pub fn speed(leg: &Leg) -> f64 {
    let Leg(Metres(way), time) = *leg;
    way / time
}
