//! Packs of `cargo bessemer pack` for each system: complete, described, and compiled against the smallest stand-ins
//! for the system's own headers (`tests/stubs/`). Messages and ports become headers here as the systems' tools make them.

mod bridged;

use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use bessemer_tests::toolchain::{self, run};
use cargo_bessemer::args::{Pack, System};
use cargo_bessemer::pack;

/// A component for `firmware`'s models. It has structs, enums, arrays and matrices as parameters and results, two entry points
/// with one state, names that meet in a message, and a value that is there in some states only.
pub const WATCH: &str = "
/// Everything that a message may have to hold.
pub mod watch {
    use super::table::Gains;
    use bessemer::prelude::*;

    /// Ways to run.
    #[data]
    #[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
    pub enum Mode {
        #[default]
        Idle,
        Run,
        Hold,
    }

    /// An axis.
    #[data]
    #[derive(Clone, Copy, Debug, Default, PartialEq)]
    pub struct Axis {
        /// Slope.
        pub slope: f32,
        /// Its mode.
        pub mode: Mode,
    }

    /// All that sensors say.
    #[data]
    #[derive(Clone, Copy, Debug, Default, PartialEq)]
    pub struct Measurement {
        /// Speed.
        #[unit(\"rad/s\")]
        pub speed: f64,
        /// Mode that the pilot chose.
        pub mode: Mode,
        /// The axes.
        pub axes: [Axis; 2],
        /// Attitude.
        pub attitude: Matrix2<f32>,
        /// Flags of sensors that are well.
        pub well: [bool; 3],
        /// The last fix, if there was one.
        pub fix: Option<f64>,
    }

    /// All that actuators do. Its name contains a type of C.
    #[data]
    #[derive(Clone, Copy, Debug, Default, PartialEq)]
    pub struct Setpoint {
        /// Torques.
        pub torque: [f64; 2],
        /// Mode that holds.
        pub mode: Mode,
    }

    /// Counts its calls.
    #[component]
    #[derive(Clone, Debug, Default)]
    pub struct Watch {
        /// Number of calls.
        pub calls: u32,
    }

    #[component]
    impl Watch {
        /// One period.
        #[entry]
        pub fn step(
            &mut self,
            gains: &Gains,
            measurement: &Measurement,
            measurement_speed: f64,
            timestamp: u32,
            input: i8,
        ) -> Setpoint {
            self.calls += 1 + timestamp;
            let fix = measurement.fix.unwrap_or(0.5);
            let slope = f64::from(measurement.axes[1].slope);
            let first = gains.error * (measurement.speed - measurement_speed) + fix;
            let second = slope + f64::from(measurement.attitude[(1, 0)]) + f64::from(input);
            let mode = if measurement.well[2] { measurement.mode } else { Mode::Hold };
            Setpoint { torque: [first, second], mode }
        }

        /// The mode before the last.
        #[entry(infallible)]
        pub fn stop(&mut self, mode: Mode) -> Mode {
            self.calls = 0;
            if mode == Mode::Run { Mode::Hold } else { Mode::Idle }
        }
    }
}
";

/// The systems, with the name of each in the command.
const SYSTEMS: &[(System, &str)] = &[
    (System::Zephyr, "zephyr"),
    (System::Px4, "px4"),
    (System::ArduPilot, "ardupilot"),
    (System::FPrime, "fprime"),
    (System::Cfs, "cfs"),
    (System::Ros2, "ros2"),
    (System::MicroRos, "micro-ros"),
    (System::FreeRtos, "freertos"),
    (System::Arduino, "arduino"),
    (System::PlatformIo, "platformio"),
    (System::EspIdf, "esp-idf"),
    (System::CmsisPack, "cmsis-pack"),
];

/// Packs the models of `workspace`, prefix `new_` and headers in a folder `new`, for each system. `settings` is its
/// `bessemer.toml`.
pub fn of(workspace: &Path, settings: &Path) {
    for (system, name) in SYSTEMS {
        let output = workspace.join(name);
        let wanted = Pack { package: Default::default(), system: *system, output };
        let said = pack::run(workspace, &wanted, false).unwrap_or_else(|error| panic!("{error}"));
        let folder = wanted.output.join("models");
        let readme = fs::read_to_string(folder.join("README.md")).expect("a page");
        for text in [&said, &readme] {
            assert!(text.contains("`measurement.fix` of `Watch::step`"), "{name}: {text}");
            assert!(text.contains("1. "), "{name}: no next step: {text}");
        }
        assert!(said.contains("left out: ") && said.contains("\nNext:\n"), "{said}");
        compiles(*system, &Built { folder, name });
    }
    bridged::bridged(workspace, settings);
}

/// A pack, and the stand-ins of its system.
struct Built<'a> {
    folder: PathBuf,
    name: &'a str,
}

impl Built<'_> {
    /// Runs a compiler of C or C++ that takes no warnings.
    fn compile(&self, compiler: &str, words: &[&str]) {
        if !toolchain::is_asked_for(compiler) {
            println!("left out: {compiler} is not installed");
            return;
        }
        let stubs = bessemer_tests::root().join("tests/stubs").join(self.name);
        let mut command = Command::new(compiler);
        command.args(["-Wall", "-Wextra", "-Werror", "-ffp-contract=off", "-I"]);
        command.arg(stubs.canonicalize().unwrap_or(stubs)).args(words).current_dir(&self.folder);
        run(&mut command).unwrap_or_else(|said| panic!("{}: {said}", self.name));
    }

    fn syntax(&self, compiler: &str, standard: &str, words: &[&str]) {
        self.compile(compiler, &[&[standard, "-fsyntax-only"], words].concat());
    }

    fn read(&self, path: &str) -> String {
        let path = self.folder.join(path);
        fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
    }

    fn write(&self, path: &str, text: &str) {
        let path = self.folder.join(path);
        fs::create_dir_all(path.parent().expect("a folder")).expect("a folder");
        fs::write(path, text).expect("a file");
    }

    /// The sources of C in a folder.
    fn sources(&self, folder: &str) -> Vec<String> {
        let files = fs::read_dir(self.folder.join(folder)).expect("the C").flatten();
        let names = files.map(|it| it.file_name().to_string_lossy().into_owned());
        let is_source = |it: &String| it.ends_with(".c") && !it.ends_with("_example_main.c");
        names.filter(is_source).map(|it| format!("{folder}/{it}")).collect()
    }
}

/// The entry points whose messages are there, by name and class.
const ENTRIES: &[(&str, &str)] = &[
    ("new_motor_step", "NewMotorStep"),
    ("new_watch_step", "NewWatchStep"),
    ("new_watch_stop", "NewWatchStop"),
];

fn compiles(system: System, built: &Built<'_>) {
    match system {
        System::Zephyr => {
            let sources = built.sources("src");
            let sources: Vec<&str> = sources.iter().map(String::as_str).collect();
            built.syntax("gcc", "-std=gnu11", &[&["-Isrc"], &sources[..]].concat());
            examples(built, "src/main.c");
        }
        System::FreeRtos | System::PlatformIo | System::CmsisPack => examples(built, "main.c"),
        System::EspIdf => examples(built, "main/main.c"),
        System::Arduino => sketches(built),
        System::Px4 => px4(built),
        System::ArduPilot => ardupilot(built),
        System::FPrime => fprime(built),
        System::Cfs => cfs(built),
        System::Ros2 => ros2(built),
        System::MicroRos => micro_ros(built),
    }
    if system == System::PlatformIo {
        let manifest: serde_json::Value =
            serde_json::from_str(&built.read("library.json")).expect("it is JSON");
        let examples = manifest["examples"].as_array().expect("a list");
        assert_eq!(examples.len(), ENTRIES.len(), "{manifest}");
    }
    if system == System::CmsisPack {
        let text = built.read("Bessemer.models.pdsc");
        let files = text.split("<file ").skip(1).filter_map(|it| it.split("name=\"").nth(1));
        for file in files.filter_map(|it| it.split('"').next()) {
            assert!(built.folder.join(file).exists(), "{file}");
        }
    }
}

fn examples(built: &Built<'_>, path: &str) {
    for (entry, _) in ENTRIES {
        built.syntax("gcc", "-std=gnu11", &["-Isrc", &format!("examples/{entry}/{path}")]);
    }
}

fn sketches(built: &Built<'_>) {
    for (entry, _) in ENTRIES {
        let sketch = format!("examples/{entry}/{entry}.ino");
        built.syntax(
            "g++",
            "-std=c++17",
            &["-Isrc", "-include", "Arduino.h", "-x", "c++", &sketch],
        );
    }
}

/// The fields of a message: type, number of elements, name.
fn fields(text: &str) -> Vec<(String, Option<String>, String)> {
    let lines = text.lines().filter_map(|line| line.split('#').next()?.trim().split_once(' '));
    let field = |(ty, name): (&str, &str)| match ty.split_once('[') {
        Some((ty, count)) => {
            (ty.to_owned(), Some(count.trim_end_matches(']').to_owned()), name.to_owned())
        }
        None => (ty.to_owned(), None, name.to_owned()),
    };
    lines.map(field).collect()
}

/// The fields of a message as C declares them.
fn declared(text: &str) -> String {
    let mut declared = String::new();
    for (ty, count, name) in fields(text) {
        let ty = match ty.as_str() {
            "float32" => "float".to_owned(),
            "float64" => "double".to_owned(),
            "bool" => ty,
            integer => format!("{integer}_t"),
        };
        let count = count.map(|it| format!("[{it}]")).unwrap_or_default();
        let _ = write!(declared, "{ty} {name}{count}; ");
    }
    declared
}

/// Makes headers of the messages of a module, as the build of PX4 does.
fn uorb(built: &Built<'_>) {
    for (entry, class) in ENTRIES {
        for (end, topic) in [("Input", "input"), ("Output", "output")] {
            let path = format!("msg/{class}{end}.msg");
            if !built.folder.join(&path).exists() {
                continue;
            }
            let fields = declared(&built.read(&path));
            let header = format!(
                "#pragma once\n#include <stdint.h>\nstruct {entry}_{topic}_s {{ {fields} }};\n"
            );
            built.write(&format!("stub/uORB/topics/{entry}_{topic}.h"), &header);
        }
    }
}

fn px4(built: &Built<'_>) {
    let message = built.read("msg/NewWatchStepInput.msg");
    for line in [
        "float64 measurement_speed # [rad/s]",
        "int32 measurement_axes_1_mode",
        "float32[4] measurement_attitude",
        "bool[3] measurement_well",
        "float64 measurement_speed_2",
        "uint32 timestamp_2",
        "int8 input_2",
    ] {
        assert!(message.lines().any(|it| it == line), "{line}: {message}");
    }
    uorb(built);
    for module in ["NewMotorModule.cpp", "NewWatchModule.cpp"] {
        built.syntax("g++", "-std=c++14", &["-Isrc", "-Istub", module]);
    }
}

/// Calls the library as ArduPilot does: structs are flattened and put back, and a number that is no enumerator is refused.
const ARDUPILOT: &str = r#"#include "AP_NewWatch.h"
#include <stdio.h>
int main()
{
    AP_NewWatch watch;
    AP_NewWatch::NewWatchStepInput input{};
    AP_NewWatch::NewWatchStepOutput output{};
    input.measurement_speed = 3.0;
    input.measurement_speed_2 = 1.0;
    input.measurement_axes_1_slope = 0.25F;
    input.measurement_attitude[1] = 0.5F;
    input.measurement_well[2] = true;
    input.measurement_mode = 1;
    input.input_2 = -3;
    const bool good = watch.new_watch_step(input, output);
    (void)printf("%d %g %g %d %d ", good, output.setpoint_torque[0], output.setpoint_torque[1], output.setpoint_mode, output.status);
    input.measurement_axes_0_mode = 3;
    AP_NewWatch::NewWatchStopInput stop{1};
    AP_NewWatch::NewWatchStopOutput stopped{};
    const bool refused = !watch.new_watch_step(input, output);
    (void)watch.new_watch_stop(stop, stopped);
    (void)printf("%d %d\n", refused, stopped.result);
    return 0;
}
"#;

fn ardupilot(built: &Built<'_>) {
    built.write("main.cpp", ARDUPILOT);
    let sources = built.sources(".");
    let mut objects = Vec::new();
    for source in &sources {
        let object = format!("{source}.o");
        built.compile("gcc", &["-std=gnu11", "-c", "-I.", source, "-o", &object]);
        objects.push(object);
    }
    let mut words = vec!["-std=gnu++17", "-I.", "main.cpp", "AP_NewWatch.cpp", "AP_NewMotor.cpp"];
    words.extend(objects.iter().map(String::as_str));
    built.compile("g++", &[&words[..], &["-lm", "-o", "program"]].concat());
    let program = built.folder.join("program");
    if program.is_file() {
        let output = Command::new(program).output().expect("it runs");
        let text = String::from_utf8_lossy(&output.stdout).into_owned();
        // Gains are 2: 2 · (3 − 1) + 0 for an `Option` of zeros, which is none: 0.5. And 0.25 + 0.5 − 3.
        assert_eq!(text, "1 4.5 -2.25 1 0 1 2\n");
    }
}

fn fprime(built: &Built<'_>) {
    for component in ["NewMotor", "NewWatch"] {
        let model = built.read(&format!("{component}.fpp"));
        built.write(&format!("stub/{component}ComponentAc.hpp"), &autocoded(component, &model));
        let source = format!("{component}.cpp");
        built.syntax("g++", "-std=c++14", &["-Isrc", "-Istub", &source]);
    }
    let check = bessemer_tests::root().join("target/python/bin/fpp-check");
    if toolchain::asked_for(|| check.is_file()) {
        for component in ["NewMotor", "NewWatch"] {
            let model = built.folder.join(format!("{component}.fpp"));
            run(Command::new(&check).arg(model)).unwrap_or_else(|said| panic!("{said}"));
        }
    } else {
        println!("left out: {} is not installed", check.display());
    }
}

/// The base class that F´ makes of a model, as far as a component needs it.
fn autocoded(component: &str, model: &str) -> String {
    let (mut types, mut members) = (String::new(), String::new());
    let mut ports = Vec::<(String, String)>::new();
    for line in model.lines().map(|it| it.split('@').next().unwrap_or_default().trim()) {
        let words: Vec<&str> = line.split_whitespace().collect();
        match words.as_slice() {
            ["array", name, "=", count, ty] => {
                let count = count.trim_matches(['[', ']']);
                let _ = writeln!(types, "using {name} = StubArray<{ty}, {count}>;");
            }
            ["port", name] => ports.push((name.trim_end_matches('(').to_owned(), String::new())),
            [name, ty] if name.starts_with("in_") || name.starts_with("out_") => {
                let ty = if ty.starts_with("New") { format!("const {ty}&") } else { (*ty).into() };
                let (_, list) = ports.last_mut().expect("a port");
                let _ = write!(list, ", {ty} {}", name.trim_end_matches(':'));
            }
            ["sync", "input", "port", name, port] => {
                let list = &ports.iter().find(|it| it.0 == *port).expect("a port").1;
                let name = name.trim_end_matches(':');
                let _ = writeln!(
                    members,
                    "virtual void {name}_handler(FwIndexType portNum{list}) = 0;"
                );
            }
            ["output", "port", name, port] => {
                let list = &ports.iter().find(|it| it.0 == *port).expect("a port").1;
                let name = name.trim_end_matches(':');
                let _ = writeln!(
                    members,
                    "bool isConnected_{name}_OutputPort(FwIndexType);\nvoid {name}_out(FwIndexType portNum{list});"
                );
            }
            _ => {}
        }
    }
    format!(
        "#pragma once\n#include <Fw/Types.hpp>\nnamespace Models {{\n{types}class {component}ComponentBase {{\npublic:\n\
         explicit {component}ComponentBase(const char *) {{}}\nvirtual ~{component}ComponentBase() {{}}\nprotected:\n{members}}};\n}}\n"
    )
}

fn cfs(built: &Built<'_>) {
    let sources = built.sources("fsw/src");
    let words: Vec<&str> = sources.iter().map(String::as_str).collect();
    built.syntax("gcc", "-std=gnu11", &[&["-Ifsw/src", "-Ifsw/inc"], &words[..]].concat());
}

fn ros2(built: &Built<'_>) {
    for (entry, class) in ENTRIES {
        for (end, topic) in [("Input", "input"), ("Output", "output")] {
            let mut members = String::new();
            for (ty, count, name) in fields(&built.read(&format!("msgs/msg/{class}{end}.msg"))) {
                let ty = match ty.as_str() {
                    "float32" => "float".to_owned(),
                    "float64" => "double".to_owned(),
                    "bool" => ty,
                    integer => format!("{integer}_t"),
                };
                let ty = count.map_or(ty.clone(), |count| format!("std::array<{ty}, {count}>"));
                let _ = write!(members, "{ty} {name}{{}}; ");
            }
            let header = format!(
                "#pragma once\n#include <array>\n#include <cstdint>\nnamespace models_msgs {{ namespace msg {{ struct {class}{end} {{ {members} }}; }} }}\n"
            );
            built.write(&format!("stub/models_msgs/msg/{entry}_{topic}.hpp"), &header);
        }
    }
    for node in ["node/new_motor_node.cpp", "node/new_watch_node.cpp"] {
        built.syntax("g++", "-std=c++17", &["-Inode/src", "-Istub", node]);
    }
}

fn micro_ros(built: &Built<'_>) {
    for (entry, class) in ENTRIES {
        for (end, topic) in [("Input", "input"), ("Output", "output")] {
            let fields = declared(&built.read(&format!("msgs/msg/{class}{end}.msg")));
            let header = format!(
                "#include <stdbool.h>\n#include <stdint.h>\ntypedef struct {{ {fields} }} models_msgs__msg__{class}{end};\n"
            );
            built.write(&format!("stub/models_msgs/msg/{entry}_{topic}.h"), &header);
        }
    }
    let words = ["-Inode", "-Inode/src", "-Istub", "node/app.c", "node/new_motor_node.c"];
    built.syntax("gcc", "-std=gnu11", &[&words[..], &["node/new_watch_node.c"]].concat());
}
