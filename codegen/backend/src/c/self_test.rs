//! Emits a function that checks the target's arithmetic at run time.
//!
//! Its text is in `codegen/backend/templates/` and depends only on names. It has the guards of every other file, so
//! it detects the rest: a compiler that the guards do not detect, and the mode of the processor. It omits only the
//! checks that would prevent its own compilation.

use tera::{Context as Values, Tera};

use super::context::Context;
use super::file::CFile;
use super::options::Options;
use super::shell::{Shell, frame};
use super::spelling::identifier;

/// Returns header and source, if they are wanted.
pub fn files(context: Context<'_>, options: &Options) -> Vec<CFile> {
    if !options.self_test {
        return Vec::new();
    }
    let stem = identifier(&options.status);
    let (header, source) =
        (options.header(&format!("{stem}_self_test")), format!("{stem}_self_test.c"));
    let mut values = Values::new();
    values.insert("name", &format!("{}_SELF_TEST", stem.to_uppercase()));
    values.insert("stem", &stem);
    let file = |name: &str, template: &str, system: &[&str]| {
        let is_header = name == header;
        let shell = Shell {
            about: &[],
            file: name,
            header: &header,
            summary: "whether the target computes as the C needs it.",
            source: &context.module.name,
            license: &options.license,
            pragmas: options.pragmas,
            system_includes: system.iter().map(|&it| it.to_owned()).collect(),
            own_includes: Vec::new(),
            calls: false,
            refuses: false,
            computes: false,
        };
        let (before, after) = frame(&shell, is_header, is_header);
        let body = Tera::one_off(template, &values, false);
        let body = body.expect("the templates render: a test renders them");
        let gap = if is_header { "\n" } else { "" };
        let text = format!("{before}{}{gap}{after}", body.trim_end());
        CFile { name: name.to_owned(), text, map: Vec::new() }
    };
    let system = ["float.h", "math.h", "stdbool.h", "stdint.h", "string.h"];
    vec![
        file(&header, include_str!("../../templates/self_test.h.tera"), &["stdint.h"]),
        file(&source, include_str!("../../templates/self_test.c.tera"), &system),
    ]
}
