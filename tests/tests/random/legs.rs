//! Runs the calls of a batch by rustc, the interpreter and the C, and finds where they differ.
//!
//! A component lives through its calls. A fault of an entry that rolls back leaves everything as it was; one of an
//! entry that changes nothing leaves the state; any other stops the component: its C answers each call with that fault until it begins anew.

use std::fmt;

use bessemer_backend::c::names::FAULTS;
use bessemer_codegen::compile::{Compiled, Options};
use bessemer_interpret::{Interpreter, Stop};
use bessemer_ir::{FunctionId, Mode, Module, Owner, Type};
use bessemer_tests::arguments::{Size, words};
use bessemer_tests::harness;
use bessemer_tests::outcome::{Outcome, meant, same};
use bessemer_tests::process::{Error, HAND_OVER, Process, at_once};
use bessemer_tests::random::Random;
use bessemer_tests::toolchain::Toolchain;

use super::native;
use super::warnings;
use super::writer::{Entry, Program};

/// Calls of each program; more of each instance of one that aims at the proofs, which is small.
const CALLS: usize = 48;
const MORE: usize = 100;

/// A program with its calls, and what Rust makes of them.
pub struct Case<'b> {
    program: &'b Program,
    entries: Vec<Target<'b>>,
    /// The words of the state before anything was called; none if there is no component.
    initial: Option<Vec<u64>>,
    calls: Vec<Call>,
    native: Vec<Outcome>,
}

/// A function or an entry point that is called.
struct Target<'b> {
    entry: &'b Entry,
    id: FunctionId,
    /// The types of what comes out: the result, the state, and what is changed.
    types: Vec<Type>,
    leaves: Vec<Type>,
}

struct Call {
    /// Index of the entry.
    entry: usize,
    /// The words of each argument.
    words: Vec<Vec<u64>>,
}

/// Something that is not the same on two legs.
pub struct Difference {
    pub program: String,
    pub text: String,
}

/// Returns the numbers of calls and of those that fault.
pub fn counted(cases: &[Case]) -> (usize, usize) {
    let faults = |case: &Case| case.native.iter().filter(|it| it.is_err()).count();
    (cases.iter().map(|it| it.calls.len()).sum(), cases.iter().map(faults).sum())
}

/// The calls of each program of the batch, and what the native program makes of them; `places`: the names of the
/// entries in it.
pub fn cases<'b>(
    programs: &[&'b Program],
    native: &str,
    places: &[String],
    compiled: &Compiled,
) -> Vec<Case<'b>> {
    let module = &compiled.module;
    let mut cases = Vec::new();
    for program in programs {
        // The same for each, so that one that is made smaller, or kept, is called as it was.
        let mut random = Random(7);
        let entries = program.entries.iter().map(|entry| Target::new(module, program, entry));
        // A smaller variant may have lost its attribute.
        let Some(entries) = entries.collect::<Option<Vec<_>>>() else { continue };
        let calls: Vec<Call> = match program.instances {
            Some(instances) => (0..MORE * instances)
                .map(|at| {
                    let mut call = call(&mut random, module, &entries, at / instances);
                    call.words[0] = vec![(at % instances) as u64];
                    call
                })
                .collect(),
            None => (0..CALLS).map(|at| call(&mut random, module, &entries, at)).collect(),
        };
        let place = |call: &Call| {
            let name = &entries[call.entry].entry.name;
            places.iter().position(|it| it == name).expect("it was built")
        };
        let flat: Vec<_> = calls.iter().map(|it| (place(it), it.words.concat())).collect();
        let native = native::run(native, &flat);
        let initial = match module.functions[entries[0].id.index()].owner {
            Some(Owner::Struct(id)) => module.structs[id.index()].initial.clone(),
            _ => None,
        };
        cases.push(Case { program, entries, initial, calls, native });
    }
    cases
}

/// One call, every other with words from the edges, where a component does not live through it.
fn call(random: &mut Random, module: &Module, entries: &[Target], at: usize) -> Call {
    let entry = random.below(entries.len());
    let function = &module.functions[entries[entry].id.index()];
    let every = if function.owner.is_some() { 4 } else { 2 };
    let size = if at.is_multiple_of(every) { Size::Edges } else { Size::Tame };
    let parameters = &function.parameters()[usize::from(function.owner.is_some())..];
    let words = parameters.iter().map(|local| words(random, module, &local.ty, size)).collect();
    Call { entry, words }
}

impl<'b> Target<'b> {
    fn new(module: &Module, program: &Program, entry: &'b Entry) -> Option<Target<'b>> {
        let index = module.functions.iter().position(|it| {
            let owner = match it.owner {
                Some(Owner::Struct(id)) => Some(module.structs[id.index()].name.as_str()),
                _ => None,
            };
            it.name == entry.name && owner == program.unit.as_deref()
        })?;
        let function = &module.functions[index];
        let own = |index: usize| index == 0 && program.unit.is_some();
        let out = function.parameters().iter().enumerate();
        let out = out.filter(|(index, local)| own(*index) || local.mode == Mode::RefMut);
        let mut types = vec![function.result.clone()];
        types.extend(out.map(|(_, local)| local.ty.clone()));
        let leaves = types.iter().flat_map(|ty| module.leaves(ty)).collect();
        Some(Target { entry, id: FunctionId(index as u32), types, leaves })
    }
}

impl Case<'_> {
    fn differs(&self, text: impl fmt::Display) -> Difference {
        let program = self.program.name.clone();
        Difference { text: format!("{program} {text}"), program }
    }

    /// Returns the difference between a call's result and Rust's.
    fn compare(&self, leg: &str, module: &Module, at: usize, got: &Outcome) -> Option<Difference> {
        let call = &self.calls[at];
        let target = &self.entries[call.entry];
        let got = meant(module, &target.types, got);
        if same(&self.native[at], &got, &target.leaves) {
            return None;
        }
        Some(self.differs(format!(
            "in {leg}, call {at} of {} with {:x?}\nRust  {:x?}\n{leg} {got:x?}",
            target.entry.name, call.words, self.native[at]
        )))
    }
}

/// Returns the differences of the interpreter.
pub fn interpreted(leg: &str, module: &Module, cases: &[Case]) -> Vec<Difference> {
    let mut interpreter = Interpreter::new(module);
    let differs = |case| interpreted_case(leg, module, &mut interpreter, case);
    cases.iter().filter_map(differs).collect()
}

fn interpreted_case(
    leg: &str,
    module: &Module,
    interpreter: &mut Interpreter,
    case: &Case,
) -> Option<Difference> {
    let mut state = case.initial.clone();
    for (at, call) in case.calls.iter().enumerate() {
        let target = &case.entries[call.entry];
        let parameters = module.functions[target.id.index()].parameters();
        let mut arguments: Vec<_> = state.iter().chain(&call.words).cloned().collect();
        let given = arguments.clone();
        // What the compiler added, a work struct, is nothing that Rust knows.
        for added in &parameters[given.len()..] {
            arguments.push(vec![0; module.width(&added.ty)]);
        }
        let called = interpreter.call(target.id, &mut arguments);
        arguments.truncate(given.len());
        let got = match called {
            Ok(mut words) => {
                for (index, argument) in arguments.iter().enumerate() {
                    if index == 0 && state.is_some() || parameters[index].mode == Mode::RefMut {
                        words.extend(argument);
                    }
                }
                Ok(words)
            }
            Err(Stop::Fault { fault, .. }) => Err(fault),
            Err(stop) => return Some(case.differs(format!("in {leg}: {stop}"))),
        };
        if let Some(difference) = case.compare(leg, module, at, &got) {
            return Some(difference);
        }
        if got.is_err() && target.entry.atomic && arguments != given {
            return Some(case.differs(format!("in {leg}, call {at}: what faulted left a trace")));
        }
        if let Some(state) = &mut state {
            *state = match (&got, &case.initial) {
                (Err(_), Some(initial)) if target.entry.stops => initial.clone(),
                _ => arguments.swap_remove(0),
            };
        }
    }
    None
}

/// Returns the differences of the C from this compiler.
pub fn in_c(
    compiled: &Compiled,
    cases: &[Case],
    toolchain: &Toolchain,
    flags: &[&str],
) -> Vec<Difference> {
    let leg = format!("{} {}", toolchain.name(), flags.join(" "));
    let module = &compiled.module;
    let targets = cases.iter().flat_map(|case| &case.entries);
    let ids: Vec<_> = targets.map(|it| (it.id, module.functions[it.id.index()].params)).collect();
    let main = harness::lives(&compiled.explicit, &ids, &Options::default());
    let mut process = match Process::run(compiled, &main, toolchain, flags) {
        Ok(process) => process,
        Err(error) => {
            let text = format!("{leg}: {error}");
            return vec![Difference { program: "all".into(), text }];
        }
    };
    let names = cases.iter().map(|case| case.program.name.as_str());
    let mut all = warnings::told(&leg, process.said(), &compiled.files, &names.collect());
    let mut first = 0;
    for case in cases {
        match Life::new(case, &leg, module, &mut process, first).lived() {
            Ok(difference) => all.extend(difference),
            Err(error) => {
                all.push(case.differs(format!("in {leg}: {error}")));
                if process.restart(toolchain).is_err() {
                    return all;
                }
            }
        }
        first += case.entries.len();
    }
    all
}

/// The calls of a program in a process of its C.
struct Life<'l> {
    case: &'l Case<'l>,
    leg: &'l str,
    module: &'l Module,
    process: &'l mut Process,
    /// The place of its first entry in the process.
    first: usize,
    /// The words of the state, and of each entry's last result.
    state: Vec<u64>,
    results: Vec<Vec<u64>>,
}

impl<'l> Life<'l> {
    fn new(
        case: &'l Case,
        leg: &'l str,
        module: &'l Module,
        process: &'l mut Process,
        first: usize,
    ) -> Life<'l> {
        let state = case.initial.clone().unwrap_or_default();
        let results = vec![Vec::new(); case.entries.len()];
        Life { case, leg, module, process, first, state, results }
    }

    fn lived(&mut self) -> Result<Option<Difference>, Error> {
        let component = self.case.initial.is_some();
        if !component {
            return self.called_at_once();
        }
        let mut anew = component;
        for (at, call) in self.case.calls.iter().enumerate() {
            let target = &self.case.entries[call.entry];
            let (status, words) = self.called(call, anew)?;
            let got =
                if status == 0 { Ok(words.clone()) } else { Err(FAULTS[status as usize - 1]) };
            if let Some(difference) = self.case.compare(self.leg, self.module, at, &got) {
                return Ok(Some(difference));
            }
            anew = component && status != 0 && target.entry.stops;
            if let Some(what) = self.trace(call, status, &words) {
                let text = format!("in {}, call {at}: a fault left a trace in {what}", self.leg);
                return Ok(Some(self.case.differs(text)));
            }
            if anew {
                let next = &self.case.calls[(at + 1) % self.case.calls.len()];
                let (again, _) = self.called(next, false)?;
                if again != status {
                    let text = format!("in {}, call {at}: {status}, then {again}", self.leg);
                    return Ok(Some(self.case.differs(text)));
                }
            }
        }
        Ok(None)
    }

    /// Makes calls that leave nothing behind, many at once: each wait costs more than a call.
    fn called_at_once(&mut self) -> Result<Option<Difference>, Error> {
        let calls = &self.case.calls;
        let leaves = |call: &Call| self.case.entries[call.entry].leaves.len();
        let words = |call: &Call| call.words.iter().map(Vec::len).sum::<usize>().max(leaves(call));
        let longest = 3 + calls.iter().map(words).max().unwrap_or_default();
        for (from, some) in calls.chunks(at_once(longest)).enumerate() {
            let mut sent = Vec::new();
            for call in some {
                sent.extend([(self.first + call.entry) as u64, 0]);
                sent.extend(call.words.iter().flatten());
            }
            sent.push(HAND_OVER);
            self.process.send(&sent)?;
            let mut found = None;
            for (at, call) in some.iter().enumerate() {
                let (status, words) = self.received(call)?;
                let got = if status == 0 { Ok(words) } else { Err(FAULTS[status as usize - 1]) };
                let at = from * at_once(longest) + at;
                found = found.or_else(|| self.case.compare(self.leg, self.module, at, &got));
            }
            if found.is_some() {
                return Ok(found);
            }
        }
        Ok(None)
    }

    /// Returns a forbidden change by a fault; keeps the state for later comparisons.
    fn trace(&mut self, call: &Call, status: u64, words: &[u64]) -> Option<&'static str> {
        let initial = self.case.initial.as_ref()?;
        let target = &self.case.entries[call.entry];
        let (result, rest) = words.split_at(self.module.width(&target.types[0]));
        let last = &mut self.results[call.entry];
        if status != 0 && !last.is_empty() && last != result {
            return Some("its result");
        }
        *last = result.to_vec();
        let (state, changed) = rest.split_at(initial.len());
        if status != 0 && !target.entry.stops && state != self.state {
            return Some("the state");
        }
        if status != 0 && target.entry.atomic {
            let parameters = &self.module.functions[target.id.index()].parameters()[1..];
            let given = parameters.iter().zip(&call.words);
            let given = given.filter(|(local, _)| local.mode == Mode::RefMut);
            let given: Vec<u64> = given.flat_map(|(_, words)| words).copied().collect();
            if changed != given {
                return Some("what is changed");
            }
        }
        if status != 0 && target.entry.stops {
            self.state.clone_from(initial);
        } else {
            self.state = state.to_vec();
        }
        None
    }

    /// The status, and the words of the result, of the state and of what is changed.
    fn called(&mut self, call: &Call, anew: bool) -> Result<(u64, Vec<u64>), Error> {
        let mut words = vec![(self.first + call.entry) as u64, u64::from(anew)];
        words.extend(call.words.iter().flatten());
        words.push(HAND_OVER);
        self.process.send(&words)?;
        self.received(call)
    }

    fn received(&mut self, call: &Call) -> Result<(u64, Vec<u64>), Error> {
        let status = self.process.receive(1)?[0];
        let words = self.process.receive(self.case.entries[call.entry].leaves.len())?;
        Ok((status, words))
    }
}
