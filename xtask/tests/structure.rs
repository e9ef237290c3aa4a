//! The compiler's structure in figures, each of which may only fall. They count files in circular imports, names of
//! methods in the front half, and what independent parts share.
//!
//! A bound is met exactly: who improves a figure lowers its bound, so that nothing grows back into the gap.

#[path = "shared/modules.rs"]
mod modules;

use std::collections::{BTreeMap, BTreeSet};
use std::path::PathBuf;

use proc_macro2::{TokenStream, TokenTree};
use syn::visit::{self, Visit};

use modules::{Module, circles, files, is_test, joined, read, root, shown};

/// Numbers of files in circular imports: the root of a crate's modules, the folder within it (everything if empty), and
/// the number.
const IN_CIRCLES: [(&str, &str, usize); 5] = [
    ("dsl/macros/src", "", 0),
    ("dsl/src", "generate", 0),
    ("codegen/frontend/src", "", 0),
    ("codegen/backend/src", "", 0),
    ("codegen/src", "", 0),
];

/// The package of the proofs.
const BACKEND: &str = "codegen/backend/src";

/// Words in quotation marks that a method could be called, and by which something could be decided, by folder.
const METHOD_NAMES: [(&str, usize); 2] =
    [("dsl/macros/src/lower", 70), ("codegen/frontend/src/typify", 43)];

#[test]
fn circles_of_imports_only_go() {
    let mut figures = Vec::new();
    for (crate_root, folder, bound) in IN_CIRCLES {
        let imports = imports(crate_root, folder);
        let circles = circles(&imports);
        let shown: Vec<String> = circles.iter().map(shown).collect();
        let count = circles.iter().map(BTreeSet::len).sum();
        figures.push((format!("{crate_root}/{folder}: {}", shown.join("; ")), count, bound));
    }
    hold("files that import each other in circles", &figures);
}

#[test]
fn names_of_methods_only_go() {
    let mut figures = Vec::new();
    for (folder, bound) in METHOD_NAMES {
        let files = files(&root().join(folder));
        let table = vec![TABLE.to_owned()];
        let words = files.get(&table).map(|path| constants(&read(path))).unwrap_or_default();
        let mut names = Vec::new();
        for path in files.iter().filter(|(module, _)| **module != table).map(|(_, path)| path) {
            names.extend(deciding(&read(path), &words));
        }
        figures.push((folder.to_owned(), names.len(), bound));
    }
    hold("names of methods", &figures);
}

/// Modules of the compiler that the second proof may name: the sites of operations. Anything else would be shared with
/// the analysis that it verifies.
const KNOWN_TO_THE_PROOF: [&str; 1] = ["passes::sites"];

/// Nor may it name what stages ask of the IR.
const UNKNOWN_TO_THE_PROOF: [&str; 2] = ["effects", "alias"];

#[test]
fn the_second_proof_shares_nothing_with_the_first() {
    let own = ["passes", "proof"].map(str::to_owned);
    let mut found = BTreeSet::new();
    for (module, imported) in imports(BACKEND, "") {
        if module.starts_with(&own) {
            found.extend(imported.into_iter().filter(|it| !it.starts_with(&own)));
        }
    }
    for (module, path) in files(&root().join(BACKEND)).iter().filter(|it| it.0.starts_with(&own)) {
        let mut named = Named::default();
        named.visit_file(&syn::parse_file(&read(path)).expect("Rust"));
        let shared = UNKNOWN_TO_THE_PROOF.into_iter().filter(|it| named.0.contains(*it));
        assert_eq!(shared.collect::<Vec<_>>(), [""; 0], "{module:?}");
    }
    let found: Vec<String> = found.iter().map(|module| module.join("::")).collect();
    assert_eq!(found, KNOWN_TO_THE_PROOF, "what the second proof imports");
}

/// Every name in a file.
#[derive(Default)]
struct Named(BTreeSet<String>);

impl Visit<'_> for Named {
    fn visit_ident(&mut self, name: &syn::Ident) {
        self.0.insert(name.to_string());
    }
}

/// Each figure is its bound.
#[track_caller]
fn hold(what: &str, figures: &[(String, usize, usize)]) {
    let differ = figures.iter().filter(|(_, count, bound)| count != bound);
    let lines = differ.map(|(place, count, bound)| match count < bound {
        true => format!("{count}, fewer than {bound}: lower the bound in this file. {place}"),
        false => format!("{count}, more than {bound}. {place}"),
    });
    let lines: Vec<String> = lines.collect();
    assert!(lines.is_empty(), "{what}:\n  {}\n", lines.join("\n  "));
}

/// For each file of a folder, the files of that folder that it imports.
fn imports(crate_root: &str, folder: &str) -> BTreeMap<Module, BTreeSet<Module>> {
    let files = files(&root().join(crate_root));
    let within =
        |module: &Module| folder.is_empty() || module.first().is_some_and(|it| it == folder);
    let inside = files.iter().filter(|(module, _)| within(module));
    let of = |(module, path): (&Module, &PathBuf)| {
        let file = syn::parse_file(&read(path)).expect("Rust");
        let mut uses = Uses { files: &files, module: module.clone(), found: BTreeSet::new() };
        uses.visit_file(&file);
        let mut found = uses.found;
        found.retain(|it| within(it) && it != module);
        (module.clone(), found)
    };
    inside.map(of).collect()
}

/// The files that one file names: in its `use` items, and in paths from `crate` or `super` on.
struct Uses<'f> {
    files: &'f BTreeMap<Module, PathBuf>,
    module: Module,
    found: BTreeSet<Module>,
}

impl Uses<'_> {
    /// Notes the file in which a path ends.
    fn note(&mut self, path: &[String]) {
        let mut at = self.module.clone();
        let mut rest = path.iter().peekable();
        match rest.peek().map(|word| word.as_str()) {
            Some("crate") => {
                rest.next();
                at.clear();
            }
            Some("super" | "self") => {
                while let Some(word) = rest.next_if(|it| matches!(it.as_str(), "super" | "self")) {
                    if word == "super" {
                        at.pop();
                    }
                }
            }
            // A child's, or another crate's.
            Some(word) if self.files.contains_key(&joined(&at, word)) => {}
            _ => return,
        }
        while let Some(word) = rest.next_if(|word| self.files.contains_key(&joined(&at, word))) {
            at = joined(&at, word);
        }
        // A module within a file is that file's.
        while !self.files.contains_key(&at) && at.pop().is_some() {}
        self.found.insert(at);
    }

    fn tree(&mut self, before: &[String], tree: &syn::UseTree) {
        match tree {
            syn::UseTree::Path(path) => {
                self.tree(&joined(before, &path.ident.to_string()), &path.tree)
            }
            syn::UseTree::Name(name) => self.note(&joined(before, &name.ident.to_string())),
            syn::UseTree::Rename(name) => self.note(&joined(before, &name.ident.to_string())),
            syn::UseTree::Glob(_) => self.note(before),
            syn::UseTree::Group(group) => {
                group.items.iter().for_each(|item| self.tree(before, item));
            }
        }
    }
}

impl<'ast> Visit<'ast> for Uses<'_> {
    fn visit_item_use(&mut self, item: &'ast syn::ItemUse) {
        self.tree(&[], &item.tree);
    }

    fn visit_path(&mut self, path: &'ast syn::Path) {
        let words: Vec<String> = path.segments.iter().map(|it| it.ident.to_string()).collect();
        if words.len() > 1 && matches!(words[0].as_str(), "crate" | "super") {
            self.note(&words);
        }
        visit::visit_path(self, path);
    }

    fn visit_item_mod(&mut self, item: &'ast syn::ItemMod) {
        if !is_test(&item.attrs) {
            self.module.push(item.ident.to_string());
            visit::visit_item_mod(self, item);
            self.module.pop();
        }
    }
}

/// Functions that name a temporary or a hidden local; the word changes only the text of the C.
const NAMING: [&str; 21] = [
    "assigned",
    "atom",
    "atom_place",
    "below",
    "below_unless_one",
    "called_here",
    "copy_of_part",
    "each_cell",
    "either",
    "fresh",
    "fresh_beside",
    "fresh_in",
    "held",
    "hidden",
    "let_local",
    "local",
    "mutable_place",
    "once",
    "part_copied",
    "role_name",
    "steady_index",
];

/// The file of a folder that has nothing but words for the C. Such a word counts where something is compared with it.
const TABLE: &str = "words";

/// The names of the constants of a file that has nothing else.
fn constants(text: &str) -> Vec<String> {
    let items = syn::parse_file(text).expect("Rust").items.into_iter();
    let name = |item| match item {
        syn::Item::Const(it) => it.ident.to_string(),
        _ => panic!("`{TABLE}.rs` has words, and nothing that could decide by them"),
    };
    items.map(name).collect()
}

/// Returns the quoted words that could name a method and decide something. Excluded are names of temporaries, roles of
/// operands, and words compared with a constant of the table.
fn deciding(text: &str, table: &[String]) -> Vec<String> {
    let mut words = Words { found: Vec::new(), table };
    words.visit_file(&syn::parse_file(text).expect("Rust"));
    words.found
}

/// All names in a piece of Rust.
struct Names(Vec<String>);

impl Names {
    fn tokens(&mut self, tokens: TokenStream) {
        for token in tokens {
            match token {
                TokenTree::Group(group) => self.tokens(group.stream()),
                TokenTree::Ident(it) => self.0.push(it.to_string()),
                _ => {}
            }
        }
    }
}

impl<'ast> Visit<'ast> for Names {
    fn visit_ident(&mut self, it: &'ast syn::Ident) {
        self.0.push(it.to_string());
    }
}

/// Methods that compare.
const COMPARING: [&str; 5] = ["contains", "eq", "ne", "starts_with", "ends_with"];

struct Words<'t> {
    found: Vec<String>,
    table: &'t [String],
}

impl Words<'_> {
    /// Notes the constants of the table in what something is compared with.
    fn compared(&mut self, visit: impl FnOnce(&mut Names)) {
        let mut names = Names(Vec::new());
        visit(&mut names);
        self.found.extend(names.0.into_iter().filter(|name| self.table.contains(name)));
    }

    fn arguments<'ast>(
        &mut self,
        callee: Option<&syn::Ident>,
        arguments: impl IntoIterator<Item = &'ast syn::Expr>,
    ) {
        let naming = callee.is_some_and(|callee| NAMING.iter().any(|name| callee == name));
        let decides = |argument: &&syn::Expr| !(naming && is_word(argument));
        arguments.into_iter().filter(decides).for_each(|argument| self.visit_expr(argument));
    }
}

impl<'ast> Visit<'ast> for Words<'_> {
    fn visit_expr_call(&mut self, call: &'ast syn::ExprCall) {
        self.visit_expr(&call.func);
        let callee = match &*call.func {
            syn::Expr::Path(it) => it.path.get_ident(),
            _ => None,
        };
        self.arguments(callee, &call.args);
    }

    fn visit_expr_method_call(&mut self, call: &'ast syn::ExprMethodCall) {
        if COMPARING.iter().any(|it| call.method == it) {
            self.compared(|names| names.visit_expr_method_call(call));
        }
        self.visit_expr(&call.receiver);
        self.arguments(Some(&call.method), &call.args);
    }

    fn visit_field_value(&mut self, field: &'ast syn::FieldValue) {
        let role = matches!(&field.member, syn::Member::Named(name) if name == "role");
        if !(role && is_word(&field.expr)) {
            visit::visit_field_value(self, field);
        }
    }

    fn visit_expr_binary(&mut self, it: &'ast syn::ExprBinary) {
        if matches!(it.op, syn::BinOp::Eq(_) | syn::BinOp::Ne(_)) {
            self.compared(|names| names.visit_expr_binary(it));
        }
        visit::visit_expr_binary(self, it);
    }

    fn visit_pat(&mut self, it: &'ast syn::Pat) {
        if matches!(it, syn::Pat::Path(_) | syn::Pat::Ident(_)) {
            self.compared(|names| names.visit_pat(it));
        }
        visit::visit_pat(self, it);
    }

    fn visit_lit_str(&mut self, literal: &'ast syn::LitStr) {
        self.found.extend(Some(literal.value()).filter(|word| is_name(word)));
    }

    // What syn leaves as tokens.
    fn visit_macro(&mut self, it: &'ast syn::Macro) {
        if !it.path.is_ident("format") {
            self.compared(|names| names.tokens(it.tokens.clone()));
        }
        quoted(it.tokens.clone(), &mut self.found);
    }

    fn visit_attribute(&mut self, it: &'ast syn::Attribute) {
        if let syn::Meta::List(list) = &it.meta {
            quoted(list.tokens.clone(), &mut self.found);
        }
    }
}

fn is_word(expr: &syn::Expr) -> bool {
    matches!(expr, syn::Expr::Lit(it) if matches!(it.lit, syn::Lit::Str(_)))
}

/// The words in quotation marks that a method could be called.
fn quoted(tokens: TokenStream, found: &mut Vec<String>) {
    for token in tokens {
        match token {
            TokenTree::Group(group) => quoted(group.stream(), found),
            TokenTree::Literal(literal) => {
                let text = literal.to_string();
                let word = text.strip_prefix('"').and_then(|text| text.strip_suffix('"'));
                found.extend(word.filter(|word| is_name(word)).map(str::to_owned));
            }
            _ => {}
        }
    }
}

fn is_name(word: &str) -> bool {
    let plain = |c: char| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '_';
    let first = word.starts_with(|first: char| first.is_ascii_lowercase());
    // A keyword is no name.
    first && word.chars().all(plain) && syn::parse_str::<syn::Ident>(word).is_ok()
}

#[test]
fn a_circle_is_found_and_a_chain_is_none() {
    let module = |name: &str| vec![name.to_owned()];
    let graph = |edges: &[(&str, &str)]| {
        let mut graph: BTreeMap<Module, BTreeSet<Module>> = BTreeMap::new();
        for (from, to) in edges {
            graph.entry(module(to)).or_default();
            graph.entry(module(from)).or_default().insert(module(to));
        }
        circles(&graph).iter().map(shown).collect::<Vec<_>>()
    };
    assert_eq!(graph(&[("a", "b"), ("b", "c"), ("a", "c")]), [""; 0]);
    assert_eq!(graph(&[("a", "b"), ("b", "c"), ("c", "b"), ("d", "a"), ("e", "e")]), ["b, c", "e"]);
}

#[test]
fn imports_are_read_as_rustc_reads_them() {
    let files = ["", "a", "a::b", "a::c", "d"].map(|path| {
        (path.split("::").filter(|it| !it.is_empty()).map(str::to_owned).collect(), PathBuf::new())
    });
    let files = BTreeMap::from(files);
    let found = |text: &str| {
        let module = vec!["a".to_owned(), "b".to_owned()];
        let mut uses = Uses { files: &files, module, found: BTreeSet::new() };
        uses.visit_file(&syn::parse_file(text).expect("Rust"));
        let names: Vec<String> = uses.found.iter().map(|module| module.join("::")).collect();
        names.join(" ")
    };
    assert_eq!(found("use super::c::{self, Thing as T}; use std::fmt;"), "a::c");
    assert_eq!(found("use super::Thing; use crate::d::*;"), "a d");
    assert_eq!(found("fn f() -> super::c::Thing { crate::d::g() }"), "a::c d");
    assert_eq!(found("mod inner { use super::super::c; use super::Own; }"), "a::b a::c");
    assert_eq!(found("#[cfg(test)] mod tests { use crate::d; }"), "");
}

#[test]
fn words_count_and_texts_do_not() {
    let found = |body: &str| deciding(&format!("fn f() {{ {body} }}"), &[]);
    assert_eq!(found("match m { \"map_or\" => say(\"two words\"), b\"x\" => f('c') }"), ["map_or"]);
    assert_eq!(found("/// A comment.\nmatches!(name, \"zip\" | \"Sum\" | \"_\");"), ["zip"]);
}

#[test]
fn names_of_temporaries_decide_nothing() {
    let found = |body: &str| deciding(&format!("fn f() {{ {body} }}"), &[]);
    assert_eq!(
        found("walk.atom(\"end\", is(\"rev\")); fresh(\"at\"); hold(\"by\");"),
        ["rev", "by"]
    );
    assert_eq!(found("fresh(if name == \"min\" { \"least\" } else { x });"), ["min", "least"]);
    assert_eq!(found("Operand { role: \"left\", name: \"right\" };"), ["right"]);
}

#[test]
fn words_of_the_table_count_where_they_are_compared() {
    let table = constants("const TAG: &str = \"tag\"; const ENDS: [&str; 2] = [\"from\", \"to\"];");
    let found = |body: &str| deciding(&format!("fn f() {{ {body} }}"), &table);
    assert_eq!(found("field(words::TAG, words::ENDS[0]); format!(\"{}\", words::TAG);"), [""; 0]);
    assert_eq!(found("if name == words::TAG { x } else { words::TAG };"), ["TAG"]);
    assert_eq!(found("match name { words::TAG => a, _ => b }"), ["TAG"]);
    assert_eq!(found("words::ENDS.contains(&name); matches!(it, words::TAG);"), ["ENDS", "TAG"]);
}
