/* The C of tests/corpus/src/programs/matrices/covariances.rs. Written by a test. */

/* climb.c */

void climb_init(climb_t *self)
{
    self->state[0] = 0.0;
    self->state[1] = 0.0;
    self->covariance.elements[0] = 4.0;
    self->covariance.elements[1] = 0.0;
    self->covariance.elements[2] = 0.0;
    self->covariance.elements[3] = 1.0;
    self->fault = BESSEMER_STATUS_OK;
}

void climb_predict(climb_t *self, double acceleration, double period)
{
    const double jacobian[4] = {
        1.0, 0.0,
        period, 1.0
    };
    const double state_product[2] = {
        jacobian[0 + 2 * 0] * self->state[0] + jacobian[0 + 2 * 1] * self->state[1],
        jacobian[1 + 2 * 0] * self->state[0] + jacobian[1 + 2 * 1] * self->state[1]
    };
    const double state_product_2 = acceleration * period;
    self->state[0] = state_product[0] + 0.5 * period * state_product_2;
    self->state[1] = state_product[1] + 1.0 * state_product_2;
    symmetric_f64_2_congruence(&self->covariance, jacobian);
    const double values[2] = {0.0, 0.04 * period};
    symmetric_f64_2_add_diagonal(&self->covariance, values);
}

void climb_measure(climb_t *BESSEMER_RESTRICT self, double height, double variance,
    correction_f64_t *BESSEMER_RESTRICT correction)
{
    const double innovation = height - self->state[0];
    const double correction_row[2] = {1.0, 0.0};
    symmetric_f64_2_correct(&self->covariance, self->state, correction_row, innovation, variance,
        9.0, correction);
}

bessemer_status_t climb_measure_both(climb_t *BESSEMER_RESTRICT self, const double measured[2],
    const double noise[2], correct_status_t *BESSEMER_RESTRICT status)
{
    if (self->fault != BESSEMER_STATUS_OK) {
        return self->fault;
    }
    const selection_2_2_t selection = {.indices = {UINT64_C(0), UINT64_C(1)}};
    double innovation_of_f64[2];
    selection_2_2_of_f64(&selection, self->state, innovation_of_f64);
    const double innovation[2] = {
        measured[0] - innovation_of_f64[0],
        measured[1] - innovation_of_f64[1]
    };
    symmetric_f64_2_t noise_2;
    symmetric_f64_2_diagonal(noise, &noise_2);
    const double jacobian[4] = {
        1.0, 0.0,
        0.0, 1.0
    };
    correction_f64_t correction;
    symmetric_f64_2_correct_jointly_2(&self->covariance, self->state, jacobian, innovation,
        &noise_2, 13.8, &correction);
    *status = correction.status;
    return BESSEMER_STATUS_OK;
}

/* climb.h */

/** Height, m, and climb, m/s, of an aircraft. */
typedef struct {
    /** Height and climb. */
    double state[2];
    /** Covariance of their errors. */
    symmetric_f64_2_t covariance;
    /** The fault that stopped the component; BESSEMER_STATUS_OK while it runs. */
    bessemer_status_t fault;
} climb_t;

/* covariances.c */

void covariances_by_factors(const double p[9], const double row[3], double innovation,
    triple_f64_vector3_f64_matrix3x3_f64_t *BESSEMER_RESTRICT result)
{
    double state[3] = {0.0, 0.0, 0.0};
    symmetric_f64_3_t factors_covariance;
    symmetric_f64_3_of_lower(p, &factors_covariance);
    option_factored_f64_3_t factors;
    factored_f64_3_of(&factors_covariance, &factors);
    if (factors.is_some) {
        factored_f64_3_t factors_2 = factors.value;
        correction_f64_t report;
        factored_f64_3_correct(&factors_2, state, row, innovation, 0.5, 16.0, &report);
        symmetric_f64_3_t self;
        factored_f64_3_covariance(&factors_2, &self);
        result->first = report.surprise;
        result->second[0] = state[0];
        result->second[1] = state[1];
        result->second[2] = state[2];
        (void)memcpy(result->third, self.elements, sizeof(double[9]));
    } else {
        result->first = -1.0;
        result->second[0] = state[0];
        result->second[1] = state[1];
        result->second[2] = state[2];
        (void)memcpy(result->third, p, sizeof(double[9]));
    }
}

void covariances_by_certain(const double p[9], const double row[3], double innovation,
    triple_status_vector3_f64_matrix3x3_f64_t *BESSEMER_RESTRICT result)
{
    result->second[0] = 0.0;
    result->second[1] = 0.0;
    result->second[2] = 0.0;
    symmetric_f64_3_t covariance;
    symmetric_f64_3_of_lower(p, &covariance);
    {
        correction_f64_t unused;
        symmetric_f64_3_correct_joseph(&covariance, result->second, row, innovation, 1e-12,
            1000000000.0, &unused);
    }
    const bool considered[3] = {false, false, true};
    correction_f64_t report;
    symmetric_f64_3_correct_considering(&covariance, result->second, considered, UINT64_C(1),
        innovation, 0.5, 16.0, &report);
    result->first = report.status;
    (void)memcpy(result->third, covariance.elements, sizeof(double[9]));
}

void covariances_by_part(const double p[16], const double innovation[2],
    triple_status_vector4_f64_matrix4x4_f64_t *BESSEMER_RESTRICT result)
{
    result->second[0] = 0.0;
    result->second[1] = 0.0;
    result->second[2] = 0.0;
    result->second[3] = 0.0;
    symmetric_f64_4_t covariance;
    symmetric_f64_4_of_lower(p, &covariance);
    const double variances[2] = {0.5, 0.25};
    correction_f64_t report;
    symmetric_f64_4_correct_part_2_2(&covariance, result->second, innovation, variances, 16.0,
        &report);
    result->first = report.status;
    (void)memcpy(result->third, covariance.elements, sizeof(double[16]));
}

void covariances_scaled(const float p[9], const float by[3], float result[BESSEMER_RESTRICT 4])
{
    const diagonal_f32_3_t scaled_self = {.values = {by[0], by[1], by[2]}};
    symmetric_f32_3_t scaled_matrix;
    symmetric_f32_3_of_lower(p, &scaled_matrix);
    symmetric_f32_3_t scaled;
    diagonal_f32_3_congruence(&scaled_self, &scaled_matrix, &scaled);
    const selection_2_3_t self_value = {.indices = {UINT64_C(2), UINT64_C(0)}};
    symmetric_f32_2_t self;
    selection_2_3_within_f32(&self_value, &scaled, &self);
    result[0] = self.elements[0];
    result[1] = self.elements[1];
    result[2] = self.elements[2];
    result[3] = self.elements[3];
}

void covariances_oscillator(double frequency, double period,
    pair_matrix2x2_f64_matrix2x2_f64_t *result)
{
    const double system[4] = {
        0.0, -frequency * frequency,
        1.0, 0.0
    };
    const double noise_values[2] = {0.0, 1.0};
    symmetric_f64_2_t noise;
    symmetric_f64_2_diagonal(noise_values, &noise);
    pair_matrix2x2_f64_symmetric_f64_2_t transition_added;
    continuous_discretized_2(system, &noise, period, UINT64_C(4), &transition_added);
    result->first[0] = transition_added.first[0];
    result->first[1] = transition_added.first[1];
    result->first[2] = transition_added.first[2];
    result->first[3] = transition_added.first[3];
    result->second[0] = transition_added.second.elements[0];
    result->second[1] = transition_added.second.elements[1];
    result->second[2] = transition_added.second.elements[2];
    result->second[3] = transition_added.second.elements[3];
}
