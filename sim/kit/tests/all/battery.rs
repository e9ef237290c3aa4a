//! The battery of the example, against the closed form of its circuit.

#![allow(dead_code)]

#[path = "../../examples/battery.rs"]
mod example;

use example::{CELLS, CURRENT, OVERVOLTAGE, PACK, UNEVEN, charged, rest_voltage, stuck};

/// The filter finds the charge from a wrong start and with a biased current; counting coulombs does not.
#[test]
fn a_pack_is_charged_and_balanced() {
    let recording = charged().expect("it runs").recording;
    let last = |name: String| {
        let channel = recording.channel(&name).expect("it is recorded");
        channel.last().expect("a sample")
    };
    let charges: Vec<f64> = (0..CELLS).map(|cell| last(format!("charge_{cell}"))).collect();
    for (cell, charge) in charges.iter().enumerate() {
        let estimate = last(format!("estimate_{cell}"));
        println!("cell {cell}: charge {charge}, estimate {estimate}");
        assert!((estimate - charge).abs() < 0.003, "cell {cell}: {estimate} for {charge}");
    }
    assert!((last("counted".to_owned()) - charges[0]).abs() > 0.1);
    // Before, 3 % lie between them.
    let spread =
        charges.iter().copied().fold(0.0, f64::max) - charges.iter().copied().fold(1.0, f64::min);
    println!("spread {spread}");
    assert!(spread < 0.004, "{charges:?}");
    // The emptiest cell gains what 3 A bring in 2400 s: 40 %.
    assert!((charges[2] - 0.75).abs() < 1e-3, "{charges:?}");
}

/// A constant current I raises the charge by I t/Q, and the capacitor's voltage to I R (1 − exp(−t/RC)).
#[test]
fn hardware_opens_the_contactor_at_the_overvoltage() {
    let run = stuck().expect("it runs");
    let voltage = |time: f64| {
        let charge = UNEVEN[1] + CURRENT * time / PACK.capacity;
        let rise = 1.0 - (-time / (PACK.parallel * PACK.capacitor)).exp();
        rest_voltage(charge) + CURRENT * (PACK.series + PACK.parallel * rise)
    };
    let (mut below, mut above) = (0.0, 1500.0);
    for _ in 0..100 {
        let middle = 0.5 * (below + above);
        if voltage(middle) < OVERVOLTAGE { below = middle } else { above = middle }
    }
    println!("{:?}, theory {above}", run.events);
    assert_eq!((run.events.len(), run.events[0].event), (1, 1));
    assert!((run.events[0].time - above).abs() < 1e-3, "{:?} for {above}", run.events);
    assert!(run.plant.is_tripped);
    // Without a current the charge stays.
    let expected = UNEVEN[1] + CURRENT * above / PACK.capacity;
    assert!((run.state[1] - expected).abs() < 1e-6, "{} for {expected}", run.state[1]);
}
