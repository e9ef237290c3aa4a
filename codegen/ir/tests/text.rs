//! The text form: what it looks like, that it reads back exactly, and that no input breaks the parser.

mod random;

use bessemer_ir::text::{parse, print};
use bessemer_ir::{Expr, ExprKind, StmtKind, Type, UnaryOp};
use proptest::prelude::*;

/// The text form in its full bloom, as the printer writes it.
const DEMO: &str = include_str!("demo.ir");

#[test]
fn demo_prints_as_it_was_read() {
    let module = parse(DEMO).unwrap_or_else(|error| panic!("demo.ir:{error}"));
    assert_eq!(print(&module), DEMO);
}

#[test]
fn hand_written_text_needs_no_spans_and_no_care() {
    let loose = "fn f(x:f64)->f64{let y:f64=x*2.0+1.0 ;// dropped\n return y.max( -0.5 );}";
    let module = parse(loose).unwrap_or_else(|error| panic!("{error}"));
    let printed = print(&module);
    assert!(printed.contains("let y: f64 = x * 2.0 + 1.0;"), "{printed}");
    assert!(printed.contains("return y.max(-0.5);"), "{printed}");
}

/// Each with the line, the column and the words of the complaint.
const BROKEN: &[(&str, u32, u32, &str)] = &[
    ("fn f() { return y; }", 1, 17, "no local or constant"),
    ("fn f() {\n  let x: f65 = 1.0;\n}", 2, 10, "no such type"),
    ("fn f() { let x: f64 = 0x10; }", 1, 27, "type does not follow"),
    ("fn f() { let x: f64 = 1.0 }", 1, 27, "expected `;`"),
    ("fn f() { let x: u8 = 300u8; }", 1, 22, "no such number"),
    ("fn f() { let x: u8 = 3f31; }", 1, 22, "no such number"),
    ("fn f() { g(1.0); }", 1, 11, "no function `g`"),
    ("fn f(x: f64, x: f64) { x.abs(); }", 1, 25, "ambiguous"),
    ("fn f(x: f64) { %0.y.abs(); }", 1, 20, "called `x`"),
    ("fn f() { let a: bool = (%1.b : bool); let %1.c: bool = true; }", 1, 25, "called `c`"),
    ("fn f() { let %7.c: bool = true; }", 1, 34, "local 0 is not declared"),
    ("fn f() { %7.c = 1.0; }", 1, 15, "stated"),
    ("fn f(x: f64) { x.wobble(); }", 1, 18, "no operation"),
    ("fn f(x: f64) { x.y; }", 1, 18, "no such field"),
    ("fn f(x: f64) { x < x < x; }", 1, 22, "do not chain"),
    ("fn f(x: f64) { check x < x else wobble; }", 1, 33, "name of a fault"),
    ("enum M { A } fn f() { let m: M = M::B; }", 1, 38, "no variant"),
    ("const C: f64 = \"x\"", 1, 16, "expected a word"),
    ("const C: f64 = [0.0 * 70000]", 1, 28, "at most"),
    ("module \"m", 1, 10, "no end"),
    ("struct S { x: f64 } §", 1, 21, "unexpected character"),
];

#[test]
fn complaints_stand_where_the_fault_is() {
    let mut wrong = String::new();
    for (text, line, column, words) in BROKEN {
        let error = parse(text).expect_err(text);
        if (error.line, error.column) != (*line, *column) || !error.message.contains(words) {
            wrong += &format!("{text}\n  {error}\n");
        }
    }
    assert!(wrong.is_empty(), "{wrong}");
}

#[test]
fn endless_nesting_is_refused() {
    let deep = 200_000;
    for (open, close) in [("(", ")"), ("-", ""), ("!", ""), ("[", "]"), ("x.min(", ")")] {
        let text = format!("fn f(x: f64) {{ {}x{}; }}", open.repeat(deep), close.repeat(deep));
        assert!(parse(&text).is_err(), "{open}");
    }
    for more in [" + x", ".abs()", " as f64", " && x"] {
        let text = format!("fn f(x: f64) {{ x{}; }}", more.repeat(deep));
        assert!(parse(&text).is_err(), "{more}");
    }
    let mixed = "(x||x&&x==x|x^x&x<<x+x*-".repeat(deep);
    assert!(parse(&format!("fn f(x: f64) {{ {mixed}")).is_err());
    assert!(parse(&format!("fn f() {}", "{ if true ".repeat(deep))).is_err());
    assert!(parse(&format!("const C: {}", "[".repeat(deep))).is_err());
}

#[test]
fn long_sums_pass() {
    let text = format!("fn f(x: f64) -> f64 {{\n  return x{};\n}}\n", " + x".repeat(400));
    let module = parse(&text).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(print(&module), format!("module \"\"\n\n{text}"));
}

/// The value that `text` represents.
fn literal(text: &str) -> Expr {
    let module = parse(&format!("fn f() {{ {text}; }}")).unwrap_or_else(|error| panic!("{error}"));
    match module.functions[0].body.0[0].kind.clone() {
        StmtKind::Expr(expr) => expr,
        other => panic!("{other:?}"),
    }
}

#[test]
fn numbers_read_back_to_the_same_bits() {
    let words = [
        0.1,
        -0.0,
        1e300,
        1e-300,
        5e-324,
        f64::MAX,
        f64::MIN_POSITIVE,
        f64::INFINITY,
        f64::NAN,
        -f64::NAN,
    ];
    for word in
        words.map(f64::to_bits).into_iter().chain([0x7ff0_0000_0000_0001, 0xffff_ffff_ffff_ffff])
    {
        let expr = Expr { kind: ExprKind::Literal(word), ty: Type::F64, span: Default::default() };
        let mut module = parse("fn f() { 1.0; }").unwrap_or_else(|error| panic!("{error}"));
        module.functions[0].body.0[0].kind = StmtKind::Expr(expr);
        assert_eq!(parse(&print(&module)), Ok(module));
    }
    assert_eq!(literal("-0.0").kind, ExprKind::Literal((-0.0f64).to_bits()));
    assert_eq!(literal("1.5f32").kind, ExprKind::Literal(u64::from(1.5f32.to_bits())));
    assert_eq!(literal("-128i8").kind, ExprKind::Literal(-128i64 as u64));
    assert_eq!(literal("7").ty, Type::USIZE);
    assert!(matches!(literal("-(1.5)").kind, ExprKind::Unary(UnaryOp::Neg, _)));
    assert!(matches!(literal("1.0 - 1.5").kind, ExprKind::Binary(..)));
}

/// Damage to a text: bytes replaced, taken out, doubled, or swapped for tokens that mean something.
fn damage(text: &str, cuts: &[(usize, u8, usize)]) -> String {
    const TOKENS: [&str; 16] = [
        "{",
        "}",
        "(",
        ")",
        "@1:2:3",
        "%3.x",
        "struct#0.S",
        ": f64",
        "0x7",
        "\"",
        "//\"",
        "1e",
        ";",
        "..",
        "99999999999",
        "as ",
    ];
    let mut chars: Vec<char> = text.chars().collect();
    for &(at, how, other) in cuts {
        let (at, other) = (at % chars.len().max(1), other % chars.len().max(1));
        match how % 5 {
            0 if !chars.is_empty() => drop(chars.remove(at)),
            1 => chars.splice(at..at, TOKENS[other % TOKENS.len()].chars()).for_each(drop),
            2 if !chars.is_empty() => chars.swap(at, other),
            3 => {
                let piece: Vec<char> = chars[at.min(other)..at.max(other)].to_vec();
                chars.splice(at..at, piece.into_iter().take(200)).for_each(drop);
            }
            _ if !chars.is_empty() => drop(chars.drain(at.min(other)..at.max(other).min(at + 20))),
            _ => {}
        }
    }
    chars.into_iter().collect()
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 400, failure_persistence: None, ..ProptestConfig::default() })]

    /// Everything survives: ill-typed nodes, handles out of range, hostile names, spans, comments.
    #[test]
    fn any_module_reads_back(bytes in prop::collection::vec(any::<u8>(), 0..3000)) {
        let module = random::module(&bytes);
        let text = print(&module);
        match parse(&text) {
            Ok(back) => prop_assert!(back == module, "{text}\n{}", print(&back)),
            Err(error) => prop_assert!(false, "{error}\n{text}"),
        }
    }

    /// The parser returns; what it accepts prints and reads back.
    #[test]
    fn damaged_text_is_refused_or_read(
        bytes in prop::collection::vec(any::<u8>(), 0..1500),
        demo in any::<bool>(),
        cuts in prop::collection::vec((any::<usize>(), any::<u8>(), any::<usize>()), 1..6),
    ) {
        let text = if demo { DEMO.to_string() } else { print(&random::module(&bytes)) };
        if let Ok(module) = parse(&damage(&text, &cuts)) {
            prop_assert_eq!(parse(&print(&module)), Ok(module));
        }
    }

    #[test]
    fn noise_is_refused(text in "\\PC{0,200}") {
        let _ = parse(&text);
    }
}
