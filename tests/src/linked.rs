//! Runs the flight software as rustc compiles it for other processors (`bench/linked/`), under emulation and in wasmtime.
//!
//! Must not know: the C that the generator emits.

use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use bessemer::Plain as _;
use models::{Height, Inputs, Outputs, Settings};
use sim::computer::{Computer, Native};
use sim::flights::find;
use sim::voyage::fly;

use crate::toolchain::{self, Toolchain, run};
use crate::{harness, root, watch, words};

/// A microcontroller without floating-point unit. Its machine has a Cortex-M3, which executes the instructions of a Cortex-M0.
const CORTEX_M0: Toolchain = Toolchain {
    machine: &[
        "-mcpu=cortex-m0",
        "-mthumb",
        "-mfloat-abi=soft",
        "--specs=rdimon.specs",
        "-Wl,--section-start=.vectors=0",
    ],
    emulator: Some(&[
        "qemu-system-arm",
        "-machine",
        "mps2-an385",
        "-display",
        "none",
        "-monitor",
        "none",
        "-semihosting-config",
        "enable=on,target=native",
        "-kernel",
    ]),
    ..toolchain::CORTEX_M4F
};

/// RISC-V of 32 bits without floating-point unit.
const RISCV32: Toolchain =
    Toolchain { more: &["-march=rv32imac", "-mabi=ilp32"], ..toolchain::RISCV32 };

/// Targets of rustc with the compiler of the program around its library, and the processor that runs it.
pub const PROCESSORS: [(&str, Toolchain); 4] = [
    ("armv7-unknown-linux-gnueabihf", toolchain::ARM),
    ("thumbv7em-none-eabihf", toolchain::CORTEX_M4F),
    ("thumbv6m-none-eabi", CORTEX_M0),
    ("riscv32imac-unknown-none-elf", RISCV32),
];

/// The target of WebAssembly.
pub const WASM: &str = "wasm32-unknown-unknown";

/// Stack of the WebAssembly, bytes: rustc's own is a megabyte.
const STACK: u32 = 16_384;

/// A flight of the models, recorded: words of each period.
#[derive(Default)]
pub struct Flight {
    models: Native,
    height: Height,
    /// Words of settings and inputs.
    pub arguments: Vec<u64>,
    /// Words of outputs, states and the thrust that the height control commands.
    pub results: Vec<u64>,
    /// Words of the height control's arguments.
    pub heights: Vec<u64>,
}

impl Flight {
    /// Flies a flight, or its first `longest` seconds.
    ///
    /// # Errors
    /// The name of a flight that does not exist.
    pub fn of(name: &str, longest: f64) -> Result<Flight, String> {
        let flight = find(name).ok_or_else(|| format!("there is no flight `{name}`"))?;
        let mut scenario = (flight.scenario)(1);
        scenario.duration = scenario.duration.min(longest);
        let mut recorded = Flight::default();
        fly(&scenario, &mut recorded);
        Ok(recorded)
    }

    /// Returns the arguments as bytes.
    pub fn input(&self) -> Vec<u8> {
        self.arguments.iter().flat_map(|word| word.to_le_bytes()).collect()
    }

    /// Returns the number of periods.
    pub fn periods(&self) -> usize {
        self.arguments.len() / (Settings::WORDS + Inputs::WORDS)
    }

    /// Returns true if these are the results; any two NaN are equal.
    pub fn has(&self, results: &[u64]) -> bool {
        let plain = |word: &u64| if f64::from_bits(*word).is_nan() { u64::MAX } else { *word };
        self.results.iter().map(plain).eq(results.iter().map(plain))
    }
}

impl Computer for Flight {
    fn step(&mut self, settings: &Settings, inputs: &Inputs) -> Outputs {
        self.arguments.extend(words(settings).into_iter().chain(words(inputs)));
        let outputs = self.models.step(settings, inputs);
        let (parameters, target) = (&settings.parameters, &outputs.reference.target);
        let (at, climb) = (outputs.estimate.position.z, outputs.estimate.velocity.z);
        let thrust = self.height.step(parameters, target, at, climb);
        self.heights.extend(words(parameters).into_iter().chain(words(target)));
        self.heights.extend([at.to_bits(), climb.to_bits()]);
        self.results.extend(self.models.words().into_iter().chain(words(&self.height)));
        self.results.push(thrust.to_bits());
        outputs
    }

    fn digest(&self) -> u64 {
        self.models.digest()
    }
}

/// Returns true if rustup has added the target.
pub fn is_added(target: &str) -> bool {
    let output =
        Command::new("rustc").args(["--print", "target-libdir", "--target", target]).output();
    output.is_ok_and(|output| Path::new(String::from_utf8_lossy(&output.stdout).trim()).is_dir())
}

/// Builds the library for a target; returns its path.
///
/// # Errors
/// The message of cargo.
pub fn library(target: &str) -> Result<PathBuf, String> {
    let into = root().join("target/linked");
    let (kind, name) = match target == WASM {
        true => ("cdylib", "linked.wasm"),
        false => ("staticlib", "liblinked.a"),
    };
    let mut command = Command::new("cargo");
    command.current_dir(root().join("bench/linked")).arg("rustc").args(["--release", "--lib"]);
    command.args(["--quiet", "--crate-type", kind, "--target", target, "--target-dir"]).arg(&into);
    if target == WASM {
        command.args([
            "--",
            "-C",
            "strip=symbols",
            "-C",
            &format!("link-arg=-zstack-size={STACK}"),
        ]);
    }
    run(&mut command)?;
    Ok(into.join(target).join("release").join(name))
}

/// Builds the program around the library of a target in `folder`, which also gets `sources`.
///
/// # Errors
/// The message of cargo or the compiler.
pub fn program(
    toolchain: &Toolchain,
    library: &[PathBuf],
    folder: &Path,
    flags: &[&str],
) -> Result<PathBuf, String> {
    let failed = |error: std::io::Error| error.to_string();
    let bare = if toolchain.bare { "#define SEMIHOSTING\n" } else { "" };
    std::fs::write(folder.join("words.h"), format!("{bare}{}{}", harness::SUPPORT, harness::MARKS))
        .map_err(failed)?;
    let (main, program) = (folder.join("main.c"), folder.join("linked"));
    std::fs::copy(root().join("bench/linked/main.c"), &main).map_err(failed)?;
    let mut sources = vec![main];
    sources.extend(watch::start(toolchain, folder)?);
    sources.extend(library.iter().cloned());
    toolchain.link(&sources, &program, flags)?;
    Ok(program)
}

/// Runs a flight on a processor; returns the words of its results.
///
/// # Errors
/// The message of a tool.
pub fn flown(target: &str, toolchain: &Toolchain, flight: &Flight) -> Result<Vec<u64>, String> {
    let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
    let program = program(toolchain, &[library(target)?], folder.path(), &[])?;
    Ok(watch::counted(toolchain, folder.path(), &program, &flight.input())?.words)
}

/// Runs a flight in wasmtime, by this Python; returns the words of its results.
///
/// # Errors
/// The message of a tool.
pub fn flown_by_wasmtime(python: &Path, flight: &Flight) -> Result<Vec<u64>, String> {
    let failed = |error: std::io::Error| format!("{}: {error}", python.display());
    let mut command = Command::new(python);
    command.arg(root().join("bench/linked/host.py")).arg(library(WASM)?);
    command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut child = command.spawn().map_err(failed)?;
    let (stdin, input) = (child.stdin.take(), flight.input());
    // A full pipe waits for its reader.
    let writer = std::thread::spawn(move || stdin.map(|mut stdin| stdin.write_all(&input)));
    let output = child.wait_with_output().map_err(failed)?;
    // A program that ends early has its reason in its status.
    let _ = writer.join();
    if !output.status.success() {
        return Err(String::from_utf8_lossy(&output.stderr).into_owned());
    }
    let (words, _) = output.stdout.as_chunks::<8>();
    Ok(words.iter().map(|bytes| u64::from_le_bytes(*bytes)).collect())
}
