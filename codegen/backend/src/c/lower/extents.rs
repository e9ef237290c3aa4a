//! Lengths of local arrays, by the author's named constants.
//!
//! No Rust type contains the name. A local gets it from the parameter to which it is passed as a whole; otherwise from the
//! values of the same shape that it is computed from, or from the loop that writes its elements. Loops over a whole array
//! use it as their end.

use std::collections::BTreeMap;

use bessemer_ir::visit::{Visit, walk_expr, walk_stmt};
use bessemer_ir::{
    Argument, ConstId, Expr, ExprKind, Function, FunctionId, LocalId, Module, Place, Step, Stmt,
    StmtKind, Type,
};

use super::Lower;
use crate::c::names::Names;
use crate::c::signature::Signature;
use crate::c::sizes;
use crate::c::tree::Expr as CExpr;

impl Lower<'_> {
    /// Returns the length of an array: its named constant if it is a variable, a parameter or a field with one, else the
    /// number. The length of a matrix may be a product, `4U * MOTORS`.
    pub(super) fn extent(&mut self, array: &CExpr, count: u32) -> CExpr {
        let sizes = match array {
            CExpr::Name(name) => self.named_extent(name),
            _ => self.extent_of_field(array),
        };
        let sizes = sizes.unwrap_or_default();
        let (module, names) = (self.context.module, self.context.names);
        let shared = |at: usize| {
            let id = sizes.get(at).copied().flatten()?;
            let value = u32::try_from(module.consts[id.index()].words[0]).ok()?;
            Some((id, value, names.shared_constant(id)?))
        };
        let all = [shared(0), shared(1)];
        let factors = match all {
            _ if let Some(one) = all.into_iter().flatten().find(|it| it.1 == count) => {
                vec![Some(one)]
            }
            [Some(rows), Some(cols)] if rows.1.checked_mul(cols.1) == Some(count) => all.to_vec(),
            [Some((_, size, _)), None] | [None, Some((_, size, _))]
                if count > 0 && count.checked_rem(size) == Some(0) =>
            {
                all.to_vec()
            }
            _ => vec![None],
        };
        let known = factors.iter().flatten().map(|(_, size, _)| size).product::<u32>().max(1);
        self.uses.consts.extend(factors.iter().flatten().map(|(id, ..)| *id));
        let factor = |it: Option<(ConstId, u32, &str)>| match it {
            Some((.., name)) => CExpr::name(name),
            None => CExpr::name(format!("{}U", count / known)),
        };
        let product = factors.into_iter().map(factor).reduce(|a, b| CExpr::binary("*", a, b));
        product.unwrap_or_else(|| CExpr::name(format!("{count}U")))
    }

    fn named_extent(&self, array: &str) -> Option<Vec<Option<ConstId>>> {
        let param = || self.signature.params.iter().find(|param| param.name == array);
        self.declared.get(array).or_else(|| Some(&param()?.sizes)).cloned()
    }

    /// Returns the constants of the lengths of a field.
    fn extent_of_field(&self, array: &CExpr) -> Option<Vec<Option<ConstId>>> {
        let (CExpr::Member(of, name) | CExpr::Arrow(of, name)) = array else { return None };
        let Type::Struct(id) = self.type_in_c(of)? else { return None };
        let at = self.context.names.structs[id.index()].fields.iter().position(|it| it == name)?;
        let module = self.context.module;
        Some(sizes::sizes(module, &module.structs[id.index()].fields.get(at)?.given))
    }

    /// Returns the type of a place in C, or of what a pointer leads to.
    fn type_in_c(&self, place: &CExpr) -> Option<Type> {
        match place {
            CExpr::Name(name) => {
                let result = self.signature.params.get(self.function.params as usize);
                if result.is_some_and(|result| result.name == *name) {
                    return Some(self.function.result.clone());
                }
                let is_bound = |at: &usize| {
                    self.bindings[*at].as_ref().is_some_and(|binding| binding.name == *name)
                };
                // The last one: an earlier one of the same name is no longer visible.
                let at = (0..self.bindings.len()).rev().find(is_bound)?;
                Some(self.function.locals[at].ty.clone())
            }
            CExpr::Unary("*" | "&", of) => self.type_in_c(of),
            CExpr::Index(of, _) => match self.type_in_c(of)? {
                Type::Array { element, .. } | Type::Slice(element) => Some(*element),
                _ => None,
            },
            CExpr::Member(of, name) | CExpr::Arrow(of, name) => {
                let Type::Struct(id) = self.type_in_c(of)? else { return None };
                let fields = &self.context.names.structs[id.index()].fields;
                let at = fields.iter().position(|it| it == name)?;
                Some(self.context.module.structs[id.index()].fields.get(at)?.ty.clone())
            }
            _ => None,
        }
    }
}

/// Returns the constants of the lengths of a function's locals. They come from the parameters to which the locals are
/// passed as a whole, unless two of these differ.
pub(super) fn of_locals(
    names: &Names,
    module: &Module,
    id: FunctionId,
) -> BTreeMap<LocalId, Vec<Option<ConstId>>> {
    let (function, own) = (&module.functions[id.index()], names.signature(id));
    let mut lengths = Lengths {
        names,
        module,
        function,
        own,
        found: BTreeMap::new(),
        ends: BTreeMap::new(),
        alike: BTreeMap::new(),
    };
    lengths.block(&function.body);
    let Lengths { found, alike, .. } = lengths;
    let mut all: BTreeMap<_, _> =
        found.iter().filter_map(|(local, sizes)| Some((*local, sizes.clone()?))).collect();
    for (local, sizes) in alike {
        if !found.contains_key(&local) {
            all.insert(local, sizes);
        }
    }
    all
}

/// Visitor that finds locals passed to parameters whose lengths have names.
struct Lengths<'l> {
    names: &'l Names,
    module: &'l Module,
    function: &'l Function,
    /// Signature of the function.
    own: &'l Signature,
    /// Constants of each local; none if two parameters disagree.
    found: BTreeMap<LocalId, Option<Vec<Option<ConstId>>>>,
    /// Constants at which the visible loops end, by their counters.
    ends: BTreeMap<LocalId, ConstId>,
    /// Constants of locals that are computed element by element from others, or by such a loop.
    alike: BTreeMap<LocalId, Vec<Option<ConstId>>>,
}

impl Lengths<'_> {
    fn note(&mut self, local: LocalId, callee: FunctionId, parameter: usize) {
        let Some(param) = self.names.signature(callee).params.get(parameter) else { return };
        let named = param.sizes.iter().any(Option::is_some);
        if !named || self.function.local(local).ty != param.ty {
            return;
        }
        let found = self.found.entry(local).or_insert_with(|| Some(param.sizes.clone()));
        if found.as_ref() != Some(&param.sizes) {
            *found = None;
        }
    }

    /// Returns the constants of the lengths of a place.
    fn of_place(&self, place: &Place) -> Option<Vec<Option<ConstId>>> {
        let sizes = match place.steps.split_last() {
            None => {
                let known = self.found.get(&place.root).cloned().flatten();
                let known = known.or_else(|| self.alike.get(&place.root).cloned());
                let of_parameter = || {
                    let index = place.root.index();
                    let mut params = self.own.params.iter().take(self.function.params as usize);
                    params.nth(index).map(|param| param.sizes.clone())
                };
                known.or_else(of_parameter)?
            }
            Some((Step::Field(field), before)) => {
                let mut ty = self.function.local(place.root).ty.clone();
                for step in before {
                    ty = self.module.step_type(&ty, step)?;
                }
                let Type::Struct(id) = ty else { return None };
                let field = self.module.structs[id.index()].fields.get(*field as usize)?;
                sizes::sizes(self.module, &field.given)
            }
            Some(_) => return None,
        };
        sizes.iter().any(Option::is_some).then_some(sizes)
    }

    /// Returns the constants of the lengths of a value that has the shape of a place.
    fn of_value(&self, value: &Expr) -> Option<Vec<Option<ConstId>>> {
        match &value.kind {
            ExprKind::Load(place) => self.of_place(place),
            ExprKind::Routine(_, operands) => {
                let mut alike = operands.iter().filter(|operand| operand.ty == value.ty);
                alike.find_map(|operand| self.of_value(operand))
            }
            _ => None,
        }
    }

    /// Records the constants of a value that a local gets as a whole.
    fn value(&mut self, local: LocalId, value: &Expr) {
        if value.ty.is_array()
            && let Some(sizes) = self.of_value(value)
        {
            self.alike.entry(local).or_insert(sizes);
        }
    }

    /// Records the constant at which a loop ends that writes elements of an array.
    fn element(&mut self, place: &Place) {
        let ty = &self.function.local(place.root).ty;
        let (len, index) = match (ty, place.steps.as_slice()) {
            (Type::Array { len, .. }, [Step::Index(index)]) => (*len, index),
            (
                Type::Matrix { rows, cols: 1, .. },
                [Step::Index(index) | Step::Element(index, _)],
            ) => (*rows, index),
            _ => return,
        };
        let ExprKind::Load(counter) = &index.kind else { return };
        let Some(end) = self.ends.get(&counter.root).filter(|_| counter.steps.is_empty()) else {
            return;
        };
        if self.module.consts[end.index()].words == [u64::from(len)] {
            self.alike.entry(place.root).or_insert(vec![Some(*end)]);
        }
    }

    /// Records that a call's result is passed by a pointer after the other parameters.
    fn result(&mut self, local: LocalId, value: &Expr) {
        if let ExprKind::Call(callee, arguments) = &value.kind {
            self.note(local, *callee, arguments.len());
        }
    }
}

impl Visit for Lengths<'_> {
    fn stmt(&mut self, stmt: &Stmt) {
        match &stmt.kind {
            StmtKind::Let { local, value: Some(value) } => {
                self.result(*local, value);
                self.value(*local, value);
            }
            StmtKind::Assign { place: Place { root, steps, .. }, value } if steps.is_empty() => {
                self.result(*root, value);
            }
            StmtKind::Assign { place, .. } => self.element(place),
            StmtKind::For { variable, to, inclusive: false, .. } => {
                if let ExprKind::Const(end) = to.kind {
                    self.ends.insert(*variable, end);
                }
            }
            _ => {}
        }
        walk_stmt(self, stmt);
    }

    fn expr(&mut self, expr: &Expr) {
        if let ExprKind::Call(callee, arguments) = &expr.kind {
            for (at, argument) in arguments.iter().enumerate() {
                let place = match argument {
                    Argument::RefMut(place) => place,
                    Argument::Ref(Expr { kind: ExprKind::Load(place), .. }) => place,
                    Argument::Ref(_) | Argument::Value(_) => continue,
                };
                if place.steps.is_empty() {
                    self.note(place.root, *callee, at);
                }
            }
        }
        walk_expr(self, expr);
    }
}
