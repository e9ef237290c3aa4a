//! Motion capture over NatNet: the simulated aircraft streamed, received, and flown by what was received.

use crate::{arm, testbed, until};
use ground::mocap::{BODY, Counts, Error, Receiver, Server, Source, Up};
use ground::testbed::{Testbed, Wanted};
use models::Phase;
use models::calibration::Vicon;
use nalgebra::Vector3;
use natnet::serverinfo::ConnectionInfo;
use natnet::{
    DataSet, MessageHeader, ModelDef, NAT_CONNECT, NAT_REQUEST_MODELDEF, PlannedBody, RigidBodyDef,
    ServerInfo, SyntheticServer, Version,
};
use sim::scenario::point;
use std::io::{BufRead as _, BufReader};
use std::net::{Ipv4Addr, SocketAddr, SocketAddrV4, UdpSocket};
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

const LOOPBACK: SocketAddrV4 = SocketAddrV4::new(Ipv4Addr::LOCALHOST, 0);

/// A limit only ends a test that would never end.
fn limit() -> Instant {
    Instant::now() + Duration::from_secs(60)
}

fn source(server: SocketAddrV4, body: &str) -> Source {
    Source { server, body: body.into(), up: Up::Y }
}

fn connected(source: &Source) -> Receiver {
    Receiver::connect(source).unwrap_or_else(|error| panic!("{error}"))
}

/// Numbers that are the same in single precision.
fn seen(x: f64) -> Vicon {
    Vicon { fresh: true, position: Vector3::new(x, -0.5, 1.25), angles: Vector3::zeros() }
}

#[test]
fn what_the_server_streams_is_what_the_receiver_reads() {
    let mut server = Server::start(LOOPBACK).expect("a port");
    // By its name, and by its number.
    let mut receivers = [BODY, "1"].map(|body| connected(&source(server.address(), body)));
    for n in 0..100_u8 {
        let wanted = seen(f64::from(n) / 8.0);
        server.send(f64::from(n), &wanted);
        for receiver in &mut receivers {
            assert_eq!(receiver.await_next(limit()), wanted);
        }
    }
    server.send(100.0, &Vicon::default());
    for receiver in &mut receivers {
        assert_eq!(receiver.await_next(limit()), Vicon::default());
        assert_eq!(receiver.counts, Counts { poses: 100, untracked: 1, ..Counts::default() });
        assert_eq!(receiver.take(), Vicon::default());
    }
    // Whoever has gone receives nothing; the other one does.
    let [mut stays, goes] = receivers;
    drop(goes);
    server.send(101.0, &seen(1.0));
    assert_eq!(stays.await_next(limit()), seen(1.0));
}

#[test]
fn a_body_that_is_not_there_is_refused_with_those_that_are() {
    let server = Server::start(LOOPBACK).expect("a port");
    let address = server.address();
    let error = Receiver::connect(&source(address, "drone")).err().expect("it is not there");
    let wanted = format!(
        "motion capture at `{address}` has no rigid body `drone`; its bodies are: `aircraft` (1)"
    );
    assert_eq!(error.to_string(), wanted);
}

/// A server of one's own: what it sends is up to the test.
struct Other {
    socket: UdpSocket,
    address: SocketAddrV4,
    version: Version,
    group: Option<SocketAddrV4>,
}

impl Other {
    fn new(version: Version, group: Option<SocketAddrV4>) -> Self {
        let socket = UdpSocket::bind(LOOPBACK).expect("a port");
        let Ok(SocketAddr::V4(address)) = socket.local_addr() else { panic!("an address") };
        Self { socket, address, version, group }
    }

    fn info(&self) -> Vec<u8> {
        let group = self.group.unwrap_or(LOOPBACK);
        let info = ServerInfo {
            application_name: "Motive".into(),
            server_version: Version::new(3, 1, 0, 0),
            protocol_version: self.version,
            high_res_clock_frequency: 1000,
            connection: ConnectionInfo {
                data_port: group.port(),
                multicast: self.group.is_some(),
                multicast_group: group.ip().octets(),
            },
        };
        info.to_datagram().expect("a message")
    }

    fn model(&self) -> Vec<u8> {
        let body = |name: &str, id| {
            let (name, offset, tail) = (name.to_owned(), [0.0; 3], vec![0; 4]);
            DataSet::RigidBody(RigidBodyDef { name, id, parent_id: -1, offset, tail })
        };
        let datasets = vec![body("wand", 3), body("aircraft", 7)];
        ModelDef { datasets }.to_datagram(self.version).expect("a message")
    }

    /// Answers one command after another with these, and returns the address of the client.
    fn answer(&self, answers: &[Vec<u8>]) -> SocketAddr {
        let mut client = None;
        for answer in answers {
            let mut buffer = [0; 1024];
            let heard = ground::wait::receive(&self.socket, &mut buffer, limit());
            let (length, from) = heard.expect("a socket").expect("a command");
            let command = MessageHeader::parse(&buffer[..length]).expect("a message").message_id;
            assert!([NAT_CONNECT, NAT_REQUEST_MODELDEF].contains(&command), "{command}");
            self.socket.send_to(answer, from).expect("loopback takes it");
            client = Some(from);
        }
        client.expect("a client")
    }

    /// Connects a receiver; returns it with its address for frames.
    fn connect(&self, up: Up) -> (Receiver, SocketAddr) {
        let source = Source { up, ..source(self.address, "aircraft") };
        std::thread::scope(|scope| {
            let answers = scope.spawn(|| self.answer(&[self.info(), self.model()]));
            let receiver = connected(&source);
            let client = answers.join().expect("it has answered");
            (receiver, self.group.map_or(client, SocketAddr::V4))
        })
    }

    /// Returns why a receiver does not connect to a server with these answers.
    fn refusal(&self, answers: &[Vec<u8>]) -> Error {
        std::thread::scope(|scope| {
            scope.spawn(|| self.answer(answers));
            Receiver::connect(&source(self.address, "aircraft")).err().expect("it is refused")
        })
    }
}

#[test]
fn an_answer_that_is_none_is_refused_with_what_to_do() {
    let address = |other: &Other| format!("motion capture at `{}`", other.address);
    let old = Other::new(Version::new(2, 5, 0, 0), None);
    let said = old.refusal(&[old.info()]).to_string();
    assert!(said.starts_with(&address(&old)) && said.ends_with("version 3.0 to 4.1"), "{said}");
    let short = Other::new(Version::V4_1, None);
    let said = short.refusal(&[short.info()[..40].to_vec()]).to_string();
    assert!(said.starts_with(&address(&short)), "{said}");
    let broken = Other::new(Version::V4_1, None);
    let said = broken.refusal(&[broken.info(), broken.model()[..30].to_vec()]).to_string();
    assert!(said.contains("does not describe its bodies"), "{said}");
}

#[test]
fn frames_of_every_version_and_either_axis_are_read_and_others_are_counted() {
    let multicast = SocketAddrV4::new(Ipv4Addr::new(239, 255, 42, 99), free_port());
    for (version, up, group) in [
        (Version::new(3, 1, 0, 0), Up::Z, None),
        (Version::new(4, 0, 0, 0), Up::Y, None),
        (Version::V4_1, Up::Z, Some(multicast)),
    ] {
        let other = Other::new(version, group);
        let (mut receiver, client) = other.connect(up);
        let source = SyntheticServer::new(version, 1000);
        let still = [0.0, 0.0, 0.0, 1.0];
        let wand = PlannedBody::tracked(3, [9.0; 3], still);
        let frame = |number, body| source.datagram(number, 0.0, &[wand, body]).expect("a frame");
        let send = |datagram: &[u8]| {
            other.socket.send_to(datagram, client).expect("loopback takes it");
        };
        let place = match up {
            Up::Y => [0.5, 1.25, -2.0],
            Up::Z => [0.5, 2.0, 1.25],
        };
        let here = PlannedBody::tracked(7, place, still);
        let wanted = Vicon { position: Vector3::new(0.5, 2.0, 1.25), ..seen(0.0) };
        send(&frame(20, here));
        assert_eq!(receiver.await_next(limit()), wanted, "{version}");
        // A repeated frame, an older one, half a frame and noise are dropped; the last frame has lost the body.
        send(&frame(20, here));
        send(&frame(19, here));
        send(&frame(21, here)[..50]);
        send(b"no");
        send(&frame(22, PlannedBody::dropout(7)));
        assert_eq!(receiver.await_next(limit()), Vicon::default(), "{version}");
        send(&frame(23, PlannedBody::tracked(7, [f32::NAN; 3], still)));
        assert_eq!(receiver.await_next(limit()), Vicon::default(), "{version}");
        // The server was started anew: its frames count from the beginning.
        send(&frame(4000, here));
        assert_eq!(receiver.await_next(limit()), wanted, "{version}");
        send(&frame(1, here));
        assert_eq!(receiver.await_next(limit()), wanted, "{version}");
        let counts = Counts { poses: 3, untracked: 2, old: 2, broken: 2 };
        assert_eq!(receiver.counts, counts, "{version}");
    }
}

/// A port that was free a moment ago.
fn free_port() -> u16 {
    let socket = UdpSocket::bind(LOOPBACK).expect("a port");
    socket.local_addr().expect("an address").port()
}

#[test]
fn an_aircraft_flies_by_what_it_receives_and_notices_that_nothing_comes() {
    let server = SocketAddrV4::new(Ipv4Addr::LOCALHOST, free_port());
    let mocap = Some(source(server, BODY));
    let mut testbed = testbed(Wanted { natnet: Some(server), mocap, ..Wanted::default() });
    arm(&mut testbed);
    let now = testbed.now();
    testbed.station.fly(now, vec![point(0.0, 0.5, -0.5, 1.0, 0.0)]);
    testbed.station.order(now, sim::ground_station::Order::TakeOff);
    let (mut fresh, mut differing) = (0, 0);
    let run = testbed.run_until(now + 12.0, |done, _| {
        let vicon = done.moment.inputs.readings.vicon;
        fresh += u32::from(vicon.fresh);
        // In single precision: it has gone over the wire.
        let wired = vicon.position.map(|it| f64::from(it as f32));
        differing += u32::from(wired != vicon.position);
    });
    run.unwrap_or_else(|error| panic!("{error}"));
    let place = testbed.bench.state().position;
    assert!((place - Vector3::new(0.5, -0.5, 1.0)).norm() < 0.15, "{place}");
    assert_eq!(testbed.station.phase(), Phase::Flight as u8);
    // 100 poses a second, one in a hundred of which is lost by chance.
    let counts = counts(&testbed);
    assert!((1100..1240).contains(&fresh) && differing == 0, "{fresh}, {differing}");
    assert_eq!((u64::from(fresh) <= counts.poses, counts.broken, counts.old), (true, 0, 0));

    testbed.bench.stream = None;
    let now = testbed.now();
    until(&mut testbed, now + 1.0);
    let [age, _] = testbed.station.received(ground::catalogue::AGES).expect("it is received");
    assert!(age > 0.9, "{age}");
}

fn counts(testbed: &Testbed) -> Counts {
    testbed.bench.capture.as_ref().map(|it| it.counts).expect("it is received")
}

#[test]
fn a_client_of_another_author_reads_the_same_bits() {
    let root = bessemer_legs::root();
    let python = root.join("target/python/bin/python");
    if !python.exists() {
        println!("left out: there is no {}", python.display());
        return;
    }
    let mut server = Server::start(LOOPBACK).expect("a port");
    let frames = 20;
    let mut child = Command::new(python)
        .arg(root.join("ground/tests/natnet/watch.py"))
        .args([server.address().port().to_string(), frames.to_string()])
        .stdout(Stdio::piped())
        .spawn()
        .expect("python starts");
    let mut lines = BufReader::new(child.stdout.take().expect("it is piped")).lines();
    let mut said = || lines.next().and_then(Result::ok);
    assert_eq!(said().as_deref(), Some("Bessemer testbed 4.1.0.0"));
    let pose = |number: i32| {
        let turn = f64::from(number) * 0.01;
        let angles = Vector3::new(turn, -2.0 * turn, 3.0 * turn);
        Vicon { fresh: number % 5 != 0, angles, ..seen(turn) }
    };
    assert_eq!(said().as_deref(), Some("aircraft 1"));
    for number in 1..=frames {
        assert_eq!(said().as_deref(), Some("next"));
        let sent = pose(number);
        server.send(0.0, &sent);
        let line = said().expect("a frame");
        let bits =
            |it: &[f32]| it.iter().map(|it| format!("{:08x}", it.to_bits())).collect::<String>();
        let (place, turn) = ground::mocap::pose(&sent);
        let wanted = match sent.fresh {
            true => format!("{number} True {} {}", bits(&place), bits(&turn)),
            false => format!("{number} False {} {}", bits(&[0.0; 3]), bits(&[0.0, 0.0, 0.0, 1.0])),
        };
        assert_eq!(line, wanted);
    }
    assert!(said().is_none() && child.wait().expect("it is ours").success());
}
