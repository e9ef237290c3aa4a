//! The compilers of emitted C, and the way to run a program of each.
//!
//! `BESSEMER_LEGS` selects the compilers that must exist: `all` includes the Cortex-A9, `host` does not. If it is
//! unset, the existing ones are used, so that a plain `cargo test` passes with one C compiler.

use std::collections::BTreeMap;
use std::ffi::OsStr;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{LazyLock, Mutex};

use crate::{machines, objects, store, zig};

use bessemer_backend::c::Standard;

pub use bessemer_backend::c::FLAGS;
pub use bessemer_tools::Missing;

/// Flags for the Cortex-A9: hard float and VFPv3, since NEON would flush subnormals to zero.
pub const CORTEX_A9: &[&str] = &["-mcpu=cortex-a9", "-mfpu=vfpv3", "-mfloat-abi=hard", "-static"];

/// A compiler with a level of optimisation and a machine.
#[derive(Clone, Debug, Hash)]
pub struct Toolchain {
    /// Program of the compiler: `gcc`, `clang`, `arm-linux-gnueabihf-gcc`.
    pub compiler: &'static str,
    /// Level of optimisation, `0` to `3`.
    pub level: u32,
    /// Compiler flags that select the machine.
    pub machine: &'static [&'static str],
    /// The emulator for programs of another machine.
    pub emulator: Option<&'static [&'static str]>,
    /// True if the machine has no operating system: see `watch`.
    pub bare: bool,
    /// Additional flags, such as one for an instruction that not every processor has.
    pub more: &'static [&'static str],
}

/// This machine, with gcc.
pub const GCC: Toolchain =
    Toolchain { compiler: "gcc", level: 2, machine: &[], emulator: None, bare: false, more: &[] };

/// This machine, with clang.
pub const CLANG: Toolchain = Toolchain { compiler: "clang", ..GCC };

/// The emulated Cortex-A9 under Linux.
pub const ARM: Toolchain = Toolchain {
    compiler: "arm-linux-gnueabihf-gcc",
    machine: CORTEX_A9,
    emulator: Some(&["qemu-arm", "-cpu", "cortex-a9"]),
    ..GCC
};

/// Defines an emulated machine with additional arguments for the emulator.
macro_rules! machine {
    ($name:literal, $($more:literal),+) => {
        Some(&[
            "qemu-system-arm", "-machine", $name, "-display", "none", "-monitor", "none", $($more),+, "-kernel",
        ])
    };
}

/// The target without an operating system: a whole Zynq, emulated, whose second serial port is the emulator's
/// standard input and output. Nothing on it is aligned to less than its size, since memory is not cached at first.
pub const ZYNQ: Toolchain = Toolchain {
    compiler: "arm-none-eabi-gcc",
    machine: &[
        "-mcpu=cortex-a9",
        "-mfpu=vfpv3",
        "-mfloat-abi=hard",
        "-marm",
        "-mno-unaligned-access",
    ],
    emulator: machine!("xilinx-zynq-a9", "-m", "128M", "-serial", "null", "-serial", "stdio"),
    ..GCC
};

/// Toolchain for bare programs that read and write the emulator's files (semihosting).
pub const BARE_A9: Toolchain = Toolchain {
    machine: &[
        "-mcpu=cortex-a9",
        "-mfpu=vfpv3",
        "-mfloat-abi=hard",
        "-marm",
        "-mno-unaligned-access",
        "--specs=rdimon.specs",
    ],
    emulator: machine!(
        "xilinx-zynq-a9",
        "-m",
        "128M",
        "-semihosting-config",
        "enable=on,target=native"
    ),
    bare: true,
    ..ZYNQ
};

/// A microcontroller whose floating-point unit has single precision alone.
pub const CORTEX_M4F: Toolchain = Toolchain {
    machine: &[
        "-mcpu=cortex-m4",
        "-mthumb",
        "-mfpu=fpv4-sp-d16",
        "-mfloat-abi=hard",
        "--specs=rdimon.specs",
        "-Wl,--section-start=.vectors=0",
    ],
    emulator: machine!("mps2-an386", "-semihosting-config", "enable=on,target=native"),
    bare: true,
    ..ZYNQ
};

/// A microcontroller whose floating-point unit has double precision.
pub const CORTEX_M7: Toolchain = Toolchain {
    machine: &[
        "-mcpu=cortex-m7",
        "-mthumb",
        "-mfpu=fpv5-d16",
        "-mfloat-abi=hard",
        "--specs=rdimon.specs",
        "-Wl,--section-start=.vectors=0",
    ],
    emulator: machine!("mps2-an500", "-semihosting-config", "enable=on,target=native"),
    bare: true,
    ..ZYNQ
};

/// ARM of 64 bits.
pub const AARCH64: Toolchain = Toolchain {
    compiler: "aarch64-linux-gnu-gcc",
    machine: &["-static"],
    emulator: Some(&["qemu-aarch64"]),
    ..GCC
};

/// RISC-V of 64 bits.
pub const RISCV64: Toolchain = Toolchain {
    compiler: "riscv64-linux-gnu-gcc",
    machine: &["-static"],
    emulator: Some(&["qemu-riscv64"]),
    ..GCC
};

/// RISC-V of 32 bits without an operating system, for a program that reads and writes its emulator's files.
pub const RISCV32: Toolchain = Toolchain {
    compiler: "riscv64-unknown-elf-gcc",
    machine: &[
        "-march=rv32imafdc",
        "-mabi=ilp32d",
        "--specs=picolibc.specs",
        "--oslib=semihost",
        "--crt0=semihost",
        "-Wl,--defsym=__flash=0x80000000",
        "-Wl,--defsym=__flash_size=0x00400000",
        "-Wl,--defsym=__ram=0x80400000",
        "-Wl,--defsym=__ram_size=0x00400000",
    ],
    emulator: Some(&[
        "qemu-system-riscv32",
        "-machine",
        "virt",
        "-bios",
        "none",
        "-display",
        "none",
        "-monitor",
        "none",
        "-serial",
        "none",
        "-semihosting-config",
        "enable=on,target=native",
        "-kernel",
    ]),
    bare: true,
    ..GCC
};

/// Big-endian. By a strict standard, gcc would compute `float` as `double` there, which the C refuses.
pub const S390X: Toolchain = Toolchain {
    compiler: "s390x-linux-gnu-gcc",
    machine: &["-fexcess-precision=fast", "-static"],
    emulator: Some(&["qemu-s390x"]),
    ..GCC
};

/// Returns the compiler at a level, as found by `cc`. It is found once, since `cc` runs a compiler to identify it.
fn tool(compiler: &'static str, level: u32) -> Option<cc::Tool> {
    type Tools = BTreeMap<(&'static str, u32), Option<cc::Tool>>;
    static TOOLS: LazyLock<Mutex<Tools>> = LazyLock::new(Mutex::default);
    let ask = || {
        let mut build = cc::Build::new();
        build
            .compiler(compiler)
            .no_default_flags(true)
            .cargo_metadata(false)
            .host(HOST)
            .target(HOST)
            .opt_level(level);
        build.try_get_compiler().ok()
    };
    TOOLS.lock().ok()?.entry((compiler, level)).or_insert_with(ask).clone()
}

impl Toolchain {
    /// Returns the names of the compiler and, if there is one, the emulator.
    pub fn programs(&self) -> Vec<&'static str> {
        std::iter::once(self.compiler).chain(self.emulator.map(|emulator| emulator[0])).collect()
    }

    /// Checks that this machine can build and run programs with it.
    ///
    /// # Errors
    ///
    /// The missing programs, and the line that installs them.
    pub fn check(&self) -> Result<(), Missing> {
        bessemer_tools::check(&self.programs())
    }

    /// Returns true if this machine can build and run programs with it.
    pub fn is_there(&self) -> bool {
        self.check().is_ok()
    }

    /// Returns true if the run requires an emulated machine, or does not exclude it.
    fn is_asked_for(&self) -> bool {
        asked_for(|| self.is_there())
    }

    /// Returns the toolchain with another C standard; [`FLAGS`] select C99.
    #[must_use]
    pub fn of(self, standard: Standard) -> Toolchain {
        match standard {
            Standard::C99 => self,
            other => Toolchain { more: other.flags(), ..self },
        }
    }

    /// Returns the name in tests: `gcc -O2`.
    pub fn name(&self) -> String {
        let more: String = self.more.iter().map(|flag| format!(" {flag}")).collect();
        format!("{} -O{}{more}", self.compiler, self.level)
    }

    /// Returns a command that compiles with the project's warnings; callers add sources and outputs.
    pub fn command(&self) -> Command {
        let mut command = match tool(self.compiler, self.level) {
            Some(tool) => tool.to_command(),
            None => Command::new(self.compiler),
        };
        command.args(FLAGS).arg(format!("-O{}", self.level));
        command.args(self.machine).args(self.more);
        command
    }

    /// Compiles and links `sources` to `program`, with additional flags.
    ///
    /// # Errors
    ///
    /// The compiler's message.
    pub fn link(&self, sources: &[PathBuf], program: &Path, flags: &[&str]) -> Result<(), String> {
        run(&mut self.linking(sources, program, flags))
    }

    fn linking(&self, sources: &[PathBuf], program: &Path, flags: &[&str]) -> Command {
        let mut command = self.command();
        command.args(flags).args(sources).arg("-o").arg(program).arg("-lm");
        // Headers may lie in a folder of their own below.
        command.args(sources.iter().take(1).filter_map(|it| it.parent()).flat_map(include));
        command
    }

    /// Compiles and links emitted `sources` around the program `main`, with more flags if there are any. What
    /// the compiler said of the sources all the same: warnings, where flags make them no errors.
    ///
    /// The program only moves words: it is compiled without optimisation, at which compilers spend minutes
    /// where there are thousands of calls.
    ///
    /// # Errors
    /// The compiler's message.
    pub fn around(
        &self,
        main: &Path,
        sources: &[PathBuf],
        program: &Path,
        flags: &[&str],
    ) -> Result<String, String> {
        let plain = Toolchain { level: 0, ..self.clone() };
        let main = plain.object(main, flags)?;
        let (objects, said) = self.objects(sources, flags)?;
        let all: Vec<PathBuf> = objects.into_iter().chain([main.0]).collect();
        run(&mut self.linking(&all, program, flags))?;
        Ok(said)
    }

    /// Compiles `sources` and links them to firmware, which has its own startup code, with additional linker flags.
    ///
    /// # Errors
    ///
    /// The compiler's message.
    pub fn firmware(
        &self,
        sources: &[PathBuf],
        program: &Path,
        flags: &[&str],
    ) -> Result<(), String> {
        let (objects, _) = self.objects(sources, &[])?;
        run(self.linking(&objects, program, flags).arg("-nostartfiles"))
    }

    /// Compiles each of the sources, using all processors; returns the objects in order, and the compiler's warnings.
    ///
    /// # Errors
    ///
    /// The compiler's message.
    pub fn objects(
        &self,
        sources: &[PathBuf],
        flags: &[&str],
    ) -> Result<(Vec<PathBuf>, String), String> {
        let workers = std::thread::available_parallelism().map_or(1, usize::from);
        let next = AtomicUsize::new(0);
        let work = || {
            let mut made = Vec::new();
            while let Some(source) = sources.get(next.fetch_add(1, Ordering::Relaxed)) {
                made.push((source, self.object(source, flags)));
            }
            made
        };
        let mut made = std::thread::scope(|scope| {
            let workers: Vec<_> = (0..workers).map(|_| scope.spawn(work)).collect();
            let made = workers.into_iter().filter_map(|worker| worker.join().ok());
            made.flatten().collect::<Vec<_>>()
        });
        made.sort_by_key(|(source, _)| *source);
        let (mut objects, mut all) = (Vec::new(), String::new());
        for (_, made) in made {
            let (object, said) = made?;
            objects.push(object);
            all.push_str(&said);
        }
        Ok((objects, all))
    }

    /// Compiles a source to an object next to it, unless a stored object exists; returns also the compiler's
    /// warnings.
    ///
    /// # Errors
    ///
    /// The compiler's message.
    pub fn object(&self, source: &Path, flags: &[&str]) -> Result<(PathBuf, String), String> {
        let compiler = Path::new(self.compiler).file_name().unwrap_or_default().to_string_lossy();
        let object = source.with_extension(format!("{compiler}-{}.o", self.level));
        let mut command = self.command();
        command.args(flags);
        let words =
            command.get_args().map(|word| word.to_string_lossy().into_owned()).collect::<Vec<_>>();
        let stored = objects::place(self.compiler, &words, source);
        if stored.as_ref().is_some_and(|stored| store::fetch(stored, &object)) {
            return Ok((object, String::new()));
        }
        command.args(source.parent().into_iter().flat_map(include));
        let said = said(command.arg("-c").arg(source).arg("-o").arg(&object))?;
        if said.is_empty()
            && let Some(stored) = stored
        {
            store::store(&object, &stored)
                .map_err(|error| format!("{}: {error}", stored.display()))?;
        }
        Ok((object, said))
    }

    /// Returns a command that runs `program`.
    pub fn runner(&self, program: &Path) -> Command {
        self.runner_with(program, &[])
    }

    /// Returns the command that runs a program, with more arguments for the emulator.
    pub fn runner_with(&self, program: &Path, more: &[&str]) -> Command {
        match self.emulator {
            Some([emulator, arguments @ ..]) => {
                let mut command = Command::new(emulator);
                command.args(more).args(arguments).arg(program);
                command
            }
            _ => Command::new(program),
        }
    }

    /// Returns the size of the part of `objects` that `symbol` needs, itself included; `kept` is written with it. The
    /// objects are compiled by sections (`-ffunction-sections -fdata-sections`).
    ///
    /// # Errors
    /// What linker or system said.
    pub fn brought(&self, objects: &[PathBuf], symbol: &str, kept: &Path) -> Result<Sizes, String> {
        // Flags for whole programs name linker scripts, whose symbols are absent here.
        let mut command = Command::new(self.compiler);
        command.args(self.machine.iter().filter(|flag| flag.starts_with("-m"))).args(self.more);
        command.args(["-r", "-nostdlib", "-Wl,--gc-sections"]).arg(format!("-Wl,-e,{symbol}"));
        run(command.args(objects).arg("-o").arg(kept))?;
        self.sizes(&[kept.to_owned()])
    }

    /// Returns the total size of programs or objects of this toolchain.
    ///
    /// # Errors
    /// What the system said, or that the program which tells it said nothing.
    pub fn sizes(&self, files: &[PathBuf]) -> Result<Sizes, String> {
        let size = self.compiler.replace("gcc", "size").replace("clang", "size");
        let output = Command::new(&size).args(files).output();
        let output = output.map_err(|error| format!("{size}: {error}"))?;
        let text = String::from_utf8_lossy(&output.stdout);
        let mut all = Sizes::default();
        for line in text.lines().skip(1) {
            let mut numbers = line.split_whitespace().map_while(|it| it.parse::<u64>().ok());
            let mut next = || numbers.next().ok_or_else(|| format!("`{size}` says `{line}`"));
            all.text += next()?;
            all.data += next()?;
            all.bss += next()?;
        }
        Ok(all)
    }
}

/// Returns the flags that make a folder a path for included files.
fn include(folder: &Path) -> [&OsStr; 2] {
    [OsStr::new("-I"), folder.as_os_str()]
}

/// Sizes of a program, bytes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Sizes {
    /// Size of instructions and constants.
    pub text: u64,
    /// Size of initialised memory.
    pub data: u64,
    /// Size of zeroed memory, stacks included.
    pub bss: u64,
}

const HOST: &str = "x86_64-unknown-linux-gnu";

/// Runs a command.
///
/// # Errors
///
/// Its output, if it failed.
pub fn run(command: &mut Command) -> Result<(), String> {
    said(command).map(drop)
}

/// Runs a command and returns its output and warnings.
fn said(command: &mut Command) -> Result<String, String> {
    match command.output() {
        Ok(output) if output.status.success() => {
            Ok(String::from_utf8_lossy(&output.stderr).into_owned())
        }
        Ok(output) => Err(format!(
            "{}\n{}{}",
            line(command),
            String::from_utf8_lossy(&output.stdout),
            String::from_utf8_lossy(&output.stderr)
        )),
        Err(error) => Err(format!("{}: {error}", line(command))),
    }
}

/// Returns the words of a command without its environment, which may hold secrets.
pub(crate) fn line(command: &Command) -> String {
    let words = std::iter::once(command.get_program()).chain(command.get_args());
    words.map(|word| word.to_string_lossy()).collect::<Vec<_>>().join(" ")
}

/// Legs that a run must have.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Legs {
    Present,
    Host,
    All,
}

fn legs() -> Legs {
    match std::env::var("BESSEMER_LEGS").as_deref() {
        Ok("all") => Legs::All,
        Ok("host") => Legs::Host,
        _ => Legs::Present,
    }
}

/// Returns true if the run uses a program that is no compiler of the host.
pub fn is_asked_for(program: &str) -> bool {
    asked_for(|| bessemer_tools::version(program).is_some())
}

/// Returns true if the run uses a leg: `BESSEMER_LEGS` demands it or leaves it out; otherwise `is_there` decides.
pub fn asked_for(is_there: impl FnOnce() -> bool) -> bool {
    match legs() {
        Legs::All => true,
        Legs::Host => false,
        Legs::Present => is_there(),
    }
}

/// Returns a toolchain at -O0, -O2 and -O3.
fn at_levels(toolchain: Toolchain) -> impl Iterator<Item = Toolchain> {
    [0, 2, 3].into_iter().map(move |level| Toolchain { level, ..toolchain.clone() })
}

/// Returns gcc and clang on this machine at -O0, -O2 and -O3.
pub fn host() -> Vec<Toolchain> {
    let wanted = |it: &Toolchain| legs() != Legs::Present || it.is_there();
    [GCC, CLANG].into_iter().filter(wanted).flat_map(at_levels).collect()
}

/// Returns the emulated Cortex-A9 at the same levels.
pub fn target() -> Vec<Toolchain> {
    if ARM.is_asked_for() { at_levels(ARM).collect() } else { Vec::new() }
}

/// Returns other emulated machines, some of them big-endian, and zig's compiler for this one, optimised.
pub fn others() -> Vec<Toolchain> {
    let others = [AARCH64, RISCV64, S390X].into_iter().chain(machines::RARE);
    others.filter(Toolchain::is_asked_for).chain(zig::zig()).collect()
}

/// Returns every toolchain of this run.
pub fn all() -> Vec<Toolchain> {
    let mut all = host();
    all.extend(target());
    all
}

/// Returns flags that permit fused multiply-adds, with vectors of each width that this processor has.
pub fn with_fma() -> Vec<&'static [&'static str]> {
    let mut list: Vec<&'static [&'static str]> = Vec::new();
    #[cfg(target_arch = "x86_64")]
    {
        use std::arch::is_x86_feature_detected as has;
        if has!("avx2") && has!("fma") && has!("bmi2") && has!("lzcnt") && has!("movbe") {
            list.push(&["-march=x86-64-v3"]);
            if has!("avx512f")
                && has!("avx512bw")
                && has!("avx512cd")
                && has!("avx512dq")
                && has!("avx512vl")
            {
                list.push(&["-march=x86-64-v4"]);
            }
            list.push(&["-march=native"]);
        }
    }
    list
}

/// Returns gcc and clang with each of these flags, optimised.
pub fn fusing() -> Vec<Toolchain> {
    let optimised = host().into_iter().filter(|it| it.level == 2);
    let each =
        |it: Toolchain| with_fma().into_iter().map(move |more| Toolchain { more, ..it.clone() });
    optimised.flat_map(each).collect()
}

/// Returns true if this machine has vectors of four doubles.
pub fn has_avx2() -> bool {
    #[cfg(target_arch = "x86_64")]
    let found = std::arch::is_x86_feature_detected!("avx2");
    #[cfg(not(target_arch = "x86_64"))]
    let found = false;
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_error_shows_the_command_without_its_environment() {
        if !GCC.is_there() {
            println!("left out: there is no gcc");
            return;
        }
        let file = Path::new("/no/such/file.c").to_owned();
        let said = GCC.link(&[file], Path::new("/no/such/program"), &[]);
        let said = said.expect_err("there is no such file");
        assert!(said.starts_with("gcc ") && said.contains(" -O2 "), "{said}");
        let variable = std::env::var("PATH").expect("a path");
        assert!(!said.contains(&variable), "{said}");
    }
}
