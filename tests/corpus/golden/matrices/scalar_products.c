/* The C of tests/corpus/src/programs/matrices/scalar_products.rs. Written by a test. */

/* scalar_products.c */

/* The scalar product of two matrices by columns, in eight lanes and in nalgebra's order. */
static double dot_f64(const double *a, const double *b, uint32_t rows, uint32_t columns)
{
    double sum = 0.0;
    for (uint32_t column = 0U; column < columns; column++) {
        double lane[8] = {0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
        const uint32_t end = (column + 1U) * rows;
        uint32_t i = column * rows;
        for (; end - i >= 8U; i += 8U) {
            lane[0] += a[i] * b[i];
            lane[1] += a[i + 1U] * b[i + 1U];
            lane[2] += a[i + 2U] * b[i + 2U];
            lane[3] += a[i + 3U] * b[i + 3U];
            lane[4] += a[i + 4U] * b[i + 4U];
            lane[5] += a[i + 5U] * b[i + 5U];
            lane[6] += a[i + 6U] * b[i + 6U];
            lane[7] += a[i + 7U] * b[i + 7U];
        }
        sum += lane[0] + lane[4];
        sum += lane[1] + lane[5];
        sum += lane[2] + lane[6];
        sum += lane[3] + lane[7];
        for (; i < end; i++) {
            sum += a[i] * b[i];
        }
    }
    return sum;
}

double scalar_products_filtered(const double taps[10], const double values[10])
{
    return dot_f64(taps, values, 10U, 1U);
}

void scalar_products_information(const double jacobian[6], double result[4])
{
    {
        const double product[4] = {
            jacobian[0 + 3 * 0] * jacobian[0 + 3 * 0] + jacobian[1 + 3 * 0] * jacobian[1 + 3 * 0]
                + jacobian[2 + 3 * 0] * jacobian[2 + 3 * 0],
            jacobian[0 + 3 * 1] * jacobian[0 + 3 * 0] + jacobian[1 + 3 * 1] * jacobian[1 + 3 * 0]
                + jacobian[2 + 3 * 1] * jacobian[2 + 3 * 0],
            jacobian[0 + 3 * 0] * jacobian[0 + 3 * 1] + jacobian[1 + 3 * 0] * jacobian[1 + 3 * 1]
                + jacobian[2 + 3 * 0] * jacobian[2 + 3 * 1],
            jacobian[0 + 3 * 1] * jacobian[0 + 3 * 1] + jacobian[1 + 3 * 1] * jacobian[1 + 3 * 1]
                + jacobian[2 + 3 * 1] * jacobian[2 + 3 * 1]
        };
        result[0] = product[0];
        result[1] = product[1];
        result[2] = product[2];
        result[3] = product[3];
    }
}

float scalar_products_energy(const float v[4])
{
    return v[0] * v[0] + v[2] * v[2] + (v[1] * v[1] + v[3] * v[3]);
}
