/*
 * wire.c: see wire.h.
 *
 * SPDX-License-Identifier: MIT OR Apache-2.0
 */
#include "wire.h"

#include <stdbool.h>
#include <string.h>

/** Where the next word is. */
typedef struct {
    const uint8_t *from;
    uint8_t *to;
} cursor_t;

static uint64_t get(cursor_t *cursor)
{
    uint64_t word = 0U;
    for (unsigned n = 0U; n < 8U; ++n) {
        word |= (uint64_t)cursor->from[n] << (8U * n);
    }
    cursor->from += 8;
    return word;
}

static double get_number(cursor_t *cursor)
{
    const uint64_t word = get(cursor);
    double number;
    memcpy(&number, &word, sizeof number);
    return number;
}

static void get_numbers(cursor_t *cursor, double *numbers, size_t count)
{
    for (size_t n = 0U; n < count; ++n) {
        numbers[n] = get_number(cursor);
    }
}

static void get_counts(cursor_t *cursor, int16_t *counts, size_t count)
{
    for (size_t n = 0U; n < count; ++n) {
        const uint16_t bits = (uint16_t)(get(cursor) & 0xFFFFU);
        memcpy(&counts[n], &bits, sizeof bits);
    }
}

static void put(cursor_t *cursor, uint64_t word)
{
    for (unsigned n = 0U; n < 8U; ++n) {
        cursor->to[n] = (uint8_t)(word >> (8U * n));
    }
    cursor->to += 8;
}

static void put_number(cursor_t *cursor, double number)
{
    uint64_t word;
    memcpy(&word, &number, sizeof word);
    put(cursor, word);
}

static void put_numbers(cursor_t *cursor, const double *numbers, size_t count)
{
    for (size_t n = 0U; n < count; ++n) {
        put_number(cursor, numbers[n]);
    }
}

static void put_packet(cursor_t *cursor, const packet_t *packet)
{
    put(cursor, packet->length);
    for (size_t n = 0U; n < sizeof packet->bytes; ++n) {
        put(cursor, packet->bytes[n]);
    }
}

static void put_reference(cursor_t *cursor, const reference_t *reference)
{
    const target_t *target = &reference->target;
    put_numbers(cursor, target->position, 3U);
    put_numbers(cursor, target->velocity, 3U);
    put_numbers(cursor, target->acceleration, 2U);
    put_number(cursor, target->climb_acceleration);
    put_number(cursor, target->yaw);
    put_number(cursor, target->yaw_rate);
    put(cursor, target->take_off ? 1U : 0U);
    put(cursor, target->grounded ? 1U : 0U);
    put(cursor, target->land ? 1U : 0U);
    put(cursor, target->manual ? 1U : 0U);
    put_numbers(cursor, target->lean, 2U);
    put(cursor, (uint64_t)reference->phase);
    put(cursor, reference->motors ? 1U : 0U);
    put_number(cursor, reference->time);
}

static void put_wish(cursor_t *cursor, const wish_t *wish)
{
    put(cursor, (uint64_t)wish->request);
    put(cursor, wish->number);
    put_number(cursor, wish->value);
    put(cursor, wish->choice.tag);
    put(cursor, wish->choice.every);
    for (size_t n = 0U; n < sizeof wish->choice.signals; ++n) {
        put(cursor, wish->choice.signals[n]);
    }
}

static void get_sensors(cursor_t *cursor, uint64_t *number, inputs_t *inputs)
{
    readings_t *readings = &inputs->readings;
    *number = get(cursor);
    inputs->time = get(cursor);
    readings->inertial.fresh = get(cursor) != 0U;
    get_counts(cursor, readings->inertial.gyroscope, 3U);
    get_counts(cursor, readings->inertial.accelerometer, 3U);
    readings->echo.fresh = get(cursor) != 0U;
    readings->echo.delay = (uint32_t)(get(cursor) & 0xFFFFFFFFU);
    readings->flow.fresh = get(cursor) != 0U;
    get_counts(cursor, readings->flow.velocity, 2U);
    readings->vicon.fresh = get(cursor) != 0U;
    get_numbers(cursor, readings->vicon.position, 3U);
    get_numbers(cursor, readings->vicon.angles, 3U);
}

void wire_read(const uint8_t bytes[WIRE_IN], uint64_t *number, inputs_t *inputs)
{
    cursor_t cursor = {bytes, NULL};
    get_sensors(&cursor, number, inputs);
}

void wire_read_again(const uint8_t bytes[WIRE_AGAIN], uint64_t *number, inputs_t *inputs)
{
    cursor_t cursor = {bytes, NULL};
    get_sensors(&cursor, number, inputs);
    inputs->uplink.length = get(&cursor);
    for (size_t n = 0U; n < sizeof inputs->uplink.bytes; ++n) {
        inputs->uplink.bytes[n] = (uint8_t)(get(&cursor) & 0xFFU);
    }
    inputs->refused.unsealed = (uint32_t)(get(&cursor) & 0xFFFFFFFFU);
    inputs->refused.forged = (uint32_t)(get(&cursor) & 0xFFFFFFFFU);
    inputs->refused.replayed = (uint32_t)(get(&cursor) & 0xFFFFFFFFU);
}

size_t wire_write(uint8_t bytes[WIRE_OUT], const wire_head_t *head, const inputs_t *inputs,
    const outputs_t *outputs)
{
    cursor_t cursor = {NULL, bytes};
    put(&cursor, head->number);
    put(&cursor, head->count);
    put(&cursor, head->station);
    put_packet(&cursor, &inputs->uplink);
    put(&cursor, inputs->refused.unsealed);
    put(&cursor, inputs->refused.forged);
    put(&cursor, inputs->refused.replayed);

    put_numbers(&cursor, outputs->command.motors, 8U);
    put_numbers(&cursor, outputs->command.speeds, 8U);
    put_numbers(&cursor, outputs->command.closed_loop, 8U);
    put_numbers(&cursor, outputs->command.feed_forward, 8U);
    put_numbers(&cursor, outputs->estimate.position, 3U);
    put_numbers(&cursor, outputs->estimate.angles, 3U);
    put_numbers(&cursor, outputs->estimate.velocity, 3U);
    put_numbers(&cursor, outputs->estimate.rates, 3U);
    put_number(&cursor, outputs->ages.inertial);
    put_number(&cursor, outputs->ages.vicon);
    put_number(&cursor, outputs->ages.height);
    put_number(&cursor, outputs->ages.plane);
    put_reference(&cursor, &outputs->reference);
    put_numbers(&cursor, outputs->variances, 6U);
    put_number(&cursor, outputs->gain);
    put_wish(&cursor, &outputs->wish);
    put(&cursor, (uint64_t)outputs->alarm);
    put_packet(&cursor, &outputs->downlink);
    return (size_t)(cursor.to - bytes);
}
