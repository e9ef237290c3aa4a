/* The C of tests/corpus/src/programs/control/best_of.rs. Written by a test. */

/* best_of.c */

void best_of_cheapest(const best_of_way_t ways[4], best_of_way_t *way)
{
    option_best_of_way_t found = {.is_some = false};
    for (uint32_t i = 0U; i < 4U; i++) {
        const option_best_of_way_t before = found;
        found.is_some = true;
        found.value = ways[i];
        uint16_t result_choice = 0U;
        uint16_t result_choice_2 = 0U;
        bool result_holds = before.is_some;
        if (result_holds) {
            result_choice = ways[i].cost;
            result_choice_2 = before.value.cost;
            result_holds = !(result_choice < result_choice_2);
        }
        if (result_holds) {
            found = before;
        }
    }
    const option_best_of_way_t result_choice = found;
    *way = ways[0];
    if (result_choice.is_some) {
        *way = result_choice.value;
    }
}

void best_of_nearest(const float values[5], float to, option_usize_t *result)
{
    option_pair_usize_f32_t found = {.is_some = false};
    for (uint32_t at = 0U; at < 5U; at++) {
        const pair_usize_f32_t pair = {.first = at, .second = values[at]};
        const option_pair_usize_f32_t before = found;
        found.is_some = true;
        found.value = pair;
        bool best_choice = false;
        bool best_holds = before.is_some;
        if (best_holds) {
            best_choice = fabsf(before.value.second - to) > fabsf(pair.second - to);
            best_holds = !best_choice;
        }
        if (best_holds) {
            found = before;
        }
    }
    const option_pair_usize_f32_t best_choice = found;
    if (!best_choice.is_some) {
        result->is_some = false;
        result->value = UINT64_C(0);
        return;
    }
    const pair_usize_f32_t best = best_choice.value;
    result->is_some = true;
    result->value = best.first;
}

void best_of_peak(const uint8_t values[5], option_usize_t *result)
{
    option_pair_usize_u8_t found = {.is_some = false};
    for (uint32_t at = 0U; at < 5U; at++) {
        const option_pair_usize_u8_t before = found;
        found.is_some = true;
        found.value.first = at;
        found.value.second = values[at];
        uint8_t result_choice = 0U;
        uint8_t result_choice_2 = 0U;
        bool result_holds = before.is_some;
        if (result_holds) {
            result_choice = values[at];
            result_choice_2 = before.value.second;
            result_holds = !(result_choice >= result_choice_2);
        }
        if (result_holds) {
            found = before;
        }
    }
    const option_pair_usize_u8_t result_choice = found;
    if (result_choice.is_some) {
        const uint64_t index = result_choice.value.first;
        result->is_some = true;
        result->value = index;
    } else {
        result->is_some = false;
        result->value = UINT64_C(0);
    }
}

/* best_of.h */

/** A way to go, and what it costs. */
typedef struct {
    uint8_t to;
    uint16_t cost;
} best_of_way_t;

/** `Option<Way>`: a value, or none. */
typedef struct {
    /** Whether there is a value. */
    bool is_some;
    /** The value, if there is one. */
    best_of_way_t value;
} option_best_of_way_t;
