//! `for` through what may be there, an `Option`: an `if`.

use bessemer_ir::Type;
use bessemer_ir::tree::{self, Site};

use super::Result;
use super::lowering::{Frame, Lowering};
use super::words;

impl Lowering<'_, '_> {
    /// Whether what is gone through is an `Option`.
    pub(super) fn may_be_there(&mut self, of: &tree::Expr) -> bool {
        let slot = of.slot.and_then(|slot| self.source.slots.get(slot as usize));
        match (slot, &of.kind) {
            (Some(tree::Ty::Option(_)), _) => true,
            (Some(tree::Ty::Ref(inner, _)), _) => matches!(**inner, tree::Ty::Option(_)),
            (Some(_), _) => false,
            (
                None,
                tree::ExprKind::Local(_) | tree::ExprKind::Field(..) | tree::ExprKind::Ref(..),
            ) => match self.place_type(of) {
                Ok(Type::Struct(id)) => {
                    ["Some", "None"].iter().all(|name| self.case(id, name).is_some())
                }
                _ => false,
            },
            _ => false,
        }
    }

    /// `for x in option`: the body, if there is something. What leaves the loop, or the pass, leaves that.
    pub(super) fn one_pass(
        &mut self,
        site: Site,
        label: Option<&str>,
        part: &tree::Part,
        body: &tree::Block,
    ) -> Result<()> {
        let of = |kind| tree::Expr { kind, site, slot: None };
        let pattern = tree::Pattern::Constructor("Some".into(), vec![part.pattern.clone()]);
        let there = tree::ExprKind::Let(Box::new(pattern), Box::new(part.array.clone()));
        let then = tree::ExprKind::If(Box::new(of(there)), body.clone(), None);
        let frame = Frame { pass: true, ..Frame::block(label, None) };
        let then = tree::Block { stmts: vec![tree::Stmt::Expr(of(then))], tail: None };
        let span = self.span(site);
        self.left(words::PASS, frame, span, |inner| inner.block_effect(&then))
    }
}
