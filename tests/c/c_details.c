/* Calls the functions of the C interface that tell more than a result: how text is read, where
 * edges came from, tight places, statistics, the trace, contacts and exact vectors. */
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

static minksum_geometry *read(const char *wkt) {
  minksum_geometry *geometry = NULL;
  if (minksum_read(wkt, strlen(wkt), &geometry, &error) != MINKSUM_OK) {
    printf("%s: %s\n", wkt, error.message);
    exit(1);
  }
  return geometry;
}
/* Tells whether the exact WKT of a geometry is `wkt`. Frees the geometry. */
static int is(minksum_geometry *geometry, const char *wkt) {
  char *text = NULL;
  int same = 0;
  if (minksum_write(geometry, MINKSUM_WKT, MINKSUM_EXACT, 0, &text, NULL, &error) == MINKSUM_OK) {
    same = strcmp(text, wkt) == 0;
    if (!same) printf("%s\n", text);
  }
  minksum_text_free(text);
  minksum_geometry_free(geometry);
  return same;
}

static void test_reading(void) {
  const char circle[] = "<svg xmlns='http://www.w3.org/2000/svg'><circle r='1'/></svg>";
  const char high[] = "POINT Z (1 2 3)";
  const char table[] = "a,b\nPOINT (1 2),POINT (3 4)\n";
  const char drawing[] =
      "0\nSECTION\n2\nENTITIES\n"
      "0\nLINE\n8\ncut\n10\n0\n20\n0\n11\n5\n21\n6\n"
      "0\nLINE\n8\nmark\n10\n7\n20\n7\n11\n8\n21\n9\n0\nENDSEC\n0\nEOF\n";
  minksum_read_options how;
  minksum_geometry *out = NULL;
  double area = 0;
  minksum_read_options_init(&how);
  minksum_read_options_init(NULL);
  EXPECT(minksum_read_as(circle, strlen(circle), &how, &out, &error) == MINKSUM_BAD_INPUT);
  how.tolerance = 0.01;
  how.side = MINKSUM_OUTSIDE;
  EXPECT(minksum_read_as(circle, strlen(circle), &how, &out, &error) == MINKSUM_OK);
  EXPECT(minksum_area(out, &area, &error) == MINKSUM_OK && area > 3.1415926 && area < 3.21);
  minksum_geometry_free(out);
  EXPECT(minksum_read_as(high, strlen(high), &how, &out, &error) == MINKSUM_BAD_INPUT);
  how.drop_z = 1;
  EXPECT(minksum_read_as(high, strlen(high), &how, &out, &error) == MINKSUM_OK);
  EXPECT(is(out, "POINT (1 2)"));
  EXPECT(minksum_read_as(table, strlen(table), &how, &out, &error) == MINKSUM_BAD_INPUT);
  EXPECT(strstr(error.message, "several columns") != NULL);
  how.column = "b";
  EXPECT(minksum_read_as(table, strlen(table), &how, &out, &error) == MINKSUM_OK);
  EXPECT(is(out, "POINT (3 4)"));
  how.column = "c";
  EXPECT(minksum_read_as(table, strlen(table), &how, &out, &error) == MINKSUM_BAD_INPUT);
  {
    /* A text that is too long for an error ends with a whole character. */
    char name[1024] = "";
    size_t i = 0;
    for (i = 0; i < 340; ++i) memcpy(name + 3 * i, "\xE2\x8A\x95", 4);
    how.column = name;
    for (i = 0; i < 3; ++i, ++how.column) {
      EXPECT(minksum_read_as(table, strlen(table), &how, &out, &error) == MINKSUM_BAD_INPUT);
      EXPECT(strcmp(error.message + strlen(error.message) - 3, "\xE2\x8A\x95") == 0);
      memcpy(name, "xxx", 3);
    }
    how.column = "c";
  }
  how.layer = "cut";
  EXPECT(minksum_read_as(drawing, strlen(drawing), &how, &out, &error) == MINKSUM_OK);
  EXPECT(is(out, "LINESTRING (0 0, 5 6)"));
  how.layer = "fold";
  EXPECT(minksum_read_as(drawing, strlen(drawing), &how, &out, &error) == MINKSUM_BAD_INPUT);
  how.tolerance = -1;
  EXPECT(minksum_read_as(high, strlen(high), &how, &out, &error) == MINKSUM_BAD_INPUT);
  how.tolerance = 0;
  how.join_ends = NAN;
  EXPECT(minksum_read_as(high, strlen(high), &how, &out, &error) == MINKSUM_BAD_INPUT);
  EXPECT(minksum_read_as(NULL, 0, NULL, &out, &error) == MINKSUM_BAD_INPUT && out == NULL);
}

static void test_details(void) {
  minksum_geometry *a = read("POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0), (3 3, 3 5, 5 5, 5 3, 3 3))");
  minksum_geometry *b = read("POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))");
  minksum_geometry *crossed = read("POLYGON ((0 0, 4 4, 4 0, 0 4, 0 0))");
  minksum_geometry *out = NULL;
  minksum_geometry *tight = NULL;
  minksum_trace *trace = NULL;
  minksum_statistics did;
  minksum_origin origins[4];
  minksum_options options;
  int found = 7;
  EXPECT(minksum_detailed_sum(a, b, NULL, &out, &tight, &did, &trace, &error) == MINKSUM_OK);
  EXPECT(minksum_geometry_get_origins(out, origins, &found, &error) == MINKSUM_OK && found == 1);
  EXPECT(origins[0].edge_operand <= 1 && origins[0].edge < 8 && origins[0].vertex < 8);
  EXPECT(minksum_geometry_get_origins(a, origins, &found, &error) == MINKSUM_OK && found == 0);
  EXPECT(minksum_geometry_get_origins(a, origins, NULL, &error) == MINKSUM_BAD_INPUT);
  EXPECT(is(out, "POLYGON ((0 0, 11 0, 11 11, 0 11, 0 0))"));
  EXPECT(is(tight, "POINT (5 5)"));
  EXPECT(did.convolution_segments > 0 && did.loops >= 1 && did.seconds > 0);
  {
    const minksum_trace_counts counts = minksum_trace_get_counts(trace);
    double *const xy = malloc(sizeof(double) * 4 * (counts.segments + counts.pieces + 64));
    int64_t offsets[16];
    unsigned char flags[256];
    EXPECT(xy != NULL && counts.segments > 0 && counts.segments < 256 && counts.loops < 15);
    EXPECT((double)counts.segments == did.convolution_segments);
    EXPECT((double)counts.loops == did.loops && counts.pieces < 256);
    EXPECT(minksum_trace_get_convolution(trace, xy, flags, &error) == MINKSUM_OK);
    EXPECT(flags[0] <= 3);
    EXPECT(minksum_trace_get_pieces(trace, xy, flags, &error) == MINKSUM_OK && flags[0] <= 3);
    EXPECT(minksum_trace_get_nodes(trace, xy, &error) == MINKSUM_OK);
    EXPECT(minksum_trace_get_loops(trace, xy, offsets, flags, &error) == MINKSUM_OK);
    EXPECT(offsets[0] == 0 && (size_t)offsets[counts.loops] == counts.loop_vertices);
    EXPECT((flags[0] & 3) <= 2);
    EXPECT(counts.columns * counts.rows <= sizeof flags);
    EXPECT(counts.columns == 0 || (counts.cell_width > 0 && counts.cell_height > 0));
    EXPECT(minksum_trace_get_cover(trace, flags, &error) == MINKSUM_OK);
    EXPECT(minksum_trace_get_cover(NULL, flags, &error) == MINKSUM_BAD_INPUT);
    EXPECT(minksum_trace_get_counts(NULL).segments == 0);
    free(xy);
  }
  minksum_trace_free(trace);
  minksum_trace_free(NULL);
  EXPECT(minksum_detailed_sum(a, b, NULL, &out, NULL, NULL, NULL, &error) == MINKSUM_OK);
  minksum_geometry_free(out);
  minksum_options_init(&options);
  options.fill = MINKSUM_FILL_STRICT;
  EXPECT(minksum_detailed_sum(a, crossed, &options, &out, &tight, &did, &trace, &error) ==
         MINKSUM_BAD_INPUT);
  EXPECT(out == NULL && tight == NULL && trace == NULL && error.operand == 1);
  minksum_geometry_free(a);
  minksum_geometry_free(b);
  minksum_geometry_free(crossed);
}

static int stop_searching(void *context, minksum_stage stage, size_t done, size_t parts) {
  (void)context, (void)done, (void)parts;
  return stage == MINKSUM_STAGE_SEARCH;
}

static void test_placements(void) {
  const double reference[] = {0, 0};
  const double places[] = {3, 3, 3.5, 3, 20, 20, 9, 1};
  const double not_finite[] = {0, 0, 0, INFINITY};
  minksum_geometry *a = read("POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0), (3 3, 3 5, 5 5, 5 3, 3 3))");
  minksum_geometry *b = read("POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))");
  minksum_geometry *point = read("POINT (0 0)");
  minksum_geometry *nothing = read("POLYGON EMPTY");
  minksum_geometry *third = read("POLYGON ((0 0, 1/3 0, 0 1/3, 0 0))");
  minksum_geometry *out = NULL;
  minksum_options options;
  int contacts[4];
  EXPECT(minksum_no_fit_polygon(a, b, reference, NULL, &out, &error) == MINKSUM_OK);
  EXPECT(minksum_contacts(out, places, 4, contacts, NULL, &error) == MINKSUM_OK);
  EXPECT(contacts[0] == MINKSUM_TOUCHING && contacts[1] == MINKSUM_OVERLAPPING);
  EXPECT(contacts[2] == MINKSUM_FREE && contacts[3] == MINKSUM_TOUCHING);
  EXPECT(minksum_contacts(out, NULL, 4, contacts, NULL, &error) == MINKSUM_BAD_INPUT);
  EXPECT(minksum_contacts(out, NULL, 0, NULL, NULL, &error) == MINKSUM_OK);
  EXPECT(minksum_contacts(out, not_finite, 2, contacts, NULL, &error) == MINKSUM_BAD_INPUT);
  EXPECT(error.vertex == 1);
  minksum_options_init(&options);
  options.progress = stop_searching;
  EXPECT(minksum_contacts(out, places, 4, contacts, &options, &error) == MINKSUM_CANCELLED);
  EXPECT(contacts[0] == 0 && contacts[3] == 0);
  minksum_geometry_free(out);
  EXPECT(minksum_depth_vector(b, third, NULL, &out, &error) == MINKSUM_OK);
  EXPECT(is(out, "POINT (-1/6 -1/6)"));
  EXPECT(minksum_depth_vector(b, point, NULL, &out, &error) == MINKSUM_OK);
  EXPECT(is(out, "POINT (0 0)"));
  EXPECT(minksum_depth_vector(b, nothing, NULL, &out, &error) == MINKSUM_OK);
  EXPECT(is(out, "POLYGON EMPTY"));
  minksum_geometry_free(a);
  minksum_geometry_free(b);
  minksum_geometry_free(point);
  minksum_geometry_free(nothing);
  minksum_geometry_free(third);
}

int main(void) {
  test_reading();
  test_details();
  test_placements();
  if (failures == 0) printf("all as it must be\n");
  return failures == 0 ? 0 : 1;
}
