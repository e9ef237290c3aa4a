//! The keys of `bessemer.toml`: one table, which the reader, the JSON Schema and the page of the documentation follow.

use bessemer_backend::kernels::{Mode, Processors};
use bessemer_codegen::compile::{Layout, Math, Standard};

use crate::settings::{Limit, Settings};

/// A key.
pub struct Key {
    /// Name of the key, with its section: `kernels.mode`.
    pub name: &'static str,
    /// Permitted values.
    pub kind: Kind,
    /// Default value, or a description of the default.
    pub default: &'static str,
    /// The effect, for the documentation.
    pub says: &'static str,
}

/// Form of a value, and the setting that it changes.
pub enum Kind {
    /// Text of a form.
    Text(Form, fn(&mut Settings, String)),
    /// One of these words; the setting gets its index.
    Choice(&'static [&'static str], fn(&mut Settings, usize)),
    /// `true` or `false`.
    Flag(fn(&mut Settings, bool)),
    /// A whole number up to this one.
    Number(u32, fn(&mut Settings, Limit)),
    /// A list of tables, read by the compiler's own reader of replacements.
    Replacements,
    /// A table for each entry point: its parameters, each with a source in a flight log.
    Inputs,
    /// A table for each entry point: fields of topics, each with its value.
    Outputs,
    /// A table: entry points, each with its period in seconds.
    Periods,
}

/// The form of a text.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    /// A folder, below that of the file or above it.
    Folder,
    /// A folder below that of the C.
    Headers,
    /// The beginning of a C name.
    Prefix,
    /// A C name that is not reserved.
    Name,
    /// An SPDX expression.
    License,
}

impl Form {
    /// A description of the form, for error messages.
    pub fn expected(self) -> &'static str {
        match self {
            Form::Folder => "a folder of its own, such as \"generated\" or \"../firmware/models\"",
            Form::Headers => {
                "a folder below that of the C, of letters, digits and `_`, such as \"acme\" or \"acme/control\""
            }
            Form::Prefix => {
                "letters, digits and `_`, with a letter first and no reserved name, such as \"acme_\""
            }
            Form::Name => "a name of C that is not reserved, such as \"motor_fault\"",
            Form::License => {
                "an SPDX expression, such as \"MIT OR Apache-2.0\" or \"LicenseRef-Acme\""
            }
        }
    }

    /// Returns the values of the key as a regular expression.
    pub fn pattern(self) -> &'static str {
        match self {
            Form::Folder => r"^.*[^./].*$",
            Form::Headers => "^([A-Za-z][A-Za-z0-9_]*(/[A-Za-z][A-Za-z0-9_]*)*)?$",
            Form::Prefix => "^([A-Za-z][A-Za-z0-9_]*)?$",
            Form::Name => "^[A-Za-z][A-Za-z0-9_]*$",
            Form::License => r"^[A-Za-z0-9.+:()\- ]+$",
        }
    }

    /// Tells whether a text has this form.
    pub fn fits(self, text: &str) -> bool {
        let word = |it: char| it.is_ascii_alphanumeric() || it == '_';
        let is_name = |text: &str| {
            text.starts_with(|it: char| it.is_ascii_alphabetic()) && text.chars().all(word)
        };
        let named = is_name(text);
        match self {
            Form::Folder => {
                text.split('/').any(|part| !matches!(part, "" | "." | ".."))
                    && !text.contains(['\0', '\n'])
            }
            Form::Headers => text.is_empty() || text.split('/').all(is_name),
            Form::Prefix => text.is_empty() || named,
            Form::Name => named && !bessemer_backend::c::is_reserved(text),
            Form::License => {
                let taken = |it: char| it.is_ascii_alphanumeric() || "().+-: ".contains(it);
                !text.trim().is_empty() && text.chars().all(taken)
            }
        }
    }
}

/// Largest number of threads of a kernel, whose handles are on the stack.
const THREADS: u32 = 64;

/// All keys, in the order of the documentation.
pub const KEYS: &[Key] = &[
    Key {
        name: "output",
        kind: Kind::Text(Form::Folder, |to, text| to.output = Some(text.into())),
        default: "`generated` at the root of the workspace",
        says: "The folder of the C, relative to this file. The generator owns it.",
    },
    Key {
        name: "license",
        kind: Kind::Text(Form::License, |to, text| to.license = Some(text)),
        default: "the package's, from its Cargo.toml",
        says: "The licence at the head of each file, as an SPDX expression.",
    },
    Key {
        name: "prefix",
        kind: Kind::Text(Form::Prefix, |to, text| to.options.prefix = text),
        default: "\"\"",
        says: "The prefix of every type, function, file and include guard.",
    },
    Key {
        name: "headers",
        kind: Kind::Text(Form::Headers, |to, text| to.options.headers = text),
        default: "\"\": beside the sources",
        says: "The folder of the headers within the folder of the C: with \"acme\" each file includes `acme/motor.h`, its guard is `ACME_MOTOR_H`, and the include path is still the folder of the C.",
    },
    Key {
        name: "status",
        kind: Kind::Text(Form::Name, |to, text| to.options.status = text),
        default: "the prefix without its last `_`, or `\"bessemer\"`",
        says: "The stem of the status type and of the common files: `bessemer` gives `bessemer_status_t` and `bessemer_target.h`.",
    },
    Key {
        name: "hook",
        kind: Kind::Text(Form::Name, |to, text| to.options.hook = Some(text)),
        default: "none: functions that can fault return a status",
        says: "A function of the firmware that a fault calls, and that does not return; then no function returns a status.",
    },
    Key {
        name: "c_standard",
        kind: Kind::Choice(
            &["c99", "c11", "c17", "c23", "gnu99", "gnu11", "gnu17", "gnu23"],
            |to, which| to.options.standard = Standard::ALL[which],
        ),
        default: "\"c99\"",
        says: "The C standard of the sources: the flag in build files, `pack` and `verify`. From C11, the sources refuse an older standard and check the sizes of numbers by `_Static_assert`; headers stay C99 and C++.",
    },
    Key {
        name: "layout",
        kind: Kind::Choice(&["columns", "rows", "array"], |to, which| {
            to.options.layout = [Layout::Columns, Layout::Rows, Layout::Array][which];
        }),
        default: "\"columns\"",
        says: "The memory layout of matrices: `double m[6]` by columns or by rows, or `double m[2][3]`.",
    },
    Key {
        name: "math",
        kind: Kind::Choice(&["portable", "target"], |to, which| {
            to.options.math = [Math::Portable, Math::Target][which];
        }),
        default: "\"portable\"",
        says: "The elementary functions: Bessemer's, with the same bits on every target, or those of the target's `math.h`, whose bits may differ from the Rust's.",
    },
    Key {
        name: "self_test",
        kind: Kind::Flag(|to, flag| to.options.self_test = flag),
        default: "false",
        says: "Adds `bessemer_self_test()`, which checks the arithmetic of the target at run time.",
    },
    Key {
        name: "pragmas",
        kind: Kind::Flag(|to, flag| to.options.pragmas = flag),
        default: "true",
        says: "Keeps the pragmas by which gcc and clang compute as the Rust does whatever their flags say. `false` is for another compiler: the flags alone decide then, so it requires `self_test = true`, which shows a wrong one on the target, and `kernels.mode = \"plain\"`.",
    },
    Key {
        name: "ascii",
        kind: Kind::Flag(|to, flag| to.options.ascii = flag),
        default: "false",
        says: "Writes every comment in ASCII: `rad/s^2` for `rad/s²`, `pi` for `π`.",
    },
    Key {
        name: "trace",
        kind: Kind::Choice(&["maps", "comments"], |to, which| {
            to.options.trace_comments = which == 1;
        }),
        default: "\"maps\"",
        says: "The way from a line of C to its line of Rust: the `.map` file beside each file, or also a comment at the end of each line, such as `/* src/motor.rs:12 */`. With comments, the C changes when a line of the Rust moves.",
    },
    Key {
        name: "contracts",
        kind: Kind::Choice(&["none", "acsl"], |to, which| to.options.contracts = which == 1),
        default: "\"none\"",
        says: "Comments for Frama-C, in its language ACSL: what a caller of each function keeps to, what a function and a loop change, and the bounds of a loop's counter.",
    },
    Key {
        name: "keep_checks",
        kind: Kind::Flag(|to, flag| to.options.keep_checks = flag),
        default: "false",
        says: "Keeps the checks that were proved never to fail; one that fails ends the program. This tests the proofs on a host, and is not for a target.",
    },
    Key {
        name: "build_files",
        kind: Kind::Flag(|to, flag| to.build_files = flag),
        default: "false",
        says: "Adds a `CMakeLists.txt` with a library and its flags, a fragment for make, and an example program for each component, such as `motor_example_main.c`.",
    },
    Key {
        name: "interface",
        kind: Kind::Flag(|to, flag| to.interface = flag),
        default: "false",
        says: "Adds `interface.json` for other tools: types with offsets, units and ranges, and entry points (docs/interface.schema.json).",
    },
    Key {
        name: "parameters",
        kind: Kind::Flag(|to, flag| to.parameters = flag),
        default: "false",
        says: "Adds tables of the parameters in C: name, type, unit, range, offset and size of each, and functions that read and set one within its range (`bessemer_parameter_table.h`).",
    },
    Key {
        name: "kernels.mode",
        kind: Kind::Choice(&["exact", "fast", "plain"], |to, which| {
            to.options.kernels.mode = [Mode::Exact, Mode::Fast, Mode::Plain][which];
        }),
        default: "\"exact\"",
        says: "The form of linear algebra kernels: with the bits of the Rust; faster, within stated error bounds; or with the bits of the Rust as plain C99 loops, without vectors, `__asm__` and `#if`, and with the loops of the source as they are written.",
    },
    Key {
        name: "kernels.processors",
        kind: Kind::Choice(&["every", "cortex-a", "cortex-m", "x86-64"], |to, which| {
            use Processors::{CortexA, CortexM, Every, X86};
            to.options.kernels.processors = [Every, CortexA, CortexM, X86][which];
        }),
        default: "\"every\"",
        says: "The processors for which kernel files have code besides their C99 loops: every one, or one family. A build for another processor uses C99, with the same bits.",
    },
    Key {
        name: "kernels.code_bytes",
        kind: Kind::Number(u32::MAX, |to, it| to.options.kernels.code_bytes = it.most),
        default: "8192",
        says: "The largest estimated code size of a kernel, in bytes. Below 1024, the loops of the source are not tiled either: each runs pass by pass, as it is written, and no pragma has gcc write out the passes of short ones.",
    },
    Key {
        name: "kernels.threads",
        kind: Kind::Number(THREADS, |to, it| to.options.threads = it.most),
        default: "0",
        says: "The number of POSIX threads that share the work of a large kernel; the target must provide them. 0 and 1 mean none. `-DBESSEMER_THREADS=4U` in a build overrides it. The bits are the Rust's for any number; kernels of the mode \"plain\" use no threads.",
    },
    Key {
        name: "limits.stack_bytes",
        kind: Kind::Number(u32::MAX, |to, it| to.limits.stack_bytes = Some(it)),
        default: "none",
        says: "The largest stack of an entry point, as `gen` estimates it and as `verify --target` measures it; more is an error.",
    },
    Key {
        name: "limits.state_bytes",
        kind: Kind::Number(u32::MAX, |to, it| to.limits.state_bytes = Some(it)),
        default: "none",
        says: "The largest state of a component, in bytes; more is an error.",
    },
    Key {
        name: "limits.checks",
        kind: Kind::Number(u32::MAX, |to, it| to.limits.checks = Some(it)),
        default: "none",
        says: "The largest number of checks for faults in an entry point; more is an error.",
    },
    Key {
        name: "limits.instructions",
        kind: Kind::Number(u32::MAX, |to, it| to.limits.instructions = Some(it)),
        default: "none",
        says: "The largest number of instructions of a call of an entry point, as `verify --target` counts them; more is an error.",
    },
    Key {
        name: "limits.estimated_instructions",
        kind: Kind::Number(u32::MAX, |to, it| to.limits.estimated_instructions = Some(it)),
        default: "none",
        says: "The largest estimate of the instructions of an entry point on its longest path, by the model of `cargo bessemer dossier`, which is no bound; more is an error, and so is a loop without a known number of passes.",
    },
    Key {
        name: "limits.text_bytes",
        kind: Kind::Number(u32::MAX, |to, it| to.limits.text_bytes = Some(it)),
        default: "none",
        says: "The largest size of all instructions and constants, in bytes, on a processor of `verify --target`; more is an error.",
    },
    Key {
        name: "replacements",
        kind: Kind::Replacements,
        default: "none",
        says: "Functions of your own library that replace kernels, each a table: `routine`, `element`, `at_least`, `at_most`, `library`, `include`, `body` (docs/kernels.md).",
    },
    Key {
        name: "inputs",
        kind: Kind::Inputs,
        default: "none",
        says: "The sources of an entry point's parameters in a flight log, for `verify --inputs` (docs/book/flight-logs.md).",
    },
    Key {
        name: "outputs",
        kind: Kind::Outputs,
        default: "none",
        says: "The topics of PX4 to which the results of an entry point go, in the module of `pack px4`; its parameters then come from the topics of `inputs` (docs/book/build-systems.md).",
    },
    Key {
        name: "periods",
        kind: Kind::Periods,
        default: "none",
        says: "The time between two calls of an entry point, in seconds, to which `verify --inputs` resamples a flight log.",
    },
];
