//! Lowers a function of the explicit IR to statements of the C tree.
//!
//! Preconditions, which the passes establish and the validator checks:
//!
//! * an aggregate is the whole value of a `Let`, an `Assign` or a `Return`, or a borrowed argument;
//! * a call is the whole value of a statement, except pure calls of words;
//! * no operation faults: `Check` statements precede it.
//!
//! This step adds conversions where C's promotions differ from Rust's types, a name for every local, and a temporary
//! wherever a result would overwrite an operand.

mod bits;
mod call;
mod compare;
mod copy;
mod extents;
mod fill;
mod join;
mod loops;
mod numbers;
mod numbers_of_matrices;
mod place;
mod range;
mod routine;
mod stmt;
mod unused;
mod variants;
mod widths;
mod word;

use std::collections::{BTreeMap, HashMap, HashSet};

use bessemer_ir::visit::Walk;
use bessemer_ir::{
    Block, ConstId, ExprKind, Function, FunctionId, LocalId, Mode, Owner, Place, Role, Span, Type,
};

use super::analysis::Usage;
use super::choices::Enumerators;
use super::context::{Context, Uses};
use super::helpers::Helper;
use super::layout::{Enums, size_of};
use super::mentions;
use super::names::local_name;
use super::signature::{Passing, Returned, Signature};
use super::spelling::{FIRST_NUMBER, numbered, stem, unique_from};
use super::tree::{
    Declarator, Expr, Init, Lines, Origin, Stmt, StmtKind, Storage, compound, plain,
};
use super::wide::Wide;
use crate::built;
use crate::uncopied::uncopied;

/// A lowered function.
pub struct Lowered {
    /// The body.
    pub body: Vec<Stmt>,
    /// Bytes of its local variables.
    pub locals: u64,
    /// Operations in double or in 64 bits, without those of callees.
    pub wide: Vec<Wide>,
}

/// Representation of a local in C.
#[derive(Clone, Debug)]
struct Binding {
    name: String,
    /// True if the C variable is a pointer to the local.
    pointer: bool,
    /// Constant that the local represents; the file needs it if the local is used.
    constant: Option<ConstId>,
}

impl Binding {
    fn new(name: String, pointer: bool) -> Binding {
        Binding { name, pointer, constant: None }
    }
}

/// The state of lowering one function.
pub(super) struct Lower<'a> {
    context: Context<'a>,
    id: FunctionId,
    function: &'a Function,
    signature: &'a Signature,
    usage: Usage,
    bindings: Vec<Option<Binding>>,
    /// Range of each `usize` local that C holds in 32 bits. For locals that are assigned again, it is known from the
    /// start.
    counters: Vec<Option<(i128, i128)>>,
    /// True for each local that a comparison needs in 64 bits.
    wide: Vec<bool>,
    /// True for each local that the C mentions.
    mentioned: Vec<bool>,
    /// Names that are visible here.
    live: Vec<String>,
    /// The visible names as a set.
    taken: HashSet<String>,
    /// The number from which each stem is looked for: all below are taken.
    free: HashMap<String, u32>,
    out: Vec<Stmt>,
    origin: Option<Origin>,
    uses: &'a mut Uses,
    /// The variable that holds a callee's status.
    status: String,
    /// Field of the component that holds the latched fault.
    latch: Option<Expr>,
    /// True if the function tests the latch before it runs.
    looks: bool,
    /// Local that is the result, in the caller's memory from the start.
    in_place: Option<LocalId>,
    /// Locals that are aliases of places.
    names: BTreeMap<LocalId, Place>,
    /// Constants that name the lengths of locals not declared yet.
    sizes: BTreeMap<LocalId, Vec<Option<ConstId>>>,
    /// Length constants of variables, by their names in C.
    declared: BTreeMap<String, Vec<Option<ConstId>>>,
    /// Locals that are parts of the result from the start.
    parts: BTreeMap<LocalId, built::Path>,
    bytes: u64,
    /// Unroll factor of the next loop, from the author.
    unroll: Option<u32>,
    /// Fields of the struct that the present statement stores which later statements overwrite before they are read.
    spared: Vec<usize>,
}

/// Lowers the body of a function; records its requirements in `uses`.
pub fn function<'a>(context: Context<'a>, id: FunctionId, uses: &'a mut Uses) -> Lowered {
    let function = &context.module.functions[id.index()];
    let mut lower = Lower {
        context,
        id,
        function,
        signature: context.names.signature(id),
        usage: Usage::new(function),
        bindings: vec![None; function.locals.len()],
        counters: crate::passes::sizes(context.module, function),
        wide: crate::passes::wide(function),
        mentioned: vec![false; function.locals.len()],
        live: Vec::new(),
        taken: HashSet::new(),
        free: HashMap::new(),
        out: Vec::new(),
        origin: None,
        uses,
        status: String::new(),
        latch: None,
        looks: false,
        in_place: None,
        names: uncopied(
            context.module,
            function,
            context.names.layout != super::matrices::Layout::Array,
        ),
        sizes: extents::of_locals(context.names, context.module, id),
        declared: BTreeMap::new(),
        parts: BTreeMap::new(),
        bytes: 0,
        unroll: None,
        spared: Vec::new(),
    };
    lower.parameters();
    lower.prologue();
    lower.block_into(&function.body, true);
    lower.epilogue();
    lower.declare_status();
    lower.quiet();
    let wide = lower.wide();
    Lowered { body: lower.out, locals: lower.bytes, wide }
}

impl<'a> Lower<'a> {
    fn parameters(&mut self) {
        let function = self.function;
        self.live = self.signature.params.iter().map(|param| param.name.clone()).collect();
        self.taken = self.live.iter().cloned().collect();
        for (index, local) in function.parameters().iter().enumerate() {
            let name = self.signature.params[index].name.clone();
            let array = local.ty.is_array();
            let by_value = local.ty.is_word() && local.mode != Mode::RefMut;
            self.bindings[index] = Some(Binding::new(name, !array && !by_value));
        }
    }

    /// Emits the code before the author's first statement.
    fn prologue(&mut self) {
        let function = self.function;
        if self.calls_fallible() {
            self.status = self.fresh("status");
        }
        self.check_latch();
        self.check_variants();
        self.in_place = if self.is_fallible() { None } else { built::whole(function) };
        if !self.is_fallible() && self.result_storage().is_some() {
            self.parts = built::parts(function, self.context.module);
        }
        for (index, local) in function.parameters().iter().enumerate() {
            let own =
                local.mode == Mode::Value && local.ty.is_aggregate() && self.usage.assigned[index];
            let name = self.signature.params[index].name.clone();
            if own {
                // The author's own copy, which the caller must not see change.
                let copy = self.fresh(&format!("own_{name}"));
                let from = self.bindings[index].clone().expect("bound above");
                let from = bound(&from);
                if matches!(local.ty, Type::Struct(_)) {
                    self.declare(&local.ty, &copy, Some(Init::Value(from)), false);
                } else {
                    self.declare(&local.ty, &copy, None, false);
                    self.copy(Expr::name(&copy), from, &local.ty, false);
                }
                if !self.usage.read[index] {
                    self.emit(StmtKind::Expr(Expr::cast("void", Expr::name(&copy))));
                }
                self.bindings[index] = Some(Binding::new(copy, false));
            } else if !self.is_used(index) {
                self.emit(StmtKind::Expr(Expr::cast("void", Expr::name(name))));
            }
        }
    }

    fn is_used(&self, parameter: usize) -> bool {
        let looked_at = parameter == 0 && self.looks;
        looked_at || self.usage.read[parameter]
    }

    /// Emits the early return of a component that a fault has stopped.
    fn check_latch(&mut self) {
        let (Role::Entry { .. }, Some(Owner::Struct(owner))) =
            (self.function.role, self.function.owner)
        else {
            return;
        };
        let Some(first) = self.function.parameters().first() else { return };
        let names = &self.context.names.structs[owner.index()];
        let Some(field) = names.fault.as_ref().filter(|_| first.ty == Type::Struct(owner)) else {
            return;
        };
        if self.signature.returned != Returned::Status || first.mode == Mode::Value {
            return;
        }
        let fault = Expr::unary("*", Expr::name(&self.signature.params[0].name)).field(field);
        let ok = Expr::name(&self.context.names.status.ok);
        let back = StmtKind::Return(Some(fault.clone()));
        self.emit(StmtKind::If {
            condition: Expr::binary("!=", fault.clone(), ok),
            then: vec![plain(back)],
            otherwise: Vec::new(),
        });
        self.looks = true;
        // An entry that rolls back can be called again.
        let latches = first.mode == Mode::RefMut && !self.function.attributes.atomic;
        self.latch = latches.then_some(fault);
    }

    fn calls_fallible(&self) -> bool {
        let mut found = false;
        self.function.body.each_expr(|expr| {
            if let ExprKind::Call(callee, _) = &expr.kind {
                found |= self.context.faults.fallible(*callee);
            }
        });
        found
    }

    /// Emits the status of success at the end of a fallible function without a result.
    fn epilogue(&mut self) {
        let returns = self.out.last().is_some_and(stmt::leaves);
        if self.function.result == Type::Unit && self.is_fallible() && !returns {
            self.origin = None;
            self.emit_ok();
        }
    }

    /// Declares the status of calls, unless all of them are in branches that a constant leaves out.
    fn declare_status(&mut self) {
        if !self.status.is_empty() && mentions::names(&self.out, &self.status) {
            let (ty, name) = (self.context.names.status.ty.clone(), self.status.clone());
            let declarator = Declarator { ty, name, dimensions: String::new() };
            self.out.insert(0, plain(StmtKind::Declare(declarator, None)));
        }
    }

    /// Marks unused parameters, and removes locals that the C does not use.
    fn quiet(&mut self) {
        let params = self.function.params as usize;
        let mut names = Vec::new();
        for (index, binding) in self.bindings.iter().enumerate() {
            if !self.usage.read[index] || self.mentioned[index] || index == 0 && self.looks {
                continue;
            }
            // The author's own copy of a parameter is declared like others.
            let declared = binding.as_ref().filter(|binding| {
                index >= params || binding.name != self.signature.params[index].name
            });
            names.extend(declared.map(|binding| binding.name.clone()));
        }
        unused::quiet(&mut self.out, &names);
        let enums = self.context.names.enums.iter().map(|names| names.variants.as_slice());
        Enumerators::new(enums).rewrite(&mut self.out);
        self.place_corrupted();
        self.quiet_parameters();
    }

    /// Marks the parameters that the finished C does not read. A write behind a pointer is a use: the caller reads it.
    fn quiet_parameters(&mut self) {
        for (index, param) in self.signature.params.iter().enumerate() {
            let looked_at = index == 0 && self.looks;
            let used = match param.passing {
                Passing::Value => mentions::reads(&self.out, &param.name) > 0,
                _ => mentions::names(&self.out, &param.name),
            };
            if !looked_at && !used {
                let name = Expr::cast("void", Expr::name(&param.name));
                self.out.insert(0, plain(StmtKind::Expr(name)));
            }
        }
    }

    fn is_fallible(&self) -> bool {
        self.signature.returned == Returned::Status
    }

    fn emit_ok(&mut self) {
        let ok = Expr::name(&self.context.names.status.ok);
        self.emit(StmtKind::Return(Some(ok)));
    }

    /// Appends a statement.
    fn emit(&mut self, kind: StmtKind) {
        self.out.push(Stmt { kind, origin: self.origin });
    }

    /// Emits `place = value`, or `place += …` if the value has this form.
    fn assign(&mut self, place: Expr, value: Expr) {
        match value {
            // A value that needs no conversion in C may be there already: `kept = kept as i32 as u32`.
            value if value == place => {}
            Expr::Binary(op, left, right) if *left == place && compound(op).is_some() => {
                self.emit(StmtKind::Assign(place, compound(op).expect("just seen"), *right));
            }
            value => self.emit(StmtKind::Assign(place, "=", value)),
        }
    }

    /// Runs `inner` in a new scope and returns its statements.
    fn scope(&mut self, inner: impl FnOnce(&mut Self)) -> Vec<Stmt> {
        let (names, outer) = (self.live.len(), std::mem::take(&mut self.out));
        inner(self);
        self.leave(names);
        std::mem::replace(&mut self.out, outer)
    }

    fn block(&mut self, block: &Block, tail: bool) -> Vec<Stmt> {
        self.scope(|lower| lower.block_into(block, tail))
    }

    /// Leaves a scope that began with this number of names.
    fn leave(&mut self, names: usize) {
        for name in self.live.drain(names..) {
            self.taken.remove(&name);
            if let Some((stem, number)) = numbered(&name)
                && let Some(free) = self.free.get_mut(stem)
            {
                *free = number.min(*free);
            }
        }
    }

    /// Returns a name that no visible variable has.
    fn fresh(&mut self, wanted: &str) -> String {
        let wanted = local_name(wanted);
        let live = &self.taken;
        let names = self.context.names;
        let taken = |name: &str| live.contains(name) || names.is_global(name);
        // Beside the result's own name, a local is the value that it will get.
        let result = self.signature.params.get(self.function.params as usize);
        let wanted = match result {
            Some(param) if param.name == wanted => format!("{wanted}_value"),
            _ => wanted,
        };
        let stem = stem(&wanted);
        let first = self.free.get(&stem).copied().unwrap_or(FIRST_NUMBER);
        let (name, number) = unique_from(&wanted, first, taken);
        if let Some(number) = number {
            self.free.insert(stem, number + 1);
        }
        self.live.push(name.clone());
        self.taken.insert(name.clone());
        name
    }

    /// Returns a name for the counter of a loop. A short one that is visible already gives way to the next letter.
    fn counter_name(&mut self, wanted: &str) -> String {
        let is_free =
            |name: &&str| !self.taken.contains(*name) && !self.context.names.is_global(name);
        let next = match wanted {
            "i" | "j" | "k" | "row" | "column" | "col" => {
                [wanted, "i", "j", "k"].into_iter().find(is_free)
            }
            _ => None,
        };
        self.fresh(next.unwrap_or(wanted))
    }

    /// Names a local of the author's.
    fn bind(&mut self, local: LocalId) -> String {
        let author = &self.function.local(local).name;
        let name = self.fresh(if author == "_" { "unused" } else { author });
        self.bindings[local.index()] = Some(Binding::new(name.clone(), false));
        name
    }

    /// Returns the name of a constant in this file.
    fn constant(&self, id: ConstId) -> &str {
        self.context.names.constant(&self.uses.file, id)
    }

    /// Returns the caller's memory for the result.
    fn result_storage(&self) -> Option<Expr> {
        let param = self.signature.params.get(self.function.params as usize)?;
        let pointer = !param.ty.is_array();
        Some(bound(&Binding::new(param.name.clone(), pointer)))
    }

    /// Declares a variable.
    fn declare(&mut self, ty: &Type, name: &str, init: Option<Init>, constant: bool) {
        self.declare_sized(ty, name, &[], init, constant);
    }

    /// Declares a variable with the constants that name its lengths.
    fn declare_sized(
        &mut self,
        ty: &Type,
        name: &str,
        sizes: &[Option<ConstId>],
        init: Option<Init>,
        constant: bool,
    ) {
        self.bytes += size_of(self.context, ty, Enums::Int);
        self.uses.consts.extend(sizes.iter().flatten());
        self.declared.insert(name.to_owned(), sizes.to_vec());
        let mut declarator = self.context.names.sized(ty, name, sizes);
        if constant {
            declarator.ty.insert_str(0, "const ");
        }
        self.include_type(ty);
        self.emit(StmtKind::Declare(declarator, init));
    }

    /// Declares a variable whose parts are written later, possibly by a callee. It is initialised because a variant
    /// writes only its part of a union, and compilers warn when the whole is then copied.
    fn begin(&mut self, ty: &Type, name: &str, sizes: &[Option<ConstId>]) {
        if !self.has_union(ty) {
            self.declare_sized(ty, name, sizes, None, false);
        } else if self.signature.storage == Storage::Inline {
            // In a header, which is C++ too: there, zero is no value of an enum.
            self.uses.system.insert("string.h");
            self.declare(ty, name, None, false);
            let (start, size) = (Expr::name(name).address(), Expr::name(name));
            let arguments = vec![start, Expr::name("0"), Expr::call("sizeof", vec![size])];
            self.emit(StmtKind::Expr(Expr::call("memset", arguments)));
        } else {
            let zero = vec![(None, Init::Value(Expr::name("0")))];
            let zero = Init::List { items: zero, lines: Lines::Fill };
            self.declare(ty, name, Some(zero), false);
        }
    }

    /// Returns true if a value contains a union.
    fn has_union(&self, ty: &Type) -> bool {
        match ty {
            Type::Struct(id) => {
                let item = &self.context.module.structs[id.index()];
                item.overlaid() || item.fields.iter().any(|field| self.has_union(&field.ty))
            }
            Type::Array { element, .. } => self.has_union(element),
            _ => false,
        }
    }

    /// Records the header of a type.
    fn include_type(&mut self, ty: &Type) {
        match ty {
            Type::Struct(id) => {
                self.uses.headers.insert(self.context.names.structs[id.index()].header.clone());
            }
            Type::Enum(id) => {
                self.uses.headers.insert(self.context.names.enums[id.index()].header.clone());
            }
            Type::Array { element, .. } | Type::Slice(element) => self.include_type(element),
            _ => {}
        }
    }

    fn at(&mut self, span: Span) {
        self.origin = (span.line > 0).then_some(Origin { file: span.file, line: span.line });
    }

    fn helper(&mut self, helper: Helper, arguments: Vec<Expr>) -> Expr {
        self.uses.helpers.insert(helper.normal());
        Expr::call(helper.name(), arguments)
    }
}

fn bound(binding: &Binding) -> Expr {
    let name = Expr::name(&binding.name);
    if binding.pointer { Expr::unary("*", name) } else { name }
}
