//! Additions to the author's comments: units, and how a matrix lies in its array.

use bessemer_ir::{Function, Type};

use super::matrices::Layout;
use super::names::Names;
use super::signature::{Param, Signature};

/// Characters in a line of a comment.
const WIDTH: usize = 92;

/// The doc comment of a field or a constant.
pub fn value(names: &Names, docs: &[String], unit: Option<&str>, ty: &Type) -> Vec<String> {
    let mut lines = docs.to_vec();
    if let Some(unit) = unit {
        add(&mut lines, format!("Unit: {unit}."));
    }
    if let Some(order) = order(names.layout, ty) {
        add(&mut lines, format!("A matrix {order}."));
    }
    lines
}

/// The doc comment of a function, with the units of its parameters and of what it gives, and how its matrices lie.
pub fn function(names: &Names, function: &Function, signature: &Signature) -> Vec<String> {
    let mut lines = function.docs.clone();
    let attributes = &function.attributes;
    let of = |(name, given): &(String, bessemer_ir::Given)| {
        let name = given.name.as_ref().unwrap_or(name);
        Some(format!("`{name}` {}", given.unit.as_ref()?))
    };
    let mut units: Vec<String> = attributes.parameters.iter().filter_map(of).collect();
    units.extend(attributes.result.unit.iter().map(|unit| format!("the result {unit}")));
    if !units.is_empty() {
        add(&mut lines, format!("Units: {}.", units.join(", ")));
    }
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

/// How a matrix of several rows and columns lies in its array.
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

/// Adds a sentence, to the last line if there is room.
fn add(lines: &mut Vec<String>, said: String) {
    let room = |last: &&mut String| {
        !last.is_empty() && last.chars().count() + said.chars().count() < WIDTH
    };
    match lines.last_mut().filter(room) {
        Some(last) => *last = format!("{last} {said}"),
        None => lines.push(said),
    }
}
