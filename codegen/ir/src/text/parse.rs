//! Parser: the shared parts, and the items of a module.
//!
//! Invariants: every loop consumes a token or ends; nesting is limited.

use alloc::collections::BTreeMap;
use alloc::format;
use alloc::string::{String, ToString};
use alloc::vec::Vec;

use crate::attributes::{Attributes, Given, Inlining, Range};
use crate::ir::{
    Block, Const, ConstId, Enum, EnumId, Field, Form, Function, FunctionId, Local, LocalId, Module,
    Owner, Role, Span, Struct, StructId, Type, Variant,
};

use crate::tree::Site;

use super::MAX_NESTING;
use super::lex::{Lexeme, ParseError, Token, lex};
use super::names::is_word;
use super::print::{TypeId, owner_id};
use super::scope::Scope;

/// Largest count of one `word * count`.
pub(super) const LONGEST_RUN: usize = 1 << 16;

pub(super) type Parsed<T> = Result<T, ParseError>;

/// Reads the text form of a module.
pub fn parse(text: &str) -> Parsed<Module> {
    let mut parser = Parser {
        lexemes: lex(text)?,
        at: 0,
        comments: Vec::new(),
        nesting: 0,
        module: Module::default(),
        types: BTreeMap::new(),
        consts: BTreeMap::new(),
        functions: BTreeMap::new(),
        locals: Locals::default(),
    };
    parser.skip_comments();
    parser.items()?;
    Ok(parser.module)
}

/// Meaning of a name without a handle.
#[derive(Clone, Copy)]
pub(super) enum Found<T> {
    One(T),
    Many,
}

/// Names and their meanings, in the text read so far.
pub(super) type Names<K, T> = BTreeMap<K, Found<T>>;

pub(super) struct Parser {
    lexemes: Vec<Lexeme>,
    at: usize,
    /// Comment lines directly before the next token.
    comments: Vec<String>,
    nesting: u32,
    pub module: Module,
    pub types: Names<String, TypeId>,
    pub consts: Names<String, ConstId>,
    pub functions: Names<(Option<TypeId>, String), FunctionId>,
    pub locals: Locals,
}

/// Locals of the function that is being read.
#[derive(Default)]
pub(super) struct Locals {
    pub known: BTreeMap<u32, Local>,
    pub names: Names<String, LocalId>,
    pub next: u32,
    /// References to locals before their declarations, which are checked at the end.
    pub ahead: Vec<(u32, Option<String>, ParseError)>,
}

/// Adds a definition to the names.
pub(super) fn define<K: Ord, T>(names: &mut Names<K, T>, name: K, id: T) {
    names.entry(name).and_modify(|found| *found = Found::Many).or_insert(Found::One(id));
}

impl Parser {
    pub fn scope(&self) -> Scope<'_> {
        Scope { module: &self.module, functions: self.module.functions.len() }
    }

    /// Returns the token `ahead` positions later, without comments.
    pub fn ahead(&self, ahead: usize) -> &Token {
        let rest = self.lexemes[self.at..].iter().map(|lexeme| &lexeme.token);
        let mut rest = rest.filter(|token| !matches!(token, Token::Comment(_)));
        rest.nth(ahead).unwrap_or(&Token::End)
    }

    pub fn peek(&self) -> &Token {
        &self.lexemes[self.at].token
    }

    /// Advances to the next token, unless at the end.
    pub fn bump(&mut self) -> Token {
        let token = self.peek().clone();
        if token != Token::End {
            self.at += 1;
            self.comments.clear();
            self.skip_comments();
        }
        token
    }

    fn skip_comments(&mut self) {
        while let Token::Comment(line) = &self.lexemes[self.at].token {
            self.comments.push(line.clone());
            self.at += 1;
        }
    }

    /// Removes and returns the comment lines directly before the next token.
    pub fn take_comments(&mut self) -> Vec<String> {
        core::mem::take(&mut self.comments)
    }

    pub fn error(&self, message: impl Into<String>) -> ParseError {
        let Lexeme { line, column, .. } = self.lexemes[self.at];
        ParseError { line, column, message: message.into() }
    }

    pub fn fail<T>(&self, message: impl Into<String>) -> Parsed<T> {
        Err(self.error(message))
    }

    pub fn sees(&self, mark: &str) -> bool {
        matches!(self.peek(), Token::Mark(found) if *found == mark)
    }

    pub fn sees_word(&self, word: &str) -> bool {
        matches!(self.peek(), Token::Name(found) if found == word)
    }

    /// Consumes the mark if it is next.
    pub fn eat(&mut self, mark: &str) -> bool {
        let found = self.sees(mark);
        if found {
            self.bump();
        }
        found
    }

    /// Consumes the keyword if it is next.
    pub fn eat_word(&mut self, word: &str) -> bool {
        let found = self.sees_word(word);
        if found {
            self.bump();
        }
        found
    }

    pub fn expect(&mut self, mark: &str) -> Parsed<()> {
        if self.eat(mark) { Ok(()) } else { self.fail(format!("expected `{mark}`")) }
    }

    pub fn expect_word(&mut self, word: &str) -> Parsed<()> {
        if self.eat_word(word) { Ok(()) } else { self.fail(format!("expected `{word}`")) }
    }

    /// Reads a name of the author's.
    pub fn name(&mut self) -> Parsed<String> {
        match self.peek() {
            Token::Quoted(_) => {}
            Token::Name(name) if !is_word(name) => {}
            _ => return self.fail("expected a name"),
        }
        match self.bump() {
            Token::Quoted(name) | Token::Name(name) => Ok(name),
            _ => self.fail("expected a name"),
        }
    }

    /// Reads a number of 32 bits.
    pub fn number(&mut self) -> Parsed<u32> {
        if let Token::Number { digits, suffix } = self.peek()
            && suffix.is_empty()
            && let Ok(number) = digits.parse()
        {
            self.bump();
            return Ok(number);
        }
        self.fail("expected a whole number below 2^32")
    }

    /// Reads a number of 64 bits.
    fn long(&mut self) -> Parsed<u64> {
        if let Token::Number { digits, suffix } = self.peek()
            && suffix.is_empty()
            && let Ok(word) = digits.parse()
        {
            self.bump();
            return Ok(word);
        }
        self.fail("expected a whole number below 2^64")
    }

    /// Reads the number of a variant.
    fn value(&mut self) -> Parsed<i32> {
        let negative = self.eat("-");
        if let Token::Number { digits, suffix } = self.peek()
            && suffix.is_empty()
            && let Ok(magnitude) = digits.parse::<i64>()
            && let Ok(value) = i32::try_from(if negative { -magnitude } else { magnitude })
        {
            self.bump();
            return Ok(value);
        }
        self.fail("expected a whole number of 32 bits")
    }

    /// Reads one nesting level deeper.
    pub fn nested<T>(&mut self, read: impl FnOnce(&mut Parser) -> Parsed<T>) -> Parsed<T> {
        if self.nesting >= MAX_NESTING {
            return self.fail(format!("nested deeper than {MAX_NESTING} levels"));
        }
        self.nesting += 1;
        let result = read(self);
        self.nesting -= 1;
        result
    }

    /// Reads a span, `@column`, `@line:column` or `@file:line:column`, if it is next; missing parts are those of
    /// `base`.
    pub fn span(&mut self, base: Span) -> Parsed<Option<Span>> {
        if !self.eat("@") {
            return Ok(None);
        }
        let mut parts = [0; 3];
        let mut count = 0;
        loop {
            parts[count] = self.number()?;
            count += 1;
            if count == 3 || !self.sees(":") || !matches!(self.ahead(1), Token::Number { .. }) {
                break;
            }
            self.bump();
        }
        Ok(Some(match (count, parts) {
            (1, [column, ..]) => Span { column, ..base },
            (2, [line, column, _]) => Span { file: base.file, line, column },
            (_, [file, line, column]) => Span { file, line, column },
        }))
    }

    fn docs(&mut self) -> Vec<String> {
        let mut docs = Vec::new();
        while let Token::Doc(line) = self.peek() {
            docs.push(line.clone());
            self.bump();
        }
        docs
    }

    fn items(&mut self) -> Parsed<()> {
        if self.eat_word("module") {
            self.module.name = self.name()?;
        }
        while *self.peek() != Token::End {
            let docs = self.docs();
            if self.eat_word("file") {
                let Token::Quoted(file) = self.bump() else {
                    return self.fail("expected a file's path in quotes");
                };
                if !docs.is_empty() {
                    self.module.about.insert(file.clone(), docs);
                }
                self.module.files.push(file);
                continue;
            }
            let span = self.span(Span::default())?.unwrap_or_default();
            if let Some(written) = self.spelling()? {
                let word = self.long()?;
                self.module.written.insert((span, word), written);
            } else if self.eat_word("struct") {
                self.structure(docs, span)?;
            } else if self.eat_word("enum") {
                self.enumeration(docs, span)?;
            } else if self.eat_word("const") {
                self.constant(docs, span)?;
            } else {
                self.function(docs, span)?;
            }
        }
        Ok(())
    }

    /// Reads ` in module`.
    fn home(&mut self) -> Parsed<String> {
        let mut home = String::new();
        if self.eat_word("in") {
            home = self.name()?;
            while self.eat("::") {
                home = home + "::" + &self.name()?;
            }
        }
        Ok(home)
    }

    fn structure(&mut self, docs: Vec<String>, span: Span) -> Parsed<()> {
        let name = self.name()?;
        let module = self.home()?;
        let form = self.form()?;
        let given = self.given()?;
        let mut fields = Vec::new();
        self.expect("{")?;
        while !self.eat("}") {
            let docs = self.docs();
            let name = self.name()?;
            self.expect(":")?;
            let ty = self.ty()?;
            let given = self.given()?;
            fields.push(Field { name, docs, ty, given });
            if !self.eat(",") && !self.sees("}") {
                return self.fail("expected `,` or `}`");
            }
        }
        let initial = if self.eat("=") { Some(self.words()?) } else { None };
        let defaults = if self.eat_word("default") { Some(self.words()?) } else { None };
        let id = TypeId::Struct(StructId(self.module.structs.len() as u32));
        define(&mut self.types, name.clone(), id);
        let item = Struct { name, module, docs, fields, form, initial, defaults, given, span };
        self.module.structs.push(item);
        Ok(())
    }

    fn form(&mut self) -> Parsed<Form> {
        if self.eat_word("sequence") {
            return Ok(Form::Sequence);
        }
        if self.eat_word("lent") {
            return Ok(Form::Lent);
        }
        if self.eat_word("shared") {
            return Ok(Form::Shared);
        }
        if !self.eat_word("choice") {
            return Ok(Form::Record);
        }
        self.expect("(")?;
        let mut chosen = Vec::new();
        while !self.eat(")") {
            chosen.push(if self.eat("-") { None } else { Some(self.number()?) });
            if !self.eat(",") && !self.sees(")") {
                return self.fail("expected `,` or `)`");
            }
        }
        Ok(Form::Choice(chosen))
    }

    fn enumeration(&mut self, docs: Vec<String>, span: Span) -> Parsed<()> {
        let name = self.name()?;
        let module = self.home()?;
        let given = self.given()?;
        let mut variants = Vec::new();
        self.expect("{")?;
        while !self.eat("}") {
            let docs = self.docs();
            let name = self.name()?;
            let value = match self.eat("=") {
                true => self.value()?,
                false => i32::try_from(variants.len()).unwrap_or(i32::MAX),
            };
            let given = self.given()?;
            variants.push(Variant { name, docs, value, given });
            if !self.eat(",") && !self.sees("}") {
                return self.fail("expected `,` or `}`");
            }
        }
        let id = TypeId::Enum(EnumId(self.module.enums.len() as u32));
        define(&mut self.types, name.clone(), id);
        self.module.enums.push(Enum { name, module, docs, variants, given, span });
        Ok(())
    }

    fn constant(&mut self, docs: Vec<String>, span: Span) -> Parsed<()> {
        let name = self.name()?;
        let module = self.home()?;
        self.expect(":")?;
        let ty = self.ty()?;
        let given = self.given()?;
        self.expect("=")?;
        let words = if self.sees("[") { self.words()? } else { alloc::vec![self.word()?] };
        let id = ConstId(self.module.consts.len() as u32);
        define(&mut self.consts, name.clone(), id);
        self.module.consts.push(Const { name, module, ty, words, docs, given, span });
        Ok(())
    }

    /// Reads `[word, word * count, …]`.
    fn words(&mut self) -> Parsed<Vec<u64>> {
        let mut words = Vec::new();
        self.expect("[")?;
        while !self.eat("]") {
            let word = self.word()?;
            let count = if self.eat("*") { self.number()? as usize } else { 1 };
            if count > LONGEST_RUN {
                return self.fail(format!("at most {LONGEST_RUN} words at once"));
            }
            words.resize(words.len() + count, word);
            if !self.eat(",") && !self.sees("]") {
                return self.fail("expected `,` or `]`");
            }
        }
        Ok(words)
    }

    fn function(&mut self, docs: Vec<String>, span: Span) -> Parsed<()> {
        let role = if self.eat_word("entry") {
            Role::Entry { infallible: self.eat_word("infallible") }
        } else if self.eat_word("private") {
            if self.eat_word("inline") { Role::Inline { public: false } } else { Role::Private }
        } else if self.eat_word("inline") {
            Role::Inline { public: true }
        } else {
            Role::Public
        };
        let attributes = self.attributes()?;
        if !self.eat_word("fn") {
            return self.fail("expected `struct`, `enum`, `const` or `fn`");
        }
        let owner = match matches!(self.peek(), Token::Name(word) if is_word(word))
            || matches!(self.ahead(1), Token::Mark("::"))
        {
            true => {
                let owner = self.type_id()?;
                self.expect("::")?;
                Some(owner)
            }
            false => None,
        };
        let name = self.name()?;
        let module = self.home()?;
        self.locals = Locals::default();
        let params = self.parameters(span)?;
        let result = if self.eat("->") { self.ty()? } else { Type::Unit };
        let result_name = if self.eat_word("as") { self.name()? } else { String::new() };
        let kernel = if self.eat("=") { Some(self.kernel()?) } else { None };
        let body = self.body(span)?;
        let locals = self.finish_locals()?;
        let id = FunctionId(self.module.functions.len() as u32);
        define(&mut self.functions, (owner.map(owner_id), name.clone()), id);
        self.module.functions.push(Function {
            name,
            module,
            owner,
            role,
            attributes,
            docs,
            locals,
            params,
            result,
            result_name,
            body,
            kernel,
            span,
        });
        Ok(())
    }

    /// Reads attributes, such as `#name "servo_set" #never_inline`.
    fn attributes(&mut self) -> Parsed<Attributes> {
        let mut attributes = Attributes::default();
        while self.eat("#") {
            match self.name()?.as_str() {
                "name" => attributes.name = Some(self.name()?),
                "section" => attributes.section = Some(self.name()?),
                "external" => attributes.external = Some(self.name()?),
                "never_inline" => attributes.inlining = Inlining::Never,
                "always_inline" => attributes.inlining = Inlining::Always,
                "atomic" => attributes.atomic = true,
                "single" => attributes.single = true,
                "parameter" => attributes.parameters.push((self.name()?, self.given()?)),
                "result" => attributes.result = self.given()?,
                _ => return self.fail("expected the name of an attribute before this"),
            }
        }
        Ok(attributes)
    }

    /// Reads a range, such as `"0.0" "5.0"`.
    fn range(&mut self) -> Parsed<Range> {
        let ends = [self.name()?.parse(), self.name()?.parse()];
        let range = if let [Ok(low), Ok(high)] = ends { Range::new(low, high) } else { None };
        range.map_or_else(|| self.fail("expected two finite numbers in order before this"), Ok)
    }

    /// Reads an item's attributes, `#(name "x" measured "m/s" @12:3)`, if they are next.
    fn given(&mut self) -> Parsed<Given> {
        let (mut item, mut range) = (Given::default(), None);
        if !self.sees("#") || *self.ahead(1) != Token::Mark("(") {
            return Ok(item);
        }
        self.bump();
        self.expect("(")?;
        while !self.eat("@") {
            let said = match self.name()?.as_str() {
                "name" => &mut item.name,
                "measured" => &mut item.unit,
                "section" => &mut item.section,
                "expression" => &mut item.expression,
                word @ ("clamped" | "reported") => {
                    range = range.map(|it: Range| it.enforced_as(word));
                    continue;
                }
                "range" => {
                    range = Some(self.range()?);
                    continue;
                }
                word @ ("public" | "hexadecimal" | "fallback") => {
                    *match word {
                        "public" => &mut item.public,
                        "hexadecimal" => &mut item.hexadecimal,
                        _ => &mut item.fallback,
                    } = true;
                    continue;
                }
                word @ ("size" | "axis") => {
                    let list = if word == "size" { &mut item.sizes } else { &mut item.axes };
                    list.push(self.name()?);
                    continue;
                }
                _ => {
                    return self.fail("expected what is said of an item before this");
                }
            };
            *said = Some(self.name()?);
        }
        item.range = range;
        let line = self.number()?;
        self.expect(":")?;
        item.site = Site(line, self.number()?);
        self.expect(")")?;
        Ok(item)
    }

    /// Reads the struct or enum to which a function belongs.
    fn type_id(&mut self) -> Parsed<Owner> {
        Ok(match self.type_reference()? {
            TypeId::Struct(id) => Owner::Struct(id),
            TypeId::Enum(id) => Owner::Enum(id),
        })
    }

    fn parameters(&mut self, span: Span) -> Parsed<u32> {
        self.expect("(")?;
        let mut params = 0;
        while !self.eat(")") {
            if self.binding(span)? != (LocalId(params), true) {
                return self.fail("parameters are declared in order, each with its type");
            }
            params += 1;
            if !self.eat(",") && !self.sees(")") {
                return self.fail("expected `,` or `)`");
            }
        }
        Ok(params)
    }

    fn body(&mut self, span: Span) -> Parsed<Block> {
        self.expect("{")?;
        while self.eat_word("var") {
            if !self.binding(span)?.1 {
                return self.fail("`var` declares a local with its type");
            }
            self.expect(";")?;
        }
        self.statements(span)
    }

    /// Returns the table of locals, or an error if one is missing.
    fn finish_locals(&mut self) -> Parsed<Vec<Local>> {
        let Locals { known, ahead, .. } = core::mem::take(&mut self.locals);
        for (id, name, mut error) in ahead {
            let found = known.get(&id).map(|local| &local.name);
            if found != name.as_ref() {
                error.message = match found {
                    Some(found) => format!("local {id} is called `{found}`"),
                    None => format!("there is no local {id}"),
                };
                return Err(error);
            }
        }
        let count = known.len();
        if let Some(gap) = (0..count as u32).find(|id| !known.contains_key(id)) {
            return self
                .fail(format!("local {gap} is not declared, yet later ones are").to_string());
        }
        Ok(known.into_values().collect())
    }
}
