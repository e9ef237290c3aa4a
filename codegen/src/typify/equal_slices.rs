//! `==` of slices: as long, and the same elements in the same order.

use bessemer_ir::tree::{self, BinaryOp as Op, Site};
use bessemer_ir::{CompareOp, Expr};

use super::Result;
use super::elements::Slice;
use super::lengths::{plus, same};
use super::lowering::Lowering;

impl Lowering<'_, '_> {
    /// `left == right` or `left != right`, if one of the two is a slice.
    pub(super) fn slices_compared(
        &mut self,
        op: Op,
        (left, right): (&tree::Expr, &tree::Expr),
        site: Site,
    ) -> Result<Option<Expr>> {
        if !matches!(op, Op::Eq | Op::Ne) {
            return Ok(None);
        }
        let (one, other) = match (self.slice(left)?, self.slice(right)?) {
            (None, None) => return Ok(None),
            (Some(one), None) => (one, self.sliced(right)?),
            (None, Some(other)) => (self.sliced(left)?, other),
            (Some(one), Some(other)) => (one, other),
        };
        let span = self.span(site);
        let equal = if same(&one.length, &other.length) {
            self.equal_elements_of((&one, &other), site)?
        } else {
            let as_long =
                Expr::compare(CompareOp::Eq, one.length.clone(), other.length.clone()).at(span);
            self.and_then(as_long, |inner| inner.equal_elements_of((&one, &other), site))?
        };
        Ok(Some(if op == Op::Ne { equal.negated() } else { equal }))
    }

    /// Whether each element is equal to its counterpart.
    fn equal_elements_of(&mut self, (one, other): (&Slice, &Slice), site: Site) -> Result<Expr> {
        let span = self.span(site);
        self.all_equal(one.length.clone(), span, |inner, index| {
            let left = one.at(plus(one.from.clone(), index.clone()));
            let right = other.at(plus(other.from.clone(), index));
            inner.equal(&left, &right, site, span)
        })
    }
}
