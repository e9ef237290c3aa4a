//! Readings that are iterated from the last one on, unless somebody asks for them in order.
use bessemer::prelude::*;

#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Readings {
    pub values: [f64; 4],
}

#[data]
impl Readings {
    pub fn iter(&self) -> impl Iterator<Item = f64> {
        self.values.iter().copied()
    }
}

impl IntoIterator for Readings {
    type Item = f64;
    type IntoIter = core::iter::Rev<core::array::IntoIter<f64, 4>>;

    fn into_iter(self) -> Self::IntoIter {
        self.values.into_iter().rev()
    }
}

impl<'a> IntoIterator for &'a Readings {
    type Item = &'a f64;
    type IntoIter = core::iter::Rev<core::slice::Iter<'a, f64>>;

    fn into_iter(self) -> Self::IntoIter {
        self.values.iter().rev()
    }
}

#[function]
pub fn by_value(readings: Readings) -> f64 {
    let mut last = 0.0;
    for x in readings {
        last = x;
    }
    last
}

#[function]
pub fn by_reference(readings: &Readings) -> f64 {
    let mut last = 0.0;
    for x in readings {
        last = *x;
    }
    last
}

#[function]
pub fn borrowed(readings: Readings) -> f64 {
    let mut last = 0.0;
    for x in &readings {
        last = *x;
    }
    last
}

#[function]
pub fn called(readings: Readings) -> f64 {
    let mut last = 0.0;
    for x in (&readings).into_iter() {
        last = *x;
    }
    last
}
