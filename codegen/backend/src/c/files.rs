//! Assigns items to files, and orders them.
//!
//! * A component has its own pair of files; the data, enums and functions of a Rust module share another.
//! * Types are in headers; functions in sources, with the prototypes of public ones in headers.
//! * A file has the order of the Rust source, except that types precede their uses; static functions are declared at
//!   the top instead of being moved.

mod about;
mod constants;
mod contracts;
mod copied;
mod draft;
mod includes;
mod inline;
mod kernel;
mod promises;

use std::collections::{BTreeMap, BTreeSet};

use bessemer_ir::{EnumId, Form, Function, FunctionId, Owner, Span, StructId, Type};

use super::analysis::{inline_callees, reachable};
use super::context::{Context, Uses};
use super::file::CFile;
use super::library::{self, is_mathematics};
use super::names::OVERLAY;
use super::options::Options;
use super::signature::Returned;
use super::tree::{Declarator, Head, Item, Member, Origin, Stmt, StmtKind, Storage, plain};
use super::{
    ascii, asked, described, helpers_header, init, lower, self_test, sizes, status_header, target,
    traced,
};
use crate::kernels;
use draft::Draft;
use includes::Includes;

/// Contents of one pair of files.
#[derive(Default)]
struct Unit {
    types: Vec<TypeId>,
    functions: Vec<Callable>,
    modules: BTreeSet<String>,
    component: Option<String>,
    kernel: bool,
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum TypeId {
    Struct(StructId),
    Enum(EnumId),
}

#[derive(Clone, Copy)]
enum Callable {
    Init(StructId),
    Function(FunctionId),
}

/// Returns all files, in the order of their names.
pub fn files(context: Context<'_>, options: &Options) -> Vec<CFile> {
    let (mut list, mut drafts) = (Vec::new(), Vec::new());
    let (mut helpers, mut consts) = (BTreeSet::new(), BTreeSet::new());
    let mut called = BTreeSet::new();
    for (name, unit) in units(context) {
        let writer = Writer { context, options, name, unit };
        drafts.push(writer.header());
        if writer.unit.functions.iter().any(|callable| writer.in_header(callable).is_none()) {
            let (source, mut uses) = writer.source();
            drafts.push(source);
            helpers.append(&mut uses.helpers);
            consts.append(&mut uses.consts);
            called.append(&mut uses.called);
        }
    }
    let (inline, mut uses) = inline::shared(context, options, &called);
    let computes = inline.is_some();
    drafts.extend(inline);
    let reports = |draft: &Draft| draft.includes.own.contains(&context.names.status.header);
    if context.faults.any() || drafts.iter().any(reports) {
        list.push(status_header::header(context, options));
    }
    list.extend(promises::write(context, options, &mut drafts));
    list.extend(drafts.into_iter().map(|draft| draft.print(context, options)));
    helpers.append(&mut uses.helpers);
    consts.append(&mut uses.consts);
    list.extend(helpers_header::header(context, options, &helpers));
    consts.extend(sizes::all(context.module));
    consts.extend(sizes::names(context.module));
    list.extend(constants::shared(context, options, &consts));
    if computes || list.iter().any(|file| file.name.ends_with(".c")) {
        list.push(target::header(context, options));
    }
    list.extend(self_test::files(context, options));
    list.sort_by(|a, b| a.name.cmp(&b.name));
    if options.trace_comments {
        list.iter_mut().for_each(traced::written);
    }
    if options.ascii {
        list.iter_mut().for_each(|file| file.text = ascii::written(&file.text));
    }
    list
}

fn units(context: Context<'_>) -> BTreeMap<String, Unit> {
    let (module, names) = (context.module, context.names);
    let mut units: BTreeMap<String, Unit> = BTreeMap::new();
    for (index, item) in module.structs.iter().enumerate() {
        let id = StructId(index as u32);
        let unit = units.entry(names.placing.struct_file(id).to_owned()).or_default();
        unit.types.push(TypeId::Struct(id));
        // Types of Rust's own come from nowhere.
        let own = item.span.line > 0 || item.initial.is_some();
        unit.modules.extend(own.then(|| item.module.clone()));
        if names.structs[index].init.is_some() {
            unit.functions.push(Callable::Init(id));
        }
        if item.initial.is_some() {
            unit.component = Some(item.name.clone());
        }
    }
    for (index, item) in module.enums.iter().enumerate() {
        let id = EnumId(index as u32);
        let unit = units.entry(names.placing.enum_file(id).to_owned()).or_default();
        unit.types.push(TypeId::Enum(id));
        unit.modules.insert(item.module.clone());
    }
    let reached = reached(context);
    // Without a function of the mathematics, its types serve nobody.
    let mut kept = module.functions.iter().zip(&names.functions).zip(&reached);
    let bare = names.has_library()
        && !kept.any(|((function, signature), reached)| {
            *reached && signature.storage != Storage::Library && is_mathematics(&function.module)
        });
    if bare {
        units.retain(|_, unit| {
            !unit.modules.iter().all(|name| is_mathematics(name)) || unit.modules.is_empty()
        });
    }
    for (index, item) in module.functions.iter().enumerate().filter(|(index, _)| reached[*index]) {
        let id = FunctionId(index as u32);
        if matches!(
            names.signature(id).storage,
            Storage::Inline | Storage::OwnInline | Storage::Foreign | Storage::Library
        ) {
            continue;
        }
        let unit = units.entry(names.placing.function_file(id).to_owned()).or_default();
        unit.functions.push(Callable::Function(id));
        unit.kernel |= item.kernel.is_some();
        unit.modules.insert(item.module.clone());
    }
    for unit in units.values_mut() {
        // Instances of something generic share their place in the source: then by name.
        unit.types.sort_by_cached_key(|id| {
            let name = match id {
                TypeId::Struct(id) => &names.structs[id.index()].ty,
                TypeId::Enum(id) => &names.enums[id.index()].ty,
            };
            (place(context, type_span(context, *id)), name)
        });
        unit.functions.sort_by_cached_key(|callable| match callable {
            Callable::Init(id) => {
                let name = &names.structs[id.index()].base;
                (place(context, type_span(context, TypeId::Struct(*id))), name)
            }
            Callable::Function(id) => {
                (place(context, module.functions[id.index()].span), &names.signature(*id).name)
            }
        });
    }
    units
}

/// Returns true for each function that a file defines or a library provides. Annotated functions are always included,
/// except private inline ones; elementary functions only if they are called.
pub fn reached(context: Context<'_>) -> Vec<bool> {
    let (module, names) = (context.module, context.names);
    let storage = |id: FunctionId| names.signature(id).storage;
    let is_root = |id: FunctionId| {
        let spare = names.has_library() && is_mathematics(&module.functions[id.index()].module);
        (storage(id) == Storage::Extern || inline::is_for_firmware(context, id)) && !spare
    };
    let is_library = |id| storage(id) == Storage::Library || !names.signature(id).parts.is_empty();
    reachable(module, is_root, is_library)
}

fn place(context: Context<'_>, span: Span) -> (String, u32, u32) {
    let file = context.module.files.get(span.file as usize).cloned().unwrap_or_default();
    (file, span.line, span.column)
}

fn type_span(context: Context<'_>, id: TypeId) -> Span {
    match id {
        TypeId::Struct(id) => context.module.structs[id.index()].span,
        TypeId::Enum(id) => context.module.enums[id.index()].span,
    }
}

fn origin(span: Span) -> Origin {
    Origin { file: span.file, line: span.line }
}

/// Returns the Rust path of a function, such as `models::attitude::Height::step`.
fn rust_path(context: Context<'_>, function: &Function) -> String {
    let owner = match function.owner {
        Some(Owner::Struct(id)) => format!("{}::", context.module.structs[id.index()].name),
        Some(Owner::Enum(id)) => format!("{}::", context.module.enums[id.index()].name),
        None => String::new(),
    };
    format!("{}::{owner}{}", function.module, function.name)
}

struct Writer<'a> {
    context: Context<'a>,
    options: &'a Options,
    name: String,
    unit: Unit,
}

impl Writer<'_> {
    fn summary(&self) -> String {
        match &self.unit.component {
            Some(component) => format!("the component {component}."),
            None if self.unit.kernel => "a kernel of linear algebra.".to_owned(),
            None if self.unit.functions.is_empty() => "types.".to_owned(),
            None if self.unit.types.is_empty() => "functions.".to_owned(),
            None => "types and functions.".to_owned(),
        }
    }

    fn header(&self) -> Draft {
        let mut items = Vec::new();
        let mut includes = Includes::default();
        let mut done = Vec::new();
        for id in &self.unit.types {
            self.type_item(*id, &mut done, &mut items, &mut includes);
        }
        for callable in &self.unit.functions {
            match callable {
                Callable::Init(id) => items.push(Item::Prototype {
                    docs: init::docs(self.context, *id),
                    head: init::head(self.context, *id),
                    origin: origin(self.context.module.structs[id.index()].span),
                    function: String::new(),
                }),
                Callable::Function(id) => {
                    let signature = self.context.names.signature(*id);
                    if let Some(kernel) = self.in_header(callable) {
                        includes.signature(self.context, self.options, signature);
                        items.extend(self.inline_kernel(kernel, *id, &mut includes));
                    } else if signature.storage == Storage::Extern {
                        includes.signature(self.context, self.options, signature);
                        items.push(self.prototype(*id, true));
                    }
                }
            }
        }
        self.draft("h", items, includes)
    }

    /// Returns the source file, and what it requires of the shared files.
    fn source(&self) -> (Draft, Uses) {
        let (module, names) = (self.context.module, self.context.names);
        let mut uses = Uses { file: self.options.header(&self.name), ..Uses::default() };
        let mut includes = Includes::default();
        let mut definitions = Vec::new();
        let mut prototypes = Vec::new();
        let mut written = Vec::new();
        let mut asked = BTreeSet::new();
        let callables: Vec<Callable> =
            self.inline().chain(self.unit.functions.iter().copied()).collect();
        for (at, callable) in callers_first(&callables) {
            let id = match callable {
                Callable::Init(id) => {
                    definitions.push((at, init::item(self.context, id, &mut uses)));
                    continue;
                }
                Callable::Function(id) => id,
            };
            let function = &module.functions[id.index()];
            let signature = names.signature(id);
            // The branch that calls it may have been removed.
            let is_own = matches!(signature.storage, Storage::Static | Storage::OwnInline);
            if is_own && !uses.called.contains(&id) {
                continue;
            }
            if let Some(kernel) = &function.kernel {
                let items = self.kernel(kernel, id, &mut uses);
                definitions.extend(items.into_iter().map(|item| (at, item)));
                continue;
            }
            if signature.storage == Storage::Static {
                prototypes.push((at, self.prototype(id, false)));
            }
            definitions.push((at, self.definition(id, &mut uses, &mut includes, &mut asked)));
            written.push(id);
        }
        let copies = self.copies(written, &mut uses, &mut includes);
        let mut items: Vec<Item> = Vec::new();
        asked.extend(uses.unroll.then_some(asked::Macro::Unroll));
        let constants = self.constants(&uses.consts, &mut includes);
        let placed = |it: &Item| matches!(it, Item::Constant { asked: Some(_), .. });
        asked.extend(constants.iter().any(placed).then_some(asked::Macro::Section));
        items.extend(asked.iter().map(|asked| Item::Verbatim(asked.text(self.options))));
        items.extend(constants);
        prototypes.sort_by_key(|(at, _)| *at);
        definitions.sort_by_key(|(at, _)| *at);
        items.extend(prototypes.into_iter().map(|(_, item)| item));
        items.extend(copies);
        items.extend(definitions.into_iter().map(|(_, item)| item));
        includes.uses(self.context, self.options, &mut uses);
        (self.draft("c", items, includes), uses)
    }

    /// Returns the definition of a function, and records its requirements.
    fn definition(
        &self,
        id: FunctionId,
        uses: &mut Uses,
        includes: &mut Includes,
        asked: &mut BTreeSet<asked::Macro>,
    ) -> Item {
        let names = self.context.names;
        let (function, signature) =
            (&self.context.module.functions[id.index()], names.signature(id));
        match signature.storage {
            Storage::Extern | Storage::Foreign | Storage::Library => {}
            Storage::Static => {
                signature.params.iter().for_each(|it| includes.sizes(self.options, &it.sizes));
            }
            Storage::Inline | Storage::OwnInline => {
                includes.signature(self.context, self.options, signature);
            }
        }
        if signature.returned == Returned::Status {
            includes.own.insert(names.status.header.clone());
        }
        let mut body = match signature.parts {
            [] => lower::function(self.context, id, uses).body,
            parts => {
                uses.system.insert("math.h");
                library::body(signature, parts)
            }
        };
        let mut head = names.head(signature);
        for (wanted, text) in asked::of(&function.attributes, self.options) {
            asked.insert(wanted);
            head.asked.push(text);
        }
        if let Some((fast, name)) = library::instruction(function) {
            uses.system.insert("math.h");
            body = by_instruction(fast, name, &head, body);
        }
        let declared = signature.storage == Storage::Extern;
        let docs = || described::function(self.context.module, names, function, signature);
        Item::Function {
            docs: if declared { Vec::new() } else { docs() },
            head,
            body,
            origin: origin(function.span),
            function: rust_path(self.context, function),
        }
    }

    /// Returns the inline functions that only this file has, callees first.
    fn inline(&self) -> impl Iterator<Item = Callable> {
        let own = self.unit.functions.iter().filter_map(|callable| match callable {
            Callable::Function(id) => Some(*id),
            Callable::Init(_) => None,
        });
        let is_inline = |id| self.context.names.signature(id).storage == Storage::OwnInline;
        inline_callees(self.context.module, own, is_inline).into_iter().map(Callable::Function)
    }

    fn prototype(&self, id: FunctionId, documented: bool) -> Item {
        let function = &self.context.module.functions[id.index()];
        let docs = || {
            let mut docs = described::function(
                self.context.module,
                self.context.names,
                function,
                self.context.names.signature(id),
            );
            if let Some(kernel) = &function.kernel
                && kernels::is_fast(kernel, &self.options.kernels)
            {
                docs.push(
                    "In the fast mode the order is free; the error, element by element:".into(),
                );
                docs.push(format!("{}.", kernels::fast::bound(kernel)));
            }
            docs
        };
        Item::Prototype {
            docs: if documented { docs() } else { Vec::new() },
            head: self.context.names.head(self.context.names.signature(id)),
            origin: origin(function.span),
            function: rust_path(self.context, function),
        }
    }

    /// Adds a type, after the types of this file that it contains.
    fn type_item(
        &self,
        id: TypeId,
        done: &mut Vec<TypeId>,
        items: &mut Vec<Item>,
        includes: &mut Includes,
    ) {
        if done.contains(&id) {
            return;
        }
        done.push(id);
        let (module, names) = (self.context.module, self.context.names);
        match id {
            TypeId::Enum(id) => {
                let item = &module.enums[id.index()];
                let names = &names.enums[id.index()];
                items.push(Item::Enum {
                    docs: item.docs.clone(),
                    name: names.ty.clone(),
                    variants: (item.variants.iter().zip(&names.variants))
                        .map(|(it, name)| (it.docs.clone(), name.clone(), it.value))
                        .collect(),
                    origin: origin(item.span),
                });
            }
            TypeId::Struct(id) => {
                let item = &module.structs[id.index()];
                for field in &item.fields {
                    includes.ty(self.context, &field.ty);
                    if let Some(needed) = named(&field.ty)
                        && self.unit.types.contains(&needed)
                    {
                        self.type_item(needed, done, items, includes);
                    }
                }
                if names.structs[id.index()].named {
                    items.push(self.struct_item(id, includes));
                }
            }
        }
    }

    fn struct_item(&self, id: StructId, includes: &mut Includes) -> Item {
        let item = &self.context.module.structs[id.index()];
        Item::Struct {
            shared: item.form == Form::Shared,
            docs: item.docs.clone(),
            name: self.context.names.structs[id.index()].ty.clone(),
            fields: self.members(id, includes),
            origin: origin(item.span),
        }
    }

    fn members(&self, id: StructId, includes: &mut Includes) -> Vec<Member> {
        let item = &self.context.module.structs[id.index()];
        let names = &self.context.names.structs[id.index()];
        let held =
            item.fields.iter().zip(&names.fields).filter(|(field, _)| field.ty != Type::Unit);
        let mut fields: Vec<Member> = held
            .map(|(field, name)| {
                if let Some(inside) = self.inside(&field.ty) {
                    return Member::Inside {
                        docs: self.context.module.structs[inside.index()].docs.clone(),
                        shared: false,
                        fields: self.members(inside, includes),
                        name: name.clone(),
                    };
                }
                let given = &field.given;
                let docs = described::field(self.context.names, &field.docs, given, &field.ty);
                let sizes = sizes::sizes(self.context.module, &field.given);
                includes.sizes(self.options, &sizes);
                Member::Field(docs, self.context.names.sized(&field.ty, name, &sizes))
            })
            .collect();
        if let Some(fault) = &names.fault {
            let status = &self.context.names.status;
            includes.own.insert(status.header.clone());
            let docs =
                format!("The fault that stopped the component; {} while it runs.", status.ok);
            let field = Declarator {
                ty: status.ty.clone(),
                name: fault.clone(),
                dimensions: String::new(),
            };
            fields.push(Member::Field(vec![docs], field));
        }
        if item.overlaid() {
            // Of those that share their memory, the names say so.
            let mut overlaid = fields.split_off(1);
            for member in &mut overlaid {
                if let Member::Field(_, field) = member {
                    field.name = field.name.replacen(OVERLAY, "", 1);
                }
            }
            fields.push(Member::Inside {
                docs: vec!["What it holds.".to_owned()],
                shared: true,
                fields: overlaid,
                name: OVERLAY.trim_end_matches('.').to_owned(),
            });
        }
        fields
    }

    /// Returns the struct that is declared inside the struct with this field.
    fn inside(&self, ty: &Type) -> Option<StructId> {
        match ty {
            Type::Struct(id) if !self.context.names.structs[id.index()].named => Some(*id),
            _ => None,
        }
    }

    fn draft(&self, extension: &str, items: Vec<Item>, includes: Includes) -> Draft {
        let header = self.options.header(&self.name);
        let is_header = extension == "h";
        let source: Vec<&str> = match self.unit.kernel {
            true => vec!["its kernels"],
            false => self.unit.modules.iter().map(String::as_str).collect(),
        };
        Draft {
            name: if is_header { header.clone() } else { format!("{}.c", self.name) },
            header,
            summary: self.summary(),
            about: self.about(extension).to_vec(),
            source: if source.is_empty() {
                self.context.module.name.clone()
            } else {
                source.join(", ")
            },
            public: true,
            computes: is_header
                && self.unit.functions.iter().any(|it| self.in_header(it).is_some()),
            items,
            includes,
        }
    }
}

/// Returns the struct or enum in a type, if there is one.
fn named(ty: &Type) -> Option<TypeId> {
    match ty {
        Type::Struct(id) => Some(TypeId::Struct(*id)),
        Type::Enum(id) => Some(TypeId::Enum(*id)),
        Type::Array { element, .. } | Type::Slice(element) => named(element),
        _ => None,
    }
}

/// Returns a body that uses the processor's instruction if there is one. gcc's own macro is tested, too, since
/// newlib's `math.h` lacks C99's.
fn by_instruction(fast: &str, name: &str, head: &Head, body: Vec<Stmt>) -> Vec<Stmt> {
    let arguments: Vec<&str> = head.params.iter().map(|param| param.name.as_str()).collect();
    let direct = format!(
        "#if defined({fast}) || defined(__{fast})\nreturn {name}({});\n#else",
        arguments.join(", ")
    );
    let direct = plain(StmtKind::Verbatim(direct));
    let end = plain(StmtKind::Verbatim("#endif".into()));
    [vec![direct], body, vec![end]].concat()
}

/// Returns the functions with their indices, in an order in which callers precede callees.
fn callers_first(callables: &[Callable]) -> Vec<(usize, Callable)> {
    let mut list: Vec<(usize, Callable)> = callables.iter().copied().enumerate().collect();
    // Callees precede callers in the module.
    list.sort_by_key(|(_, callable)| match callable {
        Callable::Init(_) => None,
        Callable::Function(id) => Some(std::cmp::Reverse(id.index())),
    });
    list
}
