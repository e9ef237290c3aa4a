//! Authors' requests for the C beside what the code does, through gcc and clang. They are names, sections, inlining,
//! entry points that roll back, external functions, and a hook in place of a status.

use std::path::PathBuf;

use bessemer_codegen::compile::{Compiled, Options};
use bessemer_codegen::generate::{explanation, table};
use bessemer_tests::interpreter::Interpreted;
use bessemer_tests::pilot::entry;
use bessemer_tests::process::lay_out;
use bessemer_tests::toolchain;
use bessemer_tests::workspace::Workspace;

const MODEL: &str = "//! A pump.
#![no_std]
use bessemer::prelude::*;

/// Counts what flows.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Pump {
    /// Strokes of each cylinder.
    pub strokes: [u8; 3],
    /// Litres so far.
    pub litres: f64,
}

/// The flow of a stroke, l, as the board measures it.
#[external(header = \"board.h\", name = \"board_flow\")]
pub fn flow(cylinder: u32, scale: f64) -> f64 {
    f64::from(cylinder).exp2() * scale
}

/// Returns the board's readings of all cylinders.
#[external(header = \"board.h\")]
pub fn board_pressures(scale: f32, pressures: &mut [f32; 3]) {
    for (i, pressure) in pressures.iter_mut().enumerate() {
        *pressure = scale * (i as f32 + 1.0);
    }
}

/// In a section of its own, and not where it is called.
#[function]
#[inline(never)]
#[c(name = \"pump_fast_sum\", section = \".fast\")]
pub fn sum(values: &[f32; 3]) -> f32 {
    values[0] + values[1] + values[2]
}

/// Always where it is called.
#[function]
#[inline(always)]
pub fn half(value: f64) -> f64 {
    value / 2.0
}

/// Called by the firmware alone, in which it is inlined.
#[function]
#[inline]
pub fn grown(value: f64) -> f64 {
    half(value).cosh()
}

#[component]
impl Pump {
    /// Strokes of two cylinders: all of it, or nothing.
    #[entry(atomic)]
    #[c(name = \"PumpStroke\")]
    pub fn stroke(&mut self, first: usize, second: usize, times: &mut u8) -> f64 {
        self.strokes[first] += 1;
        self.litres += half(flow(first.min(2) as u32, 2.0));
        *times += 1;
        self.strokes[second] += 2;
        self.litres
    }

    /// The mean pressure.
    #[entry(infallible)]
    pub fn pressure(&self, scale: f32) -> f32 {
        let mut pressures = [0.0; 3];
        board_pressures(scale, &mut pressures);
        sum(&pressures) / 3.0
    }

    /// Stops at a fault.
    #[entry]
    pub fn reset(&mut self, cylinder: usize) {
        self.litres = 0.0;
        self.strokes[cylinder] = 0;
    }
}
";

/// Header of the firmware.
const BOARD_H: &str = "#ifndef BOARD_H
#define BOARD_H
#include <stdint.h>
double board_flow(uint32_t cylinder, double scale);
void board_pressures(float scale, float pressures[3]);
#endif
";
const BOARD_C: &str = "#include \"board.h\"
#include <math.h>
double board_flow(uint32_t cylinder, double scale)
{
    return exp2((double)cylinder) * scale;
}
void board_pressures(float scale, float pressures[3])
{
    for (uint32_t i = 0U; i < 3U; i++) {
        pressures[i] = scale * ((float)i + 1.0F);
    }
}
";

const MAIN: &str = "#include \"bessemer_inline.h\"
#include \"pump.h\"
#include <stdio.h>
int main(void)
{
    pump_t pump;
    uint8_t times = 7U;
    double litres = -1.0;
    pump_init(&pump);
    printf(\"%d \", (int)PumpStroke(&pump, 0U, 1U, &times, &litres));
    printf(\"%d %d %d %a\\n\", pump.strokes[0], pump.strokes[1], times, litres);
    printf(\"%d \", (int)PumpStroke(&pump, 2U, 3U, &times, &litres));
    printf(\"%d %d %d %a\\n\", pump.strokes[2], pump.strokes[1], times, litres);
    printf(\"%d \", (int)PumpStroke(&pump, 2U, 1U, &times, &litres));
    printf(\"%d %d %d %a\\n\", pump.strokes[2], pump.strokes[1], times, litres);
    printf(\"%a\\n\", (double)pump_pressure(&pump, 0.5F));
    printf(\"%d\\n\", (int)pump_reset(&pump, 9U));
    printf(\"%d\\n\", (int)PumpStroke(&pump, 0U, 1U, &times, &litres));
    printf(\"%a\\n\", models_grown(0.0));
    return 0;
}
";

/// A fault ends the program by way of the hook; nothing behind it is printed.
const HOOKED: &str = "#include \"bessemer_status.h\"
#include \"pump.h\"
#include <stdio.h>
#include <stdlib.h>
void pump_fault(bessemer_status_t fault)
{
    printf(\"fault %d\\n\", (int)fault);
    exit(0);
}
int main(void)
{
    pump_t pump;
    uint8_t times = 7U;
    pump_init(&pump);
    printf(\"%a\\n\", PumpStroke(&pump, 0U, 1U, &times));
    printf(\"%a\\n\", PumpStroke(&pump, 0U, 5U, &times));
    return 1;
}
";

fn model() -> Workspace {
    Workspace::with_source(MODEL).expect("a workspace")
}

/// Returns the output of a program around the C, equal on each compiler.
fn printed(compiled: &Compiled, main: &str) -> String {
    let mut all = Vec::new();
    for toolchain in toolchain::all() {
        let folder = lay_out(compiled).expect("a folder");
        let path = |name: &str| folder.path().join(name);
        for (name, text) in [("board.h", BOARD_H), ("board.c", BOARD_C), ("main.c", main)] {
            std::fs::write(path(name), text).expect("a file");
        }
        let mut sources: Vec<PathBuf> = folder.sources().to_vec();
        sources.extend([path("board.c"), path("main.c")]);
        let program = path("program");
        toolchain.link(&sources, &program, &[]).unwrap_or_else(|said| panic!("{said}"));
        let output = toolchain.runner(&program).output().expect("a program");
        assert!(output.status.success(), "{}: {output:?}", toolchain.name());
        all.push(String::from_utf8_lossy(&output.stdout).into_owned());
    }
    all.dedup();
    assert_eq!(all.len(), 1, "{all:#?}");
    all.remove(0)
}

fn file<'c>(compiled: &'c Compiled, name: &str) -> &'c str {
    &compiled.files.iter().find(|file| file.name == name).expect("a file").text
}

#[test]
fn what_is_asked_of_the_c_is_done() {
    let workspace = model();
    let compiled = workspace.compiled().unwrap_or_else(|said| panic!("{said}"));

    // Rolled back, and not stopped by it; then stopped by the entry that does not roll back.
    // Half of twice a power of two: 1 for the first cylinder, 4 for the last.
    let (one, both) = (1.0, 5.0);
    let lines = printed(&compiled, MAIN);
    let numbers: Vec<Vec<&str>> = lines.lines().map(|line| line.split(' ').collect()).collect();
    assert_eq!(numbers[0][..4], ["0", "1", "2", "8"], "{lines}");
    assert_eq!(numbers[1][..4], ["4", "0", "2", "8"], "{lines}");
    assert_eq!(numbers[2][..4], ["0", "1", "4", "9"], "{lines}");
    assert_eq!(numbers[1][4], numbers[0][4], "{lines}");
    assert_eq!(hex(numbers[0][4]), one, "{lines}");
    assert_eq!(hex(numbers[2][4]), both, "{lines}");
    assert_eq!(hex(numbers[3][0]), 1.0, "{lines}");
    assert_eq!(numbers[4], ["4"], "{lines}");
    assert_eq!(numbers[5], ["4"], "{lines}");
    assert_eq!(hex(numbers[6][0]), 1.0, "{lines}");

    // The interpreter runs the stand-in, and rolls back, too.
    let stroke = entry(&compiled, "Pump", "stroke").expect("an entry point");
    let mut interpreted = Interpreted::new(&compiled.module, stroke);
    let words = interpreted.step(&[vec![0], vec![1], vec![7]]).expect("a step");
    assert_eq!(f64::from_bits(words[0]), one, "{words:x?}");
    interpreted.step(&[vec![2], vec![3], vec![7]]).expect_err("a fault");
    let words = interpreted.step(&[vec![2], vec![1], vec![7]]).expect("a step");
    assert_eq!(words[1..4], [1, 4, 1], "{words:x?}");
    assert_eq!(f64::from_bits(words[0]), both, "{words:x?}");

    let pump = file(&compiled, "pump.c");
    assert!(pump.contains("#include \"board.h\""), "{pump}");
    assert!(
        !compiled.files.iter().any(|file| file.name.starts_with("math")),
        "the stand-in's alone"
    );
    let own = file(&compiled, "models.c");
    assert!(
        own.contains("BESSEMER_SECTION(\".fast\") BESSEMER_NEVER_INLINE\nfloat pump_fast_sum("),
        "{own}"
    );
    let inline = file(&compiled, "bessemer_inline.h");
    let half = "BESSEMER_ALWAYS_INLINE\nstatic inline double models_half(";
    assert!(inline.contains(half), "{inline}");

    let table = table(&compiled);
    assert!(
        table.contains("rest on stand-ins")
            && table.contains("board_flow (board.h): controllers/src/"),
        "{table}"
    );
    let explained = explanation(&compiled);
    assert!(explained.contains("Pump::pressure: no check is left"), "{explained}");
    assert!(explained.contains("overflow: u8 + 1 may leave u8"), "{explained}");
}

#[test]
fn a_hook_stands_in_place_of_a_status() {
    let workspace = model();
    let options = Options { hook: Some("pump_fault".into()), ..Options::default() };
    let compiled = workspace.compiled_with(&options).unwrap_or_else(|said| panic!("{said}"));
    let header = file(&compiled, "pump.h");
    assert!(
        header.contains("double PumpStroke(pump_t *BESSEMER_RESTRICT self, uint64_t first,"),
        "{header}"
    );
    assert!(!header.contains("status"), "{header}");
    let lines = printed(&compiled, HOOKED);
    assert!(lines.ends_with("fault 4\n") && lines.lines().count() == 2, "{lines}");
}

/// A float as C's `%a` prints it.
fn hex(text: &str) -> f64 {
    let (sign, rest) = match text.strip_prefix('-') {
        Some(rest) => (-1.0, rest),
        None => (1.0, text),
    };
    let rest = rest.strip_prefix("0x").expect("a hexadecimal float");
    let (digits, exponent) = rest.split_once('p').expect("an exponent");
    let (whole, part) = digits.split_once('.').unwrap_or((digits, ""));
    let mantissa = u64::from_str_radix(&format!("{whole}{part}"), 16).expect("digits") as f64;
    let exponent: i32 = exponent.parse().expect("an exponent");
    sign * mantissa * 2f64.powi(exponent - 4 * part.len() as i32)
}
