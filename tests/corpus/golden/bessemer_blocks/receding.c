/* The C of blocks/src/receding.rs. Written by a test. */

/* real_time_iteration_f64_4_1_1_8_8_16_12.c */

void real_time_iteration_f64_4_1_1_8_8_16_12_init(real_time_iteration_f64_4_1_1_8_8_16_12_t *self)
{
    for (uint32_t i = 0U; i < 8U; i++) {
        self->inputs[i][0] = 0.0;
    }
    for (uint32_t i = 0U; i < 8U; i++) {
        self->states[i][0] = 0.0;
        self->states[i][1] = 0.0;
        self->states[i][2] = 0.0;
        self->states[i][3] = 0.0;
    }
    active_set_f64_8_16_12_init(&self->solver);
}

void real_time_iteration_f64_4_1_1_8_8_16_12_begin(
    real_time_iteration_f64_4_1_1_8_8_16_12_t *BESSEMER_RESTRICT self, const double state[4],
    const double input[1])
{
    for (uint32_t k = 0U; k < 8U; k++) {
        self->inputs[k][0] = input[0];
        self->states[k][0] = state[0];
        self->states[k][1] = state[1];
        self->states[k][2] = state[2];
        self->states[k][3] = state[3];
    }
}

void real_time_iteration_f64_4_1_1_8_8_16_12_improve_in_step(
    real_time_iteration_f64_4_1_1_8_8_16_12_t *BESSEMER_RESTRICT self,
    const horizon_f64_4_1_1_t *horizon, const double measured[4], const double targets[8][4],
    double work_numbers[BESSEMER_RESTRICT 256], double work_matrices[BESSEMER_RESTRICT 8][32],
    option_active_set_program_f64_8_16_t *BESSEMER_RESTRICT work_option_active_set_program_f64_8_16,
    option_cholesky_factor_f64_8_t *BESSEMER_RESTRICT work_option_cholesky_factor_f64_8,
    receding_f64_1_t *BESSEMER_RESTRICT receding_f64_1)
{
    double *const hessian = work_numbers;
    for (uint32_t i = 0U; i < 64U; i++) {
        hessian[i] = 0.0;
    }
    double gradient[8] = {0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
    double *const rows = &work_numbers[64];
    for (uint32_t i = 0U; i < 128U; i++) {
        rows[i] = 0.0;
    }
    double low[16] = {0};
    double high[16] = {0};

    /* The change of a state is `free` + `forced` Δu. */
    double free[4] = {0.0, 0.0, 0.0, 0.0};
    double forced[32] = {0};
    double changes[8][4];
    double (*const by_input)[32] = work_matrices;
    for (uint32_t i = 0U; i < 8U; i++) {
        (void)memcpy(by_input[i], forced, sizeof(double[32]));
    }
    double state[4] = {measured[0], measured[1], measured[2], measured[3]};
    for (uint32_t k = 0U; k < 8U; k++) {
        triple_vector4_f64_matrix4x4_f64_vector4_f64_t law;
        balancing_swung_jacobian(state, self->inputs[k], &law);
        double forced_next[32];
        product_f64_4x4_4x8(law.second, forced, forced_next);
        (void)memcpy(forced, forced_next, sizeof(double[32]));
        for (uint32_t j = 0U; j < 1U; j++) {
            const uint32_t at = (uint32_t)min_u64(u64_from_u32(k * 1U + j), UINT64_C(7));
            for (uint32_t i = 0U; i < 4U; i++) {
                forced[i + 4U * at] = law.third[i];
            }
        }
        const double free_product[4] = {
            law.second[0 + 4 * 0] * free[0] + law.second[0 + 4 * 1] * free[1]
                + law.second[0 + 4 * 2] * free[2] + law.second[0 + 4 * 3] * free[3],
            law.second[1 + 4 * 0] * free[0] + law.second[1 + 4 * 1] * free[1]
                + law.second[1 + 4 * 2] * free[2] + law.second[1 + 4 * 3] * free[3],
            law.second[2 + 4 * 0] * free[0] + law.second[2 + 4 * 1] * free[1]
                + law.second[2 + 4 * 2] * free[2] + law.second[2 + 4 * 3] * free[3],
            law.second[3 + 4 * 0] * free[0] + law.second[3 + 4 * 1] * free[1]
                + law.second[3 + 4 * 2] * free[2] + law.second[3 + 4 * 3] * free[3]
        };
        free[0] = free_product[0] + (law.first[0] - self->states[k][0]);
        free[1] = free_product[1] + (law.first[1] - self->states[k][1]);
        free[2] = free_product[2] + (law.first[2] - self->states[k][2]);
        free[3] = free_product[3] + (law.first[3] - self->states[k][3]);
        changes[k][0] = free[0];
        changes[k][1] = free[1];
        changes[k][2] = free[2];
        changes[k][3] = free[3];
        (void)memcpy(by_input[k], forced, sizeof(double[32]));
        state[0] = self->states[k][0];
        state[1] = self->states[k][1];
        state[2] = self->states[k][2];
        state[3] = self->states[k][3];
        const double planned[4] = {
            state[0] + free[0],
            state[1] + free[1],
            state[2] + free[2],
            state[3] + free[3]
        };
        double weight[16];
        if (k + 1U == 8U) {
            (void)memcpy(weight, horizon->last, sizeof(double[16]));
        } else {
            (void)memcpy(weight, horizon->state, sizeof(double[16]));
        }
        double weighted[32];
        product_f64_4x4_4x8(weight, forced, weighted);
        double *const hessian_product = &work_numbers[192];
        tr_mul_f64_4x8_4x8(forced, weighted, hessian_product);
        for (uint32_t i = 0U; i < 64U; i++) {
            hessian[i] += hessian_product[i];
        }
        const double gradient_difference[4] = {
            planned[0] - targets[k][0],
            planned[1] - targets[k][1],
            planned[2] - targets[k][2],
            planned[3] - targets[k][3]
        };
        const double gradient_product[8] = {
            weighted[0 + 4 * 0] * gradient_difference[0]
                + weighted[2 + 4 * 0] * gradient_difference[2]
                + (weighted[1 + 4 * 0] * gradient_difference[1]
                + weighted[3 + 4 * 0] * gradient_difference[3]),
            weighted[0 + 4 * 1] * gradient_difference[0]
                + weighted[2 + 4 * 1] * gradient_difference[2]
                + (weighted[1 + 4 * 1] * gradient_difference[1]
                + weighted[3 + 4 * 1] * gradient_difference[3]),
            weighted[0 + 4 * 2] * gradient_difference[0]
                + weighted[2 + 4 * 2] * gradient_difference[2]
                + (weighted[1 + 4 * 2] * gradient_difference[1]
                + weighted[3 + 4 * 2] * gradient_difference[3]),
            weighted[0 + 4 * 3] * gradient_difference[0]
                + weighted[2 + 4 * 3] * gradient_difference[2]
                + (weighted[1 + 4 * 3] * gradient_difference[1]
                + weighted[3 + 4 * 3] * gradient_difference[3]),
            weighted[0 + 4 * 4] * gradient_difference[0]
                + weighted[2 + 4 * 4] * gradient_difference[2]
                + (weighted[1 + 4 * 4] * gradient_difference[1]
                + weighted[3 + 4 * 4] * gradient_difference[3]),
            weighted[0 + 4 * 5] * gradient_difference[0]
                + weighted[2 + 4 * 5] * gradient_difference[2]
                + (weighted[1 + 4 * 5] * gradient_difference[1]
                + weighted[3 + 4 * 5] * gradient_difference[3]),
            weighted[0 + 4 * 6] * gradient_difference[0]
                + weighted[2 + 4 * 6] * gradient_difference[2]
                + (weighted[1 + 4 * 6] * gradient_difference[1]
                + weighted[3 + 4 * 6] * gradient_difference[3]),
            weighted[0 + 4 * 7] * gradient_difference[0]
                + weighted[2 + 4 * 7] * gradient_difference[2]
                + (weighted[1 + 4 * 7] * gradient_difference[1]
                + weighted[3 + 4 * 7] * gradient_difference[3])
        };
        BESSEMER_FEW_PASSES
        for (uint32_t i = 0U; i < 8U; i++) {
            gradient[i] += gradient_product[i];
        }
        const double cost_difference[1] = {self->inputs[k][0] - horizon->rest[0]};
        const double cost[1] = {horizon->input[0] * cost_difference[0]};
        for (uint32_t j = 0U; j < 1U; j++) {
            const uint32_t at = (uint32_t)min_u64(u64_from_u32(k * 1U + j), UINT64_C(7));
            for (uint32_t i = 0U; i < 1U; i++) {
                hessian[min_u64(u64_from_u32(k * 1U + i),
                    UINT64_C(7)) + 8U * at] += horizon->input[i];
            }
            gradient[at] += cost[j];
            const uint32_t row = (uint32_t)min_u64((uint64_t)at, UINT64_C(15));
            rows[row + 16U * at] = 1.0;
            low[row] = horizon->low[j] - self->inputs[k][j];
            high[row] = horizon->high[j] - self->inputs[k][j];
        }
        const double seen[1] = {
            horizon->outputs[0] * planned[0] + horizon->outputs[1] * planned[1]
                + horizon->outputs[2] * planned[2] + horizon->outputs[3] * planned[3]
        };
        double caused[8];
        product_f64_1x4_4x8(horizon->outputs, forced, caused);
        for (uint32_t i = 0U; i < 1U; i++) {
            const uint32_t row = (uint32_t)min_u64(u64_from_u32(k * 1U + 8U + i), UINT64_C(15));
            for (uint32_t at = 0U; at < 8U; at++) {
                rows[row + 16U * at] = caused[at];
            }
            low[row] = horizon->lowest[i] - seen[i];
            high[row] = horizon->highest[i] - seen[i];
        }
    }
    outcome_t outcome = OUTCOME_UNFINISHED;
    double violation = 0.0;
    option_active_set_program_f64_8_16_t *const program = work_option_active_set_program_f64_8_16;
    active_set_program_f64_8_16_new(hessian, rows, horizon->tolerance,
        work_option_cholesky_factor_f64_8, &work_numbers[192], program);
    if (program->is_some) {
        minimum_f64_8_t found;
        active_set_f64_8_16_12_step(&self->solver, &program->value, gradient, low, high, &found);
        outcome = found.outcome;
        violation = found.violation;
        if (outcome != OUTCOME_INFEASIBLE && isfinite(dot_f64_8(found.point, found.point)) != 0) {
            for (uint32_t k = 0U; k < 8U; k++) {
                double states_product[4];
                product_f64_4x8_8x1(by_input[k], found.point, states_product);
                self->states[k][0] += changes[k][0] + states_product[0];
                self->states[k][1] += changes[k][1] + states_product[1];
                self->states[k][2] += changes[k][2] + states_product[2];
                self->states[k][3] += changes[k][3] + states_product[3];
                for (uint32_t j = 0U; j < 1U; j++) {
                    self->inputs[k][j] += found.point[min_u64(u64_from_u32(k * 1U + j),
                        UINT64_C(7))];
                }
            }
        }
    }
    receding_f64_1->input[0] = lower_f64(upper_f64(self->inputs[0][0], horizon->low[0]),
        horizon->high[0]);
    receding_f64_1->outcome = outcome;
    receding_f64_1->violation = violation;
}

/* real_time_iteration_f64_4_1_1_8_8_16_12.h */

/**
 * Nonlinear predictive control of `X` states, `U` inputs and `Y` outputs with limits, over `H` periods.
 *
 * `N` is `U` × `H`, the inputs of the horizon, and `M` is `N` + `Y` × `H`. With the Jacobians A(k), B(k) of the law along
 * the plan, and the gap d(k) = f(x(k), u(k)) − x(k+1) of its states, the change of the plan is Δx(k+1) = A(k) Δx(k) +
 * B(k) Δu(k) + d(k). The states are eliminated, and an `ActiveSet` of `I` changes finds the Δu of least cost within
 * the limits. It is the full step of Gauss and Newton, without a search along it. Of a program without a solution, and
 * of numbers that are not finite, the plan takes nothing. Initialisation: `RealTimeIteration::begin`; `Default`
 * plans to stay at 0. Source: Diehl, Bock and Schlöder, *A Real-Time Iteration Scheme for Nonlinear Optimization in
 * Optimal Feedback Control*, SIAM Journal on Control and Optimization 43 (5), 2005.
 *
 * ```
 * use bessemer::nalgebra::{Matrix1, SVector, Vector1};
 * use bessemer_blocks::{Horizon, Outcome, RealTimeIteration};
 *
 * // A tank's level x, with x' = u - sqrt(x), filled from 1 to 4 by at most 3.
 * let one = Matrix1::new(1.0);
 * let horizon = Horizon {
 *    state: one, last: one, input: one * 1e-3, rest: Vector1::new(2.0),
 *    low: Vector1::new(0.0), high: Vector1::new(3.0),
 *    outputs: one, lowest: Vector1::new(0.5), highest: Vector1::new(4.2), tolerance: 1e-9,
 * };
 * let law = |x: &Vector1<f64>, u: &Vector1<f64>| {
 *    let root = x[0].sqrt();
 *    (x + (u - Vector1::new(root)) * 0.1, Matrix1::new(1.0 - 0.05 / root), Matrix1::new(0.1))
 * };
 * let mut control = RealTimeIteration::<f64, 1, 1, 1, 10, 10, 20, 20>::default();
 * let mut level = Vector1::new(1.0);
 * control.begin(&level, &Vector1::new(1.0));
 * for _ in 0..40 {
 *    let found = control.step(&horizon, &level, &[Vector1::new(4.0); 10], law);
 *    assert_eq!(found.outcome, Outcome::Solved);
 *    level = law(&level, &found.input).0;
 * }
 * assert!((level[0] - 4.0).abs() < 1e-3);
 * ```
 */
typedef struct {
    /** The inputs u(0), u(1), …. */
    double inputs[8][1];
    /** The states x(1), x(2), …. */
    double states[8][4];
    /** Solver of the changes. */
    active_set_f64_8_16_12_t solver;
} real_time_iteration_f64_4_1_1_8_8_16_12_t;

/* receding.h */

/**
 * Cost and limits in each period of a horizon.
 *
 * The cost is half of Σ eᵀQe + (u − u₀)ᵀR(u − u₀), where e is the difference of a state from its target, with P in the
 * place of Q for the last state. A limit may be infinite.
 */
typedef struct {
    /** Q, positive semidefinite. A matrix by columns: [row + 4 * column]. */
    double state[16];
    /** P, positive semidefinite. A matrix by columns: [row + 4 * column]. */
    double last[16];
    /** R, positive definite. */
    double input[1];
    /** u₀, the input without cost. */
    double rest[1];
    /** Lower limits of the inputs. */
    double low[1];
    /** Upper limits of the inputs. */
    double high[1];
    /** C, for outputs y = C x with limits. */
    double outputs[4];
    /** Lower limits of the outputs. */
    double lowest[1];
    /** Upper limits of the outputs. */
    double highest[1];
    /** Largest violation of a limit that counts as none, above 0, in the unit of the limits. */
    double tolerance;
} horizon_f64_4_1_1_t;

/** Input of a period. */
typedef struct {
    /** The input, always within its limits. */
    float input[3];
    /**
     * Result of the solver; unless it is `Solved`, the plan may leave the limits of the outputs.
     */
    outcome_t outcome;
    /** Largest violation of a limit by the linear law. */
    float violation;
} receding_f32_3_t;

/** Input of a period. */
typedef struct {
    /** The input, always within its limits. */
    double input[1];
    /**
     * Result of the solver; unless it is `Solved`, the plan may leave the limits of the outputs.
     */
    outcome_t outcome;
    /** Largest violation of a limit by the linear law. */
    double violation;
} receding_f64_1_t;
