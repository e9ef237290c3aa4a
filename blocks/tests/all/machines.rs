//! Blocks with states that can be compared with a plain model: contacts, timers, votes, queues and schedules.

use std::collections::VecDeque;

use bessemer_blocks::*;
use proptest::prelude::*;

fn flags() -> impl Strategy<Value = Vec<bool>> {
    prop::collection::vec(any::<bool>(), 1..60)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(128))]

    #[test]
    fn a_contact_follows_what_lasts(contacts in flags(), periods in 0_u32..5) {
        let (mut debounce, mut level) = (Debounce::default(), false);
        for end in 1..=contacts.len() {
            let contact = debounce.step(periods, contacts[end - 1]);
            let last = &contacts[end.saturating_sub(periods.max(1) as usize)..end];
            let lasts = last.len() == periods.max(1) as usize && last.iter().all(|it| *it != level);
            prop_assert_eq!(contact.rose, lasts && !level);
            prop_assert_eq!(contact.fell, lasts && level);
            level ^= lasts;
            prop_assert_eq!(contact.is_on, level);
        }
    }

    #[test]
    fn a_timer_counts_what_lasts(waits in flags(), periods in 0_u32..5) {
        let mut timer = Timer::default();
        for end in 1..=waits.len() {
            let lasted = waits[..end].iter().rev().take_while(|it| **it).count() as u32;
            prop_assert_eq!(timer.step(periods, waits[end - 1]), lasted > 0 && lasted >= periods);
            prop_assert_eq!(timer.elapsed(), lasted);
        }
    }

    #[test]
    fn a_watchdog_trips_once_and_for_all(signs in flags(), periods in 0_u32..5) {
        let (mut watchdog, mut silent, mut tripped) = (Watchdog::default(), 0, false);
        for sign in signs {
            silent = if sign { 0 } else { silent + 1 };
            tripped |= silent > periods;
            prop_assert_eq!(watchdog.step(periods, sign), tripped);
        }
        watchdog.reset();
        prop_assert!(!watchdog.step(periods, true));
    }

    #[test]
    fn a_median_is_the_second_of_three(a in -9.0..9.0, b in -9.0..9.0, c in -9.0..9.0) {
        let mut sorted = [a, b, c];
        sorted.sort_by(f64::total_cmp);
        prop_assert_eq!(median(a, b, c), sorted[1]);
        prop_assert!([a, b].contains(&median(a, b, f64::NAN)));
    }

    /// One sensor fails in any way: the vote stays within the tolerance of the others.
    #[test]
    fn a_vote_survives_one_sensor(
        faults in prop::collection::vec(prop_oneof![Just(f64::NAN), Just(f64::INFINITY), any::<f64>()], 1..40),
        which in 0_usize..3, value in -9.0..9.0,
    ) {
        let (mut voter, limits) = (Voter::default(), VoterLimits { tolerance: 0.5, periods: 3 });
        for fault in faults {
            let mut sensors = [value, value + 0.1, value - 0.1];
            sensors[which] = fault;
            let vote = voter.step(&limits, sensors);
            prop_assert!((vote.value - value).abs() <= 0.2 + 1e-9 && vote.good >= 2);
        }
    }

    #[test]
    fn a_ring_is_a_queue(commands in prop::collection::vec(prop::option::of(any::<u16>()), 1..80)) {
        let (mut ring, mut queue) = (RingBuffer::<u16, 3>::default(), VecDeque::new());
        for command in commands {
            match command {
                Some(value) => {
                    let is_full = queue.len() == 3;
                    if is_full {
                        queue.pop_front();
                    }
                    queue.push_back(value);
                    prop_assert_eq!(ring.push(value), !is_full);
                }
                None => prop_assert_eq!(ring.pop(), queue.pop_front()),
            }
            prop_assert_eq!((ring.len() as usize, ring.is_empty()), (queue.len(), queue.is_empty()));
        }
    }

    #[test]
    fn tasks_run_at_their_rates(shapes in prop::array::uniform3((1_u32..8, 0_u32..8))) {
        let task = |(period, phase)| Task { period, phase: phase % period, cost: 1 };
        let schedule = Schedule { tasks: shapes.map(task) };
        let mut rates = Rates::<3>::default();
        let mut heaviest = 0;
        // Runs of tasks, in the order in which they are executed.
        let mut runs = Vec::new();
        for step in 0..840 {
            let due = rates.step(&schedule);
            runs.extend((0..3).filter(|k| due[*k]));
            for (due, task) in due.iter().zip(&schedule.tasks) {
                prop_assert_eq!(*due, step % task.period == task.phase);
            }
            heaviest = heaviest.max(due.iter().filter(|due| **due).count());
        }
        prop_assert_eq!(schedule.heaviest(), heaviest as u64);
        let first = |task: usize| runs.iter().position(|run| *run == task);
        for pair @ [from, to] in [[0, 1], [0, 2], [1, 2]] {
            prop_assert_eq!(schedule.flows(&[pair]), first(from) < first(to));
            prop_assert!(!schedule.flows(&[[to, from]]));
        }
        prop_assert!(schedule.flows(&[]) && !schedule.flows(&[[0, 3]]));
    }
}

#[test]
fn a_vote_of_two_that_differ_is_doubtful() {
    let (mut voter, limits) = (Voter::default(), VoterLimits { tolerance: 0.5, periods: 1 });
    voter.step(&limits, [1.0, 1.0, 9.0]);
    let vote = voter.step(&limits, [1.0, 4.0, 9.0]);
    assert_eq!((vote.value, vote.good, vote.is_doubtful), (2.5, 2, true));
    // One of them is broken for certain.
    let vote = voter.step(&limits, [1.0, f64::NAN, 9.0]);
    assert_eq!((vote.value, vote.good, vote.is_doubtful), (1.0, 1, false));
    // None is left: the last value stays.
    let vote = voter.step(&limits, [f64::NAN, f64::NAN, 9.0]);
    assert_eq!((vote.value, vote.good), (1.0, 0));
    voter.reset();
    assert_eq!(voter.step(&limits, [9.0; 3]).good, 3);
}

#[test]
fn a_machine_runs_its_actions_in_order() {
    /// Records calls.
    struct Recorder(Vec<String>);

    impl Actions<u8> for Recorder {
        fn next(&mut self, state: u8, periods: u32) -> u8 {
            if periods == 2 { state + 1 } else { state }
        }

        fn during(&mut self, state: u8) {
            self.0.push(format!("during {state}"));
        }

        fn enter(&mut self, state: u8) {
            self.0.push(format!("enter {state}"));
        }

        fn exit(&mut self, state: u8) {
            self.0.push(format!("exit {state}"));
        }
    }

    let (mut machine, mut recorder) = (Machine::<u8>::default(), Recorder(Vec::new()));
    assert_eq!([0; 4].map(|_| machine.step(&mut recorder)), [0, 0, 1, 1]);
    let expected = "enter 0,during 0,during 0,exit 0,enter 1,during 1,during 1";
    assert_eq!(recorder.0.join(","), expected);
}
