//! Sizes in memory, as the usual ABIs lay things out: for the report only, never for the C.

use bessemer_ir::{Form, Scalar, StructId, Type};

use super::context::Context;

/// `sizeof` a value.
pub fn size_of(context: Context<'_>, ty: &Type) -> u64 {
    size_and_align(context, ty).0
}

/// `sizeof` a struct, its hidden field included.
pub fn size_of_struct(context: Context<'_>, id: StructId) -> u64 {
    size_of(context, &Type::Struct(id))
}

fn size_and_align(context: Context<'_>, ty: &Type) -> (u64, u64) {
    match ty {
        Type::Unit => (0, 1),
        // A pointer, and never a part of something.
        Type::Slice(_) => (8, 8),
        Type::Scalar(scalar) => {
            let size = scalar_size(*scalar);
            (size, size)
        }
        Type::Enum(_) => (4, 4),
        Type::Array { element, len } => {
            let (size, align) = size_and_align(context, element);
            (size * u64::from(*len), align)
        }
        Type::Matrix { element, rows, cols } => {
            let size = scalar_size(*element);
            (size * u64::from(*rows) * u64::from(*cols), size)
        }
        Type::Struct(id) => {
            let item = &context.module.structs[id.index()];
            let fault = context.names.structs[id.index()].fault.is_some();
            let mut fields: Vec<_> =
                item.fields.iter().map(|field| size_and_align(context, &field.ty)).collect();
            let own = if item.overlaid() { 1 } else { 0 };
            if item.overlaid() || item.form == Form::Shared {
                // One of them at a time.
                let most = fields.drain(own..).fold((0, 1), |(most, strictest), (size, align)| {
                    (u64::max(most, size), u64::max(strictest, align))
                });
                fields.push((most.0.next_multiple_of(most.1), most.1));
            }
            let fields = fields.into_iter().chain(fault.then_some((4, 4)));
            let (size, align) = fields.fold((0, 1), |(end, most), (size, align)| {
                (u64::next_multiple_of(end, align) + size, u64::max(most, align))
            });
            (size.next_multiple_of(align).max(1), align)
        }
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
