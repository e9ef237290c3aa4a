/* The C of tests/corpus/src/programs/matrices/products.rs. Written by a test. */

/* products.c */

void products_advanced(const double system[4], const double input[2], const double state[2],
    double command, double result[BESSEMER_RESTRICT 2])
{
    const double result_product[2] = {
        system[0 + 2 * 0] * state[0] + system[0 + 2 * 1] * state[1],
        system[1 + 2 * 0] * state[0] + system[1 + 2 * 1] * state[1]
    };
    result[0] = result_product[0] + input[0] * command;
    result[1] = result_product[1] + input[1] * command;
}

void products_spread(const double a[9], const double p[9], const double q[9],
    double result[BESSEMER_RESTRICT 9])
{
    double result_product[9];
    product_f64_3x3_3x3(a, p, result_product);
    double result_product_2[9];
    product_tr_f64_3x3_3x3(result_product, a, result_product_2);
    BESSEMER_FEW_PASSES
    for (uint32_t i = 0U; i < 9U; i++) {
        result[i] = result_product_2[i] + q[i];
    }
}
