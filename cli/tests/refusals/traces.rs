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
    Case {
        name: "a dossier to compare that is none",
        files: MAPPED,
        words: &["dossier", "--check", "generated"],
        said: "`generated` is no dossier",
        remedy: "name the folder that `cargo bessemer dossier` wrote",
        ..PLAIN
    },
    Case {
        name: "a dossier to compare that is not there",
        files: MAPPED,
        words: &["dossier", "--check", "nowhere"],
        said: "`nowhere` is no dossier",
        ..PLAIN
    },
    Case {
        name: "a dossier over the author's files",
        files: MAPPED,
        words: &["dossier", "--output", "src"],
        said: "which no dossier wrote",
        remedy: "choose another folder with `--output`",
        ..PLAIN
    },
    Case {
        name: "a dossier over the C",
        files: MAPPED,
        words: &["dossier", "--output", "generated"],
        said: "which no dossier wrote",
        ..PLAIN
    },
    Case {
        name: "inputs without a file",
        files: MAPPED,
        words: &["dossier", "--inputs", "flight.csv"],
        said: "`flight.csv` is no entry point with a file",
        remedy: "--inputs Motor::step=flight.csv",
        ..PLAIN
    },
    Case {
        name: "reasons that are no table",
        files: MAPPED,
        words: &["dossier", "--reasons", "src/lib.rs"],
        said: "`src/lib.rs`: the first line names no column `function`",
        remedy: "pass CSV whose first line is `function,code,reason`",
        ..PLAIN
    },
    Case {
        name: "inputs that are not there",
        files: MAPPED,
        words: &["dossier", "--inputs", "Motor::step=flight.csv"],
        said: "`flight.csv`: No such file",
        ..PLAIN
    },
    Case {
        name: "requirements that are not there",
        files: MAPPED,
        words: &["dossier", "--requirements", "hlr.csv"],
        said: "`hlr.csv`: No such file",
        ..PLAIN
    },
    Case {
        name: "requirements without identifiers",
        files: &[PACKAGE[0], RUST, PACKAGE[2], PACKAGE[3], C, MAP, ("hlr.csv", "name,text\nA,B\n")],
        words: &["dossier", "--requirements", "hlr.csv"],
        said: "`hlr.csv`: the first line names no column `id`: name, text",
        remedy: "CSV with a column `id`",
        ..PLAIN
    },
    Case {
        name: "two requirements of one name",
        files: &[PACKAGE[0], RUST, PACKAGE[2], PACKAGE[3], C, MAP, ("hlr.csv", "id\nA\nA\n")],
        words: &["dossier", "--requirements", "hlr.csv"],
        said: "`hlr.csv`: line 3: `A` is there twice, first in line 2",
        remedy: "an identifier of its own",
        ..PLAIN
    },
    Case {
        name: "requirements in broken XML",
        files: &[
            PACKAGE[0],
            RUST,
            PACKAGE[2],
            PACKAGE[3],
            C,
            MAP,
            ("hlr.reqif", "<REQ-IF></other>"),
        ],
        words: &["dossier", "--requirements", "hlr.reqif"],
        said: "`hlr.reqif`: line 1: ",
        remedy: "or ReqIF",
        ..PLAIN
    },
    Case {
        name: "an attribute that names no requirement",
        files: &[
            PACKAGE[0],
            ("src/lib.rs", "\n#[requirement(HLR)]\nfn f() {}\n"),
            PACKAGE[2],
            PACKAGE[3],
            C,
            MAP,
        ],
        words: &["dossier"],
        said: "`src/lib.rs`, line 2: a requirement is named by its identifier",
        ..PLAIN
    },
    Case {
        name: "a source that is no Rust",
        files: &[PACKAGE[0], ("src/lib.rs", "fn f( {\n"), PACKAGE[2], PACKAGE[3], C, MAP],
        words: &["dossier"],
        said: "`src/lib.rs`, line ",
        ..PLAIN
    },
    Case {
        name: "a version without a repository",
        files: MAPPED,
        words: &["dossier", "--since", "v1"],
        said: "git knows no version `v1`: ",
        remedy: "`git tag`",
        ..PLAIN
    },
    Case {
        name: "a version that would be an option of git",
        files: MAPPED,
        words: &["dossier", "--since=--all"],
        said: "git knows no version `--all`: ",
        ..PLAIN
    },
    Case {
        name: "reasons that are not there",
        files: MAPPED,
        words: &["dossier", "--reasons", "coverage.csv"],
        said: "`coverage.csv`: No such file",
        ..PLAIN
    },
    Case {
        name: "reasons with a row that lacks a cell",
        files: &[
            PACKAGE[0],
            RUST,
            PACKAGE[2],
            PACKAGE[3],
            C,
            MAP,
            ("coverage.csv", "function,code,reason\nf,g();\n"),
        ],
        words: &["dossier", "--reasons", "coverage.csv"],
        said: "`coverage.csv`: line 2: ",
        remedy: "function,code,reason",
        ..PLAIN
    },
    Case {
        name: "a dossier in place of a file",
        files: MAPPED,
        words: &["dossier", "--output", "Cargo.toml"],
        said: "Cargo.toml`: Not a directory",
        ..PLAIN
    },
    Case {
        name: "a dossier whose manifest is cut off",
        files: &[
            PACKAGE[0],
            RUST,
            PACKAGE[2],
            PACKAGE[3],
            C,
            MAP,
            ("dossier/manifest.json", "{\"package\": \"mo"),
        ],
        words: &["dossier", "--check", "dossier"],
        said: "`dossier` is no dossier",
        ..PLAIN
    },
    Case {
        name: "a dossier over a manifest of another program",
        files: &[PACKAGE[0], RUST, PACKAGE[2], PACKAGE[3], C, MAP, ("dossier/manifest.json", "{}")],
        words: &["dossier"],
        said: "which no dossier wrote",
        ..PLAIN
    },
    Case {
        name: "requirements that are a folder",
        files: MAPPED,
        words: &["dossier", "--requirements", "src"],
        said: "`src`: Is a directory",
        ..PLAIN
    },
    Case {
        name: "a requirement without an identifier",
        files: &[
            PACKAGE[0],
            RUST,
            PACKAGE[2],
            PACKAGE[3],
            C,
            MAP,
            ("hlr.csv", "id,text\nA,B\n,C\n"),
        ],
        words: &["dossier", "--requirements", "hlr.csv"],
        said: "`hlr.csv`: line 3: the requirement has no identifier",
        remedy: "give the requirement an identifier",
        ..PLAIN
    },
    Case {
        name: "a requirement whose text has a separator without quotes",
        files: &[
            PACKAGE[0],
            RUST,
            PACKAGE[2],
            PACKAGE[3],
            C,
            MAP,
            ("hlr.csv", "id,text\nA,B\nC,the motor stops, at once\n"),
        ],
        words: &["dossier", "--requirements", "hlr.csv"],
        said: "`hlr.csv`: line 3: 3 cells below 2 columns",
        remedy: "between quotes",
        ..PLAIN
    },
    Case {
        name: "an archive of requirements",
        files: &[PACKAGE[0], RUST, PACKAGE[2], PACKAGE[3], C, MAP, ("hlr.reqifz", "PK\u{3}\u{4}x")],
        words: &["dossier", "--requirements", "hlr.reqifz"],
        said: "`hlr.reqifz`: this is an archive",
        remedy: "unpack it",
        ..PLAIN
    },
    Case {
        name: "requirements beside the manifest that are wrong",
        files: &[
            PACKAGE[0],
            RUST,
            PACKAGE[2],
            PACKAGE[3],
            C,
            MAP,
            ("requirements.csv", "id\nA\nA\n"),
        ],
        words: &["dossier"],
        said: "requirements.csv`: line 3: `A` is there twice",
        ..PLAIN
    },
    Case {
        name: "reasons beside the manifest that are wrong",
        files: &[
            PACKAGE[0],
            RUST,
            PACKAGE[2],
            PACKAGE[3],
            C,
            MAP,
            ("coverage.csv", "function\nA\n"),
        ],
        words: &["dossier"],
        said: "coverage.csv`: the first line names no column `code`",
        ..PLAIN
    },
    Case {
        name: "a dossier of a package that is not there",
        files: MAPPED,
        words: &["dossier", "--package", "pump"],
        said: "the workspace has no package `pump`",
        remedy: "choose from motor",
        ..PLAIN
    },
    Case {
        name: "tests of a package that is not there",
        files: MAPPED,
        words: &["dossier", "--tests", "pump"],
        said: "the workspace has no package `pump`",
        remedy: "choose from motor",
        ..PLAIN
    },
    Case {
        name: "rounds that are no number",
        files: MAPPED,
        words: &["dossier", "--fill", "all"],
        said: "invalid value 'all' for '--fill <ROUNDS>'",
        ..PLAIN
    },
    Case {
        name: "a comparison that would also write",
        files: MAPPED,
        words: &["dossier", "--check", "dossier", "--since", "v1"],
        said: "cannot be used with",
        ..PLAIN
    },
    Case {
        name: "a reason that is empty",
        files: &[
            PACKAGE[0],
            RUST,
            PACKAGE[2],
            PACKAGE[3],
            C,
            MAP,
            ("coverage.csv", "function,code,reason\nf,g();,\n"),
        ],
        words: &["dossier", "--reasons", "coverage.csv"],
        said: "`coverage.csv`: line 2: `reason` is empty",
        ..PLAIN
    },
    Case {
        name: "reasons that are no text",
        files: &[PACKAGE[0], RUST, PACKAGE[2], PACKAGE[3], C, MAP, ("coverage.csv", "")],
        words: &["dossier", "--reasons", "coverage.csv"],
        said: "`coverage.csv`: the first line names no column `function`",
        ..PLAIN
    },
    Case {
        name: "an attribute with an empty requirement",
        files: &[
            PACKAGE[0],
            ("src/lib.rs", "\n#[requirement(\"\")]\nfn f() {}\n"),
            PACKAGE[2],
            PACKAGE[3],
            C,
            MAP,
        ],
        words: &["dossier"],
        said: "`src/lib.rs`, line 2: an identifier of a requirement is one word",
        ..PLAIN
    },
    Case {
        name: "requirements in XML of something else",
        files: &[PACKAGE[0], RUST, PACKAGE[2], PACKAGE[3], C, MAP, ("hlr.reqif", "<html></html>")],
        words: &["dossier", "--requirements", "hlr.reqif"],
        said: "`hlr.reqif`: ",
        remedy: "or ReqIF",
        ..PLAIN
    },
    Case {
        name: "inputs without an entry point",
        files: MAPPED,
        words: &["dossier", "--inputs", "=flight.csv"],
        said: "`=flight.csv` is no entry point with a file",
        ..PLAIN
    },
];
