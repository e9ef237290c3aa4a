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
