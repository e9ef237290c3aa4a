//! The places that are written: one by one for each form of the IR, and beside the account of `effects` on all programs in text.

use std::collections::BTreeSet;
use std::path::Path;

use bessemer_ir::text::parse;
use bessemer_ir::visit::Walk;
use bessemer_ir::{Function, Place, StmtKind};

use super::{Target, by_stmts, touches};
use crate::passes::proof::values::At;
use bessemer_ir::effects;

const HEAD: &str = "module demo

struct P in demo { x: u8, t: [u8; 4] }

fn bump in demo(i: &mut u8) -> u8 as value {
  return 0u8;
}

fn fill in demo(t: &mut [u8], t_len: usize) {
  return;
}
";

/// The head of the proofs' programs.
const ENUMS: &str = "module demo

enum Trim in demo { Down = -1, Level = 0, Up = 1 }
enum Kind in demo { A = 10, B = 20, C = 30 }
enum Gear in demo { First, Second, Third }
";

fn function(body: &str) -> Function {
    let head = "fn f in demo(p: &mut P, m: &mut matrix<f64, 2, 2>, i: usize, a: u8)";
    let text = format!("{HEAD}\n{head} {{\n{body}\n}}\n");
    let module = parse(&text).unwrap_or_else(|error| panic!("{error}\n{text}"));
    module.functions.into_iter().next_back().expect("there are three")
}

/// A target as a place is written; `*` is any index.
fn shown(function: &Function, target: &Target) -> String {
    let steps = target.at.iter().map(|step| match step {
        At::Field(field) => format!(".{field}"),
        At::Index(literals) => match literals.as_slice() {
            [literal] => format!("[{}]", literal.as_number().expect("a literal")),
            _ => "[*]".to_owned(),
        },
    });
    let steps: String = steps.collect();
    format!("{}{steps}", function.local(target.local).name)
}

/// The places that the statements of a body write.
fn written(body: &str) -> BTreeSet<String> {
    let function = function(body);
    by_stmts(&function.body.0).iter().map(|target| shown(&function, target)).collect()
}

#[test]
fn each_form_writes_what_it_names() {
    for (body, expected) in [
        ("let b: u8 = a;", "b"),
        ("let b: u8;", "b"),
        ("p.x = a;", "p.0"),
        ("p.t[2] = a;", "p.1[2]"),
        ("p.t[i] = a;", "p.1[*]"),
        ("p.x = p.x;", "p.0"),
        ("m[0, 1] = 0.0;", "m[*]"),
        ("let b: u8 = bump(&mut p.x);", "b p.0"),
        ("p.x = bump(&mut p.t[1]);", "p.0 p.1[1]"),
        ("p.t[bump(&mut a) as usize] = 0u8;", "a p.1[*]"),
        ("bump(&mut a);", "a"),
        ("bump(&mut p.t[bump(&mut a) as usize]);", "a p.1[*]"),
        ("fill(&mut p.t[1..], 3);", "p.1[*]"),
        ("if bump(&mut a) < 2u8 { p.x = 1u8; } else { p.t[0] = 1u8; }", "a p.0 p.1[0]"),
        ("for k: u8 in 0u8..4u8 { p.x = k; }", "k p.0"),
        ("for k: u8 in bump(&mut a)..bump(&mut p.x) { continue; }", "a k p.0"),
        (
            "match a { 1 => { p.x = 1u8; } 2 => { p.t[3] = 1u8; } _ => { a = 2u8; } }",
            "a p.0 p.1[3]",
        ),
        ("match bump(&mut a) { 1 => { return; } _ => { } }", "a"),
        ("let b: bool = a < 1u8 && bump(&mut p.x) < 1u8;", "b p.0"),
        ("let b: [u8; 2] = [a, bump(&mut p.x)];", "b p.0"),
        ("let b: matrix<f64, 2, 1> = splat<2, 1>(bump(&mut a) as f64);", "a b"),
        ("let b: u16 = bump(&mut a) as u16;", "a b"),
        ("return;", ""),
    ] {
        let expected: BTreeSet<String> = expected.split_whitespace().map(str::to_owned).collect();
        assert_eq!(written(body), expected, "{body}");
    }
}

#[test]
fn what_is_read_is_touched() {
    for (read, write, expected) in [
        ("a", "a = 1u8;", true),
        ("a", "p.x = 1u8;", false),
        ("p.x", "p.x = 1u8;", true),
        ("p.x", "p.t[0] = 1u8;", false),
        ("p.t[0]", "p.t[0] = 1u8;", true),
        ("p.t[0]", "p.t[1] = 1u8;", false),
        ("p.t[0]", "p.t[i] = 1u8;", true),
        ("p.t[i]", "p.t[0] = 1u8;", true),
        ("p.t[i]", "i = 1;", true),
        ("p.t[0]", "fill(&mut p.t[1..], 3);", true),
        ("bump(&mut a)", "a = 1u8;", true),
    ] {
        let function = function(&format!("let b: u8 = {read};\n{write}"));
        let [first, rest @ ..] = function.body.0.as_slice() else { panic!("two statements") };
        let StmtKind::Let { value: Some(value), .. } = &first.kind else {
            panic!("a value: {read}")
        };
        assert_eq!(touches(value, &by_stmts(rest)), expected, "{read} and {write}");
    }
}

/// The two accounts share no code: where they differ, one of them is wrong.
#[test]
fn two_accounts_agree() {
    let (mut statements, mut targets) = (0, 0);
    for folder in ["c", "ir", "passes", "proofs"] {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests").join(folder);
        for entry in std::fs::read_dir(folder).expect("a folder of programs").flatten() {
            if entry.path().extension().is_none_or(|it| it != "ir") {
                continue;
            }
            let text = std::fs::read_to_string(entry.path()).expect("a program");
            // Those of the proofs come without a head.
            let head = if text.contains("module ") { "" } else { ENUMS };
            let module = parse(&format!("{head}{text}"));
            let module = module.unwrap_or_else(|error| panic!("{:?}: {error}", entry.path()));
            for function in &module.functions {
                let set = |all: &[Target]| -> BTreeSet<String> {
                    all.iter().map(|target| shown(function, target)).collect()
                };
                function.body.each_stmt(|stmt| {
                    let places: Vec<Place> = effects::writes([stmt]);
                    let theirs: Vec<Target> = places.iter().map(Target::of).collect();
                    assert_eq!(set(&by_stmts([stmt])), set(&theirs), "{stmt:?}");
                    statements += 1;
                    targets += theirs.len();
                });
            }
        }
    }
    assert!(statements > 1000 && targets > 400, "{statements} statements, {targets} targets");
}
