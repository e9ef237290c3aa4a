//! The flights: what each shows, and by which figures it is judged.
//!
//! A flight is a row: scenario, checks, figures. `cargo xtask sim --list` prints them; `sim/tests` holds
//! each to its checks.

use crate::Aircraft;
use crate::campaign::dice;
use crate::checks::Check;
use crate::figures::{self, Figure};
use crate::ground_station::Order;
use crate::identify::known::{self, worst_off};
use crate::measure::{Step, hover_speed};
use crate::plant::State;
use crate::scenario::{Event, Failure, Scenario, point};
use crate::voyage::Voyage;
use models::airframe::MAX_MOTORS;
use models::receiver::Sticks;
use models::{Airframe, Alarm, Candidate, Injection, Mode, Parameters, Phase};
use nalgebra::{Vector2, Vector3};
use std::f64::consts::{FRAC_PI_2, PI};

/// A flight by name.
pub struct Flight {
    /// Name of the flight on the command line.
    pub name: &'static str,
    /// Description of the flight.
    pub about: &'static str,
    /// Scenario for a seed.
    pub scenario: fn(u64) -> Scenario,
    /// Checks of the flight.
    pub checks: fn(&Scenario, &Voyage) -> Vec<Check>,
    /// Figures of the flight.
    pub figures: &'static [Figure],
}

/// Every flight.
pub const FLIGHTS: &[Flight] = &[
    Flight {
        name: "hover",
        about: "take off, hover at 1 m, land (thesis, figs. 3–17 …)",
        scenario: |_| hover(),
        checks: hover_checks,
        figures: figures::HEIGHT,
    },
    Flight {
        name: "climb",
        about: "hover at 1 m, then at 2 m, land (thesis, figs. 3–18 …)",
        scenario: |_| climb(),
        checks: climb_checks,
        figures: figures::HEIGHT,
    },
    Flight {
        name: "step",
        about: "2 m along x, then 2.8 m diagonally, with shaped set points",
        scenario: |_| step(),
        checks: step_checks,
        figures: figures::PLANE,
    },
    Flight {
        name: "thesis-step",
        about: "as step, by the thesis' gains and steps of the set point",
        scenario: |_| thesis(step()),
        checks: thesis_step_checks,
        figures: figures::PLANE,
    },
    Flight {
        name: "yaw",
        about: "yaw steps to 90°, 180°, through half a turn to −90°, and back",
        scenario: |_| yaw(),
        checks: yaw_checks,
        figures: figures::YAW,
    },
    Flight {
        name: "gravity-25",
        about: "25 % of the weight taken away, linear injection (thesis, ch. 7)",
        scenario: |seed| reduced(seed, Injection::linear(0.5), 172.0, 0.0),
        checks: |scenario, voyage| reduced_checks(scenario, voyage, (80.0, 170.0), 0.02),
        figures: figures::GRAVITY,
    },
    Flight {
        name: "gravity-64",
        about: "64 % of the weight taken away, linear injection (thesis, ch. 7)",
        scenario: |seed| reduced(seed, Injection::linear(0.8), 70.0, 0.0),
        checks: |scenario, voyage| reduced_checks(scenario, voyage, (60.0, 70.0), 0.03),
        figures: figures::GRAVITY,
    },
    Flight {
        name: "gravity-49",
        about: "49 % of the weight taken away, sigmoid injection (thesis, ch. 7)",
        scenario: |seed| reduced(seed, Injection::sigmoid(0.7), 70.0, 0.0),
        checks: |scenario, voyage| reduced_checks(scenario, voyage, (60.0, 70.0), 0.02),
        figures: figures::GRAVITY,
    },
    Flight {
        name: "coefficient-20",
        about: "as gravity-64, with C_FT taken 20 % too high (thesis, fig. 7.9)",
        scenario: |seed| reduced(seed, Injection::linear(0.8), 70.0, 0.2),
        checks: |scenario, voyage| mistaken_checks(scenario, voyage, 0.35),
        figures: figures::GRAVITY,
    },
    Flight {
        name: "coefficient-50",
        about: "as gravity-64, with C_FT taken 50 % too high (thesis, fig. 7.10)",
        scenario: |seed| reduced(seed, Injection::linear(0.8), 70.0, 0.5),
        checks: |scenario, voyage| mistaken_checks(scenario, voyage, 0.73),
        figures: figures::GRAVITY,
    },
    Flight {
        name: "manual",
        about: "a pilot climbs, leans, turns and lets go of the sticks",
        scenario: |_| manual(),
        checks: manual_checks,
        figures: figures::HEIGHT,
    },
    Flight {
        name: "vicon-lost",
        about: "Vicon is away from 10 s to 20 s: altimeter, camera and gyroscope carry on",
        scenario: |_| vicon_lost(),
        checks: vicon_lost_checks,
        figures: figures::PLANE,
    },
    Flight {
        name: "motor-failure",
        about: "a motor stops at 10 s: the crash predictor stops the others",
        scenario: |_| motor_failure(),
        checks: motor_failure_checks,
        figures: figures::TILT,
    },
    Flight {
        name: "hexacopter",
        about: "a hexacopter takes off, hovers at 1.5 m and lands",
        scenario: |_| hexacopter(),
        checks: hexacopter_checks,
        figures: figures::HEIGHT,
    },
    Flight {
        name: "geometric",
        about: "the geometric candidate: hover, yaw by 180°, 1 m along x",
        scenario: |_| candidate(Candidate::Geometric, PI),
        checks: geometric_checks,
        figures: figures::PLANE,
    },
    Flight {
        name: "printed",
        about: "the law as the thesis prints it, at a yaw of 40°: the crash predictor ends it",
        scenario: |_| printed(),
        checks: printed_checks,
        figures: figures::PLANE,
    },
    Flight {
        name: "chance",
        about: "the flight of a seed of the campaign `spread`",
        scenario: dice::scenario,
        checks: chance_checks,
        figures: figures::PLANE,
    },
    Flight {
        name: "failing",
        about: "the flight of a seed of the campaign `failures`",
        scenario: dice::failing,
        checks: failing_checks,
        figures: figures::TILT,
    },
];

/// Returns the flight with a name.
pub fn find(name: &str) -> Option<&'static Flight> {
    FLIGHTS.iter().find(|flight| flight.name == name)
}

fn hover() -> Scenario {
    Scenario::mambo(&[point(0.0, 0.0, 0.0, 1.0, 0.0)], 24.0, Mode::ClosedLoop)
}

fn hover_checks(_: &Scenario, voyage: &Voyage) -> Vec<Check> {
    vec![
        Check::at_most("height error, 14–24 s", voyage.height_error(14.0, 24.0), 0.05, "m"),
        Check::at_most("place error, 14–24 s", voyage.plane_error(14.0, 24.0), 0.05, "m"),
        Check::at_most("overshoot", voyage.overshoot(0.0, 24.0, 1.0), 0.1, "m"),
        Check::at_most("settled to 5 cm after", voyage.settling(0.0, 24.0, 1.0), 4.0, "s"),
        Check::at_most("touch-down", voyage.touch_down(), 0.3, "m/s"),
        Check::holds("ended well", voyage.ended_well()),
    ]
}

fn climb() -> Scenario {
    let points = [point(0.0, 0.0, 0.0, 1.0, 0.0), point(14.0, 0.0, 0.0, 2.0, 0.0)];
    Scenario::mambo(&points, 28.0, Mode::ClosedLoop)
}

fn climb_checks(_: &Scenario, voyage: &Voyage) -> Vec<Check> {
    vec![
        Check::at_most("height error at 1 m, 12–14 s", voyage.height_error(12.0, 14.0), 0.05, "m"),
        Check::at_most("height error at 2 m, 24–28 s", voyage.height_error(24.0, 28.0), 0.05, "m"),
        Check::at_most("overshoot at 2 m", voyage.overshoot(14.0, 28.0, 2.0), 0.1, "m"),
        Check::at_most("settled to 5 cm after", voyage.settling(14.0, 28.0, 2.0), 4.0, "s"),
        Check::at_most("touch-down", voyage.touch_down(), 0.3, "m/s"),
        Check::holds("ended well", voyage.ended_well()),
    ]
}

/// The steps of the flight `step`, and when they begin, s.
fn steps() -> [(f64, Step); 2] {
    let corners = [Vector2::zeros(), Vector2::new(2.0, 0.0), Vector2::new(0.0, -2.0)];
    let between = |n: usize| Step { start: corners[n], end: corners[n + 1] };
    [(10.0, between(0)), (20.0, between(1))]
}

fn step() -> Scenario {
    let place = |(time, it): (f64, Step)| point(time, it.end.x, it.end.y, 1.0, 0.0);
    let [first, second] = steps().map(place);
    Scenario::mambo(&[point(0.0, 0.0, 0.0, 1.0, 0.0), first, second], 30.0, Mode::ClosedLoop)
}

/// A scenario flown as in the thesis: by its gains, and with steps of the set point.
fn thesis(mut scenario: Scenario) -> Scenario {
    scenario.settings.parameters = Parameters::thesis();
    scenario.settings.course.shaping.is_active = false;
    scenario
}

fn step_checks(_: &Scenario, voyage: &Voyage) -> Vec<Check> {
    let mut checks = Vec::new();
    let names = [
        ["overshoot of 2 m along x", "2 m along x within 5 % after"],
        ["overshoot of 2.8 m diagonally", "2.8 m diagonally within 5 % after"],
    ];
    for ([overshoot, duration], (from, step)) in names.into_iter().zip(steps()) {
        let to = from + 10.0;
        checks.push(Check::at_most(overshoot, voyage.step_overshoot(from, to, &step), 0.05, ""));
        checks.push(Check::at_most(duration, voyage.step_settling(from, to, &step), 3.5, "s"));
    }
    checks.extend([
        Check::at_most("place error, 28–30 s", voyage.plane_error(28.0, 30.0), 0.05, "m"),
        Check::at_most("height error, 10–30 s", voyage.height_error(10.0, 30.0), 0.15, "m"),
        Check::reported("tilt, 10–30 s", voyage.tilt(10.0, 30.0), "°"),
        Check::at_most("touch-down", voyage.touch_down(), 0.3, "m/s"),
        Check::holds("ended well", voyage.ended_well()),
    ]);
    checks
}

fn thesis_step_checks(_: &Scenario, voyage: &Voyage) -> Vec<Check> {
    let [(from, along), (until, across)] = steps();
    vec![
        Check::reported("overshoot of 2 m along x", voyage.step_overshoot(from, until, &along), ""),
        Check::reported(
            "2 m along x within 5 % after",
            voyage.step_settling(from, until, &along),
            "s",
        ),
        Check::reported(
            "overshoot of 2.8 m diagonally",
            voyage.step_overshoot(until, until + 10.0, &across),
            "",
        ),
        Check::reported("tilt, 10–30 s", voyage.tilt(10.0, 30.0), "°"),
        Check::holds("ended well", voyage.ended_well()),
    ]
}

fn yaw() -> Scenario {
    let turn = |time, yaw| point(time, 0.0, 0.0, 1.0, yaw);
    let points = [
        turn(0.0, 0.0),
        turn(10.0, FRAC_PI_2),
        turn(18.0, PI),
        // The short way: through half a turn.
        turn(26.0, -FRAC_PI_2),
        turn(38.0, 0.0),
    ];
    Scenario::mambo(&points, 48.0, Mode::ClosedLoop)
}

fn yaw_checks(_: &Scenario, voyage: &Voyage) -> Vec<Check> {
    let settled = |name, from, to| Check::at_most(name, voyage.yaw_error(from, to), 0.05, "rad");
    vec![
        settled("yaw error at 90°, 16–18 s", 16.0, 18.0),
        settled("yaw error at 180°, 24–26 s", 24.0, 26.0),
        settled("yaw error at −90°, through half a turn, 36–38 s", 36.0, 38.0),
        settled("yaw error at 0°, 46–48 s", 46.0, 48.0),
        Check::at_most("place error, 10–48 s", voyage.plane_error(10.0, 48.0), 0.25, "m"),
        Check::at_most("height error, 10–48 s", voyage.height_error(10.0, 48.0), 0.25, "m"),
        Check::holds("ended well", voyage.ended_well()),
    ]
}

/// The scenario of a hover with feed-forward, by an aircraft whose propellers differ by up to 10 % from the data
/// sheet. The software has the coefficients identified in an earlier hover of that aircraft, increased by a fraction
/// `mistake`.
fn reduced(seed: u64, injection: Injection, landing: f64, mistake: f64) -> Scenario {
    let points = [point(0.0, 0.0, 0.0, 1.0, 0.0)];
    let hover = known::unknown_hover(seed);
    let mut scenario = Scenario::mambo(&points, landing, Mode::FeedForward);
    scenario.airframe = hover.airframe;
    scenario.settings.injection = injection;
    // Where a log does not allow it, the data sheet stays, and the flight's checks say so.
    if let Ok(airframe) = known::log_of(&hover).and_then(|log| known::identified(&log)) {
        scenario.settings.airframe = airframe;
    }
    scenario.settings.airframe.thrust_coefficients *= 1.0 + mistake;
    scenario
}

fn reduced_checks(
    scenario: &Scenario,
    voyage: &Voyage,
    (from, to): (f64, f64),
    limit: f64,
) -> Vec<Check> {
    let gain = scenario.settings.injection.most;
    let hover = hover_speed(&scenario.airframe);
    let error = voyage.command_error(from, to, gain, hover);
    // The thesis' own: the largest speed in place of the hover's.
    let by_largest = voyage.command_error(from, to, gain, 2630.7);
    let coefficients = |airframe: &Airframe| airframe.thrust_coefficients.as_slice()[..4].to_vec();
    let (taken, true_ones) =
        (coefficients(&scenario.settings.airframe), coefficients(&scenario.airframe));
    vec![
        Check::at_most("coefficients as identified", worst_off(&taken, &true_ones), 0.01, ""),
        Check::at_most("command error (7.2)", error, limit, ""),
        Check::reported("command error by the largest speed", by_largest, ""),
        Check::reported("mean closed-loop command", voyage.closed_loop(from, to), "rad/s"),
        Check::reported("mean motor speed", voyage.commanded(from, to), "rad/s"),
        Check::at_most("height error at the end", voyage.height_error(to - 5.0, to), 0.4, "m"),
        Check::at_most("touch-down", voyage.touch_down(), 0.5, "m/s"),
        Check::holds("ended well", voyage.ended_well()),
    ]
}

fn mistaken_checks(scenario: &Scenario, voyage: &Voyage, expected: f64) -> Vec<Check> {
    let hover = hover_speed(&scenario.airframe);
    let error = voyage.command_error(60.0, 70.0, scenario.settings.injection.most, hover);
    vec![
        Check::reported("command error (7.2)", error, ""),
        Check::at_most("its distance from the model's", (error - expected).abs(), 0.03, ""),
        Check::holds("ended well", voyage.ended_well()),
    ]
}

fn manual() -> Scenario {
    let mut scenario = Scenario::mambo(&[point(0.0, 0.0, 0.0, 0.8, 0.0)], 22.0, Mode::ClosedLoop);
    scenario.order(8.0, Order::Mode(Mode::Manual));
    let sticks = |from: f64, roll, pitch, yaw_rate, climb| {
        let sticks = Sticks { lean: Vector2::new(roll, pitch), yaw_rate, climb };
        (0..10).map(move |n| (from + 0.1 * f64::from(n), Event::Order(Order::Sticks(sticks))))
    };
    scenario.events.extend(sticks(9.0, 0.0, 0.0, 0.0, 0.3));
    scenario.events.extend(sticks(10.0, 0.0, 0.05, 0.0, 0.0));
    scenario.events.extend(sticks(11.0, 0.0, -0.05, 0.0, 0.0));
    scenario.events.extend(sticks(12.0, 0.0, 0.0, 0.8, 0.0));
    // Then nobody touches them any more, and the closed loop takes over again.
    scenario.order(16.0, Order::Mode(Mode::ClosedLoop));
    scenario
}

fn manual_checks(_: &Scenario, voyage: &Voyage) -> Vec<Check> {
    let at = |time: f64| voyage.between(time, time + 0.01).next().map(|moment| moment.state);
    let (before, leant, turned) =
        (at(8.9).unwrap_or_default(), at(11.0).unwrap_or_default(), at(15.9).unwrap_or_default());
    vec![
        Check::between("climbed by 0.3 m", turned.position.z - before.position.z, 0.2, 0.5, "m"),
        Check::between("flew along −x at", leant.velocity.x, -0.7, -0.25, "m/s"),
        Check::between("turned by", turned.angles.z - before.angles.z, 0.7, 1.3, "rad"),
        Check::at_most("place error, 21–22 s", voyage.plane_error(21.0, 22.0), 0.5, "m"),
        Check::at_most("touch-down", voyage.touch_down(), 0.3, "m/s"),
        Check::holds("ended well", voyage.ended_well()),
    ]
}

fn vicon_lost() -> Scenario {
    let points = [point(0.0, 0.0, 0.0, 1.0, 0.0), point(14.0, 0.0, 0.0, 1.5, 0.0)];
    let mut scenario = Scenario::mambo(&points, 28.0, Mode::ClosedLoop);
    scenario.hide(10.0, 20.0);
    scenario
}

fn vicon_lost_checks(_: &Scenario, voyage: &Voyage) -> Vec<Check> {
    let oldest = voyage.between(10.0, 20.0).map(|moment| moment.outputs.ages.height);
    vec![
        Check::at_least("Vicon away for", oldest_vicon(voyage), 9.9, "s"),
        Check::at_most("height unmeasured for", oldest.fold(0.0, f64::max), 0.5, "s"),
        Check::at_most("height error, 19–20 s", voyage.height_error(19.0, 20.0), 0.1, "m"),
        Check::at_most("place error while away", voyage.plane_error(10.0, 20.0), 0.6, "m"),
        Check::at_most("place error, 26–28 s", voyage.plane_error(26.0, 28.0), 0.08, "m"),
        Check::at_most("touch-down", voyage.touch_down(), 0.3, "m/s"),
        Check::holds("ended well", voyage.ended_well()),
    ]
}

fn oldest_vicon(voyage: &Voyage) -> f64 {
    voyage.moments.iter().map(|moment| moment.outputs.ages.vicon).fold(0.0, f64::max)
}

fn motor_failure() -> Scenario {
    let mut scenario = Scenario::mambo(&[point(0.0, 0.0, 0.0, 1.0, 0.0)], 14.0, Mode::ClosedLoop);
    scenario.fail(10.0, Failure::Motor(2));
    scenario
}

fn motor_failure_checks(_: &Scenario, voyage: &Voyage) -> Vec<Check> {
    let (time, alarm) = voyage.alarm().unwrap_or((f64::INFINITY, Alarm::Clear));
    let on = voyage.between(time, f64::INFINITY).any(|m| m.outputs.command.motors.amax() > 0.0);
    let tilt = voyage.between(time, time + 0.001).map(|moment| {
        (moment.state.angles.x.cos() * moment.state.angles.y.cos()).acos().to_degrees()
    });
    vec![
        Check::at_most("caught after", time - 10.0, 0.2, "s"),
        Check::at_least("and not before", time - 10.0, 0.0, "s"),
        Check::reported("tilt by then", tilt.fold(0.0, f64::max), "°"),
        Check::holds(
            "by its tilt or spin",
            alarm == Alarm::Tilt || alarm == Alarm::Spin || alarm == Alarm::Speed,
        ),
        Check::holds("the motors stay off", !on),
    ]
}

fn hexacopter() -> Scenario {
    let points = [point(0.0, 0.0, 0.0, 1.5, 0.0), point(14.0, 0.5, 0.0, 1.5, 1.0)];
    let mut scenario = Scenario::mambo(&points, 28.0, Mode::ClosedLoop);
    scenario.airframe = Aircraft::F550.airframe();
    scenario.settings = Aircraft::F550.settings();
    scenario.lag = Aircraft::F550.lag();
    scenario.air.gusts = Aircraft::F550.gusts();
    scenario
}

fn hexacopter_checks(_: &Scenario, voyage: &Voyage) -> Vec<Check> {
    let six = |moment: &crate::voyage::Moment| {
        let motors = moment.outputs.command.motors;
        (0..MAX_MOTORS).all(|n| (motors[n] > 0.0) == (n < 6))
    };
    vec![
        Check::at_most("height error, 12–14 s", voyage.height_error(12.0, 14.0), 0.05, "m"),
        Check::at_most("height error, 26–28 s", voyage.height_error(26.0, 28.0), 0.05, "m"),
        Check::at_most("place error, 26–28 s", voyage.plane_error(26.0, 28.0), 0.08, "m"),
        Check::at_most("yaw error, 26–28 s", voyage.yaw_error(26.0, 28.0), 0.05, "rad"),
        Check::at_most("overshoot", voyage.overshoot(0.0, 14.0, 1.5), 0.5, "m"),
        Check::holds("six motors turn", voyage.between(5.0, 25.0).all(six)),
        Check::at_most("touch-down", voyage.touch_down(), 0.3, "m/s"),
        Check::holds("ended well", voyage.ended_well()),
    ]
}

fn candidate(which: Candidate, yaw: f64) -> Scenario {
    let points = [
        point(0.0, 0.0, 0.0, 1.0, 0.0),
        point(10.0, 0.0, 0.0, 1.0, yaw),
        point(16.0, 1.0, 0.0, 1.0, yaw),
    ];
    let mut scenario = Scenario::mambo(&points, 28.0, Mode::ClosedLoop);
    scenario.settings.parameters.candidate = which;
    scenario.start = State { position: Vector3::zeros(), ..scenario.start };
    scenario
}

/// The law as the thesis prints it, by the thesis' gains and steps of the set point.
fn printed() -> Scenario {
    let mut scenario = thesis(candidate(Candidate::Printed, 40f64.to_radians()));
    scenario.settings.parameters.candidate = Candidate::Printed;
    scenario
}

fn geometric_checks(_: &Scenario, voyage: &Voyage) -> Vec<Check> {
    vec![
        Check::at_most("height error, 24–28 s", voyage.height_error(24.0, 28.0), 0.05, "m"),
        Check::at_most("place error, 24–28 s", voyage.plane_error(24.0, 28.0), 0.05, "m"),
        Check::at_most("yaw error, 24–28 s", voyage.yaw_error(24.0, 28.0), 0.05, "rad"),
        Check::at_most("touch-down", voyage.touch_down(), 0.3, "m/s"),
        Check::holds("ended well", voyage.ended_well()),
    ]
}

fn printed_checks(_: &Scenario, voyage: &Voyage) -> Vec<Check> {
    let (time, _) = voyage.alarm().unwrap_or((f64::INFINITY, Alarm::Clear));
    let flew = |moment: &crate::voyage::Moment| moment.outputs.reference.phase == Phase::Flight;
    vec![
        Check::holds("flies at no yaw", voyage.between(9.0, 10.0).all(flew)),
        Check::at_most("place error at no yaw, 9–10 s", voyage.plane_error(9.0, 10.0), 0.2, "m"),
        Check::between("stopped at", time, 10.0, 28.0, "s"),
    ]
}

fn chance_checks(_: &Scenario, voyage: &Voyage) -> Vec<Check> {
    vec![
        Check::at_most("touch-down", voyage.touch_down(), 0.5, "m/s"),
        Check::holds("ended well", voyage.ended_well()),
    ]
}

fn failing_checks(scenario: &Scenario, voyage: &Voyage) -> Vec<Check> {
    let broke = scenario.failure().map_or(f64::INFINITY, |(at, _)| at);
    let stopped = voyage.alarm().map_or(f64::INFINITY, |(at, _)| at);
    vec![Check::reported("broke at", broke, "s"), Check::reported("stopped at", stopped, "s")]
}
