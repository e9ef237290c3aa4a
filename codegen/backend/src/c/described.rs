//! Additions to the author's comments: units, ranges, and the element order of matrices.

use bessemer_ir::attributes::{Beyond, Range};
use bessemer_ir::{Const, Function, Given, Module, StructId, Type};

use super::matrices::Layout;
use super::names::{Names, OVERLAY};
use super::outside::{self, Outside};
use super::signature::{Param, Returned, Signature};

/// Width of a comment line, in characters.
const WIDTH: usize = 92;

/// Returns the doc comment of a constant.
pub fn constant(names: &Names, item: &Const) -> Vec<String> {
    told(names, &item.docs, &item.given, item.given.expression.as_ref(), &item.ty)
}

/// Returns the doc comment of a field. The expression of its default is a comment of the function that sets it.
pub fn field(names: &Names, docs: &[String], given: &Given, ty: &Type) -> Vec<String> {
    told(names, docs, given, None, ty)
}

fn told(
    names: &Names,
    docs: &[String],
    given: &Given,
    expression: Option<&String>,
    ty: &Type,
) -> Vec<String> {
    let mut lines = docs.to_vec();
    if let Some(unit) = &given.unit {
        add(&mut lines, format!("Unit: {unit}."));
    }
    if let Some(expression) = expression {
        add(&mut lines, in_rust(expression));
    }
    if let Some(range) = given.range {
        add(&mut lines, format!("Range: {}.", ends(range)));
    }
    if let Some(order) = order(names.layout, ty) {
        add(&mut lines, format!("A matrix {order}."));
    }
    lines
}

/// Returns the doc comment of a function, with units and ranges of its parameters, the unit of its result, and the
/// element order of matrices.
pub fn function(
    module: &Module,
    names: &Names,
    function: &Function,
    signature: &Signature,
) -> Vec<String> {
    let mut lines = function.docs.clone();
    let attributes = &function.attributes;
    let of = |(name, given): &(String, Given)| {
        let name = given.name.as_ref().unwrap_or(name);
        Some(format!("`{name}` {}", given.unit.as_ref()?))
    };
    let mut units: Vec<String> = attributes.parameters.iter().filter_map(of).collect();
    units.extend(attributes.result.unit.iter().map(|unit| format!("the result {unit}")));
    if !units.is_empty() {
        add(&mut lines, format!("Units: {}.", units.join(", ")));
    }
    let ranges = attributes.parameters.iter().filter_map(|(name, given)| {
        let (name, range) = (given.name.as_ref().unwrap_or(name), given.range?);
        let beyond = match range.beyond() {
            Beyond::Taken => "",
            Beyond::Clamped => " (others are clamped)",
            Beyond::Reported => " (others are reported as `ASSERTION`)",
        };
        Some(format!("`{name}` {}{beyond}", ends(range)))
    });
    let ranges: Vec<String> = ranges.collect();
    if !ranges.is_empty() {
        add(&mut lines, format!("Ranges: {}.", ranges.join(", ")));
    }
    unchecked(module, names, function, signature, &mut lines);
    // Those that lie alike, together.
    let mut orders: Vec<(String, Vec<String>)> = Vec::new();
    for Param { name, ty, .. } in &signature.params {
        let Some(order) = order(names.layout, ty) else { continue };
        let name = format!("`{name}`");
        match orders.iter_mut().find(|(other, _)| *other == order) {
            Some((_, all)) => all.push(name),
            None => orders.push((order, vec![name])),
        }
    }
    let said: Vec<String> =
        orders.iter().map(|(order, all)| format!("{} {order}.", all.join(", "))).collect();
    if !said.is_empty() && !lines.is_empty() {
        lines.push(String::new());
    }
    lines.extend(said);
    lines
}

/// Adds the enums that an entry point without a status reads and cannot check, with the meaning of an invalid value.
fn unchecked(
    module: &Module,
    names: &Names,
    function: &Function,
    signature: &Signature,
    lines: &mut Vec<String>,
) {
    if signature.returned == Returned::Status {
        return;
    }
    let shown = |it: &Outside| {
        let own = &names.enums[it.id.index()].variants;
        let parameter = signature.params.get(it.parameter)?;
        let field = |&(of, at): &(StructId, usize)| {
            let name = &names.structs[of.index()].fields[at];
            format!(".{}", name.trim_start_matches(OVERLAY))
        };
        let path: String = it.path.iter().map(field).collect();
        let counts = own.get(module.enums[it.id.index()].fallback()).filter(|_| own.len() > 1)?;
        Some(format!("`{}{path}` as `{counts}`", parameter.name))
    };
    let (chosen, left): (Vec<_>, Vec<_>) = outside::read(module, function)
        .into_iter()
        .partition(|it| module.enums[it.id.index()].has_fallback());
    let chosen: Vec<String> = chosen.iter().filter_map(shown).collect();
    let left: Vec<String> = left.iter().filter_map(shown).collect();
    if chosen.is_empty() && left.is_empty() {
        return;
    }
    add(lines, "No enum is checked, since no status is returned.".to_owned());
    if !chosen.is_empty() {
        let which = chosen.join(", ");
        add(lines, format!("In each switch, a value that is no enumerator counts so: {which}."));
    }
    if !left.is_empty() {
        let taken = match &names.status.hook {
            Some(hook) => format!("In each switch, a value that is no enumerator calls `{hook}`."),
            None => "A value that is no enumerator takes the last case of each switch.".to_owned(),
        };
        add(lines, taken);
        add(lines, format!("Elsewhere it counts as the last enumerator: {}.", left.join(", ")));
    }
}

/// Returns the comment with the author's expression of a value.
pub fn in_rust(expression: &str) -> String {
    format!("In Rust: `{expression}`.")
}

/// Returns a range as text, `0 to 5`.
fn ends(range: Range) -> String {
    // Numbers that are far from 1 by their powers of ten.
    let shown = |it: f64| match it.abs() {
        size if size != 0.0 && !(1e-4..1e15).contains(&size) => format!("{it:e}"),
        _ => format!("{it}"),
    };
    format!("{} to {}", shown(range.low()), shown(range.high()))
}

/// Returns the comment on the element order of a matrix with several rows and columns.
fn order(layout: Layout, ty: &Type) -> Option<String> {
    match ty {
        Type::Matrix { rows, cols, .. } if *rows > 1 && *cols > 1 => match layout {
            Layout::Columns => Some(format!("by columns: [row + {rows} * column]")),
            Layout::Rows => Some(format!("by rows: [column + {cols} * row]")),
            // It has its two subscripts.
            Layout::Array => None,
        },
        Type::Array { element, .. } | Type::Slice(element) => {
            order(layout, element).map(|order| format!("each {order}"))
        }
        _ => None,
    }
}

/// Appends a sentence, to the last line if there is room.
fn add(lines: &mut Vec<String>, said: String) {
    let room = |last: &&mut String| {
        !last.is_empty() && last.chars().count() + said.chars().count() < WIDTH
    };
    match lines.last_mut().filter(room) {
        Some(last) => *last = format!("{last} {said}"),
        None => lines.push(said),
    }
}
