//! Lists of requirements: CSV and ReqIF, read and written.
//!
//! Invariant: a list that was written is read with the same content.

use quick_xml::events::Event;

use crate::separated::{self, Rows};

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
    /// The file is no ReqIF.
    #[error("byte {at}: {why}")]
    Xml {
        /// Place of the mistake.
        at: u64,
        /// The mistake.
        why: String,
    },
    /// A requirement has no identifier.
    #[error("requirement {at} has no identifier")]
    Unnamed {
        /// Number of the requirement, from 1.
        at: usize,
    },
    /// Two requirements have one identifier.
    #[error("`{id}` is there twice")]
    Twice {
        /// The identifier.
        id: String,
    },
}

/// Reads a list; a text that begins as XML is ReqIF, another is CSV.
///
/// # Errors
/// See [`Error`].
pub fn read(text: &str) -> Result<Vec<Requirement>, Error> {
    let list = match separated::unmarked(text).trim_start().starts_with('<') {
        true => from_reqif(separated::unmarked(text))?,
        false => from_csv(text)?,
    };
    for (at, it) in list.iter().enumerate() {
        if it.id.is_empty() {
            return Err(Error::Unnamed { at: at + 1 });
        }
        if list[..at].iter().any(|other| other.id == it.id) {
            return Err(Error::Twice { id: it.id.clone() });
        }
    }
    Ok(list)
}

fn from_csv(text: &str) -> Result<Vec<Requirement>, Error> {
    let mut reader = separated::reader(text, Rows::Ragged);
    let wrong = |error: &csv::Error| Error::Csv {
        line: error.position().map_or(1, csv::Position::line),
        why: error.to_string(),
    };
    let head = reader.headers().map_err(|error| wrong(&error))?.clone();
    let column = |names: &[&str]| {
        head.iter().position(|it| names.iter().any(|name| it.eq_ignore_ascii_case(name)))
    };
    let id = column(&["id", "identifier", "requirement"]);
    let id = id.ok_or_else(|| Error::NoId { found: head.iter().collect::<Vec<_>>().join(", ") })?;
    let says = column(&["text", "title", "description", "name"]);
    let mut list = Vec::new();
    for record in reader.records() {
        let record = record.map_err(|error| wrong(&error))?;
        let cell = |at: Option<usize>| at.and_then(|at| record.get(at)).unwrap_or_default();
        list.push(Requirement { id: cell(Some(id)).to_owned(), text: cell(says).to_owned() });
    }
    Ok(list)
}

/// Reads the objects of a ReqIF file. The attribute whose name ends with `ForeignID` or `ID` is the identifier; of the
/// others, the one with the longest value is the text.
fn from_reqif(text: &str) -> Result<Vec<Requirement>, Error> {
    let mut reader = quick_xml::Reader::from_str(text);
    let mut list = Vec::new();
    let mut names: Vec<(String, String)> = Vec::new();
    let mut object: Option<(String, Vec<(String, String)>)> = None;
    let (mut value, mut reference, mut said) = (None::<String>, String::new(), String::new());
    let mut in_value = false;
    let mut in_reference = false;
    let mut root = false;
    loop {
        let at = reader.buffer_position();
        let wrong = |why: String| Error::Xml { at, why };
        let event = reader.read_event().map_err(|error| wrong(error.to_string()))?;
        let attribute = |of: &quick_xml::events::BytesStart<'_>, key: &str| {
            let found =
                of.attributes().flatten().find(|it| it.key.local_name().as_ref() == key.as_bytes());
            found.map(|it| {
                let raw = String::from_utf8_lossy(&it.value).into_owned();
                quick_xml::escape::unescape(&raw).map(|it| it.into_owned()).unwrap_or(raw)
            })
        };
        match &event {
            Event::Start(of) | Event::Empty(of) => {
                let name = String::from_utf8_lossy(of.local_name().as_ref()).into_owned();
                let empty = matches!(event, Event::Empty(_));
                match &*name {
                    "REQ-IF" => root = true,
                    "SPEC-OBJECT" if !empty => {
                        let id = attribute(of, "IDENTIFIER").unwrap_or_default();
                        object = Some((id, Vec::new()));
                    }
                    _ if name.starts_with("ATTRIBUTE-DEFINITION-") && !name.ends_with("-REF") => {
                        if let (Some(id), Some(long)) =
                            (attribute(of, "IDENTIFIER"), attribute(of, "LONG-NAME"))
                        {
                            names.push((id, long));
                        }
                    }
                    _ if name.starts_with("ATTRIBUTE-VALUE-") => {
                        value = Some(attribute(of, "THE-VALUE").unwrap_or_default());
                        reference.clear();
                        said.clear();
                    }
                    "THE-VALUE" => in_value = true,
                    _ if name.ends_with("-REF") => in_reference = !empty,
                    _ => {}
                }
            }
            Event::Text(of) => {
                let of = of.decode().map_err(|error| wrong(error.to_string()))?;
                match (in_reference, in_value) {
                    (true, _) => reference += of.trim(),
                    (_, true) => said += &of,
                    _ => {}
                }
            }
            Event::GeneralRef(of) if in_value => {
                let of = of.decode().map_err(|error| wrong(error.to_string()))?;
                let text =
                    quick_xml::escape::unescape(&format!("&{of};")).map(|it| it.into_owned());
                said += &text.unwrap_or_default();
            }
            Event::End(of) => {
                let name = String::from_utf8_lossy(of.local_name().as_ref()).into_owned();
                match &*name {
                    "THE-VALUE" => in_value = false,
                    _ if name.ends_with("-REF") => in_reference = false,
                    _ if name.starts_with("ATTRIBUTE-VALUE-") => {
                        let own = value.take().unwrap_or_default();
                        let words: Vec<&str> = said.split_whitespace().collect();
                        let own = if own.is_empty() { words.join(" ") } else { own };
                        if let Some((_, values)) = &mut object {
                            values.push((reference.clone(), own));
                        }
                    }
                    "SPEC-OBJECT" => {
                        if let Some((id, values)) = object.take() {
                            list.push(requirement(&id, &values, &names));
                        }
                    }
                    _ => {}
                }
            }
            Event::Eof if !root => {
                return Err(wrong("the file has no element `REQ-IF`".to_owned()));
            }
            Event::Eof => return Ok(list),
            _ => {}
        }
    }
}

/// Returns the name of an attribute, or the reference itself.
fn long<'n>(names: &'n [(String, String)], reference: &'n str) -> &'n str {
    let found = names.iter().find(|(id, _)| id == reference);
    found.map_or(reference, |(_, long)| long)
}

fn requirement(id: &str, values: &[(String, String)], names: &[(String, String)]) -> Requirement {
    let is_id = |name: &str| {
        let name = name.rsplit('.').next().unwrap_or(name).to_ascii_lowercase();
        name.ends_with("foreignid") || name == "id" || name == "identifier"
    };
    let own =
        values.iter().find(|(reference, value)| is_id(long(names, reference)) && !value.is_empty());
    let others = values.iter().filter(|(reference, _)| !is_id(long(names, reference)));
    let text = others.max_by_key(|(_, value)| value.len());
    Requirement {
        id: own.map_or(id, |(_, value)| value).trim().to_owned(),
        text: text.map_or("", |(_, value)| value).to_owned(),
    }
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

/// Returns a list as ReqIF 1.2. Its date is the epoch, so that the file is reproducible.
pub fn to_reqif(package: &str, rows: &[[String; 6]]) -> String {
    const TIME: &str = "1970-01-01T00:00:00Z";
    let escaped = |text: &str| quick_xml::escape::escape(text).into_owned();
    let package = escaped(package);
    let columns = ["ForeignID", "Text", "Rust", "C", "Tests", "Result"];
    let mut xml = format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n\
<REQ-IF xmlns=\"http://www.omg.org/spec/ReqIF/20110401/reqif.xsd\">\n  <THE-HEADER>\n    \
<REQ-IF-HEADER IDENTIFIER=\"header\">\n      <CREATION-TIME>{TIME}</CREATION-TIME>\n      \
<REQ-IF-TOOL-ID>bessemer</REQ-IF-TOOL-ID>\n      <REQ-IF-VERSION>1.0</REQ-IF-VERSION>\n      \
<SOURCE-TOOL-ID>bessemer</SOURCE-TOOL-ID>\n      <TITLE>{package}</TITLE>\n    </REQ-IF-HEADER>\n  \
</THE-HEADER>\n  <CORE-CONTENT>\n    <REQ-IF-CONTENT>\n      <DATATYPES>\n        \
<DATATYPE-DEFINITION-STRING IDENTIFIER=\"string\" LAST-CHANGE=\"{TIME}\" LONG-NAME=\"String\" MAX-LENGTH=\"65535\"/>\n      \
</DATATYPES>\n      <SPEC-TYPES>\n        <SPEC-OBJECT-TYPE IDENTIFIER=\"requirement\" LAST-CHANGE=\"{TIME}\" LONG-NAME=\"Requirement\">\n          \
<SPEC-ATTRIBUTES>\n"
    );
    for name in columns {
        xml += &format!(
            "            <ATTRIBUTE-DEFINITION-STRING IDENTIFIER=\"column-{name}\" LAST-CHANGE=\"{TIME}\" LONG-NAME=\"ReqIF.{name}\">\n              \
<TYPE><DATATYPE-DEFINITION-STRING-REF>string</DATATYPE-DEFINITION-STRING-REF></TYPE>\n            </ATTRIBUTE-DEFINITION-STRING>\n"
        );
    }
    xml += &format!(
        "          </SPEC-ATTRIBUTES>\n        </SPEC-OBJECT-TYPE>\n        \
<SPECIFICATION-TYPE IDENTIFIER=\"specification\" LAST-CHANGE=\"{TIME}\" LONG-NAME=\"Specification\"/>\n      \
</SPEC-TYPES>\n      <SPEC-OBJECTS>\n"
    );
    for (at, row) in rows.iter().enumerate() {
        xml += &format!(
            "        <SPEC-OBJECT IDENTIFIER=\"object-{}\" LAST-CHANGE=\"{TIME}\">\n          \
<TYPE><SPEC-OBJECT-TYPE-REF>requirement</SPEC-OBJECT-TYPE-REF></TYPE>\n          <VALUES>\n",
            at + 1
        );
        for (name, value) in columns.iter().zip(row) {
            xml += &format!(
                "            <ATTRIBUTE-VALUE-STRING THE-VALUE=\"{}\"><DEFINITION>\
<ATTRIBUTE-DEFINITION-STRING-REF>column-{name}</ATTRIBUTE-DEFINITION-STRING-REF></DEFINITION></ATTRIBUTE-VALUE-STRING>\n",
                escaped(value)
            );
        }
        xml += "          </VALUES>\n        </SPEC-OBJECT>\n";
    }
    xml += &format!(
        "      </SPEC-OBJECTS>\n      <SPECIFICATIONS>\n        <SPECIFICATION IDENTIFIER=\"all\" LAST-CHANGE=\"{TIME}\" LONG-NAME=\"{package}\">\n          \
<TYPE><SPECIFICATION-TYPE-REF>specification</SPECIFICATION-TYPE-REF></TYPE>\n          <CHILDREN>\n"
    );
    for at in 1..=rows.len() {
        xml += &format!(
            "            <SPEC-HIERARCHY IDENTIFIER=\"place-{at}\" LAST-CHANGE=\"{TIME}\"><OBJECT><SPEC-OBJECT-REF>object-{at}</SPEC-OBJECT-REF></OBJECT></SPEC-HIERARCHY>\n"
        );
    }
    xml + "          </CHILDREN>\n        </SPECIFICATION>\n      </SPECIFICATIONS>\n    </REQ-IF-CONTENT>\n  </CORE-CONTENT>\n</REQ-IF>\n"
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rows() -> Vec<[String; 6]> {
        [
            [
                "HLR-1",
                "The speed, \"fast\" & <1 s>; or less",
                "Motor::step",
                "motor_step",
                "holds",
                "passed",
            ],
            ["HLR-2", "", "", "", "", ""],
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
        let xml = to_reqif("motor & more", &rows());
        let mut found = read(&xml).expect("it is ReqIF");
        // The longest value besides the identifier is the text.
        found[1].text.clear();
        assert_eq!(found, wanted());
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

    #[test]
    fn tables_of_other_tools_are_read() {
        let one = |id: &str, text: &str| Requirement { id: id.to_owned(), text: text.to_owned() };
        assert_eq!(read("\u{feff}Title;ID\nStops;A\n"), Ok(vec![one("A", "Stops")]));
        assert_eq!(read("id\nA\n"), Ok(vec![one("A", "")]));
    }

    #[test]
    fn mistakes_are_named() {
        assert!(matches!(read("name\nA\n"), Err(Error::NoId { .. })));
        assert!(matches!(read(""), Err(Error::NoId { .. })));
        assert_eq!(read("id\nA\nA\n"), Err(Error::Twice { id: "A".to_owned() }));
        assert_eq!(read("id,text\n,x\n"), Err(Error::Unnamed { at: 1 }));
        assert!(matches!(read("<a></b>"), Err(Error::Xml { .. })));
        assert!(matches!(read("<html></html>"), Err(Error::Xml { .. })));
    }
}
