//! Joins of the sides of a branch: a word that differs becomes a local that each side assigns.

use std::collections::BTreeSet;

use bessemer_ir::{Block, Expr, ExprKind, Form, LocalId, Place, Span, Stmt, StmtKind, Type};

use crate::expression::literal;
use crate::run::{Env, Frame, Run};
use crate::value::{Tangents, Value, Word, parts};
use crate::{Result, float};

/// A branch whose sides are joined.
pub struct Branch {
    /// Condition, if it has two sides.
    pub condition: Option<Expr>,
    /// Number of locals before the sides; later ones are visible within a side only.
    pub locals: usize,
    /// Place of the branch.
    pub span: Span,
}

/// The sides that go on behind a branch.
struct Open<'s> {
    branch: &'s Branch,
    at: &'s [usize],
    sides: &'s mut [(Block, Env)],
}

impl Run<'_> {
    /// Writes a branch with its sides, and returns the values behind it.
    pub fn join(
        &mut self,
        frame: Frame<'_>,
        before: &Env,
        mut sides: Vec<(Block, Env)>,
        branch: &Branch,
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
                let local = frame.function.local(key);
                let mut open = Open { branch, at: &open, sides: &mut sides };
                let value = self.joined((&local.name, &local.ty), values, &mut open)?;
                joined.locals.insert(key, value);
            }
            let returned = open.iter().map(|at| sides[*at].1.result.take());
            // A side without a result ends later; the statements behind are then in the other side.
            if let Some(values) = returned.collect::<Option<Vec<Value>>>() {
                let name = self.result_name.clone();
                let name = name.as_deref().unwrap_or(&frame.function.result_name);
                let of = (name, &frame.function.result);
                let mut open = Open { branch, at: &open, sides: &mut sides };
                joined.result = Some(self.joined(of, values, &mut open)?);
            }
        }
        let blocks = sides.into_iter().map(|side| side.0).collect();
        self.emit(write(blocks), branch.span);
        Ok(joined)
    }

    fn joined(
        &mut self,
        (name, ty): (&str, &Type),
        values: Vec<Value>,
        open: &mut Open<'_>,
    ) -> Result<Value> {
        let Some(first) = values.first() else { return Ok(Value::Parts(Vec::new())) };
        if values.iter().all(|value| value == first) {
            return Ok(first.clone());
        }
        if let Some(factor) = values.iter().find(|it| matches!(it, Value::Factor(_))) {
            return self.plain(factor.clone(), open.branch.span);
        }
        let split: Vec<Value> = values.into_iter().map(|it| it.split(self.module)).collect();
        if let [Value::Parts(first), ..] = split.as_slice() {
            let count = first.len();
            let types = parts(self.module, ty, open.branch.span);
            let read = self.read_parts(ty, &split, count);
            let mut columns: Vec<Vec<Value>> = (0..count).map(|_| Vec::new()).collect();
            for value in split {
                if let Value::Parts(parts) = value {
                    columns.iter_mut().zip(parts).for_each(|(column, it)| column.push(it));
                }
            }
            let mut joined = Vec::new();
            for (index, (column, read)) in columns.into_iter().zip(read).enumerate() {
                let mut known = column.iter().zip(read).filter(|it| it.1).map(|it| it.0);
                let value = known.next().cloned();
                let one = value
                    .filter(|one| known.all(|it| it == one) && one.is_visible(open.branch.locals));
                let ty = types.get(index).map_or(Type::Unit, |it| it.1.clone());
                joined.push(match one {
                    Some(one) => one,
                    None => self.joined((&format!("{name}_{index}"), &ty), column, open)?,
                });
            }
            return Ok(Value::Parts(joined));
        }
        let words: Vec<Word> = split.into_iter().flat_map(|it| it.words(self.module)).collect();
        let value = self.phi(name, words.iter().map(|it| it.value.clone()), open);
        let variables: BTreeSet<u32> =
            words.iter().flat_map(|word| word.tangents.keys().copied()).collect();
        let mut tangents = Tangents::new();
        for variable in variables {
            let zero = float(0.0, &value.ty, open.branch.span);
            let each: Vec<Expr> = words
                .iter()
                .map(|word| word.tangents.get(&variable).unwrap_or(&zero).clone())
                .collect();
            let name = format!("{name}_d{variable}");
            tangents.insert(variable, self.phi(&name, each.into_iter(), open));
        }
        Ok(Value::Leaf(Word { value, tangents }))
    }

    /// Returns for each part of some values which of them may be read: an option without a value has none.
    fn read_parts(&self, ty: &Type, values: &[Value], count: usize) -> Vec<Vec<bool>> {
        let form = match ty {
            Type::Struct(id) => Some(&self.module.structs[id.index()].form),
            _ => None,
        };
        let is_read = |value: &Value, part: usize| {
            let (Some(Form::Choice(cases)), Value::Parts(parts)) = (form, value) else {
                return true;
            };
            let Some(Value::Leaf(tag)) = parts.first().filter(|_| part > 0) else { return true };
            let case = literal(&tag.value).and_then(|tag| cases.get(usize::try_from(tag).ok()?));
            case.is_none_or(|field| *field == Some(part as u32))
        };
        let of_part = |part: usize| values.iter().map(|value| is_read(value, part)).collect();
        (0..count).map(of_part).collect()
    }

    fn phi(&mut self, name: &str, values: impl Iterator<Item = Expr>, open: &mut Open<'_>) -> Expr {
        let span = open.branch.span;
        let values: Vec<Expr> = values.collect();
        let Some(first) = values.first() else { return Expr::usize(0, span) };
        if values.iter().all(|value| value.kind == first.kind) {
            return first.clone();
        }
        if let Some(condition) = &open.branch.condition
            && first.ty == Type::BOOL
            && open.at == [0, 1]
            && is_small(condition)
        {
            // The values are not equal.
            match (literal(&values[0]), literal(&values[1])) {
                (Some(1), Some(0)) => return condition.clone(),
                (Some(0), Some(1)) => return condition.clone().negated(),
                _ => {}
            }
        }
        let ty = first.ty.clone();
        let local = self.declare(name, &ty, span);
        self.emit(StmtKind::Let { local, value: None }, span);
        for (at, value) in open.at.iter().zip(values) {
            let place = Place::local(local, ty.clone(), span);
            open.sides[*at].0.0.push(Stmt::new(StmtKind::Assign { place, value }, span));
        }
        Expr::local(local, &ty, span)
    }
}

/// Returns true if a condition costs as little as the local that it would be in.
fn is_small(condition: &Expr) -> bool {
    match &condition.kind {
        ExprKind::Load(_) | ExprKind::Literal(_) => true,
        ExprKind::Compare(_, a, b) => is_small(a) && is_small(b),
        ExprKind::Unary(_, a) => is_small(a),
        _ => false,
    }
}
