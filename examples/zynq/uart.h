/*
 * uart.h: the second serial port of a Zynq-7000 (Cadence UART), byte by byte, without interrupts.
 *
 * SPDX-License-Identifier: MIT OR Apache-2.0
 */
#ifndef UART_H
#define UART_H

#include <stdint.h>

/** Sets the port up: 921 600 baud from a reference clock of 100 MHz, 8 bits, no parity, one stop bit. */
void uart_open(void);

/** Waits for a byte. */
uint8_t uart_get(void);

/** Waits until there is room, and sends a byte. */
void uart_put(uint8_t byte);

#endif
