//! The aircraft of the testbed, and the addresses at which their software listens.

use crate::{arm, built, recorder, testbed, until};
use ground::catalogue::parameters;
use ground::program::{Program, Target};
use ground::station::Outcome;
use ground::testbed::{Testbed, Wanted};
use models::{Alarm, Phase};
use sim::Aircraft;
use sim::ground_station::Order;
use sim::scenario::point;
use std::net::{Ipv4Addr, SocketAddrV4, UdpSocket};
use std::process::{Command, Stdio};

/// Sends an order, and returns its result.
fn ordered(testbed: &mut Testbed, order: Order) -> Outcome {
    let now = testbed.now();
    testbed.station.outcomes.clear();
    testbed.station.order(now, order);
    while testbed.station.outcomes.is_empty() {
        testbed.step().unwrap_or_else(|error| panic!("{error}"));
    }
    testbed.station.outcomes.pop_front().map(|(_, outcome)| outcome).expect("there is one")
}

#[test]
fn the_hexacopter_flies_with_its_own_parameters_and_runs_again_to_the_bit() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("flight.mcap");
    let mut testbed = testbed(Wanted { aircraft: Aircraft::F550, ..Wanted::default() });
    let mut recorder = recorder(&path, Aircraft::F550, None);
    let run = testbed.run_until(2.0, |done, _| recorder.take(done, Vec::new()));
    run.unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(recorder.finish().error, None);
    let report = ground::replay::replay(&built(Target::Native), &path);
    let report = report.unwrap_or_else(|error| panic!("{error}"));
    assert_eq!((report.steps, report.difference), (400, None));

    for it in parameters(Aircraft::F550) {
        assert_eq!(testbed.station.parameters[usize::from(it.number)], Some(it.initial), "{it:?}");
        assert!((it.least..=it.most).contains(&it.initial), "{it:?}");
    }
    // The height's P of the Mambo is too small for it.
    assert_eq!(ordered(&mut testbed, Order::Set(0, 3.0)), Outcome::Refused);
    assert_eq!(ordered(&mut testbed, Order::Set(0, 17.0)), Outcome::Done);

    arm(&mut testbed);
    let now = testbed.now();
    testbed.station.fly(now, vec![point(0.0, 0.5, 0.0, 1.5, 0.5)]);
    testbed.station.order(now, Order::TakeOff);
    until(&mut testbed, now + 14.0);
    let state = testbed.bench.state();
    let wanted = nalgebra::Vector3::new(0.5, 0.0, 1.5);
    assert!((state.position - wanted).norm() < 0.15, "{}", state.position);
    let battery = testbed.bench.battery();
    assert!((13.0..16.8).contains(&battery.voltage()) && battery.left() < 0.99, "{battery:?}");
    let now = testbed.now();
    testbed.station.order(now, Order::Land);
    until(&mut testbed, now + 12.0);
    assert_eq!(testbed.station.phase(), Phase::Over as u8);
    assert_eq!(testbed.station.signal(35), f32::from(Alarm::Clear as u8));
    assert_eq!(testbed.bench.timing.missed, 0);
}

#[test]
fn the_software_listens_at_the_address_of_the_argument() {
    let other = Ipv4Addr::new(127, 0, 0, 2);
    let mut port = 0;
    // Any free port, then this one.
    for _ in 0..2 {
        let link = SocketAddrV4::new(other, port);
        let mut testbed = testbed(Wanted { link, ..Wanted::default() });
        let here = testbed.link().expect("it has said where it listens");
        assert_eq!(here.ip(), other);
        assert!(port == 0 || here.port() == port, "{here}");
        port = here.port();
        until(&mut testbed, 0.5);
        assert!(testbed.station.status.is_some(), "no telemetry comes from {here}");
        assert!(UdpSocket::bind((other, port)).is_err(), "{here} is free");
        assert!(UdpSocket::bind((Ipv4Addr::LOCALHOST, port)).is_ok(), "it listens elsewhere, too");
    }
}

#[test]
fn arguments_that_are_none_end_the_software_with_its_usage() {
    let Program::Process { path, .. } = built(Target::Native) else { panic!("a process") };
    let wrong: [&[&str]; 9] = [
        &[],
        &["bus"],
        &["0"],
        &["70000"],
        &["127.0.0.1"],
        &["127.0.0.1.5:4000"],
        &["-a", "f551", "4000"],
        &["-l", "here", "4000"],
        &["4000", "4001"],
    ];
    for arguments in wrong {
        let output = Command::new(&path).args(arguments).stdin(Stdio::null()).output();
        let output = output.expect("it starts");
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(2), "{arguments:?}: {said}");
        assert!(said.contains("usage: onboard"), "{arguments:?}: {said}");
    }
}
