//! Names of references: other names for their places.

use bessemer_ir::tree::{self, Site};
use bessemer_ir::{Place, Span};

use super::lowering::Lowering;
use super::syntax::bare;
use super::value::Value;
use super::{Result, problem};

/// Whether what `expr` refers to comes from a call, or is gathered: what a fold of references gives is held by itself.
fn lends(expr: &tree::Expr) -> bool {
    match &expr.kind {
        tree::ExprKind::Ref(false, inner) | tree::ExprKind::Try(_, inner) => lends(inner),
        tree::ExprKind::Call(..) | tree::ExprKind::Fold { .. } => true,
        _ => false,
    }
}

/// Whether an expression that is a reference is a part of a value: that holds it.
fn is_held(expr: &tree::Expr) -> bool {
    matches!(expr.kind, tree::ExprKind::Field(..) | tree::ExprKind::Index(..))
}

impl Lowering<'_, '_> {
    /// The meaning of a name, also behind `&` and `*`; none of another expression.
    pub(super) fn meaning(&self, expr: &tree::Expr) -> Option<Value> {
        match &bare(expr).kind {
            tree::ExprKind::Local(name) => self.lookup(name, expr.site).ok(),
            _ => None,
        }
    }

    /// The place that a name means; none if it means a value, or none yet.
    pub(super) fn place_of(&self, meaning: &Value, span: Span) -> Option<Place> {
        match meaning {
            Value::Place(place) => Some(place.clone()),
            Value::Slice(slice) => Some(slice.place()),
            Value::Local(root) => {
                Some(Place::local(*root, self.locals[root.index()].ty.clone(), span))
            }
            _ => None,
        }
    }

    /// A copy of what is at a place, under a name that nothing writes to.
    pub(super) fn hold_copy(&mut self, name: &str, place: Place) -> Place {
        self.naming_as("", |inner| inner.temporary_place(name, place.load()))
    }

    /// `let name = &place`: another name for the place.
    pub(super) fn alias(
        &mut self,
        name: &str,
        value: Option<&tree::Expr>,
        site: Site,
    ) -> Result<()> {
        if let Some(value) = value
            && self.alias_of_arm(name, value, site)?
        {
            return Ok(());
        }
        let place = match value {
            Some(value) => self.place(value)?,
            None => None,
        };
        // What a call lends is not written while it is lent.
        if let (None, Some(lent)) = (&place, value.filter(|value| lends(value))) {
            let place = self.held(lent)?;
            self.bind(name, Value::Place(place));
            return Ok(());
        }
        let Some(mut place) = place else {
            return problem(
                site,
                "a reference in a variable names a place in the DSL",
                "copy the value: `let x = *place;`, or pass the reference as an argument; of what may be there, `let Some(x) = … else { … };`",
            );
        };
        let moves = value.is_some_and(is_held) || self.may_come_to_refer(&place);
        if moves && !self.is_lasting(&place) {
            // A reference that a value holds is a copy there; the value may get another.
            place = self.hold_copy(name, place);
        }
        self.naming_as(name.trim_matches('_'), |inner| inner.fix(&mut place));
        self.bind(name, Value::Place(place));
        Ok(())
    }
}
