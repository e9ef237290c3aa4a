//! Chunks that are longer than any slice.

use bessemer::prelude::*;

/// Number and contents of the chunks.
#[function]
pub fn chunks_of_many(bytes: &[u8; 10], used: usize) -> (u8, u32) {
    let used = used.min(bytes.len());
    let (mut count, mut sum) = (0, 0);
    for part in bytes[..used].chunks(4_294_967_295) {
        count += 1;
        for byte in part {
            sum += u32::from(*byte);
        }
    }
    (count, sum)
}
