//! A variant with a payload under the name of another one.
#![no_std]
use bessemer::prelude::*;

/// Shape of an obstacle.
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Shape {
    /// By its radius, in m.
    Circle(f64),
    /// By its side, in m.
    Square(f64),
    /// By its sides, in m.
    Frame { width: f64, height: f64 },
    /// By its sides, in m.
    Panel { width: f64, height: f64 },
}

impl Default for Shape {
    fn default() -> Shape {
        Shape::Circle(0.0)
    }
}

use Shape::{Circle as Square, Panel as Frame};

/// The rim, in m.
#[function]
pub fn rim(shape: Shape) -> f64 {
    match shape {
        Square(radius) => 6.28 * radius,
        Shape::Panel { width, height } => 2.0 * (width + height),
        _ => 0.0,
    }
}

/// A shape of one size.
#[function]
pub fn one(size: f64) -> Shape {
    Square(size)
}

/// A shape of two sizes.
#[function]
pub fn two(width: f64) -> Shape {
    Frame { width, height: width }
}

/// Tests for a shape with two sizes.
#[function]
pub fn has_two(shape: Shape) -> bool {
    matches!(shape, Frame { .. })
}
