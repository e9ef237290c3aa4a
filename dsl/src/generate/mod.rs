//! The expansions of the attributes call this module in a generation build; authors never do.
//!
//! A builder's slots tell what rustc decided ([`slot`]); companions tell which function a call means,
//! the DSL's own operations among them ([`builtin`]); [`Builder`] collects the package.

mod adapters;
pub mod ascii;
mod builder;
pub mod builtin;
pub mod checked;
pub mod comparison;
pub mod complex;
mod converted;
pub mod each_element;
pub mod elementary;
pub mod factored;
pub mod generic;
mod handed;
mod items;
pub mod iterator;
pub mod linear;
pub mod list;
pub mod matrices;
pub mod non_zero;
pub mod numbers;
mod operators;
pub mod option;
pub mod range;
pub mod resized;
pub mod slice;
mod slot;
pub mod spatial;
pub mod swizzles;
pub mod views;
pub mod whole;

pub use alloc::string::String;
pub use alloc::vec::Vec;
pub use bessemer_ir::tree;
pub use builder::{Builder, Callee, Defaults, Named, NoDefault, Said, Witness, words};
pub use comparison::{Ranked, cmp};
pub use core::ops::RangeInclusive;
pub use handed::made;
pub use inventory;
pub use items::{
    Generics, Registered, argument, data, field, folders, function, number, package, variant,
};
pub use iterator::{ExtendBuiltin, FromIteratorBuiltin, Items};
pub use numbers::{FromBuiltin, TryFromBuiltin};
pub use operators::{Implements, Operates, Operation, OwnOperator, owned, sign};
pub use option::mem;
pub use slot::{
    Called, DslType, Instance, ScalarType, Seen, Slot, Value, WithoutEntries, callees, constant,
    list, types,
};

/// The imports of a builder; their names begin with `__` so that they never meet an author's.
pub mod prelude {
    pub use super::adapters::{__items, Adapters as _, CopiedItems as _};
    pub use super::ascii::{ByteBuiltins as _, CharBuiltins as _};
    pub use super::builtin::{AxisBuiltins as _, CrossBuiltin as _, IdentityBuiltin as _};
    pub use super::builtin::{
        FloatBuiltins as _, MatrixBuiltins as _, OrderBuiltins as _, RealBuiltins as _,
    };
    pub use super::builtin::{
        New1 as _, New2 as _, New3 as _, New4 as _, New5 as _, New6 as _, New8 as _, New9 as _,
        New12 as _, New16 as _,
    };
    pub use super::checked::{
        CheckedAbsBuiltin as _, CheckedBuiltins as _, CheckedSignedBuiltin as _,
    };
    pub use super::comparison::{
        CompareBuiltins as _, OrderingBuiltins as _, PartialCompareBuiltins as _,
        RankedBuiltins as _, RankedOrderBuiltins as _, ReferredOrderBuiltins as _,
        ThenBuiltin as _, TotalCompareBuiltins as _,
    };
    pub use super::complex::{ComplexBuiltins as _, ComplexMethods as _};
    pub use super::each_element::EachElement as _;
    pub use super::elementary::ElementaryBuiltins as _;
    pub use super::factored::{
        CholeskyMethods as _, LuBuiltins as _, LuMethods as _, QrBuiltins as _, QrMethods as _,
        SquareQrMethods as _, SymmetricBuiltins as _, TriangularBuiltins as _, UduMethods as _,
    };
    pub use super::handed::{__function, __made};
    pub use super::iterator::{
        ByHand as _, Ends as _, ExtendBuiltin as _, FromIteratorBuiltin as _,
    };
    pub use super::linear::SquareBuiltins as _;
    pub use super::list::{ListBuiltins as _, ListEdits as _, ListExtends as _};
    pub use super::matrices::{
        CastBuiltin as _, CrossMatrixBuiltin as _, ElementBuiltins as _, NumberBuiltins as _,
        PartBuiltins as _, PerpBuiltin as _, ScalarBuiltins as _, SquareElementBuiltins as _,
        SquareNumberBuiltins as _, SquarePartBuiltins as _, VectorPartBuiltins as _,
    };
    pub use super::non_zero::NonZeroBuiltins as _;
    pub use super::numbers::{
        BytesBuiltins as _, DivisionBuiltins as _, FloatKindBuiltins as _, FromBuiltin as _,
        IntegerBuiltins as _, IntoBuiltin as _, SignBuiltins as _, SignedBuiltins as _,
        TryFromBuiltin as _, TryIntoBuiltin as _, UnsignedBuiltins as _,
    };
    pub use super::operators::{
        __both, __computed, __named, __named_left, __named_right, __operand, __operands,
        __operated, __placed, __settled, OtherOperands as _, OwnOperands as _,
    };
    pub use super::option::{
        ArrayBuiltins as _, BoolBuiltins as _, CopiedBuiltin as _, CopiedMutBuiltin as _,
        FlattenBuiltin as _, LentOnBuiltin as _, OptionBuiltins as _, ReadOnBuiltin as _,
        ResultBuiltins as _, TransposeBackBuiltin as _, TransposeBuiltin as _, UnzipBuiltin as _,
    };
    pub use super::range::{ClosedBuiltins as _, ClosedContents as _, Contents as _};
    pub use super::resized::{PushBuiltin as _, ResizedBuiltins as _};
    pub use super::slice::{
        SliceArrays as _, SliceBuiltins as _, SliceEdits as _, SliceEnds as _, SliceEquals as _,
        SliceOrder as _, SliceSearch as _, SliceSearches as _, SliceSorts as _, TotalOrder as _,
        VectorSliceBuiltins as _,
    };
    pub use super::slot::{
        __any, __glance, __look, __next, __pass, __result, __see, __take, __unreached, Through as _,
    };
    pub use super::spatial::{
        DirectionMethods as _, IsometryBuiltins as _, IsometryMethods as _, NewPlaneRotation as _,
        NewPoint2 as _, NewPoint3 as _, NewSpaceRotation as _, NewTranslation2 as _,
        NewTranslation3 as _, PlaneRotationMethods as _, PointBuiltins as _,
        QuaternionBuiltins as _, QuaternionMethods as _, RotationBuiltins as _,
        RotationMethods as _, SpaceRotationMethods as _, TranslationBuiltins as _,
        TranslationMethods as _, UnitAxisBuiltins as _, UnitBuiltins as _,
        UnitQuaternionBuiltins as _, UnitQuaternionMethods as _,
    };
    pub use super::swizzles::SwizzleBuiltins as _;
    pub use super::views::{
        CopyBuiltin as _, LineBuiltins as _, OwnedBuiltins as _, ViewBuiltins as _,
        WrittenViews as _,
    };
    pub use super::whole::WholeBuiltins as _;
    pub use crate::math::{
        AngleMethods as _, BetweenMethods as _, ByteMethods as _, ComplexMethods as _,
        DivisionMethods as _, ElementaryMethods as _, EulerMethods as _, FloatMethods as _,
        MatrixMethods as _, OrderMethods as _, RankMethods as _, RotationMethods as _,
        RoundMethods as _, SearchMethods as _, SignMethods as _, SquareMethods as _,
        TotalMethods as _, TurnMethods as _,
    };
}

/// Registers an item with the package; expanded by the attributes.
#[doc(hidden)]
#[macro_export]
macro_rules! __register {
    ($registered:expr) => {
        $crate::generate::inventory::submit! { $registered }
    };
}
pub use crate::__register as register;
