//! Finds the crate that a name comes from, by the author's files and cargo's messages: nobody can mark what another crate
//! has.
//!
//! Must not know: what the DSL has in place of it ([`remedies`](super::remedies)).

use std::collections::BTreeSet;

use bessemer_frontend::source::Sources;
use serde_json::Value;

use super::rustc::Mark;

/// Crates of others that the build used, and the author's files.
pub struct Origins<'a> {
    foreign: BTreeSet<String>,
    sources: &'a Sources,
}

impl<'a> Origins<'a> {
    /// Reads which crates come from a registry or a repository.
    pub fn of(messages: &[Value], sources: &'a Sources) -> Origins<'a> {
        let artifacts = messages.iter().filter(|it| it["reason"] == "compiler-artifact");
        let is_foreign = |it: &&Value| {
            let id = it["package_id"].as_str().unwrap_or_default();
            id.starts_with("registry+") || id.starts_with("git+") || id.starts_with("sparse+")
        };
        let name = |it: &Value| Some(it["target"]["name"].as_str()?.replace('-', "_"));
        Origins { foreign: artifacts.filter(is_foreign).filter_map(name).collect(), sources }
    }

    /// Returns the crate of others that has `name` at a place: by its path there, or by an import of the file.
    pub fn crate_of(&self, name: &str, mark: &Mark<'_>) -> Option<String> {
        let before = mark.before();
        let path = before.rsplit(|it: char| !it.is_alphanumeric() && it != '_' && it != ':').next();
        let first = path.unwrap_or_default().trim_start_matches("::").split("::").next();
        let first = first.filter(|it| !it.is_empty()).unwrap_or(name);
        if self.foreign.contains(first) {
            return Some(first.to_owned());
        }
        self.imported(first, mark.file)
    }

    /// Returns the crate of others from which a file imports a name.
    pub fn imported(&self, name: &str, file: &str) -> Option<String> {
        let text = self.sources.text(file);
        let code: Vec<&str> =
            text.lines().map(|line| line.split("//").next().unwrap_or_default()).collect();
        let code = code.join("\n");
        let uses = code.split(';').filter_map(|stmt| {
            let (before, tree) = stmt.rsplit_once("use ")?;
            before
                .ends_with(|it: char| it.is_whitespace() || it == ')')
                .then_some(tree)
                .or_else(|| before.is_empty().then_some(tree))
        });
        let is_word = |it: char| it.is_alphanumeric() || it == '_';
        for tree in uses {
            let tree = tree.trim().trim_start_matches("::");
            let home = tree.split(|it: char| !is_word(it)).next().unwrap_or_default();
            let mut names = tree.split(|it: char| !is_word(it));
            if self.foreign.contains(home) && names.any(|it| it == name) {
                return Some(home.to_owned());
            }
        }
        None
    }

    /// Returns the crate of others that has a type, by rustc's path to it or by its import.
    pub fn home_of_type(&self, ty: &str, mark: &Mark<'_>) -> Option<String> {
        let bare = ty.trim_start_matches("&mut ").trim_start_matches('&');
        let path = bare.split(['<', '(', '[']).next().unwrap_or_default();
        let (first, last) = (path.split("::").next()?, path.rsplit("::").next()?);
        match path.contains("::") && self.foreign.contains(first) {
            true => Some(first.to_owned()),
            false => self.imported(last, mark.file),
        }
    }

    /// Returns the crate of others that has a trait by which the type parameter `name` is bound, above a place.
    pub fn crate_of_bound(&self, name: &str, mark: &Mark<'_>) -> Option<String> {
        let is_word = |it: char| it.is_alphanumeric() || it == '_' || it == ':';
        for line in (1..=mark.start.0).rev() {
            let text = self.sources.line(mark.file, line)?;
            let Some((_, bounds)) = text.split_once(&format!("{name}: ")) else { continue };
            let words = bounds.split(|it: char| !is_word(it)).filter(|it| !it.is_empty());
            let mut homes = words.filter_map(|word| {
                let first = word.split("::").next().unwrap_or_default();
                match self.foreign.contains(first) {
                    true => Some(first.to_owned()),
                    false => self.imported(first, mark.file),
                }
            });
            if let Some(home) = homes.next() {
                return Some(home);
            }
        }
        None
    }
}
