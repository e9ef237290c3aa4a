//! Writes random programs: what is in scope, who borrows it, and the functions around the bodies.
//!
//! Programs are right by construction: a variable that is lent is frozen (read only) or hidden until the
//! loan ends, so that rustc takes what comes out. What it refuses all the same is counted.

use std::fmt::Write as _;

use bessemer_tests::random::Random;

use super::types::{Items, Ty, is_instance};

/// Kind of a variable.
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
    /// Numbers of borrows that forbid writing, and of those that forbid reading too.
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

/// A program: its declarations, and what is called with words: a function, or the entry points of a component.
pub struct Program {
    pub name: String,
    pub text: String,
    /// The component.
    pub unit: Option<String>,
    pub entries: Vec<Entry>,
    /// If it aims at the proofs: how many instances its text has, of which the first argument chooses one.
    pub instances: Option<usize>,
}

impl Program {
    /// Returns the number of programs that it represents.
    pub fn count(&self) -> usize {
        self.instances.unwrap_or(1)
    }
}

pub struct Entry {
    pub name: String,
    /// The types of the parameters as Rust writes them, and `&` or `&mut` or nothing; without `self`.
    pub params: Vec<(&'static str, String)>,
    /// True if it rolls back where it faults.
    pub atomic: bool,
    /// True if a fault of it stops its component.
    pub stops: bool,
}

impl Entry {
    /// Returns the entry with each name mapped by the function.
    pub fn renamed(&self, renamed: &impl Fn(&str) -> String) -> Entry {
        let params = self.params.iter().map(|(passing, ty)| (*passing, renamed(ty))).collect();
        Entry { name: renamed(&self.name), params, ..*self }
    }
}

/// Role of a function in its program.
#[derive(Clone, Copy, PartialEq)]
enum Role {
    /// Called by others.
    Helper,
    /// The one that is called with words.
    Whole,
    /// A component's own method.
    Own(usize),
    /// An entry point of a component, and whether it rolls back.
    Entry(usize, bool),
}

pub struct Writer<'r> {
    pub random: &'r mut Random,
    pub items: Items,
    pub env: Vec<Var>,
    pub callees: Vec<Callee>,
    /// Variables that the text being written reads (false) or writes (true).
    pub trackers: Vec<Vec<(usize, bool)>>,
    /// The result of the function that is being written; none in a closure.
    pub result: Option<Ty>,
    /// The loops and the blocks with labels around.
    pub loops: Vec<Left>,
    /// Number of operations of which one may fault.
    pub risk: usize,
    pub labels: usize,
    /// True if an index is being written: one within it is a number.
    indexing: bool,
}

/// Exits that are possible.
#[derive(Clone)]
pub struct Left {
    pub label: String,
    /// The type of its value.
    pub value: Option<Ty>,
    /// A block rather than a loop.
    pub block: bool,
}

pub const NAMES: [&str; 18] = [
    "a", "b", "c", "x", "y", "n", "sum", "index", "limit", "at", "value", "part", "next", "state",
    "length", "item", "result", "next_a",
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
    if writer.one_in(2) {
        text += &writer.generic_types(name);
    }
    text += &writer.conversions();
    if writer.one_in(3) {
        text += &writer.generic(&format!("{name}_generic"));
    }
    if writer.one_in(2) {
        text += &writer.generic_functions(name);
    }
    if writer.one_in(2) {
        text += &writer.interface(name);
    }
    for index in 0..writer.below(3) {
        let function = writer.function(&format!("{name}_{index}"), Role::Helper, 3);
        text += &function;
    }
    if writer.one_in(3) {
        return writer.component(name, text);
    }
    let count = 4 + writer.below(5);
    text += &writer.function(name, Role::Whole, count);
    let entries = vec![writer.entry(false)];
    Program { name: name.to_owned(), text, unit: None, entries, instances: None }
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

    /// Returns true if something may fault here.
    pub fn risky(&mut self) -> bool {
        let risk = self.risk;
        self.random.one_in(risk)
    }

    pub fn new_name(&mut self) -> &'static str {
        self.random.of(&NAMES)
    }

    /// A program whose entry points are those of a component, behind what is there of it; it may hold another.
    fn component(&mut self, name: &str, mut text: String) -> Program {
        let mut entries = Vec::new();
        for index in 0..1 + self.below(2) {
            let of = self.items.unit(self.random, format!("{}Unit{index}", name.to_uppercase()));
            text += &self.items.unit_text(of);
            let mut methods = String::new();
            if self.one_in(2) {
                methods += &self.function(&format!("{name}_own{index}"), Role::Own(of), 2);
            }
            entries.clear();
            for entry in 0..1 + self.below(3) {
                let atomic = self.one_in(3);
                let name = format!("{name}_entry{index}{entry}");
                methods += &self.function(&name, Role::Entry(of, atomic), 3);
                entries.push(self.entry(atomic));
            }
            let unit = self.items.name(&Ty::Unit(of));
            let _ = writeln!(text, "#[component]\nimpl {unit} {{\n{methods}}}");
        }
        let unit = self.items.units.last().map(|unit| unit.0.clone());
        Program { name: name.to_owned(), text, unit, entries, instances: None }
    }

    /// Returns conversions from integers to some of the enums.
    fn conversions(&mut self) -> String {
        let mut text = String::new();
        for index in 0..self.items.enums.len() {
            if is_instance(&self.items.enums[index].0) || !self.one_in(2) {
                continue;
            }
            let int = self.random.of(&["u8", "i16", "u64"]);
            self.env = vec![Var::new("code", &Ty::Int(int), Kind::Owned, false)];
            let value = self.value(&Ty::Enum(index), 2);
            self.items.from.push((index, int));
            let name = self.items.name(&Ty::Enum(index));
            let body = format!("fn from(code: {int}) -> {name} {{ {value} }}");
            let _ = writeln!(text, "#[data]\nimpl From<{int}> for {name} {{ {body} }}");
        }
        text
    }

    /// The function that was written last, as what is called with words.
    fn entry(&self, atomic: bool) -> Entry {
        let Some(callee) = self.callees.last() else {
            return Entry { name: String::new(), params: Vec::new(), atomic, stops: false };
        };
        let changes = callee.method && callee.params[0].1 == Kind::Exclusive;
        let params = callee.params[usize::from(callee.method)..].iter();
        let params = params.map(|(ty, kind)| (passing(kind), self.items.name(ty))).collect();
        Entry { name: callee.name.clone(), params, atomic, stops: changes && !atomic }
    }

    fn function(&mut self, name: &str, role: Role, statements: usize) -> String {
        let public = matches!(role, Role::Whole | Role::Entry(..));
        let mut params = Vec::new();
        self.env.clear();
        let receiver = match role {
            Role::Own(unit) | Role::Entry(unit, _) => Some(Ty::Unit(unit)),
            Role::Helper if self.one_in(3) => self.implemented(),
            Role::Helper | Role::Whole => None,
        };
        if let Some(ty) = &receiver {
            let kind = self.random.of(&[&Kind::Shared, &Kind::Exclusive, &Kind::Exclusive]).clone();
            self.env.push(Var::new("self", ty, kind.clone(), false));
            params.push((ty.clone(), kind));
        }
        self.parameters(&mut params, public);
        let result = self.items.returned(self.random);
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
        let (list, result_name) = (list.join(", "), self.items.name(&result));
        let signature = format!("fn {name}({list}) -> {result_name} {{\n{body}}}\n");
        let method = receiver.is_some();
        self.callees.push(Callee { name: name.to_owned(), params, result, method });
        match (role, receiver) {
            (Role::Entry(_, true), _) => format!("#[entry(atomic)]\npub {signature}"),
            (Role::Entry(_, false), _) => format!("#[entry]\npub {signature}"),
            (Role::Own(_), _) => signature,
            (Role::Helper, Some(of)) => {
                format!("#[data]\nimpl {} {{\npub {signature}}}\n", self.items.name(&of))
            }
            (Role::Helper, None) => format!("#[function]\n{signature}"),
            (Role::Whole, _) => format!("#[function]\npub {signature}"),
        }
    }

    /// A struct that may have methods here.
    pub fn implemented(&mut self) -> Option<Ty> {
        let all = self.items.structs.iter().enumerate();
        let own: Vec<_> = all.filter(|it| !is_instance(&it.1.0)).map(|it| it.0).collect();
        (!own.is_empty()).then(|| Ty::Struct(self.random.of(&own)))
    }

    /// Parameters of random types and names, and `t`.
    fn parameters(&mut self, params: &mut Vec<(Ty, Kind)>, public: bool) {
        let mut names: Vec<&str> = NAMES.to_vec();
        for _ in 0..1 + self.below(if public { 4 } else { 3 }) {
            let mut ty = self.items.any(self.random, 2, true);
            let kind = match self.below(5) {
                0..=2 => Kind::Owned,
                3 => Kind::Exclusive,
                _ => Kind::Shared,
            };
            // No entry point takes a slice.
            if let Some((element, _)) = ty.sequence()
                && !public
                && kind != Kind::Owned
            {
                ty = Ty::Slice(Box::new(element.clone()));
            }
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
    }

    /// Statements and the value, with what the variables came to told to `t`.
    pub fn whole(&mut self, statements: usize, result: &Ty) -> String {
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

    /// The value, after `t` was reported it.
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
        self.any_place(write, &|ty| ty.is_data() && wanted(ty))
    }

    /// Returns a place, possibly in a component.
    pub fn any_place(&mut self, write: bool, wanted: &dyn Fn(&Ty) -> bool) -> Option<Place> {
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
            Ty::Slice(element) => part(format!("{path}[#0#]"), element),
            // What is lent as a whole where an element is written says so by a `!`.
            Ty::Matrix(_, rows, 1) => part(format!("{path}[#!{rows}#]"), &ty.element()),
            Ty::Matrix(_, rows, cols) => {
                part(format!("{path}[(#!{rows}#, #{cols}#)]"), &ty.element());
            }
            Ty::Tuple(types) => {
                types.iter().enumerate().for_each(|(at, ty)| part(format!("{path}.{at}"), ty));
            }
            other => {
                let Some(parts) = self.items.fields_of(other) else { return };
                for (at, ty) in parts.types.iter().enumerate() {
                    let name = parts.names.get(at).cloned().unwrap_or_else(|| at.to_string());
                    part(format!("{path}.{name}"), ty);
                }
            }
        }
    }

    /// The path with an index for each `#length#`.
    fn indexed(&mut self, root: usize, path: &str, write: bool) -> String {
        if !path.contains('#') {
            return path.to_owned();
        }
        // A list that is written, told by its index, is lent as a whole.
        let whole = write && (path.contains("[0]") || path.contains("#!"));
        self.lend(root, whole);
        let mut text = String::new();
        for (at, piece) in path.split('#').enumerate() {
            if at % 2 == 0 {
                text += piece;
                continue;
            }
            let len: usize = piece.trim_start_matches('!').parse().unwrap_or_default();
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
