//! Attacks on the proofs that loops end. Random `while` and `loop` programs that `typify` accepts run with adversarial
//! inputs, with the proved bound and without any. Both runs must have equal results, faults and writes.
//!
//! `BESSEMER_ENDS=seeds` runs that many batches instead of one.

mod generate;

use std::collections::BTreeSet;

use bessemer_codegen::compile::{self, Options};
use bessemer_frontend::diagnostic;
use bessemer_frontend::source::Sources;
use bessemer_interpret::{Interpreter, Stop};
use bessemer_ir::visit::{VisitMut, walk_stmt_mut};
use bessemer_ir::{Expr, ExprKind, FunctionId, Int, LocalId, Module, Scalar, Stmt, StmtKind, Type};
use bessemer_tests::random::Random;
use bessemer_tests::workspace::Workspace;

use generate::Batch;

/// Programs in a batch.
const PROGRAMS: usize = 240;
/// Inputs for each of them.
const INPUTS: usize = 48;
/// Statements after which a call is given up: more than any bound of eight bits takes.
const LIMIT: u64 = 400_000;

/// Takes the bound off every loop that ends by itself.
struct Unbounded(Vec<LocalId>);

impl VisitMut for Unbounded {
    fn stmt(&mut self, stmt: &mut Stmt) {
        if let StmtKind::For { variable, from, to, ended: true, .. } = &mut stmt.kind {
            let ty = Type::Scalar(Scalar::Int(Int::U64));
            let bound = |word, span| Expr { kind: ExprKind::Literal(word), ty: ty.clone(), span };
            (*from, *to) = (bound(0, from.span), bound(u64::MAX, to.span));
            self.0.push(*variable);
        }
        walk_stmt_mut(self, stmt);
    }
}

fn unbounded(module: &Module) -> Module {
    let mut module = module.clone();
    for function in &mut module.functions {
        let mut loops = Unbounded(Vec::new());
        loops.block(&mut function.body);
        for local in loops.0 {
            function.locals[local.index()].ty = Type::Scalar(Scalar::Int(Int::U64));
        }
    }
    module
}

/// Outcome of a call: its result or its fault, and the written values.
type Outcome = (Result<Vec<u64>, Option<bessemer_ir::Fault>>, Vec<Vec<u64>>);

fn outcome(module: &Module, function: FunctionId, arguments: &[Vec<u64>]) -> Outcome {
    let mut arguments = arguments.to_vec();
    let mut interpreter = Interpreter::new(module);
    interpreter.limit(LIMIT);
    let result = interpreter.call(function, &mut arguments).map_err(|stop| match stop {
        Stop::Fault { fault, .. } => Some(fault),
        Stop::Limit => None,
        other => panic!("{other}"),
    });
    (result, arguments)
}

/// Returns the number of accepted programs in a batch, and the errors in them.
fn attack(workspace: &Workspace, seed: u64) -> (usize, Vec<String>) {
    let mut random = Random(seed);
    let batch = Batch::new(&mut random, PROGRAMS);
    workspace.set_source(&batch.text).expect("a source file");
    let sources = Sources::new(workspace.path(""));
    let tree = workspace.tree().unwrap_or_else(|error| panic!("seed {seed}: {error}"));
    let mut package = tree.package;
    let compiled = match compile::compile(&package, &sources, &Options::default()) {
        Ok(compiled) => compiled,
        Err(errors) => {
            let other: Vec<_> = errors
                .iter()
                .filter(|it| !it.message.contains("no known bound"))
                .cloned()
                .collect();
            assert!(other.is_empty(), "{}", diagnostic::render(&other, &sources, false));
            let refused: BTreeSet<String> =
                errors.iter().map(|error| batch.program_at(error.line)).collect();
            package.functions.retain(|function| !refused.contains(&function.tree.name));
            compile::compile(&package, &sources, &Options::default())
                .unwrap_or_else(|errors| panic!("{}", diagnostic::render(&errors, &sources, false)))
        }
    };
    let proved = compiled.module;
    let free = unbounded(&proved);
    let (mut taken, mut wrong) = (0, Vec::new());
    for (index, function) in proved.functions.iter().enumerate() {
        let Some(program) = batch.programs.iter().find(|it| it.name == function.name) else {
            continue;
        };
        taken += 1;
        let id = FunctionId(index as u32);
        for _ in 0..INPUTS {
            let arguments = program.arguments(&mut random);
            let (bound, unbound) =
                (outcome(&proved, id, &arguments), outcome(&free, id, &arguments));
            if bound != unbound {
                wrong.push(format!(
                    "{}\n{arguments:?}: {bound:?} within the bound, {unbound:?} without",
                    program.text
                ));
                break;
            }
        }
    }
    (taken, wrong)
}

#[test]
fn no_loop_runs_beyond_what_was_proved() {
    let seeds = std::env::var("BESSEMER_ENDS").ok().and_then(|it| it.parse().ok()).unwrap_or(1);
    let workspace = Workspace::with_source("").expect("a workspace");
    let (mut all, mut few) = (Vec::new(), Vec::new());
    for seed in 1..=seeds {
        let (taken, wrong) = attack(&workspace, seed);
        println!("seed {seed}: {taken} of {PROGRAMS} programs taken, {} wrong", wrong.len());
        all.extend(wrong);
        few.extend((taken * 8 < PROGRAMS).then_some(taken));
    }
    assert!(all.is_empty(), "{}", all.join("\n\n"));
    assert!(few.is_empty(), "only {few:?} programs were taken: nothing was attacked");
}
