//! `PhantomData` distinguishes types with equal contents: units, and the states of a device. The C has a struct for
//! each, without the marker.

use core::marker::PhantomData;

use bessemer::prelude::*;

/// The unit metre.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Metres;

/// The unit second.
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
    /// A quantity with this value.
    pub fn new(value: f64) -> Self {
        Quantity { value, unit: PhantomData }
    }

    /// The sum of two quantities of the same unit.
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

/// State of a drive without current.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Idle;

/// State of a drive with current.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Armed;

/// A drive that turns only if it is armed.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Drive<S>(f64, PhantomData<S>);

#[data]
impl Drive<Idle> {
    /// Arms the drive with an initial speed.
    pub fn arm(self, speed: f64) -> Drive<Armed> {
        let Drive(before, _) = self;
        Drive(before + speed, PhantomData)
    }
}

#[data]
impl Drive<Armed> {
    /// Increases the speed and returns it.
    pub fn turn(&mut self, by: f64) -> f64 {
        self.0 += by;
        self.0
    }
}

/// Arms a drive and turns it.
#[function]
pub fn started(speed: f64, by: f64) -> f64 {
    let mut drive = Drive::<Idle>::default().arm(speed);
    drive.turn(by) * drive.turn(-by)
}
