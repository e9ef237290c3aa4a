/* The C of tests/corpus/src/programs/functions/gradients.rs. Written by a test. */

/* gradients.c */

void gradients_rate(const double state[2], double torque, double result[BESSEMER_RESTRICT 2])
{
    double drag;
    if (state[1] > 1.0) {
        drag = 0.25 * state[1] * state[1];
    } else {
        drag = 0.5 * state[1];
    }
    result[0] = state[1];
    result[1] = torque - sine_sin(state[0]) - drag;
}

double gradients_rollout_cost(const double start[2], const double torques[50])
{
    double state[2] = {start[0], start[1]};
    double cost = 0.0;
    for (uint32_t k = 0U; k < 50U; k++) {
        const double torque = torques[k];
        double state_rate[2];
        gradients_rate(state, torque, state_rate);
        state[0] += state_rate[0] * 0.05;
        state[1] += state_rate[1] * 0.05;
        cost += 0.01 * torque * torque;
        if (state[0] > 4.0) {
            break;
        }
        cost += fabs(state[1]) * 0.001;
    }
    const double left = state[0] - 3.0;
    return cost + left * left;
}

void gradients_rollout_gradient(const double start[2], const double torques[50],
    double work[BESSEMER_RESTRICT 250],
    triple_f64_vector2_f64_vector50_f64_t *BESSEMER_RESTRICT result)
{
    double *const cost_kept = work;
    for (uint32_t i = 0U; i < 50U; i++) {
        cost_kept[i] = 0.0;
    }
    double *const state_1_kept = &work[50];
    for (uint32_t i = 0U; i < 50U; i++) {
        state_1_kept[i] = 0.0;
    }
    double *const state_0_kept = &work[100];
    for (uint32_t i = 0U; i < 50U; i++) {
        state_0_kept[i] = 0.0;
    }
    double *const state_1_kept_2 = &work[150];
    for (uint32_t i = 0U; i < 50U; i++) {
        state_1_kept_2[i] = 0.0;
    }
    double *const state_0_kept_2 = &work[200];
    for (uint32_t i = 0U; i < 50U; i++) {
        state_0_kept_2[i] = 0.0;
    }
    double state_0 = start[0];
    double state_1 = start[1];
    double cost = 0.0;
    uint64_t last = UINT64_C(0);
    for (uint32_t k = 0U; k < 50U; k++) {
        last = k;
        const double state_0_before = state_0;
        state_0_kept[k] = state_0_before;
        const double state_1_before = state_1;
        state_1_kept[k] = state_1_before;
        const double cost_before = cost;
        double drag;
        if (state_1_before > 1.0) {
            const double drag_2 = 0.25 * state_1_before;
            const double drag_3 = drag_2 * state_1_before;
            drag = drag_3;
        } else {
            const double drag_2 = 0.5 * state_1_before;
            drag = drag_2;
        }
        const double sin_state_0 = sine_sin(state_0_before);
        const double torques_at = torques[k];
        const double rate_1 = torques_at - sin_state_0 - drag;
        const double state_0_2 = state_1_before * 0.05;
        const double state_1_2 = rate_1 * 0.05;
        const double state_0_3 = state_0_before + state_0_2;
        state_0_kept_2[k] = state_0_3;
        const double state_1_3 = state_1_before + state_1_2;
        state_1_kept_2[k] = state_1_3;
        const double cost_2 = 0.01 * torques_at;
        const double cost_3 = cost_before + cost_2 * torques_at;
        if (state_0_3 > 4.0) {
            state_0 = state_0_3;
            state_1 = state_1_3;
            cost = cost_3;
            break;
        } else {
            const double cost_4 = fabs(state_1_3);
            cost_kept[k] = cost_4;
            const double cost_5 = cost_3 + cost_4 * 0.001;
            state_0 = state_0_3;
            state_1 = state_1_3;
            cost = cost_5;
        }
    }
    const double left = state_0 - 3.0;
    const double result_value = cost + left * left;
    for (uint32_t i = 0U; i < 50U; i++) {
        result->third[i] = 0.0;
    }
    const double left_bar = left * 2.0;
    double state_0_bar = left_bar;
    double state_1_bar = 0.0;
    const double cost_bar = 1.0;
    for (uint32_t k = 50U; k-- > 0U;) {
        if (k <= last) {
            double state_1_bar_2;
            if (state_0_kept_2[k] > 4.0) {
                state_1_bar_2 = state_1_bar;
            } else {
                const double cost_bar_2 = 0.001 * cost_bar;
                double slope_d0;
                if (cost_kept[k] == state_1_kept_2[k]) {
                    slope_d0 = 1.0;
                } else {
                    slope_d0 = -1.0;
                }
                state_1_bar_2 = state_1_bar + slope_d0 * cost_bar_2;
            }
            const double cost_bar_2 = torques[k] * cost_bar;
            const double rate_1_bar = 0.05 * state_1_bar_2;
            const double torques_at_bar = 0.01 * torques[k] * cost_bar + 0.01 * cost_bar_2
                + rate_1_bar;
            result->third[k] = torques_at_bar;
            const double sin_state_0_bar = -rate_1_bar;
            const double cos_state_0_before = sine_cos(state_0_kept[k]);
            const double drag_bar = -rate_1_bar;
            double state_1_before_bar;
            if (state_1_kept[k] > 1.0) {
                const double drag_bar_2 = state_1_kept[k] * drag_bar;
                state_1_before_bar = 0.25 * state_1_kept[k] * drag_bar + 0.25 * drag_bar_2;
            } else {
                state_1_before_bar = 0.5 * drag_bar;
            }
            const double state_1_before_bar_2 = state_1_bar_2 + 0.05 * state_0_bar
                + state_1_before_bar;
            const double state_0_before_bar = state_0_bar + cos_state_0_before * sin_state_0_bar;
            state_0_bar = state_0_before_bar;
            state_1_bar = state_1_before_bar_2;
        }
    }
    result->first = result_value;
    result->second[0] = state_0_bar;
    result->second[1] = state_1_bar;
}

float gradients_misfit(const float line[2], const float covariance[4])
{
    const float residual[2] = {line[0] - 1.0F, line[0] * line[1] + 0.5F};
    option_cholesky_factor_f32_2_t factor;
    cholesky_factored_f32_2(covariance, &factor);
    if (factor.is_some) {
        float result_solve_1[2];
        cholesky_factor_f32_2_solve_1(&factor.value, residual, result_solve_1);
        return residual[0] * result_solve_1[0] + residual[1] * result_solve_1[1];
    } else {
        return residual[0] * residual[0] + residual[1] * residual[1];
    }
}

void gradients_misfit_gradient(const float line[2], const float covariance[4],
    triple_f32_vector2_f32_matrix2x2_f32_t *BESSEMER_RESTRICT result)
{
    float result_value = 0.0F;
    float result_2 = 0.0F;
    float solution[2] = {0.0F, 0.0F};
    const float residual_0 = line[0] - 1.0F;
    const float residual_1 = line[0] * line[1] + 0.5F;
    float lower[4];
    cholesky_lower_f32_2(covariance, lower);
    const bool factor_0 = lower[0 + 2 * 0] > 0.0F;
    float result_3;
    if (factor_0) {
        solution[0] = residual_0;
        solution[1] = residual_1;
        cholesky_solve_f32_2(lower, solution);
        result_2 = solution[0];
        result_value = solution[1];
        const float result_4 = residual_0 * result_2 + residual_1 * result_value;
        result_3 = result_4;
    } else {
        const float result_4 = 0.0F + (residual_0 * residual_0 + residual_1 * residual_1);
        result_3 = result_4;
    }
    float residual_0_bar;
    float residual_1_bar;
    float lower_bar;
    float lower_bar_2;
    float lower_bar_3;
    if (factor_0) {
        float solution_bar[2] = {residual_0, residual_1};
        cholesky_solve_f32_2(lower, solution_bar);
        residual_0_bar = result_2 + solution_bar[0];
        residual_1_bar = result_value + solution_bar[1];
        lower_bar = -(solution_bar[0] * solution[0]);
        lower_bar_2 = -(solution_bar[1] * solution[0] + solution_bar[0] * solution[1]);
        lower_bar_3 = -(solution_bar[1] * solution[1]);
    } else {
        residual_0_bar = residual_0 * 2.0F;
        residual_1_bar = residual_1 * 2.0F;
        lower_bar = 0.0F;
        lower_bar_2 = 0.0F;
        lower_bar_3 = 0.0F;
    }
    result->first = result_3;
    result->second[0] = line[1] * residual_1_bar + residual_0_bar;
    result->second[1] = line[0] * residual_1_bar;
    result->third[0 + 2 * 0] = lower_bar;
    result->third[1 + 2 * 0] = lower_bar_2;
    result->third[0 + 2 * 1] = 0.0F;
    result->third[1 + 2 * 1] = lower_bar_3;
}

void gradients_gradient_along(const float line[2], const float way[2], float length,
    float gradient[BESSEMER_RESTRICT 2])
{
    const float pair_line[2] = {line[0] + way[0] * length, line[1] + way[1] * length};
    const float pair_covariance[4] = {
        1.0F, 0.0F,
        0.0F, 1.0F
    };
    triple_f32_vector2_f32_matrix2x2_f32_t pair;
    gradients_misfit_gradient(pair_line, pair_covariance, &pair);
    gradient[0] = pair.second[0];
    gradient[1] = pair.second[1];
}

void gradients_hessian_product(const float line[2], const float way[2], float length,
    pair_vector2_f32_vector2_f32_t *BESSEMER_RESTRICT result)
{
    const float pair_0 = way[0] * length;
    const float pair_1 = way[1] * length;
    const float line_0 = line[0] + pair_0;
    const float line_1 = line[1] + pair_1;
    const float residual_0 = line_0 - 1.0F;
    const float residual_1 = line_0 * line_1 + 0.5F;
    const float residual_1_d0 = line_1 * way[0] + line_0 * way[1];
    const float lower_matrix[4] = {
        1.0F, 0.0F,
        0.0F, 1.0F
    };
    float lower[4];
    cholesky_lower_f32_2(lower_matrix, lower);
    const bool factor_0 = lower[0 + 2 * 0] > 0.0F;
    float result_2;
    float result_2_d0;
    float result_value;
    float result_d0;
    if (factor_0) {
        float solution[2] = {residual_0, residual_1};
        cholesky_solve_f32_2(lower, solution);
        float solution_d[2] = {way[0], residual_1_d0};
        cholesky_solve_f32_2(lower, solution_d);
        result_2 = solution[0];
        result_2_d0 = solution_d[0];
        result_value = solution[1];
        result_d0 = solution_d[1];
    } else {
        result_2 = 0.0F;
        result_2_d0 = 0.0F;
        result_value = 0.0F;
        result_d0 = 0.0F;
    }
    float residual_0_bar;
    float residual_0_bar_d0;
    float residual_1_bar;
    float residual_1_bar_d0;
    if (factor_0) {
        float solution[2] = {residual_0, residual_1};
        cholesky_solve_f32_2(lower, solution);
        float solution_d[2] = {way[0], residual_1_d0};
        cholesky_solve_f32_2(lower, solution_d);
        const float residual_0_bar_2 = result_2 + solution[0];
        const float residual_0_bar_d0_2 = result_2_d0 + solution_d[0];
        const float residual_1_bar_2 = result_value + solution[1];
        const float residual_1_bar_d0_2 = result_d0 + solution_d[1];
        residual_0_bar = residual_0_bar_2;
        residual_0_bar_d0 = residual_0_bar_d0_2;
        residual_1_bar = residual_1_bar_2;
        residual_1_bar_d0 = residual_1_bar_d0_2;
    } else {
        const float residual_0_bar_2 = residual_0 * 2.0F;
        const float residual_0_bar_d0_2 = 2.0F * way[0];
        const float residual_1_bar_2 = residual_1 * 2.0F;
        const float residual_1_bar_d0_2 = 2.0F * residual_1_d0;
        residual_0_bar = residual_0_bar_2;
        residual_0_bar_d0 = residual_0_bar_d0_2;
        residual_1_bar = residual_1_bar_2;
        residual_1_bar_d0 = residual_1_bar_d0_2;
    }
    const float pair_1_0 = line_1 * residual_1_bar + residual_0_bar;
    const float pair_1_0_d0 = residual_1_bar * way[1] + line_1 * residual_1_bar_d0
        + residual_0_bar_d0;
    const float pair_1_1 = line_0 * residual_1_bar;
    const float pair_1_1_d0 = residual_1_bar * way[0] + line_0 * residual_1_bar_d0;
    result->second[0] = pair_1_0_d0;
    result->second[1] = pair_1_1_d0;
    result->first[0] = pair_1_0;
    result->first[1] = pair_1_1;
}

double gradients_window_cost(double share, const list40_f64_t *errors)
{
    double level = 0.0;
    double cost = 0.0;
    {
        const uint32_t end = (uint32_t)min_u64(errors->length, UINT64_C(40));
        for (uint32_t i = 0U; i < end; i++) {
            level = share * level + (1.0 - share) * errors->items[i];
            cost += level * level;
        }
    }
    return cost;
}

bessemer_status_t gradients_window_slope(double share, const list40_f64_t *errors,
    double work[BESSEMER_RESTRICT 80], pair_f64_f64_t *BESSEMER_RESTRICT result)
{
    double *const level_kept = work;
    for (uint32_t i = 0U; i < 40U; i++) {
        level_kept[i] = 0.0;
    }
    double *const level_kept_2 = &work[40];
    for (uint32_t i = 0U; i < 40U; i++) {
        level_kept_2[i] = 0.0;
    }
    double level = 0.0;
    double cost = 0.0;
    {
        const uint32_t end = (uint32_t)min_u64(errors->length, UINT64_C(40));
        for (uint32_t i = 0U; i < end; i++) {
            const double level_before = level;
            level_kept[i] = level_before;
            const double cost_before = cost;
            if (errors->length > UINT64_C(40) || i >= errors->length) {
                return BESSEMER_STATUS_INDEX;
            }
            const double level_2 = share * level_before + (1.0 - share) * errors->items[i];
            level_kept_2[i] = level_2;
            const double cost_2 = cost_before + level_2 * level_2;
            level = level_2;
            cost = cost_2;
        }
    }
    double level_bar = 0.0;
    const double cost_bar = 1.0;
    double share_bar = 0.0;
    for (uint32_t i = (uint32_t)min_u64(errors->length, UINT64_C(40)); i-- > 0U;) {
        const double level_bar_2 = level_bar + level_kept_2[i] * (2.0 * cost_bar);
        const double level_before_bar = share * level_bar_2;
        if (errors->length > UINT64_C(40) || i >= errors->length) {
            return BESSEMER_STATUS_INDEX;
        }
        share_bar += level_kept[i] * level_bar_2 - errors->items[i] * level_bar_2;
        level_bar = level_before_bar;
    }
    result->first = cost;
    result->second = share_bar;
    return BESSEMER_STATUS_OK;
}
