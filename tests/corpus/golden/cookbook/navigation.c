/* The C of tests/corpus/src/programs/cookbook/navigation.rs. Written by a test. */

/* navigation.c */

static const double GATE = 52.0;
static const double GRAVITY = 9.81;

static void navigation_predicted(const double state[12], const inertial_t *inertial, double period,
    symmetric_f64_12_t *BESSEMER_RESTRICT covariance, double next[12]);

void navigation_advanced(const double state[12], const inertial_t *inertial, double period,
    double next[BESSEMER_RESTRICT 12])
{
    pair_f64_f64_t sin_roll_cos_roll;
    sine_sin_cos(state[6], &sin_roll_cos_roll);
    pair_f64_f64_t sin_pitch_cos_pitch;
    sine_sin_cos(state[7], &sin_pitch_cos_pitch);
    pair_f64_f64_t sin_yaw_cos_yaw;
    sine_sin_cos(state[8], &sin_yaw_cos_yaw);
    const double force[3] = {inertial->force[0], inertial->force[1], inertial->force[2]};

    /* The force in the plane of the ground, towards the heading and to its right, and down. */
    const double lift = sin_roll_cos_roll.first * force[1] + sin_roll_cos_roll.second * force[2];
    const double ahead = sin_pitch_cos_pitch.second * force[0] + sin_pitch_cos_pitch.first * lift;
    const double right = sin_roll_cos_roll.second * force[1] - sin_roll_cos_roll.first * force[2];
    const double down = sin_pitch_cos_pitch.second * lift - sin_pitch_cos_pitch.first * force[0];
    const double acceleration[3] = {
        sin_yaw_cos_yaw.second * ahead - sin_yaw_cos_yaw.first * right,
        sin_yaw_cos_yaw.first * ahead + sin_yaw_cos_yaw.second * right, down + GRAVITY
    };
    const double p = inertial->rate[0] - state[9];
    const double q = inertial->rate[1] - state[10];
    const double r = inertial->rate[2] - state[11];
    const double turn = (sin_roll_cos_roll.first * q + sin_roll_cos_roll.second * r)
        / sin_pitch_cos_pitch.second;
    const double rates[3] = {
        p + sin_pitch_cos_pitch.first * turn,
        sin_roll_cos_roll.second * q - sin_roll_cos_roll.first * r, turn
    };
    (void)memcpy(next, state, sizeof(double[12]));
    for (uint32_t axis = 0U; axis < 3U; axis++) {
        next[axis] += period * state[axis + 3U];
        next[axis + 3U] += period * acceleration[axis];
        next[axis + 6U] += period * rates[axis];
    }
}

/**
 * The state after one period; `covariance` becomes the covariance of its errors.
 * `next` may be `state`: nothing is read after it is written.
 */
static void navigation_predicted(const double state[12], const inertial_t *inertial, double period,
    symmetric_f64_12_t *BESSEMER_RESTRICT covariance, double next[12])
{
    pair_f64_f64_t sin_cos_state_6;
    sine_sin_cos(state[6], &sin_cos_state_6);
    const double slope = -sin_cos_state_6.first;
    pair_f64_f64_t sin_cos_state_7;
    sine_sin_cos(state[7], &sin_cos_state_7);
    const double slope_2 = -sin_cos_state_7.first;
    pair_f64_f64_t sin_cos_state_8;
    sine_sin_cos(state[8], &sin_cos_state_8);
    const double slope_3 = -sin_cos_state_8.first;
    const double lift = sin_cos_state_6.first * inertial->force[1]
        + sin_cos_state_6.second * inertial->force[2];
    const double lift_d6 = inertial->force[1] * sin_cos_state_6.second + inertial->force[2] * slope;
    const double ahead = sin_cos_state_7.second * inertial->force[0] + sin_cos_state_7.first * lift;
    const double ahead_d6 = sin_cos_state_7.first * lift_d6;
    const double ahead_d7 = inertial->force[0] * slope_2 + lift * sin_cos_state_7.second;
    const double right = sin_cos_state_6.second * inertial->force[1]
        - sin_cos_state_6.first * inertial->force[2];
    const double right_d6 = inertial->force[1] * slope
        - inertial->force[2] * sin_cos_state_6.second;
    const double down = sin_cos_state_7.second * lift - sin_cos_state_7.first * inertial->force[0];
    const double down_d6 = sin_cos_state_7.second * lift_d6;
    const double down_d7 = lift * slope_2 - inertial->force[0] * sin_cos_state_7.second;
    const double acceleration_0 = sin_cos_state_8.second * ahead - sin_cos_state_8.first * right;
    const double acceleration_0_d6 = sin_cos_state_8.second * ahead_d6
        - sin_cos_state_8.first * right_d6;
    const double acceleration_0_d7 = sin_cos_state_8.second * ahead_d7;
    const double acceleration_0_d8 = ahead * slope_3 - right * sin_cos_state_8.second;
    const double acceleration_1 = sin_cos_state_8.first * ahead + sin_cos_state_8.second * right;
    const double acceleration_1_d6 = sin_cos_state_8.first * ahead_d6
        + sin_cos_state_8.second * right_d6;
    const double acceleration_1_d7 = sin_cos_state_8.first * ahead_d7;
    const double acceleration_1_d8 = ahead * sin_cos_state_8.second + right * slope_3;
    const double acceleration_2 = down + GRAVITY;
    const double p = inertial->rate[0] - state[9];
    const double q = inertial->rate[1] - state[10];
    const double r = inertial->rate[2] - state[11];
    const double turn = (sin_cos_state_6.first * q + sin_cos_state_6.second * r)
        / sin_cos_state_7.second;
    const double turn_d6 = (q * sin_cos_state_6.second + r * slope) / sin_cos_state_7.second;
    const double turn_d7 = -(turn * slope_2) / sin_cos_state_7.second;
    const double turn_d10 = -sin_cos_state_6.first / sin_cos_state_7.second;
    const double turn_d11 = -sin_cos_state_6.second / sin_cos_state_7.second;
    const double rates_0 = p + sin_cos_state_7.first * turn;
    const double rates_0_d6 = sin_cos_state_7.first * turn_d6;
    const double rates_0_d7 = turn * sin_cos_state_7.second + sin_cos_state_7.first * turn_d7;
    const double rates_0_d10 = sin_cos_state_7.first * turn_d10;
    const double rates_0_d11 = sin_cos_state_7.first * turn_d11;
    const double rates_1 = sin_cos_state_6.second * q - sin_cos_state_6.first * r;
    const double rates_1_d6 = q * slope - r * sin_cos_state_6.second;
    const double rates_1_d10 = -sin_cos_state_6.second;
    const double next_0 = state[0] + period * state[3];
    const double next_3 = state[3] + period * acceleration_0;
    const double next_3_d6 = period * acceleration_0_d6;
    const double next_3_d7 = period * acceleration_0_d7;
    const double next_3_d8 = period * acceleration_0_d8;
    const double next_6 = state[6] + period * rates_0;
    const double next_6_d6 = 1.0 + period * rates_0_d6;
    const double next_6_d7 = period * rates_0_d7;
    const double next_6_d9 = -period;
    const double next_6_d10 = period * rates_0_d10;
    const double next_6_d11 = period * rates_0_d11;
    const double next_1 = state[1] + period * state[4];
    const double next_4 = state[4] + period * acceleration_1;
    const double next_4_d6 = period * acceleration_1_d6;
    const double next_4_d7 = period * acceleration_1_d7;
    const double next_4_d8 = period * acceleration_1_d8;
    const double next_7 = state[7] + period * rates_1;
    const double next_7_d6 = period * rates_1_d6;
    const double next_7_d10 = period * rates_1_d10;
    const double next_7_d11 = period * sin_cos_state_6.first;
    const double next_2 = state[2] + period * state[5];
    const double next_5 = state[5] + period * acceleration_2;
    const double next_5_d6 = period * down_d6;
    const double next_5_d7 = period * down_d7;
    const double next_8 = state[8] + period * turn;
    const double next_8_d6 = period * turn_d6;
    const double next_8_d7 = period * turn_d7;
    const double next_8_d10 = period * turn_d10;
    const double next_8_d11 = period * turn_d11;
    next[0] = next_0;
    next[1] = next_1;
    next[2] = next_2;
    next[3] = next_3;
    next[4] = next_4;
    next[5] = next_5;
    next[6] = next_6;
    next[7] = next_7;
    next[8] = next_8;
    next[9] = state[9];
    next[10] = state[10];
    next[11] = state[11];
    const double row_0_0 = covariance->elements[0 + 12 * 0]
        + period * covariance->elements[3 + 12 * 0];
    const double row_0_1 = covariance->elements[0 + 12 * 1]
        + period * covariance->elements[3 + 12 * 1];
    const double row_0_2 = covariance->elements[0 + 12 * 2]
        + period * covariance->elements[3 + 12 * 2];
    const double row_1_1 = covariance->elements[1 + 12 * 1]
        + period * covariance->elements[4 + 12 * 1];
    const double row_1_2 = covariance->elements[1 + 12 * 2]
        + period * covariance->elements[4 + 12 * 2];
    const double row_2_2 = covariance->elements[2 + 12 * 2]
        + period * covariance->elements[5 + 12 * 2];
    for (uint32_t k = 3U; k < 12U; k++) {
        const double row_0 = covariance->elements[0U + 12U * k]
            + period * covariance->elements[3U + 12U * k];
        const double row_1 = covariance->elements[1U + 12U * k]
            + period * covariance->elements[4U + 12U * k];
        const double row_2 = covariance->elements[2U + 12U * k]
            + period * covariance->elements[5U + 12U * k];
        covariance->elements[0U + 12U * k] = row_0;
        covariance->elements[k + 12U * 0U] = row_0;
        covariance->elements[1U + 12U * k] = row_1;
        covariance->elements[k + 12U * 1U] = row_1;
        covariance->elements[2U + 12U * k] = row_2;
        covariance->elements[k + 12U * 2U] = row_2;
    }
    const double block_0_0 = row_0_0 + period * covariance->elements[0 + 12 * 3];
    const double block_1_0 = row_0_1 + period * covariance->elements[0 + 12 * 4];
    const double block_1_1 = row_1_1 + period * covariance->elements[1 + 12 * 4];
    const double block_2_0 = row_0_2 + period * covariance->elements[0 + 12 * 5];
    const double block_2_1 = row_1_2 + period * covariance->elements[1 + 12 * 5];
    const double block_2_2 = row_2_2 + period * covariance->elements[2 + 12 * 5];
    covariance->elements[0 + 12 * 0] = block_0_0;
    covariance->elements[1 + 12 * 0] = block_1_0;
    covariance->elements[0 + 12 * 1] = block_1_0;
    covariance->elements[1 + 12 * 1] = block_1_1;
    covariance->elements[2 + 12 * 0] = block_2_0;
    covariance->elements[0 + 12 * 2] = block_2_0;
    covariance->elements[2 + 12 * 1] = block_2_1;
    covariance->elements[1 + 12 * 2] = block_2_1;
    covariance->elements[2 + 12 * 2] = block_2_2;
    const double row_3_3 = covariance->elements[3 + 12 * 3]
        + next_3_d6 * covariance->elements[6 + 12 * 3]
        + next_3_d7 * covariance->elements[7 + 12 * 3]
        + next_3_d8 * covariance->elements[8 + 12 * 3];
    const double row_3_4 = covariance->elements[3 + 12 * 4]
        + next_3_d6 * covariance->elements[6 + 12 * 4]
        + next_3_d7 * covariance->elements[7 + 12 * 4]
        + next_3_d8 * covariance->elements[8 + 12 * 4];
    const double row_3_5 = covariance->elements[3 + 12 * 5]
        + next_3_d6 * covariance->elements[6 + 12 * 5]
        + next_3_d7 * covariance->elements[7 + 12 * 5]
        + next_3_d8 * covariance->elements[8 + 12 * 5];
    const double row_4_4 = covariance->elements[4 + 12 * 4]
        + next_4_d6 * covariance->elements[6 + 12 * 4]
        + next_4_d7 * covariance->elements[7 + 12 * 4]
        + next_4_d8 * covariance->elements[8 + 12 * 4];
    const double row_4_5 = covariance->elements[4 + 12 * 5]
        + next_4_d6 * covariance->elements[6 + 12 * 5]
        + next_4_d7 * covariance->elements[7 + 12 * 5]
        + next_4_d8 * covariance->elements[8 + 12 * 5];
    const double row_5_5 = covariance->elements[5 + 12 * 5]
        + next_5_d6 * covariance->elements[6 + 12 * 5]
        + next_5_d7 * covariance->elements[7 + 12 * 5];
    for (uint32_t k = 0U; k < 3U; k++) {
        const double row_3 = covariance->elements[3U + 12U * k]
            + next_3_d6 * covariance->elements[6U + 12U * k]
            + next_3_d7 * covariance->elements[7U + 12U * k]
            + next_3_d8 * covariance->elements[8U + 12U * k];
        const double row_4 = covariance->elements[4U + 12U * k]
            + next_4_d6 * covariance->elements[6U + 12U * k]
            + next_4_d7 * covariance->elements[7U + 12U * k]
            + next_4_d8 * covariance->elements[8U + 12U * k];
        const double row_5 = covariance->elements[5U + 12U * k]
            + next_5_d6 * covariance->elements[6U + 12U * k]
            + next_5_d7 * covariance->elements[7U + 12U * k];
        covariance->elements[3U + 12U * k] = row_3;
        covariance->elements[k + 12U * 3U] = row_3;
        covariance->elements[4U + 12U * k] = row_4;
        covariance->elements[k + 12U * 4U] = row_4;
        covariance->elements[5U + 12U * k] = row_5;
        covariance->elements[k + 12U * 5U] = row_5;
    }
    for (uint32_t k = 6U; k < 12U; k++) {
        const double row_3 = covariance->elements[3U + 12U * k]
            + next_3_d6 * covariance->elements[6U + 12U * k]
            + next_3_d7 * covariance->elements[7U + 12U * k]
            + next_3_d8 * covariance->elements[8U + 12U * k];
        const double row_4 = covariance->elements[4U + 12U * k]
            + next_4_d6 * covariance->elements[6U + 12U * k]
            + next_4_d7 * covariance->elements[7U + 12U * k]
            + next_4_d8 * covariance->elements[8U + 12U * k];
        const double row_5 = covariance->elements[5U + 12U * k]
            + next_5_d6 * covariance->elements[6U + 12U * k]
            + next_5_d7 * covariance->elements[7U + 12U * k];
        covariance->elements[3U + 12U * k] = row_3;
        covariance->elements[k + 12U * 3U] = row_3;
        covariance->elements[4U + 12U * k] = row_4;
        covariance->elements[k + 12U * 4U] = row_4;
        covariance->elements[5U + 12U * k] = row_5;
        covariance->elements[k + 12U * 5U] = row_5;
    }
    const double block_3_3 = row_3_3 + next_3_d6 * covariance->elements[3 + 12 * 6]
        + next_3_d7 * covariance->elements[3 + 12 * 7]
        + next_3_d8 * covariance->elements[3 + 12 * 8];
    const double block_4_3 = row_3_4 + next_4_d6 * covariance->elements[3 + 12 * 6]
        + next_4_d7 * covariance->elements[3 + 12 * 7]
        + next_4_d8 * covariance->elements[3 + 12 * 8];
    const double block_4_4 = row_4_4 + next_4_d6 * covariance->elements[4 + 12 * 6]
        + next_4_d7 * covariance->elements[4 + 12 * 7]
        + next_4_d8 * covariance->elements[4 + 12 * 8];
    const double block_5_3 = row_3_5 + next_5_d6 * covariance->elements[3 + 12 * 6]
        + next_5_d7 * covariance->elements[3 + 12 * 7];
    const double block_5_4 = row_4_5 + next_5_d6 * covariance->elements[4 + 12 * 6]
        + next_5_d7 * covariance->elements[4 + 12 * 7];
    const double block_5_5 = row_5_5 + next_5_d6 * covariance->elements[5 + 12 * 6]
        + next_5_d7 * covariance->elements[5 + 12 * 7];
    covariance->elements[3 + 12 * 3] = block_3_3;
    covariance->elements[4 + 12 * 3] = block_4_3;
    covariance->elements[3 + 12 * 4] = block_4_3;
    covariance->elements[4 + 12 * 4] = block_4_4;
    covariance->elements[5 + 12 * 3] = block_5_3;
    covariance->elements[3 + 12 * 5] = block_5_3;
    covariance->elements[5 + 12 * 4] = block_5_4;
    covariance->elements[4 + 12 * 5] = block_5_4;
    covariance->elements[5 + 12 * 5] = block_5_5;
    for (uint32_t k = 0U; k < 12U; k++) {
        const double row_6 = next_6_d6 * covariance->elements[6U + 12U * k]
            + next_6_d7 * covariance->elements[7U + 12U * k]
            + next_6_d9 * covariance->elements[9U + 12U * k]
            + next_6_d10 * covariance->elements[10U + 12U * k]
            + next_6_d11 * covariance->elements[11U + 12U * k];
        const double row_7 = covariance->elements[7U + 12U * k]
            + next_7_d6 * covariance->elements[6U + 12U * k]
            + next_7_d10 * covariance->elements[10U + 12U * k]
            + next_7_d11 * covariance->elements[11U + 12U * k];
        const double row_8 = covariance->elements[8U + 12U * k]
            + next_8_d6 * covariance->elements[6U + 12U * k]
            + next_8_d7 * covariance->elements[7U + 12U * k]
            + next_8_d10 * covariance->elements[10U + 12U * k]
            + next_8_d11 * covariance->elements[11U + 12U * k];
        covariance->elements[6U + 12U * k] = row_6;
        covariance->elements[7U + 12U * k] = row_7;
        covariance->elements[8U + 12U * k] = row_8;
        if (!(6U <= k && k < 9U)) {
            covariance->elements[k + 12U * 6U] = row_6;
            covariance->elements[k + 12U * 7U] = row_7;
            covariance->elements[k + 12U * 8U] = row_8;
        }
    }
    const double block_6_6 = next_6_d6 * covariance->elements[6 + 12 * 6]
        + next_6_d7 * covariance->elements[6 + 12 * 7]
        + next_6_d9 * covariance->elements[6 + 12 * 9]
        + next_6_d10 * covariance->elements[6 + 12 * 10]
        + next_6_d11 * covariance->elements[6 + 12 * 11];
    const double block_7_6 = covariance->elements[6 + 12 * 7]
        + next_7_d6 * covariance->elements[6 + 12 * 6]
        + next_7_d10 * covariance->elements[6 + 12 * 10]
        + next_7_d11 * covariance->elements[6 + 12 * 11];
    const double block_7_7 = covariance->elements[7 + 12 * 7]
        + next_7_d6 * covariance->elements[7 + 12 * 6]
        + next_7_d10 * covariance->elements[7 + 12 * 10]
        + next_7_d11 * covariance->elements[7 + 12 * 11];
    const double block_8_6 = covariance->elements[6 + 12 * 8]
        + next_8_d6 * covariance->elements[6 + 12 * 6]
        + next_8_d7 * covariance->elements[6 + 12 * 7]
        + next_8_d10 * covariance->elements[6 + 12 * 10]
        + next_8_d11 * covariance->elements[6 + 12 * 11];
    const double block_8_7 = covariance->elements[7 + 12 * 8]
        + next_8_d6 * covariance->elements[7 + 12 * 6]
        + next_8_d7 * covariance->elements[7 + 12 * 7]
        + next_8_d10 * covariance->elements[7 + 12 * 10]
        + next_8_d11 * covariance->elements[7 + 12 * 11];
    const double block_8_8 = covariance->elements[8 + 12 * 8]
        + next_8_d6 * covariance->elements[8 + 12 * 6]
        + next_8_d7 * covariance->elements[8 + 12 * 7]
        + next_8_d10 * covariance->elements[8 + 12 * 10]
        + next_8_d11 * covariance->elements[8 + 12 * 11];
    covariance->elements[6 + 12 * 6] = block_6_6;
    covariance->elements[7 + 12 * 6] = block_7_6;
    covariance->elements[6 + 12 * 7] = block_7_6;
    covariance->elements[7 + 12 * 7] = block_7_7;
    covariance->elements[8 + 12 * 6] = block_8_6;
    covariance->elements[6 + 12 * 8] = block_8_6;
    covariance->elements[8 + 12 * 7] = block_8_7;
    covariance->elements[7 + 12 * 8] = block_8_7;
    covariance->elements[8 + 12 * 8] = block_8_8;
}

void navigation_init(navigation_t *self)
{
    for (uint32_t i = 0U; i < 12U; i++) {
        self->state[i] = 0.0;
    }
    for (uint32_t i = 0U; i < 144U; i++) {
        self->covariance.elements[i] = 0.0;
    }
    self->covariance.elements[0 + 12 * 0] = 1.0;
    self->covariance.elements[1 + 12 * 1] = 1.0;
    self->covariance.elements[2 + 12 * 2] = 1.0;
    self->covariance.elements[3 + 12 * 3] = 0.1;
    self->covariance.elements[4 + 12 * 4] = 0.1;
    self->covariance.elements[5 + 12 * 5] = 0.1;
    self->covariance.elements[6 + 12 * 6] = 0.01;
    self->covariance.elements[7 + 12 * 7] = 0.01;
    self->covariance.elements[8 + 12 * 8] = 0.01;
    self->covariance.elements[9 + 12 * 9] = 0.0001;
    self->covariance.elements[10 + 12 * 10] = 0.0001;
    self->covariance.elements[11 + 12 * 11] = 0.0001;
}

void navigation_predict(navigation_t *BESSEMER_RESTRICT self, const inertial_t *inertial,
    double period)
{
    navigation_predicted(self->state, inertial, period, &self->covariance, self->state);
    for (uint32_t axis = 0U; axis < 3U; axis++) {
        self->covariance.elements[axis + 3U + 12U * (axis + 3U)] += 0.01 * period;
        self->covariance.elements[axis + 6U + 12U * (axis + 6U)] += 1e-5 * period;
        self->covariance.elements[axis + 9U + 12U * (axis + 9U)] += 1e-8 * period;
    }
}

void navigation_correct(navigation_t *BESSEMER_RESTRICT self, const double measured[6],
    navigation_correct_work_t *BESSEMER_RESTRICT work,
    correction_f64_t *BESSEMER_RESTRICT correction)
{
    const double innovation_vector[6] = {
        self->state[0], self->state[1], self->state[2], self->state[3], self->state[4],
        self->state[5]
    };
    double innovation[6];
    BESSEMER_FEW_PASSES
    for (uint32_t i = 0U; i < 6U; i++) {
        innovation[i] = measured[i] - innovation_vector[i];
    }
    static const double variances[6] = {0.25, 0.25, 0.25, 0.01, 0.01, 0.01};
    symmetric_f64_12_correct_part_0_6(&self->covariance, self->state, innovation, variances, GATE,
        work->numbers, correction);
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
    double numbers[72];
} navigation_correct_work_t;
