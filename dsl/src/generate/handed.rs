//! Functions and constructors as arguments: rustc's information about them, and the closures that replace them.
//!
//! The serialised tree has only closures: each calls its function with its own arguments.

use alloc::boxed::Box;
use alloc::string::ToString;
use alloc::vec::Vec;
use core::marker::PhantomData;

use bessemer_tree as tree;
use bessemer_tree::visit::{VisitMut, walk_expr_mut};
use bessemer_tree::{Closure, Expr, ExprKind, Pattern, Ty};

use super::builder::{Builder, Witness};
use super::slot::{Called, DslType, Evaluated, Seen, Slot};

/// A companion with parameters of the types `A`.
pub trait CompanionOf<A> {
    /// Marker of the function.
    type Marker;
    /// Result type.
    type Result: Seen;
}

/// A function with parameters of the types `A`. For one without parameters, its result type is `R`, since nothing
/// else determines it: `unwrap_or_else(Vector2::zeros)`.
pub trait Takes<A, R> {}

/// Passes a function through; slots record its companion, and the types of its arguments and its result.
pub fn __function<A: Seen, C: CompanionOf<A>, F: Takes<A, C::Result>>(
    _: &Slot<C::Marker>,
    _: &Slot<A::Slot>,
    _: &Slot<<C::Result as Seen>::Slot>,
    _: C,
    function: F,
) -> F {
    function
}

/// A value or a constructor; `K` distinguishes the two implementations.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a type of the DSL",
    label = "not a type of the DSL",
    note = "the DSL has scalars, arrays, nalgebra's `SMatrix` and `SVector`, and types marked `#[data]` or `#[component]`"
)]
pub trait Made<K>: Sized {
    /// Type in the slot.
    type Slot;
    /// Returns the value; for a constructor, a constant of its result type without words.
    fn constant(self, cx: &mut Builder) -> tree::Constant;
}

/// Key of implementations for values themselves.
pub struct Itself;

impl<T: Evaluated> Made<Itself> for T {
    type Slot = T;
    fn constant(self, cx: &mut Builder) -> tree::Constant {
        self.evaluated(cx)
    }
}

/// Type in a slot for a constructor of an `R` from parts of the types `A`.
pub struct Constructor<A, R>(PhantomData<(A, R)>);

impl<A: DslType, R> DslType for Constructor<A, R> {
    fn ty(cx: &mut Builder) -> Ty {
        A::ty(cx)
    }
}

/// Passes a value or a constructor through, and records its type in the slot.
pub fn __made<K, T: Made<K>>(_: &Slot<T::Slot>, value: T) -> T {
    value
}

/// Returns the value of a path that rustc evaluated, or the result type of a constructor.
pub fn made<K, T: Made<K>>(cx: &mut Builder, _: &Slot<T::Slot>, value: T) -> tree::Constant {
    value.constant(cx)
}

macro_rules! of_arguments {
    ($($($of:ident),*;)*) => {$(
        impl<F: FnOnce($($of),*) -> Called<M, R>, M, R: Seen, $($of),*> CompanionOf<($($of,)*)> for F {
            type Marker = M;
            type Result = R;
        }

        impl<F: FnOnce($($of),*) -> R, R: DslType, $($of: DslType),*> Made<($($of,)*)> for F {
            type Slot = Constructor<($($of,)*), R>;
            fn constant(self, cx: &mut Builder) -> tree::Constant {
                tree::Constant { ty: R::ty(cx), words: Vec::new() }
            }
        }
    )*};
}

of_arguments! { ; A; A, B; A, B, C; }

impl<F: FnOnce() -> R, R> Takes<(), R> for F {}

macro_rules! takes {
    ($($($of:ident),*;)*) => {$(
        impl<F: FnOnce($($of),*) -> Native, Native, R, $($of),*> Takes<($($of,)*), R> for F {}
    )*};
}

takes! { A; A, B; A, B, C; }

/// Replaces functions and constructors by closures, and constants that refer to arrays by the arrays; records the
/// operator of each sum.
pub(super) fn as_closures(tree: &mut tree::FunctionTree, witness: &mut Witness) {
    Closures { witness, operators: &mut tree.operators }.block(&mut tree.body);
    for constant in &mut witness.constants {
        constant.ty = array(&constant.ty).unwrap_or(&constant.ty).clone();
    }
}

/// Returns the array to which a constant refers.
pub(super) fn array(ty: &Ty) -> Option<&Ty> {
    match ty {
        Ty::Ref(array, _) => Some(array),
        _ => None,
    }
}

struct Closures<'w> {
    witness: &'w mut Witness,
    operators: &'w mut Vec<tree::Operator>,
}

impl Closures<'_> {
    /// Returns true if a path is a constant that refers to an array.
    fn refers(&self, path: &ExprKind) -> bool {
        let ExprKind::Path(constant, _) = path else { return false };
        let constant = self.witness.constants.get(*constant as usize);
        constant.is_some_and(|it| array(&it.ty).is_some())
    }

    /// Records the operator with which a call adds.
    fn note_sum(&mut self, expr: &Expr) {
        use tree::{Builtin, Callee, Desugared, Together};
        let ExprKind::Call(callee, _) = expr.kind else { return };
        let sum = Callee::Builtin(Builtin::Desugared(Desugared::Together(Together::Sum)));
        if let (Some(at), Some(callee)) = (expr.slot, self.witness.callees.get(callee as usize))
            && *callee == sum
        {
            let operands = Vec::from([expr.slot; 2]);
            self.operators.push(tree::Operator { at, of: "Add".to_string(), operands });
        }
    }

    fn slot(&mut self, ty: Ty) -> u32 {
        self.witness.slots.push(ty);
        self.witness.slots.len() as u32 - 1
    }

    /// Returns the parameters of a closure, and equal arguments, from the types in a slot.
    fn parameters(&mut self, slot: u32, site: tree::Site) -> (Vec<Pattern>, Vec<Expr>) {
        let types = match self.witness.slots.get(slot as usize) {
            Some(Ty::Tuple(types)) => types.clone(),
            _ => Vec::new(),
        };
        let names = match types.len() {
            2 => ["gathered", "value", ""],
            _ => ["value", "second", "third"],
        };
        let of = |(ty, name): (Ty, &str)| {
            let pattern = Pattern::Name {
                name: name.to_string(),
                slot: self.slot(ty),
                mutable: false,
                inner: None,
            };
            (pattern, Expr { kind: ExprKind::Local(name.to_string()), site, slot: None })
        };
        types.into_iter().zip(names).map(of).unzip()
    }

    /// Returns the type that a path constructs, if it is not a value.
    fn made(&self, constant: u32, slot: u32) -> Option<Ty> {
        let constant = self.witness.constants.get(constant as usize)?;
        let made = self.witness.slots.get(slot as usize) != Some(&constant.ty);
        made.then(|| constant.ty.clone())
    }
}

impl VisitMut for Closures<'_> {
    fn expr(&mut self, expr: &mut Expr) {
        walk_expr_mut(self, expr);
        self.note_sum(expr);
        if self.refers(&expr.kind) {
            let array = Expr { slot: None, ..expr.clone() };
            *expr =
                Expr { kind: ExprKind::Ref(false, Box::new(array)), slot: None, site: expr.site };
            return;
        }
        let Some(slot) = expr.slot else { return };
        let site = expr.site;
        let (name, parameters, body) = match &mut expr.kind {
            ExprKind::Closure(closure) => {
                let ExprKind::Call(callee, _) = closure.body.kind else { return };
                let (parameters, arguments) = self.parameters(slot, site);
                let kind = ExprKind::Call(callee, arguments);
                (closure.name.take(), parameters, Expr { kind, site, slot: closure.body.slot })
            }
            ExprKind::Path(constant, path) => {
                let Some(made) = self.made(*constant, slot) else { return };
                let name = path.rsplit("::").next().unwrap_or_default().to_string();
                let (parameters, parts) = self.parameters(slot, site);
                let kind = ExprKind::Constructor(name, parts);
                (None, parameters, Expr { kind, site, slot: Some(self.slot(made)) })
            }
            _ => return,
        };
        let closure = Closure { name, parameters, body: Box::new(body) };
        *expr = Expr { kind: ExprKind::Closure(closure), site, slot: None };
    }
}
