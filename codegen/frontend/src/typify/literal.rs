//! Literals, from the author's digits to words of the expected type; and paths that rustc evaluated: constants,
//! variants, defaults.

use bessemer_ir::tree::{self, BinaryOp, Builtin, MatrixMethod, Site};
use bessemer_ir::{Expr, ExprKind, Float, Scalar, Type, UnaryOp, Written};

use super::lowering::Lowering;
use super::value::Value;
use super::{Context, Needed, OUR_FAULT, Result, names, problem, refusals, refused, struct_of};

/// Returns the word of an integer literal of type `scalar`.
pub(super) fn integer(digits: &str, negative: bool, scalar: Scalar, site: Site) -> Result<u64> {
    let value = match digits.strip_prefix("0x") {
        Some(digits) => i128::from_str_radix(digits, 16),
        None => digits.parse::<i128>(),
    };
    let value = value.ok().needed(site, "this literal is out of range")?;
    let value = if negative { -value } else { value };
    match scalar {
        Scalar::Int(int) if (int.min()..=int.max()).contains(&value) => Ok(value as u64),
        Scalar::Float(_) => {
            let digits = if negative { format!("-{digits}") } else { digits.to_owned() };
            float(&digits, scalar, site)
        }
        _ => problem(
            site,
            format!("this literal is out of range for `{}`", scalar.name()),
            OUR_FAULT,
        ),
    }
}

/// Returns an integer literal as a literal of another type that has its value. `N as u32` is one, where `N` is a const
/// generic of the instance.
pub(super) fn converted(value: &Expr, ty: &Type) -> Option<Expr> {
    let (ExprKind::Literal(word), Some(from)) = (&value.kind, value.ty.as_int()) else {
        return None;
    };
    let number = from.from_word(*word);
    let word = match (ty.as_int(), ty.as_float()) {
        (Some(to), _) if (to.min()..=to.max()).contains(&number) => *word,
        (_, Some(Float::F32)) => u64::from((number as f32).to_bits()),
        (_, Some(Float::F64)) => (number as f64).to_bits(),
        _ => return None,
    };
    Some(Expr::literal(word, ty.clone(), value.span))
}

/// Returns the result of an operation on two integer literals, unless it overflows or faults.
pub(super) fn folded(op: BinaryOp, left: &Expr, right: &Expr) -> Option<u64> {
    let (ExprKind::Literal(a), ExprKind::Literal(b)) = (&left.kind, &right.kind) else {
        return None;
    };
    let int = left.ty.as_int().filter(|_| left.ty == right.ty)?;
    let (a, b) = (int.from_word(*a), int.from_word(*b));
    let value = match op {
        BinaryOp::Add => a.checked_add(b),
        BinaryOp::Sub => a.checked_sub(b),
        BinaryOp::Mul => a.checked_mul(b),
        BinaryOp::Div => a.checked_div(b),
        BinaryOp::Rem => a.checked_rem(b),
        _ => None,
    }?;
    (int.min()..=int.max()).contains(&value).then_some(value as u64)
}

/// Returns the word of a float literal of type `scalar`.
pub(super) fn float(digits: &str, scalar: Scalar, site: Site) -> Result<u64> {
    let word = match scalar {
        Scalar::Float(Float::F64) => digits.parse::<f64>().ok().map(f64::to_bits),
        Scalar::Float(Float::F32) => digits.parse::<f32>().ok().map(|it| it.to_bits().into()),
        _ => None,
    };
    word.needed(site, "this literal is not a float here")
}

/// Returns the type of a literal: its suffix, the expected type, or Rust's default. Digits of an integer may be a
/// float if one is expected.
pub(super) fn type_of(suffix: Option<Scalar>, expected: Option<&Type>, default: Scalar) -> Scalar {
    match (suffix, expected, default) {
        (Some(scalar), ..) => scalar,
        (None, Some(Type::Scalar(scalar @ Scalar::Float(_))), _) => *scalar,
        (None, Some(Type::Scalar(scalar @ Scalar::Int(_))), Scalar::Int(_)) => *scalar,
        _ => default,
    }
}

/// Paths of the integers of 128 bits.
const WIDE: [&str; 2] = ["bessemer::wide::u128::U128", "bessemer::wide::i128::I128"];

/// Returns true for an integer of 128 bits.
pub(super) fn is_wide(cx: &Context<'_>, ty: &Type) -> bool {
    matches!(ty, Type::Struct(_)) && WIDE.iter().any(|path| cx.types.by_path.get(*path) == Some(ty))
}

/// Lowers an integer literal of 128 bits: its upper and its lower word.
pub(super) fn wide_integer(
    lowering: &mut Lowering<'_, '_>,
    digits: &str,
    negative: bool,
    ty: &Type,
    site: Site,
) -> Result<Expr> {
    // A pattern has its sign in the literal.
    let (digits, negative) = match digits.strip_prefix('-') {
        Some(digits) => (digits, !negative),
        None => (digits, negative),
    };
    let value = match digits.strip_prefix("0x") {
        Some(digits) => u128::from_str_radix(digits, 16),
        None => digits.parse::<u128>(),
    };
    let value = value.ok().needed(site, "this literal is out of range")?;
    let value = if negative { value.wrapping_neg() } else { value };
    let id = struct_of(ty, site, "an integer of 128 bits")?;
    let (span, fields) = (lowering.span(site), lowering.cx.fields(id).to_vec());
    let words = [(value >> 64) as u64, value as u64];
    if digits.starts_with("0x") {
        let spelt = words.map(|word| ((span, word), Written::Hexadecimal));
        lowering.cx.module.written.extend(spelt);
    }
    let parts = fields.iter().zip(words);
    let parts = parts.map(|(field, word)| Expr::literal(word, field.ty.clone(), span));
    lowering.node(ExprKind::Struct(parts.collect()), ty.clone(), site)
}

/// Lowers `!` of an integer literal of 128 bits. Of other values it is a function of the library.
pub(super) fn inverted(lowering: &mut Lowering<'_, '_>, literal: Expr, site: Site) -> Result<Expr> {
    let ExprKind::Struct(parts) = literal.kind else {
        return problem(site, "`!` of this value has no function", OUR_FAULT);
    };
    let invert = |part: Expr| Expr::unary(UnaryOp::Not, part);
    let kind = ExprKind::Struct(parts.into_iter().map(invert).collect());
    lowering.node(kind, literal.ty, site)
}

/// Returns the literal that `base.name` is, if `base` is the name of a struct of literals.
pub(super) fn literal_part(
    lowering: &Lowering<'_, '_>,
    base: &tree::Expr,
    name: &str,
) -> Option<Expr> {
    let Some(Value::Word(word)) = lowering.meaning(base) else { return None };
    let (ExprKind::Struct(parts), Type::Struct(id)) = (word.kind, word.ty) else { return None };
    let part = parts.into_iter().nth(lowering.cx.field_at(id, name).flatten()?)?;
    part.is_literal().then_some(part)
}

impl<'a> Lowering<'a, '_> {
    /// Returns true if a number depends on the instance: its constants, the size of a matrix, or the arguments of an
    /// expanded function.
    pub(super) fn is_of_instance(&self, expr: &tree::Expr) -> bool {
        match &expr.kind {
            tree::ExprKind::Path(_, name) => {
                matches!(self.generic(name), Some(tree::Argument::Number(..)))
            }
            tree::ExprKind::Call(callee, _) => {
                use MatrixMethod::{Cols, Elements, Rows};
                let builtin = self.builtin_of(*callee);
                matches!(builtin, Some(Builtin::Matrix(Rows | Cols | Elements)))
            }
            tree::ExprKind::Local(name) if !self.expanding.is_empty() => {
                matches!(self.lookup(name, expr.site), Ok(Value::Word(it)) if it.is_literal())
            }
            tree::ExprKind::Binary(_, a, b) => self.is_of_instance(a) || self.is_of_instance(b),
            _ => false,
        }
    }

    /// Returns the instance's argument for the parameter of this name.
    fn generic(&self, wanted: &str) -> Option<&'a tree::Argument> {
        let mut generics = self.source.generics.iter();
        generics.find(|(known, _)| known == wanted).map(|(_, argument)| argument)
    }

    /// Lowers a path that rustc evaluated: a constant, a variant, a default.
    pub(super) fn path(&mut self, index: u32, name: &str, site: Site) -> Result<Expr> {
        let source = self.source;
        let constant = source.constants.get(index as usize);
        let constant = constant.needed(site, "the tree names a constant that is not there")?;
        self.cx.no_clash(&constant.words, name.starts_with('"'), site)?;
        let ty = self.cx.value_type(&constant.ty, site)?;
        if let (Some(text), [word]) = (name.strip_prefix('"'), constant.words.as_slice()) {
            let id = self.cx.text(text, *word);
            return self.node(ExprKind::Const(id), ty, site);
        }
        if let (Type::Enum(_), [word], false) =
            (&ty, constant.words.as_slice(), self.cx.is_name(&ty))
        {
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
            return refused(site, refusals::BORROWED_CONSTANT);
        }
        let number = matches!(self.generic(name), Some(tree::Argument::Number(..)));
        let plain = ["::ZERO", "::ONE"].iter().any(|end| name.ends_with(end));
        let literal =
            number || plain && ty.as_float().is_some() || last == "DEFAULT" && ty.is_word();
        if let ([word], true) = (words.as_slice(), literal) {
            return self.node(ExprKind::Literal(*word), ty, site);
        }
        // `T::PI` is `f32::PI` where `T` is `f32`, and `Default::default()` is named for its type.
        let name =
            match name.split_once("::").map(|(first, rest)| (first, self.generic(first), rest)) {
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

/// Returns true for a float literal without a suffix, also with a sign.
pub(super) fn is_unsuffixed_float(expr: &tree::Expr) -> bool {
    match &expr.kind {
        tree::ExprKind::Float(_, None) => true,
        tree::ExprKind::Unary(_, operand) => is_unsuffixed_float(operand),
        _ => false,
    }
}
