//! Names of references: other names for their places.

use bessemer_ir::tree::{self, Site};

use super::lowering::{Binding, Lowering};
use super::{Result, problem};

/// Whether what `expr` refers to comes from a call, or is gathered: what a fold of references gives is held by itself.
fn lends(expr: &tree::Expr) -> bool {
    match &expr.kind {
        tree::ExprKind::Ref(false, inner) | tree::ExprKind::Try(_, inner) => lends(inner),
        tree::ExprKind::Call(..) | tree::ExprKind::Fold { .. } => true,
        _ => false,
    }
}

impl Lowering<'_, '_> {
    /// `let name = &place`: another name for the place.
    pub(super) fn alias(
        &mut self,
        name: &str,
        value: Option<&tree::Expr>,
        site: Site,
    ) -> Result<()> {
        let place = match value {
            Some(value) => self.place(value)?,
            None => None,
        };
        // What a call lends is not written while it is lent.
        if let (None, Some(lent)) = (&place, value.filter(|value| lends(value))) {
            let lent = self.value(lent, None)?;
            let place = self.hold(lent, site)?;
            self.bind(name, Binding::Alias(place));
            return Ok(());
        }
        let Some(mut place) = place else {
            return problem(
                site,
                "a reference in a variable names a place in the DSL",
                "copy the value: `let x = *place;`, or pass the reference as an argument",
            );
        };
        let naming = std::mem::replace(&mut self.naming, name.trim_matches('_').to_owned());
        self.fix(&mut place);
        self.naming = naming;
        self.bind(name, Binding::Alias(place));
        Ok(())
    }
}
