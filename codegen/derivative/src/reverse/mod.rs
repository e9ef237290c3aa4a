//! Gradients in reverse mode: a way forwards that keeps what the slopes need, and a way backwards through the same statements.
//!
//! The way forwards is the function on values without derivatives: calls inlined, short loops unrolled, matrices by elements.
//! Its numbers are locals that are assigned once, except what a loop's passes assign. Backwards each number has a bar: the
//! derivative of the result by it. A number's bar is complete at its declaration, and goes to its operands, times slopes.
//!
//! Invariants:
//!
//! * A loop that stays a loop is one backwards, too. What its passes compute, and slopes need, is in arrays of its length.
//! * A bar that is zero is absent.
//!
//! Must not know: Rust, and parameters that are no variables.

mod active;
mod flat;
mod kernels;
mod length;
mod once;
mod slope;
mod store;

use std::collections::{BTreeMap, BTreeSet};

use bessemer_ir::visit::{self, Access, Visit};
use bessemer_ir::{
    BinaryOp, Block, CompareOp, Expr, ExprKind, LocalId, Place, Routine, Span, Step, Stmt,
    StmtKind, Type, UnaryOp,
};

use crate::expression::literal;
use crate::run::{Env, Run};
use crate::value::{Value, parts};
use crate::{Request, Result, float};
use active::Active;
use flat::Assigned;

/// Bars of words, by local and number of the word.
type Bars = BTreeMap<Key, Expr>;

/// A word: its local, and its number in it.
type Key = (LocalId, usize);

/// Facts of the way forwards that the way backwards uses.
struct Back {
    active: Active,
    /// Bars of locals with unknown indices, by local.
    arrays: BTreeMap<LocalId, Place>,
    /// Variables of which each pass of a loop reads other parts than the others, once.
    once: BTreeSet<LocalId>,
    /// Words with a bar that one pass of a loop hands to the next, as found so far, by the loop's counter.
    carried: BTreeMap<LocalId, BTreeSet<Key>>,
}

impl Run<'_> {
    /// Returns the body of a gradient.
    pub fn gradient(&mut self, request: &Request) -> Result<Block> {
        let module = self.module;
        let of = &module.functions[request.of.index()];
        let into = &module.functions[request.into.index()];
        let span = into.span;
        let mut env = Env { passes: 1, ..Env::default() };
        for (index, parameter) in into.parameters().iter().enumerate() {
            let id = LocalId(index as u32);
            env.locals.insert(id, Value::at(Place::local(id, parameter.ty.clone(), span)));
        }
        self.backwards = true;
        let (forwards, result) = self.captured(|run| {
            let result = run.function(of, env)?.result.unwrap_or(Value::Parts(Vec::new()));
            let Some(mut result) = result.words(module).into_iter().next() else {
                return Ok(None);
            };
            if !matches!(&result.value.kind, ExprKind::Load(place) if place.steps.is_empty()) {
                result.value = run.bind(&of.result_name, result.value);
            }
            Ok(Some(result))
        })?;
        let Some(result) = result else { return Ok(Block::default()) };
        let variables: BTreeSet<LocalId> =
            request.by.iter().map(|index| LocalId(*index as u32)).collect();
        let mut active = Active::of(&forwards, variables.clone());
        let forwards = self.flat(forwards, &mut active)?;
        let active = Active::of(&forwards, variables);
        let once = once::parts(&forwards);
        let (arrays, carried) = (BTreeMap::new(), BTreeMap::new());
        let mut back = Back { active, arrays, once, carried };
        let (backwards, gradients) = self.captured(|run| {
            let mut unknown = Unknown::default();
            unknown.block(&forwards);
            for local in unknown.0.into_iter().filter(|it| back.active.0.contains(it)) {
                let declared = run.locals[local.index()].clone();
                let zero = run.zero(&declared.ty, span);
                let place = run.variable_of(&format!("{}_bar", declared.name), zero);
                back.arrays.insert(local, place);
            }
            let mut bars = Bars::new();
            let one = float(1.0, &result.value.ty, span);
            run.push(&mut back, &mut bars, &result.value, one, None)?;
            run.block_backwards(&mut back, &mut bars, &forwards)?;
            let all = request.by.iter().map(|index| {
                let id = LocalId(*index as u32);
                let parameter = &into.parameters()[*index];
                match back.arrays.get(&id) {
                    Some(place) => place.load(),
                    None => {
                        let leaves = module.leaves(&parameter.ty).into_iter().enumerate();
                        let words = leaves.map(|(word, ty)| {
                            bars.get(&(id, word)).cloned().unwrap_or(float(0.0, &ty, span))
                        });
                        run.aggregate(&parameter.ty, words)
                    }
                }
            });
            Ok(all.collect::<Vec<Expr>>())
        })?;
        let mut body = store::kept(self, forwards, backwards)?;
        let mut fields = vec![result.value];
        fields.extend(gradients);
        let value = Expr { kind: ExprKind::Struct(fields), ty: into.result.clone(), span };
        body.0.push(Stmt::new(StmtKind::Return(Some(value)), span));
        Ok(body)
    }

    /// Returns the zero of a type of floats, integers or booleans.
    fn zero(&self, ty: &Type, span: Span) -> Expr {
        let of = |kind| Expr { kind, ty: ty.clone(), span };
        match ty {
            Type::Matrix { element, .. } => {
                let zero = Expr::literal(0, Type::Scalar(*element), span);
                of(ExprKind::Splat(Box::new(zero)))
            }
            Type::Array { element, .. } => of(ExprKind::Splat(Box::new(self.zero(element, span)))),
            Type::Struct(_) => {
                let parts = parts(self.module, ty, span);
                of(ExprKind::Struct(parts.iter().map(|(_, ty)| self.zero(ty, span)).collect()))
            }
            _ => Expr::literal(0, ty.clone(), span),
        }
    }

    /// Goes back through statements.
    fn block_backwards(&mut self, back: &mut Back, bars: &mut Bars, block: &Block) -> Result<()> {
        // Functions that the way forwards called are not called again.
        for Stmt { kind, .. } in &block.0 {
            if let StmtKind::Let { local, value: Some(value) } = kind
                && let ExprKind::Call(..) = value.kind
                && value.ty.as_float().is_some()
            {
                self.calls.push((value.clone(), Expr::local(*local, &value.ty, value.span)));
            }
        }
        for stmt in block.0.iter().rev() {
            self.stmt_backwards(back, bars, stmt)?;
        }
        Ok(())
    }

    fn stmt_backwards(&mut self, back: &mut Back, bars: &mut Bars, stmt: &Stmt) -> Result<()> {
        let span = stmt.span;
        match &stmt.kind {
            StmtKind::Let { local, value: Some(value) } => {
                if let ExprKind::Call(callee, arguments) = &value.kind
                    && self.function_of(*callee).kernel.is_some()
                {
                    let of = (*callee, arguments.as_slice());
                    return self.kernel_backwards(back, bars, of, Some(*local), span);
                }
                let ty = self.locals[local.index()].ty.clone();
                let place = Place::local(*local, ty, span);
                self.value_backwards(back, bars, &place, value)
            }
            StmtKind::Assign { place, value } => self.value_backwards(back, bars, place, value),
            StmtKind::Expr(Expr { kind: ExprKind::Call(callee, arguments), .. })
                if self.function_of(*callee).kernel.is_some() =>
            {
                self.kernel_backwards(back, bars, (*callee, arguments), None, span)
            }
            StmtKind::If { condition, then, otherwise } => {
                let condition = condition.clone();
                self.sides_backwards(back, bars, &[then, otherwise], span, |mut sides| {
                    let otherwise = sides.pop().unwrap_or_default();
                    let then = sides.pop().unwrap_or_default();
                    StmtKind::If { condition, then, otherwise }
                })
            }
            StmtKind::Match { scrutinee, arms, otherwise } => {
                let mut blocks: Vec<&Block> = arms.iter().map(|arm| &arm.body).collect();
                blocks.extend(otherwise);
                self.sides_backwards(back, bars, &blocks, span, |mut sides| {
                    let otherwise = otherwise.as_ref().and_then(|_| sides.pop());
                    let arms = arms
                        .iter()
                        .zip(sides)
                        .map(|(arm, body)| bessemer_ir::Arm { values: arm.values.clone(), body });
                    let (scrutinee, arms) = (scrutinee.clone(), arms.collect());
                    StmtKind::Match { scrutinee, arms, otherwise }
                })
            }
            StmtKind::For { .. } => self.loop_backwards(back, bars, stmt),
            _ => Ok(()),
        }
    }

    /// Gives the bars of a place to the operands of the value that it took.
    fn value_backwards(
        &mut self,
        back: &mut Back,
        bars: &mut Bars,
        place: &Place,
        value: &Expr,
    ) -> Result<()> {
        if !back.active.0.contains(&place.root) {
            return Ok(());
        }
        let name = format!("{}_bar", self.locals[place.root.index()].name);
        let words = self.words_of(place);
        let of = self.module.leaves(&value.ty).len();
        let mut each = Vec::new();
        for at in 0..of {
            let bar = match (back.arrays.get(&place.root).cloned(), words) {
                (Some(array), _) => {
                    let whole = Place { root: array.root, ..place.clone() };
                    let word = Value::Place(whole.clone()).words(self.module).into_iter().nth(at);
                    let word = if whole.ty.is_word() {
                        Some(whole.load())
                    } else {
                        word.map(|it| it.value)
                    };
                    let Some(word) = word else { continue };
                    let zero = float(0.0, &word.ty, value.span);
                    let taken = self.bind(&name, word.clone());
                    if let ExprKind::Load(place) = word.kind {
                        self.emit(StmtKind::Assign { place, value: zero }, value.span);
                    }
                    Some(taken)
                }
                (None, Some(first)) => bars.remove(&(place.root, first + at)),
                (None, None) => None,
            };
            each.push(bar.map(|it| self.atom(it, &name)));
        }
        if let ExprKind::Routine(Routine::Inf | Routine::Sup, operands) = &value.kind
            && let [one, other] = operands.as_slice()
        {
            return self.elements_backwards(back, bars, place, [one, other], each);
        }
        let own = Some(place.load()).filter(|_| place.steps.is_empty() && value.ty.is_word());
        self.push_all(back, bars, value, each, own.as_ref())
    }

    /// Gives bars of the words of a value to its operands.
    fn push_all(
        &mut self,
        back: &mut Back,
        bars: &mut Bars,
        value: &Expr,
        each: Vec<Option<Expr>>,
        own: Option<&Expr>,
    ) -> Result<()> {
        match &value.kind {
            ExprKind::Struct(all) | ExprKind::Array(all) | ExprKind::Matrix(all) => {
                let mut each = each.into_iter();
                for part in all {
                    let count = self.module.leaves(&part.ty).len();
                    let of = each.by_ref().take(count).collect();
                    self.push_all(back, bars, part, of, None)?;
                }
                Ok(())
            }
            ExprKind::Splat(part) => {
                for bar in each.into_iter().flatten() {
                    self.push(back, bars, part, bar, None)?;
                }
                Ok(())
            }
            ExprKind::Load(place) if !value.ty.is_word() => {
                let words = Value::Place(place.clone()).words(self.module);
                for (word, bar) in words.into_iter().zip(each) {
                    if let Some(bar) = bar {
                        self.push(back, bars, &word.value, bar, None)?;
                    }
                }
                Ok(())
            }
            _ => match each.into_iter().next().flatten() {
                Some(bar) => self.push(back, bars, value, bar, own),
                None => Ok(()),
            },
        }
    }

    /// Adds to the bar of a place.
    fn add_bar(&mut self, back: &Back, bars: &mut Bars, place: &Place, bar: Expr) {
        if !back.active.0.contains(&place.root) {
            return;
        }
        if let Some(array) = back.arrays.get(&place.root) {
            let is_once = back.once.contains(&place.root);
            let place = Place { root: array.root, ..place.clone() };
            let span = place.span;
            let value = if is_once { bar } else { sum(place.load(), bar) };
            self.emit(StmtKind::Assign { place, value }, span);
            return;
        }
        let Some(word) = self.words_of(place) else { return };
        let key = (place.root, word);
        let total = match bars.remove(&key) {
            Some(before) => sum(before, bar),
            None => bar,
        };
        bars.insert(key, total);
    }

    /// Returns the number of the first word of a place with known indices.
    fn words_of(&self, place: &Place) -> Option<usize> {
        let mut ty = self.locals[place.root.index()].ty.clone();
        let mut first = 0;
        for step in &place.steps {
            let known = |index: &Expr| usize::try_from(literal(index)?).ok();
            first += match (step, &ty) {
                (Step::Field(field), Type::Struct(id)) => {
                    let before = &self.module.structs[id.index()].fields[..*field as usize];
                    before.iter().map(|it| self.module.leaves(&it.ty).len()).sum()
                }
                (Step::Index(index), Type::Array { element, .. }) => {
                    known(index)? * self.module.leaves(element).len()
                }
                (Step::Element(row, col), Type::Matrix { rows, .. }) => {
                    known(row)? + known(col)? * *rows as usize
                }
                _ => return None,
            };
            ty = self.module.step_type(&ty, step)?;
        }
        Some(first)
    }

    /// Goes back through the sides of a branch.
    fn sides_backwards(
        &mut self,
        back: &mut Back,
        bars: &mut Bars,
        blocks: &[&Block],
        span: Span,
        write: impl FnOnce(Vec<Block>) -> StmtKind,
    ) -> Result<()> {
        let mut assigned = Assigned::default();
        blocks.iter().for_each(|block| assigned.block(block));
        let mut inside = Bars::new();
        bars.retain(|key, bar| {
            let stays = !assigned.written.contains(&key.0);
            if !stays {
                inside.insert(*key, bar.clone());
            }
            stays
        });
        if inside.is_empty() {
            return Ok(());
        }
        // Both sides read these.
        for (key, bar) in &mut inside {
            let name = format!("{}_bar", self.locals[key.0.index()].name);
            *bar = self.atom(bar.clone(), &name);
        }
        let mut sides = Vec::new();
        for block in blocks {
            let mut own = inside.clone();
            let written = self.captured(|run| run.block_backwards(back, &mut own, block))?;
            sides.push((written.0, own));
        }
        let keys: BTreeSet<Key> = sides.iter().flat_map(|side| side.1.keys().copied()).collect();
        for key in keys {
            let ty = sides.iter().find_map(|side| Some(side.1.get(&key)?.ty.clone()));
            let Some(ty) = ty else { continue };
            let zero = float(0.0, &ty, span);
            let values: Vec<Expr> =
                sides.iter().map(|side| side.1.get(&key).unwrap_or(&zero).clone()).collect();
            let is_same = values.iter().all(|it| it.kind == values[0].kind);
            let total = match is_same && matches!(values[0].kind, ExprKind::Load(_)) {
                true => values[0].clone(),
                false => {
                    let name = format!("{}_bar", self.locals[key.0.index()].name);
                    let local = self.declare(&name, &ty, span);
                    self.emit(StmtKind::Let { local, value: None }, span);
                    for (side, value) in sides.iter_mut().zip(values) {
                        let place = Place::local(local, ty.clone(), span);
                        side.0.0.push(Stmt::new(StmtKind::Assign { place, value }, span));
                    }
                    Expr::local(local, &ty, span)
                }
            };
            let total = match bars.remove(&key) {
                Some(before) => sum(before, total),
                None => total,
            };
            bars.insert(key, total);
        }
        let blocks = sides.into_iter().map(|side| side.0).collect();
        self.emit(write(blocks), span);
        Ok(())
    }

    /// Goes back through a loop, from its last pass to its first.
    fn loop_backwards(&mut self, back: &mut Back, bars: &mut Bars, stmt: &Stmt) -> Result<()> {
        let span = stmt.span;
        let StmtKind::For { variable, from, to, inclusive, reversed, unroll, body, .. } =
            &stmt.kind
        else {
            return Ok(());
        };
        let mut assigned = Assigned::default();
        assigned.block(body);
        // The words with a bar that one pass hands to the next.
        let mut carried: BTreeSet<Key> =
            bars.keys().filter(|key| assigned.written.contains(&key.0)).copied().collect();
        if carried.is_empty() {
            return Ok(());
        }
        carried.extend(back.carried.get(variable).into_iter().flatten());
        // A pass on trial may hand on more. The loops in it begin with the words that they were found to hand on before, so the
        // number of passes grows with the words, and not with the depth of loops.
        let (mut pass, places, sums) = loop {
            let kept = self.locals.len();
            let (mut own, places) = self.bars_of(&carried, span);
            let (pass, sums) = self.captured(|run| {
                run.block_backwards(back, &mut own, body)?;
                let written = |key: &&Key| assigned.written.contains(&key.0);
                let found = own.keys().filter(written).copied();
                let before = carried.len();
                carried.extend(found);
                Ok(match carried.len() == before {
                    true => Some(run.pass_end(&own, &places, span)),
                    false => None,
                })
            })?;
            if let Some(sums) = sums {
                break (pass, places, sums);
            }
            self.locals.truncate(kept);
        };
        back.carried.insert(*variable, carried);
        for (key, place) in places.iter().chain(&sums) {
            let first = bars.remove(key).unwrap_or(float(0.0, &place.ty, span));
            self.emit(StmtKind::Let { local: place.root, value: Some(first) }, span);
        }
        if let Some(last) = self.ends.get(variable).copied() {
            let op = if *reversed { CompareOp::Ge } else { CompareOp::Le };
            let ty = from.ty.clone();
            let (at, last) = (Expr::local(*variable, &ty, span), Expr::local(last, &ty, span));
            let condition = Expr::compare(op, at, last);
            let otherwise = Block::default();
            pass = Block::of(StmtKind::If { condition, then: pass, otherwise }, span);
        }
        let kind = StmtKind::For {
            variable: *variable,
            from: from.clone(),
            to: to.clone(),
            inclusive: *inclusive,
            reversed: !reversed,
            unroll: *unroll,
            ended: false,
            body: pass,
        };
        self.emit(kind, span);
        bars.extend(places.into_iter().chain(sums).map(|(key, place)| (key, place.load())));
        Ok(())
    }

    /// Ends a pass: assigns the bars for the pass before, and adds the others to sums, which are returned.
    fn pass_end(&mut self, own: &Bars, places: &[(Key, Place)], span: Span) -> Vec<(Key, Place)> {
        let mut sums = Vec::new();
        for (key, bar) in own {
            if places.iter().any(|it| it.0 == *key) {
                continue;
            }
            let name = format!("{}_bar", self.locals[key.0.index()].name);
            let local = self.declare(&name, &bar.ty, span);
            let place = Place::local(local, bar.ty.clone(), span);
            let value = sum(place.load(), bar.clone());
            self.emit(StmtKind::Assign { place: place.clone(), value }, span);
            sums.push((*key, place));
        }
        self.next_bars(own, places, span);
        sums
    }

    /// Declares the bars of what passes assign to each other.
    fn bars_of(&mut self, carried: &BTreeSet<Key>, span: Span) -> (Bars, Vec<(Key, Place)>) {
        let each = carried.iter().map(|key| {
            let declared = self.locals[key.0.index()].clone();
            let local = self.declare(&format!("{}_bar", declared.name), &declared.ty, span);
            (*key, Place::local(local, declared.ty, span))
        });
        let places: Vec<(Key, Place)> = each.collect();
        (places.iter().map(|(key, place)| (*key, place.load())).collect(), places)
    }

    /// Assigns the bars for the pass before.
    fn next_bars(&mut self, own: &Bars, places: &[(Key, Place)], span: Span) {
        let roots: BTreeSet<LocalId> = places.iter().map(|it| it.1.root).collect();
        let mut assigned = Vec::new();
        for (key, place) in places {
            let zero = float(0.0, &place.ty, span);
            let value = own.get(key).unwrap_or(&zero).clone();
            if !matches!(&value.kind, ExprKind::Load(it) if it.root == place.root) {
                assigned.push((place.clone(), value));
            }
        }
        for (place, value) in &mut assigned {
            let mut reads = Assigned::default();
            reads.expr(value);
            if reads.read.iter().any(|it| roots.contains(it)) {
                let name = format!("next_{}", self.locals[place.root.index()].name);
                *value = self.bind(&name, value.clone());
            }
        }
        for (place, value) in assigned {
            self.emit(StmtKind::Assign { place, value }, span);
        }
    }
}

/// Returns the sum of two bars.
fn sum(a: Expr, b: Expr) -> Expr {
    match b.kind {
        ExprKind::Unary(UnaryOp::Neg, b) => Expr::binary(BinaryOp::Sub, a, *b),
        _ => Expr::binary(BinaryOp::Add, a, b),
    }
}

/// Locals with parts at unknown indices.
#[derive(Default)]
struct Unknown(BTreeSet<LocalId>);

impl Visit for Unknown {
    fn place(&mut self, place: &Place, _: Access) {
        let is_known = |step: &Step| match step {
            Step::Field(_) => true,
            Step::Index(index) => literal(index).is_some(),
            Step::Element(row, col) => literal(row).is_some() && literal(col).is_some(),
            Step::From(_) => false,
        };
        if !place.steps.iter().all(is_known) {
            self.0.insert(place.root);
        }
        visit::walk_place(self, place);
    }
}
