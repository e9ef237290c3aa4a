#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Where words come from and go to: without an operating system, files of whoever emulates the machine (semihosting.c). */
#ifdef SEMIHOSTING
extern FILE *words_in;
extern FILE *words_out;
#else
#define words_in stdin
#define words_out stdout
#endif

static uint64_t get(void)
{
    unsigned char bytes[8];
    uint64_t word = 0;
    int i;
    if (fread(bytes, 1, 8, words_in) != 8) {
        /* Not every C library does it at the end. */
        (void)fflush(words_out);
        exit(0);
    }
    for (i = 7; i >= 0; --i) {
        word = (word << 8) | bytes[i];
    }
    return word;
}

static void put(uint64_t word)
{
    unsigned char bytes[8];
    int i;
    for (i = 0; i < 8; ++i) {
        bytes[i] = (unsigned char)(word >> (8 * i));
    }
    if (fwrite(bytes, 1, 8, words_out) != 8) {
        exit(1);
    }
}

