//! Loops: what is known at the head of a pass, and behind the loop, holds in every execution from every start.
//!
//! The test writes down what is known as checks, at the head and behind the loop, and the interpreter runs them.

use bessemer_interpret::{Interpreter, Stop};
use bessemer_ir::text::parse;
use bessemer_ir::{
    CompareOp, Expr, ExprKind, Fault, FunctionId, Int, LocalId, Module, Scalar, Span, Stmt,
    StmtKind, Type,
};

use crate::passes::analysis::{Interval, Loop, State};
use crate::validate::validate;
use bessemer_ir::effects::{reads, writes};

const U8: Type = Type::Scalar(Scalar::Int(Int::U8));
/// `x`, `y` and `n`, which are the parameters, and the variable of the loop.
const LOCALS: [LocalId; 4] = [LocalId(0), LocalId(1), LocalId(2), LocalId(3)];
/// Initial intervals of the parameters.
const STARTS: [[Interval; 3]; 4] = [
    [within(0, 0), within(0, 2), within(0, 4)],
    [within(0, 1), within(3, 3), within(2, 3)],
    [within(1, 3), within(0, 1), within(0, 0)],
    [within(250, 255), within(0, 3), within(3, 6)],
];

const fn within(low: i128, high: i128) -> Interval {
    Interval { low, high }
}

fn module(head: &str, body: &str) -> Module {
    let text = format!(
        "module demo

fn two in demo(x: &mut u8) -> u8 as value {{
  x = 2u8;
  return x;
}}

fn run in demo(x: u8, y: u8, n: u8) {{
  for k: u8 in {head} {{
{body}
  }}
}}
"
    );
    let module = parse(&text).unwrap_or_else(|error| panic!("{error}\n{text}"));
    assert_eq!(validate(&module), Ok(()), "{text}");
    module
}

fn compare(op: CompareOp, a: Expr, b: Expr) -> Expr {
    let kind = ExprKind::Compare(op, Box::new(a), Box::new(b));
    Expr { kind, ty: Type::BOOL, span: Span::default() }
}

fn local(local: LocalId) -> Expr {
    Expr::local(local, &U8, Span::default())
}

fn literal(value: i128) -> Expr {
    Expr { kind: ExprKind::Literal(value as u64), ty: U8, span: Span::default() }
}

/// The bounds of the locals, and how they compare, as far as a state knows.
fn known(state: &State, locals: &[LocalId]) -> Vec<Stmt> {
    let mut all = Vec::new();
    for &one in locals {
        let Interval { low, high } = state.range(&local(one));
        all.push(compare(CompareOp::Ge, local(one), literal(low)));
        all.push(compare(CompareOp::Le, local(one), literal(high)));
        for &other in locals.iter().filter(|other| **other != one) {
            let ops = [CompareOp::Lt, CompareOp::Le, CompareOp::Eq, CompareOp::Ne];
            let pairs = ops.map(|op| compare(op, local(one), local(other)));
            all.extend(pairs.into_iter().filter(|pair| state.proves(pair)));
        }
    }
    let check = |condition| Stmt {
        kind: StmtKind::Check { condition, fault: Fault::LeftOut },
        span: Span::default(),
        comments: Vec::new(),
    };
    all.into_iter().map(check).collect()
}

/// The knowledge holds; gives how many starts did not fault.
fn holds(head: &str, body: &str) -> usize {
    STARTS.iter().map(|starts| holds_from(head, body, starts)).sum()
}

fn holds_from(head: &str, body: &str, starts: &[Interval; 3]) -> usize {
    let module = module(head, body);
    let StmtKind::For { variable, from, to, inclusive, ended, body: block, .. } =
        &module.functions[1].body.0[0].kind
    else {
        panic!("the loop comes first")
    };
    assert_eq!(*variable, LOCALS[3]);
    let mut state = State::new(&module);
    for (param, start) in LOCALS.iter().zip(starts) {
        state.bound(&local(*param), *start);
    }
    let (counter, written) = (local(*variable), writes(&block.0));
    // The passes keep bounds that change before the loop.
    if !ended && (reads(from, &written) || reads(to, &written)) {
        return 0;
    }
    let (counter, written, ended, inclusive) = (&counter, &written[..], *ended, *inclusive);
    let entered = Loop { counter, from, to, inclusive, ended, written, body: block };
    let behind = entered.enter(&mut state);
    let mut told = module.clone();
    let stmts = &mut told.functions[1].body.0;
    if let StmtKind::For { body, .. } = &mut stmts[0].kind {
        // What ends itself has no counter.
        let at_head = known(&state, if ended { &LOCALS[..3] } else { &LOCALS });
        body.0.splice(0..0, at_head);
    }
    stmts.extend(known(&behind, &LOCALS[..3]));
    let mut interpreter = Interpreter::new(&told);
    let mut whole = 0;
    for x in starts[0].low..=starts[0].high {
        for y in starts[1].low..=starts[1].high {
            for n in starts[2].low..=starts[2].high {
                let mut given = [x, y, n].map(|word| vec![word as u64]).to_vec();
                match interpreter.call(FunctionId(1), &mut given) {
                    Ok(_) => whole += 1,
                    Err(Stop::Fault { fault, .. }) if fault != Fault::LeftOut => {}
                    Err(stop) => panic!(
                        "{stop} from x = {x}, y = {y}, n = {n}\n{}",
                        bessemer_ir::text::print(&told)
                    ),
                }
            }
        }
    }
    whole
}

/// Counted loops, empty ones and those backwards among them.
const HEADS: [&str; 8] =
    ["0u8..n", "0u8..=n", "y..n", "y..=n", "rev 0u8..n", "rev y..=n", "1u8..4u8", "3u8..=3u8"];

#[test]
fn what_a_counted_loop_counts_holds() {
    for head in HEADS {
        let whole: usize = [
            "x = x + 1u8;",
            "x = x + 3u8; y = y + 1u8;",
            "if k == 1u8 { x = x + 2u8; } else { x = x + 5u8; }",
            "match k { 0 => { x = x + 4u8; } 2, 3 => {} _ => { x = x + 1u8; } }",
            "if x > 3u8 { break; } x = x + 2u8;",
            "if k == 2u8 { continue; } x = x + 2u8;",
            "for j: u8 in 0u8..k { x = x + 2u8; }",
            "for j: u8 in 0u8..=2u8 { x = x + 1u8; } x = x + 1u8;",
            "for j: u8 in y..=n { for i: u8 in 0u8..2u8 { x = x + 1u8; } }",
            "x = x + (y & 3u8);",
            "x = x + k;",
            "x = x + y; y = y & 1u8;",
            "y = y + x / 4u8; x = 8u8;",
            "if y < 2u8 { x = x + y; }",
            "x = x + two(&mut x);",
            "x = y + 1u8;",
            "x = x + 1u8; x = x.wrapping_sub(1u8);",
            "let z: u8 = two(&mut x); x = x + 1u8;",
            "y = n; x = x + 1u8;",
            "if x < n { y = x; }",
        ]
        .into_iter()
        .map(|body| holds(head, body))
        .sum();
        assert!(whole > 0, "{head}: every execution faults");
    }
}

/// Values that a loop assigns, also if the loop counts up, takes references, breaks or continues.
#[test]
fn what_a_counted_loop_gives_holds() {
    for head in HEADS {
        let whole: usize = [
            "x = k;",
            "if k > y { x = k; }",
            "x = y.min(3u8);",
            "if y > x { x = y; } else { y = 1u8; }",
            "x = k; y = x;",
            "y = x; x = k.wrapping_add(1u8);",
            "if k == 1u8 { x = 9u8; break; }",
            "if k == 1u8 { continue; } x = n; if x == 2u8 { break; } x = k;",
            "match k { 0 => { x = 7u8; } 2, 3 => { y = k; } _ => {} }",
            "for j: u8 in 0u8..=2u8 { if j > y { x = j; } }",
            "for j: u8 in 0u8..k { x = j; y = x + 1u8; } x = 5u8;",
            "x = k; let z: u8 = two(&mut x);",
            "let z: u8 = two(&mut x); x = k;",
            "x = x.wrapping_sub(k);",
            "x = 3u8; x = x.wrapping_mul(y);",
            "if x < n { x = n; } if n < 3u8 { y = x; }",
        ]
        .into_iter()
        .map(|body| holds(head, body))
        .sum();
        assert!(whole > 0, "{head}: every execution faults");
    }
}

/// Bounds that move: by one and by more, one and both of them, before and behind the condition.
#[test]
fn what_a_loop_that_ends_itself_keeps_holds() {
    let whole: usize = [
        "if x >= n { break; } x = x + 1u8;",
        "if x >= n { break; } x = x + 3u8;",
        "y = x; if x >= n { break; } x = x + 4u8;",
        "if x >= n || y == 1u8 { break; } x = x + 2u8;",
        "if n == 0u8 { break; } n = n - 1u8; y = n;",
        "if n == 0u8 { break; } y = n; n = n / 2u8;",
        "if n <= x { break; } if y == 0u8 { x = x + 1u8; } else { n = n - 1u8; }",
        "if x >= n { break; } x = x + 1u8; if x == 2u8 { continue; } y = x;",
        "if x >= n { break; } x = x + 1u8; for j: u8 in 0u8..x { y = j; }",
        "if x >= n { break; } x = x + 1u8; y = y.wrapping_add(2u8);",
        "if x >= n { break; } let z: u8 = two(&mut y); x = x + 1u8;",
        "if x >= n { break; } match y { 0 => { y = n; } _ => { y = 0u8; } } x = x + 1u8;",
    ]
    .into_iter()
    .map(|body| holds("0u8..255u8 while", body))
    .sum();
    assert!(whole > 0, "every execution faults");
}
