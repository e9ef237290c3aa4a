//! Lowers conditions: with patterns (`if let Some(x) = … && x > 0`), with `&&` whose right side needs statements, and
//! range tests. An `Ordering` that is tested at once, `a.cmp(&b).is_lt()`, becomes `a < b`.

use bessemer_ir::tree::{
    self, BinaryOp as Op, Builtin, Callee, ExprKind as Tree, NO_SLOT, OptionMethod, Site, Ty,
};
use bessemer_ir::{
    Block, CompareOp, Expr, ExprKind, LogicOp, Scalar, Span, Stmt, StmtKind, Type, UnaryOp,
};

use super::Result;
use super::lowering::Lowering;
use super::value::{Named, Value};

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
fn without_arguments(path: &str) -> &str {
    path.split('<').next().unwrap_or(path)
}

impl Lowering<'_, '_> {
    /// Lowers a condition with patterns, whose names are aliases of their places from here on.
    pub(super) fn pattern_condition(
        &mut self,
        expr: &tree::Expr,
        names: &mut Vec<Named>,
    ) -> Result<Expr> {
        match &expr.kind {
            Tree::Let(pattern, value) => {
                let subject = self.subject_of(pattern, value)?;
                let test = self.test(pattern, &subject, expr.site)?;
                self.alias_names(&test.names);
                names.extend(test.names);
                Ok(test.condition.unwrap_or_else(|| Expr::bool(true, self.span(expr.site))))
            }
            Tree::Binary(tree::BinaryOp::LogicAnd, left, right) if has_let(expr) => {
                let left = self.pattern_condition(left, names)?;
                self.logic_and(left, names, |inner, names| inner.further_condition(right, names))
            }
            _ => self.value(expr, Some(&Type::BOOL)),
        }
    }

    /// Lowers the next condition of a chain; earlier conditions bound `names`. A name with a value keeps it, whatever the
    /// condition writes.
    pub(super) fn further_condition(
        &mut self,
        expr: &tree::Expr,
        names: &mut Vec<Named>,
    ) -> Result<Expr> {
        let mut parts = Vec::new();
        for named in names.iter().filter(|it| it.slot != NO_SLOT) {
            if let Value::Slice(_) = named.stands
                && !self.slot_is_reference(named.slot, named.site)?
            {
                parts.push(named.slot);
            }
        }
        self.copy_names(names, |named| named.mutable || parts.contains(&named.slot))?;
        for named in names.iter_mut().filter(|it| it.slot != NO_SLOT) {
            let Value::Place(place) = &named.stands else { continue };
            if self.is_borrowed(named, place)? || !self.slot_is_reference(named.slot, named.site)? {
                let (name, place) = (&named.name, place.clone());
                let copy = self.naming_as("", |inner| inner.copied_place(name, place));
                named.stands = Value::Place(copy);
            }
        }
        self.alias_names(names);
        self.pattern_condition(expr, names)
    }

    /// Emits the branches of a pattern, or only the branch that constant lengths select.
    pub(super) fn branch(&mut self, condition: Expr, then: Block, otherwise: Block, span: Span) {
        match decided(&condition) {
            Some(true) => self.out.extend(then.0),
            Some(false) => self.out.extend(otherwise.0),
            None => self.emit(StmtKind::If { condition, then, otherwise }, span),
        }
    }

    /// Lowers `&&` and `||`. Statements of the right side run only if it is evaluated.
    pub(super) fn short_circuit(
        &mut self,
        op: LogicOp,
        left: Expr,
        span: Span,
        right: impl FnOnce(&mut Self) -> Result<Expr>,
    ) -> Result<Expr> {
        let (right, inner) = self.in_block(right)?;
        let (right, inner) = self.joined(right, inner, &mut []);
        match inner.is_empty() {
            true => Ok(Expr::logic(op, left, right).at(span)),
            false => Ok(self.right_behind(op, left, right, inner)),
        }
    }

    /// Lowers a logic operation whose right side needs statements, with a temporary for its result. The `if` tests the
    /// left side itself, so that the passes know that it holds.
    fn right_behind(&mut self, op: LogicOp, left: Expr, right: Expr, mut inner: Vec<Stmt>) -> Expr {
        let span = left.span;
        let place = self.assigned("holds", Expr::bool(op == LogicOp::Or, span));
        self.locals.note_unnamed(place.root);
        let held = place.load();
        inner.push(Stmt::new(StmtKind::Assign { place, value: right }, span));
        let condition = match op {
            LogicOp::And => left,
            LogicOp::Or => left.negated(),
        };
        self.emit_if(condition, Block(inner), span);
        held
    }

    /// Lowers `left && right` so that `names`, which later code uses, denote the locals that the right side declares.
    pub(super) fn logic_and(
        &mut self,
        left: Expr,
        names: &mut Vec<Named>,
        right: impl FnOnce(&mut Self, &mut Vec<Named>) -> Result<Expr>,
    ) -> Result<Expr> {
        let (right, inner) = self.in_block(|inner| right(inner, names))?;
        let (right, inner) = self.joined(right, inner, names);
        if inner.is_empty() {
            return Ok(Expr::logic(LogicOp::And, left, right));
        }
        if left.kind == ExprKind::Literal(1) {
            self.out.extend(inner);
            return Ok(right);
        }
        let kept = self.declared_first(inner, names);
        Ok(self.right_behind(LogicOp::And, left, right, kept))
    }
}

/// Returns true if a condition contains a pattern.
pub(super) fn has_let(expr: &tree::Expr) -> bool {
    match &expr.kind {
        Tree::Let(..) => true,
        Tree::Binary(tree::BinaryOp::LogicAnd, left, right) => has_let(left) || has_let(right),
        _ => false,
    }
}

/// Returns the truth of a condition that literals decide.
pub(super) fn decided(condition: &Expr) -> Option<bool> {
    let number = |expr: &Expr| match (&expr.kind, expr.ty.as_int()) {
        (ExprKind::Literal(word), Some(int)) => Some(int.from_word(*word)),
        _ => None,
    };
    match &condition.kind {
        ExprKind::Literal(word) => Some(*word != 0),
        ExprKind::Unary(UnaryOp::Not, operand) => decided(operand).map(|holds| !holds),
        ExprKind::Logic(op, left, right) => match (op, decided(left)?) {
            (LogicOp::And, true) | (LogicOp::Or, false) => decided(right),
            (_, left) => Some(left),
        },
        ExprKind::Compare(op, left, right) => {
            let order = number(left)?.cmp(&number(right)?);
            Some(match op {
                CompareOp::Eq => order.is_eq(),
                CompareOp::Ne => order.is_ne(),
                CompareOp::Lt => order.is_lt(),
                CompareOp::Le => order.is_le(),
                CompareOp::Gt => order.is_gt(),
                CompareOp::Ge => order.is_ge(),
            })
        }
        _ => None,
    }
}

/// Returns `low <= value && value <= high` without the comparisons that the value's type makes redundant.
pub(super) fn within(value: &Expr, (low, high): (i128, i128), span: Span) -> Expr {
    if value.ty == Type::BOOL {
        let not = Expr::unary(UnaryOp::Not, value.clone()).at(span);
        return if low == 1 { value.clone() } else { not };
    }
    let compare = |op, limit: i128| {
        Expr::compare(op, value.clone(), Expr::literal_like(limit as u64, value)).at(span)
    };
    let (least, most) = value.ty.as_int().map_or((-1, i128::MAX), |int| (int.min(), int.max()));
    match (low == least, high == most) {
        _ if low == high => compare(CompareOp::Eq, low),
        (true, true) => Expr::bool(true, span),
        (true, false) => compare(CompareOp::Le, high),
        (false, true) => compare(CompareOp::Ge, low),
        (false, false) => {
            let (above, below) = (compare(CompareOp::Ge, low), compare(CompareOp::Le, high));
            Expr::logic(LogicOp::And, above, below)
        }
    }
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
        let answer = match (without_arguments(&function.path), or_equal, op) {
            (COMPARE, false, op) | (PARTIAL, true, op @ (Op::Lt | Op::Gt)) => is(op),
            (PARTIAL, true, Op::Le) => not(is(Op::Gt)),
            (PARTIAL, true, Op::Ge) => not(is(Op::Lt)),
            (TOTAL, false, Op::Lt | Op::Le | Op::Gt | Op::Ge) => {
                let turned = matches!(op, Op::Gt | Op::Le);
                let below = function.callees.iter().find_map(|callee| match callee {
                    Callee::Function(path) if without_arguments(path) == BELOW => {
                        Some(path.as_str())
                    }
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
