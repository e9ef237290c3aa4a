//! The C in a vendor's firmware. Two versions of one package coexist, headers are in folders of their own, and a
//! `table.h` of the vendor's is found before theirs.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use bessemer_project::{Wanted, generate};
use bessemer_tests::toolchain::{self, run};
use bessemer_tests::workspace::Workspace;
use cargo_bessemer::args::{Fmu, Sizes, Verify};
use cargo_bessemer::{fmu, sizes, verify};

use super::packs;

/// A package whose module is called as the vendor's header, with a state, a status, data with defaults, a square root
/// and a kernel.
const MODEL: &str = "//! A table.
#![no_std]

/// Rows by speed.
pub mod table {
    use bessemer::prelude::*;

    /// Gains.
    #[data]
    #[derive(Clone, Debug)]
    pub struct Gains {
        /// Gain of the error.
        #[range(0.0..=9.0)]
        pub error: f64,
    }

    impl Default for Gains {
        fn default() -> Gains {
            Gains { error: 2.0 }
        }
    }

    /// Counts its calls.
    #[component]
    #[derive(Clone, Debug, Default)]
    pub struct Motor {
        /// So many.
        pub calls: u32,
    }

    #[component]
    impl Motor {
        /// One period.
        #[entry]
        pub fn step(&mut self, gains: &Gains, speed: f64, map: &Matrix4<f64>) -> f64 {
            self.calls += 1;
            let turned = map * map;
            speed.sqrt() * gains.error + speed.sin() + turned[(3, 3)] + VERSION
        }
    }

    const VERSION: f64 = 1000.0;
}
";

/// The models: a table, and what messages may have to hold.
fn models() -> String {
    format!("{MODEL}{}", packs::WATCH)
}

/// Calls both versions.
const MAIN: &str = r#"#include "table.h"
#include "new/new_motor.h"
#include "new/new_parameter_table.h"
#include "old/motor.h"
#include "old/table.h"

#include <stdio.h>

#if (VENDORS_ROWS != 7) || !defined(TABLE_H) || !defined(OLD_TABLE_H)
#error "one of the two tables is not there"
#endif

int main(void)
{
    static const double map[16] = {0};
    motor_t first;
    new_motor_t second;
    gains_t gains;
    new_gains_t others;
    double one = 0.0;
    double other = 0.0;
    motor_init(&first);
    new_motor_init(&second);
    gains_defaults(&gains);
    new_gains_defaults(&others);
    const bessemer_status_t status = motor_step(&first, &gains, 4.0, map, &one);
    const new_status_t state = new_motor_step(&second, &others, 4.0, map, &other);
    (void)printf("%.1f %d %d\n", other - one, (int)status, (int)state);
    return ((status == BESSEMER_STATUS_OK) && (state == NEW_STATUS_OK)) ? 0 : 1;
}
"#;

const VENDORS: &str = "#ifndef TABLE_H\n#define TABLE_H\n#define VENDORS_ROWS 7\n#endif\n";

/// The C of a version, as it would be checked in.
fn version(workspace: &Workspace, name: &str, more: &str) -> PathBuf {
    let settings = format!(
        "output = \"../{name}\"\nheaders = \"{name}\"\nbuild_files = true\ninterface = true\nparameters = true\n\
         self_test = true\n{more}"
    );
    fs::write(workspace.folder().join("bessemer.toml"), settings).expect("the settings");
    for check in [false, true] {
        let wanted = Wanted { check, ..Wanted::default() };
        generate(&workspace.path(""), wanted).unwrap_or_else(|error| panic!("{}", error.text()));
    }
    workspace.path(name)
}

/// The sources in a folder, without the programs that are examples.
fn sources(folder: &Path) -> Vec<PathBuf> {
    let files = fs::read_dir(folder).expect("the C").flatten().map(|it| it.path());
    let is_source = |it: &PathBuf| {
        let name = it.to_string_lossy();
        name.ends_with(".c") && !name.ends_with("_example_main.c")
    };
    files.filter(is_source).collect()
}

/// Checks two packages of two versions in one firmware, one with a prefix and both with a folder of headers. Each
/// computes its own result, though a vendor's header of equal name and guard is found first.
#[test]
fn two_versions_stand_in_one_firmware() {
    let workspace = Workspace::with_source(&models()).expect("a workspace");
    let old = version(&workspace, "old", "");
    workspace.replace("VERSION: f64 = 1000.0", "VERSION: f64 = 1064.0").expect("the models");
    let new = version(&workspace, "new", "prefix = \"new_\"\nc_standard = \"gnu11\"\n");

    let firmware = workspace.path("firmware");
    fs::create_dir_all(firmware.join("vendor")).expect("a folder");
    fs::write(firmware.join("vendor/table.h"), VENDORS).expect("a file");
    fs::write(firmware.join("main.c"), MAIN).expect("a file");
    for toolchain in toolchain::host().iter().filter(|it| it.level == 2) {
        let mut objects = Vec::new();
        for (folder, standard) in [(&old, "-std=c99"), (&new, "-std=gnu11")] {
            for source in sources(folder) {
                let object = source.with_extension("o");
                let mut command = toolchain.command();
                command.arg("-I").arg(firmware.join("vendor")).arg("-I").arg(folder).arg(standard);
                run(command.arg("-c").arg(&source).arg("-o").arg(&object)).expect("an object");
                fs::rename(&object, firmware.join(format!("{}.o", objects.len()))).expect("a file");
                objects.push(format!("{}.o", objects.len()));
            }
        }
        let mut command = toolchain.command();
        command.args(["-I", "vendor", "-I", "../old", "-I", "../new", "main.c"]).args(objects);
        run(command.args(["-o", "program", "-lm"]).current_dir(&firmware)).expect("a firmware");
        let output = Command::new(firmware.join("program")).output().expect("it runs");
        let text = String::from_utf8_lossy(&output.stdout);
        assert_eq!(text, "64.0 0 0\n", "{}", toolchain.compiler);
    }
    built(&workspace, &old);
    packs::of(&workspace.path(""), &workspace.folder().join("bessemer.toml"));
    verified(&workspace);
}

/// By the build files, which carry the include path; with the example, which includes by the folder.
fn built(workspace: &Workspace, old: &Path) {
    let make = "include ../old/models.mk\nexample: ../old/motor_example_main.c $(MODELS_SOURCES)\n\
        \t$(CC) $(MODELS_CFLAGS) -o $@ $^ -lm\n";
    let firmware = workspace.path("firmware");
    fs::write(firmware.join("Makefile"), make).expect("a file");
    let old = old.display().to_string();
    let steps: [&[&str]; 3] = [
        &["make", "--silent", "example"],
        &["cmake", "-S", &old, "-B", "build"],
        &["cmake", "--build", "build", "--target", "motor_example"],
    ];
    for step in steps {
        if !toolchain::is_asked_for(step[0]) {
            println!("left out: {} is not installed", step[0]);
            continue;
        }
        let mut command = Command::new(step[0]);
        run(command.args(&step[1..]).current_dir(&firmware))
            .unwrap_or_else(|said| panic!("{said}"));
    }
}

/// The commands that compile the C themselves find the headers, by the standard of the settings.
fn verified(workspace: &Workspace) {
    let (text, agree) = verify::run(&workspace.path(""), &Verify::default(), false)
        .unwrap_or_else(|error| panic!("{error}"));
    assert!(agree && text.contains("-std=gnu11"), "{text}");
    let sizes = sizes::run(&workspace.path(""), &Sizes::default(), false);
    assert!(sizes.as_ref().is_ok_and(|it| it.contains("new_motor_step")), "{sizes:?}");
    let wanted = Fmu {
        package: Default::default(),
        entry: Some("Motor::step".to_owned()),
        period: Some(0.001),
        output: workspace.path("unit"),
    };
    fmu::run(&workspace.path(""), &wanted, false).unwrap_or_else(|error| panic!("{error}"));
}
