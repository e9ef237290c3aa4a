//! Lists of lists.

use bessemer::prelude::*;

/// The type of this kind.
pub type It = List<List<u8, 2>, 3>;

/// A first value.
#[function]
pub fn one() -> It {
    let mut row = List::new();
    row.push(5);
    let mut list = List::new();
    list.push(row);
    list.push(List::new());
    list
}

/// A second, different value.
#[function]
pub fn other() -> It {
    List::new()
}

/// Changes the value to a third one.
#[function]
pub fn change(it: &mut It) {
    if it.is_empty() {
        it.push(List::new());
    } else {
        it[0].clear();
        it[0].push(7);
    }
}

include!("six.in");
