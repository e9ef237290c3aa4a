/* The C of tests/corpus/src/programs/matrices/rotation_matrices.rs. Written by a test. */

/* mounting.c */

void mounting_init(mounting_t *self)
{
    for (uint32_t i = 0U; i < 9U; i++) {
        self->rotation[i] = 0.0;
    }
    self->rotation[0 + 3 * 0] = 1.0;
    self->rotation[1 + 3 * 1] = 1.0;
    self->rotation[2 + 3 * 2] = 1.0;
}

void mounting_turned(const mounting_t *self, const double measured[3],
    double result[BESSEMER_RESTRICT 3])
{
    result[0] = self->rotation[0 + 3 * 0] * measured[0] + self->rotation[0 + 3 * 1] * measured[1]
        + self->rotation[0 + 3 * 2] * measured[2];
    result[1] = self->rotation[1 + 3 * 0] * measured[0] + self->rotation[1 + 3 * 1] * measured[1]
        + self->rotation[1 + 3 * 2] * measured[2];
    result[2] = self->rotation[2 + 3 * 0] * measured[0] + self->rotation[2 + 3 * 1] * measured[1]
        + self->rotation[2 + 3 * 2] * measured[2];
}

double mounting_mount(mounting_t *BESSEMER_RESTRICT self, const double more[9])
{
    double rotation_next[9];
    product_f64_3x3_3x3(more, self->rotation, rotation_next);
    (void)memcpy(self->rotation, rotation_next, sizeof(double[9]));
    return parts_trace_f64_3(self->rotation);
}

/* mounting.h */

/** Rotates measurements of a sensor into the vehicle's frame. */
typedef struct {
    /**
     * Rotation from the sensor's frame to the vehicle's. A matrix by columns: [row + 3 * column].
     */
    double rotation[9];
} mounting_t;

/* rotation_matrices.c */

void rotation_matrices_between(const double a[9], const double b[9],
    double back[BESSEMER_RESTRICT 9])
{
    double back_product[9];
    tr_product_f64_3x3_3x3(a, b, back_product);
    product_tr_f64_3x3_3x3(back_product, a, back);
    double back_next[9];
    product_tr_f64_3x3_3x3(back, b, back_next);
    (void)memcpy(back, back_next, sizeof(double[9]));
    matrix_edit_transpose_mut_f64_3(back);
}

void rotation_matrices_moved(const float m[9], const float v[3], const float p[3],
    pair_vector3_f32_vector3_f32_t *BESSEMER_RESTRICT result)
{
    const float there_product[3] = {
        m[0 + 3 * 0] * v[0] + m[0 + 3 * 1] * v[1] + m[0 + 3 * 2] * v[2],
        m[1 + 3 * 0] * v[0] + m[1 + 3 * 1] * v[1] + m[1 + 3 * 2] * v[2],
        m[2 + 3 * 0] * v[0] + m[2 + 3 * 1] * v[1] + m[2 + 3 * 2] * v[2]
    };
    const float there_product_2[3] = {
        m[0 + 3 * 0] * v[0] + m[0 + 3 * 1] * v[1] + m[0 + 3 * 2] * v[2],
        m[1 + 3 * 0] * v[0] + m[1 + 3 * 1] * v[1] + m[1 + 3 * 2] * v[2],
        m[2 + 3 * 0] * v[0] + m[2 + 3 * 1] * v[1] + m[2 + 3 * 2] * v[2]
    };
    result->first[0] = there_product[0] + there_product_2[0];
    result->first[1] = there_product[1] + there_product_2[1];
    result->first[2] = there_product[2] + there_product_2[2];
    const float point_product[3] = {
        m[0 + 3 * 0] * p[0] + m[0 + 3 * 1] * p[1] + m[0 + 3 * 2] * p[2],
        m[1 + 3 * 0] * p[0] + m[1 + 3 * 1] * p[1] + m[1 + 3 * 2] * p[2],
        m[2 + 3 * 0] * p[0] + m[2 + 3 * 1] * p[1] + m[2 + 3 * 2] * p[2]
    };
    const float point_product_2[3] = {
        m[0 + 3 * 0] * result->first[0] + m[1 + 3 * 0] * result->first[1]
            + m[2 + 3 * 0] * result->first[2],
        m[0 + 3 * 1] * result->first[0] + m[1 + 3 * 1] * result->first[1]
            + m[2 + 3 * 1] * result->first[2],
        m[0 + 3 * 2] * result->first[0] + m[1 + 3 * 2] * result->first[1]
            + m[2 + 3 * 2] * result->first[2]
    };
    const float point[3] = {
        point_product[0] + point_product_2[0],
        point_product[1] + point_product_2[1],
        point_product[2] + point_product_2[2]
    };
    result->second[0] = m[0 + 3 * 0] * point[0] + m[1 + 3 * 0] * point[1] + m[2 + 3 * 0] * point[2];
    result->second[1] = m[0 + 3 * 1] * point[0] + m[1 + 3 * 1] * point[1] + m[2 + 3 * 1] * point[2];
    result->second[2] = m[0 + 3 * 2] * point[0] + m[1 + 3 * 2] * point[1] + m[2 + 3 * 2] * point[2];
}

void rotation_matrices_covariance(const double m[9], const double p[9],
    double result[BESSEMER_RESTRICT 9])
{
    double result_product[9];
    product_f64_3x3_3x3(m, p, result_product);
    product_tr_f64_3x3_3x3(result_product, m, result);
}

double rotation_matrices_raw(const double m[9])
{
    const double *const rotation = m;
    return rotation[2 + 3 * 1] + rotation[0 + 3 * 2];
}

void rotation_matrices_plane(const double m[4], const double v[2],
    double result[BESSEMER_RESTRICT 2])
{
    const double vector[4] = {
        1.0, 0.0,
        0.0, 1.0
    };
    bool result_equal = true;
    for (uint32_t i = 0U; i < 2U; i++) {
        bool result_equal_2 = true;
        for (uint32_t j = 0U; j < 2U; j++) {
            if (m[j + 2U * i] != vector[j + 2U * i]) {
                result_equal_2 = false;
                break;
            }
        }
        if (!result_equal_2) {
            result_equal = false;
            break;
        }
    }
    if (result_equal) {
        result[0] = v[0];
        result[1] = v[1];
    } else {
        const double result_product[2] = {
            m[0 + 2 * 0] * v[0] + m[0 + 2 * 1] * v[1],
            m[1 + 2 * 0] * v[0] + m[1 + 2 * 1] * v[1]
        };
        result[0] = m[0 + 2 * 0] * result_product[0] + m[1 + 2 * 0] * result_product[1];
        result[1] = m[0 + 2 * 1] * result_product[0] + m[1 + 2 * 1] * result_product[1];
    }
}
