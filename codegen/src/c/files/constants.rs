//! The constants of a source: those that its functions use, by their names.

use bessemer_ir::{ConstId, Type};

use super::{Includes, Writer};
use crate::c::context::{Context, Uses};
use crate::c::tree::{Init, Item, Lines};
use crate::c::{asked, described, literal};

impl Writer<'_> {
    pub(super) fn constants(&self, uses: &Uses, includes: &mut Includes) -> Vec<Item> {
        let module = self.context.module;
        let mut list: Vec<Item> = Vec::new();
        let mut ids: Vec<_> = uses.consts.iter().copied().collect();
        let header = format!("{}.h", self.name);
        let name = |id: &ConstId| self.context.names.constant(&header, *id);
        ids.sort_by_key(name);
        ids.dedup_by_key(|id| name(id));
        for id in ids {
            let item = &module.consts[id.index()];
            includes.ty(self.context, &item.ty);
            let mut declarator = self.context.names.declarator(&item.ty, name(&id));
            declarator.ty.insert_str(0, "const ");
            let mut words = item.words.as_slice();
            let init = constant_init(self.context, &item.ty, &mut words);
            let leaves = module.leaves(&item.ty);
            if leaves.iter().zip(&item.words).any(|(ty, word)| literal::needs_math(ty, *word)) {
                includes.system.insert("math.h");
            }
            let section = item.given.section.as_ref();
            list.push(Item::Constant {
                docs: described::value(
                    self.context.names,
                    &item.docs,
                    item.given.unit.as_deref(),
                    &item.ty,
                ),
                asked: section.map(|section| asked::section(section, self.options)),
                declarator,
                init,
            });
        }
        list
    }
}

fn constant_init(context: Context<'_>, ty: &Type, words: &mut &[u64]) -> Init {
    let list = |items: Vec<(Option<String>, Init)>, lines| Init::List { items, lines };
    match ty {
        Type::Struct(id) => {
            let names = &context.names.structs[id.index()].fields;
            let item = &context.module.structs[id.index()];
            let first = words.first().copied().unwrap_or_default();
            let mut items = Vec::new();
            for (index, (field, name)) in item.fields.iter().zip(names).enumerate() {
                let init = constant_init(context, &field.ty, words);
                if field.ty != Type::Unit && (!item.overlaid() || item.holds(index, first)) {
                    items.push((Some(name.clone()), init));
                }
            }
            list(items, Lines::Fill)
        }
        Type::Array { element, len } => {
            let items = (0..*len).map(|_| (None, constant_init(context, element, words)));
            list(items.collect(), Lines::Fill)
        }
        Type::Matrix { element, rows, cols } => {
            let element = Type::Scalar(*element);
            let items: Vec<_> =
                (0..rows * cols).map(|_| constant_init(context, &element, words)).collect();
            let groups = *rows > 1 && *cols > 1;
            let lines = if groups { Lines::Groups(*rows as usize) } else { Lines::Fill };
            context.names.layout.list(&items, (*rows, *cols), lines)
        }
        _ => {
            let (word, rest) = words.split_first().expect("the validator counts words");
            *words = rest;
            Init::Value(literal::word(context.names, ty, *word))
        }
    }
}
