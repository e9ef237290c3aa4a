//! Functions that choose an index, for others to use: in bounds on every path, or out of them on one.

use bessemer_tests::random::Random;

use super::{LENGTH, SHORT};

/// `NAME_best` gives an index, `NAME_spot` one in a struct, `NAME_place` perhaps one.
pub(super) fn choosers(random: &mut Random, name: &str) -> String {
    let long = name.to_uppercase();
    let mut text = format!(
        "\n#[data]\n#[derive(Clone, Copy, Debug, PartialEq)]\npub struct {long}Spot {{ pub at: usize, pub n: u8 }}\n"
    );
    let (first, ways) = (start(random), [index(random), index(random)]);
    text += &function(
        random,
        &format!("{name}_best(x: &[i32; {LENGTH}], n: i32) -> usize"),
        &format!("let mut best: usize = {first};"),
        &[format!("return {};", ways[0]), format!("best = {};", ways[1])],
        "best",
    );
    let (first, ways) = (start(random), [index(random), index(random)]);
    let (byte, n) = (random.below(5), random.of(&["n as u8", "x[0] as u8 % 4", "3", "7"]));
    text += &function(
        random,
        &format!("{name}_spot(x: &[i32; {LENGTH}], n: i32) -> {long}Spot"),
        &format!("let mut best = {long}Spot {{ at: {first}, n: {byte} }};"),
        &[
            format!("return {long}Spot {{ at: {}, n: {n} }};", ways[0]),
            format!("best.at = {};", ways[1]),
        ],
        "best",
    );
    let (first, ways) = (start(random), [index(random), index(random)]);
    let end = random.of(&["None", "Some(best)", "(best < 3).then_some(best)"]);
    text + &function(
        random,
        &format!("{name}_place(x: &[i32; {LENGTH}], n: i32) -> Option<usize>"),
        &format!("let mut best: usize = {first};"),
        &[format!("return Some({});", ways[0]), format!("best = {};", ways[1])],
        end,
    )
}

/// Returns an index before the loop.
fn start(random: &mut Random) -> usize {
    random.of(&[0, 0, 1, 3, 5, 6])
}

/// Returns an index in the loop.
fn index(random: &mut Random) -> String {
    random
        .of(&["i", "i", "i", "i", "i / 2", "i.min(3)", "(n as usize) % 6", "i + 1", "i.max(1) - 1"])
        .to_owned()
}

/// A loop over the elements between what is `before` it and its `end`, with some of the `ways` behind conditions.
fn function(random: &mut Random, head: &str, before: &str, ways: &[String], end: &str) -> String {
    let (from, to) = (random.below(2), random.of(&[SHORT, LENGTH, LENGTH, LENGTH - 1]));
    let mut body = String::new();
    for way in ways {
        if random.one_in(4) {
            continue;
        }
        let operator = random.of(&["<", ">", "=="]);
        body += &format!("        if x[i] {operator} n {{ {way} }}\n");
    }
    let late = match random.one_in(4) && end == "best" {
        true => "    if n == 3 { return best; }\n",
        false => "",
    };
    format!(
        "\n#[function]\nfn {head} {{\n    {before}\n    for i in {from}..{to} {{\n{body}    }}\n{late}    {end}\n}}\n"
    )
}
