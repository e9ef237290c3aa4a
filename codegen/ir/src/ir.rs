//! The IR: a module of types, constants and functions, all typed.
//!
//! * Types and functions are handles into the module's tables; a definition refers to earlier ones alone: no recursion.
//! * Control flow is statements; a value that depends on control flow is a local that the statements
//!   assign. Expressions have no effect, save that calls may write through `RefMut` arguments.
//! * Operations mean what Rust means: integers, indices and shifts are checked, floats round once to nearest.
//! * Evaluation is left to right, operands before the operation.
//! * Every node carries its [`Span`]. Spans never influence the emitted C.

use alloc::boxed::Box;
use alloc::collections::{BTreeMap, BTreeSet};
use alloc::string::String;
use alloc::vec::Vec;

use crate::attributes::{Attributes, Given};
pub use crate::data::{Enum, Field, Form, Struct, Variant};
use crate::kernel::Kernel;
use crate::number::{Float, Int, Scalar};
pub use crate::operation::{Intrinsic, Routine};
pub use crate::operator::{BinaryOp, CompareOp, LogicOp, UnaryOp};

macro_rules! handles {
    ($($(#[$doc:meta])* $name:ident),* $(,)?) => {$(
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
        pub struct $name(pub u32);

        impl $name {
            /// The handle as an index into its table.
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

/// Position of a node in the author's source. Lines and columns count from 1; line 0 means no position. Lines and
/// columns count from 1; line 0: nowhere.
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
    /// The literals that authors write in base sixteen, or in base two, which C has no form for: where each stands, and its
    /// word. It is how they look, and no part of what they are.
    pub hexadecimal: BTreeSet<(Span, u64)>,
}

/// A constant that rustc evaluated.
#[derive(Clone, Debug, PartialEq)]
pub struct Const {
    /// The author's name, `GRAVITY`.
    pub name: String,
    /// The Rust module that it is in if the DSL sees it, else that of its first use.
    pub module: String,
    /// Its type.
    pub ty: Type,
    /// Its value as words, in the order of [`Module::leaves`].
    pub words: Vec<u64>,
    /// The author's doc comment, a line each, of one that the DSL sees.
    pub docs: Vec<String>,
    /// The author's wishes for its C.
    pub given: Given,
    /// Span of the name, if the DSL sees it.
    pub span: Span,
}

impl Const {
    /// Its name with its module before it, as [`Given::sizes`] has it.
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
    /// `[element; len]`.
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
    /// `[element]`: as many as the local behind the parameter says, which is a `usize` by value. Of
    /// parameters of mode `Ref` and `RefMut` alone, and of what is passed to them.
    Slice(Box<Type>),
}

/// A function, a method or an entry point.
#[derive(Clone, Debug, PartialEq)]
pub struct Function {
    /// The author's name, `step`.
    pub name: String,
    /// The Rust module, `models::attitude`.
    pub module: String,
    /// The type whose method or associated function it is.
    pub owner: Option<Owner>,
    /// Its role for its callers.
    pub role: Role,
    /// The author's wishes for its C.
    pub attributes: Attributes,
    /// The author's doc comment, a line each.
    pub docs: Vec<String>,
    /// Every local; the first [`Function::params`] of them are the parameters.
    pub locals: Vec<Local>,
    /// Number of locals that are parameters.
    pub params: u32,
    /// The type of the result; never a reference.
    pub result: Type,
    /// The name to give to the result where C needs one (an output pointer).
    pub result_name: String,
    /// Its statements. Every path ends in `Return` unless the result is `Unit`.
    pub body: Block,
    /// For a function without a body of its own: what it computes (see [`Kernel::function`]).
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
    /// Called by the firmware; the author's claim that no fault is left, if any.
    Entry {
        /// Generation has to prove that no fault is left.
        infallible: bool,
    },
    /// Called by other modules: a free function, or a method of plain data.
    Public,
    /// Called only beside its definition: a component's own method, or what is not `pub`.
    Private,
    /// Small enough to stand where it is called.
    Inline {
        /// Other modules may call it.
        public: bool,
    },
}

/// A parameter or a variable. Names need not be unique; handles are.
#[derive(Clone, Debug, PartialEq)]
pub struct Local {
    /// The author's name (or one made for a value that the author left unnamed).
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

/// Statements in sequence; locals declared in it end with it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Block(pub Vec<Stmt>);

/// A statement.
#[derive(Clone, Debug, PartialEq)]
pub struct Stmt {
    /// Its kind.
    pub kind: StmtKind,
    /// Span of the start.
    pub span: Span,
    /// The author's `//` comment lines right above it, without the slashes.
    pub comments: Vec<String>,
}

/// The kinds of statements.
#[derive(Clone, Debug, PartialEq)]
pub enum StmtKind {
    /// Declares a local, with its first value unless later ones assign it; of mode `RefMut`: a name for that place.
    Let {
        /// The local.
        local: LocalId,
        /// Its first value.
        value: Option<Expr>,
    },
    /// Writes `value` to `place`: the value is evaluated first, then the indices of the place.
    Assign {
        /// Place that is written.
        place: Place,
        /// Value that is written.
        value: Expr,
    },
    /// Calls for effect, or any expression whose value is not wanted.
    Expr(Expr),
    /// `if`.
    If {
        /// A `bool`.
        condition: Expr,
        /// When true.
        then: Block,
        /// When false.
        otherwise: Block,
    },
    /// `match` on an integer or an enum; some arm always matches.
    Match {
        /// An integer or an enum.
        scrutinee: Expr,
        /// In order; values of different arms are distinct.
        arms: Vec<Arm>,
        /// Everything else. Always present for integers; absent for an enum whose arms name all.
        otherwise: Option<Block>,
    },
    /// `for variable in from..to`, or `from..=to`; the bounds are evaluated once, before.
    For {
        /// The local that counts, declared here, an integer, not assigned by the body.
        variable: LocalId,
        /// The first value.
        from: Expr,
        /// The last value, plus one unless `inclusive`.
        to: Expr,
        /// True if the end itself is included.
        inclusive: bool,
        /// Counts down from the last to the first (`.rev()`).
        reversed: bool,
        /// Number of passes that compilers are asked to unroll; 1 keeps the loop.
        unroll: Option<u32>,
        /// True if the body itself ends the loop within the range, so that no counter is needed. An example is a
        /// `while` of the author's whose passes are bounded by what it counts. The first pass begins even if the range
        /// is empty, and evaluates the condition.
        ended: bool,
        /// The body.
        body: Block,
    },
    /// Ends the function with `fault` unless `condition` holds. Written by the pass that makes faults
    /// explicit; after it no operation faults by itself.
    Check {
        /// A `bool` that cannot fault.
        condition: Expr,
        /// The fault to report.
        fault: Fault,
    },
    /// Ends the function.
    Return(Option<Expr>),
    /// Ends the innermost loop.
    Break,
    /// Ends this pass of the innermost loop.
    Continue,
}

/// Why a function could not go on: where Rust would panic.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Fault {
    /// Integer arithmetic left its type.
    Overflow,
    /// An integer was divided by zero.
    DivisionByZero,
    /// A shift by the width or more.
    Shift,
    /// An index beyond the end.
    Index,
    /// `clamp` with bounds that are not `low <= high`.
    Clamp,
    /// An enum that holds none of its variants (a caller broke the precondition).
    Variant,
    /// An assertion of the author's.
    Assertion,
    /// A loop that would run more often than its bound says.
    Bound,
    /// `unwrap` of what holds no value.
    Absent,
    /// A bounded container that is full.
    Capacity,
    /// A proved condition does not hold: a mistake of the compiler's, told by a check that is left out otherwise.
    LeftOut,
}

/// An arm of a [`StmtKind::Match`].
#[derive(Clone, Debug, PartialEq)]
pub struct Arm {
    /// Integers, or indices of variants; at least one.
    pub values: Vec<i128>,
    /// Its statements.
    pub body: Block,
}

/// An expression.
#[derive(Clone, Debug, PartialEq)]
pub struct Expr {
    /// Its computation.
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
    /// One operand, a scalar, result of the same type.
    Unary(UnaryOp, Box<Expr>),
    /// Two scalars of one type (a shift's right side may be any integer), result of the left's type.
    Binary(BinaryOp, Box<Expr>, Box<Expr>),
    /// Two scalars or enums of one type, result `bool`.
    Compare(CompareOp, Box<Expr>, Box<Expr>),
    /// Short-circuit; `bool`s.
    Logic(LogicOp, Box<Expr>, Box<Expr>),
    /// Rust's `as`: from a scalar or enum to the scalar that is the node's type.
    Cast(Box<Expr>),
    /// A function of scalars that the DSL defines; operands and result of one scalar type.
    Intrinsic(Intrinsic, Vec<Expr>),
    /// A call.
    Call(FunctionId, Vec<Argument>),
    /// A struct, its fields in the order of the definition.
    Struct(Vec<Expr>),
    /// An array of these elements.
    Array(Vec<Expr>),
    /// An array or matrix with this value everywhere.
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
    /// To a parameter of mode `Ref`: any value; a place is not copied.
    Ref(Expr),
    /// To a parameter of mode `RefMut`.
    RefMut(Place),
}

/// Place that holds a value: a local, followed by steps into it.
#[derive(Clone, Debug, PartialEq)]
pub struct Place {
    /// A parameter or variable.
    pub root: LocalId,
    /// Steps inward.
    pub steps: Vec<Step>,
    /// The type of what is there.
    pub ty: Type,
    /// Span of the place.
    pub span: Span,
}

/// One step into a value.
#[derive(Clone, Debug, PartialEq)]
pub enum Step {
    /// A field of a struct, by index.
    Field(u32),
    /// An element of an array, or of a matrix by columns; the index is of any integer type, checked.
    Index(Expr),
    /// An element of a matrix by row and column, each checked.
    Element(Expr, Expr),
    /// The elements of an array or a slice from an index on, checked (of a matrix by columns). It is the last step of a
    /// slice argument.
    From(Expr),
}

impl Type {
    /// `bool`.
    pub const BOOL: Type = Type::Scalar(Scalar::Bool);
    /// `f64`.
    pub const F64: Type = Type::Scalar(Scalar::Float(Float::F64));
    /// `f32`.
    pub const F32: Type = Type::Scalar(Scalar::Float(Float::F32));
    /// `usize`.
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

    /// The integer type, if it is one.
    pub fn as_int(&self) -> Option<Int> {
        match self {
            Type::Scalar(Scalar::Int(int)) => Some(*int),
            _ => None,
        }
    }

    /// The float type, if it is one.
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

    /// The type of the part that a step selects in a value of type `ty`; none if such a value has no such part.
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
    /// The condition under which a loop ends, if its body begins with that and nothing else.
    pub fn head(&self) -> Option<&Expr> {
        let StmtKind::If { condition, then, otherwise } = &self.0.first()?.kind else {
            return None;
        };
        let ends = matches!(then.0.as_slice(), [Stmt { kind: StmtKind::Break, .. }]);
        (ends && otherwise.0.is_empty()).then_some(condition)
    }
}

impl Function {
    /// The parameters.
    pub fn parameters(&self) -> &[Local] {
        &self.locals[..self.params as usize]
    }

    /// A local by its handle.
    pub fn local(&self, id: LocalId) -> &Local {
        &self.locals[id.index()]
    }
}
