//! The testbed: bench, link and ground station together, one control period at a time.
//!
//! In virtual time, two runs with one seed have the same bits, although they use sockets: an uplink packet is in the
//! computer's socket before the sensors' datagram. Knows no browser and no file: the caller gets the results of each
//! period.

use crate::bench::{self, Bench, Injection, Period};
use crate::catalogue::page_signals;
use crate::key::Key;
use crate::mocap::{self, Receiver, Server, Source};
use crate::priority::{self, Awake};
use crate::program::{self, Boot, Program, Running};
use crate::radio::{Counts, Quality, Way};
use crate::station::Station;
use crate::wait;
use models::Settings;
use sim::Aircraft;
use sim::ground_station::News;
use std::io;
use std::net::{Ipv4Addr, SocketAddr, SocketAddrV4, UdpSocket};
use std::time::{Duration, Instant, SystemTime, UNIX_EPOCH};

/// Timeout of a program's start, emulated on a busy machine.
const START_TIMEOUT: Duration = Duration::from_secs(30);

/// Timeout of a datagram on loopback: it only ends a wait for one that was lost.
const DELIVERY_TIMEOUT: Duration = Duration::from_secs(10);

/// Timeout of the software's memory image in real time; otherwise that of a datagram.
const IMAGE: Duration = Duration::from_secs(2);

/// Number of periods of delay after which real time restarts instead of catching up.
const STALLED: u32 = 10;

/// Reason why the testbed does not run.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// The onboard software does not run.
    #[error(transparent)]
    Program(#[from] program::Error),
    /// The address of the link is of another machine.
    #[error("the link at `{address}`: {source}; write an address of this machine")]
    Link {
        /// Address of the link.
        address: Ipv4Addr,
        /// An error of the system.
        source: io::Error,
    },
    /// Motion capture cannot be received.
    #[error(transparent)]
    Mocap(#[from] mocap::Error),
    /// There is no server for the simulated motion capture.
    #[error("the NatNet server at `{address}`: {source}; port 0 takes a port that is free")]
    Natnet {
        /// Address of the server.
        address: SocketAddrV4,
        /// An error of the system.
        source: io::Error,
    },
    /// A socket failed.
    #[error("a socket of the testbed: {0}")]
    Socket(#[from] io::Error),
    /// The onboard software ended before it said anything.
    #[error("the onboard software ended at its start: {0}")]
    Ended(String),
    /// The onboard software did not answer.
    #[error("the onboard software does not answer: it was started, and sent nothing for {} s", START_TIMEOUT.as_secs())]
    Silent,
}

/// Time base of the testbed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Pace {
    /// Real time.
    #[default]
    Real,
    /// Real time if the software keeps up, otherwise slower, so that no period is missed on a busy machine.
    Patient,
    /// As fast as the software answers.
    Virtual,
}

/// Configuration of a testbed.
#[derive(Clone, Debug)]
pub struct Wanted {
    /// Aircraft to fly.
    pub aircraft: Aircraft,
    /// Address at which the onboard software receives commands; port 0 for any free port.
    pub link: SocketAddrV4,
    /// Time base.
    pub pace: Pace,
    /// Quality of the link.
    pub quality: Quality,
    /// Key of those who may command.
    pub key: Option<Key>,
    /// A different key for the software, for tests of the gate.
    pub other_key: Option<Key>,
    /// Motion capture in place of the simulated one.
    pub mocap: Option<Source>,
    /// Address at which a NatNet server streams the simulated aircraft.
    pub natnet: Option<SocketAddrV4>,
    /// Seed of all randomness.
    pub seed: u64,
}

impl Default for Wanted {
    fn default() -> Self {
        Self {
            aircraft: Aircraft::default(),
            link: SocketAddrV4::new(Ipv4Addr::LOCALHOST, 0),
            pace: Pace::default(),
            quality: Quality::default(),
            key: None,
            other_key: None,
            mocap: None,
            natnet: None,
            seed: 0,
        }
    }
}

/// The testbed.
pub struct Testbed {
    /// The aircraft.
    pub bench: Bench,
    /// The ground station.
    pub station: Station,
    /// The uplink.
    pub up: Way,
    /// The downlink.
    pub down: Way,
    program: Program,
    running: Running,
    key: Option<Key>,
    /// Address at which the software receives commands.
    wanted_link: SocketAddrV4,
    socket: UdpSocket,
    here: Option<u64>,
    pace: Pace,
    _awake: Option<Awake>,
    begun: Instant,
    periods: u32,
    /// Number of restarts of the software.
    pub restarts: u64,
    /// Reason of the last restart.
    pub ended: Option<String>,
}

impl Testbed {
    /// Starts the software and waits until it answers.
    ///
    /// # Errors
    ///
    /// It does not start, or there are no ports.
    pub fn start(program: &Program, wanted: &Wanted) -> Result<Self, Error> {
        let host = match *wanted.link.ip() {
            Ipv4Addr::UNSPECIFIED => Ipv4Addr::LOCALHOST,
            host => host,
        };
        let mut bench = Bench::new(wanted.aircraft, host, wanted.seed)?;
        if let Some(address) = wanted.natnet {
            let failed = |source| Error::Natnet { address, source };
            bench.stream = Some(Server::start(address).map_err(failed)?);
        }
        bench.capture = wanted.mocap.as_ref().map(Receiver::connect).transpose()?;
        // Both ends of the link have the same address, since the aircraft's is of this machine.
        let unreachable = |source| Error::Link { address: host, source };
        let socket = UdpSocket::bind((host, 0)).map_err(unreachable)?;
        socket.set_nonblocking(true)?;
        let key = wanted.other_key.clone().or_else(|| wanted.key.clone());
        let boot = Boot {
            bus: bench.port()?,
            key: key.as_ref(),
            aircraft: wanted.aircraft,
            link: wanted.link,
        };
        let mut running = match wanted.pace {
            Pace::Real => priority::raised(|| program.start(&boot))?,
            _ => program.start(&boot)?,
        };
        meet(&mut bench, &mut running)?;
        Ok(Self {
            bench,
            station: Station::new(wanted.key.clone(), page_signals(wanted.aircraft), 0.0),
            up: Way::new(wanted.quality, wanted.seed),
            down: Way::new(wanted.quality, wanted.seed.wrapping_add(1)),
            program: program.clone(),
            running,
            key,
            wanted_link: wanted.link,
            here: bench::station(socket.local_addr()?),
            socket,
            pace: wanted.pace,
            _awake: (wanted.pace == Pace::Real).then(Awake::keep),
            begun: Instant::now(),
            periods: 0,
            restarts: 0,
            ended: None,
        })
    }

    /// Returns the time since the testbed began, from the number of its periods, s.
    pub fn now(&self) -> f64 {
        self.bench.timing.periods as f64 * period()
    }

    /// Returns the counters of the datagrams of uplink and downlink.
    pub fn counts(&self) -> (Counts, Counts) {
        (self.up.counts, self.down.counts)
    }

    /// Returns the address at which the aircraft receives commands.
    pub fn link(&self) -> Option<SocketAddr> {
        self.bench.link()
    }

    /// Returns the process number of the software.
    pub fn process(&self) -> u32 {
        self.running.id()
    }

    /// Kills the software; it is restarted in the next period.
    pub fn kill(&mut self) {
        self.running.kill();
    }

    /// Returns the software's memory between two periods; none, if no answer comes.
    ///
    /// # Errors
    /// An error of the system.
    pub fn image(&mut self) -> io::Result<Option<Vec<u8>>> {
        self.bench.image(if self.pace == Pace::Real { IMAGE } else { DELIVERY_TIMEOUT })
    }

    /// Returns true if time waits for the software, and so for its listeners.
    pub fn waits(&self) -> bool {
        self.pace != Pace::Real
    }

    /// Injects a fault into the aircraft.
    pub fn inject(&mut self, what: Injection) {
        self.bench.inject(what);
    }

    /// Runs one period and returns it with the received telemetry. In real time it starts when it is due.
    ///
    /// # Errors
    ///
    /// A socket failed, or the software cannot be restarted.
    pub fn step(&mut self) -> Result<(Period, Vec<News>), Error> {
        let deadline = self.pause();
        if let Some(why) = self.running.ended() {
            self.ended = Some(why);
            self.restart()?;
        }
        let now = self.now();
        if let Some(datagram) = self.station.tick(now, milliseconds()) {
            self.up.send(now, &datagram);
        }
        for datagram in self.up.arrived(now) {
            // A software that is gone refuses: the datagram is lost.
            let _ = self.link().map(|link| self.socket.send_to(&datagram, link));
        }
        let running = &mut self.running;
        let done = self.bench.step(deadline, || running.ended().is_none())?;
        if self.pace == Pace::Virtual && done.addressee.is_some() && done.addressee == self.here {
            self.await_datagram()?;
        }
        self.listen(now);
        let mut news = Vec::new();
        for datagram in self.down.arrived(now) {
            news.extend(self.station.receive(now, &datagram));
        }
        Ok((done, news))
    }

    /// Runs periods until a time since the beginning, s; calls `seen` with each.
    ///
    /// # Errors
    ///
    /// As for [`step`](Testbed::step).
    pub fn run_until(
        &mut self,
        time: f64,
        mut seen: impl FnMut(&Period, &[News]),
    ) -> Result<(), Error> {
        while self.now() < time {
            let (done, news) = self.step()?;
            seen(&done, &news);
        }
        Ok(())
    }

    /// Waits for the datagram that went down to this station in this period. A busy system may deliver it after the answer, which
    /// went to another socket; in virtual time it belongs to the period.
    fn await_datagram(&self) -> io::Result<()> {
        self.socket.set_nonblocking(false)?;
        let _ = wait::is_there(&self.socket, Instant::now() + DELIVERY_TIMEOUT);
        self.socket.set_nonblocking(true)
    }

    /// Moves all datagrams from the socket to the simulated downlink.
    fn listen(&mut self, now: f64) {
        let mut buffer = [0; 2048];
        while let Ok((length, from)) = self.socket.recv_from(&mut buffer) {
            if Some(from) == self.link() {
                self.down.send(now, &buffer[..length]);
            }
        }
    }

    /// Waits for the beginning of the period; returns its end, if the software has a deadline.
    fn pause(&mut self) -> Option<Instant> {
        if self.pace == Pace::Virtual {
            return None;
        }
        let length = Duration::from_secs_f64(period());
        let mut due = self.begun + length * self.periods;
        let now = Instant::now();
        if now > due + length * STALLED {
            (self.begun, self.periods, due) = (now, 0, now);
        }
        if self.pace == Pace::Real && self.periods == 0 {
            priority::raise();
        }
        std::thread::sleep(due.saturating_duration_since(now));
        self.periods += 1;
        (self.pace == Pace::Real).then(|| due + length)
    }

    fn restart(&mut self) -> Result<(), Error> {
        self.bench.unplug();
        self.restarts += 1;
        self.station.anew();
        self.running = self.program.start(&Boot {
            bus: self.bench.port()?,
            key: self.key.as_ref(),
            aircraft: self.bench.aircraft(),
            link: self.wanted_link,
        })?;
        // The aircraft does not wait for its computer; time does, unless it is real.
        if self.pace != Pace::Real {
            meet(&mut self.bench, &mut self.running)?;
        }
        Ok(())
    }
}

/// Waits until the software answers, while it runs.
fn meet(bench: &mut Bench, running: &mut Running) -> Result<(), Error> {
    for _ in 0..START_TIMEOUT.as_secs() {
        if bench.wait(Duration::from_secs(1))? {
            return Ok(());
        }
        if let Some(why) = running.ended() {
            return Err(Error::Ended(why));
        }
    }
    Err(Error::Silent)
}

/// The control period, s.
pub fn period() -> f64 {
    Settings::mambo().parameters.period
}

/// The time in milliseconds since 1970.
fn milliseconds() -> u64 {
    let since = SystemTime::now().duration_since(UNIX_EPOCH).unwrap_or_default();
    u64::try_from(since.as_millis()).unwrap_or(u64::MAX)
}
