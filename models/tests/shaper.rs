//! The shaped set point: it keeps its limits for any sequence of places, comes to rest where it is wanted, and never overshoots.

use bessemer::nalgebra::Vector3;
use bessemer::requirement;
use models::shaper::{Shaped, Shaper, Shaping};
use models::{Parameters, Settings};

const PERIOD: f64 = 0.005;

/// A sequence of numbers from -1 to 1 that looks random, the same on every machine.
fn numbers(seed: u64) -> impl FnMut() -> f64 {
    let mut state = seed;
    move || {
        state =
            state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }
}

#[test]
#[requirement("HLR-10")]
fn the_limits_hold_for_any_sequence_of_places() {
    let room = Shaping::room();
    let quick = Shaping { speed: 2.5, acceleration: 5.0, jerk: 100.0, ..room };
    let slow = Shaping { speed: 0.2, acceleration: 0.5, jerk: 5.0, ..room };
    for (seed, shaping) in [room, quick, slow].into_iter().cycle().take(60).enumerate() {
        let mut next = numbers(seed as u64 + 1);
        let mut shaper = Shaper::default();
        let (mut wanted, mut before) = (Vector3::zeros(), Shaped::default());
        let (mut least, mut most) = (Vector3::<f64>::zeros(), Vector3::<f64>::zeros());
        for n in 0..4000 {
            if n % 50 == 0 && next() > 0.0 {
                wanted = Vector3::new(3.0 * next(), 3.0 * next(), 3.0 * next());
                (least, most) = (least.inf(&wanted), most.sup(&wanted));
            }
            let now = shaper.step(&shaping, PERIOD, &wanted);
            let jerk = (now.acceleration - before.acceleration).norm() / PERIOD;
            let (speed, acceleration) = (now.velocity.norm(), now.acceleration.norm());
            assert!(speed <= shaping.speed * (1.0 + 1e-9), "{seed}, {n}: {speed} m/s");
            assert!(acceleration <= shaping.acceleration, "{seed}, {n}: {acceleration} m/s²");
            assert!(jerk <= shaping.jerk, "{seed}, {n}: {jerk} m/s³");
            // It stays among the places that were wanted.
            assert!(
                now.position.inf(&least) == least && now.position.sup(&most) == most,
                "{seed}, {n}"
            );
            before = now;
        }
    }
}

#[test]
#[requirement("HLR-10")]
fn it_comes_to_rest_where_it_is_wanted_in_a_straight_line() {
    let (shaping, wanted) = (Shaping::room(), Vector3::new(2.0, -1.0, 0.5));
    let mut shaper = Shaper::default();
    let mut way = 0.0;
    for _ in 0..2000 {
        let now = shaper.step(&shaping, PERIOD, &wanted);
        assert!(now.position.cross(&wanted).norm() < 1e-12);
        assert!(now.position.norm() >= way, "it goes back");
        way = now.position.norm();
    }
    assert!((shaper.position - wanted).norm() < 1e-6 && shaper.velocity.norm() < 1e-6);
    shaper.rest(&Vector3::repeat(0.5));
    let still = shaper.step(&shaping, PERIOD, &Vector3::repeat(0.5));
    assert_eq!(still, Shaped { position: Vector3::repeat(0.5), ..Shaped::default() });
}

#[test]
#[requirement("HLR-10")]
fn it_begins_as_fast_as_the_aircraft_is() {
    let (shaping, place) = (Shaping::room(), Vector3::new(1.0, 0.0, 0.4));
    let goal = Vector3::new(1.0, 0.0, 2.0);
    for (speed, expected) in [(0.0, 0.0), (1.2, 1.2), (9.0, shaping.speed)] {
        let mut shaper = Shaper::default();
        shaper.begin(&shaping, &place, &(Vector3::z() * speed));
        let first = shaper.step(&shaping, PERIOD, &goal);
        assert!((first.position - place).norm() < 1.01 * shaping.speed * PERIOD);
        assert!((first.velocity.z - expected).abs() < shaping.acceleration * PERIOD, "{first:?}");
        assert!(first.acceleration.norm() <= shaping.acceleration, "{first:?}");
        for _ in 0..2000 {
            let now = shaper.step(&shaping, PERIOD, &goal);
            assert!(now.acceleration.norm() <= shaping.acceleration && now.position.z < 2.0 + 1e-9);
        }
        assert!((shaper.position - goal).norm() < 1e-6);
    }
}

#[test]
fn without_shaping_a_step_is_a_step() {
    let step = Shaping { is_active: false, ..Shaping::room() };
    let wanted = Vector3::new(2.0, 1.0, 0.5);
    let now = Shaper::default().step(&step, PERIOD, &wanted);
    assert_eq!(now, Shaped { position: wanted, ..Shaped::default() });
}

#[test]
fn the_gains_differ_from_the_thesis_in_the_damping_of_the_position_alone() {
    let mut mine = Parameters::mambo();
    let thesis = Parameters::thesis();
    assert_eq!((thesis.x.d, thesis.y.d), (-0.1, -0.1));
    (mine.x.d, mine.y.d) = (-0.1, -0.1);
    assert_eq!(mine, thesis);
    assert!(Settings::mambo().course.shaping.is_active);
}
