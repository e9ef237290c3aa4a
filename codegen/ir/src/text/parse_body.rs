//! Reads statements.

use alloc::vec::Vec;

use crate::ir::{Arm, Block, Span, Stmt, StmtKind};

use super::lex::Token;
use super::names::fault;
use super::parse::{Parsed, Parser};
use super::parse_type::{Number, signed};

impl Parser {
    /// Reads statements up to and including the `}`.
    pub fn statements(&mut self, around: Span) -> Parsed<Block> {
        let mut stmts = Vec::new();
        while !self.eat("}") {
            stmts.push(self.stmt(around)?);
        }
        Ok(Block(stmts))
    }

    fn block(&mut self, base: Span) -> Parsed<Block> {
        self.expect("{")?;
        self.nested(|parser| parser.statements(base))
    }

    fn stmt(&mut self, around: Span) -> Parsed<Stmt> {
        let comments = self.take_comments();
        let span = self.span(around)?.unwrap_or(around);
        let word = match self.peek() {
            Token::Name(word) => word.clone(),
            _ => Default::default(),
        };
        let kind = match word.as_str() {
            "let" => self.declaration(span),
            "if" => self.conditional(span),
            "match" => self.matching(span),
            "for" => self.repeat(span),
            "check" => self.check(span),
            "return" => {
                self.bump();
                let value = if self.sees(";") { None } else { Some(self.expr(span)?) };
                self.end(StmtKind::Return(value))
            }
            "break" => {
                self.bump();
                self.end(StmtKind::Break)
            }
            "continue" => {
                self.bump();
                self.end(StmtKind::Continue)
            }
            _ => self.assignment(span),
        };
        Ok(Stmt { kind: kind?, span, comments })
    }

    fn end(&mut self, kind: StmtKind) -> Parsed<StmtKind> {
        self.expect(";")?;
        Ok(kind)
    }

    fn declaration(&mut self, base: Span) -> Parsed<StmtKind> {
        self.bump();
        let (local, _) = self.binding(base)?;
        let value = if self.eat("=") { Some(self.expr(base)?) } else { None };
        self.end(StmtKind::Let { local, value })
    }

    /// Reads `place = value;` or `expression;`.
    fn assignment(&mut self, base: Span) -> Parsed<StmtKind> {
        let draft = self.draft(base)?;
        if !self.sees("=") && !self.sees(":") {
            let kind = StmtKind::Expr(self.settle(draft)?.0);
            return self.end(kind);
        }
        let place = self.target(draft)?;
        self.expect("=")?;
        let value = self.expr(base)?;
        self.end(StmtKind::Assign { place, value })
    }

    fn conditional(&mut self, base: Span) -> Parsed<StmtKind> {
        self.bump();
        let condition = self.expr(base)?;
        let then = self.block(base)?;
        let otherwise = if self.eat_word("else") { self.block(base)? } else { Block::default() };
        Ok(StmtKind::If { condition, then, otherwise })
    }

    fn matching(&mut self, base: Span) -> Parsed<StmtKind> {
        self.bump();
        let scrutinee = self.expr(base)?;
        self.expect("{")?;
        let mut arms = Vec::new();
        let mut otherwise = None;
        while !self.eat("}") {
            if otherwise.is_some() {
                return self.fail("`_` is the last arm");
            }
            if self.eat_word("_") {
                self.expect("=>")?;
                otherwise = Some(self.block(base)?);
                continue;
            }
            let mut values = Vec::new();
            while !self.eat("=>") {
                values.push(self.pattern()?);
                if !self.eat(",") && !self.sees("=>") {
                    return self.fail("expected `,` or `=>`");
                }
            }
            arms.push(Arm { values, body: self.block(base)? });
        }
        Ok(StmtKind::Match { scrutinee, arms, otherwise })
    }

    /// Reads an integer, or a variant such as `Mode::Hover`.
    fn pattern(&mut self) -> Parsed<i128> {
        let negative = self.eat("-");
        if negative || matches!(self.peek(), Token::Number { .. }) {
            let value = match self.take_number()? {
                Some(Number::Whole { magnitude, suffix }) if suffix.is_empty() => {
                    signed(negative, magnitude)
                }
                _ => None,
            };
            return value.map_or_else(|| self.fail("expected a whole number"), Ok);
        }
        let ty = self.type_reference()?;
        self.expect("::")?;
        Ok(i128::from(self.variant(ty)?.1))
    }

    fn repeat(&mut self, base: Span) -> Parsed<StmtKind> {
        self.bump();
        let (variable, _) = self.binding(base)?;
        self.expect_word("in")?;
        let reversed = self.eat_word("rev");
        let from = self.expr(base)?;
        let inclusive = self.eat("..=");
        if !inclusive {
            self.expect("..")?;
        }
        let to = self.expr(base)?;
        let ended = self.eat_word("while");
        let unroll = if self.eat("#") { Some(self.number()?) } else { None };
        let body = self.block(base)?;
        Ok(StmtKind::For { variable, from, to, inclusive, reversed, unroll, ended, body })
    }

    fn check(&mut self, base: Span) -> Parsed<StmtKind> {
        self.bump();
        let condition = self.expr(base)?;
        self.expect_word("else")?;
        let found = match self.peek() {
            Token::Name(name) => fault(name),
            _ => None,
        };
        let Some(fault) = found else { return self.fail("expected the name of a fault") };
        self.bump();
        self.end(StmtKind::Check { condition, fault })
    }
}
