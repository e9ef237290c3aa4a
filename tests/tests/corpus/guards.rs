//! Whatever a compiler is reported: it refuses the C, or computes the same bits.
//!
//! The program that goes through is `told_compilers` of the corpus, in which each of the flags would change bits. The
//! flags of which neither a macro nor a pragma takes the edge are the self-test's (`self_test.rs`).

use std::thread;

use bessemer_tests::process::lay_out_needed;
use bessemer_tests::store::once;
use bessemer_tests::toolchain::{self, Toolchain, run};
use bessemer_tests::{corpus, texts, turn};

use super::{Case, cases, run_c};

/// Errors at the head of a file: fast mathematics, other precision of operations, other precision of literals.
const FAST: &str = "-ffast-math and its parts change results";
const EVALUATION: &str = "computed as long double here, by x87";
const LITERALS: &str = "_DOUBLE_LITERALS";

/// Expected result of the compilation.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Then {
    Same,
    Refused(&'static str),
}
use Then::{Refused, Same};

/// Flags, beside those for processors with FMA, and what becomes of the C.
type Told = (&'static [&'static str], Then);

const GCC: &[Told] = &[
    (&["-std=gnu99", "-ffp-contract=fast"], Same),
    (&["-fno-signed-zeros"], Refused(FAST)),
    (&["-frounding-math", "-fno-trapping-math", "-fno-math-errno"], Same),
    (&["-std=gnu99", "-ffp-contract=fast", "-flto"], Same),
    (&["-ffast-math"], Refused(FAST)),
    (&["-Ofast"], Refused(FAST)),
    (&["-ffinite-math-only"], Refused(FAST)),
    (&["-freciprocal-math"], Refused(FAST)),
    (&["-funsafe-math-optimizations"], Refused(FAST)),
    (&["-fassociative-math", "-fno-signed-zeros", "-fno-trapping-math"], Refused(FAST)),
    (&["-mfpmath=387"], Refused(EVALUATION)),
    (&["-fsingle-precision-constant"], Refused(LITERALS)),
];

const CLANG: &[Told] = &[
    (&["-std=gnu99", "-ffp-contract=on"], Same),
    (&["-freciprocal-math"], Same),
    (&["-fassociative-math"], Same),
    (&["-frounding-math", "-fno-trapping-math", "-fno-math-errno"], Same),
    (&["-ffast-math"], Refused(FAST)),
    (&["-Ofast"], Refused(FAST)),
    (&["-ffinite-math-only"], Refused(FAST)),
    (&["-ffp-model=fast"], Refused(FAST)),
    (&["-Xclang", "-cl-single-precision-constant"], Refused(LITERALS)),
];

/// The cases that the flags change.
fn sensitive() -> Vec<Case> {
    let chosen = |case: &&Case| case.name.contains("told_compilers");
    cases().iter().filter(chosen).cloned().collect()
}

fn holds(toolchain: &Toolchain, flags: &[&str], then: Then, cases: &[Case]) {
    match then {
        Same => run_c(corpus(), cases, toolchain, flags),
        Refused(why) => once(why, &(texts(&corpus().files), flags, toolchain.name()), || {
            let program = "#include \"told_compilers.h\"\n";
            let folder = lay_out_needed(&corpus().files, program).expect("the C");
            let mut command = toolchain.command();
            command.args(flags).arg("-fsyntax-only").arg(folder.path().join("told_compilers.c"));
            let said = run(&mut command).expect_err(&format!("{}: {flags:?}", toolchain.name()));
            assert!(said.contains(why), "{}: {flags:?}: {said}", toolchain.name());
        }),
    }
}

#[test]
fn no_flag_changes_bits_in_silence() {
    let cases = sensitive();
    assert!(cases.len() > 10);
    let Some(&fma) = toolchain::with_fma().first() else {
        println!("left out: this processor has no FMA");
        return;
    };
    thread::scope(|scope| {
        for (compiler, told) in [("gcc", GCC), ("clang", CLANG)] {
            let is = |it: &Toolchain| it.compiler == compiler && it.level == 3;
            let Some(toolchain) = toolchain::host().into_iter().find(is) else { continue };
            let toolchain = Toolchain { more: fma, ..toolchain };
            let cases = &cases;
            scope.spawn(move || {
                for (flags, then) in turn::some_of(told.to_vec(), told.len().div_ceil(4)) {
                    holds(&toolchain, flags, then, cases);
                }
            });
        }
    });
}

/// Variables that gcc initialises by itself, in a rotating part of the corpus: no literal of a struct loses a field.
#[test]
fn initialised_variables_change_no_bits() {
    let Some(gcc) = toolchain::host().into_iter().find(|it| it.compiler == "gcc") else { return };
    let some = turn::some_of(cases().to_vec(), cases().len().div_ceil(24));
    run_c(corpus(), &some, &Toolchain { level: 2, ..gcc }, &["-ftrivial-auto-var-init=pattern"]);
}

/// Calls of `phasor_mul`, and true if a compiler reports them: only the written argument must be disjoint.
const CALLS: [(&str, bool); 3] =
    [("&x, &y, &x", true), ("&x, &x, &z", false), ("&x, &y, &z", false)];

/// gcc reports a caller of public C whose result overwrites an operand.
#[test]
fn a_call_with_shared_memory_is_reported() {
    let Some(gcc) = toolchain::host().into_iter().find(|it| it.compiler == "gcc") else { return };
    for (arguments, reported) in CALLS {
        let program = format!(
            "#include \"own_operators.h\"\n\nvoid caller(void);\n\nvoid caller(void)\n{{\n\
             phasor_t x = {{ 1.0, 2.0 }};\nphasor_t y = x;\nphasor_t z = y;\nphasor_mul({arguments});\n\
             (void)y;\n(void)z;\n}}\n"
        );
        once(arguments, &(texts(&corpus().files), gcc.name()), || {
            let folder = lay_out_needed(&corpus().files, &program).expect("the C");
            let caller = folder.path().join("caller.c");
            std::fs::write(&caller, &program).expect("a source");
            let said = run(gcc.command().arg("-fsyntax-only").arg(&caller));
            let seen = matches!(&said, Err(said) if said.contains("-Werror=restrict"));
            assert_eq!(seen, reported, "{arguments}: {said:?}");
            assert!(seen || said.is_ok(), "{arguments}: {said:?}");
        });
    }
}

/// gcc's vectors contract on processors that can, whatever they are reported. In the full run, the whole corpus goes through.
#[test]
fn no_processor_changes_bits() {
    let cases = if turn::is_full() { cases().to_vec() } else { sensitive() };
    for toolchain in turn::one_of(toolchain::fusing()) {
        run_c(corpus(), &cases, &toolchain, &[]);
        run_c(corpus(), &cases, &Toolchain { level: 3, ..toolchain }, &[]);
    }
}

/// Processors of ARM with FMA: gcc contracts there as soon as nobody tells it not to.
#[test]
fn no_contraction_on_arm() {
    const A7: Toolchain = Toolchain {
        level: 3,
        machine: &["-mcpu=cortex-a7", "-mfpu=vfpv4", "-mfloat-abi=hard", "-static"],
        emulator: Some(&["qemu-arm", "-cpu", "cortex-a7"]),
        ..toolchain::ARM
    };
    if toolchain::target().is_empty() {
        return;
    }
    run_c(corpus(), &sensitive(), &A7, &["-std=gnu99", "-ffp-contract=fast"]);
}
