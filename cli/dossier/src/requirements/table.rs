//! Lists of requirements: CSV and ReqIF, read and written.
//!
//! Invariant: a list that was written is read with the same content.

pub use super::reqif::written as to_reqif;

use std::collections::BTreeMap;

use super::reqif;
use crate::separated::{self, Rows};

/// Number of a line, from 1.
pub(super) type Line = u64;

/// A requirement.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Requirement {
    /// Its identifier: `HLR-12`.
    pub id: String,
    /// Its text.
    pub text: String,
}

/// Reason why a list cannot be read.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum Error {
    /// The file has another form than its name says.
    #[error("line {line}: {why}")]
    Csv {
        /// The line.
        line: u64,
        /// The mistake.
        why: String,
    },
    /// The table has no column of identifiers.
    #[error("the first line names no column `id`: {found}")]
    NoId {
        /// Names of the columns.
        found: String,
    },
    /// A row has more cells than the table has columns.
    #[error("line {line}: {cells} cells below {columns} columns")]
    Long {
        /// The line.
        line: u64,
        /// Number of its cells.
        cells: usize,
        /// Number of the columns.
        columns: usize,
    },
    /// The file is an archive.
    #[error("this is an archive, not the list in it")]
    Archive,
    /// The file is no ReqIF.
    #[error("line {line}: {why}")]
    Xml {
        /// The line.
        line: u64,
        /// The mistake.
        why: String,
    },
    /// A requirement has no identifier.
    #[error("line {line}: the requirement has no identifier")]
    Unnamed {
        /// The line.
        line: u64,
    },
    /// Two requirements have one identifier.
    #[error("line {line}: `{id}` is there twice, first in line {first}")]
    Twice {
        /// The identifier.
        id: String,
        /// The line of the first.
        first: u64,
        /// The line of the second.
        line: u64,
    },
}

impl Error {
    /// Returns a step that resolves the error.
    pub fn remedy(&self) -> &'static str {
        match self {
            Error::Long { .. } => "put a text with a separator between quotes: `HLR-1,\"a, b\"`",
            Error::Archive => "unpack it, and pass the file whose name ends with `.reqif`",
            Error::Unnamed { .. } => "give the requirement an identifier, or remove its line",
            Error::Twice { .. } => "give each requirement an identifier of its own",
            Error::Csv { .. } | Error::NoId { .. } | Error::Xml { .. } => {
                "pass CSV with a column `id` and one `text`, or ReqIF"
            }
        }
    }
}

/// Reads a list; a text that begins as XML is ReqIF, another is CSV.
///
/// # Errors
/// See [`Error`].
pub fn read(text: &str) -> Result<Vec<Requirement>, Error> {
    if text.starts_with("PK\u{3}\u{4}") {
        return Err(Error::Archive);
    }
    let list = match separated::unmarked(text).trim_start().starts_with('<') {
        true => reqif::read(separated::unmarked(text))?,
        false => from_csv(text)?,
    };
    let mut first: BTreeMap<&str, Line> = BTreeMap::new();
    for (it, line) in &list {
        if it.id.is_empty() {
            return Err(Error::Unnamed { line: *line });
        }
        if let Some(first) = first.insert(&it.id, *line) {
            return Err(Error::Twice { id: it.id.clone(), first, line: *line });
        }
    }
    Ok(list.into_iter().map(|(it, _)| it).collect())
}

fn from_csv(text: &str) -> Result<Vec<(Requirement, Line)>, Error> {
    let mut reader = separated::reader(text, Rows::Ragged);
    let wrong = |error: &csv::Error| Error::Csv {
        line: error.position().map_or(1, csv::Position::line),
        why: error.to_string(),
    };
    let head = reader.headers().map_err(|error| wrong(&error))?.clone();
    let column = |names: &[&str]| {
        names.iter().find_map(|name| head.iter().position(|it| it.eq_ignore_ascii_case(name)))
    };
    let id = column(&["id", "uid", "identifier", "requirement"]);
    let id = id.ok_or_else(|| Error::NoId { found: head.iter().collect::<Vec<_>>().join(", ") })?;
    let says = column(&["text", "statement", "description", "title", "name"]);
    let mut list = Vec::new();
    for record in reader.records() {
        let record = record.map_err(|error| wrong(&error))?;
        let line = separated::line(text, &record);
        let last = (0..record.len()).rfind(|at| !record[*at].is_empty());
        let filled = last.map_or(0, |last| last + 1);
        match filled {
            // Spreadsheets write rows without content.
            0 => continue,
            cells if cells > head.len() => {
                return Err(Error::Long { line, cells, columns: head.len() });
            }
            _ => {}
        }
        let cell = |at: Option<usize>| at.and_then(|at| record.get(at)).unwrap_or_default();
        let (id, text) = (cell(Some(id)).to_owned(), cell(says).to_owned());
        list.push((Requirement { id, text }, line));
    }
    Ok(list)
}

/// Returns a list as CSV.
pub fn to_csv(rows: &[[String; 6]]) -> String {
    let mut writer = csv::Writer::from_writer(Vec::new());
    let head = ["id", "text", "rust", "c", "tests", "result"].map(str::to_owned);
    for row in std::iter::once(&head).chain(rows) {
        // A record in memory has no error.
        let _ = writer.write_record(row);
    }
    writer.into_inner().map(|it| String::from_utf8_lossy(&it).into_owned()).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rows() -> Vec<[String; 6]> {
        [
            [
                "HLR-1",
                "The speed, \"fast\" & <1 s>; or less\nin a second line",
                "Motor::step",
                "motor_step",
                // Longer than the text.
                "holds falls rises goes_left goes_right stops_at_once stops_later starts_again",
                "passed",
            ],
            ["HLR-2", "", "Motor::stop", "motor_stop", "", "no test"],
        ]
        .map(|row| row.map(str::to_owned))
        .to_vec()
    }

    fn wanted() -> Vec<Requirement> {
        rows().into_iter().map(|[id, text, ..]| Requirement { id, text }).collect()
    }

    #[test]
    fn both_forms_are_read_as_they_were_written() {
        assert_eq!(read(&to_csv(&rows())), Ok(wanted()));
        assert_eq!(read(&to_reqif("motor & more", &rows())), Ok(wanted()));
    }

    #[test]
    fn reqif_of_another_tool_is_read() {
        let text = "<?xml version='1.0'?><r:REQ-IF xmlns:r='x'><r:SPEC-ATTRIBUTES>\
<r:ATTRIBUTE-DEFINITION-XHTML IDENTIFIER='_t' LONG-NAME='ReqIF.Text'/>\
<r:ATTRIBUTE-DEFINITION-STRING IDENTIFIER='_i' LONG-NAME='ReqIF.ForeignID'/></r:SPEC-ATTRIBUTES>\
<r:SPEC-OBJECT IDENTIFIER='_a1'><r:VALUES><r:ATTRIBUTE-VALUE-STRING THE-VALUE='SYS-7'><r:DEFINITION>\
<r:ATTRIBUTE-DEFINITION-STRING-REF>_i</r:ATTRIBUTE-DEFINITION-STRING-REF></r:DEFINITION></r:ATTRIBUTE-VALUE-STRING>\
<r:ATTRIBUTE-VALUE-XHTML><r:THE-VALUE><x:div>The motor <x:b>stops</x:b> &lt; 1 s.</x:div></r:THE-VALUE><r:DEFINITION>\
<r:ATTRIBUTE-DEFINITION-XHTML-REF>_t</r:ATTRIBUTE-DEFINITION-XHTML-REF></r:DEFINITION></r:ATTRIBUTE-VALUE-XHTML>\
</r:VALUES></r:SPEC-OBJECT></r:REQ-IF>";
        let text_of = "The motor stops < 1 s.".to_owned();
        assert_eq!(read(text), Ok(vec![Requirement { id: "SYS-7".to_owned(), text: text_of }]));
    }

    /// DOORS, Polarion and StrictDoc write headings, rationales longer than the text, blocks of XHTML and enumerations. Objects are
    /// in another order than in the specification.
    #[test]
    fn reqif_has_headings_and_attributes_that_are_no_requirements() {
        let definition = |kind: &str, id: &str, long: &str| {
            format!("<ATTRIBUTE-DEFINITION-{kind} IDENTIFIER='{id}' LONG-NAME='{long}'/>")
        };
        let of = |kind: &str, id: &str| {
            format!(
                "<DEFINITION><ATTRIBUTE-DEFINITION-{kind}-REF>{id}</ATTRIBUTE-DEFINITION-{kind}-REF></DEFINITION>"
            )
        };
        let value = |kind: &str, id: &str, text: &str| {
            let of = of(kind, id);
            format!("<ATTRIBUTE-VALUE-{kind} THE-VALUE='{text}'>{of}</ATTRIBUTE-VALUE-{kind}>")
        };
        let xhtml = of("XHTML", "t");
        let state = of("ENUMERATION", "s");
        let text = [
            "<REQ-IF><SPEC-ATTRIBUTES>".to_owned(),
            definition("INTEGER", "i", "ReqIF.ForeignID"),
            definition("XHTML", "t", "ReqIF.Text"),
            definition("STRING", "c", "ReqIF.ChapterName"),
            definition("STRING", "r", "Rationale"),
            definition("STRING", "n", "ReqIF.Name"),
            definition("ENUMERATION", "s", "State"),
            "</SPEC-ATTRIBUTES><SPEC-OBJECT IDENTIFIER='o2'><VALUES>".to_owned(),
            value("INTEGER", "i", "12"),
            value("STRING", "n", "Starts"),
            "</VALUES></SPEC-OBJECT><SPEC-OBJECT IDENTIFIER='o0'><VALUES>".to_owned(),
            value("STRING", "c", "Speed"),
            value("INTEGER", "i", "10"),
            "</VALUES></SPEC-OBJECT><SPEC-OBJECT IDENTIFIER='o1'><VALUES>".to_owned(),
            value("STRING", "r", "Since the brake needs a second and a half, and the belt is worn."),
            format!("<ATTRIBUTE-VALUE-ENUMERATION>{state}<VALUES><ENUM-VALUE-REF>e</ENUM-VALUE-REF></VALUES></ATTRIBUTE-VALUE-ENUMERATION>"),
            format!("<ATTRIBUTE-VALUE-XHTML>{xhtml}<THE-VALUE><x:div><x:p>It stops.</x:p><x:p>At<x:br/>once.</x:p></x:div></THE-VALUE></ATTRIBUTE-VALUE-XHTML>"),
            value("INTEGER", "i", "11"),
            "</VALUES></SPEC-OBJECT><SPECIFICATION>".to_owned(),
            "<SPEC-HIERARCHY><OBJECT><SPEC-OBJECT-REF>o0</SPEC-OBJECT-REF></OBJECT><CHILDREN>".to_owned(),
            "<SPEC-HIERARCHY><OBJECT><SPEC-OBJECT-REF>o1</SPEC-OBJECT-REF></OBJECT></SPEC-HIERARCHY>".to_owned(),
            "<SPEC-HIERARCHY><OBJECT><SPEC-OBJECT-REF>o2</SPEC-OBJECT-REF></OBJECT></SPEC-HIERARCHY>".to_owned(),
            "</CHILDREN></SPEC-HIERARCHY></SPECIFICATION></REQ-IF>".to_owned(),
        ];
        let one = |id: &str, text: &str| Requirement { id: id.to_owned(), text: text.to_owned() };
        assert_eq!(
            read(&text.concat()),
            Ok(vec![one("11", "It stops. At once."), one("12", "Starts")])
        );
    }

    #[test]
    fn tables_of_other_tools_are_read() {
        let one = |id: &str, text: &str| Requirement { id: id.to_owned(), text: text.to_owned() };
        assert_eq!(read("\u{feff}Title;ID\nStops;A\n"), Ok(vec![one("A", "Stops")]));
        assert_eq!(read("id\nA\n"), Ok(vec![one("A", "")]));
    }

    #[test]
    fn columns_are_found_by_the_best_name_and_rows_without_content_are_none() {
        let text = "Title;UID;Statement\nStops;A;The motor stops.\n;;\n;;;\n";
        let one = Requirement { id: "A".to_owned(), text: "The motor stops.".to_owned() };
        assert_eq!(read(text), Ok(vec![one]));
    }

    #[test]
    fn mistakes_are_named_with_their_lines() {
        assert!(matches!(read("name\nA\n"), Err(Error::NoId { .. })));
        assert!(matches!(read(""), Err(Error::NoId { .. })));
        let id = "A".to_owned();
        assert_eq!(read("id\nA\n\nA\n"), Err(Error::Twice { id, first: 2, line: 4 }));
        assert_eq!(read("id,text\nA,\"a\nb\"\n,x\n"), Err(Error::Unnamed { line: 4 }));
        let long = Error::Long { line: 3, cells: 3, columns: 2 };
        assert_eq!(read("id,text\nA,b\nC,stops, at once\n"), Err(long));
        assert_eq!(read("PK\u{3}\u{4}x"), Err(Error::Archive));
        assert!(matches!(read("<a>\n</b>"), Err(Error::Xml { line: 2, .. })));
        assert!(matches!(read("<html>\n</html>\n"), Err(Error::Xml { .. })));
        let cut = "<REQ-IF>\n<SPEC-OBJECTS><SPEC-OBJECT IDENTIFIER='a'></SPEC-OBJECT>\n";
        assert!(matches!(read(cut), Err(Error::Xml { line: 3, .. })));
        let twice =
            "<REQ-IF>\n<SPEC-OBJECT IDENTIFIER='a'/>\n<SPEC-OBJECT IDENTIFIER='a'/></REQ-IF>";
        let id = "a".to_owned();
        assert_eq!(read(twice), Err(Error::Twice { id, first: 2, line: 3 }));
    }
}
