/* Functions that return sets of rows, one row a call. */
#include "module.h"

#include "access/htup_details.h"
#include "catalog/pg_type.h"
#include "funcapi.h"
#include "utils/array.h"

/* Sets a function up whose rows have a type of their own. The context is that of all its calls. */
static FuncCallContext* first_call(FunctionCallInfo fcinfo) {
  FuncCallContext* calls = SRF_FIRSTCALL_INIT();
  MemoryContext before = MemoryContextSwitchTo(calls->multi_call_memory_ctx);
  TupleDesc row;
  if (get_call_result_type(fcinfo, NULL, &row) != TYPEFUNC_COMPOSITE) {
    ereport(ERROR, (errcode(ERRCODE_FEATURE_NOT_SUPPORTED),
                    errmsg("minksum: the function must be called where rows are accepted")));
  }
  calls->tuple_desc = BlessTupleDesc(row);
  calls->user_fctx = mink_state_in(calls->multi_call_memory_ctx);
  MemoryContextSwitchTo(before);
  return calls;
}

static void begin_slices(FunctionCallInfo fcinfo) {
  FuncCallContext* calls = first_call(fcinfo);
  mink_error error;
  uint64_t count = 0;
  mink_request request = mink_request_of(MINK_SUM, false);
  const mink_bytes operands[2] = {mink_bytes_of(PG_GETARG_DATUM(0)),
                                  mink_bytes_of(PG_GETARG_DATUM(1))};
  request.operands = operands;
  request.operand_count = 2;
  request.whole = PG_GETARG_INT32(2);
  request.wanted = PG_GETARG_BOOL(3);
  request.fill = mink_bytes_of(PG_GETARG_DATUM(4));
  request.round = mink_bytes_of(PG_GETARG_DATUM(5));
  mink_report(mink_begin_slices(calls->user_fctx, &request, &count, &error), &error);
  calls->max_calls = count;
}

PG_FUNCTION_INFO_V1(mink_slices);
Datum mink_slices(PG_FUNCTION_ARGS) {
  FuncCallContext* calls;
  Datum values[4];
  bool nulls[4] = {false};
  mink_answer answer = {0};
  mink_error error;
  if (SRF_IS_FIRSTCALL()) begin_slices(fcinfo);
  calls = SRF_PERCALL_SETUP();
  if (calls->call_cntr >= calls->max_calls) SRF_RETURN_DONE(calls);
  mink_report(mink_slice(calls->user_fctx, calls->call_cntr, &answer, &error), &error);
  values[0] = Int32GetDatum(answer.whole[0]);
  values[1] = Float8GetDatum(answer.numbers[0]);
  values[2] = mink_datum_of(answer.sets[0]);
  nulls[3] = answer.sets[1].size == 0;
  values[3] = nulls[3] ? (Datum)0 : mink_datum_of(answer.sets[1]);
  SRF_RETURN_NEXT(calls,
                  HeapTupleGetDatum(heap_form_tuple(calls->tuple_desc, values, nulls)));
}

static void begin_no_fit_table(FunctionCallInfo fcinfo) {
  FuncCallContext* calls = first_call(fcinfo);
  mink_error error;
  uint64_t count = 0;
  mink_request request = mink_request_of(MINK_NO_FIT_POLYGON, false);
  Datum* parts;
  bool* nulls;
  int number;
  mink_bytes* operands;
  deconstruct_array(PG_GETARG_ARRAYTYPE_P(0), BYTEAOID, -1, false, TYPALIGN_INT, &parts, &nulls,
                    &number);
  operands = palloc(sizeof(mink_bytes) * (size_t)Max(number, 1));
  for (int i = 0; i < number; ++i) {
    if (nulls[i]) {
      ereport(ERROR, (errcode(ERRCODE_NULL_VALUE_NOT_ALLOWED),
                      errmsg("minksum: part %d is NULL", i + 1),
                      errhint("Leave it out, as array_agg(...) FILTER does.")));
    }
    operands[i] = mink_bytes_of(parts[i]);
  }
  request.operands = operands;
  request.operand_count = number;
  request.whole = PG_GETARG_INT32(1);
  request.fill = mink_bytes_of(PG_GETARG_DATUM(2));
  request.round = mink_bytes_of(PG_GETARG_DATUM(3));
  mink_report(mink_begin_no_fit_table(calls->user_fctx, &request, &count, &error), &error);
  calls->max_calls = count;
}

PG_FUNCTION_INFO_V1(mink_no_fit_table);
Datum mink_no_fit_table(PG_FUNCTION_ARGS) {
  FuncCallContext* calls;
  Datum values[5];
  bool nulls[5] = {false};
  mink_answer answer = {0};
  mink_error error;
  if (SRF_IS_FIRSTCALL()) begin_no_fit_table(fcinfo);
  calls = SRF_PERCALL_SETUP();
  if (calls->call_cntr >= calls->max_calls) SRF_RETURN_DONE(calls);
  mink_report(mink_no_fit_entry(calls->user_fctx, calls->call_cntr, &answer, &error), &error);
  for (int i = 0; i < 4; ++i) values[i] = Int32GetDatum(answer.whole[i]);
  values[4] = mink_datum_of(answer.sets[0]);
  SRF_RETURN_NEXT(calls,
                  HeapTupleGetDatum(heap_form_tuple(calls->tuple_desc, values, nulls)));
}
