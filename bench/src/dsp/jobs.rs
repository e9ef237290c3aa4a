//! The jobs, and the number of instructions that the emitted C may take for each.

/// A machine with its own list of jobs.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Machine {
    /// A Cortex-M4F without an operating system.
    M4f,
    /// A Cortex-A9 without NEON.
    A9,
}

/// A job of each contender of a machine.
#[derive(Debug)]
pub struct Job {
    /// Its name in results.
    pub name: &'static str,
    /// The function of `bench/dsp/controllers.rs`, with its type.
    pub function: &'static str,
    /// Machine on which it runs.
    pub machine: Machine,
    /// Number of calls.
    pub calls: usize,
    /// Numbers in the result of a call.
    pub numbers: usize,
    /// Goal for the emitted C, in instructions.
    pub goal: u64,
}

const fn job(name: &'static str, function: &'static str, numbers: usize, goal: u64) -> Job {
    Job { name, function, machine: Machine::M4f, calls: 1, numbers, goal }
}

/// The jobs, by machine, in the order in which every program runs them.
pub const JOBS: &[Job] = &[
    Job { calls: 3, ..job("PID step", "Regulator::step", 1, 14) },
    Job { calls: 3, ..job("PID step, inlined in its caller", "Memory::advance", 1, 14) },
    job(
        "biquad cascade in direct form I, 4 sections, 64 samples",
        "DirectCascade::filter",
        64,
        3_000,
    ),
    job(
        "biquad cascade in transposed direct form II, 4 sections, 64 samples",
        "TransposedCascade::filter",
        64,
        2_800,
    ),
    job("FIR filter, 32 taps, 64 samples", "Fir::filter", 64, 5_000),
    job("Clarke's and Park's transforms", "clarke_park", 2, 9),
    job("Clarke's and Park's transforms, inlined in their caller", "transformed", 2, 9),
    job("transforms with sine and cosine", "clarke_park_at", 2, 66),
    job("transforms with those of `bessemer::fast`", "clarke_park_fast", 2, 66),
    job("current loop of a motor", "Currents::step", 3, 130),
    job("current loop by `bessemer::fast`", "Currents::step_fast", 3, 130),
    job("sine", "sine", 1, 53),
    job("sine of `bessemer::fast`", "sine_fast", 1, 33),
    job("angle of a point", "angle", 1, 125),
    job("angle of a point by `bessemer::fast`", "angle_fast", 1, 60),
    job("power of e", "power", 1, 40),
    job("power of e by `bessemer::fast`", "power_fast", 1, 30),
    job("product of 12 rows", "product", 144, 4_520),
    job("Cholesky factor and solution, 12 rows", "definite", 12, 2_409),
    job("`a.lu().solve(&b)`, 4 rows", "solved_4", 4, 339),
    job("`solve_into`, 4 rows", "into_4", 4, 323),
    job("`a.lu().solve(&b)`, 8 rows", "solved_8", 8, 1_713),
    job("`solve_into`, 8 rows", "into_8", 8, 1_632),
    job("`a.lu().solve(&b)`, 20 rows", "solved_20", 20, 20_535),
    job("`solve_into`, 20 rows", "into_20", 20, 19_558),
    Job {
        name: "predictive control, 12 states, 4 inputs, 10 stages, 10 iterations",
        function: "Mpc::step",
        machine: Machine::A9,
        calls: 2,
        numbers: 4,
        goal: 190_000,
    },
    Job { machine: Machine::A9, ..job("sine, on the A9", "sine", 1, 53) },
    Job { machine: Machine::A9, ..job("sine of `bessemer::fast`, on the A9", "sine_fast", 1, 33) },
    Job {
        machine: Machine::A9,
        ..job("transforms with sine and cosine, on the A9", "clarke_park_at", 2, 115)
    },
    Job {
        machine: Machine::A9,
        ..job("transforms with those of `bessemer::fast`, on the A9", "clarke_park_fast", 2, 66)
    },
];
