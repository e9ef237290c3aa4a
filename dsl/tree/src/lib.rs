//! The author's syntax as the attribute macros hand it on, and the package that carries it.
//!
//! The tree has no types of its own: where rustc had something to infer, a node names a *witness
//! slot*, and [`Function::slots`] gives the type that rustc put there. Names are still the author's;
//! shadowing and scopes are resolved when the tree becomes IR.
//!
//! Must not know: what an operation means. That is the typifier's.
//!
//! Beside it stand the words that tree and IR have in common: [`number`], [`operation`], [`routine`], [`attributes`].
//!
//! Invariants: `no_std`; no nalgebra. What the DSL and its macros know of the compiler is here.

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
/// Anything that is no such part.
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

/// A type as rustc decided it.
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
    /// A type of nalgebra's or of Rust's, by its name, whose values are those of another: `Rotation3` is a matrix, `char` a number.
    Known(String, Box<Ty>),
}

/// The argument for a parameter of something generic.
#[derive(Clone, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub enum Argument {
    /// A type.
    Type(Ty),
    /// A number, as a word of its type.
    Number(Scalar, u64),
}

/// A function with all that rustc decided about it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Function {
    /// Its Rust path, `models::attitude::Pid::torque`, with its arguments: unique.
    pub path: String,
    /// The module that it is in, `models::attitude`.
    pub module: String,
    /// The source file, as rustc names it.
    pub file: String,
    /// The path of the type whose method it is.
    pub owner: Option<String>,
    /// The arguments for the parameters in scope, by name.
    pub generics: Vec<(String, Argument)>,
    /// The interface that it is part of.
    pub interface: Option<String>,
    /// The suffix that tells it from other functions of its name and owner.
    pub suffix: Vec<Argument>,
    /// True if it is declared in the body of another, whose name is a part of its own.
    #[serde(default)]
    pub inner: bool,
    /// The author's text.
    pub tree: FunctionTree,
    /// The types of the slots.
    pub slots: Vec<Ty>,
    /// The callees of the tree's calls.
    pub callees: Vec<Callee>,
    /// The values of the paths that are constants.
    pub constants: Vec<Constant>,
    /// The callees of its operators, by [`Operator::at`], where they are functions.
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
    /// Its type.
    pub ty: Ty,
    /// Its value.
    pub words: Vec<u64>,
}

/// The author's text: signature and body.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct FunctionTree {
    /// The author's name.
    pub name: String,
    /// Site of the name.
    pub site: Site,
    /// The author's doc comment, a line each.
    pub docs: Vec<String>,
    /// Its role for its callers.
    pub role: Role,
    /// The author's wishes for its C.
    #[serde(default)]
    pub attributes: Attributes,
    /// Parameters, `self` included.
    pub params: Vec<Param>,
    /// The slot of the result.
    pub result: u32,
    /// The body.
    pub body: Block,
    /// Its operators that may be functions: which depends on the types of their operands.
    #[serde(default)]
    pub operators: Vec<Operator>,
}

/// An operator, and where rustc put the types of its operands.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Operator {
    /// The slot of its value; of an assignment, of its place.
    pub at: u32,
    /// Rust's trait for it: `Add`, `AddAssign`, `Neg`.
    pub of: String,
    /// The slots of its operands; none of a literal.
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
    /// Stands where it is called: nothing in the C.
    Expanded,
    /// A call of it represents its body, which has no types of its own: nothing in the C.
    Rewritten,
}

/// A parameter.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Param {
    /// The author's name; `self` for the receiver.
    pub name: String,
    /// Its type.
    pub slot: u32,
    /// Site of the parameter.
    pub site: Site,
    /// True if it takes a closure: then the slot has no information.
    #[serde(default)]
    pub closure: bool,
    /// True if it takes an iterator: it is then a closure that passes each item to [`EACH`].
    #[serde(default)]
    pub items: bool,
    /// True if its author may assign it.
    #[serde(default)]
    pub mutable: bool,
}

/// Statements, then perhaps a value.
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
        /// The author's name.
        name: String,
        /// Its type.
        slot: u32,
        /// Its first value.
        value: Option<Expr>,
        /// Site of the start of the statement.
        site: Site,
        /// True if its author may assign it.
        #[serde(default)]
        mutable: bool,
    },
    /// `let (a, b) = value;` and the like.
    Apart {
        /// The part that is taken from the value.
        pattern: Box<Pattern>,
        /// The value.
        value: Expr,
        /// `else`: what is done if the pattern does not take the value; it never comes to its end.
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
    /// Its kind.
    pub kind: ExprKind,
    /// Site of the expression.
    pub site: Site,
    /// The slot that holds its type, where rustc had something to decide.
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
    /// Digits in base ten, or behind `0x` in base sixteen, and the suffix if any.
    Int(String, Option<Scalar>),
    /// Digits as the author wrote them without underscores, and the suffix if any.
    Float(String, Option<Scalar>),
    /// `b"text"`.
    Bytes(Vec<u8>),
    /// A local by its name.
    Local(String),
    /// A path that is no local: index into [`Function::constants`]; the path as the author wrote it.
    Path(u32, String),
    /// `-x`, `!x`.
    Unary(UnaryOp, Box<Expr>),
    /// `a + b` and the like.
    Binary(BinaryOp, Box<Expr>, Box<Expr>),
    /// `place = value`, or `place += value` and the like.
    Assign(Option<BinaryOp>, Box<Expr>, Box<Expr>),
    /// A call, a method's receiver first: index into [`Function::callees`].
    Call(u32, Vec<Expr>),
    /// `|x| …` as the argument of a call. Before the builder has seen it, one with a slot is a function by its name: what
    /// the slot has are the types of its arguments.
    Closure(Closure),
    /// `f(x)`, where `f` is a parameter that takes a closure.
    Apply(String, Vec<Expr>),
    /// `base.name`.
    Field(Box<Expr>, String),
    /// `base[index]`.
    Index(Box<Expr>, Box<Expr>),
    /// `base[from..to]`, or `base[from..=to]` when true; an end that is left out is the base's.
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
    /// `value?`; with the label of what it leaves, where that is no function: the body of a closure.
    Try(Option<String>, Box<Expr>),
    /// `if`.
    If(Box<Expr>, Block, Option<Box<Expr>>),
    /// `match`.
    Match(Box<Expr>, Vec<Arm>),
    /// `{ … }`.
    Block(Block),
    /// `'label: { … }`: what leaves it early says its label, and its value.
    Labelled(String, Block),
    /// `for pattern in source`.
    Each {
        /// The author's label, without the apostrophe.
        label: Option<String>,
        /// The part that is taken from each item.
        pattern: Box<Pattern>,
        /// Sequence that it iterates over.
        source: Box<Source>,
        /// Largest number of passes of the author's own iterator: a literal or a constant.
        bound: Option<Box<Expr>>,
        /// The body.
        body: Block,
    },
    /// The result that a loop gathers: `values.iter().sum()`, `values.map(…)` and the like.
    Fold {
        /// The name of what is gathered.
        name: String,
        /// Its value before the loop.
        start: Start,
        /// The loop, which assigns it.
        each: Box<Expr>,
    },
    /// `while condition`, or `loop` without one.
    While {
        /// The author's label, without the apostrophe.
        label: Option<String>,
        /// The condition for another pass.
        condition: Option<Box<Expr>>,
        /// Largest number of passes: a literal or a constant. Without one it must be evident.
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

/// The result before the first pass of a loop.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Start {
    /// An empty sum: 0, of floats −0.
    Sum,
    /// An empty product: 1.
    Product,
    /// A value that the passes go on with, as long as what they give has one.
    Tried(Box<Expr>),
    /// Nothing yet: each pass assigns an element.
    Elements,
}

/// An arm of a `match`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Arm {
    /// Values that it matches.
    pub pattern: Pattern,
    /// A further condition.
    pub guard: Option<Expr>,
    /// Its value.
    pub body: Expr,
    /// Site of its pattern.
    pub site: Site,
}

/// A closure as the argument of a call.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Closure {
    /// The author's name for it, if it has one.
    pub name: Option<String>,
    /// Its parameters.
    pub parameters: Vec<Pattern>,
    /// Its value.
    pub body: Box<Expr>,
}

/// The slot of a name that no author wrote: its type is that of what it represents.
pub const NO_SLOT: u32 = u32::MAX;

/// The variant that `?` goes on with, in a pattern: `Some`, or `Ok`.
pub const GOES_ON: &str = "?";

/// Name of the parameter of a function that returns an iterator, and of an iterator argument: the closure to which it
/// passes each item.
pub const EACH: &str = "__each";

/// The method of a type that gives an iterator of what it holds, `set.iter()`: the macro leaves it to whom it precedes.
pub const ITER: &str = "iter";

/// The trait by which a type of the author's is an iterator.
pub const ITERATOR: &str = "Iterator";

/// The name of a method that an adaptor may be as well, and that gives what is changed.
pub const ITER_MUT: &str = "iter_mut";

/// A pattern.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Pattern {
    /// `_`.
    Any,
    /// `..` in a list.
    Rest,
    /// `name`, `name @ pattern`.
    Name {
        /// The author's name.
        name: String,
        /// Its type.
        slot: u32,
        /// True if it may be assigned.
        mutable: bool,
        /// The pattern behind `@`, if there is one.
        inner: Option<Box<Pattern>>,
    },
    /// A literal or a path.
    Value(Expr),
    /// `from..=to`, each end a literal or a path; an end that is left out is the type's.
    Range {
        /// The first value.
        from: Option<Expr>,
        /// The last value, plus one unless `inclusive`.
        to: Option<Expr>,
        /// True if `to` itself is included.
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
