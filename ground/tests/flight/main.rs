//! Whole flights of the emitted C over UDP, in virtual time: through the ground station, the link and the bus.

mod aircraft;
mod mocap;
mod recordings;

use bessemer_legs::toolchain;
use ground::bench::Injection;
use ground::catalogue::PAGE_SIGNALS;
use ground::key::Key;
use ground::program::{Program, Target};
use ground::radio::Quality;
use ground::recorder::Recorder;
use ground::station::{Outcome, Station};
use ground::testbed::{Pace, Testbed, Wanted};
use models::gate::{Gate, Refused};
use models::packet::Packet;
use models::receiver::COMMIT;
use models::{Alarm, Mode, Phase};
use sim::Aircraft;
use sim::ground_station::{Order, Status, unframed};
use sim::scenario::point;
use std::io::Write as _;
use std::net::UdpSocket;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

fn built(target: Target) -> Program {
    let root = bessemer_legs::root();
    Program::build(&root, target).unwrap_or_else(|error| panic!("{error}"))
}

fn testbed(wanted: Wanted) -> Testbed {
    testbed_on(&built(Target::Native), wanted)
}

fn testbed_on(program: &Program, wanted: Wanted) -> Testbed {
    Testbed::start(program, &Wanted { pace: Pace::Virtual, ..wanted })
        .unwrap_or_else(|error| panic!("{error}"))
}

/// A recording for which time waits.
fn recorder(path: &Path, aircraft: Aircraft, image: Option<Vec<u8>>) -> Recorder {
    Recorder::start(path.to_owned(), aircraft, image, true)
        .unwrap_or_else(|error| panic!("{error}"))
}

fn until(testbed: &mut Testbed, time: f64) {
    testbed.run_until(time, |_, _| ()).unwrap_or_else(|error| panic!("{error}"));
}

/// Arms the aircraft, and waits until it is armed.
fn arm(testbed: &mut Testbed) {
    let now = testbed.now();
    testbed.station.order(now, Order::Arm);
    while testbed.station.phase() != Phase::Ready as u8 {
        assert!(testbed.now() < now + 5.0, "{:?}", testbed.station.outcomes);
        testbed.step().unwrap_or_else(|error| panic!("{error}"));
    }
}

/// Takes off to 1 m.
fn taken_off(wanted: Wanted) -> Testbed {
    let mut testbed = testbed(wanted);
    arm(&mut testbed);
    until(&mut testbed, 1.0);
    testbed.station.fly(1.0, vec![point(0.0, 0.0, 0.0, 1.0, 0.0)]);
    until(&mut testbed, 2.0);
    testbed.station.order(2.0, Order::TakeOff);
    until(&mut testbed, 12.0);
    testbed
}

#[test]
fn the_c_takes_off_hovers_and_lands_over_udp() {
    let mut testbed = taken_off(Wanted::default());
    let place = testbed.bench.state().position;
    assert!((place.z - 1.0).abs() < 0.1, "{place}");
    assert_eq!(testbed.station.phase(), Phase::Flight as u8);
    testbed.station.order(12.0, Order::Land);
    until(&mut testbed, 20.0);
    assert_eq!(testbed.station.phase(), Phase::Over as u8);
    assert_eq!(testbed.bench.state().position.z, 0.0);
    assert_eq!(testbed.bench.timing.missed, 0);
}

const KEY: [u8; 16] = [7; 16];

fn key() -> Option<Key> {
    Some(Key::new(KEY))
}

/// Bad, but not hopeless.
fn bad() -> Quality {
    Quality { loss: 0.2, duplication: 0.1, reordering: 0.1, delay: 0.02 }
}

#[test]
fn a_trajectory_of_many_points_survives_a_link_that_loses_a_fifth() {
    let mut testbed = testbed(Wanted { quality: bad(), key: key(), ..Wanted::default() });
    let points = (0..16).map(|n| {
        let turn = f64::from(n) * 0.4;
        point(3.0 * f64::from(n), 0.4 * turn.sin(), 0.4 - 0.4 * turn.cos(), 1.0, 0.0)
    });
    arm(&mut testbed);
    let now = testbed.now();
    testbed.station.fly(now, points.collect());
    testbed.station.order(now, Order::TakeOff);
    until(&mut testbed, 8.0);
    assert_eq!(testbed.station.phase(), Phase::Flight as u8, "{:?}", testbed.station.outcomes);
    until(&mut testbed, 56.0);
    let end = 15.0_f64 * 0.4;
    let place = testbed.bench.state().position;
    let (x, y) = (0.4 * end.sin(), 0.4 - 0.4 * end.cos());
    assert!((place.x - x).hypot(place.y - y) < 0.1, "{place} is not ({x}, {y})");
    let (up, down) = testbed.counts();
    for counts in [up, down] {
        assert!(counts.lost * 4 > counts.sent / 2 && counts.doubled > 0 && counts.overtaken > 0);
    }
}

#[test]
fn two_runs_over_the_same_bad_link_are_the_same_to_the_bit() {
    let flown = || {
        let mut words = Vec::new();
        let mut testbed = testbed(Wanted { quality: bad(), seed: 5, ..Wanted::default() });
        arm(&mut testbed);
        let now = testbed.now();
        testbed.station.fly(now, vec![point(0.0, 0.0, 0.0, 1.0, 0.0)]);
        testbed.station.order(now, Order::TakeOff);
        let run = testbed.run_until(5.0, |done, _| {
            words.extend(bessemer_legs::words(&done.moment.outputs));
        });
        run.unwrap_or_else(|error| panic!("{error}"));
        words
    };
    assert!(flown() == flown());
}

/// Stops two processes again and again, each until it is seen to stand still.
const STOP_AND_GO: &str = "
for n in $(seq 100); do
    for it in $0 $1; do
        kill -STOP $it
        while read -r _ _ state _ </proc/$it/stat; do
            case $state in [TZX]) break ;; esac
        done
        kill -CONT $it
    done
done";

/// Stops and continues the processes, as a frozen machine or a debugger does: each wait with a time limit then ends early.
#[test]
fn who_is_stopped_and_goes_on_flies_the_same_bits() {
    let flown = |disturbed: bool| {
        let mut testbed = testbed(Wanted { key: key(), ..Wanted::default() });
        let (us, software) = (std::process::id(), testbed.process());
        let mut command = Command::new("sh");
        command.args(["-c", STOP_AND_GO, &us.to_string(), &software.to_string()]);
        let mut shell = disturbed.then(|| command.spawn().expect("it starts"));
        arm(&mut testbed);
        let now = testbed.now();
        testbed.station.fly(now, vec![point(0.0, 0.0, 0.0, 1.0, 0.0)]);
        testbed.station.order(now, Order::TakeOff);
        let (mut words, mut ended) = (Vec::new(), false);
        // As long as it is disturbed, and the same flight undisturbed.
        while testbed.now() < 3.0 || !ended {
            let (done, _) = testbed.step().unwrap_or_else(|error| panic!("{error}"));
            if done.moment.time < 3.0 {
                words.extend(bessemer_legs::words(&done.moment.outputs));
            }
            let over = |it: &mut Child| it.try_wait().expect("it is ours").is_some();
            ended = shell.as_mut().is_none_or(over);
        }
        assert!(testbed.image().expect("the bus").is_some());
        assert_eq!((testbed.restarts, testbed.bench.timing.missed), (0, 0));
        words
    };
    assert!(flown(false) == flown(true));
}

#[test]
fn alone_it_hovers_then_lands() {
    let mut testbed = taken_off(Wanted::default());
    testbed.up.quality.loss = 1.0;
    let lost = testbed.now();
    let (mut held, mut landing) = (None, None);
    let run = testbed.run_until(lost + 14.0, |done, _| {
        let since = done.moment.time - lost;
        match done.moment.outputs.reference.phase {
            Phase::Hold => held = held.or(Some(since)),
            Phase::Landing => landing = landing.or(Some(since)),
            _ => {}
        }
    });
    run.unwrap_or_else(|error| panic!("{error}"));
    let (held, landing) = (held.expect("it holds"), landing.expect("it lands"));
    assert!((0.9..1.2).contains(&held) && (5.9..6.2).contains(&landing), "{held} {landing}");
    assert_eq!(testbed.station.phase(), Phase::Over as u8);
    assert_eq!(testbed.bench.state().position.z, 0.0);
}

#[test]
fn a_link_that_comes_back_in_time_changes_nothing() {
    let mut testbed = taken_off(Wanted::default());
    testbed.up.quality.loss = 1.0;
    until(&mut testbed, 15.0);
    assert_eq!(testbed.station.phase(), Phase::Hold as u8);
    testbed.up.quality.loss = 0.0;
    until(&mut testbed, 16.0);
    assert_eq!(testbed.station.phase(), Phase::Flight as u8);
}

#[test]
fn who_lacks_the_key_commands_nothing() {
    for (ours, theirs) in [(None, key()), (Some(Key::new([8; 16])), key())] {
        let mut testbed =
            testbed(Wanted { key: ours.clone(), other_key: theirs, ..Wanted::default() });
        testbed.station.fly(0.0, vec![point(0.0, 0.0, 0.0, 1.0, 0.0)]);
        testbed.station.order(0.0, Order::TakeOff);
        let (mut refused, mut silent) = (Refused::default(), true);
        let run = testbed.run_until(2.0, |done, _| {
            refused = done.moment.inputs.refused;
            silent &= done.moment.outputs.downlink.length == 0;
        });
        run.unwrap_or_else(|error| panic!("{error}"));
        assert!(silent && testbed.bench.state().position.z == 0.0);
        let counted = if ours.is_none() { refused.unsealed } else { refused.forged };
        assert!(counted > 20, "{refused:?}");
    }
}

#[test]
fn a_clock_that_jumps_keeps_nobody_out() {
    let theirs = models::siphash::Key { is_set: true, halves: [u64::from_le_bytes([7; 8]); 2] };
    let (mut station, mut gate) = (Station::new(key(), PAGE_SIGNALS, 0.0), Gate::default());
    let mut through = 0;
    for (n, clock) in [5_000_000, 5, 4_000_000_000, 7].into_iter().cycle().take(400).enumerate() {
        let Some(datagram) = station.tick(0.1 * n as f64, clock) else { continue };
        let mut packet = Packet { length: datagram.len(), ..Packet::none() };
        packet.bytes[..datagram.len()].copy_from_slice(&datagram);
        assert_ne!(gate.step(&theirs, &packet).length, 0, "packet {n}, at {clock}");
        through += 1;
    }
    assert_eq!((through, gate.refused), (400, Refused::default()));
}

#[test]
fn a_station_that_was_started_anew_takes_no_other_trajectory_for_its_own() {
    let named = |flown: Option<u8>| {
        let mut station = Station::new(None, PAGE_SIGNALS, 0.0);
        station.status = flown.map(|tag| Status { tag, ..Status::default() });
        station.fly(0.0, vec![point(0.0, 0.0, 0.0, 1.0, 0.0)]);
        let datagrams = std::iter::from_fn(|| station.tick(0.0, 0));
        let names = datagrams.filter_map(|it| match unframed(&it) {
            Some((COMMIT, [_, name])) => Some(*name),
            _ => None,
        });
        names.collect::<Vec<_>>()
    };
    let first = named(None);
    assert_eq!(first.len(), 1);
    assert_ne!(named(Some(first[0])), first);
}

#[test]
fn what_was_overheard_cannot_be_said_again() {
    let mut testbed = testbed(Wanted { key: key(), ..Wanted::default() });
    testbed.up.quality.duplication = 1.0;
    until(&mut testbed, 2.0);
    let refused = testbed.station.status.as_ref().expect("the link is open").counts;
    assert!(refused[6] > 20 && refused[5] == 0, "{refused:?}");
}

#[test]
fn noise_on_the_port_harms_nobody() {
    let mut testbed = taken_off(Wanted::default());
    let noise = UdpSocket::bind("127.0.0.1:0").expect("a port");
    let link = testbed.link().expect("it listens");
    let mut random = sim::noise::Stream::new(3, sim::noise::Purpose::Radio);
    let mut alarm = Alarm::Clear;
    for step in 0..400 {
        for _ in 0..20 {
            let length = random.below(200) as usize;
            let bytes: Vec<u8> = (0..length).map(|_| random.below(256) as u8).collect();
            let _ = noise.send_to(&bytes, link);
        }
        testbed
            .run_until(12.0 + 0.005 * f64::from(step), |done, _| alarm = done.moment.outputs.alarm)
            .unwrap_or_else(|error| panic!("{error}"));
    }
    assert_eq!((alarm, testbed.station.phase()), (Alarm::Clear, Phase::Flight as u8));
    assert!((testbed.bench.state().position.z - 1.0).abs() < 0.1);
}

#[test]
fn a_second_ground_station_may_only_stop() {
    let mut testbed = taken_off(Wanted::default());
    let other = UdpSocket::bind("127.0.0.1:0").expect("a port");
    let link = testbed.link().expect("it listens");
    let mut framer = sim::ground_station::Framer::default();
    let mut say = |order: &Order| {
        for packet in framer.frame(order) {
            other.send_to(&packet.bytes[..packet.length], link).expect("loopback takes it");
        }
    };
    say(&Order::Hello);
    say(&Order::Land);
    say(&Order::Mode(Mode::Manual));
    until(&mut testbed, 13.0);
    assert_eq!(testbed.station.phase(), Phase::Flight as u8);
    assert_eq!(testbed.station.status.as_ref().map(|status| status.mode), Some(0));
    say(&Order::Stop);
    until(&mut testbed, 13.5);
    assert_eq!(testbed.station.signal(35), f32::from(Alarm::Commanded as u8));
}

#[test]
fn a_software_that_is_killed_is_met_again() {
    let mut testbed = testbed(Wanted { key: key(), ..Wanted::default() });
    until(&mut testbed, 2.0);
    testbed.kill();
    until(&mut testbed, 6.0);
    assert_eq!(testbed.restarts, 1);
    assert!(testbed.station.silence(6.0).is_some_and(|silence| silence < 0.1));
    arm(&mut testbed);
    testbed.station.fly(6.0, vec![point(0.0, 0.0, 0.0, 1.0, 0.0)]);
    testbed.station.order(6.0, Order::TakeOff);
    until(&mut testbed, 14.0);
    assert!((testbed.bench.state().position.z - 1.0).abs() < 0.1);
}

#[test]
fn the_software_ends_with_whoever_started_it() {
    let Program::Process { path, .. } = built(Target::Native) else { panic!("it is a process") };
    let bus = UdpSocket::bind("127.0.0.1:0").expect("a port");
    let mut command = Command::new(path);
    command.arg(bus.local_addr().expect("a port").port().to_string()).stdin(Stdio::piped());
    let mut software = command.spawn().expect("it starts");
    let mut input = software.stdin.take().expect("it is piped");
    writeln!(input).expect("it listens");
    let mut ready = [0; 16];
    let limit = Instant::now() + Duration::from_secs(120);
    let heard = ground::wait::receive(&bus, &mut ready, limit).expect("a socket");
    let (length, computer) = heard.expect("it says that it is there");
    assert!(ready[..length].starts_with(b"ready"));
    // Its bus is never silent, so silence cannot be the reason for its end.
    drop(input);
    let begun = Instant::now();
    while software.try_wait().expect("it is ours").is_none() {
        bus.send_to(b"image", computer).expect("loopback takes it");
        if begun.elapsed() > Duration::from_secs(20) {
            software.kill().expect("it is ours");
            panic!("it outlives whoever started it");
        }
    }
}

#[test]
fn a_software_that_ends_at_its_start_is_told() {
    let program = Program::Process { path: "/bin/false".into(), toolchain: toolchain::GCC };
    let started = Testbed::start(&program, &Wanted { pace: Pace::Virtual, ..Wanted::default() });
    let said = started.err().map(|error| error.to_string()).unwrap_or_default();
    // It may be gone before it was reported the key.
    let broken = "`/bin/false` does not start: Broken pipe";
    let ended = "the onboard software ended at its start: its process ended: exit status: 1";
    assert!(said == ended || said.starts_with(broken), "{said}");
}

#[test]
fn it_starts_disarmed_and_is_disarmed_on_the_ground_alone() {
    let mut testbed = testbed(Wanted::default());
    testbed.station.fly(0.0, vec![point(0.0, 0.0, 0.0, 1.0, 0.0)]);
    testbed.station.order(0.0, Order::TakeOff);
    until(&mut testbed, 3.0);
    assert_eq!(testbed.station.phase(), Phase::Over as u8);
    assert_eq!(testbed.bench.state().position.z, 0.0);
    arm(&mut testbed);
    let now = testbed.now();
    testbed.station.order(now, Order::Disarm);
    until(&mut testbed, now + 0.5);
    let disarmed = ("disarm".to_owned(), Outcome::Done);
    assert_eq!(testbed.station.phase(), Phase::Over as u8);
    assert!(testbed.station.outcomes.contains(&disarmed), "{:?}", testbed.station.outcomes);
    assert_eq!(testbed.station.signal(35), f32::from(Alarm::Clear as u8), "no alarm");

    let mut testbed = taken_off(Wanted::default());
    testbed.station.order(12.0, Order::Disarm);
    until(&mut testbed, 14.0);
    assert_eq!(testbed.station.phase(), Phase::Flight as u8);
}

#[test]
fn it_flies_again_after_a_stop_and_a_new_arming() {
    let mut testbed = taken_off(Wanted::default());
    testbed.station.order(12.0, Order::Stop);
    until(&mut testbed, 14.0);
    assert_eq!(testbed.bench.state().position.z, 0.0, "it falls");
    testbed.inject(Injection::Back);
    until(&mut testbed, 16.0);
    testbed.station.order(16.0, Order::Arm);
    until(&mut testbed, 17.0);
    assert_eq!(testbed.station.phase(), Phase::Ready as u8);
    testbed.station.order(17.0, Order::TakeOff);
    until(&mut testbed, 26.0);
    assert!((testbed.bench.state().position.z - 1.0).abs() < 0.1);
}

#[test]
fn whatever_is_injected_is_noticed() {
    let mut testbed = taken_off(Wanted::default());
    testbed.inject(Injection::Vicon { away: true });
    until(&mut testbed, 14.0);
    assert!(testbed.station.signal(48) > 1.5, "Vicon is {} s old", testbed.station.signal(48));
    testbed.inject(Injection::Vicon { away: false });
    until(&mut testbed, 15.0);
    assert!(testbed.station.signal(48) < 0.1);

    let calm = testbed.bench.state().position.x;
    testbed.inject(Injection::Wind { force: [0.03, 0.0], gusts: 0.0 });
    until(&mut testbed, 18.0);
    let blown = testbed.bench.state().position.x - calm;
    assert!(blown > 0.1, "{blown} m");
    testbed.inject(Injection::Wind { force: [0.0, 0.0], gusts: 0.0 });
    until(&mut testbed, 20.0);
    assert_eq!(testbed.station.phase(), Phase::Flight as u8);

    testbed.inject(Injection::Gyroscope { stuck: true });
    until(&mut testbed, 20.2);
    assert_eq!(testbed.station.phase(), Phase::Landing as u8);
    testbed.inject(Injection::Motor { number: Some(2) });
    until(&mut testbed, 21.2);
    assert_ne!(testbed.station.signal(35), f32::from(Alarm::Clear as u8));
    assert_eq!(testbed.station.phase(), Phase::Over as u8);
}

#[test]
fn parameters_and_signals_change_in_flight_within_their_bounds() {
    let mut testbed = taken_off(Wanted::default());
    assert!(testbed.station.parameters.iter().all(Option::is_some));
    testbed.station.order(12.0, Order::Set(0, 2.0));
    testbed.station.order(12.0, Order::Set(1, 9.0));
    testbed.station.order(12.0, Order::Set(19, 2.0));
    // The answer to the first of two commands for one parameter does not refuse the second.
    testbed.station.order(12.0, Order::Set(15, 0.5));
    until(&mut testbed, 12.005);
    testbed.station.order(12.005, Order::Set(15, 0.6));
    testbed.station.choose(12.005, 8, [2; 36]);
    testbed.station.outcomes.clear();
    until(&mut testbed, 13.0);
    let refused = testbed.station.outcomes.iter().filter(|(_, it)| *it == Outcome::Refused);
    let refused: Vec<&str> = refused.map(|(name, _)| name.as_str()).collect();
    assert_eq!(refused, ["set parameter 1", "set parameter 19"]);
    let parameters = &testbed.station.parameters;
    assert_eq!((parameters[0], parameters[15]), (Some(2.0), Some(0.6)));
    assert_eq!(parameters[1], Some(0.05), "9 is out of its range");
    assert_eq!(parameters[19], Some(0.0), "another candidate only on the ground");
    assert_eq!(testbed.station.chosen(), &[2; 36]);
    let record = testbed.station.record().expect("records come down");
    assert!((f64::from(record.values[35]) - 1.0).abs() < 0.1);
}

#[test]
fn the_key_is_in_no_log() {
    const SECRET: [u8; 16] = *b"Bessemer's flame";
    let digits = SECRET.map(|byte| format!("{byte:02x}")).concat();
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("flight.mcap");
    let key = Key::new(SECRET);
    let mut testbed = testbed(Wanted { key: Some(key.clone()), ..Wanted::default() });
    let image = testbed.image().expect("the bus").expect("it answers");
    let mut recorder = recorder(&path, Aircraft::Mambo, Some(image));
    testbed
        .run_until(2.0, |done, _| recorder.take(done, Vec::new()))
        .unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(recorder.finish().error, None);

    // What is printed of it, what others can see of the software's process, and what a recording holds uncompressed.
    let mut seen = vec![format!("{key:?} {:?}", testbed.station).into_bytes()];
    let process = testbed.process();
    let told = ["cmdline", "environ"].map(|file| std::fs::read(format!("/proc/{process}/{file}")));
    seen.extend(told.map(|it| it.expect("it runs")));
    let recording = std::fs::read(&path).expect("the recording");
    let messages = mcap::MessageStream::new(&recording).expect("a recording");
    seen.extend(messages.map(|message| message.expect("it is whole").data.to_vec()));
    assert!(seen.len() > 1000, "{}", seen.len());
    // And what is said of a file with a key that lacks a digit.
    let short = folder.path().join("key");
    std::fs::write(&short, &digits[1..]).expect("a file");
    seen.push(Key::read(&short).expect_err("it is too short").to_string().into_bytes());
    let numbers = format!("{SECRET:?}").replace(['[', ']'], "");
    for bytes in seen {
        let text = String::from_utf8_lossy(&bytes).to_lowercase();
        let told = text.contains(&digits[1..]) || text.contains(&numbers);
        assert!(!told && !bytes.windows(16).any(|it| it == SECRET), "{text}");
    }
}

#[test]
fn what_is_forged_or_cut_off_is_counted_wherever_it_comes_from() {
    let mut testbed = taken_off(Wanted { key: key(), ..Wanted::default() });
    let other = UdpSocket::bind("127.0.0.1:0").expect("a port");
    let link = testbed.link().expect("it listens");
    let stop = &sim::ground_station::Framer::default().frame(&Order::Stop)[0];
    let whole = Key::new(KEY).seal(stop, u64::from(u32::MAX) << 10).expect("it has room");
    let forged = Key::new([8; 16]).seal(stop, u64::from(u32::MAX) << 10).expect("it has room");
    for length in 1..whole.length {
        other.send_to(&whole.bytes[..length], link).expect("loopback takes it");
    }
    other.send_to(&forged.bytes[..forged.length], link).expect("loopback takes it");
    let land = &sim::ground_station::Framer::default().frame(&Order::Land)[0];
    let land = Key::new([8; 16]).seal(land, 7).expect("it has room");
    other.send_to(&land.bytes[..land.length], link).expect("loopback takes it");
    until(&mut testbed, 13.0);
    let counts = testbed.station.status.as_ref().expect("the link is open").counts;
    assert_eq!(counts[4..6], [whole.length as u32 - 1, 2], "{counts:?}");
    assert_eq!(testbed.station.phase(), Phase::Flight as u8);
}
