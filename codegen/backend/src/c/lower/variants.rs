//! Handles enums from outside that hold no valid variant.
//!
//! If a proof needs a valid variant ([`Intrinsic::Variant`](bessemer_ir::Intrinsic::Variant)), the last variant
//! replaces an invalid one. An entry point that returns a status tests its enums first and reports the fault. An
//! infallible one cannot, and takes the last arm of a `match`. Tested are enums that are arguments or fields of
//! struct arguments, not elements of arrays or payloads.

use bessemer_ir::{EnumId, Expr as Ir, Fault};

use super::super::outside::{self, Outside};
use super::super::signature::Returned;
use super::super::tree::{Expr, StmtKind, SwitchArm};
use super::{Lower, bound};

impl Lower<'_> {
    /// Returns an enum, or its last variant if its value is invalid.
    pub(super) fn variant(&mut self, operand: &Ir, id: EnumId) -> Expr {
        let item = &self.context.module.enums[id.index()];
        let names = self.context.names.enums[id.index()].variants.clone();
        let (Some(last), others) = (names.last().map(Expr::name), names.len().saturating_sub(1))
        else {
            return self.word(operand);
        };
        let condition = if item.is_numbered() {
            let equal = |name: &String| Expr::binary("==", self.word(operand), Expr::name(name));
            names[..others].iter().map(equal).reduce(|a, b| Expr::binary("||", a, b))
        } else {
            let end = Expr::name(format!("{others}U"));
            Some(Expr::binary("<", Expr::cast("uint32_t", self.word(operand)), end))
        };
        match condition.filter(|_| others > 0) {
            Some(condition) => {
                let value = self.word(operand);
                Expr::Conditional(Box::new(condition), Box::new(value), Box::new(last))
            }
            None => last,
        }
    }

    pub(super) fn check_variants(&mut self) {
        if self.signature.returned != Returned::Status {
            return;
        }
        for Outside { parameter, path, id } in outside::enums(self.context.module, self.function) {
            let Some(binding) = self.bindings[parameter].clone() else { continue };
            let value = path.into_iter().fold(bound(&binding), |value, (of, field)| {
                value.field(&self.context.names.structs[of.index()].fields[field])
            });
            self.check_variant(value, id);
        }
    }

    fn check_variant(&mut self, value: Expr, id: EnumId) {
        let item = &self.context.module.enums[id.index()];
        let count = item.variants.len();
        let fault = Expr::name(self.context.names.status.fault(Fault::Variant));
        let then = self.scope(|lower| lower.fail(fault));
        if item.is_numbered() {
            let labels = &self.context.names.enums[id.index()].variants;
            let labels = labels.iter().map(Expr::name).collect();
            let known = SwitchArm { labels, default: false, body: Vec::new() };
            let other = SwitchArm { labels: Vec::new(), default: true, body: then };
            self.emit(StmtKind::Switch { scrutinee: value, arms: vec![known, other] });
            return;
        }
        let end = Expr::name(format!("{count}U"));
        let condition = Expr::binary(">=", Expr::cast("uint32_t", value), end);
        self.emit(StmtKind::If { condition, then, otherwise: Vec::new() });
    }
}
