//! Longest path of each entry point on a target, beside the most instructions that a call took there.
//!
//! Invariant: a call that took more than its path fails the check, since the model is then wrong.

use bessemer_codegen::compile::{Compiled, Options};
use bessemer_dossier::content::{Outcome, Paths, grouped};
use bessemer_ir::FunctionId;
use bessemer_legs::longest::{self, Longest};
use bessemer_legs::toolchain::{GCC, Toolchain};
use bessemer_project::Project;

use super::checks::{FAILED, NOT_RUN, PASSED, first_error, try_out, version};
use super::known::Known;
use super::outcome;
use crate::error::Error;
use crate::verify::counted::Counter;
use crate::verify::search::Life;

/// Most instructions, by their bounds, of the recorded calls of one entry point: some minutes of emulation.
const BUDGET: u64 = 20_000_000_000;

/// Number of words of the calls that one program counts: 64 MB.
const MOST: usize = 8 << 20;
/// Number of changed lives of an entry point in a round.
const BATCH: usize = 16;
/// A search ends at an entry point whose bound is at most this many percent of the most that was counted.
const CLOSE: u64 = 125;

/// Counts calls. Returns their number, and the most instructions of each entry point, in their order.
///
/// Recorded calls of an entry point are counted until their bounds add up to [`BUDGET`].
fn counted(
    known: &Known<'_>,
    compiled: &Compiled,
    options: &Options,
    toolchain: &Toolchain,
    bounds: &[Longest],
) -> Result<(usize, Vec<u64>), Error> {
    let functions = &known.functions;
    let mut counter = Counter::build(compiled, options, functions, toolchain)?;
    let of_function = |id: &FunctionId| {
        let at = compiled.entries.iter().position(|it| it.function == *id)?;
        bounds.get(at)?.cost.as_ref().ok().map(|it| it.instructions.max(1))
    };
    let bounds: Vec<Option<u64>> = functions.iter().map(of_function).collect();
    counter.count(&known.lives)?;
    let mut rest: Vec<u64> = bounds.iter().map(|it| BUDGET / it.unwrap_or(BUDGET)).collect();
    let (mut lives, mut words) = (Vec::new(), 0);
    known.of_tests(compiled, |mut life| {
        let Some(rest) = rest.get_mut(life.target) else { return Ok(()) };
        life.calls.truncate(usize::try_from(*rest).unwrap_or(usize::MAX));
        *rest -= life.calls.len() as u64;
        words += life.calls.iter().map(Vec::len).sum::<usize>();
        lives.push(life);
        if words > MOST {
            counter.count(&std::mem::take(&mut lives))?;
            words = 0;
        }
        Ok(())
    })?;
    counter.count(&lives)?;
    lengthened(known, &mut counter, &bounds)?;
    let of = |id| functions.iter().position(|it| *it == id).map_or(0, |at| counter.most[at]);
    Ok((counter.calls, compiled.entries.iter().map(|it| of(it.function)).collect()))
}

/// Searches for longer calls of the entry points: changes lives, and keeps those with the most instructions so far.
fn lengthened(
    known: &Known<'_>,
    counter: &mut Counter,
    bounds: &[Option<u64>],
) -> Result<(), Error> {
    let mut search = known.search.clone();
    for _ in 0..known.rounds {
        let open = |at: &usize| bounds[*at].is_some_and(|it| 100 * it > CLOSE * counter.most[*at]);
        let open: Vec<usize> = (0..bounds.len()).filter(open).collect();
        let changed = |at: &usize| search.changed(*at).into_iter().take(BATCH).collect::<Vec<_>>();
        let lives: Vec<Life> = open.iter().flat_map(changed).collect();
        let before = counter.most.clone();
        let most = counter.count(&lives)?;
        for (life, most) in lives.iter().zip(most) {
            if most > before[life.target] {
                search.keep(life);
            }
        }
    }
    Ok(())
}

/// Finds the longest paths on a target that the model has, and counts calls where the emulator is installed.
pub fn paths(
    project: &Project,
    compiled: &Compiled,
    name: &str,
    toolchain: &Toolchain,
    known: &Known<'_>,
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
        Ok(()) => {
            counted(known, compiled, options, &toolchain, &list).map_err(|error| match error {
                Error::Compiler { said, .. } => (FAILED, first_error(&said).to_owned()),
                error => (FAILED, error.to_string()),
            })
        }
    };
    let most = counted.as_ref().map(|it| it.1.clone()).unwrap_or_default();
    let rows: Vec<Row> =
        list.iter().enumerate().map(|(at, it)| Row::of(it, most.get(at).copied())).collect();
    let bounds = rows.iter().filter(|it| it.bound.is_some()).count();
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
    let rows = rows.iter().map(Row::cells).collect();
    let paths = Paths { target: format!("{name}: {compiler}, -O2"), rows };
    (of(verdict, detail), Some(paths))
}

/// An entry point with its path and the most that was counted.
struct Row {
    entry: String,
    /// Instructions and cycles.
    bound: Option<longest::Cost>,
    /// The reason for no bound.
    why: String,
    /// Instructions; zero if no call was counted.
    most: u64,
}

impl Row {
    fn of(longest: &Longest, most: Option<u64>) -> Row {
        Row {
            entry: longest.entry.clone(),
            bound: longest.cost.as_ref().ok().copied(),
            why: longest.cost.as_ref().err().cloned().unwrap_or_default(),
            most: most.unwrap_or_default(),
        }
    }

    fn is_beyond(&self) -> bool {
        self.bound.is_some_and(|it| self.most > it.instructions)
    }

    /// Entry point, bound in instructions and in cycles, the most that was counted, and their ratio.
    fn cells(&self) -> [String; 5] {
        let (instructions, cycles) = match self.bound {
            Some(cost) => (grouped(cost.instructions), grouped(cost.cycles)),
            None => (self.why.clone(), String::new()),
        };
        let (most, ratio) = match (self.most, self.bound) {
            (0, _) => (String::new(), String::new()),
            (most, None) => (grouped(most), String::new()),
            (most, Some(cost)) => {
                (grouped(most), format!("{:.2}", cost.instructions as f64 / most as f64))
            }
        };
        [self.entry.clone(), instructions, cycles, most, ratio]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(most: u64) -> Row {
        let bound = Some(longest::Cost { instructions: 100, cycles: 250 });
        Row { entry: "motor_step".to_owned(), bound, why: String::new(), most }
    }

    #[test]
    fn a_call_beyond_its_path_is_found() {
        assert_eq!([row(100), row(101)].map(|it| it.is_beyond()), [false, true]);
        assert_eq!(row(80).cells(), ["motor_step", "100", "250", "80", "1.25"]);
        let none = Row { bound: None, why: "no bound".to_owned(), ..row(80) };
        assert_eq!(none.cells(), ["motor_step", "no bound", "", "80", ""]);
        assert!(!none.is_beyond());
        assert_eq!(row(0).cells()[3..], ["", ""]);
    }
}
