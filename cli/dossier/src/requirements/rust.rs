//! Items of Rust sources: functions, tests, types and constants, with the requirements that they name.
//!
//! The source text is read, not what a macro made of it, so that tests and items outside of the models count, too.

use std::collections::BTreeSet;

use proc_macro2::{TokenStream, TokenTree};
use quote::ToTokens;
use syn::spanned::Spanned;
use syn::visit::{self, Visit};

/// An item.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Item {
    /// Its path in the file: `Height::step`, `tests::holds`.
    pub name: String,
    /// File, from the workspace.
    pub file: String,
    /// First line of the item, with its attributes.
    pub line: u32,
    /// Last line of the item.
    pub last_line: u32,
    /// True for a `#[test]`.
    pub is_test: bool,
    /// True for a function or a method.
    pub is_function: bool,
    /// Requirements that it names.
    pub requirements: Vec<String>,
    /// Names in a function.
    pub words: BTreeSet<String>,
}

/// A mistake in an attribute or a source.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Wrong {
    /// File, from the workspace.
    pub file: String,
    /// The line.
    pub line: u32,
    /// The mistake.
    pub why: String,
}

/// Returns the items of a source.
///
/// # Errors
/// A source that is no Rust, or an attribute whose arguments are no identifiers.
pub fn items(file: &str, text: &str) -> Result<Vec<Item>, Vec<Wrong>> {
    let parsed = syn::parse_file(text).map_err(|error| {
        let line = error.span().start().line as u32;
        vec![Wrong { file: file.to_owned(), line, why: error.to_string() }]
    })?;
    let mut reader = Reader {
        file,
        path: Vec::new(),
        above: vec![Vec::new()],
        found: Vec::new(),
        wrong: Vec::new(),
    };
    reader.visit_file(&parsed);
    match reader.wrong.is_empty() {
        true => Ok(reader.found),
        false => Err(reader.wrong),
    }
}

struct Reader<'a> {
    file: &'a str,
    path: Vec<String>,
    /// Requirements of the modules and `impl` blocks around.
    above: Vec<Vec<String>>,
    found: Vec<Item>,
    wrong: Vec<Wrong>,
}

impl Reader<'_> {
    /// Returns the requirements that attributes name.
    fn named(&mut self, attributes: &[syn::Attribute]) -> Vec<String> {
        let mut named = Vec::new();
        let is_own = |it: &&syn::Attribute| {
            it.path().segments.last().is_some_and(|last| last.ident == "requirement")
        };
        for attribute in attributes.iter().filter(is_own) {
            let parser =
                syn::punctuated::Punctuated::<syn::LitStr, syn::Token![,]>::parse_terminated;
            let line = attribute.span().start().line as u32;
            let mut refuse = |why: &str| {
                let (file, why) = (self.file.to_owned(), why.to_owned());
                self.wrong.push(Wrong { file, line, why });
            };
            match attribute.parse_args_with(parser) {
                Ok(texts) if !texts.is_empty() => {
                    for text in texts {
                        let id = text.value();
                        match id.trim().is_empty() || id.contains(['\n', ',', ';']) {
                            true => refuse("an identifier of a requirement is one word"),
                            false => named.push(id.trim().to_owned()),
                        }
                    }
                }
                _ => {
                    refuse("a requirement is named by its identifier: `#[requirement(\"HLR-12\")]`")
                }
            }
        }
        named
    }

    fn add(
        &mut self,
        name: &str,
        span: proc_macro2::Span,
        attributes: &[syn::Attribute],
        function: Option<&dyn ToTokens>,
    ) {
        let mut requirements = self.named(attributes);
        requirements.extend(self.above.iter().flatten().cloned());
        requirements.sort();
        requirements.dedup();
        let is_test = attributes
            .iter()
            .any(|it| it.path().segments.last().is_some_and(|last| last.ident == "test"));
        let mut parts = self.path.clone();
        parts.push(name.to_owned());
        self.found.push(Item {
            name: parts.join("::"),
            file: self.file.to_owned(),
            line: span.start().line as u32,
            last_line: span.end().line as u32,
            is_test,
            is_function: function.is_some(),
            requirements,
            words: function.map(|it| words(it.to_token_stream())).unwrap_or_default(),
        });
    }

    fn inside(&mut self, name: &str, attributes: &[syn::Attribute], walk: impl FnOnce(&mut Self)) {
        let named = self.named(attributes);
        self.path.push(name.to_owned());
        self.above.push(named);
        walk(self);
        self.above.pop();
        self.path.pop();
    }
}

/// Returns the names in some tokens; those in the arguments of macros, too.
fn words(tokens: TokenStream) -> BTreeSet<String> {
    let of = |token| match token {
        TokenTree::Ident(name) => BTreeSet::from([name.to_string()]),
        TokenTree::Group(group) => words(group.stream()),
        _ => BTreeSet::new(),
    };
    tokens.into_iter().flat_map(of).collect()
}

impl<'ast> Visit<'ast> for Reader<'_> {
    fn visit_item_mod(&mut self, item: &'ast syn::ItemMod) {
        let name = item.ident.to_string();
        self.inside(&name, &item.attrs, |reader| visit::visit_item_mod(reader, item));
    }

    fn visit_item_impl(&mut self, item: &'ast syn::ItemImpl) {
        let name = match &*item.self_ty {
            syn::Type::Path(path) => path.path.segments.last().map(|it| it.ident.to_string()),
            _ => None,
        };
        let name = name.unwrap_or_else(|| "_".to_owned());
        self.inside(&name, &item.attrs, |reader| visit::visit_item_impl(reader, item));
    }

    fn visit_item_fn(&mut self, item: &'ast syn::ItemFn) {
        self.add(&item.sig.ident.to_string(), item.span(), &item.attrs, Some(item));
        visit::visit_item_fn(self, item);
    }

    fn visit_impl_item_fn(&mut self, item: &'ast syn::ImplItemFn) {
        self.add(&item.sig.ident.to_string(), item.span(), &item.attrs, Some(item));
        visit::visit_impl_item_fn(self, item);
    }

    fn visit_item_struct(&mut self, item: &'ast syn::ItemStruct) {
        self.add(&item.ident.to_string(), item.span(), &item.attrs, None);
    }

    fn visit_item_enum(&mut self, item: &'ast syn::ItemEnum) {
        self.add(&item.ident.to_string(), item.span(), &item.attrs, None);
    }

    fn visit_item_const(&mut self, item: &'ast syn::ItemConst) {
        self.add(&item.ident.to_string(), item.span(), &item.attrs, None);
    }

    fn visit_item_static(&mut self, item: &'ast syn::ItemStatic) {
        self.add(&item.ident.to_string(), item.span(), &item.attrs, None);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = "\
#[requirement(\"HLR-1\")]
#[component]
pub struct Motor { speed: f64 }
#[requirement(\"HLR-2\")]
#[component]
impl Motor {
    #[entry]
    #[bessemer::requirement(\"HLR-3\", \"HLR-4\")]
    pub fn step(&mut self) {}
}
mod tests {
    #[test]
    #[requirement(\"HLR-3\")]
    fn holds() {}
}
const A: f64 = 1.0;
";

    #[test]
    fn items_have_their_requirements_and_those_around() {
        let found = items("src/lib.rs", TEXT).expect("it is Rust");
        let found: Vec<_> = found
            .iter()
            .map(|it| (&*it.name, it.line, it.last_line, it.is_test, it.requirements.join(" ")))
            .collect();
        assert_eq!(
            found,
            [
                ("Motor", 1, 3, false, "HLR-1".to_owned()),
                ("Motor::step", 7, 9, false, "HLR-2 HLR-3 HLR-4".to_owned()),
                ("tests::holds", 12, 14, true, "HLR-3".to_owned()),
                ("A", 16, 16, false, String::new()),
            ]
        );
    }

    #[test]
    fn other_arguments_than_identifiers_are_refused() {
        for attribute in [
            "requirement",
            "requirement()",
            "requirement(7)",
            "requirement(\" \")",
            "requirement(\"a, b\")",
        ] {
            let text = format!("\n#[{attribute}]\nfn f() {{}}\n");
            let wrong = items("a.rs", &text).expect_err("it is wrong");
            assert_eq!((wrong.len(), wrong[0].line), (1, 2), "{attribute}");
        }
        assert!(items("a.rs", "fn f( {").is_err());
    }
}
