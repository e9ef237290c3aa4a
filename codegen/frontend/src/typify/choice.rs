//! Lowering of `match`: a `switch` if the arms name few values, else a chain of conditions.

use std::borrow::Cow;

use bessemer_ir::tree::visit::Walk;
use bessemer_ir::tree::{self, NO_SLOT, Pattern, Site};
use bessemer_ir::{
    Arm, Block, Expr, ExprKind, Int, LocalId, LogicOp, Scalar, Span, StmtKind, StructId, Type,
};

use super::conditions::has_let;
use super::frames::Target;
use super::lowering::Lowering;
use super::pattern::Test;
use super::subject::taken_name;
use super::syntax::alternatives;
use super::value::Value;
use super::{Result, problem, refusals, refused};

/// Largest number of values that an arm lists; one with more is a range.
const LISTED: usize = 8;

/// Condition of an arm, if it has one, and its body.
type Branch = (Option<Expr>, Block);

/// The values that an arm matches; none: all that no earlier arm matches.
type Words = Option<Vec<i128>>;

/// An alternative of an arm. Guard and body stay in the tree: a copy at each level of nested arms would cost the square of
/// their depth.
struct Case<'t> {
    pattern: Cow<'t, Pattern>,
    arm: &'t tree::Arm,
}

impl<'t> Case<'t> {
    fn whole(arm: &'t tree::Arm) -> Case<'t> {
        Case { pattern: Cow::Borrowed(&arm.pattern), arm }
    }
}

impl Lowering<'_, '_> {
    /// Lowers `match`, and assigns its value to `target` if there is one.
    pub(super) fn match_stmt(
        &mut self,
        site: Site,
        scrutinee: &tree::Expr,
        arms: &[tree::Arm],
        target: Option<&Target>,
    ) -> Result<()> {
        let span = self.span(site);
        let arms = reachable(arms);
        let whole: Vec<Case> = arms.iter().map(Case::whole).collect();
        let subject = match &scrutinee.kind {
            tree::ExprKind::Tuple(_) => Some(self.subject(scrutinee)?),
            _ => self.lent(scrutinee)?,
        };
        if let Some(subject) = subject {
            return self.subject_arms((subject, scrutinee), arms, target, span);
        }
        let value = self.value(scrutinee, None)?;
        if !arms.iter().any(|arm| has_names(&arm.pattern))
            && value.ty.is_word()
            && let Some(listed) = self.listed(&value.ty, &whole)?
        {
            return self.listed_arms((value, listed), &whole, span, |inner, case| {
                inner.lowered(&case.arm.body, target)
            });
        }
        let before = self.locals.len();
        let mut subject = self.value_subject(value);
        if let Some(name) = arms.iter().find_map(|arm| taken_name(&arm.pattern)) {
            self.name_held(&subject, before, &name);
        }
        if let Value::Place(place) = &mut subject
            && place.ty.is_word()
            && !place.steps.is_empty()
            && let Some((name, slot)) = arms.iter().find_map(|arm| named_whole(&arm.pattern))
            && !self.slot_is_reference(slot, site)?
            && self.listed(&place.ty, &whole)?.is_none()
        {
            // The conditions look at it by its name.
            *place = self.hold_copy(name, place.clone());
        }
        self.subject_arms((subject, scrutinee), arms, target, span)
    }

    /// Lowers arms that destructure a value: a `switch` if they name numbers or variants of one enum, else a chain of
    /// conditions.
    fn subject_arms(
        &mut self,
        (mut subject, scrutinee): (Value, &tree::Expr),
        arms: &[tree::Arm],
        target: Option<&Target>,
        span: Span,
    ) -> Result<()> {
        // Of a number each alternative gives the same name.
        let is_word = matches!(&subject, Value::Place(place) if place.ty.is_word());
        let cases: Vec<Case> = match is_word {
            true => arms.iter().map(Case::whole).collect(),
            false => arms.iter().flat_map(spread).collect(),
        };
        if let Value::Place(place) = &subject
            && let Some(listed) = self.listed(&place.ty, &cases)?
        {
            let of = match place.ty {
                Type::Struct(id) => self.part(place, id, 0),
                _ => place.clone(),
            };
            return self.listed_arms((of.load(), listed), &cases, span, |inner, case| {
                inner.bind_pattern(&case.pattern, &subject, case.arm.site)?;
                inner.lowered(&case.arm.body, target)
            });
        }
        // The later arms and the guard's own names must not see what a guard writes to what a part was copied from.
        // rustc refuses a guard that writes the matched place itself.
        if !is_place(scrutinee) {
            let guards = arms.iter().filter_map(|arm| arm.guard.as_ref());
            subject = self.beside_later(subject, scrutinee, guards);
        }
        self.arms_by_conditions(&cases, span, None, &|inner, case, last| {
            let test = inner.arm_test(case, &subject, last)?;
            let then = inner.scoped(|inner| {
                let before = inner.locals.len() as u32;
                inner.bind_names(&test.names)?;
                if case.arm.guard.is_some() {
                    // A name may be the guard's alone.
                    let names = before..inner.locals.len() as u32;
                    names.for_each(|name| inner.locals.note_optional(LocalId(name)));
                }
                inner.lowered(&case.arm.body, target)
            })?;
            Ok((test.condition, then))
        })
    }

    /// Returns the condition under which an arm is taken, including its guard.
    fn arm_test(&mut self, case: &Case, subject: &Value, last: bool) -> Result<Test> {
        let mut test = self.test(&case.pattern, subject, case.arm.site)?;
        let guard = case.arm.guard.as_ref();
        match last && !guard.is_some_and(has_let) {
            true => test.condition = None,
            false => self.guard(&mut test, guard, None)?,
        }
        Ok(test)
    }

    /// Adds a guard to the test of a pattern, whose names are aliases of their places in it. `site` is the site of
    /// the whole `match` if it is not the guard's.
    pub(super) fn guard(
        &mut self,
        test: &mut Test,
        guard: Option<&tree::Expr>,
        site: Option<Site>,
    ) -> Result<()> {
        let Some(guard) = guard else { return Ok(()) };
        self.alias_names(&test.names);
        if has_let(guard) {
            // Its names are those of the arm, too.
            let mut names = Vec::new();
            let before = test.condition.take();
            test.condition = Some(match before {
                Some(before) => {
                    let guarded =
                        |inner: &mut Self, names: &mut _| inner.pattern_condition(guard, names);
                    self.logic_and(before, &mut names, guarded)?
                }
                None => self.pattern_condition(guard, &mut names)?,
            });
            test.names.extend(names);
            return Ok(());
        }
        let asked = |inner: &mut Self| inner.value(guard, Some(&Type::BOOL));
        let span = self.span(site.unwrap_or(guard.site));
        test.condition = Some(match test.condition.take() {
            Some(test) => self.short_circuit(LogicOp::And, test, span, asked)?,
            None => asked(self)?,
        });
        Ok(())
    }

    /// Lowers arms as a chain of conditions; `taken` returns the condition and the body of one. The last arm has no
    /// condition. If only one arm `stays`, its body follows the others, all of which leave.
    pub(super) fn arms_by_conditions<A>(
        &mut self,
        arms: &[A],
        span: Span,
        stays: Option<&dyn Fn(&A) -> bool>,
        taken: &dyn Fn(&mut Self, &A, bool) -> Result<Branch>,
    ) -> Result<()> {
        let Some((arm, rest)) = arms.split_first() else { return Ok(()) };
        let (condition, then) = self.naming_scope(|inner| taken(inner, arm, rest.is_empty()))?;
        let Some(condition) = condition else {
            self.out.extend(then.0);
            return Ok(());
        };
        let otherwise = self.scoped(|inner| inner.arms_by_conditions(rest, span, stays, taken))?;
        let (condition, then, Block(behind)) = match stays.map(|stays| stays(arm)) {
            None => {
                self.branch(condition, then, otherwise, span);
                return Ok(());
            }
            Some(true) => (condition.negated(), otherwise, then),
            Some(false) => (condition, then, otherwise),
        };
        let span = condition.span;
        self.branch(condition, then, Block::default(), span);
        self.out.extend(behind);
        Ok(())
    }

    /// Returns the cases of a `switch`, and the block for all other values. An earlier arm has priority, as in Rust.
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

    /// Lowers arms with listed values: a `switch`, or an `if` for a value with two cases.
    fn listed_arms(
        &mut self,
        (of, listed): (Expr, Vec<Words>),
        named: &[Case],
        span: Span,
        lower: impl Fn(&mut Self, &Case) -> Result<()>,
    ) -> Result<()> {
        let (mut cases, mut otherwise) = self.cases(listed.into_iter().zip(named), lower)?;
        let two = cases.iter().map(|case| case.values.len()).sum::<usize>() == 2;
        if of.ty == Type::BOOL && two || otherwise.is_none() && of.ty.as_int().is_some() {
            // The arms name every value: the last takes what is left.
            otherwise = cases.pop().map(|case| case.body);
        }
        if of.ty != Type::BOOL && !cases.is_empty() {
            self.emit(StmtKind::Match { scrutinee: of, arms: cases, otherwise }, span);
            return Ok(());
        }
        let otherwise = otherwise.unwrap_or_default();
        let Some(Arm { values, body }) = cases.pop() else {
            self.evaluated(of);
            self.out.extend(otherwise.0);
            return Ok(());
        };
        let (then, otherwise) = match values.contains(&1) {
            true => (body, otherwise),
            false => (otherwise, body),
        };
        self.emit(StmtKind::If { condition: of, then, otherwise }, span);
        Ok(())
    }

    /// Returns the values that each arm matches, of a number or of an enum's tag. Returns none if an arm has a guard,
    /// matches a payload, or has many values.
    fn listed(&mut self, of: &Type, cases: &[Case]) -> Result<Option<Vec<Words>>> {
        let mut listed = Vec::new();
        for Case { pattern, arm } in cases {
            listed.push(match &**pattern {
                _ if arm.guard.is_some() => return Ok(None),
                pattern if takes_all(pattern) => None,
                pattern => match self.words(pattern, of, arm.site)? {
                    Some(words) if words.len() <= LISTED => Some(words),
                    _ => return Ok(None),
                },
            });
        }
        Ok(Some(listed))
    }

    /// Returns the values that a pattern matches; none if it matches a payload, or many values.
    fn words(&mut self, pattern: &Pattern, of: &Type, site: Site) -> Result<Option<Vec<i128>>> {
        let named = |name: &str, id| Some(self.case(id, name)?.0);
        let word = match (pattern, of) {
            // Conditions name the constants of names; the cases of a `switch` would be numbers.
            _ if self.cx.is_name(of) => return Ok(None),
            (Pattern::Or(cases), _) => {
                let words = cases.iter().map(|case| self.words(case, of, site));
                let words = words.collect::<Result<Option<Vec<_>>>>()?;
                return Ok(words.map(|words| words.concat()));
            }
            (Pattern::Name { inner: Some(inner), .. }, _) => return self.words(inner, of, site),
            (_, Type::Struct(id)) if self.is_tagged(*id) => match pattern {
                Pattern::Value(value) => self.unit_word(value, *id),
                Pattern::Constructor(name, parts) if parts.iter().all(takes_all) => {
                    named(name, *id)
                }
                Pattern::Fields(name, fields) if fields.iter().all(|(_, it)| takes_all(it)) => {
                    named(name, *id)
                }
                _ => None,
            },
            (_, Type::Scalar(Scalar::Int(_) | Scalar::Bool) | Type::Enum(_)) => {
                let (low, high) = self.range(pattern, of, site)?;
                return Ok((high - low < LISTED as i128).then(|| (low..=high).collect()));
            }
            _ => None,
        };
        Ok(word.map(|word| vec![word.into()]))
    }

    /// Returns true if a struct represents an enum with payload, and its first field is the tag.
    fn is_tagged(&self, id: StructId) -> bool {
        !self.cx.known_of(id).cases.is_empty() && matches!(self.cx.field_type(id, 0), Type::Enum(_))
    }

    /// Returns the least and the greatest number that a pattern matches.
    pub(super) fn range(
        &mut self,
        pattern: &Pattern,
        ty: &Type,
        site: Site,
    ) -> Result<(i128, i128)> {
        let whole = match ty {
            Type::Scalar(Scalar::Int(int)) => (Int::min(*int), Int::max(*int)),
            Type::Enum(_) | Type::Scalar(Scalar::Bool) => (0, i128::from(u32::MAX)),
            _ => return refused(site, refusals::MATCHED),
        };
        match pattern {
            Pattern::Value(value) => {
                let value = self.pattern_value(value, ty)?;
                Ok((value, value))
            }
            Pattern::Constructor(name, parts) if parts.is_empty() => {
                let word = self.variant_word(name, ty, site)?;
                Ok((word, word))
            }
            Pattern::Range { from, to, inclusive } => {
                let from = from.as_ref().map(|from| self.pattern_value(from, ty));
                let to = to.as_ref().map(|to| self.pattern_value(to, ty));
                let last = match to.transpose()? {
                    Some(to) if *inclusive => to,
                    Some(to) => to - 1,
                    None => whole.1,
                };
                Ok((from.transpose()?.unwrap_or(whole.0), last))
            }
            _ => refused(site, refusals::NUMBER_PATTERN),
        }
    }

    /// Returns the word of a variant without payload.
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

/// Splits an arm with names inside `|` into an arm for each alternative.
fn spread(arm: &tree::Arm) -> Vec<Case<'_>> {
    let patterns = alternatives(&arm.pattern).into_iter();
    patterns.map(|pattern| Case { pattern: Cow::Owned(pattern), arm }).collect()
}

/// Returns the name that a pattern binds to the whole value, and its slot.
fn named_whole(pattern: &Pattern) -> Option<(&str, u32)> {
    match pattern {
        Pattern::Name { name, slot, .. } if *slot != NO_SLOT => Some((name, *slot)),
        _ => None,
    }
}

fn has_names(pattern: &Pattern) -> bool {
    !pattern.bound().is_empty()
}

/// Returns true for a pattern that matches every value of any type: `_`, a name, or tuples and `|` of these.
pub(super) fn takes_all(pattern: &Pattern) -> bool {
    match pattern {
        Pattern::Any | Pattern::Rest => true,
        Pattern::Name { inner, .. } => inner.as_deref().is_none_or(takes_all),
        Pattern::Tuple(parts) => parts.iter().all(takes_all),
        Pattern::Or(cases) => cases.iter().any(takes_all),
        _ => false,
    }
}

/// Returns the arms that can be reached: an arm after one that matches everything cannot, nor can a guard among final
/// arms.
pub(super) fn reachable(arms: &[tree::Arm]) -> &[tree::Arm] {
    let all = |arm: &tree::Arm| takes_all(&arm.pattern) && arm.guard.is_none();
    let end = arms.iter().position(all).map_or(arms.len(), |last| last + 1);
    let last = arms[..end].iter().rposition(|arm| arm.guard.is_none());
    &arms[..last.map_or(0, |last| last + 1)]
}

/// Returns true if an expression denotes a place, and no value that is computed for the `match`.
fn is_place(expr: &tree::Expr) -> bool {
    use tree::ExprKind::{Deref, Field, Index, Local, Ref};
    matches!(expr.kind, Local(_) | Field(..) | Index(..) | Deref(_) | Ref(..))
}
