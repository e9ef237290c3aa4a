//! Loops for which there is a proof, and others for which there must be none; each is run from many starts.

use bessemer_ir::text::parse;
use bessemer_ir::{FunctionId, StmtKind};

use super::{Loop, proof, turned};
use bessemer_backend::validate::validate;
use bessemer_interpret::{Interpreter, Stop};

/// Passes of a loop that is taken for endless.
const LIMIT: u64 = 20_000;

/// The body of a loop of `i`, `n` and `m`, left by the first `if`: whether it is shown to end, and does.
fn shown(body: &str) -> (bool, bool) {
    shown_of("u8", body)
}

/// The loop's numbers are `u8` or `i8`, as `ty` says: whether the loop is shown to end, and does.
fn shown_of(ty: &str, body: &str) -> (bool, bool) {
    let text = format!(
        "module demo

fn lowered in demo(x: &mut u8) -> u8 as value {{
  x = x / 2u8;
  return x;
}}

fn run in demo(i: u8, n: u8, m: u8) -> u8 as value {{
  for pass: u64 in 0u64..=18446744073709551615u64 while {{
{body}
  }}
  return i;
}}
"
    )
    .replace("u8", ty);
    let module = parse(&text).unwrap_or_else(|error| panic!("{error}\n{text}"));
    assert_eq!(validate(&module), Ok(()), "{text}");
    let StmtKind::For { body: stmts, .. } = &module.functions[1].body.0[0].kind else {
        panic!("the loop comes first")
    };
    let leaves = |stmt: &bessemer_ir::Stmt| match &stmt.kind {
        StmtKind::If { then, .. } => then.0.last().is_some_and(|it| it.kind == StmtKind::Break),
        _ => false,
    };
    let head = stmts.0.iter().position(leaves);
    let head = head.expect("it has a condition");
    let StmtKind::If { condition, .. } = &stmts.0[head].kind else { unreachable!("just found") };
    let (before, rest) = (&stmts.0[..head], &stmts.0[head + 1..]);
    let of = Loop { before, condition, truth: false, rest, lead: &[] };
    let name = |_: &bessemer_ir::Place| String::new();
    let is_shown = proof(&module, name, &of).is_ok() || turned(&module, name, &of).is_ok();
    let mut interpreter = Interpreter::new(&module);
    interpreter.limit(LIMIT);
    let words = match ty {
        "i8" => [0, 1, 2, 3, 7, 100, 127, -1, -2, -128].map(|it: i64| it as u64),
        _ => [0, 1, 2, 3, 7, 8, 100, 128, 254, 255],
    };
    let mut ends = true;
    for i in words {
        for n in words {
            for m in words {
                let mut given = vec![vec![i], vec![n], vec![m]];
                let outcome = interpreter.call(FunctionId(1), &mut given);
                ends &= outcome != Err(Stop::Limit);
            }
        }
    }
    (is_shown, ends)
}

#[track_caller]
fn ends(body: &str) {
    assert_eq!(shown(body), (true, true), "{body}");
}

#[track_caller]
fn is_endless(body: &str) {
    assert_eq!(shown(body), (false, false), "{body}");
}

/// It ends by a fault, or by luck: no proof says so.
#[track_caller]
fn is_not_shown(body: &str) {
    assert_eq!(shown(body), (false, true), "{body}");
}

#[test]
fn one_of_the_two_moves_in_every_pass() {
    ends("if i >= n { break; } i = i + 1u8;");
    ends("if i > n { break; } i = i + 2u8;");
    ends("if i >= n { break; } n = n - 1u8;");
    ends("if i >= n { break; } if i == m { n = n / 2u8; } else { i = i + 1u8; }");
    ends("if i >= n { break; } i = i + 1u8; n = n.min(m);");
    is_endless("if i >= n { break; } i = i + m;");
    is_endless("if i >= n { break; } if i == m { i = i + 1u8; }");
    is_endless("if i > n { break; } n = n / 2u8;");
    is_endless("if i >= n { break; } i = i * 2u8;");
    is_endless("if i >= n { break; } match m { 0 => { i = i + 1u8; } _ => {} }");
}

#[test]
fn what_is_compared_may_be_a_sum_with_what_moves() {
    ends("if i + 2u8 >= n { break; } i = i + 1u8;");
    ends("if i + m >= n { break; } i = i + 3u8;");
    ends("if 2u8 * i > n { break; } i = i + 1u8;");
    ends("if i * i > n { break; } i = i + 1u8;");
    ends("if i >= n - 2u8 { break; } n = n - 1u8;");
    ends("if i + m >= n { break; } m = m + 1u8;");
    is_endless("if i + 2u8 >= n { break; } i = i + m;");
    is_endless("if m * i >= n { break; } i = i + 1u8; i = i.min(7u8);");
    is_endless("if i >= n - m { break; } if n > 100u8 { n = n - 1u8; }");
}

#[test]
fn what_is_compared_may_have_a_name() {
    ends("let k: u8 = n; if i >= k { break; } i = i + 1u8;");
    ends("let k: u8 = n; if k <= 0u8 { break; } n = k - 1u8;");
    ends("let k: u8 = i; if k >= n { break; } i = k + 1u8;");
    is_endless("let k: u8 = n; n = m; if i >= k { break; } n = n - 1u8;");
    is_endless("let k: u8 = n; if i >= k { break; } n = k;");
    is_endless("let k: u8 = i; k = m; if k >= n { break; } i = i + 1u8; i = i.min(9u8);");
}

/// A part of a product may be more than it, where the other is 0.
#[test]
fn a_product_with_zero_says_nothing() {
    is_not_shown("if m * i >= n { break; } i = i + 1u8;");
}

#[test]
fn neither_moves_the_other_way() {
    is_endless("if i >= n { break; } i = i + 1u8; i = i.saturating_sub(m);");
    is_not_shown("if i >= n { break; } i = i + 1u8; n = n.wrapping_add(m);");
    is_not_shown("if i >= n { break; } i = i.wrapping_add(1u8); n = n.max(m);");
    is_endless("if i >= n { break; } i = i + 1u8; if m > 3u8 { i = m; }");
}

/// It may have no pass.
#[test]
fn a_step_in_a_loop_within_is_none() {
    is_endless("if i >= n { break; } for k: u8 in 0u8..m { i = i + 1u8; }");
    is_endless("if i >= n { break; } for k: u8 in m..3u8 { n = n - 1u8; }");
    is_endless("if i >= n { break; } for k: u8 in 0u8..m { if k == 0u8 { i = i + 1u8; } }");
    ends("if i >= n { break; } for k: u8 in 0u8..m { n = n.min(k); } i = i + 1u8;");
}

#[test]
fn what_goes_on_before_a_step_has_made_none() {
    is_endless("if i >= n { break; } if i == m { continue; } i = i + 1u8;");
    is_endless("if i == m { continue; } if i >= n { break; } i = i + 1u8;");
    ends("if i >= n { break; } i = i + 1u8; if i == m { continue; } n = n.min(m);");
}

/// The upper number is above 0 only until it is written: after that, subtracting from it may wrap.
#[test]
fn high_is_above_zero_until_it_is_written() {
    ends("if i >= n { break; } n = n.wrapping_sub(1u8);");
    is_endless("if i >= n { break; } n = n.min(m); n = n.wrapping_sub(1u8);");
    is_endless("if i >= n { break; } n = n.saturating_sub(m); n = n.wrapping_sub(1u8);");
    is_not_shown("if i >= n { break; } n = n / 2u8; n = n.wrapping_sub(1u8);");
    ends(
        "if i >= n { break; } n = n.min(m); if n > 0u8 { n = n.wrapping_sub(1u8); } else { i = i + 1u8; }",
    );
    is_endless("if i > n { break; } n = n.wrapping_sub(1u8);");
    is_endless("if i > n { break; } n = n.saturating_sub(1u8);");
}

#[test]
fn what_is_between_the_two_lies_between_them() {
    ends("if i >= n { break; } if m > i { i = (i + n) / 2u8 + 1u8; } else { n = (i + n) / 2u8; }");
    is_endless("if i >= n { break; } if m > i { i = (i + n) / 2u8; } else { n = (i + n) / 2u8; }");
    is_endless("if i >= n { break; } n = n.max(i); i = (i + n) / 2u8;");
}

#[test]
fn what_is_lent_may_be_anything() {
    is_endless("if i >= n { break; } let x: u8 = lowered(&mut i); i = i + 1u8;");
    ends("if i >= n { break; } let x: u8 = lowered(&mut m); i = i + 1u8;");
    is_endless("if i >= n { break; } let x: u8 = i + 1u8; let y: u8 = lowered(&mut x); i = x;");
    ends("if i >= n { break; } let x: u8 = i + 1u8; i = x;");
}

#[test]
fn from_one_condition_to_the_next() {
    ends("n = n.saturating_sub(2u8); if n <= 5u8 { break; } n = n - 1u8;");
    is_endless("n = n.max(m); if i >= n { break; } i = i.saturating_sub(1u8);");
}

/// A half of what is negative is more; of what was found to be more than 0, less.
#[test]
fn halves_of_signed_numbers() {
    let of_signed = |body| shown_of("i8", body);
    assert_eq!(of_signed("if n <= 0u8 { break; } n = n / 2u8;"), (true, true));
    assert_eq!(of_signed("if n <= 0u8 { break; } n = n >> 1u8;"), (true, true));
    assert_eq!(of_signed("if n <= 3u8 { break; } n = n / 2u8;"), (true, true));
    assert_eq!(of_signed("if i >= n { break; } n = n / 2u8;"), (false, false));
    assert_eq!(of_signed("if n < 0u8 { break; } n = n / 2u8;"), (false, false));
    assert_eq!(of_signed("if n <= m { break; } n = n >> 1u8;"), (false, false));
    // The other number goes up, but not as fast as a negative one that is halved.
    assert!(!of_signed("if i >= n { break; } i = i + 1u8; n = n / 2u8;").0);
    assert!(shown_of("u8", "if i >= n { break; } i = i + 1u8; n = n / 2u8;").0);
    let twice = "if n <= 0u8 { break; } n = n.wrapping_sub(100u8); n = n / 2u8; n = n.max(m);";
    assert!(!of_signed(twice).0);
}
