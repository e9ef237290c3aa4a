//! Joins of the sides of a branch: a word that differs becomes a local that each side assigns.

use std::collections::BTreeSet;

use bessemer_ir::{Block, Expr, LocalId, Place, Span, Stmt, StmtKind};

use crate::run::{Env, Frame, Run};
use crate::value::{Tangents, Value, Word};
use crate::{Result, float};

impl Run<'_> {
    /// Writes a branch with its sides, and returns the values behind it.
    pub fn join(
        &mut self,
        frame: Frame<'_>,
        before: &Env,
        mut sides: Vec<(Block, Env)>,
        span: Span,
        write: impl FnOnce(Vec<Block>) -> StmtKind,
    ) -> Result<Env> {
        let mut joined = before.clone();
        let open: Vec<usize> = (0..sides.len()).filter(|at| !sides[*at].1.ended).collect();
        joined.ended = open.is_empty();
        if !open.is_empty() {
            let known = before.locals.keys();
            let keys: BTreeSet<LocalId> = known
                .chain(sides.iter().flat_map(|side| side.1.locals.keys()))
                .copied()
                .filter(|key| open.iter().all(|at| sides[*at].1.locals.contains_key(key)))
                .collect();
            joined.locals.clear();
            for key in keys {
                let values: Vec<Value> =
                    open.iter().filter_map(|at| sides[*at].1.locals.remove(&key)).collect();
                let name = frame.function.local(key).name.clone();
                let value = self.joined(&name, values, &open, &mut sides, span);
                joined.locals.insert(key, value);
            }
            let returned = open.iter().map(|at| sides[*at].1.result.take());
            // A side without a result ends later; the statements behind are then in the other side.
            if let Some(values) = returned.collect::<Option<Vec<Value>>>() {
                let name = frame.function.result_name.clone();
                joined.result = Some(self.joined(&name, values, &open, &mut sides, span));
            }
        }
        let blocks = sides.into_iter().map(|side| side.0).collect();
        self.emit(write(blocks), span);
        Ok(joined)
    }

    fn joined(
        &mut self,
        name: &str,
        values: Vec<Value>,
        open: &[usize],
        sides: &mut [(Block, Env)],
        span: Span,
    ) -> Value {
        let Some(first) = values.first() else { return Value::Parts(Vec::new()) };
        if values.iter().all(|value| value == first) {
            return first.clone();
        }
        let split: Vec<Value> = values.into_iter().map(|it| it.split(self.module)).collect();
        if let [Value::Parts(first), ..] = split.as_slice() {
            let count = first.len();
            let mut columns: Vec<Vec<Value>> = (0..count).map(|_| Vec::new()).collect();
            for value in split {
                if let Value::Parts(parts) = value {
                    columns.iter_mut().zip(parts).for_each(|(column, it)| column.push(it));
                }
            }
            let joined = columns.into_iter().enumerate().map(|(index, column)| {
                self.joined(&format!("{name}_{index}"), column, open, sides, span)
            });
            return Value::Parts(joined.collect());
        }
        let words: Vec<Word> = split.into_iter().flat_map(|it| it.words(self.module)).collect();
        let value = self.phi(name, words.iter().map(|it| it.value.clone()), open, sides, span);
        let variables: BTreeSet<u32> =
            words.iter().flat_map(|word| word.tangents.keys().copied()).collect();
        let mut tangents = Tangents::new();
        for variable in variables {
            let zero = float(0.0, &value.ty, span);
            let each: Vec<Expr> = words
                .iter()
                .map(|word| word.tangents.get(&variable).unwrap_or(&zero).clone())
                .collect();
            let name = format!("{name}_d{variable}");
            tangents.insert(variable, self.phi(&name, each.into_iter(), open, sides, span));
        }
        Value::Leaf(Word { value, tangents })
    }

    fn phi(
        &mut self,
        name: &str,
        values: impl Iterator<Item = Expr>,
        open: &[usize],
        sides: &mut [(Block, Env)],
        span: Span,
    ) -> Expr {
        let values: Vec<Expr> = values.collect();
        let Some(first) = values.first() else { return Expr::usize(0, span) };
        if values.iter().all(|value| value.kind == first.kind) {
            return first.clone();
        }
        let ty = first.ty.clone();
        let local = self.declare(name, &ty, span);
        self.emit(StmtKind::Let { local, value: None }, span);
        for (at, value) in open.iter().zip(values) {
            let place = Place::local(local, ty.clone(), span);
            sides[*at].0.0.push(Stmt::new(StmtKind::Assign { place, value }, span));
        }
        Expr::local(local, &ty, span)
    }
}
