//! Memory layout of values in the interpreter: sizes and offsets in words.
//!
//! Invariants: a value lies in the order of [`Module::leaves`]; a local of mode `Value` lies in its
//! frame, a reference is one word, the address of what it refers to.

use bessemer_ir::{Function, Mode, Module, Type};

/// Sizes and offsets of a whole module, computed once.
pub(super) struct Layout {
    structs: Vec<Extent>,
    functions: Vec<Extent>,
}

/// The parts of a struct or a frame.
pub(super) struct Extent {
    /// Offset of each part.
    pub offsets: Vec<usize>,
    /// Words in all.
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

    /// The words of a value of type `ty`.
    pub fn size(&self, ty: &Type) -> usize {
        match ty {
            Type::Unit | Type::Slice(_) => 0,
            Type::Scalar(_) | Type::Enum(_) => 1,
            Type::Array { element, len } => self.size(element) * *len as usize,
            Type::Matrix { rows, cols, .. } => *rows as usize * *cols as usize,
            Type::Struct(id) => self.structs[id.index()].size,
        }
    }

    /// The fields of a struct.
    pub fn fields(&self, id: bessemer_ir::StructId) -> &Extent {
        &self.structs[id.index()]
    }

    /// The locals of a function.
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
