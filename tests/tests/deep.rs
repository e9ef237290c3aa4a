//! Expressions that nest as deep as somebody may write them: they come through every stage, and none vanishes.

use bessemer_codegen::compile::Compiled;
use bessemer_codegen::deep::deep;
use bessemer_codegen::generate::Error;
use bessemer_interpret::Interpreter;
use bessemer_ir::FunctionId;
use bessemer_tests::process::Process;
use bessemer_tests::toolchain;
use bessemer_tests::turn;
use bessemer_tests::workspace::Workspace;

/// Number of the sum's terms in a run that is not full. rustc infers the types of operators in time quadratic in their
/// number in a function, a minute for these.
const TERMS: u32 = 2000;
const FEWER: u32 = 300;

/// Conditions between `&&`, branches, and fields.
const CONDITIONS: u32 = 2000;
const BRANCHES: u32 = 500;
const FIELDS: u32 = 600;

fn terms() -> u32 {
    if turn::is_full() { TERMS } else { FEWER }
}

fn joined(count: u32, between: &str, one: impl Fn(u32) -> String) -> String {
    (0..count).map(one).collect::<Vec<_>>().join(between)
}

fn source() -> String {
    let sum = joined(terms(), "\n        + ", |k| format!("x * {k}.5"));
    let all = joined(CONDITIONS, "\n        && ", |k| format!("n != {}", 2 * k + 1));
    let chosen =
        joined(BRANCHES, " else ", |k| format!("if n == {k} {{\n        {}\n    }}", 3 * k));
    let fields = joined(FIELDS, "\n", |k| format!("    pub f{k}: i32,"));
    format!(
        "#![allow(missing_docs)]
use bessemer::prelude::*;

#[function]
pub fn sum(x: f64) -> f64 {{
    {sum}
}}

#[function]
pub fn all(n: u32) -> bool {{
    {all}
}}

#[function]
pub fn chosen(n: u32) -> u32 {{
    {chosen} else {{
        1
    }}
}}

#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wide {{
{fields}
}}

#[function]
pub fn same(a: &Wide, b: &Wide) -> bool {{
    a == b
}}
"
    )
}

/// Calls of a function, and the word that each gives.
type Calls = Vec<(Vec<Vec<u64>>, u64)>;

fn calls() -> [(&'static str, Calls); 4] {
    let sum = |x: f64| (1..terms()).fold(x * 0.5, |sum, k| sum + x * (f64::from(k) + 0.5));
    let wide = |at: u32| (0..FIELDS).map(|k| u64::from(k) + u64::from(k == at)).collect::<Vec<_>>();
    let same = |at: u32| (vec![wide(FIELDS), wide(at)], u64::from(at == FIELDS));
    [
        ("sum", [0.1_f64, -3.7].map(|x| (vec![vec![x.to_bits()]], sum(x).to_bits())).to_vec()),
        (
            "all",
            [(1, 0), (2 * CONDITIONS - 1, 0), (2 * CONDITIONS + 1, 1), (2, 1)]
                .map(|(n, is)| (vec![vec![u64::from(n)]], is))
                .to_vec(),
        ),
        (
            "chosen",
            [(0, 0), (BRANCHES - 1, 3 * (BRANCHES - 1)), (BRANCHES, 1)]
                .map(|(n, is)| (vec![vec![u64::from(n)]], u64::from(is)))
                .to_vec(),
        ),
        ("same", [0, FIELDS - 1, FIELDS].map(same).to_vec()),
    ]
}

fn function(compiled: &Compiled, name: &str) -> FunctionId {
    let index = compiled.module.functions.iter().position(|it| it.name == name);
    FunctionId(index.unwrap_or_else(|| panic!("`{name}` vanished")) as u32)
}

#[test]
fn what_nests_deep_comes_through() {
    let workspace = Workspace::with_source(&source()).expect("a workspace");
    let compiled = workspace.compiled().unwrap_or_else(|error| panic!("{error}"));
    for (name, calls) in calls() {
        let id = function(&compiled, name);
        for (arguments, expected) in &calls {
            for module in [&compiled.module, &compiled.explicit] {
                let mut arguments = arguments.clone();
                let words = deep(|| Interpreter::new(module).call(id, &mut arguments));
                let words = words.unwrap_or_else(|stop| panic!("{name}: {stop}"));
                assert_eq!(words, [*expected], "{name}, interpreted");
            }
        }
        for toolchain in toolchain::host().iter().filter(|it| it.level == 0) {
            let mut process = Process::start(&compiled, id, toolchain)
                .unwrap_or_else(|error| panic!("{name}: {error}"));
            for (arguments, expected) in &calls {
                let words = process.step(&arguments.concat()).expect("it answers");
                assert_eq!(words, [0, *expected], "{name} with {}", toolchain.name());
            }
        }
    }
}

/// Conditions between `&&`, more than are let through.
const TOO_MANY: u32 = 4200;

/// Checks that deeper nesting is reported at its place, and that the remedy works.
#[test]
fn what_nests_too_deep_has_a_remedy() {
    let all = |from: u32, to: u32| {
        let conditions: Vec<String> = (from..to).map(|k| format!("n != {k}")).collect();
        conditions.join("\n        && ")
    };
    let source = |body: &str| {
        format!(
            "#![allow(missing_docs)]
use bessemer::prelude::*;

#[function]
pub fn all(n: u32) -> bool {{
    {body}
}}
"
        )
    };
    let workspace = Workspace::with_source(&source(&all(0, TOO_MANY))).expect("a workspace");
    let said = match workspace.generate("0") {
        Err(Error::Refused(said)) => said.to_string(),
        Err(other) => panic!("{other}"),
        Ok(_) => panic!("it was generated"),
    };
    insta::with_settings!({ prepend_module_to_snapshot => false, snapshot_path => "../diagnosed", omit_expression => true }, {
        insta::assert_snapshot!("nested_too_deep", said);
    });
    let half = TOO_MANY / 2;
    let parts = format!(
        "let low = {};\n    let high = {};\n    low && high",
        all(0, half),
        all(half, TOO_MANY)
    );
    workspace.set_source(&source(&parts)).expect("a source file");
    workspace.generate("0").unwrap_or_else(|error| panic!("{error}"));
}

/// Depths of which one is twice the other, and how much more the deeper one may cost at most. rustc takes a minute for
/// the first ones, so they are for a full run.
const DEPTHS: [usize; 2] = [20, 40];
const LESS_DEEP: [usize; 2] = [8, 16];
const MOST: f64 = 2.2;

/// Returns functions whose `match` and `if let`, with guards that write what is matched, nest in arms, conditions and guards.
fn guarded(depth: usize) -> String {
    let nested = |inner: &dyn Fn(usize, String) -> String, end: &str| {
        (0..depth).fold(end.to_owned(), |body, k| inner(k, body))
    };
    let arms = nested(
        &|k, body| {
            format!(
                "match (n, x) {{ (a, b) if {{ n = n.wrapping_add({k}); a > b }} => {{ {body} }} (a, _) => a ^ {k} }}"
            )
        },
        "n ^ x",
    );
    let conditions = nested(
        &|k, body| {
            format!(
                "if let Some(a) = o && {{ o = Some(n); n = n.wrapping_mul(3); a > {k} }} && {{ {body} }} > 7 {{ a ^ n }} else {{ n }}"
            )
        },
        "n ^ x",
    );
    let guards = nested(
        &|k, body| {
            format!(
                "match (n, x) {{ (a, _) if {{ n = n.wrapping_mul(3); {body} }} > a => a ^ {k}, (a, _) => a.wrapping_add({k}) }}"
            )
        },
        "n ^ x",
    );
    let function = |name: &str, body: &str| {
        format!(
            "#[function]\npub fn {name}_{depth}(n0: u32, x: u32) -> u32 {{\n    let mut n = n0;\n    let mut o = Some(x);\n    {body}\n}}\n"
        )
    };
    let all = [("arms", arms), ("conditions", conditions), ("guards", guards)];
    all.map(|(name, body)| function(name, &body)).concat()
}

/// Every arm, condition and guard is lowered once: twice at each level would be 2^40 times, or 2^16.
#[test]
fn nested_guards_cost_what_they_are() {
    let depths = if turn::is_full() { DEPTHS } else { LESS_DEEP };
    let functions = depths.map(guarded).concat();
    let source = format!(
        "#![allow(missing_docs, unused_assignments, unused_mut)]\nuse bessemer::prelude::*;\n\n{functions}"
    );
    let workspace = Workspace::with_source(&source).expect("a workspace");
    let compiled = workspace.compiled().unwrap_or_else(|error| panic!("{error}"));
    for name in ["arms", "conditions", "guards"] {
        let [once, twice] = depths.map(|depth| {
            let id = function(&compiled, &format!("{name}_{depth}"));
            compiled.module.functions[id.index()].locals.len() as f64
        });
        println!("{name}: {once} locals, {twice} at twice the depth");
        assert!(twice <= MOST * once, "{name}: {once} locals, {twice} at twice the depth");
    }
}
