/* Aggregates: the union and the sum of all rows of a group. */
#include "module.h"

#include "catalog/pg_type.h"
#include "parser/parse_coerce.h"

/* Converts a value as an implicit cast does. Another extension's type, such as geometry, has a cast
 * to bytea and one back. */
static Datum cast(FunctionCallInfo fcinfo, Datum value, Oid from, Oid to) {
  if (from == to || from == TEXTOID || to == TEXTOID) return value;
  if (fcinfo->flinfo->fn_extra == NULL) {
    Oid function;
    FmgrInfo* call = MemoryContextAlloc(fcinfo->flinfo->fn_mcxt, sizeof(FmgrInfo));
    if (find_coercion_pathway(to, from, COERCION_IMPLICIT, &function) != COERCION_PATH_FUNC) {
      ereport(ERROR, (errcode(ERRCODE_DATATYPE_MISMATCH),
                      errmsg("minksum: there is no implicit cast that this aggregate needs")));
    }
    fmgr_info_cxt(function, call, fcinfo->flinfo->fn_mcxt);
    fcinfo->flinfo->fn_extra = call;
  }
  return FunctionCall1((FmgrInfo*)fcinfo->flinfo->fn_extra, value);
}

static MemoryContext group_of(FunctionCallInfo fcinfo) {
  MemoryContext context;
  if (!AggCheckCallContext(fcinfo, &context)) {
    ereport(ERROR, (errcode(ERRCODE_FEATURE_NOT_SUPPORTED),
                    errmsg("minksum: this function serves aggregates only")));
  }
  return context;
}

static Datum step(FunctionCallInfo fcinfo, mink_operation operation, bool text) {
  MemoryContext group = group_of(fcinfo);
  mink_state* state = PG_ARGISNULL(0) ? NULL : (mink_state*)PG_GETARG_POINTER(0);
  mink_request request = mink_request_of(operation, text);
  mink_bytes part;
  mink_error error;
  if (PG_ARGISNULL(1)) {
    if (state == NULL) PG_RETURN_NULL();
    PG_RETURN_POINTER(state);
  }
  if (state == NULL) state = mink_state_in(group);
  part = mink_bytes_of(cast(fcinfo, PG_GETARG_DATUM(1), get_fn_expr_argtype(fcinfo->flinfo, 1),
                            BYTEAOID));
  request.operands = &part;
  request.operand_count = 1;
  mink_report(mink_collect(state, &request, &error), &error);
  PG_RETURN_POINTER(state);
}

static Datum combine(FunctionCallInfo fcinfo, mink_operation operation) {
  MemoryContext group = group_of(fcinfo);
  mink_request request = mink_request_of(operation, false);
  mink_state* state;
  mink_error error;
  if (PG_ARGISNULL(1)) {
    if (PG_ARGISNULL(0)) PG_RETURN_NULL();
    PG_RETURN_DATUM(PG_GETARG_DATUM(0));
  }
  /* The second state may belong to a shorter-lived context, so it is copied. */
  state = PG_ARGISNULL(0) ? mink_state_in(group) : (mink_state*)PG_GETARG_POINTER(0);
  mink_report(mink_merge(state, (mink_state*)PG_GETARG_POINTER(1), &request, &error), &error);
  PG_RETURN_POINTER(state);
}

static Datum finish(FunctionCallInfo fcinfo, mink_operation operation, bool text) {
  mink_request request = mink_request_of(operation, text);
  mink_answer answer;
  mink_error error;
  mink_status status;
  group_of(fcinfo);
  if (PG_ARGISNULL(0)) PG_RETURN_NULL();
  status = mink_finish((mink_state*)PG_GETARG_POINTER(0), &request, &answer, &error);
  mink_report(status, &error);
  if (status == MINK_NULL) PG_RETURN_NULL();
  return cast(fcinfo, mink_datum_of(answer.sets[0]), BYTEAOID,
              get_fn_expr_rettype(fcinfo->flinfo));
}

#define FUNCTION(name, call) \
  PG_FUNCTION_INFO_V1(name); \
  Datum name(PG_FUNCTION_ARGS) { return call; }

FUNCTION(mink_union_step, step(fcinfo, MINK_UNION, false))
FUNCTION(mink_union_step_text, step(fcinfo, MINK_UNION, true))
FUNCTION(mink_union_combine, combine(fcinfo, MINK_UNION))
FUNCTION(mink_union_finish, finish(fcinfo, MINK_UNION, false))
FUNCTION(mink_union_finish_text, finish(fcinfo, MINK_UNION, true))
FUNCTION(mink_sum_step, step(fcinfo, MINK_SUM, false))
FUNCTION(mink_sum_step_text, step(fcinfo, MINK_SUM, true))
FUNCTION(mink_sum_combine, combine(fcinfo, MINK_SUM))
FUNCTION(mink_sum_finish, finish(fcinfo, MINK_SUM, false))
FUNCTION(mink_sum_finish_text, finish(fcinfo, MINK_SUM, true))

/* Both aggregates keep a set that workers send as exact text. */
PG_FUNCTION_INFO_V1(mink_save_state);
Datum mink_save_state(PG_FUNCTION_ARGS) {
  mink_request request = mink_request_of(MINK_UNION, true);
  mink_answer answer;
  mink_error error;
  group_of(fcinfo);
  mink_report(mink_save((mink_state*)PG_GETARG_POINTER(0), &request, &answer, &error), &error);
  return mink_datum_of(answer.sets[0]);
}

PG_FUNCTION_INFO_V1(mink_load_state);
Datum mink_load_state(PG_FUNCTION_ARGS) {
  mink_request request = mink_request_of(MINK_UNION, true);
  mink_error error;
  mink_state* state;
  group_of(fcinfo);
  /* Of the short-lived context, because the state is merged into another one at once. */
  state = mink_state_in(CurrentMemoryContext);
  mink_report(mink_load(state, mink_bytes_of(PG_GETARG_DATUM(0)), &request, &error), &error);
  PG_RETURN_POINTER(state);
}
