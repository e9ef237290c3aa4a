/*
 * link.c: see link.h.
 *
 * SPDX-License-Identifier: MIT OR Apache-2.0
 */
#include "link.h"

#include "uart.h"

/** Bytes that a block of byte stuffing holds. */
#define BLOCK 254U

/** Bytes of the checksum. */
#define CHECKSUM 4U

/** A frame on its way in or out. */
typedef struct {
    uint8_t bytes[LINK_MOST];
    uint32_t length;
    /** Where the next word is read. */
    uint32_t at;
    /** Whether more was written than there is room for, or read than there is. */
    bool overrun;
} frame_t;

static frame_t in;
static frame_t out;

/** CRC-32 of IEEE 802.3, four bits at a time. */
static uint32_t checksum(const uint8_t *bytes, uint32_t length)
{
    static const uint32_t table[16] = {
        0x00000000U, 0x1DB71064U, 0x3B6E20C8U, 0x26D930ACU, 0x76DC4190U, 0x6B6B51F4U, 0x4DB26158U, 0x5005713CU,
        0xEDB88320U, 0xF00F9344U, 0xD6D6A3E8U, 0xCB61B38CU, 0x9B64C2B0U, 0x86D3D2D4U, 0xA00AE278U, 0xBDBDF21CU};
    uint32_t sum = 0xFFFFFFFFU;
    for (uint32_t n = 0U; n < length; ++n) {
        sum ^= bytes[n];
        sum = (sum >> 4U) ^ table[sum & 0xFU];
        sum = (sum >> 4U) ^ table[sum & 0xFU];
    }
    return ~sum;
}

/** Takes the byte stuffing out, in place; false if a block ends beyond the frame. */
static bool unstuff(frame_t *frame)
{
    uint32_t from = 0U;
    uint32_t to = 0U;
    while (from < frame->length) {
        const uint32_t block = (uint32_t)frame->bytes[from] - 1U;
        ++from;
        if (block > frame->length - from) {
            return false;
        }
        for (uint32_t n = 0U; n < block; ++n) {
            frame->bytes[to] = frame->bytes[from];
            ++to;
            ++from;
        }
        if (block < BLOCK && from < frame->length) {
            frame->bytes[to] = 0U;
            ++to;
        }
    }
    frame->length = to;
    return true;
}

bool link_receive(void)
{
    in.length = 0U;
    in.at = 0U;
    in.overrun = false;
    /* Zeros before a frame say nothing. */
    uint8_t byte = 0U;
    while (byte == 0U) {
        byte = uart_get();
    }
    while (byte != 0U) {
        if (in.length < LINK_MOST) {
            in.bytes[in.length] = byte;
            ++in.length;
        } else {
            in.overrun = true;
        }
        byte = uart_get();
    }
    if (in.overrun || !unstuff(&in) || in.length < CHECKSUM) {
        return false;
    }
    in.length -= CHECKSUM;
    const uint8_t *const sent = &in.bytes[in.length];
    const uint32_t sum = (uint32_t)sent[0] | ((uint32_t)sent[1] << 8U) | ((uint32_t)sent[2] << 16U) |
                         ((uint32_t)sent[3] << 24U);
    return sum == checksum(in.bytes, in.length);
}

static uint8_t next(void)
{
    if (in.at >= in.length) {
        in.overrun = true;
        return 0U;
    }
    const uint8_t byte = in.bytes[in.at];
    ++in.at;
    return byte;
}

uint64_t link_get(void)
{
    const uint32_t count = next();
    uint64_t word = 0U;
    if (count > 8U) {
        in.overrun = true;
        return 0U;
    }
    for (uint32_t n = 0U; n < count; ++n) {
        word |= (uint64_t)next() << (8U * n);
    }
    return word;
}

uint32_t link_get_bytes(uint8_t *bytes, uint32_t most)
{
    const uint64_t count = link_get();
    if (count > most) {
        in.overrun = true;
        return 0U;
    }
    uint64_t word = 0U;
    for (uint32_t n = 0U; n < count; ++n) {
        word = ((n % 8U) == 0U) ? link_get() : (word >> 8U);
        bytes[n] = (uint8_t)(word & 0xFFU);
    }
    return (uint32_t)count;
}

bool link_is_whole(void)
{
    return !in.overrun && in.at == in.length;
}

void link_begin(void)
{
    out.length = 0U;
    out.overrun = false;
}

static void append(uint8_t byte)
{
    if (out.length < LINK_MOST) {
        out.bytes[out.length] = byte;
        ++out.length;
    } else {
        out.overrun = true;
    }
}

void link_put(uint64_t word)
{
    uint32_t count = 0U;
    for (uint64_t rest = word; rest != 0U; rest >>= 8U) {
        ++count;
    }
    append((uint8_t)count);
    for (uint32_t n = 0U; n < count; ++n) {
        append((uint8_t)((word >> (8U * n)) & 0xFFU));
    }
}

void link_put_bytes(const uint8_t *bytes, uint32_t count)
{
    link_put(count);
    for (uint32_t at = 0U; at < count; at += 8U) {
        uint64_t word = 0U;
        for (uint32_t n = 0U; n < 8U && at + n < count; ++n) {
            word |= (uint64_t)bytes[at + n] << (8U * n);
        }
        link_put(word);
    }
}

void link_send(void)
{
    uint32_t sum = checksum(out.bytes, out.length);
    if (out.overrun) {
        /* What is cut short is not to pass for whole. */
        sum = ~sum;
        out.length = LINK_MOST - CHECKSUM;
    }
    for (uint32_t n = 0U; n < CHECKSUM; ++n) {
        append((uint8_t)((sum >> (8U * n)) & 0xFFU));
    }
    uint32_t from = 0U;
    bool more = true;
    while (more) {
        uint32_t block = 0U;
        while (block < BLOCK && from + block < out.length && out.bytes[from + block] != 0U) {
            ++block;
        }
        uart_put((uint8_t)(block + 1U));
        for (uint32_t n = 0U; n < block; ++n) {
            uart_put(out.bytes[from + n]);
        }
        from += block;
        more = from < out.length;
        if (block < BLOCK) {
            /* The zero that ends this block. */
            ++from;
        }
    }
    uart_put(0U);
}
