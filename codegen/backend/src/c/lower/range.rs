//! Sizes in 32 bits. Counters over `usize` with known bounds, locals that keep their initial value within 32 bits, and
//! reassigned locals that always fit, need no 64-bit arithmetic in C.

use bessemer_ir::{
    BinaryOp, CompareOp, Expr as Ir, ExprKind, Int, Intrinsic, LocalId, Place, Scalar, Type,
    UnaryOp,
};

use super::super::tree::Expr;
use super::Lower;
use bessemer_ir::effects::same_place;

/// Largest value of an expression computed in 32 bits, and of its parts.
const LIMIT: i128 = 1 << 31;

impl Lower<'_> {
    /// Returns the range of a `usize` expression that counters and constants bound, if C may compute it in 32 bits.
    pub(super) fn range(&self, expr: &Ir) -> Option<(i128, i128)> {
        if expr.ty != Type::USIZE {
            return None;
        }
        let range = match &expr.kind {
            ExprKind::Literal(word) => (i128::from(*word), i128::from(*word)),
            ExprKind::Const(id) => {
                let word = i128::from(self.context.module.consts[id.index()].words[0]);
                (word, word)
            }
            ExprKind::Load(place) => self.counter(place)?,
            ExprKind::Cast(inner) if is_unsigned(inner) => self.type_range(expr)?,
            ExprKind::Intrinsic(Intrinsic::Min, operands) => {
                let known = operands.iter().filter_map(|operand| self.range(operand));
                (0, known.map(|(_, most)| most).min()?)
            }
            ExprKind::Binary(BinaryOp::Rem, _, right) => (0, self.range(right)?.1.max(1) - 1),
            ExprKind::Binary(op, left, right) => {
                let (a, b) = (self.range(left)?, self.range(right)?);
                match op {
                    BinaryOp::Add => (a.0 + b.0, a.1 + b.1),
                    // No difference of sizes is below 0: that would be a fault.
                    BinaryOp::Sub => ((a.0 - b.1).max(0), a.1 - b.0),
                    BinaryOp::Mul => (a.0 * b.0, a.1 * b.1),
                    BinaryOp::Div if b.0 > 0 => (a.0 / b.1, a.1 / b.0),
                    _ => return None,
                }
            }
            _ => return None,
        };
        (0 <= range.0 && range.0 <= range.1 && range.1 <= LIMIT).then_some(range)
    }

    /// Returns the result of a comparison that the types decide, since compilers warn about such comparisons.
    pub(super) fn decided(&self, op: CompareOp, left: &Ir, right: &Ir) -> Option<bool> {
        if matches!(op, CompareOp::Eq | CompareOp::Ne)
            && (bits_differ(left, right) || bits_differ(right, left))
        {
            return Some(op == CompareOp::Ne);
        }
        let (a, b) = (self.type_range(left)?, self.type_range(right)?);
        let (below, above) = (a.1 < b.0, a.0 > b.1);
        let (not_above, not_below) = (a.1 <= b.0, a.0 >= b.1);
        match op {
            CompareOp::Lt if below || not_below => Some(below),
            CompareOp::Le if not_above || above => Some(not_above),
            CompareOp::Gt if above || not_above => Some(above),
            CompareOp::Ge if not_below || below => Some(not_below),
            CompareOp::Eq | CompareOp::Ne if below || above => Some(op == CompareOp::Ne),
            _ => None,
        }
    }

    /// Returns the range of an expression according to its type; of a literal, its value.
    pub(super) fn type_range(&self, expr: &Ir) -> Option<(i128, i128)> {
        let full = match &expr.ty {
            Type::Scalar(Scalar::Bool) => (0, 1),
            Type::Scalar(Scalar::Int(int)) => (Int::min(*int), Int::max(*int)),
            Type::Enum(id) => (0, self.context.module.enums[id.index()].variants.len() as i128 - 1),
            _ => return None,
        };
        if let Some(value) = const_value(expr) {
            return Some((value, value));
        }
        match &expr.kind {
            ExprKind::Literal(word) => {
                let value = expr.ty.as_int().map_or(i128::from(*word), |int| int.from_word(*word));
                Some((value, value))
            }
            // C holds it in 32 bits.
            ExprKind::Load(place) if self.counter(place).is_some() => {
                Some((0, i128::from(u32::MAX)))
            }
            ExprKind::Cast(inner) => {
                let inner = self.number_range(inner).unwrap_or(full);
                Some(if inner.0 >= full.0 && inner.1 <= full.1 { inner } else { full })
            }
            ExprKind::Binary(op, left, right) => {
                let alone = unchanged(*op, left, right).and_then(|it| self.type_range(it));
                alone.or_else(|| self.range_of_bits(*op, left, right)).or(Some(full))
            }
            _ => Some(full),
        }
    }

    /// Returns the range of a bit operation on two operands that are not negative.
    fn range_of_bits(&self, op: BinaryOp, left: &Ir, right: &Ir) -> Option<(i128, i128)> {
        let (a, b) = (self.type_range(left)?, self.type_range(right)?);
        let bits = |value: i128| (1i128 << (128 - value.leading_zeros())) - 1;
        let high = match op {
            _ if a.0 < 0 || b.0 < 0 => return None,
            BinaryOp::And => a.1.min(b.1),
            BinaryOp::Or | BinaryOp::Xor => bits(a.1 | b.1),
            _ => return None,
        };
        Some((0, high))
    }

    /// Returns the range of an expression as numbers, including the numbers of an enum's variants.
    fn number_range(&self, expr: &Ir) -> Option<(i128, i128)> {
        let range = self.type_range(expr)?;
        let Type::Enum(id) = expr.ty else { return Some(range) };
        let words = usize::try_from(range.0).ok()?..=usize::try_from(range.1).ok()?;
        let (low, high) = self.context.module.enums[id.index()].values(words)?;
        Some((low.into(), high.into()))
    }

    /// Returns the range of a local that C holds in 32 bits.
    pub(super) fn counter(&self, place: &Place) -> Option<(i128, i128)> {
        let LocalId(root) = place.root;
        if place.steps.is_empty() { self.counters[root as usize] } else { None }
    }

    /// Returns true if an expression computes with a local that C holds in 32 bits.
    pub(super) fn counts(&self, expr: &Ir) -> bool {
        match &expr.kind {
            ExprKind::Load(place) => self.counter(place).is_some(),
            ExprKind::Binary(_, left, right) => self.counts(left) || self.counts(right),
            _ => false,
        }
    }

    /// Returns an expression with a [`Lower::range`] in 32 bits. With `bare` it is an index, and a literal needs no
    /// suffix.
    pub(super) fn narrow(&mut self, expr: &Ir, bare: bool) -> Expr {
        match &expr.kind {
            ExprKind::Literal(word) if bare => Expr::name(word.to_string()),
            ExprKind::Literal(word) => Expr::name(format!("{word}U")),
            ExprKind::Load(place) => self.place(place),
            ExprKind::Cast(inner) if bare => self.index(inner),
            ExprKind::Cast(inner) if !is_long(inner) => Expr::cast("uint32_t", self.word(inner)),
            ExprKind::Binary(BinaryOp::Rem, left, right) if self.range(left).is_none() => {
                self.binary(BinaryOp::Rem, left, right)
            }
            ExprKind::Binary(op, left, right) => {
                let op = match op {
                    BinaryOp::Add => "+",
                    BinaryOp::Sub => "-",
                    BinaryOp::Div => "/",
                    BinaryOp::Rem => "%",
                    _ => "*",
                };
                let (a, b) = (self.beside(left, right), self.beside(right, left));
                Expr::binary(op, a, b)
            }
            _ => self.word(expr),
        }
    }

    /// Returns an operand cast to the width of the other one. A constant has 64 bits in C and gets 32 beside a 32-bit
    /// computation; a 32-bit computation gets 64 beside a 64-bit one.
    fn beside(&mut self, expr: &Ir, other: &Ir) -> Expr {
        let value = self.narrow(expr, false);
        if self.is_shortened(expr, other) {
            Expr::cast("uint32_t", value)
        } else if self.is_wide(other) && !self.is_wide(expr) && !self.is_shortened(other, expr) {
            match value {
                Expr::Binary(..) => self.as_int(Int::U32, Int::Usize, value),
                value => value,
            }
        } else {
            value
        }
    }

    /// Returns true if the constant `expr`, which has 64 bits, is cast to 32, since the operator `other` beside it
    /// computes in 32.
    fn is_shortened(&self, expr: &Ir, other: &Ir) -> bool {
        let computed = matches!(other.kind, ExprKind::Binary(..)) && !self.is_wide(other);
        matches!(expr.kind, ExprKind::Const(_)) && computed
    }

    /// Returns a size in 32 bits.
    pub(super) fn size(&mut self, expr: &Ir) -> Expr {
        if self.range(expr).is_none() {
            return Expr::cast("uint32_t", self.word(expr));
        }
        let (wide, value) = (self.is_wide(expr), self.narrow(expr, false));
        if wide { Expr::cast("uint32_t", value) } else { value }
    }

    /// Returns true if C computes an expression in 64 bits, though its value fits into 32.
    pub(super) fn is_wide(&self, expr: &Ir) -> bool {
        match &expr.kind {
            ExprKind::Const(_) | ExprKind::Intrinsic(..) => true,
            ExprKind::Cast(inner) => is_long(inner),
            ExprKind::Binary(BinaryOp::Rem, left, _) if self.range(left).is_none() => true,
            ExprKind::Binary(_, left, right) => {
                let wide = |one, other| self.is_wide(one) && !self.is_shortened(one, other);
                wide(left, right) || wide(right, left)
            }
            _ => false,
        }
    }
}

/// Returns true for an unsigned integer.
fn is_unsigned(value: &Ir) -> bool {
    value.ty.as_int().is_some_and(|int| !int.signed())
}

/// Returns true if an integer has 64 bits.
fn is_long(value: &Ir) -> bool {
    value.ty.as_int().is_some_and(|int| int.bits() == 64)
}

/// Returns the macro for a 64-bit literal that equals the limit of a narrower type.
pub(super) fn limit(expr: &Ir) -> Option<Expr> {
    let ExprKind::Literal(word) = expr.kind else { return None };
    let int = expr.ty.as_int().filter(|int| int.bits() == 64)?;
    match (int.from_word(word), int.signed()) {
        (-2_147_483_648, _) => Some(Expr::name("INT32_MIN")),
        (2_147_483_647, true) => Some(Expr::name("INT32_MAX")),
        (4_294_967_295, true) => Some(Expr::cast("int64_t", Expr::name("UINT32_MAX"))),
        (4_294_967_295, false) => Some(Expr::name("UINT32_MAX")),
        _ => None,
    }
}

/// Returns the value of an integer expression that compilers know from its text, modulo 2^bits. It consists of
/// literals, or one literal decides it, as in `x & 0` and `x % 1`. Its operands have no effects.
pub(super) fn const_value(expr: &Ir) -> Option<i128> {
    let int = expr.ty.as_int()?;
    exact_value(expr).map(|value| wrapped(int, value))
}

/// Returns the value before its conversion to its type, if it is known.
fn exact_value(expr: &Ir) -> Option<i128> {
    let int = expr.ty.as_int()?;
    match &expr.kind {
        ExprKind::Literal(word) => Some(int.from_word(*word)),
        ExprKind::Unary(UnaryOp::Neg, operand) => Some(-const_value(operand)?),
        ExprKind::Unary(UnaryOp::Not, operand) => Some(wrapped(int, !const_value(operand)?)),
        ExprKind::Cast(operand) => Some(wrapped(int, const_value(operand)?)),
        ExprKind::Binary(op, left, right) => {
            let (a, b) = (const_value(left), const_value(right));
            let alike = || same_load(left, right);
            by_one(int, *op, a, b).or_else(|| by_both(int, *op, a?, b?)).or_else(|| match op {
                BinaryOp::Sub | BinaryOp::Xor | BinaryOp::Rem if alike() => Some(0),
                _ => None,
            })
        }
        _ => None,
    }
}

/// Returns the result that one operand decides, whatever the other is.
fn by_one(int: Int, op: BinaryOp, a: Option<i128>, b: Option<i128>) -> Option<i128> {
    let all = Some(wrapped(int, -1));
    let is_none = match op {
        BinaryOp::And | BinaryOp::Mul => a == Some(0) || b == Some(0),
        BinaryOp::Rem => a == Some(0) || b == Some(1) || b == Some(-1),
        BinaryOp::Div | BinaryOp::Shl | BinaryOp::Shr => a == Some(0),
        BinaryOp::Or if a == all || b == all => return all,
        _ => false,
    };
    is_none.then_some(0)
}

/// Returns the result that both operands decide, before its conversion to its type.
fn by_both(int: Int, op: BinaryOp, a: i128, b: i128) -> Option<i128> {
    match op {
        BinaryOp::Add => Some(a + b),
        BinaryOp::Sub => Some(a - b),
        BinaryOp::Mul => Some(a.wrapping_mul(b)),
        BinaryOp::Div => a.checked_div(b),
        BinaryOp::Rem => a.checked_rem(b),
        BinaryOp::And => Some(a & b),
        BinaryOp::Or => Some(a | b),
        BinaryOp::Xor => Some(a ^ b),
        BinaryOp::Shl | BinaryOp::Shr if !(0..i128::from(int.bits())).contains(&b) => None,
        BinaryOp::Shl => Some(wrapped(int, a << b)),
        BinaryOp::Shr => Some(a >> b),
    }
}

/// Returns true if a constant lacks a bit that `|` sets in a value, or has one that `&` clears.
fn bits_differ(value: &Ir, constant: &Ir) -> bool {
    let (ExprKind::Binary(op, left, right), Some(constant)) = (&value.kind, const_value(constant))
    else {
        return false;
    };
    let Some(bits) = const_value(right).or_else(|| const_value(left)) else { return false };
    match op {
        BinaryOp::Or => bits & !constant != 0,
        BinaryOp::And => constant & !bits != 0,
        _ => false,
    }
}

/// Returns the operand that equals the result, since the other operand is neutral.
fn unchanged<'e>(op: BinaryOp, left: &'e Ir, right: &'e Ir) -> Option<&'e Ir> {
    let (int, (a, b)) = (left.ty.as_int()?, (const_value(left), const_value(right)));
    let (by_left, by_right) = match op {
        BinaryOp::Add | BinaryOp::Or | BinaryOp::Xor => (Some(0), Some(0)),
        BinaryOp::Sub | BinaryOp::Shl | BinaryOp::Shr => (None, Some(0)),
        BinaryOp::Mul => (Some(1), Some(1)),
        BinaryOp::Div => (None, Some(1)),
        BinaryOp::And => (Some(wrapped(int, -1)), Some(wrapped(int, -1))),
        BinaryOp::Rem => (None, None),
    };
    if by_right.is_some() && b == by_right {
        return Some(left);
    }
    (by_left.is_some() && a == by_left).then_some(right)
}

/// Returns true if two operands load the same place.
fn same_load(left: &Ir, right: &Ir) -> bool {
    match (&left.kind, &right.kind) {
        (ExprKind::Load(one), ExprKind::Load(other)) => same_place(one, other),
        (ExprKind::Cast(one), ExprKind::Cast(other)) => one.ty == other.ty && same_load(one, other),
        _ => false,
    }
}

fn wrapped(int: Int, value: i128) -> i128 {
    let low = value.rem_euclid(1i128 << int.bits());
    if low > Int::max(int) { low - (1i128 << int.bits()) } else { low }
}

/// Returns a value for an operation that certainly faults. A check before it has ended the function, but compilers warn
/// about it.
pub(super) fn never_reached(expr: &Ir) -> Option<i128> {
    let int = expr.ty.as_int()?;
    if let ExprKind::Binary(op, _, right) = &expr.kind {
        let count = const_value(right);
        let bad = match op {
            BinaryOp::Div | BinaryOp::Rem => count == Some(0),
            BinaryOp::Shl | BinaryOp::Shr => {
                count.is_some_and(|count| count < 0 || count >= i128::from(int.bits()))
            }
            _ => false,
        };
        if bad {
            return Some(0);
        }
    }
    let value = exact_value(expr)?;
    (value < Int::min(int) || value > Int::max(int)).then(|| wrapped(int, value))
}
