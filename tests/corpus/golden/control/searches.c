/* The C of tests/corpus/src/programs/control/searches.rs. Written by a test. */

/* searches.c */

void searches_largest(const int32_t counts[6], option_i32_t *BESSEMER_RESTRICT result)
{
    *result = (option_i32_t){.is_some = false};
    for (uint32_t i = 0U; i < 6U; i++) {
        if (counts[i] > 0) {
            if (result->is_some) {
                if (counts[i] >= result->value) {
                    result->is_some = true;
                    result->value = counts[i];
                }
            } else {
                result->is_some = true;
                result->value = counts[i];
            }
        }
    }
}

void searches_over(const double channels[5], const double limits[5],
    option_usize_t *BESSEMER_RESTRICT result)
{
    *result = (option_usize_t){.is_some = false};
    for (uint32_t i = 0U; i < 5U; i++) {
        if (channels[i] > limits[i]) {
            result->is_some = true;
            result->value = i;
            break;
        }
    }
}

void searches_empty(const float cells[8], option_f32_t *BESSEMER_RESTRICT result)
{
    *result = (option_f32_t){.is_some = false};
    for (uint32_t i = 0U; i < 8U; i++) {
        if (cells[i] < 3.0F) {
            result->is_some = true;
            result->value = cells[i];
            break;
        }
    }
}

double searches_finite(const double values[4], double most)
{
    double sum = 0.0;
    for (uint32_t i = 0U; i < 4U; i++) {
        if (isfinite(values[i]) != 0) {
            sum += values[i];
            if (sum > most) {
                break;
            }
        }
    }
    return sum;
}

double searches_peak(const double values[8])
{
    double gathered = 0.0;
    for (uint32_t i = 0U; i < 8U; i++) {
        gathered = max_f64(gathered, fabs(values[i]));
    }
    return gathered;
}
