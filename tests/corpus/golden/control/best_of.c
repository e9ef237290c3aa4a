/* The C of tests/corpus/src/programs/control/best_of.rs. Written by a test. */

/* best_of.c */

void best_of_cheapest(const best_of_way_t ways[4], best_of_way_t *BESSEMER_RESTRICT way)
{
    option_best_of_way_t found = {.is_some = false};
    option_u16_t least = {.is_some = false};
    for (uint32_t i = 0U; i < 4U; i++) {
        const uint16_t key = ways[i].cost;
        if (least.is_some) {
            if (key < least.value) {
                least.is_some = true;
                least.value = key;
                found.is_some = true;
                found.value = ways[i];
            }
        } else {
            least.is_some = true;
            least.value = key;
            found.is_some = true;
            found.value = ways[i];
        }
    }
    *way = ways[0];
    if (found.is_some) {
        *way = found.value;
    }
}

void best_of_nearest(const float values[5], float to, option_usize_t *BESSEMER_RESTRICT result)
{
    option_pair_usize_f32_t best = {.is_some = false};
    for (uint32_t i = 0U; i < 5U; i++) {
        if (best.is_some) {
            const pair_usize_f32_t b = {.first = i, .second = values[i]};
            if (fabsf(best.value.second - to) > fabsf(b.second - to)) {
                best.is_some = true;
                best.value.first = i;
                best.value.second = values[i];
            }
        } else {
            best.is_some = true;
            best.value.first = i;
            best.value.second = values[i];
        }
    }
    if (!best.is_some) {
        *result = (option_usize_t){.is_some = false};
        return;
    }
    result->is_some = true;
    result->value = best.value.first;
}

void best_of_peak(const uint8_t values[5], option_usize_t *BESSEMER_RESTRICT result)
{
    option_pair_usize_u8_t found = {.is_some = false};
    option_u8_t largest = {.is_some = false};
    for (uint32_t i = 0U; i < 5U; i++) {
        const uint8_t key = values[i];
        if (largest.is_some) {
            if (key >= largest.value) {
                largest.is_some = true;
                largest.value = key;
                found.is_some = true;
                found.value.first = i;
                found.value.second = values[i];
            }
        } else {
            largest.is_some = true;
            largest.value = key;
            found.is_some = true;
            found.value.first = i;
            found.value.second = values[i];
        }
    }
    if (found.is_some) {
        result->is_some = true;
        result->value = found.value.first;
    } else {
        *result = (option_usize_t){.is_some = false};
    }
}

/* best_of.h */

/** A route and its cost. */
typedef struct {
    uint8_t to;
    uint16_t cost;
} best_of_way_t;

/** `Option<Way>`: a value, or none. */
typedef struct {
    /** True if there is a value. */
    bool is_some;
    /** The value, if there is one. */
    best_of_way_t value;
} option_best_of_way_t;
