//! Random statements. Each ends with a line of its own.

use super::types::Ty;
use super::writer::{Kind, Left, Place, Var, Writer};

/// Loops within one another.
const NESTED: usize = 2;

impl Writer<'_> {
    pub fn statement(&mut self, fuel: usize) -> String {
        let compound = fuel > 0;
        let text = match self.below(if compound { 32 } else { 12 }) {
            0..=3 => self.declared(fuel),
            4..=6 => self.assigned(fuel),
            7 | 8 => self.changed(fuel),
            9 => self.called_alone(fuel),
            10 => self.edited_in_place(fuel).unwrap_or_else(|| self.list_edit(fuel)),
            11 => self.exchanged(),
            12 | 13 => self.branch(fuel),
            14 | 15 => self.match_statement(fuel),
            16..=18 if self.nested() < NESTED => self.each(fuel),
            19 | 20 if self.nested() < NESTED => self.range(fuel),
            21 if self.nested() < NESTED => self.counted(fuel),
            22 => self.left(fuel),
            23 => self.let_else(fuel),
            24 => self.closure(fuel),
            25 => self.reference(fuel),
            26 => self.scope(fuel),
            27 if self.nested() < NESTED => self.valued_loop(fuel),
            28 => self.returned(fuel),
            29 | 30 => self.edited_in_place(fuel).unwrap_or_else(|| self.list_edit(fuel)),
            _ => self.declared(fuel),
        };
        text + "\n"
    }

    /// Some statements, in a scope.
    fn statements(&mut self, fuel: usize) -> String {
        let before = self.env.len();
        let mut text = String::new();
        for _ in 0..1 + self.below(3) {
            text += &self.statement(fuel);
        }
        if self.one_in(2) {
            text += &self.told();
        }
        self.close(before);
        text
    }

    fn declared(&mut self, fuel: usize) -> String {
        let ty = self.items.any(self.random, 2, false);
        let value = self.value(&ty, fuel);
        if self.one_in(4) {
            let pattern = self.pattern(&ty, &Kind::Owned, false, 2);
            return format!("let {pattern}: {} = {value};", self.items.name(&ty));
        }
        let name = self.new_name();
        let mutable = self.one_in(2);
        self.env.push(Var::new(name, &ty, Kind::Owned, mutable));
        let mutable = if mutable { "mut " } else { "" };
        format!("let {mutable}{name}: {} = {value};", self.items.name(&ty))
    }

    fn assigned(&mut self, fuel: usize) -> String {
        let Some(place) = self.place(true, &|_| true) else { return self.declared(fuel) };
        // The right side comes first, and may change what the left side reads.
        let value = self.value(&place.ty, fuel);
        format!("{} = {value};", place.text)
    }

    fn changed(&mut self, fuel: usize) -> String {
        let Some(place) = self.place(true, &|ty| ty.is_scalar()) else {
            return self.declared(fuel);
        };
        let value = self.value(&place.ty, fuel);
        let operator = match &place.ty {
            Ty::Float(_) => self.random.of(&["+=", "-=", "*=", "/="]),
            Ty::Int(_) if self.risky() => self.random.of(&["+=", "-=", "*=", "/=", "%="]),
            Ty::Int(_) if self.one_in(3) => {
                return format!("{0} = {0}.wrapping_add({value});", place.text);
            }
            _ => self.random.of(&["^=", "|=", "&="]),
        };
        format!("{} {operator} {value};", place.text)
    }

    /// Returns the number of surrounding loops.
    fn nested(&self) -> usize {
        self.loops.iter().filter(|it| !it.block).count()
    }

    fn called_alone(&mut self, fuel: usize) -> String {
        if self.callees.is_empty() {
            return self.assigned(fuel);
        }
        let at = self.below(self.callees.len());
        let callee = self.callees[at].clone();
        match self.call(&callee, fuel) {
            Some(call) => format!("{call};"),
            None => self.assigned(fuel),
        }
    }

    /// A change of what is made of elements.
    fn edited_in_place(&mut self, fuel: usize) -> Option<String> {
        match self.below(8) {
            0 | 1 => self.matrix_edit(fuel),
            2..=4 => self.slice_edit(fuel),
            5 => self.filled(fuel),
            6 => self.text_edit(fuel),
            _ => self.bounded_edit(fuel),
        }
    }

    fn list_edit(&mut self, fuel: usize) -> String {
        let Some(place) = self.place(true, &|ty| matches!(ty, Ty::List(..))) else {
            return self.assigned(fuel);
        };
        let Ty::List(element, len) = &place.ty else { return String::new() };
        let list = &place.text;
        self.lend(place.root, false);
        let value = self.value(element, fuel);
        let at = self.below(*len);
        let text = match self.below(11) {
            7 => format!("{list}.retain({});", self.kept(element, fuel)),
            8 => format!("if {list}.len() > {at} {{ {list}.swap_remove({at}); }}"),
            9 if self.risky() => format!("{list}.extend_from_slice(&[{value}; {}]);", at + 1),
            9 => format!("if {list}.len() < {len} {{ {list}.extend([{value}]); }}"),
            0..=2 if self.risky() => format!("{list}.push({value});"),
            0 | 1 => format!("if {list}.len() < {len} {{ {list}.push({value}); }}"),
            2 => format!("if {list}.len() > {at} {{ {list}.remove({at}); }}"),
            3 => format!("{list}.truncate({at});"),
            4 => format!("if {list}.len() > {at} {{ {list}[{at}] = {value}; }}"),
            5 => format!("{list}.resize({}, {value});", at + 1),
            _ => format!("if {list}.len() < {len} {{ {list}.insert(0, {value}); }}"),
        };
        self.end(place.root, false);
        text
    }

    /// Returns a closure that selects elements and changes nothing.
    fn kept(&mut self, element: &Ty, fuel: usize) -> String {
        let frozen = self.freeze_all(true);
        let test = self.predicate(element, fuel);
        self.thaw(frozen);
        test
    }

    fn exchanged(&mut self) -> String {
        let Some(one) = self.place(true, &|_| true) else { return self.declared(0) };
        let ty = one.ty.clone();
        if self.one_in(2) {
            let Some(other) = self.place(true, &|it| *it == ty) else { return String::new() };
            return format!("({0}, {1}) = ({1}, {0});", one.text, other.text);
        }
        self.lend(one.root, true);
        let other = self.place(true, &|it| *it == ty);
        self.end(one.root, true);
        match other {
            Some(other) => format!("core::mem::swap(&mut {}, &mut {});", one.text, other.text),
            None if one.text.contains('(') => String::new(),
            None => {
                self.lend(one.root, true);
                let value = self.value(&ty, 0);
                self.end(one.root, true);
                let name = self.new_name();
                self.env.push(Var::new(name, &ty, Kind::Owned, false));
                format!("let {name} = core::mem::replace(&mut {}, {value});", one.text)
            }
        }
    }

    fn branch(&mut self, fuel: usize) -> String {
        let before = self.env.len();
        let (condition, loans) = self.condition(fuel - 1);
        let then = self.statements(fuel - 1);
        self.env.truncate(before);
        loans.into_iter().for_each(|(var, write)| self.end(var, write));
        if self.one_in(3) {
            return format!("if {condition} {{\n{then}}}");
        }
        let otherwise = self.statements(fuel - 1);
        format!("if {condition} {{\n{then}}} else {{\n{otherwise}}}")
    }

    fn match_statement(&mut self, fuel: usize) -> String {
        self.arms(fuel - 1, &mut |it| it.statements(fuel - 1))
    }

    pub fn label(&mut self) -> String {
        self.labels += 1;
        format!("'l{}", self.labels)
    }

    /// The body of a loop: its label is in scope.
    fn body(&mut self, fuel: usize, value: Option<Ty>) -> (String, String) {
        let label = self.label();
        self.loops.push(Left { label: label.clone(), value, block: false });
        let text = self.statements(fuel - 1);
        self.loops.pop();
        let used = text.contains(&format!("{label};")) || text.contains(&format!("{label} "));
        (if used { format!("{label}: ") } else { String::new() }, text)
    }

    /// A `for` through what links of an iterator give.
    fn through(&mut self, fuel: usize) -> Option<String> {
        let links = self.links(fuel - 1)?;
        let before = self.env.len();
        let pattern = self.item(&links.item, false, before);
        let (label, body) = self.body(fuel, None);
        self.env.truncate(before);
        self.unlinked(&links);
        Some(format!("{label}for {pattern} in {} {{\n{body}}}", links.text))
    }

    /// A `for` through an array or a list.
    fn each(&mut self, fuel: usize) -> String {
        if self.one_in(3)
            && let Some(text) = self.through(fuel)
        {
            return text;
        }
        let write = self.one_in(2);
        let Some(place) = self.any_place(write, &|ty| ty.sequence().is_some()) else {
            return self.range(fuel);
        };
        let Some((element, len)) = place.ty.sequence() else { return String::new() };
        let element = element.clone();
        let before = self.env.len();
        let mut mode = if write { Kind::Exclusive } else { Kind::Shared };
        let list = !matches!(place.ty, Ty::Array(..)) || !element.is_data();
        let text = &place.text;
        let iter = match (self.below(8), write) {
            (0, false) if !list => {
                mode = Kind::Owned;
                text.clone()
            }
            (0 | 1, false) => format!("&{text}"),
            (0 | 1, true) => format!("&mut {text}"),
            (2, false) => format!("{text}.iter().rev()"),
            (3, true) => format!("{text}.iter_mut().rev()"),
            (3, false) => format!("{text}.iter().skip({})", self.below(len)),
            (4, true) => format!("{text}.iter_mut().take({})", self.below(len) + 1),
            (4, false) if len > 1 => return self.windows(&place.text, place.root, &element, fuel),
            (_, true) => format!("{text}.iter_mut()"),
            (_, false) => format!("{text}.iter()"),
        };
        let lent = mode != Kind::Owned;
        if lent {
            self.lend(place.root, write);
        }
        let (iter, pattern) = if self.one_in(3) && iter.contains(".iter") {
            let name = self.new_name();
            self.env.push(Var::new(name, &Ty::Int("usize"), Kind::Owned, false));
            let from = self.env.len() - 1;
            let inner = self.pattern_beside(&element, &mode, from);
            (format!("{iter}.enumerate()"), format!("({name}, {inner})"))
        } else {
            let pattern = self.pattern(&element, &mode, false, 1);
            (iter, pattern)
        };
        let (label, body) = self.body(fuel, None);
        self.env.truncate(before);
        if lent {
            self.end(place.root, write);
        }
        format!("{label}for {pattern} in {iter} {{\n{body}}}")
    }

    /// A pattern whose names are others than those behind `from`.
    fn pattern_beside(&mut self, ty: &Ty, mode: &Kind, from: usize) -> String {
        let name = self.env[from].name.clone();
        let at = self.env.len();
        let pattern = self.pattern(ty, mode, false, 1);
        if self.env[at..].iter().any(|var| var.name == name) {
            self.env.truncate(at);
            return "_".to_owned();
        }
        pattern
    }

    fn windows(&mut self, text: &str, root: usize, element: &Ty, fuel: usize) -> String {
        let before = self.env.len();
        self.lend(root, false);
        let name = self.new_name();
        let size = 1 + self.below(2);
        // As an array, since that is how long a window is; a chunk that is not exact may be shorter.
        let window = Ty::Array(Box::new(element.clone()), size);
        self.env.push(Var::new(name, &window, Kind::Shared, false));
        let how = self.random.of(&["windows", "chunks_exact"]);
        // A window is a slice: only its elements are of a type that the rest knows.
        let first = self.new_name();
        let at = self.below(size);
        let var = self.env.len() - 1;
        self.env[var].hidden += 1;
        self.env.push(Var::new(first, element, Kind::Shared, false));
        let (label, body) = self.body(fuel, None);
        self.env.truncate(before);
        self.end(root, false);
        format!(
            "{label}for {name} in {text}.{how}({size}) {{\nlet {first} = &{name}[{at}];\n{body}}}"
        )
    }

    /// A `for` over a range.
    fn range(&mut self, fuel: usize) -> String {
        let before = self.env.len();
        let int = self.random.of(&["u8", "usize", "i32", "i8", "u64", "i16"]);
        let low = self.below(3);
        let high = match self.below(4) {
            0 | 1 => format!("{}_{int}", low + self.below(5)),
            2 => {
                let value = self.value(&Ty::Int(int), fuel - 1);
                format!("({value} % 6)")
            }
            _ => {
                let value = self.value(&Ty::Int("u8"), fuel - 1);
                format!("({value} % 5) as {int}")
            }
        };
        let dots = self.random.of(&["..", "..", "..="]);
        let range = format!("{low}{dots}{high}");
        let range = match self.below(6) {
            0 => format!("({range}).rev()"),
            1 => format!("({low}{dots}{}).step_by({})", low + self.below(9), 1 + self.below(3)),
            _ => range,
        };
        let ty = if range.contains("step_by") { "i32" } else { int };
        let name = self.new_name();
        self.env.push(Var::new(name, &Ty::Int(ty), Kind::Owned, false));
        let (label, body) = self.body(fuel, None);
        self.env.truncate(before);
        format!("{label}for {name} in {range} {{\n{body}}}")
    }

    /// A `while` whose bound is declared, or a `while let`.
    fn counted(&mut self, fuel: usize) -> String {
        let before = self.env.len();
        let bound = if self.risky() { 3 } else { 40 };
        let (condition, loans) = self.condition(fuel - 1);
        let (label, body) = self.body(fuel, None);
        self.env.truncate(before);
        loans.into_iter().for_each(|(var, write)| self.end(var, write));
        self.labels += 1;
        let count = format!("passes{}", self.labels);
        format!(
            "let mut {count} = 0_u8;\n#[bound({bound})]\n{label}while {count} < 5 && {condition} {{\n{count} += 1;\n{body}}}"
        )
    }

    /// A `loop` with a value.
    fn valued_loop(&mut self, fuel: usize) -> String {
        let ty = self.items.any(self.random, 1, true);
        let before = self.env.len();
        let (label, body) = self.body(fuel, Some(ty.clone()));
        let (condition, value) = (self.logical(fuel - 1), self.value(&ty, fuel - 1));
        self.env.truncate(before);
        self.labels += 1;
        let count = format!("passes{}", self.labels);
        let last = self.value(&ty, fuel - 1);
        let name = self.new_name();
        self.env.push(Var::new(name, &ty, Kind::Owned, true));
        format!(
            "let mut {count} = 0_u8;\nlet mut {name}: {} = {label}loop {{\nif {count} >= 4 {{ break {last}; }}\n\
             {count} += 1;\nif {condition} {{ break {value}; }}\n{body}}};",
            self.items.name(&ty)
        )
    }

    /// A way out of a loop.
    fn left(&mut self, fuel: usize) -> String {
        if self.loops.is_empty() {
            return self.assigned(fuel);
        }
        let condition = self.logical(fuel);
        let way = self.way_out(fuel);
        format!("if {condition} {{ {way} }}")
    }

    fn way_out(&mut self, fuel: usize) -> String {
        if self.loops.is_empty() || self.one_in(4) {
            let Some(result) = self.result.clone() else { return "panic!(\"left\");".to_owned() };
            return format!("return {};", self.value(&result, fuel));
        }
        let at = self.below(self.loops.len());
        let Left { label, value, block } = self.loops[at].clone();
        let innermost = at + 1 == self.loops.len() && !block;
        let label = if innermost && self.one_in(2) { String::new() } else { label };
        match value {
            _ if !block && self.one_in(2) => format!("continue {label};"),
            Some(ty) => format!("break {label} {};", self.value(&ty, fuel)),
            None => format!("break {label};"),
        }
    }

    fn let_else(&mut self, fuel: usize) -> String {
        let before = self.env.len();
        let ty = self.items.any(self.random, 2, true);
        let ty = if self.one_in(2) { Ty::Option(Box::new(ty)) } else { ty };
        let value = self.value(&ty, fuel - 1);
        if self.result.is_none() && self.loops.is_empty() {
            return format!("let _ = {value};");
        }
        let way = self.way_out(fuel - 1);
        let told = self.told();
        self.env.truncate(before);
        let pattern = self.pattern(&ty, &Kind::Owned, true, 2);
        format!("let {pattern} = ({value}) else {{ {told}{way} }};")
    }

    /// A closure in a scope of its own, in which what it captures is lent to it.
    fn closure(&mut self, fuel: usize) -> String {
        let (from, to) =
            (self.items.any(self.random, 1, true), self.items.any(self.random, 1, true));
        let name = self.new_name();
        let (text, used) = self.tracked(|it| {
            it.unreturned(|it| {
                let before = it.env.len();
                let name = it.new_name();
                it.env.push(Var::new(name, &from, Kind::Owned, false));
                let value = it.inner_block(&to, fuel);
                it.close(before);
                format!("|{name}: {}| {{ {value} }}", it.items.name(&from))
            })
        });
        let changes = used.iter().any(|(_, write)| *write);
        used.iter().for_each(|(var, write)| self.lend(*var, *write));
        let before = self.env.len();
        self.env.push(Var::new(name, &to, Kind::Closure(from, changes), false));
        let result = self.items.any(self.random, 1, true);
        let body = self.statements(fuel - 1);
        let value = if self.one_in(2) { self.value(&to, 1) } else { self.value(&result, 1) };
        self.close(before);
        used.iter().for_each(|(var, write)| self.end(*var, *write));
        let mutable = if changes { "mut " } else { "" };
        format!("{{\nlet {mutable}{name} = {text};\n{body}let _ = {value};\n}}")
    }

    /// A name for a place, in a scope of its own.
    fn reference(&mut self, fuel: usize) -> String {
        let write = self.one_in(2);
        let place = match self.slice(write) {
            Some(place) => Some(place),
            None => self.place(write, &|_| true),
        };
        let Some(place) = place else { return self.declared(fuel) };
        let before = self.env.len();
        let name = self.new_name();
        self.lend(place.root, write);
        let kind = if write { Kind::Exclusive } else { Kind::Shared };
        self.env.push(Var::new(name, &place.ty, kind, false));
        let body = self.statements(fuel - 1);
        self.env.truncate(before);
        self.end(place.root, write);
        let lent = if write { "&mut " } else { "&" };
        format!("{{\nlet {name} = {lent}{};\n{body}}}", place.text)
    }

    /// Some elements of what is at hand, now and then.
    fn slice(&mut self, write: bool) -> Option<Place> {
        if !self.one_in(3) {
            return None;
        }
        let place = self.place(false, &|ty| ty.sequence().is_some())?;
        let ty = Ty::Slice(Box::new(place.ty.sequence()?.0.clone()));
        let place = self.lent(&ty, write)?;
        Some(Place { ty, ..place })
    }

    fn scope(&mut self, fuel: usize) -> String {
        format!("{{\n{}}}", self.statements(fuel - 1))
    }

    fn returned(&mut self, fuel: usize) -> String {
        let Some(result) = self.result.clone() else { return self.assigned(fuel) };
        let condition = self.logical(fuel);
        let value = self.value(&result, fuel - 1);
        format!("if {condition} {{ return {value}; }}")
    }
}
