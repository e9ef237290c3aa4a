//! Names, `&str`, as numbers.
//!
//! While functions are lowered, names have a type of their own, an enum without variants. Afterwards the type is `u32`, and
//! the enum is gone. Must not know: how a name gets its number.

use bessemer_ir::visit::{Access, VisitMut, walk_expr_mut, walk_place_mut};
use bessemer_ir::{EnumId, Expr, Int, Module, Owner, Place, Scalar, Type};

/// Makes the names of a module numbers; `names` is their type.
pub(crate) fn to_numbers(module: &mut Module, names: EnumId) {
    let mut numbers = Numbers(names);
    let fields = module.structs.iter_mut().flat_map(|it| &mut it.fields);
    fields.for_each(|field| numbers.ty(&mut field.ty));
    module.consts.iter_mut().for_each(|constant| numbers.ty(&mut constant.ty));
    for function in &mut module.functions {
        numbers.ty(&mut function.result);
        function.locals.iter_mut().for_each(|local| numbers.ty(&mut local.ty));
        if let Some(Owner::Enum(id)) = &mut function.owner {
            numbers.id(id);
        }
        numbers.block(&mut function.body);
    }
    module.enums.remove(names.index());
}

/// Visitor that replaces the type of names, the enum, by `u32`.
struct Numbers(EnumId);

impl Numbers {
    fn ty(&self, ty: &mut Type) {
        match ty {
            Type::Enum(id) if *id == self.0 => *ty = Type::Scalar(Scalar::Int(Int::U32)),
            Type::Enum(id) => self.id(id),
            Type::Array { element, .. } | Type::Slice(element) => self.ty(element),
            Type::Unit | Type::Scalar(_) | Type::Matrix { .. } | Type::Struct(_) => {}
        }
    }

    /// Closes the gap that the enum leaves.
    fn id(&self, id: &mut EnumId) {
        id.0 -= u32::from(*id > self.0);
    }
}

impl VisitMut for Numbers {
    fn expr(&mut self, expr: &mut Expr) {
        self.ty(&mut expr.ty);
        walk_expr_mut(self, expr);
    }

    fn place(&mut self, place: &mut Place, _: Access) {
        self.ty(&mut place.ty);
        walk_place_mut(self, place);
    }
}
