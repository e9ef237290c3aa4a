//! What a test takes: time by the clock, and of the processors.
//!
//! By the clock a test also waits: for the lock on a target folder, and for the processors that other tests use. So tests
//! are put in order, left out of a quick run and seen to grow by what they use of the processors.
//!
//! What it must not know: what a test is.

use std::time::{Duration, Instant};

/// Linux counts processor time in hundredths of a second, for all that reads of it.
const TICKS: u32 = 100;

/// What something took.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Spent {
    /// By the clock.
    pub time: Duration,
    /// Of the processors; by the clock where the system does not tell.
    pub work: Duration,
}

impl Spent {
    /// What took as much since `start`, if nobody counted what it used of the processors.
    pub fn since(start: Instant) -> Self {
        let time = start.elapsed();
        Self { time, work: time }
    }
}

/// Measures what a process takes, lap by lap.
pub(super) struct Meter {
    pid: u32,
    since: Instant,
    before: Option<Duration>,
}

impl Meter {
    /// Of a process that has just started.
    pub(super) fn of(pid: u32) -> Self {
        Self { pid, since: Instant::now(), before: Some(Duration::ZERO) }
    }

    /// What the process took since the last lap. Children count once it has waited for them.
    pub(super) fn lap(&mut self) -> Spent {
        let time = self.since.elapsed();
        let now = used(self.pid);
        let work = now.zip(self.before).map_or(time, |(now, before)| now.saturating_sub(before));
        (self.since, self.before) = (Instant::now(), now);
        Spent { time, work }
    }
}

/// What a process and the children that it has waited for used of the processors.
fn used(pid: u32) -> Option<Duration> {
    ticks(&std::fs::read_to_string(format!("/proc/{pid}/stat")).ok()?)
        .map(|ticks| Duration::from_secs(ticks) / TICKS)
}

/// The ticks in a line of `/proc/PID/stat`: fields 14 to 17, counted from 1. The second is the name of the program, in
/// parentheses, and may have spaces and parentheses of its own.
fn ticks(line: &str) -> Option<u64> {
    let (_, fields) = line.rsplit_once(") ")?;
    let fields: Vec<&str> = fields.split(' ').collect();
    fields.get(11..15)?.iter().map(|it| it.parse::<u64>().ok()).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ticks_stand_behind_any_name() {
        let rest = "S 1 7 7 0 -1 4194560 9 8 0 0 1 20 300 4000 20 0 1 0 5 6 7";
        assert_eq!(ticks(&format!("7 (test) {rest}")), Some(4321));
        assert_eq!(ticks(&format!("7 (a) b) {rest}")), Some(4321));
        assert_eq!(ticks("7 (test) S 1"), None);
    }
}
