//! Values with several words: initialisers, copies, fills, constructors.

use bessemer_ir::visit::Walk as _;
use bessemer_ir::{Expr as Ir, ExprKind, Form, Place, Step, StructId, Type};

use super::super::status::{FEW, FEW_OPERATIONS};
use super::super::tree::{Declarator, Expr, Init, Lines, Step as ForStep, StmtKind, Storage};
use super::Lower;
use super::fill::length;
use super::stmt::is_simple;
use crate::uncopied::is_stored_whole;
use bessemer_ir::effects::{overlap, reads_place};

/// Largest number of words that are copied one per line.
const LINES: u32 = 4;
/// Largest number of zeros in an initialiser.
const SHOWN: u32 = 8;
/// Largest number of words in a value that one statement builds, since a compiler may keep it on the stack.
const BRIEF: usize = 16;
/// Largest number of equal words in an initialiser.
const LISTED: u32 = 16;

impl Lower<'_> {
    /// Emits the assignment of a value to `dest`. `place` is the author's place of `dest`, if operands may share its
    /// memory.
    pub(super) fn store(&mut self, dest: Expr, place: Option<&Place>, value: &Ir) {
        if let ExprKind::Call(callee, arguments) = &value.kind
            && (value.ty.is_aggregate() || self.context.faults.fallible(*callee))
        {
            self.call_into(*callee, arguments, dest, &value.ty);
            return;
        }
        if value.ty.is_word() {
            let value = self.given(value);
            self.assign(dest, value);
            return;
        }
        let built = matches!(
            value.kind,
            ExprKind::Struct(_) | ExprKind::Array(_) | ExprKind::Matrix(_) | ExprKind::Splat(_)
        );
        if built && place.is_some_and(|place| reads_place(value, place)) {
            self.spared.clear();
            self.store_through_copy(dest, value);
            return;
        }
        if let Some((ty, init)) = self.brief(value) {
            self.emit(StmtKind::Build(dest, ty, init));
            return;
        }
        match &value.kind {
            ExprKind::Load(from) => {
                let shared = place.is_some_and(|place| overlap(place, from));
                let from = self.place(from);
                if from != dest {
                    self.copy(dest, from, &value.ty, shared);
                }
            }
            ExprKind::Const(_) => {
                let from = self.operand(value);
                self.copy(dest, from, &value.ty, false);
            }
            ExprKind::Routine(routine, operands) => {
                self.store_routine(dest, place, (*routine, operands), value);
            }
            ExprKind::Splat(_) => self.construct(dest, value),
            _ if self.spared.is_empty() && is_stored_whole(self.context.module, value) => {
                let own = self.result_storage() == Some(dest.clone());
                let wanted = match dest.last_name() {
                    _ if own => self.function.name.clone(),
                    Some(name) => format!("new_{name}"),
                    None => "constants".to_owned(),
                };
                let name = self.fresh(&wanted);
                self.declare_table(&value.ty, &name, value);
                self.copy(dest, Expr::name(name), &value.ty, false);
            }
            _ => self.construct(dest, value),
        }
    }

    /// Declares a constant table of the function.
    pub(super) fn declare_table(&mut self, ty: &Type, name: &str, value: &Ir) {
        let init = self.initialiser(value);
        let mut declarator = self.context.names.declarator(ty, name);
        declarator.ty.insert_str(0, "static const ");
        self.include_type(ty);
        self.emit(StmtKind::Declare(declarator, Some(init)));
    }

    /// Builds the value in a temporary, since it reads its destination.
    pub(super) fn store_through_copy(&mut self, dest: Expr, value: &Ir) {
        let block = self.scope(|lower| {
            let name = lower.fresh("next");
            lower.define(&value.ty, &name, value, true);
            lower.copy(dest, Expr::name(name), &value.ty, false);
        });
        self.emit(StmtKind::Block(block));
    }

    /// Assigns a value part by part.
    fn construct(&mut self, dest: Expr, value: &Ir) {
        match (&value.kind, &value.ty) {
            (ExprKind::Struct(items), Type::Struct(id)) => {
                let names = &self.context.names.structs[id.index()];
                let spared = std::mem::take(&mut self.spared);
                for (index, (item, field)) in items.iter().zip(&names.fields).enumerate() {
                    let written_later = self.is_part(item) || spared.contains(&index);
                    if !self.is_held(*id, index, items) || written_later {
                        continue;
                    }
                    self.store(dest.clone().field(field), None, item);
                }
                if let Some(field) = &names.fault {
                    let ok = Expr::name(&self.context.names.status.ok);
                    self.assign(dest.field(field), ok);
                }
            }
            (ExprKind::Array(items), _) => {
                for (index, item) in items.iter().enumerate() {
                    self.store(dest.clone().at(Expr::name(index.to_string())), None, item);
                }
            }
            (ExprKind::Matrix(items), Type::Matrix { rows, cols, .. }) => {
                let sparse = is_sparse(items);
                if let Some(zero) = items.iter().find(|item| sparse && self.is_zero(item)) {
                    self.fill(dest.clone(), &value.ty, zero);
                }
                for (index, item) in items.iter().enumerate() {
                    if sparse && self.is_zero(item) {
                        continue;
                    }
                    let layout = self.context.names.layout;
                    let element = layout.by_columns(dest.clone(), (*rows, *cols), index as u32);
                    self.store(element, None, item);
                }
            }
            (ExprKind::Splat(item), ty) => self.fill(dest, ty, item),
            (kind, _) => unreachable!("the validator refuses {kind:?} as a whole value"),
        }
    }

    /// Returns a compound literal for a value some of whose fields are empty: `(option_pair_t){.is_some = false}`. C
    /// sets omitted fields to zero, as in Rust and in the interpreter, and callers may read them. Not in a header,
    /// since C++ has no such expression.
    fn brief(&mut self, value: &Ir) -> Option<(String, Init)> {
        let (ExprKind::Struct(items), Type::Struct(id)) = (&value.kind, &value.ty) else {
            return None;
        };
        let module = self.context.module;
        let (nothing, held): (Vec<_>, Vec<_>) =
            items.iter().enumerate().partition(|(index, _)| self.is_nothing(*id, *index, items));
        let wanted = !nothing.is_empty()
            && !module.structs[id.index()].overlaid()
            && module.width(&value.ty) <= BRIEF
            && held.iter().all(|(_, item)| self.initialisable(item))
            && !value.any_expr(|item| self.is_part(item));
        if !wanted {
            return None;
        }
        let ty = self.context.names.structs[id.index()].ty.clone();
        Some((ty, self.initialiser(value)))
    }

    /// Returns true if a field is empty according to the tag, and zero in C, too.
    fn is_nothing(&self, id: StructId, index: usize, items: &[Ir]) -> bool {
        let definition = &self.context.module.structs[id.index()];
        let tag = match (&definition.form, items.first().map(|first| &first.kind)) {
            (Form::Choice(_), Some(ExprKind::Literal(word))) => *word,
            _ => return false,
        };
        let in_source = self.signature.storage != Storage::Inline;
        in_source && !definition.holds(index, tag) && self.is_zero_in_c(&items[index])
    }

    /// Returns true if each byte of a value is zero in C.
    fn is_zero_in_c(&self, value: &Ir) -> bool {
        match (&value.kind, &value.ty) {
            (ExprKind::Literal(0), Type::Enum(id)) => {
                let variants = &self.context.module.enums[id.index()].variants;
                variants.first().is_some_and(|first| first.value == 0)
            }
            (ExprKind::Literal(word), _) => *word == 0,
            (ExprKind::Splat(item), _) => self.is_zero_in_c(item),
            (ExprKind::Struct(items) | ExprKind::Array(items) | ExprKind::Matrix(items), _) => {
                items.iter().all(|item| self.is_zero_in_c(item))
            }
            _ => false,
        }
    }

    /// Returns true if a value is zero everywhere, as is the part that an initialiser omits. The first variant of an
    /// enum may have another number.
    fn is_zero(&self, value: &Ir) -> bool {
        match &value.kind {
            ExprKind::Literal(_) => self.is_zero_in_c(value),
            ExprKind::Splat(item) => self.is_zero(item),
            _ => false,
        }
    }

    /// Returns true if a value is already built in its place in the result.
    fn is_part(&self, item: &Ir) -> bool {
        matches!(&item.kind, ExprKind::Load(place)
            if place.steps.is_empty() && self.parts.contains_key(&place.root))
    }

    /// Returns true if a field of a struct is written: not one whose memory another variant's payload uses.
    fn is_held(&self, id: StructId, index: usize, parts: &[Ir]) -> bool {
        let definition = &self.context.module.structs[id.index()];
        let word = match parts.first().map(|first| &first.kind) {
            Some(ExprKind::Literal(word)) => *word,
            _ => 0,
        };
        !definition.overlaid() || definition.holds(index, word)
    }

    /// Emits the assignment of one value to every element.
    fn fill(&mut self, dest: Expr, ty: &Type, item: &Ir) {
        if let Type::Matrix { element, rows, cols } = ty
            && !self.context.names.layout.is_flat((*rows, *cols))
        {
            let array = self.context.names.layout.array(*element, (*rows, *cols));
            let value = self.once("value", item, None);
            return self.fill_rows(dest, &array, &value);
        }
        let count = length(ty);
        let simple =
            matches!(item.kind, ExprKind::Literal(_) | ExprKind::Const(_) | ExprKind::Load(_));
        if count <= LINES && (simple || !item.ty.is_word()) {
            for index in 0..count {
                self.store(dest.clone().at(Expr::name(index.to_string())), None, item);
            }
            return;
        }
        let mut value = None;
        if item.ty.is_word() && !simple {
            let once = self.word(item);
            let name = self.fresh("value");
            self.declare(&item.ty, &name, Some(Init::Value(once)), true);
            value = Some(Expr::name(name));
        }
        self.count_up(count, &dest.clone(), |lower, index| match value {
            Some(value) => lower.assign(dest.at(index), value),
            None => lower.store(dest.at(index), None, item),
        });
    }

    /// Emits loops that assign one value to each element of nested arrays.
    fn fill_rows(&mut self, dest: Expr, ty: &Type, value: &Expr) {
        match ty {
            Type::Array { element, len } => self.count_up(*len, &dest.clone(), |lower, index| {
                lower.fill_rows(dest.at(index), element, value);
            }),
            _ => self.assign(dest, value.clone()),
        }
    }

    /// Emits the request to write out the passes of the next loop, which has `count`, if these are few, each of few
    /// operations. Other files may include a function of a header without the macro.
    pub(super) fn few(&mut self, count: u32, operations: u32) {
        let is_brief = (2..=FEW).contains(&count) && count * operations <= FEW_OPERATIONS;
        let few = is_brief && self.signature.storage != Storage::Inline;
        if let Some(macro_) = self.context.names.status.few.as_ref().filter(|_| few) {
            self.emit(StmtKind::Verbatim(macro_.clone()));
        }
    }

    /// Emits `for (uint32_t i = 0U; i < count; i++) { body }` over a whole array, whose length may be a named
    /// constant.
    pub(super) fn count_up(
        &mut self,
        count: u32,
        array: &Expr,
        body: impl FnOnce(&mut Self, Expr),
    ) {
        let end = self.extent(array, count);
        self.count_to("i", 0, count, end, body);
    }

    /// Emits a loop from `first` to `count`, with a name for the counter.
    pub(super) fn count_from(
        &mut self,
        name: &str,
        first: u32,
        count: u32,
        body: impl FnOnce(&mut Self, Expr),
    ) {
        self.count_to(name, first, count, Expr::name(format!("{count}U")), body);
    }

    fn count_to(
        &mut self,
        name: &str,
        first: u32,
        count: u32,
        end: Expr,
        body: impl FnOnce(&mut Self, Expr),
    ) {
        if first + 1 == count {
            return body(self, Expr::name(first.to_string()));
        }
        if first >= count {
            return;
        }
        let mut counter = String::new();
        let body = self.scope(|lower| {
            counter = lower.counter_name(name);
            body(lower, Expr::name(&counter));
        });
        self.bytes += 4;
        let counter_name = Expr::name(&counter);
        self.emit(StmtKind::For {
            init: (
                Declarator { ty: "uint32_t".to_owned(), name: counter, dimensions: String::new() },
                Expr::name(format!("{first}U")),
            ),
            condition: Expr::binary("<", counter_name.clone(), end),
            step: Some(ForStep::Expr(Expr::Postfix(Box::new(counter_name), "++"))),
            body,
        });
    }

    /// Emits the copy of a whole value; `shared` is true if source and destination may be the same.
    pub(super) fn copy(&mut self, dest: Expr, from: Expr, ty: &Type, shared: bool) {
        if ty.is_word() || matches!(ty, Type::Struct(_)) {
            self.assign(dest, from);
            return;
        }
        if is_short(ty) {
            for index in 0..length(ty) {
                let to = self.part(dest.clone(), ty, index);
                let from = self.part(from.clone(), ty, index);
                self.assign(to, from);
            }
            return;
        }
        self.uses.system.insert("string.h");
        let (element, dimensions) = self.context.names.type_parts(ty);
        let size = Expr::call("sizeof", vec![Expr::name(format!("{element}{dimensions}"))]);
        let function = if shared { "memmove" } else { "memcpy" };
        let call = Expr::call(function, vec![dest, from, size]);
        self.emit(StmtKind::Expr(Expr::cast("void", call)));
    }

    /// Returns true if C can initialise a variable with a value.
    pub(super) fn initialisable(&self, value: &Ir) -> bool {
        match &value.kind {
            ExprKind::Call(callee, _) => {
                value.ty.is_word() && !self.context.faults.fallible(*callee)
            }
            _ if value.ty.is_word() => true,
            ExprKind::Load(_) | ExprKind::Const(_) => {
                matches!(value.ty, Type::Struct(_)) || is_short(&value.ty)
            }
            ExprKind::Struct(items) | ExprKind::Array(items) | ExprKind::Matrix(items) => {
                items.iter().all(|item| self.initialisable(item))
            }
            ExprKind::Splat(item) => {
                self.is_zero(value)
                    || length(&value.ty) <= LISTED
                        && matches!(item.kind, ExprKind::Literal(_) | ExprKind::Const(_))
                        && item.ty.is_word()
            }
            ExprKind::Routine(routine, operands) => self.is_straight(*routine, operands, &value.ty),
            _ => false,
        }
    }

    /// Returns the initialiser of a value.
    pub(super) fn initialiser(&mut self, value: &Ir) -> Init {
        if value.ty.is_word() {
            return Init::Value(self.given(value));
        }
        match (&value.kind, &value.ty) {
            (ExprKind::Struct(items), Type::Struct(id)) => {
                let fields = &self.context.names.structs[id.index()].fields;
                let parts = items.iter().zip(fields).enumerate();
                let parts = parts.filter(|(index, _)| {
                    self.is_held(*id, *index, items) && !self.is_nothing(*id, *index, items)
                });
                let parts: Vec<_> = parts.map(|(_, (item, name))| (item, name.clone())).collect();
                let parts =
                    parts.into_iter().map(|(item, name)| (Some(name), self.initialiser(item)));
                Init::List { items: parts.collect(), lines: Lines::Fill }
            }
            (ExprKind::Splat(item), Type::Matrix { rows, cols, .. })
                if !self.context.names.layout.is_flat((*rows, *cols)) =>
            {
                let item = self.initialiser(item);
                let (rows, cols) = if self.is_zero(value) { (1, 1) } else { (*rows, *cols) };
                let row = (0..cols).map(|_| (None, item.clone())).collect();
                let row = Init::List { items: row, lines: Lines::Fill };
                let items = (0..rows).map(|_| (None, row.clone())).collect();
                Init::List { items, lines: Lines::Fill }
            }
            (ExprKind::Splat(item), ty) => {
                let count = length(ty);
                // C's own word for zeros everywhere.
                if self.is_zero(value) && count > SHOWN && is_number(&item.ty) {
                    let items = vec![(None, Init::Value(Expr::name("0")))];
                    return Init::List { items, lines: Lines::Fill };
                }
                let count = if self.is_zero(value) && count > SHOWN { 1 } else { count };
                let items = (0..count).map(|_| (None, self.initialiser(item)));
                Init::List { items: items.collect(), lines: Lines::Fill }
            }
            (ExprKind::Array(items) | ExprKind::Matrix(items), ty) => {
                let lines = match ty {
                    Type::Matrix { rows, cols, .. } if *rows > 1 && *cols > 1 => {
                        Lines::Groups(*rows as usize)
                    }
                    _ => Lines::Fill,
                };
                let items: Vec<_> = items.iter().map(|item| self.initialiser(item)).collect();
                self.list(&items, ty, lines)
            }
            (ExprKind::Routine(routine, operands), ty) => {
                let (elements, lines) = self.straight(*routine, operands, ty, None);
                let items: Vec<_> = elements.into_iter().map(Init::Value).collect();
                self.list(&items, ty, lines)
            }
            (_, ty) if is_short(ty) => {
                let from = self.operand(value);
                let parts = (0..length(ty)).map(|index| self.part(from.clone(), ty, index));
                let items: Vec<_> = parts.map(Init::Value).collect();
                self.list(&items, ty, Lines::Each)
            }
            _ => Init::Value(self.operand(value)),
        }
    }

    /// Returns an element of an array, or of a matrix by columns.
    fn part(&self, whole: Expr, ty: &Type, index: u32) -> Expr {
        let layout = self.context.names.layout;
        match ty {
            Type::Matrix { rows, cols, .. } if !layout.has_columns((*rows, *cols)) => {
                layout.by_columns(whole, (*rows, *cols), index)
            }
            _ => whole.at(Expr::name(index.to_string())),
        }
    }

    /// Returns the initialiser list of an array, or of a matrix by columns.
    fn list(&self, parts: &[Init], ty: &Type, lines: Lines) -> Init {
        let shape = match ty {
            Type::Matrix { rows, cols, .. } => (*rows, *cols),
            _ => (parts.len() as u32, 1),
        };
        self.context.names.layout.list(parts, shape, lines)
    }

    /// Returns a value that may be used more than once: itself if simple, else a constant variable.
    pub(super) fn once(&mut self, name: &str, value: &Ir, place: Option<&Place>) -> Expr {
        let lowered = self.word(value);
        let disturbed = place.is_some_and(|place| reads_place(value, place));
        if is_simple(&lowered) && !disturbed {
            return lowered;
        }
        let name = self.fresh(name);
        self.declare(&value.ty, &name, Some(Init::Value(lowered)), true);
        Expr::name(name)
    }
}

/// Returns true if a value is copied word by word: it has few words in a row.
fn is_short(ty: &Type) -> bool {
    let flat = match ty {
        Type::Array { element, .. } => element.is_word(),
        Type::Matrix { .. } => true,
        _ => false,
    };
    flat && length(ty) <= LINES
}

/// Returns true if a matrix is mostly zeros, so that a loop and some assignments are shorter than a line for each
/// element. Its elements are literals, since others might be read after the loop.
fn is_sparse(items: &[Ir]) -> bool {
    let numbers = items.iter().all(|item| matches!(item.kind, ExprKind::Literal(_)));
    let zeros = items.iter().filter(|item| item.kind == ExprKind::Literal(0)).count();
    items.len() > LINES as usize && numbers && 2 * zeros > items.len()
}

/// Returns true for types whose zero is C's `0`.
fn is_number(ty: &Type) -> bool {
    ty.as_int().is_some() || ty.as_float().is_some()
}

/// Returns true if an index in a place reads one of the places `written`.
pub(super) fn indexed_by(place: &Place, written: &[&Place]) -> bool {
    place.steps.iter().any(|step| match step {
        Step::Field(_) => false,
        Step::Index(index) | Step::From(index) => {
            written.iter().any(|place| reads_place(index, place))
        }
        Step::Element(row, column) => {
            written.iter().any(|place| reads_place(row, place) || reads_place(column, place))
        }
    })
}
