/*
 * computer.c: see computer.h.
 *
 * SPDX-License-Identifier: MIT OR Apache-2.0
 */
#include "computer.h"

#include <string.h>

#include "receiver.h"
#include "reference_generator.h"
#include "tuning.h"

/** After so many periods without a word, another ground station is listened to. */
#define DESERTED 400U

/** STOP of models::receiver. */
#define KIND_STOP 9U

void computer_begin(computer_t *computer, const siphash_key_t *key, aircraft_t aircraft)
{
    parameters_t parameters;
    mixer_t mixer;
    memset(computer, 0, sizeof *computer);
    computer->ground.key = *key;
    gate_init(&computer->ground.gate);
    onboard_init(&computer->image.onboard);
    /* Disarmed: after a start, and after one in flight, the motors wait for somebody who arms them. */
    reference_generator_end(&computer->image.onboard.reference);
    if (aircraft == AIRCRAFT_F550) {
        settings_hexacopter(&parameters, &mixer, &computer->image.settings);
    } else {
        settings_mambo(&computer->image.settings);
    }
}

/** Puts a packet at the end of those that wait. One that stops the motors comes first: it makes the others moot. */
static void enqueue(ground_t *ground, const packet_t *packet)
{
    if (packet_kind(packet) == KIND_STOP) {
        ground->count = 0U;
    }
    if (ground->count < COMPUTER_QUEUE) {
        ground->waiting[(ground->first + ground->count) % COMPUTER_QUEUE] = *packet;
        ++ground->count;
    }
}

void computer_hear(computer_t *computer, uint64_t station, const uint8_t *bytes, size_t length)
{
    ground_t *const ground = &computer->ground;
    packet_t packet;
    packet_t inner;
    memset(&packet, 0, sizeof packet);
    /* What is longer than a packet is none, which its length tells. */
    packet.length = (uint64_t)length;
    memcpy(packet.bytes, bytes, (sizeof packet.bytes < length) ? sizeof packet.bytes : length);
    const bool stranger = ground->known && ground->silent < DESERTED && station != ground->station;
    if (stranger && packet_kind(&packet) != KIND_STOP) {
        /* It is looked at only so that it is counted: whoever it comes from, nothing moves by it. */
        gate_t other = ground->gate;
        gate_step(&other, &ground->key, &packet, &inner);
        ground->gate.refused = other.refused;
        return;
    }
    gate_step(&ground->gate, &ground->key, &packet, &inner);
    if (inner.length == 0U) {
        return;
    }
    if (!stranger && packet_is_sound(&inner)) {
        ground->station = station;
        ground->known = true;
        ground->silent = 0U;
    }
    enqueue(ground, &inner);
}

/** The packet of this period. */
static void next(ground_t *ground, packet_t *packet)
{
    if (ground->silent < DESERTED) {
        ++ground->silent;
    }
    if (ground->count == 0U) {
        packet_none(packet);
        return;
    }
    *packet = ground->waiting[ground->first];
    ground->first = (ground->first + 1U) % COMPUTER_QUEUE;
    --ground->count;
}

bool computer_is_period(size_t length)
{
    return length == (size_t)WIRE_IN;
}

size_t computer_take(computer_t *computer, const uint8_t *bytes, size_t length)
{
    image_t *const image = &computer->image;
    inputs_t *const inputs = &computer->inputs;
    outputs_t *const outputs = &computer->outputs;
    uint64_t number;
    packet_none(&computer->downlink);
    if (length == 5U && memcmp(bytes, "image", 5U) == 0) {
        memcpy(computer->answer, image, sizeof *image);
        return sizeof *image;
    }
    if (length == sizeof *image) {
        memcpy(image, bytes, sizeof *image);
        return 0U;
    }
    if (length == (size_t)WIRE_AGAIN) {
        wire_read_again(bytes, &number, inputs);
    } else if (computer_is_period(length)) {
        wire_read(bytes, &number, inputs);
        next(&computer->ground, &inputs->uplink);
        inputs->refused = computer->ground.gate.refused;
    } else {
        return 0U;
    }
    onboard_step(&image->onboard, &image->settings, inputs, &computer->work, outputs);
    (void)settings_grant(&image->settings, &outputs->wish, outputs->reference.motors);
    wire_head_t head = {number, image->count, 0U};
    if (computer->ground.known && outputs->downlink.length > 0U) {
        computer->downlink = outputs->downlink;
        head.station = computer->ground.station;
    }
    ++image->count;
    return wire_write(computer->answer, &head, inputs, outputs);
}
