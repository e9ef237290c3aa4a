//! `let` that takes a value apart: each name a local of its own, or another name for a part.

use bessemer_ir::tree;
use bessemer_ir::{Expr, ExprKind, Local, LocalId, Mode, Place, Step, StmtKind, Type};

use super::OUR_FAULT;
use super::function::{Binding, Lowering};
use super::{Result, problem};

/// The names of one `let`: they mean what they are given only behind it.
type Names = Vec<(String, Binding)>;

impl Lowering<'_, '_> {
    /// `let pattern = value;`
    pub(super) fn take_apart(&mut self, pattern: &tree::Binding, value: &tree::Expr) -> Result<()> {
        let mut names = Names::new();
        self.part_value(pattern, value, &mut names)?;
        for (name, binding) in names {
            self.bind(&name, binding);
        }
        Ok(())
    }

    fn part_value(
        &mut self,
        pattern: &tree::Binding,
        value: &tree::Expr,
        names: &mut Names,
    ) -> Result<()> {
        match (pattern, &value.kind) {
            (tree::Binding::Tuple(parts), tree::ExprKind::Tuple(values))
                if parts.len() == values.len() =>
            {
                // Left to right, each in a local of its own before the next is computed.
                let mut each = parts.iter().zip(values);
                each.try_for_each(|(part, value)| self.part_value(part, value, names))
            }
            (tree::Binding::Tuple(_), _) => problem(
                value.site,
                "only a tuple that is written out is taken apart in the DSL",
                "return a struct marked `#[data]`",
            ),
            (tree::Binding::Ignored, _) => {
                let value = self.value(value, None)?;
                let span = value.span;
                self.emit(StmtKind::Expr(value), span);
                Ok(())
            }
            (tree::Binding::Name { name, slot }, _)
                if !self.slot_is_reference(*slot, value.site)? =>
            {
                let ty = self.slot(*slot, value.site)?;
                let naming = std::mem::replace(&mut self.naming, name.clone());
                let lowered = self.value(value, Some(&ty))?;
                self.naming = naming;
                self.agree(&lowered.ty, &ty, value.site)?;
                self.part_local(name, lowered, names);
                Ok(())
            }
            _ => {
                let place = self.base(value)?;
                self.part_place(pattern, place, value, names)
            }
        }
    }

    fn part_local(&mut self, name: &str, value: Expr, names: &mut Names) {
        let local = LocalId(self.locals.len() as u32);
        let (ty, span) = (value.ty.clone(), value.span);
        self.locals.push(Local { name: name.to_owned(), ty, mode: Mode::Value, span });
        self.emit(StmtKind::Let { local, value: Some(value) }, span);
        names.push((name.to_owned(), Binding::Local(local)));
    }

    fn part_place(
        &mut self,
        pattern: &tree::Binding,
        place: Place,
        value: &tree::Expr,
        names: &mut Names,
    ) -> Result<()> {
        match (pattern, place.ty.clone()) {
            (tree::Binding::Ignored, _) => Ok(()),
            (tree::Binding::Name { name, slot }, _) => {
                if self.slot_is_reference(*slot, value.site)? {
                    if !place.steps.iter().all(super::place::is_fixed) {
                        return problem(
                            value.site,
                            "a reference in a variable names a fixed place in the DSL",
                            "copy the value: `let Gains { p, i } = *gains;`",
                        );
                    }
                    names.push((name.clone(), Binding::Alias(place)));
                    return Ok(());
                }
                let (ty, span) = (place.ty.clone(), place.span);
                self.agree(&ty, &self.slot(*slot, value.site)?, value.site)?;
                self.part_local(name, Expr { kind: ExprKind::Load(place), ty, span }, names);
                Ok(())
            }
            (tree::Binding::Array(parts), Type::Array { element, len })
                if parts.len() == len as usize =>
            {
                for (index, part) in parts.iter().enumerate() {
                    let index = self.index_literal(index as u64, value);
                    let inner = inside(&place, Step::Index(index), (*element).clone());
                    self.part_place(part, inner, value, names)?;
                }
                Ok(())
            }
            (tree::Binding::Struct(parts), Type::Struct(id)) => {
                let declared = self.cx.module.structs[id.index()].fields.clone();
                for (name, part) in parts {
                    let found = declared.iter().position(|field| field.name == *name);
                    let Some(index) = found else {
                        return problem(value.site, format!("`{name}` is missing"), OUR_FAULT);
                    };
                    let ty = declared[index].ty.clone();
                    let inner = inside(&place, Step::Field(index as u32), ty);
                    self.part_place(part, inner, value, names)?;
                }
                Ok(())
            }
            _ => problem(
                value.site,
                "this pattern does not fit what the DSL takes apart",
                "take apart arrays, structs, and tuples that are written out",
            ),
        }
    }
}

/// The part of a place behind one more step.
fn inside(place: &Place, step: Step, ty: Type) -> Place {
    let mut inner = place.clone();
    inner.steps.push(step);
    inner.ty = ty;
    inner
}
