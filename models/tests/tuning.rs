//! The parameters that the ground can change: their ranges hold those that fly, and nothing out of them is taken.

use bessemer::requirement;
use models::receiver::{Request, Wish};
use models::tuning::{
    FIRST_GROUND_ONLY, HEXACOPTER_LARGEST_VALUES, HEXACOPTER_LEAST_VALUES, LARGEST_VALUES,
    LEAST_VALUES, PARAMETER_COUNT, values,
};
use models::{Candidate, Settings};

/// The settings of each airframe, with the least and the largest values of their parameters.
fn airframes() -> [(Settings, [[f64; PARAMETER_COUNT]; 2]); 2] {
    [
        (Settings::mambo(), [LEAST_VALUES, LARGEST_VALUES]),
        (Settings::hexacopter(), [HEXACOPTER_LEAST_VALUES, HEXACOPTER_LARGEST_VALUES]),
    ]
}

#[test]
fn each_number_reads_and_writes_the_same_parameter() {
    for (settings, [least, largest]) in airframes() {
        let now = values(&settings);
        for n in 0..PARAMETER_COUNT {
            assert!((least[n]..=largest[n]).contains(&now[n]), "parameter {n}");
            let mut changed = settings;
            assert!(changed.set(n as u8, largest[n], false));
            let then = values(&changed);
            for other in 0..PARAMETER_COUNT {
                let expected = if other == n { largest[n] } else { now[other] };
                assert_eq!(then[other], expected, "parameter {other} after {n}");
            }
            assert_eq!(changed.parameter(n as u8), largest[n]);
        }
        assert!(settings.parameter(200).is_nan());
    }
}

#[test]
#[requirement("HLR-32")]
fn what_is_out_of_range_or_unsafe_in_flight_is_refused() {
    for (initial, [least, largest]) in airframes() {
        let mut settings = initial;
        for n in 0..PARAMETER_COUNT {
            for value in [least[n] - 1e-3, largest[n] + 1e-3, f64::NAN, f64::INFINITY] {
                assert!(!settings.set(n as u8, value, false), "{value} for {n}");
            }
            assert_eq!(settings.set(n as u8, largest[n], true), n < FIRST_GROUND_ONLY);
            settings = initial;
        }
        assert!(!settings.set(PARAMETER_COUNT as u8, 0.0, false));
        assert_eq!(settings, initial);
    }
}

#[test]
#[requirement("HLR-32")]
fn a_wish_is_granted_or_not() {
    let mut settings = Settings::mambo();
    let wish = Wish { request: Request::Set, number: 19, value: 2.0, ..Wish::default() };
    assert!(!settings.grant(&wish, true));
    assert!(settings.grant(&wish, false));
    assert_eq!(settings.parameters.candidate, Candidate::Geometric);
    let mut chosen = Wish { request: Request::Choose, ..Wish::default() };
    chosen.choice.every = 2;
    assert!(settings.grant(&chosen, true));
    assert_eq!(settings.choice.every, 2);
    assert!(!settings.grant(&Wish::default(), true));
}
