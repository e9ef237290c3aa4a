//! The elementary functions compute the same bits everywhere: the Rust, the C of each compiler, the C
//! on the emulated Cortex-A9. Points of all magnitudes, infinities and NaN among them; a hundred times
//! as many in `cargo xtask bench --only equality`.

#[path = "../mathematics/probe.rs"]
mod probe;

use std::process::Command;
use std::thread;

use bessemer_codegen::compile::{self, Compiled};
use bessemer_codegen::source::Sources;
use bessemer_codegen::{diagnostic, generate};
use bessemer_ir::{Float, Type};
use bessemer_tests::pilot::entry;
use bessemer_tests::process::{Process, lay_out};
use bessemer_tests::toolchain::{self, Toolchain, run};
use bessemer_tests::workspace::Workspace;
use probe::{POINTS, Probe};

/// How many functions `probe::double` knows.
const FUNCTIONS: u32 = 23;
/// Calls for each function: 100 000 points, in both precisions, and in `f32` alone.
const CALLS: u32 = 100;

/// The range of a call's arguments.
fn range(call: u32) -> f64 {
    [1.0, 12.5, 750.0, 1e6, 1e12, 1e-3][call as usize % 6]
}

fn compiled() -> Compiled {
    let text = format!("#![no_std]\n{}", include_str!("../mathematics/probe.rs"));
    let workspace = Workspace::with_source(&text).expect("a workspace");
    let root = workspace.path("");
    let package = generate::tree(&root, "models").unwrap_or_else(|error| panic!("{error}"));
    let sources = Sources::new(&root);
    compile::compile(&package, &sources, &compile::Options::default())
        .unwrap_or_else(|errors| panic!("{}", diagnostic::render(&errors, &sources, false)))
}

fn native() -> Vec<u64> {
    let mut probe = Probe::default();
    let calls = (0..FUNCTIONS).flat_map(|which| (0..CALLS).map(move |call| (which, call)));
    calls.map(|(which, call)| probe.step(which, range(call))).collect()
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
    let compiled = &compiled();
    let native = &native();
    thread::scope(|scope| {
        for toolchain in toolchain::all() {
            scope.spawn(move || {
                let bits = in_c(compiled, &toolchain);
                let parted = native.iter().zip(&bits).position(|(rust, c)| rust != c);
                let which = parted.map(|call| (call as u32 / CALLS, call as u32 % CALLS));
                assert_eq!(which, None, "{}: function and call that part", toolchain.name());
                println!(
                    "{}: {FUNCTIONS} functions on {} points each",
                    toolchain.name(),
                    CALLS * POINTS
                );
            });
        }
    });
}

/// Where the processor has a fused multiply-add, `mul_add` is that instruction.
#[test]
fn a_fused_instruction_computes_the_same_bits() {
    #[cfg(target_arch = "x86_64")]
    if std::arch::is_x86_feature_detected!("fma") {
        let compiled = compiled();
        let text: String = compiled.files.iter().map(|file| file.text.as_str()).collect();
        assert!(text.contains("return fma(x, a, b);") && text.contains("return fmaf(x, a, b);"));
        for toolchain in toolchain::host().into_iter().filter(|it| it.level != 3) {
            let toolchain = Toolchain { more: &["-mfma"], ..toolchain };
            assert_eq!(in_c(&compiled, &toolchain), native(), "{}", toolchain.name());
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

/// Read off the symbols of every object, with no function of the compiler's own: nothing is called but
/// the emitted functions and what is exact in every C library.
#[test]
fn no_call_slips_past_to_the_platform() {
    let compiled = compiled();
    let folder = lay_out(&compiled).expect("the C");
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
