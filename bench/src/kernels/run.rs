//! Runs the measurement machine by machine: builds, checks, counts and times.

use std::path::{Path, PathBuf};

use super::case::{CHAPTER_6, Case};
use super::clock::{Reference, Server, race, summary};
use super::contender::Contender;
use super::machine::{
    A9, A9_PLAIN, HOST, HOST_AVX2, HOST_SCALAR, HOST_SSE2, HOST_V3, Machine, processor,
};
use super::results::{Cell, Results, Row, Size, Table};
use super::{check, count, generated};

/// Extent of a run.
#[derive(Clone, Copy, Debug)]
pub struct Plan<'a> {
    /// The small sizes.
    pub sizes: &'a [usize],
    /// Number of rounds of each comparison of times.
    pub rounds: usize,
    /// True for a short run, which omits the less important machines.
    pub quick: bool,
    /// True to count instructions only, without times.
    pub counts: bool,
    /// Names of the machines to use; all if empty.
    pub machines: &'a [String],
}

/// The full plan.
pub const FULL: Plan<'static> = Plan {
    sizes: &[2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20],
    rounds: 101,
    quick: false,
    counts: false,
    machines: &[],
};

/// The short plan.
pub const QUICK: Plan<'static> =
    Plan { sizes: &[3, 6, 12], rounds: 31, quick: true, counts: false, machines: &[] };

/// Runs a plan; calls `say` with each step.
///
/// # Errors
///
/// A program does not compile, does not run, or has a wrong result.
pub fn run(plan: &Plan<'_>, say: &dyn Fn(&str)) -> Result<Results, String> {
    let folder = bessemer_tests::root().join("target/bench");
    std::fs::create_dir_all(&folder).map_err(|error| error.to_string())?;
    let mut results = Results::default();
    let small = Case::small(plan.sizes);
    let timed: &[Machine] = match (plan.counts, plan.quick) {
        (true, _) => &[],
        (false, true) => &[HOST],
        (false, false) => &[HOST, HOST_V3, HOST_SCALAR],
    };
    let counted: &[Machine] =
        if plan.quick { &[A9] } else { &[HOST_SSE2, HOST_AVX2, A9, A9_PLAIN] };
    let wanted = |machine: &&Machine| {
        plan.machines.is_empty() || plan.machines.iter().any(|name| name == machine.name)
    };
    let timed: Vec<&Machine> = timed.iter().filter(wanted).collect();
    let counted: Vec<&Machine> = counted.iter().filter(wanted).collect();
    let mut bench = Bench { folder: &folder, say, results: &mut results };
    for machine in &timed {
        let table =
            bench.times(machine, &Contender::of_chapter_6(machine), &CHAPTER_6, plan.rounds)?;
        bench.results.chapter_6.push(table);
    }
    for machine in &counted {
        let table = bench.counts(machine, &Contender::of_chapter_6(machine), &CHAPTER_6)?;
        bench.results.chapter_6.push(table);
    }
    for machine in &counted {
        let table = bench.counts(machine, &Contender::SMALL, &small)?;
        bench.results.small.push(table);
    }
    // Without AVX-512 the instructions of small sizes are counted.
    for machine in timed.into_iter().filter(|machine| **machine != HOST_V3) {
        let table = bench.times(machine, &Contender::SMALL, &small, plan.rounds)?;
        bench.results.small.push(table);
    }
    Ok(results)
}

/// Number of restarts of the programs for their times: the placement of stacks and data changes a small kernel's time
/// by up to half.
const STARTS: usize = 9;

struct Bench<'a> {
    folder: &'a Path,
    say: &'a dyn Fn(&str),
    results: &'a mut Results,
}

impl Bench<'_> {
    /// Builds the programs of all contenders for a machine.
    fn programs(
        &mut self,
        machine: &Machine,
        contenders: &[Contender],
        cases: &[Case],
    ) -> Result<Vec<(Contender, PathBuf)>, String> {
        let mut programs = Vec::new();
        for &contender in contenders {
            (self.say)(&format!("{}: building {}", machine.title, contender.title()));
            match contender.build(machine, cases, self.folder) {
                Ok(program) => programs.push((contender, program)),
                Err(error) if contender == Contender::Generated => return Err(error),
                Err(error) => {
                    // rustc says how to get a target that is not installed.
                    let telling = |word| error.lines().find(|line| line.contains(word));
                    let why = telling("rustup target add").or_else(|| telling("error"));
                    let why = why.unwrap_or(&error).trim();
                    let line = format!("{} on {}: {why}", contender.title(), machine.title);
                    self.results.left_out.push(line);
                }
            }
        }
        self.sizes(machine, cases);
        Ok(programs)
    }

    /// Returns an error if a result is wrong.
    fn check(
        &self,
        machine: &Machine,
        programs: &[(Contender, PathBuf)],
        cases: &[Case],
    ) -> Result<(), String> {
        (self.say)(&format!("{}: checking results", machine.title));
        let model = Contender::Native.build(&HOST, cases, self.folder)?;
        let mut model = Server::start(&model, &[])?;
        for (contender, program) in programs {
            let mut server = if machine.target {
                Server::emulated(program)?
            } else {
                Server::start(program, contender.environment())?
            };
            for case in cases {
                let words = server.result(&case.name())?;
                let residual = check::residual(case, &words);
                if residual > check::allowed(contender.name(), case) {
                    return Err(format!(
                        "{}: {} has a residual of {residual}",
                        contender.title(),
                        case.name()
                    ));
                }
                if *contender == Contender::Generated
                    && !check::same(case, &words, &model.result(&case.name())?)
                {
                    return Err(format!("{}: the C and the model differ", case.name()));
                }
            }
        }
        Ok(())
    }

    fn times(
        &mut self,
        machine: &Machine,
        contenders: &[Contender],
        cases: &[Case],
        rounds: usize,
    ) -> Result<Table, String> {
        let programs = self.programs(machine, contenders, cases)?;
        self.check(machine, &programs, cases)?;
        let mut rounds_of = vec![vec![Vec::new(); programs.len()]; cases.len()];
        let mut reference = Reference::default();
        for start in 1..=STARTS {
            let mut servers = Vec::new();
            for (contender, program) in &programs {
                servers.push(Server::start(program, contender.environment())?);
            }
            for (case, known) in cases.iter().zip(&mut rounds_of) {
                let name = case.name();
                (self.say)(&format!("{}: timing {name}, {start} of {STARTS}", machine.title));
                let times = race(&mut servers, &name, rounds.div_ceil(STARTS), &mut reference)?;
                for (known, more) in known.iter_mut().zip(times) {
                    known.extend(more);
                }
            }
        }
        let cell = |times| Some(Cell { instructions: None, times: Some(times) });
        let rows = cases.iter().zip(&rounds_of).map(|(case, times)| {
            let cells = summary(times).into_iter().map(cell).collect();
            Row { case: *case, cells }
        });
        let rows = rows.collect();
        let contenders = programs.into_iter().map(|(contender, _)| contender).collect();
        let [kept, disturbed] = reference.rounds();
        let beside = |name| format!("{name}; {disturbed} of {kept} rounds beside a neighbour");
        let processor = processor().map(beside);
        Ok(Table { machine: *machine, contenders, rows, processor })
    }

    fn counts(
        &mut self,
        machine: &Machine,
        contenders: &[Contender],
        cases: &[Case],
    ) -> Result<Table, String> {
        let programs = self.programs(machine, contenders, cases)?;
        self.check(machine, &programs, cases)?;
        let names: Vec<String> = cases.iter().map(Case::name).collect();
        let mut columns = Vec::new();
        for (contender, program) in &programs {
            (self.say)(&format!("{}: counting {}", machine.title, contender.title()));
            let environment = contender.environment();
            columns.push(count::count(machine, program, &names, self.folder, environment)?);
        }
        let rows = cases
            .iter()
            .map(|case| {
                let cell = |column: &std::collections::BTreeMap<String, u64>| {
                    let instructions = column.get(&case.name()).copied();
                    instructions.map(|count| Cell { instructions: Some(count), times: None })
                };
                Row { case: *case, cells: columns.iter().map(cell).collect() }
            })
            .collect();
        let contenders = programs.into_iter().map(|(contender, _)| contender).collect();
        Ok(Table { machine: *machine, contenders, rows, processor: None })
    }

    /// Measures code size and stack of the generated kernels.
    fn sizes(&mut self, machine: &Machine, cases: &[Case]) {
        let kind = if cases.iter().any(|case| case.size > 20) { "chapter6" } else { "small" };
        let folder = self.folder.join(format!("{}-generated-{kind}", machine.name));
        let tool = if machine.target { "arm-linux-gnueabihf-size" } else { "size" };
        for name in cases.iter().flat_map(generated::kernels_of).map(|kernel| kernel.name()) {
            let object = folder.join(format!("{name}.o"));
            let known = |size: &Size| size.kernel == name && size.machine == machine.name;
            if self.results.sizes.iter().any(known) || !object.exists() {
                continue;
            }
            let output = std::process::Command::new(tool).arg(&object).output();
            let text = output.ok().and_then(|output| {
                let text = String::from_utf8_lossy(&output.stdout).into_owned();
                text.lines().nth(1)?.split_whitespace().next()?.parse().ok()
            });
            let usage = std::fs::read_to_string(object.with_extension("su")).unwrap_or_default();
            let stack =
                usage.lines().filter_map(|line| line.split('\t').nth(1)?.parse::<u64>().ok()).sum();
            if let Some(text) = text {
                self.results.sizes.push(Size { kernel: name, machine: machine.name, text, stack });
            }
        }
    }
}
