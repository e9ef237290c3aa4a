/* The C of tests/corpus/src/programs/data/option_methods.rs. Written by a test. */

/* option_methods.c */

void option_methods_celsius(const option_u16_t *reading, option_f64_t *BESSEMER_RESTRICT result)
{
    option_u16_t result_choice;
    if (reading->is_some && reading->value < 4095U) {
        result_choice.is_some = true;
        result_choice.value = reading->value;
    } else {
        result_choice = (option_u16_t){.is_some = false};
    }
    if (result_choice.is_some) {
        const uint16_t raw = result_choice.value;
        result->is_some = true;
        result->value = (double)raw * 0.05 - 40.0;
    } else {
        *result = (option_f64_t){.is_some = false};
    }
}

void option_methods_inverted(const option_f32_t *x, option_f32_t *BESSEMER_RESTRICT result)
{
    if (x->is_some) {
        const float x_2 = x->value;
        if (x_2 == 0.0F) {
            *result = (option_f32_t){.is_some = false};
        } else {
            result->is_some = true;
            result->value = 1.0F / x_2;
        }
    } else {
        *result = (option_f32_t){.is_some = false};
    }
}

bool option_methods_alarm(const option_f64_t *temperature, double limit)
{
    return temperature->is_some && temperature->value > limit;
}

float option_methods_chosen(const option_f32_t *one, const option_f32_t *other, float low,
    float high)
{
    option_f32_t result_choice;
    if (one->is_some) {
        result_choice.is_some = true;
        result_choice.value = one->value;
    } else {
        result_choice = *other;
    }
    if (result_choice.is_some) {
        return result_choice.value;
    } else {
        return (low + high) / 2.0F;
    }
}

float option_methods_duty(const option_u8_t *command)
{
    if (command->is_some) {
        const uint8_t percent = command->value;
        return (float)min_u8(percent, 100U) / 100.0F;
    } else {
        return 0.0F;
    }
}

void option_methods_both(const option_f64_t *position, const option_f64_t *speed,
    option_pair_f64_f64_t *BESSEMER_RESTRICT result)
{
    if (position->is_some && speed->is_some) {
        result->is_some = true;
        result->value.first = position->value;
        result->value.second = speed->value;
    } else {
        *result = (option_pair_f64_f64_t){.is_some = false};
    }
}
