/* The C of tests/corpus/src/programs/control/closure_patterns.rs. Written by a test. */

/* closure_patterns.c */

static const int32_t I32_MAX = INT32_MAX;
static const int32_t I32_MIN = INT32_MIN;

uint8_t closure_patterns_good(const closure_patterns_track_t tracks[6], float limit)
{
    uint8_t bits = 0U;
    for (uint32_t i = 0U; i < 6U; i++) {
        if (tracks[i].score > limit) {
            bits = (uint8_t)(bits | ((uint32_t)1U << i));
            if (tracks[i].id == 0U) {
                break;
            }
        }
    }
    return bits;
}

void closure_patterns_next(const closure_patterns_track_t tracks[6], uint64_t after, float limit,
    option_usize_t *BESSEMER_RESTRICT result)
{
    option_pair_usize_closure_patterns_track_t find = {.is_some = false};
    for (uint32_t i = 0U; i < 6U; i++) {
        if (i > after && tracks[i].score > limit) {
            find.is_some = true;
            find.value.first = i;
            find.value.second = tracks[i];
            break;
        }
    }
    if (find.is_some) {
        result->is_some = true;
        result->value = find.value.first;
    } else {
        *result = (option_usize_t){.is_some = false};
    }
}

int64_t closure_patterns_together(const int32_t a[4], const int32_t b[4])
{
    int64_t sum = INT64_C(0);
    for (uint32_t i = 0U; i < 4U; i++) {
        if (a[i] > 0 && b[i] > 0) {
            sum ^= (int64_t)a[i] * (int64_t)b[i];
        }
    }
    return sum;
}

void closure_patterns_ends(const int32_t values[5], pair_i32_i32_t *BESSEMER_RESTRICT result)
{
    result->first = I32_MAX;
    result->second = I32_MIN;
    for (uint32_t i = 0U; i < 5U; i++) {
        const int32_t least = result->first;
        const int32_t greatest = result->second;
        result->first = min_i32(least, values[i]);
        result->second = max_i32(greatest, values[i]);
    }
}

int32_t closure_patterns_scaled(const pair_i32_i32_t *pair, const pair_i32_i32_t *other)
{
    const int32_t a = pair->first;
    const int32_t b = pair->second;
    const int32_t a_2 = other->first;
    const int32_t b_2 = other->second;
    return a ^ shift_left_i32(b, 1U) ^ (a_2 ^ shift_left_i32(b_2, 1U)) ^ 7;
}

void closure_patterns_counted(const option_u8_t *value, uint8_t n,
    triple_u8_u32_u8x3_t *BESSEMER_RESTRICT result)
{
    uint8_t first;
    if (value->is_some) {
        first = 1U;
    } else {
        first = 0U;
    }
    uint32_t sum = 0U;
    for (uint8_t i = 0U; i < n; i++) {
        sum += 2U;
    }
    for (uint32_t i = 0U; i < 3U; i++) {
        result->third[i] = n;
    }
    result->first = first;
    result->second = sum;
}

/* closure_patterns.h */

/** A track with its quality. */
typedef struct {
    uint16_t id;
    float score;
} closure_patterns_track_t;

/** `(usize, Track)`. */
typedef struct {
    uint64_t first;
    closure_patterns_track_t second;
} pair_usize_closure_patterns_track_t;

/** `Option<(usize, Track)>`: a value, or none. */
typedef struct {
    /** True if there is a value. */
    bool is_some;
    /** The value, if there is one. */
    pair_usize_closure_patterns_track_t value;
} option_pair_usize_closure_patterns_track_t;
