//! The state of lowering one function: its locals, the meaning of names, and the enclosing constructs.
//!
//! Must not know: how anything is lowered. Each form of the tree is lowered in a file of its own, as a method of
//! [`Lowering`].

use std::collections::HashMap;
use std::rc::Rc;

use bessemer_ir::tree;
use bessemer_ir::{LocalId, Place, Span, Step, Stmt, Type};

use super::Context;
use super::borrowed::Lenders;
use super::frames::Frames;
use super::locals::Locals;
use super::scopes::Scopes;
use super::value::Value;

/// Name of temporaries if nothing else provides one.
pub(super) const UNNAMED: &str = "value";
/// Name of a function's result if the author gave it none.
pub(super) const RESULT: &str = "result";

/// A function being lowered.
pub(super) struct Lowering<'a, 'c> {
    pub cx: &'a mut Context<'c>,
    pub source: &'a tree::Function,
    pub locals: Locals,
    /// Scopes with the meaning of each name, innermost last. In a scope, later bindings shadow earlier ones.
    pub scopes: Scopes,
    /// Statements of the current block so far.
    pub out: Vec<Stmt>,
    /// First part of the names of temporaries.
    pub naming: String,
    pub result: Type,
    /// The lenders of the slices in locals.
    pub lenders: Lenders,
    /// Loops and blocks around the current code.
    pub frames: Frames,
    /// Counters of the surrounding loops over elements, outermost first.
    pub counters: Vec<LocalId>,
    /// All closures, by the index that [`Value::Closure`] holds.
    pub closures: Vec<Rc<Closure<'a>>>,
    /// Counted iterators, by the index of their closure.
    pub hands: HashMap<usize, Hand>,
    /// True for each parameter that is zero-sized.
    pub absent: Vec<bool>,
    /// Paths of the functions that are being inlined, outermost first, each with the place of the author's call.
    pub expanding: Vec<(&'a str, Span)>,
}

/// Returns the local that a place is, if its handle is at least `first`.
pub(super) fn local_since(place: &Place, first: usize) -> Option<LocalId> {
    (place.steps.is_empty() && place.root.index() >= first).then_some(place.root)
}

impl<'a> Lowering<'a, '_> {
    /// Registers a closure with the current scope, and returns it as a value.
    pub(super) fn closure_here(&mut self, text: tree::Closure) -> Value {
        let closure = self.written_here(text);
        Value::Closure(self.closure(closure))
    }

    /// Returns a closure with the current scope, without registering it.
    pub(super) fn written_here(&self, text: tree::Closure) -> Closure<'a> {
        let scope = Scope {
            names: self.scopes.clone(),
            expanding: self.expanding.clone(),
            locals: Some(self.locals.len()),
        };
        Closure {
            text,
            source: self.source,
            scope,
            outermost: None,
            borrowed: false,
            way: Way::Any,
        }
    }

    /// Returns the closure that a name denotes, even if another meaning shadows it.
    pub(super) fn closure_named(&self, name: &str) -> Option<usize> {
        self.scopes.meanings(name).find_map(|meaning| match meaning {
            Value::Closure(closure) => Some(*closure),
            _ => None,
        })
    }

    /// Returns the type at a place.
    pub(super) fn type_of(&self, root: LocalId, steps: &[Step]) -> Type {
        let root = self.locals[root.index()].ty.clone();
        steps.iter().fold(root, |ty, step| match step {
            // A part has the lenders of the whole.
            Step::From(_) => ty,
            _ => self.cx.module.step_type(&ty, step).unwrap_or(ty),
        })
    }

    /// Registers a closure and returns its index.
    pub(super) fn closure(&mut self, closure: Closure<'a>) -> usize {
        self.closures.push(Rc::new(closure));
        self.closures.len() - 1
    }
}

/// A counted iterator: explicit `next` calls and loops share its position.
#[derive(Clone)]
pub(super) struct Hand {
    /// Closure that reads the remaining items without counting them.
    pub again: usize,
    /// Name of the count in the tree; none for an author-defined iterator, which holds its own state.
    pub taken: Option<String>,
    /// Local that changes with each item: the count, or the author-defined iterator.
    pub local: LocalId,
    /// Names, in the tree, of locals that persist between items.
    pub kept: Vec<String>,
    /// Closures of the counted iterators below an adapter, with their names in the tree.
    pub within: Vec<(String, usize)>,
    /// True for an adapter with state, of which `again` is read only to copy it.
    pub stateful: bool,
    /// For an iterator whose items are also taken from the end: the local that has the end, and the closure of its
    /// reversed loop.
    pub last: Option<(LocalId, usize)>,
    /// For a loop in a loop: the iterator of the outer loop, and the counts.
    pub nested: Option<Nested>,
}

/// The counts of an adapter with a loop in its loop ([`nested`](super::nested)).
#[derive(Clone)]
pub(super) struct Nested {
    /// Name of the first iterator in the tree.
    pub items: String,
    /// Counts of the finished items and of the parts that were taken.
    pub counts: [LocalId; 2],
    /// Closure of a loop in a loop with at least as many passes as items are left; none for a copy.
    pub passes: Option<usize>,
}

/// The order in which the loop of an iterator can yield its items.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Way {
    Any,
    /// From the first to the last, since it continues from a state.
    Forward,
    /// From the last to the first: it is reversed already.
    Back,
}

/// A closure that a name denotes in the current function.
#[derive(Clone)]
pub(super) struct Closure<'a> {
    pub text: tree::Closure,
    /// Function in which its body is written.
    pub source: &'a tree::Function,
    pub scope: Scope<'a>,
    /// For the body of a loop over a generator: the loop's label, and the frame that a `break` leaves.
    pub outermost: Option<(Option<String>, usize)>,
    /// True for an iterator that the caller passes by `&mut`.
    pub borrowed: bool,
    /// The order in which its loop can yield its items.
    pub way: Way,
}

/// Meaning of the names in a closure.
#[derive(Clone)]
pub(super) struct Scope<'a> {
    pub names: Scopes,
    /// Functions that were being inlined at its definition, as in [`Lowering::expanding`].
    pub expanding: Vec<(&'a str, Span)>,
    /// Number of locals at its definition. None in a copy of a function for this closure, where its names denote
    /// parameters of the copy.
    pub locals: Option<usize>,
}
