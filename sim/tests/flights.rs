//! Every flight, held to its checks; and what the simulation promises of itself.

use std::env::var_os;

use bessemer::requirement;
use bessemer_store::once;
use bessemer_words::record::{self, Recorder};
use models::{Injection, Inputs, Mode, Onboard, Outputs, Settings};
use sim::computer::{Computer, Native};
use sim::flights::{FLIGHTS, find};
use sim::ground_station::{Order, Record};
use sim::scenario::{Scenario, point};
use sim::voyage::{Voyage, fly};

/// The models, with their calls recorded for a dossier.
struct Recorded {
    native: Native,
    recorder: Recorder,
}

impl Computer for Recorded {
    fn step(&mut self, settings: &Settings, inputs: &Inputs) -> Outputs {
        self.recorder.call(|| (*settings, *inputs));
        self.native.step(settings, inputs)
    }

    fn digest(&self) -> u64 {
        self.native.digest()
    }
}

fn flown(scenario: &Scenario) -> Voyage {
    let (native, recorder) = (Native::default(), Recorder::of::<Onboard>("step"));
    fly(scenario, &mut Recorded { native, recorder })
}

#[test]
#[requirement("HLR-07", "HLR-08", "HLR-18", "HLR-23", "HLR-38")]
fn every_flight_is_as_it_should_be() {
    // A dossier needs the calls each time.
    once("every flight", &var_os(record::FOLDER), fly_them_all);
}

fn fly_them_all() {
    let mut wrong = Vec::new();
    for flight in FLIGHTS {
        let scenario = (flight.scenario)(1);
        let voyage = flown(&scenario);
        for check in (flight.checks)(&scenario, &voyage) {
            if !check.passes() {
                wrong.push(format!("{}: {check}", flight.name));
            }
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}

#[test]
#[requirement("HLR-07", "HLR-23", "HLR-38")]
fn other_seeds_do_as_well() {
    once("other seeds", &(), fly_other_seeds);
}

fn fly_other_seeds() {
    for name in ["hover", "climb", "vicon-lost", "hexacopter", "motor-failure", "gravity-49"] {
        let flight = find(name).expect("a flight");
        for seed in 2..5 {
            let scenario = Scenario { seed, ..(flight.scenario)(seed) };
            let voyage = flown(&scenario);
            for check in (flight.checks)(&scenario, &voyage) {
                assert!(check.passes(), "{name}, seed {seed}: {check}");
            }
        }
    }
}

#[test]
fn the_order_of_mistaken_coefficients_is_the_thesis() {
    once("mistaken coefficients", &(), fly_with_mistaken_coefficients);
}

fn fly_with_mistaken_coefficients() {
    let error = |name: &str| {
        let flight = find(name).expect("a flight");
        let scenario = (flight.scenario)(1);
        let hover = sim::measure::hover_speed(&scenario.airframe);
        let gain = scenario.settings.injection.most;
        flown(&scenario).command_error(60.0, 70.0, gain, hover)
    };
    let (identified, twenty, fifty) =
        (error("gravity-64"), error("coefficient-20"), error("coefficient-50"));
    assert!(identified < twenty && twenty < fifty, "{identified} {twenty} {fifty}");
}

#[test]
#[requirement("HLR-19")]
fn the_gain_of_the_feed_forward_grows_slowly() {
    let points = [point(0.0, 0.0, 0.0, 1.0, 0.0)];
    let mut scenario = Scenario::mambo(&points, 16.0, Mode::FeedForward);
    scenario.settings.injection = Injection::constant(0.5);
    scenario.order(15.0, Order::Mode(Mode::ClosedLoop));
    let moments = flown(&scenario).moments;
    let most = moments.iter().map(|it| it.outputs.gain).fold(0.0, f64::max);
    assert!(most > 0.45, "it begins at 10 s: {most}");
    let limit = 0.1 * scenario.settings.parameters.period + 1e-12;
    for pair in moments.windows(2).filter(|pair| pair[1].outputs.reference.motors) {
        let [before, after] = [0, 1].map(|n| pair[n].outputs.gain);
        assert!((after - before).abs() <= limit, "{}: {before} {after}", pair[1].time);
    }
}

#[test]
fn a_seed_is_a_flight() {
    let scenario = (find("hover").expect("a flight").scenario)(7);
    let one = flown(&Scenario { seed: 7, ..scenario.clone() });
    assert_eq!(one, flown(&Scenario { seed: 7, ..scenario.clone() }));
    assert_ne!(one, flown(&Scenario { seed: 8, ..scenario }));
}

#[test]
#[requirement("HLR-40")]
fn what_was_logged_on_board_comes_down_whole() {
    let voyage = flown(&(find("hover").expect("a flight").scenario)(1));
    assert!(voyage.records.len() > 600, "{}", voyage.records.len());
    for Record { period, values, .. } in &voyage.records {
        let outputs = &voyage.moments[*period as usize].outputs;
        assert_eq!(values[2], outputs.estimate.position.z as f32);
        assert_eq!(values[18], outputs.command.closed_loop[0] as f32);
        assert_eq!(values[35], f32::from(outputs.alarm as u8));
    }
    let every_tenth = voyage.records.windows(2).all(|pair| pair[1].period - pair[0].period == 10);
    assert!(every_tenth, "the sender keeps up with the logger");
}
