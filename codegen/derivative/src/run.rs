//! State of an evaluation: the written statements and the locals, and the whole of a derivative.

use std::collections::{BTreeMap, BTreeSet};

use bessemer_ir::visit::{self, Access, VisitMut};
use bessemer_ir::{
    Block, Expr, ExprKind, Function, FunctionId, Local, LocalId, Mode, Module, Place, Role, Span,
    Step, Stmt, StmtKind, Type, effects,
};

use crate::covariance::elements;
use crate::value::{Tangents, Value, Word};
use crate::{Request, Result, float, jacobian};

/// Values of the locals of a function at a place of its path.
#[derive(Clone, Debug, Default)]
pub struct Env {
    /// Values by local.
    pub locals: BTreeMap<LocalId, Value>,
    /// Places that locals of mode `RefMut` alias.
    pub aliases: BTreeMap<LocalId, crate::place::Route>,
    /// Value that the path returned.
    pub result: Option<Value>,
    /// True if the path has left the loop that is written.
    pub ended: bool,
    /// Number of passes of the unrolled loops around.
    pub passes: u64,
}

/// A function that is evaluated, or the body of a loop in it that stays a loop.
#[derive(Clone, Copy)]
pub struct Frame<'f> {
    /// The function.
    pub function: &'f Function,
    /// Variables of the loop, if it is one.
    pub carried: Option<&'f [crate::loops::Carried]>,
}

/// An evaluation.
pub struct Run<'m> {
    /// Module of the function.
    pub module: &'m Module,
    /// Functions that the derivative needs besides those of the module.
    added: Vec<Function>,
    /// Locals of the derivative.
    pub locals: Vec<Local>,
    /// Statements of the current block.
    pub out: Vec<Stmt>,
    /// Variables of each word that the loop around carries, as its passes assigned them.
    pub found: Vec<BTreeSet<u32>>,
    /// Variables of loops, as passes on trial found them.
    pub trials: crate::loops::Trials,
    /// Number of evaluated statements.
    pub steps: u32,
    /// Number of comparisons around: their operands need no derivatives.
    pub compared: u32,
    /// Name for the next values.
    pub name: String,
    /// Name for the result of the function that is evaluated, if its call has one.
    pub result_name: Option<String>,
    /// Calls of elementary functions in the blocks around, with their values.
    pub calls: Vec<(Expr, Expr)>,
    /// True if a way backwards follows, so that matrices are evaluated by elements.
    pub backwards: bool,
    /// Number of parameters.
    pub params: u32,
    /// Locals with the counter of the last pass, by the counters of loops that may end early.
    pub ends: BTreeMap<LocalId, LocalId>,
}

impl<'m> Run<'m> {
    /// Creates the evaluation of a request, whose signature fits.
    pub fn new(module: &'m Module, request: &Request) -> Run<'m> {
        let declared = &module.functions[request.into.index()];
        let locals = declared.parameters().to_vec();
        Run {
            module,
            added: Vec::new(),
            locals,
            out: Vec::new(),
            found: Vec::new(),
            trials: crate::loops::Trials::default(),
            steps: 0,
            compared: 0,
            name: String::new(),
            result_name: None,
            calls: Vec::new(),
            backwards: false,
            params: declared.params,
            ends: BTreeMap::new(),
        }
    }

    /// Returns the module with the added functions, and the locals.
    pub fn finish(self) -> (Module, Vec<Local>) {
        let mut module = self.module.clone();
        module.functions.extend(self.added);
        (module, self.locals)
    }

    /// Returns the body of the derivative.
    pub fn whole(&mut self, request: &Request) -> Result<Block> {
        let module = self.module;
        let of = &module.functions[request.of.index()];
        let into = &module.functions[request.into.index()];
        let span = into.span;
        let mut env = Env { passes: 1, ..Env::default() };
        let mut first = 0;
        let mut starts = vec![];
        for (index, parameter) in into.parameters().iter().enumerate().take(of.params as usize) {
            let id = LocalId(index as u32);
            let mut value = Value::at(Place::local(id, parameter.ty.clone(), span));
            if request.by.contains(&index) {
                let mut next = first;
                value.each(module, &mut |word| {
                    let one = float(1.0, &word.value.ty, span);
                    word.tangents.insert(next, one);
                    next += 1;
                    Ok(())
                })?;
                starts.push((index, first..next));
                first = next;
            }
            env.locals.insert(id, value);
        }
        let result = self.function(of, env)?.result.unwrap_or(Value::Parts(Vec::new()));
        let words = self.plain(result, span)?.words(module);
        let value = self.aggregate(&of.result, words.iter().map(|word| word.value.clone()));
        if let Some(covariance) = crate::covariance(module, request) {
            let (root, size) = (LocalId(of.params), words.len() as u32);
            // Early, since the covariance does not need the state any more.
            let value = self.atom(value, "next");
            if let Some(place) = elements(module, root, &covariance.ty, size, span) {
                self.propagate(&words, place, span)?;
            }
            self.emit(StmtKind::Return(Some(value)), span);
            return Ok(Block(std::mem::take(&mut self.out)));
        }
        let mut fields = vec![value];
        for index in &request.by {
            let Some((_, range)) = starts.iter().find(|it| it.0 == *index) else { continue };
            fields.push(self.matrix(&words, range.clone(), span));
        }
        let result = Expr { kind: ExprKind::Struct(fields), ty: into.result.clone(), span };
        self.emit(StmtKind::Return(Some(result)), span);
        Ok(Block(std::mem::take(&mut self.out)))
    }

    /// Writes the Jacobian of the words by variables, and returns it.
    fn matrix(&mut self, words: &[Word], by: std::ops::Range<u32>, span: Span) -> Expr {
        let leaf = words.first().map_or(Type::F64, |word| word.value.ty.clone());
        let number = leaf.as_float().unwrap_or(bessemer_ir::Float::F64);
        let zero = float(0.0, &leaf, span);
        let ty = jacobian(number, words.len() as u32, by.end - by.start);
        if ty.is_word() {
            let tangent = words.first().and_then(|word| word.tangents.get(&by.start).cloned());
            return tangent.unwrap_or(zero);
        }
        let splat = Expr { kind: ExprKind::Splat(Box::new(zero)), ty: ty.clone(), span };
        let local = self.declare("jacobian", &ty, span);
        self.emit(StmtKind::Let { local, value: Some(splat) }, span);
        let whole = Place::local(local, ty, span);
        for (row, word) in words.iter().enumerate() {
            for (variable, tangent) in word.tangents.range(by.clone()) {
                let at = |index: u64| Expr::usize(index, span);
                let step = Step::Element(at(row as u64), at(u64::from(variable - by.start)));
                let place = whole.inside(step, leaf.clone());
                self.emit(StmtKind::Assign { place, value: tangent.clone() }, span);
            }
        }
        whole.load()
    }

    /// Returns a value of a type from its words.
    pub fn aggregate(&mut self, ty: &Type, words: impl Iterator<Item = Expr>) -> Expr {
        let mut words = words;
        self.build(ty, &mut words)
    }

    fn build(&mut self, ty: &Type, words: &mut dyn Iterator<Item = Expr>) -> Expr {
        if ty.is_word() {
            return words.next().unwrap_or_else(|| Expr::literal(0, ty.clone(), Span::default()));
        }
        let parts = crate::value::parts(self.module, ty, Span::default());
        let all: Vec<Expr> = parts.iter().map(|(_, ty)| self.build(ty, words)).collect();
        let span = all.first().map_or_else(Span::default, |first| first.span);
        if let Some(whole) = self.place_of(ty, &parts, &all) {
            return whole.load();
        }
        let kind = match ty {
            Type::Struct(_) => ExprKind::Struct(all),
            Type::Matrix { .. } => ExprKind::Matrix(all),
            _ => ExprKind::Array(all),
        };
        Expr { kind, ty: ty.clone(), span }
    }

    /// Returns the place of a type whose parts these are, in their order.
    fn place_of(&self, ty: &Type, parts: &[(Step, Type)], all: &[Expr]) -> Option<Place> {
        let ExprKind::Load(first) = &all.first()?.kind else { return None };
        let (_, around) = first.steps.split_last()?;
        let mut found = self.locals[first.root.index()].ty.clone();
        for step in around {
            found = self.module.step_type(&found, step)?;
        }
        let whole = Place { steps: around.to_vec(), ty: ty.clone(), ..first.clone() };
        let is_part = |(of, (step, ty)): (&Expr, &(Step, Type))| match &of.kind {
            ExprKind::Load(place) => {
                effects::same_place(place, &whole.inside(step.clone(), ty.clone()))
            }
            _ => false,
        };
        (found == *ty && all.iter().zip(parts).all(is_part)).then_some(whole)
    }

    /// Writes a statement.
    pub fn emit(&mut self, kind: StmtKind, span: Span) {
        self.out.push(Stmt::new(kind, span));
    }

    /// Writes the statements of `write` to a block of their own.
    pub fn captured<T>(
        &mut self,
        write: impl FnOnce(&mut Self) -> Result<T>,
    ) -> Result<(Block, T)> {
        let outer = std::mem::take(&mut self.out);
        let calls = self.calls.len();
        let result = write(self);
        self.calls.truncate(calls);
        let block = Block(std::mem::replace(&mut self.out, outer));
        Ok((block, result?))
    }

    /// Declares a local.
    pub fn declare(&mut self, name: &str, ty: &Type, span: Span) -> LocalId {
        let id = LocalId(self.locals.len() as u32);
        let name = if name.is_empty() { "value" } else { name };
        self.locals.push(Local { name: name.to_owned(), ty: ty.clone(), mode: Mode::Value, span });
        id
    }

    /// Declares a local with a value, and returns its value.
    pub fn bind(&mut self, name: &str, value: Expr) -> Expr {
        let (ty, span) = (value.ty.clone(), value.span);
        let local = self.declare(name, &ty, span);
        self.emit(StmtKind::Let { local, value: Some(value) }, span);
        Expr::local(local, &ty, span)
    }

    /// Returns a value that costs nothing to use twice.
    pub fn atom(&mut self, value: Expr, name: &str) -> Expr {
        match value.kind {
            ExprKind::Literal(_) | ExprKind::Const(_) | ExprKind::Load(_) => value,
            _ => self.bind(name, value),
        }
    }

    /// Makes a word and its derivatives atoms named after `name`.
    pub fn hold(&mut self, word: Word, name: &str) -> Word {
        let value = self.atom(word.value, name);
        let tangents = word.tangents.into_iter();
        let tangents: Tangents = tangents
            .map(|(variable, it)| (variable, self.atom(it, &format!("{name}_d{variable}"))))
            .collect();
        Word { value, tangents }
    }

    /// Makes all words of a value atoms.
    pub fn held(&mut self, value: Value, name: &str) -> Value {
        match value {
            Value::Leaf(word) => Value::Leaf(self.hold(word, name)),
            Value::Parts(parts) => {
                let held = |(index, part)| self.held(part, &format!("{name}_{index}"));
                Value::Parts(parts.into_iter().enumerate().map(held).collect())
            }
            place => place,
        }
    }

    /// Returns the value of an elementary function of the DSL. A second call with the same operands has the value of the
    /// first.
    pub fn elementary(&mut self, name: &str, operands: Vec<Expr>) -> Expr {
        let (ty, span) = operands
            .first()
            .map_or((Type::F64, Span::default()), |first| (first.ty.clone(), first.span));
        let base = self.module.functions.len();
        let is = |it: &Function| it.name == name && it.result == ty;
        let found = self.added.iter().position(is);
        let index = found.unwrap_or_else(|| {
            let local = |operand: &Expr| Local {
                name: "x".to_owned(),
                ty: operand.ty.clone(),
                mode: Mode::Value,
                span,
            };
            self.added.push(Function {
                name: name.to_owned(),
                module: crate::rules::MATH.to_owned(),
                owner: None,
                role: Role::Public,
                attributes: Default::default(),
                docs: Vec::new(),
                locals: operands.iter().map(local).collect(),
                params: operands.len() as u32,
                result: ty.clone(),
                result_name: "result".to_owned(),
                body: Block::default(),
                kernel: None,
                span,
            });
            self.added.len() - 1
        });
        let id = FunctionId((base + index) as u32);
        let label = operands.first().map_or_else(String::new, |it| self.label(it));
        let label = format!(
            "{}{label}",
            name.strip_suffix('f').filter(|_| ty == Type::F32).unwrap_or(name)
        );
        let argument = |it: Expr| bessemer_ir::Argument::Value(placeless(it));
        let arguments = operands.into_iter().map(argument).collect();
        let call = Expr { kind: ExprKind::Call(id, arguments), ty, span: Span::default() };
        if let Some((_, value)) = self.calls.iter().find(|it| it.0 == call) {
            return value.clone();
        }
        let value = self.bind(&label, call.clone());
        self.calls.push((call, value.clone()));
        value
    }

    /// Returns a function of the module, or one that was added.
    pub fn function_of(&self, id: FunctionId) -> &Function {
        let base = self.module.functions.len();
        match id.index().checked_sub(base) {
            Some(added) => &self.added[added],
            None => &self.module.functions[id.index()],
        }
    }

    /// Returns the function of a kernel.
    pub fn kernel_function(&mut self, kernel: bessemer_ir::Kernel) -> FunctionId {
        let all = self.module.functions.iter().chain(&self.added);
        let mut known = all.map(|it| it.kernel.as_ref() == Some(&kernel));
        let at = known.position(|it| it).unwrap_or_else(|| {
            self.added.push(kernel.function());
            self.module.functions.len() + self.added.len() - 1
        });
        FunctionId(at as u32)
    }

    /// Returns the name of an operand for names of values that depend on it.
    fn label(&self, operand: &Expr) -> String {
        let ExprKind::Load(place) = &operand.kind else { return String::new() };
        let mut label = format!("_{}", self.locals[place.root.index()].name);
        let mut ty = self.locals[place.root.index()].ty.clone();
        for step in &place.steps {
            let more = match (step, &ty) {
                (Step::Field(field), Type::Struct(id)) => {
                    let fields = &self.module.structs[id.index()].fields;
                    fields.get(*field as usize).map(|it| it.name.clone())
                }
                (Step::Index(at) | Step::Element(at, _), _) => {
                    crate::expression::literal(at).map(|at| at.to_string())
                }
                _ => None,
            };
            if let Some(more) = more {
                label = format!("{label}_{more}");
            }
            ty = self.module.step_type(&ty, step).unwrap_or(Type::Unit);
        }
        label
    }
}

/// Returns an expression without spans, by which equal expressions are found.
pub fn placeless(mut expr: Expr) -> Expr {
    struct Placeless;
    impl VisitMut for Placeless {
        fn expr(&mut self, expr: &mut Expr) {
            expr.span = Span::default();
            visit::walk_expr_mut(self, expr);
        }
        fn place(&mut self, place: &mut Place, _: Access) {
            place.span = Span::default();
            visit::walk_place_mut(self, place);
        }
    }
    Placeless.expr(&mut expr);
    expr
}
