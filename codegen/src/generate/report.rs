//! Report of a generation: a table of entry points, remaining checks with reasons, and external functions.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;

use bessemer_ir::{Fault, Owner, Role, Span};

use crate::compile::{self, Compiled};
use bessemer_backend::c::{EntryReport, Width};
use bessemer_backend::passes;

/// Returns the table of entry points: lines of C, bytes of state, estimated stack, remaining checks, operations in
/// double and in 64 bits. External functions follow.
pub fn table(compiled: &Compiled) -> String {
    let titles =
        ["component", "entry point", "C lines", "state", "stack", "checks", "double", "64 bits"];
    let mut rows: Vec<[String; 8]> = vec![titles.map(str::to_owned)];
    rows.extend(compiled.entries.iter().map(|entry| {
        [
            entry.component.clone(),
            entry.entry.clone(),
            entry.lines.to_string(),
            format!("{} B", entry.state_bytes),
            format!("{} B", entry.stack_bytes),
            entry.checks.to_string(),
            entry.doubles.to_string(),
            entry.longs.to_string(),
        ]
    }));
    let width = |column: usize| {
        rows.iter().map(|row| row[column].chars().count()).max().unwrap_or_default()
    };
    let widths: Vec<usize> = (0..titles.len()).map(width).collect();
    let mut text = String::new();
    for row in &rows {
        let cells: Vec<String> = row
            .iter()
            .zip(&widths)
            .enumerate()
            .map(|(column, (cell, width))| {
                // Names to the left, numbers to the right.
                if column < 2 { format!("{cell:<width$}") } else { format!("{cell:>width$}") }
            })
            .collect();
        let _ = writeln!(text, "{}", cells.join("  ").trim_end());
    }
    text.push_str(&units(compiled));
    for (kernel, library) in &compiled.replaced {
        let _ = writeln!(
            text,
            "{kernel}: {library}'s function; whether its bits are the Rust's rests on that"
        );
    }
    if !compiled.fast.is_empty() {
        text.push_str(
            "\nIn the fast mode, so that their last bits need not be the Rust's; their errors, element by element:\n",
        );
        let width = compiled.fast.iter().map(|(kernel, _)| kernel.len()).max().unwrap_or_default();
        for (kernel, bound) in &compiled.fast {
            let _ = writeln!(text, "  {kernel:<width$}  {bound}");
        }
    }
    text.push_str(&externals(compiled));
    if !compiled.library.is_empty() {
        let _ = writeln!(
            text,
            "\nThe C calls the target's math.h ({}): there its results need not be the Rust's to the bit.",
            compiled.library.join(", ")
        );
    }
    text
}

/// Returns the units at each entry point, by C names.
fn units(compiled: &Compiled) -> String {
    let mut text = String::new();
    for entry in compiled.entries.iter().filter(|entry| !entry.units.is_empty()) {
        let _ = writeln!(text, "\nUnits of {}", entry.entry);
        let width = entry.units.iter().map(|it| it.place.chars().count()).max().unwrap_or_default();
        for it in &entry.units {
            let _ = writeln!(text, "  {:<9}  {:<width$}  {}", it.port.word(), it.place, it.unit);
        }
    }
    text
}

/// Returns the external functions, for which the firmware's C must compute the bits of their Rust stand-ins.
fn externals(compiled: &Compiled) -> String {
    let functions = compiled.explicit.functions.iter();
    let lines = functions.filter_map(|function| {
        let attributes = &function.attributes;
        let (header, name) = (attributes.external.as_ref()?, attributes.name.as_ref()?);
        Some(format!("  {name} ({header}): {}\n", place(compiled, function.span)))
    });
    let lines: String = lines.collect();
    if lines.is_empty() {
        return lines;
    }
    format!(
        "\nThe same bits in Rust and C rest on stand-ins here: what the firmware brings must do what they do.\n{lines}"
    )
}

/// Lists the checks that are left in each entry point and its callees: the author's line, the fault, and the reason.
/// Lines that compute in double or in 64 bits follow.
pub fn explanation(compiled: &Compiled) -> String {
    let mut text = String::new();
    let functions = &compiled.module.functions;
    for (index, function) in functions.iter().enumerate() {
        let (Role::Entry { .. }, Some(Owner::Struct(owner))) = (function.role, function.owner)
        else {
            continue;
        };
        let component = &compiled.module.structs[owner.index()].name;
        let mut lines = String::new();
        let left = left(compiled, index);
        for Left { place, fault, reason } in &left {
            let _ = writeln!(lines, "  {place}: {fault}: {reason}");
        }
        let left = match left.len() {
            0 => "no check is left".to_owned(),
            1 => "1 check is left".to_owned(),
            more => format!("{more} checks are left"),
        };
        let wide = compiled.entries.iter().find(|it| it.function.index() == index);
        lines.extend(wide.map(|entry| wide_lines(compiled, entry)));
        let _ = writeln!(text, "{component}::{}: {left}\n{}", function.name, lines);
    }
    text
}

/// A check that is left in an entry point or its callees.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Left {
    /// Place of the operation, or of the author's call that leads there: `models/src/height.rs:12:9`.
    pub place: String,
    /// Name of the fault.
    pub fault: &'static str,
    /// Text that says why it could not be ruled out.
    pub reason: String,
}

/// Returns the checks that are left in an entry point, by its index, and in its callees.
pub fn left(compiled: &Compiled, entry: usize) -> Vec<Left> {
    let reached = passes::reached(&compiled.module, entry);
    let checks = reached.iter().flat_map(|at| compiled.checks.functions.get(*at));
    let left = |check: &passes::Remaining| {
        // Of a fault in the DSL's own code, the author's call.
        let span = compile::authors(&compiled.module, entry, check.span);
        let reason = check.reason.clone();
        Left { place: place(compiled, span), fault: word(check.fault), reason }
    };
    checks.flatten().map(left).collect()
}

/// Returns the author's lines with operations in double and in 64 bits, by file.
fn wide_lines(compiled: &Compiled, entry: &EntryReport) -> String {
    let mut text = String::new();
    for (width, what) in [(Width::Double, "in double"), (Width::Long, "in 64 bits")] {
        let mut files: BTreeMap<&str, BTreeSet<u32>> = BTreeMap::new();
        for site in entry.wide.iter().filter(|site| site.width == width) {
            let file = compiled.module.files.get(site.span.file as usize);
            files.entry(file.map_or("", String::as_str)).or_default().insert(site.span.line);
        }
        for (file, lines) in files {
            let lines: Vec<String> = lines.iter().map(u32::to_string).collect();
            let _ = writeln!(text, "  {what}: {file}:{}", lines.join(", "));
        }
    }
    text
}

/// Returns a place such as `models/src/height.rs:12:9`.
fn place(compiled: &Compiled, span: Span) -> String {
    let file = compiled.module.files.get(span.file as usize).map_or("", String::as_str);
    format!("{file}:{}:{}", span.line, span.column)
}

fn word(fault: Fault) -> &'static str {
    match fault {
        Fault::Overflow => "overflow",
        Fault::DivisionByZero => "division by zero",
        Fault::Shift => "shift",
        Fault::Index => "index",
        Fault::Clamp => "clamp",
        Fault::Variant => "variant",
        Fault::Assertion => "assertion",
        Fault::Bound => "bound",
        Fault::Absent => "absent",
        Fault::Capacity => "capacity",
        Fault::LeftOut => "left out",
    }
}
