//! Rare machines under emulation, on which a full run computes the flights, too. Their NaN, subnormal numbers or order of
//! bytes differ from the common ones.
//!
//! Invariant: only data.

use crate::toolchain::{GCC, Toolchain};

/// All of them.
pub const RARE: [Toolchain; 5] = [ALPHA, HPPA, SPARC64, MIPS, PPC];

/// Alpha. Its gcc keeps subnormal numbers and NaN on request only. A static program does not start in its emulator.
pub const ALPHA: Toolchain = Toolchain {
    compiler: "alpha-linux-gnu-gcc",
    machine: &["-mieee"],
    emulator: Some(&["qemu-alpha", "-L", "/usr/alpha-linux-gnu"]),
    ..GCC
};

/// PA-RISC, big-endian, whose quiet NaN has the bits of other machines' signalling ones.
pub const HPPA: Toolchain = Toolchain {
    compiler: "hppa-linux-gnu-gcc",
    machine: &["-static"],
    emulator: Some(&["qemu-hppa"]),
    ..GCC
};

/// SPARC of 64 bits, big-endian.
pub const SPARC64: Toolchain = Toolchain {
    compiler: "sparc64-linux-gnu-gcc",
    machine: &["-static"],
    emulator: Some(&["qemu-sparc64"]),
    ..GCC
};

/// MIPS of 32 bits, big-endian, with the NaN of PA-RISC.
pub const MIPS: Toolchain = Toolchain {
    compiler: "mips-linux-gnu-gcc",
    machine: &["-static"],
    emulator: Some(&["qemu-mips"]),
    ..GCC
};

/// PowerPC of 32 bits, big-endian.
pub const PPC: Toolchain = Toolchain {
    compiler: "powerpc-linux-gnu-gcc",
    machine: &["-static"],
    emulator: Some(&["qemu-ppc"]),
    ..GCC
};
