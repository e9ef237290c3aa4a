//! The elementary functions compute the same bits everywhere: the Rust, the C of each compiler, the C
//! on the emulated Cortex-A9. Points of all magnitudes, infinities and NaN among them; a hundred times
//! as many in `cargo xtask bench --only equality`.

#[path = "../mathematics/probe.rs"]
mod probe;

use std::process::Command;
use std::sync::OnceLock;
use std::thread;

use bessemer_codegen::compile::{Compiled, Options};
use bessemer_ir::{Float, FunctionId, Type};
use bessemer_tests::pilot::entry;
use bessemer_tests::process::{Process, lay_out};
use bessemer_tests::store::once;
use bessemer_tests::toolchain::{self, ARM, Toolchain, run};
use bessemer_tests::watch::watched;
use bessemer_tests::workspace::Workspace;
use bessemer_tests::{harness, texts, turn};
use probe::{POINTS, Probe};

/// Number of functions that `probe::double` knows.
const FUNCTIONS: u32 = 23;
/// Calls for each function: 100 000 points, in both precisions, and in `f32` alone.
const CALLS: u32 = 100;

/// The range of a call's arguments.
fn range(call: u32) -> f64 {
    [1.0, 12.5, 750.0, 1e6, 1e12, 1e-3][call as usize % 6]
}

fn compiled() -> &'static Compiled {
    static COMPILED: OnceLock<Compiled> = OnceLock::new();
    COMPILED.get_or_init(compile)
}

fn compile() -> Compiled {
    let text = format!("#![no_std]\n{}", include_str!("../mathematics/probe.rs"));
    let workspace = Workspace::with_source(&text).expect("a workspace");
    workspace.compiled().unwrap_or_else(|said| panic!("{said}"))
}

fn native() -> Vec<u64> {
    let mut probe = Probe::default();
    let calls = (0..FUNCTIONS).flat_map(|which| (0..CALLS).map(move |call| (which, call)));
    calls.map(|(which, call)| probe.step(which, range(call))).collect()
}

fn hold(compiled: &Compiled, toolchain: &Toolchain, native: &[u64]) {
    once("elementary functions", &(texts(&compiled.files), toolchain, native), || {
        let bits = in_c(compiled, toolchain);
        let parted = native.iter().zip(&bits).position(|(rust, c)| rust != c);
        let which = parted.map(|call| (call as u32 / CALLS, call as u32 % CALLS));
        assert_eq!(which, None, "{}: function and call that part", toolchain.name());
    });
    println!("{}: {FUNCTIONS} functions on {} points each", toolchain.name(), CALLS * POINTS);
}

fn in_c(compiled: &Compiled, toolchain: &Toolchain) -> Vec<u64> {
    let step = entry(compiled, "Probe", "step").expect("the probe has a step");
    let mut process = Process::start(compiled, step, toolchain)
        .unwrap_or_else(|error| panic!("{}: {error}", toolchain.name()));
    let calls = (0..FUNCTIONS).flat_map(|which| (0..CALLS).map(move |call| (which, call)));
    calls
        .map(|(which, call)| {
            let said = process.step(&[which.into(), range(call).to_bits()]);
            said.expect("the process answers")[1]
        })
        .collect()
}

#[test]
fn every_elementary_function_computes_the_same_bits() {
    let compiled = compiled();
    let native = &native();
    thread::scope(|scope| {
        for toolchain in turn::levels(toolchain::all()) {
            scope.spawn(move || hold(compiled, &toolchain, native));
        }
    });
}

/// Checks that `mul_add` is an instruction if the processor has a fused multiply-add.
#[test]
fn a_fused_instruction_computes_the_same_bits() {
    #[cfg(target_arch = "x86_64")]
    if std::arch::is_x86_feature_detected!("fma") {
        let compiled = compiled();
        let text: String = compiled.files.iter().map(|file| file.text.as_str()).collect();
        assert!(text.contains("return fma(x, a, b);") && text.contains("return fmaf(x, a, b);"));
        let native = native();
        for toolchain in turn::levels(toolchain::host()) {
            hold(compiled, &Toolchain { more: &["-mfma"], ..toolchain }, &native);
        }
        return;
    }
    println!("left out: this processor has no such instruction");
}

#[test]
fn no_table_is_larger_than_two_kibibytes() {
    let compiled = compiled();
    let tables: Vec<_> =
        compiled.explicit.consts.iter().filter(|item| item.words.len() > 1).collect();
    assert!(tables.len() > 10, "the functions have tables");
    let bytes = |leaf: &Type| match (leaf.as_int(), leaf.as_float()) {
        (Some(int), _) => int.bits() / 8,
        (_, Some(Float::F32)) => 4,
        _ => 8,
    };
    for table in tables {
        let size: u32 = compiled.explicit.leaves(&table.ty).iter().map(bytes).sum();
        assert!(size <= 2048, "{}: {size} bytes", table.name);
    }
}

/// Checks the symbols of every object, with the compiler's own functions off. The only calls are to emitted functions
/// and to exact functions of every C library.
#[test]
fn no_call_slips_past_to_the_platform() {
    let compiled = compiled();
    once("calls of a library", &texts(&compiled.files), || nothing_else_is_called(compiled));
}

fn nothing_else_is_called(compiled: &Compiled) {
    let folder = lay_out(compiled).expect("the C");
    for toolchain in toolchain::host().iter().filter(|it| it.level == 0) {
        let (mut defined, mut called) = (Vec::new(), Vec::new());
        for source in folder.sources() {
            let object = source.with_extension("o");
            let mut command = toolchain.command();
            command.args(["-fno-builtin", "-c"]).arg(source).arg("-o").arg(&object);
            run(&mut command).expect("an object");
            let symbols = Command::new("nm").arg(&object).output().expect("nm");
            for line in String::from_utf8_lossy(&symbols.stdout).lines() {
                let mut words = line.split_whitespace().rev();
                let name = words.next().unwrap_or_default().to_owned();
                match words.next() {
                    // Functions, and tables that several files share.
                    Some("T" | "t" | "R" | "r") => defined.push(name),
                    Some("U") => called.push(name),
                    _ => {}
                }
            }
        }
        called.retain(|name| !defined.contains(name) && name != "_GLOBAL_OFFSET_TABLE_");
        called.sort();
        called.dedup();
        let exact = ["copysign", "copysignf", "fabs", "fabsf", "floor", "floorf", "sqrt", "sqrtf"];
        assert!(defined.iter().any(|name| name.ends_with("hypot")), "the functions are here");
        for name in &called {
            assert!(exact.contains(&name.as_str()), "{}: `{name}` is called", toolchain.name());
        }
    }
}

/// Some teams' compilers take `==` of floats for an error: the functions have none, whatever their callers do.
#[test]
fn no_floats_are_compared_for_equality() {
    let compiled = compiled();
    once("floats compared", &texts(&compiled.files), || no_float_is_compared(compiled));
}

fn no_float_is_compared(compiled: &Compiled) {
    let folder = lay_out(compiled).expect("the C");
    for toolchain in toolchain::host().iter().filter(|it| it.level == 0) {
        for source in folder.sources().iter().filter(|it| !it.ends_with("models.c")) {
            let mut command = toolchain.command();
            command.args(["-fsyntax-only", "-Wfloat-equal", "-Werror"]).arg(source);
            run(&mut command).unwrap_or_else(|said| panic!("{}: {said}", toolchain.name()));
        }
    }
}

/// Firmware often tells its compiler to know no library. With `-fbuiltin` behind that, as the build files have it, a function takes
/// at most a twentieth more instructions on the Cortex-A9; without, where `fabs` and its like are calls, a quarter. In a full
/// run, since each of the three compiles all of them.
#[test]
fn it_takes_few_more_instructions_where_the_library_is_unknown() {
    let programs = [ARM.programs(), toolchain::GCC.programs()].concat();
    let is_there = programs.into_iter().all(toolchain::is_asked_for);
    if !is_there || !turn::is_full() {
        return;
    }
    let compiled = compiled();
    let functions: Vec<_> = functions(compiled);
    assert!(functions.len() > 30, "{} functions", functions.len());
    let flags: [&[&str]; 3] = [
        &[],
        &["-ffreestanding", "-fno-builtin", "-fbuiltin"],
        &["-ffreestanding", "-fno-builtin"],
    ];
    let [known, told, unknown] =
        flags.map(|more| instructions(compiled, &Toolchain { more, ..ARM }, &functions));
    let mut dearer = Vec::new();
    for (at, (id, _)) in functions.iter().enumerate() {
        let name = &compiled.explicit.functions[id.index()].name;
        let (known, told, unknown) = (known[at], told[at], unknown[at]);
        println!("{name}: {known} instructions, {told} with -fbuiltin, {unknown} without");
        if told * 100 > known * 105 || unknown * 100 > known * 125 {
            dearer.push(format!("{name}: {known}, {told} and {unknown}"));
        }
    }
    assert!(dearer.is_empty(), "{dearer:#?}");
}

/// The elementary functions in both precisions, with the number of their arguments.
fn functions(compiled: &Compiled) -> Vec<(FunctionId, u32)> {
    const NAMES: [&str; 19] = [
        "sin", "cos", "tan", "asin", "acos", "atan", "atan2", "exp", "exp2", "exp_m1", "ln",
        "log2", "log10", "ln_1p", "sinh", "cosh", "tanh", "cbrt", "hypot",
    ];
    let functions = compiled.explicit.functions.iter().enumerate();
    let is_one =
        |name: &str| NAMES.iter().any(|it| name == *it || name.strip_suffix('f') == Some(*it));
    let chosen =
        functions.filter(|(_, it)| it.module.starts_with("bessemer::math::") && is_one(&it.name));
    chosen.map(|(index, it)| (FunctionId(index as u32), it.params)).collect()
}

/// The instructions of each function over the same arguments, as models have them.
fn instructions(
    compiled: &Compiled,
    toolchain: &Toolchain,
    functions: &[(FunctionId, u32)],
) -> Vec<u64> {
    const CALLS: u32 = 64;
    let folder = lay_out(compiled).expect("the C");
    let main = folder.path().join("instructions_main.c");
    let text = harness::watched(&compiled.explicit, functions, &Options::default(), toolchain.bare);
    std::fs::write(&main, text).expect("the program");
    let mut input = Vec::new();
    for (place, (id, _)) in (0u64..).zip(functions) {
        for call in 0..CALLS {
            input.extend(place.to_le_bytes());
            for (index, local) in
                compiled.explicit.functions[id.index()].parameters().iter().enumerate()
            {
                // Within what each of them is defined on.
                let value = f64::from(call * 2 + 1 + index as u32) / f64::from(CALLS * 2 + 2);
                let word = match local.ty.as_float() {
                    Some(Float::F32) => u64::from((value as f32).to_bits()),
                    _ => value.to_bits(),
                };
                input.extend(word.to_le_bytes());
            }
        }
    }
    let watched = watched(toolchain, folder.path(), &main, folder.sources(), &input);
    let counts = watched.unwrap_or_else(|said| panic!("{}: {said}", toolchain.name())).counts;
    assert_eq!(counts.len(), functions.len() * CALLS as usize);
    counts.chunks(CALLS as usize).map(|counts| counts.iter().sum()).collect()
}
