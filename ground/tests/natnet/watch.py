"""A client of NatNet by another author: prints the bodies of the server at the port in the first argument, then requests as many
frames as the second says, by a line each, and prints each as its number, whether the body is tracked, and the bits of its
position and quaternion."""

import struct
import sys
import time

from natnet import NatNetClient

# A limit only ends a test that would never end.
LIMIT = 60.0


def bits(values):
    return "".join(struct.pack(">f", value).hex() for value in values)


def until(holds):
    """Receives until something holds."""
    end = time.monotonic() + LIMIT
    while not holds() and time.monotonic() < end:
        client.update_sync()
        time.sleep(0.001)
    assert holds(), "it never came"


client = NatNetClient("127.0.0.1", "127.0.0.1", command_port=int(sys.argv[1]), use_multicast=False)
descriptions, frames = [], []
client.on_data_description_received_event.handlers.append(descriptions.append)
client.on_data_frame_received_event.handlers.append(frames.append)
with client:
    print(client.server_info.application_name, client.server_info.nat_net_protocol_version, flush=True)
    client.request_modeldef()
    until(lambda: descriptions)
    for body in descriptions[0].rigid_bodies:
        print(body.name, body.id_num, flush=True)
    for count in range(int(sys.argv[2])):
        print("next", flush=True)
        until(lambda: len(frames) > count)
        for body in frames[count].rigid_bodies:
            print(frames[count].prefix.frame_number, body.tracking_valid, bits(body.pos), bits(body.rot), flush=True)
