//! The estimator's belief of its errors stays a covariance in flight, for a million periods: an hour and a half.
//!
//! The onboard software flies between set points and turns, and Vicon is away for 15 s of every minute and a half, so
//! that every filter works with each of its sources. A run that leaves something out flies a twentieth of it.

use bessemer::requirement;
use bessemer_words::{digest, words};
use models::{Alarm, Inputs, Mode, Onboard, Outputs, Settings};
use nalgebra::{Matrix3, Matrix6};
use sim::computer::Computer;
use sim::ground_station::Order;
use sim::scenario::{Event, Scenario, point};
use sim::voyage::follow;

/// The models, whose memory can be looked at.
#[derive(Default)]
struct Open(Onboard);

impl Computer for Open {
    fn step(&mut self, settings: &Settings, inputs: &Inputs) -> Outputs {
        self.0.step(settings, inputs)
    }

    fn digest(&self) -> u64 {
        digest(&words(&self.0))
    }
}

/// Symmetric to the bit, and without a variance, of any combination of errors, that is not positive.
fn are_covariances(onboard: &Onboard) -> bool {
    let sound = |p: &Matrix3<f64>| *p == p.transpose() && p.cholesky().is_some();
    let attitude: &Matrix6<f64> = onboard.estimator.attitude.covariance.matrix();
    *attitude == attitude.transpose()
        && attitude.cholesky().is_some()
        && onboard.estimator.axes.iter().all(|axis| sound(axis.covariance.matrix()))
}

#[test]
#[requirement("HLR-26")]
fn covariances_stay_symmetric_and_positive_for_a_million_periods_of_flight() {
    let whole = std::env::var("BESSEMER_FULL").is_ok_and(|value| value == "1");
    let periods: u32 = if whole { 1_000_000 } else { 50_000 };
    let end = f64::from(periods) * Settings::mambo().parameters.period;
    let mut scenario = Scenario::mambo(&[point(0.0, 0.0, 0.0, 1.0, 0.0)], end, Mode::ClosedLoop);
    scenario.duration = end;
    let times =
        |every: f64| (1..).map(move |n| every * f64::from(n)).take_while(move |at| *at < end);
    let places = times(10.0).enumerate().map(|(n, at)| {
        let turn = n as f64 * 0.7;
        let place = point(
            0.0,
            0.8 * turn.sin(),
            0.8 * turn.cos(),
            1.0 + 0.5 * (2.0 * turn).sin(),
            turn.sin(),
        );
        (at, Event::Order(Order::Fly(vec![place])))
    });
    scenario.events.extend(places);
    times(90.0).for_each(|at| scenario.hide(at, at + 15.0));

    let (mut flown, mut blind, mut alarm) = (0_u32, 0_u32, Alarm::Clear);
    follow(&scenario, &mut Open::default(), |moment, computer| {
        flown += 1;
        blind += u32::from(moment.outputs.ages.vicon > 1.0);
        alarm = moment.outputs.alarm;
        // As often as does not take longer than the flight.
        if flown.is_multiple_of(100) {
            assert!(are_covariances(&computer.0), "period {flown}: {:?}", computer.0.estimator);
        }
        alarm == Alarm::Clear
    });
    assert_eq!(alarm, Alarm::Clear, "in period {flown}");
    assert!(
        flown > periods && blind > periods / 10,
        "{flown} periods, {blind} of them without Vicon"
    );
}
