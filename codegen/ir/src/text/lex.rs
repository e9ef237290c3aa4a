//! Lexer: converts text to tokens with their positions.
//!
//! Must not know: the grammar. Keywords are names here.

use alloc::format;
use alloc::string::{String, ToString};
use alloc::vec::Vec;
use core::fmt;

/// Error in the text of a module, with its position.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ParseError {
    /// Line, from 1.
    pub line: u32,
    /// Column in characters, from 1.
    pub column: u32,
    /// Message.
    pub message: String,
}

impl fmt::Display for ParseError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "{}:{}: {}", self.line, self.column, self.message)
    }
}

impl core::error::Error for ParseError {}

/// The smallest unit of text.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Token {
    /// An identifier or a keyword.
    Name(String),
    /// A quoted name, `"…"`.
    Quoted(String),
    /// A number: digits, with the point and exponent, and the suffix.
    Number { digits: String, suffix: String },
    /// One of [`PUNCTUATION`].
    Mark(&'static str),
    /// A `///` line.
    Doc(String),
    /// A `//` line.
    Comment(String),
    /// The end of the text.
    End,
}

/// A token and its position.
#[derive(Clone, Debug)]
pub(super) struct Lexeme {
    pub token: Token,
    pub line: u32,
    pub column: u32,
}

/// Marks of the language, the longest first.
const PUNCTUATION: [&str; 37] = [
    "..=", "..", "::", "->", "=>", "==", "!=", "<=", ">=", "<<", ">>", "&&", "||", "{", "}", "(",
    ")", "[", "]", "<", ">", ",", ";", ":", "=", "+", "-", "*", "/", "%", "&", "|", "^", "!", ".",
    "@", "#",
];

struct Lexer<'t> {
    rest: &'t str,
    line: u32,
    column: u32,
}

/// Returns all tokens of `text`; the last is `End`.
pub(super) fn lex(text: &str) -> Result<Vec<Lexeme>, ParseError> {
    let mut lexer = Lexer { rest: text, line: 1, column: 1 };
    let mut lexemes = Vec::new();
    loop {
        while lexer.peek().is_some_and(char::is_whitespace) {
            lexer.next();
        }
        let (line, column) = (lexer.line, lexer.column);
        let token = lexer.token()?;
        let end = token == Token::End;
        lexemes.push(Lexeme { token, line, column });
        if end {
            return Ok(lexemes);
        }
    }
}

impl<'t> Lexer<'t> {
    fn peek(&self) -> Option<char> {
        self.rest.chars().next()
    }

    /// Returns the character after the next.
    fn second(&self) -> Option<char> {
        self.rest.chars().nth(1)
    }

    fn next(&mut self) -> Option<char> {
        let mut chars = self.rest.chars();
        let next = chars.next()?;
        self.rest = chars.as_str();
        if next == '\n' {
            self.line = self.line.saturating_add(1);
            self.column = 1;
        } else {
            self.column = self.column.saturating_add(1);
        }
        Some(next)
    }

    fn skip(&mut self, count: usize) {
        for _ in 0..count {
            self.next();
        }
    }

    fn take(&mut self, wanted: impl Fn(char) -> bool) -> &'t str {
        let start = self.rest;
        while self.peek().is_some_and(&wanted) {
            self.next();
        }
        &start[..start.len() - self.rest.len()]
    }

    fn fail<T>(&self, message: impl Into<String>) -> Result<T, ParseError> {
        Err(ParseError { line: self.line, column: self.column, message: message.into() })
    }

    fn token(&mut self) -> Result<Token, ParseError> {
        let Some(first) = self.peek() else { return Ok(Token::End) };
        if self.rest.starts_with("///") {
            self.skip(3);
            return self.remark().map(Token::Doc);
        }
        if self.rest.starts_with("//") {
            self.skip(2);
            return self.remark().map(Token::Comment);
        }
        if first == '"' {
            return self.quoted().map(Token::Quoted);
        }
        if first.is_ascii_digit() {
            return Ok(self.number());
        }
        if first == '_' || first.is_ascii_alphabetic() {
            return Ok(Token::Name(self.take(is_name).to_string()));
        }
        for mark in PUNCTUATION {
            if self.rest.starts_with(mark) {
                self.skip(mark.len());
                return Ok(Token::Mark(mark));
            }
        }
        self.fail(format!("unexpected character {first:?}"))
    }

    /// Reads the text after the slashes: a quoted string, or the line without its first space.
    fn remark(&mut self) -> Result<String, ParseError> {
        if self.peek() == Some('"') {
            return self.quoted();
        }
        let line = self.take(|next| next != '\n');
        Ok(line.strip_prefix(' ').unwrap_or(line).to_string())
    }

    fn quoted(&mut self) -> Result<String, ParseError> {
        let mut value = String::new();
        self.next();
        loop {
            match self.next() {
                None => return self.fail("the string has no end"),
                Some('"') => return Ok(value),
                Some('\\') => value.push(self.escape()?),
                Some(plain) => value.push(plain),
            }
        }
    }

    fn escape(&mut self) -> Result<char, ParseError> {
        match self.next() {
            Some('n') => Ok('\n'),
            Some('r') => Ok('\r'),
            Some('t') => Ok('\t'),
            Some('0') => Ok('\0'),
            Some(plain @ ('\\' | '"' | '\'')) => Ok(plain),
            Some('u') if self.peek() == Some('{') => {
                self.next();
                let digits = self.take(|next| next.is_ascii_hexdigit());
                let code = u32::from_str_radix(digits, 16).ok().and_then(char::from_u32);
                match (code, self.next()) {
                    (Some(code), Some('}')) => Ok(code),
                    _ => self.fail("no such character"),
                }
            }
            _ => self.fail("unknown escape"),
        }
    }

    fn number(&mut self) -> Token {
        let start = self.rest;
        if self.rest.starts_with("0x") {
            self.skip(2);
            self.take(|next| next.is_ascii_hexdigit() || next == '_');
        } else {
            self.take(is_digit);
            if self.peek() == Some('.') && self.second().is_some_and(|next| next.is_ascii_digit()) {
                self.next();
                self.take(is_digit);
            }
            if matches!(self.peek(), Some('e' | 'E')) {
                let digits = self.rest[1..].trim_start_matches(['+', '-']);
                let signs = self.rest.len() - 1 - digits.len();
                if signs <= 1 && digits.starts_with(|next: char| next.is_ascii_digit()) {
                    self.skip(1 + signs);
                    self.take(is_digit);
                }
            }
        }
        let digits = start[..start.len() - self.rest.len()].replace('_', "");
        Token::Number { digits, suffix: self.take(is_name).to_string() }
    }
}

fn is_name(next: char) -> bool {
    next == '_' || next.is_ascii_alphanumeric()
}

fn is_digit(next: char) -> bool {
    next == '_' || next.is_ascii_digit()
}
