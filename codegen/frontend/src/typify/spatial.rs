//! nalgebra's rotations and poses, where they need no function: structs of quaternions, conversions between them, and
//! their parts as a vector.

use bessemer_ir::tree::{self, Parts, Site, SpatialMethod};
use bessemer_ir::{CompareOp, Expr, ExprKind, LogicOp, Routine, StructId, Type, UnaryOp};

use super::expr::{Call, two};
use super::lowering::Lowering;
use super::pair::Pair;
use super::words;
use super::{Needed, OUR_FAULT, Result, problem, refusals, refused, struct_of};

/// Returns the part of a quaternion at an index that is written as a number: i, j, k and w in nalgebra's order.
pub(super) fn numbered(index: &tree::Expr) -> Result<usize> {
    let part = match &index.kind {
        tree::ExprKind::Int(digits, _) => digits.parse().ok().filter(|part| *part < 4),
        _ => None,
    };
    part.or_refused(index.site, refusals::QUATERNION_INDEX)
}

impl Lowering<'_, '_> {
    /// Returns the function that implements an operator; `slot` is the slot of its value, or of its place.
    pub(super) fn operator(&self, slot: Option<u32>) -> Option<&tree::Callee> {
        let mut operators = self.source.operators.iter();
        operators.find(|(at, _)| Some(*at) == slot).map(|(_, callee)| callee)
    }

    /// Lowers an operation on rotations or poses.
    pub(super) fn spatial(&mut self, method: SpatialMethod, call: Call<'_>) -> Result<Expr> {
        let Call { arguments, expr } = call;
        use SpatialMethod as M;
        match (method, arguments) {
            (M::PlatformAngles, _) => refused(expr.site, refusals::PLATFORM),
            (M::QuaternionIdentity, _) => {
                let id = struct_of(&self.slot_of(expr)?, expr.site, "a quaternion")?;
                let part = |name: &str| {
                    let digits = if name == "w" { "1.0" } else { "0.0" };
                    let kind = tree::ExprKind::Float(digits.into(), None);
                    (name.to_owned(), tree::Expr::plain(kind, expr.site))
                };
                self.parts(id, &["i", "j", "k", "w"].map(part), None, expr)
            }
            (M::QuaternionCoords, [q]) => self.coords(q, expr.site),
            (M::SameParts, [q]) => {
                let ty = self.slot_of(expr)?;
                let value = self.value(q, None)?;
                self.same_parts(value, &ty, expr.site)
            }
            (M::TimesTransposed, _) => {
                let [left, right] = two(self.alike(arguments, None, &words::SIDES)?, expr.site)?;
                let right = self.routine_node(Routine::Transpose, vec![right], expr.site)?;
                self.routine_node(Routine::Product, vec![left, right], expr.site)
            }
            _ => problem(expr.site, format!("{method:?} takes other operands"), OUR_FAULT),
        }
    }

    /// Builds a struct from its parts, which have the order of the arguments.
    pub(super) fn of_parts(&mut self, parts: Parts, call: Call<'_>) -> Result<Expr> {
        let Call { arguments, expr } = call;
        let id = struct_of(&self.slot_of(expr)?, expr.site, "a struct")?;
        let names = parts.names().iter().map(|name| (*name).to_owned());
        let parts: Vec<_> = names.zip(arguments.iter().cloned()).collect();
        self.parts(id, &parts, None, expr)
    }

    /// Converts a quaternion to the type `asked`, unit or not; any other value is unchanged.
    pub(super) fn as_asked(&mut self, value: Expr, asked: &Type, site: Site) -> Result<Expr> {
        let quaternion = |ty: &Type| self.cx.known(ty).unit.is_some();
        if value.ty != *asked && quaternion(&value.ty) && quaternion(asked) {
            return self.same_parts(value, asked, site);
        }
        Ok(value)
    }

    /// Returns a struct with the parts of another.
    fn same_parts(&mut self, value: Expr, ty: &Type, site: Site) -> Result<Expr> {
        let span = value.span;
        let parts = match value.kind {
            ExprKind::Struct(parts) => parts,
            _ => self.parts_of(value, site)?,
        };
        Ok(Expr { kind: ExprKind::Struct(parts), ty: ty.clone(), span })
    }

    /// Returns the parts i, j, k and w of a quaternion.
    fn parts_of(&mut self, value: Expr, site: Site) -> Result<Vec<Expr>> {
        let id = struct_of(&value.ty, site, "a quaternion")?;
        let place = self.hold(value);
        Ok((0..4).map(|part| self.part(&place, id, part).load()).collect())
    }

    /// Lowers `q.coords`: i, j, k and w as a vector.
    pub(super) fn coords(&mut self, q: &tree::Expr, site: Site) -> Result<Expr> {
        let value = self.value(q, None)?;
        let parts = self.parts_of(value, site)?;
        match parts.first().map(|part| part.ty.clone()) {
            Some(Type::Scalar(element)) => {
                self.node(ExprKind::Matrix(parts), Type::Matrix { element, rows: 4, cols: 1 }, site)
            }
            _ => problem(site, "this is not a quaternion", OUR_FAULT),
        }
    }

    /// Refuses a write to `q.coords`, which is a value in the C.
    pub(super) fn not_coords(&mut self, expr: &tree::Expr) -> Result<()> {
        if self.in_coords(expr)? {
            return refused(expr.site, refusals::QUATERNION_PARTS);
        }
        Ok(())
    }

    /// Returns true if `expr` is `q.coords` of a quaternion, or an element of it, which is no place.
    pub(super) fn in_coords(&mut self, expr: &tree::Expr) -> Result<bool> {
        match &expr.kind {
            tree::ExprKind::Field(base, name) if name == "coords" => {
                let ty = self.type_of_value(base)?;
                Ok(self.cx.known(&ty).unit.is_some())
            }
            tree::ExprKind::Field(base, _)
            | tree::ExprKind::Index(base, _)
            | tree::ExprKind::Deref(base)
            | tree::ExprKind::Ref(_, base) => self.in_coords(base),
            _ => Ok(false),
        }
    }

    /// Lowers `==` of unit quaternions: opposite quaternions are equal rotations.
    pub(super) fn same_rotation(&self, id: StructId, pair: &Pair) -> Expr {
        let span = pair.span;
        let all = |opposite: bool| {
            let parts = (0..4).map(|part| {
                let [one, mut other] =
                    pair.parts(|it| self.part(it, id, part)).sides.map(|it| it.load());
                if opposite {
                    other = Expr::unary(UnaryOp::Neg, other).at(span);
                }
                Expr::compare(CompareOp::Eq, one, other).at(span)
            });
            parts.reduce(|all, next| Expr::logic(LogicOp::And, all, next))
        };
        match (all(false), all(true)) {
            (Some(same), Some(opposite)) => Expr::logic(LogicOp::Or, same, opposite),
            _ => Expr::bool(true, span),
        }
    }
}
