//! Random bodies whose operands, indices and closures write what is beside them: small, and many of them.
//!
//! The grammar is data (`grammar.txt`; of references and patterns, `referring.txt`; of iterators with a
//! name, `iterating.txt`; of types with operators of their own, and lists, `owning.txt`; of numbers, `numbers.txt`; of chains and of
//! what calls give, `chains.txt`; of items, loops and texts, `functions.txt`; of nalgebra, `linear.txt`), and so are the items that
//! bodies call. A loan is kept as long as the production lasts that makes it, so that rustc takes what comes out; what it
//! refuses all the same is counted.

use std::collections::BTreeMap;
use std::sync::LazyLock;

use bessemer_tests::random::Random;

use super::writer::{Entry, Program};

/// Functions that every body may call.
pub const GIVEN: &str = include_str!("given.txt");
const GRAMMAR: &str = concat!(
    include_str!("grammar.txt"),
    include_str!("referring.txt"),
    include_str!("iterating.txt"),
    include_str!("owning.txt"),
    include_str!("numbers.txt"),
    include_str!("chains.txt"),
    include_str!("functions.txt"),
    include_str!("linear.txt")
);

/// The C of the external function among these, as a firmware brings it.
pub const SENSOR: [(&str, &str); 2] =
    [("beside_sensor.h", include_str!("sensor.h")), ("beside_sensor.c", include_str!("sensor.c"))];

/// Number of bodies of which one is an entry point that is claimed to have no fault.
const INFALLIBLE: usize = 6;

/// Largest nesting of parts.
const DEPTH: usize = 4;

/// The variables: the name, what it begins as, and how `t` is reported it.
const VARIABLES: [(char, &str, &str); 18] = [
    ('n', "n0 as usize % 3", "beside_tells_k(n as i16, t);"),
    ('k', "k0", "beside_tells_k(k, t);"),
    ('f', "f0", "beside_tells_f(f, t);"),
    ('a', "a0", "for x in a { beside_tells_k(x, t); }"),
    ('o', "if n0 & 1 == 0 { Some(k0) } else { None }", "beside_tells_k(o.unwrap_or(99), t);"),
    (
        's',
        "BesideTwo { a: k0 ^ 5, b: a0 }",
        "beside_tells_k(s.a, t); for x in s.b { beside_tells_k(x, t); }",
    ),
    (
        'r',
        "[BesideTwo { a: 7, b: a0 }, BesideTwo { a: a0[1], b: [k0, 2, a0[0]] }]",
        "for y in r { beside_tells_k(y.a, t); for x in y.b { beside_tells_k(x, t); } }",
    ),
    (
        'w',
        "if n0 & 2 == 0 { BesideWay::On(k0) } else { BesideWay::Both { low: 3, high: k0 } }",
        "beside_tells_w(&w, t);",
    ),
    ('p', "(a0[2], (n0 & 1) as usize)", "beside_tells_k(p.0, t); beside_tells_k(p.1 as i16, t);"),
    ('v', "Vector3::new(f0, 0.5, a0[0] as f64)", "for x in v.iter() { beside_tells_f(*x, t); }"),
    (
        'm',
        "Matrix3::new(1.0, f0, 0.5, -3.0, 0.75, 2.0, a0[0] as f64, -1.5, 4.0)",
        "for x in m.iter() { beside_tells_f(*x, t); }",
    ),
    ('e', "BesideNum(k0 ^ 3)", "beside_tells_k(e.0, t);"),
    (
        'j',
        "BesideRow { of: [BesideNum(k0), BesideNum(a0[1]), BesideNum(8)], n: a0[0] }",
        "for x in j.of { beside_tells_k(x.0, t); } beside_tells_k(j.n, t);",
    ),
    (
        'l',
        "{ let mut l = List::<i16, 6>::new(); l.push(a0[0]); if n0 & 1 == 0 { l.push(k0); } l }",
        "for x in l.iter() { beside_tells_k(*x, t); }",
    ),
    // What the references refer to, which nothing writes.
    ('u', "[a0, [k0, 4, -3], [a0[2], 7, k0]]", ""),
    (
        'd',
        "(&u[0], if n0 & 1 == 0 { Some(&u[1]) } else { None }, k0)",
        "for x in d.0 { beside_tells_k(*x, t); } beside_tells_k(d.1.map_or(9, |x| x[0]) ^ d.2, t);",
    ),
    ('g', "[(&u[1], 3), (&u[2], k0)]", "for y in g { beside_tells_k(y.0[0] ^ y.1, t); }"),
    (
        'h',
        "[BesideRef { r: &u[2], o: None, k: 3 }, BesideRef { r: &u[0], o: Some(&u[1]), k: k0 }]",
        "for y in h { beside_tells_k(y.r[0] ^ y.k ^ y.o.map_or(5, |x| x[1]), t); }",
    ),
];

/// The variables that refer to parts of `u`.
const REFERRING: [char; 3] = ['d', 'g', 'h'];

/// A line of the grammar.
struct Production {
    kind: char,
    leaves: bool,
    /// Variables that its parts may not write (`false`) or mention (`true`).
    loans: Vec<(char, bool)>,
    text: &'static str,
    /// Variables that it mentions outside its parts, and writes.
    own: Vec<(char, bool)>,
    /// Set if it has no parts.
    ends: bool,
    /// Set if it goes on with another iterator.
    goes_on: bool,
}

/// The productions of each kind, read once.
static PRODUCTIONS: LazyLock<BTreeMap<char, Vec<Production>>> = LazyLock::new(|| {
    let mut all: BTreeMap<char, Vec<Production>> = BTreeMap::new();
    let lines = GRAMMAR.lines().filter(|line| !line.is_empty() && !line.starts_with('#'));
    for production in lines.map(production) {
        all.entry(production.kind).or_default().push(production);
    }
    all
});

/// The text of each production as a program has it, without its marks.
#[cfg(test)]
pub fn productions() -> impl Iterator<Item = String> {
    PRODUCTIONS.values().flatten().map(|it| it.text.replace(['$', '~'], ""))
}

fn production(line: &'static str) -> Production {
    let (kind, mut text) = line.split_once(": ").expect("a kind, and what it is");
    let leaves = text.starts_with('^');
    text = text.trim_start_matches('^');
    let mut loans = Vec::new();
    if let Some((before, rest)) = text.split_once(';')
        && let [mode @ ('&' | '!'), name] = before.chars().collect::<Vec<_>>()[..]
    {
        loans.push((name, mode == '!'));
        text = rest;
    }
    let outside: String = text.chars().filter(|it| !matches!(it, '<' | '>')).collect();
    Production {
        kind: kind.chars().next().unwrap_or('K'),
        leaves,
        loans,
        text,
        own: mentions(&outside).collect(),
        ends: !has_holes(text),
        goes_on: text.contains("<+"),
    }
}

/// Returns the variables in a text, with true for those it writes.
fn mentions(text: &str) -> impl Iterator<Item = (char, bool)> {
    let next = text.chars().skip(1);
    text.chars().zip(next).filter(|it| matches!(it.0, '$' | '~')).map(|it| (it.1, it.0 == '~'))
}

struct Body<'r> {
    random: &'r mut Random,
    /// Borrowed variables, with true for mutable borrows.
    loans: Vec<(char, bool)>,
    closures: usize,
}

impl Body<'_> {
    fn fits(&self, production: &Production) -> bool {
        let free = |(name, writes): (char, bool)| {
            !self.loans.iter().any(|(lent, whole)| *lent == name && (*whole || writes))
        };
        (self.closures == 0 || !production.leaves)
            && production.own.iter().copied().all(free)
            && production.loans.iter().all(|loan| free((loan.0, true)))
    }

    /// A text of the kind; what its closures and places hold stays lent.
    fn part(&mut self, kind: char, depth: usize) -> String {
        let all = PRODUCTIONS.get(&kind).map_or(&[][..], Vec::as_slice);
        let fit: Vec<&Production> = all.iter().filter(|it| self.fits(it)).collect();
        let short: Vec<_> = fit.iter().copied().filter(|it| it.ends || is_iterator(kind)).collect();
        let few = depth == 0 || self.random.one_in(4);
        let mut among = if few && !short.is_empty() { short } else { fit };
        // Beyond its depth an iterator begins, and does not go on.
        if is_iterator(kind) && depth == 0 {
            among.retain(|it| !it.goes_on);
        }
        if among.is_empty() {
            return "unfit".to_owned();
        }
        let &Production { text, ref loans, .. } = self.random.of(&among);
        let before = self.loans.len();
        self.loans.extend(loans);
        let (mut out, mut rest) = (String::new(), text);
        while let Some((head, hole)) = rest.split_once('<') {
            out += head;
            let Some((mode, kind, behind)) = hole_of(hole) else {
                out.push('<');
                rest = hole;
                continue;
            };
            rest = behind;
            out += &self.hole(mode, kind, depth.saturating_sub(1));
        }
        out += rest;
        // What an iterator holds it holds as long as it is iterated.
        match is_iterator(kind) {
            true => {
                self.loans.extend(mentions(&text.replace(['<', '>'], "")).filter(|it| it.0 == 't'))
            }
            false => self.loans.truncate(before),
        }
        out
    }

    fn hole(&mut self, mode: char, kind: char, depth: usize) -> String {
        let before = self.loans.len();
        self.closures += usize::from(mode == '|');
        let text = self.part(kind, depth);
        self.closures -= usize::from(mode == '|');
        match mode {
            '+' => {}
            '|' => self.loans.extend(mentions(&text)),
            _ => self.loans.truncate(before),
        }
        if matches!(mode, '&' | '!') && text.starts_with(['$', '~', '*']) {
            self.loans.extend(mentions(&text).take(1).map(|(name, _)| (name, mode == '!')));
        }
        text
    }
}

/// Iterators, and those that are iterated by explicit `next` calls.
fn is_iterator(kind: char) -> bool {
    matches!(kind, 'X' | 'G' | 'H')
}

fn has_holes(text: &str) -> bool {
    text.split('<').skip(1).any(|hole| hole_of(hole).is_some())
}

/// The mode and the kind of a hole, and what follows it.
fn hole_of(text: &str) -> Option<(char, char, &str)> {
    let (inside, behind) = text.split_once('>')?;
    match inside.chars().collect::<Vec<_>>()[..] {
        [kind] if kind.is_ascii_uppercase() => Some((' ', kind, behind)),
        [mode @ ('&' | '!' | '|' | '+'), kind] => Some((mode, kind, behind)),
        _ => None,
    }
}

/// A body of a statement or two and a value.
pub fn program(random: &mut Random, name: &str) -> Program {
    let values = [('K', "beside_tells_k"), ('K', "beside_tells_k"), ('F', "beside_tells_f")];
    of_value(random, name, &values)
}

/// Returns such a program whose value comes from explicit `next` calls of an iterator.
pub fn iterating(random: &mut Random, name: &str) -> Program {
    of_value(random, name, &[('L', "beside_tells_k")])
}

fn of_value(random: &mut Random, name: &str, values: &[(char, &str)]) -> Program {
    let mut body = Body { random, loans: Vec::new(), closures: 0 };
    let unit = body.random.one_in(INFALLIBLE).then(|| format!("{}Unit", name.to_uppercase()));
    let mut text = String::new();
    for _ in 0..body.random.below(3) {
        text += &body.part('S', DEPTH);
        text.push('\n');
    }
    let (kind, tells) = body.random.of(values);
    let value = body.part(kind, DEPTH);
    text += &format!("let z = {value};\n{tells}(z, t);\n");
    let used = |name: char| {
        mentions(&text).any(|it| it.0 == name || name == 'u' && REFERRING.contains(&it.0))
    };
    let all = VARIABLES.iter().filter(|it| used(it.0));
    let declared: String =
        all.clone().map(|it| format!("let mut {} = {};\n", it.0, it.1)).collect();
    let told: String = all.map(|it| format!("{}\n", it.2)).collect();
    let text = text.replace(['$', '~'], "");
    let params = "a0: [i16; 3], n0: u8, k0: i16, f0: f64, t: &mut u64";
    let body = format!("{declared}{text}{told}Some(*t as i64)\n");
    let text = match &unit {
        Some(unit) => format!(
            "#[component]\n#[derive(Clone, Debug, Default, PartialEq)]\npub struct {unit} {{ pub calls: u16 }}\n\
             #[component]\nimpl {unit} {{\n#[entry(infallible)]\npub fn {name}(&mut self, {params}) -> Option<i64> {{\n\
             self.calls = self.calls.wrapping_add(1);\n{body}}}\n}}\n"
        ),
        None => format!("#[function]\npub fn {name}({params}) -> Option<i64> {{\n{body}}}\n"),
    };
    let params = [("", "[i16; 3]"), ("", "u8"), ("", "i16"), ("", "f64"), ("&mut ", "u64")];
    let params = params.map(|(passing, ty)| (passing, ty.to_owned())).to_vec();
    let entry = Entry { name: name.to_owned(), params, atomic: false, stops: false };
    Program { name: name.to_owned(), text, unit, entries: vec![entry], instances: None }
}

#[test]
fn bodies_end_and_few_lack_a_part() {
    let text = |seed| program(&mut Random(seed), "body").text;
    let unfit = (0..2000).filter(|seed| text(*seed).contains("unfit")).count();
    assert!(unfit < 20, "{unfit} of 2000");
}
