//! Holds what calls of rewritten functions stand for, on trees as the macros build them.

use super::*;

/// `core::mem::replace`: `let kept = *place; *place = value; kept`.
fn replace() -> FunctionTree {
    let site = Site::default();
    let plain = |kind| Expr::plain(kind, site);
    let place = || plain(ExprKind::Deref(Box::new(Expr::local("place", site))));
    let value = Box::new(Expr::local("value", site));
    let kept = Stmt::Let {
        name: "kept".into(),
        slot: NO_SLOT,
        value: Some(place()),
        site,
        mutable: false,
    };
    let written = Stmt::Expr(plain(ExprKind::Assign(None, Box::new(place()), value)));
    let tail = Some(Box::new(Expr::local("kept", site)));
    let param = |name: &str| tree::Param {
        name: name.into(),
        slot: NO_SLOT,
        site,
        closure: false,
        items: false,
        mutable: false,
    };
    FunctionTree {
        derivative: None,
        name: "replace".into(),
        site,
        docs: Vec::new(),
        role: Role::Rewritten,
        attributes: Default::default(),
        params: ["place", "value"].map(param).into(),
        result: NO_SLOT,
        body: Block { stmts: vec![kept, written], tail },
        operators: Vec::new(),
    }
}

/// An argument that borrows a place, in any syntax, is an alias of it and no copy.
#[test]
fn what_a_call_refers_to_is_named() {
    let site = Site::default();
    let plain = |kind| Expr::plain(kind, site);
    let call = plain(ExprKind::Call(7, Vec::new()));
    let borrowed = plain(ExprKind::Ref(true, Box::new(call.clone())));
    let indexed = ExprKind::Index(Box::new(Expr::local("v", site)), Box::new(call.clone()));
    let element = plain(ExprKind::Ref(true, Box::new(plain(indexed))));
    for place in [call, borrowed, element] {
        let arguments = [place.clone(), Expr::local("n", site)];
        let whole = rewritten(&replace(), &arguments, &plain(ExprKind::Bool(false)));
        let ExprKind::Block(Block { stmts, .. }) = whole.kind else { panic!("{whole:?}") };
        let [Stmt::Apart { pattern, value, otherwise: None, .. }] = &stmts[..] else {
            panic!("{stmts:?}")
        };
        assert_eq!((&**pattern, value), (&Pattern::name("%place"), &place));
    }
}

/// The name of a reference, and what a reference that is written out refers to, stand where the parameter does.
#[test]
fn what_a_name_refers_to_stands_in_its_place() {
    let site = Site::default();
    let local = Expr::local("p", site);
    let borrowed = Expr::plain(ExprKind::Ref(true, Box::new(local.clone())), site);
    for place in [local, borrowed] {
        let arguments = [place, Expr::local("n", site)];
        let whole = rewritten(&replace(), &arguments, &Expr::plain(ExprKind::Bool(false), site));
        let ExprKind::Block(Block { stmts, .. }) = whole.kind else { panic!("{whole:?}") };
        assert!(stmts.iter().all(|it| !matches!(it, Stmt::Apart { .. })), "{stmts:?}");
    }
}
