//! Features that the workspace's tests request of other crates, so that a build of one package requests the same.
//!
//! Cargo compiles a crate, and every crate above it, once for each set of features. Without this package a fresh run compiles
//! the compiler twice: once for xtask, and once for the tests. `Cargo.toml` lists the features; the section "Dependencies by
//! features alone" of ARCHITECTURE.md has the figures.
//!
//! Invariant: no code. Must not know why a package has a dependency.
