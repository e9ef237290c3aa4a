/*
 * words.h: the values of the onboard software as words, in the order in which the models declare them.
 *
 * words.c and digests.c are written from the models when the firmware is built (`sim/src/board.rs`), so that they
 * follow each change of the models.
 *
 * SPDX-License-Identifier: MIT OR Apache-2.0
 */
#ifndef WORDS_H
#define WORDS_H

#include <stdint.h>

#include "onboard.h"

/** What tells these models from others: their types, and the order of their fields. */
uint64_t words_identity(void);

/** Reads the settings from the frame that came. */
void get_settings(settings_t *settings);

/** Reads the inputs from it. */
void get_inputs(inputs_t *inputs);

/** Writes a packet to the frame that goes. */
void put_packet(const packet_t *packet);

/** Adds the outputs to the digest. */
void digest_outputs(const outputs_t *outputs);

/** Adds the state to it. */
void digest_onboard(const onboard_t *onboard);

#endif
