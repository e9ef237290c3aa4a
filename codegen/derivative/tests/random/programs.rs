//! Random functions of a vector, a number and a count, as text of the IR.

use std::fmt::Write as _;

/// Random numbers of a seed.
pub struct Random(pub u64);

impl Random {
    /// Returns a number below a limit.
    pub fn below(&mut self, limit: u64) -> u64 {
        self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        let mixed = (self.0 ^ (self.0 >> 29)).wrapping_mul(0x9E37_79B9_7F4A_7C15);
        (mixed >> 33) % limit
    }
}

struct Writer {
    random: Random,
    text: String,
    depth: usize,
    /// Counters of the loops around.
    counters: Vec<String>,
    names: u32,
    in_helper: bool,
    /// True within a loop that is too long to be unrolled, which cannot return.
    long: bool,
}

/// Returns a module: `subject` and the declaration of its derivative, `jacobian`.
pub fn program(seed: u64) -> String {
    let mut writer = Writer {
        random: Random(seed.wrapping_mul(0x2545_F491_4F6C_DD1D).wrapping_add(7)),
        text: String::new(),
        depth: 1,
        counters: Vec::new(),
        names: 0,
        in_helper: true,
        long: false,
    };
    writer.text.push_str(
        "module demo\n\
         struct Pair in demo { first: f64, second: matrix<f64, 1, 3>, third: f64 }\n\
         struct Slopes in demo { first: f64, second: matrix<f64, 3, 1>, third: f64 }\n\
         struct Triple in demo { first: matrix<f64, 3, 1>, second: matrix<f64, 3, 3>, third: matrix<f64, 3, 1> }\n\
         fn helper in demo(x: &matrix<f64, 3, 1>, y: f64, n: usize, table: &mut [f64; 4]) -> f64 as result {\n",
    );
    writer.function();
    writer.text.push_str("}\n");
    let vector = writer.random.below(2) == 1;
    let (ty, pair) = if vector { ("matrix<f64, 3, 1>", "Triple") } else { ("f64", "Pair") };
    writer.in_helper = false;
    let face = "(x: &matrix<f64, 3, 1>, y: f64, n: usize)";
    let _ = writeln!(writer.text, "fn subject in demo{face} -> {ty} as result {{");
    writer.text.push_str("  let table: [f64; 4] = [0.5, y, x[1, 0], 2.0];\n");
    writer.result_is_vector(vector);
    writer.text.push_str("}\n");
    let zero = match vector {
        true => "first: x, second: splat<3, 3>(0.0), third: x",
        false => "first: y, second: splat<1, 3>(0.0), third: y",
    };
    let _ = writeln!(
        writer.text,
        "fn jacobian in demo{face} -> {pair} as result {{\n  return struct {pair} {{ {zero} }};\n}}"
    );
    if !vector {
        let _ = writeln!(writer.text, "fn gradient in demo{face} -> Slopes as result {{\n}}");
    }
    writer.text
}

/// Returns arguments of some calls.
pub fn calls(seed: u64) -> Vec<Vec<Vec<u64>>> {
    let mut random = Random(seed ^ 0x5851_F42D_4C95_7F2D);
    let mut number = || (random.below(4001) as f64 - 2000.0) / 1024.0;
    let mut all = Vec::new();
    for n in 0..4 {
        let x = (0..3).map(|_| number().to_bits()).collect();
        all.push(vec![x, vec![number().to_bits()], vec![n]]);
    }
    all
}

impl Writer {
    fn line(&mut self, text: &str) {
        for _ in 0..self.depth {
            self.text.push_str("  ");
        }
        self.text.push_str(text);
        self.text.push('\n');
    }

    fn chance(&mut self, one_in: u64) -> bool {
        self.random.below(one_in) == 0
    }

    fn function(&mut self) {
        self.locals();
        self.statements(4);
        let value = self.number(2);
        self.line(&format!("return {value};"));
    }

    fn locals(&mut self) {
        for name in ["a", "b", "c"] {
            let value = self.number_of(1, 0);
            self.line(&format!("let {name}: f64 = {value};"));
        }
        self.line("let v: matrix<f64, 3, 1> = x.scale(y);");
        self.line("let m: matrix<f64, 3, 3> = matrix<3, 3>(1.0, 0.0, y, 0.0, 0.5, 0.0, x[0, 0], 0.0, 1.0);");
        self.line("let k: usize = n;");
    }

    fn result_is_vector(&mut self, vector: bool) {
        self.locals();
        // An early end must have the function's type.
        self.long = vector;
        self.statements(5);
        self.long = false;
        match vector {
            true => {
                let value = self.vector(2);
                self.line(&format!("return {value};"));
            }
            false => {
                let value = self.number(2);
                self.line(&format!("return {value};"));
            }
        }
    }

    fn statements(&mut self, count: u64) {
        for _ in 0..1 + self.random.below(count) {
            self.statement();
        }
    }

    fn scalar(&mut self) -> &'static str {
        ["a", "b", "c"][self.random.below(3) as usize]
    }

    fn statement(&mut self) {
        let name = self.scalar();
        match self.random.below(if self.depth > 4 { 6 } else { 12 }) {
            0..=2 => {
                let value = self.number(3);
                self.line(&format!("{name} = {value};"));
            }
            3 => {
                let (at, value) = (self.index(4), self.number(2));
                self.line(&format!("table[{at}] = {value};"));
            }
            4 => {
                let value = self.vector(2);
                self.line(&format!("v = {value};"));
            }
            5 if !self.in_helper => {
                let value = self.number(1);
                let count = self.random.below(4);
                self.line(&format!("{name} = helper(&v, {value}, {count}, &mut table);"));
            }
            5 => self.line("k = (k + 1) % 4;"),
            6 | 7 => self.branch(),
            8 => {
                let (row, col) = (self.index(3), self.index(3));
                let value = self.number(2);
                self.line(&format!("m[{row}, {col}] = {value};"));
            }
            9 => {
                self.line("match k {");
                self.depth += 1;
                self.line("0 => {");
                self.inside();
                self.line("}");
                self.line("1, 2 => {");
                self.inside();
                self.line("}");
                self.line("_ => {");
                self.inside();
                self.line("}");
                self.depth -= 1;
                self.line("}");
            }
            _ => self.repeat(),
        }
    }

    fn inside(&mut self) {
        self.depth += 1;
        self.statements(2);
        self.depth -= 1;
    }

    fn branch(&mut self) {
        let condition = self.condition(2);
        self.line(&format!("if {condition} {{"));
        self.inside();
        self.depth += 1;
        match self.random.below(6) {
            0 if !self.counters.is_empty() => self.line("break;"),
            1 if !self.counters.is_empty() => self.line("continue;"),
            2 if !self.long => {
                let value = self.number(2);
                self.line(&format!("return {value};"));
            }
            _ => {}
        }
        self.depth -= 1;
        if self.chance(2) {
            self.line("} else {");
            self.inside();
        }
        self.line("}");
    }

    fn repeat(&mut self) {
        self.names += 1;
        let counter = format!("at{}", self.names);
        let end = ["n", "3", "2", "k", "35"][self.random.below(5) as usize];
        let reversed = if self.chance(3) { "rev " } else { "" };
        let long = self.long;
        self.long |= !matches!(end, "2" | "3");
        // A count that is not small in a loop within another takes long.
        let end = if self.counters.is_empty() || end != "35" { end } else { "2" };
        self.line(&format!("for {counter}: usize in {reversed}0..{end} {{"));
        self.counters.push(counter);
        self.inside();
        self.counters.pop();
        self.line("}");
        self.long = long;
    }

    fn index(&mut self, limit: u64) -> String {
        let counter = self.counters.last().cloned();
        match (counter, self.random.below(4)) {
            (Some(counter), 0 | 1) => format!("{counter} % {limit}"),
            (_, 2) => format!("k % {limit}"),
            _ => self.random.below(limit).to_string(),
        }
    }

    fn condition(&mut self, depth: u32) -> String {
        match self.random.below(5) {
            0 if depth > 0 => {
                format!("{} && {}", self.condition(depth - 1), self.condition(depth - 1))
            }
            1 if depth > 0 => {
                format!("({} || {})", self.condition(depth - 1), self.condition(depth - 1))
            }
            2 => format!("k < {}", self.random.below(4)),
            3 => format!("{} > {}", self.number(1), self.number(1)),
            _ => format!("{} <= {}", self.number(1), self.number(1)),
        }
    }

    fn number(&mut self, depth: u32) -> String {
        self.number_of(depth, 3)
    }

    /// Returns a number; `declared` locals may be read.
    fn number_of(&mut self, depth: u32, declared: u64) -> String {
        let next = |writer: &mut Self| writer.number_of(depth.saturating_sub(1), declared);
        if depth == 0 || self.chance(4) {
            return match self.random.below(6 + declared) {
                0 | 1 => format!("x[{}, 0]", self.random.below(3)),
                2 => "y".to_owned(),
                3 => "n as f64".to_owned(),
                4 => format!("{:?}", (self.random.below(33) as f64 - 16.0) / 8.0)
                    .replace('-', "0.0 - "),
                5 if declared > 0 => {
                    let at = self.index(4);
                    format!("table[{at}]")
                }
                6 => self.scalar().to_owned(),
                7 => {
                    let at = self.index(3);
                    format!("v[{at}, 0]")
                }
                _ if declared > 0 => {
                    let (row, col) = (self.index(3), self.index(3));
                    format!("m[{row}, {col}]")
                }
                _ => "1.5".to_owned(),
            };
        }
        match self.random.below(14) {
            0 | 1 => format!("({} + {})", next(self), next(self)),
            2 => format!("({} - {})", next(self), next(self)),
            3..=5 => format!("({}) * ({})", next(self), next(self)),
            6 => {
                let (a, b) = (next(self), next(self));
                format!("({a}) / (1.0 + ({b}) * ({b}))")
            }
            7 => format!("({}).min({})", next(self), next(self)),
            8 => format!("({}).abs()", next(self)),
            9 => {
                let a = next(self);
                format!("(1.0 + ({a}) * ({a})).sqrt()")
            }
            10 => format!("({}).clamp(0.0 - 0.5, 1.25)", next(self)),
            11 => format!("-({})", next(self)),
            12 if declared > 0 => match self.random.below(4) {
                0 => "v.dot(x)".to_owned(),
                1 => "(1.0 + v.norm())".to_owned(),
                2 => format!("({}).copysign({})", next(self), next(self)),
                _ => format!("({}) % 1.5", next(self)),
            },
            _ => format!("({}).floor()", next(self)),
        }
    }

    fn vector(&mut self, depth: u32) -> String {
        if depth == 0 {
            return ["x", "v"][self.random.below(2) as usize].to_owned();
        }
        match self.random.below(7) {
            0 => format!("({}).add({})", self.vector(depth - 1), self.vector(depth - 1)),
            1 => format!("({}).scale({})", self.vector(depth - 1), self.number(1)),
            2 => format!("m.product({})", self.vector(depth - 1)),
            3 => format!("m.transpose().product({})", self.vector(depth - 1)),
            4 => format!("({}).cross({})", self.vector(depth - 1), self.vector(depth - 1)),
            5 => {
                format!("matrix<3, 1>({}, {}, {})", self.number(1), self.number(1), self.number(1))
            }
            _ => format!("({}).neg()", self.vector(depth - 1)),
        }
    }
}
