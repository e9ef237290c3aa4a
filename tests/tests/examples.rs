//! The programs of `examples/` that need no firmware of their own. They are built as their pages describe, and compared
//! with the models as rustc compiles them, line by line, to the bit. The bare Zynq is in `flight::zynq`.

use std::path::{Path, PathBuf};
use std::process::Command;

use bessemer::nalgebra::{SVector, Vector3};
use bessemer_tests::process::lay_out_needed;
use bessemer_tests::toolchain::{self, Toolchain, run};
use bessemer_tests::workspace::Workspace;
use bessemer_tests::{flight_models, root, turn};
use cargo_bessemer::args::{self, Verify};
use cargo_bessemer::{sizes, verify};
use models::plant::Plant;
use models::{Airframe, Controller, Estimate, Inputs, Onboard, Parameters, Settings, Target};

/// The objects of the emitted C that a program needs, in a folder.
fn objects(main: &Path, toolchain: &Toolchain) -> (bessemer_tests::process::Folder, Vec<PathBuf>) {
    let text = std::fs::read_to_string(main).expect("the program");
    let folder = lay_out_needed(&flight_models().files, &text).expect("the C");
    let objects = toolchain.objects(folder.sources(), &[]);
    let (objects, _) = objects.unwrap_or_else(|said| panic!("{said}"));
    (folder, objects)
}

fn printed(command: &mut Command) -> String {
    let output = command.output().expect("the program");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8_lossy(&output.stdout).into_owned()
}

/// Returns the output of `examples/cpp`, computed by the Rust.
fn held_height() -> String {
    let (parameters, airframe) = (Parameters::mambo(), Airframe::mambo());
    let (mut controller, mut plant) = (Controller::default(), Plant::default());
    let mut target = Target::default();
    target.position.z = 1.0;
    let (mut estimate, mut text) = (Estimate::default(), String::new());
    for n in 1..=(10.0 / parameters.period) as u32 {
        let command = controller.step(&parameters, &estimate, &target, &SVector::zeros());
        let motion = plant.step(&airframe, &command.speeds, parameters.period);
        estimate = Estimate {
            position: motion.position,
            angles: motion.angles,
            velocity: motion.velocity,
            rates: motion.rates,
        };
        if n % 200 == 0 {
            let height = motion.position.z;
            text += &format!("{:016x} {height:8.4} m\n", height.to_bits());
        }
    }
    text
}

#[test]
fn a_program_in_cpp_holds_its_height_to_the_bit() {
    let main = root().join("examples/cpp/main.cpp");
    let expected = held_height();
    assert_eq!(expected.lines().count(), 10);
    for compiler in toolchain::host().iter().filter(|it| it.level == 2) {
        let (folder, objects) = objects(&main, compiler);
        let program = folder.path().join("drone");
        let cpp = compiler.compiler.replace("gcc", "g++").replace("clang", "clang++");
        let mut command = Command::new(&cpp);
        command.args(["-std=c++17", "-O2", "-Wall", "-Wextra", "-Wpedantic", "-Wconversion"]);
        command.arg("-Werror").arg("-I").arg(folder.path()).arg(&main).args(&objects);
        run(command.arg("-o").arg(&program).arg("-lm")).unwrap_or_else(|said| panic!("{said}"));
        assert_eq!(printed(&mut Command::new(&program)), expected, "{cpp}");
    }
}

/// Returns the output of `examples/linux-a9` after a number of periods, computed by the Rust.
fn at_rest(periods: u64) -> String {
    let (mut onboard, mut settings) = (Onboard::default(), Settings::mambo());
    let (mut position, mut angles) = (String::new(), String::new());
    for n in 0..periods {
        let mut inputs = Inputs { time: 1_000_000 + n * 5000, ..Inputs::default() };
        inputs.readings.inertial.fresh = true;
        inputs.readings.inertial.gyroscope[0] = (n % 7) as i16 - 3;
        inputs.readings.inertial.accelerometer[0] = (n % 5) as i16 - 2;
        inputs.readings.inertial.accelerometer[2] = 4096;
        inputs.readings.vicon.fresh = n % 2 == 0;
        inputs.readings.echo.fresh = n % 10 == 0;
        inputs.readings.echo.delay = 100;
        let outputs = onboard.step(&settings, &inputs);
        settings.grant(&outputs.wish, outputs.reference.motors);
        let bits = |it: &Vector3<f64>| {
            it.iter().map(|number| format!(" {:016x}", number.to_bits())).collect::<String>()
        };
        position = bits(&outputs.estimate.position);
        angles = bits(&outputs.estimate.angles);
    }
    format!("position{position}\nangles{angles}\n")
}

#[test]
fn a_process_on_a_cortex_a9_keeps_its_periods_and_its_bits() {
    let main = root().join("examples/linux-a9/main.c");
    for compiler in toolchain::target().iter().filter(|it| it.level == 2) {
        let (folder, _) = objects(&main, compiler);
        // Where its object may lie, too.
        let (copy, program) = (folder.path().join("main.c"), folder.path().join("onboard"));
        std::fs::copy(&main, &copy).expect("a copy");
        let made = compiler.around(&copy, folder.sources(), &program, &[]);
        made.unwrap_or_else(|said| panic!("{said}"));
        let begun = std::time::Instant::now();
        assert_eq!(printed(compiler.runner(&program).arg("200")), at_rest(200));
        assert!(begun.elapsed().as_secs_f64() >= 199.0 * 0.005, "periods are too short");
    }
}

/// Copies the files of a folder, and of those in it.
pub(super) fn copy(from: &Path, to: &Path) {
    std::fs::create_dir_all(to).expect("a folder");
    for entry in std::fs::read_dir(from).expect("the folder").flatten() {
        let (path, target) = (entry.path(), to.join(entry.file_name()));
        match path.is_dir() {
            true => copy(&path, &target),
            false => _ = std::fs::copy(&path, &target).expect("a copy"),
        }
    }
}

/// `examples/motor-m4f` in a temporary workspace: its loop, its bits on each leg, and its instructions within its own limit.
#[test]
fn a_drive_in_single_precision_keeps_its_bits_and_its_limits() {
    let workspace = Workspace::for_package("motor").expect("a workspace");
    let (example, package) = (root().join("examples/motor-m4f"), workspace.path("motor"));
    for folder in ["src", "tests"] {
        copy(&example.join(folder), &package.join(folder));
    }
    std::fs::copy(example.join("bessemer.toml"), package.join("bessemer.toml")).expect("a copy");
    // The profile and the lock file are the workspace's.
    let manifest = std::fs::read_to_string(example.join("Cargo.toml")).expect("the manifest");
    let (manifest, _) = manifest.split_once("# Overflow").expect("a profile of its own");
    let manifest = manifest.replace("../../dsl", "../dsl");
    std::fs::write(package.join("Cargo.toml"), manifest).expect("the manifest");

    workspace.run_test(&package, "closed_loop").unwrap_or_else(|said| panic!("{said}"));

    // The DSL is built once more for it, with its builders and in single precision: every other turn.
    if turn::one_of(vec![true, false]) == [false] {
        println!("left out: the drive's C in single precision, which is another turn's");
        return;
    }
    let bare = toolchain::is_asked_for("qemu-system-arm");
    let target = if bare { vec![args::Target::CortexM4f] } else { Vec::new() };
    let inputs = Some(package.join("tests/recorded.csv"));
    let wanted = Verify { inputs, target, ..Verify::default() };
    let (text, agree) =
        verify::run(&package, &wanted, false).unwrap_or_else(|error| panic!("{error}"));
    assert!(agree && text.contains("200 calls"), "{text}");
    assert_eq!(bare, text.contains("\non cortex-m4f: "), "{text}");
    // No call takes more than the longest path, and that is at most 1.6 times what was executed.
    let target = if bare { vec![args::Target::CortexM4f] } else { Vec::new() };
    let sizes = sizes::run(&package, &args::Sizes { target, ..args::Sizes::default() }, false);
    let sizes = sizes.unwrap_or_else(|error| panic!("{error}"));
    let last = |text: &str, name: &str, from_end: usize| -> Option<u64> {
        let row = text.lines().rfind(|line| line.trim_start().starts_with(name))?;
        row.split_whitespace().rev().nth(from_end)?.parse().ok()
    };
    let estimated = last(&sizes, "drive_step", 0).unwrap_or_else(|| panic!("{sizes}"));
    if bare {
        let executed = last(&text, "Drive::step", 2).unwrap_or_else(|| panic!("{text}"));
        let longest = last(&text, "Drive::step", 0).unwrap_or_else(|| panic!("{text}"));
        assert!(estimated < longest && executed <= longest, "{executed}, {estimated}, {longest}");
        assert!(10 * longest <= 16 * executed, "{executed}, {longest}");
    }
}
