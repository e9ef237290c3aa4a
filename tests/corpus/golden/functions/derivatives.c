/* The C of tests/corpus/src/programs/functions/derivatives.rs. Written by a test. */

/* derivatives.c */

void derivatives_advanced(const double state[4], double push, double period,
    double next[BESSEMER_RESTRICT 4])
{
    const double speed = sqrt(state[2] * state[2] + state[3] * state[3]);
    double drag;
    if (speed > 2.0) {
        drag = 0.25 * speed;
    } else {
        drag = 0.5;
    }
    next[0] = state[0];
    next[1] = state[1];
    next[2] = state[2];
    next[3] = state[3];
    for (uint32_t axis = 0U; axis < 2U; axis++) {
        const double braking = drag * state[axis + 2U];
        next[axis] += period * state[axis + 2U];
        next[axis + 2U] -= period * braking;
    }
    next[2] += period * push;
}

void derivatives_advanced_jacobian(const double state[4], double push, double period,
    triple_vector4_f64_matrix4x4_f64_vector4_f64_t *BESSEMER_RESTRICT result)
{
    const double speed = sqrt(state[2] * state[2] + state[3] * state[3]);
    const double twice = 2.0 * speed;
    const double speed_d2 = (state[2] + state[2]) / twice;
    const double speed_d3 = (state[3] + state[3]) / twice;
    double drag;
    double drag_d2;
    double drag_d3;
    if (speed > 2.0) {
        const double drag_2 = 0.25 * speed;
        const double drag_d2_2 = 0.25 * speed_d2;
        const double drag_d3_2 = 0.25 * speed_d3;
        drag = drag_2;
        drag_d2 = drag_d2_2;
        drag_d3 = drag_d3_2;
    } else {
        drag = 0.5;
        drag_d2 = 0.0;
        drag_d3 = 0.0;
    }
    const double braking = drag * state[2];
    const double braking_d2 = state[2] * drag_d2 + drag;
    const double braking_d3 = state[2] * drag_d3;
    const double next_0 = state[0] + period * state[2];
    const double next_2 = state[2] - period * braking;
    const double next_2_d2 = 1.0 - period * braking_d2;
    const double next_2_d3 = -(period * braking_d3);
    const double braking_2 = drag * state[3];
    const double braking_d2_2 = state[3] * drag_d2;
    const double braking_d3_2 = state[3] * drag_d3 + drag;
    const double next_1 = state[1] + period * state[3];
    const double next_3 = state[3] - period * braking_2;
    const double next_3_d2 = -(period * braking_d2_2);
    const double next_3_d3 = 1.0 - period * braking_d3_2;
    const double next_2_2 = next_2 + period * push;
    for (uint32_t i = 0U; i < 16U; i++) {
        result->second[i] = 0.0;
    }
    result->second[0 + 4 * 0] = 1.0;
    result->second[0 + 4 * 2] = period;
    result->second[1 + 4 * 1] = 1.0;
    result->second[1 + 4 * 3] = period;
    result->second[2 + 4 * 2] = next_2_d2;
    result->second[2 + 4 * 3] = next_2_d3;
    result->second[3 + 4 * 2] = next_3_d2;
    result->second[3 + 4 * 3] = next_3_d3;
    result->third[0] = 0.0;
    result->third[1] = 0.0;
    result->third[2] = 0.0;
    result->third[3] = 0.0;
    result->third[2] = period;
    result->first[0] = next_0;
    result->first[1] = next_1;
    result->first[2] = next_2_2;
    result->first[3] = next_3;
}

void derivatives_seen(const double place[2], const double beacon[2],
    double result[BESSEMER_RESTRICT 2])
{
    const double way[2] = {place[0] - beacon[0], place[1] - beacon[1]};
    result[0] = sqrt(way[0] * way[0] + way[1] * way[1]);
    result[1] = arctangent_atan2(way[1], way[0]);
}

void derivatives_seen_jacobian(const double place[2], const double beacon[2],
    pair_vector2_f64_matrix2x2_f64_t *BESSEMER_RESTRICT result)
{
    const double way_0 = place[0] - beacon[0];
    const double way_1 = place[1] - beacon[1];
    const double result_value = sqrt(0.0 + (way_0 * way_0 + way_1 * way_1));
    const double twice = 2.0 * result_value;
    const double atan2_way_1 = arctangent_atan2(way_1, way_0);
    const double radius = way_0 * way_0 + way_1 * way_1;
    const double slope = way_0 / radius;
    const double slope_2 = way_1 / radius;
    const double result_0_d0 = (way_0 + way_0) / twice;
    const double result_0_d1 = (way_1 + way_1) / twice;
    const double result_1_d0 = -slope_2;
    result->second[0] = 0.0;
    result->second[1] = 0.0;
    result->second[2] = 0.0;
    result->second[3] = 0.0;
    result->second[0 + 2 * 0] = result_0_d0;
    result->second[0 + 2 * 1] = result_0_d1;
    result->second[1 + 2 * 0] = result_1_d0;
    result->second[1 + 2 * 1] = slope;
    result->first[0] = result_value;
    result->first[1] = atan2_way_1;
}

float derivatives_horner(const float coefficients[40], float x)
{
    float sum = 0.0F;
    for (uint32_t i = 0U; i < 40U; i++) {
        sum = sum * x + coefficients[i];
    }
    return sum;
}

void derivatives_horner_slope(const float coefficients[40], float x,
    pair_f32_f32_t *BESSEMER_RESTRICT result)
{
    float sum = 0.0F;
    float sum_d0 = 0.0F;
    for (uint32_t i = 0U; i < 40U; i++) {
        const float sum_2 = sum * x + coefficients[i];
        const float sum_d0_2 = x * sum_d0 + sum;
        sum_d0 = sum_d0_2;
        sum = sum_2;
    }
    result->first = sum;
    result->second = sum_d0;
}
