//! The onboard software in vectors, `models/lanes`, is emitted from these models. Campaigns fly it, and compare.

use std::path::Path;

use bessemer_backend::passes;
use bessemer_ir::{FunctionId, Owner};
use bessemer_tests::{flight_models, golden};

/// The committed text, from the root.
const TEXT: &str = "models/lanes/src/onboard.in";

#[test]
fn the_committed_vectors_are_those_of_the_models() {
    let module = flight_models().module.clone();
    let (explicit, _) = passes::explicit(module).unwrap_or_else(|errors| panic!("{errors:?}"));
    let is_entry = |it: &bessemer_ir::Function| {
        let owner = it.owner.map(|owner| match owner {
            Owner::Struct(id) => explicit.structs[id.index()].name.as_str(),
            Owner::Enum(id) => explicit.enums[id.index()].name.as_str(),
        });
        owner == Some("Onboard") && it.name == "step"
    };
    let place = explicit.functions.iter().position(is_entry).expect("the entry point");
    let text = bessemer_vectors::emit(&explicit, &[FunctionId(place as u32)]);
    let text = text.unwrap_or_else(|error| panic!("{error}"));
    let renewal = "UPDATE_DOCS=1 cargo test -p bessemer-tests vectors::";
    assert!(golden::holds(Path::new(TEXT), &text), "{TEXT} is stale: {renewal}");
}
