/** \file
 * The C interface of minksum: exact Minkowski sums of planar sets, and what people use them for.
 *
 * Conventions
 *   - Every function that can fail returns a minksum_status and fills a minksum_error, which may be
 *     NULL. On failure the results are NULL or 0, and nothing has to be freed.
 *   - A `minksum_geometry **` among the last arguments receives a new geometry. Free it with
 *     minksum_geometry_free. It is overwritten in any case: keep the pointer to an argument.
 *   - Options may be NULL, which means the defaults. To set one, call minksum_options_init first:
 *     a struct of zeros is not the defaults. It asks for all cores and drops tight places.
 *   - Coordinates in arrays are doubles, x and y of each point in turn. A double means exactly
 *     itself. To read exact results, write them as text (minksum_write with MINKSUM_EXACT).
 *   - A geometry never changes once it is made, except by the functions that add to it. Any number
 *     of threads may use one at the same time. No function keeps global state.
 *   - What is made of a geometry or an array has copies: the arguments may be freed after the call.
 *   - Lengths are in the unit of the coordinates, and angles in degrees, counter-clockwise.
 *
 * Errors
 *   - MINKSUM_BAD_INPUT: an argument is NULL that must not be, an enumerator does not exist, or a
 *     coordinate is NaN or infinite. Further reasons stand with each function.
 *   - MINKSUM_LIMIT_EXCEEDED: memory ran out, or a limit was exceeded, which `limit` names.
 *   - MINKSUM_CANCELLED: `progress` asked to stop.
 *   - Polygons that are not valid are errors by MINKSUM_FILL_STRICT, or where a function says so.
 *     Then the error has polygon, ring and vertex, and operand if there are several sets.
 *
 * Complexity, sources and further errors are those of the C++ functions of the same names
 * (minksum/minksum.hpp).
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

/** Says how a function ended. */
typedef enum minksum_status {
  MINKSUM_OK = 0,             /**< all went well */
  MINKSUM_BAD_INPUT = 1,      /**< an argument is not what it must be */
  MINKSUM_LIMIT_EXCEEDED = 2, /**< a limit was exceeded, or memory ran out */
  MINKSUM_CANCELLED = 3,      /**< `progress` asked to stop */
  MINKSUM_INTERNAL = 4        /**< an invariant of the library broke: please report it */
} minksum_status;

/** The value of an index that is not known. */
#define MINKSUM_NONE SIZE_MAX

/** Tells what went wrong, and where. */
typedef struct minksum_error {
  minksum_status status; /**< what the function returned */
  int operand;           /**< the set to blame, from 0; -1 = none */
  size_t polygon;        /**< its polygon; from 0 here and below, MINKSUM_NONE = not known */
  size_t ring;           /**< the ring in its polygon: 0 = outer, 1.. = holes */
  size_t vertex;         /**< the vertex in its ring */
  size_t line;           /**< the line of a text; from 1 here and below, 0 = not known */
  size_t column;         /**< the column in that line */
  char limit[48];       /**< the exceeded limit, such as "Limits::max_segments"; "" = none */
  uint64_t limit_value; /**< what was allowed; 0 if the limit is not a count */
  char message[512];    /**< what went wrong, in words */
} minksum_error;

/** Says which points rings of any kind enclose: see `minksum::FillRule`. */
typedef enum minksum_fill {
  MINKSUM_FILL_AUTOMATIC = 0, /**< what the outer ring encloses, without the holes */
  MINKSUM_FILL_EVEN_ODD,      /**< the winding number is odd */
  MINKSUM_FILL_NON_ZERO,      /**< the winding number is not 0 */
  MINKSUM_FILL_POSITIVE,      /**< the winding number is more than 0 */
  MINKSUM_FILL_NEGATIVE,      /**< the winding number is less than 0 */
  MINKSUM_FILL_STRICT         /**< polygons must be valid */
} minksum_fill;

/** Says what an operation is doing: a stage of a sum, or something besides sums. */
typedef enum minksum_stage {
  MINKSUM_STAGE_OPERANDS = 0, /**< operands are read, validated and put on their common grid */
  MINKSUM_STAGE_CONVOLUTION,  /**< the segments of the reduced convolution are listed */
  MINKSUM_STAGE_COVER,        /**< cells that are certainly inside the sum are found */
  MINKSUM_STAGE_ARRANGEMENT,  /**< the segments outside the cover are intersected */
  MINKSUM_STAGE_LOOPS,        /**< orientable loops are extracted */
  MINKSUM_STAGE_FILTERS,      /**< false loops are rejected */
  MINKSUM_STAGE_OUTPUT,       /**< the result is written */
  MINKSUM_STAGE_OVERLAY,      /**< fill rules and boolean operations are computed */
  MINKSUM_STAGE_ROUNDING,     /**< exact numbers become doubles or decimals */
  MINKSUM_STAGE_CHECKING,     /**< a result is verified */
  MINKSUM_STAGE_SEARCH        /**< paths, distances and contacts are searched for */
} minksum_stage;

/** The options of all operations: see `minksum::Options`. */
typedef struct minksum_options {
  uint64_t max_segments;  /**< see `minksum::Limits`; 0 = the default */
  uint64_t max_crossings; /**< see `minksum::Limits`; 0 = the default */
  minksum_fill fill;      /**< which points the operands' rings enclose */
  int regularize;         /**< not 0 = drop thin parts of the operands */
  int tight;              /**< keep tight places: 1 = yes, 0 = no, -1 = of no-fit polygons only */
  int threads;            /**< threads of an operation; 1 by default, 0 = one for each core */
  /** Called when a stage begins and every few milliseconds, by any thread, with the number of parts
   * that are done and of all parts. Any result but 0 stops the operation. It must return: neither
   * exceptions nor longjmp may leave it. May be NULL. */
  int (*progress)(void *context, minksum_stage stage, size_t done, size_t parts);
  void *context; /**< passed to `progress` */
} minksum_options;

/** Sets the defaults. NULL is allowed. */
MINKSUM_API void minksum_options_init(minksum_options *options);
/** Returns the version: "0.1.0". */
MINKSUM_API const char *minksum_version(void);

/* -- Geometries ----------------------------------------------------------------------------- */

/** Polygons with holes, polylines and points: any set with which the library computes. */
typedef struct minksum_geometry minksum_geometry;

/** Makes an empty geometry, to which others add. */
MINKSUM_API minksum_status minksum_geometry_empty(minksum_geometry **result, minksum_error *error);
/** Makes one polygon without holes from n points. The first point is not repeated. O(n). */
MINKSUM_API minksum_status minksum_geometry_polygon(const double *xy, size_t n,
                                                    minksum_geometry **result,
                                                    minksum_error *error);
/** Makes polygons with holes from flat arrays. Ring r has the points from `ring_offsets[r]` up to,
 * but without, `ring_offsets[r + 1]`. In the same way polygon p has the rings from
 * `polygon_offsets[p]` on, the outer ring first. Each array has one offset more than there are
 * rings or polygons, and begins with 0. O(n). Offsets that do not begin with 0 or that decrease
 * are MINKSUM_BAD_INPUT. */
MINKSUM_API minksum_status minksum_geometry_polygons(const double *xy, const int64_t *ring_offsets,
                                                     size_t rings, const int64_t *polygon_offsets,
                                                     size_t polygons, minksum_geometry **result,
                                                     minksum_error *error);
/** Adds a path along two or more points (n). It is closed if the last point repeats the first. */
MINKSUM_API minksum_status minksum_geometry_add_polyline(minksum_geometry *geometry,
                                                         const double *xy, size_t n,
                                                         minksum_error *error);
/** Adds n points. */
MINKSUM_API minksum_status minksum_geometry_add_points(minksum_geometry *geometry, const double *xy,
                                                       size_t n, minksum_error *error);
/** Makes a copy of a geometry. */
MINKSUM_API minksum_status minksum_geometry_copy(const minksum_geometry *geometry,
                                                 minksum_geometry **result, minksum_error *error);
/** Frees a geometry. This and all other functions that free allow NULL. */
MINKSUM_API void minksum_geometry_free(minksum_geometry *geometry);
/** Returns 1 if both are equal as stored, else 0. Equal results of operations are equal as
 * stored. */
MINKSUM_API int minksum_geometry_equal(const minksum_geometry *a, const minksum_geometry *b);

/** Tells how many parts a geometry has. */
typedef struct minksum_counts {
  size_t polygons;          /**< polygons: outer rings with their holes */
  size_t rings;             /**< rings: outer ones and holes */
  size_t vertices;          /**< vertices of all rings */
  size_t polylines;         /**< polylines */
  size_t polyline_vertices; /**< vertices of all polylines */
  size_t points;            /**< single points */
} minksum_counts;

/** Returns the counts of a geometry's parts, all 0 for NULL. */
MINKSUM_API minksum_counts minksum_geometry_counts(const minksum_geometry *geometry);
/** Fills arrays of 2 * vertices, rings + 1 and polygons + 1 elements with the polygons. Coordinates
 * are the nearest doubles, here and below. An array may be NULL. */
MINKSUM_API minksum_status minksum_geometry_get_polygons(const minksum_geometry *geometry,
                                                         double *xy, int64_t *ring_offsets,
                                                         int64_t *polygon_offsets,
                                                         minksum_error *error);
/** Fills arrays of 2 * polyline_vertices and polylines + 1 elements. An array may be NULL. */
MINKSUM_API minksum_status minksum_geometry_get_polylines(const minksum_geometry *geometry,
                                                          double *xy, int64_t *offsets,
                                                          minksum_error *error);
/** Fills an array of 2 * points elements with the points. */
MINKSUM_API minksum_status minksum_geometry_get_points(const minksum_geometry *geometry, double *xy,
                                                       minksum_error *error);

/** Says from which edge and which vertex of the operands an edge of a sum came. */
typedef struct minksum_origin {
  uint32_t edge_operand; /**< 0: the edge is of the first operand, and the vertex of the second */
  uint32_t edge;         /**< the index of the edge's first vertex */
  uint32_t vertex;       /**< the index of the vertex that moved the edge */
} minksum_origin;
/** Fills an array of as many elements as vertices: the origin of the edge that begins at each.
 * `found` receives 0 if the geometry has no origins, else 1. Sums have them if both operands have
 * valid polygons and no thin parts. */
MINKSUM_API minksum_status minksum_geometry_get_origins(const minksum_geometry *geometry,
                                                        minksum_origin *origins, int *found,
                                                        minksum_error *error);

/** Names a format that is written: see `minksum::io::Format`. */
typedef enum minksum_format {
  MINKSUM_WKT = 0, /**< Well-Known Text */
  MINKSUM_GEOJSON, /**< GeoJSON */
  MINKSUM_POLY,    /**< `.poly`, only without polylines and points */
  MINKSUM_SVG,     /**< a picture, which is only written */
  MINKSUM_WKB,     /**< Well-Known Binary: bytes, with MINKSUM_DOUBLES only */
  MINKSUM_HEX_WKB  /**< the same as hexadecimal digits */
} minksum_format;
/** Says as which numbers coordinates are written. */
typedef enum minksum_style {
  MINKSUM_DOUBLES = 0, /**< the nearest doubles */
  MINKSUM_EXACT,       /**< integers or p/q; GeoJSON has finite decimals where it can */
  MINKSUM_DECIMALS     /**< decimals with a number of digits after the point */
} minksum_style;

/** Reads a text or WKB, whose content tells its format. Numbers are read exactly. For what is not
 * well formed, the error has line and column, or for WKB the number of the byte in its message. */
MINKSUM_API minksum_status minksum_read(const char *text, size_t length, minksum_geometry **result,
                                        minksum_error *error);
/** Says to which side of the exact set a result may deviate. */
typedef enum minksum_side {
  MINKSUM_NEAREST = 0, /**< to both sides, as little as possible */
  MINKSUM_OUTSIDE,     /**< outwards: the result contains the exact set */
  MINKSUM_INSIDE       /**< inwards: the exact set contains the result */
} minksum_side;
/** Says how a text is read: see `minksum::io::ReadOptions`. */
typedef struct minksum_read_options {
  double tolerance; /**< how far the polyline of a drawing's curve may be off; 0 = no curves */
  double join_ends; /**< joins ends of a drawing's outlines that are at most so far apart */
  minksum_side side; /**< the side of curves */
  int drop_z;       /**< not 0 = drop heights and measures, which are errors otherwise */
  const char *column; /**< the column of a table that holds the geometries; NULL = it is found */
  const char *layer; /**< the only layer of a DXF drawing to read; NULL = all */
} minksum_read_options;
/** Sets the defaults. NULL is allowed. */
MINKSUM_API void minksum_read_options_init(minksum_read_options *read_options);
/** Reads as `minksum_read` does, with options. A negative number is MINKSUM_BAD_INPUT. */
MINKSUM_API minksum_status minksum_read_as(const char *text, size_t length,
                                           const minksum_read_options *read_options,
                                           minksum_geometry **result, minksum_error *error);
/** Writes a text. It ends with a zero byte, which `length` does not count; `length` may be NULL.
 * Only MINKSUM_DECIMALS uses `digits`, from 0 to 4096. Free the text with `minksum_text_free`. A
 * coordinate beyond the range of doubles is MINKSUM_LIMIT_EXCEEDED. */
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
MINKSUM_BINARY(sum);                  /**< makes a ⊕ b */
MINKSUM_BINARY(dilate);               /**< makes a ⊕ b, by another name */
MINKSUM_BINARY(erode);                /**< makes a ⊖ b: where b fits into a; b must not be empty */
MINKSUM_BINARY(open);                 /**< makes (a ⊖ b) ⊕ b; b must not be empty */
MINKSUM_BINARY(close);                /**< makes (a ⊕ b) ⊖ b; b must not be empty */
MINKSUM_BINARY(unite);                /**< makes a ∪ b, with thin parts */
MINKSUM_BINARY(intersect);            /**< makes the area that both have */
MINKSUM_BINARY(subtract);             /**< makes the area of a without that of b */
MINKSUM_BINARY(symmetric_difference); /**< makes the area that exactly one of both has */
#undef MINKSUM_BINARY

/** An operand for many sums: what depends on it alone is computed once. */
typedef struct minksum_prepared minksum_prepared;
/** Prepares an operand. `geometry` must have valid polygons and no thin parts. For polygons that
 * are not valid, the error has polygon, ring and vertex, but no operand. */
MINKSUM_API minksum_status minksum_prepare(const minksum_geometry *geometry,
                                           const minksum_options *options,
                                           minksum_prepared **result, minksum_error *error);
/** Frees a prepared operand. */
MINKSUM_API void minksum_prepared_free(minksum_prepared *prepared);
/** Makes a ⊕ b, as `minksum_sum` does. */
MINKSUM_API minksum_status minksum_sum_prepared(const minksum_prepared *a,
                                                const minksum_prepared *b,
                                                const minksum_options *options,
                                                minksum_geometry **result, minksum_error *error);

/** Says which shape an offset has at corners: see `minksum::Join`. */
typedef enum minksum_join {
  MINKSUM_JOIN_ROUND = 0, /**< an arc around the vertex */
  MINKSUM_JOIN_MITER,     /**< both edges, up to where they meet */
  MINKSUM_JOIN_SQUARE,    /**< a cut at the distance from the vertex */
  MINKSUM_JOIN_BEVEL      /**< a cut from edge to edge */
} minksum_join;
/** Says which shape an offset has at the ends of polylines: see `minksum::Cap`. */
typedef enum minksum_cap {
  MINKSUM_CAP_ROUND = 0, /**< a semicircle */
  MINKSUM_CAP_BUTT,      /**< nothing */
  MINKSUM_CAP_SQUARE     /**< it goes on by the distance */
} minksum_cap;

/** Says what an offset looks like: see `minksum::OffsetOptions`. */
typedef struct minksum_offset_options {
  minksum_join join;  /**< the shape at corners */
  minksum_cap cap;    /**< the shape at ends of polylines and around points */
  minksum_side side;  /**< the side of round joins and caps */
  double miter_limit; /**< the largest miter, in multiples of the distance */
  double tolerance;   /**< how far the result may deviate; 0 = a thousandth of the distance */
} minksum_offset_options;
/** Sets the defaults. NULL is allowed. */
MINKSUM_API void minksum_offset_options_init(minksum_offset_options *offset_options);
/** Makes `geometry` grown by `distance`, or shrunk if that is negative. A negative tolerance, a
 * miter limit below 1, and a side without round joins and caps are MINKSUM_BAD_INPUT. */
MINKSUM_API minksum_status minksum_offset(const minksum_geometry *geometry, double distance,
                                          const minksum_offset_options *offset_options,
                                          const minksum_options *options, minksum_geometry **result,
                                          minksum_error *error);
/** Makes a convex polygon that stands for the disc of this radius around the origin. Radius and
 * tolerance must be positive. */
MINKSUM_API minksum_status minksum_disc(double radius, double tolerance, minksum_side side,
                                        minksum_geometry **result, minksum_error *error);

/** Makes the set of points that a geometry means, with valid polygons. */
MINKSUM_API minksum_status minksum_resolve(const minksum_geometry *geometry,
                                           const minksum_options *options,
                                           minksum_geometry **result, minksum_error *error);
/** Rounds a geometry so that the result stays valid: to doubles if `decimals` is negative, else to
 * so many digits after the point, at most 4096. Polygons must be valid. Polylines and points that
 * all lie within the area, as the tight places of a no-fit polygon do, are rounded by themselves, to
 * the nearest whatever the side; they are dropped if `tight` of the options is 0. */
MINKSUM_API minksum_status minksum_round(const minksum_geometry *geometry, minksum_side side,
                                         int decimals, const minksum_options *options,
                                         minksum_geometry **result, minksum_error *error);
/** Makes the image by the map (x, y) ↦ (m₀ x + m₁ y + m₂, m₃ x + m₄ y + m₅). */
MINKSUM_API minksum_status minksum_transform(const minksum_geometry *geometry, const double m[6],
                                             const minksum_options *options,
                                             minksum_geometry **result, minksum_error *error);

/* -- What a sum is made of -------------------------------------------------------------------- */

/** Tells what the computation of a sum did: see `minksum::Statistics`. */
typedef struct minksum_statistics {
  double convolution_segments;  /**< segments of the convolution */
  double segments_kept;         /**< segments of which the arrangement is made */
  double crossings;             /**< crossings among them */
  double loops;                 /**< orientable loops, before any filter */
  double rejected_by_nesting;   /**< loops that the nesting filter dropped */
  double rejected_by_collision; /**< loops that the collision filter dropped */
  double grid_cells;            /**< cells of the cover's grid; 0 = there is no cover */
  double covered_cells;         /**< cells that certainly lie inside the sum */
  double seconds;               /**< time of the whole call */
  double stage_seconds[7];      /**< time of each stage, from MINKSUM_STAGE_OPERANDS on */
} minksum_statistics;

/** What the stages of a sum made: see `minksum::Trace`. */
typedef struct minksum_trace minksum_trace;
/** Makes a ⊕ b as `minksum_sum` does, and what else its computation tells. `tight` receives the
 * tight places, `statistics` what was done, and `trace` what the stages made. Each of these three
 * may be NULL. */
MINKSUM_API minksum_status minksum_detailed_sum(const minksum_geometry *a,
                                                const minksum_geometry *b,
                                                const minksum_options *options,
                                                minksum_geometry **result,
                                                minksum_geometry **tight,
                                                minksum_statistics *statistics,
                                                minksum_trace **trace, minksum_error *error);
/** Frees a trace. */
MINKSUM_API void minksum_trace_free(minksum_trace *trace);

/** Tells how much a trace holds, and how the cover's grid lies. */
typedef struct minksum_trace_counts {
  size_t segments;      /**< segments of the convolution */
  size_t nodes;         /**< nodes of the arrangement outside the cover */
  size_t pieces;        /**< pieces of the arrangement */
  size_t loops;         /**< orientable loops */
  size_t loop_vertices; /**< vertices of all loops */
  size_t columns;       /**< cells of the cover along x; 0 if there is no cover */
  size_t rows;          /**< cells of the cover along y */
  double min_x;         /**< x of the cover's left side */
  double min_y;         /**< y of its lower side */
  double cell_width;    /**< width of a cell */
  double cell_height;   /**< height of a cell */
} minksum_trace_counts;
/** Returns how much a trace holds, all 0 for NULL. */
MINKSUM_API minksum_trace_counts minksum_trace_get_counts(const minksum_trace *trace);
/** Fills arrays of 4 * segments and segments elements with the convolution: x and y of both ends,
 * and whether bit 0: the first operand has the edge, bit 1: the arrangement has the segment. Here
 * and below, an array may be NULL. */
MINKSUM_API minksum_status minksum_trace_get_convolution(const minksum_trace *trace, double *xy,
                                                         unsigned char *flags,
                                                         minksum_error *error);
/** Fills arrays of 4 * pieces and pieces elements with the arrangement's pieces, as above. */
MINKSUM_API minksum_status minksum_trace_get_pieces(const minksum_trace *trace, double *xy,
                                                    unsigned char *flags, minksum_error *error);
/** Fills an array of 2 * nodes elements with the arrangement's nodes. */
MINKSUM_API minksum_status minksum_trace_get_nodes(const minksum_trace *trace, double *xy,
                                                   minksum_error *error);
/** Fills an array of columns * rows elements: row by row from the lowest, 1 = the cell certainly
 * lies in the sum. */
MINKSUM_API minksum_status minksum_trace_get_cover(const minksum_trace *trace,
                                                   unsigned char *covered, minksum_error *error);
/** Fills arrays of 2 * loop_vertices, loops + 1 and loops elements with the loops. The low bits of
 * a state say what became of the loop: 0 = it is a ring of the sum, 1 = nesting rejected it, 2 =
 * collision rejected it. Bit 2 says whether it runs counter-clockwise. */
MINKSUM_API minksum_status minksum_trace_get_loops(const minksum_trace *trace, double *xy,
                                                   int64_t *offsets, unsigned char *states,
                                                   minksum_error *error);

/* -- Questions ------------------------------------------------------------------------------ */

/** Finds up to `capacity` faults of the polygons. `faults` receives them as errors, whose `message`
 * has the location as well. `count` receives their number. For a `capacity` of 1 or
 * more, 0 means that the polygons are valid. */
MINKSUM_API minksum_status minksum_validate(const minksum_geometry *geometry,
                                            const minksum_options *options, minksum_error *faults,
                                            size_t capacity, size_t *count, minksum_error *error);
/** Computes the area of the polygons, correct to a few units in the last place unless they are thin
 * or far from the origin, or outer rings and holes nearly cancel. Polygons far from the origin have
 * a relative error of at most 10^-9. */
MINKSUM_API minksum_status minksum_area(const minksum_geometry *geometry, double *area,
                                        minksum_error *error);
/** Computes the bounding box of the polygons: min x, min y, max x, max y. `found` receives 0 if
 * there are no polygons, else 1. */
MINKSUM_API minksum_status minksum_bounding_box(const minksum_geometry *geometry, double box[4],
                                                int *found, minksum_error *error);

/** Says where a point lies. */
typedef enum minksum_location {
  MINKSUM_IS_OUTSIDE = 0, /**< the point is not in the set */
  MINKSUM_IS_ON_BOUNDARY, /**< the point is on the boundary, a polyline or a single point */
  MINKSUM_IS_INSIDE       /**< the point is in the interior of the area */
} minksum_location;
/** A geometry that is prepared for asking where points lie. */
typedef struct minksum_locator minksum_locator;
/** Prepares a geometry for point location. */
MINKSUM_API minksum_status minksum_locator_new(const minksum_geometry *geometry,
                                               const minksum_options *options,
                                               minksum_locator **result, minksum_error *error);
/** Frees a locator. */
MINKSUM_API void minksum_locator_free(minksum_locator *locator);
/** Finds out where (x, y) lies, exactly. */
MINKSUM_API minksum_status minksum_locate(const minksum_locator *locator, double x, double y,
                                          minksum_location *location, minksum_error *error);

/** Tells how two sets stand to each other: see `minksum::Depth`. */
typedef struct minksum_depth {
  int found;        /**< 0 if a set is empty, and the rest means nothing */
  int overlapping;  /**< whether the interiors meet */
  double vector[2]; /**< the shortest move of b after which a and b only touch */
  double distance;  /**< the length of `vector` */
} minksum_depth;
/** Computes how deep a and b overlap, or how far they are apart. */
MINKSUM_API minksum_status minksum_penetration_depth(const minksum_geometry *a,
                                                     const minksum_geometry *b,
                                                     const minksum_options *options,
                                                     minksum_depth *depth, minksum_error *error);
/** Makes the exact vector of `minksum_penetration_depth`, as a single point, or an empty geometry
 * if a set is empty. */
MINKSUM_API minksum_status minksum_depth_vector(const minksum_geometry *a,
                                                const minksum_geometry *b,
                                                const minksum_options *options,
                                                minksum_geometry **result, minksum_error *error);
/** Computes the smallest factor ≥ 0 for which b, moved by factor * direction, touches or overlaps
 * a. `found` receives 0 if there is none, else 1. The direction must not be (0, 0). */
MINKSUM_API minksum_status minksum_time_of_impact(const minksum_geometry *a,
                                                  const minksum_geometry *b,
                                                  const double direction[2],
                                                  const minksum_options *options, double *factor,
                                                  int *found, minksum_error *error);
/** Makes the exact factor of `minksum_time_of_impact`, as the single point (factor, 0), or an empty
 * geometry if there is none. */
MINKSUM_API minksum_status minksum_impact_factor(const minksum_geometry *a,
                                                 const minksum_geometry *b,
                                                 const double direction[2],
                                                 const minksum_options *options,
                                                 minksum_geometry **result, minksum_error *error);

/** Tells what a check found: see `minksum::SumCheck`. */
typedef struct minksum_sum_check {
  int ok;                 /**< whether nothing speaks against the result */
  size_t faults;          /**< number of faults of the result; 0 = it is valid */
  uint64_t points;        /**< points that were tested */
  uint64_t disagreements; /**< points that only one of result and sum has */
  int proved;             /**< 1: the result is the sum; 0: it is not; -1: not tried */
} minksum_sum_check;
/** Checks by independent methods whether `result` is a ⊕ b, up to `within` in x and in y, which
 * must not be negative. */
MINKSUM_API minksum_status minksum_check_sum(const minksum_geometry *result,
                                             const minksum_geometry *a, const minksum_geometry *b,
                                             double within, const minksum_options *options,
                                             minksum_sum_check *check, minksum_error *error);

/* -- Placing parts ---------------------------------------------------------------------------- */

/** Makes the no-fit polygon: the placements of `moving`'s reference point at which it touches or
 * overlaps `fixed`. If `reference` is NULL, it is the first vertex of `moving`, which must have
 * one. */
MINKSUM_API minksum_status minksum_no_fit_polygon(const minksum_geometry *fixed,
                                                  const minksum_geometry *moving,
                                                  const double reference[2],
                                                  const minksum_options *options,
                                                  minksum_geometry **result, minksum_error *error);
/** Makes the inner-fit polygon: the placements of `part`'s reference point at which it lies in
 * `bin`. `reference` is as above. `part` must have an area. */
MINKSUM_API minksum_status minksum_inner_fit_polygon(
    const minksum_geometry *bin, const minksum_geometry *part, const double reference[2],
    const minksum_options *options, minksum_geometry **result, minksum_error *error);

/** Says how two placed parts stand to each other. */
typedef enum minksum_contact {
  MINKSUM_FREE = 0,   /**< they are apart */
  MINKSUM_TOUCHING,   /**< their boundaries meet, and their interiors do not */
  MINKSUM_OVERLAPPING /**< their interiors meet */
} minksum_contact;
/** Finds out how the parts stand to each other at n placements of the reference point. `contacts`
 * receives a minksum_contact for each. `no_fit` is their no-fit polygon with tight places. For a
 * placement that is not finite, the error has its index as vertex. */
MINKSUM_API minksum_status minksum_contacts(const minksum_geometry *no_fit, const double *xy,
                                            size_t n, int *contacts,
                                            const minksum_options *options, minksum_error *error);

/** The no-fit polygons of all pairs of parts in 1, 2 or 4 directions. They have tight places unless
 * options say no. */
typedef struct minksum_no_fit_table minksum_no_fit_table;
/** Makes the table of `count` parts, which are laid in 1, 2 or 4 directions (`turns`). For a part
 * without area, the error has the part's index as operand. */
MINKSUM_API minksum_status minksum_no_fit_table_new(const minksum_geometry *const *parts,
                                                    size_t count, int turns,
                                                    const minksum_options *options,
                                                    minksum_no_fit_table **result,
                                                    minksum_error *error);
/** Frees a table. */
MINKSUM_API void minksum_no_fit_table_free(minksum_no_fit_table *table);
/** Makes the no-fit polygon of two parts. Part `fixed` is turned by fixed_turn / turns of a full
 * turn, and `moving` likewise. A part or a turn that the table does not have is
 * MINKSUM_BAD_INPUT. */
MINKSUM_API minksum_status minksum_no_fit_table_at(const minksum_no_fit_table *table, size_t fixed,
                                                   int fixed_turn, size_t moving, int moving_turn,
                                                   minksum_geometry **result, minksum_error *error);

/* -- Robots ----------------------------------------------------------------------------------- */

/** Says what a configuration space depends on besides robot and obstacles. */
typedef struct minksum_space_options {
  double reference[2];               /**< the point about which the robot turns */
  const minksum_geometry *workspace; /**< the area that the robot must not leave; NULL = none */
  double tolerance;                  /**< tolerance of turns in degrees, from 1e-10 to 1 */
} minksum_space_options;
/** Sets the defaults. NULL is allowed. */
MINKSUM_API void minksum_space_options_init(minksum_space_options *space_options);

/** Where a robot can be among obstacles: see `minksum::ConfigurationSpace`. */
typedef struct minksum_space minksum_space;
/** Makes a configuration space, and all of it that does not depend on the robot's turn. The error
 * has operand 0 for a robot without area, and 2 for a workspace without area. It has operand 1 for
 * obstacles with thin parts if tight places are wanted. The space keeps `progress` and `context` for
 * its slices, so these must live as long as it does. */
MINKSUM_API minksum_status minksum_space_new(const minksum_geometry *robot,
                                             const minksum_geometry *obstacles,
                                             const minksum_space_options *space_options,
                                             const minksum_options *options, minksum_space **result,
                                             minksum_error *error);
/** Frees a configuration space. */
MINKSUM_API void minksum_space_free(minksum_space *space);
/** Makes the configuration-space obstacles of the robot turned by `degrees`, at most a million, and
 * its free space unless `free_space` is NULL. */
MINKSUM_API minksum_status minksum_space_slice(const minksum_space *space, double degrees,
                                               minksum_geometry **obstacles,
                                               minksum_geometry **free_space, minksum_error *error);

/** A placement and an angle of a robot. */
typedef struct minksum_configuration {
  double x;       /**< x of the reference point */
  double y;       /**< y of the reference point */
  double degrees; /**< the angle in degrees, counter-clockwise */
} minksum_configuration;
/** Tells whether a robot gets to its goal, and how: see `minksum::Reach`. */
typedef struct minksum_reach {
  int reachable;               /**< whether there is a path */
  size_t count;                /**< number of waypoints */
  minksum_configuration *path; /**< waypoints from start to goal */
  minksum_geometry *exact;     /**< the same exactly, as two points for each waypoint: the placement,
                                    and cosine and sine of the angle; NULL without a path */
} minksum_reach;
/** Finds out whether the robot gets from one configuration to another, turning in steps of a full
 * turn over `angles`. If `certain` is not 0, the path is free at all angles between as well. The
 * error has operand 3 if the robot is not free at `from`, and 4 at `to`. */
MINKSUM_API minksum_status minksum_find_path(const minksum_geometry *robot,
                                             const minksum_geometry *obstacles,
                                             minksum_configuration from, minksum_configuration to,
                                             size_t angles, int certain,
                                             const minksum_space_options *space_options,
                                             const minksum_options *options, minksum_reach *result,
                                             minksum_error *error);
/** Frees the path of a result, in both forms. */
MINKSUM_API void minksum_reach_free(minksum_reach *reach);

#ifdef __cplusplus
}
#endif

#endif
