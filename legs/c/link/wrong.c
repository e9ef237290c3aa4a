/*
 * wrong.c: see wrong.h.
 *
 * SPDX-License-Identifier: MIT OR Apache-2.0
 */
#include "wrong.h"

#include "link.h"

static void say(const char *text)
{
    for (const char *letter = text; *letter != '\0'; ++letter) {
        link_put((uint64_t)(uint8_t)*letter);
    }
}

void wrong(const char *why)
{
    link_begin();
    link_put(KIND_WRONG);
    say(why);
    link_send();
}

void fault(uint32_t kind, uint32_t place)
{
    static const char *const kinds[3] = {
        "an undefined instruction at 0x", "a prefetch abort at 0x", "a data abort at 0x"};
    static const char digits[] = "0123456789abcdef";
    link_begin();
    link_put(KIND_WRONG);
    say(kinds[kind % 3U]);
    for (uint32_t n = 0U; n < 8U; ++n) {
        link_put((uint64_t)(uint8_t)digits[(place >> (28U - (4U * n))) & 0xFU]);
    }
    link_send();
    for (;;) {
    }
}
