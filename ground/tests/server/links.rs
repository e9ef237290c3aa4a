//! Links of a campaign's seeds, as a browser opens them.

use super::{LIMIT, page_from, served};
use ground::live;
use ground::player::Player;
use ground::seeds;
use ground::server::{self, Hub};
use sim::campaign::Kind;
use std::io::{Read, Write};
use std::net::{SocketAddr, TcpStream};

/// The request of a browser that opens a link.
fn opened(path: &str) -> String {
    format!("GET {path} HTTP/1.1\r\nSec-Fetch-Mode: navigate\r\nSec-Fetch-Dest: document")
}

/// Sends a request with headers, and returns the answer.
pub(super) fn answered(address: SocketAddr, request: &str, host: &str) -> String {
    let mut stream = TcpStream::connect(address).expect("the server listens");
    write!(stream, "{request}\r\nHost: {host}\r\nConnection: close\r\n\r\n")
        .expect("the server listens");
    let mut answer = Vec::new();
    stream.read_to_end(&mut answer).expect("the server answers");
    String::from_utf8_lossy(&answer).into_owned()
}

#[test]
fn a_link_of_a_seed_shows_its_flight() {
    let folder = tempfile::tempdir().expect("a folder");
    let first = seeds::fly(Kind::Spread, 0, folder.path()).expect("a recording");
    let (sender, requests) = live::queue();
    let hub = Hub::new(sender, &live::hello(sim::Aircraft::Mambo, false)).expect("random bytes");
    let wanted = hub.seeds();
    let mut player =
        Player::open(&first, hub.clone(), requests).unwrap_or_else(|it| panic!("{it}"));
    let spread = player.playing().to;
    let address = server::start(([127, 0, 0, 1], 0).into(), hub).expect("a port");
    let own = address.to_string();
    for (path, host, status) in [
        ("/seed/failures/7", "evil.example", "403"),
        ("/seed/spred/7", own.as_str(), "404"),
        ("/seed/failures/-7", own.as_str(), "404"),
    ] {
        assert!(answered(address, &opened(path), host).starts_with(&format!("HTTP/1.1 {status}")));
    }
    // An image, a frame or a script of any page.
    for (mode, dest) in [("no-cors", "image"), ("navigate", "iframe"), ("cors", "empty")] {
        let request = format!(
            "GET /seed/failures/7 HTTP/1.1\r\nSec-Fetch-Mode: {mode}\r\nSec-Fetch-Dest: {dest}"
        );
        assert!(answered(address, &request, &own).starts_with("HTTP/1.1 403"), "{mode} {dest}");
    }
    let mut page = page_from(address, None).unwrap_or_else(|status| panic!("{status:?}"));
    let before = page.hear("flight")["times"].as_array().map(Vec::len);
    let answer = std::thread::spawn(move || answered(address, &opened("/seed/failures/7"), &own));
    player.fly(wanted.recv_timeout(LIMIT).expect("the link's seed"), folder.path());
    let answer = answer.join().expect("it answers");
    assert!(answer.starts_with("HTTP/1.1 303") && answer.contains("location: /\r\n"), "{answer}");
    // Its motor stops, so it is on the ground earlier; an open page has the new flight, too.
    assert!(player.playing().to != spread && folder.path().join("failures-7.mcap").is_file());
    let after = page.hear("flight")["times"].as_array().map(Vec::len);
    assert!(before != after && after.is_some_and(|it| it > 0), "{before:?} {after:?}");
}

#[test]
fn a_server_that_flies_shows_no_seed() {
    let served = served();
    let answer = answered(served.address, &opened("/seed/spread/7"), &served.address.to_string());
    assert!(answer.starts_with("HTTP/1.1 404"), "{answer}");
    assert!(answer.contains("cargo xtask replay --page --campaign spread --seed 7"), "{answer}");
}
