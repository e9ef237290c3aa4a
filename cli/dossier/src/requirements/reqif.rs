//! Lists of requirements in ReqIF, as requirement tools export them and import them.
//!
//! Invariant: a list that was written is read with the same content. Must not know: what belongs to a requirement.

use quick_xml::events::{BytesStart, Event};

use super::table::{Error, Line, Requirement};

/// Names of the attribute that is the identifier, the best first. A prefix such as `ReqIF.` does not count.
const IDENTIFIERS: [&str; 4] = ["foreignid", "uid", "identifier", "id"];
/// Names of the attribute that is the text, the best first.
const TEXTS: [&str; 6] =
    ["text", "statement", "description", "object text", "requirement text", "content"];
/// Names of the attribute that is a short title, for objects without a text.
const TITLES: [&str; 4] = ["name", "title", "summary", "object heading"];
/// Name of the attribute that headings have.
const CHAPTER: &str = "chaptername";

/// Elements of XHTML that separate words.
const BLOCKS: [&str; 15] =
    ["p", "div", "br", "li", "ul", "ol", "td", "th", "tr", "table", "h1", "h2", "h3", "pre", "dd"];

/// An object with its values by the identifier of their attribute.
#[derive(Default)]
struct Object {
    id: String,
    line: u64,
    values: Vec<(String, String)>,
}

/// Position in the document, and what was read so far.
#[derive(Default)]
struct Reader {
    /// Names of the attributes by their identifier.
    names: Vec<(String, String)>,
    /// Objects that are complete.
    objects: Vec<Object>,
    /// Identifiers of objects, in the order of the specifications.
    order: Vec<String>,
    object: Option<Object>,
    value: Option<String>,
    /// Identifier of the attribute of the present value.
    definition: String,
    /// Text of the present element.
    said: String,
    in_definition: bool,
    in_value: bool,
    in_hierarchy: bool,
    is_reqif: bool,
    /// Number of open elements.
    depth: usize,
}

/// Reads the objects of a ReqIF file, in the order of its specifications. Headings are no requirements.
///
/// # Errors
/// Broken XML, and XML of another kind.
pub(super) fn read(text: &str) -> Result<Vec<(Requirement, Line)>, Error> {
    let line = |at: u64| {
        let before = &text.as_bytes()[..text.len().min(at as usize)];
        before.iter().filter(|byte| **byte == b'\n').count() as u64 + 1
    };
    let mut xml = quick_xml::Reader::from_str(text);
    let mut reader = Reader::default();
    loop {
        let at = xml.buffer_position();
        let event = xml.read_event().map_err(|error| Error::Xml {
            line: line(xml.error_position()),
            why: error.to_string(),
        })?;
        let wrong = |why: String| Error::Xml { line: line(at), why };
        match &event {
            Event::Start(of) => {
                reader.depth += 1;
                reader.begins(of, line(at));
            }
            Event::Empty(of) => {
                reader.begins(of, line(at));
                reader.ends(&name(of.local_name().as_ref()));
            }
            Event::End(of) => {
                reader.depth -= 1;
                reader.ends(&name(of.local_name().as_ref()));
            }
            Event::Text(of) => {
                reader.said += &of.decode().map_err(|error| wrong(error.to_string()))?;
            }
            Event::CData(of) => {
                reader.said += &of.decode().map_err(|error| wrong(error.to_string()))?;
            }
            Event::GeneralRef(of) => {
                let of = of.decode().map_err(|error| wrong(error.to_string()))?;
                let text =
                    quick_xml::escape::unescape(&format!("&{of};")).map(|it| it.into_owned());
                reader.said += &text.unwrap_or_default();
            }
            Event::Eof if reader.depth > 0 => {
                return Err(wrong("the file ends within an element".to_owned()));
            }
            Event::Eof if !reader.is_reqif => {
                return Err(wrong("the file has no element `REQ-IF`".to_owned()));
            }
            Event::Eof => return Ok(reader.requirements()),
            _ => {}
        }
    }
}

fn name(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}

/// Returns the value of an attribute of XML.
fn attribute(of: &BytesStart<'_>, key: &str) -> Option<String> {
    let found = of.attributes().flatten().find(|it| it.key.local_name().as_ref() == key.as_bytes());
    found.map(|it| {
        let raw = name(&it.value);
        quick_xml::escape::unescape(&raw).map(|it| it.into_owned()).unwrap_or(raw)
    })
}

impl Reader {
    fn begins(&mut self, of: &BytesStart<'_>, line: u64) {
        let element = name(of.local_name().as_ref());
        let own = |key| attribute(of, key);
        match &*element {
            "REQ-IF" => self.is_reqif = true,
            "SPEC-OBJECT" => {
                let id = own("IDENTIFIER").unwrap_or_default();
                self.object = Some(Object { id, line, values: Vec::new() });
            }
            "SPEC-HIERARCHY" => self.in_hierarchy = true,
            "DEFINITION" => {
                self.in_definition = true;
                self.definition.clear();
            }
            "THE-VALUE" => {
                self.in_value = true;
                self.said.clear();
            }
            _ if self.in_value => self.separate(&element),
            _ if element.ends_with("-REF") => self.said.clear(),
            _ if element.starts_with("ATTRIBUTE-DEFINITION-") => {
                self.names.extend(own("IDENTIFIER").zip(own("LONG-NAME")));
            }
            _ if element.starts_with("ATTRIBUTE-VALUE-") => {
                self.value = Some(own("THE-VALUE").unwrap_or_default());
                self.definition.clear();
            }
            _ => {}
        }
    }

    fn ends(&mut self, element: &str) {
        match element {
            "THE-VALUE" => {
                self.in_value = false;
                let words: Vec<&str> = self.said.split_whitespace().collect();
                self.value = Some(words.join(" "));
            }
            _ if self.in_value => self.separate(element),
            "SPEC-OBJECT" => self.objects.extend(self.object.take()),
            "SPEC-OBJECT-REF" if self.in_hierarchy => self.order.push(self.said.trim().to_owned()),
            "SPEC-HIERARCHY" => self.in_hierarchy = false,
            "DEFINITION" => self.in_definition = false,
            _ if element.ends_with("-REF") && self.in_definition => {
                self.definition = self.said.trim().to_owned();
            }
            _ if element.starts_with("ATTRIBUTE-VALUE-") => {
                let value = self.value.take().unwrap_or_default();
                if let Some(object) = &mut self.object {
                    object.values.push((std::mem::take(&mut self.definition), value));
                }
            }
            _ => {}
        }
    }

    fn separate(&mut self, element: &str) {
        if BLOCKS.contains(&element) {
            self.said.push(' ');
        }
    }

    fn requirements(mut self) -> Vec<(Requirement, Line)> {
        let place = |object: &Object| {
            self.order.iter().position(|id| *id == object.id).unwrap_or(usize::MAX)
        };
        self.objects.sort_by_key(place);
        self.objects.iter().filter_map(|object| self.requirement(object)).collect()
    }

    /// Returns the requirement of an object; none for a heading.
    fn requirement(&self, object: &Object) -> Option<(Requirement, Line)> {
        let named = |id: &str| {
            let found = self.names.iter().find(|(own, _)| own == id);
            let long = found.map_or(id, |(_, long)| long);
            long.strip_prefix("ReqIF.").unwrap_or(long).to_ascii_lowercase()
        };
        let values: Vec<(String, &str)> =
            object.values.iter().map(|(id, value)| (named(id), value.trim())).collect();
        let best = |wanted: &[&str]| {
            let of = |name: &&str| values.iter().find(|it| it.0 == *name && !it.1.is_empty());
            wanted.iter().find_map(of).map(|it| it.1)
        };
        let text = best(&TEXTS);
        if text.is_none() && best(&[CHAPTER]).is_some() {
            return None;
        }
        let longest = || {
            if values.iter().any(|it| TEXTS.contains(&&*it.0)) {
                return None;
            }
            let others = values.iter().filter(|it| !IDENTIFIERS.contains(&&*it.0));
            others.map(|it| it.1).max_by_key(|it| it.len())
        };
        let text = text.or_else(|| best(&TITLES)).or_else(longest).unwrap_or_default();
        let id = best(&IDENTIFIERS).unwrap_or_else(|| object.id.trim());
        let requirement = Requirement { id: id.to_owned(), text: text.to_owned() };
        Some((requirement, object.line))
    }
}

/// Returns a text as the value of an attribute: a parser would turn a line's end into a blank, and refuse other controls.
fn escaped(text: &str) -> String {
    let kept: String =
        text.chars().filter(|it| !it.is_control() || matches!(it, '\n' | '\t')).collect();
    quick_xml::escape::escape(&*kept).replace('\n', "&#10;").replace('\t', "&#9;")
}

/// Returns a list as ReqIF 1.2. Its date is the epoch, so that the file is reproducible.
pub fn written(package: &str, rows: &[[String; 6]]) -> String {
    const TIME: &str = "1970-01-01T00:00:00Z";
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
