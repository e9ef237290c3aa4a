//! Which methods of numbers and slices the DSL owns, and what paths lead to them.

/// The methods that the DSL owns: their result in the last bits, at ±0 or for NaN depends on the
/// platform, they do not exist without std, or core leaves open which of equal elements they find.
pub const OWNED: &[&str] = &[
    "abs",
    "acos",
    "acosh",
    "asin",
    "asinh",
    "atan",
    "atan2",
    "atanh",
    "binary_search",
    "binary_search_by",
    "binary_search_by_key",
    "cbrt",
    "ceil",
    "clamp",
    "copysign",
    "cos",
    "cosh",
    "div_euclid",
    "exp",
    "exp2",
    "exp_m1",
    "floor",
    "fract",
    "hypot",
    "is_sign_negative",
    "is_sign_positive",
    "ln",
    "ln_1p",
    "log",
    "log10",
    "log2",
    "max",
    "min",
    "mul_add",
    "partition_point",
    "powf",
    "powi",
    "rem_euclid",
    "round",
    "signum",
    "sin",
    "sin_cos",
    "sinh",
    "sqrt",
    "tan",
    "tanh",
    "to_be_bytes",
    "to_bits",
    "to_degrees",
    "to_le_bytes",
    "to_radians",
    "total_cmp",
    "trunc",
    "udu",
];

/// The DSL's name of an owned method.
pub fn owned(name: &syn::Ident) -> Option<syn::Ident> {
    let text = name.to_string();
    OWNED.contains(&text.as_str()).then(|| syn::Ident::new(&format!("dsl_{text}"), name.span()))
}

/// Whether a path ends in a function of a type, and not of a module.
pub fn associated(qself: Option<&syn::QSelf>, path: &syn::Path) -> bool {
    let before = path.segments.iter().rev().nth(1).map(|segment| segment.ident.to_string());
    qself.is_some()
        || before.is_some_and(|before| {
            before.starts_with(|first: char| first.is_uppercase())
                || bessemer_ir::Scalar::from_name(&before).is_some()
        })
}
