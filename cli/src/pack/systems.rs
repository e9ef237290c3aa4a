//! The systems: the files of each, as templates, and the next steps of its user.
//!
//! Invariant: only data. Paths and texts are templates over [`super::context`].

use super::context::Style;
use crate::args::System;

/// A system.
pub struct Form {
    /// The folder of the C, with a `/` at its end.
    pub sources: &'static str,
    /// Notation for the fields of messages.
    pub style: Style,
    /// True if the C gets its files for CMake and make.
    pub build_files: bool,
    /// The files.
    pub templates: &'static [Template],
    /// The next steps; `FOLDER` is the folder of the pack.
    pub next: &'static str,
}

/// A file of a pack.
pub struct Template {
    /// Number of files.
    pub each: Each,
    /// Path of the template.
    pub path: &'static str,
    /// Text of the template.
    pub text: &'static str,
}

/// Number of files of one template.
pub enum Each {
    /// One.
    Package,
    /// One for each component.
    Component,
    /// One for each entry point.
    Entry,
}

/// A template of `cli/templates/packs/`: how many files, their path, the template.
macro_rules! files {
    ($($each:ident $path:literal $template:literal),* $(,)?) => {
        &[$(Template {
            each: Each::$each,
            path: $path,
            text: include_str!(concat!("../../templates/packs/", $template)),
        }),*]
    };
}

macro_rules! next {
    ($system:literal) => {
        include_str!(concat!("../../templates/packs/", $system, "/next.txt"))
    };
}

/// The files of every pack.
pub const COMMON: &[Template] = files![Package "README.md" "README.md.tera"];

/// A C++ member or a field of a message, by its dot.
const DOTS: Style =
    Style { input: "input.", output: "output.", kept: "", taken: &[], bridges: false };

/// A system whose files are examples and a description.
const fn plain(templates: &'static [Template], next: &'static str) -> Form {
    Form { sources: "src/", style: DOTS, build_files: false, templates, next }
}

/// The form of a system.
pub fn form(system: System) -> Form {
    match system {
        System::Zephyr => plain(
            files![
                Package "zephyr/module.yml" "zephyr/module.yml.tera",
                Package "Kconfig" "zephyr/Kconfig.tera",
                Package "CMakeLists.txt" "zephyr/CMakeLists.txt.tera",
                Entry "examples/{{ entry.name }}/src/main.c" "zephyr/main.c.tera",
            ],
            next!("zephyr"),
        ),
        // FreeRTOS has no form for a library of its own: the C gets the files for CMake and make.
        System::FreeRtos => Form {
            build_files: true,
            ..plain(
                files![Entry "examples/{{ entry.name }}/main.c" "freertos/main.c.tera"],
                next!("freertos"),
            )
        },
        System::Arduino => plain(
            files![
                Package "library.properties" "arduino/library.properties.tera",
                Package "src/{{ name }}_all.h" "arduino/all.h.tera",
                Entry "examples/{{ entry.name }}/{{ entry.name }}.ino" "arduino/sketch.ino.tera",
            ],
            next!("arduino"),
        ),
        System::PlatformIo => plain(
            files![
                Package "library.json" "platformio/library.json.tera",
                Entry "examples/{{ entry.name }}/main.c" "platformio/main.c.tera",
            ],
            next!("platformio"),
        ),
        System::EspIdf => plain(
            files![
                Package "idf_component.yml" "esp-idf/idf_component.yml.tera",
                Package "CMakeLists.txt" "esp-idf/CMakeLists.txt.tera",
                Entry "examples/{{ entry.name }}/main/main.c" "esp-idf/main.c.tera",
            ],
            next!("esp-idf"),
        ),
        System::CmsisPack => plain(
            files![
                Package "Bessemer.{{ name }}.pdsc" "cmsis/pack.pdsc.tera",
                Package "LICENSE.txt" "cmsis/LICENSE.txt.tera",
                Entry "examples/{{ entry.name }}/main.c" "platformio/main.c.tera",
            ],
            next!("cmsis"),
        ),
        System::Px4 => Form {
            style: Style { taken: &["timestamp"], bridges: true, ..DOTS },
            ..plain(
                files![
                    Package "Kconfig" "px4/Kconfig.tera",
                    Package "CMakeLists.txt" "px4/CMakeLists.txt.tera",
                    Component "{{ component.class }}Module.cpp" "px4/module.cpp.tera",
                    Entry "msg/{{ entry.class }}Input.msg" "px4/Input.msg.tera",
                    Entry "msg/{{ entry.class }}Output.msg" "px4/Output.msg.tera",
                ],
                next!("px4"),
            )
        },
        // Its build takes the sources of a library from one folder.
        System::ArduPilot => Form {
            sources: "",
            style: Style { kept: "_", ..DOTS },
            ..plain(
                files![
                    Package "wscript" "ardupilot/wscript.tera",
                    Component "AP_{{ component.class }}.h" "ardupilot/library.h.tera",
                    Component "AP_{{ component.class }}.cpp" "ardupilot/library.cpp.tera",
                ],
                next!("ardupilot"),
            )
        },
        System::FPrime => Form {
            style: Style { input: "in_", output: "out_", kept: "_", taken: &[], bridges: false },
            ..plain(
                files![
                    Package "CMakeLists.txt" "fprime/CMakeLists.txt.tera",
                    Component "{{ component.class }}.fpp" "fprime/types.fpp.tera",
                    Component "{{ component.class }}.hpp" "fprime/component.hpp.tera",
                    Component "{{ component.class }}.cpp" "fprime/component.cpp.tera",
                ],
                next!("fprime"),
            )
        },
        System::Cfs => Form {
            sources: "fsw/src/",
            style: Style { input: "input->", taken: &["TelemetryHeader"], ..DOTS },
            ..plain(
                files![
                    Package "CMakeLists.txt" "cfs/CMakeLists.txt.tera",
                    Package "fsw/inc/{{ name }}_msgids.h" "cfs/msgids.h.tera",
                    Package "fsw/inc/{{ name }}_msg.h" "cfs/msg.h.tera",
                    Package "fsw/src/{{ name }}_app.c" "cfs/app.c.tera",
                ],
                next!("cfs"),
            )
        },
        System::Ros2 => Form {
            sources: "node/src/",
            style: Style { kept: "_", ..DOTS },
            ..plain(
                files![
                    Package "msgs/package.xml" "ros2/msgs-package.xml.tera",
                    Package "msgs/CMakeLists.txt" "ros2/msgs-CMakeLists.txt.tera",
                    Entry "msgs/msg/{{ entry.class }}Input.msg" "ros2/Input.msg.tera",
                    Entry "msgs/msg/{{ entry.class }}Output.msg" "ros2/Output.msg.tera",
                    Package "node/package.xml" "ros2/package.xml.tera",
                    Package "node/CMakeLists.txt" "ros2/CMakeLists.txt.tera",
                    Component "node/{{ component.name }}_node.cpp" "ros2/node.cpp.tera",
                ],
                next!("ros2"),
            )
        },
        System::MicroRos => Form {
            sources: "node/src/",
            style: Style { input: "input->", ..DOTS },
            ..plain(
                files![
                    Package "msgs/package.xml" "ros2/msgs-package.xml.tera",
                    Package "msgs/CMakeLists.txt" "ros2/msgs-CMakeLists.txt.tera",
                    Entry "msgs/msg/{{ entry.class }}Input.msg" "ros2/Input.msg.tera",
                    Entry "msgs/msg/{{ entry.class }}Output.msg" "ros2/Output.msg.tera",
                    Package "node/CMakeLists.txt" "micro-ros/app-CMakeLists.txt.tera",
                    Package "node/app.c" "micro-ros/app.c.tera",
                    Component "node/{{ component.name }}_node.h" "micro-ros/node.h.tera",
                    Component "node/{{ component.name }}_node.c" "micro-ros/node.c.tera",
                ],
                next!("micro-ros"),
            )
        },
    }
}
