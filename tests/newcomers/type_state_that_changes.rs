//! A method that makes a motor of another type.
use bessemer::prelude::*;

use core::marker::PhantomData;

#[data]
#[derive(Clone, Copy)]
pub struct Armed;

#[data]
#[derive(Clone, Copy)]
pub struct Safe;

#[data]
#[derive(Clone, Copy)]
pub struct Switch<S> {
    state: PhantomData<S>,
}

impl Switch<Safe> {
    pub fn arm(self) -> Switch<Armed> {
        Switch { state: PhantomData }
    }
}

#[function]
pub fn armed(switch: Switch<Safe>) -> bool {
    let _ = switch.arm();
    true
}
