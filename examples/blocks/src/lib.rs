//! Each block of `bessemer-blocks` as an entry point in single precision, so that `costs.sh` counts its instructions.
//!
//! A `type` alias is all that a generic block needs to be an entry point of its own.
#![no_std]

pub mod functions;

use bessemer::prelude::*;
use bessemer_blocks as blocks;

/// `Pid`.
#[component]
pub type PidCost = blocks::Pid<f32>;
/// `FirstOrderFilter`.
#[component]
pub type FirstOrderFilterCost = blocks::FirstOrderFilter<f32>;
/// `Cascade` of four sections.
#[component]
pub type CascadeCost = blocks::Cascade<f32, 4>;
/// `CascadeDirect` of four sections.
#[component]
pub type CascadeDirectCost = blocks::CascadeDirect<f32, 4>;
/// `Fir` of 32 taps.
#[component]
pub type FirCost = blocks::Fir<f32, 32>;
/// `Decimator` of 32 taps.
#[component]
pub type DecimatorCost = blocks::Decimator<f32, 32>;
/// `Moving` of 16 samples.
#[component]
pub type MovingCost = blocks::Moving<f32, 16>;
/// `Derivative`.
#[component]
pub type DerivativeCost = blocks::Derivative<f32>;
/// `Integrator`.
#[component]
pub type IntegratorCost = blocks::Integrator<f32>;
/// `RateLimiter`.
#[component]
pub type RateLimiterCost = blocks::RateLimiter<f32>;
/// `JerkLimiter`.
#[component]
pub type JerkLimiterCost = blocks::JerkLimiter<f32>;
/// `Voter`.
#[component]
pub type VoterCost = blocks::Voter<f32>;
/// `Pll`.
#[component]
pub type PllCost = blocks::Pll<f32>;
/// `FluxObserver`.
#[component]
pub type FluxObserverCost = blocks::FluxObserver<f32>;
/// `Mahony`.
#[component]
pub type MahonyCost = blocks::Mahony<f32>;
/// `Madgwick`.
#[component]
pub type MadgwickCost = blocks::Madgwick<f32>;
/// `RingBuffer` of 16 values.
#[component]
pub type RingBufferCost = blocks::RingBuffer<f32, 16>;
/// `Rates` of four tasks.
#[component]
pub type RatesCost = blocks::Rates<4>;
/// `ActiveSet` of 8 variables and 16 rows, for 12 changes.
#[component]
pub type ActiveSetCost = blocks::ActiveSet<f32, 8, 16, 12>;
/// `Admm` of 8 variables and 16 rows, of which 6 are two cones, for 20 iterations.
#[component]
pub type AdmmCost = blocks::Admm<f32, 8, 16, 2, 3, 20>;
/// `RiccatiAdmm` of 6 states, 3 inputs in a cone and 8 periods, for 10 iterations.
#[component]
pub type RiccatiAdmmCost = blocks::RiccatiAdmm<f32, 6, 3, 8, 1, 3, 10>;
/// `ErrorStateFilter`.
#[component]
pub type ErrorStateFilterCost = blocks::ErrorStateFilter<f32>;
