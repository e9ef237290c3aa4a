//! Preconditions of numeric operations, and their results.
//!
//! Meaning: if the precondition holds, the operation does not fault. Its result is exact or, for a wrapping
//! operation, differs from the exact one by a multiple of 2^bits.

use bessemer_ir::{
    BinaryOp, CompareOp, EnumId, Expr, Float, Int, Intrinsic, Scalar, Type, UnaryOp,
};

use super::knowledge::{Bounds, Formula};
use super::linear::{FURTHEST, Linear};
use super::values::{Origin, Point, Value, Values, bounds_of, ordered, within};
use crate::passes::sites::Site;
use bessemer_ir::used::Rule;

impl Values<'_> {
    pub(super) fn unary(
        &mut self,
        point: &mut Point,
        op: UnaryOp,
        x: &Expr,
        expr: &Expr,
    ) -> Option<Value> {
        let value = self.value(point, x)?;
        match (op, value, expr.ty.as_int()) {
            (UnaryOp::Not, Value::Truth(formula), _) => Some(Value::Truth(formula.not())),
            // All bits turned over: the ends change places.
            (UnaryOp::Not, Value::Number(form), Some(int)) => {
                let turned = form.times(-1)?.shifted(int.min() + int.max());
                turned.map(Value::Number)
            }
            (UnaryOp::Neg, Value::Number(form), Some(int)) => {
                let opposite = form.times(-1);
                self.need_within(point, opposite.as_ref(), bounds_of(int), Site::of_expr(expr));
                opposite.map(Value::Number)
            }
            (UnaryOp::Neg, Value::Float(_, Some(bits)), _) => {
                Some(self.float(-f64::from_bits(bits)))
            }
            (op, value, _) => {
                let limits = self.limits_of_unary(op, &value);
                let made = self.opaque(Origin::Unary(op, expr.ty.clone()), vec![value], &expr.ty);
                self.limited(made, limits)
            }
        }
    }

    pub(super) fn compare(
        &mut self,
        point: &Point,
        op: CompareOp,
        ty: &Type,
        values: (Option<Value>, Option<Value>),
    ) -> Formula {
        match values {
            (Some(Value::Number(a)), Some(Value::Number(b))) => {
                if let Type::Enum(id) = ty {
                    // Two that are no variants may be the same or not; their order is not that of their indices.
                    let last = self.variants(*id) - 1;
                    let stray = |form: &Linear| self.range(point, form).1 > last;
                    let equality = matches!(op, CompareOp::Eq | CompareOp::Ne);
                    if stray(&a) && stray(&b) || !equality {
                        return Formula::Is(self.fresh((0, 1)), true);
                    }
                }
                ordered(op, &a, &b).unwrap_or_else(|| Formula::Is(self.fresh((0, 1)), true))
            }
            (Some(Value::Truth(a)), Some(Value::Truth(b))) => {
                let same = |b: Formula| {
                    let both = Formula::All(vec![a.clone(), b.clone()]);
                    Formula::Any(vec![both, Formula::All(vec![a.not(), b.not()])])
                };
                match op {
                    CompareOp::Eq => same(b),
                    CompareOp::Ne => same(b.not()),
                    _ => Formula::Is(self.fresh((0, 1)), true),
                }
            }
            (Some(Value::Float(a, x)), Some(Value::Float(b, y))) => {
                if let (Some(x), Some(y)) = (x, y) {
                    let (x, y) = (f64::from_bits(x), f64::from_bits(y));
                    return Formula::constant(match op {
                        CompareOp::Eq => x == y,
                        CompareOp::Ne => x != y,
                        CompareOp::Lt => x < y,
                        CompareOp::Le => x <= y,
                        CompareOp::Gt => x > y,
                        CompareOp::Ge => x >= y,
                    });
                }
                let (op, first, second) = match op {
                    CompareOp::Gt => (CompareOp::Lt, b, a),
                    CompareOp::Ge => (CompareOp::Le, b, a),
                    op => (op, a, b),
                };
                let mut is = |op| {
                    let of = vec![Value::Float(first, None), Value::Float(second, None)];
                    let symbol = self.made(Origin::Compare(op), of, (0, 1));
                    self.compared.insert(symbol, (op, first, second));
                    Formula::Is(symbol, true)
                };
                match op {
                    // `a < b` implies `a <= b`.
                    CompareOp::Lt => Formula::All(vec![is(CompareOp::Lt), is(CompareOp::Le)]),
                    CompareOp::Ne => is(CompareOp::Eq).not(),
                    op => is(op),
                }
            }
            _ => Formula::Is(self.fresh((0, 1)), true),
        }
    }

    pub(super) fn cast(
        &mut self,
        point: &mut Point,
        x: &Expr,
        value: Value,
        ty: &Type,
    ) -> Option<Value> {
        let Some(int) = ty.as_int() else {
            let Value::Float(_, Some(bits)) = value else {
                let limits = match &value {
                    // The symbol is the same elsewhere: nothing that holds here alone counts.
                    Value::Number(form) if x.ty.as_int().is_some() => {
                        let bounds = self.range(&Point::default(), form);
                        Some(Self::limits_of_number(bounds, ty))
                    }
                    Value::Float(..) => Some(self.limits_of_float(&value, ty)),
                    _ => None,
                };
                let made = self.opaque(Origin::Cast(ty.clone()), vec![value], ty);
                return self.limited(made, limits);
            };
            return Some(match ty.as_float()? {
                Float::F32 => self.float(f64::from(f64::from_bits(bits) as f32)),
                Float::F64 => self.float(f64::from_bits(bits)),
            });
        };
        match (&value, &x.ty) {
            (Value::Number(form), Type::Enum(id)) => {
                let number = self.variant_number(point, form, *id, int);
                Some(Value::Number(number))
            }
            (Value::Number(form), _) => {
                let (low, high) = self.range(point, form);
                if int.min() <= low && high <= int.max() {
                    return Some(value);
                }
                let symbol = self.made(Origin::Cast(ty.clone()), vec![value], bounds_of(int));
                Some(Value::Number(Linear::symbol(symbol)))
            }
            (Value::Truth(formula), _) => {
                let is = |truth| point.knowledge.shows(&truth, &self.all);
                if is(formula.clone()) {
                    return Some(Value::Number(Linear::number(1)));
                }
                if is(formula.not()) {
                    return Some(Value::Number(Linear::number(0)));
                }
                let origin = Origin::Cast(Type::BOOL);
                Some(Value::Number(Linear::symbol(self.made(origin, vec![value], (0, 1)))))
            }
            (Value::Float(..), _) => {
                let bounds = self.limits_here(point, &value).numbers(int);
                let symbol = self.made(Origin::Cast(ty.clone()), vec![value], bounds_of(int));
                point.knowledge.refine(symbol, bounds, &self.all);
                Some(Value::Number(Linear::symbol(symbol)))
            }
        }
    }

    /// Returns the number of a variant from its index; an invalid one may have any number.
    fn variant_number(
        &mut self,
        point: &mut Point,
        index: &Linear,
        id: EnumId,
        int: Int,
    ) -> Linear {
        let numbers: Vec<i128> =
            self.module.enums[id.index()].variants.iter().map(|it| it.value.into()).collect();
        let (low, high) = self.range(point, index);
        let all = bounds_of(int);
        let reached = numbers.iter().skip(low.max(0) as usize).take((high - low + 1) as usize);
        let fits = reached.clone().all(|it| all.0 <= *it && *it <= all.1);
        let is_variant = high < numbers.len() as i128;
        if is_variant && fits && (0i128..).zip(&numbers).all(|(at, number)| at == *number) {
            return index.clone();
        }
        let origin = Origin::Cast(Type::Scalar(Scalar::Int(int)));
        let symbol = self.made(origin, vec![Value::Number(index.clone())], all);
        let number = Linear::symbol(symbol);
        if fits {
            // One alternative for each variant; one for what is none.
            let equal = |a: &Linear, b: i128| ordered(CompareOp::Eq, a, &Linear::number(b));
            let one = |(at, value): (i128, &i128)| {
                Some(Formula::All(vec![equal(index, at)?, equal(&number, *value)?]))
            };
            let mut any: Vec<Formula> = (low.max(0)..).zip(reached).filter_map(one).collect();
            any.extend(equal(index, numbers.len() as i128));
            point.knowledge.assume(&Formula::Any(any), &self.all);
            if is_variant {
                let reached = &numbers[low as usize..=high as usize];
                let (low, high) = (reached.iter().min(), reached.iter().max());
                if let (Some(low), Some(high)) = (low, high) {
                    point.knowledge.refine(symbol, (*low, *high), &self.all);
                }
            }
        }
        number
    }

    pub(super) fn binary(
        &mut self,
        point: &mut Point,
        op: BinaryOp,
        a: &Expr,
        values: (Option<Value>, Option<Value>),
        expr: &Expr,
    ) -> Option<Value> {
        let int = match (&values, expr.ty.as_int()) {
            ((Some(Value::Number(_)), Some(Value::Number(_))), Some(int)) => int,
            ((Some(Value::Float(_, Some(x))), Some(Value::Float(_, Some(y)))), _) => {
                let (x, y) = (f64::from_bits(*x), f64::from_bits(*y));
                let exact = match op {
                    BinaryOp::Add => x + y,
                    BinaryOp::Sub => x - y,
                    BinaryOp::Mul => x * y,
                    BinaryOp::Div => x / y,
                    _ => return self.unknown(&expr.ty),
                };
                // Rounding a double result once more gives that of single precision.
                return Some(match expr.ty.as_float() {
                    Some(Float::F32) => self.float(f64::from(exact as f32)),
                    _ => self.float(exact),
                });
            }
            ((Some(Value::Truth(x)), Some(Value::Truth(y))), _) => {
                let (x, y) = (x.clone(), y.clone());
                return Some(Value::Truth(match op {
                    BinaryOp::And => Formula::All(vec![x, y]),
                    BinaryOp::Or => Formula::Any(vec![x, y]),
                    _ => Formula::Any(vec![
                        Formula::All(vec![x.clone(), y.not()]),
                        Formula::All(vec![x.not(), y]),
                    ]),
                }));
            }
            _ => {
                let limits = match &values {
                    (Some(a), Some(b)) => self.limits_of_binary(op, [a, b], &expr.ty),
                    _ => None,
                };
                let of = [values.0, values.1].into_iter().flatten().collect();
                let made = self.opaque(Origin::Binary(op, expr.ty.clone()), of, &expr.ty);
                return self.limited(made, limits);
            }
        };
        let (Some(Value::Number(x)), Some(Value::Number(y))) = values else { return None };
        let exact = match op {
            BinaryOp::Add => x.plus(1, &y),
            BinaryOp::Sub => x.minus(&y),
            BinaryOp::Mul => {
                let by = |form: &Linear, other: &Linear| form.times(self.single(point, other)?);
                by(&x, &y).or_else(|| by(&y, &x))
            }
            _ => None,
        };
        let exact = match op {
            BinaryOp::Mul if exact.is_none() => {
                let (p, q) = (self.range(point, &x), self.range(point, &y));
                let of = vec![Value::Number(x.clone()), Value::Number(y.clone())];
                let symbol = self.made(Origin::Product, of, (-FURTHEST, FURTHEST));
                // A product beyond `FURTHEST` faults, and the condition below tells of it.
                let (least, most) = product(p, q);
                if -FURTHEST <= least && most <= FURTHEST {
                    point.knowledge.refine(symbol, (least, most), &self.all);
                }
                Some(Linear::symbol(symbol))
            }
            _ => exact,
        };
        match op {
            BinaryOp::Add | BinaryOp::Sub => {
                self.need_within(point, exact.as_ref(), bounds_of(int), Site::of_expr(expr));
            }
            BinaryOp::Mul => {
                self.need_product(point, (&x, &y), exact.as_ref(), int, Site::of_expr(expr))
            }
            BinaryOp::Div | BinaryOp::Rem => {
                self.need_quotient(point, (&x, &y), int, Site::of_expr(expr))
            }
            BinaryOp::Shl | BinaryOp::Shr => {
                let bits = i128::from(a.ty.as_int().map_or(0, Int::bits));
                self.need_within(point, Some(&y), (0, bits - 1), Site::of_expr(expr));
            }
            BinaryOp::And | BinaryOp::Or | BinaryOp::Xor => {}
        }
        if let Some(exact) = exact {
            if let [(symbol, 1)] = exact.parts[..]
                && exact.constant == 0
            {
                point.knowledge.refine(symbol, bounds_of(int), &self.all);
            }
            return Some(Value::Number(exact));
        }
        let (p, q) = (self.range(point, &x), self.range(point, &y));
        // What was computed before is within its type.
        let p = (p.0.max(int.min()), p.1.min(int.max()));
        let found = operation(op, p, q, bounds_of(int));
        let of = vec![Value::Number(x.clone()), Value::Number(y.clone())];
        let symbol = self.made(Origin::Binary(op, expr.ty.clone()), of, bounds_of(int));
        point.knowledge.refine(symbol, found, &self.all);
        let halves = op == BinaryOp::Div && q == (2, 2) || op == BinaryOp::Shr && q == (1, 1);
        if halves && p.0 >= 0 {
            self.halved(point, &x, &Linear::symbol(symbol));
        }
        Some(Value::Number(Linear::symbol(symbol)))
    }

    /// Adds the facts about half of a natural number: it is less, unless both are 0. Half of a sum of two numbers is
    /// between them, and less than the larger.
    fn halved(&self, point: &mut Point, whole: &Linear, half: &Linear) {
        let below = |a: &Linear, b: &Linear, by: i128| {
            b.minus(a).and_then(|it| it.shifted(-by)).map(Formula::Natural)
        };
        let shows = |fact: &Option<Formula>| {
            fact.as_ref().is_some_and(|fact| point.knowledge.shows(fact, &self.all))
        };
        let mut facts = Vec::new();
        let zero = Linear::number(0);
        let by = i128::from(shows(&below(&zero, whole, 1)));
        facts.push(below(half, whole, by));
        if let [(a, 1), (b, 1)] = whole.parts[..]
            && whole.constant == 0
        {
            let (a, b) = (Linear::symbol(a), Linear::symbol(b));
            for (low, high) in [(&a, &b), (&b, &a)] {
                if shows(&below(low, high, 0)) {
                    let by = i128::from(shows(&below(low, high, 1)));
                    facts.extend([below(low, half, 0), below(half, high, by)]);
                }
            }
        }
        for fact in facts.into_iter().flatten() {
            point.knowledge.assume(&fact, &self.all);
        }
    }

    /// Requires that the product is within its type: by its form, by its bounds, or by a check with a division.
    fn need_product(
        &mut self,
        point: &Point,
        (x, y): (&Linear, &Linear),
        exact: Option<&Linear>,
        int: Int,
        site: Site,
    ) {
        if self.quiet {
            return;
        }
        let (low, high) = bounds_of(int);
        let (p, q) = (self.range(point, x), self.range(point, y));
        let (least, most) = product(p, q);
        let by_value = exact.and_then(|form| within(form, (low, high)));
        if low <= least && most <= high
            || by_value.is_some_and(|needed| point.knowledge.shows(&needed, &self.all))
        {
            return;
        }
        // x · y <= high, of two above 0, if x <= high / y; and so for each pair of signs.
        let ty = Type::Scalar(Scalar::Int(int));
        let mut quotient = |limit: i128, by: &Linear| {
            let of = vec![Value::Number(Linear::number(limit)), Value::Number(by.clone())];
            Linear::symbol(self.made(Origin::Binary(BinaryOp::Div, ty.clone()), of, (low, high)))
        };
        let above = |form: &Linear| form.shifted(-1).map(Formula::Natural);
        let beneath = |form: &Linear| Some(Formula::Natural(form.below()));
        let natural = |form: Option<Linear>| form.map(Formula::Natural);
        let mut cases = vec![(above(x), above(y), natural(quotient(high, y).minus(x)))];
        if low < 0 {
            cases.push((above(x), beneath(y), natural(y.minus(&quotient(low, x)))));
            cases.push((beneath(x), above(y), natural(x.minus(&quotient(low, y)))));
            cases.push((beneath(x), beneath(y), natural(y.minus(&quotient(high, x)))));
        }
        let shown = cases.iter().all(|case| {
            let (Some(first), Some(second), Some(fits)) = case else { return false };
            let mut knowledge = point.knowledge.assuming(first, &self.all);
            knowledge.assume(second, &self.all);
            knowledge.shows(fits, &self.all)
        });
        if !Rule::Product.told(shown) {
            self.tell(site);
        }
    }

    /// Requires that the divisor is not 0, and for signed numbers that the least is not divided by -1.
    fn need_quotient(&mut self, point: &Point, (x, y): (&Linear, &Linear), int: Int, site: Site) {
        let not =
            |form: &Linear, number: i128| ordered(CompareOp::Ne, form, &Linear::number(number));
        match not(y, 0) {
            Some(needed) => self.need(point, &needed, site),
            None => self.tell(site),
        }
        if int.signed() {
            match (not(x, int.min()), not(y, -1)) {
                (Some(a), Some(b)) => self.need(point, &Formula::Any(vec![a, b]), site),
                _ => self.tell(site),
            }
        }
    }

    pub(super) fn intrinsic(
        &mut self,
        point: &mut Point,
        which: Intrinsic,
        values: Vec<Value>,
        expr: &Expr,
    ) -> Option<Value> {
        let forms: Vec<Linear> = values
            .iter()
            .filter_map(|value| match value {
                Value::Number(form) => Some(form.clone()),
                _ => None,
            })
            .collect();
        if let (Intrinsic::Clamp, [_, low, high]) = (which, values.as_slice()) {
            let values = (Some(low.clone()), Some(high.clone()));
            let needed = self.compare(point, CompareOp::Le, &expr.ty, values);
            self.need(point, &needed, Site::of_expr(expr));
        }
        let all = match &expr.ty {
            Type::Scalar(Scalar::Int(int)) => bounds_of(*int),
            Type::Enum(id) => (0, self.variants(*id) - 1),
            _ => {
                let limits = self.limits_of_intrinsic(which, &values);
                let made = self.opaque(Origin::Intrinsic(which, expr.ty.clone()), values, &expr.ty);
                return self.limited(made, limits);
            }
        };
        if forms.len() != values.len() || forms.is_empty() {
            return self.opaque(Origin::Intrinsic(which, expr.ty.clone()), values, &expr.ty);
        }
        let int = expr.ty.as_int();
        let within = |it: Bounds| all.0 <= it.0 && it.1 <= all.1;
        let x = &forms[0];
        let p = self.range(point, x);
        let y = forms.get(1);
        let q = y.map_or((0, 0), |y| self.range(point, y));
        let exact = match which {
            Intrinsic::Abs | Intrinsic::UnsignedAbs if p.0 >= 0 => Some(x.clone()),
            Intrinsic::WrappingAdd | Intrinsic::SaturatingAdd => y.and_then(|y| x.plus(1, y)),
            Intrinsic::WrappingSub | Intrinsic::SaturatingSub => y.and_then(|y| x.minus(y)),
            Intrinsic::Variant if p.1 <= all.1 => Some(x.clone()),
            _ => None,
        };
        match (which, int) {
            (Intrinsic::Abs, Some(int)) => {
                let needed = x.times(-1);
                self.need_within(
                    point,
                    needed.as_ref(),
                    (i128::MIN / 4, int.max()),
                    Site::of_expr(expr),
                );
            }
            (Intrinsic::WrappingDiv | Intrinsic::WrappingRem, _) => {
                let needed = y.and_then(|y| ordered(CompareOp::Ne, y, &Linear::number(0)));
                match needed {
                    Some(needed) => self.need(point, &needed, Site::of_expr(expr)),
                    None => self.tell(Site::of_expr(expr)),
                }
            }
            (Intrinsic::DivEuclid | Intrinsic::RemEuclid, Some(int)) => {
                if let Some(y) = y {
                    self.need_quotient(point, (x, y), int, Site::of_expr(expr));
                }
            }
            _ => {}
        }
        if let Some(exact) = exact.filter(|exact| within(self.range(point, exact))) {
            return Some(Value::Number(exact));
        }
        let found = match which {
            Intrinsic::Min => (p.0.min(q.0), p.1.min(q.1)),
            Intrinsic::Max => (p.0.max(q.0), p.1.max(q.1)),
            Intrinsic::Clamp => {
                let top = self.range(point, &forms[2]);
                (p.0.max(q.0).min(top.0), p.1.max(q.1).min(top.1))
            }
            Intrinsic::SaturatingAdd => (p.0 + q.0, p.1 + q.1),
            Intrinsic::SaturatingSub => (p.0 - q.1, p.1 - q.0),
            Intrinsic::SaturatingMul => product(p, q),
            Intrinsic::WrappingMul if within(product(p, q)) => product(p, q),
            Intrinsic::Abs | Intrinsic::UnsignedAbs => {
                (p.0.max(-p.1).max(0), p.1.abs().max(p.0.abs()))
            }
            Intrinsic::AbsDiff => (0, (p.1 - q.0).abs().max((q.1 - p.0).abs())),
            Intrinsic::RemEuclid => (0, q.0.abs().max(q.1.abs()) - 1),
            Intrinsic::CountOnes | Intrinsic::LeadingZeros | Intrinsic::TrailingZeros => {
                let counted = match &expr.kind {
                    bessemer_ir::ExprKind::Intrinsic(_, of) => {
                        of.first().and_then(|it| it.ty.as_int())
                    }
                    _ => None,
                };
                (0, counted.map_or(64, |int| int.bits().into()))
            }
            _ => all,
        };
        let found = (found.0.clamp(all.0, all.1), found.1.clamp(all.0, all.1));
        let symbol = self.made(Origin::Intrinsic(which, expr.ty.clone()), values, all);
        point.knowledge.refine(symbol, found, &self.all);
        let form = Linear::symbol(symbol);
        if let (Intrinsic::Min | Intrinsic::Max, Some(y)) = (which, y) {
            // It is no more than both, and one of them; of the larger the other way round.
            let less = which == Intrinsic::Min;
            let order = |a: &Linear, b: &Linear| {
                let form = if less { b.minus(a) } else { a.minus(b) };
                form.map(Formula::Natural)
            };
            let both = [order(&form, x), order(&form, y)];
            both.into_iter().flatten().for_each(|it| point.knowledge.assume(&it, &self.all));
            if let (Some(a), Some(b)) = (order(x, &form), order(y, &form)) {
                point.knowledge.assume(&Formula::Any(vec![a, b]), &self.all);
            }
        }
        Some(Value::Number(form))
    }
}

fn product(p: Bounds, q: Bounds) -> Bounds {
    let all = [(p.0, q.0), (p.0, q.1), (p.1, q.0), (p.1, q.1)];
    let all = all.map(|(a, b)| a.saturating_mul(b));
    (all.into_iter().min().unwrap_or(i128::MIN), all.into_iter().max().unwrap_or(i128::MAX))
}

/// Returns the bounds of an operation that does not fault, from the bounds of its operands.
fn operation(op: BinaryOp, p: Bounds, q: Bounds, all: Bounds) -> Bounds {
    let natural = p.0 >= 0 && q.0 >= 0;
    let furthest = p.0.abs().max(p.1.abs());
    let found = match op {
        BinaryOp::Mul => product(p, q),
        // No further from 0 than what is divided; between the ends, if the divisor is on one side of 0.
        BinaryOp::Div if q.0 > 0 || q.1 < 0 => {
            let ends = [p.0 / q.0, p.0 / q.1, p.1 / q.0, p.1 / q.1];
            let least = ends.into_iter().min().unwrap_or(-furthest);
            (least, ends.into_iter().max().unwrap_or(furthest))
        }
        BinaryOp::Div => (-furthest, furthest),
        // Nearer to 0 than the divisor, no further than what is divided, and on its side.
        BinaryOp::Rem => {
            let most = (q.0.abs().max(q.1.abs()) - 1).max(0);
            let low = if p.0 < 0 { -most.min(-p.0) } else { 0 };
            (low, if p.1 > 0 { most.min(p.1) } else { 0 })
        }
        BinaryOp::And if natural => (0, p.1.min(q.1)),
        BinaryOp::And if p.0 >= 0 => (0, p.1),
        BinaryOp::And if q.0 >= 0 => (0, q.1),
        BinaryOp::Or | BinaryOp::Xor if natural => {
            let bits = 128 - p.1.max(q.1).leading_zeros();
            (0, (1 << bits) - 1)
        }
        BinaryOp::Shl => {
            let (least, most) = (q.0.clamp(0, 63), q.1.clamp(0, 63));
            let shifted = product(p, (1 << least, 1 << most));
            if all.0 <= shifted.0 && shifted.1 <= all.1 { shifted } else { all }
        }
        BinaryOp::Shr => {
            let (least, most) = (q.0.clamp(0, 63), q.1.clamp(0, 63));
            let ends = [p.0 >> least, p.0 >> most, p.1 >> least, p.1 >> most];
            (ends.into_iter().min().unwrap_or(all.0), ends.into_iter().max().unwrap_or(all.1))
        }
        _ => all,
    };
    (found.0.max(all.0), found.1.min(all.1))
}
