"""A mission flown over MAVLink alone, signed with the key in the first argument, 64 hexadecimal digits: prints the port that it
listens at, then what it has seen."""

import math
import sys

import time

from pymavlink import mavutil
from pymavlink.dialects.v20 import common as mavlink

# A limit only ends a mission that would never end.
LIMIT = 60.0
# A type of vehicle or station that no dialect has yet.
NEWER_TYPE = 200

link = mavutil.mavlink_connection("udpin:127.0.0.1:0", source_system=255, dialect="common")
KEY = bytes.fromhex(sys.argv[1])
print(link.port.getsockname()[1], flush=True)
next_beat = 0.0


def hear(kinds, holds=lambda _: True, limit=LIMIT):
    """The next message of one of the kinds for which something holds; none after the limit."""
    global next_beat
    end = time.monotonic() + limit
    while time.monotonic() < end:
        if link.target_system and time.monotonic() >= next_beat:
            next_beat = time.monotonic() + 1.0
            # It is heard, although this type is not understood.
            link.mav.heartbeat_send(NEWER_TYPE, mavlink.MAV_AUTOPILOT_INVALID, 0, 0, 0)
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
    # Asked again, an order may be refused that was obeyed: over loopback nothing is lost, and a busy machine takes its time.
    for confirmation in range(3):
        filled = list(parameters) + [0.0] * (7 - len(parameters))
        link.mav.command_long_send(link.target_system, link.target_component, command, confirmation, *filled)
        ack = hear("COMMAND_ACK", lambda it: it.command == command, 30.0)
        if ack is not None:
            return ack.result
    raise AssertionError(f"command {command} is not acknowledged")


def there(x, y, z):
    return lambda it: abs(it.x - x) < 0.1 and abs(it.y - y) < 0.1 and abs(it.z - z) < 0.1


def on(state):
    return lambda it: it.landed_state == state


heart = seen("a heart beats", "HEARTBEAT")
us = (heart.get_srcSystem(), heart.get_srcComponent())
link.target_system, link.target_component = us
assert heart.get_header().incompat_flags & mavlink.MAVLINK_IFLAG_SIGNED, "what comes is signed"
# Nobody listens to what is not signed, or signed with another key.
for other in [None, bytes(32)]:
    if other:
        link.setup_signing(other, sign_outgoing=True, allow_unsigned_callback=lambda *_: True)
    link.mav.command_long_send(*us, mavlink.MAV_CMD_NAV_TAKEOFF, 0, 0, 0, 0, 0, 0, 0, 1.0)
    assert hear("COMMAND_ACK", limit=1.5) is None, "it took what was not signed"
print("nothing is taken unsigned", flush=True)
link.setup_signing(KEY, sign_outgoing=True)
assert seen("a signed heart beats", "HEARTBEAT").get_signed()
assert (heart.type, heart.mavlink_version) == (mavlink.MAV_TYPE_QUADROTOR, 3)
assert heart.get_msgbuf()[0] == 0xFD, "MAVLink 2"

link.mav.param_request_list_send(link.target_system, link.target_component)
parameters = {}
while len(parameters) < 23:
    it = hear("PARAM_VALUE")
    assert it.param_count == 23
    if it.param_value == it.param_value:
        parameters[it.param_id] = it.param_value
    else:
        # Not known on the ground yet: asked for again.
        link.mav.param_request_read_send(link.target_system, link.target_component, b"", it.param_index)
print("23 parameters", flush=True)
for name, value, kept in [("HEIGHT_P", 2.0, 2.0), ("HEIGHT_I", 9.0, parameters["HEIGHT_I"])]:
    link.mav.param_set_send(
        link.target_system, link.target_component, name.encode(), value, mavlink.MAV_PARAM_TYPE_REAL32
    )
    answer = seen(f"{name} is answered", "PARAM_VALUE", lambda it: it.param_id == name)
    assert answer.param_value == kept, answer


# Messages on request, and periods of messages.
version = mavlink.MAVLINK_MSG_ID_AUTOPILOT_VERSION
link.mav.command_long_send(*us, mavlink.MAV_CMD_REQUEST_MESSAGE, 0, version, 0, 0, 0, 0, 0, 0)
able = seen("a version", "AUTOPILOT_VERSION").capabilities
assert hear("COMMAND_ACK").result == mavlink.MAV_RESULT_ACCEPTED
assert able & mavlink.MAV_PROTOCOL_CAPABILITY_MAVLINK2 and able & mavlink.MAV_PROTOCOL_CAPABILITY_MISSION_INT
assert order(mavlink.MAV_CMD_REQUEST_MESSAGE, 9999) == mavlink.MAV_RESULT_UNSUPPORTED
interval = mavlink.MAV_CMD_SET_MESSAGE_INTERVAL
assert order(interval, mavlink.MAVLINK_MSG_ID_ATTITUDE, 200_000) == mavlink.MAV_RESULT_ACCEPTED
assert order(interval, mavlink.MAVLINK_MSG_ID_ATTITUDE, -7) == mavlink.MAV_RESULT_DENIED
assert order(interval, mavlink.MAVLINK_MSG_ID_HEARTBEAT, -1) == mavlink.MAV_RESULT_DENIED
assert order(interval, 9999, 1000) == mavlink.MAV_RESULT_UNSUPPORTED
# Attitudes of the old period may still wait in the socket.
times = [hear("ATTITUDE").time_boot_ms]
seen("another period", "ATTITUDE", lambda it: times.append(it.time_boot_ms) or 190 <= times[-1] - times[-2] <= 210)
link.mav.command_long_send(
    *us, mavlink.MAV_CMD_REQUEST_MESSAGE, 0, mavlink.MAVLINK_MSG_ID_MESSAGE_INTERVAL, mavlink.MAVLINK_MSG_ID_ATTITUDE, 0, 0, 0, 0, 0
)
assert seen("a period", "MESSAGE_INTERVAL").interval_us == 200_000
assert hear("COMMAND_ACK").result == mavlink.MAV_RESULT_ACCEPTED
assert order(interval, mavlink.MAVLINK_MSG_ID_ATTITUDE, 0) == mavlink.MAV_RESULT_ACCEPTED
link.mav.set_gps_global_origin_send(us[0], 470000000, 110000000, 500000)
seen("a home", "HOME_POSITION", lambda it: it.latitude == 470000000)
# The command that supersedes the message; this pymavlink has no name for it.
link.mav.command_int_send(*us, mavlink.MAV_FRAME_GLOBAL, 611, 0, 0, 0, 0, 0, 0, 480000000, 110000000, 500.0)
home = seen("another home", "HOME_POSITION", lambda it: it.latitude == 480000000)
assert (home.latitude, home.longitude, home.altitude) == (480000000, 110000000, 500000)
placed = seen("a place on the earth", "GLOBAL_POSITION_INT", lambda it: it.lat != 0)
assert abs(placed.lat - 480000000) < 100 and abs(placed.lon - 110000000) < 100 and abs(placed.alt - 500000) < 100
state = seen("a state", "SYS_STATUS")
ready = mavlink.MAV_SYS_STATUS_PREARM_CHECK
assert state.onboard_control_sensors_present & ready and state.onboard_control_sensors_health & ready

# Disarmed at the start, and again on request; the reason of a refusal follows as text.
armed = lambda it: it.base_mode & mavlink.MAV_MODE_FLAG_SAFETY_ARMED
assert not armed(seen("another heart beat", "HEARTBEAT"))
assert order(mavlink.MAV_CMD_NAV_TAKEOFF, 0, 0, 0, 0, 0, 0, 1.0) == mavlink.MAV_RESULT_DENIED
seen("a reason", "STATUSTEXT", lambda it: "is disarmed" in it.text)
assert order(mavlink.MAV_CMD_COMPONENT_ARM_DISARM, 1.0) == mavlink.MAV_RESULT_ACCEPTED
seen("armed", "HEARTBEAT", armed)
assert order(mavlink.MAV_CMD_COMPONENT_ARM_DISARM, 0.0) == mavlink.MAV_RESULT_ACCEPTED
heart = seen("disarmed", "HEARTBEAT", lambda it: not armed(it))
assert heart.system_status == mavlink.MAV_STATE_STANDBY

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
since = seen("it arrives", "LOCAL_POSITION_NED", there(0.8, 0.4, -1.2)).time_boot_ms
# Longer than the silence after which a station loses the right to command: only heartbeats are sent.
seen("it is there", "LOCAL_POSITION_NED", lambda it: it.time_boot_ms > since + 7000)
seen("it has turned", "ATTITUDE", lambda it: abs(it.yaw - 0.5) < 0.1 and abs(it.roll) < 0.1 and abs(it.pitch) < 0.1)
seen("the battery drains", "BATTERY_STATUS", lambda it: 3000 < it.voltages[0] < 4200 and it.battery_remaining < 100)



def stick(x, y, z, r):
    link.mav.manual_control_send(link.target_system, x, y, z, r, 0)


# By hand: forward, then left and up, turning clockwise; nothing of it counts in another mode.
stick(1000, 0, 1000, 0)
assert order(mavlink.MAV_CMD_DO_SET_MODE, 1.0, 2.0) == mavlink.MAV_RESULT_ACCEPTED
seen("by hand", "HEARTBEAT", lambda it: it.custom_mode == 2)


def held(what, axes, holds):
    """Holds the sticks until something is so; the message that showed it."""
    for _ in range(600):
        stick(*axes)
        message = hear("LOCAL_POSITION_NED", limit=0.1)
        if message is not None and holds(message):
            print(what, flush=True)
            return message
    raise AssertionError(f"{what}: never")


held("forward", (600, 0, 500, 0), lambda it: it.vx > 0.2)
held("back", (-600, 0, 500, 0), lambda it: it.vx < 0.0)
held("left and up", (0, -600, 900, 0), lambda it: it.vy < -0.2 and it.vz < -0.1)
held("right", (0, 600, 500, 0), lambda it: it.vy > 0.0)
stick(0, 0, 500, -800)
before = hear("ATTITUDE").yaw
held("clockwise", (0, 0, 500, -800), lambda _: hear("ATTITUDE").yaw > before + 0.3)
assert order(mavlink.MAV_CMD_DO_SET_MODE, 1.0, 0.0) == mavlink.MAV_RESULT_ACCEPTED
seen("closed loop again", "HEARTBEAT", lambda it: it.custom_mode == 0)

assert order(mavlink.MAV_CMD_NAV_LAND) == mavlink.MAV_RESULT_ACCEPTED
seen("it lands", "EXTENDED_SYS_STATE", on(mavlink.MAV_LANDED_STATE_LANDING))
seen("it has landed", "EXTENDED_SYS_STATE", on(mavlink.MAV_LANDED_STATE_ON_GROUND))
seen("it rests", "HEARTBEAT", lambda it: it.system_status == mavlink.MAV_STATE_STANDBY)



def item(number, command, x, y, z, hold=0.0, yaw=math.nan, frame=mavlink.MAV_FRAME_LOCAL_NED):
    return mavlink.MAVLink_mission_item_int_message(
        *us, number, frame, command, 0, 1, hold, 0, 0, yaw, round(1e4 * x), round(1e4 * y), z
    )


def handed_in(items, wanted=mavlink.MAV_MISSION_ACCEPTED):
    """Hands a mission in, as the protocol wants it: each item when it is asked for."""
    link.mav.mission_count_send(*us, len(items))
    while True:
        it = hear(["MISSION_REQUEST_INT", "MISSION_ACK"])
        assert it is not None, "the mission is not asked for"
        if it.get_type() == "MISSION_ACK":
            assert it.type == wanted, it
            return
        link.mav.send(items[it.seq])


TO, UP, DOWN = mavlink.MAV_CMD_NAV_WAYPOINT, mavlink.MAV_CMD_NAV_TAKEOFF, mavlink.MAV_CMD_NAV_LAND
far = [item(0, UP, 0, 0, -1.0), item(1, TO, 99.0, 0, -1.0)]
handed_in(far, mavlink.MAV_MISSION_INVALID_PARAM5_X)
elsewhere = [item(0, TO, 0.1, 0.1, -1.0, frame=mavlink.MAV_FRAME_GLOBAL_RELATIVE_ALT_INT)]
handed_in(elsewhere, mavlink.MAV_MISSION_UNSUPPORTED_FRAME)
handed_in([item(0, DOWN, 0, 0, 0), item(1, TO, 0, 0, -1.0)], mavlink.MAV_MISSION_INVALID)
link.mav.mission_count_send(*us, 99)
assert hear("MISSION_ACK").type == mavlink.MAV_MISSION_NO_SPACE
assert order(mavlink.MAV_CMD_MISSION_START) == mavlink.MAV_RESULT_DENIED, "there is none"
mission = [
    item(0, UP, 0.0, 0.0, -1.0),
    item(1, TO, 0.6, 0.0, -1.2, hold=1.0, yaw=20.0),
    item(2, TO, 0.6, -0.6, -0.8),
    item(3, DOWN, 0.6, -0.6, 0.0),
]
handed_in(mission)
# And read back.
link.mav.mission_request_list_send(*us)
assert hear("MISSION_COUNT").count == len(mission)
for number, wanted in enumerate(mission):
    link.mav.mission_request_int_send(*us, number)
    it = hear("MISSION_ITEM_INT", lambda it: it.seq == number)
    assert (it.command, it.x, it.y, it.frame) == (wanted.command, wanted.x, wanted.y, wanted.frame), it
    assert abs(it.z - wanted.z) < 1e-6 and abs(it.param1 - wanted.param1) < 1e-6
link.mav.mission_request_int_send(*us, len(mission))
assert hear("MISSION_ACK").type == mavlink.MAV_MISSION_INVALID_SEQUENCE
print("a mission is on board", flush=True)

assert order(mavlink.MAV_CMD_MISSION_START) == mavlink.MAV_RESULT_DENIED, "it is not armed"
assert order(mavlink.MAV_CMD_COMPONENT_ARM_DISARM, 1.0) == mavlink.MAV_RESULT_ACCEPTED
seen("it is armed for it", "HEARTBEAT", lambda it: it.base_mode & mavlink.MAV_MODE_FLAG_SAFETY_ARMED)
assert order(mavlink.MAV_CMD_MISSION_START) == mavlink.MAV_RESULT_ACCEPTED
assert order(mavlink.MAV_CMD_MISSION_START) == mavlink.MAV_RESULT_DENIED, "it is being flown"
link.mav.mission_clear_all_send(*us)
assert hear("MISSION_ACK").type == mavlink.MAV_MISSION_DENIED
for number in range(4):
    seen(f"item {number} is reached", "MISSION_ITEM_REACHED", lambda it: it.seq == number)
seen("the mission is complete", "MISSION_CURRENT", lambda it: it.mission_state == mavlink.MISSION_STATE_COMPLETE)
link.mav.mission_clear_all_send(*us)
assert hear("MISSION_ACK").type == mavlink.MAV_MISSION_ACCEPTED
seen("and forgotten", "MISSION_CURRENT", lambda it: it.mission_state == mavlink.MISSION_STATE_NO_MISSION)

assert order(mavlink.MAV_CMD_COMPONENT_ARM_DISARM, 1.0) == mavlink.MAV_RESULT_ACCEPTED
seen("it is armed", "HEARTBEAT", lambda it: it.base_mode & mavlink.MAV_MODE_FLAG_SAFETY_ARMED)
assert order(mavlink.MAV_CMD_NAV_TAKEOFF, 0, 0, 0, 0, 0, 0, 0.6) == mavlink.MAV_RESULT_ACCEPTED
seen("it is in the air again", "LOCAL_POSITION_NED", lambda it: it.z < -0.3)
assert order(mavlink.MAV_CMD_DO_FLIGHTTERMINATION, 1.0) == mavlink.MAV_RESULT_ACCEPTED
seen("it has stopped", "HEARTBEAT", lambda it: it.system_status == mavlink.MAV_STATE_EMERGENCY)
link.mav.heartbeat_send(mavlink.MAV_TYPE_GCS, mavlink.MAV_AUTOPILOT_INVALID, 0, 0, 0)
print("flown", flush=True)
