#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static uint64_t get(void)
{
    unsigned char bytes[8];
    uint64_t word = 0;
    int i;
    if (fread(bytes, 1, 8, stdin) != 8) {
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
    if (fwrite(bytes, 1, 8, stdout) != 8) {
        exit(1);
    }
}

