/* The C of tests/corpus/src/programs/functions/references_to_values.rs. Written by a test. */

/* references_to_values.c */

uint32_t references_to_values_shared(uint32_t x)
{
    const uint32_t sum = x ^ 9U;
    const uint32_t literal = 7U;
    const uint32_t row[3] = {x, 2U, 3U};
    const uint32_t copied = x;
    const uint8_t narrow = (uint8_t)x;
    uint32_t chosen;
    if (x > 5U) {
        chosen = x;
    } else {
        chosen = 4U;
    }
    uint32_t matched;
    const uint32_t left = x % 3U;
    if (left == 0U) {
        matched = x;
    } else {
        matched = left + 10U;
    }
    const marker_t spot = {.x = x, .y = {x, 1U}};
    const marker_t marker = {.x = x, .y = {3U, x}};
    const uint32_t elements[2] = {x, 8U};
    const option_u32_t optional = {.is_some = true, .value = x};
    const uint8_t word[2] = {97U, 98U};
    const pair_u32_u8_t both = {.first = x, .second = 3U};
    x += 1U;
    const uint32_t first = sum ^ literal ^ row[0] ^ row[x % 3U] ^ ((copied << 3U) | (copied >> 29U))
        ^ (uint32_t)narrow;
    const uint32_t second_value = marker.y[1];
    const uint32_t second = chosen ^ matched ^ spot.x ^ spot.y[0]
        ^ ((second_value << 5U) | (second_value >> 27U)) ^ elements[1];
    uint32_t third_choice = 1U;
    if (optional.is_some) {
        third_choice = optional.value;
    }
    const uint32_t third = third_choice ^ (uint32_t)word[x % 2U] ^ both.first
        ^ (uint32_t)both.second;
    return first ^ ((second << 7U) | (second >> 25U)) ^ ((third << 14U) | (third >> 18U)) ^ x;
}

uint32_t references_to_values_exclusive(uint32_t x)
{
    uint32_t sum = x ^ 9U;
    sum += x;
    uint32_t copied = x;
    copied ^= 3U;
    uint32_t row[3] = {x, 2U, 3U};
    row[x % 3U] ^= copied;
    const uint32_t before = row[0];
    row[0] = row[1];
    row[1] = before;
    marker_t spot = {.x = x, .y = {x, 1U}};
    spot.y[1] = spot.x * 3U;
    marker_t marker = {.x = x, .y = {3U, x}};
    const uint32_t kept = marker.x;
    marker.x = sum;
    sum = kept;
    option_u32_t optional = {.is_some = true, .value = x};
    if (optional.is_some) {
        optional.value = (optional.value << 2U) | (optional.value >> 30U);
    }
    const option_u32_t taken_before = optional;
    optional = (option_u32_t){.is_some = false};
    uint32_t taken = 0U;
    if (taken_before.is_some) {
        taken = taken_before.value;
    }
    const uint32_t result_value = row[0];
    return sum ^ ((marker.x << 3U) | (marker.x >> 29U))
        ^ ((result_value << 6U) | (result_value >> 26U)) ^ row[1] ^ spot.y[1] ^ taken
        ^ ((copied << 9U) | (copied >> 23U)) ^ x;
}

uint32_t references_to_values_repeated(uint32_t x)
{
    uint32_t sum = x;
    for (uint32_t k = 0U; k < 4U; k++) {
        uint32_t count = k * sum;
        const uint32_t limit = (sum % 5U) + 1U;
        count += 1U;
        sum += count % limit;
    }
    return sum;
}

void references_to_values_init(references_to_values_t *self)
{
    self->last = 0U;
}

uint32_t references_to_values_step(references_to_values_t *self, uint32_t x)
{
    const uint32_t selector = self->last + x;
    const uint32_t last_shared = references_to_values_shared(selector);
    const uint32_t last_exclusive = references_to_values_exclusive(x);
    self->last = last_shared ^ ((last_exclusive << 1U) | (last_exclusive >> 31U))
        ^ references_to_values_repeated(x % 1000U);
    return self->last ^ selector;
}

/* references_to_values.h */

/** A point. */
typedef struct {
    uint32_t x;
    uint32_t y[2];
} marker_t;

/** Calls both. */
typedef struct {
    uint32_t last;
} references_to_values_t;
