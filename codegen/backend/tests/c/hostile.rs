//! Invalid bytes for enums and `bool` in entry points without a status. Only the passed objects are touched, and each
//! byte acts as one of the variants.

use std::path::Path;
use std::process::Command;

use bessemer_backend::c::{CFile, Options, emit};
use bessemer_backend::passes::explicit;
use bessemer_backend::validate::validate;

use super::compilers::{folder, is_there, run};

const MODULE: &str = "module hostile

enum Gear in hostile { First, Second, Third }
enum Trim in hostile { Down = -1, Level = 0, Up = 1 }
enum Kind in hostile { A = 10, C = 30, B = 20 }

struct Input in hostile {
  gear: Gear,
  trim: Trim,
  kinds: [Kind; 2],
  flag: bool,
}

struct Box in hostile {
  hits: [i32; 3],
  gear: Gear,
} = [0 * 3, 0]

entry infallible fn Box::count in hostile(self: &mut Box, input: &Input) -> i32 as value {
  self.hits[input.gear as usize] = 1i32;
  self.hits[(input.trim as i8 + 1i8) as usize] = 2i32;
  if input.gear != Gear::Third {
    self.hits[input.gear as usize + 1] = 3i32;
  }
  let kind: Kind = load(input.kinds[1]);
  match kind {
    Kind::A => {
      self.hits[kind as usize - 9] = 4i32;
    }
    Kind::C, Kind::B => {
      self.hits[kind as usize / 10 - 1] = 5i32;
    }
  }
  self.hits[input.flag as usize + 1] = 7i32;
  self.gear = input.gear;
  return 100i32 / (input.kinds[0] as i32 - 5i32);
}

entry infallible fn Box::again in hostile(self: &mut Box, gear: Gear) -> i32 as value {
  self.hits[gear as usize] = 6i32;
  return load(self.hits[self.gear as usize]);
}
";

/// Calls with every byte, in objects between others that must stay as they are.
const MAIN: &str = r#"
#include <stdio.h>
#include <string.h>
#include "box.h"

typedef struct { unsigned char before[64]; box_t box; unsigned char after[64]; } guarded_t;

int main(void)
{
    for (int byte = -300; byte < 300; byte++) {
        guarded_t it;
        memset(&it, 0x5A, sizeof it);
        box_init(&it.box);
        input_t input;
        int written = byte;
        memcpy(&input.gear, &written, sizeof input.gear);
        memcpy(&input.trim, &written, sizeof input.trim);
        memcpy(&input.kinds[0], &written, sizeof input.kinds[0]);
        memcpy(&input.kinds[1], &written, sizeof input.kinds[1]);
        memcpy(&input.flag, &written, sizeof input.flag);
        gear_t gear;
        memcpy(&gear, &written, sizeof gear);
        int32_t first = box_count(&it.box, &input);
        int32_t second = box_again(&it.box, gear);
        for (unsigned at = 0; at < 64; at++) {
            if (it.before[at] != 0x5A || it.after[at] != 0x5A) {
                printf("byte %d reaches beyond\n", byte);
                return 1;
            }
        }
        printf("%d %d %d %d %d\n", (int)first, (int)second, (int)it.box.hits[0], (int)it.box.hits[1],
            (int)it.box.hits[2]);
    }
    return 0;
}
"#;

#[test]
fn no_byte_reaches_beyond_what_is_passed() {
    let module = bessemer_ir::text::parse(MODULE).expect("it parses");
    assert_eq!(validate(&module), Ok(()));
    let (explicit, _) = explicit(module).expect("the claims hold");
    let mut files = emit(&explicit, &Options::default());
    super::compilers::check("hostile", &files);
    files.push(CFile { name: "main.c".to_owned(), text: MAIN.to_owned(), map: Vec::new() });
    let folder = folder("hostile", &files);
    let mut said = Vec::new();
    for compiler in ["gcc", "clang"].into_iter().filter(|compiler| is_there(compiler)) {
        for level in ["-O0", "-O2", "-O3"] {
            said.push(ran(compiler, level, &folder));
        }
    }
    // They all take a byte for the same variant.
    assert!(said.windows(2).all(|pair| pair[0] == pair[1]));
}

/// An enum whose author chose the second variant. Its forms of `match` have all variants, `_` beside the chosen one, `_` in
/// its place, and an arm that leaves a loop; it is an index, too.
const CHOSEN: &str = "module chosen

enum Gear in chosen { First, Second #(fallback @0:0), Third }

struct Case in chosen {
  hits: [i32; 3],
} = [0 * 3]

entry infallible fn Case::all in chosen(self: &mut Case, gear: Gear) -> i32 as value {
  match gear {
    Gear::First => {
      return 1i32;
    }
    Gear::Second => {
      return 2i32;
    }
    Gear::Third => {
      return 3i32;
    }
  }
}

entry infallible fn Case::beside in chosen(self: &mut Case, gear: Gear) -> i32 as value {
  match gear {
    Gear::Second => {
      return 2i32;
    }
    _ => {
      return 1i32;
    }
  }
}

entry infallible fn Case::within in chosen(self: &mut Case, gear: Gear) -> i32 as value {
  match gear {
    Gear::Third => {
      return 3i32;
    }
    _ => {
      return 1i32;
    }
  }
}

entry infallible fn Case::left in chosen(self: &mut Case, gear: Gear) -> i32 as value {
  let passes: i32 = 0i32;
  for n: usize in 0..3 {
    match gear {
      Gear::First => {
        passes = 1i32;
      }
      Gear::Second => {
        break;
      }
      Gear::Third => {
        passes = 3i32;
      }
    }
  }
  return passes;
}

entry infallible fn Case::index in chosen(self: &mut Case, gear: Gear) -> i32 as value {
  self.hits[gear as usize] = 7i32;
  return load(self.hits[1]);
}
";

const CHOSEN_MAIN: &str = r#"
#include <stdio.h>
#include <string.h>
#include "case.h"

typedef int32_t (*entry_t)(case_t *self, gear_t gear);

int main(void)
{
    const entry_t entries[] = {case_all, case_beside, case_within, case_left, case_index};
    for (unsigned at = 0; at < sizeof entries / sizeof *entries; at++) {
        for (int byte = -300; byte < 300; byte++) {
            case_t one;
            case_t other;
            case_init(&one);
            case_init(&other);
            gear_t gear;
            memcpy(&gear, &byte, sizeof gear);
            const gear_t counts = (byte < 0 || byte > 2) ? GEAR_SECOND : gear;
            if (entries[at](&one, gear) != entries[at](&other, counts)) {
                printf("entry %u takes %d otherwise\n", at, byte);
                return 1;
            }
        }
    }
    return 0;
}
"#;

#[test]
fn an_invalid_value_counts_as_the_variant_that_the_author_chose() {
    let module = bessemer_ir::text::parse(CHOSEN).expect("it parses");
    assert_eq!(validate(&module), Ok(()));
    let (explicit, _) = explicit(module).expect("the claims hold");
    let mut files = emit(&explicit, &Options::default());
    super::compilers::check("chosen", &files);
    files.push(CFile { name: "main.c".to_owned(), text: CHOSEN_MAIN.to_owned(), map: Vec::new() });
    let folder = folder("chosen", &files);
    for compiler in ["gcc", "clang"].into_iter().filter(|compiler| is_there(compiler)) {
        for level in ["-O0", "-O2"] {
            assert_eq!(ran(compiler, level, &folder), "");
        }
    }
}

/// With a hook, a `switch` without a chosen variant has a case that calls it; what happens for a variant stays.
#[test]
fn an_invalid_value_calls_the_hook() {
    let module = CHOSEN.replace(" #(fallback @0:0)", "");
    let module = bessemer_ir::text::parse(&module).expect("it parses");
    let (explicit, _) = explicit(module).expect("the claims hold");
    let options = Options { hook: Some("motors_off".to_owned()), ..Options::default() };
    let files = emit(&explicit, &options);
    super::compilers::check("hooked", &files);
    let source = files.iter().find(|file| file.name == "case.c").expect("a source");
    let case =
        "default:\n        motors_off(BESSEMER_STATUS_VARIANT);\n        for (;;) {\n        }";
    assert!(source.text.contains(case), "{}", source.text);
}

fn ran(compiler: &str, level: &str, folder: &Path) -> String {
    let sources: Vec<_> = std::fs::read_dir(folder)
        .expect("just written")
        .map(|entry| entry.expect("readable").path())
        .filter(|path| path.extension().is_some_and(|end| end == "c"))
        .filter(|path| path.file_name().is_some_and(|name| name != "alone.c"))
        .collect();
    // What a sanitizer says of a byte that is no `bool` is what is tried here.
    let flags = ["-std=c99", "-ffp-contract=off", "-fsanitize=address,undefined", level];
    let sanitized = ["-fno-sanitize=bool,enum", "-fno-sanitize-recover=all", "-o", "program"];
    run(Command::new(compiler).args(flags).args(sanitized).args(sources).arg("-lm"), folder);
    let output = Command::new(folder.join("program")).output().expect("just compiled");
    let said = String::from_utf8_lossy(&output.stdout).into_owned();
    let told = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{compiler} {level}: {said}\n{told}");
    said
}
