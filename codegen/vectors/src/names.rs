//! Names of types, functions and constants in the emitted Rust.

use std::collections::BTreeMap;

use bessemer_ir::{ConstId, EnumId, Function, FunctionId, LocalId, Module, Owner, StructId};

/// Names of a module's items; each name is there once.
pub(crate) struct Names {
    structs: Vec<String>,
    functions: Vec<String>,
    consts: Vec<String>,
}

impl Names {
    pub fn new(module: &Module) -> Names {
        let owner = |function: &Function| match function.owner {
            Some(Owner::Struct(id)) => snake(&module.structs[id.index()].name) + "_",
            Some(Owner::Enum(EnumId(id))) => snake(&module.enums[id as usize].name) + "_",
            None => String::new(),
        };
        let functions = module.functions.iter().map(|it| owner(it) + &plain(&it.name));
        Names {
            structs: unique(module.structs.iter().map(|it| plain(&it.name))),
            functions: unique(functions),
            consts: unique(module.consts.iter().map(|it| plain(&it.name).to_uppercase())),
        }
    }

    pub fn of_struct(&self, id: StructId) -> &str {
        &self.structs[id.index()]
    }

    pub fn of_function(&self, id: FunctionId) -> &str {
        &self.functions[id.index()]
    }

    pub fn of_const(&self, id: ConstId) -> &str {
        &self.consts[id.index()]
    }
}

/// Returns the name of a local: the author's, and a number where several have it.
pub(crate) fn local(function: &Function, id: LocalId) -> String {
    let name = variable(&function.local(id).name);
    let same = |it: &&bessemer_ir::Local| variable(&it.name) == name;
    let before = function.locals[..id.index()].iter().filter(same).count();
    if before == 0 { name } else { format!("{name}_{before}") }
}

/// Returns the name of a local, which is no variable of the emitted code's own.
fn variable(name: &str) -> String {
    let name = word(name);
    let own = ["m", "is", "other", "of", "first", "last", "live", "result", "it", "value"];
    let numbered = ["run", "go", "part"].iter().any(|own| {
        let number = name.strip_prefix(own);
        number.is_some_and(|it| !it.is_empty() && it.chars().all(|c| c.is_ascii_digit()))
    });
    if numbered || own.contains(&name.as_str()) { name + "_" } else { name }
}

/// Returns the name of a field, which is no keyword.
pub(crate) fn word(name: &str) -> String {
    let name = plain(name);
    match name.as_str() {
        "self" => "this".to_owned(),
        "as" | "break" | "const" | "continue" | "else" | "enum" | "false" | "fn" | "for" | "if"
        | "impl" | "in" | "let" | "loop" | "match" | "mod" | "move" | "mut" | "pub" | "ref"
        | "return" | "static" | "struct" | "super" | "trait" | "true" | "type" | "unsafe"
        | "use" | "where" | "while" | "async" | "await" | "dyn" | "gen" | "try" => name + "_",
        _ => name,
    }
}

/// Returns the letters, digits and underscores of a name.
fn plain(name: &str) -> String {
    let name = name.rsplit('.').next().unwrap_or(name);
    let kept = |c: char| if c.is_ascii_alphanumeric() { c } else { '_' };
    let name: String = name.chars().filter(|c| *c != '%').map(kept).collect();
    if name.starts_with(|c: char| c.is_ascii_digit()) { format!("n{name}") } else { name }
}

fn snake(name: &str) -> String {
    let mut out = String::new();
    for c in plain(name).chars() {
        if c.is_ascii_uppercase() && !out.is_empty() {
            out.push('_');
        }
        out.push(c.to_ascii_lowercase());
    }
    out
}

/// Numbers names that are there several times.
fn unique(names: impl Iterator<Item = String>) -> Vec<String> {
    let mut seen = BTreeMap::<String, u32>::new();
    let mut number = |name: String| {
        let count = seen.entry(name.clone()).or_default();
        *count += 1;
        if *count == 1 { name } else { format!("{name}_{count}") }
    };
    names.map(&mut number).collect()
}
