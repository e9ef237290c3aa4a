/* The C of tests/corpus/src/programs/matrices/block_sparse.rs. Written by a test. */

/* block_sparse.c */

static const uint8_t MULTIPLIED_INDICES[5][5] = {
    {0U, 1U, 64U, 64U, 64U},
    {64U, 64U, 1U, 2U, 64U},
    {64U, 64U, 3U, 4U, 64U},
    {64U, 64U, 64U, 64U, 4U},
    {64U, 64U, 64U, 64U, 5U}
};
static const uint64_t SPARSE_PLACE_INDEX = UINT64_C(0);
static const uint64_t SPARSE_PLACE_INDEX_2 = UINT64_C(2);
static const uint64_t SPARSE_PLACE_INDEX_3 = UINT64_C(4);
static const uint64_t SPARSE_PLACE_INDEX_4 = UINT64_C(1);
static const uint64_t SPARSE_PLACE_INDEX_5 = UINT64_C(3);
static const uint8_t SPARSE_WITHIN_INDICES[5] = {0U, 1U, 3U, 4U, 5U};
static const uint8_t SPARSE_WITHIN_INDICES_2[6] = {0U, 1U, 2U, 3U, 4U, 5U};
static const uint16_t STEP_LEFTS[5] = {0U, 2U, 2U, 4U, 4U};
static const uint16_t STEP_TOPS[5] = {0U, 0U, 2U, 2U, 4U};
static const uint16_t TWO_STEPS_LEFTS[6] = {0U, 2U, 4U, 2U, 4U, 4U};
static const uint16_t TWO_STEPS_TOPS[6] = {0U, 0U, 0U, 2U, 2U, 4U};

static void block_sparse_step(double period, block_sparse_step_t *step);

/** The Jacobian of a step of this period, s. */
static void block_sparse_step(double period, block_sparse_step_t *step)
{
    block_sparse_step_zeros(step);
    const double block[4] = {
        1.0, 0.0,
        0.0, 1.0
    };
    block_sparse_step_set_0_0(step, block);
    const double block_2[4] = {
        1.0, 0.0,
        0.0, 1.0
    };
    block_sparse_step_set_1_1(step, block_2);
    const double block_3[4] = {
        1.0, 0.0,
        0.0, 1.0
    };
    block_sparse_step_set_2_2(step, block_3);
    const double block_4[4] = {
        period, 0.0,
        0.0, period
    };
    block_sparse_step_set_0_1(step, block_4);
    const double block_5[4] = {
        -period, 0.0,
        0.0, -period
    };
    block_sparse_step_set_1_2(step, block_5);
}

void block_sparse_predicted(const double state[6], const double covariance[36], double period,
    symmetric_f64_6_t work_symmetric_f64_6[BESSEMER_RESTRICT 2],
    double work_numbers[BESSEMER_RESTRICT 36],
    pair_vector6_f64_matrix6x6_f64_t *BESSEMER_RESTRICT result)
{
    block_sparse_step_t step;
    block_sparse_step(period, &step);
    symmetric_f64_6_t *const after_matrix = &work_symmetric_f64_6[1];
    symmetric_f64_6_of_lower(covariance, after_matrix);
    symmetric_f64_6_t *const after = &work_symmetric_f64_6[0];
    block_sparse_step_congruence(&step, after_matrix, work_numbers, after);
    block_sparse_step_times_1(&step, state, result->first);
    (void)memcpy(result->second, after->elements, sizeof(double[36]));
}

void block_sparse_two_steps(double period, pair_matrix6x6_f64_matrix6x6_f64_t *result)
{
    block_sparse_step_t step;
    block_sparse_step(period, &step);
    two_steps_t both;
    block_sparse_step_product_6_5_307_6_311(&step, &step, &both);
    two_steps_t sum;
    block_sparse_step_sum_6_311_6_311(&step, &both, &sum);
    two_steps_matrix(&both, result->first);
    two_steps_matrix(&sum, result->second);
}

void block_sparse_corrected(const double covariance[36], const double jacobian[24],
    const double innovation[4], symmetric_f64_6_t *BESSEMER_RESTRICT work,
    triple_f64_vector6_f64_matrix6x6_f64_t *BESSEMER_RESTRICT result)
{
    block_sparse_f64_4_6_2_2_33_t jacobian_2;
    block_sparse_f64_4_6_2_2_33_of_matrix(jacobian, &jacobian_2);
    for (uint32_t i = 0U; i < 6U; i++) {
        result->second[i] = 0.0;
    }
    symmetric_f64_6_t *const covariance_2 = work;
    symmetric_f64_6_of_lower(covariance, covariance_2);
    const double noise_values[4] = {0.25, 0.25, 0.25, 0.25};
    symmetric_f64_4_t noise;
    symmetric_f64_4_diagonal(noise_values, &noise);
    correction_f64_t report;
    symmetric_f64_6_correct_sparse_4_2_2_33(covariance_2, result->second, &jacobian_2, innovation,
        &noise, 30.0, &report);
    result->first = report.surprise;
    (void)memcpy(result->third, covariance_2->elements, sizeof(double[36]));
}

void block_sparse_before(float period, const float gradient[4],
    pair_vector4_f32_matrix2x2_f32_t *BESSEMER_RESTRICT result)
{
    block_sparse_f32_4_4_2_3_11_t step;
    block_sparse_f32_4_4_2_3_11_zeros(&step);
    const float block[4] = {
        1.0F, 0.0F,
        0.0F, 1.0F
    };
    block_sparse_f32_4_4_2_3_11_set_0_0(&step, block);
    const float block_2[4] = {
        1.0F, 0.0F,
        0.0F, 1.0F
    };
    block_sparse_f32_4_4_2_3_11_set_1_1(&step, block_2);
    const float block_3[4] = {
        period, 0.0F,
        0.0F, period
    };
    block_sparse_f32_4_4_2_3_11_set_0_1(&step, block_3);
    block_sparse_f32_4_4_2_3_11_transposed_times_1(&step, gradient, result->first);
    block_sparse_f32_4_4_2_3_11_block_0_1(&step, result->second);
}

void block_sparse_step_zeros(block_sparse_step_t *step)
{
    for (uint32_t i = 0U; i < 5U; i++) {
        step->blocks[i][0] = 0.0;
        step->blocks[i][1] = 0.0;
        step->blocks[i][2] = 0.0;
        step->blocks[i][3] = 0.0;
    }
}

void two_steps_zeros(two_steps_t *two_steps)
{
    for (uint32_t i = 0U; i < 6U; i++) {
        two_steps->blocks[i][0] = 0.0;
        two_steps->blocks[i][1] = 0.0;
        two_steps->blocks[i][2] = 0.0;
        two_steps->blocks[i][3] = 0.0;
    }
}

void block_sparse_step_of_matrix(const double matrix[36],
    block_sparse_step_t *BESSEMER_RESTRICT sparse)
{
    block_sparse_step_zeros(sparse);
    for (uint32_t n = 0U; n < 5U; n++) {
        const uint32_t top = (uint32_t)min_u64((uint64_t)STEP_TOPS[n], UINT64_C(4));
        const uint32_t left = (uint32_t)min_u64((uint64_t)STEP_LEFTS[n], UINT64_C(4));
        for (uint32_t col = 0U; col < 2U; col++) {
            for (uint32_t row = 0U; row < 2U; row++) {
                sparse->blocks[n][row + 2U * col] = matrix[top + row + 6U * (left + col)];
            }
        }
    }
}

void two_steps_of_matrix(const double matrix[36], two_steps_t *BESSEMER_RESTRICT sparse)
{
    two_steps_zeros(sparse);
    for (uint32_t n = 0U; n < 6U; n++) {
        const uint32_t top = (uint32_t)min_u64((uint64_t)TWO_STEPS_TOPS[n], UINT64_C(4));
        const uint32_t left = (uint32_t)min_u64((uint64_t)TWO_STEPS_LEFTS[n], UINT64_C(4));
        for (uint32_t col = 0U; col < 2U; col++) {
            for (uint32_t row = 0U; row < 2U; row++) {
                sparse->blocks[n][row + 2U * col] = matrix[top + row + 6U * (left + col)];
            }
        }
    }
}

void block_sparse_step_matrix(const block_sparse_step_t *self, double matrix[BESSEMER_RESTRICT 36])
{
    for (uint32_t i = 0U; i < 36U; i++) {
        matrix[i] = 0.0;
    }
    for (uint32_t n = 0U; n < 5U; n++) {
        const uint32_t top = (uint32_t)min_u64((uint64_t)STEP_TOPS[n], UINT64_C(4));
        const uint32_t left = (uint32_t)min_u64((uint64_t)STEP_LEFTS[n], UINT64_C(4));
        for (uint32_t col = 0U; col < 2U; col++) {
            for (uint32_t row = 0U; row < 2U; row++) {
                matrix[top + row + 6U * (left + col)] = self->blocks[n][row + 2U * col];
            }
        }
    }
}

void two_steps_matrix(const two_steps_t *self, double matrix[BESSEMER_RESTRICT 36])
{
    for (uint32_t i = 0U; i < 36U; i++) {
        matrix[i] = 0.0;
    }
    for (uint32_t n = 0U; n < 6U; n++) {
        const uint32_t top = (uint32_t)min_u64((uint64_t)TWO_STEPS_TOPS[n], UINT64_C(4));
        const uint32_t left = (uint32_t)min_u64((uint64_t)TWO_STEPS_LEFTS[n], UINT64_C(4));
        for (uint32_t col = 0U; col < 2U; col++) {
            for (uint32_t row = 0U; row < 2U; row++) {
                matrix[top + row + 6U * (left + col)] = self->blocks[n][row + 2U * col];
            }
        }
    }
}

void block_sparse_step_set_0_0(block_sparse_step_t *BESSEMER_RESTRICT self, const double block[4])
{
    self->blocks[SPARSE_PLACE_INDEX][0] = block[0];
    self->blocks[SPARSE_PLACE_INDEX][1] = block[1];
    self->blocks[SPARSE_PLACE_INDEX][2] = block[2];
    self->blocks[SPARSE_PLACE_INDEX][3] = block[3];
}

void block_sparse_step_set_0_1(block_sparse_step_t *BESSEMER_RESTRICT self, const double block[4])
{
    self->blocks[SPARSE_PLACE_INDEX_4][0] = block[0];
    self->blocks[SPARSE_PLACE_INDEX_4][1] = block[1];
    self->blocks[SPARSE_PLACE_INDEX_4][2] = block[2];
    self->blocks[SPARSE_PLACE_INDEX_4][3] = block[3];
}

void block_sparse_step_set_1_1(block_sparse_step_t *BESSEMER_RESTRICT self, const double block[4])
{
    self->blocks[SPARSE_PLACE_INDEX_2][0] = block[0];
    self->blocks[SPARSE_PLACE_INDEX_2][1] = block[1];
    self->blocks[SPARSE_PLACE_INDEX_2][2] = block[2];
    self->blocks[SPARSE_PLACE_INDEX_2][3] = block[3];
}

void block_sparse_step_set_1_2(block_sparse_step_t *BESSEMER_RESTRICT self, const double block[4])
{
    self->blocks[SPARSE_PLACE_INDEX_5][0] = block[0];
    self->blocks[SPARSE_PLACE_INDEX_5][1] = block[1];
    self->blocks[SPARSE_PLACE_INDEX_5][2] = block[2];
    self->blocks[SPARSE_PLACE_INDEX_5][3] = block[3];
}

void block_sparse_step_set_2_2(block_sparse_step_t *BESSEMER_RESTRICT self, const double block[4])
{
    self->blocks[SPARSE_PLACE_INDEX_3][0] = block[0];
    self->blocks[SPARSE_PLACE_INDEX_3][1] = block[1];
    self->blocks[SPARSE_PLACE_INDEX_3][2] = block[2];
    self->blocks[SPARSE_PLACE_INDEX_3][3] = block[3];
}

void block_sparse_step_times_1(const block_sparse_step_t *self, const double right[6],
    double product[BESSEMER_RESTRICT 6])
{
    for (uint32_t i = 0U; i < 6U; i++) {
        product[i] = 0.0;
    }
    for (uint32_t n = 0U; n < 5U; n++) {
        const uint32_t top = (uint32_t)min_u64((uint64_t)STEP_TOPS[n], UINT64_C(4));
        const uint32_t left = (uint32_t)min_u64((uint64_t)STEP_LEFTS[n], UINT64_C(4));
        for (uint32_t col = 0U; col < 1U; col++) {
            for (uint32_t row = 0U; row < 2U; row++) {
                double sum = product[top + row];
                for (uint32_t k = 0U; k < 2U; k++) {
                    sum += self->blocks[n][row + 2U * k] * right[left + k];
                }
                product[top + row] = sum;
            }
        }
    }
}

void block_sparse_step_product_6_5_307_6_311(const block_sparse_step_t *self,
    const block_sparse_step_t *right, two_steps_t *BESSEMER_RESTRICT product)
{
    two_steps_zeros(product);
    for (uint32_t n = 0U; n < 5U; n++) {
        for (uint32_t m = 0U; m < 5U; m++) {
            const uint32_t at = (uint32_t)MULTIPLIED_INDICES[n][m];
            if (at < 6U) {
                for (uint32_t col = 0U; col < 2U; col++) {
                    for (uint32_t row = 0U; row < 2U; row++) {
                        double sum = product->blocks[at][row + 2U * col];
                        for (uint32_t k = 0U; k < 2U; k++) {
                            sum += self->blocks[n][row + 2U * k] * right->blocks[m][k + 2U * col];
                        }
                        product->blocks[at][row + 2U * col] = sum;
                    }
                }
            }
        }
    }
}

void block_sparse_step_sum_6_311_6_311(const block_sparse_step_t *self, const two_steps_t *other,
    two_steps_t *BESSEMER_RESTRICT sum)
{
    two_steps_zeros(sum);
    for (uint32_t n = 0U; n < 5U; n++) {
        const uint32_t at = (uint32_t)min_u64((uint64_t)SPARSE_WITHIN_INDICES[n], UINT64_C(5));
        sum->blocks[at][0] = self->blocks[n][0];
        sum->blocks[at][1] = self->blocks[n][1];
        sum->blocks[at][2] = self->blocks[n][2];
        sum->blocks[at][3] = self->blocks[n][3];
    }
    for (uint32_t n = 0U; n < 6U; n++) {
        const uint32_t at = (uint32_t)min_u64((uint64_t)SPARSE_WITHIN_INDICES_2[n], UINT64_C(5));
        for (uint32_t col = 0U; col < 2U; col++) {
            for (uint32_t row = 0U; row < 2U; row++) {
                sum->blocks[at][row + 2U * col] += other->blocks[n][row + 2U * col];
            }
        }
    }
}

void block_sparse_step_congruence(const block_sparse_step_t *self, const symmetric_f64_6_t *matrix,
    double work[BESSEMER_RESTRICT 36], symmetric_f64_6_t *BESSEMER_RESTRICT result)
{
    double *const product = work;
    block_sparse_step_spread(self, matrix, product);
    static const double result_values[6] = {0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
    symmetric_f64_6_diagonal(result_values, result);
    for (uint32_t n = 0U; n < 5U; n++) {
        const uint32_t top = (uint32_t)min_u64((uint64_t)STEP_TOPS[n], UINT64_C(4));
        const uint32_t left = (uint32_t)min_u64((uint64_t)STEP_LEFTS[n], UINT64_C(4));
        for (uint32_t row = 0U; row < 2U; row++) {
            for (uint32_t col = 0U; col <= top + row; col++) {
                double sum = result->elements[top + row + 6U * col];
                for (uint32_t k = 0U; k < 2U; k++) {
                    sum += self->blocks[n][row + 2U * k] * product[left + k + 6U * col];
                }
                result->elements[top + row + 6U * col] = sum;
                result->elements[col + 6U * (top + row)] = sum;
            }
        }
    }
}

void two_steps_congruence(const two_steps_t *self, const symmetric_f64_6_t *matrix,
    double work[BESSEMER_RESTRICT 36], symmetric_f64_6_t *BESSEMER_RESTRICT result)
{
    double *const product = work;
    two_steps_spread(self, matrix, product);
    static const double result_values[6] = {0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
    symmetric_f64_6_diagonal(result_values, result);
    for (uint32_t n = 0U; n < 6U; n++) {
        const uint32_t top = (uint32_t)min_u64((uint64_t)TWO_STEPS_TOPS[n], UINT64_C(4));
        const uint32_t left = (uint32_t)min_u64((uint64_t)TWO_STEPS_LEFTS[n], UINT64_C(4));
        for (uint32_t row = 0U; row < 2U; row++) {
            for (uint32_t col = 0U; col <= top + row; col++) {
                double sum = result->elements[top + row + 6U * col];
                for (uint32_t k = 0U; k < 2U; k++) {
                    sum += self->blocks[n][row + 2U * k] * product[left + k + 6U * col];
                }
                result->elements[top + row + 6U * col] = sum;
                result->elements[col + 6U * (top + row)] = sum;
            }
        }
    }
}

void block_sparse_step_spread(const block_sparse_step_t *self, const symmetric_f64_6_t *matrix,
    double product[BESSEMER_RESTRICT 36])
{
    for (uint32_t i = 0U; i < 36U; i++) {
        product[i] = 0.0;
    }
    for (uint32_t n = 0U; n < 5U; n++) {
        const uint32_t top = (uint32_t)min_u64((uint64_t)STEP_TOPS[n], UINT64_C(4));
        const uint32_t left = (uint32_t)min_u64((uint64_t)STEP_LEFTS[n], UINT64_C(4));
        for (uint32_t col = 0U; col < 2U; col++) {
            for (uint32_t row = 0U; row < 6U; row++) {
                double sum = product[row + 6U * (top + col)];
                for (uint32_t k = 0U; k < 2U; k++) {
                    sum += matrix->elements[row + 6U * (left + k)] * self->blocks[n][col + 2U * k];
                }
                product[row + 6U * (top + col)] = sum;
            }
        }
    }
}

void two_steps_spread(const two_steps_t *self, const symmetric_f64_6_t *matrix,
    double product[BESSEMER_RESTRICT 36])
{
    for (uint32_t i = 0U; i < 36U; i++) {
        product[i] = 0.0;
    }
    for (uint32_t n = 0U; n < 6U; n++) {
        const uint32_t top = (uint32_t)min_u64((uint64_t)TWO_STEPS_TOPS[n], UINT64_C(4));
        const uint32_t left = (uint32_t)min_u64((uint64_t)TWO_STEPS_LEFTS[n], UINT64_C(4));
        for (uint32_t col = 0U; col < 2U; col++) {
            for (uint32_t row = 0U; row < 6U; row++) {
                double sum = product[row + 6U * (top + col)];
                for (uint32_t k = 0U; k < 2U; k++) {
                    sum += matrix->elements[row + 6U * (left + k)] * self->blocks[n][col + 2U * k];
                }
                product[row + 6U * (top + col)] = sum;
            }
        }
    }
}

/* block_sparse.h */

/** The Jacobian of a step. */
typedef struct {
    /** Stored blocks, row after row. A matrix each by columns: [row + 2 * column]. */
    double blocks[5][4];
} block_sparse_step_t;

/** The Jacobian of two steps. */
typedef struct {
    /** Stored blocks, row after row. A matrix each by columns: [row + 2 * column]. */
    double blocks[6][4];
} two_steps_t;
