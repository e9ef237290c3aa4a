/*
 * main.c: the onboard software on a bare Zynq, sensors, motors and ground at the other end of one serial line.
 *
 * A frame is a datagram of the bus or of the ground, so that what goes up in a period comes before its sensors, as on
 * sockets. `ground/src/relay.rs` is the other end.
 *
 * SPDX-License-Identifier: MIT OR Apache-2.0
 */
#include <stdbool.h>
#include <stdint.h>

#include "computer.h"
#include "link.h"
#include "uart.h"
#include "wrong.h"

/** What a frame is, its first word; what went wrong is another one (wrong.h). */
enum {
    /** From here, once at the beginning. */
    KIND_READY = 1,
    /** Whether there is a key, its halves, and the aircraft; the software begins. */
    KIND_BEGIN = 2,
    /** A datagram of the bus; back its answer, which may be empty. */
    KIND_BUS = 3,
    /** A station and a datagram, from it or to it. */
    KIND_GROUND = 4
};

/* A frame holds the longest datagram: each eight bytes take nine at most. */
typedef char longest_fits[(COMPUTER_MOST + (COMPUTER_MOST / 8U) + 64U <= LINK_MOST) ? 1 : -1];

static void begin(computer_t *computer)
{
    siphash_key_t key;
    key.is_set = link_get() != 0U;
    key.halves[0] = link_get();
    key.halves[1] = link_get();
    computer_begin(computer, &key, (link_get() == AIRCRAFT_F550) ? AIRCRAFT_F550 : AIRCRAFT_MAMBO);
}

/** A datagram from the ground. */
static void hear(computer_t *computer)
{
    /* A byte more than a packet has: what is longer is none. */
    uint8_t bytes[sizeof computer->downlink.bytes + 1U];
    const uint64_t station = link_get();
    const uint32_t length = link_get_bytes(bytes, (uint32_t)sizeof bytes);
    if (link_is_whole()) {
        computer_hear(computer, station, bytes, length);
    } else {
        wrong("a frame has not the words of a datagram from the ground");
    }
}

/** A datagram of the bus, and its answer. */
static void take(computer_t *computer)
{
    static uint8_t in[COMPUTER_MOST];
    const uint32_t length = link_get_bytes(in, (uint32_t)sizeof in);
    if (!link_is_whole()) {
        wrong("a frame has not the words of a datagram of the bus");
        return;
    }
    const size_t size = computer_take(computer, in, length);
    const packet_t *const downlink = &computer->downlink;
    if (downlink->length > 0U) {
        link_begin();
        link_put(KIND_GROUND);
        link_put(computer->ground.station);
        link_put_bytes(downlink->bytes, (uint32_t)downlink->length);
        link_send();
    }
    link_begin();
    link_put(KIND_BUS);
    link_put_bytes(computer->answer, (uint32_t)size);
    link_send();
}

int main(void)
{
    static computer_t computer;
    static const siphash_key_t none;

    computer_begin(&computer, &none, AIRCRAFT_MAMBO);
    uart_open();
    link_begin();
    link_put(KIND_READY);
    link_send();
    for (;;) {
        if (!link_receive()) {
            wrong("a frame came garbled: its checksum is wrong");
            continue;
        }
        switch (link_get()) {
        case KIND_BEGIN:
            begin(&computer);
            break;
        case KIND_BUS:
            take(&computer);
            break;
        case KIND_GROUND:
            hear(&computer);
            break;
        default:
            wrong("a frame of no known kind");
            break;
        }
    }
}
