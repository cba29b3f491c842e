/** \file
 * The C interface of minksum: exact Minkowski sums of planar regions, and what people use them for.
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
 *
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

/** How a function ended. */
typedef enum minksum_status {
  MINKSUM_OK = 0,             /**< all went well */
  MINKSUM_BAD_INPUT = 1,      /**< an argument is not what it must be */
  MINKSUM_LIMIT_EXCEEDED = 2, /**< a stated limit, or memory */
  MINKSUM_CANCELLED = 3,      /**< `progress` said so */
  MINKSUM_INTERNAL = 4        /**< a broken invariant of the library: please report it */
} minksum_status;

/** An index that is not known. */
#define MINKSUM_NONE SIZE_MAX

/** What went wrong, and where. */
typedef struct minksum_error {
  minksum_status status; /**< what the function returned */
  int operand;           /**< which argument it is about, from 0; -1 = none */
  size_t polygon;        /**< these count from 0; MINKSUM_NONE = not known */
  size_t ring;           /**< in its polygon: 0 = outer, 1.. = holes */
  size_t vertex;         /**< in its ring */
  size_t line;           /**< in a text; these count from 1; 0 = not known */
  size_t column;         /**< in that line */
  char limit[48];       /**< the limit that was passed, such as "Limits::max_segments"; "" = none */
  uint64_t limit_value; /**< what was allowed; 0 if that is no count */
  char message[512];    /**< in words */
} minksum_error;

/** What rings of any kind enclose: see `minksum::FillRule`. */
typedef enum minksum_fill {
  MINKSUM_FILL_AUTOMATIC = 0, /**< outer ring less holes */
  MINKSUM_FILL_EVEN_ODD,      /**< the winding number is odd */
  MINKSUM_FILL_NON_ZERO,      /**< the winding number is not 0 */
  MINKSUM_FILL_POSITIVE,      /**< the winding number is more than 0 */
  MINKSUM_FILL_NEGATIVE,      /**< the winding number is less than 0 */
  MINKSUM_FILL_STRICT         /**< polygons must be valid */
} minksum_fill;

/** What an operation is doing: the stages of a sum, and what is done beside sums. */
typedef enum minksum_stage {
  MINKSUM_STAGE_OPERANDS = 0, /**< operands are read, validated and put on their common grid */
  MINKSUM_STAGE_CONVOLUTION,  /**< the segments of the reduced convolution are listed */
  MINKSUM_STAGE_COVER,        /**< cells that are certainly inside the sum are found */
  MINKSUM_STAGE_ARRANGEMENT,  /**< the segments outside the cover are intersected */
  MINKSUM_STAGE_LOOPS,        /**< orientable loops are extracted */
  MINKSUM_STAGE_FILTERS,      /**< false loops are rejected */
  MINKSUM_STAGE_OUTPUT,       /**< the result is written */
  MINKSUM_STAGE_OVERLAY,      /**< fill rules and boolean operations */
  MINKSUM_STAGE_ROUNDING,     /**< exact numbers become doubles or decimals */
  MINKSUM_STAGE_CHECKING,     /**< a result is verified */
  MINKSUM_STAGE_SEARCH        /**< paths, distances and contacts are searched */
} minksum_stage;

/** The options of every operation: see `minksum::Options`. */
typedef struct minksum_options {
  uint64_t max_segments;  /**< see `minksum::Limits`; 0 = the default */
  uint64_t max_crossings; /**< see `minksum::Limits`; 0 = the default */
  minksum_fill fill;      /**< how operands are read */
  int regularize;         /**< drop thin parts of the operands */
  int tight;              /**< keep tight places: 1 = yes, 0 = no, -1 = of no-fit polygons only */
  int threads;            /**< of operations on many parts; 0 = one for each core */
  /** Called when a stage begins and every few milliseconds, by any thread, with how many of how
   * many parts are done. Not 0 = stop. May be NULL. */
  int (*progress)(void *context, minksum_stage stage, size_t done, size_t parts);
  void *context; /**< is handed to `progress` */
} minksum_options;

/** Sets the defaults. */
MINKSUM_API void minksum_options_init(minksum_options *options);
/** The version: "0.1.0". */
MINKSUM_API const char *minksum_version(void);

/* -- Geometries ----------------------------------------------------------------------------- */

/** Polygons with holes, polylines and points: any set that the library computes with. */
typedef struct minksum_geometry minksum_geometry;

/** Nothing, to add to. */
MINKSUM_API minksum_status minksum_geometry_empty(minksum_geometry **result, minksum_error *error);
/** One polygon without holes from n points; the first is not repeated. */
MINKSUM_API minksum_status minksum_geometry_polygon(const double *xy, size_t n,
                                                    minksum_geometry **result,
                                                    minksum_error *error);
/** Polygons with holes. Ring r has the points from `ring_offsets[r]` to `ring_offsets[r + 1]`,
 * which excluded. So polygon p has rings by `polygon_offsets`, the outer one first. There is one
 * offset more than there are rings, and polygons; the first offset is 0. */
MINKSUM_API minksum_status minksum_geometry_polygons(const double *xy, const int64_t *ring_offsets,
                                                     size_t rings, const int64_t *polygon_offsets,
                                                     size_t polygons, minksum_geometry **result,
                                                     minksum_error *error);
/** Adds a path along n points, two or more; closed if the last one repeats the first. */
MINKSUM_API minksum_status minksum_geometry_add_polyline(minksum_geometry *geometry,
                                                         const double *xy, size_t n,
                                                         minksum_error *error);
/** Adds n points. */
MINKSUM_API minksum_status minksum_geometry_add_points(minksum_geometry *geometry, const double *xy,
                                                       size_t n, minksum_error *error);
/** A geometry of its own, with the same parts. */
MINKSUM_API minksum_status minksum_geometry_copy(const minksum_geometry *geometry,
                                                 minksum_geometry **result, minksum_error *error);
/** Frees a geometry. NULL is allowed, and so it is for all functions that free. */
MINKSUM_API void minksum_geometry_free(minksum_geometry *geometry);
/** Equal as stored. Equal sets are equal as stored if both are results of operations. */
MINKSUM_API int minksum_geometry_equal(const minksum_geometry *a, const minksum_geometry *b);

/** How many parts a geometry has. */
typedef struct minksum_counts {
  size_t polygons;          /**< outer rings with their holes */
  size_t rings;             /**< outer ones and holes */
  size_t vertices;          /**< of rings */
  size_t polylines;         /**< paths */
  size_t polyline_vertices; /**< of all polylines */
  size_t points;            /**< single ones */
} minksum_counts;

/** Counts the parts. All counts are 0 for NULL. */
MINKSUM_API minksum_counts minksum_geometry_counts(const minksum_geometry *geometry);
/** Fill arrays of 2 * vertices, rings + 1 and polygons + 1 elements. An array may be NULL. */
MINKSUM_API minksum_status minksum_geometry_get_polygons(const minksum_geometry *geometry,
                                                         double *xy, int64_t *ring_offsets,
                                                         int64_t *polygon_offsets,
                                                         minksum_error *error);
/** Fill arrays of 2 * polyline_vertices and polylines + 1 elements. An array may be NULL. */
MINKSUM_API minksum_status minksum_geometry_get_polylines(const minksum_geometry *geometry,
                                                          double *xy, int64_t *offsets,
                                                          minksum_error *error);
/** Fills an array of 2 * points elements. */
MINKSUM_API minksum_status minksum_geometry_get_points(const minksum_geometry *geometry, double *xy,
                                                       minksum_error *error);

/** The text formats that are written: see `minksum::io::Format`. */
typedef enum minksum_format {
  MINKSUM_WKT = 0, /**< Well-Known Text */
  MINKSUM_GEOJSON, /**< GeoJSON */
  MINKSUM_POLY,    /**< `.poly` */
  MINKSUM_SVG      /**< is only written */
} minksum_format;
/** As which numbers coordinates are written. */
typedef enum minksum_style {
  MINKSUM_DOUBLES = 0, /**< the nearest doubles */
  MINKSUM_EXACT,       /**< integers, or p/q; finite decimals in GeoJSON */
  MINKSUM_DECIMALS     /**< with a number of digits after the point */
} minksum_style;

/** Reads a text. It tells its format itself. Numbers are read exactly. */
MINKSUM_API minksum_status minksum_read(const char *text, size_t length, minksum_geometry **result,
                                        minksum_error *error);
/** Writes a text. It ends with a zero byte, which `length` does not count; `length` may be NULL.
 * `digits` counts for MINKSUM_DECIMALS only. Free the text with `minksum_text_free`. */
MINKSUM_API minksum_status minksum_write(const minksum_geometry *geometry, minksum_format format,
                                         minksum_style style, int digits, char **text,
                                         size_t *length, minksum_error *error);
/** Frees a text. */
MINKSUM_API void minksum_text_free(char *text);

/* -- Sums and what is made of them ------------------------------------------------------------ */

#define MINKSUM_BINARY(name)                                                                      \
  MINKSUM_API minksum_status minksum_##name(const minksum_geometry *a, const minksum_geometry *b, \
                                            const minksum_options *options,                       \
                                            minksum_geometry **result, minksum_error *error)
MINKSUM_BINARY(sum);                  /**< a ⊕ b */
MINKSUM_BINARY(dilate);               /**< a ⊕ b by another name */
MINKSUM_BINARY(erode);                /**< a ⊖ b: where b can be put inside a */
MINKSUM_BINARY(open);                 /**< the erosion of a by b, dilated by b */
MINKSUM_BINARY(close);                /**< the dilation of a by b, eroded by b */
MINKSUM_BINARY(unite);                /**< a ∪ b, thin parts as well */
MINKSUM_BINARY(intersect);            /**< the area that both have */
MINKSUM_BINARY(subtract);             /**< the area of a less that of b */
MINKSUM_BINARY(symmetric_difference); /**< the areas of one of both alone */
#undef MINKSUM_BINARY

/** An operand that meets many others: what can be asked of it alone is computed once. */
typedef struct minksum_prepared minksum_prepared;
/** Prepares an operand. `geometry` must have valid polygons and no thin parts. */
MINKSUM_API minksum_status minksum_prepare(const minksum_geometry *geometry,
                                           const minksum_options *options,
                                           minksum_prepared **result, minksum_error *error);
/** Frees a prepared operand. */
MINKSUM_API void minksum_prepared_free(minksum_prepared *prepared);
/** a ⊕ b, as `minksum_sum` gives it. */
MINKSUM_API minksum_status minksum_sum_prepared(const minksum_prepared *a,
                                                const minksum_prepared *b,
                                                const minksum_options *options,
                                                minksum_geometry **result, minksum_error *error);

/** To which side a result may be off. */
typedef enum minksum_side {
  MINKSUM_NEAREST = 0, /**< to both, as little as can be */
  MINKSUM_OUTSIDE,     /**< the result contains the exact set */
  MINKSUM_INSIDE       /**< the result is contained in the exact set */
} minksum_side;
/** What an offset has at corners: see `minksum::Join`. */
typedef enum minksum_join {
  MINKSUM_JOIN_ROUND = 0, /**< an arc around the vertex */
  MINKSUM_JOIN_MITER,     /**< both edges go on until they meet */
  MINKSUM_JOIN_SQUARE,    /**< cut at the distance from the vertex */
  MINKSUM_JOIN_BEVEL      /**< cut from edge to edge */
} minksum_join;
/** What an offset has at the ends of polylines: see `minksum::Cap`. */
typedef enum minksum_cap {
  MINKSUM_CAP_ROUND = 0, /**< a semicircle */
  MINKSUM_CAP_BUTT,      /**< nothing */
  MINKSUM_CAP_SQUARE     /**< it goes on by the distance */
} minksum_cap;

/** What an offset can be told beyond its distance. */
typedef struct minksum_offset_options {
  minksum_join join;  /**< at corners */
  minksum_cap cap;    /**< at ends of polylines, and around points */
  minksum_side side;  /**< of round joins and caps */
  double miter_limit; /**< how far a miter may reach, in multiples of the distance */
  double tolerance;   /**< how far the result may be off; 0 = a thousandth of the distance */
} minksum_offset_options;
/** Sets the defaults. */
MINKSUM_API void minksum_offset_options_init(minksum_offset_options *offset_options);
/** `geometry` grown by `distance`, or shrunk if that is negative. */
MINKSUM_API minksum_status minksum_offset(const minksum_geometry *geometry, double distance,
                                          const minksum_offset_options *offset_options,
                                          const minksum_options *options, minksum_geometry **result,
                                          minksum_error *error);
/** A polygon that stands for the disc of this radius around the origin. */
MINKSUM_API minksum_status minksum_disc(double radius, double tolerance, minksum_side side,
                                        minksum_geometry **result, minksum_error *error);

/** The set of points that the rings mean, with valid polygons. */
MINKSUM_API minksum_status minksum_resolve(const minksum_geometry *geometry,
                                           const minksum_options *options,
                                           minksum_geometry **result, minksum_error *error);
/** Rounds so that the result stays valid: to doubles if `decimals` is negative, else to so many
 * digits after the point. `geometry` must be a result of an operation. */
MINKSUM_API minksum_status minksum_round(const minksum_geometry *geometry, minksum_side side,
                                         int decimals, const minksum_options *options,
                                         minksum_geometry **result, minksum_error *error);
/** The image by (x, y) ↦ (m₀ x + m₁ y + m₂, m₃ x + m₄ y + m₅). */
MINKSUM_API minksum_status minksum_transform(const minksum_geometry *geometry, const double m[6],
                                             const minksum_options *options,
                                             minksum_geometry **result, minksum_error *error);

/* -- Questions ------------------------------------------------------------------------------ */

/** Finds up to `capacity` faults of the polygons: `faults` receives them as errors, with the place
 * of each in `message`. `count` receives their number; 0 = valid. */
MINKSUM_API minksum_status minksum_validate(const minksum_geometry *geometry,
                                            const minksum_options *options, minksum_error *faults,
                                            size_t capacity, size_t *count, minksum_error *error);
/** The area of the polygons, correct to a few units in the last place. */
MINKSUM_API minksum_status minksum_area(const minksum_geometry *geometry, double *area,
                                        minksum_error *error);
/** The bounding box of the polygons: min x, min y, max x, max y; `found` receives 0 if there are
 * none. */
MINKSUM_API minksum_status minksum_bounding_box(const minksum_geometry *geometry, double box[4],
                                                int *found, minksum_error *error);

/** Where a point lies. */
typedef enum minksum_location {
  MINKSUM_IS_OUTSIDE = 0, /**< it is not of the set */
  MINKSUM_IS_ON_BOUNDARY, /**< or on a polyline, or a point */
  MINKSUM_IS_INSIDE       /**< in the inside of the area */
} minksum_location;
/** A geometry of which many points are asked. */
typedef struct minksum_locator minksum_locator;
/** Prepares a geometry for that. It must be a result of an operation. */
MINKSUM_API minksum_status minksum_locator_new(const minksum_geometry *geometry,
                                               const minksum_options *options,
                                               minksum_locator **result, minksum_error *error);
/** Frees a locator. */
MINKSUM_API void minksum_locator_free(minksum_locator *locator);
/** Where (x, y) lies, exactly. */
MINKSUM_API minksum_status minksum_locate(const minksum_locator *locator, double x, double y,
                                          minksum_location *location, minksum_error *error);

/** How two sets stand to each other: see `minksum::Depth`. */
typedef struct minksum_depth {
  int found;        /**< 0 if a set is empty; the rest says nothing then */
  int overlapping;  /**< whether the interiors meet */
  double vector[2]; /**< the shortest motion of b after which a and b touch */
  double distance;  /**< its length */
} minksum_depth;
/** How deep a and b overlap, or how far they are apart. */
MINKSUM_API minksum_status minksum_penetration_depth(const minksum_geometry *a,
                                                     const minksum_geometry *b,
                                                     const minksum_options *options,
                                                     minksum_depth *depth, minksum_error *error);
/** The smallest factor for which b, moved by factor * direction, touches or overlaps a. `found`
 * receives 0 if it never does. */
MINKSUM_API minksum_status minksum_time_of_impact(const minksum_geometry *a,
                                                  const minksum_geometry *b,
                                                  const double direction[2],
                                                  const minksum_options *options, double *factor,
                                                  int *found, minksum_error *error);

/** What a check found out: see `minksum::SumCheck`. */
typedef struct minksum_sum_check {
  int ok;                 /**< whether nothing speaks against the result */
  size_t faults;          /**< why the result is not valid; 0 = it is */
  uint64_t points;        /**< that were tested */
  uint64_t disagreements; /**< points that are in one of result and sum only */
  int proved;             /**< 1: the result is the sum; 0: it is not; -1: not tried */
} minksum_sum_check;
/** Whether `result` is a ⊕ b, up to `within` in x and in y, by methods of their own. */
MINKSUM_API minksum_status minksum_check_sum(const minksum_geometry *result,
                                             const minksum_geometry *a, const minksum_geometry *b,
                                             double within, const minksum_options *options,
                                             minksum_sum_check *check, minksum_error *error);

/* -- Placing parts ---------------------------------------------------------------------------- */

/** Placements of `moving`'s reference point where it touches or overlaps `fixed`. Without a
 * reference point (NULL) it is the first vertex. */
MINKSUM_API minksum_status minksum_no_fit_polygon(const minksum_geometry *fixed,
                                                  const minksum_geometry *moving,
                                                  const double reference[2],
                                                  const minksum_options *options,
                                                  minksum_geometry **result, minksum_error *error);
/** Placements of `part`'s reference point that put it into `bin`. */
MINKSUM_API minksum_status minksum_inner_fit_polygon(
    const minksum_geometry *bin, const minksum_geometry *part, const double reference[2],
    const minksum_options *options, minksum_geometry **result, minksum_error *error);

/** The no-fit polygons of all pairs of parts, in 1, 2 or 4 directions. They have tight places
 * unless options say no. */
typedef struct minksum_no_fit_table minksum_no_fit_table;
/** Makes all sums. Parts are laid in 1, 2 or 4 directions (`turns`). */
MINKSUM_API minksum_status minksum_no_fit_table_new(const minksum_geometry *const *parts,
                                                    size_t count, int turns,
                                                    const minksum_options *options,
                                                    minksum_no_fit_table **result,
                                                    minksum_error *error);
/** Frees a table. */
MINKSUM_API void minksum_no_fit_table_free(minksum_no_fit_table *table);
/** The no-fit polygon of two parts: part `fixed` turned by fixed_turn / turns of a full turn, and
 * so for `moving`. */
MINKSUM_API minksum_status minksum_no_fit_table_at(const minksum_no_fit_table *table, size_t fixed,
                                                   int fixed_turn, size_t moving, int moving_turn,
                                                   minksum_geometry **result, minksum_error *error);

/* -- Robots ----------------------------------------------------------------------------------- */

/** What a configuration space can be told beyond its shapes. */
typedef struct minksum_space_options {
  double reference[2];               /**< the point of the robot that it turns about */
  const minksum_geometry *workspace; /**< that the robot must stay in; NULL = none */
  double tolerance;                  /**< of turns, in degrees */
} minksum_space_options;
/** Sets the defaults. */
MINKSUM_API void minksum_space_options_init(minksum_space_options *space_options);

/** Where a robot can be among obstacles: see `minksum::ConfigurationSpace`. */
typedef struct minksum_space minksum_space;
/** Makes all that does not depend on the robot's turn. */
MINKSUM_API minksum_status minksum_space_new(const minksum_geometry *robot,
                                             const minksum_geometry *obstacles,
                                             const minksum_space_options *space_options,
                                             const minksum_options *options, minksum_space **result,
                                             minksum_error *error);
/** Frees a configuration space. */
MINKSUM_API void minksum_space_free(minksum_space *space);
/** The obstacles, and free space unless that is NULL, of the robot turned by `degrees`. */
MINKSUM_API minksum_status minksum_space_slice(const minksum_space *space, double degrees,
                                               minksum_geometry **obstacles,
                                               minksum_geometry **free_space, minksum_error *error);

/** A robot's place and turn. */
typedef struct minksum_configuration {
  double x;       /**< of the reference point */
  double y;       /**< of the reference point */
  double degrees; /**< counter-clockwise */
} minksum_configuration;
/** Whether a robot gets there, and how: see `minksum::Reach`. */
typedef struct minksum_reach {
  int reachable;               /**< whether there is a path */
  size_t count;                /**< waypoints */
  minksum_configuration *path; /**< free it with minksum_reach_free */
} minksum_reach;
/** Whether the robot gets from one configuration to another, turning in steps of
 * a full turn over `angles`. With `certain` the path is free at all angles between. */
MINKSUM_API minksum_status minksum_find_path(const minksum_geometry *robot,
                                             const minksum_geometry *obstacles,
                                             minksum_configuration from, minksum_configuration to,
                                             size_t angles, int certain,
                                             const minksum_space_options *space_options,
                                             const minksum_options *options, minksum_reach *result,
                                             minksum_error *error);
/** Frees the path. */
MINKSUM_API void minksum_reach_free(minksum_reach *reach);

#ifdef __cplusplus
}
#endif

#endif
