//! Random options and results, and what is asked of them.

use super::types::Ty;
use super::writer::{Kind, Var, Writer};

impl Writer<'_> {
    pub fn optional(&mut self, inner: &Ty, fuel: usize) -> String {
        let less = fuel - 1;
        let ty = Ty::Option(Box::new(inner.clone()));
        match (self.below(16), inner) {
            (0 | 1, Ty::Int(name)) => self.checked(name, less),
            (2, _) => self.taken(inner, less),
            (3, _) => {
                let found = self.place(false, &|it| match it {
                    Ty::List(element, _) | Ty::Array(element, _) => **element == *inner,
                    _ => false,
                });
                let Some(place) = found else { return self.simple(&ty) };
                self.lend(place.root, false);
                let index = self.value(&Ty::Int("usize"), less);
                self.end(place.root, false);
                let get = self.random.of(&["get", "first", "last"]);
                let index = if get == "get" { index } else { String::new() };
                format!("{}.{get}({index}).copied()", place.text)
            }
            (4 | 5, _) => {
                let other = self.items.any(self.random, 1, true);
                let from = self.value(&Ty::Option(Box::new(other.clone())), less);
                if self.one_in(2) {
                    let (closure, _) = self.lambda(&other, inner, less);
                    return format!("{from}.map({closure})");
                }
                let (closure, _) = self.lambda(&other, &ty, less);
                format!("{from}.and_then({closure})")
            }
            (6, _) => {
                let value = self.value(&ty, less);
                let test = self.predicate(inner, less);
                format!("{value}.filter({test})")
            }
            (7, _) => {
                let condition = self.logical(less);
                let value = self.unreturned(|it| it.value(inner, less));
                format!("{condition}.then(|| {value})")
            }
            (8, _) => {
                let (one, other) = (self.value(&ty, less), self.value(&ty, less));
                format!("{one}.{}({other})", self.random.of(&["or", "xor", "and"]))
            }
            (9, _) => {
                let one = self.value(&ty, less);
                let other = self.unreturned(|it| it.value(&ty, less));
                format!("{one}.or_else(|| {other})")
            }
            (10, _) => {
                let nested = self.value(&Ty::Option(Box::new(ty)), less);
                format!("{nested}.flatten()")
            }
            (11, Ty::Tuple(types)) if types.len() == 2 => {
                let mut option = |ty: &Ty| self.value(&Ty::Option(Box::new(ty.clone())), less);
                let (one, other) = (option(&types[0]), option(&types[1]));
                format!("{one}.zip({other})")
            }
            (12, _) => {
                let error = self.items.any(self.random, 0, true);
                let (inner, error) = (Box::new(inner.clone()), Box::new(error));
                if self.one_in(3) {
                    return format!("{}.err()", self.value(&Ty::Result(error, inner), less));
                }
                format!("{}.ok()", self.value(&Ty::Result(inner, error), less))
            }
            (13, _) => self.of_sequence(&ty, less).unwrap_or_else(|| self.simple(&ty)),
            _ => {
                let value = self.value(inner, less);
                format!("Some({value})")
            }
        }
    }

    fn checked(&mut self, name: &'static str, fuel: usize) -> String {
        let inner = Ty::Int(name);
        let one = self.value(&inner, fuel);
        match self.below(4) {
            0 => {
                let operator = self.random.of(&["shl", "shr", "pow"]);
                format!("{one}.checked_{operator}({})", self.value(&Ty::Int("u32"), fuel))
            }
            1 => format!("{one}.checked_neg()"),
            _ => {
                let operator = self.random.of(&["add", "sub", "mul", "div", "rem"]);
                format!("{one}.checked_{operator}({})", self.value(&inner, fuel))
            }
        }
    }

    /// Returns an expression that takes the content of a place.
    fn taken(&mut self, inner: &Ty, fuel: usize) -> String {
        let ty = Ty::Option(Box::new(inner.clone()));
        let found = self.place(true, &|it| match it {
            Ty::List(element, _) => **element == *inner,
            Ty::Text(_) => *inner == Ty::Int("u8"),
            other => *other == ty,
        });
        match found {
            Some(place) if place.ty == ty && self.one_in(2) => {
                self.lend(place.root, false);
                let value = self.value(inner, fuel);
                self.end(place.root, false);
                format!("{}.replace({value})", place.text)
            }
            Some(place) if place.ty == ty => format!("{}.take()", place.text),
            Some(place) => format!("{}.pop()", place.text),
            None => self.simple(&ty),
        }
    }

    pub fn fallible(&mut self, ok: &Ty, err: &Ty, fuel: usize) -> String {
        let less = fuel - 1;
        let ty = Ty::Result(Box::new(ok.clone()), Box::new(err.clone()));
        match self.below(8) {
            0 | 1 => {
                let option = self.value(&Ty::Option(Box::new(ok.clone())), less);
                if self.one_in(2) {
                    return format!("{option}.ok_or({})", self.value(err, less));
                }
                let error = self.unreturned(|it| it.value(err, less));
                format!("{option}.ok_or_else(|| {error})")
            }
            2 => {
                let other = self.items.any(self.random, 1, true);
                let from = Ty::Result(Box::new(other.clone()), Box::new(err.clone()));
                let from = self.value(&from, less);
                if self.one_in(2) {
                    let (closure, _) = self.lambda(&other, ok, less);
                    return format!("{from}.map({closure})");
                }
                let (closure, _) = self.lambda(&other, &ty, less);
                format!("{from}.and_then({closure})")
            }
            3 => {
                let other = self.items.any(self.random, 0, true);
                let from = Ty::Result(Box::new(ok.clone()), Box::new(other.clone()));
                let from = self.value(&from, less);
                if self.one_in(2) {
                    let (closure, _) = self.lambda(&other, err, less);
                    return format!("{from}.map_err({closure})");
                }
                let (closure, _) = self.lambda(&other, &ty, less);
                format!("{from}.or_else({closure})")
            }
            4 if *ok == Ty::Int("usize") && *err == *ok => {
                self.searched(less).unwrap_or_else(|| self.simple(&ty))
            }
            _ => self.literal(&ty),
        }
    }

    /// A question about an option or a result.
    pub fn tested_option(&mut self, fuel: usize) -> String {
        let inner = self.items.any(self.random, 1, true);
        let (test, _) = self.tracked(|it| {
            it.unreturned(|it| {
                let before = it.env.len();
                let pattern = it.pattern(&inner, &Kind::Owned, false, 1);
                let value = it.logical(fuel);
                it.close(before);
                format!("|{pattern}| {value}")
            })
        });
        if self.one_in(2) {
            let option = self.value(&Ty::Option(Box::new(inner)), fuel);
            return match self.below(4) {
                0 => format!("{option}.is_some()"),
                1 => format!("{option}.is_none()"),
                2 => format!("{option}.is_none_or({test})"),
                _ => format!("{option}.is_some_and({test})"),
            };
        }
        let error = Box::new(self.items.any(self.random, 0, true));
        let result = self.value(&Ty::Result(Box::new(inner), error), fuel);
        match self.below(3) {
            0 => format!("{result}.is_ok()"),
            1 => format!("{result}.is_err()"),
            _ => format!("{result}.is_ok_and({test})"),
        }
    }

    /// A statement that changes what is in an option.
    pub fn filled(&mut self, fuel: usize) -> Option<String> {
        let place = self.place(true, &|ty| matches!(ty, Ty::Option(_)))?;
        let Ty::Option(inner) = &place.ty else { return None };
        self.lend(place.root, true);
        let value = self.value(inner, fuel);
        let text = &place.text;
        let written = match self.below(4) {
            0 => format!("{text}.insert({value});"),
            1 => format!("*{text}.get_or_insert({value}) = {};", self.value(inner, fuel)),
            2 => {
                let value = self.unreturned(|it| it.value(inner, fuel));
                format!("*{text}.get_or_insert_with(|| {value}) = {};", self.value(inner, fuel))
            }
            _ => {
                let before = self.env.len();
                let name = self.new_name();
                self.env.push(Var::new(name, inner, Kind::Exclusive, false));
                let body = self.statement(fuel.min(1));
                self.close(before);
                format!("if let Some({name}) = {text}.as_mut() {{\n{body}}}")
            }
        };
        self.end(place.root, true);
        Some(written)
    }
}
