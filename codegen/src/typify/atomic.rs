//! `#[entry(atomic)]`: what the entry point writes through references is written in copies, and goes back
//! where it returns. So a fault leaves everything as it was.

use bessemer_ir::visit::{self, Access, VisitMut};
use bessemer_ir::{Block, Expr, LocalId, Mode, Place, Span, Stmt, StmtKind, Type};

use super::lowering::Lowering;
use super::order::is_free;
use super::words;

impl Lowering<'_, '_> {
    /// Makes the body that was lowered write to copies.
    pub(super) fn roll_back(&mut self, params: usize, span: Span) {
        let mut copies = Vec::new();
        for index in 0..params {
            let param = &self.locals[index];
            if param.mode != Mode::RefMut {
                continue;
            }
            let (ty, name) = (param.ty.clone(), param.name.clone());
            let name = if name == "self" { "next".to_owned() } else { format!("next_{name}") };
            let copy = self.local(name, ty.clone(), span);
            let place = |root| Place::local(root, ty.clone(), span);
            copies.push((place(LocalId(index as u32)), place(copy)));
        }
        let mut body = Block(std::mem::take(&mut self.out));
        Moved(&copies).block(&mut body);
        self.commits(&mut body, &copies);
        let ends = matches!(body.0.last(), Some(Stmt { kind: StmtKind::Return(_), .. }));
        if self.result == Type::Unit && !ends {
            body.0.extend(commit(&copies, span));
        }
        let first = copies.iter().map(|(place, copy)| {
            Stmt::new(StmtKind::Let { local: copy.root, value: Some(place.load()) }, span)
        });
        self.out = first.chain(body.0).collect();
    }

    /// Puts the copies back before each `return`, behind what its value does.
    fn commits(&mut self, block: &mut Block, copies: &[(Place, Place)]) {
        for mut each in std::mem::take(&mut block.0) {
            let span = each.span;
            match &mut each.kind {
                StmtKind::Return(value) => {
                    if let Some(value) = value.as_mut().filter(|value| !is_free(value)) {
                        let local = self.local(words::OUTCOME, value.ty.clone(), span);
                        let held = Expr::local(local, &value.ty, span);
                        let value = Some(std::mem::replace(value, held));
                        block.0.push(Stmt::new(StmtKind::Let { local, value }, span));
                    }
                    block.0.extend(commit(copies, span));
                }
                StmtKind::If { then, otherwise, .. } => {
                    self.commits(then, copies);
                    self.commits(otherwise, copies);
                }
                StmtKind::Match { arms, otherwise, .. } => {
                    arms.iter_mut().for_each(|arm| self.commits(&mut arm.body, copies));
                    otherwise.iter_mut().for_each(|block| self.commits(block, copies));
                }
                StmtKind::For { body, .. } => self.commits(body, copies),
                _ => {}
            }
            block.0.push(each);
        }
    }
}

fn commit(copies: &[(Place, Place)], span: Span) -> impl Iterator<Item = Stmt> {
    copies.iter().map(move |(place, copy)| {
        Stmt::new(StmtKind::Assign { place: place.clone(), value: copy.load() }, span)
    })
}

/// The writes that go to the copies in place of the references.
struct Moved<'c>(&'c [(Place, Place)]);

impl VisitMut for Moved<'_> {
    fn place(&mut self, place: &mut Place, _: Access) {
        if let Some((_, copy)) = self.0.iter().find(|(from, _)| from.root == place.root) {
            place.root = copy.root;
        }
        visit::walk_place_mut(self, place);
    }
}
