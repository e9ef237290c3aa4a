/* The C of tests/corpus/src/programs/data/tuples.rs. Written by a test. */

/* programs_data_tuples.c */

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
