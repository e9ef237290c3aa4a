//! Growth of the tool's own time with the size of a function, for constructs that nest or follow each other. Twice the size
//! must take no more than 2.2 times as long.
//!
//! One package has a function for each shape and size. It is built once for its tree; then each function is compiled to C by
//! itself, without cargo and rustc. The time is processor time. The sizes of a shape are measured in turn, some rounds of a
//! fifth of a second each, so that a machine that slows down meanwhile slows all of them.

use std::fmt::Write as _;

use bessemer_codegen::compile::{self, Options};
use bessemer_codegen::generate;
use bessemer_frontend::source::Sources;
use bessemer_ir::tree::Package;
use bessemer_tests::workspace::Workspace;
use serde_json::{Value, json};

use crate::check_cost::{all_seconds, hundredths};

/// Least processor time of a size in a round, in seconds.
const LEAST: f64 = 0.2;
const ROUNDS: usize = 5;

/// A shape: its name, the sizes of its functions, and the body of one.
pub type Shape = (&'static str, [usize; 3], fn(usize) -> String);

/// The shapes.
pub const SHAPES: [Shape; 10] = [
    ("nested match", [10, 20, 40], nested_match),
    ("nested match, guards write", [10, 20, 40], writing_match),
    ("nested if let", [10, 20, 40], nested_if_let),
    ("if let chain", [10, 20, 40], let_chain),
    ("nested if", [10, 20, 40], nested_if),
    ("closures that call each other", [10, 20, 40], closures),
    ("chain of adapters", [10, 20, 40], adapters),
    ("nested loops", [4, 8, 16], nested_loops),
    ("long function", [1000, 2000, 4000], long),
    ("long function of integers", [1000, 2000, 4000], long_of_integers),
];

/// The measured times of a shape: each size with milliseconds.
#[derive(Clone, Debug)]
pub struct Growth {
    /// Name of the shape.
    pub shape: &'static str,
    /// Sizes, and processor milliseconds of a compilation.
    pub times: Vec<(usize, f64)>,
}

impl Growth {
    /// Ratios of the times of neighbouring sizes.
    pub fn ratios(&self) -> Vec<f64> {
        self.times.windows(2).map(|pair| pair[1].1 / pair[0].1).collect()
    }
}

/// Returns the results for machines.
pub fn results(rows: &[Growth]) -> Value {
    let row = |growth: &Growth| {
        json!({
            "shape": growth.shape,
            "sizes": growth.times.iter().map(|it| it.0).collect::<Vec<_>>(),
            "milliseconds": growth.times.iter().map(|it| hundredths(it.1)).collect::<Vec<_>>(),
            "ratios": growth.ratios().into_iter().map(hundredths).collect::<Vec<_>>(),
        })
    };
    json!({
        "command": "cargo xtask bench --only shapes",
        "shapes": rows.iter().map(row).collect::<Vec<_>>(),
    })
}

/// Returns the table for people.
pub fn table(rows: &[Growth]) -> String {
    let mut text = "one function, tree to C, processor ms by size\n\n".to_owned();
    for growth in rows {
        let _ = write!(text, "{:<30}", growth.shape);
        for (size, time) in &growth.times {
            let _ = write!(text, " {size:>5}: {time:>8.2}");
        }
        let ratios: Vec<String> = growth.ratios().iter().map(|it| format!("{it:.2}")).collect();
        let _ = writeln!(text, "   × {}", ratios.join(" "));
    }
    text
}

/// Measures; `tick` is called after each shape.
///
/// # Errors
/// The message of cargo, the generator or the file system.
pub fn measure(mut tick: impl FnMut()) -> Result<Vec<Growth>, String> {
    let mut source = "//! Shapes.\n#![no_std]\nuse bessemer::prelude::*;\n".to_owned();
    for (at, (_, sizes, body)) in SHAPES.iter().enumerate() {
        for size in sizes {
            let _ = write!(
                source,
                "\n/// A shape.\n#[function]\npub fn f{at}_{size}(a: f64, b: f64, r: f64, mut n: i32, v: &[i32; 8]) -> f64 {{\n    n = n.wrapping_add(1);\n{}}}\n",
                body(*size)
            );
        }
    }
    let workspace = Workspace::with_source(&source).map_err(|error| error.to_string())?;
    let tree = generate::tree(&workspace.job()).map_err(|error| error.to_string())?;
    let sources = Sources::new(workspace.path(""));
    let mut rows = Vec::new();
    for (at, (shape, sizes, _)) in SHAPES.iter().enumerate() {
        let packages = sizes.map(|size| {
            let name = format!("f{at}_{size}");
            let mut package = tree.package.clone();
            package
                .functions
                .retain(|it| it.module.starts_with("bessemer::") || it.tree.name == name);
            package
        });
        let compiled = |package: &Package| {
            compile::compile(package, &sources, &Options::default())
                .map(drop)
                .map_err(|errors| format!("{shape}: {:?}", errors.first()))
        };
        packages.iter().try_for_each(compiled)?;
        let (mut spent, mut runs) = ([0.0; 3], [0.0; 3]);
        for _ in 0..ROUNDS {
            for (which, package) in packages.iter().enumerate() {
                let (start, mut more) = (all_seconds()?, 0.0);
                while more < LEAST {
                    compiled(package)?;
                    runs[which] += 1.0;
                    more = all_seconds()? - start;
                }
                spent[which] += more;
            }
        }
        let times = (0..3).map(|at| (sizes[at], 1000.0 * spent[at] / runs[at])).collect();
        rows.push(Growth { shape, times });
        tick();
    }
    Ok(rows)
}

/// Writes `depth` constructs within each other: each is `open` with its number, and `close` behind the inner one.
fn nested(depth: usize, open: impl Fn(usize) -> String, inner: &str, close: &str) -> String {
    let mut text: String = (0..depth).map(|at| open(at) + "\n").collect();
    text += inner;
    for _ in 0..depth {
        text += "\n";
        text += close;
    }
    text + "\n"
}

fn nested_match(depth: usize) -> String {
    nested(
        depth,
        |at| {
            format!(
                "match (n, v[{}]) {{ (0, _) => {at}.0, (x, y) if x > y.wrapping_add({at}) => {{",
                at % 8
            )
        },
        "a",
        "} _ => b, }",
    )
}

fn writing_match(depth: usize) -> String {
    nested(
        depth,
        |at| {
            let part = at % 8;
            format!("match (n, v[{part}]) {{ (x, y) if {{ n = n.wrapping_add(1); x > y }} => {{")
        },
        "a",
        "} _ => b, }",
    )
}

fn nested_if_let(depth: usize) -> String {
    nested(
        depth,
        |at| {
            format!(
                "if let Some(x{at}) = v[{}].checked_add(n) {{ n = n.wrapping_mul(x{at});",
                at % 8
            )
        },
        "a",
        "} else { b }",
    )
}

fn let_chain(depth: usize) -> String {
    let condition = |at| format!("let Some(x{at}) = v[{}].checked_add({at})\n", at % 8);
    let conditions: Vec<String> = (0..depth).map(condition).collect();
    format!("if {} && x0 > n {{ a }} else {{ b }}\n", conditions.join(" && "))
}

fn nested_if(depth: usize) -> String {
    nested(
        depth,
        |at| format!("if n > {at} && a < {at}.5 {{ n = n.wrapping_sub(1);"),
        "a",
        "} else { b }",
    )
}

fn closures(number: usize) -> String {
    let mut text = "let g0 = |x: f64| x * a + r;\n".to_owned();
    for at in 1..number {
        let _ = writeln!(text, "let g{at} = |x: f64| g{}(x + b) * {at}.5;", at - 1);
    }
    let _ = writeln!(text, "g{}(r)", number - 1);
    text
}

fn adapters(number: usize) -> String {
    let links: String = (0..number)
        .map(|at| match at % 2 {
            0 => format!(".map(|x| x.wrapping_add({at}))\n"),
            _ => format!(".filter(|x| *x > n.wrapping_add({at}))\n"),
        })
        .collect();
    format!(
        "let sum = v.iter().map(|x| *x){links}.fold(0, |sum: i32, x| sum.wrapping_add(x));\nf64::from(sum)\n"
    )
}

fn nested_loops(depth: usize) -> String {
    format!(
        "let mut sum = a;\n{}sum\n",
        nested(depth, |at| format!("for i{at} in 0..3 {{ sum += r;"), "sum *= b;", "}")
    )
}

/// Operations, ten in four lines, as a controller has them.
fn long(operations: usize) -> String {
    let mut text = "let x0 = a;\nlet x1 = b;\n".to_owned();
    for n in 2..2 + operations / 10 {
        let (one, two) = (n - 1, n - 2);
        let _ = write!(
            text,
            "let e{n} = r - x{one};\nlet p{n} = e{n} * 1.5 + x{two} * a;\n\
             let q{n} = if p{n} > b {{ p{n} - 0.25 }} else {{ p{n} + 0.75 }};\n\
             let x{n} = q{n}.clamp(-1.0, 1.0) * 0.125 - e{n};\n"
        );
    }
    text + &format!("x{}\n", 1 + operations / 10)
}

/// Operations of integers that may overflow, so that facts about them are kept: ten in five lines.
fn long_of_integers(operations: usize) -> String {
    let mut text = "let x0 = v[0] / 2;\nlet x1 = n / 2;\n".to_owned();
    for n in 2..2 + operations / 10 {
        let (one, two) = (n - 1, n - 2);
        let _ = write!(
            text,
            "let e{n} = x{one} / 2 - x{two} / 4;\nlet p{n} = if e{n} > {n} {{ e{n} - 1 }} else {{ x{one} / 2 + 1 }};\n\
             let q{n} = v[({n} + p{n}.clamp(0, 7) as usize) % 8] / 4;\n\
             let x{n} = q{n} + p{n} / 2;\n"
        );
    }
    text + &format!("f64::from(x{})\n", 1 + operations / 10)
}
