/* The C of tests/corpus/src/programs/matrices/scalar_products.rs. Written by a test. */

/* scalar_products.c */

double scalar_products_filtered(const double taps[10], const double values[10])
{
    return dot_f64_10(taps, values);
}

void scalar_products_information(const double jacobian[6], double result[BESSEMER_RESTRICT 4])
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
