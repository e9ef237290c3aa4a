//! The server of the page: static files, and a WebSocket for everything else.
//!
//! * A GET never commands anything. A page with the token may request the right to command, which one client has at a
//!   time; the others only watch. Stopping the motors needs only the token.
//! * A WebSocket is opened only for pages of this server: `Origin` and `Host` are checked.
//! * A recording needs the token, and is read piece by piece.
//! * The link of a campaign's seed is for a person who opens it: no page can embed it. It flies in simulation, and only a server that
//!   shows recordings has such links.
//! * The numbers of connections and pages are limited; further ones are rejected.
//! * A client that reads slowly misses frames; nothing waits for it. Commands that arrive faster than the testbed
//!   takes them are rejected.
//!
//! Knows messages, but not their effects.

use crate::command::{Command, Seat};
use crate::events::Event;
use crate::limited::Limited;
use crate::messages::{Ask, Flight, Saved, Tell};
use crate::page;
use crate::seeds::Seed;
use axum::Router;
use axum::body::Body;
use axum::extract::ws::{Message, Utf8Bytes, WebSocket, WebSocketUpgrade};
use axum::extract::{Path, State};
use axum::http::{HeaderMap, StatusCode, Uri, header};
use axum::response::{IntoResponse, Redirect, Response};
use axum::routing::get;
use serde_json::Value;
use std::collections::VecDeque;
use std::net::SocketAddr;
use std::path::{Path as FilePath, PathBuf};
use std::sync::atomic::{AtomicBool, AtomicU64, AtomicUsize, Ordering};
use std::sync::mpsc::{Receiver, SyncSender, TrySendError, sync_channel};
use std::sync::{Arc, Mutex, OnceLock};
use tokio::net::TcpListener;
use tokio::sync::broadcast::{self, error::RecvError};
use tokio_util::io::ReaderStream;

/// Messages that a slow page may be behind: two seconds of frames.
const QUEUE_LENGTH: usize = 128;

/// The most connections at once: half of the files that a process may open on most systems.
const MOST_CONNECTIONS: usize = 512;

/// The most pages among them: the others are for files.
const MOST_PAGES: usize = 256;

/// The most recordings that are listed.
const MOST_RECORDINGS: usize = 20;

/// Events that a page receives when it opens.
const MOST_EVENTS: usize = 200;

/// The most seeds that wait for their flights.
const MOST_SEEDS: usize = 4;

/// The longest message that a page may send, bytes.
const LONGEST: usize = 16 * 1024;

/// State shared by server and testbed.
#[derive(Debug)]
pub struct Hub {
    /// Channel to every page.
    news: broadcast::Sender<Utf8Bytes>,
    /// Queue of the pages' requests, each with its client.
    asked: SyncSender<Ask>,
    /// First message to a page.
    hello: String,
    token: String,
    command: Arc<Command>,
    pages: AtomicUsize,
    skipped: AtomicU64,
    /// True if a client commands the motors to stop. It is never rejected, however long the queue is.
    stop: AtomicBool,
    /// The recordings, the oldest first.
    recordings: Mutex<Vec<(PathBuf, Saved)>>,
    /// A recorded flight, which a page receives when it opens.
    flight: Mutex<Option<Utf8Bytes>>,
    /// Queue of the seeds whose flights a person wants to see, if this server shows them.
    seeds: OnceLock<SyncSender<Seed>>,
    /// Number of all events, and the last of them as messages.
    events: Mutex<(usize, VecDeque<Utf8Bytes>)>,
}

impl Hub {
    /// Creates a hub whose pages send their requests to `asked`. Its token consists of random bytes.
    ///
    /// # Errors
    ///
    /// The system has no random bytes.
    pub fn new(asked: SyncSender<Ask>, hello: &Tell) -> Result<Arc<Self>, getrandom::Error> {
        let mut bytes = [0; 16];
        getrandom::fill(&mut bytes)?;
        Ok(Arc::new(Self {
            news: broadcast::channel(QUEUE_LENGTH).0,
            asked,
            hello: text(hello),
            token: bytes.iter().map(|byte| format!("{byte:02x}")).collect(),
            command: Arc::default(),
            pages: AtomicUsize::new(0),
            skipped: AtomicU64::new(0),
            stop: AtomicBool::new(false),
            recordings: Mutex::default(),
            flight: Mutex::default(),
            seeds: OnceLock::new(),
            events: Mutex::default(),
        }))
    }

    /// Returns the token that permits commands.
    pub fn token(&self) -> &str {
        &self.token
    }

    /// Sends a message to every page.
    pub fn tell(&self, what: &Tell) {
        if self.news.receiver_count() > 0 {
            // None listens any more: nobody is reported.
            let _ = self.news.send(text(what).into());
        }
    }

    /// Keeps an event for every page: each receives it with its next message, however slowly it reads.
    pub fn log(&self, event: &Event) {
        if let Ok(mut events) = self.events.lock() {
            let (count, last) = &mut *events;
            *count += 1;
            last.push_back(text(&Tell::Event(event.clone())).into());
            if last.len() > MOST_EVENTS {
                last.pop_front();
            }
        }
    }

    /// Returns the events after the first `seen`, and notes them there.
    fn events(&self, seen: &mut usize) -> Vec<Utf8Bytes> {
        let Ok(events) = self.events.lock() else { return Vec::new() };
        let (count, last) = &*events;
        let new = last.iter().skip(last.len().saturating_sub(count.saturating_sub(*seen)));
        *seen = *count;
        new.cloned().collect()
    }

    /// Pages that look on.
    pub fn pages(&self) -> usize {
        self.pages.load(Ordering::Relaxed)
    }

    /// Returns the number of messages dropped for slow pages.
    pub fn skipped(&self) -> u64 {
        self.skipped.load(Ordering::Relaxed)
    }

    /// Returns true if any client has the right to command.
    pub fn is_commanded(&self) -> bool {
        self.command.is_held()
    }

    /// Creates a seat for a client that may request the right to command.
    pub fn seat(&self) -> Seat {
        self.command.seat()
    }

    /// Returns true if a client has commanded the motors to stop since the last call.
    pub fn take_stop(&self) -> bool {
        self.stop.swap(false, Ordering::Relaxed)
    }

    /// Adds a file that can be downloaded. Beyond a number, the oldest is not listed any more.
    pub fn keep(&self, recording: PathBuf) {
        let Some(saved) = Saved::of(&recording) else { return };
        if let Ok(mut recordings) = self.recordings.lock() {
            recordings.retain(|(it, _)| *it != recording);
            recordings.push((recording, saved));
            let more = recordings.len().saturating_sub(MOST_RECORDINGS);
            recordings.drain(..more);
        }
    }

    /// Adds the recordings in a folder, in the order of their changes.
    pub fn keep_all(&self, folder: &FilePath) {
        let files = std::fs::read_dir(folder).into_iter().flatten().flatten();
        let mcap =
            files.map(|it| it.path()).filter(|it| it.extension().is_some_and(|it| it == "mcap"));
        let mut found: Vec<(PathBuf, Saved)> =
            mcap.filter_map(|path| Saved::of(&path).map(|saved| (path, saved))).collect();
        found.sort_by(|(_, one), (_, other)| one.written.total_cmp(&other.written));
        found.into_iter().for_each(|(path, _)| self.keep(path));
    }

    /// Returns the files that can be downloaded, the oldest first.
    pub fn recordings(&self) -> Vec<Saved> {
        let Ok(recordings) = self.recordings.lock() else { return Vec::new() };
        recordings.iter().map(|(_, saved)| saved.clone()).collect()
    }

    /// Shows a recorded flight with its events in place of the one before: each page receives it, also when it opens later.
    pub fn show(&self, flight: Flight, events: &[Event]) {
        if let Ok(mut kept) = self.events.lock() {
            kept.1.clear();
        }
        events.iter().for_each(|event| self.log(event));
        let flight = Utf8Bytes::from(text(&Tell::Flight(Box::new(flight))));
        if let Ok(mut shown) = self.flight.lock() {
            *shown = Some(flight.clone());
        }
        // No page is open.
        let _ = self.news.send(flight);
    }

    /// Returns the seeds whose flights a person wants to see; without this call, there are no such links.
    pub fn seeds(&self) -> Receiver<Seed> {
        let (wanted, seeds) = sync_channel(MOST_SEEDS);
        let _ = self.seeds.set(wanted);
        seeds
    }

    /// Returns the path of a recording by its name; of the last one without a name.
    fn recording(&self, wanted: Option<&str>) -> Option<PathBuf> {
        let recordings = self.recordings.lock().ok()?;
        let mut newest = recordings.iter().rev();
        let found = newest.find(|(_, saved)| wanted.is_none_or(|wanted| saved.name == wanted));
        found.map(|(path, _)| path.clone())
    }
}

/// Serves until the process ends.
///
/// # Errors
/// The socket failed.
pub async fn serve(listener: TcpListener, hub: Arc<Hub>) -> std::io::Result<()> {
    axum::serve(Limited::new(listener, MOST_CONNECTIONS), router(hub)).await
}

/// Binds to an address and serves from a thread; returns the actual address.
///
/// # Errors
///
/// The address is in use, or there is no thread.
pub fn start(address: SocketAddr, hub: Arc<Hub>) -> std::io::Result<SocketAddr> {
    let runtime = tokio::runtime::Builder::new_current_thread().enable_all().build()?;
    let listener = runtime.block_on(TcpListener::bind(address))?;
    let bound = listener.local_addr()?;
    std::thread::Builder::new().name("server".into()).spawn(move || {
        if let Err(error) = runtime.block_on(serve(listener, hub)) {
            eprintln!("the server ended: {error}");
        }
    })?;
    Ok(bound)
}

fn router(hub: Arc<Hub>) -> Router {
    Router::new()
        .route("/", get(|| file(Path("index.html".to_owned()))))
        .route("/live", get(live))
        .route("/flight.mcap", get(last_recording))
        .route("/recordings/{name}", get(recording))
        .route("/seed/{campaign}/{seed}", get(seed))
        .route("/{name}", get(file))
        .with_state(hub)
}

/// Serves a file of the page.
async fn file(Path(name): Path<String>) -> Response {
    let Some((kind, content)) = page::file(&name) else {
        return (StatusCode::NOT_FOUND, "there is no such file").into_response();
    };
    let headers = [
        (header::CONTENT_TYPE, kind),
        (header::CACHE_CONTROL, "no-cache"),
        (header::X_CONTENT_TYPE_OPTIONS, "nosniff"),
        (
            header::CONTENT_SECURITY_POLICY,
            "default-src 'self'; style-src 'self' 'unsafe-inline'; img-src 'self' data:; frame-ancestors 'none'",
        ),
    ];
    (headers, content).into_response()
}

/// Serves the last recording to a client with the token.
async fn last_recording(State(hub): State<Arc<Hub>>, headers: HeaderMap, address: Uri) -> Response {
    download(&hub, None, &headers, &address).await
}

/// Serves a recording by its name to a client with the token.
async fn recording(
    State(hub): State<Arc<Hub>>,
    Path(name): Path<String>,
    headers: HeaderMap,
    address: Uri,
) -> Response {
    download(&hub, Some(&name), &headers, &address).await
}

/// Sends a recording piece by piece.
async fn download(hub: &Hub, wanted: Option<&str>, headers: &HeaderMap, address: &Uri) -> Response {
    let mut query = address.query().into_iter().flat_map(|query| query.split('&'));
    let token = query.find_map(|part| part.strip_prefix("token=")).unwrap_or_default();
    if !is_ours(headers) || !is_same(token, &hub.token) {
        let reason = "a recording is for clients with the token: use the link on the page";
        return (StatusCode::FORBIDDEN, reason).into_response();
    }
    let Some(path) = hub.recording(wanted) else {
        let reason = match wanted {
            Some(_) => "there is no recording of this name",
            None => "nothing has been recorded",
        };
        return (StatusCode::NOT_FOUND, reason).into_response();
    };
    let file = match tokio::fs::File::open(&path).await {
        Ok(file) => file,
        Err(error) => {
            let reason = format!("the recording {} cannot be read: {error}", path.display());
            return (StatusCode::NOT_FOUND, reason).into_response();
        }
    };
    let headers = [
        (header::CONTENT_TYPE, "application/octet-stream"),
        // The browser takes the name from the address.
        (header::CONTENT_DISPOSITION, "attachment"),
        (header::CACHE_CONTROL, "no-store"),
    ];
    (headers, Body::from_stream(ReaderStream::new(file))).into_response()
}

/// Shows the flight of a campaign's seed to a person who opened its link.
async fn seed(
    State(hub): State<Arc<Hub>>,
    Path((campaign, seed)): Path<(String, String)>,
    headers: HeaderMap,
) -> Response {
    if !is_ours(&headers) || !is_opened(&headers) {
        return (StatusCode::FORBIDDEN, "a seed is shown if a person opens its link")
            .into_response();
    }
    let Some((seed, answer)) = Seed::of(&campaign, &seed) else {
        let reason = "there is no such seed: the campaigns are `spread` and `failures`";
        return (StatusCode::NOT_FOUND, reason).into_response();
    };
    // Only an address that was checked is repeated.
    let Some(seeds) = hub.seeds.get() else {
        let reason = format!(
            "this server shows no seeds: end it, and run cargo xtask replay --page --campaign {campaign} --seed {}",
            seed.seed
        );
        return (StatusCode::NOT_FOUND, reason).into_response();
    };
    if seeds.try_send(seed).is_err() {
        return (StatusCode::SERVICE_UNAVAILABLE, "other seeds are being flown: try again")
            .into_response();
    }
    match answer.await {
        Ok(Ok(())) => Redirect::to("/").into_response(),
        Ok(Err(reason)) => (StatusCode::INTERNAL_SERVER_ERROR, reason).into_response(),
        Err(_) => (StatusCode::INTERNAL_SERVER_ERROR, "the program has ended").into_response(),
    }
}

/// Returns true if an address was opened as a page of its own, or the client is no browser. A browser says so of what a page
/// embeds or requests (W3C, Fetch Metadata Request Headers).
fn is_opened(headers: &HeaderMap) -> bool {
    let is = |name, wanted: &str| headers.get(name).is_none_or(|value| value == wanted);
    is("sec-fetch-mode", "navigate") && is("sec-fetch-dest", "document")
}

/// Opens a page's WebSocket.
async fn live(
    State(hub): State<Arc<Hub>>,
    headers: HeaderMap,
    upgrade: WebSocketUpgrade,
) -> Response {
    if !is_ours(&headers) {
        return (StatusCode::FORBIDDEN, "this page is not of this server").into_response();
    }
    if hub.pages() >= MOST_PAGES {
        return (StatusCode::SERVICE_UNAVAILABLE, "too many pages look on").into_response();
    }
    hub.pages.fetch_add(1, Ordering::Relaxed);
    let (failed, there) = (hub.clone(), hub);
    upgrade
        .max_message_size(LONGEST)
        .on_failed_upgrade(move |_| {
            failed.pages.fetch_sub(1, Ordering::Relaxed);
        })
        .on_upgrade(move |socket| async move {
            attend(socket, &there).await;
            there.pages.fetch_sub(1, Ordering::Relaxed);
        })
}

/// Returns true if the host is this machine's, and the page comes from this server or the client is no browser.
fn is_ours(headers: &HeaderMap) -> bool {
    let host = headers.get(header::HOST).and_then(|host| host.to_str().ok());
    if !host.is_some_and(is_local_name) {
        return false;
    }
    let Some(origin) = headers.get(header::ORIGIN) else { return true };
    let from = origin.to_str().ok().and_then(|origin| origin.parse::<Uri>().ok());
    let from = from.as_ref().and_then(Uri::authority).map(|it| it.as_str());
    from.is_some() && from == host
}

/// Returns true if a host is an address or `localhost`. A foreign name that resolves to this machine is rejected.
fn is_local_name(host: &str) -> bool {
    let name = host.rsplit_once(':').map_or(host, |(name, _)| name);
    let plain = name.trim_start_matches('[').trim_end_matches(']');
    plain == "localhost" || plain.parse::<std::net::IpAddr>().is_ok()
}

/// Serves one page until it disconnects.
async fn attend(mut socket: WebSocket, hub: &Hub) {
    let seat = hub.seat();
    let mut news = hub.news.subscribe();
    let (mut trusted, mut held, mut seen) = (false, false, 0);
    let flight = hub.flight.lock().ok().and_then(|flight| flight.clone());
    let first = [Some(hub.hello.clone().into()), flight];
    for message in first.into_iter().flatten() {
        if socket.send(Message::Text(message)).await.is_err() {
            return;
        }
    }
    loop {
        let mut messages = hub.events(&mut seen);
        if held && seat.is_taken() {
            let reason = "another client has taken command";
            messages.push(text(&Tell::Command { granted: false, reason }).into());
        }
        held = seat.holds();
        for message in messages {
            if socket.send(Message::Text(message)).await.is_err() {
                return;
            }
        }
        tokio::select! {
            message = news.recv() => match message {
                Ok(message) => {
                    if socket.send(Message::Text(message)).await.is_err() {
                        return;
                    }
                }
                Err(RecvError::Lagged(count)) => {
                    hub.skipped.fetch_add(count, Ordering::Relaxed);
                }
                Err(RecvError::Closed) => return,
            },
            heard = socket.recv() => {
                let Some(Ok(message)) = heard else { return };
                let Message::Text(message) = message else { continue };
                if let Some(answer) = answer(hub, &seat, &mut trusted, &message)
                    && socket.send(Message::Text(text(&answer).into())).await.is_err()
                {
                    return;
                }
            }
        }
    }
}

/// Answers a page's request, or queues it for the testbed if the page may make it.
fn answer(hub: &Hub, seat: &Seat, trusted: &mut bool, message: &str) -> Option<Tell> {
    let ask: Ask = match serde_json::from_str(message) {
        Ok(ask) => ask,
        Err(_) => return Some(Tell::Refused { reason: unknown(message) }),
    };
    match ask {
        Ask::Ping { number } => Some(Tell::Pong { number }),
        Ask::Claim { token, force } => {
            *trusted |= is_same(&token, &hub.token);
            if !*trusted {
                let reason =
                    "the token is not that of this server: open the address that it printed";
                return Some(Tell::Command { granted: false, reason });
            }
            let free = seat.claim(force);
            let reason = if free { "" } else { "somebody else commands" };
            Some(Tell::Command { granted: free, reason })
        }
        Ask::Release => {
            seat.release();
            Some(Tell::Command { granted: false, reason: "" })
        }
        Ask::Stop if *trusted => {
            hub.stop.store(true, Ordering::Relaxed);
            None
        }
        ask if seat.holds() => match hub.asked.try_send(ask) {
            Ok(()) => None,
            Err(TrySendError::Full(_)) => {
                Some(Tell::Refused { reason: "orders come too fast".into() })
            }
            Err(TrySendError::Disconnected(_)) => {
                Some(Tell::Refused { reason: "the testbed has ended".into() })
            }
        },
        _ => Some(Tell::Refused { reason: "this page does not command".into() }),
    }
}

/// Returns the reason to refuse a message that is no request.
fn unknown(message: &str) -> String {
    let kind = serde_json::from_str::<Value>(message).ok();
    let kind = kind.as_ref().and_then(|it| it["type"].as_str());
    let kind = kind.map(|kind| kind.chars().take(40).collect::<String>());
    let what = kind.map_or("a request".to_owned(), |kind| format!("the request \"{kind}\""));
    format!("the server does not know {what} in this form: reload the page")
}

/// Compares two tokens in a time that does not depend on their difference.
fn is_same(one: &str, other: &str) -> bool {
    let differing = one.bytes().zip(other.bytes()).fold(0, |all, (a, b)| all | (a ^ b));
    one.len() == other.len() && differing == 0
}

/// Converts a message to JSON. Numbers that are not finite become null.
fn text(tell: &Tell) -> String {
    serde_json::to_string(tell).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::mpsc::sync_channel;
    use std::time::Duration;

    #[test]
    fn earlier_recordings_are_listed_by_their_age_and_not_without_end() {
        let folder = tempfile::tempdir().expect("a folder");
        let begun = std::time::SystemTime::UNIX_EPOCH + Duration::from_secs(1_700_000_000);
        for age in 0..25_u64 {
            // The younger it is, the earlier in the alphabet.
            let path = folder.path().join(format!("flight-{:02}.mcap", 99 - age));
            let file = std::fs::File::create(&path).expect("the folder");
            file.set_modified(begun + Duration::from_secs(age)).expect("a file");
        }
        std::fs::write(folder.path().join("notes.txt"), "").expect("the folder");
        let (requests, _queue) = sync_channel(1);
        let hub = Hub::new(requests, &Tell::Pong { number: 0.0 }).expect("random bytes");
        hub.keep_all(folder.path());
        let names: Vec<String> = hub.recordings().into_iter().map(|it| it.name).collect();
        let expected: Vec<String> =
            (5..25).map(|age| format!("flight-{:02}.mcap", 99 - age)).collect();
        assert_eq!(names, expected);
    }
}
