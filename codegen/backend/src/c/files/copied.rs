//! Copies of small functions of other files, which the loops of a source call ([`crate::c::near`]).

use std::collections::BTreeSet;

use bessemer_ir::FunctionId;

use super::{Includes, Writer};
use crate::c::context::Uses;
use crate::c::described;
use crate::c::tree::{Item, Storage};

impl Writer<'_> {
    /// Returns the copies that these functions of the source call.
    pub(super) fn copies(
        &self,
        callers: Vec<FunctionId>,
        uses: &mut Uses,
        includes: &mut Includes,
    ) -> Vec<Item> {
        let (module, names) = (self.context.module, self.context.names);
        let mut items = Vec::new();
        for (id, name) in names.copied(callers.into_iter()) {
            // The branch that calls it may have been removed.
            if !uses.called.contains(&id) {
                continue;
            }
            let (function, signature) = (&module.functions[id.index()], names.signature(id));
            includes.signature(self.context, self.options, signature);
            // Its author requests nothing of a compiler.
            let mut item = self.definition(id, uses, includes, &mut BTreeSet::new());
            if let Item::Function { docs, head, .. } = &mut item {
                *docs = described::function(module, names, function, signature);
                docs.push(format!("A copy of `{}`, for the loops of this file.", head.name));
                (head.storage, head.name) = (Storage::OwnInline, name);
            }
            items.push(item);
        }
        items
    }
}
