/* The C of tests/corpus/src/programs/data/tuples.rs. Written by a test. */

/* programs_data_tuples.c */

/* The integer nearest to value towards zero, within its type; 0 for a NaN. */
static int32_t i32_from_f64(double value)
{
    if (isnan(value)) {
        return 0;
    }
    if (value <= -2147483648.0) {
        return INT32_MIN;
    }
    return value >= 2147483648.0 ? INT32_MAX : (int32_t)value;
}

void programs_data_tuples_unwound(double angle, pair_i32_f64_t *result)
{
    const double turns = floor(angle / 6.25);
    result->first = i32_from_f64(turns);
    result->second = angle - turns * 6.25;
}

double programs_data_tuples_together(double one, double other)
{
    pair_i32_f64_t pair;
    programs_data_tuples_unwound(one, &pair);
    pair_i32_f64_t second;
    programs_data_tuples_unwound(other, &second);
    return pair.second + second.second;
}
