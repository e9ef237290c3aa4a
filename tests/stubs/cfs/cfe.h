/* A stand-in for cFE's header of this name: as much of its interface as an emitted application needs, for a test. */
#ifndef CFE_H
#define CFE_H

#include <stdbool.h>

#include "cfe_msg_hdr.h"

#define CFE_SUCCESS 0
#define CFE_SB_PEND_FOREVER (-1)
#define CFE_MSG_PTR(header) (&(header).Msg)
#define CFE_SB_INVALID_MSG_ID ((CFE_SB_MsgId_t){0})
#define CFE_SB_INVALID_PIPE ((CFE_SB_PipeId_t)0)

typedef int32 CFE_Status_t;
typedef uint32 CFE_SB_PipeId_t;
typedef struct {
    uint32 Value;
} CFE_SB_MsgId_t;
typedef union {
    CFE_MSG_Message_t Msg;
    long long LongInt;
    long double LongDouble;
} CFE_SB_Buffer_t;

enum { CFE_ES_RunStatus_APP_RUN = 1, CFE_ES_RunStatus_APP_ERROR = 3 };

CFE_SB_MsgId_t CFE_SB_ValueToMsgId(uint32 value);
uint32 CFE_SB_MsgIdToValue(CFE_SB_MsgId_t id);
CFE_Status_t CFE_MSG_Init(CFE_MSG_Message_t *message, CFE_SB_MsgId_t id, CFE_MSG_Size_t size);
CFE_Status_t CFE_MSG_GetMsgId(const CFE_MSG_Message_t *message, CFE_SB_MsgId_t *id);
CFE_Status_t CFE_MSG_GetSize(const CFE_MSG_Message_t *message, CFE_MSG_Size_t *size);
CFE_Status_t CFE_SB_CreatePipe(CFE_SB_PipeId_t *pipe, uint16 depth, const char *name);
CFE_Status_t CFE_SB_Subscribe(CFE_SB_MsgId_t id, CFE_SB_PipeId_t pipe);
CFE_Status_t CFE_SB_ReceiveBuffer(CFE_SB_Buffer_t **buffer, CFE_SB_PipeId_t pipe, int32 wait);
CFE_Status_t CFE_SB_TransmitMsg(const CFE_MSG_Message_t *message, bool is_origination);
void CFE_SB_TimeStampMsg(CFE_MSG_Message_t *message);
bool CFE_ES_RunLoop(uint32 *status);
void CFE_ES_ExitApp(uint32 status);
CFE_Status_t CFE_ES_WriteToSysLog(const char *text, ...);

#endif
