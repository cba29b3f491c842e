-- Each function once, on shapes that can be checked by hand: a square of 4, one of 1, and a bow tie.
\pset format unaligned
SELECT mink_sum_text('POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))',
    'POLYGON ((0 0, 1/3 0, 1/3 1, 0 1, 0 0))');
SELECT mink_erode_text('POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))',
    'POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))');
SELECT mink_open_text('POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))', 'POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))');
SELECT mink_close_text('POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))',
    'POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))');
SELECT mink_union_text('POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))',
    'POLYGON ((2 2, 6 2, 6 6, 2 6, 2 2))');
SELECT mink_intersection_text('POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))',
    'POLYGON ((2 2, 6 2, 6 6, 2 6, 2 2))');
SELECT mink_difference_text('POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))',
    'POLYGON ((2 2, 6 2, 6 6, 2 6, 2 2))');
SELECT mink_sym_difference_text('POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))',
    'POLYGON ((2 2, 6 2, 6 6, 2 6, 2 2))');
SELECT mink_resolve_text('POLYGON ((0 0, 4 4, 4 0, 0 4, 0 0))');
SELECT mink_offset_text('POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))', '1/3', join_style => 'miter');
SELECT mink_no_fit_polygon_text('POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))',
    'POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))');
SELECT mink_inner_fit_polygon_text('POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))',
                                   'POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))');
SELECT * FROM mink_depth_text('POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))',
    'POLYGON ((3 1, 6 1, 6 2, 3 2, 3 1))');
SELECT mink_impact_text('POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))',
    'POLYGON ((6 1, 7 1, 7 2, 6 2, 6 1))', -4, 0);
SELECT mink_is_sum_text('POLYGON ((0 0, 5 0, 5 5, 0 5, 0 0))',
    'POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))',
                        'POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))');
SELECT mink_union_agg_text(a) FROM (VALUES ('POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))'),
                                           ('POLYGON ((2 0, 4 0, 4 2, 2 2, 2 0))')) AS s(a);
SELECT mink_sum_agg_text(a) FROM (VALUES ('POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))'),
                                         ('LINESTRING (0 0, 1 0)'), ('POINT (1 1)')) AS s(a);

-- The same on geometries.
CREATE TEMPORARY TABLE shapes AS
  SELECT 'POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))'::geometry AS a,
         'POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))'::geometry AS b,
         'POLYGON ((2 2, 6 2, 6 6, 2 6, 2 2))'::geometry AS c;
SELECT ST_AsText(mink_sum(a, b)), ST_AsText(mink_erode(a, b)) FROM shapes;
SELECT ST_AsText(mink_open(a, b)), ST_AsText(mink_close(a, b)) FROM shapes;
SELECT ST_AsText(mink_union(a, c)), ST_AsText(mink_intersection(a, c)) FROM shapes;
SELECT ST_AsText(mink_difference(a, c)), ST_AsText(mink_sym_difference(a, c)) FROM shapes;
SELECT ST_AsText(mink_resolve(a)), ST_AsText(mink_offset(a, 1, 'miter')) FROM shapes;
SELECT ST_AsText(mink_no_fit_polygon(a, b)), ST_AsText(mink_inner_fit_polygon(a, b)) FROM shapes;
SELECT ST_AsText(mink_no_fit_polygon(a, b, 'POINT (1 1)'::geometry)),
       ST_AsText(mink_inner_fit_polygon(a, b, 'POINT (1 1)'::geometry)) FROM shapes;
SELECT (mink_depth(a, c)).*, mink_impact(a, c, 1, 0) FROM shapes;
SELECT mink_is_sum(mink_sum(a, b), a, b), mink_is_sum(c, a, b) FROM shapes;
SELECT slice, degrees, ST_Area(blocked), ST_Area(free)
  FROM shapes, mink_slices(b, a, 4, true) ORDER BY slice;
SELECT fixed, fixed_turn, moving, moving_turn, ST_Area(polygon)
  FROM shapes, mink_no_fit_table(ARRAY[a, b], 1) ORDER BY 1, 2, 3, 4;
SELECT ST_AsText(mink_union_agg(g)), ST_AsText(mink_sum_agg(g))
  FROM (SELECT a AS g FROM shapes UNION ALL SELECT c FROM shapes) AS s;

-- And on EWKB.
SELECT encode(mink_sum(a::bytea, b::bytea), 'hex') = encode(ST_AsEWKB(mink_sum(a, b)), 'hex')
  FROM shapes;
SELECT ST_NPoints(mink_disc(1, 0.1)::geometry) > 8, ST_Area(mink_disc(1, 0.01, 'inside')::geometry)
  < pi(), ST_Area(mink_disc(1, 0.01, 'outside')::geometry) > pi();
