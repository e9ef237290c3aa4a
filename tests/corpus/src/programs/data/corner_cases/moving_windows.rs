//! Windows that move by one or by a constant, in arrays: nothing can fault. By a variable and in slices of any length they fault
//! as Rust panics.

use bessemer::prelude::*;

/// A window over samples.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MovingWindow {
    samples: [f64; 8],
    marks: [u8; 5],
}

#[component]
impl MovingWindow {
    /// Adds a sample at the end.
    #[entry(infallible)]
    pub fn push(&mut self, sample: f64) -> f64 {
        self.samples.rotate_left(1);
        core::mem::replace(&mut self.samples[7], sample)
    }

    /// Adds one at the front.
    #[entry(infallible)]
    pub fn push_front(&mut self, sample: f64) -> f64 {
        self.samples.rotate_right(1);
        core::mem::replace(&mut self.samples[0], sample)
    }

    /// Moves all but one on.
    #[entry(infallible)]
    pub fn shift(&mut self, mark: u8) -> [u8; 5] {
        self.marks.copy_within(1.., 0);
        self.marks[4] = mark;
        self.marks
    }

    /// Moves parts by constants.
    #[entry(infallible)]
    pub fn turn(&mut self) -> [u8; 5] {
        self.marks.rotate_left(3);
        self.marks.rotate_right(2);
        self.marks.copy_within(0..3, 2);
        self.marks.copy_within(..2, 1);
        self.marks
    }

    /// Moves by as many as are wanted.
    #[entry]
    pub fn turn_by(&mut self, by: usize, from: usize, to: usize) -> [u8; 5] {
        self.marks.rotate_left(by);
        self.marks.rotate_right(by / 2);
        self.marks.copy_within(from.., to);
        self.marks.copy_within(to..from, by);
        self.marks
    }
}

/// Moves the elements of any slice.
#[function]
pub fn moved(mut values: [i32; 6], first: usize, last: usize) -> [i32; 6] {
    let part = &mut values[first..last];
    part.rotate_left(1);
    part.copy_within(1.., 0);
    part.rotate_right(1);
    values
}
