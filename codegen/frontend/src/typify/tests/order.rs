//! Order of evaluation: a value that is said to stay the same does, for each statement behind it. The interpreter computes
//! it before that statement and behind it.

use bessemer_interpret::Stop;
use bessemer_ir::{Expr, Module, Stmt, StmtKind};

use super::super::order::{is_free, is_settled};
use super::{called, module};

/// Values of `i`, `n` (numbers), `x` (a float) and `a` (an array), each with 1 if it is free of faults and effects.
const VALUES: [(&str, &str, bool); 14] = [
    ("u8", "3u8", true),
    ("u8", "i", true),
    ("u8", "a[0]", true),
    ("u8", "a[1]", true),
    ("u8", "a[i as usize]", false),
    ("u8", "i + n", false),
    ("u8", "i.wrapping_add(n)", false),
    ("u8", "written(&mut i)", false),
    ("u8", "read(n)", false),
    ("f64", "x", true),
    ("f64", "x + 1.0", true),
    ("f64", "x.min(2.0)", true),
    ("f64", "-x", true),
    ("bool", "x < 2.0", true),
];

/// Statements that may change such a value, or end before it is computed.
const STATEMENTS: [&str; 12] = [
    "i = 9u8;",
    "n = 1u8;",
    "x = 7.5;",
    "a[0] = 5u8;",
    "a[1] = n;",
    "a[i as usize] = 1u8;",
    "i = i + n;",
    "let t: u8 = written(&mut i);",
    "let t: u8 = n / i;",
    "let t: f64 = x * 2.0;",
    "if n < i { x = 0.0; }",
    "check i < 4u8 else index;",
];

/// Starts: `i`, `n`, `x` and the elements of `a`.
const STARTS: [[u64; 5]; 4] =
    [[0, 0, 0, 1, 2], [1, 0, 1, 3, 4], [2, 255, 2, 5, 6], [200, 100, 3, 7, 8]];

/// Returns a function that computes a value of a type, with a statement behind it or before it.
fn function(ty: &str, body: &str) -> Module {
    module(&format!(
        "fn written in demo(i: &mut u8) -> u8 as y {{
  i = i.wrapping_mul(3u8);
  return i;
}}

fn read in demo(i: u8) -> u8 as y {{
  return i / 2u8;
}}

fn f in demo(i: u8, n: u8, x: f64, a: [u8; 2]) -> {ty} as y {{
{body}
}}"
    ))
}

/// Returns the value of a function's first declaration, and the statements behind it but the last.
fn parts(module: &Module) -> (Expr, Vec<Stmt>) {
    let body = &module.functions[2].body.0;
    match &body[0].kind {
        StmtKind::Let { value: Some(value), .. } => {
            (value.clone(), body[1..body.len() - 1].to_vec())
        }
        _ => panic!("a declaration comes first"),
    }
}

/// Reports if two functions give the same words and faults for each start.
fn agree(one: &Module, other: &Module) -> bool {
    STARTS.iter().all(|start| {
        let x = (start[2] as f64).to_bits();
        let arguments: [&[u64]; 4] = [&start[..1], &start[1..2], &[x], &start[3..]];
        let outcome = |module| match called(module, &arguments) {
            Err(Stop::Fault { fault, .. }) => Err(fault),
            words => Ok(words.expect("a call of a valid module")),
        };
        outcome(one) == outcome(other)
    })
}

#[test]
fn a_free_value_has_no_effect_and_no_fault() {
    for (ty, value, expected) in VALUES {
        let function = function(ty, &format!("  let y: {ty} = {value};\n  return y;"));
        assert_eq!(is_free(&parts(&function).0), expected, "{value}");
    }
}

#[test]
fn a_value_that_stays_is_the_same_behind_a_statement() {
    let (mut stay, mut differ) = (0, 0);
    for (ty, value, _) in VALUES {
        for statement in STATEMENTS {
            let before = format!("  let y: {ty} = {value};\n  {statement}\n  return y;");
            let behind = format!("  {statement}\n  let y: {ty} = {value};\n  return y;");
            let [before, behind] = [before, behind].map(|body| function(ty, &body));
            let (found, later) = parts(&before);
            let same = agree(&before, &behind);
            differ += usize::from(!same);
            if is_settled(&found, &later) {
                assert!(same, "{value} is not the same behind {statement}");
                stay += 1;
            }
        }
    }
    assert!(differ > 30, "only {differ} pairs differ: the statements prove little");
    assert!(stay > 50, "only {stay} values stay where they are");
}
