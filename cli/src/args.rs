//! The command line: the commands, their arguments, and the help texts.
//!
//! Invariant: only data and help texts; nothing is executed here.

mod campaign;

use std::path::PathBuf;

use clap::builder::styling::{AnsiColor, Styles};
use clap::{Args, Parser, Subcommand, ValueEnum};

pub use campaign::Campaign;

const STYLES: Styles = Styles::styled()
    .header(AnsiColor::Green.on_default().bold())
    .usage(AnsiColor::Green.on_default().bold())
    .literal(AnsiColor::Cyan.on_default().bold())
    .placeholder(AnsiColor::Cyan.on_default());

/// The command line of a cargo subcommand: cargo passes the subcommand's name as the first argument.
#[derive(Debug, Parser)]
#[command(name = "cargo", bin_name = "cargo", styles = STYLES)]
pub struct Arguments {
    #[command(subcommand)]
    cargo: Cargo,
}

#[derive(Debug, Subcommand)]
enum Cargo {
    /// Bessemer: controllers written in Rust, delivered as readable C99 that computes the same bits
    #[command(
        version,
        after_help = "\
First steps:
  cargo bessemer new motor    Begin a package with a small model, its test and a firmware stub
  cd motor
  cargo test                  Simulate it
  cargo bessemer gen          Write its C into generated/

It finds the package of models from any folder of the workspace. What it can be told about the C stands in
bessemer.toml, beside the package's Cargo.toml."
    )]
    Bessemer {
        #[command(subcommand)]
        task: Task,
    },
}

impl Arguments {
    /// The command that the user requested.
    pub fn task(self) -> Task {
        let Cargo::Bessemer { task } = self.cargo;
        task
    }
}

/// The commands.
#[derive(Debug, Subcommand)]
pub enum Task {
    /// Begin a package: a model, a closed-loop test, bessemer.toml, a firmware stub
    New(New),
    /// Compile the package's models to C
    Gen(Gen),
    /// Compare Rust, interpreter and C of each entry point, bit for bit
    Verify(Verify),
    /// Print what each entry point adds to a firmware: code, memory, stack and state
    Sizes(Sizes),
    /// List the checks for faults that are left in each entry point, and why
    Explain(Explain),
    /// Write the folder that a reviewer reads: trace, requirements, coverage, faults, estimated cost, evidence
    Dossier(Dossier),
    /// Show the Rust of a line of the C, or the C of a line of Rust
    Where(Where),
    /// Make a module of Python of the C, whose arrays are NumPy's
    Py(Python),
    /// Write an entry point as Rust that computes eight runs at once, in vectors, for simulations
    Vectors(Vectors),
    /// Make a folder of the C for a system that firmware is built in: Zephyr, PX4, ROS 2, FreeRTOS …
    Pack(Pack),
    /// Make a co-simulation unit (FMI 3.0) of an entry point or a component
    Fmu(Fmu),
    /// Run a simulation very many times by seed, here or on an engine, and summarise what went wrong
    Campaign(Box<Campaign>),
    /// Describe variables of a linked firmware in ASAP2, for measurement and calibration tools
    A2l(A2l),
    /// Check that this machine and this workspace have everything needed
    Doctor(Doctor),
}

/// Selection of the package.
#[derive(Args, Debug, Default)]
pub struct Package {
    /// The package of models, where the workspace has several
    #[arg(short, long, value_name = "NAME")]
    package: Option<String>,
}

impl Package {
    /// Selection of the package called `name`, if there is a name.
    pub(crate) fn of(name: Option<&str>) -> Package {
        Package { package: name.map(str::to_owned) }
    }

    /// Name of the package, if set.
    pub fn name(&self) -> Option<&str> {
        self.package.as_deref()
    }
}

/// Arguments of `new`.
#[derive(Args, Debug)]
#[command(after_help = "\
Examples:
  cargo bessemer new motor                     A folder motor/, which depends on Bessemer's repository
  cargo bessemer new motor --path ../bessemer  The same, on a checkout of it
  cargo bessemer new axis --template drive     Two components and their plant: a loop of speed around a loop of current")]
pub struct New {
    /// The name of the package and of its folder
    pub name: String,
    /// The model to begin with; without it, one component
    #[arg(long, value_enum)]
    pub template: Option<Template>,
    /// A checkout of Bessemer to depend on, in place of its repository
    #[arg(long, value_name = "FOLDER")]
    pub path: Option<PathBuf>,
    /// Another repository to depend on
    #[arg(long, value_name = "URL", conflicts_with = "path")]
    pub git: Option<String>,
}

/// A model of two components, with the test of both around their plant.
#[derive(clap::ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
pub enum Template {
    /// A DC motor: a loop of speed around a loop of current
    Drive,
    /// Height and climb from accelerometer and barometer, and a monitor of the barometer
    Estimator,
    /// A vehicle: its speed and its lane, simulated by bessemer-sim with noisy sensors and a hill
    Vehicle,
}

/// Arguments of `gen`.
#[derive(Args, Debug)]
#[command(after_help = "\
Examples:
  cargo bessemer gen            Bring the C up to date
  cargo bessemer gen --check    Fail, with a diff, if it is stale; for your CI
  cargo bessemer gen --explain  Also list the checks that are left in each entry point, and why

Needs Rust, nothing else. The output is written whole or not at all.")]
pub struct Gen {
    /// Selection of the package
    #[command(flatten)]
    pub package: Package,
    /// Compare instead of writing
    #[arg(long)]
    pub check: bool,
    /// Also list the checks that are left in each entry point, and why
    #[arg(long)]
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

/// Arguments of `verify`.
#[derive(Args, Debug, Default)]
#[command(after_help = "\
Examples:
  cargo bessemer verify                     Edge values, small numbers, and those around the code's own, on each leg
  cargo bessemer verify --seed 7            Others
  cargo bessemer verify --inputs flight.csv --entry Motor::step
                                            Recorded inputs of one entry point, row by row
  cargo bessemer verify --inputs flight.ulg --outputs replayed.csv
                                            A flight log, as bessemer.toml maps it, and what the controller answers to it
  cargo bessemer verify --target zynq --target cortex-m4f
                                            Also the C on emulated processors, and what it costs there:
                                            instructions, stack, size, held to the limits of bessemer.toml
  cargo bessemer verify --board firmware/verify
                                            Write what a board's firmware is built from that answers the next
  cargo bessemer verify --serial /dev/ttyUSB0 --baud 921600
                                            Also the C on that board, call by call over its serial line

The C is compiled by gcc and clang at -O0, -O2 and -O3, whichever are there. Exit code 1 if a word differs.")]
pub struct Verify {
    /// Selection of the package
    #[command(flatten)]
    pub package: Package,
    /// Seed of the values
    #[arg(long, value_name = "S", default_value_t = 0)]
    pub seed: u64,
    /// Also on this processor, emulated by QEMU
    #[arg(long, value_enum)]
    pub target: Vec<Target>,
    /// Write the sources of a firmware that answers `--serial` into this folder, and do nothing else
    #[arg(long, value_name = "FOLDER", conflicts_with_all = ["serial", "target", "inputs"])]
    pub board: Option<PathBuf>,
    /// Also verify on the board at this serial port, with firmware built from the output of `--board`
    #[arg(long, value_name = "PORT")]
    pub serial: Vec<PathBuf>,
    /// The speed of the port, bits a second
    #[arg(long, value_name = "SPEED", default_value_t = 115_200, requires = "serial")]
    pub baud: u32,
    /// Recorded inputs in place of generated ones: CSV, MCAP, or a log of PX4, ArduPilot or Betaflight
    ///
    /// CSV has a column for each input number, such as `gains.p`; MCAP has messages in JSON; bessemer.toml maps the topics of a log.
    #[arg(long, value_name = "FILE")]
    pub inputs: Option<PathBuf>,
    /// The entry point that was recorded, where there are several: `Motor::step`, or `motor_step` as in the C
    #[arg(long, value_name = "NAME", requires = "inputs")]
    pub entry: Option<String>,
    /// Also write the recorded calls with their results and states into this file, as CSV
    #[arg(long, value_name = "FILE", requires = "inputs")]
    pub outputs: Option<PathBuf>,
}

/// Arguments of `sizes`.
#[derive(Args, Debug, Default)]
#[command(after_help = "\
Examples:
  cargo bessemer sizes                        For this machine, by gcc -O2
  cargo bessemer sizes --target cortex-m4f    For another one, by its gcc

An entry point brings what it calls; two of them share what both bring. The C library is not in it. Stack and state are
the bounds that `gen` reports.")]
pub struct Sizes {
    /// Selection of the package
    #[command(flatten)]
    pub package: Package,
    /// For this processor, in place of this machine's
    #[arg(long, value_enum)]
    pub target: Vec<Target>,
}

/// A processor that QEMU emulates.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Target {
    /// ARM of 32 bits, as in a Zynq, with VFPv3, under Linux
    CortexA9,
    /// A Zynq (Cortex-A9) without an operating system
    Zynq,
    /// A microcontroller with single precision in hardware
    CortexM4f,
    /// A microcontroller with double precision in hardware
    CortexM7,
    /// ARM of 64 bits
    Aarch64,
    /// RISC-V of 32 bits with double precision in hardware, without an operating system
    Riscv32,
    /// RISC-V of 64 bits
    Riscv64,
    /// Big-endian
    S390x,
}

/// Arguments of `explain`.
#[derive(Args, Debug)]
#[command(after_help = "\
Examples:
  cargo bessemer explain              Each entry point
  cargo bessemer explain motor_step   One, by its name in the C or in the Rust")]
pub struct Explain {
    /// Selection of the package
    #[command(flatten)]
    pub package: Package,
    /// An entry point: `motor_step` or `Motor::step`
    pub entry: Option<String>,
}

/// Arguments of `dossier`.
#[derive(Args, Debug)]
#[command(after_help = "\
Examples:
  cargo bessemer dossier                              dossier/: open dossier/index.html
  cargo bessemer dossier --requirements hlr.csv       With the texts of the requirements that the sources name
  cargo bessemer dossier --inputs Motor::step=log.csv --fill 100
                                                      Coverage also by a recording, and by a search
  cargo bessemer dossier --tests sim                  Coverage also by the calls that the tests of `sim` record
  cargo bessemer dossier --since v1.0                 Also what of the C changed since a tag, and what to test again
  cargo bessemer dossier --check dossier              Is it of these sources? Compares hashes, and builds nothing

It runs the package's tests, `verify`, an instrumented copy of the C, and the compilers that are installed. What cannot
be run is in it with the reason. The folder needs no network, and the same sources give the same bytes. Items and tests
name their requirements: `#[requirement(\"HLR-12\")]`. Exit code 1 if a check failed.")]
pub struct Dossier {
    /// Selection of the package
    #[command(flatten)]
    pub package: Package,
    /// The folder to write; an earlier dossier in it is replaced
    #[arg(long, value_name = "FOLDER", default_value = "dossier")]
    pub output: PathBuf,
    /// Compare this dossier with the sources, and write nothing
    #[arg(long, value_name = "FOLDER", conflicts_with_all = ["requirements", "inputs", "since", "quick", "tests", "reasons", "fill"])]
    pub check: Option<PathBuf>,
    /// The list of requirements: CSV with the columns `id` and `text`, or ReqIF [default: requirements.csv or
    /// requirements.reqif beside the package's Cargo.toml]
    #[arg(long, value_name = "FILE")]
    pub requirements: Option<PathBuf>,
    /// Recorded inputs for the coverage: an entry point and a file as `verify --inputs` takes it
    #[arg(long, value_name = "ENTRY=FILE")]
    pub inputs: Vec<String>,
    /// Also run the tests of this package of the workspace, such as one that simulates the models
    #[arg(long, value_name = "PACKAGE")]
    pub tests: Vec<String>,
    /// Reasons why conditions and statements need no further test: CSV with the columns `function`, `code` and `reason`
    /// [default: coverage.csv beside the package's Cargo.toml]
    #[arg(long, value_name = "FILE")]
    pub reasons: Option<PathBuf>,
    /// Search for calls that raise the coverage, in this number of rounds
    #[arg(long, value_name = "ROUNDS", default_value_t = 0)]
    pub fill: u64,
    /// Also list the changes of the C since this tag or commit, in which the C is committed
    #[arg(long, value_name = "TAG")]
    pub since: Option<String>,
    /// Run nothing: no tests, no comparison, no coverage, no sizes
    #[arg(long)]
    pub quick: bool,
}

/// Arguments of `where`.
#[derive(Args, Debug)]
#[command(after_help = "\
Examples:
  cargo bessemer where generated/motor.c:40   The Rust that this line comes from, and names that only the C has
  cargo bessemer where src/lib.rs:31          Each line of C that comes from this one

It reads the folder of the C with the .map file beside each file, as `gen` wrote them, and builds nothing. A path may be
any end of it, such as motor.c:40. A line of a longer statement means the whole statement.")]
pub struct Where {
    /// Selection of the package
    #[command(flatten)]
    pub package: Package,
    /// The file and the line, as compilers print them: `generated/motor.c:40`
    #[arg(value_name = "FILE:LINE")]
    pub line: String,
}

/// Arguments of `py`.
#[derive(Args, Debug)]
#[command(after_help = "\
Examples:
  cargo bessemer py                    python/motor/, to be imported with PYTHONPATH=python
  cargo bessemer py --output build/py  The same elsewhere

Needs gcc or clang; the module needs NumPy.")]
pub struct Python {
    /// Selection of the package
    #[command(flatten)]
    pub package: Package,
    /// The folder that the module's own is made in
    #[arg(long, value_name = "FOLDER", default_value = "python")]
    pub output: PathBuf,
}

/// Arguments of `vectors`.
#[derive(Args, Debug)]
#[command(after_help = "\
Examples:
  cargo bessemer vectors                                      The package's only entry point, in src/eight.in
  cargo bessemer vectors Motor::step --output sim/src/motor.in  One of several, elsewhere

The entry point has to be `infallible`. The simulation needs bessemer-lanes, and is faster where it is compiled for the processor:
RUSTFLAGS='-C target-cpu=native'. Each run has the bits of the run alone.")]
pub struct Vectors {
    /// Selection of the package
    #[command(flatten)]
    pub package: Package,
    /// The entry point, such as `Motor::step`, where the package has several
    pub entry: Option<String>,
    /// The file
    #[arg(long, value_name = "FILE", default_value = "src/eight.in")]
    pub output: PathBuf,
}

/// Arguments of `pack`.
#[derive(Args, Debug)]
#[command(after_help = "\
Examples:
  cargo bessemer pack zephyr     pack/motor/: a module with Kconfig, CMake and an example of each entry point
  cargo bessemer pack px4        pack/motor/: a module around each component, with its messages of uORB
  cargo bessemer pack ros2       pack/motor/: a node around each component, and a package of its messages

The folder is whole by itself: copy it to where the system looks for it.")]
pub struct Pack {
    /// Selection of the package
    #[command(flatten)]
    pub package: Package,
    /// The system
    #[arg(value_enum)]
    pub system: System,
    /// The folder that the package's own is made in
    #[arg(long, value_name = "FOLDER", default_value = "pack")]
    pub output: PathBuf,
}

/// A system that firmware is built in.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum System {
    /// A module, by `zephyr/module.yml`
    Zephyr,
    /// Modules on work queues, for `src/modules`
    Px4,
    /// A library of classes, for `libraries`
    #[value(name = "ardupilot")]
    ArduPilot,
    /// Components of F´ with ports, by FPP
    #[value(name = "fprime")]
    FPrime,
    /// An application of NASA's core Flight System
    Cfs,
    /// Nodes of ROS 2, and a package of their messages
    Ros2,
    /// Nodes of micro-ROS, and a package of their messages
    MicroRos,
    /// Periodic tasks, in memory of their own
    #[value(name = "freertos")]
    FreeRtos,
    /// A library, by `library.properties`
    Arduino,
    /// A library, by `library.json`
    #[value(name = "platformio")]
    PlatformIo,
    /// A component, by `idf_component.yml`
    EspIdf,
    /// A software pack, by `.pdsc`
    CmsisPack,
}

/// Arguments of `fmu`.
#[derive(Args, Debug)]
#[command(after_help = "\
Examples:
  cargo bessemer fmu --period 0.001                      fmu/motor_step.fmu
  cargo bessemer fmu --entry Motor::step --period 0.001  One of several entry points
  cargo bessemer fmu --entry Estimator                   All entry points of a component, by [periods] of bessemer.toml

It has the C and a library for this machine. Data with a `…_defaults()` becomes parameters, what else goes in inputs; a
step of the simulation is a whole number of periods. Needs gcc or clang.")]
pub struct Fmu {
    /// Selection of the package
    #[command(flatten)]
    pub package: Package,
    /// The entry point, or the component whose entry points share the unit: `Motor::step`, `Estimator`
    #[arg(long, value_name = "NAME")]
    pub entry: Option<String>,
    /// The time between two calls, s; without it, as `[periods]` of bessemer.toml has it
    #[arg(long, value_name = "SECONDS")]
    pub period: Option<f64>,
    /// The folder that the unit is made in
    #[arg(long, value_name = "FOLDER", default_value = "fmu")]
    pub output: PathBuf,
}

/// Arguments of `a2l`.
#[derive(Args, Debug)]
#[command(after_help = "\
Example:
  cargo bessemer a2l build/firmware.elf controller=motor_t gains=gains_t > firmware.a2l

The fields of components become measurements, those of other data characteristics, with the limits that `#[range(…)]` sets.")]
pub struct A2l {
    /// Selection of the package
    #[command(flatten)]
    pub package: Package,
    /// The linked firmware, an ELF with its symbols
    pub elf: PathBuf,
    /// Variables of the firmware, each with its type in the C: `controller=motor_t`
    #[arg(required = true, value_name = "VARIABLE=TYPE")]
    pub variables: Vec<String>,
}

/// Arguments of `doctor`.
#[derive(Args, Debug)]
pub struct Doctor {
    /// Selection of the package
    #[command(flatten)]
    pub package: Package,
}

#[cfg(test)]
mod tests {
    use super::*;
    use clap::CommandFactory;
    use clap::error::ErrorKind;

    fn parse(line: &[&str]) -> Result<Task, ErrorKind> {
        let words = ["cargo", "bessemer"].iter().chain(line);
        Arguments::try_parse_from(words).map(Arguments::task).map_err(|error| error.kind())
    }

    #[test]
    fn the_definition_is_sound() {
        Arguments::command().debug_assert();
    }

    #[test]
    fn what_is_asked_is_read() {
        assert!(matches!(parse(&["gen"]), Ok(Task::Gen(Gen { check: false, .. }))));
        let gen_ = parse(&["gen", "--check", "-p", "models"]);
        assert!(
            matches!(gen_, Ok(Task::Gen(it)) if it.check && it.package.name() == Some("models"))
        );
        assert!(matches!(parse(&["new", "motor"]), Ok(Task::New(it)) if it.name == "motor"));
        assert!(
            matches!(parse(&["explain", "motor_step"]), Ok(Task::Explain(it)) if it.entry.is_some())
        );
        let dossier = parse(&["dossier", "--quick", "--inputs", "Motor::step=a.csv"]);
        assert!(matches!(dossier, Ok(Task::Dossier(it)) if it.quick && it.inputs.len() == 1));
        assert_eq!(
            parse(&["dossier", "--check", "a", "--quick"]).err(),
            Some(ErrorKind::ArgumentConflict)
        );
        assert!(matches!(parse(&["where", "a.c:7"]), Ok(Task::Where(it)) if it.line == "a.c:7"));
        assert!(matches!(parse(&["verify", "--seed", "7"]), Ok(Task::Verify(it)) if it.seed == 7));
        let arm = parse(&["verify", "--target", "cortex-a9"]);
        assert!(matches!(arm, Ok(Task::Verify(it)) if it.target == [Target::CortexA9]));
        let board = parse(&["verify", "--serial", "/dev/ttyS0", "--baud", "9600"]);
        assert!(matches!(board, Ok(Task::Verify(it)) if it.baud == 9600));
        let sizes = parse(&["sizes", "--target", "zynq"]);
        assert!(matches!(sizes, Ok(Task::Sizes(it)) if it.target == [Target::Zynq]));
        let campaign = parse(&["campaign", "--merge", "a.csv", "b.csv"]);
        assert!(matches!(campaign, Ok(Task::Campaign(it)) if it.merge.len() == 2));
        assert!(matches!(parse(&["doctor"]), Ok(Task::Doctor(_))));
    }

    /// Each line with `cargo bessemer` in the book, the README and the templates is a command that there is.
    #[test]
    fn what_the_book_shows_is_read() {
        let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
        let book = std::fs::read_dir(root.join("docs/book")).expect("the book").flatten();
        let pages = ["README.md", "cli/templates/README.md"].map(|name| root.join(name));
        let mut lines = 0;
        for page in book.map(|it| it.path()).filter(|it| it.is_file()).chain(pages) {
            let text = std::fs::read_to_string(&page).expect("a page");
            for line in text.lines().map(str::trim) {
                let commands =
                    line.split(" && ").filter_map(|it| it.strip_prefix("cargo bessemer"));
                for command in commands {
                    let words = command.split(['#', '>']).next().unwrap_or_default();
                    let words: Vec<&str> = words.split_whitespace().collect();
                    assert!(parse(&words).is_ok(), "{}: {line}", page.display());
                    lines += 1;
                }
            }
        }
        assert!(lines >= 20, "{lines} commands");
    }

    #[test]
    fn nonsense_is_refused() {
        assert_eq!(parse(&["gne"]).err(), Some(ErrorKind::InvalidSubcommand));
        assert_eq!(parse(&["verify", "--target", "z80"]).err(), Some(ErrorKind::InvalidValue));
        assert_eq!(parse(&["new"]).err(), Some(ErrorKind::MissingRequiredArgument));
        assert_eq!(parse(&["gen", "--chekc"]).err(), Some(ErrorKind::UnknownArgument));
        let alone = ["verify", "--baud", "9600"];
        assert_eq!(parse(&alone).err(), Some(ErrorKind::MissingRequiredArgument));
        let both = ["new", "m", "--path", "a", "--git", "b"];
        assert_eq!(parse(&both).err(), Some(ErrorKind::ArgumentConflict));
    }

    #[test]
    fn every_command_has_help() {
        let mut command = Arguments::command();
        let bessemer = command.find_subcommand_mut("bessemer").expect("the command");
        for command in bessemer.get_subcommands() {
            assert!(command.get_about().is_some(), "{} has no help", command.get_name());
        }
    }
}
