//! Words in, words out; and the computer of a loop that such words make.
//!
//! Knows neither who runs the controller nor what it controls.

use std::marker::PhantomData;

use bessemer::Plain;
use bessemer_legs::{value, words};
use bessemer_sim::{Computer, Failure, Reading};

use crate::error::Error;

/// A controller that something runs: the words of a call's arguments in, the words of its result out.
pub trait Leg {
    /// Calls the controller with the words of its arguments, in their order, without the component.
    ///
    /// Returns the words of the result, then those of each argument that the call may change.
    ///
    /// # Errors
    ///
    /// The controller faults, the number of words is wrong, or whoever runs it does not answer.
    fn call(&mut self, arguments: &[u64]) -> Result<Vec<u64>, Error>;
}

impl<L: Leg + ?Sized> Leg for Box<L> {
    fn call(&mut self, arguments: &[u64]) -> Result<Vec<u64>, Error> {
        (**self).call(arguments)
    }
}

/// A leg as the computer of a loop; see [`wired`].
#[derive(Debug)]
pub struct Wired<L, A, C, O> {
    leg: L,
    arguments: A,
    command: C,
    result: PhantomData<fn(O)>,
}

/// Makes a leg the computer of a loop.
///
/// `arguments` returns the arguments of a call from readings and goal: a tuple in the order of the entry point's parameters
/// behind `self`, each by value. `command` turns the result into the plant's command; if the entry point changes arguments,
/// the result is a tuple of the result and these.
pub fn wired<const S: usize, G, I, O, C, L, A, R>(
    leg: L,
    arguments: A,
    command: R,
) -> Wired<L, A, R, O>
where
    L: Leg,
    I: Plain,
    O: Plain,
    A: FnMut(&[Reading; S], &G) -> I,
    R: FnMut(O) -> C,
{
    Wired { leg, arguments, command, result: PhantomData }
}

impl<const S: usize, G, I, O, C, L, A, R> Computer<S, G, C> for Wired<L, A, R, O>
where
    L: Leg,
    I: Plain,
    O: Plain,
    A: FnMut(&[Reading; S], &G) -> I,
    R: FnMut(O) -> C,
{
    fn step(&mut self, readings: &[Reading; S], goal: &G) -> Result<C, Failure> {
        let result = self.leg.call(&words(&(self.arguments)(readings, goal)))?;
        if result.len() != O::WORDS {
            return Err(Error::Result { found: result.len(), wanted: O::WORDS }.into());
        }
        Ok((self.command)(value(&result)))
    }
}
