//! Pairs of values that are compared: their parts, and what their types say about a comparison.
//!
//! Must not know: how a comparison is lowered. Nothing is emitted here.

use bessemer_ir::tree::Site;
use bessemer_ir::{CompareOp, Expr, ExprKind, Form, Place, Span, Step, StructId, Type};

use super::lengths::size;
use super::lowering::Lowering;
use super::{Result, refusals, refused};

/// Largest number of elements that are compared one by one, without a loop.
pub(super) const FEW: u32 = 4;

/// Two places of one type that are compared, with the site.
#[derive(Clone)]
pub(super) struct Pair {
    pub sides: [Place; 2],
    pub site: Site,
    pub span: Span,
}

impl Pair {
    /// Returns the pair of the same part of both places.
    pub(super) fn parts(&self, part: impl Fn(&Place) -> Place) -> Pair {
        let [left, right] = &self.sides;
        Pair { sides: [part(left), part(right)], ..*self }
    }

    /// Returns the pair of the parts that a step leads to.
    pub(super) fn at(&self, step: &Step, ty: &Type) -> Pair {
        self.parts(|whole| whole.inside(step.clone(), ty.clone()))
    }
}

/// Returns true for a variant constructed in place, such as `Some(3)`.
pub(super) fn is_variant(lower: &Lowering<'_, '_>, value: &Expr) -> bool {
    let (ExprKind::Struct(parts), Type::Struct(id)) = (&value.kind, &value.ty) else {
        return false;
    };
    let of_literal = parts.first().is_some_and(|tag| matches!(tag.kind, ExprKind::Literal(_)));
    of_literal && matches!(lower.cx.module.structs[id.index()].form, Form::Choice(_))
}

/// Returns true if a struct has only fields of one word, which are compared as words.
pub(super) fn is_flat(lower: &Lowering<'_, '_>, id: StructId) -> bool {
    let rotation = lower.cx.known_of(id).unit == Some(true);
    let fields = lower.cx.fields(id);
    let list = lower.cx.module.structs[id.index()].form == Form::Sequence;
    !rotation && !list && fields.iter().all(|field| field.ty.is_word())
}

/// Returns true if a comparison of two values of a type loops over their elements.
pub(super) fn has_loop(lower: &Lowering<'_, '_>, ty: &Type) -> bool {
    match ty {
        _ if lower.cx.known(ty).own_equality.is_some() => false,
        Type::Array { element, len } => *len > FEW || !element.is_word(),
        Type::Matrix { rows, cols, .. } => rows * cols > FEW || (*rows > 1 && *cols > 1),
        _ => false,
    }
}

/// Returns true if the order of a struct is clear in one expression: of a few words, or of a choice with one word.
pub(super) fn is_short(lower: &Lowering<'_, '_>, id: StructId) -> bool {
    let fields = lower.cx.fields(id);
    // The tag of a choice is a field.
    let most = if ordered_choice(lower, id) { 2 } else { FEW as usize };
    fields.len() <= most && fields.iter().all(|field| field.ty.is_word())
}

/// Returns true for an ordered enum with payload, an `Option` or a `Result`.
pub(super) fn ordered_choice(lower: &Lowering<'_, '_>, id: StructId) -> bool {
    let known = lower.cx.known_of(id);
    (known.ordered || known.shown.is_some()) && !known.cases.is_empty()
}

/// Returns the pairs of the parts of a tuple, an array or a struct with a derived order.
pub(super) fn parts(lower: &Lowering<'_, '_>, pair: &Pair) -> Result<Vec<Pair>> {
    let whole = &pair.sides[0];
    let known = lower.cx.known(&whole.ty);
    let is_tuple = known.shown.is_some() && known.cases.is_empty();
    match &whole.ty {
        Type::Struct(id) if is_tuple || known.ordered || known.reversed => {
            Ok(fields(lower, *id, pair))
        }
        Type::Array { element, len } => {
            let at = |at: u32| pair.at(&Step::Index(size(at, whole.span)), element);
            Ok((0..*len).map(at).collect())
        }
        _ => refused(pair.site, refusals::ORDER),
    }
}

/// Returns the pairs of the fields of a struct.
pub(super) fn fields(lower: &Lowering<'_, '_>, id: StructId, pair: &Pair) -> Vec<Pair> {
    let fields = (0..).zip(lower.cx.fields(id));
    fields.map(|(at, field)| pair.at(&Step::Field(at), &field.ty)).collect()
}

/// Returns the first name, or the second if the author has a function whose C name would be the same.
pub(super) fn free_name(
    lower: &Lowering<'_, '_>,
    id: StructId,
    [name, other]: [&str; 2],
) -> String {
    let ty = Type::Struct(id);
    let paths = lower.cx.types.by_path.iter().filter(|(_, it)| **it == ty);
    let mut homes: Vec<String> = paths.map(|(path, _)| format!("{path}::{name}")).collect();
    let own = super::names::snake(lower.cx.name_of(&ty).unwrap_or_default());
    homes.push(format!("::{own}::{name}"));
    let taken = |known: &String| homes.iter().any(|home| known.ends_with(home));
    if lower.cx.authored.iter().any(taken) { other } else { name }.to_owned()
}

/// Negates a comparison of equality, also of floats.
pub(super) fn opposite(same: Expr) -> Expr {
    let span = same.span;
    match same.kind {
        ExprKind::Compare(CompareOp::Eq, one, other) => {
            Expr::compare(CompareOp::Ne, *one, *other).at(span)
        }
        _ => same.negated(),
    }
}

/// Returns the comparison without equality: `<` for `<=`.
pub(super) fn strict(op: CompareOp) -> CompareOp {
    match op {
        CompareOp::Le => CompareOp::Lt,
        CompareOp::Ge => CompareOp::Gt,
        op => op,
    }
}
