//! Types, and the definitions of structs and constants.

use std::collections::BTreeSet;
use std::fmt::Write as _;

use bessemer_ir::visit::Walk;
use bessemer_ir::{ConstId, ExprKind, Float, FunctionId, Int, Module, Scalar, StructId, Type};

use crate::error::Error;
use crate::names::{Names, word};

/// Types and constants that functions need.
#[derive(Default)]
pub(crate) struct Used {
    structs: BTreeSet<StructId>,
    consts: BTreeSet<ConstId>,
}

/// Returns what functions need.
pub(crate) fn used(module: &Module, functions: &BTreeSet<FunctionId>) -> Used {
    let mut used = Used::default();
    for id in functions {
        let function = &module.functions[id.index()];
        used.note(module, &function.result);
        function.locals.iter().for_each(|local| used.note(module, &local.ty));
        function.body.any_expr(|expr| {
            used.note(module, &expr.ty);
            if let ExprKind::Const(id) = expr.kind {
                used.consts.insert(id);
            }
            false
        });
    }
    used
}

impl Used {
    fn note(&mut self, module: &Module, ty: &Type) {
        match ty {
            Type::Struct(id) if self.structs.insert(*id) => {
                let fields = &module.structs[id.index()].fields;
                fields.iter().for_each(|field| self.note(module, &field.ty));
            }
            Type::Array { element, .. } | Type::Slice(element) => self.note(module, element),
            _ => {}
        }
    }
}

/// Returns the Rust type of a value's lanes.
pub(crate) fn text(names: &Names, ty: &Type) -> String {
    match ty {
        Type::Unit => "()".to_owned(),
        Type::Scalar(scalar) => of_scalar(*scalar).to_owned(),
        Type::Enum(_) => "Whole".to_owned(),
        Type::Array { element, len } => format!("[{}; {len}]", stored(names, element)),
        Type::Matrix { element, rows, cols } => {
            format!("[{}; {}]", of_scalar(*element), rows * cols)
        }
        Type::Struct(id) => names.of_struct(*id).to_owned(),
        Type::Slice(element) => format!("[{}]", stored(names, element)),
    }
}

/// Returns true if a value is a byte, which has a type of its own in arrays and structs.
pub(crate) fn is_byte(ty: &Type) -> bool {
    *ty == Type::Scalar(Scalar::Int(Int::U8))
}

/// Returns the Rust type of an element or a field.
pub(crate) fn stored(names: &Names, ty: &Type) -> String {
    if is_byte(ty) { "Byte".to_owned() } else { text(names, ty) }
}

pub(crate) fn of_scalar(scalar: Scalar) -> &'static str {
    match scalar {
        Scalar::Float(Float::F64) => "Real",
        Scalar::Float(Float::F32) => "Single",
        Scalar::Int(_) => "Whole",
        Scalar::Bool => "Mask",
    }
}

/// Writes the definitions of structs and constants.
pub(crate) fn definitions(
    module: &Module,
    names: &Names,
    used: &Used,
    out: &mut String,
) -> Result<(), Error> {
    for id in &used.structs {
        structure(module, names, *id, out);
    }
    for id in &used.consts {
        let constant = &module.consts[id.index()];
        let (name, words) = (names.of_const(*id), &constant.words);
        _ = match (&constant.ty, words.as_slice()) {
            (Type::Scalar(Scalar::Float(Float::F64)), [word]) => {
                writeln!(out, "\nconst {name}: f64 = {};", number(f64::from_bits(*word)))
            }
            (_, [word]) => writeln!(out, "\nconst {name}: i64 = {};", *word as i64),
            (_, words) => {
                let list: Vec<String> = words.iter().map(|word| format!("{word:#x}")).collect();
                let len = words.len();
                writeln!(out, "\nstatic {name}: [u64; {len}] = [{}];", list.join(", "))
            }
        };
    }
    Ok(())
}

/// Returns a number in Rust that has its bits.
pub(crate) fn number(value: f64) -> String {
    if value.is_finite() {
        return format!("{value:?}");
    }
    format!("f64::from_bits({:#x})", value.to_bits())
}

fn structure(module: &Module, names: &Names, id: StructId, out: &mut String) {
    let (name, definition) = (names.of_struct(id), &module.structs[id.index()]);
    let fields: Vec<String> = definition.fields.iter().map(|field| word(&field.name)).collect();
    _ = writeln!(out, "\n#[derive(Clone, Debug, PartialEq)]\npub struct {name} {{");
    for (field, name) in definition.fields.iter().zip(&fields) {
        _ = writeln!(out, "    pub {name}: {},", stored(names, &field.ty));
    }
    _ = writeln!(out, "}}\n\nimpl Lanes for {name} {{");
    let each = |line: &dyn Fn(&String) -> String| -> String {
        fields.iter().map(|field| format!("        {}\n", line(field))).collect()
    };
    _ = write!(
        out,
        "    fn assign(&mut self, mask: Mask, value: &Self) {{\n{}    }}\n    \
         fn take(&mut self, lane: usize, value: &Self) {{\n{}    }}\n    \
         fn splat(words: &mut impl Iterator<Item = u64>) -> Self {{\n        {name} {{\n{}        }}\n    }}\n    \
         fn put(&mut self, lane: usize, words: &mut impl Iterator<Item = u64>) {{\n{}    }}\n    \
         fn words(&self, lane: usize, words: &mut Vec<u64>) {{\n{}    }}\n}}\n",
        each(&|it| format!("self.{it}.assign(mask, &value.{it});")),
        each(&|it| format!("self.{it}.take(lane, &value.{it});")),
        each(&|it| format!("    {it}: Lanes::splat(words),")),
        each(&|it| format!("self.{it}.put(lane, words);")),
        each(&|it| format!("self.{it}.words(lane, words);")),
    );
}
