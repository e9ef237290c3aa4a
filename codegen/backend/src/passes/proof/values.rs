//! Values of expressions, and preconditions of their operations.
//!
//! Meaning: in an execution at the point without a fault so far, the expression has this value. A precondition is
//! reported before the operation's value is computed; afterwards the operation has not faulted, so its result is
//! exact.

use std::collections::{BTreeMap, HashMap};

use bessemer_ir::visit::{Access, VisitMut, walk_expr_mut, walk_place_mut};
use bessemer_ir::{
    BinaryOp, CompareOp, EnumId, Expr, ExprKind, Float, Function, FunctionId, Int, Intrinsic,
    LocalId, LogicOp, Module, Place, Scalar, Span, Step, Type, UnaryOp,
};

use super::knowledge::{Bounds, Formula, Knowledge};
use super::limits::Limits;
use super::linear::{FURTHEST, Linear, Symbol};
use super::persistent::Map;
use super::returns::{Numbers, Returns};
use crate::passes::sites::Site;
use bessemer_ir::used::Rule;

/// Value of a word.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(super) enum Value {
    /// An integer, or the index of a variant; for an invalid enum, the number of its variants.
    Number(Linear),
    Truth(Formula),
    /// A float, with its bits, widened to double, if they are known.
    Float(Symbol, Option<u64>),
}

/// Key of a symbol: equal operations on equal values have the same symbol (value numbering).
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(super) enum Origin {
    Float(u64),
    Unary(UnaryOp, Type),
    Binary(BinaryOp, Type),
    /// Exact product, for any type.
    Product,
    Compare(CompareOp),
    Cast(Type),
    Intrinsic(Intrinsic, Type),
    /// Call of a function without effects, with the version of memory at which it is evaluated.
    Call(String, u32),
}

/// A step into a value, with indices as values.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum At {
    Field(u32),
    Index(Vec<Linear>),
}

impl At {
    /// Returns the field, if it is one.
    pub(super) fn field(&self) -> Option<u32> {
        match self {
            At::Field(field) => Some(*field),
            At::Index(_) => None,
        }
    }
}

/// Known words in a value, each with the steps to it.
pub(super) type Parts = Vec<(Vec<At>, Value)>;

/// Returns the part that is the value itself, if it is a word.
pub(super) fn the_whole(parts: &Parts) -> Option<&Value> {
    parts.iter().find(|(at, _)| at.is_empty()).map(|(_, value)| value)
}

/// Returns the truth value with these bounds, if they are equal.
fn truth_of((low, high): &Bounds) -> Option<Formula> {
    (low == high).then(|| Formula::constant(*low != 0))
}

/// Returns the steps to a place with fields only.
pub(super) fn fields_of(place: &Place) -> Option<Vec<At>> {
    let field = |step: &Step| match step {
        Step::Field(field) => Some(At::Field(*field)),
        _ => None,
    };
    place.steps.iter().map(field).collect()
}

/// Values of places at a point, with the facts about them.
#[derive(Clone, Default)]
pub(super) struct Point {
    pub(super) knowledge: Knowledge,
    pub(super) places: Map<Parts>,
    /// Changes with every write.
    pub(super) version: u32,
}

/// Symbols of a function.
pub(super) struct Values<'m> {
    pub(super) module: &'m Module,
    pub(super) function: &'m Function,
    /// Summaries of the functions before this one.
    pub(super) shown: &'m [Returns],
    /// Bounds of each symbol by its type.
    pub(super) all: Vec<Bounds>,
    origins: HashMap<(Origin, Vec<Value>), Symbol>,
    /// Comparisons of two floats, by the symbol that is 1 where they hold.
    pub(super) compared: BTreeMap<Symbol, (CompareOp, Symbol, Symbol)>,
    /// Limits of floats that are known.
    pub(super) limits: HashMap<Symbol, Limits>,
    pub(super) versions: u32,
    /// Operations that may fault.
    pub(super) open: Vec<Site>,
    /// True if these are not reported now, but later.
    pub(super) quiet: bool,
}

pub(super) fn bounds_of(int: Int) -> Bounds {
    (int.min(), int.max())
}

impl<'m> Values<'m> {
    pub(super) fn new(
        module: &'m Module,
        function: &'m Function,
        shown: &'m [Returns],
    ) -> Values<'m> {
        let (all, origins, open) = (Vec::new(), HashMap::new(), Vec::new());
        let (compared, limits) = (BTreeMap::new(), HashMap::new());
        let (versions, quiet) = (0, false);
        Values { module, function, shown, all, origins, compared, limits, versions, open, quiet }
    }

    /// Returns the summary of a function; an empty one if it does not precede this one.
    pub(super) fn returned(&self, callee: FunctionId) -> &'m Returns {
        static NOTHING: Returns = Returns { numbers: Numbers::new(), steady: false, never: false };
        self.shown.get(callee.index()).unwrap_or(&NOTHING)
    }

    /// Returns a new symbol with these bounds.
    pub(super) fn fresh(&mut self, bounds: Bounds) -> Symbol {
        self.all.push((bounds.0.max(-FURTHEST), bounds.1.min(FURTHEST)));
        Symbol(self.all.len() as u32 - 1)
    }

    pub(super) fn next_version(&mut self) -> u32 {
        self.versions += 1;
        self.versions
    }

    pub(super) fn made(&mut self, origin: Origin, of: Vec<Value>, bounds: Bounds) -> Symbol {
        if let Some(symbol) = self.origins.get(&(origin.clone(), of.clone())) {
            return *symbol;
        }
        let symbol = self.fresh(bounds);
        self.origins.insert((origin, of), symbol);
        symbol
    }

    pub(super) fn variants(&self, id: EnumId) -> i128 {
        self.module.enums[id.index()].variants.len() as i128
    }

    /// Returns an unknown value of a type.
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

    /// Returns the result of an operation of which only the type is known: the same symbol for equal operands.
    pub(super) fn opaque(&mut self, origin: Origin, of: Vec<Value>, ty: &Type) -> Option<Value> {
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

    /// Reports an operation whose precondition is not proved.
    pub(super) fn need(&mut self, point: &Point, needed: &Formula, site: Site) {
        if !self.quiet && !Rule::Shown.told(point.knowledge.shows(needed, &self.all)) {
            self.open.push(site);
        }
    }

    pub(super) fn tell(&mut self, site: Site) {
        if !self.quiet {
            self.open.push(site);
        }
    }

    pub(super) fn need_within(
        &mut self,
        point: &Point,
        form: Option<&Linear>,
        bounds: Bounds,
        site: Site,
    ) {
        match form.and_then(|form| within(form, bounds)) {
            Some(needed) => self.need(point, &needed, site),
            None => self.tell(site),
        }
    }

    pub(super) fn range(&self, point: &Point, form: &Linear) -> Bounds {
        point.knowledge.range(form, &self.all)
    }

    /// Returns the number of a form, also if only its bounds determine it.
    pub(super) fn single(&self, point: &Point, form: &Linear) -> Option<i128> {
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

    /// Returns the known words in a call's result.
    pub(super) fn given(&mut self, callee: FunctionId, ty: &Type) -> Parts {
        let mut parts = Parts::new();
        for (fields, bounds) in &self.returned(callee).numbers {
            let inside = |ty: Type, field: &u32| step_type(self.module, &ty, &Step::Field(*field));
            let word = fields.iter().try_fold(ty.clone(), inside);
            let value = match word {
                Some(Type::Scalar(Scalar::Bool)) => match truth_of(bounds) {
                    Some(truth) => Value::Truth(truth),
                    None => continue,
                },
                Some(_) => Value::Number(Linear::symbol(self.fresh(*bounds))),
                None => continue,
            };
            Rule::Called.used();
            parts.push((fields.iter().map(|field| At::Field(*field)).collect(), value));
        }
        parts
    }

    /// Returns the bounds of the numbers in a value, as far as fields lead to them.
    pub(super) fn numbers(&self, point: &Point, parts: &Parts) -> Numbers {
        let number = |(at, value): &(Vec<At>, Value)| {
            let fields: Option<Vec<u32>> = at.iter().map(At::field).collect();
            let bounds = match value {
                Value::Number(form) => point.knowledge.closest(form, &self.all),
                // As it is written: to show a long one takes long.
                Value::Truth(formula) if *formula == Formula::constant(true) => (1, 1),
                Value::Truth(formula) if *formula == Formula::constant(false) => (0, 0),
                Value::Truth(_) | Value::Float(..) => return None,
            };
            Some((fields?, bounds))
        };
        parts.iter().filter_map(number).collect()
    }

    /// Returns the value of an expression; none for an aggregate. Operands are evaluated left to right.
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
            ExprKind::Logic(op, ..) => {
                let mut operands = operands(*op, expr);
                let first = self.truth(point, operands.pop()?);
                let mut within = point.clone();
                let mut parts = vec![first];
                while let (Some(last), Some(operand)) = (parts.last(), operands.pop()) {
                    let reached = if *op == LogicOp::And { last.clone() } else { last.not() };
                    within.knowledge.assume(&reached, &self.all);
                    parts.push(self.truth(&mut within, operand));
                }
                // What was read on the way is the same here.
                point.places = within.places;
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
                point.knowledge.dead |= self.returned(*id).never;
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

    pub(super) fn literal(&mut self, ty: &Type, word: u64) -> Option<Value> {
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

    pub(super) fn float(&mut self, value: f64) -> Value {
        let bits = value.to_bits();
        let symbol = self.made(Origin::Float(bits), Vec::new(), (0, 0));
        if !value.is_nan() {
            self.limits.insert(symbol, Limits::of([value], false));
        }
        Value::Float(symbol, (!value.is_nan()).then_some(bits))
    }

    /// Returns the value of a call. A call without effects has the same value until the next write.
    pub(super) fn call(&mut self, point: &Point, id: FunctionId, expr: &Expr) -> Option<Value> {
        let callee = &self.module.functions[id.index()];
        let reads = callee.parameters().iter().all(|it| it.mode != bessemer_ir::Mode::RefMut);
        let mut unknown = self.unknown(&expr.ty)?;
        if let (Value::Number(form), Some(shown)) =
            (&unknown, self.returned(id).numbers.get(&[][..]))
        {
            Rule::Called.used();
            let (low, high) = self.range(point, form);
            let bounds = (low.max(shown.0), high.min(shown.1));
            unknown = Value::Number(Linear::symbol(self.fresh(bounds)));
        }
        let shown = self.returned(id).numbers.get(&[][..]);
        if let (Value::Truth(_), Some(truth)) = (&unknown, shown.and_then(truth_of)) {
            return Some(Value::Truth(truth));
        }
        if !reads || !self.returned(id).steady {
            return Some(unknown);
        }
        let bounds = match &unknown {
            Value::Number(form) => self.range(point, form),
            _ => (0, 1),
        };
        let written = format!("{:?}", without_spans(expr));
        let symbol = self.made(Origin::Call(written, point.version), Vec::new(), bounds);
        Some(match unknown {
            Value::Number(_) => Value::Number(Linear::symbol(symbol)),
            Value::Truth(_) => Value::Truth(Formula::Is(symbol, true)),
            Value::Float(..) => Value::Float(symbol, None),
        })
    }

    /// Returns the steps of a place, and reports the preconditions of its indices.
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
            container = container.and_then(|it| step_type(self.module, &it, step));
            all.push(at);
        }
        all
    }

    /// The bounds that the word at some fields of a local has by its type.
    pub(super) fn type_bounds(&mut self, root: LocalId, at: &[At]) -> Bounds {
        let mut ty = Some(self.function.local(root).ty.clone());
        for step in at {
            ty = match (step, ty) {
                (At::Field(field), Some(ty)) => step_type(self.module, &ty, &Step::Field(*field)),
                (At::Index(_), Some(Type::Array { element, .. } | Type::Slice(element))) => {
                    Some(*element)
                }
                (At::Index(_), Some(Type::Matrix { element, .. })) => Some(Type::Scalar(element)),
                _ => None,
            };
        }
        let unknown = ty.and_then(|ty| self.unknown(&ty));
        match unknown {
            Some(Value::Number(form)) => Point::default().knowledge.range(&form, &self.all),
            _ => (-FURTHEST, FURTHEST),
        }
    }

    /// The value that a place holds.
    pub(super) fn load(
        &mut self,
        point: &mut Point,
        root: LocalId,
        at: Vec<At>,
        ty: &Type,
    ) -> Option<Value> {
        let held = point.places.get(root.0).and_then(|all| all.iter().find(|(it, _)| *it == at));
        if let Some((_, value)) = held {
            return Some(value.clone());
        }
        let value = self.unknown(ty)?;
        point.places.change(root.0).push((at, value.clone()));
        Some(value)
    }
}

/// Returns the type after a step; none after the beginning of a slice.
pub(super) fn step_type(module: &Module, container: &Type, step: &Step) -> Option<Type> {
    Some(match (container, step) {
        (Type::Struct(id), Step::Field(field)) => {
            module.structs.get(id.index())?.fields.get(*field as usize)?.ty.clone()
        }
        (Type::Array { element, .. } | Type::Slice(element), Step::Index(_)) => (**element).clone(),
        (Type::Matrix { element, .. }, Step::Index(_) | Step::Element(..)) => {
            Type::Scalar(*element)
        }
        _ => return None,
    })
}

/// Returns an expression without spans, for comparisons. A missed span only makes equal expressions look different.
fn without_spans(expr: &Expr) -> Expr {
    struct Erase;
    impl VisitMut for Erase {
        fn expr(&mut self, expr: &mut Expr) {
            expr.span = Span::default();
            walk_expr_mut(self, expr);
        }
        fn place(&mut self, place: &mut Place, _: Access) {
            place.span = Span::default();
            walk_place_mut(self, place);
        }
    }
    let mut expr = expr.clone();
    Erase.expr(&mut expr);
    expr
}

/// Returns the formula that a form is within bounds.
pub(super) fn within(form: &Linear, (low, high): Bounds) -> Option<Formula> {
    let low = low.max(-FURTHEST);
    let high = high.min(FURTHEST);
    let above = form.shifted(-low)?;
    let below = form.times(-1)?.shifted(high)?;
    Some(Formula::All(vec![Formula::Natural(above), Formula::Natural(below)]))
}

/// Returns the formula of a comparison of two forms.
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

/// Returns the operands of `a && b && c`, the first one last; each is evaluated if all before it are true.
fn operands(op: LogicOp, mut expr: &Expr) -> Vec<&Expr> {
    let mut operands = Vec::new();
    while let ExprKind::Logic(found, left, right) = &expr.kind
        && *found == op
    {
        operands.push(&**right);
        expr = left;
    }
    operands.push(expr);
    operands
}
