/* The C of tests/corpus/src/programs/data/comparisons.rs. Written by a test. */

/* comparisons.c */

bool comparisons_is_new(const target_t *before, const target_t *now)
{
    return !target_equal(before, now);
}

bool comparisons_same_plan(const target_t one[6], const target_t other[6])
{
    bool result_equal = true;
    for (uint32_t i = 0U; i < 6U; i++) {
        if (!target_equal(&one[i], &other[i])) {
            result_equal = false;
            break;
        }
    }
    return result_equal;
}

/* comparisons.h */

/** Destination. */
typedef struct {
    double position[3];
    bool land;
} target_t;
