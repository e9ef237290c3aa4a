//! The IR: a module of typed types, constants and functions.
//!
//! * Types and functions are handles into the module's tables; a definition refers only to earlier ones, so there is
//!   no recursion.
//! * Control flow consists of statements; a value that depends on it is a local that the statements assign.
//!   Expressions have no effect, except that calls may write through `RefMut` arguments.
//! * Operations have Rust's meaning: integers, indices and shifts are checked, floats round once to nearest.
//! * Evaluation is left to right, operands before the operation.
//! * Every node has its [`Span`]. Spans never influence the emitted C.

use alloc::boxed::Box;
use alloc::collections::BTreeMap;
use alloc::string::String;
use alloc::vec::Vec;

use crate::attributes::{Attributes, Given};
pub use crate::data::{Enum, Field, Form, Struct, Variant};
use crate::kernel::Kernel;
use crate::number::{Float, Int, Scalar};
pub use crate::operation::{Intrinsic, Routine};
pub use crate::operator::{BinaryOp, CompareOp, LogicOp, UnaryOp};
use crate::written::Written;

macro_rules! handles {
    ($($(#[$doc:meta])* $name:ident),* $(,)?) => {$(
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
        pub struct $name(pub u32);

        impl $name {
            /// Returns the handle as an index into its table.
            pub const fn index(self) -> usize {
                self.0 as usize
            }
        }
    )*};
}

handles! {
    /// A struct of [`Module::structs`].
    StructId,
    /// An enum of [`Module::enums`].
    EnumId,
    /// A constant of [`Module::consts`].
    ConstId,
    /// A function of [`Module::functions`].
    FunctionId,
    /// A local of [`Function::locals`].
    LocalId,
}

/// Position of a node in the author's source. Lines and columns count from 1; line 0 means no position.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Span {
    /// Index into [`Module::files`].
    pub file: u32,
    /// Line, from 1.
    pub line: u32,
    /// Column, from 1.
    pub column: u32,
}

/// Everything that one generation compiles.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Module {
    /// The Rust package.
    pub name: String,
    /// Source files, relative to the workspace, with forward slashes.
    pub files: Vec<String>,
    /// Module comments of each source file, by its path, one entry per line.
    pub about: BTreeMap<String, Vec<String>>,
    /// Structs; fields refer to earlier ones.
    pub structs: Vec<Struct>,
    /// Enums.
    pub enums: Vec<Enum>,
    /// Named constants.
    pub consts: Vec<Const>,
    /// Functions; callees before callers.
    pub functions: Vec<Function>,
    /// Literals that authors do not write in decimal, by span and word. They affect only the appearance of the C.
    pub written: BTreeMap<(Span, u64), Written>,
}

/// A constant that rustc evaluated.
#[derive(Clone, Debug, PartialEq)]
pub struct Const {
    /// Author's name, such as `GRAVITY`.
    pub name: String,
    /// Rust module of its definition if the DSL sees it, else of its first use.
    pub module: String,
    /// Type of the constant.
    pub ty: Type,
    /// Words of its value, in the order of [`Module::leaves`].
    pub words: Vec<u64>,
    /// Author's doc comment, one entry per line, if the DSL sees it.
    pub docs: Vec<String>,
    /// Author's attributes for the C.
    pub given: Given,
    /// Span of the name, if the DSL sees it.
    pub span: Span,
}

impl Const {
    /// Module of the constants of names, `"pump"`, which belong to no module of an author.
    pub const NAMES: &str = "str::name";

    /// Returns true for the constant of a name.
    pub fn is_name(&self) -> bool {
        self.module == Const::NAMES
    }

    /// Returns its module and name as a path, in the form of [`Given::sizes`].
    pub fn path(&self) -> String {
        alloc::format!("{}::{}", self.module, self.name)
    }
}

/// The type of a value.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Type {
    /// No value.
    Unit,
    /// One word.
    Scalar(Scalar),
    /// An array, `[element; len]`.
    Array {
        /// The type of each element.
        element: Box<Type>,
        /// Number of elements.
        len: u32,
    },
    /// nalgebra's `SMatrix<element, rows, cols>`; a vector has one column. Stored by columns.
    Matrix {
        /// The type of each element.
        element: Scalar,
        /// Rows.
        rows: u32,
        /// Columns.
        cols: u32,
    },
    /// A struct.
    Struct(StructId),
    /// An enum.
    Enum(EnumId),
    /// A slice, `[element]`. Its length is the next parameter, a `usize` by value. Only parameters of mode `Ref` and
    /// `RefMut` and their arguments have this type.
    Slice(Box<Type>),
}

/// A function, a method or an entry point.
#[derive(Clone, Debug, PartialEq)]
pub struct Function {
    /// Author's name, such as `step`.
    pub name: String,
    /// Rust module, such as `models::attitude`.
    pub module: String,
    /// Type of which it is a method or an associated function.
    pub owner: Option<Owner>,
    /// Role of the function for its callers.
    pub role: Role,
    /// Author's attributes for the C.
    pub attributes: Attributes,
    /// Author's doc comment, one entry per line.
    pub docs: Vec<String>,
    /// All locals; the first [`Function::params`] of them are the parameters.
    pub locals: Vec<Local>,
    /// Number of locals that are parameters.
    pub params: u32,
    /// Type of the result; never a reference.
    pub result: Type,
    /// Name of the result where the C needs one (an output pointer).
    pub result_name: String,
    /// Statements. Every path ends in `Return` unless the result is `Unit`.
    pub body: Block,
    /// Kernel that the function computes, if it has no body (see [`Kernel::function`]).
    pub kernel: Option<Kernel>,
    /// Span of the name.
    pub span: Span,
}

/// The type that a method belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[allow(missing_docs)]
pub enum Owner {
    Struct(StructId),
    Enum(EnumId),
}

/// The role of a function for its callers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Role {
    /// Called by the firmware.
    Entry {
        /// True if the author declares that it cannot fault; generation must prove it.
        infallible: bool,
    },
    /// Called by other modules: a free function, or a method of plain data.
    Public,
    /// Called only in its own file: a component's method, or an item that is not `pub`.
    Private,
    /// Small enough to be inlined.
    Inline {
        /// True if other modules may call it.
        public: bool,
    },
}

/// A parameter or a variable. Names need not be unique; handles are.
#[derive(Clone, Debug, PartialEq)]
pub struct Local {
    /// Author's name, or a generated one for an unnamed value.
    pub name: String,
    /// The type of the value, of the pointee for a reference.
    pub ty: Type,
    /// Passing mode of the local.
    pub mode: Mode,
    /// Span of the declaration.
    pub span: Span,
}

/// Passing mode of a local.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mode {
    /// A parameter by value (the callee's own copy), or a variable.
    Value,
    /// A parameter `&T`.
    Ref,
    /// A parameter `&mut T`.
    RefMut,
}

/// Statements in sequence; the scope of the locals that it declares.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Block(pub Vec<Stmt>);

/// A statement.
#[derive(Clone, Debug, PartialEq)]
pub struct Stmt {
    /// Kind of the statement.
    pub kind: StmtKind,
    /// Span of the start.
    pub span: Span,
    /// Author's `//` comment lines directly above it, without the slashes.
    pub comments: Vec<String>,
}

/// The kinds of statements.
#[derive(Clone, Debug, PartialEq)]
pub enum StmtKind {
    /// Declares a local, with its first value unless a later statement assigns it. With mode `RefMut` the local is an
    /// alias of the place.
    Let {
        /// The local.
        local: LocalId,
        /// Initial value of the local.
        value: Option<Expr>,
    },
    /// Writes `value` to `place`: the value is evaluated first, then the indices of the place.
    Assign {
        /// Place that is written.
        place: Place,
        /// Value that is written.
        value: Expr,
    },
    /// An expression whose value is unused, such as a call for its effect.
    Expr(Expr),
    /// `if`.
    If {
        /// Condition, a `bool`.
        condition: Expr,
        /// Statements if it is true.
        then: Block,
        /// Statements if it is false.
        otherwise: Block,
    },
    /// A `match` on an integer or an enum; some arm always matches.
    Match {
        /// An integer or an enum.
        scrutinee: Expr,
        /// Arms in order; their values are distinct.
        arms: Vec<Arm>,
        /// Statements for all other values. Always present for integers; absent for an enum whose arms name all
        /// variants.
        otherwise: Option<Block>,
    },
    /// `for variable in from..to`, or `from..=to`; the bounds are evaluated once, before the loop.
    For {
        /// Counter, an integer that is declared here and that the body does not assign.
        variable: LocalId,
        /// First value.
        from: Expr,
        /// Last value, plus one unless `inclusive`.
        to: Expr,
        /// True if the range includes `to`.
        inclusive: bool,
        /// True if it counts from the last value to the first (`.rev()`).
        reversed: bool,
        /// Unroll factor for compilers; 1 means no unrolling.
        unroll: Option<u32>,
        /// True if the body itself ends the loop within the range, so that no counter is needed. An example is an
        /// author's `while` with a proved bound. The first pass begins even if the range is empty, and tests the
        /// condition.
        ended: bool,
        /// The body.
        body: Block,
    },
    /// Ends the function with `fault` unless `condition` holds. The passes insert checks; afterwards no operation
    /// faults by itself.
    Check {
        /// Condition, a `bool` that cannot fault.
        condition: Expr,
        /// Reported fault.
        fault: Fault,
    },
    /// Ends the function.
    Return(Option<Expr>),
    /// Ends the innermost loop.
    Break,
    /// Ends this pass of the innermost loop.
    Continue,
}

/// Faults: reasons for which Rust would panic.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Fault {
    /// The result of integer arithmetic is out of range.
    Overflow,
    /// Integer division by zero.
    DivisionByZero,
    /// Shift by at least the width.
    Shift,
    /// Index out of range.
    Index,
    /// `clamp` without `low <= high`.
    Clamp,
    /// An enum holds no valid variant, since a caller violated the precondition.
    Variant,
    /// A failed assertion of the author's.
    Assertion,
    /// A loop would exceed its declared bound.
    Bound,
    /// `unwrap` of `None` or `Err`.
    Absent,
    /// A bounded container is full.
    Capacity,
    /// A proved condition does not hold: a bug of the compiler, which only checks that are kept for tests can report.
    LeftOut,
}

/// An arm of a [`StmtKind::Match`].
#[derive(Clone, Debug, PartialEq)]
pub struct Arm {
    /// Integers, or indices of variants; at least one.
    pub values: Vec<i128>,
    /// Statements of the arm.
    pub body: Block,
}

/// An expression.
#[derive(Clone, Debug, PartialEq)]
pub struct Expr {
    /// Kind of the expression.
    pub kind: ExprKind,
    /// The type of its value.
    pub ty: Type,
    /// Span of the expression.
    pub span: Span,
}

/// The kinds of expressions.
#[derive(Clone, Debug, PartialEq)]
pub enum ExprKind {
    /// A scalar or an enum, as a word.
    Literal(u64),
    /// A named constant.
    Const(ConstId),
    /// The value at a place.
    Load(Place),
    /// An operation on one scalar, with a result of the same type.
    Unary(UnaryOp, Box<Expr>),
    /// An operation on two scalars of one type (the right side of a shift may be any integer), with a result of the
    /// left's type.
    Binary(BinaryOp, Box<Expr>, Box<Expr>),
    /// A comparison of two scalars or enums of one type, with a `bool` result.
    Compare(CompareOp, Box<Expr>, Box<Expr>),
    /// A short-circuit operation on `bool`s.
    Logic(LogicOp, Box<Expr>, Box<Expr>),
    /// Rust's `as`: from a scalar or enum to the scalar that is the node's type.
    Cast(Box<Expr>),
    /// An intrinsic function of scalars, defined by the DSL.
    Intrinsic(Intrinsic, Vec<Expr>),
    /// A call.
    Call(FunctionId, Vec<Argument>),
    /// A struct; fields are in the order of the definition.
    Struct(Vec<Expr>),
    /// An array of these elements.
    Array(Vec<Expr>),
    /// An array or matrix in which every element has this value.
    Splat(Box<Expr>),
    /// A matrix of these elements, by columns.
    Matrix(Vec<Expr>),
    /// A routine of linear algebra.
    Routine(Routine, Vec<Expr>),
}

/// The arguments of a call.
#[derive(Clone, Debug, PartialEq)]
pub enum Argument {
    /// To a parameter of mode `Value`.
    Value(Expr),
    /// To a parameter of mode `Ref`: any value; a place is passed without a copy.
    Ref(Expr),
    /// To a parameter of mode `RefMut`.
    RefMut(Place),
}

/// Place that holds a value: a local, followed by steps into it.
#[derive(Clone, Debug, PartialEq)]
pub struct Place {
    /// A parameter or variable.
    pub root: LocalId,
    /// Steps into the local.
    pub steps: Vec<Step>,
    /// Type of the place.
    pub ty: Type,
    /// Span of the place.
    pub span: Span,
}

/// One step into a value.
#[derive(Clone, Debug, PartialEq)]
pub enum Step {
    /// A field of a struct, by index.
    Field(u32),
    /// An element of an array, or of a matrix by columns; the index has any integer type and is checked.
    Index(Expr),
    /// An element of a matrix; row and column are checked.
    Element(Expr, Expr),
    /// The elements from a checked index on, of an array, a slice or a matrix by columns. It is the last step of a
    /// slice argument.
    From(Expr),
}

impl Type {
    /// Type `bool`.
    pub const BOOL: Type = Type::Scalar(Scalar::Bool);
    /// Type `f64`.
    pub const F64: Type = Type::Scalar(Scalar::Float(Float::F64));
    /// Type `f32`.
    pub const F32: Type = Type::Scalar(Scalar::Float(Float::F32));
    /// Type `usize`.
    pub const USIZE: Type = Type::Scalar(Scalar::Int(Int::Usize));

    /// Returns true if a value is one word: a scalar or an enum.
    pub fn is_word(&self) -> bool {
        matches!(self, Type::Scalar(_) | Type::Enum(_))
    }

    /// Returns true if values have parts: arrays, matrices, structs, slices.
    pub fn is_aggregate(&self) -> bool {
        matches!(self, Type::Array { .. } | Type::Matrix { .. } | Type::Struct(_) | Type::Slice(_))
    }

    /// Returns true if the type is an array in C, which is its own address.
    pub fn is_array(&self) -> bool {
        matches!(self, Type::Array { .. } | Type::Matrix { .. } | Type::Slice(_))
    }

    /// Returns the integer type, if it is one.
    pub fn as_int(&self) -> Option<Int> {
        match self {
            Type::Scalar(Scalar::Int(int)) => Some(*int),
            _ => None,
        }
    }

    /// Returns the float type, if it is one.
    pub fn as_float(&self) -> Option<Float> {
        match self {
            Type::Scalar(Scalar::Float(float)) => Some(*float),
            _ => None,
        }
    }
}

impl Module {
    /// Returns the number of words of a value of type `ty`: the number of its [`leaves`](Self::leaves).
    pub fn width(&self, ty: &Type) -> usize {
        match ty {
            Type::Unit | Type::Slice(_) => 0,
            Type::Scalar(_) | Type::Enum(_) => 1,
            Type::Array { element, len } => self.width(element).saturating_mul(*len as usize),
            Type::Matrix { rows, cols, .. } => (*rows * *cols) as usize,
            Type::Struct(id) => {
                let fields = &self.structs[id.index()].fields;
                fields.iter().map(|field| self.width(&field.ty)).sum()
            }
        }
    }

    /// Returns the one-word types of which a value of type `ty` consists, in the order of its words. Fields and
    /// elements are in order, matrices by columns.
    pub fn leaves(&self, ty: &Type) -> Vec<Type> {
        match ty {
            Type::Unit | Type::Slice(_) => Vec::new(),
            Type::Scalar(_) | Type::Enum(_) => alloc::vec![ty.clone()],
            Type::Array { element, len } => {
                let one = self.leaves(element);
                (0..*len).flat_map(|_| one.iter().cloned()).collect()
            }
            Type::Matrix { element, rows, cols } => {
                alloc::vec![Type::Scalar(*element); (*rows * *cols) as usize]
            }
            Type::Struct(id) => self.structs[id.index()]
                .fields
                .iter()
                .flat_map(|field| self.leaves(&field.ty))
                .collect(),
        }
    }

    /// Returns the type of the part that a step selects in a value of type `ty`; none if there is no such part.
    pub fn step_type(&self, ty: &Type, step: &Step) -> Option<Type> {
        Some(match (step, ty) {
            (Step::Field(field), Type::Struct(id)) => {
                self.structs.get(id.index())?.fields.get(*field as usize)?.ty.clone()
            }
            (Step::Index(_), Type::Array { element, .. } | Type::Slice(element)) => {
                (**element).clone()
            }
            (Step::From(_), Type::Array { element, .. } | Type::Slice(element)) => {
                Type::Slice(element.clone())
            }
            (Step::From(_), Type::Matrix { element, .. }) => {
                Type::Slice(Box::new(Type::Scalar(*element)))
            }
            (Step::Index(_) | Step::Element(..), Type::Matrix { element, .. }) => {
                Type::Scalar(*element)
            }
            _ => return None,
        })
    }
}

impl Block {
    /// Returns the condition under which a loop ends, if its body begins with a test that only leaves it.
    pub fn head(&self) -> Option<&Expr> {
        let StmtKind::If { condition, then, otherwise } = &self.0.first()?.kind else {
            return None;
        };
        let ends = matches!(then.0.as_slice(), [Stmt { kind: StmtKind::Break, .. }]);
        (ends && otherwise.0.is_empty()).then_some(condition)
    }
}

impl Function {
    /// Returns the parameters.
    pub fn parameters(&self) -> &[Local] {
        &self.locals[..self.params as usize]
    }

    /// Returns a local by its handle.
    pub fn local(&self, id: LocalId) -> &Local {
        &self.locals[id.index()]
    }
}
