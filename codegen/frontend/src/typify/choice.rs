//! `match`: a list of cases where the arms name few values, else conditions one after the other.

use std::cell::RefCell;

use bessemer_ir::tree::visit::Walk;
use bessemer_ir::tree::{self, NO_SLOT, Pattern, Site};
use bessemer_ir::{
    Arm, Block, Expr, ExprKind, Int, LogicOp, Place, Scalar, Span, StmtKind, StructId, Type,
};

use super::conditions::within_any;
use super::lowering::{Lowering, Target};
use super::pattern::Test;
use super::subject::taken_name;
use super::value::Value;
use super::words;
use super::{Result, problem};
use bessemer_ir::effects;

/// An arm with more values than this is told by their ends.
const LISTED: i128 = 8;

/// The values that an arm takes, as ranges with both ends; empty: every one.
pub(super) type Ranges = Vec<(i128, i128)>;

/// An arm of a `match` on a number.
struct Taken<'t> {
    arm: &'t tree::Arm,
    /// The name that it gives to the value, and whether that may be assigned.
    binding: Option<(&'t str, bool)>,
    ranges: Ranges,
}

/// The condition of an arm, if it has one, and its body.
type Branch = (Option<Expr>, Block);

/// The values that an arm takes; none: every one that is left.
type Words = Option<Vec<i128>>;

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
        let subject = match &scrutinee.kind {
            tree::ExprKind::Tuple(_) => Some(self.subject(scrutinee)?),
            _ => self.lent(scrutinee)?,
        };
        if let Some(subject) = subject {
            return self.subject_arms((subject, scrutinee), arms, target, span);
        }
        let value = self.value(scrutinee, None)?;
        let by_number = value.ty.is_word()
            && !matches!(value.ty, Type::Scalar(Scalar::Float(_)))
            && !arms.iter().any(|arm| names_twice(&arm.pattern));
        if by_number && !self.lends_the_whole(arms)? {
            return self.number_arms((value, scrutinee), arms, target, span);
        }
        let before = self.locals.len();
        let subject = self.value_subject(value);
        if let Some(name) = arms.iter().find_map(|arm| taken_name(&arm.pattern)) {
            self.name_held(&subject, before, name);
        }
        self.subject_arms((subject, scrutinee), arms, target, span)
    }

    /// Whether an arm has a name through which all that is matched can be written.
    fn lends_the_whole(&self, arms: &[tree::Arm]) -> Result<bool> {
        for arm in arms {
            if let Some(slot) = slot_of_whole(&arm.pattern)
                && slot != NO_SLOT
                && self.slot_is_exclusive(slot, arm.site)?
            {
                return Ok(true);
            }
        }
        Ok(false)
    }

    /// Arms that compare a number: a list of cases, unless one has a guard or takes many values.
    fn number_arms(
        &mut self,
        (mut value, scrutinee): (Expr, &tree::Expr),
        arms: &[tree::Arm],
        target: Option<&Target>,
        span: Span,
    ) -> Result<()> {
        let mut taken: Vec<Taken<'_>> = Vec::new();
        for arm in arms {
            let (binding, patterns) = split(&arm.pattern);
            let ranges = self.ranges(patterns, &value.ty, arm.site)?;
            taken.push(Taken { arm, binding, ranges });
        }
        let name = taken.iter().find_map(|taken| taken.binding).map(|(name, _)| name);
        let wide = |taken: &Taken<'_>| {
            taken.ranges.iter().map(|(low, high)| high - low + 1).sum::<i128>() > LISTED
        };
        let chained = arms.iter().any(|arm| arm.guard.is_some()) || taken.iter().any(wide);
        let still = is_still(&value) && is_place(scrutinee);
        if name.is_some() || chained && !still {
            value = self.let_local(name.unwrap_or(words::SELECTOR), value).load();
        }
        if chained {
            return self.chain(&taken, span, &|inner, taken, last| {
                inner.name(taken, &value);
                let mut test = Test::default();
                if !last {
                    test.condition = within_any(&value, &taken.ranges, span);
                    inner.guard(&mut test, taken.arm.guard.as_ref(), None)?;
                }
                Ok((test.condition, inner.scoped(|inner| inner.arm(taken, target))?))
            });
        }
        let values = |taken: &Taken<'_>| {
            let values = taken.ranges.iter().flat_map(|(low, high)| *low..=*high);
            (!taken.ranges.is_empty()).then(|| values.collect())
        };
        let listed = taken.iter().map(|taken| (values(taken), taken));
        let (mut cases, mut otherwise) = self.cases(listed, |inner, taken| {
            inner.name(taken, &value);
            inner.arm(taken, target)
        })?;
        let both = value.ty == Type::BOOL
            && cases.iter().map(|case| case.values.len()).sum::<usize>() == 2;
        if both || otherwise.is_none() && value.ty.as_int().is_some() {
            // The arms name every value: the last takes what is left.
            otherwise = cases.pop().map(|case| case.body);
        }
        if cases.is_empty() && !is_still(&value) {
            self.emit(StmtKind::Expr(value.clone()), span);
        }
        self.emit_cases(value, cases, otherwise, span);
        Ok(())
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
            let place = self.let_local(name, value);
            self.note_changing(place.root, NO_SLOT);
            self.bind(name, Value::Local(place.root));
        }
        self.lowered(&taken.arm.body, target)
    }

    /// Arms that take a value apart: a list of cases where they name the variants of one enum, else
    /// conditions one after the other.
    fn subject_arms(
        &mut self,
        (mut subject, scrutinee): (Value, &tree::Expr),
        arms: &[tree::Arm],
        target: Option<&Target>,
        span: Span,
    ) -> Result<()> {
        let arms: Vec<tree::Arm> = arms.iter().flat_map(spread).collect();
        if let Some((tag, listed)) = self.variants(&subject, &arms) {
            let (cases, otherwise) = self.cases(listed.into_iter().zip(&arms), |inner, arm| {
                inner.bind_pattern(&arm.pattern, &subject, arm.site)?;
                inner.lowered(&arm.body, target)
            })?;
            self.emit_cases(tag, cases, otherwise, span);
            return Ok(());
        }
        let open = self.lenders.open();
        let (written, stmts) =
            self.apart(|inner| inner.subject_chain(&subject, &arms, target, span))?;
        let mark = self.out.len();
        self.copy_subject(&mut subject, scrutinee, &written);
        if self.out.len() == mark {
            self.out.extend(stmts);
            return Ok(());
        }
        // A guard writes what the subject was computed from: the arms are lowered anew, and look at a copy.
        self.lenders.forget(open);
        self.subject_chain(&subject, &arms, target, span).map(drop)
    }

    /// Arms as conditions; gives what their guards write.
    fn subject_chain(
        &mut self,
        subject: &Value,
        arms: &[tree::Arm],
        target: Option<&Target>,
        span: Span,
    ) -> Result<Vec<Place>> {
        let written = RefCell::new(Vec::new());
        self.chain(arms, span, &|inner, arm, last| {
            let mut test = inner.test(&arm.pattern, subject, arm.site)?;
            let mark = inner.out.len();
            match last {
                true => test.condition = None,
                false => inner.guard(&mut test, arm.guard.as_ref(), None)?,
            }
            let mut written = written.borrow_mut();
            written.extend(effects::writes(&inner.out[mark..]));
            written.extend(test.condition.iter().flat_map(effects::lent));
            drop(written);
            let then = inner.scoped(|inner| {
                inner.bind_names(&test.names)?;
                inner.lowered(&arm.body, target)
            })?;
            // A name may be the guard's alone.
            Ok((
                test.condition,
                if arm.guard.is_some() { super::pattern::used(then) } else { then },
            ))
        })?;
        Ok(written.into_inner())
    }

    /// Adds a guard to the test of a pattern, whose names stand for their places in it; `site`: where the whole stands, if
    /// not at the guard.
    pub(super) fn guard(
        &mut self,
        test: &mut Test,
        guard: Option<&tree::Expr>,
        site: Option<Site>,
    ) -> Result<()> {
        let Some(guard) = guard else { return Ok(()) };
        self.alias_names(&test.names);
        let asked = |inner: &mut Self| inner.value(guard, Some(&Type::BOOL));
        let span = self.span(site.unwrap_or(guard.site));
        test.condition = Some(match test.condition.take() {
            Some(test) => self.short_circuit(LogicOp::And, test, span, asked)?,
            None => asked(self)?,
        });
        Ok(())
    }

    /// Arms as conditions, one after the other; `taken` gives the condition and the body of one. The last takes what is
    /// left.
    fn chain<A>(
        &mut self,
        arms: &[A],
        span: Span,
        taken: &dyn Fn(&mut Self, &A, bool) -> Result<Branch>,
    ) -> Result<()> {
        let Some((arm, rest)) = arms.split_first() else { return Ok(()) };
        let (condition, then) = self.naming_scope(|inner| taken(inner, arm, rest.is_empty()))?;
        let Some(condition) = condition else {
            self.out.extend(then.0);
            return Ok(());
        };
        let otherwise = self.scoped(|inner| inner.chain(rest, span, taken))?;
        self.branch(condition, then, otherwise, span);
        Ok(())
    }

    /// A list of cases, and what takes all that is left. Earlier arms win, in Rust and so here.
    fn cases<A>(
        &mut self,
        arms: impl Iterator<Item = (Words, A)>,
        lower: impl Fn(&mut Self, A) -> Result<()>,
    ) -> Result<(Vec<Arm>, Option<Block>)> {
        let mut cases: Vec<Arm> = Vec::new();
        for (words, arm) in arms {
            let body = self.scoped(|inner| lower(inner, arm))?;
            let Some(words) = words else { return Ok((cases, Some(body))) };
            let mut values = Vec::new();
            for word in words {
                // `1 | 1` is Rust, with a warning.
                if !values.contains(&word) && !cases.iter().any(|it| it.values.contains(&word)) {
                    values.push(word);
                }
            }
            if !values.is_empty() {
                cases.push(Arm { values, body });
            }
        }
        Ok((cases, None))
    }

    fn emit_cases(&mut self, of: Expr, mut cases: Vec<Arm>, otherwise: Option<Block>, span: Span) {
        if of.ty != Type::BOOL && !cases.is_empty() {
            self.emit(StmtKind::Match { scrutinee: of, arms: cases, otherwise }, span);
            return;
        }
        let otherwise = otherwise.unwrap_or_default();
        let Some(Arm { values, body }) = cases.pop() else {
            self.out.extend(otherwise.0);
            return;
        };
        let (then, otherwise) = match values.contains(&1) {
            true => (body, otherwise),
            false => (otherwise, body),
        };
        self.emit(StmtKind::If { condition: of, then, otherwise }, span);
    }

    /// The tag of an enum with payload, and the variants that each arm takes, whatever they hold; none if an arm looks within.
    fn variants(&self, subject: &Value, arms: &[tree::Arm]) -> Option<(Expr, Vec<Words>)> {
        let Value::Place(place) = subject else { return None };
        let Type::Struct(id) = place.ty else { return None };
        if self.cx.known_of(id).cases.is_empty() {
            return None;
        }
        let words = |arm: &tree::Arm| match &arm.pattern {
            _ if arm.guard.is_some() => None,
            pattern if takes_all(pattern) => Some(None),
            pattern => self.variant_words(pattern, id).map(Some),
        };
        let tag = self.part(place, id, 0);
        let listed = arms.iter().map(words).collect::<Option<_>>()?;
        matches!(tag.ty, Type::Enum(_)).then(|| (tag.load(), listed))
    }

    fn variant_words(&self, pattern: &Pattern, id: StructId) -> Option<Vec<i128>> {
        let free = |part: &Pattern| matches!(part, Pattern::Rest) || takes_all(part);
        let named = |name: &str| self.case(id, name).map(|(word, _)| word);
        let word = match pattern {
            Pattern::Or(cases) => {
                let words = cases.iter().map(|case| self.variant_words(case, id));
                return words.collect::<Option<Vec<_>>>().map(|words| words.concat());
            }
            Pattern::Value(value) => self.unit_word(value, id),
            Pattern::Constructor(name, parts) if parts.iter().all(free) => named(name),
            Pattern::Fields(name, fields) if fields.iter().all(|(_, it)| free(it)) => named(name),
            _ => None,
        };
        Some(vec![word?.into()])
    }

    pub(super) fn ranges<'p>(
        &mut self,
        patterns: impl IntoIterator<Item = &'p Pattern>,
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
                Pattern::Value(value) => {
                    let value = self.pattern_value(value, ty)?;
                    (value, value)
                }
                Pattern::Constructor(name, parts) if parts.is_empty() => {
                    let word = self.variant_word(name, ty, site)?;
                    (word, word)
                }
                Pattern::Range { from, to, inclusive } => {
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
fn split(pattern: &Pattern) -> (Option<(&str, bool)>, Vec<&Pattern>) {
    match pattern {
        Pattern::Any => (None, Vec::new()),
        Pattern::Name { name, mutable, inner, .. } => {
            let values = inner.as_deref().map(|inner| split(inner).1).unwrap_or_default();
            (Some((name, *mutable)), values)
        }
        Pattern::Or(cases) => {
            // `x @ 1 | x @ 2`: each gives the same name.
            let binding = cases.first().and_then(|case| split(case).0);
            let cases: Vec<_> = cases.iter().map(|case| split(case).1).collect();
            // `1 | _` is `_`.
            let any = cases.iter().any(Vec::is_empty);
            (binding, if any { Vec::new() } else { cases.concat() })
        }
        other => (None, vec![other]),
    }
}

/// The slot of the name that a pattern gives to all that is matched.
fn slot_of_whole(pattern: &Pattern) -> Option<u32> {
    match pattern {
        Pattern::Name { slot, .. } => Some(*slot),
        Pattern::Or(cases) => cases.first().and_then(slot_of_whole),
        _ => None,
    }
}

/// Whether a pattern binds two names to one number: `x @ (y @ 1)`.
fn names_twice(pattern: &Pattern) -> bool {
    match pattern {
        Pattern::Name { inner, .. } => inner.as_deref().is_some_and(has_names),
        Pattern::Or(cases) => cases.iter().any(names_twice),
        _ => false,
    }
}

/// An arm with names inside `|` as an arm for each.
fn spread(arm: &tree::Arm) -> Vec<tree::Arm> {
    let arms = alternatives(&arm.pattern).into_iter();
    arms.map(|pattern| tree::Arm { pattern, ..arm.clone() }).collect()
}

/// The patterns that a pattern with names inside `|` stands for, in the order in which Rust tries them.
fn alternatives(pattern: &Pattern) -> Vec<Pattern> {
    // The parts beside each other: each case of the first with each of the rest.
    let all = |parts: &[Pattern]| {
        parts.iter().fold(vec![Vec::new()], |before: Vec<Vec<Pattern>>, part| {
            let next = |before: &Vec<Pattern>| {
                let each = alternatives(part).into_iter();
                each.map(|case| [&before[..], &[case]].concat()).collect::<Vec<_>>()
            };
            before.iter().flat_map(next).collect()
        })
    };
    match pattern {
        Pattern::Or(each) if each.iter().any(has_names) => {
            each.iter().flat_map(alternatives).collect()
        }
        Pattern::Name { name, slot, mutable, inner: Some(inner) } => {
            let named = |inner| Pattern::Name {
                name: name.clone(),
                slot: *slot,
                mutable: *mutable,
                inner: Some(Box::new(inner)),
            };
            alternatives(inner).into_iter().map(named).collect()
        }
        Pattern::Tuple(parts) => all(parts).into_iter().map(Pattern::Tuple).collect(),
        Pattern::Array(parts) => all(parts).into_iter().map(Pattern::Array).collect(),
        Pattern::Constructor(name, parts) => {
            all(parts).into_iter().map(|parts| Pattern::Constructor(name.clone(), parts)).collect()
        }
        Pattern::Fields(name, fields) => {
            let (names, parts): (Vec<_>, Vec<_>) = fields.iter().cloned().unzip();
            let fields = |parts| names.iter().cloned().zip::<Vec<_>>(parts).collect();
            all(&parts).into_iter().map(|it| Pattern::Fields(name.clone(), fields(it))).collect()
        }
        other => vec![other.clone()],
    }
}

fn has_names(pattern: &Pattern) -> bool {
    !pattern.bound().is_empty()
}

/// Whether a pattern takes every value, whatever it is of.
fn takes_all(pattern: &Pattern) -> bool {
    match pattern {
        Pattern::Any => true,
        Pattern::Name { inner, .. } => inner.as_deref().is_none_or(takes_all),
        Pattern::Or(cases) => cases.iter().any(takes_all),
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

/// Whether an expression is a place. Rust refuses a guard that assigns to the place that is matched.
fn is_place(expr: &tree::Expr) -> bool {
    use tree::ExprKind as Tree;
    match &expr.kind {
        Tree::Field(inner, _) | Tree::Index(inner, _) => is_place(inner),
        Tree::Local(_) | Tree::Deref(_) | Tree::Ref(..) => true,
        _ => false,
    }
}
