//! Prints the body of a derivative as Rust, for the module of its declaration.

use std::collections::{BTreeMap, BTreeSet};

use bessemer_ir::visit::{self, Access, Visit};
use bessemer_ir::{
    Argument, BinaryOp, Block, CompareOp, Expr, ExprKind, Float, Form, Function, Intrinsic,
    KernelRoutine, LocalId, LogicOp, Module, Place, Routine, Scalar, Step, StmtKind, Type, UnaryOp,
};

mod idioms;

use idioms::{CONSTANTS, special};

/// Returns the statements of a function's body, each on its line.
pub fn body(module: &Module, function: &Function) -> String {
    let mut assigned = Assigned::default();
    assigned.block(&function.body);
    let parts = BTreeMap::new();
    let mut printer = Printer { module, function, assigned, parts, text: String::new(), depth: 1 };
    printer.block(&function.body);
    printer.text
}

/// Returns a name as an identifier.
pub fn identifier(name: &str) -> String {
    let mut text: String =
        name.chars()
            .map(|it| {
                if it.is_ascii_alphanumeric() || it == '_' { it.to_ascii_lowercase() } else { '_' }
            })
            .collect();
    if text.starts_with(|it: char| it.is_ascii_digit()) || text.is_empty() {
        text.insert_str(0, "value_");
    }
    if KEYWORDS.contains(&text.as_str()) {
        text = if text == "self" { "this".to_owned() } else { format!("{text}_value") };
    }
    text
}

const KEYWORDS: [&str; 39] = [
    "as", "break", "const", "continue", "crate", "else", "enum", "extern", "false", "fn", "for",
    "if", "impl", "in", "let", "loop", "match", "mod", "move", "mut", "pub", "ref", "return",
    "self", "static", "struct", "super", "trait", "true", "type", "unsafe", "use", "where",
    "while", "async", "await", "dyn", "gen", "_",
];

/// Returns the name of a type in Rust, as code in module `from` writes it.
pub fn type_name(module: &Module, ty: &Type, from: &str) -> String {
    match ty {
        Type::Unit => "()".to_owned(),
        Type::Scalar(scalar) => scalar.name().to_owned(),
        Type::Array { element, len } => format!("[{}; {len}]", type_name(module, element, from)),
        Type::Matrix { element, rows, cols: 1 } => format!("SVector<{}, {rows}>", element.name()),
        Type::Matrix { element, rows, cols } => {
            format!("SMatrix<{}, {rows}, {cols}>", element.name())
        }
        Type::Struct(id) => {
            let of = &module.structs[id.index()];
            path(&of.module, &of.name, from)
        }
        Type::Enum(id) => {
            let of = &module.enums[id.index()];
            path(&of.module, &of.name, from)
        }
        Type::Slice(element) => format!("[{}]", type_name(module, element, from)),
    }
}

/// Returns the path of an item, as code in module `from` writes it.
fn path(module: &str, name: &str, from: &str) -> String {
    if module == from {
        return name.to_owned();
    }
    let (own, home) = (module.split("::").next(), from.split("::").next());
    match module.split_once("::") {
        Some((_, rest)) if own == home => format!("crate::{rest}::{name}"),
        None if own == home => format!("crate::{name}"),
        _ => format!("{module}::{name}"),
    }
}

/// Locals that are assigned, and those of which a part is.
#[derive(Default)]
struct Assigned {
    whole: BTreeSet<LocalId>,
    parts: BTreeSet<LocalId>,
}

impl Visit for Assigned {
    fn place(&mut self, place: &Place, access: Access) {
        if access != Access::Read {
            let is_whole = place.steps.is_empty() && access == Access::Write;
            let set = if is_whole { &mut self.whole } else { &mut self.parts };
            set.insert(place.root);
        }
        visit::walk_place(self, place);
    }
}

/// Precedences of Rust.
const LOWEST: u8 = 0;
const CAST: u8 = 10;
const PREFIX: u8 = 11;
const ATOM: u8 = 12;

struct Printer<'m> {
    module: &'m Module,
    function: &'m Function,
    assigned: Assigned,
    /// Texts of locals that are parts of a value with another name.
    parts: BTreeMap<LocalId, String>,
    text: String,
    depth: usize,
}

impl Printer<'_> {
    fn line(&mut self, text: &str) {
        for _ in 0..self.depth {
            self.text.push_str("    ");
        }
        self.text.push_str(text);
        self.text.push('\n');
    }

    fn inside(&mut self, block: &Block) {
        self.depth += 1;
        self.block(block);
        self.depth -= 1;
    }

    fn block(&mut self, block: &Block) {
        let mut rest = block.0.as_slice();
        while let [stmt, after @ ..] = rest {
            rest = after;
            if let [next, after @ ..] = after
                && let Some(text) = self.sine_and_cosine(&stmt.kind, &next.kind)
            {
                self.line(&text);
                rest = after;
                continue;
            }
            self.stmt(&stmt.kind, self.depth == 1 && rest.is_empty());
        }
    }

    fn stmt(&mut self, kind: &StmtKind, last: bool) {
        match kind {
            StmtKind::Let { local, value } => {
                let declared = self.function.local(*local);
                let (whole, parts) = (&self.assigned.whole, &self.assigned.parts);
                let again = whole.contains(local) && value.is_some();
                let mutable = if again || parts.contains(local) { "mut " } else { "" };
                let shown = match value {
                    None => true,
                    Some(value) => matches!(
                        value.kind,
                        ExprKind::Literal(_) | ExprKind::Splat(_) | ExprKind::Array(_)
                    ),
                };
                let ty = match shown {
                    true => {
                        let name = type_name(self.module, &declared.ty, &self.function.module);
                        format!(": {name}")
                    }
                    false => String::new(),
                };
                let value = match value {
                    Some(value) => format!(" = {}", self.expr(value, LOWEST)),
                    None => String::new(),
                };
                self.line(&format!("let {mutable}{}{ty}{value};", declared.name));
            }
            StmtKind::Assign { place, value } => {
                let text = format!("{} = {};", self.place(place), self.expr(value, LOWEST));
                self.line(&text);
            }
            StmtKind::Expr(expr) => {
                let text = format!("{};", self.expr(expr, LOWEST));
                self.line(&text);
            }
            StmtKind::If { condition, then, otherwise } => {
                self.branch(String::new(), condition, then, otherwise);
            }
            StmtKind::Match { scrutinee, arms, otherwise } => {
                let text = format!("match {} {{", self.expr(scrutinee, LOWEST));
                self.line(&text);
                self.depth += 1;
                for arm in arms {
                    let values: Vec<String> = arm
                        .values
                        .iter()
                        .map(|value| self.word(*value as u64, &scrutinee.ty, false))
                        .collect();
                    self.line(&format!("{} => {{", values.join(" | ")));
                    self.inside(&arm.body);
                    self.line("}");
                }
                if let Some(otherwise) = otherwise {
                    self.line("_ => {");
                    self.inside(otherwise);
                    self.line("}");
                }
                self.depth -= 1;
                self.line("}");
            }
            StmtKind::For { variable, from, to, inclusive, reversed, body, .. } => {
                let dots = if *inclusive { "..=" } else { ".." };
                let from = match from.kind {
                    ExprKind::Literal(word) if from.ty != Type::USIZE => {
                        self.word(word, &from.ty, true)
                    }
                    _ => self.expr(from, CAST),
                };
                let range = format!("{from}{dots}{}", self.expr(to, CAST));
                let range = if *reversed { format!("({range}).rev()") } else { range };
                let name = &self.function.local(*variable).name;
                let mut used = Used { local: *variable, found: false };
                used.block(body);
                let name = if used.found { name.as_str() } else { "_" };
                self.line(&format!("for {name} in {range} {{"));
                self.inside(body);
                self.line("}");
            }
            StmtKind::Check { condition, .. } => {
                let text = format!("assert!({});", self.expr(condition, LOWEST));
                self.line(&text);
            }
            StmtKind::Return(Some(value)) if last => {
                let text = self.expr(value, LOWEST);
                self.line(&text);
            }
            StmtKind::Return(Some(value)) => {
                let text = format!("return {};", self.expr(value, LOWEST));
                self.line(&text);
            }
            StmtKind::Return(None) => self.line("return;"),
            StmtKind::Break => self.line("break;"),
            StmtKind::Continue => self.line("continue;"),
        }
    }

    fn branch(&mut self, before: String, condition: &Expr, then: &Block, otherwise: &Block) {
        let (then, otherwise, condition) = match then.0.is_empty() {
            true => (otherwise, then, format!("!{}", self.expr(condition, PREFIX))),
            false => (then, otherwise, self.expr(condition, LOWEST)),
        };
        self.line(&format!("{before}if {condition} {{"));
        self.inside(then);
        match otherwise.0.as_slice() {
            [] => self.line("}"),
            [bessemer_ir::Stmt { kind: StmtKind::If { condition, then, otherwise }, .. }] => {
                self.branch("} else ".to_owned(), condition, then, otherwise);
            }
            _ => {
                self.line("} else {");
                self.inside(otherwise);
                self.line("}");
            }
        }
    }

    fn place(&self, place: &Place) -> String {
        let local = self.function.local(place.root);
        let mut text = self.parts.get(&place.root).unwrap_or(&local.name).clone();
        let mut ty = local.ty.clone();
        for step in &place.steps {
            match step {
                Step::Field(field) => text.push_str(&field_of(self.module, &ty, *field)),
                Step::Index(index) => text.push_str(&format!("[{}]", self.index(index))),
                Step::Element(row, col) => match ty {
                    Type::Matrix { cols: 1, .. } => {
                        text.push_str(&format!("[{}]", self.index(row)));
                    }
                    _ => {
                        let (row, col) = (self.index(row), self.index(col));
                        text.push_str(&format!("[({row}, {col})]"));
                    }
                },
                Step::From(first) => text.push_str(&format!("[{}..]", self.index(first))),
            }
            ty = self.module.step_type(&ty, step).unwrap_or(Type::Unit);
        }
        text
    }

    fn index(&self, index: &Expr) -> String {
        match index.ty == Type::USIZE {
            true => self.expr(index, LOWEST),
            false => format!("{} as usize", self.expr(index, CAST)),
        }
    }

    /// Returns a word of a type; with `suffix` its type shows.
    fn word(&self, word: u64, ty: &Type, suffix: bool) -> String {
        let text = match ty {
            Type::Scalar(Scalar::Bool) => return (word != 0).to_string(),
            Type::Scalar(Scalar::Int(int)) => int.from_word(word).to_string(),
            Type::Scalar(Scalar::Float(Float::F64)) => {
                let value = f64::from_bits(word);
                if let Some((_, name)) = CONSTANTS.iter().find(|it| it.0.to_bits() == word) {
                    return format!("core::f64::consts::{name}");
                }
                match value.is_finite() {
                    true => format!("{value:?}"),
                    false => return special(value, "f64"),
                }
            }
            Type::Scalar(Scalar::Float(Float::F32)) => {
                let value = f32::from_bits(word as u32);
                let is = |it: &&(f64, &str)| (it.0 as f32).to_bits() == value.to_bits();
                if let Some((_, name)) = CONSTANTS.iter().find(is) {
                    return format!("core::f32::consts::{name}");
                }
                match value.is_finite() {
                    true => format!("{value:?}"),
                    false => return special(value.into(), "f32"),
                }
            }
            Type::Enum(id) => {
                let of = &self.module.enums[id.index()];
                let name = path(&of.module, &of.name, &self.function.module);
                let variant = of.variants.get(word as usize).map_or("", |it| it.name.as_str());
                return format!("{name}::{variant}");
            }
            _ => return "()".to_owned(),
        };
        match ty {
            Type::Scalar(scalar) if suffix => format!("{text}_{}", scalar.name()),
            _ => text,
        }
    }

    fn expr(&self, expr: &Expr, least: u8) -> String {
        let (text, precedence) = self.with_precedence(expr);
        if precedence < least { format!("({text})") } else { text }
    }

    fn list<'e>(&self, all: impl IntoIterator<Item = &'e Expr>) -> String {
        let all: Vec<String> = all.into_iter().map(|it| self.expr(it, LOWEST)).collect();
        all.join(", ")
    }

    /// Returns a receiver of a method.
    fn receiver(&self, expr: &Expr) -> String {
        match expr.kind {
            ExprKind::Literal(word) => {
                let text = self.word(word, &expr.ty, true);
                if text.starts_with('-') { format!("({text})") } else { text }
            }
            _ => self.expr(expr, ATOM),
        }
    }

    fn method(&self, name: &str, operands: &[&Expr]) -> (String, u8) {
        let Some((first, rest)) = operands.split_first() else { return (name.to_owned(), ATOM) };
        let rest = self.list(rest.iter().copied());
        (format!("{}.{name}({rest})", self.receiver(first)), ATOM)
    }

    fn infix(&self, mark: &str, precedence: u8, a: &Expr, b: &Expr) -> (String, u8) {
        let left = if precedence == COMPARE { precedence + 1 } else { precedence };
        let (a, b) = (self.expr(a, left), self.expr(b, precedence + 1));
        (format!("{a} {mark} {b}"), precedence)
    }

    fn with_precedence(&self, expr: &Expr) -> (String, u8) {
        match &expr.kind {
            ExprKind::Literal(word) => {
                let text = self.word(*word, &expr.ty, false);
                let precedence = if text.starts_with('-') { PREFIX } else { ATOM };
                (text, precedence)
            }
            ExprKind::Const(id) => {
                let constant = &self.module.consts[id.index()];
                let is_name = constant.module == self.function.module
                    && constant.name.chars().all(|it| it.is_ascii_alphanumeric() || it == '_');
                match (is_name, constant.words.first()) {
                    (false, Some(word)) => (self.word(*word, &expr.ty, false), PREFIX),
                    _ => (constant.name.clone(), ATOM),
                }
            }
            ExprKind::Load(place) => {
                let text = self.place(place);
                let whole = place.steps.is_empty() && !place.ty.is_word();
                let by_reference =
                    whole && self.function.local(place.root).mode == bessemer_ir::Mode::Ref;
                if by_reference { (format!("*{text}"), PREFIX) } else { (text, ATOM) }
            }
            ExprKind::Unary(op, operand) => {
                let mark = if *op == UnaryOp::Neg { "-" } else { "!" };
                (format!("{mark}{}", self.expr(operand, PREFIX)), PREFIX)
            }
            ExprKind::Binary(op, a, b) => {
                let (mark, precedence) = binary(*op);
                self.infix(mark, precedence, a, b)
            }
            ExprKind::Compare(op, a, b) => self.infix(comparison(*op), COMPARE, a, b),
            ExprKind::Logic(LogicOp::And, a, b) => match self.within(a, b) {
                Some(text) => (text, ATOM),
                None => self.infix("&&", 2, a, b),
            },
            ExprKind::Logic(LogicOp::Or, a, b) => self.infix("||", 1, a, b),
            ExprKind::Cast(operand) => {
                let ty = type_name(self.module, &expr.ty, &self.function.module);
                let operand = match operand.kind {
                    ExprKind::Literal(word) => self.word(word, &operand.ty, true),
                    _ => self.expr(operand, CAST),
                };
                (format!("{operand} as {ty}"), CAST)
            }
            ExprKind::Intrinsic(op, operands) => {
                let all: Vec<&Expr> = operands.iter().collect();
                match (op, all.as_slice()) {
                    (Intrinsic::FromBits, [bits]) => {
                        let ty = type_name(self.module, &expr.ty, &self.function.module);
                        (format!("{ty}::from_bits({})", self.expr(bits, LOWEST)), ATOM)
                    }
                    (Intrinsic::RawBits, all) => self.method("to_bits", all),
                    (Intrinsic::Variant, [value]) => self.with_precedence(value),
                    (op, all) => {
                        let names = bessemer_ir::text::INTRINSICS;
                        let name = names.iter().find(|it| it.1 == *op).map_or("", |it| it.0);
                        self.method(name, all)
                    }
                }
            }
            ExprKind::Call(callee, arguments) => {
                let callee = &self.module.functions[callee.index()];
                if let Some(kernel) = &callee.kernel {
                    return self.kernel(kernel.routine, arguments);
                }
                let all: Vec<&Expr> = arguments
                    .iter()
                    .filter_map(|it| match it {
                        Argument::Value(value) | Argument::Ref(value) => Some(value),
                        Argument::RefMut(_) => None,
                    })
                    .collect();
                let single = callee.result == Type::F32;
                let name = callee.name.strip_suffix('f').filter(|_| single);
                self.method(name.unwrap_or(&callee.name), &all)
            }
            ExprKind::Struct(parts) => match &expr.ty {
                Type::Struct(_) if expr.ty == self.function.result => {
                    (format!("({})", self.list(parts)), ATOM)
                }
                Type::Struct(id) => {
                    let of = &self.module.structs[id.index()];
                    let name = path(&of.module, &of.name, &self.function.module);
                    let fields = of.fields.iter().zip(parts).map(|(field, value)| {
                        let value = self.expr(value, LOWEST);
                        match value == field.name {
                            true => value,
                            false => format!("{}: {value}", field.name),
                        }
                    });
                    let fields: Vec<String> = fields.collect();
                    (format!("{name} {{ {} }}", fields.join(", ")), ATOM)
                }
                _ => (format!("({})", self.list(parts)), ATOM),
            },
            ExprKind::Array(parts) => (format!("[{}]", self.list(parts)), ATOM),
            ExprKind::Matrix(parts) => match &expr.ty {
                Type::Matrix { rows, cols, .. } if *cols > 1 => {
                    let (rows, cols) = (*rows as usize, *cols as usize);
                    let row = |row: usize| self.list((0..cols).map(|col| &parts[row + col * rows]));
                    let all: Vec<String> = (0..rows).map(row).collect();
                    (format!("matrix![{}]", all.join("; ")), ATOM)
                }
                _ => (format!("vector![{}]", self.list(parts)), ATOM),
            },
            ExprKind::Splat(operand) => match (&expr.ty, crate::known(operand)) {
                (Type::Array { len, .. }, _) => {
                    (format!("[{}; {len}]", self.expr(operand, LOWEST)), ATOM)
                }
                (Type::Matrix { cols: 1, .. }, Some(0.0)) => ("SVector::zeros()".to_owned(), ATOM),
                (_, Some(0.0)) => ("SMatrix::zeros()".to_owned(), ATOM),
                _ => (format!("SMatrix::repeat({})", self.expr(operand, LOWEST)), ATOM),
            },
            ExprKind::Routine(routine, operands) => self.routine(*routine, operands),
        }
    }

    /// Returns the call of a kernel.
    fn kernel(&self, routine: KernelRoutine, arguments: &[Argument]) -> (String, u8) {
        let path = match routine {
            KernelRoutine::LuSolve => "solve_mut",
            KernelRoutine::Solve => "solve_into",
            KernelRoutine::Inverse => "inverse_mut",
            KernelRoutine::Determinant => "linear::kernels::determinant",
            KernelRoutine::Cholesky => "linear::kernels::cholesky_mut",
            KernelRoutine::CholeskyLower => "linear::kernels::cholesky_lower",
            KernelRoutine::CholeskySolve => "linear::kernels::cholesky_solve_mut",
            KernelRoutine::SolveLower => "linear::kernels::solve_lower_mut",
            KernelRoutine::SolveUpper => "linear::kernels::solve_upper_mut",
            KernelRoutine::TrSolveLower => "linear::kernels::tr_solve_lower_mut",
            KernelRoutine::TrSolveUpper => "linear::kernels::tr_solve_upper_mut",
            // Products are operators.
            _ => "linear",
        };
        let all = arguments.iter().map(|argument| match argument {
            Argument::Value(value) => self.expr(value, LOWEST),
            Argument::Ref(value) => {
                let text = self.expr(value, PREFIX);
                text.strip_prefix('*').map_or_else(|| format!("&{text}"), str::to_owned)
            }
            Argument::RefMut(place) => format!("&mut {}", self.place(place)),
        });
        let all: Vec<String> = all.collect();
        (format!("bessemer::{path}({})", all.join(", ")), ATOM)
    }

    fn routine(&self, routine: Routine, operands: &[Expr]) -> (String, u8) {
        let all: Vec<&Expr> = operands.iter().collect();
        let [a, ..] = all.as_slice() else { return (String::new(), ATOM) };
        let b = all.get(1).copied().unwrap_or(a);
        let infix = |mark, precedence| self.infix(mark, precedence, a, b);
        let borrowed =
            |name: &str| (format!("{}.{name}(&{})", self.receiver(a), self.expr(b, PREFIX)), ATOM);
        match routine {
            Routine::Add => infix("+", 8),
            Routine::Sub => infix("-", 8),
            Routine::Neg => (format!("-{}", self.expr(a, PREFIX)), PREFIX),
            Routine::Scale | Routine::Product => infix("*", 9),
            Routine::Unscale => infix("/", 9),
            Routine::ComponentMul => borrowed("component_mul"),
            Routine::ComponentDiv => borrowed("component_div"),
            Routine::TrMul => borrowed("tr_mul"),
            Routine::Inf => borrowed("inf"),
            Routine::Sup => borrowed("sup"),
            Routine::Abs => self.method("abs", &[a]),
            Routine::Amax => self.method("amax", &[a]),
            Routine::Amin => self.method("amin", &[a]),
            Routine::Dot => borrowed("dot"),
            Routine::Cross => borrowed("cross"),
            Routine::Transpose => self.method("transpose", &[a]),
            Routine::Norm => self.method("norm", &[a]),
            Routine::NormSquared => self.method("norm_squared", &[a]),
        }
    }
}

struct Used {
    local: LocalId,
    found: bool,
}

impl Visit for Used {
    fn place(&mut self, place: &Place, _: Access) {
        self.found |= place.root == self.local;
        visit::walk_place(self, place);
    }
}

/// Precedence of comparisons.
const COMPARE: u8 = 3;

fn binary(op: BinaryOp) -> (&'static str, u8) {
    match op {
        BinaryOp::Add => ("+", 8),
        BinaryOp::Sub => ("-", 8),
        BinaryOp::Mul => ("*", 9),
        BinaryOp::Div => ("/", 9),
        BinaryOp::Rem => ("%", 9),
        BinaryOp::And => ("&", 6),
        BinaryOp::Or => ("|", 4),
        BinaryOp::Xor => ("^", 5),
        BinaryOp::Shl => ("<<", 7),
        BinaryOp::Shr => (">>", 7),
    }
}

fn comparison(op: CompareOp) -> &'static str {
    match op {
        CompareOp::Eq => "==",
        CompareOp::Ne => "!=",
        CompareOp::Lt => "<",
        CompareOp::Le => "<=",
        CompareOp::Gt => ">",
        CompareOp::Ge => ">=",
    }
}

/// Returns the text that reads a field; a `List` shows its length by a method, and its elements as they are.
fn field_of(module: &Module, ty: &Type, field: u32) -> String {
    let Type::Struct(id) = ty else { return ".".to_owned() };
    let of = &module.structs[id.index()];
    match (&of.form, field) {
        (Form::Sequence, 0) => ".len()".to_owned(),
        (Form::Sequence, _) => String::new(),
        _ => format!(".{}", of.fields.get(field as usize).map_or("", |it| it.name.as_str())),
    }
}
