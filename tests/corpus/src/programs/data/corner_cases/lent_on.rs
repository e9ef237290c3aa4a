//! An `Option<&mut T>` that is passed on several times, for writing and for reading, and whose content is copied.

use bessemer::prelude::*;

/// Increments the counter, if any.
#[function]
pub fn count(counter: Option<&mut u8>) -> bool {
    match counter {
        Some(counter) => {
            *counter = counter.wrapping_add(1);
            true
        }
        None => false,
    }
}

/// Reads the counter.
#[function]
pub fn read(counter: Option<&u8>) -> u8 {
    counter.cloned().unwrap_or(200)
}

/// Reborrowed in a loop, and moved afterwards.
#[function]
pub fn in_a_loop(mut counter: Option<&mut u8>, times: u8) -> u8 {
    let mut counted = 0;
    for _ in 0..times % 5 {
        if count(counter.as_deref_mut()) {
            counted += 1;
        }
        counted ^= read(counter.as_deref());
    }
    if let Some(counter) = counter.as_deref_mut() {
        *counter ^= 0x11;
    }
    let Some(last) = counter.as_deref_mut() else { return counted };
    *last ^= 0x22;
    counted ^ counter.copied().unwrap_or_default()
}

/// A reference to an element that a search found.
#[function]
pub fn found(values: &mut [i16; 4], sought: i16) -> (Option<i16>, Option<i16>, bool) {
    let mut found = values.iter_mut().find(|it| **it == sought);
    let written = found.as_deref_mut().map(|it| {
        *it ^= 3;
        *it
    });
    let below = found.as_deref().is_some_and(|it| *it < 0);
    if let Some(it) = found.as_deref_mut().filter(|it| **it > 4) {
        *it = 4;
    }
    (written, found.cloned(), below)
}

/// Returns early if there is no element.
#[function]
pub fn tried(values: &mut [i16; 4], at: usize) -> Option<i16> {
    let mut found = values.get_mut(at);
    *found.as_deref_mut()? ^= 5;
    *found.as_deref_mut().unwrap() ^= 9;
    found.copied()
}

/// Fills some elements.
#[function]
pub fn fill(part: Option<&mut [u8]>, with: u8) {
    if let Some(part) = part {
        part.fill(with);
    }
}

/// The sum of some elements.
#[function]
pub fn sum(part: Option<&[u8]>) -> u32 {
    part.map_or(1, |part| part.iter().map(|x| u32::from(*x)).sum())
}

/// Passes rows on.
#[function]
pub fn rows(values: &mut [u8; 6], from: usize) -> u32 {
    let mut part = values.get_mut(from..);
    fill(part.as_deref_mut(), 3);
    let before = sum(part.as_deref());
    fill(part.as_deref_mut(), 5);
    before * 100 + sum(part.as_deref())
}
