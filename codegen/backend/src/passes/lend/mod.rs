//! Moves large temporaries to the caller's memory, laid out by their lifetimes.
//!
//! Precondition: a valid, explicit module. Postcondition: no local has more than [`LARGEST`] bytes, except one that
//! is built in the caller's result, an alias of a place, and a constant table. The others use memory of the caller:
//!
//! * a function has, as its last parameters, a row of elements for each element type of its temporaries; an entry
//!   point has one work struct, whose content has no meaning between calls;
//! * a large local becomes an alias of its part of this memory (a `let` of mode `RefMut`);
//! * two that are never alive together share memory, and so does memory for calls: [`lives`] computes lifetimes,
//!   [`rows`] positions.
//!
//! Lifetimes are computed by statements; a loop counts as one statement if a value outlives a pass. Must not know:
//! the C text.

mod entry;
mod lives;
mod rewrite;
mod row;
mod rows;

use bessemer_ir::visit::{self, Access, Visit};
use bessemer_ir::{
    ExprKind, Field, Float, Function, Given, Kernel, Local, LocalId, Mode, Module, Place, Role,
    Scalar, Span, Stmt, StmtKind, Struct, StructId, Type,
};
use std::collections::{BTreeMap, BTreeSet};

use super::callees::fallible;
use crate::built;
use crate::kernels::{self, Buffer, Tuning};
use crate::uncopied::{is_table, uncopied};
use lives::Life;
use row::{Need, Row, noun};
use rows::Laid;

/// Largest size of a local on the stack, bytes.
pub const LARGEST: u64 = 256;

/// Moves large temporaries to callers' memory; `tuning` determines the memory of kernels. `flat`: matrices are arrays
/// of scalars in the C.
pub fn lend(mut module: Module, tuning: &Tuning, flat: bool) -> Module {
    let mut needs: Vec<Need> = Vec::new();
    for (index, fallible) in fallible(&module).into_iter().enumerate() {
        let need = match &module.functions[index].kernel {
            Some(kernel) => match scratch(kernel, tuning) {
                Some(definition) => lend_struct(&mut module, index, definition).1,
                None => Need::new(),
            },
            None => lend_body(&mut module, index, fallible, &needs, flat),
        };
        needs.push(need);
    }
    module
}

/// Moves the large temporaries of a function, and returns the memory that it needs.
fn lend_body(
    module: &mut Module,
    index: usize,
    fallible: bool,
    needs: &[Need],
    flat: bool,
) -> Need {
    let function = &module.functions[index];
    let names = uncopied(module, function, flat);
    let large = large_locals(module, function, fallible, &names);
    let lives = Life::of(function, &large, &names, needs, flat);
    if lives.is_empty() {
        return Need::new();
    }
    if let Role::Entry { .. } = function.role {
        let plan = entry::plan(&lives, &|ty| bytes(module, ty));
        let (mut definitions, at) = entry::structs(module, function, &lives, &plan);
        let Some(own) = definitions.pop() else { return Need::new() };
        module.structs.append(&mut definitions);
        let (work, need) = lend_struct(module, index, own);
        let row = |laid: &Laid| entry::place(laid, &at, work);
        let mut body = module.functions[index].clone();
        rewrite::rewrite(module, &mut body, 1, &lives, &plan.laid, &row);
        module.functions[index] = body;
        return need;
    }
    let (need, laid) = rows::lay(&lives);
    let names = row_names(module, &need);
    let function = &mut module.functions[index];
    let said = names.iter().map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", ");
    let (is, its) = if names.len() == 1 { ("is", "its") } else { ("are", "their") };
    let text = format!("{said} {is} scratch memory; {its} contents mean nothing between calls.");
    function.docs.push(text);
    let taken: Vec<LocalId> =
        need.iter().zip(names).map(|(row, name)| take(function, name, row.ty())).collect();
    let row = |laid: &Laid| Place {
        root: taken[laid.row],
        steps: Vec::new(),
        ty: need[laid.row].ty(),
        span: Default::default(),
    };
    let mut body = function.clone();
    rewrite::rewrite(module, &mut body, need.len() as u32, &lives, &laid, &row);
    module.functions[index] = body;
    need
}

/// Adds a parameter for a function's work struct.
fn lend_struct(module: &mut Module, index: usize, definition: Struct) -> (LocalId, Need) {
    let work = StructId(module.structs.len() as u32);
    module.structs.push(definition);
    let row = Row { element: Type::Struct(work), len: 1 };
    (take(&mut module.functions[index], "work".into(), row.ty()), vec![row])
}

/// Adds a last parameter to a function; the handles of later locals increase by one.
fn take(function: &mut Function, name: String, ty: Type) -> LocalId {
    let parameter = LocalId(function.params);
    let local = Local { name, ty, mode: Mode::RefMut, span: function.span };
    function.locals.insert(parameter.index(), local);
    function.params += 1;
    parameter
}

/// Returns the names of the rows that a function needs.
fn row_names(module: &Module, need: &[Row]) -> Vec<String> {
    match need {
        [_] => vec!["work".into()],
        rows => rows.iter().map(|row| format!("work_{}", noun(module, &row.element))).collect(),
    }
}

/// Returns the bytes of a value in C, without padding.
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
            let item = &module.structs[id.index()];
            let fields = item.fields.iter().map(|field| bytes(module, &field.ty));
            if item.form == bessemer_ir::Form::Shared {
                fields.max().unwrap_or_default()
            } else {
                fields.sum()
            }
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

/// Returns the locals that are too large for the stack, in the order of their declarations.
fn large_locals(
    module: &Module,
    function: &Function,
    fallible: bool,
    names: &BTreeMap<LocalId, Place>,
) -> Vec<LocalId> {
    let mut uses = Uses { module, written: BTreeSet::new(), constant: BTreeSet::new() };
    uses.block(&function.body);
    let whole = if fallible { None } else { built::whole(function) };
    let parts = if fallible { Default::default() } else { built::parts(function, module) };
    let stays = |id: &LocalId| {
        whole == Some(*id)
            || parts.contains_key(id)
            || names.contains_key(id)
            || (uses.constant.contains(id) && !uses.written.contains(id))
    };
    (function.params..function.locals.len() as u32)
        .map(LocalId)
        .filter(|id| bytes(module, &function.local(*id).ty) > LARGEST && !stays(id))
        .collect()
}

/// Use of a function's locals.
struct Uses<'m> {
    module: &'m Module,
    written: BTreeSet<LocalId>,
    constant: BTreeSet<LocalId>,
}

impl Visit for Uses<'_> {
    fn stmt(&mut self, stmt: &Stmt) {
        if let StmtKind::Let { local, value: Some(value) } = &stmt.kind
            && (matches!(value.kind, ExprKind::Const(_)) || is_table(self.module, value))
        {
            self.constant.insert(*local);
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

/// Returns the work struct of a kernel; none if its buffers fit on the stack.
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
    let docs =
        vec![format!("Working memory of `{name}`; the contents are undefined between calls.")];
    let module = kernel.function().module;
    (!fields.is_empty())
        .then(|| entry::record((format!("{name}_work"), module, Span::default()), docs, fields))
}
