//! Handles enums from outside that hold no valid variant.
//!
//! An invalid value counts as the variant that the author chose (`#[c(fallback)]`), or as the last, where a proof needs
//! a variant ([`Intrinsic::Variant`](bessemer_ir::Intrinsic::Variant)) and in each `match`. With a hook, a `match` without
//! such a choice calls it. An entry point that returns a status tests its enums first and reports the fault. Tested are enums that are arguments or fields of
//! struct arguments, not elements of arrays or payloads.

use bessemer_ir::{EnumId, Expr as Ir, Fault, Type};

use super::super::corrupted::{Corrupted, Enum};
use super::super::outside::{self, Outside};
use super::super::signature::Returned;
use super::super::tree::{Expr, StmtKind, SwitchArm};
use super::{Lower, bound};

impl Lower<'_> {
    /// Returns an enum, or the variant as which an invalid value counts.
    pub(super) fn variant(&mut self, operand: &Ir, id: EnumId) -> Expr {
        let item = &self.context.module.enums[id.index()];
        let names = self.context.names.enums[id.index()].variants.clone();
        let others = names.len().saturating_sub(1);
        let Some(last) = names.get(item.fallback()).map(Expr::name) else {
            return self.word(operand);
        };
        let condition = if item.is_numbered() {
            let equal = |(_, name): (usize, &String)| {
                Expr::binary("==", self.word(operand), Expr::name(name))
            };
            let other = |(at, _): &(usize, &String)| *at != item.fallback();
            let equal = names.iter().enumerate().filter(other).map(equal);
            equal.reduce(|a, b| Expr::binary("||", a, b))
        } else {
            let end = if item.fallback() == others { others } else { names.len() };
            let end = Expr::name(format!("{end}U"));
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

    /// Returns the variant that the author chose for invalid values of a type.
    pub(super) fn chosen(&self, ty: &Type) -> Option<i128> {
        let Type::Enum(id) = ty else { return None };
        let item = &self.context.module.enums[id.index()];
        item.has_fallback().then(|| item.fallback() as i128)
    }

    /// Places the cases for invalid values in the function's `switch` statements.
    pub(super) fn place_corrupted(&mut self) {
        let (module, names) = (self.context.module, self.context.names);
        let enums = module.enums.iter().zip(&names.enums).map(|(item, names)| Enum {
            variants: &names.variants,
            fallback: item.has_fallback().then(|| names.variants[item.fallback()].as_str()),
        });
        let fault = Expr::name(names.status.fault(Fault::Variant));
        let hook = names.status.hook.is_some().then(|| self.scope(|lower| lower.fail(fault)));
        let headers = self.uses.headers.clone();
        if !Corrupted::new(enums, hook).rewrite(&mut self.out) {
            self.uses.headers = headers;
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
