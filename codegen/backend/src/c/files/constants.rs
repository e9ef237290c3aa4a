//! Constants in files: those of one source, and shared ones, which are defined once.
//!
//! Shared sizes are also in a header for callers ([`sizes`]). Other words are in a header, so that C compilers
//! compute with them, and so are polynomials of inline functions. Tables are declared there, and defined in a source
//! of their own.

use std::collections::BTreeSet;

use bessemer_ir::{Const, ConstId, Type};

use super::includes::Includes;
use super::{Writer, origin};
use crate::c::assemble::assemble;
use crate::c::context::Context;
use crate::c::file::CFile;
use crate::c::literal::{self, Readers};
use crate::c::options::Options;
use crate::c::shell::Shell;
use crate::c::spelling::identifier;
use crate::c::tree::{Expr, Init, Item, Lines, Storage};
use crate::c::{asked, described, internal, sizes, target};

/// Largest number of words in a polynomial; longer constants are tables.
const FEW: usize = 16;

const SUMMARY: &str = "constants, for the sources beside it alone.";

impl Writer<'_> {
    /// Returns the constants that only this source has.
    pub(super) fn constants(&self, used: &BTreeSet<ConstId>, includes: &mut Includes) -> Vec<Item> {
        let names = self.context.names;
        let own: Vec<ConstId> =
            used.iter().copied().filter(|id| names.shared_constant(*id).is_none()).collect();
        let file = self.options.header(&self.name);
        let list = by_name(&own, |id| names.constant(&file, id));
        let item = |(name, id)| constant(self.context, self.options, id, name, includes);
        list.into_iter().map(item).collect()
    }
}

/// Returns the files of shared constants: a header, and a source if there are tables.
pub(super) fn shared(
    context: Context<'_>,
    options: &Options,
    used: &BTreeSet<ConstId>,
) -> Vec<CFile> {
    let name = |id| context.names.shared_constant(id).unwrap_or_default();
    let ids: Vec<ConstId> = used.iter().copied().filter(|id| !name(*id).is_empty()).collect();
    let (mut declared, mut defined) = (Vec::new(), Vec::new());
    let (mut of_header, mut of_source) = (Includes::default(), Includes::default());
    let (mut sizes, mut texts) = (Vec::new(), Vec::new());
    for (name, id) in by_name(&ids, name) {
        let item = &context.module.consts[id.index()];
        if sizes::is_one(item) || item.is_name() {
            let list = if item.is_name() { &mut texts } else { &mut sizes };
            list.push(defined_for_callers(context, id, name));
            continue;
        }
        if is_in_header(item) {
            declared.push(constant(context, options, id, name, &mut of_header));
            continue;
        }
        let mut table = constant(context, options, id, name, &mut of_source);
        of_header.ty(context, &item.ty);
        if let Item::Constant { storage, docs, declarator, origin, path, .. } = &mut table {
            *storage = Storage::Extern;
            declared.push(Item::Constant {
                storage: Storage::Extern,
                docs: std::mem::take(docs),
                asked: None,
                declarator: declarator.clone(),
                init: None,
                origin: *origin,
                path: path.clone(),
            });
        }
        defined.push(table);
    }
    if defined.iter().any(|it| matches!(it, Item::Constant { asked: Some(_), .. })) {
        defined.insert(0, Item::Verbatim(asked::Macro::Section.text(options)));
    }
    let header = internal::constants(options);
    let file = |name: &str, summary: &str, items: &[Item], includes: Includes| {
        let shell = Shell {
            about: &[],
            file: name,
            header: &header,
            summary,
            source: &context.module.name,
            license: &options.license,
            pragmas: options.pragmas,
            system_includes: includes.system(),
            own_includes: includes.own(&header),
            calls: false,
            refuses: true,
            computes: false,
        };
        assemble(context, name, &shell, name.ends_with(".h"), items)
    };
    let mut files = Vec::new();
    if !declared.is_empty() {
        files.push(file(&header, SUMMARY, &declared, of_header));
    }
    if !defined.is_empty() {
        of_source.own.insert(target::name(options));
        files.push(file(
            &format!("{}_constants.c", identifier(&options.status)),
            SUMMARY,
            &defined,
            of_source,
        ));
    }
    for (header, summary, items) in [
        (sizes::header(options), "sizes and numbers of elements.", sizes),
        (sizes::names_header(options), "names, each as the CRC-32 of its text.", texts),
    ] {
        if !items.is_empty() {
            let mut includes = Includes::default();
            includes.ty(context, &Type::USIZE);
            files.push(file(&header, summary, &items, includes));
        }
    }
    files
}

/// Returns true if the value of a shared constant must be visible where it is used. These are scalars, and the short
/// aggregates of inline functions, which compilers fold completely.
fn is_in_header(item: &Const) -> bool {
    let few = !item.given.public && item.words.len() <= FEW;
    item.given.section.is_none() && (item.ty.is_word() || few)
}

/// Returns the macro of a size or a name.
fn defined_for_callers(context: Context<'_>, id: ConstId, name: &str) -> Item {
    let item = &context.module.consts[id.index()];
    let value = match item.is_name() {
        true => Expr::name(format!("0x{:08X}U", item.words[0])),
        false => literal::word(context.names, &item.ty, item.words[0], Readers::Cpp),
    };
    Item::Define {
        docs: described::constant(context.names, item),
        name: name.to_owned(),
        value,
        origin: origin(item.span),
        path: item.path(),
    }
}

/// Returns constants sorted by name, without duplicates.
fn by_name<'n>(ids: &[ConstId], name: impl Fn(ConstId) -> &'n str) -> Vec<(&'n str, ConstId)> {
    let mut list: Vec<(&str, ConstId)> = ids.iter().map(|id| (name(*id), *id)).collect();
    list.sort();
    list.dedup_by_key(|(name, _)| *name);
    list
}

fn constant(
    context: Context<'_>,
    options: &Options,
    id: ConstId,
    name: &str,
    includes: &mut Includes,
) -> Item {
    let module = context.module;
    let item = &module.consts[id.index()];
    includes.ty(context, &item.ty);
    let mut declarator = context.names.declarator(&item.ty, name);
    declarator.ty.insert_str(0, "const ");
    let mut words = item.words.as_slice();
    let leaves = module.leaves(&item.ty);
    let by_bits = |(ty, word): (&Type, &u64)| literal::is_by_bits(ty, *word);
    let hexadecimal = item.given.hexadecimal || leaves.iter().zip(&item.words).any(by_bits);
    let shared = context.names.shared_constant(id).is_some();
    let readers = if shared && is_in_header(item) { Readers::Cpp } else { Readers::C };
    let init = constant_init(context, &item.ty, (hexadecimal, readers), &mut words);
    if leaves.iter().zip(&item.words).any(|(ty, word)| literal::needs_math(ty, *word)) {
        includes.system.insert("math.h");
    }
    if leaves.iter().zip(&item.words).any(|(ty, word)| context.text(ty, *word).is_some()) {
        includes.own.insert(sizes::names_header(options));
    }
    let section = item.given.section.as_ref();
    Item::Constant {
        storage: Storage::Static,
        docs: docs(context, item),
        asked: section.map(|section| asked::section(section, options)),
        declarator,
        init: Some(init),
        origin: origin(item.span),
        path: item.path(),
    }
}

/// Returns a constant's comment, in which names of shared constants are replaced by their C names.
fn docs(context: Context<'_>, item: &Const) -> Vec<String> {
    let mut docs = described::constant(context.names, item);
    for (index, other) in context.module.consts.iter().enumerate() {
        if let Some(name) = context.names.shared_constant(ConstId(index as u32))
            && other.module == item.module
        {
            let (word, name) = (format!("`{}`", other.name), format!("`{name}`"));
            docs.iter_mut().for_each(|line| *line = line.replace(&word, &name));
        }
    }
    docs
}

/// Returns the initialiser of a constant. Its integers are all hexadecimal, or all decimal.
fn constant_init(
    context: Context<'_>,
    ty: &Type,
    spelling: (bool, Readers),
    words: &mut &[u64],
) -> Init {
    let list = |items: Vec<(Option<String>, Init)>, lines| Init::List { items, lines };
    match ty {
        Type::Struct(id) => {
            let names = &context.names.structs[id.index()].fields;
            let item = &context.module.structs[id.index()];
            let first = words.first().copied().unwrap_or_default();
            let mut items = Vec::new();
            for (index, (field, name)) in item.fields.iter().zip(names).enumerate() {
                let init = constant_init(context, &field.ty, spelling, words);
                if field.ty != Type::Unit && (!item.overlaid() || item.holds(index, first)) {
                    items.push((Some(name.clone()), init));
                }
            }
            list(items, Lines::Fill)
        }
        Type::Array { element, len } => {
            let items = (0..*len).map(|_| (None, constant_init(context, element, spelling, words)));
            list(items.collect(), Lines::Fill)
        }
        Type::Matrix { element, rows, cols } => {
            let element = Type::Scalar(*element);
            let items: Vec<_> = (0..rows * cols)
                .map(|_| constant_init(context, &element, spelling, words))
                .collect();
            let groups = *rows > 1 && *cols > 1;
            let lines = if groups { Lines::Groups(*rows as usize) } else { Lines::Fill };
            context.names.layout.list(&items, (*rows, *cols), lines)
        }
        _ => {
            let (word, rest) = words.split_first().expect("the validator counts words");
            *words = rest;
            let (hexadecimal, readers) = spelling;
            Init::Value(match (context.text(ty, *word), hexadecimal, ty.as_int()) {
                (Some((_, name)), ..) => Expr::name(name),
                (None, true, Some(int)) if !int.signed() => {
                    literal::hexadecimal(int, int.from_word(*word))
                }
                _ => literal::word(context.names, ty, *word, readers),
            })
        }
    }
}
