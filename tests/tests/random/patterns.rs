//! Random patterns, and the names that they bind.

use super::types::{Parts, Ty, path, width};
use super::writer::{Kind, Var, Writer};

impl Writer<'_> {
    /// A pattern of the type, whose names hold what `mode` says; they are in scope from here on.
    pub fn pattern(&mut self, ty: &Ty, mode: &Kind, refutable: bool, depth: usize) -> String {
        let from = self.env.len();
        self.part_of_pattern(ty, mode, refutable, depth, from)
    }

    pub fn part_of_pattern(
        &mut self,
        ty: &Ty,
        mode: &Kind,
        refutable: bool,
        depth: usize,
        from: usize,
    ) -> String {
        if depth == 0 || self.one_in(6) {
            return self.bound(ty, mode, from);
        }
        match ty {
            Ty::Int(name) if refutable && !self.one_in(4) => {
                let pattern = self.numbers(name);
                self.at(pattern, ty, mode, from)
            }
            Ty::Bool if refutable && self.one_in(2) => {
                // An arm that takes both leaves nothing to test; it was tested once.
                self.random.of(&["true", "false", "(true | false)", "(false | true)"]).into()
            }
            Ty::Tuple(types) => {
                let parts = Parts { names: Vec::new(), types: types.clone() };
                let texts = self.several(&parts.types, mode, refutable, depth, from);
                parts.filled(&texts)
            }
            Ty::Array(element, len) => {
                let types = vec![(**element).clone(); *len];
                let before = self.env.len();
                let texts = self.several(&types, mode, refutable, depth, from);
                if *len > 1 && self.one_in(4) {
                    // Names that `..` takes the place of stay out of scope.
                    self.env.truncate(before);
                    let first = self.bound(element, mode, from);
                    return self.random.of(&["[NAME, ..]", "[.., NAME]"]).replace("NAME", &first);
                }
                format!("[{}]", texts.join(", "))
            }
            Ty::Struct(index) => {
                let types = self.items.structs[*index].1.types.clone();
                let texts = self.several(&types, mode, refutable, depth, from);
                let (name, parts) = &self.items.structs[*index];
                let name = path(name);
                format!("{name}{}", parts.filled(&texts))
            }
            Ty::Enum(index) if refutable => self.variant(*index, mode, depth, from),
            Ty::Option(inner) if refutable => {
                if self.one_in(4) {
                    return "None".to_owned();
                }
                format!("Some({})", self.part_of_pattern(inner, mode, true, depth - 1, from))
            }
            Ty::Result(ok, err) if refutable => {
                let (name, inner) = if self.one_in(2) { ("Ok", ok) } else { ("Err", err) };
                format!("{name}({})", self.part_of_pattern(inner, mode, true, depth - 1, from))
            }
            _ => self.bound(ty, mode, from),
        }
    }

    fn several(
        &mut self,
        types: &[Ty],
        mode: &Kind,
        refutable: bool,
        depth: usize,
        from: usize,
    ) -> Vec<String> {
        types.iter().map(|ty| self.part_of_pattern(ty, mode, refutable, depth - 1, from)).collect()
    }

    fn variant(&mut self, index: usize, mode: &Kind, depth: usize, from: usize) -> String {
        let count = self.items.enums[index].1.len();
        let at = self.below(count);
        let types = self.items.enums[index].1[at].1.types.clone();
        let texts = self.several(&types, mode, true, depth, from);
        let (name, variants) = &self.items.enums[index];
        let name = path(name);
        let one = format!("{name}::{}{}", variants[at].0, variants[at].1.filled(&texts));
        let plain: Vec<_> =
            variants.iter().filter(|it| it.1.types.is_empty()).map(|it| it.0.clone()).collect();
        if types.is_empty() && self.one_in(3) {
            let other = &plain[self.below(plain.len())];
            return format!("({one} | {name}::{other})");
        }
        one
    }

    /// Values of an integer: one, a range, or any of several.
    fn numbers(&mut self, name: &str) -> String {
        let (_, signed) = width(name);
        let low = self.below(8) as i64 - if signed { 4 } else { 0 };
        let high = low + self.below(6) as i64;
        match self.below(6) {
            0 | 1 => format!("{low}"),
            2 => format!("{low}..={high}"),
            3 => format!("({low}..)"),
            4 if !signed => format!("(..={high})"),
            4 => format!("(..{low})"),
            _ => format!("({low} | {}..={})", high + 1, high + 3),
        }
    }

    /// `name @ pattern`, or the pattern.
    fn at(&mut self, pattern: String, ty: &Ty, mode: &Kind, from: usize) -> String {
        if !self.one_in(3) {
            return pattern;
        }
        let name = self.bound(ty, mode, from);
        if name == "_" { pattern } else { format!("{name} @ {pattern}") }
    }

    /// A name that the pattern has not yet, or `_`.
    pub fn bound(&mut self, ty: &Ty, mode: &Kind, from: usize) -> String {
        let name = self.new_name();
        if self.one_in(6) || self.env[from..].iter().any(|var| var.name == name) {
            return "_".to_owned();
        }
        let mutable = *mode == Kind::Owned && self.one_in(3);
        self.env.push(Var::new(name, ty, mode.clone(), mutable));
        if mutable { format!("mut {name}") } else { name.to_owned() }
    }
}
