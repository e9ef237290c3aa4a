//! Closures with effects in iterators of which std takes a number of items that it does not promise.
use bessemer::prelude::*;

#[function]
pub fn taken_by_access(values: &[u8], others: &[u8], calls: &mut u32) -> Option<u8> {
    let counted = values.iter().map(|x| {
        *calls = calls.wrapping_add(1);
        *x
    });
    counted.zip(others.iter().rev()).map(|(x, y)| x ^ y).max()
}

#[function]
pub fn skipped_by_access(values: &[u8], others: &[u8], k: usize) -> usize {
    values.iter().map(|x| x + 1).skip(k).zip(others).count()
}

#[function]
pub fn compared_by_access(values: &[u8], others: &[u8]) -> bool {
    values.iter().map(|x| x + 1).take(3).eq(others.iter().copied())
}

#[function]
pub fn last_from_the_end(values: &[u8]) -> Option<usize> {
    values.chunk_by(|x, y| x + 1 == *y).last().map(|part| part.len())
}
