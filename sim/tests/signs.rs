//! Flipping the sign of any one gain or mixer entry fails the flight.
//!
//! Left out: the gains that the thesis sets to 0 (the integral of yaw), which have no sign.

use models::Parameters;
use sim::verdict::{Fault, judge};
use sim::{Mission, Native, Tolerance, Vehicle, fly};

/// A named number among the parameters.
type Knob = (&'static str, fn(&mut Parameters) -> &mut f64);

const GAINS: [Knob; 16] = [
    ("take-off", |p| &mut p.takeoff_gain),
    ("height P", |p| &mut p.height.p),
    ("height I", |p| &mut p.height.i),
    ("height D", |p| &mut p.height.d),
    ("x P", |p| &mut p.x.p),
    ("x D", |p| &mut p.x.d),
    ("y P", |p| &mut p.y.p),
    ("y D", |p| &mut p.y.d),
    ("roll P", |p| &mut p.roll.p),
    ("roll I", |p| &mut p.roll.i),
    ("roll D", |p| &mut p.roll.d),
    ("pitch P", |p| &mut p.pitch.p),
    ("pitch I", |p| &mut p.pitch.i),
    ("pitch D", |p| &mut p.pitch.d),
    ("yaw P", |p| &mut p.yaw.p),
    ("yaw D", |p| &mut p.yaw.d),
];

/// Returns the faults of the flight with these parameters.
fn faults(parameters: Parameters) -> Vec<Fault> {
    let mission = Mission::every_channel();
    let mut pilot = Native::new(parameters);
    // The plant and its control period stay those of the Mambo, whatever the pilot believes.
    let flight = fly(&Vehicle::mambo(), &Parameters::mambo(), &mission, &mut pilot);
    judge(&flight, &mission, &Tolerance::default())
}

#[test]
fn the_thesis_gains_fly() {
    assert_eq!(faults(Parameters::mambo()), []);
}

#[test]
fn every_gain_has_its_sign() {
    for (name, knob) in GAINS {
        let mut parameters = Parameters::mambo();
        let gain = knob(&mut parameters);
        assert!(*gain != 0.0, "{name} has no sign");
        *gain = -*gain;
        assert!(!faults(parameters).is_empty(), "{name} may as well be negated");
    }
}

#[test]
fn every_mixer_entry_has_its_sign() {
    for motor in 0..4 {
        for load in 0..4 {
            let mut parameters = Parameters::mambo();
            let entry = &mut parameters.mixer.allocation[(motor, load)];
            assert!(*entry != 0.0, "entry ({motor}, {load}) has no sign");
            *entry = -*entry;
            let faults = faults(parameters);
            assert!(!faults.is_empty(), "entry ({motor}, {load}) may as well be negated");
        }
    }
}
