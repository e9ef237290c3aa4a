//! Small Cholesky factors, written out. A column remains in registers until it is finished.

use std::fmt::Write as _;

use bessemer_ir::Kernel;

use super::super::text::{fill, values};
use super::super::{Source, is_in_header};
use super::{is_beside, spoil};

const POSITIVE: &str = "\
/* Roots of magnitudes, of what is positive anyway: compilers for ARM then keep no call for what is negative. */
";

/// Returns the factorisation: for every column, the columns on its left, the root, the division.
pub(super) fn factor(kernel: &Kernel, n: u32) -> Source {
    let (in_header, beside) = (is_in_header(kernel), is_beside(kernel));
    let mut text = if in_header { POSITIVE.to_owned() } else { String::new() };
    // Writing to a string cannot fail.
    let mut put = |line: String| {
        let _ = writeln!(text, "{line}");
    };
    if beside {
        let above = (0..n).flat_map(|column| (0..column).map(move |row| row + n * column));
        above.for_each(|index| put(format!("result[{index}] = a[{index}];")));
    }
    let (l, none) = match beside {
        true => ("result", "spoil(result);\n    return;"),
        false => ("a", "return spoil(a);"),
    };
    for column in 0..n {
        for row in column..n {
            put(format!("$real l{row}_{column} = a[{}];", row + n * column));
        }
        for k in 0..column {
            for row in column..n {
                put(format!("l{row}_{column} -= l{column}_{k} * l{row}_{k};"));
            }
        }
        let diagonal = format!("l{column}_{column}");
        put(format!("if (!({diagonal} > $zero)) {{\n    {none}\n}}"));
        put(match in_header {
            true => format!("{diagonal} = $sqrt($abs({diagonal}));"),
            false => format!("{diagonal} = $sqrt({diagonal});"),
        });
        for row in column + 1..n {
            put(format!("l{row}_{column} /= {diagonal};"));
        }
    }
    for column in 0..n {
        for row in column..n {
            put(format!("{l}[{}] = l{row}_{column};", row + n * column));
        }
    }
    if !beside {
        put("return true;".into());
    }
    let values = values(kernel.element, &[("n", n)]);
    let (mut spoil, mut body) = (spoil(kernel), text);
    if in_header {
        // A name of its own: several kernels may are in one source.
        let name = format!("spoil_{}(", kernel.name());
        spoil = spoil.replace("static ", "static inline ").replace("spoil(", &name);
        body = body.replace("spoil(", &name);
    }
    Source {
        before: fill(&spoil, &values).trim_end().to_owned(),
        body: fill(&body, &values),
        math: true,
        ..Source::default()
    }
}

/// Returns both substitutions, with each right-hand side in registers.
pub(super) fn solve(kernel: &Kernel, n: u32, columns: u32) -> Source {
    let mut text = String::new();
    for row in 0..n {
        let _ = writeln!(text, "    $real x{row} = x[{row}];");
        for k in 0..row {
            let _ = writeln!(text, "    x{row} -= a[{}] * x{k};", n * k + row);
        }
        let _ = writeln!(text, "    x{row} /= a[{}];", n * row + row);
    }
    for row in (0..n).rev() {
        known(&mut text, n, row);
        let _ = writeln!(text, "    x{row} = (x{row} - known{row}) / a[{}];", n * row + row);
        let _ = writeln!(text, "    x[{row}] = x{row};");
    }
    let values = values(kernel.element, &[("n", n), ("columns", columns)]);
    if is_in_header(kernel) {
        let body = text.replace("    ", "").replace("= x[", "= b[").replace("x[", "b[");
        return Source { body: fill(&body, &values), ..Source::default() };
    }
    let text = format!(
        "/* Solves for one right-hand side: down by L, then up by its transpose. */\n\
         static void substitute(const $real *a, $real *x)\n{{\n{text}}}\n"
    );
    let body = match columns {
        1 => "substitute(a, b);\n",
        _ => {
            "for (uint32_t column = 0U; column < $columns; column++) {\n    \
             substitute(a, &b[$n * column]);\n}\n"
        }
    };
    Source {
        before: fill(&text, &values).trim_end().to_owned(),
        body: fill(body, &values),
        ..Source::default()
    }
}

/// Writes the scalar product of a column below the diagonal with the known part, in nalgebra's order. From eight terms
/// on, it has eight sums that are then added in pairs.
fn known(text: &mut String, n: u32, row: u32) {
    let terms = n - 1 - row;
    let whole = terms - terms % 8;
    let product = |term: u32| {
        let other = row + 1 + term;
        format!("a[{}] * x{other}", n * row + other)
    };
    if whole > 0 {
        for lane in 0..8 {
            let _ = write!(text, "    const $real sum{row}_{lane} = $zero");
            for term in (lane..whole).step_by(8) {
                let _ = write!(text, " + {}", product(term));
            }
            text.push_str(";\n");
        }
    }
    // The leading zero makes +0 of a sum of −0.
    let _ = writeln!(text, "    $real known{row} = $zero;");
    if whole > 0 {
        for lane in 0..4 {
            let _ = writeln!(text, "    known{row} += sum{row}_{lane} + sum{row}_{};", lane + 4);
        }
    }
    for term in whole..terms {
        let _ = writeln!(text, "    known{row} += {};", product(term));
    }
}
