//! Holds every operand in a temporary of its own, in the order of evaluation, and checks every index there, as the plainest
//! lowering would.

use std::collections::HashSet;

use bessemer_ir::effects;
use bessemer_ir::visit::{VisitMut, walk_block_mut, walk_expr_mut};
use bessemer_ir::{
    Argument, Block, CompareOp, Expr, ExprKind, Fault, Function, Local, LocalId, Mode, Module,
    Place, Step, Stmt, StmtKind, Type,
};

/// The function with its operands held, and the temporaries; those of a statement that `keep` takes stay.
pub fn held(
    module: &Module,
    function: &Function,
    keep: &mut dyn FnMut() -> bool,
) -> (Function, HashSet<LocalId>) {
    let mut hold = Hold { module, locals: function.locals.clone(), out: Vec::new(), keep };
    let body = hold.block(&function.body);
    let made = (function.locals.len()..hold.locals.len()).map(|at| LocalId(at as u32)).collect();
    (Function { body, locals: hold.locals, ..function.clone() }, made)
}

struct Hold<'k> {
    module: &'k Module,
    locals: Vec<Local>,
    out: Vec<Stmt>,
    keep: &'k mut dyn FnMut() -> bool,
}

impl Hold<'_> {
    fn block(&mut self, block: &Block) -> Block {
        let outer = std::mem::take(&mut self.out);
        block.0.iter().for_each(|stmt| self.stmt(stmt));
        Block(std::mem::replace(&mut self.out, outer))
    }

    fn stmt(&mut self, stmt: &Stmt) {
        if (self.keep)() {
            self.out.push(stmt.clone());
            return;
        }
        let kind = match &stmt.kind {
            StmtKind::Let { local, value } => {
                StmtKind::Let { local: *local, value: value.as_ref().map(|it| self.value(it)) }
            }
            StmtKind::Assign { place, value } => {
                let value = self.value(value);
                StmtKind::Assign { place: self.place(place).0, value }
            }
            StmtKind::Expr(value) => StmtKind::Expr(self.value(value)),
            StmtKind::If { condition, then, otherwise } => StmtKind::If {
                condition: self.value(condition),
                then: self.block(then),
                otherwise: self.block(otherwise),
            },
            StmtKind::Match { scrutinee, arms, otherwise } => {
                let scrutinee = self.value(scrutinee);
                let mut arms = arms.clone();
                arms.iter_mut().for_each(|arm| arm.body = self.block(&arm.body));
                let otherwise = otherwise.as_ref().map(|block| self.block(block));
                StmtKind::Match { scrutinee, arms, otherwise }
            }
            StmtKind::For { variable, from, to, inclusive, reversed, unroll, ended, body } => {
                StmtKind::For {
                    variable: *variable,
                    // What a loop counts to is computed before it, if it is computed.
                    from: from.clone(),
                    to: to.clone(),
                    inclusive: *inclusive,
                    reversed: *reversed,
                    unroll: *unroll,
                    ended: *ended,
                    body: self.block(body),
                }
            }
            StmtKind::Check { condition, fault } => {
                // A checked condition has no effect.
                StmtKind::Check { condition: condition.clone(), fault: *fault }
            }
            StmtKind::Return(value) => {
                StmtKind::Return(value.as_ref().map(|value| self.value(value)))
            }
            StmtKind::Break => StmtKind::Break,
            StmtKind::Continue => StmtKind::Continue,
        };
        self.out.push(Stmt { kind, ..stmt.clone() });
    }

    fn value(&mut self, expr: &Expr) -> Expr {
        let kind = match &expr.kind {
            ExprKind::Literal(_) | ExprKind::Const(_) => return expr.clone(),
            ExprKind::Load(place) => ExprKind::Load(self.place(place).0),
            ExprKind::Unary(op, x) => ExprKind::Unary(*op, self.boxed(x)),
            ExprKind::Cast(x) => ExprKind::Cast(self.boxed(x)),
            ExprKind::Splat(x) => ExprKind::Splat(self.boxed(x)),
            ExprKind::Binary(op, a, b) => ExprKind::Binary(*op, self.boxed(a), self.boxed(b)),
            ExprKind::Compare(op, a, b) => ExprKind::Compare(*op, self.boxed(a), self.boxed(b)),
            // The right side is computed on a condition.
            ExprKind::Logic(op, a, b) => ExprKind::Logic(*op, self.boxed(a), b.clone()),
            ExprKind::Intrinsic(which, all) => ExprKind::Intrinsic(*which, self.all(all)),
            ExprKind::Struct(all) => ExprKind::Struct(self.all(all)),
            ExprKind::Array(all) => ExprKind::Array(self.all(all)),
            ExprKind::Matrix(all) => ExprKind::Matrix(self.all(all)),
            ExprKind::Routine(which, all) => ExprKind::Routine(*which, self.all(all)),
            ExprKind::Call(callee, arguments) => {
                let mut stays = false;
                let arguments = arguments.iter().map(|argument| match argument {
                    _ if stays => argument.clone(),
                    Argument::Value(value) => Argument::Value(self.value(value)),
                    Argument::Ref(Expr { kind: ExprKind::Load(place), .. }) => {
                        let (place, checked) = self.place(place);
                        stays = !checked;
                        Argument::Ref(place.load())
                    }
                    Argument::Ref(value) => Argument::Ref(self.value(value)),
                    Argument::RefMut(place) => {
                        let (place, checked) = self.place(place);
                        stays = !checked;
                        Argument::RefMut(place)
                    }
                });
                ExprKind::Call(*callee, arguments.collect())
            }
        };
        let value = Expr { kind, ..expr.clone() };
        self.temporary(value)
    }

    fn temporary(&mut self, value: Expr) -> Expr {
        let (ty, span) = (value.ty.clone(), value.span);
        let name = format!("held{}", self.locals.len());
        self.locals.push(Local { name, ty: ty.clone(), mode: Mode::Value, span });
        let local = LocalId(self.locals.len() as u32 - 1);
        self.out.push(Stmt::new(StmtKind::Let { local, value: Some(value) }, span));
        Expr::local(local, &ty, span)
    }

    fn boxed(&mut self, expr: &Expr) -> Box<Expr> {
        Box::new(self.value(expr))
    }

    fn all(&mut self, all: &[Expr]) -> Vec<Expr> {
        all.iter().map(|expr| self.value(expr)).collect()
    }

    /// Holds and checks the indices of a place. Those of a slice show whether they are beyond the end where the place is
    /// used, so what comes behind them is not held; returns false then.
    fn place(&mut self, place: &Place) -> (Place, bool) {
        let mut place = place.clone();
        let mut ty = self.locals[place.root.index()].ty.clone();
        let mut checked = true;
        for step in &mut place.steps {
            if !checked {
                break;
            }
            step.indices_mut().for_each(|index| *index = self.value(index));
            let lengths = match (&*step, &ty) {
                (Step::Field(_), _) => Vec::new(),
                (Step::Index(_), Type::Array { len, .. }) => vec![*len],
                (Step::Index(_), Type::Matrix { rows, cols, .. }) => vec![rows * cols],
                (Step::Element(..), Type::Matrix { rows, cols, .. }) => vec![*rows, *cols],
                _ => {
                    checked = false;
                    break;
                }
            };
            for (index, len) in step.indices().zip(lengths) {
                match index.kind {
                    ExprKind::Literal(word) if word < u64::from(len) => continue,
                    ExprKind::Literal(_) => {
                        checked = false;
                        continue;
                    }
                    _ => {}
                }
                let len = Expr::literal_like(u64::from(len), index);
                let condition = Expr::compare(CompareOp::Lt, index.clone(), len);
                let kind = StmtKind::Check { condition, fault: Fault::Index };
                self.out.push(Stmt::new(kind, index.span));
            }
            ty = self.module.step_type(&ty, step).expect("the type of a part");
        }
        (place, checked)
    }
}

/// Declares temporaries earlier than they are needed, and lets operations read theirs in the other order.
pub fn shuffle(function: &mut Function, made: &HashSet<LocalId>, chance: &mut dyn FnMut() -> bool) {
    Shuffle { made, chance }.block(&mut function.body);
}

struct Shuffle<'s> {
    made: &'s HashSet<LocalId>,
    chance: &'s mut dyn FnMut() -> bool,
}

impl VisitMut for Shuffle<'_> {
    fn block(&mut self, block: &mut Block) {
        walk_block_mut(self, block);
        for at in 1..block.0.len() {
            let mut at = at;
            while at > 0 && self.may_swap(&block.0[at - 1], &block.0[at]) && (self.chance)() {
                block.0.swap(at - 1, at);
                at -= 1;
            }
        }
    }

    fn expr(&mut self, expr: &mut Expr) {
        walk_expr_mut(self, expr);
        if let ExprKind::Binary(_, left, right) | ExprKind::Compare(_, left, right) = &mut expr.kind
            && left.ty == right.ty
            && (self.chance)()
        {
            std::mem::swap(left, right);
        }
    }
}

impl Shuffle<'_> {
    /// Returns whether the second statement, which has to declare a temporary, may stand before the first.
    fn may_swap(&self, first: &Stmt, second: &Stmt) -> bool {
        let StmtKind::Let { local, value: Some(value) } = &second.kind else { return false };
        let declares = match &first.kind {
            StmtKind::Let { local, .. } => Some(*local),
            _ => None,
        };
        self.made.contains(local) && declares.is_none_or(|it| !effects::mentions(value, it))
    }
}
