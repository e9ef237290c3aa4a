//! Enums with payload: stored, constructed, changed in place, matched and compared.

use bessemer::prelude::*;

/// State of the heater.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum State {
    /// Off.
    #[default]
    Idle,
    /// Heats for a number of periods.
    Heating(u16),
    /// Holds a temperature.
    Holding {
        /// Target temperature, °C.
        target: f64,
        /// Number of periods at this temperature so far.
        since: u16,
    },
    /// Has failed permanently, with a reason and a temperature.
    Failed(Reason, f32),
}

#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Reason {
    TooHot,
    NoSensor,
}

/// A command from outside.
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Order {
    Stop,
    Heat { periods: u16 },
    Hold(f64),
}

/// An enum of which every variant but one has no payload.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Reading {
    #[default]
    Lost,
    Volts([f32; 3]),
    Saturated,
}

/// An enum that contains other enums.
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Event {
    Ordered(Order),
    Read { channel: u8, reading: Reading },
    Both(Option<Order>, Reading),
}

#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Enums {
    pub state: State,
    pub history: [State; 3],
    pub reading: Reading,
    pub pending: Option<State>,
}

const FIRST: State = State::Holding { target: 20.0, since: 3 };
const OPTIONS: [State; 3] = [State::Idle, State::Heating(9), State::Failed(Reason::NoSensor, -0.5)];

#[data]
impl State {
    pub fn is_hot(&self) -> bool {
        matches!(self, State::Holding { target, .. } if *target > 50.0)
    }

    /// The state one period later.
    pub fn next(self, temperature: f64) -> State {
        match self {
            State::Idle => self,
            State::Heating(0) => State::Holding { target: temperature, since: 0 },
            State::Heating(left) => State::Heating(left - 1),
            State::Holding { target, .. } if temperature > target + 30.0 => {
                State::Failed(Reason::TooHot, temperature as f32)
            }
            State::Holding { target, since } => {
                State::Holding { target, since: since.saturating_add(1) }
            }
            failed @ State::Failed(..) => failed,
        }
    }

    pub fn age(&mut self) {
        match self {
            State::Idle | State::Failed(..) => {}
            State::Heating(left) => *left /= 2,
            State::Holding { since, .. } => *since = since.wrapping_mul(2),
        }
    }
}

#[function]
fn starting(order: &Order) -> State {
    match *order {
        Order::Stop => State::Idle,
        Order::Heat { periods } => State::Heating(periods),
        Order::Hold(target) => State::Holding { target, since: 0 },
    }
}

#[component]
impl Enums {
    #[entry]
    pub fn step(&mut self, order: Option<Order>, temperature: f64) -> State {
        if let Some(order) = order {
            self.pending = Some(starting(&order));
        }
        let before = self.state;
        self.state = match self.pending.take() {
            Some(state) => state,
            None => self.state.next(temperature),
        };
        self.state.age();
        before
    }

    #[entry]
    pub fn recorded(&mut self, i: usize, state: State) -> State {
        let old = self.history[i];
        self.history[i] = state;
        if old == state {
            return FIRST;
        }
        if let State::Holding { since, .. } = &mut self.history[2 - i] {
            *since += 1;
        }
        OPTIONS[i]
    }

    #[entry(infallible)]
    pub fn equal(&self, a: State, b: State, history: &[State; 3]) -> (bool, bool, bool) {
        (a == b, *history == self.history, Some(a) != self.pending && !a.is_hot())
    }

    #[entry(infallible)]
    pub fn read(&mut self, reading: Reading) -> f32 {
        let was = self.reading;
        self.reading = reading;
        match (was, reading) {
            (Reading::Volts([a, _, c]), Reading::Volts([x, y, ..])) => a * x - c * y,
            (Reading::Lost | Reading::Saturated, Reading::Volts(volts)) => volts[2],
            (Reading::Volts(_), Reading::Lost) => -1.0,
            _ => 0.0,
        }
    }

    #[entry(infallible)]
    pub fn handled(&mut self, event: &Event) -> u16 {
        match event {
            Event::Ordered(Order::Heat { periods: n @ 1..=100 }) => *n,
            Event::Ordered(Order::Stop) => {
                self.state = State::Idle;
                1000
            }
            Event::Ordered(order) => {
                self.state = starting(order);
                1001
            }
            Event::Read { channel: 0..=3, reading } => {
                self.reading = *reading;
                1002
            }
            Event::Read { channel, .. } => 2000 + *channel as u16,
            Event::Both(Some(Order::Hold(level)), Reading::Saturated) if *level > 0.0 => 3000,
            Event::Both(None, other) => (*other == self.reading) as u16,
            Event::Both(..) => 3001,
        }
    }

    #[entry]
    pub fn changed(&mut self, by: u16) -> u16 {
        let mut copy = self.state;
        match &mut copy {
            State::Heating(left) => *left += by,
            State::Holding { target, since } => {
                *since -= by;
                *target = -*target;
            }
            State::Failed(reason, _) => *reason = Reason::TooHot,
            State::Idle => copy = State::Heating(by),
        }
        self.state = copy;
        let State::Heating(left) = copy else { return 0 };
        left
    }
}
