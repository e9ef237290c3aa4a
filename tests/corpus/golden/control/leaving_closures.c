/* The C of tests/corpus/src/programs/control/leaving_closures.rs. Written by a test. */

/* leaving_closures.c */

void leaving_closures_root(double x, option_f64_t *result)
{
    if (isnan(x) != 0) {
        *result = (option_f64_t){.is_some = false};
        return;
    }
    if (x >= 0.0) {
        result->is_some = true;
        result->value = sqrt(x);
    } else {
        *result = (option_f64_t){.is_some = false};
    }
}

double leaving_closures_roots(double x, double y)
{
    option_f64_t result_choice;
    option_f64_t option;
    leaving_closures_root(x, &option);
    if (!option.is_some) {
        result_choice = (option_f64_t){.is_some = false};
    } else {
        option_f64_t y_option;
        leaving_closures_root(y, &y_option);
        if (!y_option.is_some) {
            result_choice = (option_f64_t){.is_some = false};
        } else {
            result_choice.is_some = true;
            result_choice.value = option.value + y_option.value;
        }
    }
    double result = -1.0;
    if (result_choice.is_some) {
        result = result_choice.value;
    }
    return result;
}

int32_t leaving_closures_known(const int32_t readings[6], int32_t scale)
{
    int32_t gathered = 0;
    for (uint32_t i = 0U; i < 6U; i++) {
        option_i32_t result_choice;
        option_i32_t x_option;
        math_checked_mul_i32(readings[i], scale, &x_option);
        if (!x_option.is_some) {
            result_choice = (option_i32_t){.is_some = false};
        } else {
            const int32_t x = x_option.value;
            if (x % 2 == 0) {
                result_choice = (option_i32_t){.is_some = false};
            } else {
                math_checked_add_i32(x, 1, &result_choice);
            }
        }
        if (result_choice.is_some) {
            const int32_t value = result_choice.value;
            gathered = wrap_i32((uint32_t)gathered + (uint32_t)value);
        }
    }
    return gathered;
}

uint32_t leaving_closures_first_above(const uint8_t rows[2][3], uint8_t least)
{
    uint32_t result_choice = 0U;
    bool answer_done = false;
    for (uint32_t at = 0U; at < 3U; at++) {
        if (rows[0][at] > least) {
            result_choice = at;
            answer_done = true;
            break;
        }
    }
    if (!answer_done) {
        result_choice = 9U;
    }
    const uint32_t result_left = 10U * result_choice;
    uint32_t result_choice_2 = 0U;
    bool answer_done_2 = false;
    for (uint32_t at = 0U; at < 3U; at++) {
        if (rows[1][at] > least) {
            result_choice_2 = at;
            answer_done_2 = true;
            break;
        }
    }
    if (!answer_done_2) {
        result_choice_2 = 9U;
    }
    return result_left + result_choice_2;
}

bessemer_status_t leaving_closures_by_name(const float values[4], float k,
    float *BESSEMER_RESTRICT result)
{
    float halves = -0.0F;
    for (uint32_t i = 0U; i < 4U; i++) {
        halves += k * leaving_closures_halved(values[i]);
    }
    float most = -FLT_MAX;
    for (uint32_t i = 0U; i < 4U; i++) {
        most = max_f32(most, values[i]);
    }
    float shifted[4];
    for (uint32_t i = 0U; i < 4U; i++) {
        shifted[i] = values[i] + k;
    }
    if (k == 7.0F) {
        return BESSEMER_STATUS_ASSERTION;
    }
    *result = halves + most + shifted[0];
    return BESSEMER_STATUS_OK;
}

float leaving_closures_halved(float x)
{
    return x / 2.0F;
}
