//! Functions that take closures: each combination of closures has a copy of the function.
//!
//! Instead of the closure the copy takes the variables that the closure uses: words that it only reads by value, all
//! others by reference. The body of the closure replaces each call of it.

use std::borrow::Cow;
use std::collections::BTreeSet;
use std::rc::Rc;

use bessemer_ir::tree::visit::Walk;
use bessemer_ir::tree::{self, NO_SLOT, Site, Ty};
use bessemer_ir::{
    Argument, Expr, ExprKind, Function, FunctionId, Local, LocalId, Mode, Place, Role, Type,
};

use super::lowering::{Closure, Lowering, Scope, UNNAMED, Way, local_since};
use super::value::Value;
use super::words;
use super::{Needed, Result, names, refusals, refused};
use bessemer_ir::effects;

impl<'a> Lowering<'a, '_> {
    /// Lowers a call of a function that takes closures.
    pub(super) fn call_handing(
        &mut self,
        template: &'a tree::Function,
        arguments: &[tree::Expr],
        expr: &tree::Expr,
    ) -> Result<Expr> {
        let (mut closures, mut plain) = (Vec::new(), Vec::new());
        for (param, argument) in template.tree.params.iter().zip(arguments) {
            match param.closure {
                true => closures.push((param.name.as_str(), self.handed(argument)?)),
                false => plain.push(argument.clone()),
            }
        }
        let (id, captured) = self.specialised(template, closures, expr.site)?;
        self.call_with(id, &plain, captured, expr)
    }

    /// Returns the closure that an argument is, with its captured variables.
    fn handed(&mut self, argument: &tree::Expr) -> Result<Closure<'a>> {
        let closure = self.closure_given(argument)?;
        let known = (*self.closures[closure]).clone();
        if known.scope.locals.is_none() {
            return Ok(known);
        }
        // It leaves the function that it was written in: what it uses goes with it.
        self.in_scope_of(&known, None, argument.site, |inner| {
            let text = inner.with_called(known.text.clone(), argument.site)?;
            inner.captured(text, argument.site)
        })
    }

    /// Returns a closure whose body begins with the definitions of the closures that it calls.
    fn with_called(&self, mut text: tree::Closure, site: Site) -> Result<tree::Closure> {
        let is_here = |name: &String| self.with_name(name).is_some();
        let mut stmts = Vec::new();
        for name in names_in(&text).into_iter().filter(is_here) {
            let closure = self.text_here(&name).or_refused(site, refusals::HIDDEN_NAME)?;
            let closure = tree::ExprKind::Closure(self.with_called(closure, site)?);
            let value = Some(tree::Expr::plain(closure, site));
            stmts.push(tree::Stmt::Let { name, slot: NO_SLOT, value, site, mutable: false });
        }
        if !stmts.is_empty() {
            let slot = text.body.slot;
            let block = tree::Block { stmts, tail: Some(text.body) };
            text.body = Box::new(tree::Expr { kind: tree::ExprKind::Block(block), site, slot });
        }
        Ok(text)
    }

    /// Returns the closure that the author named in the current function.
    fn with_name(&self, name: &str) -> Option<&Closure<'a>> {
        let closure = &self.closures[self.closure_named(name)?];
        let is_here = closure.text.name.is_some()
            && closure.scope.locals.is_some()
            && std::ptr::eq(closure.source, self.source);
        is_here.then_some(closure)
    }

    /// Returns the closure if the names in it have the same meaning here; none otherwise.
    fn text_here(&self, name: &str) -> Option<tree::Closure> {
        let closure = self.with_name(name)?;
        let same = |name: &String| closure.scope.names.meaning(name) == self.scopes.meaning(name);
        names_in(&closure.text).iter().all(same).then(|| closure.text.clone())
    }

    /// Returns a closure that calls the named closure with its own arguments.
    fn calling(&self, name: &str, site: Site) -> Option<tree::Closure> {
        let called = self.with_name(name)?;
        let given = (0..called.text.parameters.len()).map(|at| format!("given%{at}"));
        let given: Vec<_> = given.collect();
        let parameters = given.iter().map(|given| tree::Pattern::name(given)).collect();
        let arguments = given.iter().map(|given| tree::Expr::local(given, site)).collect();
        let kind = tree::ExprKind::Apply(name.to_owned(), arguments);
        let body = Box::new(tree::Expr { kind, site, slot: called.text.body.slot });
        Some(tree::Closure { name: None, parameters, body })
    }

    /// Returns the arguments with each name of a closure replaced by the closure itself.
    pub(super) fn written_out<'e>(&self, arguments: &'e [tree::Expr]) -> Cow<'e, [tree::Expr]> {
        let closure = |argument: &tree::Expr| match &argument.kind {
            tree::ExprKind::Local(name) => {
                self.text_here(name).or_else(|| self.calling(name, argument.site))
            }
            _ => None,
        };
        let mut arguments = Cow::Borrowed(arguments);
        for at in 0..arguments.len() {
            if let Some(closure) = closure(&arguments[at]) {
                arguments.to_mut()[at].kind = tree::ExprKind::Closure(closure);
            }
        }
        arguments
    }

    /// Returns the closure that an argument names or contains.
    pub(super) fn closure_given(&mut self, argument: &tree::Expr) -> Result<usize> {
        match &argument.kind {
            tree::ExprKind::Closure(closure) => {
                let closure = self.written_here(closure.clone());
                Ok(self.closure(closure))
            }
            tree::ExprKind::Local(name) => {
                self.closure_named(name).needed(argument.site, "this is not a closure")
            }
            _ => refused(argument.site, refusals::CLOSURE_GIVEN),
        }
    }

    /// Returns true for the closure that represents a named iterator: it yields items.
    fn is_iterator(&self, closure: usize) -> bool {
        let hands = |it: &tree::Expr| matches!(&it.kind, tree::ExprKind::Apply(name, _) if name == tree::EACH);
        self.closures[closure].text.body.any_expr(hands)
    }

    /// Returns a closure with its captured variables, each a place that can be passed.
    fn captured(&mut self, text: tree::Closure, site: Site) -> Result<Closure<'a>> {
        let mut captures = Vec::new();
        for name in names_in(&text) {
            let Ok(meaning) = self.lookup(&name, site) else { continue };
            let span = self.span(site);
            // Neither the parts of an array nor a parameter that is a slice.
            let plain = |place: &Place| {
                !matches!(place.ty, Type::Slice(_)) && self.cx.slices_in(&place.ty).is_empty()
            };
            match (&meaning, self.place_of(&meaning, span)) {
                (Value::Closure(of), _) if self.is_iterator(*of) => {
                    return refused(site, refusals::ITERATOR_IN_CLOSURE);
                }
                (Value::Closure(_), _) => {}
                (Value::Nothing, _) => captures.push((name, meaning)),
                (_, Some(place)) if plain(&place) => captures.push((name, meaning)),
                _ => return refused(site, refusals::SLICE_IN_CLOSURE),
            }
        }
        let scope =
            Scope { names: captures.into_iter().collect(), expanding: Vec::new(), locals: None };
        Ok(Closure {
            text,
            source: self.source,
            scope,
            outermost: None,
            borrowed: false,
            way: Way::Any,
        })
    }

    /// Returns the copy of a function for some closures, and the captured variables as its arguments.
    fn specialised(
        &mut self,
        template: &'a tree::Function,
        mut closures: Vec<(&str, Closure<'a>)>,
        site: Site,
    ) -> Result<(FunctionId, Vec<Argument>)> {
        closures.sort_by_key(|(param, _)| *param);
        let mut given: Vec<_> =
            closures.iter().filter_map(|(_, closure)| closure.text.name.clone()).collect();
        given.sort();
        let span = self.span(site);
        let all = closures.iter().flat_map(|(_, closure)| closure.scope.names.iter());
        let outside: Vec<(String, Place)> = all
            .filter_map(|(name, meaning)| Some((name.clone(), self.place_of(meaning, span)?)))
            .collect();
        let assigned: Vec<_> = outside.iter().map(|(_, place)| self.rustc_at(place)).collect();
        let mut inner = Lowering::new(&mut *self.cx, template)?;
        inner.parameters()?;
        let first = inner.locals.len();
        for ((name, place), ty) in outside.iter().zip(assigned) {
            let (name, span) = (name.clone(), place.span);
            let captured = Local { name, ty: place.ty.clone(), mode: Mode::RefMut, span };
            let local = inner.locals.add(captured);
            ty.into_iter().for_each(|ty| inner.locals.note_assigned(local, ty));
        }
        let params = inner.locals.len();
        let mut next = first as u32;
        for (param, mut closure) in closures {
            for meaning in closure.scope.names.meanings_mut() {
                match meaning {
                    Value::Local(local) => *local = LocalId(next),
                    Value::Place(place) => {
                        *place = Place::local(LocalId(next), place.ty.clone(), place.span);
                    }
                    _ => continue,
                }
                next += 1;
            }
            let closure = inner.closure(closure);
            inner.bind(param, Value::Closure(closure));
        }
        inner.body(&template.tree.body)?;
        let mut lowered = inner.finished(params, span)?;
        let function = &mut lowered.function;
        let mut captured = Vec::new();
        for ((_, place), at) in outside.into_iter().zip(first..) {
            let written = effects::writes_local(&function.body, LocalId(at as u32));
            let (mode, argument) = match (written, place.ty.is_word()) {
                (true, _) => (Mode::RefMut, Argument::RefMut(place)),
                (false, true) => (Mode::Value, Argument::Value(place.load())),
                (false, false) => (Mode::Ref, Argument::Ref(place.load())),
            };
            function.locals[at].mode = mode;
            captured.push(argument);
        }
        function.module.clone_from(&self.source.module);
        function.owner = self.owner();
        if let tree::Role::Inline { public } = self.source.tree.role {
            function.role = Role::Inline { public };
        }
        // Behind the body, in which another closure may be handed to the same function.
        let id = match self.named_copy(template, &given, function) {
            Some(known) => known,
            None => self.cx.add(lowered),
        };
        Ok((id, captured))
    }

    /// Names a copy `bisect_error` for a closure named `error`, else `bisect_in_step` for the calling function
    /// `step`. A copy for a generic instance has the instance's name in it, so that no other instance changes its
    /// name. Returns an identical copy that exists already.
    fn named_copy(
        &self,
        template: &tree::Function,
        given: &[String],
        copy: &mut Function,
    ) -> Option<FunctionId> {
        let purpose = match given.is_empty() {
            true => format!("in_{}", names::snake(&self.source.tree.name)),
            false => given.join("_"),
        };
        let instance = self.cx.suffix(&self.source.suffix);
        let wanted = format!("{}_{purpose}{instance}", template.tree.name);
        let all = &self.cx.module.functions;
        let mut number = 1;
        copy.name.clone_from(&wanted);
        loop {
            let same = |it: &Function| {
                it.module == copy.module && it.owner == copy.owner && it.name == copy.name
            };
            let taken = all.iter().position(same)?;
            if all[taken].locals == copy.locals && all[taken].body == copy.body {
                return Some(FunctionId(taken as u32));
            }
            number += 1;
            copy.name = format!("{wanted}_{number}");
        }
    }

    /// Lowers `f(x)` by inlining the body of the closure; its value is none if it is zero-sized.
    pub(super) fn apply(
        &mut self,
        name: &str,
        arguments: &[tree::Expr],
        site: Site,
    ) -> Result<Expr> {
        let before = self.locals.len();
        let value = self.applied(name, arguments, site, Self::body_value)?;
        if value.ty == Type::Unit {
            return Ok(value);
        }
        if let ExprKind::Load(place) = &value.kind
            && let Some(local) = local_since(place, before)
        {
            // A local of its own, which nothing names from here on.
            self.locals.note_temporary(local);
            return Ok(value);
        }
        // The value is held: its operands may be written before it is used. If it has no name, it takes the closure's.
        if self.naming != UNNAMED {
            return Ok(self.atom("value", value));
        }
        Ok(self.naming_as("", |inner| inner.atom(name, value)))
    }

    /// Lowers a condition. The result of an inlined closure is tested directly, without a temporary.
    pub(super) fn asked(&mut self, condition: &tree::Expr) -> Result<Expr> {
        match &condition.kind {
            tree::ExprKind::Apply(name, arguments) if self.stands_here(condition) => {
                self.applied(name, arguments, condition.site, Self::body_value)
            }
            tree::ExprKind::Unary(tree::UnaryOp::Not, inner) if self.stands_here(inner) => {
                Ok(self.asked(inner)?.negated())
            }
            _ => self.value(condition, Some(&Type::BOOL)),
        }
    }

    /// Returns true for a call of a closure that is inlined in the scope of its definition.
    pub(super) fn stands_here(&self, expr: &tree::Expr) -> bool {
        let tree::ExprKind::Apply(name, _) = &expr.kind else { return false };
        let closure = self.closure_named(name).filter(|_| name != tree::EACH);
        closure.is_some_and(|it| self.closures[it].scope.locals.is_some())
    }

    pub(super) fn applied<T>(
        &mut self,
        name: &str,
        arguments: &[tree::Expr],
        site: Site,
        end: impl FnOnce(&mut Self, &tree::Closure) -> Result<T>,
    ) -> Result<T> {
        let handed = self
            .closure_named(name)
            .map(|it| Rc::clone(&self.closures[it]))
            .or_refused(site, refusals::CLOSURE_HANDED_ON)?;
        let closure = &handed.text;
        // A closure that was written before what calls it changes nothing there but what it is lent for that.
        let stays = handed.scope.locals.filter(|_| name != tree::EACH);
        let mut subjects: Vec<Value> = Vec::new();
        for (at, (parameter, argument)) in closure.parameters.iter().zip(arguments).enumerate() {
            let each = name == tree::EACH;
            let subject = self.argument_for(parameter, argument, &handed, (each, site))?;
            self.name_own(parameter, &subject, stays);
            // A parameter is another name of an accumulator that the body assigns.
            subjects.push(self.beside_later(subject, argument, &arguments[at + 1..]));
        }
        self.in_scope_of(&handed, None, site, |inner| {
            inner.bind_arguments(closure, &subjects, stays)?;
            match &handed.outermost {
                Some((label, outermost)) => {
                    inner.pass_of(label.as_deref(), *outermost, |inner| end(inner, closure))
                }
                None => end(inner, closure),
            }
        })
    }

    /// Returns the value of an argument for the parameter of a closure; `each`: the argument is an item of an
    /// iterator.
    fn argument_for(
        &mut self,
        parameter: &tree::Pattern,
        argument: &tree::Expr,
        handed: &Closure<'a>,
        (each, site): (bool, Site),
    ) -> Result<Value> {
        let name = match parameter {
            tree::Pattern::Name { name, slot, .. } => Some((name, *slot)),
            _ => None,
        };
        let written = handed.source.tree.role != tree::Role::Expanded;
        // An item is what it is where it comes from; but a pair that has one name is a value.
        let whole = name.is_some_and(|(name, _)| !is_hidden(name))
            && matches!(argument.kind, tree::ExprKind::Tuple(_))
            && written;
        if each && !whole {
            let before = self.locals.len();
            let item = self.item(argument, Some(parameter))?;
            self.name_own(parameter, &item, handed.scope.locals.filter(|_| written));
            let computed = match name {
                Some((_, NO_SLOT)) => self.just_computed(&item, before),
                _ => None,
            };
            return Ok(computed.map_or(item, |value| Value::Word(Box::new(value))));
        }
        if let tree::Pattern::Tuple(_) = parameter
            && let Some(parts) = self.parts_named(argument)
        {
            return Ok(parts);
        }
        if let Some(slice @ Value::Slice(_)) = self.meaning_lent(argument) {
            return Ok(slice);
        }
        let taken = name.and_then(|(_, slot)| handed.source.slots.get(slot as usize));
        let expected = taken.map(|ty| self.cx.pointee(ty, site)).transpose()?;
        let value = self.value(argument, expected.as_ref())?;
        if value.ty == Type::Unit {
            return Ok(self.value_subject(value));
        }
        let by_value = !matches!(taken, Some(Ty::Ref(..)));
        if let ExprKind::Load(place) = &value.kind
            && !each
            && handed.scope.locals.is_some()
            && !(by_value && self.cx.holds_iterator(&value.ty))
        {
            return Ok(Value::Place(place.clone()));
        }
        // In a place of its own: the body may write to what it was computed from.
        let value = match name {
            _ if matches!(taken, Some(Ty::Ref(..))) => value,
            Some((name, _)) => self.naming_as("", |inner| inner.atom(name, value)),
            None => self.atom(words::ARGUMENT, value),
        };
        Ok(self.value_subject(value))
    }

    /// Lowers code of a closure in the scope of its definition; `each` receives the items that it yields.
    pub(super) fn in_scope_of<T>(
        &mut self,
        closure: &Closure<'a>,
        each: Option<Value>,
        site: Site,
        lower: impl FnOnce(&mut Self) -> Result<T>,
    ) -> Result<T> {
        let Scope { names, expanding, locals } = &closure.scope;
        let each = each.map(|each| (tree::EACH.to_owned(), each));
        let mut names = names.clone();
        names.push(each.into_iter().collect());
        let expanding = if locals.is_some() { expanding } else { &self.expanding }.clone();
        let scope = Scope { names, expanding, locals: *locals };
        self.in_names(closure.source, scope, (site, None), lower)
    }

    /// Binds the parameters of a closure: as aliases of the argument places where these do not change. A local of the
    /// caller that is newer than the closure gets the parameter's name.
    fn bind_arguments(
        &mut self,
        closure: &tree::Closure,
        subjects: &[Value],
        stays: Option<usize>,
    ) -> Result<()> {
        let mut names = Vec::new();
        for (pattern, subject) in closure.parameters.iter().zip(subjects) {
            self.name_own(pattern, subject, stays);
            match (pattern, subject) {
                (
                    tree::Pattern::Name { name, mutable: false, inner: None, .. },
                    Value::Place(place),
                ) if stays.is_some() => self.bind(name, subject.clone()),
                // What was just computed for a name that no author gave.
                (tree::Pattern::Name { name, slot: NO_SLOT, .. }, Value::Word(_)) => {
                    self.bind(name, subject.clone());
                }
                _ => names.extend(self.test(pattern, subject, closure.body.site)?.names),
            }
        }
        self.bind_names(&names)
    }

    /// Renames temporaries that hold the parts of a pattern after the pattern's names, except the first `stays`
    /// locals unless their names are hidden.
    pub(super) fn name_own(
        &mut self,
        pattern: &tree::Pattern,
        subject: &Value,
        stays: Option<usize>,
    ) {
        match (pattern, subject) {
            (tree::Pattern::Tuple(patterns), Value::Tuple(parts, _)) => {
                for (pattern, part) in patterns.iter().zip(parts) {
                    self.name_own(pattern, part, stays);
                }
            }
            (
                tree::Pattern::Name { name, mutable: false, inner: None, .. },
                Value::Place(place),
            ) if place.steps.is_empty()
                && !is_hidden(name)
                && (self.locals[place.root.index()].name.starts_with(UNTIL_NAMED)
                    || stays.is_some_and(|own| place.root.index() >= own)) =>
            {
                self.locals[place.root.index()].name.clone_from(name);
                // A computed aggregate needs a local anyway, which then has the author's name.
                if !place.ty.is_word() {
                    self.locals.note_named(place.root);
                }
            }
            _ => {}
        }
    }

    fn body_value(&mut self, closure: &tree::Closure) -> Result<Expr> {
        let (slot, site) = (closure.body.slot, closure.body.site);
        // What a reference that only reads refers to is the same as long as there is one.
        let read = |slot| {
            let shared =
                self.slot_is_reference(slot, site)? && !self.slot_is_exclusive(slot, site)?;
            if shared { self.refers_to(slot, site) } else { self.slot(slot, site) }
        };
        let ty = slot.map(read).transpose()?;
        let unit = match &ty {
            Some(ty) => *ty == Type::Unit,
            // The body of a loop.
            None => matches!(&closure.body.kind, tree::ExprKind::Block(it) if it.tail.is_none()),
        };
        if unit {
            self.effect(&closure.body)?;
            let span = self.span(closure.body.site);
            return Ok(Expr { kind: ExprKind::Struct(Vec::new()), ty: Type::Unit, span });
        }
        self.value(&closure.body, ty.as_ref())
    }
}

/// Prefix of a temporary's name that the name of a pattern may replace.
pub(super) const UNTIL_NAMED: &str = "%%";

/// Returns true for a name of the compiler, not of the author.
pub(super) fn is_hidden(name: &str) -> bool {
    name.contains('%')
}

/// Returns the names that a closure's body uses, except its own parameters.
fn names_in(closure: &tree::Closure) -> BTreeSet<String> {
    let own = closure.parameters.iter().flat_map(Walk::bound).collect();
    let mut names = closure.body.locals();
    closure.body.each_expr(|expr| {
        if let tree::ExprKind::Apply(name, _) = &expr.kind {
            names.insert(name.clone());
        }
    });
    names.difference(&own).cloned().collect()
}
