/* Calls the operations of the C interface, and compares the results with the expected ones. */
#include <math.h>
#include <minksum_c.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int failures = 0;

static void expect(int good, const char *what, int line) {
  if (good) return;
  printf("line %d: not so: %s\n", line, what);
  ++failures;
}
#define EXPECT(condition) expect(condition, #condition, __LINE__)

static minksum_error error;

/* Expects that the exact WKT of a geometry is `wkt`. Frees the geometry. */
static void expect_wkt(minksum_status status, minksum_geometry *geometry, const char *wkt,
                       int line) {
  char *text = NULL;
  if (status != MINKSUM_OK) {
    printf("line %d: failed: %s\n", line, error.message);
    ++failures;
    return;
  }
  expect(minksum_write(geometry, MINKSUM_WKT, MINKSUM_EXACT, 0, &text, NULL, &error) == MINKSUM_OK,
         "writing works", line);
  if (text == NULL || strcmp(text, wkt) != 0) {
    printf("line %d: %s\n     not %s\n", line, text == NULL ? "nothing" : text, wkt);
    ++failures;
  }
  minksum_text_free(text);
  minksum_geometry_free(geometry);
}
#define EXPECT_WKT(call, wkt)                \
  do {                                       \
    const minksum_status status = call;      \
    expect_wkt(status, out, wkt, __LINE__);  \
    out = NULL;                              \
  } while (0)

static minksum_geometry *read(const char *wkt) {
  minksum_geometry *geometry = NULL;
  if (minksum_read(wkt, strlen(wkt), &geometry, &error) != MINKSUM_OK) {
    printf("%s: %s\n", wkt, error.message);
    exit(1);
  }
  return geometry;
}

static int stop_at_once(void* calls, minksum_stage stage, size_t done, size_t parts) {
  EXPECT(stage == MINKSUM_STAGE_OPERANDS && done == 0 && parts == 1);
  ++*(int *)calls;
  return 1;
}

/* Remembers how many parts there are. */
static int count_parts(void* most, minksum_stage stage, size_t done, size_t parts) {
  EXPECT(stage <= MINKSUM_STAGE_SEARCH && done <= parts);
  if (parts > *(size_t*)most) *(size_t*)most = parts;
  return 0;
}

static void test_geometries(void) {
  const double square[] = {0, 0, 2, 0, 2, 2, 0, 2};
  const double with_hole[] = {0, 0, 9, 0, 0, 9, 1, 1, 1, 2, 2, 1};
  const int64_t rings[] = {0, 3, 6};
  const int64_t polygons[] = {0, 2};
  const int64_t bad[] = {0, 7, 6};
  const double path[] = {10, 10, 12, 10.5};
  const double no_number[] = {1, 2, 3, NAN};
  const int64_t negative[] = {0, -1};
  double xy[12];
  int64_t ring_offsets[3];
  int64_t polygon_offsets[2];
  int64_t line_offsets[2];
  minksum_geometry *out = NULL;
  minksum_geometry *copy = NULL;
  EXPECT_WKT(minksum_geometry_empty(&out, &error), "POLYGON EMPTY");
  EXPECT_WKT(minksum_geometry_polygon(square, 4, &out, &error),
             "POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))");
  EXPECT(minksum_geometry_polygons(with_hole, bad, 2, polygons, 1, &out, &error) ==
         MINKSUM_BAD_INPUT);
  EXPECT(out == NULL && strstr(error.message, "ring offsets") != NULL);
  EXPECT(minksum_geometry_polygons(with_hole, rings, 2, polygons, 1, &out, &error) == MINKSUM_OK);
  EXPECT(minksum_geometry_add_polyline(out, path, 2, &error) == MINKSUM_OK);
  EXPECT(minksum_geometry_add_polyline(out, path, 1, &error) == MINKSUM_BAD_INPUT);
  EXPECT(minksum_geometry_add_points(out, path, 1, &error) == MINKSUM_OK);
  EXPECT(minksum_geometry_copy(out, &copy, &error) == MINKSUM_OK);
  EXPECT(minksum_geometry_equal(out, copy));
  minksum_geometry_free(out);
  const minksum_counts counts = minksum_geometry_counts(copy);
  EXPECT(counts.polygons == 1 && counts.rings == 2 && counts.vertices == 6);
  EXPECT(counts.polylines == 1 && counts.polyline_vertices == 2 && counts.points == 1);
  EXPECT(minksum_geometry_get_polygons(copy, xy, ring_offsets, polygon_offsets, &error) ==
         MINKSUM_OK);
  EXPECT(memcmp(xy, with_hole, sizeof with_hole) == 0);
  EXPECT(memcmp(ring_offsets, rings, sizeof rings) == 0);
  EXPECT(memcmp(polygon_offsets, polygons, sizeof polygons) == 0);
  EXPECT(minksum_geometry_get_polylines(copy, xy, line_offsets, &error) == MINKSUM_OK);
  EXPECT(memcmp(xy, path, sizeof path) == 0 && line_offsets[0] == 0 && line_offsets[1] == 2);
  EXPECT(minksum_geometry_get_points(copy, xy, &error) == MINKSUM_OK);
  EXPECT(minksum_geometry_get_points(copy, NULL, &error) == MINKSUM_BAD_INPUT);
  EXPECT(minksum_geometry_add_points(copy, xy, SIZE_MAX, &error) == MINKSUM_BAD_INPUT);
  EXPECT(minksum_geometry_polygon(xy, SIZE_MAX / 2, &out, &error) == MINKSUM_BAD_INPUT);
  EXPECT(strstr(error.message, "more points") != NULL && out == NULL);
  EXPECT(minksum_geometry_polygons(xy, negative, 1, polygons, 1, &out, &error) ==
         MINKSUM_BAD_INPUT);
  EXPECT(strstr(error.message, "negative") != NULL);
  EXPECT(minksum_geometry_add_points(copy, no_number, 2, &error) == MINKSUM_BAD_INPUT);
  EXPECT(error.vertex == 1);
  EXPECT(minksum_geometry_counts(NULL).points == 0 && !minksum_geometry_equal(copy, NULL));
  EXPECT(xy[0] == 10 && xy[1] == 10);
  minksum_geometry_free(copy);
  minksum_geometry_free(NULL);
  EXPECT(minksum_read("POLYGON ((0 0, 1 O))", 20, &out, &error) == MINKSUM_BAD_INPUT);
  EXPECT(error.line == 1 && error.column == 18 && out == NULL);
  EXPECT(minksum_read(NULL, 0, &out, NULL) == MINKSUM_BAD_INPUT);
  EXPECT(strlen(minksum_version()) >= 5);
}

static void test_binary(void) {
  minksum_geometry *tile = read("POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))"), *out = NULL;
  char *bytes = NULL;
  size_t length = 0;
  EXPECT(minksum_write(tile, MINKSUM_WKB, MINKSUM_DOUBLES, 0, &bytes, &length, NULL) == MINKSUM_OK);
  EXPECT(length == 93);
  EXPECT_WKT(minksum_read(bytes, length, &out, &error), "POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))");
  minksum_text_free(bytes);
  EXPECT(minksum_write(tile, MINKSUM_HEX_WKB, MINKSUM_DOUBLES, 0, &bytes, &length, NULL) ==
         MINKSUM_OK);
  EXPECT(length == 186);
  EXPECT_WKT(minksum_read(bytes, length, &out, &error), "POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))");
  minksum_text_free(bytes);
  EXPECT(minksum_write(tile, MINKSUM_WKB, MINKSUM_EXACT, 0, &bytes, NULL, NULL) ==
         MINKSUM_BAD_INPUT);
  minksum_geometry_free(tile);
}

static void test_sums(void) {
  minksum_geometry *square = read("POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))");
  minksum_geometry *third = read("POLYGON ((0 0, 1/3 0, 1/3 1/3, 0 1/3, 0 0))");
  minksum_geometry *shifted = read("POLYGON ((1 0, 3 0, 3 2, 1 2, 1 0))");
  minksum_geometry *bow_tie = read("POLYGON ((0 0, 4 4, 4 0, 0 4, 0 0))");
  minksum_prepared *p = NULL;
  minksum_prepared *q = NULL;
  minksum_geometry *out = NULL;
  minksum_options options;
  int calls = 0;
  const char *sum = "POLYGON ((0 0, 7/3 0, 7/3 7/3, 0 7/3, 0 0))";
  EXPECT_WKT(minksum_sum(square, third, NULL, &out, &error), sum);
  EXPECT_WKT(minksum_dilate(square, third, NULL, &out, &error), sum);
  EXPECT_WKT(minksum_erode(square, third, NULL, &out, &error),
             "POLYGON ((0 0, 5/3 0, 5/3 5/3, 0 5/3, 0 0))");
  EXPECT_WKT(minksum_open(square, third, NULL, &out, &error),
             "POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))");
  EXPECT_WKT(minksum_close(square, third, NULL, &out, &error),
             "POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))");
  EXPECT_WKT(minksum_unite(square, shifted, NULL, &out, &error),
             "POLYGON ((0 0, 3 0, 3 2, 0 2, 0 0))");
  EXPECT_WKT(minksum_intersect(square, shifted, NULL, &out, &error),
             "POLYGON ((1 0, 2 0, 2 2, 1 2, 1 0))");
  EXPECT_WKT(minksum_subtract(square, shifted, NULL, &out, &error),
             "POLYGON ((0 0, 1 0, 1 2, 0 2, 0 0))");
  EXPECT_WKT(minksum_symmetric_difference(square, shifted, NULL, &out, &error),
             "MULTIPOLYGON (((0 0, 1 0, 1 2, 0 2, 0 0)), ((2 0, 3 0, 3 2, 2 2, 2 0)))");
  EXPECT(minksum_prepare(square, NULL, &p, &error) == MINKSUM_OK);
  EXPECT(minksum_prepare(third, NULL, &q, &error) == MINKSUM_OK);
  EXPECT_WKT(minksum_sum_prepared(p, q, NULL, &out, &error), sum);
  minksum_prepared_free(p);
  minksum_prepared_free(q);
  EXPECT(minksum_prepare(bow_tie, NULL, &p, &error) == MINKSUM_BAD_INPUT);
  minksum_options_init(&options);
  options.fill = MINKSUM_FILL_STRICT;
  EXPECT(minksum_sum(square, bow_tie, &options, &out, &error) == MINKSUM_BAD_INPUT);
  EXPECT(error.operand == 1 && error.polygon == 0 && error.ring == 0);
  options.fill = (minksum_fill)99;
  EXPECT(minksum_sum(square, third, &options, &out, &error) == MINKSUM_BAD_INPUT);
  minksum_options_init(&options);
  options.progress = stop_at_once;
  options.context = &calls;
  EXPECT(minksum_sum(square, third, &options, &out, &error) == MINKSUM_CANCELLED);
  EXPECT(calls > 0 && out == NULL);
  minksum_options_init(&options);
  options.max_segments = 3;
  EXPECT(minksum_sum(bow_tie, bow_tie, &options, &out, &error) == MINKSUM_LIMIT_EXCEEDED);
  EXPECT(strcmp(error.limit, "Limits::max_segments") == 0 && error.limit_value == 3);
  EXPECT(minksum_sum(square, NULL, NULL, &out, &error) == MINKSUM_BAD_INPUT);
  minksum_geometry_free(square);
  minksum_geometry_free(third);
  minksum_geometry_free(shifted);
  minksum_geometry_free(bow_tie);
}

static void test_shapes(void) {
  const double turn[6] = {0, -1, 5, 1, 0, 0};
  minksum_geometry *square = read("POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))");
  minksum_geometry *third = read("POLYGON ((0 0, 1/3 0, 1/3 1/3, 0 1/3, 0 0))");
  minksum_geometry *bow_tie = read("POLYGON ((0 0, 4 4, 4 0, 0 4, 0 0))");
  minksum_geometry *no_fit = read("GEOMETRYCOLLECTION (POLYGON ((0 0, 6 0, 6 4, 0 4, 0 0)), "
                                  "LINESTRING (2 1, 2 11/3))");
  minksum_geometry *out = NULL;
  minksum_options options;
  minksum_offset_options how;
  minksum_error faults[3];
  size_t count = 0;
  double area = 0;
  double box[4];
  int found = 0;
  minksum_locator *locator = NULL;
  minksum_location location;
  minksum_offset_options_init(&how);
  how.join = MINKSUM_JOIN_MITER;
  EXPECT_WKT(minksum_offset(square, 1, &how, NULL, &out, &error),
             "POLYGON ((-1 -1, 3 -1, 3 3, -1 3, -1 -1))");
  how.join = (minksum_join)7;
  EXPECT(minksum_offset(square, 1, &how, NULL, &out, &error) == MINKSUM_BAD_INPUT);
  EXPECT(minksum_offset(square, NAN, NULL, NULL, &out, &error) == MINKSUM_BAD_INPUT);
  EXPECT(minksum_disc(1, 0.01, MINKSUM_OUTSIDE, &out, &error) == MINKSUM_OK);
  EXPECT(minksum_area(out, &area, &error) == MINKSUM_OK && area > 3.1415 && area < 3.21);
  EXPECT(minksum_area(NULL, &area, &error) == MINKSUM_BAD_INPUT && area == 0);
  minksum_geometry_free(out);
  EXPECT_WKT(minksum_resolve(bow_tie, NULL, &out, &error),
             "MULTIPOLYGON (((0 0, 2 2, 0 4, 0 0)), ((2 2, 4 0, 4 4, 2 2)))");
  EXPECT_WKT(minksum_round(third, MINKSUM_OUTSIDE, 1, NULL, &out, &error),
             "POLYGON ((0 0, 2/5 0, 2/5 2/5, 0 2/5, 0 0))");
  EXPECT_WKT(minksum_round(no_fit, MINKSUM_OUTSIDE, 0, NULL, &out, &error),
             "GEOMETRYCOLLECTION (POLYGON ((0 0, 6 0, 6 4, 0 4, 0 0)), LINESTRING (2 1, 2 4))");
  minksum_options_init(&options);
  options.tight = 0;
  EXPECT_WKT(minksum_round(no_fit, MINKSUM_OUTSIDE, 0, &options, &out, &error),
             "POLYGON ((0 0, 6 0, 6 4, 0 4, 0 0))");
  EXPECT_WKT(minksum_transform(no_fit, turn, NULL, &out, &error),
             "GEOMETRYCOLLECTION (POLYGON ((5 0, 5 6, 1 6, 1 0, 5 0)), LINESTRING (4 2, 4/3 2))");
  EXPECT_WKT(minksum_transform(square, turn, NULL, &out, &error),
             "POLYGON ((5 0, 5 2, 3 2, 3 0, 5 0))");
  EXPECT(minksum_validate(bow_tie, NULL, faults, 3, &count, &error) == MINKSUM_OK);
  EXPECT(count == 1 && strstr(faults[0].message, "(2, 2)") != NULL && faults[0].polygon == 0);
  EXPECT(minksum_bounding_box(square, box, &found, &error) == MINKSUM_OK);
  EXPECT(found && box[0] == 0 && box[1] == 0 && box[2] == 2 && box[3] == 2);
  EXPECT(minksum_resolve(square, NULL, &out, &error) == MINKSUM_OK);
  EXPECT(minksum_locator_new(out, NULL, &locator, &error) == MINKSUM_OK);
  minksum_geometry_free(out);
  EXPECT(minksum_locate(locator, 1, 1, &location, &error) == MINKSUM_OK &&
         location == MINKSUM_IS_INSIDE);
  EXPECT(minksum_locate(locator, 2, 1, &location, &error) == MINKSUM_OK &&
         location == MINKSUM_IS_ON_BOUNDARY);
  EXPECT(minksum_locate(locator, 3, 1, &location, &error) == MINKSUM_OK &&
         location == MINKSUM_IS_OUTSIDE);
  location = MINKSUM_IS_INSIDE;
  EXPECT(minksum_locate(locator, NAN, 1, &location, &error) == MINKSUM_BAD_INPUT &&
         location == MINKSUM_IS_OUTSIDE);
  minksum_locator_free(locator);
  minksum_geometry_free(square);
  minksum_geometry_free(third);
  minksum_geometry_free(bow_tie);
  minksum_geometry_free(no_fit);
}

static void test_pairs(void) {
  const double along[2] = {-1, 0};
  const double slow[2] = {-0.75, 0};
  const double away[2] = {1, 0};
  const double nowhere[2] = {0, 0};
  const double centre[2] = {0.5, 0.5};
  minksum_geometry *a = read("POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))");
  minksum_geometry *b = read("POLYGON ((5 0, 6 0, 6 1, 5 1, 5 0))");
  minksum_geometry *unit = read("POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))");
  const minksum_geometry *parts[2];
  minksum_geometry *out = NULL;
  minksum_no_fit_table *table = NULL;
  minksum_depth depth;
  minksum_sum_check check;
  minksum_options options;
  size_t most = 0;
  double factor = 0;
  int found = 0;
  EXPECT(minksum_penetration_depth(a, b, NULL, &depth, &error) == MINKSUM_OK);
  EXPECT(depth.found && !depth.overlapping && depth.distance == 3);
  EXPECT(depth.vector[0] == -3 && depth.vector[1] == 0);
  EXPECT(minksum_time_of_impact(a, b, along, NULL, &factor, &found, &error) == MINKSUM_OK);
  EXPECT(found && factor == 3);
  EXPECT_WKT(minksum_impact_factor(a, b, slow, NULL, &out, &error), "POINT (4 0)");
  EXPECT_WKT(minksum_impact_factor(a, b, away, NULL, &out, &error), "POLYGON EMPTY");
  EXPECT(minksum_impact_factor(a, b, nowhere, NULL, &out, &error) == MINKSUM_BAD_INPUT);
  EXPECT(minksum_time_of_impact(a, b, nowhere, NULL, &factor, &found, &error) ==
         MINKSUM_BAD_INPUT);
  EXPECT_WKT(minksum_no_fit_polygon(a, unit, centre, NULL, &out, &error),
             "POLYGON ((-1/2 -1/2, 5/2 -1/2, 5/2 5/2, -1/2 5/2, -1/2 -1/2))");
  EXPECT_WKT(minksum_inner_fit_polygon(a, unit, NULL, NULL, &out, &error),
             "POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))");
  parts[0] = a;
  parts[1] = unit;
  EXPECT(minksum_no_fit_table_new(parts, 2, 4, NULL, &table, &error) == MINKSUM_OK);
  EXPECT_WKT(minksum_no_fit_table_at(table, 0, 0, 1, 2, &out, &error),
             "POLYGON ((0 0, 3 0, 3 3, 0 3, 0 0))");
  EXPECT(minksum_no_fit_table_at(table, 2, 0, 1, 0, &out, &error) == MINKSUM_BAD_INPUT);
  minksum_no_fit_table_free(table);
  minksum_options_init(&options);
  options.tight = 0;
  options.threads = 0;
  options.progress = count_parts;
  options.context = &most;
  EXPECT(minksum_no_fit_table_new(parts, 2, 1, &options, &table, &error) == MINKSUM_OK);
  EXPECT(most == 2);
  minksum_no_fit_table_free(table);
  EXPECT(minksum_sum(a, unit, NULL, &out, &error) == MINKSUM_OK);
  EXPECT(minksum_check_sum(out, a, unit, 0, NULL, &check, &error) == MINKSUM_OK);
  EXPECT(check.ok && check.proved == 1 && check.points > 0 && check.disagreements == 0);
  EXPECT(minksum_check_sum(a, a, unit, 0, NULL, &check, &error) == MINKSUM_OK);
  EXPECT(!check.ok && check.proved == 0);
  minksum_geometry_free(out);
  minksum_geometry_free(a);
  minksum_geometry_free(b);
  minksum_geometry_free(unit);
}

static void test_robots(void) {
  minksum_geometry *robot = read("POLYGON ((0 0, 2 0, 2 1, 0 1, 0 0))");
  minksum_geometry *walls =
      read("MULTIPOLYGON (((-1 4, 4 4, 4 5, -1 5, -1 4)), ((6 4, 11 4, 11 5, 6 5, 6 4)))");
  minksum_geometry *room = read("POLYGON ((-1 -1, 11 -1, 11 11, -1 11, -1 -1))");
  minksum_geometry *obstacles = NULL;
  minksum_geometry *free_space = NULL;
  minksum_space *space = NULL;
  minksum_space_options how;
  minksum_reach reach;
  const minksum_configuration from = {1, 1, 0};
  const minksum_configuration to = {1, 8, 0};
  minksum_space_options_init(&how);
  how.workspace = room;
  EXPECT(minksum_space_new(robot, walls, &how, NULL, &space, &error) == MINKSUM_OK);
  EXPECT(minksum_space_slice(space, 90, &obstacles, &free_space, &error) == MINKSUM_OK);
  EXPECT(minksum_geometry_counts(free_space).polygons == 1);
  minksum_geometry_free(obstacles);
  minksum_geometry_free(free_space);
  EXPECT(minksum_space_slice(space, 0, &obstacles, NULL, &error) == MINKSUM_OK);
  minksum_geometry_free(obstacles);
  EXPECT(minksum_space_slice(space, NAN, &obstacles, &free_space, &error) == MINKSUM_BAD_INPUT);
  EXPECT(obstacles == NULL && free_space == NULL);
  minksum_space_free(space);
  EXPECT(minksum_find_path(robot, walls, from, to, 8, 0, &how, NULL, &reach, &error) ==
         MINKSUM_OK);
  EXPECT(reach.reachable && reach.count >= 2 && reach.path[reach.count - 1].y == 8);
  EXPECT(minksum_geometry_counts(reach.exact).points == 2 * reach.count);
  minksum_reach_free(&reach);
  EXPECT(reach.exact == NULL);
  EXPECT(minksum_find_path(robot, walls, from, to, SIZE_MAX, 0, &how, NULL, &reach, &error) ==
         MINKSUM_LIMIT_EXCEEDED);
  minksum_reach_free(NULL);
  EXPECT(reach.path == NULL);
  minksum_geometry_free(robot);
  minksum_geometry_free(walls);
  minksum_geometry_free(room);
}

int main(void) {
  test_geometries();
  test_binary();
  test_sums();
  test_shapes();
  test_pairs();
  test_robots();
  if (failures == 0) printf("all as it must be\n");
  return failures == 0 ? 0 : 1;
}
