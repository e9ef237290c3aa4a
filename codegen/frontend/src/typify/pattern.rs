//! Patterns: the condition under which a value matches, and the meaning of the names.
//!
//! A name with a reference type is an alias of the place. A name with a value type is a copy, made at the beginning
//! of the arm or after the `let`; in a guard it is still an alias.
//!
//! Invariant: a payload is read only after the test of its variant.

use bessemer_ir::tree::{self, ExprKind as Tree, NO_SLOT, Pattern, Site};
use bessemer_ir::{
    Block, CompareOp, Expr, ExprKind, LogicOp, Mode, Place, Scalar, Step, StmtKind, StructId, Type,
};

use super::closure_args::is_hidden;
use super::conditions::within;
use super::context::Case;
use super::literal::is_wide;
use super::lowering::Lowering;
use super::value::{Named, Value};
use super::{Needed, Result, problem, refusals, refused};
use bessemer_ir::effects;

/// Condition under which a pattern matches, if any, and the names that it binds.
#[derive(Default)]
pub(super) struct Test {
    pub condition: Option<Expr>,
    pub names: Vec<Named>,
}

impl Test {
    /// Returns a test without names.
    pub(super) fn of(condition: Option<Expr>) -> Test {
        Test { condition, names: Vec::new() }
    }

    /// Returns a test that always matches and binds a name.
    pub(super) fn named(name: &str, slot: u32, stands: Value, site: Site) -> Test {
        let name = Named { name: name.to_owned(), slot, mutable: false, stands, site };
        Test { condition: None, names: vec![name] }
    }

    /// Returns the test with names that the author may assign if `mutable`.
    #[must_use]
    pub(super) fn changeable(mut self, mutable: bool) -> Test {
        self.names.iter_mut().for_each(|name| name.mutable = mutable);
        self
    }

    /// Returns the conjunction of two tests. Conditions have no effects, so a constant false replaces the whole.
    #[must_use]
    pub(super) fn with(mut self, other: Test) -> Test {
        self.names.extend(other.names);
        let fails = |it: &Expr| it.kind == ExprKind::Literal(0);
        self.condition = match (self.condition, other.condition) {
            (Some(one), _) if fails(&one) => Some(one),
            (_, Some(other)) if fails(&other) => Some(other),
            (Some(one), Some(other)) => Some(Expr::logic(LogicOp::And, one, other)),
            (one, other) => one.or(other),
        };
        self
    }
}

impl Lowering<'_, '_> {
    /// Returns the condition under which `pattern` matches the subject.
    pub(super) fn test(&mut self, pattern: &Pattern, subject: &Value, site: Site) -> Result<Test> {
        match (pattern, subject) {
            (Pattern::Any | Pattern::Rest, _) => Ok(Test::default()),
            (_, Value::Nothing) => Ok(Self::take_nothing(pattern, site)),
            (_, Value::Place(place)) => self.test_place(pattern, place, site),
            (Pattern::Name { name, slot, inner: None, .. }, Value::Submatrix(_))
            | (Pattern::Name { name, slot, mutable: false, inner: None }, Value::Word(_)) => {
                Ok(Test::named(name, *slot, subject.clone(), site))
            }
            (_, Value::Word(word)) => {
                let place = self.hold((**word).clone());
                self.test_place(pattern, &place, site)
            }
            (Pattern::Or(cases), _) => self.test_any(cases, subject, site),
            (_, Value::Slice(slice)) => self.test_slice(pattern, slice, site),
            (_, Value::Maybe(there, lent)) => self.test_maybe(pattern, (there, lent), site),
            (Pattern::Tuple(patterns), Value::Tuple(parts, _)) => {
                let pairs = aligned(patterns, parts.len()).into_iter();
                self.test_all(pairs.map(|(it, index)| (it, parts[index].clone())), site)
            }
            (Pattern::Name { name, slot, mutable: false, inner: None }, Value::Tuple(parts, _))
                if is_hidden(name) || self.source.tree.role == tree::Role::Expanded =>
            {
                // One that lends to be changed has no type of its own, and is only taken apart.
                let ty = if *slot == NO_SLOT { None } else { self.slot(*slot, site).ok() };
                Ok(Test::named(name, *slot, Value::Tuple(parts.clone(), ty), site))
            }
            _ => refused(site, refusals::TUPLE_PATTERN),
        }
    }

    fn test_any(&mut self, cases: &[Pattern], subject: &Value, site: Site) -> Result<Test> {
        let (mut any, mut known): (Option<Expr>, Option<Vec<Named>>) = (None, None);
        for case in cases {
            let Test { condition, mut names } = self.test(case, subject, site)?;
            names.sort_by(|one, other| one.name.cmp(&other.name));
            // Each of `x @ 1 | x @ 2` is another name of one place.
            let first = known.get_or_insert_with(|| names.clone());
            if first.len() != names.len() || !first.iter().zip(&names).all(same_names) {
                return refused(site, refusals::NAMES_BY_CASE);
            }
            let Some(next) = condition else { return Ok(Test { condition: None, names }) };
            any = Some(match any {
                Some(any) => Expr::logic(LogicOp::Or, any, next),
                None => next,
            });
        }
        Ok(Test { condition: any, names: known.unwrap_or_default() })
    }

    /// Returns the conjunction of the tests of all parts.
    fn test_all<'p>(
        &mut self,
        parts: impl IntoIterator<Item = (&'p Pattern, Value)>,
        site: Site,
    ) -> Result<Test> {
        let mut all = Test::default();
        for (pattern, part) in parts {
            all = all.with(self.test(pattern, &part, site)?);
        }
        Ok(all)
    }

    /// Tests a literal or a range of floats or of integers of 128 bits, or a name, by `==` and `<=`.
    fn test_compared(&mut self, pattern: &Pattern, place: &Place) -> Result<Test> {
        let bounds = match pattern {
            Pattern::Range { from, to, inclusive } => {
                let most = if *inclusive { CompareOp::Le } else { CompareOp::Lt };
                vec![(CompareOp::Ge, from.as_ref()), (most, to.as_ref())]
            }
            Pattern::Value(number) => vec![(CompareOp::Eq, Some(number))],
            _ => Vec::new(),
        };
        let mut all = Test::default();
        for (op, number) in bounds {
            if let Some(number) = number {
                let site = number.site;
                let number = self.value(number, Some(&place.ty))?;
                let test = match place.ty {
                    Type::Struct(_) => self.compare_node(op, place.load(), number, site)?,
                    _ => Expr::compare(op, place.load(), number).at(place.span),
                };
                all = all.with(Test::of(Some(test)));
            }
        }
        Ok(all)
    }

    fn test_place(&mut self, pattern: &Pattern, place: &Place, site: Site) -> Result<Test> {
        match (pattern, &place.ty) {
            (Pattern::Any | Pattern::Rest, _) => Ok(Test::default()),
            _ if let Some(element) = self.element_lent(place, site)? => {
                self.test_place(pattern, &element, site)
            }
            (Pattern::Array(_), _) if let Some(slice) = self.slice_at(place.clone(), site)? => {
                self.test_slice(pattern, &slice, site)
            }
            (Pattern::Array(_), Type::Array { .. })
                if let Some(slice) = self.all_of(place.clone()) =>
            {
                self.test_slice(pattern, &slice, site)
            }
            (Pattern::Name { name, slot, mutable, inner }, _) => {
                let test = Test::named(name, *slot, Value::Place(place.clone()), site);
                let test = test.changeable(*mutable);
                match inner {
                    Some(inner) => Ok(test.with(self.test_place(inner, place, site)?)),
                    None => Ok(test),
                }
            }
            (Pattern::Or(cases), _) => self.test_any(cases, &Value::Place(place.clone()), site),
            (Pattern::Tuple(_), Type::Struct(_)) => {
                let parts = self.inner_patterns(pattern, place, false, site)?;
                self.test_all(parts, site)
            }
            (Pattern::Constructor(name, _) | Pattern::Fields(name, _), Type::Struct(id)) => {
                let (payload, single, tag) = self.taken(place, *id, name, site)?;
                let inner = match payload {
                    None => Self::take_nothing(pattern, site),
                    Some(payload) => {
                        let parts = self.inner_patterns(pattern, &payload, single, site)?;
                        self.test_all(parts, site)?
                    }
                };
                Ok(Test::of(tag).with(inner))
            }
            (Pattern::Value(_) | Pattern::Range { .. }, ty) if is_wide(self.cx, ty) => {
                self.test_compared(pattern, place)
            }
            (Pattern::Value(value), Type::Struct(id)) => match self.unit_word(value, *id) {
                Some(word) => Ok(Test::of(Some(self.tag_is(place, *id, word)))),
                None => refused(value.site, refusals::CONSTANT_PATTERN),
            },
            (Pattern::Value(_) | Pattern::Range { .. }, Type::Scalar(Scalar::Float(_))) => {
                self.test_compared(pattern, place)
            }
            (Pattern::Value(_), ty) if self.cx.is_name(ty) => self.test_compared(pattern, place),
            (Pattern::Value(_) | Pattern::Range { .. } | Pattern::Constructor(..), ty)
                if ty.is_word() =>
            {
                let range = self.range(pattern, ty, site)?;
                Ok(Test::of(Some(within(&place.load(), range, place.span))))
            }
            _ => refused(site, refusals::PATTERN),
        }
    }

    /// Returns the patterns inside a pattern, each with its part of `whole`. With `single`, the payload is one value
    /// and not a struct.
    fn inner_patterns<'p>(
        &self,
        pattern: &'p Pattern,
        whole: &Place,
        single: bool,
        site: Site,
    ) -> Result<Vec<(&'p Pattern, Value)>> {
        let itself = |it| (it, Value::Place(whole.clone()));
        let part = |id, at: Option<usize>| match at {
            Some(at) => Value::Place(self.part(whole, id, at)),
            None => Value::Nothing,
        };
        let mut parts = Vec::new();
        match (pattern, &whole.ty) {
            (Pattern::Constructor(_, patterns), _) if single => {
                parts.extend(patterns.iter().take(1).map(itself));
            }
            (Pattern::Fields(_, fields), _) if single => {
                parts.extend(fields.iter().map(|(_, it)| itself(it)));
            }
            (Pattern::Tuple(patterns) | Pattern::Constructor(_, patterns), Type::Struct(id)) => {
                let fields = self.cx.fields_at(*id);
                let pairs = aligned(patterns, fields.len()).into_iter();
                parts.extend(pairs.map(|(it, index)| (it, part(*id, fields[index]))));
            }
            (Pattern::Fields(_, fields), Type::Struct(id)) => {
                for (name, it) in fields {
                    let at =
                        self.cx.field_at(*id, name).needed(site, format!("`{name}` is missing"))?;
                    parts.push((it, part(*id, at)));
                }
            }
            _ => {}
        }
        Ok(parts)
    }

    /// Returns the variant that the author wrote by name. A `use` that renames another variant to this name is
    /// refused.
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

    /// Returns the name of the variant with which `?` continues, `Some` or `Ok`.
    pub(super) fn going_on(&self, id: StructId) -> Option<&'static str> {
        ["Some", "Ok"].into_iter().find(|name| self.case(id, name).is_some())
    }

    /// Returns a variant of a struct that represents an enum: its word and its payload.
    pub(super) fn case(&self, id: StructId, name: &str) -> Option<(u64, Case)> {
        let cases = &self.cx.known_of(id).cases;
        let index = cases.iter().position(|case| case.name == name)?;
        Some((index as u64, cases[index].clone()))
    }

    /// Returns the word of a variant without payload that a path denotes; the path may be an alias.
    pub(super) fn unit_word(&self, value: &tree::Expr, id: StructId) -> Option<u64> {
        let Tree::Path(index, _) = &value.kind else { return None };
        let word = *self.source.constants.get(*index as usize)?.words.first()?;
        let case = self.cx.known_of(id).cases.get(usize::try_from(word).ok()?)?;
        case.field.is_none().then_some(word)
    }

    /// Returns the payload that `Name(…)` destructures, true if it is one value, and the condition that the variant
    /// matches.
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

    /// Returns the condition `place.tag == word`.
    pub(super) fn tag_is(&mut self, place: &Place, id: StructId, word: u64) -> Expr {
        let tag = self.part(place, id, 0);
        let word = i128::from(word);
        within(&tag.load(), (word, word), place.span)
    }

    /// Returns the place of a field.
    pub(super) fn part(&self, place: &Place, id: StructId, index: usize) -> Place {
        let ty = self.cx.field_type(id, index as u32);
        place.inside(Step::Field(index as u32), ty)
    }

    /// Binds names as aliases of their places, also names of values. Valid only while nothing is written.
    pub(super) fn alias_names(&mut self, names: &[Named]) {
        for named in names {
            self.bind(&named.name, named.stands.clone());
        }
    }

    /// Copies the names of a condition that the rest of the condition may change, or whose places it may write.
    pub(super) fn copy_names(
        &mut self,
        names: &mut Vec<Named>,
        changes: impl Fn(&Named) -> bool,
    ) -> Result<()> {
        let mut kept = Vec::new();
        for named in std::mem::take(names) {
            match changes(&named) && named.copied_from().is_some() {
                true => self.bind_names(&[named])?,
                false => kept.push(named),
            }
        }
        *names = kept;
        Ok(())
    }

    /// Binds the names of an irrefutable pattern.
    pub(super) fn bind_pattern(
        &mut self,
        pattern: &Pattern,
        value: &Value,
        site: Site,
    ) -> Result<()> {
        self.bind_or(pattern, value, site, |_| Ok(None))
    }

    /// Binds a pattern that may not match: then control leaves by `otherwise`, if that returns a block.
    pub(super) fn bind_or(
        &mut self,
        pattern: &Pattern,
        value: &Value,
        site: Site,
        otherwise: impl FnOnce(&mut Self) -> Result<Option<Block>>,
    ) -> Result<()> {
        let Test { condition, names } = self.test(pattern, value, site)?;
        if let Some(taken) = condition
            && let Some(left) = otherwise(self)?
        {
            let span = taken.span;
            self.branch(taken.negated(), left, Block::default(), span);
        }
        self.bind_names(&names)
    }

    /// Binds names: as an alias of a place, or as a copy.
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
            let borrowed = self.is_borrowed(named, place)?;
            let reference =
                !unnamed && !borrowed && self.slot_is_reference(named.slot, named.site)?;
            if reference {
                let refers = self.refers_to(named.slot, named.site)?;
                self.agree(&place.ty, &refers, named.site)?;
            }
            // What no author named is read at once.
            let same = match reference || unnamed {
                true => Some(Value::Place(place.clone())),
                false => self.denoted(place, named.mutable),
            };
            if let Some(same) = same {
                self.bind(&named.name, same);
                continue;
            }
            let rustc = match borrowed {
                true => self.refers_to(named.slot, named.site)?,
                false => self.slot(named.slot, named.site)?,
            };
            self.agree(&place.ty, &rustc, named.site)?;
            let span = self.span(named.site);
            let local = self.declare(&named.name, rustc, Mode::Value, span);
            if named.mutable {
                self.note_changing(local, named.slot);
            }
            let value = Some(place.load());
            self.emit(StmtKind::Let { local, value }, span);
        }
        Ok(())
    }

    /// Returns true if a name denotes a value that refers to something: a slice in a value, or a copy of a referenced
    /// value.
    pub(super) fn is_borrowed(&self, named: &Named, place: &Place) -> Result<bool> {
        Ok(self.cx.as_borrowed(&place.ty).is_some()
            || named.slot != NO_SLOT
                && self.is_loan(place)
                && !self.slot_is_exclusive(named.slot, named.site)?)
    }
}

/// Returns true if two alternatives bind the same name to the same place.
fn same_names((one, other): (&Named, &Named)) -> bool {
    let same = match (&one.stands, &other.stands) {
        (Value::Place(one), Value::Place(other)) => effects::same_place(one, other),
        (Value::Nothing, Value::Nothing) => true,
        _ => false,
    };
    same && one.name == other.name && one.mutable == other.mutable
}

/// Returns patterns with the index of the part that each matches; `..` skips the remaining parts.
pub(super) fn aligned(patterns: &[Pattern], count: usize) -> Vec<(&Pattern, usize)> {
    let rest = patterns.iter().position(|it| matches!(it, Pattern::Rest));
    let (before, after) = match rest {
        Some(rest) => (&patterns[..rest], &patterns[rest + 1..]),
        None => (patterns, &patterns[patterns.len()..]),
    };
    let behind = count.saturating_sub(after.len());
    let before = before.iter().enumerate().map(|(index, pattern)| (pattern, index));
    let after = after.iter().enumerate().map(|(index, pattern)| (pattern, behind + index));
    before.chain(after).filter(|(_, index)| *index < count).collect()
}
