//! Functions of the target's own `math.h`, for users who prefer them to the DSL's.
//!
//! A function that rounds once (`mul_add`) and one that is defined by its expansion (`powi`) remain the DSL's. `sin_cos`,
//! which C99 lacks, returns the library's sine and cosine.

use bessemer_ir::Function;

use super::signature::Signature;
use super::tree::{Expr, Stmt, StmtKind, plain};

/// Source of the elementary functions that the C calls.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Math {
    /// The DSL's, emitted with the models: the same bits as the Rust on every target.
    #[default]
    Portable,
    /// Functions of the target's `math.h`: the bits are the library's and can differ from the Rust's.
    Target,
}

/// Modules of elementary functions in double precision: Rust names and C names.
const DOUBLE: &[(&str, &[(&str, &str)])] = &[
    ("sine", &[("sin", "sin"), ("cos", "cos")]),
    ("tangent", &[("tan", "tan")]),
    ("arctangent", &[("asin", "asin"), ("acos", "acos"), ("atan", "atan"), ("atan2", "atan2")]),
    ("exponential", &[("exp", "exp"), ("exp2", "exp2"), ("exp_m1", "expm1")]),
    ("logarithm", &[("ln", "log"), ("log2", "log2"), ("log10", "log10"), ("ln_1p", "log1p")]),
    ("hyperbolic", &[("sinh", "sinh"), ("cosh", "cosh"), ("tanh", "tanh")]),
    ("power", &[("powf", "pow")]),
    ("roots", &[("cbrt", "cbrt"), ("hypot", "hypot")]),
];

/// Returns true for a module of functions in single precision, whose names in Rust and in C end with an additional
/// `f`.
fn is_of_f32(module: &str) -> bool {
    module == "bessemer::math::single" || module.starts_with("bessemer::math::narrow::")
}

/// Returns a macro of C99's `math.h` and its function. The macro says that the processor computes the function in an
/// instruction; with at most one rounding its bits are determined.
pub fn instruction(function: &Function) -> Option<(&'static str, &'static str)> {
    if function.owner.is_some() || !is_mathematics(&function.module) {
        return None;
    }
    match function.name.as_str() {
        "mul_add" => Some(("FP_FAST_FMA", "fma")),
        "mul_addf" | "exact_mul_addf" => Some(("FP_FAST_FMAF", "fmaf")),
        _ => None,
    }
}

/// Returns true if a Rust module contains elementary functions.
pub fn is_mathematics(module: &str) -> bool {
    module == "bessemer::math" || module.starts_with("bessemer::math::")
}

/// Returns the name in `math.h` of an elementary function. Only functions that return floats have one: proofs use
/// bounds of a function's integer result, which another implementation might not satisfy.
pub fn name(function: &Function) -> Option<String> {
    let gives_float = function.result.as_float().is_some();
    if function.owner.is_some() || !is_mathematics(&function.module) || !gives_float {
        return None;
    }
    if is_of_f32(&function.module) {
        let name = function.name.strip_suffix('f')?;
        let mut all = DOUBLE.iter().flat_map(|(_, names)| names.iter());
        return all.find(|(rust, _)| *rust == name).map(|(_, c)| format!("{c}f"));
    }
    let module = function.module.rsplit("::").next()?;
    let (_, names) = DOUBLE.iter().find(|(own, _)| *own == module)?;
    names.iter().find(|(rust, _)| *rust == function.name).map(|(_, c)| (*c).to_owned())
}

/// Returns the functions of `math.h` whose results a function returns in order; empty unless it is `sin_cos`.
pub fn parts(function: &Function) -> &'static [&'static str] {
    if function.owner.is_some() || !is_mathematics(&function.module) {
        return &[];
    }
    match function.name.as_str() {
        "sin_cos" => &["sin", "cos"],
        "sin_cosf" => &["sinf", "cosf"],
        _ => &[],
    }
}

/// Returns the body of a function with these [`parts`], whose result is a pair behind its last parameter.
pub fn body(signature: &Signature, parts: &[&str]) -> Vec<Stmt> {
    let [argument, result] = &signature.params[..] else { return Vec::new() };
    let assigned = parts.iter().zip(["first", "second"]).map(|(name, field)| {
        let pair = Expr::unary("*", Expr::name(&result.name));
        let value = Expr::call(*name, vec![Expr::name(&argument.name)]);
        plain(StmtKind::Assign(pair.field(field), "=", value))
    });
    assigned.collect()
}
