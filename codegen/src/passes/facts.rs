//! What is known at one point of a function: ranges of places, and conditions that hold.
//!
//! The walk over the statements (of the pass, and of the checker after it) keeps a [`Facts`] up to
//! date: [`assign`](Facts::assign) and [`forget`](Facts::forget) at writes, [`assume`](Facts::assume)
//! where a condition holds, [`join`](Facts::join) where branches meet, and
//! [`enter_loop`](Facts::enter_loop), which forgets all that the body writes.
//!
//! Invariant: everything known is true whenever execution reaches the point. A condition that is known
//! reads only places that were not written since.

use std::collections::{BTreeMap, HashSet};
use std::rc::Rc;

use bessemer_ir::{
    BinaryOp, CompareOp, Expr, ExprKind, Float, Intrinsic, LocalId, LogicOp, Module, Place, Scalar,
    Span, Step, Type, UnaryOp,
};

use super::glance::{Glance, bit};
use super::places::{erased, overlap, reads, whole};
use super::ranges::Interval;

/// A local and the fields into it.
type Key = (LocalId, Vec<u32>);

/// What is known about the word at a place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Known {
    /// It lies within.
    Within(Interval),
    /// It is this float; not a NaN.
    Float(f64),
}

/// A condition that holds, and what tells it from most others at a glance.
#[derive(Clone)]
struct Fact {
    condition: Rc<Expr>,
    glance: Glance,
}

/// What is known at a point.
#[derive(Clone)]
pub(crate) struct Facts<'m> {
    module: &'m Module,
    known: BTreeMap<Key, Known>,
    hold: Vec<Fact>,
}

fn key(place: &Place) -> Option<Key> {
    let fields = place.steps.iter().map(|step| match step {
        Step::Field(field) => Some(*field),
        Step::Index(_) | Step::Element(..) | Step::From(_) => None,
    });
    Some((place.root, fields.collect::<Option<_>>()?))
}

fn place_of((root, fields): &Key) -> Place {
    Place { steps: fields.iter().map(|field| Step::Field(*field)).collect(), ..whole(*root) }
}

impl<'m> Facts<'m> {
    pub(crate) fn new(module: &'m Module) -> Facts<'m> {
        Facts { module, known: BTreeMap::new(), hold: Vec::new() }
    }

    /// The module that types and constants are looked up in.
    pub(crate) fn module(&self) -> &'m Module {
        self.module
    }

    /// All values of a word type; floats have no interval.
    pub(crate) fn all(&self, ty: &Type) -> Option<Interval> {
        match ty {
            Type::Scalar(Scalar::Bool) => Some(Interval::BOOL),
            Type::Scalar(Scalar::Int(int)) => Some(Interval::of(*int)),
            Type::Enum(id) => {
                let variants = self.module.enums.get(id.index())?.variants.len() as i128;
                Some(Interval::new(0, (variants - 1).max(0)))
            }
            _ => None,
        }
    }

    /// The range of an integer, `bool` or enum; of anything else, nothing useful.
    pub(crate) fn range(&self, expr: &Expr) -> Interval {
        let all = self.all(&expr.ty).unwrap_or(Interval::new(i128::MIN, i128::MAX));
        self.result(expr, all)
    }

    fn result(&self, expr: &Expr, all: Interval) -> Interval {
        match &expr.kind {
            ExprKind::Literal(word) => self.word(&expr.ty, *word).unwrap_or(all),
            ExprKind::Const(id) => {
                let word = self.module.consts.get(id.index()).and_then(|c| c.words.first());
                word.and_then(|word| self.word(&expr.ty, *word)).unwrap_or(all)
            }
            ExprKind::Load(place) => match key(place).and_then(|key| self.known.get(&key)) {
                Some(Known::Within(interval)) => *interval,
                _ => all,
            },
            ExprKind::Unary(UnaryOp::Not, x) => self.range(x).not(all),
            ExprKind::Unary(UnaryOp::Neg, x) => all.meet(Interval::one(0).sub(self.range(x))),
            ExprKind::Binary(op, a, b) => self.range(a).binary(*op, self.range(b), all),
            ExprKind::Compare(op, a, b) => self.compare(*op, a, b),
            ExprKind::Logic(op, a, b) => {
                let (a, b) = (self.range(a), self.range(b));
                if *op == LogicOp::And { a.min(b) } else { a.max(b) }
            }
            ExprKind::Cast(x) => {
                let from = self.all(&x.ty).map_or(all, |_| self.number(x));
                if from.within(all) { from } else { all }
            }
            ExprKind::Intrinsic(which, args) => {
                let args: Vec<Interval> = args.iter().map(|arg| self.range(arg)).collect();
                Interval::intrinsic(*which, &args, all)
            }
            _ => all,
        }
    }

    /// What a word type is as a number: an enum has those of its variants.
    fn number(&self, expr: &Expr) -> Interval {
        let range = self.range(expr);
        let Type::Enum(id) = expr.ty else { return range };
        let (Ok(low), Ok(high)) = (usize::try_from(range.low), usize::try_from(range.high)) else {
            return range;
        };
        match self.module.enums.get(id.index()).and_then(|it| it.values(low..=high)) {
            Some((low, high)) => Interval::new(low.into(), high.into()),
            None => range,
        }
    }

    fn word(&self, ty: &Type, word: u64) -> Option<Interval> {
        match ty {
            Type::Scalar(Scalar::Int(int)) => Some(Interval::one(int.from_word(word))),
            Type::Scalar(Scalar::Bool) | Type::Enum(_) => Some(Interval::one(i128::from(word))),
            _ => None,
        }
    }

    fn compare(&self, op: CompareOp, a: &Expr, b: &Expr) -> Interval {
        if a.ty.as_float().is_none() {
            return self.range(a).compare(op, self.range(b));
        }
        let (Some(a), Some(b)) = (self.float(a), self.float(b)) else { return Interval::BOOL };
        Interval::one(i128::from(match op {
            CompareOp::Eq => a == b,
            CompareOp::Ne => a != b,
            CompareOp::Lt => a < b,
            CompareOp::Le => a <= b,
            CompareOp::Gt => a > b,
            CompareOp::Ge => a >= b,
        }))
    }

    /// The value of a float expression where it is constant; never a NaN.
    fn float(&self, expr: &Expr) -> Option<f64> {
        let float = expr.ty.as_float()?;
        let value = match &expr.kind {
            ExprKind::Literal(word) => float_of(float, *word),
            ExprKind::Const(id) => {
                float_of(float, *self.module.consts.get(id.index())?.words.first()?)
            }
            ExprKind::Load(place) => match self.known.get(&key(place)?)? {
                Known::Float(value) => *value,
                Known::Within(_) => return None,
            },
            ExprKind::Unary(UnaryOp::Neg, x) => -self.float(x)?,
            ExprKind::Binary(op, a, b) => {
                round(float, operate(*op, self.float(a)?, self.float(b)?)?)
            }
            ExprKind::Cast(x) => round(float, self.float(x)?),
            _ => return None,
        };
        (!value.is_nan()).then_some(value)
    }

    /// What is known about a value.
    pub(crate) fn value(&self, expr: &Expr) -> Option<Known> {
        match self.all(&expr.ty) {
            Some(_) => Some(Known::Within(self.range(expr))),
            None => self.float(expr).map(Known::Float),
        }
    }

    /// Whether `condition` surely holds.
    pub(crate) fn proves(&self, condition: &Expr) -> bool {
        if self.range(condition) == Interval::one(1) {
            return true;
        }
        match &condition.kind {
            ExprKind::Logic(LogicOp::And, a, b) => self.proves(a) && self.proves(b),
            ExprKind::Logic(LogicOp::Or, a, b) => {
                self.holds(condition) || self.proves(a) || self.assuming(a, false).proves(b)
            }
            _ => self.holds(condition) || self.below_length(condition),
        }
    }

    /// Whether an index is below the length of a slice by way of another value: `i < to <= length`, `i + 1` of
    /// `i < to < length`, or of a loop up to `max(length, 1) - 1`; `i - 1`, which is checked before, of `i < length`.
    fn below_length(&self, condition: &Expr) -> bool {
        let condition = erased(condition);
        let ExprKind::Compare(CompareOp::Lt, index, length) = &condition.kind else { return false };
        if !matches!(&length.kind, ExprKind::Load(place) if place.steps.is_empty()) {
            return false;
        }
        let (base, further) = match &index.kind {
            ExprKind::Binary(BinaryOp::Add, base, more) => match more.kind {
                ExprKind::Literal(more) => (base, more),
                _ => (index, 0),
            },
            ExprKind::Binary(BinaryOp::Sub, base, less)
                if matches!(less.kind, ExprKind::Literal(_))
                    && base.ty.as_int().is_some_and(|int| !int.signed()) =>
            {
                (base, 0)
            }
            _ => (index, 0),
        };
        self.hold.iter().any(|fact| match &fact.condition.kind {
            ExprKind::Compare(CompareOp::Lt, a, end) if a == base => {
                let by = match further {
                    0 => Some(CompareOp::Le),
                    1 => Some(CompareOp::Lt),
                    _ => None,
                };
                let up_to = by.is_some_and(|op| {
                    let kind = ExprKind::Compare(op, end.clone(), length.clone());
                    self.holds(&Expr { kind, ..condition.clone() })
                });
                up_to
                    || further == 0 && end == length
                    || short_of(end, length).is_some_and(|short| further <= short)
            }
            _ => false,
        })
    }

    fn holds(&self, condition: &Expr) -> bool {
        let condition = upright(erased(condition));
        let glance = Glance::of(&condition);
        let mut alike = self.hold.iter().filter(|fact| fact.glance.like(glance));
        alike.any(|fact| self.gives(&fact.condition, &condition))
    }

    /// Whether a fact gives the condition, itself or where its excuse does not apply.
    fn gives(&self, fact: &Expr, condition: &Expr) -> bool {
        if implies(fact, condition) {
            return true;
        }
        match &fact.kind {
            ExprKind::Logic(LogicOp::Or, excuse, rest) => {
                self.range(excuse) == Interval::one(0) && self.gives(rest, condition)
            }
            _ => false,
        }
    }

    /// The same facts where `condition` is `truth`.
    pub(crate) fn assuming(&self, condition: &Expr, truth: bool) -> Facts<'m> {
        let mut facts = self.clone();
        facts.assume(condition, truth);
        facts
    }

    /// From here on `condition` is `truth`.
    pub(crate) fn assume(&mut self, condition: &Expr, truth: bool) {
        match &condition.kind {
            ExprKind::Unary(UnaryOp::Not, x) => self.assume(x, !truth),
            ExprKind::Logic(op, a, b) if (*op == LogicOp::And) == truth => {
                self.assume(a, truth);
                self.assume(b, truth);
            }
            ExprKind::Compare(op, a, b) => self.assume_compare(*op, a, b, truth),
            ExprKind::Load(_) => self.bound(condition, Interval::one(i128::from(truth))),
            _ if truth => self.learn(condition),
            _ => {}
        }
    }

    fn assume_compare(&mut self, op: CompareOp, a: &Expr, b: &Expr, truth: bool) {
        let float = a.ty.as_float().is_some();
        let op = match (op, truth) {
            (op, true) => op,
            (CompareOp::Eq, false) => CompareOp::Ne,
            (CompareOp::Ne, false) => CompareOp::Eq,
            (_, false) if float => return,
            (CompareOp::Lt, false) => CompareOp::Ge,
            (CompareOp::Le, false) => CompareOp::Gt,
            (CompareOp::Gt, false) => CompareOp::Le,
            (CompareOp::Ge, false) => CompareOp::Lt,
        };
        if !float {
            self.order(op, a, b);
        }
        let kind = ExprKind::Compare(op, Box::new(a.clone()), Box::new(b.clone()));
        let fact = Expr { kind, ty: Type::BOOL, span: Span::default() };
        self.learn(&fact);
    }

    fn learn(&mut self, condition: &Expr) {
        let condition = Rc::new(upright(erased(condition)));
        let glance = Glance::of(&condition);
        self.hold.push(Fact { condition, glance });
    }

    /// Narrows both sides of an integer comparison that holds.
    fn order(&mut self, op: CompareOp, a: &Expr, b: &Expr) {
        let (x, y) = (self.range(a), self.range(b));
        let below = |high: i128| Interval::new(i128::MIN, high);
        let above = |low: i128| Interval::new(low, i128::MAX);
        match op {
            CompareOp::Lt => {
                self.bound(a, below(y.high.saturating_sub(1)));
                self.bound(b, above(x.low.saturating_add(1)));
            }
            CompareOp::Le => {
                self.bound(a, below(y.high));
                self.bound(b, above(x.low));
            }
            CompareOp::Gt => self.order(CompareOp::Lt, b, a),
            CompareOp::Ge => self.order(CompareOp::Le, b, a),
            CompareOp::Eq => {
                self.bound(a, y);
                self.bound(b, x);
            }
            CompareOp::Ne => {
                y.single().into_iter().for_each(|value| self.bound(a, x.without(value)));
                x.single().into_iter().for_each(|value| self.bound(b, y.without(value)));
            }
        }
    }

    /// From here on the value of `expr` lies within `interval`.
    pub(crate) fn bound(&mut self, expr: &Expr, interval: Interval) {
        match &expr.kind {
            ExprKind::Load(place) => {
                let (Some(key), Some(_)) = (key(place), self.all(&expr.ty)) else { return };
                let range = self.range(expr).meet(interval);
                self.known.insert(key, Known::Within(range));
            }
            ExprKind::Cast(x) => {
                let (Some(_), Some(all)) = (self.all(&x.ty), self.all(&expr.ty)) else { return };
                if self.range(x).within(all) {
                    self.bound(x, interval);
                }
            }
            ExprKind::Binary(BinaryOp::Add, a, b) => {
                if let Some(b) = self.range(b).single() {
                    self.bound(a, interval.sub(Interval::one(b)));
                } else if let Some(a) = self.range(a).single() {
                    self.bound(b, interval.sub(Interval::one(a)));
                }
            }
            ExprKind::Binary(BinaryOp::Sub, a, b) => {
                if let Some(b) = self.range(b).single() {
                    self.bound(a, interval.add(Interval::one(b)));
                }
            }
            _ => {}
        }
    }

    /// `written` are written: nothing that depends on them is known any more.
    pub(crate) fn forget(&mut self, written: &[Place]) {
        if written.is_empty() {
            return;
        }
        for written in written {
            let (first, next) = (written.root, LocalId(written.root.0.saturating_add(1)));
            let same_root = self.known.range((first, Vec::new())..(next, Vec::new()));
            let hit = same_root.map(|(key, _)| key).filter(|key| overlap(&place_of(key), written));
            for key in hit.cloned().collect::<Vec<_>>() {
                self.known.remove(&key);
            }
        }
        let roots = written.iter().fold(0, |roots, place| roots | bit(place.root));
        self.hold.retain(|fact| fact.glance.roots & roots == 0 || !reads(&fact.condition, written));
    }

    /// `value`, if anything is known about it, is written to `place`.
    pub(crate) fn assign(&mut self, place: &Place, value: Option<Known>) {
        self.forget(std::slice::from_ref(place));
        if let (Some(key), Some(value)) = (key(place), value) {
            self.known.insert(key, value);
        }
    }

    /// Only what is known here and in `other`.
    pub(crate) fn join(&mut self, other: &Facts<'m>) {
        self.known.retain(|key, known| match (*known, other.known.get(key)) {
            (Known::Within(a), Some(Known::Within(b))) => {
                *known = Known::Within(a.hull(*b));
                true
            }
            (Known::Float(a), Some(Known::Float(b))) => a.to_bits() == b.to_bits(),
            _ => false,
        });
        let shared: HashSet<*const Expr> =
            other.hold.iter().map(|fact| Rc::as_ptr(&fact.condition)).collect();
        self.hold.retain(|fact| {
            let mut alike = other.hold.iter().filter(|other| other.glance.like(fact.glance));
            shared.contains(&Rc::as_ptr(&fact.condition))
                || alike.any(|other| fact.condition == other.condition)
        });
    }

    /// At the head of a loop: nothing that the body writes is known.
    pub(crate) fn enter_loop(&mut self, variable: LocalId, written: &[Place]) {
        self.forget(&[whole(variable)]);
        self.forget(written);
    }

    /// In the body of a `for`, after [`Facts::enter_loop`]; the body does not change the bounds,
    /// `ranges` are those that they had before the loop.
    pub(crate) fn enter_body(
        &mut self,
        variable: &Expr,
        (from, to): (&Expr, &Expr),
        ranges: (Interval, Interval),
        inclusive: bool,
    ) {
        let last = if inclusive { ranges.1.high } else { ranges.1.high.saturating_sub(1) };
        self.bound(variable, Interval::new(ranges.0.low, last.max(ranges.0.low)));
        let op = if inclusive { CompareOp::Le } else { CompareOp::Lt };
        self.assume_compare(CompareOp::Le, from, variable, true);
        self.assume_compare(op, variable, to, true);
    }

    /// In the arm of a `match` for `values`.
    pub(crate) fn select(&mut self, scrutinee: &Expr, values: &[i128]) {
        let ones = values.iter().copied().map(Interval::one);
        if let Some(range) = ones.reduce(Interval::hull) {
            self.bound(scrutinee, range);
        }
    }

    /// In the last arm of a `match`, where `values` do not occur.
    pub(crate) fn exclude(&mut self, scrutinee: &Expr, mut values: Vec<i128>) {
        values.sort_unstable();
        let range = values.iter().fold(self.range(scrutinee), |range, value| range.without(*value));
        let range = values.iter().rev().fold(range, |range, value| range.without(*value));
        self.bound(scrutinee, range);
    }

    /// After branches: what is known at the end of all of those that reach it.
    pub(crate) fn after(&mut self, ends: Vec<(Facts<'m>, bool)>) {
        let reached = ends.into_iter().filter(|(_, diverges)| !diverges).map(|(facts, _)| facts);
        let joined = reached.reduce(|mut a, b| {
            a.join(&b);
            a
        });
        if let Some(joined) = joined {
            *self = joined;
        }
    }
}

/// Whether one condition, as [`upright`] leaves it, holds wherever the other does.
fn implies(fact: &Expr, condition: &Expr) -> bool {
    let (ExprKind::Compare(known, x, y), ExprKind::Compare(op, a, b)) =
        (&fact.kind, &condition.kind)
    else {
        return fact == condition;
    };
    let same = x == a && y == b;
    let turned = x == b && y == a;
    match op {
        CompareOp::Le => same && matches!(known, CompareOp::Lt | CompareOp::Le),
        CompareOp::Ne => (same || turned) && matches!(known, CompareOp::Lt | CompareOp::Ne),
        _ => same && known == op,
    }
}

/// By how much `max(length, n) - n` falls short of the length, where there is anything below it.
fn short_of(end: &Expr, length: &Expr) -> Option<u64> {
    let ExprKind::Binary(BinaryOp::Sub, most, short) = &end.kind else { return None };
    let ExprKind::Intrinsic(Intrinsic::Max, operands) = &most.kind else { return None };
    let same = operands.first() == Some(length) && operands.get(1) == Some(short);
    match short.kind {
        ExprKind::Literal(short) if same => Some(short),
        _ => None,
    }
}

/// Comparisons, also those of a disjunction, written with `<`, `<=`, `==` and `!=` only, and without
/// the `1` that tells `<` from `<=`.
fn upright(expr: Expr) -> Expr {
    let Expr { kind, ty, span } = expr;
    let kind = match kind {
        ExprKind::Compare(CompareOp::Gt, a, b) => below(*b, *a),
        ExprKind::Compare(CompareOp::Ge, a, b) => at_most(*b, *a),
        ExprKind::Compare(CompareOp::Lt, a, b) => below(*a, *b),
        ExprKind::Compare(CompareOp::Le, a, b) => at_most(*a, *b),
        ExprKind::Logic(op, a, b) => {
            ExprKind::Logic(op, Box::new(upright(*a)), Box::new(upright(*b)))
        }
        kind => kind,
    };
    Expr { kind, ty, span }
}

/// `a < b`; of `a < b + 1` it is `a <= b`.
fn below(a: Expr, b: Expr) -> ExprKind {
    match one_less(&b, BinaryOp::Add) {
        Some(b) => ExprKind::Compare(CompareOp::Le, Box::new(a), Box::new(b)),
        None => ExprKind::Compare(CompareOp::Lt, Box::new(a), Box::new(b)),
    }
}

/// `a <= b`; of `a <= b - 1` and `a + 1 <= b` it is `a < b`.
fn at_most(a: Expr, b: Expr) -> ExprKind {
    let (less, more) = (one_less(&a, BinaryOp::Add), one_less(&b, BinaryOp::Sub));
    let (op, a, b) = match (less, more) {
        (Some(a), _) => (CompareOp::Lt, a, b),
        (None, Some(b)) => (CompareOp::Lt, a, b),
        (None, None) => (CompareOp::Le, a, b),
    };
    ExprKind::Compare(op, Box::new(a), Box::new(b))
}

/// `x` of `x + 1` (or `x - 1`), which are integers that did not overflow.
fn one_less(expr: &Expr, op: BinaryOp) -> Option<Expr> {
    match &expr.kind {
        ExprKind::Binary(found, x, one) if *found == op && expr.ty.as_int().is_some() => {
            (one.kind == ExprKind::Literal(1)).then(|| (**x).clone())
        }
        _ => None,
    }
}

fn float_of(float: Float, word: u64) -> f64 {
    match float {
        Float::F32 => f64::from(f32::from_bits(word as u32)),
        Float::F64 => f64::from_bits(word),
    }
}

fn round(float: Float, value: f64) -> f64 {
    match float {
        Float::F32 => f64::from(value as f32),
        Float::F64 => value,
    }
}

/// In double precision; rounding the result to single gives what single precision gives.
fn operate(op: BinaryOp, a: f64, b: f64) -> Option<f64> {
    match op {
        BinaryOp::Add => Some(a + b),
        BinaryOp::Sub => Some(a - b),
        BinaryOp::Mul => Some(a * b),
        BinaryOp::Div => Some(a / b),
        _ => None,
    }
}
