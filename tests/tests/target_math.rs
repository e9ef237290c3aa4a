//! `math = Target`: the C calls the target's `math.h` in place of the DSL's functions, and the report
//! says so.

use std::fs;
use std::process::Command;

use bessemer_codegen::compile::Math;
use bessemer_codegen::generate;
use bessemer_tests::toolchain::{self, run};
use bessemer_tests::workspace::Workspace;

const MODEL: &str = "//! Angles.
#![no_std]
use bessemer::prelude::*;

/// A heading, its logarithm, and what stays the DSL's.
#[function]
pub fn heading(x: f64, y: f64, z: f32) -> [f64; 3] {
    [y.atan2(x), x.ln() + z.powf(0.3) as f64, x.mul_add(y, 1.0) + y.powi(3)]
}

/// A vector of this length and direction.
#[function]
pub fn directed(length: f64, angle: f32) -> [f64; 2] {
    let (sine, cosine) = angle.sin_cos();
    let (_, other) = length.sin_cos();
    [length * sine as f64, other * cosine as f64]
}
";

#[test]
fn the_targets_functions_stand_for_the_dsls() {
    let workspace = Workspace::with_source(MODEL).expect("a workspace");
    let mut job = workspace.job();
    let portable = workspace.perform(&job).expect("generated").compiled;
    assert!(portable.library.is_empty());
    assert!(!generate::table(&portable).contains("math.h"));

    job.options.math = Math::Target;
    let summary = workspace.perform(&job).expect("generated");
    assert_eq!(summary.compiled.library, ["atan2", "cos", "cosf", "log", "powf", "sin", "sinf"]);
    let said = generate::table(&summary.compiled);
    assert!(
        said.contains("the target's math.h (atan2, cos, cosf, log, powf, sin, sinf)"),
        "{said}"
    );
    let manifest = fs::read_to_string(job.output.join("manifest.json")).expect("a manifest");
    assert!(manifest.contains("target_math"), "{manifest}");

    let source = fs::read_to_string(job.output.join("models.c")).expect("the C");
    for call in ["= atan2(y, x);", "log(x) + (double)powf(z, 0.3F)", "fused_mul_add(x, y, 1.0)"] {
        assert!(source.contains(call), "{source}");
    }
    let pairs = fs::read_to_string(job.output.join("single.c")).expect("the C");
    let both = "    result->first = sinf(x);\n    result->second = cosf(x);\n}";
    assert!(pairs.contains(both) && !pairs.contains("reduction"), "{pairs}");
    // No code and no table of what is not called is left.
    let names: Vec<_> = summary.compiled.files.iter().map(|file| file.name.as_str()).collect();
    assert!(names.contains(&"fused.c") && !names.contains(&"logarithm.c"), "{names:?}");
    assert!(!names.contains(&"exponential.c") && !names.contains(&"arctangent.c"), "{names:?}");

    for toolchain in toolchain::host().iter().filter(|it| it.level == 0) {
        let mut called = String::new();
        for file in summary.compiled.files.iter().filter(|file| file.name.ends_with(".c")) {
            let object = job.output.join(&file.name).with_extension("o");
            let mut command = toolchain.command();
            command.arg("-c").arg(job.output.join(&file.name)).arg("-o").arg(&object);
            run(&mut command).expect("an object");
            let symbols = Command::new("nm").arg(&object).output().expect("nm");
            called += &String::from_utf8_lossy(&symbols.stdout);
        }
        for name in ["atan2", "log", "powf", "sin", "cosf"] {
            assert!(called.contains(&format!(" U {name}\n")), "{}: {called}", toolchain.name());
        }
    }
}
