//! Prints expressions and places.
//!
//! Invariant: a type or a span is omitted only if the parser supplies the same.

use alloc::format;
use alloc::string::String;
use alloc::vec::Vec;

use crate::ir::{Argument, Expr, ExprKind, Place, Span, Step, Type, UnaryOp};
use crate::number::{Int, Scalar};

use super::names::{
    ATOM, CAST, COMPARE, Infix, PREFIX, infix, intrinsic_name, routine_name, shown,
};
use super::print::{Printer, relative, shown_float};
use super::scope::spread;

/// Text of an expression, and its precedence.
struct Draft {
    text: String,
    binds: u8,
    /// Type and span that the parser supplies.
    ty: Option<Type>,
    span: Span,
}

impl Printer<'_> {
    /// Prints an expression of a statement at `base`.
    pub fn expr(&mut self, expr: &Expr, base: Span) {
        let text = self.tight(expr, 0, base);
        self.out.push_str(&text);
    }

    /// Prints a place, with its span unless it is `default`, and with its type if that does not follow.
    pub fn place(&mut self, place: &Place, base: Span, default: Span, typed: bool) {
        let text = self.place_text(place, base, default, typed);
        self.out.push_str(&text);
    }

    /// Returns the text of an expression that binds at least as tightly as `least`.
    fn tight(&mut self, expr: &Expr, least: u8, base: Span) -> String {
        let Draft { mut text, mut binds, ty, span } = self.draft(expr, base);
        if ty.as_ref() != Some(&expr.ty) {
            text = format!("({text} : {})", self.ty(&expr.ty));
            binds = ATOM;
        }
        let place = relative(expr.span, span, base);
        if binds < least || (binds < ATOM && !place.is_empty()) {
            text = format!("({text})");
        }
        text + &place
    }

    fn draft(&mut self, expr: &Expr, base: Span) -> Draft {
        let mut ty = self.scope().expr(&expr.kind);
        let mut span = base;
        let mut binds = ATOM;
        let text = match &expr.kind {
            ExprKind::Literal(word) => {
                let text = self.literal(*word, &expr.ty);
                ty = text.is_some().then(|| expr.ty.clone());
                text.unwrap_or_else(|| format!("{word:#x}"))
            }
            ExprKind::Const(id) => self.const_name(*id),
            ExprKind::Load(place) => return self.load(expr, place, base),
            ExprKind::Unary(op, operand) => {
                binds = PREFIX;
                self.prefixed(*op, operand, base)
            }
            ExprKind::Binary(op, left, right) => {
                return self.between(Infix::Binary(*op), left, right, ty, base);
            }
            ExprKind::Compare(op, left, right) => {
                return self.between(Infix::Compare(*op), left, right, ty, base);
            }
            ExprKind::Logic(op, left, right) => {
                return self.between(Infix::Logic(*op), left, right, ty, base);
            }
            ExprKind::Cast(operand) => {
                (binds, span, ty) = (CAST, operand.span, Some(expr.ty.clone()));
                format!("{} as {}", self.tight(operand, CAST, base), self.ty(&expr.ty))
            }
            ExprKind::Intrinsic(function, operands) => {
                span = operands.first().map_or(base, |first| first.span);
                self.method(intrinsic_name(*function), operands, base)
            }
            ExprKind::Routine(what, operands) => {
                span = operands.first().map_or(base, |first| first.span);
                self.method(routine_name(*what), operands, base)
            }
            ExprKind::Call(id, arguments) => {
                let name = self.function_name(*id);
                let arguments = self.arguments(arguments, base);
                format!("{name}({arguments})")
            }
            ExprKind::Struct(parts) => {
                let (text, known) = self.struct_value(parts, &expr.ty, base);
                ty = known;
                text
            }
            ExprKind::Array(parts) => format!("[{}]", self.list(parts, base)),
            ExprKind::Splat(part) => {
                let dimensions;
                (dimensions, ty) = stated(&expr.ty, Some(part));
                format!("splat{dimensions}({})", self.tight(part, 0, base))
            }
            ExprKind::Matrix(parts) => {
                let dimensions;
                let element = parts.first().filter(|_| matches!(expr.ty, Type::Matrix { .. }));
                (dimensions, ty) = stated(&expr.ty, element);
                format!("matrix{dimensions}({})", self.list(parts, base))
            }
        };
        Draft { text, binds, ty, span }
    }

    /// Returns a place as text if it agrees with its load, else `load(place)`.
    fn load(&mut self, expr: &Expr, place: &Place, base: Span) -> Draft {
        if place.span == expr.span && place.ty == expr.ty {
            let text = self.place_text(place, base, place.span, false);
            return Draft { text, binds: ATOM, ty: self.place_type(place), span: base };
        }
        let text = format!("load({})", self.place_text(place, base, base, true));
        Draft { text, binds: ATOM, ty: Some(place.ty.clone()), span: base }
    }

    fn place_type(&self, place: &Place) -> Option<Type> {
        let index = place.root.index();
        let declared = self.locals.declared.get(index) == Some(&true);
        let function = self.locals.function.filter(|_| declared);
        self.scope().place(function.map(|function| &function.locals[index].ty), place)
    }

    fn place_text(&mut self, place: &Place, base: Span, default: Span, typed: bool) -> String {
        let mut text = self.local_name(place.root);
        let steps = Vec::with_capacity(place.steps.len());
        let mut inner = Place { root: place.root, steps, ty: Type::Unit, span: place.span };
        for step in &place.steps {
            match step {
                Step::Field(field) => {
                    let outer = self.place_type(&inner);
                    text = format!("{text}.{}", self.field(outer.as_ref(), *field));
                }
                Step::Index(at) => text = format!("{text}[{}]", self.tight(at, 0, base)),
                Step::From(at) => text = format!("{text}[{}..]", self.tight(at, 0, base)),
                Step::Element(row, col) => {
                    let (row, col) = (self.tight(row, 0, base), self.tight(col, 0, base));
                    text = format!("{text}[{row}, {col}]");
                }
            }
            inner.steps.push(step.clone());
        }
        text += &relative(place.span, default, base);
        if typed && self.place_type(place).as_ref() != Some(&place.ty) {
            text = format!("{text} : {}", self.ty(&place.ty));
        }
        text
    }

    /// Returns the name of a field if it is unique, else its index.
    fn field(&self, ty: Option<&Type>, index: u32) -> String {
        let fields = match ty {
            Some(Type::Struct(id)) => {
                self.module.structs.get(id.index()).map_or(&[][..], |found| &found.fields)
            }
            _ => &[],
        };
        match fields.get(index as usize) {
            Some(field) if fields.iter().filter(|other| other.name == field.name).count() == 1 => {
                shown(&field.name)
            }
            _ => format!("#{index}"),
        }
    }

    fn literal(&self, word: u64, ty: &Type) -> Option<String> {
        match ty {
            Type::Scalar(Scalar::Bool) => match word {
                0 => Some("false".into()),
                1 => Some("true".into()),
                _ => None,
            },
            Type::Scalar(Scalar::Float(float)) => shown_float(word, *float),
            Type::Scalar(Scalar::Int(int)) => {
                let value = int.from_word(word);
                let fits = Int::min(*int) <= value && value <= Int::max(*int);
                let suffix = if *int == Int::Usize { "" } else { int.name() };
                fits.then(|| format!("{value}{suffix}"))
            }
            _ => self.variant(ty, Some(word)),
        }
    }

    fn prefixed(&mut self, op: UnaryOp, operand: &Expr, base: Span) -> String {
        let text = self.tight(operand, PREFIX, base);
        let mark = match op {
            UnaryOp::Neg => '-',
            UnaryOp::Not => '!',
        };
        // `-1.5` is a number; the negation of one is `-(1.5)`.
        if text.starts_with(|first: char| first.is_ascii_digit()) {
            format!("{mark}({text})")
        } else {
            format!("{mark}{text}")
        }
    }

    fn between(
        &mut self,
        op: Infix,
        left: &Expr,
        right: &Expr,
        ty: Option<Type>,
        base: Span,
    ) -> Draft {
        let (mark, binds) = infix(op);
        let span = left.span;
        let left = self.tight(left, if binds == COMPARE { binds + 1 } else { binds }, base);
        let right = self.tight(right, binds + 1, base);
        Draft { text: format!("{left} {mark} {right}"), binds, ty, span }
    }

    /// Returns `first.name(rest)`, or `name!()`.
    fn method(&mut self, name: &str, operands: &[Expr], base: Span) -> String {
        match operands {
            [] => format!("{name}!()"),
            [first, rest @ ..] => {
                let first = self.tight(first, ATOM, base);
                format!("{first}.{name}({})", self.list(rest, base))
            }
        }
    }

    fn list(&mut self, parts: &[Expr], base: Span) -> String {
        let parts: Vec<String> = parts.iter().map(|part| self.tight(part, 0, base)).collect();
        parts.join(", ")
    }

    fn arguments(&mut self, arguments: &[Argument], base: Span) -> String {
        let mut text = String::new();
        for argument in arguments {
            if !text.is_empty() {
                text += ", ";
            }
            match argument {
                Argument::Value(expr) => text += &self.tight(expr, 0, base),
                Argument::Ref(expr) => text += &format!("&{}", self.tight(expr, 0, base)),
                Argument::RefMut(place) => {
                    text += &format!("&mut {}", self.place_text(place, base, base, true));
                }
            }
        }
        text
    }

    /// Returns `struct Name { field: value }`, or a list whose type must be stated.
    fn struct_value(&mut self, parts: &[Expr], ty: &Type, base: Span) -> (String, Option<Type>) {
        let definition = match ty {
            Type::Struct(id) => self.module.structs.get(id.index()),
            _ => None,
        };
        let Some(definition) = definition.filter(|found| found.fields.len() == parts.len()) else {
            return (format!("struct({})", self.list(parts, base)), None);
        };
        let mut text = format!("struct {} {{", self.ty(ty));
        for (index, (field, part)) in definition.fields.iter().zip(parts).enumerate() {
            let gap = if index == 0 { " " } else { ", " };
            text += &format!("{gap}{}: {}", shown(&field.name), self.tight(part, 0, base));
        }
        (text + " }", Some(ty.clone()))
    }
}

/// Returns `<rows, cols>`, and the type that follows from it and from the element type.
fn stated(ty: &Type, element: Option<&Expr>) -> (String, Option<Type>) {
    let (text, rows, cols) = match ty {
        Type::Array { len, .. } => (format!("<{len}>"), *len, None),
        Type::Matrix { rows, cols, .. } => (format!("<{rows}, {cols}>"), *rows, Some(*cols)),
        _ => return (String::new(), None),
    };
    match element.and_then(|element| spread(&element.ty, rows, cols)) {
        Some(known) => (text, Some(known)),
        None => (String::new(), None),
    }
}
