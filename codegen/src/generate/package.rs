//! Runs the generation build of a package, and the program that prints its tree.
//!
//! The build is cargo's own, of the package's library with the DSL's feature `generate`, so that the package itself
//! needs neither a feature nor a program for it; what rustc says about the builders is told in the author's terms.

use std::collections::BTreeSet;
use std::process::Stdio;

use bessemer_ir::tree::Package;
use serde_json::Value;

use super::error::Error;
use super::job::Job;
use super::program::{self, Built, Program};
use super::workspace::{Member, cargo, program as cargo_program};
use crate::deep;
use crate::diagnostic::{self, Diagnostic};
use crate::source::Sources;

/// How often what was built may turn out to be another workspace's.
const TRIES: usize = 10;

/// The tree of a package.
pub(super) fn tree(job: &Job, member: &Member, sources: &Sources) -> Result<Package, Error> {
    let library = member.models()?;
    let license = job.license.as_ref().or(member.license.as_ref());
    let license = license.ok_or_else(|| Error::NoLicense { package: job.package.clone() })?;
    let failed = |reason: String| Error::Tree { package: job.package.clone(), reason };
    let mut why = "another workspace keeps building into the same target folder".to_owned();
    for _ in 0..TRIES {
        let built = build(job, sources, true)?;
        let variables = [("CARGO_PKG_NAME", job.package.as_str()), ("CARGO_PKG_LICENSE", license)];
        let text = format!("bessemer::print_tree!({library});\n");
        let program = match built.link(&job.root, library, &text, &variables)? {
            Ok(program) => program,
            Err(said) => {
                why = said;
                continue;
            }
        };
        let printed = program.run()?;
        if !printed.success {
            return Err(failed(printed.error));
        }
        if printed.strangers.is_empty() {
            let read = || bessemer_ir::tree::read(&printed.tree);
            return deep::deep(read).map_err(|error| failed(error.to_string()));
        }
        for source in &printed.strangers {
            program::touch(source)?;
        }
    }
    Err(failed(why))
}

/// What cargo is told with `--config` for a generation build of a package. Its program runs once, for its tree: the builders are
/// not worth optimising, and nobody steps through them.
pub fn settings(package: &str) -> impl Iterator<Item = String> {
    let of = |package: &str| {
        ["opt-level=0", "debug=false"].map(|it| format!("profile.dev.package.{package}.{it}"))
    };
    let whole = "profile.dev.panic=\"unwind\"".to_owned();
    of(package).into_iter().chain(of("bessemer")).chain([whole])
}

/// Bytes of rustc's stack in a generation build. In the witness copy each value of an expression stands in a call, so
/// what nests as deep as an author's Rust may nests three times as deep there. Only what is used of it is memory.
const RUSTC_STACK: usize = 1 << 30;

/// A program around the package as rustc makes it, without builders; or what rustc said of the text, in a line each.
pub(super) fn native(
    job: &Job,
    member: &Member,
    sources: &Sources,
    text: &str,
) -> Result<Result<Program, String>, Error> {
    build(job, sources, false)?.link(&job.root, member.models()?, text, &[])
}

/// Builds the package and what it is made of; in a generation build, with their builders.
fn build(job: &Job, sources: &Sources, generating: bool) -> Result<Built, Error> {
    let mut command = cargo(&["build", "--quiet", "--lib"]);
    command
        .args(["--message-format=json-diagnostic-rendered-ansi", "--package", &job.package])
        .current_dir(&job.root)
        .stderr(Stdio::piped());
    if generating {
        command.args(["--features", "bessemer/generate"]);
        if std::env::var_os("RUST_MIN_STACK").is_none() {
            command.env("RUST_MIN_STACK", RUSTC_STACK.to_string());
        }
        settings(&job.package).for_each(|it| _ = command.args(["--config", &it]));
    }
    let output =
        command.output().map_err(|source| Error::Run { program: cargo_program(), source })?;
    let text = String::from_utf8_lossy(&output.stdout);
    let messages: Vec<Value> =
        text.lines().filter_map(|line| serde_json::from_str(line).ok()).collect();
    if output.status.success() {
        return Ok(Built::of(&messages));
    }
    let mut said = errors(&messages, job, sources);
    if said.is_empty() {
        said = String::from_utf8_lossy(&output.stderr).trim().to_owned();
    }
    Err(Error::Models(said))
}

/// What rustc said: each thing once, ours in the author's terms.
fn errors(messages: &[Value], job: &Job, sources: &Sources) -> String {
    let all: Vec<Said<'_>> = messages.iter().filter_map(Said::of).collect();
    let mut seen = BTreeSet::new();
    let mut text = String::new();
    for said in &all {
        // What a builder trips over at the attribute, the witness copy tells at the author's line.
        let elsewhere = all.iter().any(|other| !other.at_attribute && other.title == said.title);
        // What rustc says of the original at this place says more than what a builder misses there.
        let rustcs = |other: &Said<'_>| other.help.is_none() && other.place == said.place;
        let said_better = said.help.is_some() && said.place.is_some() && all.iter().any(rustcs);
        // The witness copy also repeats what is wrong in the original.
        if said_better
            || (said.at_attribute && elsewhere)
            || !seen.insert((said.place.clone(), &said.title))
        {
            continue;
        }
        match (&said.place, said.help) {
            (Some((file, line, column)), Some(help)) => {
                let one = Diagnostic {
                    file: file.clone(),
                    line: *line,
                    column: *column,
                    message: said.title.clone(),
                    help: help.to_owned(),
                };
                text.push_str(&diagnostic::render(&[one], sources, job.colour));
            }
            _ => {
                text.push_str(&plain(said.rendered, job.colour));
                text.push('\n');
            }
        }
    }
    text
}

/// One error of rustc's.
struct Said<'a> {
    /// In the author's terms.
    title: String,
    /// What to write instead, if the terms are ours.
    help: Option<&'static str>,
    /// File, line and column.
    place: Option<(String, u32, u32)>,
    /// Whether it is told at an attribute, which stands for code that no author wrote.
    at_attribute: bool,
    /// As rustc would print it.
    rendered: &'a str,
}

impl<'a> Said<'a> {
    fn of(message: &'a Value) -> Option<Said<'a>> {
        let message = message.get("message").filter(|message| message.is_object())?;
        let title = message["message"].as_str()?;
        let mut spans = message["spans"].as_array().into_iter().flatten();
        let primary = spans.find(|span| span["is_primary"] == true);
        if message["level"] != "error" || (primary.is_none() && title.starts_with("aborting")) {
            return None;
        }
        let place = primary.map(|span| {
            let number = |key: &str| span[key].as_u64().unwrap_or_default() as u32;
            let file = span["file_name"].as_str().unwrap_or_default().to_owned();
            (file, number("line_start"), number("column_start"))
        });
        let line = primary.and_then(|span| span["text"][0]["text"].as_str());
        let at_attribute = line.is_some_and(|line| line.trim_start().starts_with("#["));
        let rendered = message["rendered"].as_str().unwrap_or(title);
        let label = primary.and_then(|span| span["label"].as_str()).unwrap_or_default();
        let (title, help) = match label.strip_suffix(" is not a crate or module") {
            Some(function) if function.starts_with("function `") => {
                let name = function.trim_start_matches("function ");
                let help = match name {
                    "`swap`" | "`replace`" | "`take`" => MEM,
                    "`max`" | "`min`" => CMP,
                    _ => "mark the function `#[function]`",
                };
                (format!("{name} is not part of the DSL"), Some(help))
            }
            _ if ["E0223", "E0599"].iter().any(|code| message["code"]["code"] == *code)
                && rendered.contains("__b_")
                && !title.contains("__") =>
            {
                (
                    "a function of an alias of small letters is not in the DSL".to_owned(),
                    Some(
                        "give the alias a name with a capital, `type Real32 = f32;`, or call the method",
                    ),
                )
            }
            _ if message["code"]["code"] == "E0223" && primary.is_some_and(is_pattern) => (
                "this is not a variant of the type before it".to_owned(),
                Some("give a constant in a pattern a name in capitals: `Preset::IDLE`"),
            ),
            _ => reworded(title),
        };
        Some(Said { title, help, place, at_attribute, rendered })
    }
}

/// For functions that may be `core::mem`'s.
const MEM: &str =
    "write `core::mem::swap(&mut a, &mut b)` whole, or mark a function of your own `#[function]`";

/// For functions that may be `core::cmp`'s.
const CMP: &str = "write `core::cmp::max(a, b)` whole, or `a.max(b)`; or mark a function of your own `#[function]`";

/// Whether an error is told at a pattern of a `match`, as far as its line shows.
fn is_pattern(span: &Value) -> bool {
    let text = &span["text"][0];
    let end = text["highlight_end"].as_u64().unwrap_or_default() as usize;
    let rest: String =
        text["text"].as_str().unwrap_or_default().chars().skip(end.saturating_sub(1)).collect();
    ["=>", "|", "if "].iter().any(|next| rest.trim_start().starts_with(next))
}

fn plain(rendered: &str, colour: bool) -> String {
    if colour {
        return rendered.to_owned();
    }
    // SGR sequences: ESC [ … m.
    let mut text = String::new();
    let mut rest = rendered;
    while let Some((before, after)) = rest.split_once('\u{1b}') {
        text.push_str(before);
        rest = after.split_once('m').map_or("", |(_, rest)| rest);
    }
    text + rest
}

/// The macros that a model may call: the builders ask rustc whether they are Rust's.
const TAKEN_MACROS: [&str; 8] = [
    "assert",
    "assert_eq",
    "assert_ne",
    "matches",
    "panic",
    "todo",
    "unimplemented",
    "unreachable",
];

/// What rustc says of the builders' own names, in the author's terms, and a remedy.
fn reworded(title: &str) -> (String, Option<&'static str>) {
    let quoted: Vec<&str> = title.split('`').skip(1).step_by(2).collect();
    let method = quoted.iter().find_map(|name| name.strip_prefix("__b_"));
    let owner = quoted.last().copied().unwrap_or_default();
    if let Some(method) = method.and_then(|name| name.strip_prefix("list_")) {
        let owner = owner.trim_start_matches("&mut ").trim_start_matches('&');
        return (
            format!("`{method}` of `{owner}` would be taken for the method of lists"),
            Some("call it by its path, `Type::method(&mut value, …)`, or give it another name"),
        );
    }
    if let Some(method) = method {
        let owner = static_matrix(owner.trim_start_matches("&mut ").trim_start_matches('&'));
        let help = if let Some(help) = instead(method, &owner) {
            help
        } else if method == "clone" {
            "derive `Copy` too: then the value copies itself"
        } else if is_known(&owner) {
            "write it out with the operations that the DSL has: see docs/language.md"
        } else {
            "mark the `impl` block that has it `#[data]` or `#[component]`"
        };
        return (format!("`{method}` of `{owner}` is not part of the DSL"), Some(help));
    }
    if title.starts_with("`core::cmp::max` and") {
        return (title.to_owned(), Some("write `a.max(b)`, of references `*a.max(b)`"));
    }
    if title.contains("`__call`") {
        return (
            format!("`{owner}` is not part of the DSL"),
            Some("mark the function `#[function]`"),
        );
    }
    if let ([name], true) = (quoted.as_slice(), title.ends_with("` is ambiguous")) {
        let help = Some("give it another name: by this one the DSL means Rust's");
        if TAKEN_MACROS.contains(name) {
            return (format!("a macro of the author's own is named as Rust's `{name}!`"), help);
        }
        if *name == "mem" {
            return ("a module of the author's own is named as Rust's `mem`".to_owned(), help);
        }
    }
    if title.ends_with("is not a type of the DSL") {
        return (
            title.to_owned(),
            Some(
                "the DSL has scalars, arrays, nalgebra's `SMatrix` and `SVector`, and types marked `#[data]` or `#[component]`",
            ),
        );
    }
    (title.to_owned(), None)
}

/// What to write in place of a method that this kind of type has in Rust.
fn instead(method: &str, owner: &str) -> Option<&'static str> {
    // A generic type is named by its parameter.
    let generic = !owner.contains(|it: char| !it.is_ascii_uppercase() && !it.is_ascii_digit());
    Some(match method {
        "min" | "max" | "clamp" if generic => {
            "compare what is generic with `<`: `if b < a { b } else { a }`"
        }
        _ if generic || !is_known(owner) => return None,
        "pseudo_inverse" => "write `bessemer::linear::svd(&a).pseudo_inverse(least)`",
        "zip_zip_map" => "write `zip_map` twice, or `from_fn(|row, column| …)`",
        "column_iter" | "row_iter" | "column_iter_mut" | "row_iter_mut" => {
            "number them and take the rest by the number: `for (i, column) in m.column_iter().enumerate() { … w[i] … }`"
        }
        "midpoint" => {
            "add in a wider type, `((i64::from(a) + i64::from(b)) / 2) as i32`, of floats `0.5 * (a + b)`"
        }
        "isqrt" => "write `f64::from(x).sqrt() as u32`: up to 32 bits it is exact",
        "saturating_pow" => "write `x.checked_pow(n).unwrap_or(u32::MAX)` of what is not negative",
        "checked_next_power_of_two" => {
            "write `1 << (u32::BITS - (x - 1).leading_zeros())`: of 0, and beyond the type, a fault"
        }
        "saturating_add_signed" | "wrapping_add_signed" | "checked_add_signed" => {
            "convert both to the wider signed type, `i64::from(x)`, and back with `try_from`"
        }
        _ => return None,
    })
}

/// Whether a type is the DSL's, nalgebra's or Rust's, whose methods no author marks.
fn is_known(ty: &str) -> bool {
    const KNOWN: [&str; 12] = [
        "SMatrix",
        "List",
        "BoundedMatrix",
        "Text",
        "Option",
        "Result",
        "Unit",
        "Quaternion",
        "Rotation",
        "Isometry",
        "Translation",
        "OPoint",
    ];
    let ty = ty.split(['<', '[']).next().unwrap_or_default();
    let name = ty.rsplit("::").next().unwrap_or_default();
    !name.contains(char::is_uppercase) || KNOWN.contains(&name)
}

/// nalgebra's own name of a static matrix, as its users write it.
fn static_matrix(ty: &str) -> String {
    let sizes = ty.strip_prefix("Matrix<").and_then(|rest| {
        let mut parts = rest.split(", ");
        let element = parts.next()?;
        let rows = parts.next()?.strip_prefix("Const<")?.strip_suffix('>')?;
        let cols = parts.next()?.strip_prefix("Const<")?.strip_suffix('>')?;
        Some(format!("SMatrix<{element}, {rows}, {cols}>"))
    });
    sizes.unwrap_or_else(|| ty.to_owned())
}
