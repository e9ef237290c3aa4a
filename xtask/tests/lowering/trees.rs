//! Places that build nodes of the author's tree while they lower it.

use std::collections::{BTreeMap, BTreeSet};

use syn::spanned::Spanned;
use syn::visit::{self, Visit};

use super::Files;

/// The nodes of the tree.
const NODES: [&str; 10] =
    ["Arm", "Block", "Closure", "Expr", "ExprKind", "Pattern", "Range", "Source", "Start", "Stmt"];

/// Returns, for each file, the lines where a node is built. A node within another counts with that one.
pub fn built(files: &Files) -> Vec<(String, Vec<usize>)> {
    let mut found = Vec::new();
    for (module, file) in files {
        let mut built = Built::default();
        built.visit_file(file);
        if !built.lines.is_empty() {
            let name = if module.is_empty() { "mod".to_owned() } else { module.join("::") };
            found.push((name, built.lines));
        }
    }
    found
}

#[derive(Default)]
struct Built {
    /// The nodes by their names in this file, and the names of the tree's module.
    names: BTreeMap<String, String>,
    modules: BTreeSet<String>,
    lines: Vec<usize>,
}

impl Built {
    /// Notes what a `use` of the tree names.
    fn import(&mut self, tree: &syn::UseTree, in_tree: bool) {
        let mut named = |name: &syn::Ident, here: &syn::Ident| {
            let (name, here) = (name.to_string(), here.to_string());
            if in_tree && NODES.contains(&name.as_str()) {
                self.names.insert(here, name);
            } else if name == "tree" || in_tree && name == "self" {
                self.modules.insert("tree".to_owned());
            }
        };
        match tree {
            syn::UseTree::Path(it) => self.import(&it.tree, in_tree || it.ident == "tree"),
            syn::UseTree::Name(it) => named(&it.ident, &it.ident),
            syn::UseTree::Rename(it) => named(&it.ident, &it.rename),
            syn::UseTree::Group(it) => it.items.iter().for_each(|it| self.import(it, in_tree)),
            syn::UseTree::Glob(_) => {}
        }
    }

    /// Returns how many segments of a path name a node, if it begins with one.
    fn node(&self, path: &syn::Path) -> Option<usize> {
        let names: Vec<String> = path.segments.iter().map(|it| it.ident.to_string()).collect();
        match &names[..] {
            [first, ..] if self.names.contains_key(first) => Some(1),
            [first, second, ..]
                if self.modules.contains(first) && NODES.contains(&second.as_str()) =>
            {
                Some(2)
            }
            _ => None,
        }
    }
}

impl<'ast> Visit<'ast> for Built {
    fn visit_item_use(&mut self, it: &'ast syn::ItemUse) {
        self.import(&it.tree, false);
    }

    fn visit_expr_struct(&mut self, it: &'ast syn::ExprStruct) {
        match self.node(&it.path) {
            Some(_) => self.lines.push(it.span().start().line),
            None => visit::visit_expr_struct(self, it),
        }
    }

    fn visit_expr_call(&mut self, it: &'ast syn::ExprCall) {
        let built = match &*it.func {
            syn::Expr::Path(of) => {
                self.node(&of.path).is_some_and(|node| of.path.segments.len() > node)
            }
            _ => false,
        };
        match built {
            true => self.lines.push(it.span().start().line),
            false => visit::visit_expr_call(self, it),
        }
    }

    // A pattern reads. One without parts is a path to syn.
    fn visit_pat(&mut self, it: &'ast syn::Pat) {
        if !matches!(it, syn::Pat::Path(_)) {
            visit::visit_pat(self, it);
        }
    }

    fn visit_expr_path(&mut self, it: &'ast syn::ExprPath) {
        if self.node(&it.path).is_some_and(|node| it.path.segments.len() > node) {
            self.lines.push(it.span().start().line);
        }
    }
}
