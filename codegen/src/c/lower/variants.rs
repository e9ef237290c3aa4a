//! What an entry point says of an enum that it is handed and that holds none of its variants.
//!
//! One that returns a status says so before it does anything; one that is claimed to be infallible has no way to,
//! and takes the last arm of a `match`. Looked at are enums that are passed, by themselves or as fields of
//! structs; not the elements of arrays, and not payloads.

use bessemer_ir::{Fault, Form, Owner, Role, Type};

use super::super::names::Returned;
use super::super::tree::{Expr, StmtKind, SwitchArm};
use super::{Lower, bound};

impl Lower<'_> {
    pub(super) fn check_variants(&mut self) {
        let entry = matches!(self.function.role, Role::Entry { .. });
        if !entry || self.signature.returned != Returned::Status {
            return;
        }
        let function = self.function;
        for (index, local) in function.parameters().iter().enumerate() {
            // A component's state is what its entry points made of it.
            let own = matches!((function.owner, &local.ty),
                (Some(Owner::Struct(owner)), Type::Struct(id)) if index == 0 && *id == owner);
            let Some(binding) = self.bindings[index].clone().filter(|_| !own) else { continue };
            self.check_variant(bound(&binding), &local.ty);
        }
    }

    fn check_variant(&mut self, value: Expr, ty: &Type) {
        match ty {
            Type::Enum(id) => {
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
            Type::Struct(id) => {
                let item = &self.context.module.structs[id.index()];
                let names = &self.context.names.structs[id.index()].fields;
                // What a tag did not choose means nothing.
                let looked_at = if item.form == Form::Record { item.fields.len() } else { 1 };
                for (field, name) in item.fields.iter().zip(names).take(looked_at) {
                    self.check_variant(value.clone().field(name), &field.ty);
                }
            }
            _ => {}
        }
    }
}
