/*
 * stack.c: see stack.h.
 *
 * SPDX-License-Identifier: MIT OR Apache-2.0
 */
#include "stack.h"

#define PAINT 0xA5A5A5A5U

/* From the linker script. */
extern const uint32_t stack_low[];
extern const uint32_t stack_high[];

uint32_t stack_end(void)
{
    return (uint32_t)(uintptr_t)stack_high;
}

uint32_t stack_size(void)
{
    return stack_end() - (uint32_t)(uintptr_t)stack_low;
}

uint32_t stack_deepest(void)
{
    const volatile uint32_t *at = stack_low;
    while (at < stack_high && *at == PAINT) {
        ++at;
    }
    return (uint32_t)(uintptr_t)at;
}
