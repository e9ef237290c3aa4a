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
use crate::verify::search::{Life, Search, Step, Value};

/// Number of early calls at which an ascent begins, and of later ones.
const BEGINNINGS: usize = 2;
/// Place of a call in its life from which it is a later one: a state that needs time is in no early one.
const LATER: usize = 16;
/// Numbers of last calls of the best one that are changed together. The last call is repeated to have that many: time passes,
/// until a sensor counts as lost.
const LAST: [usize; 3] = [8, 40, 1];
/// Instructions of the lives that are counted at once: the next ones begin from the best of them.
const AT_ONCE: u64 = 10_000_000;
/// Instructions with which the program reads a word.
const OF_A_WORD: u64 = 200;

/// A long call, and those before it.
#[derive(Clone)]
pub struct Peak {
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

    /// Instructions of a program that makes the calls that may be changed.
    fn cost(&self) -> u64 {
        let words = self.life.calls.iter().map(Vec::len).sum::<usize>() as u64;
        self.instructions.max(1) * self.life.calls.len().max(1) as u64 + words * OF_A_WORD
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
        // Not looked at, or no call at all.
        if longest.instructions == 0 || life.calls.is_empty() {
            return;
        }
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

    /// Returns long calls with other numbers as beginnings: a change may give them these numbers.
    pub fn beginnings(&self, others: Option<&Peaks>) -> Vec<Peak> {
        let own = self.0.concat();
        let longest = own.iter().map(|it| it.instructions).max().unwrap_or_default();
        let others = others.into_iter().flat_map(|it| it.0.concat());
        // A call helps if it is longer than the longest one with these numbers.
        let others = others.map(|it| Peak { instructions: longest.max(1), ..it });
        own.iter().cloned().chain(others).collect()
    }

    /// Returns the structs of the longest call.
    pub fn values(&self, search: &Search<'_>) -> Vec<Value> {
        let longest = self.0.iter().flatten().max_by_key(|it| it.instructions);
        longest.map(|it| search.values(&it.life)).unwrap_or_default()
    }

    /// Returns the calls that lead to each long call, with it.
    pub fn lives(&self) -> impl Iterator<Item = Vec<Life>> {
        self.0.iter().flatten().map(|it| [&*it.before, std::slice::from_ref(&it.life)].concat())
    }
}

/// Searches for longer calls of an entry point with these numbers, and notes them. It ends at `enough` instructions of a
/// call, and when `budget` instructions are counted. Returns the rest of the budget.
///
/// # Errors
/// The message of the emulator or the system.
pub fn climb(
    search: &mut Search<'_>,
    counter: &mut Counter,
    (beginnings, peaks): (&[Peak], &mut Peaks),
    values: &[Value],
    numbers: Numbers,
    [enough, budget]: [u64; 2],
) -> Result<u64, Error> {
    let mut ascent = Ascent {
        search,
        counter,
        values,
        numbers,
        enough,
        left: budget,
        end: 0,
        helped: Vec::new(),
    };
    // Most of the budget is for the best of them.
    let mut shares = (beginnings.len() + LAST.len() + 1) as u64;
    let mut best: Option<(Peak, Peak)> = None;
    for whole in beginnings.iter().cloned() {
        let peak = ascent.ascend(whole.clone().with_last(), shares)?;
        shares -= 1;
        if best.as_ref().is_none_or(|it| it.0.instructions < peak.instructions) {
            best = Some((peak, whole));
        }
    }
    let Some((mut peak, whole)) = best else { return Ok(budget) };
    let whole = ascent.shortened(whole)?;
    // Arguments of all calls, which are parameters of the component.
    let whole = ascent.ascend(whole, shares)?;
    for count in LAST {
        shares -= 1;
        peak = ascent.ascend(peak.with_last().repeated(count), shares)?;
    }
    for it in [peak, whole] {
        let at = it.life.calls.len().saturating_sub(1);
        peaks.note(&it.before, &it.life, LongestCall { instructions: it.instructions, at });
    }
    Ok(ascent.left)
}

struct Ascent<'a, 'm> {
    search: &'a mut Search<'m>,
    counter: &'a mut Counter,
    /// Structs of long calls of other functions.
    values: &'a [Value],
    numbers: Numbers,
    /// Instructions of a call at which the search ends.
    enough: u64,
    /// Instructions that may still be counted.
    left: u64,
    /// The rest that is for later ascents.
    end: u64,
    /// Changes that made a call longer, the latest first: they often help elsewhere, too.
    helped: Vec<Step>,
}

impl Ascent<'_, '_> {
    /// Makes passes until none helps, or until its share of the rest is spent, one of `shares`. Returns the longest call.
    fn ascend(&mut self, mut peak: Peak, shares: u64) -> Result<Peak, Error> {
        self.end = self.left - self.left / shares.max(1);
        while peak.instructions < self.enough {
            match self.pass(&peak)? {
                Some(higher) => peak = higher,
                None => break,
            }
        }
        Ok(peak)
    }

    /// Counts lives, and cuts each behind its longest call. One of at most `floor` instructions may have none.
    fn count(
        &mut self,
        before: &Rc<[Life]>,
        lives: Vec<Life>,
        floor: u64,
    ) -> Result<Vec<Peak>, Error> {
        let floor = match self.numbers {
            Numbers::Any => u64::MAX,
            Numbers::Normal => floor,
        };
        let found = self.counter.count_after(before, &lives, floor)?;
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
        let found = self.count(&peak.before, lives, 0)?.into_iter().find(near);
        Ok(found.unwrap_or(peak))
    }

    /// Tries each change of one word, and joins those that helped. Returns none if none did.
    fn pass(&mut self, peak: &Peak) -> Result<Option<Peak>, Error> {
        let mut steps = self.search.steps(peak.life.target, self.numbers, self.values);
        if peak.life.calls.len() == 1 {
            steps.retain(|it| !it.all);
        }
        let place = |step: &Step| self.helped.iter().position(|it| it == step);
        steps.sort_by_cached_key(|step| place(step).unwrap_or(usize::MAX));
        let mut peak = peak.clone();
        let first = peak.instructions;
        let mut rest = &steps[..];
        while !rest.is_empty() {
            let cost = peak.cost();
            let left = self.left - self.end;
            if left < cost {
                break;
            }
            let most = (AT_ONCE.min(left) / cost) as usize;
            let (some, others) = rest.split_at(most.clamp(1, rest.len()));
            rest = others;
            self.left -= cost * some.len() as u64;
            let lives = some
                .iter()
                .map(|it| self.search.stepped(&peak.life, std::slice::from_ref(it)))
                .collect();
            let found = self.count(&peak.before, lives, peak.instructions)?;
            let counts = found.into_iter().map(|it| it.instructions);
            let chosen = chosen(counts.zip(some.iter().cloned()), peak.instructions);
            if let Some(longer) = self.joined(&peak, &chosen)? {
                self.helped.retain(|it| !chosen.contains(it));
                self.helped.splice(0..0, chosen);
                peak = longer;
            }
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
        let found = self.count(&peak.before, lives.collect(), peak.instructions)?;
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
