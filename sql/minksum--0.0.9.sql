-- Functions on EWKB (bytea), and on exact WKT (text).
\echo Use "CREATE EXTENSION minksum" to load this file. \quit

CREATE FUNCTION mink_sum(a bytea, b bytea,
  fill text DEFAULT 'automatic', round text DEFAULT 'nearest')
  RETURNS bytea
  AS 'MODULE_PATHNAME'
  LANGUAGE C IMMUTABLE STRICT PARALLEL SAFE COST 10000;
COMMENT ON FUNCTION mink_sum(bytea, bytea, text, text) IS
  'a ⊕ b, all sums of a point of a and a point of b';

CREATE FUNCTION mink_sum_text(a text, b text, fill text DEFAULT 'automatic')
  RETURNS text
  AS 'MODULE_PATHNAME'
  LANGUAGE C IMMUTABLE STRICT PARALLEL SAFE COST 10000;
COMMENT ON FUNCTION mink_sum_text(text, text, text) IS
  'a ⊕ b, all sums of a point of a and a point of b, exactly';

CREATE FUNCTION mink_erode(a bytea, b bytea,
  fill text DEFAULT 'automatic', round text DEFAULT 'nearest')
  RETURNS bytea
  AS 'MODULE_PATHNAME'
  LANGUAGE C IMMUTABLE STRICT PARALLEL SAFE COST 20000;
COMMENT ON FUNCTION mink_erode(bytea, bytea, text, text) IS
  'a ⊖ b, all places at which b lies inside a';

CREATE FUNCTION mink_erode_text(a text, b text, fill text DEFAULT 'automatic')
  RETURNS text
  AS 'MODULE_PATHNAME'
  LANGUAGE C IMMUTABLE STRICT PARALLEL SAFE COST 20000;
COMMENT ON FUNCTION mink_erode_text(text, text, text) IS
  'a ⊖ b, all places at which b lies inside a, exactly';

CREATE FUNCTION mink_open(a bytea, b bytea,
  fill text DEFAULT 'automatic', round text DEFAULT 'nearest')
  RETURNS bytea
  AS 'MODULE_PATHNAME'
  LANGUAGE C IMMUTABLE STRICT PARALLEL SAFE COST 60000;
COMMENT ON FUNCTION mink_open(bytea, bytea, text, text) IS
  'the union of all translates of b inside a';

CREATE FUNCTION mink_open_text(a text, b text, fill text DEFAULT 'automatic')
  RETURNS text
  AS 'MODULE_PATHNAME'
  LANGUAGE C IMMUTABLE STRICT PARALLEL SAFE COST 60000;
COMMENT ON FUNCTION mink_open_text(text, text, text) IS
  'the union of all translates of b inside a, exactly';

CREATE FUNCTION mink_close(a bytea, b bytea,
  fill text DEFAULT 'automatic', round text DEFAULT 'nearest')
  RETURNS bytea
  AS 'MODULE_PATHNAME'
  LANGUAGE C IMMUTABLE STRICT PARALLEL SAFE COST 70000;
COMMENT ON FUNCTION mink_close(bytea, bytea, text, text) IS
  'a ⊕ b eroded by b, which contains a';

CREATE FUNCTION mink_close_text(a text, b text, fill text DEFAULT 'automatic')
  RETURNS text
  AS 'MODULE_PATHNAME'
  LANGUAGE C IMMUTABLE STRICT PARALLEL SAFE COST 70000;
COMMENT ON FUNCTION mink_close_text(text, text, text) IS
  'a ⊕ b eroded by b, which contains a, exactly';

CREATE FUNCTION mink_union(a bytea, b bytea,
  fill text DEFAULT 'automatic', round text DEFAULT 'nearest')
  RETURNS bytea
  AS 'MODULE_PATHNAME'
  LANGUAGE C IMMUTABLE STRICT PARALLEL SAFE COST 10000;
COMMENT ON FUNCTION mink_union(bytea, bytea, text, text) IS
  'what lies in a or in b';

CREATE FUNCTION mink_union_text(a text, b text, fill text DEFAULT 'automatic')
  RETURNS text
  AS 'MODULE_PATHNAME'
  LANGUAGE C IMMUTABLE STRICT PARALLEL SAFE COST 10000;
COMMENT ON FUNCTION mink_union_text(text, text, text) IS
  'what lies in a or in b, exactly';

CREATE FUNCTION mink_intersection(a bytea, b bytea,
  fill text DEFAULT 'automatic', round text DEFAULT 'nearest')
  RETURNS bytea
  AS 'MODULE_PATHNAME'
  LANGUAGE C IMMUTABLE STRICT PARALLEL SAFE COST 10000;
COMMENT ON FUNCTION mink_intersection(bytea, bytea, text, text) IS
  'the area that lies in both';

CREATE FUNCTION mink_intersection_text(a text, b text, fill text DEFAULT 'automatic')
  RETURNS text
  AS 'MODULE_PATHNAME'
  LANGUAGE C IMMUTABLE STRICT PARALLEL SAFE COST 10000;
COMMENT ON FUNCTION mink_intersection_text(text, text, text) IS
  'the area that lies in both, exactly';

CREATE FUNCTION mink_difference(a bytea, b bytea,
  fill text DEFAULT 'automatic', round text DEFAULT 'nearest')
  RETURNS bytea
  AS 'MODULE_PATHNAME'
  LANGUAGE C IMMUTABLE STRICT PARALLEL SAFE COST 10000;
COMMENT ON FUNCTION mink_difference(bytea, bytea, text, text) IS
  'the area that lies in a and not in b';

CREATE FUNCTION mink_difference_text(a text, b text, fill text DEFAULT 'automatic')
  RETURNS text
  AS 'MODULE_PATHNAME'
  LANGUAGE C IMMUTABLE STRICT PARALLEL SAFE COST 10000;
COMMENT ON FUNCTION mink_difference_text(text, text, text) IS
  'the area that lies in a and not in b, exactly';

CREATE FUNCTION mink_sym_difference(a bytea, b bytea,
  fill text DEFAULT 'automatic', round text DEFAULT 'nearest')
  RETURNS bytea
  AS 'MODULE_PATHNAME'
  LANGUAGE C IMMUTABLE STRICT PARALLEL SAFE COST 10000;
COMMENT ON FUNCTION mink_sym_difference(bytea, bytea, text, text) IS
  'the area that lies in exactly one of both';

CREATE FUNCTION mink_sym_difference_text(a text, b text, fill text DEFAULT 'automatic')
  RETURNS text
  AS 'MODULE_PATHNAME'
  LANGUAGE C IMMUTABLE STRICT PARALLEL SAFE COST 10000;
COMMENT ON FUNCTION mink_sym_difference_text(text, text, text) IS
  'the area that lies in exactly one of both, exactly';

CREATE FUNCTION mink_resolve(a bytea, fill text DEFAULT 'automatic', round text DEFAULT 'nearest')
  RETURNS bytea
  AS 'MODULE_PATHNAME'
  LANGUAGE C IMMUTABLE STRICT PARALLEL SAFE COST 7000;
COMMENT ON FUNCTION mink_resolve(bytea, text, text) IS
  'the set that the rings of a mean by a fill rule';

CREATE FUNCTION mink_resolve_text(a text, fill text DEFAULT 'automatic')
  RETURNS text
  AS 'MODULE_PATHNAME'
  LANGUAGE C IMMUTABLE STRICT PARALLEL SAFE COST 7000;
COMMENT ON FUNCTION mink_resolve_text(text, text) IS
  'the set that the rings of a mean by a fill rule, exactly';

CREATE FUNCTION mink_offset(a bytea, distance float8, join_style text DEFAULT 'round',
  cap_style text DEFAULT 'round',
  miter_limit float8 DEFAULT 2, tolerance float8 DEFAULT 0, side text DEFAULT 'nearest',
  fill text DEFAULT 'automatic', round text DEFAULT 'nearest')
  RETURNS bytea
  AS 'MODULE_PATHNAME'
  LANGUAGE C IMMUTABLE STRICT PARALLEL SAFE COST 25000;
COMMENT ON FUNCTION mink_offset(bytea, float8, text, text, float8, float8, text, text, text) IS
  'a grown by the distance, or shrunk if it is negative; tolerance 0 means distance/1000';

CREATE FUNCTION mink_offset_text(a text, distance text, join_style text DEFAULT 'round',
  cap_style text DEFAULT 'round',
  miter_limit float8 DEFAULT 2, tolerance float8 DEFAULT 0, side text DEFAULT 'nearest',
  fill text DEFAULT 'automatic')
  RETURNS text
  AS 'MODULE_PATHNAME'
  LANGUAGE C IMMUTABLE STRICT PARALLEL SAFE COST 25000;
COMMENT ON FUNCTION mink_offset_text(text, text, text, text, float8, float8, text, text) IS
  'a grown by the distance, or shrunk if it is negative, exactly';

CREATE FUNCTION mink_disc(radius float8, tolerance float8 DEFAULT 0,
  side text DEFAULT 'nearest', round text DEFAULT 'nearest')
  RETURNS bytea
  AS 'MODULE_PATHNAME'
  LANGUAGE C IMMUTABLE STRICT PARALLEL SAFE COST 10000;
COMMENT ON FUNCTION mink_disc(float8, float8, text, text) IS
  'a polygon for the disc around the origin; tolerance 0 means radius/1000';

CREATE FUNCTION mink_no_fit_polygon(fixed bytea, moving bytea,
  fill text DEFAULT 'automatic', round text DEFAULT 'nearest')
  RETURNS bytea
  AS 'MODULE_PATHNAME'
  LANGUAGE C IMMUTABLE STRICT PARALLEL SAFE COST 30000;
COMMENT ON FUNCTION mink_no_fit_polygon(bytea, bytea, text, text) IS
  'where the reference point of moving may not be: both parts touch or overlap';

CREATE FUNCTION mink_no_fit_polygon(fixed bytea, moving bytea, reference bytea,
  fill text DEFAULT 'automatic',
  round text DEFAULT 'nearest')
  RETURNS bytea
  AS 'MODULE_PATHNAME', 'mink_no_fit_polygon_at'
  LANGUAGE C IMMUTABLE STRICT PARALLEL SAFE COST 30000;
COMMENT ON FUNCTION mink_no_fit_polygon(bytea, bytea, bytea, text, text) IS
  'where the reference point of moving may not be: both parts touch or overlap';

CREATE FUNCTION mink_no_fit_polygon_text(fixed text, moving text, fill text DEFAULT 'automatic')
  RETURNS text
  AS 'MODULE_PATHNAME'
  LANGUAGE C IMMUTABLE STRICT PARALLEL SAFE COST 30000;
COMMENT ON FUNCTION mink_no_fit_polygon_text(text, text, text) IS
  'where the reference point of moving may not be: both parts touch or overlap, exactly';

CREATE FUNCTION mink_inner_fit_polygon(bin bytea, part bytea,
  fill text DEFAULT 'automatic', round text DEFAULT 'nearest')
  RETURNS bytea
  AS 'MODULE_PATHNAME'
  LANGUAGE C IMMUTABLE STRICT PARALLEL SAFE COST 50000;
COMMENT ON FUNCTION mink_inner_fit_polygon(bytea, bytea, text, text) IS
  'where the reference point of part may be: the part lies inside the bin';

CREATE FUNCTION mink_inner_fit_polygon(bin bytea, part bytea, reference bytea,
  fill text DEFAULT 'automatic',
  round text DEFAULT 'nearest')
  RETURNS bytea
  AS 'MODULE_PATHNAME', 'mink_inner_fit_polygon_at'
  LANGUAGE C IMMUTABLE STRICT PARALLEL SAFE COST 50000;
COMMENT ON FUNCTION mink_inner_fit_polygon(bytea, bytea, bytea, text, text) IS
  'where the reference point of part may be: the part lies inside the bin';

CREATE FUNCTION mink_inner_fit_polygon_text(bin text, part text, fill text DEFAULT 'automatic')
  RETURNS text
  AS 'MODULE_PATHNAME'
  LANGUAGE C IMMUTABLE STRICT PARALLEL SAFE COST 50000;
COMMENT ON FUNCTION mink_inner_fit_polygon_text(text, text, text) IS
  'where the reference point of part may be: the part lies inside the bin, exactly';

CREATE FUNCTION mink_depth(a bytea, b bytea,
  fill text DEFAULT 'automatic',
  OUT overlapping boolean, OUT distance float8, OUT dx float8, OUT dy float8,
  OUT squared text)
  RETURNS record
  AS 'MODULE_PATHNAME'
  LANGUAGE C IMMUTABLE STRICT PARALLEL SAFE COST 150000;
COMMENT ON FUNCTION mink_depth(bytea, bytea, text) IS
  'whether a and b overlap, and the shortest move of b after which they touch';

CREATE FUNCTION mink_impact(a bytea, b bytea, dx float8, dy float8, fill text DEFAULT 'automatic')
  RETURNS float8
  AS 'MODULE_PATHNAME'
  LANGUAGE C IMMUTABLE STRICT PARALLEL SAFE COST 15000;
COMMENT ON FUNCTION mink_impact(bytea, bytea, float8, float8, text) IS
  'the least factor of (dx, dy) by which b moves until it meets a; NULL if never';

CREATE FUNCTION mink_depth_text(a text, b text,
  fill text DEFAULT 'automatic',
  OUT overlapping boolean, OUT distance float8, OUT dx float8, OUT dy float8,
  OUT squared text)
  RETURNS record
  AS 'MODULE_PATHNAME'
  LANGUAGE C IMMUTABLE STRICT PARALLEL SAFE COST 150000;
COMMENT ON FUNCTION mink_depth_text(text, text, text) IS
  'whether a and b overlap, and the shortest move of b after which they touch';

CREATE FUNCTION mink_impact_text(a text, b text, dx float8, dy float8,
  fill text DEFAULT 'automatic')
  RETURNS float8
  AS 'MODULE_PATHNAME'
  LANGUAGE C IMMUTABLE STRICT PARALLEL SAFE COST 15000;
COMMENT ON FUNCTION mink_impact_text(text, text, float8, float8, text) IS
  'the least factor of (dx, dy) by which b moves until it meets a; NULL if never';

CREATE FUNCTION mink_slices(robot bytea, obstacles bytea, angles integer,
  with_free boolean DEFAULT false, fill text DEFAULT 'automatic', round text DEFAULT 'nearest',
  OUT slice integer, OUT degrees float8, OUT blocked bytea, OUT free bytea)
  RETURNS SETOF record
  AS 'MODULE_PATHNAME'
  LANGUAGE C IMMUTABLE STRICT PARALLEL SAFE COST 30000 ROWS 72;
COMMENT ON FUNCTION mink_slices(bytea, bytea, integer, boolean, text, text) IS
  'where the origin of the robot may not be among obstacles, for each angle of the robot';

CREATE FUNCTION mink_no_fit_table(parts bytea[], turns integer DEFAULT 4,
  fill text DEFAULT 'automatic',
  round text DEFAULT 'nearest', OUT fixed integer, OUT fixed_turn integer,
  OUT moving integer, OUT moving_turn integer, OUT polygon bytea)
  RETURNS SETOF record
  AS 'MODULE_PATHNAME'
  LANGUAGE C IMMUTABLE STRICT PARALLEL SAFE COST 10000 ROWS 1000;
COMMENT ON FUNCTION mink_no_fit_table(bytea[], integer, text, text) IS
  'the no-fit polygons of all pairs of parts in 1, 2 or 4 directions';
