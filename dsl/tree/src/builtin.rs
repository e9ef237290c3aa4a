//! Operations that the library knows without a function: the results of rustc's method resolution.
//!
//! A companion's marker names one. The front end has an exhaustive `match` for each kind, so an operation that is
//! listed here but not handled does not compile.
//!
//! Must not know: the Rust names of the methods, which belong to the companions.

use serde::{Deserialize, Serialize};

use crate::operation::{Intrinsic, Routine};
use crate::routine::KernelRoutine;

macro_rules! builtins {
    ($($(#[$doc:meta])* $name:ident { $($(#[$of:meta])* $variant:ident $(($($held:ty),*))?,)* })*) => {$(
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
        #[allow(missing_docs)]
        pub enum $name { $($(#[$of])* $variant $(($($held),*))?,)* }
    )*};
}

builtins! {
    /// An operation that the library knows.
    Builtin {
        /// An operation of the IR on scalars.
        Scalar(Intrinsic),
        /// A method of numbers that is composed of such operations.
        Number(NumberMethod),
        /// Conversion of a number to its bytes, or of bytes to a number.
        Bytes(ByteOrder),
        /// `real(0.5)`: a number in double precision as a float of the requested type.
        Real,
        /// `x.as_f64()`: a float in double precision.
        AsF64,
        /// `T::try_from(n)` between integers.
        TryFrom,
        /// A copy of a view, or an unwrapped value; in the C it is the value itself.
        Owned,
        /// A routine of linear algebra, an operation of the IR.
        Linear(Routine),
        /// A constructor of a matrix, its dimensions, or a rearrangement of its elements.
        Matrix(MatrixMethod),
        /// A routine of linear algebra with its own function.
        Kernel(KernelRoutine),
        /// A method of rotations and poses that needs no function.
        Spatial(SpatialMethod),
        /// A struct of the library from its parts, in the order of the arguments.
        Parts(Parts),
        /// A method of `List`.
        List(ListMethod),
        /// A method of slices, or of other types with elements.
        Slice(SliceMethod),
        /// A method of `Option` or `Result` without a closure.
        Option(OptionMethod),
        /// A method that is equivalent to a `match` or a loop.
        Desugared(Desugared),
    }

    /// Methods of numbers that are composed of IR operations.
    NumberMethod {
        Recip, Fract, ToDegrees, ToRadians, Signum, IsSignNegative, IsSignPositive, IsNegative, IsPositive,
        WrappingNeg, WrappingAbs, SwapBytes, IsPowerOfTwo, From,
        CountOnes, CountZeros, LeadingZeros, LeadingOnes, TrailingZeros, TrailingOnes,
        DivEuclid, RemEuclid, WrappingDiv, WrappingRem, AbsDiff,
        WrappingShl, WrappingShr, RotateLeft, RotateRight, ShiftLeft, UnsignedShr, SignedShr,
    }

    /// Order of the bytes of a number.
    ByteOrder {
        /// Least significant byte first.
        Little,
        /// Most significant byte first.
        Big,
    }

    /// Constructors of matrices, dimensions, and rearrangements of elements.
    MatrixMethod {
        /// From its elements, by rows.
        New,
        /// From an array of rows.
        ByRows,
        /// From an array of columns, or such an array from a matrix.
        FromArray,
        Zeros, Identity, FromElement,
        /// Unit vector along an axis.
        Axis(u32),
        Rows, Cols,
        /// Number of elements.
        Elements,
        /// Vector of the components with these indices; the second value is their number.
        Swizzle([u8; 3], u8),
        /// A row, column or block as a place, which can be written.
        Part(MatrixPart),
    }

    /// Indices that define the beginning of a part.
    MatrixPart {
        /// First row: the part has all columns.
        Rows,
        /// First column: the part has all rows.
        Columns,
        /// First row and first column.
        Block,
    }

    /// Methods of rotations and poses that need no function.
    SpatialMethod {
        /// A method of nalgebra that uses the platform's sine, cosine or root, and is refused.
        PlatformAngles,
        QuaternionIdentity, QuaternionCoords,
        /// Conversion to another struct with equal parts, or to the struct itself.
        SameParts,
        /// Product of a matrix and the transpose of another.
        TimesTransposed,
    }

    /// Structs of the library that a constructor builds from parts.
    Parts { Quaternion, Isometry, Complex, }

    /// Methods of `List`.
    ListMethod { New, Push, Pop, Clear, Truncate, Resize, Len, IsEmpty, Capacity, }

    /// Methods of slices.
    SliceMethod {
        /// All elements of a type with elements.
        Whole,
        Len, IsEmpty, First, FirstMut, Last, LastMut, Get, GetMut,
        /// `get(from..to)`.
        GetPart,
        /// `get(from..)`.
        GetFrom,
        SplitAt, SplitAtChecked, SplitFirst, SplitLast,
        /// The first elements as an array of this length, and the others.
        SplitFirstChunk(u32),
        /// All but the last elements, and these as an array of this length.
        SplitLastChunk(u32),
        CopyFrom, Reverse, ToArray, FirstChunk,
    }

    /// Methods of `Option` and `Result` without a closure.
    OptionMethod {
        Unwrap, UnwrapErr, UnwrapOr, Copied, Or, And, Take, Replace,
        OkOr, Ok, Err, AsMut, Insert, GetOrInsert,
        /// `get_or_insert_with`; its closure is evaluated in place.
        GetOrInsertWith,
    }

    /// Methods that are equivalent to a `match` or a loop.
    Desugared {
        ArrayMap, AsRef,
        /// `core::array::from_fn`.
        FromFn,
        /// The iterator itself.
        ByRef,
        /// Items of an iterator combined by an operator.
        Together(Together),
    }

    /// Combinations of an iterator's items.
    Together { Sum, Product, Tried, }
}

impl Parts {
    /// Returns the names of the fields, in the order of the constructor's arguments.
    #[must_use]
    pub const fn names(self) -> &'static [&'static str] {
        match self {
            Parts::Quaternion => &["w", "i", "j", "k"],
            Parts::Isometry => &["translation", "rotation"],
            Parts::Complex => &["re", "im"],
        }
    }
}
