/*
 * start.S: from reset to main() on a Cortex-A9, without an operating system.
 *
 * It sets up what C rests on (a stack, memory that begins as zero) and what the emitted C rests on (a floating-point
 * unit that rounds to nearest and keeps subnormal numbers), and leads each exception to fault(). Interrupts stay off:
 * the program polls. Caches and clocks stay as the boot loader left them.
 *
 * SPDX-License-Identifier: MIT OR Apache-2.0
 */
    .syntax unified
    .arm
    .fpu vfpv3

    .equ MODE_ABORT, 0xD7           /* the processor's modes, interrupts off */
    .equ MODE_UNDEFINED, 0xDB
    .equ MODE_SUPERVISOR, 0xD3
    .equ PAINT, 0xA5A5A5A5          /* as in stack.c */

    .section .vectors, "ax"
    .global _start
    .balign 32
_start:
    b       reset
    b       undefined
    b       .                       /* supervisor call: nothing makes one */
    b       prefetch
    b       data
    b       .
    b       .                       /* interrupts are off */
    b       .

    .text
reset:
    /* Exceptions come to this table, and each has the same small stack: none of them comes back. */
    ldr     r0, =_start
    mcr     p15, 0, r0, c12, c0, 0
    ldr     r0, =fault_stack_high
    msr     cpsr_c, #MODE_ABORT
    mov     sp, r0
    msr     cpsr_c, #MODE_UNDEFINED
    mov     sp, r0
    msr     cpsr_c, #MODE_SUPERVISOR
    ldr     sp, =stack_high

    /* The floating-point unit: on, rounding to nearest, no flush to zero, no default NaN. */
    mrc     p15, 0, r0, c1, c0, 2
    orr     r0, r0, #(0xF << 20)
    mcr     p15, 0, r0, c1, c0, 2
    isb
    mov     r0, #0x40000000
    vmsr    fpexc, r0
    mov     r0, #0
    vmsr    fpscr, r0

    /* What C begins with as zero. */
    ldr     r0, =bss_low
    ldr     r1, =bss_high
    mov     r2, #0
1:  cmp     r0, r1
    strlo   r2, [r0], #4
    blo     1b

    bl      stack_paint
    bl      main
    b       .

/*
 * uint32_t stack_paint(void): fills the stack below its caller with a pattern; where that begins. It needs no stack
 * of its own.
 */
    .global stack_paint
    .type stack_paint, %function
stack_paint:
    ldr     r0, =stack_low
    ldr     r1, =PAINT
2:  cmp     r0, sp
    strlo   r1, [r0], #4
    blo     2b
    bx      lr

/* void fault(uint32_t kind, uint32_t place): the instruction that did not come through. */
undefined:
    mov     r0, #0
    sub     r1, lr, #4
    b       fault
prefetch:
    mov     r0, #1
    sub     r1, lr, #4
    b       fault
data:
    mov     r0, #2
    sub     r1, lr, #8
    b       fault
