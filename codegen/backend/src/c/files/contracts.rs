//! Contracts in ACSL, the language of Frama-C: conditions on the callers of a function, and the memory that it changes.
//!
//! A contract follows from the head alone: pointers are valid, written memory is separate from the memory of other arguments,
//! and nothing else changes. Ranges of parameters and enumerators come from the model. A loop lists the variables that it changes
//! and, if it counts up by one, the bounds of its counter. Invariant: a contract is a comment, so the code is equal without it.

use std::collections::{BTreeMap, BTreeSet};

use bessemer_ir::attributes::Beyond;
use bessemer_ir::{EnumId, Function, FunctionId, Type};

use super::draft::Draft;
use crate::c::context::Context;
use crate::c::disjoint::{Pair, is_pointer};
use crate::c::signature::{Returned, Signature};
use crate::c::tree::{Declarator, Expr, Head, Init, Item, Step, Stmt, StmtKind, Storage, plain};

/// Writes contracts into the drafts. A function has it at its first declaration; `unproved` has the pairs of parameters
/// that may share memory.
pub(super) fn write(context: Context<'_>, drafts: &mut [Draft], unproved: &BTreeSet<Pair>) {
    let functions = context.names.functions.iter().enumerate();
    let known: BTreeMap<&str, FunctionId> =
        functions.map(|(index, it)| (it.name.as_str(), FunctionId(index as u32))).collect();
    let items = drafts.iter().flat_map(|draft| &draft.items);
    let heads = items.filter_map(|item| match item {
        Item::Function { head, .. } => Some((head.name.clone(), head.clone())),
        _ => None,
    });
    let heads: BTreeMap<String, Head> = heads.collect();
    for draft in drafts {
        let mut declared = BTreeSet::new();
        for item in &mut draft.items {
            let (head, body) = match item {
                Item::Prototype { head, .. } => (head, None),
                Item::Function { head, body, .. } => (head, Some(body)),
                _ => continue,
            };
            // The declaration of an external function is in its header.
            let is_defined = body.is_some() && head.storage == Storage::Extern;
            if !is_defined && declared.insert(head.name.clone()) {
                head.contract = of_head(head, unproved);
                if let Some(id) = known.get(head.name.as_str()) {
                    let function = &context.module.functions[id.index()];
                    let more = of_values(context, function, context.names.signature(*id));
                    head.contract.splice(0..0, more.0);
                    head.contract.extend(more.1);
                }
            }
            if let Some(body) = body {
                let mut loops = Loops { heads: &heads, declared: declarators(head, body) };
                loops.block(body);
            }
        }
    }
}

/// Returns the clauses that follow from the types of the parameters.
fn of_head(head: &Head, unproved: &BTreeSet<Pair>) -> Vec<String> {
    let pointers: Vec<usize> =
        (0..head.params.len()).filter(|at| is_pointer(&head.params[*at])).collect();
    let is_written = |at: &usize| !head.params[*at].ty.starts_with("const ");
    let (written, read): (Vec<usize>, Vec<usize>) =
        pointers.iter().copied().partition(|at| is_written(at));
    let list = |places: &[usize], text: fn(&Declarator) -> String| {
        places.iter().map(|at| text(&head.params[*at])).collect::<Vec<_>>().join(", ")
    };
    let mut lines = Vec::new();
    let valid =
        |word: &str, at: &usize| format!("requires \\{word}({});", pointer(&head.params[*at]));
    lines.extend(written.iter().map(|at| valid("valid", at)));
    lines.extend(read.iter().map(|at| valid("valid_read", at)));
    let shares = |one: usize, other: usize| {
        unproved.contains(&(head.name.clone(), one, other))
            || unproved.contains(&(head.name.clone(), other, one))
    };
    for (at, one) in written.iter().enumerate() {
        let others = written[at + 1..].iter().chain(&read).copied();
        let others: Vec<usize> = others.filter(|other| !shares(*one, *other)).collect();
        for other in others {
            let pair = list(&[*one, other], pointer);
            lines.push(format!("requires \\separated({pair});"));
        }
    }
    lines.push(match written.is_empty() {
        true => "assigns \\nothing;".to_owned(),
        false => format!("assigns {};", list(&written, place)),
    });
    lines
}

/// Returns the clauses before and after those of the head: ranges and enumerators of parameters, and of the result.
fn of_values(
    context: Context<'_>,
    function: &Function,
    signature: &Signature,
) -> (Vec<String>, Vec<String>) {
    let mut before = Vec::new();
    for (local, param) in function.parameters().iter().zip(&signature.params) {
        let mut parameters = function.attributes.parameters.iter();
        let own = parameters.find(|(name, _)| *name == local.name);
        let range = own.and_then(|(_, own)| own.range);
        match (&local.ty, range) {
            (Type::Enum(id), _) if local.ty == param.ty => {
                let condition = enumerators(context, *id, &param.name);
                before.extend(condition.map(|it| format!("requires {it};")));
            }
            (ty, Some(range)) if ty.is_word() && range.beyond() == Beyond::Taken => {
                let finite = match ty.as_float() {
                    Some(_) => format!("\\is_finite({}) && ", param.name),
                    None => String::new(),
                };
                let (low, high) = (range.low(), range.high());
                before.push(format!("requires {finite}{low:?} <= {} <= {high:?};", param.name));
            }
            _ => {}
        }
    }
    let after = match &signature.returned {
        Returned::Value(Type::Enum(id)) => enumerators(context, *id, "\\result"),
        _ => None,
    };
    (before, after.map(|it| format!("ensures {it};")).into_iter().collect())
}

/// Returns the condition that a value is an enumerator; none for an enum without any.
fn enumerators(context: Context<'_>, id: EnumId, value: &str) -> Option<String> {
    let names = &context.names.enums[id.index()].variants;
    let numbers: Vec<i32> =
        context.module.enums[id.index()].variants.iter().map(|it| it.value).collect();
    let follows = numbers.windows(2).all(|pair| pair[1] == pair[0].wrapping_add(1));
    match (&names[..], follows) {
        ([], _) => None,
        ([only], _) => Some(format!("{value} == {only}")),
        ([first, .., last], true) => Some(format!("{first} <= {value} <= {last}")),
        (all, false) => {
            let one = all.iter().map(|name| format!("{value} == {name}"));
            Some(one.collect::<Vec<_>>().join(" || "))
        }
    }
}

/// Returns the lengths of an array, `["3", "4"]`; the length of a slice is a parameter.
fn lengths(declarator: &Declarator) -> Vec<String> {
    let inner = declarator.dimensions.split_terminator(']').map(|it| it.trim_start_matches('['));
    let length = |it: &str| match it {
        "" => format!("{}_length", declarator.name),
        length => length.to_owned(),
    };
    inner.map(length).collect()
}

/// Returns the pointers to all elements of a parameter.
fn pointer(param: &Declarator) -> String {
    match lengths(param).first() {
        Some(length) => format!("{} + (0 .. {length} - 1)", param.name),
        None => param.name.clone(),
    }
}

/// Returns all elements of a variable, or the target of a pointer.
fn place(declarator: &Declarator) -> String {
    let all: String = lengths(declarator).iter().map(|it| format!("[0 .. {it} - 1]")).collect();
    match declarator.ty.trim_end().ends_with(['*']) || declarator.ty.ends_with("*const") {
        true if all.is_empty() => format!("*{}", declarator.name),
        _ => format!("{}{all}", declarator.name),
    }
}

/// Returns the parameters and all variables of a function, by name.
fn declarators(head: &Head, body: &[Stmt]) -> BTreeMap<String, Declarator> {
    fn add(found: &mut BTreeMap<String, Declarator>, body: &[Stmt]) {
        for stmt in body {
            match &stmt.kind {
                StmtKind::Declare(it, _) | StmtKind::For { init: (it, _), .. } => {
                    found.insert(it.name.clone(), it.clone());
                }
                _ => {}
            }
            stmt.kind.blocks().into_iter().for_each(|block| add(found, block));
        }
    }
    let mut found: BTreeMap<String, Declarator> =
        head.params.iter().map(|it| (it.name.clone(), it.clone())).collect();
    add(&mut found, body);
    found
}

/// The loops of a function.
struct Loops<'h> {
    heads: &'h BTreeMap<String, Head>,
    declared: BTreeMap<String, Declarator>,
}

impl Loops<'_> {
    /// Writes the annotation before each loop of a block.
    fn block(&mut self, block: &mut Vec<Stmt>) {
        let mut at = 0;
        while at < block.len() {
            block[at].kind.blocks_mut().into_iter().for_each(|inner| self.block(inner));
            if let Some(lines) = self.annotation(&block[at].kind) {
                block.insert(at, plain(StmtKind::Annotation(lines)));
                at += 1;
            }
            at += 1;
        }
    }

    fn annotation(&self, kind: &StmtKind) -> Option<Vec<String>> {
        let mut changed = Changed { loops: self, roots: BTreeMap::new(), own: BTreeSet::new() };
        let mut lines = Vec::new();
        match kind {
            StmtKind::For { init: (counter, first), condition, step, body } => {
                changed.root(&counter.name, counter.name.clone());
                changed.expr(condition);
                match step {
                    Some(Step::Expr(value)) => changed.expr(value),
                    Some(Step::Assign(to, value)) => {
                        changed.place(to);
                        changed.expr(value);
                    }
                    None => {}
                }
                changed.block(body);
                let counts = matches!(step, Some(Step::Expr(Expr::Postfix(it, "++")))
                    if **it == Expr::name(&counter.name));
                let mut within = BTreeSet::new();
                assigned(body, &mut within);
                let counts = counts && !within.contains(&counter.name);
                if let Expr::Binary("<", left, to) = condition
                    && **left == Expr::name(&counter.name)
                    && counts
                    && let (Some(from), Some(to)) = (constant(first), self.fixed(to, &within))
                {
                    let counter = &counter.name;
                    lines.push(format!("loop invariant {from} <= {counter};"));
                    // A loop without a pass begins beyond its end.
                    let or = format!(" || {counter} == {from}");
                    let or = if is_zero(&from) { "" } else { &or };
                    lines.push(format!("loop invariant {counter} <= {to}{or};"));
                    lines.push(format!("loop variant {to} - {counter};"));
                }
            }
            StmtKind::While { condition, body } => {
                changed.expr(condition);
                changed.block(body);
            }
            _ => return None,
        }
        let Changed { roots, own, .. } = changed;
        let places: BTreeSet<String> =
            roots.into_iter().filter(|(root, _)| !own.contains(root)).flat_map(|it| it.1).collect();
        let places: Vec<String> = places.into_iter().collect();
        let assigns = match places.is_empty() {
            true => "loop assigns \\nothing;".to_owned(),
            false => format!("loop assigns {};", places.join(", ")),
        };
        // Frama-C requires this clause before the variant.
        let at = lines.len().saturating_sub(1);
        lines.insert(at, assigns);
        Some(lines)
    }

    /// Returns the end of a loop as text if its value stays.
    fn fixed(&self, end: &Expr, within: &BTreeSet<String>) -> Option<String> {
        if let Some(text) = constant(end) {
            return Some(text);
        }
        match end {
            Expr::Name(name) if !within.contains(name) => Some(name.clone()),
            _ => None,
        }
    }
}

/// Returns a number, or the name of a constant.
fn constant(expr: &Expr) -> Option<String> {
    let text = match expr {
        Expr::Name(text) => text.clone(),
        Expr::Call(name, arguments) if name.ends_with("_C") => match &arguments[..] {
            [Expr::Name(number)] => format!("{name}({number})"),
            _ => return None,
        },
        _ => return None,
    };
    let is_constant = text.chars().all(|it| !it.is_lowercase());
    is_constant.then_some(text)
}

/// Returns true for a zero of an unsigned type: no end lies below it.
fn is_zero(text: &str) -> bool {
    text == "0U" || text == "UINT64_C(0)"
}

/// Adds the names of the variables that a block assigns.
fn assigned(body: &[Stmt], names: &mut BTreeSet<String>) {
    for stmt in body {
        if let StmtKind::Assign(place, ..) | StmtKind::Build(place, ..) = &stmt.kind {
            names.extend(root(place).map(str::to_owned));
        }
        for expr in stmt.kind.expressions() {
            stepped(expr, names);
        }
        stmt.kind.blocks().into_iter().for_each(|block| assigned(block, names));
    }
}

/// Adds the names of the variables that an expression steps, or whose address it takes.
fn stepped(expr: &Expr, names: &mut BTreeSet<String>) {
    if let Expr::Postfix(place, _) | Expr::Unary("&", place) = expr {
        names.extend(root(place).map(str::to_owned));
    }
    expr.operands().into_iter().for_each(|it| stepped(it, names));
}

/// Returns the variable of a place.
fn root(place: &Expr) -> Option<&str> {
    match place {
        Expr::Name(name) => Some(name),
        Expr::Unary("*" | "&", of)
        | Expr::Cast(_, of)
        | Expr::Member(of, _)
        | Expr::Arrow(of, _)
        | Expr::Index(of, _)
        | Expr::Binary("+", of, _) => root(of),
        _ => None,
    }
}

/// Changes of a loop.
struct Changed<'l, 'h> {
    loops: &'l Loops<'h>,
    /// Places by their variable.
    roots: BTreeMap<String, BTreeSet<String>>,
    /// Variables that are declared within.
    own: BTreeSet<String>,
}

impl Changed<'_, '_> {
    fn root(&mut self, name: &str, place: String) {
        self.roots.entry(name.to_owned()).or_default().insert(place);
    }

    fn block(&mut self, body: &[Stmt]) {
        for stmt in body {
            match &stmt.kind {
                StmtKind::Declare(it, _) | StmtKind::For { init: (it, _), .. } => {
                    self.own.insert(it.name.clone());
                }
                StmtKind::Assign(place, ..) | StmtKind::Build(place, ..) => self.place(place),
                _ => {}
            }
            if let StmtKind::Declare(_, Some(init @ Init::List { .. })) = &stmt.kind {
                init.expressions().into_iter().for_each(|it| self.expr(it));
            }
            stmt.kind.expressions().into_iter().for_each(|it| self.expr(it));
            stmt.kind.blocks().into_iter().for_each(|block| self.block(block));
        }
    }

    /// Adds a place that is assigned: an array as a whole, a field without its neighbours.
    fn place(&mut self, place: &Expr) {
        let Some(name) = root(place).map(str::to_owned) else { return };
        let whole = match self.loops.declared.get(&name) {
            Some(declarator) => self::place(declarator),
            None => name.clone(),
        };
        self.root(&name, path(place).unwrap_or(whole));
    }

    /// Adds the changes by the calls of an expression, and the variables that it steps.
    fn expr(&mut self, expr: &Expr) {
        match expr {
            Expr::Postfix(place, _) => self.place(place),
            Expr::Call(callee, arguments) => {
                let head = self.loops.heads.get(callee);
                for (at, argument) in arguments.iter().enumerate() {
                    let is_written = match head.and_then(|it| it.params.get(at)) {
                        Some(param) => is_pointer(param) && !param.ty.starts_with("const "),
                        None => at == 0 && matches!(&**callee, "memcpy" | "memset" | "memmove"),
                    };
                    if is_written && let Some(name) = root(argument).map(str::to_owned) {
                        let path = match argument {
                            Expr::Unary("&", place) => path(place),
                            _ => None,
                        };
                        let whole = self.loops.declared.get(&name).map(self::place);
                        self.root(&name, path.or(whole).unwrap_or_else(|| name.clone()));
                    }
                }
            }
            _ => {}
        }
        expr.operands().into_iter().for_each(|it| self.expr(it));
    }
}

/// Returns a place made of fields and elements of fields, all elements of an array; none for a whole variable.
fn path(place: &Expr) -> Option<String> {
    match place {
        Expr::Arrow(of, field) => match &**of {
            Expr::Name(name) => Some(format!("{name}->{field}")),
            _ => None,
        },
        Expr::Member(of, field) => match &**of {
            Expr::Name(name) => Some(format!("{name}.{field}")),
            of => Some(format!("{}.{field}", path(of)?)),
        },
        Expr::Index(of, _) => Some(format!("{}[..]", path(of)?)),
        _ => None,
    }
}
