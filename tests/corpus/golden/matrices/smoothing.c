/* The C of tests/corpus/src/programs/matrices/smoothing.rs. Written by a test. */

/* smoothing.c */

static void smoothing_transition(double result[4]);
static void smoothing_swing(const double state[2], double result[BESSEMER_RESTRICT 2]);
static void smoothing_runge_kutta_in_swung(const double state[2], double period,
    double result[BESSEMER_RESTRICT 2]);
static void smoothing_swing_jacobian(const double state[2],
    pair_vector2_f64_matrix2x2_f64_t *BESSEMER_RESTRICT result);
static void smoothing_runge_kutta_jacobian_in_swung_jacobian(const double state[2], double period,
    pair_vector2_f64_matrix2x2_f64_t *BESSEMER_RESTRICT result);

/**
 * Transition of place and speed over a second.
 *
 * `result` by columns: [row + 2 * column].
 */
static void smoothing_transition(double result[4])
{
    static const double transition[4] = {
        1.0, 0.0,
        1.0, 1.0
    };
    result[0] = transition[0];
    result[1] = transition[1];
    result[2] = transition[2];
    result[3] = transition[3];
}

void smoothing_track(const double measured[3], double variance, double states[BESSEMER_RESTRICT 6])
{
    double f[4];
    smoothing_transition(f);
    const double start_values[2] = {100.0, 10.0};
    symmetric_f64_2_t start_covariance;
    symmetric_f64_2_diagonal(start_values, &start_covariance);
    const estimate_f64_2_t start = {.state = {0.0, 0.0}, .covariance = start_covariance};
    estimate_f64_2_t filtered[3];
    filtered[0] = start;
    filtered[1] = start;
    filtered[2] = start;
    estimate_f64_2_t predicted[3];
    predicted[0] = start;
    predicted[1] = start;
    predicted[2] = start;
    for (uint32_t step = 0U; step < 3U; step++) {
        if (step > 0U) {
            estimate_f64_2_t ahead = filtered[step - 1U];
            const double state_next[2] = {
                f[0 + 2 * 0] * ahead.state[0] + f[0 + 2 * 1] * ahead.state[1],
                f[1 + 2 * 0] * ahead.state[0] + f[1 + 2 * 1] * ahead.state[1]
            };
            ahead.state[0] = state_next[0];
            ahead.state[1] = state_next[1];
            symmetric_f64_2_congruence(&ahead.covariance, f);
            const double values[2] = {0.1, 0.2};
            symmetric_f64_2_add_diagonal(&ahead.covariance, values);
            predicted[step] = ahead;
        }
        estimate_f64_2_t now = predicted[step];
        const double innovation = measured[step] - now.state[0];
        {
            correction_f64_t unused;
            symmetric_f64_2_correct_element(&now.covariance, now.state, UINT64_C(0), innovation,
                variance, 1000000000.0, &unused);
        }
        filtered[step] = now;
    }
    double states_value[6] = {0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
    estimate_f64_2_t next = filtered[2];
    for (uint32_t row = 0U; row < 2U; row++) {
        states_value[row + 2U * 2U] = next.state[row];
    }
    for (uint32_t back = 0U; back < 2U; back++) {
        const uint32_t step = 1U - back;
        option_estimate_f64_2_t estimate;
        record_smoothed_f64_2(&filtered[step], f, &predicted[step + 1U], &next, &estimate);
        if (estimate.is_some) {
            next = estimate.value;
        } else {
            for (uint32_t i = 0U; i < 6U; i++) {
                states[i] = 0.0;
            }
            return;
        }
        for (uint32_t row = 0U; row < 2U; row++) {
            states_value[row + 2U * step] = next.state[row];
        }
    }
    (void)memcpy(states, states_value, sizeof(double[6]));
}

/** Rate of a pendulum: of its angle, rad, and of its rate, rad/s. */
static void smoothing_swing(const double state[2], double result[BESSEMER_RESTRICT 2])
{
    result[0] = state[1];
    result[1] = -9.81 * sine_sin(state[0]) - 0.1 * state[1];
}

void smoothing_swung(const double state[2], double period, double result[BESSEMER_RESTRICT 2])
{
    smoothing_runge_kutta_in_swung(state, period, result);
}

/**
 * Returns the state after a period, by one step of the classical Runge-Kutta method of fourth order; `law` gives its
 * rate.
 */
static void smoothing_runge_kutta_in_swung(const double state[2], double period,
    double result[BESSEMER_RESTRICT 2])
{
    const double half = period * 0.5;
    double one[2];
    smoothing_swing(state, one);
    const double two_state[2] = {state[0] + one[0] * half, state[1] + one[1] * half};
    double two[2];
    smoothing_swing(two_state, two);
    const double three_state[2] = {state[0] + two[0] * half, state[1] + two[1] * half};
    double three[2];
    smoothing_swing(three_state, three);
    const double four_state[2] = {state[0] + three[0] * period, state[1] + three[1] * period};
    double four[2];
    smoothing_swing(four_state, four);
    const double result_quotient = period / 6.0;
    result[0] = state[0] + (one[0] + (two[0] + three[0]) * 2.0 + four[0]) * result_quotient;
    result[1] = state[1] + (one[1] + (two[1] + three[1]) * 2.0 + four[1]) * result_quotient;
}

/** Rate of a pendulum, and its Jacobian. */
static void smoothing_swing_jacobian(const double state[2],
    pair_vector2_f64_matrix2x2_f64_t *BESSEMER_RESTRICT result)
{
    smoothing_swing(state, result->first);
    result->second[0 + 2 * 0] = 0.0;
    result->second[1 + 2 * 0] = -9.81 * sine_cos(state[0]);
    result->second[0 + 2 * 1] = 1.0;
    result->second[1 + 2 * 1] = -0.1;
}

void smoothing_swung_jacobian(const double state[2], double period,
    pair_vector2_f64_matrix2x2_f64_t *BESSEMER_RESTRICT result)
{
    smoothing_runge_kutta_jacobian_in_swung_jacobian(state, period, result);
}

/**
 * Returns the state of `runge_kutta` and its Jacobian by the state before; `law` gives the rate and the rate's
 * Jacobian. The Jacobian belongs to the step, not to the continuous flow: a covariance follows what the filter
 * computes.
 */
static void smoothing_runge_kutta_jacobian_in_swung_jacobian(const double state[2], double period,
    pair_vector2_f64_matrix2x2_f64_t *BESSEMER_RESTRICT result)
{
    const double half = period * 0.5;
    const double sixth = period / 6.0;
    const double identity[4] = {
        1.0, 0.0,
        0.0, 1.0
    };
    pair_vector2_f64_matrix2x2_f64_t one_slope_one;
    smoothing_swing_jacobian(state, &one_slope_one);
    const double two_by_two_state[2] = {
        state[0] + one_slope_one.first[0] * half,
        state[1] + one_slope_one.first[1] * half
    };
    pair_vector2_f64_matrix2x2_f64_t two_by_two;
    smoothing_swing_jacobian(two_by_two_state, &two_by_two);
    const double slope_two_sum[4] = {
        identity[0 + 2 * 0] + one_slope_one.second[0 + 2 * 0] * half,
        identity[1 + 2 * 0] + one_slope_one.second[1 + 2 * 0] * half,
        identity[0 + 2 * 1] + one_slope_one.second[0 + 2 * 1] * half,
        identity[1 + 2 * 1] + one_slope_one.second[1 + 2 * 1] * half
    };
    const double slope_two[4] = {
        two_by_two.second[0 + 2 * 0] * slope_two_sum[0 + 2 * 0]
            + two_by_two.second[0 + 2 * 1] * slope_two_sum[1 + 2 * 0],
        two_by_two.second[1 + 2 * 0] * slope_two_sum[0 + 2 * 0]
            + two_by_two.second[1 + 2 * 1] * slope_two_sum[1 + 2 * 0],
        two_by_two.second[0 + 2 * 0] * slope_two_sum[0 + 2 * 1]
            + two_by_two.second[0 + 2 * 1] * slope_two_sum[1 + 2 * 1],
        two_by_two.second[1 + 2 * 0] * slope_two_sum[0 + 2 * 1]
            + two_by_two.second[1 + 2 * 1] * slope_two_sum[1 + 2 * 1]
    };
    const double three_by_three_state[2] = {
        state[0] + two_by_two.first[0] * half,
        state[1] + two_by_two.first[1] * half
    };
    pair_vector2_f64_matrix2x2_f64_t three_by_three;
    smoothing_swing_jacobian(three_by_three_state, &three_by_three);
    const double slope_three_sum[4] = {
        identity[0 + 2 * 0] + slope_two[0 + 2 * 0] * half,
        identity[1 + 2 * 0] + slope_two[1 + 2 * 0] * half,
        identity[0 + 2 * 1] + slope_two[0 + 2 * 1] * half,
        identity[1 + 2 * 1] + slope_two[1 + 2 * 1] * half
    };
    const double slope_three[4] = {
        three_by_three.second[0 + 2 * 0] * slope_three_sum[0 + 2 * 0]
            + three_by_three.second[0 + 2 * 1] * slope_three_sum[1 + 2 * 0],
        three_by_three.second[1 + 2 * 0] * slope_three_sum[0 + 2 * 0]
            + three_by_three.second[1 + 2 * 1] * slope_three_sum[1 + 2 * 0],
        three_by_three.second[0 + 2 * 0] * slope_three_sum[0 + 2 * 1]
            + three_by_three.second[0 + 2 * 1] * slope_three_sum[1 + 2 * 1],
        three_by_three.second[1 + 2 * 0] * slope_three_sum[0 + 2 * 1]
            + three_by_three.second[1 + 2 * 1] * slope_three_sum[1 + 2 * 1]
    };
    const double four_by_four_state[2] = {
        state[0] + three_by_three.first[0] * period,
        state[1] + three_by_three.first[1] * period
    };
    pair_vector2_f64_matrix2x2_f64_t four_by_four;
    smoothing_swing_jacobian(four_by_four_state, &four_by_four);
    const double slope_four_sum[4] = {
        identity[0 + 2 * 0] + slope_three[0 + 2 * 0] * period,
        identity[1 + 2 * 0] + slope_three[1 + 2 * 0] * period,
        identity[0 + 2 * 1] + slope_three[0 + 2 * 1] * period,
        identity[1 + 2 * 1] + slope_three[1 + 2 * 1] * period
    };
    const double slope_four[4] = {
        four_by_four.second[0 + 2 * 0] * slope_four_sum[0 + 2 * 0]
            + four_by_four.second[0 + 2 * 1] * slope_four_sum[1 + 2 * 0],
        four_by_four.second[1 + 2 * 0] * slope_four_sum[0 + 2 * 0]
            + four_by_four.second[1 + 2 * 1] * slope_four_sum[1 + 2 * 0],
        four_by_four.second[0 + 2 * 0] * slope_four_sum[0 + 2 * 1]
            + four_by_four.second[0 + 2 * 1] * slope_four_sum[1 + 2 * 1],
        four_by_four.second[1 + 2 * 0] * slope_four_sum[0 + 2 * 1]
            + four_by_four.second[1 + 2 * 1] * slope_four_sum[1 + 2 * 1]
    };
    result->first[0] = state[0] + (one_slope_one.first[0]
        + (two_by_two.first[0] + three_by_three.first[0]) * 2.0 + four_by_four.first[0]) * sixth;
    result->first[1] = state[1] + (one_slope_one.first[1]
        + (two_by_two.first[1] + three_by_three.first[1]) * 2.0 + four_by_four.first[1]) * sixth;
    result->second[0 + 2 * 0] = identity[0 + 2 * 0]
        + (one_slope_one.second[0 + 2 * 0] + (slope_two[0 + 2 * 0] + slope_three[0 + 2 * 0]) * 2.0
        + slope_four[0 + 2 * 0]) * sixth;
    result->second[1 + 2 * 0] = identity[1 + 2 * 0]
        + (one_slope_one.second[1 + 2 * 0] + (slope_two[1 + 2 * 0] + slope_three[1 + 2 * 0]) * 2.0
        + slope_four[1 + 2 * 0]) * sixth;
    result->second[0 + 2 * 1] = identity[0 + 2 * 1]
        + (one_slope_one.second[0 + 2 * 1] + (slope_two[0 + 2 * 1] + slope_three[0 + 2 * 1]) * 2.0
        + slope_four[0 + 2 * 1]) * sixth;
    result->second[1 + 2 * 1] = identity[1 + 2 * 1]
        + (one_slope_one.second[1 + 2 * 1] + (slope_two[1 + 2 * 1] + slope_three[1 + 2 * 1]) * 2.0
        + slope_four[1 + 2 * 1]) * sixth;
}

void smoothing_turned(const float matrix[4], float result[BESSEMER_RESTRICT 4])
{
    continuous_exponential_f32_2(matrix, UINT64_C(4), result);
}

void smoothing_by_root(const double p[4], const double removed[2],
    pair_bool_matrix2x2_f64_t *BESSEMER_RESTRICT result)
{
    symmetric_f64_2_t start_covariance;
    symmetric_f64_2_of_lower(p, &start_covariance);
    option_rooted_f64_2_t start;
    rooted_f64_2_of(&start_covariance, &start);
    if (!start.is_some) {
        result->first = false;
        result->second[0] = p[0];
        result->second[1] = p[1];
        result->second[2] = p[2];
        result->second[3] = p[3];
        return;
    }
    rooted_f64_2_t root = start.value;
    double jacobian[4];
    smoothing_transition(jacobian);
    const double deviations[2] = {0.1, 0.2};
    rooted_f64_2_predict(&root, jacobian, deviations);
    const bool kept = rooted_f64_2_remove(&root, removed);
    symmetric_f64_2_t self;
    rooted_f64_2_covariance(&root, &self);
    result->first = kept;
    result->second[0] = self.elements[0];
    result->second[1] = self.elements[1];
    result->second[2] = self.elements[2];
    result->second[3] = self.elements[3];
}

void smoothing_triangle(const double elements[9], const double right[3],
    pair_vector3_f64_matrix3x3_f64_t *BESSEMER_RESTRICT result)
{
    upper_triangular_f64_3_t upper;
    (void)memcpy(upper.elements, elements, sizeof(double[9]));
    option_vector3_f64_t solution;
    upper_triangular_f64_3_solve(&upper, right, &solution);
    if (solution.is_some) {
        double vector[3];
        upper_triangular_f64_3_times(&upper, solution.value, vector);
        symmetric_f64_3_t self;
        upper_triangular_f64_3_square(&upper, &self);
        result->first[0] = vector[0];
        result->first[1] = vector[1];
        result->first[2] = vector[2];
        (void)memcpy(result->second, self.elements, sizeof(double[9]));
    } else {
        double result_second[9];
        upper_triangular_f64_3_matrix(&upper, result_second);
        result->first[0] = 0.0;
        result->first[1] = 0.0;
        result->first[2] = 0.0;
        (void)memcpy(result->second, result_second, sizeof(double[9]));
    }
}
