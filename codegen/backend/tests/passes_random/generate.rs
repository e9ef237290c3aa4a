//! Random valid modules, small and full of edges: every integer width, arrays, matrices, structs,
//! loops, calls that write through references.

use bessemer_ir::{
    Argument, Arm, BinaryOp, Block, CompareOp, Const, Enum, EnumId, Expr, ExprKind, Fault, Field,
    Float, Function, FunctionId, Given, Int, Intrinsic, Local, LocalId, LogicOp, Mode, Module,
    Place, Role, Routine, Scalar, Span, Step, Stmt, StmtKind, Struct, StructId, Type, UnaryOp,
    Variant,
};

/// xorshift64*.
pub struct Random(u64);

impl Random {
    pub fn new(seed: u64) -> Random {
        Random(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1)
    }
    pub fn next(&mut self) -> u64 {
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        self.0.wrapping_mul(0x2545_F491_4F6C_DD1D)
    }
    pub fn below(&mut self, end: usize) -> usize {
        (self.next() >> 33) as usize % end
    }
    pub fn chance(&mut self, percent: usize) -> bool {
        self.below(100) < percent
    }
    pub fn pick<'a, T>(&mut self, from: &'a [T]) -> &'a T {
        &from[self.below(from.len())]
    }
    /// A word of a type, edges preferred.
    pub fn word(&mut self, ty: &Type) -> u64 {
        match ty {
            Type::Scalar(Scalar::Bool) => self.next() & 1,
            Type::Scalar(Scalar::Int(int)) => {
                let int = *int;
                let any = self.next() as i128;
                let small = self.below(5) as i128;
                let edges = [int.min(), int.min() + 1, int.max() - 1, int.max(), any, 100];
                let value = if self.chance(85) { small } else { *self.pick(&edges) };
                let value = value.clamp(int.min(), int.max());
                if int.signed() { value as i64 as u64 } else { value as u64 }
            }
            Type::Scalar(Scalar::Float(Float::F64)) => {
                let values = [0.0, -0.0, 1.0, -2.5, 3.0, 1e300, f64::INFINITY, f64::NAN];
                self.pick(&values).to_bits()
            }
            Type::Enum(_) => self.below(3) as u64,
            _ => 0,
        }
    }
}

pub const STATE: Type = Type::Struct(StructId(0));
pub const MODE: Type = Type::Enum(EnumId(0));
pub const MATRIX: Type = Type::Matrix { element: Scalar::Float(Float::F64), rows: 2, cols: 2 };

fn int(int: Int) -> Type {
    Type::Scalar(Scalar::Int(int))
}

fn samples() -> Type {
    Type::Array { element: Box::new(int(Int::I64)), len: 4 }
}

fn rows() -> Type {
    Type::Array { element: Box::new(samples()), len: 2 }
}

fn types() -> Vec<Type> {
    let mut types: Vec<Type> = Int::ALL.into_iter().map(int).collect();
    types.extend([Type::BOOL, Type::F64, MODE, STATE, MATRIX, samples(), rows()]);
    types
}

fn word_types() -> Vec<Type> {
    types().into_iter().filter(Type::is_word).collect()
}

fn fields() -> Vec<(&'static str, Type)> {
    vec![
        ("count", int(Int::U8)),
        ("sum", int(Int::I32)),
        ("on", Type::BOOL),
        ("history", samples()),
        ("gains", MATRIX),
    ]
}

/// A module of four functions.
pub fn module(seed: u64) -> Module {
    let mut module =
        Module { name: "random".into(), files: vec!["a.rs".into()], ..Module::default() };
    module.structs.push(Struct {
        name: "State".into(),
        module: "random".into(),
        docs: Vec::new(),
        fields: fields()
            .into_iter()
            .map(|(name, ty)| Field {
                name: name.into(),
                docs: Vec::new(),
                ty,
                given: Given::default(),
            })
            .collect(),
        form: bessemer_ir::Form::Record,
        initial: None,
        defaults: None,
        given: Given::default(),
        span: Span::default(),
    });
    let variant = |name: &str, value| Variant {
        name: name.into(),
        docs: Vec::new(),
        value,
        given: Given::default(),
    };
    module.enums.push(Enum {
        name: "Mode".into(),
        module: "random".into(),
        docs: Vec::new(),
        variants: vec![variant("Idle", 40), variant("Climb", -7), variant("Land", 200)],
        given: Given::default(),
        span: Span::default(),
    });
    let mut random = Random::new(seed);
    for (name, ty) in [("LIMIT", int(Int::I32)), ("SIZE", Type::USIZE), ("GAIN", Type::F64)] {
        let words = vec![random.word(&ty)];
        module.consts.push(Const {
            name: name.into(),
            module: "random".into(),
            ty,
            words,
            docs: Vec::new(),
            given: Given::default(),
            span: Span::default(),
        });
    }
    for index in 0..4 {
        let function = Generator::function(&module, &mut random, index);
        module.functions.push(function);
    }
    module
}

struct Generator<'a> {
    module: &'a Module,
    random: &'a mut Random,
    locals: Vec<Local>,
    scope: Vec<LocalId>,
    fixed: Vec<LocalId>,
    loops: usize,
    line: u32,
    result: Type,
    calls: usize,
}

impl Generator<'_> {
    fn function(module: &Module, random: &mut Random, index: usize) -> Function {
        let pool = if random.chance(40) { word_types() } else { types() };
        let result = random.pick(&pool).clone();
        let mut generator = Generator {
            module,
            random,
            locals: Vec::new(),
            scope: Vec::new(),
            fixed: Vec::new(),
            loops: 0,
            line: index as u32 * 10_000 + 1,
            result: result.clone(),
            calls: 0,
        };
        generator.parameters(&pool);
        let params = generator.locals.len() as u32;
        let mut body = generator.block(3);
        let span = generator.span();
        let value = generator.value(&result, 3);
        body.0.push(stmt(StmtKind::Return(Some(value)), span));
        Function {
            name: format!("f{index}"),
            module: "random".into(),
            owner: None,
            role: Role::Public,
            attributes: Default::default(),
            docs: Vec::new(),
            locals: generator.locals,
            params,
            result,
            result_name: "output".into(),
            body,
            kernel: None,
            span,
        }
    }

    fn parameters(&mut self, pool: &[Type]) {
        for index in 0..1 + self.random.below(4) {
            let ty = self.random.pick(pool).clone();
            let mode = match self.random.below(10) {
                0..5 => Mode::Value,
                5..7 => Mode::Ref,
                _ => Mode::RefMut,
            };
            let local = self.local(format!("p{index}"), ty, mode);
            if mode == Mode::Ref {
                self.fixed.push(local);
            }
        }
    }

    fn local(&mut self, name: String, ty: Type, mode: Mode) -> LocalId {
        let id = LocalId(self.locals.len() as u32);
        let span = self.span();
        self.locals.push(Local { name, ty, mode, span });
        self.scope.push(id);
        id
    }

    fn span(&mut self) -> Span {
        self.line += 1;
        Span { file: 0, line: self.line, column: 1 }
    }

    fn block(&mut self, depth: usize) -> Block {
        let scope = self.scope.len();
        let count = 1 + self.random.below(4);
        let mut block = Vec::new();
        for _ in 0..count {
            let span = self.span();
            let kind = self.kind(depth);
            block.push(stmt(kind, span));
        }
        self.scope.truncate(scope);
        Block(block)
    }

    fn kind(&mut self, depth: usize) -> StmtKind {
        match self.random.below(if depth == 0 { 11 } else { 18 }) {
            0..4 => self.declare(),
            4..8 => self.assign(),
            8 => {
                let condition = self.value(&Type::BOOL, 2);
                StmtKind::Check { condition, fault: Fault::Assertion }
            }
            9 => self.effect(),
            10 if self.loops > 0 && self.random.chance(50) => StmtKind::Break,
            10 if self.loops > 0 => StmtKind::Continue,
            10 if self.random.chance(10) => {
                let result = self.result.clone();
                StmtKind::Return(Some(self.value(&result, 2)))
            }
            10 => self.declare(),
            11..14 => {
                let condition = self.value(&Type::BOOL, 3);
                let then = self.block(depth - 1);
                let otherwise =
                    if self.random.chance(50) { self.block(depth - 1) } else { Block::default() };
                StmtKind::If { condition, then, otherwise }
            }
            14 => self.choose(depth),
            _ if self.loops < 2 => self.repeat(depth),
            _ => self.assign(),
        }
    }

    fn declare(&mut self) -> StmtKind {
        let ty = self.random.pick(&types()).clone();
        let value = self.value(&ty, 3);
        let name = format!("x{}", self.locals.len());
        let local = self.local(name, ty, Mode::Value);
        StmtKind::Let { local, value: Some(value) }
    }

    fn assign(&mut self) -> StmtKind {
        let ty = self.random.pick(&types()).clone();
        let value = self.value(&ty, 3);
        match self.place(&ty, true, 2) {
            Some(place) => StmtKind::Assign { place, value },
            None => StmtKind::Expr(value),
        }
    }

    fn effect(&mut self) -> StmtKind {
        let results: Vec<Type> = self.module.functions.iter().map(|f| f.result.clone()).collect();
        let ty = if results.is_empty() { Type::BOOL } else { self.random.pick(&results).clone() };
        StmtKind::Expr(match self.call(&ty, 3) {
            Some(call) => call,
            None => self.value(&Type::BOOL, 2),
        })
    }

    fn choose(&mut self, depth: usize) -> StmtKind {
        let whole = self.random.chance(50);
        let ty = if whole { MODE } else { int(Int::I16) };
        let scrutinee = self.value(&ty, 2);
        let arms =
            if whole { vec![vec![0], vec![1, 2]] } else { vec![vec![-1, 0], vec![2], vec![3]] };
        let arms =
            arms.into_iter().map(|values| Arm { values, body: self.block(depth - 1) }).collect();
        let otherwise = (!whole).then(|| self.block(depth - 1));
        StmtKind::Match { scrutinee, arms, otherwise }
    }

    fn repeat(&mut self, depth: usize) -> StmtKind {
        let ty = int(*self.random.pick(&Int::ALL));
        let zero = Int::from_word(ty.as_int().unwrap(), 0) as u64;
        let from = self.small(&ty, zero);
        let last = 1 + self.random.below(5) as u64;
        let literal = self.small(&ty, last);
        let to = if self.random.chance(30) {
            let bound = self.value(&ty, 2);
            let span = self.span();
            expr(ExprKind::Intrinsic(Intrinsic::Min, vec![literal, bound]), &ty, span)
        } else {
            literal
        };
        let scope = self.scope.len();
        let variable = self.local(format!("i{}", self.locals.len()), ty, Mode::Value);
        self.fixed.push(variable);
        self.loops += 1;
        let body = self.block(depth - 1);
        self.loops -= 1;
        self.scope.truncate(scope);
        let (inclusive, reversed) = (self.random.chance(40), self.random.chance(30));
        StmtKind::For { variable, from, to, inclusive, reversed, unroll: None, ended: false, body }
    }

    fn small(&mut self, ty: &Type, word: u64) -> Expr {
        let span = self.span();
        expr(ExprKind::Literal(word), ty, span)
    }

    /// A value of a type; anything that Rust's types allow.
    fn value(&mut self, ty: &Type, depth: usize) -> Expr {
        if depth > 0
            && self.random.chance(12)
            && let Some(call) = self.call(ty, depth - 1)
        {
            return call;
        }
        let span = self.span();
        if (depth == 0 || self.random.chance(35))
            && let Some(place) = self.place(ty, false, depth)
        {
            return expr(ExprKind::Load(place), ty, span);
        }
        match ty {
            Type::Scalar(Scalar::Bool) => self.boolean(depth, span),
            Type::Scalar(Scalar::Int(_)) => self.integer(ty, depth, span),
            Type::Scalar(Scalar::Float(_)) => self.float(depth, span),
            Type::Enum(_) => expr(ExprKind::Literal(self.random.word(ty)), ty, span),
            _ => self.aggregate(ty, depth, span),
        }
    }

    fn aggregate(&mut self, ty: &Type, depth: usize, span: Span) -> Expr {
        let less = depth.saturating_sub(1);
        let kind = match ty {
            Type::Struct(_) => {
                ExprKind::Struct(fields().iter().map(|(_, ty)| self.value(ty, less)).collect())
            }
            Type::Array { element, len } => {
                if depth == 0 || self.random.chance(50) {
                    ExprKind::Splat(Box::new(self.value(element, less)))
                } else {
                    ExprKind::Array((0..*len).map(|_| self.value(element, less)).collect())
                }
            }
            _ => return self.matrix(depth, span),
        };
        expr(kind, ty, span)
    }

    fn matrix(&mut self, depth: usize, span: Span) -> Expr {
        let less = depth.saturating_sub(1);
        let choice = if depth == 0 { 0 } else { self.random.below(9) };
        let routine = match choice {
            0 => {
                return expr(
                    ExprKind::Splat(Box::new(self.value(&Type::F64, less))),
                    &MATRIX,
                    span,
                );
            }
            1 => {
                let parts = (0..4).map(|_| self.value(&Type::F64, less)).collect();
                return expr(ExprKind::Matrix(parts), &MATRIX, span);
            }
            2 => Routine::Transpose,
            3 => Routine::Neg,
            4 | 5 => Routine::Scale,
            6 => Routine::Product,
            7 => Routine::TrMul,
            _ => [Routine::Add, Routine::Sup, Routine::Inf][span.line as usize % 3],
        };
        let mut operands = vec![self.value(&MATRIX, less)];
        match routine {
            Routine::Scale => operands.push(self.value(&Type::F64, less)),
            Routine::Transpose | Routine::Neg => {}
            _ => operands.push(self.value(&MATRIX, less)),
        }
        expr(ExprKind::Routine(routine, operands), &MATRIX, span)
    }

    fn boolean(&mut self, depth: usize, span: Span) -> Expr {
        let less = depth.saturating_sub(1);
        let kind = match if depth == 0 { 0 } else { self.random.below(6) } {
            0 => ExprKind::Literal(self.random.next() & 1),
            1 => ExprKind::Unary(UnaryOp::Not, Box::new(self.value(&Type::BOOL, less))),
            2 | 3 => {
                let (a, b) = (self.value(&Type::BOOL, less), self.value(&Type::BOOL, less));
                let op = *self.random.pick(&[LogicOp::And, LogicOp::Or]);
                ExprKind::Logic(op, Box::new(a), Box::new(b))
            }
            _ => {
                let ty = self.random.pick(&word_types()).clone();
                let (a, b) = (self.value(&ty, less), self.value(&ty, less));
                use CompareOp::{Eq, Ge, Gt, Le, Lt, Ne};
                let all = [Eq, Ne, Lt, Le, Gt, Ge];
                let only = if matches!(ty, Type::Enum(_)) { &all[..2] } else { &all[..] };
                ExprKind::Compare(*self.random.pick(only), Box::new(a), Box::new(b))
            }
        };
        expr(kind, &Type::BOOL, span)
    }

    fn integer(&mut self, ty: &Type, depth: usize, span: Span) -> Expr {
        use BinaryOp::{Add, And, Div, Mul, Or, Rem, Shl, Shr, Sub, Xor};
        let less = depth.saturating_sub(1);
        let signed = ty.as_int().is_some_and(Int::signed);
        let kind = match if depth == 0 { 0 } else { self.random.below(12) } {
            0 | 1 => ExprKind::Literal(self.random.word(ty)),
            2 if *ty == Type::USIZE => ExprKind::Const(bessemer_ir::ConstId(1)),
            2 if *ty == int(Int::I32) => ExprKind::Const(bessemer_ir::ConstId(0)),
            3 if signed => ExprKind::Unary(UnaryOp::Neg, Box::new(self.value(ty, less))),
            3 => ExprKind::Unary(UnaryOp::Not, Box::new(self.value(ty, less))),
            4 => {
                let from = self.random.pick(&word_types()).clone();
                ExprKind::Cast(Box::new(self.value(&from, less)))
            }
            5 | 6 => {
                use Intrinsic::{Abs, Clamp, Max, Min, WrappingAdd, WrappingMul, WrappingSub};
                let all = [Min, Max, WrappingAdd, WrappingSub, WrappingMul, Clamp, Abs];
                let which = *self.random.pick(if signed { &all } else { &all[..6] });
                let count = [2, 3, 1][usize::from(which == Clamp) + 2 * usize::from(which == Abs)];
                ExprKind::Intrinsic(which, (0..count).map(|_| self.value(ty, less)).collect())
            }
            _ => {
                let all = [Add, Add, Sub, Sub, Mul, Mul, Div, Rem, And, Or, Xor, Shl, Shr];
                let op = *self.random.pick(&all);
                let shift = matches!(op, Shl | Shr) && self.random.chance(50);
                let a = self.value(ty, less);
                let right = if shift { int(*self.random.pick(&Int::ALL)) } else { ty.clone() };
                ExprKind::Binary(op, Box::new(a), Box::new(self.value(&right, less)))
            }
        };
        expr(kind, ty, span)
    }

    fn float(&mut self, depth: usize, span: Span) -> Expr {
        let less = depth.saturating_sub(1);
        let ty = Type::F64;
        let kind = match if depth == 0 { 0 } else { self.random.below(7) } {
            0 => ExprKind::Literal(self.random.word(&ty)),
            1 => ExprKind::Const(bessemer_ir::ConstId(2)),
            2 => ExprKind::Routine(Routine::Norm, vec![self.value(&MATRIX, less)]),
            3 => {
                let operands = (0..3).map(|_| self.value(&ty, less)).collect();
                ExprKind::Intrinsic(Intrinsic::Clamp, operands)
            }
            4 => {
                let from = int(*self.random.pick(&Int::ALL));
                ExprKind::Cast(Box::new(self.value(&from, less)))
            }
            _ => {
                let (a, b) = (self.value(&ty, less), self.value(&ty, less));
                ExprKind::Binary(BinaryOp::Add, Box::new(a), Box::new(b))
            }
        };
        expr(kind, &ty, span)
    }

    /// A place of a type in scope, if there is one.
    fn place(&mut self, ty: &Type, write: bool, depth: usize) -> Option<Place> {
        let roots: Vec<LocalId> = self
            .scope
            .iter()
            .copied()
            .filter(|id| !write || !self.fixed.contains(id))
            .filter(|id| reaches(&self.locals[id.index()].ty, ty))
            .collect();
        if roots.is_empty() {
            return None;
        }
        let root = *self.random.pick(&roots);
        let mut at = self.locals[root.index()].ty.clone();
        let mut steps = Vec::new();
        while at != *ty {
            let (step, next) = self.step(&at, ty, depth);
            steps.push(step);
            at = next;
        }
        let span = self.span();
        Some(Place { root, steps, ty: ty.clone(), span })
    }

    fn step(&mut self, from: &Type, to: &Type, depth: usize) -> (Step, Type) {
        match from {
            Type::Struct(_) => {
                let fields: Vec<(usize, Type)> = fields()
                    .into_iter()
                    .map(|(_, ty)| ty)
                    .enumerate()
                    .filter(|(_, ty)| reaches(ty, to))
                    .collect();
                let (field, ty) = self.random.pick(&fields).clone();
                (Step::Field(field as u32), ty)
            }
            Type::Array { element, len } => {
                (Step::Index(self.index(u64::from(*len), depth)), (**element).clone())
            }
            // The interpreter checks a row before it evaluates the column; Rust after. So no faults.
            _ => (Step::Element(self.index(2, 0), self.index(2, 0)), Type::F64),
        }
    }

    fn index(&mut self, len: u64, depth: usize) -> Expr {
        let ty =
            if self.random.chance(60) { Type::USIZE } else { int(*self.random.pick(&Int::ALL)) };
        if depth > 0 && self.random.chance(60) {
            return self.value(&ty, depth - 1);
        }
        let word = self.random.next() % (len + u64::from(self.random.chance(5)));
        let span = self.span();
        expr(ExprKind::Literal(word), &ty, span)
    }

    /// A call of an earlier function with this result; what it may write, nothing else of it refers to.
    fn call(&mut self, ty: &Type, depth: usize) -> Option<Expr> {
        let fitting: Vec<usize> = (0..self.module.functions.len())
            .filter(|index| self.module.functions[*index].result == *ty)
            .collect();
        if fitting.is_empty() || self.calls > 12 {
            return None;
        }
        self.calls += 1;
        let callee = *self.random.pick(&fitting);
        let parameters = self.module.functions[callee].parameters().to_vec();
        let mut lent: Vec<LocalId> = Vec::new();
        let mut arguments = Vec::new();
        for parameter in parameters {
            let ty = &parameter.ty;
            arguments.push(match parameter.mode {
                Mode::Value => Argument::Value(self.value(ty, depth.min(2))),
                Mode::Ref => {
                    let value = self.value(ty, depth.min(2));
                    if let ExprKind::Load(place) = &value.kind {
                        if lent.contains(&place.root) {
                            return None;
                        }
                        lent.push(place.root);
                    }
                    Argument::Ref(value)
                }
                Mode::RefMut => {
                    let place = self.place(ty, true, depth.min(2))?;
                    if lent.contains(&place.root) {
                        return None;
                    }
                    lent.push(place.root);
                    Argument::RefMut(place)
                }
            });
        }
        let span = self.span();
        Some(expr(ExprKind::Call(FunctionId(callee as u32), arguments), ty, span))
    }
}

fn reaches(from: &Type, to: &Type) -> bool {
    from == to
        || match from {
            Type::Struct(_) => fields().iter().any(|(_, ty)| reaches(ty, to)),
            Type::Array { element, .. } => reaches(element, to),
            Type::Matrix { element, .. } => Type::Scalar(*element) == *to,
            _ => false,
        }
}

fn stmt(kind: StmtKind, span: Span) -> Stmt {
    Stmt { kind, span, comments: Vec::new() }
}

fn expr(kind: ExprKind, ty: &Type, span: Span) -> Expr {
    Expr { kind, ty: ty.clone(), span }
}
