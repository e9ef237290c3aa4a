//! Statements and conditions: a loop that runs once without the loop, and conditions that literals decide.

use bessemer_ir::{Block, Module, StmtKind};

use super::super::conditions::{decided, within};
use super::super::single_pass::single_pass;
use super::{called, module, shown, values};

/// Returns a function of `i` and `n` with a loop that it leaves at its end.
fn looped(body: &str) -> Module {
    ended(&format!("{body}\n    break;"))
}

/// Returns a function of `i` and `n` with a loop that ends as its body says.
fn ended(body: &str) -> Module {
    module(&format!(
        "fn f in demo(i: u8, n: u8) -> u8 as y {{
  for k: usize in 0..1 {{
{body}
  }}
  return i;
}}"
    ))
}

/// Returns the same function without the loop, if that can be.
fn without_loop(module: &Module) -> Option<Module> {
    let mut module = module.clone();
    let body = &mut module.functions[0].body.0;
    let StmtKind::For { body: pass, .. } = &body[0].kind else { panic!("a loop comes first") };
    let Block(stmts) = single_pass(&pass.0)?;
    body.splice(..1, stmts);
    Some(module)
}

#[test]
fn a_loop_that_runs_once_is_its_statements() {
    for body in [
        "i = n;",
        "if i < n {\n i = 1u8;\n break;\n }",
        "if i < n {\n break;\n }\n i = 2u8;",
        "if i < n {\n i = 1u8;\n break;\n }\n if n < 3u8 {\n i = 4u8;\n break;\n }\n i = 5u8;",
        "if i < n {\n i = 1u8;\n break;\n } else {\n i = 6u8;\n }\n i = i.wrapping_add(1u8);",
    ] {
        means_the_same(&looped(body), body);
    }
}

#[test]
fn each_branch_may_end_a_loop_that_runs_once() {
    for body in [
        "if i < n {\n break;\n } else {\n i = 7u8;\n break;\n }",
        "if i < n {\n i = 1u8;\n break;\n } else {\n break;\n }",
        "if i < n {\n if n < 3u8 {\n break;\n } else {\n i = 2u8;\n break;\n }\n } else {\n i = 3u8;\n break;\n }",
    ] {
        means_the_same(&ended(body), body);
    }
}

/// Compares a function with the same function without its loop.
fn means_the_same(with: &Module, body: &str) {
    let without = without_loop(with).unwrap_or_else(|| panic!("{body}: no single pass"));
    for (i, n) in [(0, 0), (0, 1), (5, 3), (3, 5), (2, 2), (255, 1)] {
        let arguments: [&[u64]; 2] = [&[i], &[n]];
        let [one, other] = [with, &without].map(|it| called(it, &arguments).ok());
        assert_eq!(one, other, "{body} of {i} and {n}");
    }
}

#[test]
fn a_loop_that_goes_on_stays_one() {
    for body in [
        "if i < n {\n continue;\n }",
        "if i < n {\n i = 1u8;\n continue;\n }\n i = 2u8;",
        "if i < n {\n if n < 9u8 {\n break;\n }\n i = 3u8;\n }",
    ] {
        assert!(without_loop(&looped(body)).is_none(), "{body}");
    }
}

#[test]
fn literals_decide_a_condition_or_leave_it() {
    for (condition, expected) in [
        ("1 < 2", Some(true)),
        ("2 <= 1", Some(false)),
        ("!(1 == 1)", Some(false)),
        ("n < 2", None),
        ("1 < 2 && n < 2", None),
        ("2 < 1 && n < 2", Some(false)),
        ("1 < 2 || n < 2", Some(true)),
        ("n < 2 && 2 < 1", None),
    ] {
        let text = format!("fn f in demo(n: usize) -> bool as y {{\n  return {condition};\n}}");
        let StmtKind::Return(Some(value)) = &module(&text).functions[0].body.0[0].kind else {
            panic!("a value is returned")
        };
        assert_eq!(decided(value), expected, "{condition}");
    }
}

#[test]
fn a_range_is_as_few_comparisons_as_it_needs() {
    let (module, values) = values("n");
    let most = i128::from(u64::MAX);
    for ((low, high), expected) in [
        ((3, 3), "n == 3"),
        ((0, most), "true"),
        ((0, 5), "n <= 5"),
        ((2, most), "n >= 2"),
        ((2, 5), "n >= 2 && n <= 5"),
    ] {
        let condition = within(&values[0], (low, high), values[0].span);
        let (text, computed) = shown(&module, &condition);
        assert_eq!(text, expected);
        for (n, computed) in super::PAIRS.iter().map(|it| i128::from(it.0)).zip(computed) {
            assert_eq!(computed, Some(u64::from(low <= n && n <= high)), "{text} of {n}");
        }
    }
}
