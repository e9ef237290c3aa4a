//! Expressions of one word.
//!
//! Invariant: a result of [`Lower::word`] has exactly the C type of its IR type, except for literals and for
//! comparisons, which are `int` in C.

use bessemer_ir::{
    BinaryOp, CompareOp, ConstId, Expr as Ir, ExprKind, Int, Intrinsic, LogicOp, Role, Routine,
    Scalar, Type, UnaryOp, Written,
};

use super::super::literal::{self, Readers};
use super::super::spelling::scalar_type;
use super::super::tree::Expr;
use super::Lower;
use super::bits::{is_raised, is_widened, masked, uncast};
use super::place::is_small;
use super::range::const_value;

impl Lower<'_> {
    /// Returns the languages of those that read the function: an inline one may be in a header.
    fn readers(&self) -> Readers {
        match self.function.role {
            Role::Inline { .. } => Readers::Cpp,
            _ => Readers::C,
        }
    }

    /// Returns an expression of one word.
    pub(super) fn word(&mut self, expr: &Ir) -> Expr {
        if self.counts(expr) && self.range(expr).is_some() {
            let narrow = self.narrow(expr, false);
            return if self.is_wide(expr) {
                narrow
            } else {
                self.as_int(Int::U32, Int::Usize, narrow)
            };
        }
        if let (Some(value), Some(int)) = (super::range::never_reached(expr), expr.ty.as_int()) {
            return literal::integer(int, value);
        }
        match &expr.kind {
            ExprKind::Literal(word) => {
                self.uses.system.extend(literal::needs_math(&expr.ty, *word).then_some("math.h"));
                match expr.ty.as_int().filter(|_| self.is_hexadecimal(expr, *word)) {
                    Some(int) => literal::hexadecimal(int, int.from_word(*word)),
                    None => literal::word(self.context.names, &expr.ty, *word, self.readers()),
                }
            }
            ExprKind::Const(id) => self.constant_or_word_of_c(*id),
            ExprKind::Load(place) => self.load(place),
            ExprKind::Unary(op, operand) => self.unary(*op, operand),
            ExprKind::Binary(op, left, right) => self.binary(*op, left, right),
            ExprKind::Compare(op, left, right) => self.compare(*op, left, right),
            ExprKind::Logic(op, left, right) => {
                let [left, right] = [left, right].map(|it| self.word(it));
                both(*op, left, right)
            }
            ExprKind::Cast(operand) => self.cast(operand, &expr.ty),
            ExprKind::Intrinsic(intrinsic, operands) => {
                self.intrinsic(*intrinsic, operands, &expr.ty)
            }
            ExprKind::Call(callee, arguments) => self.call_value(*callee, arguments),
            ExprKind::Routine(routine, operands) => self.scalar_routine(*routine, operands),
            ExprKind::Struct(_) | ExprKind::Array(_) | ExprKind::Splat(_) | ExprKind::Matrix(_) => {
                unreachable!("no word: {expr:?}")
            }
        }
    }

    fn constant_or_word_of_c(&mut self, id: ConstId) -> Expr {
        match literal::word_of_c(&self.context.module.consts[id.index()]) {
            Some((word, header)) => {
                self.uses.system.insert(header);
                word
            }
            None => {
                self.uses.consts.insert(id);
                Expr::name(self.constant(id))
            }
        }
    }

    fn load(&mut self, place: &bessemer_ir::Place) -> Expr {
        let value = self.place(place);
        if self.counter(place).is_some() { Expr::cast("uint64_t", value) } else { value }
    }

    fn unary(&mut self, op: UnaryOp, operand: &Ir) -> Expr {
        let value = self.word(of_bool(operand).unwrap_or(operand));
        match (op, &operand.ty) {
            (UnaryOp::Not, Type::Scalar(Scalar::Bool)) => not(value),
            (UnaryOp::Not, ty) => narrowed(ty, Expr::unary("~", value)),
            (UnaryOp::Neg, ty) => narrowed(ty, Expr::unary("-", value)),
        }
    }

    pub(super) fn binary(&mut self, op: BinaryOp, left: &Ir, right: &Ir) -> Expr {
        if matches!(op, BinaryOp::Shl | BinaryOp::Shr) {
            return self.shift(op, left, right);
        }
        if op == BinaryOp::Xor && left.ty == Type::BOOL {
            return self.compare(CompareOp::Ne, left, right);
        }
        let of_bits = matches!(op, BinaryOp::And | BinaryOp::Or | BinaryOp::Xor);
        let (a, b) = match left.ty.as_int() {
            Some(int) if of_bits && !int.signed() => {
                let (a, b) = (self.bits(left), self.bits(right));
                // Beside what is raised, a smaller number needs no cast to the type that both are brought back to.
                let beside = |value: Expr, ir: &Ir, other: &Ir| {
                    let alone = is_small(int) && is_widened(ir) && is_raised(other);
                    if alone { uncast(value, &ir.ty) } else { value }
                };
                (beside(a, left, right), beside(b, right, left))
            }
            // Of two counters, one at least has to have 64 bits; beside a number, the cast says which both have.
            _ if self.is_counter(left) && self.is_counter(right)
                || left.is_literal()
                || right.is_literal() =>
            {
                (self.word(left), self.word(right))
            }
            _ => (self.given(left), self.given(right)),
        };
        let a = power_base(op, left, right).unwrap_or(a);
        self.arithmetic(op, &left.ty, a, b)
    }

    /// Returns a value where C converts it implicitly to its type: a 32-bit counter needs no cast to 64 bits.
    pub(super) fn given(&mut self, expr: &Ir) -> Expr {
        match &expr.kind {
            ExprKind::Load(place) if self.counter(place).is_some() => self.place(place),
            _ => self.word(expr),
        }
    }

    /// Returns true if the author wrote a literal in hexadecimal; a single digit is the same in both bases.
    fn is_hexadecimal(&self, expr: &Ir, word: u64) -> bool {
        word >= 10 && self.context.module.written(expr) == Some(Written::Hexadecimal)
    }

    /// Returns true if a value is a counter that C holds in 32 bits.
    fn is_counter(&self, expr: &Ir) -> bool {
        matches!(&expr.kind, ExprKind::Load(place) if self.counter(place).is_some())
    }

    fn compare(&mut self, op: CompareOp, left: &Ir, right: &Ir) -> Expr {
        let left = self.unbrought(op, left, right);
        if let Some(always) = self.decided(op, left, right) {
            return Expr::name(if always { "true" } else { "false" });
        }
        let narrow = (self.counts(left) || self.counts(right))
            && self.range(left).is_some()
            && self.range(right).is_some();
        let before = (self.mentioned.clone(), self.uses.clone());
        let (a, b) = if narrow {
            (self.narrow(left, false), self.narrow(right, false))
        } else {
            let (a, b) = (self.word(left), self.word(right));
            // gcc takes `MAX - x`, of more bits than what it is compared with, for a complement that was promoted.
            let plain = |other: &Expr| !matches!(other, Expr::Unary(..) | Expr::Binary(..));
            let (bare, other) = (plain(&b), plain(&a));
            let a = if bare && self.is_counter(left) { self.given(left) } else { a };
            (a, if other && self.is_counter(right) { self.given(right) } else { b })
        };
        if a == b && left.ty.as_float().is_none() {
            let equal = matches!(op, CompareOp::Eq | CompareOp::Le | CompareOp::Ge);
            (self.mentioned, *self.uses) = before;
            return Expr::name(if equal { "true" } else { "false" });
        }
        let limit = |value: Expr, ir: &Ir| super::range::limit(ir).unwrap_or(value);
        let (a, b) = (limit(masked(a, left), left), limit(masked(b, right), right));
        let (a, b) = (self.comparable(a), self.comparable(b));
        let natural = left.ty.as_int().is_some_and(|int| !int.signed());
        match op {
            CompareOp::Ge if natural && const_value(left) == Some(0) => Expr::binary("==", b, a),
            CompareOp::Lt if natural && const_value(left) == Some(0) => Expr::binary(">", b, a),
            _ => Expr::binary(comparison(op), a, b),
        }
    }

    /// Returns a compared enum as it is in memory, where that does not change the result. An invalid value equals only the
    /// variant as which it counts.
    fn unbrought<'e>(&self, op: CompareOp, value: &'e Ir, with: &Ir) -> &'e Ir {
        let (ExprKind::Intrinsic(Intrinsic::Variant, operands), ExprKind::Literal(word)) =
            (&value.kind, &with.kind)
        else {
            return value;
        };
        let (Type::Enum(id), [operand]) = (&value.ty, &operands[..]) else { return value };
        let fallback = self.context.module.enums[id.index()].fallback() as u64;
        let equality = matches!(op, CompareOp::Eq | CompareOp::Ne);
        if equality && *word != fallback { operand } else { value }
    }

    /// Returns the negation of a condition, with comparisons reversed where that is equivalent. For floats these are
    /// only `==` and `!=`, because of NaN.
    pub(super) fn negated(&mut self, condition: &Ir) -> Expr {
        match &condition.kind {
            ExprKind::Literal(word) => Expr::name(if *word == 0 { "true" } else { "false" }),
            ExprKind::Unary(UnaryOp::Not, inner) => self.word(inner),
            ExprKind::Compare(op, left, right) if turns(*op, &left.ty) => {
                self.compare(turned(*op), left, right)
            }
            ExprKind::Logic(op, left, right) if has_negation(left) && has_negation(right) => {
                let [left, right] = [left, right].map(|it| self.negated(it));
                both(if *op == LogicOp::And { LogicOp::Or } else { LogicOp::And }, left, right)
            }
            _ => not(self.word(condition)),
        }
    }

    fn scalar_routine(&mut self, routine: Routine, operands: &[Ir]) -> Expr {
        match routine {
            Routine::Dot => self.dot_product(&operands[0], &operands[1]),
            Routine::NormSquared => self.norm_squared(&operands[0]),
            Routine::Amax | Routine::Amin => self.extreme(routine, &operands[0]),
            Routine::Norm => {
                let float = operands[0].ty.clone();
                let square = self.norm_squared(&operands[0]);
                self.uses.system.insert("math.h");
                let single = matches!(
                    float,
                    Type::Matrix { element: Scalar::Float(bessemer_ir::Float::F32), .. }
                );
                Expr::call(if single { "sqrtf" } else { "sqrt" }, vec![square])
            }
            _ => unreachable!("{routine:?} gives a matrix"),
        }
    }
}

/// Returns the negation of a C condition: `isnan(x) == 0` for `isnan(x) != 0`.
fn not(condition: Expr) -> Expr {
    match condition {
        Expr::Binary("!=", left, right) => Expr::Binary("==", left, right),
        other => Expr::unary("!", other),
    }
}

/// Casts a value that C promoted to `int` back to its type.
pub(super) fn narrowed(ty: &Type, value: Expr) -> Expr {
    match ty.as_int() {
        Some(int) if super::place::is_small(int) => {
            Expr::cast(scalar_type(Scalar::Int(int)), value)
        }
        _ => value,
    }
}

fn comparison(op: CompareOp) -> &'static str {
    match op {
        CompareOp::Eq => "==",
        CompareOp::Ne => "!=",
        CompareOp::Lt => "<",
        CompareOp::Le => "<=",
        CompareOp::Gt => ">",
        CompareOp::Ge => ">=",
    }
}

fn turned(op: CompareOp) -> CompareOp {
    match op {
        CompareOp::Eq => CompareOp::Ne,
        CompareOp::Ne => CompareOp::Eq,
        CompareOp::Lt => CompareOp::Ge,
        CompareOp::Le => CompareOp::Gt,
        CompareOp::Gt => CompareOp::Le,
        CompareOp::Ge => CompareOp::Lt,
    }
}

fn turns(op: CompareOp, ty: &Type) -> bool {
    ty.as_float().is_none() || matches!(op, CompareOp::Eq | CompareOp::Ne)
}

fn has_negation(condition: &Ir) -> bool {
    match &condition.kind {
        ExprKind::Unary(UnaryOp::Not, _) => true,
        ExprKind::Compare(op, left, _) => turns(*op, &left.ty),
        ExprKind::Logic(_, left, right) => has_negation(left) && has_negation(right),
        ExprKind::Load(_) => true,
        _ => false,
    }
}

/// Returns a `bool` as a number, without a redundant mask: gcc warns of `~(uint8_t)((uint8_t)flag & 1U)`.
fn of_bool(operand: &Ir) -> Option<&Ir> {
    match &operand.kind {
        ExprKind::Cast(from) if from.ty == Type::BOOL => Some(operand),
        ExprKind::Binary(BinaryOp::And, value, mask) => {
            matches!(mask.kind, ExprKind::Literal(word) if word & 1 == 1).then(|| of_bool(value))?
        }
        _ => None,
    }
}

/// Returns the truth of a condition that is a constant.
pub(super) fn truth_of(condition: &Expr) -> Option<bool> {
    match condition {
        Expr::Name(name) if name == "true" => Some(true),
        Expr::Name(name) if name == "false" => Some(false),
        _ => None,
    }
}

/// Returns a condition of two, without one that is a constant and changes nothing.
fn both(op: LogicOp, left: Expr, right: Expr) -> Expr {
    let (name, neutral) = match op {
        LogicOp::And => ("&&", true),
        LogicOp::Or => ("||", false),
    };
    match (truth_of(&left), truth_of(&right)) {
        (Some(truth), _) if truth == neutral => right,
        (_, Some(truth)) if truth == neutral => left,
        _ => Expr::binary(name, left, right),
    }
}

/// Returns the left operand of `2 ^ n` or `10 ^ n` in hexadecimal: compilers warn that in decimal it is taken for a power.
fn power_base(op: BinaryOp, left: &Ir, right: &Ir) -> Option<Expr> {
    match (op, &left.kind, &right.kind) {
        (BinaryOp::Xor, ExprKind::Literal(base @ (2 | 10)), ExprKind::Literal(_)) => {
            left.ty.as_int().map(|int| literal::hexadecimal(int, (*base).into()))
        }
        _ => None,
    }
}
