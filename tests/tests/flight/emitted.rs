//! The emitted C as a product: clean under every compiler, and free of what firmware does not take.

use std::path::PathBuf;
use std::process::Command;

use bessemer_tests::process::lay_out;
use bessemer_tests::toolchain::{self, Toolchain, run};
use bessemer_tests::{flight_models, root, turn};

#[test]
fn it_compiles_without_a_warning() {
    let folder = lay_out(flight_models()).expect("the C");
    std::thread::scope(|scope| {
        for toolchain in turn::levels(toolchain::all()) {
            let folder = &folder;
            scope.spawn(move || {
                for source in folder.sources() {
                    toolchain
                        .object(source, &[])
                        .unwrap_or_else(|said| panic!("{}: {said}", toolchain.name()));
                }
            });
        }
    });
}

#[test]
fn its_headers_compile_as_cpp_each_on_its_own() {
    let folder = lay_out(flight_models()).expect("the C");
    let headers = flight_models().files.iter().filter(|file| file.name.ends_with(".h"));
    for header in headers {
        for compiler in toolchain::host().iter().filter(|it| it.level == 2) {
            check_cpp(compiler, &folder.path().join(&header.name));
        }
    }
}

fn check_cpp(toolchain: &Toolchain, header: &PathBuf) {
    let mut command = Command::new(toolchain.compiler);
    command.args(["-x", "c++", "-std=c++11", "-Wall", "-Wextra", "-Wpedantic", "-Werror"]);
    command
        .arg("-fsyntax-only")
        .args(["-Wno-pragma-once-outside-header", "-Wno-unused-function"])
        .arg("-Wno-unused-const-variable")
        .arg(header);
    run(&mut command).unwrap_or_else(|said| panic!("{said}"));
}

/// Checks the symbols, so that no spelling can hide one. Nothing that is written is outside the caller's memory, and
/// the only calls are to the files' own functions and the exact ones of `math.h`.
#[test]
fn it_has_no_heap_and_no_memory_of_its_own() {
    let folder = lay_out(flight_models()).expect("the C");
    let toolchains = toolchain::host();
    let Some(toolchain) = toolchains.iter().find(|it| it.level == 0) else { return };
    let (mut defined, mut called) = (Vec::new(), Vec::new());
    for source in folder.sources() {
        let (object, _) = toolchain.object(source, &[]).expect("an object");
        let symbols = Command::new("nm").arg(&object).output().expect("nm");
        for line in String::from_utf8_lossy(&symbols.stdout).lines() {
            let mut words = line.split_whitespace().rev();
            let (name, kind) = (words.next().unwrap_or_default(), words.next().unwrap_or_default());
            match kind {
                "T" | "t" => defined.push(name.to_owned()),
                "U" => called.push(name.to_owned()),
                // Constants, some of which other files use.
                "r" => {}
                "R" => defined.push(name.to_owned()),
                _ => panic!("{}: `{name}` is a {kind}: written memory", source.display()),
            }
        }
    }
    let allowed = [
        "sqrt", "sqrtf", "floor", "floorf", "fabs", "fabsf", "fmod", "fmodf", "copysign", "memcpy",
        "memset",
    ];
    for name in called {
        let known = defined.contains(&name) || allowed.contains(&name.as_str());
        assert!(known || name == "_GLOBAL_OFFSET_TABLE_", "`{name}` is called");
    }
}

#[test]
fn every_loop_counts_to_a_bound() {
    for file in &flight_models().files {
        for line in file.text.lines().map(str::trim) {
            assert!(
                !line.starts_with("while") && !line.starts_with("do "),
                "{}: {line}",
                file.name
            );
            assert!(!line.starts_with("goto"), "{}: {line}", file.name);
            if let Some(head) = line.strip_prefix("for (") {
                assert_eq!(head.matches(';').count(), 2, "{}: {line}", file.name);
                assert!(head.contains('<') || head.contains('>'), "{}: {line}", file.name);
            }
        }
    }
}

/// Line numbers, versions and dates would move with every edit.
#[test]
fn it_says_nothing_that_ages() {
    for file in &flight_models().files {
        assert!(!file.text.contains(env!("CARGO_PKG_VERSION")), "{}", file.name);
        assert!(!file.text.contains("__LINE__") && !file.text.contains(".rs:"), "{}", file.name);
    }
}

#[test]
fn what_is_committed_is_what_the_models_give() {
    for file in &flight_models().files {
        let committed = std::fs::read_to_string(root().join("generated").join(&file.name));
        assert_eq!(
            committed.ok().as_ref(),
            Some(&file.text),
            "{}: run `cargo xtask gen`",
            file.name
        );
    }
}

/// The author's names, comments, functions and branches.
#[test]
fn the_controller_keeps_its_authors_words() {
    let text = |name: &str| {
        let file = flight_models().files.iter().find(|file| file.name == name);
        file.map(|file| file.text.as_str()).unwrap_or_default()
    };
    let (header, source) = (text("height.h"), text("height.c"));
    let step =
        "Advances one control period and returns the commanded thrust (thesis, eq. (3.14)), N.";
    assert!(header.contains(step));
    assert!(header.contains("/** Integral of the height error, m·s. */"));
    for line in [
        "const double weight = parameters->mass * AIRFRAME_GRAVITY;",
        "if (target->take_off) {",
        "return weight + parameters->takeoff_gain * weight;",
        "const double error = target->position[2] - height;",
        "const double integral = self->integral + error * parameters->period;",
    ] {
        assert!(source.contains(line), "{line}");
    }
    assert!(text("cascade.c").contains("/* Commanded thrust and tilt. */"));
}

/// Calls of `reference_generator_step` on a Cortex-A9 took up to 13,356 instructions.
///
/// The yaw setpoint may be as far from the yaw as a float can be. `fmod` subtracts once for each binary place of the
/// quotient.
#[test]
fn an_estimate_includes_the_longest_remainder() {
    let compiled = flight_models();
    let estimates = bessemer_codegen::estimate::estimates(&compiled.explicit);
    let entry = compiled.entries.iter().find(|it| it.entry == "reference_generator_step");
    let cost = entry.and_then(|it| estimates[it.function.index()].cost).unwrap_or_default();
    assert!(cost.instructions >= 13_356, "{cost:?}");
}
