//! Events of a flight: phases, alarms, failsafes, sensors, link, software and refused commands, in an operator's words.
//!
//! Page, recording and tools receive the same events. Sources are the software's outputs of each period, the state of
//! the link, and the requests that were executed.
//!
//! Invariant: a change is one event, however long it lasts; a lost source is one event when it is lost and one when it
//! returns. What it must not know: sockets, files, and who reads the events.

use crate::bench::{Injection, Period};
use crate::station::Outcome;
use crate::testbed::Testbed;
use models::{Alarm, Outputs, Phase};
use serde::Serialize;

/// Age from which a sensor counts as lost, s.
const SENSOR_TIMEOUT: f64 = 0.5;

/// Age below which a lost sensor counts as back, s.
const SENSOR_RETURN: f64 = 0.1;

/// Silence of the downlink after which the link counts as lost, s.
const LINK_TIMEOUT: f64 = 1.0;

/// Speed of a touch-down from which it is a crash, m/s.
const CRASH_SPEED: f64 = 0.8;

/// Time within which several impacts are one, s.
const IMPACT_PERIOD: f64 = 1.0;

/// Severity of an event.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Severity {
    /// Normal course of a flight.
    Info,
    /// Needs attention.
    Warning,
    /// The flight is in danger or has ended.
    Critical,
}

/// An event.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Event {
    /// Time since the testbed began, s.
    pub time: f64,
    /// Severity.
    pub severity: Severity,
    /// Text for the operator.
    pub text: String,
}

/// State of the testbed on which events depend.
#[derive(Clone, Debug)]
pub struct Sight {
    /// Time since the testbed began, s.
    pub time: f64,
    /// Outputs of the software; none while it does not answer.
    pub outputs: Option<Outputs>,
    /// Speed at which the aircraft hit the ground in the period, m/s; 0 if it did not.
    pub impact: f64,
    /// Number of restarts of the software.
    pub restarts: u64,
    /// Reason for the last restart.
    pub ended: Option<String>,
    /// Time since the last packet of the downlink, s; none before the first.
    pub silence: Option<f64>,
}

impl Sight {
    /// Returns the state after a period.
    pub fn of(testbed: &Testbed, done: &Period) -> Self {
        let time = testbed.now();
        Self {
            time,
            outputs: testbed.bench.is_answered().then_some(done.moment.outputs),
            impact: done.moment.impact,
            restarts: testbed.restarts,
            ended: testbed.ended.clone(),
            silence: testbed.station.silence(time),
        }
    }
}

/// A source that is lost and returns.
#[derive(Clone, Copy, Debug, Default)]
struct Source {
    /// Time of the loss, s; none while the source is there.
    lost: Option<f64>,
}

impl Source {
    /// Returns the duration, s, of a loss that ended now, or 0 for a loss that began now; none without a change.
    fn change(&mut self, time: f64, age: f64, timeout: f64, back: f64) -> Option<f64> {
        match self.lost {
            None if age > timeout => {
                self.lost = Some(time - age);
                Some(0.0)
            }
            Some(since) if age < back => {
                self.lost = None;
                Some(time - since)
            }
            _ => None,
        }
    }
}

/// Watches a flight for events.
#[derive(Clone, Debug)]
pub struct Watch {
    phase: Phase,
    alarm: Alarm,
    silent: bool,
    sources: [Source; 4],
    link: Source,
    restarts: u64,
    impact: f64,
    /// True from a command to land until the next phase that is no landing.
    landing: bool,
}

impl Default for Watch {
    fn default() -> Self {
        Self {
            phase: Phase::Over,
            alarm: Alarm::Clear,
            silent: false,
            sources: Default::default(),
            link: Source::default(),
            restarts: 0,
            impact: f64::NEG_INFINITY,
            landing: false,
        }
    }
}

/// Names of the sources, in the order of their ages.
const SOURCES: [&str; 4] = ["gyroscope", "motion capture", "height", "horizontal motion"];

/// State of a source.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Health {
    /// Name of the source.
    pub name: &'static str,
    /// Time of the loss, s; none while the source is there.
    pub lost: Option<f64>,
}

impl Watch {
    /// Returns the state of each source.
    pub fn sources(&self) -> [Health; 4] {
        std::array::from_fn(|n| Health { name: SOURCES[n], lost: self.sources[n].lost })
    }

    /// Notes that a landing was commanded.
    pub fn land(&mut self) {
        self.landing = true;
    }

    /// Returns the events of a period.
    pub fn look(&mut self, sight: &Sight) -> Vec<Event> {
        let time = sight.time;
        let mut events = Vec::new();
        let mut add = |severity, text: String| events.push(Event { time, severity, text });
        if sight.restarts > self.restarts {
            self.restarts = sight.restarts;
            let reason = sight.ended.as_deref().unwrap_or("no reason known");
            add(
                Severity::Critical,
                format!("the onboard software ended and was restarted: {reason}"),
            );
            (self.phase, self.alarm) = (Phase::Over, Alarm::Clear);
        }
        if self.silent != sight.outputs.is_none() {
            self.silent = sight.outputs.is_none();
            match self.silent {
                true => add(
                    Severity::Critical,
                    "the onboard software does not answer: motors off".into(),
                ),
                false => add(Severity::Info, "the onboard software answers".into()),
            }
        }
        if let Some(outputs) = &sight.outputs {
            let ages = [
                outputs.ages.inertial,
                outputs.ages.vicon,
                outputs.ages.height,
                outputs.ages.plane,
            ];
            for ((source, name), age) in self.sources.iter_mut().zip(SOURCES).zip(ages) {
                match source.change(time, age, SENSOR_TIMEOUT, SENSOR_RETURN) {
                    None => {}
                    Some(0.0) => add(Severity::Warning, format!("{name} lost")),
                    Some(lost) => add(Severity::Info, format!("{name} back after {lost:.1} s")),
                }
            }
            if outputs.alarm != self.alarm {
                self.alarm = outputs.alarm;
                match reason(self.alarm) {
                    Some(reason) => add(Severity::Critical, format!("alarm: {reason}; motors off")),
                    None => add(Severity::Info, "alarm cleared".into()),
                }
            }
            let phase = outputs.reference.phase;
            if phase != self.phase {
                self.phase = phase;
                let lost = self.sources.iter().zip(SOURCES).find(|(it, _)| it.lost.is_some());
                let (severity, text) = entered(phase, self.landing, lost.map(|(_, name)| name));
                add(severity, text);
                self.landing &= phase == Phase::Landing;
            }
        }
        if let Some(silence) = sight.silence {
            match self.link.change(time, silence, LINK_TIMEOUT, LINK_TIMEOUT) {
                None => {}
                Some(0.0) => add(Severity::Warning, "downlink lost".into()),
                Some(lost) => add(Severity::Info, format!("downlink back after {lost:.1} s")),
            }
        }
        if sight.impact >= CRASH_SPEED && time - self.impact > IMPACT_PERIOD {
            add(Severity::Critical, format!("crash: hit the ground at {:.1} m/s", sight.impact));
        }
        if sight.impact >= CRASH_SPEED {
            self.impact = time;
        }
        events
    }
}

/// Returns the reason of an alarm; none for its absence.
pub fn reason(alarm: Alarm) -> Option<&'static str> {
    Some(match alarm {
        Alarm::Clear => return None,
        Alarm::Commanded => "stopped by the operator",
        Alarm::Undefined => "the state estimate is not a number",
        Alarm::Clock => "the processor's clock is wrong",
        Alarm::Unmeasured => "position or attitude has not been measured for too long",
        Alarm::Tilt => "tilt beyond its limit",
        Alarm::Spin => "turn rate beyond its limit",
        Alarm::Speed => "speed beyond its limit",
        Alarm::Height => "height beyond its limit",
        Alarm::Position => "position beyond the walls",
        Alarm::Impact => "about to hit the ground too hard",
    })
}

/// Returns the event of a phase; a landing that nobody commanded is a failsafe.
fn entered(phase: Phase, commanded: bool, lost: Option<&str>) -> (Severity, String) {
    let because = lost.map_or(String::new(), |name| format!(": {name} lost"));
    match phase {
        Phase::Ready => (Severity::Info, "armed".into()),
        Phase::TakeOff => (Severity::Info, "take-off".into()),
        Phase::Flight => (Severity::Info, "flight".into()),
        Phase::Landing if commanded => (Severity::Info, "landing, as commanded".into()),
        Phase::Landing if lost.is_none() => {
            (Severity::Warning, "failsafe landing: uplink lost".into())
        }
        Phase::Landing => (Severity::Warning, format!("failsafe landing{because}")),
        Phase::Over => (Severity::Info, "disarmed, motors off".into()),
        Phase::Hold => (Severity::Warning, "failsafe hold: uplink lost".into()),
    }
}

/// Returns the severity and text of a command's outcome; none for one that succeeded.
pub fn outcome(order: &str, outcome: &Outcome) -> Option<(Severity, String)> {
    match outcome {
        Outcome::Done => None,
        Outcome::GivenUp => Some((Severity::Warning, format!("{order}: no confirmation"))),
        Outcome::Refused => Some((Severity::Warning, format!("{order}: refused by the aircraft"))),
    }
}

/// Returns the text of a fault injection; none for wind, which changes with each move of its slider.
pub fn injected(injection: &Injection) -> Option<String> {
    Some(match injection {
        Injection::Motor { number: Some(number) } => {
            format!("fault injection: motor {} stopped", number.saturating_add(1))
        }
        Injection::Motor { number: None } => "fault injection: all motors run".into(),
        Injection::Gyroscope { stuck: true } => "fault injection: gyroscope stuck".into(),
        Injection::Gyroscope { stuck: false } => "fault injection: gyroscope works".into(),
        Injection::Vicon { away: true } => "fault injection: motion capture lost".into(),
        Injection::Vicon { away: false } => "fault injection: motion capture works".into(),
        Injection::Wind { .. } => return None,
        Injection::Back => "vehicle reset".into(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// State of a flight without trouble.
    fn calm(time: f64) -> Sight {
        let mut outputs = Outputs::default();
        outputs.reference.phase = Phase::Over;
        let outputs = Some(outputs);
        Sight { time, outputs, impact: 0.0, restarts: 0, ended: None, silence: Some(0.0) }
    }

    fn texts(watch: &mut Watch, sight: &Sight) -> Vec<String> {
        watch.look(sight).into_iter().map(|event| event.text).collect()
    }

    /// Returns the state with a change of the outputs.
    fn with(time: f64, change: impl Fn(&mut Outputs)) -> Sight {
        let mut sight = calm(time);
        sight.outputs.iter_mut().for_each(change);
        sight
    }

    #[test]
    fn a_calm_period_has_no_event() {
        assert_eq!(texts(&mut Watch::default(), &calm(1.0)), [""; 0]);
    }

    #[test]
    fn each_change_is_one_event() {
        type Change = fn(&mut Outputs);
        let rows: [(Change, &str); 8] = [
            (|it| it.reference.phase = Phase::TakeOff, "take-off"),
            (|it| it.reference.phase = Phase::Flight, "flight"),
            (|it| it.reference.phase = Phase::Hold, "failsafe hold: uplink lost"),
            (|it| it.reference.phase = Phase::Landing, "failsafe landing: uplink lost"),
            (|it| it.reference.phase = Phase::Ready, "armed"),
            (|it| it.alarm = Alarm::Tilt, "alarm: tilt beyond its limit; motors off"),
            (|it| it.ages.vicon = 0.6, "motion capture lost"),
            (|it| it.ages.inertial = 0.6, "gyroscope lost"),
        ];
        for (change, text) in rows {
            let mut watch = Watch::default();
            assert_eq!(texts(&mut watch, &with(1.0, change)), [text]);
            assert_eq!(texts(&mut watch, &with(1.1, change)), [""; 0], "{text}, again");
        }
        let mut watch = Watch::default();
        watch.look(&with(1.0, |it| it.reference.phase = Phase::Ready));
        assert_eq!(texts(&mut watch, &calm(1.1)), ["disarmed, motors off"]);
    }

    #[test]
    fn a_source_that_returns_tells_how_long_it_was_lost() {
        let mut watch = Watch::default();
        watch.look(&with(10.0, |it| it.ages.vicon = 0.6));
        assert_eq!(texts(&mut watch, &with(12.0, |it| it.ages.vicon = 2.6)), [""; 0]);
        assert_eq!(texts(&mut watch, &calm(15.4)), ["motion capture back after 6.0 s"]);
    }

    #[test]
    fn a_landing_names_its_cause() {
        let lands = |it: &mut Outputs| it.reference.phase = Phase::Landing;
        let mut watch = Watch::default();
        watch.land();
        assert_eq!(texts(&mut watch, &with(1.0, lands)), ["landing, as commanded"]);
        let mut watch = Watch::default();
        watch.look(&with(1.0, |it| it.ages.inertial = 0.6));
        let lost = |it: &mut Outputs| {
            lands(it);
            it.ages.inertial = 0.7;
        };
        assert_eq!(texts(&mut watch, &with(1.1, lost)), ["failsafe landing: gyroscope lost"]);
    }

    #[test]
    fn a_restart_and_its_silence_are_events() {
        let mut watch = Watch::default();
        let silent = Sight { outputs: None, ..calm(1.0) };
        assert_eq!(
            texts(&mut watch, &silent),
            ["the onboard software does not answer: motors off"]
        );
        let ended = Some("signal 9".to_owned());
        let again = Sight { restarts: 1, ended, ..calm(2.0) };
        let expected = [
            "the onboard software ended and was restarted: signal 9",
            "the onboard software answers",
        ];
        assert_eq!(texts(&mut watch, &again), expected);
    }

    #[test]
    fn impacts_within_a_second_are_one_crash() {
        let mut watch = Watch::default();
        let hit = |time, impact| Sight { impact, ..calm(time) };
        assert_eq!(texts(&mut watch, &hit(1.0, 0.3)), [""; 0]);
        assert_eq!(texts(&mut watch, &hit(2.0, 2.5)), ["crash: hit the ground at 2.5 m/s"]);
        assert_eq!(texts(&mut watch, &hit(2.4, 1.0)), [""; 0]);
    }

    #[test]
    fn the_downlink_is_lost_and_returns() {
        let mut watch = Watch::default();
        let silence = |time, silence| Sight { silence: Some(silence), ..calm(time) };
        assert_eq!(texts(&mut watch, &silence(5.0, 1.5)), ["downlink lost"]);
        assert_eq!(texts(&mut watch, &silence(6.0, 2.5)), [""; 0]);
        assert_eq!(texts(&mut watch, &silence(6.5, 0.0)), ["downlink back after 3.0 s"]);
    }
}
