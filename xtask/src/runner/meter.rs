//! Measures what a test costs: wall time and processor time.
//!
//! Wall time includes waiting, for the lock on a target folder and for other tests. So processor time decides in which order
//! tests run, which ones a quick run leaves out, and which ones have grown.
//!
//! What it must not know: what a test is.

use std::time::{Duration, Instant};

/// Linux counts processor time in hundredths of a second, for all that reads of it.
const TICKS: u32 = 100;

/// The cost of a test or a stage.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Spent {
    /// Wall time.
    pub time: Duration,
    /// Processor time; wall time where the system does not tell.
    pub work: Duration,
}

impl Spent {
    /// The cost since `start` of something whose processor time was not counted.
    pub fn since(start: Instant) -> Self {
        let time = start.elapsed();
        Self { time, work: time }
    }
}

/// Measures a process, lap by lap.
pub(super) struct Meter {
    pid: u32,
    since: Instant,
    before: Option<Duration>,
}

impl Meter {
    /// Starts with a process that has just started.
    pub(super) fn of(pid: u32) -> Self {
        Self { pid, since: Instant::now(), before: Some(Duration::ZERO) }
    }

    /// The cost since the last lap. Children count once the process has waited for them.
    pub(super) fn lap(&mut self) -> Spent {
        let time = self.since.elapsed();
        let now = used(self.pid);
        let work = now.zip(self.before).map_or(time, |(now, before)| now.saturating_sub(before));
        (self.since, self.before) = (Instant::now(), now);
        Spent { time, work }
    }
}

/// Processor time of this program and of all that it started and waited for; none where the system does not tell.
#[must_use]
pub fn processors() -> Option<Duration> {
    used(std::process::id())
}

/// Processor time of a process and of the children that it has waited for.
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
