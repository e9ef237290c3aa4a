//! Counters of the proofs' rules, which show how well programs cover them.
//!
//! The counters are global to the process. No decision depends on them.

use core::sync::atomic::{AtomicU64, Ordering};

macro_rules! rules {
    ($($name:ident: $text:literal,)*) => {
        /// A rule of a proof.
        #[derive(Clone, Copy)]
        pub enum Rule {
            $(#[doc = $text] $name,)*
        }

        const TEXTS: &[&str] = &[$($text),*];
    };
}

rules! {
    Interval: "analysis: a condition, by intervals",
    Relation: "analysis: a condition, by one that holds",
    Others: "analysis: a comparison, by several others",
    Float: "analysis: a number, by the bounds of the float that is converted",
    Each: "analysis: a comparison with the smaller or the larger of two, as one with each",
    Either: "analysis: a disjunction, where its first part fails",
    Excluded: "analysis: the other of two alternatives, where one was excluded",
    Place: "analysis: a place narrowed by a condition",
    Converted: "analysis: what is behind a conversion narrowed",
    Variant: "analysis: variants narrowed by their numbers",
    Brought: "analysis: what an enum is brought to narrowed",
    Term: "analysis: a term of a sum or a difference narrowed",
    Arm: "analysis: narrowed by the arm of a match",
    Rest: "analysis: narrowed by the last arm of a match",
    Counter: "analysis: a counter between the bounds of its loop",
    Counted: "analysis: a local that a loop counts",
    Given: "analysis: a word that a loop gives values within an interval",
    Invariant: "analysis: what a loop keeps that ends itself",
    Kept: "analysis: an order of a local that holds for its new value",
    Met: "analysis: an order that one path has learned and the other proves",
    Ordered: "analysis: orders that each pass of a counted loop preserves",
    Left: "analysis: what holds where a loop that ends itself is left",
    Returned: "analysis: a number that a function returns",
    Shown: "verifier: what an operation needs, shown",
    Forms: "verifier: a form, by others that are 0 or more",
    Cases: "verifier: a formula, from each alternative",
    Product: "verifier: a product, by a division",
    Moved: "verifier: a local that a loop moves by steps",
    Guessed: "verifier: bounds that a loop keeps",
    Preserved: "verifier: an order that each pass of a loop preserves",
    Called: "verifier: a number that a function returns",
    Doubted: "a check left out that the verifier did not confirm, and that stands",
    Ends: "a loop that was shown to end",
}

static COUNTS: [AtomicU64; TEXTS.len()] = [const { AtomicU64::new(0) }; TEXTS.len()];

impl Rule {
    /// Counts a use of the rule.
    pub fn used(self) {
        COUNTS[self as usize].fetch_add(1, Ordering::Relaxed);
    }

    /// Counts the rule if it decided, and returns the argument.
    pub fn told(self, decided: bool) -> bool {
        if decided {
            self.used();
        }
        decided
    }
}

/// Returns each rule as text, with the number of its uses in this process.
pub fn counts() -> impl Iterator<Item = (&'static str, u64)> {
    TEXTS.iter().zip(&COUNTS).map(|(text, count)| (*text, count.load(Ordering::Relaxed)))
}
