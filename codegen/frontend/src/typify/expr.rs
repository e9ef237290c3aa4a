//! Lowers expressions: the type of each follows from its operands, and must agree with rustc's slot.

use bessemer_ir::tree::{self, BinaryOp as Op, Role, Site};
use bessemer_ir::{
    BinaryOp, CompareOp, Expr, ExprKind, Float, Int, KernelRoutine, LogicOp, Routine, Scalar, Span,
    Type, UnaryOp, Written,
};

use super::expand::is_ours;
use super::function::takes_closures;
use super::implied::{conversion, own_comparison};
use super::kernels::{kernel_of, matrix_of_factors};
use super::lengths::plus;
use super::lowering::Lowering;
use super::syntax::{bare, control_with_value, is_question, numbered};
use super::words;
use super::{Needed, OUR_FAULT, Result, literal, problem, refusals, refused};

/// An operand to be lowered: the expression, its expected type, and its role, which names its temporary.
pub(super) struct Operand<'e> {
    pub expr: &'e tree::Expr,
    pub expected: Option<Type>,
    pub role: &'e str,
}

/// A call of an operation of the DSL: its arguments, and the whole expression.
#[derive(Clone, Copy)]
pub(super) struct Call<'e> {
    pub arguments: &'e [tree::Expr],
    pub expr: &'e tree::Expr,
}

/// Remedy for an operator without an implementation in the DSL.
const OPERATOR: &str = "of a type of your own: mark the `impl` block of the operator `#[data]`; of a type parameter: call the operator where the type is known";

impl Lowering<'_, '_> {
    /// Lowers `expr` to a value, and emits the statements that it needs before.
    pub(super) fn value(&mut self, expr: &tree::Expr, expected: Option<&Type>) -> Result<Expr> {
        if let Some(other) = self.in_place(expr) {
            return self.value(&other, expected);
        }
        if self.holds_nothing(expr) {
            self.effect(expr)?;
            return Ok(self.nothing(expr.site));
        }
        if let Some(slice) = self.wanted_slice(expr, expected)? {
            return Ok(slice);
        }
        if let Some(place) = self.lent_place(expr)? {
            return Ok(place.load());
        }
        let value = match self.expansion(expr) {
            Some(expansion) => self.expanded_value(expansion, expected, expr.site)?,
            None => self.bare_value(expr, expected)?,
        };
        self.cx.typed.expressions += 1;
        if let Some(slot) = expr.slot {
            let rustc = self.seen(slot, expr.site)?;
            self.agree(&value.ty, &rustc, expr.site)?;
            self.cx.typed.agreed += 1;
        }
        Ok(value)
    }

    pub(super) fn bare_value(
        &mut self,
        expr: &tree::Expr,
        expected: Option<&Type>,
    ) -> Result<Expr> {
        let site = expr.site;
        match &expr.kind {
            tree::ExprKind::Bool(value) => Ok(Expr::bool(*value, self.span(site))),
            tree::ExprKind::Int(digits, suffix) => {
                let seen = expr.slot.map(|slot| self.seen(slot, site)).transpose()?;
                self.integer(digits, false, *suffix, seen.as_ref().or(expected), site)
            }
            tree::ExprKind::Float(digits, suffix) => {
                let scalar = literal::type_of(*suffix, expected, Scalar::Float(Float::F64));
                let word = literal::float(digits, scalar, site)?;
                self.node(ExprKind::Literal(word), Type::Scalar(scalar), site)
            }
            tree::ExprKind::Bytes(bytes) => {
                let (element, span) = (Type::Scalar(Scalar::Int(Int::U8)), self.span(site));
                let item = |byte: &u8| Expr::literal((*byte).into(), element.clone(), span);
                let items = bytes.iter().map(item).collect();
                let ty = Type::Array { element: Box::new(element), len: bytes.len() as u32 };
                self.node(ExprKind::Array(items), ty, site)
            }
            tree::ExprKind::Path(index, name) => self.path(*index, name, site),
            tree::ExprKind::Local(name) => self.named(name, site),
            tree::ExprKind::Unary(op, operand) => match self.operator(expr.slot).cloned() {
                Some(callee) => self.call_of(&callee, std::slice::from_ref(&**operand), expr),
                None => self.unary(*op, operand, expected, site),
            },
            tree::ExprKind::Field(base, name) if name == "coords" && self.in_coords(expr)? => {
                self.coords(base, site)
            }
            tree::ExprKind::Field(base, name)
                if let Some(part) = literal::literal_part(self, base, name) =>
            {
                Ok(part)
            }
            tree::ExprKind::Binary(op, left, right) => self.binary(*op, left, right, expr),
            tree::ExprKind::Call(callee, arguments) => self.call(*callee, arguments, expr),
            tree::ExprKind::Apply(name, arguments) => self.apply(name, arguments, site),
            tree::ExprKind::Closure(_) => refused(site, refusals::CLOSURE_ARGUMENT),
            tree::ExprKind::Struct(name, fields, rest) => {
                self.struct_value(name, fields, rest.as_deref(), expr)
            }
            tree::ExprKind::Constructor(name, parts) => {
                self.constructed(name, parts, expected, expr)
            }
            tree::ExprKind::Tuple(parts) if !parts.is_empty() => match (expr.slot, expected) {
                // One that no author wrote is of the type that is wanted.
                (None, Some(Type::Struct(id))) => self.parts(*id, &numbered(parts), None, expr),
                _ => self.constructed("", parts, None, expr),
            },
            tree::ExprKind::Try(label, operand) => self
                .try_value(label.as_deref(), operand, site)?
                .or_refused(site, refusals::STATEMENT),
            tree::ExprKind::Array(elements) => self.array(elements, expr),
            tree::ExprKind::Repeat(element) => {
                let ty = self.slot_of(expr)?;
                let inner = elements_of(&ty).needed(site, "this is not an array")?;
                let element = self.value(element, Some(inner))?;
                self.node(ExprKind::Splat(Box::new(element)), ty, site)
            }
            tree::ExprKind::Cast(operand) => self.cast(operand, expr),
            tree::ExprKind::Match(scrutinee, arms) if is_question(arms) => {
                self.question(scrutinee, &arms[0], site)
            }
            tree::ExprKind::Fold { .. } => {
                let local = self.lower_fold(expr, None)?;
                let span = self.span(site);
                Ok(Expr::local(local, &self.locals[local.index()].ty, span))
            }
            tree::ExprKind::Ref(false, part) | tree::ExprKind::Deref(part)
                if self.is_submatrix(part) =>
            {
                self.read(part, None)
            }
            tree::ExprKind::Deref(part) if let Some(part) = self.part_named(part) => {
                self.part_value(&part, site)
            }
            _ if control_with_value(expr) => self.control_value(expr, expected),
            _ => match self.place(expr)? {
                Some(place) => Ok(place.load().at(self.span(site))),
                None => match &expr.kind {
                    tree::ExprKind::Ref(_, inner) | tree::ExprKind::Deref(inner) => {
                        self.value(inner, expected)
                    }
                    _ => refused(site, refusals::NO_VALUE),
                },
            },
        }
    }

    pub(super) fn node(&mut self, kind: ExprKind, ty: Type, site: Site) -> Result<Expr> {
        let span = self.span(site);
        Ok(Expr { kind, ty, span })
    }

    pub(super) fn slot_of(&mut self, expr: &tree::Expr) -> Result<Type> {
        let slot = expr.slot.needed(expr.site, "rustc was not asked for this type")?;
        self.seen(slot, expr.site)
    }

    fn integer(
        &mut self,
        digits: &str,
        negative: bool,
        suffix: Option<Scalar>,
        expected: Option<&Type>,
        site: Site,
    ) -> Result<Expr> {
        if let (None, Some(ty)) = (suffix, expected)
            && literal::is_wide(self.cx, ty)
        {
            return literal::wide_integer(self, digits, negative, ty, site);
        }
        let scalar = literal::type_of(suffix, expected, Scalar::Int(Int::I32));
        let word = literal::integer(digits, negative, scalar, site)?;
        if digits.starts_with("0x") {
            let span = self.span(site);
            self.cx.module.written.insert((span, word), Written::Hexadecimal);
        }
        self.node(ExprKind::Literal(word), Type::Scalar(scalar), site)
    }

    pub(super) fn unary(
        &mut self,
        op: tree::UnaryOp,
        operand: &tree::Expr,
        expected: Option<&Type>,
        site: Site,
    ) -> Result<Expr> {
        if let (tree::UnaryOp::Neg, tree::ExprKind::Int(digits, suffix)) = (op, &operand.kind) {
            let seen = operand.slot.map(|slot| self.seen(slot, site)).transpose()?;
            return self.integer(digits, true, *suffix, seen.as_ref().or(expected), site);
        }
        let operand = self.value(operand, expected)?;
        let (ty, span) = (operand.ty.clone(), self.span(site));
        match (op, &ty) {
            (tree::UnaryOp::Neg, Type::Matrix { .. }) => {
                self.routine_node(Routine::Neg, vec![operand], site)
            }
            (tree::UnaryOp::Neg, Type::Scalar(_)) => {
                Ok(Expr::unary(UnaryOp::Neg, operand).at(span))
            }
            (tree::UnaryOp::Not, Type::Scalar(_)) => {
                Ok(Expr::unary(UnaryOp::Not, operand).at(span))
            }
            (tree::UnaryOp::Not, _) if literal::is_wide(self.cx, &ty) => {
                literal::inverted(self, operand, site)
            }
            _ => problem(site, "no marked operator is defined for this type", OPERATOR),
        }
    }

    fn binary(
        &mut self,
        op: Op,
        left: &tree::Expr,
        right: &tree::Expr,
        expr: &tree::Expr,
    ) -> Result<Expr> {
        if let Plain::Logic(op) = plain(op) {
            let (left, span) = (self.value(left, Some(&Type::BOOL))?, self.span(expr.site));
            return self
                .short_circuit(op, left, span, |inner| inner.value(right, Some(&Type::BOOL)));
        }
        if let Some(callee) = self.operator(expr.slot).cloned() {
            return self.call_of(&callee, &[left.clone(), right.clone()], expr);
        }
        if let Some(equal) = self.slices_compared(op, (left, right), expr.site)? {
            return Ok(equal);
        }
        let of_instance = self.is_of_instance(left) || self.is_of_instance(right);
        let both = |of_left, of_right| {
            let left = Operand { expr: left, expected: of_left, role: "left" };
            [left, Operand { expr: right, expected: of_right, role: "right" }]
        };
        let [left, right] = match (plain(op), expr.slot) {
            (Plain::Arithmetic(_), Some(slot)) => {
                let result = self.slot(slot, expr.site)?;
                let (of_left, of_right) =
                    (Some(of_elements(&result)), self.compound_operand(op, &result));
                two(self.operands(&both(of_left, of_right))?, expr.site)?
            }
            _ => self.beside_literal(both(None, None), expr.site)?,
        };
        // The lengths that a function of the DSL's computes with are its caller's.
        let of_caller = self.source.tree.role == Role::Expanded && is_ours(self.source);
        match literal::folded(op, &left, &right).filter(|_| of_instance || of_caller) {
            Some(word) => self.node(ExprKind::Literal(word), left.ty, expr.site),
            None if of_instance && op == Op::Add && left.ty == Type::USIZE => Ok(plus(left, right)),
            None => self.binary_node(op, left, right, expr.site),
        }
    }

    /// Lowers two operands, of which an unsuffixed literal gets the other's type. The literal is lowered last, which
    /// nobody can observe.
    pub(super) fn beside_literal(
        &mut self,
        both: [Operand<'_>; 2],
        site: Site,
    ) -> Result<[Expr; 2]> {
        let [left, right] = &both;
        match (left.expr.is_unsuffixed(), right.expr.is_unsuffixed()) {
            (true, false) => {
                let value = self.read(right.expr, None)?;
                let ty = self.cx.literal_beside(&value.ty, left.expr)?;
                Ok([self.read(left.expr, Some(&ty))?, value])
            }
            (false, true) => {
                let value = self.read(left.expr, None)?;
                let ty = self.cx.literal_beside(&value.ty, right.expr)?;
                let literal = self.read(right.expr, Some(&ty))?;
                Ok([value, literal])
            }
            _ => two(self.operands(&both)?, site),
        }
    }

    /// The expected type of the right operand of an arithmetic operator.
    pub(super) fn compound_operand(&self, op: Op, result: &Type) -> Option<Type> {
        (!matches!(op, Op::Shl | Op::Shr)).then(|| of_elements(result))
    }

    pub(super) fn binary_node(
        &mut self,
        op: Op,
        left: Expr,
        right: Expr,
        site: Site,
    ) -> Result<Expr> {
        match (plain(op), &left.ty, &right.ty) {
            (Plain::Logic(_), ..) => problem(site, "this operator is not supported", OUR_FAULT),
            (Plain::Compare(op), ..) => self.compare_node(op, left, right, site),
            (Plain::Arithmetic(plain), Type::Scalar(_), Type::Scalar(_)) => {
                Ok(Expr::binary(plain, left, right).at(self.span(site)))
            }
            (_, Type::Matrix { .. }, _) | (.., Type::Matrix { .. }) => {
                self.matrix_binary(op, left, right, site)
            }
            _ => problem(site, "no marked operator is defined for these types", OPERATOR),
        }
    }

    pub(super) fn compare_node(
        &mut self,
        op: CompareOp,
        left: Expr,
        right: Expr,
        site: Site,
    ) -> Result<Expr> {
        let ty = left.ty.clone();
        if ty == Type::Unit {
            return refused(site, refusals::NOTHING_COMPARED);
        }
        if ty != right.ty {
            if let Some(own) = own_comparison(self, op, (&left, &right), site)? {
                return Ok(own);
            }
            // rustc compares numbers of one type only.
            let numbers = ty.is_word() && right.ty.is_word();
            let remedy = if numbers { OUR_FAULT } else { "convert one of them" };
            return problem(site, "`==` and `<` require two values of one type", remedy);
        }
        let equality = matches!(op, CompareOp::Eq | CompareOp::Ne);
        let known = self.cx.known(&ty);
        if !equality && known.own_equality.is_some() {
            return refused(site, refusals::ORDER_AND_EQUALITY);
        }
        // A word too, where its author says what `==` is.
        if equality && (!ty.is_word() || known.own_equality.is_some() || known.unequal) {
            let equal = self.equality(left, right, site)?;
            return Ok(if op == CompareOp::Ne { equal.negated() } else { equal });
        }
        if !ty.is_word() {
            return self.lexical(op, left, right, site);
        }
        let (left, right) = match ty {
            Type::Enum(id) if !equality => {
                (self.rank(id, left, site)?, self.rank(id, right, site)?)
            }
            _ => (left, right),
        };
        Ok(Expr::compare(op, left, right).at(self.span(site)))
    }

    fn matrix_binary(&mut self, op: Op, left: Expr, right: Expr, site: Site) -> Result<Expr> {
        let (routine, arguments) = match (op, &left.ty, &right.ty) {
            (Op::Add, Type::Matrix { .. }, _) => (Routine::Add, vec![left, right]),
            (Op::Sub, Type::Matrix { .. }, _) => (Routine::Sub, vec![left, right]),
            (Op::Mul, Type::Matrix { .. }, Type::Matrix { .. }) => {
                (Routine::Product, vec![left, right])
            }
            (Op::Mul, Type::Matrix { .. }, _) => (Routine::Scale, vec![left, right]),
            // `operands` holds the number before the matrix is read.
            (Op::Mul, _, Type::Matrix { .. }) => (Routine::Scale, vec![right, left]),
            (Op::Div, Type::Matrix { .. }, Type::Scalar(_)) => {
                (Routine::Unscale, vec![left, right])
            }
            _ => return refused(site, refusals::OPERAND_TYPES),
        };
        self.routine_node(routine, arguments, site)
    }

    fn array(&mut self, elements: &[tree::Expr], expr: &tree::Expr) -> Result<Expr> {
        let ty = self.slot_of(expr)?;
        let element = elements_of(&ty).needed(expr.site, "this is not an array")?.clone();
        if let Some(moved) = elements.iter().find(|it| self.is_submatrix(it)) {
            return refused(moved.site, refusals::MOVED_VIEW);
        }
        let elements = self.alike(elements, Some(element), &[])?;
        self.node(ExprKind::Array(elements), ty, expr.site)
    }

    fn cast(&mut self, operand: &tree::Expr, expr: &tree::Expr) -> Result<Expr> {
        let ty = self.slot_of(expr)?;
        // rustc gives a literal the type that it is cast to, if that is of its kind.
        let of_kind = match ty.as_float() {
            Some(_) => literal::is_unsuffixed_float(operand),
            None => {
                ty.as_int().is_some() || literal::is_wide(self.cx, &ty) && operand.is_unsuffixed()
            }
        };
        let expected = of_kind.then(|| ty.clone());
        if let Some(callee) = conversion(self, operand, &ty)? {
            return self.call_of(&callee, std::slice::from_ref(operand), expr);
        }
        let operand = self.value(operand, expected.as_ref())?;
        if operand.ty == ty && literal::is_wide(self.cx, &ty) {
            return Ok(operand);
        }
        if !operand.ty.is_word() || !matches!(ty, Type::Scalar(_)) {
            return refused(expr.site, refusals::CAST);
        }
        if let Some(literal) = literal::converted(&operand, &ty) {
            return Ok(literal);
        }
        self.node(ExprKind::Cast(Box::new(operand)), ty, expr.site)
    }

    /// Lowers `matches!(…)` to its condition.
    fn question(&mut self, scrutinee: &tree::Expr, arm: &tree::Arm, site: Site) -> Result<Expr> {
        let subject = self.subject(scrutinee)?;
        self.naming_scope(|inner| {
            let mut test = inner.test(&arm.pattern, &subject, site)?;
            inner.guard(&mut test, arm.guard.as_ref(), Some(site))?;
            Ok(test.condition.unwrap_or_else(|| Expr::bool(true, inner.span(site))))
        })
    }

    /// Lowers control flow inside an expression to a local that it assigns.
    fn control_value(&mut self, expr: &tree::Expr, expected: Option<&Type>) -> Result<Expr> {
        let ty = match (expr.slot, expected) {
            (None, Some(ty)) => ty.clone(),
            _ => self.slot_of(expr)?,
        };
        let span = self.span(expr.site);
        let name = self.role_name("choice");
        let place = self.decided_by(name, ty, Some(expr), span)?;
        self.locals.note_unnamed(place.root);
        Ok(place.load())
    }

    /// Lowers operands left to right. Each but the last is held before the next.
    pub(super) fn operands(&mut self, operands: &[Operand<'_>]) -> Result<Vec<Expr>> {
        let mut values: Vec<Expr> = Vec::new();
        for (index, operand) in operands.iter().enumerate() {
            let value = self.read(operand.expr, operand.expected.as_ref())?;
            values.push(match index + 1 < operands.len() {
                true => self.operand_held(operand.role, value),
                false => value,
            });
        }
        Ok(values)
    }

    /// Holds an operand. A computed aggregate is named by its type, the result of a call by the function.
    pub(super) fn operand_held(&mut self, role: &str, value: Expr) -> Expr {
        let computed =
            !matches!(value.kind, ExprKind::Load(_) | ExprKind::Struct(_) | ExprKind::Array(_));
        let value = match self.atomic(role, value) {
            Err(value) if computed && !value.ty.is_word() => return self.hold(value).load(),
            Err(value) => value,
            Ok(value) => return value,
        };
        let place = match &value.kind {
            ExprKind::Call(callee, _) => {
                let function = self.cx.module.functions[callee.index()].name.clone();
                self.atom_place(&function, value)
            }
            _ => self.atom_place(role, value),
        };
        self.locals.note_unnamed(place.root);
        place.load()
    }

    /// Lowers operands left to right and holds each in a local with the name of its role.
    pub(super) fn parts_held(&mut self, operands: &[Operand<'_>]) -> Result<Vec<Expr>> {
        let held = operands.iter().map(|operand| {
            let value = self.read(operand.expr, operand.expected.as_ref())?;
            Ok(self.naming_as("", |inner| inner.atom(operand.role, value)))
        });
        held.collect()
    }

    /// Lowers operands of one expected type. An operand without a role is named as an element.
    pub(super) fn alike(
        &mut self,
        operands: &[tree::Expr],
        expected: Option<Type>,
        roles: &[&'static str],
    ) -> Result<Vec<Expr>> {
        let roles = roles.iter().copied().chain(std::iter::repeat(words::ELEMENT));
        let operands = operands.iter().zip(roles);
        let operands: Vec<_> = operands
            .map(|(expr, role)| Operand { expr, expected: expected.clone(), role })
            .collect();
        self.operands(&operands)
    }

    fn call(&mut self, callee: u32, arguments: &[tree::Expr], expr: &tree::Expr) -> Result<Expr> {
        let callee = self.callee(callee).cloned();
        let callee = callee.needed(expr.site, "the tree names a callee that is not there")?;
        self.call_of(&callee, arguments, expr)
    }

    /// Lowers a call of the callee that rustc resolved.
    pub(super) fn call_of(
        &mut self,
        callee: &tree::Callee,
        arguments: &[tree::Expr],
        expr: &tree::Expr,
    ) -> Result<Expr> {
        match callee {
            tree::Callee::Builtin(builtin) => self.builtin(*builtin, Call { arguments, expr }),
            tree::Callee::Function(path) => {
                let function = self.cx.calls.all.get(path.as_str()).copied();
                // An operator of the library may be expanded, too.
                if let Some(expanded) = function.filter(|it| it.tree.role == Role::Expanded) {
                    return self.expanded_value((expanded, arguments), None, expr.site);
                }
                if let Some(template) = function.filter(|it| takes_closures(it)) {
                    return self.call_handing(template, arguments, expr);
                }
                if let Some(function) = function
                    && let Some(place) = self.lent_by((function, arguments), expr)?
                {
                    return Ok(place.load());
                }
                if let Some(value) = self.shorter(path, Call { arguments, expr })? {
                    return Ok(value);
                }
                if let [factors, b] = arguments
                    && self.cx.by_columns
                    && let Some(a) = matrix_of_factors(function, self.called(bare(factors)))
                {
                    let types = [self.type_of_value(a)?, self.type_of_value(b)?];
                    let kernel = kernel_of(KernelRoutine::Solve, &types);
                    let kernel = kernel.needed(expr.site, "this takes matrices of floats")?;
                    let option = self.slot_of(expr)?;
                    let none = self.zero(&option, Span::default());
                    let kernel = self.cx.kernel(&kernel);
                    let id = self.cx.solving(kernel, none);
                    return self.call_function(id, &[a.clone(), b.clone()], expr);
                }
                if let Some(answer) = self.order_asked(path, arguments, expr.site)? {
                    return Ok(answer);
                }
                if let Some(called) = self.assigns_part(expr) {
                    return self.expanded_value(called, None, expr.site);
                }
                let id = self.function_at(path, expr.site)?;
                self.call_function(id, arguments, expr)
            }
        }
    }
}

/// Returns the element type of an array.
fn elements_of(ty: &Type) -> Option<&Type> {
    match ty {
        Type::Array { element, .. } => Some(element),
        _ => None,
    }
}

pub(super) fn two<T>(values: Vec<T>, site: Site) -> Result<[T; 2]> {
    <[T; 2]>::try_from(values).ok().needed(site, "this takes two operands")
}

/// Returns the element type of a matrix, or any other type itself.
fn of_elements(ty: &Type) -> Type {
    match ty {
        Type::Matrix { element, .. } => Type::Scalar(*element),
        other => other.clone(),
    }
}

/// IR operation that an author's operator means.
enum Plain {
    Logic(LogicOp),
    Compare(CompareOp),
    Arithmetic(BinaryOp),
}

fn plain(op: Op) -> Plain {
    use Plain::{Arithmetic, Compare, Logic};
    match op {
        Op::Add => Arithmetic(BinaryOp::Add),
        Op::Sub => Arithmetic(BinaryOp::Sub),
        Op::Mul => Arithmetic(BinaryOp::Mul),
        Op::Div => Arithmetic(BinaryOp::Div),
        Op::Rem => Arithmetic(BinaryOp::Rem),
        Op::And => Arithmetic(BinaryOp::And),
        Op::Or => Arithmetic(BinaryOp::Or),
        Op::Xor => Arithmetic(BinaryOp::Xor),
        Op::Shl => Arithmetic(BinaryOp::Shl),
        Op::Shr => Arithmetic(BinaryOp::Shr),
        Op::Eq => Compare(CompareOp::Eq),
        Op::Ne => Compare(CompareOp::Ne),
        Op::Lt => Compare(CompareOp::Lt),
        Op::Le => Compare(CompareOp::Le),
        Op::Gt => Compare(CompareOp::Gt),
        Op::Ge => Compare(CompareOp::Ge),
        Op::LogicAnd => Logic(LogicOp::And),
        Op::LogicOr => Logic(LogicOp::Or),
    }
}
