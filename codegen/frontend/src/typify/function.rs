//! Lowers one function: parameters, scopes, and statements in order.

use std::collections::HashMap;

use bessemer_ir::tree::{self, NO_SLOT, Pattern, Site, Ty};
use bessemer_ir::{
    Block, Expr, ExprKind, Fault, Function, Local, LocalId, Mode, Owner, Place, Role, Span, Stmt,
    StmtKind, Type,
};

use super::borrowed::Lenders;
use super::context::Path;
use super::destructure::Let;
use super::frames::{Frames, Target};
use super::locals::Locals;
use super::lowering::{Lowering, RESULT, UNNAMED, local_since};
use super::names::split;
use super::scopes::Scopes;
use super::slots::{slice_of, slot_type};
use super::syntax::control_with_value;
use super::value::Value;
use super::{Context, Result, names, problem, refusals, refused};
use crate::fuse::fuse;
use crate::takers;

/// A lowered function, with facts that its callers need.
pub(super) struct Lowered {
    pub function: Function,
    /// True for each parameter that is zero-sized, so the C has none.
    pub absent: Vec<bool>,
    /// The lender of each slice in its result.
    pub given_back: Vec<(Path, Place)>,
}

/// Lowers a function whose callees are in the module already.
pub(super) fn lower(cx: &mut Context<'_>, source: &tree::Function) -> Result<Lowered> {
    let tree = &source.tree;
    let span = cx.span(&source.file, tree.site);
    let mut lowering = Lowering::new(cx, source)?;
    lowering.parameters()?;
    let params = lowering.locals.len();
    lowering.body(&tree.body)?;
    if tree.attributes.atomic {
        lowering.roll_back(params, span);
    }
    let lowered = lowering.finished(params, span)?;
    let home = source.owner.as_deref().unwrap_or(&source.module);
    let suffix = lowering.cx.suffix(&source.suffix);
    let name = match &source.interface {
        // A method of another name keeps it; those of two interfaces are told apart by these.
        Some(interface) if lowering.cx.is_claimed_twice(source) => {
            format!("{}_{}", names::snake(interface), tree.name)
        }
        _ => tree.name.clone(),
    };
    // The methods of what is no type of the author's in the C say in their names whose they are.
    let nameless = source.owner.as_ref().and_then(|path| lowering.cx.types.nothings.get(path));
    let nameless = nameless.map(|it| names::snake(&it.name));
    let of_rust = type_of_rust(source).map(names::joined);
    let name = match nameless.or(of_rust) {
        Some(owner) => format!("{owner}_{name}"),
        None => name,
    };
    let mut name = lowering.cx.instance_name(home, &name, &suffix);
    if source.inner && lowering.cx.authored.contains(&format!("{home}::{name}")) {
        name.push_str("_inside");
    }
    // The methods of an instance stand where its author named it.
    let alias = source.owner.as_deref().and_then(|owner| lowering.cx.aliases.get(owner));
    let module = alias.map_or(&source.module, |alias| &alias.module).clone();
    let role = match tree.role {
        tree::Role::Entry { infallible } => Role::Entry { infallible },
        tree::Role::Public => Role::Public,
        tree::Role::Private | tree::Role::Expanded | tree::Role::Rewritten => Role::Private,
        tree::Role::Inline { public } => Role::Inline { public },
    };
    Ok(Lowered { function: Function { name, module, role, ..lowered.function }, ..lowered })
}

/// Returns true if a function has a closure parameter, so that it is copied for each combination of closures.
pub(super) fn takes_closures(function: &tree::Function) -> bool {
    function.tree.params.iter().any(|param| param.closure)
}

/// Returns the local with the `%` marks removed from its name.
pub(super) fn without_marks(local: Local) -> Local {
    Local { name: local.name.replace('%', ""), ..local }
}

/// Returns the type of Rust on which a function is implemented, such as `f64` or `[f64; 3]`; it is not an author's type.
fn type_of_rust(source: &tree::Function) -> Option<&str> {
    let is_number = |path: &str| path.starts_with(char::is_lowercase) && !path.contains("::");
    let is_one = |path: &&str| is_number(path) || path.starts_with(['[', '(']);
    source.owner.as_deref().filter(is_one)
}

impl<'a, 'c> Lowering<'a, 'c> {
    /// Returns a lowering without statements.
    pub(super) fn new(cx: &'a mut Context<'c>, source: &'a tree::Function) -> Result<Self> {
        let site = source.tree.site;
        if let Some(path) = &source.owner
            && type_of_rust(source).is_none()
            && !cx.types.by_path.contains_key(path)
        {
            let remedy = match path.contains("::") {
                true => "mark it `#[data]`",
                false => {
                    "wrap the value: `#[data] struct Gain(f64);`, and implement the interface for that"
                }
            };
            return problem(site, format!("`{path}` was not built"), remedy);
        }
        // What is lent to be read may be a copy.
        let result = match slot_type(source, source.tree.result, site)? {
            Ty::Ref(inner, mutable)
                if !matches!(**inner, Ty::Slice(_)) && (!mutable || cx.is_nothing(inner)) =>
            {
                cx.value_type(inner, site)?
            }
            ty => cx.content_type(ty, site)?,
        };
        Ok(Lowering {
            cx,
            source,
            locals: Locals::default(),
            scopes: Scopes::default(),
            out: Vec::new(),
            naming: UNNAMED.into(),
            result,
            lenders: Lenders::default(),
            frames: Frames::default(),
            counters: Vec::new(),
            closures: Vec::new(),
            hands: HashMap::new(),
            absent: Vec::new(),
            expanding: Vec::new(),
        })
    }
}

impl Lowering<'_, '_> {
    /// Returns the author's type whose method is being lowered.
    pub(super) fn owner(&self) -> Option<Owner> {
        match self.cx.types.by_path.get(self.source.owner.as_ref()?) {
            Some(Type::Struct(id)) => Some(Owner::Struct(*id)),
            Some(Type::Enum(id)) => Some(Owner::Enum(*id)),
            _ => None,
        }
    }

    /// Returns the lowered function, whose first `params` locals are its parameters. The caller names it.
    pub(super) fn finished(&mut self, params: usize, span: Span) -> Result<Lowered> {
        self.follow_copies();
        self.put_awaited()?;
        self.check_locals()?;
        let given_back = self.lent_out()?;
        let (source, result) = (self.source, self.result.clone());
        let facts = std::mem::take(&mut self.locals);
        let locals = facts.to_vec();
        let mut function = Function {
            name: source.tree.name.clone(),
            module: source.module.clone(),
            owner: self.owner(),
            role: Role::Private,
            attributes: self.cx.sizes_of(source, &locals[..params], &result),
            docs: source.tree.docs.clone(),
            params: params as u32,
            result_name: names::result(self.cx, &source.tree, &result),
            body: Block(std::mem::take(&mut self.out)),
            locals: locals.into_iter().map(without_marks).collect(),
            result,
            kernel: None,
            span,
        };
        takers::name(&self.cx.module, &mut function, &|local| facts.is_unnamed(local));
        fuse(&self.cx.module, &mut function, &|local| facts.is_atom(local));
        Ok(Lowered { function, absent: std::mem::take(&mut self.absent), given_back })
    }

    pub(super) fn parameters(&mut self) -> Result<()> {
        let source = self.source;
        for param in source.tree.params.iter().filter(|param| !param.closure) {
            let ty = slot_type(self.source, param.slot, param.site)?;
            let absent = self.slot_is_nothing(param.slot);
            self.absent.push(absent);
            if absent {
                self.bind(&param.name, Value::Nothing);
                continue;
            }
            if let Some(element) = slice_of(ty) {
                self.slice_parameter(param, element, matches!(ty, Ty::Ref(_, true)))?;
                continue;
            }
            let mode = match ty {
                Ty::Ref(_, false) => Mode::Ref,
                Ty::Ref(_, true) => Mode::RefMut,
                _ => Mode::Value,
            };
            let ty = self.cx.pointee(ty, param.site)?;
            let span = self.span(param.site);
            let local = self.declare(&param.name, ty, mode, span);
            match mode {
                Mode::Value if !param.mutable => self.locals.note_counter(local),
                Mode::Ref => {}
                _ => self.note_changing(local, param.slot),
            }
            self.lending_parameters(param, local)?;
        }
        self.lenders.params = self.locals.len();
        Ok(())
    }

    pub(super) fn body(&mut self, block: &tree::Block) -> Result<()> {
        let source = self.source;
        for param in source.tree.params.iter().filter(|it| it.mutable && !it.closure) {
            if self.slot_is_slice(param.slot, param.site)? {
                self.rebound(&param.name, param.slot, param.site)?;
            }
        }
        self.whole_body(block)?;
        let mut stmts = std::mem::take(&mut self.out);
        self.give_values(&mut stmts);
        let mut body = Block(stmts);
        self.leave_unasked(&mut body);
        super::marks::leave_out(&mut body);
        self.out = body.0;
        Ok(())
    }

    fn whole_body(&mut self, block: &tree::Block) -> Result<()> {
        self.stmts(block)?;
        let Some(tail) = &block.tail else { return Ok(()) };
        let mark = self.out.len();
        if self.result == Type::Unit {
            self.effect(tail)?;
        } else {
            self.naming = RESULT.into();
            self.lower_into(tail, &Target::Return)?;
        }
        self.comment(mark, tail.site);
        Ok(())
    }

    /// Adds a local by value, which no name denotes yet.
    pub(super) fn local(&mut self, name: impl Into<String>, ty: Type, span: Span) -> LocalId {
        self.locals.by_value(name.into(), ty, span)
    }

    /// Declares a local with its value, and returns its place.
    pub(super) fn let_local(&mut self, name: impl Into<String>, value: Expr) -> Place {
        let (ty, span) = (value.ty.clone(), value.span);
        let local = self.local(name, ty.clone(), span);
        self.emit(StmtKind::Let { local, value: Some(value) }, span);
        Place::local(local, ty, span)
    }

    /// Adds a local, and binds `name` to it.
    pub(super) fn declare(&mut self, name: &str, ty: Type, mode: Mode, span: Span) -> LocalId {
        let id = self.local(name, ty, span);
        self.locals[id.index()].mode = mode;
        self.bind(name, Value::Local(id));
        id
    }

    /// Declares a local with its value, and binds `name` to it.
    pub(super) fn let_named(&mut self, name: &str, value: Expr, span: Span) -> LocalId {
        let local = self.declare(name, value.ty.clone(), Mode::Value, span);
        self.emit(StmtKind::Let { local, value: Some(value) }, span);
        local
    }

    /// Returns the value that a name denotes.
    pub(super) fn named(&mut self, name: &str, site: Site) -> Result<Expr> {
        let span = self.span(site);
        let meaning = self.lookup(name, site)?;
        if let Some(place) = self.place_of(&meaning, span) {
            return Ok(place.load().at(span));
        }
        match meaning {
            Value::Word(value) => Ok(*value),
            Value::Nothing => Ok(self.nothing(site)),
            Value::Submatrix(_) => refused(site, refusals::MOVED_VIEW),
            Value::Tuple(parts, Some(ty)) => self.lent_value(Value::Tuple(parts, None), &ty, site),
            _ => refused(site, refusals::TUPLE_MADE),
        }
    }

    pub(super) fn bind(&mut self, name: &str, binding: Value) {
        self.scopes.add_name(name.to_owned(), binding);
    }

    pub(super) fn lookup(&self, name: &str, site: Site) -> Result<Value> {
        match self.scopes.meaning(name) {
            Some(meaning) => Ok(meaning.clone()),
            None => problem(site, format!("`{name}` is not known here"), super::OUR_FAULT),
        }
    }

    pub(super) fn emit(&mut self, kind: StmtKind, span: Span) {
        self.follow(&kind);
        self.out.push(Stmt::new(kind, span));
    }

    /// Attaches the author's comments above `site` to the first statement after `mark`.
    fn comment(&mut self, mark: usize, Site(line, _): Site) {
        if let Some(stmt) = self.out.get_mut(mark)
            && stmt.comments.is_empty()
        {
            stmt.comments = self.cx.sources.comments_above(&self.source.file, line);
        }
    }

    /// Lowers in a new scope, into the current block.
    pub(super) fn naming_scope<T>(
        &mut self,
        lower: impl FnOnce(&mut Self) -> Result<T>,
    ) -> Result<T> {
        self.scopes.push(Vec::new());
        let done = lower(self);
        self.scopes.pop();
        done
    }

    /// Lowers into a block of its own, and returns the statements of the block.
    pub(super) fn in_block<T>(
        &mut self,
        lower: impl FnOnce(&mut Self) -> Result<T>,
    ) -> Result<(T, Vec<Stmt>)> {
        let outer = std::mem::take(&mut self.out);
        let done = lower(self);
        let inner = std::mem::replace(&mut self.out, outer);
        Ok((done?, inner))
    }

    /// Lowers in a new scope, into a new block.
    pub(super) fn scoped(&mut self, lower: impl FnOnce(&mut Self) -> Result<()>) -> Result<Block> {
        self.scopes.push(Vec::new());
        let done = self.in_block(lower);
        self.scopes.pop();
        done.map(|((), inner)| Block(inner))
    }

    /// Lowers the statements of a block, without its tail expression.
    pub(super) fn stmts(&mut self, block: &tree::Block) -> Result<()> {
        for stmt in &block.stmts {
            let mark = self.out.len();
            let site = match stmt {
                &tree::Stmt::Let { ref name, slot, ref value, site, mutable } => {
                    self.let_stmt(Let { name, slot, value: value.as_ref(), site, mutable })?;
                    site
                }
                tree::Stmt::Apart { pattern, value, otherwise, site } => {
                    let naming = match &**pattern {
                        // Another name of a place, which no author wrote.
                        Pattern::Name { name, slot: NO_SLOT, .. } => name.clone(),
                        _ => self.naming.clone(),
                    };
                    let otherwise = otherwise.as_ref();
                    self.naming_as(naming, |inner| inner.take_apart(pattern, value, otherwise))?;
                    *site
                }
                tree::Stmt::Expr(expr) => {
                    self.effect(expr)?;
                    expr.site
                }
            };
            self.comment(mark, site);
        }
        Ok(())
    }

    /// Lowers `let name = value`, if the value has no `?` on a borrowed option.
    pub(super) fn give_name(&mut self, it: Let) -> Result<()> {
        let Let { name, slot, value, site, mutable } = it;
        if let Some(value) = value {
            if let tree::ExprKind::Closure(closure @ tree::Closure { name: Some(_), .. }) =
                &value.kind
            {
                let closure = self.closure_here(closure.clone());
                self.bind(name, closure);
                return Ok(());
            }
            if let Some(mut iterator) = self.iterator(value)? {
                if mutable {
                    iterator = self.by_hand(name, iterator, self.source, site)?;
                }
                self.bind(name, iterator);
                return Ok(());
            }
            if let Some(part) = self.naming_as(name, |inner| inner.submatrix(value))? {
                self.bind(name, Value::Submatrix(Box::new(part)));
                return Ok(());
            }
        }
        let other = value.and_then(|value| self.in_place(value));
        let rewritten = other.as_ref().or(value);
        let refers = match slot {
            NO_SLOT => None,
            slot => {
                Some(slot_type(self.source, slot, site)?).filter(|ty| matches!(ty, Ty::Ref(..)))
            }
        };
        let absent = self.slot_is_nothing(slot);
        // Where it is called, what is assigned to a reference lies elsewhere: it holds what it refers to.
        let gathers = mutable && self.source.tree.role == tree::Role::Expanded;
        match (refers.is_some_and(|ty| slice_of(ty).is_some()), rewritten) {
            (true, Some(value)) => return self.let_slice((name, slot), mutable, value, site),
            _ if refers.is_some() && !absent && !gathers => {
                return self.alias((name, slot), value, site);
            }
            _ => {}
        }
        let ty = match (slot, rewritten) {
            _ if absent => Type::Unit,
            (NO_SLOT, Some(value)) => self.type_of_value(value)?,
            _ if refers.is_some() => self.refers_to(slot, site)?,
            _ => self.slot(slot, site)?,
        };
        if ty == Type::Unit {
            value.iter().try_for_each(|value| self.effect(value))?;
            self.bind(name, Value::Nothing);
            return Ok(());
        }
        let span = self.span(site);
        self.naming_as(name, |inner| match rewritten {
            Some(value) if matches!(value.kind, tree::ExprKind::Fold { .. }) => {
                // The loop gathers in the variable itself.
                let local = inner.lower_fold(value, Some(name))?;
                inner.agree(&inner.locals[local.index()].ty.clone(), &ty, site)?;
                inner.bind(name, Value::Local(local));
                Ok(())
            }
            Some(value) if !control_with_value(value) => {
                // The name means the new local only after its value.
                let before = inner.locals.len();
                let value = inner.value(value, Some(&ty))?;
                inner.agree(&value.ty, &ty, site)?;
                match inner.made_for(&value, before) {
                    Some(local) => {
                        inner.locals[local.index()].name = name.to_owned();
                        inner.bind(name, Value::Local(local));
                    }
                    None => {
                        inner.let_named(name, value, span);
                    }
                }
                Ok(())
            }
            _ => inner.let_control(name, ty, rewritten, span),
        })
    }

    /// Returns the temporary in which a value was built, if nothing else uses it. It may get the author's name.
    fn made_for(&mut self, value: &Expr, since: usize) -> Option<LocalId> {
        match &value.kind {
            ExprKind::Load(place) => {
                local_since(place, since).filter(|local| self.locals.release(*local))
            }
            _ => None,
        }
    }

    /// Lowers `let name = if …`.
    pub(super) fn let_control(
        &mut self,
        name: &str,
        ty: Type,
        value: Option<&tree::Expr>,
        span: Span,
    ) -> Result<()> {
        let place = self.decided_by(name.to_owned(), ty, value, span)?;
        self.bind(name, Value::Local(place.root));
        Ok(())
    }

    /// Declares a temporary that the following statements assign, and returns its place.
    pub(super) fn assigned(&mut self, role: &str, value: Expr) -> Place {
        let place = self.mutable_place(role, value);
        self.locals.note_temporary(place.root);
        place
    }

    /// Declares a mutable temporary with this value, and returns its place.
    pub(super) fn mutable_place(&mut self, role: &str, value: Expr) -> Place {
        self.let_local(self.role_name(role), value)
    }

    /// Lowers with `name` as the first part of temporaries' names.
    pub(super) fn naming_as<T>(
        &mut self,
        name: impl Into<String>,
        lower: impl FnOnce(&mut Self) -> T,
    ) -> T {
        let outer = std::mem::replace(&mut self.naming, name.into());
        let done = lower(self);
        self.naming = outer;
        done
    }

    /// Emits a check of a condition.
    pub(super) fn check(&mut self, condition: Expr, fault: Fault, span: Span) {
        self.emit(StmtKind::Check { condition, fault }, span);
    }

    /// Emits an `if` without an `else`.
    pub(super) fn emit_if(&mut self, condition: Expr, then: Block, span: Span) {
        self.emit(StmtKind::if_then(condition, then), span);
    }

    pub(super) fn role_name(&self, role: &str) -> String {
        if self.naming.is_empty() { role.into() } else { format!("{}_{role}", self.naming) }
    }

    /// Reports an internal error if a computed type differs from rustc's.
    pub(super) fn agree(&self, computed: &Type, rustc: &Type, site: Site) -> Result<()> {
        if computed == rustc {
            return Ok(());
        }
        problem(
            site,
            format!(
                "Bessemer takes this for `{}`, rustc for `{}`",
                self.cx.show(computed),
                self.cx.show(rustc)
            ),
            super::OUR_FAULT,
        )
    }

    /// Returns the module that contains the function.
    pub(super) fn module_path(&self) -> String {
        if self.source.module.is_empty() {
            split(&self.source.path).0.to_owned()
        } else {
            self.source.module.clone()
        }
    }
}
