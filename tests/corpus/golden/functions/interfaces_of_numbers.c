/* The C of tests/corpus/src/programs/functions/interfaces_of_numbers.rs. Written by a test. */

/* interfaces_of_numbers.c */

double interfaces_of_numbers_f64_without_middle(double self, double width)
{
    if (fabs(self) < width) {
        return 0.0;
    } else {
        return self;
    }
}

double interfaces_of_numbers_f64_doubled(double self)
{
    return self * 2.0;
}

bessemer_status_t interfaces_of_numbers_i16_without_middle(int16_t self, int16_t width,
    int16_t *result)
{
    if (width == INT16_MIN) {
        return BESSEMER_STATUS_OVERFLOW;
    }
    const int16_t low = (int16_t)(-width);
    const int16_t high = width;
    const bool result_choice = low <= self && self <= high;
    if (result_choice) {
        *result = 0;
        return BESSEMER_STATUS_OK;
    } else {
        *result = self;
        return BESSEMER_STATUS_OK;
    }
}

int16_t interfaces_of_numbers_i16_doubled(int16_t self)
{
    return saturating_mul_i16(self, 2);
}

void interfaces_of_numbers_f64_mul_metres(double self, const interfaces_of_numbers_metres_t *length,
    interfaces_of_numbers_metres_t *BESSEMER_RESTRICT metres)
{
    metres->value = self * length->value;
}

void interfaces_of_numbers_f64_mul_seconds(double self, const seconds_t *time,
    seconds_t *BESSEMER_RESTRICT seconds)
{
    seconds->value = self * time->value;
}

void interfaces_of_numbers_i32_mul_metres(int32_t self,
    const interfaces_of_numbers_metres_t *length,
    interfaces_of_numbers_metres_t *BESSEMER_RESTRICT metres)
{
    interfaces_of_numbers_f64_mul_metres((double)self, length, metres);
}

double interfaces_of_numbers_metres_div_seconds(const interfaces_of_numbers_metres_t *self,
    const seconds_t *time)
{
    return self->value / time->value;
}

double interfaces_of_numbers_f64_from_metres(const interfaces_of_numbers_metres_t *length)
{
    return length->value;
}

double interfaces_of_numbers_meant_f64(double stick, double width)
{
    return interfaces_of_numbers_f64_without_middle(interfaces_of_numbers_f64_doubled(stick),
        width);
}

bessemer_status_t interfaces_of_numbers_meant_i16(int16_t stick, int16_t width, int16_t *result)
{
    bessemer_status_t status;
    status = interfaces_of_numbers_i16_without_middle(interfaces_of_numbers_i16_doubled(stick),
        width, result);
    if (status != BESSEMER_STATUS_OK) {
        return status;
    }
    return BESSEMER_STATUS_OK;
}

bessemer_status_t interfaces_of_numbers_sticks(double fine, int16_t coarse, double *result)
{
    bessemer_status_t status;
    int16_t result_meant_i16;
    status = interfaces_of_numbers_meant_i16(coarse, 10, &result_meant_i16);
    if (status != BESSEMER_STATUS_OK) {
        return status;
    }
    *result = interfaces_of_numbers_meant_f64(fine, 0.25) + (double)result_meant_i16
        + interfaces_of_numbers_f64_doubled(fine);
    return BESSEMER_STATUS_OK;
}

double interfaces_of_numbers_speed(const interfaces_of_numbers_metres_t *step, int32_t count,
    const seconds_t *period)
{
    interfaces_of_numbers_metres_t way_length;
    interfaces_of_numbers_i32_mul_metres(count, step, &way_length);
    interfaces_of_numbers_metres_t way;
    interfaces_of_numbers_f64_mul_metres(0.5, &way_length, &way);
    seconds_t result_time;
    interfaces_of_numbers_f64_mul_seconds(2.0, period, &result_time);
    return interfaces_of_numbers_metres_div_seconds(&way, &result_time);
}

double interfaces_of_numbers_number(const interfaces_of_numbers_metres_t *length)
{
    const double number = interfaces_of_numbers_f64_from_metres(length);
    interfaces_of_numbers_metres_t result_length;
    interfaces_of_numbers_f64_mul_metres(2.0, length, &result_length);
    const double result_f64_from_metres = interfaces_of_numbers_f64_from_metres(&result_length);
    return number + result_f64_from_metres;
}

bool interfaces_of_numbers_u16_step(uint16_t *self, uint8_t by)
{
    *self = (uint16_t)((uint32_t)*self + (uint32_t)by);
    return *self > 1000U;
}

bool interfaces_of_numbers_counted(uint16_t *counter, uint8_t by)
{
    const bool often = interfaces_of_numbers_u16_step(counter, by);
    bool result = false;
    if (often) {
        result = interfaces_of_numbers_u16_step(counter, 1U);
    }
    return result;
}

/* interfaces_of_numbers.h */

/** A length, m. */
typedef struct {
    double value;
} interfaces_of_numbers_metres_t;

/** A time, s. */
typedef struct {
    double value;
} seconds_t;
