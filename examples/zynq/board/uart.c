/*
 * uart.c: see uart.h; the second serial port of a Zynq-7000 (Cadence UART) at 921 600 baud from a reference clock of 100 MHz,
 * 8 bits, no parity, one stop bit, without interrupts. The registers are those of the Zynq-7000's technical reference manual, appendix B, and of the
 * Cortex-A9's interrupt controller.
 *
 * SPDX-License-Identifier: MIT OR Apache-2.0
 */
#include "uart.h"

/** The registers up to the last one that is used. */
typedef struct {
    uint32_t control;
    uint32_t mode;
    uint32_t interrupts_on;
    uint32_t unused_1[2];
    uint32_t interrupts;
    uint32_t baud_generator;
    uint32_t unused_2;
    uint32_t receive_trigger;
    uint32_t unused_3[2];
    uint32_t status;
    uint32_t fifo;
    uint32_t baud_divider;
} uart_t;

#define UART1 ((volatile uart_t *)0xE0001000U)

#define CONTROL_RESET 0x03U         /* receiver and transmitter */
#define CONTROL_ENABLE 0x14U        /* both */
#define MODE_8_NONE_1 0x20U
#define STATUS_NOTHING_CAME 0x02U
#define STATUS_FULL 0x10U
#define INTERRUPT_CAME 0x01U

/* The interrupt controller: the port's interrupt is number 82. */
#define PROCESSOR_ON (*(volatile uint32_t *)0xF8F00100U)
#define PROCESSOR_PRIORITY (*(volatile uint32_t *)0xF8F00104U)
#define DISTRIBUTOR_ON (*(volatile uint32_t *)0xF8F01000U)
#define INTERRUPTS_64_TO_95_ON (*(volatile uint32_t *)0xF8F01108U)
#define INTERRUPT_82_TARGET (*(volatile uint8_t *)0xF8F01852U)

void uart_open(void)
{
    UART1->control = CONTROL_RESET;
    UART1->mode = MODE_8_NONE_1;
    /* 100 MHz / (18 * (5 + 1)) = 925 926 baud, 0.5 % too fast. */
    UART1->baud_generator = 18U;
    UART1->baud_divider = 5U;
    UART1->receive_trigger = 1U;
    UART1->interrupts_on = INTERRUPT_CAME;
    UART1->control = CONTROL_ENABLE;

    INTERRUPT_82_TARGET = 1U;
    INTERRUPTS_64_TO_95_ON = 1U << 18U;
    DISTRIBUTOR_ON = 1U;
    PROCESSOR_PRIORITY = 0xFFU;
    PROCESSOR_ON = 1U;
}

uint8_t uart_get(void)
{
    while ((UART1->status & STATUS_NOTHING_CAME) != 0U) {
        /* The interrupt, which is masked, only ends the processor's sleep: one that comes from here on is not missed. */
        UART1->interrupts = INTERRUPT_CAME;
        if ((UART1->status & STATUS_NOTHING_CAME) != 0U) {
            __asm__ volatile("dsb\n\twfi" ::: "memory");
        }
    }
    return (uint8_t)(UART1->fifo & 0xFFU);
}

void uart_put(uint8_t byte)
{
    while ((UART1->status & STATUS_FULL) != 0U) {
    }
    UART1->fifo = byte;
}
