//! The programs beside Rust's own that the commands run, and what installs them: compilers, emulators, CMake.
//!
//! Invariants: nothing here changes the machine; a program is there if it answers `--version`.
//!
//! What it must not know: who runs them, and for what.

use std::process::{Command, Stdio};

/// A program and the packages that contain it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Program {
    /// Name of the program.
    pub name: &'static str,
    /// Debian packages of the program and of everything that it needs.
    pub packages: &'static [&'static str],
}

/// Describes a program.
const fn program(name: &'static str, packages: &'static [&'static str]) -> Program {
    Program { name, packages }
}

/// The first compiler for this machine, gcc.
pub const GCC: Program = program("gcc", &["gcc", "libc6-dev"]);
/// The second compiler for this machine, clang.
pub const CLANG: Program = program("clang", &["clang", "libc6-dev"]);
/// Builds by a Makefile.
pub const MAKE: Program = program("make", &["make"]);
/// Builds firmware.
pub const CMAKE: Program = program("cmake", &["cmake"]);
/// Compiles for ARM of 32 bits, under Linux.
pub const ARM_LINUX_GCC: Program =
    program("arm-linux-gnueabihf-gcc", &["gcc-arm-linux-gnueabihf", "libc6-dev-armhf-cross"]);
/// Compiles for ARM of 32 bits without an operating system.
pub const ARM_BARE_GCC: Program =
    program("arm-none-eabi-gcc", &["gcc-arm-none-eabi", "libnewlib-arm-none-eabi"]);
/// Compiles for ARM of 64 bits.
pub const AARCH64_GCC: Program =
    program("aarch64-linux-gnu-gcc", &["gcc-aarch64-linux-gnu", "libc6-dev-arm64-cross"]);
/// Compiles for RISC-V of 64 bits, under Linux.
pub const RISCV64_GCC: Program =
    program("riscv64-linux-gnu-gcc", &["gcc-riscv64-linux-gnu", "libc6-dev-riscv64-cross"]);
/// Compiles for RISC-V without an operating system.
pub const RISCV_BARE_GCC: Program = program(
    "riscv64-unknown-elf-gcc",
    &["gcc-riscv64-unknown-elf", "picolibc-riscv64-unknown-elf"],
);
/// Compiles for a big-endian machine.
pub const S390X_GCC: Program =
    program("s390x-linux-gnu-gcc", &["gcc-s390x-linux-gnu", "libc6-dev-s390x-cross"]);
/// Runs programs of ARM of 32 bits; with it come the emulators of other processors under Linux.
pub const QEMU_ARM: Program = program("qemu-arm", &["qemu-user"]);
/// QEMU for user programs of 64-bit ARM.
pub const QEMU_AARCH64: Program = program("qemu-aarch64", &["qemu-user"]);
/// QEMU for user programs of 64-bit RISC-V.
pub const QEMU_RISCV64: Program = program("qemu-riscv64", &["qemu-user"]);
/// QEMU for user programs of big-endian s390x.
pub const QEMU_S390X: Program = program("qemu-s390x", &["qemu-user"]);
/// Compiles for Alpha.
pub const ALPHA_GCC: Program =
    program("alpha-linux-gnu-gcc", &["gcc-alpha-linux-gnu", "libc6.1-dev-alpha-cross"]);
/// QEMU for user programs of Alpha.
pub const QEMU_ALPHA: Program = program("qemu-alpha", &["qemu-user"]);
/// Compiles for PA-RISC.
pub const HPPA_GCC: Program =
    program("hppa-linux-gnu-gcc", &["gcc-hppa-linux-gnu", "libc6-dev-hppa-cross"]);
/// QEMU for user programs of PA-RISC.
pub const QEMU_HPPA: Program = program("qemu-hppa", &["qemu-user"]);
/// Compiles for SPARC of 64 bits.
pub const SPARC64_GCC: Program =
    program("sparc64-linux-gnu-gcc", &["gcc-sparc64-linux-gnu", "libc6-dev-sparc64-cross"]);
/// QEMU for user programs of SPARC of 64 bits.
pub const QEMU_SPARC64: Program = program("qemu-sparc64", &["qemu-user"]);
/// Compiles for MIPS.
pub const MIPS_GCC: Program =
    program("mips-linux-gnu-gcc", &["gcc-mips-linux-gnu", "libc6-dev-mips-cross"]);
/// QEMU for user programs of MIPS.
pub const QEMU_MIPS: Program = program("qemu-mips", &["qemu-user"]);
/// Compiles for PowerPC.
pub const PPC_GCC: Program =
    program("powerpc-linux-gnu-gcc", &["gcc-powerpc-linux-gnu", "libc6-dev-powerpc-cross"]);
/// QEMU for user programs of PowerPC.
pub const QEMU_PPC: Program = program("qemu-ppc", &["qemu-user"]);
/// Runs whole machines with an ARM.
pub const QEMU_SYSTEM_ARM: Program = program("qemu-system-arm", &["qemu-system-arm"]);
/// Runs whole machines with a RISC-V of 32 bits.
pub const QEMU_SYSTEM_RISCV32: Program = program("qemu-system-riscv32", &["qemu-system-misc"]);

/// Every one of them.
pub const ALL: &[Program] = &[
    GCC,
    CLANG,
    MAKE,
    CMAKE,
    ARM_LINUX_GCC,
    QEMU_ARM,
    ARM_BARE_GCC,
    QEMU_SYSTEM_ARM,
    AARCH64_GCC,
    QEMU_AARCH64,
    RISCV64_GCC,
    QEMU_RISCV64,
    RISCV_BARE_GCC,
    QEMU_SYSTEM_RISCV32,
    S390X_GCC,
    QEMU_S390X,
    ALPHA_GCC,
    QEMU_ALPHA,
    HPPA_GCC,
    QEMU_HPPA,
    SPARC64_GCC,
    QEMU_SPARC64,
    MIPS_GCC,
    QEMU_MIPS,
    PPC_GCC,
    QEMU_PPC,
];

/// A program that is needed does not run here.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Missing {
    /// The missing program.
    pub program: &'static str,
    /// The line that installs it on Debian, with what it works together with.
    pub install: String,
}

impl std::fmt::Display for Missing {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "`{}` does not run here", self.program)
    }
}

impl std::error::Error for Missing {}

/// Checks that all of these programs run here.
///
/// # Errors
/// The first that does not.
pub fn check(programs: &[&'static str]) -> Result<(), Missing> {
    match programs.iter().find(|program| version(program).is_none()) {
        None => Ok(()),
        Some(program) => {
            let known = ALL.iter().filter(|it| programs.contains(&it.name)).copied();
            Err(Missing { program, install: install(&known.collect::<Vec<_>>()) })
        }
    }
}

impl Program {
    /// Returns its version; none if it does not run here.
    pub fn version(&self) -> Option<String> {
        version(self.name)
    }

    /// The line that installs it.
    pub fn install(&self) -> String {
        install(&[*self])
    }
}

/// Returns the version that a program prints; none if it does not run here.
pub fn version(program: &str) -> Option<String> {
    let output = Command::new(program).arg("--version").stdin(Stdio::null()).output().ok()?;
    output.status.success().then(|| String::from_utf8_lossy(&output.stdout).into_owned())
}

/// The line that installs programs on Debian and what is made of it.
pub fn install(programs: &[Program]) -> String {
    let mut packages: Vec<&str> = Vec::new();
    for package in programs.iter().flat_map(|program| program.packages) {
        if !packages.contains(package) {
            packages.push(package);
        }
    }
    format!("apt-get install {}", packages.join(" "))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_package_is_named_once() {
        let line = install(&[GCC, CLANG, QEMU_ARM, QEMU_S390X]);
        assert_eq!(line, "apt-get install gcc libc6-dev clang qemu-user");
    }

    #[test]
    fn what_is_missing_is_named_with_what_it_works_with() {
        let missing = Missing { program: "no-such-program", install: GCC.install() };
        assert_eq!(check(&["gcc", "no-such-program"]), Err(missing));
        assert_eq!(check(&["rustc"]), Ok(()));
    }

    #[test]
    fn what_does_not_exist_is_not_there() {
        assert_eq!(version("no-such-program-anywhere"), None);
        assert!(version("rustc").is_some_and(|said| said.starts_with("rustc")));
    }
}
