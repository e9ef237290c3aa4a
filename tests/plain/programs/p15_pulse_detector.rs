//! Heart-beat detector: adaptive threshold with hysteresis, refractory time and
//! a beats-per-minute figure from the last intervals.

/// A detected beat.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Beat {
    /// Sample number of the peak.
    pub at: u32,
    pub height: f32,
    /// Rate from the median of recent intervals, once there are enough.
    pub bpm: Option<f32>,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum State {
    /// Waiting for the signal to rise over the threshold.
    Waiting,
    /// Above the threshold, following the maximum.
    Climbing { peak: f32, at: u32 },
    /// Just reported, blind until the given sample.
    Refractory { until: u32 },
}

#[derive(Clone, Debug)]
pub struct PulseDetector {
    fs: f32,
    now: u32,
    state: State,
    baseline: f32,
    envelope: f32,
    last_beat: Option<u32>,
    intervals: [u32; Self::HISTORY],
    interval_count: usize,
}

impl PulseDetector {
    const HISTORY: usize = 5;
    const RISE: f32 = 0.6;
    const FALL: f32 = 0.4;
    const MIN_HEIGHT: f32 = 0.05;
    const REFRACTORY_S: f32 = 0.25;

    pub fn new(fs: f32) -> Self {
        Self {
            fs,
            now: 0,
            state: State::Waiting,
            baseline: 0.0,
            envelope: Self::MIN_HEIGHT,
            last_beat: None,
            intervals: [0; Self::HISTORY],
            interval_count: 0,
        }
    }

    /// Feeds one sample; returns a beat shortly after its peak.
    pub fn push(&mut self, raw: f32) -> Option<Beat> {
        let now = self.now;
        self.now = self.now.wrapping_add(1);

        self.baseline += (raw - self.baseline) / self.fs;
        let x = raw - self.baseline;
        // The envelope jumps up and decays over about two seconds.
        let decay = 1.0 - 0.5 / self.fs;
        self.envelope = (self.envelope * decay).max(x).max(Self::MIN_HEIGHT);

        let (next, beat) = match self.state {
            State::Waiting if x > Self::RISE * self.envelope && x > Self::MIN_HEIGHT => {
                (State::Climbing { peak: x, at: now }, None)
            }
            State::Climbing { peak, .. } if x > peak => (State::Climbing { peak: x, at: now }, None),
            State::Climbing { peak, at } if x < Self::FALL * peak => {
                let until = now.wrapping_add((Self::REFRACTORY_S * self.fs) as u32);
                (State::Refractory { until }, Some((at, peak)))
            }
            State::Refractory { until } if now >= until => (State::Waiting, None),
            unchanged => (unchanged, None),
        };
        self.state = next;
        beat.map(|(at, height)| self.register(at, height))
    }

    fn register(&mut self, at: u32, height: f32) -> Beat {
        if let Some(previous) = self.last_beat.replace(at) {
            let slot = self.interval_count % Self::HISTORY;
            self.intervals[slot] = at.wrapping_sub(previous);
            self.interval_count += 1;
        }
        Beat { at, height, bpm: self.bpm() }
    }

    /// Beats per minute, `None` until three intervals are known.
    pub fn bpm(&self) -> Option<f32> {
        let known = self.interval_count.min(Self::HISTORY);
        if known < 3 {
            return None;
        }
        let mut sorted = self.intervals;
        let sorted = &mut sorted[..known];
        sorted.sort_unstable();
        match sorted[known / 2] {
            0 => None,
            samples => Some(60.0 * self.fs / samples as f32),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A narrow bump every `period` samples on a wandering baseline.
    fn pleth(n: u32, period: u32) -> f32 {
        let phase = (n % period) as f32 / period as f32;
        let bump = (-((phase - 0.3) / 0.06).powi(2)).exp();
        2.0 + 0.2 * (n as f32 * 0.002).sin() + bump
    }

    #[test]
    fn measures_75_bpm() {
        let mut det = PulseDetector::new(100.0);
        let beats = (0..2000).filter_map(|n| det.push(pleth(n, 80))).skip(5);
        let mut count = 0;
        for beat in beats {
            count += 1;
            assert!(beat.bpm.is_some_and(|b| (b - 75.0).abs() < 2.0), "{beat:?}");
        }
        assert!(count >= 12, "{count}");
    }

    #[test]
    fn flat_line_has_no_beats() {
        let mut det = PulseDetector::new(100.0);
        let settled = (0..2000).filter_map(|n| det.push(1.0).map(|_| n)).filter(|&n| n > 1000);
        assert_eq!(settled.count(), 0);
    }

    #[test]
    fn wobble_near_the_threshold_counts_once() {
        let mut det = PulseDetector::new(50.0);
        let wave = [0.0, 0.0, 1.0, 0.8, 0.95, 0.75, 0.9, 0.1, 0.0, 0.0];
        assert_eq!(wave.iter().filter_map(|&x| det.push(x)).count(), 1);
    }
}
