//! `#[entry(atomic)]`: an entry point writes to copies of its mutable arguments, and copies them back where it
//! returns. A fault so leaves the arguments unchanged.

use bessemer_ir::visit::{self, Access, VisitMut};
use bessemer_ir::{Block, Expr, LocalId, Mode, Place, Span, Stmt, StmtKind, Type};

use super::locals::Locals;
use super::lowering::Lowering;
use super::words;

impl Lowering<'_, '_> {
    /// Redirects the writes of a lowered body to copies.
    pub(super) fn roll_back(&mut self, params: usize, span: Span) {
        let mut copies = Vec::new();
        for index in 0..params {
            let param = &self.locals[index];
            if param.mode != Mode::RefMut {
                continue;
            }
            let (ty, name) = (param.ty.clone(), param.name.clone());
            let name = if name == "self" { "next".to_owned() } else { format!("next_{name}") };
            let copy = self.locals.by_value(name, ty.clone(), span);
            let place = |root| Place::local(root, ty.clone(), span);
            copies.push((place(LocalId(index as u32)), place(copy)));
        }
        let mut body = Block(std::mem::take(&mut self.out));
        let mut rolled_back = RolledBack { locals: &mut self.locals, copies: &copies };
        rolled_back.block(&mut body);
        let ends = matches!(body.0.last(), Some(Stmt { kind: StmtKind::Return(_), .. }));
        if self.result == Type::Unit && !ends {
            body.0.extend(commit(&copies, span));
        }
        let first = copies.iter().map(|(place, copy)| {
            Stmt::new(StmtKind::Let { local: copy.root, value: Some(place.load()) }, span)
        });
        self.out = first.chain(body.0).collect();
    }
}

fn commit(copies: &[(Place, Place)], span: Span) -> impl Iterator<Item = Stmt> {
    copies.iter().map(move |(place, copy)| {
        Stmt::new(StmtKind::Assign { place: place.clone(), value: copy.load() }, span)
    })
}

/// Replaces each write through a reference by a write to its copy. Before each `return`, after the returned value is
/// computed, it inserts the copying back.
struct RolledBack<'l> {
    locals: &'l mut Locals,
    copies: &'l [(Place, Place)],
}

impl VisitMut for RolledBack<'_> {
    fn block(&mut self, block: &mut Block) {
        for mut each in std::mem::take(&mut block.0) {
            self.stmt(&mut each);
            let span = each.span;
            if let StmtKind::Return(value) = &mut each.kind {
                if let Some(value) = value {
                    let local =
                        self.locals.by_value(words::OUTCOME.to_owned(), value.ty.clone(), span);
                    self.locals.note_atom(local);
                    let held = Expr::local(local, &value.ty, span);
                    let value = Some(std::mem::replace(value, held));
                    block.0.push(Stmt::new(StmtKind::Let { local, value }, span));
                }
                block.0.extend(commit(self.copies, span));
            }
            block.0.push(each);
        }
    }

    fn place(&mut self, place: &mut Place, _: Access) {
        if let Some((_, copy)) = self.copies.iter().find(|(from, _)| from.root == place.root) {
            place.root = copy.root;
        }
        visit::walk_place_mut(self, place);
    }
}
