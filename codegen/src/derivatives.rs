//! Writes the bodies of derivatives, `#[function(derivative(advance, state))]`, into the author's source.
//!
//! The body is ordinary Rust of the author's module, so that rustc compiles it for the simulation, and the generator for
//! the C. It is compared by its tokens: the author may format it and add comments.
//!
//! Invariants: nothing but the text between the braces of such a function changes; the body does not depend on the layout
//! of matrices in the C.

use std::collections::{BTreeMap, BTreeSet};
use std::str::FromStr;

use bessemer_derivative::{Kind, Problem, Request};
use bessemer_frontend::diagnostic::Diagnostic;
use bessemer_frontend::source::Sources;
use bessemer_frontend::typify;
use bessemer_ir::tree::{self, Derivative, Package, Site};
use bessemer_ir::visit::{self, Visit};
use bessemer_ir::{Expr, ExprKind, FunctionId, Module};
use proc_macro2::{Delimiter, LineColumn, TokenStream, TokenTree};

use crate::deep::deep;

/// A source file with other bodies of derivatives.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Edit {
    /// The file, relative to the workspace.
    pub file: String,
    /// Its text.
    pub before: String,
    /// Its text with the bodies as the functions require them.
    pub after: String,
}

/// Returns the source files with stale bodies of derivatives.
///
/// # Errors
///
/// Functions without a derivative, at the author's lines.
pub fn edits(package: &Package, sources: &Sources) -> Result<Vec<Edit>, Vec<Diagnostic>> {
    let declared =
        package.functions.iter().filter_map(|it| Some((it, it.tree.derivative.as_ref()?)));
    let declared: Vec<(&tree::Function, &Derivative)> = declared.collect();
    if declared.is_empty() {
        return Ok(Vec::new());
    }
    deep(|| {
        let (mut module, _) = typify::typify(package, sources, true)?;
        let mut errors = Vec::new();
        let mut requests = Vec::new();
        for (function, derivative) in declared {
            match request(&module, function, derivative) {
                Ok(request) => requests.push((function, derivative, request)),
                Err(more) => errors.extend(more),
            }
        }
        let mut bodies: BTreeMap<&str, Vec<(Site, String)>> = BTreeMap::new();
        while !requests.is_empty() {
            let (function, derivative, request) = requests.remove(next(&module, &requests));
            match derived(module.clone(), (function, derivative), &request) {
                Ok((with, body)) => {
                    module = with;
                    bodies.entry(&function.file).or_default().push((function.tree.site, body));
                }
                Err(more) => errors.extend(more),
            }
        }
        if !errors.is_empty() {
            return Err(errors);
        }
        let edit = |(file, bodies): (&str, Vec<(Site, String)>)| {
            let before = sources.text(file);
            let after = replaced(&before, &bodies);
            (before != after).then(|| Edit { file: file.to_owned(), before, after })
        };
        Ok(bodies.into_iter().filter_map(edit).collect())
    })
}

fn in_file(file: &str, site: Site, message: String, help: &str) -> Vec<Diagnostic> {
    vec![Diagnostic {
        file: file.to_owned(),
        line: site.0,
        column: site.1,
        message,
        help: help.to_owned(),
        ..Diagnostic::default()
    }]
}

/// Returns the index of a request whose function calls no function with a body that is still to be written. If each does, the
/// first.
fn next(module: &Module, requests: &[(&tree::Function, &Derivative, Request)]) -> usize {
    let is_ready = |(_, _, request): &(&tree::Function, &Derivative, Request)| {
        let mut called = Called { module, found: BTreeSet::new() };
        called.function(request.of);
        requests.iter().all(|(_, _, other)| !called.found.contains(&other.into.0))
    };
    requests.iter().position(is_ready).unwrap_or_default()
}

/// Functions that a function calls, and itself.
struct Called<'m> {
    module: &'m Module,
    found: BTreeSet<u32>,
}

impl Called<'_> {
    fn function(&mut self, id: FunctionId) {
        if self.found.insert(id.0) {
            let module = self.module;
            self.block(&module.functions[id.index()].body);
        }
    }
}

impl Visit for Called<'_> {
    fn expr(&mut self, expr: &Expr) {
        if let ExprKind::Call(callee, _) = expr.kind {
            self.function(callee);
        }
        visit::walk_expr(self, expr);
    }
}

/// Returns the module with a derivative in place of its declaration, and its body.
fn derived(
    module: Module,
    (function, derivative): (&tree::Function, &Derivative),
    request: &Request,
) -> Result<(Module, String), Vec<Diagnostic>> {
    let found = bessemer_derivative::derivative(&module, request);
    let (mut with, derived) = found.map_err(|problem| {
        let Problem { span, message, help } = problem;
        let file = module.files.get(span.file as usize).cloned();
        match file.filter(|file| span.line > 0 && !file.starts_with('/')) {
            Some(file) => in_file(&file, Site(span.line, span.column), message, &help),
            None => in_file(&function.file, derivative.site, message, &help),
        }
    })?;
    let body = bessemer_derivative::body(&with, &derived);
    with.functions[request.into.index()] = derived;
    Ok((with, body))
}

/// Returns the request of a declared derivative.
fn request(
    module: &Module,
    function: &tree::Function,
    derivative: &Derivative,
) -> Result<Request, Vec<Diagnostic>> {
    let at = |site, message, help: &str| in_file(&function.file, site, message, help);
    let path = derivative.of.join("::");
    let into = named(module, &function.module, &function.tree.name);
    let [into] = into.as_slice() else {
        let message =
            format!("`{}` is generic, and the derivative has no types", function.tree.name);
        return Err(at(
            function.tree.site,
            message,
            "declare it with the types that it is called with",
        ));
    };
    let found = differentiated(module, &function.module, &derivative.of);
    let of = match found.as_slice() {
        [of] => *of,
        [] => {
            let message = format!("`{path}` is no function of this package that becomes C");
            return Err(at(
                derivative.site,
                message,
                "mark it `#[function]`; of a generic function declare an instance: a function that calls it",
            ));
        }
        _ => {
            let message = format!("`{path}` may be several functions");
            return Err(at(
                derivative.site,
                message,
                "write its path with the module, such as `plant::advance`",
            ));
        }
    };
    let parameters = module.functions[of.index()].parameters();
    let mut by = Vec::new();
    for name in &derivative.by {
        let Some(index) = parameters.iter().position(|it| it.name == *name) else {
            let message = format!("`{path}` has no parameter `{name}`");
            return Err(at(derivative.site, message, "name parameters of the function"));
        };
        by.push(index);
    }
    let kind = if derivative.is_gradient { Kind::Gradients } else { Kind::Jacobians };
    Ok(Request { of, by, kind, into: *into })
}

/// Returns the free functions of a name in a module.
fn named(module: &Module, path: &str, name: &str) -> Vec<FunctionId> {
    let is =
        |it: &bessemer_ir::Function| it.owner.is_none() && it.module == path && it.name == name;
    let all = module.functions.iter().enumerate().filter(|(_, it)| is(it));
    all.map(|(index, _)| FunctionId(index as u32)).collect()
}

/// Returns the functions that a path may mean in a module.
fn differentiated(module: &Module, from: &str, path: &[String]) -> Vec<FunctionId> {
    let Some((name, modules)) = path.split_last() else { return Vec::new() };
    let modules: Vec<&str> = modules
        .iter()
        .map(String::as_str)
        .filter(|it| !["crate", "super", "self"].contains(it))
        .collect();
    if modules.is_empty() {
        let own = named(module, from, name);
        if !own.is_empty() {
            return own;
        }
    }
    let ends = |of: &str| {
        let segments: Vec<&str> = of.split("::").collect();
        segments.ends_with(&modules)
    };
    let is =
        |it: &bessemer_ir::Function| it.owner.is_none() && it.name == *name && ends(&it.module);
    let all = module.functions.iter().enumerate().filter(|(_, it)| is(it));
    all.map(|(index, _)| FunctionId(index as u32)).collect()
}

/// Returns a text with the bodies of the functions whose names are at these sites. A body with the same tokens stays.
fn replaced(text: &str, bodies: &[(Site, String)]) -> String {
    let Ok(tokens) = TokenStream::from_str(text) else { return text.to_owned() };
    let mut ranges: Vec<(usize, usize, &str)> = Vec::new();
    for (site, body) in bodies {
        let Some((open, close)) = braces(tokens.clone(), *site) else { continue };
        let (open, close) = (offset(text, open) + 1, offset(text, close));
        if !equal(&text[open..close], body) {
            ranges.push((open, close, body));
        }
    }
    ranges.sort_unstable();
    let mut new = text.to_owned();
    for (open, close, body) in ranges.into_iter().rev() {
        new.replace_range(open..close, &format!("\n{body}"));
    }
    new
}

/// Returns the braces of the body of the function whose name is at a site.
fn braces(tokens: TokenStream, site: Site) -> Option<(LineColumn, LineColumn)> {
    let mut found = false;
    for token in tokens {
        match token {
            TokenTree::Ident(name) if !found => {
                let at = name.span().start();
                // Columns of a site count from 1.
                found = (at.line, at.column + 1) == (site.0 as usize, site.1 as usize);
            }
            TokenTree::Group(group) if group.delimiter() == Delimiter::Brace => {
                if found {
                    return Some((group.span_open().start(), group.span_close().start()));
                }
                if let Some(inner) = braces(group.stream(), site) {
                    return Some(inner);
                }
            }
            _ => {}
        }
    }
    None
}

/// Returns the number of bytes before a position.
fn offset(text: &str, at: LineColumn) -> usize {
    let lines = text.split_inclusive('\n').take(at.line - 1);
    let before: usize = lines.map(str::len).sum();
    let line = &text[before..];
    before + line.char_indices().nth(at.column).map_or(line.len(), |it| it.0)
}

/// Returns true if two texts have the same tokens, except commas before a closing bracket.
fn equal(one: &str, other: &str) -> bool {
    let tokens = |text: &str| {
        let mut all = Vec::new();
        TokenStream::from_str(text).ok().map(|tokens| {
            flat(tokens, &mut all);
            all
        })
    };
    tokens(one).is_some_and(|one| Some(one) == tokens(other))
}

/// Adds the tokens and the brackets to a list.
fn flat(tokens: TokenStream, all: &mut Vec<String>) {
    for token in tokens {
        match token {
            TokenTree::Group(group) => {
                let [open, close] = match group.delimiter() {
                    Delimiter::Parenthesis => ["(", ")"],
                    Delimiter::Brace => ["{", "}"],
                    Delimiter::Bracket => ["[", "]"],
                    Delimiter::None => ["", ""],
                };
                all.push(open.to_owned());
                flat(group.stream(), all);
                if all.last().is_some_and(|it| it == ",") {
                    all.pop();
                }
                all.push(close.to_owned());
            }
            other => all.push(other.to_string()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Another format or a comment is no difference; another token is one, and only the body changes.
    #[test]
    fn a_body_is_compared_by_its_tokens() {
        let text = "mod a {\n    #[function(derivative(f, x))]\n    /// é {\n    fn g(x: f64) -> (f64, f64) {\n        // By x.\n        (\n            x,\n            1.0,\n        )\n    }\n}\n";
        let at = |body: &str| replaced(text, &[(Site(4, 8), body.to_owned())]);
        assert_eq!(at("(x, 1.0)\n"), text);
        let other = at("    (x, 2.0)\n");
        assert!(other.contains("fn g(x: f64) -> (f64, f64) {\n    (x, 2.0)\n}\n}\n"), "{other}");
    }
}
