//! `PhantomData` distinguishes types with equal contents: units, and the states of a device. The C has a struct for each, without it.

use core::marker::PhantomData;

use bessemer::prelude::*;

/// A unit.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Metres;

/// A unit.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Seconds;

/// A number with its unit.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Quantity<U> {
    pub value: f64,
    unit: PhantomData<U>,
}

#[data]
impl<U> Quantity<U> {
    /// So much of it.
    pub fn new(value: f64) -> Self {
        Quantity { value, unit: PhantomData }
    }

    /// Both.
    pub fn plus(self, other: Self) -> Self {
        Quantity { value: self.value + other.value, ..self }
    }
}

/// Mean speed of a return trip.
#[function]
pub fn pace(there: f64, back: f64, time: f64) -> f64 {
    let way = Quantity::<Metres>::new(there).plus(Quantity::new(back));
    let time: Quantity<Seconds> = Quantity::new(time);
    way.value / time.value
}

/// Without current.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Idle;

/// With it.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Armed;

/// A drive, which turns only where it is armed.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Drive<S>(f64, PhantomData<S>);

#[data]
impl Drive<Idle> {
    /// With a speed to begin with.
    pub fn arm(self, speed: f64) -> Drive<Armed> {
        let Drive(before, _) = self;
        Drive(before + speed, PhantomData)
    }
}

#[data]
impl Drive<Armed> {
    /// Faster.
    pub fn turn(&mut self, by: f64) -> f64 {
        self.0 += by;
        self.0
    }
}

/// From rest.
#[function]
pub fn started(speed: f64, by: f64) -> f64 {
    let mut drive = Drive::<Idle>::default().arm(speed);
    drive.turn(by) * drive.turn(-by)
}
