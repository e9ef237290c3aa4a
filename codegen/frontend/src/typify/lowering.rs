//! The state of lowering one function: its locals, the meaning of names, and the enclosing constructs.
//!
//! Must not know: how anything is lowered. Each form of the tree is lowered in a file of its own, as a method of
//! [`Lowering`].

use std::collections::{HashMap, HashSet};
use std::rc::Rc;

use bessemer_ir::tree;
use bessemer_ir::{Local, LocalId, Place, Stmt, Type};

use super::Context;
use super::borrowed::Lenders;
use super::value::Value;

/// The owner of temporaries where nothing has a name.
pub(super) const UNNAMED: &str = "value";
/// The name of what a function gives, where its author named nothing.
pub(super) const RESULT: &str = "result";

/// A function being lowered.
pub(super) struct Lowering<'a, 'c> {
    pub cx: &'a mut Context<'c>,
    pub source: &'a tree::Function,
    pub locals: Vec<Local>,
    /// Innermost scope last; in each, later bindings shadow.
    pub scopes: Vec<Vec<(String, Value)>>,
    /// The statements of the block being lowered, so far.
    pub out: Vec<Stmt>,
    /// A name for a value that the author left unnamed here.
    pub naming: String,
    pub result: Type,
    /// The locals that the author has no name for: nothing writes to them again.
    pub held: HashSet<LocalId>,
    /// Locals among them that [`fuse`](crate::fuse) may put back.
    pub atoms: HashSet<LocalId>,
    /// The counters of loops over ranges, which only their loop changes, and parameters that nobody does.
    pub steady: HashSet<LocalId>,
    /// The locals that their author may write again, and their types as rustc sees them.
    pub changing: HashMap<LocalId, tree::Ty>,
    /// Locals that not every use asks: where a slice begins, how many elements it has, and what the guard of an arm names.
    pub unasked: Vec<LocalId>,
    /// Locals that have to have a value where they are declared.
    pub valued: HashSet<LocalId>,
    /// The arrays whose elements the slices in its locals are.
    pub lenders: Lenders,
    /// The loops around what is being lowered, outermost first.
    pub frames: Vec<Frame>,
    /// The counters of the loops over elements around it, outermost first.
    pub counters: Vec<LocalId>,
    /// The closures that names mean.
    pub closures: Vec<Rc<Closure<'a>>>,
    /// Those of them that are iterators gone through by hand.
    pub hands: HashMap<usize, Hand>,
    /// Which of its parameters hold nothing.
    pub absent: Vec<bool>,
    /// The functions that lend whose bodies are being lowered, outermost first.
    pub expanding: Vec<&'a str>,
}

/// What a name means in scopes, the innermost last.
pub(super) fn meaning_in<'s>(scopes: &'s [Vec<(String, Value)>], name: &str) -> Option<&'s Value> {
    let mut found = scopes.iter().rev().flat_map(|scope| scope.iter().rev());
    found.find_map(|(known, meaning)| (known == name).then_some(meaning))
}

/// The local that a place is, if it is none of the first ones.
pub(super) fn local_since(place: &Place, first: usize) -> Option<LocalId> {
    (place.steps.is_empty() && place.root.index() >= first).then_some(place.root)
}

/// Where a value goes.
#[derive(Clone)]
pub(super) enum Target {
    /// To a place.
    Place(Place),
    /// Out of the function.
    Return,
}

/// A loop, a block with a label, or the pass of several loops that are one, that is being lowered.
pub(super) struct Frame {
    pub label: Option<String>,
    /// Where the value of a `break` goes.
    pub target: Option<Target>,
    /// Of a block: the local whose declaration marks where it is left ([`labelled`](super::labelled)).
    pub mark: Option<LocalId>,
    /// Of the pass of a loop that several are: the outermost of these, which what leaves the loop leaves.
    pub outermost: Option<usize>,
    /// Whether it is the pass of what is gone through at most once: what leaves a loop leaves it as well.
    pub pass: bool,
    /// The flags that are tested behind the loop.
    pub behind: Vec<Behind>,
}

impl<'a> Lowering<'a, '_> {
    /// A closure that is written here.
    pub(super) fn closure_here(&mut self, text: tree::Closure) -> Value {
        let closure = self.written_here(text);
        Value::Closure(self.closure(closure))
    }

    /// The same, before a name means it.
    pub(super) fn written_here(&self, text: tree::Closure) -> Closure<'a> {
        let scope = Scope {
            names: self.scopes.clone(),
            expanding: self.expanding.clone(),
            locals: Some(self.locals.len()),
        };
        Closure { text, source: self.source, scope, outermost: None }
    }

    /// The closure that a name means, whatever hides it since.
    pub(super) fn closure_named(&self, name: &str) -> Option<usize> {
        let mut found = self.scopes.iter().rev().flat_map(|scope| scope.iter().rev());
        found.find_map(|(known, meaning)| match meaning {
            Value::Closure(closure) if known == name => Some(*closure),
            _ => None,
        })
    }

    /// Drops all locals but the first ones, and what is known of them: others will have their numbers.
    pub(super) fn drop_locals(&mut self, first: usize) {
        let stays = |local: &LocalId| local.index() < first;
        self.locals.truncate(first);
        self.unasked.retain(stays);
        self.hands.retain(|_, hand| stays(&hand.local));
        for known in [&mut self.held, &mut self.atoms, &mut self.steady, &mut self.valued] {
            known.retain(stays);
        }
        self.changing.retain(|local, _| stays(local));
    }

    /// A closure that a name can mean.
    pub(super) fn closure(&mut self, closure: Closure<'a>) -> usize {
        self.closures.push(Rc::new(closure));
        self.closures.len() - 1
    }
}

impl Frame {
    /// Whether it is a loop of the C.
    pub(super) fn is_loop(&self) -> bool {
        self.mark.is_none() && self.outermost.is_none()
    }

    /// That of a loop, with a mark that of a block, which is left where its mark is declared.
    pub(super) fn of(label: Option<&str>, target: Option<&Target>) -> Frame {
        let (label, target) = (label.map(str::to_owned), target.cloned());
        Frame { label, target, mark: None, outermost: None, pass: false, behind: Vec::new() }
    }
}

/// A flag that is looked at behind a loop.
pub(super) struct Behind {
    pub flag: LocalId,
    /// The loop that is left for good, or continued, by its depth.
    pub left: usize,
    pub leaving: Leaving,
}

/// The two ways to leave a pass.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Leaving {
    Break,
    Continue,
}

/// An iterator that is gone through by hand.
pub(super) struct Hand {
    /// What goes through the same items and takes none.
    pub again: usize,
    /// The name in the text of how many were taken; none for an own iterator, which goes on by itself.
    pub taken: Option<String>,
    /// The local that each item changes: how many were taken, or the own iterator.
    pub local: LocalId,
    /// What it keeps from item to item, by the names in the text.
    pub kept: Vec<String>,
    /// The iterator whose items a link changes or leaves out, which is gone through by hand in its place.
    pub within: Option<usize>,
}

/// A closure that a name means in the function that is being lowered.
#[derive(Clone)]
pub(super) struct Closure<'a> {
    pub text: tree::Closure,
    /// The function that its body stands in.
    pub source: &'a tree::Function,
    pub scope: Scope<'a>,
    /// Of the pass of a loop through what a function gives: the loop's label, and the frame that what leaves it leaves.
    pub outermost: Option<(Option<String>, usize)>,
}

/// The meaning of names in a closure.
#[derive(Clone)]
pub(super) struct Scope<'a> {
    pub names: Vec<Vec<(String, Value)>>,
    /// The functions around it whose bodies are being lowered.
    pub expanding: Vec<&'a str>,
    /// How many locals there were where it was written. None in a copy of a function for it: there its names mean
    /// parameters of the copy.
    pub locals: Option<usize>,
}
