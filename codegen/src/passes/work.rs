//! Large temporaries become the caller's: a work struct for each function that needs one.
//!
//! Precondition: a valid, explicit module. Postcondition: no local of more than [`LARGEST`] bytes is
//! left, save a result that is built where the caller wants it, and a constant that is only read. A
//! function that had one takes `work: &mut …Work` as its last parameter; so does every function that
//! calls it, and holds the callee's work in its own. The content of a work struct means nothing
//! between calls.

use std::collections::{BTreeMap, BTreeSet};

use bessemer_ir::visit::{self, Access, Visit, VisitMut, Walk};
use bessemer_ir::{
    Argument, Expr, ExprKind, Field, Float, Function, FunctionId, Given, Kernel, Local, LocalId,
    Mode, Module, Owner, Place, Scalar, Step, Stmt, StmtKind, Struct, StructId, Type,
};

use super::callees::fallible;
use crate::kernels::{self, Buffer, Tuning};

/// Bytes that a local may take on the stack.
pub const LARGEST: u64 = 256;

/// Lends large temporaries from the caller; what kernels need follows from how they are made.
pub fn lend(mut module: Module, tuning: &Tuning) -> Module {
    let mut works: BTreeMap<FunctionId, StructId> = BTreeMap::new();
    for (index, fallible) in fallible(&module).into_iter().enumerate() {
        let id = FunctionId(index as u32);
        if let Some(kernel) = &module.functions[index].kernel {
            if let Some(definition) = scratch(kernel, tuning) {
                let work = StructId(module.structs.len() as u32);
                module.structs.push(definition);
                works.insert(id, work);
                take_work(&mut module.functions[index], work);
            }
            continue;
        }
        let large = large_locals(&module, &module.functions[index], fallible);
        let called = called(&module.functions[index], &works);
        if large.is_empty() && called.is_empty() {
            continue;
        }
        let fields = fields(&module, &module.functions[index], &large, &called, &works);
        let work = StructId(module.structs.len() as u32);
        let definition = definition(&module, &module.functions[index], fields);
        module.structs.push(definition);
        works.insert(id, work);
        rewrite(&mut module.functions[index], work, &large, &called, &works);
    }
    module
}

/// Bytes of a value in C, without padding.
fn bytes(module: &Module, ty: &Type) -> u64 {
    match ty {
        Type::Unit | Type::Slice(_) => 0,
        Type::Scalar(scalar) => scalar_bytes(*scalar),
        Type::Enum(_) => 4,
        Type::Array { element, len } => bytes(module, element) * u64::from(*len),
        Type::Matrix { element, rows, cols } => {
            scalar_bytes(*element) * u64::from(*rows) * u64::from(*cols)
        }
        Type::Struct(id) => {
            module.structs[id.index()].fields.iter().map(|field| bytes(module, &field.ty)).sum()
        }
    }
}

fn scalar_bytes(scalar: Scalar) -> u64 {
    match scalar {
        Scalar::Bool => 1,
        Scalar::Int(int) => u64::from(int.bits() / 8),
        Scalar::Float(Float::F32) => 4,
        Scalar::Float(Float::F64) => 8,
    }
}

/// The locals that are too large for the stack, in the order of their declaration.
fn large_locals(module: &Module, function: &Function, fallible: bool) -> Vec<LocalId> {
    let mut uses = Uses::default();
    uses.block(&function.body);
    let in_place = if fallible { None } else { uses.only_result() };
    let stays = |id: &LocalId| {
        in_place == Some(*id) || (uses.constant.contains(id) && !uses.written.contains(id))
    };
    (function.params..function.locals.len() as u32)
        .map(LocalId)
        .filter(|id| bytes(module, &function.local(*id).ty) > LARGEST && !stays(id))
        .collect()
}

/// How a function uses its locals.
#[derive(Default)]
struct Uses {
    written: BTreeSet<LocalId>,
    constant: BTreeSet<LocalId>,
    /// The local that each `return` returns, if it is a whole local.
    returned: Vec<Option<LocalId>>,
}

impl Uses {
    /// The local that every `return` gives back: the back end builds it in the caller's storage.
    fn only_result(&self) -> Option<LocalId> {
        let first = self.returned.first().copied().flatten()?;
        self.returned.iter().all(|other| *other == Some(first)).then_some(first)
    }
}

impl Visit for Uses {
    fn stmt(&mut self, stmt: &Stmt) {
        match &stmt.kind {
            StmtKind::Let { local, value: Some(value) } => {
                if matches!(value.kind, ExprKind::Const(_)) {
                    self.constant.insert(*local);
                }
            }
            StmtKind::Return(Some(value)) => self.returned.push(match &value.kind {
                ExprKind::Load(place) if place.steps.is_empty() => Some(place.root),
                _ => None,
            }),
            _ => {}
        }
        visit::walk_stmt(self, stmt);
    }

    fn place(&mut self, place: &Place, access: Access) {
        if access != Access::Read {
            self.written.insert(place.root);
        }
        visit::walk_place(self, place);
    }
}

/// The functions called that need work, each once.
fn called(function: &Function, works: &BTreeMap<FunctionId, StructId>) -> Vec<FunctionId> {
    let mut called = BTreeSet::new();
    function.body.each_expr(|expr| {
        if let ExprKind::Call(callee, _) = &expr.kind
            && works.contains_key(callee)
        {
            called.insert(*callee);
        }
    });
    called.into_iter().collect()
}

/// The fields of a function's work: its large locals, then the works of those it calls.
fn fields(
    module: &Module,
    function: &Function,
    large: &[LocalId],
    called: &[FunctionId],
    works: &BTreeMap<FunctionId, StructId>,
) -> Vec<Field> {
    let mut taken: BTreeSet<String> = BTreeSet::new();
    let mut fresh = |wanted: &str| {
        let candidates = std::iter::once(wanted.to_owned())
            .chain((2..).map(|count| format!("{wanted}_{count}")));
        let name = candidates.into_iter().find(|name| taken.insert(name.clone()));
        name.unwrap_or_default()
    };
    let mut fields = Vec::new();
    for id in large {
        let local = function.local(*id);
        // Its name says what it holds, as it does in the function.
        fields.push(Field {
            name: fresh(&local.name),
            docs: Vec::new(),
            ty: local.ty.clone(),
            given: Given::default(),
        });
    }
    for callee in called {
        let name = &module.functions[callee.index()].name;
        let docs = vec![format!("What `{name}` works with.")];
        let ty = Type::Struct(works[callee]);
        let name = fresh(&format!("{name}_work"));
        fields.push(Field { name, docs, ty, given: Given::default() });
    }
    fields
}

fn definition(module: &Module, function: &Function, fields: Vec<Field>) -> Struct {
    let owner = match function.owner {
        Some(Owner::Struct(id)) => Some(module.structs[id.index()].name.as_str()),
        Some(Owner::Enum(id)) => Some(module.enums[id.index()].name.as_str()),
        None => None,
    };
    // As the function is named in C: for its type, or for its module.
    let place = owner.or_else(|| function.module.rsplit("::").next()).unwrap_or_default();
    let path = owner.map_or_else(String::new, |owner| format!("{owner}::")) + &function.name;
    Struct {
        name: format!("{place}_{}_work", function.name),
        module: function.module.clone(),
        docs: vec![format!("What `{path}` works with; its content means nothing between calls.")],
        fields,
        form: bessemer_ir::Form::Record,
        initial: None,
        given: Given::default(),
        span: function.span,
    }
}

/// Makes the work struct the last parameter, and moves the locals into it.
fn rewrite(
    function: &mut Function,
    work: StructId,
    large: &[LocalId],
    called: &[FunctionId],
    works: &BTreeMap<FunctionId, StructId>,
) {
    let parameter = take_work(function, work);
    let mut fields = BTreeMap::new();
    for (field, id) in large.iter().enumerate() {
        // The parameter moved every local behind it by one.
        fields.insert(LocalId(id.0 + 1), field as u32);
    }
    let callees = called
        .iter()
        .enumerate()
        .map(|(index, callee)| {
            let place = Place {
                root: parameter,
                steps: vec![Step::Field((large.len() + index) as u32)],
                ty: Type::Struct(works[callee]),
                span: function.span,
            };
            (*callee, place)
        })
        .collect();
    let types = function.locals.iter().map(|local| local.ty.clone()).collect();
    let mut rewrite = Rewrite { parameter, fields, callees, types };
    rewrite.block(&mut function.body);
}

/// Gives a function its last parameter.
fn take_work(function: &mut Function, work: StructId) -> LocalId {
    let parameter = LocalId(function.params);
    let ty = Type::Struct(work);
    let local = Local { name: "work".into(), ty, mode: Mode::RefMut, span: function.span };
    function.locals.insert(parameter.index(), local);
    function.params += 1;
    parameter
}

/// The work of a kernel that needs more memory than a function may take for itself.
fn scratch(kernel: &Kernel, tuning: &Tuning) -> Option<Struct> {
    let name = kernel.name();
    let lent = kernels::lent(kernel, tuning);
    let field = |buffer: &Buffer| Field {
        name: buffer.name.into(),
        docs: vec![buffer.holds.to_owned()],
        ty: Type::Array { element: Box::new(Type::Scalar(buffer.element)), len: buffer.len },
        given: Given::default(),
    };
    let fields: Vec<Field> = lent.iter().map(field).collect();
    (!fields.is_empty()).then(|| Struct {
        name: format!("{name}_work"),
        module: kernel.function().module,
        docs: vec![format!("What `{name}` works with; its content means nothing between calls.")],
        fields,
        form: bessemer_ir::Form::Record,
        initial: None,
        given: Given::default(),
        span: Default::default(),
    })
}

struct Rewrite {
    parameter: LocalId,
    /// The field that a moved local became.
    fields: BTreeMap<LocalId, u32>,
    /// The work to lend to each callee.
    callees: BTreeMap<FunctionId, Place>,
    types: Vec<Type>,
}

impl Rewrite {
    fn renumbered(&self, local: LocalId) -> LocalId {
        if local >= self.parameter { LocalId(local.0 + 1) } else { local }
    }
}

impl VisitMut for Rewrite {
    fn block(&mut self, block: &mut bessemer_ir::Block) {
        visit::walk_block_mut(self, block);
        // A declaration without a value has nothing left to do.
        block.0.retain(|stmt| {
            !matches!(&stmt.kind, StmtKind::Let { local, value: None } if self.fields.contains_key(local))
        });
    }

    fn stmt(&mut self, stmt: &mut Stmt) {
        visit::walk_stmt_mut(self, stmt);
        if let StmtKind::Let { local, value } = &mut stmt.kind
            && let Some(field) = self.fields.get(local)
            && let Some(value) = value.take()
        {
            let place = Place {
                root: self.parameter,
                steps: vec![Step::Field(*field)],
                ty: self.types[local.index()].clone(),
                span: stmt.span,
            };
            stmt.kind = StmtKind::Assign { place, value };
        }
    }

    fn expr(&mut self, expr: &mut Expr) {
        visit::walk_expr_mut(self, expr);
        if let ExprKind::Call(callee, arguments) = &mut expr.kind
            && let Some(place) = self.callees.get(callee)
        {
            arguments.push(Argument::RefMut(Place { span: expr.span, ..place.clone() }));
        }
    }

    fn place(&mut self, place: &mut Place, _: Access) {
        visit::walk_place_mut(self, place);
        let local = self.renumbered(place.root);
        match self.fields.get(&local) {
            Some(field) => {
                place.root = self.parameter;
                place.steps.insert(0, Step::Field(*field));
            }
            None => place.root = local,
        }
    }

    fn declaration(&mut self, local: &mut LocalId) {
        *local = self.renumbered(*local);
    }
}
