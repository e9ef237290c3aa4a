//! The walk over the author's syntax, held against the whole of it as it is shown.

use bessemer_codegen::generate::Job;
use bessemer_ir::tree::visit::{Visit, walk_expr};
use bessemer_ir::tree::{Block, Expr};
use bessemer_tests::{root, trees};

struct Met(usize);

impl Visit for Met {
    fn expr(&mut self, expr: &Expr) {
        self.0 += 1;
        walk_expr(self, expr);
    }
}

fn met(body: &Block) -> usize {
    let mut met = Met(0);
    met.block(body);
    met.0
}

/// Checks all functions of the corpus, which has every construct.
#[test]
fn every_expression_is_met_once() {
    let package = trees::tree(&Job::new(root(), "corpus"), &trees::folders());
    let package = package.unwrap_or_else(|error| panic!("{error}")).package;
    for function in &package.functions {
        let body = &function.tree.body;
        let shown = format!("{body:?}").matches("Expr { kind: ").count();
        assert_eq!(met(body), shown, "{}", function.path);
    }
    let all: usize = package.functions.iter().map(|function| met(&function.tree.body)).sum();
    assert!(all > 50_000, "the corpus has {all} expressions");
}
