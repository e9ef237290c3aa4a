//! Attributes that rustc applies by a condition, and those that change nothing in the C.

/// Returns the attributes that a `cfg_attr` adds; none if the C depends on one of them.
pub fn conditional(attribute: &syn::Attribute) -> Option<Vec<syn::Meta>> {
    use syn::punctuated::Punctuated;
    let parser = Punctuated::<syn::Meta, syn::Token![,]>::parse_terminated;
    let added: Vec<_> = attribute.parse_args_with(parser).ok()?.into_iter().skip(1).collect();
    let is_free = |meta: &syn::Meta| {
        let name = meta.path().segments.first().map(|first| first.ident.to_string());
        match name.unwrap_or_default().as_str() {
            "derive" => match meta.require_list().and_then(|list| {
                list.parse_args_with(Punctuated::<syn::Path, syn::Token![,]>::parse_terminated)
            }) {
                Ok(derived) => !derived.iter().any(|it| {
                    it.segments.last().is_some_and(|it| DERIVED.iter().any(|of| it.ident == of))
                }),
                Err(_) => false,
            },
            name => !MEANT.contains(&name),
        }
    };
    added.iter().all(is_free).then_some(added)
}

/// Derived traits that the C depends on.
const DERIVED: [&str; 7] = ["Clone", "Copy", "Default", "Eq", "Ord", "PartialEq", "PartialOrd"];

/// Attributes that the C depends on.
const MEANT: [&str; 18] = [
    "axes",
    "bound",
    "c",
    "cfg",
    "cfg_attr",
    "component",
    "data",
    "default",
    "entry",
    "external",
    "function",
    "inline",
    "interface",
    "keep",
    "range",
    "repr",
    "unit",
    "unroll",
];

/// Attributes without influence on the behaviour.
const HARMLESS: &[&str] = &["allow", "warn", "deny", "forbid", "expect", "doc"];

/// Returns true if an attribute changes nothing about the code.
pub fn is_harmless(path: &syn::Path) -> bool {
    let name = path.segments.first().map(|first| first.ident.to_string()).unwrap_or_default();
    let tools = ["rustfmt", "rustfmt_skip", "clippy"];
    tools.contains(&name.as_str()) || HARMLESS.contains(&name.as_str())
}
