//! The parameters that the ground can change: their ranges hold those that fly, and nothing out of them is taken.

use models::receiver::{Request, Wish};
use models::tuning::{FIRST_GROUND_ONLY, LARGEST_VALUES, LEAST_VALUES, PARAMETER_COUNT, values};
use models::{Candidate, Settings};

#[test]
fn each_number_reads_and_writes_the_same_parameter() {
    for n in 0..PARAMETER_COUNT {
        let settings = Settings::mambo();
        let now = values(&settings);
        assert!((LEAST_VALUES[n]..=LARGEST_VALUES[n]).contains(&now[n]), "parameter {n}");
        let mut changed = settings;
        assert!(changed.set(n as u8, LARGEST_VALUES[n], false));
        let then = values(&changed);
        for other in 0..PARAMETER_COUNT {
            let expected = if other == n { LARGEST_VALUES[n] } else { now[other] };
            assert_eq!(then[other], expected, "parameter {other} after {n}");
        }
        assert_eq!(changed.parameter(n as u8), LARGEST_VALUES[n]);
    }
    assert!(Settings::mambo().parameter(200).is_nan());
}

#[test]
fn what_is_out_of_range_or_unsafe_in_flight_is_refused() {
    let mut settings = Settings::mambo();
    for n in 0..PARAMETER_COUNT {
        for value in [LEAST_VALUES[n] - 1e-3, LARGEST_VALUES[n] + 1e-3, f64::NAN, f64::INFINITY] {
            assert!(!settings.set(n as u8, value, false), "{value} for {n}");
        }
        assert_eq!(settings.set(n as u8, LARGEST_VALUES[n], true), n < FIRST_GROUND_ONLY);
        settings = Settings::mambo();
    }
    assert!(!settings.set(PARAMETER_COUNT as u8, 0.0, false));
    assert_eq!(settings, Settings::mambo());
}

#[test]
fn a_wish_is_granted_or_not() {
    let mut settings = Settings::mambo();
    let last = (PARAMETER_COUNT - 1) as u8;
    let wish = Wish { request: Request::Set, number: last, value: 2.0, ..Wish::default() };
    assert!(!settings.grant(&wish, true));
    assert!(settings.grant(&wish, false));
    assert_eq!(settings.parameters.candidate, Candidate::Geometric);
    let mut chosen = Wish { request: Request::Choose, ..Wish::default() };
    chosen.choice.every = 2;
    assert!(settings.grant(&chosen, true));
    assert_eq!(settings.choice.every, 2);
    assert!(!settings.grant(&Wish::default(), true));
}
