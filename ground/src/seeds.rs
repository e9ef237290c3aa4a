//! Flights of a campaign's seeds: the links of its summary page open them here.
//!
//! Must not know: how a flight is shown.

use crate::recorder::{self, Unwritable};
use sim::campaign::{Campaign as _, Kind};
use std::path::{Path, PathBuf};
use tokio::sync::oneshot;

/// A seed whose flight a person wants to see.
#[derive(Debug)]
pub struct Seed {
    /// Campaign of the seed.
    pub campaign: Kind,
    /// The seed.
    pub seed: u64,
    done: oneshot::Sender<Result<(), String>>,
}

/// The answer to a [`Seed`]: nothing once its flight is shown, or the reason why it is not.
pub type Answer = oneshot::Receiver<Result<(), String>>;

impl Seed {
    /// Reads the parts of a link's address, such as `failures` and `7`; returns `None` for others.
    pub fn of(campaign: &str, seed: &str) -> Option<(Self, Answer)> {
        let campaign =
            [Kind::Spread, Kind::Failures].into_iter().find(|it| it.kind() == campaign)?;
        let seed = seed.parse().ok()?;
        let (done, answer) = oneshot::channel();
        Some((Self { campaign, seed, done }, answer))
    }

    /// Answers the page that wants to see the flight.
    pub fn answer(self, shown: Result<(), String>) {
        // A page that was closed meanwhile needs none.
        let _ = self.done.send(shown);
    }
}

/// Flies the seed of a campaign, and returns its recording in a folder.
///
/// # Errors
///
/// The recording cannot be written.
pub fn fly(campaign: Kind, seed: u64, folder: &Path) -> Result<PathBuf, Unwritable> {
    let unwritable = |source| Unwritable { path: folder.to_owned(), source };
    std::fs::create_dir_all(folder).map_err(unwritable)?;
    let path = folder.join(format!("{}-{seed}.mcap", campaign.kind()));
    recorder::simulated(&campaign.scenario(seed), path.clone())?;
    Ok(path)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_a_seed_of_a_campaign_is_one() {
        let of = |campaign, seed| Seed::of(campaign, seed).map(|(it, _)| (it.campaign, it.seed));
        assert_eq!(of("failures", "7"), Some((Kind::Failures, 7)));
        assert_eq!(of("spread", "18446744073709551615"), Some((Kind::Spread, u64::MAX)));
        for (campaign, seed) in [("spred", "7"), ("spread", "-7"), ("spread", ""), ("", "7")] {
            assert_eq!(of(campaign, seed), None);
        }
    }
}
