/* The C of tests/corpus/src/programs/matrices/unscented.rs. Written by a test. */

/* located.c */

static void located_unscented_in_drive(const double mean[3], const symmetric_f64_3_t *covariance,
    double spread, double distance, double turn,
    option_transformed_f64_3_3_t *BESSEMER_RESTRICT result);
static void located_unscented_in_measure(const double mean[3], const symmetric_f64_3_t *covariance,
    double spread, option_transformed_f64_3_2_t *BESSEMER_RESTRICT result);

void located_init(located_t *self)
{
    self->pose.place[0] = 2.0;
    self->pose.place[1] = 3.0;
    self->pose.heading = 0.0;

    /* In Rust: `Symmetric::diagonal(&Vector3::new(1.0, 1.0, 0.1))`. */
    for (uint32_t i = 0U; i < 9U; i++) {
        self->covariance.elements[i] = 0.0;
    }
    self->covariance.elements[0 + 3 * 0] = 1.0;
    self->covariance.elements[1 + 3 * 1] = 1.0;
    self->covariance.elements[2 + 3 * 2] = 0.1;
}

bool located_drive(located_t *self, double distance, double turn)
{
    double moved_mean[3];
    pose_vector(&self->pose, moved_mean);
    option_transformed_f64_3_3_t moved;
    located_unscented_in_drive(moved_mean, &self->covariance, 3.0, distance, turn, &moved);
    if (moved.is_some) {
        const transformed_f64_3_3_t *const next = &moved.value;
        pose_of_vector(next->mean, &self->pose);
        self->covariance = next->covariance;
        const double values[3] = {0.0001, 0.0001, 1e-5};
        symmetric_f64_3_add_diagonal(&self->covariance, values);
        return true;
    } else {
        return false;
    }
}

/**
 * Returns the distribution of `law` of numbers with this mean and covariance; none unless the covariance is positive
 * definite and the spread positive.
 */
static void located_unscented_in_drive(const double mean[3], const symmetric_f64_3_t *covariance,
    double spread, double distance, double turn,
    option_transformed_f64_3_3_t *BESSEMER_RESTRICT result)
{
    option_matrix3x3_f64_t factor_option;
    symmetric_f64_3_root(covariance, &factor_option);
    if (!factor_option.is_some) {
        static const option_transformed_f64_3_3_t unscented_in_drive = {.is_some = false};
        *result = unscented_in_drive;
        return;
    }
    const double *const factor = factor_option.value;
    if (!(spread > 0.0)) {
        static const option_transformed_f64_3_3_t unscented_in_drive = {.is_some = false};
        *result = unscented_in_drive;
        return;
    }
    const double width = sqrt(spread);
    const double weight = 1.0 / (spread + spread);
    double center[3];
    unscented_driven(mean, distance, turn, center);

    /*
     * Half the sum and half the difference of the results at the two points of each column, the sum less that at the
     * mean.
     */
    double even[9];
    double odd[9];
    double offset[3] = {0.0, 0.0, 0.0};
    for (uint32_t n = 0U; n < 3U; n++) {
        const double step[3] = {
            factor[0U + 3U * n] * width,
            factor[1U + 3U * n] * width,
            factor[2U + 3U * n] * width
        };
        const double ahead_pose[3] = {mean[0] + step[0], mean[1] + step[1], mean[2] + step[2]};
        double ahead_driven[3];
        unscented_driven(ahead_pose, distance, turn, ahead_driven);
        const double ahead[3] = {
            ahead_driven[0] - center[0],
            ahead_driven[1] - center[1],
            ahead_driven[2] - center[2]
        };
        const double behind_pose[3] = {mean[0] - step[0], mean[1] - step[1], mean[2] - step[2]};
        double behind_driven[3];
        unscented_driven(behind_pose, distance, turn, behind_driven);
        const double behind[3] = {
            behind_driven[0] - center[0],
            behind_driven[1] - center[1],
            behind_driven[2] - center[2]
        };
        for (uint32_t m = 0U; m < 3U; m++) {
            even[m + 3U * n] = ahead[m] + behind[m];
            odd[m + 3U * n] = ahead[m] - behind[m];
            offset[m] += weight * even[m + 3U * n];
        }
    }

    /*
     * Σ wᵢ (yᵢ − ȳ)(yᵢ − ȳ)ᵀ: the pairs' squares are (e eᵀ + o oᵀ)/2, and the weights' sum is one.
     */
    const double half = weight * 0.5;
    const double spreads_values[3] = {0.0, 0.0, 0.0};
    symmetric_f64_3_diagonal(spreads_values, &result->value.covariance);
    for (uint32_t row = 0U; row < 3U; row++) {
        for (uint32_t col = 0U; col <= row; col++) {
            double sum = 0.0;
            for (uint32_t n = 0U; n < 3U; n++) {
                sum += even[row + 3U * n] * even[col + 3U * n]
                    + odd[row + 3U * n] * odd[col + 3U * n];
            }
            const double value = half * sum - offset[row] * offset[col];
            result->value.covariance.elements[row + 3U * col] = value;
            result->value.covariance.elements[col + 3U * row] = value;
        }
    }
    for (uint32_t i = 0U; i < 9U; i++) {
        result->value.cross[i] = 0.0;
    }
    for (uint32_t n = 0U; n < 3U; n++) {
        for (uint32_t m = 0U; m < 3U; m++) {
            const double slope = weight * width * odd[m + 3U * n];
            for (uint32_t row = n; row < 3U; row++) {
                result->value.cross[row + 3U * m] += factor[row + 3U * n] * slope;
            }
        }
    }
    result->value.mean[0] = center[0] + offset[0];
    result->value.mean[1] = center[1] + offset[1];
    result->value.mean[2] = center[2] + offset[2];
    result->is_some = true;
}

void located_measure(located_t *BESSEMER_RESTRICT self, const double measured[2],
    correction_f64_t *BESSEMER_RESTRICT correction)
{
    double pose[3];
    pose_vector(&self->pose, pose);
    option_transformed_f64_3_2_t expected;
    located_unscented_in_measure(pose, &self->covariance, 3.0, &expected);
    if (expected.is_some) {
        const double noise_values[2] = {0.01, 0.01};
        symmetric_f64_2_t noise;
        symmetric_f64_2_diagonal(noise_values, &noise);
        correction_f64_t report;
        symmetric_f64_3_correct_unscented_2(&self->covariance, pose, &expected.value, measured,
            &noise, 30.0, &report);
        pose_of_vector(pose, &self->pose);
        *correction = report;
    } else {
        correction->surprise = 0.0;
        correction->status = CORRECT_STATUS_LOST;
    }
}

/**
 * Returns the distribution of `law` of numbers with this mean and covariance; none unless the covariance is positive
 * definite and the spread positive.
 */
static void located_unscented_in_measure(const double mean[3], const symmetric_f64_3_t *covariance,
    double spread, option_transformed_f64_3_2_t *BESSEMER_RESTRICT result)
{
    option_matrix3x3_f64_t factor_option;
    symmetric_f64_3_root(covariance, &factor_option);
    if (!factor_option.is_some) {
        *result = (option_transformed_f64_3_2_t){.is_some = false};
        return;
    }
    const double *const factor = factor_option.value;
    if (!(spread > 0.0)) {
        *result = (option_transformed_f64_3_2_t){.is_some = false};
        return;
    }
    const double width = sqrt(spread);
    const double weight = 1.0 / (spread + spread);
    double center[2];
    unscented_distances(mean, center);

    /*
     * Half the sum and half the difference of the results at the two points of each column, the sum less that at the
     * mean.
     */
    double even[6];
    double odd[6];
    double offset[2] = {0.0, 0.0};
    for (uint32_t n = 0U; n < 3U; n++) {
        const double step[3] = {
            factor[0U + 3U * n] * width,
            factor[1U + 3U * n] * width,
            factor[2U + 3U * n] * width
        };
        const double ahead_pose[3] = {mean[0] + step[0], mean[1] + step[1], mean[2] + step[2]};
        double ahead_distances[2];
        unscented_distances(ahead_pose, ahead_distances);
        const double ahead[2] = {ahead_distances[0] - center[0], ahead_distances[1] - center[1]};
        const double behind_pose[3] = {mean[0] - step[0], mean[1] - step[1], mean[2] - step[2]};
        double behind_distances[2];
        unscented_distances(behind_pose, behind_distances);
        const double behind[2] = {behind_distances[0] - center[0], behind_distances[1] - center[1]};
        for (uint32_t m = 0U; m < 2U; m++) {
            even[m + 2U * n] = ahead[m] + behind[m];
            odd[m + 2U * n] = ahead[m] - behind[m];
            offset[m] += weight * even[m + 2U * n];
        }
    }

    /*
     * Σ wᵢ (yᵢ − ȳ)(yᵢ − ȳ)ᵀ: the pairs' squares are (e eᵀ + o oᵀ)/2, and the weights' sum is one.
     */
    const double half = weight * 0.5;
    const double spreads_values[2] = {0.0, 0.0};
    symmetric_f64_2_diagonal(spreads_values, &result->value.covariance);
    for (uint32_t row = 0U; row < 2U; row++) {
        for (uint32_t col = 0U; col <= row; col++) {
            double sum = 0.0;
            for (uint32_t n = 0U; n < 3U; n++) {
                sum += even[row + 2U * n] * even[col + 2U * n]
                    + odd[row + 2U * n] * odd[col + 2U * n];
            }
            const double value = half * sum - offset[row] * offset[col];
            result->value.covariance.elements[row + 2U * col] = value;
            result->value.covariance.elements[col + 2U * row] = value;
        }
    }
    for (uint32_t i = 0U; i < 6U; i++) {
        result->value.cross[i] = 0.0;
    }
    for (uint32_t n = 0U; n < 3U; n++) {
        for (uint32_t m = 0U; m < 2U; m++) {
            const double slope = weight * width * odd[m + 2U * n];
            for (uint32_t row = n; row < 3U; row++) {
                result->value.cross[row + 3U * m] += factor[row + 3U * n] * slope;
            }
        }
    }
    result->value.mean[0] = center[0] + offset[0];
    result->value.mean[1] = center[1] + offset[1];
    result->is_some = true;
}

/* located.h */

/** An unscented filter. */
typedef struct {
    /** Pose. */
    pose_t pose;
    /** Covariance of its errors. */
    symmetric_f64_3_t covariance;
} located_t;

/* located_by_root.c */

static bool located_by_root_predict_unscented_in_step(rooted_f64_3_t *BESSEMER_RESTRICT self,
    double state[BESSEMER_RESTRICT 3], double spread, const double deviations[3], double distance,
    double turn);
static void located_by_root_correct_unscented_in_step(rooted_f64_3_t *BESSEMER_RESTRICT self,
    double state[BESSEMER_RESTRICT 3], double spread, double measured, double variance,
    double gate, correction_f64_t *BESSEMER_RESTRICT correction);

void located_by_root_init(located_by_root_t *self)
{
    self->pose[0] = 2.0;
    self->pose[1] = 3.0;
    self->pose[2] = 0.0;

    /* In Rust: `Rooted::diagonal(&Vector3::new(1.0, 1.0, 0.3))`. */
    for (uint32_t i = 0U; i < 9U; i++) {
        self->root.factor[i] = 0.0;
    }
    self->root.factor[0 + 3 * 0] = 1.0;
    self->root.factor[1 + 3 * 1] = 1.0;
    self->root.factor[2 + 3 * 2] = 0.3;
}

void located_by_root_step(located_by_root_t *BESSEMER_RESTRICT self, double distance, double turn,
    double measured, correction_f64_t *BESSEMER_RESTRICT correction)
{
    const double noise[3] = {0.01, 0.01, 0.003};
    (void)located_by_root_predict_unscented_in_step(&self->root, self->pose, 3.0, noise, distance,
        turn);
    located_by_root_correct_unscented_in_step(&self->root, self->pose, 3.0, measured, 0.01, 30.0,
        correction);
}

/**
 * Moves a state and this covariance by a step without a derivative, with the points of
 * `unscented` and independent noise of these standard deviations. Returns false, and changes
 * nothing, if `spread` is less than N.
 */
static bool located_by_root_predict_unscented_in_step(rooted_f64_3_t *BESSEMER_RESTRICT self,
    double state[BESSEMER_RESTRICT 3], double spread, const double deviations[3], double distance,
    double turn)
{
    const double size = 3.0;
    if (!(spread >= size && isfinite(spread) != 0)) {
        return false;
    }
    const double width = sqrt(spread);
    const double weight = 1.0 / (spread + spread);
    double center[3];
    unscented_driven(state, distance, turn, center);
    double ahead[9];
    double behind[9];
    double offset[3] = {0.0, 0.0, 0.0};
    for (uint32_t n = 0U; n < 3U; n++) {
        const double step[3] = {
            self->factor[0U + 3U * n] * width,
            self->factor[1U + 3U * n] * width,
            self->factor[2U + 3U * n] * width
        };
        const double after_pose[3] = {state[0] + step[0], state[1] + step[1], state[2] + step[2]};
        double after[3];
        unscented_driven(after_pose, distance, turn, after);
        const double before_pose[3] = {state[0] - step[0], state[1] - step[1], state[2] - step[2]};
        double before[3];
        unscented_driven(before_pose, distance, turn, before);
        const double part[3] = {after[0] - center[0], after[1] - center[1], after[2] - center[2]};
        for (uint32_t row = 0U; row < 3U; row++) {
            ahead[row + 3U * n] = part[row];
        }
        const double part_2[3] = {
            before[0] - center[0],
            before[1] - center[1],
            before[2] - center[2]
        };
        for (uint32_t row = 0U; row < 3U; row++) {
            behind[row + 3U * n] = part_2[row];
        }
        offset[0] += (ahead[0U + 3U * n] + behind[0U + 3U * n]) * weight;
        offset[1] += (ahead[1U + 3U * n] + behind[1U + 3U * n]) * weight;
        offset[2] += (ahead[2U + 3U * n] + behind[2U + 3U * n]) * weight;
    }
    const double share = sqrt(weight);
    rooted_f64_3_t rooted_f64_3;
    rooted_f64_3_diagonal(deviations, &rooted_f64_3);
    (void)memcpy(self->factor, rooted_f64_3.factor, sizeof(double[9]));
    for (uint32_t n = 0U; n < 3U; n++) {
        const double after[3] = {
            (ahead[0U + 3U * n] - offset[0]) * share,
            (ahead[1U + 3U * n] - offset[1]) * share,
            (ahead[2U + 3U * n] - offset[2]) * share
        };
        const double before[3] = {
            (behind[0U + 3U * n] - offset[0]) * share,
            (behind[1U + 3U * n] - offset[1]) * share,
            (behind[2U + 3U * n] - offset[2]) * share
        };
        rooted_f64_3_add(self, after);
        rooted_f64_3_add(self, before);
    }
    const double root = sqrt(1.0 - size / spread);
    const double vector[3] = {offset[0] * root, offset[1] * root, offset[2] * root};
    rooted_f64_3_add(self, vector);
    state[0] = center[0] + offset[0];
    state[1] = center[1] + offset[1];
    state[2] = center[2] + offset[2];
    return true;
}

/**
 * Corrects a state by one number that `law` expects, with the points of `unscented`. Several
 * independent numbers are corrected one by one.
 */
static void located_by_root_correct_unscented_in_step(rooted_f64_3_t *BESSEMER_RESTRICT self,
    double state[BESSEMER_RESTRICT 3], double spread, double measured, double variance,
    double gate, correction_f64_t *BESSEMER_RESTRICT correction)
{
    if (!(spread > 0.0 && variance > 0.0)) {
        correction->surprise = 0.0;
        correction->status = CORRECT_STATUS_LOST;
        return;
    }
    const double width = sqrt(spread);
    const double weight = 1.0 / (spread + spread);
    double vector[2];
    unscented_distances(state, vector);
    const double center = vector[0];
    double offset = 0.0;
    double squares = 0.0;
    double slopes[3];
    for (uint32_t n = 0U; n < 3U; n++) {
        const double step[3] = {
            self->factor[0U + 3U * n] * width,
            self->factor[1U + 3U * n] * width,
            self->factor[2U + 3U * n] * width
        };
        const double vector_pose[3] = {state[0] + step[0], state[1] + step[1], state[2] + step[2]};
        double vector_2[2];
        unscented_distances(vector_pose, vector_2);
        const double ahead = vector_2[0] - center;
        const double vector_pose_2[3] = {
            state[0] - step[0],
            state[1] - step[1],
            state[2] - step[2]
        };
        double vector_3[2];
        unscented_distances(vector_pose_2, vector_3);
        const double behind = vector_3[0] - center;
        offset += weight * (ahead + behind);
        squares += weight * (ahead * ahead + behind * behind);
        slopes[n] = weight * width * (ahead - behind);
    }
    const double expected = squares - offset * offset + variance;
    if (!(expected > 0.0 && isfinite(expected) != 0)) {
        correction->surprise = 0.0;
        correction->status = CORRECT_STATUS_LOST;
        return;
    }
    const double innovation = measured - (center + offset);
    const double surprise = innovation * innovation / expected;
    if (!(surprise <= gate)) {
        correction->surprise = surprise;
        correction->status = CORRECT_STATUS_REJECTED;
        return;
    }
    const double length = sqrt(expected);
    const double step_product[3] = {
        self->factor[0 + 3 * 0] * slopes[0] + self->factor[0 + 3 * 1] * slopes[1]
            + self->factor[0 + 3 * 2] * slopes[2],
        self->factor[1 + 3 * 0] * slopes[0] + self->factor[1 + 3 * 1] * slopes[1]
            + self->factor[1 + 3 * 2] * slopes[2],
        self->factor[2 + 3 * 0] * slopes[0] + self->factor[2 + 3 * 1] * slopes[1]
            + self->factor[2 + 3 * 2] * slopes[2]
    };
    const double step[3] = {
        step_product[0] / length,
        step_product[1] / length,
        step_product[2] / length
    };
    if (!rooted_f64_3_remove(self, step)) {
        correction->surprise = surprise;
        correction->status = CORRECT_STATUS_LOST;
        return;
    }
    const double state_quotient = innovation / length;
    state[0] += step[0] * state_quotient;
    state[1] += step[1] * state_quotient;
    state[2] += step[2] * state_quotient;
    correction->surprise = surprise;
    correction->status = CORRECT_STATUS_CORRECTED;
}

void located_by_root_head(located_by_root_t *BESSEMER_RESTRICT self, double innovation, double jump,
    double result[BESSEMER_RESTRICT 9])
{
    const double row[3] = {0.0, 0.0, 1.0};
    correction_f64_t report;
    rooted_f64_3_correct(&self->root, self->pose, row, innovation, 0.01, 9.0, &report);
    if (report.status == CORRECT_STATUS_CORRECTED) {
        const double vector[3] = {jump, 0.0, 0.0};
        rooted_f64_3_add(&self->root, vector);
    }
    symmetric_f64_3_t self_2;
    rooted_f64_3_covariance(&self->root, &self_2);
    (void)memcpy(result, self_2.elements, sizeof(double[9]));
}

/* located_by_root.h */

/** An unscented filter by the root of its covariance. */
typedef struct {
    /** Place, m, and heading, rad. */
    double pose[3];
    /** Root of the covariance of their errors. */
    rooted_f64_3_t root;
} located_by_root_t;

/* unscented.c */

static const double BEACONS[2][2] = {{0.0, 0.0}, {10.0, 0.0}};

void pose_difference(const pose_t *self, const pose_t *from, double errors[BESSEMER_RESTRICT 3])
{
    for (uint32_t n = 0U; n < 2U; n++) {
        errors[UNSCENTED_POSE_PLACE + n] = self->place[n] - from->place[n];
    }
    errors[UNSCENTED_POSE_HEADING] = self->heading - from->heading;
}

void pose_of_vector(const double vector[3], pose_t *BESSEMER_RESTRICT pose)
{
    pose->place[0] = vector[UNSCENTED_POSE_PLACE];
    pose->place[1] = vector[UNSCENTED_POSE_PLACE + 1U];
    pose->heading = vector[UNSCENTED_POSE_HEADING];
}

void pose_retracted(const pose_t *self, const double errors[3], pose_t *BESSEMER_RESTRICT moved)
{
    *moved = *self;
    for (uint32_t n = 0U; n < 2U; n++) {
        moved->place[n] += errors[UNSCENTED_POSE_PLACE + n];
    }
    moved->heading += errors[UNSCENTED_POSE_HEADING];
}

void pose_vector(const pose_t *self, double vector[BESSEMER_RESTRICT 3])
{
    for (uint32_t n = 0U; n < 2U; n++) {
        vector[UNSCENTED_POSE_PLACE + n] = self->place[n];
    }
    vector[UNSCENTED_POSE_HEADING] = self->heading;
}

void unscented_driven(const double pose[3], double distance, double turn,
    double result[BESSEMER_RESTRICT 3])
{
    pair_f64_f64_t sine_cosine;
    sine_sin_cos(pose[2] + 0.5 * turn, &sine_cosine);
    result[0] = pose[0] + distance * sine_cosine.second;
    result[1] = pose[1] + distance * sine_cosine.first;
    result[2] = pose[2] + turn;
}

void unscented_distances(const double pose[3], double distances[BESSEMER_RESTRICT 2])
{
    for (uint32_t n = 0U; n < 2U; n++) {
        const double x = pose[0] - BEACONS[n][0];
        const double y = pose[1] - BEACONS[n][1];
        distances[n] = sqrt(x * x + y * y);
    }
}

/* unscented.h */

/** Place, m, and heading, rad, of a vehicle. */
typedef struct {
    /** Place in the plane, m. */
    double place[2];
    /** Heading from the first axis, rad. */
    double heading;
} pose_t;
