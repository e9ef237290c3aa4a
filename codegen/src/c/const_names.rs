//! The names of constants, file by file.
//!
//! A constant is `static` in each file that uses it, under the author's own name; it is qualified where
//! two in one file differ in value, or where a type, a variant or a function has the name. So what another
//! file uses changes nothing.

use std::collections::{BTreeMap, BTreeSet};

use bessemer_ir::visit::Walk;
use bessemer_ir::{Const, ConstId, ExprKind, FunctionId, Module};

use super::analysis::inline_callees;
use super::reserved::is_reserved_globally;
use super::signature::Signature;
use super::spelling::{identifier, relative, screaming, unique};
use super::tree::Storage;

/// The names, by file (its header) and constant.
#[derive(Clone, Debug, Default)]
pub struct ConstNames {
    files: BTreeMap<String, BTreeMap<ConstId, String>>,
    all: BTreeSet<String>,
}

impl ConstNames {
    /// Names the constants that the functions use; `globals` are the names of everything else.
    pub fn new(module: &Module, functions: &[Signature], globals: &BTreeSet<String>) -> ConstNames {
        let mut used: BTreeMap<&str, BTreeSet<ConstId>> = BTreeMap::new();
        let inline = |id: FunctionId| functions[id.index()].storage == Storage::Inline;
        for (index, signature) in functions.iter().enumerate() {
            let id = FunctionId(index as u32);
            if inline(id) {
                continue;
            }
            let file = used.entry(&signature.header).or_default();
            for id in [id].into_iter().chain(inline_callees(module, [id], inline)) {
                module.functions[id.index()].body.each_expr(|expr| {
                    if let ExprKind::Const(id) = expr.kind {
                        file.insert(id);
                    }
                });
            }
        }
        let files = used.into_iter();
        let files = files.map(|(file, ids)| (file.to_owned(), of_file(module, &ids, globals)));
        let files: BTreeMap<_, BTreeMap<_, String>> = files.collect();
        let all = files.values().flat_map(BTreeMap::values).cloned().collect();
        ConstNames { files, all }
    }

    /// The name of a constant in a file.
    pub fn get(&self, file: &str, id: ConstId) -> &str {
        self.files.get(file).and_then(|names| names.get(&id)).map_or("", String::as_str)
    }

    /// Whether a constant has another name than this in some file.
    pub fn renamed(&self, id: ConstId, name: &str) -> bool {
        self.files.values().filter_map(|names| names.get(&id)).any(|own| own != name)
    }

    /// Whether any constant has this name.
    pub fn contains(&self, name: &str) -> bool {
        self.all.contains(name)
    }
}

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
