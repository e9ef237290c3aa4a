//! Items that would have equal names in the C.
use bessemer::prelude::*;

#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Run {
    #[default]
    Idle,
    FastStart,
}

#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum RunFast {
    #[default]
    Start,
    Stop,
}

#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Joint {
    pub union: f64,
    pub union_: f64,
    pub kind: Run,
    pub fast: RunFast,
}
