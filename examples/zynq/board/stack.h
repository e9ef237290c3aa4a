/*
 * stack.h: how deep the stack was used. It is filled with a pattern; where the pattern is gone, it was used.
 *
 * SPDX-License-Identifier: MIT OR Apache-2.0
 */
#ifndef STACK_H
#define STACK_H

#include <stdint.h>

/** Fills the stack below its caller with a pattern; the address from which on down it did (start.S). */
uint32_t stack_paint(void);

/** The lowest address that was used since. */
uint32_t stack_deepest(void);

/** The end of the stack. */
uint32_t stack_end(void);

/** Bytes of the stack. */
uint32_t stack_size(void);

#endif
