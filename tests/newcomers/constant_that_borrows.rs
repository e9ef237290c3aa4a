//! A token of a text, and a constant of one.
use bessemer::prelude::*;

#[data]
#[derive(Clone, Copy, Debug)]
pub enum Token<'a> {
    End,
    Word(&'a [u8]),
}

const NOTHING: Token<'static> = Token::End;

#[function]
fn first(text: &[u8]) -> Token<'_> {
    if text.is_empty() { NOTHING } else { Token::Word(text) }
}

#[function]
pub fn length(text: &[u8; 8]) -> usize {
    match first(text) {
        Token::End => 0,
        Token::Word(word) => word.len(),
    }
}
