//! The gate: for every invariant a module that violates it and nothing else, and its name.

use std::collections::BTreeSet;

use bessemer_backend::validate::{Problem, Subject, validate};
use bessemer_ir::text::parse;
use bessemer_ir::{
    Block, Expr, ExprKind, FunctionId, LocalId, Mode, Module, Span, Step, Stmt, StmtKind, Type,
    UnaryOp,
};

/// Declarations that all bodies below may use.
const PRELUDE: &str = "
    enum M { A, B }
    struct P { x: f64, y: f64, a: [P0; 3] }
    const C: f64 = 1.0
    fn by(x: f64, y: &f64, z: &mut f64) -> f64 { z = x; return y; }
    fn take(x: f64) { }
    fn two(a: &mut f64, b: &mut f64) { }
    fn read(a: &f64, b: f64) -> f64 { return a; }
    fn bump(a: &mut f64) -> f64 { return a; }
    fn bump2(a: &mut f64, b: f64) -> f64 { return a; }
";

/// The name of a problem, then a text that has it.
const BAD: &[(&str, &str)] = &[
    ("Kernel", "fn f(a: &mut matrix<f64, 3, 3>) -> bool = kernel inverse<f64, 4> { }"),
    ("Kernel", "fn f(a: &mut matrix<f64, 3, 3>) -> bool = kernel inverse<f64, 3> { return true; }"),
    ("Kernel", "fn f(a: &matrix<f64, 3, 3>) -> f64 = kernel determinant<f64, 3, 3> { }"),
    // Definitions.
    ("UnknownStruct", "struct S { x: struct#9._ }"),
    ("UnknownStruct", "fn f(x: [struct#9._; 2]) { }"),
    ("UnknownStruct", "fn struct#9._::f() { }"),
    ("LaterStruct", "struct S { x: struct#3.T } struct T { y: f64 }"),
    ("LaterStruct", "struct S { x: [struct#2.S; 2] }"),
    ("UnknownEnum", "const K: enum#9._ = 0"),
    ("UnknownEnum", "fn f() -> enum#9._ { }"),
    ("UnknownFile", "@4:1:1 struct S { x: f64 }"),
    ("UnknownFile", "fn f(x: f64@0:1:1) { }"),
    ("UnknownFile", "fn f() { @0:1:1 return; }"),
    ("UnknownFile", "fn f() { 1.0@0:1:1; }"),
    ("EmptyType", "struct S { }"),
    ("EmptyType", "enum E { }"),
    ("EmptyType", "const K: [f64; 0] = []"),
    ("EmptyType", "fn f(m: matrix<f64, 3, 0>) { }"),
    ("EmptyType", "fn f() { splat<0>(1.0); }"),
    ("UnitValue", "struct S { x: unit }"),
    ("UnitValue", "fn f() { let x: unit; }"),
    ("UnitValue", "fn f() { [take(1.0)]; }"),
    ("TypeTooLarge", "struct S { x: [[f64; 70000]; 70000] }"),
    ("TypeTooLarge", "fn f() { splat<4000000000>(1.0); }"),
    ("TypeTooLarge", "struct S { x: [f64; 10000000] } struct T { x: S, y: S }"),
    ("DuplicateName", "struct S { x: f64, x: f64 }"),
    ("DuplicateName", "enum E { A, A }"),
    ("Form", "struct S choice(-, 1) { x: f64, y: f64 }"),
    ("Form", "struct S choice(-, 2) { x: bool, y: f64 }"),
    ("Form", "struct S choice(1) { x: bool, y: f64 }"),
    ("Form", "struct S choice(1, 1) { x: bool, y: f64 }"),
    ("Form", "struct S choice(-, 1) { x: bool, y: f64, z: f64 }"),
    ("Form", "struct S sequence { x: usize, y: f64 }"),
    (
        "OpenChoice",
        "struct S choice(-, 1) { x: bool, y: f64 } fn f(b: bool) { struct S { x: b, y: 1.0 }; }",
    ),
    ("Words", "const K: [f64; 2] = [1.0]"),
    ("Words", "const K: bool = 2"),
    ("Words", "const K: u8 = 256"),
    ("Words", "const K: i8 = 128"),
    ("Words", "const K: f32 = 1.0"),
    ("Words", "const K: M = 2"),
    ("Words", "struct S { x: f64 } = [1.0, 2.0]"),
    ("ReferenceLocal", "fn f() { var x: &f64; }"),
    // Statements.
    ("UnknownLocal", "fn f() { %7._ : f64 = 1.0; }"),
    ("UnknownLocal", "fn f() { let %7._ = 1.0; }"),
    ("UnknownLocal", "fn f() { let x: f64 = (%7._ : f64); }"),
    ("DeclaredTwice", "fn f() { let x: f64 = 1.0; let x = 2.0; }"),
    ("DeclaredTwice", "fn f(x: f64) { let x = 2.0; }"),
    ("DeclaredTwice", "fn f() { for i: u8 in 0u8..1u8 { } for i in 0u8..1u8 { } }"),
    ("NotInScope", "fn f() { var x: f64; x = 1.0; let x; }"),
    ("NotInScope", "fn f(c: bool) -> f64 { if c { let x: f64 = 1.0; } return x; }"),
    ("NotInScope", "fn f() -> u8 { for i: u8 in 0u8..1u8 { } return i; }"),
    ("NotInScope", "fn f() { for i: u8 in 0u8..i { } }"),
    ("NotAssigned", "fn f() -> f64 { let x: f64; return x; }"),
    ("NotAssigned", "fn f(c: bool) -> f64 { let x: f64; if c { x = 1.0; } return x; }"),
    (
        "NotAssigned",
        "fn f(m: M) -> f64 { let x: f64; match m { M::A => { x = 1.0; } M::B => { } } return x; }",
    ),
    (
        "NotAssigned",
        "fn f(n: u8) -> f64 { let x: f64; for i: u8 in 0u8..n { x = 1.0; } return x; }",
    ),
    ("NotAssigned", "fn f() { let p: [f64; 2]; p[0] = 1.0; }"),
    ("NotAssigned", "fn f() { let x: f64; bump(&mut x); }"),
    (
        "NotAssigned",
        "fn f(n: u8) { for i: u8 in 0u8..n { let x: u8; if i == 0u8 { x = i; } i + x; } }",
    ),
    ("WrittenReference", "fn f(x: &f64) { x = 1.0; }"),
    ("WrittenReference", "fn f(x: &[f64; 2]) { x[0] = 1.0; }"),
    ("WrittenReference", "fn f(x: &f64) { bump(&mut x); }"),
    ("WrittenCounter", "fn f() { for i: u8 in 0u8..1u8 { i = 1u8; } }"),
    ("WrittenCounter", "fn g(i: &mut u8) { } fn f() { for i: u8 in 0u8..1u8 { g(&mut i); } }"),
    ("TypeMismatch", "fn f() { let x: f64 = 1.0f32; }"),
    ("TypeMismatch", "fn f(x: f64) { x = true; }"),
    ("TypeMismatch", "fn f(x: f64) { x : f32 = 1.0f32; }"),
    ("TypeMismatch", "fn f(x: f64) -> f64 { return (x + x : f32); }"),
    ("TypeMismatch", "fn f() -> f64 { return 1.0f32; }"),
    ("TypeMismatch", "fn f(x: f64) { if (x : bool) { } }"),
    ("TypeMismatch", "fn f(x: f64) { if x { } }"),
    ("TypeMismatch", "fn f(x: f64) { check x else index; }"),
    ("TypeMismatch", "fn f(x: f64, y: f32) { x + y; }"),
    ("TypeMismatch", "fn f(x: f64, y: f32) { x < y; }"),
    ("TypeMismatch", "fn f(x: f64, y: bool) { y || (x < x) == y && x; }"),
    ("TypeMismatch", "fn f(x: f64, y: f32) { x.min(y); }"),
    ("TypeMismatch", "fn f(x: f64, y: f32) { [x, y]; }"),
    ("TypeMismatch", "fn f(y: f32) { take(y); }"),
    ("TypeMismatch", "fn f(y: f32) { bump(&mut y); }"),
    ("TypeMismatch", "fn f(y: f32) { struct P0 { v: y }; }"),
    ("TypeMismatch", "fn f() { for i: u8 in 0..1u8 { } }"),
    ("TypeMismatch", "fn f() { (C : f32); }"),
    ("MatchType", "fn f(x: f64) { match x { _ => {} } }"),
    ("MatchType", "fn f(x: bool) { match x { 0 => {} 1 => {} } }"),
    ("MatchArmEmpty", "fn f(x: u8) { match x { => {} _ => {} } }"),
    ("MatchValueOutOfRange", "fn f(x: u8) { match x { 256 => {} _ => {} } }"),
    ("MatchValueOutOfRange", "fn f(x: i8) { match x { -129 => {} _ => {} } }"),
    ("MatchValueOutOfRange", "fn f(x: M) { match x { 2 => {} _ => {} } }"),
    ("MatchValueTwice", "fn f(x: u8) { match x { 1 => {} 2, 1 => {} _ => {} } }"),
    ("MatchNotExhaustive", "fn f(x: M) { match x { M::B => {} } }"),
    ("MatchNotExhaustive", "fn f(x: u8) { match x { 1 => {} } }"),
    ("LoopType", "fn f() { for i: f64 in 0.0..1.0 { } }"),
    ("OutsideLoop", "fn f() { break; }"),
    ("OutsideLoop", "fn f() { for i: u8 in 0u8..1u8 { } if true { continue; } }"),
    ("MissingReturn", "fn f() -> f64 { }"),
    ("MissingReturn", "fn f(c: bool) -> f64 { if c { return 1.0; } }"),
    ("MissingReturn", "fn f() -> f64 { for i: u8 in 0u8..1u8 { return 1.0; } }"),
    ("MissingReturn", "fn f(m: M) -> f64 { match m { M::A => { return 1.0; } _ => {} } }"),
    ("ReturnValue", "fn f() { return 1.0; }"),
    ("ReturnValue", "fn f() -> f64 { return; }"),
    ("CallInCheck", "fn g() -> bool { return true; } fn f(x: bool) { check x || g() else index; }"),
    // Expressions.
    ("UnknownConst", "fn f() { (const#9._ : f64); }"),
    ("UnknownFunction", "fn f() { (#99._() : f64); }"),
    ("LaterFunction", "fn f() { (#6.f() : f64); }"),
    ("LaterFunction", "fn f() { (#7.g() : unit); } fn g() { }"),
    ("LiteralWord", "fn f() { (0x2 : bool); }"),
    ("LiteralWord", "fn f() { (0x100 : u8); }"),
    ("LiteralWord", "fn f() { (0x80 : i8); }"),
    ("LiteralWord", "fn f() { (0x100000000 : f32); }"),
    ("LiteralWord", "fn f() { (0x2 : M); }"),
    ("LiteralWord", "fn f() { (0x0 : [f64; 1]); }"),
    ("UnaryOperand", "fn f(x: u8) { -x; }"),
    ("UnaryOperand", "fn f(x: bool) { -x; }"),
    ("UnaryOperand", "fn f(x: f64) { !x; }"),
    ("BinaryOperand", "fn f(x: bool) { x + x; }"),
    ("BinaryOperand", "fn f(x: f64) { x & x; }"),
    ("BinaryOperand", "fn f(x: M) { x | x; }"),
    ("BinaryOperand", "fn f(x: bool) { x << 1u8; }"),
    ("BinaryOperand", "fn f(x: u8) { x << 1.0; }"),
    ("CompareOperand", "fn f(x: [f64; 2]) { x == x; }"),
    ("Cast", "fn f(x: f64) { x as bool; }"),
    ("Cast", "fn f(x: bool) { x as f64; }"),
    ("Cast", "fn f(x: M) { x as f64; }"),
    ("Cast", "fn f(x: u8) { x as bool; }"),
    ("Cast", "fn f(x: u8) { x as M; }"),
    ("Cast", "fn f(x: [f64; 1]) { x as f64; }"),
    ("IntrinsicOperand", "fn f(x: u8) { x.sqrt(); }"),
    ("IntrinsicOperand", "fn f(x: u8) { x.abs(); }"),
    ("IntrinsicOperand", "fn f(x: bool) { x.min(x); }"),
    ("IntrinsicOperand", "fn f(x: f64) { x.wrapping_add(x); }"),
    ("IntrinsicOperand", "fn f(x: u8) { (x.to_bits() : u64); }"),
    ("IntrinsicOperand", "fn f(x: i64) { (x.from_bits() : f64); }"),
    ("IntrinsicOperand", "fn f(x: matrix<f64, 1, 1>) { x.floor(); }"),
    ("OperandCount", "fn f(x: f64) { x.sqrt(x); }"),
    ("OperandCount", "fn f(x: f64) { x.min(); }"),
    ("OperandCount", "fn f(x: f64) { x.clamp(x); }"),
    ("OperandCount", "fn f() { (sqrt!() : f64); }"),
    ("OperandCount", "fn f() { (norm!() : f64); }"),
    ("OperandCount", "fn f() { take(); }"),
    ("OperandCount", "fn f(x: f64) { ([x] : [f64; 2]); }"),
    ("OperandCount", "fn f(x: f64) { matrix<2, 2>(x); }"),
    ("OperandCount", "fn f(x: f64) { (struct(x, x) : P0); }"),
    ("Parts", "fn f(x: f64) { (struct(x) : M); }"),
    ("Parts", "fn f(x: f64) { ([x] : f64); }"),
    ("Parts", "fn f(x: f64) { ([x] : matrix<f64, 1, 1>); }"),
    ("Parts", "fn f(x: f64) { (matrix(x) : [f64; 1]); }"),
    ("Shape", "fn f(a: matrix<f64, 2, 2>, b: matrix<f64, 2, 3>) { a.add(b); }"),
    ("Shape", "fn f(a: matrix<f64, 2, 2>, b: matrix<f32, 2, 2>) { a.sub(b); }"),
    ("Shape", "fn f(a: matrix<u8, 2, 2>) { a.neg(); }"),
    ("Shape", "fn f(a: matrix<f64, 2, 2>) { a.scale(a); }"),
    ("Shape", "fn f(a: matrix<f64, 2, 2>) { a.unscale(1.0f32); }"),
    ("Shape", "fn f(a: matrix<f64, 2, 2>, b: matrix<f64, 3, 2>) { a.product(b); }"),
    ("Shape", "fn f(a: matrix<f64, 2, 2>, b: matrix<f64, 3, 2>) { a.tr_mul(b); }"),
    ("Shape", "fn f(a: matrix<f64, 2, 1>) { a.cross(a); }"),
    ("Shape", "fn f(a: matrix<f64, 3, 1>, b: matrix<f64, 1, 3>) { a.cross(b); }"),
    ("Shape", "fn f(a: matrix<f64, 3, 1>, b: matrix<f64, 1, 3>) { a.dot(b); }"),
    ("Shape", "fn f(a: matrix<f64, 3, 1>, b: matrix<f64, 1, 3>) { a.component_mul(b); }"),
    ("Shape", "fn f(x: f64) { (x.norm() : f64); }"),
    ("Shape", "fn f(x: f64) { (x.transpose() : f64); }"),
    ("ArgumentMode", "fn f(x: f64, y: f64) { by(&x, &1.0, &mut y); }"),
    ("ArgumentMode", "fn f(x: f64, y: f64) { by(x, x, &y); }"),
    ("Alias", "fn f(x: f64) { two(&mut x, &mut x); }"),
    ("Alias", "fn f(x: f64) { by(1.0, &x, &mut x); }"),
    ("Alias", "fn f(p: P) { two(&mut p.a[0].v, &mut p.a[0].v); }"),
    ("Alias", "fn f(p: P, i: u8) { two(&mut p.a[0].v, &mut p.a[i].v); }"),
    ("Alias", "fn f(x: f64) { read(&x, bump(&mut x)); }"),
    ("Alias", "fn f(x: f64) { bump2(&mut x, bump(&mut x)); }"),
    (
        "Alias",
        "fn parts(a: &mut [f64], m: usize, b: &[f64], n: usize) { } fn f(a: [f64; 8]) { parts(&mut a[0usize..], 5usize, &a[4usize..], 4usize); }",
    ),
    (
        "Alias",
        "fn parts(a: &mut [f64], m: usize, b: &[f64], n: usize) { } fn f(a: [f64; 8]) { parts(&mut a[4usize..], 4usize, &a[0usize..], 5usize); }",
    ),
    (
        "Alias",
        "fn parts(a: &mut [f64], m: usize, b: &[f64], n: usize) { } fn f(a: [f64; 8], i: usize, j: usize) { parts(&mut a[0usize..], i, &a[j..], 8usize - j); }",
    ),
    (
        "Alias",
        "fn parts(a: &mut [f64], m: usize, b: &[f64], n: usize) { } fn f(a: [f64; 8], i: usize) { parts(&mut a[1usize..], i, &a[i..], 1usize); }",
    ),
    (
        "Alias",
        "fn parts(a: &mut [f64], m: usize, b: &[f64], n: usize) { } fn f(a: [f64; 8], i: usize) { parts(&mut a[i..], i, &a[i + 1usize..], 1usize); }",
    ),
    (
        "Alias",
        "fn parts(a: &mut [f64], m: usize, b: &[f64], n: usize) { } fn f(a: [[f64; 8]; 2], i: usize) { parts(&mut a[i][0usize..], 8usize, &a[1usize][0usize..], 8usize); }",
    ),
    ("Step", "fn f(x: f64) { (x[0] : f64); }"),
    ("Step", "fn f(p: P) { (p.#9 : f64); }"),
    ("Step", "fn f(a: [f64; 2]) { (a[0, 0] : f64); }"),
    ("Step", "fn f(a: [f64; 4]) { (a[1..][0] : f64); }"),
    ("IndexType", "fn f(a: [f64; 2]) { a[1.0]; }"),
    ("IndexType", "fn f(a: matrix<f64, 1, 1>) { a[0, true]; }"),
    ("Slice", "fn f(a: &[f64]) { }"),
];

fn read(text: &str) -> Module {
    let text = format!("struct P0 {{ v: f64 }} {PRELUDE} {text}");
    parse(&text).unwrap_or_else(|error| panic!("{error}\n{text}"))
}

fn name(problem: &Problem) -> String {
    let shown = format!("{problem:?}");
    shown.split(|next: char| !next.is_alphanumeric()).next().unwrap_or_default().to_string()
}

/// The names of the problems that a module has.
fn problems(module: &Module) -> Vec<String> {
    let errors = validate(module).err().unwrap_or_default();
    errors.iter().map(|error| name(&error.problem)).collect()
}

#[test]
fn every_bad_module_is_refused_by_name() {
    let mut wrong = String::new();
    for (expected, text) in BAD {
        let found = problems(&read(text));
        if found.is_empty() || found.iter().any(|found| found != expected) {
            wrong += &format!("{expected}: {text}\n  {found:?}\n");
        }
    }
    assert!(wrong.is_empty(), "{wrong}");
}

/// Bodies near the bad ones that are good.
const GOOD: &[&str] = &[
    "fn f(c: bool) -> f64 { let x: f64; if c { x = 1.0; } else { x = 2.0; } return x; }",
    "fn f(c: bool) -> f64 { let x: f64; if c { x = 1.0; } else { return 2.0; } return x; }",
    "fn f(m: M) -> f64 { match m { M::A => { return 1.0; } M::B => { return 2.0; } } }",
    "fn f(n: u8) { for i: u8 in 0u8..n { let x: u8; if i == 0u8 { continue; } else { x = i; } i + x; } }",
    "fn f(p: P) { two(&mut p.x, &mut p.y); two(&mut p.a[0].v, &mut p.a[1].v); }",
    "fn parts(a: &mut [f64], m: usize, b: &[f64], n: usize) { } fn f(a: [f64; 8]) { parts(&mut a[0usize..], 4usize, &a[4usize..], 4usize); parts(&mut a[5usize..], 3usize, &a[2usize..], 3usize); }",
    "fn parts(a: &mut [f64], m: usize, b: &[f64], n: usize) { } fn f(a: [f64; 8], i: usize) { parts(&mut a[0usize..], i, &a[i..], 8usize - i); parts(&mut a[i..], 8usize - i, &a[0usize..], i); }",
    "fn parts(a: &mut [f64], m: usize, b: &[f64], n: usize) { } fn f(a: [f64; 8], i: usize, j: usize) { parts(&mut a[0usize..], i, &a[i + j..], 8usize - i - j); parts(&mut a[i..], j, &a[j + i..], 1usize); }",
    "fn parts(a: &mut [f64], m: usize, b: &[f64], n: usize) { } fn f(a: [f64; 8], i: usize) { parts(&mut a[2usize..], i - 1usize, &a[1usize + i..], 1usize); }",
    "fn f(x: f64) { bump2(&mut x, x); read(&x, x); by(x, &(x + 1.0), &mut x); }",
    "fn f(x: f64) -> f64 { x = bump(&mut x); return x + bump(&mut x); }",
    "fn f(x: u8) { match x { 255 => {} _ => {} } }",
    "fn f(x: [f64; 2]) { x[0] = 1.0; x[1] = C; }",
    "fn f(c: bool) { if c { let x: f64 = 1.0; x; } else { let y: f64 = 2.0; y; } }",
    "fn f() { take(1.0); return; }",
    "fn f(m: matrix<i8, 2, 3>) -> matrix<i8, 3, 2> { return m.transpose(); }",
    "fn f() -> f64 { let x: f64; return 1.0; x; }",
    "fn f(a: &mut matrix<f64, 3, 3>) -> bool = kernel inverse<f64, 3> { }",
    "private fn P::f(self: &mut P) { self.a[2] = struct P0 { v: 0.0 }; }",
];

#[test]
fn good_modules_pass() {
    for text in GOOD {
        assert_eq!(validate(&read(text)), Ok(()), "{text}");
    }
}

#[test]
fn errors_say_where() {
    let module = read("file \"a.rs\"").functions.len() as u32;
    let mut bad = read("fn f(x: u8) { return; } @7:4 fn g(x: u8) { @8:2 let y: f64 = x@13; }");
    bad.files.push("a.rs".into());
    let errors = validate(&bad).err().unwrap_or_default();
    assert_eq!(errors.len(), 1);
    assert_eq!(errors[0].subject, Subject::Function(FunctionId(module + 1)));
    assert_eq!(errors[0].span, Span { file: 0, line: 8, column: 13 });
}

#[test]
fn all_errors_come_at_once() {
    let module = read("fn f(x: u8) { -x; break; } fn g() -> f64 { }");
    assert_eq!(problems(&module), ["UnaryOperand", "OutsideLoop", "MissingReturn"]);
}

fn literal() -> Expr {
    Expr { kind: ExprKind::Literal(0), ty: Type::F64, span: Span::default() }
}

fn stmt(kind: StmtKind) -> Stmt {
    Stmt { kind, span: Span::default(), comments: Vec::new() }
}

/// Checks modules that the text form cannot express.
#[test]
fn more_parameters_than_locals_are_refused() {
    let mut module = read("fn f(x: f64) { }");
    for function in &mut module.functions {
        if function.name == "f" {
            function.params = 2;
        }
    }
    assert_eq!(problems(&module), ["ParameterCount"]);
}

/// Checks that endless nesting is found before any recursive walk of the module.
#[test]
fn endless_nesting_is_refused() {
    let mut deep = literal();
    for _ in 0..5000 {
        deep = Expr { kind: ExprKind::Unary(UnaryOp::Neg, Box::new(deep)), ..literal() };
    }
    let mut blocks = Block::default();
    for _ in 0..5000 {
        let condition = Expr { kind: ExprKind::Literal(1), ty: Type::BOOL, span: Span::default() };
        blocks = Block(vec![stmt(StmtKind::If {
            condition,
            then: blocks,
            otherwise: Block::default(),
        })]);
    }
    let mut ty = Type::F64;
    for _ in 0..5000 {
        ty = Type::Array { element: Box::new(ty), len: 1 };
    }
    let mut module = read("fn f(x: f64) { }");
    let last = module.functions.len() - 1;
    for body in [Block(vec![stmt(StmtKind::Expr(deep))]), blocks] {
        module.functions[last].body = body;
        assert_eq!(problems(&module), ["NestedTooDeep"]);
    }
    module.functions[last].body = Block::default();
    module.functions[last].locals[0].ty = ty;
    assert_eq!(problems(&module), ["NestedTooDeep"]);
}

/// The list above is complete: each variant of [`Problem`] has a module.
#[test]
fn every_problem_has_a_module() {
    let source = include_str!("../src/validate/problem.rs");
    let variants: BTreeSet<&str> =
        (source.split("pub enum Problem").nth(1).unwrap_or_default().lines())
            .filter_map(|line| line.strip_prefix("    "))
            .filter(|line| line.starts_with(|first: char| first.is_ascii_uppercase()))
            .filter_map(|line| line.split(|next: char| !next.is_alphanumeric()).next())
            .collect();
    assert!(variants.len() > 40, "{variants:?}");
    let elsewhere = ["ParameterCount", "NestedTooDeep"];
    let covered: BTreeSet<&str> = BAD.iter().map(|(name, _)| *name).chain(elsewhere).collect();
    assert_eq!(variants, covered);
}

/// Damage to a good module that the text form would hide: handles beyond every table.
#[test]
fn wild_handles_are_refused() {
    let good = read(
        "fn f(p: P, x: f64) -> f64 { x = p.x; for i: u8 in 0u8..3u8 { x = p.a[i].v; } return x; }",
    );
    assert_eq!(validate(&good), Ok(()));
    let last = good.functions.len() - 1;
    let damage: [fn(&mut bessemer_ir::Function); 5] = [
        |function| function.result = Type::Struct(bessemer_ir::StructId(u32::MAX)),
        |function| function.locals[0].ty = Type::Enum(bessemer_ir::EnumId(u32::MAX)),
        |function| function.locals[2].mode = Mode::RefMut,
        |function| match &mut function.body.0[0].kind {
            StmtKind::Assign { place, .. } => place.root = LocalId(u32::MAX),
            _ => unreachable!("the first statement assigns"),
        },
        |function| match &mut function.body.0[0].kind {
            StmtKind::Assign { place, .. } => place.steps.push(Step::Field(u32::MAX)),
            _ => unreachable!("the first statement assigns"),
        },
    ];
    for harm in damage {
        let mut bad = good.clone();
        harm(&mut bad.functions[last]);
        assert!(validate(&bad).is_err());
    }
}
