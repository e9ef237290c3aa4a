//! A function that returns a reference is inlined: the call is the place, after the function's
//! other statements. A function that chooses among several places to read returns a copy.

use bessemer::prelude::*;

/// One of three.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Axis {
    pub gain: f64,
    pub limit: f64,
}

#[data]
impl Axis {
    /// Within the limit.
    pub fn command(&self, error: f64) -> f64 {
        (self.gain * error).min(self.limit)
    }

    /// Farther.
    pub fn widen(&mut self, by: f64) {
        self.limit += by;
    }
}

/// The three, and which counts.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Head {
    axes: [Axis; 3],
    main: usize,
}

#[data]
impl Head {
    /// To be read.
    pub fn axis(&self, i: usize) -> &Axis {
        &self.axes[i]
    }

    /// To be written; the first is fixed.
    pub fn axis_mut(&mut self, i: usize) -> &mut Axis {
        assert!(i > 0);
        &mut self.axes[i]
    }

    /// The one that counts.
    pub fn main(&self) -> &Axis {
        self.axis(self.main)
    }

    /// The one that goes farther.
    pub fn wider(&self, i: usize, j: usize) -> &Axis {
        if self.axes[i].limit > self.axes[j].limit { &self.axes[i] } else { &self.axes[j] }
    }
}

/// Places that are read.
#[function]
pub fn commanded(head: &Head, i: usize, error: f64) -> f64 {
    let axis = head.axis(i);
    axis.command(error) + head.main().gain + head.wider(0, i).limit
}

/// Places that are written.
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

/// The later of two, of any length.
#[function]
pub fn behind<'a>(values: &'a [f64], other: &'a [f64], i: usize) -> &'a f64 {
    if i < values.len() { &values[i] } else { &other[i - values.len()] }
}

/// From either.
#[function]
pub fn joined(left: &[f64; 3], right: &[f64; 2], i: usize) -> f64 {
    *behind(left, right, i) - *behind(right, left, 0)
}
