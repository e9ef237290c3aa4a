//! Removes statements without effect from explicit IR.
//!
//! * A value that is read from a place and stored there again.
//! * A local of the passes that only passes its value on: to the next statement, to the `if` that tests it, or to the
//!   author's local.
//! * A local that an `if` alone sets to the right side of `&&` or `||`: it is the whole condition.
//! * A local of numbers that a loop computes for one other loop: that loop computes them.
//! * A local of equal numbers that is only copied as a whole: each copy is of these numbers.
//! * A loop over a literal range without a number, as `0..N % 3` is for some `N`.
//!
//! Preserves: the value of every place after each statement, and the faults. Must not know: why the passes made a
//! local.

use bessemer_ir::visit::{Access, VisitMut, Walk, walk_block_mut, walk_expr_mut, walk_place_mut};
use bessemer_ir::{
    Block, Expr, ExprKind, Function, LocalId, LogicOp, Mode, Place, Scalar, Step, Stmt, StmtKind,
    Type,
};

use super::places::disturbs;
use super::positions::{self, Callee, Position};
use crate::late::Early;
use crate::routines::{is_element_wise, outer};
use bessemer_ir::effects::{
    calls, is_own, lent, mentions, moves, reads, same_place, writes, writes_local,
};

/// Largest number of elements that are computed one per line.
const LINES: u32 = 4;

/// Tidies a function; its first `own` locals are the author's.
pub(super) fn tidy(function: &mut Function, own: usize, callees: &[Callee]) {
    let mut body = std::mem::take(&mut function.body);
    let mut again = true;
    while again {
        let mut uses = vec![0; function.locals.len()];
        body.each_place(|place, _| uses[place.root.index()] += 1);
        let mut tidy = Tidy { function, own, callees, uses, again: false };
        tidy.block(&mut body);
        again = tidy.again;
    }
    function.body = body;
}

struct Tidy<'f> {
    function: &'f Function,
    own: usize,
    callees: &'f [Callee],
    /// Number of uses of each local, without its declaration.
    uses: Vec<usize>,
    /// True if a removal may allow further ones.
    again: bool,
}

impl VisitMut for Tidy<'_> {
    fn block(&mut self, block: &mut Block) {
        walk_block_mut(self, block);
        let mut at = 0;
        while at < block.0.len() {
            let less = self.put_back(&mut block.0, at)
                || self.put_back_later(&mut block.0, at)
                || self.handed_on(&mut block.0, at)
                || self.asked(&mut block.0, at)
                || self.joined(&mut block.0, at)
                || self.renamed(&mut block.0, at)
                || self.equal(&mut block.0, at)
                || self.empty(&mut block.0, at)
                || self.fused(&mut block.0, at);
            at += usize::from(!less);
        }
    }
}

impl Tidy<'_> {
    /// Removes `let same = x; x = same;`.
    fn put_back(&self, stmts: &mut Vec<Stmt>, at: usize) -> bool {
        let [Stmt { kind: StmtKind::Let { local, value: Some(value) }, .. }, next, ..] =
            &stmts[at..]
        else {
            return false;
        };
        let StmtKind::Assign { place, value: back } = &next.kind else { return false };
        let idle = self.is_used_once(*local)
            && is_load(back, *local)
            && is_own(value, place)
            && next.comments.is_empty();
        if idle {
            let comments = stmts.drain(at..at + 2).flat_map(|it| it.comments).collect();
            hand_down(stmts, at, comments);
        }
        idle
    }

    /// Simplifies `let same = x; if … { x = y; } else { x = same; }`: the second branch assigns the old value.
    fn put_back_later(&mut self, stmts: &mut Vec<Stmt>, at: usize) -> bool {
        let StmtKind::Let { local, value: Some(value) } = &stmts[at].kind else { return false };
        let ExprKind::Load(place) = &value.kind else { return false };
        let fixed = place.steps.iter().all(|step| matches!(step, Step::Field(_)));
        let (local, place) = (*local, place.clone());
        if !value.ty.is_word()
            || !fixed
            || place.root == local
            || writes_local(&stmts[at + 1..], local)
            || !put_back_within(&mut stmts[at + 1..], local, &place)
        {
            return false;
        }
        self.again = true;
        let unused = !mentions(&stmts[at + 1..], local);
        if unused {
            let removed = stmts.remove(at);
            hand_down(stmts, at, removed.comments);
        }
        unused
    }

    /// Simplifies `let made = f(); x = made;`.
    fn handed_on(&self, stmts: &mut Vec<Stmt>, at: usize) -> bool {
        let [Stmt { kind: StmtKind::Let { local, value: Some(value) }, .. }, next, ..] =
            &stmts[at..]
        else {
            return false;
        };
        let StmtKind::Assign { place, value: stored } = &next.kind else { return false };
        let through_pointer = match &value.kind {
            ExprKind::Call(callee, _) => {
                let unknown = Some(Early::default());
                self.callees.get(callee.index()).map_or(unknown, |callee| callee.through_pointer)
            }
            _ => None,
        };
        let direct = self.is_made(*local)
            && value.ty.is_word()
            && self.is_used_once(*local)
            && is_load(stored, *local)
            && !moves(place, &lent(value))
            && !disturbs(place, value, through_pointer);
        if direct {
            let value = value.clone();
            let first = stmts.remove(at);
            if let StmtKind::Assign { value: stored, .. } = &mut stmts[at].kind {
                *stored = value;
            }
            hand_down(stmts, at, first.comments);
        }
        direct
    }

    /// Simplifies `let made = f(); if !made { … }`.
    fn asked(&self, stmts: &mut Vec<Stmt>, at: usize) -> bool {
        let [Stmt { kind: StmtKind::Let { local, value: Some(value) }, .. }, next, ..] =
            &stmts[at..]
        else {
            return false;
        };
        let StmtKind::If { condition, .. } = &next.kind else { return false };
        let decides = self.is_made(*local)
            && self.is_used_once(*local)
            && is_load(positions::asked(condition), *local)
            && positions::accepts(self.callees, Position::Decision, value);
        if decides {
            let value = value.clone();
            let first = stmts.remove(at);
            if let StmtKind::If { condition, .. } = &mut stmts[at].kind {
                match &mut condition.kind {
                    ExprKind::Unary(_, asked) => **asked = value,
                    _ => *condition = value,
                }
            }
            hand_down(stmts, at, first.comments);
        }
        decides
    }

    /// Simplifies `let both = false; if a { both = b; }` to `let both = a && b;`, and likewise `||`. Names of constants
    /// for `b` move before it.
    fn joined(&self, stmts: &mut Vec<Stmt>, at: usize) -> bool {
        let [Stmt { kind: StmtKind::Let { local, value: Some(value) }, .. }, next, ..] =
            &stmts[at..]
        else {
            return false;
        };
        let (ExprKind::Literal(start), StmtKind::If { condition, then, otherwise }) =
            (&value.kind, &next.kind)
        else {
            return false;
        };
        let Some((Stmt { kind: StmtKind::Assign { place, value: right }, .. }, names)) =
            then.0.split_last()
        else {
            return false;
        };
        let is_constant = |it: &Stmt| {
            let StmtKind::Let { value: Some(value), .. } = &it.kind else { return false };
            matches!(value.kind, ExprKind::Const(_))
        };
        let plain = names.iter().all(is_constant)
            && then.0.iter().all(|it| it.comments.is_empty())
            && otherwise.0.is_empty();
        let (op, left) = match start {
            0 => (LogicOp::And, condition.clone()),
            _ => (LogicOp::Or, condition.clone().negated()),
        };
        let sets = place.root == *local && place.steps.is_empty() && place.ty == Type::BOOL;
        let nests = |it: &Expr| {
            !mentions(it, *local) && positions::accepts(self.callees, Position::Nested, it)
        };
        if !(sets && plain && nests(&left) && nests(right)) {
            return false;
        }
        let (whole, names) = (Expr::logic(op, left, right.clone()), names.to_vec());
        let removed = stmts.remove(at + 1);
        if let StmtKind::Let { value, .. } = &mut stmts[at].kind {
            *value = Some(whole);
        }
        stmts[at].comments.extend(removed.comments);
        stmts.splice(at..at, names);
        true
    }

    /// Simplifies `let made = …; …; let name = made;`.
    fn renamed(&mut self, stmts: &mut Vec<Stmt>, at: usize) -> bool {
        let StmtKind::Let { local: made, .. } = stmts[at].kind else { return false };
        if !self.is_made(made) {
            return false;
        }
        let Some(last) = stmts.iter().rposition(|stmt| mentions(stmt, made)) else { return false };
        let StmtKind::Let { local: name, value: Some(value) } = &stmts[last].kind else {
            return false;
        };
        let name = *name;
        let local = self.function.local(name);
        if last == at
            || !is_load(value, made)
            || local.mode != Mode::Value
            || local.ty != self.function.local(made).ty
        {
            return false;
        }
        self.uses[name.index()] += self.uses[made.index()];
        let removed = stmts.remove(last);
        let mut rename = Rename(made, name);
        stmts[at..last].iter_mut().for_each(|stmt| rename.stmt(stmt));
        hand_down(stmts, at, removed.comments);
        true
    }

    /// Simplifies `let zeros = [0.0; 8]; x = zeros;`.
    fn equal(&self, stmts: &mut Vec<Stmt>, at: usize) -> bool {
        let StmtKind::Let { local, value: Some(value) } = &stmts[at].kind else { return false };
        let ExprKind::Splat(item) = &value.kind else { return false };
        let (local, value) = (*local, value.clone());
        if !matches!(item.kind, ExprKind::Literal(_)) || self.uses[local.index()] == 0 {
            return false;
        }
        let mut copies = Copies { of: local, value: &value, found: 0, put: false };
        copies.count(&mut stmts[at + 1..]);
        if copies.found != self.uses[local.index()] {
            return false;
        }
        copies.put = true;
        copies.count(&mut stmts[at + 1..]);
        let removed = stmts.remove(at);
        hand_down(stmts, at, removed.comments);
        true
    }

    /// Removes `for n in 0..0 { … }`.
    fn empty(&mut self, stmts: &mut Vec<Stmt>, at: usize) -> bool {
        let StmtKind::For { from, to, inclusive, ended: false, .. } = &stmts[at].kind else {
            return false;
        };
        let (ExprKind::Literal(first), ExprKind::Literal(end)) = (&from.kind, &to.kind) else {
            return false;
        };
        let Some(int) = from.ty.as_int() else { return false };
        let (first, end) = (int.from_word(*first), int.from_word(*end));
        if first < end || *inclusive && first == end {
            return false;
        }
        let removed = stmts.remove(at);
        hand_down(stmts, at, removed.comments);
        self.again = true;
        true
    }

    /// Fuses `let product = a * b; let sum = c + product;` element by element.
    fn fused(&self, stmts: &mut Vec<Stmt>, at: usize) -> bool {
        let StmtKind::Let { local, value: Some(value) } = &stmts[at].kind else { return false };
        let local = *local;
        let ExprKind::Routine(routine, operands) = &value.kind else { return false };
        let by_elements = is_element_wise(*routine) || outer(*routine, operands);
        let Type::Matrix { element: Scalar::Float(_), rows, cols } = value.ty else { return false };
        if !by_elements || rows * cols <= LINES || !self.is_used_once(local) {
            return false;
        }
        let Some(user) = stmts.iter().position(|stmt| mentions(stmt, local)) else { return false };
        let (StmtKind::Let { value: Some(given), .. }
        | StmtKind::Return(Some(given))
        | StmtKind::Assign { value: given, .. }) = &stmts[user].kind
        else {
            return false;
        };
        let mut given = given.clone();
        let changed = writes(&stmts[at + 1..user]);
        if reads(value, &changed) || calls(value) || !put(&mut given, local, value) {
            return false;
        }
        match &mut stmts[user].kind {
            StmtKind::Assign { place, .. } if disturbs(place, &given, None) => return false,
            StmtKind::Let { value: Some(to), .. }
            | StmtKind::Return(Some(to))
            | StmtKind::Assign { value: to, .. } => *to = given,
            _ => return false,
        }
        let removed = stmts.remove(at);
        hand_down(stmts, at, removed.comments);
        true
    }

    fn is_made(&self, local: LocalId) -> bool {
        local.index() >= self.own
    }

    fn is_used_once(&self, local: LocalId) -> bool {
        self.uses[local.index()] == 1
    }
}

/// Returns true if an expression loads a whole local.
fn is_load(expr: &Expr, local: LocalId) -> bool {
    matches!(&expr.kind, ExprKind::Load(place) if place.root == local && place.steps.is_empty())
}

/// Removes assignments, also in branches, that store a local into the place that it is a copy of, if nothing wrote it
/// before. Returns true if there were any.
fn put_back_within(stmts: &mut [Stmt], local: LocalId, place: &Place) -> bool {
    let mut found = false;
    for stmt in stmts {
        let asked = match &stmt.kind {
            StmtKind::If { condition: asked, .. } | StmtKind::Match { scrutinee: asked, .. } => {
                lent(asked)
            }
            _ => Vec::new(),
        };
        // The condition may write there itself: `if !step(&mut x) { x = same; }`.
        if reads(&place.load(), &asked) {
            return found;
        }
        let blocks: Vec<&mut Block> = match &mut stmt.kind {
            StmtKind::If { then, otherwise, .. } => vec![then, otherwise],
            StmtKind::Match { arms, otherwise, .. } => {
                arms.iter_mut().map(|arm| &mut arm.body).chain(otherwise).collect()
            }
            _ => Vec::new(),
        };
        for block in blocks {
            found |= put_back_within(&mut block.0, local, place);
            let before = block.0.len();
            let first = block.0.iter().position(|stmt| reads(&place.load(), &writes([stmt])));
            if let Some(first) = first
                && block.0[first].comments.is_empty()
                && matches!(&block.0[first].kind, StmtKind::Assign { place: to, value }
                    if same_place(to, place) && is_load(value, local))
            {
                block.0.remove(first);
            }
            found |= block.0.len() < before;
        }
        if reads(&place.load(), &writes([&*stmt])) {
            return found;
        }
    }
    found
}

/// Replaces a local by its value where it is an operand of an element-wise routine.
fn put(expr: &mut Expr, local: LocalId, value: &Expr) -> bool {
    let ExprKind::Routine(routine, operands) = &mut expr.kind else { return false };
    is_element_wise(*routine)
        && operands.iter_mut().any(|operand| {
            if is_load(operand, local) {
                *operand = value.clone();
                return true;
            }
            put(operand, local, value)
        })
}

/// Moves the comments of a removed statement to the statement that follows.
fn hand_down(stmts: &mut [Stmt], at: usize, mut comments: Vec<String>) {
    if let Some(stmt) = stmts.get_mut(at) {
        comments.append(&mut stmt.comments);
        stmt.comments = comments;
    }
}

/// Visitor that replaces one local by another.
struct Rename(LocalId, LocalId);

impl VisitMut for Rename {
    fn place(&mut self, place: &mut Place, _: Access) {
        self.declaration(&mut place.root);
        walk_place_mut(self, place);
    }

    fn declaration(&mut self, local: &mut LocalId) {
        if *local == self.0 {
            *local = self.1;
        }
    }
}

/// Visitor that replaces whole copies of a local by its value, where that is allowed.
struct Copies<'v> {
    of: LocalId,
    value: &'v Expr,
    found: usize,
    put: bool,
}

impl Copies<'_> {
    fn count(&mut self, stmts: &mut [Stmt]) {
        stmts.iter_mut().for_each(|stmt| self.stmt(stmt));
    }

    fn copy(&mut self, expr: &mut Expr) {
        if is_load(expr, self.of) {
            self.found += 1;
            if self.put {
                expr.kind = self.value.kind.clone();
            }
        }
    }
}

impl VisitMut for Copies<'_> {
    fn stmt(&mut self, stmt: &mut Stmt) {
        if let StmtKind::Assign { value, .. } = &mut stmt.kind {
            self.copy(value);
        }
        bessemer_ir::visit::walk_stmt_mut(self, stmt);
    }

    fn expr(&mut self, expr: &mut Expr) {
        if let ExprKind::Struct(items) = &mut expr.kind {
            items.iter_mut().for_each(|item| self.copy(item));
        }
        walk_expr_mut(self, expr);
    }
}
