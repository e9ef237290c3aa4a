//! Writes random programs: what is in scope, who borrows it, and the functions around the bodies.
//!
//! Programs are right by construction: a variable that is lent is frozen (read only) or hidden until the
//! loan ends, so that rustc takes what comes out. What it refuses all the same is counted.

use std::fmt::Write as _;

use bessemer_tests::random::Random;

use super::types::{Items, Ty};

/// How a variable holds its value.
#[derive(Clone, Debug, PartialEq)]
pub enum Kind {
    Owned,
    Shared,
    Exclusive,
    /// A closure: its parameter's type, and whether calling it changes something. The variable's type is that of the result.
    Closure(Ty, bool),
}

#[derive(Clone, Debug)]
pub struct Var {
    pub name: String,
    pub ty: Ty,
    pub kind: Kind,
    pub mutable: bool,
    /// How many loans forbid writing, and how many reading too.
    pub frozen: u32,
    pub hidden: u32,
}

impl Var {
    pub fn new(name: &str, ty: &Ty, kind: Kind, mutable: bool) -> Var {
        Var { name: name.to_owned(), ty: ty.clone(), kind, mutable, frozen: 0, hidden: 0 }
    }
}

/// A place: its text, whose it is, and its type.
pub struct Place {
    pub text: String,
    pub root: usize,
    pub ty: Ty,
}

/// A function that was written, and can be called.
#[derive(Clone)]
pub struct Callee {
    pub name: String,
    pub params: Vec<(Ty, Kind)>,
    pub result: Ty,
    /// Its first parameter is `self`.
    pub method: bool,
}

/// A program: its declarations and functions, the last of which is called with words.
pub struct Program {
    pub name: String,
    pub text: String,
    /// The types of the parameters as Rust writes them, and `&` or `&mut` or nothing.
    pub params: Vec<(&'static str, String)>,
}

pub struct Writer<'r> {
    pub random: &'r mut Random,
    pub items: Items,
    pub env: Vec<Var>,
    pub callees: Vec<Callee>,
    /// Which variables the text that is being written reads (false) or writes (true).
    pub trackers: Vec<Vec<(usize, bool)>>,
    /// The result of the function that is being written; none in a closure.
    pub result: Option<Ty>,
    /// Labels of the loops around.
    pub loops: Vec<(String, Option<Ty>)>,
    /// How often one in so many operations may fault.
    pub risk: usize,
    pub labels: usize,
    /// Whether an index is being written: one within it is a number.
    indexing: bool,
}

pub const NAMES: [&str; 16] = [
    "a", "b", "c", "x", "y", "n", "sum", "index", "limit", "at", "value", "part", "next", "state",
    "length", "item",
];

/// A program, `pub fn name(…, t: &mut u64) -> …`.
pub fn program(random: &mut Random, name: &str) -> Program {
    let prefix = name.to_uppercase();
    let items = Items::new(random, &prefix);
    let risk = random.of(&[4, 12, 30, 60]);
    let mut writer = Writer {
        random,
        items,
        env: Vec::new(),
        callees: Vec::new(),
        trackers: Vec::new(),
        result: None,
        loops: Vec::new(),
        risk,
        labels: 0,
        indexing: false,
    };
    let mut text = writer.items.text();
    for index in 0..writer.below(3) {
        let function = writer.function(&format!("{name}_{index}"), false, 3);
        text += &function;
    }
    let count = 4 + writer.below(5);
    text += &writer.function(name, true, count);
    let callee = writer.callees.pop();
    let params = callee.map(|it| it.params).unwrap_or_default();
    let params = params.iter().map(|(ty, kind)| (passing(kind), writer.items.name(ty))).collect();
    Program { name: name.to_owned(), text, params }
}

fn passing(kind: &Kind) -> &'static str {
    match kind {
        Kind::Shared => "&",
        Kind::Exclusive => "&mut ",
        _ => "",
    }
}

impl Writer<'_> {
    pub fn below(&mut self, n: usize) -> usize {
        self.random.below(n)
    }

    pub fn one_in(&mut self, n: usize) -> bool {
        self.random.one_in(n)
    }

    /// Whether something may fault here.
    pub fn risky(&mut self) -> bool {
        let risk = self.risk;
        self.random.one_in(risk)
    }

    pub fn new_name(&mut self) -> &'static str {
        self.random.of(&NAMES)
    }

    fn function(&mut self, name: &str, public: bool, statements: usize) -> String {
        let method = !public && !self.items.structs.is_empty() && self.one_in(3);
        let mut params = Vec::new();
        self.env.clear();
        if method {
            let ty = Ty::Struct(self.below(self.items.structs.len()));
            let kind = self.random.of(&[&Kind::Shared, &Kind::Exclusive]).clone();
            self.env.push(Var::new("self", &ty, kind.clone(), false));
            params.push((ty, kind));
        }
        let mut names: Vec<&str> = NAMES.to_vec();
        for _ in 0..1 + self.below(if public { 4 } else { 3 }) {
            let ty = self.items.any(self.random, 2, true);
            let kind = match self.below(5) {
                0..=2 => Kind::Owned,
                3 => Kind::Exclusive,
                _ => Kind::Shared,
            };
            let at = self.below(names.len());
            let name = names.remove(at);
            let mutable = kind == Kind::Owned && self.one_in(2);
            self.env.push(Var::new(name, &ty, kind.clone(), mutable));
            params.push((ty, kind));
        }
        if public || self.one_in(2) {
            let ty = Ty::Int("u64");
            self.env.push(Var::new("t", &ty, Kind::Exclusive, false));
            params.push((ty, Kind::Exclusive));
        }
        let result = self.items.any(self.random, 2, public);
        self.result = Some(result.clone());
        let mut list = Vec::new();
        for (var, (ty, kind)) in self.env.iter().zip(&params) {
            list.push(match var.name.as_str() {
                "self" => format!("{}self", passing(kind)),
                name => {
                    let mutable = if var.mutable { "mut " } else { "" };
                    format!("{mutable}{name}: {}{}", passing(kind), self.items.name(ty))
                }
            });
        }
        let body = self.whole(statements, &result);
        let callee = Callee { name: name.to_owned(), params: params.clone(), result, method };
        let mut text = String::new();
        let signature = format!(
            "fn {name}({}) -> {} {{\n{body}}}",
            list.join(", "),
            self.items.name(&callee.result)
        );
        if method {
            let of = self.items.name(&params[0].0);
            let _ = writeln!(text, "#[data]\nimpl {of} {{\npub {signature}\n}}");
        } else {
            let visible = if public { "pub " } else { "" };
            let _ = writeln!(text, "#[function]\n{visible}{signature}");
        }
        self.callees.push(callee);
        text
    }

    /// Statements and the value, with what the variables came to told to `t`.
    fn whole(&mut self, statements: usize, result: &Ty) -> String {
        let mut text = String::new();
        for _ in 0..statements {
            text += &self.statement(2);
        }
        text += &self.told();
        let value = self.value(result, 2);
        text + &value + "\n"
    }

    /// Tells `t` of some of the variables.
    pub fn told(&mut self) -> String {
        let mut text = String::new();
        for _ in 0..2 {
            if let Some(place) = self.place(false, &|ty| ty.is_scalar())
                && let Some(told) = self.ticked(&place.ty, place.text)
            {
                text += &format!("{told};\n");
            }
        }
        text
    }

    /// The value, after `t` was told of it.
    pub fn ticked(&mut self, ty: &Ty, value: String) -> Option<String> {
        let t = self.env.iter().position(|var| var.name == "t")?;
        if !self.writable(t) || !ty.is_scalar() {
            return None;
        }
        self.mention(t, true);
        Some(format!("tick_{}({value}, t)", self.items.name(ty)))
    }

    // What is in scope.

    pub fn mention(&mut self, var: usize, write: bool) {
        for tracker in &mut self.trackers {
            tracker.push((var, write));
        }
    }

    fn readable(&self, index: usize) -> bool {
        let var = &self.env[index];
        var.hidden == 0 && !self.env[index + 1..].iter().any(|later| later.name == var.name)
    }

    pub fn writable(&self, index: usize) -> bool {
        let var = &self.env[index];
        let may = match var.kind {
            Kind::Owned => var.mutable,
            Kind::Exclusive => true,
            Kind::Shared | Kind::Closure(..) => false,
        };
        may && var.frozen == 0 && self.readable(index)
    }

    /// The closures that can be called here.
    pub fn closures(&self) -> Vec<usize> {
        let is = |index: &usize| match self.env[*index].kind {
            Kind::Closure(_, changes) => {
                self.readable(*index) && !(changes && self.env[*index].frozen > 0)
            }
            _ => false,
        };
        (0..self.env.len()).filter(is).collect()
    }

    /// Lends a variable until `end`.
    pub fn lend(&mut self, var: usize, write: bool) {
        if write {
            self.env[var].hidden += 1;
        } else {
            self.env[var].frozen += 1;
        }
    }

    pub fn end(&mut self, var: usize, write: bool) {
        if var < self.env.len() {
            let var = &mut self.env[var];
            *if write { &mut var.hidden } else { &mut var.frozen } -= 1;
        }
    }

    /// Writes something, and says what it mentions of what was there before.
    pub fn tracked<T>(&mut self, write: impl FnOnce(&mut Self) -> T) -> (T, Vec<(usize, bool)>) {
        let known = self.env.len();
        self.trackers.push(Vec::new());
        let value = write(self);
        let mut all = self.trackers.pop().unwrap_or_default();
        all.retain(|(var, _)| *var < known);
        all.sort_unstable();
        all.dedup();
        (value, all)
    }

    /// A place of a type that is wanted, to read or to write; its indices are written too.
    pub fn place(&mut self, write: bool, wanted: &dyn Fn(&Ty) -> bool) -> Option<Place> {
        let mut all = Vec::new();
        for index in 0..self.env.len() {
            let var = &self.env[index];
            let usable = if write { self.writable(index) } else { self.readable(index) };
            if !usable || matches!(var.kind, Kind::Closure(..)) || var.name == "t" {
                continue;
            }
            if wanted(&var.ty) {
                let text = if var.kind == Kind::Owned {
                    var.name.clone()
                } else {
                    format!("(*{})", var.name)
                };
                all.push((index, text, var.ty.clone()));
            }
            self.parts_of(index, &var.name, &var.ty, (3, write), wanted, &mut all);
        }
        if all.is_empty() {
            return None;
        }
        let at = self.below(all.len());
        let (root, path, ty) = all.swap_remove(at);
        let text = self.indexed(root, &path, write);
        self.mention(root, write);
        Some(Place { text, root, ty })
    }

    fn parts_of(
        &self,
        root: usize,
        path: &str,
        ty: &Ty,
        (depth, write): (usize, bool),
        wanted: &dyn Fn(&Ty) -> bool,
        all: &mut Vec<(usize, String, Ty)>,
    ) {
        let mut part = |path: String, ty: &Ty| {
            if wanted(ty) {
                all.push((root, path.clone(), ty.clone()));
            }
            if depth > 0 {
                self.parts_of(root, &path, ty, (depth - 1, write), wanted, all);
            }
        };
        match ty {
            Ty::Array(element, len) => part(format!("{path}[#{len}#]"), element),
            // A list is lent as a whole where one of its elements is written, so its length is not at hand.
            Ty::List(element, _) if write => part(format!("{path}[0]"), element),
            Ty::List(element, _) => part(format!("{path}[#0#]"), element),
            Ty::Tuple(types) => {
                types.iter().enumerate().for_each(|(at, ty)| part(format!("{path}.{at}"), ty));
            }
            Ty::Struct(index) => {
                let parts = &self.items.structs[*index].1;
                for (at, ty) in parts.types.iter().enumerate() {
                    let name = parts.names.get(at).cloned().unwrap_or_else(|| at.to_string());
                    part(format!("{path}.{name}"), ty);
                }
            }
            _ => {}
        }
    }

    /// The path with an index for each `#length#`.
    fn indexed(&mut self, root: usize, path: &str, write: bool) -> String {
        if !path.contains('#') {
            return path.to_owned();
        }
        // A list that is written, told by its index, is lent as a whole.
        let whole = write && path.contains("[0]");
        self.lend(root, whole);
        let mut text = String::new();
        for (at, piece) in path.split('#').enumerate() {
            if at % 2 == 0 {
                text += piece;
                continue;
            }
            let len: usize = piece.parse().unwrap_or_default();
            let before = text.trim_end_matches('[').to_owned();
            text += &self.index(len, &before);
        }
        self.end(root, whole);
        text
    }

    /// An index into `len` elements; of 0 as many as the list `before` says.
    fn index(&mut self, len: usize, before: &str) -> String {
        if self.indexing {
            return if len == 0 {
                format!("{before}.len() / 2")
            } else {
                self.below(len).to_string()
            };
        }
        self.indexing = true;
        let text = self.any_index(len, before);
        self.indexing = false;
        text
    }

    fn any_index(&mut self, len: usize, before: &str) -> String {
        let usize_ = Ty::Int("usize");
        if len == 0 {
            let value = self.value(&usize_, 1);
            return if self.risky() {
                self.below(3).to_string()
            } else {
                format!("({value} % {before}.len())")
            };
        }
        match self.below(6) {
            0 if self.risky() => self.value(&usize_, 1),
            1 | 2 => {
                let value = self.value(&usize_, 1);
                format!("({value} % {len})")
            }
            3 => {
                let value = self.value(&Ty::Int("u8"), 1);
                format!("({value} % {len}) as usize")
            }
            _ => self.below(len).to_string(),
        }
    }
}
