/* The C of tests/corpus/src/programs/cookbook/autopilot.rs. Written by a test. */

/* autopilot.c */

static const double GATE = 1000000.0;
static const double GRAVITY = 9.80665;
static const uint64_t SEEN[10] = {
    UINT64_C(0), UINT64_C(1), UINT64_C(2), UINT64_C(3), UINT64_C(16), UINT64_C(17), UINT64_C(18),
    UINT64_C(19), UINT64_C(20), UINT64_C(21)
};

static void autopilot_predicted(const double state[24], const imu_t *imu, double period,
    symmetric_f64_24_t *BESSEMER_RESTRICT covariance, double next[24]);
static void autopilot_magnetic_jacobian(const double seen[10],
    pair_vector3_f64_matrix3x10_f64_t *BESSEMER_RESTRICT result);

void flight_difference(const flight_t *self, const flight_t *from,
    double errors[BESSEMER_RESTRICT 24])
{
    for (uint32_t n = 0U; n < 4U; n++) {
        errors[AUTOPILOT_FLIGHT_ATTITUDE + n] = self->attitude[n] - from->attitude[n];
    }
    for (uint32_t n = 0U; n < 3U; n++) {
        errors[AUTOPILOT_FLIGHT_VELOCITY + n] = self->velocity[n] - from->velocity[n];
    }
    for (uint32_t n = 0U; n < 3U; n++) {
        errors[AUTOPILOT_FLIGHT_POSITION + n] = self->position[n] - from->position[n];
    }
    for (uint32_t n = 0U; n < 3U; n++) {
        errors[AUTOPILOT_FLIGHT_GYRO_BIAS + n] = self->gyro_bias[n] - from->gyro_bias[n];
    }
    for (uint32_t n = 0U; n < 3U; n++) {
        errors[AUTOPILOT_FLIGHT_FORCE_BIAS + n] = self->force_bias[n] - from->force_bias[n];
    }
    for (uint32_t n = 0U; n < 3U; n++) {
        errors[AUTOPILOT_FLIGHT_FIELD + n] = self->field[n] - from->field[n];
    }
    for (uint32_t n = 0U; n < 3U; n++) {
        errors[AUTOPILOT_FLIGHT_BODY_FIELD + n] = self->body_field[n] - from->body_field[n];
    }
    for (uint32_t n = 0U; n < 2U; n++) {
        errors[AUTOPILOT_FLIGHT_WIND + n] = self->wind[n] - from->wind[n];
    }
}

void flight_of_vector(const double vector[24], flight_t *BESSEMER_RESTRICT flight)
{
    flight->attitude[0] = vector[AUTOPILOT_FLIGHT_ATTITUDE];
    flight->attitude[1] = vector[AUTOPILOT_FLIGHT_ATTITUDE + 1U];
    flight->attitude[2] = vector[AUTOPILOT_FLIGHT_ATTITUDE + 2U];
    flight->attitude[3] = vector[AUTOPILOT_FLIGHT_ATTITUDE + 3U];
    flight->velocity[0] = vector[AUTOPILOT_FLIGHT_VELOCITY];
    flight->velocity[1] = vector[AUTOPILOT_FLIGHT_VELOCITY + 1U];
    flight->velocity[2] = vector[AUTOPILOT_FLIGHT_VELOCITY + 2U];
    flight->position[0] = vector[AUTOPILOT_FLIGHT_POSITION];
    flight->position[1] = vector[AUTOPILOT_FLIGHT_POSITION + 1U];
    flight->position[2] = vector[AUTOPILOT_FLIGHT_POSITION + 2U];
    flight->gyro_bias[0] = vector[AUTOPILOT_FLIGHT_GYRO_BIAS];
    flight->gyro_bias[1] = vector[AUTOPILOT_FLIGHT_GYRO_BIAS + 1U];
    flight->gyro_bias[2] = vector[AUTOPILOT_FLIGHT_GYRO_BIAS + 2U];
    flight->force_bias[0] = vector[AUTOPILOT_FLIGHT_FORCE_BIAS];
    flight->force_bias[1] = vector[AUTOPILOT_FLIGHT_FORCE_BIAS + 1U];
    flight->force_bias[2] = vector[AUTOPILOT_FLIGHT_FORCE_BIAS + 2U];
    flight->field[0] = vector[AUTOPILOT_FLIGHT_FIELD];
    flight->field[1] = vector[AUTOPILOT_FLIGHT_FIELD + 1U];
    flight->field[2] = vector[AUTOPILOT_FLIGHT_FIELD + 2U];
    flight->body_field[0] = vector[AUTOPILOT_FLIGHT_BODY_FIELD];
    flight->body_field[1] = vector[AUTOPILOT_FLIGHT_BODY_FIELD + 1U];
    flight->body_field[2] = vector[AUTOPILOT_FLIGHT_BODY_FIELD + 2U];
    flight->wind[0] = vector[AUTOPILOT_FLIGHT_WIND];
    flight->wind[1] = vector[AUTOPILOT_FLIGHT_WIND + 1U];
}

void flight_retracted(const flight_t *self, const double errors[24],
    flight_t *BESSEMER_RESTRICT moved)
{
    *moved = *self;
    for (uint32_t n = 0U; n < 4U; n++) {
        moved->attitude[n] += errors[AUTOPILOT_FLIGHT_ATTITUDE + n];
    }
    for (uint32_t n = 0U; n < 3U; n++) {
        moved->velocity[n] += errors[AUTOPILOT_FLIGHT_VELOCITY + n];
    }
    for (uint32_t n = 0U; n < 3U; n++) {
        moved->position[n] += errors[AUTOPILOT_FLIGHT_POSITION + n];
    }
    for (uint32_t n = 0U; n < 3U; n++) {
        moved->gyro_bias[n] += errors[AUTOPILOT_FLIGHT_GYRO_BIAS + n];
    }
    for (uint32_t n = 0U; n < 3U; n++) {
        moved->force_bias[n] += errors[AUTOPILOT_FLIGHT_FORCE_BIAS + n];
    }
    for (uint32_t n = 0U; n < 3U; n++) {
        moved->field[n] += errors[AUTOPILOT_FLIGHT_FIELD + n];
    }
    for (uint32_t n = 0U; n < 3U; n++) {
        moved->body_field[n] += errors[AUTOPILOT_FLIGHT_BODY_FIELD + n];
    }
    for (uint32_t n = 0U; n < 2U; n++) {
        moved->wind[n] += errors[AUTOPILOT_FLIGHT_WIND + n];
    }
}

void flight_vector(const flight_t *self, double vector[BESSEMER_RESTRICT 24])
{
    for (uint32_t n = 0U; n < 4U; n++) {
        vector[AUTOPILOT_FLIGHT_ATTITUDE + n] = self->attitude[n];
    }
    for (uint32_t n = 0U; n < 3U; n++) {
        vector[AUTOPILOT_FLIGHT_VELOCITY + n] = self->velocity[n];
    }
    for (uint32_t n = 0U; n < 3U; n++) {
        vector[AUTOPILOT_FLIGHT_POSITION + n] = self->position[n];
    }
    for (uint32_t n = 0U; n < 3U; n++) {
        vector[AUTOPILOT_FLIGHT_GYRO_BIAS + n] = self->gyro_bias[n];
    }
    for (uint32_t n = 0U; n < 3U; n++) {
        vector[AUTOPILOT_FLIGHT_FORCE_BIAS + n] = self->force_bias[n];
    }
    for (uint32_t n = 0U; n < 3U; n++) {
        vector[AUTOPILOT_FLIGHT_FIELD + n] = self->field[n];
    }
    for (uint32_t n = 0U; n < 3U; n++) {
        vector[AUTOPILOT_FLIGHT_BODY_FIELD + n] = self->body_field[n];
    }
    for (uint32_t n = 0U; n < 2U; n++) {
        vector[AUTOPILOT_FLIGHT_WIND + n] = self->wind[n];
    }
}

void autopilot_advanced(const double state[24], const imu_t *imu, double period,
    double next[BESSEMER_RESTRICT 24])
{
    const double w = state[0];
    const double x = state[1];
    const double y = state[2];
    const double z = state[3];
    double half[3];
    double force[3];
    for (uint32_t axis = 0U; axis < 3U; axis++) {
        half[axis] = 0.5 * period * (imu->rate[axis] - state[AUTOPILOT_FLIGHT_GYRO_BIAS + axis]);
        force[axis] = period * (imu->force[axis] - state[AUTOPILOT_FLIGHT_FORCE_BIAS + axis]);
    }
    (void)memcpy(next, state, sizeof(double[24]));
    next[0] = w - x * half[0] - y * half[1] - z * half[2];
    next[1] = x + w * half[0] + y * half[2] - z * half[1];
    next[2] = y + w * half[1] + z * half[0] - x * half[2];
    next[3] = z + w * half[2] + x * half[1] - y * half[0];
    const double north = (1.0 - 2.0 * (y * y + z * z)) * force[0] + 2.0 * (x * y - w * z) * force[1]
        + 2.0 * (x * z + w * y) * force[2];
    const double east = 2.0 * (x * y + w * z) * force[0] + (1.0 - 2.0 * (x * x + z * z)) * force[1]
        + 2.0 * (y * z - w * x) * force[2];
    const double down = 2.0 * (x * z - w * y) * force[0] + 2.0 * (y * z + w * x) * force[1]
        + (1.0 - 2.0 * (x * x + y * y)) * force[2];
    next[AUTOPILOT_FLIGHT_VELOCITY] += north;
    next[AUTOPILOT_FLIGHT_VELOCITY + 1U] += east;
    next[AUTOPILOT_FLIGHT_VELOCITY + 2U] += down + GRAVITY * period;
    for (uint32_t axis = 0U; axis < 3U; axis++) {
        const uint32_t next_index = (uint32_t)(AUTOPILOT_FLIGHT_VELOCITY + axis);
        next[AUTOPILOT_FLIGHT_POSITION + axis] += period * state[next_index];
    }
}

/**
 * The state after one period; `covariance` becomes the covariance of its errors.
 * `next` may be `state`: nothing is read after it is written.
 */
static void autopilot_predicted(const double state[24], const imu_t *imu, double period,
    symmetric_f64_24_t *BESSEMER_RESTRICT covariance, double next[24])
{
    const double half = 0.5 * period;
    const double half_0 = half * (imu->rate[0] - state[10]);
    const double half_0_d10 = -half;
    const double force_0 = period * (imu->force[0] - state[13]);
    const double force_0_d13 = -period;
    const double half_2 = 0.5 * period;
    const double half_1 = half_2 * (imu->rate[1] - state[11]);
    const double half_1_d11 = -half_2;
    const double force_1 = period * (imu->force[1] - state[14]);
    const double force_1_d14 = -period;
    const double half_3 = 0.5 * period;
    const double half_2_2 = half_3 * (imu->rate[2] - state[12]);
    const double half_2_d12 = -half_3;
    const double force_2 = period * (imu->force[2] - state[15]);
    const double force_2_d15 = -period;
    const double next_0 = state[0] - state[1] * half_0 - state[2] * half_1 - state[3] * half_2_2;
    const double next_0_d1 = -half_0;
    const double next_0_d2 = -half_1;
    const double next_0_d3 = -half_2_2;
    const double next_0_d10 = -(state[1] * half_0_d10);
    const double next_0_d11 = -(state[2] * half_1_d11);
    const double next_0_d12 = -(state[3] * half_2_d12);
    const double next_1 = state[1] + state[0] * half_0 + state[2] * half_2_2 - state[3] * half_1;
    const double next_1_d3 = -half_1;
    const double next_1_d10 = state[0] * half_0_d10;
    const double next_1_d11 = -(state[3] * half_1_d11);
    const double next_1_d12 = state[2] * half_2_d12;
    const double next_2 = state[2] + state[0] * half_1 + state[3] * half_0 - state[1] * half_2_2;
    const double next_2_d1 = -half_2_2;
    const double next_2_d10 = state[3] * half_0_d10;
    const double next_2_d11 = state[0] * half_1_d11;
    const double next_2_d12 = -(state[1] * half_2_d12);
    const double next_3 = state[3] + state[0] * half_2_2 + state[1] * half_1 - state[2] * half_0;
    const double next_3_d2 = -half_0;
    const double next_3_d10 = -(state[2] * half_0_d10);
    const double next_3_d11 = state[1] * half_1_d11;
    const double next_3_d12 = state[0] * half_2_d12;
    const double north = 1.0 - 2.0 * (state[2] * state[2] + state[3] * state[3]);
    const double north_2 = 2.0 * (state[1] * state[2] - state[0] * state[3]);
    const double north_3 = 2.0 * (state[1] * state[3] + state[0] * state[2]);
    const double north_4 = north * force_0 + north_2 * force_1 + north_3 * force_2;
    const double north_d0 = force_1 * (2.0 * -state[3]) + force_2 * (2.0 * state[2]);
    const double north_d1 = force_1 * (2.0 * state[2]) + force_2 * (2.0 * state[3]);
    const double north_d2 = force_0 * -(2.0 * (state[2] + state[2])) + force_1 * (2.0 * state[1])
        + force_2 * (2.0 * state[0]);
    const double north_d3 = force_0 * -(2.0 * (state[3] + state[3])) + force_1 * (2.0 * -state[0])
        + force_2 * (2.0 * state[1]);
    const double north_d13 = north * force_0_d13;
    const double north_d14 = north_2 * force_1_d14;
    const double north_d15 = north_3 * force_2_d15;
    const double east = 2.0 * (state[1] * state[2] + state[0] * state[3]);
    const double east_2 = 1.0 - 2.0 * (state[1] * state[1] + state[3] * state[3]);
    const double east_3 = 2.0 * (state[2] * state[3] - state[0] * state[1]);
    const double east_4 = east * force_0 + east_2 * force_1 + east_3 * force_2;
    const double east_d0 = force_0 * (2.0 * state[3]) + force_2 * (2.0 * -state[1]);
    const double east_d1 = force_0 * (2.0 * state[2]) + force_1 * -(2.0 * (state[1] + state[1]))
        + force_2 * (2.0 * -state[0]);
    const double east_d2 = force_0 * (2.0 * state[1]) + force_2 * (2.0 * state[3]);
    const double east_d3 = force_0 * (2.0 * state[0]) + force_1 * -(2.0 * (state[3] + state[3]))
        + force_2 * (2.0 * state[2]);
    const double east_d13 = east * force_0_d13;
    const double east_d14 = east_2 * force_1_d14;
    const double east_d15 = east_3 * force_2_d15;
    const double down = 2.0 * (state[1] * state[3] - state[0] * state[2]);
    const double down_2 = 2.0 * (state[2] * state[3] + state[0] * state[1]);
    const double down_3 = 1.0 - 2.0 * (state[1] * state[1] + state[2] * state[2]);
    const double down_4 = down * force_0 + down_2 * force_1 + down_3 * force_2;
    const double down_d0 = force_0 * (2.0 * -state[2]) + force_1 * (2.0 * state[1]);
    const double down_d1 = force_0 * (2.0 * state[3]) + force_1 * (2.0 * state[0])
        + force_2 * -(2.0 * (state[1] + state[1]));
    const double down_d2 = force_0 * (2.0 * -state[0]) + force_1 * (2.0 * state[3])
        + force_2 * -(2.0 * (state[2] + state[2]));
    const double down_d3 = force_0 * (2.0 * state[1]) + force_1 * (2.0 * state[2]);
    const double down_d13 = down * force_0_d13;
    const double down_d14 = down_2 * force_1_d14;
    const double down_d15 = down_3 * force_2_d15;
    const double next_4 = state[4] + north_4;
    const double next_5 = state[5] + east_4;
    const double next_6 = state[6] + (down_4 + GRAVITY * period);
    const double next_7 = state[7] + period * state[4];
    const double next_8 = state[8] + period * state[5];
    const double next_9 = state[9] + period * state[6];
    next[0] = next_0;
    next[1] = next_1;
    next[2] = next_2;
    next[3] = next_3;
    next[4] = next_4;
    next[5] = next_5;
    next[6] = next_6;
    next[7] = next_7;
    next[8] = next_8;
    next[9] = next_9;
    next[10] = state[10];
    next[11] = state[11];
    next[12] = state[12];
    next[13] = state[13];
    next[14] = state[14];
    next[15] = state[15];
    next[16] = state[16];
    next[17] = state[17];
    next[18] = state[18];
    next[19] = state[19];
    next[20] = state[20];
    next[21] = state[21];
    next[22] = state[22];
    next[23] = state[23];
    const double row_7_7 = covariance->elements[7 + 24 * 7]
        + period * covariance->elements[4 + 24 * 7];
    const double row_7_8 = covariance->elements[7 + 24 * 8]
        + period * covariance->elements[4 + 24 * 8];
    const double row_7_9 = covariance->elements[7 + 24 * 9]
        + period * covariance->elements[4 + 24 * 9];
    const double row_8_8 = covariance->elements[8 + 24 * 8]
        + period * covariance->elements[5 + 24 * 8];
    const double row_8_9 = covariance->elements[8 + 24 * 9]
        + period * covariance->elements[5 + 24 * 9];
    const double row_9_9 = covariance->elements[9 + 24 * 9]
        + period * covariance->elements[6 + 24 * 9];
    for (uint32_t k = 0U; k < 7U; k++) {
        const double row_7 = covariance->elements[7U + 24U * k]
            + period * covariance->elements[4U + 24U * k];
        const double row_8 = covariance->elements[8U + 24U * k]
            + period * covariance->elements[5U + 24U * k];
        const double row_9 = covariance->elements[9U + 24U * k]
            + period * covariance->elements[6U + 24U * k];
        covariance->elements[7U + 24U * k] = row_7;
        covariance->elements[k + 24U * 7U] = row_7;
        covariance->elements[8U + 24U * k] = row_8;
        covariance->elements[k + 24U * 8U] = row_8;
        covariance->elements[9U + 24U * k] = row_9;
        covariance->elements[k + 24U * 9U] = row_9;
    }
    for (uint32_t k = 10U; k < 24U; k++) {
        const double row_7 = covariance->elements[7U + 24U * k]
            + period * covariance->elements[4U + 24U * k];
        const double row_8 = covariance->elements[8U + 24U * k]
            + period * covariance->elements[5U + 24U * k];
        const double row_9 = covariance->elements[9U + 24U * k]
            + period * covariance->elements[6U + 24U * k];
        covariance->elements[7U + 24U * k] = row_7;
        covariance->elements[k + 24U * 7U] = row_7;
        covariance->elements[8U + 24U * k] = row_8;
        covariance->elements[k + 24U * 8U] = row_8;
        covariance->elements[9U + 24U * k] = row_9;
        covariance->elements[k + 24U * 9U] = row_9;
    }
    const double block_7_7 = row_7_7 + period * covariance->elements[7 + 24 * 4];
    const double block_8_7 = row_7_8 + period * covariance->elements[7 + 24 * 5];
    const double block_8_8 = row_8_8 + period * covariance->elements[8 + 24 * 5];
    const double block_9_7 = row_7_9 + period * covariance->elements[7 + 24 * 6];
    const double block_9_8 = row_8_9 + period * covariance->elements[8 + 24 * 6];
    const double block_9_9 = row_9_9 + period * covariance->elements[9 + 24 * 6];
    covariance->elements[7 + 24 * 7] = block_7_7;
    covariance->elements[8 + 24 * 7] = block_8_7;
    covariance->elements[7 + 24 * 8] = block_8_7;
    covariance->elements[8 + 24 * 8] = block_8_8;
    covariance->elements[9 + 24 * 7] = block_9_7;
    covariance->elements[7 + 24 * 9] = block_9_7;
    covariance->elements[9 + 24 * 8] = block_9_8;
    covariance->elements[8 + 24 * 9] = block_9_8;
    covariance->elements[9 + 24 * 9] = block_9_9;
    const double row_4_4 = covariance->elements[4 + 24 * 4]
        + north_d0 * covariance->elements[0 + 24 * 4] + north_d1 * covariance->elements[1 + 24 * 4]
        + north_d2 * covariance->elements[2 + 24 * 4] + north_d3 * covariance->elements[3 + 24 * 4]
        + north_d13 * covariance->elements[13 + 24 * 4]
        + north_d14 * covariance->elements[14 + 24 * 4]
        + north_d15 * covariance->elements[15 + 24 * 4];
    const double row_4_5 = covariance->elements[4 + 24 * 5]
        + north_d0 * covariance->elements[0 + 24 * 5] + north_d1 * covariance->elements[1 + 24 * 5]
        + north_d2 * covariance->elements[2 + 24 * 5] + north_d3 * covariance->elements[3 + 24 * 5]
        + north_d13 * covariance->elements[13 + 24 * 5]
        + north_d14 * covariance->elements[14 + 24 * 5]
        + north_d15 * covariance->elements[15 + 24 * 5];
    const double row_4_6 = covariance->elements[4 + 24 * 6]
        + north_d0 * covariance->elements[0 + 24 * 6] + north_d1 * covariance->elements[1 + 24 * 6]
        + north_d2 * covariance->elements[2 + 24 * 6] + north_d3 * covariance->elements[3 + 24 * 6]
        + north_d13 * covariance->elements[13 + 24 * 6]
        + north_d14 * covariance->elements[14 + 24 * 6]
        + north_d15 * covariance->elements[15 + 24 * 6];
    const double row_5_5 = covariance->elements[5 + 24 * 5]
        + east_d0 * covariance->elements[0 + 24 * 5] + east_d1 * covariance->elements[1 + 24 * 5]
        + east_d2 * covariance->elements[2 + 24 * 5] + east_d3 * covariance->elements[3 + 24 * 5]
        + east_d13 * covariance->elements[13 + 24 * 5]
        + east_d14 * covariance->elements[14 + 24 * 5]
        + east_d15 * covariance->elements[15 + 24 * 5];
    const double row_5_6 = covariance->elements[5 + 24 * 6]
        + east_d0 * covariance->elements[0 + 24 * 6] + east_d1 * covariance->elements[1 + 24 * 6]
        + east_d2 * covariance->elements[2 + 24 * 6] + east_d3 * covariance->elements[3 + 24 * 6]
        + east_d13 * covariance->elements[13 + 24 * 6]
        + east_d14 * covariance->elements[14 + 24 * 6]
        + east_d15 * covariance->elements[15 + 24 * 6];
    const double row_6_6 = covariance->elements[6 + 24 * 6]
        + down_d0 * covariance->elements[0 + 24 * 6] + down_d1 * covariance->elements[1 + 24 * 6]
        + down_d2 * covariance->elements[2 + 24 * 6] + down_d3 * covariance->elements[3 + 24 * 6]
        + down_d13 * covariance->elements[13 + 24 * 6]
        + down_d14 * covariance->elements[14 + 24 * 6]
        + down_d15 * covariance->elements[15 + 24 * 6];
    for (uint32_t k = 0U; k < 4U; k++) {
        const double row_4 = covariance->elements[4U + 24U * k]
            + north_d0 * covariance->elements[0U + 24U * k]
            + north_d1 * covariance->elements[1U + 24U * k]
            + north_d2 * covariance->elements[2U + 24U * k]
            + north_d3 * covariance->elements[3U + 24U * k]
            + north_d13 * covariance->elements[13U + 24U * k]
            + north_d14 * covariance->elements[14U + 24U * k]
            + north_d15 * covariance->elements[15U + 24U * k];
        const double row_5 = covariance->elements[5U + 24U * k]
            + east_d0 * covariance->elements[0U + 24U * k]
            + east_d1 * covariance->elements[1U + 24U * k]
            + east_d2 * covariance->elements[2U + 24U * k]
            + east_d3 * covariance->elements[3U + 24U * k]
            + east_d13 * covariance->elements[13U + 24U * k]
            + east_d14 * covariance->elements[14U + 24U * k]
            + east_d15 * covariance->elements[15U + 24U * k];
        const double row_6 = covariance->elements[6U + 24U * k]
            + down_d0 * covariance->elements[0U + 24U * k]
            + down_d1 * covariance->elements[1U + 24U * k]
            + down_d2 * covariance->elements[2U + 24U * k]
            + down_d3 * covariance->elements[3U + 24U * k]
            + down_d13 * covariance->elements[13U + 24U * k]
            + down_d14 * covariance->elements[14U + 24U * k]
            + down_d15 * covariance->elements[15U + 24U * k];
        covariance->elements[4U + 24U * k] = row_4;
        covariance->elements[k + 24U * 4U] = row_4;
        covariance->elements[5U + 24U * k] = row_5;
        covariance->elements[k + 24U * 5U] = row_5;
        covariance->elements[6U + 24U * k] = row_6;
        covariance->elements[k + 24U * 6U] = row_6;
    }
    for (uint32_t k = 7U; k < 24U; k++) {
        const double row_4 = covariance->elements[4U + 24U * k]
            + north_d0 * covariance->elements[0U + 24U * k]
            + north_d1 * covariance->elements[1U + 24U * k]
            + north_d2 * covariance->elements[2U + 24U * k]
            + north_d3 * covariance->elements[3U + 24U * k]
            + north_d13 * covariance->elements[13U + 24U * k]
            + north_d14 * covariance->elements[14U + 24U * k]
            + north_d15 * covariance->elements[15U + 24U * k];
        const double row_5 = covariance->elements[5U + 24U * k]
            + east_d0 * covariance->elements[0U + 24U * k]
            + east_d1 * covariance->elements[1U + 24U * k]
            + east_d2 * covariance->elements[2U + 24U * k]
            + east_d3 * covariance->elements[3U + 24U * k]
            + east_d13 * covariance->elements[13U + 24U * k]
            + east_d14 * covariance->elements[14U + 24U * k]
            + east_d15 * covariance->elements[15U + 24U * k];
        const double row_6 = covariance->elements[6U + 24U * k]
            + down_d0 * covariance->elements[0U + 24U * k]
            + down_d1 * covariance->elements[1U + 24U * k]
            + down_d2 * covariance->elements[2U + 24U * k]
            + down_d3 * covariance->elements[3U + 24U * k]
            + down_d13 * covariance->elements[13U + 24U * k]
            + down_d14 * covariance->elements[14U + 24U * k]
            + down_d15 * covariance->elements[15U + 24U * k];
        covariance->elements[4U + 24U * k] = row_4;
        covariance->elements[k + 24U * 4U] = row_4;
        covariance->elements[5U + 24U * k] = row_5;
        covariance->elements[k + 24U * 5U] = row_5;
        covariance->elements[6U + 24U * k] = row_6;
        covariance->elements[k + 24U * 6U] = row_6;
    }
    const double block_4_4 = row_4_4 + north_d0 * covariance->elements[4 + 24 * 0]
        + north_d1 * covariance->elements[4 + 24 * 1] + north_d2 * covariance->elements[4 + 24 * 2]
        + north_d3 * covariance->elements[4 + 24 * 3]
        + north_d13 * covariance->elements[4 + 24 * 13]
        + north_d14 * covariance->elements[4 + 24 * 14]
        + north_d15 * covariance->elements[4 + 24 * 15];
    const double block_5_4 = row_4_5 + east_d0 * covariance->elements[4 + 24 * 0]
        + east_d1 * covariance->elements[4 + 24 * 1] + east_d2 * covariance->elements[4 + 24 * 2]
        + east_d3 * covariance->elements[4 + 24 * 3] + east_d13 * covariance->elements[4 + 24 * 13]
        + east_d14 * covariance->elements[4 + 24 * 14]
        + east_d15 * covariance->elements[4 + 24 * 15];
    const double block_5_5 = row_5_5 + east_d0 * covariance->elements[5 + 24 * 0]
        + east_d1 * covariance->elements[5 + 24 * 1] + east_d2 * covariance->elements[5 + 24 * 2]
        + east_d3 * covariance->elements[5 + 24 * 3] + east_d13 * covariance->elements[5 + 24 * 13]
        + east_d14 * covariance->elements[5 + 24 * 14]
        + east_d15 * covariance->elements[5 + 24 * 15];
    const double block_6_4 = row_4_6 + down_d0 * covariance->elements[4 + 24 * 0]
        + down_d1 * covariance->elements[4 + 24 * 1] + down_d2 * covariance->elements[4 + 24 * 2]
        + down_d3 * covariance->elements[4 + 24 * 3] + down_d13 * covariance->elements[4 + 24 * 13]
        + down_d14 * covariance->elements[4 + 24 * 14]
        + down_d15 * covariance->elements[4 + 24 * 15];
    const double block_6_5 = row_5_6 + down_d0 * covariance->elements[5 + 24 * 0]
        + down_d1 * covariance->elements[5 + 24 * 1] + down_d2 * covariance->elements[5 + 24 * 2]
        + down_d3 * covariance->elements[5 + 24 * 3] + down_d13 * covariance->elements[5 + 24 * 13]
        + down_d14 * covariance->elements[5 + 24 * 14]
        + down_d15 * covariance->elements[5 + 24 * 15];
    const double block_6_6 = row_6_6 + down_d0 * covariance->elements[6 + 24 * 0]
        + down_d1 * covariance->elements[6 + 24 * 1] + down_d2 * covariance->elements[6 + 24 * 2]
        + down_d3 * covariance->elements[6 + 24 * 3] + down_d13 * covariance->elements[6 + 24 * 13]
        + down_d14 * covariance->elements[6 + 24 * 14]
        + down_d15 * covariance->elements[6 + 24 * 15];
    covariance->elements[4 + 24 * 4] = block_4_4;
    covariance->elements[5 + 24 * 4] = block_5_4;
    covariance->elements[4 + 24 * 5] = block_5_4;
    covariance->elements[5 + 24 * 5] = block_5_5;
    covariance->elements[6 + 24 * 4] = block_6_4;
    covariance->elements[4 + 24 * 6] = block_6_4;
    covariance->elements[6 + 24 * 5] = block_6_5;
    covariance->elements[5 + 24 * 6] = block_6_5;
    covariance->elements[6 + 24 * 6] = block_6_6;
    for (uint32_t k = 0U; k < 24U; k++) {
        const double row_0 = covariance->elements[0U + 24U * k]
            + next_0_d1 * covariance->elements[1U + 24U * k]
            + next_0_d2 * covariance->elements[2U + 24U * k]
            + next_0_d3 * covariance->elements[3U + 24U * k]
            + next_0_d10 * covariance->elements[10U + 24U * k]
            + next_0_d11 * covariance->elements[11U + 24U * k]
            + next_0_d12 * covariance->elements[12U + 24U * k];
        const double row_1 = covariance->elements[1U + 24U * k]
            + half_0 * covariance->elements[0U + 24U * k]
            + half_2_2 * covariance->elements[2U + 24U * k]
            + next_1_d3 * covariance->elements[3U + 24U * k]
            + next_1_d10 * covariance->elements[10U + 24U * k]
            + next_1_d11 * covariance->elements[11U + 24U * k]
            + next_1_d12 * covariance->elements[12U + 24U * k];
        const double row_2 = covariance->elements[2U + 24U * k]
            + half_1 * covariance->elements[0U + 24U * k]
            + next_2_d1 * covariance->elements[1U + 24U * k]
            + half_0 * covariance->elements[3U + 24U * k]
            + next_2_d10 * covariance->elements[10U + 24U * k]
            + next_2_d11 * covariance->elements[11U + 24U * k]
            + next_2_d12 * covariance->elements[12U + 24U * k];
        const double row_3 = covariance->elements[3U + 24U * k]
            + half_2_2 * covariance->elements[0U + 24U * k]
            + half_1 * covariance->elements[1U + 24U * k]
            + next_3_d2 * covariance->elements[2U + 24U * k]
            + next_3_d10 * covariance->elements[10U + 24U * k]
            + next_3_d11 * covariance->elements[11U + 24U * k]
            + next_3_d12 * covariance->elements[12U + 24U * k];
        covariance->elements[0U + 24U * k] = row_0;
        covariance->elements[1U + 24U * k] = row_1;
        covariance->elements[2U + 24U * k] = row_2;
        covariance->elements[3U + 24U * k] = row_3;
        if (k >= 4U) {
            covariance->elements[k + 24U * 0U] = row_0;
            covariance->elements[k + 24U * 1U] = row_1;
            covariance->elements[k + 24U * 2U] = row_2;
            covariance->elements[k + 24U * 3U] = row_3;
        }
    }
    const double block_0_0 = covariance->elements[0 + 24 * 0]
        + next_0_d1 * covariance->elements[0 + 24 * 1]
        + next_0_d2 * covariance->elements[0 + 24 * 2]
        + next_0_d3 * covariance->elements[0 + 24 * 3]
        + next_0_d10 * covariance->elements[0 + 24 * 10]
        + next_0_d11 * covariance->elements[0 + 24 * 11]
        + next_0_d12 * covariance->elements[0 + 24 * 12];
    const double block_1_0 = covariance->elements[0 + 24 * 1]
        + half_0 * covariance->elements[0 + 24 * 0] + half_2_2 * covariance->elements[0 + 24 * 2]
        + next_1_d3 * covariance->elements[0 + 24 * 3]
        + next_1_d10 * covariance->elements[0 + 24 * 10]
        + next_1_d11 * covariance->elements[0 + 24 * 11]
        + next_1_d12 * covariance->elements[0 + 24 * 12];
    const double block_1_1 = covariance->elements[1 + 24 * 1]
        + half_0 * covariance->elements[1 + 24 * 0] + half_2_2 * covariance->elements[1 + 24 * 2]
        + next_1_d3 * covariance->elements[1 + 24 * 3]
        + next_1_d10 * covariance->elements[1 + 24 * 10]
        + next_1_d11 * covariance->elements[1 + 24 * 11]
        + next_1_d12 * covariance->elements[1 + 24 * 12];
    const double block_2_0 = covariance->elements[0 + 24 * 2]
        + half_1 * covariance->elements[0 + 24 * 0] + next_2_d1 * covariance->elements[0 + 24 * 1]
        + half_0 * covariance->elements[0 + 24 * 3]
        + next_2_d10 * covariance->elements[0 + 24 * 10]
        + next_2_d11 * covariance->elements[0 + 24 * 11]
        + next_2_d12 * covariance->elements[0 + 24 * 12];
    const double block_2_1 = covariance->elements[1 + 24 * 2]
        + half_1 * covariance->elements[1 + 24 * 0] + next_2_d1 * covariance->elements[1 + 24 * 1]
        + half_0 * covariance->elements[1 + 24 * 3]
        + next_2_d10 * covariance->elements[1 + 24 * 10]
        + next_2_d11 * covariance->elements[1 + 24 * 11]
        + next_2_d12 * covariance->elements[1 + 24 * 12];
    const double block_2_2 = covariance->elements[2 + 24 * 2]
        + half_1 * covariance->elements[2 + 24 * 0] + next_2_d1 * covariance->elements[2 + 24 * 1]
        + half_0 * covariance->elements[2 + 24 * 3]
        + next_2_d10 * covariance->elements[2 + 24 * 10]
        + next_2_d11 * covariance->elements[2 + 24 * 11]
        + next_2_d12 * covariance->elements[2 + 24 * 12];
    const double block_3_0 = covariance->elements[0 + 24 * 3]
        + half_2_2 * covariance->elements[0 + 24 * 0] + half_1 * covariance->elements[0 + 24 * 1]
        + next_3_d2 * covariance->elements[0 + 24 * 2]
        + next_3_d10 * covariance->elements[0 + 24 * 10]
        + next_3_d11 * covariance->elements[0 + 24 * 11]
        + next_3_d12 * covariance->elements[0 + 24 * 12];
    const double block_3_1 = covariance->elements[1 + 24 * 3]
        + half_2_2 * covariance->elements[1 + 24 * 0] + half_1 * covariance->elements[1 + 24 * 1]
        + next_3_d2 * covariance->elements[1 + 24 * 2]
        + next_3_d10 * covariance->elements[1 + 24 * 10]
        + next_3_d11 * covariance->elements[1 + 24 * 11]
        + next_3_d12 * covariance->elements[1 + 24 * 12];
    const double block_3_2 = covariance->elements[2 + 24 * 3]
        + half_2_2 * covariance->elements[2 + 24 * 0] + half_1 * covariance->elements[2 + 24 * 1]
        + next_3_d2 * covariance->elements[2 + 24 * 2]
        + next_3_d10 * covariance->elements[2 + 24 * 10]
        + next_3_d11 * covariance->elements[2 + 24 * 11]
        + next_3_d12 * covariance->elements[2 + 24 * 12];
    const double block_3_3 = covariance->elements[3 + 24 * 3]
        + half_2_2 * covariance->elements[3 + 24 * 0] + half_1 * covariance->elements[3 + 24 * 1]
        + next_3_d2 * covariance->elements[3 + 24 * 2]
        + next_3_d10 * covariance->elements[3 + 24 * 10]
        + next_3_d11 * covariance->elements[3 + 24 * 11]
        + next_3_d12 * covariance->elements[3 + 24 * 12];
    covariance->elements[0 + 24 * 0] = block_0_0;
    covariance->elements[1 + 24 * 0] = block_1_0;
    covariance->elements[0 + 24 * 1] = block_1_0;
    covariance->elements[1 + 24 * 1] = block_1_1;
    covariance->elements[2 + 24 * 0] = block_2_0;
    covariance->elements[0 + 24 * 2] = block_2_0;
    covariance->elements[2 + 24 * 1] = block_2_1;
    covariance->elements[1 + 24 * 2] = block_2_1;
    covariance->elements[2 + 24 * 2] = block_2_2;
    covariance->elements[3 + 24 * 0] = block_3_0;
    covariance->elements[0 + 24 * 3] = block_3_0;
    covariance->elements[3 + 24 * 1] = block_3_1;
    covariance->elements[1 + 24 * 3] = block_3_1;
    covariance->elements[3 + 24 * 2] = block_3_2;
    covariance->elements[2 + 24 * 3] = block_3_2;
    covariance->elements[3 + 24 * 3] = block_3_3;
}

void autopilot_magnetic(const double seen[10], double result[BESSEMER_RESTRICT 3])
{
    const double w = seen[0];
    const double x = seen[1];
    const double y = seen[2];
    const double z = seen[3];
    const double north = seen[4];
    const double east = seen[5];
    const double down = seen[6];
    const double ahead = (1.0 - 2.0 * (y * y + z * z)) * north + 2.0 * (x * y + w * z) * east
        + 2.0 * (x * z - w * y) * down;
    const double right = 2.0 * (x * y - w * z) * north + (1.0 - 2.0 * (x * x + z * z)) * east
        + 2.0 * (y * z + w * x) * down;
    const double below = 2.0 * (x * z + w * y) * north + 2.0 * (y * z - w * x) * east
        + (1.0 - 2.0 * (x * x + y * y)) * down;
    result[0] = ahead + seen[7];
    result[1] = right + seen[8];
    result[2] = below + seen[9];
}

/** The measured field, and its Jacobian. */
static void autopilot_magnetic_jacobian(const double seen[10],
    pair_vector3_f64_matrix3x10_f64_t *BESSEMER_RESTRICT result)
{
    const double ahead = 1.0 - 2.0 * (seen[2] * seen[2] + seen[3] * seen[3]);
    const double ahead_2 = 2.0 * (seen[1] * seen[2] + seen[0] * seen[3]);
    const double ahead_3 = 2.0 * (seen[1] * seen[3] - seen[0] * seen[2]);
    const double ahead_4 = ahead * seen[4] + ahead_2 * seen[5] + ahead_3 * seen[6];
    const double ahead_d0 = seen[5] * (2.0 * seen[3]) + seen[6] * (2.0 * -seen[2]);
    const double ahead_d1 = seen[5] * (2.0 * seen[2]) + seen[6] * (2.0 * seen[3]);
    const double ahead_d2 = seen[4] * -(2.0 * (seen[2] + seen[2])) + seen[5] * (2.0 * seen[1])
        + seen[6] * (2.0 * -seen[0]);
    const double ahead_d3 = seen[4] * -(2.0 * (seen[3] + seen[3])) + seen[5] * (2.0 * seen[0])
        + seen[6] * (2.0 * seen[1]);
    const double right = 2.0 * (seen[1] * seen[2] - seen[0] * seen[3]);
    const double right_2 = 1.0 - 2.0 * (seen[1] * seen[1] + seen[3] * seen[3]);
    const double right_3 = 2.0 * (seen[2] * seen[3] + seen[0] * seen[1]);
    const double right_4 = right * seen[4] + right_2 * seen[5] + right_3 * seen[6];
    const double right_d0 = seen[4] * (2.0 * -seen[3]) + seen[6] * (2.0 * seen[1]);
    const double right_d1 = seen[4] * (2.0 * seen[2]) + seen[5] * -(2.0 * (seen[1] + seen[1]))
        + seen[6] * (2.0 * seen[0]);
    const double right_d2 = seen[4] * (2.0 * seen[1]) + seen[6] * (2.0 * seen[3]);
    const double right_d3 = seen[4] * (2.0 * -seen[0]) + seen[5] * -(2.0 * (seen[3] + seen[3]))
        + seen[6] * (2.0 * seen[2]);
    const double below = 2.0 * (seen[1] * seen[3] + seen[0] * seen[2]);
    const double below_2 = 2.0 * (seen[2] * seen[3] - seen[0] * seen[1]);
    const double below_3 = 1.0 - 2.0 * (seen[1] * seen[1] + seen[2] * seen[2]);
    const double below_4 = below * seen[4] + below_2 * seen[5] + below_3 * seen[6];
    const double below_d0 = seen[4] * (2.0 * seen[2]) + seen[5] * (2.0 * -seen[1]);
    const double below_d1 = seen[4] * (2.0 * seen[3]) + seen[5] * (2.0 * -seen[0])
        + seen[6] * -(2.0 * (seen[1] + seen[1]));
    const double below_d2 = seen[4] * (2.0 * seen[0]) + seen[5] * (2.0 * seen[3])
        + seen[6] * -(2.0 * (seen[2] + seen[2]));
    const double below_d3 = seen[4] * (2.0 * seen[1]) + seen[5] * (2.0 * seen[2]);
    const double result_0 = ahead_4 + seen[7];
    const double result_1 = right_4 + seen[8];
    const double result_2 = below_4 + seen[9];
    for (uint32_t i = 0U; i < 30U; i++) {
        result->second[i] = 0.0;
    }
    result->second[0 + 3 * 0] = ahead_d0;
    result->second[0 + 3 * 1] = ahead_d1;
    result->second[0 + 3 * 2] = ahead_d2;
    result->second[0 + 3 * 3] = ahead_d3;
    result->second[0 + 3 * 4] = ahead;
    result->second[0 + 3 * 5] = ahead_2;
    result->second[0 + 3 * 6] = ahead_3;
    result->second[0 + 3 * 7] = 1.0;
    result->second[1 + 3 * 0] = right_d0;
    result->second[1 + 3 * 1] = right_d1;
    result->second[1 + 3 * 2] = right_d2;
    result->second[1 + 3 * 3] = right_d3;
    result->second[1 + 3 * 4] = right;
    result->second[1 + 3 * 5] = right_2;
    result->second[1 + 3 * 6] = right_3;
    result->second[1 + 3 * 8] = 1.0;
    result->second[2 + 3 * 0] = below_d0;
    result->second[2 + 3 * 1] = below_d1;
    result->second[2 + 3 * 2] = below_d2;
    result->second[2 + 3 * 3] = below_d3;
    result->second[2 + 3 * 4] = below;
    result->second[2 + 3 * 5] = below_2;
    result->second[2 + 3 * 6] = below_3;
    result->second[2 + 3 * 9] = 1.0;
    result->first[0] = result_0;
    result->first[1] = result_1;
    result->first[2] = result_2;
}

void autopilot_init(autopilot_t *self)
{
    for (uint32_t i = 0U; i < 24U; i++) {
        self->state[i] = 0.0;
    }
    for (uint32_t i = 0U; i < 576U; i++) {
        self->covariance.elements[i] = 0.0;
    }
}

void autopilot_start(autopilot_t *BESSEMER_RESTRICT self, const double state[24],
    const double variances[24])
{
    (void)memcpy(self->state, state, sizeof(double[24]));
    symmetric_f64_24_diagonal(variances, &self->covariance);
}

void autopilot_predict(autopilot_t *BESSEMER_RESTRICT self, const imu_t *imu, double period)
{
    autopilot_predicted(self->state, imu, period, &self->covariance, self->state);
    const double attitude[4] = {
        self->state[AUTOPILOT_FLIGHT_ATTITUDE], self->state[AUTOPILOT_FLIGHT_ATTITUDE + 1U],
        self->state[AUTOPILOT_FLIGHT_ATTITUDE + 2U], self->state[AUTOPILOT_FLIGHT_ATTITUDE + 3U]
    };
    const double length = sqrt(attitude[0] * attitude[0] + attitude[2] * attitude[2]
        + (attitude[1] * attitude[1] + attitude[3] * attitude[3]));
    for (uint32_t n = 0U; n < 4U; n++) {
        self->state[n] /= length;
    }
    for (uint32_t n = 0U; n < 4U; n++) {
        self->covariance.elements[n + 24U * n] += 1e-6 * period;
    }
    for (uint32_t axis = 0U; axis < 3U; axis++) {
        const uint32_t velocity = (uint32_t)(AUTOPILOT_FLIGHT_VELOCITY + axis);
        self->covariance.elements[velocity + 24U * velocity] += 0.01 * period;
        const uint32_t gyro = (uint32_t)(AUTOPILOT_FLIGHT_GYRO_BIAS + axis);
        self->covariance.elements[gyro + 24U * gyro] += 1e-8 * period;
        const uint32_t force = (uint32_t)(AUTOPILOT_FLIGHT_FORCE_BIAS + axis);
        self->covariance.elements[force + 24U * force] += 1e-6 * period;
        const uint32_t field = (uint32_t)(AUTOPILOT_FLIGHT_FIELD + axis);
        self->covariance.elements[field + 24U * field] += 1e-6 * period;
        const uint32_t body = (uint32_t)(AUTOPILOT_FLIGHT_BODY_FIELD + axis);
        self->covariance.elements[body + 24U * body] += 1e-6 * period;
    }
    for (uint32_t axis = 0U; axis < 2U; axis++) {
        const uint32_t wind = (uint32_t)(AUTOPILOT_FLIGHT_WIND + axis);
        self->covariance.elements[wind + 24U * wind] += 0.01 * period;
    }
}

bool autopilot_place(autopilot_t *BESSEMER_RESTRICT self, const double measured[6],
    autopilot_place_work_t *BESSEMER_RESTRICT work)
{
    const double innovation_vector[6] = {
        self->state[AUTOPILOT_FLIGHT_VELOCITY], self->state[AUTOPILOT_FLIGHT_VELOCITY + 1U],
        self->state[AUTOPILOT_FLIGHT_VELOCITY + 2U], self->state[AUTOPILOT_FLIGHT_VELOCITY + 3U],
        self->state[AUTOPILOT_FLIGHT_VELOCITY + 4U], self->state[AUTOPILOT_FLIGHT_VELOCITY + 5U]
    };
    double innovation[6];
    BESSEMER_FEW_PASSES
    for (uint32_t i = 0U; i < 6U; i++) {
        innovation[i] = measured[i] - innovation_vector[i];
    }
    static const double variances[6] = {0.01, 0.01, 0.01, 0.25, 0.25, 0.25};
    correction_f64_t report;
    symmetric_f64_24_correct_part_4_6(&self->covariance, self->state, innovation, variances, GATE,
        work->numbers, &report);
    return report.status == CORRECT_STATUS_CORRECTED;
}

bool autopilot_compass(autopilot_t *BESSEMER_RESTRICT self, const double measured[3],
    autopilot_compass_work_t *BESSEMER_RESTRICT work)
{
    selection_10_24_t selection;
    (void)memcpy(selection.indices, SEEN, sizeof(uint64_t[10]));
    double expected_jacobian_seen[10];
    selection_10_24_of_f64(&selection, self->state, expected_jacobian_seen);
    pair_vector3_f64_matrix3x10_f64_t *const expected_jacobian = &work->expected_jacobian;
    autopilot_magnetic_jacobian(expected_jacobian_seen, expected_jacobian);
    const double innovation[3] = {
        measured[0] - expected_jacobian->first[0],
        measured[1] - expected_jacobian->first[1],
        measured[2] - expected_jacobian->first[2]
    };
    const double variances[3] = {0.0025, 0.0025, 0.0025};
    correction_f64_t report;
    symmetric_f64_24_correct_selected_10_3(&self->covariance, self->state, &selection,
        expected_jacobian->second, innovation, variances, GATE, work->numbers, &report);
    return report.status == CORRECT_STATUS_CORRECTED;
}

/* autopilot.h */

/** State of the filter. */
typedef struct {
    /** Quaternion from the body's frame to north, east, down: w, x, y, z. */
    double attitude[4];
    /** Velocity north, east and down, m/s. */
    double velocity[3];
    /** Position north, east and down, m. */
    double position[3];
    /** Bias of the rates, rad/s. */
    double gyro_bias[3];
    /** Bias of the specific force, m/s². */
    double force_bias[3];
    /** Magnetic field of the Earth, north, east and down, gauss. */
    double field[3];
    /** Magnetic field of the body, gauss. */
    double body_field[3];
    /** Wind north and east, m/s. */
    double wind[2];
} flight_t;

/** An inertial measurement. */
typedef struct {
    /** Rate of the body, rad/s. */
    double rate[3];
    /** Specific force in the body's frame, m/s². */
    double force[3];
} imu_t;

/** The filter. */
typedef struct {
    /** State, in the order of `Flight`. */
    double state[24];
    /** Covariance of its errors. */
    symmetric_f64_24_t covariance;
} autopilot_t;

/** Working memory of its entry point; the contents are undefined between calls. */
typedef struct {
    double numbers[144];
} autopilot_place_work_t;

/** Working memory of its entry point; the contents are undefined between calls. */
typedef struct {
    pair_vector3_f64_matrix3x10_f64_t expected_jacobian;
    double numbers[108];
} autopilot_compass_work_t;
