//! Cooperative scheduler for a fixed set of periodic tasks with priorities
//! and run-time statistics.

/// Free-running microsecond counter; wraps around.
pub trait Clock {
    fn now(&self) -> u32;
}

/// A periodic task working on the shared context `C`.
pub struct Task<C> {
    pub name: &'static str,
    /// Smaller numbers run first.
    pub priority: u8,
    pub period_us: u32,
    pub run: fn(&mut C),
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Statistics {
    pub runs: u32,
    pub total_us: u64,
    pub worst_us: u32,
    /// Largest delay between release and start.
    pub worst_latency_us: u32,
    /// Releases that were dropped because the previous one was still due.
    pub missed: u32,
}

impl Statistics {
    pub fn mean_us(&self) -> Option<u32> {
        Some(self.total_us.checked_div(self.runs.into())? as u32)
    }

    fn record(&mut self, latency: u32, duration: u32) {
        self.runs += 1;
        self.total_us += u64::from(duration);
        self.worst_us = self.worst_us.max(duration);
        self.worst_latency_us = self.worst_latency_us.max(latency);
    }
}

struct Slot<C> {
    task: Task<C>,
    release: u32,
    statistics: Statistics,
}

impl<C> Slot<C> {
    /// How long the task has been due, `None` if it is not.
    fn lateness(&self, now: u32) -> Option<u32> {
        let late = now.wrapping_sub(self.release) as i32;
        u32::try_from(late).ok()
    }

    /// Moves the release to the next point on the task's grid after `now`.
    fn reschedule(&mut self, now: u32) {
        let late = self.lateness(now).unwrap_or(0);
        let skipped = late / self.task.period_us;
        self.statistics.missed += skipped;
        self.release = self.release.wrapping_add((skipped + 1) * self.task.period_us);
    }
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Activity {
    Ran(&'static str),
    /// Nothing is due for that many microseconds.
    Idle(u32),
}

pub struct Scheduler<K, C, const N: usize> {
    clock: K,
    slots: [Slot<C>; N],
    started: u32,
}

impl<K: Clock, C, const N: usize> Scheduler<K, C, N> {
    pub fn new(clock: K, tasks: [Task<C>; N]) -> Self {
        let started = clock.now();
        let mut slots =
            tasks.map(|task| Slot { task, release: started, statistics: Statistics::default() });
        slots.sort_unstable_by_key(|slot| slot.task.priority);
        Self { clock, slots, started }
    }

    /// Runs the most important task that is due.
    pub fn poll(&mut self, context: &mut C) -> Activity {
        let now = self.clock.now();
        let due =
            self.slots.iter_mut().find_map(|slot| slot.lateness(now).map(|late| (slot, late)));

        let Some((slot, latency)) = due else {
            return Activity::Idle(self.until_next(now));
        };
        (slot.task.run)(context);
        slot.statistics.record(latency, self.clock.now().wrapping_sub(now));
        slot.reschedule(now);
        Activity::Ran(slot.task.name)
    }

    fn until_next(&self, now: u32) -> u32 {
        self.slots.iter().map(|slot| slot.release.wrapping_sub(now)).min().unwrap_or(u32::MAX)
    }

    pub fn statistics(&self) -> impl Iterator<Item = (&'static str, &Statistics)> {
        self.slots.iter().map(|slot| (slot.task.name, &slot.statistics))
    }

    /// Share of the time since start that was spent in tasks.
    pub fn load(&self) -> f32 {
        let busy: u64 = self.slots.iter().map(|slot| slot.statistics.total_us).sum();
        match self.clock.now().wrapping_sub(self.started) {
            0 => 0.0,
            elapsed => busy as f32 / elapsed as f32,
        }
    }
}
