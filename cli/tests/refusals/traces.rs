//! Lines that have no counterpart, and C that is not what its map says.

use crate::workspaces::PACKAGE;
use crate::{Case, File, PLAIN};

const C: File = ("generated/motor.c", "int a;\nint b;\n");
const MAP: File =
    ("generated/motor.c.map", "# C line\tRust file:line\tfunction\n1\tsrc/lib.rs:1\tmotor::A\n");
const RUST: File = ("src/lib.rs", "const A: i32 = 0;\n\n");

const MAPPED: &[File] = &[PACKAGE[0], RUST, PACKAGE[2], PACKAGE[3], C, MAP];

/// Each, with the error that is reported.
pub const CASES: &[Case<'static>] = &[
    Case {
        name: "a line of C without a number",
        files: MAPPED,
        words: &["where", "generated/motor.c"],
        said: "`generated/motor.c` names no line",
        remedy: "cargo bessemer where generated/motor.c:40",
        ..PLAIN
    },
    Case {
        name: "line 0",
        files: MAPPED,
        words: &["where", "motor.c:0"],
        said: "`motor.c:0` names no line",
        ..PLAIN
    },
    Case {
        name: "no C",
        files: PACKAGE,
        words: &["where", "motor.c:1"],
        said: "/generated` has no C with maps",
        remedy: "cargo bessemer gen",
        ..PLAIN
    },
    Case {
        name: "C of another name",
        files: MAPPED,
        words: &["where", "motor_c.c:1"],
        said: "the C has no file `motor_c.c`",
        remedy: "choose from motor.c",
        ..PLAIN
    },
    Case {
        name: "a line behind the end of the C",
        files: MAPPED,
        words: &["where", "motor.c:3"],
        said: "`motor.c` has 2 lines, and no line 3",
        ..PLAIN
    },
    Case {
        name: "Rust that becomes no C",
        files: MAPPED,
        words: &["where", "src/other.rs:1"],
        said: "no C comes from `src/other.rs`",
        remedy: "a path from the workspace",
        ..PLAIN
    },
    Case {
        name: "a line behind the end of the Rust",
        files: MAPPED,
        words: &["where", "src/lib.rs:9"],
        said: "`src/lib.rs` has 2 lines, and no line 9",
        ..PLAIN
    },
    Case {
        name: "C that was shortened after its generation",
        files: &[PACKAGE[0], RUST, PACKAGE[2], PACKAGE[3], ("generated/motor.c", ""), MAP],
        words: &["where", "motor.c:1"],
        said: "`motor.c` was changed after its generation: its map has line 1, the file has 0",
        remedy: "cargo bessemer gen",
        ..PLAIN
    },
    Case {
        name: "a map that is none",
        files: &[
            PACKAGE[0],
            RUST,
            PACKAGE[2],
            PACKAGE[3],
            C,
            ("generated/motor.c.map", "# C\n1 2 3\n"),
        ],
        words: &["where", "motor.c:1"],
        said: "line 2: this is no line of a map",
        remedy: "cargo bessemer gen",
        ..PLAIN
    },
];
