//! The drive of the example, against the theory of its loops.

#![allow(dead_code)]

#[path = "../../examples/drive/main.rs"]
mod example;

use example::{LOAD, MOTOR, SPEED_FREQUENCY, TARGET, run};

fn mean(values: &[f64]) -> f64 {
    values.iter().sum::<f64>() / values.len() as f64
}

/// With ideal currents, a load step T lowers a critically damped speed by T/(J w e) at most, after 1/w.
#[test]
fn a_drive_holds_its_speed_under_load() {
    let recording = run(1).expect("it runs").recording;
    let channel = |name: &str| recording.channel(name).expect("it is recorded");
    let speed = channel("speed");
    for (from, until) in [(0.18, 0.199), (0.35, 0.399), (0.55, 0.6)] {
        assert!((mean(speed.between(from, until)) - TARGET).abs() < 0.05);
    }
    let lowest = speed.between(0.2, 0.4).iter().copied().fold(f64::INFINITY, f64::min);
    let highest = speed.between(0.4, 0.6).iter().copied().fold(0.0, f64::max);
    let dip = LOAD / (MOTOR.inertia * SPEED_FREQUENCY * std::f64::consts::E);
    println!("lowest {lowest}, highest {highest}, theory {dip}");
    assert!(((TARGET - lowest) / dip - 1.0).abs() < 0.15, "{lowest}, for a dip of {dip}");
    assert!(((highest - TARGET) / dip - 1.0).abs() < 0.15, "{highest}, for a dip of {dip}");

    // The balance of torques: load and friction.
    let expected = (LOAD + MOTOR.friction * TARGET) / MOTOR.torque_constant();
    let current = mean(channel("quadrature").between(0.35, 0.399));
    println!("current {current}, theory {expected}");
    assert!((current / expected - 1.0).abs() < 0.01, "{current} A, for {expected} A");
    assert!(mean(channel("direct").between(0.35, 0.399)).abs() < 0.02);
}

/// The bits of a run depend on its seed alone.
#[test]
fn a_drive_repeats_its_bits() {
    let runs = [1, 1, 2].map(|seed| run(seed).expect("it runs").recording);
    assert_eq!(runs[0], runs[1]);
    assert_ne!(runs[0], runs[2]);
}
