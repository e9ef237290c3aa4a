//! Recordings of flights: the C computes them again to the bit, on this machine and on others.

use crate::{arm, bad, built, key, recorder, taken_off, testbed, testbed_on, until};
use bessemer_legs::toolchain::{self, ZYNQ};
use ground::program::{Program, Target};
use ground::testbed::Wanted;
use sim::Aircraft;
use sim::ground_station::Order;
use sim::scenario::point;
use std::path::Path;

#[test]
fn the_c_runs_again_from_a_recording_to_the_bit() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("flight.mcap");
    // From the middle of the flight, over a bad link, with a key.
    let mut testbed = taken_off(Wanted { quality: bad(), key: key(), ..Wanted::default() });
    let image = testbed.image().expect("the bus").expect("it answers");
    let mut recorder = recorder(&path, Aircraft::Mambo, Some(image));
    testbed.station.order(12.0, Order::Set(0, 2.0));
    testbed
        .run_until(15.0, |done, _| recorder.take(done, Vec::new()))
        .unwrap_or_else(|error| panic!("{error}"));
    let state = recorder.finish();
    assert_eq!((state.error, state.periods), (None, 600));

    let report = ground::replay::replay(&built(Target::Native), &path)
        .unwrap_or_else(|error| panic!("{error}"));
    assert_eq!((report.steps, report.difference), (600, None));
}

/// A recording of the first two seconds; in one of its periods a bit is another, if that is wanted.
fn recorded(path: &Path, changed: Option<u64>) {
    let mut testbed = testbed(Wanted::default());
    let mut recorder = recorder(path, Aircraft::Mambo, None);
    let run = testbed.run_until(2.0, |done, _| {
        let mut done = done.clone();
        if done.count == changed && changed.is_some() {
            let motor = &mut done.moment.outputs.command.motors[2];
            *motor = f64::from_bits(motor.to_bits() ^ 1);
        }
        recorder.take(&done, Vec::new());
    });
    run.unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(recorder.finish().error, None);
}

#[test]
fn one_bit_of_a_recording_is_told_by_its_step_and_signal() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("flight.mcap");
    recorded(&path, Some(123));
    let report = ground::replay::replay(&built(Target::Native), &path)
        .unwrap_or_else(|error| panic!("{error}"));
    let difference = report.difference.expect("a bit differs");
    assert_eq!((difference.count, difference.signal.as_str()), (123, "command.motors[2]"));
}

#[test]
fn the_cortex_a9_runs_a_recording_of_this_machine_to_the_bit() {
    if !std::env::var("BESSEMER_FULL").is_ok_and(|value| value == "1") {
        println!("left out: it compiles for the Cortex-A9; BESSEMER_FULL=1 brings it in");
        return;
    }
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("flight.mcap");
    recorded(&path, None);
    let report =
        ground::replay::replay(&built(Target::A9), &path).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!((report.steps, report.difference), (400, None));
}

#[test]
fn a_bare_zynq_takes_off_with_the_bits_of_this_machine() {
    if !ZYNQ.programs().into_iter().all(toolchain::is_asked_for) {
        println!("left out: the tools of the bare Zynq are not installed");
        return;
    }
    let flown = |program: &Program| {
        let wanted = Wanted { quality: bad(), key: key(), ..Wanted::default() };
        let (mut testbed, mut words) = (testbed_on(program, wanted), Vec::new());
        arm(&mut testbed);
        let now = testbed.now();
        testbed.station.fly(now, vec![point(0.0, 0.0, 0.0, 1.0, 0.0)]);
        testbed.station.order(now, Order::TakeOff);
        let run = testbed.run_until(3.0, |done, news| {
            words.extend(done.count);
            words.extend(bessemer_legs::words(&done.moment.inputs));
            words.extend(bessemer_legs::words(&done.moment.outputs));
            words.push(news.len() as u64);
        });
        run.unwrap_or_else(|error| panic!("{error}"));
        (testbed, words)
    };
    let program = built(Target::Zynq);
    let ((here, native), (mut there, bare)) = (flown(&built(Target::Native)), flown(&program));
    assert!(here.bench.state().position.z > 0.1, "{}", here.bench.state().position);
    let parted = native.iter().zip(&bare).position(|(here, there)| here != there);
    assert_eq!((parted, native.len()), (None, bare.len()));

    // Its memory goes over the line, too, and is put back.
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("flight.mcap");
    let image = there.image().expect("the bus").expect("it answers");
    let mut recorder = recorder(&path, Aircraft::Mambo, Some(image));
    there
        .run_until(3.5, |done, _| recorder.take(done, Vec::new()))
        .unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(recorder.finish().error, None);
    let report = ground::replay::replay(&program, &path).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!((report.steps, report.difference), (100, None));

    there.kill();
    until(&mut there, 4.0);
    let why = there.ended.as_deref();
    assert_eq!((there.restarts, why), (1, Some("its process ended: signal: 9 (SIGKILL)")));
}
