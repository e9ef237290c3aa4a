//! The state: facts about places, and relations between them; with writes, and joins of paths.

use bessemer_ir::{Expr, ExprKind, FunctionId, LocalId, Module, Place, Scalar, Step, Type};
use imbl::OrdMap;
use imbl::ordmap::DiffItem;

use super::domain::Interval;
use super::known::{Known, Parts};
use super::relations::Relations;
use super::results::Results;
use bessemer_ir::effects::{overlap, whole};

/// A local and the fields into it. With [`BROUGHT`](super::known::BROUGHT) at the end, it is the normalised enum
/// there.
pub(super) type Key = (LocalId, Vec<u32>);

/// Facts at a point of a function. A copy shares them, and costs nothing: each branch has one.
#[derive(Clone)]
pub(crate) struct State<'m> {
    pub(super) module: &'m Module,
    /// Summaries of the functions before this one.
    pub(super) results: &'m [Results],
    pub(super) known: OrdMap<Key, Known>,
    pub(super) relations: Relations,
    /// True if nothing is concluded; each operation then has the full range of its type.
    pub(super) blind: bool,
}

/// Returns the key of a place with fields only; an element of an array has none.
pub(super) fn key(place: &Place) -> Option<Key> {
    let fields = place.steps.iter().map(|step| match step {
        Step::Field(field) => Some(*field),
        Step::Index(_) | Step::Element(..) | Step::From(_) => None,
    });
    Some((place.root, fields.collect::<Option<_>>()?))
}

pub(super) fn place_of((root, fields): &Key) -> Place {
    Place { steps: fields.iter().map(|field| Step::Field(*field)).collect(), ..whole(*root) }
}

impl<'m> State<'m> {
    /// Returns the state without facts, which every execution satisfies.
    pub(crate) fn new(module: &'m Module) -> State<'m> {
        let (known, relations) = (OrdMap::new(), Relations::default());
        State { module, results: &[], known, relations, blind: false }
    }

    /// Returns the initial state with the summaries of the functions before this one.
    pub(crate) fn with_results(module: &'m Module, results: &'m [Results]) -> State<'m> {
        State { results, ..State::new(module) }
    }

    /// Returns a state without facts that also concludes nothing: every number may have each value of its type.
    pub(crate) fn blind(module: &'m Module) -> State<'m> {
        State { blind: true, ..State::new(module) }
    }

    /// Returns the range of a word type; floats have none.
    pub(crate) fn all(&self, ty: &Type) -> Option<Interval> {
        match ty {
            Type::Scalar(Scalar::Bool) => Some(Interval::BOOL),
            Type::Scalar(Scalar::Int(int)) => Some(Interval::of(*int)),
            Type::Enum(_) => Some(Interval::new(0, self.stray(ty)?)),
            _ => None,
        }
    }

    /// Returns the value that represents an invalid enum: one more than its last index.
    pub(super) fn stray(&self, ty: &Type) -> Option<i128> {
        let Type::Enum(id) = ty else { return None };
        Some(self.module.enums.get(id.index())?.variants.len() as i128)
    }

    /// Returns the valid values of a type; for an enum, its variants.
    pub(super) fn meant(&self, ty: &Type) -> Option<Interval> {
        let all = self.all(ty)?;
        Some(self.stray(ty).map_or(all, |stray| all.without(stray)))
    }

    /// Returns true if an expression is an enum that may be invalid.
    pub(crate) fn may_stray(&self, expr: &Expr) -> bool {
        self.stray(&expr.ty).is_some_and(|stray| self.range(expr).contains(stray))
    }

    /// Drops the facts that depend on the places `written`.
    pub(crate) fn forget(&mut self, written: &[Place]) {
        for written in written {
            let (first, next) = (written.root, LocalId(written.root.0.saturating_add(1)));
            let same_root = self.known.range::<_, Key>((first, Vec::new())..(next, Vec::new()));
            let hit = same_root.map(|(key, _)| key).filter(|key| overlap(&place_of(key), written));
            for key in hit.cloned().collect::<Vec<_>>() {
                self.known.remove(&key);
            }
        }
        self.relations.forget(written);
    }

    /// Returns the known words of a value, each with the fields that lead to it. The value is a struct literal, the
    /// result of a call, or reached by fields alone.
    pub(crate) fn parts(&self, value: &Expr) -> Parts {
        let mut parts = Vec::new();
        self.collect(value, &[], &mut parts);
        parts
    }

    fn collect(&self, value: &Expr, at: &[u32], parts: &mut Parts) {
        match &value.kind {
            ExprKind::Struct(fields) => {
                for (field, part) in (0..).zip(fields) {
                    self.collect(part, &[at, &[field]].concat(), parts);
                }
            }
            ExprKind::Load(from) if !value.ty.is_word() => {
                let Some((root, fields)) = key(from) else { return };
                let held = self.known.range::<_, Key>((root, fields.clone())..);
                let inside = held.map_while(|((other, all), known)| {
                    let rest = all.strip_prefix(&fields[..]).filter(|_| *other == root)?;
                    Some(([at, rest].concat(), *known))
                });
                parts.extend(inside);
            }
            ExprKind::Call(callee, _) if !value.ty.is_word() => {
                let returned = self.returned(*callee).into_iter().flat_map(Results::all);
                parts.extend(returned.map(|(inside, known)| ([at, inside].concat(), known)));
            }
            _ => parts.extend(self.value(value).map(|known| (at.to_vec(), known))),
        }
    }

    /// Returns the summary of a callee.
    pub(super) fn returned(&self, callee: FunctionId) -> Option<&'m Results> {
        self.results.get(callee.index())
    }

    /// Records the facts about a value at the place to which it is written.
    pub(crate) fn assign(&mut self, place: &Place, value: Parts) {
        self.forget(std::slice::from_ref(place));
        if let Some((root, fields)) = key(place) {
            let known =
                value.into_iter().map(|(at, known)| ((root, [&fields[..], &at].concat()), known));
            self.known.extend(known);
        }
    }

    /// Keeps the facts that hold here and in `other`.
    pub(crate) fn join(&mut self, other: &State<'m>) {
        let orders = self.common(other);
        self.change(other, |known, other| known.or(*other?));
        self.relations.join(&other.relations);
        orders.iter().for_each(|order| self.relations.learn(order));
    }

    /// Changes or drops the facts that differ from those of `other`. Where paths meet, most are shared, and are not
    /// looked at.
    pub(super) fn change(
        &mut self,
        other: &State<'m>,
        mut changed: impl FnMut(Known, Option<&Known>) -> Option<Known>,
    ) {
        let changes = self.known.diff(&other.known).filter_map(|item| match item {
            DiffItem::Add(..) => None,
            DiffItem::Remove(key, known) => Some((key.clone(), changed(*known, None))),
            DiffItem::Update { old: (key, known), new: (_, other) } => {
                Some((key.clone(), changed(*known, Some(other))))
            }
        });
        for (key, known) in changes.collect::<Vec<_>>() {
            match known {
                Some(known) => _ = self.known.insert(key, known),
                None => _ = self.known.remove(&key),
            }
        }
    }

    /// Continues after branches, with the join of those that reach their end.
    pub(crate) fn after(&mut self, ends: Vec<(State<'m>, bool)>) {
        let reached = ends.into_iter().filter(|(_, diverges)| !diverges).map(|(state, _)| state);
        if let Some(joined) = joined(reached) {
            *self = joined;
        }
    }
}

/// Returns the state where several paths meet; none if there are none.
pub(super) fn joined<'m>(paths: impl IntoIterator<Item = State<'m>>) -> Option<State<'m>> {
    paths.into_iter().reduce(|mut a, b| {
        a.join(&b);
        a
    })
}
