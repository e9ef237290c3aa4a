//! Wall-clock times of stages and processor times of tests: the slowest, and those that grew since a stored run.
//!
//! A machine may be faster or busier than the one of the stored run. So what is compared is each part's time over
//! its stored time, beside the median of these ratios.
//!
//! What it must not know: what a part does.

use super::Done;
use std::collections::BTreeMap;
use std::time::Duration;

/// Growth limit: a part has grown if its ratio to the stored time exceeds the median ratio by this factor.
const GROWTH: f64 = 4.0 / 3.0;

/// Growth limit of the whole run's processor time.
const GROWTH_OF_ALL: f64 = 1.1;

/// Duration below which times vary too much to be compared.
const SHORT: Duration = Duration::from_secs(4);

/// Shortest time that is stored.
const STORED: Duration = Duration::from_millis(300);

/// Times by the name of a stage or a test.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Times(BTreeMap<String, Duration>);

impl Times {
    /// Parses `name<TAB>seconds` lines; other lines are ignored.
    #[must_use]
    pub fn read(text: &str) -> Self {
        let line = |line: &str| {
            let (name, seconds) = line.split_once('\t')?;
            Some((name.to_owned(), Duration::try_from_secs_f64(seconds.trim().parse().ok()?).ok()?))
        };
        Self(text.lines().filter_map(line).collect())
    }

    /// Formats the times of at least [`STORED`] as lines for [`read`](Self::read).
    #[must_use]
    pub fn text(&self) -> String {
        let long = self.0.iter().filter(|(_, time)| **time >= STORED);
        long.map(|(name, time)| format!("{name}\t{:.1}\n", time.as_secs_f64())).collect()
    }

    /// Adds the time of a part.
    pub fn add(&mut self, name: &str, time: Duration) {
        self.0.insert(name.to_owned(), time);
    }

    /// Returns the time of a part; zero if it is not known.
    #[must_use]
    pub fn of(&self, name: &str) -> Duration {
        self.0.get(name).copied().unwrap_or_default()
    }

    /// Returns the ratio of a part's time to its stored time, if it grew by a tenth or more.
    #[must_use]
    pub fn grown_as_a_whole(&self, stored: &Self, name: &str) -> Option<f64> {
        let (before, now) = (stored.of(name), self.of(name));
        let ratio = now.as_secs_f64() / before.as_secs_f64();
        (before >= SHORT && ratio >= GROWTH_OF_ALL).then_some(ratio)
    }

    /// Returns the parts that grew by a third compared with `stored`, and their growth.
    #[must_use]
    pub fn grown(&self, stored: &Self) -> Vec<(String, f64)> {
        let ratio = |(name, time): (&String, &Duration)| {
            let before = stored.of(name);
            let compared = before >= SHORT && *time >= SHORT;
            compared.then(|| (name.clone(), time.as_secs_f64() / before.as_secs_f64()))
        };
        let mut ratios: Vec<_> = self.0.iter().filter_map(ratio).collect();
        ratios.sort_by(|a, b| a.1.total_cmp(&b.1));
        let Some(median) = ratios.get(ratios.len() / 2).map(|it| it.1) else { return Vec::new() };
        ratios.retain(|(_, ratio)| *ratio > GROWTH * median);
        ratios.iter_mut().for_each(|(_, ratio)| *ratio /= median);
        ratios
    }
}

/// Returns the tests with the most processor time.
#[must_use]
pub fn slowest(done: &[Done], count: usize) -> Vec<&Done> {
    let mut list: Vec<&Done> = done.iter().collect();
    list.sort_by(|a, b| b.spent.work.cmp(&a.spent.work).then(a.title.cmp(&b.title)));
    list.truncate(count);
    list
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::runner::Spent;

    fn times(list: &[(&str, u64)]) -> Times {
        let mut times = Times::default();
        list.iter().for_each(|(name, seconds)| times.add(name, Duration::from_secs(*seconds)));
        times
    }

    #[test]
    fn what_is_written_is_read() {
        let stored = times(&[("lints", 70), ("corpus::the_c_agrees", 120)]);
        assert_eq!(Times::read(&stored.text()), stored);
        assert_eq!(Times::read("# a remark\nlints\tno number\n"), Times::default());
    }

    #[test]
    fn a_slower_machine_lets_nothing_grow_but_a_part_does() {
        let stored = times(&[("a", 10), ("b", 20), ("c", 30), ("short", 1)]);
        let slower = times(&[("a", 20), ("b", 40), ("c", 60), ("short", 9)]);
        assert_eq!(slower.grown(&stored), []);
        let grown = times(&[("a", 20), ("b", 40), ("c", 90), ("short", 9)]).grown(&stored);
        assert_eq!(grown, [("c".to_owned(), 1.5)]);
    }

    #[test]
    fn a_whole_that_grew_by_a_tenth_is_told() {
        let grown = |before, now| {
            let [stored, times] = [before, now].map(|seconds| times(&[("all", seconds)]));
            times.grown_as_a_whole(&stored, "all")
        };
        assert_eq!(grown(100, 109), None);
        assert_eq!(grown(100, 110), Some(1.1));
        assert_eq!(grown(100, 50), None);
        assert_eq!(grown(0, 100), None, "nothing is stored");
    }

    #[test]
    fn the_slowest_come_first() {
        let done = |title: &str, seconds| Done {
            title: title.to_owned(),
            passed: true,
            spent: Spent { work: Duration::from_secs(seconds), ..Spent::default() },
        };
        let list = [done("a", 1), done("b", 3), done("c", 2)];
        let titles: Vec<_> = slowest(&list, 2).iter().map(|it| it.title.as_str()).collect();
        assert_eq!(titles, ["b", "c"]);
    }
}
