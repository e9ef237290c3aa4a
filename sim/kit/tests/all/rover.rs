//! The rover of the example: what its events and its receiver's outage do to it.

#![allow(dead_code)]

#[path = "../../examples/rover.rs"]
mod example;

use example::run;

/// It drives where it is sent, rests while it hears nothing, goes on afterwards, and rolls out without its drive.
#[test]
fn a_rover_follows_its_events() {
    for seed in 0..5 {
        let recording = run(seed).expect("it runs");
        let position = recording.channel("position").expect("it is recorded");
        let at = |time: f64| position.between(time, time)[0];
        assert!(at(1.0).abs() < 0.1 && at(1.5) > 0.05, "{} {}", at(1.0), at(1.5));
        assert!((at(14.0) - 2.0).abs() < 0.1, "{}", at(14.0));
        // It heard the order, and then nothing: 1 s of patience, and friction with a time constant of 1 s.
        assert!(at(17.0) > 2.2 && at(24.0) < 4.5, "{} {}", at(17.0), at(24.0));
        assert!(at(24.0) - at(22.0) < 0.02, "{} {}", at(22.0), at(24.0));
        assert!((at(29.9) - 5.0).abs() < 0.2, "{}", at(29.9));
        assert!((at(39.0) - at(30.0)).abs() < 0.2, "{} {}", at(30.0), at(39.0));

        let received = recording.channel("received").expect("it is recorded");
        assert_eq!(received.between(16.0, 23.99), [0.0; 0]);
        let arrived = received.values().len();
        assert!((128..=158).contains(&arrived), "{arrived} of 160");
        assert_eq!(run(seed).expect("it runs").csv(), recording.csv());
    }
    assert_ne!(run(0).expect("it runs").csv(), run(1).expect("it runs").csv());
}
