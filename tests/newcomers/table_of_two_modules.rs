//! A table that two modules read, without a mark.
use bessemer::prelude::*;

pub const GAINS: [f64; 9] = [0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9];

#[function]
pub fn gain(at: u8) -> f64 {
    GAINS[usize::from(at % 9)]
}

pub mod opposite {
    use super::GAINS;
    use bessemer::prelude::*;

    #[function]
    pub fn gain(at: u8) -> f64 {
        -GAINS[usize::from(at % 9)]
    }
}
