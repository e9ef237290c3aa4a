//! Places in values: reads and writes of their parts.

use bessemer_ir::{Expr, ExprKind, LocalId, Place, Span, Step, StmtKind, Type};

use crate::expression::literal;
use crate::run::{Env, Frame, Run};
use crate::value::{Tangents, Value, Word, parts};
use crate::{Problem, Result, float};

/// A place with evaluated indices.
#[derive(Clone, Debug)]
pub struct Route {
    root: LocalId,
    root_type: Type,
    steps: Vec<Hop>,
}

/// One step of a route.
#[derive(Clone, Debug)]
enum Hop {
    /// A part.
    Part(usize),
    /// The parts from one on.
    From(usize),
    /// A part that is known only when the derivative runs.
    Unknown(Step),
}

impl Route {
    /// Returns the local.
    pub fn root(&self) -> LocalId {
        self.root
    }
}

fn outside(span: Span) -> Problem {
    Problem::new(span, "this index is out of range", "correct the index")
}

impl Run<'_> {
    /// Returns the name of a place: its variable, fields and known indices.
    pub fn named(&self, name: String, ty: &Type, place: &Place, route: &Route) -> String {
        let before = route.steps.len().saturating_sub(place.steps.len());
        let (mut name, mut ty) = (name, ty.clone());
        for (step, hop) in place.steps.iter().zip(&route.steps[before..]) {
            let more = match (step, hop, &ty) {
                (Step::Field(field), _, Type::Struct(id)) => {
                    let fields = &self.module.structs[id.index()].fields;
                    fields.get(*field as usize).map(|it| it.name.clone())
                }
                (_, Hop::Part(at), _) => Some(at.to_string()),
                _ => None,
            };
            if let Some(more) = more {
                name = format!("{name}_{more}");
            }
            ty = self.module.step_type(&ty, step).unwrap_or(Type::Unit);
        }
        name
    }

    /// Evaluates the indices of a place.
    pub fn route(&mut self, frame: Frame<'_>, env: &mut Env, place: &Place) -> Result<Route> {
        let root = frame.function.local(place.root);
        let mut route = match env.aliases.get(&place.root) {
            Some(alias) => alias.clone(),
            None => Route { root: place.root, root_type: root.ty.clone(), steps: Vec::new() },
        };
        let mut ty = root.ty.clone();
        for step in &place.steps {
            let hop = match step {
                Step::Field(field) => Hop::Part(*field as usize),
                Step::Index(index) => {
                    let index = self.scalar(frame, env, index)?;
                    match literal(&index) {
                        Some(at) => Hop::Part(at as usize),
                        None => Hop::Unknown(Step::Index(index)),
                    }
                }
                Step::Element(row, col) => {
                    let row = self.scalar(frame, env, row)?;
                    let col = self.scalar(frame, env, col)?;
                    let rows = match ty {
                        Type::Matrix { rows, .. } => i128::from(rows),
                        _ => 1,
                    };
                    match (literal(&row), literal(&col)) {
                        (Some(row), Some(col)) if (0..rows).contains(&row) && col >= 0 => {
                            Hop::Part((col * rows + row) as usize)
                        }
                        (Some(_), Some(_)) => return Err(outside(place.span)),
                        _ => Hop::Unknown(Step::Element(row, col)),
                    }
                }
                Step::From(first) => {
                    let first = self.scalar(frame, env, first)?;
                    match literal(&first) {
                        Some(at) => Hop::From(at as usize),
                        None => {
                            return Err(Problem::new(
                                place.span,
                                "a part of unknown position has no derivative",
                                "index the elements in a loop",
                            ));
                        }
                    }
                }
            };
            ty = self.module.step_type(&ty, step).unwrap_or(Type::Unit);
            route.steps.push(hop);
        }
        Ok(route)
    }

    /// Returns the value at a route.
    pub fn read(&mut self, env: &Env, route: &Route, span: Span) -> Result<Value> {
        let unset = || Problem::new(span, "this is read before it has a value", "assign it first");
        let mut value = env.locals.get(&route.root).ok_or_else(unset)?;
        let mut own: Value;
        let mut ty = route.root_type.clone();
        for hop in &route.steps {
            let (next, next_type) = match (hop, value) {
                (Hop::Part(at), Value::Parts(all)) => {
                    value = all.get(*at).ok_or_else(|| outside(span))?;
                    ty = self.part_type(&ty, *at);
                    continue;
                }
                (_, Value::Place(place)) => self.inside(place, hop, &ty, span)?,
                (_, Value::Factor(factor)) => {
                    self.inside(&self.elements(factor, span)?, hop, &ty, span)?
                }
                (Hop::From(at), Value::Parts(all)) => {
                    let rest = all.get(*at..).ok_or_else(|| outside(span))?;
                    (Value::Parts(rest.to_vec()), Some(slice(&ty)))
                }
                (Hop::Unknown(step), Value::Parts(all)) => {
                    let all = all.clone();
                    (self.chosen(&ty, &all, step, span)?, None)
                }
                (_, Value::Leaf(_)) => return Err(outside(span)),
            };
            ty = next_type.unwrap_or_else(|| match hop {
                Hop::Part(at) => self.part_type(&ty, *at),
                Hop::Unknown(step) => self.module.step_type(&ty, step).unwrap_or(Type::Unit),
                Hop::From(_) => slice(&ty),
            });
            own = next;
            value = &own;
        }
        Ok(value.clone())
    }

    /// Returns the value one step into a place, and its type if that is not the step's.
    fn inside(
        &self,
        place: &Place,
        hop: &Hop,
        ty: &Type,
        span: Span,
    ) -> Result<(Value, Option<Type>)> {
        match hop {
            Hop::Part(at) => Ok((self.part(place, *at, span)?, None)),
            Hop::Unknown(step) => {
                let inner = self.module.step_type(&place.ty, step).unwrap_or(Type::Unit);
                Ok((Value::at(place.inside(step.clone(), inner)), None))
            }
            Hop::From(0) if matches!(place.ty, Type::Slice(_)) => {
                Ok((Value::Place(place.clone()), None))
            }
            Hop::From(at) => {
                let Value::Parts(all) = Value::Place(place.clone()).split(self.module) else {
                    return Err(outside(span));
                };
                let rest = all.get(*at..).ok_or_else(|| outside(span))?;
                Ok((Value::Parts(rest.to_vec()), Some(slice(ty))))
            }
        }
    }

    /// Writes a value to a route.
    pub fn write(&mut self, env: &mut Env, route: &Route, value: Value, span: Span) -> Result<()> {
        if route.steps.is_empty() {
            env.locals.insert(route.root, value);
            return Ok(());
        }
        let old = env.locals.remove(&route.root);
        let old = old.unwrap_or_else(|| self.zeros(&route.root_type, span));
        let new = self.replaced(old, &route.root_type.clone(), &route.steps, value, span)?;
        env.locals.insert(route.root, new);
        Ok(())
    }

    fn replaced(
        &mut self,
        old: Value,
        ty: &Type,
        steps: &[Hop],
        value: Value,
        span: Span,
    ) -> Result<Value> {
        let Some((hop, rest)) = steps.split_first() else { return Ok(value) };
        let old = self.plain(old, span)?;
        let Value::Parts(mut all) = old.split(self.module) else { return Err(outside(span)) };
        match hop {
            Hop::Part(at) => {
                let inner = self.part_type(ty, *at);
                let part = all.get_mut(*at).ok_or_else(|| outside(span))?;
                let old = std::mem::replace(part, Value::Parts(Vec::new()));
                all[*at] = self.replaced(old, &inner, rest, value, span)?;
            }
            Hop::From(at) => {
                let tail = Value::Parts(all.split_off((*at).min(all.len())));
                let Value::Parts(new) = self.replaced(tail, &slice(ty), rest, value, span)? else {
                    return Err(outside(span));
                };
                all.extend(new);
            }
            Hop::Unknown(step) => {
                let inner = self.module.step_type(ty, step).unwrap_or(Type::Unit);
                if !rest.is_empty() || !inner.is_word() {
                    return Err(Problem::new(
                        span,
                        "a part at an unknown index is written here, and has no derivative",
                        "index an array of numbers, or let a loop with constant bounds count",
                    ));
                }
                let Value::Leaf(word) = value else { return Err(outside(span)) };
                all = self.stored(ty, &all, step, word, span)?;
            }
        }
        Ok(Value::Parts(all))
    }

    /// Returns the element of parts at an index that is known only when the derivative runs.
    fn chosen(&mut self, ty: &Type, all: &[Value], step: &Step, span: Span) -> Result<Value> {
        let inner = self.module.step_type(ty, step).unwrap_or(Type::Unit);
        let active = all.iter().any(Value::is_active);
        if !inner.is_word() && active {
            return Err(Problem::new(
                span,
                "a part at an unknown index is read here, and has no derivative",
                "index an array of numbers, or let a loop with constant bounds count",
            ));
        }
        let (table, tangents) = self.tables(ty, all, span);
        let at = |place: Place| place.inside(step.clone(), inner.clone());
        if tangents.is_empty() {
            return Ok(Value::at(at(table)));
        }
        let tangents = tangents.into_iter().map(|(variable, it)| (variable, at(it).load()));
        Ok(Value::Leaf(Word { value: at(table).load(), tangents: tangents.collect() }))
    }

    /// Writes a word to an element of parts at an index that is known only when the derivative runs.
    fn stored(
        &mut self,
        ty: &Type,
        all: &[Value],
        step: &Step,
        word: Word,
        span: Span,
    ) -> Result<Vec<Value>> {
        let (table, mut tangents) = self.tables(ty, all, span);
        let leaf = word.value.ty.clone();
        let at = |place: &Place| place.inside(step.clone(), leaf.clone());
        for variable in word.tangents.keys() {
            if tangents.iter().all(|it| it.0 != *variable) {
                let zero = float(0.0, &leaf, span);
                let zeros =
                    Expr { kind: ExprKind::Splat(Box::new(zero)), ty: table.ty.clone(), span };
                tangents.push((*variable, self.table(&format!("table_d{variable}"), zeros)));
            }
        }
        self.emit(StmtKind::Assign { place: at(&table), value: word.value.clone() }, span);
        for (variable, place) in &tangents {
            let zero = float(0.0, &leaf, span);
            let value = word.tangents.get(variable).cloned().unwrap_or(zero);
            self.emit(StmtKind::Assign { place: at(place), value }, span);
        }
        let steps = parts(self.module, &table.ty, span);
        let loaded = steps.into_iter().map(|(step, ty)| {
            let load = |place: &Place| place.inside(step.clone(), ty.clone()).load();
            let each = tangents.iter().map(|(variable, it)| (*variable, load(it)));
            Value::Leaf(Word { value: load(&table), tangents: each.collect::<Tangents>() })
        });
        Ok(loaded.collect())
    }

    /// Writes parts to locals: the values, and the derivatives by each variable.
    fn tables(&mut self, ty: &Type, all: &[Value], span: Span) -> (Place, Vec<(u32, Place)>) {
        let ty = match ty {
            Type::Slice(element) => Type::Array { element: element.clone(), len: all.len() as u32 },
            other => other.clone(),
        };
        let words: Vec<Word> = all.iter().flat_map(|it| it.clone().words(self.module)).collect();
        let values = self.aggregate(&ty, words.iter().map(|word| word.value.clone()));
        let table = self.table("table", values);
        let mut variables: Vec<u32> =
            words.iter().flat_map(|word| word.tangents.keys().copied()).collect();
        variables.sort_unstable();
        variables.dedup();
        let tangents = variables.into_iter().map(|variable| {
            let of = |word: &Word| {
                let zero = float(0.0, &word.value.ty, span);
                word.tangents.get(&variable).cloned().unwrap_or(zero)
            };
            let values: Vec<Expr> = words.iter().map(of).collect();
            let values = self.aggregate(&ty, values.into_iter());
            (variable, self.table(&format!("table_d{variable}"), values))
        });
        let tangents = tangents.collect();
        (table, tangents)
    }

    fn table(&mut self, name: &str, value: Expr) -> Place {
        let (ty, span) = (value.ty.clone(), value.span);
        let local = self.declare(name, &ty, span);
        self.emit(StmtKind::Let { local, value: Some(value) }, span);
        Place::local(local, ty, span)
    }

    /// Returns a value for a local that has none yet.
    fn zeros(&self, ty: &Type, span: Span) -> Value {
        if ty.is_word() {
            return Value::Leaf(Word::constant(Expr::literal(0, ty.clone(), span)));
        }
        let parts = parts(self.module, ty, span);
        Value::Parts(parts.iter().map(|(_, ty)| self.zeros(ty, span)).collect())
    }

    fn part(&self, place: &Place, at: usize, span: Span) -> Result<Value> {
        let index = Expr::usize(at as u64, span);
        let (step, ty) = match &place.ty {
            Type::Slice(element) => (Step::Index(index), (**element).clone()),
            ty => parts(self.module, ty, span).get(at).cloned().ok_or_else(|| outside(span))?,
        };
        Ok(Value::at(place.inside(step, ty)))
    }

    fn part_type(&self, ty: &Type, at: usize) -> Type {
        match ty {
            Type::Slice(element) | Type::Array { element, .. } => (**element).clone(),
            Type::Matrix { element, .. } => Type::Scalar(*element),
            Type::Struct(id) => {
                let fields = &self.module.structs[id.index()].fields;
                fields.get(at).map_or(Type::Unit, |field| field.ty.clone())
            }
            _ => Type::Unit,
        }
    }
}

/// Returns the type of the elements from one on.
fn slice(ty: &Type) -> Type {
    match ty {
        Type::Array { element, .. } | Type::Slice(element) => Type::Slice(element.clone()),
        Type::Matrix { element, .. } => Type::Slice(Box::new(Type::Scalar(*element))),
        other => other.clone(),
    }
}
