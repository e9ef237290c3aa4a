//! A battery pack of four cells in series: estimated charge, balancing, and a contactor that opens at an overvoltage.
//!
//! `cargo run --example battery` prints the figures of two runs and writes `battery.csv` and `battery.svg`. In the second run a sensor is
//! stuck, so the software does not see that a cell is full, and the protection of the hardware acts: an event of the plant.

use std::error::Error;
use std::fs;

use bessemer::prelude::*;
use bessemer_sim::{
    Channel, Fault, FaultKind, Input, Outcome, Period, Plant, Quality, Reading, Scenario, Setup,
    Signal, Solver, Tick, Timeline, Tolerances, View,
};
use nalgebra::{Matrix2, RowVector2, Vector2};

/// Number of cells.
pub const CELLS: usize = 4;
/// Number of states: a charge and a voltage of each cell.
pub const STATES: usize = 2 * CELLS;
/// Control period, s.
const PERIOD: f64 = 2.0;
/// Voltage of a cell at which the software opens the contactor, V.
const FULL: f64 = 4.15;
/// Voltage of a cell at which the hardware opens the contactor, V.
pub const OVERVOLTAGE: f64 = 4.2;

/// Cell as the software knows it.
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CellParameters {
    /// Charge of a full cell, A·s.
    pub capacity: f64,
    /// Resistance in series, Ω.
    pub series: f64,
    /// Resistance that is in parallel with a capacitor, Ω.
    pub parallel: f64,
    /// Time constant of that pair, s.
    pub time_constant: f64,
    /// Resistor that drains the cell, Ω.
    pub drain: f64,
    /// Polynomial of the voltage at rest over the charge from 0 to 1, lowest power first, V.
    pub rest: [f64; 4],
}

/// Estimates the state of a cell by an extended Kalman filter: coulombs are counted, the voltage corrects them.
#[component]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CellFilter {
    /// Charge from 0 to 1, and the voltage of the capacitor in V.
    state: Vector2<f64>,
    covariance: Matrix2<f64>,
}

impl Default for CellFilter {
    /// Half full, with a standard deviation of 20 %.
    fn default() -> Self {
        let covariance = Matrix2::from_diagonal(&Vector2::new(0.04, 1e-4));
        Self { state: Vector2::new(0.5, 0.0), covariance }
    }
}

#[component]
impl CellFilter {
    /// Advances one period with a current into the cell in A and a voltage in V; returns the charge from 0 to 1.
    #[entry(infallible)]
    pub fn step(&mut self, cell: &CellParameters, current: f64, voltage: f64) -> f64 {
        let decay = 1.0 - PERIOD / cell.time_constant;
        self.state = Vector2::new(
            self.state.x + PERIOD / cell.capacity * current,
            decay * self.state.y + (1.0 - decay) * cell.parallel * current,
        );
        let transition = Matrix2::new(1.0, 0.0, 0.0, decay);
        let process = Matrix2::new(1e-10, 0.0, 0.0, 1e-8);
        let covariance = transition * self.covariance * transition.transpose() + process;

        let [r0, r1, r2, r3] = cell.rest;
        let charge = self.state.x;
        let rest = r0 + charge * (r1 + charge * (r2 + charge * r3));
        let slope = r1 + charge * (2.0 * r2 + 3.0 * charge * r3);
        let output = RowVector2::new(slope, 1.0);
        let variance = (output * covariance * output.transpose()).x + 1e-5;
        let gain = covariance * output.transpose() / variance;
        self.state += gain * (voltage - rest - self.state.y - cell.series * current);
        self.covariance = covariance - gain * output * covariance;
        self.state.x
    }
}

/// Command of the software, with its estimates.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Command {
    /// True if the contactor may be closed.
    pub is_closed: bool,
    /// True for each cell whose resistor drains it.
    pub drained: [bool; CELLS],
    /// Estimated charge of each cell, 0 to 1.
    pub charges: [f64; CELLS],
    /// Charge of the first cell by counting coulombs alone, 0 to 1.
    pub counted: f64,
}

/// Manages the pack.
#[component]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Manager {
    filters: [CellFilter; CELLS],
    /// Cells that are drained in this period.
    drained: [bool; CELLS],
    counted: f64,
    is_full: bool,
}

impl Default for Manager {
    fn default() -> Self {
        let filters = [CellFilter::default(); CELLS];
        Self { filters, drained: [false; CELLS], counted: 0.5, is_full: false }
    }
}

#[component]
impl Manager {
    /// Advances one period with the current into the pack in A, and the voltage of each cell in V.
    ///
    /// At rest it drains each cell that has 0.2 % more charge than the emptiest one. Once a cell is full, the contactor
    /// stays open.
    #[entry(infallible)]
    pub fn step(&mut self, cell: &CellParameters, current: f64, voltages: [f64; CELLS]) -> Command {
        let mut command = Command::default();
        self.counted += PERIOD / cell.capacity * current;
        command.counted = self.counted;
        let mut lowest = 1.0_f64;
        for (index, voltage) in voltages.iter().enumerate() {
            let drained = if self.drained[index] { voltage / cell.drain } else { 0.0 };
            let charge = self.filters[index].step(cell, current - drained, *voltage);
            command.charges[index] = charge;
            lowest = lowest.min(charge);
            self.is_full |= *voltage >= FULL;
        }
        let is_at_rest = current.abs() < 0.2;
        command.drained = command.charges.map(|charge| is_at_rest && charge > lowest + 0.002);
        self.drained = command.drained;
        command.is_closed = !self.is_full;
        command
    }
}

/// Pack of cells, each with a resistance and a pair of resistance and capacitor in series.
///
/// States: the charge of each cell from 0 to 1, then the voltage of each capacitor in V. The disturbance is the current of the
/// charger in A. Source of the circuit: Plett, *Battery Management Systems*, volume I, 2015, chapter 2.
#[derive(Clone, Copy, Debug)]
pub struct Pack {
    /// Capacity of a cell, A·s.
    pub capacity: f64,
    /// Resistance in series, Ω.
    pub series: f64,
    /// Resistance of the pair, Ω.
    pub parallel: f64,
    /// Capacitor of the pair, F.
    pub capacitor: f64,
    /// Resistor that drains a cell, Ω.
    pub drain: f64,
    /// True once the hardware has opened the contactor.
    pub is_tripped: bool,
}

/// Pack of this example: cells of 5 Ah.
pub const PACK: Pack = Pack {
    capacity: 18_000.0,
    series: 0.01,
    parallel: 0.006,
    capacitor: 5000.0,
    drain: 8.0,
    is_tripped: false,
};

/// Voltage at rest of a cell with a charge from 0 to 1, V.
pub fn rest_voltage(charge: f64) -> f64 {
    3.0 + 1.1 * charge - 0.6 * charge * charge + 0.7 * charge * charge * charge
}

type State = bessemer_sim::State<STATES>;
type Drive = Input<Command, f64>;

impl Pack {
    /// Returns the current into the pack, A.
    fn current(&self, input: &Drive) -> f64 {
        if self.is_tripped || !input.command.is_closed { 0.0 } else { input.disturbance }
    }

    /// Returns the voltage of a cell without a drain, V.
    fn voltage(&self, cell: usize, state: &State, input: &Drive) -> f64 {
        rest_voltage(state[cell]) + state[CELLS + cell] + self.series * self.current(input)
    }
}

impl Plant<STATES> for Pack {
    type Command = Command;
    type Disturbance = f64;

    fn derivative(&self, _: f64, state: &State, input: &Drive) -> State {
        let mut derivative = State::zeros();
        for cell in 0..CELLS {
            let is_drained = input.command.drained[cell];
            let drained =
                if is_drained { self.voltage(cell, state, input) / self.drain } else { 0.0 };
            let current = self.current(input) - drained;
            derivative[cell] = current / self.capacity;
            derivative[CELLS + cell] =
                (current - state[CELLS + cell] / self.parallel) / self.capacitor;
        }
        derivative
    }

    fn events(&self) -> usize {
        CELLS
    }

    fn crossing(&self, cell: usize, _: f64, state: &State, input: &Drive) -> f64 {
        OVERVOLTAGE - self.voltage(cell, state, input)
    }

    fn handle(&mut self, _: usize, _: f64, _: &mut State) {
        self.is_tripped = true;
    }
}

/// Returns the cells as the software knows them: with the true parameters.
fn known(pack: &Pack) -> CellParameters {
    CellParameters {
        capacity: pack.capacity,
        series: pack.series,
        parallel: pack.parallel,
        time_constant: pack.parallel * pack.capacitor,
        drain: pack.drain,
        rest: [3.0, 1.1, -0.6, 0.7],
    }
}

/// Outcome of a run.
pub type Run = Outcome<Pack, STATES>;

/// Runs the pack from the charge of each cell, 0 to 1, for a duration in s. The charger's currents are in A.
fn run(
    charges: [f64; CELLS],
    duration: f64,
    currents: Timeline<f64>,
    faults: Vec<Fault>,
) -> Result<Run, bessemer_sim::Error> {
    let every = Period::ticks(2)?;
    let voltage = |cell: usize| Channel {
        signal: Signal::new(&format!("voltage_{cell}"), "V", move |view: &View<Pack, STATES>| {
            view.plant.voltage(cell, view.state, view.input)
        }),
        period: every,
        quality: Quality { noise: 0.001, resolution: 0.001, ..Quality::default() },
    };
    let current = Channel {
        signal: Signal::new("current", "A", |view: &View<Pack, STATES>| {
            view.plant.current(view.input)
        }),
        period: every,
        quality: Quality { noise: 0.01, bias: 0.03, ..Quality::default() },
    };
    let charge = |cell: usize| {
        Signal::new(&format!("charge_{cell}"), "1", move |view: &View<Pack, STATES>| {
            view.state[cell]
        })
    };
    let estimate = |cell: usize| {
        Signal::new(&format!("estimate_{cell}"), "1", move |view: &View<Pack, STATES>| {
            view.input.command.charges[cell]
        })
    };
    let mut probes: Vec<_> = (0..CELLS).map(charge).chain((0..CELLS).map(estimate)).collect();
    probes
        .push(Signal::new("counted", "1", |view: &View<Pack, STATES>| view.input.command.counted));
    let mut start = State::zeros();
    start.fixed_rows_mut::<CELLS>(0).copy_from_slice(&charges);
    let setup = Setup {
        plant: PACK,
        start,
        command: Command { is_closed: true, ..Command::default() },
        sensors: [current, voltage(0), voltage(1), voltage(2), voltage(3)],
        probes,
        tick: Tick::nanoseconds(1_000_000_000)?,
        control: every,
        record: Period::ticks(10)?,
        solver: Solver::DormandPrince(Tolerances::default()),
    };
    let scenario = Scenario {
        duration,
        goals: Timeline::constant(()),
        disturbances: currents,
        faults,
        seed: 1,
    };
    let cell = known(&PACK);
    let mut manager = Manager::default();
    let mut computer = |[current, voltages @ ..]: &[Reading; 1 + CELLS], _: &()| {
        manager.step(&cell, current.value, voltages.map(|reading| reading.value))
    };
    setup.run(&scenario, &mut computer)
}

/// Charges for 40 minutes with 3 A, then rests for 35 minutes, in which the cells are balanced.
pub fn charged() -> Result<Run, bessemer_sim::Error> {
    run([0.36, 0.38, 0.35, 0.37], 4500.0, Timeline::new(3.0, vec![(2400.0, 0.0)])?, Vec::new())
}

/// Charge of each cell when the second run begins, 0 to 1.
pub const UNEVEN: [f64; CELLS] = [0.60, 0.70, 0.60, 0.60];
/// Current of the charger in the second run, A.
pub const CURRENT: f64 = 5.0;

/// Charges without an end, while the sensor of the fullest cell is stuck from 60 s on.
pub fn stuck() -> Result<Run, bessemer_sim::Error> {
    let fault = Fault {
        sensor: "voltage_1".to_owned(),
        from: 60.0,
        until: f64::INFINITY,
        kind: FaultKind::Stuck,
    };
    run(UNEVEN, 1500.0, Timeline::constant(CURRENT), vec![fault])
}

fn main() -> Result<(), Box<dyn Error>> {
    let run = charged()?;
    for cell in 0..CELLS {
        let last = |name: &str| {
            Ok::<_, Box<dyn Error>>(run.recording.channel(name)?.last().unwrap_or_default())
        };
        let (charge, estimate) =
            (last(&format!("charge_{cell}"))?, last(&format!("estimate_{cell}"))?);
        println!("cell {cell}: charge {charge:.4}, estimated {estimate:.4}");
    }
    for event in stuck()?.events {
        println!("overvoltage of cell {} at {:.3} s", event.event, event.time);
    }
    fs::write("battery.csv", run.recording.csv())?;
    let panels: [&[&str]; 2] = [
        &["charge_0", "charge_1", "charge_2", "charge_3", "estimate_0"],
        &["voltage_0", "voltage_1"],
    ];
    fs::write("battery.svg", run.recording.svg(&panels)?)?;
    Ok(())
}
