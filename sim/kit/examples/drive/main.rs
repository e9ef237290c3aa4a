//! A three-phase motor with permanent magnets under load steps: field-oriented control, from blocks (`control.rs`).
//!
//! `cargo run --example drive` prints the figures of a run and writes `drive.csv`, `drive.mcap` and `drive.svg`. The plant shares no
//! code with the controller: a fault in one must not hide in the other.

pub mod control;

use std::error::Error;
use std::fs;

use bessemer_blocks::{PidParameters, PllGains};
use bessemer_sim::{
    Channel, Input, Outcome, Period, Plant, Quality, Reading, Scenario, Setup, Signal, Solver,
    Timeline, View,
};

use control::{Drive, Settings};

/// Control period, s.
pub const PERIOD: f64 = 1e-4;
/// Voltage of the supply, V.
pub const SUPPLY: f64 = 48.0;
/// Natural frequency of the speed loop, rad/s. The loop is critically damped.
pub const SPEED_FREQUENCY: f64 = 75.0;
/// Bandwidth of the current loops, rad/s.
const CURRENT_BANDWIDTH: f64 = 1500.0;

/// Motor with surface magnets, in the rotor's frame.
///
/// States: current along the flux and across it in A, mechanical speed in rad/s, electrical angle in rad. The command is the duties
/// of the half bridges, the disturbance the torque of the load in N·m.
#[derive(Clone, Copy, Debug)]
pub struct Motor {
    /// Resistance of a phase, Ω.
    pub resistance: f64,
    /// Inductance of a phase, H.
    pub inductance: f64,
    /// Flux linkage of the magnets, Wb.
    pub flux: f64,
    /// Number of pole pairs.
    pub pole_pairs: f64,
    /// Moment of inertia, kg·m².
    pub inertia: f64,
    /// Viscous friction, N·m·s/rad.
    pub friction: f64,
}

/// Motor of this example.
pub const MOTOR: Motor = Motor {
    resistance: 0.5,
    inductance: 1e-3,
    flux: 0.02,
    pole_pairs: 4.0,
    inertia: 2e-4,
    friction: 1e-4,
};

impl Motor {
    /// Torque per ampere across the flux, N·m/A.
    pub fn torque_constant(&self) -> f64 {
        1.5 * self.pole_pairs * self.flux
    }

    /// Returns the current of a phase that is `lag` rad behind the first one, A.
    fn phase_current(state: &bessemer_sim::State<4>, lag: f64) -> f64 {
        let (sine, cosine) = libm::sincos(state[3] - lag);
        state[0] * cosine - state[1] * sine
    }
}

/// Angle between two phases, rad.
const THIRD: f64 = std::f64::consts::TAU / 3.0;

impl Plant<4> for Motor {
    type Command = [f64; 3];
    type Disturbance = f64;

    fn derivative(
        &self,
        _: f64,
        state: &bessemer_sim::State<4>,
        input: &Input<[f64; 3], f64>,
    ) -> bessemer_sim::State<4> {
        let [direct, quadrature, speed, angle] = (*state).into();
        // Mean voltages of a period. The star point cancels their common part.
        let (mut across, mut along) = (0.0, 0.0);
        for (lag, duty) in [0.0, THIRD, 2.0 * THIRD].into_iter().zip(input.command) {
            let (sine, cosine) = libm::sincos(angle - lag);
            along += 2.0 / 3.0 * SUPPLY * duty * cosine;
            across -= 2.0 / 3.0 * SUPPLY * duty * sine;
        }
        let electrical = self.pole_pairs * speed;
        let rotation = electrical * self.inductance;
        let torque = self.torque_constant() * quadrature;
        [
            (along - self.resistance * direct + rotation * quadrature) / self.inductance,
            (across - self.resistance * quadrature - rotation * direct - electrical * self.flux)
                / self.inductance,
            (torque - self.friction * speed - input.disturbance) / self.inertia,
            electrical,
        ]
        .into()
    }
}

/// Speed that the drive holds, rad/s.
pub const TARGET: f64 = 100.0;
/// Torque of the load from 0.2 s to 0.4 s, N·m.
pub const LOAD: f64 = 0.3;

/// Returns settings for a motor: poles of the currents cancelled, and a critically damped speed.
pub fn settings(motor: &Motor) -> Settings {
    let limits = |limit: f64| PidParameters {
        low: -limit,
        high: limit,
        period: PERIOD,
        ..Default::default()
    };
    let per_ampere = motor.torque_constant() / motor.inertia;
    Settings {
        speed: PidParameters {
            proportional: 2.0 * SPEED_FREQUENCY / per_ampere,
            integral: SPEED_FREQUENCY * SPEED_FREQUENCY / per_ampere,
            target_weight: 0.0,
            ..limits(10.0)
        },
        current: PidParameters {
            proportional: CURRENT_BANDWIDTH * motor.inductance,
            integral: CURRENT_BANDWIDTH * motor.resistance,
            ..limits(0.5 * SUPPLY)
        },
        pll: PllGains { proportional: 4000.0, integral: 4e6, period: PERIOD },
        pole_pairs: motor.pole_pairs,
        supply: SUPPLY,
    }
}

/// Returns the loop around the drive: motor, sensors, rates.
pub fn setup() -> Result<Setup<Motor, 4, 3>, bessemer_sim::Error> {
    let current = |name: &str, lag: f64| {
        let value = move |view: &View<Motor, 4>| Motor::phase_current(view.state, lag);
        let quality = Quality { noise: 0.02, resolution: 0.005, ..Quality::default() };
        Channel { signal: Signal::new(name, "A", value), period: Period::TICK, quality }
    };
    let encoder = Channel {
        signal: Signal::new("encoder", "rad", |view: &View<Motor, 4>| view.state[3]),
        period: Period::TICK,
        quality: Quality {
            resolution: 4.0 * std::f64::consts::TAU / 16384.0,
            ..Quality::default()
        },
    };
    Ok(Setup {
        plant: MOTOR,
        start: [0.0; 4].into(),
        command: [0.5; 3],
        sensors: [current("current_a", 0.0), current("current_b", THIRD), encoder],
        probes: vec![
            Signal::new("direct", "A", |view| view.state[0]),
            Signal::new("quadrature", "A", |view| view.state[1]),
            Signal::new("speed", "rad/s", |view| view.state[2]),
            Signal::new("load", "N·m", |view| view.input.disturbance),
        ],
        tick: bessemer_sim::Tick::nanoseconds(100_000)?,
        control: Period::TICK,
        record: Period::ticks(5)?,
        solver: Solver::RungeKutta { step: 0.5 * PERIOD },
    })
}

/// Returns a run up to the speed, and through a load that comes at 0.2 s and goes at 0.4 s.
pub fn scenario(seed: u64) -> Result<Scenario<f64, f64>, bessemer_sim::Error> {
    Ok(Scenario {
        duration: 0.6,
        goals: Timeline::constant(TARGET),
        disturbances: Timeline::new(0.0, vec![(0.2, LOAD), (0.4, 0.0)])?,
        faults: Vec::new(),
        seed,
    })
}

/// Runs the drive through its scenario.
pub fn run(seed: u64) -> Result<Outcome<Motor, 4>, bessemer_sim::Error> {
    let settings = settings(&MOTOR);
    let mut drive = Drive::default();
    let mut computer = |[a, b, angle]: &[Reading; 3], target: &f64| {
        drive.step(&settings, *target, [a.value, b.value], angle.value)
    };
    setup()?.run(&scenario(seed)?, &mut computer)
}

fn main() -> Result<(), Box<dyn Error>> {
    let recording = run(1)?.recording;
    let speed = recording.channel("speed")?;
    let lowest = speed.between(0.2, 0.4).iter().copied().fold(f64::INFINITY, f64::min);
    println!("speed before the load: {:.2} rad/s", speed.between(0.19, 0.2)[0]);
    println!("lowest speed under the load: {lowest:.2} rad/s");
    fs::write("drive.csv", recording.csv())?;
    fs::write("drive.mcap", recording.mcap()?)?;
    #[cfg(feature = "parquet")]
    fs::write("drive.parquet", recording.parquet()?)?;
    fs::write("drive.svg", recording.svg(&[&["speed"], &["direct", "quadrature"], &["load"]])?)?;
    Ok(())
}
