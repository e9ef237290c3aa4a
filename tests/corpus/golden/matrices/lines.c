/* The C of tests/corpus/src/programs/matrices/lines.rs. Written by a test. */

/* lines.c */

void lines_read(const double m[12], const double w[4],
    tuple4_f64_f64_f64_option_usize_t *BESSEMER_RESTRICT result)
{
    double far_ = 0.0;
    uint32_t left = 1U;
    for (uint32_t i = 0U; i < 4U; i++) {
        const double c[3] = {m[0U + 3U * i], m[1U + 3U * i], m[2U + 3U * i]};
        if (left > 0U) {
            left -= 1U;
        } else {
            far_ = max_f64(far_, sqrt(c[0] * c[0] + c[1] * c[1] + c[2] * c[2]) * w[i]);
        }
    }
    double zipped = -0.0;
    uint32_t others_taken = 0U;
    for (uint32_t column = 0U; column < 4U; column++) {
        const double c[3] = {m[0U + 3U * column], m[1U + 3U * column], m[2U + 3U * column]};
        option_f64_t other = {.is_some = false};
        if (others_taken < 4U) {
            const uint32_t index = others_taken;
            others_taken = index + 1U;
            other.is_some = true;
            other.value = w[index];
        }
        if (!other.is_some) {
            break;
        }
        zipped += matrix_statistics_sum_f64_3_1(c) * other.value;
    }
    double both = -0.0;
    uint32_t left_2 = 1U;
    for (uint32_t row = 0U; row < 3U; row++) {
        const double row_2[4] = {
            m[row + 3U * 0U], m[row + 3U * 1U], m[row + 3U * 2U], m[row + 3U * 3U]
        };
        if (left_2 > 0U) {
            left_2 -= 1U;
        } else {
            both += row_2[0];
        }
    }
    for (uint32_t row = 0U; row < 3U; row++) {
        const double row_2[4] = {
            m[row + 3U * 0U], m[row + 3U * 1U], m[row + 3U * 2U], m[row + 3U * 3U]
        };
        both += row_2[0];
    }
    option_pair_usize_vector3_f64_t find = {.is_some = false};
    for (uint32_t column = 4U; column-- > 0U;) {
        const double c[3] = {m[0U + 3U * column], m[1U + 3U * column], m[2U + 3U * column]};
        if (c[0] > 1.0) {
            find.is_some = true;
            find.value.first = column;
            find.value.second[0] = c[0];
            find.value.second[1] = c[1];
            find.value.second[2] = c[2];
            break;
        }
    }
    if (find.is_some) {
        result->fourth.is_some = true;
        result->fourth.value = find.value.first;
    } else {
        result->fourth = (option_usize_t){.is_some = false};
    }
    result->first = far_;
    result->second = zipped;
    result->third = both;
}

void lines_written(double m[BESSEMER_RESTRICT 12], const double w[4])
{
    uint32_t others_taken = 0U;
    for (uint32_t column = 0U; column < 4U; column++) {
        option_f64_t other = {.is_some = false};
        if (others_taken < 4U) {
            const uint32_t index = others_taken;
            others_taken = index + 1U;
            other.is_some = true;
            other.value = w[index];
        }
        if (!other.is_some) {
            break;
        }
        double column_2[3] = {m[0U + 3U * column], m[1U + 3U * column], m[2U + 3U * column]};
        column_2[0] *= other.value;
        column_2[1] *= other.value;
        column_2[2] *= other.value;
        for (uint32_t row = 0U; row < 3U; row++) {
            m[row + 3U * column] = column_2[row];
        }
        if (m[0U + 3U * column] > 5.0) {
            break;
        }
    }
    for (uint32_t i = 0U; i < 3U; i++) {
        m[i + 3U * i] = 1.0;
    }
    const double elements[2] = {1.0, 2.0};
    uint32_t others_taken_2 = 0U;
    for (uint32_t row = 0U; row < 3U; row++) {
        option_f64_t other = {.is_some = false};
        if (others_taken_2 < 2U) {
            const uint32_t index = others_taken_2;
            others_taken_2 = index + 1U;
            other.is_some = true;
            other.value = elements[index];
        }
        if (!other.is_some) {
            break;
        }
        for (uint32_t column = 0U; column < 4U; column++) {
            m[row + 3U * column] = other.value;
        }
    }
}

void lines_extremes(const float m[12], pair_option_usize_option_f32_t *BESSEMER_RESTRICT result)
{
    option_pair_usize_f32_t found = {.is_some = false};
    for (uint32_t column = 0U; column < 4U; column++) {
        const float column_2[3] = {m[0U + 3U * column], m[1U + 3U * column], m[2U + 3U * column]};
        if (found.is_some) {
            const pair_usize_f32_t b = {.first = column, .second = column_2[0]};
            if (!sort_below_f32(b.second, found.value.second)) {
                found.is_some = true;
                found.value.first = column;
                found.value.second = column_2[0];
            }
        } else {
            found.is_some = true;
            found.value.first = column;
            found.value.second = column_2[0];
        }
    }
    if (found.is_some) {
        result->first.is_some = true;
        result->first.value = found.value.first;
    } else {
        result->first = (option_usize_t){.is_some = false};
    }
    result->second = (option_f32_t){.is_some = false};
    for (uint32_t row = 0U; row < 3U; row++) {
        const float row_2[4] = {
            m[row + 3U * 0U], m[row + 3U * 1U], m[row + 3U * 2U], m[row + 3U * 3U]
        };
        const float value = sqrtf(norm_squared_f32(row_2, 1U, 4U));
        if (result->second.is_some) {
            if (sort_below_f32(value, result->second.value)) {
                result->second.is_some = true;
                result->second.value = value;
            }
        } else {
            result->second.is_some = true;
            result->second.value = value;
        }
    }
}

void lines_other_names(double a[BESSEMER_RESTRICT 16], const double b[4],
    option_f64_t *BESSEMER_RESTRICT result)
{
    double first[4] = {a[0 + 4 * 0], a[1 + 4 * 0], a[2 + 4 * 0], a[3 + 4 * 0]};
    first[0] += b[0];
    first[1] += b[1];
    first[2] += b[2];
    first[3] += b[3];
    for (uint32_t row = 0U; row < 4U; row++) {
        a[row + 4U * 0U] = first[row];
    }
    double other[4] = {a[0 + 4 * 0], a[1 + 4 * 0], a[2 + 4 * 0], a[3 + 4 * 0]};
    other[0] += b[0];
    other[1] += b[1];
    other[2] += b[2];
    other[3] += b[3];
    for (uint32_t row = 0U; row < 4U; row++) {
        a[row + 4U * 0U] = other[row];
    }
    if (b[0] > 0.0) {
        double second[4] = {a[0 + 4 * 1], a[1 + 4 * 1], a[2 + 4 * 1], a[3 + 4 * 1]};
        second[0] += b[0];
        second[1] += b[1];
        second[2] += b[2];
        second[3] += b[3];
        for (uint32_t row = 0U; row < 4U; row++) {
            a[row + 4U * 1U] = second[row];
        }
    } else {
        matrix_edit_fill_f64_4_4(a, 0.0);
    }
    if (b[1] > 0.0) {
        option_f64_t third_choice;
        const option_f64_t third_option = {.is_some = true, .value = b[1]};
        if (third_option.value > 1.0) {
            third_choice.is_some = true;
            third_choice.value = third_option.value;
        } else {
            third_choice = (option_f64_t){.is_some = false};
        }
        if (!third_choice.is_some) {
            *result = (option_f64_t){.is_some = false};
            return;
        }
        a[2 + 4 * 0] = third_choice.value;
        for (uint32_t i = 1U; i < 4U; i++) {
            a[2U + 4U * i] *= 0.5;
        }
    }
    result->is_some = true;
    result->value = b[2];
}

bessemer_status_t lines_parts_of_parts(double m[BESSEMER_RESTRICT 36], uint64_t at, double by,
    double *BESSEMER_RESTRICT result)
{
    if (at > UINT64_C(0xFFFFFFFFFFFFFFFB)) {
        return BESSEMER_STATUS_OVERFLOW;
    }
    if (at + UINT64_C(4) > UINT64_C(6)) {
        return BESSEMER_STATUS_INDEX;
    }
    double line[4] = {
        m[2U + 6U * at], m[2U + 6U * (at + UINT64_C(1))], m[2U + 6U * (at + UINT64_C(2))],
        m[2U + 6U * (at + UINT64_C(3))]
    };
    double line_elements[4];
    line_elements[0] = by;
    line_elements[1] = by;
    line_elements[2] = by;
    line_elements[3] = by;
    line[0] += line_elements[0];
    line[1] += line_elements[1];
    line[2] += line_elements[2];
    line[3] += line_elements[3];
    for (uint32_t column = 0U; column < 4U; column++) {
        m[2U + 6U * (at + column)] = line[column];
    }
    for (uint32_t row = 0U; row < 3U; row++) {
        m[row + 1U + 6U * (at + at)] = by;
    }
    for (uint32_t i = 0U; i < 12U; i++) {
        m[(i % 3U) + 1U + 6U * (at + u64_from_u32(i / 3U))] -= (double)i;
        if (m[(i % 3U) + 1U + 6U * (at + u64_from_u32(i / 3U))] > 1000.0) {
            *result = by;
            return BESSEMER_STATUS_OK;
        }
    }
    const double block_operand = m[3U + 6U * (at + UINT64_C(3))];
    m[2U + 6U * (at + UINT64_C(2))] = block_operand;
    double large[30];
    for (uint32_t column = 0U; column < 6U; column++) {
        for (uint32_t row = 0U; row < 5U; row++) {
            large[row + 5U * column] = m[row + 1U + 6U * column];
        }
    }
    for (uint32_t i = 0U; i < 30U; i++) {
        large[i] *= 0.5;
    }
    for (uint32_t column = 0U; column < 6U; column++) {
        for (uint32_t row = 0U; row < 5U; row++) {
            m[row + 1U + 6U * column] = large[row + 5U * column];
        }
    }
    double part[30];
    for (uint32_t column = 0U; column < 6U; column++) {
        for (uint32_t row = 0U; row < 5U; row++) {
            part[row + 5U * column] = m[row + 1U + 6U * column];
        }
    }
    const double result_given = norms_normalize_mut_f64_5_6(part);
    for (uint32_t column = 0U; column < 6U; column++) {
        for (uint32_t row = 0U; row < 5U; row++) {
            m[row + 1U + 6U * column] = part[row + 5U * column];
        }
    }
    *result = result_given;
    return BESSEMER_STATUS_OK;
}
