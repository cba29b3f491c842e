/* Functions that return one value. */
#include "module.h"

#include "access/htup_details.h"
#include "funcapi.h"
#include "utils/builtins.h"

/* How the arguments of a function are read, one letter each. */
enum {
  OPERAND = 'o',
  NUMBER = 'n', /* float8 */
  EXACT = 'e',  /* a number as text */
  FILL = 'f',
  ROUND = 'r',
  SIDE = 's',
  JOIN = 'j',
  CAP = 'c'
};

static void gather(FunctionCallInfo fcinfo, const char* signature, mink_request* request,
                   mink_bytes* operands) {
  request->operands = operands;
  for (int i = 0; signature[i] != '\0'; ++i) {
    const Datum value = PG_GETARG_DATUM(i);
    switch (signature[i]) {
      case OPERAND:
        operands[request->operand_count++] = mink_bytes_of(value);
        break;
      case NUMBER:
        request->numbers[request->number_count++] = DatumGetFloat8(value);
        break;
      case EXACT:
        request->exact = mink_bytes_of(value);
        ++request->number_count;
        break;
      case FILL:
        request->fill = mink_bytes_of(value);
        break;
      case ROUND:
        request->round = mink_bytes_of(value);
        break;
      case SIDE:
        request->side = mink_bytes_of(value);
        break;
      case JOIN:
        request->join = mink_bytes_of(value);
        break;
      case CAP:
        request->cap = mink_bytes_of(value);
        break;
    }
  }
}

static mink_status compute(FunctionCallInfo fcinfo, mink_operation operation, bool text,
                           const char* signature, mink_answer* answer) {
  mink_bytes operands[3];
  mink_error error;
  mink_request request = mink_request_of(operation, text);
  mink_status status;
  if (fcinfo->flinfo->fn_extra == NULL) {
    fcinfo->flinfo->fn_extra = mink_state_in(fcinfo->flinfo->fn_mcxt);
  }
  gather(fcinfo, signature, &request, operands);
  status = mink_compute(fcinfo->flinfo->fn_extra, &request, answer, &error);
  mink_report(status, &error);
  mink_count_prepared(answer->prepared);
  return status;
}

static Datum set_of(FunctionCallInfo fcinfo, mink_operation operation, bool text,
                    const char* signature) {
  mink_answer answer;
  compute(fcinfo, operation, text, signature, &answer);
  return mink_datum_of(answer.sets[0]);
}

#define SET(name, operation, signature)                     \
  PG_FUNCTION_INFO_V1(name);                                \
  Datum name(PG_FUNCTION_ARGS) {                            \
    return set_of(fcinfo, operation, false, signature);     \
  }
#define TEXT_SET(name, operation, signature)                \
  PG_FUNCTION_INFO_V1(name);                                \
  Datum name(PG_FUNCTION_ARGS) {                            \
    return set_of(fcinfo, operation, true, signature);      \
  }

SET(mink_sum, MINK_SUM, "oofr")
SET(mink_erode, MINK_ERODE, "oofr")
SET(mink_open, MINK_OPEN, "oofr")
SET(mink_close, MINK_CLOSE, "oofr")
SET(mink_union, MINK_UNION, "oofr")
SET(mink_intersection, MINK_INTERSECTION, "oofr")
SET(mink_difference, MINK_DIFFERENCE, "oofr")
SET(mink_sym_difference, MINK_SYM_DIFFERENCE, "oofr")
SET(mink_resolve, MINK_RESOLVE, "ofr")
SET(mink_offset, MINK_OFFSET, "onjcnnsfr")
SET(mink_disc, MINK_DISC, "nnsr")
SET(mink_no_fit_polygon, MINK_NO_FIT_POLYGON, "oofr")
SET(mink_no_fit_polygon_at, MINK_NO_FIT_POLYGON, "ooofr")
SET(mink_inner_fit_polygon, MINK_INNER_FIT_POLYGON, "oofr")
SET(mink_inner_fit_polygon_at, MINK_INNER_FIT_POLYGON, "ooofr")

TEXT_SET(mink_sum_text, MINK_SUM, "oof")
TEXT_SET(mink_erode_text, MINK_ERODE, "oof")
TEXT_SET(mink_open_text, MINK_OPEN, "oof")
TEXT_SET(mink_close_text, MINK_CLOSE, "oof")
TEXT_SET(mink_union_text, MINK_UNION, "oof")
TEXT_SET(mink_intersection_text, MINK_INTERSECTION, "oof")
TEXT_SET(mink_difference_text, MINK_DIFFERENCE, "oof")
TEXT_SET(mink_sym_difference_text, MINK_SYM_DIFFERENCE, "oof")
TEXT_SET(mink_resolve_text, MINK_RESOLVE, "of")
TEXT_SET(mink_offset_text, MINK_OFFSET, "oejcnnsf")
TEXT_SET(mink_no_fit_polygon_text, MINK_NO_FIT_POLYGON, "oof")
TEXT_SET(mink_inner_fit_polygon_text, MINK_INNER_FIT_POLYGON, "oof")

/* The names that the row type of the function has decide nothing; their order does. */
static Datum depth_of(FunctionCallInfo fcinfo, bool text) {
  TupleDesc row;
  Datum values[5];
  bool nulls[5] = {false};
  mink_answer answer;
  if (compute(fcinfo, MINK_DEPTH, text, "oof", &answer) == MINK_NULL) PG_RETURN_NULL();
  if (get_call_result_type(fcinfo, NULL, &row) != TYPEFUNC_COMPOSITE) {
    ereport(ERROR, (errcode(ERRCODE_FEATURE_NOT_SUPPORTED),
                    errmsg("minksum: mink_depth must be called where a record is accepted")));
  }
  values[0] = BoolGetDatum(answer.truth);
  values[1] = Float8GetDatum(answer.numbers[0]);
  values[2] = Float8GetDatum(answer.numbers[1]);
  values[3] = Float8GetDatum(answer.numbers[2]);
  values[4] = mink_datum_of(answer.exact);
  return HeapTupleGetDatum(heap_form_tuple(BlessTupleDesc(row), values, nulls));
}

PG_FUNCTION_INFO_V1(mink_depth);
Datum mink_depth(PG_FUNCTION_ARGS) { return depth_of(fcinfo, false); }
PG_FUNCTION_INFO_V1(mink_depth_text);
Datum mink_depth_text(PG_FUNCTION_ARGS) { return depth_of(fcinfo, true); }

static Datum impact_of(FunctionCallInfo fcinfo, bool text) {
  mink_answer answer;
  if (compute(fcinfo, MINK_IMPACT, text, "oonnf", &answer) == MINK_NULL) PG_RETURN_NULL();
  PG_RETURN_FLOAT8(answer.numbers[0]);
}

PG_FUNCTION_INFO_V1(mink_impact);
Datum mink_impact(PG_FUNCTION_ARGS) { return impact_of(fcinfo, false); }
PG_FUNCTION_INFO_V1(mink_impact_text);
Datum mink_impact_text(PG_FUNCTION_ARGS) { return impact_of(fcinfo, true); }

static Datum is_sum(FunctionCallInfo fcinfo, bool text) {
  mink_answer answer;
  if (compute(fcinfo, MINK_IS_SUM, text, "ooonf", &answer) == MINK_NULL) PG_RETURN_NULL();
  PG_RETURN_BOOL(answer.truth);
}

PG_FUNCTION_INFO_V1(mink_is_sum);
Datum mink_is_sum(PG_FUNCTION_ARGS) { return is_sum(fcinfo, false); }
PG_FUNCTION_INFO_V1(mink_is_sum_text);
Datum mink_is_sum_text(PG_FUNCTION_ARGS) { return is_sum(fcinfo, true); }
