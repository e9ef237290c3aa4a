//! Functions and their statements.
//!
//! `m` is the mask of the lanes that execute a statement. A function has `live`, the lanes that have not returned, if it returns
//! early; a loop has `run`, the lanes that have not left it, and `go`, the lanes that have not ended this pass.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;

use bessemer_ir::visit::Walk;
use bessemer_ir::{
    Arm, Block, ConstId, Expr, ExprKind, Function, FunctionId, Int, LocalId, Mode, Module, Place,
    Role, Span, Stmt, StmtKind, Type,
};

use crate::error::Error;
use crate::names::Names;
use crate::place::Path;
use crate::types::text;

pub(crate) type Result<T, E = Error> = std::result::Result<T, E>;

/// One function while it is emitted.
pub(crate) struct Cx<'a> {
    pub module: &'a Module,
    pub names: &'a Names,
    pub function: &'a Function,
    /// Counters that all lanes have in common.
    pub uniform: BTreeSet<LocalId>,
    /// Locals that hold a constant and are read by element only.
    pub tables: BTreeMap<LocalId, ConstId>,
    /// Locals whose whole value is used once, outside of loops: they need no copy.
    pub moved: BTreeSet<LocalId>,
    out: String,
    /// True if the function returns before its end.
    early: bool,
    /// Number of loops around.
    loops: usize,
    depth: usize,
}

/// The ways in which statements end for some lanes.
#[derive(Clone, Copy, Default)]
struct Exits {
    returns: bool,
    breaks: bool,
    continues: bool,
}

/// Returns the text of a function.
pub(crate) fn function(module: &Module, names: &Names, id: FunctionId) -> Result<String> {
    let function = &module.functions[id.index()];
    let last = function.body.0.len().saturating_sub(1);
    let early = function.body.0.iter().enumerate().any(|(n, stmt)| match &stmt.kind {
        StmtKind::Return(_) => n != last,
        _ => exits(stmt).returns,
    });
    let mut cx = Cx {
        module,
        names,
        function,
        uniform: BTreeSet::new(),
        tables: tables(module, function),
        moved: moved(function),
        out: String::new(),
        early,
        loops: 0,
        depth: 1,
    };
    let passed = function.parameters().iter().enumerate().map(|(n, local)| {
        let ty = text(names, &local.ty);
        let (before, mode) = match local.mode {
            Mode::Value => ("mut ", ""),
            Mode::Ref => ("", "&"),
            Mode::RefMut => ("", "&mut "),
        };
        format!("{before}{}: {mode}{ty}", cx.local(LocalId(n as u32)))
    });
    let passed: Vec<String> = std::iter::once("m: Mask".to_owned()).chain(passed).collect();
    let result = match function.result {
        Type::Unit => String::new(),
        ref ty => format!(" -> {}", text(names, ty)),
    };
    let inline = match function.role {
        Role::Inline { .. } => "#[inline(always)]\n",
        _ => "",
    };
    let (name, passed) = (names.of_function(id), passed.join(", "));
    for doc in &function.docs {
        _ = writeln!(cx.out, "///{doc}");
    }
    let head = format!("\n{}{inline}pub fn {name}({passed}){result} {{\n", cx.out);
    cx.out.clear();
    if let Some(kernel) = &function.kernel {
        let text = cx.kernel(kernel)?;
        cx.line(&text);
    } else {
        if early {
            if function.result != Type::Unit {
                let ty = text(names, &function.result);
                cx.line(&format!("let mut result = <{ty} as Lanes>::zero();"));
            }
            cx.line("let mut live = m;");
        }
        cx.block(&function.body)?;
        let ended = matches!(function.body.0.last(), Some(Stmt { kind: StmtKind::Return(_), .. }));
        if early && !ended && function.result != Type::Unit {
            cx.line("result");
        }
    }
    Ok(format!("{head}{}}}\n", cx.out))
}

/// Returns the locals that hold a constant of several words, are not written, and are read by element only.
fn tables(module: &Module, function: &Function) -> BTreeMap<LocalId, ConstId> {
    let mut found = BTreeMap::new();
    each_stmt(&function.body, &mut |stmt| {
        if let StmtKind::Let { local, value: Some(Expr { kind: ExprKind::Const(id), .. }) } =
            &stmt.kind
            && module.consts[id.index()].words.len() > 1
        {
            found.insert(*local, *id);
        }
    });
    let mut whole = BTreeSet::new();
    each_stmt(&function.body, &mut |stmt| {
        if let StmtKind::Assign { place, .. } = &stmt.kind {
            whole.insert(place.root);
        }
    });
    function.body.any_expr(|expr| {
        match &expr.kind {
            ExprKind::Load(Place { root, ty, .. }) if !ty.is_word() => _ = whole.insert(*root),
            ExprKind::Call(_, arguments) => {
                for argument in arguments {
                    if let bessemer_ir::Argument::RefMut(place) = argument {
                        whole.insert(place.root);
                    }
                }
            }
            _ => {}
        }
        false
    });
    found.retain(|local, _| !whole.contains(local));
    found
}

/// Returns the locals whose whole value is used once, outside of loops, and of which nothing else is used.
fn moved(function: &Function) -> BTreeSet<LocalId> {
    let mut uses = BTreeMap::<LocalId, usize>::new();
    let mut note = |block: &Block, weight: usize| {
        block.any_place(|place, _| {
            let whole = if place.steps.is_empty() { weight } else { 2 };
            *uses.entry(place.root).or_default() += whole;
            false
        });
    };
    note(&function.body, 1);
    each_stmt(&function.body, &mut |stmt| {
        if let StmtKind::For { body, .. } = &stmt.kind {
            note(body, 2);
        }
    });
    let is_value = |id: &LocalId| function.local(*id).mode == Mode::Value;
    uses.into_iter().filter(|(id, uses)| *uses == 1 && is_value(id)).map(|it| it.0).collect()
}

/// Visits each statement of a block, and those within.
fn each_stmt(block: &Block, visit: &mut dyn FnMut(&Stmt)) {
    for stmt in &block.0 {
        visit(stmt);
        within(stmt).into_iter().for_each(|inner| each_stmt(inner, visit));
    }
}

/// Returns the blocks of a statement.
fn within(stmt: &Stmt) -> Vec<&Block> {
    match &stmt.kind {
        StmtKind::If { then, otherwise, .. } => vec![then, otherwise],
        StmtKind::Match { arms, otherwise, .. } => {
            arms.iter().map(|arm| &arm.body).chain(otherwise).collect()
        }
        StmtKind::For { body, .. } => vec![body],
        _ => Vec::new(),
    }
}

/// Returns the ways in which a statement may end the code around it.
fn exits(stmt: &Stmt) -> Exits {
    let mut all = Exits {
        returns: matches!(stmt.kind, StmtKind::Return(_)),
        breaks: matches!(stmt.kind, StmtKind::Break),
        continues: matches!(stmt.kind, StmtKind::Continue),
    };
    let is_loop = matches!(stmt.kind, StmtKind::For { .. });
    for block in within(stmt) {
        let inner = exits_of(block);
        all.returns |= inner.returns;
        all.breaks |= inner.breaks && !is_loop;
        all.continues |= inner.continues && !is_loop;
    }
    all
}

fn exits_of(block: &Block) -> Exits {
    block.0.iter().map(exits).fold(Exits::default(), |one, other| Exits {
        returns: one.returns || other.returns,
        breaks: one.breaks || other.breaks,
        continues: one.continues || other.continues,
    })
}

impl Cx<'_> {
    pub(crate) fn error(&self, span: Span, what: &str) -> Error {
        Error::new(self.module, self.function, span, what)
    }

    fn line(&mut self, line: &str) {
        _ = writeln!(self.out, "{:indent$}{line}", "", indent = 4 * self.depth);
    }

    fn open(&mut self, line: &str) {
        self.line(line);
        self.depth += 1;
    }

    fn close(&mut self) {
        self.depth -= 1;
        self.line("}");
    }

    fn block(&mut self, block: &Block) -> Result<()> {
        for stmt in &block.0 {
            self.stmt(stmt)?;
        }
        Ok(())
    }

    fn stmt(&mut self, stmt: &Stmt) -> Result<()> {
        for comment in &stmt.comments {
            self.line(&format!("//{comment}"));
        }
        match &stmt.kind {
            StmtKind::Let { local, value } => {
                self.declaration(*local, value.as_ref(), stmt.span)?
            }
            StmtKind::Assign { place, value } => self.assignment(place, value)?,
            StmtKind::Expr(expr) => {
                let text = self.value(expr)?;
                self.line(&format!("{text};"));
            }
            StmtKind::If { condition, then, otherwise } => {
                self.branch(condition, then, otherwise)?;
                self.after(exits(stmt));
            }
            StmtKind::Match { scrutinee, arms, otherwise } => {
                self.choice(scrutinee, arms, otherwise.as_ref())?;
                self.after(exits(stmt));
            }
            StmtKind::For { .. } => {
                self.iteration(stmt)?;
                self.after(exits(stmt));
            }
            StmtKind::Check { .. } => {
                let what =
                    "has a check that may fail: lanes need an entry point that is `infallible`";
                return Err(self.error(stmt.span, what));
            }
            StmtKind::Return(value) => self.end(value.as_ref())?,
            StmtKind::Break => self.line(&format!("run{} &= !m;", self.loops)),
            StmtKind::Continue => self.line(&format!("go{} &= !m;", self.loops)),
        }
        Ok(())
    }

    fn declaration(&mut self, local: LocalId, value: Option<&Expr>, span: Span) -> Result<()> {
        if self.tables.contains_key(&local) {
            return Ok(());
        }
        let of = self.function.local(local);
        if of.mode != Mode::Value {
            return Err(self.error(span, "has a variable that is a reference"));
        }
        let (name, ty) = (self.local(local), text(self.names, &of.ty));
        match value {
            Some(value) => {
                let value = self.value(value)?;
                self.line(&format!("let mut {name}: {ty} = {value};"));
            }
            None => self.line(&format!("let mut {name} = <{ty} as Lanes>::zero();")),
        }
        Ok(())
    }

    fn assignment(&mut self, place: &Place, value: &Expr) -> Result<()> {
        // A place is passed by reference where nothing of it is written meanwhile.
        let is_elsewhere = matches!(&value.kind, ExprKind::Load(of) if of.root != place.root);
        let value = match is_elsewhere && !value.ty.is_word() {
            true => self.reference(value)?,
            false if self.is_byte(place) => format!("&Byte::of({})", self.value(value)?),
            false => format!("&{}", self.value(value)?),
        };
        let path = self.path(place)?;
        self.line(&format!("let value = {value};"));
        match path {
            Path::Direct(text) => self.line(&format!("{text}.assign(m, value);")),
            Path::Selected { array, index, rest } => self.line(&format!(
                "lanes::each(&mut {array}[..], {index}, m, |it, m| it{rest}.assign(m, value));"
            )),
        }
        Ok(())
    }

    fn branch(&mut self, condition: &Expr, then: &Block, otherwise: &Block) -> Result<()> {
        if let Some(condition) = self.uniform_condition(condition) {
            self.open(&format!("if {condition} {{"));
            self.block(then)?;
            if !otherwise.0.is_empty() {
                self.depth -= 1;
                self.open("} else {");
                self.block(otherwise)?;
            }
            self.close();
            return Ok(());
        }
        let condition = self.value(condition)?;
        self.line(&format!("let is = {condition};"));
        if then.0.is_empty() {
            return self.masked("m & !is", otherwise);
        }
        if otherwise.0.is_empty() {
            return self.masked("m & is", then);
        }
        self.line("let other = m & !is;");
        self.masked("m & is", then)?;
        self.masked("other", otherwise)
    }

    /// Executes a block for the lanes of a mask.
    fn masked(&mut self, mask: &str, block: &Block) -> Result<()> {
        if block.0.is_empty() {
            return Ok(());
        }
        self.open("{");
        self.line(&format!("let m = {mask};"));
        self.open("if m.any() {");
        self.block(block)?;
        self.close();
        self.close();
        Ok(())
    }

    fn choice(&mut self, scrutinee: &Expr, arms: &[Arm], otherwise: Option<&Block>) -> Result<()> {
        let text = self.value(scrutinee)?;
        self.open("{");
        self.line(&format!("let of = {text};"));
        self.line("let mut other = m;");
        // An enum that is no variant takes the last arm.
        let (listed, last) = match (otherwise, arms.split_last()) {
            (Some(otherwise), _) => (arms, otherwise),
            (None, Some((last, listed))) => (listed, &last.body),
            (None, None) => return Err(self.error(scrutinee.span, "has a match without arms")),
        };
        for arm in listed {
            let is =
                arm.values.iter().map(|value| format!("of.equals(Whole::of({}))", *value as i64));
            let is: Vec<String> = is.collect();
            self.line(&format!("let is = {};", is.join(" | ")));
            self.masked("m & is", &arm.body)?;
            self.line("other &= !is;");
        }
        self.masked("other", last)?;
        self.close();
        Ok(())
    }

    /// Narrows the mask after a statement that may end for some lanes.
    fn after(&mut self, exits: Exits) {
        let mut left = Vec::new();
        if exits.returns {
            left.push("live".to_owned());
        }
        if exits.breaks {
            left.push(format!("run{}", self.loops));
        }
        if exits.continues {
            left.push(format!("go{}", self.loops));
        }
        if left.is_empty() {
            return;
        }
        self.line(&format!("let m = m & {};", left.join(" & ")));
        if exits.returns && self.depth == 1 {
            self.open("if !m.any() {");
            let result = if self.function.result == Type::Unit { "" } else { " result" };
            self.line(&format!("return{result};"));
            self.close();
        }
    }

    fn end(&mut self, value: Option<&Expr>) -> Result<()> {
        if let Some(value) = value.filter(|_| self.function.result != Type::Unit) {
            // Nothing follows that could read a local.
            if let ExprKind::Load(place) = &value.kind
                && self.depth == 1
                && place.steps.is_empty()
                && self.function.local(place.root).mode == Mode::Value
            {
                self.moved.insert(place.root);
            }
            let value = self.value(value)?;
            if self.early {
                self.line(&format!("result.assign(m, &{value});"));
            } else {
                self.line(&value);
            }
        }
        if !self.early {
            return Ok(());
        }
        if self.depth > 1 {
            self.line("live &= !m;");
        } else if self.function.result != Type::Unit {
            self.line("result");
        }
        Ok(())
    }

    fn iteration(&mut self, stmt: &Stmt) -> Result<()> {
        let StmtKind::For { variable, from, to, inclusive, reversed, ended, body, .. } = &stmt.kind
        else {
            return Ok(());
        };
        let within = exits_of(body);
        let bounds = (self.uniform(from), self.uniform(to));
        let name = self.local(*variable);
        let (from, to) = (self.value(from)?, self.value(to)?);
        self.loops += 1;
        let level = self.loops;
        self.open("{");
        self.line(&format!("let mut run{level} = m;"));
        let counter = if *reversed { bounds.1.clone() } else { bounds.0.clone() };
        let counted = match (bounds, ended) {
            ((Some(from), Some(to)), false) => {
                let dots = if *inclusive { "..=" } else { ".." };
                let reversed = if *reversed { ".rev()" } else { "" };
                self.uniform.insert(*variable);
                self.open(&format!("for {name} in ({from}{dots}{to}){reversed} {{"));
                true
            }
            // The counter is equal in all lanes, and each leaves the loop at an end of its own.
            _ if counter.is_some() && !*reversed => {
                let counter = counter.unwrap_or_default();
                self.line(&format!("let last = {to};"));
                self.uniform.insert(*variable);
                self.open(&format!("for {name} in {counter}.. {{"));
                if !ended {
                    let signed =
                        self.function.local(*variable).ty.as_int().is_some_and(Int::signed);
                    let order = if signed { "" } else { ".unsigned()" };
                    let is_below = if *inclusive { "le" } else { "lt" };
                    let line =
                        format!("run{level} &= Whole::of({name}){order}.{is_below}(last{order});");
                    self.line(&line);
                }
                true
            }
            _ => {
                let is_below = if *inclusive { "le" } else { "lt" };
                self.line(&format!("let (first, last) = ({from}, {to});"));
                if !ended {
                    let signed =
                        self.function.local(*variable).ty.as_int().is_some_and(Int::signed);
                    let order = if signed { "" } else { ".unsigned()" };
                    let line = format!("run{level} &= first{order}.{is_below}(last{order});");
                    self.line(&line);
                }
                let start = match (reversed, inclusive) {
                    (false, _) => "first",
                    (true, true) => "last",
                    (true, false) => "last - Whole::of(1)",
                };
                self.line(&format!("let mut {name} = {start};"));
                self.open("loop {");
                false
            }
        };
        let live = if within.returns { " & live" } else { "" };
        self.line(&format!("let m = run{level}{live};"));
        self.open("if !m.any() {");
        self.line("break;");
        self.close();
        if within.continues {
            self.line(&format!("let mut go{level} = m;"));
        }
        self.block(body)?;
        if !counted {
            let one = "Whole::of(1)";
            if !ended {
                let end = match (reversed, inclusive) {
                    (true, _) => "first".to_owned(),
                    (false, true) => "last".to_owned(),
                    (false, false) => format!("last - {one}"),
                };
                self.line(&format!("run{level} &= {name}.differs({end});"));
            }
            let step = if *reversed { "-" } else { "+" };
            self.line(&format!("{name} = {name} {step} {one};"));
        }
        self.close();
        self.close();
        self.loops -= 1;
        Ok(())
    }
}
