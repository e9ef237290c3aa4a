/* The C of tests/corpus/src/programs/functions/references.rs. Written by a test. */

/* references.c */

void references_take(moments_t *moments, double value)
{
    moments->count += 1U;
    moments->sum += value;
    moments->squares += value * value;
}

double references_mean(const moments_t *moments)
{
    if (moments->count == 0U) {
        return 0.0;
    } else {
        return moments->sum / (double)moments->count;
    }
}

double references_take_both(moments_t *BESSEMER_RESTRICT moments, const double values[2])
{
    references_take(moments, values[0]);
    references_take(moments, values[1]);
    return references_mean(moments);
}

/* references.h */

/** Sums for a mean and a variance. */
typedef struct {
    uint32_t count;
    double sum;
    double squares;
} moments_t;
