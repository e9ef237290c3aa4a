//! Compares generated kernels with other implementations: for the computation of Chapter 6, and for small sizes.
//!
//! | module | what it is for |
//! |---|---|
//! | [`case`] | what is measured, and on which numbers |
//! | [`machine`] | where, and with which flags |
//! | [`contender`] | who, and how each becomes a program |
//! | [`count`] | executed instructions: callgrind on the host, QEMU's plugin on the Cortex-A9 |
//! | [`clock`] | times: programs that run alternately, round by round |
//! | [`check`] | whether a result may be measured at all |
//! | [`above`] | where the generated C takes more than it should |
//! | [`goals`] | what it is to reach, and whether it did |
//! | [`reasons`] | why it does not, as far as somebody found out |
//! | [`stored`] | the results of a run as a file, and from it |
//! | [`report`], [`plot`] | the terminal, JSON, Markdown and SVG |
//!
//! Invariants: every contender gets the same numbers and the same flags; what is compared was measured in
//! one run, in turns; no figure of a contender whose result is wrong.

pub mod above;
pub mod case;
pub mod check;
pub mod clock;
pub mod contender;
pub mod count;
pub mod generated;
pub mod goals;
pub mod machine;
pub mod plot;
pub mod reasons;
pub mod report;
pub mod results;
pub mod run;
pub mod stored;
