//! Memory layout of values in the interpreter: sizes and offsets in words.
//!
//! Invariants: a value has the order of [`Module::leaves`]. A local of mode `Value` is in its frame; a reference is
//! one word, the address of its referent.

use bessemer_ir::{Function, Mode, Module, Type};

/// Sizes and offsets of a whole module, computed once.
pub(super) struct Layout {
    structs: Vec<Extent>,
    functions: Vec<Extent>,
}

/// Layout of a struct's fields, or of a frame's locals.
pub(super) struct Extent {
    /// Offset of each part.
    pub offsets: Vec<usize>,
    /// Total size in words.
    pub size: usize,
}

impl Extent {
    fn of(sizes: impl Iterator<Item = usize>) -> Extent {
        let mut extent = Extent { offsets: Vec::new(), size: 0 };
        for size in sizes {
            extent.offsets.push(extent.size);
            extent.size += size;
        }
        extent
    }
}

impl Layout {
    pub fn new(module: &Module) -> Layout {
        let mut layout = Layout { structs: Vec::new(), functions: Vec::new() };
        for definition in &module.structs {
            let extent = Extent::of(definition.fields.iter().map(|field| layout.size(&field.ty)));
            layout.structs.push(extent);
        }
        for function in &module.functions {
            let extent = layout.frame(function);
            layout.functions.push(extent);
        }
        layout
    }

    /// Returns the words of a value of type `ty`.
    pub fn size(&self, ty: &Type) -> usize {
        match ty {
            Type::Unit | Type::Slice(_) => 0,
            Type::Scalar(_) | Type::Enum(_) => 1,
            Type::Array { element, len } => self.size(element) * *len as usize,
            Type::Matrix { rows, cols, .. } => *rows as usize * *cols as usize,
            Type::Struct(id) => self.structs[id.index()].size,
        }
    }

    /// Returns the layout of a struct.
    pub fn fields(&self, id: bessemer_ir::StructId) -> &Extent {
        &self.structs[id.index()]
    }

    /// Returns the layout of a function's locals.
    pub fn locals(&self, id: bessemer_ir::FunctionId) -> &Extent {
        &self.functions[id.index()]
    }

    fn frame(&self, function: &Function) -> Extent {
        Extent::of(function.locals.iter().map(|local| match local.mode {
            Mode::Value => self.size(&local.ty),
            Mode::Ref | Mode::RefMut => 1,
        }))
    }
}
