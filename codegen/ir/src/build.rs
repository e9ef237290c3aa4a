//! Constructors of expressions, places and statements. The type of an expression follows from its operands, and its
//! span is the first operand's.
//!
//! Nothing is folded or reordered. The validator checks the types of the operands.

use alloc::boxed::Box;
use alloc::vec::Vec;

use crate::ir::{
    BinaryOp, Block, CompareOp, Expr, ExprKind, Intrinsic, LocalId, LogicOp, Place, Span, Step,
    Stmt, StmtKind, Type, UnaryOp,
};

impl Expr {
    /// Returns a literal word of a type.
    pub fn literal(word: u64, ty: Type, span: Span) -> Expr {
        Expr { kind: ExprKind::Literal(word), ty, span }
    }

    /// Returns a literal with the type and the span of another expression.
    pub fn literal_like(word: u64, like: &Expr) -> Expr {
        Expr::literal(word, like.ty.clone(), like.span)
    }

    /// Returns a `usize` literal.
    pub fn usize(value: u64, span: Span) -> Expr {
        Expr::literal(value, Type::USIZE, span)
    }

    /// Returns `true` or `false`.
    pub fn bool(value: bool, span: Span) -> Expr {
        Expr::literal(value.into(), Type::BOOL, span)
    }

    /// Returns the value of a local.
    pub fn local(local: LocalId, ty: &Type, span: Span) -> Expr {
        Place::local(local, ty.clone(), span).load()
    }

    /// Returns `-x` or `!x`.
    pub fn unary(op: UnaryOp, operand: Expr) -> Expr {
        let (ty, span) = (operand.ty.clone(), operand.span);
        Expr { kind: ExprKind::Unary(op, Box::new(operand)), ty, span }
    }

    /// Returns `a + b` and the like, with the left operand's type.
    pub fn binary(op: BinaryOp, left: Expr, right: Expr) -> Expr {
        let (ty, span) = (left.ty.clone(), left.span);
        Expr { kind: ExprKind::Binary(op, Box::new(left), Box::new(right)), ty, span }
    }

    /// Returns `a < b` and the like.
    pub fn compare(op: CompareOp, left: Expr, right: Expr) -> Expr {
        let span = left.span;
        let kind = ExprKind::Compare(op, Box::new(left), Box::new(right));
        Expr { kind, ty: Type::BOOL, span }
    }

    /// Returns `a && b` or `a || b`.
    pub fn logic(op: LogicOp, left: Expr, right: Expr) -> Expr {
        let span = left.span;
        let kind = ExprKind::Logic(op, Box::new(left), Box::new(right));
        Expr { kind, ty: Type::BOOL, span }
    }

    /// Returns an intrinsic, with the type that its first operand determines.
    pub fn intrinsic(op: Intrinsic, operands: Vec<Expr>) -> Expr {
        let first = operands.first();
        let span = first.map_or_else(Span::default, |first| first.span);
        let ty = match first.map(|first| &first.ty) {
            Some(Type::Scalar(scalar)) => Type::Scalar(op.result(*scalar).unwrap_or(*scalar)),
            Some(other) => other.clone(),
            None => Type::Unit,
        };
        Expr { kind: ExprKind::Intrinsic(op, operands), ty, span }
    }

    /// Returns `self as ty`, or the value itself if it has that type.
    #[must_use]
    pub fn cast(self, ty: &Type) -> Expr {
        if self.ty == *ty {
            return self;
        }
        let span = self.span;
        Expr { kind: ExprKind::Cast(Box::new(self)), ty: ty.clone(), span }
    }

    /// Returns the negation of a condition. A comparison is inverted, unless its operands are floats, which may be
    /// NaN.
    #[must_use]
    pub fn negated(self) -> Expr {
        let Expr { kind, ty, span } = self;
        let kind = match kind {
            ExprKind::Unary(UnaryOp::Not, inner) => return *inner,
            ExprKind::Compare(op, a, b) if a.ty.as_float().is_none() => {
                ExprKind::Compare(op.opposite(), a, b)
            }
            kind => ExprKind::Unary(UnaryOp::Not, Box::new(Expr { kind, ty: ty.clone(), span })),
        };
        Expr { kind, ty, span }
    }

    /// Returns true for a literal or a named constant.
    pub fn is_literal(&self) -> bool {
        matches!(self.kind, ExprKind::Literal(_) | ExprKind::Const(_))
    }

    /// Returns the expression with another span; its operands keep theirs.
    #[must_use]
    pub fn at(self, span: Span) -> Expr {
        Expr { span, ..self }
    }
}

impl Place {
    /// Returns the place of a whole local.
    pub fn local(root: LocalId, ty: Type, span: Span) -> Place {
        Place { root, steps: Vec::new(), ty, span }
    }

    /// Returns the place after one more step.
    #[must_use]
    pub fn inside(&self, step: Step, ty: Type) -> Place {
        let mut inner = self.clone();
        inner.steps.push(step);
        inner.ty = ty;
        inner
    }

    /// Returns the value at the place.
    pub fn load(&self) -> Expr {
        Expr { kind: ExprKind::Load(self.clone()), ty: self.ty.clone(), span: self.span }
    }
}

impl Stmt {
    /// Returns a statement without comments.
    pub fn new(kind: StmtKind, span: Span) -> Stmt {
        Stmt { kind, span, comments: Vec::new() }
    }
}

impl StmtKind {
    /// Returns `if condition { then }`.
    pub fn if_then(condition: Expr, then: Block) -> StmtKind {
        StmtKind::If { condition, then, otherwise: Block::default() }
    }

    /// Returns `for variable in from..to`.
    pub fn for_range(variable: LocalId, from: Expr, to: Expr, body: Block) -> StmtKind {
        StmtKind::for_way(variable, [from, to], (false, false), body)
    }

    /// Returns a `for` statement. With `inclusive` it includes the end; with `reversed` it counts down.
    pub fn for_way(
        variable: LocalId,
        [from, to]: [Expr; 2],
        (inclusive, reversed): (bool, bool),
        body: Block,
    ) -> StmtKind {
        let (unroll, ended) = (None, false);
        StmtKind::For { variable, from, to, inclusive, reversed, unroll, ended, body }
    }

    /// Returns `for variable in 0..to`.
    pub fn for_below(variable: LocalId, to: Expr, body: Block) -> StmtKind {
        StmtKind::for_range(variable, Expr::literal_like(0, &to), to, body)
    }
}

impl Block {
    /// Returns a block with one statement.
    pub fn of(kind: StmtKind, span: Span) -> Block {
        Block(alloc::vec![Stmt::new(kind, span)])
    }
}
