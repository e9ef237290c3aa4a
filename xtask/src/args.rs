//! The command line: the commands, their arguments, and the help texts.
//!
//! Invariant: only data and help texts; nothing is executed here.

use clap::builder::styling::{AnsiColor, Styles};
use clap::{Args, Parser, Subcommand};
use std::num::NonZeroUsize;

const STYLES: Styles = Styles::styled()
    .header(AnsiColor::Green.on_default().bold())
    .usage(AnsiColor::Green.on_default().bold())
    .literal(AnsiColor::Cyan.on_default().bold())
    .placeholder(AnsiColor::Cyan.on_default());

const EXAMPLES: &str = "\
First steps:
  cargo xtask gen               Write the C of every model into generated/
  cargo xtask test --install    Install what the tests need, then run all of them

What needs what:
  gen       Rust, nothing else
  test      also rustfmt and clippy, gcc, g++ and clang; for the ARM part
            arm-linux-gnueabihf-gcc and qemu-arm; to look at the C again frama-c
            and cppcheck
  test --host
            the same without the ARM part, frama-c and cppcheck
  book      mdBook: `cargo install mdbook`
  doctor    nothing: it tells what is there and what is missing

Plain `cargo test` works too: it runs what needs no cross tools.";

/// Bessemer: controllers written in Rust, delivered as readable C99 that computes the same bits.
#[derive(Debug, Parser)]
#[command(name = "cargo xtask", bin_name = "cargo xtask", version, styles = STYLES, after_help = EXAMPLES)]
pub struct Arguments {
    /// The command.
    #[command(subcommand)]
    pub task: Task,
}

/// The commands.
#[derive(Debug, Subcommand)]
pub enum Task {
    /// Compile every model in models/ to C, into generated/
    Gen(Gen),
    /// Run everything that must pass: format, lints, freshness of generated/, all tests
    Test(Test),
    /// Break the compiler in small ways, and show that the tests tell
    Mutate(Mutate),
    /// Run random programs through everything: Rust, interpreter, C; most aim at the proofs
    Fuzz(Fuzz),
    /// List the tools that are there and those that are missing
    Doctor(Doctor),
    /// Measure the generated C against its peers
    Bench(Bench),
    /// Make C of crates of other authors, and compare the bits
    Crates(Crates),
    /// Make searchable pages of the book, by mdBook, into target/book/
    Book,
    /// The simulation's commands: `sim`, `identify`, `campaign`
    #[command(flatten)]
    Simulation(sim_args::Task),
    /// The ground station's commands: `fly`, `replay`
    #[command(flatten)]
    Ground(ground_args::Task),
}

/// Arguments of `gen`.
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  cargo xtask gen            Bring generated/ up to date
  cargo xtask gen --check    Fail, with a diff, if generated/ is stale
  cargo xtask gen --explain  Also list the checks that are left in each entry point, and why
  cargo xtask gen --check --message-format json
                             What an editor runs to show mistakes where one types (docs/workspace.md)

Needs Rust, nothing else. The output is written whole or not at all.")]
pub struct Gen {
    /// Write nothing; fail with a diff if the committed C is stale
    #[arg(long)]
    pub check: bool,
    /// List the checks that are left in each entry point: line, fault, and why it could not be ruled out
    #[arg(long, conflicts_with = "check")]
    pub explain: bool,
    /// Format of errors and warnings: for people, or one JSON object per line for editors, as rustc writes it
    #[arg(long, value_enum, default_value_t = MessageFormat::Human, value_name = "FORMAT")]
    pub message_format: MessageFormat,
}

/// For whom errors and warnings are reported.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub enum MessageFormat {
    /// For people, on standard error.
    Human,
    /// For editors, on standard output.
    Json,
}

/// Mode of the generation: write or compare.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Mode {
    /// Bring the output up to date.
    Write,
    /// Compare, and fail if the output is stale.
    Check,
}

impl Gen {
    /// The choice of a run of the tests.
    pub const CHECK: Gen =
        Gen { check: true, explain: false, message_format: MessageFormat::Human };

    /// The mode that the flags choose.
    #[must_use]
    pub fn mode(&self) -> Mode {
        if self.check { Mode::Check } else { Mode::Write }
    }
}

/// Arguments of `test`.
#[derive(Debug, Default, Args)]
#[command(after_help = "\
Examples:
  cargo xtask test              Run everything; if a tool is missing, print the line that installs it, and fail
  cargo xtask test --install    The same, but install what is missing first (apt, as root or through sudo)
  cargo xtask test --host       Leave out what runs on the emulated Cortex-A9
  cargo xtask test --quick      What to run at each step: only the tests that take no time
  cargo xtask test --full       Every leg, compiler and size; without it, commits take turns at the dear ones

Stages: format, gen --check, lints and build, tests (those of the documentation beside them). The first that fails ends the run.
The tests learn what to run from the environment: BESSEMER_LEGS is `all`, or `host` with --host; BESSEMER_FULL is set
with --full; without it BESSEMER_TURN is a number that the commit chooses.")]
pub struct Test {
    /// Install missing tools first, with apt-get (as root or through sudo) and rustup
    #[arg(long)]
    pub install: bool,
    /// Leave out the ARM part: neither the cross compiler nor QEMU is needed
    #[arg(long)]
    pub host: bool,
    /// Leave out the documentation tests, and the tests that used over 1 s of the processors in the stored run
    #[arg(long, conflicts_with = "full")]
    pub quick: bool,
    /// Leave nothing out: every leg, compiler, size and seed
    #[arg(long)]
    pub full: bool,
    /// Store the times of this run, with which later runs are compared
    #[arg(long)]
    pub store_times: bool,
}

/// Arguments of `mutate`.
#[derive(Debug, Default, Args)]
#[command(
    arg_required_else_help = true,
    after_help = "\
Examples:
  cargo xtask mutate --all                 Every mutant in tests/mutants/ (four minutes)
  cargo xtask mutate c_negative_zero_lost  One of them
  cargo xtask mutate --turn 3 --of 30      The third of thirty parts

A mutant is a patch as `git apply` takes it: drop the output of `git diff` into tests/mutants/, below a line that
says what is broken and, if it is known, the test that finds it (`killed-by: cargo test …`). It is tried in a copy of the
work tree, under target/mutants/. Exit code 1 if one survives, does not compile, or is found by another test."
)]
pub struct Mutate {
    /// The mutants to try: names of patches, without the ending
    #[arg(required_unless_present_any = ["all", "turn"], conflicts_with_all = ["all", "turn"])]
    pub names: Vec<String>,
    /// Every mutant
    #[arg(long, conflicts_with = "turn")]
    pub all: bool,
    /// One part of them, from 1
    #[arg(long, value_name = "N", requires = "of")]
    pub turn: Option<NonZeroUsize>,
    /// Number of parts
    #[arg(long, value_name = "M", requires = "turn")]
    pub of: Option<NonZeroUsize>,
    /// Print JSON instead of lines
    #[arg(long)]
    pub json: bool,
}

/// Arguments of `fuzz`.
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  cargo xtask fuzz                             A thousand programs
  cargo xtask fuzz --programs 100000 --seed 7  As many as are asked for, from another seed

Each program is called a hundred times: what rustc makes of it, the interpreter before and after the passes, with the
checks that were left out, and the C of gcc and clang must agree to the bit. After each batch a line says how far it is
and how fast; at the end stands how often each rule of the proofs decided something. A program that differs is made
small and written to tests/found/, from where every run of the tests takes it. Exit code 1 if one differs.")]
pub struct Fuzz {
    /// Number of programs
    #[arg(long, value_name = "N", default_value_t = 1000)]
    pub programs: u64,
    /// The first seed; a batch has one
    #[arg(long, value_name = "S", default_value_t = 0)]
    pub seed: u64,
}

/// Arguments of `doctor`.
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  cargo xtask doctor           A table, and the one line that installs what is missing
  cargo xtask doctor --json    The same for a program

Exit code 1 if something that `cargo xtask test` needs is missing.")]
pub struct Doctor {
    /// Print JSON instead of a table
    #[arg(long)]
    pub json: bool,
}

/// Arguments of `bench`.
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  cargo xtask bench                   Measure everything and write bench/results/ (half an hour)
  cargo xtask bench --only kernels    Only the generated linear algebra against its peers
  cargo xtask bench --only check-cost Only what the attributes cost; also rebuild, generation, elementary
  cargo xtask bench --only equality   The elementary functions on 10 million points each, on every leg
  cargo xtask bench --quick           A few sizes, Chapter 6 on the host and the Cortex-A9; writes nothing
  cargo xtask bench --install         Install missing tools first (apt, as root or through sudo)

Times are of this machine as busy as it is; instruction counts are exact. nalgebra on the Cortex-A9 needs
`rustup target add armv7-unknown-linux-gnueabihf`, and is left out without it.")]
pub struct Bench {
    /// Measure the short list only, and write nothing
    #[arg(long)]
    pub quick: bool,
    /// Only this part: kernels, threads, elementary, check-cost, rebuild, generation, long, shapes, onboard,
    /// dsp, ekf, gradient, qp, equality, accuracy-points
    #[arg(long)]
    pub only: Option<String>,
    /// Only these machines of `kernels`, such as a9,host-v3: the others keep their previous results
    #[arg(long)]
    pub machines: Option<String>,
    /// The small sizes for `kernels`, such as 2,3,4,6,8; all of 2 to 20 take a compiler most of an hour
    #[arg(long)]
    pub sizes: Option<String>,
    /// Only the instructions of `kernels`, which a busy machine does not disturb; write nothing
    #[arg(long)]
    pub counts: bool,
    /// Points of each function for `equality` and `accuracy-points`
    #[arg(long)]
    pub points: Option<u32>,
    /// Folder with the repositories `CMSIS-DSP` and `TinyMPC`, for `dsp` and `qp`
    #[arg(long)]
    pub peers: Option<String>,
    /// Install missing tools first, with apt-get (as root or through sudo)
    #[arg(long)]
    pub install: bool,
}

/// Arguments of `crates`.
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  cargo xtask crates                  Try all twenty, and write bench/results/crates.json and docs/crates.md
  cargo xtask crates pid --verbose    Only this one, with all errors
  cargo xtask crates pid --dry        Write nothing

cargo fetches the sources by exact version into target/crates/, and finds the attributes in bench/crates/. Needs gcc.")]
pub struct Crates {
    /// Only these crates; the others keep their previous results
    pub names: Vec<String>,
    /// Print all errors of a crate that does not become C
    #[arg(long)]
    pub verbose: bool,
    /// Write nothing
    #[arg(long)]
    pub dry: bool,
}

#[cfg(test)]
mod tests {
    use super::*;
    use clap::CommandFactory;

    fn parse(line: &[&str]) -> Result<Task, clap::error::ErrorKind> {
        let words = std::iter::once("cargo xtask").chain(line.iter().copied());
        Arguments::try_parse_from(words)
            .map(|arguments| arguments.task)
            .map_err(|error| error.kind())
    }

    #[test]
    fn the_definition_is_sound() {
        Arguments::command().debug_assert();
    }

    #[test]
    fn gen_writes_unless_told_to_check() {
        assert!(matches!(parse(&["gen"]), Ok(Task::Gen(wanted)) if wanted.mode() == Mode::Write));
        assert!(
            matches!(parse(&["gen", "--check"]), Ok(Task::Gen(wanted)) if wanted.mode() == Mode::Check)
        );
    }

    #[test]
    fn gen_tells_people_unless_told_otherwise() {
        let format = |line: &[&str]| match parse(line) {
            Ok(Task::Gen(wanted)) => Some(wanted.message_format),
            _ => None,
        };
        assert_eq!(format(&["gen"]), Some(MessageFormat::Human));
        let json = ["gen", "--check", "--message-format", "json"];
        assert_eq!(format(&json), Some(MessageFormat::Json));
        assert_eq!(format(&["gen", "--message-format", "xml"]), None);
    }

    #[test]
    fn test_installs_nothing_unless_told() {
        let flags = |line: &[&str]| match parse(line) {
            Ok(Task::Test(it)) => (it.install, it.host, it.quick, it.full),
            _ => panic!("{line:?} is no test"),
        };
        assert_eq!(flags(&["test"]), (false, false, false, false));
        assert_eq!(flags(&["test", "--install"]), (true, false, false, false));
        assert_eq!(flags(&["test", "--host", "--quick"]), (false, true, true, false));
        assert_eq!(flags(&["test", "--install", "--full"]), (true, false, false, true));
        assert!(parse(&["test", "--quick", "--full"]).is_err());
    }

    #[test]
    fn the_rest_is_read() {
        assert!(matches!(parse(&["doctor", "--json"]), Ok(Task::Doctor(Doctor { json: true }))));
        assert!(matches!(parse(&["bench", "--quick"]), Ok(Task::Bench(Bench { quick: true, .. }))));
        assert!(matches!(parse(&["book"]), Ok(Task::Book)));
        assert!(matches!(
            parse(&["crates", "pid", "--dry"]),
            Ok(Task::Crates(Crates { dry: true, .. }))
        ));
        assert!(matches!(parse(&["sim"]), Ok(Task::Simulation(_))));
        assert!(matches!(parse(&["sim", "hover", "--c"]), Ok(Task::Simulation(_))));
        assert!(matches!(parse(&["fly", "--headless"]), Ok(Task::Ground(_))));
        assert!(matches!(parse(&["replay", "f.mcap"]), Ok(Task::Ground(_))));
    }

    /// By the same definitions as the programs have, without building them.
    #[test]
    fn simulation_and_ground_station_are_helped_and_refused_here() {
        use clap::error::ErrorKind;
        for command in ["sim", "identify", "campaign", "fly", "replay"] {
            assert_eq!(parse(&[command, "--help"]).err(), Some(ErrorKind::DisplayHelp));
            assert_eq!(parse(&[command, "--sed", "1"]).err(), Some(ErrorKind::UnknownArgument));
        }
        assert_eq!(parse(&["campaign", "spred"]).err(), Some(ErrorKind::InvalidValue));
        assert_eq!(parse(&["fly", "--loss", "101%"]).err(), Some(ErrorKind::ValueValidation));
    }

    #[test]
    fn mutate_is_told_which() {
        use clap::error::ErrorKind;
        let mutate = |rest: &[&str]| match parse(&[&["mutate"], rest].concat()) {
            Ok(Task::Mutate(wanted)) => Ok(wanted),
            Ok(_) => Err(ErrorKind::Format),
            Err(kind) => Err(kind),
        };
        assert!(mutate(&["a", "b"]).is_ok_and(|it| it.names == ["a", "b"] && !it.all));
        assert!(mutate(&["--all", "--json"]).is_ok_and(|it| it.all && it.json));
        assert!(mutate(&["--turn", "1", "--of", "2"]).is_ok_and(|it| it.turn.is_some()));
        for wrong in [&["--json"][..], &["--turn", "1"], &["--of", "2"]] {
            assert_eq!(mutate(wrong).err(), Some(ErrorKind::MissingRequiredArgument), "{wrong:?}");
        }
        for wrong in [&["a", "--all"][..], &["--all", "--turn", "1", "--of", "2"]] {
            assert_eq!(mutate(wrong).err(), Some(ErrorKind::ArgumentConflict), "{wrong:?}");
        }
        let zero = mutate(&["--turn", "0", "--of", "2"]);
        assert_eq!(zero.err(), Some(ErrorKind::ValueValidation));
    }

    #[test]
    fn fuzz_takes_numbers() {
        let fuzz = |rest: &[&str]| match parse(&[&["fuzz"], rest].concat()) {
            Ok(Task::Fuzz(wanted)) => Some((wanted.programs, wanted.seed)),
            _ => None,
        };
        assert_eq!(fuzz(&[]), Some((1000, 0)));
        assert_eq!(fuzz(&["--programs", "5", "--seed", "9"]), Some((5, 9)));
        assert_eq!(fuzz(&["--programs", "many"]), None);
    }

    #[test]
    fn nonsense_is_refused() {
        use clap::error::ErrorKind;
        assert_eq!(parse(&["tset"]).err(), Some(ErrorKind::InvalidSubcommand));
        assert_eq!(parse(&["gen", "--install"]).err(), Some(ErrorKind::UnknownArgument));
        assert_eq!(parse(&[]).err(), Some(ErrorKind::DisplayHelpOnMissingArgumentOrSubcommand));
    }

    #[test]
    fn every_command_has_help() {
        for command in Arguments::command().get_subcommands() {
            assert!(command.get_about().is_some(), "{} has no help", command.get_name());
        }
    }
}
