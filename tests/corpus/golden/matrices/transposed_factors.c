/* The C of tests/corpus/src/programs/matrices/transposed_factors.rs. Written by a test. */

/* transposed_factors.c */

void transposed_factors_advance(belief_t *BESSEMER_RESTRICT belief, const double advance[4])
{
    const double covariance_product[4] = {
        advance[0 + 2 * 0] * belief->covariance[0 + 2 * 0]
            + advance[0 + 2 * 1] * belief->covariance[1 + 2 * 0],
        advance[1 + 2 * 0] * belief->covariance[0 + 2 * 0]
            + advance[1 + 2 * 1] * belief->covariance[1 + 2 * 0],
        advance[0 + 2 * 0] * belief->covariance[0 + 2 * 1]
            + advance[0 + 2 * 1] * belief->covariance[1 + 2 * 1],
        advance[1 + 2 * 0] * belief->covariance[0 + 2 * 1]
            + advance[1 + 2 * 1] * belief->covariance[1 + 2 * 1]
    };
    {
        const double product[4] = {
            covariance_product[0 + 2 * 0] * advance[0 + 2 * 0]
                + covariance_product[0 + 2 * 1] * advance[0 + 2 * 1],
            covariance_product[1 + 2 * 0] * advance[0 + 2 * 0]
                + covariance_product[1 + 2 * 1] * advance[0 + 2 * 1],
            covariance_product[0 + 2 * 0] * advance[1 + 2 * 0]
                + covariance_product[0 + 2 * 1] * advance[1 + 2 * 1],
            covariance_product[1 + 2 * 0] * advance[1 + 2 * 0]
                + covariance_product[1 + 2 * 1] * advance[1 + 2 * 1]
        };
        belief->covariance[0] = product[0];
        belief->covariance[1] = product[1];
        belief->covariance[2] = product[2];
        belief->covariance[3] = product[3];
    }
    const double covariance_next[4] = {
        (belief->covariance[0 + 2 * 0] + belief->covariance[0 + 2 * 0]) * 0.5,
        (belief->covariance[1 + 2 * 0] + belief->covariance[0 + 2 * 1]) * 0.5,
        (belief->covariance[0 + 2 * 1] + belief->covariance[1 + 2 * 0]) * 0.5,
        (belief->covariance[1 + 2 * 1] + belief->covariance[1 + 2 * 1]) * 0.5
    };
    belief->covariance[0] = covariance_next[0];
    belief->covariance[1] = covariance_next[1];
    belief->covariance[2] = covariance_next[2];
    belief->covariance[3] = covariance_next[3];
    const double mean_next[2] = {
        advance[0 + 2 * 0] * belief->mean[0] + advance[1 + 2 * 0] * belief->mean[1],
        advance[0 + 2 * 1] * belief->mean[0] + advance[1 + 2 * 1] * belief->mean[1]
    };
    belief->mean[0] = mean_next[0];
    belief->mean[1] = mean_next[1];
}

void transposed_factors_corrected(const double covariance[9], const double gain[3],
    const double row[3], double variance, double result[BESSEMER_RESTRICT 9])
{
    static const double kept_matrix[9] = {
        1.0, 0.0, 0.0,
        0.0, 1.0, 0.0,
        0.0, 0.0, 1.0
    };
    double kept[9];
    for (uint32_t column = 0U; column < 3U; column++) {
        BESSEMER_FEW_PASSES
        for (uint32_t i = 0U; i < 3U; i++) {
            kept[i + 3U * column] = kept_matrix[i + 3U * column] - gain[i] * row[column];
        }
    }
    double result_product[9];
    product_f64_3x3_3x3(kept, covariance, result_product);
    double result_product_2[9];
    product_tr_f64_3x3_3x3(result_product, kept, result_product_2);
    for (uint32_t column = 0U; column < 3U; column++) {
        BESSEMER_FEW_PASSES
        for (uint32_t i = 0U; i < 3U; i++) {
            result[i + 3U * column] = result_product_2[i + 3U * column]
                + gain[i] * gain[column] * variance;
        }
    }
}

void transposed_factors_oblongs(const float a[6], const float b[6],
    triple_matrix3x3_f32_matrix2x2_f32_matrix3x2_f32_t *BESSEMER_RESTRICT result)
{
    {
        const float product[9] = {
            a[0 + 2 * 0] * b[0 + 3 * 0] + a[1 + 2 * 0] * b[0 + 3 * 1],
            a[0 + 2 * 1] * b[0 + 3 * 0] + a[1 + 2 * 1] * b[0 + 3 * 1],
            a[0 + 2 * 2] * b[0 + 3 * 0] + a[1 + 2 * 2] * b[0 + 3 * 1],
            a[0 + 2 * 0] * b[1 + 3 * 0] + a[1 + 2 * 0] * b[1 + 3 * 1],
            a[0 + 2 * 1] * b[1 + 3 * 0] + a[1 + 2 * 1] * b[1 + 3 * 1],
            a[0 + 2 * 2] * b[1 + 3 * 0] + a[1 + 2 * 2] * b[1 + 3 * 1],
            a[0 + 2 * 0] * b[2 + 3 * 0] + a[1 + 2 * 0] * b[2 + 3 * 1],
            a[0 + 2 * 1] * b[2 + 3 * 0] + a[1 + 2 * 1] * b[2 + 3 * 1],
            a[0 + 2 * 2] * b[2 + 3 * 0] + a[1 + 2 * 2] * b[2 + 3 * 1]
        };
        result->first[0] = product[0];
        result->first[1] = product[1];
        result->first[2] = product[2];
        result->first[3] = product[3];
        result->first[4] = product[4];
        result->first[5] = product[5];
        result->first[6] = product[6];
        result->first[7] = product[7];
        result->first[8] = product[8];
    }
    for (uint32_t column = 0U; column < 2U; column++) {
        BESSEMER_FEW_PASSES
        for (uint32_t row = 0U; row < 3U; row++) {
            result->third[row + 3U * column] = a[column + 2U * row]
                - b[row + 3U * column] * a[column + 2U * row];
        }
    }
    const float result_product[4] = {
        a[0 + 2 * 0] * a[0 + 2 * 0] + a[0 + 2 * 1] * a[0 + 2 * 1] + a[0 + 2 * 2] * a[0 + 2 * 2],
        a[1 + 2 * 0] * a[0 + 2 * 0] + a[1 + 2 * 1] * a[0 + 2 * 1] + a[1 + 2 * 2] * a[0 + 2 * 2],
        a[0 + 2 * 0] * a[1 + 2 * 0] + a[0 + 2 * 1] * a[1 + 2 * 1] + a[0 + 2 * 2] * a[1 + 2 * 2],
        a[1 + 2 * 0] * a[1 + 2 * 0] + a[1 + 2 * 1] * a[1 + 2 * 1] + a[1 + 2 * 2] * a[1 + 2 * 2]
    };
    const float result_product_2[4] = {
        b[0 + 3 * 0] * b[0 + 3 * 0] + b[1 + 3 * 0] * b[1 + 3 * 0] + b[2 + 3 * 0] * b[2 + 3 * 0],
        b[0 + 3 * 1] * b[0 + 3 * 0] + b[1 + 3 * 1] * b[1 + 3 * 0] + b[2 + 3 * 1] * b[2 + 3 * 0],
        b[0 + 3 * 0] * b[0 + 3 * 1] + b[1 + 3 * 0] * b[1 + 3 * 1] + b[2 + 3 * 0] * b[2 + 3 * 1],
        b[0 + 3 * 1] * b[0 + 3 * 1] + b[1 + 3 * 1] * b[1 + 3 * 1] + b[2 + 3 * 1] * b[2 + 3 * 1]
    };
    result->second[0 + 2 * 0] = result_product[0 + 2 * 0] + result_product_2[0 + 2 * 0] * 2.0F;
    result->second[1 + 2 * 0] = result_product[1 + 2 * 0] + result_product_2[1 + 2 * 0] * 2.0F;
    result->second[0 + 2 * 1] = result_product[0 + 2 * 1] + result_product_2[0 + 2 * 1] * 2.0F;
    result->second[1 + 2 * 1] = result_product[1 + 2 * 1] + result_product_2[1 + 2 * 1] * 2.0F;
}

void transposed_factors_lines(const double a[4], const double b[4],
    triple_matrix1x4_f64_vector4_f64_f64_t *BESSEMER_RESTRICT result)
{
    result->first[0] = a[0] + b[0];
    result->first[1] = a[1] + b[1];
    result->first[2] = a[2] + b[2];
    result->first[3] = a[3] + b[3];
    result->second[0] = -(a[0] * 3.0 - b[0]);
    result->second[1] = -(a[1] * 3.0 - b[1]);
    result->second[2] = -(a[2] * 3.0 - b[2]);
    result->second[3] = -(a[3] * 3.0 - b[3]);
    const double vector[1] = {
        result->first[0] * result->second[0] + result->first[1] * result->second[1]
            + result->first[2] * result->second[2] + result->first[3] * result->second[3]
    };
    result->third = vector[0];
}

void transposed_factors_large(const double a[20], const double b[30],
    pair_matrix4x6_f64_matrix5x5_f64_t *BESSEMER_RESTRICT result)
{
    tr_product_f64_5x4_5x6(a, b, result->first);
    double result_product[25];
    product_tr_f64_5x6_5x6(b, b, result_product);
    double result_product_2[25];
    product_tr_f64_5x4_5x4(a, a, result_product_2);
    for (uint32_t i = 0U; i < 25U; i++) {
        result->second[i] = result_product[i] - result_product_2[i];
    }
}

/* transposed_factors.h */

/** Covariance and mean of two states. */
typedef struct {
    /** The covariance. A matrix by columns: [row + 2 * column]. */
    double covariance[4];
    /** The mean. */
    double mean[2];
} belief_t;
