//! A tuple struct is a struct with numbered fields; with one field it is a newtype.

use bessemer::prelude::*;

/// A length, m.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Metres(pub f64);

/// A length, ft.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Feet(pub f64);

/// A distance and the time that it took, s.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Leg(pub Metres, pub f64);

/// Converts a length to metres.
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
