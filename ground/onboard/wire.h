/*
 * wire.h: what goes over the bus between the aircraft and its computer, as words of 64 bits, least significant
 * byte first, in the order in which the models declare it.
 *
 * SPDX-License-Identifier: MIT OR Apache-2.0
 */
#ifndef WIRE_H
#define WIRE_H

#include <stddef.h>
#include <stdint.h>

#include "onboard.h"

/** Bytes of what comes: the period's number, the clock, the sensors. */
#define WIRE_IN (21 * 8)

/** Bytes of a recorded period: the same, a packet, and what the gate had kept out. */
#define WIRE_AGAIN ((21 + 65 + 3) * 8)

/** The most bytes of what goes: the head, what was heard, the outputs. */
#define WIRE_OUT 4096

/** Reads the period's number and what is sensed in it. */
void wire_read(const uint8_t bytes[WIRE_IN], uint64_t *number, inputs_t *inputs);

/** Reads a recorded period. */
void wire_read_again(const uint8_t bytes[WIRE_AGAIN], uint64_t *number, inputs_t *inputs);

/** Head of an answer, before inputs and outputs. */
typedef struct {
    /** The period's number. */
    uint64_t number;
    /** How many periods there were. */
    uint64_t count;
    /** The station to which a packet goes down in this period; 0 if no packet does. */
    uint64_t station;
} wire_head_t;

/** Writes the answer; how many bytes it has. */
size_t wire_write(uint8_t bytes[WIRE_OUT], const wire_head_t *head, const inputs_t *inputs,
    const outputs_t *outputs);

#endif
