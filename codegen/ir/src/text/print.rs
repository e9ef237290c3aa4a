//! Prints the items of a module.
//!
//! Invariant: a name is printed without a handle only if the parser, which has read only the text above, finds
//! exactly this item by it.

use alloc::collections::BTreeMap;
use alloc::format;
use alloc::string::{String, ToString};
use alloc::vec::Vec;
use core::fmt::Write;

use crate::attributes::{Attributes, Given, Inlining};
use crate::ir::{
    ConstId, EnumId, Field, Form, Function, FunctionId, LocalId, Mode, Module, Owner, Role, Span,
    Struct, StructId, Type, Variant,
};
use crate::number::{Float, Scalar};

use crate::written::Written;

use super::names::shown;
use super::scope::Scope;

/// Returns the text form of a module.
pub fn print(module: &Module) -> String {
    let mut printer = Printer::new(module);
    printer.module();
    printer.out
}

/// A struct or an enum; both share one namespace.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum TypeId {
    Struct(StructId),
    Enum(EnumId),
}

/// Number of definitions with each name.
struct Uses<'m> {
    types: BTreeMap<&'m str, u32>,
    consts: BTreeMap<&'m str, u32>,
    functions: BTreeMap<(Option<TypeId>, &'m str), u32>,
}

pub(super) struct Printer<'m> {
    pub out: String,
    pub module: &'m Module,
    pub indent: usize,
    uses: Uses<'m>,
    structs_above: usize,
    pub functions_above: usize,
    pub locals: LocalsAbove<'m>,
}

/// Locals of the function that is being printed.
#[derive(Default)]
pub(super) struct LocalsAbove<'m> {
    pub function: Option<&'m Function>,
    pub uses: BTreeMap<&'m str, u32>,
    pub declared: Vec<bool>,
    /// Number of the next declaration, unless it states one.
    pub next: u32,
}

pub(super) fn owner_id(owner: Owner) -> TypeId {
    match owner {
        Owner::Struct(id) => TypeId::Struct(id),
        Owner::Enum(id) => TypeId::Enum(id),
    }
}

impl<'m> Printer<'m> {
    fn new(module: &'m Module) -> Self {
        let mut uses =
            Uses { types: BTreeMap::new(), consts: BTreeMap::new(), functions: BTreeMap::new() };
        let structs = module.structs.iter().map(|definition| definition.name.as_str());
        for name in structs.chain(module.enums.iter().map(|definition| definition.name.as_str())) {
            *uses.types.entry(name).or_default() += 1;
        }
        for definition in &module.consts {
            *uses.consts.entry(&definition.name).or_default() += 1;
        }
        for function in &module.functions {
            let key = (function.owner.map(owner_id), function.name.as_str());
            *uses.functions.entry(key).or_default() += 1;
        }
        Printer {
            out: String::new(),
            module,
            indent: 0,
            uses,
            structs_above: 0,
            functions_above: 0,
            locals: LocalsAbove::default(),
        }
    }

    pub fn scope(&self) -> Scope<'m> {
        Scope { module: self.module, functions: self.functions_above }
    }

    /// Appends formatted text.
    pub fn put(&mut self, text: core::fmt::Arguments<'_>) {
        // Writing to a string cannot fail.
        let _ = self.out.write_fmt(text);
    }

    /// Starts a line.
    pub fn line(&mut self) {
        if !self.out.is_empty() && !self.out.ends_with('\n') {
            self.out.push('\n');
        }
        for _ in 0..self.indent {
            self.out.push_str("  ");
        }
    }

    /// Prints a doc or comment line.
    pub fn remarks(&mut self, slashes: &str, lines: &[String]) {
        for text in lines {
            self.line();
            let plain = !text.chars().any(|next| next != '\t' && next.is_control());
            match text.as_str() {
                "" => self.out.push_str(slashes),
                _ if plain => self.put(format_args!("{slashes} {text}")),
                _ => self.put(format_args!("{slashes}{text:?}")),
            }
            self.out.push('\n');
        }
    }

    fn module(&mut self) {
        let module = self.module;
        self.put(format_args!("module {}\n", shown(&module.name)));
        for file in &module.files {
            self.remarks("///", module.about.get(file).map_or(&[][..], Vec::as_slice));
            self.put(format_args!("file {file:?}\n"));
        }
        for ((span, word), written) in &module.written {
            let place = relative(*span, Span::default(), Span::default());
            let gap = if place.is_empty() { "" } else { " " };
            let spelling = match written {
                Written::Hexadecimal => "hexadecimal".to_string(),
                Written::Constant(ConstId(id)) => format!("constant {id}"),
                Written::Variant(EnumId(id), at) => format!("variant {id} {at}"),
            };
            self.put(format_args!("{place}{gap}{spelling} {word}\n"));
        }
        for definition in &module.enums {
            let head = ("enum", definition.name.as_str(), definition.module.as_str());
            self.head(&definition.docs, definition.span, head);
            self.put(format_args!("{} {{\n", shown_given(&definition.given)));
            self.variants(&definition.variants);
            self.out.push_str("}\n");
        }
        for (index, definition) in module.structs.iter().enumerate() {
            self.structs_above = index;
            self.structure(definition);
        }
        self.structs_above = module.structs.len();
        if !module.consts.is_empty() {
            self.out.push('\n');
        }
        for definition in &module.consts {
            self.remarks("///", &definition.docs);
            let place = relative(definition.span, Span::default(), Span::default());
            let gap = if place.is_empty() { "" } else { " " };
            let (name, home) = (shown(&definition.name), home(&definition.module));
            let (ty, given) = (self.ty(&definition.ty), shown_given(&definition.given));
            self.put(format_args!("{place}{gap}const {name}{home}: {ty}{given} = "));
            self.words(&definition.words, &definition.ty);
            self.out.push('\n');
        }
        for (index, function) in module.functions.iter().enumerate() {
            self.functions_above = index;
            self.function(function);
        }
    }

    /// Prints docs, span, and `keyword name in module` of an item.
    fn head(&mut self, docs: &[String], span: Span, (keyword, name, module): (&str, &str, &str)) {
        self.out.push('\n');
        self.remarks("///", docs);
        let place = relative(span, Span::default(), Span::default());
        let gap = if place.is_empty() { "" } else { " " };
        self.put(format_args!("{place}{gap}{keyword} {}{}", shown(name), home(module)));
    }

    fn variants(&mut self, variants: &[Variant]) {
        self.indent = 1;
        for (index, variant) in variants.iter().enumerate() {
            self.remarks("///", &variant.docs);
            self.line();
            self.put(format_args!("{}", shown(&variant.name)));
            if variant.value != index as i32 {
                self.put(format_args!(" = {}", variant.value));
            }
            self.put(format_args!("{},\n", shown_given(&variant.given)));
        }
        self.indent = 0;
    }

    fn structure(&mut self, definition: &Struct) {
        let head = ("struct", definition.name.as_str(), definition.module.as_str());
        self.head(&definition.docs, definition.span, head);
        match &definition.form {
            Form::Record => {}
            Form::Choice(chosen) => {
                let chosen = chosen.iter().map(|field| match field {
                    Some(field) => format!("{field}"),
                    None => String::from("-"),
                });
                self.put(format_args!(" choice({})", chosen.collect::<Vec<_>>().join(", ")));
            }
            Form::Sequence => self.out.push_str(" sequence"),
            Form::Lent => self.out.push_str(" lent"),
            Form::Shared => self.out.push_str(" shared"),
        }
        self.put(format_args!("{} {{\n", shown_given(&definition.given)));
        self.indent = 1;
        for Field { name, docs, ty, given } in &definition.fields {
            self.remarks("///", docs);
            self.line();
            self.put(format_args!("{}: {}{},\n", shown(name), self.ty(ty), shown_given(given)));
        }
        self.indent = 0;
        self.out.push('}');
        if let Some(initial) = &definition.initial {
            self.out.push_str(" = ");
            self.state(definition, initial);
        }
        if let Some(defaults) = &definition.defaults {
            self.out.push_str(" default ");
            self.state(definition, defaults);
        }
        self.out.push('\n');
    }

    /// Prints the words of a struct's value.
    fn state(&mut self, definition: &Struct, words: &[u64]) {
        let mut leaves = Vec::new();
        for field in &definition.fields {
            self.leaves(&field.ty, self.structs_above, words.len(), &mut leaves);
        }
        self.word_list(words, &leaves);
    }

    fn function(&mut self, function: &'m Function) {
        self.locals = LocalsAbove { function: Some(function), ..LocalsAbove::default() };
        self.locals.declared = alloc::vec![false; function.locals.len()];
        for local in &function.locals {
            *self.locals.uses.entry(&local.name).or_default() += 1;
        }
        let keyword = match function.role {
            Role::Entry { infallible: true } => "entry infallible ",
            Role::Entry { infallible: false } => "entry ",
            Role::Public => "",
            Role::Private => "private ",
            Role::Inline { public: true } => "inline ",
            Role::Inline { public: false } => "private inline ",
        };
        let place = relative(function.span, Span::default(), Span::default());
        self.out.push('\n');
        self.remarks("///", &function.docs);
        if !place.is_empty() {
            self.put(format_args!("{place} "));
        }
        let owner = function
            .owner
            .map_or(String::new(), |owner| format!("{}::", self.type_name(owner_id(owner))));
        let name = shown(&function.name);
        let attributes = shown_attributes(&function.attributes);
        self.put(format_args!("{keyword}{attributes}fn {owner}{name}{}(", home(&function.module)));
        let params = (function.params as usize).min(function.locals.len());
        for index in 0..params {
            if index > 0 {
                self.out.push_str(", ");
            }
            self.declare(LocalId(index as u32), function.span);
        }
        self.out.push(')');
        if function.result != Type::Unit || !function.result_name.is_empty() {
            self.put(format_args!(" -> {}", self.ty(&function.result)));
        }
        if !function.result_name.is_empty() {
            self.put(format_args!(" as {}", shown(&function.result_name)));
        }
        if let Some(kernel) = &function.kernel {
            let element = Scalar::Float(kernel.element).name();
            self.put(format_args!(" = kernel {}<{element}", kernel.routine.name()));
            for dim in &kernel.dims {
                self.put(format_args!(", {dim}"));
            }
            self.out.push('>');
        }
        self.body(function);
        self.out.push('\n');
    }

    /// Prints `name: type@span`, with the handle if the name or the number does not follow.
    pub fn declare(&mut self, id: LocalId, base: Span) {
        let Some(function) = self.locals.function else { return };
        let local = function.local(id);
        if id.0 != self.locals.next || self.locals.uses.get(local.name.as_str()) != Some(&1) {
            self.put(format_args!("%{}.", id.0));
        }
        let mode = match local.mode {
            Mode::Value => "",
            Mode::Ref => "&",
            Mode::RefMut => "&mut ",
        };
        let (name, ty) = (shown(&local.name), self.ty(&local.ty));
        self.put(format_args!("{name}: {mode}{ty}{}", relative(local.span, base, base)));
        self.locals.declared[id.index()] = true;
        self.locals.next = id.0.wrapping_add(1);
    }

    /// Returns a type as text.
    pub fn ty(&self, ty: &Type) -> String {
        match ty {
            Type::Unit => "unit".to_string(),
            Type::Scalar(scalar) => scalar.name().to_string(),
            Type::Array { element, len } => format!("[{}; {len}]", self.ty(element)),
            Type::Matrix { element, rows, cols } => {
                format!("matrix<{}, {rows}, {cols}>", element.name())
            }
            Type::Struct(id) => self.type_name(TypeId::Struct(*id)),
            Type::Enum(id) => self.type_name(TypeId::Enum(*id)),
            Type::Slice(element) => format!("[{}]", self.ty(element)),
        }
    }

    /// Returns the name of a struct or an enum.
    pub fn type_name(&self, id: TypeId) -> String {
        let (keyword, index, name, above) = match id {
            TypeId::Struct(id) => {
                let definition = self.module.structs.get(id.index());
                let name = definition.map(|found| found.name.as_str());
                ("struct", id.0, name, id.index() < self.structs_above)
            }
            TypeId::Enum(id) => {
                let definition = self.module.enums.get(id.index());
                ("enum", id.0, definition.map(|found| found.name.as_str()), true)
            }
        };
        let unique = name.is_some_and(|name| self.uses.types.get(name) == Some(&1));
        bare_or_handle(&format!("{keyword}#"), index, name, unique && above)
    }

    /// Returns the name of a function in a call.
    pub fn function_name(&self, id: FunctionId) -> String {
        let found = self.module.functions.get(id.index());
        let Some(function) = found.filter(|_| id.index() < self.functions_above) else {
            return bare_or_handle("#", id.0, found.map(|function| function.name.as_str()), false);
        };
        let owner = function.owner.map(owner_id);
        let unique = self.uses.functions.get(&(owner, function.name.as_str())) == Some(&1);
        let path = owner.map(|owner| self.type_name(owner));
        match path {
            Some(path) if unique && !path.contains('#') => {
                format!("{path}::{}", shown(&function.name))
            }
            None if unique => shown(&function.name),
            _ => bare_or_handle("#", id.0, Some(&function.name), false),
        }
    }

    /// Returns the name of a constant in an expression; locals have priority.
    pub fn const_name(&self, id: ConstId) -> String {
        let name = self.module.consts.get(id.index()).map(|found| found.name.as_str());
        let unique = name.is_some_and(|name| {
            self.uses.consts.get(name) == Some(&1) && !self.locals.uses.contains_key(name)
        });
        bare_or_handle("const#", id.0, name, unique)
    }

    /// Returns the name of a local in a statement or a place.
    pub fn local_name(&self, id: LocalId) -> String {
        let locals = self.locals.function.map_or(&[][..], |function| &function.locals);
        let name = locals.get(id.index()).map(|local| local.name.as_str());
        let unique = name.is_some_and(|name| self.locals.uses.get(name) == Some(&1));
        let declared = self.locals.declared.get(id.index()) == Some(&true);
        bare_or_handle("%", id.0, name, unique && declared)
    }

    /// Prints the words of a constant.
    fn words(&mut self, words: &[u64], ty: &Type) {
        let mut leaves = Vec::new();
        self.leaves(ty, self.structs_above, words.len(), &mut leaves);
        match (words, leaves.as_slice()) {
            (&[word], &[scalar]) if !ty.is_aggregate() => {
                self.out.push_str(&shown_word(word, scalar))
            }
            _ => self.word_list(words, &leaves),
        }
    }

    /// Collects the first `wanted` scalars of a value; structs from index `above` on count as empty.
    fn leaves(&self, ty: &Type, above: usize, wanted: usize, leaves: &mut Vec<Option<Scalar>>) {
        let mut repeat = |count: usize, scalar| {
            leaves.resize(leaves.len().saturating_add(count).min(wanted), scalar);
        };
        match ty {
            Type::Unit | Type::Slice(_) => {}
            Type::Scalar(scalar) => repeat(1, Some(*scalar)),
            Type::Enum(_) => repeat(1, None),
            Type::Matrix { element, rows, cols } => {
                repeat((*rows as usize).saturating_mul(*cols as usize), Some(*element));
            }
            Type::Array { element, len } => {
                for _ in 0..*len {
                    let before = leaves.len();
                    self.leaves(element, above, wanted, leaves);
                    if leaves.len() == before || leaves.len() >= wanted {
                        break;
                    }
                }
            }
            Type::Struct(id) if id.index() < above => {
                for field in &self.module.structs[id.index()].fields {
                    self.leaves(&field.ty, id.index(), wanted, leaves);
                }
            }
            Type::Struct(_) => {}
        }
    }

    fn word_list(&mut self, words: &[u64], leaves: &[Option<Scalar>]) {
        self.out.push('[');
        let shown = words
            .iter()
            .enumerate()
            .map(|(index, word)| shown_word(*word, leaves.get(index).copied().flatten()));
        let shown: Vec<String> = shown.collect();
        let mut rest = shown.as_slice();
        while let Some(first) = rest.first() {
            let same =
                rest.iter().take(super::parse::LONGEST_RUN).take_while(|word| *word == first);
            let run = same.count();
            let gap = if rest.len() == shown.len() { "" } else { ", " };
            if run >= 4 {
                self.put(format_args!("{gap}{first} * {run}"));
                rest = &rest[run..];
            } else {
                self.put(format_args!("{gap}{first}"));
                rest = &rest[1..];
            }
        }
        self.out.push(']');
    }
}

/// Returns ` in module`, or nothing for an empty path.
fn home(module: &str) -> String {
    let parts: Vec<&str> = module.split("::").collect();
    if module.is_empty() {
        String::new()
    } else if parts.iter().all(|part| shown(part) == *part) {
        format!(" in {module}")
    } else {
        format!(" in {module:?}")
    }
}

fn bare_or_handle(sigil: &str, index: u32, name: Option<&str>, bare: bool) -> String {
    match name {
        Some(name) if bare => shown(name),
        Some(name) => format!("{sigil}{index}.{}", shown(name)),
        None => format!("{sigil}{index}._"),
    }
}

/// Returns ` @…`: nothing if `span` equals `default`, else its differences from `base`.
pub(super) fn relative(span: Span, default: Span, base: Span) -> String {
    let Span { file, line, column } = span;
    if span == default {
        String::new()
    } else if file != base.file {
        format!("@{file}:{line}:{column}")
    } else if line != base.line {
        format!("@{line}:{column}")
    } else {
        format!("@{column}")
    }
}

/// Returns attributes as text, such as `#name "servo_set" #never_inline `.
fn shown_attributes(attributes: &Attributes) -> String {
    let mut text = String::new();
    let named = [
        ("name", &attributes.name),
        ("section", &attributes.section),
        ("external", &attributes.external),
    ];
    for (name, value) in named {
        if let Some(value) = value {
            text.push_str(&format!("#{name} {value:?} "));
        }
    }
    text.push_str(match attributes.inlining {
        Inlining::Free => "",
        Inlining::Never => "#never_inline ",
        Inlining::Always => "#always_inline ",
    });
    text.push_str(if attributes.atomic { "#atomic " } else { "" });
    text.push_str(if attributes.single { "#single " } else { "" });
    for (name, given) in &attributes.parameters {
        text.push_str(&format!("#parameter {name:?}{} ", shown_given(given)));
    }
    if attributes.result != Given::default() {
        text.push_str(&format!("#result{} ", shown_given(&attributes.result)));
    }
    text
}

/// Returns an item's attributes as text, such as ` (name "x", unit "m/s")`, or nothing.
fn shown_given(item: &Given) -> String {
    if *item == Given::default() {
        return String::new();
    }
    let said = [
        ("name", &item.name),
        ("measured", &item.unit),
        ("section", &item.section),
        ("expression", &item.expression),
    ];
    let said =
        said.iter().filter_map(|(word, text)| Some(format!("{word} {:?} ", (*text).as_ref()?)));
    let said: String = said.collect();
    let range = item.range.map(|it| format!("range \"{:?}\" \"{:?}\" ", it.low(), it.high()));
    let range = range.unwrap_or_default();
    let beyond = item.range.and_then(|it| it.enforced()).map(|word| format!("{word} "));
    let range = range + &beyond.unwrap_or_default();
    let public = if item.public { "public " } else { "" };
    let radix = if item.hexadecimal { "hexadecimal " } else { "" };
    let fallback = if item.fallback { "fallback " } else { "" };
    let sizes: String = item.sizes.iter().map(|size| format!("size {size:?} ")).collect();
    let axes: String = item.axes.iter().map(|axis| format!("axis {axis:?} ")).collect();
    format!(
        " #({said}{range}{axes}{public}{radix}{fallback}{sizes}@{}:{})",
        item.site.0, item.site.1
    )
}

/// Returns a word of a constant, in a readable form if that reads back to the same bits.
fn shown_word(word: u64, scalar: Option<Scalar>) -> String {
    let readable = match scalar {
        Some(Scalar::Bool) if word <= 1 => Some((word == 1).to_string()),
        Some(Scalar::Int(int)) if int.signed() => Some((word as i64).to_string()),
        Some(Scalar::Float(float)) => shown_float(word, float),
        Some(Scalar::Int(_)) | None => Some(word.to_string()),
        Some(Scalar::Bool) => None,
    };
    readable.unwrap_or_else(|| format!("{word:#x}"))
}

/// Returns a float in decimal with its suffix; none if it is infinite or NaN.
pub(super) fn shown_float(word: u64, float: Float) -> Option<String> {
    match float {
        Float::F64 => {
            let value = f64::from_bits(word);
            value.is_finite().then(|| format!("{value:?}"))
        }
        Float::F32 => {
            let value = f32::from_bits(u32::try_from(word).ok()?);
            value.is_finite().then(|| format!("{value:?}f32"))
        }
    }
}
