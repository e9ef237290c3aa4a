//! Names for values that the author left unnamed, and for constants that a path denotes.

use bessemer_ir::tree::number;
use bessemer_ir::{Type, tree};

use super::context::Context;
use super::words;

/// Returns the words of a type of Rust as part of a name: `f64_3` for `[f64; 3]`.
pub(super) fn joined(ty: &str) -> String {
    let words: Vec<&str> =
        ty.split(|it: char| !it.is_alphanumeric()).filter(|it| !it.is_empty()).collect();
    snake(&words.join("_"))
}

/// Converts `RateMatrix` to `rate_matrix`.
pub(super) fn snake(name: &str) -> String {
    let mut snake = String::new();
    let mut previous_lower = false;
    for c in name.chars() {
        if c.is_uppercase() && previous_lower {
            snake.push('_');
        }
        previous_lower = c.is_lowercase() || c.is_ascii_digit();
        snake.extend(c.to_lowercase());
    }
    snake
}

/// Returns a name for a value of a type: the type's name in snake case. An instance is named after its generic type.
pub(super) fn role(name: &str) -> String {
    let snake = snake(name);
    let bare = snake.strip_suffix("_f64").or_else(|| snake.strip_suffix("_f32"));
    bare.unwrap_or(&snake).to_owned()
}

/// Returns the name of the result: the author's if the body ends in a local, else the name of its type.
pub(super) fn result(cx: &Context<'_>, tree: &tree::FunctionTree, result: &Type) -> String {
    if let Some(name) = &tree.attributes.result.name {
        return name.clone();
    }
    if let Some(tree::ExprKind::Local(name)) = tree.body.tail.as_ref().map(|tail| &tail.kind)
        && name != "self"
        && tree.params.iter().all(|param| param.name != *name)
    {
        return name.clone();
    }
    match result {
        Type::Struct(id) if cx.known(result).shown.is_none() => {
            role(&cx.module.structs[id.index()].name)
        }
        Type::Enum(id) if !cx.is_name(result) => snake(&cx.module.enums[id.index()].name),
        _ => "result".into(),
    }
}

/// Returns module and name of a constant that a function of `module` (in an `impl` of `owner`) reads by `path`.
/// Examples: `left::LIMIT` is `LIMIT` of `left`, `Gains::LIMIT` is `GAINS_LIMIT`, `i8::MAX` is `I8_MAX`.
pub(super) fn constant(module: &str, owner: Option<&str>, path: &str) -> (String, String) {
    let mut segments: Vec<&str> = path.split("::").collect();
    segments.retain(|segment| !matches!(*segment, "crate" | "self" | "super" | "core"));
    let name = segments.pop().unwrap_or_default().to_owned();
    let root = module.split("::").next().unwrap_or_default();
    let Some(qualifier) = segments.last() else { return (module.to_owned(), name) };
    let ty = match *qualifier {
        "Self" => owner,
        word if number::is_number(word) => Some(word),
        word => word.starts_with(char::is_uppercase).then_some(word),
    };
    match ty {
        Some(ty) => (module.to_owned(), format!("{}_{name}", snake(ty).to_uppercase())),
        None => (format!("{root}::{}", segments.join("::")), name),
    }
}

/// Splits a path into module and name.
pub(super) fn split(path: &str) -> (&str, &str) {
    path.rsplit_once("::").unwrap_or(("", path))
}

/// Returns the name of a tuple with this number of parts.
pub(super) fn arity(count: usize) -> String {
    match count.checked_sub(1).and_then(|at| words::TUPLES.get(at)) {
        Some(name) => (*name).to_owned(),
        None => format!("tuple{count}"),
    }
}

/// Returns the C name of part `index` of a tuple of `count`.
pub(super) fn part(index: usize, count: usize) -> String {
    match (words::PARTS.get(index), count) {
        (_, 1) => words::VALUE.to_owned(),
        (Some(name), _) => (*name).to_owned(),
        (None, _) => format!("part_{}", index + 1),
    }
}
