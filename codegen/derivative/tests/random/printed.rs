//! Text of derivatives: two statements or two conditions that are written as one.

use bessemer_derivative::body;
use bessemer_ir::text::parse;

use crate::with_derivative;

/// Returns the text of the Jacobian of a function of `first` and `y` with these statements.
fn printed(first: &str, statements: &str) -> String {
    let text = format!(
        "module demo\n\
         struct Triple in demo {{ value: f64, by_first: f64, by_second: f64 }}\n\
         fn sin in bessemer::math(x: f64) -> f64 as sine {{\nreturn x;\n}}\n\
         fn cos in bessemer::math(x: f64) -> f64 as cosine {{\nreturn x;\n}}\n\
         fn subject in demo({first}: f64, y: f64) -> f64 as result {{\n{statements}\n}}\n\
         fn jacobian in demo({first}: f64, y: f64) -> Triple as result {{\n\
           return struct Triple {{ value: 0.0, by_first: 0.0, by_second: 0.0 }};\n\
         }}\n"
    );
    let module = parse(&text).unwrap_or_else(|error| panic!("{error}"));
    let (module, function) = with_derivative(&module).expect("it has a derivative");
    body(&module, &function)
}

/// The sine and the cosine of one angle are one call, whichever the function has.
#[test]
fn sine_and_cosine_of_an_angle_are_computed_together() {
    for call in ["sin(x)", "cos(x)"] {
        let text = printed("x", &format!("return {call} * y;"));
        assert!(text.contains("let sin_cos_x = x.sin_cos();"), "{text}");
        assert!(text.contains("sin_cos_x.0") && text.contains("sin_cos_x.1"), "{text}");
        assert!(!text.contains(".sin()") && !text.contains(".cos()"), "{text}");
    }
    let text = printed("x", "return sin(x) * cos(y);");
    assert!(text.contains("x.sin_cos()") && text.contains("y.sin_cos()"), "{text}");
}

/// One alone stays alone, as do two of different angles, and two for which the name is taken.
#[test]
fn sine_and_cosine_of_other_angles_are_separate() {
    let text = printed("x", "if sin(x) < 0.5 {\nreturn y;\n}\nreturn x;");
    assert!(text.contains("x.sin()") && !text.contains("sin_cos"), "{text}");
    let text = printed("x", "if sin(x) < cos(y) {\nreturn y;\n}\nreturn x;");
    assert!(text.contains("x.sin()") && text.contains("y.cos()"), "{text}");
    assert!(!text.contains("sin_cos"), "{text}");
    let text = printed("sin_cos_y", "return sin(y) * sin_cos_y;");
    assert!(text.contains("y.sin()") && text.contains("y.cos()"), "{text}");
}

/// Two conditions on one number are a range; those on two numbers, and of another order, are not.
#[test]
fn a_number_between_two_ends_is_in_a_range() {
    let of =
        |condition: &str| printed("x", &format!("if {condition} {{\nreturn y;\n}}\nreturn x;"));
    let text = of("0.5 <= x && x < 1.5");
    assert!(text.contains("if (0.5..1.5).contains(&x) {"), "{text}");
    for other in ["0.5 <= x && y < 1.5", "0.5 < x && x < 1.5", "0.5 <= x && x <= 1.5"] {
        let text = of(other);
        assert!(!text.contains("contains"), "{text}");
    }
}
