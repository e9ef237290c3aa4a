//! The drive and a motor of its own in a loop.

use bessemer::math::ElementaryMethods;
use motor::{Drive, Gains, Inputs, Settings};

/// The supply, V.
const SUPPLY: f32 = 24.0;
/// The control period, s.
const PERIOD: f64 = 50e-6;

/// A motor with permanent magnets, in the rotor's frame.
#[derive(Default)]
struct Motor {
    direct: f64,
    quadrature: f64,
    /// Electrical, rad/s.
    speed: f64,
    /// Electrical, rad.
    angle: f64,
}

impl Motor {
    const RESISTANCE: f64 = 0.4;
    const INDUCTANCE: f64 = 1e-3;
    const FLUX: f64 = 0.01;
    const INERTIA: f64 = 2e-6;

    fn step(&mut self, duties: [f32; 3], enabled: bool, load: f64) {
        let [a, b, c] = duties.map(|duty| f64::from(duty) * f64::from(SUPPLY));
        // The DSL's own sine: the same on every machine.
        let (sine, cosine) = self.angle.dsl_sin_cos();
        let (alpha, beta) = ((2.0 * a - b - c) / 3.0, (b - c) / 3.0_f64.sqrt());
        let (direct, quadrature) = (cosine * alpha + sine * beta, cosine * beta - sine * alpha);
        if enabled {
            let over = PERIOD / Self::INDUCTANCE;
            let back = self.speed * (Self::FLUX + Self::INDUCTANCE * self.direct);
            let turned = self.speed * Self::INDUCTANCE * self.quadrature;
            self.direct += over * (direct - Self::RESISTANCE * self.direct + turned);
            self.quadrature += over * (quadrature - Self::RESISTANCE * self.quadrature - back);
        } else {
            (self.direct, self.quadrature) = (0.0, 0.0);
        }
        let torque = 1.5 * Self::FLUX * self.quadrature - load - 1e-6 * self.speed;
        self.speed += PERIOD * torque / Self::INERTIA;
        self.angle = (self.angle + PERIOD * self.speed) % std::f64::consts::TAU;
    }

    fn inputs(&self, target: f32) -> Inputs {
        let (sine, cosine) = self.angle.dsl_sin_cos();
        let alpha = cosine * self.direct - sine * self.quadrature;
        let beta = sine * self.direct + cosine * self.quadrature;
        Inputs {
            run: true,
            target,
            speed: self.speed as f32,
            angle: self.angle as f32,
            currents: [alpha as f32, (-0.5 * alpha + 0.75_f64.sqrt() * beta) as f32],
            supply: SUPPLY,
            ..Inputs::default()
        }
    }
}

fn settings() -> Settings {
    Settings {
        speed: Gains { proportional: 0.02, integral: 2e-5 },
        current: Gains { proportional: 2.0, integral: 0.04 },
        ramp: 0.5,
        most_current: 5.0,
        trip_current: 12.0,
        aligning: 2000,
        per_top_speed: 1e-3,
        weakening: [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.2, -0.5, -1.0],
    }
}

/// Flies: a start, a load from the middle on. The inputs of each period, and the speed at the end.
fn life() -> (Vec<Inputs>, f64) {
    let (settings, mut drive, mut motor) = (settings(), Drive::default(), Motor::default());
    let mut life = Vec::new();
    for n in 0..40_000 {
        let load = if n < 20_000 { 0.0 } else { 0.01 };
        let inputs = motor.inputs(600.0);
        let outputs = drive.step(&settings, &inputs);
        assert!(outputs.duties.iter().all(|duty| (0.0..=1.0).contains(duty)));
        motor.step(outputs.duties, outputs.enabled, load);
        life.push(inputs);
    }
    (life, motor.speed)
}

#[test]
fn the_speed_is_reached_and_held_under_load() {
    let (_, speed) = life();
    assert!((speed - 600.0).abs() < 3.0, "{speed} rad/s");
}

#[test]
fn a_current_too_high_trips_until_it_is_acknowledged() {
    let (settings, mut drive, motor) = (settings(), Drive::default(), Motor::default());
    assert!(drive.step(&settings, &motor.inputs(600.0)).enabled);
    let short = Inputs { currents: [13.0, 0.0], ..motor.inputs(600.0) };
    assert!(!drive.step(&settings, &short).enabled);
    assert!(!drive.step(&settings, &motor.inputs(600.0)).enabled);
    let acknowledged = Inputs { acknowledge: true, ..motor.inputs(600.0) };
    assert!(!drive.step(&settings, &acknowledged).enabled);
    assert!(drive.step(&settings, &motor.inputs(600.0)).enabled);
}

/// One period in 200 of that life, for `cargo bessemer verify --inputs tests/recorded.csv`; short of time to align.
fn recorded() -> String {
    let settings = Settings { aligning: 10, ..settings() };
    let Settings { speed, current, .. } = settings;
    let list = |name: &str, count: usize| -> String {
        (0..count).map(|n| format!(",{name}[{n}]")).collect()
    };
    let mut text = "settings.speed.proportional,settings.speed.integral,settings.current.proportional,\
        settings.current.integral,settings.ramp,settings.most_current,settings.trip_current,settings.aligning,\
        settings.per_top_speed"
        .to_owned();
    text += &list("settings.weakening", settings.weakening.len());
    text += ",inputs.run,inputs.acknowledge,inputs.target,inputs.speed,inputs.angle";
    text += &(list("inputs.currents", 2) + ",inputs.supply\n");
    for inputs in life().0.iter().step_by(200) {
        let numbers = [speed.proportional, speed.integral, current.proportional, current.integral];
        let mut row: Vec<String> = numbers.iter().map(f32::to_string).collect();
        let numbers = [settings.ramp, settings.most_current, settings.trip_current];
        row.extend(numbers.iter().map(f32::to_string));
        row.extend([settings.aligning.to_string(), settings.per_top_speed.to_string()]);
        row.extend(settings.weakening.iter().map(f32::to_string));
        row.extend([inputs.run, inputs.acknowledge].map(|it| it.to_string()));
        let numbers = [inputs.target, inputs.speed, inputs.angle];
        row.extend(numbers.iter().chain(&inputs.currents).map(f32::to_string));
        row.push(inputs.supply.to_string());
        text += &(row.join(",") + "\n");
    }
    text
}

/// `BESSEMER_RECORD=1` writes it anew.
#[test]
fn the_recording_is_of_this_life() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/recorded.csv");
    if std::env::var_os("BESSEMER_RECORD").is_some() {
        std::fs::write(path, recorded()).expect("the recording");
    }
    assert_eq!(std::fs::read_to_string(path).expect("the recording"), recorded());
}
