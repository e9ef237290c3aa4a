//! Plain loops that define a kernel, at the head of its file before the faster variants. A reviewer reads or certifies
//! them, and a benchmark compares the variants with them.
//!
//! Invariant: without `BESSEMER_LOOPS` nothing of this is compiled.

use bessemer_ir::{Float, Kernel, Mode, Scalar, Type};

use super::text::{fill, indented};
use super::{Buffer, Source, are_lent, declarations, plain, scalar};

const HEAD: &str = "\
/* What this kernel computes; with -DBESSEMER_LOOPS, how it does. Every other way below gives the same bits: it takes other
   elements side by side, each of them in this order. */
#if defined(BESSEMER_LOOPS)
static $result by_loops($params)
{
$loops}
$ways#endif";

/// Selection of the loops where the processor has no instructions for `double`.
const SOFTWARE: &str = "\
/* Where double is computed in software, its functions take the time, and loops are as fast in a tenth of the code. */
#if !defined(BESSEMER_LOOPS) && $condition
#define BESSEMER_LOOPS
#endif

";

/// Preprocessor condition of processors without instructions for `double`.
pub(super) const IN_SOFTWARE: &str =
    "defined(__arm__) && (!defined(__ARM_FP) || (__ARM_FP & 8) == 0)";

/// Returns a kernel's variants, preceded by its plain loops unless these are the only variant.
pub(super) fn before(kernel: &Kernel, ways: Source, buffers: &[Buffer]) -> Source {
    let loops = plain::alone(plain::source(kernel));
    let Some(lent) = lent(kernel, buffers) else { return ways };
    if loops.body == ways.body || !loops.before.is_empty() {
        return ways;
    }
    let function = kernel.function();
    let answers = function.result == Type::BOOL;
    let own = function.locals.iter().map(|local| {
        let constant = if local.mode == Mode::Ref { "const " } else { "" };
        (element(constant, &local.ty), local.name.clone(), local.name.clone())
    });
    let result = matches!(function.result, Type::Matrix { .. }).then(|| {
        (element("", &function.result), function.result_name.clone(), function.result_name.clone())
    });
    let all: Vec<(String, String, String)> = own.chain(result).chain(lent).collect();
    let params: Vec<String> = all.iter().map(|(ty, name, _)| format!("{ty} *{name}")).collect();
    let arguments: Vec<&str> = all.iter().map(|(.., argument)| argument.as_str()).collect();

    // What is lent is a parameter, and no name for a part of what the caller lends.
    let needed = plain::buffers(kernel);
    let named = if are_lent(&needed) { declarations(&needed) } else { String::new() };
    let body = loops.body.strip_prefix(&named).unwrap_or(&loops.body);
    let values = [
        ("result", if answers { "bool" } else { "void" }.to_owned()),
        ("params", params.join(", ")),
        ("loops", indented(body)),
        (
            "ways",
            if ways.before.is_empty() {
                String::new()
            } else {
                format!("#else\n{}\n", ways.before)
            },
        ),
    ];
    let call = format!("by_loops({});\n", arguments.join(", "));
    let call = if answers { format!("return {call}") } else { call };
    let unused = are_lent(buffers) && named.is_empty();
    let call = if unused { format!("(void)work;\n{call}") } else { call };
    let others = match ways.body.strip_prefix("#if").filter(|_| is_one_choice(&ways.body)) {
        Some(rest) => format!("#elif{rest}"),
        None => format!("#else\n{}#endif\n", ways.body),
    };
    let (math, string, dot) =
        (ways.math || loops.math, ways.string || loops.string, ways.dot || loops.dot);
    let body = format!("#if defined(BESSEMER_LOOPS)\n{call}{others}");
    let condition = [("condition", IN_SOFTWARE.to_owned())];
    let software =
        if kernel.element == Float::F64 { fill(SOFTWARE, &condition) } else { String::new() };
    Source { before: format!("{software}{}", fill(HEAD, &values)), body, math, string, dot }
}

/// Returns the parts of the passed memory that the loops use: type, name and place. None if the memory does not fit.
fn lent(kernel: &Kernel, buffers: &[Buffer]) -> Option<Vec<(String, String, String)>> {
    let needed = plain::buffers(kernel);
    if !are_lent(&needed) {
        return Some(Vec::new());
    }
    let place = |wanted: &Buffer| {
        let serves = |it: &&Buffer| it.element == wanted.element && it.len >= wanted.len;
        let place = buffers.iter().find(serves).filter(|_| are_lent(buffers))?;
        let name = wanted.name.to_owned();
        Some((scalar(wanted.element).to_owned(), name, format!("work->{}", place.name)))
    };
    needed.iter().map(place).collect()
}

fn element(constant: &str, ty: &Type) -> String {
    let element = match ty {
        Type::Matrix { element, .. } => *element,
        _ => Scalar::Bool,
    };
    format!("{constant}{}", scalar(element))
}

/// Returns true if a text is one `#if` … `#endif`, from its first line to its last.
fn is_one_choice(text: &str) -> bool {
    let mut depth = 0;
    let mut lines = text.lines().peekable();
    while let Some(line) = lines.next() {
        depth += i32::from(line.starts_with("#if"));
        depth -= i32::from(line.starts_with("#endif"));
        if depth == 0 {
            return lines.peek().is_none();
        }
    }
    false
}
