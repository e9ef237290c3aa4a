/*
 * main.c: the onboard software on a computer with sockets: sensors and motors on one, the ground on the other.
 *
 *     onboard [-a AIRCRAFT] [-l ADDRESS[:PORT]] [ADDRESS:]PORT
 *
 * The last argument is where sensors and motors are: the other end of the bus, on loopback without an address. `-l` is
 * where the ground is listened to: any free port of loopback without it, any free port of the address without a port.
 * `-a` is the aircraft, `mambo` or `f550`. The first datagram on the bus is "ready" and the port for the ground, two
 * bytes, least significant first. The first line of standard input is the key, 32 hexadecimal digits, or empty. The
 * program ends when standard input does: then whoever started it is gone. A silent bus does not end it: the machine
 * may be busy.
 *
 * SPDX-License-Identifier: MIT OR Apache-2.0
 */
#define _POSIX_C_SOURCE 200112L

#include <arpa/inet.h>
#include <errno.h>
#include <netinet/in.h>
#include <poll.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <unistd.h>

#include "computer.h"

/** A socket for the ground, at an address. */
static int listening(const struct sockaddr_in *here)
{
    const int made = socket(AF_INET, SOCK_DGRAM, 0);
    if (made < 0 || bind(made, (const struct sockaddr *)here, sizeof *here) != 0) {
        perror("onboard: ground");
        exit(1);
    }
    return made;
}

/** A socket whose other end is the bus. */
static int connected(const struct sockaddr_in *there)
{
    const int made = socket(AF_INET, SOCK_DGRAM, 0);
    if (made < 0 || connect(made, (const struct sockaddr *)there, sizeof *there) != 0) {
        perror("onboard: bus");
        exit(1);
    }
    return made;
}

/** The key from the first line of standard input; false if the line is neither a key nor empty. */
static bool read_key(siphash_key_t *key)
{
    char line[80];
    memset(key, 0, sizeof *key);
    if (fgets(line, (int)sizeof line, stdin) == NULL || line[0] == '\n') {
        return true;
    }
    if (strspn(line, "0123456789abcdefABCDEF") != 32U) {
        return false;
    }
    for (unsigned n = 0U; n < 16U; ++n) {
        const char two[3] = {line[2U * n], line[2U * n + 1U], '\0'};
        key->halves[n / 8U] |= (uint64_t)strtoul(two, NULL, 16) << (8U * (n % 8U));
    }
    key->is_set = true;
    return true;
}

/** Waits for a datagram on the bus; false if whoever started the program is gone. */
static bool wait_for(int bus)
{
    struct pollfd ends[2] = {{bus, POLLIN, 0}, {STDIN_FILENO, POLLIN, 0}};
    for (;;) {
        if (poll(ends, 2U, -1) < 0) {
            if (errno != EINTR) {
                perror("onboard: poll");
                return false;
            }
            continue;
        }
        if (ends[1].revents != 0) {
            /* Nothing more is to be said there but its end. */
            char rest[80];
            if (read(STDIN_FILENO, rest, sizeof rest) <= 0) {
                return false;
            }
        }
        if (ends[0].revents != 0) {
            return true;
        }
    }
}

/** A sender as a number: its address above its port. */
static uint64_t station(const struct sockaddr_in *sender)
{
    return ((uint64_t)ntohl(sender->sin_addr.s_addr) << 16U) | ntohs(sender->sin_port);
}

/** Takes in every datagram that has come from the ground. */
static void listen_to(computer_t *computer, int ground)
{
    for (;;) {
        struct sockaddr_in from;
        socklen_t size = sizeof from;
        /* A byte more than a packet has: what is longer is none. */
        uint8_t bytes[sizeof computer->downlink.bytes + 1U];
        const ssize_t length =
            recvfrom(ground, bytes, sizeof bytes, MSG_DONTWAIT, (struct sockaddr *)&from, &size);
        if (length < 0) {
            return;
        }
        computer_hear(computer, station(&from), bytes, (size_t)length);
    }
}

/** Sends down what goes to the station. */
static void speak(const computer_t *computer, int ground)
{
    struct sockaddr_in there;
    memset(&there, 0, sizeof there);
    there.sin_family = AF_INET;
    there.sin_port = htons((uint16_t)(computer->ground.station & 0xFFFFU));
    there.sin_addr.s_addr = htonl((uint32_t)((computer->ground.station >> 16U) & 0xFFFFFFFFU));
    (void)sendto(ground, computer->downlink.bytes, (size_t)computer->downlink.length, 0,
        (const struct sockaddr *)&there, sizeof there);
}

/** Reads a port; false if the text is none. */
static bool read_port(const char *text, struct sockaddr_in *address)
{
    char *end;
    const unsigned long number = strtoul(text, &end, 10);
    address->sin_port = htons((uint16_t)(number & 0xFFFFU));
    return strspn(text, "0123456789") > 0U && *end == '\0' && number <= 0xFFFFU;
}

/** Reads an address of IPv4; false if the text is none. */
static bool read_address(const char *text, struct sockaddr_in *address)
{
    return inet_pton(AF_INET, text, &address->sin_addr) == 1;
}

/** Reads an address, a port, or both; what the text leaves out stays. False if the text is neither. */
static bool read_place(const char *text, struct sockaddr_in *place)
{
    char host[INET_ADDRSTRLEN];
    const char *const colon = strchr(text, ':');
    if (colon == NULL) {
        return (strchr(text, '.') != NULL) ? read_address(text, place) : read_port(text, place);
    }
    const size_t length = (size_t)(colon - text);
    if (length >= sizeof host) {
        return false;
    }
    memcpy(host, text, length);
    host[length] = '\0';
    return read_address(host, place) && read_port(colon + 1, place);
}

/** Arguments of the program. */
typedef struct {
    struct sockaddr_in bus;
    struct sockaddr_in ground;
    aircraft_t aircraft;
} arguments_t;

static bool read_aircraft(const char *text, aircraft_t *aircraft)
{
    *aircraft = (strcmp(text, "f550") == 0) ? AIRCRAFT_F550 : AIRCRAFT_MAMBO;
    return *aircraft == AIRCRAFT_F550 || strcmp(text, "mambo") == 0;
}

/** Reads the command line; false if it is not as the program takes it. */
static bool read_arguments(int argc, char **argv, arguments_t *arguments)
{
    int option;
    memset(arguments, 0, sizeof *arguments);
    arguments->bus.sin_family = AF_INET;
    arguments->bus.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    arguments->ground = arguments->bus;
    while ((option = getopt(argc, argv, "a:l:")) != -1) {
        if (option == 'a' ? !read_aircraft(optarg, &arguments->aircraft)
                          : option != 'l' || !read_place(optarg, &arguments->ground)) {
            return false;
        }
    }
    return optind + 1 == argc && read_place(argv[optind], &arguments->bus) && arguments->bus.sin_port != 0U;
}

/** Says that it is there, and where the ground reaches it. */
static void say_ready(int bus, int ground)
{
    struct sockaddr_in here;
    socklen_t size = sizeof here;
    uint8_t ready[7] = {'r', 'e', 'a', 'd', 'y', 0U, 0U};
    if (getsockname(ground, (struct sockaddr *)&here, &size) != 0) {
        perror("onboard: ground");
        exit(1);
    }
    const uint16_t number = ntohs(here.sin_port);
    ready[5] = (uint8_t)(number & 0xFFU);
    ready[6] = (uint8_t)(number >> 8U);
    (void)send(bus, ready, sizeof ready, 0);
}

int main(int argc, char **argv)
{
    static computer_t computer;
    /* A byte more than a datagram has: what is longer is none. */
    static uint8_t in[COMPUTER_MOST + 1U];
    siphash_key_t key;
    arguments_t arguments;

    if (!read_arguments(argc, argv, &arguments) || !read_key(&key)) {
        (void)fprintf(stderr, "usage: onboard [-a mambo|f550] [-l ADDRESS[:PORT]] [ADDRESS:]PORT, with a key or an "
                              "empty line on standard input\n");
        return 2;
    }
    const int ground = listening(&arguments.ground);
    const int bus = connected(&arguments.bus);
    computer_begin(&computer, &key, arguments.aircraft);
    say_ready(bus, ground);

    while (wait_for(bus)) {
        const ssize_t length = recv(bus, in, sizeof in, 0);
        if (length < 0) {
            /* The other end of the bus is closed. */
            return 0;
        }
        if (computer_is_period((size_t)length)) {
            listen_to(&computer, ground);
        }
        const size_t size = computer_take(&computer, in, (size_t)length);
        /* What goes down comes first: whoever has the answer finds it there. */
        if (computer.downlink.length > 0U) {
            speak(&computer, ground);
        }
        if (size > 0U) {
            (void)send(bus, computer.answer, size, 0);
        }
    }
    return 0;
}
