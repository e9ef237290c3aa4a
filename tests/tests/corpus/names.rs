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
