//! Counts what the front half's lowering does in many places and is to do in one. Among it are files that call each other
//! in a circle, lines that decide the order of evaluation, and places that build the author's tree.
//!
//! Each count is committed in `counts.txt`, and may only fall. `UPDATE_DOCS=1 cargo test -p xtask --test lowering` writes it
//! where it fell, and never where it rose.

mod calls;
#[path = "../shared/modules.rs"]
mod modules;
mod order;
mod trees;
mod types;

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use modules::{Module, files, read, root};

/// The folder of the lowering.
const LOWERING: &str = "codegen/frontend/src/typify";
/// The file of the counts.
const COUNTS: &str = "xtask/tests/lowering/counts.txt";

/// An idea, and its mechanisms: a description, the file and a name defined there.
type Idea = (&'static str, &'static [(&'static str, &'static str, &'static str)]);

/// Ideas with several mechanisms. A mechanism leaves the list when its name goes.
const MECHANISMS: [Idea; 3] = [
    ("kinds of code that is lowered twice", &[]),
    (
        "mechanisms for iterators",
        &[
            ("by index: `Seq`", "seq", "Seq"),
            ("by callback: the loop of a function that hands items on", "items", "handing"),
            ("by explicit `next` calls", "lowering", "Hand"),
        ],
    ),
    (
        "mechanisms that put a body where it is called",
        &[
            ("`#[function(expand)]`", "expand", "expansion"),
            ("`#[function(rewrite)]`", "rewrite", "rule"),
            ("closures as arguments", "closure_args", "call_handing"),
            ("functions that return places", "place_functions", "lends"),
            ("functions that give iterators", "generator", "generated_stmt"),
        ],
    ),
];

/// The files of a folder, parsed.
pub type Files = BTreeMap<Module, syn::File>;

/// Returns the parsed files of a folder.
fn parsed(folder: &Path) -> Files {
    let parsed =
        |(module, path): (Module, PathBuf)| (module, syn::parse_file(&read(&path)).expect("Rust"));
    files(folder).into_iter().map(parsed).collect()
}

/// Returns files by name and text.
fn written(files: &[(&str, &str)]) -> Files {
    let file = |(name, text): &(&str, &str)| {
        (vec![(*name).to_owned()], syn::parse_file(text).expect("Rust"))
    };
    files.iter().map(file).collect()
}

/// A count, and the places that were counted.
struct Count {
    what: &'static str,
    count: usize,
    places: Vec<String>,
}

/// Counts everything.
fn counts() -> Vec<Count> {
    let lowering = parsed(&root().join(LOWERING));
    let circle = calls::circle(&lowering);
    let order = order::lines(&lowering);
    let trees = trees::built(&lowering);
    let [fields, methods] = types::largest(&parsed(&root().join("codegen/frontend/src")));
    let mut counts = vec![
        Count { what: "files in the circle of calls", count: circle.len(), places: circle },
        Count {
            what: "lines that decide the order of evaluation",
            count: order.iter().map(|(_, lines)| lines.len()).sum(),
            places: by_file(order),
        },
        Count {
            what: "places that build the author's tree",
            count: trees.iter().map(|(_, lines)| lines.len()).sum(),
            places: by_file(trees),
        },
        Count { what: "fields of the largest struct", count: fields.0, places: vec![fields.1] },
        Count { what: "methods of the largest type", count: methods.0, places: vec![methods.1] },
    ];
    for (what, listed) in MECHANISMS {
        let places = listed.iter().map(|(why, file, name)| format!("{file}.rs, `{name}`: {why}"));
        counts.push(Count { what, count: listed.len(), places: places.collect() });
    }
    counts
}

/// Writes each file with its lines.
fn by_file(lines: Vec<(String, Vec<usize>)>) -> Vec<String> {
    let line = |(file, lines): (String, Vec<usize>)| {
        let lines: Vec<String> = lines.iter().map(usize::to_string).collect();
        format!("{file}: {}", lines.join(" "))
    };
    lines.into_iter().map(line).collect()
}

/// Writes the table.
fn table(counts: &[(&str, usize)]) -> String {
    counts.iter().map(|(what, count)| format!("{count:>4} {what}\n")).collect()
}

#[test]
fn each_count_only_falls() {
    let counts = counts();
    let path = root().join(COUNTS);
    let committed = std::fs::read_to_string(&path).unwrap_or_default();
    let bound = |what: &str| {
        let line = committed.lines().find_map(|line| line.trim_start().strip_suffix(what));
        line.and_then(|count| count.trim_end().parse::<usize>().ok()).unwrap_or(usize::MAX)
    };
    for Count { what, count, places } in &counts {
        println!("{count:>4} {what}\n       {}", places.join("\n       "));
    }
    let rose = counts.iter().filter(|it| it.count > bound(it.what)).map(|it| {
        let Count { what, count, places } = it;
        format!("{count} {what}, more than {}:\n    {}", bound(what), places.join("\n    "))
    });
    let rose: Vec<String> = rose.collect();
    assert!(rose.is_empty(), "{}", rose.join("\n"));
    let table = table(&counts.iter().map(|it| (it.what, it.count)).collect::<Vec<_>>());
    if std::env::var_os("UPDATE_DOCS").is_some() {
        std::fs::write(&path, table).expect("the counts are written");
    } else {
        let renewal = "UPDATE_DOCS=1 cargo test -p xtask --test lowering";
        assert!(committed == table, "{COUNTS} is stale: run {renewal}. It should be\n{table}");
    }
}

#[test]
fn each_listed_mechanism_is_there() {
    let files = parsed(&root().join(LOWERING));
    let mut gone = Vec::new();
    for (what, listed) in MECHANISMS {
        for (_, file, name) in listed {
            let there = files.get(&vec![(*file).to_owned()]).is_some_and(|it| {
                let names = types::defined(it);
                names.contains(*name)
            });
            if !there {
                gone.push(format!("{what}: {file}.rs has no `{name}`"));
            }
        }
    }
    assert!(gone.is_empty(), "take these off the list, or name their successors:\n{gone:#?}");
}

#[test]
fn a_circle_of_calls_is_found_without_an_import() {
    let files = written(&[
        ("a", "struct Lowering; impl Lowering { fn one(&mut self) { self.two(); } }"),
        ("b", "impl Lowering { fn two(&self) { (|inner| inner.one())(self) } }"),
        ("c", "impl Lowering { fn three(&self) { self.one(); self.count(); } }"),
        ("d", "struct D; impl D { fn two(&self) { self.three(); } } fn free() {}"),
    ]);
    assert_eq!(calls::circle(&files), ["a", "b"]);
    let files = written(&[
        ("a", "use super::b::free; impl Lowering { fn one(&mut self) { free(self) } }"),
        ("b", "fn free(of: &mut Lowering) { of.one(); }"),
        ("c", "fn own() { let free = 1; f(free); super::a::none(); }"),
    ]);
    assert_eq!(calls::circle(&files), ["a", "b"]);
}

#[test]
fn only_lines_that_decide_order_count() {
    let found = |body: &str| {
        let files = written(&[("a", &format!("use order::is_free;\nfn keep() {{\n{body}\n}}"))]);
        order::lines(&files).iter().map(|(_, lines)| lines.len()).sum::<usize>()
    };
    assert_eq!(
        found("self.settle(x);\nself.keep_order(y);\nvalues.iter().all(order::is_free);"),
        3
    );
    assert_eq!(found("if inner.is_lasting(&x) && is_free(y) { self.fix(z) }"), 1);
    assert_eq!(found("matches!(self.temporary(x), Some(_));"), 1);
    assert_eq!(found("let held = later; self.held(held); fixed(keep);"), 0);
    assert_eq!(order::lines(&written(&[("order", "fn f() { self.settle(x); }")])), []);
}

#[test]
fn building_a_tree_counts_and_reading_one_does_not() {
    let found = |body: &str| {
        let uses =
            "use bessemer_ir::tree::{self, ExprKind as Tree, Pattern};\nuse bessemer_ir::Expr;";
        let files = written(&[("a", &format!("{uses}\nfn f() {{ {body} }}"))]);
        trees::built(&files).iter().map(|(_, lines)| lines.len()).sum::<usize>()
    };
    assert_eq!(found("tree::Expr::plain(Tree::Bool(true), site); Pattern::name(x);"), 2);
    assert_eq!(found("Tree::Block(tree::Block { stmts, tail: None })"), 1);
    assert_eq!(found("match x { Tree::Bool(it) => Expr::bool(it), Tree::Unit => y }"), 0);
    assert_eq!(found("fn g(of: &tree::Expr) -> Expr { Expr { kind, ty } }"), 0);
}
