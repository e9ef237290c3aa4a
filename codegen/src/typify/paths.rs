//! Paths that rustc evaluated: constants, variants, defaults.

use bessemer_ir::tree::{self, Site};
use bessemer_ir::{Expr, ExprKind, Type};

use super::lowering::Lowering;
use super::{OUR_FAULT, Result, names, problem};

impl Lowering<'_, '_> {
    pub(super) fn path(&mut self, index: u32, name: &str, site: Site) -> Result<Expr> {
        let source = self.source;
        let Some(constant) = source.constants.get(index as usize) else {
            return problem(site, "the tree names a constant that is not there", OUR_FAULT);
        };
        let ty = self.cx.value_type(&constant.ty, site)?;
        if let (Type::Enum(_), [word]) = (&ty, constant.words.as_slice()) {
            return self.node(ExprKind::Literal(*word), ty, site);
        }
        if ty == Type::Unit {
            return Ok(self.nothing(site));
        }
        let words = constant.words.clone();
        let last = name.rsplit("::").next().unwrap_or_default();
        if let Type::Struct(id) = ty
            && let Some((word, case)) = self.case(id, last)
            && case.field.is_none()
            && words.first() == Some(&word)
        {
            return self.choice(id, word, None, site);
        }
        if !self.cx.slices_in(&ty).is_empty() {
            return problem(
                site,
                "a value that borrows is no constant in C",
                "make it here, or in a function, instead of a `const`",
            );
        }
        let generic = |wanted: &str| {
            source.generics.iter().find(|(known, _)| known == wanted).map(|(_, argument)| argument)
        };
        let number = matches!(generic(name), Some(tree::Argument::Number(..)));
        let plain = ["::ZERO", "::ONE"].iter().any(|end| name.ends_with(end));
        let literal =
            number || plain && ty.as_float().is_some() || last == "DEFAULT" && ty.is_word();
        if let ([word], true) = (words.as_slice(), literal) {
            return self.node(ExprKind::Literal(*word), ty, site);
        }
        // `T::PI` is `f32::PI` where `T` is `f32`, and `Default::default()` is named for its type.
        let name = match name.split_once("::").map(|(first, rest)| (first, generic(first), rest)) {
            Some((_, Some(tree::Argument::Type(tree::Ty::Named(path))), rest)) => {
                format!("{}::{rest}", self.cx.item_name(path))
            }
            Some((_, Some(argument), rest)) => {
                format!("{}::{rest}", self.cx.argument_name(argument))
            }
            Some(("Default", None, rest)) if let Type::Struct(_) = ty => {
                format!("{}::{rest}", self.cx.name_of(&ty).unwrap_or_default())
            }
            _ => name.to_owned(),
        };
        let owner = source.owner.as_ref().map(|path| self.cx.item_name(path).to_owned());
        let (module, name) = names::constant(&self.module_path(), owner.as_deref(), &name);
        let id = self.cx.constant(&module, &name, &ty, &words);
        self.node(ExprKind::Const(id), ty, site)
    }
}
