//! What is read of a slice, or of a `&mut T`, in a local before anything shows which array it is of: in a loop, that the local
//! begins as `None` and an assignment further down gives it one.
//!
//! A local of the array's type stands for the array while the function is lowered, and is nowhere in what is given: there the array
//! itself stands, which the assignment has shown by then.
//!
//! Must not know: how lenders are followed ([`lenders`](super::lenders)).

use bessemer_ir::tree::Site;
use bessemer_ir::visit::{self, Access, VisitMut};
use bessemer_ir::{Block, Local, LocalId, Mode, Place, Type};

use super::lenders::path_of;
use super::lowering::{Lowering, UNNAMED};
use super::regions::Awaited;
use super::{Result, problem};

impl Lowering<'_, '_> {
    /// What stands for the array whose elements the slice at a place has.
    pub(super) fn awaited(
        &mut self,
        place: &Place,
        element: &Type,
        (site, help): (Site, &'static str),
    ) -> Place {
        let of = (place.root, path_of(place));
        let ty = Type::Array { element: Box::new(element.clone()), len: u32::MAX };
        let known = self.lenders.awaited.iter().find(|it| it.of == of).map(|it| it.stands);
        let stands = known.unwrap_or(LocalId(self.locals.len() as u32));
        if known.is_none() {
            let (name, ty) = (UNNAMED.to_owned(), ty.clone());
            self.locals.push(Local { name, ty, mode: Mode::Value, span: place.span });
            let element = element.clone();
            self.lenders.awaited.push(Awaited { stands, element, of, site, help });
        }
        Place::local(stands, ty, place.span)
    }

    /// Whether a local stands for an array.
    pub(super) fn stands(&self, local: LocalId) -> bool {
        self.lenders.awaited.iter().any(|it| it.stands == local)
    }

    /// Puts the arrays where something stands for them.
    pub(super) fn put_awaited(&mut self) -> Result<()> {
        for Awaited { stands, element, of, site, help } in std::mem::take(&mut self.lenders.awaited)
        {
            let lender = self.lenders.of(of.0, &of.1).filter(|it| it.root != stands);
            let Some(lender) = lender else {
                // Where it was shown, and refused.
                if let Some(told) = self.lenders.problem.take() {
                    return Err(told);
                }
                return problem(site, "whose elements these are is not known here", help);
            };
            let mut put = Put { stands, whole: lender.ty == element, lender };
            let mut body = Block(std::mem::take(&mut self.out));
            put.block(&mut body);
            self.out = body.0;
            // What others were given of it.
            for (.., lender) in &mut self.lenders.known {
                put.place(lender, Access::Read);
            }
            self.locals[stands.index()].ty = Type::BOOL;
        }
        Ok(())
    }
}

/// Puts an array in the place of what stands for it.
struct Put {
    stands: LocalId,
    lender: Place,
    /// Whether what lends is the one element itself.
    whole: bool,
}

impl VisitMut for Put {
    fn place(&mut self, place: &mut Place, _: Access) {
        visit::walk_place_mut(self, place);
        if place.root == self.stands {
            let own = usize::from(self.whole).min(place.steps.len());
            let behind = place.steps.split_off(own);
            place.steps = self.lender.steps.iter().cloned().chain(behind).collect();
            place.root = self.lender.root;
        }
    }
}
