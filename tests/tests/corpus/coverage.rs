//! The programs that run on every leg have each node of the IR on each type that it takes.
//!
//! The rows are the IR's own: an operation that is added without a program that uses it on each of its
//! types is a hole, and fails. `UPDATE_DOCS=1 cargo test -p bessemer-tests coverage::` writes
//! docs/coverage.md.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;

use bessemer_ir::text::{INTRINSICS, ROUTINES};
use bessemer_ir::visit::{self, Access, Visit};
use bessemer_ir::{
    BinaryOp, CompareOp, Expr, ExprKind, Float, Int, Intrinsic, LogicOp, Module, Place, Scalar,
    Step, Stmt, StmtKind, Type, UnaryOp,
};
use bessemer_tests::{compiled, corpus, root};

const PAGE: &str = "docs/coverage.md";

/// The type that a node is counted under: a scalar's name, or the kind of an aggregate.
type Column = &'static str;

/// Nodes by row, each with its columns.
type Cells = BTreeMap<String, BTreeSet<Column>>;

fn column(ty: &Type) -> Column {
    match ty {
        Type::Scalar(scalar) => scalar.name(),
        Type::Enum(_) => "enum",
        Type::Struct(_) => "struct",
        Type::Array { .. } => "array",
        Type::Slice(_) => "slice",
        Type::Matrix { element, .. } => element.name(),
        _ => "other",
    }
}

/// The cells that a module fills.
#[derive(Default)]
struct Filled(Cells);

impl Filled {
    fn add(&mut self, row: impl Into<String>, column: Column) {
        self.0.entry(row.into()).or_default().insert(column);
    }
}

impl Visit for Filled {
    fn stmt(&mut self, stmt: &Stmt) {
        match &stmt.kind {
            StmtKind::Let { .. } => self.add("let", "all"),
            StmtKind::Assign { .. } => self.add("assign", "all"),
            StmtKind::Expr(_) => self.add("expression", "all"),
            StmtKind::If { .. } => self.add("if", "all"),
            StmtKind::Match { scrutinee, .. } => self.add("match", column(&scrutinee.ty)),
            StmtKind::For { from, inclusive, reversed, .. } => {
                let range = if *inclusive { "for ..=" } else { "for .." };
                let turned = if *reversed { " rev" } else { "" };
                self.add(format!("{range}{turned}"), column(&from.ty));
            }
            StmtKind::Check { .. } => self.add("check", "all"),
            StmtKind::Return(_) => self.add("return", "all"),
            StmtKind::Break => self.add("break", "all"),
            StmtKind::Continue => self.add("continue", "all"),
        }
        visit::walk_stmt(self, stmt);
    }

    fn expr(&mut self, expr: &Expr) {
        match &expr.kind {
            ExprKind::Literal(_) => self.add("literal", column(&expr.ty)),
            ExprKind::Const(_) => self.add("constant", column(&expr.ty)),
            ExprKind::Load(_) => self.add("load", column(&expr.ty)),
            ExprKind::Unary(op, x) => self.add(format!("unary {op:?}"), column(&x.ty)),
            ExprKind::Binary(op, a, _) => self.add(format!("binary {op:?}"), column(&a.ty)),
            ExprKind::Compare(op, a, _) => self.add(format!("compare {op:?}"), column(&a.ty)),
            ExprKind::Logic(op, ..) => self.add(format!("logic {op:?}"), "bool"),
            ExprKind::Cast(x) => self.add(format!("as {}", column(&expr.ty)), column(&x.ty)),
            ExprKind::Intrinsic(which, operands) => {
                if let (Some(name), Some(first)) = (name_of(INTRINSICS, *which), operands.first()) {
                    self.add(format!("intrinsic {name}"), column(&first.ty));
                }
            }
            ExprKind::Call(..) => self.add("call", "all"),
            ExprKind::Struct(_) => self.add("struct", "struct"),
            ExprKind::Array(_) => self.add("array", "array"),
            ExprKind::Splat(_) => self.add("splat", column(&expr.ty)),
            ExprKind::Matrix(_) => self.add("matrix", column(&expr.ty)),
            ExprKind::Routine(which, operands) => {
                if let (Some(name), Some(first)) = (name_of(ROUTINES, *which), operands.first()) {
                    self.add(format!("routine {name}"), column(&first.ty));
                }
            }
        }
        visit::walk_expr(self, expr);
    }

    fn place(&mut self, place: &Place, access: Access) {
        for step in &place.steps {
            match step {
                Step::Field(_) => self.add(format!("field {access:?}"), "all"),
                Step::Index(index) => {
                    self.add(format!("index {access:?}"), "all");
                    self.add("index of type", column(&index.ty));
                }
                Step::Element(..) => self.add(format!("element {access:?}"), "all"),
                Step::From(_) => self.add(format!("part {access:?}"), "all"),
            }
        }
        visit::walk_place(self, place);
    }
}

fn name_of<T: Copy + PartialEq>(names: &[(&'static str, T)], which: T) -> Option<&'static str> {
    names.iter().find(|(_, other)| *other == which).map(|(name, _)| *name)
}

/// The cells that must be filled: what the IR's typing rules allow.
fn wanted() -> Cells {
    let mut cells = Filled::default();
    let ints: Vec<Scalar> = Int::ALL.into_iter().map(Scalar::Int).collect();
    let floats = [Scalar::Float(Float::F32), Scalar::Float(Float::F64)];
    let scalars: Vec<Scalar> = ints.iter().copied().chain(floats).chain([Scalar::Bool]).collect();
    for scalar in &scalars {
        let name = scalar.name();
        let (int, float) = (matches!(scalar, Scalar::Int(_)), matches!(scalar, Scalar::Float(_)));
        let signed = matches!(scalar, Scalar::Int(int) if int.signed());
        for row in ["literal", "constant", "load"] {
            cells.add(row, name);
        }
        if signed || float {
            cells.add(format!("unary {:?}", UnaryOp::Neg), name);
        }
        if !float {
            cells.add(format!("unary {:?}", UnaryOp::Not), name);
        }
        use BinaryOp::*;
        for op in [Add, Sub, Mul, Div, Rem] {
            if int || float {
                cells.add(format!("binary {op:?}"), name);
            }
        }
        for op in [And, Or, Xor] {
            if !float {
                cells.add(format!("binary {op:?}"), name);
            }
        }
        for op in [Shl, Shr] {
            if int {
                cells.add(format!("binary {op:?}"), name);
            }
        }
        for op in [CompareOp::Eq, CompareOp::Ne] {
            cells.add(format!("compare {op:?}"), name);
        }
        for op in [CompareOp::Lt, CompareOp::Le, CompareOp::Gt, CompareOp::Ge] {
            if int || float {
                cells.add(format!("compare {op:?}"), name);
            }
        }
        for to in ints.iter().chain(&floats).filter(|to| *to != scalar) {
            if int || float || matches!(to, Scalar::Int(_)) {
                cells.add(format!("as {}", to.name()), name);
            }
        }
        for (intrinsic, which) in INTRINSICS {
            // The bits of a NaN are nobody's to see: the mathematics alone looks at them.
            if which.result(*scalar).is_some() && *which != Intrinsic::RawBits {
                cells.add(format!("intrinsic {intrinsic}"), name);
            }
        }
        if int {
            for row in ["for ..", "for .. rev", "for ..=", "for ..= rev", "match"] {
                cells.add(row, name);
            }
        }
        if float {
            for row in ["splat", "matrix"] {
                cells.add(row, name);
            }
            for (routine, _) in ROUTINES {
                cells.add(format!("routine {routine}"), name);
            }
        }
    }
    for op in [LogicOp::And, LogicOp::Or] {
        cells.add(format!("logic {op:?}"), "bool");
    }
    for (row, column) in [
        ("match", "enum"),
        ("index of type", "usize"),
        ("literal", "enum"),
        ("load", "enum"),
        ("load", "struct"),
        ("load", "array"),
        ("constant", "array"),
        ("struct", "struct"),
        ("array", "array"),
        ("splat", "array"),
        ("compare Eq", "enum"),
        ("compare Ne", "enum"),
    ] {
        cells.add(row, column);
    }
    for row in ["let", "assign", "expression", "if", "check", "return", "break", "continue", "call"]
    {
        cells.add(row, "all");
    }
    for step in ["field", "index", "element"] {
        for access in [Access::Read, Access::Write, Access::Lend] {
            cells.add(format!("{step} {access:?}"), "all");
        }
    }
    cells.0
}

fn filled(modules: &[&Module]) -> Cells {
    let mut filled = Filled::default();
    for function in modules.iter().flat_map(|module| &module.functions) {
        filled.block(&function.body);
    }
    filled.0
}

/// The page.
fn page(wanted: &Cells, filled: &Cells) -> String {
    let columns = [
        "bool", "i8", "i16", "i32", "i64", "isize", "u8", "u16", "u32", "u64", "usize", "f32",
        "f64", "enum", "struct", "array", "all",
    ];
    let mut text = String::from(
        "# Coverage\n\nEach node of the IR on each type that it takes: ● where a program of the corpus or \
         of the table of edges\nhas it, ○ for a hole (there are none: `tests/tests/corpus/coverage.rs` fails on \
         one). Every such program runs as Rust, in\nthe interpreter before and after the passes, and as \
         C: gcc and clang at -O0 and -O3, with the address and the\nundefined-behaviour sanitizer, and on \
         the emulated Cortex-A9. Matrices count under the type of their elements.\n\n",
    );
    let _ = writeln!(text, "| node | {} |", columns.join(" | "));
    let _ = writeln!(text, "|---|{}", ":-:|".repeat(columns.len()));
    for (row, cells) in wanted {
        let marks = columns.map(|column| match (cells.contains(column), filled.get(row)) {
            (false, _) => "",
            (true, Some(found)) if found.contains(column) => "●",
            _ => "○",
        });
        let _ = writeln!(text, "| {row} | {} |", marks.join(" | "));
    }
    text
}

#[test]
fn every_node_runs_on_every_type_that_it_takes() {
    let edges = compiled("edges");
    let wanted = wanted();
    // The explicit IR has the checks.
    let filled = filled(&[&corpus().module, &corpus().explicit, &edges.module]);
    let holes: Vec<String> = wanted
        .iter()
        .flat_map(|(row, columns)| {
            let none = BTreeSet::new();
            let found = filled.get(row).unwrap_or(&none);
            let missing: Vec<Column> = columns.difference(found).copied().collect();
            missing.into_iter().map(move |column| format!("{row} on {column}"))
        })
        .collect();
    assert!(holes.is_empty(), "no program has {holes:#?}");
    let current = page(&wanted, &filled);
    let path = root().join(PAGE);
    if std::env::var_os("UPDATE_DOCS").is_some() {
        std::fs::write(path, current).expect("the page can be written");
    } else {
        let page = std::fs::read_to_string(path).unwrap_or_default();
        assert!(
            page == current,
            "{PAGE} is stale: UPDATE_DOCS=1 cargo test -p bessemer-tests coverage::"
        );
    }
}
