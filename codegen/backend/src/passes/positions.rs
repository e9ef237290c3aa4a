//! Grammar of explicit IR: the positions in which expressions are allowed.

use bessemer_ir::{Argument, Expr, ExprKind, Function, Mode, Role, Routine, UnaryOp};

use super::places::weight;
use crate::late::{self, Early};
use crate::routines::{is_element_wise, outer, reduces};

/// Largest number of elements for which an element-wise routine is written out in C.
const ELEMENTS: usize = 4;

/// Largest weight of an element that takes the place of its name.
const SHORT: usize = 3;

/// Position of an expression in a statement.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Position {
    /// The whole value of a `let`, an assignment or a `return`.
    Whole,
    /// The condition of an `if`, or the operand of the `!` that is its condition.
    Decision,
    /// A word inside an expression.
    Nested,
    /// A part of a constructor.
    Part,
    /// A matrix operand of a routine that works element by element. It may be built there from a few short elements.
    Elementwise,
    /// The value that a splat repeats.
    Repeated,
    /// An operand that is read several times.
    Leaf,
    /// A factor of a product: a leaf, or the transpose of one.
    Factor,
    /// A place that is borrowed.
    Reference,
}

/// Facts about a function that its callers need.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Callee {
    /// True if it may fault.
    pub(crate) fallible: bool,
    /// If it returns its result through a pointer: the parameters that it reads only before it writes there.
    pub(crate) through_pointer: Option<Early>,
    /// True if a call may be inside an expression.
    pub(crate) nests: bool,
    /// True if it is external, or calls such a function: two calls may return different results, and each may have
    /// effects.
    pub(crate) outside: bool,
}

impl Callee {
    pub(crate) fn of(function: &Function, fallible: bool, outside: bool) -> Callee {
        let status = fallible || function.role == Role::Entry { infallible: false };
        // Without effect, so that it does not matter when the call is made.
        let reads = function.parameters().iter().all(|p| match p.mode {
            Mode::Value => p.ty.is_word(),
            Mode::Ref => true,
            Mode::RefMut => false,
        });
        Callee {
            fallible,
            through_pointer: (status || function.result.is_aggregate())
                .then(|| late::early(function, status)),
            nests: !status && reads && !outside && function.result.is_word(),
            outside,
        }
    }
}

/// Returns true if `expr`, whose operands are explicit, is allowed at `position`.
pub(crate) fn accepts(callees: &[Callee], position: Position, expr: &Expr) -> bool {
    use Position::{Decision, Elementwise, Factor, Nested, Part, Reference, Repeated, Whole};
    match &expr.kind {
        _ if position == Whole => true,
        ExprKind::Call(callee, _) => {
            let callee = callees.get(callee.index());
            match position {
                Decision => callee.is_some_and(|callee| callee.through_pointer.is_none()),
                Nested | Part => callee.is_some_and(|callee| callee.nests),
                _ => false,
            }
        }
        ExprKind::Const(_) | ExprKind::Load(_) => true,
        ExprKind::Literal(_) => position != Reference,
        _ if expr.ty.is_word() => matches!(position, Decision | Nested | Part),
        ExprKind::Matrix(items) if position == Elementwise => is_short(items),
        ExprKind::Struct(_) | ExprKind::Array(_) | ExprKind::Matrix(_) => position == Part,
        ExprKind::Splat(_) => matches!(position, Part | Repeated),
        ExprKind::Routine(Routine::Transpose, _) => matches!(position, Elementwise | Factor),
        ExprKind::Routine(routine, operands) => {
            position == Elementwise && (is_element_wise(*routine) || outer(*routine, operands))
        }
        _ => false,
    }
}

/// Returns true if elements are few and short. An element-wise routine of so small a matrix is written out in C, and
/// reads each of them once.
fn is_short(items: &[Expr]) -> bool {
    items.len() <= ELEMENTS && items.iter().all(|item| weight(item) <= SHORT)
}

/// Returns the operand of a negated condition, or any other condition itself.
pub(crate) fn asked(condition: &Expr) -> &Expr {
    match &condition.kind {
        ExprKind::Unary(UnaryOp::Not, x) => x,
        _ => condition,
    }
}

/// Returns the position of an operand of an expression that is no call.
pub(crate) fn operand(parent: &ExprKind, operand: &Expr) -> Position {
    match parent {
        ExprKind::Struct(_) | ExprKind::Array(_) | ExprKind::Matrix(_) => Position::Part,
        ExprKind::Splat(_) => Position::Repeated,
        ExprKind::Routine(routine, _)
            if (is_element_wise(*routine) || reduces(*routine)) && operand.ty.is_aggregate() =>
        {
            Position::Elementwise
        }
        ExprKind::Routine(Routine::Product, _) => Position::Factor,
        ExprKind::Routine(..) => Position::Leaf,
        _ => Position::Nested,
    }
}

/// Returns the value of an argument with its position; none for a mutable borrow.
pub(crate) fn argument(argument: &Argument) -> Option<(&Expr, Position)> {
    match argument {
        Argument::Value(value) if value.ty.is_aggregate() => Some((value, Position::Leaf)),
        Argument::Value(value) => Some((value, Position::Nested)),
        Argument::Ref(value) => Some((value, Position::Reference)),
        Argument::RefMut(_) => None,
    }
}
