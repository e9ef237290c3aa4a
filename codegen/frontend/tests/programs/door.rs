//! One program of a package: the part of the tree that it needs, stored as lines of JSON, and its IR as text.
//!
//! Two tests share it: the front half's own, which reads stored trees, and the test of `legs/`, which has the tree of the
//! whole corpus.

#![allow(dead_code, reason = "neither test needs all of it")]

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

use bessemer_frontend::diagnostic::Diagnostic;
use bessemer_frontend::source::Sources;
use bessemer_frontend::typify::typify;
use bessemer_ir::tree::{Alias, Definition, Function, Implied, Package, Table};
use bessemer_ir::visit::{self, Access, VisitMut};
use bessemer_ir::{Expr, Module, Place, Span, Stmt, text};
use serde::{Deserialize, Serialize};

/// Stack for the recursion over trees, in bytes.
const STACK: usize = 1 << 28;
/// Distance between the lines of two functions of a file, which none has.
const DISTANCE: u32 = 10_000;
/// The module of all programs.
const PROGRAMS: &str = "corpus::programs::";
/// The items that are no program's, beside the stored trees.
pub const LIBRARY: &str = "library";

/// Returns the folder of the stored trees.
pub fn trees(root: &Path) -> PathBuf {
    root.join("codegen/frontend/tests/programs")
}

/// Returns the folder of the IR.
pub fn golden(root: &Path) -> PathBuf {
    root.join("tests/corpus/golden/ir")
}

/// Returns the file of a program's module in a folder.
pub fn file(folder: &Path, module: &str, ending: &str) -> PathBuf {
    let name = module.strip_prefix(PROGRAMS).unwrap_or(module).replace("::", "/");
    folder.join(format!("{name}.{ending}"))
}

/// Returns the files below a folder that have an ending, each with its program's module.
pub fn files(folder: &Path, ending: &str) -> BTreeMap<String, PathBuf> {
    let (mut found, mut open) = (BTreeMap::new(), vec![folder.to_owned()]);
    while let Some(at) = open.pop() {
        for entry in fs::read_dir(&at).into_iter().flatten().flatten() {
            let path = entry.path();
            if path.is_dir() {
                open.push(path);
            } else if path.extension().is_some_and(|it| it == ending) {
                let name = path.strip_prefix(folder).unwrap_or(&path).with_extension("");
                let parts = name.iter().map(|part| part.to_string_lossy()).collect::<Vec<_>>();
                found.insert(format!("{PROGRAMS}{}", parts.join("::")), path);
            }
        }
    }
    found
}

/// Compares a file with the text that it should have; returns the first difference. With `UPDATE_DOCS` it writes the text.
pub fn differs(path: &Path, text: &str) -> Option<String> {
    let old = fs::read_to_string(path).unwrap_or_default();
    if old == text && path.exists() {
        return None;
    }
    if std::env::var_os("UPDATE_DOCS").is_some() {
        fs::create_dir_all(path.parent().unwrap_or(path)).expect("a folder of golden files");
        fs::write(path, text).expect("a golden file can be written");
        return None;
    }
    let same = old.lines().zip(text.lines()).take_while(|(old, new)| old == new).count();
    let line =
        |text: &str| text.lines().nth(same).unwrap_or("(nothing)").chars().take(200).collect();
    let (was, is): (String, String) = (line(&old), line(text));
    Some(format!("{}:{}\n    was {was}\n    is  {is}", path.display(), same + 1))
}

/// An item of a package.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub enum Item {
    Type(Definition),
    Function(Box<Function>),
    Alias(Alias),
    Table(Table),
    Implied(Implied),
}

/// The items of a package, in their order.
pub struct Items {
    name: String,
    items: Vec<(Item, String)>,
    /// The items of a path.
    paths: BTreeMap<String, Vec<usize>>,
}

impl Item {
    /// Returns the paths by which others name the item.
    fn paths(&self) -> Vec<&str> {
        match self {
            Item::Type(it) => vec![&it.path],
            Item::Function(it) => vec![&it.path],
            Item::Alias(it) => vec![&it.of],
            Item::Table(_) | Item::Implied(_) => Vec::new(),
        }
    }

    /// Returns the file and the line of a function's name.
    fn home(&self) -> Option<(String, u32)> {
        match self {
            Item::Function(it) => Some((it.file.clone(), it.tree.site.0)),
            _ => None,
        }
    }

    /// Returns the key of its order. The linker decides the order of functions; types are in the order of definition.
    fn order(&self) -> (u8, &str, u32) {
        match self {
            Item::Type(_) => (0, "", 0),
            Item::Function(it) => (1, &it.file, it.tree.site.0),
            Item::Alias(_) => (2, "", 0),
            Item::Table(_) => (3, "", 0),
            Item::Implied(_) => (4, "", 0),
        }
    }

    /// Returns the module that the item is declared in.
    fn module(&self) -> &str {
        match self {
            Item::Type(it) => &it.module,
            Item::Function(it) => &it.module,
            Item::Alias(it) => &it.module,
            Item::Table(it) => &it.module,
            Item::Implied(_) => "",
        }
    }
}

impl Items {
    /// Returns the items of a package, without places in the source; files are named from `root` on.
    pub fn of(package: Package, root: &str) -> Items {
        let named = |file: &mut String| {
            if let Some(at) = file.find(root) {
                *file = file.split_off(at);
            }
        };
        let Package { name, types, functions, aliases, tables, implied, .. } = package;
        let types = types.into_iter().map(|mut it| {
            named(&mut it.file);
            it.docs.clear();
            Item::Type(it)
        });
        let functions = functions.into_iter().map(|mut it| {
            named(&mut it.file);
            it.tree.docs.clear();
            Item::Function(Box::new(it))
        });
        let aliases = aliases.into_iter().map(|mut it| {
            named(&mut it.file);
            Item::Alias(it)
        });
        let tables = tables.into_iter().map(|mut it| {
            named(&mut it.file);
            Item::Table(it)
        });
        let items = types.chain(functions).chain(aliases).chain(tables);
        let items = items.chain(implied.into_iter().map(Item::Implied));
        let items: Vec<Item> = items.collect();
        let homes: BTreeSet<(String, u32)> = items.iter().filter_map(Item::home).collect();
        let line = |item: Item| {
            let first = item.home().map(|home| {
                let before = homes.range((home.0.clone(), 0)..home.clone()).count();
                (home.1, DISTANCE * (1 + before as u32))
            });
            let line = serde_json::to_string(&item).expect("a tree is JSON");
            let line = with_own_lines(&line, first);
            let item = bessemer_ir::tree::read(&line).expect("a tree with other lines is one");
            (item, line)
        };
        let mut items: Vec<(Item, String)> = items.into_iter().map(line).collect();
        let is_function = |item: &Item| matches!(item, Item::Function(_));
        let key = |(item, text): &(Item, String)| {
            let (kind, file, line) = item.order();
            let text = if is_function(item) { text.clone() } else { String::new() };
            (kind, file.to_owned(), line, text)
        };
        items.sort_by_cached_key(key);
        Items::indexed(name, items)
    }

    /// Returns the items of some stored texts.
    ///
    /// # Errors
    /// The first line that is no item.
    pub fn read(name: &str, texts: &[&str]) -> serde_json::Result<Items> {
        let lines = texts.iter().flat_map(|text| text.lines());
        let item = |line: &str| Ok((bessemer_ir::tree::read(line)?, line.to_owned()));
        let items = lines.map(item).collect::<serde_json::Result<Vec<_>>>()?;
        Ok(Items::indexed(name.to_owned(), items))
    }

    fn indexed(name: String, items: Vec<(Item, String)>) -> Items {
        let mut paths = BTreeMap::<String, Vec<usize>>::new();
        for (at, (item, _)) in items.iter().enumerate() {
            for path in item.paths() {
                paths.entry(path.to_owned()).or_default().push(at);
            }
        }
        Items { name, items, paths }
    }

    /// Returns the modules of the package's own functions.
    pub fn modules(&self) -> BTreeSet<&str> {
        let functions = self.items.iter().filter_map(|(item, _)| match item {
            Item::Function(it) => Some(it.module.as_str()),
            _ => None,
        });
        functions.filter(|it| it.split("::").next() == Some(self.name.as_str())).collect()
    }

    /// Returns the items that a module's own name, by their numbers. An implementation is needed where its types are.
    fn needed(&self, module: &str) -> BTreeSet<usize> {
        let own = self.items.iter().enumerate().filter(|(_, (item, _))| item.module() == module);
        let mut open: Vec<usize> = own.map(|(at, _)| at).collect();
        let mut needed: BTreeSet<usize> = open.iter().copied().collect();
        loop {
            while let Some(at) = open.pop() {
                let words = self.items[at].1.split('"');
                let named = words.filter_map(|word| self.paths.get(word)).flatten();
                open.extend(named.copied().filter(|at| needed.insert(*at)));
            }
            for (at, (item, _)) in self.items.iter().enumerate() {
                if let Item::Implied(implied) = item
                    && self.has_types_of(implied, &needed)
                    && needed.insert(at)
                {
                    open.push(at);
                }
            }
            if open.is_empty() {
                return needed;
            }
        }
    }

    /// Reports if all types that an implementation names are needed.
    fn has_types_of(&self, implied: &Implied, needed: &BTreeSet<usize>) -> bool {
        let types = serde_json::to_string(&(&implied.owner, &implied.other));
        let types = types.expect("types are JSON");
        let mut named = types.split('"').filter_map(|word| self.paths.get(word)).flatten();
        named.all(|at| needed.contains(at))
    }

    /// Returns the lines of a module's needed items: first those that are no program's, then the others.
    pub fn lines(&self, module: &str) -> [BTreeSet<(usize, &str)>; 2] {
        let line = |at: usize| (at, self.items[at].1.as_str());
        let lines = self.needed(module).into_iter().map(line);
        let (programs, others) = lines.partition(|(_, line)| line.contains(PROGRAMS));
        [others, programs]
    }

    /// Returns a package of some of the items.
    fn package(&self, items: &BTreeSet<usize>) -> Package {
        let mut package = Package { name: self.name.clone(), ..Package::default() };
        for at in items {
            match self.items[*at].0.clone() {
                Item::Type(it) => package.types.push(it),
                Item::Function(it) => package.functions.push(*it),
                Item::Alias(it) => package.aliases.push(it),
                Item::Table(it) => package.tables.push(it),
                Item::Implied(it) => package.implied.push(it),
            }
        }
        package
    }

    /// Returns the IR of a module: its own items, without places in the source.
    ///
    /// # Errors
    /// Everything that is wrong with it.
    pub fn ir(&self, module: &str) -> Result<String, Vec<Diagnostic>> {
        let package = self.package(&self.needed(module));
        let nowhere = Sources::new(Path::new("nowhere"));
        let (mut typed, _) = typify(&package, &nowhere, true)?;
        strip(&mut typed);
        Ok(own_items(&text::print(&typed), module))
    }
}

/// Runs the work on a stack that is deep enough for a tree.
pub fn deep<T: Send>(work: impl FnOnce() -> T + Send) -> T {
    std::thread::scope(|scope| {
        let thread = std::thread::Builder::new().stack_size(STACK).spawn_scoped(scope, work);
        let done = thread.expect("a thread starts").join();
        done.unwrap_or_else(|panic| std::panic::resume_unwind(panic))
    })
}

/// Replaces the lines of a function by lines of its own, so that an edit above it does not show. `first` is the line
/// of its name, and the line that replaces that. Elsewhere a place has no line.
fn with_own_lines(text: &str, first: Option<(u32, u32)>) -> String {
    const SITE: &str = "\"site\":[";
    let mut parts = text.split(SITE);
    let mut made = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        let (line, behind) = part.split_once(',').unwrap_or((part, ""));
        let line = match (first, line.parse::<u32>()) {
            (Some((from, to)), Ok(line @ 1..)) => (line + to).saturating_sub(from),
            _ => 0,
        };
        made += &format!("{SITE}{line},{behind}");
    }
    made
}

/// Keeps the blocks of a module's text whose items are declared in `module`, which they need not name then.
fn own_items(text: &str, module: &str) -> String {
    let place = format!(" in {module}");
    let own = |block: &str| {
        let (head, rest) = block.split_once('\n').unwrap_or((block, ""));
        let (before, behind) = head.split_once(&place)?;
        let ends = behind.starts_with([' ', '(', ':']) && !behind.starts_with("::");
        ends.then(|| format!("{before}{behind}\n{}", rest.trim_end()).trim_end().to_owned())
    };
    let blocks: Vec<String> = text.split("\n\n").filter_map(own).collect();
    blocks.join("\n\n") + "\n"
}

/// Removes places in the source, documentation and comments.
fn strip(module: &mut Module) {
    module.files.clear();
    module.about.clear();
    module.written.clear();
    for it in &mut module.structs {
        (it.span, it.docs) = Default::default();
        for field in &mut it.fields {
            field.docs.clear();
        }
    }
    for it in &mut module.enums {
        (it.span, it.docs) = Default::default();
        for variant in &mut it.variants {
            variant.docs.clear();
        }
    }
    for it in &mut module.consts {
        (it.span, it.docs) = Default::default();
    }
    for it in &mut module.functions {
        (it.span, it.docs) = Default::default();
        for local in &mut it.locals {
            local.span = Span::default();
        }
        Strip.block(&mut it.body);
    }
}

struct Strip;

impl VisitMut for Strip {
    fn stmt(&mut self, stmt: &mut Stmt) {
        (stmt.span, stmt.comments) = Default::default();
        visit::walk_stmt_mut(self, stmt);
    }

    fn expr(&mut self, expr: &mut Expr) {
        expr.span = Span::default();
        visit::walk_expr_mut(self, expr);
    }

    fn place(&mut self, place: &mut Place, access: Access) {
        let _ = access;
        place.span = Span::default();
        visit::walk_place_mut(self, place);
    }
}
