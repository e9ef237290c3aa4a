//! The tests of campaigns, as one program.

mod figures;
mod files;
mod together;
