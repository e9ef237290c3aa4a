//! A function that returns a reference is inlined: the call is the place, after the function's other statements. A
//! function that selects one of several places for reading returns a copy.

use bessemer::prelude::*;

/// One of three axes.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Axis {
    pub gain: f64,
    pub limit: f64,
}

#[data]
impl Axis {
    /// The command for an error, limited.
    pub fn command(&self, error: f64) -> f64 {
        (self.gain * error).min(self.limit)
    }

    /// Widens the limit.
    pub fn widen(&mut self, by: f64) {
        self.limit += by;
    }
}

/// Three axes, and the index of the main one.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Head {
    axes: [Axis; 3],
    main: usize,
}

#[data]
impl Head {
    /// An axis, for reading.
    pub fn axis(&self, i: usize) -> &Axis {
        &self.axes[i]
    }

    /// An axis, for writing; index 0 is another axis.
    pub fn axis_mut(&mut self, i: usize) -> &mut Axis {
        assert!(i > 0);
        &mut self.axes[i]
    }

    /// The main axis.
    pub fn main(&self) -> &Axis {
        self.axis(self.main)
    }

    /// The axis with the wider limit.
    pub fn wider(&self, i: usize, j: usize) -> &Axis {
        if self.axes[i].limit > self.axes[j].limit { &self.axes[i] } else { &self.axes[j] }
    }
}

/// Reads through returned references.
#[function]
pub fn commanded(head: &Head, i: usize, error: f64) -> f64 {
    let axis = head.axis(i);
    axis.command(error) + head.main().gain + head.wider(0, i).limit
}

/// Writes through returned references.
#[function]
pub fn widened(head: &mut Head, i: usize, by: f64) {
    head.axis_mut(i).gain = by;
    head.axis_mut(1).widen(by);
    for k in 1..3 {
        head.axis_mut(k).limit *= 2.0;
    }
    let axis = head.axis_mut(2);
    axis.widen(by);
    axis.gain -= 1.0;
}

/// An element of one of two slices, as if they were joined.
#[function]
pub fn behind<'a>(values: &'a [f64], other: &'a [f64], i: usize) -> &'a f64 {
    if i < values.len() { &values[i] } else { &other[i - values.len()] }
}

/// Reads an element of two joined slices.
#[function]
pub fn joined(left: &[f64; 3], right: &[f64; 2], i: usize) -> f64 {
    *behind(left, right, i) - *behind(right, left, 0)
}
