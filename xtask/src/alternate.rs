//! The tests that take longest, of which a run takes half: those of its turn. `--full` takes all.
//!
//! Each of them tests a whole once more in another way: other layouts of the C, other sizes, another package. The
//! corpus on each leg and its golden files, by which most errors show first, are in each run.
//!
//! It must not know the subject of a test.

/// Titles of the tests of an even turn, and of those of an odd one; a run of either takes about as long.
pub const TESTS: [&[&str]; 2] = [
    &[
        "bessemer-tests/all::command::a_new_package_is_simulated_and_generated",
        "bessemer-tests/all::corpus::the_c_agrees_in_every_layout",
        "bessemer-tests/all::corpus::what_was_proved_holds",
        "bessemer-tests/all::linear::the_c_agrees",
        "bessemer-tests/all::stability::only_what_must_move_moves",
    ],
    &[
        "bessemer-tests/all::corpus::eva::what_was_left_out_cannot_fail",
        "bessemer-tests/all::corpus::guards::initialised_variables_change_no_bits",
        "bessemer-tests/all::edges::every_operation_at_every_edge",
        "bessemer-tests/all::examples::a_drive_in_single_precision_keeps_its_bits_and_its_limits",
        "bessemer-tests/all::firmware::two_versions_stand_in_one_firmware",
        "bessemer-tests/all::large::the_c_agrees",
        "bessemer-tests/all::plain::every_leg_agrees",
        "xtask/installed::whichever_modules_of_python_are_there",
    ],
];

/// Returns true unless a test is one of the other turn.
#[must_use]
pub fn is_due(title: &str, turn: u32) -> bool {
    let [even, odd] = TESTS;
    let other = if turn.is_multiple_of(2) { odd } else { even };
    !other.contains(&title)
}

/// Returns how many tests a run of `turn` leaves out.
#[must_use]
pub fn left_out(turn: u32) -> usize {
    TESTS[usize::from(turn.is_multiple_of(2))].len()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_test_is_due_in_one_turn_of_two() {
        for title in TESTS.into_iter().flatten() {
            assert!(is_due(title, 6) != is_due(title, 7), "{title}");
        }
        assert!(is_due("another", 6) && is_due("another", 7));
        let left = |turn| TESTS.into_iter().flatten().filter(|it| !is_due(it, turn)).count();
        assert!((6..8).all(|turn| left(turn) == left_out(turn)));
    }
}
