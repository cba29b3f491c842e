/* The module: its settings, its states, and how it reports errors. */
#include "module.h"

#include <limits.h>

#include "miscadmin.h"
#include "utils/builtins.h"
#include "utils/guc.h"
#include "utils/memutils.h"

PG_MODULE_MAGIC;

void _PG_init(void);

static int max_segments = 1 << 24;
static int max_crossings = 1 << 24;
static int prepared_operands = 0;

void mink_count_prepared(int operands) {
  if (prepared_operands <= INT_MAX - operands) prepared_operands += operands;
}

void _PG_init(void) {
  DefineCustomIntVariable("minksum.max_segments",
                          "Most segments of the convolution that one sum may list.",
                          "More are an error, program_limit_exceeded.", &max_segments, 1 << 24, 1,
                          1 << 30, PGC_USERSET, 0, NULL, NULL, NULL);
  DefineCustomIntVariable("minksum.max_crossings",
                          "Most crossings that one sum or one union may find.",
                          "More are an error, program_limit_exceeded.", &max_crossings, 1 << 24, 1,
                          1 << 30, PGC_USERSET, 0, NULL, NULL, NULL);
  DefineCustomIntVariable("minksum.prepared_operands",
                          "How many operands this session has prepared, because they came again.",
                          NULL, &prepared_operands, 0, 0, INT_MAX, PGC_INTERNAL, 0, NULL, NULL,
                          NULL);
  MarkGUCPrefixReserved("minksum");
}

/* The C++ half asks this; it must not be left by longjmp, so it only looks. */
static bool stop(void) { return QueryCancelPending || ProcDiePending; }

typedef struct Holder {
  MemoryContextCallback callback;
  mink_state* state;
} Holder;

static void release(void* holder) { mink_state_free(((Holder*)holder)->state); }

mink_state* mink_state_in(MemoryContext context) {
  Holder* holder = MemoryContextAllocZero(context, sizeof(Holder));
  holder->state = mink_state_new();
  if (holder->state == NULL) {
    ereport(ERROR, (errcode(ERRCODE_OUT_OF_MEMORY), errmsg("minksum: out of memory")));
  }
  holder->callback.func = release;
  holder->callback.arg = holder;
  MemoryContextRegisterResetCallback(context, &holder->callback);
  return holder->state;
}

mink_request mink_request_of(mink_operation operation, bool text) {
  mink_request request = {.operation = operation, .text = text, .stop = stop};
  request.max_segments = (uint64_t)max_segments;
  request.max_crossings = (uint64_t)max_crossings;
  return request;
}

static int code_of(mink_status status) {
  switch (status) {
    case MINK_BAD_INPUT:
      return ERRCODE_INVALID_PARAMETER_VALUE;
    case MINK_BAD_BYTES:
      return ERRCODE_INVALID_BINARY_REPRESENTATION;
    case MINK_BAD_TEXT:
      return ERRCODE_INVALID_TEXT_REPRESENTATION;
    case MINK_LIMIT:
      return ERRCODE_PROGRAM_LIMIT_EXCEEDED;
    case MINK_MEMORY:
      return ERRCODE_OUT_OF_MEMORY;
    case MINK_CANCELLED:
      return ERRCODE_QUERY_CANCELED;
    default:
      return ERRCODE_INTERNAL_ERROR;
  }
}

void mink_report(mink_status status, const mink_error* error) {
  if (status == MINK_OK || status == MINK_NULL) return;
  /* This says why the query is cancelled, or that the session ends. */
  if (status == MINK_CANCELLED) CHECK_FOR_INTERRUPTS();
  ereport(ERROR, (errcode(code_of(status)), errmsg("minksum: %s", error->message),
                  error->detail[0] ? errdetail("%s", error->detail) : 0,
                  error->hint[0] ? errhint("%s", error->hint) : 0));
}

mink_bytes mink_bytes_of(Datum value) {
  struct varlena* bytes = PG_DETOAST_DATUM_PACKED(value);
  mink_bytes result = {VARDATA_ANY(bytes), VARSIZE_ANY_EXHDR(bytes)};
  return result;
}

Datum mink_datum_of(mink_bytes bytes) {
  struct varlena* result;
  if (bytes.size > MaxAllocSize - VARHDRSZ) {
    ereport(ERROR, (errcode(ERRCODE_PROGRAM_LIMIT_EXCEEDED),
                    errmsg("minksum: the result has %zu bytes, and a value has at most %zu",
                           bytes.size, (size_t)(MaxAllocSize - VARHDRSZ))));
  }
  result = palloc(bytes.size + VARHDRSZ);
  SET_VARSIZE(result, bytes.size + VARHDRSZ);
  if (bytes.size > 0) memcpy(VARDATA(result), bytes.data, bytes.size);
  return PointerGetDatum(result);
}
