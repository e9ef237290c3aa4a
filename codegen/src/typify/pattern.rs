//! Patterns: what has to hold for a value to be taken, and what its names stand for.
//!
//! A name of a reference is another name for the place. A name of a value is a copy, made where the arm
//! (or the `let`) begins; before that, in a guard, it is another name too.
//!
//! A payload is looked at only behind the test that it is there.

use bessemer_ir::tree::{self, NO_SLOT, Site};
use bessemer_ir::{
    Block, CompareOp, Expr, ExprKind, LogicOp, Mode, Place, Scalar, Step, Stmt, StmtKind, StructId,
    Type,
};

use super::closure_args::is_hidden;
use super::conditions::{within, within_any};
use super::generic::Case;
use super::lowering::Lowering;
use super::order::is_settled;
use super::value::{Named, Value};
use super::{OUR_FAULT, Result, problem};
use crate::effects;

impl Lowering<'_, '_> {
    /// The subject of a `match` or a `let`, computed once.
    pub(super) fn subject(&mut self, expr: &tree::Expr) -> Result<Value> {
        // One that rustc saw as a whole is matched by a name.
        if let (tree::ExprKind::Tuple(parts), None) = (&expr.kind, expr.slot)
            && !parts.is_empty()
        {
            let mut subjects: Vec<Value> = Vec::new();
            for part in parts {
                let next = self.settling(
                    |inner| inner.subject(part),
                    |inner, _, later| {
                        subjects.iter_mut().for_each(|it| inner.settle_subject(it, later));
                    },
                )?;
                subjects.push(next);
            }
            return Ok(Value::Tuple(subjects, None));
        }
        if let tree::ExprKind::Apply(name, arguments) = &expr.kind
            && self.stands_here(expr)
        {
            return self.applied(name, arguments, expr.site, |inner, closure| {
                inner.subject(&closure.body)
            });
        }
        if let Some(parts) = self.parts_named(expr) {
            return Ok(parts);
        }
        if let Some(part) = self.submatrix(expr)? {
            return Ok(Value::Submatrix(Box::new(part)));
        }
        if let Some(lent) = self.lent(expr)? {
            return Ok(lent);
        }
        // A number that is written out is of the type that rustc saw.
        let expected = match expr.slot.and_then(|slot| self.source.slots.get(slot as usize)) {
            Some(tree::Ty::Scalar(scalar)) => Some(Type::Scalar(*scalar)),
            _ => None,
        };
        let value = self.value(expr, expected.as_ref())?;
        Ok(self.value_subject(value))
    }

    /// The same of a pattern; a value that has to be held has the name of what the pattern takes from it.
    pub(super) fn subject_of(
        &mut self,
        pattern: &tree::Pattern,
        expr: &tree::Expr,
    ) -> Result<Value> {
        let before = self.locals.len();
        let subject = self.subject(expr)?;
        self.name_held(&subject, before, std::iter::once(pattern));
        Ok(subject)
    }

    /// Names the temporary that a subject is held in, if it is none of the locals `before`.
    pub(super) fn name_held<'t>(
        &mut self,
        subject: &Value,
        before: usize,
        mut patterns: impl Iterator<Item = &'t tree::Pattern>,
    ) {
        if let Value::Place(place) = subject
            && place.root.index() >= before
            && place.steps.is_empty()
            && self.held.contains(&place.root)
            && let Some(name) = patterns.find_map(taken_name)
        {
            self.locals[place.root.index()].name = name.to_owned();
        }
    }

    /// The same, its value known.
    pub(super) fn value_subject(&mut self, value: Expr) -> Value {
        if value.ty == Type::Unit {
            self.discard(value);
            return Value::Nothing;
        }
        let mut place = self.hold(value);
        // Its indices are checked also where no pattern comes to read it.
        self.fix(&mut place);
        Value::Place(place)
    }

    /// Copies what the statements to come could change.
    fn settle_subject(&mut self, subject: &mut Value, later: &[Stmt]) {
        match subject {
            Value::Tuple(parts, _) => {
                parts.iter_mut().for_each(|part| self.settle_subject(part, later));
            }
            Value::Place(place) => {
                let value = place.load();
                if !later.is_empty() && !is_settled(&value, later) {
                    *place = self.temporary_place("selector", value);
                }
            }
            // Another name for what is there, whatever becomes of it.
            _ => {}
        }
    }

    /// The condition for `pattern` to take the subject, if there is one; its names go to `names`.
    pub(super) fn test(
        &mut self,
        pattern: &tree::Pattern,
        subject: &Value,
        site: Site,
        names: &mut Vec<Named>,
    ) -> Result<Option<Expr>> {
        match (pattern, subject) {
            (tree::Pattern::Any | tree::Pattern::Rest, _) => Ok(None),
            (_, Value::Nothing) => {
                Self::take_nothing(pattern, site, names);
                Ok(None)
            }
            (_, Value::Place(place)) => self.test_place(pattern, place, site, names),
            (tree::Pattern::Name { name, slot, inner: None, .. }, Value::Submatrix(_)) => {
                names.push(Named::of(name, *slot, subject.clone(), site));
                Ok(None)
            }
            (tree::Pattern::Or(cases), _) => self.test_any(cases, subject, site, names),
            (_, Value::Slice(slice)) => self.test_slice(pattern, slice, site, names),
            (_, Value::Maybe(there, lent)) => self.test_maybe(pattern, (there, lent), site, names),
            (tree::Pattern::Tuple(patterns), Value::Tuple(parts, _)) => {
                let pairs = aligned(patterns, parts.len()).into_iter();
                self.test_all(pairs.map(|(it, index)| (it, parts[index].clone())), site, names)
            }
            (
                tree::Pattern::Name { name, slot, mutable: false, inner: None },
                Value::Tuple(parts, _),
            ) if is_hidden(name) || self.source.tree.role == tree::Role::Expanded => {
                // One that lends to be changed has no type of its own, and is only taken apart.
                let ty = if *slot == NO_SLOT { None } else { self.slot(*slot, site).ok() };
                names.push(Named::of(name, *slot, Value::Tuple(parts.clone(), ty), site));
                Ok(None)
            }
            _ => problem(
                site,
                "a tuple that is written out is matched part by part",
                "give it a name first: `let pair = (a, b);`",
            ),
        }
    }

    fn test_any(
        &mut self,
        cases: &[tree::Pattern],
        subject: &Value,
        site: Site,
        names: &mut Vec<Named>,
    ) -> Result<Option<Expr>> {
        let before = names.len();
        let mut any: Option<Expr> = None;
        for case in cases {
            let next = self.test(case, subject, site, names)?;
            if names.len() > before {
                return problem(
                    site,
                    "names inside `|` stand for different places",
                    "write an arm for each",
                );
            }
            let Some(next) = next else { return Ok(None) };
            any = Some(match any {
                Some(any) => Expr::logic(LogicOp::Or, any, next),
                None => next,
            });
        }
        Ok(any)
    }

    /// The condition for all patterns to take their parts.
    fn test_all<'p>(
        &mut self,
        parts: impl IntoIterator<Item = (&'p tree::Pattern, Value)>,
        site: Site,
        names: &mut Vec<Named>,
    ) -> Result<Option<Expr>> {
        let mut all = None;
        for (pattern, part) in parts {
            all = both(all, self.test(pattern, &part, site, names)?);
        }
        Ok(all)
    }

    /// A number or a range of floats, which is compared as by `==` and `<=`.
    fn test_float(&mut self, pattern: &tree::Pattern, place: &Place) -> Result<Option<Expr>> {
        let bounds = match pattern {
            tree::Pattern::Range { from, to, inclusive } => {
                let most = if *inclusive { CompareOp::Le } else { CompareOp::Lt };
                vec![(CompareOp::Ge, from.as_ref()), (most, to.as_ref())]
            }
            tree::Pattern::Value(number) => vec![(CompareOp::Eq, Some(number))],
            _ => Vec::new(),
        };
        let mut all = None;
        for (op, number) in bounds {
            if let Some(number) = number {
                let number = self.value(number, Some(&place.ty))?;
                all = both(all, Some(Expr::compare(op, place.load(), number).at(place.span)));
            }
        }
        Ok(all)
    }

    fn test_place(
        &mut self,
        pattern: &tree::Pattern,
        place: &Place,
        site: Site,
        names: &mut Vec<Named>,
    ) -> Result<Option<Expr>> {
        use tree::Pattern as P;
        match (pattern, &place.ty) {
            (P::Any | P::Rest, _) => Ok(None),
            _ if let Some(element) = self.element_lent(place, site)? => {
                self.test_place(pattern, &element, site, names)
            }
            (P::Array(_), _) if let Some(slice) = self.slice_at(place.clone(), site)? => {
                self.test_slice(pattern, &slice, site, names)
            }
            (P::Array(_), Type::Array { .. }) if let Some(slice) = self.all_of(place.clone()) => {
                self.test_slice(pattern, &slice, site, names)
            }
            (P::Name { name, slot, mutable, inner }, _) => {
                let (name, slot, mutable) = (name.clone(), *slot, *mutable);
                let stands = Value::Place(place.clone());
                names.push(Named { name, slot, mutable, stands, site });
                match inner {
                    Some(inner) => self.test_place(inner, place, site, names),
                    None => Ok(None),
                }
            }
            (P::Or(cases), _) => self.test_any(cases, &Value::Place(place.clone()), site, names),
            (P::Tuple(_), Type::Struct(_)) => {
                let parts = self.inner_patterns(pattern, place, false, site)?;
                self.test_all(parts, site, names)
            }
            (P::Constructor(name, _) | P::Fields(name, _), Type::Struct(id)) => {
                let (payload, single, tag) = self.taken(place, *id, name, site)?;
                let Some(payload) = payload else {
                    Self::take_nothing(pattern, site, names);
                    return Ok(tag);
                };
                let parts = self.inner_patterns(pattern, &payload, single, site)?;
                Ok(both(tag, self.test_all(parts, site, names)?))
            }
            (P::Value(value), Type::Struct(id)) => self.unit_case(value, place, *id),
            (P::Value(_) | P::Range { .. }, Type::Scalar(Scalar::Float(_))) => {
                self.test_float(pattern, place)
            }
            (P::Value(_) | P::Range { .. } | P::Constructor(..), ty) if ty.is_word() => {
                let ranges = self.ranges(std::slice::from_ref(pattern), ty, site)?;
                Ok(within_any(&place.load(), &ranges, place.span))
            }
            _ => problem(
                site,
                "this pattern does not fit what the DSL takes apart",
                "take apart arrays, tuples, structs and variants",
            ),
        }
    }

    /// The patterns inside of one, each with the part of `whole` that it takes; `single`: that is the only part itself.
    fn inner_patterns<'p>(
        &self,
        pattern: &'p tree::Pattern,
        whole: &Place,
        single: bool,
        site: Site,
    ) -> Result<Vec<(&'p tree::Pattern, Value)>> {
        use tree::Pattern as P;
        let itself = |it| (it, Value::Place(whole.clone()));
        let part = |id, at: Option<usize>| match at {
            Some(at) => Value::Place(self.part(whole, id, at)),
            None => Value::Nothing,
        };
        let mut parts = Vec::new();
        match (pattern, &whole.ty) {
            (P::Constructor(_, patterns), _) if single => {
                parts.extend(patterns.iter().take(1).map(itself));
            }
            (P::Fields(_, fields), _) if single => {
                parts.extend(fields.iter().map(|(_, it)| itself(it)));
            }
            (P::Tuple(patterns) | P::Constructor(_, patterns), Type::Struct(id)) => {
                let fields = self.cx.fields_at(*id);
                let pairs = aligned(patterns, fields.len()).into_iter();
                parts.extend(pairs.map(|(it, index)| (it, part(*id, fields[index]))));
            }
            (P::Fields(_, fields), Type::Struct(id)) => {
                for (name, it) in fields {
                    let Some(at) = self.cx.field_at(*id, name) else {
                        return problem(site, format!("`{name}` is missing"), OUR_FAULT);
                    };
                    parts.push((it, part(*id, at)));
                }
            }
            _ => {}
        }
        Ok(parts)
    }

    /// A variant without payload, or a constant that is one.
    fn unit_case(
        &mut self,
        value: &tree::Expr,
        place: &Place,
        id: StructId,
    ) -> Result<Option<Expr>> {
        if let Some(word) = self.unit_word(value, id) {
            return Ok(Some(self.tag_is(place, id, word)));
        }
        problem(value.site, "a constant of this type is not a pattern", "compare with `==`")
    }

    /// The variant that an author wrote by name, which must be its own: another's, given by a `use`, would be taken for
    /// that one.
    pub(super) fn named_case(&self, id: StructId, name: &str, site: Site) -> Result<(u64, Case)> {
        match self.case(id, name) {
            Some(case) if !self.cx.sources.renames(&self.source.file, name) => Ok(case),
            _ => problem(
                site,
                format!("`{name}` is not a variant's own name"),
                "write the name that the variant has where its enum is declared",
            ),
        }
    }

    /// The variant of an `Option` or a `Result` that `?` goes on with.
    pub(super) fn going_on(&self, id: StructId) -> Option<&'static str> {
        ["Some", "Ok"].into_iter().find(|name| self.case(id, name).is_some())
    }

    /// The variant of a struct that stands for an enum: its word, and what it holds.
    pub(super) fn case(&self, id: StructId, name: &str) -> Option<(u64, Case)> {
        let cases = &self.cx.known_of(id).cases;
        let index = cases.iter().position(|case| case.name == name)?;
        Some((index as u64, cases[index].clone()))
    }

    /// The word of the variant without payload that a path has for a value: its name may be another.
    pub(super) fn unit_word(&self, value: &tree::Expr, id: StructId) -> Option<u64> {
        let tree::ExprKind::Path(index, _) = &value.kind else { return None };
        let word = *self.source.constants.get(*index as usize)?.words.first()?;
        let case = self.cx.known_of(id).cases.get(usize::try_from(word).ok()?)?;
        case.field.is_none().then_some(word)
    }

    /// The content that `Name(…)` takes apart, whether that is the one part itself, and the condition for it.
    fn taken(
        &mut self,
        place: &Place,
        id: StructId,
        name: &str,
        site: Site,
    ) -> Result<(Option<Place>, bool, Option<Expr>)> {
        if self.cx.known_of(id).cases.is_empty() {
            return Ok((Some(place.clone()), false, None));
        }
        let name = match name {
            tree::GOES_ON => self.going_on(id).unwrap_or(name),
            name => name,
        };
        let (word, case) = self.named_case(id, name, site)?;
        let payload = case.field.map(|field| self.part(place, id, field as usize));
        Ok((payload, case.single, Some(self.tag_is(place, id, word))))
    }

    /// `place.tag == word`.
    pub(super) fn tag_is(&mut self, place: &Place, id: StructId, word: u64) -> Expr {
        let tag = self.part(place, id, 0);
        let word = i128::from(word);
        within(&tag.load(), (word, word), place.span)
    }

    /// The place of a field.
    pub(super) fn part(&self, place: &Place, id: StructId, index: usize) -> Place {
        let ty = self.cx.field_type(id, index as u32);
        place.inside(Step::Field(index as u32), ty)
    }

    /// Makes names stand for their places, those of values too: only while nothing is written.
    pub(super) fn alias_names(&mut self, names: &[Named]) {
        for named in names {
            self.bind(&named.name, named.stands.clone());
        }
    }

    /// Gives those names of a condition a copy at once that what follows in it may lend to be changed.
    pub(super) fn keep_changeable(&mut self, names: &mut Vec<Named>) -> Result<()> {
        let mut kept = Vec::new();
        for named in std::mem::take(names) {
            match named.mutable && matches!(named.stands, Value::Place(_)) {
                true => self.bind_names(&[named])?,
                false => kept.push(named),
            }
        }
        *names = kept;
        Ok(())
    }

    /// Binds the names of a pattern that takes any such value.
    pub(super) fn bind_pattern(
        &mut self,
        pattern: &tree::Pattern,
        value: &Value,
        site: Site,
    ) -> Result<()> {
        self.bind_or(pattern, value, site, |_| Ok(None))
    }

    /// The same of one that may not take the value: then control leaves by `otherwise`, if that gives anything.
    pub(super) fn bind_or(
        &mut self,
        pattern: &tree::Pattern,
        value: &Value,
        site: Site,
        otherwise: impl FnOnce(&mut Self) -> Result<Option<Block>>,
    ) -> Result<()> {
        let mut names = Vec::new();
        if let Some(taken) = self.test(pattern, value, site, &mut names)?
            && let Some(left) = otherwise(self)?
        {
            let span = taken.span;
            self.branch(taken.negated(), left, Block::default(), span);
        }
        self.bind_names(&names)
    }

    /// Gives names their meaning: another name for a place, or a copy.
    pub(super) fn bind_names(&mut self, names: &[Named]) -> Result<()> {
        for named in names {
            let place = match &named.stands {
                Value::Slice(part) => {
                    self.bind_part((&named.name, named.slot), part, named.site)?;
                    continue;
                }
                Value::Place(place) => place,
                other => {
                    self.bind(&named.name, other.clone());
                    continue;
                }
            };
            let unnamed = named.slot == NO_SLOT;
            // A slice in a value is a value, and so is what a value refers to.
            let borrowed = self.cx.as_borrowed(&place.ty).is_some()
                || !unnamed
                    && self.is_loan(place)
                    && !self.slot_is_exclusive(named.slot, named.site)?;
            let reference =
                !unnamed && !borrowed && self.slot_is_reference(named.slot, named.site)?;
            if reference {
                let refers = self.refers_to(named.slot, named.site)?;
                self.agree(&place.ty, &refers, named.site)?;
            }
            // What no author named is read at once.
            if reference || unnamed || !named.mutable && self.is_lasting(place) {
                self.bind(&named.name, Value::Place(place.clone()));
                continue;
            }
            let rustc = match borrowed {
                true => self.refers_to(named.slot, named.site)?,
                false => self.slot(named.slot, named.site)?,
            };
            self.agree(&place.ty, &rustc, named.site)?;
            let span = self.span(named.site);
            let local = self.declare(&named.name, rustc, Mode::Value, span);
            let value = Some(place.load());
            self.emit(StmtKind::Let { local, value }, span);
        }
        Ok(())
    }

    /// Whether nothing can write to a place: it is behind `&`, or in a local that the author has no name
    /// for.
    pub(super) fn is_lasting(&self, place: &Place) -> bool {
        let local = &self.locals[place.root.index()];
        local.mode == Mode::Ref
            || self.held.contains(&place.root)
            || place.steps.is_empty() && self.steady.contains(&place.root)
    }
}

/// A block without the names that it begins with and does not use.
pub(super) fn used(mut block: Block) -> Block {
    let mut at = 0;
    while let Some(Stmt { kind: StmtKind::Let { local, value: Some(value) }, .. }) = block.0.get(at)
        && matches!(value.kind, ExprKind::Load(_))
    {
        if effects::mentions(&block.0[at + 1..], *local) {
            at += 1;
        } else {
            block.0.remove(at);
        }
    }
    block
}

/// The only name in `Some(name)`, of what does not change.
fn taken_name(pattern: &tree::Pattern) -> Option<&str> {
    let tree::Pattern::Constructor(_, parts) = pattern else { return None };
    match parts.as_slice() {
        [tree::Pattern::Name { name, mutable: false, inner: None, .. }] => Some(name),
        _ => None,
    }
}

/// Both conditions, as far as there are any. Neither has an effect, so one that is false is the whole.
pub(super) fn both(one: Option<Expr>, other: Option<Expr>) -> Option<Expr> {
    let fails =
        |test: &Option<Expr>| test.as_ref().is_some_and(|it| it.kind == ExprKind::Literal(0));
    match (one, other) {
        (one, _) if fails(&one) => one,
        (_, other) if fails(&other) => other,
        (Some(one), Some(other)) => Some(Expr::logic(LogicOp::And, one, other)),
        (one, other) => one.or(other),
    }
}

/// Patterns and the index of the part that each takes; `..` stands for as many as are left.
pub(super) fn aligned(patterns: &[tree::Pattern], count: usize) -> Vec<(&tree::Pattern, usize)> {
    let rest = patterns.iter().position(|it| matches!(it, tree::Pattern::Rest));
    let (before, after) = match rest {
        Some(rest) => (&patterns[..rest], &patterns[rest + 1..]),
        None => (patterns, &patterns[patterns.len()..]),
    };
    let behind = count.saturating_sub(after.len());
    let before = before.iter().enumerate().map(|(index, pattern)| (pattern, index));
    let after = after.iter().enumerate().map(|(index, pattern)| (pattern, behind + index));
    before.chain(after).filter(|(_, index)| *index < count).collect()
}
