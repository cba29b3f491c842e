-- NULL, empty sets, reference systems, and input that is refused, with SQLSTATE, detail and hint.
\pset format unaligned
\pset null NULL
SELECT mink_sum_text(NULL, 'POINT (1 1)'), mink_sum(NULL::geometry, 'POINT (1 1)'::geometry);
SELECT mink_union_agg(g), mink_sum_agg(g) FROM (VALUES (NULL::geometry)) AS s(g);
SELECT mink_sum_text('POLYGON EMPTY', 'POLYGON ((0 0, 1 0, 0 1, 0 0))');
SELECT ST_AsEWKT(mink_sum('SRID=4326;POINT (1 1)'::geometry, 'POINT (1 2)'::geometry));
\set SHOW_CONTEXT never
SELECT mink_sum('SRID=4326;POINT (1 1)'::geometry, 'SRID=3857;POINT (1 2)'::geometry);
\echo :LAST_ERROR_SQLSTATE
SELECT mink_erode_text('POLYGON ((0 0, 1 0, 0 1, 0 0))', 'POLYGON EMPTY');
\echo :LAST_ERROR_SQLSTATE
SELECT mink_sum_text('POLYGON ((0 0, 1 O, 0 1, 0 0))', 'POINT (1 1)');
\echo :LAST_ERROR_SQLSTATE
SELECT mink_sum('POINT Z (1 1 1)'::geometry, 'POINT (1 2)'::geometry);
\echo :LAST_ERROR_SQLSTATE
SELECT mink_sum('CIRCULARSTRING (0 0, 1 1, 2 0)'::geometry, 'POINT (1 2)'::geometry);
\echo :LAST_ERROR_SQLSTATE
SELECT mink_sum('POINT (1 1)'::geometry, 'POINT (1 2)'::geometry, 'odd');
\echo :LAST_ERROR_SQLSTATE
SELECT mink_sum('POINT (1 1)'::geometry, 'POINT (1 2)'::geometry, round => 'up');
\echo :LAST_ERROR_SQLSTATE
SELECT mink_sum('\x0101'::bytea, '\x01'::bytea);
\echo :LAST_ERROR_SQLSTATE
SELECT mink_offset('POINT (1 1)'::geometry, 'NaN');
\echo :LAST_ERROR_SQLSTATE
SELECT mink_is_sum_text('POINT (0 0)', 'POLYGON ((0 0, 4 4, 4 0, 0 4, 0 0))', 'POINT (0 0)');
\echo :LAST_ERROR_SQLSTATE
