//! A search for longer calls that changes one word at a time, and joins the changes that made a call longer.
//!
//! It begins at the longest known calls of an entry point, and ends when no change helps or its budget of instructions is
//! spent. Most of a bound is such calls: subnormal numbers where the processor has no double precision, large angles in
//! front of a remainder.

use bessemer_legs::longest::Numbers;

use crate::error::Error;
use crate::verify::counted::{Counter, LongestCall};
use crate::verify::search::{Life, Search, Step};

/// Number of lives at which an ascent begins.
const BEGINNINGS: usize = 2;
/// Number of times that a last call is repeated: time passes, until a sensor counts as lost.
const REPEATS: usize = 40;
/// Instructions of the lives that are counted at once: some seconds.
const AT_ONCE: u64 = 1_000_000_000;
/// Number of words of the lives that are counted at once.
const MOST: usize = 2 << 20;

/// A life, and the instructions of its last call, which is its longest.
#[derive(Clone)]
struct Peak {
    life: Life,
    instructions: u64,
}

impl Peak {
    fn of(mut life: Life, longest: LongestCall) -> Peak {
        life.calls.truncate(longest.at + 1);
        Peak { life, instructions: longest.instructions }
    }
}

/// The longest calls that were seen of one entry point, the longest first.
#[derive(Clone, Default)]
pub struct Peaks(Vec<Peak>);

impl Peaks {
    /// Notes a life and its longest call.
    pub fn note(&mut self, life: &Life, longest: LongestCall) {
        let known = |it: &Peak| it.instructions == longest.instructions;
        let full = self.0.len() == BEGINNINGS;
        if self.0.iter().any(known)
            || full && self.0.last().is_some_and(|it| it.instructions >= longest.instructions)
        {
            return;
        }
        self.0.push(Peak::of(life.clone(), longest));
        self.0.sort_by_key(|it| std::cmp::Reverse(it.instructions));
        self.0.truncate(BEGINNINGS);
    }
}

/// Searches for longer calls of an entry point with these numbers. It ends at `enough` instructions of a call, and when
/// `budget` instructions are counted.
///
/// # Errors
/// The message of the emulator or the system.
pub fn climb(
    search: &mut Search<'_>,
    counter: &mut Counter,
    peaks: &Peaks,
    numbers: Numbers,
    [enough, budget]: [u64; 2],
) -> Result<(), Error> {
    for peak in &peaks.0 {
        let mut ascent = Ascent { search, counter, left: 0, numbers };
        let short = ascent.shortened(peak.clone())?;
        let mut longer = short.clone();
        let last = short.life.calls.last().cloned();
        longer.life.calls.extend(last.into_iter().flat_map(|it| std::iter::repeat_n(it, REPEATS)));
        for mut peak in [short, longer] {
            ascent.left = budget / (2 * BEGINNINGS as u64);
            while peak.instructions < enough {
                match ascent.pass(&peak)? {
                    Some(higher) => peak = higher,
                    None => break,
                }
            }
        }
    }
    Ok(())
}

struct Ascent<'a, 'm> {
    search: &'a mut Search<'m>,
    counter: &'a mut Counter,
    left: u64,
    numbers: Numbers,
}

impl Ascent<'_, '_> {
    /// Counts lives, and cuts each behind its longest call.
    fn count(&mut self, lives: Vec<Life>) -> Result<Vec<Peak>, Error> {
        let found = self.counter.count(&lives)?;
        let longest = found.into_iter().map(|it| it.of(self.numbers));
        Ok(longest.zip(lives).map(|(longest, life)| Peak::of(life, longest)).collect())
    }

    /// Returns a life with fewer calls before the longest one, which takes almost as long.
    fn shortened(&mut self, peak: Peak) -> Result<Peak, Error> {
        let all = &peak.life.calls;
        let cuts = std::iter::successors(Some(1), |it| Some(it * 2));
        let cut = |count: usize| Life {
            target: peak.life.target,
            calls: all[all.len() - count..].to_vec(),
        };
        let lives: Vec<Life> = cuts.take_while(|it| *it < all.len()).map(cut).collect();
        let near = |it: &Peak| 50 * it.instructions >= 49 * peak.instructions;
        let found = self.count(lives)?.into_iter().find(near);
        Ok(found.unwrap_or(peak))
    }

    /// Tries single changes, then joins those that helped; none if none did.
    fn pass(&mut self, peak: &Peak) -> Result<Option<Peak>, Error> {
        let cost = peak.instructions.max(1) * peak.life.calls.len() as u64;
        let mut steps = self.search.steps(peak.life.target, self.numbers);
        steps.truncate(usize::try_from(self.left / cost).unwrap_or(usize::MAX));
        self.left = self.left.saturating_sub(cost * steps.len() as u64);
        let words = peak.life.calls.iter().map(Vec::len).sum::<usize>();
        let at_once = (MOST / words.max(1)).min((AT_ONCE / cost) as usize).max(1);
        let mut better: Vec<(u64, Step)> = Vec::new();
        for some in steps.chunks(at_once) {
            let lives = some.iter().map(|it| self.search.stepped(&peak.life, &[*it])).collect();
            let counts = self.count(lives)?.into_iter().map(|it| it.instructions);
            better.extend(counts.zip(some.iter().copied()));
        }
        better.retain(|(count, _)| *count > peak.instructions);
        // The best change of each word; the first of equal ones.
        better.sort_by_key(|(count, _)| std::cmp::Reverse(*count));
        let mut chosen: Vec<Step> = Vec::new();
        for (_, step) in better {
            if !chosen.iter().any(|it| (it.argument, it.leaf) == (step.argument, step.leaf)) {
                chosen.push(step);
            }
        }
        if chosen.is_empty() {
            return Ok(None);
        }
        let counts = std::iter::successors(Some(1), |it| Some(it * 2));
        let mut joined: Vec<usize> = counts.take_while(|it| *it < chosen.len()).collect();
        joined.push(chosen.len());
        let lives = joined.iter().map(|it| self.search.stepped(&peak.life, &chosen[..*it]));
        let best = self.count(lives.collect())?.into_iter().max_by_key(|it| it.instructions);
        Ok(best.filter(|it| it.instructions > peak.instructions))
    }
}
