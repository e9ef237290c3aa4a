//! The programs of the book's cookbook do what their pages say: loops are closed, and properties hold for many inputs.
//!
//! That their C has the same bits is the corpus' to show, as of any other program.

use corpus::programs::cookbook::autopilot::{Autopilot, Flight, Imu};
use corpus::programs::cookbook::debounce::{ButtonEvent, LONG_SAMPLES, PushButton, STABLE_SAMPLES};
use corpus::programs::cookbook::lookup_table::{BROKEN, NTC_COUNTS, SHORTED, thermistor};
use corpus::programs::cookbook::low_pass::{LowPass, butterworth};
use corpus::programs::cookbook::navigation::{Inertial, Navigation, advanced};
use corpus::programs::cookbook::pi::{PiController, PidParameters};
use corpus::programs::cookbook::position_servo::{PositionServo, SPEED_PERIODS, ServoParameters};
use corpus::programs::cookbook::pump::{DRY_MS, PRIMING_MS, PumpControl, PumpInputs, PumpState};
use corpus::programs::cookbook::q15_filter::{Q15, Q15LowPass};
use corpus::programs::cookbook::rate_limiter::{RateLimits, Setpoint};

/// A small motor: 20 rad/s for each volt, with a time constant of 50 ms.
#[derive(Default)]
struct Motor {
    position: f32,
    speed: f32,
}

impl Motor {
    fn step(&mut self, voltage: f32, period: f32) {
        self.speed += (20.0 * voltage - self.speed) / 0.05 * period;
        self.position += self.speed * period;
    }
}

const SPEED_LOOP: PidParameters<f32> = PidParameters {
    proportional: 0.1,
    integral: 2.0,
    derivative: 0.0,
    target_weight: 1.0,
    target_slope_weight: 0.0,
    filter: 0.0,
    tracking: 0.0,
    low: -12.0,
    high: 12.0,
    period: 1e-3,
};

#[test]
fn the_pi_loop_does_not_wind_up() {
    let (mut controller, mut motor) = (PiController::default(), Motor::default());
    let mut run = |target: f32| {
        let mut voltages = (0..1000).map(|_| {
            let voltage = controller.step(&SPEED_LOOP, target, motor.speed);
            motor.step(voltage, SPEED_LOOP.period);
            (voltage, motor.speed)
        });
        let (first, _) = voltages.next().unwrap_or_default();
        let (highest, last) =
            voltages.fold((0.0_f32, 0.0), |(most, _), (_, speed)| (most.max(speed), speed));
        (first, highest, last)
    };
    // From rest the output is at its limit for a while, and the speed does not overshoot.
    let (first, highest, last) = run(200.0);
    assert!(first == 12.0 && highest < 201.0 && (last - 200.0).abs() < 0.1, "{highest}, {last}");
    // A second at a target that cannot be reached; then the output leaves its limit at once.
    let (_, _, last) = run(400.0);
    assert!((last - 240.0).abs() < 0.1, "{last}");
    let (first, _, last) = run(200.0);
    assert!(first < 12.0 && (last - 200.0).abs() < 0.1, "{first}, {last}");
}

#[test]
fn the_pi_loop_takes_over_where_it_was_left_and_lets_no_nan_in() {
    let mut controller = PiController::default();
    controller.preset(&SPEED_LOOP, 100.0, 100.0, 5.0);
    assert_eq!(controller.step(&SPEED_LOOP, 100.0, 100.0), 5.0);
    assert_eq!(controller.step(&SPEED_LOOP, 100.0, f32::NAN), -12.0);
    assert_eq!(controller.step(&SPEED_LOOP, 100.0, 100.0), 5.0);
}

#[test]
fn the_thermistor_is_monotone_and_right_at_its_points() {
    let mut before = f32::INFINITY;
    for counts in 0..=u16::MAX {
        let Some(temperature) = thermistor(counts) else {
            assert!(!(SHORTED..=BROKEN).contains(&counts));
            continue;
        };
        assert!(temperature <= before && (0.0..=120.0).contains(&temperature), "{counts}");
        before = temperature;
        // The law that the table represents, between its ends.
        let resistance = 10e3 * f64::from(counts) / (4096.0 - f64::from(counts));
        let law = 1.0 / (1.0 / 298.15 + (resistance / 10e3).ln() / 3950.0) - 273.15;
        if (0.0..=120.0).contains(&law) {
            assert!((f64::from(temperature) - law).abs() < 1.6, "{counts}: {temperature} °C");
        }
    }
    assert!(NTC_COUNTS.points.is_sorted_by(|below, above| below < above));
}

#[test]
fn the_set_point_keeps_its_rates_and_arrives() {
    let limits = RateLimits { rise: 2.0, fall: 5.0, period: 0.01 };
    let (mut setpoint, mut before) = (Setpoint::default(), 0.2);
    assert_eq!(setpoint.step(&limits, false, 1.0, 0.2), 0.2);
    for period in 0..600 {
        let target = [1.0, -1.0, 0.3, f32::NAN][period / 150];
        let output = setpoint.step(&limits, true, target, 0.2);
        assert!((-0.0501..=0.0201).contains(&(output - before)), "{before} to {output}");
        before = output;
        if period % 150 == 149 && period < 450 {
            assert_eq!(output, target);
        }
    }
    assert_eq!(before, 0.3);
}

#[test]
fn the_low_pass_passes_what_is_slow_and_halves_the_power_at_its_cutoff() {
    let (cutoff, rate) = (50.0, 1000.0);
    let coefficients = butterworth(cutoff, rate);
    let gain = |frequency: f32| {
        let mut filter = LowPass::default();
        let wave = |n: i32| (core::f32::consts::TAU * frequency / rate * n as f32).sin();
        let settled = (0..2000).map(|n| filter.step(&coefficients, wave(n))).skip(1000);
        settled.fold(0.0_f32, |most, sample| most.max(sample.abs()))
    };
    assert!((gain(1.0) - 1.0).abs() < 0.01);
    assert!((gain(cutoff) - core::f32::consts::FRAC_1_SQRT_2).abs() < 0.01);
    assert!(gain(400.0) < 0.01);
    let mut filter = LowPass::default();
    filter.preset(&coefficients, 3.0);
    assert!((0..100).all(|_| (filter.step(&coefficients, 3.0) - 3.0).abs() < 1e-5));
}

#[test]
fn a_button_that_bounces_is_pressed_once() {
    let mut button = PushButton::default();
    let bouncing = [true, false, true, true, false].into_iter().cycle().take(20);
    let pressed = [true].into_iter().cycle().take(20);
    let mut events = bouncing.chain(pressed).map(|closed| button.sample(closed));
    assert!(events.all(|event| event == ButtonEvent::Steady));
    let released = (0..STABLE_SAMPLES).map(|_| button.sample(false));
    assert_eq!(released.last(), Some(ButtonEvent::Short));
    let mut held = (0..2 * LONG_SAMPLES).map(|_| button.sample(true));
    assert_eq!(held.position(|event| event == ButtonEvent::Long), Some(803));
    assert!((0..10).all(|_| button.sample(false) == ButtonEvent::Steady));
}

#[test]
fn a_dry_pump_stays_off_until_it_is_acknowledged() {
    let mut pump = PumpControl::default();
    let mut run = |demand, flow, acknowledge, periods: u16| {
        let inputs = PumpInputs { demand, flow, acknowledge };
        let on = (0..periods).filter(|_| pump.step(&inputs)).count();
        (on, pump.state())
    };
    assert_eq!(run(true, false, false, PRIMING_MS + 1).1, PumpState::Priming { left: 0 });
    assert_eq!(run(true, true, false, 1000), (1000, PumpState::Running { dry: 0 }));
    assert_eq!(run(true, false, false, DRY_MS).1, PumpState::Running { dry: DRY_MS });
    assert_eq!(run(true, false, false, 1), (0, PumpState::LockedOut));
    assert_eq!(run(true, true, true, 100), (0, PumpState::LockedOut));
    assert_eq!(run(false, true, false, 100), (0, PumpState::LockedOut));
    assert_eq!(run(false, false, true, 1), (0, PumpState::Off));
}

#[test]
fn the_servo_arrives_at_its_position_and_asks_for_no_more_than_its_speed() {
    let parameters = ServoParameters { stiffness: 8.0, speed_limit: 50.0, speed: SPEED_LOOP };
    let (mut servo, mut motor) = (PositionServo::default(), Motor::default());
    let mut fastest = 0.0_f32;
    for _ in 0..200 * SPEED_PERIODS {
        let voltage = servo.step(&parameters, 10.0, motor.position, motor.speed);
        motor.step(voltage, SPEED_LOOP.period);
        fastest = fastest.max(motor.speed);
    }
    assert!((motor.position - 10.0).abs() < 0.01, "{} rad", motor.position);
    assert!((45.0..60.0).contains(&fastest), "{fastest} rad/s");
}

#[test]
fn the_fixed_point_filter_is_its_floating_one_to_a_step() {
    let (mut filter, mut level) = (Q15LowPass::default(), 0.0_f64);
    let (gain, share) = (Q15(0x4000), Q15(0x0147));
    for n in 0..5000_i32 {
        let sample = Q15(((n * 7919) % 65536 - 32768) as i16);
        let output = filter.step(gain, share, sample);
        let target = f64::from((gain * sample).0) / 32768.0;
        level += f64::from(share.0) / 32768.0 * (target - level);
        assert!((f64::from(output.0) / 32768.0 - level).abs() < 1.0 / 32768.0, "{n}");
    }
    assert_eq!(Q15(i16::MIN) * Q15(i16::MIN), Q15(i16::MAX));
}

/// A hovering aircraft that is steered by the filter's estimate returns to the origin, although its gyro has a bias.
#[test]
fn an_aircraft_returns_by_the_estimate_of_the_navigation_filter() {
    let mut seed = 1_u64;
    // Uniform, with variance 1.
    let mut noise = || {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((seed >> 33) as f64 / (1_u64 << 31) as f64 - 0.5) * 12_f64.sqrt()
    };
    let period = 0.01;
    let mut filter = Navigation::default();
    let mut truth = filter.state;
    let bias = [0.02, -0.03, 0.01];
    for axis in 0..3 {
        truth[axis] = [1.5, -1.0, 0.5][axis];
        truth[axis + 9] = bias[axis];
    }
    let mut rejected = 0;
    for step in 0..6_000 {
        let seen = filter.state;
        let wanted = |axis: usize| (-0.3 * seen[axis] - seen[axis + 3]).clamp(-1.0, 1.0);
        // Pitch down accelerates to the north, roll to the right to the east.
        let rates = [0.1 * wanted(1) - seen[6], -0.1 * wanted(0) - seen[7], -seen[8]];
        let inertial = Inertial {
            rate: [0, 1, 2].map(|axis| 4.0 * rates[axis] + bias[axis]).into(),
            force: [0.0, 0.0, wanted(2) - 9.81].into(),
        };
        truth = advanced(&truth, &inertial, period);
        filter.predict(&inertial, period);
        if step % 10 == 0 {
            let spread = [0.5, 0.5, 0.5, 0.1, 0.1, 0.1];
            let measured = [0, 1, 2, 3, 4, 5].map(|n| truth[n] + spread[n] * noise());
            let report = filter.correct(&measured.into());
            rejected += u32::from(report.status != Default::default());
        }
        let covariance = filter.covariance.matrix();
        assert!(filter.covariance.is_plausible(), "step {step}");
        assert_eq!(*covariance, covariance.transpose(), "step {step}");
    }
    let far = (0..3).map(|axis| truth[axis].abs()).fold(0.0, f64::max);
    assert!(far < 0.3, "{truth}");
    for axis in [9, 10] {
        assert!((filter.state[axis] - truth[axis]).abs() < 0.003, "{} {truth}", filter.state);
    }
    assert_eq!(rejected, 0);
}

/// The autopilot's filter finds attitude, biases and field on a flight in a circle that climbs and sinks.
#[test]
fn the_autopilot_finds_attitude_and_biases() {
    use bessemer::nalgebra::{SVector, UnitQuaternion, Vector3};
    const GRAVITY: f64 = 9.80665;
    let period = 0.004;
    let gyro_bias = Vector3::new(0.01, -0.02, 0.005);
    let force_bias = Vector3::new(0.05, -0.03, 0.1);
    let field = Vector3::new(0.21, 0.03, 0.42);
    let mut attitude = UnitQuaternion::from_euler_angles(0.1, -0.05, 0.8);
    let (mut velocity, mut position) = (Vector3::new(5.0, 0.0, 0.0), Vector3::zeros());

    let mut filter = Autopilot::default();
    let mut start = SVector::<f64, 24>::zeros();
    // A heading of 0.6 rad and no bank: a fifth of a radian off.
    start[0] = f64::cos(0.3);
    start[3] = f64::sin(0.3);
    start[Flight::VELOCITY] = 5.0;
    start.fixed_rows_mut::<3>(Flight::FIELD).copy_from(&Vector3::new(0.2, 0.0, 0.4));
    let blocks =
        [(4, 0.02), (3, 0.1), (3, 0.1), (3, 1e-3), (3, 0.02), (3, 1e-3), (3, 1e-6), (2, 1.0)];
    let variances = blocks.iter().flat_map(|(size, variance)| vec![*variance; *size]);
    filter.start(&start, &SVector::from_iterator(variances));

    for step in 0..15_000_u32 {
        let time = f64::from(step) * period;
        let rates = Vector3::new(0.3 * (0.7 * time).sin(), 0.2 * (0.4 * time).cos(), 0.4);
        let acceleration =
            Vector3::new(2.0 * (0.5 * time).cos(), 2.0 * (0.5 * time).sin(), (0.3 * time).sin());
        let force = attitude.inverse() * (acceleration - Vector3::new(0.0, 0.0, GRAVITY));
        filter.predict(&Imu { rate: rates + gyro_bias, force: force + force_bias }, period);
        attitude *= UnitQuaternion::new(rates * period);
        position += velocity * period;
        velocity += acceleration * period;
        // Errors without a trend: a fixed pattern of a twentieth.
        let error = f64::from(step * 7 % 11) / 100.0 - 0.05;
        if step % 25 == 0 {
            let mut measured = SVector::<f64, 6>::zeros();
            for axis in 0..3 {
                measured[axis] = velocity[axis] + error;
                measured[axis + 3] = position[axis] - error;
            }
            assert!(filter.place(&measured), "step {step}");
        }
        if step % 25 == 12 {
            let seen = attitude.inverse() * field;
            assert!(filter.compass(&seen.add_scalar(0.1 * error)), "step {step}");
        }
        assert_eq!(*filter.covariance.matrix(), filter.covariance.matrix().transpose());
    }
    let state = &filter.state;
    let found = UnitQuaternion::from_quaternion(bessemer::nalgebra::Quaternion::new(
        state[0], state[1], state[2], state[3],
    ));
    let off = |at: usize, truth: &Vector3<f64>| (state.fixed_rows::<3>(at) - truth).amax();
    assert!(found.angle_to(&attitude) < 0.02, "{} rad", found.angle_to(&attitude));
    assert!(off(Flight::GYRO_BIAS, &gyro_bias) < 2e-3, "{state}");
    assert!(off(Flight::FORCE_BIAS, &force_bias) < 0.05, "{state}");
    assert!(
        off(Flight::VELOCITY, &velocity) < 0.1 && off(Flight::POSITION, &position) < 0.2,
        "{state}"
    );
    assert!(filter.covariance.is_plausible());
}
