//! Includes of a file: headers of C's library and of the package.
//!
//! Invariant: a file includes what its own text needs, whatever its other headers include.

use std::collections::BTreeSet;

use bessemer_ir::{ConstId, Scalar, Type};

use crate::c::context::{Context, Uses};
use crate::c::options::Options;
use crate::c::signature::{Returned, Signature};
use crate::c::{helpers_header, internal, sizes, target};

/// Includes of a file.
#[derive(Default)]
pub(super) struct Includes {
    pub(super) system: BTreeSet<&'static str>,
    pub(super) own: BTreeSet<String>,
}

impl Includes {
    pub(super) fn ty(&mut self, context: Context<'_>, ty: &Type) {
        match ty {
            Type::Unit => {}
            Type::Scalar(scalar) => self.scalar(*scalar),
            Type::Matrix { element, .. } => self.scalar(*element),
            Type::Array { element, .. } | Type::Slice(element) => self.ty(context, element),
            Type::Struct(id) => {
                self.own.insert(context.names.structs[id.index()].header.clone());
            }
            Type::Enum(id) => {
                self.own.insert(context.names.enums[id.index()].header.clone());
            }
        }
    }

    fn scalar(&mut self, scalar: Scalar) {
        match scalar {
            Scalar::Bool => self.system.extend(["stdbool.h"]),
            Scalar::Int(_) => self.system.extend(["stdint.h"]),
            Scalar::Float(_) => {}
        }
    }

    /// Adds the headers that the text of functions uses in every source.
    pub(super) fn uses(&mut self, context: Context<'_>, options: &Options, uses: &mut Uses) {
        self.system.extend(["stdbool.h", "stdint.h"]);
        self.own.insert(target::name(options));
        self.system.append(&mut uses.system);
        self.own.append(&mut uses.headers);
        let calls_helpers = !uses.helpers.is_empty();
        self.own.extend(calls_helpers.then(|| helpers_header::name(options)));
        let shared = |id: &&ConstId| context.names.shared_constant(**id).is_some();
        for id in uses.consts.iter().filter(shared) {
            let item = &context.module.consts[id.index()];
            self.own.insert(match (sizes::is_one(item), item.is_name()) {
                (true, _) => sizes::header(options),
                (_, true) => sizes::names_header(options),
                _ => internal::constants(options),
            });
        }
    }

    /// Returns the included headers of C's library.
    pub(super) fn system(&self) -> Vec<String> {
        self.system.iter().map(|it| (*it).to_owned()).collect()
    }

    /// Returns the included headers of the package, except one.
    pub(super) fn own(&self, without: &str) -> Vec<String> {
        self.own.iter().filter(|it| *it != without).cloned().collect()
    }

    pub(super) fn sizes(&mut self, options: &Options, sizes: &[Option<ConstId>]) {
        self.own.extend(sizes.iter().any(Option::is_some).then(|| sizes::header(options)));
    }

    pub(super) fn signature(
        &mut self,
        context: Context<'_>,
        options: &Options,
        signature: &Signature,
    ) {
        for param in &signature.params {
            self.ty(context, &param.ty);
            self.sizes(options, &param.sizes);
        }
        match &signature.returned {
            Returned::Nothing => {}
            Returned::Value(ty) => self.ty(context, ty),
            Returned::Status => {
                self.own.insert(context.names.status.header.clone());
            }
        }
    }
}
