//! The linear algebra that the DSL computes itself, against nalgebra's and against what defines it.
//!
//! Here rather than with the DSL, whose package is optimised: nalgebra's routines are compiled for each size of a test,
//! which takes longer than they run.

mod decomposed;
mod linear;
