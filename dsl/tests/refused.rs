//! What the DSL does not take: each file in `refused/` is a model that must not compile, and beside it
//! stands what its author is told.
//!
//! Drop a file there and get a test. `TRYBUILD=overwrite cargo test -p bessemer --test refused` writes
//! the `.stderr` files anew: read them as the author of the model would.

// A generation build tells more (what its witness copies find), so the messages differ.
#![cfg(not(feature = "generate"))]

#[test]
fn refused_models_are_told_why() {
    trybuild::TestCases::new().compile_fail("tests/refused/*.rs");
}
