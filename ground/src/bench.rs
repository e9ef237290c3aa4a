//! The simulated aircraft: plant, motors, air and sensors, with a program at the other end of the bus as its
//! computer.
//!
//! A period begins with the sensors' datagram and ends with the motors' datagram. In virtual time the bench waits for
//! the answer; in real time it waits no longer than the period. Without an answer the last command remains, and the
//! period counts as missed. Knows nothing of the ground station.

use crate::mocap::{Receiver, Server};
use crate::wait;
use bessemer::Plain;
use bessemer_legs::{value, words};
use models::calibration::Vicon;
use models::gate::Refused;
use models::packet::Packet;
use models::{Inputs, Outputs};
use serde::{Deserialize, Serialize};
use sim::Aircraft;
use sim::air::Air;
use sim::battery::Battery;
use sim::noise::{Purpose, Stream};
use sim::plant::State;
use sim::sensors::{Fault, FaultKind, Senses, Sensor};
use sim::voyage::Moment;
use sim::world::World;
use std::collections::VecDeque;
use std::io;
use std::net::{Ipv4Addr, SocketAddr, UdpSocket};
use std::time::{Duration, Instant};

/// Largest force of the wind on an aircraft of this size, N.
const WIND: f64 = 1.0;

/// Number of periods without a command after which the motors stop, as on a real aircraft.
const FAILSAFE: u64 = 20;

/// Timeout of a running software in virtual time: it only ends a wait that would never end.
const ANSWER_TIMEOUT: Duration = Duration::from_secs(60);

/// Number of periods between two frames of the simulated motion capture.
const CAPTURE_DECIMATION: u64 = 2;

/// Period of checks that the software is still running.
const LOOK: Duration = Duration::from_millis(500);

/// Faults that can be injected into the aircraft.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(tag = "what", rename_all = "snake_case")]
pub enum Injection {
    /// A motor stops, or all run again.
    Motor {
        /// Index of the stopped motor; none if all run.
        number: Option<usize>,
    },
    /// The gyroscope sticks at its last value, or works again.
    Gyroscope {
        /// True if the sensor is stuck.
        stuck: bool,
    },
    /// Vicon loses the aircraft, or sees it again.
    Vicon {
        /// True if the source is absent.
        away: bool,
    },
    /// Wind starts or changes.
    Wind {
        /// Along x and y, N.
        force: [f64; 2],
        /// Standard deviation of the gusts, N.
        gusts: f64,
    },
    /// The aircraft is put back to its start with a full battery.
    Back,
}

impl Injection {
    /// Returns the reason to refuse a fault on an aircraft with so many motors.
    pub fn refusal(&self, motors: usize) -> Option<String> {
        match self {
            Self::Motor { number: Some(number) } if *number >= motors => {
                Some(format!("fault injection refused: there are motors 1 to {motors}"))
            }
            Self::Wind { force: [x, y], gusts }
                if ![x, y, gusts].iter().all(|it| it.abs() <= WIND) =>
            {
                Some(format!("wind refused: allowed are -{WIND} to {WIND} N"))
            }
            _ => None,
        }
    }
}

/// Result of a period.
#[derive(Clone, Debug)]
pub struct Period {
    /// Periods since the bench began.
    pub number: u64,
    /// Periods since the software began; none, if no answer came in time.
    pub count: Option<u64>,
    /// The period, with the last outputs if no answer came.
    pub moment: Moment,
    /// Number of the [`station`] to which a packet went down in this period.
    pub addressee: Option<u64>,
    /// Inputs and outputs of earlier periods whose answers arrived only now.
    pub late: Vec<Worked>,
}

/// One step of the software: its inputs and outputs.
#[derive(Clone, Debug, PartialEq)]
pub struct Worked {
    /// Steps since it began.
    pub count: u64,
    /// Inputs of the software.
    pub inputs: Inputs,
    /// Outputs of the software.
    pub outputs: Outputs,
}

impl Period {
    /// The steps of the software whose answers have arrived, in order.
    pub fn worked(&self) -> impl Iterator<Item = Worked> + '_ {
        let Moment { inputs, outputs, .. } = self.moment;
        let now = self.count.map(|count| Worked { count, inputs, outputs });
        self.late.iter().cloned().chain(now)
    }
}

/// Statistics of the period's timing.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Timing {
    /// Periods begun.
    pub periods: u64,
    /// Periods without an answer in time.
    pub missed: u64,
    /// The longest answer, µs.
    pub slowest: u64,
}

/// The simulated aircraft, with the sockets to its computer.
pub struct Bench {
    aircraft: Aircraft,
    /// Address at which the computer receives commands.
    host: Ipv4Addr,
    /// Motion capture in place of the simulated one.
    pub capture: Option<Receiver>,
    /// Server to which the simulated motion capture goes.
    pub stream: Option<Server>,
    world: World,
    battery: Battery,
    bus: UdpSocket,
    computer: Option<SocketAddr>,
    link: Option<SocketAddr>,
    faults: Vec<Fault>,
    last: Outputs,
    silent: u64,
    start: State,
    period: f64,
    open: VecDeque<(u64, Inputs)>,
    /// Statistics of the period's timing.
    pub timing: Timing,
}

impl Bench {
    /// A bench with an aircraft on the ground; the seed determines all noise. `host` is the address at which the
    /// computer receives commands.
    ///
    /// # Errors
    ///
    /// There is no port.
    pub fn new(aircraft: Aircraft, host: Ipv4Addr, seed: u64) -> io::Result<Self> {
        let period = aircraft.settings().parameters.period;
        let mut dice = Stream::new(seed, Purpose::Dice);
        let mut about = |most: f64| dice.between(-most, most);
        let start = State {
            position: nalgebra::Vector3::new(about(0.1), about(0.1), 0.0),
            angles: nalgebra::Vector3::new(about(0.01), about(0.01), about(0.05)),
            ..State::default()
        };
        let air = Air { gusts: aircraft.gusts(), memory: 0.5, ..Air::default() };
        let world = World::new(&aircraft.airframe(), aircraft.lag(), start, period, seed).with(
            air,
            &Senses::usual(),
            seed,
        );
        Ok(Self {
            aircraft,
            host,
            capture: None,
            stream: None,
            world,
            battery: aircraft.battery(),
            bus: UdpSocket::bind((Ipv4Addr::LOCALHOST, 0))?,
            computer: None,
            link: None,
            faults: Vec::new(),
            last: Outputs::default(),
            silent: 0,
            start,
            period,
            open: VecDeque::new(),
            timing: Timing::default(),
        })
    }

    /// Returns the port of the bus.
    ///
    /// # Errors
    /// An error of the system.
    pub fn port(&self) -> io::Result<u16> {
        Ok(self.bus.local_addr()?.port())
    }

    /// Waits until a computer connects; returns false after `patience`.
    ///
    /// # Errors
    ///
    /// An error of the system.
    pub fn wait(&mut self, patience: Duration) -> io::Result<bool> {
        let deadline = Instant::now() + patience;
        while self.computer.is_none() {
            if !self.hear(deadline, |_| ())? {
                return Ok(false);
            }
        }
        Ok(true)
    }

    /// Returns the address at which the last computer receives commands.
    pub fn link(&self) -> Option<SocketAddr> {
        self.link
    }

    /// Returns the state of the aircraft.
    pub fn state(&self) -> State {
        self.world.state()
    }

    /// Returns the aircraft.
    pub fn aircraft(&self) -> Aircraft {
        self.aircraft
    }

    /// Returns the state of the battery.
    pub fn battery(&self) -> &Battery {
        &self.battery
    }

    /// Injects a fault.
    pub fn inject(&mut self, what: Injection) {
        match what {
            Injection::Motor { number } => {
                self.world.aircraft.plant.motors.dead = number.filter(|motor| *motor < 8);
            }
            Injection::Gyroscope { stuck } => {
                self.set(Sensor::Gyroscope, stuck.then_some(FaultKind::Stuck));
            }
            Injection::Vicon { away } => {
                self.set(Sensor::Vicon, away.then_some(FaultKind::Silent));
            }
            Injection::Wind { force: [x, y], gusts } => {
                let air = &mut self.world.wind.air;
                air.steady = nalgebra::Vector3::new(bounded(x), bounded(y), 0.0);
                air.gusts = bounded(gusts).abs();
            }
            Injection::Back => {
                self.world.place(&self.start);
                self.battery = self.aircraft.battery();
            }
        }
    }

    /// Sets or clears the fault of a sensor.
    fn set(&mut self, sensor: Sensor, kind: Option<FaultKind>) {
        self.faults.retain(|fault| fault.sensor != sensor.name());
        let always = |kind| sensor.fault(kind, f64::NEG_INFINITY, f64::INFINITY);
        self.faults.extend(kind.map(always));
    }

    /// Runs one period. Waits for the answer until `deadline`; without a deadline, as long as the software `runs`.
    ///
    /// # Errors
    /// An error of the system.
    pub fn step(
        &mut self,
        deadline: Option<Instant>,
        mut runs: impl FnMut() -> bool,
    ) -> io::Result<Period> {
        let number = self.timing.periods;
        self.timing.periods += 1;
        let time = number as f64 * self.period;
        let mut readings = self.world.sense(number, |sensor| Fault::at(&self.faults, sensor, time));
        readings.vicon = self.captured(number, time, &readings.vicon, deadline.is_some());
        let clock = 1_000_000 + number * (1e6 * self.period).round() as u64;
        let begun = Instant::now();
        if let Some(computer) = self.computer {
            let mut datagram = vec![number];
            clock.store(&mut |word| datagram.push(word));
            readings.store(&mut |word| datagram.push(word));
            // A computer that is gone refuses: then there is no answer.
            let _ = self.bus.send_to(&bytes(&datagram), computer);
        }
        let mut inputs = Inputs { time: clock, readings, ..Inputs::default() };
        self.open.push_back((number, inputs));
        let (mut count, mut late, mut addressee) = (None, Vec::new(), None);
        if let (None, Some(deadline)) = (self.computer, deadline) {
            // One that was started anew says so.
            self.hear(deadline, |_| ())?;
        }
        let until = deadline.unwrap_or(begun + ANSWER_TIMEOUT);
        while self.computer.is_some() && count.is_none() {
            let mut heard = None;
            let look = if deadline.is_some() { until } else { until.min(Instant::now() + LOOK) };
            if !self.hear(look, |answer| heard = Some(answer))? {
                if look < until && runs() {
                    continue;
                }
                break;
            }
            let Some(answer) = heard else { continue };
            let place = self.open.iter().position(|(open, _)| *open == answer.number);
            let Some((_, taken)) = place.and_then(|place| self.open.remove(place)) else {
                continue;
            };
            let Answer { count: theirs, station, uplink, refused, outputs, .. } = answer;
            let taken = Inputs { uplink, refused, ..taken };
            if answer.number == number {
                (count, inputs, self.last) = (Some(theirs), taken, outputs);
                addressee = (station != 0).then_some(station);
            } else {
                late.push(Worked { count: theirs, inputs: taken, outputs });
            }
        }
        // What is older than a moment is not answered any more.
        while self.open.len() > 64 {
            self.open.pop_front();
        }
        if count.is_some() {
            self.silent = 0;
            let took = u64::try_from(begun.elapsed().as_micros()).unwrap_or(u64::MAX);
            self.timing.slowest = self.timing.slowest.max(took);
        } else {
            self.silent += 1;
            self.timing.missed += 1;
        }
        if self.silent >= FAILSAFE {
            self.last.command = models::Command::still();
        }
        let state = self.world.state();
        let impact = self.world.advance(&self.last.command.speeds);
        let speeds = self.world.aircraft.plant.motors.speeds;
        self.battery.draw(&speeds, self.period);
        let moment = Moment { time, state, inputs, outputs: self.last, speeds, impact };
        Ok(Period { number, count, moment, addressee, late })
    }

    /// Returns the reading of motion capture in a period, from the simulated one. In virtual time a frame of the own
    /// server belongs to its period, and is awaited.
    fn captured(&mut self, number: u64, time: f64, simulated: &Vicon, real: bool) -> Vicon {
        let mut due = None;
        if let Some(server) = self.stream.as_mut()
            && (simulated.fresh || number.is_multiple_of(CAPTURE_DECIMATION))
        {
            server.send(time, simulated);
            due = Some(server.address());
        }
        let Some(receiver) = &mut self.capture else { return *simulated };
        let awaits = !real && due == Some(receiver.server());
        let seen = match awaits {
            true => receiver.await_next(Instant::now() + ANSWER_TIMEOUT),
            false => receiver.take(),
        };
        let is_away = Fault::at(&self.faults, Sensor::Vicon.name(), time).is_some();
        if is_away { Vicon::default() } else { seen }
    }

    /// Returns true if the software has answered lately.
    pub fn is_answered(&self) -> bool {
        self.computer.is_some() && self.silent < FAILSAFE
    }

    /// Returns the software's memory between two periods: bytes for the same program only. None if no answer comes in time.
    ///
    /// # Errors
    /// An error of the system.
    pub fn image(&mut self, patience: Duration) -> io::Result<Option<Vec<u8>>> {
        let Some(computer) = self.computer else { return Ok(None) };
        self.bus.send_to(b"image", computer)?;
        let until = Instant::now() + patience;
        let mut buffer = vec![0; 65536];
        // Late answers of earlier periods may come before it.
        for _ in 0..64 {
            let heard = wait::receive(&self.bus, &mut buffer, until);
            let Ok(Some((length, from))) = heard else { break };
            if from == computer && Answer::read(&buffer[..length]).is_none() {
                buffer.truncate(length);
                return Ok(Some(buffer));
            }
        }
        Ok(None)
    }

    /// Forgets the computer; another one will announce itself.
    pub fn unplug(&mut self) {
        self.computer = None;
    }

    /// Receives one datagram before `deadline` and passes an answer to `take`. Returns false if no datagram arrived.
    fn hear(&mut self, deadline: Instant, take: impl FnOnce(Answer)) -> io::Result<bool> {
        let mut buffer = [0; 4096];
        let (length, from) = match wait::receive(&self.bus, &mut buffer, deadline) {
            Ok(Some(heard)) => heard,
            Ok(None) => return Ok(false),
            // Refused: the computer is gone.
            Err(error) if error.kind() == io::ErrorKind::ConnectionRefused => return Ok(true),
            Err(error) => return Err(error),
        };
        if let Some([low, high]) = buffer[..length].strip_prefix(b"ready") {
            self.computer = Some(from);
            self.link = Some((self.host, u16::from_le_bytes([*low, *high])).into());
            return Ok(true);
        }
        if let Some(answer) = Answer::read(&buffer[..length]) {
            take(answer);
        }
        Ok(true)
    }
}

/// Words of an answer before inputs and outputs: period, count, station.
const HEAD: usize = 3;

/// Returns the number of a station: its address above its port. An IPv6 address has no number.
pub fn station(address: SocketAddr) -> Option<u64> {
    let SocketAddr::V4(address) = address else { return None };
    Some(u64::from(address.ip().to_bits()) << 16 | u64::from(address.port()))
}

/// Answer of the computer.
#[derive(Clone, Debug)]
pub struct Answer {
    /// The period's number.
    pub number: u64,
    /// Number of periods since the software began.
    pub count: u64,
    /// Number of the station to which a packet went down; 0 if no packet did.
    pub station: u64,
    /// The packet from the ground that the software received in this period.
    pub uplink: Packet,
    /// Packets that its gate has rejected.
    pub refused: Refused,
    /// Outputs of the software.
    pub outputs: Outputs,
}

impl Answer {
    /// Parses an answer; `None` if the datagram is not one.
    pub fn read(datagram: &[u8]) -> Option<Self> {
        let all: Vec<u64> = datagram
            .chunks_exact(8)
            .map(|eight| u64::from_le_bytes(eight.try_into().unwrap_or_default()))
            .collect();
        let (packet, refused) = (words(&Packet::none()).len(), words(&Refused::default()).len());
        let expected = HEAD + packet + refused + words(&Outputs::default()).len();
        if datagram.len() != 8 * expected {
            return None;
        }
        let (head, rest) = all.split_at(HEAD);
        let (uplink, rest) = rest.split_at(packet);
        let (kept, outputs) = rest.split_at(refused);
        Some(Self {
            number: head[0],
            count: head[1],
            station: head[2],
            uplink: value(uplink),
            refused: value(kept),
            outputs: value(outputs),
        })
    }
}

/// Words as bytes, least significant byte first.
pub fn bytes(words: &[u64]) -> Vec<u8> {
    words.iter().flat_map(|word| word.to_le_bytes()).collect()
}

/// A force limited to plausible values for an aircraft of this size, N; 0 if it is not a number.
fn bounded(force: f64) -> f64 {
    if force.is_finite() { force.clamp(-WIND, WIND) } else { 0.0 }
}
