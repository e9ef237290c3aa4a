//! `cargo bessemer` from the user's view: a package is created, simulated, generated and built into firmware. Errors
//! that only a build of models reveals are included.

mod built;
mod described;
mod dossier;
mod observer;
mod templates;
mod units;
mod verified;

use std::fs;
use std::path::Path;
use std::process::Command;

use bessemer_project::{Wanted, generate};
use bessemer_tests::golden;
use bessemer_tests::toolchain;
use bessemer_tests::workspace::Workspace;
use cargo_bessemer::args::{Fmu, New, Python, Sizes, Vectors};
use cargo_bessemer::{fmu, new, python, sizes, vectors};

/// Returns the output of `gen` in a folder, without colours; none if it failed.
fn generated(folder: &Path, check: bool) -> Result<String, String> {
    let outcome = generate(folder, Wanted { check, ..Wanted::default() });
    outcome
        .map(|done| done.text)
        .map_err(|error| anstream::adapter::strip_str(&error.text()).to_string())
}

/// One test, since all of it is one package, built once.
#[test]
fn a_new_package_is_simulated_and_generated() {
    let workspace = Workspace::for_package("motor").expect("a workspace");
    let wanted =
        New { name: "motor".to_owned(), template: None, path: Some(".".into()), git: None };
    let said = new::run(&workspace.path(""), &wanted).expect("it is new");
    assert!(said.contains("cargo bessemer gen") && !said.contains("`members`"), "{said}");
    let package = workspace.path("motor");

    workspace.run_test(&package, "closed_loop").unwrap_or_else(|said| panic!("{said}"));

    // From a folder in it, and to where its own settings say.
    let said = generated(&package.join("src"), false).expect("it is sound");
    assert!(said.contains("motor_step"), "{said}");
    the_tutorial_shows_it(&package, &said);
    assert!(!workspace.path("generated").exists());
    assert_eq!(generated(&package, true).as_deref(), Ok(""));

    // The stub around it computes what the closed loop begins with.
    for gcc in toolchain::host().into_iter().filter(|it| it.level == 2) {
        let program = package.join("stub");
        let sources = fs::read_dir(package.join("generated")).expect("the C").flatten();
        let sources =
            sources.map(|it| it.path()).filter(|it| it.extension().is_some_and(|it| it == "c"));
        let mut compile = gcc.command();
        compile.arg("-Igenerated").arg("firmware/main.c").args(sources).args(["-lm", "-o"]);
        toolchain::run(compile.arg(&program).current_dir(&package))
            .unwrap_or_else(|said| panic!("{said}"));
        let output = Command::new(&program).output().expect("it runs");
        let text = String::from_utf8_lossy(&output.stdout).into_owned();
        assert_eq!(text, STUB, "{}", gcc.name());
    }

    built::by_cmake_and_make(&package);
    super::shown::run(&package);
    verified::verified(&package);
    verified::verified_by_a_recording(&package);
    verified::verified_by_flight_logs(&package);
    verified::verified_by_a_test(&package);
    verified::verified_on_a_board(&package);
    sized(&package);
    dossier::run(&package);
    built::packed(&package);
    called_from_python(&package);
    simulated_as_a_unit(&package);
    in_vectors(&package);
    described::run(&package);
    units::run(&package);
    refusals(&package);
}

/// Output of a firmware's stub: 0.05 · 100 V, and 2 · 100 · 1 ms more each period.
const STUB: &str = "5\n5.2000000000000002\n5.4000000000000004\n";

/// The tutorial and the README quote these files.
fn the_tutorial_shows_it(package: &Path, report: &str) {
    let read = |name| fs::read_to_string(package.join("generated").join(name)).expect("the C");
    let files = [
        ("motor.h", read("motor.h")),
        ("motor.c", read("motor.c")),
        ("report.txt", report.to_owned()),
    ];
    let folder = Path::new("tests/corpus/golden/tutorial");
    let stale = files.iter().filter(|(name, text)| !golden::holds(&folder.join(name), text));
    let names: Vec<&str> = stale.map(|(name, _)| *name).collect();
    let asked = "UPDATE_DOCS=1 cargo test -p bessemer-tests command::";
    assert!(names.is_empty(), "{}: stale: {names:?}; {asked}", folder.display());
}

/// Checks that an entry point's part is less than all, and not zero.
fn sized(package: &Path) {
    let text = sizes::run(package, &Sizes::default(), false);
    let text = text.unwrap_or_else(|error| panic!("{error}"));
    let figures = |name: &str| -> Vec<u64> {
        let row = text.lines().find_map(|line| line.trim_start().strip_prefix(name));
        let words = row.unwrap_or_else(|| panic!("{text}")).split_whitespace();
        words.filter_map(|word| word.parse().ok()).collect()
    };
    let (entry, all) = (figures("motor_step"), figures("all of the C"));
    assert!(entry[0] > 50 && entry[0] < all[0], "{text}");
    assert_eq!((entry[1], entry[2], entry[4]), (0, 0, 8), "{text}");
}

/// The entry point in vectors is the only one, or is named; another name is refused with those that there are.
fn in_vectors(package: &Path) {
    let wanted = |entry: Option<&str>| Vectors {
        package: Default::default(),
        entry: entry.map(str::to_owned),
        output: "src/eight.in".into(),
    };
    let said =
        vectors::run(package, &wanted(None), false).unwrap_or_else(|error| panic!("{error}"));
    assert!(said.starts_with("src/eight.in: Motor::step for eight runs at once"), "{said}");
    let text = fs::read_to_string(package.join("src/eight.in")).expect("it is written");
    assert!(text.contains("pub fn motor_step(m: Mask, this: &mut Motor, "), "{text}");
    let error =
        vectors::run(package, &wanted(Some("Motor::stop")), false).expect_err("there is none");
    assert_eq!(error.to_string(), "there is no entry point `Motor::stop`");
    fs::remove_file(package.join("src/eight.in")).expect("it is there");
}

/// Python with a package that a test needs, if the test takes part in this run.
fn python_with(package: &str) -> Option<Command> {
    let python = bessemer_tests::root().join("target/python/bin/python");
    let import = || Command::new(&python).args(["-c", &format!("import {package}")]).output();
    if toolchain::asked_for(|| import().is_ok_and(|it| it.status.success())) {
        return Some(Command::new(python));
    }
    println!("left out: {} has no {package}", python.display());
    None
}

/// Returns the voltages and integrals of the motor's controller in its first periods, computed by the same operations
/// in Rust, as words.
fn first_periods() -> String {
    let (mut integral, mut words) = (0.0_f64, String::new());
    for n in 0..100 {
        let error = 100.0 - f64::from(n) * 1.5;
        let wanted = 0.05 * error + 2.0 * integral;
        let voltage = wanted.clamp(-12.0, 12.0);
        if voltage == wanted {
            integral += error * 0.001;
        }
        words += &format!("{:016x} {:016x}\n", voltage.to_bits(), integral.to_bits());
    }
    words
}

/// Returns the output of a Python script.
fn printed(python: &mut Command, script: &str) -> String {
    let output = python.args(["-c", script]).output().expect("python starts");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8_lossy(&output.stdout).into_owned()
}

/// As a module of Python, whose arrays are NumPy's.
fn called_from_python(package: &Path) {
    let Some(mut python) = python_with("numpy") else { return };
    let wanted = Python { package: Default::default(), output: package.join("python") };
    let said = python::run(package, &wanted, false).unwrap_or_else(|error| panic!("{error}"));
    assert!(said.contains("import motor"), "{said}");
    assert_eq!(printed(python.env("PYTHONPATH", &wanted.output), CALLS), first_periods());
    fs::remove_dir_all(&wanted.output).expect("the module");
}

const CALLS: &str = "
import motor, numpy
bits = lambda x: format(numpy.float64(x).view(numpy.uint64), '016x')
controller, gains = motor.motor_t(), motor.gains_t()
for n in range(100):
    voltage = controller.step(gains, 100.0, n * 1.5)
    print(bits(voltage), bits(controller.integral))
";

/// As a co-simulation unit, which FMPy validates and steps; its state goes out and back in the middle.
fn simulated_as_a_unit(package: &Path) {
    let wanted = |entry: Option<&str>, period: Option<f64>| Fmu {
        package: Default::default(),
        entry: entry.map(str::to_owned),
        period,
        output: package.join("fmu"),
    };
    let refused = fmu::run(package, &wanted(None, Some(0.0)), false).expect_err("no period");
    assert_eq!(refused.to_string(), "the period must be greater than 0 s");
    let refused = fmu::run(package, &wanted(None, None), false).expect_err("no period");
    assert_eq!(refused.to_string(), "the time between two calls of `motor_step` is not set");
    let refused = fmu::run(package, &wanted(Some("Pump::step"), Some(0.001)), false);
    assert_eq!(refused.expect_err("no pump").to_string(), "there is no entry point `Pump::step`");
    let Some(mut python) = python_with("fmpy") else { return };
    let wanted = wanted(None, Some(0.001));
    let said = fmu::run(package, &wanted, false).unwrap_or_else(|error| panic!("{error}"));
    assert!(said.contains("motor_step.fmu: Motor::step with 7 variables"), "{said}");
    python.current_dir(&wanted.output);
    assert_eq!(printed(&mut python, STEPS), first_periods());
    fs::remove_dir_all(&wanted.output).expect("the unit");
}

const STEPS: &str = "
import fmpy, numpy
from fmpy.fmi3 import FMU3Slave
from fmpy.validation import validate_fmu
bits = lambda x: format(numpy.float64(x).view(numpy.uint64), '016x')
problems = validate_fmu('motor_step.fmu')
assert not problems, problems
result = fmpy.simulate_fmu('motor_step.fmu', stop_time=0.01, start_values={'target': 100.0}, output=['result'])
assert result['result'][1] == 5.0, result
about = fmpy.read_model_description('motor_step.fmu')
place = {it.name: it.valueReference for it in about.modelVariables}
start = {it.name: (it.start, it.unit, it.min, it.max) for it in about.modelVariables}
assert start['gains.integral'] == ('2.0', 'V/rad', '0.0', '20.0'), start
folder = fmpy.extract('motor_step.fmu')
unit = FMU3Slave(guid=about.guid, unzipDirectory=folder, modelIdentifier='motor_step', instanceName='one')
unit.instantiate()
unit.enterInitializationMode()
unit.exitInitializationMode()
for n in range(100):
    unit.setFloat64([place['target'], place['speed']], [100.0, n * 1.5])
    unit.doStep(n * 0.001, 0.001)
    if n == 50:
        state = unit.getFMUState()
        kept = unit.serializeFMUState(state)
        unit.doStep(0.051, 0.001)
        unit.freeFMUState(state)
        state = unit.deserializeFMUState(kept)
        unit.setFMUState(state)
        unit.freeFMUState(state)
    print(*map(bits, unit.getFloat64([place['result'], place['self.integral']])))
unit.terminate()
unit.freeInstance()
";

/// Checks errors and their messages; afterwards everything is unchanged.
fn refusals(package: &Path) {
    let settings = package.join("bessemer.toml");
    let sound = fs::read_to_string(&settings).expect("the settings");
    let header = || fs::read_to_string(package.join("generated/motor.h")).expect("the C");
    let before = header();
    let cases = [
        ("[limits]\nstack_bytes = 8\n", "`motor_step` has ", "--> motor/bessemer.toml:2:15"),
        (
            "[limits]\nstate_bytes = 7\n",
            "`motor_step` has 8 bytes of state, more than 7",
            "or raise the limit",
        ),
        ("output = \"/proc/generated\"\n", "`/proc", "error: "),
    ];
    for (text, said, also) in cases {
        let text = if text.starts_with("output") {
            text.to_owned()
        } else {
            format!("output = \"generated\"\n{text}")
        };
        fs::write(&settings, &text).expect("the settings");
        let told = generated(package, false).expect_err(&text);
        let also = also.replace(":2:15", ":3:15");
        assert!(told.contains(said) && told.contains(&also), "{text}{told}");
        assert_eq!(header(), before);
    }
    fs::write(&settings, &sound).expect("the settings");

    // Names that are its own, in a folder of its own.
    fs::write(
        &settings,
        "output = \"generated\"\nprefix = \"acme_\"\nlicense = \"LicenseRef-Acme\"\n",
    )
    .expect("the settings");
    generated(package, false).expect("it is sound");
    let prefixed = fs::read_to_string(package.join("generated/acme_motor.h")).expect("the C");
    for wanted in [
        "#ifndef ACME_MOTOR_H",
        "acme_motor_step(acme_motor_t *ACME_RESTRICT self",
        "LicenseRef-Acme",
    ] {
        assert!(prefixed.contains(wanted), "{prefixed}");
    }
    assert!(!package.join("generated/motor.h").exists());

    // Nothing that is marked.
    fs::write(package.join("src/lib.rs"), "//! Nothing.\n#![no_std]\n").expect("the source");
    let told = generated(package, false).expect_err("nothing is marked");
    assert!(told.contains("nothing in the package `motor` is marked for C"), "{told}");
    assert!(told.contains("#[component]"), "{told}");
    assert!(package.join("generated/acme_motor.h").is_file());
}
