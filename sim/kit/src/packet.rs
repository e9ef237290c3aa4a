//! Packet sensors: several numbers that are sampled, late and lost together, such as those of an inertial unit.
//!
//! For a loop of your own. A packet sensor knows the plant and neither a scenario nor who uses its readings: the loop says
//! which fault a sensor has. Its chance is a [`Stream`] of its own, so another sensor changes no number of it.
//!
//! A receiver that measures position and speed ten times a second, 0.2 s late, and loses a tenth of its packets:
//!
//! ```
//! use bessemer_sim::*;
//!
//! /// A cart without a drive. Its states are the position, m, and the speed, m/s.
//! #[derive(Debug)]
//! struct Cart;
//!
//! impl Plant<2> for Cart {
//!     type Command = ();
//!     type Disturbance = ();
//!
//!     fn derivative(&self, _: f64, state: &State<2>, _: &Input<(), ()>) -> State<2> {
//!         State::from([state[1], 0.0])
//!     }
//! }
//!
//! struct Receiver;
//!
//! impl Instrument<Cart, 2, 2> for Receiver {
//!     fn measure(&mut self, view: &View<Cart, 2>) -> Numbers<2> {
//!         *view.state
//!     }
//!
//!     fn packet(&mut self, truth: Numbers<2>, chance: &mut Stream) -> Option<Numbers<2>> {
//!         Some(truth + chance.normals::<2>().component_mul(&Numbers::from([1.0, 0.1])))
//!     }
//! }
//!
//! let tick = Tick::nanoseconds(10_000_000)?;
//! let input = Input { command: (), disturbance: () };
//! let mut cart = Stepper::new(Cart, State::from([0.0, 3.0]), input, tick, Integrator::default());
//! let delivery = Delivery { period: Period::ticks(10)?, age: 20, dropout: 0.1 };
//! let chance = Stream::named(7, "receiver");
//! let mut receiver = PacketSensor::new(["receiver"; 2], Receiver, delivery, chance);
//! let outage = Fault { sensor: "receiver".to_owned(), from: 40.0, until: 50.0, kind: FaultKind::Silent };
//! let mut arrived = 0;
//! for now in 0..6_000 {
//!     let time = cart.time();
//!     let fault = |sensor: &str| Fault::at(std::slice::from_ref(&outage), sensor, time);
//!     let Reading { value, is_fresh } = receiver.read(now, &cart.view(), fault);
//!     if is_fresh {
//!         arrived += 1;
//!         let [position, speed] = value.into();
//!         assert!((position - 3.0 * (time - 0.2).max(0.0)).abs() < 5.0 && (speed - 3.0).abs() < 0.5);
//!     }
//!     cart.advance(1)?;
//! }
//! assert!((420..=480).contains(&arrived), "of 500 outside the outage");
//! # Ok::<(), Error>(())
//! ```

use std::collections::VecDeque;

use nalgebra::SVector;

use crate::clock::Period;
use crate::noise::Stream;
use crate::plant::{Plant, View};
use crate::scenario::FaultKind;
use crate::sensor::Reading;

/// M numbers of a packet, each in a unit of its own.
pub type Numbers<const M: usize> = SVector<f64, M>;

/// Numbers that a packet sensor measures of a plant P with N states, and their errors.
pub trait Instrument<P: Plant<N>, const N: usize, const M: usize> {
    /// Returns the true numbers, each in its unit, when the sensor samples them.
    fn measure(&mut self, view: &View<'_, P, N>) -> Numbers<M>;

    /// Returns the numbers that arrive in place of the true ones; `None` if the sensor has nothing to send.
    ///
    /// It is called when the packet is due, but not if that is lost or the sensor is silent. Noise, bias, outliers and
    /// resolution are made here; the numbers of chance are drawn in your order.
    fn packet(&mut self, truth: Numbers<M>, chance: &mut Stream) -> Option<Numbers<M>>;
}

/// Rate, age and losses of packets.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Delivery {
    /// Period with which packets arrive.
    pub period: Period,
    /// Age of the numbers when their packet arrives, in ticks. The first packets, which would be older than the run, have
    /// the numbers of its start.
    pub age: u32,
    /// Probability that a packet is lost, 0 to 1. Only if it is above 0, it draws a number for each packet.
    pub dropout: f64,
}

/// A sensor whose readings are packets of M numbers, of an [`Instrument`] I.
#[derive(Clone, Debug)]
pub struct PacketSensor<I, const M: usize> {
    /// The instrument.
    pub instrument: I,
    delivery: Delivery,
    chance: Stream,
    sensors: Vec<Part>,
    /// Numbers of the first call, and the last tick at which they arrive.
    start: Option<(u64, Numbers<M>)>,
    /// True numbers that were sampled and have not arrived, each with the tick of its arrival, in order.
    underway: VecDeque<(u64, Numbers<M>)>,
    last: Numbers<M>,
}

/// A sensor in a packet.
#[derive(Clone, Debug)]
struct Part {
    name: String,
    /// Number behind the last one of the sensor.
    end: usize,
    /// Fault of the sensor when the last packet was due.
    fault: Option<FaultKind>,
}

impl<I, const M: usize> PacketSensor<I, M> {
    /// Creates a sensor. `names` has the name of the sensor that measures each number, by which faults find it: one name, or
    /// several for a packet of several sensors that can fail alone.
    pub fn new(names: [&str; M], instrument: I, delivery: Delivery, chance: Stream) -> Self {
        let mut sensors: Vec<Part> = Vec::new();
        for (name, end) in names.into_iter().zip(1..) {
            match sensors.last_mut() {
                Some(last) if last.name == name => last.end = end,
                _ => sensors.push(Part { name: name.to_owned(), end, fault: None }),
            }
        }
        let (start, underway, last) = (None, VecDeque::new(), Numbers::zeros());
        Self { instrument, delivery, chance, sensors, start, underway, last }
    }

    /// Returns the reading at a tick: fresh if a packet arrives. Call it once at each tick of your loop.
    ///
    /// `fault` returns the present fault of a sensor by its name; [`Fault::at`](crate::Fault::at) looks it up in a list. A silent
    /// sensor's whole packet is not sent. A stuck one repeats its numbers of the last packet that arrived, and an offset is added to each
    /// of its numbers; of a [`Drift`](FaultKind::Drift) this needs the offset at that time, as `Fault::at` returns it.
    pub fn read<P: Plant<N>, const N: usize>(
        &mut self,
        now: u64,
        view: &View<'_, P, N>,
        fault: impl Fn(&str) -> Option<FaultKind>,
    ) -> Reading<Numbers<M>>
    where
        I: Instrument<P, N, M>,
    {
        self.read_truth(now, |instrument| instrument.measure(view), fault)
    }

    /// Returns the reading at a tick as [`read`](PacketSensor::read) does, of true numbers that the loop has computed already. `truth` is called when the sensor samples them.
    pub fn read_truth<P: Plant<N>, const N: usize>(
        &mut self,
        now: u64,
        truth: impl FnOnce(&mut I) -> Numbers<M>,
        fault: impl Fn(&str) -> Option<FaultKind>,
    ) -> Reading<Numbers<M>>
    where
        I: Instrument<P, N, M>,
    {
        let Delivery { period, age, .. } = self.delivery;
        let arrival = now.saturating_add(age.into());
        let is_sampled = period.is_due(arrival);
        if is_sampled || self.start.is_none() {
            let truth = truth(&mut self.instrument);
            self.start.get_or_insert((arrival, truth));
            self.underway.extend(is_sampled.then_some((arrival, truth)));
        }
        let arrives = period.is_due(now).then(|| self.arrived(now)).flatten();
        let packet = arrives.and_then(|truth| self.packet(truth, fault));
        self.last = packet.unwrap_or(self.last);
        Reading { value: self.last, is_fresh: packet.is_some() }
    }

    /// Returns the true numbers that are due at a tick.
    fn arrived(&mut self, now: u64) -> Option<Numbers<M>> {
        let mut due = self.start.filter(|(until, _)| now <= *until);
        while let Some(sampled) = self.underway.pop_front_if(|(arrival, _)| *arrival <= now) {
            due = Some(sampled);
        }
        due.map(|(_, truth)| truth)
    }

    /// Returns the packet that arrives of true numbers; `None` if none does.
    fn packet<P: Plant<N>, const N: usize>(
        &mut self,
        truth: Numbers<M>,
        fault: impl Fn(&str) -> Option<FaultKind>,
    ) -> Option<Numbers<M>>
    where
        I: Instrument<P, N, M>,
    {
        let Self { instrument, delivery, chance, sensors, last, .. } = self;
        sensors.iter_mut().for_each(|sensor| sensor.fault = fault(&sensor.name));
        if sensors.iter().any(|sensor| sensor.fault == Some(FaultKind::Silent)) {
            return None;
        }
        if delivery.dropout > 0.0 && chance.happens(delivery.dropout) {
            return None;
        }
        let mut packet = instrument.packet(truth, chance)?;
        let mut begin = 0;
        for sensor in sensors {
            let range = begin..sensor.end;
            let numbers = &mut packet.as_mut_slice()[range.clone()];
            match sensor.fault {
                Some(FaultKind::Stuck) => {
                    numbers.copy_from_slice(&last.as_slice()[range]);
                }
                Some(FaultKind::Offset(offset)) => {
                    numbers.iter_mut().for_each(|number| *number += offset);
                }
                Some(FaultKind::Silent | FaultKind::Drift(_)) | None => {}
            }
            begin = sensor.end;
        }
        Some(packet)
    }
}
