/*
 * Begins a program on a machine without an operating system: what it reads and writes are files of whoever emulates it.
 * The C library's start (newlib's, picolibc's) calls this before main(); what reads and writes for it is a debugger's or an emulator's
 * (semihosting).
 */
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

FILE *words_in;
FILE *words_out;

#if defined(__riscv)
/* picolibc's start does it. */
static void enable_floats(void)
{
}
#elif __ARM_ARCH_PROFILE == 'M'
void _start(void);

/* What a Cortex-M reads at its reset. newlib asks the emulator for a larger stack. */
typedef struct {
    uint32_t stack;
    void (*start)(void);
} vectors_t;
__attribute__((section(".vectors"), used)) static const vectors_t vectors = {0x00010000U, _start};

static void enable_floats(void)
{
    *(volatile uint32_t *)0xE000ED88U |= 0xFU << 20U;
    __asm__ volatile("dsb\n\tisb");
}
#else
static void enable_floats(void)
{
    __asm__ volatile("mrc p15, 0, r0, c1, c0, 2\n\t"
                     "orr r0, r0, #0xF00000\n\t"
                     "mcr p15, 0, r0, c1, c0, 2\n\t"
                     "isb\n\t"
                     "mov r0, #0x40000000\n\t"
                     "vmsr fpexc, r0\n\t"
                     "mov r0, #0\n\t"
                     "vmsr fpscr, r0"
                     ::: "r0");
}
#endif

__attribute__((constructor)) static void begin(void)
{
    enable_floats();
    words_in = fopen("words.in", "rb");
    words_out = fopen("words.out", "wb");
    if (words_in == NULL || words_out == NULL) {
        exit(1);
    }
}
