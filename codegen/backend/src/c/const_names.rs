//! Names of constants in the C, and the set of constants that all sources share.
//!
//! A marked `pub` constant is defined once, with its module as a prefix, as functions have. So is a constant of an
//! inline function that other modules may call. Its file and name so depend only on its definition. Any other
//! constant is `static` in each file that uses it, under the author's name. It has a prefix only if two constants in
//! one file have this name and different values, or if a type, a variant or a function has it. Thus other files have
//! no influence.

use std::collections::{BTreeMap, BTreeSet};

use bessemer_ir::visit::Walk;
use bessemer_ir::{Const, ConstId, FunctionId, Module};

use super::analysis::inline_callees;
use super::reserved::is_reserved_globally;
use super::signature::Signature;
use super::sizes;
use super::spelling::{identifier, last_segment, relative, screaming, unique};
use super::tree::Storage;

/// Names of constants, by file (its header) and constant.
#[derive(Clone, Debug, Default)]
pub struct ConstNames {
    files: BTreeMap<String, BTreeMap<ConstId, String>>,
    shared: BTreeMap<ConstId, String>,
    all: BTreeSet<String>,
}

impl ConstNames {
    /// Names the constants that the functions use; `globals` are the names of all other items.
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
                    file.extend(module.constant(expr));
                });
            }
        }
        let everything = used.values().flatten().copied();
        let everything = everything.chain(sizes::all(module)).chain(sizes::names(module));
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

    /// Returns the name of a shared constant.
    pub fn shared(&self, id: ConstId) -> Option<&str> {
        self.shared.get(&id).map(String::as_str)
    }

    /// Returns the name of a constant in a file.
    pub fn get(&self, file: &str, id: ConstId) -> &str {
        let own = || self.files.get(file)?.get(&id).map(String::as_str);
        self.shared(id).or_else(own).unwrap_or_default()
    }

    /// Returns true if a constant has a different name in some file.
    pub fn renamed(&self, id: ConstId, name: &str) -> bool {
        let files = self.files.values().chain([&self.shared]);
        files.filter_map(|names| names.get(&id)).any(|own| own != name)
    }

    /// Returns true if any constant has this name.
    pub fn contains(&self, name: &str) -> bool {
        self.all.contains(name)
    }
}

/// Returns the names of the shared constants.
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

/// Returns the names of the constants of one file.
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
