//! The names of constants, and which of them are beside all sources.
//!
//! A constant that its author marked, and that is `pub`, stands once, with its module's name before it, as a function has; so at its place and
//! what it is called follow from it alone. So does one of an inline function that other modules may call. Any other is `static` in each file that uses it, under the author's own name; it is
//! qualified where two in one file differ in value, or where a type, a variant or a function has the name. So what another
//! file uses changes nothing.

use std::collections::{BTreeMap, BTreeSet};

use bessemer_ir::visit::Walk;
use bessemer_ir::{Const, ConstId, ExprKind, FunctionId, Module};

use super::analysis::inline_callees;
use super::reserved::is_reserved_globally;
use super::signature::Signature;
use super::sizes;
use super::spelling::{identifier, last_segment, relative, screaming, unique};
use super::tree::Storage;

/// The names, by file (its header) and constant.
#[derive(Clone, Debug, Default)]
pub struct ConstNames {
    files: BTreeMap<String, BTreeMap<ConstId, String>>,
    shared: BTreeMap<ConstId, String>,
    all: BTreeSet<String>,
}

impl ConstNames {
    /// Names the constants that the functions use; `globals` are the names of everything else.
    pub fn new(
        module: &Module,
        functions: &[Signature],
        globals: &BTreeSet<String>,
        prefix: &str,
    ) -> ConstNames {
        let mut used: BTreeMap<&str, BTreeSet<ConstId>> = BTreeMap::new();
        let storage = |id: FunctionId| functions[id.index()].storage;
        let own_inline = |id: FunctionId| storage(id) == Storage::OwnInline;
        let mut of_inline = BTreeSet::new();
        for (index, signature) in functions.iter().enumerate() {
            let id = FunctionId(index as u32);
            let file = match storage(id) {
                Storage::OwnInline => continue,
                Storage::Inline => &mut of_inline,
                _ => used.entry(&signature.header).or_default(),
            };
            for id in [id].into_iter().chain(inline_callees(module, [id], own_inline)) {
                module.functions[id.index()].body.each_expr(|expr| {
                    if let ExprKind::Const(id) = expr.kind {
                        file.insert(id);
                    }
                });
            }
        }
        let everything = used.values().flatten().copied().chain(sizes::named(module));
        let mut marked: BTreeSet<ConstId> =
            everything.filter(|id| module.consts[id.index()].given.public).collect();
        marked.append(&mut of_inline);
        let shared = beside_all(module, &marked, globals, prefix);
        let taken: BTreeSet<String> = globals.iter().chain(shared.values()).cloned().collect();
        let own = |ids: &BTreeSet<ConstId>| {
            let ids: BTreeSet<ConstId> = ids.difference(&marked).copied().collect();
            of_file(module, &ids, &taken)
        };
        let files = used.iter().map(|(file, ids)| ((*file).to_owned(), own(ids)));
        let files: BTreeMap<_, BTreeMap<_, String>> = files.collect();
        let all = files.values().chain([&shared]).flat_map(BTreeMap::values).cloned().collect();
        ConstNames { files, shared, all }
    }

    /// The name of a constant that is beside all sources.
    pub fn shared(&self, id: ConstId) -> Option<&str> {
        self.shared.get(&id).map(String::as_str)
    }

    /// The name of a constant in a file.
    pub fn get(&self, file: &str, id: ConstId) -> &str {
        let own = || self.files.get(file)?.get(&id).map(String::as_str);
        self.shared(id).or_else(own).unwrap_or_default()
    }

    /// Returns true if a constant has another name than this in some file.
    pub fn renamed(&self, id: ConstId, name: &str) -> bool {
        let files = self.files.values().chain([&self.shared]);
        files.filter_map(|names| names.get(&id)).any(|own| own != name)
    }

    /// Returns true if any constant has this name.
    pub fn contains(&self, name: &str) -> bool {
        self.all.contains(name)
    }
}

/// The names of those that are beside all sources.
fn beside_all(
    module: &Module,
    ids: &BTreeSet<ConstId>,
    globals: &BTreeSet<String>,
    prefix: &str,
) -> BTreeMap<ConstId, String> {
    let mut names: BTreeMap<ConstId, String> = BTreeMap::new();
    for id in ids {
        let Const { name, module: path, given, .. } = &module.consts[id.index()];
        let wanted = given.name.clone().unwrap_or_else(|| {
            screaming(&format!(
                "{prefix}{}_{}",
                last_segment(path),
                identifier(name).to_lowercase()
            ))
        });
        let taken = |name: &str| globals.contains(name) || names.values().any(|it| it == name);
        let name = if given.name.is_some() { wanted } else { unique(&wanted, taken) };
        names.insert(*id, name);
    }
    names
}

/// The names of those of one file.
fn of_file(
    module: &Module,
    ids: &BTreeSet<ConstId>,
    globals: &BTreeSet<String>,
) -> BTreeMap<ConstId, String> {
    let item = |id: &ConstId| &module.consts[id.index()];
    let same = |a: &Const, b: &Const| a.ty == b.ty && a.words == b.words;
    let wanted = |id: &ConstId| {
        if let Some(name) = &item(id).given.name {
            return name.clone();
        }
        let own = identifier(&item(id).name);
        let rival =
            |other: &ConstId| identifier(&item(other).name) == own && !same(item(id), item(other));
        if ids.iter().any(rival) || is_reserved_globally(&own) || globals.contains(&own) {
            screaming(&format!("{}_{own}", relative(&item(id).module).join("_")))
        } else {
            own
        }
    };
    // Two modules may end alike, too; the one must not be taken for the other.
    let mut names: BTreeMap<ConstId, String> = BTreeMap::new();
    for id in ids {
        let given = item(id).given.name.is_some();
        let taken = |name: &str| {
            !given && globals.contains(name)
                || names.iter().any(|(before, n)| n == name && !same(item(before), item(id)))
        };
        names.insert(*id, unique(&wanted(id), taken));
    }
    names
}
