/* The C of tests/corpus/src/programs/data/variable_sizes.rs. Written by a test. */

/* variable_sizes.c */

bessemer_status_t variable_sizes_seen(scan_t *BESSEMER_RESTRICT scan, const float point[3],
    const uint8_t hits[2])
{
    bessemer_status_t status;
    if (scan->ranges.length >= UINT64_C(5)) {
        return BESSEMER_STATUS_CAPACITY;
    }
    scan->ranges.items[scan->ranges.length] = sqrtf(
        point[0] * point[0] + point[1] * point[1] + point[2] * point[2]);
    scan->ranges.length += UINT64_C(1);
    if (scan->points.length >= UINT64_C(4)) {
        return BESSEMER_STATUS_CAPACITY;
    }
    scan->points.items[scan->points.length][0] = point[0];
    scan->points.items[scan->points.length][1] = point[1];
    scan->points.items[scan->points.length][2] = point[2];
    scan->points.length += UINT64_C(1);
    const uint64_t value_end = bounded_matrix_u8_2_3_nrows(&scan->hits);
    status = bounded_matrix_u8_2_3_push_column(&scan->hits, hits, value_end);
    if (status != BESSEMER_STATUS_OK) {
        return status;
    }
    return BESSEMER_STATUS_OK;
}

void variable_sizes_middle(const scan_t *scan, float result[BESSEMER_RESTRICT 3])
{
    float sum[3] = {0.0F, 0.0F, 0.0F};
    {
        const uint32_t end = (uint32_t)min_u64(scan->points.length, UINT64_C(4));
        for (uint32_t i = 0U; i < end; i++) {
            sum[0] += scan->points.items[i][0];
            sum[1] += scan->points.items[i][1];
            sum[2] += scan->points.items[i][2];
        }
    }
    const float result_larger = (float)max_u64(scan->points.length, UINT64_C(1));
    result[0] = sum[0] / result_larger;
    result[1] = sum[1] / result_larger;
    result[2] = sum[2] / result_larger;
}

bessemer_status_t variable_sizes_strong(const scan_t *scan, uint8_t level,
    uint32_t *BESSEMER_RESTRICT count)
{
    uint32_t count_value = 0U;
    const uint64_t column_end = bounded_matrix_u8_2_3_ncols(&scan->hits);
    for (uint64_t column = UINT64_C(0); column < column_end; column++) {
        const uint64_t row_end = bounded_matrix_u8_2_3_nrows(&scan->hits);
        for (uint64_t row = UINT64_C(0); row < row_end; row++) {
            if (scan->hits.rows > UINT64_C(2) || scan->hits.columns > UINT64_C(3)
                    || row >= scan->hits.rows || column >= scan->hits.columns) {
                return BESSEMER_STATUS_INDEX;
            }
            if (scan->hits.elements[column][row] > level) {
                count_value += 1U;
            }
        }
    }
    *count = count_value;
    return BESSEMER_STATUS_OK;
}

/* variable_sizes.h */

/** Hits of a scanner. */
typedef struct {
    /** At most five ranges. */
    list5_f32_t ranges;
    /** At most four points of three coordinates. */
    list4_vector3_f32_t points;
    /** A matrix of at most two by three. */
    bounded_matrix_u8_2_3_t hits;
    /** A matrix of two by three. A matrix by columns: [row + 2 * column]. */
    float grid[6];
} scan_t;
