//! Checks each `#[axes]`: the table is an array of numbers, and each axis a field beside it with as many points.
//!
//! Invariant: no computation depends on axes.

use bessemer_ir::tables::{lengths, points};
use bessemer_ir::{Field, Module, Struct};

use crate::diagnostic::Diagnostic;

/// Returns an error for each table whose axes do not fit.
pub(crate) fn wrong(module: &Module) -> Vec<Diagnostic> {
    let mut found: Vec<Diagnostic> = Vec::new();
    for item in &module.structs {
        for field in item.fields.iter().filter(|it| !it.given.axes.is_empty()) {
            let Some((message, help)) = unfit(module, item, field) else { continue };
            let file = module.files.get(item.span.file as usize).cloned().unwrap_or_default();
            let (line, column) = (field.given.site.0, field.given.site.1);
            // Instances of a generic struct share the attribute.
            let at = |it: &Diagnostic| (&it.file, it.line, it.column) == (&file, line, column);
            if !found.iter().any(at) {
                let help = help.to_owned();
                found.push(Diagnostic {
                    file,
                    line,
                    column,
                    message,
                    help,
                    ..Diagnostic::default()
                });
            }
        }
    }
    found
}

/// Returns the reason why the axes of a table do not fit, and the remedy.
fn unfit(module: &Module, item: &Struct, field: &Field) -> Option<(String, &'static str)> {
    let (name, axes) = (&field.name, &field.given.axes);
    let lengths = lengths(&field.ty).unwrap_or_default();
    if lengths.len() != axes.len() {
        let indices = if axes.len() == 1 { "one index" } else { "two indices" };
        return Some((
            format!("`{name}` is not an array of numbers with {indices}, one for each axis"),
            "declare `[f32; 8]` for a table with one axis, `[[f32; 4]; 8]` for one with two",
        ));
    }
    axes.iter().zip(lengths).find_map(|(axis, length)| {
        let beside = item.fields.iter().find(|it| it.name == *axis && it.name != *name);
        let points = beside.and_then(|it| points(module, &it.ty));
        points.is_none_or(|it| it.count != length).then(|| {
            (
                format!("`{axis}` is not a field beside `{name}` with {length} points"),
                "declare the points in the same struct, as an array, `pub loads: [f32; 4]`, or as an `Axis<f32, 4>`",
            )
        })
    })
}
