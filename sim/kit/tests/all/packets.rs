//! Packet sensors: rate, age, losses, faults and chance, each by its values.

use bessemer_sim::*;

/// A clock, whose state is the time in ticks.
#[derive(Debug)]
struct Clock;

impl Plant<1> for Clock {
    type Command = ();
    type Disturbance = ();

    fn derivative(&self, _: f64, _: &State<1>, _: &Input<(), ()>) -> State<1> {
        State::from([1.0])
    }
}

/// Measures the time, ticks, as 1, 10 and 100 times itself.
#[derive(Clone, Debug)]
struct Times {
    /// Standard deviation of the noise.
    noise: f64,
    /// Latest time at which there is something to send, ticks.
    last: f64,
    /// Number of measurements.
    count: u32,
}

const IDEAL: Times = Times { noise: 0.0, last: f64::INFINITY, count: 0 };

impl Instrument<Clock, 1, 3> for Times {
    fn measure(&mut self, view: &View<'_, Clock, 1>) -> Numbers<3> {
        self.count += 1;
        Numbers::from([1.0, 10.0, 100.0]) * view.state[0].round()
    }

    fn packet(&mut self, truth: Numbers<3>, chance: &mut Stream) -> Option<Numbers<3>> {
        let noise = chance.normals() * self.noise;
        (truth[0] <= self.last).then_some(truth + noise)
    }
}

const NAMES: [&str; 3] = ["pair", "pair", "single"];

fn delivery(period: u32, age: u32, dropout: f64) -> Delivery {
    Delivery { period: Period::ticks(period).expect("a period"), age, dropout }
}

fn sensor(instrument: Times, delivery: Delivery, seed: u64) -> PacketSensor<Times, 3> {
    PacketSensor::new(NAMES, instrument, delivery, Stream::named(seed, "times"))
}

/// Returns the fresh readings of some ticks, with the ticks at which they arrived. A tick has 1 s.
fn read(sensor: &mut PacketSensor<Times, 3>, ticks: u64, faults: &[Fault]) -> Vec<(u64, [f64; 3])> {
    let tick = Tick::nanoseconds(1_000_000_000).expect("a tick");
    let input = Input { command: (), disturbance: () };
    let integrator = Integrator::new(Solver::Euler { step: 1.0 }).expect("a step");
    let mut clock = Stepper::new(Clock, State::zeros(), input, tick, integrator);
    let mut latest = Numbers::zeros();
    let mut all = Vec::new();
    for now in 0..ticks {
        let time = clock.time();
        let reading = sensor.read(now, &clock.view(), |name| Fault::at(faults, name, time));
        if reading.is_fresh {
            latest = reading.value;
            all.push((now, latest.into()));
        }
        assert_eq!(reading.value, latest, "without a packet the reading is the latest one");
        clock.advance(1).expect("it advances");
    }
    all
}

/// Packets arrive with their period and have their age; the first ones have the numbers of the start.
#[test]
fn packets_have_a_rate_and_an_age() {
    for (period, age, arrivals, times) in [
        (1, 0, vec![0, 1, 2, 3], vec![0.0, 1.0, 2.0, 3.0]),
        (1, 2, vec![0, 1, 2, 3], vec![0.0, 0.0, 0.0, 1.0]),
        (3, 0, vec![0, 3, 6, 9], vec![0.0, 3.0, 6.0, 9.0]),
        (3, 1, vec![0, 3, 6, 9], vec![0.0, 2.0, 5.0, 8.0]),
        (3, 3, vec![0, 3, 6, 9], vec![0.0, 0.0, 3.0, 6.0]),
        (3, 7, vec![0, 3, 6, 9, 12], vec![0.0, 0.0, 0.0, 2.0, 5.0]),
        (2, 5, vec![0, 2, 4, 6, 8], vec![0.0, 0.0, 0.0, 1.0, 3.0]),
        (1, u32::MAX, vec![0, 1, 2], vec![0.0, 0.0, 0.0]),
    ] {
        let mut sensor = sensor(IDEAL, delivery(period, age, 0.0), 1);
        let ticks = arrivals.last().map_or(0, |last| last + 1);
        let expected: Vec<_> = arrivals
            .into_iter()
            .zip(times.into_iter().map(|time| [time, 10.0 * time, 100.0 * time]))
            .collect();
        assert_eq!(read(&mut sensor, ticks, &[]), expected, "period {period}, age {age}");
        // Only packets that are underway at the end are measured in vain.
        let most = expected.len() + (age / period) as usize + 1;
        assert!(sensor.instrument.count as usize <= most, "{}", sensor.instrument.count);
    }
}

/// A loop may begin at any tick, and a tick without a call costs its packet and a later one.
#[test]
fn a_loop_may_begin_late_and_skip_ticks() {
    let tick = Tick::nanoseconds(1_000_000_000).expect("a tick");
    let input = Input { command: (), disturbance: () };
    for first in [0_u64, 1_000, u64::MAX - 9] {
        let start = Clock;
        let mut clock = Stepper::new(start, State::zeros(), input, tick, Integrator::default());
        let mut sensor = sensor(IDEAL, delivery(1, 2, 0.0), 1);
        let mut arrived = Vec::new();
        for n in 0..8 {
            if n != 4 {
                let reading = sensor.read(first + n, &clock.view(), |_| None);
                arrived.extend(reading.is_fresh.then_some((n, reading.value[0])));
            }
            clock.advance(1).expect("it advances");
        }
        // Its sample is due at tick 6.
        let expected = [(0, 0.0), (1, 0.0), (2, 0.0), (3, 1.0), (5, 3.0), (7, 5.0)];
        assert_eq!(arrived, expected, "from {first} on");
    }
}

/// A fault changes the numbers of its sensor, and an outage of one sensor takes the packet.
#[test]
fn faults_act_on_the_numbers_of_their_sensor() {
    let fault = |sensor: &str, from, until, kind| {
        let sensor = sensor.to_owned();
        Fault { sensor, from, until, kind }
    };
    let silent = |name| fault(name, 2.0, 5.0, FaultKind::Silent);
    let stuck = |name| fault(name, 2.0, 5.0, FaultKind::Stuck);
    type Arrived = fn(f64) -> Option<[f64; 3]>;
    let cases: [(&str, Vec<Fault>, Arrived); 9] = [
        ("no fault", vec![], |_| None),
        ("fault of another", vec![silent("other")], |_| None),
        ("outage", vec![silent("single")], |_| Some([f64::NAN; 3])),
        ("outage of two", vec![silent("pair")], |_| Some([f64::NAN; 3])),
        ("stuck", vec![stuck("single")], |t| Some([t, 10.0 * t, 100.0])),
        ("both stuck", vec![stuck("single"), stuck("pair")], |_| Some([1.0, 10.0, 100.0])),
        ("offset", vec![fault("pair", 2.0, 5.0, FaultKind::Offset(-0.5))], |t| {
            Some([t - 0.5, 10.0 * t - 0.5, 100.0 * t])
        }),
        ("drift", vec![fault("single", 2.0, 5.0, FaultKind::Drift(2.0))], |t| {
            Some([t, 10.0 * t, 100.0 * t + 2.0 * (t - 2.0)])
        }),
        ("the first of two", vec![stuck("pair"), silent("pair")], |t| Some([1.0, 10.0, 100.0 * t])),
    ];
    for (name, faults, during) in cases {
        let mut expected = Vec::new();
        for now in 0..10_u64 {
            let time = now as f64;
            let usual = [time, 10.0 * time, 100.0 * time];
            let packet = if (2..5).contains(&now) { during(time).unwrap_or(usual) } else { usual };
            expected.extend((!packet[0].is_nan()).then_some((now, packet)));
        }
        let mut sensor = sensor(IDEAL, delivery(1, 0, 0.0), 1);
        assert_eq!(read(&mut sensor, 10, &faults), expected, "{name}");
    }
}

/// A sensor that is stuck from the start on repeats zeros; one that is stuck behind an outage repeats what arrived before it.
#[test]
fn a_stuck_sensor_repeats_what_arrived() {
    let fault = |from, until, kind| Fault { sensor: "pair".to_owned(), from, until, kind };
    let mut late = sensor(IDEAL, delivery(1, 2, 0.0), 1);
    let faults = [fault(4.0, 6.0, FaultKind::Silent), fault(6.0, f64::INFINITY, FaultKind::Stuck)];
    let arrived: Vec<_> = read(&mut late, 8, &faults).into_iter().skip(3).collect();
    assert_eq!(
        arrived,
        [(3, [1.0, 10.0, 100.0]), (6, [1.0, 10.0, 400.0]), (7, [1.0, 10.0, 500.0])]
    );
    let mut sensor = sensor(IDEAL, delivery(2, 0, 0.0), 1);
    let always = [fault(0.0, f64::INFINITY, FaultKind::Stuck)];
    assert_eq!(read(&mut sensor, 3, &always), [(0, [0.0; 3]), (2, [0.0, 0.0, 200.0])]);
}

/// A loss takes all numbers of a packet, is as frequent as its probability, and moves no other packet.
#[test]
fn a_lost_packet_is_lost_whole() {
    let count = 20_000_u32;
    let mut sensor = sensor(IDEAL, delivery(1, 3, 0.2), 5);
    let arrived = read(&mut sensor, count.into(), &[]);
    for (now, numbers) in &arrived {
        let time = now.saturating_sub(3) as f64;
        assert_eq!(*numbers, [time, 10.0 * time, 100.0 * time]);
    }
    let share = arrived.len() as f64 / f64::from(count);
    assert!((share - 0.8).abs() < 5.0 * (0.16 / f64::from(count)).sqrt(), "{share}");
}

/// An instrument with nothing to send sends nothing, and its sensor keeps its reading.
#[test]
fn an_instrument_may_send_nothing() {
    let mut sensor = sensor(Times { last: 2.0, ..IDEAL }, delivery(1, 0, 0.0), 1);
    let arrived: Vec<u64> = read(&mut sensor, 9, &[]).into_iter().map(|(now, _)| now).collect();
    assert_eq!(arrived, [0, 1, 2]);
}

/// Equal seeds have equal readings, and other seeds others; what another sensor draws, and an outage, change none.
#[test]
fn chance_is_by_seed_and_sensor() {
    let noisy = |seed| sensor(Times { noise: 1.0, ..IDEAL }, delivery(2, 1, 0.3), seed);
    let alone = read(&mut noisy(7), 200, &[]);
    assert_eq!(read(&mut noisy(7), 200, &[]), alone);
    assert_ne!(read(&mut noisy(8), 200, &[]), alone);

    let tick = Tick::nanoseconds(1_000_000_000).expect("a tick");
    let input = Input { command: (), disturbance: () };
    let mut clock = Stepper::new(Clock, State::zeros(), input, tick, Integrator::default());
    let chance = Stream::named(7, "other");
    let other = Times { noise: 1.0, ..IDEAL };
    let mut other = PacketSensor::new(["other"; 3], other, delivery(1, 0, 0.5), chance);
    let mut sensor = noisy(7);
    let mut beside = Vec::new();
    for now in 0..200 {
        other.read(now, &clock.view(), |_| None);
        let reading = sensor.read(now, &clock.view(), |_| None);
        if reading.is_fresh {
            beside.push((now, reading.value.into()));
        }
        clock.advance(1).expect("it advances");
    }
    assert_eq!(beside, alone);

    // A silent sensor draws nothing: behind its outage it has the errors that it would have had in it.
    let outage =
        Fault { sensor: "single".to_owned(), from: 0.0, until: 20.0, kind: FaultKind::Silent };
    let errors = |readings: &[(u64, [f64; 3])]| -> Vec<[f64; 3]> {
        let truth = |now: u64, scale: f64| now.saturating_sub(1) as f64 * scale;
        let scales = [1.0, 10.0, 100.0];
        let error = |(now, numbers): &(u64, [f64; 3])| {
            std::array::from_fn(|n| ((numbers[n] - truth(*now, scales[n])) * 1e6).round())
        };
        readings.iter().map(error).collect()
    };
    let later = read(&mut noisy(7), 220, &[outage]);
    assert_eq!(errors(&later), errors(&alone));
}
