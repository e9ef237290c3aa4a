//! Programs that aim at the proofs: small functions whose checks are nearly needed, or nearly not.
//!
//! Bounds that move, heads before conditions, steps above one, numbers of enums, casts, wrapping counters, early exits,
//! and parts that another name or a call writes. Numbers are small and lie about the lengths, so that what is wrong by
//! one shows. No loop makes many passes: its bound is small, or declared.

use std::fmt::Write as _;

use bessemer_tests::random::Random;

use super::writer::{Entry, Program};

/// Types of numbers, the smaller ones more often: there a bound is near.
const INTS: [&str; 11] =
    ["u8", "u8", "i8", "i8", "u16", "i16", "u32", "i32", "usize", "u64", "i64"];

/// The length of the parameter `x`, and of the field `x`.
const LENGTH: usize = 6;
const SHORT: usize = 4;

/// The declarations of each program, with its name in place of `NAME` and `LONG`.
const ITEMS: &str = "
#[data]
#[repr(i8)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum LONGKind { A = FIRST, B = SECOND, C = THIRD }

#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LONGPart { pub i: usize, pub n: u8, pub m: i16, pub x: [u8; 4] }

#[function]
fn NAME_move(i: &mut usize, by: usize) {
    *i = i.wrapping_add(by) % 9;
}

#[function]
fn NAME_next(x: &[i32], i: usize) -> i32 {
    if i + 1 < x.len() { x[i + 1] } else { -1 }
}
";

struct Var {
    name: String,
    ty: &'static str,
}

struct Aimed<'r> {
    random: &'r mut Random,
    /// The variables in scope.
    vars: Vec<Var>,
    /// Those that are written nowhere: the counters of `for`.
    fixed: usize,
    named: usize,
    loops: usize,
    /// Whether sums and differences are kept from overflowing, as a rule: else few calls come to their end.
    tame: bool,
    kind: String,
    name: String,
}

/// A program that aims at the proofs.
pub fn program(random: &mut Random, name: &str) -> Program {
    let long = name.to_uppercase();
    let first = random.of(&[-1_i64, 0, 1, -7, 10]);
    let second = first + random.of(&[1, 1, 4]);
    let third = second + random.of(&[1, 1, 10]);
    let mut text = ITEMS.replace("NAME", name).replace("LONG", &long);
    for (mark, value) in [("FIRST", first), ("SECOND", second), ("THIRD", third)] {
        text = text.replace(mark, &value.to_string());
    }
    let kind = format!("{long}Kind");
    let tame = !random.one_in(4);
    text.push_str(&seek(random, name));
    let mut aimed = Aimed {
        random,
        vars: Vec::new(),
        fixed: 0,
        named: 0,
        loops: 0,
        tame,
        kind,
        name: name.to_owned(),
    };
    let mut params = Vec::new();
    for var in ["a", "b", "c"] {
        let ty = aimed.random.of(&INTS);
        aimed.vars.push(Var { name: var.to_owned(), ty });
        params.push((var, "", ty.to_owned()));
    }
    params.push(("flag", "", "bool".to_owned()));
    params.push(("k", "", aimed.kind.clone()));
    params.push(("x", "&mut ", format!("[i32; {LENGTH}]")));
    params.push(("s", "&mut ", format!("{long}Part")));
    params.push(("t", "&mut ", "u64".to_owned()));
    let body: String = (0..2 + aimed.random.below(4)).map(|_| aimed.statement(3)).collect();
    let result = aimed.number("i32", 2);
    let list: Vec<String> = params
        .iter()
        .map(|(name, by, ty)| match *by {
            "" => format!("mut {name}: {ty}"),
            by => format!("{name}: {by}{ty}"),
        })
        .collect();
    let _ = write!(
        text,
        "#[function]\npub fn {name}({}) -> i32 {{\n{body}{result}\n}}\n",
        list.join(", ")
    );
    let params = params.into_iter().map(|(_, by, ty)| (by, ty)).collect();
    let entry = Entry { name: name.to_owned(), params, atomic: false, stops: false };
    Program { name: name.to_owned(), text, unit: None, entries: vec![entry], aimed: true }
}

/// A function that goes through a slice up to another value, which it has compared with the length.
fn seek(random: &mut Random, name: &str) -> String {
    let compare = random.of(&["n > x.len()", "n > x.len()", "n >= x.len()", "n < x.len()"]);
    let (from, end) = (random.below(3), random.of(&["n", "n", "x.len().max(1) - 1", "x.len()"]));
    let index = random.of(&["i", "i", "i + 1", "i - 1", "i + 2"]);
    format!(
        "
#[function]
fn {name}_seek(x: &[i32], n: usize) -> i32 {{
    if {compare} {{
        return 0;
    }}
    let mut sum = 0_i32;
    for i in {from}..{end} {{
        sum = sum.wrapping_mul(31) ^ x[{index}];
    }}
    sum
}}
"
    )
}

impl Aimed<'_> {
    /// A number near the lengths.
    fn near(&mut self) -> usize {
        self.random.of(&[0, 1, 1, 2, 3, 4, 4, 5, 5, 6, 6, 7, 8, 9])
    }

    fn variable(&mut self, ty: &'static str) -> String {
        self.named += 1;
        let name = format!("v{}", self.named);
        self.vars.push(Var { name: name.clone(), ty });
        name
    }

    /// A variable of some type; `written`: one that may be.
    fn var(&mut self, written: bool) -> (String, &'static str) {
        loop {
            let var = &self.vars[self.random.below(self.vars.len())];
            if !(written && var.name.starts_with('f')) {
                return (var.name.clone(), var.ty);
            }
        }
    }

    /// What has a number without computing one.
    fn source(&mut self, ty: &'static str) -> String {
        match self.random.below(14) {
            0 => self.cast("s.n", "u8", ty),
            1 => self.cast("s.m", "i16", ty),
            2 => self.cast("s.i", "usize", ty),
            3 => format!("(k as {ty})"),
            4 => format!("(flag as {ty})"),
            5 => self.cast("x.len()", "usize", ty),
            6 => {
                let index = self.index(SHORT, 0);
                self.cast(&format!("s.x[{index}]"), "u8", ty)
            }
            7 | 8 => format!("{}_{ty}", self.near()),
            _ => {
                let own: Vec<String> = self
                    .vars
                    .iter()
                    .filter(|var| var.ty == ty)
                    .map(|var| var.name.clone())
                    .collect();
                if !own.is_empty() && !self.random.one_in(4) {
                    return own[self.random.below(own.len())].clone();
                }
                let (name, from) = self.var(false);
                self.cast(&name, from, ty)
            }
        }
    }

    fn cast(&mut self, text: &str, from: &str, ty: &str) -> String {
        if from == ty { text.to_owned() } else { format!("({text} as {ty})") }
    }

    /// An expression of a type of numbers.
    fn number(&mut self, ty: &'static str, depth: usize) -> String {
        if depth == 0 {
            return self.source(ty);
        }
        let signed = ty.starts_with('i');
        let one = self.number(ty, depth - 1);
        let near = self.near();
        match self.random.below(26) {
            0..=3 if self.tame => match self.random.below(3) {
                0 => format!("({one}.min(99) + {near})"),
                1 => format!("({one}.max({near}) - {near})"),
                _ => format!("({one} % 9 + {near})"),
            },
            0 | 1 => format!("({one} + {near})"),
            2 | 3 => format!("({one} - {near})"),
            4 => format!("({one} % {})", near.max(2)),
            5 => format!("({one} / {})", near.max(1)),
            6 => format!("{one}.min({})", near.max(1)),
            7 => format!("{one}.max({near})"),
            8 => format!("({one} & {})", near.max(1)),
            9 => format!("({one} >> {})", near.min(7)),
            10 => format!("{one}.wrapping_add({near})"),
            11 => format!("{one}.wrapping_sub({near})"),
            12 => format!("{one}.saturating_sub({near})"),
            13 if self.tame => format!("({one}.min(9) * {})", near.clamp(1, 3)),
            13 => format!("({one} * {})", near.clamp(1, 3)),
            14 => format!("{one}.clamp({}, {})", near.min(2), near + 1),
            15 if signed => format!("(-{one}.max(-9))"),
            16 if signed => format!("{one}.max(-9).abs()"),
            15 | 16 => format!("(!{one})"),
            17 => {
                let other = self.number(ty, depth - 1);
                let operator = match self.tame {
                    true => self.random.of(&["&", "|", "^", "/", "%"]),
                    false => self.random.of(&["+", "-", "*", "/", "%", "&", "|", "^"]),
                };
                format!("({one} {operator} {other})")
            }
            18 => {
                let other = self.number(ty, depth - 1);
                format!(
                    "{one}.{}({other})",
                    self.random
                        .of(&["min", "max", "abs_diff_of"])
                        .replace("abs_diff_of", "wrapping_sub")
                )
            }
            19 => {
                let from = self.random.of(&INTS);
                let other = self.number(from, depth - 1);
                self.cast(&other, from, ty)
            }
            20 => {
                let (condition, other) = (self.condition(depth - 1), self.source(ty));
                format!("(if {condition} {{ {one} }} else {{ {other} }})")
            }
            21 => {
                let (of, other) = (self.kind.clone(), self.source(ty));
                format!("(match k {{ {of}::A => {one}, {of}::B => {near}, {of}::C => {other} }})")
            }
            _ => one,
        }
    }

    /// An index into so many elements, mostly in bounds.
    fn index(&mut self, length: usize, depth: usize) -> String {
        match self.random.below(if self.tame { 5 } else { 8 }) {
            0 => self.random.below(length).to_string(),
            1 => format!("({} % {length})", self.number("usize", depth)),
            2 => format!("{}.min({})", self.number("usize", depth), length - 1),
            3 if depth > 0 && !self.tame => {
                format!("({length} - 1 - {})", self.number("usize", depth - 1))
            }
            _ => self.number("usize", depth),
        }
    }

    fn condition(&mut self, depth: usize) -> String {
        match self.random.below(if depth == 0 { 7 } else { 11 }) {
            0..=4 => {
                let ty = self.random.of(&INTS);
                let operator = self.random.of(&["<", "<", "<=", ">", ">=", "==", "!="]);
                let (one, less) = (self.number(ty, depth.min(1)), depth.saturating_sub(1));
                let other = if self.random.one_in(2) {
                    format!("{}", self.near())
                } else {
                    self.number(ty, less.min(1))
                };
                format!("({one} {operator} {other})")
            }
            5 => {
                let variant = self.random.of(&["A", "B", "C"]);
                format!("(k {} {}::{variant})", self.random.of(&["==", "!="]), self.kind)
            }
            6 => "flag".to_owned(),
            7 => format!("(!{})", self.condition(depth - 1)),
            _ => {
                let (one, other) = (self.condition(depth - 1), self.condition(depth - 1));
                format!("({one} {} {other})", self.random.of(&["&&", "&&", "||"]))
            }
        }
    }

    /// An operation that may need a check, told to `t` or stored.
    fn use_of(&mut self) -> String {
        let ty = self.random.of(&INTS);
        let value = match self.random.below(11) {
            0..=3 => format!("x[{}]", self.index(LENGTH, 1)),
            4 => {
                let bits = if self.random.one_in(2) { "u32" } else { "u8" };
                format!("(1_u32 << {})", self.number(bits, 1))
            }
            5 => {
                let (one, other) = (self.number(ty, 1), self.number(ty, 1));
                format!("({one} {} {other})", self.random.of(&["/", "%"]))
            }
            6 => {
                let index = self.index(LENGTH, 1);
                format!("{}_next(&x[..], {index})", self.name)
            }
            7 => format!("s.x[{}]", self.index(SHORT, 1)),
            8 => {
                let (from, to) = (self.index(LENGTH, 1), self.number("usize", 1));
                format!("{}_seek(&x[{from} % {LENGTH}..], {to})", self.name)
            }
            _ => self.number(ty, 2),
        };
        match self.random.below(4) {
            0 => format!("x[{}] = {value} as i32;\n", self.index(LENGTH, 1)),
            _ => format!("*t = t.wrapping_mul(31).wrapping_add({value} as u64);\n"),
        }
    }

    /// A change of what conditions and bounds have looked at.
    fn change(&mut self) -> String {
        let (name, ty) = self.var(true);
        let near = self.near();
        match self.random.below(12) {
            0 if self.tame => format!("if {name} < 99 {{ {name} += {near}; }}\n"),
            1 if self.tame => format!("if {name} > {near} {{ {name} -= {near}; }}\n"),
            0 => format!("{name} += {near};\n"),
            1 => format!("{name} -= {near};\n"),
            2 => format!("{name} = {name}.wrapping_add({near});\n"),
            3 => format!("{name} = {name}.min({near});\n"),
            4 => format!("{name} = {};\n", self.number(ty, 2)),
            5 => format!("{}_move(&mut s.i, {near});\n", self.name),
            6 => format!("s.n = {};\n", self.number("u8", 1)),
            7 => {
                let by = self.number("usize", 1);
                format!("{{ let by = {by}; let part = &mut s.i; *part = by % 8; }}\n")
            }
            8 => format!("s.x[{}] = {};\n", self.index(SHORT, 1), self.number("u8", 1)),
            9 => "core::mem::swap(&mut s.n, &mut s.x[1]);\n".to_owned(),
            10 => "flag = !flag;\n".to_owned(),
            _ => format!("{name} /= {};\n", near.max(1)),
        }
    }

    fn statement(&mut self, depth: usize) -> String {
        match self.random.below(if depth == 0 { 7 } else { 14 }) {
            0..=2 => self.use_of(),
            3 => self.change(),
            4 => {
                let ty = self.random.of(&INTS);
                let value = self.number(ty, 2);
                format!("let mut {}: {ty} = {value};\n", self.variable(ty))
            }
            5 => {
                let condition = self.condition(1);
                match self.random.below(3) {
                    0 if self.loops > 0 => format!("if {condition} {{ break; }}\n"),
                    _ if self.tame && !self.random.one_in(4) => {
                        format!("if {condition} {{ return {}; }}\n", self.number("i32", 1))
                    }
                    0 | 1 => format!("if {condition} {{ return {}; }}\n", self.number("i32", 1)),
                    _ => format!("assert!({condition});\n"),
                }
            }
            6 => self.use_of(),
            7..=9 => {
                let condition = self.condition(2);
                let then = self.block(depth - 1);
                match self.random.one_in(2) {
                    true => format!("if {condition} {{\n{then}}}\n"),
                    false => {
                        format!(
                            "if {condition} {{\n{then}}} else {{\n{}}}\n",
                            self.block(depth - 1)
                        )
                    }
                }
            }
            10 => {
                let ty = self.random.of(&INTS);
                let value = self.number(ty, 1);
                let arms = [self.block(depth - 1), self.block(depth - 1), self.block(depth - 1)];
                let from = self.near();
                format!(
                    "match {value} {{\n{from} => {{\n{}}}\n{}..={} => {{\n{}}}\n_ => {{\n{}}}\n}}\n",
                    arms[0],
                    from + 1,
                    from + 3,
                    arms[1],
                    arms[2]
                )
            }
            _ if self.loops < 2 => self.repeat(depth - 1),
            _ => self.use_of(),
        }
    }

    fn block(&mut self, depth: usize) -> String {
        let known = self.vars.len();
        let text = (0..1 + self.random.below(3)).map(|_| self.statement(depth)).collect();
        self.vars.truncate(known);
        text
    }

    fn body(&mut self, depth: usize) -> String {
        self.loops += 1;
        let text = self.block(depth);
        self.loops -= 1;
        text
    }

    /// A loop: over a range, behind a condition, or with its condition in its midst.
    fn repeat(&mut self, depth: usize) -> String {
        let known = self.vars.len();
        let text = match self.random.below(3) {
            0 => self.counted(depth),
            1 => self.behind_condition(depth),
            _ => self.before_condition(depth),
        };
        self.vars.truncate(known);
        text
    }

    /// A number that is small, whatever the arguments.
    fn small(&mut self, ty: &'static str) -> String {
        match self.random.below(4) {
            0 => format!("{}_{ty}", self.near()),
            1 => format!("({} % {})", self.number(ty, 1), 2 + self.near()),
            _ => format!("{}.min({})", self.number(ty, 1), self.near()),
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

    /// How a counter goes up.
    fn step(&mut self, name: &str) -> String {
        let by = 1 + self.random.below(4);
        match self.random.below(5) {
            0 => format!("{name} = {name}.wrapping_add({by});\n"),
            1 => {
                let condition = self.condition(1);
                format!("if {condition} {{ {name} += {by}; }} else {{ {name} += 1; }}\n")
            }
            _ => format!("{name} += {by};\n"),
        }
    }

    /// Passes are declared, unless the step shows that it ends.
    fn declared(&mut self, step: &str) -> &'static str {
        match step.contains("wrapping") || self.random.one_in(2) {
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
            0 => self.near().to_string(),
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
        let step = self.step(&name);
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
        let step = self.step(&name);
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

    /// Takes variables out of scope.
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

    fn hide(&mut self, names: &[&str]) -> Vec<Var> {
        let (hidden, left) = std::mem::take(&mut self.vars)
            .into_iter()
            .partition(|var| names.contains(&var.name.as_str()));
        self.vars = left;
        hidden
    }
}
