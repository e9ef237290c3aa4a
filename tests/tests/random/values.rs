//! Random expressions of a type that is wanted.

use super::types::{Ty, path, width};
use super::writer::{Kind, Left, Writer};

impl Writer<'_> {
    /// An expression of the type, at most `fuel` deep. It stands anywhere: what needs parentheses has them.
    pub fn value(&mut self, ty: &Ty, fuel: usize) -> String {
        if fuel == 0 {
            return self.simple(ty);
        }
        match self.below(20) {
            0..=3 => self.simple(ty),
            4 => self.choice(ty, fuel),
            5 => self.matched(ty, fuel),
            6 if self.one_in(3) => self.labelled(ty, fuel),
            6 => self.block(ty, fuel),
            7 | 8 => self.called(ty, fuel).unwrap_or_else(|| self.simple(ty)),
            9 if ty.is_scalar() => {
                let value = self.value(ty, fuel - 1);
                self.ticked(ty, value).unwrap_or_else(|| self.simple(ty))
            }
            10 => self.unwrapped(ty, fuel),
            11 | 12 => self.chain(ty, fuel).unwrap_or_else(|| self.simple(ty)),
            _ => self.own(ty, fuel),
        }
    }

    /// A literal, or what a place holds.
    pub fn simple(&mut self, ty: &Ty) -> String {
        if !self.one_in(3)
            && let Some(place) = self.place(false, &|it| it == ty)
        {
            return place.text;
        }
        if ty.is_number()
            && self.one_in(2)
            && let Some(place) = self.place(false, &|it| it.is_number())
        {
            return format!("({} as {})", place.text, self.items.name(ty));
        }
        self.literal(ty)
    }

    pub fn literal(&mut self, ty: &Ty) -> String {
        match ty {
            Ty::Int(name) => {
                let (_, signed) = width(name);
                match self.below(12) {
                    0 => format!("{name}::MAX"),
                    1 => format!("{name}::MIN"),
                    2 if signed => format!("(-{}_{name})", 1 + self.below(20)),
                    _ => format!("{}_{name}", self.below(10)),
                }
            }
            Ty::Float(name) => match self.below(12) {
                0 => format!("{name}::NAN"),
                1 => format!("{name}::INFINITY"),
                2 => format!("(-0.0_{name})"),
                3 => format!("{name}::MAX"),
                _ => {
                    format!("{}.{}_{name}", self.below(20), self.random.of(&["0", "5", "25", "1"]))
                }
            },
            Ty::Bool => self.random.of(&["true", "false"]).to_owned(),
            Ty::Option(_) if self.one_in(3) => format!("None::<{}>", self.inner_name(ty)),
            _ => self.made(ty, 0),
        }
    }

    fn inner_name(&self, ty: &Ty) -> String {
        match ty {
            Ty::Option(inner) => self.items.name(inner),
            other => self.items.name(other),
        }
    }

    /// Returns an expression specific to the type.
    fn own(&mut self, ty: &Ty, fuel: usize) -> String {
        let from = self.items.from.iter().find(|it| *ty == Ty::Enum(it.0)).copied();
        if let Some((_, int)) = from
            && self.one_in(3)
        {
            let code = self.value(&Ty::Int(int), fuel - 1);
            return format!("{}::from({code})", self.items.name(ty));
        }
        match ty {
            Ty::Int(name) => self.integer(name, fuel),
            Ty::Float(name) => self.float(name, fuel),
            Ty::Bool => self.logical(fuel),
            Ty::Option(inner) => self.optional(inner, fuel),
            Ty::Result(ok, err) => self.fallible(ok, err, fuel),
            Ty::Text(len) => self.text(*len, fuel),
            Ty::Bounded(element, rows, cols) => self.bounded((element, *rows, *cols), fuel),
            Ty::Array(element, len) if **element == Ty::Int("u8") && self.one_in(3) => {
                self.bytes(*len, fuel).unwrap_or_else(|| self.made(ty, fuel))
            }
            Ty::Matrix(element, rows, cols) => self.matrix((element, *rows, *cols), fuel),
            _ => self.made(ty, fuel),
        }
    }

    /// An aggregate of its parts.
    fn made(&mut self, ty: &Ty, fuel: usize) -> String {
        let less = fuel.saturating_sub(1);
        match ty {
            Ty::Array(element, len) => match self.below(6) {
                0 => {
                    let value = self.value(element, less);
                    format!("[{value}; {len}]")
                }
                1 if fuel > 0 => self.mapped(element, *len, less),
                2 if fuel > 0 => self.filled_by_index(element, *len, less),
                _ => {
                    let all: Vec<_> = (0..*len).map(|_| self.value(element, less)).collect();
                    format!("[{}]", all.join(", "))
                }
            },
            Ty::Tuple(parts) => {
                let all: Vec<_> = parts.iter().map(|part| self.value(part, less)).collect();
                format!("({})", all.join(", "))
            }
            Ty::Struct(index) => self.structure(*index, fuel),
            Ty::Enum(index) => {
                let count = self.items.enums[*index].1.len();
                let variant = self.below(count);
                let types = self.items.enums[*index].1[variant].1.types.clone();
                let texts: Vec<_> = types.iter().map(|ty| self.value(ty, less)).collect();
                let (name, variants) = &self.items.enums[*index];
                let name = path(name);
                format!("({name}::{}{})", variants[variant].0, variants[variant].1.filled(&texts))
            }
            Ty::Option(inner) => {
                let value = self.value(inner, less);
                format!("Some({value})")
            }
            Ty::Result(ok, err) => {
                let (which, inner) = if self.one_in(3) { ("Err", err) } else { ("Ok", ok) };
                let value = self.value(inner, less);
                format!("{which}::<{}, {}>({value})", self.items.name(ok), self.items.name(err))
            }
            Ty::List(element, len) => {
                let mut text = format!("{{ let mut made: {} = List::new(); ", self.items.name(ty));
                for _ in 0..self.below(len + 1) {
                    text += &format!("made.push({}); ", self.value(element, less));
                }
                text + "made }"
            }
            Ty::Matrix(element, rows, cols) => self.matrix((element, *rows, *cols), 0),
            Ty::Text(len) => self.text(*len, 0),
            Ty::Bounded(element, rows, cols) => self.bounded((element, *rows, *cols), 0),
            scalar => self.literal(scalar),
        }
    }

    fn structure(&mut self, index: usize, fuel: usize) -> String {
        let less = fuel.saturating_sub(1);
        let ty = Ty::Struct(index);
        if self.one_in(8) {
            return format!("{}::default()", path(&self.items.name(&ty)));
        }
        let types = self.items.structs[index].1.types.clone();
        let named = !self.items.structs[index].1.names.is_empty();
        if named && self.one_in(4) {
            let at = self.below(types.len());
            let value = self.value(&types[at], less);
            let base = self.value(&ty, less);
            let (name, parts) = &self.items.structs[index];
            let name = path(name);
            return format!("({name} {{ {}: {value}, ..{base} }})", parts.names[at]);
        }
        // Fields may be written in another order than they were declared in.
        let texts: Vec<_> = types.iter().map(|ty| self.value(ty, less)).collect();
        let (name, parts) = &self.items.structs[index];
        let name = path(name);
        format!("({name}{})", parts.filled(&texts))
    }

    /// A condition.
    pub fn logical(&mut self, fuel: usize) -> String {
        let less = fuel.saturating_sub(1);
        match self.below(15) {
            11 => self.tested_option(less),
            12 | 13 => self.of_sequence(&Ty::Bool, less).unwrap_or_else(|| self.literal(&Ty::Bool)),
            14 => self.of_text(&Ty::Bool, less).unwrap_or_else(|| self.literal(&Ty::Bool)),
            0..=3 => {
                let ty = self.items.any(self.random, 0, true);
                let ty = if ty.is_number() { ty } else { Ty::Int("i32") };
                let operator = self.random.of(&["<", "<=", ">", ">=", "==", "!="]);
                let (one, other) = (self.value(&ty, less), self.value(&ty, less));
                format!("({one} {operator} {other})")
            }
            4 | 5 => {
                let operator = self.random.of(&["&&", "||", "&", "|", "^"]);
                let (one, other) = (self.value(&Ty::Bool, less), self.value(&Ty::Bool, less));
                format!("({one} {operator} {other})")
            }
            6 => {
                let value = self.value(&Ty::Bool, less);
                format!("(!{value})")
            }
            7 | 8 => {
                let Some(place) = self.place(false, &|ty| !ty.is_scalar()) else {
                    return self.literal(&Ty::Bool);
                };
                self.lend(place.root, false);
                let operator = self.random.of(&["==", "!="]);
                let other = self.value(&place.ty, less);
                self.end(place.root, false);
                format!("({} {operator} {other})", place.text)
            }
            9 => {
                let Some(place) = self.place(false, &|_| true) else {
                    return self.literal(&Ty::Bool);
                };
                let before = self.env.len();
                let pattern = self.pattern(&place.ty.clone(), &Kind::Owned, true, 2);
                let guard = if self.one_in(2) {
                    self.lend(place.root, false);
                    let guard = self.logical(less);
                    self.end(place.root, false);
                    format!(" if {guard}")
                } else {
                    String::new()
                };
                self.env.truncate(before);
                format!("matches!({}, {pattern}{guard})", place.text)
            }
            _ => {
                let Some(place) = self.place(false, &|ty| matches!(ty, Ty::Option(_))) else {
                    return self.literal(&Ty::Bool);
                };
                let method = self.random.of(&["is_some", "is_none"]);
                format!("{}.{method}()", place.text)
            }
        }
    }

    /// `if … { … } else { … }`, with parentheses.
    fn choice(&mut self, ty: &Ty, fuel: usize) -> String {
        let before = self.env.len();
        let (condition, loans) = self.condition(fuel - 1);
        let then = self.inner_block(ty, fuel - 1);
        self.env.truncate(before);
        loans.into_iter().for_each(|(var, write)| self.end(var, write));
        let otherwise = self.inner_block(ty, fuel - 1);
        format!("(if {condition} {{ {then} }} else {{ {otherwise} }})")
    }

    /// A condition, also a chain of `let`: the names are in scope, and what is lent is until it is ended.
    pub fn condition(&mut self, fuel: usize) -> (String, Vec<(usize, bool)>) {
        let mut parts = Vec::new();
        let mut loans = Vec::new();
        for _ in 0..1 + self.below(2) {
            if self.one_in(3) {
                let (scrutinee, ty, mode, loan) = self.scrutinee(fuel);
                let pattern = self.pattern(&ty, &mode, true, 2);
                loans.extend(loan);
                parts.push(format!("let {pattern} = {scrutinee}"));
            } else {
                parts.push(self.logical(fuel));
            }
        }
        (parts.join(" && "), loans)
    }

    /// Returns a matched value: its text, its type, the binding mode of names, and the variable that is borrowed.
    pub fn scrutinee(&mut self, fuel: usize) -> (String, Ty, Kind, Option<(usize, bool)>) {
        let compound = |ty: &Ty| !matches!(ty, Ty::Float(_) | Ty::List(..));
        match self.below(8) {
            0 => {
                let ty = self.items.any(self.random, 2, true);
                let ty = if matches!(ty, Ty::Tuple(_)) { Ty::Int("i32") } else { ty };
                (format!("({})", self.value(&ty, fuel)), ty, Kind::Owned, None)
            }
            1 if self.one_in(6) => {
                let types: Vec<_> = (0..2).map(|_| self.items.any(self.random, 1, true)).collect();
                let values: Vec<_> = types.iter().map(|ty| self.value(ty, fuel)).collect();
                (format!("({})", values.join(", ")), Ty::Tuple(types), Kind::Owned, None)
            }
            2 | 3 => match self.place(true, &compound) {
                Some(place) => {
                    self.lend(place.root, true);
                    (
                        format!("&mut {}", place.text),
                        place.ty,
                        Kind::Exclusive,
                        Some((place.root, true)),
                    )
                }
                None => ("3_u8".to_owned(), Ty::Int("u8"), Kind::Owned, None),
            },
            4 => match self.place(false, &compound) {
                Some(place) => {
                    self.lend(place.root, false);
                    (format!("&{}", place.text), place.ty, Kind::Shared, Some((place.root, false)))
                }
                None => ("4_i8".to_owned(), Ty::Int("i8"), Kind::Owned, None),
            },
            _ => match self.place(false, &compound) {
                Some(place) => (place.text, place.ty, Kind::Owned, None),
                None => ("5_u16".to_owned(), Ty::Int("u16"), Kind::Owned, None),
            },
        }
    }

    /// `match … { … }`, with parentheses.
    fn matched(&mut self, ty: &Ty, fuel: usize) -> String {
        let arms = self.arms(fuel - 1, &mut |it| it.inner_block(ty, fuel - 1));
        format!("({arms})")
    }

    /// A `match` whose arms are written by `body`.
    pub fn arms(&mut self, fuel: usize, body: &mut dyn FnMut(&mut Self) -> String) -> String {
        let (scrutinee, ty, mode, loan) = self.scrutinee(fuel);
        let mut text = format!("match {scrutinee} {{\n");
        let before = self.env.len();
        let count = 1 + self.below(3);
        for arm in 0..=count {
            let pattern = self.pattern(&ty, &mode, arm < count, 2);
            let guard = if arm < count && self.one_in(3) {
                // A guard reads what is matched, and changes nothing of it.
                let frozen: Vec<usize> = (0..self.env.len()).collect();
                frozen.iter().for_each(|var| self.lend(*var, false));
                let guard = self.logical(fuel);
                frozen.iter().for_each(|var| self.end(*var, false));
                format!(" if {guard}")
            } else {
                String::new()
            };
            text += &format!("{pattern}{guard} => {{ {} }}\n", body(self));
            self.env.truncate(before);
        }
        if let Some((var, write)) = loan {
            self.end(var, write);
        }
        text + "}"
    }

    /// Statements and a value, without braces.
    pub fn inner_block(&mut self, ty: &Ty, fuel: usize) -> String {
        let before = self.env.len();
        let statement = if self.one_in(3) { self.statement(fuel.min(1)) } else { String::new() };
        let value = self.value(ty, fuel);
        self.close(before);
        statement + &value
    }

    fn block(&mut self, ty: &Ty, fuel: usize) -> String {
        let before = self.env.len();
        let statement = self.statement(fuel - 1);
        let value = self.value(ty, fuel - 1);
        self.close(before);
        format!("({{ {statement}{value} }})")
    }

    /// A block with a label, which may be left before its end.
    fn labelled(&mut self, ty: &Ty, fuel: usize) -> String {
        let before = self.env.len();
        let label = self.label();
        self.loops.push(Left { label: label.clone(), value: Some(ty.clone()), block: true });
        let mut body = self.statement(fuel - 1);
        if self.one_in(2) {
            let (condition, value) = (self.logical(fuel - 1), self.value(ty, fuel - 1));
            body += &format!("if {condition} {{ break {label} {value}; }}\n");
        }
        self.loops.pop();
        let value = self.value(ty, fuel - 1);
        self.close(before);
        format!("({label}: {{\n{body}{value} }})")
    }

    /// The scope ends: what was bound behind `before` is gone.
    pub fn close(&mut self, before: usize) {
        self.env.truncate(before);
    }
}
