/*
 * computer.h: the onboard software as a computer: what it does with what comes over the bus, where sensors and motors are,
 * and from the ground. What carries that is somebody else's: sockets of an operating system (unix/), or a serial line
 * (zynq/). So they cannot do different things.
 *
 * A period begins with the sensors' datagram, as it would with their interrupt, and ends with the motors'. A longer
 * datagram brings a recorded period with what was heard from the ground in it. "image" is answered with the software's
 * memory, and such an answer puts it back: only for this very program.
 *
 * SPDX-License-Identifier: MIT OR Apache-2.0
 */
#ifndef COMPUTER_H
#define COMPUTER_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "gate.h"
#include "onboard.h"
#include "packet.h"
#include "wire.h"

/** Packets that wait for their period. */
#define COMPUTER_QUEUE 64U

/** The ground, as this side of the link sees it. */
typedef struct {
    siphash_key_t key;
    gate_t gate;
    /** Who commands: whom we heard first, until nothing is heard of it. */
    uint64_t station;
    bool known;
    unsigned silent;
    packet_t waiting[COMPUTER_QUEUE];
    unsigned first;
    unsigned count;
} ground_t;

/** Everything that the software remembers. */
typedef struct {
    onboard_t onboard;
    settings_t settings;
    uint64_t count;
} image_t;

/** Bytes of the longest datagram on the bus. */
#define COMPUTER_MOST ((sizeof(image_t) > (size_t)WIRE_OUT) ? sizeof(image_t) : (size_t)WIRE_OUT)

/** The computer. */
typedef struct {
    image_t image;
    ground_t ground;
    inputs_t inputs;
    outputs_t outputs;
    onboard_step_work_t work;
    /** The answer to the last datagram of the bus. */
    uint8_t answer[COMPUTER_MOST];
    /** What goes down to the station with it, if it has a length. */
    packet_t downlink;
} computer_t;

/** The aircraft that the software can fly: `sim::aircraft` has the same numbers. */
typedef enum {
    AIRCRAFT_MAMBO = 0,
    AIRCRAFT_F550 = 1
} aircraft_t;

/** Puts the software into its initial state, for an aircraft; the key may be unset. */
void computer_begin(computer_t *computer, const siphash_key_t *key, aircraft_t aircraft);

/** Takes a datagram from the ground; `station` tells its sender from others. */
void computer_hear(computer_t *computer, uint64_t station, const uint8_t *bytes, size_t length);

/**
 * Whether a datagram of the bus begins a period: what has come from the ground is to be heard before it is taken.
 */
bool computer_is_period(size_t length);

/** Takes a datagram of the bus; how many bytes its answer has, 0 if there is none. */
size_t computer_take(computer_t *computer, const uint8_t *bytes, size_t length);

#endif
