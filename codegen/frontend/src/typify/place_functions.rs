//! Functions that return references, `fn axis_mut(&mut self, i: usize) -> &mut Axis`, and authors' implementations of
//! `Index`.
//!
//! They are inlined: a reference lowers to a place, never to a pointer, so nothing is copied and the place can be
//! written. A function that selects one of several places and returns a shared reference is a C function that returns
//! a copy, since nothing writes the referent during the borrow. One that returns a mutable reference returns the
//! index of the element.

use bessemer_ir::tree::visit::{self, VisitMut, Walk};
use bessemer_ir::tree::{self, ExprKind as Tree, Site, Ty};
use bessemer_ir::{Expr, Place, Type};

use super::callee::Called;
use super::closure_args::UNTIL_NAMED;
use super::lowering::Lowering;
use super::rewrite::Placed;
use super::slots::result_of;
use super::value::Value;
use super::{Context, Needed, Problem, Result, refusals, refused};

/// Returns true if a function returns a mutable reference to a place, and false for a shared one. It is `None` if the
/// function returns a value or a slice.
pub(super) fn lends(function: &tree::Function) -> Option<bool> {
    match result_of(function) {
        Some(Ty::Ref(inner, mutable)) if !matches!(**inner, Ty::Slice(_)) => Some(*mutable),
        _ => None,
    }
}

/// Returns true if a statement only names parts of the returned place. It does not select the place, and does nothing
/// else that needs a C function.
fn is_named_first(stmt: &tree::Stmt) -> bool {
    match stmt {
        tree::Stmt::Let { .. } => true,
        tree::Stmt::Apart { otherwise, .. } => otherwise.is_none(),
        tree::Stmt::Expr(expr) => matches!(expr.kind, Tree::Assert(..)),
    }
}

/// Visitor that makes mutable borrows shared.
struct Read;

impl VisitMut for Read {
    fn expr(&mut self, expr: &mut tree::Expr) {
        if let Tree::Ref(mutable, _) = &mut expr.kind {
            *mutable = false;
        }
        visit::walk_expr_mut(self, expr);
    }
}

/// Returns true if two functions differ only in the mutability of their references.
fn same_meaning(one: &tree::Function, other: &tree::Function) -> bool {
    let names = |it: &tree::Function| it.tree.params.iter().map(|it| it.name.clone()).collect();
    let called = |it: &tree::Function| (it.callees.clone(), it.constants.clone());
    let bare = |it: &tree::Function| {
        let mut body = it.tree.body.clone();
        Placed(Site::default()).block(&mut body);
        Read.block(&mut body);
        body
    };
    let (one_names, other_names): (Vec<_>, Vec<_>) = (names(one), names(other));
    one_names == other_names && called(one) == called(other) && bare(one) == bare(other)
}

impl<'a> Context<'a> {
    /// Records an author's implementation of `Index`.
    pub(super) fn note_indexing(&mut self, it: &'a tree::Implied) {
        if let Ty::Named(path) = &it.owner
            && let Some(owner) = self.types.by_path.get(path)
        {
            self.implied.indexing.push((owner.clone(), it));
        }
    }

    /// Records the functions that return references and are inlined at each call.
    pub(super) fn note_lending(&mut self, functions: &[&'a tree::Function]) {
        for function in functions {
            let body = &function.tree.body;
            let holds_nothing = result_of(function).is_some_and(|ty| self.is_nothing(ty));
            let stands = match lends(function) {
                Some(written) if !holds_nothing => {
                    (written || body.stmts.iter().all(is_named_first))
                        && !body.any_expr(|it| matches!(it.kind, Tree::Return(_)))
                        && body.tail.as_deref().is_some_and(|tail| self.is_place(function, tail))
                }
                _ => false,
            };
            let asked = &function.tree.attributes;
            if stands && (asked.name.is_some() || asked.section.is_some()) {
                let problem = Problem {
                    site: function.tree.site,
                    message: "a function that returns `&mut` is inlined in C, so it cannot have a name or a section".into(),
                    help: "remove them".into(),
                };
                self.tell(&function.file, problem);
            } else if stands {
                self.calls.lending.insert(&function.path);
            }
        }
    }

    /// Returns true if a function is inlined because it returns a reference.
    pub(super) fn lends_place(&self, function: &tree::Function) -> bool {
        self.calls.lending.contains(function.path.as_str())
    }

    fn is_place(&self, function: &tree::Function, expr: &tree::Expr) -> bool {
        match &expr.kind {
            Tree::Local(_) => true,
            Tree::Ref(_, of) | Tree::Deref(of) | Tree::Field(of, _) | Tree::Index(of, _) => {
                self.is_place(function, of)
            }
            Tree::Call(callee, _) => match function.callees.get(*callee as usize) {
                Some(tree::Callee::Function(path)) => {
                    self.calls.all.get(path.as_str()).copied().and_then(lends).is_some()
                }
                // `self.last.as_mut().unwrap()`.
                _ => lends(function) == Some(true),
            },
            _ => false,
        }
    }
}

impl<'a> Lowering<'a, '_> {
    /// Returns the place to which a call's result refers; none if it is a value.
    pub(super) fn lent_place(&mut self, expr: &tree::Expr) -> Result<Option<Place>> {
        match self.called(expr) {
            Some(called) => self.lent_by(called, expr),
            None => self.in_option(expr),
        }
    }

    /// Returns true if a call's result is a `&mut T` that a C function selects.
    pub(super) fn gives_element(&self, expr: &tree::Expr) -> bool {
        let called = self.called(expr).filter(|(it, _)| it.tree.role != tree::Role::Expanded);
        called.is_some_and(|(it, _)| lends(it) == Some(true) && !self.cx.lends_place(it))
    }

    /// Returns the place to which the result of a called function refers; none if it is a value.
    pub(super) fn lent_by(
        &mut self,
        called: Called<'a, '_>,
        expr: &tree::Expr,
    ) -> Result<Option<Place>> {
        if !self.cx.lends_place(called.0) {
            return Ok(None);
        }
        let place = self.placed(called, expr.site)?;
        if let Some(slot) = expr.slot {
            let rustc = self.refers_to(slot, expr.site)?;
            self.agree(&place.ty, &rustc, expr.site)?;
        }
        Ok(Some(place))
    }

    /// Returns the place at an author's `Index`; none if the type has none.
    pub(super) fn own_element(
        &mut self,
        owner: &Type,
        operands: [&tree::Expr; 2],
        site: Site,
    ) -> Result<Option<Place>> {
        let Some(function) = self.indexed_by(owner, operands[1], site)? else { return Ok(None) };
        let operands = operands.map(tree::Expr::clone);
        if self.cx.lends_place(function) {
            return self.placed((function, &operands), site).map(Some);
        }
        let id = self.function_at(&function.path, site)?;
        let expr = tree::Expr::plain(Tree::Bool(false), site);
        let value = self.call_function(id, &operands, &expr)?;
        Ok(Some(self.hold(value)))
    }

    /// Returns the element type of an author's `Index`.
    pub(super) fn own_element_type(
        &mut self,
        owner: &Type,
        index: &tree::Expr,
        site: Site,
    ) -> Result<Option<Type>> {
        let Some(function) = self.indexed_by(owner, index, site)? else { return Ok(None) };
        result_of(function).map(|ty| self.cx.pointee(ty, site)).transpose()
    }

    /// Returns the function of an author's `Index` for this type of index.
    fn indexed_by(
        &mut self,
        owner: &Type,
        index: &tree::Expr,
        site: Site,
    ) -> Result<Option<&'a tree::Function>> {
        let all = self.cx.implied.indexing.iter().filter(|(of, _)| of == owner);
        let all: Vec<_> = all.map(|(_, it)| *it).collect();
        let several = all.iter().any(|it| it.other != all[0].other);
        let mut found = [None, None];
        for it in all {
            if !several || self.is_of(index, &it.other)? {
                let known = &mut found[usize::from(it.of == "IndexMut")];
                *known = known.or(self.cx.calls.all.get(it.function.as_str()).copied());
            }
        }
        match found {
            [Some(read), Some(written)] if !same_meaning(read, written) => {
                refused(site, refusals::TWO_INDEXINGS)
            }
            [Some(read), Some(written)] if !self.cx.lends_place(read) => Ok(Some(written)),
            [read, _] => Ok(read),
        }
    }

    /// Returns true if an index has this type. A tuple or a literal has no slot from rustc.
    fn is_of(&mut self, index: &tree::Expr, ty: &Ty) -> Result<bool> {
        match (&index.kind, ty) {
            (Tree::Tuple(parts), ty) if index.slot.is_none() => {
                Ok(matches!(ty, Ty::Tuple(types) if types.len() == parts.len()))
            }
            (Tree::Int(_, None), ty) => Ok(matches!(ty, Ty::Scalar(bessemer_ir::Scalar::Int(_)))),
            _ => Ok(self.cx.pointee(ty, index.site)? == self.type_of_value(index)?),
        }
    }

    /// Inlines a function, and returns the place to which its result refers.
    fn placed(&mut self, called: Called<'a, '_>, site: Site) -> Result<Place> {
        self.expanded(called, site, |inner, tail| {
            let tail = tail.or_refused(called.0.tree.site, refusals::LENDS_NOTHING)?;
            inner.place(tail)?.or_refused(tail.site, refusals::LENT_PLACE)
        })
    }

    /// Returns the meaning of a parameter: an alias of the borrowed place, or a value that does not change.
    pub(super) fn given(
        &mut self,
        (name, mutable): (&str, bool),
        ty: &Ty,
        argument: &tree::Expr,
    ) -> Result<Value> {
        if self.holds_nothing(argument) {
            self.effect(argument)?;
            return Ok(Value::Nothing);
        }
        if let (Tree::Tuple(values), Ty::Tuple(types), false) = (&argument.kind, ty, mutable) {
            // It is taken apart where it stands, and its parts have their names there.
            let own = format!("{UNTIL_NAMED}{name}");
            let parts = values.iter().zip(types).map(|(it, ty)| self.given((&own, false), ty, it));
            let parts = parts.collect::<Result<_>>()?;
            return Ok(Value::Tuple(parts, self.cx.value_type(ty, argument.site).ok()));
        }
        if let Ty::Ref(inner, written) = ty {
            if let Ty::Slice(_) = **inner
                && !mutable
            {
                return Ok(Value::Slice(Box::new(self.sliced(argument)?)));
            }
            if let Some(part) = self.submatrix(argument)? {
                return Ok(Value::Submatrix(Box::new(part)));
            }
            if let Some(mut place) = self.place(argument)? {
                if !written && self.is_loan(&place) {
                    place = self.hold_copy(name, place);
                }
                return Ok(Value::Place(place));
            }
            // A value of its own, `table.clone()` too.
            let ty = self.cx.value_type(inner, argument.site)?;
            let value = self.value(argument, Some(&ty))?;
            return Ok(self.own(name, value, written.then_some(&**inner)));
        }
        let lowered = self.cx.value_type(ty, argument.site)?;
        let value = self.value(argument, Some(&lowered))?;
        let mutable = mutable || self.cx.holds_iterator(&lowered);
        Ok(self.own(name, value, mutable.then_some(ty)))
    }

    /// Declares a local with this value. With `changing`, rustc's type, it may be written.
    pub(super) fn own(&mut self, name: &str, value: Expr, changing: Option<&Ty>) -> Value {
        self.naming_as("", |inner| match changing {
            Some(ty) => {
                let place = inner.mutable_place(name, value);
                inner.locals.note_assigned(place.root, ty.clone());
                Value::Place(place)
            }
            None => inner.constant(name, value),
        })
    }
}
