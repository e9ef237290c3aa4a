//! Operations on single numbers: operators, comparisons, conversions and intrinsics.

use bessemer_ir::{
    BinaryOp, CompareOp, Expr, ExprKind, Float, Int, Intrinsic, Scalar, Type, UnaryOp,
};

use crate::body::{Cx, Result};

/// Returns true if the words of an integer need an order of their own: those above 2^63 are negative as an `i64`.
fn is_unsigned(int: Int) -> bool {
    !int.signed() && int.bits() == 64
}

fn wrapped(text: &str, int: Int) -> String {
    match int.bits() {
        64 => text.to_owned(),
        bits => format!("({text}).wrapped({bits}, {})", int.signed()),
    }
}

impl Cx<'_> {
    pub(crate) fn unary(&self, op: UnaryOp, of: &Expr) -> Result<String> {
        let text = self.value(of)?;
        Ok(match (op, &of.ty) {
            (UnaryOp::Neg, Type::Scalar(Scalar::Int(int))) => {
                wrapped(&format!("Whole::of(0) - {text}"), *int)
            }
            (UnaryOp::Neg, _) => format!("(-{text})"),
            (UnaryOp::Not, Type::Scalar(Scalar::Int(int))) => wrapped(&format!("!{text}"), *int),
            (UnaryOp::Not, _) => format!("(!{text})"),
        })
    }

    pub(crate) fn binary(&self, op: BinaryOp, left: &Expr, right: &Expr) -> Result<String> {
        let (a, b) = (self.value(left)?, self.value(right)?);
        let operator = |op: &str| format!("({a} {op} {b})");
        let int = left.ty.as_int();
        let unsigned = int.is_some_and(is_unsigned);
        Ok(match op {
            BinaryOp::Add => operator("+"),
            BinaryOp::Sub => operator("-"),
            BinaryOp::Mul => operator("*"),
            BinaryOp::Div if int.is_none() => operator("/"),
            BinaryOp::Div | BinaryOp::Rem if self.power(left, right).is_some() => {
                let power = self.power(left, right).unwrap_or_default();
                match op {
                    BinaryOp::Div => format!("{a}.shift_right(Whole::of({power}))"),
                    _ => format!("({a} & Whole::of({}))", (1_u64 << power) - 1),
                }
            }
            BinaryOp::Div if int.is_some_and(|int| int.bits() <= 32) => {
                format!("{a}.narrow_quotient({b})")
            }
            BinaryOp::Rem if int.is_some_and(|int| int.bits() <= 32) => {
                format!("{a}.narrow_remainder({b})")
            }
            BinaryOp::Div if unsigned => format!("{a}.unsigned_quotient({b})"),
            BinaryOp::Div => format!("{a}.quotient({b})"),
            BinaryOp::Rem if unsigned => format!("{a}.unsigned_remainder({b})"),
            BinaryOp::Rem => format!("{a}.remainder({b})"),
            BinaryOp::And => operator("&"),
            BinaryOp::Or => operator("|"),
            BinaryOp::Xor => operator("^"),
            BinaryOp::Shl => wrapped(&format!("{a}.shift_left({b})"), int.unwrap_or(Int::U64)),
            BinaryOp::Shr if int.is_some_and(Int::signed) => format!("{a}.signed_shift_right({b})"),
            BinaryOp::Shr => format!("{a}.shift_right({b})"),
        })
    }

    /// Returns the logarithm of a divisor that is a power of two, for an unsigned dividend.
    fn power(&self, left: &Expr, right: &Expr) -> Option<u32> {
        let divisor = match &right.kind {
            ExprKind::Literal(word) => *word,
            ExprKind::Const(id) => *self.module.consts[id.index()].words.first()?,
            _ => return None,
        };
        let unsigned = left.ty.as_int().is_some_and(|int| !int.signed());
        (unsigned && divisor.is_power_of_two()).then(|| divisor.trailing_zeros())
    }

    pub(crate) fn comparison(&self, op: CompareOp, left: &Expr, right: &Expr) -> Result<String> {
        let (mut a, mut b) = (self.value(left)?, self.value(right)?);
        let is_bool = left.ty == Type::BOOL;
        let ordered = !matches!(op, CompareOp::Eq | CompareOp::Ne);
        if ordered && left.ty.as_int().is_some_and(is_unsigned) {
            (a, b) = (a + ".unsigned()", b + ".unsigned()");
        } else if ordered && is_bool {
            (a, b) = (a + ".whole()", b + ".whole()");
        }
        Ok(match op {
            CompareOp::Eq => format!("{a}.equals({b})"),
            CompareOp::Ne if is_bool => format!("({a} ^ {b})"),
            CompareOp::Ne => format!("{a}.differs({b})"),
            CompareOp::Lt => format!("{a}.lt({b})"),
            CompareOp::Le => format!("{a}.le({b})"),
            CompareOp::Gt => format!("{a}.gt({b})"),
            CompareOp::Ge => format!("{a}.ge({b})"),
        })
    }

    /// Converts as Rust's `as` does.
    pub(crate) fn cast(&self, of: &Expr, to: &Type) -> Result<String> {
        let text = self.value(of)?;
        let Type::Scalar(to) = to else { return Err(self.error(of.span, "casts to no scalar")) };
        Ok(match (&of.ty, to) {
            (Type::Scalar(Scalar::Float(from)), Scalar::Float(to)) if from == to => text,
            (Type::Scalar(Scalar::Float(_)), Scalar::Float(Float::F64)) => text + ".real()",
            (Type::Scalar(Scalar::Float(_)), Scalar::Float(Float::F32)) => text + ".single()",
            (Type::Scalar(Scalar::Float(from)), Scalar::Int(int)) => {
                let real = if *from == Float::F64 { "" } else { ".real()" };
                format!("{text}{real}.convert(|value| value as {} as i64)", int.name())
            }
            (Type::Scalar(Scalar::Bool), Scalar::Int(_)) => text + ".whole()",
            (Type::Scalar(Scalar::Bool), _) => text,
            (Type::Scalar(Scalar::Int(from)), Scalar::Float(to)) => {
                let name = if *to == Float::F64 { "real" } else { "single" };
                let unsigned = if is_unsigned(*from) { "unsigned_" } else { "" };
                format!("{text}.{unsigned}{name}()")
            }
            (Type::Scalar(Scalar::Int(from)), Scalar::Int(to)) => {
                let keeps = Int::min(*from) >= Int::min(*to) && Int::max(*from) <= Int::max(*to);
                if keeps { text } else { wrapped(&text, *to) }
            }
            (Type::Enum(id), Scalar::Int(to)) => {
                let variants = &self.module.enums[id.index()].variants;
                let numbers: Vec<i32> = variants.iter().map(|it| it.value).collect();
                let plain = numbers.iter().enumerate().all(|(n, it)| n as i32 == *it);
                if plain {
                    return Ok(text);
                }
                let len = numbers.len();
                let table = format!(
                    "[{}]",
                    numbers.iter().map(|it| format!("{it}_i64")).collect::<Vec<_>>().join(", ")
                );
                wrapped(
                    &format!(
                        "{text}.apply(|n| {table}[(n as usize).min({})])",
                        len.saturating_sub(1)
                    ),
                    *to,
                )
            }
            _ => return Err(self.error(of.span, "has a cast that lanes do not have")),
        })
    }

    pub(crate) fn intrinsic(&self, which: Intrinsic, of: &[Expr]) -> Result<String> {
        let values = of.iter().map(|it| self.value(it)).collect::<Result<Vec<_>>>()?;
        let Some(first) = of.first() else {
            return Err(self.error(Default::default(), "calls nothing"));
        };
        let span = first.span;
        if let Type::Scalar(Scalar::Int(int)) = first.ty {
            return self.integer(which, int, &values).ok_or_else(|| self.missing(which, span));
        }
        if let Type::Enum(id) = first.ty {
            let last = self.module.enums[id.index()].variants.len().saturating_sub(1);
            let value = &values[0];
            return Ok(format!("{value}.unsigned_min(Whole::of({last}))"));
        }
        let name = match which {
            Intrinsic::Sqrt => "sqrt",
            Intrinsic::Abs => "abs",
            Intrinsic::ToBits => "to_bits",
            Intrinsic::RawBits => "raw_bits",
            Intrinsic::IsNan => "is_nan",
            Intrinsic::IsFinite => "is_finite",
            // Those that follow are there in double precision alone.
            _ if first.ty != Type::F64 => return Err(self.missing(which, span)),
            Intrinsic::Min => "min",
            Intrinsic::Max => "max",
            Intrinsic::Clamp => "clamp",
            Intrinsic::Floor => "floor",
            Intrinsic::Copysign => "copysign",
            Intrinsic::DivEuclid => "div_euclid",
            Intrinsic::RemEuclid => "rem_euclid",
            Intrinsic::Ceil => "ceil",
            Intrinsic::Trunc => "trunc",
            Intrinsic::Round => "round",
            Intrinsic::Signum => "signum",
            Intrinsic::IsInfinite => "is_infinite",
            _ => return Err(self.missing(which, span)),
        };
        let (first, others) = values.split_first().unwrap_or((&values[0], &[]));
        Ok(format!("{first}.{name}({})", others.join(", ")))
    }

    fn missing(&self, which: Intrinsic, span: bessemer_ir::Span) -> crate::Error {
        self.error(span, &format!("uses `{which:?}`, which lanes do not have for this type"))
    }

    fn integer(&self, which: Intrinsic, int: Int, values: &[String]) -> Option<String> {
        let operator = |op: &str| format!("({} {op} {})", values[0], values[1]);
        let unsigned = if is_unsigned(int) { "unsigned_" } else { "" };
        let by_lane = |name: &str| {
            let (a, b, int) = (&values[0], &values[1], int.name());
            format!("{a}.zip({b}, |one, other| (one as {int}).{name}(other as {int}) as i64)")
        };
        Some(match which {
            Intrinsic::Abs | Intrinsic::UnsignedAbs => format!("{}.magnitude()", values[0]),
            Intrinsic::Min => format!("{}.{unsigned}min({})", values[0], values[1]),
            Intrinsic::Max => format!("{}.{unsigned}max({})", values[0], values[1]),
            Intrinsic::Clamp => {
                format!("{}.{unsigned}max({}).{unsigned}min({})", values[0], values[1], values[2])
            }
            Intrinsic::WrappingAdd => wrapped(&operator("+"), int),
            Intrinsic::WrappingSub => wrapped(&operator("-"), int),
            Intrinsic::WrappingMul => wrapped(&operator("*"), int),
            Intrinsic::SaturatingAdd => by_lane("saturating_add"),
            Intrinsic::SaturatingSub => by_lane("saturating_sub"),
            Intrinsic::SaturatingMul => by_lane("saturating_mul"),
            Intrinsic::AbsDiff => by_lane("abs_diff"),
            Intrinsic::CountOnes => format!("{}.apply(|n| i64::from(n.count_ones()))", values[0]),
            Intrinsic::LeadingZeros => format!(
                "{}.apply(|n| i64::from(n.leading_zeros()) - {})",
                values[0],
                64 - int.bits()
            ),
            Intrinsic::TrailingZeros => {
                format!(
                    "{}.apply(|n| i64::from(n.trailing_zeros()).min({}))",
                    values[0],
                    int.bits()
                )
            }
            Intrinsic::FromBits if int == Int::U64 => format!("{}.real_of_bits()", values[0]),
            Intrinsic::FromBits => format!("{}.single_of_bits()", values[0]),
            _ => return None,
        })
    }
}
