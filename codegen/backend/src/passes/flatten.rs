//! Makes expressions explicit: any IR expression becomes statements and a remaining expression.
//!
//! Precondition: a valid module. Postconditions for the remaining expression:
//!
//! * it is in a position that [`positions`](super::positions) allows. Calls that fault, write or return aggregates
//!   are separate statements, and so are aggregates inside an expression;
//! * it cannot fault after the statements before it have run, and has no effect (unless it is a call as a whole
//!   value);
//! * the statements before it have the effects and the faults of the original, in its order.
//!
//! Operands are processed left to right. Each remaining operand is pure and cannot fault, so it may be evaluated
//! later, unless a call in a later operand writes what it reads; then a local holds it. Expressions that are explicit
//! already are unchanged.

use std::borrow::Cow;

use bessemer_ir::{
    Argument, Expr, ExprKind, Fault, FunctionId, Intrinsic, Local, LocalId, LogicOp, Mode, Place,
    Span, Step, Stmt, StmtKind, Type,
};

use super::analysis::State;
use super::checked;
use super::faults::{self, Obligation};
use super::lowering::Lowering;
use super::names::{self, Purpose};
use super::places::weight;
use super::positions::{self, Position, accepts};
use bessemer_ir::effects::{lent, lent_by_step, moves, reads, whole, writes};

/// Largest weight of an expression that may be written twice: in a check, and again in the statement.
const LIGHT: usize = 4;

impl<'m> Lowering<'m> {
    /// Makes `expr` explicit, for the position `position`.
    pub(super) fn lower(&mut self, expr: Expr, position: Position, purpose: Purpose) -> Expr {
        let expr = self.node(expr);
        if accepts(self.callees, position, &expr) { expr } else { self.keep(expr, purpose) }
    }

    /// Makes a word inside an expression explicit.
    pub(super) fn word(&mut self, expr: Expr) -> Expr {
        let expr = self.lower(expr, Position::Nested, Purpose::Operand);
        self.brought(expr)
    }

    /// Normalises an enum that may come from outside: it becomes one of its variants, or that is a fault.
    fn brought(&mut self, expr: Expr) -> Expr {
        let comes = matches!(expr.kind, ExprKind::Load(_) | ExprKind::Call(..));
        if !(self.brings && comes && self.facts.may_stray(&expr)) {
            return expr;
        }
        // It is read twice.
        let expr = if comes_light(&expr) { expr } else { self.keep(expr, Purpose::Operand) };
        let (ty, span) = (expr.ty.clone(), expr.span);
        Expr { kind: ExprKind::Intrinsic(Intrinsic::Variant, vec![expr]), ty, span }
    }

    fn node(&mut self, expr: Expr) -> Expr {
        let Expr { kind, ty, span } = expr;
        let kind = match kind {
            ExprKind::Literal(_) | ExprKind::Const(_) => kind,
            ExprKind::Load(place) => ExprKind::Load(self.place(place)),
            ExprKind::Unary(op, x) => ExprKind::Unary(op, Box::new(self.word(*x))),
            ExprKind::Cast(x) => ExprKind::Cast(Box::new(self.word(*x))),
            ExprKind::Binary(op, a, b) => {
                let (a, b) = self.pair(*a, *b);
                ExprKind::Binary(op, Box::new(a), Box::new(b))
            }
            ExprKind::Compare(op, a, b) => {
                let (a, b) = self.pair(*a, *b);
                ExprKind::Compare(op, Box::new(a), Box::new(b))
            }
            ExprKind::Logic(op, a, b) => return self.logic(op, *a, *b, span),
            ExprKind::Call(callee, arguments) => self.call(callee, arguments),
            ExprKind::Splat(x) => {
                let x = self.lower(*x, Position::Repeated, Purpose::Part("element"));
                ExprKind::Splat(Box::new(x))
            }
            kind => self.list(kind, &ty),
        };
        self.secure(Expr { kind, ty, span })
    }

    /// Makes two words explicit, left to right.
    pub(super) fn pair(&mut self, a: Expr, b: Expr) -> (Expr, Expr) {
        let mut a = self.word(a);
        self.protect(&mut a, &lent(&b));
        (a, self.word(b))
    }

    /// Makes the operands of a constructor, an intrinsic or a routine explicit.
    fn list(&mut self, kind: ExprKind, ty: &Type) -> ExprKind {
        let module = self.module;
        let part = |index: usize| match ty {
            Type::Struct(id) => {
                Some(module.structs.get(id.index())?.fields.get(index)?.name.as_str())
            }
            _ => None,
        };
        let parts: Vec<Option<&str>> = match &kind {
            ExprKind::Struct(operands) => (0..operands.len()).map(part).collect(),
            _ => Vec::new(),
        };
        let mut lower_all = |operands: &[Expr]| {
            let mut done: Vec<Expr> = Vec::new();
            for (index, operand) in operands.iter().enumerate() {
                let written = lent(operand);
                done.iter_mut().for_each(|done| self.protect(done, &written));
                let part = parts.get(index).copied().flatten();
                let purpose = part.map_or(Purpose::Operand, Purpose::Part);
                let position = positions::operand(&kind, operand);
                done.push(self.lower(operand.clone(), position, purpose));
            }
            done
        };
        match &kind {
            ExprKind::Intrinsic(which, operands) => {
                ExprKind::Intrinsic(*which, lower_all(operands))
            }
            ExprKind::Routine(which, operands) => ExprKind::Routine(*which, lower_all(operands)),
            ExprKind::Struct(operands) => ExprKind::Struct(lower_all(operands)),
            ExprKind::Array(operands) => ExprKind::Array(lower_all(operands)),
            ExprKind::Matrix(operands) => ExprKind::Matrix(lower_all(operands)),
            _ => kind,
        }
    }

    fn call(&mut self, callee: FunctionId, arguments: Vec<Argument>) -> ExprKind {
        let module = self.module;
        let parameters = module.functions.get(callee.index()).map_or(&[][..], |f| f.parameters());
        // The kernel's names for its operands say nothing of what they mean here.
        let of_kernel = module.functions.get(callee.index()).is_some_and(|f| f.kernel.is_some());
        let mut done: Vec<Argument> = Vec::new();
        for (index, argument) in arguments.into_iter().enumerate() {
            let written = match &argument {
                Argument::Value(value) | Argument::Ref(value) => lent(value),
                Argument::RefMut(place) => lent(place),
            };
            done.iter_mut().for_each(|done| self.protect_argument(done, &written));
            let purpose = match parameters.get(index) {
                Some(parameter) if !of_kernel => Purpose::Part(&parameter.name),
                _ => Purpose::Operand,
            };
            let position = positions::argument(&argument).map(|(_, position)| position);
            done.push(match (argument, position) {
                (Argument::Value(value), Some(at)) => {
                    Argument::Value(self.lower(value, at, purpose))
                }
                (Argument::Ref(value), Some(at)) => Argument::Ref(self.lower(value, at, purpose)),
                (Argument::RefMut(place), _) => Argument::RefMut(self.place(place)),
                (argument, None) => argument,
            });
        }
        self.part_from_lent(&mut done);
        ExprKind::Call(callee, done)
    }

    /// Copies aggregate arguments that the same call may write through another argument.
    fn part_from_lent(&mut self, arguments: &mut [Argument]) {
        let lent: Vec<Place> = arguments
            .iter()
            .filter_map(|argument| match argument {
                Argument::RefMut(place) => Some(place.clone()),
                _ => None,
            })
            .collect();
        for argument in arguments {
            if let Argument::Value(value) = argument
                && value.ty.is_aggregate()
                && reads(value, &lent)
            {
                let name = self.name_of(value, "copy");
                *value = self.keep(value.clone(), Purpose::Named(&name));
            }
        }
    }

    /// Makes `&&` or `||` explicit: an `if`, if the right side needs statements.
    fn logic(&mut self, op: LogicOp, a: Expr, b: Expr, span: Span) -> Expr {
        self.chain(op, a, b, span).0
    }

    /// Flattens a chain of one logical operator, and returns the state in which its next operand is evaluated. Each
    /// operand of a long chain is assumed once.
    fn chain(&mut self, op: LogicOp, a: Expr, b: Expr, span: Span) -> (Expr, State<'m>) {
        let (a, behind) = self.before_next(op, a);
        let (before, asked) = (std::mem::replace(&mut self.facts, behind.clone()), b.clone());
        let outer = std::mem::take(&mut self.out);
        let b = self.word(b);
        let mut then = std::mem::replace(&mut self.out, outer);
        let within = std::mem::replace(&mut self.facts, before);
        let logic = |a: Expr, b: Expr| {
            let kind = ExprKind::Logic(op, Box::new(a), Box::new(b));
            Expr { kind, ty: Type::BOOL, span }
        };
        if then.is_empty() {
            let mut behind = behind;
            behind.assume(&b, op == LogicOp::And);
            return (logic(a, b), behind);
        }
        let a = self.undecided(a);
        let start = ExprKind::Literal(u64::from(op == LogicOp::Or));
        let start = Expr { kind: start, ty: Type::BOOL, span };
        let name = logic(start.clone(), asked);
        let name = self.wish(Purpose::Operand, &name);
        let Some(local) = self.declare(&name, start) else {
            return self.with_what_follows(op, logic(a, b));
        };
        let place = Place { ty: Type::BOOL, span, ..whole(local) };
        let mut within = within;
        within.assign(&place, within.parts(&b));
        self.facts.join(&within);
        then.push(Stmt { kind: StmtKind::Assign { place, value: b }, span, comments: Vec::new() });
        self.emit(when(op, a, then), span);
        self.with_what_follows(op, Expr::local(local, &Type::BOOL, span))
    }

    /// Makes an operand of a chain explicit, and returns the facts at the evaluation of the next operand.
    fn before_next(&mut self, op: LogicOp, operand: Expr) -> (Expr, State<'m>) {
        match operand.kind {
            ExprKind::Logic(of, a, b) if of == op => {
                let (value, behind) = self.chain(op, *a, *b, operand.span);
                if matches!(value.kind, ExprKind::Logic(..)) {
                    return (value, behind);
                }
                let value = self.brought(value);
                self.with_what_follows(op, value)
            }
            _ => {
                let value = self.word(operand);
                self.with_what_follows(op, value)
            }
        }
    }

    /// Returns a value, and the facts where it is true (for `&&`) or false.
    fn with_what_follows(&self, op: LogicOp, value: Expr) -> (Expr, State<'m>) {
        let mut behind = self.facts.clone();
        behind.assume(&value, op == LogicOp::And);
        (value, behind)
    }

    /// Makes the indices of a place explicit.
    pub(super) fn place(&mut self, place: Place) -> Place {
        self.place_beside(place, &[])
    }

    /// Flattens a place; indices that read one of the places `changed` are first computed into locals.
    pub(super) fn place_beside(&mut self, place: Place, changed: &[Place]) -> Place {
        let Place { root, steps, ty, span } = place;
        let mut container = Some(self.function.local(root).ty.clone());
        let mut done = Place { root, steps: Vec::new(), ty: ty.clone(), span };
        for step in steps {
            self.protect_place(&mut done, &lent_by_step(&step));
            let mut step = match step {
                Step::Field(field) => Step::Field(field),
                Step::Index(index) => Step::Index(self.word(index)),
                Step::From(index) => Step::From(self.word(index)),
                Step::Element(row, column) => {
                    let (row, column) = self.pair(row, column);
                    Step::Element(row, column)
                }
            };
            self.protect_step(&mut step, changed);
            if let Some(container) = &container {
                self.secure_step(container, &mut step, &done);
            }
            container = container.and_then(|container| self.module.step_type(&container, &step));
            done.steps.push(step);
        }
        done
    }

    fn secure_step(&mut self, container: &Type, step: &mut Step, of: &Place) {
        let (root, span) = (of.root, of.span);
        let obliged = |lowering: &Self, step: &Step| {
            faults::of_step(root, container, step, &lowering.facts_at(span))
        };
        let kept = |blank: &State| faults::of_step(root, container, step, blank);
        if obliged(self, step).is_empty() && !self.keeps_any(kept) {
            return;
        }
        let of = names::place(self.module, &self.function, of);
        match step {
            Step::Field(_) => {}
            Step::Index(index) | Step::From(index) => {
                self.lighten(index, Purpose::Named(&format!("{of}_index")))
            }
            Step::Element(row, column) => {
                self.lighten(row, Purpose::Named(&format!("{of}_row")));
                self.lighten(column, Purpose::Named(&format!("{of}_column")));
            }
        }
        let doubted = self.doubts(span);
        let checked = obliged(self, step).into_iter().map(|it| self.check(it, doubted)).collect();
        self.keep_proved(|blank| faults::of_step(root, container, step, blank), checked);
    }

    /// Returns true if the proof of an operation at this span is doubted.
    pub(super) fn doubts(&self, span: Span) -> bool {
        self.doubted.contains(&span)
    }

    /// Returns the facts before an operation; none if its proof is doubted.
    fn facts_at(&self, span: Span) -> Cow<'_, State<'m>> {
        match self.doubts(span) {
            true => Cow::Owned(State::blind(self.module)),
            false => Cow::Borrowed(&self.facts),
        }
    }

    /// Returns true if checks of an operation are kept although they were proved.
    fn keeps_any(&self, of: impl Fn(&State) -> Vec<Obligation>) -> bool {
        self.keeps && !of(&State::new(self.module)).is_empty()
    }

    /// Emits the proved checks of an operation, except those in `checked`.
    fn keep_proved(&mut self, of: impl Fn(&State) -> Vec<Obligation>, checked: Vec<Expr>) {
        if !self.keeps {
            return;
        }
        for Obligation { condition, span, .. } in of(&State::new(self.module)) {
            if !checked.contains(&condition) {
                self.emit(StmtKind::Check { condition, fault: Fault::LeftOut }, span);
            }
        }
    }

    /// Emits the checks that the operation at the root of `expr` needs.
    fn secure(&mut self, mut expr: Expr) -> Expr {
        let obliged =
            |lowering: &Self, expr: &Expr| faults::of_expr(expr, &lowering.facts_at(expr.span));
        let kept = |blank: &State| faults::of_expr(&expr, blank);
        let needs = !obliged(self, &expr).is_empty() || self.keeps_any(kept);
        if self.asked == Some(expr.span) || !needs {
            return expr;
        }
        match &mut expr.kind {
            ExprKind::Unary(_, x) => self.lighten(x, Purpose::Operand),
            ExprKind::Binary(op, a, b) => {
                let signs = faults::signs_matter(*op, &expr.ty);
                for (operand, sign) in [(a, signs.0), (b, signs.1)] {
                    if sign && !bare(operand) {
                        **operand = self.keep((**operand).clone(), Purpose::Operand);
                    }
                    self.lighten(operand, Purpose::Operand);
                }
            }
            ExprKind::Intrinsic(_, operands) => {
                operands.iter_mut().for_each(|operand| self.lighten(operand, Purpose::Operand));
            }
            _ => {}
        }
        let doubted = self.doubts(expr.span);
        let checked = obliged(self, &expr).into_iter().map(|it| self.check(it, doubted)).collect();
        self.keep_proved(|blank| faults::of_expr(&expr, blank), checked);
        expr
    }

    /// Holds a value that will be written more than once in a local, unless it is short.
    fn lighten(&mut self, expr: &mut Expr, purpose: Purpose) {
        if weight(expr) > LIGHT {
            *expr = self.keep(expr.clone(), purpose);
        }
    }

    /// Emits the check of a condition, and returns the condition; with `doubted`, even if it is proved.
    fn check(&mut self, obligation: Obligation, doubted: bool) -> Expr {
        let Obligation { condition, fault, span, reason } = obligation;
        // Another half of the same operation may have just been checked; or all of it, in explicit code.
        let proved = self.facts.proves(&condition) && !doubted;
        let changes = |stmt: &Stmt, condition: &Expr| reads(condition, &writes([stmt]));
        let stands =
            checked::before(&self.out, &condition, changes) && !reads(&condition, &self.pending);
        if !proved && !stands {
            self.facts.assume(&condition, true);
            self.remain(fault, span, reason);
            self.emit(StmtKind::Check { condition: condition.clone(), fault }, span);
        }
        condition
    }

    /// Holds a value in a new local.
    pub(super) fn keep(&mut self, expr: Expr, purpose: Purpose) -> Expr {
        let (ty, span) = (expr.ty.clone(), expr.span);
        let name = self.wish(purpose, &expr);
        match self.declare(&name, expr.clone()) {
            Some(local) => Expr::local(local, &ty, span),
            None => expr,
        }
    }

    /// Declares a local with a value; none if handles run out, which does not happen.
    fn declare(&mut self, name: &str, value: Expr) -> Option<LocalId> {
        let span = value.span;
        let local = self.new_local(name, &value)?;
        let known = self.facts.parts(&value);
        self.facts.forget(&lent(&value));
        self.facts.assign(&whole(local), known);
        self.emit(StmtKind::Let { local, value: Some(value) }, span);
        Some(local)
    }

    fn new_local(&mut self, name: &str, value: &Expr) -> Option<LocalId> {
        let local = LocalId(u32::try_from(self.function.locals.len()).ok()?);
        let (name, ty, span) = (name.to_owned(), value.ty.clone(), value.span);
        self.function.locals.push(Local { name, ty, mode: Mode::Value, span });
        Some(local)
    }

    pub(super) fn emit(&mut self, kind: StmtKind, span: Span) {
        self.out.push(Stmt { kind, span, comments: Vec::new() });
    }

    /// Holds `value` in a local if it reads a place that is about to be written.
    pub(super) fn protect(&mut self, value: &mut Expr, written: &[Place]) {
        if written.is_empty() || !reads(value, written) {
            return;
        }
        let before = self.name_of(value, "before");
        let purpose = match value.kind {
            ExprKind::Load(_) => Purpose::Named(&before),
            _ => Purpose::Operand,
        };
        *value = self.keep(value.clone(), purpose);
    }

    fn protect_argument(&mut self, argument: &mut Argument, written: &[Place]) {
        match argument {
            Argument::Value(value) => self.protect(value, written),
            Argument::Ref(value) => {
                if let ExprKind::Load(place) = &mut value.kind {
                    self.protect_place(place, written);
                }
            }
            Argument::RefMut(place) => self.protect_place(place, written),
        }
    }

    fn protect_place(&mut self, place: &mut Place, written: &[Place]) {
        if !moves(place, written) {
            return;
        }
        for step in &mut place.steps {
            self.protect_step(step, written);
        }
    }

    fn protect_step(&mut self, step: &mut Step, written: &[Place]) {
        match step {
            Step::Field(_) => {}
            Step::Index(index) | Step::From(index) => self.protect(index, written),
            Step::Element(row, column) => {
                self.protect(row, written);
                self.protect(column, written);
            }
        }
    }

    /// Holds the call `value` in a local before the statement `at`, so that later code follows its effects.
    pub(super) fn keep_at(&mut self, at: usize, value: &mut Expr, name: &str) {
        let Some(local) = self.new_local(name, value) else { return };
        let kept = Expr::local(local, &value.ty, value.span);
        let value = std::mem::replace(value, kept);
        let span = value.span;
        let kind = StmtKind::Let { local, value: Some(value) };
        self.out.insert(at, Stmt { kind, span, comments: Vec::new() });
    }

    /// Returns the preferred name of a value that is held for the present statement.
    pub(super) fn wish(&self, purpose: Purpose, expr: &Expr) -> String {
        names::wish(self.module, &self.function, &self.base, purpose, expr)
    }

    fn name_of(&self, value: &Expr, role: &str) -> String {
        match &value.kind {
            ExprKind::Load(place) => {
                format!("{}_{role}", names::place(self.module, &self.function, place))
            }
            _ => role.to_string(),
        }
    }
}

/// Returns true if a value may be written twice: a short place without calls.
fn comes_light(expr: &Expr) -> bool {
    matches!(expr.kind, ExprKind::Load(_)) && weight(expr) <= LIGHT
}

/// Returns true if a value is a literal, a constant, a local or a field.
fn bare(expr: &Expr) -> bool {
    match &expr.kind {
        ExprKind::Literal(_) | ExprKind::Const(_) => true,
        ExprKind::Load(place) => place.steps.iter().all(|step| matches!(step, Step::Field(_))),
        _ => false,
    }
}

/// Returns the `if` that runs the right side of a short circuit.
pub(super) fn when(op: LogicOp, condition: Expr, then: Vec<Stmt>) -> StmtKind {
    let condition = match op {
        LogicOp::And => condition,
        LogicOp::Or => condition.negated(),
    };
    let then = bessemer_ir::Block(then);
    StmtKind::If { condition, then, otherwise: bessemer_ir::Block::default() }
}
