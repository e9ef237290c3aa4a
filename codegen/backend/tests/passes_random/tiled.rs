//! Random modules with loops that are tiled, or narrowly are not. They have sums over the elements of arrays, and passes
//! that change the elements of the passes before. Indices meet in every way, so that some loops must stay as they are.

use std::fmt::Write as _;

use bessemer_ir::{Module, text};

use crate::generate::Random;

/// Elements of each array.
const LENGTH: usize = 64;

/// A module of sums and of carried elements.
pub fn module(seed: u64) -> Module {
    let mut random = Random::new(seed);
    let mut text = String::from("module tiled\nfile \"a.rs\"\n\n");
    for index in 0..3 {
        text +=
            &if random.chance(50) { sums(&mut random, index) } else { carried(&mut random, index) };
    }
    text::parse(&text).unwrap_or_else(|why| panic!("seed {seed}: {why}\n{text}"))
}

/// Arguments of every function: numbers whose sums depend on their order, and a few that are special.
pub fn arguments(random: &mut Random) -> Vec<Vec<u64>> {
    let number = |random: &mut Random| match random.below(60) {
        0 => f64::INFINITY,
        1 => -0.0,
        _ => random.below(2_000_001) as f64 * 1e-6 - 1.0,
    };
    (0..3).map(|_| (0..LENGTH).map(|_| number(random).to_bits()).collect()).collect()
}

fn head(index: usize) -> String {
    format!(
        "@0:{line}:1 fn f{index} in tiled(a: &[f64; {LENGTH}], b: &mut [f64; {LENGTH}], c: &mut [f64; {LENGTH}]) {{\n",
        line = index * 100 + 1,
    )
}

/// An index of two counters, mostly within the arrays.
fn index(random: &mut Random, outer: &str, inner: &str) -> String {
    match random.below(8) {
        0 => outer.to_owned(),
        1 => inner.to_owned(),
        2 | 3 => format!("{outer} + {inner}"),
        4 => format!("{} - {outer}", LENGTH - 1 - random.below(9)),
        5 => format!("{inner} + {}", random.below(9)),
        6 => format!("{outer} + {}", random.below(9)),
        _ => random.below(LENGTH).to_string(),
    }
}

fn element(random: &mut Random, names: &[&str], outer: &str, inner: &str) -> String {
    format!("{}[{}]", random.pick(names), index(random, outer, inner))
}

fn sign(random: &mut Random) -> &'static str {
    if random.chance(70) { "+" } else { "-" }
}

/// A sum for each element of an array.
fn sums(random: &mut Random, number: usize) -> String {
    let mut text = head(number);
    let passes = *random.pick(&[16, 16, 24, 32, 17]);
    let terms = *random.pick(&[4, 5, 8, 12, 16]);
    let start = *random.pick(&["0.0", "1.5"]);
    // Rarely one that is written.
    let read = if random.chance(15) { &["a", "b", "c"][..] } else { &["a", "b"][..] };
    let (one, other) = (element(random, read, "n", "k"), element(random, read, "n", "k"));
    let operation = sign(random);
    let target = match random.below(4) {
        0 => "c[n + 3]".to_owned(),
        1 => "c[40 - n]".to_owned(),
        _ => "c[n]".to_owned(),
    };
    let value = match random.below(3) {
        0 => format!("sum {} {}", sign(random), element(random, &["a", "b"], "n", "n")),
        _ => "sum".to_owned(),
    };
    let _ = write!(
        text,
        "  for n: usize in 0..{passes} {{\n    let sum: f64 = {start};\n    for k: usize in 0..{terms} {{\n      \
         sum = sum {operation} {one} * {other};\n    }}\n    {target} = {value};\n  }}\n}}\n\n",
    );
    text
}

/// Passes that change the elements of the passes before.
fn carried(random: &mut Random, number: usize) -> String {
    let mut text = head(number);
    let passes = *random.pick(&[2, 3, 4, 6, 8]);
    let elements = *random.pick(&[16, 16, 32, 17]);
    let _ =
        write!(text, "  for i: usize in 0..{passes} {{\n    for j: usize in 0..{elements} {{\n");
    text += "      let x: f64 = c[j];\n";
    let mut values = vec!["x".to_owned()];
    for count in 0..1 + random.below(3) {
        let target = match random.below(8) {
            0 => element(random, &["b", "c"], "i", "j"),
            1..4 => "b[i + 8]".to_owned(),
            _ => "b[i]".to_owned(),
        };
        let factor = match random.below(6) {
            0 => element(random, &["a", "b", "c"], "i", "j"),
            1 => "a[j]".to_owned(),
            2 => "b[i + 8]".to_owned(),
            3 => "b[i]".to_owned(),
            _ => format!("a[i + {}]", 8 * random.below(4)),
        };
        let last = random.pick(&values).clone();
        let _ = writeln!(
            text,
            "      let y{count}: f64 = {factor} * {last} {} {target};",
            sign(random)
        );
        let _ = writeln!(text, "      {target} = {};", random.pick(&values));
        values.push(format!("y{count}"));
    }
    let _ = write!(text, "      c[j] = {};\n    }}\n  }}\n}}\n\n", random.pick(&values));
    text
}
