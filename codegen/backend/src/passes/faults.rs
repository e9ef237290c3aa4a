//! Conditions that an operation needs in order not to fault, without the proved ones.
//!
//! Precondition: the operands do not fault. Postcondition: each condition is IR that does not fault, and is true
//! exactly where Rust does not panic. A conjunct that [`State`] proves is omitted. Integers of up to 32 bits are
//! compared after widening; wider ones are compared with the distance to the limit.

use bessemer_ir::{
    BinaryOp, CompareOp, Expr, ExprKind, Fault, Int, Intrinsic, LocalId, LogicOp, Scalar, Span,
    Step, Type, UnaryOp,
};

use super::analysis::Interval;
use super::analysis::State;
use super::places::located;

/// A condition that has to be checked before an operation.
pub(crate) struct Obligation {
    pub(crate) condition: Expr,
    pub(crate) fault: Fault,
    /// Span of the operation.
    pub(crate) span: Span,
    /// Text that says why it could not be proved.
    pub(crate) reason: String,
}

/// Returns the conditions that the operation at the root of `expr` needs.
pub(crate) fn of_expr(expr: &Expr, facts: &State) -> Vec<Obligation> {
    let needs = Needs { facts, span: expr.span };
    match &expr.kind {
        ExprKind::Unary(UnaryOp::Neg, x) => needs.of_negation(x),
        ExprKind::Intrinsic(Intrinsic::Abs, args) => {
            args.first().map_or_else(Vec::new, |x| needs.of_negation(x))
        }
        ExprKind::Intrinsic(Intrinsic::Clamp, args) => match args.as_slice() {
            [_, low, high] => {
                let reason = "the bounds are not known to be in order".to_string();
                needs.all(vec![compare(CompareOp::Le, low, high)], Fault::Clamp, reason)
            }
            _ => Vec::new(),
        },
        ExprKind::Intrinsic(function, args) => match (function, args.as_slice()) {
            (Intrinsic::WrappingDiv | Intrinsic::WrappingRem, [_, b]) => needs.of_divisor(b),
            (Intrinsic::DivEuclid, [a, b]) => needs.of_binary(BinaryOp::Div, a, b),
            (Intrinsic::RemEuclid, [a, b]) => needs.of_binary(BinaryOp::Rem, a, b),
            _ => Vec::new(),
        },
        // A number between two others is within their type.
        ExprKind::Binary(BinaryOp::Add, ..) if facts.halved(expr).is_some() => Vec::new(),
        ExprKind::Binary(op, a, b) => needs.of_binary(*op, a, b),
        _ => Vec::new(),
    }
}

/// Returns the conditions that a step into a value of type `container` needs.
pub(crate) fn of_step(
    root: LocalId,
    container: &Type,
    step: &Step,
    facts: &State,
) -> Vec<Obligation> {
    let index = |index: &Expr, len: u32, what: &str| {
        Needs { facts, span: index.span }.of_index(index, len, what)
    };
    match (container, step) {
        (Type::Array { len, .. }, Step::Index(at)) => index(at, *len, "elements"),
        (Type::Matrix { rows, cols, .. }, Step::Index(at)) => index(at, rows * cols, "elements"),
        (Type::Slice(_), Step::Index(at)) => {
            Needs { facts, span: at.span }.of_slice(CompareOp::Lt, at, root)
        }
        (Type::Slice(_), Step::From(at)) => {
            Needs { facts, span: at.span }.of_slice(CompareOp::Le, at, root)
        }
        (Type::Array { len, .. }, Step::From(at)) => index(at, len.saturating_add(1), "beginnings"),
        (Type::Matrix { rows, cols, .. }, Step::From(at)) => {
            index(at, rows.saturating_mul(*cols).saturating_add(1), "beginnings")
        }
        (Type::Matrix { rows, cols, .. }, Step::Element(row, column)) => {
            let mut all = index(row, *rows, "rows");
            all.extend(index(column, *cols, "columns"));
            all
        }
        _ => Vec::new(),
    }
}

/// Returns the operands whose sign a condition tests first. Facts must apply to them, so they must be locals or fields.
pub(crate) fn signs_matter(op: BinaryOp, ty: &Type) -> (bool, bool) {
    let Some(int) = ty.as_int().filter(|int| int.bits() == 64) else { return (false, false) };
    match op {
        BinaryOp::Add | BinaryOp::Sub => (false, int.signed()),
        BinaryOp::Mul => (int.signed(), true),
        _ => (false, false),
    }
}

/// Returns the length of the slice that is this parameter.
fn length_of(slice: LocalId, span: Span) -> Expr {
    Expr::local(LocalId(slice.0.saturating_add(1)), &Type::USIZE, span)
}

/// An operation at a point of the function.
struct Needs<'f, 'm> {
    facts: &'f State<'m>,
    span: Span,
}

impl Needs<'_, '_> {
    /// Returns one obligation for those of `conditions` that are not proved; none if all are.
    fn all(&self, conditions: Vec<Expr>, fault: Fault, reason: String) -> Vec<Obligation> {
        let open = conditions.into_iter().filter(|condition| !self.facts.proves(condition));
        let condition = open.reduce(|a, b| logic(LogicOp::And, a, b));
        let condition = condition.map(|condition| located(condition, self.span));
        let obligation = |condition| Obligation { condition, fault, span: self.span, reason };
        condition.map(obligation).into_iter().collect()
    }

    fn of_index(&self, index: &Expr, len: u32, what: &str) -> Vec<Obligation> {
        let Some(int) = index.ty.as_int() else { return Vec::new() };
        let mut conditions = at_least(index, int, 0);
        conditions.extend(below(index, int, i128::from(len)));
        let reason = format!("index {} of {len} {what}", self.described(index));
        self.all(conditions, Fault::Index, reason)
    }

    /// Returns the condition of an index into a slice: its length is the local behind it.
    fn of_slice(&self, op: CompareOp, index: &Expr, root: LocalId) -> Vec<Obligation> {
        let length = length_of(root, self.span);
        let reason = format!("index {} of a slice", self.described(index));
        self.all(vec![compare(op, index, &length)], Fault::Index, reason)
    }

    fn of_negation(&self, x: &Expr) -> Vec<Obligation> {
        let Some(int) = x.ty.as_int() else { return Vec::new() };
        let reason = format!("the opposite of {} may leave {}", self.described(x), int.name());
        let condition = compare(CompareOp::Ne, x, &literal(int.min(), int));
        self.all(vec![condition], Fault::Overflow, reason)
    }

    fn of_binary(&self, op: BinaryOp, a: &Expr, b: &Expr) -> Vec<Obligation> {
        let (Some(int), Some(right)) = (a.ty.as_int(), b.ty.as_int()) else { return Vec::new() };
        let overflow = |sign: &str, conditions| {
            let (a, b) = (self.described(a), self.described(b));
            let reason = format!("{a} {sign} {b} may leave {}", int.name());
            self.all(conditions, Fault::Overflow, reason)
        };
        let exact = self.facts.range(a).exact(op, self.facts.range(b));
        match op {
            BinaryOp::Add | BinaryOp::Sub | BinaryOp::Mul if exact.within(Interval::of(int)) => {
                Vec::new()
            }
            BinaryOp::Add => overflow("+", sum(a, b, int, self.facts)),
            BinaryOp::Sub => overflow("-", difference(a, b, int, self.facts)),
            BinaryOp::Mul => overflow("*", product(a, b, int, self.facts)),
            BinaryOp::Div | BinaryOp::Rem => {
                let mut all = self.of_divisor(b);
                all.extend(overflow("/", quotient(a, b, int)));
                all
            }
            BinaryOp::Shl | BinaryOp::Shr => {
                let mut conditions = at_least(b, right, 0);
                conditions.extend(below(b, right, i128::from(int.bits())));
                let reason = format!("shift by {} of {} bits", self.described(b), int.bits());
                self.all(conditions, Fault::Shift, reason)
            }
            BinaryOp::And | BinaryOp::Or | BinaryOp::Xor => Vec::new(),
        }
    }

    fn of_divisor(&self, b: &Expr) -> Vec<Obligation> {
        let Some(int) = b.ty.as_int() else { return Vec::new() };
        let nonzero = compare(CompareOp::Ne, b, &literal(0, int));
        let reason = format!("the divisor {} may be 0", self.described(b));
        self.all(vec![nonzero], Fault::DivisionByZero, reason)
    }

    /// Returns the range of a value as text, or its type if nothing is known.
    fn described(&self, x: &Expr) -> String {
        match x.ty.as_int() {
            Some(int) if self.facts.range(x) == Interval::of(int) => int.name().to_string(),
            _ => self.facts.range(x).to_string(),
        }
    }
}

fn sum(a: &Expr, b: &Expr, int: Int, facts: &State) -> Vec<Expr> {
    if let Some(c) = constant(b, facts) {
        shifted(a, int, -c)
    } else if let Some(c) = constant(a, facts) {
        shifted(b, int, -c)
    } else if int.bits() < 64 {
        wide(BinaryOp::Add, a, b, Int::I64, int)
    } else {
        let room = |limit, sign| {
            let rest = binary(BinaryOp::Sub, &literal(limit, int), b);
            compare(sign, a, &rest)
        };
        let up = room(int.max(), CompareOp::Le);
        if !int.signed() {
            return vec![up];
        }
        let down = room(int.min(), CompareOp::Ge);
        vec![unless(b, CompareOp::Lt, up, facts), unless(b, CompareOp::Gt, down, facts)]
    }
}

fn difference(a: &Expr, b: &Expr, int: Int, facts: &State) -> Vec<Expr> {
    if let Some(c) = constant(b, facts) {
        shifted(a, int, c)
    } else if !int.signed() {
        vec![compare(CompareOp::Le, b, a)]
    } else if int.bits() < 64 {
        wide(BinaryOp::Sub, a, b, Int::I64, int)
    } else {
        let room = |limit, sign| {
            let rest = binary(BinaryOp::Add, &literal(limit, int), b);
            compare(sign, a, &rest)
        };
        let up = room(int.max(), CompareOp::Le);
        let down = room(int.min(), CompareOp::Ge);
        vec![unless(b, CompareOp::Gt, up, facts), unless(b, CompareOp::Lt, down, facts)]
    }
}

/// Returns the condition that `x - c` is within the type.
fn shifted(x: &Expr, int: Int, c: i128) -> Vec<Expr> {
    if c >= 0 { at_least(x, int, int.min() + c) } else { at_most(x, int, int.max() + c) }
}

fn product(a: &Expr, b: &Expr, int: Int, facts: &State) -> Vec<Expr> {
    match (constant(a, facts), constant(b, facts)) {
        (_, Some(c)) => scaled(a, int, c),
        (Some(c), None) => scaled(b, int, c),
        _ if int == Int::U32 => wide(BinaryOp::Mul, a, b, Int::U64, int),
        _ if int.bits() < 64 => wide(BinaryOp::Mul, a, b, Int::I64, int),
        _ => long_product(a, b, int, facts),
    }
}

/// Returns the condition that `x * c` is within the type.
fn scaled(x: &Expr, int: Int, c: i128) -> Vec<Expr> {
    let (low, high) = match c {
        0 => return Vec::new(),
        c if c > 0 => (int.min() / c, int.max() / c),
        c => (int.max() / c, int.min() / c),
    };
    let mut conditions = at_least(x, int, low);
    conditions.extend(at_most(x, int, high));
    conditions
}

/// Returns the conditions that a 64-bit `a * b` is within the type, one for each pair of signs.
fn long_product(a: &Expr, b: &Expr, int: Int, facts: &State) -> Vec<Expr> {
    let zero = literal(0, int);
    let over = |limit, by| binary(BinaryOp::Div, &literal(limit, int), by);
    if !int.signed() {
        let fits = compare(CompareOp::Le, a, &over(int.max(), b));
        return vec![otherwise(compare(CompareOp::Eq, b, &zero), fits, facts)];
    }
    let case = |a_off, b_off, fits| {
        let (a, b) = (compare(a_off, a, &zero), compare(b_off, b, &zero));
        otherwise(a, otherwise(b, fits, facts), facts)
    };
    use CompareOp::{Ge, Le};
    vec![
        case(Le, Le, compare(Le, a, &over(int.max(), b))),
        case(Le, Ge, compare(Ge, b, &over(int.min(), a))),
        case(Ge, Le, compare(Ge, a, &over(int.min(), b))),
        case(Ge, Ge, compare(Ge, b, &over(int.max(), a))),
    ]
}

fn quotient(a: &Expr, b: &Expr, int: Int) -> Vec<Expr> {
    if !int.signed() {
        return Vec::new();
    }
    let smallest = compare(CompareOp::Ne, a, &literal(int.min(), int));
    let opposite = compare(CompareOp::Ne, b, &literal(-1, int));
    vec![logic(LogicOp::Or, smallest, opposite)]
}

/// Returns the condition that the exact result, in the wider type, is within the narrower.
fn wide(op: BinaryOp, a: &Expr, b: &Expr, to: Int, int: Int) -> Vec<Expr> {
    let cast = |x: &Expr| {
        let ty = Type::Scalar(Scalar::Int(to));
        Expr { kind: ExprKind::Cast(Box::new(x.clone())), ty, span: Span::default() }
    };
    let exact = binary(op, &cast(a), &cast(b));
    // Neither a sum nor a product of unsigned numbers is below 0.
    let mut conditions = match int.signed() {
        true => at_least(&exact, to, int.min()),
        false => Vec::new(),
    };
    conditions.extend(at_most(&exact, to, int.max()));
    conditions
}

/// Returns `condition`, or true where `b` compares with 0 as in `sign`.
fn unless(b: &Expr, sign: CompareOp, condition: Expr, facts: &State) -> Expr {
    let Some(int) = b.ty.as_int() else { return condition };
    otherwise(compare(sign, b, &literal(0, int)), condition, facts)
}

/// Returns `excuse || condition`, or only `condition` if `excuse` is known to be false.
fn otherwise(excuse: Expr, condition: Expr, facts: &State) -> Expr {
    if facts.range(&excuse) == Interval::one(0) {
        condition
    } else {
        logic(LogicOp::Or, excuse, condition)
    }
}

fn at_least(x: &Expr, int: Int, low: i128) -> Vec<Expr> {
    if low <= int.min() { Vec::new() } else { vec![compare(CompareOp::Ge, x, &literal(low, int))] }
}

fn at_most(x: &Expr, int: Int, high: i128) -> Vec<Expr> {
    if high >= int.max() {
        Vec::new()
    } else {
        vec![compare(CompareOp::Le, x, &literal(high, int))]
    }
}

fn below(x: &Expr, int: Int, end: i128) -> Vec<Expr> {
    if end > int.max() { Vec::new() } else { vec![compare(CompareOp::Lt, x, &literal(end, int))] }
}

/// Returns the value of a literal or a named constant.
fn constant(x: &Expr, facts: &State) -> Option<i128> {
    match x.kind {
        ExprKind::Literal(_) | ExprKind::Const(_) => facts.range(x).single(),
        _ => None,
    }
}

fn literal(value: i128, int: Int) -> Expr {
    let word = if int.signed() { value as i64 as u64 } else { value as u64 };
    Expr::literal(word, Type::Scalar(Scalar::Int(int)), Span::default())
}

fn binary(op: BinaryOp, a: &Expr, b: &Expr) -> Expr {
    Expr::binary(op, a.clone(), b.clone()).at(Span::default())
}

fn compare(op: CompareOp, a: &Expr, b: &Expr) -> Expr {
    Expr::compare(op, a.clone(), b.clone()).at(Span::default())
}

fn logic(op: LogicOp, a: Expr, b: Expr) -> Expr {
    Expr::logic(op, a, b).at(Span::default())
}
