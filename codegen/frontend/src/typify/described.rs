//! Definitions of the module, and types as names: in the C, and as their authors write them.
//!
//! Must not know: how a type is lowered.

use bessemer_ir::tree::{Argument, Ty};
use bessemer_ir::{Field, Scalar, Struct, StructId, Type};

use super::context::Context;
use super::names::{arity, snake, split};

impl Context<'_> {
    /// Returns the fields of a struct.
    pub(super) fn fields(&self, id: StructId) -> &[Field] {
        &self.module.structs[id.index()].fields
    }

    /// Returns the type of a field.
    pub(super) fn field_type(&self, id: StructId, at: u32) -> Type {
        self.fields(id)[at as usize].ty.clone()
    }

    /// Returns the name of a struct or an enum.
    pub(super) fn name_of(&self, ty: &Type) -> Option<&str> {
        match ty {
            Type::Struct(id) => Some(&self.module.structs[id.index()].name),
            Type::Enum(id) => Some(&self.module.enums[id.index()].name),
            _ => None,
        }
    }

    /// Adds a struct to the module.
    pub(super) fn add_struct(&mut self, item: Struct) -> StructId {
        self.module.structs.push(item);
        StructId(self.module.structs.len() as u32 - 1)
    }

    /// Returns a type as its author writes it.
    pub(super) fn show(&self, ty: &Type) -> String {
        match ty {
            Type::Unit => "()".into(),
            Type::Scalar(scalar) => scalar.name().into(),
            Type::Array { element, len } => format!("[{}; {len}]", self.show(element)),
            Type::Matrix { element, rows, cols } => {
                format!("SMatrix<{}, {rows}, {cols}>", element.name())
            }
            Type::Struct(_) if let Some(shown) = &self.known(ty).shown => shown.clone(),
            Type::Struct(_) | Type::Enum(_) => self.name_of(ty).unwrap_or_default().to_owned(),
            Type::Slice(element) => format!("[{}]", self.show(element)),
        }
    }

    /// Returns the name of an instance of the item `name` in the module or type `home`. Another item of the author's
    /// with the resulting name keeps it.
    pub(super) fn instance_name(&self, home: &str, name: &str, suffix: &str) -> String {
        let own = format!("{name}{suffix}");
        let taken =
            !suffix.is_empty() && self.authored.contains(&format!("{home}::{}", snake(&own)));
        if taken { format!("{name}_of{suffix}") } else { own }
    }

    /// Returns a readable suffix for an instance, such as `_f32_4`; empty without arguments.
    pub(super) fn suffix(&self, arguments: &[Argument]) -> String {
        arguments.iter().map(|argument| format!("_{}", self.argument_name(argument))).collect()
    }

    /// Returns a generic argument as part of a name.
    pub(super) fn argument_name(&self, argument: &Argument) -> String {
        match argument {
            Argument::Type(ty) => self.type_name(ty),
            Argument::Number(Scalar::Bool, word) => (*word != 0).to_string(),
            Argument::Number(Scalar::Int(int), word) => {
                let value = int.from_word(*word);
                let sign = if value < 0 { "minus_" } else { "" };
                format!("{sign}{}", value.unsigned_abs())
            }
            Argument::Number(_, word) => word.to_string(),
        }
    }

    fn type_name(&self, ty: &Ty) -> String {
        match ty {
            Ty::Unit => "unit".into(),
            Ty::Scalar(scalar) => scalar.name().into(),
            Ty::Array(element, len) => format!("{}_{len}", self.type_name(element)),
            Ty::Matrix(scalar, rows, cols) => format!("{}_{rows}x{cols}", scalar.name()),
            Ty::Named(path) => snake(self.item_name(path)),
            Ty::Tuple(parts) => {
                let parts: Vec<_> = parts.iter().map(|part| self.type_name(part)).collect();
                format!("{}_{}", arity(parts.len()), parts.join("_"))
            }
            Ty::Slice(element) => format!("slice_{}", self.type_name(element)),
            Ty::List(element, n) => format!("list{n}_{}", self.type_name(element)),
            Ty::Option(value) => format!("option_{}", self.type_name(value)),
            Ty::Result(value, error) => {
                format!("result_{}_{}", self.type_name(value), self.type_name(error))
            }
            Ty::Ref(inner, _) => self.type_name(inner),
            Ty::Known(name, inner) => match &**inner {
                Ty::Matrix(scalar, ..) => format!("{}_{}", snake(name), scalar.name()),
                Ty::Scalar(_) => snake(name),
                inner => format!("{}_{}", snake(name), self.type_name(inner)),
            },
        }
    }

    /// Returns the name of the type at a path.
    pub(super) fn item_name<'p>(&'p self, path: &'p str) -> &'p str {
        let named = self.types.by_path.get(path).and_then(|ty| self.name_of(ty));
        let nothing = || self.types.nothings.get(path).map(|it| it.name.as_str());
        named.or_else(nothing).unwrap_or(split(path).1)
    }
}
