//! Methods of numbers and slices that the DSL owns, and the paths that lead to them.

/// The methods that the DSL owns. Their results depend on the platform in the last bits, at ±0 or for NaN; or they do
/// not exist without std; or core does not specify which of equal elements they find.
pub const OWNED: &[&str] = &[
    "abs",
    "acos",
    "acosh",
    "arg",
    "argument",
    "asin",
    "asinh",
    "atan",
    "atan2",
    "atanh",
    "axis_angle",
    "binary_search",
    "binary_search_by",
    "binary_search_by_key",
    "cbrt",
    "ceil",
    "cis",
    "clamp",
    "copysign",
    "cos",
    "cosh",
    "div_euclid",
    "euler_angles",
    "exp",
    "exp2",
    "exp_m1",
    "floor",
    "fract",
    "from_axis_angle",
    "from_euler_angles",
    "from_polar",
    "from_scaled_axis",
    "hypot",
    "is_sign_negative",
    "is_sign_positive",
    "ln",
    "ln_1p",
    "log",
    "log10",
    "log2",
    "lp_norm",
    "max",
    "min",
    "modulus",
    "mul_add",
    "partition_point",
    "powf",
    "powi",
    "rem_euclid",
    "rotation_between",
    "rotation_between_axis",
    "round",
    "scaled_axis",
    "scaled_rotation_between",
    "scaled_rotation_between_axis",
    "signum",
    "sin",
    "sin_cos",
    "sinh",
    "slerp",
    "sqrt",
    "tan",
    "tanh",
    "to_be_bytes",
    "to_bits",
    "to_degrees",
    "to_le_bytes",
    "to_polar",
    "to_radians",
    "total_cmp",
    "trunc",
    "udu",
];

/// Returns the DSL's name of an owned method.
pub fn owned(name: &syn::Ident) -> Option<syn::Ident> {
    let text = name.to_string();
    OWNED.contains(&text.as_str()).then(|| syn::Ident::new(&format!("dsl_{text}"), name.span()))
}

/// Returns the DSL's name for a function of the crate `libm` that equals a float's method: `libm::sinf` is
/// `f32::sin`. Its last bits depend on `libm`'s version.
pub fn of_libm(path: &syn::Path) -> Option<syn::Path> {
    let (first, last) = match path.segments.iter().collect::<Vec<_>>().as_slice() {
        [first, last] => (first.ident.to_string(), &last.ident),
        _ => return None,
    };
    let text = last.to_string();
    let named = |text: &str| {
        let other = LIBM.iter().find(|(theirs, _)| *theirs == text).map(|(_, ours)| *ours);
        other.or_else(|| OWNED.iter().copied().find(|ours| *ours == text))
    };
    let single = || text.strip_suffix('f').and_then(named).map(|name| ("f32", name));
    let (float, name) = named(&text).map(|name| ("f64", name)).or_else(single)?;
    let (float, name) = [float, name].map(|it| syn::Ident::new(it, last.span())).into();
    (first == "libm").then(|| syn::parse_quote!(#float::#name))
}

/// Returns the DSL's name of `new` for a type with the name of one of nalgebra's, whose `new` calls the platform's
/// sine and cosine. An author's type with that name has such a function, too.
pub fn of_turns(owner: &syn::Ident, name: &syn::Ident) -> Option<syn::Ident> {
    let turns = ["UnitQuaternion", "Rotation2", "Rotation3"].iter().any(|it| owner == it);
    (turns && name == "new").then(|| syn::Ident::new("dsl_new", name.span()))
}

/// Returns the DSL's name for the function at the end of a path, if the DSL owns it.
pub fn of_path(path: &syn::Path) -> Option<syn::Ident> {
    let mut last = path.segments.iter().rev();
    let name = &last.next()?.ident;
    owned(name).or_else(|| of_turns(&last.next()?.ident, name))
}

/// nalgebra's traits of numbers, whose paths may precede methods.
pub const FIELDS: [&str; 2] = ["ComplexField", "RealField"];

/// Rewrites a call by the path of its trait as a method call: `ComplexField::sin(x)` becomes `x.sin()`. Code without
/// std has to use such paths where it cannot name a type.
pub fn by_method(it: &syn::ExprCall) -> Option<syn::Expr> {
    let syn::Expr::Path(syn::ExprPath { qself: None, path, .. }) = &*it.func else { return None };
    let mut last = path.segments.iter().rev();
    let (name, home) = (&last.next()?.ident, &last.next()?.ident);
    owned(name).filter(|_| FIELDS.iter().any(|it| home == it))?;
    let (receiver, rest) = (it.args.first()?, it.args.iter().skip(1));
    Some(syn::parse_quote! { (#receiver).#name(#(#rest),*) })
}

/// Returns the DSL's function in the witness copy for a free function of nalgebra.
pub fn of_nalgebra(path: &syn::Path) -> Option<syn::Path> {
    let [home, last] = path.segments.iter().collect::<Vec<_>>()[..] else { return None };
    let is = |ident: &syn::Ident, known: &[&str]| known.iter().any(|it| ident == it);
    let known = ["convert", "distance", "distance_squared"];
    let mut last = last.clone();
    // `convert::<f64, T>`: what is converted is in double precision.
    if let syn::PathArguments::AngleBracketed(list) = &mut last.arguments
        && list.args.len() == 2
        && matches!(&list.args[0], syn::GenericArgument::Type(syn::Type::Path(it)) if it.path.is_ident("f64"))
    {
        list.args = list.args.iter().skip(1).cloned().collect();
    }
    (is(&home.ident, &["nalgebra", "na"]) && is(&last.ident, &known))
        .then(|| syn::parse_quote!(::bessemer::generate::generic::#last))
}

/// Module and name of core's iterator over one value.
pub const ONCE: (&str, &str) = ("iter", "once");

/// Functions of `libm` with other names than in Rust.
const LIBM: &[(&str, &str)] = &[
    ("expm1", "exp_m1"),
    ("fabs", "abs"),
    ("fma", "mul_add"),
    ("fmax", "max"),
    ("fmin", "min"),
    ("log", "ln"),
    ("log1p", "ln_1p"),
    ("pow", "powf"),
];

/// Returns true if a path ends in a function of a type, not of a module.
pub fn associated(qself: Option<&syn::QSelf>, path: &syn::Path) -> bool {
    let before = path.segments.iter().rev().nth(1).map(|segment| segment.ident.to_string());
    qself.is_some()
        || before.is_some_and(|before| {
            before.starts_with(|first: char| first.is_uppercase())
                || before == "char"
                || bessemer_tree::number::Scalar::from_name(&before).is_some()
        })
}
