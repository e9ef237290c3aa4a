//! Tests of the detection of operations behind their checks, without any proof.

use bessemer_ir::text::parse;
use bessemer_ir::visit::{Access, Visit, walk_expr, walk_place};
use bessemer_ir::{Expr, Module, Place, Step};

use super::{Site, State, faults, needed, without};

/// All operations of a function that may fault; only arrays are indexed.
struct Sites<'m>(State<'m>, Vec<Site>);

impl Visit for Sites<'_> {
    fn expr(&mut self, expr: &Expr) {
        walk_expr(self, expr);
        if !faults::of_expr(expr, &self.0).is_empty() {
            self.1.push(Site::of_expr(expr));
        }
    }
    fn place(&mut self, place: &Place, _: Access) {
        walk_place(self, place);
        let indices = place.steps.iter().filter(|step| matches!(step, Step::Index(_)));
        self.1.extend(indices.map(|step| Site::of_step(step, place.span)));
    }
}

fn module(body: &str) -> Module {
    let text = format!(
        "module demo

fn bump in demo(i: &mut usize) -> u8 as value {{
  return 0u8;
}}

fn f in demo(t: &[u8; 4], u: &mut [u8; 4], i: usize, a: i64, b: i64) {{
{body}
}}
"
    );
    parse(&text).unwrap_or_else(|error| panic!("{error}\n{text}"))
}

/// Returns the number of operations without a check before them.
fn open(body: &str) -> usize {
    let module = module(body);
    let function = &module.functions[1];
    let mut sites = Sites(State::blind(&module), Vec::new());
    sites.block(&function.body);
    without(sites.1, &module, function).len()
}

#[test]
fn an_operation_stands_behind_its_own_check() {
    assert_eq!(open("  let x: u8 = load(t[i]);"), 1);
    assert_eq!(open("  check i < 4 else index;\n  let x: u8 = load(t[i]);"), 0);
    assert_eq!(open("  check i < 5 else index;\n  let x: u8 = load(t[i]);"), 1);
    assert_eq!(open("  let x: u8 = load(t[i]);\n  check i < 4 else index;"), 1);
    // Half of a condition is not the condition.
    let sum = "  let x: i64 = a + 1i64 - b;";
    assert_eq!(open(sum), 2);
    assert_eq!(open(&format!("  check a <= 9223372036854775806i64 else overflow;\n{sum}")), 1);
}

#[test]
fn operations_of_one_span_are_told_apart() {
    // All of these come from nowhere.
    let both = "  let x: u8 = load(t[i]);\n  let y: i64 = a / b;";
    assert_eq!(open(&format!("  check i < 4 else index;\n{both}")), 1);
}

#[test]
fn a_write_in_between_ends_a_check() {
    let used = "  let x: u8 = load(t[i]);";
    assert_eq!(open(&format!("  check i < 4 else index;\n  i = 7;\n{used}")), 1);
    assert_eq!(open(&format!("  check i < 4 else index;\n  bump(&mut i);\n{used}")), 1);
    assert_eq!(open(&format!("  check i < 4 else index;\n  a = 7i64;\n{used}")), 0);
    // The value is made, and what it lends is written, after the check.
    let lent = "  check i < 4 else index;\n  let x: u8 = bump(&mut i);\n  u[i] = x;";
    assert_eq!(open(lent), 1);
}

#[test]
fn a_check_counts_in_its_own_block() {
    let used = "  let x: u8 = load(t[i]);";
    assert_eq!(open(&format!("  if a == 0i64 {{\n  check i < 4 else index;\n  }}\n{used}")), 1);
    // In a block within, the proof sees it.
    assert_eq!(open(&format!("  check i < 4 else index;\n  if a == 0i64 {{\n{used}\n  }}")), 1);
}

#[test]
fn a_check_that_went_is_none() {
    let mut module = module("  check i < 4 else index;\n  let x: u8 = load(t[i]);");
    let bessemer_ir::StmtKind::Check { fault, .. } = &mut module.functions[1].body.0[0].kind else {
        panic!("a check");
    };
    *fault = bessemer_ir::Fault::LeftOut;
    let function = &module.functions[1];
    let mut sites = Sites(State::blind(&module), Vec::new());
    sites.block(&function.body);
    assert_eq!(without(sites.1, &module, function).len(), 1);
}

#[test]
fn what_a_check_asks_of_the_operands_cannot_fault() {
    // `a <= MAX - b`, where `b` is not below 0.
    let sum = "  let x: i64 = a + b;";
    let check = check_of(sum);
    let needs = |body: &str| needed(&module(body), &module(body).functions[1]).len();
    assert_eq!((open(&format!("{check}{sum}")), needs(&format!("{check}{sum}"))), (0, 1));
    assert_eq!((open(&check), needs(&check)), (2, 0));
}

/// The check that an operation needs, in words.
fn check_of(stmt: &str) -> String {
    let (after, _) = crate::passes::explicit(module(stmt)).expect("explicit");
    let text = bessemer_ir::text::print(&after);
    let check = text.lines().find_map(|line| line.find("check ").map(|at| &line[at..]));
    format!("  {}\n", check.expect("a check"))
}

#[test]
fn operands_of_what_is_checked_may_fault_all_the_same() {
    // The element in the condition is looked at before its own check.
    let early = "  check load(t[i]) <= 254u8 else overflow;\n  check i < 4 else index;\n";
    assert_eq!(open(&format!("{early}  let x: u8 = load(t[i]) + 1u8;")), 1);
    let late = "  check i < 4 else index;\n  check load(t[i]) <= 254u8 else overflow;\n";
    assert_eq!(open(&format!("{late}  let x: u8 = load(t[i]) + 1u8;")), 0);
    let one = |first: &str, second: &str| format!("  check {first};\n  check {second};\n");
    let (inner, outer) = (
        "a <= 9223372036854775806i64 else overflow",
        "a + 1i64 <= 9223372036854775806i64 else overflow",
    );
    let used = "  let x: i64 = a + 1i64 + 1i64;";
    assert_eq!(open(&format!("{}{used}", one(inner, outer))), 0);
    assert_eq!(open(&format!("{}{used}", one(outer, inner))), 1);
}
