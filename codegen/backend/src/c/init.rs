//! Functions that set a component to its initial state, and plain data of entry points to its default.

use std::collections::BTreeSet;

use bessemer_ir::{ConstId, Module, Scalar, StructId, Type};

use super::context::{Context, Uses};
use super::literal::Readers;
use super::spelling::unique;
use super::tree::{
    Declarator, Expr, Head, Init, Item, Lines, Origin, Step, Stmt, StmtKind, Storage, plain,
};
use super::{described, literal, sizes};

/// Largest number of equal elements that are set one per line, without a loop.
const LINES: usize = 4;
/// Largest number of different words that are set one per line; more are copied from a table.
const WORDS: usize = 16;

/// Returns the head of the function that sets a component to its initial state, or plain data to its default.
pub fn head(context: Context<'_>, id: StructId) -> Head {
    let names = &context.names.structs[id.index()];
    let this = Declarator {
        ty: format!("{} *", names.ty),
        name: "self".to_owned(),
        dimensions: String::new(),
    };
    Head {
        contract: Vec::new(),
        asked: Vec::new(),
        storage: Storage::Extern,
        result: "void".to_owned(),
        name: names.init.clone().expect("what has no function is not asked for it"),
        params: vec![this],
    }
}

/// Returns the doc comment of that function.
pub fn docs(context: Context<'_>, id: StructId) -> Vec<String> {
    let component = context.module.structs[id.index()].initial.is_some();
    let said = match component {
        true => "Sets the initial state; call it before anything else.",
        false => "Sets each field to its default.",
    };
    vec![said.to_owned()]
}

/// Returns the definition of that function.
pub fn item(context: Context<'_>, id: StructId, uses: &mut Uses) -> Item {
    let component = &context.module.structs[id.index()];
    let words = component.initial.as_ref().or(component.defaults.as_ref());
    let words = words.expect("what has a function has words");
    let this = Expr::unary("*", Expr::name("self"));
    let mut writer = Writer { context, uses, body: Vec::new(), depth: 0, tables: BTreeSet::new() };
    writer.fields(&this, id, words);
    Item::Function {
        docs: Vec::new(),
        head: head(context, id),
        body: writer.body,
        origin: Origin { file: component.span.file, line: component.span.line },
        function: format!("{}::{}", component.module, component.name),
    }
}

struct Writer<'a> {
    context: Context<'a>,
    uses: &'a mut Uses,
    body: Vec<Stmt>,
    /// Number of surrounding loops.
    depth: usize,
    tables: BTreeSet<String>,
}

impl Writer<'_> {
    fn fields(&mut self, place: &Expr, id: StructId, words: &[u64]) {
        let module = self.context.module;
        let names = &self.context.names.structs[id.index()];
        let item = &module.structs[id.index()];
        let mut rest = words;
        // Where it begins as it does on its own.
        let default = [&item.initial, &item.defaults].iter().any(|it| it.as_deref() == Some(words));
        for (index, (field, name)) in item.fields.iter().zip(&names.fields).enumerate() {
            let (own, later) = rest.split_at(count(module, &field.ty));
            rest = later;
            if item.overlaid() && !item.holds(index, words[0]) {
                continue;
            }
            if let Some(expression) = field.given.expression.as_ref().filter(|_| default) {
                let told = vec![described::in_rust(expression)];
                self.body.push(plain(StmtKind::Comment(told)));
            }
            let sizes = sizes::sizes(module, &field.given);
            self.value(place.clone().field(name), &field.ty, &sizes, own);
        }
        if let Some(fault) = &names.fault {
            self.set(place.clone().field(fault), Expr::name(&self.context.names.status.ok));
        }
    }

    fn set(&mut self, place: Expr, value: Expr) {
        self.body.push(plain(StmtKind::Assign(place, "=", value)));
    }

    /// Returns a word as a C constant.
    fn word(&mut self, ty: &Type, word: u64) -> Expr {
        match self.context.text(ty, word) {
            Some((id, name)) => {
                self.uses.consts.insert(id);
                Expr::name(name)
            }
            None => literal::word(self.context.names, ty, word, Readers::C),
        }
    }

    /// Sets a place to a value; `sizes` are the constants that name its lengths.
    fn value(&mut self, place: Expr, ty: &Type, sizes: &[Option<ConstId>], words: &[u64]) {
        match ty {
            Type::Unit | Type::Slice(_) => {}
            Type::Scalar(_) | Type::Enum(_) => {
                self.uses.system.extend(literal::needs_math(ty, words[0]).then_some("math.h"));
                let value = self.word(ty, words[0]);
                self.set(place, value);
            }
            Type::Struct(id) => self.structure(place, *id, words),
            Type::Array { element, len } => self.array(place, element, *len, sizes, words),
            Type::Matrix { element, rows, cols } => {
                let (layout, shape) = (self.context.names.layout, (*rows, *cols));
                if *rows > 1 && *cols > 1 && is_sparse(words) {
                    self.sparse(place, *element, shape, words);
                    return;
                }
                let words = layout.in_memory(words, shape);
                // Of a column, the rows are the elements.
                let sizes = if *cols == 1 { sizes } else { &[] };
                self.value(place, &layout.array(*element, shape), sizes, &words);
            }
        }
    }

    /// Sets a matrix to zeros, and then the elements that are none.
    fn sparse(&mut self, place: Expr, element: Scalar, shape: (u32, u32), words: &[u64]) {
        let layout = self.context.names.layout;
        let zeros = vec![0; words.len()];
        self.value(place.clone(), &layout.array(element, shape), &[], &zeros);
        for (index, word) in (0..).zip(words).filter(|(_, word)| **word != 0) {
            let place = layout.by_columns(place.clone(), shape, index);
            self.value(place, &Type::Scalar(element), &[], std::slice::from_ref(word));
        }
    }

    /// Sets a nested component by its own function, if its value is its initial state.
    fn structure(&mut self, place: Expr, id: StructId, words: &[u64]) {
        let item = &self.context.module.structs[id.index()];
        let names = &self.context.names.structs[id.index()];
        match &names.init {
            Some(init) if item.initial.as_deref() == Some(words) => {
                self.uses.headers.insert(names.header.clone());
                let call = Expr::call(init, vec![place.address()]);
                self.body.push(plain(StmtKind::Expr(call)));
            }
            _ => self.fields(&place, id, words),
        }
    }

    fn array(
        &mut self,
        place: Expr,
        element: &Type,
        count: u32,
        sizes: &[Option<ConstId>],
        words: &[u64],
    ) {
        let len = count as usize;
        let size = words.len() / len.max(1);
        let (own, inner) = sizes.split_first().unwrap_or((&None, &[]));
        let parts: Vec<&[u64]> = words.chunks(size.max(1)).collect();
        let equal = parts.windows(2).all(|pair| pair[0] == pair[1]);
        if equal && (len > LINES || len > 1 && size > LINES) {
            let counter = &counter(self.depth);
            let outer = std::mem::take(&mut self.body);
            self.depth += 1;
            self.value(place.at(Expr::name(counter)), element, inner, parts[0]);
            self.depth -= 1;
            let body = std::mem::replace(&mut self.body, outer);
            let named = own.and_then(|id| self.context.names.shared_constant(id));
            self.uses.consts.extend(own.filter(|_| named.is_some()));
            let count = named.map_or_else(|| format!("{count}U"), str::to_owned);
            self.body.push(plain(count_up(counter, count, body)));
        } else if element.is_word() && len > WORDS {
            self.table(place, element, words);
        } else {
            for (index, part) in parts.iter().enumerate() {
                let place = place.clone().at(Expr::name(index.to_string()));
                self.value(place, element, inner, part);
            }
        }
    }

    fn table(&mut self, place: Expr, element: &Type, words: &[u64]) {
        let field = match &place {
            Expr::Arrow(_, field) | Expr::Member(_, field) => field.clone(),
            _ => "values".to_owned(),
        };
        let tables = &self.tables;
        let name = unique(&format!("initial_{field}"), |name| tables.contains(name));
        self.tables.insert(name.clone());
        let items = words.iter().map(|word| (None, Init::Value(self.word(element, *word))));
        let init = Init::List { items: items.collect(), lines: Lines::Fill };
        let declarator = Declarator {
            ty: format!("static const {}", self.context.names.word(element)),
            name: name.clone(),
            dimensions: format!("[{}]", words.len()),
        };
        self.body.push(plain(StmtKind::Declare(declarator, Some(init))));
        let size = Expr::call("sizeof", vec![Expr::name(&name)]);
        let copy = Expr::call("memcpy", vec![place, Expr::name(name), size]);
        self.body.push(plain(StmtKind::Expr(Expr::cast("void", copy))));
        self.uses.system.insert("string.h");
        let math = words.iter().any(|word| literal::needs_math(element, *word));
        self.uses.system.extend(math.then_some("math.h"));
    }
}

/// Returns true if a matrix is mostly zeros, so that a loop and some assignments are shorter than its elements.
fn is_sparse(words: &[u64]) -> bool {
    let zeros = words.iter().filter(|word| **word == 0).count();
    words.len() > LINES
        && words.len() > zeros
        && words.len() - zeros <= WORDS
        && 2 * zeros > words.len()
}

/// Returns the counter name for a loop inside `depth` others.
fn counter(depth: usize) -> String {
    match ["i", "j", "k", "l", "m", "n"].get(depth) {
        Some(letter) => (*letter).to_owned(),
        None => format!("i{}", depth + 1),
    }
}

fn count_up(counter: &str, count: String, body: Vec<Stmt>) -> StmtKind {
    let name = Expr::name(counter);
    StmtKind::For {
        init: (
            Declarator {
                ty: "uint32_t".to_owned(),
                name: counter.to_owned(),
                dimensions: String::new(),
            },
            Expr::name("0U"),
        ),
        condition: Expr::binary("<", name.clone(), Expr::name(count)),
        step: Some(Step::Expr(Expr::Postfix(Box::new(name), "++"))),
        body,
    }
}

fn count(module: &Module, ty: &Type) -> usize {
    module.width(ty)
}
