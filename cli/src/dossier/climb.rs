//! A search for longer calls that changes one word at a time, and joins the changes that made a call longer.
//!
//! It begins at the longest known calls of an entry point, and ends when no change helps or its budget of instructions is
//! spent. Only the last calls of a life are changed at first: those before them are counted once for many changes.
//!
//! Most of a bound is such calls: subnormal numbers where the processor has no double precision, large angles in front of
//! a remainder, states that an aircraft reaches after minutes.

use std::rc::Rc;

use bessemer_legs::longest::Numbers;

use crate::error::Error;
use crate::verify::counted::{Counter, LongestCall};
use crate::verify::search::{Life, Search, Step};

/// Number of early calls at which an ascent begins, and of later ones.
const BEGINNINGS: usize = 2;
/// Place of a call in its life from which it is a later one: a state that needs time is in no early one.
const LATER: usize = 16;
/// Numbers of last calls that are changed together. The last call is repeated to have that many: time passes, until a sensor
/// counts as lost.
const LAST: [usize; 3] = [1, 8, 40];
/// Instructions of the lives that are counted at once, as long as a start of the emulator.
const AT_ONCE: u64 = 20_000_000;
/// Number of words of the lives that are counted at once.
const MOST: usize = 2 << 20;

/// A long call, and those before it.
#[derive(Clone)]
struct Peak {
    /// Calls that are not changed, from the initial state; some may be of other functions.
    before: Rc<[Life]>,
    /// Calls that may be changed; the last one is the long one.
    life: Life,
    /// Instructions of the last call.
    instructions: u64,
}

impl Peak {
    fn of(before: Rc<[Life]>, mut life: Life, longest: LongestCall) -> Peak {
        life.calls.truncate(longest.at + 1);
        Peak { before, life, instructions: longest.instructions }
    }

    /// Returns the same calls, of which the last one may be changed.
    fn with_last(mut self) -> Peak {
        let first = self.life.calls.len().saturating_sub(1);
        let last = self.life.calls.split_off(first);
        let target = self.life.target;
        let earlier = std::mem::replace(&mut self.life, Life { target, calls: last });
        if !earlier.calls.is_empty() {
            self.before = self.before.iter().cloned().chain([earlier]).collect();
        }
        self
    }

    /// Returns the calls with repetitions of the last one, until so many may be changed.
    fn repeated(mut self, count: usize) -> Peak {
        let missing = count.saturating_sub(self.life.calls.len());
        let last = self.life.calls.last().cloned();
        self.life.calls.extend(last.into_iter().flat_map(|it| std::iter::repeat_n(it, missing)));
        self
    }
}

/// The longest calls that were seen of one entry point: the early ones, and the later ones. The longest is the first.
#[derive(Clone, Default)]
pub struct Peaks([Vec<Peak>; 2]);

impl Peaks {
    /// Notes a life that follows others, and its longest call.
    pub fn note(&mut self, before: &[Life], life: &Life, longest: LongestCall) {
        let place = before.iter().map(|it| it.calls.len()).sum::<usize>() + longest.at;
        let peaks = &mut self.0[usize::from(place >= LATER)];
        let known = |it: &Peak| it.instructions == longest.instructions;
        let full = peaks.len() == BEGINNINGS;
        if peaks.iter().any(known)
            || full && peaks.last().is_some_and(|it| it.instructions >= longest.instructions)
        {
            return;
        }
        peaks.push(Peak::of(before.into(), life.clone(), longest));
        peaks.sort_by_key(|it| std::cmp::Reverse(it.instructions));
        peaks.truncate(BEGINNINGS);
    }

    /// Returns the calls that lead to each long call, with it.
    pub fn lives(&self) -> impl Iterator<Item = Vec<Life>> {
        self.0.iter().flatten().map(|it| [&*it.before, std::slice::from_ref(&it.life)].concat())
    }
}

/// Searches for longer calls of an entry point with these numbers, and notes them. It ends at `enough` instructions of a
/// call, and when `budget` instructions are counted.
///
/// # Errors
/// The message of the emulator or the system.
pub fn climb(
    search: &mut Search<'_>,
    counter: &mut Counter,
    peaks: &mut Peaks,
    numbers: Numbers,
    [enough, budget]: [u64; 2],
) -> Result<(), Error> {
    let beginnings = peaks.0.concat();
    let each = budget / (beginnings.len() * (LAST.len() + 1)).max(1) as u64;
    for peak in beginnings {
        let mut ascent = Ascent { search, counter, left: 0, numbers };
        let whole = ascent.shortened(peak.clone())?;
        let mut peak = peak.with_last();
        for count in LAST {
            peak = ascent.ascend(peak.repeated(count), enough, each)?;
        }
        // Arguments of all calls, which are parameters of the component.
        let whole = ascent.ascend(whole, enough, each)?;
        for it in [peak, whole] {
            let at = it.life.calls.len().saturating_sub(1);
            peaks.note(&it.before, &it.life, LongestCall { instructions: it.instructions, at });
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
    /// Makes passes until none helps. Returns the longest call.
    fn ascend(&mut self, mut peak: Peak, enough: u64, budget: u64) -> Result<Peak, Error> {
        self.left = budget;
        while peak.instructions < enough {
            match self.pass(&peak)? {
                Some(higher) => peak = higher,
                None => break,
            }
        }
        Ok(peak)
    }

    /// Counts lives, and cuts each behind its longest call.
    fn count(&mut self, before: &Rc<[Life]>, lives: Vec<Life>) -> Result<Vec<Peak>, Error> {
        let found = self.counter.count_after(before, &lives)?;
        let longest = found.into_iter().map(|it| it.of(self.numbers));
        let of = |(longest, life)| Peak::of(Rc::clone(before), life, longest);
        Ok(longest.zip(lives).map(of).collect())
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
        let found = self.count(&peak.before, lives)?.into_iter().find(near);
        Ok(found.unwrap_or(peak))
    }

    /// Tries each change of one word, and joins those that helped. Returns none if none did.
    fn pass(&mut self, peak: &Peak) -> Result<Option<Peak>, Error> {
        let mut steps = self.search.steps(peak.life.target, self.numbers);
        if peak.life.calls.len() == 1 {
            steps.retain(|it| !it.all);
        }
        let mut peak = peak.clone();
        let first = peak.instructions;
        let mut rest = &steps[..];
        while !rest.is_empty() {
            let cost = peak.instructions.max(1) * peak.life.calls.len() as u64;
            let before: usize = peak.before.iter().map(|it| it.calls.len()).sum();
            let cost_before = peak.instructions * before as u64;
            if self.left < cost {
                break;
            }
            let words = peak.life.calls.iter().map(Vec::len).sum::<usize>();
            let most = (MOST / words.max(1)).min((self.left / cost) as usize);
            // The calls before are counted again with each group.
            let count = (AT_ONCE.max(cost_before) / cost) as usize;
            let (some, others) = rest.split_at(count.min(most).clamp(1, rest.len()));
            rest = others;
            self.left -= cost * some.len() as u64;
            let lives = some.iter().map(|it| self.search.stepped(&peak.life, &[*it])).collect();
            let found = self.count(&peak.before, lives)?;
            let counts = found.into_iter().map(|it| it.instructions);
            let chosen = chosen(counts.zip(some.iter().copied()), peak.instructions);
            peak = self.joined(&peak, &chosen)?.unwrap_or(peak);
        }
        Ok((peak.instructions > first).then_some(peak))
    }

    /// Joins the first one, two, four … changes. Returns the longest call if it is longer than before.
    fn joined(&mut self, peak: &Peak, steps: &[Step]) -> Result<Option<Peak>, Error> {
        if steps.is_empty() {
            return Ok(None);
        }
        let counts = std::iter::successors(Some(1), |it| Some(it * 2));
        let mut joined: Vec<usize> = counts.take_while(|it| *it < steps.len()).collect();
        joined.push(steps.len());
        let lives = joined.iter().map(|it| self.search.stepped(&peak.life, &steps[..*it]));
        let found = self.count(&peak.before, lives.collect())?;
        let best = found.into_iter().max_by_key(|it| it.instructions);
        Ok(best.filter(|it| it.instructions > peak.instructions))
    }
}

/// Returns the best change of each word that makes a call longer than `least`, the best first.
fn chosen(found: impl Iterator<Item = (u64, Step)>, least: u64) -> Vec<Step> {
    let mut better: Vec<(u64, Step)> = found.filter(|(count, _)| *count > least).collect();
    better.sort_by_key(|(count, _)| std::cmp::Reverse(*count));
    let mut chosen: Vec<Step> = Vec::new();
    for (_, step) in better {
        if !chosen.iter().any(|it| (it.argument, it.leaf) == (step.argument, step.leaf)) {
            chosen.push(step);
        }
    }
    chosen
}
