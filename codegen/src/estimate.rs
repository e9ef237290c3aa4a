//! Estimates of the instructions and cycles of each function on its longest path, from the explicit IR by a stated model.
//!
//! The model counts operations on the longest path: of a branch the longer side, of a loop the most passes. Each operation
//! has the weights of its [`Class`]. The weights are not calibrated, so an estimate is no bound. Caches, interrupts and wait states of memory are not in it.
//!
//! Invariant: a loop without a known number of passes has no estimate, and neither have the functions that reach it.

mod passes;
mod weights;

use bessemer_ir::{
    Argument, BinaryOp, Block, Expr, ExprKind, Function, Intrinsic, Kernel, Module, Place, Routine,
    Scalar, Span, Step, Stmt, StmtKind, Type,
};

use crate::deep::deep;
use passes::Known;
pub use passes::Source;
pub use weights::{Class, Cost, PROCESSORS, WEIGHTS};

/// Estimate of a function.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Estimate {
    /// Instructions and cycles; none if a loop has no known number of passes.
    pub cost: Option<Cost>,
    /// Loops of the function.
    pub loops: Vec<Loop>,
}

/// A loop, its passes, and the reason why there are no more.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Loop {
    /// Place of the loop.
    pub span: Span,
    /// Largest number of passes; none if unknown.
    pub passes: Option<u64>,
    /// Source of the number.
    pub source: Source,
}

/// Returns the estimate of each function of a module in explicit IR, in its order.
pub fn estimates(module: &Module) -> Vec<Estimate> {
    deep(|| of_functions(module))
}

fn of_functions(module: &Module) -> Vec<Estimate> {
    let mut estimates: Vec<Estimate> = Vec::new();
    for function in &module.functions {
        let mut counter = Counter {
            module,
            function,
            callees: &estimates,
            known: Known::new(module, function),
            loops: Vec::new(),
        };
        let cost = match &function.kernel {
            Some(kernel) => Some(of_kernel(kernel)),
            None => counter.block(&function.body),
        };
        let loops = counter.loops;
        estimates.push(Estimate { cost, loops });
    }
    estimates
}

struct Counter<'a> {
    module: &'a Module,
    function: &'a Function,
    callees: &'a [Estimate],
    known: Known<'a>,
    loops: Vec<Loop>,
}

/// A cost; none if it has no bound.
type Found = Option<Cost>;

fn one(class: Class) -> Cost {
    class.cost()
}

impl Counter<'_> {
    fn block(&mut self, block: &Block) -> Found {
        let mut sum = Cost::default();
        let mut all = true;
        for stmt in &block.0 {
            match self.stmt(stmt) {
                Some(cost) => sum += cost,
                None => all = false,
            }
        }
        all.then_some(sum)
    }

    fn stmt(&mut self, stmt: &Stmt) -> Found {
        Some(match &stmt.kind {
            StmtKind::Let { local, value } => {
                self.known.declare(*local, value.as_ref());
                match value {
                    Some(value) => self.expr(value)? + self.moved(&value.ty),
                    None => Cost::default(),
                }
            }
            StmtKind::Assign { place, value } => {
                self.expr(value)? + self.place(place)? + self.moved(&value.ty)
            }
            StmtKind::Expr(expr) => self.expr(expr)?,
            StmtKind::If { condition, then, otherwise } => {
                let test = self.expr(condition)? + one(Class::Branch);
                let (then, otherwise) = (self.block(then), self.block(otherwise));
                test + then?.most(otherwise?)
            }
            StmtKind::Match { scrutinee, arms, otherwise } => {
                let test = self.expr(scrutinee)? + one(Class::Branch) * (arms.len() as u64 + 1);
                let sides: Vec<Found> = arms
                    .iter()
                    .map(|arm| &arm.body)
                    .chain(otherwise)
                    .map(|body| self.block(body))
                    .collect();
                let mut longest = Cost::default();
                for side in sides {
                    longest = longest.most(side?);
                }
                test + longest
            }
            StmtKind::For { variable, from, to, inclusive, body, .. } => {
                let ends = self.expr(from)? + self.expr(to)?;
                let (passes, source) = self.known.passes(*variable, from, to, *inclusive, body);
                self.loops.push(Loop { span: stmt.span, passes, source });
                let outer = self.known.clone();
                self.known.counts(*variable, from, to, *inclusive);
                let body = self.block(body);
                self.known = outer;
                let each = body? + one(Class::Word32) * 2 + one(Class::Branch);
                ends + each * passes? + one(Class::Branch)
            }
            StmtKind::Check { condition, .. } => self.expr(condition)? + one(Class::Branch),
            StmtKind::Return(value) => {
                let value = value.as_ref();
                let own = value.map_or(Some(Cost::default()), |it| self.expr(it))?;
                own + value.map_or(Cost::default(), |it| self.moved(&it.ty)) + one(Class::Branch)
            }
            StmtKind::Break | StmtKind::Continue => one(Class::Branch),
        })
    }

    /// Cost of moving a value of this type.
    fn moved(&self, ty: &Type) -> Cost {
        one(Class::Move) * self.module.width(ty).max(1) as u64
    }

    fn exprs<'e>(&mut self, list: impl IntoIterator<Item = &'e Expr>) -> Found {
        let mut sum = Cost::default();
        for expr in list {
            sum += self.expr(expr)?;
        }
        Some(sum)
    }

    fn expr(&mut self, expr: &Expr) -> Found {
        Some(match &expr.kind {
            ExprKind::Literal(_) | ExprKind::Const(_) => one(Class::Move),
            ExprKind::Load(place) => self.place(place)? + one(Class::Move),
            ExprKind::Unary(_, of) => self.expr(of)? + one(arithmetic(&expr.ty)),
            ExprKind::Cast(of) => self.expr(of)? + one(Class::conversion(&of.ty, &expr.ty)),
            ExprKind::Binary(op, left, right) => {
                let own = match op {
                    BinaryOp::Div => division(&expr.ty),
                    BinaryOp::Rem => remainder(&expr.ty),
                    _ => arithmetic(&expr.ty),
                };
                self.exprs([&**left, &**right])? + one(own)
            }
            ExprKind::Compare(_, left, right) => {
                let own = arithmetic(&left.ty);
                self.exprs([&**left, &**right])? + one(own) + one(Class::Word32)
            }
            ExprKind::Logic(_, left, right) => {
                self.exprs([&**left, &**right])? + one(Class::Branch)
            }
            ExprKind::Intrinsic(intrinsic, operands) => {
                let ty = operands.first().map_or(&expr.ty, |it| &it.ty);
                self.exprs(operands)? + of_intrinsic(*intrinsic, ty)
            }
            ExprKind::Call(callee, arguments) => {
                let mut sum = one(Class::Call);
                for argument in arguments {
                    sum += match argument {
                        Argument::Value(value) | Argument::Ref(value) => self.expr(value)?,
                        Argument::RefMut(place) => self.place(place)?,
                    };
                    sum += one(Class::Move);
                }
                sum + self.callees.get(callee.index()).and_then(|it| it.cost)?
            }
            ExprKind::Struct(parts) | ExprKind::Array(parts) | ExprKind::Matrix(parts) => {
                self.exprs(parts)? + self.moved(&expr.ty)
            }
            ExprKind::Splat(of) => self.expr(of)? + self.moved(&expr.ty),
            ExprKind::Routine(routine, operands) => {
                self.exprs(operands)? + self.routine(*routine, operands, &expr.ty)
            }
        })
    }

    fn place(&mut self, place: &Place) -> Found {
        let mut sum = one(Class::Move);
        for step in &place.steps {
            sum += match step {
                Step::Field(_) => Cost::default(),
                Step::Index(index) | Step::From(index) => self.expr(index)? + one(Class::Word32),
                Step::Element(row, column) => self.exprs([row, column])? + one(Class::Word32) * 2,
            };
        }
        // A slice is passed with its length.
        let slice = matches!(self.function.local(place.root).ty, Type::Slice(_));
        Some(if slice { sum + one(Class::Move) } else { sum })
    }

    /// Cost of a routine of small matrices, written out in the C.
    fn routine(&self, routine: Routine, operands: &[Expr], result: &Type) -> Cost {
        let width = |ty: &Type| self.module.width(ty).max(1) as u64;
        let first = operands.first().map_or(result, |it| &it.ty);
        let element = match first {
            Type::Matrix { element, .. } => Type::Scalar(*element),
            other => other.clone(),
        };
        let inner = match (routine, first) {
            (Routine::Product, Type::Matrix { cols, .. }) => u64::from(*cols),
            (Routine::TrMul, Type::Matrix { rows, .. }) => u64::from(*rows),
            (Routine::Dot | Routine::Norm | Routine::NormSquared, ty) => width(ty),
            (Routine::Cross, _) => 2,
            _ => 1,
        };
        let term = one(arithmetic(&element)) * 2 + one(Class::Move) * 3 + one(Class::Word32) * 2;
        let own = match routine {
            Routine::Unscale | Routine::ComponentDiv => one(division(&element)),
            Routine::Norm => one(root(&element)),
            _ => Cost::default(),
        };
        term * (inner * width(result)) + own * width(result)
    }
}

/// Cost of a kernel: of its inner loops, generously.
fn of_kernel(kernel: &Kernel) -> Cost {
    let element = Type::Scalar(Scalar::Float(kernel.element));
    let dims: Vec<u64> = kernel.dims.iter().map(|it| u64::from(*it)).collect();
    let terms = match dims[..] {
        [rows, inner, cols] => rows * inner * cols,
        [size, cols] => size * size * (size + cols),
        _ => dims.iter().product::<u64>().pow(3),
    };
    let rows = dims.iter().copied().max().unwrap_or(1);
    let term = one(arithmetic(&element)) * 2 + one(Class::Move) * 3 + one(Class::Word32) * 2;
    term * terms
        + (one(division(&element)) + one(root(&element))) * rows
        + one(Class::Branch) * terms
}

fn arithmetic(ty: &Type) -> Class {
    Class::arithmetic(ty)
}

fn division(ty: &Type) -> Class {
    match Class::arithmetic(ty) {
        Class::Single => Class::SingleDivision,
        Class::Double => Class::DoubleDivision,
        Class::Word64 => Class::Word64Division,
        _ => Class::Word32Division,
    }
}

fn remainder(ty: &Type) -> Class {
    match Class::arithmetic(ty) {
        Class::Single => Class::SingleRemainder,
        Class::Double => Class::DoubleRemainder,
        _ => division(ty),
    }
}

fn root(ty: &Type) -> Class {
    match Class::arithmetic(ty) {
        Class::Double => Class::DoubleDivision,
        _ => Class::SingleDivision,
    }
}

fn of_intrinsic(intrinsic: Intrinsic, ty: &Type) -> Cost {
    use Intrinsic::{
        Ceil, Clamp, CountOnes, DivEuclid, Floor, LeadingZeros, RemEuclid, Round, Sqrt, SwapBytes,
        TrailingZeros, Trunc, WrappingDiv, WrappingRem,
    };
    let word = one(arithmetic(ty)) + one(Class::Branch);
    match intrinsic {
        Sqrt => one(root(ty)),
        WrappingDiv | WrappingRem => one(division(ty)) + word,
        // Both take a quotient and a remainder.
        DivEuclid | RemEuclid => one(division(ty)) + one(remainder(ty)) + word * 2,
        // Loops or tables of a few steps where the processor has no instruction.
        Floor | Ceil | Trunc | Round => word * 6,
        CountOnes | LeadingZeros | TrailingZeros | SwapBytes => word * 8,
        Clamp => word * 4,
        _ => word * 3,
    }
}
