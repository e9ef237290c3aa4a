//! The onboard software on a board at the other end of a serial line, presented as a computer with sockets.
//!
//! Datagrams are converted to frames and back.
//!
//! Like the program on this machine, it processes packets from the ground when a datagram of the bus arrives, and
//! sends packets to the ground before its answer, so that a flight in virtual time is the same. It ends with the
//! line, or when the [`Relay`] is dropped. `ground/onboard/zynq/main.c` is the other end.
//!
//! What it must not know: the contents of datagrams.

use crate::bench::station;
use crate::key::Key;
use crate::program::Boot;
use bessemer_legs::lockstep::complaint;
use bessemer_legs::serial::{self, Serial, packed, unpacked};
use std::io::ErrorKind::{Interrupted, TimedOut, WouldBlock};
use std::io::{self, Read, Write};
use std::net::{Ipv4Addr, SocketAddrV4, UdpSocket};
use std::sync::{Arc, OnceLock, Weak};
use std::time::Duration;

/// Interval between checks that the [`Relay`] still exists.
const LOOK: Duration = Duration::from_millis(500);

/// The longest datagram: the software's memory.
const MOST: usize = 1 << 16;

/// The kinds of frames, given by their first word.
mod kind {
    pub const READY: u64 = 1;
    pub const BEGIN: u64 = 2;
    pub const BUS: u64 = 3;
    pub const GROUND: u64 = 4;
}

/// Reason why the board no longer works.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// The line failed.
    #[error("the board's line: {0}")]
    Line(#[from] serial::Error),
    /// The board reported an error.
    #[error("the board says: {0}")]
    Board(String),
    /// The board sent an answer that does not fit the request.
    #[error("the board answers something else than it was asked")]
    Other,
    /// A socket failed.
    #[error("the board's sockets: {0}")]
    Socket(#[from] io::Error),
}

/// A relay that runs on its own thread.
#[derive(Debug)]
pub struct Relay(Arc<OnceLock<Error>>);

impl Relay {
    /// Starts to relay between a line and the bus at a port; announces the board there as soon as it is ready.
    ///
    /// # Errors
    ///
    /// There are no ports.
    pub fn start<L: Read + Write + Send + 'static>(line: L, boot: &Boot<'_>) -> io::Result<Self> {
        let to_bus = UdpSocket::bind((Ipv4Addr::LOCALHOST, 0))?;
        let ground = UdpSocket::bind(boot.link)?;
        to_bus.connect((Ipv4Addr::LOCALHOST, boot.bus))?;
        to_bus.set_read_timeout(Some(LOOK))?;
        ground.set_nonblocking(true)?;
        let [low, high] = boot.key.map(Key::halves).unwrap_or_default();
        let begin = [kind::BEGIN, u64::from(boot.key.is_some()), low, high, boot.aircraft.number()];
        let mut ends = Ends { board: Serial::new(line), bus: to_bus, ground };
        let wrong = Arc::new(OnceLock::new());
        let there = Arc::downgrade(&wrong);
        std::thread::spawn(move || {
            if let Err(error) = ends.relay(&begin, &there)
                && let Some(wrong) = there.upgrade()
            {
                let _ = wrong.set(error);
            }
        });
        Ok(Self(wrong))
    }

    /// Returns the error that ended the relay, if any.
    pub fn wrong(&self) -> Option<&Error> {
        self.0.get()
    }
}

/// Endpoints of the relay.
struct Ends<L> {
    board: Serial<L>,
    bus: UdpSocket,
    ground: UdpSocket,
}

impl<L: Read + Write> Ends<L> {
    /// Relays until the other end of `there` is dropped.
    fn relay(&mut self, begin: &[u64], there: &Weak<OnceLock<Error>>) -> Result<(), Error> {
        if self.receive()? != [kind::READY] {
            return Err(Error::Other);
        }
        self.board.send(begin)?;
        let port = self.ground.local_addr()?.port();
        // Whoever does not listen any more is reported nothing.
        let _ = self.bus.send(&[b"ready", &port.to_le_bytes()[..]].concat());
        let mut datagram = vec![0; MOST];
        while there.strong_count() > 0 {
            let length = match self.bus.recv(&mut datagram) {
                Ok(length) => length,
                Err(error) if matches!(error.kind(), WouldBlock | TimedOut | Interrupted) => {
                    continue;
                }
                // The other end of the bus is closed.
                Err(_) => break,
            };
            let mut heard = [0; 2048];
            while let Ok((length, from)) = self.ground.recv_from(&mut heard) {
                let Some(station) = station(from) else { continue };
                // One byte more than the board reads is enough to tell it that this is no packet.
                let some = &heard[..length.min(LONGEST_HEARD)];
                let words = [kind::GROUND, station].into_iter().chain(packed(some));
                self.board.send(&words.collect::<Vec<_>>())?;
            }
            let words = std::iter::once(kind::BUS).chain(packed(&datagram[..length]));
            self.board.send(&words.collect::<Vec<_>>())?;
            self.answer()?;
        }
        Ok(())
    }

    /// Passes frames on, up to and including the answer to a datagram of the bus.
    fn answer(&mut self) -> Result<(), Error> {
        loop {
            match &self.receive()?[..] {
                [kind::GROUND, station, words @ ..] => {
                    let datagram = unpacked(words).ok_or(Error::Other)?;
                    let _ = self.ground.send_to(&datagram, address(*station));
                }
                [kind::BUS, words @ ..] => {
                    let datagram = unpacked(words).ok_or(Error::Other)?;
                    if !datagram.is_empty() {
                        let _ = self.bus.send(&datagram);
                    }
                    return Ok(());
                }
                _ => return Err(Error::Other),
            }
        }
    }

    fn receive(&mut self) -> Result<Vec<u64>, Error> {
        let words = self.board.receive()?;
        match complaint(&words) {
            Some(said) => Err(Error::Board(said)),
            None => Ok(words),
        }
    }
}

/// Number of bytes of a datagram from the ground that are passed to the board: one more than a packet has.
const LONGEST_HEARD: usize = models::packet::MAX_BYTES + 1;

/// The address that a number represents.
fn address(number: u64) -> SocketAddrV4 {
    SocketAddrV4::new(Ipv4Addr::from_bits((number >> 16) as u32), number as u16)
}

#[cfg(test)]
mod tests {
    use super::*;
    use sim::Aircraft;
    use std::net::{Shutdown, SocketAddr};
    use std::os::unix::net::UnixStream;
    use std::time::Instant;

    /// A bus, a relay to it, and the board's end of the line.
    fn started(key: Option<&Key>) -> (UdpSocket, Relay, Serial<UnixStream>) {
        let bus = UdpSocket::bind((Ipv4Addr::LOCALHOST, 0)).expect("a port");
        let (here, there) = UnixStream::pair().expect("a line");
        let port = bus.local_addr().expect("a port").port();
        let boot = Boot { key, aircraft: Aircraft::F550, ..Boot::on(port) };
        let relay = Relay::start(here, &boot).expect("ports");
        (bus, relay, Serial::new(there))
    }

    fn heard(socket: &UdpSocket) -> (Vec<u8>, SocketAddr) {
        // It only ends a test that would never end.
        let limit = Instant::now() + Duration::from_secs(60);
        let mut buffer = [0; 2048];
        let heard = crate::wait::receive(socket, &mut buffer, limit).expect("a socket");
        let (length, from) = heard.expect("a datagram");
        (buffer[..length].to_vec(), from)
    }

    #[test]
    fn datagrams_and_frames_stand_for_one_another() {
        let key = Key::new(*b"\x01\0\0\0\0\0\0\0\x02\0\0\0\0\0\0\0");
        let (bus, _relay, mut board) = started(Some(&key));
        board.send(&[kind::READY]).expect("a line");
        assert_eq!(board.receive().expect("a frame"), [kind::BEGIN, 1, 1, 2, 1]);
        let (ready, computer) = heard(&bus);
        let port = ready.strip_prefix(b"ready").expect("it says that it is there");
        let link = u16::from_le_bytes(port.try_into().expect("a port"));

        let station = UdpSocket::bind((Ipv4Addr::LOCALHOST, 0)).expect("a port");
        station.send_to(&[7; 200], (Ipv4Addr::LOCALHOST, link)).expect("loopback takes it");
        bus.send_to(b"sensors", computer).expect("loopback takes it");
        let up = board.receive().expect("a frame");
        let who = super::station(station.local_addr().expect("an address")).expect("of version 4");
        assert_eq!((up[0], up[1]), (kind::GROUND, who));
        assert_eq!(unpacked(&up[2..]), Some(vec![7; LONGEST_HEARD]));
        let sensors = board.receive().expect("a frame");
        assert_eq!(unpacked(&sensors[1..]).as_deref(), Some(&b"sensors"[..]));

        let frame = |head: &[u64], bytes: &[u8]| {
            head.iter().copied().chain(packed(bytes)).collect::<Vec<_>>()
        };
        board.send(&frame(&[kind::GROUND, who], b"down")).expect("a line");
        board.send(&frame(&[kind::BUS], b"motors")).expect("a line");
        assert_eq!(heard(&bus).0, b"motors");
        assert_eq!(heard(&station).0, b"down");
    }

    /// Returns the error for a board that answers the first datagram thus and then disconnects.
    fn told(answer: &[u64]) -> String {
        let (bus, relay, mut board) = started(None);
        board.send(&[kind::READY]).expect("a line");
        let (_, computer) = heard(&bus);
        bus.send_to(b"sensors", computer).expect("loopback takes it");
        board.send(answer).expect("a line");
        board.line().shutdown(Shutdown::Write).expect("a line");
        relay.0.wait().to_string()
    }

    #[test]
    fn a_board_that_fails_is_told() {
        let wrong: Vec<u64> = [6].into_iter().chain("no".bytes().map(u64::from)).collect();
        assert_eq!(told(&wrong), "the board says: no");
        assert_eq!(told(&[kind::READY]), "the board answers something else than it was asked");
        assert_eq!(told(&[kind::BUS, 9]), "the board answers something else than it was asked");
        let down = [kind::GROUND, 0, 0];
        assert_eq!(told(&down), "the board's line: the line is closed: the other end is gone");
    }
}
