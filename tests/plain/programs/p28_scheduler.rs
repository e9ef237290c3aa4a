//! Cooperative scheduler for periodic tasks over a shared context, on a wrapping
//! millisecond clock, with overrun accounting.

use core::cmp::Reverse;
use core::ops::{Add, Sub};

/// A point on the wrapping millisecond clock.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Instant(pub u32);

/// Milliseconds between two instants.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Millis(pub u32);

impl Add<Millis> for Instant {
    type Output = Self;
    fn add(self, rhs: Millis) -> Self {
        Self(self.0.wrapping_add(rhs.0))
    }
}

impl Sub for Instant {
    type Output = Millis;
    fn sub(self, rhs: Self) -> Millis {
        Millis(self.0.wrapping_sub(rhs.0))
    }
}

impl Instant {
    /// True once `self` is at or after `other`, within half the clock's range.
    pub fn reached(self, other: Self) -> bool {
        (self - other).0 < 1 << 31
    }
}

/// What a task wants after its run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Next {
    Continue,
    /// Sleep this long once, then go on with the period.
    After(Millis),
    Stop,
}

/// Body of a task; works on the shared context.
pub type Body<C> = fn(&mut C, Instant) -> Next;

#[derive(Debug)]
struct Task<C> {
    name: &'static str,
    body: Body<C>,
    period: Millis,
    priority: u8,
    due: Option<Instant>,
    overruns: u16,
}

/// Handle of an added task.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TaskId(usize);

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AddError {
    Full,
    ZeroPeriod,
}

/// Scheduler with up to `N` tasks.
#[derive(Debug)]
pub struct Scheduler<C, const N: usize> {
    tasks: [Option<Task<C>>; N],
}

impl<C, const N: usize> Scheduler<C, N> {
    pub const fn new() -> Self {
        Self { tasks: [const { None }; N] }
    }

    pub fn add(
        &mut self,
        name: &'static str,
        period: Millis,
        priority: u8,
        first: Instant,
        body: Body<C>,
    ) -> Result<TaskId, AddError> {
        if period.0 == 0 {
            return Err(AddError::ZeroPeriod);
        }
        let (id, slot) = self
            .tasks
            .iter_mut()
            .enumerate()
            .find(|(_, slot)| slot.is_none())
            .ok_or(AddError::Full)?;
        *slot = Some(Task { name, body, period, priority, due: Some(first), overruns: 0 });
        Ok(TaskId(id))
    }

    /// Runs the most urgent task that is due; gives its name. Call until `None`.
    pub fn step(&mut self, now: Instant, context: &mut C) -> Option<&'static str> {
        let (task, due) = self
            .tasks
            .iter_mut()
            .flatten()
            .filter_map(|task| task.due.filter(|&d| now.reached(d)).map(|d| (task, d)))
            .max_by_key(|(task, due)| (Reverse(task.priority), now - *due))?;

        task.due = match (task.body)(context, now) {
            Next::Stop => None,
            Next::After(pause) => Some(now + pause),
            Next::Continue => {
                let next = due + task.period;
                if now.reached(next) && now != next {
                    // Missed whole periods: skip them but stay on the raster.
                    let missed = (now - due).0 / task.period.0;
                    task.overruns = task.overruns.saturating_add(missed as u16);
                    Some(due + Millis(task.period.0 * (missed + 1)))
                } else {
                    Some(next)
                }
            }
        };
        Some(task.name)
    }

    /// Time until something is due, for the sleep timer.
    pub fn idle_for(&self, now: Instant) -> Option<Millis> {
        self.tasks
            .iter()
            .flatten()
            .filter_map(|t| t.due)
            .map(|due| if now.reached(due) { Millis(0) } else { due - now })
            .min()
    }

    pub fn overruns(&self, TaskId(id): TaskId) -> Option<u16> {
        self.tasks.get(id)?.as_ref().map(|t| t.overruns)
    }
}

impl<C, const N: usize> Default for Scheduler<C, N> {
    fn default() -> Self {
        Self::new()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[derive(Default)]
    struct Board {
        fast: u32,
        slow: u32,
        blinks: u32,
    }

    #[test]
    fn periods_over_the_clock_wrap() {
        let mut sched = Scheduler::<Board, 4>::new();
        let start = Instant(u32::MAX - 50);
        let fast = |b: &mut Board, _| {
            b.fast += 1;
            Next::Continue
        };
        sched.add("fast", Millis(10), 0, start, fast).unwrap();
        sched.add("slow", Millis(35), 1, start + Millis(5), |b, _| {
            b.slow += 1;
            Next::Continue
        }).unwrap();
        let mut board = Board::default();
        for ms in 0..1000 {
            while sched.step(start + Millis(ms), &mut board).is_some() {}
        }
        assert_eq!((board.fast, board.slow), (100, 29));
    }

    #[test]
    fn priority_overruns_and_sleep() {
        let mut sched = Scheduler::<Board, 2>::default();
        let t0 = Instant(0);
        let blink: Body<Board> = |b, _| {
            b.blinks += 1;
            if b.blinks < 3 { Next::After(Millis(2)) } else { Next::Stop }
        };
        let a = sched.add("a", Millis(10), 5, t0, |_, _| Next::Continue).unwrap();
        sched.add("blink", Millis(100), 1, t0, blink).unwrap();
        assert_eq!(sched.add("c", Millis(1), 0, t0, blink), Err(AddError::Full));

        let mut board = Board::default();
        assert_eq!(sched.step(t0, &mut board), Some("blink"));
        assert_eq!(sched.step(t0, &mut board), Some("a"));
        assert_eq!(sched.idle_for(t0), Some(Millis(2)));
        while sched.step(Instant(45), &mut board).is_some() {}
        assert_eq!(sched.overruns(a), Some(3));
        assert_eq!(sched.idle_for(Instant(45)), Some(Millis(2)));
        while sched.step(Instant(47), &mut board).is_some() {}
        assert_eq!((board.blinks, sched.idle_for(Instant(47))), (3, Some(Millis(3))));
    }
}
