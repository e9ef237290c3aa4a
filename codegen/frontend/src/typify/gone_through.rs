//! Values that are converted for iteration. A stored range becomes its numbers, as in `for hour in
//! window.hours.clone()`. A value with an author's `iter` becomes a call of it.
//!
//! Invariant: no loop takes numbers from a range in a variable, since it would have to change the variable.
//!
//! Must not know: how a loop counts, or how slices are represented.

use bessemer_ir::Type;
use bessemer_ir::tree::{
    self, Builtin, Desugared, ExprKind as Tree, NO_SLOT, Range, Site, Source, Ty,
};

use super::closure_args::is_hidden;
use super::function::result_of;
use super::lowering::Lowering;
use super::syntax::generates;
use super::{Result, refusals, refused};

impl Lowering<'_, '_> {
    /// Replaces stored ranges in a source by their numbers, and types with an author's `iter` by its call. Returns
    /// none if it has neither.
    pub(super) fn meant(&mut self, source: &Source) -> Option<Source> {
        let mut inner = |of: &Source| self.meant(of).map(Box::new);
        Some(match source {
            Source::Elements(of, owned) => match self.numbers_of(of) {
                Some(range) => Source::Numbers(range),
                // A loop by value calls `into_iter`, which may give something else.
                None if *owned => return None,
                None => Source::Elements(self.own_iter(of)?, false),
            },
            Source::Zip(one, other, next) => {
                let (one, other) = both(one, other, [inner(one), inner(other)])?;
                Source::Zip(one, other, *next)
            }
            Source::Chain(one, other) => {
                let (one, other) = both(one, other, [inner(one), inner(other)])?;
                Source::Chain(one, other)
            }
            Source::Enumerate(of) => Source::Enumerate(inner(of)?),
            Source::Rev(of) => Source::Rev(inner(of)?),
            Source::Cycle(of) => Source::Cycle(inner(of)?),
            Source::Skip(of, count) => Source::Skip(inner(of)?, count.clone()),
            Source::Take(of, count) => Source::Take(inner(of)?, count.clone()),
            Source::StepBy(of, step) => Source::StepBy(inner(of)?, step.clone()),
            Source::Numbers(_) | Source::Groups(..) => return None,
        })
    }

    /// Returns the call of an author's `iter`, since the adapter belongs to the iterator. Returns none for a type
    /// that also has an `iter_mut`, since either may be meant.
    fn own_iter(&mut self, of: &tree::Expr) -> Option<tree::Expr> {
        let is_place = matches!(of.kind, Tree::Local(_) | Tree::Field(..) | Tree::Index(..));
        if !is_place || self.cx.own_iterators.is_empty() || self.holds_nothing(of) {
            return None;
        }
        let ty = self.type_alone(of).ok()?;
        let (path, _) = self.cx.types.iter().find(|(_, known)| **known == ty)?;
        let own = self.cx.own_iterators.iter().find(|it| it.owner.as_ref() == Some(path))?;
        let is_iterator = |ty: &Ty| match ty {
            Ty::Named(path) => {
                let ty = self.cx.types.get(path);
                self.cx.iterators.iter().any(|(own, _)| Some(own) == ty)
            }
            _ => false,
        };
        if !generates(own) && !result_of(own).is_some_and(is_iterator) {
            return None;
        }
        let callee = self.cx.unnamed(&own.path);
        let lent = tree::Expr::plain(Tree::Ref(false, Box::new(of.clone())), of.site);
        Some(tree::Expr::plain(Tree::Call(callee, vec![lent]), of.site))
    }

    /// Returns the numbers of a range in a place, or of its copy.
    pub(super) fn numbers_of(&mut self, of: &tree::Expr) -> Option<Range> {
        self.numbers_in(self.copied(of).unwrap_or(of))
    }

    /// Refuses `range.next()` and the like, which would change the range in the variable.
    pub(super) fn check_taken(&mut self, of: &tree::Expr) -> Result<()> {
        match &of.kind {
            // A copy that has no name.
            Tree::Local(name) if is_hidden(name) => Ok(()),
            _ if self.numbers_in(of).is_some() => refused(of.site, refusals::RANGE_TAKEN),
            _ => Ok(()),
        }
    }

    /// Returns the operand that an expression copies.
    fn copied<'e>(&self, expr: &'e tree::Expr) -> Option<&'e tree::Expr> {
        match self.builtin_call(expr)? {
            (Builtin::Owned | Builtin::Desugared(Desugared::AsRef), of) => of.first(),
            _ => None,
        }
    }

    fn numbers_in(&mut self, of: &tree::Expr) -> Option<Range> {
        // Whatever else is wrong with it is told where it is lowered.
        let ty = is_place(of).then(|| self.place_type(of).ok())??;
        let (Type::Struct(id), inclusive) = (&ty, self.cx.known(&ty).range?) else { return None };
        let mut ends = self.cx.fields(*id).iter().map(|end| {
            tree::Expr::plain(Tree::Field(Box::new(of.clone()), end.name.clone()), of.site)
        });
        Some(Range { from: ends.next()?, to: Some(ends.next()?), inclusive, slot: NO_SLOT })
    }

    /// Returns the type of the numbers in a range. A stored range has no slot for it.
    pub(super) fn type_of_numbers(&mut self, range: &Range, site: Site) -> Result<Type> {
        match range.slot {
            NO_SLOT => self.place_type(&range.from),
            slot => self.slot(slot, site),
        }
    }
}

/// Returns true for a place that may be evaluated twice: its indices are names and literals.
fn is_place(expr: &tree::Expr) -> bool {
    match &expr.kind {
        Tree::Local(_) => true,
        Tree::Field(base, _) | Tree::Deref(base) => is_place(base),
        Tree::Index(base, index) => {
            is_place(base) && matches!(index.kind, Tree::Local(_) | Tree::Int(..))
        }
        _ => false,
    }
}

/// Returns two sources with the replaced ones in place; none if neither was replaced.
fn both(
    one: &Source,
    other: &Source,
    meant: [Option<Box<Source>>; 2],
) -> Option<(Box<Source>, Box<Source>)> {
    let [first, second] = meant;
    if first.is_none() && second.is_none() {
        return None;
    }
    let or =
        |meant: Option<Box<Source>>, of: &Source| meant.unwrap_or_else(|| Box::new(of.clone()));
    Some((or(first, one), or(second, other)))
}
