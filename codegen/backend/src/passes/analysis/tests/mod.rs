//! The rules of the analysis against execution: exhaustively where types are narrow, by chance where they are wide.

mod conditions;
mod enums;
mod loops;
mod operations;
mod writes;
