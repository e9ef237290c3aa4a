/* A stand-in for cFE's header of this name, for a test. */
#ifndef CFE_MSG_HDR_H
#define CFE_MSG_HDR_H

#include <stddef.h>
#include <stdint.h>

typedef uint32_t uint32;
typedef uint16_t uint16;
typedef int32_t int32;
typedef size_t CFE_MSG_Size_t;

typedef struct {
    uint16_t id;
    uint16_t size;
} CFE_MSG_Message_t;

typedef struct {
    CFE_MSG_Message_t Msg;
    uint8_t Sec[8];
} CFE_MSG_TelemetryHeader_t;

#endif
