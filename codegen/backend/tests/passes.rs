//! The passes on small modules: before and after side by side, and what is refused.

use bessemer_backend::passes::{
    Choices, Error, Report, Rule, check, explicit, explicit_with, fallible,
};
use bessemer_backend::validate::validate;
use bessemer_ir::text::{parse, print};
use bessemer_ir::{Fault, Module};

fn module(text: &str) -> Module {
    let module = parse(text).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(validate(&module), Ok(()));
    module
}

fn passed(text: &str) -> (Module, Report) {
    let (after, report) = explicit(module(text)).expect("explicit");
    assert_eq!(validate(&after), Ok(()));
    assert_eq!(check(&after), []);
    (after, report)
}

/// The text form without places.
fn bare(module: &Module) -> String {
    let text = print(module);
    let mut bare = String::new();
    let mut chars = text.chars().peekable();
    while let Some(c) = chars.next() {
        if c == '@' {
            while chars.peek().is_some_and(|c| c.is_ascii_digit() || *c == ':') {
                chars.next();
            }
        } else {
            bare.push(c);
        }
    }
    bare
}

fn snapshot(name: &str, text: &str) {
    let (after, report) = passed(text);
    let mut left = String::new();
    for (function, checks) in after.functions.iter().zip(&report.functions) {
        for check in checks {
            left += &format!("{}: {:?}: {}\n", function.name, check.fault, check.reason);
        }
    }
    let all = format!("{}\n--- checks left ---\n{left}", bare(&after));
    insta::with_settings!({ snapshot_path => "passes", prepend_module_to_snapshot => false }, {
        insta::assert_snapshot!(name, all);
    });
}

macro_rules! cases {
    ($($name:ident),* $(,)?) => {$(
        #[test]
        fn $name() {
            snapshot(stringify!($name), include_str!(concat!("passes/", stringify!($name), ".ir")));
        }
    )*};
}

cases!(
    aggregates,
    arithmetic,
    below,
    clamps,
    decided,
    indices,
    loops,
    order,
    put_back,
    short_circuit
);

#[test]
fn explicit_code_comes_out_as_it_went_in() {
    let before = module(include_str!("passes/already_explicit.ir"));
    let (after, report) = explicit(before.clone()).expect("explicit");
    assert_eq!(bare(&before), bare(&after));
    assert_eq!(report.functions, [vec![]]);
    assert_eq!(fallible(&after), [false]);
}

#[test]
fn tiled_loops_come_out_as_they_went_in() {
    let (once, _) = passed(include_str!("c/tiles.ir"));
    assert!(print(&once).contains("tile"), "no loop is tiled");
    let (twice, _) = explicit(once.clone()).expect("explicit");
    assert_eq!(bare(&once), bare(&twice));
}

#[test]
fn no_loop_is_tiled_without_the_choice() {
    let plain = Choices { tiles: false, ..Choices::default() };
    let (after, _) = explicit_with(module(include_str!("c/tiles.ir")), plain).expect("explicit");
    let is_tile = |name: &str| ["tile", "part"].contains(&name);
    let mut locals = after.functions.iter().flat_map(|function| &function.locals);
    assert!(!locals.any(|local| is_tile(&local.name)), "{}", bare(&after));
}

#[test]
fn a_broken_claim_names_each_check() {
    let text = "module demo

fn pick in demo(table: &[u8; 4], i: usize) -> u8 as value {
  return load(table[i]);
}

entry infallible fn start in demo(table: &[u8; 4], i: usize, n: u8) -> u8 as value {
  let first: u8 = pick(&table, i);
  return first / n;
}
";
    let errors = explicit(module(text)).expect_err("two checks are left");
    let told: Vec<_> = errors.iter().map(ToString::to_string).collect();
    assert_eq!(
        told,
        [
            "`start` is not infallible: in `pick`, Index: index usize of 4 elements",
            "`start` is not infallible: in `start`, DivisionByZero: the divisor u8 may be 0",
        ]
    );
    let Error::Fallible { check, .. } = &errors[0] else { panic!("{errors:?}") };
    assert_eq!((check.fault, check.span.line), (Fault::Index, 0));
}

#[test]
fn what_is_proved_keeps_the_claim() {
    let text = "module demo

entry infallible fn start in demo(table: &[u8; 4], i: usize) -> u8 as value {
  if i >= 4 {
    return 0u8;
  }
  return load(table[i]);
}
";
    let (after, _) = passed(text);
    assert_eq!(fallible(&after), [false]);
}

#[test]
fn faults_reach_the_callers() {
    let (after, _) = passed(include_str!("passes/order.ir"));
    assert_eq!(fallible(&after), [false, true, false, true]);
}

#[test]
fn the_checker_names_the_rule() {
    let rules = |text: &str| check(&module(text)).into_iter().map(|p| p.rule).collect::<Vec<_>>();
    let body = |body: &str| {
        format!(
            "module demo

fn f in demo(x: &mut u8) -> u8 as value {{
  return x;
}}

fn g in demo(m: &mut matrix<f64, 2, 2>, t: &[u8; 4], i: usize, n: u8) {{
{body}
}}
"
        )
    };
    assert_eq!(rules(&body("  let x: u8 = load(t[i]);")), [Rule::Unchecked]);
    assert_eq!(rules(&body("  check i < 4 else index;\n  let x: u8 = load(t[i]);")), []);
    assert_eq!(rules(&body("  check n + 1u8 > 0u8 else overflow;")), [Rule::Unchecked]);
    // A condition is no reason to believe what is asked in it.
    let early = "  check load(t[i]) <= 254u8 else overflow;\n  check i < 4 else index;";
    let used = "  let x: u8 = load(t[i]) + 1u8;";
    assert_eq!(rules(&body(&format!("{early}\n{used}"))), [Rule::Unchecked]);
    assert_eq!(rules(&body("  let x: u8 = f(&mut n) & 1u8;")), [Rule::Call]);
    assert_eq!(rules(&body("  let x: u8 = f(&mut n);")), []);
    assert_eq!(rules(&body("  m = m.product(m);")), [Rule::Overlap]);
    assert_eq!(rules(&body("  let x: f64 = m.neg().norm();")), [Rule::Aggregate]);
    assert_eq!(rules(&body("  for k: u8 in 0u8..n {\n    n = 3u8;\n  }")), [Rule::Bounds]);
}
