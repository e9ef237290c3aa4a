//! Decides which temporaries are substituted and which checks go: the one place that reasons about evaluation order.
//!
//! Invariant: one walk from the last statement to the first decides, knowing the next access to each local.
//!
//! Must not know: why lowering made a local; how a value is substituted.

use std::collections::HashMap;

use bessemer_ir::visit::{Access, Visit, Walk};
use bessemer_ir::{
    Argument, BinaryOp, Block, Expr, ExprKind, Intrinsic, Local, LocalId, Mode, Module, Place,
    Scalar, Step, Stmt, StmtKind, Type, UnaryOp,
};

use super::checks::{self, Index};
use super::known::Known;

/// Locals to be substituted and checks to be removed.
pub(super) struct Decided {
    /// True for each local that its value replaces.
    pub gone: Vec<bool>,
    /// True for each check that a use repeats, from the last check to the first.
    pub repeated: Vec<bool>,
}

impl Decided {
    pub fn is_any(&self) -> bool {
        self.gone.contains(&true) || self.repeated.contains(&true)
    }
}

/// Decides what goes.
pub(super) fn decided<'f>(
    module: &'f Module,
    locals: &'f [Local],
    (made, is_copy): (&dyn Fn(LocalId) -> bool, &'f dyn Fn(LocalId) -> bool),
    body: &Block,
) -> Decided {
    let may_go = (0..locals.len() as u32).map(|at| made(LocalId(at))).collect();
    let mut known = Known::new(module, locals, may_go);
    known.block(body);
    let mut backwards = Backwards { is_copy, ..Backwards::new(module, locals, known) };
    backwards.block(body);
    let Backwards { known, mut gone, repeated, .. } = backwards;
    for (at, gone) in gone.iter_mut().enumerate() {
        *gone |= known.may_go[at] && !known.mentioned[at];
    }
    Decided { gone, repeated }
}

/// Position in the evaluation; a later one is larger.
type Moment = u64;

/// Reads of a temporary.
#[derive(Clone, Copy)]
struct Reads {
    count: u32,
    first: Moment,
    /// Moment of the last read. A read in a loop without the declaration counts until the loop's end.
    last: Moment,
    /// Block of the read that the walk met first. In it, `first` and `begin` are the moments between which the value
    /// would be evaluated there.
    block: u32,
    begin: Moment,
    end: Moment,
    site: Site,
    /// Moment of the call that borrows the temporary.
    borrowed: Option<Moment>,
}

/// Restrictions on a value at a read.
#[derive(Clone, Copy)]
struct Site {
    /// True if the read is conditional, or in an operation that may be skipped.
    conditional: bool,
    /// True if the read is in a check, whose condition has no effect and faults by arithmetic alone.
    checked: bool,
    allowed: Allowed,
}

/// Site without restrictions.
const ANYWHERE: Site = Site { conditional: false, checked: false, allowed: Allowed::Any };

/// Moments of the next accesses and ends.
struct Next {
    /// Moment of the next read of each local.
    read: Vec<Moment>,
    written: Vec<Moment>,
    /// Moment of the next index that may be out of range.
    misses: Moment,
    /// Moment of the next other end of the function.
    ends: Moment,
    /// Moment of the next write that the caller sees.
    shows: Moment,
}

/// Values that may replace a read.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Allowed {
    Any,
    /// Values without calls and intrinsics.
    Arithmetic,
    Names,
}

/// Backward walk that decides which temporaries are substituted.
struct Backwards<'f> {
    module: &'f Module,
    locals: &'f [Local],
    known: Known<'f>,
    /// True for a local that only names a place, which was read before: the place may be read several times.
    is_copy: &'f dyn Fn(LocalId) -> bool,
    gone: Vec<bool>,
    reads: Vec<Reads>,
    next: Next,
    /// Moment and block of the next unconditional use of an index.
    indexed: HashMap<Index, (Moment, u32)>,
    /// True for each check that a use repeats, from the last check to the first.
    repeated: Vec<bool>,
    now: Moment,
    block: u32,
    blocks: u32,
    /// Moments of the ends of the surrounding loops, outermost first.
    loops: Vec<Moment>,
    site: Site,
}

/// Effects of evaluating a value.
#[derive(Default)]
struct Effects {
    reads: Vec<LocalId>,
    writes: Vec<LocalId>,
    /// True if an index in it may be out of range.
    misses: bool,
    /// True if another operation in it may end the function.
    ends: bool,
    calls: bool,
}

impl Effects {
    /// Returns true if the value writes nothing and faults by arithmetic alone.
    fn are_of_arithmetic(&self) -> bool {
        self.writes.is_empty() && !self.misses && !self.calls
    }
}

impl<'f> Backwards<'f> {
    fn new(module: &'f Module, locals: &'f [Local], known: Known<'f>) -> Self {
        let (count, never) = (locals.len(), Moment::MAX);
        let unread = Reads {
            count: 0,
            first: never,
            last: 0,
            block: 0,
            begin: 0,
            end: 0,
            site: ANYWHERE,
            borrowed: None,
        };
        Backwards {
            module,
            locals,
            known,
            is_copy: &|_| false,
            gone: vec![false; count],
            reads: vec![unread; count],
            next: Next {
                read: vec![never; count],
                written: vec![never; count],
                misses: never,
                ends: never,
                shows: never,
            },
            indexed: HashMap::new(),
            repeated: Vec::new(),
            now: never - 1,
            block: 0,
            blocks: 0,
            loops: Vec::new(),
            site: ANYWHERE,
        }
    }

    fn block(&mut self, block: &Block) {
        self.blocks += 1;
        let outer = std::mem::replace(&mut self.block, self.blocks);
        block.0.iter().rev().for_each(|stmt| self.stmt(stmt));
        self.block = outer;
    }

    fn stmt(&mut self, stmt: &Stmt) {
        match &stmt.kind {
            StmtKind::Let { local, value: Some(value) } if self.goes(*local, value) => {
                self.gone[local.index()] = true;
            }
            StmtKind::Let { local, value } => {
                self.writes(*local);
                value.iter().for_each(|value| self.expr(value));
            }
            StmtKind::Assign { place, value } => {
                self.writes(place.root);
                self.steps(place);
                self.expr(value);
            }
            StmtKind::Expr(value) => self.expr(value),
            StmtKind::Return(value) => {
                self.may_end();
                value.iter().for_each(|value| self.expr(value));
            }
            StmtKind::If { condition, then, otherwise } => {
                self.block(otherwise);
                self.block(then);
                self.expr(condition);
            }
            StmtKind::Match { scrutinee, arms, otherwise } => {
                otherwise.iter().for_each(|block| self.block(block));
                arms.iter().rev().for_each(|arm| self.block(&arm.body));
                // An enum may hold no variant.
                self.may_end();
                self.expr(scrutinee);
            }
            StmtKind::For { variable, from, to, body, .. } => {
                self.now -= 1;
                self.loops.push(self.now);
                self.block(body);
                self.loops.pop();
                self.writes(*variable);
                // C evaluates a bound in each pass: a computed bound, and a call in one, stays before the loop.
                self.site.allowed = match checks::local(to) {
                    Some(_) => Allowed::Names,
                    None => Allowed::Arithmetic,
                };
                self.expr(to);
                self.site.allowed = Allowed::Any;
                self.expr(from);
            }
            StmtKind::Check { condition, .. } => {
                if self.known.is_last_again() {
                    self.repeated.push(true);
                    return;
                }
                let repeated = checks::index_check(&stmt.kind).and_then(|it| self.repeated(it));
                self.repeated.push(repeated.is_some());
                if let Some(used) = repeated {
                    earlier(&mut self.next.misses, used);
                    return;
                }
                self.may_end();
                if let Some(index) = checks::index_check(&stmt.kind) {
                    self.now -= 1;
                    self.indexed.insert(index, (self.now, self.block));
                }
                self.site.checked = true;
                self.expr(condition);
                self.site.checked = false;
            }
            StmtKind::Break | StmtKind::Continue => self.may_end(),
        }
    }

    fn expr(&mut self, expr: &Expr) {
        match &expr.kind {
            ExprKind::Literal(_) | ExprKind::Const(_) => {}
            ExprKind::Load(place) if self.known.may_go[place.root.index()] => {
                self.temporary(place.root, None);
                self.steps(place);
            }
            ExprKind::Load(place) => {
                self.reads(place.root);
                self.steps(place);
            }
            ExprKind::Call(_, arguments) => self.call(arguments),
            ExprKind::Logic(_, left, right) => {
                let outer = std::mem::replace(&mut self.site.conditional, true);
                self.expr(right);
                self.site.conditional = outer;
                self.expr(left);
            }
            ExprKind::Unary(_, x) | ExprKind::Cast(x) | ExprKind::Splat(x) => {
                self.operation(expr);
                self.expr(x);
            }
            ExprKind::Binary(_, left, right) | ExprKind::Compare(_, left, right) => {
                self.operation(expr);
                self.expr(right);
                self.expr(left);
            }
            ExprKind::Intrinsic(_, operands)
            | ExprKind::Struct(operands)
            | ExprKind::Array(operands)
            | ExprKind::Matrix(operands)
            | ExprKind::Routine(_, operands) => {
                self.operation(expr);
                operands.iter().rev().for_each(|operand| self.expr(operand));
            }
        }
    }

    /// Records a call: a mutable borrow is written at the call, and a shared borrow is read from its own moment until
    /// the call.
    fn call(&mut self, arguments: &[Argument]) {
        self.may_end();
        let call = self.now;
        for argument in arguments {
            if let Argument::RefMut(place) = argument {
                self.reads(place.root);
                self.writes(place.root);
            }
        }
        for argument in arguments.iter().rev() {
            match argument {
                Argument::Ref(Expr { kind: ExprKind::Load(place), .. })
                    if self.known.may_go[place.root.index()] =>
                {
                    self.temporary(place.root, Some(call));
                    self.steps(place);
                }
                Argument::Value(value) | Argument::Ref(value) => self.expr(value),
                Argument::RefMut(place) => self.steps(place),
            }
        }
    }

    /// Returns the moment of an index' use before which nothing else ends the function or is visible.
    fn repeated(&self, index: Index) -> Option<Moment> {
        let (used, block) = *self.indexed.get(&index)?;
        let repeated = block == self.block
            && self.next.ends > used
            && self.next.shows > used
            && self.next.written[index.0.index()] > used;
        repeated.then_some(used)
    }

    /// Records the steps to a place: for each step its indices, then the bounds check.
    fn steps(&mut self, place: &Place) {
        let doubtful = self.doubtful(place);
        for (step, doubtful) in place.steps.iter().zip(doubtful).rev() {
            if !doubtful.is_empty() {
                self.now -= 1;
                if !self.known.are_checked(&doubtful) {
                    earlier(&mut self.next.misses, self.now);
                }
                if !self.site.conditional {
                    let used = (self.now, self.block);
                    self.indexed.extend(doubtful.into_iter().flatten().map(|it| (it, used)));
                }
            }
            match step {
                Step::Field(_) => {}
                Step::Index(index) | Step::From(index) => self.expr(index),
                Step::Element(row, column) => {
                    self.expr(column);
                    self.expr(row);
                }
            }
        }
    }

    fn operation(&mut self, expr: &Expr) {
        if may_fault(expr) {
            self.may_end();
        }
    }

    /// Returns the indices of each step that may be out of range.
    fn doubtful(&self, place: &Place) -> Vec<Vec<Option<Index>>> {
        checks::doubtful(self.module, self.locals, &self.known.counters, place)
    }

    /// Returns true if an index of a place may be out of range.
    fn misses(&self, place: &Place) -> bool {
        self.doubtful(place).iter().any(|it| !self.known.are_checked(it))
    }

    fn may_end(&mut self) {
        self.now -= 1;
        earlier(&mut self.next.ends, self.now);
    }

    fn reads(&mut self, local: LocalId) {
        self.now -= 1;
        earlier(&mut self.next.read[local.index()], self.now);
    }

    fn writes(&mut self, local: LocalId) {
        self.now -= 1;
        earlier(&mut self.next.written[local.index()], self.now);
        if self.is_seen(local) {
            earlier(&mut self.next.shows, self.now);
        }
    }

    /// Returns true if the caller sees writes to a local.
    fn is_seen(&self, local: LocalId) -> bool {
        self.locals[local.index()].mode != Mode::Value
    }

    /// Records the read of a temporary, and reserves moments for the evaluation of its value there.
    fn temporary(&mut self, local: LocalId, borrowed: Option<Moment>) {
        let (end, depth) = (self.now - 1, self.known.depth[local.index()]);
        self.now = end - self.known.room(local);
        let reads = &mut self.reads[local.index()];
        reads.count += 1;
        reads.first = self.now;
        let last = self.loops.get(depth).copied().unwrap_or(self.now);
        reads.last = reads.last.max(last).max(borrowed.unwrap_or(0));
        let (begin, block) = (self.now, self.block);
        let site = self.site;
        let reads = &mut self.reads[local.index()];
        *reads = Reads { begin, end, block, site, borrowed, ..*reads };
    }

    /// Decides if a temporary is substituted, and records the effects of its value at the place where it is then
    /// evaluated.
    fn goes(&mut self, local: LocalId, value: &Expr) -> bool {
        let (at, reads) = (local.index(), self.reads[local.index()]);
        if !self.known.may_go[at] {
            return false;
        }
        let effects = self.effects(value);
        let free = effects.writes.is_empty() && !effects.ends && !effects.misses;
        match reads.count {
            0 => free,
            1 if self.known.uses[at] == 1
                && !self.known.parts[at]
                && reads.block == self.block
                && may_replace(value, reads.site.allowed)
                && (free || !reads.site.conditional)
                && (!reads.site.checked || effects.are_of_arithmetic())
                && self.may_wait(&effects, value, &reads) =>
            {
                let now = std::mem::replace(&mut self.now, reads.end);
                let outer = std::mem::replace(&mut self.site, reads.site);
                match &value.kind {
                    ExprKind::Load(of) if self.known.may_go[of.root.index()] => {
                        self.temporary(of.root, reads.borrowed);
                        self.steps(of);
                    }
                    _ => self.expr(value),
                }
                self.now = now;
                self.site = outer;
                true
            }
            _ => self.is_name_for(local, value, &reads),
        }
    }

    /// Returns true if a value may be evaluated at its only reader.
    fn may_wait(&self, effects: &Effects, value: &Expr, reads: &Reads) -> bool {
        let until = match (reads.borrowed, &value.kind) {
            // It is not copied, so the call must not write it either.
            (Some(call), ExprKind::Load(_)) => call,
            _ => reads.begin,
        };
        let unchanged = effects.reads.iter().all(|it| self.next.written[it.index()] > until);
        let untouched = effects.writes.iter().all(|it| {
            self.next.written[it.index()] > reads.begin && self.next.read[it.index()] > reads.begin
        });
        let seen = effects.writes.iter().any(|it| self.is_seen(*it));
        // Two indices beyond the end give the same fault in either order.
        let faults = effects.ends || effects.misses;
        unchanged
            && untouched
            && (!faults || self.next.ends > reads.begin && self.next.shows > reads.begin)
            && (!effects.ends || self.next.misses > reads.begin)
            && (!seen || self.next.ends > reads.begin)
    }

    /// Returns true if a temporary only names a place or a literal that does not change until the last read.
    fn is_name_for(&mut self, local: LocalId, value: &Expr, reads: &Reads) -> bool {
        let place = match &value.kind {
            ExprKind::Literal(_) | ExprKind::Const(_) => return !self.known.parts[local.index()],
            ExprKind::Load(place) => place,
            _ => match as_size(value) {
                Some(place) => place,
                None => return false,
            },
        };
        // An aggregate in an array is read in its place.
        let indices: Option<Vec<LocalId>> = match is_plain(place) {
            true => Some(Vec::new()),
            false if !(self.is_copy)(local) && (value.ty.is_word() || self.misses(place)) => None,
            false => place
                .steps
                .iter()
                .flat_map(Step::indices)
                .filter(|it| !it.is_literal())
                .map(checks::local)
                .collect(),
        };
        let Some(indices) = indices else { return false };
        let named = || indices.iter().chain([&place.root]);
        if named().any(|local| self.next.written[local.index()] <= reads.last) {
            return false;
        }
        named().for_each(|local| self.reads_too(*local, reads));
        true
    }

    /// Counts the reads of a temporary as reads of another local.
    fn reads_too(&mut self, local: LocalId, reads: &Reads) {
        let at = local.index();
        if self.known.may_go[at] {
            let last = self.loops.get(self.known.depth[at]).copied().unwrap_or(reads.last);
            let of = &mut self.reads[at];
            of.count += reads.count;
            earlier(&mut of.first, reads.first);
            of.last = of.last.max(last).max(reads.last);
        } else {
            earlier(&mut self.next.read[at], reads.first);
        }
    }

    fn effects(&self, value: &Expr) -> Effects {
        let mut effects = Effects::default();
        value.each_place(|place, access| {
            effects.misses |= self.misses(place);
            effects.reads.push(place.root);
            if access != Access::Read {
                effects.writes.push(place.root);
            }
        });
        effects.calls = value.any_expr(|expr| matches!(expr.kind, ExprKind::Call(..)));
        effects.ends = effects.calls || value.any_expr(may_fault);
        effects
    }
}

fn earlier(known: &mut Moment, now: Moment) {
    *known = now.min(*known);
}

/// Returns true if a computed value may replace a read.
fn may_replace(value: &Expr, allowed: Allowed) -> bool {
    let calls = |expr: &Expr| matches!(expr.kind, ExprKind::Call(..) | ExprKind::Intrinsic(..));
    match allowed {
        Allowed::Any => true,
        Allowed::Arithmetic => !value.any_expr(calls),
        Allowed::Names => false,
    }
}

/// Returns the local that a value converts to `usize`, without another effect: an index of C needs no conversion.
fn as_size(value: &Expr) -> Option<&Place> {
    let ExprKind::Cast(inner) = &value.kind else { return None };
    let ExprKind::Load(place) = &inner.kind else { return None };
    let unsigned = inner.ty.as_int().is_some_and(|int| !int.signed());
    (value.ty == Type::USIZE && unsigned && place.steps.is_empty()).then_some(place)
}

/// Returns true if a place has only fields as steps.
fn is_plain(place: &Place) -> bool {
    place.steps.iter().all(|step| matches!(step, Step::Field(_)))
}

/// Returns true if an operation itself may fault.
fn may_fault(expr: &Expr) -> bool {
    let float = matches!(expr.ty, Type::Scalar(Scalar::Float(_) | Scalar::Bool));
    match &expr.kind {
        ExprKind::Unary(op, _) => *op == UnaryOp::Neg && !float,
        ExprKind::Binary(op, ..) => {
            !float && !matches!(op, BinaryOp::And | BinaryOp::Or | BinaryOp::Xor)
        }
        ExprKind::Intrinsic(Intrinsic::Clamp, _) => true,
        ExprKind::Intrinsic(which, _) => {
            use Intrinsic::*;
            !float && matches!(which, Abs | WrappingDiv | WrappingRem | DivEuclid | RemEuclid)
        }
        ExprKind::Routine(..) => {
            !matches!(expr.ty, Type::Matrix { element: Scalar::Float(_), .. }) && !float
        }
        _ => false,
    }
}
