/* The C of blocks/src/spectrum.rs. Written by a test. */

/* spectrum.c */

static const float F32_TAU = 6.2831855F;
static const uint32_t SPECTRUM_STAGES_COUNT = 4U;
static const uint32_t SPECTRUM_STAGES_COUNT_2 = 3U;

void spectrum_fft_f32_16_8(float re[BESSEMER_RESTRICT 16], float im[BESSEMER_RESTRICT 16],
    const float roots[8][2])
{
    for (uint32_t k = 0U; k < 16U; k++) {
        const uint32_t mirrored = (whole_reverse_bits_u32(k) >> (32U - SPECTRUM_STAGES_COUNT))
            & (16U - 1U);
        if (mirrored > k) {
            const float before = re[k];
            re[k] = re[mirrored];
            re[mirrored] = before;
            const float before_2 = im[k];
            im[k] = im[mirrored];
            im[mirrored] = before_2;
        }
    }
    for (uint32_t stage = 0U; stage < SPECTRUM_STAGES_COUNT; stage++) {
        const uint32_t half = (uint32_t)1U << stage;
        for (uint32_t butterfly = 0U; butterfly < 8U; butterfly++) {
            const uint32_t k = butterfly & (half - 1U);
            const uint32_t low = (((butterfly >> stage) << (stage + 1U)) | k) & (16U - 1U);
            const uint32_t high = (low | half) & (16U - 1U);
            const uint32_t root = (k << (SPECTRUM_STAGES_COUNT - 1U - stage)) & (8U - 1U);
            const uint64_t low_2 = (uint64_t)low;
            const uint64_t high_2 = (uint64_t)high;
            const float turned_re = re[high_2] * roots[root][0] + im[high_2] * roots[root][1];
            const float turned_im = im[high_2] * roots[root][0] - re[high_2] * roots[root][1];
            re[high_2] = re[low_2] - turned_re;
            im[high_2] = im[low_2] - turned_im;
            re[low_2] += turned_re;
            im[low_2] += turned_im;
        }
    }
}

void spectrum_fft_f64_8_4(double re[BESSEMER_RESTRICT 8], double im[BESSEMER_RESTRICT 8],
    const double roots[4][2])
{
    for (uint32_t k = 0U; k < 8U; k++) {
        const uint32_t mirrored = (whole_reverse_bits_u32(k) >> (32U - SPECTRUM_STAGES_COUNT_2))
            & (8U - 1U);
        if (mirrored > k) {
            const double before = re[k];
            re[k] = re[mirrored];
            re[mirrored] = before;
            const double before_2 = im[k];
            im[k] = im[mirrored];
            im[mirrored] = before_2;
        }
    }
    for (uint32_t stage = 0U; stage < SPECTRUM_STAGES_COUNT_2; stage++) {
        const uint32_t half = (uint32_t)1U << stage;
        for (uint32_t butterfly = 0U; butterfly < 4U; butterfly++) {
            const uint32_t k = butterfly & (half - 1U);
            const uint32_t low = (((butterfly >> stage) << (stage + 1U)) | k) & (8U - 1U);
            const uint32_t high = (low | half) & (8U - 1U);
            const uint32_t root = (k << (SPECTRUM_STAGES_COUNT_2 - 1U - stage)) & (4U - 1U);
            const uint64_t low_2 = (uint64_t)low;
            const uint64_t high_2 = (uint64_t)high;
            const double turned_re = re[high_2] * roots[root][0] + im[high_2] * roots[root][1];
            const double turned_im = im[high_2] * roots[root][0] - re[high_2] * roots[root][1];
            re[high_2] = re[low_2] - turned_re;
            im[high_2] = im[low_2] - turned_im;
            re[low_2] += turned_re;
            im[low_2] += turned_im;
        }
    }
}

float spectrum_goertzel_f32_16(const float samples[16], float cycles)
{
    const float coefficient = 2.0F * math_single_cosf(F32_TAU * cycles);
    float last = 0.0F;
    float before = 0.0F;
    for (uint32_t i = 0U; i < 16U; i++) {
        const float next = samples[i] + coefficient * last - before;
        before = last;
        last = next;
    }
    return before * before + last * last - coefficient * before * last;
}
