//! Measures what a test costs: wall time and processor time.
//!
//! Wall time includes waiting, for the lock on a target folder and for other tests. So processor time decides in which order
//! tests run, which ones a quick run leaves out, and which ones have grown.
//!
//! What it must not know: what a test is.

use std::time::{Duration, Instant};

/// Number of ticks in a second: Linux reports processor time in hundredths of a second.
const TICKS: u32 = 100;

/// The cost of a test or a stage.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Spent {
    /// Wall time.
    pub time: Duration,
    /// Processor time; wall time on systems that do not report it.
    pub work: Duration,
}

impl Spent {
    /// Returns the cost since `start`, with the wall time as its processor time.
    pub fn since(start: Instant) -> Self {
        let time = start.elapsed();
        Self { time, work: time }
    }
}

/// Measures a process in sections.
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

    /// Returns the cost since the last call. Child processes count when the process has waited for them.
    pub(super) fn lap(&mut self) -> Spent {
        let time = self.since.elapsed();
        let now = used(self.pid);
        let work = now.zip(self.before).map_or(time, |(now, before)| now.saturating_sub(before));
        (self.since, self.before) = (Instant::now(), now);
        Spent { time, work }
    }
}

/// Returns the processor time of this program and of all processes that it has waited for; `None` on systems that do
/// not report it.
#[must_use]
pub fn processors() -> Option<Duration> {
    used(std::process::id())
}

/// Returns the processor time of a process and of the children that it has waited for.
fn used(pid: u32) -> Option<Duration> {
    ticks(&std::fs::read_to_string(format!("/proc/{pid}/stat")).ok()?)
        .map(|ticks| Duration::from_secs(ticks) / TICKS)
}

/// Returns the sum of the ticks in a line of `/proc/PID/stat`: fields 14 to 17, counted from 1. The second field is
/// the name of the program in parentheses, which may itself contain spaces and parentheses.
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
