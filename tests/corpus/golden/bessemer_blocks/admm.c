/* The C of blocks/src/admm.rs. Written by a test. */

/* admm.c */

static uint64_t admm_row_3(uint32_t from, uint32_t behind);
static uint64_t admm_row_4(uint32_t from, uint32_t behind);

void admm_program_f32_3_4_new(const float hessian[9], const float rows[12], const float weights[4],
    float tolerance, option_admm_program_f32_3_4_t *BESSEMER_RESTRICT result)
{
    float weighted[12];
    (void)memcpy(weighted, rows, sizeof(float[12]));
    for (uint32_t i = 0U; i < 4U; i++) {
        for (uint32_t k = 0U; k < 3U; k++) {
            weighted[i + 4U * k] *= weights[i];
        }
    }
    const float inverse_option_product[9] = {
        rows[0 + 4 * 0] * weighted[0 + 4 * 0] + rows[2 + 4 * 0] * weighted[2 + 4 * 0]
            + (rows[1 + 4 * 0] * weighted[1 + 4 * 0] + rows[3 + 4 * 0] * weighted[3 + 4 * 0]),
        rows[0 + 4 * 1] * weighted[0 + 4 * 0] + rows[2 + 4 * 1] * weighted[2 + 4 * 0]
            + (rows[1 + 4 * 1] * weighted[1 + 4 * 0] + rows[3 + 4 * 1] * weighted[3 + 4 * 0]),
        rows[0 + 4 * 2] * weighted[0 + 4 * 0] + rows[2 + 4 * 2] * weighted[2 + 4 * 0]
            + (rows[1 + 4 * 2] * weighted[1 + 4 * 0] + rows[3 + 4 * 2] * weighted[3 + 4 * 0]),
        rows[0 + 4 * 0] * weighted[0 + 4 * 1] + rows[2 + 4 * 0] * weighted[2 + 4 * 1]
            + (rows[1 + 4 * 0] * weighted[1 + 4 * 1] + rows[3 + 4 * 0] * weighted[3 + 4 * 1]),
        rows[0 + 4 * 1] * weighted[0 + 4 * 1] + rows[2 + 4 * 1] * weighted[2 + 4 * 1]
            + (rows[1 + 4 * 1] * weighted[1 + 4 * 1] + rows[3 + 4 * 1] * weighted[3 + 4 * 1]),
        rows[0 + 4 * 2] * weighted[0 + 4 * 1] + rows[2 + 4 * 2] * weighted[2 + 4 * 1]
            + (rows[1 + 4 * 2] * weighted[1 + 4 * 1] + rows[3 + 4 * 2] * weighted[3 + 4 * 1]),
        rows[0 + 4 * 0] * weighted[0 + 4 * 2] + rows[2 + 4 * 0] * weighted[2 + 4 * 2]
            + (rows[1 + 4 * 0] * weighted[1 + 4 * 2] + rows[3 + 4 * 0] * weighted[3 + 4 * 2]),
        rows[0 + 4 * 1] * weighted[0 + 4 * 2] + rows[2 + 4 * 1] * weighted[2 + 4 * 2]
            + (rows[1 + 4 * 1] * weighted[1 + 4 * 2] + rows[3 + 4 * 1] * weighted[3 + 4 * 2]),
        rows[0 + 4 * 2] * weighted[0 + 4 * 2] + rows[2 + 4 * 2] * weighted[2 + 4 * 2]
            + (rows[1 + 4 * 2] * weighted[1 + 4 * 2] + rows[3 + 4 * 2] * weighted[3 + 4 * 2])
    };
    float inverse_option_a[9];
    BESSEMER_FEW_PASSES
    for (uint32_t i = 0U; i < 9U; i++) {
        inverse_option_a[i] = hessian[i] + inverse_option_product[i];
    }
    option_cholesky_factor_f32_3_t inverse_option;
    cholesky_factored_f32_3(inverse_option_a, &inverse_option);
    if (!inverse_option.is_some) {
        static const option_admm_program_f32_3_4_t new_ = {.is_some = false};
        *result = new_;
        return;
    }
    cholesky_factor_f32_3_inverse(&inverse_option.value, result->value.inverse);
    result->is_some = true;
    (void)memcpy(result->value.rows, rows, sizeof(float[12]));
    result->value.weights[0] = weights[0];
    result->value.weights[1] = weights[1];
    result->value.weights[2] = weights[2];
    result->value.weights[3] = weights[3];
    result->value.tolerance = tolerance;
}

float admm_support_f32_3_1_3(const float direction[3], const float low[3], const float high[3],
    float small)
{
    const uint32_t cones = saturating_sub_u32(3U, 3U);
    float most = 0.0F;
    for (uint64_t i = UINT64_C(0); i < (uint64_t)cones; i++) {
        float limit;
        if (direction[i] > 0.0F) {
            limit = high[i];
        } else {
            limit = low[i];
        }

        /* Small directions at no limit are rounding errors. */
        if (isfinite(limit) != 0 || fabsf(direction[i]) > small) {
            most += limit * direction[i];
        }
    }
    for (uint32_t c = 0U; c < 1U; c++) {
        const uint64_t first = admm_row_3(cones, c * 3U);
        float square = 0.0F;
        for (uint32_t d = 0U; d < 3U; d++) {
            const uint64_t at = admm_row_3((uint32_t)first, d);
            most += low[at] * direction[at];
            if (d > 0U) {
                square += direction[at] * direction[at];
            }
        }
        if (!(sqrtf(square) <= small - direction[first])) {
            most = INFINITY;
        }
    }
    return most;
}

float admm_support_f32_4_1_3(const float direction[4], const float low[4], const float high[4],
    float small)
{
    const uint32_t cones = saturating_sub_u32(4U, 3U);
    float most = 0.0F;
    for (uint64_t i = UINT64_C(0); i < (uint64_t)cones; i++) {
        float limit;
        if (direction[i] > 0.0F) {
            limit = high[i];
        } else {
            limit = low[i];
        }

        /* Small directions at no limit are rounding errors. */
        if (isfinite(limit) != 0 || fabsf(direction[i]) > small) {
            most += limit * direction[i];
        }
    }
    for (uint32_t c = 0U; c < 1U; c++) {
        const uint64_t first = admm_row_4(cones, c * 3U);
        float square = 0.0F;
        for (uint32_t d = 0U; d < 3U; d++) {
            const uint64_t at = admm_row_4((uint32_t)first, d);
            most += low[at] * direction[at];
            if (d > 0U) {
                square += direction[at] * direction[at];
            }
        }
        if (!(sqrtf(square) <= small - direction[first])) {
            most = INFINITY;
        }
    }
    return most;
}

float admm_support_f32_6_0_0(const float direction[6], const float low[6], const float high[6],
    float small)
{
    const uint32_t cones = saturating_sub_u32(6U, 0U);
    float most = 0.0F;
    for (uint64_t i = UINT64_C(0); i < (uint64_t)cones; i++) {
        float limit;
        if (direction[i] > 0.0F) {
            limit = high[i];
        } else {
            limit = low[i];
        }

        /* Small directions at no limit are rounding errors. */
        if (isfinite(limit) != 0 || fabsf(direction[i]) > small) {
            most += limit * direction[i];
        }
    }
    return most;
}

void admm_project_f32_3_1_3(float rows[BESSEMER_RESTRICT 3], const float low[3],
    const float high[3])
{
    const uint32_t cones = saturating_sub_u32(3U, 3U);
    for (uint64_t i = UINT64_C(0); i < (uint64_t)cones; i++) {
        rows[i] = min_f32(max_f32(rows[i], low[i]), high[i]);
    }
    for (uint32_t c = 0U; c < 1U; c++) {
        const uint64_t first = admm_row_3(cones, c * 3U);
        const float axis = rows[first] - low[first];
        float square = 0.0F;
        for (uint32_t d = 1U; d < 3U; d++) {
            const uint64_t at = admm_row_3((uint32_t)first, d);
            square += (rows[at] - low[at]) * (rows[at] - low[at]);
        }
        const float length = sqrtf(square);
        pair_f32_f32_t value_choice;
        if (length <= axis) {
            value_choice.first = axis;
            value_choice.second = 1.0F;
        } else if (length <= -axis) {
            value_choice.first = 0.0F;
            value_choice.second = 0.0F;
        } else {
            const float height = (axis + length) * 0.5F;
            value_choice.first = height;
            value_choice.second = height / length;
        }
        const float height = value_choice.first;
        const float share = value_choice.second;
        rows[first] = low[first] + height;
        for (uint32_t d = 1U; d < 3U; d++) {
            const uint64_t at = admm_row_3((uint32_t)first, d);
            rows[at] = low[at] + (rows[at] - low[at]) * share;
        }
    }
}

void admm_project_f32_4_1_3(float rows[BESSEMER_RESTRICT 4], const float low[4],
    const float high[4])
{
    const uint32_t cones = saturating_sub_u32(4U, 3U);
    for (uint64_t i = UINT64_C(0); i < (uint64_t)cones; i++) {
        rows[i] = min_f32(max_f32(rows[i], low[i]), high[i]);
    }
    for (uint32_t c = 0U; c < 1U; c++) {
        const uint64_t first = admm_row_4(cones, c * 3U);
        const float axis = rows[first] - low[first];
        float square = 0.0F;
        for (uint32_t d = 1U; d < 3U; d++) {
            const uint64_t at = admm_row_4((uint32_t)first, d);
            square += (rows[at] - low[at]) * (rows[at] - low[at]);
        }
        const float length = sqrtf(square);
        pair_f32_f32_t value_choice;
        if (length <= axis) {
            value_choice.first = axis;
            value_choice.second = 1.0F;
        } else if (length <= -axis) {
            value_choice.first = 0.0F;
            value_choice.second = 0.0F;
        } else {
            const float height = (axis + length) * 0.5F;
            value_choice.first = height;
            value_choice.second = height / length;
        }
        const float height = value_choice.first;
        const float share = value_choice.second;
        rows[first] = low[first] + height;
        for (uint32_t d = 1U; d < 3U; d++) {
            const uint64_t at = admm_row_4((uint32_t)first, d);
            rows[at] = low[at] + (rows[at] - low[at]) * share;
        }
    }
}

/**
 * Returns the index of a row behind another, and the last row if there are fewer: a program without cones has none to
 * index.
 */
static uint64_t admm_row_3(uint32_t from, uint32_t behind)
{
    return (uint64_t)min_u32(saturating_add_u32(from, behind), 3U - 1U);
}

/**
 * Returns the index of a row behind another, and the last row if there are fewer: a program without cones has none to
 * index.
 */
static uint64_t admm_row_4(uint32_t from, uint32_t behind)
{
    return (uint64_t)min_u32(saturating_add_u32(from, behind), 4U - 1U);
}

uint64_t admm_row_6(uint32_t from, uint32_t behind)
{
    return (uint64_t)min_u32(saturating_add_u32(from, behind), 6U - 1U);
}

/* admm.h */

/** Constant part of a program for `Admm`, of `N` variables and `M` rows. */
typedef struct {
    /**
     * The inverse of H + AᵀWA, with the weights in the diagonal of W.
     * A matrix by columns: [row + 3 * column].
     */
    float inverse[9];
    /** A. A matrix by columns: [row + 4 * column]. */
    float rows[12];
    /** Weight of each row, above 0; the rows of a cone have one weight. */
    float weights[4];
    /** Residual that counts as none, above 0. */
    float tolerance;
} admm_program_f32_3_4_t;

/** `Option<AdmmProgram_f32_3_4>`: a value, or none. */
typedef struct {
    /** True if there is a value. */
    bool is_some;
    /** The value, if there is one. */
    admm_program_f32_3_4_t value;
} option_admm_program_f32_3_4_t;

/* admm_f32_3_4_1_3_25.c */

static bool admm_f32_3_4_1_3_25_proves(const admm_f32_3_4_1_3_25_t *self,
    const admm_program_f32_3_4_t *program, const float change[4], const float low[4],
    const float high[4]);

void admm_f32_3_4_1_3_25_init(admm_f32_3_4_1_3_25_t *self)
{
    self->values[0] = 0.0F;
    self->values[1] = 0.0F;
    self->values[2] = 0.0F;
    self->values[3] = 0.0F;
    self->multipliers[0] = 0.0F;
    self->multipliers[1] = 0.0F;
    self->multipliers[2] = 0.0F;
    self->multipliers[3] = 0.0F;
}

void admm_f32_3_4_1_3_25_step(admm_f32_3_4_1_3_25_t *BESSEMER_RESTRICT self,
    const admm_program_f32_3_4_t *program, const float gradient[3], const float low[4],
    const float high[4], minimum_f32_3_t *BESSEMER_RESTRICT minimum_f32_3)
{
    minimum_f32_3->point[0] = 0.0F;
    minimum_f32_3->point[1] = 0.0F;
    minimum_f32_3->point[2] = 0.0F;
    float change[4] = {0.0F, 0.0F, 0.0F, 0.0F};
    float gap[4] = {0.0F, 0.0F, 0.0F, 0.0F};
    float slope[4] = {0.0F, 0.0F, 0.0F, 0.0F};
    for (uint32_t pass = 0U; pass < 25U; pass++) {
        const float pull[4] = {
            self->values[0] * program->weights[0] - self->multipliers[0],
            self->values[1] * program->weights[1] - self->multipliers[1],
            self->values[2] * program->weights[2] - self->multipliers[2],
            self->values[3] * program->weights[3] - self->multipliers[3]
        };
        const float point_product[3] = {
            program->rows[0 + 4 * 0] * pull[0] + program->rows[2 + 4 * 0] * pull[2]
                + (program->rows[1 + 4 * 0] * pull[1] + program->rows[3 + 4 * 0] * pull[3]),
            program->rows[0 + 4 * 1] * pull[0] + program->rows[2 + 4 * 1] * pull[2]
                + (program->rows[1 + 4 * 1] * pull[1] + program->rows[3 + 4 * 1] * pull[3]),
            program->rows[0 + 4 * 2] * pull[0] + program->rows[2 + 4 * 2] * pull[2]
                + (program->rows[1 + 4 * 2] * pull[1] + program->rows[3 + 4 * 2] * pull[3])
        };
        const float point_difference[3] = {
            point_product[0] - gradient[0],
            point_product[1] - gradient[1],
            point_product[2] - gradient[2]
        };
        minimum_f32_3->point[0] = program->inverse[0 + 3 * 0] * point_difference[0]
            + program->inverse[0 + 3 * 1] * point_difference[1]
            + program->inverse[0 + 3 * 2] * point_difference[2];
        minimum_f32_3->point[1] = program->inverse[1 + 3 * 0] * point_difference[0]
            + program->inverse[1 + 3 * 1] * point_difference[1]
            + program->inverse[1 + 3 * 2] * point_difference[2];
        minimum_f32_3->point[2] = program->inverse[2 + 3 * 0] * point_difference[0]
            + program->inverse[2 + 3 * 1] * point_difference[1]
            + program->inverse[2 + 3 * 2] * point_difference[2];
        const float reached[4] = {
            program->rows[0 + 4 * 0] * minimum_f32_3->point[0]
                + program->rows[0 + 4 * 1] * minimum_f32_3->point[1]
                + program->rows[0 + 4 * 2] * minimum_f32_3->point[2],
            program->rows[1 + 4 * 0] * minimum_f32_3->point[0]
                + program->rows[1 + 4 * 1] * minimum_f32_3->point[1]
                + program->rows[1 + 4 * 2] * minimum_f32_3->point[2],
            program->rows[2 + 4 * 0] * minimum_f32_3->point[0]
                + program->rows[2 + 4 * 1] * minimum_f32_3->point[1]
                + program->rows[2 + 4 * 2] * minimum_f32_3->point[2],
            program->rows[3 + 4 * 0] * minimum_f32_3->point[0]
                + program->rows[3 + 4 * 1] * minimum_f32_3->point[1]
                + program->rows[3 + 4 * 2] * minimum_f32_3->point[2]
        };
        const float relaxed[4] = {
            reached[0] * 1.6F - self->values[0] * 0.6F,
            reached[1] * 1.6F - self->values[1] * 0.6F,
            reached[2] * 1.6F - self->values[2] * 0.6F,
            reached[3] * 1.6F - self->values[3] * 0.6F
        };
        float values[4] = {
            relaxed[0] + self->multipliers[0] / program->weights[0],
            relaxed[1] + self->multipliers[1] / program->weights[1],
            relaxed[2] + self->multipliers[2] / program->weights[2],
            relaxed[3] + self->multipliers[3] / program->weights[3]
        };
        admm_project_f32_4_1_3(values, low, high);
        change[0] = (relaxed[0] - values[0]) * program->weights[0];
        change[1] = (relaxed[1] - values[1]) * program->weights[1];
        change[2] = (relaxed[2] - values[2]) * program->weights[2];
        change[3] = (relaxed[3] - values[3]) * program->weights[3];
        slope[0] = change[0] - (reached[0] - self->values[0]) * program->weights[0];
        slope[1] = change[1] - (reached[1] - self->values[1]) * program->weights[1];
        slope[2] = change[2] - (reached[2] - self->values[2]) * program->weights[2];
        slope[3] = change[3] - (reached[3] - self->values[3]) * program->weights[3];
        gap[0] = reached[0] - values[0];
        gap[1] = reached[1] - values[1];
        gap[2] = reached[2] - values[2];
        gap[3] = reached[3] - values[3];
        self->values[0] = values[0];
        self->values[1] = values[1];
        self->values[2] = values[2];
        self->values[3] = values[3];
        self->multipliers[0] += change[0];
        self->multipliers[1] += change[1];
        self->multipliers[2] += change[2];
        self->multipliers[3] += change[3];
    }
    const float violation = larger_magnitude_f32(
        larger_magnitude_f32(larger_magnitude_f32(fabsf(gap[0]), fabsf(gap[1])), fabsf(gap[2])),
        fabsf(gap[3]));
    const bool is_finite = isfinite(
        minimum_f32_3->point[0] * minimum_f32_3->point[0]
        + minimum_f32_3->point[1] * minimum_f32_3->point[1]
        + minimum_f32_3->point[2] * minimum_f32_3->point[2]) != 0;
    const bool is_empty = admm_f32_3_4_1_3_25_proves(self, program, change, low, high);
    outcome_t outcome;
    bool condition = false;
    if (is_finite && !is_empty && violation <= program->tolerance) {
        const float product[3] = {
            program->rows[0 + 4 * 0] * slope[0] + program->rows[2 + 4 * 0] * slope[2]
                + (program->rows[1 + 4 * 0] * slope[1] + program->rows[3 + 4 * 0] * slope[3]),
            program->rows[0 + 4 * 1] * slope[0] + program->rows[2 + 4 * 1] * slope[2]
                + (program->rows[1 + 4 * 1] * slope[1] + program->rows[3 + 4 * 1] * slope[3]),
            program->rows[0 + 4 * 2] * slope[0] + program->rows[2 + 4 * 2] * slope[2]
                + (program->rows[1 + 4 * 2] * slope[1] + program->rows[3 + 4 * 2] * slope[3])
        };
        condition = larger_magnitude_f32(larger_magnitude_f32(fabsf(product[0]), fabsf(product[1])),
            fabsf(product[2])) <= program->tolerance;
    }
    if (condition) {
        outcome = OUTCOME_SOLVED;
    } else if (is_empty) {
        outcome = OUTCOME_INFEASIBLE;
    } else {
        outcome = OUTCOME_UNFINISHED;
    }
    if (is_empty || !is_finite || isfinite(
            self->multipliers[0] * self->multipliers[0]
            + self->multipliers[2] * self->multipliers[2]
            + (self->multipliers[1] * self->multipliers[1]
            + self->multipliers[3] * self->multipliers[3])) == 0) {
        self->values[0] = 0.0F;
        self->values[1] = 0.0F;
        self->values[2] = 0.0F;
        self->values[3] = 0.0F;
        self->multipliers[0] = 0.0F;
        self->multipliers[1] = 0.0F;
        self->multipliers[2] = 0.0F;
        self->multipliers[3] = 0.0F;
    }
    minimum_f32_3->outcome = outcome;
    minimum_f32_3->violation = violation;
}

/**
 * Returns true if limits exclude each other, or a change of the multipliers separates them from every Az.
 */
static bool admm_f32_3_4_1_3_25_proves(const admm_f32_3_4_1_3_25_t *self,
    const admm_program_f32_3_4_t *program, const float change[4], const float low[4],
    const float high[4])
{
    (void)self;
    {
        const uint64_t end = (uint64_t)saturating_sub_u32(4U, 3U);
        for (uint64_t i = UINT64_C(0); i < end; i++) {
            if (low[i] > high[i]) {
                return true;
            }
        }
    }
    const float small = larger_magnitude_f32(
        larger_magnitude_f32(larger_magnitude_f32(fabsf(change[0]), fabsf(change[1])),
        fabsf(change[2])), fabsf(change[3])) * 0.001F;
    const float most = admm_support_f32_4_1_3(change, low, high, small);
    bool result = false;
    if (most < -small) {
        const float result_product[3] = {
            program->rows[0 + 4 * 0] * change[0] + program->rows[2 + 4 * 0] * change[2]
                + (program->rows[1 + 4 * 0] * change[1] + program->rows[3 + 4 * 0] * change[3]),
            program->rows[0 + 4 * 1] * change[0] + program->rows[2 + 4 * 1] * change[2]
                + (program->rows[1 + 4 * 1] * change[1] + program->rows[3 + 4 * 1] * change[3]),
            program->rows[0 + 4 * 2] * change[0] + program->rows[2 + 4 * 2] * change[2]
                + (program->rows[1 + 4 * 2] * change[1] + program->rows[3 + 4 * 2] * change[3])
        };
        result = larger_magnitude_f32(larger_magnitude_f32(fabsf(result_product[0]),
            fabsf(result_product[1])), fabsf(result_product[2])) <= small;
    }
    return result;
}

/* admm_f32_3_4_1_3_25.h */

/**
 * Solver by `I` iterations of the alternating direction method of multipliers, each the same work; H may be
 * semidefinite. The last `C` × `D` rows are `C` second-order cones of `D` rows, the others have limits.
 *
 * A cone holds where the first of its rows, less its lower limit, is at least the length of the others, less theirs.
 * An iteration minimises with the rows near their last values, z = (H + AᵀWA)⁻¹(Aᵀ(Ws − y) − g), relaxes, r = 1.6 Az −
 * 0.6 s, and projects, s = Π(r + W⁻¹y), y += W(r − s). The tolerance is for Az − s and for the gradient. A problem
 * is infeasible if the last change of y proves it, to one in a thousand. Initialisation: `Default` begins at 0.
 * Source: Stellato et al., *OSQP: an operator splitting solver for quadratic programs*, Mathematical Programming
 * Computation 12, 2020.
 *
 * ```
 * use bessemer::nalgebra::{Matrix3, SVector, Vector3};
 * use bessemer_blocks::{Admm, AdmmProgram, Outcome};
 *
 * // The nearest point to (0, 3, 4) in the cone of the first axis.
 * let one = Matrix3::identity();
 * let program = AdmmProgram::new(&one, &one, &Vector3::repeat(1.0), 1e-9).unwrap();
 * let mut solver = Admm::<f64, 3, 3, 1, 3, 60>::default();
 * let zero = SVector::zeros();
 * let found = solver.step(&program, &-Vector3::new(0.0, 3.0, 4.0), &zero, &zero);
 * assert_eq!(found.outcome, Outcome::Solved);
 * assert!((found.point - Vector3::new(2.5, 1.5, 2.0)).norm() < 1e-8);
 * ```
 */
typedef struct {
    /** The rows s, within their limits. */
    float values[4];
    /** The multipliers y. */
    float multipliers[4];
} admm_f32_3_4_1_3_25_t;
