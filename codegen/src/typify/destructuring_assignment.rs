//! `(a, b) = value`: every value is computed before the first place is written.

use bessemer_ir::tree::{self, Places, Site};
use bessemer_ir::{Expr, Place, Step, StmtKind, Type};

use super::lowering::Lowering;
use super::{Result, problem};

impl Lowering<'_, '_> {
    pub(super) fn assign_each(&mut self, places: &Places, value: &tree::Expr) -> Result<()> {
        let mut pairs = Vec::new();
        self.pair_up(places, value, &mut pairs)?;
        for (place, value) in pairs {
            let span = value.span;
            let place = self.writable(place)?;
            self.agree(&value.ty, &place.ty, place_site(&place))?;
            self.emit(StmtKind::Assign { place, value }, span);
        }
        Ok(())
    }

    /// Each place with its value; values that are written out one by one need no tuple.
    fn pair_up<'t>(
        &mut self,
        places: &'t Places,
        value: &tree::Expr,
        pairs: &mut Vec<(&'t tree::Expr, Expr)>,
    ) -> Result<()> {
        match (places, &value.kind) {
            (
                Places::Each(places),
                tree::ExprKind::Tuple(values) | tree::ExprKind::Array(values),
            ) if places.len() == values.len() => {
                for (places, value) in places.iter().zip(values) {
                    self.pair_up(places, value, pairs)?;
                }
                Ok(())
            }
            (Places::One(place), _) if self.holds_nothing(place) => {
                self.assign_nothing(place, value)
            }
            (Places::One(place), _) => {
                self.keeps_what_it_refers_to(place, value)?;
                let ty = self.place_type(place)?;
                let name = self.name_of(place);
                let value = self.naming_as(name, |inner| {
                    let value = inner.value(value, Some(&ty))?;
                    Ok(if value.is_literal() { value } else { inner.temporary("next", value) })
                })?;
                pairs.push((place, value));
                Ok(())
            }
            _ => {
                let whole = self.value(value, None)?;
                let place = self.temporary_place("parts", whole);
                self.take_parts(places, &place, pairs, value.site)
            }
        }
    }

    /// The parts of a value in its place.
    fn take_parts<'t>(
        &mut self,
        places: &'t Places,
        from: &Place,
        pairs: &mut Vec<(&'t tree::Expr, Expr)>,
        site: Site,
    ) -> Result<()> {
        match (places, &from.ty) {
            (Places::None, _) => Ok(()),
            (Places::One(place), _) => {
                pairs.push((place, from.load()));
                Ok(())
            }
            (Places::Each(all), Type::Struct(id)) => {
                for (index, places) in all.iter().enumerate() {
                    let part = self.part(from, *id, index);
                    self.take_parts(places, &part, pairs, site)?;
                }
                Ok(())
            }
            (Places::Each(all), Type::Array { element, .. }) => {
                for (index, places) in all.iter().enumerate() {
                    let step = Step::Index(Expr::usize(index as u64, from.span));
                    let part = from.inside(step, (**element).clone());
                    self.take_parts(places, &part, pairs, site)?;
                }
                Ok(())
            }
            _ => problem(site, "this is not taken apart by an assignment", "use `let`"),
        }
    }
}

/// Where a place stands, as the tree has it.
fn place_site(place: &Place) -> Site {
    Site(place.span.line, place.span.column)
}
