//! Numbers and conditions that are equal in all lanes because of their form. These are literals, constants, counters of loops whose
//! bounds are such numbers, and their sums. They are an `i64` or a `bool` of Rust, so an index of this kind needs no lane by lane
//! access, and a branch no mask.

use bessemer_ir::{BinaryOp, CompareOp, Expr, ExprKind, Int, LogicOp, Scalar, Type, UnaryOp};

use crate::body::Cx;

impl Cx<'_> {
    /// Returns a whole number that all lanes have in common, as an `i64`.
    pub(crate) fn uniform(&self, expr: &Expr) -> Option<String> {
        let Type::Scalar(Scalar::Int(int)) = expr.ty else { return None };
        match &expr.kind {
            ExprKind::Literal(word) => fits(int, *word).then(|| (*word as i64).to_string()),
            ExprKind::Const(id) => {
                let constant = &self.module.consts[id.index()];
                let [word] = constant.words.as_slice() else { return None };
                fits(int, *word).then(|| self.names.of_const(*id).to_owned())
            }
            ExprKind::Load(place) if place.steps.is_empty() => {
                self.uniform.contains(&place.root).then(|| self.local(place.root))
            }
            ExprKind::Binary(op, left, right) => {
                let op = match op {
                    BinaryOp::Add => "+",
                    BinaryOp::Sub => "-",
                    BinaryOp::Mul => "*",
                    BinaryOp::Div | BinaryOp::Rem
                        if !matches!(right.kind, ExprKind::Literal(1..)) =>
                    {
                        return None;
                    }
                    BinaryOp::Div => "/",
                    BinaryOp::Rem => "%",
                    _ => return None,
                };
                Some(format!("({} {op} {})", self.uniform(left)?, self.uniform(right)?))
            }
            ExprKind::Cast(of) => {
                let Type::Scalar(Scalar::Int(from)) = of.ty else { return None };
                let keeps = Int::min(from) >= Int::min(int) && Int::max(from) <= Int::max(int);
                if keeps || matches!(of.kind, ExprKind::Literal(word) if fits(int, word)) {
                    return self.uniform(of);
                }
                None
            }
            _ => None,
        }
    }

    /// Returns a condition that all lanes have in common, as a `bool`.
    pub(crate) fn uniform_condition(&self, expr: &Expr) -> Option<String> {
        match &expr.kind {
            ExprKind::Literal(word) => Some((*word != 0).to_string()),
            ExprKind::Compare(op, left, right) => {
                let op = match op {
                    CompareOp::Eq => "==",
                    CompareOp::Ne => "!=",
                    CompareOp::Lt => "<",
                    CompareOp::Le => "<=",
                    CompareOp::Gt => ">",
                    CompareOp::Ge => ">=",
                };
                Some(format!("({} {op} {})", self.uniform(left)?, self.uniform(right)?))
            }
            ExprKind::Logic(op, left, right) => {
                let op = if *op == LogicOp::And { "&&" } else { "||" };
                let (left, right) = (self.uniform_condition(left)?, self.uniform_condition(right)?);
                Some(format!("({left} {op} {right})"))
            }
            ExprKind::Unary(UnaryOp::Not, of) => Some(format!("!{}", self.uniform_condition(of)?)),
            _ => None,
        }
    }
}

/// Returns true if the word of an integer is its value as an `i64`.
fn fits(int: Int, word: u64) -> bool {
    int.signed() || i64::try_from(word).is_ok()
}
