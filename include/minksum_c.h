/* The C interface of minksum: exact Minkowski sums of planar regions, and what people use them for.
 *
 * Conventions
 *   - Every function that can fail returns a minksum_status and takes a minksum_error, which may be
 *     NULL. On failure the results are NULL or 0, and nothing has to be freed.
 *   - A `minksum_geometry **` at the end of the arguments receives a new geometry. Free it with
 *     minksum_geometry_free. It is overwritten in any case: keep the pointer to an argument.
 *   - Options may be NULL: then the defaults hold. Set up others by minksum_options_init.
 *   - Coordinates in arrays are doubles, x and y of each point in turn. A double means exactly
 *     itself. Exact results are read as text (minksum_write with MINKSUM_EXACT).
 *   - Geometries never change once they are made, but by the functions that add to them. Any number
 *     of threads may use one at the same time. No function keeps global state.
 * Complexity and sources are those of the C++ functions of the same names (minksum/minksum.hpp).
 */
#ifndef MINKSUM_C_H
#define MINKSUM_C_H

#include <stddef.h>
#include <stdint.h>

#include "minksum/export.h"

#ifdef __cplusplus
extern "C" {
#endif

/* -- Errors and options --------------------------------------------------------------------- */

typedef enum minksum_status {
  MINKSUM_OK = 0,
  MINKSUM_BAD_INPUT = 1,      /* an argument is not what it must be */
  MINKSUM_LIMIT_EXCEEDED = 2, /* a stated limit, or memory */
  MINKSUM_CANCELLED = 3,      /* `progress` said so */
  MINKSUM_INTERNAL = 4        /* a broken invariant of the library: please report it */
} minksum_status;

/* An index that is not known. */
#define MINKSUM_NONE SIZE_MAX

typedef struct minksum_error {
  minksum_status status;
  int operand;    /* which argument it is about, from 0; -1 = none */
  size_t polygon; /* these count from 0; MINKSUM_NONE = not known */
  size_t ring;
  size_t vertex;
  size_t line; /* in a text; these count from 1; 0 = not known */
  size_t column;
  char limit[48]; /* the limit that was passed, such as "Limits::max_segments"; "" = none */
  uint64_t limit_value;
  char message[512];
} minksum_error;

/* What rings of any kind enclose: see minksum::FillRule. */
typedef enum minksum_fill {
  MINKSUM_FILL_AUTOMATIC = 0, /* outer ring less holes */
  MINKSUM_FILL_EVEN_ODD,
  MINKSUM_FILL_NON_ZERO,
  MINKSUM_FILL_POSITIVE,
  MINKSUM_FILL_NEGATIVE,
  MINKSUM_FILL_STRICT /* polygons must be valid */
} minksum_fill;

/* What an operation is doing: the stages of a sum, and what is done beside sums. */
typedef enum minksum_stage {
  MINKSUM_STAGE_OPERANDS = 0,
  MINKSUM_STAGE_CONVOLUTION,
  MINKSUM_STAGE_COVER,
  MINKSUM_STAGE_ARRANGEMENT,
  MINKSUM_STAGE_LOOPS,
  MINKSUM_STAGE_FILTERS,
  MINKSUM_STAGE_OUTPUT,
  MINKSUM_STAGE_OVERLAY,
  MINKSUM_STAGE_ROUNDING,
  MINKSUM_STAGE_CHECKING,
  MINKSUM_STAGE_SEARCH
} minksum_stage;

/* The options of every operation: see minksum::Options. */
typedef struct minksum_options {
  uint64_t max_segments;  /* 0 = the default */
  uint64_t max_crossings; /* 0 = the default */
  minksum_fill fill;      /* how operands are read */
  int regularize;         /* drop thin parts of the operands */
  int tight;              /* keep tight places: 1 = yes, 0 = no, -1 = no-fit polygons only */
  int threads;            /* of operations on many parts; 0 = one for each core */
  /* Called when a stage begins and every few milliseconds, by any thread, with how many of how
   * many parts are done. Not 0 = stop. May be NULL. */
  int (*progress)(void* context, minksum_stage stage, size_t done, size_t parts);
  void *context;
} minksum_options;

/* Sets the defaults. */
MINKSUM_API void minksum_options_init(minksum_options *options);
/* "0.1.0" */
MINKSUM_API const char *minksum_version(void);

/* -- Geometries ----------------------------------------------------------------------------- */

/* Polygons with holes, polylines and points: any set that the library computes with. */
typedef struct minksum_geometry minksum_geometry;

MINKSUM_API minksum_status minksum_geometry_empty(minksum_geometry **result, minksum_error *error);
/* One polygon without holes from n points; the first is not repeated. */
MINKSUM_API minksum_status minksum_geometry_polygon(const double *xy, size_t n,
                                                    minksum_geometry **result,
                                                    minksum_error *error);
/* Polygons with holes. Ring r has the points [ring_offsets[r], ring_offsets[r + 1]), polygon p the
 * rings [polygon_offsets[p], polygon_offsets[p + 1]), the outer one first. There is one offset more
 * than there are rings, and polygons; the first offset is 0. */
MINKSUM_API minksum_status minksum_geometry_polygons(const double *xy, const int64_t *ring_offsets,
                                                     size_t rings, const int64_t *polygon_offsets,
                                                     size_t polygons, minksum_geometry **result,
                                                     minksum_error *error);
/* A path along n points, two or more; closed if the last one repeats the first. */
MINKSUM_API minksum_status minksum_geometry_add_polyline(minksum_geometry *geometry,
                                                         const double *xy, size_t n,
                                                         minksum_error *error);
MINKSUM_API minksum_status minksum_geometry_add_points(minksum_geometry *geometry,
                                                       const double *xy, size_t n,
                                                       minksum_error *error);
MINKSUM_API minksum_status minksum_geometry_copy(const minksum_geometry *geometry,
                                                 minksum_geometry **result, minksum_error *error);
/* NULL is allowed. */
MINKSUM_API void minksum_geometry_free(minksum_geometry *geometry);
/* Equal as stored. Equal sets are equal as stored if both are results of operations. */
MINKSUM_API int minksum_geometry_equal(const minksum_geometry *a, const minksum_geometry *b);

typedef struct minksum_counts {
  size_t polygons;
  size_t rings;
  size_t vertices; /* of rings */
  size_t polylines;
  size_t polyline_vertices;
  size_t points;
} minksum_counts;

/* All 0 for NULL. */
MINKSUM_API minksum_counts minksum_geometry_counts(const minksum_geometry *geometry);
/* Fill arrays of 2 * vertices, rings + 1 and polygons + 1 elements. An array may be NULL. */
MINKSUM_API minksum_status minksum_geometry_get_polygons(const minksum_geometry *geometry,
                                                         double *xy, int64_t *ring_offsets,
                                                         int64_t *polygon_offsets,
                                                         minksum_error *error);
/* Fill arrays of 2 * polyline_vertices and polylines + 1 elements. An array may be NULL. */
MINKSUM_API minksum_status minksum_geometry_get_polylines(const minksum_geometry *geometry,
                                                          double *xy, int64_t *offsets,
                                                          minksum_error *error);
/* Fills an array of 2 * points elements. */
MINKSUM_API minksum_status minksum_geometry_get_points(const minksum_geometry *geometry,
                                                       double *xy, minksum_error *error);

typedef enum minksum_format {
  MINKSUM_WKT = 0,
  MINKSUM_GEOJSON,
  MINKSUM_POLY,
  MINKSUM_SVG /* is only written */
} minksum_format;
typedef enum minksum_style {
  MINKSUM_DOUBLES = 0, /* the nearest doubles */
  MINKSUM_EXACT,       /* integers, or p/q; finite decimals in GeoJSON */
  MINKSUM_DECIMALS     /* with a number of digits after the point */
} minksum_style;

/* The format is told by the text. Numbers are read exactly. */
MINKSUM_API minksum_status minksum_read(const char *text, size_t length, minksum_geometry **result,
                                        minksum_error *error);
/* Ends with a zero byte, which `length` does not count; `length` may be NULL. Free it with
 * minksum_text_free. */
MINKSUM_API minksum_status minksum_write(const minksum_geometry *geometry, minksum_format format,
                                         minksum_style style, int digits, char **text,
                                         size_t *length, minksum_error *error);
MINKSUM_API void minksum_text_free(char *text);

/* -- Sums and what is made of them ------------------------------------------------------------ */

#define MINKSUM_BINARY(name)                                                        \
  MINKSUM_API minksum_status minksum_##name(                                        \
      const minksum_geometry *a, const minksum_geometry *b,                         \
      const minksum_options *options, minksum_geometry **result, minksum_error *error)
MINKSUM_BINARY(sum);    /* a ⊕ b */
MINKSUM_BINARY(dilate); /* the same */
MINKSUM_BINARY(erode);  /* where b can be put inside a */
MINKSUM_BINARY(open);
MINKSUM_BINARY(close);
MINKSUM_BINARY(unite);
MINKSUM_BINARY(intersect); /* of the areas, and so the next two */
MINKSUM_BINARY(subtract);
MINKSUM_BINARY(symmetric_difference);
#undef MINKSUM_BINARY

/* What can be asked of one operand that meets many others is computed once. */
typedef struct minksum_prepared minksum_prepared;
/* `geometry` must have valid polygons and no thin parts. */
MINKSUM_API minksum_status minksum_prepare(const minksum_geometry *geometry,
                                           const minksum_options *options,
                                           minksum_prepared **result, minksum_error *error);
MINKSUM_API void minksum_prepared_free(minksum_prepared *prepared);
MINKSUM_API minksum_status minksum_sum_prepared(const minksum_prepared *a,
                                                const minksum_prepared *b,
                                                const minksum_options *options,
                                                minksum_geometry **result, minksum_error *error);

typedef enum minksum_side {
  MINKSUM_NEAREST = 0,
  MINKSUM_OUTSIDE, /* the result contains the exact set */
  MINKSUM_INSIDE   /* the result is contained in the exact set */
} minksum_side;
typedef enum minksum_join {
  MINKSUM_JOIN_ROUND = 0,
  MINKSUM_JOIN_MITER,
  MINKSUM_JOIN_SQUARE,
  MINKSUM_JOIN_BEVEL
} minksum_join;
typedef enum minksum_cap {
  MINKSUM_CAP_ROUND = 0,
  MINKSUM_CAP_BUTT,
  MINKSUM_CAP_SQUARE
} minksum_cap;

typedef struct minksum_offset_options {
  minksum_join join;
  minksum_cap cap;
  minksum_side side; /* of round joins and caps */
  double miter_limit;
  double tolerance; /* how far the result may be off; 0 = a thousandth of the distance */
} minksum_offset_options;
MINKSUM_API void minksum_offset_options_init(minksum_offset_options *offset_options);
/* `geometry` grown by `distance`, or shrunk if that is negative. */
MINKSUM_API minksum_status minksum_offset(const minksum_geometry *geometry, double distance,
                                          const minksum_offset_options *offset_options,
                                          const minksum_options *options,
                                          minksum_geometry **result, minksum_error *error);
/* A polygon that stands for the disc of this radius around the origin. */
MINKSUM_API minksum_status minksum_disc(double radius, double tolerance, minksum_side side,
                                        minksum_geometry **result, minksum_error *error);

/* The set of points that the rings mean, with valid polygons. */
MINKSUM_API minksum_status minksum_resolve(const minksum_geometry *geometry,
                                           const minksum_options *options,
                                           minksum_geometry **result, minksum_error *error);
/* To doubles if `decimals` is negative, else to so many digits after the point. `geometry` must be
 * a result of an operation. */
MINKSUM_API minksum_status minksum_round(const minksum_geometry *geometry, minksum_side side,
                                         int decimals, const minksum_options *options,
                                         minksum_geometry **result, minksum_error *error);
/* (x, y) -> (m[0] x + m[1] y + m[2], m[3] x + m[4] y + m[5]) */
MINKSUM_API minksum_status minksum_transform(const minksum_geometry *geometry, const double m[6],
                                             const minksum_options *options,
                                             minksum_geometry **result, minksum_error *error);

/* -- Questions ------------------------------------------------------------------------------ */

/* Finds up to `capacity` faults of the polygons: `faults` receives them as errors, with the place
 * of each in `message`. `count` receives their number; 0 = valid. */
MINKSUM_API minksum_status minksum_validate(const minksum_geometry *geometry,
                                            const minksum_options *options, minksum_error *faults,
                                            size_t capacity, size_t *count, minksum_error *error);
/* Of the polygons, correct to a few units in the last place. */
MINKSUM_API minksum_status minksum_area(const minksum_geometry *geometry, double *area,
                                        minksum_error *error);
/* min x, min y, max x, max y of the polygons; `found` receives 0 if there are none. */
MINKSUM_API minksum_status minksum_bounding_box(const minksum_geometry *geometry, double box[4],
                                                int *found, minksum_error *error);

typedef enum minksum_location {
  MINKSUM_IS_OUTSIDE = 0,
  MINKSUM_IS_ON_BOUNDARY, /* or on a polyline, or a point */
  MINKSUM_IS_INSIDE
} minksum_location;
/* For many points. `geometry` must be a result of an operation. */
typedef struct minksum_locator minksum_locator;
MINKSUM_API minksum_status minksum_locator_new(const minksum_geometry *geometry,
                                               const minksum_options *options,
                                               minksum_locator **result, minksum_error *error);
MINKSUM_API void minksum_locator_free(minksum_locator *locator);
MINKSUM_API minksum_status minksum_locate(const minksum_locator *locator, double x, double y,
                                          minksum_location *location, minksum_error *error);

typedef struct minksum_depth {
  int found;       /* 0 if a set is empty; the rest says nothing then */
  int overlapping; /* whether the interiors meet */
  double vector[2]; /* the shortest motion of b after which a and b touch */
  double distance;  /* its length */
} minksum_depth;
MINKSUM_API minksum_status minksum_penetration_depth(const minksum_geometry *a,
                                                     const minksum_geometry *b,
                                                     const minksum_options *options,
                                                     minksum_depth *depth, minksum_error *error);
/* The smallest factor for which b, moved by factor * direction, touches or overlaps a. `found`
 * receives 0 if it never does. */
MINKSUM_API minksum_status minksum_time_of_impact(const minksum_geometry *a,
                                                  const minksum_geometry *b,
                                                  const double direction[2],
                                                  const minksum_options *options, double *factor,
                                                  int *found, minksum_error *error);

typedef struct minksum_sum_check {
  int ok;
  size_t faults;
  uint64_t points; /* that were tested */
  uint64_t disagreements;
  int proved;  /* 1: the result is the sum; 0: it is not; -1: not tried */
} minksum_sum_check;
/* Whether `result` is a ⊕ b, up to `within` in x and in y, by methods of their own. */
MINKSUM_API minksum_status minksum_check_sum(const minksum_geometry *result,
                                             const minksum_geometry *a, const minksum_geometry *b,
                                             double within, const minksum_options *options,
                                             minksum_sum_check *check, minksum_error *error);

/* -- Placing parts ---------------------------------------------------------------------------- */

/* Placements of `moving`'s reference point where it touches or overlaps `fixed`. Without a
 * reference point (NULL) it is the first vertex. */
MINKSUM_API minksum_status minksum_no_fit_polygon(const minksum_geometry *fixed,
                                                  const minksum_geometry *moving,
                                                  const double reference[2],
                                                  const minksum_options *options,
                                                  minksum_geometry **result, minksum_error *error);
/* Placements of `part`'s reference point that put it into `bin`. */
MINKSUM_API minksum_status minksum_inner_fit_polygon(const minksum_geometry *bin,
                                                     const minksum_geometry *part,
                                                     const double reference[2],
                                                     const minksum_options *options,
                                                     minksum_geometry **result,
                                                     minksum_error *error);

/* The no-fit polygons of all pairs of parts, in 1, 2 or 4 directions, with tight places unless
 * options say no. */
typedef struct minksum_no_fit_table minksum_no_fit_table;
MINKSUM_API minksum_status minksum_no_fit_table_new(const minksum_geometry* const* parts,
                                                    size_t count, int turns,
                                                    const minksum_options* options,
                                                    minksum_no_fit_table** result,
                                                    minksum_error* error);
MINKSUM_API void minksum_no_fit_table_free(minksum_no_fit_table *table);
/* Part `fixed` turned by fixed_turn / turns of a full turn, and so for `moving`. */
MINKSUM_API minksum_status minksum_no_fit_table_at(const minksum_no_fit_table *table, size_t fixed,
                                                   int fixed_turn, size_t moving, int moving_turn,
                                                   minksum_geometry **result,
                                                   minksum_error *error);

/* -- Robots ----------------------------------------------------------------------------------- */

typedef struct minksum_space_options {
  double reference[2];               /* the point of the robot that it turns about */
  const minksum_geometry* workspace; /* that the robot must stay in; NULL = none */
  double tolerance;                  /* of turns, in degrees */
} minksum_space_options;
MINKSUM_API void minksum_space_options_init(minksum_space_options *space_options);

typedef struct minksum_space minksum_space;
MINKSUM_API minksum_status minksum_space_new(const minksum_geometry *robot,
                                             const minksum_geometry *obstacles,
                                             const minksum_space_options *space_options,
                                             const minksum_options *options,
                                             minksum_space **result, minksum_error *error);
MINKSUM_API void minksum_space_free(minksum_space *space);
/* The obstacles, and free space unless that is NULL, of the robot turned by `degrees`. */
MINKSUM_API minksum_status minksum_space_slice(const minksum_space *space, double degrees,
                                               minksum_geometry **obstacles,
                                               minksum_geometry **free_space,
                                               minksum_error *error);

typedef struct minksum_configuration {
  double x;
  double y;
  double degrees;
} minksum_configuration;
typedef struct minksum_reach {
  int reachable;
  size_t count;                /* waypoints */
  minksum_configuration *path; /* free it with minksum_reach_free */
} minksum_reach;
/* Whether the robot gets from one configuration to another, turning in steps of 1 / angles. */
MINKSUM_API minksum_status minksum_find_path(const minksum_geometry *robot,
                                             const minksum_geometry *obstacles,
                                             minksum_configuration from, minksum_configuration to,
                                             size_t angles, int certain,
                                             const minksum_space_options *space_options,
                                             const minksum_options *options, minksum_reach *result,
                                             minksum_error *error);
MINKSUM_API void minksum_reach_free(minksum_reach *reach);

#ifdef __cplusplus
}
#endif

#endif
