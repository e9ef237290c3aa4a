//! Calls with disjoint arguments, and calls for which no proof exists.

use std::collections::BTreeSet;

use super::unproved;
use crate::c::tree::{Declarator, Expr, Head, Init, Item, Origin, StmtKind, Storage, plain};

fn param(ty: &str, name: &str, dimensions: &str) -> Declarator {
    Declarator { ty: ty.into(), name: name.into(), dimensions: dimensions.into() }
}

fn function(name: &str, params: Vec<Declarator>, body: Vec<StmtKind>) -> Item {
    let head = Head {
        contract: Vec::new(),
        asked: Vec::new(),
        storage: Storage::Static,
        result: "void".into(),
        name: name.into(),
        params,
    };
    let origin = Origin { file: 0, line: 0 };
    let body = body.into_iter().map(plain).collect();
    Item::Function { docs: Vec::new(), head, body, origin, function: String::new() }
}

fn name(text: &str) -> Expr {
    Expr::name(text)
}

fn field(of: &str, field: &str) -> Expr {
    Expr::unary("*", name(of)).field(field)
}

fn from(row: &str, index: &str) -> Expr {
    name(row).at(name(index)).address()
}

/// Returns true if `callee(from, to)` is proved, with three elements each. The caller has `self`, `other`, `work` and
/// `tail`, a name for what follows `work[6]`, and a variable `list`.
fn proved(from_it: Expr, to: Expr) -> bool {
    let callee = function(
        "callee",
        vec![param("const double", "from", "[3]"), param("double", "to", "[3]")],
        Vec::new(),
    );
    let tail =
        StmtKind::Declare(param("double *const", "tail", ""), Some(Init::Value(from("work", "6"))));
    let list = StmtKind::Declare(param("double", "list", "[6]"), None);
    let call = StmtKind::Expr(Expr::call("callee", vec![from_it, to]));
    let caller = function(
        "caller",
        vec![
            param("part_t *", "self", ""),
            param("const part_t *", "other", ""),
            param("double", "work", "[12]"),
        ],
        vec![tail, list, call],
    );
    let shared = BTreeSet::from(["first".to_owned(), "second".to_owned()]);
    unproved([&callee, &caller].into_iter(), &shared).is_empty()
}

#[test]
fn disjoint_memory_is_proved() {
    for (from_it, to) in [
        (name("list"), name("work")),
        (name("work"), from("work", "3")),
        (from("work", "3U"), name("work")),
        (name("work"), name("tail")),
        (from("tail", "3"), name("tail")),
        (from("tail", "3"), from("work", "6")),
        (field("self", "x"), field("self", "y")),
        (field("self", "x"), field("other", "x")),
        (field("self", "first"), field("self", "y")),
        (name("TABLE"), field("self", "x")),
        (from("list", "3"), name("list")),
    ] {
        assert!(proved(from_it.clone(), to.clone()), "{from_it:?} and {to:?}");
    }
}

#[test]
fn memory_that_may_be_shared_is_not() {
    for (from_it, to) in [
        (name("list"), name("list")),
        (name("work"), from("work", "2")),
        (name("work"), from("work", "n")),
        (from("work", "7"), name("tail")),
        (from("tail", "1"), from("work", "9")),
        (field("self", "x"), field("self", "x")),
        (field("self", "first"), field("self", "second")),
        (from("list", "2"), name("list")),
        (Expr::call("any", Vec::new()), name("list")),
    ] {
        assert!(!proved(from_it.clone(), to.clone()), "{from_it:?} and {to:?}");
    }
}

#[test]
fn a_caller_without_proof_lends_none_to_its_callees() {
    let two = || vec![param("const double", "from", "[3]"), param("double", "to", "[3]")];
    let call = |callee: &str, one: &str, other: &str| {
        StmtKind::Expr(Expr::call(callee, vec![name(one), name(other)]))
    };
    let list = StmtKind::Declare(param("double", "list", "[3]"), None);
    let inner = function("inner", two(), Vec::new());
    let outer = function("outer", two(), vec![call("inner", "from", "to")]);
    let nothing = BTreeSet::new();
    let kept = [&inner, &outer];
    assert!(unproved(kept.into_iter(), &nothing).is_empty());
    let broken = function("broken", Vec::new(), vec![list, call("outer", "list", "list")]);
    let all = unproved([&inner, &outer, &broken].into_iter(), &nothing);
    let pair = |name: &str| (name.to_owned(), 1, 0);
    assert_eq!(all.into_iter().collect::<Vec<_>>(), [pair("inner"), pair("outer")]);
}

#[test]
fn a_pair_without_proof_leaves_the_others() {
    let three = |last: &str| {
        vec![
            param("const double", "from", "[3]"),
            param("double", "work", "[3]"),
            param("double", last, "[3]"),
        ]
    };
    let call = |callee: &str, names: &[&str]| {
        StmtKind::Expr(Expr::call(callee, names.iter().map(|it| name(it)).collect()))
    };
    let variable = |name: &str| StmtKind::Declare(param("double", name, "[3]"), None);
    let two = vec![param("const double", "from", "[3]"), param("double", "to", "[3]")];
    let inner = function("inner", two, Vec::new());
    let outer = function("outer", three("to"), vec![call("inner", &["work", "to"])]);
    let over = call("outer", &["list", "spare", "list"]);
    let caller = function("caller", Vec::new(), vec![variable("list"), variable("spare"), over]);
    let all = unproved([&inner, &outer, &caller].into_iter(), &BTreeSet::new());
    assert_eq!(all.into_iter().collect::<Vec<_>>(), [("outer".to_owned(), 2, 0)]);
}
