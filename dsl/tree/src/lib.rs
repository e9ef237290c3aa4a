//! The author's syntax, as the attribute macros emit it, and the package that contains it.
//!
//! The tree has no types: where rustc had to infer one, a node has the number of a *witness slot*, and
//! [`Function::slots`] has the type that rustc inferred for it. Names are the author's; shadowing and scopes are
//! resolved in the lowering to IR.
//!
//! Must not know: the meaning of operations, which belongs to the front end.
//!
//! This crate also has the types that tree and IR share: [`number`], [`operation`], [`routine`], [`attributes`].
//!
//! Invariants: `no_std`; no nalgebra. DSL and macros know nothing of the compiler besides this crate.

#![no_std]

extern crate alloc;

pub mod attributes;
mod build;
mod builtin;
mod data;
pub mod number;
pub mod operation;
mod package;
pub mod routine;
pub mod visit;
mod way;

use alloc::boxed::Box;
use alloc::string::String;
use alloc::vec::Vec;

use serde::{Deserialize, Serialize};

use crate::attributes::Attributes;
use crate::number::Scalar;

pub use builtin::*;
pub use data::*;
pub use package::*;
pub use way::*;

/// Reads a part of the tree from JSON, which nests as deep as the author's expressions. The caller provides a large
/// stack.
///
/// # Errors
///
/// JSON that is not such a part.
pub fn read<'t, T: Deserialize<'t>>(text: &'t str) -> serde_json::Result<T> {
    let mut reader = serde_json::Deserializer::from_str(text);
    reader.disable_recursion_limit();
    let part = T::deserialize(&mut reader)?;
    reader.end()?;
    Ok(part)
}

/// Line and column in a file, both from 1.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Site(pub u32, pub u32);

/// A type as rustc inferred it.
#[derive(Clone, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub enum Ty {
    /// `()`.
    Unit,
    /// `bool`, an integer or a float.
    Scalar(Scalar),
    /// `[T; n]`.
    Array(Box<Ty>, u32),
    /// `SMatrix<T, rows, cols>`.
    Matrix(Scalar, u32, u32),
    /// A struct or enum, by its path.
    Named(String),
    /// `(A, B)`.
    Tuple(Vec<Ty>),
    /// `List<T, n>`.
    List(Box<Ty>, u32),
    /// `Option<T>`.
    Option(Box<Ty>),
    /// `Result<T, E>`.
    Result(Box<Ty>, Box<Ty>),
    /// `[T]`, behind a reference.
    Slice(Box<Ty>),
    /// `&T`, or `&mut T` when true.
    Ref(Box<Ty>, bool),
    /// A named type of nalgebra or Rust that is represented by another: `Rotation3` by a matrix, `char` by a number.
    Known(String, Box<Ty>),
}

impl Ty {
    /// Rust's name of the type of names, `&str`.
    pub const NAME: &str = "str";

    /// Returns true for names, and for arrays of them.
    pub fn is_name(&self) -> bool {
        match self {
            Ty::Known(name, _) => name == Ty::NAME,
            Ty::Array(element, _) | Ty::Ref(element, _) => element.is_name(),
            _ => false,
        }
    }
}

/// Argument for a generic parameter.
#[derive(Clone, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub enum Argument {
    /// A type.
    Type(Ty),
    /// A number, as a word of its type.
    Number(Scalar, u64),
}

/// A function with rustc's results.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Function {
    /// Unique Rust path with arguments, such as `models::attitude::Pid::torque`.
    pub path: String,
    /// Module, such as `models::attitude`.
    pub module: String,
    /// Source file, as rustc names it.
    pub file: String,
    /// Path of the type whose method it is.
    pub owner: Option<String>,
    /// Arguments for the generic parameters in scope, by name.
    pub generics: Vec<(String, Argument)>,
    /// Interface to which it belongs.
    pub interface: Option<String>,
    /// Suffix that distinguishes it from other functions of its name and owner.
    pub suffix: Vec<Argument>,
    /// True if it is declared in the body of another function, whose name is part of its own.
    #[serde(default)]
    pub inner: bool,
    /// Author's syntax.
    pub tree: FunctionTree,
    /// Types of the slots.
    pub slots: Vec<Ty>,
    /// Callees of the tree's calls.
    pub callees: Vec<Callee>,
    /// Values of the paths that are constants.
    pub constants: Vec<Constant>,
    /// Callees of its operators that are functions, by [`Operator::at`].
    #[serde(default)]
    pub operators: Vec<(u32, Callee)>,
}

/// The callee of a call.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Callee {
    /// A function of the package, by its path.
    Function(String),
    /// An operation that the library knows.
    Builtin(Builtin),
}

/// A path that rustc evaluated.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Constant {
    /// Type.
    pub ty: Ty,
    /// Words of the value.
    pub words: Vec<u64>,
}

/// Author's syntax: signature and body.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct FunctionTree {
    /// Author's name.
    pub name: String,
    /// Site of the name.
    pub site: Site,
    /// Author's doc comment, one entry per line.
    pub docs: Vec<String>,
    /// Role of the function for its callers.
    pub role: Role,
    /// Author's attributes for the C.
    #[serde(default)]
    pub attributes: Attributes,
    /// Parameters, including `self`.
    pub params: Vec<Param>,
    /// Slot of the result.
    pub result: u32,
    /// The body.
    pub body: Block,
    /// Operators that may be functions, depending on the types of their operands.
    #[serde(default)]
    pub operators: Vec<Operator>,
    /// Derivative that the body computes, if the generator writes it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub derivative: Option<Derivative>,
}

/// A derivative: `#[function(derivative(advance, state))]`, or a gradient.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Derivative {
    /// Segments of the path of the differentiated function.
    pub of: Vec<String>,
    /// Parameters by which it is differentiated, in the order of the Jacobians.
    pub by: Vec<String>,
    /// True for `#[function(gradient(cost, input))]`: the gradients of a number, in reverse mode.
    #[serde(default, skip_serializing_if = "core::ops::Not::not")]
    pub is_gradient: bool,
    /// Site of the path.
    pub site: Site,
}

/// An operator, with the slots of its operands.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Operator {
    /// Slot of its value; for an assignment, of its place.
    pub at: u32,
    /// Rust's trait: `Add`, `AddAssign`, `Neg`.
    pub of: String,
    /// Slots of its operands; none for a literal.
    pub operands: Vec<Option<u32>>,
}

/// The role of a function for its callers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[allow(missing_docs)]
pub enum Role {
    Entry {
        infallible: bool,
    },
    Public,
    Private,
    Inline {
        public: bool,
    },
    /// Inlined at each call; not a function in the C.
    Expanded,
    /// Replaced by its body at each call; not a function in the C.
    Rewritten,
}

/// A parameter.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Param {
    /// Author's name; `self` for the receiver.
    pub name: String,
    /// Slot of its type.
    pub slot: u32,
    /// Site of the parameter.
    pub site: Site,
    /// True if it takes a closure; its slot is then unused.
    #[serde(default)]
    pub closure: bool,
    /// True if it takes an iterator: it is then a closure that passes each item to [`EACH`].
    #[serde(default)]
    pub items: bool,
    /// True if the author may assign it.
    #[serde(default)]
    pub mutable: bool,
}

/// Statements, then possibly a value.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Block {
    /// The statements.
    pub stmts: Vec<Stmt>,
    /// The expression without a semicolon at the end.
    pub tail: Option<Box<Expr>>,
}

/// A statement.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Stmt {
    /// `let name = value;`
    Let {
        /// Author's name.
        name: String,
        /// Slot of its type.
        slot: u32,
        /// First value.
        value: Option<Expr>,
        /// Site of the start of the statement.
        site: Site,
        /// True if the author may assign it.
        #[serde(default)]
        mutable: bool,
    },
    /// `let (a, b) = value;` and the like.
    Apart {
        /// Pattern that destructures the value.
        pattern: Box<Pattern>,
        /// The value.
        value: Expr,
        /// Block after `else`, which runs if the pattern does not match; it never reaches its end.
        otherwise: Option<Block>,
        /// Site of the start of the statement.
        site: Site,
    },
    /// An expression for its effect.
    Expr(Expr),
}

/// An expression.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Expr {
    /// Kind of the expression.
    pub kind: ExprKind,
    /// Site of the expression.
    pub site: Site,
    /// Slot with its type, if rustc had to infer it.
    pub slot: Option<u32>,
}

impl Expr {
    /// Returns true if it is a number without a type suffix.
    pub fn is_unsuffixed(&self) -> bool {
        match &self.kind {
            ExprKind::Int(_, suffix) | ExprKind::Float(_, suffix) => suffix.is_none(),
            ExprKind::Unary(_, operand) => operand.is_unsuffixed(),
            _ => false,
        }
    }
}

/// The kinds of [`Expr`].
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum ExprKind {
    /// `true`, `false`.
    Bool(bool),
    /// Digits in decimal, or in hexadecimal after `0x`; and the suffix if there is one.
    Int(String, Option<Scalar>),
    /// Digits as the author wrote them without underscores, and the suffix if any.
    Float(String, Option<Scalar>),
    /// `b"text"`.
    Bytes(Vec<u8>),
    /// A local by its name.
    Local(String),
    /// A path that is no local: index into [`Function::constants`], and the path as the author wrote it. For a
    /// name, `"pump"`, it is the text after a quotation mark.
    Path(u32, String),
    /// `-x`, `!x`.
    Unary(UnaryOp, Box<Expr>),
    /// `a + b` and the like.
    Binary(BinaryOp, Box<Expr>, Box<Expr>),
    /// `place = value`, or `place += value` and the like.
    Assign(Option<BinaryOp>, Box<Expr>, Box<Expr>),
    /// A call; the receiver of a method is the first argument. The number is an index into [`Function::callees`].
    Call(u32, Vec<Expr>),
    /// A closure as an argument, `|x| …`. Before the builder has run, one with a slot is a function's name, and its
    /// slot has the types of its arguments.
    Closure(Closure),
    /// `f(x)`, where `f` is a parameter that takes a closure.
    Apply(String, Vec<Expr>),
    /// `base.name`.
    Field(Box<Expr>, String),
    /// `base[index]`.
    Index(Box<Expr>, Box<Expr>),
    /// `base[from..to]`, or `base[from..=to]` when true; a missing end is the base's.
    Slice(Box<Expr>, Option<Box<Expr>>, Option<Box<Expr>>, bool),
    /// `(a, b)`.
    Tuple(Vec<Expr>),
    /// `Name(a, b)`: a tuple struct or a variant; `None` has no parts.
    Constructor(String, Vec<Expr>),
    /// `Name { field: value, …, ..base }`: a struct or a variant.
    Struct(String, Vec<(String, Expr)>, Option<Box<Expr>>),
    /// `[a, b, …]`.
    Array(Vec<Expr>),
    /// `[value; n]`.
    Repeat(Box<Expr>),
    /// `&x`, or `&mut x` when true.
    Ref(bool, Box<Expr>),
    /// `*x`.
    Deref(Box<Expr>),
    /// `x as T`.
    Cast(Box<Expr>),
    /// `let pattern = value` as a condition.
    Let(Box<Pattern>, Box<Expr>),
    /// `value?`, with the label of the closure body that it leaves, if it is in one.
    Try(Option<String>, Box<Expr>),
    /// `if`.
    If(Box<Expr>, Block, Option<Box<Expr>>),
    /// `match`.
    Match(Box<Expr>, Vec<Arm>),
    /// `{ … }`.
    Block(Block),
    /// `'label: { … }`; a `break` to it has its label and value.
    Labelled(String, Block),
    /// `for pattern in source`.
    Each {
        /// Author's label, without the apostrophe.
        label: Option<String>,
        /// Pattern of each item.
        pattern: Box<Pattern>,
        /// Sequence that it iterates over.
        source: Box<Source>,
        /// Largest number of passes over an author-defined iterator: a literal or a constant.
        bound: Option<Box<Expr>>,
        /// The body.
        body: Block,
    },
    /// Result of an accumulating loop: `values.iter().sum()`, `values.map(…)` and the like.
    Fold {
        /// Name of the accumulator.
        name: String,
        /// Value of the accumulator before the loop.
        start: Start,
        /// Loop that assigns the accumulator.
        each: Box<Expr>,
    },
    /// `while condition`, or `loop` without one.
    While {
        /// Author's label, without the apostrophe.
        label: Option<String>,
        /// Condition for a further pass.
        condition: Option<Box<Expr>>,
        /// Largest number of passes: a literal or a constant. Without it, the bound must be proved.
        bound: Option<Box<Expr>>,
        /// The body.
        body: Block,
    },
    /// `#[unroll(4)]` above a `for`; 1: `#[keep]`.
    Unroll(u32, Box<Expr>),
    /// `return value`.
    Return(Option<Box<Expr>>),
    /// `break 'label value`.
    Break(Option<String>, Option<Box<Expr>>),
    /// `continue 'label`.
    Continue(Option<String>),
    /// `assert!(condition)`.
    Assert(Box<Expr>, Claim),
}

/// Value of the accumulator before the first pass.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Start {
    /// Empty sum: 0, for floats −0.
    Sum,
    /// Empty product: 1.
    Product,
    /// A value; passes continue while their results are `Some` or `Ok`.
    Tried(Box<Expr>),
    /// No value: each pass assigns an element.
    Elements,
}

/// An arm of a `match`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Arm {
    /// Pattern of the arm.
    pub pattern: Pattern,
    /// Guard.
    pub guard: Option<Expr>,
    /// Value of the arm.
    pub body: Expr,
    /// Site of the pattern.
    pub site: Site,
}

/// A closure as an argument of a call.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Closure {
    /// Author's name, if it has one.
    pub name: Option<String>,
    /// Parameters.
    pub parameters: Vec<Pattern>,
    /// Value.
    pub body: Box<Expr>,
}

/// Slot of a generated name, whose type is that of its value.
pub const NO_SLOT: u32 = u32::MAX;

/// Pattern for the variant with which `?` continues: `Some` or `Ok`.
pub const GOES_ON: &str = "?";

/// Name of the parameter of a function that returns an iterator, and of an iterator argument: the closure to which it
/// passes each item.
pub const EACH: &str = "__each";

/// Name of a type's method that returns an iterator over it, `set.iter()`; the macro cannot resolve it.
pub const ITER: &str = "iter";

/// Name of a conversion by `as` that is a function of the library.
pub const AS: &str = "As";

/// Trait of author-defined iterators.
pub const ITERATOR: &str = "Iterator";

/// Name of a method that returns mutable items; it may also be an adapter's.
pub const ITER_MUT: &str = "iter_mut";

/// A pattern.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Pattern {
    /// `_`.
    Any,
    /// `..` in a list.
    Rest,
    /// A name, `name`, possibly with a pattern, `name @ pattern`.
    Name {
        /// Author's name.
        name: String,
        /// Slot of its type.
        slot: u32,
        /// True if it may be assigned.
        mutable: bool,
        /// Pattern after `@`, if there is one.
        inner: Option<Box<Pattern>>,
    },
    /// A literal or a path.
    Value(Expr),
    /// `from..=to`, each end a literal or a path; a missing end is the type's.
    Range {
        /// First value.
        from: Option<Expr>,
        /// Last value, plus one unless `inclusive`.
        to: Option<Expr>,
        /// True if the range includes `to`.
        inclusive: bool,
    },
    /// `a | b`.
    Or(Vec<Pattern>),
    /// `(a, b)`.
    Tuple(Vec<Pattern>),
    /// `[a, b]`.
    Array(Vec<Pattern>),
    /// `Name(a, b)`; `None` has no parts.
    Constructor(String, Vec<Pattern>),
    /// `Name { field: a, .. }`.
    Fields(String, Vec<(String, Pattern)>),
}

/// Operators of one operand.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[allow(missing_docs)]
pub enum UnaryOp {
    Neg,
    Not,
}

/// Operators of two operands.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[allow(missing_docs)]
pub enum BinaryOp {
    Add,
    Sub,
    Mul,
    Div,
    Rem,
    And,
    Or,
    Xor,
    Shl,
    Shr,
    Eq,
    Ne,
    Lt,
    Le,
    Gt,
    Ge,
    LogicAnd,
    LogicOr,
}
