/* The C of tests/corpus/src/programs/matrices/written_parts.rs. Written by a test. */

/* written_parts_blocks.c */

void blocks_init(blocks_t *self)
{
    for (uint32_t i = 0U; i < 36U; i++) {
        self->p[i] = 0.0;
    }
    self->fault = BESSEMER_STATUS_OK;
}

void blocks_reset(blocks_t *BESSEMER_RESTRICT self, const double cross[9], double noise)
{
    for (uint32_t column = 0U; column < 3U; column++) {
        for (uint32_t row = 0U; row < 3U; row++) {
            self->p[row + 6U * (column + 3U)] = cross[row + 3U * column];
        }
    }
    double part[9] = {
        self->p[3 + 6 * 3], self->p[4 + 6 * 3], self->p[5 + 6 * 3],
        self->p[3 + 6 * 4], self->p[4 + 6 * 4], self->p[5 + 6 * 4],
        self->p[3 + 6 * 5], self->p[4 + 6 * 5], self->p[5 + 6 * 5]
    };
    matrix_edit_fill_diagonal_f64_3_3(part, noise);
    for (uint32_t column = 0U; column < 3U; column++) {
        for (uint32_t row = 0U; row < 3U; row++) {
            self->p[row + 3U + 6U * (column + 3U)] = part[row + 3U * column];
        }
    }
    for (uint32_t column = 0U; column < 2U; column++) {
        for (uint32_t row = 0U; row < 2U; row++) {
            self->p[row + 3U + 6U * (column + 4U)] = 0.5;
        }
    }
}

void blocks_exchange(blocks_t *self)
{
    for (uint32_t column = 0U; column < 6U; column++) {
        const double held = self->p[0U + 6U * column];
        self->p[0U + 6U * column] = self->p[1U + 6U * column];
        self->p[1U + 6U * column] = held;
    }
    for (uint32_t row = 0U; row < 6U; row++) {
        const double held = self->p[row + 6U * 0U];
        self->p[row + 6U * 0U] = self->p[row + 6U * 1U];
        self->p[row + 6U * 1U] = held;
    }
}

void blocks_update(blocks_t *BESSEMER_RESTRICT self, const double gain[6], const double row[6])
{
    for (uint32_t i = 0U; i < 3U; i++) {
        for (uint32_t j = 0U; j < 6U; j++) {
            self->p[j + 6U * i] = gain[j];
        }
    }
    double b[6];
    BESSEMER_FEW_PASSES
    for (uint32_t i = 0U; i < 6U; i++) {
        b[i] = gain[i] * 2.0;
    }
    for (uint32_t i = 0U; i < 6U; i++) {
        self->p[i + 6U * 4U] = b[i];
    }
    for (uint32_t column = 0U; column < 6U; column++) {
        self->p[5U + 6U * column] = row[column];
    }
    for (uint32_t i = 0U; i < 6U; i++) {
        self->p[i + 6U * 3U] = 0.0;
    }
}

bessemer_status_t blocks_set(blocks_t *BESSEMER_RESTRICT self, uint64_t at, const double part[3])
{
    if (self->fault != BESSEMER_STATUS_OK) {
        return self->fault;
    }
    if (at > UINT64_C(0xFFFFFFFFFFFFFFFC)) {
        self->fault = BESSEMER_STATUS_OVERFLOW;
        return BESSEMER_STATUS_OVERFLOW;
    }
    if (at + UINT64_C(3) > UINT64_C(6)) {
        self->fault = BESSEMER_STATUS_INDEX;
        return BESSEMER_STATUS_INDEX;
    }
    for (uint32_t row = 0U; row < 3U; row++) {
        self->p[at + row + 6U * (uint32_t)at] = part[row];
    }
    return BESSEMER_STATUS_OK;
}

/* written_parts_blocks.h */

/** A covariance whose blocks are set individually. */
typedef struct {
    /** A matrix by columns: [row + 6 * column]. */
    double p[36];
    /** The fault that stopped the component; BESSEMER_STATUS_OK while it runs. */
    bessemer_status_t fault;
} blocks_t;
