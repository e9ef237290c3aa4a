//! The tests that take longest, of which a run takes a quarter: those of its turn. `--full` takes all.
//!
//! Each of them tests a whole once more in another way: other layouts of the C, other sizes, another package. The
//! corpus on each leg and its golden files, by which most errors show first, are in each run.
//!
//! It must not know the subject of a test.

/// Titles of the tests of each turn. A run of any of them takes about as long.
pub const TESTS: [&[&str]; 4] = [
    &[
        "bessemer-backend/c::kept_checks_hold",
        "bessemer-tests/all::command::a_new_package_is_simulated_and_generated",
        "bessemer-tests/all::corpus::misra::each_finding_is_of_a_rule_with_a_reason",
        "bessemer-tests/all::corpus::what_was_proved_holds",
        "bessemer-tests/all::types::every_type_is_rustcs_own",
    ],
    &[
        "bessemer-tests/all::corpus::coverage::every_node_runs_on_every_type_that_it_takes",
        "bessemer-tests/all::edges::every_operation_at_every_edge",
        "bessemer-tests/all::flight::zynq::it_flies_the_same_bits_in_real_time_and_within_its_stack",
        "bessemer-tests/all::linear::the_c_agrees",
        "bessemer-tests/all::stability::only_what_must_move_moves",
        "ground/flight::recordings::a_bare_zynq_takes_off_with_the_bits_of_this_machine",
    ],
    &[
        "bessemer-tests/all::corpus::eva::what_was_left_out_cannot_fail",
        "bessemer-tests/all::corpus::guards::initialised_variables_change_no_bits",
        "bessemer-tests/all::corpus::the_c_agrees_in_every_layout",
        "bessemer-tests/all::diagnosed::each_error_has_its_authors_terms",
        "bessemer-tests/all::firmware::two_versions_stand_in_one_firmware",
        "bessemer-tests/all::plain::every_leg_agrees",
    ],
    &[
        "bessemer-backend/c::compiles_without_a_warning",
        "bessemer-legs/programs::the_derivatives_are_those_of_the_functions",
        "bessemer-tests/all::command::templates::a_template_is_simulated_and_generated",
        "bessemer-tests/all::corpus::each_file_compiles_alone",
        "bessemer-tests/all::ends::no_loop_runs_beyond_what_was_proved",
        "bessemer-tests/all::examples::a_drive_in_single_precision_keeps_its_bits_and_its_limits",
        "bessemer-tests/all::large::the_c_agrees",
        "bessemer-tests/all::linear::the_interpreter_agrees",
        "bessemer-tests/all::linear::vectors_ask_for_no_more_than_numbers_have",
        "bessemer-tests/all::mathematics::every_elementary_function_computes_the_same_bits",
        "xtask/installed::whichever_modules_of_python_are_there",
    ],
];

/// Returns the tests of a turn.
///
/// Its number is the sum of the digits to the base of four: four runs in a row have each test once. By
/// the turn modulo four, a test that chooses one of two, three or four parts by the turn would always choose the same.
fn of(turn: u32) -> &'static [&'static str] {
    let count = TESTS.len();
    let mut rest = turn as usize;
    let mut sum = 0;
    while rest > 0 {
        sum += rest % count;
        rest /= count;
    }
    TESTS[sum % count]
}

/// Returns true unless a test is one of another turn.
#[must_use]
pub fn is_due(title: &str, turn: u32) -> bool {
    of(turn).contains(&title) || !TESTS.iter().any(|it| it.contains(&title))
}

/// Returns how many tests a run of `turn` leaves out.
#[must_use]
pub fn left_out(turn: u32) -> usize {
    TESTS.iter().map(|it| it.len()).sum::<usize>() - of(turn).len()
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    #[test]
    fn each_test_is_due_in_one_turn_of_four() {
        for title in TESTS.into_iter().flatten() {
            let due: BTreeSet<u32> =
                (0..4096).filter(|turn| is_due(title, *turn)).map(|it| it % 12).collect();
            assert_eq!(due.len(), 12, "{title} sees all choices");
            assert_eq!((8..12).filter(|turn| is_due(title, *turn)).count(), 1, "{title}");
        }
        assert!((8..12).all(|turn| is_due("another", turn)));
        let left = |turn| TESTS.into_iter().flatten().filter(|it| !is_due(it, turn)).count();
        assert!((8..12).all(|turn| left(turn) == left_out(turn)));
    }
}
