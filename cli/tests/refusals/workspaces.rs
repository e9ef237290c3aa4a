//! Workspaces that nothing can be generated of, folders that it cannot be generated to, programs that are missing and commands that are
//! none.

use crate::{Case, File, PLAIN};

/// A sound package, as far as it is looked at here; its library is never built.
pub const SOUND: &str = "[package]\nname = \"motor\"\nedition = \"2024\"\nlicense = \"MIT\"\n\
    [dependencies]\nbessemer = { path = \"dsl\" }\n";
pub const UNLICENSED: &str = "[package]\nname = \"motor\"\nedition = \"2024\"\n[dependencies]\nbessemer = { path = \"dsl\" }\n";
pub const UNCOMMENTED: &str = "[package]\nname = \"motor\"\nedition = \"2024\"\nlicense = \"MIT */ int x;\"\n\
    [dependencies]\nbessemer = { path = \"dsl\" }\n";
pub const DSL: File = ("dsl/Cargo.toml", "[package]\nname = \"bessemer\"\nedition = \"2024\"\n");
pub const DSL_LIB: File = ("dsl/src/lib.rs", "");
pub const LIB: File = ("src/lib.rs", "");

/// A sound package whose settings are wrong or whose command is.
pub const PACKAGE: &[File] = &[("Cargo.toml", SOUND), LIB, DSL, DSL_LIB];

/// A name that is longer than file systems take.
const LONG: &str = concat!(
    "output = \"",
    "motor_motor_motor_motor_motor_motor_motor_motor_motor_motor_motor_motor_motor_motor_motor_motor_",
    "motor_motor_motor_motor_motor_motor_motor_motor_motor_motor_motor_motor_motor_motor_motor_motor_",
    "motor_motor_motor_motor_motor_motor_motor_motor_motor_motor_motor_motor_motor_motor_motor_motor_\""
);

/// Each, with what is said of it.
pub const CASES: &[Case<'static>] = &[
    Case {
        name: "no workspace",
        said: "could not find `Cargo.toml`",
        remedy: "cargo bessemer new motor",
        ..PLAIN
    },
    Case {
        name: "a manifest that is no TOML",
        files: &[("Cargo.toml", "[package\n"), LIB],
        said: "unclosed table",
        ..PLAIN
    },
    Case {
        name: "a manifest without a target",
        files: &[("Cargo.toml", "[package]\nname = \"motor\"\nedition = \"2024\"\n")],
        said: "no targets specified",
        ..PLAIN
    },
    Case {
        name: "a package that is not there",
        files: &[("Cargo.toml", SOUND), LIB],
        words: &["gen", "--package", "motr"],
        said: "the workspace has no package `motr`",
        remedy: "choose from motor",
        ..PLAIN
    },
    Case {
        name: "a program and no library",
        files: &[("Cargo.toml", SOUND), ("src/main.rs", "fn main() {}"), DSL, DSL_LIB],
        said: "the package `motor` has no library",
        remedy: "src/lib.rs",
        ..PLAIN
    },
    Case {
        name: "a library that Rust cannot link",
        files: &[
            (
                "Cargo.toml",
                "[package]\nname = \"motor\"\nedition = \"2024\"\n[lib]\ncrate-type = [\"staticlib\"]\n",
            ),
            LIB,
        ],
        said: "the library of `motor` cannot be linked",
        remedy: "\"rlib\"",
        ..PLAIN
    },
    Case {
        name: "a package without the DSL",
        files: &[("Cargo.toml", "[package]\nname = \"motor\"\nedition = \"2024\"\n"), LIB],
        said: "`motor` does not depend on `bessemer`",
        remedy: "`[dependencies]`",
        ..PLAIN
    },
    Case {
        name: "the DSL under another name",
        files: &[
            (
                "Cargo.toml",
                "[package]\nname = \"motor\"\nedition = \"2024\"\n[dependencies]\nb = { package = \"bessemer\", path = \"dsl\" }\n",
            ),
            LIB,
            DSL,
            DSL_LIB,
        ],
        said: "does not depend on `bessemer`",
        remedy: "by that name",
        ..PLAIN
    },
    Case {
        name: "the DSL for tests only",
        files: &[
            (
                "Cargo.toml",
                "[package]\nname = \"motor\"\nedition = \"2024\"\n[dev-dependencies]\nbessemer = { path = \"dsl\" }\n",
            ),
            LIB,
            DSL,
            DSL_LIB,
        ],
        said: "does not depend on `bessemer`",
        remedy: "`[dependencies]`",
        ..PLAIN
    },
    Case {
        name: "several packages, none of models",
        files: &[
            ("Cargo.toml", "[workspace]\nmembers = [\"a\", \"b\"]\n"),
            ("a/Cargo.toml", "[package]\nname = \"a\"\nedition = \"2024\"\n"),
            ("b/Cargo.toml", "[package]\nname = \"b\"\nedition = \"2024\"\n"),
            ("a/src/lib.rs", ""),
            ("b/src/lib.rs", ""),
        ],
        said: "no package of the workspace at",
        remedy: "cargo bessemer new",
        ..PLAIN
    },
    Case {
        name: "several packages of models",
        files: &[
            ("Cargo.toml", "[workspace]\nmembers = [\"a\", \"b\"]\n"),
            (
                "a/Cargo.toml",
                "[package]\nname = \"a\"\nedition = \"2024\"\n[dependencies]\nbessemer = { path = \"../dsl\" }\n",
            ),
            (
                "b/Cargo.toml",
                "[package]\nname = \"b\"\nedition = \"2024\"\n[dependencies]\nbessemer = { path = \"../dsl\" }\n",
            ),
            ("a/src/lib.rs", ""),
            ("b/src/lib.rs", ""),
            DSL,
            DSL_LIB,
        ],
        said: "several packages may have models: a, b",
        remedy: "--package a",
        ..PLAIN
    },
    Case {
        name: "no licence",
        files: &[("Cargo.toml", UNLICENSED), LIB, DSL, DSL_LIB],
        said: "has no `license`",
        remedy: "`license = \"MIT OR Apache-2.0\"`",
        ..PLAIN
    },
    Case {
        name: "a licence that ends its comment",
        files: &[("Cargo.toml", UNCOMMENTED), LIB, DSL, DSL_LIB],
        said: "cannot be written in a C comment: \"MIT */ int x;\"",
        remedy: "without `/*` and `*/`",
        ..PLAIN
    },
    Case {
        name: "a key that there is not",
        files: &[("Cargo.toml", SOUND), LIB, ("bessemer.toml", "\nprefx = \"a\"\n"), DSL, DSL_LIB],
        said: " --> bessemer.toml:2:1",
        remedy: "write `prefix`",
        ..PLAIN
    },
    Case {
        name: "settings that are a folder",
        files: &[("Cargo.toml", SOUND), LIB, ("bessemer.toml/", ""), DSL, DSL_LIB],
        said: "bessemer.toml`: Is a directory",
        ..PLAIN
    },
    Case {
        name: "a file where the C should go",
        files: &[("Cargo.toml", SOUND), LIB, ("generated", "mine"), DSL, DSL_LIB],
        said: "generated` is a file, not a folder",
        remedy: "generate into another folder",
        ..PLAIN
    },
    Case {
        name: "a file above where the C should go",
        files: &[
            ("Cargo.toml", SOUND),
            LIB,
            ("bessemer.toml", "output = \"src/lib.rs/c\""),
            DSL,
            DSL_LIB,
        ],
        said: "is a file, not a folder",
        remedy: "generate into another folder",
        ..PLAIN
    },
    Case {
        name: "somebody's notes where the C should go",
        files: &[("Cargo.toml", SOUND), LIB, ("generated/notes.txt", "mine"), DSL, DSL_LIB],
        said: "holds `notes.txt`, which Bessemer did not write",
        remedy: "move it elsewhere",
        ..PLAIN
    },
    Case {
        name: "somebody's folder where the C should go",
        files: &[("Cargo.toml", SOUND), LIB, ("generated/inner/", ""), DSL, DSL_LIB],
        said: "holds `inner`, which Bessemer did not write",
        remedy: "move it elsewhere",
        ..PLAIN
    },
    Case {
        name: "sources where the C should go",
        files: &[("Cargo.toml", SOUND), LIB, ("bessemer.toml", "output = \"src\""), DSL, DSL_LIB],
        said: "holds `lib.rs`, which Bessemer did not write",
        remedy: "generate into another folder",
        ..PLAIN
    },
    Case {
        name: "another package's C",
        files: &[
            ("Cargo.toml", SOUND),
            LIB,
            ("generated/manifest.json", "{ \"package\": \"pump\", \"files\": [] }"),
            DSL,
            DSL_LIB,
        ],
        said: "generated` holds the C of the package `pump`",
        remedy: "`output = \"…\"`",
        ..PLAIN
    },
    Case {
        name: "a folder beside the workspace's packages",
        files: &[
            ("Cargo.toml", SOUND),
            LIB,
            ("bessemer.toml", "[limits]\nstack = 3\n"),
            DSL,
            DSL_LIB,
        ],
        folder: "src",
        said: " --> bessemer.toml:2:1",
        remedy: "write `limits.stack_bytes`",
        ..PLAIN
    },
    Case {
        name: "a link to nowhere where the C should go",
        files: &[("Cargo.toml", SOUND), LIB, ("generated@", "nowhere"), DSL, DSL_LIB],
        said: "generated` is a file, not a folder",
        remedy: "generate into another folder",
        ..PLAIN
    },
    Case {
        name: "a link to itself where the C should go",
        files: &[("Cargo.toml", SOUND), LIB, ("generated@", "generated"), DSL, DSL_LIB],
        said: "generated`: Too many levels of symbolic links",
        ..PLAIN
    },
    Case {
        name: "a name that no folder can have",
        files: &[("Cargo.toml", SOUND), LIB, ("bessemer.toml", LONG), DSL, DSL_LIB],
        said: "File name too long",
        remedy: "generate into another folder",
        ..PLAIN
    },
    Case {
        name: "a folder that nobody can write to",
        files: &[
            ("Cargo.toml", SOUND),
            LIB,
            ("bessemer.toml", "output = \"/proc/generated\""),
            DSL,
            DSL_LIB,
        ],
        said: "`/proc/generated`: ",
        ..PLAIN
    },
    Case {
        name: "a device where the C should go",
        files: &[
            ("Cargo.toml", SOUND),
            LIB,
            ("bessemer.toml", "output = \"/dev/full\""),
            DSL,
            DSL_LIB,
        ],
        said: "`/dev/full` is a file, not a folder",
        remedy: "generate into another folder",
        ..PLAIN
    },
    Case {
        name: "a folder on a device",
        files: &[
            ("Cargo.toml", SOUND),
            LIB,
            ("bessemer.toml", "output = \"/dev/full/c\""),
            DSL,
            DSL_LIB,
        ],
        said: "`/dev/full/c` is a file, not a folder",
        remedy: "generate into another folder",
        ..PLAIN
    },
    Case {
        name: "a stranger's header among ours",
        files: &[
            ("Cargo.toml", SOUND),
            LIB,
            (
                "generated/manifest.json",
                "{ \"package\": \"motor\", \"files\": [\"acme/motor.h\"] }",
            ),
            ("generated/acme/motor.h", "ours"),
            ("generated/acme/notes.txt", "mine"),
            DSL,
            DSL_LIB,
        ],
        said: "holds `acme/notes.txt`, which Bessemer did not write",
        remedy: "move it elsewhere",
        ..PLAIN
    },
    Case {
        name: "settings that are no UTF-8 text",
        files: &[("Cargo.toml", SOUND), LIB, ("bessemer.toml@", "/proc/self/exe"), DSL, DSL_LIB],
        said: "bessemer.toml`: stream did not contain valid UTF-8",
        ..PLAIN
    },
    Case {
        name: "no compiler to compare with",
        files: PACKAGE,
        words: &["verify"],
        bare: true,
        said: "neither gcc nor clang can be run",
        remedy: "apt-get install gcc libc6-dev clang",
        ..PLAIN
    },
    Case {
        name: "no compiler for a module of Python",
        files: PACKAGE,
        words: &["py"],
        bare: true,
        said: "neither gcc nor clang can be run",
        remedy: "apt-get install gcc libc6-dev clang",
        ..PLAIN
    },
    Case {
        name: "no compiler for a co-simulation unit",
        files: PACKAGE,
        words: &["fmu", "--period", "0.001"],
        bare: true,
        said: "neither gcc nor clang can be run",
        remedy: "apt-get install gcc libc6-dev clang",
        ..PLAIN
    },
    Case {
        name: "no compiler for sizes",
        files: PACKAGE,
        words: &["sizes"],
        bare: true,
        said: "`gcc` does not run here",
        remedy: "apt-get install gcc",
        ..PLAIN
    },
    Case {
        name: "no compiler for sizes on a microcontroller",
        files: PACKAGE,
        words: &["sizes", "--target", "cortex-m4f"],
        bare: true,
        said: "`arm-none-eabi-gcc` does not run here",
        remedy: "apt-get install gcc-arm-none-eabi",
        ..PLAIN
    },
    Case {
        name: "a unit that is called every no second",
        files: PACKAGE,
        words: &["fmu", "--period", "0"],
        said: "the period must be greater than 0 s",
        remedy: "--period 0.001",
        ..PLAIN
    },
    Case {
        name: "a unit that is called every NaN",
        files: PACKAGE,
        words: &["fmu", "--period", "NaN"],
        said: "the period must be greater than 0 s",
        remedy: "--period 0.001",
        ..PLAIN
    },
    Case {
        name: "a firmware that is not there",
        files: PACKAGE,
        words: &["a2l", "firmware.elf", "controller=motor_t"],
        said: "firmware.elf`: No such file",
        ..PLAIN
    },
    Case {
        name: "a firmware that is no ELF",
        files: PACKAGE,
        words: &["a2l", "Cargo.toml", "controller=motor_t"],
        said: "Cargo.toml`: ",
        remedy: "the linked ELF file",
        ..PLAIN
    },
    Case {
        name: "a command that there is not",
        files: PACKAGE,
        words: &["gne"],
        said: "unrecognized subcommand 'gne'",
        remedy: "try '--help'",
        ..PLAIN
    },
    Case {
        name: "a processor that there is not",
        files: PACKAGE,
        words: &["verify", "--target", "z80"],
        said: "invalid value 'z80'",
        remedy: "cortex-m4f",
        ..PLAIN
    },
    Case {
        name: "a system that there is not",
        files: PACKAGE,
        words: &["pack", "windows"],
        said: "invalid value 'windows'",
        remedy: "zephyr",
        ..PLAIN
    },
    Case {
        name: "a switch that there is not",
        files: PACKAGE,
        words: &["gen", "--chekc"],
        said: "unexpected argument '--chekc'",
        remedy: "--check",
        ..PLAIN
    },
    Case {
        name: "a checkout that is none",
        files: PACKAGE,
        words: &["new", "pump", "--path", "src"],
        said: "is not a checkout of Bessemer",
        remedy: "pass the folder of your clone",
        ..PLAIN
    },
    Case {
        name: "a new package where something is",
        files: PACKAGE,
        words: &["new", "src"],
        said: "src` exists already",
        remedy: "choose another name",
        ..PLAIN
    },
];
