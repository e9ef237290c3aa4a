//! Sizes and offsets in memory for the usual ABIs. They appear in reports and descriptions, never in the C.

use bessemer_ir::{EnumId, Form, Scalar, StructId, Type};

use super::context::Context;

/// Size of enums.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Enums {
    /// As an `int`.
    Int,
    /// As the smallest integer that holds its values.
    Short,
}

/// Returns `sizeof` a value.
pub fn size_of(context: Context<'_>, ty: &Type, enums: Enums) -> u64 {
    size_and_align(context, ty, enums).0
}

/// Returns `sizeof` a struct including its hidden field, with enums as `int`.
pub fn size_of_struct(context: Context<'_>, id: StructId) -> u64 {
    size_of(context, &Type::Struct(id), Enums::Int)
}

/// Returns `offsetof` each field of a struct, and of its hidden field.
pub fn offsets(context: Context<'_>, id: StructId, enums: Enums) -> Vec<u64> {
    laid_out(context, id, enums).0
}

fn size_and_align(context: Context<'_>, ty: &Type, enums: Enums) -> (u64, u64) {
    match ty {
        Type::Unit => (0, 1),
        // A pointer, and never a part of something.
        Type::Slice(_) => (8, 8),
        Type::Scalar(scalar) => {
            let size = scalar_size(*scalar);
            (size, size)
        }
        Type::Enum(id) => {
            let size = enum_size(context, *id, enums);
            (size, size)
        }
        Type::Array { element, len } => {
            let (size, align) = size_and_align(context, element, enums);
            (size * u64::from(*len), align)
        }
        Type::Matrix { element, rows, cols } => {
            let size = scalar_size(*element);
            (size * u64::from(*rows) * u64::from(*cols), size)
        }
        Type::Struct(id) => laid_out(context, *id, enums).1,
    }
}

/// Returns the offsets of a struct's fields, its size and its alignment.
fn laid_out(context: Context<'_>, id: StructId, enums: Enums) -> (Vec<u64>, (u64, u64)) {
    let item = &context.module.structs[id.index()];
    let fields = item.fields.iter().map(|field| size_and_align(context, &field.ty, enums));
    let fields: Vec<_> = fields.collect();
    // Those behind share their memory.
    let own = match (item.overlaid(), item.form == Form::Shared) {
        (true, _) => 1,
        (_, true) => 0,
        _ => fields.len(),
    };
    let (mut end, mut strictest, mut offsets) = (0, 1, Vec::new());
    for (size, align) in &fields[..own] {
        let offset = u64::next_multiple_of(end, *align);
        offsets.push(offset);
        (end, strictest) = (offset + size, u64::max(strictest, *align));
    }
    let shared = &fields[own..];
    let align = shared.iter().map(|(_, align)| *align).max().unwrap_or(1);
    let most = shared.iter().map(|(size, _)| *size).max().unwrap_or(0);
    let start = end.next_multiple_of(align);
    offsets.extend(shared.iter().map(|_| start));
    if !shared.is_empty() {
        end = start + most.next_multiple_of(align);
        strictest = strictest.max(align);
    }
    if context.names.structs[id.index()].fault.is_some() {
        // Of few values, none of them negative.
        let size = if enums == Enums::Short { 1 } else { 4 };
        offsets.push(end.next_multiple_of(size));
        end = end.next_multiple_of(size) + size;
        strictest = strictest.max(size);
    }
    (offsets, (end.next_multiple_of(strictest).max(1), strictest))
}

fn enum_size(context: Context<'_>, id: EnumId, enums: Enums) -> u64 {
    let values = context.module.enums[id.index()].variants.iter().map(|it| i64::from(it.value));
    let within = |low: i64, high: i64| values.clone().all(|it| (low..=high).contains(&it));
    match enums {
        Enums::Int => 4,
        Enums::Short if within(0, 0xFF) || within(-0x80, 0x7F) => 1,
        Enums::Short if within(0, 0xFFFF) || within(-0x8000, 0x7FFF) => 2,
        Enums::Short => 4,
    }
}

fn scalar_size(scalar: Scalar) -> u64 {
    match scalar {
        Scalar::Bool => 1,
        Scalar::Float(bessemer_ir::Float::F32) => 4,
        Scalar::Float(bessemer_ir::Float::F64) => 8,
        Scalar::Int(int) => u64::from(int.bits() / 8),
    }
}
