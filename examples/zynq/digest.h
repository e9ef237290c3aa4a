/*
 * digest.h: many words as one (FNV-1a), to compare what is too much to send. Any NaN counts as any other.
 *
 * SPDX-License-Identifier: MIT OR Apache-2.0
 */
#ifndef DIGEST_H
#define DIGEST_H

#include <stdint.h>

/** Begins anew. */
void digest_begin(void);

/** One word more. */
void digest_put(uint64_t word);

/** The digest of those since the beginning. */
uint64_t digest(void);

#endif
