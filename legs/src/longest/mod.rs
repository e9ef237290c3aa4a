//! Longest path of each entry point through the code that gcc makes of the C, in instructions and cycles.
//!
//! Model: each source is compiled to assembly. A function costs the most of all paths through its blocks, and of its copies
//! in other files; a call costs its callee, and a function of a library the figure of [`library`]. A loop costs its longest pass as often as its
//! largest number of passes, which the C itself or the explicit IR has ([`passes`]), or with those of each value of the
//! counter around it. The passes and the sides of branches
//! are taken as independent, so the path need not be possible. Each instruction costs one, and the cycles of [`cycles`];
//! caches, wait states and interrupts are not in it.
//!
//! Invariant: a loop or a call without a bound gives a reason in place of a figure. `verify --target` compares the
//! figures with counted calls.

mod assembly;
mod cycles;
mod library;
mod passes;
mod paths;

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};

use bessemer_codegen::compile::Compiled;

use crate::process;
use crate::toolchain::{self, Toolchain};
use assembly::{Function, Step};
use library::Known;
pub use library::{Numbers, slow};
use passes::Passes;

/// A processor of the model.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Processor {
    /// Cortex-A9 with double precision in hardware.
    A9,
    /// Cortex-M4 with single precision in hardware.
    M4f,
}

/// Instructions and cycles.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Cost {
    /// Executed instructions.
    pub instructions: u64,
    /// Cycles.
    pub cycles: u64,
}

/// Longest path of an entry point.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Longest {
    /// The C name.
    pub entry: String,
    /// Its cost, or the reason for none.
    pub cost: Result<Cost, String>,
    /// Its cost if it meets normal numbers alone.
    pub normal: Result<Cost, String>,
}

/// Returns the processor that a toolchain compiles for; none if the model has no figures for it.
pub fn processor(toolchain: &Toolchain) -> Option<Processor> {
    let is =
        |name: &str| toolchain.machine.iter().any(|it| it.strip_prefix("-mcpu=") == Some(name));
    match () {
        () if is("cortex-a9") => Some(Processor::A9),
        () if is("cortex-m4") => Some(Processor::M4f),
        () => None,
    }
}

/// Returns true if operations in double precision take longer with subnormal numbers, since they are a library's.
pub fn has_slow_numbers(toolchain: &Toolchain) -> bool {
    processor(toolchain) == Some(Processor::M4f)
}

/// Returns the most instructions of an unoptimised caller that passes this many parameters and takes the result.
pub fn call(parameters: usize) -> u64 {
    16 + 6 * parameters as u64
}

/// Returns the longest path of each entry point, in their order; none for a processor that the model does not have.
///
/// # Errors
/// The message of the compiler or the system.
pub fn longest(compiled: &Compiled, toolchain: &Toolchain) -> Result<Option<Vec<Longest>>, String> {
    let Some(processor) = processor(toolchain) else { return Ok(None) };
    let laid = process::lay_out(compiled).map_err(|error| error.to_string())?;
    let texts = assembled(toolchain, laid.sources())?;
    let mut functions: BTreeMap<String, Vec<Function>> = BTreeMap::new();
    for function in texts.iter().flat_map(|text| assembly::functions(text)) {
        functions.entry(function.name.clone()).or_default().push(function);
    }
    let passes = Passes::of(compiled);
    let places = library::places(&compiled.explicit);
    let costs = |numbers| Costs {
        processor,
        numbers,
        functions: &functions,
        passes: &passes,
        places,
        known: BTreeMap::new(),
    };
    let (mut any, mut normal) = (costs(Numbers::Any), costs(Numbers::Normal));
    let mut of = |entry: &str| Longest {
        entry: entry.to_owned(),
        cost: any.of(entry),
        normal: normal.of(entry),
    };
    Ok(Some(compiled.entries.iter().map(|it| of(&it.entry)).collect()))
}

/// Returns the instructions of each function's caller in a program of [`counted`](crate::harness::counted).
///
/// Between the marks the program passes the arguments and takes the result, without a branch.
///
/// # Errors
/// The message of the compiler or the system.
pub fn callers(toolchain: &Toolchain, main: &Path, count: usize) -> Result<Vec<u64>, String> {
    // The program is compiled without optimisation: see `Toolchain::around`.
    let text = assembly_of(&Toolchain { level: 0, ..toolchain.clone() }, main)?;
    let functions = assembly::functions(&text);
    let caller = |index| {
        let name = format!("call_{index}");
        let function = functions.iter().find(|it| it.name == name)?;
        let all: Vec<_> = function.blocks.iter().flat_map(|it| &it.instructions).collect();
        let at = |mark: &str| all.iter().position(|it| it.step == Step::Call(mark.to_owned()));
        Some(at("bench_end")?.checked_sub(at("bench_begin")?)? as u64)
    };
    let all = (0..count).map(|it| caller(it).ok_or_else(|| format!("`call_{it}` has no marks")));
    all.collect()
}

/// Compiles a source to assembly.
fn assembly_of(toolchain: &Toolchain, source: &Path) -> Result<String, String> {
    let output = source.with_extension("s");
    let mut command = toolchain.command();
    // The lines of the C stand beside the instructions, which they leave as they are.
    command.args(["-S", "-g1", "-I"]).args(source.parent()).arg(source).arg("-o").arg(&output);
    toolchain::run(&mut command)?;
    std::fs::read_to_string(&output).map_err(|error| error.to_string())
}

/// Compiles each source to assembly, using all processors.
fn assembled(toolchain: &Toolchain, sources: &[PathBuf]) -> Result<Vec<String>, String> {
    let next = AtomicUsize::new(0);
    let work = || {
        let mut made = Vec::new();
        while let Some(source) = sources.get(next.fetch_add(1, Ordering::Relaxed)) {
            made.push((source, assembly_of(toolchain, source)));
        }
        made
    };
    let workers = std::thread::available_parallelism().map_or(1, usize::from);
    let mut made = std::thread::scope(|scope| {
        let workers: Vec<_> = (0..workers).map(|_| scope.spawn(work)).collect();
        workers.into_iter().filter_map(|it| it.join().ok()).flatten().collect::<Vec<_>>()
    });
    // The first error is the same in each run.
    made.sort_by_key(|(source, _)| *source);
    made.into_iter().map(|(_, text)| text).collect()
}

struct Costs<'f> {
    processor: Processor,
    numbers: Numbers,
    /// Functions by name. Each file may have one of its own: a copy of an inline function, or gcc's copy for the constants of
    /// its calls (`f.constprop.0`).
    functions: &'f BTreeMap<String, Vec<Function>>,
    passes: &'f Passes,
    /// Most binary places of the quotient of a remainder.
    places: u64,
    /// Costs of functions; none for one that is being computed.
    known: BTreeMap<String, Option<Result<Cost, String>>>,
}

impl Costs<'_> {
    fn of(&mut self, name: &str) -> Result<Cost, String> {
        if let Some(known) = self.known.get(name) {
            return known.clone().unwrap_or_else(|| Err(format!("`{name}` calls itself")));
        }
        let Some(copies) = self.functions.get(name) else {
            return Err(format!("`{name}` is of a library without a known cost"));
        };
        self.known.insert(name.to_owned(), None);
        let cost = copies.iter().try_fold(Cost::default(), |most, copy| {
            let cost = self.function(copy)?;
            Ok(Cost {
                instructions: most.instructions.max(cost.instructions),
                cycles: most.cycles.max(cost.cycles),
            })
        });
        self.known.insert(name.to_owned(), Some(cost.clone()));
        cost
    }

    fn function(&mut self, function: &Function) -> Result<Cost, String> {
        if let Some(why) = &function.unknown {
            return Err(format!("`{}`: {why}", function.name));
        }
        let mut costs = Vec::new();
        for block in &function.blocks {
            let mut sum = Cost::default();
            for instruction in &block.instructions {
                sum.instructions += 1;
                sum.cycles += cycles::of(self.processor, &instruction.text);
                if let Step::Call(callee) = &instruction.step {
                    let cost = match library::cost(
                        self.processor,
                        callee,
                        Known { bytes: instruction.bytes, zero: instruction.zero },
                        self.places,
                        self.numbers,
                    ) {
                        Some(cost) => cost,
                        None => self.of(callee)?,
                    };
                    sum.instructions += cost.instructions;
                    sum.cycles += cost.cycles;
                }
            }
            costs.push(sum);
        }
        let next: Vec<Vec<usize>> = function.blocks.iter().map(|it| it.next.clone()).collect();
        let leave: Vec<bool> = function.blocks.iter().map(|it| it.leaves).collect();
        let bound = |blocks: &[usize]| self.passes.of_loop(function, blocks);
        let longest = |of: fn(&Cost) -> u64| {
            let costs: Vec<u64> = costs.iter().map(of).collect();
            paths::longest(&next, &leave, &costs, &bound)
        };
        Ok(Cost { instructions: longest(|it| it.instructions)?, cycles: longest(|it| it.cycles)? })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// gcc gives copies for constants the same name in each file, and another text.
    #[test]
    fn of_copies_with_one_name_the_longest_counts() {
        let text =
            |body: &str| format!("\t.type\tf, %function\nf:\n{body}\tbx\tlr\n\t.size\tf, .-f\n");
        let copies =
            |bodies: [&str; 2]| bodies.map(|body| assembly::functions(&text(body)).remove(0));
        for bodies in [["", "\tnop\n\tnop\n"], ["\tnop\n\tnop\n", ""]] {
            let functions = BTreeMap::from([("f".to_owned(), copies(bodies).into())]);
            let mut costs = Costs {
                processor: Processor::M4f,
                numbers: Numbers::Any,
                functions: &functions,
                passes: &Passes::default(),
                places: 0,
                known: BTreeMap::new(),
            };
            assert_eq!(costs.of("f").map(|it| it.instructions), Ok(3));
        }
    }
}
