/*
 * link.h: frames over the serial line, so that what comes is whole or is known not to be.
 *
 * A frame is a list of words of 64 bits, each as the number of its bytes that count (0 to 8) and these, least
 * significant first; then a CRC-32 (that of IEEE 802.3) of all that, least significant byte first. Byte stuffing (COBS)
 * takes the zeros out of it, and a zero ends it: whoever begins to listen in the middle of a frame understands the next
 * one. `src/serial.rs` is the other end.
 *
 * SPDX-License-Identifier: MIT OR Apache-2.0
 */
#ifndef LINK_H
#define LINK_H

#include <stdbool.h>
#include <stdint.h>

/** Bytes of a frame at most, its checksum with it; less, where memory is short. */
#ifndef LINK_MOST
#define LINK_MOST 32768U
#endif

/** Waits for a frame; false if what came is none: too long, cut short, or with a wrong checksum. */
bool link_receive(void);

/** The next word of the frame that came; 0 if there is none, and then it is not whole. */
uint64_t link_get(void);

/** The next bytes, which `link_put_bytes` has put there; how many. What has more than `most` is not whole. */
uint32_t link_get_bytes(uint8_t *bytes, uint32_t most);

/** Whether every word of the frame that came was read, and none too many. */
bool link_is_whole(void);

/** Begins a frame. */
void link_begin(void);

/** One word more of it. */
void link_put(uint64_t word);

/** Bytes: how many, and eight in a word, least significant first. */
void link_put_bytes(const uint8_t *bytes, uint32_t count);

/** Sends it. */
void link_send(void);

#endif
