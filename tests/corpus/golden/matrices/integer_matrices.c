/* The C of tests/corpus/src/programs/matrices/integer_matrices.rs. Written by a test. */

/* integer_matrices.c */

bessemer_status_t integer_matrices_corrected(const int32_t counts[4], const int32_t offsets[4],
    int32_t gain, int32_t result[BESSEMER_RESTRICT 4])
{
    int32_t result_difference[4];
    for (uint32_t col = 0U; col < 2U; col++) {
        for (uint32_t row = 0U; row < 2U; row++) {
            if ((int64_t)counts[row + 2U * col] - (int64_t)offsets[row + 2U * col] < INT32_MIN
                    || (int64_t)counts[row + 2U * col] - (int64_t)offsets[row + 2U * col]
                    > INT32_MAX) {
                return BESSEMER_STATUS_OVERFLOW;
            }
            result_difference[row + 2U * col] = counts[row + 2U * col] - offsets[row + 2U * col];
        }
    }
    int32_t result_scaled[4];
    for (uint32_t col = 0U; col < 2U; col++) {
        for (uint32_t row = 0U; row < 2U; row++) {
            if ((int64_t)result_difference[row + 2U * col] * (int64_t)gain < INT32_MIN
                    || (int64_t)result_difference[row + 2U * col] * (int64_t)gain > INT32_MAX) {
                return BESSEMER_STATUS_OVERFLOW;
            }
            result_scaled[row + 2U * col] = result_difference[row + 2U * col] * gain;
        }
    }
    const int32_t vector[4] = {
        1, 0,
        0, 1
    };
    int32_t result_sum[4];
    for (uint32_t col = 0U; col < 2U; col++) {
        for (uint32_t row = 0U; row < 2U; row++) {
            if ((int64_t)result_scaled[row + 2U * col] + (int64_t)vector[row + 2U * col] < INT32_MIN
                    || (int64_t)result_scaled[row + 2U * col] + (int64_t)vector[row + 2U * col]
                    > INT32_MAX) {
                return BESSEMER_STATUS_OVERFLOW;
            }
            result_sum[row + 2U * col] = result_scaled[row + 2U * col] + vector[row + 2U * col];
        }
    }
    result[0] = result_sum[0];
    result[1] = result_sum[1];
    result[2] = result_sum[2];
    result[3] = result_sum[3];
    return BESSEMER_STATUS_OK;
}

bessemer_status_t integer_matrices_mixed(const int16_t weights[6], const int16_t levels[3],
    int16_t result[BESSEMER_RESTRICT 2])
{
    int16_t result_product[2] = {0, 0};
    for (uint32_t row = 0U; row < 2U; row++) {
        for (uint32_t k = 0U; k < 3U; k++) {
            if ((int64_t)weights[row + 2U * k] * (int64_t)levels[k] < -INT64_C(32768)
                    || (int64_t)weights[row + 2U * k] * (int64_t)levels[k] > INT64_C(32767)) {
                return BESSEMER_STATUS_OVERFLOW;
            }
            const int16_t result_product_product = (int16_t)(weights[row + 2U * k] * levels[k]);
            if ((int64_t)result_product[row] + (int64_t)result_product_product < -INT64_C(32768)
                    || (int64_t)result_product[row] + (int64_t)result_product_product
                    > INT64_C(32767)) {
                return BESSEMER_STATUS_OVERFLOW;
            }
            result_product[row] = (int16_t)(result_product[row] + result_product_product);
        }
    }
    result[0] = result_product[0];
    result[1] = result_product[1];
    return BESSEMER_STATUS_OK;
}

bessemer_status_t integer_matrices_shares(const uint8_t parts[3], const uint8_t wholes[3],
    uint8_t divisor, uint8_t result[BESSEMER_RESTRICT 3])
{
    uint8_t result_quotient[3];
    for (uint32_t row = 0U; row < 3U; row++) {
        if (wholes[row] == 0U) {
            return BESSEMER_STATUS_DIVISION_BY_ZERO;
        }
        result_quotient[row] = (uint8_t)(parts[row] / wholes[row]);
    }
    uint8_t result_product[3];
    for (uint32_t row = 0U; row < 3U; row++) {
        if ((int64_t)parts[row] * (int64_t)wholes[row] > INT64_C(255)) {
            return BESSEMER_STATUS_OVERFLOW;
        }
        result_product[row] = (uint8_t)(parts[row] * wholes[row]);
    }
    uint8_t result_quotient_2[3];
    for (uint32_t row = 0U; row < 3U; row++) {
        if (divisor == 0U) {
            return BESSEMER_STATUS_DIVISION_BY_ZERO;
        }
        result_quotient_2[row] = (uint8_t)(result_product[row] / divisor);
    }
    uint8_t result_sum[3];
    for (uint32_t row = 0U; row < 3U; row++) {
        if ((int64_t)result_quotient[row] + (int64_t)result_quotient_2[row] > INT64_C(255)) {
            return BESSEMER_STATUS_OVERFLOW;
        }
        result_sum[row] = (uint8_t)(result_quotient[row] + result_quotient_2[row]);
    }
    result[0] = result_sum[0];
    result[1] = result_sum[1];
    result[2] = result_sum[2];
    return BESSEMER_STATUS_OK;
}

bessemer_status_t integer_matrices_turned(int8_t grid[9])
{
    int8_t grid_negative[9];
    for (uint32_t col = 0U; col < 3U; col++) {
        for (uint32_t row = 0U; row < 3U; row++) {
            if (grid[row + 3U * col] == INT8_MIN) {
                return BESSEMER_STATUS_OVERFLOW;
            }
            grid_negative[row + 3U * col] = (int8_t)(-grid[row + 3U * col]);
        }
    }
    (void)memcpy(grid, grid_negative, sizeof(int8_t[9]));
    int8_t vector[9];
    parts_from_diagonal_element_i8_3_3(1, vector);
    int8_t grid_sum[9];
    for (uint32_t col = 0U; col < 3U; col++) {
        for (uint32_t row = 0U; row < 3U; row++) {
            if ((int64_t)grid[row + 3U * col] + (int64_t)vector[row + 3U * col] < -INT64_C(128)
                    || (int64_t)grid[row + 3U * col] + (int64_t)vector[row + 3U * col]
                    > INT64_C(127)) {
                return BESSEMER_STATUS_OVERFLOW;
            }
            grid_sum[row + 3U * col] = (int8_t)(grid[row + 3U * col] + vector[row + 3U * col]);
        }
    }
    (void)memcpy(grid, grid_sum, sizeof(int8_t[9]));
    return BESSEMER_STATUS_OK;
}

bessemer_status_t integer_matrices_cleared(uint8_t map[16], uint64_t row)
{
    if (row >= UINT64_C(4)) {
        return BESSEMER_STATUS_INDEX;
    }
    for (uint32_t column = 0U; column < 4U; column++) {
        map[(uint32_t)row + 4U * column] = 9U;
    }
    for (uint32_t i = 0U; i < 4U; i++) {
        const uint8_t held = map[i + 4U * 0U];
        map[i + 4U * 0U] = map[i + 4U * 3U];
        map[i + 4U * 3U] = held;
    }
    matrix_edit_fill_lower_triangle_u8_4_4(map, 7U, UINT64_C(2));
    const uint8_t diagonal[4] = {1U, 2U, 3U, 4U};
    matrix_edit_set_diagonal_u8_4(map, diagonal);
    matrix_edit_transpose_mut_u8_4(map);
    return BESSEMER_STATUS_OK;
}

bessemer_status_t integer_matrices_summary(const int32_t map[9],
    tuple4_i32_i32_i32_i32_t *BESSEMER_RESTRICT result)
{
    bessemer_status_t status;
    int32_t result_first;
    status = matrix_statistics_sum_i32_3_3(map, &result_first);
    if (status != BESSEMER_STATUS_OK) {
        return status;
    }
    int32_t result_fourth;
    status = parts_trace_i32_3(map, &result_fourth);
    if (status != BESSEMER_STATUS_OK) {
        return status;
    }
    result->first = result_first;
    result->second = matrix_extremes_max_i32_3_3(map);
    result->third = matrix_extremes_min_i32_3_3(map);
    result->fourth = result_fourth;
    return BESSEMER_STATUS_OK;
}

bessemer_status_t integer_matrices_edges(const uint16_t map[6],
    pair_matrix1x3_u16_vector2_u16_t *BESSEMER_RESTRICT result)
{
    bessemer_status_t status;
    uint16_t result_first[3];
    status = matrix_statistics_row_sum_u16_2_3(map, result_first);
    if (status != BESSEMER_STATUS_OK) {
        return status;
    }
    uint16_t result_second[2];
    status = matrix_statistics_column_sum_u16_2_3(map, result_second);
    if (status != BESSEMER_STATUS_OK) {
        return status;
    }
    result->first[0] = result_first[0];
    result->first[1] = result_first[1];
    result->first[2] = result_first[2];
    result->second[0] = result_second[0];
    result->second[1] = result_second[1];
    return BESSEMER_STATUS_OK;
}

bessemer_status_t integer_matrices_flagged(bool flags[BESSEMER_RESTRICT 4],
    bool before[BESSEMER_RESTRICT 4])
{
    bessemer_status_t status;
    const pair_usize_usize_t one = {.first = UINT64_C(0), .second = UINT64_C(0)};
    const pair_usize_usize_t other = {.first = UINT64_C(1), .second = UINT64_C(1)};
    status = matrix_edit_swap_bool_2_2(flags, &one, &other);
    if (status != BESSEMER_STATUS_OK) {
        return status;
    }
    const bool before_value[4] = {flags[0], flags[1], flags[2], flags[3]};
    matrix_edit_fill_diagonal_bool_2_2(flags, true);
    before[0] = before_value[0];
    before[1] = before_value[1];
    before[2] = before_value[2];
    before[3] = before_value[3];
    return BESSEMER_STATUS_OK;
}
