//! Trapezoidal stepper ramps as an iterator over step intervals, fed by a
//! planner that queues relative moves.

use nalgebra::ComplexField;

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Direction {
    Forward,
    Backward,
}

/// Motion limits in steps and seconds.
#[derive(Debug, Clone, Copy)]
pub struct Limits {
    pub max_speed: f32,
    pub acceleration: f32,
}

/// Yields the delay before each step in timer ticks.
///
/// Uses the recurrence c' = c - 2c / (4n + 1) of David Austin, which needs
/// one division per step instead of a square root.
#[derive(Debug, Clone)]
pub struct Ramp {
    interval: f32,
    min_interval: f32,
    /// Index into the ideal acceleration curve.
    level: u32,
    remaining: u32,
}

impl Ramp {
    pub fn new(steps: u32, limits: Limits, tick_rate: f32) -> Self {
        // 0.676 corrects the error of the recurrence at its first step.
        let first = 0.676 * tick_rate * (2.0 / limits.acceleration).sqrt();
        let min_interval = tick_rate / limits.max_speed;
        Self { interval: first.max(min_interval), min_interval, level: 0, remaining: steps }
    }

    fn accelerate(&mut self) {
        let next = self.interval - 2.0 * self.interval / (4 * self.level + 5) as f32;
        if next >= self.min_interval {
            self.interval = next;
            self.level += 1;
        }
    }

    fn decelerate(&mut self) {
        if self.level > 0 {
            self.interval += 2.0 * self.interval / (4 * self.level - 1) as f32;
            self.level -= 1;
        }
    }
}

impl Iterator for Ramp {
    type Item = u32;

    fn next(&mut self) -> Option<u32> {
        self.remaining = self.remaining.checked_sub(1)?;
        let ticks = (self.interval + 0.5) as u32;

        // Start braking when the remaining steps just undo the acceleration.
        if self.remaining <= self.level {
            self.decelerate();
        } else if self.remaining > self.level + 1 {
            self.accelerate();
        }
        Some(ticks)
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        (self.remaining as usize, Some(self.remaining as usize))
    }
}

impl ExactSizeIterator for Ramp {}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct QueueFull;

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Step {
    pub direction: Direction,
    pub delay_ticks: u32,
}

/// Queues up to `N` moves and hands out single steps to the timer interrupt.
pub struct Planner<const N: usize> {
    limits: Limits,
    tick_rate: f32,
    queue: [i32; N],
    queued: usize,
    active: Option<(Direction, Ramp)>,
    position: i32,
}

impl<const N: usize> Planner<N> {
    pub fn new(limits: Limits, tick_rate: f32) -> Self {
        Self { limits, tick_rate, queue: [0; N], queued: 0, active: None, position: 0 }
    }

    pub fn position(&self) -> i32 {
        self.position
    }

    pub fn move_by(&mut self, steps: i32) -> Result<(), QueueFull> {
        let slot = self.queue.get_mut(self.queued).ok_or(QueueFull)?;
        *slot = steps;
        self.queued += 1;
        Ok(())
    }

    /// Next step to execute, `None` when all moves are done.
    pub fn next_step(&mut self) -> Option<Step> {
        loop {
            if let Some((direction, ramp)) = &mut self.active {
                if let Some(delay_ticks) = ramp.next() {
                    let direction = *direction;
                    self.position += match direction {
                        Direction::Forward => 1,
                        Direction::Backward => -1,
                    };
                    return Some(Step { direction, delay_ticks });
                }
                self.active = None;
            }
            let steps = self.dequeue()?;
            let direction = if steps < 0 { Direction::Backward } else { Direction::Forward };
            let ramp = Ramp::new(steps.unsigned_abs(), self.limits, self.tick_rate);
            self.active = Some((direction, ramp));
        }
    }

    fn dequeue(&mut self) -> Option<i32> {
        self.queued = self.queued.checked_sub(1)?;
        let first = self.queue[0];
        self.queue.copy_within(1.., 0);
        Some(first)
    }
}
