//! Numbers of items that adapters and consumers of Rust's standard library take from an iterator, as rustc 1.95 has them.
//!
//! It depends on the access of the standard library to the items: by index; one by one, with a known length; or one by one.
//!
//! Must not know: how anything is lowered.

use bessemer_ir::tree::Function;

/// Access to the items of an iterator, in increasing order.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Access {
    /// One by one.
    Serial,
    /// One by one; it is not decided whether their number is known.
    Sequential,
    /// Not decided.
    Unknown,
    /// One by one, and their number is known.
    Counted,
    /// By index.
    Indexed,
}

impl Access {
    /// Returns the access to pairs of items.
    pub fn and(self, other: Access) -> Access {
        match (self, other) {
            (Access::Unknown, Access::Counted) | (Access::Counted, Access::Unknown) => {
                Access::Sequential
            }
            _ => self.min(other),
        }
    }
}

/// Properties of an iterator's items on which the number of closure calls depends.
#[derive(Clone, Copy, Debug)]
pub struct Items {
    /// Access to them.
    pub access: Access,
    /// True if a closure that yields an item writes or may fault.
    pub acts: bool,
    /// True if `skip` follows such a closure: access by index leaves out the calls for skipped items.
    pub skips: bool,
    /// True if nothing ends them.
    pub endless: bool,
}

impl Items {
    /// Items of which nothing is known.
    pub const UNKNOWN: Items =
        Items { access: Access::Unknown, acts: true, skips: false, endless: false };

    /// Returns items that no closure yields.
    pub fn plain(access: Access) -> Items {
        Items { access, acts: false, skips: false, endless: false }
    }

    /// Returns items that also a closure yields, which may act.
    pub fn acting(self, acts: bool) -> Items {
        Items { acts: self.acts || acts, ..self }
    }

    /// Returns the items with at most this access.
    pub fn at_most(self, access: Access) -> Items {
        Items { access: self.access.and(access), ..self }
    }

    /// Returns the pairs of the items of both.
    pub fn beside(self, other: Items) -> Items {
        Items {
            access: self.access.and(other.access),
            acts: self.acts || other.acts,
            skips: self.skips || other.skips,
            endless: self.endless && other.endless,
        }
    }

    /// Returns the items after the first ones.
    pub fn skipped(self) -> Items {
        match self.access {
            Access::Indexed | Access::Unknown => Items { skips: self.skips || self.acts, ..self },
            _ => self.at_most(Access::Serial),
        }
    }

    /// Returns every `n`th item.
    pub fn stepped(self) -> Items {
        match self.access {
            Access::Counted => self.at_most(Access::Serial),
            Access::Unknown => self.at_most(Access::Sequential),
            _ => self.at_most(Access::Counted),
        }
    }

    /// Returns the first `n` items.
    pub fn taken(self) -> Items {
        Items { endless: false, ..self.at_most(Access::Counted) }
    }
}

/// The way in which a consumer takes items.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Taking {
    /// By `next`.
    Next,
    /// All at once, by `fold`.
    Fold,
    /// By both, as `max` and `skip` do.
    Mixed,
}

/// The way in which a function takes the items of its argument.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Consumer {
    /// Always in this way.
    Takes(Taking),
    /// As its own consumer does.
    PassesOn,
    /// By `next` if its own consumer does, else by both.
    PassesOnNext,
}

/// The number of items of an adapter.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Number {
    /// As many as its argument has.
    Same,
    /// As many as the shorter one of its arguments has.
    Least,
}

const ADAPTERS: &str = "bessemer::adapt";
const CONSUMERS: &str = "bessemer::iterate";
const CUTS: &str = "bessemer::cut";

/// Returns the items of an adapter over these; `acting` is true if a closure of its own writes or may fault.
pub fn adapted(function: &Function, sides: &[Items], acting: bool) -> Items {
    match (&*function.module, &*function.tree.name, sides) {
        (ADAPTERS, "map" | "copied" | "enumerate", [of]) => of.acting(acting),
        (ADAPTERS, "skip", [of]) => of.skipped(),
        (ADAPTERS, "step_by", [of]) => of.stepped(),
        (ADAPTERS, "rev", [of]) => of.at_most(Access::Counted),
        (ADAPTERS, "take", [of]) => of.taken(),
        (ADAPTERS, "zip", [one, other]) => one.beside(*other),
        (ADAPTERS, "chain", [one, other]) => one.beside(*other).at_most(Access::Counted),
        // If these are arrays, their number is known.
        (ADAPTERS, "flat_map" | "flatten", [of]) => of.at_most(Access::Unknown).acting(acting),
        (ADAPTERS, _, [of]) => of.at_most(Access::Serial).acting(acting),
        // A cut slice, or an iterator of nalgebra's.
        (module, ..) if module.starts_with("bessemer::") => {
            Items::plain(Access::Serial).acting(acting)
        }
        _ => Items::UNKNOWN,
    }
}

/// Returns the number of items of an adapter; none if its arguments do not decide it.
pub fn number(function: &Function) -> Option<Number> {
    match (&*function.module, &*function.tree.name) {
        (ADAPTERS, "map" | "copied" | "enumerate" | "inspect" | "rev") => Some(Number::Same),
        (ADAPTERS, "zip") => Some(Number::Least),
        _ => None,
    }
}

/// Returns how a function of the DSL takes the items of its argument; none if it is no adapter or consumer.
pub fn consumer(function: &Function) -> Option<Consumer> {
    Some(match (&*function.module, &*function.tree.name) {
        (CONSUMERS, "count" | "fold" | "last" | "for_each") => Consumer::Takes(Taking::Fold),
        (CONSUMERS, "reduce" | "max" | "min" | "max_by" | "min_by") => {
            Consumer::Takes(Taking::Mixed)
        }
        (CONSUMERS, "max_by_key" | "min_by_key") => Consumer::Takes(Taking::Mixed),
        (CONSUMERS, _) => Consumer::Takes(Taking::Next),
        (ADAPTERS, "take" | "take_while" | "map_while" | "scan" | "step_by") => {
            Consumer::Takes(Taking::Next)
        }
        (ADAPTERS, "zip" | "skip" | "skip_while" | "rev") => Consumer::PassesOnNext,
        (ADAPTERS, _) => Consumer::PassesOn,
        _ => return None,
    })
}

/// Returns true for the result of `sum` and `product`, which take all items at once.
pub fn is_gathered(name: &str) -> bool {
    name == "%sum" || name == "%product"
}

/// Returns true for the function that compares the items of two iterators.
pub fn is_comparison(function: &Function) -> bool {
    is(function, CONSUMERS, "equal_items")
}

/// Returns true for `next_back`, which takes an item from the end.
pub fn is_next_back(function: &Function) -> bool {
    is(function, CONSUMERS, "next_back")
}

/// Returns true for the number of items, `len`.
pub fn is_len(function: &Function) -> bool {
    is(function, CONSUMERS, "len")
}

/// Returns true for the consumer `last`.
pub fn is_last(function: &Function) -> bool {
    is(function, CONSUMERS, "last")
}

/// Returns true for `chunk_by`, whose last part is found from the end on.
pub fn is_chunk_by(function: &Function) -> bool {
    is(function, CUTS, "chunk_by")
}

/// Returns true for an adapter whose last item is the last one of an argument, without a loop over all.
pub fn ends_in_argument(function: &Function) -> bool {
    is(function, ADAPTERS, "skip") || is(function, ADAPTERS, "chain")
}

/// State of an adapter after its argument yielded `None`, from which it continues if the argument yields more items.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Interrupted {
    /// This count is zero: it skips nothing more.
    Zero(&'static str),
    /// This count has the value of another variable: it skips anew.
    Anew(&'static str, &'static str),
    /// It takes no more items of its first argument.
    Behind,
}

/// Returns the state in which the standard library leaves an adapter after its argument yielded `None`; none if the adapter's own
/// variables have it already.
pub fn interrupted(function: &Function) -> Option<Interrupted> {
    match (&*function.module, &*function.tree.name) {
        (ADAPTERS, "skip") => Some(Interrupted::Zero("left")),
        (ADAPTERS, "step_by") => Some(Interrupted::Anew("left", "between")),
        (ADAPTERS, "chain") => Some(Interrupted::Behind),
        _ => None,
    }
}

/// Returns true if an adapter yields no more items once its own loop is left.
pub fn ends_for_good(function: &Function) -> bool {
    is(function, ADAPTERS, "take_while")
}

/// Returns true if an adapter stays ended where its arguments do.
pub fn stays_ended(function: &Function) -> bool {
    !["from_fn", "map_while", "scan"].iter().any(|name| is(function, ADAPTERS, name))
}

/// Returns true for an adapter with a loop in its loop, over the parts of each item.
pub fn is_nested(function: &Function) -> bool {
    is(function, ADAPTERS, "flat_map") || is(function, ADAPTERS, "flatten")
}

/// Returns true for the adapter `rev`.
pub fn is_rev(function: &Function) -> bool {
    is(function, ADAPTERS, "rev")
}

/// Returns true for the adapter `zip`.
pub fn is_zip(function: &Function) -> bool {
    is(function, ADAPTERS, "zip")
}

/// Returns true for the adapter `enumerate`.
pub fn is_enumerate(function: &Function) -> bool {
    is(function, ADAPTERS, "enumerate")
}

fn is(function: &Function, module: &str, name: &str) -> bool {
    function.module == module && function.tree.name == name
}
