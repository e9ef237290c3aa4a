/* The C of tests/corpus/src/programs/functions/taking_closures.rs. Written by a test. */

/* taking_closures.c */

static double taking_closures_root_surplus(double low, double high, double drag, double thrust);
static double taking_closures_root_in_square_root(double low, double high, double of);
static bessemer_status_t taking_closures_around_in_swept(uint8_t steps,
    uint32_t *BESSEMER_RESTRICT count, double scale, double *BESSEMER_RESTRICT sum);

double taking_closures_top_speed(double thrust, double drag)
{
    return taking_closures_root_surplus(0.0, 100.0, drag, thrust);
}

/** A zero of `f` between `low` and `high`, by bisection. */
static double taking_closures_root_surplus(double low, double high, double drag, double thrust)
{
    for (int32_t pass = 0; pass < 20; pass++) {
        const double middle = (low + high) / 2.0;
        const double value = drag * middle * middle - thrust;
        if (value == 0.0) {
            return middle;
        }
        if (value > 0.0) {
            high = middle;
        } else {
            low = middle;
        }
    }
    return (low + high) / 2.0;
}

double taking_closures_square_root(double of)
{
    return taking_closures_root_in_square_root(0.0, 1024.0, of);
}

/** A zero of `f` between `low` and `high`, by bisection. */
static double taking_closures_root_in_square_root(double low, double high, double of)
{
    for (int32_t pass = 0; pass < 20; pass++) {
        const double middle = (low + high) / 2.0;
        const double value = middle * middle - of;
        if (value == 0.0) {
            return middle;
        }
        if (value > 0.0) {
            high = middle;
        } else {
            low = middle;
        }
    }
    return (low + high) / 2.0;
}

bessemer_status_t taking_closures_swept(uint8_t steps, double scale, pair_f64_u32_t *result)
{
    bessemer_status_t status;
    double sum = 0.0;
    uint32_t count = 0U;
    status = taking_closures_around_in_swept(steps, &count, scale, &sum);
    if (status != BESSEMER_STATUS_OK) {
        return status;
    }
    result->first = sum;
    result->second = count;
    return BESSEMER_STATUS_OK;
}

/** Calls `visit` with each angle of a circle, rad. */
static bessemer_status_t taking_closures_around_in_swept(uint8_t steps,
    uint32_t *BESSEMER_RESTRICT count, double scale, double *BESSEMER_RESTRICT sum)
{
    for (uint8_t i = 0U; i < 16U; i++) {
        if (i < steps) {
            *sum += scale * ((double)i * 0.4);
            if (*count > 0xFFFFFFFEU) {
                return BESSEMER_STATUS_OVERFLOW;
            }
            *count += 1U;
        }
    }
    return BESSEMER_STATUS_OK;
}
