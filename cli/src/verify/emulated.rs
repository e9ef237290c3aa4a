//! The C on an emulated processor: its results, and its cost in instructions, stack and code.
//!
//! Instructions and stack are the maxima over all calls; the size is of all the C. No call may take more instructions than
//! the longest path through the machine code, where the model of [`longest`] has the processor.

use std::fmt::Write as _;

use bessemer_codegen::compile::{Compiled, Options, Standard};
use bessemer_legs::longest::{self, Longest};
use bessemer_legs::toolchain::{self, Sizes, Toolchain};
use bessemer_legs::{harness, process, watch};
use bessemer_project::{Figure, Limits};

use super::{Case, called, fault, input};
use crate::args::Target;
use crate::error::Error;
use bessemer_legs::outcome::Outcome;

/// A processor with its compiler and emulator.
pub struct Processor {
    /// Name of the processor in the command's output.
    pub name: &'static str,
    /// Compiler and emulator for the processor.
    pub toolchain: Toolchain,
}

/// The most that a call of an entry point costs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Cost {
    /// Instructions of a call.
    pub instructions: u64,
    /// Bytes of stack.
    pub stack: u64,
}

/// The outcomes and costs of the cases on a processor.
pub struct Seen {
    /// The outcome of each call of each case.
    pub outcomes: Vec<Vec<Outcome>>,
    /// The cost of each case.
    pub costs: Vec<Cost>,
    /// The sizes of the C.
    pub sizes: Sizes,
    /// The longest path of each case with the instructions of its caller; none if the model lacks the processor.
    pub longest: Vec<Option<Longest>>,
}

impl Seen {
    /// Returns the cases whose calls took more than their longest path: the model is then wrong.
    pub fn beyond(&self, cases: &[Case]) -> Vec<String> {
        let rows = cases.iter().zip(&self.costs).zip(&self.longest);
        let beyond = rows.filter_map(|((case, cost), longest)| {
            let most = longest.as_ref()?.cost.as_ref().ok()?.instructions;
            (cost.instructions > most).then(|| {
                let (name, count) = (&case.name, cost.instructions);
                format!("{name}: a call took {count} instructions, and its longest path has {most}")
            })
        });
        beyond.collect()
    }
}

/// The name of a processor, and the compiler and emulator for it.
pub fn machine(target: Target) -> (&'static str, Toolchain) {
    match target {
        Target::CortexA9 => ("cortex-a9", toolchain::ARM),
        Target::Zynq => ("zynq", toolchain::BARE_A9),
        Target::CortexM4f => ("cortex-m4f", toolchain::CORTEX_M4F),
        Target::CortexM7 => ("cortex-m7", toolchain::CORTEX_M7),
        Target::Aarch64 => ("aarch64", toolchain::AARCH64),
        Target::Riscv64 => ("riscv64", toolchain::RISCV64),
        Target::Riscv32 => ("riscv32", toolchain::RISCV32),
        Target::S390x => ("s390x", toolchain::S390X),
    }
}

/// The processor of a target, if its programs run here.
///
/// # Errors
/// The program that is missing, with the line that installs it.
pub fn processor(target: Target, standard: Standard) -> Result<Processor, Error> {
    let (name, toolchain) = machine(target);
    // gcc makes the plugin that counts.
    let programs = [toolchain.programs(), toolchain::GCC.programs()].concat();
    bessemer_tools::check(&programs)?;
    Ok(Processor { name, toolchain: toolchain.of(standard) })
}

/// Calls each case on the processor.
///
/// # Errors
/// The message of the compiler, the emulator or the system.
pub fn seen(
    compiled: &Compiled,
    cases: &[Case],
    options: &Options,
    processor: &Processor,
) -> Result<Seen, Error> {
    let toolchain = &processor.toolchain;
    let failed = |said: String| Error::Compiler { name: processor.name.to_owned(), said };
    let folder = process::lay_out(compiled).map_err(|error| failed(error.to_string()))?;
    let main = folder.path().join("verify_main.c");
    let text =
        harness::watched(&compiled.explicit, &called(compiled, cases), options, toolchain.bare);
    std::fs::write(&main, text).map_err(|source| Error::File { path: main.clone(), source })?;
    let watched = watch::watched(toolchain, folder.path(), &main, folder.sources(), &input(cases));
    let watched = watched.map_err(failed)?;
    let (objects, _) = toolchain.objects(folder.sources(), &[]).map_err(failed)?;
    let sizes = toolchain.sizes(&objects).map_err(failed)?;
    let (outcomes, costs) = told(cases, &watched);
    let paths = longest::longest(compiled, toolchain).map_err(failed)?.unwrap_or_default();
    let longest = cases.iter().map(|case| {
        let at = compiled.entries.iter().position(|it| it.function == case.id)?;
        let mut found = paths.get(at)?.clone();
        // The counted instructions are also those of the caller.
        let parameters = compiled.module.functions[case.id.index()].parameters().len();
        if let Ok(cost) = &mut found.cost {
            cost.instructions += longest::call(parameters);
        }
        Some(found)
    });
    let longest = longest.collect();
    Ok(Seen { outcomes, costs, sizes, longest })
}

/// The outcomes and costs in a program's output.
fn told(cases: &[Case], watched: &watch::Watched) -> (Vec<Vec<Outcome>>, Vec<Cost>) {
    let (mut words, mut counts) = (watched.words.iter().copied(), watched.counts.iter().copied());
    let (mut outcomes, mut costs) = (Vec::new(), Vec::new());
    for case in cases {
        let mut cost = Cost::default();
        let mut one = || {
            // A program that died has not written every word; the words in their place agree with nothing.
            let status = words.next().unwrap_or(u64::MAX);
            cost.stack = cost.stack.max(words.next().unwrap_or(0));
            cost.instructions = cost.instructions.max(counts.next().unwrap_or(0));
            match status {
                0 => Ok(case.leaves.iter().map(|_| words.next().unwrap_or(u64::MAX - 7)).collect()),
                status => Err(fault(status)),
            }
        };
        outcomes.push(case.calls.iter().map(|_| one()).collect());
        costs.push(cost);
    }
    (outcomes, costs)
}

/// The table of the cases' costs on a processor.
pub fn table(processor: &Processor, cases: &[Case], seen: &Seen) -> String {
    let width = cases.iter().map(|case| case.name.len()).max().unwrap_or(0).max(11);
    let Sizes { text, data, bss } = seen.sizes;
    let mut table = format!(
        "\non {}: {text} bytes of text, {} of data; of any call the most:\n  {:width$}  instructions  stack  longest path\n",
        processor.name,
        data + bss,
        "entry point"
    );
    for (at, (case, cost)) in cases.iter().zip(&seen.costs).enumerate() {
        let longest = match seen.longest.get(at).and_then(Option::as_ref).map(|it| &it.cost) {
            None => "–".to_owned(),
            Some(Ok(cost)) => cost.instructions.to_string(),
            Some(Err(why)) => format!("none: {why}"),
        };
        // Writing to a string cannot fail.
        let _ = writeln!(
            table,
            "  {:width$}  {:>12}  {:>5}  {longest:>12}",
            case.name, cost.instructions, cost.stack
        );
    }
    table
}

/// The figures that limits hold.
pub fn figures(processor: &Processor, cases: &[Case], seen: &Seen, limits: &Limits) -> Vec<Figure> {
    let on = processor.name;
    let figure = |limit, whose, found, what| Figure { limit, whose, found, what };
    let size =
        figure(limits.text_bytes, format!("the C for {on}"), seen.sizes.text, "bytes of text");
    let each = cases.iter().zip(&seen.costs).flat_map(|(case, cost)| {
        let whose = format!("`{}` on {on}", case.name);
        [
            figure(limits.instructions, whose.clone(), cost.instructions, "instructions"),
            figure(limits.stack_bytes, whose, cost.stack, "bytes of stack"),
        ]
    });
    std::iter::once(size).chain(each).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use bessemer_backend::c::names::FAULTS;
    use bessemer_ir::{FunctionId, Type};
    use bessemer_project::Limit;

    fn case(calls: usize) -> Case {
        Case {
            id: FunctionId(0),
            name: "Motor::step".into(),
            types: Vec::new(),
            leaves: vec![Type::Unit; 2],
            calls: vec![Vec::new(); calls],
            expected: Vec::new(),
            never: String::new(),
        }
    }

    #[test]
    fn the_most_of_any_call_is_told_and_held() {
        let cases = [case(2), case(1)];
        let watched = watch::Watched {
            words: [&[0, 40, 7, 8][..], &[1, 48], &[0, 4, 9, 9]].concat(),
            counts: vec![100, 30, 5],
        };
        let (outcomes, costs) = told(&cases, &watched);
        assert_eq!(outcomes[0], [Ok(vec![7, 8]), Err(FAULTS[0])]);
        assert_eq!(outcomes[1], [Ok(vec![9, 9])]);
        assert_eq!(costs[0], Cost { instructions: 100, stack: 48 });
        assert_eq!(costs[1], Cost { instructions: 5, stack: 4 });

        let limit = |most| Some(Limit { most, line: 1, column: 1 });
        let limits = Limits { instructions: limit(99), text_bytes: limit(9), ..Limits::default() };
        let sizes = Sizes { text: 10, data: 0, bss: 0 };
        let path = |instructions| Longest {
            entry: "motor_step".to_owned(),
            cost: Ok(longest::Cost { instructions, cycles: 9 }),
            normal: Ok(longest::Cost { instructions, cycles: 9 }),
        };
        let longest = vec![Some(path(99)), Some(path(5))];
        let seen = Seen { outcomes, costs, sizes, longest };
        assert_eq!(
            seen.beyond(&cases),
            ["Motor::step: a call took 100 instructions, and its longest path has 99"]
        );
        let processor = Processor { name: "zynq", toolchain: toolchain::BARE_A9 };
        let beyond = figures(&processor, &cases, &seen, &limits)
            .into_iter()
            .filter(|it| it.limit.is_some_and(|limit| it.found > u64::from(limit.most)));
        let told: Vec<String> =
            beyond.map(|it| format!("{} has {} {}", it.whose, it.found, it.what)).collect();
        let expected =
            ["the C for zynq has 10 bytes of text", "`Motor::step` on zynq has 100 instructions"];
        assert_eq!(told, expected);
    }
}
