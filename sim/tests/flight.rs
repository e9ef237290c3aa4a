//! The flight that uses every channel of the controller: it settles, saturates and lands.

use bessemer::requirement;
use models::Parameters;
use sim::verdict::{judge, saturations, settled};
use sim::{Flight, Mission, Native, Tolerance, Vehicle, fly};

fn flown() -> (Mission, Flight) {
    let parameters = Parameters::mambo();
    let mission = Mission::every_channel();
    let mut pilot = Native::new(parameters);
    let flight = fly(&Vehicle::mambo(), &parameters, &mission, &mut pilot);
    (mission, flight)
}

#[test]
#[requirement("HLR-06")]
fn it_settles_after_each_manoeuvre_and_lands() {
    let (mission, flight) = flown();
    let tolerance = Tolerance::default();
    let faults = judge(&flight, &mission, &tolerance);
    let lines: Vec<String> = faults.iter().map(ToString::to_string).collect();
    assert!(faults.is_empty(), "{lines:#?}");
    assert_eq!(settled(&flight, &mission, tolerance.window).len(), 3);
}

#[test]
fn it_takes_six_thousand_steps() {
    assert_eq!(flown().1.steps.len(), 6000);
}

#[test]
fn motors_saturate_at_both_ends() {
    let (_, flight) = flown();
    let found = saturations(&flight, Parameters::mambo().mixer.largest_command);
    for upper in [true, false] {
        assert!(found.iter().any(|at| at.upper == upper), "{found:#?}");
    }
}

#[test]
fn it_stays_off_the_floor_until_it_lands() {
    let (_, flight) = flown();
    let touched = |step: &&sim::Step| step.time > 0.0 && step.state.position.z <= 0.0;
    let first = flight.steps.iter().find(touched).expect("it lands");
    assert!((29.2..29.5).contains(&first.time), "{}", first.time);
}

#[test]
fn flying_twice_gives_the_same_bits() {
    assert_eq!(flown().1, flown().1);
}
