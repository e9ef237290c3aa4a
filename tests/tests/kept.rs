//! The program that counts calls keeps a state and returns to it, so that the calls before many others run once. It goes on
//! running for more calls.

use std::path::Path;

use bessemer_codegen::compile::Options;
use bessemer_tests::harness::{self, GOES_ON, KEEPS, RESTARTS, RETURNS};
use bessemer_tests::pilot::entry;
use bessemer_tests::process::{Folder, lay_out};
use bessemer_tests::running::Running;
use bessemer_tests::toolchain::{self, ARM, CORTEX_M4F, Toolchain};
use bessemer_tests::watch::{self, watched};
use bessemer_tests::workspace::Workspace;

/// The number of passes of a call is the sum of all arguments so far.
const MODEL: &str = "//! A sum.
#![no_std]
use bessemer::prelude::*;

/// Sum of all arguments.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Total {
    /// The sum.
    pub sum: u32,
}

#[component]
impl Total {
    /// Adds a number, and returns a power of 3.
    #[entry(infallible)]
    pub fn step(&mut self, more: u32) -> u32 {
        self.sum = self.sum.saturating_add(more).min(1000);
        let mut power = 1_u32;
        for _ in 0..self.sum {
            power = power.wrapping_mul(3);
        }
        power
    }
}
";

/// Builds the program for each target that is there: below Linux, and without an operating system.
fn with_counts(check: impl Fn(&Toolchain, &Folder, &Path)) {
    for toolchain in [ARM, CORTEX_M4F] {
        if toolchain.programs().into_iter().all(toolchain::is_asked_for) {
            on(&toolchain, &check);
        }
    }
}

fn on(toolchain: &Toolchain, check: impl Fn(&Toolchain, &Folder, &Path)) {
    let workspace = Workspace::with_source(MODEL).expect("a workspace");
    let compiled = workspace.compiled().unwrap_or_else(|said| panic!("{said}"));
    let step = entry(&compiled, "Total", "step").expect("an entry point");
    let folder = lay_out(&compiled).expect("a folder");
    let main = folder.path().join("main.c");
    let text =
        harness::counted(&compiled.explicit, &[(step, 2)], &Options::default(), toolchain.bare);
    std::fs::write(&main, text).expect("the program");
    check(toolchain, &folder, &main);
}

fn input(calls: &[(u64, u64)]) -> Vec<u8> {
    let words = calls.iter().flat_map(|(flag, more)| [0, *flag, *more]);
    words.flat_map(u64::to_le_bytes).collect()
}

#[test]
fn a_call_that_returns_to_a_state_takes_as_long_as_one_from_it() {
    with_counts(|toolchain, folder, main| {
        let counted = |calls: &[(u64, u64)]| {
            let watched = watched(toolchain, folder.path(), main, folder.sources(), &input(calls));
            watched.unwrap_or_else(|said| panic!("{said}")).counts
        };
        let whole = |more: u64| {
            *counted(&[(RESTARTS, 100), (GOES_ON, 20), (GOES_ON, more)]).last().expect("a count")
        };
        let from_one = counted(&FROM_ONE);
        assert_eq!(from_one.len(), 6);
        assert_eq!([from_one[2], from_one[3], from_one[5]], [whole(3), whole(400), whole(0)]);
        assert!(from_one[4] > from_one[3] && from_one[3] > from_one[2] + 397, "{from_one:?}");
    });
}

/// A state is kept, and two calls return to it.
const FROM_ONE: [(u64, u64); 6] =
    [(RESTARTS, 100), (GOES_ON, 20), (KEEPS, 3), (RETURNS, 400), (GOES_ON, 50), (RETURNS, 0)];

/// The state stays from one batch of calls to the next, and a program that ends is an error.
#[test]
fn a_program_that_goes_on_running_counts_as_one_run_does() {
    with_counts(|toolchain, folder, main| {
        let watched = watched(toolchain, folder.path(), main, folder.sources(), &input(&FROM_ONE));
        let whole = watched.unwrap_or_else(|said| panic!("{said}")).counts;
        let own = folder.path().join(watch::FOLDER);
        let mut running = Running::start(toolchain, &own, &own.join("main"))
            .unwrap_or_else(|said| panic!("{said}"));
        let mut counts = Vec::new();
        for calls in FROM_ONE.chunks(2) {
            let some = running.count(input(calls), calls.len());
            counts.extend(some.unwrap_or_else(|said| panic!("{said}")));
        }
        assert_eq!(counts, whole);
        // More than a pipe holds at once.
        let many = FROM_ONE.repeat(1000);
        let counts = running.count(input(&many), many.len());
        assert_eq!(counts.unwrap_or_else(|said| panic!("{said}")), whole.repeat(1000));
        let main = folder.path().join("ends.c");
        std::fs::write(&main, "int main(void)\n{\n    return 3;\n}\n").expect("a program");
        let program = watch::built(toolchain, folder.path(), &main, &[], &[]).expect("it compiles");
        let mut running = Running::start(toolchain, &own, &program).expect("it starts");
        let said = running.count(input(&FROM_ONE), 6).expect_err("it reads no calls");
        assert!(said.contains("exit status: 3"), "{said}");
    });
}
