//! A motor whose state is part of its type.
use bessemer::prelude::*;

use core::marker::PhantomData;

pub struct On;
pub struct Off;

#[component]
#[derive(Default)]
pub struct TypedMotor<S> {
    speed: f64,
    state: PhantomData<S>,
}

#[component]
impl TypedMotor<On> {
    #[entry]
    pub fn step(&mut self, speed: f64) -> f64 {
        self.speed = speed;
        self.speed
    }
}

#[component]
pub type MotorOn = TypedMotor<On>;
