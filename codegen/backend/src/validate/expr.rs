//! Checks of expressions and places, bottom-up.
//!
//! The stated type of each node is compared with the type that follows from its kind and its operands' stated types,
//! so one wrong node is one error.

use bessemer_ir::{
    Argument, BinaryOp, Expr, ExprKind, Form, FunctionId, Int, Intrinsic, Mode, Place, Routine,
    Scalar, Step, Type, UnaryOp,
};

use bessemer_ir::alias::conflicts;

use super::body::Body;
use super::items::check_span;
use super::problem::Problem;
use bessemer_ir::words::word_fits;

type Checked = Result<Type, Problem>;

impl Body<'_> {
    /// Checks an expression whose value is used.
    pub fn value(&mut self, expr: &Expr) {
        self.expr(expr);
        if expr.ty == Type::Unit {
            self.note(expr.span, Err(Problem::UnitValue));
        }
    }

    /// Checks an expression whose value may be unused.
    pub fn expr(&mut self, expr: &Expr) {
        self.note(expr.span, check_span(self.module, expr.span));
        match self.operation(expr) {
            Ok(ty) => {
                self.expect(expr.span, &ty, &expr.ty);
                if expr.ty.is_aggregate() {
                    let size = self.sizes.of(&expr.ty).map(|_| ());
                    self.note(expr.span, size);
                }
            }
            Err(problem) => self.note(expr.span, Err(problem)),
        }
    }

    fn values(&mut self, operands: &[Expr]) {
        for operand in operands {
            self.value(operand);
        }
    }

    /// Returns the type of an expression according to its operands.
    fn operation(&mut self, expr: &Expr) -> Checked {
        match &expr.kind {
            ExprKind::Literal(word) => {
                if word_fits(self.module, &expr.ty, *word) {
                    Ok(expr.ty.clone())
                } else {
                    Err(Problem::LiteralWord { word: *word, ty: expr.ty.clone() })
                }
            }
            ExprKind::Const(id) => {
                let found = self.module.consts.get(id.index());
                found.map(|found| found.ty.clone()).ok_or(Problem::UnknownConst(*id))
            }
            ExprKind::Load(place) => {
                if self.place(place) {
                    let read = self.flow.read(place.root);
                    self.note(place.span, read);
                }
                Ok(place.ty.clone())
            }
            ExprKind::Unary(op, operand) => {
                self.value(operand);
                unary(*op, &operand.ty)
            }
            ExprKind::Binary(op, left, right) => {
                self.value(left);
                self.value(right);
                binary(*op, &left.ty, &right.ty)
            }
            ExprKind::Compare(_, left, right) => {
                self.value(left);
                self.value(right);
                if !left.ty.is_word() {
                    return Err(Problem::CompareOperand(left.ty.clone()));
                }
                same(&left.ty, &right.ty)?;
                Ok(Type::BOOL)
            }
            ExprKind::Logic(_, left, right) => {
                self.value(left);
                self.value(right);
                same(&Type::BOOL, &left.ty)?;
                same(&Type::BOOL, &right.ty)
            }
            ExprKind::Cast(operand) => {
                self.value(operand);
                cast(&operand.ty, &expr.ty)
            }
            ExprKind::Intrinsic(function, operands) => {
                self.values(operands);
                intrinsic(*function, operands)
            }
            ExprKind::Call(callee, arguments) => self.call(expr, *callee, arguments),
            ExprKind::Struct(parts) => {
                self.values(parts);
                self.structure(&expr.ty, parts)
            }
            ExprKind::Array(_) | ExprKind::Splat(_) | ExprKind::Matrix(_) => self.filled(expr),
            ExprKind::Routine(what, operands) => {
                self.values(operands);
                routine(*what, operands)
            }
        }
    }

    fn structure(&self, ty: &Type, parts: &[Expr]) -> Checked {
        let definition = match ty {
            Type::Struct(id) => self.module.structs.get(id.index()),
            _ => None,
        };
        let Some(definition) = definition else { return Err(Problem::Parts(ty.clone())) };
        counted(definition.fields.len(), parts)?;
        for (field, part) in definition.fields.iter().zip(parts) {
            same(&field.ty, &part.ty)?;
        }
        let chosen = match (&definition.form, parts.first().map(|part| &part.kind)) {
            (Form::Choice(cases), Some(ExprKind::Literal(word))) => *word < cases.len() as u64,
            (Form::Choice(_), _) => false,
            _ => true,
        };
        if !chosen {
            return Err(Problem::OpenChoice);
        }
        Ok(ty.clone())
    }

    /// Checks an array or a matrix, and returns its type.
    fn filled(&mut self, expr: &Expr) -> Checked {
        let scalar;
        let (element, count) = match &expr.ty {
            Type::Array { element, len } => (&**element, *len as usize),
            Type::Matrix { element, rows, cols } => {
                scalar = Type::Scalar(*element);
                (&scalar, (*rows as usize).saturating_mul(*cols as usize))
            }
            other => return Err(Problem::Parts(other.clone())),
        };
        let array = matches!(expr.ty, Type::Array { .. });
        match &expr.kind {
            ExprKind::Splat(part) => {
                self.value(part);
                same(element, &part.ty)?;
                Ok(expr.ty.clone())
            }
            ExprKind::Array(parts) | ExprKind::Matrix(parts) => {
                self.values(parts);
                if array != matches!(expr.kind, ExprKind::Array(_)) {
                    return Err(Problem::Parts(expr.ty.clone()));
                }
                counted(count, parts)?;
                for part in parts {
                    same(element, &part.ty)?;
                }
                Ok(expr.ty.clone())
            }
            _ => unreachable!("called for arrays, splats and matrices"),
        }
    }

    fn call(&mut self, expr: &Expr, callee: FunctionId, arguments: &[Argument]) -> Checked {
        for argument in arguments {
            match argument {
                Argument::Ref(Expr { kind: ExprKind::Load(place), ty, span })
                    if matches!(ty, Type::Slice(_)) =>
                {
                    if self.place(place) {
                        let read = self.flow.read(place.root);
                        self.note(place.span, read);
                    }
                    self.expect(*span, &place.ty, ty);
                }
                Argument::Value(value) | Argument::Ref(value) => self.value(value),
                Argument::RefMut(place) => {
                    if self.place(place) {
                        let written = self.flow.write(place.root, false);
                        self.note(place.span, written);
                    }
                }
            }
        }
        for index in conflicts(arguments) {
            self.note(expr.span, Err(Problem::Alias(index)));
        }
        let Some(function) = self.module.functions.get(callee.index()) else {
            return Err(Problem::UnknownFunction(callee));
        };
        if callee.index() >= self.index {
            return Err(Problem::LaterFunction(callee));
        }
        let parameters = function.parameters();
        if parameters.len() != arguments.len() {
            let (expected, found) = (parameters.len(), arguments.len());
            return Err(Problem::OperandCount { expected, found });
        }
        for (index, (parameter, argument)) in parameters.iter().zip(arguments).enumerate() {
            let (mode, span, ty) = match argument {
                Argument::Value(value) => (Mode::Value, value.span, &value.ty),
                Argument::Ref(value) => (Mode::Ref, value.span, &value.ty),
                Argument::RefMut(place) => (Mode::RefMut, place.span, &place.ty),
            };
            if mode != parameter.mode {
                self.note(span, Err(Problem::ArgumentMode(index)));
            }
            self.expect(span, &parameter.ty, ty);
        }
        Ok(function.result.clone())
    }

    /// Checks a place's steps and indices; returns true if its root exists, so that its use can be checked.
    pub fn place(&mut self, place: &Place) -> bool {
        self.note(place.span, check_span(self.module, place.span));
        let Some(root) = self.function.locals.get(place.root.index()) else {
            self.note(place.span, Err(Problem::UnknownLocal(place.root)));
            return false;
        };
        let mut ty = root.ty.clone();
        let mut whole = ty.clone();
        for (index, step) in place.steps.iter().enumerate() {
            // A part from an element on ends a place: passes and interpreter find the length of a slice by the place's root.
            let ended = index > 0 && matches!(place.steps[index - 1], Step::From(_));
            match self.step(step, &ty).filter(|_| !ended) {
                Some(inner) => whole = std::mem::replace(&mut ty, inner),
                None => {
                    self.note(place.span, Err(Problem::Step { step: index, ty }));
                    return true;
                }
            }
        }
        if !is_part(place, &whole) {
            self.expect(place.span, &ty, &place.ty);
        }
        true
    }

    /// Returns the type to which a step leads.
    fn step(&mut self, step: &Step, ty: &Type) -> Option<Type> {
        let indices: Vec<&Expr> = match step {
            Step::Field(_) => Vec::new(),
            Step::Index(index) | Step::From(index) => vec![index],
            Step::Element(row, col) => vec![row, col],
        };
        for index in indices {
            self.value(index);
            if index.ty.as_int().is_none() {
                self.note(index.span, Err(Problem::IndexType(index.ty.clone())));
            }
        }
        self.module.step_type(ty, step)
    }
}

/// Returns true if a place is an array or a matrix that lies within an array, `whole`, from a fixed element on.
fn is_part(place: &Place, whole: &Type) -> bool {
    let (Type::Array { element, len }, Some(Step::From(from))) = (whole, place.steps.last()) else {
        return false;
    };
    let (alike, own) = match &place.ty {
        Type::Array { element: own, len } => (own == element, *len),
        Type::Matrix { element: own, rows, cols } => (Type::Scalar(*own) == **element, rows * cols),
        _ => return false,
    };
    let end = |from: u64| from.saturating_add(own.into());
    alike && matches!(from.kind, ExprKind::Literal(word) if end(word) <= u64::from(*len))
}

fn same(expected: &Type, found: &Type) -> Checked {
    if expected == found {
        Ok(expected.clone())
    } else {
        Err(Problem::TypeMismatch { expected: expected.clone(), found: found.clone() })
    }
}

fn counted(expected: usize, operands: &[Expr]) -> Result<(), Problem> {
    let found = operands.len();
    if expected == found { Ok(()) } else { Err(Problem::OperandCount { expected, found }) }
}

/// Scalar types that an operation accepts.
#[derive(Clone, Copy)]
struct Kind {
    signed: bool,
    integer: bool,
    float: bool,
    bits: bool,
}

fn kind(ty: &Type) -> Kind {
    let (int, float) = (ty.as_int(), ty.as_float().is_some());
    Kind {
        signed: float || int.is_some_and(Int::signed),
        integer: int.is_some(),
        float,
        bits: int.is_some() || *ty == Type::BOOL,
    }
}

fn unary(op: UnaryOp, ty: &Type) -> Checked {
    let fits = match op {
        UnaryOp::Neg => kind(ty).signed,
        UnaryOp::Not => kind(ty).bits,
    };
    if fits { Ok(ty.clone()) } else { Err(Problem::UnaryOperand { op, ty: ty.clone() }) }
}

fn binary(op: BinaryOp, left: &Type, right: &Type) -> Checked {
    let Kind { integer, float, bits, .. } = kind(left);
    let shift = matches!(op, BinaryOp::Shl | BinaryOp::Shr);
    let fits = match op {
        BinaryOp::Add | BinaryOp::Sub | BinaryOp::Mul | BinaryOp::Div | BinaryOp::Rem => {
            integer || float
        }
        BinaryOp::And | BinaryOp::Or | BinaryOp::Xor => bits,
        BinaryOp::Shl | BinaryOp::Shr => integer,
    };
    if !fits {
        return Err(Problem::BinaryOperand { op, ty: left.clone() });
    }
    if !shift {
        return same(left, right);
    }
    if right.as_int().is_none() {
        return Err(Problem::BinaryOperand { op, ty: right.clone() });
    }
    Ok(left.clone())
}

fn cast(from: &Type, to: &Type) -> Checked {
    use Scalar::{Bool, Int};
    let fits = match (from, to) {
        (Type::Scalar(Bool), Type::Scalar(to)) => matches!(to, Bool | Int(_)),
        (Type::Enum(_), Type::Scalar(to)) => matches!(to, Int(_)),
        (Type::Scalar(from), Type::Scalar(to)) => *from != Bool && *to != Bool,
        _ => false,
    };
    if fits { Ok(to.clone()) } else { Err(Problem::Cast { from: from.clone(), to: to.clone() }) }
}

fn intrinsic(function: Intrinsic, operands: &[Expr]) -> Checked {
    counted(function.operands(), operands)?;
    let ty = &operands[0].ty;
    for operand in operands {
        same(ty, &operand.ty)?;
    }
    let result = match ty {
        Type::Scalar(scalar) => function.result(*scalar).map(Type::Scalar),
        Type::Enum(_) if function == Intrinsic::Variant => Some(ty.clone()),
        _ => None,
    };
    result.ok_or_else(|| Problem::IntrinsicOperand { function, ty: ty.clone() })
}

fn routine(what: Routine, operands: &[Expr]) -> Checked {
    let count = match what {
        Routine::Neg | Routine::Abs | Routine::Transpose => 1,
        Routine::Norm | Routine::NormSquared | Routine::Amax | Routine::Amin => 1,
        _ => 2,
    };
    counted(count, operands)?;
    let types: Vec<Type> = operands.iter().map(|operand| operand.ty.clone()).collect();
    match shape(what, &types[0], types.get(1)) {
        Some(result) => Ok(result),
        None => Err(Problem::Shape { routine: what, operands: types }),
    }
}

/// Returns the type of a routine's result, if the operands fit.
fn shape(what: Routine, first: &Type, second: Option<&Type>) -> Option<Type> {
    let &Type::Matrix { element, rows, cols } = first else { return None };
    if what != Routine::Transpose && !matches!(element, Scalar::Float(_)) {
        return None;
    }
    let matrix = |rows, cols| Some(Type::Matrix { element, rows, cols });
    let other = || match second {
        Some(&Type::Matrix { element: other, rows, cols }) if other == element => {
            Some((rows, cols))
        }
        _ => None,
    };
    let alike = |result: &Type| (second == Some(first)).then(|| result.clone());
    match what {
        Routine::Add | Routine::Sub => alike(first),
        Routine::ComponentMul | Routine::ComponentDiv => alike(first),
        Routine::Inf | Routine::Sup => alike(first),
        Routine::Scale | Routine::Unscale => {
            (second == Some(&Type::Scalar(element))).then(|| first.clone())
        }
        Routine::Product => match other()? {
            (inner, outer) if inner == cols => matrix(rows, outer),
            _ => None,
        },
        Routine::TrMul => match other()? {
            (inner, outer) if inner == rows => matrix(cols, outer),
            _ => None,
        },
        Routine::Cross => match (rows, cols) {
            (3, 1) | (1, 3) => alike(first),
            _ => None,
        },
        Routine::Dot => alike(&Type::Scalar(element)),
        Routine::Neg | Routine::Abs => Some(first.clone()),
        Routine::Transpose => matrix(cols, rows),
        Routine::Norm | Routine::NormSquared => Some(Type::Scalar(element)),
        Routine::Amax | Routine::Amin => Some(Type::Scalar(element)),
    }
}
