//! `match`: a list of cases where the arms name few values, else conditions one after the other.

use bessemer_ir::tree::{self, Site};
use bessemer_ir::{
    Arm, Block, CompareOp, Expr, ExprKind, Int, Local, LocalId, LogicOp, Mode, Place, Scalar, Span,
    StmtKind, Type, UnaryOp,
};

use super::function::{Lowering, Target};
use super::{Result, problem};

/// An arm with more values than this is told by their ends.
const LISTED: i128 = 8;

/// The values that an arm takes, as ranges with both ends; empty: every one.
type Ranges = Vec<(i128, i128)>;

impl Lowering<'_, '_> {
    /// `match`, its value to `target` if one is wanted.
    pub(super) fn match_stmt(
        &mut self,
        site: Site,
        scrutinee: &tree::Expr,
        arms: &[tree::Arm],
        target: Option<&Target>,
    ) -> Result<()> {
        let span = self.span(site);
        let arms = reachable(arms);
        let name = arms.iter().find_map(|arm| arm.binding.as_ref()).map(|(name, _)| name.as_str());
        let guarded = arms.iter().any(|arm| arm.guard.is_some());
        let mut value = self.value(scrutinee, None)?;
        let mut taken: Vec<(&tree::Arm, Ranges)> = Vec::new();
        for arm in arms {
            taken.push((arm, self.ranges(arm, &value.ty)?));
        }
        let wide = |(_, ranges): &(_, Ranges)| {
            ranges.iter().map(|(low, high)| high - low + 1).sum::<i128>() > LISTED
        };
        let chained = guarded || taken.iter().any(wide);
        if name.is_some() || chained && !is_still(&value) {
            value = self.held(name.unwrap_or("selector"), value);
        }
        if chained {
            let Block(stmts) = self.scoped(|inner| inner.chain(&value, &taken, target, span))?;
            self.out.extend(stmts);
            return Ok(());
        }
        self.cases(value, &taken, target, span)
    }

    /// A local that holds what is matched.
    fn held(&mut self, name: &str, value: Expr) -> Expr {
        let (ty, span) = (value.ty.clone(), value.span);
        let local = LocalId(self.locals.len() as u32);
        self.locals.push(Local { name: name.into(), ty: ty.clone(), mode: Mode::Value, span });
        self.emit(StmtKind::Let { local, value: Some(value) }, span);
        let place = Place { root: local, steps: Vec::new(), ty: ty.clone(), span };
        Expr { kind: ExprKind::Load(place), ty, span }
    }

    /// Arms without guards, of few values each.
    fn cases(
        &mut self,
        scrutinee: Expr,
        arms: &[(&tree::Arm, Ranges)],
        target: Option<&Target>,
        span: Span,
    ) -> Result<()> {
        let mut lowered: Vec<Arm> = Vec::new();
        let mut otherwise = None;
        for (arm, ranges) in arms {
            let body = self.scoped(|inner| {
                inner.name(arm, &scrutinee);
                inner.arm(arm, target)
            })?;
            let values = ranges.iter().flat_map(|(low, high)| *low..=*high);
            // Earlier arms win, in Rust and so here.
            let mut seen = std::collections::BTreeSet::new();
            let values: Vec<i128> = values
                .filter(|value| !lowered.iter().any(|arm| arm.values.contains(value)))
                // `1 | 1` is Rust, with a warning.
                .filter(|value| seen.insert(*value))
                .collect();
            if ranges.is_empty() {
                otherwise = Some(body);
            } else if !values.is_empty() {
                lowered.push(Arm { values, body });
            }
        }
        if scrutinee.ty == Type::BOOL {
            self.match_bool(scrutinee, lowered, otherwise, span);
            return Ok(());
        }
        if otherwise.is_none() && scrutinee.ty.as_int().is_some() {
            // The arms name every value: the last takes what is left.
            otherwise = lowered.pop().map(|arm| arm.body);
        }
        if lowered.is_empty() {
            if !is_still(&scrutinee) {
                self.emit(StmtKind::Expr(scrutinee), span);
            }
            self.out.extend(otherwise.unwrap_or_default().0);
            return Ok(());
        }
        self.emit(StmtKind::Match { scrutinee, arms: lowered, otherwise }, span);
        Ok(())
    }

    /// Arms as conditions; the last takes what is left.
    fn chain(
        &mut self,
        value: &Expr,
        arms: &[(&tree::Arm, Ranges)],
        target: Option<&Target>,
        span: Span,
    ) -> Result<()> {
        let Some(((arm, ranges), rest)) = arms.split_first() else { return Ok(()) };
        let (condition, then) = self.naming_scope(|inner| {
            inner.name(arm, value);
            let condition = match rest {
                [] => None,
                _ => inner.condition(value, ranges, arm.guard.as_ref(), span)?,
            };
            Ok((condition, inner.scoped(|inner| inner.arm(arm, target))?))
        })?;
        match condition {
            None => self.out.extend(then.0),
            Some(condition) => {
                let otherwise = self.scoped(|inner| inner.chain(value, rest, target, span))?;
                self.emit(StmtKind::If { condition, then, otherwise }, span);
            }
        }
        Ok(())
    }

    /// What must hold for an arm; none if nothing must.
    fn condition(
        &mut self,
        value: &Expr,
        ranges: &Ranges,
        guard: Option<&tree::Expr>,
        span: Span,
    ) -> Result<Option<Expr>> {
        let tests = ranges.iter().map(|range| test(value, *range, span));
        let pattern = tests.reduce(|one, other| {
            let kind = ExprKind::Logic(LogicOp::Or, Box::new(one), Box::new(other));
            Expr { kind, ty: Type::BOOL, span }
        });
        match (pattern, guard) {
            (Some(pattern), Some(guard)) => {
                self.short_circuit(LogicOp::And, pattern, guard, guard.site).map(Some)
            }
            (None, Some(guard)) => self.value(guard, Some(&Type::BOOL)).map(Some),
            (pattern, None) => Ok(pattern),
        }
    }

    /// The author's name for what is matched.
    fn name(&mut self, arm: &tree::Arm, value: &Expr) {
        if let (Some((name, _)), ExprKind::Load(place)) = (&arm.binding, &value.kind) {
            self.alias_to(name, place.clone());
        }
    }

    /// The body of an arm.
    fn arm(&mut self, arm: &tree::Arm, target: Option<&Target>) -> Result<()> {
        if let Some((name, true)) = &arm.binding {
            // Assigned, it is a copy of its own.
            let value = self.named(name, arm.body.site)?;
            let span = value.span;
            let local = self.declare(name, value.ty.clone(), Mode::Value, span);
            self.emit(StmtKind::Let { local, value: Some(value) }, span);
        }
        match (target, &arm.body.kind) {
            (Some(target), _) => self.into(&arm.body, target),
            // The arm is a block already.
            (None, tree::ExprKind::Block(block)) => {
                let Block(stmts) = self.block_effect(block)?;
                self.out.extend(stmts);
                Ok(())
            }
            (None, _) => self.effect(&arm.body),
        }
    }

    fn match_bool(
        &mut self,
        condition: Expr,
        arms: Vec<Arm>,
        otherwise: Option<Block>,
        span: Span,
    ) {
        let mut arms: Vec<(bool, Block)> =
            arms.into_iter().map(|arm| (arm.values.contains(&1), arm.body)).collect();
        let mut take = |wanted: bool| {
            arms.iter().position(|(value, _)| *value == wanted).map(|index| arms.remove(index).1)
        };
        let (then, els) = (take(true), take(false));
        let otherwise = otherwise.unwrap_or_default();
        let then = then.unwrap_or_else(|| otherwise.clone());
        let els = els.unwrap_or(otherwise);
        self.emit(StmtKind::If { condition, then, otherwise: els }, span);
    }

    fn ranges(&mut self, arm: &tree::Arm, ty: &Type) -> Result<Ranges> {
        let whole = match ty {
            Type::Scalar(Scalar::Int(int)) => (Int::min(*int), Int::max(*int)),
            Type::Enum(_) | Type::Scalar(Scalar::Bool) => (0, i128::from(u32::MAX)),
            _ if arm.patterns.is_empty() => return Ok(Vec::new()),
            _ => {
                return problem(
                    arm.body.site,
                    "`match` takes integers and plain enums in the DSL",
                    "compare with `if`",
                );
            }
        };
        let mut ranges = Vec::new();
        for pattern in &arm.patterns {
            ranges.push(match pattern {
                tree::Pattern::Value(value) => {
                    let value = self.pattern_value(value, ty)?;
                    (value, value)
                }
                tree::Pattern::Range { from, to, inclusive } => {
                    let from = from.as_ref().map(|from| self.pattern_value(from, ty));
                    let to = to.as_ref().map(|to| self.pattern_value(to, ty));
                    let last = match to.transpose()? {
                        Some(to) if *inclusive => to,
                        Some(to) => to - 1,
                        None => whole.1,
                    };
                    (from.transpose()?.unwrap_or(whole.0), last)
                }
            });
        }
        Ok(ranges)
    }

    fn pattern_value(&mut self, pattern: &tree::Expr, ty: &Type) -> Result<i128> {
        let literal = self.value(pattern, Some(ty))?;
        self.agree(&literal.ty, ty, pattern.site)?;
        let word = match &literal.kind {
            ExprKind::Literal(word) => *word,
            ExprKind::Const(id) => self.cx.module.consts[id.index()].words[0],
            _ => 0,
        };
        Ok(match ty.as_int() {
            Some(int) => int.from_word(word),
            None => Int::U64.from_word(word),
        })
    }
}

/// The arms that can be reached: what follows one that takes everything is never tried, nor a guard
/// behind arms that take everything between them.
fn reachable(arms: &[tree::Arm]) -> &[tree::Arm] {
    let all = |arm: &tree::Arm| arm.patterns.is_empty() && arm.guard.is_none();
    let end = arms.iter().position(all).map_or(arms.len(), |last| last + 1);
    let last = arms[..end].iter().rposition(|arm| arm.guard.is_none());
    &arms[..last.map_or(0, |last| last + 1)]
}

/// Whether a value can be read again, and is the same while the arms are tried.
fn is_still(value: &Expr) -> bool {
    matches!(&value.kind, ExprKind::Load(place) if place.steps.iter().all(super::place::is_fixed))
}

/// `low <= value && value <= high`, or what is left of it.
fn test(value: &Expr, (low, high): (i128, i128), span: Span) -> Expr {
    let boolean = |kind| Expr { kind, ty: Type::BOOL, span };
    if value.ty == Type::BOOL {
        let not = ExprKind::Unary(UnaryOp::Not, Box::new(value.clone()));
        return if low == 1 { value.clone() } else { boolean(not) };
    }
    let limit = |limit: i128| Expr {
        kind: ExprKind::Literal(limit as u64),
        ty: value.ty.clone(),
        span: value.span,
    };
    let compare =
        |op, other| boolean(ExprKind::Compare(op, Box::new(value.clone()), Box::new(limit(other))));
    let (least, most) = value.ty.as_int().map_or((-1, i128::MAX), |int| (int.min(), int.max()));
    match (low == least, high == most) {
        _ if low == high => compare(CompareOp::Eq, low),
        (true, true) => boolean(ExprKind::Literal(1)),
        (true, false) => compare(CompareOp::Le, high),
        (false, true) => compare(CompareOp::Ge, low),
        (false, false) => {
            let (above, below) = (compare(CompareOp::Ge, low), compare(CompareOp::Le, high));
            boolean(ExprKind::Logic(LogicOp::And, Box::new(above), Box::new(below)))
        }
    }
}
