//! The numbers of enums, and their order by these.
//!
//! A variant's word is its index; Rust compares and converts the numbers, which the author may choose.

use bessemer_ir::tree::{self, Site};
use bessemer_ir::{EnumId, Expr, Int, Scalar, Type, Variant};

use super::lowering::Lowering;
use super::{Result, problem};

impl Lowering<'_, '_> {
    /// The number of an enum that `<` compares.
    pub(super) fn rank(&self, id: EnumId, value: Expr, site: Site) -> Result<Expr> {
        let definition = &self.cx.module.enums[id.index()];
        if !self.cx.ordered.contains(&Type::Enum(id)) {
            return problem(
                site,
                format!("`{}` does not derive `PartialOrd` where the DSL sees it", definition.name),
                "write `#[derive(PartialOrd)]` below `#[data]`, or `match`",
            );
        }
        if !definition.is_numbered() {
            return Ok(value);
        }
        Ok(value.cast(&Type::Scalar(Scalar::Int(Int::I32))))
    }
}

/// The variants of an enum with their numbers: the author's, or from 0 upwards.
pub(super) fn numbered(variants: &[tree::Variant], site: Site) -> Result<Vec<Variant>> {
    let number = |(index, it): (i64, &tree::Variant)| {
        let Ok(value) = i32::try_from(it.value.unwrap_or(index)) else {
            return problem(
                site,
                "the number of a variant has 32 bits in C",
                "choose numbers between -2147483648 and 2147483647",
            );
        };
        let (name, docs, given) = (it.name.clone(), it.docs.clone(), it.given.clone());
        Ok(Variant { name, docs, value, given })
    };
    (0..).zip(variants).map(number).collect()
}
