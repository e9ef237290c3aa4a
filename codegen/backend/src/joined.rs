//! Finds statements over the elements of vectors that the C computes in one loop.
//!
//! A *member* is a statement that visits the elements of vectors of one length in order: it stores an element-wise value, copies
//! a vector, or takes the largest magnitude of an element-wise value. It has no call and no check, so no effect or fault moves
//! beyond another. A member joins those before it if
//!
//! * it reads or writes a whole vector that one of them reads or writes; otherwise the loop would save only a counter;
//! * neither it nor one of them writes what the other reads once for all elements: a factor, an index, a magnitude;
//! * a copy has its source from the loop, and the loop has at most [`VECTORS`] vectors, as many as processors have registers
//!   for.
//!
//! Invariant: every dependence between joined members is from an element to the same element. Two vectors are one
//! memory or separate ones, since no part of a vector is a vector. Names for memory of the caller, where vectors may overlap, and
//! parts of an enum, whose variants share memory, are in no member. Must not know: the C text of a loop.

use bessemer_ir::effects::{overlap, same_place, whole};
use bessemer_ir::visit::Walk as _;
use bessemer_ir::{
    Expr, ExprKind, Function, LocalId, Mode, Module, Place, Routine, Scalar, Step, Stmt, StmtKind,
    Type,
};

use crate::routines::is_element_wise;

/// Largest number of vectors that a loop reads or writes.
const VECTORS: usize = 8;
/// Largest number of elements that are computed one per line, without a loop.
const LINES: u32 = 4;

/// Statement over the elements of vectors.
#[derive(Debug)]
pub(crate) struct Member {
    /// Number of elements.
    count: u32,
    /// Vector that it stores, element by element.
    stored: Option<Place>,
    /// Vectors that it reads, element by element.
    read: Vec<Place>,
    /// Magnitude that it declares.
    magnitude: Option<LocalId>,
    /// Places that it reads once for all elements.
    once: Vec<Place>,
    is_copy: bool,
}

/// Members that one loop computes, in order.
#[derive(Debug)]
pub(crate) struct Group(Vec<Member>);

/// Returns the number of statements, from the first on, that one loop computes; at most 1 if the first has its own loop or
/// none.
pub(crate) fn joined<'s>(
    module: &Module,
    function: &Function,
    stmts: impl Iterator<Item = &'s Stmt>,
) -> usize {
    let mut members = stmts.map_while(|stmt| Member::of(module, function, stmt));
    let Some(mut group) = members.next().and_then(Group::new) else { return 0 };
    for member in members {
        if !group.accepts(&member) {
            break;
        }
        group.push(member);
    }
    group.0.len()
}

/// Returns true if each place in a statement shares memory only with places of the same root.
pub(crate) fn is_separate(module: &Module, function: &Function, stmt: &Stmt) -> bool {
    !stmt.any_place(|place, _| {
        let local = function.local(place.root);
        let mut ty = Some(local.ty.clone());
        let is_overlaid = place.steps.iter().any(|step| {
            let of = ty.take();
            ty = of.as_ref().and_then(|of| module.step_type(of, step));
            matches!(of, Some(Type::Struct(id)) if module.structs[id.index()].overlaid())
        });
        is_overlaid || local.mode == Mode::RefMut && place.root.0 >= function.params
    })
}

impl Group {
    /// Returns a group of one member; none if no other can join it.
    pub(crate) fn new(first: Member) -> Option<Group> {
        (!first.is_copy).then(|| Group(vec![first]))
    }

    /// Returns true if a member that follows may be in the same loop.
    pub(crate) fn accepts(&self, next: &Member) -> bool {
        let vectors = || self.0.iter().flat_map(Member::vectors);
        let is_here = |place: &Place| vectors().any(|other| same_place(place, other));
        let is_stored = |place: &Place| {
            let mut stored = self.0.iter().filter_map(|it| it.stored.as_ref());
            stored.any(|other| same_place(place, other))
        };
        let mut all: Vec<&Place> = Vec::new();
        for place in vectors().chain(next.vectors()) {
            if !all.iter().any(|other| same_place(place, other)) {
                all.push(place);
            }
        }
        self.0.iter().all(|it| it.count == next.count && !it.hurts(next) && !next.hurts(it))
            && next.vectors().any(is_here)
            && (!next.is_copy || next.read.iter().all(is_stored))
            && all.len() <= VECTORS
    }

    /// Adds a member that it accepts.
    pub(crate) fn push(&mut self, next: Member) {
        self.0.push(next);
    }
}

impl Member {
    /// Returns a statement as a member; none if it has no loop over the elements of vectors.
    pub(crate) fn of(module: &Module, function: &Function, stmt: &Stmt) -> Option<Member> {
        let none = |count| Member {
            count,
            stored: None,
            read: Vec::new(),
            magnitude: None,
            once: Vec::new(),
            is_copy: false,
        };
        let member = match &stmt.kind {
            StmtKind::Let { local, value: Some(value) } => match &value.kind {
                ExprKind::Routine(Routine::Amax, operands) => {
                    let mut member = none(length(&operands[0].ty)?);
                    member.magnitude = Some(*local);
                    member.operand(&operands[0])?;
                    member
                }
                // Most copies to a local are names.
                ExprKind::Routine(..) => {
                    let mut member = none(length(&value.ty)?);
                    member.stored = Some(whole(*local));
                    member.operand(value)?;
                    member
                }
                _ => return None,
            },
            StmtKind::Assign { place, value } => {
                let mut member = none(length(&value.ty)?);
                member.is_copy = matches!(value.kind, ExprKind::Load(_));
                member.stored = Some(place.clone());
                member.indices(place)?;
                member.operand(value)?;
                member
            }
            _ => return None,
        };
        is_separate(module, function, stmt).then_some(member)
    }

    /// Adds the reads of an operand; none if it is not element-wise.
    fn operand(&mut self, operand: &Expr) -> Option<()> {
        if operand.ty.is_word() {
            return self.number(operand);
        }
        if length(&operand.ty) != Some(self.count) {
            return None;
        }
        match &operand.kind {
            ExprKind::Load(place) => {
                self.read.push(place.clone());
                self.indices(place)
            }
            ExprKind::Splat(item) => self.number(item),
            ExprKind::Const(_) => Some(()),
            ExprKind::Routine(routine, operands) if is_element_wise(*routine) => {
                operands.iter().try_for_each(|operand| self.operand(operand))
            }
            _ => None,
        }
    }

    /// Adds the reads of a number that is computed once; none if it calls or computes a routine.
    fn number(&mut self, value: &Expr) -> Option<()> {
        let computes =
            |expr: &Expr| matches!(expr.kind, ExprKind::Call(..) | ExprKind::Routine(..));
        value.each_place(|place, _| self.once.push(place.clone()));
        (!value.any_expr(computes)).then_some(())
    }

    fn indices(&mut self, place: &Place) -> Option<()> {
        place.steps.iter().flat_map(Step::indices).try_for_each(|index| self.number(index))
    }

    /// Returns the vectors that it reads or writes element by element.
    fn vectors(&self) -> impl Iterator<Item = &Place> {
        self.read.iter().chain(&self.stored)
    }

    /// Returns true if it writes a place that another reads once for all elements.
    fn hurts(&self, other: &Member) -> bool {
        let magnitude = self.magnitude.map(whole);
        let mut written = self.stored.iter().chain(&magnitude);
        written.any(|written| other.once.iter().any(|read| overlap(written, read)))
    }
}

/// Returns the number of elements of a vector that a loop computes.
fn length(ty: &Type) -> Option<u32> {
    match *ty {
        Type::Matrix { element: Scalar::Float(_), rows, cols } if rows == 1 || cols == 1 => {
            (rows * cols > LINES).then_some(rows * cols)
        }
        _ => None,
    }
}
