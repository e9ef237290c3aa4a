//! `match`: a list of cases where the arms name few values, else conditions one after the other.

use bessemer_ir::tree::{self, NO_SLOT, Site};
use bessemer_ir::{
    Arm, Block, Expr, ExprKind, Int, LogicOp, Mode, Place, Scalar, Span, StmtKind, StructId, Type,
};

use super::conditions::within;
use super::lowering::{Lowering, Target};
use super::value::Value;
use super::words;
use super::{Result, problem};

/// An arm with more values than this is told by their ends.
const LISTED: i128 = 8;

/// The values that an arm takes, as ranges with both ends; empty: every one.
type Ranges = Vec<(i128, i128)>;

/// An arm of a `match` on a number.
struct Taken<'t> {
    arm: &'t tree::Arm,
    /// The name that it gives to the value, and whether that may be assigned.
    binding: Option<(&'t str, bool)>,
    ranges: Ranges,
}

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
        if let tree::ExprKind::Tuple(_) = &scrutinee.kind {
            let subject = self.subject(scrutinee)?;
            return self.subject_arms(&subject, arms, target, site);
        }
        if let Some(subject) = self.lent(scrutinee)? {
            return self.subject_arms(&subject, arms, target, site);
        }
        let mut value = self.value(scrutinee, None)?;
        let by_number = value.ty.is_word() && !matches!(value.ty, Type::Scalar(Scalar::Float(_)));
        if !by_number || self.lends_the_whole(arms)? {
            let before = self.locals.len();
            let subject = self.value_subject(value);
            self.name_held(&subject, before, arms.iter().map(|arm| &arm.pattern));
            return self.subject_arms(&subject, arms, target, site);
        }
        let mut taken: Vec<Taken<'_>> = Vec::new();
        for arm in arms {
            let (binding, patterns) = split(&arm.pattern);
            let ranges = self.ranges(patterns, &value.ty, arm.site)?;
            taken.push(Taken { arm, binding, ranges });
        }
        let name = taken.iter().find_map(|taken| taken.binding).map(|(name, _)| name);
        let guarded = arms.iter().any(|arm| arm.guard.is_some());
        let wide = |taken: &Taken<'_>| {
            taken.ranges.iter().map(|(low, high)| high - low + 1).sum::<i128>() > LISTED
        };
        let chained = guarded || taken.iter().any(wide);
        if name.is_some() || chained && !is_still(&value) {
            value = self.let_local(name.unwrap_or(words::SELECTOR), value).load();
        }
        if chained {
            let Block(stmts) = self.scoped(|inner| inner.chain(&value, &taken, target, span))?;
            self.out.extend(stmts);
            return Ok(());
        }
        self.cases(value, &taken, target, span)
    }

    /// Whether an arm has a name through which all that is matched can be written.
    fn lends_the_whole(&self, arms: &[tree::Arm]) -> Result<bool> {
        for arm in arms {
            if let tree::Pattern::Name { slot, .. } = &arm.pattern
                && *slot != NO_SLOT
                && self.slot_is_exclusive(*slot, arm.site)?
            {
                return Ok(true);
            }
        }
        Ok(false)
    }

    /// Arms without guards, of few values each.
    fn cases(
        &mut self,
        scrutinee: Expr,
        arms: &[Taken<'_>],
        target: Option<&Target>,
        span: Span,
    ) -> Result<()> {
        let mut lowered: Vec<Arm> = Vec::new();
        let mut otherwise = None;
        for taken in arms {
            let ranges = &taken.ranges;
            let body = self.scoped(|inner| {
                inner.name(taken, &scrutinee);
                inner.arm(taken, target)
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
        if scrutinee.ty == Type::BOOL {
            self.match_bool(scrutinee, lowered, otherwise, span);
            return Ok(());
        }
        self.emit(StmtKind::Match { scrutinee, arms: lowered, otherwise }, span);
        Ok(())
    }

    /// Arms as conditions; the last takes what is left.
    fn chain(
        &mut self,
        value: &Expr,
        arms: &[Taken<'_>],
        target: Option<&Target>,
        span: Span,
    ) -> Result<()> {
        let Some((taken, rest)) = arms.split_first() else { return Ok(()) };
        let (condition, then) = self.naming_scope(|inner| {
            inner.name(taken, value);
            let condition = match rest {
                [] => None,
                _ => inner.condition(value, &taken.ranges, taken.arm.guard.as_ref(), span)?,
            };
            Ok((condition, inner.scoped(|inner| inner.arm(taken, target))?))
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

    /// The condition of an arm, if there is one.
    fn condition(
        &mut self,
        value: &Expr,
        ranges: &Ranges,
        guard: Option<&tree::Expr>,
        span: Span,
    ) -> Result<Option<Expr>> {
        let tests = ranges.iter().map(|range| within(value, *range, span));
        let pattern = tests.reduce(|one, other| Expr::logic(LogicOp::Or, one, other).at(span));
        match (pattern, guard) {
            (Some(pattern), Some(guard)) => {
                self.short_circuit(LogicOp::And, pattern, guard, guard.site).map(Some)
            }
            (None, Some(guard)) => self.value(guard, Some(&Type::BOOL)).map(Some),
            (pattern, None) => Ok(pattern),
        }
    }

    /// The author's name for what is matched.
    fn name(&mut self, taken: &Taken<'_>, value: &Expr) {
        if let (Some((name, _)), ExprKind::Load(place)) = (taken.binding, &value.kind) {
            self.bind(name, Value::Place(place.clone()));
        }
    }

    /// The body of an arm.
    fn arm(&mut self, taken: &Taken<'_>, target: Option<&Target>) -> Result<()> {
        if let Some((name, true)) = taken.binding {
            // Assigned, it is a copy of its own.
            let value = self.named(name, taken.arm.site)?;
            let span = value.span;
            let local = self.declare(name, value.ty.clone(), Mode::Value, span);
            self.emit(StmtKind::Let { local, value: Some(value) }, span);
        }
        self.lowered(&taken.arm.body, target)
    }

    /// Arms that take a value apart: a list of cases where they name the variants of one enum, else
    /// conditions one after the other.
    fn subject_arms(
        &mut self,
        subject: &Value,
        arms: &[tree::Arm],
        target: Option<&Target>,
        site: Site,
    ) -> Result<()> {
        let arms: Vec<tree::Arm> = arms.iter().flat_map(spread).collect();
        if let Value::Place(place) = subject
            && self.variant_cases(place, &arms, target, site)?
        {
            return Ok(());
        }
        let Block(stmts) =
            self.scoped(|inner| inner.subject_chain(subject, &arms, target, site))?;
        self.out.extend(stmts);
        Ok(())
    }

    fn subject_chain(
        &mut self,
        subject: &Value,
        arms: &[tree::Arm],
        target: Option<&Target>,
        site: Site,
    ) -> Result<()> {
        let span = self.span(site);
        let Some((arm, rest)) = arms.split_first() else { return Ok(()) };
        let (condition, then) = self.naming_scope(|inner| {
            let mut names = Vec::new();
            let test = inner.test(&arm.pattern, subject, arm.site, &mut names)?;
            let condition = match (rest, test, &arm.guard) {
                ([], ..) => None,
                (_, test, None) => test,
                (_, test, Some(guard)) => {
                    inner.alias_names(&names);
                    Some(match test {
                        Some(test) => inner.short_circuit(LogicOp::And, test, guard, guard.site)?,
                        None => inner.value(guard, Some(&Type::BOOL))?,
                    })
                }
            };
            let then = inner.scoped(|inner| {
                inner.bind_names(&names)?;
                inner.lowered(&arm.body, target)
            })?;
            // A name may be the guard's alone.
            Ok((condition, if arm.guard.is_some() { super::pattern::used(then) } else { then }))
        })?;
        match condition {
            None => self.out.extend(then.0),
            Some(condition) => {
                let otherwise =
                    self.scoped(|inner| inner.subject_chain(subject, rest, target, site))?;
                self.branch(condition, then, otherwise, span);
            }
        }
        Ok(())
    }

    /// Arms that name the variants of an enum with payload, and nothing within; false if they do more.
    fn variant_cases(
        &mut self,
        place: &Place,
        arms: &[tree::Arm],
        target: Option<&Target>,
        site: Site,
    ) -> Result<bool> {
        let Type::Struct(id) = place.ty else { return Ok(false) };
        if self.cx.known_of(id).cases.is_empty() {
            return Ok(false);
        }
        let tag = self.part(place, id, 0);
        let words: Option<Vec<_>> = arms.iter().map(|arm| self.words(arm, id)).collect();
        let (Type::Enum(_), Some(words)) = (&tag.ty, words) else { return Ok(false) };
        let subject = Value::Place(place.clone());
        let (mut cases, mut otherwise) = (Vec::<Arm>::new(), None);
        for (arm, words) in arms.iter().zip(words) {
            let body = self.scoped(|inner| {
                inner.bind_pattern(&arm.pattern, &subject, arm.site)?;
                inner.lowered(&arm.body, target)
            })?;
            let Some(mut values) = words else {
                otherwise = Some(body);
                break;
            };
            values.retain(|word| !cases.iter().any(|case| case.values.contains(word)));
            if !values.is_empty() {
                cases.push(Arm { values, body });
            }
        }
        let span = self.span(site);
        match (cases.is_empty(), otherwise) {
            (true, Some(Block(all))) => self.out.extend(all),
            (_, otherwise) => {
                let scrutinee = tag.load();
                self.emit(StmtKind::Match { scrutinee, arms: cases, otherwise }, span);
            }
        }
        Ok(true)
    }

    /// The variants that an arm takes, whatever they hold: none inside for all; none if it looks within.
    fn words(&self, arm: &tree::Arm, id: StructId) -> Option<Option<Vec<i128>>> {
        if arm.guard.is_some() {
            return None;
        }
        if takes_all(&arm.pattern) {
            return Some(None);
        }
        let mut words = Vec::new();
        self.variant_words(&arm.pattern, id, &mut words).then_some(Some(words))
    }

    fn variant_words(&self, pattern: &tree::Pattern, id: StructId, words: &mut Vec<i128>) -> bool {
        let free = |part: &tree::Pattern| matches!(part, tree::Pattern::Rest) || takes_all(part);
        let named = |name: &str| self.case(id, name).map(|(word, _)| word);
        let word = match pattern {
            tree::Pattern::Or(cases) => {
                return cases.iter().all(|case| self.variant_words(case, id, words));
            }
            tree::Pattern::Value(value) => self.unit_word(value, id),
            tree::Pattern::Constructor(name, parts) if parts.iter().all(free) => named(name),
            tree::Pattern::Fields(name, fields) if fields.iter().all(|(_, it)| free(it)) => {
                named(name)
            }
            _ => None,
        };
        let Some(word) = word else { return false };
        if !words.contains(&i128::from(word)) {
            words.push(i128::from(word));
        }
        true
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

    pub(super) fn ranges<'p>(
        &mut self,
        patterns: impl IntoIterator<Item = &'p tree::Pattern>,
        ty: &Type,
        site: Site,
    ) -> Result<Ranges> {
        let mut patterns = patterns.into_iter().peekable();
        let whole = match ty {
            Type::Scalar(Scalar::Int(int)) => (Int::min(*int), Int::max(*int)),
            Type::Enum(_) | Type::Scalar(Scalar::Bool) => (0, i128::from(u32::MAX)),
            _ if patterns.peek().is_none() => return Ok(Vec::new()),
            _ => {
                return problem(
                    site,
                    "`match` compares integers, `bool` and enums in the DSL",
                    "compare with `if`",
                );
            }
        };
        let mut ranges = Vec::new();
        for pattern in patterns {
            ranges.push(match pattern {
                tree::Pattern::Value(value) => {
                    let value = self.pattern_value(value, ty)?;
                    (value, value)
                }
                tree::Pattern::Constructor(name, parts) if parts.is_empty() => {
                    let word = self.variant_word(name, ty, site)?;
                    (word, word)
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
                _ => {
                    return problem(
                        site,
                        "this pattern is not one of a number",
                        "give values, ranges, a name or `_`",
                    );
                }
            });
        }
        Ok(ranges)
    }

    /// The word of a variant without payload.
    fn variant_word(&self, name: &str, ty: &Type, site: Site) -> Result<i128> {
        let variants = match ty {
            Type::Enum(id) => self.cx.module.enums[id.index()].variants.as_slice(),
            _ => &[],
        };
        match variants.iter().position(|variant| variant.name == name) {
            Some(index) => Ok(index as i128),
            None => problem(
                site,
                format!("`{name}` is not a variant of this"),
                "give a constant a name in capitals",
            ),
        }
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

/// The name that a pattern of a number gives it, and the patterns of its values; none: every one.
fn split(pattern: &tree::Pattern) -> (Option<(&str, bool)>, Vec<&tree::Pattern>) {
    match pattern {
        tree::Pattern::Any => (None, Vec::new()),
        tree::Pattern::Name { name, mutable, inner, .. } => {
            let values = inner.as_deref().map(|inner| split(inner).1).unwrap_or_default();
            (Some((name, *mutable)), values)
        }
        tree::Pattern::Or(cases) => {
            let cases: Vec<_> = cases.iter().map(|case| split(case).1).collect();
            // `1 | _` is `_`.
            let any = cases.iter().any(Vec::is_empty);
            (None, if any { Vec::new() } else { cases.concat() })
        }
        other => (None, vec![other]),
    }
}

/// An arm with names inside `|` as an arm for each.
fn spread(arm: &tree::Arm) -> Vec<tree::Arm> {
    match &arm.pattern {
        tree::Pattern::Or(cases) if cases.iter().any(has_names) => cases
            .iter()
            .map(|pattern| tree::Arm { pattern: pattern.clone(), ..arm.clone() })
            .collect(),
        _ => vec![arm.clone()],
    }
}

fn has_names(pattern: &tree::Pattern) -> bool {
    match pattern {
        tree::Pattern::Name { .. } => true,
        tree::Pattern::Or(parts) | tree::Pattern::Tuple(parts) | tree::Pattern::Array(parts) => {
            parts.iter().any(has_names)
        }
        tree::Pattern::Constructor(_, parts) => parts.iter().any(has_names),
        tree::Pattern::Fields(_, fields) => fields.iter().any(|(_, part)| has_names(part)),
        _ => false,
    }
}

/// Whether a pattern takes every value, whatever it is of.
fn takes_all(pattern: &tree::Pattern) -> bool {
    match pattern {
        tree::Pattern::Any => true,
        tree::Pattern::Name { inner, .. } => inner.as_deref().is_none_or(takes_all),
        tree::Pattern::Or(cases) => cases.iter().any(takes_all),
        _ => false,
    }
}

/// The arms that can be reached: what follows one that takes everything is never tried, nor a guard
/// behind arms that take everything between them.
fn reachable(arms: &[tree::Arm]) -> &[tree::Arm] {
    let all = |arm: &tree::Arm| takes_all(&arm.pattern) && arm.guard.is_none();
    let end = arms.iter().position(all).map_or(arms.len(), |last| last + 1);
    let last = arms[..end].iter().rposition(|arm| arm.guard.is_none());
    &arms[..last.map_or(0, |last| last + 1)]
}

/// Whether a value can be read again, and is the same while the arms are tried.
fn is_still(value: &Expr) -> bool {
    matches!(&value.kind, ExprKind::Load(place) if place.steps.iter().all(super::order::is_fixed))
}
