//! Unit tests of the front half's own functions. Values and statements are written as text of the IR, and what such a
//! function says of them is compared with what the interpreter computes.

mod lengths;
mod literals;
mod names;
mod order;
mod patterns;
mod statements;

use bessemer_backend::validate::validate;
use bessemer_interpret::{Stop, call};
use bessemer_ir::text::{parse, print};
use bessemer_ir::{Expr, FunctionId, Module, Stmt, StmtKind};

/// Returns a module with one function, called last.
fn module(text: &str) -> Module {
    let module = parse(&format!("module demo\n\n{text}\n"));
    let module = module.unwrap_or_else(|error| panic!("{error}\n{text}"));
    assert_eq!(validate(&module), Ok(()), "{text}");
    module
}

/// Returns what the last function of a module computes: the words of its result.
fn called(module: &Module, arguments: &[&[u64]]) -> Result<Vec<u64>, Stop> {
    let mut arguments: Vec<Vec<u64>> = arguments.iter().map(|words| words.to_vec()).collect();
    let last = FunctionId(module.functions.len() as u32 - 1);
    call(module, last, &mut arguments)
}

/// Returns the values of a text, separated by `;`, of two lengths `n` and `m`; and a module for them.
fn values(text: &str) -> (Module, Vec<Expr>) {
    let kept: Vec<String> = text.split(';').map(|it| format!("  let x: usize ={it};")).collect();
    let kept = kept.join("\n");
    let module = module(&format!(
        "fn f in demo(n: usize, m: usize) -> usize as x {{\n{kept}\n  return n;\n}}"
    ));
    let value = |stmt: &Stmt| match &stmt.kind {
        StmtKind::Let { value, .. } => value.clone(),
        _ => None,
    };
    let values = module.functions[0].body.0.iter().filter_map(value).collect();
    (module, values)
}

/// Returns a value as text, and what it is for some lengths.
fn shown(module: &Module, value: &Expr) -> (String, Vec<Option<u64>>) {
    let mut module = module.clone();
    let body = &mut module.functions[0].body.0;
    let span = value.span;
    *body = vec![Stmt::new(StmtKind::Return(Some(value.clone())), span)];
    module.functions[0].locals.truncate(2);
    let text = print(&module);
    let (_, text) = text.split_once("return ").unwrap_or_default();
    let text = text.split(';').next().unwrap_or_default().to_owned();
    let computed = |(n, m)| called(&module, &[&[n], &[m]]).ok().map(|words| words[0]);
    (text, PAIRS.map(computed).to_vec())
}

/// Lengths for which values are computed.
const PAIRS: [(u64, u64); 8] = [(0, 0), (0, 3), (1, 1), (2, 3), (3, 2), (4, 4), (7, 2), (9, 0)];
