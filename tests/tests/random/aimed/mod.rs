//! Programs that aim at the proofs: small functions whose checks are nearly needed, or nearly not.
//!
//! A text is generic in constants, and each of its instances is a program of its own: the same operations beside other
//! bounds, steps and lengths, for one look of rustc at the text. An entry with a selector calls them.
//!
//! Bounds that move, heads before conditions, steps above one, numbers of enums, casts, wrapping counters, early exits,
//! indices that a function chooses, and parts that another name or a call writes. Numbers are small and lie about the lengths, so that what is wrong by
//! one shows. No loop makes many passes: its bound is small, or declared.

mod choosers;
mod instances;
mod loops;

use std::fmt::Write as _;

use bessemer_tests::random::Random;

use super::writer::{Entry, Program};
pub use instances::{hold, instantiate, of_first_instance, with_constants_as_arguments};

/// Types of numbers, the smaller ones more often: there a bound is near.
const INTS: [&str; 11] =
    ["u8", "u8", "i8", "i8", "u16", "i16", "u32", "i32", "usize", "u64", "i64"];

/// The length of the parameter `x`, and of the field `x`.
const LENGTH: usize = 6;
const SHORT: usize = 4;

/// The constants of a text: any that are near the lengths, and those that are above zero.
const ANY: [&str; 3] = ["C0", "C1", "C2"];
const POSITIVE: [&str; 3] = ["D0", "D1", "D2"];

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
    /// True if sums and differences are kept from overflowing, as a rule: else few calls come to their end.
    tame: bool,
    kind: String,
    name: String,
}

/// Programs of one text that aim at the proofs, so many as there are instances.
pub fn program(random: &mut Random, name: &str, instances: usize) -> Program {
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
    text.push_str(&choosers::choosers(random, name));
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
    let constants = ANY.iter().chain(&POSITIVE).map(|name| format!("const {name}: usize"));
    let constants: Vec<String> = constants.collect();
    let _ = write!(
        text,
        "#[function]\nfn {name}_of<{}>({}) -> i32 {{\n{body}{result}\n}}\n",
        constants.join(", "),
        list.join(", ")
    );
    params.insert(0, ("which", "", "u8".to_owned()));
    text.push_str(&selector(random, name, &params, instances));
    let params = params.into_iter().map(|(_, by, ty)| (by, ty)).collect();
    let entry = Entry { name: name.to_owned(), params, atomic: false, stops: false };
    Program {
        name: name.to_owned(),
        text,
        unit: None,
        entries: vec![entry],
        instances: Some(instances),
    }
}

/// The entry: its first argument says which instance is called.
fn selector(
    random: &mut Random,
    name: &str,
    params: &[(&str, &'static str, String)],
    instances: usize,
) -> String {
    let names: Vec<&str> = params[1..].iter().map(|(name, ..)| *name).collect();
    let names = names.join(", ");
    let mut arms = String::new();
    for at in 0..instances {
        let any = ANY.map(|_| random.of(&[0, 1, 1, 2, 3, 4, 4, 5, 5, 6, 6, 7, 8, 9]));
        let positive = POSITIVE.map(|_| 1 + random.below(7));
        let all = any.iter().chain(&positive).map(usize::to_string).collect::<Vec<_>>();
        let _ = writeln!(arms, "{at} => {name}_of::<{}>({names}),", all.join(", "));
    }
    let list: Vec<String> =
        params.iter().map(|(name, by, ty)| format!("{name}: {by}{ty}")).collect();
    format!(
        "#[function]\npub fn {name}({}) -> i32 {{\nmatch which {{\n{arms}_ => 0,\n}}\n}}\n",
        list.join(", ")
    )
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

    /// A constant near the lengths: as often as not one in which the text is generic.
    fn constant(&mut self, ty: &str) -> String {
        match self.random.one_in(2) {
            true => format!("({} as {ty})", self.random.of(&ANY)),
            false => format!("{}_{ty}", self.near()),
        }
    }

    /// A constant between 1 and 7.
    fn positive(&mut self, ty: &str) -> String {
        match self.random.one_in(2) {
            true => format!("({} as {ty})", self.random.of(&POSITIVE)),
            false => format!("{}_{ty}", 1 + self.random.below(4)),
        }
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

    /// Returns a number that is not computed.
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
            7 | 8 => self.constant(ty),
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
        let near = self.constant(ty);
        let positive = self.positive(ty);
        match self.random.below(26) {
            0..=3 if self.tame => match self.random.below(3) {
                0 => format!("({one}.min(99) + {near})"),
                1 => format!("({one}.max({near}) - {near})"),
                _ => format!("({one} % 9 + {near})"),
            },
            0 | 1 => format!("({one} + {near})"),
            2 | 3 => format!("({one} - {near})"),
            4 => format!("({one} % {})", 2 + self.near()),
            5 => format!("({one} / {positive})"),
            6 => format!("{one}.min({near})"),
            7 => format!("{one}.max({near})"),
            8 => format!("({one} & {})", self.near().max(1)),
            9 => format!("({one} >> {positive})"),
            10 => format!("{one}.wrapping_add({near})"),
            11 => format!("{one}.wrapping_sub({near})"),
            12 => format!("{one}.saturating_sub({near})"),
            13 if self.tame => format!("({one}.min(9) * {positive})"),
            13 => format!("({one} * {positive})"),
            14 => format!("{one}.clamp({}, {near} + 2)", self.random.below(3)),
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
        match self.random.below(if self.tame { 8 } else { 11 }) {
            6 | 7 => {
                let (name, n) = (self.name.clone(), self.source("i32"));
                match self.random.below(4) {
                    0 => format!("{name}_best(x, {n})"),
                    1 => format!("{name}_spot(x, {n}).at"),
                    2 => format!("({name}_spot(x, {n}).n as usize)"),
                    _ => format!("{name}_place(x, {n}).unwrap_or({})", self.near()),
                }
            }
            0 => self.random.below(length).to_string(),
            1 => format!("({} % {length})", self.number("usize", depth)),
            2 => format!("{}.min({})", self.number("usize", depth), length - 1),
            3 if depth > 0 && !self.tame => {
                format!("({length} - 1 - {})", self.number("usize", depth - 1))
            }
            4 => self.constant("usize"),
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
                    self.constant(ty)
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
        let near = self.constant(ty);
        match self.random.below(12) {
            0 if self.tame => format!("if {name} < 99 {{ {name} += {near}; }}\n"),
            1 if self.tame => format!("if {name} > {near} {{ {name} -= {near}; }}\n"),
            0 => format!("{name} += {near};\n"),
            1 => format!("{name} -= {near};\n"),
            2 => format!("{name} = {name}.wrapping_add({near});\n"),
            3 => format!("{name} = {name}.min({near});\n"),
            4 => format!("{name} = {};\n", self.number(ty, 2)),
            5 => {
                let by = self.constant("usize");
                format!("{}_move(&mut s.i, {by});\n", self.name)
            }
            6 => format!("s.n = {};\n", self.number("u8", 1)),
            7 => {
                let by = self.number("usize", 1);
                format!("{{ let by = {by}; let part = &mut s.i; *part = by % 8; }}\n")
            }
            8 => format!("s.x[{}] = {};\n", self.index(SHORT, 1), self.number("u8", 1)),
            9 => "core::mem::swap(&mut s.n, &mut s.x[1]);\n".to_owned(),
            10 => "flag = !flag;\n".to_owned(),
            _ => format!("{name} /= {};\n", self.positive(ty)),
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
}
