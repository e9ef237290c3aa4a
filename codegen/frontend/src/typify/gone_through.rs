//! Values that a loop goes through for something else: a range that is held, for its numbers, `for hour in
//! window.hours.clone()`; a type with an `iter` of the author's own, for what that gives.
//!
//! Invariant: nothing is taken from a range in a place, which would have to be shorter then.
//!
//! Must not know: how a loop counts, or what a slice is.

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
    /// A source with what is meant in the place of its values; none if all of them are meant themselves.
    pub(super) fn meant(&mut self, source: &Source) -> Option<Source> {
        let mut source = source.clone();
        self.mean(&mut source).then_some(source)
    }

    /// Puts what is meant in the place of values; says whether there were any.
    pub(super) fn mean(&mut self, source: &mut Source) -> bool {
        match source {
            Source::Elements(of, owned) => {
                if let Some(range) = self.numbers_of(of) {
                    *source = Source::Numbers(range);
                    return true;
                }
                // What is gone through by value is what `into_iter` gives, which may be something else.
                let own = if *owned { None } else { self.own_iter(of) };
                own.is_some_and(|own| {
                    *of = own;
                    true
                })
            }
            Source::Zip(one, other, _) | Source::Chain(one, other) => {
                self.mean(one) | self.mean(other)
            }
            Source::Enumerate(of)
            | Source::Rev(of)
            | Source::Cycle(of)
            | Source::Skip(of, _)
            | Source::Take(of, _)
            | Source::StepBy(of, _) => self.mean(of),
            Source::Numbers(_) | Source::Groups(..) => false,
        }
    }

    /// The call of an author's own `iter`: the adaptor is the iterator's own, as its name is. Not of a type that has an
    /// `iter_mut` as well, since either may be meant.
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

    /// The numbers of a range in a place, or of its copy.
    pub(super) fn numbers_of(&mut self, of: &tree::Expr) -> Option<Range> {
        self.numbers_in(self.copied(of).unwrap_or(of))
    }

    /// Refuses to take from a range in a place: what is left of it would be there.
    pub(super) fn check_taken(&mut self, of: &tree::Expr) -> Result<()> {
        match &of.kind {
            // A copy that has no name.
            Tree::Local(name) if is_hidden(name) => Ok(()),
            _ if self.numbers_in(of).is_some() => refused(of.site, refusals::RANGE_TAKEN),
            _ => Ok(()),
        }
    }

    /// What an expression copies.
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

    /// The type of the numbers in a range; of one that is held, rustc put it into no slot.
    pub(super) fn type_of_numbers(&mut self, range: &Range, site: Site) -> Result<Type> {
        match range.slot {
            NO_SLOT => self.place_type(&range.from),
            slot => self.slot(slot, site),
        }
    }
}

/// Whether an expression is a place that can be named twice: its indices are names and numbers.
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
