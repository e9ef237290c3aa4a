//! The witness technique: a generation build returns the types that rustc inferred and the functions that it
//! resolved, for any names.

#![cfg(feature = "generate")]

use bessemer::generate::tree::{Callee, Expr, ExprKind, Function, Package, Role, Stmt, Ty};
use bessemer_tree::number::{Float, Int, Scalar};

#[path = "witness/parts.rs"]
mod parts;
#[path = "witness/syntax.rs"]
mod syntax;
#[path = "witness/values.rs"]
mod values;

const F64: Ty = Ty::Scalar(Scalar::Float(Float::F64));
const F32: Ty = Ty::Scalar(Scalar::Float(Float::F32));
const BOOL: Ty = Ty::Scalar(Scalar::Bool);

fn int(int: Int) -> Ty {
    Ty::Scalar(Scalar::Int(int))
}

/// Returns the registered items of this crate.
fn package() -> Package {
    let package: Package =
        serde_json::from_str(&bessemer::generate::package("witness", "witness", "MIT"))
            .expect("a package is JSON");
    assert_eq!(package.errors, []);
    package
}

/// Returns the function with the path `witness::…`.
fn function(path: &str) -> Function {
    let path = format!("witness::{path}");
    let mut functions = package().functions.into_iter();
    functions.find(|function| function.path == path).unwrap_or_else(|| panic!("no {path}"))
}

/// Returns the type of each `let` at the top of a function, in order; a closure has none.
fn lets(function: &Function) -> Vec<(String, Ty)> {
    let stmts = function.tree.body.stmts.iter();
    stmts
        .filter_map(|stmt| match stmt {
            Stmt::Let { name, slot, .. } => {
                function.slots.get(*slot as usize).map(|ty| (name.clone(), ty.clone()))
            }
            Stmt::Apart { .. } | Stmt::Expr(_) => None,
        })
        .collect()
}

/// Returns the types of the parameters, and of the result.
fn signature(function: &Function) -> (Vec<(&str, Ty)>, Ty) {
    let ty = |slot: u32| function.slots[slot as usize].clone();
    let params = function.tree.params.iter().map(|param| (param.name.as_str(), ty(param.slot)));
    (params.collect(), ty(function.tree.result))
}

fn named(path: &str) -> Ty {
    Ty::Named(format!("witness::{path}"))
}

fn shared(ty: Ty) -> Ty {
    Ty::Ref(Box::new(ty), false)
}

/// Returns the callees of a function, without this crate's name.
fn callees(function: &Function) -> Vec<String> {
    let name = |callee: &Callee| match callee {
        Callee::Function(path) => path.trim_start_matches("witness::").to_owned(),
        Callee::Builtin(builtin) => format!("{builtin:?}"),
    };
    function.callees.iter().map(name).collect()
}

/// Returns the tail of a function.
fn tail(function: &Function) -> &Expr {
    function.tree.body.tail.as_deref().expect("the function ends in a value")
}

#[test]
fn callees_come_before_callers() {
    let functions = package().functions;
    for (index, caller) in functions.iter().enumerate() {
        for callee in &caller.callees {
            let Callee::Function(path) = callee else { continue };
            let place = functions.iter().position(|function| function.path == *path);
            assert!(place.is_some_and(|place| place < index), "{path} after {}", caller.path);
        }
    }
}

#[test]
fn types_come_after_those_they_are_made_of() {
    let paths: Vec<_> = package().types.into_iter().map(|definition| definition.path).collect();
    let place =
        |name: &str| paths.iter().position(|path| path == &format!("witness::values::{name}"));
    assert!(place("Inner").is_some());
    assert!(place("Inner") < place("Outer"));
}

#[test]
fn docs_and_roles_travel() {
    let step = function("values::Outer::step");
    assert_eq!(step.tree.docs, ["One period.", "", "Twice as documented."]);
    assert_eq!(step.tree.role, Role::Entry { infallible: true });
    assert_eq!(function("values::Outer::reset").tree.role, Role::Private);
    assert_eq!(function("values::Pair::sum").tree.role, Role::Public);
}

#[test]
fn sites_are_the_authors_own() {
    let source = include_str!("witness/values.rs");
    let sum = function("values::Pair::sum");
    let line = source.lines().nth(sum.tree.site.0 as usize - 1).expect("the line is there");
    assert_eq!(&line[sum.tree.site.1 as usize - 1..][..4], "sum(");
    assert!(sum.file.ends_with("tests/witness/values.rs"));
}

#[test]
fn a_refused_node_never_travels() {
    for function in package().functions {
        assert!(
            !matches!(&function.tree.body.tail, Some(tail) if tail.kind == ExprKind::Tuple(Vec::new()))
        );
    }
}
