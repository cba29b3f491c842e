/* What the files of the C half share. */
#pragma once

#include "postgres.h"

#include "fmgr.h"

#include "bridge.h"

/* Returns the state that belongs to a memory context, which frees it when it is reset. */
mink_state* mink_state_in(MemoryContext context);
/* Returns a request with the settings of this session. */
mink_request mink_request_of(mink_operation operation, bool text);
/* Counts operands that were prepared, for minksum.prepared_operands. */
void mink_count_prepared(int operands);
/* Reports an error, unless there is none. */
void mink_report(mink_status status, const mink_error* error);
/* Returns the bytes of a value of a type with a variable length. */
mink_bytes mink_bytes_of(Datum value);
/* Returns a value of type bytea or text. */
Datum mink_datum_of(mink_bytes bytes);
