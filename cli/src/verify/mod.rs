//! `cargo bessemer verify`: calls each entry point on each leg and compares the words of Rust, interpreter and C.
//!
//! Inputs are edge values, sequences of small numbers, and sequences around the constants of the code.
//!
//! Invariant: the output names missing legs, entry points that were not called, and lines that no call executed.

mod board;
pub(crate) mod counted;
pub(crate) mod covered;
mod emulated;
mod lines;
pub(crate) mod lives;
mod native;
mod outputs;
mod parts;
pub mod recording;
pub(crate) mod sanitized;
pub(crate) mod search;

use std::fmt::Write as _;
use std::path::Path;
use std::process::{Command, Stdio};

use bessemer_backend::c::CFile;
use bessemer_backend::c::names::FAULTS;
use bessemer_codegen::compile::{Compiled, Options};
use bessemer_codegen::generate::{self, Program};
use bessemer_interpret::{Interpreter, Stop};
use bessemer_ir::{Fault, Function, FunctionId, Mode, Module, Type};
use bessemer_legs::arguments::{Numbers, Size, words};
use bessemer_legs::entries::{self, all, can_call, initial, named};
use bessemer_legs::outcome::{self, Outcome};
use bessemer_legs::random::Random;
use bessemer_legs::toolchain::{self, Toolchain};
use bessemer_legs::{harness, process};
use bessemer_project::Project;
use parts::parted;
use recording::flight::Mapping;

pub(crate) use emulated::machine;

use crate::args::Verify;
use crate::error::Error;

/// Number of calls of each entry point with edge values, in a sequence of small numbers, and in sequences around the
/// constants of its code.
const CALLS: usize = 100;
/// Number of calls in one sequence around the constants. A sequence is short, since a component that faults stays in
/// the fault state.
const LIFE: usize = 20;

/// An entry point, and what the interpreter makes of each call.
struct Case {
    id: FunctionId,
    name: String,
    /// Types of the result, the component and the changed arguments.
    types: Vec<Type>,
    leaves: Vec<Type>,
    /// The words of each argument.
    calls: Vec<Vec<Vec<u64>>>,
    expected: Vec<Outcome>,
    /// The lines that no call ran.
    never: String,
}

/// Compares the legs; the table of what was seen, and whether they agree.
///
/// # Errors
/// Errors of the models or the system; [`Error::NoCompiler`] if there is no leg of C.
pub fn run(folder: &Path, wanted: &Verify, colour: bool) -> Result<(String, bool), Error> {
    compared(folder, wanted, colour, |project, compiled| match &wanted.inputs {
        Some(path) => recorded(project, compiled, path, wanted.entry.as_deref()),
        None => Ok(Inputs::Made { seed: wanted.seed }),
    })
}

/// Verifies one entry point with these inputs: for each call of its sequence, the words of all arguments except the
/// component.
///
/// # Errors
/// Errors of the models or the system; [`Error::Words`] if the inputs are not what the entry point takes.
pub fn with_words(
    folder: &Path,
    wanted: &Verify,
    calls: &[Vec<u64>],
) -> Result<(String, bool), Error> {
    compared(folder, wanted, false, |_, compiled| {
        let entry = chosen(compiled, wanted.entry.as_deref())?;
        let calls = parted(&compiled.module, entry, calls)?;
        Ok(Inputs::Recorded { entry, calls, notes: Vec::new() })
    })
}

fn compared(
    folder: &Path,
    wanted: &Verify,
    colour: bool,
    inputs: impl FnOnce(&Project, &Compiled) -> Result<Inputs, Error>,
) -> Result<(String, bool), Error> {
    let project = Project::find(folder, wanted.package.name(), colour)?;
    let mut job = project.job(colour);
    // Before a build of a minute, the programs that it would be in vain without.
    let standard = job.options.standard;
    let compilers = toolchain::host();
    if compilers.is_empty() && wanted.board.is_none() {
        return Err(Error::NoCompiler);
    }
    let targets = wanted.target.iter().map(|target| emulated::processor(*target, standard));
    let targets = targets.collect::<Result<Vec<_>, _>>()?;
    // What calls the firmware's own function at a fault does not come back to tell of it.
    let hooked = job.options.hook.take().is_some();
    let compiled = generate::compiled(&job).map_err(bessemer_project::Error::from)?.compiled;
    if let Some(folder) = &wanted.board {
        return Ok((board::write(&compiled, &job.options, folder)?, true));
    }
    let module = &compiled.module;
    let inputs = inputs(&project, &compiled)?;
    let mut cases = cases(module, &inputs);
    if let (Some(path), Some(case)) = (&wanted.outputs, cases.first()) {
        let failed = |source| Error::File { path: path.clone(), source };
        std::fs::write(path, outputs::csv(module, case)).map_err(failed)?;
    }
    let mut legs = Vec::new();
    let (program, left) = rust(&job, &compiled, &mut cases)?;
    if let Some(program) = program {
        legs.push(("Rust".to_owned(), of_rust(&cases, &program.path())?));
    }
    // First what can be out of reach: a board.
    for port in &wanted.serial {
        let outcomes = board::outcomes(&compiled, &cases, port, wanted.baud)?;
        legs.push((port.display().to_string(), outcomes));
    }
    for toolchain in compilers.into_iter().map(|it| it.of(standard)) {
        legs.push((toolchain.name(), of_c(&compiled, &cases, &job.options, &toolchain)?));
    }
    let (mut costs, mut figures, mut beyond) = (String::new(), Vec::new(), Vec::new());
    for target in targets {
        let seen = emulated::seen(&compiled, &cases, &job.options, &target)?;
        costs += &emulated::table(&target, &cases, &seen);
        beyond.extend(seen.beyond(&cases));
        figures.extend(emulated::figures(&target, &cases, &seen, &project.settings.limits));
        legs.push((target.name.to_owned(), seen.outcomes));
    }
    let mut text = String::new();
    let calls: usize = cases.iter().map(|case| case.calls.len()).sum();
    // Writing to a string cannot fail.
    let _ = writeln!(text, "{} entry points, {calls} calls; against the interpreter:", cases.len());
    if let Inputs::Recorded { notes, .. } = &inputs {
        for note in notes {
            let _ = writeln!(text, "  the recording: {note}");
        }
    }
    if cases.is_empty() && left.is_empty() {
        text += "  There is nothing to call: mark a method of a component `#[entry]`.\n";
    }
    let mut all = true;
    // Without a call no leg computed a word.
    for (leg, outcomes) in legs.iter().filter(|_| !cases.is_empty()) {
        let differing = differing(module, &cases, outcomes);
        all &= differing.is_empty();
        let words: usize = differing.iter().map(|it| it.words.len()).sum();
        let _ = write!(text, "  {leg:<27}  {words} words differ");
        let _ = match differing.len() {
            0 => writeln!(text),
            calls => writeln!(text, ", in {calls} calls; the first of each entry point:"),
        };
        for first in differing.chunk_by(|a, b| a.case == b.case).map(|of_one| &of_one[0]) {
            let _ = writeln!(text, "    {}", first.told(&cases, outcomes));
        }
    }
    for name in left {
        let _ = writeln!(text, "{name}: not called, since its Rust is not public or takes a slice");
    }
    for Case { name, never, .. } in cases.iter().filter(|case| !case.never.is_empty()) {
        let _ = writeln!(text, "{name}: no call ran {never}");
    }
    if cases.iter().any(|case| !case.never.is_empty()) {
        text +=
            "  Inputs that run them, as of a flight: --inputs, --seed, or `same_bits` in a test.\n";
    }
    text += &costs;
    for line in &beyond {
        let _ = writeln!(text, "{line}: please report this");
    }
    all &= beyond.is_empty();
    if !hooked && is_stale(&job.output, &compiled) {
        text += "warning: what lies in the folder of the C is older than the models, and not what was compared here\n  to do: \
                 cargo bessemer gen\n";
    }
    bessemer_project::hold(&project, figures.into_iter(), colour)?;
    Ok((text, all && !cases.is_empty()))
}

/// Returns true if the folder has other C.
fn is_stale(output: &Path, compiled: &Compiled) -> bool {
    let differs = |file: &CFile| {
        !std::fs::read(output.join(&file.name)).is_ok_and(|is| is == file.text.as_bytes())
    };
    output.is_dir() && compiled.files.iter().any(differs)
}

/// Sources of inputs.
enum Inputs {
    /// Edge values, and a life of small numbers, of each entry point.
    Made { seed: u64 },
    /// The recorded inputs of one entry point: the words of each argument but the component, for each call.
    Recorded { entry: FunctionId, calls: Vec<Vec<Vec<u64>>>, notes: Vec<String> },
}

/// The entry point called `entry`, or the only one.
fn chosen(compiled: &Compiled, entry: Option<&str>) -> Result<FunctionId, Error> {
    let module = &compiled.module;
    let chosen = entries::chosen(compiled, entry);
    if let [entry] = chosen[..] {
        return Ok(entry);
    }
    let known = all(module).map(|id| named(module, &module.functions[id.index()])).collect();
    Err(match entry {
        Some(entry) => Error::NoEntry { name: entry.to_owned(), known },
        None => Error::WhichEntry { known },
    })
}

/// The recording of an entry point.
fn recorded(
    project: &Project,
    compiled: &Compiled,
    path: &Path,
    entry: Option<&str>,
) -> Result<Inputs, Error> {
    let entry = chosen(compiled, entry)?;
    let module = &compiled.module;
    let bytes = std::fs::read(path);
    let bytes = bytes.map_err(|source| Error::File { path: path.to_owned(), source })?;
    let function = &module.functions[entry.index()];
    let mapping = Mapping::of(project, &compiled.interface, &named(module, function));
    let read = recording::read(module, function, &bytes, &mapping);
    let read =
        read.map_err(|wrong| Error::Recording { path: path.to_owned(), wrong: Box::new(wrong) })?;
    Ok(Inputs::Recorded { entry, calls: read.calls, notes: read.notes })
}

/// The calls of each entry point, and what the interpreter makes of them.
fn cases(module: &Module, inputs: &Inputs) -> Vec<Case> {
    let (mut random, only, count) = match inputs {
        Inputs::Made { seed } => (Random(*seed), None, 3 * CALLS),
        Inputs::Recorded { entry, calls, .. } => (Random(0), Some(*entry), calls.len()),
    };
    let mut interpreter = Interpreter::new(module);
    let mut cases = Vec::new();
    for id in all(module).filter(|id| only.is_none_or(|only| only == *id)) {
        let function = &module.functions[id.index()];
        let parameters = function.parameters();
        let mut types = vec![function.result.clone()];
        let changes = |index: usize| index == 0 || parameters[index].mode == Mode::RefMut;
        let changed = (0..parameters.len()).filter(|index| changes(*index));
        types.extend(changed.map(|index| parameters[index].ty.clone()));
        let leaves = types.iter().flat_map(|ty| module.leaves(ty)).collect();
        let name = named(module, function);
        let (calls, expected, never) = (Vec::new(), Vec::new(), String::new());
        let mut case = Case { id, name, types, leaves, calls, expected, never };
        if can_call(function) {
            let initial = initial(module, &parameters[0].ty);
            let mut state = initial.clone();
            let numbers = Numbers::of(module, id);
            interpreter.watch();
            for index in 0..count {
                let size = match index / CALLS {
                    0 => Size::Edges,
                    1 => Size::Tame,
                    _ => Size::Near(&numbers),
                };
                if only.is_none() && index % LIFE == 0 && matches!(size, Size::Near(_)) {
                    state.clone_from(&initial);
                }
                let mut call: Vec<Vec<u64>> = match inputs {
                    Inputs::Made { .. } => {
                        let make =
                            |it: &bessemer_ir::Local| words(&mut random, module, &it.ty, size);
                        parameters.iter().map(make).collect()
                    }
                    Inputs::Recorded { calls, .. } => {
                        std::iter::once(Vec::new()).chain(calls[index].iter().cloned()).collect()
                    }
                };
                if only.is_some() || size != Size::Edges {
                    call[0].clone_from(&state);
                }
                let outcome =
                    interpreted(&mut interpreter, &case, parameters.len(), &call, &changes);
                if let Ok((_, after)) = &outcome {
                    state.clone_from(after);
                } else {
                    state.clone_from(&initial);
                }
                case.calls.push(call);
                case.expected.push(outcome.map(|(words, _)| words));
            }
            case.never = lines::never(module, id, &interpreter.ran());
        }
        cases.push(case);
    }
    cases
}

/// The words that come out, and the component's among them.
fn interpreted(
    interpreter: &mut Interpreter<'_>,
    case: &Case,
    count: usize,
    call: &[Vec<u64>],
    changes: &dyn Fn(usize) -> bool,
) -> Result<(Vec<u64>, Vec<u64>), Fault> {
    let mut arguments = call.to_vec();
    match interpreter.call(case.id, &mut arguments) {
        Ok(mut words) => {
            let changed = (0..count).filter(|index| changes(*index));
            changed.for_each(|index| words.extend(&arguments[index]));
            Ok((words, arguments[0].clone()))
        }
        Err(Stop::Fault { fault, .. }) => Err(fault),
        // A program that runs too long for the interpreter, or words that fit no type: no leg agrees with it.
        Err(_) => Err(Fault::LeftOut),
    }
}

/// The program of the Rust, and those of the cases that it cannot call, which leave the list.
fn rust(
    job: &generate::Job,
    Compiled { module, names, .. }: &Compiled,
    cases: &mut Vec<Case>,
) -> Result<(Option<Program>, Vec<String>), Error> {
    let mut left = Vec::new();
    cases.retain(|case| {
        let called = !case.calls.is_empty();
        if !called {
            left.push(case.name.clone());
        }
        called
    });
    loop {
        let functions: Vec<&Function> =
            cases.iter().map(|case| &module.functions[case.id.index()]).collect();
        if functions.is_empty() {
            return Ok((None, left));
        }
        let (text, first) = native::program(module, names, &functions);
        let said = match generate::native(job, &text, !names.is_empty())
            .map_err(bessemer_project::Error::from)?
        {
            Ok(program) => return Ok((Some(program), left)),
            Err(said) => said,
        };
        // `program.rs:57:13: error[E0603]: module `inner` is private`
        let errors = said.lines().filter(|line| line.contains(": error"));
        let lines = errors.filter_map(|line| line.split(':').nth(1)?.parse::<usize>().ok());
        let wrong: Vec<usize> = lines
            .filter_map(|line| line.checked_sub(first))
            .filter(|index| *index < cases.len())
            .collect();
        if wrong.is_empty() {
            return Err(Error::Native { said });
        }
        let mut index = 0;
        cases.retain(|case| {
            let kept = !wrong.contains(&index);
            if !kept {
                left.push(case.name.clone());
            }
            index += 1;
            kept
        });
    }
}

/// All words of all calls, as the programs read them.
fn input(cases: &[Case]) -> Vec<u8> {
    let mut bytes = Vec::new();
    for (place, case) in cases.iter().enumerate() {
        for call in &case.calls {
            bytes.extend((place as u64).to_le_bytes());
            call.iter().flatten().for_each(|word| bytes.extend(word.to_le_bytes()));
        }
    }
    bytes
}

/// The words that a program writes of all calls.
fn output(mut command: Command, cases: &[Case]) -> Result<Vec<u64>, Error> {
    use std::io::{Seek, Write};
    let failed = |source| Error::File { path: std::env::temp_dir(), source };
    let mut file = tempfile::tempfile().map_err(failed)?;
    file.write_all(&input(cases)).and_then(|()| file.rewind()).map_err(failed)?;
    let output = command.stdin(Stdio::from(file)).output();
    let output = output.map_err(|source| {
        let path = Path::new(command.get_program()).to_owned();
        Error::File { path, source }
    })?;
    let word = |bytes: &[u8]| bytes.iter().rev().fold(0, |word, byte| word << 8 | u64::from(*byte));
    Ok(output.stdout.chunks_exact(8).map(word).collect())
}

/// The cases as the harness takes them.
fn called(compiled: &Compiled, cases: &[Case]) -> Vec<(FunctionId, u32)> {
    let entry = |case: &Case| (case.id, compiled.module.functions[case.id.index()].params);
    cases.iter().map(entry).collect()
}

/// The outcome of each call of each case; `fault` reads the rest of an answer, by its first word.
fn outcomes(
    cases: &[Case],
    words: &[u64],
    fault: impl Fn(u64, &mut dyn FnMut() -> u64) -> Fault,
) -> Vec<Vec<Outcome>> {
    let mut words = words.iter().copied();
    // What a program that died has not written agrees with nothing.
    let mut next = || words.next().unwrap_or(u64::MAX - 7);
    let one = |case: &Case, next: &mut dyn FnMut() -> u64| match next() {
        0 => Ok(case.leaves.iter().map(|_| next()).collect()),
        status => Err(fault(status, next)),
    };
    cases.iter().map(|case| case.calls.iter().map(|_| one(case, &mut next)).collect()).collect()
}

fn of_rust(cases: &[Case], program: &Path) -> Result<Vec<Vec<Outcome>>, Error> {
    let words = output(Command::new(program), cases)?;
    Ok(outcomes(cases, &words, |status, next| {
        let length = (status - 1).min(1 << 16) as usize;
        let mut text: Vec<u8> =
            (0..length.div_ceil(8)).flat_map(|_| next().to_le_bytes()).collect();
        text.truncate(length);
        outcome::fault(&String::from_utf8_lossy(&text))
    }))
}

fn of_c(
    compiled: &Compiled,
    cases: &[Case],
    options: &Options,
    toolchain: &Toolchain,
) -> Result<Vec<Vec<Outcome>>, Error> {
    let failed = |said: String| Error::Compiler { name: toolchain.name(), said };
    let entries = called(compiled, cases);
    let folder = process::lay_out(compiled).map_err(|error| failed(error.to_string()))?;
    let main = folder.path().join("verify_main.c");
    std::fs::write(&main, harness::programs_with(&compiled.explicit, &entries, options))
        .map_err(|source| Error::File { path: main.clone(), source })?;
    let program = folder.path().join("verify");
    toolchain.around(&main, folder.sources(), &program, &[]).map_err(failed)?;
    let words = output(toolchain.runner(&program), cases)?;
    Ok(outcomes(cases, &words, |status, _| fault(status)))
}

/// The fault that a status of the C's other than 0 represents. One that the C never returns, such as a program that died
/// leaves, represents a fault that no other leg reports.
fn fault(status: u64) -> Fault {
    let index = (status as usize).wrapping_sub(1);
    FAULTS.get(index).copied().unwrap_or(Fault::LeftOut)
}

/// A call that is not what the interpreter says.
struct Differing {
    case: usize,
    call: usize,
    /// The places of the words.
    words: Vec<usize>,
}

impl Differing {
    /// Describes the inputs, and the first word of the output that differs.
    fn told(&self, cases: &[Case], outcomes: &[Vec<Outcome>]) -> String {
        let case = &cases[self.case];
        let (expected, got) = (&case.expected[self.call], &outcomes[self.case][self.call]);
        let said = match (expected, got) {
            (Ok(expected), Ok(got)) => {
                let place = self.words.first().copied().unwrap_or_default();
                let word = |of: &[u64]| of.get(place).copied().unwrap_or_default();
                format!("word {place} is {:#018x}, not {:#018x}", word(got), word(expected))
            }
            (expected, got) => {
                let said = |it: &Outcome| match it {
                    Ok(_) => "a result".to_owned(),
                    Err(fault) => format!("the fault {fault:?}"),
                };
                format!("{}, not {}", said(got), said(expected))
            }
        };
        format!("{} of {:x?}: {said}", case.name, case.calls[self.call])
    }
}

fn differing(module: &Module, cases: &[Case], outcomes: &[Vec<Outcome>]) -> Vec<Differing> {
    let mut list = Vec::new();
    for (place, (case, outcomes)) in cases.iter().zip(outcomes).enumerate() {
        for (call, (expected, got)) in case.expected.iter().zip(outcomes).enumerate() {
            let meant = |it: &Outcome| outcome::meant(module, &case.types, it);
            let words = outcome::parted(&meant(expected), &meant(got), &case.leaves);
            if !words.is_empty() {
                list.push(Differing { case: place, call, words });
            }
        }
    }
    list
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_component_without_a_constructor_begins_with_zeros() {
        let text = include_str!("../../../codegen/backend/tests/c/height.ir");
        let mut module = bessemer_ir::text::parse(text).expect("it is a module");
        module.structs.iter_mut().for_each(|of| of.initial = None);
        for case in cases(&module, &Inputs::Made { seed: 0 }) {
            let component = &module.functions[case.id.index()].parameters()[0].ty;
            assert_eq!(
                initial(&module, component),
                vec![0; case.calls[0][0].len()],
                "{}",
                case.name
            );
            assert!(case.expected[CALLS..].iter().any(Result::is_ok), "{}", case.name);
        }
    }

    #[test]
    fn a_word_that_differs_is_found() {
        let text = include_str!("../../../codegen/backend/tests/c/height.ir");
        let module = bessemer_ir::text::parse(text).expect("it is a module");
        let cases = cases(&module, &Inputs::Made { seed: 0 });
        let mut got: Vec<Vec<Outcome>> = cases.iter().map(|case| case.expected.clone()).collect();
        assert!(got.iter().flatten().any(|outcome| outcome.is_ok()), "nothing ran to its end");
        assert!(differing(&module, &cases, &got).is_empty());
        let last = got[0].iter_mut().rev().find_map(|it| it.as_mut().ok()).expect("one that ran");
        last[0] ^= 1;
        let [one] = &differing(&module, &cases, &got)[..] else { panic!("one word differs") };
        assert_eq!(one.words, [0]);
        let told = one.told(&cases, &got);
        assert!(told.starts_with(&cases[0].name) && told.contains("word 0 is 0x"), "{told}");
        got[0][0] = Err(Fault::Index);
        let all = differing(&module, &cases, &got);
        assert_eq!((all[0].case, all[0].call, all[0].words.len()), (0, 0, cases[0].leaves.len()));
        assert!(all[0].told(&cases, &got).contains(": the fault Index, not "));
    }
}
