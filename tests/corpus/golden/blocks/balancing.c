/* The C of tests/corpus/src/programs/blocks/balancing.rs. Written by a test. */

/* balance.c */

static void balance_step_in_step(real_time_iteration_f64_4_1_1_8_8_16_12_t *BESSEMER_RESTRICT self,
    const horizon_f64_4_1_1_t *horizon, const double measured[4], const double targets[8][4],
    double work_numbers[BESSEMER_RESTRICT 256], double work_matrices[BESSEMER_RESTRICT 8][32],
    option_active_set_program_f64_8_16_t *BESSEMER_RESTRICT work_option_active_set_program_f64_8_16,
    option_cholesky_factor_f64_8_t *BESSEMER_RESTRICT work_option_cholesky_factor_f64_8,
    receding_f64_1_t *BESSEMER_RESTRICT found);

void balance_init(balance_t *self)
{
    real_time_iteration_f64_4_1_1_8_8_16_12_init(&self->plan);
}

void balance_begin(balance_t *BESSEMER_RESTRICT self, const double state[4])
{
    const double input[1] = {0.0};
    real_time_iteration_f64_4_1_1_8_8_16_12_begin(&self->plan, state, input);
}

void balance_step(balance_t *BESSEMER_RESTRICT self, const double state[4], double target,
    balance_step_work_t *BESSEMER_RESTRICT work,
    receding_f64_1_t *BESSEMER_RESTRICT receding_f64_1)
{
    const double weights[4] = {2.0, 4.0, 0.1, 0.2};
    double horizon_state[16];
    parts_from_diagonal_f64_4(weights, horizon_state);
    const double horizon_diagonal[4] = {
        weights[0] * 20.0,
        weights[1] * 20.0,
        weights[2] * 20.0,
        weights[3] * 20.0
    };
    double horizon_last[16];
    parts_from_diagonal_f64_4(horizon_diagonal, horizon_last);
    const double horizon_element = -12.0;
    const double horizon_element_2 = -0.8;
    horizon_f64_4_1_1_t *const horizon = &work->horizon;
    (void)memcpy(horizon->state, horizon_state, sizeof(double[16]));
    (void)memcpy(horizon->last, horizon_last, sizeof(double[16]));
    horizon->input[0] = 0.01;
    horizon->rest[0] = 0.0;
    horizon->low[0] = horizon_element;
    horizon->high[0] = 12.0;
    static const double new_outputs[4] = {1.0, 0.0, 0.0, 0.0};
    horizon->outputs[0] = new_outputs[0];
    horizon->outputs[1] = new_outputs[1];
    horizon->outputs[2] = new_outputs[2];
    horizon->outputs[3] = new_outputs[3];
    horizon->lowest[0] = horizon_element_2;
    horizon->highest[0] = 0.8;
    horizon->tolerance = 1e-6;
    const double targets_element[4] = {target, 0.0, 0.0, 0.0};
    double targets[8][4];
    for (uint32_t i = 0U; i < 8U; i++) {
        targets[i][0] = targets_element[0];
        targets[i][1] = targets_element[1];
        targets[i][2] = targets_element[2];
        targets[i][3] = targets_element[3];
    }
    balance_step_in_step(&self->plan, horizon, state, (const double (*)[4])targets, work->numbers,
        work->matrices, &work->option_active_set_program_f64_8_16,
        &work->option_cholesky_factor_f64_8, receding_f64_1);
}

/**
 * Improves the plan from the measured state, returns its first input, and moves it by one period.
 *
 * `targets` are those of x(1), x(2), …. `law` gives the state after a period, and its Jacobians by the state and by
 * the input: a `#[function(derivative(…))]`.
 * `work_numbers`, `work_matrices`, `work_option_active_set_program_f64_8_16`, `work_option_cholesky_factor_f64_8` are scratch memory; their contents mean nothing between calls.
 *
 * `work_matrices` each by columns: [row + 4 * column].
 */
static void balance_step_in_step(real_time_iteration_f64_4_1_1_8_8_16_12_t *BESSEMER_RESTRICT self,
    const horizon_f64_4_1_1_t *horizon, const double measured[4], const double targets[8][4],
    double work_numbers[BESSEMER_RESTRICT 256], double work_matrices[BESSEMER_RESTRICT 8][32],
    option_active_set_program_f64_8_16_t *BESSEMER_RESTRICT work_option_active_set_program_f64_8_16,
    option_cholesky_factor_f64_8_t *BESSEMER_RESTRICT work_option_cholesky_factor_f64_8,
    receding_f64_1_t *BESSEMER_RESTRICT found)
{
    real_time_iteration_f64_4_1_1_8_8_16_12_improve_in_step(self, horizon, measured,
        (const double (*)[4])targets, work_numbers, work_matrices,
        work_option_active_set_program_f64_8_16, work_option_cholesky_factor_f64_8, found);
    for (uint32_t k = 1U; k < 8U; k++) {
        self->inputs[k - 1U][0] = self->inputs[k][0];
        self->states[k - 1U][0] = self->states[k][0];
        self->states[k - 1U][1] = self->states[k][1];
        self->states[k - 1U][2] = self->states[k][2];
        self->states[k - 1U][3] = self->states[k][3];
    }
}

/* balance.h */

/** Balances a pendulum, within 0.8 m of the middle. */
typedef struct {
    real_time_iteration_f64_4_1_1_8_8_16_12_t plan;
} balance_t;

/* balancing.c */

static const double PERIOD = 0.05;

void balancing_swung(const double state[4], const double push[1],
    double result[BESSEMER_RESTRICT 4])
{
    pair_f64_f64_t sine_cosine;
    sine_sin_cos(state[1], &sine_cosine);

    /* A rod of 0.5 m with its mass at the end. */
    const double turn = (9.81 * sine_cosine.first - push[0] * sine_cosine.second) / 0.5
        - 0.1 * state[3];
    const double speed = state[2] + PERIOD * push[0];
    const double rate = state[3] + PERIOD * turn;
    result[0] = state[0] + PERIOD * speed;
    result[1] = state[1] + PERIOD * rate;
    result[2] = speed;
    result[3] = rate;
}

void balancing_swung_jacobian(const double state[4], const double push[1],
    triple_vector4_f64_matrix4x4_f64_vector4_f64_t *BESSEMER_RESTRICT result)
{
    pair_f64_f64_t sin_cos_state_1;
    sine_sin_cos(state[1], &sin_cos_state_1);
    const double slope = -sin_cos_state_1.first;
    const double turn = (9.81 * sin_cos_state_1.first - push[0] * sin_cos_state_1.second) / 0.5
        - 0.1 * state[3];
    const double turn_d1 = (9.81 * sin_cos_state_1.second - push[0] * slope) / 0.5;
    const double turn_d4 = -sin_cos_state_1.second / 0.5;
    const double speed = state[2] + PERIOD * push[0];
    const double rate = state[3] + PERIOD * turn;
    const double rate_d1 = PERIOD * turn_d1;
    const double rate_d3 = 1.0 + PERIOD * -0.1;
    const double rate_d4 = PERIOD * turn_d4;
    const double result_0 = state[0] + PERIOD * speed;
    const double result_0_d4 = PERIOD * PERIOD;
    const double result_1 = state[1] + PERIOD * rate;
    const double result_1_d1 = 1.0 + PERIOD * rate_d1;
    const double result_1_d3 = PERIOD * rate_d3;
    const double result_1_d4 = PERIOD * rate_d4;
    for (uint32_t i = 0U; i < 16U; i++) {
        result->second[i] = 0.0;
    }
    result->second[0 + 4 * 0] = 1.0;
    result->second[0 + 4 * 2] = PERIOD;
    result->second[1 + 4 * 1] = result_1_d1;
    result->second[1 + 4 * 3] = result_1_d3;
    result->second[2 + 4 * 2] = 1.0;
    result->second[3 + 4 * 1] = rate_d1;
    result->second[3 + 4 * 3] = rate_d3;
    result->third[0] = result_0_d4;
    result->third[1] = result_1_d4;
    result->third[2] = PERIOD;
    result->third[3] = rate_d4;
    result->first[0] = result_0;
    result->first[1] = result_1;
    result->first[2] = speed;
    result->first[3] = rate;
}

/* balancing.h */

/** Working memory of its entry point; the contents are undefined between calls. */
typedef struct {
    horizon_f64_4_1_1_t horizon;
    double numbers[256];
    /** A matrix each by columns: [row + 4 * column]. */
    double matrices[8][32];
    option_active_set_program_f64_8_16_t option_active_set_program_f64_8_16;
    option_cholesky_factor_f64_8_t option_cholesky_factor_f64_8;
} balance_step_work_t;

/* lander.c */

void lander_init(lander_t *self)
{
    riccati_admm_f32_6_3_8_1_3_10_init(&self->plan);
}

void lander_step(lander_t *BESSEMER_RESTRICT self, const riccati_program_f32_6_3_t *program,
    const float state[6], float result[BESSEMER_RESTRICT 3])
{
    static const float receding_f32_3_target[6] = {0.0F, 0.0F, 0.0F, 0.0F, 0.0F, 0.0F};
    receding_f32_3_t receding_f32_3;
    riccati_admm_f32_6_3_8_1_3_10_step(&self->plan, program, state, receding_f32_3_target,
        &receding_f32_3);
    result[0] = receding_f32_3.input[0];
    result[1] = receding_f32_3.input[1];
    result[2] = receding_f32_3.input[2];
}

/* lander.h */

/**
 * Controls a lander by a linear law of its position, m, and velocity, m/s, along three axes.
 * The input is the acceleration of its engine less gravity, m/s².
 */
typedef struct {
    riccati_admm_f32_6_3_8_1_3_10_t plan;
} lander_t;
