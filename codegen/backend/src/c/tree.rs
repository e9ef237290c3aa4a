//! The C tree: what the lowering builds and the printer prints.
//!
//! Expressions know their precedence, so that parentheses are the printer's business alone. Types are
//! the lowering's: it has put every conversion in place as a [`Expr::Cast`]. Nothing here knows the
//! IR, save that statements carry the Rust line they come from.

/// An expression.
#[derive(Clone, Debug, PartialEq)]
pub enum Expr {
    /// An identifier, a literal without sign, or a macro.
    Name(String),
    /// `-x`, `!x`, `~x`, `*x`, `&x`.
    Unary(&'static str, Box<Expr>),
    /// `a op b`.
    Binary(&'static str, Box<Expr>, Box<Expr>),
    /// `a ? b : c`.
    Conditional(Box<Expr>, Box<Expr>, Box<Expr>),
    /// `(type)x`.
    Cast(String, Box<Expr>),
    /// `name(arguments)`.
    Call(String, Vec<Expr>),
    /// `array[index]`.
    Index(Box<Expr>, Box<Expr>),
    /// `value.field`.
    Member(Box<Expr>, String),
    /// `pointer->field`.
    Arrow(Box<Expr>, String),
    /// `x++`, `x--`.
    Postfix(Box<Expr>, &'static str),
}

impl Expr {
    /// An identifier or a literal.
    pub fn name(text: impl Into<String>) -> Expr {
        Expr::Name(text.into())
    }

    /// `a op b`.
    pub fn binary(op: &'static str, left: Expr, right: Expr) -> Expr {
        Expr::Binary(op, Box::new(left), Box::new(right))
    }

    /// A unary operator.
    pub fn unary(op: &'static str, operand: Expr) -> Expr {
        Expr::Unary(op, Box::new(operand))
    }

    /// `(ty)operand`, unless it is that cast already or a literal that can have the type itself.
    pub fn cast(ty: &str, operand: Expr) -> Expr {
        match operand {
            Expr::Cast(inner, value) if inner == ty => Expr::Cast(inner, value),
            Expr::Name(text) if ty == "uint32_t" && is_counted(&text) => {
                Expr::Name(format!("{}U", text.trim_end_matches('U')))
            }
            other => Expr::Cast(ty.to_owned(), Box::new(other)),
        }
    }

    /// A call.
    pub fn call(function: impl Into<String>, arguments: Vec<Expr>) -> Expr {
        Expr::Call(function.into(), arguments)
    }

    /// The last name in a place: a field's, or a variable's.
    pub fn last_name(&self) -> Option<&str> {
        match self {
            Expr::Name(name) | Expr::Member(_, name) | Expr::Arrow(_, name) => Some(name),
            Expr::Index(place, _) | Expr::Unary("*", place) => place.last_name(),
            _ => None,
        }
    }

    /// `self[index]`.
    pub fn at(self, index: Expr) -> Expr {
        Expr::Index(Box::new(self), Box::new(index))
    }

    /// The field of a struct, whether the struct is at hand or behind a pointer.
    pub fn field(self, name: &str) -> Expr {
        match self {
            Expr::Unary("*", pointer) => Expr::Arrow(pointer, name.to_owned()),
            value => Expr::Member(Box::new(value), name.to_owned()),
        }
    }

    /// The address of what is not an array (an array is its own address).
    pub fn address(self) -> Expr {
        match self {
            Expr::Unary("*", pointer) => *pointer,
            value => Expr::unary("&", value),
        }
    }

    /// Binding strength; the larger binds tighter.
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

/// Binding strength of a binary operator.
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
    /// A value.
    Value(Expr),
    /// `{…}`.
    List {
        /// The items, each with its designator if it is a field.
        items: Vec<(Option<String>, Init)>,
        /// Layout of the list.
        lines: Lines,
    },
}

/// Layout of a list.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Lines {
    /// On one line, or as many items on each as fit.
    Fill,
    /// On one line, or an item on each.
    Each,
    /// So many items on each, as a matrix has them.
    Groups(usize),
}

/// `type name[dimensions]`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Declarator {
    /// `const double`, `pid_t *`.
    pub ty: String,
    /// The name.
    pub name: String,
    /// `[3][4]`, or nothing.
    pub dimensions: String,
}

impl Declarator {
    /// As C writes it.
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
    /// Its action.
    pub kind: StmtKind,
    /// Source position.
    pub origin: Option<Origin>,
}

/// Kinds of statements.
#[derive(Clone, Debug, PartialEq)]
pub enum StmtKind {
    /// `/* … */`, a line each.
    Comment(Vec<String>),
    /// A declaration.
    Declare(Declarator, Option<Init>),
    /// An expression for its effect.
    Expr(Expr),
    /// `place op value;`, `op` being `=` or `+=` and the like.
    Assign(Expr, &'static str, Expr),
    /// `place = (type){…};`
    Build(Expr, String, Init),
    /// `if`.
    If {
        /// The condition.
        condition: Expr,
        /// When true.
        then: Vec<Stmt>,
        /// When false.
        otherwise: Vec<Stmt>,
    },
    /// `switch`.
    Switch {
        /// Value that selects the case.
        scrutinee: Expr,
        /// In order.
        arms: Vec<SwitchArm>,
    },
    /// `for (init; condition; step)`.
    For {
        /// The counter and its first value.
        init: (Declarator, Expr),
        /// While it holds.
        condition: Expr,
        /// After each pass, if anything is left to do.
        step: Option<Step>,
        /// Body of the loop.
        body: Vec<Stmt>,
    },
    /// `while (condition)`.
    While {
        /// While it holds.
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
    /// `for (;;) { }`: nothing runs on.
    Forever,
    /// `{ … }`.
    Block(Vec<Stmt>),
    /// Lines that come as they are.
    Verbatim(String),
}

/// The third part of a `for`.
#[derive(Clone, Debug, PartialEq)]
pub enum Step {
    /// `i++`, `i--`.
    Expr(Expr),
    /// `i = …`.
    Assign(Expr, Expr),
}

/// A group of `case` labels with what they do.
#[derive(Clone, Debug, PartialEq)]
pub struct SwitchArm {
    /// The values.
    pub labels: Vec<Expr>,
    /// True if `default:` stands here too.
    pub default: bool,
    /// Its action.
    pub body: Vec<Stmt>,
}

/// Storage class of a function.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Storage {
    /// Every file.
    Extern,
    /// Its own file.
    Static,
    /// The sources, which have it of a header of their own.
    Inline,
    /// Its own file, at whose calls it may stand.
    OwnInline,
    /// The firmware's.
    Foreign,
    /// It is the target's own, of `math.h`.
    Library,
}

/// The head of a function, as C writes it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Head {
    /// Attributes for the compiler, one macro each.
    pub asked: Vec<String>,
    /// `static`, or `static inline`.
    pub storage: Storage,
    /// The type of the result.
    pub result: String,
    /// The name.
    pub name: String,
    /// The parameters.
    pub params: Vec<Declarator>,
}

/// A part of a struct or of a union, with its doc comment.
#[derive(Clone, Debug, PartialEq)]
pub enum Member {
    /// A field.
    Field(Vec<String>, Declarator),
    /// `struct { … } name;`, or `union`: fields whose type nothing else speaks of.
    Inside {
        /// The doc comment.
        docs: Vec<String>,
        /// True if they share their memory.
        shared: bool,
        /// They.
        fields: Vec<Member>,
        /// The name of all of them.
        name: String,
    },
}

/// Items at the top level of a file.
#[derive(Clone, Debug, PartialEq)]
pub enum Item {
    /// `typedef struct { … } name;`, or `typedef union`.
    Struct {
        /// True if all fields share their memory.
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
        /// The enumerators, each with its doc comment and its value.
        variants: Vec<(Vec<String>, String, i32)>,
        /// Source position.
        origin: Origin,
    },
    /// `static const …;` at the top of a file, or one that several files see.
    Constant {
        /// Storage class.
        storage: Storage,
        /// The author's doc comment.
        docs: Vec<String>,
        /// Attribute for the compiler, on the line before.
        asked: Option<String>,
        /// Its name and type.
        declarator: Declarator,
        /// Its value, unless another file gives it.
        init: Option<Init>,
    },
    /// `#define name value`.
    Define {
        /// The author's doc comment.
        docs: Vec<String>,
        /// Its name.
        name: String,
        /// Its value, a literal.
        value: Expr,
    },
    /// A function's declaration.
    Prototype {
        /// The author's doc comment.
        docs: Vec<String>,
        /// The head.
        head: Head,
        /// Source position.
        origin: Origin,
        /// The Rust path.
        function: String,
    },
    /// A function.
    Function {
        /// The doc comment, where no prototype carries it.
        docs: Vec<String>,
        /// The head.
        head: Head,
        /// The body.
        body: Vec<Stmt>,
        /// Source position.
        origin: Origin,
        /// The Rust path.
        function: String,
    },
    /// Text that comes as it is.
    Verbatim(String),
}

/// A statement that no line of the author's represents.
pub fn plain(kind: StmtKind) -> Stmt {
    Stmt { kind, origin: None }
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
