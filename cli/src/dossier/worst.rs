//! Longest path of each entry point on a target, beside the most instructions that a call took there.
//!
//! Invariant: a call that took more than its path fails the check, since the model is then wrong.

use std::sync::mpsc::{self, Receiver, Sender};

use bessemer_codegen::compile::{Compiled, Options};
use bessemer_dossier::content::{Outcome, Paths, grouped};
use bessemer_ir::FunctionId;
use bessemer_legs::longest::{self, Cost, Longest, Numbers};
use bessemer_legs::toolchain::{GCC, Toolchain};
use bessemer_project::Project;

use super::checks::{FAILED, NOT_RUN, PASSED, first_error, try_out, version};
use super::climb::{Peaks, climb};
use super::known::Known;
use super::{joined, outcome};
use crate::error::Error;
use crate::verify::counted::{Both, Counter, Row};
use crate::verify::search::{Life, Search, Value};

/// Most instructions, by their bounds, of the recorded calls of one entry point: some minutes of emulation.
const BUDGET: u64 = 20_000_000_000;

/// Instructions that are counted to climb at one entry point, for each round of the search.
const CLIMB: u64 = 300_000_000;
/// Number of climbs from the same calls: each in another order, which decides where it ends.
const CLIMBS: u64 = 3;
/// [`CLIMB`] with subnormal numbers, of which no bound is near.
const CLIMB_SUBNORMAL: u64 = 1_500_000;

/// Number of words of the calls that are counted at once.
const MOST: usize = 1 << 18;
/// Number of changed lives of an entry point in a round, and of made lives of a function that others follow.
const BATCH: usize = 16;
/// A search ends at an entry point whose bound is at most this many percent of the most that was counted.
const CLOSE: u64 = 150;

/// Long calls, from one target to another. Each is lives behind one another, the last with the call.
///
/// A call that is long on one target is often long on another, and a search is faster where doubles are in hardware.
enum Exchange {
    /// To the targets that wait.
    Sends(Sender<Vec<Vec<Life>>>),
    /// From all targets that send.
    Waits(Receiver<Vec<Vec<Life>>>),
}

/// Counts calls. Returns their number, and the most instructions of each entry point, in their order.
///
/// Recorded calls of an entry point are counted until their bounds add up to [`BUDGET`].
fn counted(
    known: &Known<'_>,
    compiled: &Compiled,
    options: &Options,
    toolchain: &Toolchain,
    bounds: &[Longest],
    exchange: Option<Exchange>,
) -> Result<(usize, Vec<Both>), Error> {
    let functions = &known.functions;
    let mut counter = Counter::build(compiled, options, functions, toolchain)?;
    let of_function = |id: &FunctionId| {
        let at = compiled.entries.iter().position(|it| it.function == *id)?;
        bounds.get(at)
    };
    let of = |numbers: Numbers| -> Vec<Option<u64>> {
        let of_numbers = |it: &Longest| bound(it, numbers).map(|it| it.instructions.max(1));
        functions.iter().map(|id| of_function(id).and_then(of_numbers)).collect()
    };
    // Subnormal numbers are no slower in hardware, and a call with them says little about other targets.
    let mut ascents = vec![Ascents::new(Numbers::Normal, of(Numbers::Normal))];
    if longest::has_slow_numbers(toolchain) {
        ascents.insert(0, Ascents::new(Numbers::Any, of(Numbers::Any)));
    }
    let bounds = of(Numbers::Any);
    let mut count = |counter: &mut Counter, lives: Vec<Life>| -> Result<(), Error> {
        of_rows(&lives.into_iter().map(|it| vec![it]).collect::<Vec<Row>>(), counter, &mut ascents)
    };
    count(&mut counter, known.lives.clone())?;
    let mut rest: Vec<u64> = bounds.iter().map(|it| BUDGET / it.unwrap_or(BUDGET)).collect();
    let (mut lives, mut words) = (Vec::new(), 0);
    known.of_tests(compiled, |mut life| {
        let Some(rest) = rest.get_mut(life.target) else { return Ok(()) };
        life.calls.truncate(usize::try_from(*rest).unwrap_or(usize::MAX));
        *rest -= life.calls.len() as u64;
        if life.calls.is_empty() {
            return Ok(());
        }
        words += life.calls.iter().map(Vec::len).sum::<usize>();
        lives.push(life);
        if words > MOST {
            count(&mut counter, std::mem::take(&mut lives))?;
            words = 0;
        }
        Ok(())
    })?;
    count(&mut counter, lives)?;
    lengthened(known, &mut counter, &mut ascents, exchange)?;
    let of = |id| {
        functions.iter().position(|it| *it == id).map_or(Both::default(), |at| counter.most[at])
    };
    Ok((counter.calls, compiled.entries.iter().map(|it| of(it.function)).collect()))
}

fn bound(longest: &Longest, numbers: Numbers) -> Option<Cost> {
    let cost = match numbers {
        Numbers::Any => &longest.cost,
        Numbers::Normal => &longest.normal,
    };
    cost.as_ref().ok().copied()
}

/// The search for longer calls with these numbers.
struct Ascents {
    numbers: Numbers,
    /// Instructions of each function.
    bounds: Vec<Option<u64>>,
    peaks: Vec<Peaks>,
}

impl Ascents {
    fn new(numbers: Numbers, bounds: Vec<Option<u64>>) -> Ascents {
        let peaks = vec![Peaks::default(); bounds.len()];
        Ascents { numbers, bounds, peaks }
    }

    fn note(&mut self, before: &[Life], life: &Life, both: Both) {
        self.peaks[life.target].note(before, life, both.of(self.numbers));
    }

    /// True if the bound of a function is far above the most that was counted.
    fn is_open(&self, counter: &Counter, at: usize) -> bool {
        let most = counter.most[at].of(self.numbers).instructions;
        self.bounds[at].is_some_and(|it| 100 * it > CLOSE * most)
    }
}

/// Searches for longer calls of the entry points: changes lives, and keeps those with the most instructions so far. Then it
/// climbs from the longest ones.
fn lengthened(
    known: &Known<'_>,
    counter: &mut Counter,
    ascents: &mut [Ascents],
    exchange: Option<Exchange>,
) -> Result<(), Error> {
    let mut search = known.search.clone();
    for _ in 0..known.rounds {
        let open = |at: &usize| ascents.iter().any(|it| it.is_open(counter, *at));
        let open: Vec<usize> = (0..counter.most.len()).filter(open).collect();
        let changed = |at: &usize| search.changed(*at).into_iter().take(BATCH).collect::<Vec<_>>();
        let rows: Vec<Row> = open.iter().flat_map(changed).map(|it| vec![it]).collect();
        let before = counter.most.clone();
        for (life, both) in rows.iter().flatten().zip(counter.count(&rows)?) {
            let before = before[life.target];
            let longer = ascents
                .iter()
                .any(|it| both.of(it.numbers).instructions > before.of(it.numbers).instructions);
            if longer {
                search.keep(life);
            }
            ascents.iter_mut().for_each(|it| it.note(&[], life, both));
        }
    }
    after_others(known, &search, counter, ascents)?;
    let longest = match exchange {
        Some(Exchange::Sends(longest)) => Some(longest),
        Some(Exchange::Waits(others)) => {
            for rows in others {
                of_rows(&rows, counter, ascents)?;
            }
            None
        }
        None => None,
    };
    climbed(known, &mut search, counter, ascents)?;
    if let Some(longest) = longest {
        let of = |it: &Ascents| it.peaks.iter().flat_map(Peaks::lives).collect::<Vec<_>>();
        // Nobody waits where no other target is installed.
        let _ = longest.send(ascents.iter().flat_map(of).collect());
    }
    Ok(())
}

/// Climbs at each entry point whose bound is far above the most that was counted.
fn climbed(
    known: &Known<'_>,
    search: &mut Search<'_>,
    counter: &mut Counter,
    ascents: &mut [Ascents],
) -> Result<(), Error> {
    let soft = ascents.len() > 1;
    let mut others: Option<Vec<Peaks>> = None;
    for it in ascents.iter_mut() {
        let mut open: Vec<(u64, usize)> = (0..it.bounds.len())
            .filter(|at| it.is_open(counter, *at))
            .filter_map(|at| Some((it.bounds[at]?, at)))
            .collect();
        // Long calls have more words to change, and get what short ones leave.
        open.sort_unstable();
        let budget = match (soft, it.numbers) {
            (true, Numbers::Any) => CLIMB_SUBNORMAL,
            _ => CLIMB,
        };
        let mut left = known.rounds.saturating_mul(budget).saturating_mul(open.len() as u64);
        let mut all: u64 = open.iter().map(|it| it.0).sum();
        for (bound, at) in open {
            let mut share = (u128::from(left) * u128::from(bound) / u128::from(all.max(1))) as u64;
            all -= bound;
            left -= share;
            let values: Vec<Value> = it.peaks.iter().flat_map(|it| it.values(search)).collect();
            let others = others.as_ref().and_then(|it| it.get(at));
            let beginnings = it.peaks[at].beginnings(others);
            for rest in (1..=CLIMBS).rev() {
                let ends = [100 * bound / CLOSE, share / rest];
                let peaks = &mut it.peaks[at];
                share -= ends[1];
                share += climb(search, counter, (&beginnings, peaks), &values, it.numbers, ends)?;
                if !it.is_open(counter, at) {
                    break;
                }
            }
            left += share;
        }
        others = Some(it.peaks.clone());
    }
    Ok(())
}

/// Counts rows of lives: those of another target, or made ones.
fn of_rows(rows: &[Row], counter: &mut Counter, ascents: &mut [Ascents]) -> Result<(), Error> {
    for (row, both) in rows.iter().zip(counter.count(rows)?) {
        let Some((life, before)) = row.split_last() else { continue };
        ascents.iter_mut().for_each(|it| it.note(before, life, both));
    }
    Ok(())
}

/// Counts made calls behind those of the component's other functions: behind the longest ones, behind made ones, and behind
/// two of them.
fn after_others(
    known: &Known<'_>,
    search: &Search<'_>,
    counter: &mut Counter,
    ascents: &mut [Ascents],
) -> Result<(), Error> {
    let made = |at: usize| {
        let all: Vec<&Life> = known.lives.iter().filter(|it| it.target == at).collect();
        let step = all.len().div_ceil(BATCH).max(1);
        all.into_iter().step_by(step).cloned().collect::<Vec<Life>>()
    };
    for at in 0..counter.most.len() {
        let open: Vec<&Ascents> = ascents.iter().filter(|it| it.is_open(counter, at)).collect();
        if open.is_empty() {
            continue;
        }
        let mut states: Vec<Vec<Life>> = Vec::new();
        let others = search.others(at);
        for other in &others {
            states.extend(made(*other).into_iter().map(|it| vec![it]));
            states.extend(open.iter().flat_map(|it| it.peaks[*other].lives()));
            for next in others.iter().filter(|it| *it != other) {
                states.extend(made(*other).into_iter().zip(made(*next)).map(|(a, b)| vec![a, b]));
            }
        }
        let lives = made(at);
        for before in states.chunks(BATCH) {
            let behind = |life: &Life| {
                let row = |it: &Vec<Life>| [&**it, std::slice::from_ref(life)].concat();
                before.iter().map(row).collect::<Vec<_>>()
            };
            let rows: Vec<Vec<Life>> = lives.iter().flat_map(behind).collect();
            of_rows(&rows, counter, ascents)?;
        }
    }
    Ok(())
}

/// Finds the longest paths on the targets that the model has, and counts calls where the emulator is installed.
pub fn on_all(
    project: &Project,
    compiled: &Compiled,
    targets: &[(&'static str, Toolchain)],
    known: &Known<'_>,
) -> Vec<(Outcome, Option<Paths>)> {
    let (sender, receiver) = mpsc::channel();
    let mut receiver = Some(receiver);
    let mut runs = Vec::new();
    for (name, toolchain) in targets.iter().filter(|it| longest::processor(&it.1).is_some()) {
        let exchange = match longest::has_slow_numbers(toolchain) {
            true => receiver.take().map(Exchange::Waits),
            false => Some(Exchange::Sends(sender.clone())),
        };
        runs.push(move || paths(project, compiled, name, toolchain, known, exchange));
    }
    // Who waits is done when all that send have ended.
    drop(sender);
    std::thread::scope(|scope| {
        let runs: Vec<_> = runs.into_iter().map(|it| scope.spawn(it)).collect();
        runs.into_iter().map(joined).collect()
    })
}

fn paths(
    project: &Project,
    compiled: &Compiled,
    name: &str,
    toolchain: &Toolchain,
    known: &Known<'_>,
    exchange: Option<Exchange>,
) -> (Outcome, Option<Paths>) {
    let (what, compiler) = (format!("Longest paths on {name}"), version(toolchain.compiler));
    let command = format!("cargo bessemer verify --target {name}");
    let of = |verdict, detail| outcome(&what, &command, compiler.clone(), verdict, detail);
    if let Err(why) = try_out(toolchain) {
        return (of(NOT_RUN, why), None);
    }
    let toolchain = toolchain.clone().of(project.settings.options.standard);
    let list = match longest::longest(compiled, &toolchain) {
        Ok(list) => list.unwrap_or_default(),
        Err(said) => return (of(FAILED, first_error(&said).to_owned()), None),
    };
    let options = &project.settings.options;
    let programs = [toolchain.programs(), GCC.programs()].concat();
    let counted = match bessemer_tools::check(&programs) {
        Err(missing) => Err((PASSED, missing.to_string())),
        // Its paths are those of another C than the one without the firmware's function.
        Ok(()) if options.hook.is_some() => {
            Err((PASSED, "the C calls the firmware's own function at a fault".to_owned()))
        }
        Ok(()) => counted(known, compiled, options, &toolchain, &list, exchange).map_err(|error| {
            match error {
                Error::Compiler { said, .. } => (FAILED, first_error(&said).to_owned()),
                error => (FAILED, error.to_string()),
            }
        }),
    };
    let most = counted.as_ref().map(|it| it.1.clone()).unwrap_or_default();
    let rows: Vec<Line> =
        list.iter().enumerate().map(|(at, it)| Line::of(it, most.get(at).copied())).collect();
    let bounds = rows.iter().filter(|it| it.any.bound.is_some()).count();
    let mut detail = format!("{bounds} of {} entry points have a bound", rows.len());
    let mut verdict = PASSED;
    match counted {
        Err((without, why)) => {
            verdict = without;
            detail += &format!("; no calls were counted: {why}");
        }
        Ok((calls, _)) => {
            let beyond: Vec<&str> =
                rows.iter().filter(|it| it.is_beyond()).map(|it| it.entry.as_str()).collect();
            detail += &format!("; {} calls were counted, ", grouped(calls as u64));
            detail += &match beyond.len() {
                0 => "none beyond its bound".to_owned(),
                _ => format!("beyond its bound: {}", beyond.join(", ")),
            };
            if !beyond.is_empty() {
                verdict = FAILED;
            }
        }
    }
    let rows = rows.iter().map(Line::cells).collect();
    let target = format!("{name}: {compiler}, -O2");
    let paths = Paths { target, rows, has_normal: longest::has_slow_numbers(&toolchain) };
    (of(verdict, detail), Some(paths))
}

/// An entry point with its path and the most that was counted.
struct Line {
    entry: String,
    any: Pair,
    normal: Pair,
    /// The reason for no bound.
    why: String,
}

/// A bound, and the most that was counted.
#[derive(Clone, Copy)]
struct Pair {
    bound: Option<Cost>,
    /// Instructions; zero if no call was counted.
    most: u64,
}

impl Pair {
    fn is_beyond(&self) -> bool {
        self.bound.is_some_and(|it| self.most > it.instructions)
    }

    /// The most that was counted, and the ratio of the bound to it.
    fn cells(&self) -> [String; 2] {
        let most = if self.most == 0 { String::new() } else { grouped(self.most) };
        let ratio = self.bound.filter(|_| self.most > 0).map_or_else(String::new, |it| {
            format!("{:.2}", it.instructions as f64 / self.most as f64)
        });
        [most, ratio]
    }
}

impl Line {
    fn of(longest: &Longest, most: Option<Both>) -> Line {
        let pair = |numbers| Pair {
            bound: bound(longest, numbers),
            most: most.map_or(0, |it| it.of(numbers).instructions),
        };
        Line {
            entry: longest.entry.clone(),
            any: pair(Numbers::Any),
            normal: pair(Numbers::Normal),
            why: longest.cost.as_ref().err().cloned().unwrap_or_default(),
        }
    }

    fn is_beyond(&self) -> bool {
        self.any.is_beyond() || self.normal.is_beyond()
    }

    /// Returns a row of [`Paths`].
    fn cells(&self) -> [String; 8] {
        let (instructions, cycles) = match self.any.bound {
            Some(cost) => (grouped(cost.instructions), grouped(cost.cycles)),
            None => (self.why.clone(), String::new()),
        };
        let [most, ratio] = self.any.cells();
        let normal = self.normal.bound.map_or_else(String::new, |it| grouped(it.instructions));
        let [most_normal, ratio_normal] = self.normal.cells();
        [self.entry.clone(), instructions, cycles, most, ratio, normal, most_normal, ratio_normal]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(most: u64) -> Line {
        let any = Pair { bound: Some(Cost { instructions: 100, cycles: 250 }), most };
        let normal = Pair { bound: Some(Cost { instructions: 50, cycles: 100 }), most: 40 };
        Line { entry: "motor_step".to_owned(), any, normal, why: String::new() }
    }

    #[test]
    fn a_call_beyond_its_path_is_found() {
        assert_eq!([row(100), row(101)].map(|it| it.is_beyond()), [false, true]);
        assert_eq!(row(80).cells(), ["motor_step", "100", "250", "80", "1.25", "50", "40", "1.25"]);
        let mut normal = row(80);
        normal.normal.most = 51;
        assert!(normal.is_beyond());
        let pair = |most| Pair { bound: None, most };
        let none = Line { any: pair(80), normal: pair(0), why: "no bound".to_owned(), ..row(80) };
        assert_eq!(none.cells(), ["motor_step", "no bound", "", "80", "", "", "", ""]);
        assert!(!none.is_beyond());
        assert_eq!(row(0).cells()[3..5], ["", ""]);
    }
}
