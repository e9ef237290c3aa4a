//! Temporaries put back: small functions by what becomes of them, and random ones by what they give.

#[path = "../../../backend/tests/passes_random/generate.rs"]
#[allow(dead_code)]
mod generate;
mod hold;

use bessemer_backend::validate::validate;
use bessemer_frontend::fuse::fuse;
use bessemer_interpret::{Interpreter, Stop};
use bessemer_ir::{Fault, FunctionId, Mode, Module, Span, Type, text};
use generate::Random;

/// The body of the last function, its locals whose names begin with `t` put back where nothing tells.
fn fused(source: &str) -> String {
    let mut module = text::parse(source).expect("a module");
    assert_eq!(validate(&module), Ok(()), "{source}");
    let mut function = module.functions.pop().expect("a function");
    let of_ours = |at: &usize| function.locals[*at].name.starts_with('t');
    let made: Vec<bool> = (0..function.locals.len()).map(|at| of_ours(&at)).collect();
    fuse(&module, &mut function, &|local| made[local.index()]);
    module.functions.push(function);
    assert_eq!(validate(&module), Ok(()), "{source}");
    let printed = text::print(&module);
    let (_, last) = printed.rsplit_once("fn ").expect("a function");
    let (_, body) = last.split_once("{\n").expect("a body");
    let body: Vec<_> = body.lines().map(str::trim).collect();
    body.join(" ").trim().trim_end_matches('}').trim().into()
}

/// A function of these statements: `x` is borrowed, `a` is an array, `n` and `m` are its own.
fn of(body: &str) -> String {
    fused(&format!(
        "module demo

fn bump in demo(count: &mut u8) -> u8 as value {{
  count = count.wrapping_add(1u8);
  return count;
}}

fn add in demo(count: &mut u8, by: &u8) -> u8 as value {{
  count = count.wrapping_add(by);
  return count;
}}

fn sum in demo(x: &mut u8, a: [u8; 4], n: u8, m: u8) -> u8 as total {{
  {body}
}}
"
    ))
}

#[test]
fn an_operand_goes_back_where_nothing_between_tells() {
    // Read once, and nothing between: whatever it does.
    assert_eq!(of("let t: u8 = bump(&mut x); return t + n;"), "return bump(&mut x) + n;");
    assert_eq!(
        of("let t0: u8 = n; let t1: u8 = bump(&mut n); return t0 & t1;"),
        "return n & bump(&mut n);"
    );
    assert_eq!(
        of("let t0: u8 = bump(&mut n); let t1: u8 = n; return t0 & t1;"),
        "return bump(&mut n) & n;"
    );
    // The reader takes them in another order.
    for kept in [
        "let t0: u8 = bump(&mut n); let t1: u8 = n; return t1 & t0;",
        "let t0: u8 = n; let t1: u8 = bump(&mut n); return t1 & t0;",
    ] {
        let first = kept.split_inclusive(';').next().expect("a statement");
        assert!(of(kept).starts_with(first), "{}", of(kept));
    }
}

#[test]
fn what_stands_between_keeps_what_it_would_tell() {
    // Statements between, by columns: nothing; a write of `n`, of `x`, of `m`; a read of `n`; a fault; a way out; a call; an
    // index that may be out of range.
    let between = [
        "",
        "n = 0u8;",
        "x = 0u8;",
        "m = 0u8;",
        "m = n;",
        "m = m + 1u8;",
        "if m == 0u8 { return 9u8; }",
        "bump(&mut m);",
        "m = a[m];",
    ];
    // Whether it goes (`+`), for each.
    let values = [
        ("n", "+-+++++++"),
        ("x", "++-++++++"),
        ("n & 3u8", "+-+++++++"),
        ("n.wrapping_add(x)", "+--++++++"),
        ("a[3]", "+++++++++"),
        ("n + 1u8", "+--++----"),
        ("a[n]", "+--++---+"),
        ("bump(&mut n)", "+--+-----"),
        ("bump(&mut x)", "++-++----"),
    ];
    for (value, goes) in values {
        for (between, goes) in between.iter().zip(goes.chars()) {
            let found = of(&format!("let t: u8 = {value}; {between} return t;"));
            let there = found.starts_with("let t: u8");
            assert_eq!(there, goes == '-', "{value} before {between:?}: {found}");
            // And in a branch that comes before it.
            let inside = format!("let t: u8 = {value}; if m == 1u8 {{ {between} }} return t;");
            let found = of(&inside);
            assert_eq!(found.starts_with("let t: u8"), goes == '-', "{inside}: {found}");
        }
    }
}

#[test]
fn a_name_goes_where_it_is_read_as_often_as_one_likes() {
    let twice = "m = t; return t;";
    assert_eq!(of(&format!("let t: u8 = n; {twice}")), "m = n; return n;");
    assert_eq!(of("let t: u8 = 3u8; m = t; return t;"), "m = 3u8; return 3u8;");
    let stays = |body: &str| assert!(of(body).starts_with("let t: u8"), "{}", of(body));
    stays("let t: u8 = n & 1u8; m = t; return t;");
    stays("let t: u8 = n; m = t; n = 0u8; return t;");
    // In a loop, a write behind the read precedes the next read.
    stays("let t: u8 = n; for i: u8 in 0u8..2u8 { m = t; n = i; } return m;");
    assert_eq!(
        of("let t: u8 = n; for i: u8 in 0u8..2u8 { m = t; } n = 0u8; return m;"),
        "for i: u8 in 0u8..2u8 { m = n; } n = 0u8; return m;"
    );
    // Names of names.
    assert_eq!(
        of("let t0: u8 = n; let t1: u8 = t0; m = t1; return t1 & t0;"),
        "m = n; return n & n;"
    );
    // A read of a name of a name is a read of the first.
    assert!(
        of("let t0: u8 = n; let t1: u8 = t0; m = t1; n = 0u8; return t1;").starts_with("let t0")
    );
    // A read of a name of a name in a loop is followed by the writes of the loop.
    for reads in ["m = t1;", "m = t1; x = t1;"] {
        stays(&format!(
            "let t: u8 = n; for i: u8 in 0u8..2u8 {{ let t1: u8 = t; {reads} n = i; }} return m;"
        ));
    }
    // A conversion to `usize` is a name of what it converts, even of a name of a literal or a field.
    let index = "let t1: usize = t0 as usize; m = a[t1]; return a[t1];";
    assert_eq!(of(&format!("let t0: u8 = n; {index}")), "m = a[n as usize]; return a[n as usize];");
    assert_eq!(
        of(&format!("let t0: u8 = 3u8; {index}")),
        "m = a[3u8 as usize]; return a[3u8 as usize];"
    );
    assert_eq!(
        of("let t: usize = n as usize; m = a[t]; n = 0u8; return a[t];").find("let t"),
        Some(0)
    );
    assert_eq!(of("let t: i8 = n as i8; m = t as u8; return t as u8;").find("let t"), Some(0));
    // What a branch computes may have to be computed before it.
    stays("let t: u8 = n & 1u8; if m == 0u8 { return t; } return 0u8;");
    assert_eq!(
        of("let t: u8 = n; if m == 0u8 { return t; } return 0u8;"),
        "if m == 0u8 { return n; } return 0u8;"
    );
}

#[test]
fn what_is_computed_on_a_condition_has_no_effect() {
    let stays = |body: &str| assert!(of(body).starts_with("let t"), "{}", of(body));
    stays("let t: u8 = bump(&mut x); let both: bool = m == 0u8 && t == 1u8; return m;");
    stays("let t: u8 = n + 1u8; let both: bool = m == 0u8 && t == 1u8; return m;");
    assert_eq!(
        of("let t: u8 = n & 1u8; let both: bool = m == 0u8 && t == 1u8; return m;"),
        "let both: bool = m == 0u8 && n & 1u8 == 1u8; return m;"
    );
}

#[test]
fn what_is_lent_stays_what_it_is_during_the_call() {
    assert_eq!(of("let t: u8 = m; return add(&mut x, &t);"), "return add(&mut x, &m);");
    let kept = "let t: u8 = x; return add(&mut x, &t);";
    assert_eq!(of(kept), kept);
    // An index is no part of the borrowed value.
    assert_eq!(of("let t: u8 = n; return bump(&mut a[t]);"), "return bump(&mut a[n]);");
}

#[test]
fn a_check_goes_where_the_use_of_its_index_repeats_it() {
    let check = "check n < 4u8 else index;";
    // Between the check and the use: what neither ends the function nor shows.
    for between in ["", "m = 0u8;", "let t: u8 = a[m];", "m = t1;"] {
        let found = of(&format!("let t1: u8 = x; {check} {between} return a[n];"));
        assert!(!found.contains("check"), "{between}: {found}");
    }
    for kept in ["x = 0u8;", "m = m + 1u8;", "n = 0u8;", "if m == 0u8 { return 9u8; }"] {
        let found = of(&format!("{check} {kept} return a[n];"));
        assert!(found.contains(check), "{kept}: {found}");
    }
    // Where the use is skipped, or has another length, the check stays.
    for kept in [
        "if m == 0u8 { return a[n]; } return m;",
        "let both: bool = m == 0u8 && a[n] == 0u8; return m;",
        "return m;",
        "return a[m];",
    ] {
        let found = of(&format!("{check} {kept}"));
        assert!(found.contains(check), "{kept}: {found}");
    }
    assert!(of("check n < 3u8 else index; return a[n];").contains("check"));
    // The places of arguments are there before a later argument faults.
    assert_eq!(
        of("let t0: u8 = n & 3u8; check t0 < 4u8 else index; let t1: u8 = m + 1u8; \
            return add(&mut a[t0], &t1);"),
        "return add(&mut a[n & 3u8], &m + 1u8);"
    );
}

#[test]
fn what_moves_into_a_check_has_no_effect() {
    let of =
        |value: &str| of(&format!("let t: u8 = {value}; check t == 0u8 else absent; return m;"));
    assert_eq!(of("n & 7u8"), "check n & 7u8 == 0u8 else absent; return m;");
    for value in ["bump(&mut n)", "a[n]"] {
        assert!(of(value).starts_with("let t: u8"), "{}", of(value));
    }
}

#[test]
fn a_check_that_an_earlier_one_repeats_goes() {
    let checks = |between: &str| {
        let check = "check n < 4u8 else index;";
        of(&format!("{between} {check} x = 0u8; return a[n];")).matches("check").count()
    };
    assert_eq!(checks(""), 1);
    assert_eq!(checks("check n < 4u8 else index; x = 1u8;"), 1);
    // In a branch, of another length, and of an index that is written since.
    for between in [
        "if m == 0u8 { check n < 4u8 else index; x = 1u8; }",
        "check n < 5u8 else index; x = 1u8;",
        "check n < 4u8 else index; x = 1u8; n = m;",
    ] {
        assert_eq!(checks(between), 2, "{between}");
    }
}

#[test]
fn a_use_behind_a_check_misses_nothing() {
    let goes = |before: &str| {
        !of(&format!("{before} let t: u8 = a[n]; m = m + 1u8; return t & m;")).contains("let t")
    };
    assert!(goes("check n < 4u8 else index;"));
    for before in [
        "",
        "check n < 5u8 else index;",
        "check n < 4u8 else index; n = m;",
        "x = a[n]; check n < 4u8 else index;",
        "if m == 0u8 { check n < 4u8 else index; }",
    ] {
        assert!(!goes(before), "{before}");
    }
}

#[test]
fn a_counter_is_below_the_end_of_its_loop() {
    // A fault stays before an index that may be out of range.
    let stays = |range: &str| {
        let body = "let t: u8 = n + 1u8; m = a[i]; m = m & t;";
        of(&format!("for i: u8 in {range} {{ {body} }} return m;")).contains("let t")
    };
    for within in ["0u8..4u8", "0u8..=3u8", "2u8..4u8", "rev 0u8..4u8"] {
        assert!(!stays(within), "{within}");
    }
    for beyond in ["0u8..5u8", "0u8..=4u8", "0u8..n"] {
        assert!(stays(beyond), "{beyond}");
    }
    let checked = |range: &str| {
        of(&format!("for i: u8 in {range} {{ check i < 4u8 else index; x = i; }} return m;"))
            .contains("check")
    };
    assert!(!checked("0u8..4u8"));
    assert!(checked("0u8..5u8"));
}

#[test]
fn a_word_of_an_array_is_read_once_and_an_aggregate_in_its_place() {
    let kept = "let t: u8 = a[1]; m = t; return t;";
    assert_eq!(of(kept), kept);
    let rows = |body: &str| {
        fused(&format!(
            "module demo

fn sum in demo(rows: [[u8; 2]; 3], n: usize, m: u8) -> u8 as total {{
  {body}
}}
"
        ))
    };
    let read = "m = t[0]; return t[1] & m;";
    assert_eq!(
        rows(&format!("check n < 3 else index; let t: [u8; 2] = rows[n]; {read}")),
        "check n < 3 else index; m = rows[n][0]; return rows[n][1] & m;"
    );
    for kept in [
        format!("let t: [u8; 2] = rows[n]; {read}"),
        "check n < 3 else index; let t: [u8; 2] = rows[n]; m = t[0]; rows[0][1] = 1u8; return t[1] & m;".into(),
    ] {
        assert!(rows(&kept).contains("let t"), "{kept}: {}", rows(&kept));
    }
    // Each read of the aggregate reads its index, too.
    for index in ["n", "n & 1"] {
        let found = rows(&format!(
            "let t0: usize = {index}; check t0 < 3 else index; let t1: [u8; 2] = rows[t0]; \
             m = t1[0]; n = 0; return t1[1] & m;"
        ));
        assert!(found.starts_with("let t0") && !found.contains("let t1"), "{found}");
    }
}

#[test]
fn a_computed_bound_of_a_loop_stays_before_it() {
    let stays = |body: &str| assert!(of(body).starts_with("let t: u8"), "{}", of(body));
    stays("let t: u8 = n & 3u8; for i: u8 in 0u8..t { m = i; } return m;");
    assert_eq!(
        of("let t: u8 = n & 3u8; for i: u8 in t..3u8 { m = i; } return m;"),
        "for i: u8 in n & 3u8..3u8 { m = i; } return m;"
    );
    assert_eq!(
        of("let t: u8 = n; for i: u8 in 0u8..t { m = i; } return m;"),
        "for i: u8 in 0u8..n { m = i; } return m;"
    );
    // A part of a bound may be computed in each pass, but no function is called there.
    assert_eq!(
        of("let t: u8 = n & 3u8; for i: u8 in 0u8..t & m { x = i; } return m;"),
        "for i: u8 in 0u8..n & 3u8 & m { x = i; } return m;"
    );
    stays("let t: u8 = n.min(m); for i: u8 in 0u8..t & 3u8 { x = i; } return m;");
    let inner = "let t0: u8 = n.min(m); let t1: u8 = t0 & 3u8; for i: u8 in 0u8..t1 & m { x = i; } return m;";
    assert!(of(inner).starts_with("let t0: u8"), "{}", of(inner));
}

#[test]
fn a_fault_stays_before_what_leaves_the_pass() {
    for leaves in ["break;", "continue;"] {
        let found = of(&format!(
            "for i: u8 in 0u8..2u8 {{ let t: u8 = n + 1u8; if m == 0u8 {{ {leaves} }} m = t; }} return m;"
        ));
        assert!(found.contains("let t: u8"), "{leaves}: {found}");
    }
}

#[test]
fn a_fault_stays_before_a_match_of_an_enum() {
    let found = fused(
        "module demo

enum Mode {
  Idle,
  Land,
}

fn step in demo(mode: Mode, n: u8) -> u8 as total {
  let t: u8 = n + 1u8;
  let m: u8 = 0u8;
  match mode {
    Mode::Idle => {
      m = 1u8;
    }
    Mode::Land => {}
  }
  return t & m;
}
",
    );
    assert!(found.starts_with("let t: u8"), "{found}");
}

#[test]
fn rows_are_evaluated_before_columns() {
    let indexed = |row: &str, column: &str| {
        fused(&format!(
            "module demo

fn bump in demo(count: &mut usize) -> usize as value {{
  count = count.wrapping_add(1usize);
  return count;
}}

fn pick in demo(a: matrix<f64, 2, 2>, n: usize) -> f64 as value {{
  let t0: usize = bump(&mut n);
  let t1: usize = n;
  return a[{row}, {column}];
}}
"
        ))
    };
    assert_eq!(indexed("t0", "t1"), "return a[bump(&mut n), n];");
    assert!(indexed("t1", "t0").starts_with("let t0: usize"), "{}", indexed("t1", "t0"));
}

#[test]
fn a_value_of_which_a_part_is_read_stays() {
    let kept = "let t: [u8; 4] = [n, m, n, m]; return t[1];";
    assert_eq!(of(kept), kept);
    assert_eq!(of("let t: [u8; 4] = a; return t[1];"), "return a[1];");
}

#[test]
fn a_temporary_that_is_written_stays() {
    let kept = "let t: u8 = n; t = m; return t;";
    assert_eq!(of(kept), kept);
}

#[test]
fn what_nobody_reads_goes_unless_it_does_something() {
    assert_eq!(of("let t: u8 = n & 1u8; return m;"), "return m;");
    let stays = |body: &str| assert_eq!(of(body), body);
    stays("let t: u8 = bump(&mut x); return m;");
    stays("let t: u8 = n + 1u8; return m;");
}

/// Counts what the random functions gave.
#[derive(Default)]
struct Count {
    functions: usize,
    runs: usize,
    faults: usize,
    held: usize,
    left: usize,
    whole: usize,
}

/// NaNs are all the same.
fn canonical(words: &[u64]) -> Vec<u64> {
    let nan = |word: u64| f64::from_bits(word).is_nan() && word >> 52 & 0x7FF == 0x7FF;
    words.iter().map(|word| if nan(*word) { f64::NAN.to_bits() } else { *word }).collect()
}

/// Returns the result of a call and what it left in references, or its fault; two faults of indices are the same.
fn called(module: &Module, function: usize, arguments: &[Vec<u64>]) -> String {
    let mut arguments = arguments.to_vec();
    let result = Interpreter::new(module).call(FunctionId(function as u32), &mut arguments);
    let parameters = module.functions[function].parameters();
    // Arguments by value are nobody's afterwards.
    let borrowed = arguments.iter().zip(parameters).filter(|it| it.1.mode != Mode::Value);
    let borrowed: Vec<_> = borrowed.map(|(words, _)| canonical(words)).collect();
    match result {
        Ok(words) => format!("{:?} {borrowed:?}", canonical(&words)),
        Err(Stop::Fault { fault, function, span }) => {
            let at = if fault == Fault::Index { Span::default() } else { span };
            format!("{fault:?} in {function:?} at {at:?}, {borrowed:?}")
        }
        Err(other) => panic!("{other}"),
    }
}

/// Holds a random module's operands, puts them back and compares; `shuffled`: in an order that is not the author's.
fn compare(seed: u64, shuffled: bool, count: &mut Count) {
    let plain = generate::module(seed);
    if validate(&plain).is_err() {
        return;
    }
    let mut random = Random::new(seed ^ 0x5EED);
    let often = seed as usize % 3 * 20;
    let (mut held, mut fused) = (plain.clone(), plain.clone());
    for at in 0..plain.functions.len() {
        let item = &plain.functions[at];
        let (mut function, made) = hold::held(&plain, item, &mut || random.chance(often));
        if shuffled {
            hold::shuffle(&mut function, &made, &mut || random.chance(50));
        }
        held.functions[at] = function.clone();
        fuse(&plain, &mut function, &|local| made.contains(&local));
        count.functions += 1;
        count.held += made.len();
        count.left += function.locals.len() - item.locals.len();
        count.whole += usize::from(function == *item);
        fused.functions[at] = function;
    }
    if std::env::var("FUSE_SHOW").is_ok() {
        println!("{}\n=====\n{}", text::print(&held), text::print(&fused));
    }
    assert_eq!(validate(&held), Ok(()), "seed {seed}");
    assert_eq!(validate(&fused), Ok(()), "seed {seed}");
    for (function, item) in plain.functions.iter().enumerate() {
        for _ in 0..8 {
            let words = |ty: &Type, random: &mut Random| {
                plain.leaves(ty).iter().map(|leaf| random.word(leaf)).collect()
            };
            let arguments: Vec<Vec<u64>> =
                item.parameters().iter().map(|it| words(&it.ty, &mut random)).collect();
            let expected = called(&held, function, &arguments);
            if !shuffled {
                let plain = called(&plain, function, &arguments);
                assert_eq!(plain, expected, "seed {seed} f{function}: held");
            }
            let found = called(&fused, function, &arguments);
            assert_eq!(found, expected, "seed {seed} f{function}");
            count.runs += 1;
            count.faults += usize::from(!expected.starts_with('['));
        }
    }
}

fn random_functions(shuffled: bool) -> Count {
    let number = |name: &str, default| {
        std::env::var(name).ok().and_then(|text| text.parse().ok()).unwrap_or(default)
    };
    let (first, seeds) = (number("FUSE_FIRST", 0), number("FUSE_SEEDS", 400));
    let mut count = Count::default();
    (first..first + seeds).for_each(|seed| compare(seed, shuffled, &mut count));
    let Count { functions, runs, faults, held, left, whole } = count;
    println!(
        "{functions} functions, {runs} runs, {faults} faults; {held} temporaries, {left} left; \
         {whole} functions as their authors wrote them"
    );
    count
}

#[test]
fn operands_held_in_their_order_go_back() {
    let count = random_functions(false);
    assert!(count.held > 50_000, "{} temporaries", count.held);
    assert!(count.left * 1_000 < count.held, "{} of {} are left", count.left, count.held);
    assert!(count.whole * 10 > count.functions * 9, "{} of {}", count.whole, count.functions);
}

#[test]
fn operands_held_in_another_order_mean_the_same() {
    let count = random_functions(true);
    assert!(count.left * 20 > count.held, "{} of {} are left", count.left, count.held);
    assert!(count.left * 2 < count.held, "{} of {} are left", count.left, count.held);
}
