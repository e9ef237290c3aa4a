/*
 * wrong.h: what goes wrong on the board is told over the line, in words.
 *
 * SPDX-License-Identifier: MIT OR Apache-2.0
 */
#ifndef WRONG_H
#define WRONG_H

#include <stdint.h>

/** The first word of such a frame; a word for each letter follows. No other frame begins so. */
#define KIND_WRONG 6U

/** Says what went wrong. */
void wrong(const char *why);

/** Ends here whatever the processor cannot go on with (the board's start). */
void fault(uint32_t kind, uint32_t place);

#endif
