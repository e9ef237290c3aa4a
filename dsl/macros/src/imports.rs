//! The `use` declarations of the author's file for crates whose functions and traits the DSL replaces, and for the DSL's
//! attributes. Examples: `use libm::{sqrtf, atan2f};`, `use num_traits::Zero;`, `use bessemer::entry;`.
//!
//! A macro sees its own item alone, and rustc resolves names later, so the file itself is read, once for each build. So is the file of
//! the module above, if a name comes from there: `use super::Float;`.
//! A name that a function binds is the function's own. Where there is no file, as in an editor, nothing is known, and a bare
//! name stays as it is.
//!
//! Must not know: what these crates' items mean.

use std::cell::RefCell;
use std::collections::HashMap;
use std::ops::RangeInclusive;
use std::path::{Path, PathBuf};
use std::rc::Rc;

use proc_macro2::{Span, TokenStream, TokenTree};
use quote::quote;
use syn::ext::IdentExt;
use syn::visit::{self, Visit};
use syn::visit_mut::{self, VisitMut};

use crate::owned;
use crate::words::{self, Word};

/// The crates whose names are looked up.
const CRATES: [&str; 3] = ["libm", "num_traits", "nalgebra"];

/// The DSL's own crate, whose attributes are looked up.
const OWN: &str = "bessemer";

/// Attributes of it that the macros remove from the items below them.
const REMOVED: [&str; 3] = ["entry", "c", "function"];

/// Beginnings of a path into a file above, which may import the name: `use super::Float;`, `use crate::*;`.
const ABOVE: [&str; 2] = ["super", "crate"];

/// Number of files that are followed for a name.
const FOLLOWED: u32 = 8;

/// An import: the lines in which it holds, the name there (`*` for all), and the whole path.
struct Import {
    lines: RangeInclusive<usize>,
    name: String,
    path: Vec<String>,
}

/// Imports and modules of a file.
#[derive(Default)]
struct File {
    imports: Vec<Import>,
    /// The lines of each module that is written out in it, with its name.
    modules: Vec<(String, RangeInclusive<usize>)>,
}

thread_local! {
    static FILES: RefCell<HashMap<PathBuf, Rc<File>>> = RefCell::default();
}

/// Writes out the bare names in a function's body that are imported from `libm` and the like: `sqrtf(x)` becomes
/// `libm::sqrtf(x)`.
pub fn write_out(signature: &syn::Signature, body: &mut syn::Block) {
    let mut bound = Bound::default();
    bound.visit_signature(signature);
    bound.visit_block(body);
    WriteOut { bound: bound.0 }.visit_block_mut(body);
}

/// Returns the bare name for which [`write_out`] wrote a path; none for an author's path.
pub fn bare(path: &syn::Path) -> Option<&syn::PathSegment> {
    let (first, last) = (path.segments.first()?, path.segments.last()?);
    let is_ours = path.segments.len() > 1 && CRATES.iter().any(|it| first.ident == it);
    (is_ours && first.ident.span().start() == last.ident.span().start()).then_some(last)
}

/// Returns the crate of [`CRATES`] that a path leads to, and the last name in it.
pub fn home(path: &syn::Path) -> Option<(String, String)> {
    let first = &path.segments.first()?.ident;
    let last = text(&path.segments.last()?.ident);
    if path.segments.len() > 1 {
        let first = text(first);
        return CRATES.contains(&first.as_str()).then_some((first, last));
    }
    let whole = whole(first)?;
    let known = CRATES.contains(&whole.first()?.as_str());
    known.then_some((whole.first()?.clone(), whole.last()?.clone()))
}

/// Returns uses of the imported attributes in an item that are removed from it, so that rustc knows the imports are used.
pub fn uses(item: &TokenStream) -> TokenStream {
    let mut removed = Vec::new();
    attributes(item.clone(), &mut removed);
    let imported = removed.iter().filter(|name| {
        whole(name).is_some_and(|it| it.len() == 2 && it[0] == OWN && it[1] == text(name))
    });
    let uses = imported.map(|name| quote! { #[allow(unused_imports)] use #name as _; });
    let uses: TokenStream = uses.collect();
    if uses.is_empty() {
        uses
    } else {
        quote! { const _: () = { #uses }; }
    }
}

/// Adds each attribute of [`REMOVED`] in an item, once.
fn attributes(item: TokenStream, found: &mut Vec<syn::Ident>) {
    let mut after_sign = false;
    for token in item {
        let is_sign = matches!(&token, TokenTree::Punct(sign) if sign.as_char() == '#');
        if let TokenTree::Group(group) = token {
            match group.stream().into_iter().next() {
                Some(TokenTree::Ident(name)) if after_sign => {
                    let is_removed = REMOVED.iter().any(|it| name == it);
                    if is_removed && !found.contains(&name) {
                        found.push(name);
                    }
                }
                _ => attributes(group.stream(), found),
            }
        }
        after_sign = is_sign;
    }
}

/// Returns true if a module that is named as an item surrounds it, in its file or as its file.
pub fn in_module_of_its_name(name: &syn::Ident) -> bool {
    let Some((path, file)) = file_of(name.span()) else { return false };
    let (text, line) = (text(name), name.span().start().line);
    let around = file.modules.iter().filter(|(_, lines)| lines.contains(&line));
    match around.min_by_key(|(_, lines)| lines.end() - lines.start()) {
        Some((module, _)) => *module == text,
        None => path.file_stem().is_some_and(|stem| *stem == *text),
    }
}

/// The whole path of an imported name.
fn whole(name: &syn::Ident) -> Option<Vec<String>> {
    let (path, file) = file_of(name.span())?;
    let (text, line) = (text(name), name.span().start().line);
    let module = |lines: &RangeInclusive<usize>| {
        let inner = |of: &RangeInclusive<usize>| {
            lines.contains(of.start()) && lines.contains(of.end()) && lines != of
        };
        file.modules.iter().any(|(_, of)| inner(of) && of.contains(&line))
    };
    let reaches = |it: &&Import| it.lines.contains(&line) && !module(&it.lines);
    let reaching: Vec<&Import> = file.imports.iter().filter(reaches).collect();
    let found = nearest(&reaching, &text)?;
    let is_within = file.modules.iter().any(|(_, lines)| *lines == found.lines);
    followed(found, is_within, &text, &path, FOLLOWED)
}

/// Returns the innermost import of a name, or else of all names of a file above.
fn nearest<'i>(imports: &[&'i Import], name: &str) -> Option<&'i Import> {
    let of = |wanted: &str| {
        let named = imports.iter().copied().filter(|it| it.name == wanted);
        named.min_by_key(|it| it.lines.end() - it.lines.start())
    };
    of(name).or_else(|| of("*").filter(|it| it.is_of_above()))
}

/// The whole path of an import of `name` in a file; one from a file above is looked up there, up to `left` times. `is_within` says
/// that the import is in a module that is written out in the file.
fn followed(
    import: &Import,
    is_within: bool,
    name: &str,
    path: &Path,
    left: u32,
) -> Option<Vec<String>> {
    if !import.is_of_above() {
        return Some(import.path.clone());
    }
    let (first, last) = (import.path.first()?, import.path.last()?);
    let name = if last == "*" { name } else { last };
    let above = if is_within && first == "super" { path.to_owned() } else { above(path, first)? };
    let file = file_at(&above)?;
    let outermost: Vec<&Import> =
        file.imports.iter().filter(|it| *it.lines.end() == usize::MAX).collect();
    let found = nearest(&outermost, name).filter(|_| left > 0)?;
    followed(found, false, name, &above, left - 1)
}

/// Returns the file of the module above that of `path`, or of the crate.
fn above(path: &Path, first: &str) -> Option<PathBuf> {
    let folder = path.parent()?;
    let in_folder = |folder: &Path, names: &[&str]| {
        names.iter().map(|name| folder.join(name)).find(|it| it.is_file())
    };
    if first == "crate" {
        return folder.ancestors().find_map(|it| in_folder(it, &["lib.rs", "main.rs"]));
    }
    let is_of_folder = path.file_name().is_some_and(|name| name == "mod.rs");
    let folder = if is_of_folder { folder.parent()? } else { folder };
    in_folder(folder, &["mod.rs", "lib.rs", "main.rs"])
        .or_else(|| Some(folder.with_extension("rs")).filter(|it| it.is_file()))
}

/// The file in which something is written, with what it imports.
fn file_of(span: Span) -> Option<(PathBuf, Rc<File>)> {
    let path = span.local_file()?;
    let file = file_at(&path)?;
    Some((path, file))
}

fn file_at(path: &Path) -> Option<Rc<File>> {
    let known = FILES.with_borrow(|files| files.get(path).cloned());
    known.or_else(|| {
        let text = std::fs::read_to_string(path).ok()?;
        let file = Rc::new(File::read(&words::of(&text)));
        FILES.with_borrow_mut(|files| files.insert(path.to_owned(), Rc::clone(&file)));
        Some(file)
    })
}

impl Import {
    /// Returns true if it names what a file above has.
    fn is_of_above(&self) -> bool {
        self.path.first().is_some_and(|first| ABOVE.contains(&first.as_str()))
    }
}

impl File {
    /// Reads a file: its `use` declarations and its modules.
    fn read(words: &[Word<'_>]) -> File {
        let mut file = File::default();
        // The blocks that are open: where each begins, the name of a module, and its first import.
        let mut blocks = vec![(1, None, 0)];
        let mut at = 0;
        while let Some(word) = words.get(at) {
            match word.text {
                "use" => {
                    let end = words[at..].iter().position(|it| it.text == ";");
                    let end = end.map_or(words.len(), |end| at + end);
                    file.import(&mut words[at + 1..end].iter(), &mut Vec::new());
                    at = end;
                }
                "{" => {
                    let module = at.checked_sub(2).filter(|at| words[*at].text == "mod");
                    let module = module.map(|at| words[at + 1].text.to_owned());
                    blocks.push((word.line, module, file.imports.len()));
                }
                "}" if blocks.len() > 1 => {
                    let (first, module, imports) = blocks.pop().unwrap_or_default();
                    let lines = first..=word.line;
                    // Those of inner blocks have their lines already.
                    for import in &mut file.imports[imports..] {
                        if *import.lines.end() == usize::MAX {
                            import.lines = lines.clone();
                        }
                    }
                    file.modules.extend(module.map(|name| (name, lines)));
                }
                _ => {}
            }
            at += 1;
        }
        file
    }

    /// Reads the words behind `use`, up to the end of its list: the names in one list share the path before it.
    fn import<'w>(
        &mut self,
        words: &mut impl Iterator<Item = &'w Word<'w>>,
        path: &mut Vec<String>,
    ) {
        let before = path.len();
        let mut renamed: Option<&str> = None;
        let mut named = false;
        let end = |file: &mut File, path: &mut Vec<String>, renamed: Option<&str>| {
            let name = renamed.or(path.last().map(String::as_str)).unwrap_or_default().to_owned();
            let is_known = match &path[..] {
                [first, _] if ABOVE.contains(&&first[..]) => true,
                [first, ..] => first == OWN || CRATES.contains(&&first[..]),
                [] => false,
            };
            if is_known {
                file.imports.push(Import { lines: 1..=usize::MAX, name, path: path.clone() });
            }
        };
        while let Some(word) = words.next() {
            match word.text {
                "{" => {
                    self.import(words, path);
                    named = false;
                }
                "}" | "," => {
                    if named {
                        end(self, path, renamed);
                    }
                    (renamed, named) = (None, false);
                    path.truncate(before);
                    if word.text == "}" {
                        return;
                    }
                }
                "as" => renamed = words.next().map(|it| it.text),
                ":" => {}
                text => {
                    path.push(text.to_owned());
                    named = true;
                }
            }
        }
        if named {
            end(self, path, renamed);
        }
        path.truncate(before);
    }
}

/// The names that a function binds: by patterns, or as functions in its body.
#[derive(Default)]
struct Bound(Vec<String>);

impl<'ast> Visit<'ast> for Bound {
    fn visit_pat_ident(&mut self, it: &'ast syn::PatIdent) {
        self.0.push(text(&it.ident));
        visit::visit_pat_ident(self, it);
    }

    fn visit_item_fn(&mut self, it: &'ast syn::ItemFn) {
        self.0.push(text(&it.sig.ident));
        visit::visit_item_fn(self, it);
    }
}

struct WriteOut {
    bound: Vec<String>,
}

impl VisitMut for WriteOut {
    /// It has an attribute of its own.
    fn visit_item_fn_mut(&mut self, _: &mut syn::ItemFn) {}

    fn visit_expr_path_mut(&mut self, it: &mut syn::ExprPath) {
        visit_mut::visit_expr_path_mut(self, it);
        let [only] = it.path.segments.iter().collect::<Vec<_>>()[..] else { return };
        if it.qself.is_some() || self.bound.contains(&text(&only.ident)) {
            return;
        }
        // Few names are looked up: each look is a call into rustc.
        let is_theirs = owned::is_of_libm(&only.ident) || owned::is_of_num_traits(&only.ident);
        let Some(whole) = is_theirs.then(|| whole(&only.ident)).flatten() else { return };
        let span = only.ident.span();
        let arguments = only.arguments.clone();
        let names = whole.iter().map(|name| syn::Ident::new(name, span));
        it.path = syn::parse_quote!(#(#names)::*);
        if let Some(last) = it.path.segments.last_mut() {
            last.arguments = arguments;
        }
    }
}

/// Returns a name without the `r#` of a raw one.
pub fn text(ident: &syn::Ident) -> String {
    ident.unraw().to_string()
}
