//! Calls: passing of arguments, destination of the result, and handling of faults.

use bessemer_ir::{Argument, Expr as Ir, ExprKind, FunctionId, Place, Type};

use super::super::signature::{Passing, Returned};
use super::super::tree::{Expr, StmtKind, Storage};
use super::Lower;
use super::copy::indexed_by;
use crate::late::early;
use bessemer_ir::effects::{overlap, reads_place};

impl Lower<'_> {
    /// Returns a call as an expression; its result is one word, and it cannot fault.
    pub(super) fn call_value(&mut self, callee: FunctionId, arguments: &[Argument]) -> Expr {
        let list = self.arguments(callee, arguments);
        Expr::call(self.context.names.called(self.id, callee), list)
    }

    /// Emits an expression for its effect.
    pub(super) fn effect(&mut self, value: &Ir) {
        let ExprKind::Call(callee, arguments) = &value.kind else {
            if value.ty.is_word() {
                let value = self.word(value);
                self.emit(StmtKind::Expr(Expr::cast("void", value)));
            }
            return;
        };
        let signature = self.context.names.signature(*callee);
        let receives = signature.params.len() > arguments.len();
        match (&signature.returned, receives) {
            (_, true) => {
                let block = self.scope(|lower| {
                    let name = lower.fresh("unused");
                    lower.declare(&value.ty, &name, None, false);
                    lower.call_into(*callee, arguments, Expr::name(name), &value.ty);
                });
                self.emit(StmtKind::Block(block));
            }
            (Returned::Value(_), _) => {
                let call = self.call_value(*callee, arguments);
                self.emit(StmtKind::Expr(Expr::cast("void", call)));
            }
            (Returned::Nothing, _) => {
                let call = self.call_value(*callee, arguments);
                self.emit(StmtKind::Expr(call));
            }
            (Returned::Status, _) => {
                let list = self.arguments(*callee, arguments);
                self.guarded(*callee, list);
            }
        }
    }

    /// Emits a call whose result goes to a place of the author's, through a temporary if the callee could observe the
    /// difference.
    pub(super) fn call_into_place(
        &mut self,
        callee: FunctionId,
        arguments: &[Argument],
        dest: &Place,
    ) {
        let written: Vec<&Place> = arguments
            .iter()
            .filter_map(|argument| match argument {
                Argument::RefMut(place) => Some(place),
                _ => None,
            })
            .collect();
        let moved = indexed_by(dest, &written);
        let plain = matches!(self.context.names.signature(callee).returned, Returned::Value(_));
        let of = &self.context.module.functions[callee.index()];
        let early = early(of, self.context.faults.fallible(callee));
        let mut passed = arguments.iter().enumerate();
        let shared = !plain && passed.any(|(index, it)| !early.has(index) && lends(it, dest));
        if !moved && !shared {
            let place = self.place(dest);
            if plain {
                let call = self.call_value(callee, arguments);
                self.assign(place, call);
            } else {
                self.call_into(callee, arguments, place, &dest.ty);
            }
            return;
        }
        let block = self.scope(|lower| {
            let name = lower.fresh("next");
            lower.begin(&dest.ty, &name, &[]);
            if plain {
                let call = lower.call_value(callee, arguments);
                lower.assign(Expr::name(&name), call);
            } else {
                lower.call_into(callee, arguments, Expr::name(&name), &dest.ty);
            }
            let place = lower.place(dest);
            lower.copy(place, Expr::name(&name), &dest.ty, false);
        });
        self.emit(StmtKind::Block(block));
    }

    /// Emits a call that writes its result to `dest`, which shares no memory with its arguments.
    pub(super) fn call_into(
        &mut self,
        callee: FunctionId,
        arguments: &[Argument],
        dest: Expr,
        ty: &Type,
    ) {
        let signature = self.context.names.signature(callee);
        if let Returned::Value(_) = signature.returned {
            let call = self.call_value(callee, arguments);
            self.assign(dest, call);
            return;
        }
        let mut list = self.arguments(callee, arguments);
        if signature.params.len() > arguments.len() {
            list.push(Lower::address(dest, ty));
        }
        if signature.returned == Returned::Status {
            self.guarded(callee, list);
        } else {
            let name = self.context.names.called(self.id, callee);
            self.emit(StmtKind::Expr(Expr::call(name, list)));
        }
    }

    /// Emits a fallible call; a fault ends this function, too.
    fn guarded(&mut self, callee: FunctionId, list: Vec<Expr>) {
        let names = self.context.names;
        let status = Expr::name(&self.status);
        self.assign(status.clone(), Expr::call(&names.signature(callee).name, list));
        let then = self.scope(|lower| lower.fail(status.clone()));
        let ok = Expr::name(&names.status.ok);
        let condition = Expr::binary("!=", status, ok);
        self.emit(StmtKind::If { condition, then, otherwise: Vec::new() });
    }

    fn arguments(&mut self, callee: FunctionId, arguments: &[Argument]) -> Vec<Expr> {
        self.uses.called.insert(callee);
        let signature = self.context.names.signature(callee);
        match signature.storage {
            Storage::Library => {
                self.uses.system.insert("math.h");
            }
            // The file defines it.
            Storage::Static | Storage::OwnInline => {}
            _ => {
                self.uses.headers.insert(signature.header.clone());
            }
        }
        let mut list = Vec::new();
        for (argument, param) in arguments.iter().zip(&signature.params) {
            list.push(match argument {
                Argument::RefMut(place) => {
                    let value = self.place(place);
                    Lower::address(value, &place.ty)
                }
                Argument::Value(value) | Argument::Ref(value)
                    if param.passing == Passing::Value =>
                {
                    self.given(value)
                }
                Argument::Value(value) if self.needs_copy(value, arguments) => {
                    let name = self.fresh(&format!("{}_copy", param.name));
                    self.define(&value.ty, &name, value, true);
                    self.lend(Expr::name(name), &value.ty)
                }
                Argument::Value(value) | Argument::Ref(value) => {
                    let operand = self.operand(value);
                    self.lend(operand, &value.ty)
                }
            });
        }
        list
    }

    /// Returns true if the callee could change a value that C passes by address.
    fn needs_copy(&self, value: &Ir, arguments: &[Argument]) -> bool {
        arguments.iter().any(|other| match other {
            Argument::RefMut(place) => reads_place(value, place),
            _ => false,
        })
    }

    /// Returns the address of a value that the callee only reads. C99 does not convert an array of arrays to an array
    /// of const arrays implicitly.
    fn lend(&mut self, value: Expr, ty: &Type) -> Expr {
        let (element, dimensions) = self.context.names.type_parts(ty);
        let inner = dimensions.find(']').map(|end| &dimensions[end + 1..]).unwrap_or_default();
        if inner.is_empty() {
            Lower::address(value, ty)
        } else {
            Expr::cast(&format!("const {element} (*){inner}"), value)
        }
    }
}

/// Returns true if an argument passes memory to the callee that `dest` shares.
fn lends(argument: &Argument, dest: &Place) -> bool {
    match argument {
        Argument::RefMut(place) => overlap(place, dest),
        Argument::Value(value) | Argument::Ref(value) => {
            value.ty.is_aggregate() && reads_place(value, dest)
        }
    }
}
