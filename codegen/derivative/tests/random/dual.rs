//! Dense dual numbers: runs a function of the IR with all derivatives of all numbers, in plain Rust.

use std::collections::BTreeMap;

use bessemer_ir::{
    Argument, BinaryOp, Block, CompareOp, Expr, ExprKind, Function, FunctionId, Intrinsic, LocalId,
    LogicOp, Module, Place, Routine, Step, StmtKind, Type, UnaryOp,
};

/// Number of variables: the words of the first two arguments.
pub const VARIABLES: usize = 4;

/// A word with derivatives, if it is a float.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dual {
    /// The word.
    pub word: u64,
    /// Derivatives.
    pub tangents: [f64; VARIABLES],
}

impl Dual {
    /// Returns a word without derivatives.
    pub fn word(word: u64) -> Dual {
        Dual { word, tangents: [0.0; VARIABLES] }
    }

    /// Returns a float with its derivatives.
    pub fn new(value: f64, tangent: impl Fn(usize) -> f64) -> Dual {
        Dual { word: value.to_bits(), tangents: std::array::from_fn(tangent) }
    }

    /// Returns the float.
    pub fn value(self) -> f64 {
        f64::from_bits(self.word)
    }

    fn is_finite(self) -> bool {
        self.value().is_finite() && self.tangents.iter().all(|it| it.is_finite())
    }
}

fn add(a: Dual, b: Dual) -> Dual {
    Dual::new(a.value() + b.value(), |k| a.tangents[k] + b.tangents[k])
}

/// Returns `a - b`.
pub fn sub(a: Dual, b: Dual) -> Dual {
    Dual::new(a.value() - b.value(), |k| a.tangents[k] - b.tangents[k])
}

/// Returns `a * b`.
pub fn mul(a: Dual, b: Dual) -> Dual {
    let (x, y) = (a.value(), b.value());
    Dual::new(x * y, |k| y * a.tangents[k] + x * b.tangents[k])
}

/// Returns `a / b`.
pub fn div(a: Dual, b: Dual) -> Dual {
    let (x, y) = (a.value(), b.value());
    let quotient = x / y;
    Dual::new(quotient, |k| (a.tangents[k] - quotient * b.tangents[k]) / y)
}

fn rem(a: Dual, b: Dual) -> Dual {
    let (x, y) = (a.value(), b.value());
    Dual::new(x % y, |k| a.tangents[k] - (x / y).trunc() * b.tangents[k])
}

/// Returns the square root.
pub fn root(a: Dual) -> Dual {
    let root = a.value().sqrt();
    Dual::new(root, |k| a.tangents[k] / (2.0 * root))
}

fn neg(a: Dual) -> Dual {
    Dual::new(-a.value(), |k| -a.tangents[k])
}

enum Flow {
    Next,
    Break,
    Continue,
    Return(Vec<Dual>),
}

struct Run<'m> {
    module: &'m Module,
    finite: bool,
    largest: f64,
}

type Memory = BTreeMap<LocalId, Vec<Dual>>;

/// Calls a function on words; the first two arguments are the variables. Returns the largest number
/// on the way, too; none if a float was infinite or NaN.
pub fn call(
    module: &Module,
    function: FunctionId,
    arguments: &[Vec<u64>],
) -> Option<(Vec<Dual>, f64)> {
    let mut memory = Memory::new();
    let mut variable = 0;
    for (index, words) in arguments.iter().enumerate() {
        let mut duals: Vec<Dual> = words.iter().map(|word| Dual::word(*word)).collect();
        for dual in duals.iter_mut().filter(|_| index < 2) {
            dual.tangents[variable] = 1.0;
            variable += 1;
        }
        memory.insert(LocalId(index as u32), duals);
    }
    let mut run = Run { module, finite: true, largest: 1.0 };
    let result = run.function(&module.functions[function.index()], &mut memory);
    Some((result, run.largest)).filter(|_| run.finite)
}

impl Run<'_> {
    fn function(&mut self, function: &Function, memory: &mut Memory) -> Vec<Dual> {
        match self.block(function, memory, &function.body) {
            Flow::Return(value) => value,
            _ => Vec::new(),
        }
    }

    fn block(&mut self, of: &Function, memory: &mut Memory, block: &Block) -> Flow {
        for stmt in &block.0 {
            let flow = match &stmt.kind {
                StmtKind::Let { local, value } => {
                    let value = match value {
                        Some(value) => self.expr(of, memory, value),
                        None => vec![Dual::word(0); self.module.width(&of.local(*local).ty)],
                    };
                    memory.insert(*local, value);
                    Flow::Next
                }
                StmtKind::Assign { place, value } => {
                    let value = self.expr(of, memory, value);
                    self.store(of, memory, place, &value);
                    Flow::Next
                }
                StmtKind::Expr(expr) => {
                    self.expr(of, memory, expr);
                    Flow::Next
                }
                StmtKind::If { condition, then, otherwise } => {
                    let holds = self.one(of, memory, condition).word != 0;
                    self.block(of, memory, if holds { then } else { otherwise })
                }
                StmtKind::Match { scrutinee, arms, otherwise } => {
                    let word = i128::from(self.one(of, memory, scrutinee).word);
                    let arm = arms.iter().find(|arm| arm.values.contains(&word));
                    match arm.map(|arm| &arm.body).or(otherwise.as_ref()) {
                        Some(body) => self.block(of, memory, body),
                        None => Flow::Next,
                    }
                }
                StmtKind::For { variable, from, to, reversed, body, .. } => {
                    let from = self.one(of, memory, from).word;
                    let to = self.one(of, memory, to).word;
                    let mut values: Vec<u64> = (from..to).collect();
                    if *reversed {
                        values.reverse();
                    }
                    let mut end = Flow::Next;
                    for value in values {
                        memory.insert(*variable, vec![Dual::word(value)]);
                        match self.block(of, memory, body) {
                            Flow::Break => break,
                            Flow::Return(value) => {
                                end = Flow::Return(value);
                                break;
                            }
                            _ => {}
                        }
                    }
                    end
                }
                StmtKind::Return(value) => Flow::Return(
                    value.as_ref().map_or_else(Vec::new, |it| self.expr(of, memory, it)),
                ),
                StmtKind::Break => Flow::Break,
                StmtKind::Continue => Flow::Continue,
                StmtKind::Check { .. } => Flow::Next,
            };
            if !matches!(flow, Flow::Next) {
                return flow;
            }
        }
        Flow::Next
    }

    fn range(&mut self, of: &Function, memory: &mut Memory, place: &Place) -> (usize, usize) {
        let mut ty = of.local(place.root).ty.clone();
        let mut start = 0;
        for step in &place.steps {
            start += match step {
                Step::Field(field) => {
                    let Type::Struct(id) = &ty else { panic!("a field of a struct") };
                    let before = &self.module.structs[id.index()].fields[..*field as usize];
                    before.iter().map(|it| self.module.width(&it.ty)).sum()
                }
                Step::Index(index) => {
                    let at = self.one(of, memory, index).word as usize;
                    match &ty {
                        Type::Array { element, .. } => at * self.module.width(element),
                        _ => at,
                    }
                }
                Step::Element(row, col) => {
                    let Type::Matrix { rows, .. } = ty else { panic!("an element of a matrix") };
                    let row = self.one(of, memory, row).word as usize;
                    row + self.one(of, memory, col).word as usize * rows as usize
                }
                Step::From(_) => panic!("no slices here"),
            };
            ty = self.module.step_type(&ty, step).expect("a valid step");
        }
        (start, self.module.width(&place.ty))
    }

    fn store(&mut self, of: &Function, memory: &mut Memory, place: &Place, value: &[Dual]) {
        let (start, width) = self.range(of, memory, place);
        let all = memory.get_mut(&place.root).expect("a declared local");
        if let Some(part) = all.get_mut(start..start + width) {
            part.copy_from_slice(value);
        }
    }

    fn one(&mut self, of: &Function, memory: &mut Memory, expr: &Expr) -> Dual {
        self.expr(of, memory, expr)[0]
    }

    fn expr(&mut self, of: &Function, memory: &mut Memory, expr: &Expr) -> Vec<Dual> {
        let duals = self.unchecked(of, memory, expr);
        if expr.ty.as_float().is_some() {
            self.finite &= duals.iter().all(|it| it.is_finite());
            let all = duals.iter().flat_map(|it| it.tangents.into_iter().chain([it.value()]));
            self.largest = all.fold(self.largest, |most, it| most.max(it.abs()));
        }
        duals
    }

    fn unchecked(&mut self, of: &Function, memory: &mut Memory, expr: &Expr) -> Vec<Dual> {
        let is_float = expr.ty.as_float().is_some();
        vec![match &expr.kind {
            ExprKind::Literal(word) => Dual::word(*word),
            ExprKind::Load(place) => {
                let (start, width) = self.range(of, memory, place);
                let all = &memory[&place.root];
                // The interpreter reports an index out of range.
                let part = all.get(start..start + width);
                return part.map_or_else(|| vec![Dual::word(0); width], <[Dual]>::to_vec);
            }
            ExprKind::Unary(UnaryOp::Neg, a) => neg(self.one(of, memory, a)),
            ExprKind::Unary(UnaryOp::Not, a) => Dual::word(1 - self.one(of, memory, a).word),
            ExprKind::Binary(op, a, b) => {
                let (a, b) = (self.one(of, memory, a), self.one(of, memory, b));
                match op {
                    BinaryOp::Add if is_float => add(a, b),
                    BinaryOp::Sub if is_float => sub(a, b),
                    BinaryOp::Mul if is_float => mul(a, b),
                    BinaryOp::Div if is_float => div(a, b),
                    BinaryOp::Rem if is_float => rem(a, b),
                    BinaryOp::Add => Dual::word(a.word.wrapping_add(b.word)),
                    BinaryOp::Sub => Dual::word(a.word.wrapping_sub(b.word)),
                    BinaryOp::Rem => Dual::word(a.word.checked_rem(b.word).unwrap_or(0)),
                    other => panic!("{other:?} of whole numbers"),
                }
            }
            ExprKind::Compare(op, a, b) => {
                let is_float = a.ty.as_float().is_some();
                let (a, b) = (self.one(of, memory, a), self.one(of, memory, b));
                let order = match is_float {
                    true => a.value().partial_cmp(&b.value()),
                    false => Some(a.word.cmp(&b.word)),
                };
                let holds = match op {
                    CompareOp::Eq => order.is_some_and(|it| it.is_eq()),
                    CompareOp::Ne => order.is_none_or(|it| it.is_ne()),
                    CompareOp::Lt => order.is_some_and(|it| it.is_lt()),
                    CompareOp::Le => order.is_some_and(|it| it.is_le()),
                    CompareOp::Gt => order.is_some_and(|it| it.is_gt()),
                    CompareOp::Ge => order.is_some_and(|it| it.is_ge()),
                };
                Dual::word(holds.into())
            }
            ExprKind::Logic(op, a, b) => {
                let first = self.one(of, memory, a);
                match (op, first.word) {
                    (LogicOp::And, 0) | (LogicOp::Or, 1) => first,
                    _ => self.one(of, memory, b),
                }
            }
            ExprKind::Cast(a) => {
                let from = a.ty.clone();
                let a = self.one(of, memory, a);
                match (is_float, from.as_float().is_some()) {
                    (true, false) => Dual::new(a.word as f64, |_| 0.0),
                    (false, true) => Dual::word(a.value() as u64),
                    _ => a,
                }
            }
            ExprKind::Intrinsic(op, operands) => {
                let all: Vec<Dual> = operands.iter().map(|it| self.one(of, memory, it)).collect();
                intrinsic(*op, &all)
            }
            ExprKind::Call(callee, arguments) => {
                let callee = &self.module.functions[callee.index()];
                let mut inner = Memory::new();
                for (index, argument) in arguments.iter().enumerate() {
                    let value = match argument {
                        Argument::Value(it) | Argument::Ref(it) => self.expr(of, memory, it),
                        Argument::RefMut(place) => self.expr(of, memory, &place.load()),
                    };
                    inner.insert(LocalId(index as u32), value);
                }
                if let Some(kernel) = &callee.kernel {
                    let mut operands: Vec<Vec<Dual>> = inner.into_values().collect();
                    let size = kernel.dims[0] as usize;
                    let result = crate::kernels::run(kernel.routine, size, &mut operands);
                    for (argument, value) in arguments.iter().zip(&operands) {
                        if let Argument::RefMut(place) = argument {
                            self.store(of, memory, place, value);
                        }
                    }
                    return result;
                }
                let result = self.function(callee, &mut inner);
                for (index, argument) in arguments.iter().enumerate() {
                    if let Argument::RefMut(place) = argument {
                        self.store(of, memory, place, &inner[&LocalId(index as u32)].clone());
                    }
                }
                return result;
            }
            ExprKind::Struct(all) | ExprKind::Array(all) | ExprKind::Matrix(all) => {
                return all.iter().flat_map(|it| self.expr(of, memory, it)).collect();
            }
            ExprKind::Splat(a) => {
                let value = self.one(of, memory, a);
                return vec![value; self.module.width(&expr.ty)];
            }
            ExprKind::Routine(routine, operands) => {
                let a = self.expr(of, memory, &operands[0]);
                let b = operands.get(1).map_or_else(Vec::new, |it| self.expr(of, memory, it));
                return self.routine(*routine, &operands[0].ty, (&a, &b));
            }
            ExprKind::Const(_) => panic!("no constants here"),
        }]
    }

    fn routine(&mut self, routine: Routine, ty: &Type, (a, b): (&[Dual], &[Dual])) -> Vec<Dual> {
        let Type::Matrix { rows, cols, .. } = *ty else { panic!("a matrix") };
        let (rows, inner) = (rows as usize, cols as usize);
        let each = |operation: fn(Dual, Dual) -> Dual| {
            a.iter().zip(b).map(|(a, b)| operation(*a, *b)).collect::<Vec<Dual>>()
        };
        let of_three = |a: &[Dual], b: &[Dual]| {
            let term = |k: usize| mul(a[k], b[k]);
            add(add(term(0), term(1)), term(2))
        };
        match routine {
            Routine::Add => each(add),
            Routine::Sub => each(sub),
            Routine::ComponentMul => each(mul),
            Routine::Neg => a.iter().map(|it| neg(*it)).collect(),
            Routine::Scale => a.iter().map(|it| mul(*it, b[0])).collect(),
            Routine::Unscale => a.iter().map(|it| div(*it, b[0])).collect(),
            Routine::Product => {
                let cols = b.len() / inner;
                let mut all = Vec::new();
                for col in 0..cols {
                    for row in 0..rows {
                        let term = |k: usize| mul(a[row + k * rows], b[k + col * inner]);
                        all.push((1..inner).fold(term(0), |sum, k| add(term(k), sum)));
                    }
                }
                all
            }
            Routine::Transpose => {
                let all = (0..rows).flat_map(|row| (0..inner).map(move |col| row + col * rows));
                all.map(|at| a[at]).collect()
            }
            Routine::Dot if a.len() == 3 => vec![of_three(a, b)],
            Routine::Cross => {
                let of = |i: usize, j: usize| sub(mul(a[i], b[j]), mul(a[j], b[i]));
                vec![of(1, 2), of(2, 0), of(0, 1)]
            }
            Routine::Norm if a.len() == 3 => {
                vec![root(add(Dual::new(0.0, |_| 0.0), of_three(a, a)))]
            }
            other => panic!("{other:?} of {rows} rows"),
        }
    }
}

fn intrinsic(op: Intrinsic, all: &[Dual]) -> Dual {
    let (a, b) = (all[0], *all.get(1).unwrap_or(&all[0]));
    let (x, y) = (a.value(), b.value());
    let chosen = |value: f64, of: Dual| Dual::new(value, |k| of.tangents[k]);
    match op {
        Intrinsic::Sqrt => root(a),
        Intrinsic::Abs => chosen(x.abs(), if x.abs() == x { a } else { neg(a) }),
        Intrinsic::Min | Intrinsic::Max => {
            let first = match (op, x == y) {
                (Intrinsic::Min, true) => {
                    if x.is_sign_negative() {
                        x
                    } else {
                        y
                    }
                }
                (_, true) => {
                    if x.is_sign_positive() {
                        x
                    } else {
                        y
                    }
                }
                (Intrinsic::Min, false) => x.min(y),
                _ => x.max(y),
            };
            chosen(first, if first == x { a } else { b })
        }
        Intrinsic::Clamp => {
            let c = all[2];
            match () {
                () if x < y => b,
                () if x > c.value() => c,
                () => a,
            }
        }
        Intrinsic::Copysign => {
            let value = x.copysign(y);
            chosen(value, if value == x { a } else { neg(a) })
        }
        Intrinsic::Floor => Dual::new(x.floor(), |_| 0.0),
        Intrinsic::Signum => Dual::new(x.signum(), |_| 0.0),
        other => panic!("{other:?}"),
    }
}
