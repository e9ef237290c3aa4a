//! Order of evaluation: a value that nobody can observe has no effect and no fault.

use bessemer_ir::{Expr, Module, StmtKind};

use super::super::order::is_free;
use super::module;

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

/// Returns a function that computes a value of a type.
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

/// Returns the value of the function's first declaration.
fn value(module: &Module) -> Expr {
    match &module.functions[2].body.0[0].kind {
        StmtKind::Let { value: Some(value), .. } => value.clone(),
        _ => panic!("a declaration comes first"),
    }
}

#[test]
fn a_free_value_has_no_effect_and_no_fault() {
    for (ty, text, expected) in VALUES {
        let function = function(ty, &format!("  let y: {ty} = {text};\n  return y;"));
        assert_eq!(is_free(&value(&function)), expected, "{text}");
    }
}
