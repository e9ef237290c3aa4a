//! Content of a dossier: everything that its pages show, as data.
//!
//! Invariants: it depends only on sources and results; a thing that was not done is there with the reason. Must not
//! know: how it is shown.

use bessemer_backend::c::interface::{Interface, Value};
use bessemer_backend::c::names::Passing;
use bessemer_codegen::compile::Compiled;
use bessemer_codegen::estimate::{self, Estimate};
use bessemer_codegen::generate;
use serde::Serialize;
use std::collections::BTreeMap;

use crate::calls::Calls;
use crate::change::Change;
use crate::coverage::Report;
use crate::evidence::Evidence;
use crate::graph;
use crate::requirements::Matrix;
use crate::trace::Folder;

/// Everything that the pages show.
#[derive(Clone, Debug, Default, Serialize)]
pub struct Content {
    /// Name of the package.
    pub package: String,
    /// Version of the tool.
    pub tool: String,
    /// Version of rustc.
    pub rustc: String,
    /// Licence of the C.
    pub license: String,
    /// Results of checks.
    pub results: Vec<Outcome>,
    /// Components.
    pub components: Vec<Component>,
    /// Structs that are no component.
    pub structs: Vec<Component>,
    /// Enums.
    pub enums: Vec<Enum>,
    /// Functions of the C.
    pub functions: Vec<Function>,
    /// Loops with their numbers of passes.
    pub loops: Vec<Loop>,
    /// Weights of the model of the estimates.
    pub weights: Vec<[String; 4]>,
    /// Sizes by target.
    pub sizes: Vec<Sizes>,
    /// Longest paths by target.
    pub paths: Vec<Paths>,
    /// Contracts that were proved, by function.
    pub proved: Vec<Proved>,
    /// Requirements.
    pub matrix: Matrix,
    /// Coverage of the C; none if it was not measured.
    pub coverage: Option<Report>,
    /// Changes since a version; none if none was named.
    pub change: Option<Change>,
    /// Evidence of the tool.
    pub evidence: Evidence,
    /// Numbers of statements with a counterpart, and of all.
    pub traced: (usize, usize),
}

/// Result of a check.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Outcome {
    /// Subject of the check.
    pub what: String,
    /// Command that repeats it.
    pub command: String,
    /// Versions of the programs that it used.
    pub version: String,
    /// `passed`, `failed` or `not run`.
    pub verdict: &'static str,
    /// Figures or the reason.
    pub detail: String,
}

/// A struct: the state of a component, or data.
#[derive(Clone, Debug, Serialize)]
pub struct Component {
    /// Name in the C.
    pub name: String,
    /// Name in the Rust.
    pub rust: String,
    /// The author's comment.
    pub docs: String,
    /// Header.
    pub header: String,
    /// Bytes, with enums as `int`.
    pub bytes: u64,
    /// Fields.
    pub fields: Vec<Field>,
    /// Entry points.
    pub entries: Vec<Entry>,
}

/// A field or a parameter.
#[derive(Clone, Debug, Serialize)]
pub struct Field {
    /// Its name.
    pub name: String,
    /// Type with dimensions.
    pub ty: String,
    /// Unit, or nothing.
    pub unit: String,
    /// Range, or nothing.
    pub range: String,
    /// Offset, or how it is passed.
    pub place: String,
    /// The author's comment.
    pub docs: String,
}

/// An enum.
#[derive(Clone, Debug, Serialize)]
pub struct Enum {
    /// Name in the C.
    pub name: String,
    /// The author's comment.
    pub docs: String,
    /// Names, values and comments.
    pub variants: Vec<[String; 3]>,
}

/// An entry point.
#[derive(Clone, Debug, Serialize)]
pub struct Entry {
    /// Name in the C.
    pub name: String,
    /// Name in the Rust.
    pub rust: String,
    /// The author's comment.
    pub docs: String,
    /// Parameters and the result.
    pub parameters: Vec<Field>,
    /// Bytes of stack.
    pub stack: u64,
    /// Bytes of state.
    pub state: u64,
    /// Operations in double and in 64 bits.
    pub wide: (usize, usize),
    /// Estimate of instructions, or the reason for none.
    pub instructions: String,
    /// Bounds of cycles on each processor.
    pub cycles: Vec<[String; 2]>,
    /// Faults that are left: place, fault, reason.
    pub left: Vec<[String; 3]>,
    /// Number of functions that it reaches.
    pub reached: usize,
    /// Picture of the calls below it as SVG; none if it calls nothing.
    pub graph: Option<String>,
}

/// A function of the C.
#[derive(Clone, Debug, Serialize)]
pub struct Function {
    /// Name in the C.
    pub name: String,
    /// Place in the C.
    pub place: String,
    /// Place in the Rust.
    pub rust: String,
    /// Statements.
    pub statements: usize,
    /// Decisions.
    pub decisions: usize,
    /// Conditions.
    pub conditions: usize,
    /// Bytes of its own variables, if it is known.
    pub frame: Option<u64>,
    /// Bytes of stack with its callees.
    pub stack: Option<u64>,
    /// Share of the largest stack, in percent.
    pub share: u64,
    /// Estimate of instructions, or a dash.
    pub instructions: String,
    /// Functions that it calls.
    pub calls: Vec<String>,
}

/// A loop.
#[derive(Clone, Debug, Serialize)]
pub struct Loop {
    /// Place in the Rust.
    pub place: String,
    /// Largest number of passes, or a dash.
    pub passes: String,
    /// Source of the number.
    pub source: &'static str,
}

/// Longest paths on one target.
#[derive(Clone, Debug, Serialize)]
pub struct Paths {
    /// Name of the target with its compiler.
    pub target: String,
    /// Rows of eight cells.
    ///
    /// They are entry point, instructions and cycles or the reason for none, the most instructions that a call took, and the
    /// ratio of the path to it; then instructions, the most and the ratio with normal numbers.
    pub rows: Vec<[String; 8]>,
    /// True if subnormal numbers take longer.
    pub has_normal: bool,
}

/// Returns the longest paths as CSV.
pub fn paths_csv(all: &[Paths]) -> String {
    const HEAD: [&str; 9] = [
        "target",
        "entry",
        "instructions",
        "cycles",
        "counted",
        "ratio",
        "normal_instructions",
        "normal_counted",
        "normal_ratio",
    ];
    let mut writer = csv::Writer::from_writer(Vec::new());
    // A record in memory has no error.
    let _ = writer.write_record(HEAD);
    for paths in all {
        for row in &paths.rows {
            let cells = row.iter().map(|it| it.replace(SEPARATOR, ""));
            let _ = writer.write_record(std::iter::once(paths.target.clone()).chain(cells));
        }
    }
    writer.into_inner().map(|it| String::from_utf8_lossy(&it).into_owned()).unwrap_or_default()
}

/// Goals of a function's contract.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Proved {
    /// The C name.
    pub function: String,
    /// Number of proved goals.
    pub proved: u64,
    /// Number of all goals.
    pub goals: u64,
}

/// Sizes on one target.
#[derive(Clone, Debug, Serialize)]
pub struct Sizes {
    /// Name of the target with its compiler.
    pub target: String,
    /// Entry point, bytes of code, of data and of memory.
    pub rows: Vec<[String; 4]>,
}

/// Reason for a bound that is missing.
const UNBOUNDED: &str = "no bound";

fn joined(docs: &[String]) -> String {
    docs.join(" ").trim().to_owned()
}

fn field(name: &str, value: &Value, place: String, docs: &[String]) -> Field {
    let dimensions: String = value
        .dimensions
        .iter()
        .map(|it| it.map_or("[]".to_owned(), |count| format!("[{count}]")))
        .collect();
    let matrix = value.matrix.map(|(rows, columns)| format!(" ({rows} × {columns})"));
    let range = value.range.map(|range| format!("{} … {}", range.low(), range.high()));
    Field {
        name: name.to_owned(),
        ty: format!("{}{dimensions}{}", value.ty, matrix.unwrap_or_default()),
        unit: value.unit.clone().unwrap_or_default(),
        range: range.unwrap_or_default(),
        place,
        docs: joined(docs),
    }
}

/// Between thousands.
const SEPARATOR: char = '\u{202f}';

/// Groups digits of a number by thin spaces.
pub fn grouped(number: u64) -> String {
    let digits = number.to_string();
    let first = digits.len() % 3;
    let mut text = digits[..first].to_owned();
    for (at, digit) in digits[first..].chars().enumerate() {
        if at % 3 == 0 && !text.is_empty() {
            text.push(SEPARATOR);
        }
        text.push(digit);
    }
    text
}

/// Returns components, structs and enums of an interface.
pub fn types(
    compiled: &Compiled,
    folder: &Folder,
    calls: &Calls,
    estimates: &[Estimate],
) -> (Vec<Component>, Vec<Component>, Vec<Enum>) {
    let face = &compiled.interface;
    let places: Vec<(&str, String)> = folder
        .files
        .iter()
        .flat_map(|file| {
            let place = |line| format!("{}:{line}", file.name);
            file.functions.iter().map(move |it| (&*it.name, place(it.line)))
        })
        .collect();
    let places = places.iter().map(|(name, place)| (*name, &**place)).collect();
    let structure = |it: &bessemer_backend::c::interface::Struct| Component {
        name: it.name.clone(),
        rust: it.rust.clone(),
        docs: joined(&it.docs),
        header: it.header.clone(),
        bytes: it.size.int_enums,
        fields: it
            .fields
            .iter()
            .map(|it| field(&it.name, &it.value, it.offset.int_enums.to_string(), &it.docs))
            .collect(),
        entries: entries(compiled, &it.name, calls, &places, estimates),
    };
    let (components, structs): (Vec<_>, Vec<_>) = face
        .structs
        .iter()
        .partition(|it| compiled.entries.iter().any(|entry| entry.state == it.name));
    let enums = face.enums.iter().map(|it| Enum {
        name: it.name.clone(),
        docs: joined(&it.docs),
        variants: it
            .variants
            .iter()
            .map(|(name, value, docs)| [name.clone(), value.to_string(), joined(docs)])
            .collect(),
    });
    (
        components.into_iter().map(structure).collect(),
        structs.into_iter().map(structure).collect(),
        enums.collect(),
    )
}

fn entries(
    compiled: &Compiled,
    state: &str,
    calls: &Calls,
    places: &BTreeMap<&str, &str>,
    estimates: &[Estimate],
) -> Vec<Entry> {
    let reports = compiled.entries.iter().filter(|it| it.state == state);
    let entry = |report: &bessemer_backend::c::EntryReport| {
        let face = compiled.interface.entries.iter().find(|it| it.name == report.entry);
        let index = report.function.index();
        let left = generate::left(compiled, index);
        let cost = estimates.get(index).and_then(|it| it.cost);
        let cycles = cost.iter().flat_map(|cost| {
            let pairs = estimate::PROCESSORS.iter().zip(cost.cycles);
            pairs.map(|(name, cycles)| [(*name).to_owned(), grouped(cycles)])
        });
        Entry {
            name: report.entry.clone(),
            rust: face.map(|it| it.rust.clone()).unwrap_or_default(),
            docs: face.map(|it| joined(&it.docs)).unwrap_or_default(),
            parameters: face.map(|it| parameters(&compiled.interface, it)).unwrap_or_default(),
            stack: report.stack_bytes,
            state: report.state_bytes,
            wide: (report.doubles, report.longs),
            instructions: cost.map_or(UNBOUNDED.to_owned(), |it| grouped(it.instructions)),
            cycles: cycles.collect(),
            left: left.into_iter().map(|it| [it.place, it.fault.to_owned(), it.reason]).collect(),
            reached: calls.reached(&report.entry).len(),
            graph: graph::picture(calls, &report.entry, places),
        }
    };
    reports.map(entry).collect()
}

fn parameters(_: &Interface, entry: &bessemer_backend::c::interface::Entry) -> Vec<Field> {
    let passing = |it: Passing| match it {
        Passing::Value => "value",
        Passing::Input => "in",
        Passing::InOut => "in-out",
        Passing::Output => "out",
    };
    let parameters = entry.parameters.iter();
    let mut fields: Vec<Field> = parameters
        .map(|it| field(&it.name, &it.value, passing(it.passing).to_owned(), &[]))
        .collect();
    if let Some(result) = &entry.result {
        fields.push(field("(result)", result, "returned".to_owned(), &[]));
    }
    fields
}

/// Returns the functions of the C, with their figures.
pub fn functions(
    compiled: &Compiled,
    folder: &Folder,
    calls: &Calls,
    estimates: &[Estimate],
) -> Vec<Function> {
    let largest = compiled.functions.iter().map(|it| it.stack_bytes).max().unwrap_or(1).max(1);
    let mut list = Vec::new();
    for file in &folder.files {
        for function in &file.functions {
            let own = compiled.functions.iter().position(|it| it.name == function.name);
            let report = own.map(|at| &compiled.functions[at]);
            let bound =
                report.and_then(|it| estimates.get(it.function.index())).and_then(|it| it.cost);
            let row = file.counterpart(function.line).map(|(_, _, row)| row);
            let called = calls.0.get(&function.name);
            list.push(Function {
                name: function.name.clone(),
                place: format!("{}:{}", file.name, function.line),
                rust: row
                    .map(|it| format!("{}:{}", it.rust_file, it.rust_line))
                    .unwrap_or_default(),
                statements: function.statements.len(),
                decisions: function.decisions.len(),
                conditions: function.decisions.iter().map(|it| it.conditions.len()).sum(),
                frame: report.map(|it| it.frame_bytes),
                stack: report.map(|it| it.stack_bytes),
                share: report.map_or(0, |it| it.stack_bytes * 100 / largest),
                instructions: bound.map_or("–".to_owned(), |it| grouped(it.instructions)),
                calls: called.into_iter().flatten().cloned().collect(),
            });
        }
    }
    list
}

/// Returns the loops of all functions.
pub fn loops(compiled: &Compiled, estimates: &[Estimate]) -> Vec<Loop> {
    let file = |it: u32| compiled.explicit.files.get(it as usize).cloned().unwrap_or_default();
    let mut list: Vec<Loop> = estimates
        .iter()
        .flat_map(|bound| &bound.loops)
        .map(|it| Loop {
            place: format!("{}:{}", file(it.span.file), it.span.line),
            passes: it.passes.map_or("–".to_owned(), grouped),
            source: it.source.word(),
        })
        .collect();
    list.sort_by(|one, other| {
        (one.passes != "–", &one.place, &one.passes).cmp(&(
            other.passes != "–",
            &other.place,
            &other.passes,
        ))
    });
    list.dedup_by(|one, other| (&one.place, &one.passes) == (&other.place, &other.passes));
    list
}
