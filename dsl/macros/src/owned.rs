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
    let (float, name) = float_method(&last.to_string()).filter(|_| first == "libm")?;
    let (float, name) = [float, name].map(|it| syn::Ident::new(it, last.span())).into();
    Some(syn::parse_quote!(#float::#name))
}

/// The float and its method for the name of a function of `libm`.
fn float_method(text: &str) -> Option<(&'static str, &'static str)> {
    let named = |text: &str| {
        let other = LIBM.iter().find(|(theirs, _)| *theirs == text).map(|(_, ours)| *ours);
        other.or_else(|| OWNED.iter().copied().find(|ours| *ours == text))
    };
    let single = || text.strip_suffix('f').and_then(named).map(|name| ("f32", name));
    named(text).map(|name| ("f64", name)).or_else(single)
}

/// Returns true if `libm` may have a function of this name.
pub fn is_of_libm(name: &syn::Ident) -> bool {
    float_method(&name.to_string()).is_some()
}

/// The free functions of `num_traits` that the DSL has.
const NUM_TRAITS: [&str; 5] = ["abs", "cast", "one", "signum", "zero"];

/// Returns true if `num_traits` may have a free function of this name.
pub fn is_of_num_traits(name: &syn::Ident) -> bool {
    NUM_TRAITS.iter().any(|it| name == it)
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

/// Returns true if a function's path leads through one of these traits.
pub fn is_of_nalgebra(path: &syn::Path) -> bool {
    let home = path.segments.iter().rev().nth(1);
    home.is_some_and(|home| FIELDS.iter().any(|it| home.ident == it))
}

/// Traits of numbers of `num_traits`, and the DSL's own.
const NUMBERS: [&str; 5] = ["Euclid", "Float", "FloatCore", "Real", "Signed"];

/// Rewrites a call by the path of its trait as a method call: `ComplexField::sin(x)` and `<T as Float>::sin(x)` become
/// `x.sin()`. Code without std has to use such paths where it cannot name a type.
///
/// A trait of `num_traits` is recognized by `is_of_num_traits`, since an author may have a type of such a name.
pub fn by_method(
    it: &syn::ExprCall,
    is_of_num_traits: fn(&syn::Path) -> bool,
) -> Option<syn::Expr> {
    let syn::Expr::Path(syn::ExprPath { qself, path, .. }) = &*it.func else { return None };
    let mut last = path.segments.iter().rev();
    let (name, home) = (&last.next()?.ident, &last.next()?.ident);
    let of_numbers = || {
        let count = path.segments.len() - 1;
        let home: Vec<_> = path.segments.iter().take(count).collect();
        qself.is_some() || is_of_num_traits(&syn::parse_quote!(#(#home)::*))
    };
    let is_trait =
        FIELDS.iter().any(|it| home == it) || NUMBERS.iter().any(|it| home == it) && of_numbers();
    owned(name).filter(|_| is_trait)?;
    if let Some(qself) = qself
        && matches!(it.args.first(), Some(syn::Expr::Lit(_) | syn::Expr::Unary(_)))
    {
        // A literal has the type that is named.
        let (ty, arguments) = (&qself.ty, &it.args);
        return Some(syn::parse_quote! { <#ty>::#name(#arguments) });
    }
    let (receiver, rest) = (it.args.first()?, it.args.iter().skip(1));
    Some(syn::parse_quote! { (#receiver).#name(#(#rest),*) })
}

/// Returns the DSL's function in the witness copy for a free function of nalgebra.
pub fn of_nalgebra(path: &syn::Path) -> Option<syn::Path> {
    let [home, last] = path.segments.iter().collect::<Vec<_>>()[..] else { return None };
    let is = |ident: &syn::Ident, known: &[&str]| known.iter().any(|it| ident == it);
    let known = ["convert", "distance", "distance_squared"];
    let mut last = last.clone();
    if is(&home.ident, &["nalgebra", "na"]) && is(&last.ident, &["zero", "one"]) {
        return Some(syn::parse_quote!(::bessemer::generate::numeric::#last));
    }
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

/// Returns the DSL's function in the witness copy for a free function of `num_traits`, or for `NumCast::from` and the
/// like, which name no type.
pub fn of_num_traits(path: &syn::Path) -> Option<syn::Path> {
    let mut last = path.segments.iter().rev();
    let (name, home) = (last.next()?, &last.next()?.ident);
    if home == "num_traits" && is_of_num_traits(&name.ident) {
        return Some(syn::parse_quote!(::bessemer::generate::numeric::#name));
    }
    let function = match (home.to_string().as_str(), name.ident.to_string().as_str()) {
        ("NumCast", "from") => "cast",
        ("Zero", "zero") => "zero",
        ("One", "one") => "one",
        _ => return None,
    };
    let function = syn::Ident::new(function, name.ident.span());
    Some(syn::parse_quote!(::bessemer::generate::numeric::#function))
}

/// Module and names of core's iterators that a closure makes.
pub const MADE: (&str, &[&str]) = ("iter", &["from_fn", "successors"]);

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
                || bessemer_tree::number::is_number(&before)
        })
}
