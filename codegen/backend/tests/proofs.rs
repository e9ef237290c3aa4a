//! The proofs hold: small functions in which a check must not be left out, and beside them others in which it
//! may. Each is run on every combination of its arguments' edges, before and after the passes.

use bessemer_backend::passes::{Choices, Rule, check, explicit, explicit_with};
use bessemer_backend::validate::validate;
use bessemer_interpret::{Interpreter, Stop};
use bessemer_ir::text::parse;
use bessemer_ir::visit::{VisitMut, walk_stmt_mut};
use bessemer_ir::{Fault, Float, FunctionId, Int, Module, Scalar, Stmt, StmtKind, Type};

/// Enums that are numbered otherwise than from 0 upwards, and some constants.
const HEAD: &str = "module demo

enum Trim in demo { Down = -1, Level = 0, Up = 1 }
enum Kind in demo { A = 10, B = 20, C = 30 }
enum Gear in demo { First, Second, Third }
";

fn module(functions: &str) -> Module {
    let text = format!("{HEAD}\n{functions}\n");
    let module = parse(&text).unwrap_or_else(|error| panic!("{error}\n{text}"));
    assert_eq!(validate(&module), Ok(()), "{text}");
    module
}

/// Tells the faults of checks from those of operations.
struct Mark;

impl VisitMut for Mark {
    fn stmt(&mut self, stmt: &mut Stmt) {
        if matches!(stmt.kind, StmtKind::Check { .. }) {
            stmt.span.file = 1;
        }
        walk_stmt_mut(self, stmt);
    }
}

/// Words that a proof could be wrong about.
fn words(module: &Module, ty: &Type) -> Vec<u64> {
    match ty {
        Type::Scalar(Scalar::Bool) => vec![0, 1],
        &Type::Scalar(Scalar::Int(int)) => {
            let near = (-3..=12).chain([30, 31, 32]);
            let ends = [int.min(), int.min() + 1, int.max() - 1, int.max()];
            let mut all: Vec<i128> =
                near.chain(ends).filter(|it| (int.min()..=int.max()).contains(it)).collect();
            all.sort_unstable();
            all.dedup();
            all.into_iter().map(|value| word(int, value)).collect()
        }
        Type::Enum(id) => (0..module.enums[id.index()].variants.len() as u64).collect(),
        Type::Scalar(Scalar::Float(Float::F64)) => {
            let ends = [0.0, -0.0, 1.0, -1.0, 6.5, 7.0, 8.0, f64::MAX, f64::INFINITY];
            let near =
                [7.0_f64.next_down(), 7.0_f64.next_up(), f64::MIN, f64::NEG_INFINITY, f64::NAN];
            ends.into_iter().chain(near).map(f64::to_bits).collect()
        }
        _ => vec![0],
    }
}

fn word(int: Int, value: i128) -> u64 {
    if int.signed() { value as i64 as u64 } else { value as u64 }
}

/// Every combination for words, one value for what has parts.
fn arguments(module: &Module, function: usize) -> Vec<Vec<Vec<u64>>> {
    let mut all = vec![Vec::new()];
    for parameter in module.functions[function].parameters() {
        let choices: Vec<Vec<u64>> = if parameter.ty.is_word() {
            words(module, &parameter.ty).into_iter().map(|word| vec![word]).collect()
        } else {
            vec![(0..module.width(&parameter.ty) as u64).collect()]
        };
        let longer = |begun: &Vec<Vec<u64>>| {
            let begun = begun.clone();
            choices
                .iter()
                .map(move |choice| [begun.clone(), vec![choice.clone()]].concat())
                .collect::<Vec<_>>()
        };
        all = all.iter().flat_map(longer).collect();
    }
    all
}

/// Takes every check for one that was proved.
struct LeaveOut;

impl VisitMut for LeaveOut {
    fn stmt(&mut self, stmt: &mut Stmt) {
        if let StmtKind::Check { fault, .. } = &mut stmt.kind {
            *fault = Fault::LeftOut;
        }
        walk_stmt_mut(self, stmt);
    }
}

/// Returns true if the verifier believes that the functions need no check at all.
fn believed(functions: &str) -> bool {
    let mut module = module(functions);
    module.functions.iter_mut().for_each(|function| LeaveOut.block(&mut function.body));
    !check(&module).iter().any(|problem| problem.rule == Rule::Unchecked)
}

/// Runs the last function before and after the passes: the same outcome, and no fault but a check's.
fn holds(functions: &str) -> bool {
    let before = module(functions);
    let last = before.functions.len() - 1;
    // The claim is looked at; the checks, if it is refused, without it.
    let mut free = before.clone();
    free.functions[last].role = bessemer_ir::Role::Entry { infallible: false };
    let (kept, _) = explicit_with(free.clone(), Choices::KEPT).expect("explicit");
    let (after, report) = explicit(free).expect("explicit");
    assert_eq!(report.doubted.concat(), [], "{functions}: what the analysis alone believes");
    assert_eq!(check(&after), [], "{functions}");
    let mut marked = after.clone();
    marked.functions.iter_mut().for_each(|function| Mark.block(&mut function.body));
    let (mut first, mut second) = (Interpreter::new(&before), Interpreter::new(&marked));
    let mut third = Interpreter::new(&kept);
    for given in arguments(&before, last) {
        let (mut one, mut other) = (given.clone(), given.clone());
        let id = FunctionId(last as u32);
        let (expected, found) = (first.call(id, &mut one), second.call(id, &mut other));
        match (&expected, &found) {
            (Ok(expected), Ok(found)) => assert_eq!(expected, found, "{functions}\n{given:?}"),
            (
                Err(Stop::Fault { fault: expected, .. }),
                Err(Stop::Fault { fault: found, span, .. }),
            ) => {
                assert_eq!(expected, found, "{functions}\n{given:?}");
                assert_eq!(span.file, 1, "{functions}\n{given:?}: an operation faulted");
            }
            _ => panic!("{functions}\n{given:?}: {expected:?} became {found:?}"),
        }
        assert_eq!(one, other, "{functions}\n{given:?}: what was lent");
        let told = |outcome: &Result<Vec<u64>, Stop>| match outcome {
            Err(Stop::Fault { fault, .. }) => Err(*fault),
            other => Ok(other.clone().ok()),
        };
        let proved = third.call(id, &mut given.clone());
        assert_eq!(told(&expected), told(&proved), "{functions}\n{given:?}: what was proved");
    }
    explicit(before).is_ok()
}

macro_rules! functions {
    ($($expected:ident: $($name:ident),+ $(,)?);+ $(;)?) => {$($(
        #[test]
        fn $name() {
            let text = include_str!(concat!("proofs/", stringify!($name), ".ir"));
            let expected = stringify!($expected) == "proved";
            assert_eq!(holds(text), expected, "the claim");
            // Nobody tells the verifier of the claim. Where enums come from outside, it needs what the passes add.
            assert!(expected || !believed(text), "the verifier believes what is wrong");
        }
    )+)+};
}

functions! {
    refused:
        number_as_index, number_as_divisor, assertion_of_a_number, arm_of_a_number,
        index_beyond_a_moving_bound, index_behind_another_condition, shift_beyond_a_moving_bound,
        divisor_at_the_first_pass, count_behind_a_loop, count_in_a_loop_of_too_many,
        count_in_loops_in_loops_of_too_many, one_more_than_a_length, two_more_than_a_length,
        below_another_length, condition_beside_a_loop, condition_before_a_write,
        condition_before_a_call, condition_before_a_call_of_a_slice, condition_before_a_loop_that_lends,
        given_beyond_in_a_loop, given_where_a_loop_is_left, fields_of_another, length_itself,
        returned_early_beyond, returned_late_beyond, returned_in_fields_of_some,
        returned_by_the_firmware, read_twice_from_the_firmware,
        condition_that_writes, returned_behind_a_condition_that_writes,
        returned_as_the_firmware_gave_it, called_and_never_returned,
        divisor_of_a_narrower_type, left_beyond_a_bound, clamped_float_beyond,
        smaller_float_without_a_largest, divisor_from_a_float, moved_on_in_a_loop, moved_up_in_a_loop,
        sum_of_too_many_signed_numbers, moved_up_and_back_before_a_continue_beyond,
        zeros_of_a_number_beyond, float_between_numbers_beyond, float_not_below_a_number,
        rest_of_a_length_beyond,
        search_by_halves_beyond, search_by_wholes_beyond, search_between_ends_beyond,
        search_in_a_slice_beyond, width_of_numbers_beyond, width_of_nothing_beyond,
        order_where_a_loop_is_left, order_moved_twice_in_a_pass, greater_of_two_paths,
        alternative_that_may_fail, sum_beyond_a_length,
        width_of_signed_numbers_beyond, search_by_a_difference_beyond, list_filled_in_a_loop_beyond,
        end_of_a_part_beyond, start_of_a_clamped_part_beyond,
        count_of_a_rest_beyond, count_of_a_moved_rest_beyond, excluded_alternative_beyond, excluded_before_a_write_beyond,
        middle_of_signed_numbers, middle_of_numbers, field_that_wraps_in_a_loop, moved_beside_a_field_that_wraps;
    proved:
        sum_of_signed_numbers, moved_up_and_back_before_a_continue, zeros_of_a_number,
        float_in_a_local, float_between_numbers, zero_of_either_sign, rest_of_a_length,
        lengths_alike, smaller_of_two_lengths,
        index_of_a_number, number_above, bound_that_moves_by_one, counted_to_a_bound, counted_down,
        counted_to_a_length, index_of_a_variant, count_within_behind_a_loop, count_in_a_loop,
        count_in_loops_in_loops, below_a_length, one_more_below_a_length, last_of_a_loop_backwards,
        last_arm_of_an_enum, given_in_a_loop, given_in_fields, last_of_a_slice,
        returned_index, returned_in_fields, returned_by_what_it_calls,
        returned_always_some, divisor_of_another_type, left_within_a_bound, clamped_float,
        share_of_a_table, length_below_another,
        moved_back_in_a_loop,
        search_by_halves, search_between_ends, search_in_a_slice, width_of_numbers,
        width_by_larger_and_smaller, order_moved_in_a_pass, lesser_of_two_paths,
        alternative_that_fails, excluded_alternative, excluded_by_the_second,
        count_of_a_rest, end_of_a_part, start_of_a_clamped_part, sum_below_a_length,
        width_of_signed_numbers, middle_of_ordered_numbers, search_by_a_difference, list_filled_in_a_loop;
}
