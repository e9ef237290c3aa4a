//! Loops that stay loops: what their passes assign is in variables, whose derivatives are found by passes on trial.
//!
//! Invariant: a pass on trial that finds no variable more is the pass that is written.

use std::collections::{BTreeMap, BTreeSet};

use bessemer_ir::visit::{self, Access, Visit};
use bessemer_ir::{Block, Expr, ExprKind, Int, LocalId, Mode, Place, Scalar, Span, StmtKind, Type};

use crate::run::{Env, Frame, Run};
use crate::value::{Tangents, Value, Word};
use crate::{Problem, Result, float};

/// Largest number of passes of a loop that is unrolled, and of all loops around it together.
const UNROLLED: [u64; 2] = [32, 1024];

/// A local that the passes of a loop assign, with its variables in the derivative.
pub struct Carried {
    local: LocalId,
    words: Vec<Variable>,
}

/// A word of such a local.
struct Variable {
    value: Place,
    tangents: Vec<(u32, Place)>,
}

impl Run<'_> {
    /// Returns the values of a counter, if the loop is short enough to be unrolled.
    pub fn values(
        &self,
        (first, last): (i128, i128),
        (inclusive, reversed): (bool, bool),
        like: &Expr,
        around: u64,
    ) -> Option<Vec<Expr>> {
        let end = if inclusive { last + 1 } else { last };
        let count = u64::try_from((end - first).max(0)).ok()?;
        let [passes, all] = UNROLLED;
        if count > passes || around.saturating_mul(count) > all {
            return None;
        }
        let word = |value: i128| Expr { span: like.span, ..Expr::literal_like(value as u64, like) };
        let mut values: Vec<Expr> = (first..end).map(word).collect();
        if reversed {
            values.reverse();
        }
        Some(values)
    }

    /// Writes a loop.
    pub fn kept(
        &mut self,
        frame: Frame<'_>,
        env: &mut Env,
        kind: &StmtKind,
        (from, to): (Expr, Expr),
        span: Span,
    ) -> Result<()> {
        let StmtKind::For { variable, inclusive, reversed, unroll, body, .. } = kind else {
            return Ok(());
        };
        let all = frame.function.locals.iter().enumerate();
        let references = all.filter(|it| it.1.mode == Mode::RefMut);
        let references = references.map(|it| LocalId(it.0 as u32)).collect();
        let mut assigned = Assigned { references, ..Assigned::default() };
        assigned.block(body);
        let mut locals = BTreeSet::new();
        for written in assigned.written() {
            // An alias of a place writes the local of the place.
            let local = env.aliases.get(&written).map_or(written, crate::place::Route::root);
            if let Some(value) = env.locals.get(&local) {
                self.plain(value.clone(), span)?;
                locals.insert(local);
            } else if !assigned.declared.contains(&local) {
                let name = &frame.function.local(local).name;
                return Err(Problem::new(
                    span,
                    format!("`{name}` has no value before this long loop, and so no derivative"),
                    format!("give `{name}` a value before the loop"),
                ));
            }
        }
        self.fix(frame, env, &assigned.read, &locals, span);
        let counter = frame.function.local(*variable);
        let int = match counter.ty {
            Type::Scalar(scalar) => Type::Scalar(scalar),
            _ => Type::Scalar(Scalar::Int(Int::Usize)),
        };
        let mut known: Vec<Vec<BTreeSet<u32>>> = locals.iter().map(|_| Vec::new()).collect();
        for (local, known) in locals.iter().zip(&mut known) {
            let words = env.locals[local].clone().words(self.module);
            known.extend(
                words.iter().map(|word| word.tangents.keys().copied().collect::<BTreeSet<u32>>()),
            );
        }
        // A pass on trial may find a variable more. The loops in it begin with the variables that they were found to have before,
        // so the number of passes grows with the variables, and not with the depth of loops.
        let Trial { known: before, mut inner } = self.trials.begin();
        grow(&mut known, before);
        let (firsts, counter, block) = loop {
            let kept = self.locals.len();
            let mut outer = env.clone();
            let around = self.trials.enter(inner);
            let written = self.captured(|run| {
                let carried = run.carried(frame, &mut outer, &locals, &known, span)?;
                let firsts = std::mem::take(&mut run.out);
                let mut within = outer.clone();
                let of = (*variable, &int);
                Ok((firsts, run.passed(frame, &mut within, of, body, &carried, span)?))
            });
            inner = self.trials.leave(around);
            let (block, (firsts, (counter, found))) = written?;
            if !grow(&mut known, found) {
                *env = outer;
                break (firsts, counter, block);
            }
            self.locals.truncate(kept);
        };
        self.trials.end(Trial { known: known.into_iter().flatten().collect(), inner });
        self.out.extend(firsts);
        self.emit(
            StmtKind::For {
                variable: counter,
                from,
                to,
                inclusive: *inclusive,
                reversed: *reversed,
                unroll: *unroll,
                ended: false,
                body: block,
            },
            span,
        );
        Ok(())
    }

    /// Gives arrays without derivatives that the passes only read a place, so that no pass writes them anew.
    fn fix(
        &mut self,
        frame: Frame<'_>,
        env: &mut Env,
        read: &BTreeSet<LocalId>,
        written: &BTreeSet<LocalId>,
        span: Span,
    ) {
        for local in read.difference(written) {
            let declared = frame.function.local(*local);
            let Some(value) = env.locals.get(local) else { continue };
            if !declared.ty.is_array() || !matches!(value, Value::Parts(_)) || value.is_active() {
                continue;
            }
            if matches!(declared.ty, Type::Slice(_)) {
                continue;
            }
            let words = value.clone().words(self.module).into_iter().map(|word| word.value);
            let whole = self.aggregate(&declared.ty, words);
            let name = declared.name.clone();
            let id = self.declare(&name, &declared.ty, span);
            self.emit(StmtKind::Let { local: id, value: Some(whole) }, span);
            env.locals.insert(*local, Value::Place(Place::local(id, declared.ty.clone(), span)));
        }
    }

    /// Evaluates one pass; returns the counter, and the variables found for each word.
    fn passed(
        &mut self,
        frame: Frame<'_>,
        env: &mut Env,
        (variable, int): (LocalId, &Type),
        body: &Block,
        carried: &[Carried],
        span: Span,
    ) -> Result<(LocalId, Vec<BTreeSet<u32>>)> {
        let counter = self.declare(&frame.function.local(variable).name, int, span);
        let value = Expr::local(counter, int, span);
        env.locals.insert(variable, Value::Leaf(Word::constant(value)));
        let outer = std::mem::take(&mut self.found);
        let inner = Frame { function: frame.function, carried: Some(carried) };
        let done = self.pass(inner, env, body);
        let found = std::mem::replace(&mut self.found, outer);
        done?;
        Ok((counter, found))
    }

    /// Declares the variables of a loop with their first values.
    fn carried(
        &mut self,
        frame: Frame<'_>,
        env: &mut Env,
        locals: &BTreeSet<LocalId>,
        known: &[Vec<BTreeSet<u32>>],
        span: Span,
    ) -> Result<Vec<Carried>> {
        let mut all = Vec::new();
        for (local, known) in locals.iter().zip(known) {
            let declared = frame.function.local(*local);
            let Some(value) = env.locals.remove(local) else { continue };
            let old = value.words(self.module);
            let many = old.len() > 1;
            let mut words = Vec::new();
            let mut new = Vec::new();
            for (index, (word, known)) in old.into_iter().zip(known).enumerate() {
                let name = match many {
                    true => format!("{}_{index}", declared.name),
                    false => declared.name.clone(),
                };
                let zero = float(0.0, &word.value.ty, span);
                let value = self.variable(&name, word.value);
                let tangents: Vec<(u32, Place)> = known
                    .iter()
                    .map(|variable| {
                        let first = word.tangents.get(variable).unwrap_or(&zero).clone();
                        (*variable, self.variable(&format!("{name}_d{variable}"), first))
                    })
                    .collect();
                let loads = tangents.iter().map(|(variable, place)| (*variable, place.load()));
                new.push(Word { value: value.load(), tangents: loads.collect::<Tangents>() });
                words.push(Variable { value, tangents });
            }
            let value = Value::of(self.module, &declared.ty, &mut new.into_iter());
            let unsized_part = || {
                Problem::new(
                    span,
                    format!("`{}` is a slice, which a loop writes", declared.name),
                    "write to an array",
                )
            };
            env.locals.insert(*local, value.ok_or_else(unsized_part)?);
            all.push(Carried { local: *local, words });
        }
        Ok(all)
    }

    fn variable(&mut self, name: &str, first: Expr) -> Place {
        let (ty, span) = (first.ty.clone(), first.span);
        let local = self.declare(name, &ty, span);
        self.emit(StmtKind::Let { local, value: Some(first) }, span);
        Place::local(local, ty, span)
    }

    /// Assigns the variables of the loop at the end of a pass.
    pub fn write_back(&mut self, frame: Frame<'_>, env: &mut Env) -> Result<()> {
        let Some(carried) = frame.carried else { return Ok(()) };
        let mut assigned: Vec<(Place, Expr)> = Vec::new();
        let mut found = Vec::new();
        for Carried { local, words } in carried {
            let Some(value) = env.locals.get(local).cloned() else { continue };
            let value = self.plain(value, frame.function.local(*local).span)?;
            for (word, variable) in value.words(self.module).into_iter().zip(words) {
                found.push(word.tangents.keys().copied().collect::<BTreeSet<u32>>());
                let zero = float(0.0, &word.value.ty, word.value.span);
                for (index, place) in &variable.tangents {
                    let value = word.tangents.get(index).unwrap_or(&zero).clone();
                    assigned.push((place.clone(), value));
                }
                assigned.push((variable.value.clone(), word.value));
            }
        }
        assigned.retain(|(place, value)| !matches!(&value.kind, ExprKind::Load(it) if it == place));
        let roots: BTreeSet<LocalId> = assigned.iter().map(|it| it.0.root).collect();
        // A value that reads another of the variables is taken before any is assigned.
        for (place, value) in &mut assigned {
            let mut reads = Reads { roots: &roots, found: false };
            reads.expr(value);
            if reads.found {
                let name = format!("next_{}", self.locals[place.root.index()].name);
                *value = self.bind(&name, value.clone());
            }
        }
        for (place, value) in assigned {
            let span = value.span;
            self.emit(StmtKind::Assign { place, value }, span);
        }
        if self.found.len() < found.len() {
            self.found.resize(found.len(), BTreeSet::new());
        }
        self.found.iter_mut().zip(found).for_each(|(all, more)| all.extend(more));
        Ok(())
    }
}

/// Variables that loops were found to have, in the order in which a pass reaches the loops.
#[derive(Debug, Default)]
pub struct Trials {
    of: Vec<Trial>,
    at: usize,
}

/// Variables that a loop was found to have, by carried word, and those of the loops in it.
#[derive(Clone, Debug, Default)]
struct Trial {
    known: Vec<BTreeSet<u32>>,
    inner: Vec<Trial>,
}

impl Trials {
    /// Returns the variables found so far of the loop that the pass reaches now.
    fn begin(&mut self) -> Trial {
        self.of.get(self.at).cloned().unwrap_or_default()
    }

    /// Stores the variables of that loop. The pass goes on to the next.
    fn end(&mut self, trial: Trial) {
        match self.of.get_mut(self.at) {
            Some(place) => *place = trial,
            None => self.of.push(trial),
        }
        self.at += 1;
    }

    /// Begins a pass of a loop, of whose loops this is known. Returns the state of the pass around it.
    fn enter(&mut self, inner: Vec<Trial>) -> Trials {
        std::mem::replace(self, Trials { of: inner, at: 0 })
    }

    /// Ends a pass of a loop; returns the variables found of the loops in it.
    fn leave(&mut self, around: Trials) -> Vec<Trial> {
        std::mem::replace(self, around).of
    }
}

/// Adds variables of words; returns true if one is new.
fn grow(known: &mut [Vec<BTreeSet<u32>>], more: Vec<BTreeSet<u32>>) -> bool {
    let mut grown = false;
    for (known, more) in known.iter_mut().flatten().zip(more) {
        let before = known.len();
        known.extend(more);
        grown |= known.len() > before;
    }
    grown
}

/// Roots of the places that a block assigns, and its declarations.
#[derive(Default)]
struct Assigned {
    roots: BTreeSet<LocalId>,
    read: BTreeSet<LocalId>,
    declared: BTreeSet<LocalId>,
    aliased: BTreeMap<LocalId, LocalId>,
    references: BTreeSet<LocalId>,
}

impl Assigned {
    /// Returns the written locals; those of aliases that the block declares are the aliased ones.
    fn written(&self) -> BTreeSet<LocalId> {
        let source = |local: &LocalId| {
            let mut local = *local;
            while let Some(source) = self.aliased.get(&local) {
                local = *source;
            }
            local
        };
        self.roots.iter().map(source).collect()
    }
}

impl Visit for Assigned {
    fn place(&mut self, place: &Place, access: Access) {
        let set = if access == Access::Read { &mut self.read } else { &mut self.roots };
        set.insert(place.root);
        visit::walk_place(self, place);
    }

    fn declaration(&mut self, local: &LocalId) {
        self.declared.insert(*local);
    }

    fn stmt(&mut self, stmt: &bessemer_ir::Stmt) {
        if let StmtKind::Let { local, value: Some(Expr { kind: ExprKind::Load(place), .. }) } =
            &stmt.kind
            && self.references.contains(local)
        {
            self.aliased.insert(*local, place.root);
        }
        visit::walk_stmt(self, stmt);
    }
}

struct Reads<'r> {
    roots: &'r BTreeSet<LocalId>,
    found: bool,
}

impl Visit for Reads<'_> {
    fn place(&mut self, place: &Place, _: Access) {
        self.found |= self.roots.contains(&place.root);
        visit::walk_place(self, place);
    }
}
