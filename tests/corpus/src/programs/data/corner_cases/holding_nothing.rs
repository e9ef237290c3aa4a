//! Zero-sized values in every position: their expressions are evaluated nevertheless, and their indices are checked.

use core::marker::PhantomData;
use core::ops::Mul;

use bessemer::prelude::*;

/// A zero-sized struct.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Mark {}

#[data]
impl Mark {
    /// Increments a count, and faults at four.
    fn count(&self, n: &mut u32) -> Mark {
        *n += 1;
        assert!(*n != 4);
        Mark {}
    }

    /// A constant code.
    fn code(self) -> u32 {
        7
    }
}

/// A zero-sized field between two others.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Slot {
    before: u8,
    mark: Mark,
    after: u16,
}

/// A tuple struct whose first field is zero-sized.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Tagged<U>(PhantomData<U>, u32, Mark, u32);

/// An enum whose variants have zero-sized payloads.
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Kind {
    Marked(Mark),
    Numbered(u32),
    Neither,
}

#[data]
impl Mul<Mark> for u32 {
    type Output = Slot;

    fn mul(self, mark: Mark) -> Slot {
        Slot { after: self as u16, mark, before: 1 }
    }
}

/// Evaluates the fields in the order of the Rust.
#[function]
pub fn counted(n: u32) -> u32 {
    let mut n = n % 8;
    let slot = Slot { after: n as u16, mark: Mark {}.count(&mut n), before: n as u8 };
    let again = slot.mark.count(&mut n).count(&mut n);
    u32::from(slot.before) * 10_000 + u32::from(slot.after) * 100 + n + again.code()
}

/// A zero-sized element that may be out of range.
#[function]
pub fn looked(slots: &mut [Slot; 3], i: usize, j: usize) -> u32 {
    let mark = slots[i].mark;
    slots[j % 5].mark = mark;
    let Slot { before, mark, after } = slots[0];
    u32::from(before) + u32::from(after) + mark.code()
}

/// Fields by number, although the first does not exist in the C.
#[function]
pub fn numbered(x: u32, y: u32) -> [u32; 3] {
    let mut tagged: Tagged<f32> = Tagged(PhantomData, x, Mark {}, y);
    tagged.3 ^= tagged.1;
    let Tagged(unit, first, .., last) = tagged;
    let other = Tagged(unit, last, tagged.2, first);
    let Tagged(.., mark, third) = other;
    [other.1, third, mark.code()]
}

/// Matches the variants.
#[function]
pub fn kinds(x: u32) -> u32 {
    let kind = match x % 3 {
        0 => Kind::Marked(Mark {}),
        1 => Kind::Numbered(x),
        _ => Kind::Neither,
    };
    let same = kind == Kind::Marked(Mark {});
    let code = match kind {
        Kind::Marked(mark) => mark.code(),
        Kind::Numbered(n) if n > 9 => n,
        Kind::Numbered(_) => 1,
        Kind::Neither => 2,
    };
    code + if same { 1_000 } else { 0 }
}

#[function]
fn found(x: u32) -> Result<Mark, Slot> {
    if x > 3 { Ok(Mark {}) } else { Err(x * Mark {}) }
}

#[function]
fn found_twice(x: u32) -> Result<u32, Slot> {
    let mark = found(x)?;
    let _ = found(x % 7)?;
    Ok(mark.code())
}

/// `Option` and `Result` of zero-sized values.
#[function]
pub fn there(x: u32) -> u32 {
    let mut n = 0;
    let mark: Option<Mark> = (x % 2 == 0).then_some(Mark {});
    if let Some(mark) = mark {
        n += mark.code();
    }
    if matches!(mark, Some(_)) && mark == Some(Mark {}) {
        n += 10;
    }
    n += match found_twice(x) {
        Ok(n) => n,
        Err(slot) => u32::from(slot.after) + slot.mark.code() * 100,
    };
    if found(x).map_err(|_| Mark {}).is_err() { n + 1_000 } else { n }
}

#[function]
fn applied(f: impl Fn(u32) -> u32, x: u32, mark: Mark) -> u32 {
    f(x).wrapping_add(mark.code())
}

/// Zero-sized values in closures, in unused tuples, and as the values of loops and blocks.
#[function]
pub fn passed(x: u32) -> u32 {
    let (mark, y) = (Mark {}, x);
    let mut other = mark;
    let z;
    (other, z) = (if y > 3 { other } else { Mark {} }, y ^ 1);
    let mut passes = 0;
    let left = loop {
        passes += 1;
        if passes >= x % 9 {
            break other;
        }
    };
    let found = 'found: {
        if z > 5 {
            break 'found left;
        }
        passes += 1;
        mark
    };
    let sum = applied(|y| y.wrapping_mul(mark.code()), z, found);
    match (found, sum) {
        (Mark {}, sum) if sum > 100 => sum - 100 + passes,
        (_, sum) => sum + passes,
    }
}

/// A constant with zero-sized fields.
const START: Tagged<Mark> = Tagged(PhantomData, 3, Mark {}, 4);

#[function]
fn begun<T: Default>(n: u32) -> T {
    assert!(n < 9);
    T::default()
}

/// Constructs zero-sized values from expressions that may fault.
#[function]
pub fn made(n: u32) -> u32 {
    let mark: Mark = begun(n);
    let slot: Slot = begun(n + 1);
    START.1 + START.3 + mark.code() + u32::from(slot.after)
}

#[function]
pub fn folded(values: &[i32; 3], sum: &mut i32) -> i32 {
    let nothing = values.iter().fold(Mark {}, |so_far, value| {
        *sum ^= value;
        so_far
    });
    let _ = nothing;
    values[0]
}
