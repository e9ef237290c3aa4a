//! Foxglove's end of its protocol, by a WebSocket alone: the channels of a recording, message by message.

use ground::live::{self, Live};
use ground::program::{Program, Target};
use ground::server::Hub;
use ground::testbed::{Pace, Testbed, Wanted};
use ground::tools::foxglove::Foxglove;
use serde_json::{Value, json};
use sim::recording::{channels, log_time, messages};
use std::collections::BTreeMap;
use std::net::{SocketAddr, TcpStream};
use std::sync::mpsc::{Receiver, TryRecvError, sync_channel};
use std::time::{Duration, Instant};
use tungstenite::client::IntoClientRequest;
use tungstenite::{Message, WebSocket};

/// Time limit of a wait. Only a broken server exceeds it.
const LIMIT: Duration = Duration::from_secs(120);

/// So many messages are looked at.
const MESSAGES: usize = 200;

/// A message of a topic at a time, ns.
type Heard = (String, u64, Vec<u8>);

/// A client that has subscribed to everything; the topics, with schema and encoding, by number.
fn client(address: SocketAddr) -> (WebSocket<TcpStream>, BTreeMap<u64, Value>) {
    let mut request = format!("ws://{address}").into_client_request().expect("an address");
    let protocol = "foxglove.sdk.v1".parse().expect("a header");
    request.headers_mut().insert("sec-websocket-protocol", protocol);
    let stream = TcpStream::connect(address).expect("the server listens");
    let (mut socket, _) = tungstenite::client(request, stream).expect("it speaks this protocol");
    let expected = channels().count();
    let mut topics = BTreeMap::new();
    while topics.len() < expected {
        let heard = socket.read().expect("the server speaks");
        let Ok(Ok(told)) = heard.to_text().map(serde_json::from_str::<Value>) else { continue };
        for channel in told["channels"].as_array().into_iter().flatten() {
            topics.insert(channel["id"].as_u64().expect("a number"), channel.clone());
        }
    }
    let wanted: Vec<Value> = topics.keys().map(|id| json!({ "id": id, "channelId": id })).collect();
    let ask = json!({ "op": "subscribe", "subscriptions": wanted });
    socket.send(Message::text(ask.to_string())).expect("the server listens");
    (socket, topics)
}

/// Reads until there is enough, beside the test.
fn heard(mut socket: WebSocket<TcpStream>, topics: BTreeMap<u64, Value>) -> Receiver<Heard> {
    let (sender, receiver) = sync_channel(MESSAGES);
    std::thread::spawn(move || {
        let mut count = 0;
        while count < MESSAGES {
            let Message::Binary(bytes) = socket.read().expect("the server speaks") else {
                continue;
            };
            if bytes[0] != 1 {
                continue;
            }
            let number = u32::from_le_bytes(bytes[1..5].try_into().expect("four bytes"));
            let time = u64::from_le_bytes(bytes[5..13].try_into().expect("eight bytes"));
            let topic = topics[&number.into()]["topic"].as_str().expect("a text").to_owned();
            count += 1;
            if sender.send((topic, time, bytes[13..].to_vec())).is_err() {
                return;
            }
        }
    });
    receiver
}

#[test]
fn foxglove_sees_what_a_recording_holds() {
    let program = Program::build(&bessemer_legs::root(), Target::Native)
        .unwrap_or_else(|error| panic!("{error}"));
    let testbed = Testbed::start(&program, &Wanted { pace: Pace::Virtual, ..Wanted::default() })
        .unwrap_or_else(|error| panic!("{error}"));
    let (asked, asks) = live::queue();
    let hub = Hub::new(asked, &live::hello(sim::Aircraft::Mambo, false)).expect("random bytes");
    let mut live = Live::new(testbed, hub, asks, std::env::temp_dir());
    let tool = Foxglove::start(([127, 0, 0, 1], 0).into()).expect("a port");
    let address = tool.address();
    live.add(tool);

    let (socket, topics) = client(address);
    for (channel, expected) in topics.values().zip(channels()) {
        assert_eq!(channel["topic"], expected.topic.as_str());
        assert_eq!(channel["schema"], expected.text.as_str());
        assert_eq!(channel["encoding"], "json");
    }
    let heard = heard(socket, topics);
    let (mut expected, mut checked, begun) = (BTreeMap::new(), 0, Instant::now());
    loop {
        let done = live.step().unwrap_or_else(|error| panic!("{error}"));
        let time = log_time(done.moment.time);
        for (channel, message) in channels().zip(messages(&done.moment)) {
            expected.insert((channel.topic, time), message);
        }
        match heard.try_recv() {
            Ok((topic, time, bytes)) => {
                let wanted = expected.get(&(topic.clone(), time)).map(String::as_bytes);
                assert_eq!(wanted, Some(bytes.as_slice()), "{topic} at {time}");
                checked += 1;
            }
            Err(TryRecvError::Empty) => assert!(begun.elapsed() < LIMIT, "nothing comes"),
            Err(TryRecvError::Disconnected) => break,
        }
    }
    assert_eq!(checked, MESSAGES);
}
