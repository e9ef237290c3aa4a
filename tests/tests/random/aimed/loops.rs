//! Loops of programs that aim at the proofs: bounds that change, conditions before and inside the body, steps above
//! one, declared bounds.

use std::fmt::Write as _;

use super::{Aimed, INTS, Var};

impl Aimed<'_> {
    /// A loop: over a range, behind a condition, or with its condition in its midst.
    pub(super) fn repeat(&mut self, depth: usize) -> String {
        let known = self.vars.len();
        let text = match self.random.below(3) {
            0 => self.counted(depth),
            1 => self.behind_condition(depth),
            _ => self.before_condition(depth),
        };
        self.vars.truncate(known);
        text
    }

    /// A number that is small, whatever the arguments: neither end of a loop is far away.
    fn small(&mut self, ty: &'static str) -> String {
        let limit = self.constant(ty);
        match self.random.below(4) {
            0 => limit,
            1 => format!("({} % {})", self.number(ty, 1), 2 + self.near()),
            _ if ty.starts_with('i') => format!("{}.clamp(-3, {limit})", self.number(ty, 1)),
            _ => format!("{}.min({limit})", self.number(ty, 1)),
        }
    }

    fn counted(&mut self, depth: usize) -> String {
        let ty = self.random.of(&INTS);
        let (from, to) = match self.random.one_in(3) {
            true => (format!("({} % 5)", self.number(ty, 1)), self.small(ty)),
            false => (format!("{}_{ty}", self.random.below(3)), self.small(ty)),
        };
        let dots = self.random.of(&["..", "..", "..="]);
        let range = match self.random.below(6) {
            0 => format!("({from}{dots}{to}).rev()"),
            1 => format!("({from}{dots}{to}).step_by({})", 1 + self.random.below(4)),
            _ => format!("{from}{dots}{to}"),
        };
        self.fixed += 1;
        let name = format!("f{}", self.fixed);
        self.vars.push(Var { name: name.clone(), ty });
        format!("for {name} in {range} {{\n{}}}\n", self.body(depth))
    }

    /// Returns the step of a counter.
    fn step(&mut self, name: &str, ty: &'static str) -> String {
        let by = self.positive(ty);
        match self.random.below(5) {
            0 => format!("{name} = {name}.wrapping_add({by});\n"),
            1 => {
                let condition = self.condition(1);
                format!("if {condition} {{ {name} += {by}; }} else {{ {name} += 1; }}\n")
            }
            _ => format!("{name} += {by};\n"),
        }
    }

    /// Passes are declared, unless the step shows that it ends. A constant behind a conversion does not show it.
    fn declared(&mut self, step: &str) -> &'static str {
        match step.contains("wrapping") || step.contains(" as ") || self.random.one_in(2) {
            true => self.random.of(&["#[bound(6)]\n", "#[bound(9)]\n", "#[bound(300)]\n"]),
            false => "",
        }
    }

    fn behind_condition(&mut self, depth: usize) -> String {
        let ty = self.random.of(&INTS);
        let (start, value) = (self.small(ty), self.small(ty));
        let name = self.variable(ty);
        let mut lead = format!("let mut {name}: {ty} = {start};\n");
        let limit = match self.random.below(3) {
            0 => self.constant(ty),
            1 => "x.len()".to_owned(),
            _ => {
                let limit = self.variable(ty);
                let _ = writeln!(lead, "let mut {limit}: {ty} = {value};");
                limit
            }
        };
        let of = if limit.starts_with('x') { format!("({limit} as {ty})") } else { limit.clone() };
        let operator = self.random.of(&["<", "<", "<="]);
        let condition = match self.random.below(4) {
            0 => format!("x[{name} as usize] < 3 && {name} {operator} {of}"),
            1 => format!("{name} {operator} {of} && {}", self.condition(1)),
            _ => format!("{name} {operator} {of}"),
        };
        let step = self.step(&name, ty);
        let (bound, body) = self.bounded_body(&[&name, &limit], &step, depth);
        let uses = format!("*t = t.wrapping_mul(31).wrapping_add(x[{name} as usize] as u64);\n");
        let inner = match self.random.below(4) {
            0 => format!("{step}{body}"),
            1 => format!("{uses}{body}{step}"),
            2 => format!("{body}{step}{uses}"),
            _ => format!("{body}{step}"),
        };
        format!("{lead}{bound}while {condition} {{\n{inner}}}\n")
    }

    fn before_condition(&mut self, depth: usize) -> String {
        let ty = self.random.of(&INTS);
        let (start, value) = (self.small(ty), self.small(ty));
        let (name, limit) = (self.variable(ty), self.variable(ty));
        let step = self.step(&name, ty);
        let (bound, body) = self.bounded_body(&[&name, &limit], &step, depth);
        let index = match self.random.below(3) {
            0 => format!("{name} as usize"),
            1 => format!("{limit} as usize"),
            _ => format!("({limit} - {name}) as usize"),
        };
        let operator = self.random.of(&[">=", ">=", ">"]);
        format!(
            "let mut {name}: {ty} = {start};\nlet mut {limit}: {ty} = {value};\n{bound}loop {{\n\
             *t = t.wrapping_mul(31).wrapping_add(x[{index}] as u64);\n\
             if {name} {operator} {limit} {{ break; }}\n{body}{step}}}\n"
        )
    }

    /// A body, and what its loop says of its end. In three of four the step alone writes the variables that the condition
    /// compares, so that the loop may show that it ends.
    fn bounded_body(
        &mut self,
        compared: &[&str],
        step: &str,
        depth: usize,
    ) -> (&'static str, String) {
        let hidden: Vec<Var> = match self.random.one_in(4) {
            true => Vec::new(),
            false => self.hide(compared),
        };
        let bound = if hidden.is_empty() { "#[bound(9)]\n" } else { self.declared(step) };
        let body = self.body(depth);
        self.vars.extend(hidden);
        (bound, body)
    }

    /// Takes variables out of scope.
    fn hide(&mut self, names: &[&str]) -> Vec<Var> {
        let (hidden, left) = std::mem::take(&mut self.vars)
            .into_iter()
            .partition(|var| names.contains(&var.name.as_str()));
        self.vars = left;
        hidden
    }
}
