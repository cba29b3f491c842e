-- The functions of minksum on geometries. All but aggregates can be inlined.
\echo Use "CREATE EXTENSION minksum_postgis" to load this file. \quit

CREATE FUNCTION mink_sum(a geometry, b geometry,
  fill text DEFAULT 'automatic', round text DEFAULT 'nearest')
  RETURNS geometry
  LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE COST 10000
  RETURN mink_sum(a::bytea, b::bytea, fill, round)::geometry;
COMMENT ON FUNCTION mink_sum(geometry, geometry, text, text) IS
  'a ⊕ b, all sums of a point of a and a point of b';

CREATE FUNCTION mink_erode(a geometry, b geometry,
  fill text DEFAULT 'automatic', round text DEFAULT 'nearest')
  RETURNS geometry
  LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE COST 20000
  RETURN mink_erode(a::bytea, b::bytea, fill, round)::geometry;
COMMENT ON FUNCTION mink_erode(geometry, geometry, text, text) IS
  'a ⊖ b, all places at which b lies inside a';

CREATE FUNCTION mink_open(a geometry, b geometry,
  fill text DEFAULT 'automatic', round text DEFAULT 'nearest')
  RETURNS geometry
  LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE COST 60000
  RETURN mink_open(a::bytea, b::bytea, fill, round)::geometry;
COMMENT ON FUNCTION mink_open(geometry, geometry, text, text) IS
  'the union of all translates of b inside a';

CREATE FUNCTION mink_close(a geometry, b geometry,
  fill text DEFAULT 'automatic', round text DEFAULT 'nearest')
  RETURNS geometry
  LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE COST 70000
  RETURN mink_close(a::bytea, b::bytea, fill, round)::geometry;
COMMENT ON FUNCTION mink_close(geometry, geometry, text, text) IS
  'a ⊕ b eroded by b, which contains a';

CREATE FUNCTION mink_union(a geometry, b geometry,
  fill text DEFAULT 'automatic', round text DEFAULT 'nearest')
  RETURNS geometry
  LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE COST 10000
  RETURN mink_union(a::bytea, b::bytea, fill, round)::geometry;
COMMENT ON FUNCTION mink_union(geometry, geometry, text, text) IS
  'what lies in a or in b';

CREATE FUNCTION mink_intersection(a geometry, b geometry,
  fill text DEFAULT 'automatic', round text DEFAULT 'nearest')
  RETURNS geometry
  LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE COST 10000
  RETURN mink_intersection(a::bytea, b::bytea, fill, round)::geometry;
COMMENT ON FUNCTION mink_intersection(geometry, geometry, text, text) IS
  'the area that lies in both';

CREATE FUNCTION mink_difference(a geometry, b geometry,
  fill text DEFAULT 'automatic', round text DEFAULT 'nearest')
  RETURNS geometry
  LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE COST 10000
  RETURN mink_difference(a::bytea, b::bytea, fill, round)::geometry;
COMMENT ON FUNCTION mink_difference(geometry, geometry, text, text) IS
  'the area that lies in a and not in b';

CREATE FUNCTION mink_sym_difference(a geometry, b geometry,
  fill text DEFAULT 'automatic', round text DEFAULT 'nearest')
  RETURNS geometry
  LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE COST 10000
  RETURN mink_sym_difference(a::bytea, b::bytea, fill, round)::geometry;
COMMENT ON FUNCTION mink_sym_difference(geometry, geometry, text, text) IS
  'the area that lies in exactly one of both';

CREATE FUNCTION mink_resolve(a geometry,
  fill text DEFAULT 'automatic', round text DEFAULT 'nearest')
  RETURNS geometry
  LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE COST 7000
  RETURN mink_resolve(a::bytea, fill, round)::geometry;
COMMENT ON FUNCTION mink_resolve(geometry, text, text) IS
  'the set that the rings of a mean by a fill rule';

CREATE FUNCTION mink_offset(a geometry, distance float8, join_style text DEFAULT 'round',
  cap_style text DEFAULT 'round',
  miter_limit float8 DEFAULT 2, tolerance float8 DEFAULT 0, side text DEFAULT 'nearest',
  fill text DEFAULT 'automatic', round text DEFAULT 'nearest')
  RETURNS geometry
  LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE COST 25000
  RETURN mink_offset(a::bytea, distance, join_style, cap_style, miter_limit, tolerance, side,
    fill, round)::geometry;
COMMENT ON FUNCTION mink_offset(geometry, float8, text, text, float8, float8, text, text, text) IS
  'a grown by the distance, or shrunk if it is negative; tolerance 0 means distance/1000';

CREATE FUNCTION mink_no_fit_polygon(fixed geometry, moving geometry,
  fill text DEFAULT 'automatic', round text DEFAULT 'nearest')
  RETURNS geometry
  LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE COST 30000
  RETURN mink_no_fit_polygon(fixed::bytea, moving::bytea, fill, round)::geometry;
COMMENT ON FUNCTION mink_no_fit_polygon(geometry, geometry, text, text) IS
  'where the reference point of moving may not be: both parts touch or overlap';

CREATE FUNCTION mink_no_fit_polygon(fixed geometry, moving geometry, reference geometry,
  fill text DEFAULT 'automatic',
  round text DEFAULT 'nearest')
  RETURNS geometry
  LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE COST 30000
  RETURN mink_no_fit_polygon(fixed::bytea, moving::bytea, reference::bytea, fill, round)::geometry;
COMMENT ON FUNCTION mink_no_fit_polygon(geometry, geometry, geometry, text, text) IS
  'where the reference point of moving may not be: both parts touch or overlap';

CREATE FUNCTION mink_inner_fit_polygon(bin geometry, part geometry,
  fill text DEFAULT 'automatic', round text DEFAULT 'nearest')
  RETURNS geometry
  LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE COST 50000
  RETURN mink_inner_fit_polygon(bin::bytea, part::bytea, fill, round)::geometry;
COMMENT ON FUNCTION mink_inner_fit_polygon(geometry, geometry, text, text) IS
  'where the reference point of part may be: the part lies inside the bin';

CREATE FUNCTION mink_inner_fit_polygon(bin geometry, part geometry, reference geometry,
  fill text DEFAULT 'automatic',
  round text DEFAULT 'nearest')
  RETURNS geometry
  LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE COST 50000
  RETURN mink_inner_fit_polygon(bin::bytea, part::bytea, reference::bytea, fill, round)::geometry;
COMMENT ON FUNCTION mink_inner_fit_polygon(geometry, geometry, geometry, text, text) IS
  'where the reference point of part may be: the part lies inside the bin';

CREATE FUNCTION mink_depth(a geometry, b geometry,
  fill text DEFAULT 'automatic',
  OUT overlapping boolean, OUT distance float8, OUT dx float8, OUT dy float8,
  OUT squared text)
  RETURNS record
  LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE COST 150000
  RETURN mink_depth(a::bytea, b::bytea, fill);
COMMENT ON FUNCTION mink_depth(geometry, geometry, text) IS
  'whether a and b overlap, and the shortest move of b after which they touch';

CREATE FUNCTION mink_impact(a geometry, b geometry, dx float8, dy float8,
  fill text DEFAULT 'automatic')
  RETURNS float8
  LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE COST 15000
  RETURN mink_impact(a::bytea, b::bytea, dx, dy, fill);
COMMENT ON FUNCTION mink_impact(geometry, geometry, float8, float8, text) IS
  'the least factor of (dx, dy) by which b moves until it meets a; NULL if never';

CREATE FUNCTION mink_is_sum(result geometry, p geometry, q geometry,
  within float8 DEFAULT 0, fill text DEFAULT 'automatic')
  RETURNS boolean
  LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE COST 2000000
  RETURN mink_is_sum(result::bytea, p::bytea, q::bytea, within, fill);
COMMENT ON FUNCTION mink_is_sum(geometry, geometry, geometry, float8, text) IS
  'whether result is p ⊕ q, by another method; NULL if p ⊕ q is too large for a proof';

CREATE FUNCTION mink_slices(robot geometry, obstacles geometry, angles integer,
  with_free boolean DEFAULT false, fill text DEFAULT 'automatic', round text DEFAULT 'nearest',
  OUT slice integer, OUT degrees float8, OUT blocked geometry, OUT free geometry)
  RETURNS SETOF record
  LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE COST 30000 ROWS 72
BEGIN ATOMIC
  SELECT s.slice, s.degrees, s.blocked::geometry, s.free::geometry
  FROM mink_slices(robot::bytea, obstacles::bytea, angles, with_free, fill, round) AS s;
END;
COMMENT ON FUNCTION mink_slices(geometry, geometry, integer, boolean, text, text) IS
  'where the origin of the robot may not be among obstacles, for each angle of the robot';

CREATE FUNCTION mink_no_fit_table(parts geometry[], turns integer DEFAULT 4,
  fill text DEFAULT 'automatic', round text DEFAULT 'nearest',
  OUT fixed integer, OUT fixed_turn integer, OUT moving integer, OUT moving_turn integer,
  OUT polygon geometry)
  RETURNS SETOF record
  LANGUAGE sql IMMUTABLE STRICT PARALLEL SAFE COST 10000 ROWS 1000
BEGIN ATOMIC
  SELECT t.fixed, t.fixed_turn, t.moving, t.moving_turn, t.polygon::geometry
  FROM mink_no_fit_table(parts::bytea[], turns, fill, round) AS t;
END;
COMMENT ON FUNCTION mink_no_fit_table(geometry[], integer, text, text) IS
  'the no-fit polygons of all pairs of parts in 1, 2 or 4 directions';

-- The module converts geometries by the casts of PostGIS.
CREATE FUNCTION mink_union_step(state internal, a geometry)
  RETURNS internal
  AS '$libdir/minksum', 'mink_union_step'
  LANGUAGE C IMMUTABLE PARALLEL SAFE COST 10000;

CREATE FUNCTION mink_union_finish_geometry(state internal)
  RETURNS geometry
  AS '$libdir/minksum', 'mink_union_finish'
  LANGUAGE C IMMUTABLE PARALLEL SAFE COST 10000;

CREATE AGGREGATE mink_union_agg(geometry) (
  SFUNC = mink_union_step, STYPE = internal, FINALFUNC = mink_union_finish_geometry,
  COMBINEFUNC = mink_union_combine, SERIALFUNC = mink_save_state, DESERIALFUNC = mink_load_state,
  PARALLEL = SAFE
);
COMMENT ON AGGREGATE mink_union_agg(geometry) IS
  'the union of all sets of a group';

CREATE FUNCTION mink_sum_step(state internal, a geometry)
  RETURNS internal
  AS '$libdir/minksum', 'mink_sum_step'
  LANGUAGE C IMMUTABLE PARALLEL SAFE COST 10000;

CREATE FUNCTION mink_sum_finish_geometry(state internal)
  RETURNS geometry
  AS '$libdir/minksum', 'mink_sum_finish'
  LANGUAGE C IMMUTABLE PARALLEL SAFE COST 1000;

CREATE AGGREGATE mink_sum_agg(geometry) (
  SFUNC = mink_sum_step, STYPE = internal, FINALFUNC = mink_sum_finish_geometry,
  COMBINEFUNC = mink_sum_combine, SERIALFUNC = mink_save_state, DESERIALFUNC = mink_load_state,
  PARALLEL = SAFE
);
COMMENT ON AGGREGATE mink_sum_agg(geometry) IS
  'the sum of all sets of a group';
