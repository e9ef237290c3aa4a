//! Random programs around one loop: what it compares goes on in most of them, and something odd happens to it
//! in many.

use std::fmt::Write as _;

use bessemer_tests::random::Random;

/// A program: `fn(a, b, c, seen: &mut T) -> T`.
pub struct Program {
    pub name: String,
    pub text: String,
    ty: &'static str,
    /// Its first line.
    line: u32,
}

impl Program {
    /// Its arguments as words: the limits of the type, and numbers near them.
    pub fn arguments(&self, random: &mut Random) -> Vec<Vec<u64>> {
        let number = |random: &mut Random| {
            let small = random.below(12) as i64;
            let value = match (self.ty, random.below(4)) {
                (_, 0) => small,
                ("u8", 1) => 255 - small,
                ("u8", _) => random.below(256) as i64,
                ("i8", 1) => 127 - small,
                ("i8", 2) => small - 128,
                ("i8", _) => random.below(256) as i64 - 128,
                ("u32", 1) => i64::from(u32::MAX) - small,
                ("usize", 1) => -1 - small,
                _ => random.below(300) as i64,
            };
            value as u64
        };
        (0..4).map(|_| vec![number(random)]).collect()
    }
}

/// A file of programs.
pub struct Batch {
    pub text: String,
    pub programs: Vec<Program>,
}

impl Batch {
    pub fn new(random: &mut Random, count: usize) -> Batch {
        let mut text = String::from("//! Loops.\n#![allow(warnings)]\nuse bessemer::prelude::*;\n");
        for ty in TYPES {
            text += &HELPERS.replace("TYPE", ty);
        }
        let mut programs = Vec::new();
        for index in 0..count {
            let ty = random.of(&["u8", "u8", "i8", "i8", "u32", "usize"]);
            let name = format!("program_{index}");
            let line = text.lines().count() as u32 + 1;
            let body = Writer { random, ty, depth: 0, middle: false }.program(&name);
            text += &body;
            programs.push(Program { name, text: body, ty, line });
        }
        Batch { text, programs }
    }

    /// The program at a line of the file.
    pub fn program_at(&self, line: u32) -> String {
        let found = self.programs.iter().rev().find(|program| program.line <= line);
        found.map(|program| program.name.clone()).unwrap_or_default()
    }
}

const TYPES: [&str; 4] = ["u8", "i8", "u32", "usize"];

const HELPERS: &str = "
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Pair_TYPE { pub low: TYPE, pub high: TYPE }
#[function]
fn up_TYPE(x: &mut TYPE) -> bool { *x = x.wrapping_add(1); *x % 7 != 3 }
#[function]
fn down_TYPE(x: &mut TYPE) -> bool { *x = x.wrapping_sub(1); *x % 5 != 3 }
#[function]
fn next_TYPE(x: &mut TYPE) -> TYPE { *x = x.wrapping_sub(1); *x }
#[function]
fn place_TYPE(x: &mut TYPE) -> usize { *x = x.wrapping_sub(1); 2 }
#[function]
fn even_TYPE(x: &TYPE) -> bool { *x % 2 == 0 }
#[function]
fn reset_TYPE(p: &mut Pair_TYPE) { p.low = 0; }
";

/// Names of the numbers: two that are compared, and another one. They are locals or fields. They are locals or fields.
const NAMES: [&str; 3] = ["p.low", "p.high", "k"];

struct Writer<'r> {
    random: &'r mut Random,
    ty: &'static str,
    depth: usize,
    /// True if `m` is there.
    middle: bool,
}

impl Writer<'_> {
    fn program(&mut self, name: &str) -> String {
        let ty = self.ty;
        let mut text = format!(
            "#[function]\npub fn {name}(a: {ty}, b: {ty}, c: {ty}, seen: &mut {ty}) -> {ty} {{\n\
             let mut p = Pair_{ty} {{ low: a, high: b }};\nlet mut k = c;\nlet mut x = 1.0_f64;\n\
             let mut table = [0_u8; 4];\nlet mut list: List<{ty}, 8> = List::new();\n\
             list.push(a);\nlist.push(b);\nlist.push(c);\n"
        );
        let (condition, low, high) = self.condition();
        let count = 1 + self.below(3);
        let mut body = self.block(count, (&low, &high));
        if !self.random.one_in(20) {
            let progress = self.progress(&low, &high);
            // At the end or at the start, or within a branch that may leave it out.
            match self.below(6) {
                0 => body = progress + &body,
                1 => {
                    let other = self.progress(&low, &high);
                    let condition = self.simple();
                    body += &format!("if {condition} {{ {progress} }} else {{ {other} }}\n");
                }
                _ => body += &progress,
            }
        }
        let whole = if condition.starts_with("let ") { 4 } else { self.below(5) };
        match whole {
            0 => {
                let _ = write!(text, "'outer: loop {{\nif !({condition}) {{ break; }}\n{body}}}\n");
            }
            1 => {
                let count = self.below(3);
                let rest = self.block(count, (&low, &high));
                let _ = writeln!(
                    text,
                    "'outer: loop {{\n{body}if !({condition}) {{ break; }}\n{rest}}}"
                );
            }
            _ => {
                let _ = write!(text, "'outer: while {condition} {{\n{body}}}\n");
            }
        }
        text + "*seen = p.high;\nif x > 1.0 { k } else { p.low }\n}\n"
    }

    fn below(&mut self, n: usize) -> usize {
        self.random.below(n)
    }

    fn name(&mut self) -> &'static str {
        self.random.of(&NAMES)
    }

    /// A condition, and what it says is low and high.
    fn condition(&mut self) -> (String, String, String) {
        let (low, high) = match self.below(7) {
            6 => ("0".into(), "list.len()".into()),
            0 => ("p.low".into(), self.below(100).to_string()),
            1 => (self.below(3).to_string(), "p.high".into()),
            2 => ("k".into(), "p.high".into()),
            3 => ("(*seen)".into(), "p.high".into()),
            _ => ("p.low".to_owned(), "p.high".to_owned()),
        };
        let mut text = match self.below(6) {
            0 => format!("{low} <= {high}"),
            1 => format!("{high} > {low}"),
            2 => format!("!({low} >= {high})"),
            3 if high.contains('.') => format!("{high} != 0"),
            _ => format!("{low} < {high}"),
        };
        if high == "list.len()" {
            text = match self.below(3) {
                0 => "!list.is_empty()".into(),
                1 => "let Some(y) = list.pop()".into(),
                _ => "list.len() > 0".into(),
            };
        } else if self.random.one_in(2) {
            let more = self.more();
            text = match self.below(3) {
                0 => format!("{more} && {text}"),
                1 => format!("!(!({text}) || !({more}))"),
                _ => format!("{text} && {more}"),
            };
        }
        (text, low, high)
    }

    /// Another part of a condition, which may do something.
    fn more(&mut self) -> String {
        let (ty, name) = (self.ty, self.name());
        match self.below(7) {
            0 => format!("up_{ty}(&mut {name})"),
            1 => format!("down_{ty}(&mut {name})"),
            2 => format!("next_{ty}(&mut {name}) < 100"),
            3 => "x < 1.0e9".into(),
            4 => format!("table[place_{ty}(&mut {name})] < 3"),
            _ => self.simple(),
        }
    }

    fn simple(&mut self) -> String {
        let (ty, name) = (self.ty, self.name());
        match self.below(4) {
            0 => format!("even_{ty}(&{name})"),
            1 => format!("{name} % 3 == 1"),
            2 => "x < 64.0".into(),
            _ => format!("{name} < {}", self.below(100)),
        }
    }

    /// Returns the statement that advances most loops.
    fn progress(&mut self, low: &str, high: &str) -> String {
        if high == "list.len()" {
            let all = [
                "list.pop();",
                "k = list.pop().unwrap_or(0);",
                "list.truncate(1);",
                "list.clear();",
            ];
            return format!(
                "{}\n",
                if self.random.one_in(2) { all[0] } else { self.random.of(&all) }
            );
        }
        let (mut ups, mut downs) = (Vec::new(), Vec::new());
        if low.contains(char::is_alphabetic) {
            ups.extend([
                format!("{low} += 1;"),
                format!("{low} += 2;"),
                format!("{low} = {low}.max({high}) + 1;"),
                format!("let t = {low} + 1; {low} = t;"),
                format!("{low} = ({low} + {high}) / 2 + 1;"),
                format!("{low} = {low} + ({high} - {low}) / 2 + 1;"),
                format!("{low} = {low} * 2;"),
                format!("{low} = {low} * 3 + 1;"),
                format!("{low} = {low}.wrapping_add(1);"),
                format!("{low} = {low}.saturating_add(1);"),
            ]);
        }
        if high.contains(char::is_alphabetic) {
            downs.extend([
                format!("{high} -= 1;"),
                format!("{high} /= 2;"),
                format!("{high} >>= 1;"),
                format!("{high} &= {high} - 1;"),
                format!("let r = k % {high}; k = {high}; {high} = r;"),
                format!("{high} = ({low} + {high}) / 2;"),
                format!("{high} = {high}.min({low}) - 1;"),
                format!("{high} = {low} + ({high} - {low}) / 2;"),
                format!("{high} = {high}.wrapping_sub(1);"),
                format!("{high} = {high}.saturating_sub(1);"),
                format!("{high} %= {high};"),
            ]);
        }
        let both = ups.len().min(downs.len()) > 0 && self.random.one_in(4);
        let up = (!ups.is_empty()).then(|| ups[self.below(ups.len())].clone());
        let down = (!downs.is_empty()).then(|| downs[self.below(downs.len())].clone());
        match (up, down) {
            (Some(up), Some(down)) if both => {
                let test = self.simple();
                format!(
                    "let m = ({low} + {high}) / 2;\nif {test} {{ {low} = m + 1; }} else {{ {high} = m; }}\n{}",
                    if self.random.one_in(3) { up + &down + "\n" } else { String::new() }
                )
            }
            (Some(up), None) => up + "\n",
            (None, Some(down)) => down + "\n",
            (Some(up), Some(down)) => {
                if self.random.one_in(2) {
                    up + "\n"
                } else {
                    down + "\n"
                }
            }
            (None, None) => String::new(),
        }
    }

    fn block(&mut self, count: usize, sides: (&str, &str)) -> String {
        let had = self.middle;
        let text = (0..count).map(|_| self.stmt(sides)).collect();
        self.middle = had;
        text
    }

    fn inner(&mut self, sides: (&str, &str)) -> String {
        self.depth += 1;
        let count = 1 + self.below(2);
        let text = self.block(count, sides);
        self.depth -= 1;
        text
    }

    fn value(&mut self) -> String {
        let (name, other) = (self.name(), self.name());
        match self.below(9) {
            0 => format!("{name} + 1"),
            1 => format!("{name} - 1"),
            2 => format!("{name}.wrapping_add({other})"),
            3 => format!("{name} / 2"),
            4 => format!("({name} + {other}) / 2"),
            5 if self.middle => "m".into(),
            6 if self.middle => "m + 1".into(),
            7 => format!("{name}.min({other})"),
            _ => name.into(),
        }
    }

    fn stmt(&mut self, sides: (&str, &str)) -> String {
        let (ty, name, other) = (self.ty, self.name(), self.name());
        // Mostly what is not compared, so that some programs are taken.
        let harmless = !self.random.one_in(12);
        let name = if harmless { "k" } else { name };
        let kind = self.below(if self.depth < 2 { 20 } else { 9 });
        let value = self.value();
        let text = match kind {
            0 => format!("{name} = {value};"),
            1 => format!("{name} += {};", self.below(3)),
            2 => "x *= 1.5;".into(),
            3 => format!("up_{ty}(&mut {name});"),
            4 => format!("table[place_{ty}(&mut {name})] = 1;"),
            5 => format!("({name}, {other}) = ({other}, {name});"),
            6 => {
                self.middle = true;
                format!("let m = {value};")
            }
            7 => format!("let lent = &mut {name}; *lent = *lent / 2;"),
            8 => format!("table[({name} % 4) as usize & 3] = 2;"),
            9 => {
                let test = self.simple();
                format!("if {test} {{ continue 'outer; }}")
            }
            10 => {
                let test = self.simple();
                format!("if {test} {{ break; }}")
            }
            11 => {
                let (test, then) = (self.simple(), self.inner(sides));
                format!("if {test} {{\n{then}}}")
            }
            12 => {
                let (test, then, otherwise) =
                    (self.simple(), self.inner(sides), self.progress(sides.0, sides.1));
                format!("if {test} {{\n{then}}} else {{\n{otherwise}}}")
            }
            13 => {
                let body = self.inner(sides);
                format!("for _ in 0..3 {{\n{body}}}")
            }
            14 => {
                let (body, test) = (self.inner(sides), self.simple());
                format!("for _ in 0..3 {{\nif {test} {{ continue 'outer; }}\n{body}}}")
            }
            15 => {
                let (one, other) = (self.inner(sides), self.progress(sides.0, sides.1));
                format!(
                    "match {name} {{\n0 => {{ {one} }}\n1..=9 => {{ {other} }}\n_ => x += 1.0,\n}}"
                )
            }
            16 => format!("reset_{ty}(&mut p);"),
            17 if self.random.one_in(3) => "if list.len() < 8 { list.push(k); }".into(),
            18 => "if list.len() > 0 { list.pop(); }".into(),
            _ => {
                let (one, go) =
                    (self.inner(sides), if self.random.one_in(2) { "continue;" } else { "" });
                format!("match k % 4 {{ 0 => {{ {one} {go} }} _ => {{}} }}")
            }
        };
        text + "\n"
    }
}
