//! Fields, variants, statements, arms, methods and arguments under `#[cfg]` of a feature: rustc decides before the C is made.
#![allow(unexpected_cfgs)]

use bessemer::prelude::*;

/// Perhaps with a field.
#[data]
#[derive(Clone, Copy, Default)]
pub struct ConditionalGains {
    pub p: f64,
    #[cfg(feature = "absent")]
    pub i: i8,
    #[cfg(not(feature = "absent"))]
    pub i: f64,
    #[cfg(all(not(feature = "absent"), not(any(feature = "none", feature = "other"))))]
    pub d: f32,
}

/// Perhaps with a variant.
#[data]
#[derive(Clone, Copy, PartialEq)]
pub enum ConditionalMode {
    #[cfg(feature = "absent")]
    Off,
    Idle,
    #[cfg(not(feature = "absent"))]
    Armed(f64),
}

#[data]
impl ConditionalGains {
    /// Response of the gains.
    pub fn respond(&self, #[cfg(not(feature = "absent"))] error: f64) -> f64 {
        #[cfg(feature = "absent")]
        {
            self.p
        }

        #[cfg(not(feature = "absent"))]
        {
            self.p * error + self.i
        }
    }

    /// The method of a build with the feature.
    #[cfg(feature = "absent")]
    pub fn last(&self) -> u8 {
        1
    }

    /// The method of a build without it.
    #[cfg(not(feature = "absent"))]
    pub fn last(&self) -> f64 {
        f64::from(self.d)
    }
}

/// Computes by the arms and statements that rustc leaves.
#[function]
pub fn conditional_parts(gains: ConditionalGains, mode: ConditionalMode, error: f64) -> f64 {
    let mut sum = gains.respond(error);
    #[cfg(feature = "absent")]
    let scale = 2;
    #[cfg(not(feature = "absent"))]
    let scale = 0.5;
    #[cfg(not(feature = "absent"))]
    for k in [1.0, 2.0] {
        sum += k * scale;
    }
    match mode {
        #[cfg(feature = "absent")]
        ConditionalMode::Off => 0,
        ConditionalMode::Idle => sum + gains.last(),
        #[cfg(not(feature = "absent"))]
        ConditionalMode::Armed(level) => sum - level,
    }
}
