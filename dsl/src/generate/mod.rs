//! Support code that the attributes' expansions call in a generation build; authors never call it.
//!
//! The slots of a builder record rustc's inferred types ([`slot`]). Companions identify the function that a call
//! means, including the DSL's own operations ([`companions`]). [`Builder`] collects the package.

mod builder;
mod companions;
pub mod comparison;
pub mod containers;
pub mod factored;
pub mod generic;
mod handed;
mod implied;
mod items;
pub mod iterator;
pub mod matrices;
pub mod numbers;
pub mod numeric;
mod operators;
mod own;
pub mod slice;
mod slot;
pub mod spatial;
mod wide;
mod wrapping;

pub use alloc::string::String;
pub use alloc::vec::Vec;
pub use bessemer_tree as tree;
pub use builder::{Builder, Callee, Defaults, Named, NoDefault, OwnOperator, Said, Witness, words};
pub use comparison::{Ranked, cmp};
pub use containers::{array, mem};
pub use core::ops::RangeInclusive;
pub use handed::made;
pub use implied::{NotImplied, OwnImplied, note_implied};
pub use inventory;
pub use items::{Build, Generics, Registered, argument, field, folders, number, package, variant};
pub use iterator::{ExtendBuiltin, FromIteratorBuiltin, Items, iter};
pub use numbers::{FromBuiltin, TryFromBuiltin};
pub use operators::{Implements, Operates, Operation, sign};
pub use own::{Asked, NotImplemented, Own};
pub use slot::{
    Called, DslType, EntriesOfBlock, Instance, ScalarType, Seen, Slot, Value, WithoutEntries,
    constant, list,
};

/// Imports of a builder; their names begin with `__`, so they never conflict with an author's.
pub mod prelude {
    pub use super::comparison::traits::*;
    pub use super::containers::traits::*;
    pub use super::factored::traits::*;
    pub use super::factored::{
        CholeskyMethods as _, LuMethods as _, QrMethods as _, UduMethods as _,
    };
    pub use super::generic::ElementaryBuiltins as _;
    pub use super::handed::{__function, __made};
    pub use super::implied::{__asked, NotImplied as _};
    pub use super::iterator::traits::*;
    pub use super::iterator::{__beside, __items};
    pub use super::matrices::traits::*;
    pub use super::matrices::{
        New1 as _, New2 as _, New3 as _, New4 as _, New5 as _, New6 as _, New8 as _, New9 as _,
        New10 as _, New12 as _, New15 as _, New16 as _, New18 as _, New20 as _, New24 as _,
        New25 as _, New30 as _, New36 as _, SwizzleBuiltins as _,
    };
    pub use super::numbers::ByteBuiltins as _;
    pub use super::numbers::traits::*;
    pub use super::operators::{
        __both, __computed, __named, __named_left, __named_right, __operand, __operands,
        __operated, __placed, __settled, OtherOperands as _, OwnOperands as _,
    };
    pub use super::slice::traits::*;
    pub use super::slot::{
        __any, __glance, __look, __next, __pass, __result, __see, __take, __unreached, Through as _,
    };
    pub use super::spatial::traits::*;
    pub use super::wide::traits::*;
    pub use crate::comparison::OrderingCompanions as _;
    pub use crate::complex::ComplexCompanions as _;
    pub use crate::linear::InverseCompanion as _;
    pub use crate::linear::blas::{
        PerpCompanion as _, ProductCompanions as _, QuadraticFormCompanion as _,
        SquareProductCompanions as _, SumOfVectorsCompanions as _,
        TransposedProductCompanions as _, TransposedVectorProductCompanions as _,
        VectorProductCompanion as _,
    };
    pub use crate::linear::each_element::EachElementCompanions as _;
    pub use crate::linear::elementwise::{ElementwiseCompanions as _, LerpCompanion as _};
    pub use crate::linear::factored::triangular::TriangularCompanions as _;
    pub use crate::linear::matrix_edit::{
        EditCompanions as _, IdentityEditCompanion as _, SquareEditCompanions as _,
    };
    pub use crate::linear::matrix_extremes::{
        ExtremeCompanions as _, NumberExtremeCompanions as _, VectorExtremeCompanions as _,
    };
    pub use crate::linear::matrix_powers::PowerCompanions as _;
    pub use crate::linear::matrix_resize::FixedResizeCompanion as _;
    pub use crate::linear::matrix_statistics::{StatisticCompanions as _, SumCompanions as _};
    pub use crate::linear::norms::{
        DirectionCompanions as _, NormCompanions as _, SquareNormCompanions as _,
    };
    pub use crate::linear::parts::{
        CrossMatrixCompanion as _, IthCompanion as _, PartCompanions as _,
        SquarePartCompanions as _, SymmetricPartCompanion as _, TraceCompanion as _,
    };
    pub use crate::linear::spatial::isometry::IsometryCompanions as _;
    pub use crate::linear::spatial::quaternion::QuaternionCompanions as _;
    pub use crate::linear::spatial::unit_quaternion::UnitQuaternionCompanions as _;
    pub use crate::linear::views::ViewCompanions as _;
    pub use crate::list_edit::ListEditCompanions as _;
    pub use crate::math::whole::WholeCompanions as _;
    pub use crate::math::{
        AngleMethods as _, BetweenMethods as _, ByteMethods as _, ComplexMethods as _,
        DivisionMethods as _, ElementaryMethods as _, EulerMethods as _, FloatMethods as _,
        MatrixMethods as _, OrderMethods as _, RankMethods as _, RealMethods as _,
        RotationMethods as _, RoundMethods as _, SearchMethods as _, SignMethods as _,
        SquareMethods as _, TotalMethods as _, TurnMethods as _,
    };
    pub use crate::optional::{
        BoolCompanions as _, CopiedMutCompanions as _, FlattenCompanion as _,
        OptionCompanions as _, OptionDefaultCompanion as _, TransposeCompanion as _,
        UnzipCompanion as _,
    };
    pub use crate::outcome::{
        ResultCompanions as _, ResultDefaultCompanion as _, TransposeBackCompanion as _,
    };
    pub use crate::rotation::{
        PlaneRotationCompanion as _, SpaceRotationCompanions as _, TurnCompanions as _,
    };
    pub use crate::search::SearchCompanions as _;
    pub use crate::slice_edit::{
        ContainsCompanion as _, EndCompanions as _, LetterCompanions as _, SliceEditCompanions as _,
    };
    pub use crate::sort::{OrderCompanion as _, SortCompanions as _};
}

/// Registers an item with the package; the attributes' expansions call it.
#[doc(hidden)]
#[macro_export]
macro_rules! __register {
    ($registered:expr) => {
        $crate::generate::inventory::submit! { $registered }
    };
}
pub use crate::__register as register;
