//! Sensors: delay, outliers, limits and faults, each by its values.

use std::cell::RefCell;
use std::rc::Rc;

use bessemer_sim::*;

use super::loops::{Tank, level, run, scenario, setup};

/// Returns the recorded times, ns, and values of the sensor `a` of this quality, whose plant's level is the time in s.
fn read(period: u32, quality: Quality, scenario: &Scenario<f64, f64>) -> (Vec<u64>, Vec<f64>) {
    let recording = run(setup([level("a", period, quality)]), scenario);
    let channel = recording.channel("a").expect("it is recorded");
    (channel.times().to_vec(), channel.values().to_vec())
}

fn near(values: &[f64], expected: &[f64]) -> bool {
    let pairs = values.iter().zip(expected);
    values.len() == expected.len() && pairs.into_iter().all(|(a, b)| (a - b).abs() < 1e-12)
}

/// A delay moves each reading by whole ticks, also past the ticks at which anything else is due, and changes no value.
#[test]
fn a_delayed_reading_has_the_bits_of_its_sample() {
    let quality = Quality { noise: 0.1, walk: 0.1, dropout: 0.3, ..Quality::default() };
    let (times, values) = read(2, quality, &scenario(0.1));
    for delay in [1, 2, 3, 7] {
        let late = read(2, Quality { delay, ..quality }, &scenario(0.1));
        let arrived =
            times.iter().filter(|time| **time + u64::from(delay) * 1_000_000 <= 100_000_000);
        let arrivals: Vec<u64> = arrived.map(|time| time + u64::from(delay) * 1_000_000).collect();
        assert_eq!(late, (arrivals.clone(), values[..arrivals.len()].to_vec()), "{delay}");
    }
}

/// The computer gets the sample of `delay` ticks ago, and nothing before the first one arrives.
#[test]
fn the_computer_reads_the_past() {
    let steps = Rc::new(RefCell::new(Vec::new()));
    let seen = Rc::clone(&steps);
    let mut computer = move |readings: &[Reading; 1], goal: &f64| {
        seen.borrow_mut().push((readings[0].value, readings[0].is_fresh));
        *goal
    };
    let quality = Quality { delay: 6, ..Quality::default() };
    let setup: Setup<Tank, 1, 1> = setup([level("a", 4, quality)]);
    setup.run(&scenario(0.02), &mut computer).expect("it runs");
    // Steps are at 0, 4, 8 … ms; the sample of 4 ms arrives at 10 ms.
    let (values, fresh): (Vec<f64>, Vec<bool>) = steps.borrow().iter().copied().unzip();
    assert!(near(&values, &[0.0, 0.0, 0.0, 0.004, 0.008, 0.012]), "{values:?}");
    assert_eq!(fresh, [false, false, true, true, true, true]);
}

/// Outliers are as frequent as their probability, uniform up to their size, and change no other reading.
#[test]
fn outliers_are_rare_and_bounded() {
    let quality = Quality { noise: 0.01, ..Quality::default() };
    let long = scenario(20.0);
    let (_, usual) = read(1, quality, &long);
    let (_, wild) = read(1, Quality { outliers: 0.1, outlier_size: 5.0, ..quality }, &long);
    let errors: Vec<f64> = wild.iter().zip(&usual).map(|(a, b)| a - b).collect();
    let outliers: Vec<f64> = errors.into_iter().filter(|error| *error != 0.0).collect();
    let (n, count) = (20_001.0_f64, outliers.len() as f64);
    assert!((count / n - 0.1).abs() < 5.0 * (0.09 / n).sqrt(), "{count}");
    assert!(outliers.iter().all(|error| error.abs() <= 5.0));
    // The variance of a uniform number is a third of its bound's square, and that of its square 4/45 of the fourth power.
    let square = outliers.iter().map(|error| error * error).sum::<f64>() / count;
    assert!((square / 25.0 - 1.0 / 3.0).abs() < 5.0 * (4.0 / 45.0 / count).sqrt(), "{square}");
    let mean = outliers.iter().sum::<f64>() / count;
    assert!(mean.abs() < 5.0 * (25.0 / 3.0 / count).sqrt(), "{mean}");
    // The bits are those of every machine.
    let first = outliers.first().map(|error| (error * 1e6).round());
    assert_eq!(first, Some(-3_827_061.0));
}

#[test]
fn readings_stay_within_limits() {
    let quality = Quality { resolution: 0.004, limits: Some((0.001, 0.006)), ..Quality::default() };
    let (_, values) = read(1, quality, &scenario(0.008));
    assert!(
        near(&values, &[0.001, 0.001, 0.004, 0.004, 0.004, 0.004, 0.006, 0.006, 0.006]),
        "{values:?}"
    );
}

/// A drift begins with 0 and ends with its fault; a stuck sensor with a delay repeats its sample, not an arrived reading.
#[test]
fn a_drift_grows_and_a_late_sensor_sticks() {
    let fault = |from, until, kind| Fault { sensor: "a".to_owned(), from, until, kind };
    let mut drifting = scenario(0.005);
    drifting.faults = vec![fault(0.002, 0.005, FaultKind::Drift(10.0))];
    let (_, values) = read(1, Quality::default(), &drifting);
    assert!(near(&values, &[0.0, 0.001, 0.002, 0.013, 0.024, 0.005]), "{values:?}");

    let mut stuck = scenario(0.008);
    stuck.faults = vec![fault(0.004, 0.006, FaultKind::Stuck)];
    let (times, values) = read(1, Quality { delay: 2, ..Quality::default() }, &stuck);
    assert_eq!(times.first(), Some(&2_000_000));
    assert!(near(&values, &[0.0, 0.001, 0.002, 0.003, 0.003, 0.003, 0.006]), "{values:?}");
}
