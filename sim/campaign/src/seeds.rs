//! Ranges of seeds, and the shards that several machines share them by.
//!
//! Invariant: the shards of a range are disjoint, and together they are the range.

use std::ops::Range;

/// One of several parts of a range of seeds.
///
/// The seed `from + k` is in the shard `k mod count`, so that each shard has runs of the whole range.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shard {
    /// Number of the shard, from 1.
    pub number: u64,
    /// Number of shards.
    pub count: u64,
}

impl Shard {
    /// The whole range.
    pub const WHOLE: Self = Self { number: 1, count: 1 };

    /// Returns true if the shard has the seed.
    pub fn has(self, seeds: &Range<u64>, seed: u64) -> bool {
        seeds.contains(&seed) && (seed - seeds.start) % self.count == self.number - 1
    }

    /// Returns the seeds of the shard.
    pub fn of(self, seeds: &Range<u64>) -> impl Iterator<Item = u64> + use<> {
        let (start, end) = (seeds.start, seeds.end);
        let first = start.checked_add(self.number - 1);
        std::iter::successors(first, move |seed| seed.checked_add(self.count))
            .take_while(move |seed| *seed < end)
    }
}

/// Parses a shard.
///
/// # Errors
///
/// The message says how it is written.
///
/// ```
/// use bessemer_campaign::{Shard, shard};
///
/// assert_eq!(shard("2/3"), Ok(Shard { number: 2, count: 3 }));
/// assert!(shard("0/3").is_err());
/// let seeds: Vec<u64> = Shard { number: 2, count: 3 }.of(&(10..20)).collect();
/// assert_eq!(seeds, [11, 14, 17]);
/// ```
pub fn shard(text: &str) -> Result<Shard, String> {
    let wrong = || format!("`{text}` is not a shard; write it as 1/4 … 4/4");
    let (number, count) = text.split_once('/').ok_or_else(wrong)?;
    let parse = |text: &str| text.parse::<u64>().map_err(|_| wrong());
    let (number, count) = (parse(number)?, parse(count)?);
    if number >= 1 && number <= count { Ok(Shard { number, count }) } else { Err(wrong()) }
}

/// Parses a range of seeds, such as `0..1000`, without its end.
///
/// # Errors
///
/// The message says how it is written.
pub fn seeds(text: &str) -> Result<Range<u64>, String> {
    let wrong = || format!("`{text}` is not a range of seeds; write it as 0..1000");
    let (from, to) = text.split_once("..").ok_or_else(wrong)?;
    let number = |text: &str| text.replace('_', "").parse::<u64>().map_err(|_| wrong());
    let seeds = number(from)?..number(to)?;
    if seeds.start <= seeds.end { Ok(seeds) } else { Err(wrong()) }
}
