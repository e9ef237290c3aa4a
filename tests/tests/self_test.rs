//! `bessemer_self_test`: silent where the C computes the same bits, and telling what is wrong wherever it would not.
//!
//! Compilers that guards reach are tried without these, too: so does one compile that knows no such pragmas.

use std::path::PathBuf;

use bessemer_backend::c::{self, CFile, Options};
use bessemer_ir::Module;
use bessemer_tests::store::once;
use bessemer_tests::toolchain::{self, Toolchain};
use bessemer_tests::{texts, turn};
use tempfile::TempDir;

const FORMAT: u32 = 1;
const LITERALS: u32 = 2;
const ROUNDING: u32 = 4;
const SUBNORMALS: u32 = 8;
const PRECISION: u32 = 16;
const CONTRACTION: u32 = 32;
const ORDER: u32 = 64;
const RECIPROCAL: u32 = 128;
const ZEROS: u32 = 256;
const FINITE: u32 = 512;
const LIBRARY: u32 = 1024;
const SOFTWARE: u32 = 2048;

/// Sets the processor as the first argument says, and asks.
const MAIN: &str = r#"
#include "bessemer_self_test.h"
#include <fenv.h>
#include <math.h>
#include <stdio.h>
#if defined(__SSE__)
#include <xmmintrin.h>
#endif

/* A library's that is wrong, by the name that a macro gives it. */
#if defined(sqrt)
double sqrt(double x)
{
    return (x == 2.0) ? 1.5 : x;
}
#endif
#if defined(floor)
double floor(double x)
{
    return (double)(long)x;
}
#endif

int main(int count, char **arguments)
{
    const char set = (count > 1) ? arguments[1][0] : ' ';
    if (set == 'u') {
        (void)fesetround(FE_UPWARD);
    } else if (set == 'd') {
        (void)fesetround(FE_DOWNWARD);
    } else if (set == 'z') {
        (void)fesetround(FE_TOWARDZERO);
    }
#if defined(__SSE__)
    if (set == 'f') {
        _mm_setcsr(_mm_getcsr() | 0x8000U);
    } else if (set == 'n') {
        _mm_setcsr(_mm_getcsr() | 0x0040U);
    }
#endif
    return (printf("%u\n", (unsigned)bessemer_self_test()) > 0) ? 0 : 1;
}
"#;

fn files() -> Vec<CFile> {
    c::emit(&Module::default(), &Options { self_test: true, ..Options::default() })
}

/// The files and a program around them, with each line of the source as `change` has it.
fn laid_out(change: impl Fn(&str) -> Option<String>) -> (TempDir, Vec<PathBuf>) {
    let folder = tempfile::tempdir().expect("a folder");
    let place = |name: &str| folder.path().join(name);
    std::fs::write(place("main.c"), MAIN).expect("a file");
    for file in files() {
        let lines = file.text.lines().filter_map(|line| match file.name.ends_with(".c") {
            true => change(line),
            false => Some(line.to_owned()),
        });
        let text: String = lines.map(|line| line + "\n").collect();
        std::fs::write(place(&file.name), text).expect("a file");
    }
    let sources = vec![place("main.c"), place("bessemer_self_test.c")];
    (folder, sources)
}

fn guarded(line: &str) -> Option<String> {
    Some(line.to_owned())
}

fn unguarded(line: &str) -> Option<String> {
    (!line.starts_with("#pragma")).then(|| line.to_owned())
}

/// Returns the answer of the self test.
fn answer(
    laid: &(TempDir, Vec<PathBuf>),
    toolchain: &Toolchain,
    flags: &[&str],
    set: Option<&str>,
) -> u32 {
    let (folder, sources) = laid;
    let program = folder.path().join("program");
    let name = format!("{} {flags:?} {set:?}", toolchain.name());
    toolchain.link(sources, &program, flags).unwrap_or_else(|said| panic!("{name}: {said}"));
    let output = toolchain.runner(&program).args(set).output().expect("it runs");
    let text = String::from_utf8_lossy(&output.stdout);
    text.trim().parse().unwrap_or_else(|_| panic!("{name}: {text}"))
}

fn host(compiler: &str, level: u32) -> Option<Toolchain> {
    toolchain::host().into_iter().find(|it| (it.compiler, it.level) == (compiler, level))
}

/// Every compiler, warnings and all.
#[test]
fn it_is_silent_where_all_is_well() {
    once("silence", &texts(&files()), all_is_well);
}

fn all_is_well() {
    let laid = laid_out(guarded);
    for toolchain in toolchain::all().into_iter().chain(turn::others()) {
        assert_eq!(answer(&laid, &toolchain, &[], None), 0, "{}", toolchain.name());
    }
    for more in toolchain::with_fma() {
        for toolchain in toolchain::host() {
            let toolchain = Toolchain { more, ..toolchain };
            assert_eq!(answer(&laid, &toolchain, &[], None), 0, "{}", toolchain.name());
        }
    }
}

/// Register fields that differ from the processor's usual state, by their names above.
const SET: [(&str, u32); 5] =
    [("u", ROUNDING), ("d", ROUNDING), ("z", ROUNDING), ("f", SUBNORMALS), ("n", SUBNORMALS)];

#[test]
fn it_tells_how_the_processor_is_set() {
    once("settings of a processor", &texts(&files()), each_setting_is_told);
}

fn each_setting_is_told() {
    let laid = laid_out(guarded);
    for compiler in ["gcc", "clang"] {
        let Some(toolchain) = host(compiler, 2) else { continue };
        for (set, expected) in SET {
            let got = answer(&laid, &toolchain, &[], Some(set));
            assert_eq!(got & expected, expected, "{compiler} {set}: {got}");
        }
    }
}

/// Flags, whether the guards stay, and what it tells.
type Told = (&'static [&'static str], bool, u32);

const GCC: &[Told] = &[
    (&["-std=gnu99", "-ffp-contract=fast", "-mfma"], true, 0),
    (&["-std=gnu99", "-ffp-contract=fast", "-mfma"], false, CONTRACTION),
    // gcc's own vectors, whatever it is reported.
    (&["-march=x86-64-v3"], false, CONTRACTION),
    (&["-ffast-math"], true, SUBNORMALS | ORDER | RECIPROCAL | FINITE),
    (&["-ffinite-math-only"], true, FINITE),
    (&["-freciprocal-math"], true, RECIPROCAL),
    (&["-fassociative-math", "-fno-signed-zeros", "-fno-trapping-math"], true, ORDER),
    (&["-fno-signed-zeros"], true, 0),
    (&["-fno-signed-zeros"], false, ZEROS),
    (&["-fsingle-precision-constant"], true, LITERALS),
    (&["-mfpmath=387"], true, PRECISION),
    (&["-Dsqrt=wrong_sqrt"], true, LIBRARY),
    (&["-Dfloor=wrong_floor"], true, LIBRARY),
];

const CLANG: &[Told] = &[
    (&["-ffp-contract=on", "-mfma"], true, 0),
    (&["-ffp-contract=on", "-mfma"], false, CONTRACTION),
    // No pragma of clang's takes this one back, and no macro tells of it.
    (&["-ffp-contract=fast", "-mfma"], true, CONTRACTION),
    (&["-fno-signed-zeros"], true, ZEROS),
    (&["-ffast-math"], true, SUBNORMALS | FINITE),
    (&["-ffinite-math-only"], true, FINITE),
    (&["-freciprocal-math"], true, 0),
    (&["-freciprocal-math"], false, RECIPROCAL),
    (&["-fassociative-math", "-fno-signed-zeros", "-fno-trapping-math"], false, ORDER | ZEROS),
    (&["-Dsqrt=wrong_sqrt"], true, LIBRARY),
];

#[test]
fn it_tells_what_a_compiler_was_told() {
    once("flags", &texts(&files()), each_flag_is_told);
}

fn each_flag_is_told() {
    let (kept, bare) = (laid_out(guarded), laid_out(unguarded));
    for (compiler, told) in [("gcc", GCC), ("clang", CLANG)] {
        let Some(toolchain) = host(compiler, 3) else { continue };
        for (flags, guards, expected) in told {
            if toolchain::with_fma().is_empty() && flags.iter().any(|it| it.starts_with("-m")) {
                continue;
            }
            let flags: Vec<&str> = flags.iter().copied().chain(["-w"]).collect();
            let laid = if *guards { &kept } else { &bare };
            let got = answer(laid, &toolchain, &flags, None);
            let wrong = got & expected != *expected || *expected == 0 && got != 0;
            assert!(!wrong, "{compiler} {flags:?}, guards {guards}: {got}, not {expected}");
        }
    }
}

/// As AVR has it.
#[test]
fn it_tells_of_doubles_of_four_bytes() {
    let laid = laid_out(|line| Some(line.replace("double", "float")));
    let Some(gcc) = host("gcc", 2) else { return };
    assert_eq!(answer(&laid, &gcc, &["-w"], None), FORMAT);
}

/// Asks on a machine without an operating system: a file of its emulator's takes the answer (`legs/c/semihosting.c`).
const BARE_MAIN: &str = r#"
#include "bessemer_self_test.h"
#include <stdio.h>

extern FILE *words_out;

int main(void)
{
    return (fprintf(words_out, "%u\n", (unsigned)bessemer_self_test()) > 0) ? 0 : 1;
}
"#;

/// Returns the answer on such a machine.
fn bare_answer(toolchain: &Toolchain) -> u32 {
    let (folder, mut sources) = laid_out(guarded);
    std::fs::write(&sources[0], BARE_MAIN).expect("a file");
    sources.push(bessemer_tests::root().join("legs/c/semihosting.c"));
    std::fs::write(folder.path().join("words.in"), "").expect("a file");
    let program = folder.path().join("program");
    toolchain.link(&sources, &program, &["-w"]).unwrap_or_else(|said| panic!("{said}"));
    toolchain.runner(&program).current_dir(folder.path()).output().expect("it runs");
    let text = std::fs::read_to_string(folder.path().join("words.out")).expect("an answer");
    text.trim().parse().unwrap_or_else(|_| panic!("{text}"))
}

/// A Cortex-M4F has no `double`, and libgcc's sums are not always the nearest; a Cortex-M7 has them in hardware.
#[test]
fn it_tells_of_sums_in_software_that_round_wrongly() {
    for (toolchain, expected) in [(toolchain::CORTEX_M4F, SOFTWARE), (toolchain::CORTEX_M7, 0)] {
        if toolchain.is_there() {
            assert_eq!(bare_answer(&toolchain), expected, "{:?}", toolchain.machine);
        }
    }
}
