//! Machines that run the programs, and the flags of all of them.

/// A machine and its compiler flags.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Machine {
    /// Name of the machine in results.
    pub name: &'static str,
    /// Title of the machine in tables.
    pub title: &'static str,
    /// True for the emulated Cortex-A9.
    pub target: bool,
    /// Flags for C and C++, which all contenders share.
    pub flags: &'static [&'static str],
    /// Flags for rustc.
    pub rust_flags: &'static str,
}

/// The host with all its vector extensions; for times.
pub const HOST: Machine = Machine {
    name: "host",
    title: "host, -O3 -march=native",
    target: false,
    flags: &["-O3", "-march=native", "-ffp-contract=off"],
    rust_flags: "-C target-cpu=native",
};

/// The host without AVX-512; for the times of Chapter 6.
pub const HOST_V3: Machine = Machine {
    name: "host-v3",
    title: "host, -O3 -march=x86-64-v3",
    target: false,
    flags: &["-O3", "-march=x86-64-v3", "-ffp-contract=off"],
    rust_flags: "-C target-cpu=x86-64-v3",
};

/// The host without vector instructions; for times.
pub const HOST_SCALAR: Machine = Machine {
    name: "host-scalar",
    title: "host, -O2, no vectors",
    target: false,
    flags: &[
        "-O2",
        "-ffp-contract=off",
        "-fno-tree-vectorize",
        "-fno-tree-slp-vectorize",
        "-DEIGEN_DONT_VECTORIZE",
        "-DBESSEMER_PLAIN",
    ],
    rust_flags: "-C no-vectorize-loops -C no-vectorize-slp",
};

/// The host with the instructions that every x86-64 has; for counts.
pub const HOST_SSE2: Machine = Machine {
    name: "host-sse2",
    title: "host, -O2",
    target: false,
    flags: &["-O2", "-ffp-contract=off"],
    rust_flags: "-C target-cpu=x86-64",
};

/// The host with AVX2, which callgrind supports (unlike AVX-512); for counts.
pub const HOST_AVX2: Machine = Machine {
    name: "host-avx2",
    title: "host, -O2 -march=x86-64-v3",
    target: false,
    flags: &["-O2", "-march=x86-64-v3", "-ffp-contract=off"],
    rust_flags: "-C target-cpu=x86-64-v3",
};

/// The Cortex-A9 with loads by NEON; arithmetic is by the VFP.
pub const A9: Machine = Machine {
    name: "a9",
    title: "Cortex-A9, -O2, NEON loads",
    target: true,
    flags: &[
        "-O2",
        "-mcpu=cortex-a9",
        "-mfpu=neon-vfpv3",
        "-mfloat-abi=hard",
        "-ffp-contract=off",
        "-static",
    ],
    rust_flags: "-C target-cpu=cortex-a9 -C target-feature=+crt-static",
};

/// The Cortex-A9 in plain C99.
pub const A9_PLAIN: Machine = Machine {
    name: "a9-plain",
    title: "Cortex-A9, -O2, plain C99",
    target: true,
    flags: &[
        "-O2",
        "-mcpu=cortex-a9",
        "-mfpu=vfpv3",
        "-mfloat-abi=hard",
        "-ffp-contract=off",
        "-static",
        "-DBESSEMER_PLAIN",
        "-DEIGEN_DONT_VECTORIZE",
    ],
    rust_flags: "-C target-cpu=cortex-a9 -C target-feature=-neon,+crt-static",
};

/// All machines in the order of the report.
pub const ALL: [Machine; 7] = [HOST, HOST_V3, HOST_SCALAR, HOST_SSE2, HOST_AVX2, A9, A9_PLAIN];

/// The Rust target of the Cortex-A9.
pub const RUST_TARGET: &str = "armv7-unknown-linux-gnueabihf";

impl Machine {
    /// Returns the compiler: `gcc` or `g++`, or the cross compiler.
    pub fn compiler(&self, cpp: bool) -> &'static str {
        match (self.target, cpp) {
            (false, false) => "gcc",
            (false, true) => "g++",
            (true, false) => "arm-linux-gnueabihf-gcc",
            (true, true) => "arm-linux-gnueabihf-g++",
        }
    }
}

/// Returns the processor's name and vector extensions, without which times are not comparable.
pub fn processor() -> Option<String> {
    let text = std::fs::read_to_string("/proc/cpuinfo").ok()?;
    let said = |wanted: &str| {
        let mut lines = text.lines().filter_map(|line| line.split_once(':'));
        lines.find(|(key, _)| key.trim() == wanted).map(|(_, value)| value.trim())
    };
    let flags = said("flags")?;
    let known = [("avx512f", "AVX-512"), ("avx2", "AVX2")];
    let vectors = known.iter().find(|(flag, _)| flags.contains(flag)).map_or("SSE2", |it| it.1);
    Some(format!(
        "{}, family {}, model {}, {vectors}",
        said("model name")?,
        said("cpu family")?,
        said("model")?,
    ))
}

/// Each needed tool, the arguments that test it, and its Debian package.
pub const TOOLS: &[(&str, &[&str], &str)] = &[
    ("gcc", &["gcc", "--version"], "gcc"),
    ("g++", &["g++", "--version"], "g++"),
    (
        "Eigen",
        &["g++", "-E", "-x", "c++", "-I/usr/include/eigen3", "-include", "Eigen/Core", "/dev/null"],
        "libeigen3-dev",
    ),
    ("OpenBLAS", &["gcc", "-shared", "-o", "/dev/null", "-lopenblas"], "libopenblas-dev"),
    ("LAPACK", &["test", "-e", "/usr/lib/x86_64-linux-gnu/lapack/liblapack.so"], "liblapack-dev"),
    ("BLAS", &["test", "-e", "/usr/lib/x86_64-linux-gnu/blas/libblas.so"], "libblas-dev"),
    ("callgrind", &["valgrind", "--version"], "valgrind"),
    (
        "arm-linux-gnueabihf-gcc",
        &["arm-linux-gnueabihf-gcc", "--version"],
        "gcc-arm-linux-gnueabihf",
    ),
    (
        "arm-linux-gnueabihf-g++",
        &["arm-linux-gnueabihf-g++", "--version"],
        "g++-arm-linux-gnueabihf",
    ),
    ("qemu-arm", &["qemu-arm", "--version"], "qemu-user"),
];
