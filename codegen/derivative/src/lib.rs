//! Differentiates functions of the IR in forward mode, and numbers in reverse mode, and prints the derivative as Rust.
//!
//! The function is evaluated on values whose numbers are expressions, each with its derivatives by the variables on
//! which it depends. Those variables are known for each number, so zeros and ones are never computed. Branches on
//! unknown conditions stay branches, long loops stay loops; calls are inlined.
//!
//! Invariants:
//!
//! * Values have the operations of the function in its order, so the bits of the value are the function's.
//! * The derivative at a branch is the derivative of the branch taken. Whole numbers, booleans and enums are constant, and so
//!   is a rounded number.
//!
//! Must not know: the author's syntax, or C.

mod clean;
mod control;
mod covariance;
mod expression;
mod extreme;
mod fold;
mod join;
mod linear;
mod loops;
mod place;
mod reverse;
mod rules;
mod run;
mod rust;
mod solve;
mod value;

use bessemer_ir::{Expr, ExprKind, Float, Function, FunctionId, Mode, Module, Scalar, Span, Type};

pub use rust::body;

/// A reason why a function has no derivative, at its place.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Problem {
    /// Place of the reason.
    pub span: Span,
    /// The mistake.
    pub message: String,
    /// The remedy.
    pub help: String,
}

/// A result, or the reason why there is none.
pub type Result<T> = std::result::Result<T, Problem>;

impl Problem {
    /// Creates a problem.
    pub fn new(span: Span, message: impl Into<String>, help: impl Into<String>) -> Problem {
        Problem { span, message: message.into(), help: help.into() }
    }
}

/// Derivatives that a function computes besides the value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Jacobians, in forward mode.
    Jacobians,
    /// Gradients of a number, in reverse mode. Each has the type of its parameter.
    Gradients,
}

/// A request for the value of a function and its derivatives by some of its parameters.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Request {
    /// Differentiated function.
    pub of: FunctionId,
    /// Parameters by which it is differentiated, by their indices.
    pub by: Vec<usize>,
    /// The derivatives.
    pub kind: Kind,
    /// Function that computes the value and the derivatives. It has the parameters of `of`.
    pub into: FunctionId,
}

/// Returns the function of a request, with the body of the derivative. Its calls are calls of functions in the returned module,
/// which has the elementary functions that the derivative needs.
///
/// # Errors
///
/// A function without a derivative, or a signature that does not fit.
pub fn derivative(module: &Module, request: &Request) -> Result<(Module, Function)> {
    check(module, request)?;
    let mut run = run::Run::new(module, request);
    let body = match request.kind {
        Kind::Jacobians => run.whole(request)?,
        Kind::Gradients => run.gradient(request)?,
    };
    let declared = &module.functions[request.into.index()];
    let (module, locals) = run.finish();
    let mut function = Function { locals, body, ..declared.clone() };
    clean::clean(&mut function);
    Ok((module, function))
}

/// Returns the name of the variable's type, and the number of variables of a parameter.
fn variables(module: &Module, ty: &Type) -> Option<(Float, u32)> {
    let leaves = module.leaves(ty);
    let float = leaves.first()?.as_float()?;
    let all = leaves.iter().all(|leaf| leaf.as_float() == Some(float));
    all.then_some((float, leaves.len() as u32))
}

/// Returns the type of a Jacobian.
fn jacobian(float: Float, rows: u32, cols: u32) -> Type {
    match (rows, cols) {
        (1, 1) => Type::Scalar(Scalar::Float(float)),
        _ => Type::Matrix { element: Scalar::Float(float), rows, cols },
    }
}

fn check(module: &Module, request: &Request) -> Result<()> {
    let of = &module.functions[request.of.index()];
    let into = &module.functions[request.into.index()];
    if let Some(written) = of.parameters().iter().find(|it| it.mode == Mode::RefMut) {
        return Err(Problem::new(
            into.span,
            format!("`{}` writes through `{}`, and has no derivative", of.name, written.name),
            "return the new value from a function that takes `&` references",
        ));
    }
    let fits =
        |(a, b): (&bessemer_ir::Local, &bessemer_ir::Local)| a.ty == b.ty && a.mode == b.mode;
    let mut pairs = of.parameters().iter().zip(into.parameters());
    let gradients = request.kind == Kind::Gradients;
    let propagates = !gradients && covariance(module, request).is_some();
    if of.params + u32::from(propagates) != into.params || !pairs.all(fits) {
        return Err(Problem::new(
            into.span,
            format!("`{}` does not have the parameters of `{}`", into.name, of.name),
            format!("declare the parameters of `{}` in their order", of.name),
        ));
    }
    let Some((float, rows)) = variables(module, &of.result) else {
        return Err(Problem::new(
            into.span,
            format!("the result of `{}` has parts that are no floats of one type", of.name),
            "differentiate a function whose result is a float, a vector, or a struct of them",
        ));
    };
    if gradients && !of.result.is_word() {
        return Err(Problem::new(
            into.span,
            format!("the result of `{}` is no number, and has no gradient", of.name),
            format!("write `derivative({}, …)` for its Jacobian", of.name),
        ));
    }
    let mut expected = vec![of.result.clone()];
    for &index in &request.by {
        let parameter = &of.parameters()[index];
        let Some((_, cols)) = variables(module, &parameter.ty).filter(|it| it.0 == float) else {
            return Err(Problem::new(
                into.span,
                format!("`{}` is no {}, and has no derivative", parameter.name, float.name()),
                "name parameters that are floats, vectors, matrices or structs of them",
            ));
        };
        expected.push(match gradients {
            true => parameter.ty.clone(),
            false => jacobian(float, rows, cols),
        });
    }
    if let Some(covariance) = covariance(module, request).filter(|_| propagates) {
        return propagation(module, request, covariance, rows);
    }
    let declared: Vec<Type> = match &into.result {
        Type::Struct(id) => {
            module.structs[id.index()].fields.iter().map(|field| field.ty.clone()).collect()
        }
        _ => Vec::new(),
    };
    if declared != expected {
        let shown = expected.iter().map(|ty| rust::type_name(module, ty, &into.module));
        let shown = shown.collect::<Vec<_>>().join(", ");
        return Err(Problem::new(
            into.span,
            format!(
                "`{}` has another result than the value and the {} of `{}`",
                into.name,
                if gradients { "gradients" } else { "Jacobians" },
                of.name
            ),
            format!("write `-> ({shown})`"),
        ));
    }
    Ok(())
}

/// Returns the parameter that a derivative has besides those of its function: a covariance that it propagates.
fn covariance<'m>(module: &'m Module, request: &Request) -> Option<&'m bessemer_ir::Local> {
    let of = &module.functions[request.of.index()];
    let more = module.functions[request.into.index()].parameters().get(of.params as usize..)?;
    more.first().filter(|it| more.len() == 1 && it.mode == Mode::RefMut)
}

/// Checks the signature of a function that propagates a covariance.
fn propagation(
    module: &Module,
    request: &Request,
    covariance: &bessemer_ir::Local,
    rows: u32,
) -> Result<()> {
    let of = &module.functions[request.of.index()];
    let into = &module.functions[request.into.index()];
    let [by] = request.by.as_slice() else {
        return Err(Problem::new(
            into.span,
            format!("`{}` propagates a covariance by several parameters", into.name),
            "name the state alone: `derivative(advanced, state)`",
        ));
    };
    let state = &of.parameters()[*by];
    if variables(module, &state.ty).is_none_or(|it| it.1 != rows) {
        return Err(Problem::new(
            into.span,
            format!("the result of `{}` is no state of the size of `{}`", of.name, state.name),
            "propagate a covariance by a function that returns the next state",
        ));
    }
    let root = bessemer_ir::LocalId(of.params);
    let found = covariance::elements(module, root, &covariance.ty, rows, into.span);
    let float = variables(module, &of.result).map(|it| Type::Scalar(Scalar::Float(it.0)));
    if found.is_none_or(|it| Some(it.1) != float) {
        return Err(Problem::new(
            into.span,
            format!(
                "`{}` is no covariance of the {rows} numbers of `{}`",
                covariance.name, of.name
            ),
            format!("write `{}: &mut Symmetric<{}, {rows}>`", covariance.name, name_of(float)),
        ));
    }
    if into.result != of.result {
        let result = rust::type_name(module, &of.result, &into.module);
        return Err(Problem::new(
            into.span,
            format!(
                "`{}` propagates a covariance, and has another result than `{}`",
                into.name, of.name
            ),
            format!("write `-> {result}`"),
        ));
    }
    Ok(())
}

fn name_of(ty: Option<Type>) -> &'static str {
    ty.and_then(|ty| ty.as_float()).unwrap_or(Float::F64).name()
}

/// Returns a literal float.
fn float(value: f64, ty: &Type, span: Span) -> Expr {
    let word = match ty.as_float() {
        Some(Float::F32) => u64::from((value as f32).to_bits()),
        _ => value.to_bits(),
    };
    Expr::literal(word, ty.clone(), span)
}

/// Returns the value of a literal float.
fn known(expr: &Expr) -> Option<f64> {
    let ExprKind::Literal(word) = expr.kind else { return None };
    match expr.ty.as_float()? {
        Float::F32 => Some(f64::from(f32::from_bits(word as u32))),
        Float::F64 => Some(f64::from_bits(word)),
    }
}
