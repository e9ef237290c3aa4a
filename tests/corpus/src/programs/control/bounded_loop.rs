//! A `loop` may have a value.

use bessemer::prelude::*;

/// The integer square root, by Newton's steps from above.
#[function]
pub fn root(n: u32) -> u32 {
    if n < 2 {
        return n;
    }
    let mut guess = n / 2;
    #[bound(32)]
    let root = loop {
        let next = (guess + n / guess) / 2;
        if next >= guess {
            break guess;
        }
        guess = next;
    };
    root
}
