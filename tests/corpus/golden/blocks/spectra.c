/* The C of tests/corpus/src/programs/blocks/spectra.rs. Written by a test. */

/* spectra.c */

void spectra_powers(const float samples[16], float powers[BESSEMER_RESTRICT 8])
{
    float re[16];
    (void)memcpy(re, samples, sizeof(float[16]));
    float im[16] = {0};
    spectrum_fft_f32_16_8(re, im, (const float (*)[2])SPECTRA_ROOTS);
    for (uint32_t k = 0U; k < 8U; k++) {
        powers[k] = re[k] * re[k] + im[k] * im[k];
    }
}

void spectra_transformed(double re[BESSEMER_RESTRICT 8], double im[BESSEMER_RESTRICT 8])
{
    spectrum_fft_f64_8_4(re, im, (const double (*)[2])SPECTRA_FINE_ROOTS);
}

float spectra_tone(const float samples[16], float cycles)
{
    return spectrum_goertzel_f32_16(samples, cycles);
}
