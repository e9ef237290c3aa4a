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
type Line = (String, u32);

/// The loops of the C.
#[derive(Default)]
pub struct Passes {
    /// By the line of the head: the last line of the loop, and its passes.
    loops: BTreeMap<Line, (u32, Option<u64>)>,
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
            for (at, line) in lines.iter().enumerate() {
                let head = line.trim_start();
                if !head.starts_with("for (") && !head.starts_with("while (") {
                    continue;
                }
                let number = at as u32 + 1;
                let own = by_text(head, &constants, &slices);
                let row = file.map.iter().rev().find(|row| row.c_line <= number);
                let row = row.filter(|row| row.c_line == number);
                let of_ir = row.and_then(|row| {
                    of_rust.get(&(row.rust_file.clone(), row.rust_line)).copied().flatten()
                });
                let passes = match (own, of_ir) {
                    (Some(one), Some(other)) => Some(one.min(other)),
                    (one, other) => one.or(other),
                };
                loops.insert((name.to_owned(), number), (last_line(&lines, at), passes));
            }
        }
        Passes { loops }
    }

    /// Returns the largest number of passes of a loop of these blocks.
    ///
    /// # Errors
    /// The reason for none.
    pub fn of_loop(&self, function: &Function, blocks: &[usize]) -> Result<u64, String> {
        let places = blocks.iter().flat_map(|it| &function.blocks[*it].instructions);
        let mut places: Vec<&Line> = places.filter_map(|it| it.place.as_ref()).collect();
        places.sort_unstable();
        places.dedup();
        let found: Vec<_> =
            places.into_iter().filter_map(|it| self.loops.get_key_value(it)).collect();
        let is_within = |inner: &Line| {
            found.iter().any(|(outer, (last, _))| {
                outer.0 == inner.0 && outer.1 < inner.1 && inner.1 <= *last
            })
        };
        let mut most = None;
        for (place, (_, passes)) in found.iter().filter(|it| !is_within(it.0)) {
            let passes = passes.ok_or_else(|| {
                format!("the loop at {}:{} has no known number of passes", place.0, place.1)
            })?;
            most = most.max(Some(passes));
        }
        most.or_else(|| copied(function, blocks))
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

/// Returns the passes by the head of a loop with constant ends: `for (T n = A; n < B; n++)`.
fn by_text(
    head: &str,
    constants: &BTreeMap<&str, u64>,
    slices: &BTreeMap<String, u64>,
) -> Option<u64> {
    let inner = head.strip_prefix("for (")?.split_once(") {")?.0;
    let mut parts = inner.split(';');
    let (first, test, step) = (parts.next()?, parts.next()?.trim(), parts.next()?.trim());
    let (name, from) = first.rsplit_once(" = ")?;
    let name = name.split_whitespace().last()?;
    let from = value(from, constants)?;
    let mut words = test.splitn(3, ' ');
    let (left, operator, right) = (words.next()?, words.next()?, words.next()?);
    let length = || slices.get(right.strip_suffix("_length")?).copied();
    let to = value(right, constants).or_else(length)?;
    if left != name || step != format!("{name}++") {
        return None;
    }
    match operator {
        "<" => Some(to.saturating_sub(from)),
        "<=" => Some((to + 1).saturating_sub(from)),
        _ => None,
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
        let of = |head: &str| by_text(head, &constants, &slices);
        assert_eq!(of("for (uint32_t n = 1U; n < WIDTH * 4U; n++) {"), Some(143));
        assert_eq!(of("for (uint32_t n = 0U; n <= UINT64_C(3); n++) {"), Some(4));
        assert_eq!(of("for (uint64_t i = UINT64_C(0); i < bytes_length; i++) {"), Some(56));
        assert_eq!(of("for (uint32_t col = 0U; col <= row; col++) {"), None);
        assert_eq!(of("for (uint32_t n = 8U; n-- > 0U;) {"), None);
        assert_eq!(of("while (n < 3U) {"), None);
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
