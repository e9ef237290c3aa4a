//! Tests of the witness technique, in a package of their own: they need the generation build of `bessemer`, and with the
//! dependencies of its other tests cargo would build nalgebra once more for them.
