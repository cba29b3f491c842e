-- Adds aggregates, and the check of sums.
\echo Use "ALTER EXTENSION minksum UPDATE TO '0.1.0'" to load this file. \quit

CREATE FUNCTION mink_is_sum(result bytea, p bytea, q bytea, within float8 DEFAULT 0,
  fill text DEFAULT 'automatic')
  RETURNS boolean
  AS 'MODULE_PATHNAME'
  LANGUAGE C IMMUTABLE STRICT PARALLEL SAFE COST 2000000;

COMMENT ON FUNCTION mink_is_sum(bytea, bytea, bytea, float8, text) IS
  'whether result is p ⊕ q, by another method; NULL if p ⊕ q is too large for a proof';

CREATE FUNCTION mink_is_sum_text(result text, p text, q text, within float8 DEFAULT 0,
  fill text DEFAULT 'automatic')
  RETURNS boolean
  AS 'MODULE_PATHNAME'
  LANGUAGE C IMMUTABLE STRICT PARALLEL SAFE COST 2000000;

COMMENT ON FUNCTION mink_is_sum_text(text, text, text, float8, text) IS
  'whether result is p ⊕ q, by another method; NULL if p ⊕ q is too large for a proof';

-- What aggregates are made of.

CREATE FUNCTION mink_save_state(state internal)
  RETURNS bytea
  AS 'MODULE_PATHNAME'
  LANGUAGE C IMMUTABLE STRICT PARALLEL SAFE COST 1000;

CREATE FUNCTION mink_load_state(saved bytea, unused internal)
  RETURNS internal
  AS 'MODULE_PATHNAME'
  LANGUAGE C IMMUTABLE STRICT PARALLEL SAFE COST 1000;

CREATE FUNCTION mink_union_combine(a internal, b internal)
  RETURNS internal
  AS 'MODULE_PATHNAME'
  LANGUAGE C IMMUTABLE PARALLEL SAFE COST 10000;

CREATE FUNCTION mink_union_step(state internal, a bytea)
  RETURNS internal
  AS 'MODULE_PATHNAME'
  LANGUAGE C IMMUTABLE PARALLEL SAFE COST 10000;

CREATE FUNCTION mink_union_finish(state internal)
  RETURNS bytea
  AS 'MODULE_PATHNAME'
  LANGUAGE C IMMUTABLE PARALLEL SAFE COST 10000;

CREATE AGGREGATE mink_union_agg(bytea) (
  SFUNC = mink_union_step, STYPE = internal, FINALFUNC = mink_union_finish,
  COMBINEFUNC = mink_union_combine, SERIALFUNC = mink_save_state,
  DESERIALFUNC = mink_load_state, PARALLEL = SAFE
);
COMMENT ON AGGREGATE mink_union_agg(bytea) IS
  'the union of all sets of a group';

CREATE FUNCTION mink_union_step_text(state internal, a text)
  RETURNS internal
  AS 'MODULE_PATHNAME'
  LANGUAGE C IMMUTABLE PARALLEL SAFE COST 10000;

CREATE FUNCTION mink_union_finish_text(state internal)
  RETURNS text
  AS 'MODULE_PATHNAME'
  LANGUAGE C IMMUTABLE PARALLEL SAFE COST 10000;

CREATE AGGREGATE mink_union_agg_text(text) (
  SFUNC = mink_union_step_text, STYPE = internal, FINALFUNC = mink_union_finish_text,
  COMBINEFUNC = mink_union_combine, SERIALFUNC = mink_save_state,
  DESERIALFUNC = mink_load_state, PARALLEL = SAFE
);
COMMENT ON AGGREGATE mink_union_agg_text(text) IS
  'the union of all sets of a group, exactly';

CREATE FUNCTION mink_sum_combine(a internal, b internal)
  RETURNS internal
  AS 'MODULE_PATHNAME'
  LANGUAGE C IMMUTABLE PARALLEL SAFE COST 10000;

CREATE FUNCTION mink_sum_step(state internal, a bytea)
  RETURNS internal
  AS 'MODULE_PATHNAME'
  LANGUAGE C IMMUTABLE PARALLEL SAFE COST 10000;

CREATE FUNCTION mink_sum_finish(state internal)
  RETURNS bytea
  AS 'MODULE_PATHNAME'
  LANGUAGE C IMMUTABLE PARALLEL SAFE COST 1000;

CREATE AGGREGATE mink_sum_agg(bytea) (
  SFUNC = mink_sum_step, STYPE = internal, FINALFUNC = mink_sum_finish,
  COMBINEFUNC = mink_sum_combine, SERIALFUNC = mink_save_state,
  DESERIALFUNC = mink_load_state, PARALLEL = SAFE
);
COMMENT ON AGGREGATE mink_sum_agg(bytea) IS
  'the sum of all sets of a group';

CREATE FUNCTION mink_sum_step_text(state internal, a text)
  RETURNS internal
  AS 'MODULE_PATHNAME'
  LANGUAGE C IMMUTABLE PARALLEL SAFE COST 10000;

CREATE FUNCTION mink_sum_finish_text(state internal)
  RETURNS text
  AS 'MODULE_PATHNAME'
  LANGUAGE C IMMUTABLE PARALLEL SAFE COST 1000;

CREATE AGGREGATE mink_sum_agg_text(text) (
  SFUNC = mink_sum_step_text, STYPE = internal, FINALFUNC = mink_sum_finish_text,
  COMBINEFUNC = mink_sum_combine, SERIALFUNC = mink_save_state,
  DESERIALFUNC = mink_load_state, PARALLEL = SAFE
);
COMMENT ON AGGREGATE mink_sum_agg_text(text) IS
  'the sum of all sets of a group, exactly';
