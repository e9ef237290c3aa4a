//! Random modules out of random bytes: every kind of node, well-typed or not, with hostile names,
//! spans and words.

use bessemer_ir::tree::Site;
use bessemer_ir::*;

/// A module that these bytes represent; when they run out, the simplest of everything.
pub fn module(bytes: &[u8]) -> Module {
    let mut source = Source { bytes, depth: 0, locals: 0 };
    let files = source.some(2, Source::text);
    let about = files.first().map(|file| (file.clone(), source.some(2, Source::text)));
    let about = about.into_iter().filter(|(_, lines)| !lines.is_empty()).collect();
    let enums = source.some(3, Source::enumeration);
    let structs = source.some(4, Source::structure);
    let consts = source.some(3, Source::constant);
    let functions = source.some(4, Source::function);
    Module {
        name: source.name(),
        files,
        about,
        structs,
        enums,
        consts,
        functions,
        written: source.some(3, Source::written).into_iter().collect(),
    }
}

struct Source<'b> {
    bytes: &'b [u8],
    depth: u32,
    locals: u32,
}

impl Source<'_> {
    fn byte(&mut self) -> u8 {
        let Some((first, rest)) = self.bytes.split_first() else { return 0 };
        self.bytes = rest;
        *first
    }

    fn below(&mut self, limit: u32) -> u32 {
        u32::from(self.byte()) % limit
    }

    fn chance(&mut self, one_in: u32) -> bool {
        self.below(one_in) == one_in - 1
    }

    fn some<T>(&mut self, most: u32, make: impl Fn(&mut Self) -> T) -> Vec<T> {
        let count = self.below(most + 1);
        (0..count).map(|_| make(self)).collect()
    }

    fn pick<T: Copy>(&mut self, from: &[T]) -> T {
        from[self.below(from.len() as u32) as usize]
    }

    fn name(&mut self) -> String {
        let names = [
            "a",
            "b",
            "x",
            "step",
            "Pid",
            "min",
            "_",
            "f64",
            "let",
            "",
            "two words",
            "é",
            "1st",
            "q\"\n\\",
            "struct",
            "rev",
            "a",
            "x1",
            "Mode",
            "as",
        ];
        self.pick(&names).to_string()
    }

    fn text(&mut self) -> String {
        let texts = [
            "",
            " ",
            "Plain.",
            "\"quoted\"",
            "two\nlines",
            "\ttab ",
            "é — ∑",
            "// x",
            "\r",
            "m::n",
            "a b ",
        ];
        self.pick(&texts).to_string()
    }

    fn span(&mut self) -> Span {
        if self.chance(2) {
            return Span::default();
        }
        Span { file: self.below(2), line: self.below(3), column: self.below(3) }
    }

    fn word(&mut self) -> u64 {
        let words = [
            0,
            1,
            2,
            u64::MAX,
            1 << 63,
            0x3ff0_0000_0000_0000,
            0x7ff0_0000_0000_0000,
            0x7ff8_0000_0000_0001,
            0xfff8_0000_0000_0000,
            0x7fc0_0000,
            0x3f80_0000,
            0xffff_ff80,
            0x3fb9_9999_9999_999a,
            255,
            300,
        ];
        self.pick(&words)
    }

    fn written(&mut self) -> ((Span, u64), Written) {
        let written = match self.below(3) {
            0 => Written::Hexadecimal,
            1 => Written::Constant(ConstId(self.handle())),
            _ => Written::Variant(EnumId(self.handle()), self.handle()),
        };
        ((self.span(), self.word()), written)
    }

    fn handle(&mut self) -> u32 {
        if self.chance(20) { 4_000_000_000 } else { self.below(5) }
    }

    fn scalar(&mut self) -> Scalar {
        match self.below(5) {
            0 => Scalar::Float(Float::F64),
            1 => Scalar::Bool,
            2 => Scalar::Float(Float::F32),
            _ => Scalar::Int(self.pick(&Int::ALL)),
        }
    }

    fn ty(&mut self) -> Type {
        match self.below(9) {
            0..4 => Type::Scalar(self.scalar()),
            4 => Type::Matrix { element: self.scalar(), rows: self.below(4), cols: self.below(3) },
            5 if self.bytes.len() > 4 => {
                Type::Array { element: Box::new(self.ty()), len: self.below(4) }
            }
            6 => Type::Enum(EnumId(self.handle())),
            7 => Type::Struct(StructId(self.handle())),
            _ => Type::Unit,
        }
    }

    fn enumeration(&mut self) -> Enum {
        Enum {
            name: self.name(),
            module: self.text(),
            docs: self.some(2, Source::text),
            variants: self.some(3, |source| Variant {
                name: source.name(),
                docs: source.some(1, Source::text),
                value: source.word() as i32,
                given: source.given(),
            }),
            given: self.given(),
            span: self.span(),
        }
    }

    fn given(&mut self) -> Given {
        if !self.chance(6) {
            return Given::default();
        }
        Given {
            name: self.chance(2).then(|| self.text()),
            unit: self.chance(2).then(|| self.text()),
            range: Range::new(f64::from(self.below(9)) / 4.0 - 2.0, 1e300)
                .map(|it| it.with(attributes::Beyond::Clamped)),
            axes: self.some(2, Source::text),
            section: self.chance(2).then(|| self.text()),
            public: self.chance(2),
            hexadecimal: self.chance(2),
            expression: self.chance(2).then(|| self.text()),
            sizes: self.some(2, Source::text),
            fallback: self.chance(2),
            site: Site(self.below(99), self.below(99)),
        }
    }

    fn structure(&mut self) -> Struct {
        Struct {
            name: self.name(),
            module: self.text(),
            docs: self.some(2, Source::text),
            fields: self.some(3, |source| Field {
                name: source.name(),
                docs: source.some(1, Source::text),
                ty: source.ty(),
                given: source.given(),
            }),
            form: match self.below(5) {
                0 => Form::Record,
                1 => Form::Sequence,
                2 => Form::Lent,
                3 => Form::Shared,
                _ => {
                    Form::Choice(self.some(3, |source| {
                        if source.chance(2) { None } else { Some(source.below(3)) }
                    }))
                }
            },
            initial: if self.chance(2) { Some(self.some(6, Source::word)) } else { None },
            defaults: if self.chance(3) { Some(self.some(6, Source::word)) } else { None },
            given: self.given(),
            span: self.span(),
        }
    }

    fn constant(&mut self) -> Const {
        let mut words = self.some(6, Source::word);
        if self.chance(4) {
            words.extend([7; 9]);
        }
        Const {
            name: self.name(),
            module: self.text(),
            ty: self.ty(),
            words,
            docs: self.some(2, Source::text),
            given: self.given(),
            span: self.span(),
        }
    }

    fn function(&mut self) -> Function {
        let locals = self.some(7, |source| Local {
            name: source.name(),
            ty: source.ty(),
            mode: source.pick(&[Mode::Value, Mode::Ref, Mode::RefMut]),
            span: source.span(),
        });
        self.locals = locals.len() as u32;
        Function {
            name: self.name(),
            module: self.text(),
            owner: match self.below(3) {
                0 => None,
                1 => Some(Owner::Struct(StructId(self.handle()))),
                _ => Some(Owner::Enum(EnumId(self.handle()))),
            },
            role: self.pick(&[
                Role::Public,
                Role::Private,
                Role::Inline { public: true },
                Role::Inline { public: false },
                Role::Entry { infallible: true },
                Role::Entry { infallible: false },
            ]),
            attributes: Attributes {
                name: self.chance(20).then(|| self.text()),
                section: self.chance(20).then(|| self.text()),
                inlining: self.pick(&[Inlining::Free, Inlining::Never, Inlining::Always]),
                atomic: self.chance(20),
                single: self.chance(20),
                external: self.chance(20).then(|| self.text()),
                parameters: self.some(1, |source| (source.text(), source.given())),
                result: self.given(),
            },
            docs: self.some(2, Source::text),
            params: self.below(self.locals + 1),
            locals,
            result: self.ty(),
            result_name: self.name(),
            body: self.block(),
            kernel: self.chance(20).then(|| Kernel {
                routine: self.pick(&KernelRoutine::ALL),
                element: self.pick(&[Float::F32, Float::F64]),
                dims: self.some(4, |source| source.below(300)),
            }),
            span: self.span(),
        }
    }

    fn block(&mut self) -> Block {
        self.depth += 1;
        let most = if self.depth > 4 { 0 } else { 4 };
        let block = Block(self.some(most, Source::stmt));
        self.depth -= 1;
        block
    }

    fn local(&mut self) -> LocalId {
        LocalId(if self.locals == 0 || self.chance(30) {
            self.handle()
        } else {
            self.below(self.locals)
        })
    }

    fn stmt(&mut self) -> Stmt {
        let kind = match self.below(11) {
            0 | 1 => StmtKind::Let {
                local: self.local(),
                value: if self.chance(3) { None } else { Some(self.expr()) },
            },
            2 => StmtKind::Assign { place: self.place(), value: self.expr() },
            3 => StmtKind::Expr(self.expr()),
            4 => {
                StmtKind::If { condition: self.expr(), then: self.block(), otherwise: self.block() }
            }
            5 => StmtKind::Match {
                scrutinee: self.expr(),
                arms: self.some(3, |source| Arm {
                    values: source.some(3, |source| {
                        let value = i128::from(source.below(4));
                        source.pick(&[value, -1, i128::MIN, i128::MAX])
                    }),
                    body: source.block(),
                }),
                otherwise: if self.chance(2) { Some(self.block()) } else { None },
            },
            6 => StmtKind::For {
                variable: self.local(),
                from: self.expr(),
                to: self.expr(),
                inclusive: self.chance(2),
                reversed: self.chance(2),
                unroll: self.chance(4).then(|| self.below(9)),
                ended: self.chance(4),
                body: self.block(),
            },
            7 => StmtKind::Check {
                condition: self.expr(),
                fault: self.pick(&[
                    Fault::Overflow,
                    Fault::DivisionByZero,
                    Fault::Shift,
                    Fault::Index,
                    Fault::Clamp,
                    Fault::Variant,
                    Fault::Assertion,
                    Fault::Bound,
                ]),
            },
            8 => StmtKind::Return(if self.chance(3) { None } else { Some(self.expr()) }),
            9 => StmtKind::Break,
            _ => StmtKind::Continue,
        };
        Stmt { kind, span: self.span(), comments: self.some(1, Source::text) }
    }

    fn place(&mut self) -> Place {
        Place {
            root: self.local(),
            steps: self.some(2, |source| match source.below(3) {
                0 => Step::Field(source.below(4)),
                1 => Step::Index(source.expr()),
                _ => Step::Element(source.expr(), source.expr()),
            }),
            ty: self.ty(),
            span: self.span(),
        }
    }

    fn boxed(&mut self) -> Box<Expr> {
        Box::new(self.expr())
    }

    fn expr(&mut self) -> Expr {
        self.depth += 1;
        let kind = if self.depth > 7 { ExprKind::Literal(self.word()) } else { self.kind() };
        self.depth -= 1;
        let mut expr = Expr { kind, ty: self.ty(), span: self.span() };
        // More often than not, as a front end makes them.
        if let ExprKind::Load(place) = &mut expr.kind
            && !self.chance(4)
        {
            (place.ty, place.span) = (expr.ty.clone(), expr.span);
        }
        expr
    }

    fn kind(&mut self) -> ExprKind {
        use {BinaryOp as B, CompareOp as C, Intrinsic as I, Routine as R};
        let binary =
            [B::Add, B::Sub, B::Mul, B::Div, B::Rem, B::And, B::Or, B::Xor, B::Shl, B::Shr];
        let compare = [C::Eq, C::Ne, C::Lt, C::Le, C::Gt, C::Ge];
        let intrinsic = [
            I::Sqrt,
            I::Abs,
            I::Min,
            I::Max,
            I::Clamp,
            I::Floor,
            I::ToBits,
            I::RawBits,
            I::FromBits,
            I::Copysign,
            I::WrappingAdd,
            I::WrappingSub,
            I::WrappingMul,
            I::WrappingDiv,
            I::WrappingRem,
            I::SaturatingAdd,
            I::SaturatingSub,
            I::SaturatingMul,
            I::DivEuclid,
            I::RemEuclid,
            I::UnsignedAbs,
            I::AbsDiff,
            I::CountOnes,
            I::LeadingZeros,
            I::TrailingZeros,
            I::SwapBytes,
            I::Ceil,
            I::Trunc,
            I::Round,
            I::Signum,
            I::IsNan,
            I::IsFinite,
            I::IsInfinite,
            I::Variant,
        ];
        let routine = [
            R::Add,
            R::Sub,
            R::Neg,
            R::Scale,
            R::Unscale,
            R::ComponentMul,
            R::ComponentDiv,
            R::Inf,
            R::Sup,
            R::Abs,
            R::Product,
            R::TrMul,
            R::Transpose,
            R::Dot,
            R::Cross,
            R::Norm,
            R::NormSquared,
            R::Amax,
            R::Amin,
        ];
        match self.below(18) {
            0 | 1 => ExprKind::Literal(self.word()),
            2 => ExprKind::Const(ConstId(self.handle())),
            3..6 => ExprKind::Load(self.place()),
            6 => ExprKind::Unary(self.pick(&[UnaryOp::Neg, UnaryOp::Not]), self.boxed()),
            7 | 8 => ExprKind::Binary(self.pick(&binary), self.boxed(), self.boxed()),
            9 => ExprKind::Compare(self.pick(&compare), self.boxed(), self.boxed()),
            10 => {
                ExprKind::Logic(self.pick(&[LogicOp::And, LogicOp::Or]), self.boxed(), self.boxed())
            }
            11 => ExprKind::Cast(self.boxed()),
            12 => ExprKind::Intrinsic(self.pick(&intrinsic), self.some(3, Source::expr)),
            13 => ExprKind::Call(
                FunctionId(self.handle()),
                self.some(3, |source| match source.below(3) {
                    0 => Argument::Value(source.expr()),
                    1 => Argument::Ref(source.expr()),
                    _ => Argument::RefMut(source.place()),
                }),
            ),
            14 => ExprKind::Struct(self.some(3, Source::expr)),
            15 => ExprKind::Array(self.some(3, Source::expr)),
            16 => match self.below(2) {
                0 => ExprKind::Splat(self.boxed()),
                _ => ExprKind::Matrix(self.some(4, Source::expr)),
            },
            _ => ExprKind::Routine(self.pick(&routine), self.some(2, Source::expr)),
        }
    }
}
