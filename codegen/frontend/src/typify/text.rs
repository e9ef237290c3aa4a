//! Names, `&str`: values without an order, each the CRC-32 of its text.
//!
//! While functions are lowered, names have the type of an enum without variants, so that nothing takes one for a
//! number: they have no order, no arithmetic and no conversion. Afterwards the type is `u32`, and the enum is gone.

use std::collections::HashMap;

use bessemer_ir::tree::Site;
use bessemer_ir::visit::{Access, VisitMut, walk_expr_mut, walk_place_mut};
use bessemer_ir::{Const, ConstId, Enum, EnumId, Expr, Given, Int, Place, Scalar, Span, Type};

use super::{Context, Result, names, problem};

impl Context<'_> {
    /// Returns the type of names. A module with names has the constant of the empty one.
    pub(super) fn name_type(&mut self) -> Type {
        if let Some(id) = self.names {
            return Type::Enum(id);
        }
        let enums = &mut self.module.enums;
        let id = EnumId(enums.len() as u32);
        enums.push(Enum {
            name: "str".into(),
            module: Const::NAMES.into(),
            docs: Vec::new(),
            variants: Vec::new(),
            given: Given::default(),
            span: Span::default(),
        });
        self.names = Some(id);
        self.text("", 0);
        Type::Enum(id)
    }

    /// Returns the constant of a name.
    pub(super) fn text(&mut self, text: &str, word: u64) -> ConstId {
        let ty = self.name_type();
        let id = self.constant(Const::NAMES, &names::of_text(text, word), &ty, &[word]);
        let constant = &mut self.module.consts[id.index()];
        (constant.given.hexadecimal, constant.given.public) = (true, true);
        constant.docs = vec![names::shown(text)];
        id
    }

    /// Refuses a value with a name that has the word of another, once for each two names. Without such names, words are
    /// words.
    pub(super) fn no_clash(&mut self, words: &[u64], site: Site) -> Result<()> {
        let Some([one, other]) = words.iter().find_map(|word| self.clashes.remove(word)) else {
            return Ok(());
        };
        problem(
            site,
            format!("the names {one:?} and {other:?} have the same CRC-32, by which the C tells names apart"),
            "change the text of one of them",
        )
    }

    /// Returns true for the type of names.
    pub(super) fn is_name(&self, ty: &Type) -> bool {
        matches!(ty, Type::Enum(id) if self.names == Some(*id))
    }

    /// Adds the constants of names that are only in tables and initial states: callers compare with them, too.
    pub(super) fn all_names(&mut self) {
        if self.names.is_some() {
            self.package.names.iter().for_each(|(word, text)| _ = self.text(text, *word));
        }
    }

    /// Makes the names of the module numbers.
    pub(super) fn names_to_numbers(&mut self) {
        let Some(names) = self.names else { return };
        let module = &mut self.module;
        let mut numbers = Numbers(names);
        let fields = module.structs.iter_mut().flat_map(|it| &mut it.fields);
        fields.for_each(|field| numbers.ty(&mut field.ty));
        module.consts.iter_mut().for_each(|constant| numbers.ty(&mut constant.ty));
        for function in &mut module.functions {
            numbers.ty(&mut function.result);
            function.locals.iter_mut().for_each(|local| numbers.ty(&mut local.ty));
            if let Some(bessemer_ir::Owner::Enum(id)) = &mut function.owner {
                numbers.id(id);
            }
            numbers.block(&mut function.body);
        }
        module.enums.remove(names.index());
    }
}

/// Returns the pairs of names that have one word, by the word.
pub(super) fn clashes(names: &[(u64, String)]) -> HashMap<u64, [&str; 2]> {
    let pairs = names.array_windows();
    let clashing = pairs.filter(|[(one, _), (other, _)]| one == other);
    clashing.map(|[(word, one), (_, other)]| (*word, [one.as_str(), other.as_str()])).collect()
}

/// Visitor that replaces the type of names, the enum, by that of their words.
struct Numbers(EnumId);

impl Numbers {
    fn ty(&self, ty: &mut Type) {
        match ty {
            Type::Enum(id) if *id == self.0 => *ty = Type::Scalar(Scalar::Int(Int::U32)),
            Type::Enum(id) => self.id(id),
            Type::Array { element, .. } | Type::Slice(element) => self.ty(element),
            Type::Unit | Type::Scalar(_) | Type::Matrix { .. } | Type::Struct(_) => {}
        }
    }

    /// Closes the gap that the enum leaves.
    fn id(&self, id: &mut EnumId) {
        id.0 -= u32::from(*id > self.0);
    }
}

impl VisitMut for Numbers {
    fn expr(&mut self, expr: &mut Expr) {
        self.ty(&mut expr.ty);
        walk_expr_mut(self, expr);
    }

    fn place(&mut self, place: &mut Place, _: Access) {
        self.ty(&mut place.ty);
        walk_place_mut(self, place);
    }
}
