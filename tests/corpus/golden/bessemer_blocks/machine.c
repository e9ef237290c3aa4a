/* The C of blocks/src/machine.rs. Written by a test. */

/* machine.c */

void pump_during_phase(pump_t *self, sequencing_phase_t state)
{
    (void)self;
    (void)state;
}

/* machine.h */

/** A task of a `Schedule`. */
typedef struct {
    /** Number of steps between two runs; 0 means 1. */
    uint32_t period;
    /** Number of steps before the first run, below the period. */
    uint32_t phase;
    /** Longest duration, in units of the author's, such as µs or instructions. */
    uint32_t cost;
} machine_task_t;

/**
 * Schedule of `N` tasks, each with its rate. Tasks that are due in a step run in the author's order.
 */
typedef struct {
    /** The tasks. */
    machine_task_t tasks[1];
} schedule_1_t;

/**
 * Schedule of `N` tasks, each with its rate. Tasks that are due in a step run in the author's order.
 */
typedef struct {
    /** The tasks. */
    machine_task_t tasks[3];
} schedule_3_t;

/* machine_phase.c */

void machine_phase_init(machine_phase_t *self)
{
    self->state = SEQUENCING_PHASE_OFF;
    self->periods = 0U;
    self->running = false;
}

sequencing_phase_t machine_phase_step_pump(machine_phase_t *BESSEMER_RESTRICT self,
    pump_t *BESSEMER_RESTRICT actions)
{
    if (!self->running) {
        self->running = true;
        pump_enter_phase(actions, self->state);
    }
    const sequencing_phase_t next = pump_next_phase(actions, self->state, self->periods);
    if (next != self->state) {
        pump_exit_phase(actions, self->state);
        self->state = next;
        self->periods = 0U;
        pump_enter_phase(actions, next);
    }
    pump_during_phase(actions, next);
    self->periods = saturating_add_u32(self->periods, 1U);
    return next;
}

/* machine_phase.h */

/**
 * Finite state machine: the state, and the periods that it has lasted.
 *
 * In each period `next` decides; if the state changes, the old one's `exit` and the new one's `enter` run; then
 * `during`. The first period enters the initial state, the `Default` of `S`. The count of periods saturates at 2³² − 1.
 *
 * ```
 * use bessemer::prelude::*;
 * use bessemer_blocks::{Actions, Machine};
 *
 * /// States of a pump.
 * #[data]
 * #[derive(Clone, Copy, Debug, Default, PartialEq)]
 * pub enum State {
 *    #[default]
 *    Off,
 *    Priming,
 *    On,
 * }
 *
 * /// What the pump sees and does.
 * #[data]
 * #[derive(Clone, Copy, Debug, Default, PartialEq)]
 * pub struct Pump {
 *    pub wanted: bool,
 *    pub valve: bool,
 *    pub starts: u32,
 * }
 *
 * #[data]
 * impl Actions<State> for Pump {
 *    fn next(&mut self, state: State, periods: u32) -> State {
 *        match state {
 *            _ if !self.wanted => State::Off,
 *            State::Off => State::Priming,
 *            State::Priming if periods >= 2 => State::On,
 *            other => other,
 *        }
 *    }
 *
 *    fn enter(&mut self, state: State) {
 *        self.valve = state != State::Off;
 *        if state == State::On {
 *            self.starts = self.starts.saturating_add(1);
 *        }
 *    }
 * }
 *
 * let (mut machine, mut pump) = (Machine::<State>::default(), Pump { wanted: true, ..Pump::default() });
 * let states = [0; 4].map(|_| machine.step(&mut pump));
 * assert_eq!(states, [State::Priming, State::Priming, State::On, State::On]);
 * assert_eq!((pump.valve, pump.starts), (true, 1));
 * ```
 */
typedef struct {
    /** The state. */
    sequencing_phase_t state;
    /** Number of periods in the state. */
    uint32_t periods;
    /** True after the first period. */
    bool running;
} machine_phase_t;

/* rates_1.c */

void rates_1_init(rates_1_t *self)
{
    self->waits[0] = 0U;
    self->running = false;
}

void rates_1_step(rates_1_t *BESSEMER_RESTRICT self, const schedule_1_t *schedule,
    bool due[BESSEMER_RESTRICT 1])
{
    for (uint32_t i = 0U; i < 1U; i++) {
        if (!self->running) {
            self->waits[i] = schedule->tasks[i].phase;
        }
        due[i] = self->waits[i] == 0U;
        if (due[i]) {
            self->waits[i] = saturating_sub_u32(schedule->tasks[i].period, 1U);
        } else {
            self->waits[i] = saturating_sub_u32(self->waits[i], 1U);
        }
    }
    self->running = true;
}

/* rates_1.h */

/**
 * Several rates in one step: which tasks of a `Schedule` are due.
 *
 * Initialisation: `Default` begins each task at its phase. The rates never drift, since each task has a count of its own.
 *
 * ```
 * use bessemer_blocks::{Rates, Schedule, Task};
 *
 * const SCHEDULE: Schedule<2> = Schedule { tasks: [
 *    Task { period: 1, phase: 0, cost: 40 },
 *    Task { period: 3, phase: 1, cost: 50 },
 * ] };
 * const _: () = assert!(SCHEDULE.heaviest() <= 100 && SCHEDULE.flows(&[[0, 1]]));
 *
 * let mut rates = Rates::<2>::default();
 * let slow = [0; 6].map(|_| rates.step(&SCHEDULE)[1]);
 * assert_eq!(slow, [false, true, false, false, true, false]);
 * ```
 */
typedef struct {
    /** Steps before the next run of each task. */
    uint32_t waits[1];
    /** True after the first step. */
    bool running;
} rates_1_t;

/* rates_3.c */

void rates_3_init(rates_3_t *self)
{
    self->waits[0] = 0U;
    self->waits[1] = 0U;
    self->waits[2] = 0U;
    self->running = false;
}

void rates_3_step(rates_3_t *BESSEMER_RESTRICT self, const schedule_3_t *schedule,
    bool due[BESSEMER_RESTRICT 3])
{
    for (uint32_t i = 0U; i < 3U; i++) {
        if (!self->running) {
            self->waits[i] = schedule->tasks[i].phase;
        }
        due[i] = self->waits[i] == 0U;
        if (due[i]) {
            self->waits[i] = saturating_sub_u32(schedule->tasks[i].period, 1U);
        } else {
            self->waits[i] = saturating_sub_u32(self->waits[i], 1U);
        }
    }
    self->running = true;
}

/* rates_3.h */

/**
 * Several rates in one step: which tasks of a `Schedule` are due.
 *
 * Initialisation: `Default` begins each task at its phase. The rates never drift, since each task has a count of its own.
 *
 * ```
 * use bessemer_blocks::{Rates, Schedule, Task};
 *
 * const SCHEDULE: Schedule<2> = Schedule { tasks: [
 *    Task { period: 1, phase: 0, cost: 40 },
 *    Task { period: 3, phase: 1, cost: 50 },
 * ] };
 * const _: () = assert!(SCHEDULE.heaviest() <= 100 && SCHEDULE.flows(&[[0, 1]]));
 *
 * let mut rates = Rates::<2>::default();
 * let slow = [0; 6].map(|_| rates.step(&SCHEDULE)[1]);
 * assert_eq!(slow, [false, true, false, false, true, false]);
 * ```
 */
typedef struct {
    /** Steps before the next run of each task. */
    uint32_t waits[3];
    /** True after the first step. */
    bool running;
} rates_3_t;
