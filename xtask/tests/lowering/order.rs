//! Lines that decide the order of evaluation: where something is computed now, kept, or put behind something else.

use std::collections::BTreeSet;

use proc_macro2::{Span, TokenStream, TokenTree};
use syn::visit::{self, Visit};

use super::Files;

/// The one module that may, with its parts.
const OWN: &str = "order";
/// The functions that decide, by their names.
const NAMES: [&str; 14] = [
    "fix",
    "later",
    "apart",
    "own_copy",
    "is_free",
    "is_settled",
    "may_follow",
    "is_pure",
    "is_lasting",
    "is_steady",
    "is_among",
    "is_repeatable",
    "read_later",
    "copy_written",
];
/// The functions that decide, by how their names begin.
const BEGINNINGS: [&str; 3] = ["settl", "keep", "temporary"];

/// Returns, for each file but the own one, the lines that call such a function. Imports and definitions
/// do not count, but the functions' bodies do.
pub fn lines(files: &Files) -> Vec<(String, Vec<usize>)> {
    let mut found = Vec::new();
    for (module, file) in
        files.iter().filter(|(module, _)| module.first().is_none_or(|it| it != OWN))
    {
        let mut lines = Lines::default();
        lines.visit_file(file);
        if !lines.0.is_empty() {
            let name = if module.is_empty() { "mod".to_owned() } else { module.join("::") };
            found.push((name, lines.0.into_iter().collect()));
        }
    }
    found
}

fn decides(name: &syn::Ident) -> bool {
    let name = name.to_string();
    NAMES.contains(&name.as_str()) || BEGINNINGS.iter().any(|it| name.starts_with(it))
}

#[derive(Default)]
struct Lines(BTreeSet<usize>);

impl Lines {
    fn note(&mut self, span: Span) {
        self.0.insert(span.start().line);
    }

    /// Notes what syn leaves as tokens: a name before parentheses.
    fn tokens(&mut self, tokens: TokenStream) {
        let tokens: Vec<TokenTree> = tokens.into_iter().collect();
        for (at, token) in tokens.iter().enumerate() {
            let called = matches!(tokens.get(at + 1), Some(TokenTree::Group(_)));
            match token {
                TokenTree::Group(group) => self.tokens(group.stream()),
                TokenTree::Ident(name) if called && decides(name) => self.note(name.span()),
                _ => {}
            }
        }
    }
}

impl<'ast> Visit<'ast> for Lines {
    fn visit_expr_method_call(&mut self, it: &'ast syn::ExprMethodCall) {
        if decides(&it.method) {
            self.note(it.method.span());
        }
        visit::visit_expr_method_call(self, it);
    }

    fn visit_expr_path(&mut self, it: &'ast syn::ExprPath) {
        let last = it.path.segments.last();
        let qualified = it.path.segments.len() > 1;
        // A variable may have such a name.
        let function = |name: &syn::Ident| qualified || name.to_string().contains('_');
        if let Some(name) = last.map(|it| &it.ident).filter(|it| decides(it) && function(it)) {
            self.note(name.span());
        }
    }

    fn visit_macro(&mut self, it: &'ast syn::Macro) {
        self.tokens(it.tokens.clone());
    }
}
