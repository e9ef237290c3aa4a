//! Names for values that the passes hold in locals, from their kinds and purposes.
//!
//! Two locals may have the same name. The C numbers one only where both are visible.

use bessemer_ir::{
    Argument, BinaryOp, Expr, ExprKind, Function, Intrinsic, LogicOp, Module, Place, Routine, Step,
    Type, UnaryOp,
};

/// The purpose of a value.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Purpose<'a> {
    /// An operand without a name, named after its kind.
    Operand,
    /// A part or a parameter with this name.
    Part(&'a str),
    /// A value with this name, without the whole's name.
    Named(&'a str),
}

/// Returns the preferred name for `expr`, which is held for the destination `base`.
pub(crate) fn wish(
    module: &Module,
    function: &Function,
    base: &str,
    purpose: Purpose,
    expr: &Expr,
) -> String {
    let role = match purpose {
        Purpose::Named(name) => return name.to_string(),
        Purpose::Part(name) => name.to_string(),
        Purpose::Operand => kind(module, function, expr),
    };
    match base {
        "" => role,
        // A flag that decides one value alone takes the name of that value.
        base if matches!(purpose, Purpose::Operand) && is_condition(expr) => base.to_string(),
        base if base == role => format!("{base}_value"),
        base => format!("{base}_{role}"),
    }
}

/// Returns the name of a place: its last field, or the local.
pub(crate) fn place(module: &Module, function: &Function, place: &Place) -> String {
    let root = function.local(place.root);
    let mut name = &root.name;
    let mut ty = Some(root.ty.clone());
    for step in &place.steps {
        let container = ty.take();
        ty = container.as_ref().and_then(|ty| module.step_type(ty, step));
        if let (Step::Field(field), Some(bessemer_ir::Type::Struct(id))) = (step, &container)
            && let Some(field) = module.structs[id.index()].fields.get(*field as usize)
        {
            name = &field.name;
        }
    }
    name.clone()
}

/// Returns one word for the kind of an expression.
fn kind(module: &Module, function: &Function, expr: &Expr) -> String {
    match &expr.kind {
        ExprKind::Literal(_) | ExprKind::Struct(_) => "value".to_string(),
        ExprKind::Const(id) => module.consts[id.index()].name.to_lowercase(),
        ExprKind::Load(from) => place(module, function, from),
        ExprKind::Unary(UnaryOp::Neg, _) => "opposite".to_string(),
        ExprKind::Unary(UnaryOp::Not, _) => "inverse".to_string(),
        ExprKind::Binary(op, ..) => binary(*op).to_string(),
        ExprKind::Logic(LogicOp::And, _, last) => answer(module, function, last),
        ExprKind::Compare(..) | ExprKind::Logic(..) => "condition".to_string(),
        ExprKind::Cast(inner) => kind(module, function, inner),
        ExprKind::Intrinsic(which, _) => intrinsic(*which).to_string(),
        ExprKind::Call(callee, _) => {
            let function = &module.functions[callee.index()];
            let kernel = function.kernel.as_ref();
            kernel.map_or_else(|| function.name.clone(), |it| it.routine.result().to_string())
        }
        ExprKind::Array(_) | ExprKind::Splat(_) => "elements".to_string(),
        ExprKind::Matrix(_) => match expr.ty {
            Type::Matrix { rows: 1, .. } | Type::Matrix { cols: 1, .. } => "vector".to_string(),
            _ => "matrix".to_string(),
        },
        ExprKind::Routine(which, _) => routine(*which).to_string(),
    }
}

/// Returns the name of the last condition in a chain, if it is a call: `gyroscope_says` for `gyroscope.says(…)`.
fn answer(module: &Module, function: &Function, last: &Expr) -> String {
    let ExprKind::Call(callee, arguments) = &last.kind else { return "condition".to_string() };
    let name = &module.functions[callee.index()].name;
    let of = match arguments.first() {
        Some(Argument::RefMut(of)) => Some(of),
        Some(Argument::Ref(Expr { kind: ExprKind::Load(of), .. })) => Some(of),
        _ => None,
    };
    match of.filter(|of| !of.steps.is_empty()) {
        Some(of) => format!("{}_{name}", place(module, function, of)),
        None => name.clone(),
    }
}

fn is_condition(expr: &Expr) -> bool {
    matches!(expr.kind, ExprKind::Compare(..) | ExprKind::Logic(..))
}

fn binary(op: BinaryOp) -> &'static str {
    match op {
        BinaryOp::Add => "sum",
        BinaryOp::Sub => "difference",
        BinaryOp::Mul => "product",
        BinaryOp::Div => "quotient",
        BinaryOp::Rem => "remainder",
        BinaryOp::And | BinaryOp::Or | BinaryOp::Xor => "bits",
        BinaryOp::Shl | BinaryOp::Shr => "shifted",
    }
}

fn intrinsic(which: Intrinsic) -> &'static str {
    match which {
        Intrinsic::Sqrt => "root",
        Intrinsic::Abs => "magnitude",
        Intrinsic::Min => "smaller",
        Intrinsic::Max => "larger",
        Intrinsic::Clamp => "clamped",
        Intrinsic::Floor => "floor",
        Intrinsic::ToBits | Intrinsic::RawBits => "bits",
        Intrinsic::FromBits => "value",
        Intrinsic::Copysign => "signed",
        Intrinsic::WrappingAdd => "sum",
        Intrinsic::WrappingSub => "difference",
        Intrinsic::WrappingMul => "product",
        Intrinsic::WrappingDiv => "quotient",
        Intrinsic::WrappingRem => "remainder",
        Intrinsic::SaturatingAdd => "sum",
        Intrinsic::SaturatingSub => "difference",
        Intrinsic::SaturatingMul => "product",
        Intrinsic::DivEuclid => "quotient",
        Intrinsic::RemEuclid => "remainder",
        Intrinsic::UnsignedAbs => "magnitude",
        Intrinsic::AbsDiff => "distance",
        Intrinsic::CountOnes => "ones",
        Intrinsic::LeadingZeros => "zeros",
        Intrinsic::TrailingZeros => "zeros",
        Intrinsic::SwapBytes => "swapped",
        Intrinsic::Variant => "variant",
        Intrinsic::Ceil => "ceiling",
        Intrinsic::Trunc => "whole",
        Intrinsic::Round => "rounded",
        Intrinsic::Signum => "sign",
        Intrinsic::IsNan => "undefined",
        Intrinsic::IsFinite => "finite",
        Intrinsic::IsInfinite => "infinite",
    }
}

fn routine(which: Routine) -> &'static str {
    match which {
        Routine::Add => "sum",
        Routine::Sub => "difference",
        Routine::Neg => "opposite",
        Routine::Scale | Routine::Unscale => "scaled",
        Routine::ComponentMul | Routine::Product | Routine::TrMul => "product",
        Routine::ComponentDiv => "quotient",
        Routine::Inf | Routine::Amin => "smaller",
        Routine::Sup | Routine::Amax => "larger",
        Routine::Abs => "magnitudes",
        Routine::Transpose => "transposed",
        Routine::Dot => "dot",
        Routine::Cross => "cross",
        Routine::Norm => "norm",
        Routine::NormSquared => "norm_squared",
    }
}
