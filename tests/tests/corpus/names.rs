//! Names of functions: no unrelated item moves them.

use bessemer_ir::Owner;
use bessemer_tests::corpus;

/// Copies for closures carry the name of the instance that hands these over, and no number.
#[test]
fn no_instance_names_the_copies_of_another() {
    let module = &corpus().module;
    let of_program = |it: &&bessemer_ir::Function| it.module.ends_with("::copies_of_instances");
    let name = |it: &bessemer_ir::Function| match it.owner {
        Some(Owner::Struct(id)) => format!("{}::{}", module.structs[id.index()].name, it.name),
        _ => it.name.clone(),
    };
    let mut names: Vec<String> = module.functions.iter().filter(of_program).map(name).collect();
    names.sort();
    let copies = |of: &str| [format!("{of}::sort_by_in_step"), format!("{of}::step")];
    let methods = ["Middle_3", "Middle_5"].into_iter().flat_map(copies);
    let free = ["middle_3", "middle_5"].map(str::to_owned);
    let free = free.into_iter().chain(["3", "5"].map(|n| format!("sort_by_in_middle_{n}")));
    let expected: Vec<String> = methods.chain(["Middles::step".to_owned()]).chain(free).collect();
    assert_eq!(names, expected);
}

/// A state has its indices in the header of sizes, and a generic one in each instance.
#[test]
fn indices_of_states_are_in_the_header_of_sizes() {
    let header = corpus().files.iter().map(|file| file.text.as_str());
    let header = header.filter(|text| text.contains("STATES_MOTION_ERRORS")).collect::<String>();
    for index in [
        "STATES_MOTION_VELOCITY UINT64_C(3)",
        "STATES_SINGLE_AXIS_ANGLE UINT64_C(0)",
        "STATES_SINGLE_AXIS_RATES UINT64_C(1)",
        "STATES_SINGLE_AXIS_ERRORS UINT64_C(3)",
        "STATES_AXIS_F64_RATES UINT64_C(1)",
    ] {
        assert!(header.contains(&format!("#define {index}")), "{index} in\n{header}");
    }
}
