//! The walks: every node once, in the order of evaluation.

use bessemer_ir::text::{parse, print};
use bessemer_ir::visit::{
    Access, Visit, VisitMut, walk_block, walk_block_mut, walk_expr, walk_place,
};
use bessemer_ir::{Expr, ExprKind, LocalId, Module, Place};

const TEXT: &str = "
fn g(a: f64, b: &f64, c: &mut f64) -> f64 { return a; }
fn f(x: [f64; 20]) {
  x[1] = g(2.0, &3.0, &mut x[4]) + -5.0 * 6.0.min(9.0);
  for i: usize in 10..11 { let t: f64 = 12.0; }
  match 13 { 1 => { 14.0; } _ => { 15.0; } }
  if x[16] < 17.0 { check true else index; } else { return; }
}";

#[derive(Default)]
struct Log(Vec<String>);

impl Visit for Log {
    fn expr(&mut self, expr: &Expr) {
        if let ExprKind::Literal(word) = expr.kind {
            self.0.push(match f64::from_bits(word) {
                float if float.is_normal() => format!("{float}"),
                _ => word.to_string(),
            });
        }
        walk_expr(self, expr);
    }

    fn place(&mut self, place: &Place, access: Access) {
        walk_place(self, place);
        self.0.push(format!("{access:?}"));
    }

    fn declaration(&mut self, local: &LocalId) {
        self.0.push(format!("#{}", local.0));
    }
}

fn module() -> Module {
    parse(TEXT).unwrap_or_else(|error| panic!("{error}"))
}

#[test]
fn nodes_are_met_in_the_order_of_evaluation() {
    let mut log = Log::default();
    walk_block(&mut log, &module().functions[1].body);
    let met = log.0.join(" ");
    let order = "2 3 4 Lend -5 6 9 1 Write 10 11 #1 12 #2 13 14 15 16 Read 17 1";
    assert_eq!(met, order);
}

struct Renumber;

impl VisitMut for Renumber {
    fn place(&mut self, place: &mut Place, access: Access) {
        bessemer_ir::visit::walk_place_mut(self, place);
        if access == Access::Lend {
            place.root = LocalId(7);
        }
    }

    fn declaration(&mut self, local: &mut LocalId) {
        local.0 += 1;
    }
}

#[test]
fn nodes_are_rewritten_in_place() {
    let mut module = module();
    walk_block_mut(&mut Renumber, &mut module.functions[1].body);
    let text = print(&module);
    assert!(text.contains("&mut %7._[4]"), "{text}");
    assert!(text.contains("for t: f64 in 10..11"), "{text}");
}
