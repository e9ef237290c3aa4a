/* The C of tests/corpus/src/programs/cookbook/navigation.rs. Written by a test. */

/* navigation.c */

static const double GATE = 25.0;
static const double GRAVITY = 9.81;

void navigation_advanced(const double state[12], const inertial_t *inertial, double period,
    double next[BESSEMER_RESTRICT 12])
{
    pair_f64_f64_t pair;
    sine_sin_cos(state[6], &pair);
    pair_f64_f64_t pair_2;
    sine_sin_cos(state[7], &pair_2);
    pair_f64_f64_t pair_3;
    sine_sin_cos(state[8], &pair_3);
    const double force[3] = {inertial->force[0], inertial->force[1], inertial->force[2]};

    /* The force in the plane of the ground, towards the heading and to its right, and down. */
    const double lift = pair.first * force[1] + pair.second * force[2];
    const double ahead = pair_2.second * force[0] + pair_2.first * lift;
    const double right = pair.second * force[1] - pair.first * force[2];
    const double down = pair_2.second * lift - pair_2.first * force[0];
    const double acceleration[3] = {
        pair_3.second * ahead - pair_3.first * right, pair_3.first * ahead + pair_3.second * right,
        down + GRAVITY
    };
    const double p = inertial->rate[0] - state[9];
    const double q = inertial->rate[1] - state[10];
    const double r = inertial->rate[2] - state[11];
    const double turn = (pair.first * q + pair.second * r) / pair_2.second;
    const double rates[3] = {p + pair_2.first * turn, pair.second * q - pair.first * r, turn};
    (void)memcpy(next, state, sizeof(double[12]));
    for (uint32_t axis = 0U; axis < 3U; axis++) {
        next[axis] += period * state[axis + 3U];
        next[axis + 3U] += period * acceleration[axis];
        next[axis + 6U] += period * rates[axis];
    }
}

void navigation_linearized(const double state[12], const inertial_t *inertial, double period,
    pair_vector12_f64_matrix12x12_f64_t *BESSEMER_RESTRICT result)
{
    const double sin_state_6 = sine_sin(state[6]);
    const double cos_state_6 = sine_cos(state[6]);
    const double slope = -sin_state_6;
    const double sin_state_7 = sine_sin(state[7]);
    const double cos_state_7 = sine_cos(state[7]);
    const double slope_2 = -sin_state_7;
    const double sin_state_8 = sine_sin(state[8]);
    const double cos_state_8 = sine_cos(state[8]);
    const double slope_3 = -sin_state_8;
    const double lift = sin_state_6 * inertial->force[1] + cos_state_6 * inertial->force[2];
    const double lift_d6 = inertial->force[1] * cos_state_6 + inertial->force[2] * slope;
    const double ahead = cos_state_7 * inertial->force[0] + sin_state_7 * lift;
    const double ahead_d6 = sin_state_7 * lift_d6;
    const double ahead_d7 = inertial->force[0] * slope_2 + lift * cos_state_7;
    const double right = cos_state_6 * inertial->force[1] - sin_state_6 * inertial->force[2];
    const double right_d6 = inertial->force[1] * slope - inertial->force[2] * cos_state_6;
    const double down = cos_state_7 * lift - sin_state_7 * inertial->force[0];
    const double down_d6 = cos_state_7 * lift_d6;
    const double down_d7 = lift * slope_2 - inertial->force[0] * cos_state_7;
    const double acceleration_0 = cos_state_8 * ahead - sin_state_8 * right;
    const double acceleration_0_d6 = cos_state_8 * ahead_d6 - sin_state_8 * right_d6;
    const double acceleration_0_d7 = cos_state_8 * ahead_d7;
    const double acceleration_0_d8 = ahead * slope_3 - right * cos_state_8;
    const double acceleration_1 = sin_state_8 * ahead + cos_state_8 * right;
    const double acceleration_1_d6 = sin_state_8 * ahead_d6 + cos_state_8 * right_d6;
    const double acceleration_1_d7 = sin_state_8 * ahead_d7;
    const double acceleration_1_d8 = ahead * cos_state_8 + right * slope_3;
    const double acceleration_2 = down + GRAVITY;
    const double p = inertial->rate[0] - state[9];
    const double q = inertial->rate[1] - state[10];
    const double r = inertial->rate[2] - state[11];
    const double turn = (sin_state_6 * q + cos_state_6 * r) / cos_state_7;
    const double turn_d6 = (q * cos_state_6 + r * slope) / cos_state_7;
    const double turn_d7 = -(turn * slope_2) / cos_state_7;
    const double turn_d10 = -sin_state_6 / cos_state_7;
    const double turn_d11 = -cos_state_6 / cos_state_7;
    const double rates_0 = p + sin_state_7 * turn;
    const double rates_0_d6 = sin_state_7 * turn_d6;
    const double rates_0_d7 = turn * cos_state_7 + sin_state_7 * turn_d7;
    const double rates_0_d10 = sin_state_7 * turn_d10;
    const double rates_0_d11 = sin_state_7 * turn_d11;
    const double rates_1 = cos_state_6 * q - sin_state_6 * r;
    const double rates_1_d6 = q * slope - r * cos_state_6;
    const double rates_1_d10 = -cos_state_6;
    const double next = state[0] + period * state[3];
    const double next_2 = state[3] + period * acceleration_0;
    const double next_d6 = period * acceleration_0_d6;
    const double next_d7 = period * acceleration_0_d7;
    const double next_d8 = period * acceleration_0_d8;
    const double next_3 = state[6] + period * rates_0;
    const double next_d6_2 = 1.0 + period * rates_0_d6;
    const double next_d7_2 = period * rates_0_d7;
    const double next_d9 = -period;
    const double next_d10 = period * rates_0_d10;
    const double next_d11 = period * rates_0_d11;
    const double next_4 = state[1] + period * state[4];
    const double next_5 = state[4] + period * acceleration_1;
    const double next_d6_3 = period * acceleration_1_d6;
    const double next_d7_3 = period * acceleration_1_d7;
    const double next_d8_2 = period * acceleration_1_d8;
    const double next_6 = state[7] + period * rates_1;
    const double next_d6_4 = period * rates_1_d6;
    const double next_d10_2 = period * rates_1_d10;
    const double next_d11_2 = period * sin_state_6;
    const double next_7 = state[2] + period * state[5];
    const double next_8 = state[5] + period * acceleration_2;
    const double next_d6_5 = period * down_d6;
    const double next_d7_4 = period * down_d7;
    const double next_9 = state[8] + period * turn;
    const double next_d6_6 = period * turn_d6;
    const double next_d7_5 = period * turn_d7;
    const double next_d10_3 = period * turn_d10;
    const double next_d11_3 = period * turn_d11;
    for (uint32_t i = 0U; i < 144U; i++) {
        result->second[i] = 0.0;
    }
    result->second[0 + 12 * 0] = 1.0;
    result->second[0 + 12 * 3] = period;
    result->second[1 + 12 * 1] = 1.0;
    result->second[1 + 12 * 4] = period;
    result->second[2 + 12 * 2] = 1.0;
    result->second[2 + 12 * 5] = period;
    result->second[3 + 12 * 3] = 1.0;
    result->second[3 + 12 * 6] = next_d6;
    result->second[3 + 12 * 7] = next_d7;
    result->second[3 + 12 * 8] = next_d8;
    result->second[4 + 12 * 4] = 1.0;
    result->second[4 + 12 * 6] = next_d6_3;
    result->second[4 + 12 * 7] = next_d7_3;
    result->second[4 + 12 * 8] = next_d8_2;
    result->second[5 + 12 * 5] = 1.0;
    result->second[5 + 12 * 6] = next_d6_5;
    result->second[5 + 12 * 7] = next_d7_4;
    result->second[6 + 12 * 6] = next_d6_2;
    result->second[6 + 12 * 7] = next_d7_2;
    result->second[6 + 12 * 9] = next_d9;
    result->second[6 + 12 * 10] = next_d10;
    result->second[6 + 12 * 11] = next_d11;
    result->second[7 + 12 * 6] = next_d6_4;
    result->second[7 + 12 * 7] = 1.0;
    result->second[7 + 12 * 10] = next_d10_2;
    result->second[7 + 12 * 11] = next_d11_2;
    result->second[8 + 12 * 6] = next_d6_6;
    result->second[8 + 12 * 7] = next_d7_5;
    result->second[8 + 12 * 8] = 1.0;
    result->second[8 + 12 * 10] = next_d10_3;
    result->second[8 + 12 * 11] = next_d11_3;
    result->second[9 + 12 * 9] = 1.0;
    result->second[10 + 12 * 10] = 1.0;
    result->second[11 + 12 * 11] = 1.0;
    result->first[0] = next;
    result->first[1] = next_4;
    result->first[2] = next_7;
    result->first[3] = next_2;
    result->first[4] = next_5;
    result->first[5] = next_8;
    result->first[6] = next_3;
    result->first[7] = next_6;
    result->first[8] = next_9;
    result->first[9] = state[9];
    result->first[10] = state[10];
    result->first[11] = state[11];
}

void navigation_init(navigation_t *self)
{
    for (uint32_t i = 0U; i < 12U; i++) {
        self->state[i] = 0.0;
    }
    static const double initial_elements[144] = {
        1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.1, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.1, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.1, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.01, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.01, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.01, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0001, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, 0.0001, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0001
    };
    (void)memcpy(self->covariance.elements, initial_elements, sizeof(initial_elements));
}

void navigation_predict(navigation_t *BESSEMER_RESTRICT self, const inertial_t *inertial,
    double period, navigation_predict_work_t *BESSEMER_RESTRICT work)
{
    pair_vector12_f64_matrix12x12_f64_t *const pair = &work->pair;
    navigation_linearized(self->state, inertial, period, pair);
    (void)memcpy(self->state, pair->first, sizeof(double[12]));
    symmetric_f64_12_congruence(&self->covariance, pair->second, work->numbers);
    double noise[12] = {0};
    for (uint32_t axis = 0U; axis < 3U; axis++) {
        noise[axis + 3U] = 0.01 * period;
        noise[axis + 6U] = 1e-5 * period;
        noise[axis + 9U] = 1e-8 * period;
    }
    symmetric_f64_12_add_diagonal(&self->covariance, noise);
}

uint32_t navigation_correct(navigation_t *BESSEMER_RESTRICT self, const double position[3],
    const double velocity[3])
{
    uint32_t rejected = 0U;
    for (uint32_t index = 0U; index < 6U; index++) {
        pair_f64_f64_t value_choice;
        if (index < 3U) {
            value_choice.first = position[index];
            value_choice.second = 0.25;
        } else {
            value_choice.first = velocity[(uint64_t)index - UINT64_C(3)];
            value_choice.second = 0.01;
        }
        const double measured = value_choice.first;
        const double variance = value_choice.second;
        const double innovation = measured - self->state[index];
        correction_f64_t report;
        symmetric_f64_12_correct_element(&self->covariance, self->state, index, innovation,
            variance, GATE, &report);
        if (report.status != CORRECT_STATUS_CORRECTED) {
            rejected += 1U;
        }
    }
    return rejected;
}

/* navigation.h */

/** An inertial measurement. */
typedef struct {
    /** Rate of the body, rad/s. */
    double rate[3];
    /** Specific force in the body's frame, m/s². */
    double force[3];
} inertial_t;

/** The filter. */
typedef struct {
    /** State, in the order of `advanced`. */
    double state[12];
    /** Covariance of its errors. */
    symmetric_f64_12_t covariance;
} navigation_t;

/** Working memory of its entry point; the contents are undefined between calls. */
typedef struct {
    pair_vector12_f64_matrix12x12_f64_t pair;
    double numbers[144];
} navigation_predict_work_t;
