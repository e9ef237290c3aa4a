//! The C tree: the lowering builds it, and the printer prints it.
//!
//! Expressions have a precedence, so the printer alone places parentheses. The lowering has inserted every conversion
//! as an [`Expr::Cast`]. Nothing here depends on the IR, except that statements have a Rust line.

/// An expression.
#[derive(Clone, Debug, PartialEq)]
pub enum Expr {
    /// An identifier, a literal without sign, or a macro.
    Name(String),
    /// A unary operation: `-x`, `!x`, `~x`, `*x`, `&x`.
    Unary(&'static str, Box<Expr>),
    /// A binary operation, `a op b`.
    Binary(&'static str, Box<Expr>, Box<Expr>),
    /// A conditional, `a ? b : c`.
    Conditional(Box<Expr>, Box<Expr>, Box<Expr>),
    /// A cast, `(type)x`.
    Cast(String, Box<Expr>),
    /// A call, `name(arguments)`.
    Call(String, Vec<Expr>),
    /// An indexed array, `array[index]`.
    Index(Box<Expr>, Box<Expr>),
    /// A field of a value, `value.field`.
    Member(Box<Expr>, String),
    /// A field behind a pointer, `pointer->field`.
    Arrow(Box<Expr>, String),
    /// An increment or decrement, `x++`, `x--`.
    Postfix(Box<Expr>, &'static str),
}

impl Expr {
    /// Returns an identifier or a literal.
    pub fn name(text: impl Into<String>) -> Expr {
        Expr::Name(text.into())
    }

    /// Returns `a op b`.
    pub fn binary(op: &'static str, left: Expr, right: Expr) -> Expr {
        Expr::Binary(op, Box::new(left), Box::new(right))
    }

    /// Returns a unary operation.
    pub fn unary(op: &'static str, operand: Expr) -> Expr {
        Expr::Unary(op, Box::new(operand))
    }

    /// Returns `(ty)operand`. A second equal cast is omitted, and a literal gets a suffix instead.
    pub fn cast(ty: &str, operand: Expr) -> Expr {
        match operand {
            Expr::Cast(inner, value) if inner == ty => Expr::Cast(inner, value),
            Expr::Name(text) if ty == "uint32_t" && is_counted(&text) => {
                Expr::Name(format!("{}U", text.trim_end_matches('U')))
            }
            other => Expr::Cast(ty.to_owned(), Box::new(other)),
        }
    }

    /// Returns a call.
    pub fn call(function: impl Into<String>, arguments: Vec<Expr>) -> Expr {
        Expr::Call(function.into(), arguments)
    }

    /// Returns the last name in a place: of a field, or of the variable.
    pub fn last_name(&self) -> Option<&str> {
        match self {
            Expr::Name(name) | Expr::Member(_, name) | Expr::Arrow(_, name) => Some(name),
            Expr::Index(place, _) | Expr::Unary("*", place) => place.last_name(),
            _ => None,
        }
    }

    /// Returns `self[index]`.
    pub fn at(self, index: Expr) -> Expr {
        Expr::Index(Box::new(self), Box::new(index))
    }

    /// Returns a field of a struct, also through a pointer.
    pub fn field(self, name: &str) -> Expr {
        match self {
            Expr::Unary("*", pointer) => Expr::Arrow(pointer, name.to_owned()),
            value => Expr::Member(Box::new(value), name.to_owned()),
        }
    }

    /// Returns the address of a value that is not an array (an array is its own address).
    pub fn address(self) -> Expr {
        match self {
            Expr::Unary("*", pointer) => *pointer,
            value => Expr::unary("&", value),
        }
    }

    /// Returns its direct operands.
    pub fn operands(&self) -> Vec<&Expr> {
        match self {
            Expr::Name(_) => Vec::new(),
            Expr::Unary(_, of)
            | Expr::Cast(_, of)
            | Expr::Member(of, _)
            | Expr::Arrow(of, _)
            | Expr::Postfix(of, _) => vec![of],
            Expr::Binary(_, left, right) | Expr::Index(left, right) => vec![left, right],
            Expr::Conditional(condition, left, right) => vec![condition, left, right],
            Expr::Call(_, arguments) => arguments.iter().collect(),
        }
    }

    /// Counts the mentions of a variable.
    pub fn mentions(&self, name: &str) -> usize {
        match self {
            Expr::Name(it) => usize::from(it == name),
            other => other.operands().into_iter().map(|operand| operand.mentions(name)).sum(),
        }
    }

    /// Returns its direct operands, for changes.
    fn operands_mut(&mut self) -> Vec<&mut Expr> {
        match self {
            Expr::Name(_) => Vec::new(),
            Expr::Unary(_, of)
            | Expr::Cast(_, of)
            | Expr::Member(of, _)
            | Expr::Arrow(of, _)
            | Expr::Postfix(of, _) => vec![of],
            Expr::Binary(_, left, right) | Expr::Index(left, right) => vec![left, right],
            Expr::Conditional(condition, left, right) => vec![condition, left, right],
            Expr::Call(_, arguments) => arguments.iter_mut().collect(),
        }
    }

    /// Replaces each mention of a variable by a value.
    pub fn replace(&mut self, name: &str, value: &Expr) {
        match self {
            Expr::Name(it) if it == name => *self = value.clone(),
            other => other.operands_mut().into_iter().for_each(|it| it.replace(name, value)),
        }
    }

    /// Replaces each element of an array by a variable of its name.
    pub fn replace_elements(&mut self, array: &str) {
        match self {
            Expr::Index(of, _) if **of == Expr::name(array) => *self = Expr::name(array),
            other => other.operands_mut().into_iter().for_each(|it| it.replace_elements(array)),
        }
    }

    /// Returns the precedence; a greater one binds tighter.
    pub fn precedence(&self) -> u8 {
        match self {
            Expr::Name(_)
            | Expr::Call(..)
            | Expr::Index(..)
            | Expr::Member(..)
            | Expr::Arrow(..)
            | Expr::Postfix(..) => 15,
            Expr::Unary(..) | Expr::Cast(..) => 14,
            Expr::Binary(op, ..) => operator_precedence(op),
            Expr::Conditional(..) => 2,
        }
    }
}

/// Returns the precedence of a binary operator.
pub fn operator_precedence(op: &str) -> u8 {
    match op {
        "*" | "/" | "%" => 13,
        "+" | "-" => 12,
        "<<" | ">>" => 11,
        "<" | "<=" | ">" | ">=" => 10,
        "==" | "!=" => 9,
        "&" => 8,
        "^" => 7,
        "|" => 6,
        "&&" => 5,
        "||" => 4,
        _ => unreachable!("no binary operator of C: {op}"),
    }
}

/// An initialiser.
#[derive(Clone, Debug, PartialEq)]
pub enum Init {
    /// One value.
    Value(Expr),
    /// A list, `{…}`.
    List {
        /// Items, each with its designator if it is a field.
        items: Vec<(Option<String>, Init)>,
        /// Layout of the list.
        lines: Lines,
    },
}

impl Init {
    /// Returns the values in the initialiser.
    pub fn expressions(&self) -> Vec<&Expr> {
        match self {
            Init::Value(value) => vec![value],
            Init::List { items, .. } => {
                items.iter().flat_map(|(_, item)| item.expressions()).collect()
            }
        }
    }
}

/// Layout of a list.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Lines {
    /// On one line, or with as many items per line as fit.
    Fill,
    /// On one line, or with one item per line.
    Each,
    /// With this number of items per line, as in a matrix.
    Groups(usize),
}

/// A declarator, `type name[dimensions]`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Declarator {
    /// Type, such as `const double` or `pid_t *`.
    pub ty: String,
    /// The name.
    pub name: String,
    /// Dimensions, such as `[3][4]`; may be empty.
    pub dimensions: String,
}

impl Declarator {
    /// Returns the declarator as C text.
    pub fn text(&self) -> String {
        let gap = if self.ty.ends_with('*') { "" } else { " " };
        format!("{}{gap}{}{}", self.ty, self.name, self.dimensions)
    }
}

/// A line of the author's source.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Origin {
    /// Index into the module's files.
    pub file: u32,
    /// Line, from 1.
    pub line: u32,
}

/// A statement.
#[derive(Clone, Debug, PartialEq)]
pub struct Stmt {
    /// Kind of the statement.
    pub kind: StmtKind,
    /// Source position.
    pub origin: Option<Origin>,
}

/// Kinds of statements.
#[derive(Clone, Debug, PartialEq)]
pub enum StmtKind {
    /// A comment, by lines.
    Comment(Vec<String>),
    /// Clauses of a contract, about the loop that follows.
    Annotation(Vec<String>),
    /// A declaration.
    Declare(Declarator, Option<Init>),
    /// An expression for its effect.
    Expr(Expr),
    /// `place op value;`, where `op` is `=`, `+=` or the like.
    Assign(Expr, &'static str, Expr),
    /// `place = (type){…};`, a compound literal.
    Build(Expr, String, Init),
    /// `if`.
    If {
        /// The condition.
        condition: Expr,
        /// Statements if it is true.
        then: Vec<Stmt>,
        /// Statements if it is false.
        otherwise: Vec<Stmt>,
    },
    /// `switch`.
    Switch {
        /// Value that selects the case.
        scrutinee: Expr,
        /// Cases, in order.
        arms: Vec<SwitchArm>,
    },
    /// `for (init; condition; step)`.
    For {
        /// The counter and its first value.
        init: (Declarator, Expr),
        /// Condition for a further pass.
        condition: Expr,
        /// Expression after each pass; none if empty.
        step: Option<Step>,
        /// Body of the loop.
        body: Vec<Stmt>,
    },
    /// `while (condition)`.
    While {
        /// Condition for a further pass.
        condition: Expr,
        /// Body of the loop.
        body: Vec<Stmt>,
    },
    /// `return`.
    Return(Option<Expr>),
    /// `break`.
    Break,
    /// `continue`.
    Continue,
    /// `for (;;) { }`, which never ends.
    Forever,
    /// `{ … }`.
    Block(Vec<Stmt>),
    /// Lines printed unchanged.
    Verbatim(String),
}

impl StmtKind {
    /// Returns the expressions in the statement, without those of its blocks.
    pub fn expressions(&self) -> Vec<&Expr> {
        match self {
            StmtKind::Declare(_, Some(init)) => init.expressions(),
            StmtKind::Expr(value) | StmtKind::Return(Some(value)) => vec![value],
            StmtKind::Assign(place, _, value) => vec![place, value],
            StmtKind::Build(place, _, init) => {
                std::iter::once(place).chain(init.expressions()).collect()
            }
            StmtKind::If { condition, .. } | StmtKind::While { condition, .. } => vec![condition],
            StmtKind::Switch { scrutinee, .. } => vec![scrutinee],
            StmtKind::For { init: (_, first), condition, step, .. } => match step {
                Some(Step::Expr(value)) => vec![first, condition, value],
                Some(Step::Assign(place, value)) => vec![first, condition, place, value],
                None => vec![first, condition],
            },
            _ => Vec::new(),
        }
    }

    /// Returns the blocks in the statement.
    pub fn blocks(&self) -> Vec<&Vec<Stmt>> {
        match self {
            StmtKind::If { then, otherwise, .. } => vec![then, otherwise],
            StmtKind::Switch { arms, .. } => arms.iter().map(|arm| &arm.body).collect(),
            StmtKind::For { body, .. } | StmtKind::While { body, .. } | StmtKind::Block(body) => {
                vec![body]
            }
            _ => Vec::new(),
        }
    }

    /// Returns the blocks in the statement, for changes.
    pub fn blocks_mut(&mut self) -> Vec<&mut Vec<Stmt>> {
        match self {
            StmtKind::If { then, otherwise, .. } => vec![then, otherwise],
            StmtKind::Switch { arms, .. } => arms.iter_mut().map(|arm| &mut arm.body).collect(),
            StmtKind::For { body, .. } | StmtKind::While { body, .. } | StmtKind::Block(body) => {
                vec![body]
            }
            _ => Vec::new(),
        }
    }
}

/// Third part of a `for`.
#[derive(Clone, Debug, PartialEq)]
pub enum Step {
    /// An expression, `i++` or `i--`.
    Expr(Expr),
    /// An assignment, `i = …`.
    Assign(Expr, Expr),
}

/// A group of `case` labels with its statements.
#[derive(Clone, Debug, PartialEq)]
pub struct SwitchArm {
    /// Values of the labels.
    pub labels: Vec<Expr>,
    /// True if `default:` is one of the labels.
    pub default: bool,
    /// Statements.
    pub body: Vec<Stmt>,
}

/// Storage class of a function.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Storage {
    /// Visible in every file.
    Extern,
    /// Visible in its own file.
    Static,
    /// Inline, in a header for the sources.
    Inline,
    /// Inline, in its own file.
    OwnInline,
    /// External: the firmware defines it.
    Foreign,
    /// External: a function of the target's `math.h`.
    Library,
}

/// Head of a function.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Head {
    /// Clauses of its contract; empty if there is none.
    pub contract: Vec<String>,
    /// Macros of compiler attributes.
    pub asked: Vec<String>,
    /// Storage class: `static`, `static inline`, ….
    pub storage: Storage,
    /// The type of the result.
    pub result: String,
    /// The name.
    pub name: String,
    /// The parameters.
    pub params: Vec<Declarator>,
}

/// A member of a struct or of a union, with its doc comment.
#[derive(Clone, Debug, PartialEq)]
pub enum Member {
    /// A field.
    Field(Vec<String>, Declarator),
    /// `struct { … } name;`, or `union`: fields whose type has no name.
    Inside {
        /// The doc comment.
        docs: Vec<String>,
        /// True for a union.
        shared: bool,
        /// Members.
        fields: Vec<Member>,
        /// Name of the member.
        name: String,
    },
}

/// Items at the top level of a file.
#[derive(Clone, Debug, PartialEq)]
pub enum Item {
    /// `typedef struct { … } name;`, or `typedef union`.
    Struct {
        /// True for a union.
        shared: bool,
        /// The author's doc comment.
        docs: Vec<String>,
        /// The name of the type.
        name: String,
        /// The fields.
        fields: Vec<Member>,
        /// Source position.
        origin: Origin,
    },
    /// `typedef enum { … } name;`
    Enum {
        /// The author's doc comment.
        docs: Vec<String>,
        /// The name of the type.
        name: String,
        /// Enumerators, each with its doc comment, name and value.
        variants: Vec<(Vec<String>, String, i32)>,
        /// Source position.
        origin: Origin,
    },
    /// `static const …;` in a file, or a constant that several files share.
    Constant {
        /// Storage class.
        storage: Storage,
        /// The author's doc comment.
        docs: Vec<String>,
        /// Macro of a compiler attribute, on the line before.
        asked: Option<String>,
        /// Name and type.
        declarator: Declarator,
        /// Value; none if another file defines it.
        init: Option<Init>,
        /// Source position.
        origin: Origin,
        /// Rust path.
        path: String,
    },
    /// `#define name value`.
    Define {
        /// The author's doc comment.
        docs: Vec<String>,
        /// Name of the macro.
        name: String,
        /// Value, a literal.
        value: Expr,
        /// Source position.
        origin: Origin,
        /// Rust path.
        path: String,
    },
    /// A function's declaration.
    Prototype {
        /// The author's doc comment.
        docs: Vec<String>,
        /// The head.
        head: Head,
        /// Source position.
        origin: Origin,
        /// Rust path.
        function: String,
    },
    /// A function.
    Function {
        /// Doc comment, unless the prototype has it.
        docs: Vec<String>,
        /// The head.
        head: Head,
        /// The body.
        body: Vec<Stmt>,
        /// Source position.
        origin: Origin,
        /// Rust path.
        function: String,
    },
    /// Text printed unchanged.
    Verbatim(String),
}

/// Returns a statement without a source line.
pub fn plain(kind: StmtKind) -> Stmt {
    Stmt { kind, origin: None }
}

/// The assignment that an operator has: `+=` of `+`.
pub fn compound(op: &str) -> Option<&'static str> {
    Some(match op {
        "+" => "+=",
        "-" => "-=",
        "*" => "*=",
        "/" => "/=",
        "&" => "&=",
        "|" => "|=",
        "^" => "^=",
        "<<" => "<<=",
        ">>" => ">>=",
        _ => return None,
    })
}

/// Returns true if a text is a literal without a sign, of `int` or `unsigned int`.
fn is_counted(text: &str) -> bool {
    let digits = text.trim_end_matches('U');
    let hexadecimal = digits.strip_prefix("0x");
    let is_digit = |byte: u8| match hexadecimal {
        Some(_) => byte.is_ascii_hexdigit(),
        None => byte.is_ascii_digit(),
    };
    let digits = hexadecimal.unwrap_or(digits);
    !digits.is_empty() && digits.bytes().all(is_digit)
}
