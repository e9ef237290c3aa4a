//! The folder of the C with its maps.

use std::collections::BTreeMap;
use std::path::Path;

use super::error::Error;
use crate::scan::{self, Function};

/// A row of a map.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Row {
    /// Line of the C file, from 1.
    pub c_line: u32,
    /// The Rust file, from the workspace.
    pub rust_file: String,
    /// Line of the Rust file, from 1.
    pub rust_line: u32,
    /// Path of the Rust function, type or constant; empty for a type.
    pub function: String,
}

/// A C file with its map.
#[derive(Clone, Debug)]
pub struct File {
    /// Name in the folder.
    pub name: String,
    /// Text of the file.
    pub text: String,
    /// Rows of the map, in the order of the C.
    pub rows: Vec<Row>,
    /// Functions with bodies.
    pub functions: Vec<Function>,
}

/// The C files of a folder.
#[derive(Clone, Debug)]
pub struct Folder {
    /// Files by name.
    pub files: Vec<File>,
}

impl Folder {
    /// Reads a folder.
    ///
    /// # Errors
    /// [`Error::NoFolder`], [`Error::Map`], [`Error::Edited`] or [`Error::File`].
    pub fn read(path: &Path) -> Result<Folder, Error> {
        let mut texts = BTreeMap::new();
        let mut open = vec![(path.to_owned(), String::new())];
        while let Some((folder, before)) = open.pop() {
            let Ok(list) = std::fs::read_dir(&folder) else { continue };
            for entry in list {
                let entry = entry.map_err(|source| Error::File { path: folder.clone(), source })?;
                let name = format!("{before}{}", entry.file_name().to_string_lossy());
                if entry.path().is_dir() {
                    open.push((entry.path(), format!("{name}/")));
                } else if [".c", ".h", ".map"].iter().any(|end| name.ends_with(end)) {
                    let failed = |source| Error::File { path: entry.path(), source };
                    let bytes = std::fs::read(entry.path()).map_err(failed)?;
                    texts.insert(name, String::from_utf8_lossy(&bytes).into_owned());
                }
            }
        }
        let folder = Folder::of(&texts, path)?;
        match folder.files.iter().any(|file| !file.rows.is_empty()) {
            true => Ok(folder),
            false => Err(Error::NoFolder { path: path.to_owned() }),
        }
    }

    /// Builds a folder from texts by name; `path` is its place, for errors.
    ///
    /// # Errors
    /// [`Error::Map`] or [`Error::Edited`].
    pub fn of(texts: &BTreeMap<String, String>, path: &Path) -> Result<Folder, Error> {
        let mut files = Vec::new();
        for (name, text) in texts.iter().filter(|(name, _)| !name.ends_with(".map")) {
            let map = format!("{name}.map");
            let rows = match texts.get(&map) {
                Some(map_text) => {
                    rows(map_text).map_err(|line| Error::Map { path: path.join(&map), line })?
                }
                None => Vec::new(),
            };
            let last = text.lines().count() as u32;
            if let Some(row) = rows.iter().find(|row| row.c_line > last) {
                return Err(Error::Edited { file: name.clone(), line: row.c_line, last });
            }
            let functions = scan::functions(text);
            files.push(File { name: name.clone(), text: text.clone(), rows, functions });
        }
        Ok(Folder { files })
    }

    /// Returns the file that a user names by its path or the end of it.
    ///
    /// # Errors
    /// [`Error::NoFile`] or [`Error::Several`].
    pub fn file(&self, wanted: &str) -> Result<&File, Error> {
        let names: Vec<&str> = self.files.iter().map(|it| &*it.name).collect();
        match &matching(&names, wanted)[..] {
            [one] => Ok(&self.files[*one]),
            [] => {
                let like = like(names.iter().copied(), wanted);
                Err(Error::NoFile { name: wanted.to_owned(), like })
            }
            several => Err(Error::Several {
                name: wanted.to_owned(),
                known: several.iter().map(|at| names[*at].to_owned()).collect(),
            }),
        }
    }

    /// Returns the name in the maps of a Rust file that a user names by its path or the end of it.
    ///
    /// # Errors
    /// [`Error::NoRust`] or [`Error::Several`].
    pub fn rust_file(&self, wanted: &str) -> Result<String, Error> {
        let rows = self.files.iter().flat_map(|file| &file.rows);
        let mut names: Vec<&str> = rows.map(|row| &*row.rust_file).collect();
        names.sort_unstable();
        names.dedup();
        match &matching(&names, wanted)[..] {
            [one] => Ok(names[*one].to_owned()),
            [] => {
                let like = like(names.iter().copied(), wanted);
                Err(Error::NoRust { name: wanted.to_owned(), like })
            }
            several => Err(Error::Several {
                name: wanted.to_owned(),
                known: several.iter().map(|at| names[*at].to_owned()).collect(),
            }),
        }
    }

    /// Returns the C of a line of Rust: the file, first and last line of the statement, and its row.
    pub fn of_rust(&self, rust_file: &str, line: u32) -> Vec<(&File, u32, u32, &Row)> {
        let mut places: Vec<(&File, u32, u32, &Row)> = Vec::new();
        for file in &self.files {
            for row in &file.rows {
                if row.rust_file == rust_file && row.rust_line == line {
                    let (first, last) = file.extent(row.c_line);
                    let known = places
                        .iter()
                        .any(|(of, from, _, _)| of.name == file.name && *from == first);
                    if !known {
                        places.push((file, first, last, row));
                    }
                }
            }
        }
        places
    }

    /// Returns the line of a Rust file that has C and is nearest to `line`; the one before, if two are.
    pub fn nearest(&self, rust_file: &str, line: u32) -> Option<u32> {
        let rows = self.files.iter().flat_map(|file| &file.rows);
        let lines = rows.filter(|row| row.rust_file == rust_file).map(|row| row.rust_line);
        lines.min_by_key(|other| (other.abs_diff(line), *other))
    }
}

/// Returns the places of the names that a user's path may mean: the path itself, the longest common end, or the last part.
fn matching(names: &[&str], wanted: &str) -> Vec<usize> {
    let wanted = wanted.replace('\\', "/");
    let common = |name: &str| {
        let parts = name.rsplit('/').zip(wanted.rsplit('/'));
        parts.take_while(|(one, other)| one == other).count()
    };
    let most = names.iter().map(|name| common(name)).max().unwrap_or_default();
    if most == 0 {
        return Vec::new();
    }
    let found = (0..names.len()).filter(|at| common(names[*at]) == most);
    found.collect()
}

/// Returns the names whose last part begins as the wanted one does.
fn like<'n>(names: impl Iterator<Item = &'n str>, wanted: &str) -> Vec<String> {
    let last = wanted.rsplit('/').next().unwrap_or_default();
    let stem = last.split('.').next().unwrap_or_default();
    let begins = |name: &&str| {
        let name = name.rsplit('/').next().unwrap_or_default();
        !stem.is_empty()
            && (name.starts_with(stem) || stem.starts_with(name.split('.').next().unwrap_or(name)))
    };
    names.filter(begins).take(5).map(str::to_owned).collect()
}

/// Reads a map; the number of the first line that is wrong.
fn rows(text: &str) -> Result<Vec<Row>, usize> {
    let lines = text.lines().zip(1_usize..).filter(|(line, _)| !line.starts_with('#'));
    let mut rows =
        lines.map(|(line, number)| row(line).ok_or(number)).collect::<Result<Vec<_>, _>>()?;
    rows.sort_by_key(|row| row.c_line);
    Ok(rows)
}

fn row(line: &str) -> Option<Row> {
    let mut parts = line.split('\t');
    let c_line = parts.next()?.parse().ok()?;
    let (rust_file, rust_line) = parts.next()?.rsplit_once(':')?;
    let function = parts.next()?.to_owned();
    let rust_line = rust_line.parse().ok()?;
    Some(Row { c_line, rust_file: rust_file.to_owned(), rust_line, function })
}

impl File {
    /// Returns the lines of the statement that a line belongs to.
    pub fn extent(&self, line: u32) -> (u32, u32) {
        let within = |it: &&Function| it.line <= line && line <= it.last_line;
        let statements = self.functions.iter().find(within).map(|it| &it.statements);
        let holds = |first: u32, last: u32| first <= line && line <= last;
        let statement = statements.into_iter().flatten().rfind(|it| holds(it.line, it.last_line));
        statement.map_or((line, line), |it| (it.line, it.last_line))
    }

    /// Returns the statement of a line, and the row of its Rust.
    ///
    /// A line of a function without a row of its own has the row before it, within the function; so has a comment. A
    /// function of a file that has the rows of one function only is a part of that one.
    pub fn counterpart(&self, line: u32) -> Option<(u32, u32, &Row)> {
        let (first, last) = self.extent(line);
        let function = self.functions.iter().find(|it| it.line <= line && line <= it.last_line);
        if let Some(function) = function {
            let head = self.head(function);
            let rows = self.rows.iter().filter(|row| (head..=last).contains(&row.c_line));
            let before = rows.max_by_key(|row| row.c_line);
            let whole = || {
                let mut names: Vec<&str> = self.rows.iter().map(|row| &*row.function).collect();
                names.dedup();
                names.len() == 1
            };
            let row = before.or_else(|| self.rows.first().filter(|_| whole()))?;
            return Some((first, last, row));
        }
        // A prototype, a type or a constant: the row before it, unless an empty line is between them.
        let row = self.rows.iter().rev().find(|row| row.c_line <= line)?;
        let between = self.text.lines().skip(row.c_line as usize - 1);
        let between = between.take((line - row.c_line + 1) as usize);
        let separate = between.clone().any(|it| it.trim().is_empty())
            || self.functions.iter().any(|it| it.line >= row.c_line && it.last_line < line);
        (!separate).then_some((first, last, row))
    }

    /// Returns the first line of a function's head: its name may be on a later line.
    pub(crate) fn head(&self, function: &Function) -> u32 {
        let lines: Vec<&str> = self.text.lines().collect();
        let mut line = function.line;
        while line > 1 {
            let before = lines[line as usize - 2].trim();
            if before.is_empty()
                || before.ends_with([';', '}', '/', '{'])
                || before.starts_with('#')
            {
                break;
            }
            line -= 1;
        }
        line
    }

    /// Explains why a line has no Rust.
    pub fn why_none(&self, line: u32) -> &'static str {
        let text =
            self.text.lines().nth(line.saturating_sub(1) as usize).unwrap_or_default().trim();
        let in_function = self.functions.iter().any(|it| it.line <= line && line <= it.last_line);
        match text {
            "" => "an empty line",
            _ if text.starts_with('#') => {
                "a directive of the preprocessor, which the generator writes"
            }
            _ if text.starts_with(['/', '*']) => "a comment",
            _ if self.rows.is_empty() => {
                "a part of the generator's own C, the same for each package (docs/design/files-and-names.md)"
            }
            _ if in_function => "a helper of the generator, without a line of Rust",
            _ => "a declaration of the generator, without a line of Rust",
        }
    }
}
