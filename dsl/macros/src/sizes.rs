//! Constants with which an author writes lengths in a type: `[u8; MAX_BYTES]`.
//!
//! Only their names are known here. A const parameter of a generic item is listed, too, and ignored later.

use syn::{Expr, GenericArgument, PathArguments, Type};

use crate::lower;

/// Returns the names of the lengths in a type, from the outside in, rows before columns; a number has an empty name.
/// Empty if there is no name.
pub fn of(ty: &Type) -> Vec<String> {
    let mut all = Vec::new();
    gather(ty, &mut all);
    if all.iter().all(String::is_empty) { Vec::new() } else { all }
}

fn gather(ty: &Type, all: &mut Vec<String>) {
    match ty {
        Type::Reference(it) => gather(&it.elem, all),
        Type::Paren(it) => gather(&it.elem, all),
        Type::Group(it) => gather(&it.elem, all),
        Type::Array(it) => {
            all.push(expression(&it.len));
            gather(&it.elem, all);
        }
        Type::Path(it) => {
            let Some(last) = it.path.segments.last() else { return };
            let PathArguments::AngleBracketed(arguments) = &last.arguments else { return };
            let mut numbers = arguments.args.iter().skip(1).map(argument);
            let mut next = || numbers.next().unwrap_or_default();
            match lower::text(&last.ident).as_str() {
                "SMatrix" => all.extend([next(), next()]),
                "SVector" => all.extend([next(), String::new()]),
                "RowSVector" => all.extend([String::new(), next()]),
                _ => {}
            }
        }
        _ => {}
    }
}

/// Returns the name of a generic argument that is a number.
fn argument(argument: &GenericArgument) -> String {
    match argument {
        GenericArgument::Type(Type::Path(it)) => last(&it.path),
        GenericArgument::Const(it) => expression(it),
        _ => String::new(),
    }
}

fn expression(expr: &Expr) -> String {
    match expr {
        Expr::Path(it) => last(&it.path),
        Expr::Group(it) => expression(&it.expr),
        Expr::Paren(it) => expression(&it.expr),
        _ => String::new(),
    }
}

fn last(path: &syn::Path) -> String {
    path.segments.last().map(|it| lower::text(&it.ident)).unwrap_or_default()
}
