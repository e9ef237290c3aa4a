//! Handles locals that the C does not read, because types decide a comparison or only a removed check needed them.
//!
//! `(void)name;` follows the declaration of such a local, or its last store if it is declared without a value. A local that only copies a place which is read elsewhere,
//! or a list of literals, is removed. Any other value remains, since it may contain a call.

use crate::c::mentions::{names, reads};
use crate::c::tree::{Expr, Init, Stmt, StmtKind, plain};

/// Inserts `(void)name;` after the declarations of these names, and removes copies that nothing reads.
pub(super) fn quiet(body: &mut Vec<Stmt>, names: &[String]) {
    if !names.is_empty() {
        say(body, names);
    }
    while drop_copy(body, &body.clone()) {}
}

fn say(body: &mut Vec<Stmt>, unread: &[String]) {
    let mut index = 0;
    while index < body.len() {
        if let StmtKind::Declare(declarator, init) = &body[index].kind
            && unread.contains(&declarator.name)
        {
            // Before its stores a variable has no value that may be read.
            let stored = |at: &usize| names(&body[*at..=*at], &declarator.name);
            let after = match init {
                Some(_) => index,
                None => (index + 1..body.len()).rev().find(stored).unwrap_or(index),
            };
            let name = Expr::name(&declarator.name);
            body.insert(after + 1, plain(StmtKind::Expr(Expr::cast("void", name))));
        }
        body[index].kind.blocks_mut().into_iter().for_each(|block| say(block, unread));
        index += 1;
    }
}

/// Removes the declaration and the `(void)` of one copy that its block does not read and whose place `body` reads
/// elsewhere. Returns true if there was one.
fn drop_copy(block: &mut Vec<Stmt>, body: &[Stmt]) -> bool {
    let unread = |at: &usize| {
        let [Stmt { kind: StmtKind::Declare(declarator, Some(init)), .. }, next, rest @ ..] =
            &block[*at..]
        else {
            return false;
        };
        let said = StmtKind::Expr(Expr::cast("void", Expr::name(&declarator.name)));
        // Names of other blocks count as one: of a name that two have, nothing is known.
        let elsewhere = |place| reads(body, place) > 1 && declarations(body, place) <= 1;
        let needless = || match init {
            Init::Value(value) => root(value).is_some_and(elsewhere),
            list => is_constant(list),
        };
        // The last looks through the whole function.
        next.kind == said && !names(rest, &declarator.name) && needless()
    };
    if let Some(at) = (0..block.len()).find(unread) {
        block.drain(at..at + 2);
        return true;
    }
    block.iter_mut().flat_map(|stmt| stmt.kind.blocks_mut()).any(|block| drop_copy(block, body))
}

/// Returns the variable of which an expression is a part, without index or pointer arithmetic.
fn root(place: &Expr) -> Option<&str> {
    match place {
        Expr::Name(name) => Some(name),
        Expr::Member(of, _) | Expr::Arrow(of, _) => root(of),
        _ => None,
    }
}

/// Returns true if an initialiser contains only literals.
fn is_constant(init: &Init) -> bool {
    match init {
        Init::List { items, .. } => items.iter().all(|(_, item)| is_constant(item)),
        Init::Value(Expr::Name(text)) => {
            text.starts_with(|first: char| first.is_ascii_digit())
                || text == "true"
                || text == "false"
        }
        Init::Value(_) => false,
    }
}

/// Returns the number of variables of this name.
fn declarations(body: &[Stmt], name: &str) -> usize {
    let count = |stmt: &Stmt| {
        let own = match &stmt.kind {
            StmtKind::Declare(declarator, _) => declarator.name == name,
            StmtKind::For { init: (declarator, _), .. } => declarator.name == name,
            _ => false,
        };
        let inner = stmt.kind.blocks().into_iter().map(|block| declarations(block, name));
        usize::from(own) + inner.sum::<usize>()
    };
    body.iter().map(count).sum()
}
