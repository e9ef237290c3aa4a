/* The C of blocks/src/quadratic.rs. Written by a test. */

/* active_set_f64_8_16_12.c */

static bool active_set_f64_8_16_12_enter(active_set_f64_8_16_12_t *BESSEMER_RESTRICT self,
    const active_set_program_f64_8_16_t *program, uint64_t row, double sign, const double low[16],
    const double high[16]);

void active_set_f64_8_16_12_init(active_set_f64_8_16_12_t *self)
{
    self->working.count = 0U;
    for (uint32_t i = 0U; i < 8U; i++) {
        self->working.rows[i] = 0U;
    }
    for (uint32_t i = 0U; i < 8U; i++) {
        self->working.signs[i] = 0.0;
    }
    for (uint32_t i = 0U; i < 8U; i++) {
        self->working.multipliers[i] = 0.0;
    }
    for (uint32_t i = 0U; i < 64U; i++) {
        self->working.lower[i] = 0.0;
    }
    for (uint32_t i = 0U; i < 8U; i++) {
        self->working.pivots[i] = 0.0;
    }
}

void active_set_f64_8_16_12_step(active_set_f64_8_16_12_t *BESSEMER_RESTRICT self,
    const active_set_program_f64_8_16_t *program, const double gradient[8], const double low[16],
    const double high[16], minimum_f64_8_t *BESSEMER_RESTRICT minimum_f64_8)
{
    const double offset[8] = {
        dot_f64_8(program->inverse, gradient),
        dot_f64_8(&program->inverse[0 + 8 * 1], gradient),
        dot_f64_8(&program->inverse[0 + 8 * 2], gradient),
        dot_f64_8(&program->inverse[0 + 8 * 3], gradient),
        dot_f64_8(&program->inverse[0 + 8 * 4], gradient),
        dot_f64_8(&program->inverse[0 + 8 * 5], gradient),
        dot_f64_8(&program->inverse[0 + 8 * 6], gradient),
        dot_f64_8(&program->inverse[0 + 8 * 7], gradient)
    };
    double shift[16];
    product_f64_16x8_8x1(program->rows, offset, shift);
    double low_2[16];
    double high_2[16];
    for (uint32_t i = 0U; i < 16U; i++) {
        low_2[i] = low[i] + shift[i];
        high_2[i] = high[i] + shift[i];
    }
    working_set_f64_8_begin_16(&self->working, program->rows);
    double point[8] = {0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
    outcome_t outcome = OUTCOME_UNFINISHED;
    double violation = 0.0;
    for (uint32_t i = 0U; i < 16U; i++) {
        if (low_2[i] > high_2[i]) {
            outcome = OUTCOME_INFEASIBLE;
        }
    }
    for (uint32_t pass = 0U; pass < 12U; pass++) {
        if (outcome == OUTCOME_INFEASIBLE) {
            break;
        }
        double direction_equations_16[8];
        working_set_f64_8_equations_16(&self->working, low_2, high_2, direction_equations_16);
        double direction[8];
        BESSEMER_FEW_PASSES
        for (uint32_t i = 0U; i < 8U; i++) {
            direction[i] = direction_equations_16[i] - self->working.multipliers[i];
        }
        pair_usize_f64_t leaving_share;
        working_set_f64_8_first_leaving_16(&self->working, direction, 1.0, 0.0, low_2, high_2,
            &leaving_share);
        working_set_f64_8_advance(&self->working, direction, leaving_share.second);
        if (leaving_share.first < UINT64_C(8)) {
            working_set_f64_8_remove_16(&self->working, program->rows, leaving_share.first);
            continue;
        }
        working_set_f64_8_minimum_16(&self->working, program->rows, point);
        double values[16];
        product_f64_16x8_8x1(program->rows, point, values);
        uint32_t row = 0U;
        double sign = 1.0;
        violation = 0.0;
        for (uint32_t i = 0U; i < 16U; i++) {
            if (values[i] - high_2[i] > violation) {
                const uint32_t row_next = i;
                const double sign_next = 1.0;
                const double violation_next = values[i] - high_2[i];
                row = row_next;
                sign = sign_next;
                violation = violation_next;
            }
            if (low_2[i] - values[i] > violation) {
                const uint32_t row_next = i;
                const double sign_next = -1.0;
                const double violation_next = low_2[i] - values[i];
                row = row_next;
                sign = sign_next;
                violation = violation_next;
            }
        }
        if (violation <= program->tolerance) {
            outcome = OUTCOME_SOLVED;
            break;
        }
        if (!active_set_f64_8_16_12_enter(self, program, row, sign, low_2, high_2)) {
            outcome = OUTCOME_INFEASIBLE;
        }
    }
    double point_difference[8];
    BESSEMER_FEW_PASSES
    for (uint32_t i = 0U; i < 8U; i++) {
        point_difference[i] = point[i] - offset[i];
    }
    product_f64_8x8_8x1(program->inverse, point_difference, minimum_f64_8->point);
    const double multipliers = dot_f64_8(self->working.multipliers, self->working.multipliers);

    /* NaN violates no limit. */
    const bool is_finite = isfinite(dot_f64_8(minimum_f64_8->point, minimum_f64_8->point)) != 0
        && isfinite(multipliers) != 0;
    if (outcome == OUTCOME_SOLVED && !is_finite) {
        outcome = OUTCOME_UNFINISHED;
    }
    if (outcome == OUTCOME_INFEASIBLE || !is_finite) {
        self->working.count = 0U;
        for (uint32_t i = 0U; i < 8U; i++) {
            self->working.multipliers[i] = 0.0;
        }
    }
    minimum_f64_8->outcome = outcome;
    minimum_f64_8->violation = violation;
}

/**
 * Makes a limit active; one that depends on the active ones replaces one of them. Returns false if none can leave.
 */
static bool active_set_f64_8_16_12_enter(active_set_f64_8_16_12_t *BESSEMER_RESTRICT self,
    const active_set_program_f64_8_16_t *program, uint64_t row, double sign, const double low[16],
    const double high[16])
{
    const uint32_t count = (uint32_t)min_u64((uint64_t)self->working.count, UINT64_C(8));
    reach_f64_8_t reach;
    working_set_f64_8_reach_16(&self->working, program->rows, count, row, sign, &reach);
    double multiplier = 0.0;
    if (count == 8U || reach.pivot <= reach.size * DBL_EPSILON * 1024.0) {
        double direction_b[8];
        BESSEMER_FEW_PASSES
        for (uint32_t i = 0U; i < 8U; i++) {
            direction_b[i] = -reach.lower[i];
        }
        double direction[8];
        working_set_f64_8_solve_transposed(&self->working, direction_b, direction);

        /* A direction of rounding errors would exchange a row on which this one does not depend. */
        const double small = DBL_EPSILON * 1024.0;
        pair_usize_f64_t leaving_share;
        working_set_f64_8_first_leaving_16(&self->working, direction, (double)INFINITY, small, low,
            high, &leaving_share);
        if (leaving_share.first == UINT64_C(8)) {
            return false;
        }
        working_set_f64_8_advance(&self->working, direction, leaving_share.second);
        multiplier = leaving_share.second;
        working_set_f64_8_remove_16(&self->working, program->rows, leaving_share.first);
        const uint32_t count_2 = (uint32_t)min_u64((uint64_t)self->working.count, UINT64_C(8));
        working_set_f64_8_reach_16(&self->working, program->rows, count_2, row, sign, &reach);
    }
    const uint32_t count_2 = (uint32_t)min_u64((uint64_t)self->working.count, UINT64_C(7));
    self->working.multipliers[count_2] = multiplier;
    working_set_f64_8_store(&self->working, count_2, row, sign, &reach);
    self->working.count = count_2 + 1U;
    return true;
}

/* active_set_f64_8_16_12.h */

/**
 * Dual active-set solver, for at most `I` changes of the set of active limits; `M` is at least 1.
 *
 * It solves for the multipliers with the active limits as equations. A row whose multiplier would become negative
 * leaves; else the row with the largest violation enters. Initialisation: `Default` begins without active limits. A
 * limit may be infinite. Rounding errors grow with the condition of H, whose Cholesky factor scales the rows. Source:
 * Arnström, Bemporad and Axehill, *A Dual Active-Set Solver for Embedded Quadratic Programming Using Recursive LDLᵀ
 * Updates*, IEEE Transactions on Automatic Control 67 (8), 2022.
 *
 * ```
 * use bessemer::nalgebra::{Matrix2, Vector2};
 * use bessemer_blocks::{ActiveSet, ActiveSetProgram, Outcome};
 *
 * // The nearest point to (2, 1) in a box.
 * let program = ActiveSetProgram::new(&Matrix2::identity(), &Matrix2::identity(), 1e-9).unwrap();
 * let mut solver = ActiveSet::<f64, 2, 2, 10>::default();
 * let most = Vector2::new(0.5, 0.5);
 * let found = solver.step(&program, &Vector2::new(-2.0, -1.0), &-most, &most);
 * assert_eq!((found.outcome, found.point), (Outcome::Solved, most));
 * ```
 */
typedef struct {
    /** The active limits. */
    working_set_f64_8_t working;
} active_set_f64_8_16_12_t;

/* quadratic.c */

static uint64_t working_set_f64_8_row_16(const working_set_f64_8_t *self, uint64_t at);
static void working_set_f64_8_factor_16(working_set_f64_8_t *BESSEMER_RESTRICT self,
    const double rows[128], uint64_t from);

void active_set_program_f64_8_16_new(const double hessian[64], const double rows[128],
    double tolerance,
    option_cholesky_factor_f64_8_t *BESSEMER_RESTRICT work_option_cholesky_factor_f64_8,
    double work_numbers[BESSEMER_RESTRICT 64],
    option_active_set_program_f64_8_16_t *BESSEMER_RESTRICT result)
{
    option_cholesky_factor_f64_8_t *const lower_option = work_option_cholesky_factor_f64_8;
    cholesky_factored_f64_8(hessian, lower_option);
    if (!lower_option->is_some) {
        result->is_some = false;
        for (uint32_t i = 0U; i < 64U; i++) {
            result->value.inverse[i] = 0.0;
        }
        for (uint32_t i = 0U; i < 128U; i++) {
            result->value.rows[i] = 0.0;
        }
        result->value.tolerance = 0.0;
        return;
    }
    double *const lower = work_numbers;
    cholesky_factor_f64_8_l(&lower_option->value, lower);
    (void)memcpy(result->value.inverse, BESSEMER_IDENTITY_8, sizeof(double[64]));
    for (uint32_t column = 0U; column < 8U; column++) {
        for (uint32_t i = column; i < 8U; i++) {
            double sum = result->value.inverse[column + 8U * i];
            for (uint32_t k = column; k < i; k++) {
                sum -= lower[i + 8U * k] * result->value.inverse[column + 8U * k];
            }
            result->value.inverse[column + 8U * i] = sum / lower[i + 8U * i];
        }
    }
    product_f64_16x8_8x8(rows, result->value.inverse, result->value.rows);
    result->is_some = true;
    result->value.tolerance = tolerance;
}

/** Returns the index of a working row. */
static uint64_t working_set_f64_8_row_16(const working_set_f64_8_t *self, uint64_t at)
{
    if (at < UINT64_C(8)) {
        return min_u64((uint64_t)self->rows[at], UINT64_C(15));
    } else {
        return UINT64_C(0);
    }
}

void working_set_f64_8_reach_16(const working_set_f64_8_t *self, const double rows[128],
    uint64_t count, uint64_t row, double sign, reach_f64_8_t *BESSEMER_RESTRICT reach_f64_8)
{
    const uint32_t row_2 = (uint32_t)min_u64(row, UINT64_C(15));
    for (uint32_t i = 0U; i < 8U; i++) {
        reach_f64_8->lower[i] = 0.0;
    }
    double size = 0.0;
    for (uint32_t k = 0U; k < 8U; k++) {
        size += rows[row_2 + 16U * k] * rows[row_2 + 16U * k];
    }
    double pivot = size;
    {
        const uint32_t end = (uint32_t)min_u64(count, UINT64_C(8));
        for (uint32_t i = 0U; i < end; i++) {
            const uint64_t other = working_set_f64_8_row_16(self, i);
            double product = 0.0;
            for (uint32_t k = 0U; k < 8U; k++) {
                product += rows[(uint32_t)other + 16U * k] * rows[row_2 + 16U * k];
            }
            product *= self->signs[i] * sign;
            for (uint32_t k = 0U; k < i; k++) {
                product -= self->lower[i + 8U * k] * reach_f64_8->lower[k];
            }
            reach_f64_8->lower[i] = product;
        }
    }
    {
        const uint32_t end = (uint32_t)min_u64(count, UINT64_C(8));
        for (uint32_t i = 0U; i < end; i++) {
            const double product = reach_f64_8->lower[i];
            reach_f64_8->lower[i] = product / self->pivots[i];
            pivot -= product * reach_f64_8->lower[i];
        }
    }
    reach_f64_8->size = size;
    reach_f64_8->pivot = pivot;
}

void working_set_f64_8_store(working_set_f64_8_t *BESSEMER_RESTRICT self, uint64_t count,
    uint64_t row, double sign, const reach_f64_8_t *reach)
{
    if (count < UINT64_C(8)) {
        self->rows[count] = (uint32_t)row;
        self->signs[count] = sign;
        for (uint64_t k = UINT64_C(0); k < count; k++) {
            self->lower[count + 8U * k] = reach->lower[k];
        }
        self->pivots[count] = reach->pivot;
    }
}

void working_set_f64_8_begin_16(working_set_f64_8_t *BESSEMER_RESTRICT self, const double rows[128])
{
    {
        const uint32_t end = (uint32_t)min_u64((uint64_t)self->count, UINT64_C(8));
        for (uint32_t i = 0U; i < end; i++) {
            if (self->multipliers[i] < 0.0) {
                self->multipliers[i] = -self->multipliers[i];
                self->signs[i] = -self->signs[i];
            }
        }
    }
    working_set_f64_8_factor_16(self, rows, UINT64_C(0));
}

/**
 * Factors the rows from `from` on again.
 *
 * `rows` by columns: [row + 16 * column].
 */
static void working_set_f64_8_factor_16(working_set_f64_8_t *BESSEMER_RESTRICT self,
    const double rows[128], uint64_t from)
{
    const uint32_t at_end = (uint32_t)min_u64((uint64_t)self->count, UINT64_C(8));
    for (uint64_t at = from; at < (uint64_t)at_end; at++) {
        const uint64_t row = working_set_f64_8_row_16(self, at);
        const double sign = self->signs[at];
        reach_f64_8_t reach;
        working_set_f64_8_reach_16(self, rows, at, row, sign, &reach);
        working_set_f64_8_store(self, at, row, sign, &reach);
    }
}

void working_set_f64_8_remove_16(working_set_f64_8_t *BESSEMER_RESTRICT self,
    const double rows[128], uint64_t leaving)
{
    {
        const uint32_t end = (uint32_t)min_u64((uint64_t)self->count, UINT64_C(8));
        for (uint32_t at = 1U; at < end; at++) {
            if (at > leaving) {
                self->rows[at - 1U] = self->rows[at];
                self->signs[at - 1U] = self->signs[at];
                self->multipliers[at - 1U] = self->multipliers[at];
            }
        }
    }
    self->count = saturating_sub_u32(self->count, 1U);
    working_set_f64_8_factor_16(self, rows, leaving);
}

void working_set_f64_8_solve_transposed(const working_set_f64_8_t *self, const double b[8],
    double x[BESSEMER_RESTRICT 8])
{
    const uint32_t count = (uint32_t)min_u64((uint64_t)self->count, UINT64_C(8));
    (void)memcpy(x, b, sizeof(double[8]));
    for (uint32_t i = count; i-- > 0U;) {
        double sum = x[i];
        for (uint32_t k = i + 1U; k < count; k++) {
            sum -= self->lower[k + 8U * i] * x[k];
        }
        x[i] = sum;
    }
}

void working_set_f64_8_equations_16(const working_set_f64_8_t *self, const double low[16],
    const double high[16], double result[BESSEMER_RESTRICT 8])
{
    const uint32_t count = (uint32_t)min_u64((uint64_t)self->count, UINT64_C(8));
    double x[8] = {0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
    for (uint32_t i = 0U; i < count; i++) {
        const uint64_t row = working_set_f64_8_row_16(self, i);
        double sum;
        if (self->signs[i] > 0.0) {
            sum = -high[row];
        } else {
            sum = low[row];
        }
        for (uint32_t k = 0U; k < i; k++) {
            sum -= self->lower[i + 8U * k] * x[k];
        }
        x[i] = sum;
    }
    for (uint32_t i = 0U; i < count; i++) {
        x[i] /= self->pivots[i];
    }
    working_set_f64_8_solve_transposed(self, x, result);
}

void working_set_f64_8_first_leaving_16(const working_set_f64_8_t *self, const double direction[8],
    double most, double small, const double low[16], const double high[16],
    pair_usize_f64_t *BESSEMER_RESTRICT result)
{
    uint32_t leaving = 8U;
    double share = most;
    {
        const uint32_t end = (uint32_t)min_u64((uint64_t)self->count, UINT64_C(8));
        for (uint32_t i = 0U; i < end; i++) {
            const uint64_t row = working_set_f64_8_row_16(self, i);
            if (direction[i] < -small && low[row] < high[row]) {
                const double own = -self->multipliers[i] / direction[i];
                if (own < share) {
                    share = own;
                    leaving = i;
                }
            }
        }
    }
    result->first = leaving;
    result->second = share;
}

void working_set_f64_8_advance(working_set_f64_8_t *BESSEMER_RESTRICT self,
    const double direction[8], double share)
{
    {
        const uint32_t end = (uint32_t)min_u64((uint64_t)self->count, UINT64_C(8));
        for (uint32_t i = 0U; i < end; i++) {
            self->multipliers[i] += direction[i] * share;
        }
    }
}

void working_set_f64_8_minimum_16(const working_set_f64_8_t *self, const double rows[128],
    double point[BESSEMER_RESTRICT 8])
{
    for (uint32_t i = 0U; i < 8U; i++) {
        point[i] = 0.0;
    }
    {
        const uint32_t end = (uint32_t)min_u64((uint64_t)self->count, UINT64_C(8));
        for (uint32_t i = 0U; i < end; i++) {
            const uint64_t row = working_set_f64_8_row_16(self, i);
            const double weight = self->multipliers[i] * self->signs[i];
            for (uint32_t k = 0U; k < 8U; k++) {
                point[k] -= rows[(uint32_t)row + 16U * k] * weight;
            }
        }
    }
}

/* quadratic.h */

/** Result of a solver. */
typedef enum {
    /** The point is the minimum, to the tolerance. */
    OUTCOME_SOLVED = 0,
    /** The iterations were too few; the point is the best so far. */
    OUTCOME_UNFINISHED = 1,
    /**
     * No point is within the limits. The next call begins anew, as it does after numbers that are not finite.
     */
    OUTCOME_INFEASIBLE = 2
} outcome_t;

/** Point that a solver found. */
typedef struct {
    /** The point z. */
    float point[3];
    /** Result of the solver. */
    outcome_t outcome;
    /** Largest distance of a row of Az from its limits or its cone. */
    float violation;
} minimum_f32_3_t;

/** Point that a solver found. */
typedef struct {
    /** The point z. */
    double point[8];
    /** Result of the solver. */
    outcome_t outcome;
    /** Largest distance of a row of Az from its limits or its cone. */
    double violation;
} minimum_f64_8_t;

/** Constant part of a program for an `ActiveSet`, of `N` variables and `M` rows. */
typedef struct {
    /** L⁻ᵀ, with H = LLᵀ. A matrix by columns: [row + 8 * column]. */
    double inverse[64];
    /** A L⁻ᵀ. A matrix by columns: [row + 16 * column]. */
    double rows[128];
    /** Largest violation of a limit that counts as none, above 0, in the unit of the limits. */
    double tolerance;
} active_set_program_f64_8_16_t;

/** `Option<ActiveSetProgram_f64_8_16>`: a value, or none. */
typedef struct {
    /** True if there is a value. */
    bool is_some;
    /** The value, if there is one. */
    active_set_program_f64_8_16_t value;
} option_active_set_program_f64_8_16_t;

/** A row by the working rows before it. */
typedef struct {
    /** The row of L. */
    double lower[8];
    /** The square of its length. */
    double size;
    /** The pivot: the square of the part that the rows before do not reach. */
    double pivot;
} reach_f64_8_t;

/**
 * Rows of A L⁻ᵀ with an active limit, each with a sign: 1 at the upper limit, −1 at the lower one.
 */
typedef struct {
    /** Number of rows. */
    uint32_t count;
    /** Their indices. */
    uint32_t rows[8];
    /** Their signs. */
    double signs[8];
    /** Their multipliers, 0 or more; of an equation any number. */
    double multipliers[8];
    /**
     * L below its diagonal of ones, with LDLᵀ the products of the signed rows with each other.
     * A matrix by columns: [row + 8 * column].
     */
    double lower[64];
    /** D. */
    double pivots[8];
} working_set_f64_8_t;
