//! Reads `bessemer.toml`. Unknown keys and values that mean nothing are reported at their line and column.

use bessemer_backend::kernels::{Mode, replace};
use bessemer_codegen::compile::Options;
use bessemer_frontend::diagnostic::Diagnostic;
use serde_json::Value;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

use crate::inputs;
use crate::keys::{KEYS, Key, Kind};
use crate::outputs;
use crate::settings::{Limit, Settings};

/// The name of the file.
pub const NAME: &str = "bessemer.toml";

/// Reads the settings in `text`; diagnostics call the file `name`.
///
/// # Errors
/// A diagnostic for each mistake in the file.
pub fn read(name: &str, text: &str) -> Result<Settings, Vec<Diagnostic>> {
    let mut reader = Reader { name, text, settings: Settings::default(), wrong: Vec::new() };
    match DeTable::parse(text) {
        Ok(table) => {
            reader.table(table.get_ref(), "");
            reader.together(table.get_ref());
        }
        Err(error) => {
            let at = error.span().map_or(text.len(), |span| span.start);
            reader.tell(at, error.message().replace('\n', ", "), "write TOML: `key = value`");
        }
    }
    reader.wrong.sort_by_key(|it| (it.line, it.column));
    if !reader.wrong.is_empty() {
        return Err(reader.wrong);
    }
    // Two packages with prefixes of their own share nothing.
    let options = &mut reader.settings.options;
    let stem = options.prefix.trim_end_matches('_');
    if options.status == Options::default().status && !stem.is_empty() {
        options.status = stem.to_owned();
    }
    Ok(reader.settings)
}

struct Reader<'a> {
    name: &'a str,
    text: &'a str,
    settings: Settings,
    wrong: Vec<Diagnostic>,
}

impl Reader<'_> {
    fn table(&mut self, table: &DeTable<'_>, section: &str) {
        for (key, value) in table {
            let name = format!("{section}{}", key.get_ref());
            let within = format!("{name}.");
            let known = KEYS.iter().find(|it| it.name == name);
            match (known, value.get_ref()) {
                (Some(known), _) => self.value(known, value),
                (None, found) if KEYS.iter().any(|it| it.name.starts_with(&within)) => {
                    match found.as_table() {
                        Some(inner) => self.table(inner, &within),
                        None => self.tell(
                            value.span().start,
                            format!("`{name}` is a section"),
                            &format!("begin it with `[{name}]`, its keys below"),
                        ),
                    }
                }
                _ => {
                    let nearest = nearest(&name, KEYS.iter().map(|it| it.name));
                    let help = match nearest {
                        Some(nearest) => format!("write `{nearest}`"),
                        None => {
                            let all: Vec<&str> = KEYS.iter().map(|it| it.name).collect();
                            format!("choose from {}", all.join(", "))
                        }
                    };
                    self.tell(key.span().start, format!("there is no key `{name}`"), &help);
                }
            }
        }
    }

    /// Checks the keys that require others.
    fn together(&mut self, table: &DeTable<'_>) {
        let Options { pragmas, self_test, kernels, .. } = &self.settings.options;
        let (is_tested, is_plain) = (*self_test, kernels.mode == Mode::Plain);
        let Some((key, _)) =
            table.iter().find(|(key, _)| !pragmas && key.get_ref().as_ref() == "pragmas")
        else {
            return;
        };
        let at = key.span().start;
        if !is_tested {
            self.tell(
                at,
                "without pragmas, only the self test shows a wrong flag".to_owned(),
                "add `self_test = true`, and call it once on the target",
            );
        }
        if !is_plain {
            self.tell(
                at,
                "kernels with vectors need their pragmas".to_owned(),
                "write `mode = \"plain\"` below `[kernels]`",
            );
        }
    }

    fn value(&mut self, key: &Key, value: &Spanned<DeValue<'_>>) {
        let at = value.span().start;
        match (&key.kind, value.get_ref()) {
            (Kind::Text(form, set), DeValue::String(text)) if form.fits(text) => {
                set(&mut self.settings, text.to_string());
            }
            (Kind::Text(form, _), _) => self.unfit(key, at, form.expected()),
            (Kind::Choice(words, set), found) => {
                let found = found.as_str().unwrap_or_default();
                match words.iter().position(|word| *word == found) {
                    Some(which) => set(&mut self.settings, which),
                    None => {
                        let quoted: Vec<String> =
                            words.iter().map(|word| format!("\"{word}\"")).collect();
                        self.unfit(key, at, &quoted.join(" or "));
                    }
                }
            }
            (Kind::Flag(set), DeValue::Boolean(flag)) => set(&mut self.settings, *flag),
            (Kind::Flag(_), _) => self.unfit(key, at, "true or false"),
            (Kind::Number(largest, set), found) => {
                let number = found
                    .as_integer()
                    .and_then(|it| u32::from_str_radix(it.as_str(), it.radix()).ok())
                    .filter(|it| it <= largest);
                match number {
                    Some(most) => {
                        let (line, column) = self.place(at);
                        set(&mut self.settings, Limit { most, line, column });
                    }
                    None => self.unfit(key, at, &format!("a whole number from 0 to {largest}")),
                }
            }
            (Kind::Replacements, found) => self.replacements(found, at),
            (Kind::Inputs, found) => {
                let read = inputs::inputs(found, at, &|at| self.place(at).0);
                match read {
                    Ok(read) => self.settings.inputs = read,
                    Err(wrong) => self.all_wrong(wrong),
                }
            }
            (Kind::Outputs, found) => {
                let read = outputs::outputs(found, at, &|at| self.place(at).0);
                match read {
                    Ok(read) => self.settings.outputs = read,
                    Err(wrong) => self.all_wrong(wrong),
                }
            }
            (Kind::Periods, found) => {
                let read = inputs::periods(found, at, &|at| self.place(at).0);
                match read {
                    Ok(read) => self.settings.periods = read,
                    Err(wrong) => self.all_wrong(wrong),
                }
            }
        }
    }

    /// Reads each entry in the compiler's form, so that an error can be reported at the entry's field.
    fn replacements(&mut self, found: &DeValue<'_>, at: usize) {
        let Some(entries) = found.as_array() else {
            return self.tell(
                at,
                "`replacements` takes a list of tables".to_owned(),
                "begin each with `[[replacements]]`",
            );
        };
        for entry in entries {
            let text = Value::Array(vec![json(entry.get_ref())]).to_string();
            match replace::parse(&text) {
                Ok(read) => self.settings.options.replacements.extend(read),
                Err(replace::Error::Field { field, expected, .. }) => {
                    let table = entry.get_ref().as_table().into_iter().flatten();
                    let mut fields = table.filter(|(key, _)| *key.get_ref() == field.as_str());
                    let at = fields.next().map_or(entry.span().start, |(key, _)| key.span().start);
                    self.tell(
                        at,
                        format!("`{field}` of a replacement takes {expected}"),
                        "docs/kernels.md has an example",
                    );
                }
                Err(other) => {
                    self.tell(
                        entry.span().start,
                        other.to_string(),
                        "docs/kernels.md has an example",
                    );
                }
            }
        }
    }

    fn all_wrong(&mut self, wrong: Vec<inputs::Wrong>) {
        for inputs::Wrong { at, message, help } in wrong {
            self.tell(at, message, &help);
        }
    }

    fn unfit(&mut self, key: &Key, at: usize, expected: &str) {
        self.tell(at, format!("`{}` takes {expected}", key.name), key.says);
    }

    fn tell(&mut self, at: usize, message: String, help: &str) {
        let (line, column) = self.place(at);
        self.wrong.push(Diagnostic {
            file: self.name.to_owned(),
            line,
            column,
            message,
            help: help.to_owned(),
            ..Diagnostic::default()
        });
    }

    /// Line and column, from 1, of a place in the text.
    fn place(&self, at: usize) -> (u32, u32) {
        let before = self.text.get(..at).unwrap_or(self.text);
        let line = before.matches('\n').count() + 1;
        let column = before.rsplit('\n').next().unwrap_or_default().chars().count() + 1;
        (line as u32, column as u32)
    }
}

fn json(value: &DeValue<'_>) -> Value {
    match value {
        DeValue::String(text) => Value::from(text.as_ref()),
        DeValue::Boolean(flag) => Value::from(*flag),
        DeValue::Integer(it) => {
            i64::from_str_radix(it.as_str(), it.radix()).map_or(Value::Null, Value::from)
        }
        DeValue::Array(list) => list.iter().map(|it| json(it.get_ref())).collect(),
        DeValue::Table(table) => {
            let fields =
                table.iter().map(|(key, it)| (key.get_ref().to_string(), json(it.get_ref())));
            Value::Object(fields.collect())
        }
        DeValue::Float(_) | DeValue::Datetime(_) => Value::Null,
    }
}

/// Returns the most similar name, if one is similar enough; also compares the last part, in case the section is
/// missing.
fn nearest<'k>(written: &str, known: impl Iterator<Item = &'k str>) -> Option<&'k str> {
    /// Least similarity for a suggestion, from 0 to 1; a less similar one would mislead.
    const NEAR: f64 = 0.8;
    let last = |name: &str| name.rsplit('.').next().unwrap_or_default().to_owned();
    // A limit is a most by itself: `limits.stack_bytes`, where others write `max_stack`.
    let written = &*written.replacen("max_", "", 1);
    let likeness = |name: &str| {
        let whole = strsim::jaro_winkler(written, name);
        whole.max(strsim::jaro_winkler(&last(written), &last(name)) - 0.05)
    };
    let all = known.map(|name| (likeness(name), name));
    let (likeness, name) = all.max_by(|(one, _), (other, _)| one.total_cmp(other))?;
    (likeness >= NEAR).then_some(name)
}

#[cfg(test)]
mod tests {
    use super::*;
    use bessemer_backend::kernels::{Processors, Tuning};
    use bessemer_codegen::compile::{Layout, Math, Standard};

    #[test]
    fn what_is_there_is_set() {
        let text = "prefix = \"acme_\"\nlayout = \"rows\"\n[kernels]\ncode_bytes = 0x400\n[limits]\nstack_bytes = 512\n\
            [[replacements]]\nroutine = \"product\"\nlibrary = \"CBLAS\"\ninclude = \"<cblas.h>\"\nbody = [\"x();\"]\n";
        let settings = read(NAME, text).expect("it is sound");
        assert_eq!(settings.options.prefix, "acme_");
        assert_eq!(settings.options.status, "acme");
        assert_eq!(settings.options.layout, Layout::Rows);
        assert_eq!(settings.options.kernels.code_bytes, 1024);
        assert_eq!(settings.limits.stack_bytes, Some(Limit { most: 512, line: 6, column: 15 }));
        assert_eq!(settings.options.replacements.len(), 1);
        assert_eq!(read(NAME, "").expect("empty"), Settings::default());
    }

    /// Lists all fields of the options, so that a new field must get a key here.
    #[test]
    fn every_option_has_a_key() {
        let text = "prefix = \"acme_\"\nheaders = \"acme\"\nstatus = \"motor\"\nhook = \"stop\"\nc_standard = \"gnu11\"\n\
            math = \"target\"\nlayout = \"array\"\nself_test = true\nkeep_checks = true\npragmas = false\nascii = true\ntrace = \"comments\"\ncontracts = \"acsl\"\n\
            [kernels]\nmode = \"plain\"\nprocessors = \"cortex-m\"\ncode_bytes = 9\nthreads = 2\n\
            [[replacements]]\nroutine = \"product\"\nlibrary = \"CBLAS\"\ninclude = \"<cblas.h>\"\nbody = [\"x();\"]\n";
        let set = read(NAME, text).expect("it is sound").options;
        let Options {
            prefix,
            headers,
            status,
            hook,
            // It is `license`, or the package's own.
            license: _,
            standard,
            replacements,
            kernels: Tuning { code_bytes, mode, processors },
            threads,
            math,
            layout,
            self_test,
            pragmas,
            ascii,
            trace_comments,
            contracts,
            keep_checks,
        } = set;
        assert_eq!(
            (prefix.as_str(), headers.as_str(), status.as_str()),
            ("acme_", "acme", "motor")
        );
        assert_eq!(
            (hook.as_deref(), standard, replacements.len()),
            (Some("stop"), Standard::Gnu11, 1)
        );
        assert_eq!(
            (code_bytes, mode, processors, threads),
            (9, Mode::Plain, Processors::CortexM, 2)
        );
        assert_eq!(
            (math, layout, self_test, keep_checks, pragmas, ascii, trace_comments, contracts),
            (Math::Target, Layout::Array, true, true, false, true, true, true)
        );
    }

    #[test]
    fn each_standard_is_the_one_of_its_word() {
        for (word, flag) in
            [("c99", "-std=c99"), ("c17", "-std=c17"), ("c23", "-std=c2x"), ("gnu23", "-std=gnu2x")]
        {
            let set = read(NAME, &format!("c_standard = {word:?}")).expect("it is sound");
            assert_eq!(set.options.standard.flag(), flag);
        }
    }

    #[test]
    fn everything_that_is_wrong_is_told_at_once() {
        let wrong = read(NAME, "prefx = 1\nmath = 1\n").expect_err("two things are wrong");
        assert_eq!(wrong.len(), 2);
    }
}
