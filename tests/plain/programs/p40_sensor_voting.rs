//! Voting of three redundant sensors, and the alarm manager that turns its
//! findings into latched, acknowledged and prioritised alarms.

/// Reading of one channel; `None` when the channel did not answer.
pub type Reading = Option<f32>;

/// What the vote rests on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Vote {
    /// All three agree.
    Unanimous { value: f32 },
    /// Two agree; the third is named.
    Majority { value: f32, odd: usize },
    /// One healthy channel left.
    Single { value: f32 },
    /// Nothing to be believed; the last good value is held.
    Failed { held: f32 },
}

impl Vote {
    pub fn value(&self) -> f32 {
        match *self {
            Self::Unanimous { value }
            | Self::Majority { value, .. }
            | Self::Single { value }
            | Self::Failed { held: value } => value,
        }
    }
}

#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
struct Health {
    strikes: u8,
    isolated: bool,
}

/// Two-out-of-three voter with a miscompare counter per channel.
#[derive(Clone, Debug)]
pub struct Voter {
    tolerance: f32,
    range: core::ops::RangeInclusive<f32>,
    health: [Health; 3],
    last_good: f32,
}

impl Voter {
    /// Strikes in excess of good samples after which a channel is isolated.
    pub const MAX_STRIKES: u8 = 5;

    pub fn new(tolerance: f32, range: core::ops::RangeInclusive<f32>) -> Self {
        let last_good = 0.5 * (range.start() + range.end());
        Self { tolerance, range, health: Default::default(), last_good }
    }

    pub fn step(&mut self, readings: [Reading; 3]) -> Vote {
        let mut usable = readings.map(|r| r.filter(|v| self.range.contains(v)));
        for (slot, health) in usable.iter_mut().zip(&self.health) {
            *slot = slot.filter(|_| !health.isolated);
        }
        let close = |a: f32, b: f32| (a - b).abs() <= self.tolerance;

        let vote = match usable {
            [Some(a), Some(b), Some(c)] => {
                match (close(a, b), close(b, c), close(a, c)) {
                    (true, true, _) | (true, _, true) | (_, true, true) => {
                        Vote::Unanimous { value: median(a, b, c) }
                    }
                    (true, ..) => Vote::Majority { value: 0.5 * (a + b), odd: 2 },
                    (_, true, _) => Vote::Majority { value: 0.5 * (b + c), odd: 0 },
                    (_, _, true) => Vote::Majority { value: 0.5 * (a + c), odd: 1 },
                    _ => Vote::Failed { held: self.last_good },
                }
            }
            [Some(a), Some(b), None] | [Some(a), None, Some(b)] | [None, Some(a), Some(b)]
                if close(a, b) =>
            {
                let odd = usable.iter().position(Option::is_none).unwrap_or_default();
                Vote::Majority { value: 0.5 * (a + b), odd }
            }
            [Some(value), None, None] | [None, Some(value), None] | [None, None, Some(value)] => {
                Vote::Single { value }
            }
            _ => Vote::Failed { held: self.last_good },
        };
        self.judge(&vote, &usable);
        vote
    }

    fn judge(&mut self, vote: &Vote, usable: &[Reading; 3]) {
        let odd = match vote {
            Vote::Majority { odd, .. } => Some(*odd),
            Vote::Failed { .. } => return,
            _ => None,
        };
        self.last_good = vote.value();
        for (n, (health, reading)) in self.health.iter_mut().zip(usable).enumerate() {
            if odd == Some(n) || reading.is_none() {
                health.strikes = (health.strikes + 1).min(Self::MAX_STRIKES);
                health.isolated |= health.strikes == Self::MAX_STRIKES;
            } else {
                health.strikes = health.strikes.saturating_sub(1);
            }
        }
    }

    pub fn isolated(&self) -> impl Iterator<Item = usize> + '_ {
        self.health.iter().enumerate().filter(|(_, h)| h.isolated).map(|(n, _)| n)
    }

    /// Gives isolated channels another chance, after maintenance.
    pub fn rehabilitate(&mut self) {
        self.health = Default::default();
    }
}

fn median(a: f32, b: f32, c: f32) -> f32 {
    a.min(b).max(a.max(b).min(c))
}

/// Alarms and their state.
pub mod alarm {
    use super::{Vote, Voter};

    #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
    pub enum Severity {
        Advisory,
        Caution,
        Warning,
    }

    /// The alarms there are; the discriminant is the table index.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub enum Alarm {
        Miscompare,
        ChannelIsolated,
        SensorLost,
    }

    impl Alarm {
        pub const ALL: [Self; 3] = [Self::Miscompare, Self::ChannelIsolated, Self::SensorLost];

        /// Severity, delay in steps, and whether it latches until acknowledged.
        const TABLE: [(Severity, u8, bool); 3] = [
            (Severity::Advisory, 3, false),
            (Severity::Caution, 1, true),
            (Severity::Warning, 1, true),
        ];

        fn properties(self) -> (Severity, u8, bool) {
            Self::TABLE[self as usize]
        }

        pub fn severity(self) -> Severity {
            self.properties().0
        }
    }

    #[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
    pub enum State {
        #[default]
        Normal,
        Pending(u8),
        Active,
        Acknowledged,
        /// Condition gone, but nobody has acknowledged yet.
        Latched,
    }

    #[derive(Clone, Debug, Default)]
    pub struct AlarmManager {
        states: [State; 3],
    }

    impl AlarmManager {
        pub fn new() -> Self {
            Self::default()
        }

        /// Evaluates all conditions once; gives the most severe alarm showing.
        pub fn step(&mut self, vote: &Vote, voter: &Voter) -> Option<Alarm> {
            for alarm in Alarm::ALL {
                let condition = match alarm {
                    Alarm::Miscompare => matches!(vote, Vote::Majority { .. }),
                    Alarm::ChannelIsolated => voter.isolated().next().is_some(),
                    Alarm::SensorLost => matches!(vote, Vote::Single { .. } | Vote::Failed { .. }),
                };
                let (_, delay, latching) = alarm.properties();
                let state = &mut self.states[alarm as usize];
                *state = match (*state, condition) {
                    (State::Normal, true) if delay <= 1 => State::Active,
                    (State::Normal, true) => State::Pending(1),
                    (State::Pending(n), true) if n + 1 >= delay => State::Active,
                    (State::Pending(n), true) => State::Pending(n + 1),
                    (State::Latched, true) => State::Active,
                    (State::Active, false) if latching => State::Latched,
                    (State::Latched, false) => State::Latched,
                    (held, true) => held,
                    (_, false) => State::Normal,
                };
            }
            self.showing().max_by_key(|a| a.severity())
        }

        pub fn acknowledge(&mut self, alarm: Alarm) {
            let state = &mut self.states[alarm as usize];
            *state = match *state {
                State::Active => State::Acknowledged,
                State::Latched => State::Normal,
                other => other,
            };
        }

        pub fn state(&self, alarm: Alarm) -> State {
            self.states[alarm as usize]
        }

        fn showing(&self) -> impl Iterator<Item = Alarm> {
            Alarm::ALL
                .into_iter()
                .filter(|&a| matches!(self.state(a), State::Active | State::Latched))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::alarm::{Alarm, AlarmManager, State};
    use super::*;

    #[test]
    fn votes() {
        let mut v = Voter::new(0.5, 0.0..=100.0);
        assert_eq!(v.step([Some(10.0), Some(10.4), Some(10.2)]), Vote::Unanimous { value: 10.2 });
        assert_eq!(v.step([Some(10.0), Some(50.0), Some(10.0)]), Vote::Majority { value: 10.0, odd: 1 });
        assert_eq!(v.step([Some(1.0), Some(50.0), Some(90.0)]), Vote::Failed { held: 10.0 });
        assert_eq!(v.step([None, Some(f32::NAN), Some(7.0)]).value(), 7.0);
    }

    #[test]
    fn a_bad_channel_is_isolated_and_comes_back_on_request() {
        let mut v = Voter::new(0.5, 0.0..=100.0);
        for _ in 0..Voter::MAX_STRIKES {
            v.step([Some(20.0), Some(20.1), Some(80.0)]);
        }
        assert!(v.isolated().eq([2]));
        // Two channels that disagree cannot be decided between.
        assert!(matches!(v.step([Some(20.0), Some(30.0), Some(20.0)]), Vote::Failed { .. }));
        v.rehabilitate();
        assert_eq!(v.step([Some(20.0); 3]), Vote::Unanimous { value: 20.0 });
    }

    #[test]
    fn alarms_delay_latch_and_acknowledge() {
        let mut v = Voter::new(0.5, 0.0..=100.0);
        let mut m = AlarmManager::new();
        let odd = [Some(1.0), Some(1.0), Some(9.0)];
        let shown = [odd, odd, odd, odd, odd].map(|r| m.step(&v.step(r), &v));
        assert_eq!(
            shown,
            [None, None, Some(Alarm::Miscompare), Some(Alarm::Miscompare), Some(Alarm::ChannelIsolated)]
        );
        assert_eq!(m.step(&v.step([None; 3]), &v), Some(Alarm::SensorLost));
        m.acknowledge(Alarm::SensorLost);
        assert_eq!(m.state(Alarm::SensorLost), State::Acknowledged);
        v.rehabilitate();
        let good = v.step([Some(1.0); 3]);
        assert_eq!(m.step(&good, &v), Some(Alarm::ChannelIsolated));
        m.acknowledge(Alarm::ChannelIsolated);
        assert_eq!(m.step(&good, &v), None);
    }
}
