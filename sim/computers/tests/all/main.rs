//! Computers under test, as their users see them.

mod loops;
mod units;
