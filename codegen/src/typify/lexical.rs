//! `<` of tuples, arrays and structs that derive it: the first parts that differ decide. And of enums: by their numbers.
//!
//! A NaN among these parts makes each comparison false, as in Rust: it neither comes first nor is it equal. A variant's word
//! is its index; Rust compares and converts the numbers, which the author may choose.

use bessemer_ir::tree::{BinaryOp as Op, Site};
use bessemer_ir::{EnumId, Expr, Int, LogicOp, Place, Scalar, Step, Type};

use super::lowering::Lowering;
use super::{Result, problem};

/// An array of more elements is not written out.
const MOST: u32 = 8;

impl Lowering<'_, '_> {
    /// `left < right` and the like of two values of several words.
    pub(super) fn lexical(&mut self, op: Op, left: Expr, right: Expr, site: Site) -> Result<Expr> {
        let [mut left, mut right] = [left, right].map(|operand| self.compared(operand));
        if self.cx.known(&left.ty).reversed {
            std::mem::swap(&mut left, &mut right);
        }
        let Some(steps) = self.steps_to_parts(&left.ty, &left) else {
            return problem(
                site,
                "this has no order in the DSL",
                "compare parts; tuples have an order, arrays of up to 8 elements, and plain enums and structs that derive `PartialOrd` below `#[data]`",
            );
        };
        let strict = match op {
            Op::Le => Op::Lt,
            Op::Ge => Op::Gt,
            op => op,
        };
        let mut decided: Option<Expr> = None;
        for (step, ty) in steps.into_iter().rev() {
            let [one, other] =
                [&left, &right].map(|whole| whole.inside(step.clone(), ty.clone()).load());
            decided = Some(match decided {
                None => self.binary_node(op, one, other, site)?,
                Some(rest) => {
                    let first = self.binary_node(strict, one.clone(), other.clone(), site)?;
                    let same = self.binary_node(Op::Eq, one, other, site)?;
                    Expr::logic(LogicOp::Or, first, Expr::logic(LogicOp::And, same, rest))
                }
            });
        }
        match decided {
            Some(decided) => Ok(decided),
            None => problem(site, "what is empty has no order in the DSL", "leave it out"),
        }
    }

    /// The number of an enum that `<` compares.
    pub(super) fn rank(&self, id: EnumId, value: Expr, site: Site) -> Result<Expr> {
        let definition = &self.cx.module.enums[id.index()];
        if !self.cx.known(&Type::Enum(id)).ordered {
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

    /// The way to each part, and its type; none if the whole has no order part by part.
    fn steps_to_parts(&self, ty: &Type, place: &Place) -> Option<Vec<(Step, Type)>> {
        let known = self.cx.known(ty);
        let is_tuple = known.shown.is_some() && known.cases.is_empty();
        match ty {
            Type::Struct(id) if is_tuple || known.ordered || known.reversed => {
                let fields = self.cx.fields(*id).iter();
                Some((0..).zip(fields).map(|(at, it)| (Step::Field(at), it.ty.clone())).collect())
            }
            Type::Array { element, len } if *len <= MOST => {
                let step = |at: u32| Step::Index(Expr::usize(u64::from(at), place.span));
                Some((0..*len).map(|at| (step(at), (**element).clone())).collect())
            }
            _ => None,
        }
    }
}
