//! Statics whose types are not `Copy`: parts are read, and the whole is passed by reference. The attributes are imported by
//! name.

use bessemer::{c, component, data, entry, function};

/// Points of a curve.
#[data]
#[derive(Debug, PartialEq)]
pub struct Curve {
    /// Inputs.
    pub at: [f32; 3],
    /// Outputs.
    pub value: [f32; 3],
}

/// Curves of one motor.
#[data]
#[derive(Debug, PartialEq)]
#[c(name = "motor_curves")]
pub struct Curves {
    /// One for each direction.
    pub curves: [Curve; 2],
    /// Offset of all.
    pub offset: f32,
}

#[data]
impl Curves {
    /// First output of a direction.
    pub fn first(&self, backward: bool) -> f32 {
        self.curves[backward as usize].value[0] + self.offset
    }
}

/// The curves.
pub static CURVES: Curves = Curves {
    curves: [
        Curve { at: [0.0, 1.0, 2.0], value: [0.0, 3.0, 5.0] },
        Curve { at: [0.0, 1.0, 4.0], value: [0.5, -3.0, -7.0] },
    ],
    offset: 0.25,
};

/// Sum of the inputs.
#[function]
pub fn inputs(curve: &Curve) -> f32 {
    let mut sum = 0.0;
    for at in &curve.at {
        sum += *at;
    }
    sum
}

/// Reads parts of the curves.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Reader {
    /// Sum of all results.
    pub sum: f32,
}

#[component]
impl Reader {
    /// Adds what one direction has.
    #[entry]
    pub fn step(&mut self, backward: bool, x: f32) -> f32 {
        let curve = &CURVES.curves[backward as usize];
        let mut most = CURVES.offset;
        for other in CURVES.curves.iter() {
            most = most.max(other.value[2]);
        }
        self.sum += inputs(curve) + CURVES.first(backward) + x * CURVES.curves[1].at[2] + most;
        self.sum
    }
}
