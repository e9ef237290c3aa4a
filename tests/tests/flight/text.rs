//! The text form of the IR, on the real models: prints, and parses back to the same IR.

use bessemer_ir::text;
use bessemer_tests::flight_models;

#[test]
fn the_flight_models_read_back_as_they_were() {
    let compiled = flight_models();
    for module in [&compiled.module, &compiled.explicit] {
        let printed = text::print(module);
        let parsed = text::parse(&printed).unwrap_or_else(|error| panic!("{error:?}"));
        assert_eq!(&parsed, module);
        assert_eq!(text::print(&parsed), printed);
    }
}

/// The height loop as IR: the form in which a failing program is reported and kept.
#[test]
fn the_text_can_be_read() {
    let printed = text::print(&flight_models().module);
    let start = printed.find("Height.step").or_else(|| printed.find("step")).expect("the entry");
    assert!(printed[start..].contains("let weight"), "{printed}");
}
