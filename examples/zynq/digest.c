/*
 * digest.c: see digest.h.
 *
 * SPDX-License-Identifier: MIT OR Apache-2.0
 */
#include "digest.h"

/** Bits above which, the sign aside, a double is no number. */
#define INFINITE 0x7FF0000000000000U

static uint64_t sum;

void digest_begin(void)
{
    sum = 0xCBF29CE484222325U;
}

void digest_put(uint64_t word)
{
    const uint64_t plain = ((word & 0x7FFFFFFFFFFFFFFFU) > INFINITE) ? UINT64_MAX : word;
    sum = (sum ^ plain) * 0x00000100000001B3U;
}

uint64_t digest(void)
{
    return sum;
}
