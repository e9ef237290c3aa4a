//! Every type of the IR equals rustc's: each is computed from the bottom up and compared with the slot of the
//! expression. A disagreement is reported as an error of the tool.

use bessemer_codegen::compile::{self, Options};
use bessemer_codegen::generate::Job;
use bessemer_frontend::source::Sources;
use bessemer_ir::tree::{Package, Ty};
use bessemer_ir::{Float, Int, Scalar};
use bessemer_tests::{compiled, root, trees, turn};

/// The packages whose every expression is checked: one in a run, since no package compiles otherwise.
const PACKAGES: [&str; 4] = ["models", "corpus", "edges", "linear"];

#[test]
fn every_type_is_rustcs_own() {
    for package in turn::one_of(PACKAGES.to_vec()) {
        let typed = compiled(package).typed;
        println!(
            "{package}: {} expressions typed from the bottom up, {} of them held against rustc",
            typed.expressions, typed.agreed
        );
        assert!(typed.agreed > 0 && typed.agreed <= typed.expressions, "{package}: {typed:?}");
    }
}

/// Number of consecutive functions of which a run changes one, unless it is full.
const THIRD: usize = 3;

/// The package with the type in one slot another than rustc's.
fn doctored(package: &Package, function: usize, slot: usize) -> Option<Package> {
    let mut other = package.clone();
    let ty = other.functions.get_mut(function)?.slots.get_mut(slot)?;
    *ty = match ty {
        Ty::Scalar(Scalar::Float(Float::F64)) => Ty::Scalar(Scalar::Float(Float::F32)),
        Ty::Scalar(Scalar::Float(Float::F32)) => Ty::Scalar(Scalar::Float(Float::F64)),
        Ty::Scalar(Scalar::Int(Int::U32)) => Ty::Scalar(Scalar::Int(Int::I32)),
        Ty::Scalar(Scalar::Int(_)) => Ty::Scalar(Scalar::Int(Int::U32)),
        Ty::Scalar(Scalar::Bool) => Ty::Scalar(Scalar::Int(Int::U8)),
        _ => return None,
    };
    Some(other)
}

/// The slots of a function's arithmetic: their types follow from their operands.
fn arithmetic(value: &serde_json::Value, found: &mut Vec<usize>) {
    match value {
        serde_json::Value::Object(map) => {
            let binary = map.get("kind").is_some_and(|kind| kind.get("Binary").is_some());
            if let (true, Some(slot)) = (binary, map.get("slot").and_then(|slot| slot.as_u64())) {
                found.push(slot as usize);
            }
            map.values().for_each(|value| arithmetic(value, found));
        }
        serde_json::Value::Array(items) => items.iter().for_each(|item| arithmetic(item, found)),
        _ => {}
    }
}

#[test]
fn a_type_that_is_not_rustcs_is_told() {
    let package = trees::tree(&Job::new(root(), "models"), &trees::folders());
    let package = package.expect("the tree of the package").package;
    let sources = Sources::new(root());
    let (mut told, mut tried, mut otherwise) = (0, 0, Vec::new());
    let functions: Vec<_> = package.functions.iter().enumerate().collect();
    for (index, function) in functions.chunks(THIRD).flat_map(|some| turn::one_of(some.to_vec())) {
        let tree = serde_json::to_value(&function.tree).expect("a tree as JSON");
        let mut slots = Vec::new();
        arithmetic(&tree, &mut slots);
        for slot in slots.into_iter().take(1) {
            let Some(other) = doctored(&package, index, slot) else { continue };
            tried += 1;
            let errors = match compile::compile(&other, &sources, &Options::default()) {
                Ok(_) => panic!("{}: nobody saw that slot {slot} is another", function.path),
                Err(errors) => errors,
            };
            let named = |help: &str| help.contains("a fault of Bessemer");
            if errors.iter().any(|error| named(&error.help)) {
                told += 1;
            } else {
                otherwise.push(format!("{} slot {slot}: {errors:?}", function.path));
            }
        }
    }
    println!("{tried} types changed behind rustc's back, {told} told as a fault of the tool");
    assert!(tried >= 20 && otherwise.is_empty(), "{told} of {tried}: {otherwise:#?}");
}
