//! Expressions and places made of their parts: types follow from the operands, and an expression stands where its
//! first operand does.
//!
//! Nothing is folded or reordered. Whether the operands are of the types that an operation takes is the validator's to
//! say.

use alloc::boxed::Box;
use alloc::vec::Vec;

use crate::ir::{
    BinaryOp, Block, CompareOp, Expr, ExprKind, Intrinsic, LocalId, LogicOp, Place, Span, Step,
    Stmt, StmtKind, Type, UnaryOp,
};

impl Expr {
    /// A word of a type.
    pub fn literal(word: u64, ty: Type, span: Span) -> Expr {
        Expr { kind: ExprKind::Literal(word), ty, span }
    }

    /// A word of the type of another expression, where that one stands.
    pub fn literal_like(word: u64, like: &Expr) -> Expr {
        Expr::literal(word, like.ty.clone(), like.span)
    }

    /// A `usize`.
    pub fn usize(value: u64, span: Span) -> Expr {
        Expr::literal(value, Type::USIZE, span)
    }

    /// `true` or `false`.
    pub fn bool(value: bool, span: Span) -> Expr {
        Expr::literal(value.into(), Type::BOOL, span)
    }

    /// The value of a local.
    pub fn local(local: LocalId, ty: &Type, span: Span) -> Expr {
        Place::local(local, ty.clone(), span).load()
    }

    /// `-x`, `!x`.
    pub fn unary(op: UnaryOp, operand: Expr) -> Expr {
        let (ty, span) = (operand.ty.clone(), operand.span);
        Expr { kind: ExprKind::Unary(op, Box::new(operand)), ty, span }
    }

    /// `a + b` and the like: of the left operand's type.
    pub fn binary(op: BinaryOp, left: Expr, right: Expr) -> Expr {
        let (ty, span) = (left.ty.clone(), left.span);
        Expr { kind: ExprKind::Binary(op, Box::new(left), Box::new(right)), ty, span }
    }

    /// `a < b` and the like.
    pub fn compare(op: CompareOp, left: Expr, right: Expr) -> Expr {
        let span = left.span;
        let kind = ExprKind::Compare(op, Box::new(left), Box::new(right));
        Expr { kind, ty: Type::BOOL, span }
    }

    /// `a && b`, `a || b`.
    pub fn logic(op: LogicOp, left: Expr, right: Expr) -> Expr {
        let span = left.span;
        let kind = ExprKind::Logic(op, Box::new(left), Box::new(right));
        Expr { kind, ty: Type::BOOL, span }
    }

    /// An intrinsic, of the type that it gives for its first operand.
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

    /// `self as ty`; the value itself where it is of that type.
    #[must_use]
    pub fn cast(self, ty: &Type) -> Expr {
        if self.ty == *ty {
            return self;
        }
        let span = self.span;
        Expr { kind: ExprKind::Cast(Box::new(self)), ty: ty.clone(), span }
    }

    /// The opposite of a condition; a comparison turned round, unless a NaN could tell.
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
    /// The whole of a local.
    pub fn local(root: LocalId, ty: Type, span: Span) -> Place {
        Place { root, steps: Vec::new(), ty, span }
    }

    /// The part behind one more step.
    #[must_use]
    pub fn inside(&self, step: Step, ty: Type) -> Place {
        let mut inner = self.clone();
        inner.steps.push(step);
        inner.ty = ty;
        inner
    }

    /// The value that is there.
    pub fn load(&self) -> Expr {
        Expr { kind: ExprKind::Load(self.clone()), ty: self.ty.clone(), span: self.span }
    }
}

impl Stmt {
    /// A statement without comments.
    pub fn new(kind: StmtKind, span: Span) -> Stmt {
        Stmt { kind, span, comments: Vec::new() }
    }
}

impl StmtKind {
    /// `if condition { then }`.
    pub fn if_then(condition: Expr, then: Block) -> StmtKind {
        StmtKind::If { condition, then, otherwise: Block::default() }
    }

    /// `for variable in from..to`.
    pub fn for_range(variable: LocalId, from: Expr, to: Expr, body: Block) -> StmtKind {
        StmtKind::for_way(variable, [from, to], (false, false), body)
    }

    /// Builds a `for` statement: `inclusive` of the end or not, and from the last on if it is `reversed`.
    pub fn for_way(
        variable: LocalId,
        [from, to]: [Expr; 2],
        (inclusive, reversed): (bool, bool),
        body: Block,
    ) -> StmtKind {
        let (unroll, ended) = (None, false);
        StmtKind::For { variable, from, to, inclusive, reversed, unroll, ended, body }
    }

    /// `for variable in 0..to`.
    pub fn for_below(variable: LocalId, to: Expr, body: Block) -> StmtKind {
        StmtKind::for_range(variable, Expr::literal_like(0, &to), to, body)
    }
}

impl Block {
    /// One statement.
    pub fn of(kind: StmtKind, span: Span) -> Block {
        Block(alloc::vec![Stmt::new(kind, span)])
    }
}
