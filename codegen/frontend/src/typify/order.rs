//! Order of evaluation.
//!
//! Operands, arguments and indices are held in locals where Rust evaluates them, and [`fuse`] substitutes them again.
//!
//! Invariant: the indices that lead to a place are atoms, and are checked where Rust evaluates the place.

pub(super) mod syntax;

use std::cell::RefCell;
use std::collections::HashSet;

use bessemer_ir::tree::{self, Ty};
use bessemer_ir::visit::Walk;
use bessemer_ir::{
    Block, CompareOp, Expr, ExprKind, Fault, Form, Intrinsic, LocalId, Module, Place, Routine,
    Scalar, Span, Step, Stmt, StmtKind, Type, Written,
};

use super::borrowed::Lenders;
use super::lenders::Put;
use super::lowering::{Lowering, local_since};
use super::seq::{Elements, Item, Kind};
use super::value::{Named, Value, indices};
use super::{Result, words};
use crate::fuse;
use bessemer_ir::effects;
use syntax::is_pure;

impl Lowering<'_, '_> {
    /// Substitutes the statements before a value into it, if [`fuse`](crate::fuse) leaves none of them. Later code also uses
    /// `named`: a name that is a copy denotes the place again, if nothing here writes it.
    pub(super) fn joined(
        &mut self,
        value: Expr,
        stmts: Vec<Stmt>,
        named: &mut [Named],
    ) -> (Expr, Vec<Stmt>) {
        let lent = read_later(&self.lenders, &stmts, &[]);
        let mut later: Vec<LocalId> =
            read_later(&self.lenders, &stmts, named).into_iter().collect();
        later.sort();
        // An index that leads to a place keeps its value.
        let is_index = |local: LocalId| {
            named.iter().any(|named| match &named.stands {
                Value::Place(place) => indices(place).any(|it| effects::mentions(it, local)),
                other => other.any_local(&|it| it == local),
            })
        };
        let is_copy = |local: &LocalId| {
            self.locals.is_copy(*local) && !lent.contains(local) && !is_index(*local)
        };
        let (copies, kept): (Vec<_>, Vec<_>) = later.iter().copied().partition(is_copy);
        if stmts.is_empty() || copies.is_empty() && !kept.is_empty() {
            return (value, stmts);
        }
        let made = |local| self.locals.is_atom(local) && !kept.contains(&local);
        let before = fuse::Before { stmts: &stmts, value: &value, copies: &copies };
        let Some(joined) = fuse::joined(&self.cx.module, &self.locals, &made, &before) else {
            copies.into_iter().for_each(|copy| self.locals.note_temporary(copy));
            return (value, stmts);
        };
        for (copy, place) in copies.into_iter().zip(joined.places) {
            match place {
                Some(place) => {
                    let mut put = Put::new(copy, place);
                    named.iter_mut().for_each(|named| put.value(&mut named.stands));
                }
                None => self.locals.note_temporary(copy),
            }
        }
        self.alias_names(named);
        (joined.value, joined.stmts)
    }

    /// Substitutes the statements since `mark` into a place that is read and then written, if none is left. A place that calls
    /// is evaluated once.
    pub(super) fn joined_place(&mut self, mark: usize, place: Place) -> Place {
        let other = self.out[mark..]
            .iter()
            .rposition(|stmt| !fuse::may_go(stmt, &|it| self.locals.is_atom(it)));
        let stmts = self.out.split_off(other.map_or(mark, |at| mark + at + 1));
        match self.joined(place.load(), stmts.clone(), &mut []) {
            (Expr { kind: ExprKind::Load(joined), .. }, left)
                if left.is_empty() && !effects::calls(&joined.load()) =>
            {
                joined
            }
            _ => {
                self.out.extend(stmts);
                place
            }
        }
    }

    /// Returns an atom for a value: a literal, a constant, or a local that is assigned once. If nothing would have
    /// changed the value, [`fuse`](crate::fuse) substitutes it again.
    pub(super) fn atom(&mut self, role: &str, value: Expr) -> Expr {
        self.atomic(role, value).unwrap_or_else(|value| self.atom_place(role, value).load())
    }

    /// Returns an atom for a value as the meaning of a name.
    pub(super) fn constant(&mut self, name: &str, value: Expr) -> Value {
        match value.kind {
            ExprKind::Load(place)
                if place.steps.is_empty() && self.locals.is_constant_place(&place) =>
            {
                Value::Place(place)
            }
            _ if self.is_atom(&value) && !value.any_place(|_, _| true) => {
                Value::Word(Box::new(value))
            }
            _ => Value::Place(self.atom_place(name, value)),
        }
    }

    /// Returns the value if its form is needed and its parts can be atoms; otherwise the value as an error.
    pub(super) fn atomic(&mut self, role: &str, value: Expr) -> Result<Expr, Expr> {
        // A zero-sized value is no value of the IR, and a slice is no local.
        if self.is_atom(&value) || matches!(value.ty, Type::Unit | Type::Slice(_)) {
            return Ok(value);
        }
        match (value.kind, &value.ty) {
            (ExprKind::Struct(parts), Type::Struct(id))
                if matches!(self.cx.module.structs[id.index()].form, Form::Choice(_)) =>
            {
                let parts = parts.into_iter().map(|part| self.atom(role, part)).collect();
                Ok(Expr { kind: ExprKind::Struct(parts), ..value })
            }
            // A product reads a factor untransposed.
            (ExprKind::Routine(Routine::Transpose, of), _) => {
                let of = of.into_iter().map(|of| self.atom(role, of)).collect();
                Ok(Expr { kind: ExprKind::Routine(Routine::Transpose, of), ..value })
            }
            (kind, _) => Err(Expr { kind, ..value }),
        }
    }

    fn is_atom(&self, value: &Expr) -> bool {
        match &value.kind {
            ExprKind::Literal(_) | ExprKind::Const(_) => true,
            ExprKind::Load(place) => {
                let once = self.locals.is_atom(place.root) || self.locals.is_counter(place.root);
                place.steps.is_empty() && once
            }
            ExprKind::Struct(parts) | ExprKind::Array(parts) => {
                parts.iter().all(|part| self.is_atom(part))
            }
            _ => false,
        }
    }

    /// Returns the place of a new local that holds a value and is assigned once.
    pub(super) fn atom_place(&mut self, role: &str, value: Expr) -> Place {
        let place = self.assigned(role, value);
        self.locals.note_atom(place.root);
        place
    }

    /// Emits the evaluation of a value that nothing reads, unless nobody can observe it.
    pub(super) fn evaluated(&mut self, value: Expr) {
        if !is_free(&value) {
            let span = value.span;
            self.emit(StmtKind::Expr(value), span);
        }
    }

    /// Returns a place that keeps the value of a place.
    pub(super) fn constant_place(&mut self, role: &str, place: Place) -> Place {
        match self.locals.is_constant_place(&place) {
            true => place,
            false => self.atom_place(role, place.load()),
        }
    }

    /// Returns a place that keeps the value of a place, under which a name of the author's denotes the value.
    pub(super) fn copied_place(&mut self, role: &str, place: Place) -> Place {
        let before = self.locals.len();
        let kept = self.constant_place(role, place);
        local_since(&kept, before).into_iter().for_each(|copy| self.locals.note_copy(copy));
        kept
    }

    /// Evaluates and checks the indices of the last step to a place, as Rust does where the step is written. So no later
    /// write moves the place.
    pub(super) fn indexed(&mut self, mut place: Place) -> Place {
        let Some(mut last) = place.steps.pop() else { return place };
        for index in last.indices_mut() {
            let named = named_index(&mut self.cx.module, index.clone());
            *index = self.atom(words::INDEX, named);
        }
        let lengths = match self.type_of(place.root, &place.steps) {
            // The place of a reference was checked where the reference was chosen.
            _ if self.lenders.has_placeholder(place.root) => Vec::new(),
            Type::Array { len, .. } => vec![len],
            Type::Matrix { rows, cols, .. } => match last {
                Step::Element(..) => vec![rows, cols],
                _ => vec![rows * cols],
            },
            // A slice has looked already.
            _ => Vec::new(),
        };
        let known = |(index, len): &(&Expr, u32)| matches!(index.kind, ExprKind::Literal(at) if at < u64::from(*len));
        for (index, len) in last.indices().zip(lengths).filter(|it| !known(it)) {
            let len = Expr::literal_like(u64::from(len), index);
            let condition = Expr::compare(CompareOp::Lt, index.clone(), len);
            self.emit(StmtKind::Check { condition, fault: Fault::Index }, index.span);
        }
        place.steps.push(last);
        place
    }

    /// Holds the parts of a value, unless nothing that is evaluated later writes.
    pub(super) fn beside_later<'e>(
        &mut self,
        value: Value,
        expr: &tree::Expr,
        later: impl IntoIterator<Item = &'e tree::Expr>,
    ) -> Value {
        match later.into_iter().all(is_pure) {
            true => value,
            false => self.part_held(value, expr),
        }
    }

    /// Returns the place as the meaning of an immutable name, if nothing writes the place; otherwise the name needs a copy. Such a
    /// place is behind `&`, or in a local that the author has no name for.
    pub(super) fn denoted(&self, place: &Place, mutable: bool) -> Option<Value> {
        let lasts = self.locals.lasts(place) && !self.cx.holds_iterator(&place.ty);
        (lasts && !mutable).then(|| Value::Place(place.clone()))
    }

    /// Declares the locals that later code mentions before the condition whose right side computes them. Returns the other
    /// statements of that side, which assign them.
    pub(super) fn declared_first(&mut self, inner: Vec<Stmt>, names: &[Named]) -> Vec<Stmt> {
        let mut kept = Vec::new();
        let later = read_later(&self.lenders, &inner, names);
        for stmt in inner {
            let Stmt { kind: StmtKind::Let { local, value }, span, comments } = stmt else {
                kept.push(stmt);
                continue;
            };
            // Where a block is left, nothing is declared.
            let own = self.locals.is_atom(local) && !later.contains(&local);
            if own || self.frames.marks().contains(&local) {
                kept.push(Stmt { kind: StmtKind::Let { local, value }, span, comments });
                continue;
            }
            let ty = self.locals[local.index()].ty.clone();
            let first = Some(self.zero(&ty, span));
            // Whose elements the slices in it are is known from where it was lowered.
            self.out.push(Stmt::new(StmtKind::Let { local, value: first }, span));
            let place = Place::local(local, ty, span);
            let assign = value.map(|value| StmtKind::Assign { place, value });
            kept.extend(assign.map(|kind| Stmt { kind, span, comments }));
        }
        kept
    }

    /// Copies arrays that a loop iterates over by value, if its body writes them, and returns the declarations of the
    /// copies.
    pub(super) fn own_elements(
        &mut self,
        items: &[Item],
        body: &mut Block,
        span: Span,
    ) -> Vec<Stmt> {
        let mut copies = Vec::new();
        for item in items {
            let Some(Kind::Elements(Elements { slice, owned })) = item.of else { continue };
            let place = &slice.base;
            // Elements that are references, whatever they are gone through by: those of a slice with a name.
            let refers = |slot| matches!(self.source.slots.get(slot as usize), Some(Ty::Ref(..)));
            let refers = matches!(item.pattern, tree::Pattern::Name { slot, .. } if refers(*slot));
            if !owned || refers || !effects::writes_local(body, place.root) {
                continue;
            }
            let local = self.local(words::ELEMENTS, place.ty.clone(), span);
            let mut copied = false;
            for stmt in &mut body.0 {
                // The declarations of the names come first, each with its part of the element.
                if let StmtKind::Let { value: Some(value), .. } = &mut stmt.kind
                    && let ExprKind::Load(element) = &mut value.kind
                    && element.root == place.root
                    && element.steps.len() > place.steps.len()
                    && element.steps.starts_with(&place.steps)
                    && element.span == place.span
                {
                    copied = true;
                    element.root = local;
                    element.steps.drain(..place.steps.len());
                }
            }
            // Else its names are references, `for x in table.row_mut(i)`.
            if copied {
                let value = Some(place.load().at(span));
                copies.push(Stmt::new(StmtKind::Let { local, value }, span));
            }
        }
        copies
    }
}

/// Returns an index as its number, if it is the name of one: a constant, or a variant `as usize`. The C has the name.
fn named_index(module: &mut Module, index: Expr) -> Expr {
    let named = match &index.kind {
        ExprKind::Const(id) => match module.consts[id.index()].words.as_slice() {
            [word] => Some((*word, Written::Constant(*id))),
            _ => None,
        },
        ExprKind::Cast(of) if let (ExprKind::Literal(at), Type::Enum(id)) = (&of.kind, &of.ty) => {
            let number = module.enums[id.index()].variants.get(*at as usize).map(|it| it.value);
            let word = number.and_then(|number| u64::try_from(number).ok());
            word.map(|word| (word, Written::Variant(*id, *at as u32)))
        }
        _ => None,
    };
    let Some((word, written)) = named.filter(|_| index.ty == Type::USIZE) else { return index };
    module.written.insert((index.span, word), written);
    Expr::usize(word, index.span)
}

/// Returns the locals that statements declare and that `named` or a lender mentions.
fn read_later(lenders: &Lenders, stmts: &[Stmt], named: &[Named]) -> HashSet<LocalId> {
    let declared = stmts.iter().filter_map(|stmt| match stmt.kind {
        StmtKind::Let { local, .. } => Some(local),
        _ => None,
    });
    let declared: HashSet<LocalId> = declared.collect();
    let found = RefCell::new(HashSet::new());
    let note = |local: LocalId| {
        if declared.contains(&local) {
            found.borrow_mut().insert(local);
        }
        false
    };
    if !declared.is_empty() {
        named.iter().for_each(|named| _ = named.stands.any_local(&note));
        lenders.mention(&note);
    }
    found.into_inner()
}

/// Returns true if a value may be evaluated earlier or later: it writes nothing, and cannot fault. A call may do
/// either.
pub(super) fn is_free(expr: &Expr) -> bool {
    is_quiet_but_for(expr, |place| place.steps.iter().all(is_fixed))
}

/// Returns true if an expression does not write, call or fault, except by loads that `allowed` judges.
fn is_quiet_but_for(expr: &Expr, allowed: impl Fn(&Place) -> bool) -> bool {
    !expr.any_expr(|expr| {
        let float = matches!(expr.ty, Type::Scalar(Scalar::Float(_) | Scalar::Bool));
        let quiet = match &expr.kind {
            ExprKind::Call(..) => false,
            ExprKind::Intrinsic(which, _) => float && *which != Intrinsic::Clamp,
            ExprKind::Unary(..) | ExprKind::Binary(..) => float,
            ExprKind::Load(place) => allowed(place),
            _ => true,
        };
        !quiet
    })
}

/// Returns true if a value may be read more than once: it is a literal, or a place with fields only.
pub(super) fn is_light(value: &Expr) -> bool {
    let fields = |place: &Place| place.steps.iter().all(|step| matches!(step, Step::Field(_)));
    value.is_literal() || matches!(&value.kind, ExprKind::Load(place) if fields(place))
}

/// Returns true if a step has only literal indices.
pub(super) fn is_fixed(step: &Step) -> bool {
    step.indices().all(Expr::is_literal)
}
