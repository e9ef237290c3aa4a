//! Runs of many seeds on all cores.
//!
//! Knows no file and no screen: the caller gets each row as its run ends.

use crate::campaign::Campaign;
use crate::error::Error;
use crate::row::Row;
use rayon::prelude::*;
use std::sync::Mutex;

/// Runs the seeds on all cores; calls `done` with the row of each as its run ends, in any order.
///
/// A run without values is made again, up to `retries` times: for what a seed does not decide, such as a board.
///
/// # Errors
///
/// The first error of `done`, after which no further run begins.
pub fn run(
    campaign: &dyn Campaign,
    seeds: &[u64],
    retries: u32,
    done: impl FnMut(Row) -> Result<(), Error> + Send,
) -> Result<(), Error> {
    let done = Mutex::new(done);
    seeds.par_chunks(campaign.together().max(1)).try_for_each(|seeds| {
        Row::all_of(campaign, seeds).into_iter().try_for_each(|mut row| {
            for _ in 0..retries {
                if row.result.is_ok() {
                    break;
                }
                row = Row::of(campaign, row.seed);
            }
            let mut done = done.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
            done(row)
        })
    })
}
