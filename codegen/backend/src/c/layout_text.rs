//! Breaks expressions into lines of at most 100 columns.
//!
//! An expression is a list of pieces, each with the nesting depth of a possible line break before it. A line that is
//! too long breaks at its outermost possible places, and continues four columns further in.

use super::tree::{Expr, operator_precedence};

/// Columns of a line.
pub const WIDTH: usize = 100;

/// A piece of text without a line break.
#[derive(Clone, Debug)]
pub struct Piece {
    /// The text, beginning with a space if it follows another piece on the same line.
    pub text: String,
    /// Nesting depth of a possible line break before the piece; none if there is none.
    pub break_depth: Option<u32>,
}

/// Collects pieces.
#[derive(Default)]
pub struct Pieces {
    list: Vec<Piece>,
    open: String,
    open_break: Option<u32>,
}

impl Pieces {
    /// Appends text that must not be separated from the text before it.
    pub fn glue(&mut self, text: &str) {
        self.open.push_str(text);
    }

    /// Allows a line break here.
    pub fn allow_break(&mut self, depth: u32) {
        self.close();
        self.open_break = Some(depth);
    }

    fn close(&mut self) {
        if !self.open.is_empty() {
            let text = std::mem::take(&mut self.open);
            self.list.push(Piece { text, break_depth: self.open_break.take() });
        }
    }

    /// Returns all pieces.
    pub fn finish(mut self) -> Vec<Piece> {
        self.close();
        self.list
    }

    /// Appends an expression; `depth` is the number of enclosing constructs.
    pub fn expr(&mut self, expr: &Expr, depth: u32) {
        match expr {
            Expr::Name(name) => self.glue(name),
            Expr::Unary(op, operand) => {
                self.glue(op);
                let clash = matches!(&**operand, Expr::Unary(inner, _) if inner == op);
                self.child(operand, operand.precedence() < 14 || clash, depth);
            }
            Expr::Cast(ty, operand) => {
                self.glue(&format!("({ty})"));
                let negative = matches!(&**operand, Expr::Unary("-", _));
                self.child(operand, operand.precedence() < 14 || negative, depth);
            }
            Expr::Binary(op, left, right) => self.binary(op, left, right, depth),
            Expr::Conditional(condition, yes, no) => {
                self.child(condition, condition.precedence() <= 2, depth + 1);
                self.allow_break(depth);
                self.glue(" ? ");
                self.child(yes, yes.precedence() <= 2, depth + 1);
                self.allow_break(depth);
                self.glue(" : ");
                self.child(no, no.precedence() <= 2, depth + 1);
            }
            Expr::Call(function, arguments) => {
                self.glue(function);
                self.arguments(arguments, depth + 1);
            }
            Expr::Index(array, index) => {
                self.child(array, array.precedence() < 15, depth + 1);
                self.glue("[");
                self.expr(index, depth + 10);
                self.glue("]");
            }
            Expr::Member(value, field) => {
                self.child(value, value.precedence() < 15, depth + 1);
                self.glue(".");
                self.glue(field);
            }
            Expr::Arrow(pointer, field) => {
                self.child(pointer, pointer.precedence() < 15, depth + 1);
                self.glue("->");
                self.glue(field);
            }
            Expr::Postfix(operand, op) => {
                self.child(operand, operand.precedence() < 15, depth + 1);
                self.glue(op);
            }
        }
    }

    fn arguments(&mut self, arguments: &[Expr], depth: u32) {
        self.glue("(");
        for (index, argument) in arguments.iter().enumerate() {
            if index > 0 {
                self.glue(",");
            }
            self.allow_break(depth);
            if index > 0 {
                self.glue(" ");
            }
            self.expr(argument, depth + 1);
        }
        self.glue(")");
    }

    fn binary(&mut self, op: &str, left: &Expr, right: &Expr, depth: u32) {
        let own = operator_precedence(op);
        // A chain of one operator stays at one depth, so that it breaks evenly.
        let chained = left.precedence() == own;
        let left_parens = left.precedence() < own || wants_parens(op, left);
        self.child(left, left_parens, if chained && !left_parens { depth } else { depth + 1 });
        if depth < 10 {
            self.allow_break(depth);
        }
        self.glue(&format!(" {op} "));
        let signed = matches!(op, "+" | "-") && matches!(right, Expr::Unary("-", _));
        let right_parens = right.precedence() <= own || wants_parens(op, right) || signed;
        self.child(right, right_parens, depth + 1);
    }

    fn child(&mut self, expr: &Expr, parens: bool, depth: u32) {
        if parens {
            self.glue("(");
            self.expr(expr, depth + 1);
            self.glue(")");
        } else {
            self.expr(expr, depth);
        }
    }
}

/// Returns true if parentheses help a reader though C does not need them. These are bit operations and shifts among
/// other operators, `&&` inside `||`, and comparisons inside comparisons.
fn wants_parens(op: &str, child: &Expr) -> bool {
    let Expr::Binary(inner, ..) = child else {
        return matches!(child, Expr::Conditional(..));
    };
    let bits = |op: &str| matches!(op, "&" | "|" | "^" | "<<" | ">>");
    let logic = |op: &str| matches!(op, "&&" | "||");
    let compare = |op: &str| matches!(op, "==" | "!=" | "<" | "<=" | ">" | ">=");
    (bits(op) || bits(inner)) && op != *inner
        || logic(op) && logic(inner) && op != *inner
        || compare(op) && compare(inner)
        || matches!(op, "%") && !compare(op)
        || matches!(*inner, "%") && !compare(op)
}

/// Returns the expression on one line.
pub fn flat(expr: &Expr) -> String {
    let mut pieces = Pieces::default();
    pieces.expr(expr, 0);
    pieces.finish().into_iter().map(|piece| piece.text).collect()
}

/// Breaks pieces into lines from column `indent`; further lines are indented by `further` more columns.
pub fn fill(pieces: &[Piece], indent: usize, further: usize) -> Vec<String> {
    let mut lines = Vec::new();
    let mut rest = pieces;
    let mut margin = indent;
    loop {
        let taken = line_length(rest, WIDTH.saturating_sub(margin));
        let text: String = rest[..taken].iter().map(|piece| piece.text.as_str()).collect();
        let text = if lines.is_empty() { text.as_str() } else { text.trim_start() };
        lines.push(format!("{:margin$}{}", "", text.trim_end()));
        rest = &rest[taken..];
        if rest.is_empty() {
            return lines;
        }
        margin = indent + further;
    }
}

/// Returns the number of pieces on a line of `room` columns: all, or those up to the last fitting outermost break.
fn line_length(pieces: &[Piece], room: usize) -> usize {
    let mut column = 0;
    let mut best: Option<(u32, usize)> = None;
    for (index, piece) in pieces.iter().enumerate() {
        if let (true, Some(depth)) = (index > 0, piece.break_depth) {
            let outer = best.is_none_or(|(known, _)| depth <= known);
            // A break near the margin leaves a stub; one further in is better then.
            let stub = best.is_some_and(|(_, at)| width(&pieces[..at]) * 3 < room);
            if outer || stub {
                best = Some((depth, index));
            }
        }
        column += piece.text.chars().count();
        if column > room
            && let Some((_, at)) = best
        {
            return at;
        }
    }
    pieces.len()
}

fn width(pieces: &[Piece]) -> usize {
    pieces.iter().map(|piece| piece.text.chars().count()).sum()
}
