//! A calculator of expressions in postfix form, on a bounded stack.

use bessemer::prelude::*;

/// An element of a program: a number or an operation.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Symbol {
    Number(f64),
    Add,
    Subtract,
    Multiply,
    Divide,
    #[default]
    Negate,
}

/// Reason why a program has no value.
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Mistake {
    TooDeep,
    TooFew,
    Left(u8),
}

/// Evaluates a program.
#[function]
pub fn calculate(program: &List<Symbol, 12>) -> Result<f64, Mistake> {
    let mut stack: List<f64, 4> = List::new();
    for &token in program {
        let value = match token {
            Symbol::Number(value) => value,
            Symbol::Negate => -stack.pop().ok_or(Mistake::TooFew)?,
            Symbol::Add | Symbol::Subtract | Symbol::Multiply | Symbol::Divide => {
                let (Some(right), Some(left)) = (stack.pop(), stack.pop()) else {
                    return Err(Mistake::TooFew);
                };
                match token {
                    Symbol::Add => left + right,
                    Symbol::Subtract => left - right,
                    Symbol::Multiply => left * right,
                    Symbol::Divide => left / right,
                    _ => unreachable!(),
                }
            }
        };
        if stack.len() == stack.capacity() {
            return Err(Mistake::TooDeep);
        }
        stack.push(value);
    }
    match stack.as_slice() {
        &[value] => Ok(value),
        [] => Err(Mistake::TooFew),
        rest => Err(Mistake::Left(rest.len() as u8)),
    }
}
