/* The C of tests/corpus/src/programs/data/exchanges.rs. Written by a test. */

/* exchanges.c */

void exchanges_put_in_order(limits_t *limits)
{
    if (limits->low > limits->high) {
        const double kept = limits->low;
        limits->low = limits->high;
        limits->high = kept;
    }
}

void exchanges_flip(uint8_t front[BESSEMER_RESTRICT 6], uint8_t back[BESSEMER_RESTRICT 6])
{
    uint8_t kept[6];
    (void)memcpy(kept, front, sizeof(uint8_t[6]));
    (void)memcpy(front, back, sizeof(uint8_t[6]));
    (void)memcpy(back, kept, sizeof(uint8_t[6]));
}

double exchanges_moved(double *last, double now)
{
    const double kept = *last;
    *last = now;
    const double result_choice = kept;
    return now - result_choice;
}

void exchanges_noted(option_limits_t *BESSEMER_RESTRICT note,
    option_limits_t *BESSEMER_RESTRICT result)
{
    *result = *note;
    *note = (option_limits_t){.is_some = false};
}

float exchanges_oldest(float ring[4], uint64_t count, float sample)
{
    const uint32_t place_index = (uint32_t)(count % UINT64_C(4));
    const float kept = ring[place_index];
    ring[place_index] = sample;
    return kept;
}

/* exchanges.h */

/** Limits of a range. */
typedef struct {
    double low;
    double high;
} limits_t;

/** `Option<Limits>`: a value, or none. */
typedef struct {
    /** True if there is a value. */
    bool is_some;
    /** The value, if there is one. */
    limits_t value;
} option_limits_t;
