//! Proves for every call in the C that an argument which the callee writes shares no memory with another argument.
//!
//! Invariants: in doubt, memory is shared. Only calls between emitted functions are seen; for a call by the firmware,
//! the header states the condition. Must not know: how a proof is used.

use std::collections::{BTreeMap, BTreeSet};

use super::tree::{Declarator, Expr, Head, Item, Stmt, StmtKind};

/// Heads of the emitted functions, by name.
type Heads<'a> = BTreeMap<&'a str, &'a Head>;

/// A pair of a function's parameters that some emitted function may call with shared memory: the written one, and the
/// other.
pub type Pair = (String, usize, usize);

/// Returns the pairs of parameters for which a call without shared memory is not proved.
///
/// `shared` has the fields that lie in unions.
pub fn unproved<'a>(
    functions: impl Iterator<Item = &'a Item>,
    shared: &BTreeSet<String>,
) -> BTreeSet<Pair> {
    let bodies: Vec<(&Head, &Vec<Stmt>)> = functions
        .filter_map(|item| match item {
            Item::Function { head, body, .. } => Some((head, body)),
            _ => None,
        })
        .collect();
    let heads: Heads<'_> = bodies.iter().map(|(head, _)| (head.name.as_str(), *head)).collect();
    let mut calls = Vec::new();
    for (head, body) in bodies {
        let mut known = Known { heads: &heads, shared, names: Vec::new(), calls: Vec::new() };
        for (index, param) in head.params.iter().enumerate() {
            let memory = Memory { root: Root::Parameter(index), steps: Vec::new(), run: true };
            known.names.push((param.name.clone(), is_pointer(param).then_some(memory)));
        }
        known.block(body);
        calls.extend(known.calls.into_iter().map(|(pair, proof)| (&head.name, pair, proof)));
    }
    let mut unproved: BTreeSet<Pair> = BTreeSet::new();
    loop {
        let before = unproved.len();
        for (caller, pair, proof) in &calls {
            let may_share =
                |one: usize, other: usize| unproved.contains(&((*caller).clone(), one, other));
            let holds = match *proof {
                Proof::Always => true,
                Proof::IfDisjoint(one, other) => !may_share(one, other) && !may_share(other, one),
                Proof::Never => false,
            };
            if !holds {
                unproved.insert(pair.clone());
            }
        }
        if unproved.len() == before {
            return unproved;
        }
    }
}

/// Returns true if a parameter is a pointer or an array.
pub fn is_pointer(param: &Declarator) -> bool {
    param.ty.ends_with('*') || !param.dimensions.is_empty()
}

/// Returns the indices of the parameters through which a function writes, if it has another pointer beside.
pub fn written(head: &Head) -> Vec<usize> {
    let pointers: Vec<usize> =
        (0..head.params.len()).filter(|index| is_pointer(&head.params[*index])).collect();
    let is_written = |index: &usize| !head.params[*index].ty.starts_with("const ");
    if pointers.len() < 2 { Vec::new() } else { pointers.into_iter().filter(is_written).collect() }
}

/// Proof that two arguments share no memory.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Proof {
    Always,
    /// It holds if these two parameters of the caller share none.
    IfDisjoint(usize, usize),
    Never,
}

#[derive(Clone, Debug, PartialEq)]
enum Root {
    /// Memory of the caller's, by the parameter's index.
    Parameter(usize),
    /// A variable of the function.
    Variable(String),
    /// A constant, which no function writes.
    Constant,
    /// Unknown memory.
    Unknown,
}

#[derive(Clone, Debug, PartialEq)]
enum Part {
    Field(String),
    /// An element; none if the index is no number.
    Element(Option<u64>),
}

/// Memory that an expression leads to.
#[derive(Clone, Debug, PartialEq)]
struct Memory {
    root: Root,
    steps: Vec<Part>,
    /// True for a pointer to one of several elements, false for a place.
    run: bool,
}

struct Known<'a> {
    heads: &'a Heads<'a>,
    shared: &'a BTreeSet<String>,
    /// Visible variables; none is one that is no pointer.
    names: Vec<(String, Option<Memory>)>,
    calls: Vec<(Pair, Proof)>,
}

impl Known<'_> {
    fn block(&mut self, block: &[Stmt]) {
        let outside = self.names.len();
        for stmt in block {
            for expr in stmt.kind.expressions() {
                self.calls_in(expr);
            }
            if let StmtKind::Declare(declarator, init) = &stmt.kind {
                let (pointer, name) = pointed(declarator);
                let memory = pointer.then(|| match init {
                    Some(super::tree::Init::Value(value)) => self.memory(value),
                    _ => UNKNOWN,
                });
                self.names.push((name.to_owned(), memory));
            }
            for inner in stmt.kind.blocks() {
                self.block(inner);
            }
        }
        self.names.truncate(outside);
    }

    fn calls_in(&mut self, expr: &Expr) {
        for operand in expr.operands() {
            self.calls_in(operand);
        }
        let Expr::Call(callee, arguments) = expr else { return };
        let Some(head) = self.heads.get(callee.as_str()).copied() else { return };
        for index in written(head) {
            for (other, param) in head.params.iter().enumerate() {
                if other != index && is_pointer(param) {
                    let one = self.argument(&arguments[index], &head.params[index]);
                    let two = self.argument(&arguments[other], param);
                    let proof = self.disjoint(&one, &two);
                    self.calls.push(((callee.clone(), index, other), proof));
                }
            }
        }
    }

    /// Returns the memory of an argument, and the number of elements that the callee may use; none if it is unknown.
    fn argument(&self, argument: &Expr, param: &Declarator) -> (Memory, Option<u64>) {
        let mut memory = self.memory(argument);
        if param.dimensions.is_empty() {
            return (memory, Some(1));
        }
        if !(memory.run && matches!(memory.steps.last(), Some(Part::Element(_)))) {
            memory.steps.push(Part::Element(Some(0)));
            memory.run = true;
        }
        let lengths = param.dimensions.trim_matches(['[', ']']).split("][");
        (memory, lengths.map(number).try_fold(1, |all, length| Some(all * length?)))
    }

    /// Returns the memory that a pointer leads to, or the place that an expression is.
    fn memory(&self, expr: &Expr) -> Memory {
        match expr {
            Expr::Name(name) => match self.names.iter().rev().find(|(known, _)| known == name) {
                Some((_, Some(memory))) => memory.clone(),
                Some((name, None)) => {
                    Memory { root: Root::Variable(name.clone()), steps: Vec::new(), run: false }
                }
                None => Memory { root: Root::Constant, ..UNKNOWN },
            },
            Expr::Cast(_, pointer) => self.memory(pointer),
            Expr::Unary("&", place) => {
                let mut memory = self.memory(place);
                memory.run = matches!(memory.steps.last(), Some(Part::Element(_)));
                memory
            }
            Expr::Unary("*", pointer) => Memory { run: false, ..self.memory(pointer) },
            Expr::Member(of, field) | Expr::Arrow(of, field) => {
                let mut memory = self.memory(of);
                memory.steps.push(Part::Field(field.clone()));
                memory.run = false;
                memory
            }
            Expr::Index(of, index) => {
                let mut memory = self.memory(of);
                let index = match &**index {
                    Expr::Name(text) => number(text),
                    _ => None,
                };
                match memory.steps.last_mut() {
                    Some(Part::Element(first)) if memory.run => {
                        *first = first.zip(index).map(|(first, index)| first + index);
                    }
                    _ => memory.steps.push(Part::Element(index)),
                }
                memory.run = false;
                memory
            }
            _ => UNKNOWN,
        }
    }

    fn disjoint(&self, one: &(Memory, Option<u64>), two: &(Memory, Option<u64>)) -> Proof {
        let ((one, of_one), (two, of_two)) = (one, two);
        match (&one.root, &two.root) {
            (Root::Constant, _) | (_, Root::Constant) => return Proof::Always,
            (Root::Unknown, _) | (_, Root::Unknown) => return Proof::Never,
            (Root::Parameter(one), Root::Parameter(two)) if one != two => {
                return Proof::IfDisjoint(*one, *two);
            }
            (one, two) if one != two => return Proof::Always,
            _ => {}
        }
        let extent = |memory: &Memory, at: usize, count: Option<u64>| match memory.run {
            true if at + 1 == memory.steps.len() => count,
            _ => Some(1),
        };
        for (at, steps) in one.steps.iter().zip(&two.steps).enumerate() {
            match steps {
                (Part::Field(one), Part::Field(two)) if one == two => {}
                (Part::Field(one), Part::Field(two)) => {
                    return match self.shared.contains(one) && self.shared.contains(two) {
                        true => Proof::Never,
                        false => Proof::Always,
                    };
                }
                (Part::Element(first), Part::Element(second)) => {
                    let (Some(first), Some(second)) = (first, second) else { continue };
                    let ends = |first: &u64, count: Option<u64>, next: &u64| {
                        count.is_some_and(|count| first + count <= *next)
                    };
                    let (here, there) = (extent(one, at, *of_one), extent(two, at, *of_two));
                    if ends(first, here, second) || ends(second, there, first) {
                        return Proof::Always;
                    }
                    if first != second {
                        return Proof::Never;
                    }
                }
                _ => return Proof::Never,
            }
        }
        Proof::Never
    }
}

const UNKNOWN: Memory = Memory { root: Root::Unknown, steps: Vec::new(), run: false };

/// Returns true for the declarator of a pointer, and the variable's name.
fn pointed(declarator: &Declarator) -> (bool, &str) {
    match declarator.name.strip_prefix("(*const ") {
        Some(name) => (true, name.trim_end_matches(')')),
        None => (declarator.ty.contains('*'), &declarator.name),
    }
}

/// Returns the value of a decimal literal.
fn number(text: &str) -> Option<u64> {
    text.trim_end_matches('U').parse().ok()
}

#[cfg(test)]
mod tests;
