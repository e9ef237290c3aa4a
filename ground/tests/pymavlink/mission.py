"""A mission flown over MAVLink alone: prints the port that it listens at, then what it has seen."""

import time

from pymavlink import mavutil
from pymavlink.dialects.v20 import common as mavlink

# A limit only ends a mission that would never end.
LIMIT = 60.0

link = mavutil.mavlink_connection("udpin:127.0.0.1:0", source_system=255, dialect="common")
print(link.port.getsockname()[1], flush=True)
next_beat = 0.0


def hear(kinds, holds=lambda _: True, limit=LIMIT):
    """The next message of one of the kinds for which something holds; none after the limit."""
    global next_beat
    end = time.monotonic() + limit
    while time.monotonic() < end:
        if link.target_system and time.monotonic() >= next_beat:
            next_beat = time.monotonic() + 1.0
            link.mav.heartbeat_send(mavlink.MAV_TYPE_GCS, mavlink.MAV_AUTOPILOT_INVALID, 0, 0, 0)
        message = link.recv_match(type=kinds, blocking=True, timeout=0.2)
        if message is not None and holds(message):
            return message
    return None


def seen(what, kinds, holds=lambda _: True):
    message = hear(kinds, holds)
    assert message is not None, f"{what}: never"
    print(what, flush=True)
    return message


def order(command, *parameters):
    """Sends a command until it is acknowledged, as the protocol wants it; the result."""
    for confirmation in range(10):
        filled = list(parameters) + [0.0] * (7 - len(parameters))
        link.mav.command_long_send(link.target_system, link.target_component, command, confirmation, *filled)
        ack = hear("COMMAND_ACK", lambda it: it.command == command, 2.0)
        if ack is not None:
            return ack.result
    raise AssertionError(f"command {command} is not acknowledged")


def there(x, y, z):
    return lambda it: abs(it.x - x) < 0.1 and abs(it.y - y) < 0.1 and abs(it.z - z) < 0.1


def on(state):
    return lambda it: it.landed_state == state


heart = seen("a heart beats", "HEARTBEAT")
link.target_system, link.target_component = heart.get_srcSystem(), heart.get_srcComponent()
assert (heart.type, heart.mavlink_version) == (mavlink.MAV_TYPE_QUADROTOR, 3)
assert heart.get_msgbuf()[0] == 0xFD, "MAVLink 2"

link.mav.param_request_list_send(link.target_system, link.target_component)
parameters = {}
while len(parameters) < 20:
    it = hear("PARAM_VALUE")
    assert it.param_count == 20
    if it.param_value == it.param_value:
        parameters[it.param_id] = it.param_value
    else:
        # Not known on the ground yet: asked for again.
        link.mav.param_request_read_send(link.target_system, link.target_component, b"", it.param_index)
print("20 parameters", flush=True)
for name, value, kept in [("HEIGHT_P", 2.0, 2.0), ("HEIGHT_I", 9.0, parameters["HEIGHT_I"])]:
    link.mav.param_set_send(
        link.target_system, link.target_component, name.encode(), value, mavlink.MAV_PARAM_TYPE_REAL32
    )
    answer = seen(f"{name} is answered", "PARAM_VALUE", lambda it: it.param_id == name)
    assert answer.param_value == kept, answer

assert order(mavlink.MAV_CMD_COMPONENT_ARM_DISARM, 1.0) == mavlink.MAV_RESULT_ACCEPTED
assert order(mavlink.MAV_CMD_NAV_TAKEOFF, 0, 0, 0, 0, 0, 0, 1.0) == mavlink.MAV_RESULT_ACCEPTED
seen("it takes off", "EXTENDED_SYS_STATE", on(mavlink.MAV_LANDED_STATE_TAKEOFF))
seen("it is 1 m high", "LOCAL_POSITION_NED", lambda it: abs(it.z + 1.0) < 0.1)
seen("it flies", "EXTENDED_SYS_STATE", on(mavlink.MAV_LANDED_STATE_IN_AIR))
assert order(mavlink.MAV_CMD_NAV_TAKEOFF, 0, 0, 0, 0, 0, 0, 1.0) == mavlink.MAV_RESULT_DENIED
assert order(mavlink.MAV_CMD_COMPONENT_ARM_DISARM, 0.0) == mavlink.MAV_RESULT_DENIED, "in the air"
assert order(mavlink.MAV_CMD_NAV_LOITER_UNLIM) == mavlink.MAV_RESULT_UNSUPPORTED
assert order(mavlink.MAV_CMD_DO_SET_MODE, 1.0, 7.0) == mavlink.MAV_RESULT_DENIED, "no such mode"

assert order(mavlink.MAV_CMD_DO_SET_MODE, 1.0, 1.0) == mavlink.MAV_RESULT_ACCEPTED
seen("feed-forward", "HEARTBEAT", lambda it: it.custom_mode == 1)
assert order(mavlink.MAV_CMD_DO_SET_MODE, 1.0, 0.0) == mavlink.MAV_RESULT_ACCEPTED
seen("closed loop", "HEARTBEAT", lambda it: it.custom_mode == 0)

# Position and yaw, nothing else.
link.mav.set_position_target_local_ned_send(
    0, link.target_system, link.target_component, mavlink.MAV_FRAME_LOCAL_NED, 0b100111111000,
    0.8, 0.4, -1.2, 0, 0, 0, 0, 0, 0, 0.5, 0,
)
seen("it is there", "LOCAL_POSITION_NED", there(0.8, 0.4, -1.2))
seen("it has turned", "ATTITUDE", lambda it: abs(it.yaw - 0.5) < 0.1 and abs(it.roll) < 0.1 and abs(it.pitch) < 0.1)
seen("the battery drains", "BATTERY_STATUS", lambda it: 3000 < it.voltages[0] < 4200 and it.battery_remaining < 100)

assert order(mavlink.MAV_CMD_NAV_LAND) == mavlink.MAV_RESULT_ACCEPTED
seen("it lands", "EXTENDED_SYS_STATE", on(mavlink.MAV_LANDED_STATE_LANDING))
seen("it has landed", "EXTENDED_SYS_STATE", on(mavlink.MAV_LANDED_STATE_ON_GROUND))
seen("it rests", "HEARTBEAT", lambda it: it.system_status == mavlink.MAV_STATE_STANDBY)

assert order(mavlink.MAV_CMD_COMPONENT_ARM_DISARM, 1.0) == mavlink.MAV_RESULT_ACCEPTED
seen("it is armed", "HEARTBEAT", lambda it: it.base_mode & mavlink.MAV_MODE_FLAG_SAFETY_ARMED)
assert order(mavlink.MAV_CMD_NAV_TAKEOFF, 0, 0, 0, 0, 0, 0, 0.6) == mavlink.MAV_RESULT_ACCEPTED
seen("it is in the air again", "LOCAL_POSITION_NED", lambda it: it.z < -0.3)
assert order(mavlink.MAV_CMD_DO_FLIGHTTERMINATION, 1.0) == mavlink.MAV_RESULT_ACCEPTED
seen("it has stopped", "HEARTBEAT", lambda it: it.system_status == mavlink.MAV_STATE_EMERGENCY)
print("flown", flush=True)
