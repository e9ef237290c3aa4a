//! Values of expressions, and what their operations need.
//!
//! The meaning: in an execution at the point, in which nothing has faulted yet, the expression has this value. What an
//! operation needs is told before its value is made; behind it, it has not faulted, so its result is the exact one.

use std::collections::HashMap;

use bessemer_ir::{
    BinaryOp, CompareOp, EnumId, Expr, ExprKind, Float, Function, FunctionId, Int, Intrinsic,
    LocalId, LogicOp, Module, Place, Scalar, Step, Type, UnaryOp,
};

use super::knowledge::{Bounds, Formula, Knowledge};
use super::linear::{FURTHEST, Linear, Symbol};
use crate::passes::sites::Site;

/// The value of a word.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(super) enum Value {
    /// An integer, or the index of a variant; of an enum that is none, the number of its variants.
    Number(Linear),
    Truth(Formula),
    /// A float: its bits if they are known, widened to double precision.
    Float(Symbol, Option<u64>),
}

/// What makes a symbol: the same operation on the same values gives the same symbol.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
enum Origin {
    Float(u64),
    Unary(UnaryOp, Type),
    Binary(BinaryOp, Type),
    /// The exact product, whatever its type.
    Product,
    Compare(CompareOp),
    Cast(Type),
    Intrinsic(Intrinsic, Type),
    /// A call of a function without effects, as it is written, while nothing is written.
    Call(String, u32),
}

/// A step into a value, its indices as values.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum At {
    Field(u32),
    Index(Vec<Linear>),
}

/// What each place is known to hold, and what is known of it.
#[derive(Clone, Default)]
pub(super) struct Point {
    pub(super) knowledge: Knowledge,
    pub(super) places: HashMap<LocalId, Vec<(Vec<At>, Value)>>,
    /// Changes with every write.
    pub(super) version: u32,
}

/// The symbols of a function.
pub(super) struct Values<'m> {
    pub(super) module: &'m Module,
    pub(super) function: &'m Function,
    /// The bounds of each symbol by its type.
    pub(super) all: Vec<Bounds>,
    origins: HashMap<(Origin, Vec<Value>), Symbol>,
    pub(super) versions: u32,
    /// The operations that may fault.
    pub(super) open: Vec<Site>,
    /// Whether that is told later.
    pub(super) quiet: bool,
}

fn bounds_of(int: Int) -> Bounds {
    (int.min(), int.max())
}

impl<'m> Values<'m> {
    pub(super) fn new(module: &'m Module, function: &'m Function) -> Values<'m> {
        let (all, origins, open) = (Vec::new(), HashMap::new(), Vec::new());
        Values { module, function, all, origins, versions: 0, open, quiet: false }
    }

    /// A symbol of which nothing is known but its bounds.
    pub(super) fn fresh(&mut self, bounds: Bounds) -> Symbol {
        self.all.push((bounds.0.max(-FURTHEST), bounds.1.min(FURTHEST)));
        Symbol(self.all.len() as u32 - 1)
    }

    pub(super) fn next_version(&mut self) -> u32 {
        self.versions += 1;
        self.versions
    }

    fn made(&mut self, origin: Origin, of: Vec<Value>, bounds: Bounds) -> Symbol {
        if let Some(symbol) = self.origins.get(&(origin.clone(), of.clone())) {
            return *symbol;
        }
        let symbol = self.fresh(bounds);
        self.origins.insert((origin, of), symbol);
        symbol
    }

    fn variants(&self, id: EnumId) -> i128 {
        self.module.enums[id.index()].variants.len() as i128
    }

    /// A value of a type of which nothing is known.
    pub(super) fn unknown(&mut self, ty: &Type) -> Option<Value> {
        Some(match ty {
            Type::Scalar(Scalar::Int(int)) => {
                Value::Number(Linear::symbol(self.fresh(bounds_of(*int))))
            }
            Type::Enum(id) => {
                let bounds = (0, self.variants(*id));
                Value::Number(Linear::symbol(self.fresh(bounds)))
            }
            Type::Scalar(Scalar::Bool) => Value::Truth(Formula::Is(self.fresh((0, 1)), true)),
            Type::Scalar(Scalar::Float(_)) => Value::Float(self.fresh((0, 0)), None),
            _ => return None,
        })
    }

    /// What an operation gives of which nothing but its type is known: the same for the same operands.
    fn opaque(&mut self, origin: Origin, of: Vec<Value>, ty: &Type) -> Option<Value> {
        Some(match ty {
            Type::Scalar(Scalar::Int(int)) => {
                Value::Number(Linear::symbol(self.made(origin, of, bounds_of(*int))))
            }
            Type::Enum(id) => {
                let bounds = (0, self.variants(*id));
                Value::Number(Linear::symbol(self.made(origin, of, bounds)))
            }
            Type::Scalar(Scalar::Bool) => {
                Value::Truth(Formula::Is(self.made(origin, of, (0, 1)), true))
            }
            Type::Scalar(Scalar::Float(_)) => Value::Float(self.made(origin, of, (0, 0)), None),
            _ => return None,
        })
    }

    /// Tells of a place where what is needed does not show.
    pub(super) fn need(&mut self, point: &Point, needed: &Formula, site: Site) {
        if !self.quiet && !point.knowledge.shows(needed, &self.all) {
            self.open.push(site);
        }
    }

    fn tell(&mut self, site: Site) {
        if !self.quiet {
            self.open.push(site);
        }
    }

    fn need_within(&mut self, point: &Point, form: Option<&Linear>, bounds: Bounds, site: Site) {
        match form.and_then(|form| within(form, bounds)) {
            Some(needed) => self.need(point, &needed, site),
            None => self.tell(site),
        }
    }

    fn range(&self, point: &Point, form: &Linear) -> Bounds {
        point.knowledge.range(form, &self.all)
    }

    /// The number, also where only its bounds tell.
    fn single(&self, point: &Point, form: &Linear) -> Option<i128> {
        let (low, high) = self.range(point, form);
        (low == high).then_some(low)
    }

    pub(super) fn number(&mut self, point: &mut Point, expr: &Expr) -> Linear {
        match self.value(point, expr) {
            Some(Value::Number(form)) => form,
            _ => Linear::symbol(self.fresh((-FURTHEST, FURTHEST))),
        }
    }

    pub(super) fn truth(&mut self, point: &mut Point, expr: &Expr) -> Formula {
        match self.value(point, expr) {
            Some(Value::Truth(formula)) => formula,
            _ => Formula::Is(self.fresh((0, 1)), true),
        }
    }

    /// The value of an expression; nothing of what has parts. Its operands are looked at from left to right.
    pub(super) fn value(&mut self, point: &mut Point, expr: &Expr) -> Option<Value> {
        match &expr.kind {
            ExprKind::Literal(word) => self.literal(&expr.ty, *word),
            ExprKind::Const(id) => {
                let word = *self.module.consts.get(id.index())?.words.first()?;
                if expr.ty.is_word() { self.literal(&expr.ty, word) } else { None }
            }
            ExprKind::Load(place) => {
                let at = self.steps(point, place);
                self.load(point, place.root, at, &expr.ty)
            }
            ExprKind::Unary(op, x) => self.unary(point, *op, x, expr),
            ExprKind::Binary(op, a, b) => {
                let values = (self.value(point, a), self.value(point, b));
                self.binary(point, *op, a, values, expr)
            }
            ExprKind::Compare(op, a, b) => {
                let values = (self.value(point, a), self.value(point, b));
                Some(Value::Truth(self.compare(point, *op, &a.ty, values)))
            }
            ExprKind::Logic(op, a, b) => {
                let first = self.truth(point, a);
                let reached = if *op == LogicOp::And { first.clone() } else { first.not() };
                let mut within = point.clone();
                within.knowledge.assume(&reached, &self.all);
                let second = self.truth(&mut within, b);
                // What was read on the way is the same here.
                point.places = within.places;
                let parts = vec![first, second];
                Some(Value::Truth(match op {
                    LogicOp::And => Formula::All(parts),
                    LogicOp::Or => Formula::Any(parts),
                }))
            }
            ExprKind::Cast(x) => {
                let value = self.value(point, x)?;
                self.cast(point, x, value, &expr.ty)
            }
            ExprKind::Intrinsic(which, parts) => {
                let values: Vec<Value> =
                    parts.iter().filter_map(|it| self.value(point, it)).collect();
                self.intrinsic(point, *which, values, expr)
            }
            ExprKind::Call(id, arguments) => {
                for argument in arguments {
                    match argument {
                        bessemer_ir::Argument::Value(value) | bessemer_ir::Argument::Ref(value) => {
                            self.value(point, value);
                        }
                        bessemer_ir::Argument::RefMut(place) => {
                            self.steps(point, place);
                        }
                    }
                }
                self.call(point, *id, expr)
            }
            ExprKind::Struct(parts)
            | ExprKind::Array(parts)
            | ExprKind::Matrix(parts)
            | ExprKind::Routine(_, parts) => {
                parts.iter().for_each(|part| {
                    self.value(point, part);
                });
                self.unknown(&expr.ty)
            }
            ExprKind::Splat(part) => {
                self.value(point, part);
                None
            }
        }
    }

    fn literal(&mut self, ty: &Type, word: u64) -> Option<Value> {
        Some(match ty {
            Type::Scalar(Scalar::Int(int)) => Value::Number(Linear::number(int.from_word(word))),
            Type::Scalar(Scalar::Bool) => Value::Truth(Formula::constant(word != 0)),
            Type::Scalar(Scalar::Float(float)) => self.float(match float {
                Float::F32 => f64::from(f32::from_bits(word as u32)),
                Float::F64 => f64::from_bits(word),
            }),
            Type::Enum(_) => Value::Number(Linear::number(i128::from(word))),
            _ => return None,
        })
    }

    fn float(&mut self, value: f64) -> Value {
        let bits = value.to_bits();
        let symbol = self.made(Origin::Float(bits), Vec::new(), (0, 0));
        Value::Float(symbol, (!value.is_nan()).then_some(bits))
    }

    /// What has no effect gives the same again until something is written.
    fn call(&mut self, point: &Point, id: FunctionId, expr: &Expr) -> Option<Value> {
        let callee = &self.module.functions[id.index()];
        let reads = callee.parameters().iter().all(|it| it.mode != bessemer_ir::Mode::RefMut);
        let unknown = self.unknown(&expr.ty)?;
        if !reads || callee.attributes.external.is_some() {
            return Some(unknown);
        }
        let bounds = match &unknown {
            Value::Number(form) => self.range(point, form),
            _ => (0, 1),
        };
        let written = format!("{:?}", crate::passes::places::erased(expr));
        let symbol = self.made(Origin::Call(written, point.version), Vec::new(), bounds);
        Some(match unknown {
            Value::Number(_) => Value::Number(Linear::symbol(symbol)),
            Value::Truth(_) => Value::Truth(Formula::Is(symbol, true)),
            Value::Float(..) => Value::Float(symbol, None),
        })
    }

    /// The steps of a place, and what its indices need.
    pub(super) fn steps(&mut self, point: &mut Point, place: &Place) -> Vec<At> {
        let mut container = Some(self.function.local(place.root).ty.clone());
        let mut all = Vec::new();
        for step in &place.steps {
            let at = match step {
                Step::Field(field) => At::Field(*field),
                Step::Index(index) | Step::From(index) => {
                    At::Index(vec![self.number(point, index)])
                }
                Step::Element(row, column) => {
                    At::Index(vec![self.number(point, row), self.number(point, column)])
                }
            };
            let more = i128::from(matches!(step, Step::From(_)));
            if let (At::Index(indices), Some(container)) = (&at, &container) {
                let site = Site::of_step(step, place.span);
                match container {
                    Type::Array { len, .. } => {
                        let last = i128::from(*len) - 1 + more;
                        self.need_within(point, indices.first(), (0, last), site);
                    }
                    Type::Matrix { rows, cols, .. } => {
                        let most = match indices.len() {
                            1 => vec![i128::from(*rows) * i128::from(*cols) + more],
                            _ => vec![i128::from(*rows), i128::from(*cols)],
                        };
                        for (index, most) in indices.iter().zip(most) {
                            self.need_within(point, Some(index), (0, most - 1), site);
                        }
                    }
                    Type::Slice(_) => {
                        let length = LocalId(place.root.0 + 1);
                        let length = self.load(point, length, Vec::new(), &Type::USIZE);
                        if let (Some(Value::Number(length)), Some(index)) =
                            (length, indices.first())
                        {
                            let room = length.minus(index).and_then(|it| it.shifted(more - 1));
                            self.need_within(point, Some(index), (0, FURTHEST), site);
                            self.need_within(point, room.as_ref(), (0, FURTHEST), site);
                        }
                    }
                    _ => {}
                }
            }
            container =
                container.and_then(|it| crate::passes::faults::step_type(self.module, &it, step));
            all.push(at);
        }
        all
    }

    /// What a place holds.
    pub(super) fn load(
        &mut self,
        point: &mut Point,
        root: LocalId,
        at: Vec<At>,
        ty: &Type,
    ) -> Option<Value> {
        let held = point.places.get(&root).and_then(|all| all.iter().find(|(it, _)| *it == at));
        if let Some((_, value)) = held {
            return Some(value.clone());
        }
        let value = self.unknown(ty)?;
        point.places.entry(root).or_default().push((at, value.clone()));
        Some(value)
    }

    fn unary(&mut self, point: &mut Point, op: UnaryOp, x: &Expr, expr: &Expr) -> Option<Value> {
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
                self.opaque(Origin::Unary(op, expr.ty.clone()), vec![value], &expr.ty)
            }
        }
    }

    fn compare(
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
                    Formula::Is(self.made(Origin::Compare(op), of, (0, 1)), true)
                };
                match op {
                    // What is less is also not more.
                    CompareOp::Lt => Formula::All(vec![is(CompareOp::Lt), is(CompareOp::Le)]),
                    CompareOp::Ne => is(CompareOp::Eq).not(),
                    op => is(op),
                }
            }
            _ => Formula::Is(self.fresh((0, 1)), true),
        }
    }

    fn cast(&mut self, point: &mut Point, x: &Expr, value: Value, ty: &Type) -> Option<Value> {
        let Some(int) = ty.as_int() else {
            let Value::Float(_, Some(bits)) = value else {
                return self.opaque(Origin::Cast(ty.clone()), vec![value], ty);
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
                let symbol = self.made(Origin::Cast(ty.clone()), vec![value], bounds_of(int));
                Some(Value::Number(Linear::symbol(symbol)))
            }
        }
    }

    /// The number of a variant, by its index; what is none may have any.
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

    fn binary(
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
                let of = [values.0, values.1].into_iter().flatten().collect();
                return self.opaque(Origin::Binary(op, expr.ty.clone()), of, &expr.ty);
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
                // What lies further out faults, and the need below tells of it.
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
        let found = operation(op, p, q, bounds_of(int));
        let of = vec![Value::Number(x), Value::Number(y)];
        let symbol = self.made(Origin::Binary(op, expr.ty.clone()), of, bounds_of(int));
        point.knowledge.refine(symbol, found, &self.all);
        Some(Value::Number(Linear::symbol(symbol)))
    }

    /// The product lies within its type: by its value, by its bounds, or as it was checked by division.
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
        if !shown {
            self.tell(site);
        }
    }

    /// The divisor is not 0; of signed numbers the least is not divided by -1.
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

    fn intrinsic(
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
            _ => return self.opaque(Origin::Intrinsic(which, expr.ty.clone()), values, &expr.ty),
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
            Intrinsic::CountOnes | Intrinsic::LeadingZeros | Intrinsic::TrailingZeros => (0, 64),
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

/// The statement that a form lies within bounds.
pub(super) fn within(form: &Linear, (low, high): Bounds) -> Option<Formula> {
    let low = low.max(-FURTHEST);
    let high = high.min(FURTHEST);
    let above = form.shifted(-low)?;
    let below = form.times(-1)?.shifted(high)?;
    Some(Formula::All(vec![Formula::Natural(above), Formula::Natural(below)]))
}

/// A comparison of two forms.
pub(super) fn ordered(op: CompareOp, a: &Linear, b: &Linear) -> Option<Formula> {
    let natural = |form: Option<Linear>| form.map(Formula::Natural);
    let at_most = |a: &Linear, b: &Linear| natural(b.minus(a));
    Some(match op {
        CompareOp::Le => at_most(a, b)?,
        CompareOp::Ge => at_most(b, a)?,
        CompareOp::Lt => at_most(b, a)?.not(),
        CompareOp::Gt => at_most(a, b)?.not(),
        CompareOp::Eq => Formula::All(vec![at_most(a, b)?, at_most(b, a)?]),
        CompareOp::Ne => Formula::Any(vec![at_most(a, b)?.not(), at_most(b, a)?.not()]),
    })
}

fn product(p: Bounds, q: Bounds) -> Bounds {
    let all = [(p.0, q.0), (p.0, q.1), (p.1, q.0), (p.1, q.1)];
    let all = all.map(|(a, b)| a.saturating_mul(b));
    (all.into_iter().min().unwrap_or(i128::MIN), all.into_iter().max().unwrap_or(i128::MAX))
}

/// The bounds of an operation that does not fault, from those of its operands.
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
