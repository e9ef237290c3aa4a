//! Author's expression of a constant, for a comment in the C, since rustc provides only the value.
//!
//! A literal has no expression, and neither has a long one. Must not know: the meaning of names in it.

use proc_macro2::{Delimiter, Spacing, TokenStream, TokenTree};
use quote::ToTokens;
use syn::Expr;

/// Longest expression that a comment quotes, in characters.
const LONGEST: usize = 72;

/// Returns the author's text of an expression that computes something.
pub fn told(value: &Expr) -> Option<String> {
    let text = shown(value.to_token_stream());
    let fits = text.chars().count() <= LONGEST && !text.contains("/*") && !text.contains("*/");
    let generic = text.replace("<<", "").contains('<');
    (computes(value) && fits && !generic).then_some(text)
}

/// Returns true if a value is more than literals and constructors of them.
fn computes(value: &Expr) -> bool {
    match value {
        Expr::Binary(_) | Expr::MethodCall(_) => true,
        Expr::Unary(it) => computes(&it.expr),
        Expr::Paren(it) => computes(&it.expr),
        Expr::Group(it) => computes(&it.expr),
        Expr::Reference(it) => computes(&it.expr),
        Expr::Cast(it) => computes(&it.expr),
        Expr::Repeat(it) => computes(&it.expr),
        Expr::Array(it) => it.elems.iter().any(computes),
        Expr::Tuple(it) => it.elems.iter().any(computes),
        Expr::Struct(it) => it.fields.iter().any(|field| computes(&field.expr)),
        Expr::Call(it) => !constructs(&it.func) || it.args.iter().any(computes),
        // A constant that is not of a number's own type, as `i16::MAX` is.
        Expr::Path(it) => {
            let names: Vec<String> =
                it.path.segments.iter().map(|it| it.ident.to_string()).collect();
            let is_constant = |name: &String| !name.chars().any(char::is_lowercase);
            let of_numbers = names[0].starts_with(['i', 'u', 'f']) && names.len() == 2;
            names.last().is_some_and(is_constant) && !of_numbers
        }
        _ => false,
    }
}

/// Returns true if a function only constructs a value from its arguments: `Vector3::new`, `Some`.
fn constructs(function: &Expr) -> bool {
    let Expr::Path(path) = function else { return false };
    let name = path.path.segments.last().map(|it| it.ident.to_string()).unwrap_or_default();
    name == "new" || name.starts_with(char::is_uppercase)
}

/// Returns tokens as an author writes them; not generic arguments, which look like comparisons.
fn shown(tokens: TokenStream) -> String {
    let mut text = String::new();
    // Whether an operand is complete, so that an operator behind it has two; and whether one goes on.
    let (mut operand, mut goes_on) = (false, false);
    for token in tokens {
        match token {
            TokenTree::Group(it) => {
                let (open, close) = match it.delimiter() {
                    Delimiter::Parenthesis => ("(", ")"),
                    Delimiter::Bracket => ("[", "]"),
                    Delimiter::Brace => (" { ", " }"),
                    Delimiter::None => ("", ""),
                };
                text += &format!("{open}{}{close}", shown(it.stream()));
                (operand, goes_on) = (true, false);
            }
            TokenTree::Punct(it) => {
                let mark = it.as_char();
                match mark {
                    '.' | '!' | '?' | '&' if !operand || mark != '&' => text.push(mark),
                    ',' | ';' => text += &format!("{mark} "),
                    ':' if it.spacing() == Spacing::Joint || text.ends_with(':') => text.push(mark),
                    ':' => text += ": ",
                    _ if goes_on => {
                        text.truncate(text.trim_end().len());
                        text += &format!("{mark} ");
                    }
                    _ if operand => text += &format!(" {mark} "),
                    _ => text.push(mark),
                }
                goes_on = it.spacing() == Spacing::Joint && !matches!(mark, ':' | '.');
                operand = false;
            }
            other => {
                if operand {
                    text.push(' ');
                }
                text += &other.to_string();
                (operand, goes_on) = (true, false);
                if text.ends_with(" as") {
                    text.push(' ');
                    operand = false;
                }
            }
        }
    }
    text.trim_end().to_owned()
}
