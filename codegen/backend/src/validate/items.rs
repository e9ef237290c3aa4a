//! Checks of types, constants and signatures.

use std::collections::BTreeSet;

use bessemer_ir::text::MAX_NESTING;
use bessemer_ir::words::words_fit;
use bessemer_ir::{
    ConstId, EnumId, Form, Function, FunctionId, Kernel, Local, LocalId, Mode, Module, Owner, Span,
    Struct, StructId, Type,
};

use super::problem::{Error, Problem, Subject};

/// Largest number of words in a value (128 MiB in the interpreter).
pub const MAX_WORDS: u64 = 1 << 24;

/// Numbers of words of types, with their checks.
pub(super) struct Sizes<'m> {
    module: &'m Module,
    /// Numbers of words of the structs checked so far.
    structs: Vec<u64>,
}

impl Sizes<'_> {
    /// Returns the number of words of a type, if it is valid.
    pub fn of(&self, ty: &Type) -> Result<u64, Problem> {
        self.size(ty, 0)
    }

    fn size(&self, ty: &Type, depth: u32) -> Result<u64, Problem> {
        if depth > MAX_NESTING {
            return Err(Problem::NestedTooDeep);
        }
        let size = match ty {
            Type::Unit => return Err(Problem::UnitValue),
            // Parameters are looked at as such.
            Type::Slice(_) => return Err(Problem::Slice),
            Type::Scalar(_) => 1,
            Type::Enum(id) if id.index() < self.module.enums.len() => 1,
            Type::Enum(id) => return Err(Problem::UnknownEnum(*id)),
            Type::Array { element, len } => {
                self.size(element, depth + 1)?.saturating_mul(u64::from(*len))
            }
            Type::Matrix { rows, cols, .. } => u64::from(*rows).saturating_mul(u64::from(*cols)),
            Type::Struct(id) => match self.structs.get(id.index()) {
                Some(0) => 1, // Reported where it is defined.
                Some(size) => *size,
                None if id.index() < self.module.structs.len() => {
                    return Err(Problem::LaterStruct(*id));
                }
                None => return Err(Problem::UnknownStruct(*id)),
            },
        };
        match size {
            0 => Err(Problem::EmptyType),
            _ if size > MAX_WORDS => Err(Problem::TypeTooLarge),
            _ => Ok(size),
        }
    }
}

struct Items<'m> {
    module: &'m Module,
    sizes: Sizes<'m>,
    errors: Vec<Error>,
}

/// Checks everything except the bodies of functions.
pub(super) fn check(module: &Module) -> (Sizes<'_>, Vec<Error>) {
    let sizes = Sizes { module, structs: Vec::new() };
    let mut items = Items { module, sizes, errors: Vec::new() };
    items.enums();
    items.structs();
    items.consts();
    for (index, function) in module.functions.iter().enumerate() {
        items.function(FunctionId(index as u32), function);
    }
    (items.sizes, items.errors)
}

/// Checks that a span with a source position names a file of the module.
pub(super) fn check_span(module: &Module, span: Span) -> Result<(), Problem> {
    if span.line == 0 || (span.file as usize) < module.files.len() {
        Ok(())
    } else {
        Err(Problem::UnknownFile(span.file))
    }
}

impl Items<'_> {
    fn note(&mut self, subject: Subject, span: Span, result: Result<(), Problem>) {
        if let Err(problem) = result {
            self.errors.push(Error { problem, subject, span });
        }
    }

    fn enums(&mut self) {
        for (index, definition) in self.module.enums.iter().enumerate() {
            let subject = Subject::Enum(EnumId(index as u32));
            let span = definition.span;
            self.note(subject, span, check_span(self.module, span));
            if definition.variants.is_empty() {
                self.note(subject, span, Err(Problem::EmptyType));
            }
            let names = definition.variants.iter().map(|variant| &variant.name);
            self.note(subject, span, distinct(names));
        }
    }

    fn structs(&mut self) {
        for (index, definition) in self.module.structs.iter().enumerate() {
            let subject = Subject::Struct(StructId(index as u32));
            let span = definition.span;
            self.note(subject, span, check_span(self.module, span));
            let names = definition.fields.iter().map(|field| &field.name);
            self.note(subject, span, distinct(names));
            let mut size = 0u64;
            for field in &definition.fields {
                match self.sizes.of(&field.ty) {
                    Ok(words) => size = size.saturating_add(words),
                    Err(problem) => self.note(subject, span, Err(problem)),
                }
            }
            if definition.fields.is_empty() {
                self.note(subject, span, Err(Problem::EmptyType));
            } else if size > MAX_WORDS {
                self.note(subject, span, Err(Problem::TypeTooLarge));
            }
            if let Err(problem) = self.form(definition) {
                self.note(subject, span, Err(problem));
            }
            self.sizes.structs.push(size);
        }
        // Only now may types be walked: before, they could have been endless.
        if self.errors.is_empty() {
            self.initial_states();
        }
    }

    /// Checks that the first field can select among the others, as the struct's form requires.
    fn form(&self, definition: &Struct) -> Result<(), Problem> {
        let first = definition.fields.first().map(|field| &field.ty);
        match &definition.form {
            Form::Record | Form::Lent | Form::Shared => Ok(()),
            Form::Choice(chosen) => {
                let cases = match first {
                    Some(&Type::BOOL) => 2,
                    Some(Type::Enum(id)) => {
                        self.module.enums.get(id.index()).map_or(0, |it| it.variants.len())
                    }
                    _ => return Err(Problem::Form(0)),
                };
                if chosen.len() != cases {
                    return Err(Problem::Form(0));
                }
                let mut seen = BTreeSet::new();
                for field in chosen.iter().flatten() {
                    let known = (1..definition.fields.len()).contains(&(*field as usize));
                    if !known || !seen.insert(*field) {
                        return Err(Problem::Form(*field));
                    }
                }
                if seen.len() + 1 < definition.fields.len() {
                    return Err(Problem::Form(definition.fields.len() as u32 - 1));
                }
                Ok(())
            }
            Form::Sequence => match (first, definition.fields.get(1).map(|field| &field.ty)) {
                (Some(&Type::USIZE), Some(Type::Array { .. })) => Ok(()),
                _ => Err(Problem::Form(1)),
            },
        }
    }

    fn initial_states(&mut self) {
        for (index, definition) in self.module.structs.iter().enumerate() {
            for words in definition.initial.iter().chain(&definition.defaults) {
                let id = StructId(index as u32);
                let fit = words_fit(self.module, &Type::Struct(id), words);
                self.note(Subject::Struct(id), definition.span, fit.map_err(Problem::from));
            }
        }
    }

    fn consts(&mut self) {
        let sound = self.errors.is_empty();
        for (index, definition) in self.module.consts.iter().enumerate() {
            let subject = Subject::Const(ConstId(index as u32));
            let size = self.sizes.of(&definition.ty).map(|_| ());
            if sound && size.is_ok() {
                let fit = words_fit(self.module, &definition.ty, &definition.words);
                self.note(subject, Span::default(), fit.map_err(Problem::from));
            }
            self.note(subject, Span::default(), size);
        }
    }

    fn function(&mut self, id: FunctionId, function: &Function) {
        let subject = Subject::Function(id);
        self.note(subject, function.span, check_span(self.module, function.span));
        let (params, locals) = (function.params, function.locals.len());
        if params as usize > locals {
            let problem = Problem::ParameterCount { params, locals };
            self.note(subject, function.span, Err(problem));
        }
        if let Some(kernel) = &function.kernel
            && !has_face(function, kernel)
        {
            self.note(subject, function.span, Err(Problem::Kernel));
        }
        let owner = match function.owner {
            Some(Owner::Struct(owner)) => self.sizes.of(&Type::Struct(owner)).map(|_| ()),
            Some(Owner::Enum(owner)) => self.sizes.of(&Type::Enum(owner)).map(|_| ()),
            None => Ok(()),
        };
        self.note(subject, function.span, owner);
        if function.result != Type::Unit {
            let size = self.sizes.of(&function.result);
            self.note(subject, function.span, size.map(|_| ()));
        }
        for (index, local) in function.locals.iter().enumerate() {
            self.note(subject, local.span, check_span(self.module, local.span));
            let size = match &local.ty {
                Type::Slice(element) if is_lent(function, index) => self.sizes.of(element),
                ty => self.sizes.of(ty),
            };
            self.note(subject, local.span, size.map(|_| ()));
            if local.mode == Mode::Ref && index >= params as usize {
                let problem = Problem::ReferenceLocal(LocalId(index as u32));
                self.note(subject, local.span, Err(problem));
            }
        }
    }
}

/// Returns true if a local is a slice parameter, followed by its length.
fn is_lent(function: &Function, index: usize) -> bool {
    let by_reference = function.locals[index].mode != Mode::Value;
    let length = function.parameters().get(index + 1);
    by_reference && length.is_some_and(|it| it.ty == Type::USIZE && it.mode == Mode::Value)
}

/// Returns true if a function has its kernel's signature and no body, with at most one more parameter for the
/// kernel's memory.
fn has_face(function: &Function, kernel: &Kernel) -> bool {
    let Some(sound) = Kernel::new(kernel.routine, kernel.element, &kernel.dims) else {
        return false;
    };
    // Matrices, or arrays of their elements, all of them.
    let faces = [sound.function(), sound.flat_function()];
    faces.iter().any(|face| has_face_of(function, face))
}

fn has_face_of(function: &Function, face: &Function) -> bool {
    let own = face.locals.len();
    let alike = |(a, b): (&Local, &Local)| a.ty == b.ty && a.mode == b.mode;
    let lent = function.locals.get(own..).unwrap_or_default();
    function.locals.len() >= own
        && function.locals.iter().zip(&face.locals).all(alike)
        && lent.len() <= 1
        && lent.iter().all(|local| local.mode == Mode::RefMut)
        && function.params as usize == function.locals.len()
        && function.result == face.result
        && function.owner.is_none()
        && function.body.0.is_empty()
}

fn distinct<'n>(names: impl Iterator<Item = &'n String>) -> Result<(), Problem> {
    let mut seen = BTreeSet::new();
    for name in names {
        if !seen.insert(name) {
            return Err(Problem::DuplicateName(name.clone()));
        }
    }
    Ok(())
}
