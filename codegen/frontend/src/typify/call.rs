//! Calls of functions, with their arguments evaluated in Rust's order.

use bessemer_ir::tree::{self, Site};
use bessemer_ir::{Argument, Expr, ExprKind, FunctionId, Mode, Place, Type};

use super::lowering::Lowering;
use super::value::Submatrix;
use super::words;
use super::{Result, refusals, refused};
use bessemer_ir::{alias, effects};

impl Lowering<'_, '_> {
    pub(super) fn call_function(
        &mut self,
        id: FunctionId,
        arguments: &[tree::Expr],
        expr: &tree::Expr,
    ) -> Result<Expr> {
        self.call_with(id, arguments, Vec::new(), expr)
    }

    /// Lowers a call with additional arguments after the author's.
    pub(super) fn call_with(
        &mut self,
        id: FunctionId,
        arguments: &[tree::Expr],
        more: Vec<Argument>,
        expr: &tree::Expr,
    ) -> Result<Expr> {
        let callee = &self.cx.module.functions[id.index()];
        let parameters: Vec<_> =
            callee.parameters().iter().map(|local| (local.mode, local.ty.clone())).collect();
        let result = callee.result.clone();
        let (mut passed, mut copies) = (Vec::new(), Vec::new());
        let mut parameters = parameters.into_iter();
        for (index, argument) in arguments.iter().enumerate() {
            let parameter = match self.cx.is_absent(id, index) {
                true => None,
                false => match parameters.next() {
                    Some(parameter) => Some(parameter),
                    None => break,
                },
            };
            let mut next = self.passed(argument, parameter.as_ref(), &mut copies)?;
            let is_last = index + 1 == arguments.len();
            // A slice begins and ends where nothing writes.
            if let [one] = next.as_mut_slice() {
                self.hold_argument(one, argument, is_last);
            }
            // The length of a slice is a parameter of its own.
            parameters.by_ref().take(next.len().saturating_sub(1)).for_each(drop);
            let lenders = match (&parameter, next.as_slice()) {
                (Some((_, ty)), [one]) => self.lending_arguments(one, ty, argument.site)?,
                _ => Vec::new(),
            };
            lent_twice(&passed, &lenders, argument.site)?;
            parameters.by_ref().take(lenders.len()).for_each(drop);
            passed.extend(next);
            passed.extend(lenders);
        }
        passed.extend(more);
        if !alias::conflicts(&passed).is_empty() {
            return refused(expr.site, refusals::MAY_MEET);
        }
        let call = self.node(ExprKind::Call(id, passed), result, expr.site)?;
        let call = self.counted_from_lender(call)?;
        self.written_back(call, copies)
    }

    /// Returns the arguments of the C for one argument: a slice also passes its length, and a zero-sized one passes
    /// nothing.
    fn passed(
        &mut self,
        argument: &tree::Expr,
        parameter: Option<&(Mode, Type)>,
        copies: &mut Vec<(Submatrix, Place)>,
    ) -> Result<Vec<Argument>> {
        let Some((mode, ty)) = parameter else {
            self.effect(argument)?;
            return Ok(Vec::new());
        };
        let passed = match mode {
            _ if matches!(ty, Type::Slice(_)) => {
                return Ok(self.sliced(argument)?.passed(*mode).into());
            }
            Mode::RefMut if let Some(part) = self.submatrix(argument)? => {
                let copy = self.copy_of_part("part", &part, argument.site)?;
                copies.push((part, copy.clone()));
                Argument::RefMut(copy)
            }
            Mode::RefMut => match self.place(argument)? {
                Some(place) => Argument::RefMut(place),
                None => {
                    self.not_coords(argument)?;
                    let value = self.value(argument, Some(ty))?;
                    Argument::RefMut(self.assigned(words::ARGUMENT, value))
                }
            },
            Mode::Ref => {
                let value = self.read(argument, Some(ty))?;
                Argument::Ref(self.as_asked(value, ty, argument.site)?)
            }
            Mode::Value => Argument::Value(self.value(argument, Some(ty))?),
        };
        Ok(vec![passed])
    }

    /// Evaluates an argument before the next: holds a value, checks a borrowed place. The last value needs no local.
    fn hold_argument(&mut self, argument: &mut Argument, expr: &tree::Expr, is_last: bool) {
        match argument {
            Argument::Value(_) if is_last => {}
            Argument::RefMut(_) => {}
            Argument::Ref(Expr { kind: ExprKind::Load(place), .. })
                if is_place(expr) && !self.is_loan(place) => {}
            Argument::Value(value) | Argument::Ref(value) => {
                *value = self.atom(words::ARGUMENT, value.clone());
            }
        }
    }
}

/// Returns true if an expression is a place, or borrows one.
fn is_place(expr: &tree::Expr) -> bool {
    match &expr.kind {
        tree::ExprKind::Local(_) => true,
        tree::ExprKind::Ref(_, inner)
        | tree::ExprKind::Deref(inner)
        | tree::ExprKind::Field(inner, _)
        | tree::ExprKind::Index(inner, _) => is_place(inner),
        _ => false,
    }
}

/// Returns the place that an argument borrows, and true if the borrow is mutable.
pub(super) fn lent(argument: &Argument) -> Option<(&Place, bool)> {
    match argument {
        Argument::RefMut(place) => Some((place, true)),
        Argument::Ref(Expr { kind: ExprKind::Load(place), .. }) => Some((place, false)),
        _ => None,
    }
}

/// Refuses two arguments whose slices have one lender, if one of them is mutable: the C would receive the array
/// twice.
fn lent_twice(passed: &[Argument], lenders: &[Argument], site: Site) -> Result<()> {
    let hurt = passed.iter().filter_map(lent).any(|(earlier, mutable)| {
        let mut lenders = lenders.iter().filter_map(lent);
        lenders.any(|(place, also)| (mutable || also) && effects::overlap(earlier, place))
    });
    if hurt {
        return refused(site, refusals::LENT_TWICE);
    }
    Ok(())
}
