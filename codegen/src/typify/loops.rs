//! Loops, and how they are left.
//!
//! A loop with a declared bound is a `for` over its passes; one whose bound shows is a `for` that its
//! own condition ends. Leaving a loop that is not the innermost
//! raises a flag: each loop in between ends, and looks at the flag behind it.

use bessemer_ir::tree::{self, Builtin, ListMethod, Site};
use bessemer_ir::{
    Block, CompareOp, Expr, ExprKind, Fault, Int, LocalId, LogicOp, Mode, Place, Scalar, Span,
    Step, Stmt, StmtKind, Type,
};

use crate::termination::{self, Loop, Proof};

use super::conditions::has_let;
use super::each::Each;
use super::lowering::{Behind, Frame, Leaving, Lowering, Target};
use super::order::is_light;
use super::value::Named;
use super::words;
use super::{OUR_FAULT, Result, labelled, problem};

impl Lowering<'_, '_> {
    /// A loop through a range, or through elements.
    pub(super) fn through(&mut self, expr: &tree::Expr) -> Result<()> {
        match &expr.kind {
            tree::ExprKind::For { label, name, slot, range, body } => {
                self.for_stmt(expr.site, label.as_deref(), (name, *slot), range, body)
            }
            tree::ExprKind::Each { label, index, parts, order, cuts, body } => {
                let (site, label, index) = (expr.site, label.as_deref(), index.as_deref());
                self.each_stmt(parts, Each { site, label, index, order: *order, cuts, body })
            }
            _ => self.effect(expr),
        }
    }

    pub(super) fn for_stmt(
        &mut self,
        site: Site,
        label: Option<&str>,
        (name, slot): (&str, u32),
        range: &tree::Range,
        body: &tree::Block,
    ) -> Result<()> {
        let (ty, span) = (self.slot(slot, site)?, self.span(site));
        let [from, to] = self.ends(range, &ty, site)?;
        let open = range.to.is_none();
        let name = if name.starts_with('_') { words::PASS } else { name };
        if range.step.is_some() {
            return self.stepped(site, label, (name, ty), range, [from, to], body);
        }
        self.repeated(label, None, span, |inner| {
            let mut variable = LocalId(0);
            let body = inner.scoped(|inner| {
                variable = inner.declare(name, ty, Mode::Value, span);
                inner.steady.insert(variable);
                if open {
                    inner.ask_open(variable, &to, span);
                }
                inner.statements(body)
            })?;
            let (inclusive, reversed) = (range.inclusive || open, range.reversed);
            let (unroll, ended) = (None, false);
            Ok(StmtKind::For { variable, from, to, inclusive, reversed, unroll, ended, body })
        })
    }

    /// `while`: one pass more than the bound comes to the condition, and not beyond.
    pub(super) fn while_stmt(
        &mut self,
        site: Site,
        label: Option<&str>,
        condition: &tree::Expr,
        bound: Option<&tree::Expr>,
        body: &tree::Block,
    ) -> Result<()> {
        if let (None, Some(rest)) = (bound, self.rest_of(condition, body)) {
            let (index, order, cuts) = (None, tree::Order::Up, &[][..]);
            return self.each_stmt(&[rest], Each { site, label, index, order, cuts, body });
        }
        let span = self.span(site);
        let bound = bound.map(|bound| self.passes(bound)).transpose()?;
        let length = self.popped_length(condition)?;
        self.repeated(label, None, span, |inner| {
            let declared = bound.map(|bound| (inner.pass(&bound, span), bound));
            let mut heads = Vec::new();
            let body = inner.scoped(|inner| {
                let mut names = Vec::new();
                heads = inner.heads(condition, &mut names, span)?;
                if let Some((pass, bound)) = &declared {
                    inner.emit(begun(*pass, bound, span), span);
                }
                inner.bind_names(&names)?;
                inner.statements(body)
            })?;
            match (declared, length) {
                (Some((pass, bound)), _) => Ok(passes(pass, bound, true, body)),
                (None, Some(length)) => {
                    let name = |place: &Place| inner.place_name(place);
                    let rest = &body.0[heads[0] + 1..];
                    let shown = termination::popped(&inner.cx.module, name, &length, rest);
                    inner.ended(site, shown, body)
                }
                (None, None) => {
                    let shown = inner.shown(&body, &heads);
                    inner.ended(site, shown, body)
                }
            }
        })
    }

    /// `loop`, the value of its `break` to `target` if it has one.
    pub(super) fn loop_stmt(
        &mut self,
        site: Site,
        label: Option<&str>,
        bound: Option<&tree::Expr>,
        body: &tree::Block,
        target: Option<&Target>,
    ) -> Result<()> {
        let span = self.span(site);
        let bound = bound.map(|bound| self.passes(bound)).transpose()?;
        let (mut endless, mut behind) = (false, Vec::new());
        self.repeated(label, target, span, |inner| {
            let declared = bound.map(|bound| (inner.pass(&bound, span), bound));
            let mut body = inner.scoped(|inner| inner.statements(body))?;
            let Some((pass, bound)) = declared else {
                behind = last_breath(&mut body);
                return inner.ended_loop(site, body);
            };
            endless = !breaks(&body);
            if !endless {
                body.0.insert(0, Stmt::new(begun(pass, &bound, span), span));
            }
            Ok(passes(pass, bound, !endless, body))
        })?;
        self.out.extend(behind);
        if endless {
            // Behind the last pass there is nothing but the fault.
            let condition = Expr::bool(false, span);
            self.emit(StmtKind::Check { condition, fault: Fault::Bound }, span);
        }
        Ok(())
    }

    /// The length of the list that `while let Some(…) = list.pop()` takes from.
    fn popped_length(&mut self, condition: &tree::Expr) -> Result<Option<Expr>> {
        let tree::ExprKind::Let(pattern, value) = &condition.kind else { return Ok(None) };
        let tree::Pattern::Constructor(variant, _) = &**pattern else { return Ok(None) };
        let Some((Builtin::List(ListMethod::Pop), arguments)) = self.builtin_call(value) else {
            return Ok(None);
        };
        if variant != "Some" || !is_named(&arguments[0]) {
            return Ok(None);
        }
        let list = self.base(&arguments[0])?;
        Ok(self.list_items(&list).map(|(length, _)| length.load()))
    }

    /// Leaves a loop where its condition does not hold; gives the places of the `if`s that do. There is one for all
    /// that C can say in one expression: what has to be computed first is computed only where the conditions before
    /// it hold.
    fn heads(
        &mut self,
        condition: &tree::Expr,
        names: &mut Vec<Named>,
        span: Span,
    ) -> Result<Vec<usize>> {
        let leave = |condition: Expr| {
            let then = Block::of(StmtKind::Break, span);
            Stmt::new(StmtKind::if_then(condition.negated(), then), span)
        };
        let is_true = |condition: &Expr| condition.kind == ExprKind::Literal(1);
        let mut parts = conjuncts(condition).into_iter();
        let mut holds = match parts.next() {
            Some(first) => self.pattern_condition(first, names)?,
            None => Expr::bool(true, span),
        };
        let mut heads = Vec::new();
        for part in parts {
            let at = self.out.len();
            if has_let(condition) {
                self.keep_changeable(names)?;
            }
            let next = self.pattern_condition(part, names)?;
            holds = match self.out.len() == at {
                _ if is_true(&holds) => next,
                true if is_true(&next) => holds,
                true => Expr::logic(LogicOp::And, holds, next),
                false => {
                    self.out.insert(at, leave(holds));
                    heads.push(at);
                    next
                }
            };
        }
        // What always holds leaves nowhere.
        if heads.is_empty() || !is_true(&holds) {
            heads.push(self.out.len());
            self.out.push(leave(holds));
        }
        Ok(heads)
    }

    /// The bound that shows of a loop which one of the `if`s at `heads` of its body ends.
    fn shown(&self, body: &Block, heads: &[usize]) -> Result<Proof, termination::Reason> {
        let name = |place: &Place| self.place_name(place);
        let shown = |head: &usize| {
            let of = left_at(&body.0, *head, &self.out).ok_or_else(no_end)?;
            termination::proof(&self.cx.module, name, &of)
        };
        let mut all = heads.iter().map(shown);
        let first = all.next().unwrap_or_else(|| Err(no_end()));
        first.or_else(|why| all.find_map(Result::ok).ok_or(why))
    }

    /// A `loop` without a declared bound: one of its `if … { break; }` has to show that it ends.
    fn ended_loop(&mut self, site: Site, body: Block) -> Result<StmtKind> {
        let (mut shown, span) = (Err(no_end()), self.span(site));
        for head in 0..body.0.len() {
            let Some(of) = left_at(&body.0, head, &self.out) else { continue };
            let name = |place: &Place| self.place_name(place);
            match termination::proof(&self.cx.module, name, &of) {
                Ok(proof) => return self.ended(site, Ok(proof), body),
                Err(reason) => match termination::turned(&self.cx.module, name, &of) {
                    Ok(()) => return Ok(self.turned(body, span)),
                    Err(turned) => shown = Err(if head == 0 { reason } else { turned }),
                },
            }
        }
        self.ended(site, shown, body)
    }

    /// A loop that ends, though nothing is known of its first pass: any number of passes is enough.
    fn turned(&mut self, body: Block, span: Span) -> StmtKind {
        let ty = Type::Scalar(Scalar::Int(Int::U64));
        let bound = |word| Expr::literal(word, ty.clone(), span);
        self.ended_within(bound(0), bound(u64::MAX), body, span)
    }

    fn ended_within(&mut self, from: Expr, to: Expr, body: Block, span: Span) -> StmtKind {
        let variable = self.pass(&from, span);
        let (inclusive, reversed, unroll, ended) = (true, false, None, true);
        StmtKind::For { variable, from, to, inclusive, reversed, unroll, ended, body }
    }

    /// A loop that its body ends, within a bound that shows.
    fn ended(
        &mut self,
        site: Site,
        shown: Result<Proof, termination::Reason>,
        body: Block,
    ) -> Result<StmtKind> {
        let span = self.span(site);
        let Proof { low, high, inclusive } = match shown {
            Ok(proof) => proof,
            Err(reason) => {
                return problem(
                    site,
                    format!("nothing shows how often this loop runs at most: {reason}"),
                    "write `#[bound(64)]` above it: another pass than that is a fault; or count in it: \
                     `while i < n { …; i += 1; }`",
                );
            }
        };
        // The last pass comes no further than the condition, so there is one more than the proof says.
        let Some(int) = low.ty.as_int() else { return problem(site, "no integers", OUR_FAULT) };
        let limit = |value: i128| Expr::literal_like(value as u64, &low);
        let from = if is_light(&low) { low.clone() } else { limit(int.min()) };
        let to = if is_light(&high) && !inclusive { high } else { limit(int.max()) };
        Ok(self.ended_within(from, to, body, span))
    }

    /// A place as its author names it.
    fn place_name(&self, place: &Place) -> String {
        let mut name = self.locals[place.root.index()].name.replace('%', "");
        let mut ty = &self.locals[place.root.index()].ty;
        for step in &place.steps {
            if let (Step::Field(field), Type::Struct(id)) = (step, ty) {
                let field = &self.cx.module.structs[id.index()].fields[*field as usize];
                name = format!("{name}.{}", field.name);
                ty = &field.ty;
            }
        }
        name
    }

    /// The counter of the passes of a loop with a bound; the author has no name for it.
    fn pass(&mut self, bound: &Expr, span: Span) -> LocalId {
        self.local(words::PASS, bound.ty.clone(), span)
    }

    /// The bound of a loop.
    fn passes(&mut self, bound: &tree::Expr) -> Result<Expr> {
        let value = self.value(bound, Some(&Type::USIZE))?;
        if value.ty.as_int().is_none() {
            return problem(
                bound.site,
                "the bound of a loop is an integer",
                "write `#[bound(64)]`",
            );
        }
        Ok(value)
    }

    pub(super) fn statements(&mut self, body: &tree::Block) -> Result<()> {
        self.stmts(body)?;
        match &body.tail {
            Some(tail) => self.effect(tail),
            None => Ok(()),
        }
    }

    /// Lowers a loop and emits it, with the flags of what leaves it from within.
    pub(super) fn repeated(
        &mut self,
        label: Option<&str>,
        target: Option<&Target>,
        span: Span,
        lower: impl FnOnce(&mut Self) -> Result<StmtKind>,
    ) -> Result<()> {
        let depth = self.frames.len();
        self.frames.push(Frame::of(label, target));
        let kind = lower(self);
        let frame = self.frames.pop();
        let kind = kind?;
        let behind = frame.map(|frame| frame.behind).unwrap_or_default();
        for Behind { flag, left, .. } in &behind {
            // That of a block is declared where the block begins.
            if self.is_outermost(*left, depth) && self.frames[*left].mark.is_none() {
                let value = Expr::bool(false, span);
                self.emit(StmtKind::Let { local: *flag, value: Some(value) }, span);
            }
        }
        match self.at_most_once(&kind, span).filter(|_| behind.is_empty()) {
            Some((condition, pass)) => self.emit_if(condition, pass, span),
            None => self.emit(kind, span),
        }
        for Behind { flag, left, leaving } in behind {
            // What this loop stands in ends as well, unless it is the one that goes on.
            let kind = match (leaving, self.frames[left].mark) {
                (Leaving::Continue, None) if self.is_outermost(left, depth) => StmtKind::Continue,
                (_, Some(mark)) if self.is_outermost(left, depth) => labelled::left(mark),
                _ => StmtKind::Break,
            };
            self.emit_if(Expr::local(flag, &Type::BOOL, span), Block::of(kind, span), span);
        }
        Ok(())
    }

    /// Lowers a pass of a loop that several are, the outermost of them at `outermost`.
    pub(super) fn pass_of<T>(
        &mut self,
        label: Option<&str>,
        outermost: usize,
        lower: impl FnOnce(&mut Self) -> Result<T>,
    ) -> Result<T> {
        self.frames.push(Frame { outermost: Some(outermost), ..Frame::of(label, None) });
        let done = lower(self);
        self.frames.pop();
        done
    }

    /// `break`, with its value if it has one.
    pub(super) fn break_stmt(
        &mut self,
        label: Option<&str>,
        value: Option<&tree::Expr>,
        site: Site,
    ) -> Result<()> {
        if let Some(value) = value {
            let depth = self.depth(label, site)?;
            match self.frames[depth].target.clone() {
                Some(target) => {
                    self.into(value, &target)?;
                    if matches!(target, Target::Return) {
                        return Ok(());
                    }
                }
                None => self.effect(value)?,
            }
        }
        self.leave(label, Leaving::Break, site)
    }

    /// Where the value goes with which the closure's body with this label is left; the function, without one.
    pub(super) fn left_by(&self, label: Option<&str>, site: Site) -> Result<Target> {
        match label {
            Some(_) => match self.frames[self.depth(label, site)?].target.clone() {
                Some(target) => Ok(target),
                None => problem(site, "this leaves what has no value", OUR_FAULT),
            },
            None => Ok(Target::Return),
        }
    }

    /// Leaves a pass of the loop with this label, or of the innermost.
    pub(super) fn leave(
        &mut self,
        label: Option<&str>,
        leaving: Leaving,
        site: Site,
    ) -> Result<()> {
        let span = self.span(site);
        let mut depth = self.depth(label, site)?;
        let named = self.frames[depth].label.clone();
        if let Some(outermost) = self.frames[depth].outermost {
            let innermost = self.frames[..depth].iter().rposition(|it| it.is_loop() || it.pass);
            depth = match leaving {
                Leaving::Break => outermost,
                Leaving::Continue => innermost.unwrap_or(outermost),
            };
        }
        if self.is_outermost(depth, self.frames.len()) {
            let kind = match (leaving, self.frames[depth].mark) {
                (_, Some(mark)) => labelled::left(mark),
                (Leaving::Break, None) => StmtKind::Break,
                (Leaving::Continue, None) => StmtKind::Continue,
            };
            self.emit(kind, span);
            return Ok(());
        }
        let flag = self.flag((depth, named), leaving, span);
        let place = Place::local(flag, Type::BOOL, span);
        let value = Expr::bool(true, span);
        self.emit(StmtKind::Assign { place, value }, span);
        self.emit(StmtKind::Break, span);
        Ok(())
    }

    /// Whether no loop stands between the frame that is left and the one at `depth`.
    fn is_outermost(&self, left: usize, depth: usize) -> bool {
        !self.frames[left + 1..depth].iter().any(Frame::is_loop)
    }

    fn depth(&self, label: Option<&str>, site: Site) -> Result<usize> {
        let found = match label {
            None => self.frames.iter().rposition(|frame| frame.mark.is_none() || frame.pass),
            Some(_) => self.frames.iter().rposition(|frame| frame.label.as_deref() == label),
        };
        match found {
            Some(depth) => Ok(depth),
            None => problem(site, "there is no such loop here", OUR_FAULT),
        }
    }

    /// The flag that leaves the loop at `depth`; each loop in between looks at it.
    fn flag(
        &mut self,
        (depth, named): (usize, Option<String>),
        leaving: Leaving,
        span: Span,
    ) -> LocalId {
        let inner = self.frames[depth + 1..].iter().find(|frame| frame.is_loop());
        let behind = inner.into_iter().flat_map(|frame| &frame.behind);
        let known = self.frames[depth].mark.or_else(|| {
            let mut same = behind.filter(|it| it.left == depth && it.leaving == leaving);
            same.next().map(|behind| behind.flag)
        });
        let flag = known.unwrap_or_else(|| {
            let label = named.unwrap_or_else(|| words::LOOP.into());
            let role = match leaving {
                Leaving::Break => words::DONE,
                Leaving::Continue => words::NEXT,
            };
            self.local(format!("{label}_{role}"), Type::BOOL, span)
        });
        for frame in &mut self.frames[depth + 1..] {
            if frame.is_loop() && !frame.behind.iter().any(|behind| behind.flag == flag) {
                frame.behind.push(Behind { flag, left: depth, leaving });
            }
        }
        flag
    }
}

/// The statements of a loop before the one `break` that it begins with: they stand behind it as well.
fn last_breath(body: &mut Block) -> Vec<Stmt> {
    let Some((head, rest)) = body.0.split_first_mut() else { return Vec::new() };
    match &mut head.kind {
        StmtKind::If { then, .. } if !rest.iter().any(breaks_in) => match then.0.last() {
            Some(Stmt { kind: StmtKind::Break, .. }) => then.0.drain(..then.0.len() - 1).collect(),
            Some(Stmt { kind: StmtKind::Return(_), span, .. }) => {
                let only = Block::of(StmtKind::Break, *span);
                std::mem::replace(then, only).0
            }
            _ => Vec::new(),
        },
        _ => Vec::new(),
    }
}

/// A loop that the `if … { break; }` at `head` of its body leaves.
fn left_at<'a>(body: &'a [Stmt], head: usize, lead: &'a [Stmt]) -> Option<Loop<'a>> {
    let StmtKind::If { condition, then, otherwise } = &body.get(head)?.kind else { return None };
    let leaves = matches!(then.0.last()?.kind, StmtKind::Break | StmtKind::Return(_));
    (leaves && otherwise.0.is_empty()).then(|| Loop {
        before: &body[..head],
        condition,
        truth: false,
        rest: &body[head + 1..],
        lead,
    })
}

fn no_end() -> termination::Reason {
    "no `if … { break; }` stands in it by itself".into()
}

/// What has to hold one after the other for a condition to hold.
fn conjuncts(condition: &tree::Expr) -> Vec<&tree::Expr> {
    match &condition.kind {
        tree::ExprKind::Binary(tree::BinaryOp::LogicAnd, left, right) => {
            [conjuncts(left), conjuncts(right)].concat()
        }
        _ => vec![condition],
    }
}

/// Whether an expression is a variable or a part of one, so that to name it does nothing.
fn is_named(expr: &tree::Expr) -> bool {
    match &expr.kind {
        tree::ExprKind::Local(_) => true,
        tree::ExprKind::Field(base, _) | tree::ExprKind::Deref(base) => is_named(base),
        _ => false,
    }
}

/// The check that a pass may begin.
fn begun(pass: LocalId, bound: &Expr, span: Span) -> StmtKind {
    let pass = Expr::local(pass, &bound.ty, span);
    let condition = Expr::compare(CompareOp::Lt, pass, bound.clone());
    StmtKind::Check { condition, fault: Fault::Bound }
}

/// The passes of a loop with a bound; `over`: one more begins, for its check to tell.
fn passes(variable: LocalId, bound: Expr, over: bool, body: Block) -> StmtKind {
    let (from, to) = (Expr::literal_like(0, &bound), bound);
    let (inclusive, reversed, unroll, ended) = (over, false, None, false);
    StmtKind::For { variable, from, to, inclusive, reversed, unroll, ended, body }
}

/// Whether something in the body of a loop ends it.
fn breaks(body: &Block) -> bool {
    body.0.iter().any(breaks_in)
}

pub(super) fn breaks_in(stmt: &Stmt) -> bool {
    matches!(stmt.kind, StmtKind::Break) || labelled::branches(stmt).any(breaks)
}
