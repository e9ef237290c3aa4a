//! Identification of the thrust coefficients from a logged flight (thesis, ch. 5).
//!
//! | module | what it says |
//! |---|---|
//! | [`logged`] | a flight as the identification sees it: motor speeds and states |
//! | [`replay`] | the thesis' cost: the whole flight replayed open loop |
//! | [`swarm`] | the thesis' particle swarm |
//! | [`segments`] | the well-posed cost: short segments, each restarted from the log |
//! | [`known`] | an aircraft of unknown propellers, and what the software takes it for after a hover |
//! | [`fit`] | its minimum by Nelder and Mead's method (crate `argmin`), with confidence intervals |
//!
//! The dynamics are those of `models::plant`, which is emitted too. Work is shared between threads by
//! pieces whose results are put together in their own order, so that their number changes no bit.

pub mod fit;
pub mod known;
pub mod logged;
pub mod replay;
pub mod segments;
pub mod swarm;

use models::Airframe;

/// The airframe with these thrust coefficients, one for each motor or one for all; the drag-moment
/// coefficients follow (thesis, eq. (5.1)).
pub fn with_coefficients(airframe: &Airframe, coefficients: &[f64]) -> Airframe {
    let mut known = *airframe;
    for n in 0..airframe.motors {
        let thrust = coefficients[n.min(coefficients.len() - 1)];
        known.thrust_coefficients[n] = thrust;
        known.drag_coefficients[n] = thrust.powf(1.5) / std::f64::consts::SQRT_2;
    }
    known
}
