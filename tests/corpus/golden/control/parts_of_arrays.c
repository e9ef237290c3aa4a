/* The C of tests/corpus/src/programs/control/parts_of_arrays.rs. Written by a test. */

/* parts_of_arrays.c */

double parts_of_arrays_steepest(const double values[8])
{
    double steepest = 0.0;
    for (uint32_t i = 0U; i < 7U; i++) {
        const double steepest_left = values[i + 1U];
        steepest = max_f64(steepest, fabs(steepest_left - values[i]));
    }
    return steepest;
}

void parts_of_arrays_sums(const uint16_t samples[9], uint32_t sums[BESSEMER_RESTRICT 3])
{
    for (uint32_t i = 0U; i < 3U; i++) {
        uint32_t sum = 0U;
        for (uint32_t j = i * 3U; j < i * 3U + 3U; j++) {
            sum += (uint32_t)samples[j];
        }
        sums[i] = sum;
    }
}

float parts_of_arrays_settled(const float values[10])
{
    float sum = -0.0F;
    for (uint32_t i = 2U; i < 10U; i++) {
        sum += values[i];
    }
    return sum / 8.0F;
}

uint64_t parts_of_arrays_recent(const bool flags[12])
{
    uint32_t count = 0U;
    for (uint32_t i = 12U; i-- > 8U;) {
        if (flags[i]) {
            count += 1U;
        }
    }
    return count;
}
