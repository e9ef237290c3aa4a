//! Neighbouring statements over the elements of vectors, which share a loop, or narrowly cannot.

use bessemer::prelude::*;

pub type FiveNumbers = SVector<f32, 5>;

/// Vectors of one stage.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Projected {
    pub x: FiveNumbers,
    pub slack: FiveNumbers,
    pub dual: FiveNumbers,
}

/// Stages of a projection.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Projection {
    pub stages: [Projected; 3],
    pub worst: f32,
}

#[component]
impl Projection {
    /// Projects each stage between limits; one loop with two magnitudes.
    #[entry(infallible)]
    pub fn step(&mut self, x: &FiveNumbers, low: &FiveNumbers, high: &FiveNumbers, rho: f32) {
        self.worst = 0.0;
        for stage in self.stages.iter_mut() {
            stage.x = (stage.x + x) * 0.5;
            let slack = (stage.x + stage.dual).sup(low).inf(high);
            stage.dual += stage.x - slack;
            self.worst = self.worst.max((stage.x - slack).amax());
            self.worst = self.worst.max((stage.slack - slack).amax() * rho);
            stage.slack = slack;
        }
    }

    /// Mixes two stages, which may be one.
    #[entry]
    pub fn mix(&mut self, i: usize, j: usize) -> FiveNumbers {
        assert!(i < 3 && j < 3);
        self.stages[i].x = self.stages[j].x + self.stages[j].dual;
        self.stages[j].x = self.stages[i].x * 2.0 - self.stages[i].dual;
        let mixed = self.stages[i].x + self.stages[j].x;
        self.stages[i].dual = mixed.abs();
        mixed
    }
}

/// Scales by an element, a magnitude and a number that an earlier statement writes.
#[function]
pub fn scaled_by_what_changes(a: &mut FiveNumbers, b: &mut FiveNumbers) -> f32 {
    *a += *b;
    *b = *a * a[3];
    let largest = b.amax();
    *b = *a / largest;
    *a -= *b * b[0];
    let first = a[0];
    *a = *a * first + *b;
    largest
}

/// Reports a fault after the first of two statements.
#[function]
pub fn between_a_check(a: &mut FiveNumbers, b: &FiveNumbers, limit: f32) {
    *a += b;
    assert!(limit > 0.0);
    *a *= limit;
}

/// Keeps the vector as it was before it changes.
#[function]
pub fn before_and_after(a: &mut FiveNumbers, b: &FiveNumbers) -> (FiveNumbers, f32) {
    let before = *a;
    *a = before.component_mul(b) - before;
    let change = *a - before;
    let largest = change.amax();
    (change + before * largest, largest)
}
