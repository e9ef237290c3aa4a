//! Random modules of statements over the elements of vectors that one loop computes, or narrowly cannot. Factors are elements and
//! magnitudes that other statements write, rows of an array may be one row, and calls and checks are between.

use std::fmt::Write as _;

use bessemer_ir::{Module, text};

use crate::generate::Random;

/// Type of each vector.
const VECTOR: &str = "matrix<f64, 6, 1>";

/// A module of such functions.
pub fn module(seed: u64, functions: usize) -> Module {
    let mut random = Random::new(seed);
    let mut text = format!(
        "module vectors\nfile \"a.rs\"\n\n@0:1:1 struct Vectors in vectors {{\n  a: {VECTOR},\n  b: {VECTOR},\n  \
         rows: [{VECTOR}; 3],\n  worst: f64,\n}}\n\n@0:2:1 fn touch in vectors(a: &mut {VECTOR}) {{\n  \
         @0:3:1 a[1, 0] = a[2, 0] + 1.0;\n}}\n\n"
    );
    (0..functions).for_each(|index| text += &Body::new(&mut random).function(index));
    text::parse(&text).unwrap_or_else(|why| panic!("seed {seed}: {why}\n{text}"))
}

/// Statements of a function, and the names that they declare.
struct Body<'r> {
    random: &'r mut Random,
    text: String,
    vectors: Vec<String>,
    numbers: Vec<String>,
}

impl Body<'_> {
    fn new(random: &mut Random) -> Body<'_> {
        let vectors = ["v.a", "v.b", "v.rows[i]", "v.rows[j]", "v.rows[1]", "p", "made"];
        let numbers = ["x", "v.worst", "0.5"];
        Body {
            random,
            text: String::new(),
            vectors: vectors.map(str::to_owned).to_vec(),
            numbers: numbers.map(str::to_owned).to_vec(),
        }
    }

    fn function(mut self, index: usize) -> String {
        let first = self.number();
        for line in 0..4 + self.random.below(5) {
            let before = self.text.len();
            self.statement(line);
            let at = format!("    @0:{}:1 ", index * 100 + line + 10);
            self.text.insert_str(before, &at);
        }
        format!(
            "@0:{line}:1 fn run{index} in vectors(v: &mut Vectors, p: &{VECTOR}, x: f64) -> {VECTOR} as made {{\n  \
             let made: {VECTOR} = p.scale({first});\n  for i: usize in 0..3 {{\n  for j: usize in 0..2 {{\n{body}  }}\n  }}\n  \
             return made;\n}}\n\n",
            line = index * 100 + 5,
            body = self.text,
        )
    }

    fn statement(&mut self, line: usize) {
        let value = self.value(2);
        let _ = match self.random.below(12) {
            0..3 => {
                let name = format!("t{line}");
                let text = writeln!(self.text, "let {name}: {VECTOR} = {value};");
                self.vectors.push(name);
                text
            }
            3..6 => {
                let place = self.place();
                writeln!(self.text, "{place} = {value};")
            }
            6 => {
                let (place, from) = (self.place(), self.vector());
                writeln!(self.text, "{place} = {from};")
            }
            7 => {
                let name = format!("m{line}");
                let text = writeln!(self.text, "let {name}: f64 = {value}.amax();");
                self.numbers.push(name);
                text
            }
            8 | 9 => {
                let factor = self.number();
                writeln!(self.text, "v.worst = v.worst.max({value}.amax() * {factor});")
            }
            10 => {
                let number = self.number();
                writeln!(self.text, "v.worst = v.worst + {number};")
            }
            _ if self.random.chance(50) => writeln!(self.text, "touch(&mut v.a);"),
            _ => writeln!(self.text, "check v.worst < 1000000.0 else assertion;"),
        };
    }

    /// A vector that a statement may read.
    fn vector(&mut self) -> String {
        // The latest most, so that statements share vectors.
        let latest = self.vectors.len().saturating_sub(3);
        match self.random.chance(50) {
            true => self.random.pick(&self.vectors[latest..]).clone(),
            false => self.random.pick(&self.vectors).clone(),
        }
    }

    /// A vector that a statement may write.
    fn place(&mut self) -> String {
        let places: Vec<String> = self.vectors.iter().filter(|it| *it != "p").cloned().collect();
        self.random.pick(&places).clone()
    }

    fn number(&mut self) -> String {
        match self.random.below(4) {
            0 => format!("{}[{}, 0]", self.random.pick(&["v.a", "v.b", "p"]), self.random.below(6)),
            1 => self.numbers.last().cloned().unwrap_or_default(),
            _ => self.random.pick(&self.numbers).clone(),
        }
    }

    /// An element-wise value.
    fn value(&mut self, depth: usize) -> String {
        let left = match depth {
            0 => return self.vector(),
            _ => self.value(depth - 1),
        };
        match self.random.below(8) {
            0 => format!("{left}.neg()"),
            1 => format!("{left}.magnitudes()"),
            2 | 3 => format!("{left}.scale({})", self.number()),
            operation => {
                let name = ["add", "sub", "sup", "component_mul"][operation - 4];
                format!("{left}.{name}({})", self.value(depth - 1))
            }
        }
    }
}
