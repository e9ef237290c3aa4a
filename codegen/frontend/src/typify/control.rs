//! Lowers control flow: statements, and values computed by control flow.

use bessemer_ir::tree::{self, Builtin, ExprKind as Tree, OptionMethod, Site};
use bessemer_ir::{Block, Expr, ExprKind, Fault, Mode, Place, Span, StmtKind, Type};

use super::conditions::{decided, has_let};
use super::each::Each;
use super::expand::is_ours;
use super::expr::Call;
use super::frames::{Leaving, Target};
use super::lowering::{Lowering, RESULT};
use super::syntax::{control_with_value, either, ends_in_loop, names_by_case};
use super::value::Value;
use super::words;
use super::{Needed, Result, refusals, refused};
use crate::standard;
use bessemer_ir::effects;

impl Lowering<'_, '_> {
    /// Lowers `expr` and assigns its value to `target`.
    pub(super) fn lower_into(&mut self, expr: &tree::Expr, target: &Target) -> Result<()> {
        self.lowered(expr, Some(target))
    }

    /// Lowers `expr` for its effects only.
    pub(super) fn effect(&mut self, expr: &tree::Expr) -> Result<()> {
        self.lowered(expr, None)
    }

    /// Lowers `expr`, and assigns its value to `target` if there is one.
    pub(super) fn lowered(&mut self, expr: &tree::Expr, target: Option<&Target>) -> Result<()> {
        if let Some(other) = self.in_place(expr) {
            return self.lowered(&other, target);
        }
        if let Some(expansion) = self.expansion(expr) {
            if standard::is_comparison(expansion.0) || standard::is_len(expansion.0) {
                return match target {
                    Some(target) => self.store(expr, target),
                    None => self.value(expr, None).map(drop),
                };
            }
            return self.expanded(expansion, expr.site, |inner, tail| {
                tail.map_or(Ok(()), |tail| inner.lowered(tail, target))
            });
        }
        if target.is_none() {
            // The file of a statement is listed before those of what it calls.
            self.span(expr.site);
        }
        match (&expr.kind, target) {
            (Tree::Apply(name, arguments), Some(_)) if self.stands_here(expr) => {
                self.applied(name, arguments, expr.site, |inner, closure| {
                    inner.lowered(&closure.body, target)
                })
            }
            (Tree::If(condition, then, otherwise), _)
                if target.is_none() || otherwise.is_some() =>
            {
                self.if_stmt(expr.site, condition, then, otherwise.as_deref(), target)
            }
            (Tree::Match(scrutinee, arms), _) if target.is_none() || control_with_value(expr) => {
                self.match_stmt(expr.site, scrutinee, arms, target)
            }
            (Tree::Block(block), _) => self.run(block, target),
            (Tree::Labelled(label, body), _) => self.labelled(label, body, target, expr),
            (Tree::While { label, condition, bound, body }, _) => {
                let asked = (condition.as_deref(), bound.as_deref());
                self.while_stmt(expr.site, label.as_deref(), asked, body, target)
            }
            (Tree::Return(_) | Tree::Break(..) | Tree::Continue(_) | Tree::Assert(..), _)
            | (_, None) => self.statement(expr),
            (_, Some(target)) => self.store(expr, target),
        }
    }

    /// Lowers `if`; if the instance decides the condition, only the branch that is taken.
    fn if_stmt(
        &mut self,
        site: Site,
        condition: &tree::Expr,
        then: &tree::Block,
        otherwise: Option<&tree::Expr>,
        target: Option<&Target>,
    ) -> Result<()> {
        let span = self.span(site);
        if let Tree::Let(pattern, value) = &condition.kind
            && names_by_case(pattern)
        {
            let arms = either(pattern, then, otherwise, condition.site);
            return self.match_stmt(site, value, &arms, target);
        }
        if has_let(condition) {
            // The names of its patterns are known in the branch alone.
            let (condition, then) = self.naming_scope(|inner| {
                let mut names = Vec::new();
                let condition = inner.pattern_condition(condition, &mut names)?;
                let then = inner.scoped(|inner| {
                    inner.bind_names(&names)?;
                    inner.run(then, target)
                })?;
                Ok((condition, then))
            })?;
            let otherwise = self.otherwise(otherwise, target)?;
            self.branch(condition, then, otherwise, span);
            return Ok(());
        }
        let condition = self.asked(condition)?;
        if let Some(holds) = self.decided(&condition) {
            return match (holds, otherwise) {
                (true, _) => self.run(then, target),
                (false, Some(otherwise)) => self.lowered(otherwise, target),
                (false, None) => Ok(()),
            };
        }
        let then = self.block(then, target)?;
        let otherwise = self.otherwise(otherwise, target)?;
        // Assignments of zero-sized values are erased, so both branches may be empty.
        match target.is_none() && then.0.is_empty() && otherwise.0.is_empty() {
            true => self.evaluated(condition),
            false => self.emit(StmtKind::If { condition, then, otherwise }, span),
        }
        Ok(())
    }

    fn is_unwrap(&self, callee: u32) -> bool {
        self.builtin_of(callee) == Some(Builtin::Option(OptionMethod::Unwrap))
    }

    /// Lowers `operand?`: returns early with `None` or the error, else continues with the payload; none if that is
    /// zero-sized.
    pub(super) fn try_value(
        &mut self,
        label: Option<&str>,
        operand: &tree::Expr,
        site: Site,
    ) -> Result<Option<Expr>> {
        let span = self.span(site);
        let place = self.held(operand)?;
        let target = self.left_by(label, site)?;
        let (Type::Struct(id), Type::Struct(result)) = (place.ty.clone(), self.wanted(&target))
        else {
            return refused(site, refusals::TRIED);
        };
        let (there, value) =
            self.present(&place, false).needed(site, "`?` takes an `Option` or a `Result`")?;
        let error = self.present(&place, true);
        let left = if error.is_some() { "Err" } else { "None" };
        let (word, case) =
            self.case(result, left).needed(site, "this does not fit the result of the function")?;
        let payload = error.and_then(|(_, from)| from).map(|from| from.load());
        let wanted = case.field.map(|field| self.cx.field_type(result, field));
        let then = self.scoped(|inner| {
            let payload = inner.converted_error(payload, wanted.as_ref(), (id, result), site)?;
            let leave = inner.choice(result, word, payload, site)?;
            inner.send(leave, &target, span);
            match target {
                Target::Return => Ok(()),
                Target::Place(_) => inner.leave(label, Leaving::Break, site),
            }
        })?;
        self.emit_if(there.negated(), then, span);
        Ok(value.map(|value| value.load()))
    }

    /// Returns the type of a target.
    fn wanted(&self, target: &Target) -> Type {
        match target {
            Target::Place(place) => place.ty.clone(),
            Target::Return => self.result.clone(),
        }
    }

    /// Declares a local that control flow then assigns on every path.
    pub(super) fn decided_by(
        &mut self,
        name: String,
        ty: Type,
        value: Option<&tree::Expr>,
        span: Span,
    ) -> Result<Place> {
        let local = self.local(name, ty.clone(), span);
        let first = value.and_then(|value| self.before_loop(value, &ty, span));
        self.emit(StmtKind::Let { local, value: first }, span);
        let place = Place::local(local, ty, span);
        value.map_or(Ok(()), |value| self.lower_into(value, &Target::Place(place.clone())))?;
        Ok(place)
    }

    /// Returns an initial value for a local that a loop assigns, since C compilers cannot see that the loop runs.
    fn before_loop(&self, value: &tree::Expr, ty: &Type, span: Span) -> Option<Expr> {
        (ends_in_loop(value) && *ty != Type::Unit).then(|| self.zero(ty, span))
    }

    fn send(&mut self, value: Expr, target: &Target, span: Span) {
        let kind = match target {
            Target::Place(place) => StmtKind::Assign { place: place.clone(), value },
            Target::Return => StmtKind::Return(Some(value)),
        };
        self.emit(kind, span);
    }

    fn store(&mut self, expr: &tree::Expr, target: &Target) -> Result<()> {
        let ty = self.wanted(target);
        let value = self.value(expr, Some(&ty))?;
        self.agree(&value.ty, &ty, expr.site)?;
        if let (Target::Place(place), ExprKind::Load(same)) = (target, &value.kind)
            && place.root == same.root
            && place.steps.is_empty()
            && same.steps.is_empty()
        {
            // `|mut sum, x| { sum += x; sum }`.
            return Ok(());
        }
        let span = value.span;
        self.send(value, target, span);
        Ok(())
    }

    /// Lowers a block, and assigns its value to `target` if there is one.
    pub(super) fn block(&mut self, block: &tree::Block, target: Option<&Target>) -> Result<Block> {
        self.scoped(|inner| {
            inner.stmts(block)?;
            match &block.tail {
                Some(tail) => inner.lowered(tail, target),
                // Nothing is wanted, or every path has left: `return`, `break` or `continue`.
                None => Ok(()),
            }
        })
    }

    /// Lowers a block into the current one.
    fn run(&mut self, block: &tree::Block, target: Option<&Target>) -> Result<()> {
        let Block(stmts) = self.block(block, target)?;
        self.out.extend(stmts);
        Ok(())
    }

    /// Lowers the `else` branch, which is empty if there is none.
    fn otherwise(
        &mut self,
        otherwise: Option<&tree::Expr>,
        target: Option<&Target>,
    ) -> Result<Block> {
        self.scoped(|inner| otherwise.map_or(Ok(()), |it| inner.lowered(it, target)))
    }

    /// Lowers an expression for its effect, unless it is control flow with a value.
    fn statement(&mut self, expr: &tree::Expr) -> Result<()> {
        let span = self.span(expr.site);
        match &expr.kind {
            Tree::Assign(op, place, value) => self.assign(*op, place, value, expr.site),
            Tree::Each { label, pattern, source, bound, body } => {
                let (site, label, bound) = (expr.site, label.as_deref(), bound.as_deref());
                self.each_stmt(Each { site, label, pattern, source, bound, body })
            }
            Tree::Unroll(count, inner) => {
                let mark = self.out.len();
                self.effect(inner)?;
                // A loop over the elements of a value may stand behind a copy of it.
                let loops = self.out[mark..].iter_mut().rev();
                let mut hints = loops.filter_map(|stmt| match &mut stmt.kind {
                    StmtKind::For { unroll, .. } => Some(unroll),
                    _ => None,
                });
                if let Some(unroll) = hints.next() {
                    *unroll = Some(*count);
                }
                Ok(())
            }
            Tree::Return(value) => self.return_stmt(value.as_deref(), expr.site),
            Tree::Break(label, value) => {
                self.break_stmt(label.as_deref(), value.as_deref(), expr.site)
            }
            Tree::Continue(label) => self.leave(label.as_deref(), Leaving::Continue, expr.site),
            Tree::Assert(condition, claim) => self.assert_stmt(condition, *claim, expr.site),
            Tree::Tuple(parts) if parts.is_empty() => Ok(()),
            Tree::Call(..)
                if self.lent_place(expr)?.is_some()
                    || self.list_effect(expr)?
                    || self.slice_effect(expr)? =>
            {
                Ok(())
            }
            Tree::Call(callee, arguments) if self.is_unwrap(*callee) => {
                self.payload_needed(OptionMethod::Unwrap, Call { arguments, expr }).map(|_| ())
            }
            Tree::Try(label, operand) => {
                self.try_value(label.as_deref(), operand, expr.site).map(|_| ())
            }
            Tree::Apply(name, arguments) => {
                let value = self.apply(name, arguments, expr.site)?;
                if value.ty != Type::Unit {
                    self.emit(StmtKind::Expr(value), span);
                }
                Ok(())
            }
            _ => {
                if self.holds_nothing(expr) {
                    let left = self.done(expr)?;
                    self.discard(left);
                    return Ok(());
                }
                let value = self.value(expr, None)?;
                // What has no value may be done already.
                if value.ty != Type::Unit || !matches!(value.kind, ExprKind::Literal(_)) {
                    self.emit(StmtKind::Expr(value), span);
                }
                Ok(())
            }
        }
    }

    /// Returns the truth of a condition that a const generic of the instance decides, such as `if N == 0`. A literal
    /// argument of an expanded function of the DSL also decides. The C then has only one branch.
    fn decided(&self, condition: &Expr) -> Option<bool> {
        let of_caller = self.source.tree.role == tree::Role::Expanded && is_ours(self.source);
        if self.source.generics.is_empty() && !of_caller {
            return None;
        }
        decided(condition)
    }

    fn return_stmt(&mut self, value: Option<&tree::Expr>, site: Site) -> Result<()> {
        if let Some(value) = value.filter(|_| self.result != Type::Unit) {
            return self.naming_as(RESULT, |inner| inner.lower_into(value, &Target::Return));
        }
        value.map_or(Ok(()), |value| self.effect(value))?;
        let span = self.span(site);
        self.emit(StmtKind::Return(None), span);
        Ok(())
    }

    fn assert_stmt(
        &mut self,
        condition: &tree::Expr,
        claim: tree::Claim,
        site: Site,
    ) -> Result<()> {
        let naming = std::mem::take(&mut self.naming);
        let condition = self.value(condition, Some(&Type::BOOL))?;
        // What an author asserts may do anything, so it is computed first. The library asks for sums at most.
        let condition = match claim {
            tree::Claim::Assertion => self.atom("asserted", condition),
            _ => condition,
        };
        self.naming = naming;
        let span = self.span(site);
        let fault = match claim {
            tree::Claim::Assertion => Fault::Assertion,
            tree::Claim::Index => Fault::Index,
            tree::Claim::Capacity => Fault::Capacity,
            tree::Claim::Clamp => Fault::Clamp,
            tree::Claim::Overflow => Fault::Overflow,
            tree::Claim::DivisionByZero => Fault::DivisionByZero,
            tree::Claim::Shift => Fault::Shift,
        };
        if !self.expanding.is_empty() && self.decided(&condition) == Some(true) {
            return Ok(());
        }
        self.emit(StmtKind::Check { condition, fault }, span);
        Ok(())
    }

    /// Refuses an assignment that makes a reference refer to another place: in the C its name is an alias of one
    /// place.
    pub(super) fn refuse_moved_reference(
        &mut self,
        place: &tree::Expr,
        value: &tree::Expr,
    ) -> Result<()> {
        let Tree::Local(name) = &place.kind else {
            let element = !self.cx.types.borrowed.is_empty()
                && matches!(place.kind, Tree::Field(..) | Tree::Index(..))
                && self.place_type(place).is_ok_and(|ty| self.type_behind(ty.clone()) != ty);
            return if element { refused(place.site, refusals::MOVED_REFERENCE) } else { Ok(()) };
        };
        let refers = match self.lookup(name, place.site)? {
            Value::Place(_) | Value::Slice(_) => true,
            // One that may be written also stands for a variable that a closure writes.
            Value::Local(root) => match self.locals[root.index()].mode {
                Mode::Value => false,
                Mode::Ref => true,
                Mode::RefMut => self.is_reference(value)?,
            },
            _ => false,
        };
        if refers { refused(place.site, refusals::MOVED_REFERENCE) } else { Ok(()) }
    }

    fn is_reference(&self, value: &tree::Expr) -> Result<bool> {
        match (&value.kind, value.slot) {
            (Tree::Ref(..), _) => Ok(true),
            (_, Some(slot)) => self.slot_is_reference(slot, value.site),
            _ => Ok(false),
        }
    }

    /// Lowers `place = value` and `place op= value`.
    fn assign(
        &mut self,
        op: Option<tree::BinaryOp>,
        place: &tree::Expr,
        value: &tree::Expr,
        site: Site,
    ) -> Result<()> {
        if self.is_submatrix(place) {
            // Without a `*` the name is given another view.
            return match (op, &place.kind) {
                (None, Tree::Local(_)) => refused(site, refusals::MOVED_VIEW),
                _ => self.assign_part(op, place, value, site),
            };
        }
        if op.is_none() {
            self.refuse_moved_reference(place, value)?;
        }
        if op.is_none() && self.holds_nothing(place) {
            self.effect(value)?;
            return self.effect(place);
        }
        let other = self.in_place(value);
        let value = other.as_ref().unwrap_or(value);
        let name = self.name_of(place);
        let naming = std::mem::replace(&mut self.naming, name);
        let span = self.span(site);
        match op {
            None if control_with_value(value) || self.stands_here(value) => {
                // Rust computes the value before the place. A place without statements of its own is assigned in each branch.
                let (target, chosen) = self.in_block(|inner| inner.writable(place))?;
                match self.joined(target.load(), chosen.clone(), &mut []) {
                    (Expr { kind: ExprKind::Load(target), .. }, left)
                        if left.is_empty() && !effects::calls(&target.load()) =>
                    {
                        self.lower_into(value, &Target::Place(target))?;
                    }
                    _ => {
                        let value = self.value(value, Some(&target.ty))?;
                        self.out.extend(chosen);
                        self.emit(StmtKind::Assign { place: target, value }, span);
                    }
                }
            }
            None => {
                let ty = self.place_type(place)?;
                let value = self.value(value, Some(&ty))?;
                self.agree(&value.ty, &ty, site)?;
                let value = self.atom(words::OPERAND, value);
                let place = self.writable(place)?;
                self.emit(StmtKind::Assign { place, value }, span);
            }
            Some(_) if let Some(callee) = self.operator(place.slot).cloned() => {
                let place = &self.computed_once(place)?;
                let operands = [place.clone(), value.clone()];
                let ty = self.place_type(place)?;
                let value = self.call_of(&callee, &operands, place)?;
                if value.ty == Type::Unit {
                    // `impl AddAssign` of a type of the author's: it writes the place itself.
                    self.emit(StmtKind::Expr(value), span);
                } else {
                    self.agree(&value.ty, &ty, site)?;
                    let place = self.writable(place)?;
                    self.emit(StmtKind::Assign { place, value }, span);
                }
            }
            Some(op) => {
                let ty = self.place_type(place)?;
                let expected = self.compound_operand(op, &ty);
                let (place, value) = self.compound(place, value, expected, &ty)?;
                let current = place.load();
                let value = self.binary_node(op, current, value, site)?;
                self.agree(&value.ty, &ty, site)?;
                self.emit(StmtKind::Assign { place, value }, span);
            }
        }
        self.naming = naming;
        Ok(())
    }

    /// Returns the place of `place op= value` with its computed indices in temporaries, since Rust evaluates them
    /// once and first.
    fn computed_once(&mut self, place: &tree::Expr) -> Result<tree::Expr> {
        let found = self.writable(place)?;
        self.bind(PLACE, Value::Place(found));
        Ok(tree::Expr { kind: Tree::Local(PLACE.to_owned()), ..place.clone() })
    }

    /// Returns the place and the operand of `place op= value`. Rust evaluates the operand of scalars first, and the
    /// place of matrices first. The statement contains the place twice, but its indices are evaluated once.
    fn compound(
        &mut self,
        place: &tree::Expr,
        value: &tree::Expr,
        expected: Option<Type>,
        ty: &Type,
    ) -> Result<(Place, Expr)> {
        if ty.is_word() {
            let value = self.value(value, expected.as_ref())?;
            let value = self.atom(words::OPERAND, value);
            let mark = self.out.len();
            let place = self.writable(place)?;
            return Ok((self.joined_place(mark, place), value));
        }
        let place = self.writable(place)?;
        let value = self.value(value, expected.as_ref())?;
        Ok((place, value))
    }

    /// Returns the name of a temporary for a value that a place receives: the place's last field, or its variable.
    pub(super) fn name_of(&self, place: &tree::Expr) -> String {
        match &place.kind {
            // What a function that stands here calls its parameter has the author's name.
            Tree::Local(name) if !self.expanding.is_empty() => {
                match self.lookup(name, place.site) {
                    Ok(Value::Place(it)) if it.steps.is_empty() => {
                        self.locals[it.root.index()].name.clone()
                    }
                    _ => name.clone(),
                }
            }
            Tree::Local(name) | Tree::Field(_, name) => name.clone(),
            Tree::Index(base, _) | Tree::Deref(base) | Tree::Ref(_, base) => self.name_of(base),
            _ => words::VALUE.into(),
        }
    }

    /// Returns the place that an assignment writes.
    pub(super) fn writable(&mut self, expr: &tree::Expr) -> Result<Place> {
        self.not_coords(expr)?;
        self.place(expr)?.or_refused(expr.site, refusals::ASSIGNED)
    }
}

/// Name of a place with computed indices during its assignment.
const PLACE: &str = "%place";
