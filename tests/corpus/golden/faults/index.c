/* The C of tests/corpus/src/programs/faults/index.rs. Written by a test. */

/* corpus_programs_faults_index.c */

bessemer_status_t corpus_programs_faults_index_element(const double table[4], uint64_t at,
    double *BESSEMER_RESTRICT result)
{
    if (at >= UINT64_C(4)) {
        return BESSEMER_STATUS_INDEX;
    }
    *result = table[at];
    return BESSEMER_STATUS_OK;
}

double corpus_programs_faults_index_guarded(const double table[4], uint64_t at)
{
    if (at < UINT64_C(4)) {
        return table[at];
    } else {
        return 0.0;
    }
}

double corpus_programs_faults_index_masked(const double table[4], uint64_t at)
{
    return table[at % UINT64_C(4)];
}
