//! Items of a `flat_map` taken one by one, whose closure counts, or reads a sensor that does.
use bessemer::prelude::*;

#[component]
#[derive(Default)]
pub struct FlatMapThatWrites {
    pub rows: [[f32; 3]; 4],
    pub count: u32,
}

#[component]
impl FlatMapThatWrites {
    #[entry]
    pub fn step(&mut self, x: f32) -> f32 {
        let mut count = self.count;
        let mut cells = self.rows.iter().flat_map(|row| {
            count = count.wrapping_add(1);
            row.iter()
        });
        let first = cells.next().map_or(x, |cell| *cell);
        let second = cells.next().map_or(x, |cell| *cell);
        self.count = count;
        first + second
    }
}

/// Reads the next sample of a converter.
#[external(header = "converter.h", name = "converter_sample")]
fn sample(row: usize) -> f32 {
    row as f32
}

#[data]
#[derive(Clone, Copy)]
pub struct Scaled(f32);

#[data]
impl core::ops::Add<usize> for Scaled {
    type Output = f32;

    fn add(self, row: usize) -> f32 {
        self.0 + sample(row)
    }
}

#[function]
fn twice(row: usize) -> f32 {
    2.0 * sample(row)
}

/// The sensor in the closure.
#[function]
pub fn sampled(x: f32) -> f32 {
    let mut all = (0..3).flat_map(|row| [sample(row), x]);
    let first = all.next().unwrap_or(x);
    first + all.next().unwrap_or(x)
}

/// A function that reads it.
#[function]
pub fn sampled_twice(x: f32) -> f32 {
    let mut all = (0..3).flat_map(|row| [twice(row), x]);
    let first = all.next().unwrap_or(x);
    first + all.next().unwrap_or(x)
}

/// An operator that reads it.
#[function]
pub fn sampled_by_operator(x: Scaled) -> f32 {
    let mut all = (0..3).flat_map(|row| [x + row, x.0]);
    let first = all.next().unwrap_or(x.0);
    first + all.next().unwrap_or(x.0)
}

/// The sensor in the iterator before.
#[function]
pub fn sampled_before(x: f32) -> f32 {
    let mut all = (0..3).map(|row| sample(row)).flat_map(|sample| [sample, x]);
    let first = all.next().unwrap_or(x);
    first + all.next().unwrap_or(x)
}
