//! Ranges that are held, where their numbers are meant: `for hour in window.hours.clone()`, `&values[part]`.
//!
//! Must not know: how a loop counts, or what a slice is.

use bessemer_ir::Type;
use bessemer_ir::tree::{self, Builtin, Desugared, ExprKind as Tree, NO_SLOT, Range, Site, Source};

use super::closure_args::is_hidden;
use super::lowering::Lowering;
use super::syntax::is_named;
use super::{Result, refusals, refused};

impl Lowering<'_, '_> {
    /// A source with the numbers of each held range in its place; none if it has no such range.
    pub(super) fn without_held_ranges(&mut self, source: &Source) -> Option<Source> {
        let mut source = source.clone();
        self.count_through(&mut source).then_some(source)
    }

    fn count_through(&mut self, source: &mut Source) -> bool {
        match source {
            Source::Elements(of, _) => match self.numbers_of(of) {
                Some(range) => {
                    *source = Source::Numbers(range);
                    true
                }
                None => false,
            },
            Source::Zip(one, other) | Source::Chain(one, other) => {
                self.count_through(one) | self.count_through(other)
            }
            Source::Enumerate(of)
            | Source::Rev(of)
            | Source::Cycle(of)
            | Source::Skip(of, _)
            | Source::Take(of, _)
            | Source::StepBy(of, _) => self.count_through(of),
            Source::Numbers(_) | Source::Groups(..) => false,
        }
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
        let ty = is_named(of, false).then(|| self.place_type(of).ok())??;
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
