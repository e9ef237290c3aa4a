//! Translates rustc's errors of a generation build to the author's terms: each error once, at the author's line.
//!
//! A generation build compiles more than the author's code: a witness copy of each function, and the builders of the
//! tree. An error in the model repeats there, with names that no author has seen. Each message of rustc is parsed
//! ([`rustc`]), reworded if it is about the DSL ([`wording`], [`unsupported`]), or gets a suitable remedy ([`hints`], [`habits`], [`declared`]), with types as
//! authors write them ([`types`]). It is dropped if another message reports its cause ([`causes`]). An unsupported
//! type is reported where its author names it ([`place`]).
//!
//! Must not know: how cargo is called.

mod causes;
mod declared;
mod foreign;
mod habits;
mod hints;
mod origins;
mod place;
mod remedies;
mod rustc;
mod types;
mod unsupported;
mod wording;

use serde_json::Value;

use bessemer_frontend::diagnostic::{Diagnostic, Level, Place};
use bessemer_frontend::source::Sources;
use origins::Origins;
use rustc::Message;
use wording::Words;

/// Returns the diagnostics for rustc's messages, which cargo passes on.
pub fn reported(messages: &[Value], sources: &Sources) -> Vec<Diagnostic> {
    let all: Vec<Message<'_>> = messages.iter().filter_map(Message::of).collect();
    let origins = Origins::of(messages, sources);
    let words = |message| {
        let foreign = foreign::of(message, &origins);
        foreign.or_else(|| unsupported::of(message, sources)).or_else(|| wording::of(message))
    };
    let worded = all.iter().map(|message| (message, words(message))).collect();
    let reported = causes::once(worded, sources);
    reported.into_iter().map(|(message, words)| diagnostic(message, words, sources)).collect()
}

fn diagnostic(message: &Message<'_>, words: Option<Words>, sources: &Sources) -> Diagnostic {
    let level = if message.is_error { Level::Error } else { Level::Warning };
    let mark = message.mark();
    let (line, column) = mark.map_or((0, 0), |mark| mark.start);
    let place = Diagnostic {
        level,
        file: mark.map_or("", |mark| mark.file).to_owned(),
        line,
        column,
        end: mark.map(|mark| mark.end),
        ..Diagnostic::default()
    };
    if let Some(words) = words {
        let reported = Diagnostic { message: words.title, help: words.help, ..place };
        return match (words.of_type, mark) {
            (Some(name), Some(mark)) => place::of_type(reported, &name, mark, sources),
            _ => reported,
        };
    }
    let (mut help, mut declared) = (hints::of(message), None);
    if let Some(of) = declared::of(message, sources) {
        (help, declared) = (Some(of.help), of.at);
    }
    let is_readable = types::shown(message.title) == message.title && !message.shows_internals();
    if help.is_none() && is_readable {
        let rustc = Some(Box::new(message.value.clone()));
        return Diagnostic { message: message.title.to_owned(), rustc, ..place };
    }
    let own = message.marks.iter().filter(|it| !it.is_primary && it.is_short_in(&place.file));
    let also = own.map(|it| Place {
        start: it.start,
        end: it.end,
        label: types::shown(it.label),
        ..Place::default()
    });
    Diagnostic {
        // The name of a lint is no code.
        code: Some(message.code).filter(|it| it.starts_with('E')).unwrap_or_default().to_owned(),
        message: types::shown(message.title),
        // A label that recommends a `Vec` is dropped: a model has no heap.
        label: mark
            .map(|it| types::shown(it.label))
            .filter(|it| !it.contains("`Vec<"))
            .unwrap_or_default(),
        also: also.chain(declared).collect(),
        help: help.or_else(|| message.own_help()).unwrap_or_default(),
        notes: message.own_notes(),
        ..place
    }
}
