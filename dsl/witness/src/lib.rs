//! Tests of the witness technique. They are a package of their own because they need the generation build of
//! `bessemer`; otherwise cargo would build nalgebra twice.
