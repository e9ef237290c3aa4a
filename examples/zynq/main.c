/*
 * main.c: the whole onboard software on a bare Zynq, in lockstep with an aircraft at the other end of the serial line.
 *
 * A period begins with a frame of what comes in and ends with the frame of what goes out: the aircraft waits for it. So
 * the software runs here as it would from a timer's interrupt, and every bit of it can be compared. Each answer begins with the kind of
 * what it answers; a frame that is not understood is answered with a text.
 *
 * SPDX-License-Identifier: MIT OR Apache-2.0
 */
#include <stdbool.h>
#include <stdint.h>
#include <string.h>

#include "digest.h"
#include "link.h"
#include "onboard.h"
#include "stack.h"
#include "uart.h"
#include "words.h"
#include "wrong.h"

/** What a frame is, its first word; what went wrong is another one (wrong.h). `legs/src/lockstep.rs` has the other end. */
enum {
    /** From here, once at the beginning: the identity of the models. */
    KIND_READY = 1,
    /** The software begins anew. */
    KIND_BEGIN = 2,
    /** Settings, for the periods that follow. */
    KIND_SETTINGS = 3,
    /** The period's number and the inputs; back what `answer` says. */
    KIND_STEP = 4,
    /** Back how deep the stack was used. */
    KIND_REPORT = 5
};

/** How deep the stack was used, bytes. */
typedef struct {
    /** By the call of the onboard software. */
    uint32_t step;
    /** By all of the program. */
    uint32_t all;
} used_t;

static uint32_t larger(uint32_t one, uint32_t other)
{
    return (one > other) ? one : other;
}

/**
 * Answers a period with its number, what aircraft and ground take of the outputs (the motors' speeds, the packet), and
 * a digest of all outputs and of the state: a line of 921 600 baud has room for no more in real time.
 */
static void answer(uint64_t number, const outputs_t *outputs, const onboard_t *onboard)
{
    link_begin();
    link_put(KIND_STEP);
    link_put(number);
    for (uint32_t n = 0U; n < 8U; ++n) {
        uint64_t word;
        (void)memcpy(&word, &outputs->command.speeds[n], sizeof word);
        link_put(word);
    }
    put_packet(&outputs->downlink);
    digest_begin();
    digest_outputs(outputs);
    digest_onboard(onboard);
    link_put(digest());
    link_send();
}

/** One period of the onboard software, whose stack is watched. */
static void step(onboard_t *onboard, const settings_t *settings, used_t *used)
{
    static inputs_t inputs;
    static outputs_t outputs;
    static onboard_step_work_t work;
    const uint64_t number = link_get();
    get_inputs(&inputs);
    if (!link_is_whole()) {
        wrong("a frame has not the words of a period");
        return;
    }

    used->all = larger(used->all, stack_end() - stack_deepest());
    const uint32_t from = stack_paint();
    onboard_step(onboard, settings, &inputs, &work, &outputs);
    const uint32_t deepest = stack_deepest();
    used->step = larger(used->step, from - deepest);
    used->all = larger(used->all, stack_end() - deepest);
    if (used->all >= stack_size()) {
        wrong("the stack is used up");
        return;
    }
    answer(number, &outputs, onboard);
}

/** An answer without words. */
static void confirm(uint64_t kind)
{
    link_begin();
    link_put(kind);
    link_send();
}

static void report(const used_t *used)
{
    link_begin();
    link_put(KIND_REPORT);
    link_put(used->step);
    link_put(used->all);
    link_put(stack_size());
    link_send();
}

int main(void)
{
    static onboard_t onboard;
    static settings_t settings;
    static used_t used;

    uart_open();
    link_begin();
    link_put(KIND_READY);
    link_put(words_identity());
    link_send();
    for (;;) {
        if (!link_receive()) {
            wrong("a frame came garbled: its checksum is wrong");
            continue;
        }
        switch (link_get()) {
        case KIND_BEGIN:
            onboard_init(&onboard);
            confirm(KIND_BEGIN);
            break;
        case KIND_SETTINGS:
            get_settings(&settings);
            if (link_is_whole()) {
                confirm(KIND_SETTINGS);
            } else {
                wrong("a frame has not the words of the settings");
            }
            break;
        case KIND_STEP:
            step(&onboard, &settings, &used);
            break;
        case KIND_REPORT:
            report(&used);
            break;
        default:
            wrong("a frame of no known kind");
            break;
        }
    }
}
