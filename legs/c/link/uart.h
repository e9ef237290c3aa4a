/*
 * uart.h: a serial port, byte by byte: what a board has to give to be spoken with.
 *
 * SPDX-License-Identifier: MIT OR Apache-2.0
 */
#ifndef UART_H
#define UART_H

#include <stdint.h>

/** Sets the port up. */
void uart_open(void);

/** Waits for a byte. */
uint8_t uart_get(void);

/** Waits until there is room, and sends a byte. */
void uart_put(uint8_t byte);

#endif
