//! Bounds on the traits of `num_traits` and nalgebra for numbers, such as `T: Zero`. Each implies traits of the DSL with
//! the methods and companions.
//!
//! `num_traits`' are recognized by their path or their import: an author may have traits of these names.

use proc_macro2::TokenStream;
use quote::{ToTokens, format_ident, quote};
use syn::TypeParamBound;

use crate::imports::{self, text};

/// Bounds that others imply.
const IMPLIED: [(&str, &[&str]); 10] = [
    ("Float", &["NumCast", "ToPrimitive", "PartialOrd"]),
    ("FloatCore", &["NumCast", "ToPrimitive", "PartialOrd"]),
    ("Real", &["NumCast", "ToPrimitive", "PartialOrd"]),
    ("NumCast", &["NumCast", "ToPrimitive"]),
    ("Num", &["Zero", "One"]),
    ("NumAssign", &["Zero", "One"]),
    ("Unsigned", &["Zero", "One"]),
    ("Signed", &["Zero", "One", "Signed"]),
    ("Saturating", &["Saturating"]),
    (
        "PrimInt",
        &[
            "Zero",
            "One",
            "NumCast",
            "ToPrimitive",
            "Bounded",
            "Saturating",
            "PrimInt",
            "PartialOrd",
            "Ord",
        ],
    ),
];

/// Bounds of core, and the companions that each implies.
const ORDERS: [(&str, &[&str]); 2] =
    [("PartialOrd", &["PartialOrd"]), ("Ord", &["PartialOrd", "Ord"])];

/// Bounds whose companions are in a trait of their name.
const OWN: [&str; 25] = [
    "Zero",
    "One",
    "Bounded",
    "Euclid",
    "AsPrimitive",
    "ToPrimitive",
    "FromPrimitive",
    "FloatConst",
    "WrappingAdd",
    "WrappingSub",
    "WrappingMul",
    "WrappingNeg",
    "WrappingShl",
    "WrappingShr",
    "SaturatingAdd",
    "SaturatingSub",
    "SaturatingMul",
    "CheckedAdd",
    "CheckedSub",
    "CheckedMul",
    "CheckedDiv",
    "CheckedRem",
    "CheckedNeg",
    "CheckedShl",
    "CheckedShr",
];

/// Returns the traits of companions, with their arguments, that a bound implies.
pub fn companions(bound: &TypeParamBound) -> Vec<TokenStream> {
    let TypeParamBound::Trait(bound) = bound else { return Vec::new() };
    let Some(last) = bound.path.segments.last() else { return Vec::new() };
    let name = text(&last.ident);
    let known = |table: &'static [(&str, &[&str])]| {
        table.iter().find(|(of, _)| *of == name).map(|(_, implied)| *implied)
    };
    let own = OWN.iter().find(|it| **it == name).map(std::slice::from_ref);
    let numeric = known(&IMPLIED).or(own).filter(|_| is_of_num_traits(&bound.path));
    // `PartialOrd<f32>` compares with another type.
    let order = known(&ORDERS).filter(|_| last.arguments.is_empty());
    let Some(names) = numeric.or(order) else { return Vec::new() };
    let arguments = &last.arguments;
    let path = |name: &&str| {
        let name = format_ident!("Any{name}Builtins");
        quote! { ::bessemer::generate::numeric::#name #arguments }
    };
    names.iter().map(path).collect()
}

/// Functions of traits that numbers of a known type have by the author's import of the trait.
const OF_KNOWN: [(&str, &[&str]); 6] = [
    ("AsPrimitive", &["as_"]),
    ("Zero", &["zero", "is_zero"]),
    ("One", &["one", "is_one"]),
    (
        "FloatConst",
        &[
            "E",
            "FRAC_1_PI",
            "FRAC_1_SQRT_2",
            "FRAC_2_PI",
            "FRAC_2_SQRT_PI",
            "FRAC_PI_2",
            "FRAC_PI_3",
            "FRAC_PI_4",
            "FRAC_PI_6",
            "FRAC_PI_8",
            "LN_10",
            "LN_2",
            "LOG10_2",
            "LOG10_E",
            "LOG2_10",
            "LOG2_E",
            "PI",
            "SQRT_2",
            "TAU",
        ],
    ),
    (
        "ToPrimitive",
        &[
            "to_i8", "to_i16", "to_i32", "to_i64", "to_isize", "to_u8", "to_u16", "to_u32",
            "to_u64", "to_usize", "to_f32", "to_f64",
        ],
    ),
    (
        "FromPrimitive",
        &[
            "from_i8",
            "from_i16",
            "from_i32",
            "from_i64",
            "from_isize",
            "from_u8",
            "from_u16",
            "from_u32",
            "from_u64",
            "from_usize",
            "from_f32",
            "from_f64",
        ],
    ),
];

/// Returns the traits of companions that a body needs for numbers of known types. It has a function of that name, and its file
/// imports the trait.
pub fn of_known(body: &syn::Block, span: proc_macro2::Span) -> Vec<syn::Ident> {
    let tokens = body.to_token_stream();
    let is_used = |(trait_name, names): &&(&str, &[&str])| {
        let names: Vec<String> = names.iter().map(|&name| name.to_owned()).collect();
        mentions(tokens.clone(), &names)
            && is_of_num_traits(&syn::Ident::new(trait_name, span).into())
    };
    let used = OF_KNOWN.iter().filter(is_used);
    used.map(|(name, _)| format_ident!("Any{name}Builtins")).collect()
}

/// Returns true if a trait is one of `num_traits` that a type of the author's may implement.
pub fn is_own(path: &syn::Path) -> bool {
    let last = path.segments.last().map(|last| text(&last.ident)).unwrap_or_default();
    matches!(last.as_str(), "Zero" | "One") && is_of_num_traits(path)
}

/// Traits whose functions take their receiver by value, which companions borrow: they are called as methods.
const FLOATS: [(&str, &str); 2] = [("Float", "AnyFloat"), ("FloatCore", "AnyCore")];

/// Rewrites a call by the path of a trait of floats as a method call in the witness copy: `Float::is_nan(x)` becomes
/// `x.is_nan()`.
pub fn by_method(it: &syn::ExprCall) -> Option<syn::Expr> {
    let syn::Expr::Path(function) = &*it.func else { return None };
    let (home, name) = of_trait(&function.path)?;
    FLOATS.iter().find(|(of, _)| *of == home)?;
    let (receiver, rest) = (it.args.first()?, it.args.iter().skip(1));
    Some(syn::parse_quote! { (#receiver).#name(#(#rest),*) })
}

/// Returns the path of the companions' trait in place of `num_traits`' own: `<T as One>::one`.
pub fn by_companions(function: &syn::ExprPath) -> Option<syn::ExprPath> {
    let ty = &function.qself.as_ref()?.ty;
    let (home, name) = of_trait(&function.path)?;
    let before = function.path.segments.iter().rev().nth(1)?;
    let arguments = &before.arguments;
    let float = FLOATS.iter().find(|(of, _)| *of == home);
    let (module, home) = match float {
        Some((_, family)) => (format_ident!("generic"), format_ident!("{family}Builtins")),
        None if OWN.contains(&home.as_str()) || home == "NumCast" => {
            (format_ident!("numeric"), format_ident!("Any{home}Builtins"))
        }
        None => return None,
    };
    Some(syn::parse_quote!(<#ty as ::bessemer::generate::#module::#home #arguments>::#name))
}

/// The trait of `num_traits` through which a function's path leads, and the function.
fn of_trait(path: &syn::Path) -> Option<(String, syn::Ident)> {
    let count = path.segments.len().checked_sub(1)?;
    let name = path.segments.last()?.ident.clone();
    let home: Vec<_> = path.segments.iter().take(count).collect();
    let last = text(&home.last()?.ident);
    // Few names are looked up: each look is a call into rustc.
    let is_known = last == "NumCast"
        || OWN.contains(&last.as_str())
        || FLOATS.iter().any(|(of, _)| *of == last);
    let home: syn::Path = is_known.then(|| syn::parse_quote!(#(#home)::*))?;
    is_of_num_traits(&home).then_some((last, name))
}

/// Returns the names of the DSL's traits for the methods of what has these bounds: first those of a float.
pub fn families<'a>(bounds: impl Iterator<Item = &'a TypeParamBound>) -> Vec<&'static str> {
    let bounds: Vec<&TypeParamBound> = bounds.collect();
    let any = |name: &str| bounds.iter().any(|it| is_bound(it, name));
    let floats = match () {
        () if bounds.iter().any(|it| is_real(it)) => "AnyReal",
        () if any("FloatCore") => "AnyCore",
        () => "AnyFloat",
    };
    let others = [("Signed", "AnySigned"), ("Euclid", "AnyEuclid")];
    let others = others.into_iter().filter(|(name, _)| any(name)).map(|(_, family)| family);
    std::iter::once(floats).chain(others).collect()
}

/// Returns the bounds that an interface has besides its author's: whatever implements it has methods and companions by
/// these.
pub fn implied_by<'a>(
    supertraits: impl IntoIterator<Item = &'a TypeParamBound>,
    generating: bool,
) -> Vec<TypeParamBound> {
    let bounds: Vec<&TypeParamBound> = supertraits.into_iter().collect();
    let families = families(bounds.iter().copied());
    // `Float` needs no bound of its own: its methods are all types' that have it.
    let families = families.into_iter().filter(|it| *it != "AnyFloat");
    let mut implied: Vec<TypeParamBound> = Vec::new();
    for family in families {
        let methods = format_ident!("{family}Methods");
        implied.push(syn::parse_quote!(::bessemer::math::#methods));
        if generating && ["AnyReal", "AnyCore"].contains(&family) {
            let companions = format_ident!("{family}Builtins");
            implied.push(syn::parse_quote!(::bessemer::generate::generic::#companions));
        }
    }
    if generating {
        if bounds.iter().any(|it| is_real(it)) {
            implied.push(syn::parse_quote!(::bessemer::math::Real));
        }
        let numeric = bounds.iter().flat_map(|bound| companions(bound));
        implied.extend(numeric.map(|path| -> TypeParamBound { syn::parse_quote!(#path) }));
    }
    implied
}

/// Returns true if a bound is nalgebra's `RealField`, or simba's for numbers in lanes, of which a model has the one-lane `f32` and `f64`.
pub fn is_real(bound: &TypeParamBound) -> bool {
    mentions(
        bound.to_token_stream(),
        &["RealField", "ComplexField", "SimdRealField", "SimdValue"].map(str::to_owned),
    )
}

/// Returns true if a bound is the trait of this name of `num_traits`.
fn is_bound(bound: &TypeParamBound, name: &str) -> bool {
    let TypeParamBound::Trait(bound) = bound else { return false };
    bound.path.segments.last().is_some_and(|last| last.ident == name)
        && is_of_num_traits(&bound.path)
}

/// Returns true if a path is a trait of `num_traits`.
pub fn is_of_num_traits(path: &syn::Path) -> bool {
    imports::home(path).is_some_and(|(home, _)| home == "num_traits")
}

/// Returns true if one of the names is among the tokens.
pub fn mentions(tokens: TokenStream, names: &[String]) -> bool {
    tokens.into_iter().any(|token| match token {
        proc_macro2::TokenTree::Ident(ident) => names.contains(&ident.to_string()),
        proc_macro2::TokenTree::Group(group) => mentions(group.stream(), names),
        _ => false,
    })
}
