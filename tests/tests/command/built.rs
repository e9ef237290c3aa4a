//! The C in builds of others: by CMake and make, installed, and as a part of Zephyr, FreeRTOS and Arduino.
//!
//! CMake and make are the real ones. The systems are stand-ins for their headers (`tests/stubs/`): what is made for these is
//! compiled, and run where this machine can.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use bessemer_tests::toolchain::{self, Toolchain};
use bessemer_tests::turn;
use cargo_bessemer::args::{Pack, System};
use cargo_bessemer::pack;

use super::{STUB, generated};

/// Each compiler of this run, once: those of this machine, and ARM's with an operating system and without.
fn compilers() -> Vec<Toolchain> {
    let mut list: Vec<_> = toolchain::all().into_iter().filter(|it| it.level == 2).collect();
    let bare = toolchain::BARE_A9;
    list.extend(toolchain::is_asked_for(bare.compiler).then_some(bare));
    list
}

fn run(command: &mut Command) {
    toolchain::run(command).unwrap_or_else(|said| panic!("{said}"));
}

/// The stub of the firmware prints what it does in Rust, where this machine can run it.
fn prints_the_same(compiler: &Toolchain, program: &Path) {
    if !compiler.bare {
        let output = compiler.runner(program).output().expect("it runs");
        assert_eq!(String::from_utf8_lossy(&output.stdout), STUB, "{}", compiler.name());
    }
}

/// The files for CMake and make build the stub, with the table of parameters, and the example.
pub fn by_cmake_and_make(package: &Path) {
    let settings = package.join("bessemer.toml");
    let sound = fs::read_to_string(&settings).expect("the settings");
    fs::write(
        &settings,
        format!("build_files = true\ninterface = true\nparameters = true\n{sound}"),
    )
    .expect("the settings");
    generated(package, false).expect("it is sound");
    let face = fs::read_to_string(package.join("generated/interface.json")).expect("the interface");
    assert!(face.contains("\"set_by\": \"gains_defaults\""), "{face}");
    let table = fs::read_to_string(package.join("generated/bessemer_parameter_table.c"));
    let row = "{\"integral\", \"V/rad\", 0.0, 20.0, offsetof(gains_t, integral), sizeof(double), 1U, BESSEMER_PARAMETER_DOUBLE}";
    assert!(table.as_ref().is_ok_and(|it| it.contains(row)), "{table:?}");

    let folder = package.join("others");
    fs::create_dir_all(&folder).expect("a folder");
    if toolchain::is_asked_for("make") {
        compilers().iter().for_each(|it| made(&folder, it));
        // The compilers of the other targets of `verify`, as far as they are installed; the one of s390x needs a flag.
        let targets = [
            toolchain::CORTEX_M4F,
            toolchain::CORTEX_M7,
            toolchain::AARCH64,
            toolchain::RISCV32,
            toolchain::RISCV64,
            toolchain::S390X,
        ];
        targets.iter().filter(|it| it.is_there()).for_each(|it| made(&folder, it));
    } else {
        println!("left out: make is not installed");
    }
    if toolchain::is_asked_for("cmake") {
        turn::some_of(compilers(), 2).iter().for_each(|it| part_of_cmake(&folder, it));
        turn::one_of(compilers()).iter().for_each(|it| installed_by_cmake(package, it));
    } else {
        println!("left out: cmake is not installed");
    }
    fs::remove_dir_all(&folder).expect("the folder");
    fs::write(&settings, sound).expect("the settings");
    generated(package, false).expect("it is sound");
    assert!(!package.join("generated/CMakeLists.txt").exists());
}

fn made(folder: &Path, compiler: &Toolchain) {
    let make = "include ../generated/motor.mk\nstub: ../firmware/main.c $(MOTOR_SOURCES)\n\
        \t$(CC) $(CFLAGS) $(MOTOR_CFLAGS) -o $@ $^ -lm\n";
    fs::write(folder.join("Makefile"), make).expect("a file");
    let mut command = Command::new("make");
    command.args(["--silent", "--always-make"]).arg(format!("CC={}", compiler.compiler));
    let machine = compiler.machine.iter().filter(|it| !it.starts_with("-fexcess"));
    let machine = machine.copied().collect::<Vec<_>>().join(" ");
    command.arg(format!("CFLAGS=-O2 {machine}"));
    run(command.current_dir(folder));
    prints_the_same(compiler, &folder.join("stub"));
}

/// Makes what a project of CMake has, in `project/build`.
fn cmake(project: &Path, compiler: &Toolchain, settings: &[String], targets: &[&str]) -> PathBuf {
    let build = project.join("build");
    let mut configure = Command::new("cmake");
    configure.arg("-S").arg(project).arg("-B").arg(&build).args(settings);
    configure.args([
        "-DCMAKE_BUILD_TYPE=Release".to_owned(),
        format!("-DCMAKE_C_COMPILER={}", compiler.compiler),
        format!("-DCMAKE_C_FLAGS={}", compiler.machine.join(" ")),
    ]);
    if compiler.emulator.is_some() {
        let system = if compiler.bare { "Generic" } else { "Linux" };
        configure.arg(format!("-DCMAKE_SYSTEM_NAME={system}")).arg("-DCMAKE_SYSTEM_PROCESSOR=arm");
    }
    run(&mut configure);
    run(Command::new("cmake").arg("--build").arg(&build).arg("--target").args(targets));
    build
}

/// The folder of the C as a part of a firmware's own project.
fn part_of_cmake(folder: &Path, compiler: &Toolchain) {
    let text = "cmake_minimum_required(VERSION 3.16)\nproject(firmware C)\nadd_subdirectory(../generated generated)\n\
        add_executable(stub ../firmware/main.c)\ntarget_link_libraries(stub PRIVATE motor::motor)\n";
    fs::write(folder.join("CMakeLists.txt"), text).expect("a file");
    let build = cmake(folder, compiler, &[], &["stub", "motor_example"]);
    prints_the_same(compiler, &build.join("stub"));
    // What is installed with the firmware is the firmware's to say.
    run(Command::new("cmake").arg("--install").arg(&build).args(["--prefix", "/proc/none"]));
    fs::remove_dir_all(build).expect("the build");
}

/// Builds and installs the C by itself. A project elsewhere then finds it by its installation path only, without
/// sources or build.
fn installed_by_cmake(package: &Path, compiler: &Toolchain) {
    let place = tempfile::tempdir().expect("a folder");
    let (c, firmware) = (place.path().join("c"), place.path().join("firmware"));
    super::super::examples::copy(&package.join("generated"), &c);
    super::super::examples::copy(&package.join("firmware"), &firmware);
    let build = cmake(&c, compiler, &[], &["all"]);
    let (first, last) = (place.path().join("first"), place.path().join("last"));
    run(Command::new("cmake").arg("--install").arg(build).arg("--prefix").arg(&first));
    fs::rename(&first, &last).expect("an installation can be moved");
    fs::remove_dir_all(&c).expect("the C");

    let text = "cmake_minimum_required(VERSION 3.16)\nproject(firmware C)\nfind_package(motor CONFIG REQUIRED)\n\
        add_executable(stub main.c)\ntarget_link_libraries(stub PRIVATE motor::motor)\n";
    fs::write(firmware.join("CMakeLists.txt"), text).expect("a file");
    let found = [format!("-DCMAKE_PREFIX_PATH={}", last.display())];
    let build = cmake(&firmware, compiler, &found, &["stub"]);
    prints_the_same(compiler, &build.join("stub"));
}

/// As a part of Zephyr, FreeRTOS and Arduino, compiled against stand-ins for these.
pub fn packed(package: &Path) {
    zephyr(package);
    freertos(package);
    arduino(package);
}

/// The folder made for a system.
fn made_for(package: &Path, system: System, name: &str) -> PathBuf {
    let output = package.join(name);
    let wanted = Pack { package: Default::default(), system, output };
    pack::run(package, &wanted, false).unwrap_or_else(|error| panic!("{error}"));
    let again = pack::run(package, &wanted, false).expect_err("it is there");
    assert!(again.to_string().ends_with("exists already"), "{again}");
    wanted.output.join("motor")
}

/// A compiler of C, or its like of C++, that takes no warnings and finds the stand-ins for a system.
fn built(compiler: &Toolchain, program: &str, folder: &Path, system: &str, arguments: &[&str]) {
    let stubs = bessemer_tests::root().join("tests/stubs").join(system);
    let mut command = Command::new(program);
    command.args(["-Wall", "-Wextra", "-Werror", "-O2", "-Isrc"]).arg("-I").arg(stubs);
    run(command.args(compiler.machine).args(arguments).current_dir(folder));
}

/// The compiler of C++ beside one of C, if it takes part in this run.
fn cpp(compiler: &Toolchain) -> Option<String> {
    let program = compiler.compiler.replace("gcc", "g++").replace("clang", "clang++");
    if toolchain::is_asked_for(&program) {
        return Some(program);
    }
    println!("left out: {program} is not installed");
    None
}

fn zephyr(package: &Path) {
    let folder = made_for(package, System::Zephyr, "zephyr");
    let example = "examples/motor_step/src/main.c";
    for it in compilers() {
        built(&it, it.compiler, &folder, "zephyr", &["-std=c99", "-fsyntax-only", example]);
    }
    let module = fs::read_to_string(folder.join("zephyr/module.yml")).expect("the module");
    assert!(module.contains("name: motor\nbuild:\n  cmake: .\n"), "{module}");
    fs::remove_dir_all(package.join("zephyr")).expect("the folder");
}

/// The task runs for three periods; the stand-in says whether it did what a task has to.
fn freertos(package: &Path) {
    let folder = made_for(package, System::FreeRtos, "freertos");
    for it in compilers() {
        let words = ["-std=c99", "-ffp-contract=off", "src/motor.c", "examples/motor_step/main.c"];
        let words = [&words[..], &["-lm", "-o", "task"]].concat();
        built(&it, it.compiler, &folder, "freertos", &words);
        if !it.bare {
            run(&mut it.runner(&folder.join("task")));
        }
    }
    let make = fs::read_to_string(folder.join("src/motor.mk")).expect("the fragment for make");
    assert!(make.contains("    motor.c"), "{make}");
    fs::remove_dir_all(package.join("freertos")).expect("the folder");
}

/// One pass of the sketch, as a program, beside the tables of parameters.
fn arduino(package: &Path) {
    let settings = package.join("bessemer.toml");
    let sound = fs::read_to_string(&settings).expect("the settings");
    fs::write(&settings, format!("parameters = true\n{sound}")).expect("the settings");
    let folder = made_for(package, System::Arduino, "arduino");
    fs::write(&settings, sound).expect("the settings");
    let main = bessemer_tests::root().join("tests/stubs/arduino/main.cpp").display().to_string();
    let cpp = ["-include", "Arduino.h", "-x", "c++", "examples/motor_step/motor_step.ino"];
    for (it, program) in compilers().iter().filter_map(|it| Some((it, self::cpp(it)?))) {
        for source in ["src/motor.c", "src/bessemer_parameter_table.c"] {
            let words = ["-std=c99", "-ffp-contract=off", "-c", source];
            built(it, it.compiler, &folder, "arduino", &words);
        }
        if it.bare {
            // Its libraries of C++ are a package of their own, which the sketch does not need.
            built(
                it,
                &program,
                &folder,
                "arduino",
                &[&cpp[..], &["-c", "-o", "sketch.o"]].concat(),
            );
            continue;
        }
        let words = [&[&*main], &cpp[..], &["-x", "none", "motor.o", "-o", "sketch"]].concat();
        built(it, &program, &folder, "arduino", &words);
        run(&mut it.runner(&folder.join("sketch")));
    }
    fs::remove_dir_all(package.join("arduino")).expect("the folder");
}
