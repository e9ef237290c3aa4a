//! Emitted files.

/// An emitted file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CFile {
    /// Name, such as `height.h`.
    pub name: String,
    /// Text of the file.
    pub text: String,
    /// Source positions of its lines, in order.
    pub map: Vec<MapLine>,
}

/// A line of C and the line of Rust that it comes from.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct MapLine {
    /// Line of the C file, from 1.
    pub c_line: u32,
    /// The Rust file, relative to the workspace.
    pub rust_file: String,
    /// Line of the Rust file, from 1.
    pub rust_line: u32,
    /// The Rust path of the function, empty for a type.
    pub function: String,
}
