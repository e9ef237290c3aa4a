/* The C of blocks/src/riccati.rs. Written by a test. */

/* riccati.c */

bool riccati_proves_f32_6_3_8_1_3(const riccati_program_f32_6_3_t *program, const float measured[6],
    const float input_gaps[8][3], const float state_gaps[8][6])
{
    for (uint32_t i = 0U; i < 6U; i++) {
        if (program->lowest[i] > program->highest[i]) {
            return true;
        }
    }
    {
        const uint64_t end = (uint64_t)saturating_sub_u32(3U, 3U);
        for (uint64_t i = UINT64_C(0); i < end; i++) {
            if (program->low[i] > program->high[i]) {
                return true;
            }
        }
    }
    float size = 0.0F;
    for (uint32_t k = 0U; k < 8U; k++) {
        float largest = fabsf(state_gaps[k][0]);
        BESSEMER_FEW_PASSES
        for (uint32_t i = 1U; i < 6U; i++) {
            largest = larger_magnitude_f32(largest, fabsf(state_gaps[k][i]));
        }
        size = max_f32(max_f32(size, larger_magnitude_f32(
            larger_magnitude_f32(fabsf(input_gaps[k][0]), fabsf(input_gaps[k][1])),
            fabsf(input_gaps[k][2]))), largest);
    }
    const float small = size * 0.001F;
    float most = 0.0F;
    float steepest = 0.0F;
    float slope[6] = {0.0F, 0.0F, 0.0F, 0.0F, 0.0F, 0.0F};
    for (uint32_t k = 8U; k-- > 0U;) {
        BESSEMER_FEW_PASSES
        for (uint32_t i = 0U; i < 6U; i++) {
            slope[i] += state_gaps[k][i];
        }
        const float steepest_product[3] = {
            0.0F + program->by_input[0 + 6 * 0] * slope[0] + program->by_input[1 + 6 * 0] * slope[1]
                + program->by_input[2 + 6 * 0] * slope[2] + program->by_input[3 + 6 * 0] * slope[3]
                + program->by_input[4 + 6 * 0] * slope[4]
                + program->by_input[5 + 6 * 0] * slope[5],
            0.0F + program->by_input[0 + 6 * 1] * slope[0] + program->by_input[1 + 6 * 1] * slope[1]
                + program->by_input[2 + 6 * 1] * slope[2] + program->by_input[3 + 6 * 1] * slope[3]
                + program->by_input[4 + 6 * 1] * slope[4]
                + program->by_input[5 + 6 * 1] * slope[5],
            0.0F + program->by_input[0 + 6 * 2] * slope[0] + program->by_input[1 + 6 * 2] * slope[1]
                + program->by_input[2 + 6 * 2] * slope[2] + program->by_input[3 + 6 * 2] * slope[3]
                + program->by_input[4 + 6 * 2] * slope[4] + program->by_input[5 + 6 * 2] * slope[5]
        };
        steepest = max_f32(steepest, larger_magnitude_f32(
            larger_magnitude_f32(fabsf(input_gaps[k][0] + steepest_product[0]),
            fabsf(input_gaps[k][1] + steepest_product[1])),
            fabsf(input_gaps[k][2] + steepest_product[2])));
        const float slope_next[6] = {
            0.0F + program->by_state[0 + 6 * 0] * slope[0] + program->by_state[1 + 6 * 0] * slope[1]
                + program->by_state[2 + 6 * 0] * slope[2] + program->by_state[3 + 6 * 0] * slope[3]
                + program->by_state[4 + 6 * 0] * slope[4]
                + program->by_state[5 + 6 * 0] * slope[5],
            0.0F + program->by_state[0 + 6 * 1] * slope[0] + program->by_state[1 + 6 * 1] * slope[1]
                + program->by_state[2 + 6 * 1] * slope[2] + program->by_state[3 + 6 * 1] * slope[3]
                + program->by_state[4 + 6 * 1] * slope[4]
                + program->by_state[5 + 6 * 1] * slope[5],
            0.0F + program->by_state[0 + 6 * 2] * slope[0] + program->by_state[1 + 6 * 2] * slope[1]
                + program->by_state[2 + 6 * 2] * slope[2] + program->by_state[3 + 6 * 2] * slope[3]
                + program->by_state[4 + 6 * 2] * slope[4]
                + program->by_state[5 + 6 * 2] * slope[5],
            0.0F + program->by_state[0 + 6 * 3] * slope[0] + program->by_state[1 + 6 * 3] * slope[1]
                + program->by_state[2 + 6 * 3] * slope[2] + program->by_state[3 + 6 * 3] * slope[3]
                + program->by_state[4 + 6 * 3] * slope[4]
                + program->by_state[5 + 6 * 3] * slope[5],
            0.0F + program->by_state[0 + 6 * 4] * slope[0] + program->by_state[1 + 6 * 4] * slope[1]
                + program->by_state[2 + 6 * 4] * slope[2] + program->by_state[3 + 6 * 4] * slope[3]
                + program->by_state[4 + 6 * 4] * slope[4]
                + program->by_state[5 + 6 * 4] * slope[5],
            0.0F + program->by_state[0 + 6 * 5] * slope[0] + program->by_state[1 + 6 * 5] * slope[1]
                + program->by_state[2 + 6 * 5] * slope[2] + program->by_state[3 + 6 * 5] * slope[3]
                + program->by_state[4 + 6 * 5] * slope[4] + program->by_state[5 + 6 * 5] * slope[5]
        };
        (void)memcpy(slope, slope_next, sizeof(float[6]));
        const float inputs = admm_support_f32_3_1_3(input_gaps[k], program->low, program->high,
            small);
        const float states = admm_support_f32_6_0_0(state_gaps[k], program->lowest,
            program->highest, small);
        most += inputs + states;
    }
    return steepest <= small && most
        < 0.0F + slope[0] * measured[0] + slope[1] * measured[1] + slope[2] * measured[2]
        + slope[3] * measured[3] + slope[4] * measured[4] + slope[5] * measured[5] - small;
}

/* riccati.h */

/**
 * Law, cost and limits of a `RiccatiAdmm`, the same in each period.
 *
 * The cost is half of Σ eᵀQe + uᵀRu, where e is the difference of a state from the target, with P − wI in the place of Q
 * for the last state. A limit may be infinite, save the first one of a cone.
 */
typedef struct {
    /** A. A matrix by columns: [row + 6 * column]. */
    float by_state[36];
    /** B. A matrix by columns: [row + 6 * column]. */
    float by_input[18];
    /** Q. A matrix by columns: [row + 6 * column]. */
    float state[36];
    /** w, the weight of the limits. */
    float weight;
    /** P. A matrix by columns: [row + 6 * column]. */
    float last[36];
    /** K = (R + wI + BᵀPB)⁻¹BᵀPA. A matrix by columns: [row + 3 * column]. */
    float gain[18];
    /** (R + wI + BᵀPB)⁻¹. A matrix by columns: [row + 3 * column]. */
    float inverse[9];
    /** A − BK. A matrix by columns: [row + 6 * column]. */
    float closed[36];
    /** Lower limits of the states. */
    float lowest[6];
    /** Upper limits of the states. */
    float highest[6];
    /** Lower limits of the inputs. */
    float low[3];
    /** Upper limits of the inputs. */
    float high[3];
    /** Residual that counts as none, above 0. */
    float tolerance;
} riccati_program_f32_6_3_t;

/* riccati_admm_f32_6_3_8_1_3_10.c */

void riccati_admm_f32_6_3_8_1_3_10_init(riccati_admm_f32_6_3_8_1_3_10_t *self)
{
    for (uint32_t i = 0U; i < 8U; i++) {
        self->inputs[i][0] = 0.0F;
        self->inputs[i][1] = 0.0F;
        self->inputs[i][2] = 0.0F;
    }
    for (uint32_t i = 0U; i < 8U; i++) {
        self->input_remainders[i][0] = 0.0F;
        self->input_remainders[i][1] = 0.0F;
        self->input_remainders[i][2] = 0.0F;
    }
    for (uint32_t i = 0U; i < 8U; i++) {
        for (uint32_t j = 0U; j < 6U; j++) {
            self->states[i][j] = 0.0F;
        }
    }
    for (uint32_t i = 0U; i < 8U; i++) {
        for (uint32_t j = 0U; j < 6U; j++) {
            self->state_remainders[i][j] = 0.0F;
        }
    }
}

void riccati_admm_f32_6_3_8_1_3_10_step(riccati_admm_f32_6_3_8_1_3_10_t *BESSEMER_RESTRICT self,
    const riccati_program_f32_6_3_t *program, const float measured[6], const float target[6],
    receding_f32_3_t *BESSEMER_RESTRICT found)
{
    riccati_admm_f32_6_3_8_1_3_10_improve(self, program, measured, target, found);
    for (uint32_t k = 1U; k < 8U; k++) {
        self->inputs[k - 1U][0] = self->inputs[k][0];
        self->inputs[k - 1U][1] = self->inputs[k][1];
        self->inputs[k - 1U][2] = self->inputs[k][2];
        self->input_remainders[k - 1U][0] = self->input_remainders[k][0];
        self->input_remainders[k - 1U][1] = self->input_remainders[k][1];
        self->input_remainders[k - 1U][2] = self->input_remainders[k][2];
        (void)memmove(self->states[k - 1U], self->states[k], sizeof(float[6]));
        (void)memmove(self->state_remainders[k - 1U], self->state_remainders[k], sizeof(float[6]));
    }
}

void riccati_admm_f32_6_3_8_1_3_10_improve(riccati_admm_f32_6_3_8_1_3_10_t *BESSEMER_RESTRICT self,
    const riccati_program_f32_6_3_t *program, const float measured[6], const float target[6],
    receding_f32_3_t *BESSEMER_RESTRICT receding_f32_3)
{
    const float weight = program->weight;
    float pull[6];
    product_f32_6x6_6x1(program->state, target, pull);
    float last_pull_product[6];
    product_f32_6x6_6x1(program->last, target, last_pull_product);
    float last_pull[6];
    BESSEMER_FEW_PASSES
    for (uint32_t i = 0U; i < 6U; i++) {
        last_pull[i] = last_pull_product[i] - target[i] * weight;
    }
    float offsets[8][3] = {
        {0.0F, 0.0F, 0.0F},
        {0.0F, 0.0F, 0.0F},
        {0.0F, 0.0F, 0.0F},
        {0.0F, 0.0F, 0.0F},
        {0.0F, 0.0F, 0.0F},
        {0.0F, 0.0F, 0.0F},
        {0.0F, 0.0F, 0.0F},
        {0.0F, 0.0F, 0.0F}
    };
    float input_gaps[8][3];
    (void)memcpy(input_gaps, offsets, sizeof(float[8][3]));
    float state_gaps[8][6] = {
        {0.0F, 0.0F, 0.0F, 0.0F, 0.0F, 0.0F},
        {0.0F, 0.0F, 0.0F, 0.0F, 0.0F, 0.0F},
        {0.0F, 0.0F, 0.0F, 0.0F, 0.0F, 0.0F},
        {0.0F, 0.0F, 0.0F, 0.0F, 0.0F, 0.0F},
        {0.0F, 0.0F, 0.0F, 0.0F, 0.0F, 0.0F},
        {0.0F, 0.0F, 0.0F, 0.0F, 0.0F, 0.0F},
        {0.0F, 0.0F, 0.0F, 0.0F, 0.0F, 0.0F},
        {0.0F, 0.0F, 0.0F, 0.0F, 0.0F, 0.0F}
    };
    float residual = 0.0F;
    float violation = 0.0F;
    for (uint32_t pass = 0U; pass < 10U; pass++) {
        float slope[6] = {0.0F, 0.0F, 0.0F, 0.0F, 0.0F, 0.0F};
        for (uint32_t k = 8U; k-- > 0U;) {
            float linear[6];
            BESSEMER_FEW_PASSES
            for (uint32_t i = 0U; i < 6U; i++) {
                linear[i] = (self->state_remainders[k][i] - self->states[k][i]) * weight;
            }
            if (k + 1U == 8U) {
                BESSEMER_FEW_PASSES
                for (uint32_t i = 0U; i < 6U; i++) {
                    slope[i] = linear[i] - last_pull[i];
                }
            } else {
                BESSEMER_FEW_PASSES
                for (uint32_t i = 0U; i < 6U; i++) {
                    slope[i] = slope[i] + linear[i] - pull[i];
                }
            }
            const float own[3] = {
                (self->input_remainders[k][0] - self->inputs[k][0]) * weight,
                (self->input_remainders[k][1] - self->inputs[k][1]) * weight,
                (self->input_remainders[k][2] - self->inputs[k][2]) * weight
            };
            const float offsets_product[3] = {
                0.0F + program->by_input[0 + 6 * 0] * slope[0]
                    + program->by_input[1 + 6 * 0] * slope[1]
                    + program->by_input[2 + 6 * 0] * slope[2]
                    + program->by_input[3 + 6 * 0] * slope[3]
                    + program->by_input[4 + 6 * 0] * slope[4]
                    + program->by_input[5 + 6 * 0] * slope[5],
                0.0F + program->by_input[0 + 6 * 1] * slope[0]
                    + program->by_input[1 + 6 * 1] * slope[1]
                    + program->by_input[2 + 6 * 1] * slope[2]
                    + program->by_input[3 + 6 * 1] * slope[3]
                    + program->by_input[4 + 6 * 1] * slope[4]
                    + program->by_input[5 + 6 * 1] * slope[5],
                0.0F + program->by_input[0 + 6 * 2] * slope[0]
                    + program->by_input[1 + 6 * 2] * slope[1]
                    + program->by_input[2 + 6 * 2] * slope[2]
                    + program->by_input[3 + 6 * 2] * slope[3]
                    + program->by_input[4 + 6 * 2] * slope[4]
                    + program->by_input[5 + 6 * 2] * slope[5]
            };
            const float offsets_sum[3] = {
                offsets_product[0] + own[0],
                offsets_product[1] + own[1],
                offsets_product[2] + own[2]
            };
            offsets[k][0] = program->inverse[0 + 3 * 0] * offsets_sum[0]
                + program->inverse[0 + 3 * 1] * offsets_sum[1]
                + program->inverse[0 + 3 * 2] * offsets_sum[2];
            offsets[k][1] = program->inverse[1 + 3 * 0] * offsets_sum[0]
                + program->inverse[1 + 3 * 1] * offsets_sum[1]
                + program->inverse[1 + 3 * 2] * offsets_sum[2];
            offsets[k][2] = program->inverse[2 + 3 * 0] * offsets_sum[0]
                + program->inverse[2 + 3 * 1] * offsets_sum[1]
                + program->inverse[2 + 3 * 2] * offsets_sum[2];
            const float slope_product[6] = {
                0.0F + program->closed[0 + 6 * 0] * slope[0] + program->closed[1 + 6 * 0] * slope[1]
                    + program->closed[2 + 6 * 0] * slope[2] + program->closed[3 + 6 * 0] * slope[3]
                    + program->closed[4 + 6 * 0] * slope[4]
                    + program->closed[5 + 6 * 0] * slope[5],
                0.0F + program->closed[0 + 6 * 1] * slope[0] + program->closed[1 + 6 * 1] * slope[1]
                    + program->closed[2 + 6 * 1] * slope[2] + program->closed[3 + 6 * 1] * slope[3]
                    + program->closed[4 + 6 * 1] * slope[4]
                    + program->closed[5 + 6 * 1] * slope[5],
                0.0F + program->closed[0 + 6 * 2] * slope[0] + program->closed[1 + 6 * 2] * slope[1]
                    + program->closed[2 + 6 * 2] * slope[2] + program->closed[3 + 6 * 2] * slope[3]
                    + program->closed[4 + 6 * 2] * slope[4]
                    + program->closed[5 + 6 * 2] * slope[5],
                0.0F + program->closed[0 + 6 * 3] * slope[0] + program->closed[1 + 6 * 3] * slope[1]
                    + program->closed[2 + 6 * 3] * slope[2] + program->closed[3 + 6 * 3] * slope[3]
                    + program->closed[4 + 6 * 3] * slope[4]
                    + program->closed[5 + 6 * 3] * slope[5],
                0.0F + program->closed[0 + 6 * 4] * slope[0] + program->closed[1 + 6 * 4] * slope[1]
                    + program->closed[2 + 6 * 4] * slope[2] + program->closed[3 + 6 * 4] * slope[3]
                    + program->closed[4 + 6 * 4] * slope[4]
                    + program->closed[5 + 6 * 4] * slope[5],
                0.0F + program->closed[0 + 6 * 5] * slope[0] + program->closed[1 + 6 * 5] * slope[1]
                    + program->closed[2 + 6 * 5] * slope[2] + program->closed[3 + 6 * 5] * slope[3]
                    + program->closed[4 + 6 * 5] * slope[4] + program->closed[5 + 6 * 5] * slope[5]
            };
            const float slope_product_2[6] = {
                program->gain[0 + 3 * 0] * own[0] + program->gain[1 + 3 * 0] * own[1]
                    + program->gain[2 + 3 * 0] * own[2],
                program->gain[0 + 3 * 1] * own[0] + program->gain[1 + 3 * 1] * own[1]
                    + program->gain[2 + 3 * 1] * own[2],
                program->gain[0 + 3 * 2] * own[0] + program->gain[1 + 3 * 2] * own[1]
                    + program->gain[2 + 3 * 2] * own[2],
                program->gain[0 + 3 * 3] * own[0] + program->gain[1 + 3 * 3] * own[1]
                    + program->gain[2 + 3 * 3] * own[2],
                program->gain[0 + 3 * 4] * own[0] + program->gain[1 + 3 * 4] * own[1]
                    + program->gain[2 + 3 * 4] * own[2],
                program->gain[0 + 3 * 5] * own[0] + program->gain[1 + 3 * 5] * own[1]
                    + program->gain[2 + 3 * 5] * own[2]
            };
            BESSEMER_FEW_PASSES
            for (uint32_t i = 0U; i < 6U; i++) {
                slope[i] = slope_product[i] - slope_product_2[i];
            }
        }
        float state[6];
        (void)memcpy(state, measured, sizeof(float[6]));
        residual = 0.0F;
        violation = 0.0F;
        for (uint32_t k = 0U; k < 8U; k++) {
            const float input_product[3] = {
                program->gain[0 + 3 * 0] * state[0] + program->gain[0 + 3 * 1] * state[1]
                    + program->gain[0 + 3 * 2] * state[2] + program->gain[0 + 3 * 3] * state[3]
                    + program->gain[0 + 3 * 4] * state[4] + program->gain[0 + 3 * 5] * state[5],
                program->gain[1 + 3 * 0] * state[0] + program->gain[1 + 3 * 1] * state[1]
                    + program->gain[1 + 3 * 2] * state[2] + program->gain[1 + 3 * 3] * state[3]
                    + program->gain[1 + 3 * 4] * state[4] + program->gain[1 + 3 * 5] * state[5],
                program->gain[2 + 3 * 0] * state[0] + program->gain[2 + 3 * 1] * state[1]
                    + program->gain[2 + 3 * 2] * state[2] + program->gain[2 + 3 * 3] * state[3]
                    + program->gain[2 + 3 * 4] * state[4] + program->gain[2 + 3 * 5] * state[5]
            };
            const float input[3] = {
                -input_product[0] - offsets[k][0],
                -input_product[1] - offsets[k][1],
                -input_product[2] - offsets[k][2]
            };
            float state_product[6];
            product_f32_6x6_6x1(program->by_state, state, state_product);
            const float state_product_2[6] = {
                program->by_input[0 + 6 * 0] * input[0] + program->by_input[0 + 6 * 1] * input[1]
                    + program->by_input[0 + 6 * 2] * input[2],
                program->by_input[1 + 6 * 0] * input[0] + program->by_input[1 + 6 * 1] * input[1]
                    + program->by_input[1 + 6 * 2] * input[2],
                program->by_input[2 + 6 * 0] * input[0] + program->by_input[2 + 6 * 1] * input[1]
                    + program->by_input[2 + 6 * 2] * input[2],
                program->by_input[3 + 6 * 0] * input[0] + program->by_input[3 + 6 * 1] * input[1]
                    + program->by_input[3 + 6 * 2] * input[2],
                program->by_input[4 + 6 * 0] * input[0] + program->by_input[4 + 6 * 1] * input[1]
                    + program->by_input[4 + 6 * 2] * input[2],
                program->by_input[5 + 6 * 0] * input[0] + program->by_input[5 + 6 * 1] * input[1]
                    + program->by_input[5 + 6 * 2] * input[2]
            };
            BESSEMER_FEW_PASSES
            for (uint32_t i = 0U; i < 6U; i++) {
                state[i] = state_product[i] + state_product_2[i];
            }
            float inputs[3] = {
                input[0] + self->input_remainders[k][0],
                input[1] + self->input_remainders[k][1],
                input[2] + self->input_remainders[k][2]
            };
            admm_project_f32_3_1_3(inputs, program->low, program->high);
            float states[6];
            BESSEMER_FEW_PASSES
            for (uint32_t i = 0U; i < 6U; i++) {
                states[i] = lower_f32(upper_f32(state[i] + self->state_remainders[k][i],
                    program->lowest[i]), program->highest[i]);
            }
            float largest = fabsf(states[0] - self->states[k][0]);
            BESSEMER_FEW_PASSES
            for (uint32_t i = 1U; i < 6U; i++) {
                largest = larger_magnitude_f32(largest, fabsf(states[i] - self->states[k][i]));
            }
            const float changed = max_f32(
                larger_magnitude_f32(larger_magnitude_f32(fabsf(inputs[0] - self->inputs[k][0]),
                fabsf(inputs[1] - self->inputs[k][1])), fabsf(inputs[2] - self->inputs[k][2])),
                largest);
            residual = max_f32(residual, changed * weight);
            input_gaps[k][0] = input[0] - inputs[0];
            input_gaps[k][1] = input[1] - inputs[1];
            input_gaps[k][2] = input[2] - inputs[2];
            BESSEMER_FEW_PASSES
            for (uint32_t i = 0U; i < 6U; i++) {
                state_gaps[k][i] = state[i] - states[i];
            }
            float largest_2 = fabsf(state_gaps[k][0]);
            BESSEMER_FEW_PASSES
            for (uint32_t i = 1U; i < 6U; i++) {
                largest_2 = larger_magnitude_f32(largest_2, fabsf(state_gaps[k][i]));
            }
            violation = max_f32(max_f32(violation,
                larger_magnitude_f32(larger_magnitude_f32(fabsf(input_gaps[k][0]),
                fabsf(input_gaps[k][1])), fabsf(input_gaps[k][2]))), largest_2);
            self->inputs[k][0] = inputs[0];
            self->inputs[k][1] = inputs[1];
            self->inputs[k][2] = inputs[2];
            (void)memcpy(self->states[k], states, sizeof(float[6]));
            self->input_remainders[k][0] += input_gaps[k][0];
            self->input_remainders[k][1] += input_gaps[k][1];
            self->input_remainders[k][2] += input_gaps[k][2];
            BESSEMER_FEW_PASSES
            for (uint32_t i = 0U; i < 6U; i++) {
                self->state_remainders[k][i] += state_gaps[k][i];
            }
        }
    }
    float size = 0.0F + measured[0] * measured[0] + measured[1] * measured[1]
        + measured[2] * measured[2] + measured[3] * measured[3] + measured[4] * measured[4]
        + measured[5] * measured[5];
    for (uint32_t k = 0U; k < 8U; k++) {
        size += self->input_remainders[k][0] * self->input_remainders[k][0]
            + self->input_remainders[k][1] * self->input_remainders[k][1]
            + self->input_remainders[k][2] * self->input_remainders[k][2]
            + (0.0F + self->state_remainders[k][0] * self->state_remainders[k][0]
            + self->state_remainders[k][1] * self->state_remainders[k][1]
            + self->state_remainders[k][2] * self->state_remainders[k][2]
            + self->state_remainders[k][3] * self->state_remainders[k][3]
            + self->state_remainders[k][4] * self->state_remainders[k][4]
            + self->state_remainders[k][5] * self->state_remainders[k][5]);
        size += self->inputs[k][0] * self->inputs[k][0] + self->inputs[k][1] * self->inputs[k][1]
            + self->inputs[k][2] * self->inputs[k][2]
            + (0.0F + self->states[k][0] * self->states[k][0]
            + self->states[k][1] * self->states[k][1] + self->states[k][2] * self->states[k][2]
            + self->states[k][3] * self->states[k][3] + self->states[k][4] * self->states[k][4]
            + self->states[k][5] * self->states[k][5]);
    }
    const bool is_empty = riccati_proves_f32_6_3_8_1_3(program, measured,
        (const float (*)[3])input_gaps, (const float (*)[6])state_gaps);
    outcome_t outcome;
    if (is_empty) {
        outcome = OUTCOME_INFEASIBLE;
    } else if (isfinite(size) != 0 && violation <= program->tolerance
            && residual <= program->tolerance) {
        outcome = OUTCOME_SOLVED;
    } else {
        outcome = OUTCOME_UNFINISHED;
    }
    receding_f32_3->input[0] = self->inputs[0][0];
    receding_f32_3->input[1] = self->inputs[0][1];
    receding_f32_3->input[2] = self->inputs[0][2];
    if (is_empty || isfinite(size) == 0) {
        for (uint32_t i = 0U; i < 8U; i++) {
            self->inputs[i][0] = 0.0F;
            self->inputs[i][1] = 0.0F;
            self->inputs[i][2] = 0.0F;
        }
        (void)memcpy(self->input_remainders, self->inputs, sizeof(float[8][3]));
        for (uint32_t i = 0U; i < 8U; i++) {
            for (uint32_t j = 0U; j < 6U; j++) {
                self->states[i][j] = 0.0F;
            }
        }
        (void)memcpy(self->state_remainders, self->states, sizeof(float[8][6]));
        receding_f32_3->input[0] = 0.0F;
        receding_f32_3->input[1] = 0.0F;
        receding_f32_3->input[2] = 0.0F;
        admm_project_f32_3_1_3(receding_f32_3->input, program->low, program->high);
    }
    receding_f32_3->outcome = outcome;
    receding_f32_3->violation = violation;
}

/* riccati_admm_f32_6_3_8_1_3_10.h */

/**
 * Solver of `X` states, `U` inputs and `H` periods by `I` iterations, each the same work. The last `C` × `D` inputs of a
 * period are `C` second-order cones of `D` inputs; the others have limits, and so have the states.
 *
 * A cone is defined in `admm`. An iteration goes backwards by d(k) = (R + wI + BᵀPB)⁻¹(Bᵀp(k+1) + r(k)), p(k) = q(k) +
 * (A − BK)ᵀp(k+1) − Kᵀr(k), with r(k) = −w(z(k) − y(k)) and q(k) = −Qt − w(v(k) − g(k)), and forwards by u(k) = −Kx(k) −
 * d(k), x(k+1) = Ax(k) + Bu(k). It projects, z = Π(u + y) and v = Π(x + g), and adds up the remainders, y += u − z and
 * g += x − v. The tolerance is for u − z, x − v, and w times the changes of z and v. A problem is infeasible if the last
 * remainders prove it, to one in a thousand. Initialisation: `Default` begins at 0. Source: Nguyen, Schoedel, Alavilli,
 * Plancher and Manchester, *TinyMPC: Model-Predictive Control on Resource-Constrained Microcontrollers*, ICRA 2024.
 *
 * ```
 * use bessemer::nalgebra::{Matrix1, Vector1};
 * use bessemer_blocks::{Outcome, RiccatiAdmm, RiccatiProgram};
 *
 * // x(k+1) = x(k) + u(k), with w = 1 and so P = (Q + w) (1 + √5) / 2.
 * let one = Matrix1::new(1.0);
 * let last = one * (1.0 + 5.0_f64.sqrt());
 * let mut program = RiccatiProgram::new((&one, &one), (&one, &one), &last, 1.0, 1e-9).unwrap();
 * program.low[0] = -0.5;
 * program.high[0] = 0.5;
 * let mut solver = RiccatiAdmm::<f64, 1, 1, 8, 0, 0, 1000>::default();
 * let found = solver.step(&program, &Vector1::new(3.0), &Vector1::new(0.0));
 * assert_eq!((found.outcome, found.input[0]), (Outcome::Solved, -0.5));
 * ```
 */
typedef struct {
    /** The inputs z, within their limits. */
    float inputs[8][3];
    /** Their remainders y. */
    float input_remainders[8][3];
    /** The states v(1), v(2), …, within their limits. */
    float states[8][6];
    /** Their remainders g. */
    float state_remainders[8][6];
} riccati_admm_f32_6_3_8_1_3_10_t;
