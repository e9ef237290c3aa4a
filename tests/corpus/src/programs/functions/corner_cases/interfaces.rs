//! Traits with parameters, associated types and defaults; the same names elsewhere.

use bessemer::prelude::*;

#[interface]
pub trait Stage<T> {
    type Output;
    const ORDER: u8;

    fn run(&self, input: T) -> Self::Output;

    fn twice<const N: usize>(&self, _inputs: [T; N]) -> u8 {
        if N > 3 { Self::ORDER } else { N as u8 }
    }

    /// A function of the trait without a receiver.
    fn made(seed: u8) -> Self
    where
        Self: Sized;
}

#[interface]
pub trait Named: Copy {
    fn run(self) -> i32;
}

#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Scale<T> {
    pub by: T,
}

#[data]
impl<T: Real> Stage<T> for Scale<T> {
    type Output = T;
    const ORDER: u8 = 1;

    fn run(&self, input: T) -> T {
        self.by * input
    }

    fn made(seed: u8) -> Self {
        Scale { by: real(seed as f64) }
    }
}

#[data]
impl Stage<bool> for Scale<f32> {
    type Output = f64;
    const ORDER: u8 = 2;

    fn run(&self, input: bool) -> f64 {
        if input { self.by.as_f64() } else { -0.5 }
    }

    fn made(seed: u8) -> Self {
        Scale { by: seed as f32 / 2.0 }
    }

    fn twice<const N: usize>(&self, inputs: [bool; N]) -> u8 {
        let mut count = 0;
        for input in inputs {
            if input {
                count += 1;
            }
        }
        count
    }
}

#[data]
impl<T: Real> Named for Scale<T> {
    fn run(self) -> i32 {
        self.run_of() + 1
    }
}

#[data]
impl<T: Real> Scale<T> {
    pub fn run_of(&self) -> i32 {
        self.by.as_f64() as i32
    }
}

#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Kind {
    #[default]
    Plain,
    Odd,
}

#[data]
impl Named for Kind {
    fn run(self) -> i32 {
        match self {
            Kind::Plain => 1,
            Kind::Odd => -1,
        }
    }
}

#[function]
fn through<T: Copy, S: Stage<T>>(stage: &S, input: T) -> S::Output {
    stage.run(input)
}

#[function]
fn orders<S: Stage<f32> + Stage<bool>>(_stage: &S) -> u8 {
    <S as Stage<f32>>::ORDER * 10 + <S as Stage<bool>>::ORDER
}

#[function]
fn sum<A: Named, B: Named>(a: A, b: B) -> i32 {
    a.run().wrapping_add(b.run())
}

#[function]
pub fn stages(by: f32, input: f32, flag: bool, seed: u8) -> f64 {
    let scale = Scale { by };
    let made: Scale<f64> = Stage::<f64>::made(seed);
    let half = <Scale<f32> as Stage<bool>>::made(seed);
    through(&scale, input).as_f64() + through(&half, flag) + Stage::<f64>::run(&made, 0.25)
}

#[function]
pub fn counted(flags: [bool; 3], seed: u8, odd: Kind) -> i32 {
    let scale = Scale { by: seed as f32 };
    let of_flags = Stage::<bool>::twice(&scale, flags);
    let of_floats = Stage::<f32>::twice(&scale, [1.0, 2.0, 3.0, 4.0]);
    let all = of_flags as i32 + of_floats as i32 + orders(&scale) as i32;
    sum(scale, odd) + sum(odd, Scale { by: 2.5 }) + all
}
