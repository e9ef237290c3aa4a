//! Largest numbers of passes of the loops of the C, by their lines.
//!
//! Sources, of which the least counts: constant ends in the head of the loop; the loop of the explicit IR at the line of
//! Rust; for a slice, the longest array that is passed to a parameter of that name. Which line a loop of the machine code
//! comes from is known by the lines of its instructions: those of a `for` or `while`, without the ones within another
//! that is there, too. If several are left, as where a function was inlined, the one with the most passes counts. A loop
//! without a line is the compiler's copy of a struct, from a register to the constant that was added to it.

use std::collections::BTreeMap;

use bessemer_codegen::compile::Compiled;
use bessemer_codegen::estimate::{self, Estimate};
use bessemer_ir::visit::Walk as _;
use bessemer_ir::{Argument, Expr, ExprKind, Module, Place, Role, Type};

use super::assembly::{Block, Function};

/// File and line of the C.
pub type Line = (String, u32);

/// Largest number of passes of a loop.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Times {
    /// The line of its head, among those of other loops of the function; none if it may be the loop of another function.
    pub places: Vec<Line>,
    /// The number.
    pub most: u64,
    /// A loop around it whose counter it follows, and its numbers of passes, each for one value of the counter. The
    /// largest is the first.
    pub following: Option<(Line, Vec<u64>)>,
    /// Loops of the C within it, and their largest numbers of passes.
    pub within: Vec<(Line, u64)>,
}

impl From<u64> for Times {
    fn from(most: u64) -> Times {
        Times { most, ..Times::default() }
    }
}

/// The loops of the C.
#[derive(Default)]
pub struct Passes {
    /// By the line of the head.
    loops: BTreeMap<Line, Loop>,
}

/// A loop of the C.
struct Loop {
    last_line: u32,
    /// Number of functions before its own in the file.
    function: usize,
    passes: Option<u64>,
    following: Option<(Line, Vec<u64>)>,
}

/// A loop around others whose counter goes from a constant to another.
struct Counted {
    line: u32,
    last_line: u32,
    counter: String,
    values: std::ops::Range<u64>,
}

impl Passes {
    /// Finds the loops of the C.
    pub fn of(compiled: &Compiled) -> Passes {
        let estimates = estimate::estimates(&compiled.explicit);
        let of_rust = of_rust(&compiled.explicit, &estimates);
        let slices = slices(&compiled.explicit);
        let constants = constants(compiled);
        let mut loops = BTreeMap::new();
        for file in &compiled.files {
            let name = file.name.rsplit('/').next().unwrap_or(&file.name);
            let lines: Vec<&str> = file.text.lines().collect();
            let mut around: Vec<Counted> = Vec::new();
            let mut function_number = 0;
            for (at, line) in lines.iter().enumerate() {
                function_number += usize::from(*line == "}");
                let head = line.trim_start();
                if !head.starts_with("for (") && !head.starts_with("while (") {
                    continue;
                }
                let number = at as u32 + 1;
                let last_line = last_line(&lines, at);
                around.retain(|it| number <= it.last_line);
                let parsed = Head::of(head);
                let own = parsed.as_ref().and_then(|it| it.passes(&constants, &slices));
                let following = match own {
                    None => parsed.as_ref().and_then(|it| {
                        let of =
                            |outer: &Counted| Some((outer.line, it.passes_by(outer, &constants)?));
                        around.iter().rev().find_map(of)
                    }),
                    Some(_) => None,
                };
                let own = own.or_else(|| following.as_ref()?.1.first().copied());
                let row = file.map.iter().rev().find(|row| row.c_line <= number);
                let row = row.filter(|row| row.c_line == number);
                let of_ir = row.and_then(|row| {
                    of_rust.get(&(row.rust_file.clone(), row.rust_line)).copied().flatten()
                });
                let passes = match (own, of_ir) {
                    (Some(one), Some(other)) => Some(one.min(other)),
                    (one, other) => one.or(other),
                };
                if let Some(it) = parsed.as_ref().filter(|it| it.stays(&lines, at, last_line)) {
                    around.extend(it.counted(number, last_line, &constants));
                }
                let following = following.map(|(line, passes)| ((name.to_owned(), line), passes));
                let own = Loop { last_line, function: function_number, passes, following };
                loops.insert((name.to_owned(), number), own);
            }
        }
        Passes { loops }
    }

    /// Returns the largest number of passes of a loop of these blocks.
    ///
    /// # Errors
    /// The reason for none.
    pub fn of_loop(&self, function: &Function, blocks: &[usize]) -> Result<Times, String> {
        let places = blocks.iter().flat_map(|it| &function.blocks[*it].instructions);
        let mut places: Vec<&Line> = places.filter_map(|it| it.place.as_ref()).collect();
        places.sort_unstable();
        places.dedup();
        let found: Vec<_> =
            places.into_iter().filter_map(|it| self.loops.get_key_value(it)).collect();
        let is_within = |inner: &Line| {
            found.iter().any(|(outer, it)| {
                outer.0 == inner.0 && outer.1 < inner.1 && inner.1 <= it.last_line
            })
        };
        let mut times: Option<Times> = None;
        let own: Vec<_> = found.iter().filter(|it| !is_within(it.0)).collect();
        for (place, it) in &own {
            let most = it.passes.ok_or_else(|| {
                format!("the loop at {}:{} has no known number of passes", place.0, place.1)
            })?;
            times = Some(match times {
                None => Times { most, following: it.following.clone(), ..Times::default() },
                // Several that were inlined: which of them it is, is not known.
                Some(other) => Times::from(most.max(other.most)),
            });
        }
        if let Some(times) = &mut times {
            let inner = found.iter().filter(|it| is_within(it.0));
            times.within =
                inner.map(|(it, own)| ((*it).clone(), own.passes.unwrap_or(1))).collect();
        }
        if let (Some(times), Some((place, first))) = (&mut times, own.first())
            && own.iter().all(|(it, other)| (&it.0, other.function) == (&place.0, first.function))
        {
            times.places = own.iter().map(|it| it.0.clone()).collect();
        }
        times
            .or_else(|| copied(function, blocks).map(Times::from))
            .ok_or_else(|| format!("a loop of `{}` has no line of a loop in the C", function.name))
    }
}

/// Returns the last line of a loop that begins at an index: its closing brace has the indentation of its head.
fn last_line(lines: &[&str], at: usize) -> u32 {
    let indentation = |line: &str| line.len() - line.trim_start().len();
    let own = indentation(lines[at]);
    let after = lines.iter().enumerate().skip(at + 1);
    let mut after = after.filter(|(_, line)| !line.trim().is_empty() && indentation(line) <= own);
    after.next().map_or(lines.len(), |(index, _)| index + 1) as u32
}

/// Returns the passes by file and line of the Rust: of several loops at one line the most, if each has a number.
fn of_rust(module: &Module, estimates: &[Estimate]) -> BTreeMap<Line, Option<u64>> {
    let mut found: BTreeMap<Line, Option<u64>> = BTreeMap::new();
    for it in estimates.iter().flat_map(|it| &it.loops) {
        let file = module.files.get(it.span.file as usize).cloned().unwrap_or_default();
        let passes = found.entry((file, it.span.line)).or_insert(Some(0));
        *passes = passes.zip(it.passes).map(|(one, other)| one.max(other));
    }
    found
}

/// The number behind each `#define` of the C.
fn constants(compiled: &Compiled) -> BTreeMap<&str, u64> {
    let lines = compiled.files.iter().flat_map(|file| file.text.lines());
    let defined = lines.filter_map(|line| line.strip_prefix("#define ")?.split_once(' '));
    defined.filter_map(|(name, value)| Some((name, number(value.trim())?))).collect()
}

/// Reads a constant: `8`, `8U`, `UINT64_C(8)`, `(8U)`.
fn number(text: &str) -> Option<u64> {
    let inner = text.split_once('(').and_then(|(before, rest)| {
        let of_macro = before.is_empty() || before.ends_with("_C");
        rest.strip_suffix(')').filter(|_| of_macro)
    });
    inner.unwrap_or(text).trim_end_matches(['U', 'L']).parse().ok()
}

/// The head of a loop: `for (T counter = from; counter < to; counter++)`, or with `<=`.
struct Head<'t> {
    counter: &'t str,
    from: &'t str,
    to: &'t str,
    /// True for `<=`.
    closed: bool,
}

impl<'t> Head<'t> {
    fn of(head: &'t str) -> Option<Head<'t>> {
        let inner = head.strip_prefix("for (")?.split_once(") {")?.0;
        let mut parts = inner.split(';');
        let (first, test, step) = (parts.next()?, parts.next()?.trim(), parts.next()?.trim());
        let (name, from) = first.rsplit_once(" = ")?;
        let counter = name.split_whitespace().last()?;
        let mut words = test.splitn(3, ' ');
        let (left, operator, to) = (words.next()?, words.next()?, words.next()?);
        let steps = step.strip_suffix("++") == Some(counter);
        let closed = match operator {
            "<" => false,
            "<=" => true,
            _ => return None,
        };
        (left == counter && steps).then_some(Head { counter, from, to, closed })
    }

    fn between(&self, from: u64, to: u64) -> u64 {
        (to + u64::from(self.closed)).saturating_sub(from)
    }

    /// Returns the passes between constant ends.
    fn passes(
        &self,
        constants: &BTreeMap<&str, u64>,
        slices: &BTreeMap<String, u64>,
    ) -> Option<u64> {
        let from = value(self.from, constants)?;
        let length = || slices.get(self.to.strip_suffix("_length")?).copied();
        let to = value(self.to, constants).or_else(length)?;
        Some(self.between(from, to))
    }

    /// True if nothing within the loop changes its counter, or has its name.
    fn stays(&self, lines: &[&str], at: usize, last_line: u32) -> bool {
        let mut within = lines[..last_line as usize].iter().skip(at + 1);
        !within.any(|line| {
            let mut words = line.split(|it: char| !it.is_alphanumeric() && it != '_');
            let is_name = words.any(|it| it == self.counter);
            let written = [" = ", " += ", " -= ", "++", "--"];
            is_name && written.iter().any(|it| line.contains(&format!("{}{it}", self.counter)))
        })
    }

    /// Returns the loop if its ends are constants.
    fn counted(
        &self,
        line: u32,
        last_line: u32,
        constants: &BTreeMap<&str, u64>,
    ) -> Option<Counted> {
        let from = value(self.from, constants)?;
        let to = value(self.to, constants)? + u64::from(self.closed);
        Some(Counted { line, last_line, counter: self.counter.to_owned(), values: from..to })
    }

    /// Returns the passes for each value of the counter of a loop around it, the largest first; none if no end follows it.
    fn passes_by(&self, outer: &Counted, constants: &BTreeMap<&str, u64>) -> Option<Vec<u64>> {
        let end = |text: &str, counter: u64| {
            let rest = text.trim().strip_prefix(outer.counter.as_str());
            match rest {
                Some("") => Some(counter),
                Some(rest) => counter.checked_add(number(rest.strip_prefix(" + ")?)?),
                None => value(text, constants),
            }
        };
        let of = |it: u64| Some(self.between(end(self.from, it)?, end(self.to, it)?));
        let few = outer.values.end.saturating_sub(outer.values.start) <= 1024;
        let mut all = few.then(|| outer.values.clone().map(of).collect::<Option<Vec<u64>>>())??;
        all.sort_unstable_by_key(|it| std::cmp::Reverse(*it));
        Some(all)
    }
}

/// Returns the value of a product of constants.
fn value(text: &str, constants: &BTreeMap<&str, u64>) -> Option<u64> {
    let one = |it: &str| number(it).or_else(|| constants.get(it).copied());
    text.trim().split(" * ").map(one).try_fold(1_u64, |product, it| product.checked_mul(it?))
}

/// Returns for each name of a slice parameter the longest array that is passed to one.
///
/// A name is not in it if the length of one argument is unknown, or if the firmware passes one, whose length may be any.
fn slices(module: &Module) -> BTreeMap<String, u64> {
    let mut found: BTreeMap<String, Option<u64>> = BTreeMap::new();
    for function in &module.functions {
        let is_slice = |it: &&bessemer_ir::Local| matches!(it.ty, Type::Slice(_));
        let within = !matches!(function.role, Role::Entry { .. });
        for parameter in function.parameters().iter().filter(is_slice) {
            let most = found.entry(parameter.name.clone()).or_insert(Some(0));
            *most = most.filter(|_| within);
        }
    }
    for function in &module.functions {
        function.body.each_expr(|expr| {
            let ExprKind::Call(callee, arguments) = &expr.kind else { return };
            let parameters = module.functions[callee.index()].parameters();
            for (argument, parameter) in arguments.iter().zip(parameters) {
                let Some(most) = found.get_mut(&parameter.name) else { continue };
                let place = match argument {
                    Argument::RefMut(place) => Some(place),
                    Argument::Ref(Expr { kind: ExprKind::Load(place), .. })
                    | Argument::Value(Expr { kind: ExprKind::Load(place), .. }) => Some(place),
                    _ => None,
                };
                let length = place.and_then(|it| length(module, function, it));
                *most = most.zip(length).map(|(one, other)| one.max(other));
            }
        });
    }
    found.into_iter().filter_map(|(name, most)| Some((name, most?))).collect()
}

/// Returns the length of the array that a place is or is a part of.
fn length(module: &Module, function: &bessemer_ir::Function, place: &Place) -> Option<u64> {
    let mut ty = function.local(place.root).ty.clone();
    let mut last = None;
    for step in place.steps.iter().map(Some).chain([None]) {
        match &ty {
            Type::Array { len, .. } => last = Some(u64::from(*len)),
            Type::Matrix { rows, cols, .. } => last = Some(u64::from(*rows) * u64::from(*cols)),
            Type::Slice(_) => {}
            _ => last = None,
        }
        if let Some(step) = step {
            ty = module.step_type(&ty, step)?;
        }
    }
    last
}

/// Returns the passes of a copy: the constant that was added to its pointer, by the bytes of a pass.
fn copied(function: &Function, blocks: &[usize]) -> Option<u64> {
    let own = || blocks.iter().flat_map(|it| &function.blocks[*it].instructions);
    let stride = own().filter_map(|it| stride(&it.text)).max()?;
    let compared = own().find_map(|it| it.text.strip_prefix("cmp ")?.split_once(", "))?;
    let first = *blocks.iter().min()?;
    let before = function.blocks[..first].iter().flat_map(|it: &Block| &it.instructions);
    let added = before.rev().find_map(|it| {
        let (word, operands) = it.text.split_once(' ')?;
        let (register, rest) = operands.split_once(", ")?;
        let is_end = register == compared.0 || register == compared.1;
        let number = rest.split_once(", #")?.1.parse::<u64>().ok()?;
        (word.starts_with("add") && is_end).then_some(number)
    })?;
    Some(added.div_ceil(stride))
}

/// Returns the bytes by which a load or a store advances its pointer.
fn stride(text: &str) -> Option<u64> {
    let (word, operands) = text.split_once(' ')?;
    if let Some((_, number)) = operands.split_once("], #") {
        return number.parse().ok();
    }
    let is_many = word.starts_with("ldm") || word.starts_with("stm");
    let list = operands.split_once("!, {")?.1;
    is_many.then(|| 4 * (list.matches(',').count() as u64 + 1))
}

#[cfg(test)]
mod tests {
    use super::*;
    use bessemer_ir::{Attributes, Function, Local, Mode, Span};

    #[test]
    fn heads_with_constant_ends_have_their_passes() {
        let constants = BTreeMap::from([("WIDTH", 36)]);
        let slices = BTreeMap::from([("bytes".to_owned(), 56)]);
        let of = |head: &str| Head::of(head)?.passes(&constants, &slices);
        assert_eq!(of("for (uint32_t n = 1U; n < WIDTH * 4U; n++) {"), Some(143));
        assert_eq!(of("for (uint32_t n = 0U; n <= UINT64_C(3); n++) {"), Some(4));
        assert_eq!(of("for (uint64_t i = UINT64_C(0); i < bytes_length; i++) {"), Some(56));
        assert_eq!(of("for (uint32_t col = 0U; col <= row; col++) {"), None);
        assert_eq!(of("for (uint32_t n = 8U; n-- > 0U;) {"), None);
        assert_eq!(of("while (n < 3U) {"), None);
    }

    #[test]
    fn a_triangle_has_the_passes_of_each_row() {
        let outer = Head::of("for (uint32_t row = 0U; row < WIDTH; row++) {").expect("a head");
        let constants = BTreeMap::from([("WIDTH", 4)]);
        let outer = outer.counted(1, 9, &constants).expect("constant ends");
        let of = |head: &str| Head::of(head)?.passes_by(&outer, &constants);
        let passes = |all: &[u64]| Some(all.to_vec());
        assert_eq!(of("for (uint32_t col = 0U; col <= row; col++) {"), passes(&[4, 3, 2, 1]));
        assert_eq!(of("for (uint32_t col = 0U; col < row; col++) {"), passes(&[3, 2, 1, 0]));
        assert_eq!(of("for (uint32_t k = row + 1U; k < WIDTH; k++) {"), passes(&[3, 2, 1, 0]));
        assert_eq!(of("for (uint32_t k = 0U; k < rows; k++) {"), None);
        assert_eq!(of("for (uint32_t k = 0U; k < row * 2U; k++) {"), None);
    }

    #[test]
    fn a_slice_from_the_firmware_has_any_length() {
        let of = |role: Role| {
            let element = Type::Slice(Box::new(Type::F64));
            let span = Span::default();
            let (name, mode) = ("values".to_owned(), Mode::Ref);
            let function = Function {
                name: "mean".to_owned(),
                module: "filters".to_owned(),
                owner: None,
                role,
                attributes: Attributes::default(),
                docs: Vec::new(),
                locals: vec![Local { name, ty: element, mode, span }],
                params: 1,
                result: Type::Unit,
                result_name: String::new(),
                body: bessemer_ir::Block(Vec::new()),
                kernel: None,
                span,
            };
            slices(&Module { functions: vec![function], ..Module::default() })
        };
        assert_eq!(of(Role::Private), BTreeMap::from([("values".to_owned(), 0)]));
        assert_eq!(of(Role::Entry { infallible: true }), BTreeMap::new());
    }

    #[test]
    fn a_loop_ends_at_the_brace_below_its_head() {
        let lines = ["    for (;;) {", "        f();", "", "    }", "    g();"];
        assert_eq!(last_line(&lines, 0), 4);
    }

    #[test]
    fn copies_advance_by_their_registers() {
        assert_eq!(stride("ldmia ip!, {r0, r1, r2, r3}"), Some(16));
        assert_eq!([stride("str r0, [r3], #4"), stride("str r0, [r3, #4]")], [Some(4), None]);
    }
}
