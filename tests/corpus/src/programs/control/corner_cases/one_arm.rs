//! A `let` of a reference whose value is a `match` or an `if let` with only one arm that does not exit. The name
//! refers to that place.

use bessemer::prelude::*;

/// A struct whose fields are referred to.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Shelf {
    /// Levels of the shelf.
    pub levels: [u8; 3],
    /// An optional number.
    pub spare: Option<i16>,
}

#[data]
impl Shelf {
    /// A mutable reference to a level.
    pub fn level(&mut self, i: usize) -> Option<&mut u8> {
        self.levels.get_mut(i)
    }

    /// A `match` on the result of its own method.
    pub fn raise(&mut self, i: usize, by: u8) -> bool {
        let level = match self.level(i) {
            Some(level) => level,
            None => return false,
        };
        *level = level.wrapping_add(by);
        true
    }
}

/// An optional place, written and read.
#[function]
pub fn written(levels: &mut [u8; 4], i: usize) -> u8 {
    let level = match levels.get_mut(i) {
        Some(level) => level,
        None => return 3,
    };
    *level ^= 0x55;
    *level
}

/// The other arm continues or breaks a loop.
#[function]
pub fn in_loops(levels: &mut [u8; 4], at: &[usize; 3]) -> u8 {
    let mut sum = 0_u8;
    for i in at {
        let level = match levels.get_mut(i % 6) {
            Some(level) => level,
            None => break,
        };
        let other = match at.get(usize::from(*level)) {
            None => continue,
            Some(other) => other,
        };
        *level = level.wrapping_add(1);
        sum = sum.wrapping_add(*other as u8);
    }
    sum
}

/// Optional references as arguments, with the arms in either order.
#[function]
pub fn given(first: Option<&mut u8>, second: Option<&mut u8>) -> u8 {
    let one = match first {
        None => return 1,
        Some(one) => one,
    };
    let other = match second {
        Some(other) => other,
        None => {
            *one = 2;
            return 2;
        }
    };
    *one ^= *other;
    *other = 7;
    *one
}

/// The other arm returns an error whose name means something else after the `match`.
#[function]
pub fn handed_on(levels: &mut [u8; 4], r: Result<usize, u8>, e: u8, i: usize) -> Result<u8, u8> {
    let level = match r {
        Ok(i) => &mut levels[i % 5],
        Err(e) => return Err(e ^ 1),
    };
    *level = e;
    Ok(*level ^ i as u8)
}

/// A place that a search finds, written before it is named.
#[function]
pub fn found(levels: &mut [u8; 4], sought: u8) -> u8 {
    let level = if let Some(level) = levels.iter_mut().find(|it| **it == sought) {
        *level ^= 0x0F;
        level
    } else {
        panic!("there is none");
    };
    *level ^= 0xF0;
    *level
}

/// Exiting arms before and after the other one.
#[function]
pub fn between(shelf: &mut Shelf, k: u8) -> u8 {
    let level = match k {
        0 => return 1,
        1 => {
            shelf.spare = None;
            return 2;
        }
        2..=4 => &mut shelf.levels[usize::from(k - 2)],
        5 => return 4,
        n => return n,
    };
    *level ^= 1;
    *level
}

/// A place in a field.
#[function]
pub fn spare(shelf: &mut Shelf, k: u8) -> i16 {
    let spare = match shelf.spare.as_mut() {
        Some(spare) => spare,
        None => {
            shelf.levels[0] = k;
            return 1;
        }
    };
    *spare = spare.wrapping_sub(1);
    *spare
}
