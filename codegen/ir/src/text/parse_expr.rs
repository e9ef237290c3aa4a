//! Reads expressions and places: operators by precedence, everything else by recursive descent.
//!
//! Invariant: no expression exceeds [`MAX_HEIGHT`], so dropping, printing or visiting it cannot overflow the stack.

use alloc::boxed::Box;
use alloc::format;
use alloc::string::String;
use alloc::vec::Vec;

use crate::ir::{
    Argument, ConstId, EnumId, Expr, ExprKind, FunctionId, LocalId, Place, Span, Step, Type,
    UnaryOp,
};
use crate::number::{Int, Scalar};
use crate::written::Written;

use super::MAX_HEIGHT;
use super::lex::Token;
use super::names::{CAST, COMPARE, INFIX, Infix, intrinsic, routine};
use super::parse::{Found, Parsed, Parser};
use super::parse_type::{Number, float, signed};
use super::print::TypeId;
use super::scope::spread;

/// An expression whose type may still follow in the text.
pub(super) struct Draft {
    kind: ExprKind,
    ty: Option<Type>,
    span: Span,
    height: u32,
    /// True for a place without parentheses: a type and a span after it are also the place's.
    plain: bool,
}

impl Draft {
    fn new(kind: ExprKind, ty: Option<Type>, span: Span, below: u32) -> Draft {
        Draft { kind, ty, span, height: below + 1, plain: false }
    }
}

impl Parser {
    /// Reads the spelling of a literal; none if another item follows.
    pub fn spelling(&mut self) -> Parsed<Option<Written>> {
        Ok(Some(if self.eat_word("hexadecimal") {
            Written::Hexadecimal
        } else if self.eat_word("constant") {
            Written::Constant(ConstId(self.number()?))
        } else if self.eat_word("variant") {
            Written::Variant(EnumId(self.number()?), self.number()?)
        } else {
            return Ok(None);
        }))
    }

    /// Reads an expression of a statement at `base`.
    pub fn expr(&mut self, base: Span) -> Parsed<Expr> {
        let draft = self.draft(base)?;
        Ok(self.settle(draft)?.0)
    }

    /// Reads an expression whose type may not follow from its operands.
    pub fn draft(&mut self, base: Span) -> Parsed<Draft> {
        self.infix(base, 0)
    }

    /// Returns a finished expression and its height.
    pub fn settle(&mut self, draft: Draft) -> Parsed<(Expr, u32)> {
        let Some(ty) = draft.ty else {
            return self.fail("the type does not follow from this: write `(expression : type)`");
        };
        if draft.height > MAX_HEIGHT {
            return self.fail(format!("more than {MAX_HEIGHT} levels of operands"));
        }
        Ok((Expr { kind: draft.kind, ty, span: draft.span }, draft.height))
    }

    /// Returns the place that an assignment writes, with the type stated after it.
    pub fn target(&mut self, draft: Draft) -> Parsed<Place> {
        let stated = if self.eat(":") { Some(self.ty()?) } else { None };
        match (draft.kind, stated.or(draft.ty)) {
            (ExprKind::Load(place), Some(ty)) if draft.plain => Ok(Place { ty, ..place }),
            (ExprKind::Load(_), None) => self.fail("the type of the place has to be stated"),
            _ => self.fail("only a place can be assigned"),
        }
    }

    fn infix(&mut self, base: Span, least: u8) -> Parsed<Draft> {
        let mut left = self.prefix(base)?;
        let mut compared = false;
        loop {
            if CAST >= least && self.eat_word("as") {
                let ty = self.ty()?;
                let (operand, height) = self.settle(left)?;
                let span = operand.span;
                left = Draft::new(ExprKind::Cast(Box::new(operand)), Some(ty), span, height);
                continue;
            }
            let Token::Mark(mark) = *self.peek() else { return Ok(left) };
            let Some(&(_, op, binds)) = INFIX.iter().find(|entry| entry.0 == mark) else {
                return Ok(left);
            };
            if binds < least {
                return Ok(left);
            }
            if compared && binds == COMPARE {
                return self.fail("comparisons do not chain");
            }
            compared = binds == COMPARE;
            self.bump();
            let right = self.infix(base, binds + 1)?;
            left = self.combine(op, left, right)?;
        }
    }

    fn combine(&mut self, op: Infix, left: Draft, right: Draft) -> Parsed<Draft> {
        let (left, left_height) = self.settle(left)?;
        let (right, right_height) = self.settle(right)?;
        let (span, left, right) = (left.span, Box::new(left), Box::new(right));
        let kind = match op {
            Infix::Binary(op) => ExprKind::Binary(op, left, right),
            Infix::Compare(op) => ExprKind::Compare(op, left, right),
            Infix::Logic(op) => ExprKind::Logic(op, left, right),
        };
        let ty = self.scope().expr(&kind);
        Ok(Draft::new(kind, ty, span, left_height.max(right_height)))
    }

    fn prefix(&mut self, base: Span) -> Parsed<Draft> {
        let op = match self.peek() {
            Token::Mark("-") if matches!(self.ahead(1), Token::Number { .. }) => {
                return self.postfix(base);
            }
            Token::Mark("-") => UnaryOp::Neg,
            Token::Mark("!") => UnaryOp::Not,
            _ => return self.postfix(base),
        };
        self.bump();
        let operand = self.nested(|parser| parser.prefix(base))?;
        let (operand, height) = self.settle(operand)?;
        let kind = ExprKind::Unary(op, Box::new(operand));
        let ty = self.scope().expr(&kind);
        Ok(Draft::new(kind, ty, base, height))
    }

    /// Reads a primary expression, its span, and methods on it.
    fn postfix(&mut self, base: Span) -> Parsed<Draft> {
        let mut draft = self.primary(base)?;
        loop {
            if let Some(span) = self.span(base)? {
                draft.span = span;
                if let (true, ExprKind::Load(place)) = (draft.plain, &mut draft.kind) {
                    place.span = span;
                }
            }
            let method = match (self.peek(), self.ahead(1), self.ahead(2)) {
                (Token::Mark("."), Token::Name(name), Token::Mark("(")) => name.clone(),
                _ => return Ok(draft),
            };
            self.bump();
            let first = self.settle(draft)?;
            let span = first.0.span;
            draft = self.method(&method, Some(first), base)?;
            draft.span = span;
        }
    }

    /// Reads `name(operands)`, after the first operand and the point.
    fn method(&mut self, name: &str, first: Option<(Expr, u32)>, base: Span) -> Parsed<Draft> {
        let unknown = self.error(format!("there is no operation `{name}`"));
        self.bump();
        let (mut operands, mut height) = (Vec::new(), 0);
        if let Some((first, below)) = first {
            (operands, height) = (alloc::vec![first], below);
        }
        self.expect("(")?;
        let (rest, below) = self.list(base, ")")?;
        operands.extend(rest);
        let kind = match (intrinsic(name), routine(name)) {
            (Some(function), _) => ExprKind::Intrinsic(function, operands),
            (_, Some(what)) => ExprKind::Routine(what, operands),
            _ => return Err(unknown),
        };
        let ty = self.scope().expr(&kind);
        Ok(Draft::new(kind, ty, base, height.max(below)))
    }

    /// Reads expressions up to and including the closing mark; also returns the greatest height.
    fn list(&mut self, base: Span, close: &str) -> Parsed<(Vec<Expr>, u32)> {
        let (mut list, mut height) = (Vec::new(), 0);
        while !self.eat(close) {
            let draft = self.nested(|parser| parser.draft(base))?;
            let (expr, below) = self.settle(draft)?;
            list.push(expr);
            height = height.max(below);
            if !self.eat(",") && !self.sees(close) {
                return self.fail(format!("expected `,` or `{close}`"));
            }
        }
        Ok((list, height))
    }

    fn primary(&mut self, base: Span) -> Parsed<Draft> {
        let word = match self.peek() {
            Token::Mark("(") => return self.parenthesis(base),
            Token::Mark("[") => {
                self.bump();
                let (parts, height) = self.list(base, "]")?;
                let kind = ExprKind::Array(parts);
                let ty = self.scope().expr(&kind);
                return Ok(Draft::new(kind, ty, base, height));
            }
            Token::Mark("-") | Token::Number { .. } => return self.literal(base),
            Token::Mark("%") => {
                let error = self.error("");
                let (id, name) = self.handle("%")?;
                let id = self.known_local(id, name, error)?;
                return self.load(id, base);
            }
            Token::Mark("#") => {
                let (id, name) = self.handle("#")?;
                let found = self.module.functions.get(id as usize).map(|found| found.name.clone());
                self.same(id, found, name)?;
                return self.call(FunctionId(id), base);
            }
            Token::Name(word) => word.clone(),
            Token::Quoted(_) => return self.named(base),
            _ => return self.fail("expected an expression"),
        };
        match word.as_str() {
            "true" | "false" => {
                self.bump();
                let kind = ExprKind::Literal(u64::from(word == "true"));
                Ok(Draft::new(kind, Some(Type::BOOL), base, 0))
            }
            "struct" => self.struct_value(base),
            "splat" => self.splat(base),
            "matrix" => self.matrix(base),
            "load" => self.stated_load(base),
            "const" => {
                self.bump();
                let (id, name) = self.handle("#")?;
                let found = self.module.consts.get(id as usize).map(|found| found.name.clone());
                self.same(id, found, name)?;
                self.constant_value(ConstId(id), base)
            }
            "enum" => self.path(base),
            _ if *self.ahead(1) == Token::Mark("!") && *self.ahead(2) == Token::Mark("(") => {
                self.bump();
                self.method(&word, None, base)
            }
            _ => self.named(base),
        }
    }

    /// Reads `(expression)`, or `(expression : type)`.
    fn parenthesis(&mut self, base: Span) -> Parsed<Draft> {
        self.bump();
        let mut draft = self.nested(|parser| parser.draft(base))?;
        if self.eat(":") {
            let ty = self.ty()?;
            if let (true, ExprKind::Load(place)) = (draft.plain, &mut draft.kind) {
                place.ty = ty.clone();
            }
            draft.ty = Some(ty);
        }
        self.expect(")")?;
        Ok(draft)
    }

    fn literal(&mut self, base: Span) -> Parsed<Draft> {
        let wrong = self.error("no such number");
        let negative = self.eat("-");
        let literal = match self.take_number()? {
            Some(Number::Bits(word)) if !negative => Some((word, None)),
            Some(Number::Fraction { digits, single }) => float(negative, &digits, single)
                .map(|word| (word, Some(if single { Type::F32 } else { Type::F64 }))),
            Some(Number::Whole { magnitude, suffix }) => {
                let int = match Scalar::from_name(&suffix) {
                    Some(Scalar::Int(int)) => Some(int),
                    None if suffix.is_empty() => Some(Int::Usize),
                    _ => None,
                };
                int.zip(signed(negative, magnitude))
                    .filter(|(int, value)| Int::min(*int) <= *value && *value <= Int::max(*int))
                    .map(|(int, value)| (value as u64, Some(Type::Scalar(Scalar::Int(int)))))
            }
            _ => None,
        };
        match literal {
            Some((word, ty)) => Ok(Draft::new(ExprKind::Literal(word), ty, base, 0)),
            None => Err(wrong),
        }
    }

    /// Reads an expression that begins with an author's name: a call, a path, a local, a constant.
    fn named(&mut self, base: Span) -> Parsed<Draft> {
        match self.ahead(1) {
            Token::Mark("::") => return self.path(base),
            Token::Mark("(") => {
                let name = self.name()?;
                let id = self.function_named(None, name)?;
                return self.call(id, base);
            }
            _ => {}
        }
        let unknown = self.error("no local or constant of this name is declared above");
        let name = self.name()?;
        match (self.locals.names.get(&name), self.consts.get(&name)) {
            (Some(&Found::One(id)), _) => self.load(id, base),
            (None, Some(&Found::One(id))) => self.constant_value(id, base),
            (None, None) => Err(unknown),
            _ => self.fail(format!("`{name}` is ambiguous: use its handle")),
        }
    }

    fn function_named(&mut self, owner: Option<TypeId>, name: String) -> Parsed<FunctionId> {
        let key = (owner, name);
        match self.functions.get(&key) {
            Some(Found::One(id)) => Ok(*id),
            Some(Found::Many) => self.fail(format!("`{}` is ambiguous: use its handle", key.1)),
            None => self.fail(format!("no function `{}` is defined above", key.1)),
        }
    }

    /// Reads `Mode::Hover`, or `Pid::step(…)`.
    fn path(&mut self, base: Span) -> Parsed<Draft> {
        let ty = self.type_reference()?;
        self.expect("::")?;
        if *self.ahead(1) == Token::Mark("(") {
            let name = self.name()?;
            let id = self.function_named(Some(ty), name)?;
            return self.call(id, base);
        }
        let (ty, word) = self.variant(ty)?;
        Ok(Draft::new(ExprKind::Literal(word), Some(ty), base, 0))
    }

    /// Reads the name of a variant; returns the enum's type and the variant's word.
    pub fn variant(&mut self, ty: TypeId) -> Parsed<(Type, u64)> {
        let name = self.name()?;
        let TypeId::Enum(id) = ty else { return self.fail("a struct has no variants") };
        let variants = self.module.enums.get(id.index()).map_or(&[][..], |found| &found.variants);
        match variants.iter().position(|variant| variant.name == name) {
            Some(index) => Ok((Type::Enum(id), index as u64)),
            None => self.fail(format!("no variant `{name}` is defined above")),
        }
    }

    fn constant_value(&mut self, id: ConstId, base: Span) -> Parsed<Draft> {
        let kind = ExprKind::Const(id);
        let ty = self.scope().expr(&kind);
        Ok(Draft::new(kind, ty, base, 0))
    }

    /// Reads the steps of a place after its root, and returns its value.
    fn load(&mut self, root: LocalId, base: Span) -> Parsed<Draft> {
        let (place, ty, below) = self.place(root, base)?;
        let draft = Draft::new(ExprKind::Load(place), ty, base, below);
        Ok(Draft { plain: true, ..draft })
    }

    /// Reads a step in brackets after the opening one: `index]`, `row, column]` or `from..]`.
    fn step(&mut self, base: Span) -> Parsed<(Step, u32)> {
        let index = |parser: &mut Parser| {
            let draft = parser.nested(|parser| parser.draft(base))?;
            parser.settle(draft)
        };
        let (first, below) = index(self)?;
        if self.eat("..") {
            self.expect("]")?;
            return Ok((Step::From(first), below));
        }
        if !self.eat(",") {
            self.expect("]")?;
            return Ok((Step::Index(first), below));
        }
        let (column, behind) = index(self)?;
        self.expect("]")?;
        Ok((Step::Element(first, column), below.max(behind)))
    }

    /// Reads the steps of a place; returns its type, if it follows, and the height of its indices.
    fn place(&mut self, root: LocalId, base: Span) -> Parsed<(Place, Option<Type>, u32)> {
        let mut place = Place { root, steps: Vec::new(), ty: Type::Unit, span: base };
        let mut height = 0;
        loop {
            if self.eat("[") {
                let (step, below) = self.step(base)?;
                height = height.max(below);
                place.steps.push(step);
                continue;
            }
            let field = self.sees(".")
                && match self.ahead(1) {
                    Token::Mark("#") | Token::Quoted(_) => true,
                    Token::Name(_) => *self.ahead(2) != Token::Mark("("),
                    _ => false,
                };
            if !field {
                break;
            }
            self.bump();
            let field = self.field(&place)?;
            place.steps.push(Step::Field(field));
        }
        let known = self.place_type(&place);
        if let Some(ty) = &known {
            place.ty = ty.clone();
        }
        Ok((place, known, height))
    }

    fn place_type(&self, place: &Place) -> Option<Type> {
        let root = self.locals.known.get(&place.root.0);
        self.scope().place(root.map(|local| &local.ty), place)
    }

    /// Reads `name` or `#index`, a field of the struct at `place`.
    fn field(&mut self, place: &Place) -> Parsed<u32> {
        if self.eat("#") {
            return self.number();
        }
        let unknown = self.error("what is here has no such field");
        let name = self.name()?;
        let index = match self.place_type(place) {
            Some(Type::Struct(id)) => (self.module.structs.get(id.index()))
                .and_then(|found| found.fields.iter().position(|field| field.name == name)),
            _ => None,
        };
        index.map(|index| index as u32).ok_or(unknown)
    }

    /// Reads `load(place : type)`, for a place that differs from its value in span or type.
    fn stated_load(&mut self, base: Span) -> Parsed<Draft> {
        self.bump();
        self.expect("(")?;
        let (place, height) = self.stated_place(base)?;
        self.expect(")")?;
        let ty = Some(place.ty.clone());
        Ok(Draft::new(ExprKind::Load(place), ty, base, height))
    }

    /// Reads `place@span : type`.
    fn stated_place(&mut self, base: Span) -> Parsed<(Place, u32)> {
        let draft = self.nested(|parser| parser.postfix(base))?;
        let height = draft.height;
        if height > MAX_HEIGHT {
            return self.fail(format!("more than {MAX_HEIGHT} levels of operands"));
        }
        Ok((self.target(draft)?, height))
    }

    fn call(&mut self, id: FunctionId, base: Span) -> Parsed<Draft> {
        self.expect("(")?;
        let (mut arguments, mut height) = (Vec::new(), 0);
        while !self.eat(")") {
            let lent = self.eat("&");
            let argument = if lent && self.eat_word("mut") {
                let (place, below) = self.stated_place(base)?;
                height = height.max(below);
                Argument::RefMut(place)
            } else {
                let draft = self.nested(|parser| parser.draft(base))?;
                let (expr, below) = self.settle(draft)?;
                height = height.max(below);
                if lent { Argument::Ref(expr) } else { Argument::Value(expr) }
            };
            arguments.push(argument);
            if !self.eat(",") && !self.sees(")") {
                return self.fail("expected `,` or `)`");
            }
        }
        let kind = ExprKind::Call(id, arguments);
        let ty = self.scope().expr(&kind);
        Ok(Draft::new(kind, ty, base, height))
    }

    /// Reads `struct Name { field: value }`, or `struct(values)`.
    fn struct_value(&mut self, base: Span) -> Parsed<Draft> {
        self.bump();
        if self.eat("(") {
            let (parts, height) = self.list(base, ")")?;
            return Ok(Draft::new(ExprKind::Struct(parts), None, base, height));
        }
        let TypeId::Struct(id) = self.type_reference()? else {
            return self.fail("this is an enum");
        };
        let fields = self.module.structs.get(id.index()).map(|found| found.fields.as_slice());
        let names: Vec<String> =
            fields.unwrap_or(&[]).iter().map(|field| field.name.clone()).collect();
        let (mut parts, mut height) = (Vec::new(), 0);
        self.expect("{")?;
        for name in names {
            let wrong = self.error(format!("expected the field `{name}`"));
            if self.name()? != name {
                return Err(wrong);
            }
            self.expect(":")?;
            let draft = self.nested(|parser| parser.draft(base))?;
            let (part, below) = self.settle(draft)?;
            parts.push(part);
            height = height.max(below);
            if !self.eat(",") && !self.sees("}") {
                return self.fail("expected `,` or `}`");
            }
        }
        self.expect("}")?;
        Ok(Draft::new(ExprKind::Struct(parts), Some(Type::Struct(id)), base, height))
    }

    /// Reads `<rows>` or `<rows, cols>`, if it is next.
    fn dimensions(&mut self) -> Parsed<Option<(u32, Option<u32>)>> {
        if !self.eat("<") {
            return Ok(None);
        }
        let rows = self.number()?;
        let cols = if self.eat(",") { Some(self.number()?) } else { None };
        self.expect(">")?;
        Ok(Some((rows, cols)))
    }

    fn splat(&mut self, base: Span) -> Parsed<Draft> {
        self.bump();
        let dimensions = self.dimensions()?;
        self.expect("(")?;
        let draft = self.nested(|parser| parser.draft(base))?;
        let (part, height) = self.settle(draft)?;
        self.expect(")")?;
        let ty = dimensions.and_then(|(rows, cols)| spread(&part.ty, rows, cols));
        Ok(Draft::new(ExprKind::Splat(Box::new(part)), ty, base, height))
    }

    fn matrix(&mut self, base: Span) -> Parsed<Draft> {
        self.bump();
        let dimensions = self.dimensions()?;
        self.expect("(")?;
        let (parts, height) = self.list(base, ")")?;
        let ty = match (dimensions, parts.first()) {
            (Some((rows, cols @ Some(_))), Some(first)) => spread(&first.ty, rows, cols),
            _ => None,
        };
        Ok(Draft::new(ExprKind::Matrix(parts), ty, base, height))
    }
}
