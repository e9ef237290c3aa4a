//! Properties of blocks for any input.

use bessemer::nalgebra::{Quaternion, UnitQuaternion, Vector3};
use bessemer_blocks::*;
use proptest::prelude::*;

/// Any float, also infinite and NaN.
fn any_float() -> impl Strategy<Value = f64> {
    prop_oneof![4 => -1e3..1e3, 1 => any::<f64>()]
}

fn any_floats() -> impl Strategy<Value = Vec<f64>> {
    prop::collection::vec(any_float(), 1..40)
}

/// Numbers of usual size.
fn numbers() -> impl Strategy<Value = Vec<f64>> {
    prop::collection::vec(-1e3..1e3, 1..40)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(128))]

    #[test]
    fn a_pid_stays_within_its_limits_and_recovers(
        inputs in any_floats(), gains in prop::array::uniform3(0.0..100.0), tracking in 0.0..10.0,
    ) {
        let [proportional, integral, derivative] = gains;
        let parameters = PidParameters {
            proportional, integral, derivative, tracking, filter: 0.1, low: -2.0, high: 3.0, period: 0.1,
            ..PidParameters::default()
        };
        let mut pid = Pid::default();
        for input in inputs {
            let output = pid.step(&parameters, input, 0.5);
            prop_assert!((-2.0..=3.0).contains(&output));
        }
        pid.track(&parameters, 1.0, 0.25, 0.75);
        prop_assert!((pid.step(&parameters, 1.0, 0.25) - 0.75).abs() < 1e-12);
    }

    #[test]
    fn an_integral_does_not_wind_up(input in 1.0..1e6_f64) {
        let parameters = PidParameters {
            integral: 1.0, low: -1.0, high: 1.0, period: 0.1, ..PidParameters::default()
        };
        for tracking in [0.0, 5.0] {
            let (mut pid, parameters) = (Pid::default(), PidParameters { tracking, ..parameters });
            for _ in 0..1000 {
                pid.step(&parameters, input, 0.0);
            }
            let steps = (0..1000).take_while(|_| pid.step(&parameters, -1.0, 0.0) >= 1.0).count() as f64;
            // By back-calculation, the integral stays at input/tracking above the limit; by clamping within a step of it.
            let most = if tracking > 0.0 { 12.0 + 2.0 * (1.0 + input).ln() } else { 2.0 + input };
            prop_assert!(steps <= most, "{} steps", steps);
        }
    }

    #[test]
    fn filters_of_gain_one_come_to_rest_at_a_constant(frequency in 20.0..400.0, value in -10.0..10.0_f64) {
        let sections = [Section::low_pass(frequency, 0.7, 1000.0), Section::notch(frequency, 0.7, 1000.0)];
        let (mut one, mut other) = (Cascade::<f64, 2>::default(), CascadeDirect::<f64, 2>::default());
        for _ in 0..2000 {
            one.step(&sections, value);
            other.step(&sections, value);
        }
        prop_assert!((one.step(&sections, value) - value).abs() < 1e-9);
        prop_assert!((other.step(&sections, value) - value).abs() < 1e-9);
        let low_pass = FirstOrder::low_pass(1.0 / frequency, 1e-3);
        let mut filter = FirstOrderFilter::default();
        filter.preset(&low_pass, value, value);
        prop_assert!((filter.step(&low_pass, value) - value).abs() < 1e-12);
    }

    #[test]
    fn a_mean_is_within_its_window(samples in numbers()) {
        let mut moving = Moving::<f64, 5>::default();
        for (k, sample) in samples.iter().enumerate() {
            let spread = moving.spread(*sample);
            let mut window: Vec<f64> = (0..5).map(|back| samples[k.saturating_sub(back)]).collect();
            window.sort_by(f64::total_cmp);
            prop_assert!(spread.mean >= window[0] - 1e-9 && spread.mean <= window[4] + 1e-9);
            prop_assert!(spread.variance >= 0.0);
        }
    }

    #[test]
    fn a_decimator_is_the_filter_at_each_third_sample(samples in numbers()) {
        let taps = [0.5, -0.25, 0.125];
        let (mut fir, mut decimator) = (Fir::<f64, 3>::default(), Decimator::<f64, 3>::default());
        for (k, sample) in samples.iter().enumerate() {
            let (all, one) = (fir.step(&taps, *sample), decimator.step(&taps, 3, *sample));
            prop_assert_eq!(one.is_some(), k % 3 == 0);
            prop_assert!(one.is_none_or(|one| (one - all).abs() < 1e-9));
        }
    }

    #[test]
    fn an_integrator_stays_within_its_limits(samples in any_floats()) {
        let limits = IntegratorParameters { low: -1.0, high: 2.0, period: 0.5 };
        let (mut integrator, mut derivative) = (Integrator::default(), Derivative::default());
        for sample in samples {
            prop_assert!((-1.0..=2.0).contains(&integrator.step(&limits, sample)));
            prop_assert!(!derivative.step(0.1, 0.5, sample).is_nan());
        }
        integrator.reset(0.5);
        prop_assert_eq!(integrator.step(&limits, 7.0), 0.5);
    }

    #[test]
    fn rates_are_limited_and_targets_reached(targets in any_floats(), last in -5.0..5.0_f64) {
        let limits = RateLimits { rise: 2.0, fall: 4.0, period: 0.1 };
        let smooth = JerkLimits { rate: 3.0, acceleration: 8.0, period: 0.01 };
        let (mut limiter, mut jerk) = (RateLimiter::default(), JerkLimiter::default());
        let (mut before, mut motion) = (0.0, Motion::<f64>::default());
        for target in targets {
            let output = limiter.step(&limits, target);
            prop_assert!((-0.4 - 1e-9..=0.2 + 1e-9).contains(&(output - before)));
            before = output;
            let next = jerk.step(&smooth, target);
            prop_assert!(next.rate.abs() <= 3.0 && (next.rate - motion.rate).abs() <= 0.08 + 1e-9);
            motion = next;
        }
        for _ in 0..1000 {
            before = limiter.step(&limits, last);
        }
        prop_assert_eq!(before, last);
        jerk.preset(0.0);
        // The overshoot is less than acceleration · period².
        let highest = (0..5000).map(|_| jerk.step(&smooth, last).value.abs()).fold(0.0, f64::max);
        prop_assert!((highest - last.abs()).abs() < 8.0 * 1e-4, "{} for {}", highest, last);
    }

    #[test]
    fn limited_values(value in any_float(), other in -3.0..3.0_f64) {
        let limited = saturated(value, -1.0, 2.0);
        prop_assert!((-1.0..=2.0).contains(&limited.value));
        prop_assert_eq!(limited.is_low || limited.is_high, limited.value != value);
        prop_assert!(!(limited.is_low && limited.is_high));
        let off = dead_band(value, 0.5);
        prop_assert!(value.is_nan() && off == 0.0 || off.abs() <= value.abs());
        prop_assert_eq!(dead_band(-other, 0.5), -dead_band(other, 0.5));
    }

    #[test]
    fn hysteresis_changes_only_beyond_its_levels(values in any_floats()) {
        let (mut hysteresis, mut before) = (Hysteresis::default(), false);
        for value in values {
            let is_on = hysteresis.step(2.0, -2.0, value);
            prop_assert_eq!(is_on, value >= 2.0 || before && (value > -2.0 || value.is_nan()));
            before = is_on;
        }
    }

    #[test]
    fn a_table_is_between_its_neighbours(steps in prop::array::uniform6(0.01..10.0), at in any_float()) {
        let mut points = steps;
        for k in 1..6 {
            points[k] += points[k - 1];
        }
        let (axis, values) = (Axis { points }, [3.0, -1.0, 2.0, 7.0, 7.0, 0.0]);
        let place = axis.place(at, Beyond::Hold);
        let (low, high) = (values[place.below as usize], values[place.below as usize + 1]);
        let found = interpolated(&values, place);
        prop_assert!(found >= low.min(high) - 1e-12 && found <= low.max(high) + 1e-12);
        prop_assert_eq!(Search::default().place(&axis, at, Beyond::Hold), place);
        prop_assert!(interpolated(&values, axis.place(points[3], Beyond::Extend)) == 7.0);
    }

    /// The limits hold, one of them is active at each time, and the integral of the jerk is the motion: so no motion is
    /// faster.
    #[test]
    fn an_s_curve_is_the_fastest_within_its_limits(
        distance in -20.0..20.0_f64, speed in 0.1..5.0, acceleration in 0.1..10.0, jerk in 0.5..50.0,
    ) {
        prop_assume!(distance.abs() > 1e-3);
        let curve = SCurve::plan(distance, speed, acceleration, jerk);
        prop_assert!((curve.at(curve.duration()).position - distance).abs() < 1e-9);
        let step = curve.duration() / 1000.0;
        let mut before: Point<f64> = curve.at(0.37 * step);
        for k in 1..999 {
            let at = curve.at((f64::from(k) + 0.37) * step);
            prop_assert!(at.speed.abs() <= speed * (1.0 + 1e-9));
            prop_assert!(at.acceleration.abs() <= acceleration * (1.0 + 1e-9));
            prop_assert!((at.position - before.position).abs() <= speed * step * (1.0 + 1e-9) + 1e-12);
            prop_assert!((at.speed - before.speed).abs() <= acceleration * step * (1.0 + 1e-9) + 1e-12);
            let bend = (at.acceleration - before.acceleration).abs();
            prop_assert!(bend <= jerk * step * (1.0 + 1e-6) + 1e-9);
            let is_active = at.jerk.abs() >= jerk * (1.0 - 1e-9)
                || at.acceleration.abs() >= acceleration * (1.0 - 1e-9)
                || at.speed.abs() >= speed * (1.0 - 1e-9);
            prop_assert!(is_active, "{:?}", at);
            before = at;
        }
    }

    #[test]
    fn a_trapezoid_is_the_fastest_within_its_limits(
        distance in -20.0..20.0_f64, speed in 0.1..5.0, acceleration in 0.1..10.0,
    ) {
        prop_assume!(distance.abs() > 1e-3);
        let motion = Trapezoid::plan(distance, speed, acceleration);
        prop_assert!((motion.at(motion.duration()).position - distance).abs() < 1e-9);
        let step = motion.duration() / 500.0;
        let mut before: Point<f64> = motion.at(0.37 * step);
        for k in 1..499 {
            let at = motion.at((f64::from(k) + 0.37) * step);
            prop_assert!(at.speed.abs() <= speed * (1.0 + 1e-9));
            prop_assert!((at.position - before.position).abs() <= speed * step * (1.0 + 1e-9) + 1e-12);
            prop_assert!((at.speed - before.speed).abs() <= acceleration * step * (1.0 + 1e-9) + 1e-12);
            let is_active = at.acceleration.abs() >= acceleration * (1.0 - 1e-9)
                || at.speed.abs() >= speed * (1.0 - 1e-9);
            prop_assert!(is_active, "{:?}", at);
            before = at;
        }
    }

    #[test]
    fn frames_of_a_motor_are_inverse(alpha in -9.0..9.0_f64, beta in -9.0..9.0_f64, angle in -9.0_f64..9.0) {
        let vector = Stator { alpha, beta };
        let [a, b, c] = clarke_inverse(vector);
        prop_assert!((a + b + c).abs() < 1e-12);
        let back = clarke(a, b);
        prop_assert!((back.alpha - alpha).abs() < 1e-12 && (back.beta - beta).abs() < 1e-12);
        let (sine, cosine) = angle.sin_cos();
        let back = park_inverse(park(vector, sine, cosine), sine, cosine);
        prop_assert!((back.alpha - alpha).abs() < 1e-12 && (back.beta - beta).abs() < 1e-12);
        // The duties give the voltages between the phases.
        let modulated = space_vector(vector, 24.0);
        prop_assert!((24.0 * (modulated.duties[0] - modulated.duties[1]) - (a - b)).abs() < 1e-12);
    }

    #[test]
    fn a_loop_locks_to_a_constant_speed(speed in -200.0..200.0_f64, phase in -3.0..3.0_f64) {
        let gains = PllGains { proportional: 200.0, integral: 10_000.0, period: 1e-3 };
        let mut pll = Pll::default();
        for k in 0..3000 {
            let (beta, alpha) = (phase + speed * 1e-3 * f64::from(k)).sin_cos();
            pll.step(&gains, Stator { alpha, beta });
        }
        prop_assert!((pll.speed() - speed).abs() < 1e-6);
        pll.step(&gains, Stator { alpha: f64::NAN, beta: 0.0 });
        prop_assert!((pll.speed() - speed).abs() < 1e-6);
    }

    #[test]
    fn an_attitude_stays_a_rotation(samples in prop::collection::vec(prop::array::uniform6(any_float()), 1..20)) {
        let (mut mahony, mut madgwick) = (Mahony::default(), Madgwick::default());
        let gains = MahonyGains { proportional: 1.0, integral: 0.1, period: 0.01 };
        for [a, b, c, d, e, f] in samples {
            let (rates, force) = (Vector3::new(a, b, c), Vector3::new(d, e, f));
            let one = mahony.step(&gains, &rates, &force);
            let other = madgwick.step(&MadgwickGain { gain: 0.1, period: 0.01 }, &rates, &force);
            prop_assert!((one.norm() - 1.0).abs() < 1e-9 && (other.norm() - 1.0).abs() < 1e-9);
        }
    }

    #[test]
    fn a_torque_points_to_the_target(numbers in prop::array::uniform4(-1.0..1.0)) {
        let [w, i, j, k] = numbers;
        prop_assume!(Quaternion::new(w, i, j, k).norm() > 0.1);
        let target = UnitQuaternion::from_quaternion(Quaternion::new(w, i, j, k));
        let level = UnitQuaternion::identity();
        let gains = AttitudeGains { stiffness: Vector3::repeat(2.0), ..AttitudeGains::default() };
        let torque = attitude_torque(&gains, &level, &Vector3::zeros(), &target, &Vector3::zeros());
        prop_assert!(torque.dot(&Vector3::new(i, j, k)) * w >= 0.0);
    }

    #[test]
    fn positions_come_back(latitude in -1.57..1.57_f64, longitude in -3.1..3.1_f64, height in -1e6..1e8_f64) {
        let position = Geodetic { latitude, longitude, height };
        let back = geodetic_from_ecef(&ecef_from_geodetic(&position));
        prop_assert!((back.latitude - latitude).abs() < 1e-12 && (back.longitude - longitude).abs() < 1e-12);
        prop_assert!((back.height - height).abs() < 1e-6 * (1.0 + height.abs() * 1e-6));
    }

    #[test]
    fn a_signal_comes_back_within_half_a_step(
        start in 0_u8..64, bits in 1_u8..=32, value in any_float(), is_signed: bool, frame: [u8; 8],
    ) {
        let bits = bits.min(64 - start);
        let signal = Signal { start, bits, is_signed, scale: 0.25, offset: 3.0, ..Signal::default() };
        let mut written = frame;
        write_signal(&mut written, &signal, value);
        let (steps, sign) = (2_f64.powi(i32::from(bits)), f64::from(u8::from(is_signed)));
        let (low, high) = (3.0 - 0.125 * steps * sign, 2.75 + 0.25 * steps - 0.125 * steps * sign);
        let meant = if value.is_nan() { 3.0 } else { value.max(low).min(high) };
        prop_assert!((read_signal(&written, &signal) - meant).abs() <= 0.125 + 1e-9 * meant.abs());
        let mask = ((1_u128 << bits) - 1) << start;
        let others = |frame| u128::from(u64::from_le_bytes(frame)) & !mask;
        prop_assert_eq!(others(written), others(frame));
    }

    #[test]
    fn a_checksum_detects_a_changed_bit(text in prop::collection::vec(any::<u8>(), 1..40), bit in 0_usize..8) {
        let mut changed = text.clone();
        changed[0] ^= 1 << bit;
        prop_assert_ne!(crc8(&CRC8_SMBUS, 0, &text), crc8(&CRC8_SMBUS, 0, &changed));
        prop_assert_ne!(crc16(&CRC16_CCITT, 0, &text), crc16(&CRC16_CCITT, 0, &changed));
        prop_assert_ne!(crc32(&CRC32_IEEE, 0, &text), crc32(&CRC32_IEEE, 0, &changed));
    }
}
