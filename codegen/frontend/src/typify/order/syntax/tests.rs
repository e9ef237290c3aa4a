//! Effects of expressions, as the syntax shows them.

use super::*;
use bessemer_ir::tree::{BinaryOp, Site};

fn plain(kind: Tree) -> Expr {
    Expr::plain(kind, Site::default())
}

fn both(op: BinaryOp, one: Expr, other: Expr) -> Expr {
    plain(Tree::Binary(op, Box::new(one), Box::new(other)))
}

fn number() -> Expr {
    plain(Tree::Int("1".into(), None))
}

fn name(name: &str) -> Expr {
    Expr::local(name, Site::default())
}

/// A sum may fault, so it is evaluated where Rust does, but it writes nothing; a call may do anything.
#[test]
fn a_call_may_do_anything() {
    let call = plain(Tree::Call(0, Vec::new()));
    let sum = |of: Expr| both(BinaryOp::Add, of, number());
    let less = |of: Expr| both(BinaryOp::Lt, of, number());
    let judged = |of: &Expr| (is_plain(of), is_quiet(of), is_pure(of));
    assert_eq!(judged(&name("a")), (true, true, true));
    assert_eq!(judged(&less(name("a"))), (false, true, true));
    assert_eq!(judged(&sum(name("a"))), (false, false, true));
    for of in [call.clone(), sum(call.clone()), less(call)] {
        assert_eq!(judged(&of), (false, false, false));
    }
}

/// `==` of two names may be an author's own.
#[test]
fn a_comparison_without_a_number_may_do_anything() {
    assert!(!is_quiet(&both(BinaryOp::Eq, name("a"), name("b"))));
}

/// An operand moves behind a later one that may write the same variable.
#[test]
fn only_what_mentions_the_same_variable_moves() {
    let call = |of: &str| plain(Tree::Call(0, vec![name(of)]));
    assert!(may_move(&call("a"), &name("a")));
    assert!(!may_move(&call("b"), &name("a")));
    assert!(!may_move(&name("a"), &name("a")));
}
