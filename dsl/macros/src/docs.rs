//! The author's doc comments, a line each, as they travel to the C, with the units of fields.

/// The text of the `///` lines among `attributes`, without the leading space.
pub fn lines(attributes: &[syn::Attribute]) -> Vec<String> {
    let mut lines = Vec::new();
    for attribute in attributes {
        let syn::Meta::NameValue(meta) = &attribute.meta else { continue };
        if !meta.path.is_ident("doc") {
            continue;
        }
        if let syn::Expr::Lit(syn::ExprLit { lit: syn::Lit::Str(text), .. }) = &meta.value {
            let text = text.value();
            lines.extend(
                text.lines()
                    .map(|line| line.strip_prefix(' ').unwrap_or(line).trim_end().to_owned()),
            );
            if text.is_empty() {
                lines.push(String::new());
            }
        }
    }
    lines
}

/// The doc comment of a field, with its unit: `#[unit("m/s")]`.
pub fn field(field: &syn::Field) -> Vec<String> {
    let mut lines = lines(&field.attrs);
    if let Some(unit) = field.attrs.iter().find_map(unit) {
        let unit = format!("Unit: {}.", unit.value());
        match lines.last_mut().filter(|last| !last.is_empty()) {
            Some(last) => *last = format!("{last} {unit}"),
            None => lines.push(unit),
        }
    }
    lines
}

/// The unit that an attribute gives.
pub fn unit(attribute: &syn::Attribute) -> Option<syn::LitStr> {
    attribute.path().is_ident("unit").then(|| attribute.parse_args().ok()).flatten()
}
