//! A NatNet server that streams the simulated aircraft, as Motive would stream a real one.
//!
//! Unicast, version 4.1, one rigid body, the y axis upwards. A thread answers commands; the aircraft's thread sends the
//! frames to every client that was heard lately. It must not know who listens.

use super::{BODY, pose::pose};
use crate::priority;
use crate::wait;
use models::calibration::Vicon;
use natnet::serverinfo::ConnectionInfo;
use natnet::{
    DataSet, MessageHeader, ModelDef, NAT_CONNECT, NAT_DISCONNECT, NAT_KEEPALIVE, NAT_REQUEST,
    NAT_REQUEST_MODELDEF, NAT_UNRECOGNIZED_REQUEST, PlannedBody, RigidBodyDef, ServerInfo,
    SyntheticServer, Version,
};
use std::io;
use std::net::{SocketAddr, SocketAddrV4, UdpSocket};
use std::sync::{Arc, Mutex, Weak};
use std::time::{Duration, Instant};

/// Version of the protocol.
const VERSION: Version = Version::V4_1;

/// Number of the rigid body.
const ID: i32 = 1;

/// Frequency of the clock in frames, Hz.
const CLOCK: u64 = 1_000_000;

/// Silence after which a client receives no more frames.
const CLIENT_TIMEOUT: Duration = Duration::from_secs(30);

/// The most clients at once.
const MOST_CLIENTS: usize = 16;

/// Interval between checks that the [`Server`] still exists.
const LOOK: Duration = Duration::from_millis(200);

/// Clients, and when each was heard last.
type Clients = Mutex<Vec<(SocketAddr, Instant)>>;

/// A server; dropping it ends it.
#[derive(Debug)]
pub struct Server {
    socket: UdpSocket,
    clients: Arc<Clients>,
    address: SocketAddrV4,
    source: SyntheticServer,
    frame: i32,
}

impl Server {
    /// Binds to an address, and answers commands from a thread.
    ///
    /// # Errors
    ///
    /// The address is in use, or there is no thread.
    pub fn start(address: SocketAddrV4) -> io::Result<Self> {
        let socket = UdpSocket::bind(address)?;
        let SocketAddr::V4(bound) = socket.local_addr()? else {
            return Err(io::Error::from(io::ErrorKind::AddrNotAvailable));
        };
        let clients = Arc::<Clients>::default();
        let (ears, there) = (socket.try_clone()?, Arc::downgrade(&clients));
        let (info, model) = descriptions(bound.port()).map_err(io::Error::other)?;
        std::thread::Builder::new().name("natnet".into()).spawn(move || {
            priority::lower();
            answer(&ears, &there, &info, &model);
        })?;
        let source = SyntheticServer::new(VERSION, CLOCK);
        Ok(Self { socket, clients, address: bound, source, frame: 0 })
    }

    /// Returns the address at which the server listens.
    pub fn address(&self) -> SocketAddrV4 {
        self.address
    }

    /// Sends a frame with a reading of the aircraft at a time, s, to every client. A reading that is not fresh is a body
    /// that is not tracked.
    pub fn send(&mut self, time: f64, reading: &Vicon) {
        let (position, orientation) = pose(reading);
        let body = match reading.fresh {
            true => PlannedBody::tracked(ID, position, orientation),
            false => PlannedBody::dropout(ID),
        };
        self.frame = self.frame.wrapping_add(1);
        let Ok(frame) = self.source.datagram(self.frame, time, &[body]) else { return };
        let Ok(mut clients) = self.clients.lock() else { return };
        clients.retain(|(_, heard)| heard.elapsed() < CLIENT_TIMEOUT);
        for (client, _) in clients.iter() {
            // A client that is gone refuses: it loses the frame.
            let _ = self.socket.send_to(&frame, client);
        }
    }
}

/// Returns the datagrams that describe the server at a port and its body.
fn descriptions(data_port: u16) -> natnet::Result<(Vec<u8>, Vec<u8>)> {
    let info = ServerInfo {
        application_name: "Bessemer testbed".into(),
        server_version: Version::new(0, 1, 0, 0),
        protocol_version: VERSION,
        high_res_clock_frequency: CLOCK,
        connection: ConnectionInfo { data_port, multicast: false, multicast_group: [0; 4] },
    };
    let body = RigidBodyDef {
        name: BODY.into(),
        id: ID,
        parent_id: -1,
        offset: [0.0; 3],
        // No markers.
        tail: vec![0; 4],
    };
    let model = ModelDef { datasets: vec![DataSet::RigidBody(body)] };
    Ok((info.to_datagram()?, model.to_datagram(VERSION)?))
}

/// Answers commands until the server is dropped.
fn answer(socket: &UdpSocket, there: &Weak<Clients>, info: &[u8], model: &[u8]) {
    let mut buffer = [0; 2048];
    loop {
        let heard = wait::receive(socket, &mut buffer, Instant::now() + LOOK);
        let Some(clients) = there.upgrade() else { return };
        // Refused: a client is gone, and that says nothing of the others.
        let Ok(Some((length, from))) = heard else { continue };
        let Ok(header) = MessageHeader::parse(&buffer[..length]) else { continue };
        let unknown = [NAT_UNRECOGNIZED_REQUEST.to_le_bytes(), [0; 2]].concat();
        let reply = match header.message_id {
            NAT_CONNECT => info,
            NAT_REQUEST_MODELDEF => model,
            NAT_REQUEST => &unknown,
            NAT_KEEPALIVE | NAT_DISCONNECT => &[],
            _ => continue,
        };
        if !reply.is_empty() {
            let _ = socket.send_to(reply, from);
        }
        if let Ok(mut clients) = clients.lock() {
            let known = clients.iter().position(|(client, _)| *client == from);
            match (known, header.message_id) {
                (Some(place), NAT_DISCONNECT) => drop(clients.swap_remove(place)),
                (Some(place), _) => clients[place].1 = Instant::now(),
                (None, NAT_CONNECT) if clients.len() < MOST_CLIENTS => {
                    clients.push((from, Instant::now()));
                }
                (None, _) => {}
            }
        }
    }
}
