//! The operations that the library knows without a function of its own: what rustc resolved a method to.
//!
//! A companion's marker names one; the typifier has a `match` for each kind, which the compiler holds to be complete.
//! So an operation that is listed here and handled nowhere does not compile.
//!
//! Must not know: what its authors call it in Rust, which is the companion's business.

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
        /// A method of numbers that is made of such operations.
        Number(NumberMethod),
        /// The bytes of a number as an array, or the number that they make.
        Bytes(ByteOrder),
        /// `real(0.5)`: a number in double precision as a float of the type that is requested.
        Real,
        /// `x.as_f64()`.
        AsF64,
        /// `T::try_from(n)` of integers.
        TryFrom,
        /// A copy of what is viewed, or a wrapper around what it wraps: in the C it is the value itself.
        Owned,
        /// A routine of linear algebra, an operation of the IR.
        Linear(Routine),
        /// A matrix from its parts, its sizes, and its elements in other places.
        Matrix(MatrixMethod),
        /// A routine of linear algebra that is a function of its own.
        Kernel(KernelRoutine),
        /// Methods of rotations and poses that need no function.
        Spatial(SpatialMethod),
        /// A struct of the library from its parts, in the order of the arguments.
        Parts(Parts),
        /// A method of `List`.
        List(ListMethod),
        /// A method of slices, or of what has elements in a row.
        Slice(SliceMethod),
        /// A method of `Option` or `Result` without a closure.
        Option(OptionMethod),
        /// A method that represents a `match` or a loop in the author's own language.
        Desugared(Desugared),
    }

    /// Methods of numbers that are made of operations of the IR.
    NumberMethod {
        Recip, Fract, ToDegrees, ToRadians, Signum, IsSignNegative, IsSignPositive, IsNegative, IsPositive,
        WrappingNeg, WrappingAbs, SwapBytes, IsPowerOfTwo, From,
        CountOnes, CountZeros, LeadingZeros, LeadingOnes, TrailingZeros, TrailingOnes,
        DivEuclid, RemEuclid, WrappingDiv, WrappingRem, AbsDiff,
        WrappingShl, WrappingShr, RotateLeft, RotateRight,
    }

    /// Order of the bytes of a number.
    ByteOrder {
        /// The least significant.
        Little,
        /// The most significant.
        Big,
    }

    /// Matrices from their parts, their sizes, and their elements in other places.
    MatrixMethod {
        /// From its elements, by rows.
        New,
        /// From an array of rows.
        ByRows,
        /// From an array of columns, or such an array from a matrix.
        FromArray,
        Zeros, Identity, FromElement,
        /// The unit vector along an axis.
        Axis(u32),
        Rows, Cols,
        /// Number of elements.
        Elements,
        /// The vector of these components; as many as the second says.
        Swizzle([u8; 3], u8),
        /// A part that is written where it is.
        Part(MatrixPart),
    }

    /// Index at which a part of a matrix begins.
    MatrixPart {
        /// Index of the first row: the part has all columns.
        Rows,
        /// Index of the first column.
        Columns,
        /// Both.
        Block,
    }

    /// Methods of rotations and poses that need no function.
    SpatialMethod {
        /// A method of nalgebra's that asks the platform for its sine, cosine or root: it is refused.
        PlatformAngles,
        QuaternionIdentity, QuaternionCoords,
        /// Conversion to another struct with equal parts, or to the struct itself.
        SameParts,
        /// A matrix by another, transposed.
        TimesTransposed,
    }

    /// A struct of the library that a constructor makes of its parts.
    Parts { Quaternion, Isometry, Complex, }

    /// Methods of `List`.
    ListMethod { New, Push, Pop, Clear, Truncate, Resize, Len, IsEmpty, Capacity, }

    /// Methods of slices.
    SliceMethod {
        /// All elements of what has some in a row.
        Whole,
        Len, IsEmpty, First, FirstMut, Last, LastMut, Get, GetMut,
        /// `get(from..to)`.
        GetPart,
        /// `get(from..)`.
        GetFrom,
        SplitAt, SplitAtChecked, SplitFirst, SplitLast,
        /// The first so many elements as an array, and the others.
        SplitFirstChunk(u32),
        /// All but the last so many elements, and these as an array.
        SplitLastChunk(u32),
        CopyFrom, Reverse, ToArray, FirstChunk,
    }

    /// Methods of `Option` and `Result` without a closure.
    OptionMethod {
        Unwrap, UnwrapErr, UnwrapOr, Copied, Or, And, Take, Replace,
        OkOr, Ok, Err, AsMut, Insert, GetOrInsert,
        /// `get_or_insert_with`: its closure is computed in its place.
        GetOrInsertWith,
    }

    /// Methods that represent a `match` or a loop in the author's own language.
    Desugared {
        ArrayMap, AsRef,
        /// `core::array::from_fn`.
        FromFn,
        /// The iterator itself.
        ByRef,
        /// The items of an iterator together, by an operator.
        Together(Together),
    }

    /// Combination of numbers or matrices.
    Together { Sum, Product, Tried, }
}

impl Parts {
    /// The fields, in the order of the constructor's arguments.
    #[must_use]
    pub const fn names(self) -> &'static [&'static str] {
        match self {
            Parts::Quaternion => &["w", "i", "j", "k"],
            Parts::Isometry => &["translation", "rotation"],
            Parts::Complex => &["re", "im"],
        }
    }
}
