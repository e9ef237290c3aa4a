//! Statements, except loops and calls.

use bessemer_ir::visit::Walk;
use bessemer_ir::{
    Arm, Block, CompareOp, ConstId, Expr as Ir, ExprKind, Fault, Int, LocalId, Mode, Place, Role,
    Scalar, Stmt as IrStmt, StmtKind as IrKind, Type,
};

use super::super::literal::{self, Readers};
use super::super::tree::{Expr, Init, Stmt, StmtKind, SwitchArm, plain};
use super::Lower;
use super::fill::{length, rewritten, spared, unwritten};
use super::word::truth_of;
use crate::filled::filled;
use crate::passes::reached;
use crate::uncopied::is_table;
use bessemer_ir::effects::{calls, whole};

/// Largest number of elements for which an initialiser is shorter than a loop over the rest.
const SHORT: u32 = 16;

impl Lower<'_> {
    /// Lowers the statements of a block into the current one; `tail` is true if the function ends after them.
    pub(super) fn block_into(&mut self, block: &Block, tail: bool) {
        let mut joined = 0;
        for (index, stmt) in block.0.iter().enumerate() {
            if index < joined {
                continue;
            }
            if !stmt.comments.is_empty() {
                self.origin = None;
                self.emit(StmtKind::Comment(stmt.comments.clone()));
            }
            joined = index + self.join(&block.0[index..]);
            if index < joined {
                continue;
            }
            self.at(stmt.span);
            match &stmt.kind {
                IrKind::Let { local, value: Some(value) }
                    if matches!(value.kind, ExprKind::Splat(_)) =>
                {
                    self.let_filled(*local, value, &block.0[index + 1..]);
                }
                IrKind::Let { local, value: Some(value) }
                    if self.is_idle(value)
                        && rewritten(
                            self.context.module,
                            *local,
                            &value.ty,
                            &block.0[index + 1..],
                        ) =>
                {
                    self.let_(*local, None);
                }
                IrKind::Let { local, value: Some(value) }
                    if self.is_copied(*local, value)
                        && filled(
                            self.context.module,
                            *local,
                            &value.ty,
                            &block.0[index + 1..],
                        ) =>
                {
                    self.let_(*local, None);
                }
                _ => {
                    self.spared = self.spared(&stmt.kind, &block.0[index + 1..]);
                    self.stmt(stmt, tail && index + 1 == block.0.len());
                    self.spared.clear();
                }
            }
            // Behind a check that always fails nothing runs, and compilers warn of the operation that it is for.
            if self.out.last().is_some_and(leaves) {
                break;
            }
        }
    }

    /// Returns the fields of the variable that a statement sets which later statements write before they are read.
    fn spared(&self, stmt: &IrKind, rest: &[IrStmt]) -> Vec<usize> {
        let (local, value) = match stmt {
            IrKind::Let { local, value: Some(value) } => (*local, value),
            IrKind::Assign { place, value } if place.steps.is_empty() => (place.root, value),
            _ => return Vec::new(),
        };
        // The caller may see a parameter after a fault.
        match local.0 < self.function.params {
            true => Vec::new(),
            false => spared(self.context.module, local, value, rest),
        }
    }

    /// Appends the statements of a block, whose declarations stay in it.
    fn emit_block(&mut self, body: Vec<Stmt>) {
        match body.iter().any(|stmt| matches!(stmt.kind, StmtKind::Declare(..))) {
            true => self.emit(StmtKind::Block(body)),
            false => self.out.extend(body),
        }
    }

    fn stmt(&mut self, stmt: &IrStmt, tail: bool) {
        match &stmt.kind {
            IrKind::Let { local, value } => self.let_(*local, value.as_ref()),
            IrKind::Assign { place, value } => self.assignment(place, value),
            IrKind::Expr(value) => self.effect(value),
            IrKind::If { condition, then, otherwise } => {
                let condition = self.word(condition);
                if let Some(truth) = truth_of(&condition) {
                    let taken = self.block(if truth { then } else { otherwise }, tail);
                    return self.emit_block(taken);
                }
                let origin = self.origin;
                let then = self.block(then, tail);
                let otherwise = self.block(otherwise, tail);
                self.origin = origin;
                self.emit(StmtKind::If { condition, then, otherwise });
            }
            IrKind::Match { scrutinee, arms, otherwise } => {
                self.match_(scrutinee, arms, otherwise.as_ref(), tail);
            }
            IrKind::For { ended: true, body, .. } => self.while_(body),
            IrKind::For { variable, from, to, inclusive, reversed, unroll, body, .. } => {
                self.unroll = *unroll;
                self.for_(*variable, (from, to), *inclusive, *reversed, body);
                self.unroll = None;
            }
            IrKind::Check { condition, fault } => self.check(condition, *fault),
            IrKind::Return(value) => self.return_(value.as_ref(), tail),
            IrKind::Break => self.emit(StmtKind::Break),
            IrKind::Continue => self.emit(StmtKind::Continue),
        }
    }

    /// Declares a local of equal values, some of which later statements overwrite before they are read.
    fn let_filled(&mut self, local: LocalId, value: &Ir, rest: &[IrStmt]) {
        let (module, ty) = (self.context.module, &self.function.local(local).ty);
        if filled(module, local, ty, rest) {
            return self.let_(local, None);
        }
        let gaps = unwritten(module, local, ty, rest);
        let ExprKind::Splat(item) = &value.kind else { return };
        let literal = matches!(item.kind, ExprKind::Literal(_));
        if gaps.is_empty() {
            return self.let_(local, None);
        }
        let [(from, to)] = gaps[..] else { return self.let_(local, Some(value)) };
        // An initialiser says less for what is short, or mostly not written.
        if !literal || to - from > length(ty) / 2 || length(ty) <= SHORT {
            return self.let_(local, Some(value));
        }
        self.let_(local, None);
        let place = self.place(&whole(local));
        self.count_from("i", from, to, |lower, index| lower.store(place.at(index), None, item));
    }

    /// Returns true if a local begins as a copy of an array or a matrix.
    fn is_copied(&self, local: LocalId, value: &Ir) -> bool {
        let is_name = self.names.contains_key(&local) || self.part_of_result(local).is_some();
        matches!(value.ty, Type::Array { .. } | Type::Matrix { .. })
            && matches!(value.kind, ExprKind::Load(_))
            && self.function.local(local).mode == Mode::Value
            && !is_name
    }

    /// Returns true if a value need not be computed: it reads no place, and calls at most a pure function that others
    /// may call.
    fn is_idle(&self, value: &Ir) -> bool {
        let functions = &self.context.module.functions;
        let called = match &value.kind {
            ExprKind::Call(id, _) => Some(*id),
            _ if value.any_expr(|expr| matches!(expr.kind, ExprKind::Call(..))) => return false,
            _ => None,
        };
        let outside = |at: &usize| functions[*at].attributes.external.is_some();
        let known = called.is_none_or(|id| {
            functions[id.index()].role == Role::Public
                && !self.context.faults.fallible(id)
                && !reached(self.context.module, id.index()).iter().any(outside)
        });
        known && !value.any_place(|_, _| true)
    }

    fn let_(&mut self, local: LocalId, value: Option<&Ir>) {
        let ty = self.function.local(local).ty.clone();
        if self.in_place == Some(local) {
            self.let_in_place(local, value);
            return;
        }
        if let Some(part) = self.part_of_result(local) {
            value.into_iter().for_each(|value| self.store(part.clone(), None, value));
            return;
        }
        if let Some(Ir { kind: ExprKind::Load(place), .. }) = value {
            let lent = self.function.local(local).mode == Mode::RefMut;
            if lent || self.names.contains_key(&local) {
                self.name_part(local, place, !lent);
                return;
            }
        }
        let constant = value.is_some() && !self.usage.assigned[local.index()];
        let sizes = self.sizes.remove(&local).unwrap_or_default();
        if let Some((routine, operand)) = value.and_then(|value| self.is_reduced(value)) {
            let name = self.bind(local);
            self.reduce(routine, &operand, &name);
            return;
        }
        match value {
            _ if self.counters[local.index()].is_some() => {
                let value = value.map(|value| Init::Value(self.size(value)));
                let name = self.bind(local);
                self.declare(&Type::Scalar(Scalar::Int(Int::U32)), &name, value, false);
            }
            None => {
                let name = self.bind(local);
                self.begin(&ty, &name, &sizes);
            }
            Some(value) if ty.is_word() && !self.is_status_call(value) => {
                let narrow = constant && !self.wide[local.index()];
                match self.range(value).filter(|_| narrow) {
                    Some(range) => self.let_narrow(local, value, range),
                    None => {
                        let value = self.given(value);
                        let name = self.bind(local);
                        self.declare(&ty, &name, Some(Init::Value(value)), constant);
                    }
                }
            }
            // A constant that is not written to needs no copy.
            Some(Ir { kind: ExprKind::Const(id), .. }) if constant => {
                let name = self.constant(*id).to_owned();
                let binding = super::Binding { name, pointer: false, constant: Some(*id) };
                self.bindings[local.index()] = Some(binding);
                return;
            }
            Some(value) if constant && is_table(self.context.module, value) => {
                let name = self.bind(local);
                self.declare_table(&ty, &name, value);
            }
            Some(value) if self.is_read_by_its_tag(local, value) => {
                let name = self.bind(local);
                self.declare(&ty, &name, None, false);
                self.store(Expr::name(name), None, value);
            }
            Some(value) => {
                let name = self.bind(local);
                self.define_sized(&ty, &name, &sizes, value, constant);
            }
        }
        if !self.usage.read[local.index()] && ty != Type::Unit {
            let name = self.bindings[local.index()].as_ref().expect("just bound").name.clone();
            self.emit(StmtKind::Expr(Expr::cast("void", Expr::name(name))));
        }
    }

    /// Declares a size that is not assigned again, in 32 bits.
    fn let_narrow(&mut self, local: LocalId, value: &Ir, range: (i128, i128)) {
        let value = self.size(value);
        let name = self.bind(local);
        self.counters[local.index()] = Some(range);
        self.declare(&Type::Scalar(Scalar::Int(Int::U32)), &name, Some(Init::Value(value)), true);
    }

    /// Declares a name for a part of borrowed or read-only memory: `double *const gain = &work[36];`.
    fn name_part(&mut self, local: LocalId, place: &Place, read_only: bool) {
        let part = self.place(place);
        let name = self.bind(local);
        let array = place.ty.is_array();
        let mut declarator = self.context.names.pointer(&place.ty, &name);
        if read_only {
            declarator.ty.insert_str(0, "const ");
        }
        self.include_type(&place.ty);
        self.emit(StmtKind::Declare(
            declarator,
            Some(Init::Value(Lower::address(part, &place.ty))),
        ));
        self.bindings[local.index()] = Some(super::Binding::new(name, !array));
    }

    /// Initialises the local that is the result, in the caller's memory.
    pub(super) fn let_in_place(&mut self, local: LocalId, value: Option<&Ir>) {
        let name = self.signature.params[self.function.params as usize].name.clone();
        let dest = self.result_storage().expect("only aggregates are built in place");
        self.bindings[local.index()] =
            Some(super::Binding::new(name, matches!(dest, Expr::Unary(..))));
        if let Some(value) = value {
            self.store(dest, None, value);
        }
    }

    /// Declares `name` with a value, by an initialiser if C has one for it.
    pub(super) fn define(&mut self, ty: &Type, name: &str, value: &Ir, constant: bool) {
        self.define_sized(ty, name, &[], value, constant);
    }

    fn define_sized(
        &mut self,
        ty: &Type,
        name: &str,
        sizes: &[Option<ConstId>],
        value: &Ir,
        constant: bool,
    ) {
        if *ty == Type::Unit {
            self.effect(value);
            return;
        }
        if ty.is_word() && !self.is_status_call(value) {
            let value = self.given(value);
            self.declare(ty, name, Some(Init::Value(value)), constant);
        } else if self.initialisable(value) {
            let init = self.initialiser(value);
            self.declare_sized(ty, name, sizes, Some(init), constant);
        } else {
            match value.kind {
                // Copied whole.
                ExprKind::Load(_) | ExprKind::Const(_) => {
                    self.declare_sized(ty, name, sizes, None, false);
                }
                _ => self.begin(ty, name, sizes),
            }
            self.store(Expr::name(name), None, value);
        }
    }

    /// Returns true for the result of a call with a union, which is read part by part. So nothing copies the bytes that the
    /// callee does not write.
    fn is_read_by_its_tag(&self, local: LocalId, value: &Ir) -> bool {
        let Type::Struct(id) = &value.ty else { return false };
        let item = &self.context.module.structs[id.index()];
        let is_flat = || !item.fields.iter().any(|field| self.has_union(&field.ty));
        let called = matches!(value.kind, ExprKind::Call(..));
        called && item.overlaid() && !self.usage.whole[local.index()] && is_flat()
    }

    fn is_status_call(&self, value: &Ir) -> bool {
        matches!(&value.kind, ExprKind::Call(callee, _) if self.context.faults.fallible(*callee))
    }

    fn assignment(&mut self, place: &Place, value: &Ir) {
        if place.ty == Type::Unit {
            self.effect(value);
            return;
        }
        if let ExprKind::Call(callee, arguments) = &value.kind {
            self.call_into_place(*callee, arguments, place);
            return;
        }
        let root = place.root.index();
        let mentioned = self.mentioned[root];
        let dest = self.place(place);
        let is_local = is_own(&dest);
        if self.counter(place).is_some() {
            let value = self.size(value);
            self.assign(dest, value);
        } else {
            self.store(dest, Some(place), value);
        }
        if is_local {
            // A C compiler does not count a store as a use, nor one to a part.
            self.mentioned[root] = mentioned;
        }
    }

    fn check(&mut self, condition: &Ir, fault: Fault) {
        let then = self.scope(|lower| match fault {
            Fault::LeftOut => {
                lower.uses.system.insert("stdlib.h");
                lower.emit(StmtKind::Expr(Expr::call("abort", Vec::new())));
            }
            _ => lower.fail(Expr::name(lower.context.names.status.fault(fault))),
        });
        match condition.kind {
            ExprKind::Literal(0) => self.out.extend(then),
            ExprKind::Literal(_) => {}
            _ => {
                let condition = self.negated(condition);
                match &condition {
                    Expr::Name(name) if name == "false" => {}
                    Expr::Name(name) if name == "true" => self.out.extend(then),
                    _ => self.emit(StmtKind::If { condition, then, otherwise: Vec::new() }),
                }
            }
        }
    }

    /// Ends the function with a status other than OK.
    pub(super) fn fail(&mut self, status: Expr) {
        let names = &self.context.names.status;
        if let Some(hook) = &names.hook {
            self.uses.headers.insert(names.header.clone());
            self.emit(StmtKind::Expr(Expr::call(hook, vec![status])));
            self.emit(StmtKind::Forever);
            return;
        }
        match self.latch.clone() {
            None => self.emit(StmtKind::Return(Some(status))),
            Some(latch) => {
                self.emit(StmtKind::Assign(latch, "=", status.clone()));
                self.emit(StmtKind::Return(Some(status)));
            }
        }
    }

    fn return_(&mut self, value: Option<&Ir>, tail: bool) {
        match (value, self.result_storage()) {
            (Some(_), Some(_)) if self.in_place.is_some() => {}
            (Some(value), Some(dest)) => self.store(dest, None, value),
            (Some(value), None) if value.ty.is_word() => {
                let value = self.given(value);
                self.emit(StmtKind::Return(Some(value)));
                return;
            }
            (Some(value), None) => self.effect(value),
            (None, _) => {}
        }
        if self.is_fallible() {
            self.emit_ok();
        } else if !tail {
            self.emit(StmtKind::Return(None));
        }
    }

    fn match_(&mut self, scrutinee: &Ir, arms: &[Arm], otherwise: Option<&Block>, tail: bool) {
        let chosen = self.chosen(&scrutinee.ty);
        if let ([Arm { values, body }], Some(otherwise)) = (arms, otherwise)
            && let [value] = values[..]
            && chosen != Some(value)
        {
            self.match_as_if(scrutinee, value, [body, otherwise], tail);
            return;
        }
        // Of one way there is nothing to choose.
        if let ([Arm { body, .. }], None, false) = (arms, otherwise, calls(scrutinee)) {
            let body = self.block(body, tail);
            self.emit(StmtKind::Block(body));
            return;
        }
        let blocks: Vec<&Block> = arms.iter().map(|arm| &arm.body).chain(otherwise).collect();
        if blocks.iter().any(|block| breaks(block)) {
            self.match_as_ifs(scrutinee, arms, otherwise, tail);
            return;
        }
        let value = self.word(scrutinee);
        let origin = self.origin;
        let mut list: Vec<SwitchArm> = Vec::new();
        for (index, arm) in arms.iter().enumerate() {
            let labels = arm.values.iter().map(|value| self.label(&scrutinee.ty, *value)).collect();
            // If the arms name every variant, the last arm also takes invalid values.
            let default = otherwise.is_none() && index + 1 == arms.len();
            list.push(SwitchArm { labels, default, body: self.block(&arm.body, tail) });
        }
        if let Some(block) = otherwise {
            let body = self.block(block, tail);
            list.push(SwitchArm { labels: Vec::new(), default: true, body });
        }
        self.origin = origin;
        self.emit(StmtKind::Switch { scrutinee: value, arms: list });
    }

    /// Lowers a `match` on one value and all others to an `if`.
    fn match_as_if(&mut self, scrutinee: &Ir, value: i128, arms: [&Block; 2], tail: bool) {
        let label = Ir::literal(value as u64, scrutinee.ty.clone(), scrutinee.span);
        let decided = self.decided(CompareOp::Eq, scrutinee, &label);
        let (origin, test) = (self.origin, decided.is_none().then(|| self.word(scrutinee)));
        let [then, otherwise] = arms.map(|block| self.block(block, tail));
        let value = self.label(&scrutinee.ty, value);
        self.origin = origin;
        let turned = then.is_empty() && !otherwise.is_empty();
        let condition = match test {
            Some(test) => {
                let test = self.comparable(test);
                Expr::binary(if turned { "!=" } else { "==" }, test, value)
            }
            None => Expr::name(if decided == Some(!turned) { "true" } else { "false" }),
        };
        let (then, otherwise) = if turned { (otherwise, Vec::new()) } else { (then, otherwise) };
        self.emit(StmtKind::If { condition, then, otherwise });
    }

    /// Lowers a `match` in which an arm leaves a loop to `if`s, since `break` in a `switch` leaves the `switch`.
    fn match_as_ifs(
        &mut self,
        scrutinee: &Ir,
        arms: &[Arm],
        otherwise: Option<&Block>,
        tail: bool,
    ) {
        let origin = self.origin;
        let mut value = self.word(scrutinee);
        if !is_simple(&value) || self.is_assigned(scrutinee) {
            let name = self.fresh("selector");
            self.declare(&scrutinee.ty, &name, Some(Init::Value(value)), true);
            value = Expr::name(name);
        }
        let mut cases: Vec<(Vec<i128>, &Block)> =
            arms.iter().map(|arm| (arm.values.clone(), &arm.body)).collect();
        cases.extend(otherwise.map(|block| (self.left(&scrutinee.ty, arms), block)));
        // The last takes invalid values.
        let chosen = self.chosen(&scrutinee.ty);
        let is_chosen =
            |(values, _): &(Vec<i128>, &Block)| chosen.is_some_and(|it| values.contains(&it));
        if let Some(at) = cases.iter().position(is_chosen) {
            cases[at..].rotate_left(1);
        }
        let mut chain: Vec<Stmt> = Vec::new();
        for (index, (values, body)) in cases.iter().enumerate().rev() {
            let body = self.block(body, tail);
            let tests = values
                .iter()
                .map(|label| Expr::binary("==", value.clone(), self.label(&scrutinee.ty, *label)));
            match tests.reduce(|a, b| Expr::binary("||", a, b)) {
                _ if index + 1 == cases.len() => chain = body,
                Some(condition) => {
                    chain = vec![plain(StmtKind::If { condition, then: body, otherwise: chain })];
                }
                // No variant is left for it.
                None => {}
            }
        }
        match <[Stmt; 1]>::try_from(chain) {
            Ok([stmt]) => self.out.push(Stmt { origin, ..stmt }),
            Err(body) => self.emit(StmtKind::Block(body)),
        }
    }

    /// Returns the variants that no arm names.
    fn left(&self, ty: &Type, arms: &[Arm]) -> Vec<i128> {
        let Type::Enum(id) = ty else { return Vec::new() };
        let count = self.context.module.enums[id.index()].variants.len() as i128;
        (0..count).filter(|value| !arms.iter().any(|arm| arm.values.contains(value))).collect()
    }

    /// Returns true if the value could change while the arms are tested or run.
    fn is_assigned(&self, expr: &Ir) -> bool {
        match &expr.kind {
            ExprKind::Load(place) => self.usage.assigned[place.root.index()],
            _ => true,
        }
    }

    fn label(&self, ty: &Type, value: i128) -> Expr {
        literal::word(self.context.names, ty, value as u64, Readers::C)
    }
}

/// Returns true if reading a value again has no cost and no effect.
pub(super) fn is_simple(value: &Expr) -> bool {
    match value {
        Expr::Name(_) => true,
        Expr::Unary("-" | "*", inner) => is_simple(inner),
        Expr::Member(inner, _) | Expr::Arrow(inner, _) => is_simple(inner),
        Expr::Index(array, index) => is_simple(array) && matches!(**index, Expr::Name(_)),
        _ => false,
    }
}

/// Returns true if control never reaches the end of a statement.
pub(super) fn leaves(stmt: &Stmt) -> bool {
    let ends = |block: &Vec<Stmt>| block.last().is_some_and(leaves);
    match &stmt.kind {
        StmtKind::Return(_) | StmtKind::Forever => true,
        StmtKind::Block(body) => ends(body),
        StmtKind::If { then, otherwise, .. } => ends(then) && ends(otherwise),
        _ => false,
    }
}

/// Returns true if a block leaves its enclosing loop.
fn breaks(block: &Block) -> bool {
    block.0.iter().any(|stmt| match &stmt.kind {
        IrKind::Break => true,
        IrKind::If { then, otherwise, .. } => breaks(then) || breaks(otherwise),
        IrKind::Match { arms, otherwise, .. } => {
            arms.iter().any(|arm| breaks(&arm.body)) || otherwise.as_ref().is_some_and(breaks)
        }
        _ => false,
    })
}

/// Returns true if a place is in the memory of a variable itself, behind no pointer. An index counts only behind a field:
/// the name of an array may be that of a pointer.
pub(super) fn is_own(place: &Expr) -> bool {
    match place {
        Expr::Name(_) => true,
        Expr::Member(of, _) => is_own(of),
        Expr::Index(of, _) => matches!(**of, Expr::Member(..) | Expr::Index(..)) && is_own(of),
        _ => false,
    }
}
