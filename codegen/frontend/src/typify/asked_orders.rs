//! Lowering of an `Ordering` that is tested at once: `a.cmp(&b).is_lt()` becomes `a < b`, and a comparing closure is
//! inlined at its call.
//!
//! Must not know: how the result is used.

use bessemer_ir::tree::{
    self, BinaryOp as Op, Builtin, Callee, ExprKind as Tree, OptionMethod, Site, Ty,
};
use bessemer_ir::{Expr, Scalar, Type};

use super::Result;
use super::lowering::Lowering;

/// Library functions that test an `Ordering`, and the comparison of the two values that each means.
const ASKED: [(&str, Op); 6] = [
    ("bessemer::comparison::is_less", Op::Lt),
    ("bessemer::comparison::is_at_most", Op::Le),
    ("bessemer::comparison::is_greater", Op::Gt),
    ("bessemer::comparison::is_at_least", Op::Ge),
    ("bessemer::comparison::is_equal", Op::Eq),
    ("bessemer::comparison::is_unequal", Op::Ne),
];

/// Names of the library's comparison functions: for ordered types, for partially ordered types, and for the total order
/// of floats, which calls `BELOW`.
const COMPARE: &str = "bessemer::comparison::compare";
const PARTIAL: &str = "bessemer::comparison::partial";
const TOTAL: &str = "bessemer::comparison::total";
const BELOW: &str = "bessemer::sort::below";

/// Returns a path without its generic arguments.
fn bare(path: &str) -> &str {
    path.split('<').next().unwrap_or(path)
}

impl Lowering<'_, '_> {
    /// Returns the result of a test of an `Ordering` as a comparison of two values; none for another call.
    pub(super) fn order_asked(
        &mut self,
        path: &str,
        arguments: &[tree::Expr],
        site: Site,
    ) -> Result<Option<Expr>> {
        match (ASKED.iter().find(|(asked, _)| *asked == path), arguments) {
            (Some((_, op)), [order]) => self.answered(*op, order, path, site),
            _ => Ok(None),
        }
    }

    fn answered(
        &mut self,
        op: Op,
        order: &tree::Expr,
        path: &str,
        site: Site,
    ) -> Result<Option<Expr>> {
        match &order.kind {
            Tree::Block(tree::Block { stmts, tail: Some(tail) }) if stmts.is_empty() => {
                self.answered(op, tail, path, site)
            }
            Tree::Apply(name, given) if self.stands_here(order) => {
                self.applied(name, given, order.site, |inner, closure| {
                    if let Some(answer) = inner.answered(op, &closure.body, path, site)? {
                        return Ok(Some(answer));
                    }
                    let order = inner.value(&closure.body, None)?;
                    inner.call_implied(path, [order], Type::BOOL, site).map(Some)
                })
            }
            _ => self.answered_of_two(op, order, site),
        }
    }

    fn answered_of_two(&mut self, op: Op, order: &tree::Expr, site: Site) -> Result<Option<Expr>> {
        let (compared, or_equal) = match self.builtin_call(order) {
            // The author takes two values without an order for equal.
            Some((Builtin::Option(OptionMethod::UnwrapOr), [partial, other])) if matches!(&other.kind, Tree::Path(_, name) if name.ends_with("Equal")) => {
                (partial, true)
            }
            _ => (order, false),
        };
        let Some((function, [one, other])) = self.called(compared) else { return Ok(None) };
        let is = |op| {
            let kind = Tree::Binary(op, Box::new(one.clone()), Box::new(other.clone()));
            tree::Expr::plain(kind, site)
        };
        let not = |expr| tree::Expr::plain(Tree::Unary(tree::UnaryOp::Not, Box::new(expr)), site);
        let answer = match (bare(&function.path), or_equal, op) {
            (COMPARE, false, op) | (PARTIAL, true, op @ (Op::Lt | Op::Gt)) => is(op),
            (PARTIAL, true, Op::Le) => not(is(Op::Gt)),
            (PARTIAL, true, Op::Ge) => not(is(Op::Lt)),
            (TOTAL, false, Op::Lt | Op::Le | Op::Gt | Op::Ge) => {
                let turned = matches!(op, Op::Gt | Op::Le);
                let below = function.callees.iter().find_map(|callee| match callee {
                    Callee::Function(path) if bare(path) == BELOW => Some(path.as_str()),
                    _ => None,
                });
                let moves = !turned || self.is_calm(one) && self.is_calm(other);
                let Some(below) = below.filter(|_| moves) else { return Ok(None) };
                let id = self.function_at(below, site)?;
                let pair = if turned { [other, one] } else { [one, other] }.map(Clone::clone);
                let answer = self.call_function(id, &pair, order)?;
                let answers = matches!(op, Op::Lt | Op::Gt);
                return Ok(Some(if answers { answer } else { answer.negated() }));
            }
            _ => return Ok(None),
        };
        self.value(&answer, Some(&Type::BOOL)).map(Some)
    }

    /// Returns true if an expression may be evaluated before an earlier one, since it has no effect and cannot fault.
    fn is_calm(&self, expr: &tree::Expr) -> bool {
        let is_float = || {
            let ty = self.seen_as(expr);
            matches!(ty, Some(Ty::Scalar(Scalar::Float(_))))
        };
        match &expr.kind {
            Tree::Local(_) | Tree::Float(..) => true,
            Tree::Ref(_, inner) | Tree::Deref(inner) | Tree::Field(inner, _) => self.is_calm(inner),
            Tree::Binary(_, one, other) => is_float() && self.is_calm(one) && self.is_calm(other),
            Tree::Call(..) => match self.builtin_call(expr) {
                Some((Builtin::Scalar(_), of)) => {
                    is_float() && of.iter().all(|it| self.is_calm(it))
                }
                _ => false,
            },
            _ => false,
        }
    }
}
