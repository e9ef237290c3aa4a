//! The plant against physics, and against the model that knows the same geometry.

use bessemer_sim::{Input, Integrator, Stepper, Tick};
use models::{Airframe, Layout, Motion, Orientation};
use nalgebra::{SVector, Vector3, Vector4};
use sim::noise::{Purpose, Stream};
use sim::plant::{Body, GRAVITY, Loads, angle_rates, rotation};
use sim::{Aircraft, State, Vehicle};

fn body() -> Body {
    let airframe = Airframe::mambo();
    Body { mass: airframe.mass, inertia: airframe.inertia }
}

/// Returns the state after a period, s, a whole number of nanoseconds.
fn after(start: &State, body: &Body, loads: &Loads, period: f64) -> State {
    let nanoseconds = (period * 1e9).round() as u64;
    let tick = Tick::nanoseconds(nanoseconds).expect("a period");
    let input = Input { command: *loads, disturbance: () };
    let mut plant = Stepper::new(*body, start.vector(), input, tick, Integrator::default());
    plant.advance(1).expect("it moves");
    State::from_vector(&plant.state)
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
    let mut squares = SVector::<f64, 8>::zeros();
    squares.fixed_rows_mut::<4>(0).copy_from(&Vector4::new(1e6, 2e6, 3e6, 4e6));
    let expected = Airframe::mambo().effectiveness() * squares;
    let (thrust, torque) = Vehicle::mambo().loads(squares.as_slice());
    let loads = Vector4::new(thrust, torque.x, torque.y, torque.z);
    assert!((loads - expected).norm() < 1e-15, "{loads}");
}

#[test]
fn plant_and_model_move_alike() {
    for airframe in [Airframe::mambo(), Airframe::hexacopter()] {
        let speeds = SVector::<f64, 8>::from_fn(|n, _| 400.0 + 60.0 * n as f64);
        let squares = speeds.component_mul(&speeds);
        let vehicle = Vehicle::new(&airframe);
        let (thrust, torque) = vehicle.loads(squares.as_slice());
        let loads = Loads { thrust, torque, wind: Vector3::zeros() };
        let body = Body { mass: vehicle.mass, inertia: vehicle.inertia };
        let start = State {
            position: Vector3::new(0.1, 0.2, 3.0),
            angles: Vector3::new(0.3, -0.2, 1.0),
            velocity: Vector3::new(0.5, 0.4, 0.3),
            rates: Vector3::new(-1.0, 2.0, 0.5),
        };
        let State { position, angles, velocity, rates } = start;
        let motion = Motion { position, angles, velocity, rates };
        let there = motion.after(&airframe, &airframe.wrench(&speeds), 0.005);
        let here = after(&start, &body, &loads, 0.005);
        assert!((there.position - here.position).norm() < 1e-14, "{there:?} {here:?}");
        assert!((there.angles - here.angles).norm() < 1e-13, "{there:?} {here:?}");
        assert!((there.velocity - here.velocity).norm() < 1e-13, "{there:?} {here:?}");
        assert!((there.rates - here.rates).norm() < 1e-12, "{there:?} {here:?}");
    }
}

#[test]
fn any_even_number_of_equal_motors_balances() {
    for layout in [Layout::Plus, Layout::Cross] {
        for motors in [2, 4, 6, 8] {
            let airframe = Airframe {
                layout,
                motors,
                thrust_coefficients: Airframe::for_each(motors, 0.0107),
                drag_coefficients: Airframe::for_each(motors, 0.7826e-3),
                ..Airframe::mambo()
            };
            let (thrust, torque) = Vehicle::new(&airframe).loads(&vec![1e6; motors]);
            assert!(thrust > 0.0);
            assert!(torque.norm() < 1e-17, "{layout:?} {motors}: {torque}");
        }
    }
}

#[test]
fn falling_is_a_parabola() {
    let start = State { position: Vector3::new(0.0, 0.0, 10.0), ..State::default() };
    let mut state = start;
    for _ in 0..200 {
        state = after(&state, &body(), &Loads::default(), 0.005);
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
        state = after(&state, &body, &Loads::default(), 0.005);
    }
    assert!((energy(&state) / energy(&start) - 1.0).abs() < 1e-9);
    let drift = (momentum(&state) - momentum(&start)).norm() / momentum(&start).norm();
    assert!(drift < 1e-8, "{drift}");
}

/// The step computes each sine once and no product with zero. Its bits are those of the plain equations.
#[test]
fn a_step_has_the_bits_of_the_plain_equations() {
    let body = body();
    let mut chance = Stream::new(7, Purpose::Dice);
    for _ in 0..2000 {
        let start = State {
            position: chance.normals() + Vector3::new(0.0, 0.0, 8.0),
            angles: chance.normals(),
            velocity: chance.normals(),
            rates: chance.normals() * 3.0,
        };
        let (thrust, torque, wind) =
            (chance.normal(), chance.normals() * 1e-3, chance.normals() * 1e-2);
        let period = chance.between(1e6, 1e7).round() / 1e9;
        let loads = Loads { thrust, torque, wind };
        let moved = |from: &State, by: &State, time: f64| State {
            position: from.position + by.position * time,
            angles: from.angles + by.angles * time,
            velocity: from.velocity + by.velocity * time,
            rates: from.rates + by.rates * time,
        };
        let slope = |at: &State| {
            let push = rotation(&at.angles) * Vector3::new(0.0, 0.0, thrust) + wind;
            let turn = torque - at.rates.cross(&body.inertia.component_mul(&at.rates));
            State {
                position: at.velocity,
                angles: angle_rates(&at.angles, &at.rates),
                velocity: push * (1.0 / body.mass) - Vector3::new(0.0, 0.0, GRAVITY),
                rates: turn.component_mul(&body.inertia.map(|moment| 1.0 / moment)),
            }
        };
        let one = slope(&start);
        let two = slope(&moved(&start, &one, period / 2.0));
        let three = slope(&moved(&start, &two, period / 2.0));
        let four = slope(&moved(&start, &three, period));
        let sum = moved(&moved(&moved(&one, &two, 2.0), &three, 2.0), &four, 1.0);
        let wanted = moved(&start, &sum, period / 6.0);
        let found = after(&start, &body, &loads, period);
        let bits = |it: &State| {
            let all =
                [it.position, it.angles, it.velocity, it.rates].map(|part| part.map(f64::to_bits));
            all.map(|part| [part.x, part.y, part.z])
        };
        assert_eq!(bits(&found), bits(&wanted), "{start:?} {loads:?}");
    }
}

#[test]
fn the_floor_holds_what_the_thrust_does_not() {
    let weight = body().mass * GRAVITY;
    let under = Loads { thrust: 0.9 * weight, ..Loads::default() };
    let over = Loads { thrust: 1.1 * weight, ..Loads::default() };
    let rest = after(&State::default(), &body(), &under, 0.005);
    assert_eq!(rest, State::default());
    assert!(after(&rest, &body(), &over, 0.005).position.z > 0.0);
}

#[test]
fn hovering_empties_the_battery_in_about_ten_minutes() {
    for (aircraft, empty) in [(Aircraft::Mambo, 3.0), (Aircraft::F550, 12.0)] {
        let minutes = hovered(aircraft, empty);
        assert!((8..=16).contains(&minutes), "{aircraft:?}: {minutes}");
    }
}

/// Returns the time in the air, minutes, of an aircraft whose battery never falls below a voltage.
fn hovered(aircraft: Aircraft, empty: f64) -> u32 {
    let vehicle = Vehicle::new(&aircraft.airframe());
    let mut battery = aircraft.battery();
    let lift = vehicle.mass * GRAVITY / vehicle.motors.len() as f64;
    let speed = (lift / vehicle.motors[0].thrust_factor).sqrt();
    let (mut minutes, mut before) = (0, f64::INFINITY);
    while battery.left() > 0.0 && minutes < 60 {
        for _ in 0..600 {
            battery.draw(&SVector::repeat(speed), 0.1);
        }
        assert!(battery.voltage() < before && battery.voltage() > empty, "{battery:?}");
        before = battery.voltage();
        minutes += 1;
    }
    minutes
}
