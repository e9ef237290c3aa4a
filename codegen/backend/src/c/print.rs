//! Prints the C tree, and records the source line of each statement for the map.
//!
//! Invariant: in a function that has a source line, each statement has one; that of the statement before it if it has
//! none of its own.
//!
//! Decides indentation, line breaks, braces, and the form of comments. Must not know: the IR.

use super::comments::comment_lines;
use super::file::MapLine;
use super::layout_text::{Pieces, WIDTH, fill, flat};
use super::tree::{
    Declarator, Head, Init, Item, Lines, Member, Origin, Step, Stmt, StmtKind, Storage, SwitchArm,
};

/// Columns of one indentation level.
const INDENT: usize = 4;

/// Text being printed.
pub struct Printer<'a> {
    files: &'a [String],
    text: String,
    line: u32,
    map: Vec<MapLine>,
    function: String,
    /// Position of the last statement that has one, which the following statements without one belong to.
    nearest: Option<Origin>,
    level: usize,
}

impl<'a> Printer<'a> {
    /// Creates a printer whose first line has the number `first_line` in its file.
    pub fn new(files: &'a [String], first_line: u32) -> Printer<'a> {
        Printer {
            files,
            text: String::new(),
            line: first_line,
            map: Vec::new(),
            function: String::new(),
            nearest: None,
            level: 0,
        }
    }

    /// Returns the text and its map.
    pub fn finish(self) -> (String, Vec<MapLine>) {
        (self.text, self.map)
    }

    fn margin(&self) -> usize {
        self.level * INDENT
    }

    fn put(&mut self, text: &str) {
        if !text.is_empty() {
            let margin = self.margin();
            self.text.push_str(&" ".repeat(margin));
            self.text.push_str(text);
        }
        self.end_line();
    }

    fn end_line(&mut self) {
        self.text.push('\n');
        self.line += 1;
    }

    fn put_filled(&mut self, pieces: Pieces, further: usize) {
        for line in fill(&pieces.finish(), self.margin(), further) {
            self.text.push_str(&line);
            self.end_line();
        }
    }

    fn mark(&mut self, origin: Option<Origin>) {
        let own = origin.filter(|origin| origin.line > 0);
        self.nearest = own.or(self.nearest);
        if let Some(origin) = self.nearest {
            self.map.push(MapLine {
                c_line: self.line,
                rust_file: self.files.get(origin.file as usize).cloned().unwrap_or_default(),
                rust_line: origin.line,
                function: self.function.clone(),
            });
        }
    }

    /// Prints fields in braces, and the name after them.
    fn fields(&mut self, before: &str, shared: bool, fields: &[Member], name: &str) {
        self.put(&format!("{before}{} {{", if shared { "union" } else { "struct" }));
        self.level += 1;
        for field in fields {
            match field {
                Member::Field(docs, field) => {
                    self.docs(docs);
                    self.put(&format!("{};", field.text()));
                }
                Member::Inside { docs, shared, fields, name } => {
                    self.docs(docs);
                    self.fields("", *shared, fields, name);
                }
            }
        }
        self.level -= 1;
        self.put(&format!("}} {name};"));
    }

    /// Prints an item, with an empty line before it unless it is the first.
    pub fn item(&mut self, item: &Item, gap: bool) {
        if gap {
            self.end_line();
        }
        self.function.clear();
        self.nearest = None;
        match item {
            Item::Struct { shared, docs, name, fields, origin } => {
                self.docs(docs);
                self.mark(Some(*origin));
                self.fields("typedef ", *shared, fields, name);
            }
            Item::Enum { docs, name, variants, origin } => {
                self.docs(docs);
                self.mark(Some(*origin));
                self.put("typedef enum {");
                self.level += 1;
                for (index, (docs, variant, value)) in variants.iter().enumerate() {
                    self.docs(docs);
                    let comma = if index + 1 < variants.len() { "," } else { "" };
                    self.put(&format!("{variant} = {value}{comma}"));
                }
                self.level -= 1;
                self.put(&format!("}} {name};"));
            }
            Item::Constant { storage, docs, asked, declarator, init, origin, path } => {
                self.docs(docs);
                asked.iter().for_each(|asked| self.put(asked));
                self.function.clone_from(path);
                self.mark(Some(*origin));
                let storage = match (storage, init) {
                    (Storage::Extern, None) => "extern ",
                    (Storage::Extern, Some(_)) => "",
                    _ => "static ",
                };
                self.declare(storage, declarator, init.as_ref());
            }
            Item::Define { docs, name, value, origin, path } => {
                self.docs(docs);
                self.function.clone_from(path);
                self.mark(Some(*origin));
                self.put(&format!("#define {name} {}", flat(value)));
            }
            Item::Prototype { docs, head, origin, function } => {
                self.docs(docs);
                self.contract(&head.contract);
                self.function.clone_from(function);
                self.mark(Some(*origin));
                self.head(head, ";");
            }
            Item::Function { docs, head, body, origin, function } => {
                self.docs(docs);
                self.contract(&head.contract);
                self.function.clone_from(function);
                self.mark(Some(*origin));
                self.head(head, "");
                self.put("{");
                self.block(body);
                self.put("}");
            }
            Item::Verbatim(text) => {
                for line in text.lines() {
                    self.put(line);
                }
            }
        }
    }

    fn head(&mut self, head: &Head, end: &str) {
        if !head.asked.is_empty() {
            self.put(&head.asked.join(" "));
        }
        let mut pieces = Pieces::default();
        let storage = match head.storage {
            Storage::Extern | Storage::Foreign | Storage::Library => "",
            Storage::Static => "static ",
            Storage::Inline | Storage::OwnInline => "static inline ",
        };
        let gap = if head.result.ends_with('*') { "" } else { " " };
        pieces.glue(&format!("{storage}{}{gap}{}(", head.result, head.name));
        if head.params.is_empty() {
            pieces.glue("void");
        }
        for (index, param) in head.params.iter().enumerate() {
            if index > 0 {
                pieces.glue(",");
            }
            pieces.allow_break(0);
            if index > 0 {
                pieces.glue(" ");
            }
            pieces.glue(&param.text());
        }
        pieces.glue(&format!("){end}"));
        self.put_filled(pieces, INDENT);
    }

    /// Prints a doc comment.
    fn docs(&mut self, docs: &[String]) {
        self.comment("/**", docs);
    }

    /// Prints clauses in the form of ACSL. A clause is one line, whatever its length: its words are no prose.
    fn contract(&mut self, clauses: &[String]) {
        match clauses {
            [] => {}
            [only] => self.put(&format!("/*@ {only} */")),
            _ => {
                self.put("/*@");
                clauses.iter().for_each(|clause| self.put(&format!("  {clause}")));
                self.put("*/");
            }
        }
    }

    fn comment(&mut self, open: &str, lines: &[String]) {
        let lines = comment_lines(lines);
        if let [line] = &lines[..]
            && line.chars().count() + self.margin() + open.len() + 4 <= WIDTH
        {
            self.put(&format!("{open} {line} */"));
            return;
        }
        if lines.is_empty() {
            return;
        }
        self.put(open);
        for line in &lines {
            self.put(format!(" * {line}").trim_end());
        }
        self.put(" */");
    }

    fn block(&mut self, block: &[Stmt]) {
        self.level += 1;
        for (index, stmt) in block.iter().enumerate() {
            match stmt.kind {
                StmtKind::Comment(_) if index == 0 => {}
                StmtKind::Comment(_) => self.end_line(),
                StmtKind::Annotation(_) => {}
                _ => self.mark(stmt.origin),
            }
            self.stmt(&stmt.kind);
        }
        self.level -= 1;
    }

    fn stmt(&mut self, kind: &StmtKind) {
        match kind {
            StmtKind::Comment(lines) => self.comment("/*", lines),
            StmtKind::Annotation(clauses) => self.contract(clauses),
            StmtKind::Declare(declarator, init) => self.declare("", declarator, init.as_ref()),
            StmtKind::Expr(expr) => {
                let mut pieces = Pieces::default();
                pieces.expr(expr, 0);
                pieces.glue(";");
                self.put_filled(pieces, INDENT);
            }
            StmtKind::Assign(place, op, value) => {
                let mut pieces = Pieces::default();
                pieces.expr(place, 20);
                pieces.glue(&format!(" {op} "));
                pieces.expr(value, 0);
                pieces.glue(";");
                self.put_filled(pieces, INDENT);
            }
            StmtKind::Build(place, ty, init) => {
                self.initialised(&format!("{} = ({ty})", flat(place)), init);
            }
            StmtKind::If { condition, then, otherwise } => {
                self.if_chain("", condition, then, otherwise);
            }
            StmtKind::Switch { scrutinee, arms } => {
                self.put(&format!("switch ({}) {{", flat(scrutinee)));
                for arm in arms {
                    self.arm(arm);
                }
                self.put("}");
            }
            StmtKind::For { init, condition, step, body } => {
                let step = match step {
                    None => String::new(),
                    Some(Step::Expr(expr)) => format!(" {}", flat(expr)),
                    Some(Step::Assign(place, value)) => {
                        format!(" {} = {}", flat(place), flat(value))
                    }
                };
                let (counter, first) = init;
                let mut pieces = Pieces::default();
                pieces.glue(&format!("for ({} = {};", counter.text(), flat(first)));
                pieces.allow_break(0);
                pieces.glue(&format!(" {};", flat(condition)));
                pieces.allow_break(0);
                pieces.glue(&format!("{step}) {{"));
                self.put_filled(pieces, 2 * INDENT);
                self.block(body);
                self.put("}");
            }
            StmtKind::While { condition, body } => {
                let mut pieces = Pieces::default();
                pieces.glue("while (");
                pieces.expr(condition, 0);
                pieces.glue(") {");
                self.put_filled(pieces, 2 * INDENT);
                self.block(body);
                self.put("}");
            }
            StmtKind::Return(None) => self.put("return;"),
            StmtKind::Return(Some(value)) => {
                let mut pieces = Pieces::default();
                pieces.glue("return ");
                pieces.expr(value, 0);
                pieces.glue(";");
                self.put_filled(pieces, INDENT);
            }
            StmtKind::Forever => {
                self.put("for (;;) {");
                self.put("}");
            }
            StmtKind::Break => self.put("break;"),
            StmtKind::Continue => self.put("continue;"),
            StmtKind::Verbatim(text) => {
                for line in text.lines() {
                    // The preprocessor's lines start where lines start.
                    let level = if line.starts_with('#') { 0 } else { self.level };
                    let level = std::mem::replace(&mut self.level, level);
                    self.put(line);
                    self.level = level;
                }
            }
            StmtKind::Block(block) => {
                self.put("{");
                self.block(block);
                self.put("}");
            }
        }
    }

    fn if_chain(
        &mut self,
        before: &str,
        condition: &super::tree::Expr,
        then: &[Stmt],
        otherwise: &[Stmt],
    ) {
        let mut pieces = Pieces::default();
        pieces.glue(&format!("{before}if ("));
        pieces.expr(condition, 0);
        pieces.glue(") {");
        self.put_filled(pieces, 2 * INDENT);
        self.block(then);
        match otherwise {
            // Who reads a chain is reported that nothing was forgotten.
            [] if !before.is_empty() => {
                self.put("} else {");
                self.level += 1;
                self.put("/* Nothing. */");
                self.level -= 1;
                self.put("}");
            }
            [] => self.put("}"),
            [Stmt { kind: StmtKind::If { condition, then, otherwise }, origin }] => {
                self.mark(*origin);
                self.if_chain("} else ", condition, then, otherwise);
            }
            _ => {
                self.put("} else {");
                self.block(otherwise);
                self.put("}");
            }
        }
    }

    fn arm(&mut self, arm: &SwitchArm) {
        // A label must be followed by a statement, not by a declaration: braces give the scope.
        let declares = arm.body.iter().any(|stmt| matches!(stmt.kind, StmtKind::Declare(..)));
        let brace = if declares { " {" } else { "" };
        let mut labels: Vec<String> =
            arm.labels.iter().map(|label| format!("case {}:", flat(label))).collect();
        if arm.default {
            labels.push("default:".to_owned());
        }
        for (index, label) in labels.iter().enumerate() {
            let last = index + 1 == labels.len();
            self.put(&format!("{label}{}", if last { brace } else { "" }));
        }
        self.block(&arm.body);
        let leaves = matches!(
            arm.body.last().map(|stmt| &stmt.kind),
            Some(StmtKind::Return(_) | StmtKind::Continue)
        );
        if !leaves {
            self.level += 1;
            self.mark(None);
            self.put("break;");
            self.level -= 1;
        }
        if declares {
            self.put("}");
        }
    }

    fn declare(&mut self, storage: &str, declarator: &Declarator, init: Option<&Init>) {
        let head = format!("{storage}{}", declarator.text());
        match init {
            None => self.put(&format!("{head};")),
            Some(Init::Value(value)) => {
                let mut pieces = Pieces::default();
                pieces.glue(&format!("{head} = "));
                pieces.expr(value, 0);
                pieces.glue(";");
                self.put_filled(pieces, INDENT);
            }
            Some(list) => self.initialised(&format!("{head} = "), list),
        }
    }

    /// Prints an initialiser list, on one line if it fits.
    fn initialised(&mut self, before: &str, list: &Init) {
        let one = format!("{before}{};", flat_init(list));
        if one.chars().count() + self.margin() <= WIDTH && !by_lines(list) {
            self.put(&one);
        } else {
            self.list(before, list, ";");
        }
    }

    fn list(&mut self, before: &str, init: &Init, after: &str) {
        let Init::List { items, lines } = init else { unreachable!("called with a list") };
        self.put(&format!("{before}{{"));
        self.level += 1;
        let plain = items.iter().all(|(name, init)| name.is_none() && is_value(init));
        if *lines == Lines::Fill && plain {
            let mut pieces = Pieces::default();
            for (index, (_, item)) in items.iter().enumerate() {
                pieces.allow_break(0);
                let gap = if index > 0 { " " } else { "" };
                let comma = if index + 1 < items.len() { "," } else { "" };
                pieces.glue(&format!("{gap}{}{comma}", flat_init(item)));
            }
            self.put_filled(pieces, 0);
        } else {
            let size = if let Lines::Groups(size) = lines { *size } else { 1 };
            for (index, group) in items.chunks(size).enumerate() {
                let last = (index + 1) * size >= items.len();
                self.group(group, if last { "" } else { "," });
            }
        }
        self.level -= 1;
        self.put(&format!("}}{after}"));
    }

    fn group(&mut self, group: &[(Option<String>, Init)], end: &str) {
        if let [(name, list @ Init::List { .. })] = group {
            let name = name.as_ref().map(|name| format!(".{name} = ")).unwrap_or_default();
            let one = format!("{name}{}{end}", flat_init(list));
            if one.chars().count() + self.margin() <= WIDTH && !by_lines(list) {
                self.put(&one);
            } else {
                self.list(&name, list, end);
            }
            return;
        }
        let mut pieces = Pieces::default();
        for (index, (name, item)) in group.iter().enumerate() {
            if index > 0 {
                pieces.glue(",");
                pieces.allow_break(0);
                pieces.glue(" ");
            }
            if let Some(name) = name {
                pieces.glue(&format!(".{name} = "));
            }
            match item {
                Init::Value(value) => pieces.expr(value, 1),
                list => pieces.glue(&flat_init(list)),
            }
        }
        pieces.glue(end);
        self.put_filled(pieces, INDENT);
    }
}

fn is_value(init: &Init) -> bool {
    matches!(init, Init::Value(_))
}

/// Returns true if a list has several lines whatever its length.
fn by_lines(init: &Init) -> bool {
    match init {
        Init::Value(_) => false,
        Init::List { items, lines } => {
            matches!(lines, Lines::Groups(size) if items.len() > *size)
                || items.iter().any(|(_, item)| by_lines(item))
        }
    }
}

fn flat_init(init: &Init) -> String {
    match init {
        Init::Value(value) => flat(value),
        Init::List { items, .. } => {
            let items: Vec<String> = items
                .iter()
                .map(|(name, item)| match name {
                    Some(name) => format!(".{name} = {}", flat_init(item)),
                    None => flat_init(item),
                })
                .collect();
            format!("{{{}}}", items.join(", "))
        }
    }
}
