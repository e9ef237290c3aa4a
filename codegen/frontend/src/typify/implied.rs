//! Functions without a call in the source: an author's `==`, the conversion of an error by `?`, the `next` of an
//! iterator.
//!
//! The types select the function. Its definition may follow its use, so it is lowered at the first use.

use bessemer_ir::tree::visit::Walk;
use bessemer_ir::tree::{self, Site};
use bessemer_ir::{Argument, CompareOp, Expr, ExprKind, FunctionId, LogicOp, Mode, StructId, Type};

use super::literal::is_unsuffixed_float;
use super::lowering::Lowering;
use crate::diagnostic::Place;

use super::{Context, Problem, Result, function, problem, refusals, refused, struct_of};

impl<'a> Context<'a> {
    /// Returns the function of a path, lowered now if it was not before; none if it was refused, which is reported.
    pub(super) fn function(&mut self, path: &str) -> Option<FunctionId> {
        if let Some(function) = self.calls.waiting.remove(path) {
            self.calls.underway.push(&function.path);
            let lowered = function::lower(self, function);
            self.calls.underway.pop();
            match lowered {
                Ok(lowered) => {
                    let id = self.add(lowered);
                    self.calls.lowered.insert(function.path.clone(), id);
                }
                Err(problem) => self.tell_in(function, problem),
            }
        }
        self.calls.lowered.get(path).copied()
    }

    /// Adds a function to the module.
    pub(super) fn add(&mut self, lowered: function::Lowered) -> FunctionId {
        let id = FunctionId(self.module.functions.len() as u32);
        self.calls.absent.insert(id, lowered.absent);
        self.calls.given_back.insert(id, lowered.given_back);
        self.module.functions.push(lowered.function);
        id
    }

    /// Reports a problem in a function. For an instance of a generic function it also shows a call of that instance, which
    /// chose the types.
    fn tell_in(&mut self, function: &tree::Function, problem: Problem) {
        let is_new = !problem.message.is_empty();
        self.tell(&function.file, problem);
        let call = if function.generics.is_empty() { None } else { self.call_of(&function.path) };
        if let (true, Some(last)) = (is_new, self.told.last_mut()) {
            last.also.extend(call);
        }
    }

    /// Returns the first place of a call of a function.
    fn call_of(&self, path: &str) -> Option<Place> {
        let is_called = |callee: &tree::Callee| matches!(callee, tree::Callee::Function(called) if called == path);
        let callers = self.package.functions.iter().filter(|it| it.path != path);
        callers.filter(|it| it.callees.iter().any(is_called)).find_map(|caller| {
            let mut sites = Vec::new();
            caller.tree.body.each_expr(|expr| {
                if let tree::ExprKind::Call(callee, _) = &expr.kind
                    && caller.callees.get(*callee as usize).is_some_and(is_called)
                {
                    sites.push(expr.site);
                }
            });
            let Site(line, column) = *sites.first()?;
            Some(Place {
                file: caller.file.clone(),
                start: (line, column),
                label: "called here with these types".to_owned(),
                ..Place::default()
            })
        })
    }

    /// Records the implementations of traits that authors wrote for their types.
    pub(super) fn note_implied(&mut self, implied: &'a [tree::Implied]) {
        for it in implied {
            match (it.of.as_str(), &it.owner) {
                ("From" | "PartialOrd" | tree::AS, _) => self.implied.between.push(it),
                ("PartialEq", _) if it.owner != it.other => self.implied.between.push(it),
                ("PartialEq", tree::Ty::Named(path)) => {
                    // Of what holds nothing no comparison is taken.
                    let ty = self.types.by_path.get(path).filter(|ty| **ty != Type::Unit);
                    if let Some(ty) = ty.cloned() {
                        self.note(&ty).own_equality = Some(&it.function);
                    }
                }
                ("Index" | "IndexMut", _) => self.note_indexing(it),
                (tree::ITERATOR, _) => self.note_iterator(it),
                _ => {}
            }
        }
    }
}

impl Context<'_> {
    /// Returns true if an author wrote an `==` of any type.
    pub(super) fn has_own_equality(&self) -> bool {
        self.types.known.values().any(|known| known.own_equality.is_some())
    }

    /// Returns true if a call compares values by an author's `==`.
    pub(super) fn calls_own_equality(&self, expr: &Expr) -> bool {
        match &expr.kind {
            ExprKind::Call(_, arguments) => arguments.iter().any(|it| match it {
                Argument::Value(value) | Argument::Ref(value) => self.compares_by_own(&value.ty),
                Argument::RefMut(_) => false,
            }),
            _ => false,
        }
    }

    /// Returns true if `==` of a type calls an author's `==`.
    fn compares_by_own(&self, ty: &Type) -> bool {
        self.known(ty).own_equality.is_some()
            || match ty {
                Type::Struct(id) => {
                    self.fields(*id).iter().any(|field| self.compares_by_own(&field.ty))
                }
                Type::Array { element, .. } | Type::Slice(element) => self.compares_by_own(element),
                _ => false,
            }
    }
}

impl<'a> Context<'a> {
    /// Returns the functions of a trait for two types, each with these types.
    fn between(&mut self, of: &str, site: Site) -> Result<Vec<(Type, Type, &'a str)>> {
        let mut found = Vec::new();
        for it in self.implied.between.clone() {
            if it.of == of {
                let [one, other] = [&it.owner, &it.other].map(|ty| self.pointee(ty, site));
                found.push((one?, other?, it.function.as_str()));
            }
        }
        Ok(found)
    }

    /// Returns the type of an unsuffixed literal that is compared with a value: the value's, or the number with which its
    /// author compares it.
    pub(super) fn literal_beside(&mut self, ty: &Type, literal: &tree::Expr) -> Result<Type> {
        if ty.is_word() {
            return Ok(ty.clone());
        }
        let is_float = is_unsuffixed_float(literal);
        let fits = |number: &Type| match is_float {
            true => number.as_float().is_some(),
            false => number.as_int().is_some(),
        };
        let mut compared = self.between("PartialEq", literal.site)?;
        compared.extend(self.between("PartialOrd", literal.site)?);
        let beside = compared.iter().find_map(|(one, other, _)| match (one, other) {
            (one, number) | (number, one) if one == ty && fits(number) => Some(number),
            _ => None,
        });
        Ok(beside.unwrap_or(ty).clone())
    }
}

/// Returns the function that converts an operand to a type by `as`, if a type of the library is involved.
pub(super) fn conversion(
    lowering: &mut Lowering<'_, '_>,
    operand: &tree::Expr,
    ty: &Type,
) -> Result<Option<tree::Callee>> {
    if lowering.cx.implied.between.iter().all(|it| it.of != tree::AS) {
        return Ok(None);
    }
    let from = lowering.type_of_value(operand)?;
    let all = lowering.cx.between(tree::AS, operand.site)?;
    let found = all.into_iter().find(|(to, other, _)| to == ty && *other == from);
    Ok(found.map(|(.., path)| tree::Callee::Function(path.to_owned())))
}

/// Lowers a comparison of two types by the author's implementation; none if there is none.
pub(super) fn own_comparison(
    lowering: &mut Lowering<'_, '_>,
    op: CompareOp,
    (left, right): (&Expr, &Expr),
    site: Site,
) -> Result<Option<Expr>> {
    let equality = matches!(op, CompareOp::Eq | CompareOp::Ne);
    let all = lowering.cx.between(if equality { "PartialEq" } else { "PartialOrd" }, site)?;
    let found = all.iter().find(|(one, other, _)| *one == left.ty && *other == right.ty);
    let Some((.., path)) = found else { return Ok(None) };
    let sides = [left.clone(), right.clone()];
    if equality {
        let equal = lowering.call_implied(path, sides, Type::BOOL, site)?;
        return Ok(Some(if op == CompareOp::Ne { equal.negated() } else { equal }));
    }
    let id = lowering.function_at(path, site)?;
    let order = lowering.cx.module.functions[id.index()].result.clone();
    let call = lowering.call_implied(path, sides, order.clone(), site)?;
    let place = lowering.hold(call);
    let id = struct_of(&order, site, "an `Option<Ordering>`")?;
    let (there, order) = (lowering.tag_is(&place, id, 1), lowering.part(&place, id, 1));
    // Less, Equal and Greater are the words 0, 1 and 2.
    let (op, word) = match op {
        CompareOp::Lt => (CompareOp::Eq, 0),
        CompareOp::Le => (CompareOp::Ne, 2),
        CompareOp::Gt => (CompareOp::Eq, 2),
        _ => (CompareOp::Ne, 0),
    };
    let span = lowering.span(site);
    let word = Expr::literal(word, order.ty.clone(), span);
    let decided = Expr::compare(op, order.load(), word).at(span);
    Ok(Some(Expr::logic(LogicOp::And, there, decided)))
}

impl Lowering<'_, '_> {
    /// Returns the callee at a path, or an error that says why there is none.
    pub(super) fn function_at(&mut self, path: &str, site: Site) -> Result<FunctionId> {
        match self.cx.function(path) {
            Some(id) => Ok(id),
            // Calls by name that come back were told by the builder.
            None if !self.cx.refused && self.cx.calls.underway.contains(&path) => problem(
                site,
                format!("`{path}` calls itself through an operator, a conversion or a loop"),
                "write a loop with a bound, or compare the parts",
            ),
            // It was refused, and that was told.
            None => problem(site, "", ""),
        }
    }

    /// Lowers `left == right` by the author's implementation; none if the comparison is part by part.
    pub(super) fn own_equality(
        &mut self,
        left: &Expr,
        right: &Expr,
        site: Site,
    ) -> Result<Option<Expr>> {
        let Some(path) = self.cx.known(&left.ty).own_equality else { return Ok(None) };
        self.call_implied(path, [left.clone(), right.clone()], Type::BOOL, site).map(Some)
    }

    /// Returns the error with which `?` leaves, converted to the error type of the function's result; none if it is
    /// zero-sized.
    pub(super) fn converted_error(
        &mut self,
        error: Option<Expr>,
        wanted: Option<&Type>,
        (of, result): (StructId, StructId),
        site: Site,
    ) -> Result<Option<Expr>> {
        let mut found = Vec::new();
        match (&error, wanted) {
            (Some(error), Some(wanted)) if error.ty == *wanted => return Ok(Some(error.clone())),
            (Some(Expr { ty: Type::Scalar(_), .. }), Some(Type::Scalar(_))) => {
                let span = self.span(site);
                return Ok(error.zip(wanted).map(|(error, wanted)| error.cast(wanted).at(span)));
            }
            (Some(error), Some(wanted)) => {
                let all = self.cx.between("From", site)?;
                let meant =
                    all.into_iter().filter(|(to, from, _)| to == wanted && *from == error.ty);
                found.extend(meant.map(|(.., path)| path));
            }
            // Types that hold nothing are told apart by their names alone.
            _ => {
                let [from, to] = [of, result].map(|id| self.cx.known_of(id).error.as_ref());
                if from == to {
                    return Ok(None);
                }
                if from == Some(&tree::Ty::Unit) {
                    return refused(site, refusals::ERROR_OF_NOTHING);
                }
                let meant = |it: &&&tree::Implied| {
                    it.of == "From" && Some(&it.owner) == to && Some(&it.other) == from
                };
                found.extend(
                    self.cx.implied.between.iter().find(meant).map(|it| it.function.as_str()),
                );
            }
        }
        let [path] = found.as_slice() else {
            return refused(site, refusals::ERROR_CONVERSION);
        };
        let call = self.call_implied(path, error, wanted.cloned().unwrap_or(Type::Unit), site)?;
        if wanted.is_some() {
            return Ok(Some(call));
        }
        self.discard(call);
        Ok(None)
    }

    /// Returns a call of a function without a call in the source.
    pub(super) fn call_implied(
        &mut self,
        path: &str,
        values: impl IntoIterator<Item = Expr>,
        ty: Type,
        site: Site,
    ) -> Result<Expr> {
        let id = self.function_at(path, site)?;
        let parameters = self.cx.module.functions[id.index()].parameters();
        let passed = parameters.iter().zip(values).map(|(parameter, value)| match parameter.mode {
            Mode::Value => Argument::Value(value),
            _ => Argument::Ref(value),
        });
        let arguments = passed.collect();
        self.node(ExprKind::Call(id, arguments), ty, site)
    }
}
