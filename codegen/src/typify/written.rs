//! What is written by statements, and which places share memory with it.

use bessemer_ir::visit::{Access, Visit, walk_place};
use bessemer_ir::{Expr, ExprKind, LocalId, Place, Stmt};

/// A place of fields alone.
pub(super) fn place(expr: &Expr) -> Option<&Place> {
    match &expr.kind {
        ExprKind::Load(place) => {
            let fields = place.steps.iter().all(|step| matches!(step, bessemer_ir::Step::Field(_)));
            fields.then_some(place)
        }
        _ => None,
    }
}

/// Whether two places are the same one; of fields alone.
pub(super) fn alike(a: &Place, b: &Place) -> bool {
    a.root == b.root && a.steps == b.steps
}

/// Whether two places may share memory.
pub(super) fn overlap(a: &Place, b: &Place) -> bool {
    use bessemer_ir::Step::Field;
    let apart = |(a, b)| matches!((a, b), (&Field(a), &Field(b)) if a != b);
    a.root == b.root && !a.steps.iter().zip(&b.steps).any(apart)
}

/// What is written.
#[derive(Default)]
pub(super) struct Writes(pub Vec<Place>);

impl Writes {
    pub(super) fn of<'s>(stmts: impl IntoIterator<Item = &'s Stmt>) -> Writes {
        let mut writes = Writes::default();
        stmts.into_iter().for_each(|stmt| writes.stmt(stmt));
        writes
    }

    pub(super) fn of_expr(expr: &Expr) -> Writes {
        let mut writes = Writes::default();
        writes.expr(expr);
        writes
    }

    /// Whether an expression reads what is written.
    pub(super) fn touch(&self, expr: &Expr) -> bool {
        struct Touched<'w>(&'w [Place], bool);
        impl Visit for Touched<'_> {
            fn place(&mut self, place: &Place, _: Access) {
                self.1 |= self.0.iter().any(|written| overlap(written, place));
                walk_place(self, place);
            }
        }
        let mut touched = Touched(&self.0, false);
        touched.expr(expr);
        touched.1
    }
}

impl Visit for Writes {
    fn place(&mut self, place: &Place, access: Access) {
        if access != Access::Read {
            self.0.push(place.clone());
        }
        walk_place(self, place);
    }
    fn declaration(&mut self, local: &LocalId) {
        // One that is declared in the loop is another in each pass.
        self.0.push(Place {
            root: *local,
            steps: Vec::new(),
            ty: bessemer_ir::Type::Unit,
            span: bessemer_ir::Span::default(),
        });
    }
}
