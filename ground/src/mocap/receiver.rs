//! A client of a NatNet server: the pose of one rigid body, as a reading of Vicon.
//!
//! Unicast and multicast, versions 3.0 to 4.1. A server that falls silent is requested to stream again, so the flight goes on
//! with the estimator's other sources until it is back. It must not know what the reading is for.

use super::{Up, pose::reading};
use models::calibration::Vicon;
use natnet::net::{CommandClient, DataClient, HandshakeError, MIN_DATA_BUFFER, RawCommandClient};
use natnet::{
    DataSet, Decoder, FrameOfData, Message, ModelDef, ParsePolicy, RigidBodyDef, command,
};
use std::io::ErrorKind::{Interrupted, TimedOut, WouldBlock};
use std::io::{self, Result as IoResult};
use std::net::{IpAddr, Ipv4Addr, SocketAddr, SocketAddrV4, UdpSocket};
use std::time::{Duration, Instant};

/// Timeout of the server's answer to a command.
const ANSWER_TIMEOUT: Duration = Duration::from_secs(2);

/// Interval between the messages that keep a unicast server streaming.
const KEEPALIVE_PERIOD: Duration = Duration::from_secs(1);

/// Silence after which the server is requested to stream again: it may have been restarted.
const SILENCE: Duration = Duration::from_secs(2);

/// Frames by which a datagram that was overtaken may be older than the last one. One that is older still belongs to a server that
/// counts anew.
const OVERTAKEN: i32 = 1000;

/// A body of a motion-capture system.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Source {
    /// Address of the server's commands.
    pub server: SocketAddrV4,
    /// Name of the rigid body, or its number.
    pub body: String,
    /// Axis that points upwards.
    pub up: Up,
}

/// Reason why motion capture cannot be received.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// There is no socket for the server.
    #[error("motion capture at `{server}`: {source}; is this the address of a machine in reach?")]
    Socket {
        /// Address of the server.
        server: SocketAddrV4,
        /// An error of the system.
        source: io::Error,
    },
    /// The server did not answer, or answered something that this version does not understand.
    #[error(
        "motion capture at `{server}`: {source}; switch streaming over NatNet on there, version 3.0 to 4.1"
    )]
    Handshake {
        /// Address of the server.
        server: SocketAddrV4,
        /// Reason.
        source: Box<HandshakeError>,
    },
    /// The server did not describe its bodies.
    #[error("motion capture at `{server}` does not describe its bodies: {reason}")]
    Model {
        /// Address of the server.
        server: SocketAddrV4,
        /// Reason.
        reason: String,
    },
    /// The server has no such body.
    #[error("motion capture at `{server}` has no rigid body `{body}`; its bodies are: {known}")]
    Body {
        /// Address of the server.
        server: SocketAddrV4,
        /// Name or number of the body.
        body: String,
        /// Names of the bodies, with their numbers.
        known: String,
    },
}

/// Numbers of received datagrams.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counts {
    /// Frames with a pose of the body.
    pub poses: u64,
    /// Frames in which the body is missing, not tracked or not finite.
    pub untracked: u64,
    /// Frames that are no newer than the last one.
    pub old: u64,
    /// Datagrams that are no message.
    pub broken: u64,
}

/// Sockets on which the frames arrive.
enum Frames {
    /// The socket of the commands.
    Unicast,
    /// A socket of the group.
    Multicast(DataClient),
}

/// The receiver.
pub struct Receiver {
    commands: RawCommandClient,
    frames: Frames,
    server: SocketAddrV4,
    decoder: Decoder,
    body: i32,
    up: Up,
    last: Option<i32>,
    heard: Instant,
    kept: Instant,
    buffer: Vec<u8>,
    /// Statistics of the stream.
    pub counts: Counts,
}

impl Receiver {
    /// Connects to a server, and finds the body.
    ///
    /// # Errors
    ///
    /// The server does not answer in two seconds, or has no such body.
    pub fn connect(source: &Source) -> Result<Self, Error> {
        let server = source.server;
        let socket = |source| Error::Socket { server, source };
        let here = route(server).map_err(socket)?;
        let mut client = CommandClient::bind(here, server).map_err(socket)?;
        let info = client
            .connect_handshake(ANSWER_TIMEOUT)
            .map_err(|source| Error::Handshake { server, source: Box::new(source) })?;
        let failed = |reason: String| Error::Model { server, reason };
        let request = command::request_modeldef().map_err(|error| failed(error.to_string()))?;
        let reply = client.exchange(&request, ANSWER_TIMEOUT);
        let reply = reply.map_err(|error| failed(error.to_string()))?;
        let version = info.protocol_version;
        let model = ModelDef::parse(&reply, version).map_err(|error| failed(error.to_string()))?;
        let bodies: Vec<&RigidBodyDef> = model.datasets.iter().filter_map(rigid_body).collect();
        let Some(body) = found(&bodies, &source.body) else {
            let known = bodies.iter().map(|it| format!("`{}` ({})", it.name, it.id));
            let known = known.collect::<Vec<_>>().join(", ");
            let known = if known.is_empty() { "none".into() } else { known };
            return Err(Error::Body { server, body: source.body.clone(), known });
        };
        let decoder = Decoder::new(version).map_err(|error| failed(error.to_string()))?;
        let commands = client.into_raw();
        commands.set_nonblocking(true).map_err(socket)?;
        let frames = if info.connection.multicast {
            let (group, port) = (info.multicast_group(), info.connection.data_port);
            let client = DataClient::bind_multicast(here, group, port).map_err(socket)?;
            client.set_nonblocking(true).map_err(socket)?;
            Frames::Multicast(client)
        } else {
            Frames::Unicast
        };
        let now = Instant::now();
        Ok(Self {
            commands,
            frames,
            server,
            decoder: decoder.with_policy(ParsePolicy::Compatible),
            body,
            up: source.up,
            last: None,
            heard: now,
            kept: now,
            buffer: vec![0; MIN_DATA_BUFFER],
            counts: Counts::default(),
        })
    }

    /// Returns the address of the server.
    pub fn server(&self) -> SocketAddrV4 {
        self.server
    }

    /// Returns the newest pose that has arrived since the last call, without waiting. Without one, the reading is not fresh.
    pub fn take(&mut self) -> Vicon {
        self.keep();
        let mut newest = Vicon::default();
        while let Ok((length, from)) = self.receive() {
            if let Some(frame) = self.frame(length, from) {
                newest = self.seen(&frame).unwrap_or_default();
            }
        }
        newest
    }

    /// Waits for the next frame until a deadline, and returns its pose: for time that waits for the aircraft.
    pub fn await_next(&mut self, until: Instant) -> Vicon {
        self.keep();
        loop {
            let left = until.saturating_duration_since(Instant::now());
            if left.is_zero() || self.block(Some(left)).is_err() {
                return Vicon::default();
            }
            let heard = self.receive();
            let _ = self.block(None);
            match heard {
                Ok((length, from)) => {
                    if let Some(frame) = self.frame(length, from) {
                        return self.seen(&frame).unwrap_or_default();
                    }
                }
                Err(error) if matches!(error.kind(), Interrupted | TimedOut | WouldBlock) => {}
                Err(_) => return Vicon::default(),
            }
        }
    }

    /// Keeps the server streaming.
    fn keep(&mut self) {
        if self.kept.elapsed() < KEEPALIVE_PERIOD {
            return;
        }
        self.kept = Instant::now();
        // A server that is gone refuses: the next request is in a second.
        let _ = match command::connect_request() {
            Ok(connect) if self.heard.elapsed() > SILENCE => self.commands.send(connect.as_bytes()),
            _ => self.commands.send(&command::keepalive_datagram()),
        };
    }

    fn receive(&mut self) -> IoResult<(usize, SocketAddr)> {
        match &self.frames {
            Frames::Unicast => self.commands.recv(&mut self.buffer),
            Frames::Multicast(client) => client.recv(&mut self.buffer),
        }
    }

    /// Lets a call of [`receive`](Self::receive) wait for a time, or not at all.
    fn block(&self, left: Option<Duration>) -> IoResult<()> {
        match &self.frames {
            Frames::Unicast => {
                self.commands.set_nonblocking(left.is_none())?;
                self.commands.set_read_timeout(left)
            }
            Frames::Multicast(client) => {
                client.set_nonblocking(left.is_none())?;
                client.set_read_timeout(left)
            }
        }
    }

    /// Returns the frame in a received datagram, if it is newer than the last one.
    fn frame(&mut self, length: usize, from: SocketAddr) -> Option<FrameOfData> {
        if from.ip() != IpAddr::V4(*self.server.ip()) {
            return None;
        }
        let Ok(decoded) = self.decoder.parse(&self.buffer[..length]) else {
            self.counts.broken += 1;
            return None;
        };
        // Answers to the commands that keep the server streaming.
        let Message::FrameOfData(frame) = decoded.into_message() else { return None };
        self.heard = Instant::now();
        let ahead = self.last.map_or(1, |last| frame.frame_number.wrapping_sub(last));
        if (-OVERTAKEN..=0).contains(&ahead) {
            self.counts.old += 1;
            return None;
        }
        self.last = Some(frame.frame_number);
        Some(*frame)
    }

    /// Returns the pose of the body in a frame.
    fn seen(&mut self, frame: &FrameOfData) -> Option<Vicon> {
        let body = frame.rigid_bodies.iter().find(|it| it.id == self.body);
        let tracked = body.filter(|it| it.tracking_valid());
        let seen = tracked.and_then(|it| reading(self.up, it.position, it.orientation));
        match seen {
            Some(_) => self.counts.poses += 1,
            None => self.counts.untracked += 1,
        }
        seen
    }
}

impl Drop for Receiver {
    fn drop(&mut self) {
        // A server that does not hear it forgets this client by its silence.
        let _ = self.commands.send(&command::disconnect_datagram());
    }
}

/// Returns the address of this machine from which a server is reached.
fn route(server: SocketAddrV4) -> IoResult<Ipv4Addr> {
    let socket = UdpSocket::bind((Ipv4Addr::UNSPECIFIED, 0))?;
    socket.connect(server)?;
    match socket.local_addr()?.ip() {
        IpAddr::V4(address) => Ok(address),
        IpAddr::V6(_) => Err(io::ErrorKind::AddrNotAvailable.into()),
    }
}

fn rigid_body(dataset: &DataSet) -> Option<&RigidBodyDef> {
    match dataset {
        DataSet::RigidBody(body) => Some(body),
        _ => None,
    }
}

/// Returns the number of the body with a name, or with this number.
fn found(bodies: &[&RigidBodyDef], wanted: &str) -> Option<i32> {
    let number = wanted.parse::<i32>().ok();
    let named = bodies.iter().find(|it| it.name == wanted);
    named.or_else(|| bodies.iter().find(|it| Some(it.id) == number)).map(|it| it.id)
}
