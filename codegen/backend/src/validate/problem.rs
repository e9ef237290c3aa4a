//! Violations of a module's invariants.

use bessemer_ir::{
    BinaryOp, ConstId, EnumId, FunctionId, Intrinsic, LocalId, Routine, Span, StructId, Type,
    UnaryOp,
};

use bessemer_ir::words::WordsError;

/// A violated invariant and its place.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{subject:?}, {}:{}:{}: {problem}", span.file, span.line, span.column)]
pub struct Error {
    /// Violated invariant.
    pub problem: Problem,
    /// Definition in which it was found.
    pub subject: Subject,
    /// Span at which it was found.
    pub span: Span,
}

/// A definition.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs)]
pub enum Subject {
    Struct(StructId),
    Enum(EnumId),
    Const(ConstId),
    Function(FunctionId),
}

/// Violations of the invariants.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[allow(missing_docs)]
pub enum Problem {
    #[error("there is no struct {}", .0.0)]
    UnknownStruct(StructId),
    #[error("struct {} is not defined before its use", .0.0)]
    LaterStruct(StructId),
    #[error("there is no enum {}", .0.0)]
    UnknownEnum(EnumId),
    #[error("there is no constant {}", .0.0)]
    UnknownConst(ConstId),
    #[error("there is no function {}", .0.0)]
    UnknownFunction(FunctionId),
    #[error("function {} is not defined before its use", .0.0)]
    LaterFunction(FunctionId),
    #[error("there is no local {}", .0.0)]
    UnknownLocal(LocalId),
    #[error("there is no file {0}")]
    UnknownFile(u32),
    #[error("a type without values or without words")]
    EmptyType,
    #[error("`Unit` where a value has to be")]
    UnitValue,
    #[error("a type of more than {} words", super::MAX_WORDS)]
    TypeTooLarge,
    #[error("nested too deep")]
    NestedTooDeep,
    #[error("`{0}` is defined twice")]
    DuplicateName(String),
    #[error("field {0} cannot be what this form makes of it")]
    Form(u32),
    #[error("a choice whose first part is not a literal, or names no case")]
    OpenChoice,
    #[error("{0}")]
    Words(#[from] WordsError),
    #[error("{params} parameters among {locals} locals")]
    ParameterCount { params: u32, locals: usize },
    #[error("local {} is a reference, but no parameter, and no name for a place", .0.0)]
    ReferenceLocal(LocalId),
    #[error("a kernel with another face or a body")]
    Kernel,
    #[error("a path ends without returning a value")]
    MissingReturn,
    #[error("local {} is declared twice", .0.0)]
    DeclaredTwice(LocalId),
    #[error("local {} is used where it is not declared", .0.0)]
    NotInScope(LocalId),
    #[error("local {} is used where it may not have been assigned", .0.0)]
    NotAssigned(LocalId),
    #[error("parameter {} is a shared reference: nothing is written through it", .0.0)]
    WrittenReference(LocalId),
    #[error("local {} counts a loop: nothing else writes it", .0.0)]
    WrittenCounter(LocalId),
    #[error("expected the type {expected:?}, found {found:?}")]
    TypeMismatch { expected: Type, found: Type },
    #[error("a match on {0:?}")]
    MatchType(Type),
    #[error("an arm without values")]
    MatchArmEmpty,
    #[error("{0} is no value of what is matched")]
    MatchValueOutOfRange(i128),
    #[error("{0} is matched twice")]
    MatchValueTwice(i128),
    #[error("not every value is matched")]
    MatchNotExhaustive,
    #[error("a loop over {0:?}")]
    LoopType(Type),
    #[error("`break` or `continue` outside of a loop")]
    OutsideLoop,
    #[error("a value is returned where none is wanted, or the other way round")]
    ReturnValue,
    #[error("a call in the condition of a check")]
    CallInCheck,
    #[error("{word:#x} is no value of {ty:?}")]
    LiteralWord { word: u64, ty: Type },
    #[error("{op:?} of {ty:?}")]
    UnaryOperand { op: UnaryOp, ty: Type },
    #[error("{op:?} of {ty:?}")]
    BinaryOperand { op: BinaryOp, ty: Type },
    #[error("a comparison of {0:?}")]
    CompareOperand(Type),
    #[error("a cast from {from:?} to {to:?}")]
    Cast { from: Type, to: Type },
    #[error("{function:?} of {ty:?}")]
    IntrinsicOperand { function: Intrinsic, ty: Type },
    #[error("{expected} operands are wanted, not {found}")]
    OperandCount { expected: usize, found: usize },
    #[error("a value of type {0:?} is made of other parts than these")]
    Parts(Type),
    #[error("{routine:?} of {operands:?}")]
    Shape { routine: Routine, operands: Vec<Type> },
    #[error("argument {0} is not passed as its parameter asks")]
    ArgumentMode(usize),
    #[error("argument {0} overlaps what another argument lends")]
    Alias(usize),
    #[error("a slice that is not passed, or without its length behind it")]
    Slice,
    #[error("step {step} does not lead into {ty:?}")]
    Step { step: usize, ty: Type },
    #[error("an index of type {0:?}")]
    IndexType(Type),
}
