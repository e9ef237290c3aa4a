//! The plant against physics, and against the model that knows the same geometry.

use models::{Airframe, Orientation};
use nalgebra::{Vector3, Vector4};
use sim::plant::{Body, GRAVITY, Loads, angle_rates, rotation};
use sim::{Layout, State, Vehicle};

fn body() -> Body {
    let airframe = Airframe::mambo();
    Body { mass: airframe.mass, inertia: airframe.inertia }
}

#[test]
fn plant_and_model_share_their_geometry() {
    let angles = Vector3::new(0.4, -0.7, 2.1);
    let rates = Vector3::new(0.3, 1.2, -0.8);
    let orientation = Orientation::of(&angles);
    assert!((orientation.rotation() - rotation(&angles)).norm() < 1e-15);
    assert!((orientation.angle_rates(&rates) - angle_rates(&angles, &rates)).norm() < 1e-15);
}

#[test]
fn vehicle_and_model_share_their_motors() {
    let squares = Vector4::new(1e6, 2e6, 3e6, 4e6);
    let expected = Airframe::mambo().effectiveness() * squares;
    let (thrust, torque) = Vehicle::mambo().loads(squares.as_slice());
    let loads = Vector4::new(thrust, torque.x, torque.y, torque.z);
    assert!((loads - expected).norm() < 1e-15, "{loads}");
}

#[test]
fn any_even_number_of_equal_motors_balances() {
    for layout in [Layout::Plus, Layout::Cross] {
        for count in [2, 4, 6, 8] {
            let vehicle = Vehicle::new(&Airframe::mambo(), layout, count);
            let (thrust, torque) = vehicle.loads(&vec![1e6; count]);
            assert!(thrust > 0.0);
            assert!(torque.norm() < 1e-17, "{layout:?} {count}: {torque}");
        }
    }
}

#[test]
fn falling_is_a_parabola() {
    let start = State { position: Vector3::new(0.0, 0.0, 10.0), ..State::default() };
    let mut state = start;
    for _ in 0..200 {
        state = state.after(&body(), &Loads::default(), 0.005);
    }
    assert!((state.position.z - (10.0 - GRAVITY / 2.0)).abs() < 1e-12);
    assert!((state.velocity.z + GRAVITY).abs() < 1e-12);
}

#[test]
fn tumbling_keeps_energy_and_angular_momentum() {
    let body = body();
    let energy = |state: &State| state.rates.dot(&body.inertia.component_mul(&state.rates));
    let momentum =
        |state: &State| rotation(&state.angles) * body.inertia.component_mul(&state.rates);
    let start = State {
        position: Vector3::new(0.0, 0.0, 100.0),
        rates: Vector3::new(1.0, 0.2, 2.0),
        ..State::default()
    };
    let mut state = start;
    for _ in 0..400 {
        state = state.after(&body, &Loads::default(), 0.005);
    }
    assert!((energy(&state) / energy(&start) - 1.0).abs() < 1e-9);
    let drift = (momentum(&state) - momentum(&start)).norm() / momentum(&start).norm();
    assert!(drift < 1e-8, "{drift}");
}

#[test]
fn the_floor_holds_what_the_thrust_does_not() {
    let weight = body().mass * GRAVITY;
    let under = Loads { thrust: 0.9 * weight, ..Loads::default() };
    let over = Loads { thrust: 1.1 * weight, ..Loads::default() };
    let rest = State::default().after(&body(), &under, 0.005);
    assert_eq!(rest, State::default());
    assert!(rest.after(&body(), &over, 0.005).position.z > 0.0);
}
