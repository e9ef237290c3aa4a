//! Two-out-of-three voting with a generic comparator and latched faults.

/// Decides whether two redundant readings agree and merges those that do.
pub trait Comparator<T> {
    fn agree(&self, a: &T, b: &T) -> bool;

    /// Merges two agreeing readings; keeps the first one by default.
    fn merge(&self, a: T, _b: T) -> T {
        a
    }

    /// Picks one of three agreeing readings.
    fn middle(&self, [first, ..]: [T; 3]) -> T {
        first
    }
}

/// Exact match, for discrete signals.
#[derive(Debug, Clone, Copy, Default)]
pub struct Exact;

impl<T: PartialEq> Comparator<T> for Exact {
    fn agree(&self, a: &T, b: &T) -> bool {
        a == b
    }
}

/// Analogue signals that may differ by an absolute and a relative amount.
#[derive(Debug, Clone, Copy)]
pub struct Tolerance {
    pub absolute: f32,
    pub relative: f32,
}

impl Comparator<f32> for Tolerance {
    fn agree(&self, a: &f32, b: &f32) -> bool {
        let scale = a.abs().max(b.abs());
        (a - b).abs() <= self.absolute.max(self.relative * scale)
    }

    fn merge(&self, a: f32, b: f32) -> f32 {
        0.5 * (a + b)
    }

    fn middle(&self, mut readings: [f32; 3]) -> f32 {
        readings.sort_unstable_by(f32::total_cmp);
        readings[1]
    }
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Channel {
    A,
    B,
    C,
}

const CHANNELS: [Channel; 3] = [Channel::A, Channel::B, Channel::C];

/// Latches after `limit` net failures; good cycles count down again.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
struct FaultLatch {
    count: u8,
    latched: bool,
}

impl FaultLatch {
    fn record(&mut self, failed: bool, limit: u8) {
        let change = if failed { 1 } else { -1 };
        self.count = self.count.saturating_add_signed(change);
        self.latched |= self.count >= limit;
    }
}

/// With a majority of two, the third was outvoted or absent.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Vote<T> {
    Unanimous(T),
    Majority { value: T, dissenter: Channel },
    NoMajority,
}

impl<T> Vote<T> {
    pub fn value(self) -> Option<T> {
        match self {
            Vote::Unanimous(value) | Vote::Majority { value, .. } => Some(value),
            Vote::NoMajority => None,
        }
    }
}

#[derive(Debug, Clone)]
pub struct Voter<C> {
    comparator: C,
    latches: [FaultLatch; 3],
    limit: u8,
}

impl<C> Voter<C> {
    pub fn new(comparator: C, limit: u8) -> Self {
        Self { comparator, latches: Default::default(), limit }
    }

    pub fn faults(&self) -> impl Iterator<Item = Channel> + '_ {
        CHANNELS.into_iter().filter(|&channel| self.latches[channel as usize].latched)
    }

    /// Votes on one cycle; `None` stands for a channel without a reading.
    pub fn vote<T: Copy>(&mut self, readings: [Option<T>; 3]) -> Vote<T>
    where
        C: Comparator<T>,
    {
        let admitted =
            CHANNELS.map(|ch| readings[ch as usize].filter(|_| !self.latches[ch as usize].latched));
        let vote = self.decide(admitted);
        for channel in CHANNELS {
            let outvoted = matches!(vote, Vote::Majority { dissenter, .. } if dissenter == channel);
            let failed = outvoted || readings[channel as usize].is_none();
            self.latches[channel as usize].record(failed, self.limit);
        }
        vote
    }

    fn decide<T: Copy>(&self, admitted: [Option<T>; 3]) -> Vote<T>
    where
        C: Comparator<T>,
    {
        const PAIRS: [(Channel, Channel, Channel); 3] = [
            (Channel::A, Channel::B, Channel::C),
            (Channel::A, Channel::C, Channel::B),
            (Channel::B, Channel::C, Channel::A),
        ];
        let mut majorities = PAIRS.iter().filter_map(|&(x, y, dissenter)| {
            let (a, b) = admitted[x as usize].zip(admitted[y as usize])?;
            let agree = self.comparator.agree(&a, &b);
            agree.then(|| Vote::Majority { value: self.comparator.merge(a, b), dissenter })
        });

        // A reading that agrees with both others is bridging them.
        match (majorities.next(), majorities.next(), admitted) {
            (Some(_), Some(_), [Some(a), Some(b), Some(c)]) => {
                Vote::Unanimous(self.comparator.middle([a, b, c]))
            }
            (first, ..) => first.unwrap_or(Vote::NoMajority),
        }
    }
}
