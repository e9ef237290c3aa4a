//! Reasons to refuse a request before it goes to the aircraft.
//!
//! The software on board checks every command again and drops what it cannot use, but it gives no reason, and the
//! ground station would wait for a confirmation in vain.
//!
//! Invariants:
//! - a request that the software on board would drop is refused here, with what is wrong and what to do;
//! - the software on board arms whenever the aircraft is at rest; the checks here ask for more;
//! - STOP, landing, and giving back the right to command are never refused.
//!
//! It must not know who sent a request.

use crate::catalogue::{self, SIGNALS, UNUSED};
use crate::messages::{Ask, Point};
use models::Phase;
use models::trajectory::{MAX_POINTS, Space};
use serde::Serialize;
use sim::Aircraft;
use std::f64::consts::TAU;

/// Largest number of signals in a selection.
const MOST_SIGNALS: usize = 36;

/// Silence of the downlink after which no flight begins, s.
const SILENT: f64 = 1.0;

/// Height, m, and speed, m/s, above which the software on board does not arm.
const LOW: f64 = 0.1;
const SLOW: f64 = 0.1;

/// Age of a measurement above which the aircraft is not armed, s.
const OLD: f64 = 0.5;

/// State of the flight on which refusals depend.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Situation {
    /// Number of the phase.
    pub phase: u8,
    /// True if the aircraft has raised no alarm.
    pub clear: bool,
    /// True if a command to arm is on its way.
    pub arming: bool,
    /// True if a trajectory was sent that no flight has followed yet.
    pub planned: bool,
    /// Time since the last packet of the downlink, s; none before the first.
    pub silence: Option<f64>,
    /// The aircraft.
    pub aircraft: Aircraft,
    /// Height, m; none if it is not received.
    pub height: Option<f64>,
    /// Speed, m/s; none if it is not received.
    pub speed: Option<f64>,
    /// Ages of the measurements of Vicon and the height, s; none if they are not received.
    pub ages: Option<[f64; 2]>,
}

/// A check before arming.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Check {
    /// Condition that is checked.
    pub name: &'static str,
    /// True if the telemetry includes what is checked.
    pub known: bool,
    /// Reason why the aircraft cannot be armed; none if the check passes, or is not known.
    pub problem: Option<&'static str>,
}

impl Situation {
    /// Returns true if the motors may turn.
    pub fn is_flying(&self) -> bool {
        let ground = [Phase::Ready, Phase::Over].map(|it| it as u8);
        !ground.contains(&self.phase)
    }
}

impl Situation {
    /// Returns the state for a request that follows this one.
    pub fn after(&self, ask: &Ask) -> Self {
        let mut next = *self;
        match ask {
            Ask::Fly { .. } => next.planned = true,
            Ask::Arm => next.arming = true,
            Ask::Disarm | Ask::Stop => next.arming = false,
            _ => {}
        }
        next
    }
}

/// Returns the checks before arming, in the order in which they are worth mending.
pub fn checks(now: &Situation) -> [Check; 5] {
    let linked = now.silence.is_some_and(|silence| silence <= SILENT);
    let [vicon, height] = match now.ages {
        Some(ages) => ages.map(|age| Some(age <= OLD)),
        None => [None; 2],
    };
    let rest = now.height.zip(now.speed).map(|(height, speed)| height < LOW && speed < SLOW);
    let rows = [
        ("telemetry", Some(linked), "no telemetry from the aircraft"),
        ("on the ground", Some(!now.is_flying()), "the aircraft is flying"),
        ("motion capture", vicon, "motion capture does not see the aircraft"),
        ("height sensor", height, "no measurement of the height"),
        ("at rest", rest, "the aircraft is not at rest on the ground"),
    ];
    rows.map(|(name, passed, problem)| {
        // Without telemetry, the other values are old.
        let passed = passed.filter(|_| linked || name == "telemetry");
        Check { name, known: passed.is_some(), problem: (passed == Some(false)).then_some(problem) }
    })
}

/// Returns the first of some requests that is refused in their order, if there is one.
pub fn first_refused(asks: &[Ask], now: &Situation) -> Option<usize> {
    let mut now = *now;
    asks.iter().position(|ask| {
        let refused = reason(ask, &now).is_some();
        now = now.after(ask);
        refused
    })
}

/// Returns the reason to refuse a request; none if it may go to the aircraft.
pub fn reason(ask: &Ask, now: &Situation) -> Option<String> {
    match ask {
        Ask::TakeOff => take_off(now).map(|why| format!("take-off refused: {why}")),
        Ask::Arm => {
            let problem = checks(now).into_iter().find_map(|check| check.problem);
            problem.map(|problem| format!("arming refused: {problem}"))
        }
        Ask::Disarm if now.is_flying() => {
            Some("disarming refused: the aircraft is flying: land it, or press STOP".into())
        }
        Ask::Fly { points } => trajectory(points, &now.aircraft.settings().space)
            .map(|why| format!("trajectory refused: {why}")),
        Ask::Set { number, value } => parameter(*number, *value, now),
        Ask::Choose { every, signals } => {
            selection(*every, signals).map(|why| format!("signals refused: {why}"))
        }
        Ask::Sticks { roll, pitch, yaw_rate, climb } => {
            let numbers = [roll, pitch, yaw_rate, climb].iter().all(|it| it.is_finite());
            (!numbers).then(|| "sticks refused: a value is not a number".into())
        }
        Ask::Inject { injection } => injection.refusal(now.aircraft.airframe().motors),
        Ask::Link { loss, duplication, reordering, delay } => {
            let shares = [loss, duplication, reordering];
            let sound = shares.iter().all(|it| (0.0..=1.0).contains(*it));
            let sound = sound && (0.0..=1.0).contains(delay);
            (!sound).then(|| "link refused: probabilities are 0 to 1, the delay is 0 to 1 s".into())
        }
        _ => None,
    }
}

/// Returns the reason why a take-off is impossible now, with the remedy.
fn take_off(now: &Situation) -> Option<&'static str> {
    if now.silence.is_none_or(|silence| silence > SILENT) {
        return Some("no telemetry from the aircraft");
    }
    if now.is_flying() {
        return Some("the aircraft is flying");
    }
    if !now.arming && (now.phase == Phase::Over as u8 || !now.clear) {
        return Some("the aircraft is disarmed: arm it first");
    }
    (!now.planned).then_some("no trajectory since the last flight: send one first")
}

/// Returns what is wrong with a trajectory.
fn trajectory(points: &[Point], space: &Space) -> Option<String> {
    if points.is_empty() || points.len() > MAX_POINTS {
        return Some(format!("it has {} points; allowed are 1 to {MAX_POINTS}", points.len()));
    }
    let (reach, low, high) = (space.reach, space.heights.x, space.heights.y);
    let mut before = None;
    for (index, point) in points.iter().enumerate() {
        let Point { time, x, y, z, yaw } = *point;
        let rows = [
            ("time", time, 0.0, space.latest, "s"),
            ("x", x, -reach, reach, "m"),
            ("y", y, -reach, reach, "m"),
            ("z", z, low, high, "m"),
            ("yaw", yaw, -TAU, TAU, "rad"),
        ];
        let number = index + 1;
        for (name, value, least, most, unit) in rows {
            if !(least..=most).contains(&value) {
                let (least, most) = (rounded(least), rounded(most));
                return Some(format!(
                    "{name} of point {number} is {value} {unit}; allowed are {least} to {most} {unit}"
                ));
            }
        }
        if before.is_some_and(|before| time <= before) {
            return Some(format!("point {number} does not start after the point before it"));
        }
        before = Some(time);
    }
    None
}

/// Rounds a limit to 2 decimals towards 0, for display.
fn rounded(limit: f64) -> f64 {
    (limit * 100.0).trunc() / 100.0
}

/// Returns the reason to refuse the value of a parameter.
fn parameter(number: u8, value: f64, now: &Situation) -> Option<String> {
    let Some(it) = catalogue::parameters(now.aircraft).into_iter().find(|it| it.number == number)
    else {
        return Some(format!("parameter refused: there is no parameter {number}"));
    };
    if !(it.least..=it.most).contains(&value) {
        let (name, unit) = (it.name, [" ", it.unit].concat());
        let unit = unit.trim_end();
        return Some(format!(
            "{name} refused: {value}{unit}; allowed are {} to {}{unit}",
            it.least, it.most
        ));
    }
    let grounded = now.is_flying() && !it.in_flight;
    grounded.then(|| format!("{} refused: it changes only on the ground", it.name))
}

/// Returns what is wrong with a selection of signals.
fn selection(every: u8, signals: &[u8]) -> Option<String> {
    if every == 0 {
        return Some("the period is 0; allowed are 1 to 255 control periods".into());
    }
    if signals.is_empty() || signals.len() > MOST_SIGNALS {
        return Some(format!("{} are selected; allowed are 1 to {MOST_SIGNALS}", signals.len()));
    }
    let known = |number: u8| number == UNUSED || SIGNALS.iter().any(|it| it.number == number);
    let unknown = signals.iter().find(|number| !known(**number))?;
    Some(format!("there is no signal {unknown}"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bench::Injection;

    /// Ready for take-off.
    const READY: Situation = Situation {
        phase: Phase::Ready as u8,
        clear: true,
        arming: false,
        planned: true,
        silence: Some(0.0),
        aircraft: Aircraft::Mambo,
        height: Some(0.0),
        speed: Some(0.0),
        ages: Some([0.01, 0.0]),
    };

    const POINT: Point = Point { time: 0.0, x: 0.0, y: 0.0, z: 1.0, yaw: 0.0 };

    fn fly(points: &[Point]) -> Ask {
        Ask::Fly { points: points.to_vec() }
    }

    #[test]
    fn a_take_off_needs_a_vehicle_that_is_ready() {
        assert_eq!(reason(&Ask::TakeOff, &READY), None);
        let over = Situation { phase: Phase::Over as u8, ..READY };
        assert_eq!(reason(&Ask::TakeOff, &Situation { arming: true, ..over }), None);
        let rows = [
            (Situation { silence: None, ..READY }, "no telemetry"),
            (Situation { silence: Some(3.0), ..READY }, "no telemetry"),
            (Situation { phase: Phase::Hold as u8, ..READY }, "is flying"),
            (over, "arm it first"),
            (Situation { clear: false, ..READY }, "arm it first"),
            (Situation { planned: false, ..READY }, "send one first"),
        ];
        for (now, words) in rows {
            let why = reason(&Ask::TakeOff, &now).unwrap_or_default();
            assert!(why.starts_with("take-off refused: ") && why.contains(words), "{words}: {why}");
        }
    }

    #[test]
    fn what_ends_a_flight_is_never_refused() {
        let worst = Situation { silence: None, clear: false, planned: false, ..READY };
        for phase in 0..=u8::MAX {
            for ask in [Ask::Stop, Ask::Land, Ask::Release] {
                assert_eq!(reason(&ask, &Situation { phase, ..worst }), None, "{ask:?}");
            }
        }
    }

    #[test]
    fn a_value_out_of_bounds_is_named() {
        let nan = f64::NAN;
        let rows = [
            (fly(&[]), "it has 0 points; allowed are 1 to 16"),
            (fly(&[POINT; 17]), "it has 17 points"),
            (fly(&[Point { x: 99.0, ..POINT }]), "x of point 1 is 99 m; allowed are -"),
            (fly(&[Point { z: nan, ..POINT }]), "z of point 1 is NaN m"),
            (
                fly(&[Point { yaw: -7.0, ..POINT }]),
                "yaw of point 1 is -7 rad; allowed are -6.28 to 6.28 rad",
            ),
            (fly(&[Point { time: -1.0, ..POINT }]), "time of point 1 is -1 s"),
            (fly(&[POINT, POINT]), "point 2 does not start after"),
            (Ask::Set { number: 200, value: 0.0 }, "there is no parameter 200"),
            (
                Ask::Set { number: 0, value: 99.0 },
                "height P refused: 99 N/m; allowed are 0.5 to 3 N/m",
            ),
            (Ask::Set { number: 15, value: nan }, "feed-forward gain refused: NaN; allowed are"),
            (Ask::Choose { every: 0, signals: vec![1] }, "the period is 0"),
            (Ask::Choose { every: 4, signals: Vec::new() }, "0 are selected"),
            (Ask::Choose { every: 4, signals: vec![0; 37] }, "37 are selected"),
            (Ask::Choose { every: 4, signals: vec![0, 60] }, "there is no signal 60"),
            (Ask::Sticks { roll: 0.0, pitch: nan, yaw_rate: 0.0, climb: 0.0 }, "not a number"),
            (Ask::Link { loss: 1.5, duplication: 0.0, reordering: 0.0, delay: 0.0 }, "0 to 1"),
            (Ask::Inject { injection: Injection::Motor { number: Some(4) } }, "motors 1 to 4"),
            (
                Ask::Inject { injection: Injection::Wind { force: [nan, 0.0], gusts: 0.0 } },
                "wind refused",
            ),
        ];
        for (ask, words) in rows {
            let why = reason(&ask, &READY).unwrap_or_default();
            assert!(why.contains(words), "{words}: {why}");
        }
    }

    #[test]
    fn some_commands_depend_on_the_flight() {
        let flying = Situation { phase: Phase::Flight as u8, ..READY };
        let law = Ask::Set { number: 19, value: 1.0 };
        assert_eq!(reason(&law, &READY), None);
        let why = reason(&law, &flying).unwrap_or_default();
        assert_eq!(why, "candidate refused: it changes only on the ground");
        assert_eq!(reason(&Ask::Arm, &READY), None);
        assert_eq!(
            reason(&Ask::Arm, &flying).as_deref(),
            Some("arming refused: the aircraft is flying")
        );
        assert_eq!(reason(&fly(&[POINT]), &flying), None);
        assert_eq!(reason(&Ask::Disarm, &READY), None);
        let why = reason(&Ask::Disarm, &flying).unwrap_or_default();
        assert!(why.contains("land it, or press STOP"), "{why}");
    }

    #[test]
    fn arming_needs_every_check_that_is_known() {
        let rows = [
            (Situation { silence: None, ..READY }, "no telemetry"),
            (Situation { phase: Phase::Flight as u8, ..READY }, "is flying"),
            (Situation { ages: Some([2.0, 0.0]), ..READY }, "motion capture"),
            (Situation { ages: Some([0.0, 2.0]), ..READY }, "of the height"),
            (Situation { height: Some(0.3), ..READY }, "not at rest"),
            (Situation { speed: Some(0.3), ..READY }, "not at rest"),
            (Situation { speed: Some(f64::NAN), ..READY }, "not at rest"),
        ];
        for (now, words) in rows {
            let why = reason(&Ask::Arm, &now).unwrap_or_default();
            assert!(why.starts_with("arming refused: ") && why.contains(words), "{words}: {why}");
            let failed = checks(&now).into_iter().filter(|it| it.problem.is_some());
            assert_eq!(failed.count(), 1, "{words}");
        }
        let blind = Situation { height: None, ages: None, ..READY };
        assert_eq!(reason(&Ask::Arm, &blind), None);
        assert_eq!(checks(&blind).iter().filter(|it| !it.known).count(), 3);
    }

    #[test]
    fn requests_are_judged_in_their_order() {
        let over = Situation { phase: Phase::Over as u8, planned: false, ..READY };
        let up = fly(&[POINT]);
        assert_eq!(first_refused(&[Ask::Arm, up.clone(), Ask::TakeOff], &over), None);
        assert_eq!(first_refused(&[up.clone(), Ask::Arm, Ask::TakeOff], &over), None);
        assert_eq!(first_refused(&[up, Ask::TakeOff], &over), Some(1));
        assert_eq!(first_refused(&[Ask::Arm, Ask::TakeOff], &over), Some(1));
    }
}
