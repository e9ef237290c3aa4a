//! Tests of the blocks: against independent implementations, whose values are in `tests/data/` beside the script that
//! makes them, and of properties for any input. One program, so that it is linked once.
//!
//! The bits of the C are tested elsewhere: `tests/corpus/src/programs/blocks/` calls every block on every leg.

mod data;
mod earth;
mod laws;
mod machines;
mod motions;
mod predictions;
mod programs;
mod signals;
