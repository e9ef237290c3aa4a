//! Reads types, handles, the declarations of locals, and the words of constants.

use alloc::boxed::Box;
use alloc::format;
use alloc::string::String;
use alloc::vec::Vec;

use crate::ir::{EnumId, Local, LocalId, Mode, Span, StructId, Type};
use crate::kernel::{Kernel, KernelRoutine};
use crate::number::Scalar;

use super::lex::Token;
use super::parse::{Found, Parsed, Parser, define};
use super::print::TypeId;

/// A number in the text, before its type is known.
pub(super) enum Number {
    /// A word, `0x…`.
    Bits(u64),
    /// Digits, with the suffix of a type.
    Whole { magnitude: u128, suffix: String },
    /// A number with a point, an exponent or a float's suffix.
    Fraction { digits: String, single: bool },
}

impl Parser {
    pub fn ty(&mut self) -> Parsed<Type> {
        if self.eat("[") {
            let element = Box::new(self.nested(Parser::ty)?);
            if self.eat("]") {
                return Ok(Type::Slice(element));
            }
            self.expect(";")?;
            let len = self.number()?;
            self.expect("]")?;
            return Ok(Type::Array { element, len });
        }
        if self.eat_word("unit") {
            return Ok(Type::Unit);
        }
        if self.eat_word("matrix") {
            self.expect("<")?;
            let Some(element) = self.scalar() else {
                return self.fail("expected a scalar type");
            };
            self.expect(",")?;
            let rows = self.number()?;
            self.expect(",")?;
            let cols = self.number()?;
            self.expect(">")?;
            return Ok(Type::Matrix { element, rows, cols });
        }
        if let Some(scalar) = self.scalar() {
            return Ok(Type::Scalar(scalar));
        }
        Ok(match self.type_reference()? {
            TypeId::Struct(id) => Type::Struct(id),
            TypeId::Enum(id) => Type::Enum(id),
        })
    }

    /// Reads a kernel, such as `kernel lu_solve<f64, 6, 1>`.
    pub fn kernel(&mut self) -> Parsed<Kernel> {
        if !self.eat_word("kernel") {
            return self.fail("expected `kernel`");
        }
        let Some(routine) = KernelRoutine::from_name(&self.name()?) else {
            return self.fail("there is no such kernel");
        };
        self.expect("<")?;
        let Some(Scalar::Float(element)) = self.scalar() else {
            return self.fail("expected `f64` or `f32`");
        };
        let mut dims = Vec::new();
        while self.eat(",") {
            dims.push(self.number()?);
        }
        self.expect(">")?;
        Ok(Kernel { routine, element, dims })
    }

    fn scalar(&mut self) -> Option<Scalar> {
        let scalar = match self.peek() {
            Token::Name(name) => Scalar::from_name(name),
            _ => None,
        };
        if scalar.is_some() {
            self.bump();
        }
        scalar
    }

    /// Reads `Name`, `struct#3.Name` or `enum#3.Name`.
    pub fn type_reference(&mut self) -> Parsed<TypeId> {
        if self.eat_word("struct") {
            let (id, name) = self.handle("#")?;
            let found = self.module.structs.get(id as usize).map(|found| found.name.clone());
            self.same(id, found, name)?;
            return Ok(TypeId::Struct(StructId(id)));
        }
        if self.eat_word("enum") {
            let (id, name) = self.handle("#")?;
            let found = self.module.enums.get(id as usize).map(|found| found.name.clone());
            self.same(id, found, name)?;
            return Ok(TypeId::Enum(EnumId(id)));
        }
        let unknown = self.error("no such type is defined above");
        let name = self.name()?;
        match self.types.get(&name) {
            Some(Found::One(id)) => Ok(*id),
            Some(Found::Many) => self.fail(format!("`{name}` is ambiguous: use its handle")),
            None => Err(unknown),
        }
    }

    /// Reads a handle, `#3.name`; `_` in place of the name means that it has none.
    pub fn handle(&mut self, sigil: &str) -> Parsed<(u32, Option<String>)> {
        self.expect(sigil)?;
        let id = self.number()?;
        self.expect(".")?;
        Ok((id, if self.eat_word("_") { None } else { Some(self.name()?) }))
    }

    /// Checks that the name beside a handle is right, if its definition is known.
    pub fn same(&self, id: u32, found: Option<String>, name: Option<String>) -> Parsed<()> {
        match found {
            Some(found) if Some(&found) != name.as_ref() => {
                self.fail(format!("handle {id} is called `{found}`"))
            }
            _ => Ok(()),
        }
    }

    /// Reads `name: type@span`, which declares a local, or `name`, which refers to one. Returns true for a
    /// declaration.
    pub fn binding(&mut self, base: Span) -> Parsed<(LocalId, bool)> {
        if self.sees("%") {
            let error = self.error("");
            let (id, name) = self.handle("%")?;
            if let (true, Some(name)) = (self.sees(":"), &name) {
                return self.declare(LocalId(id), name.clone(), base);
            }
            return Ok((self.known_local(id, name, error)?, false));
        }
        let unknown = self.error("no such local is declared above");
        let name = self.name()?;
        if self.sees(":") {
            return self.declare(LocalId(self.locals.next), name, base);
        }
        match self.locals.names.get(&name) {
            Some(Found::One(id)) => Ok((*id, false)),
            Some(Found::Many) => self.fail(format!("`{name}` is ambiguous: use its handle")),
            None => Err(unknown),
        }
    }

    /// Returns a local by its handle; its name is checked now, or at the end of the function.
    pub fn known_local(
        &mut self,
        id: u32,
        name: Option<String>,
        error: super::ParseError,
    ) -> Parsed<LocalId> {
        match self.locals.known.get(&id).map(|local| local.name.clone()) {
            None => self.locals.ahead.push((id, name, error)),
            found => self.same(id, found, name)?,
        }
        Ok(LocalId(id))
    }

    fn declare(&mut self, id: LocalId, name: String, base: Span) -> Parsed<(LocalId, bool)> {
        self.expect(":")?;
        let mode = match (self.eat("&"), self.sees_word("mut")) {
            (false, _) => Mode::Value,
            (true, false) => Mode::Ref,
            (true, true) => {
                self.bump();
                Mode::RefMut
            }
        };
        let ty = self.ty()?;
        let span = self.span(base)?.unwrap_or(base);
        let local = Local { name: name.clone(), ty, mode, span };
        if self.locals.known.insert(id.0, local).is_some() {
            return self.fail(format!("local {} is declared twice", id.0));
        }
        define(&mut self.locals.names, name, id);
        self.locals.next = id.0.wrapping_add(1);
        Ok((id, true))
    }

    /// Reads a number, if it is next.
    pub fn take_number(&mut self) -> Parsed<Option<Number>> {
        let Token::Number { digits, suffix } = self.peek() else { return Ok(None) };
        let single = suffix == "f32";
        let float =
            single || suffix == "f64" || (suffix.is_empty() && digits.contains(['.', 'e', 'E']));
        let number = match digits.strip_prefix("0x") {
            Some(hex) if suffix.is_empty() => u64::from_str_radix(hex, 16).ok().map(Number::Bits),
            Some(_) => None,
            None if float => Some(Number::Fraction { digits: digits.clone(), single }),
            None => (digits.parse().ok())
                .map(|magnitude| Number::Whole { magnitude, suffix: suffix.clone() }),
        };
        if number.is_none() {
            return self.fail("no such number");
        }
        self.bump();
        Ok(number)
    }

    /// Reads a word of a constant.
    pub fn word(&mut self) -> Parsed<u64> {
        if self.eat_word("true") {
            return Ok(1);
        }
        if self.eat_word("false") {
            return Ok(0);
        }
        let negative = self.eat("-");
        let word = match self.take_number()? {
            Some(Number::Bits(word)) if !negative => Some(word),
            Some(Number::Whole { magnitude, suffix }) if suffix.is_empty() => {
                match signed(negative, magnitude) {
                    Some(value) if negative => i64::try_from(value).ok().map(|value| value as u64),
                    Some(value) => u64::try_from(value).ok(),
                    None => None,
                }
            }
            Some(Number::Fraction { digits, single }) => float(negative, &digits, single),
            _ => None,
        };
        word.map_or_else(|| self.fail("expected a word: a number, `true` or `false`"), Ok)
    }
}

/// Returns the value of an integer, if it is in range.
pub(super) fn signed(negative: bool, magnitude: u128) -> Option<i128> {
    if negative { 0i128.checked_sub_unsigned(magnitude) } else { i128::try_from(magnitude).ok() }
}

/// Returns the word of a float.
pub(super) fn float(negative: bool, digits: &str, single: bool) -> Option<u64> {
    if single {
        let value: f32 = digits.parse().ok()?;
        Some(u64::from((if negative { -value } else { value }).to_bits()))
    } else {
        let value: f64 = digits.parse().ok()?;
        Some((if negative { -value } else { value }).to_bits())
    }
}
