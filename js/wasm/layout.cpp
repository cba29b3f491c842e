// Holds that the C interface lies in memory as js/src/abi.ts reads and writes it.
#include <minksum_c.h>

#include <cstddef>

#define AT(type, member, offset) static_assert(offsetof(type, member) == (offset))

static_assert(sizeof(minksum_error) == 600);
AT(minksum_error, operand, 4);
AT(minksum_error, polygon, 8);
AT(minksum_error, ring, 12);
AT(minksum_error, vertex, 16);
AT(minksum_error, line, 20);
AT(minksum_error, column, 24);
AT(minksum_error, limit, 28);
AT(minksum_error, message, 88);
static_assert(sizeof(minksum_options) == 40);
AT(minksum_options, max_crossings, 8);
AT(minksum_options, fill, 16);
AT(minksum_options, regularize, 20);
AT(minksum_options, tight, 24);
AT(minksum_options, threads, 28);
AT(minksum_options, progress, 32);
static_assert(sizeof(minksum_counts) == 24);
static_assert(sizeof(minksum_origin) == 12);
static_assert(sizeof(minksum_read_options) == 32);
AT(minksum_read_options, join_ends, 8);
AT(minksum_read_options, side, 16);
AT(minksum_read_options, drop_z, 20);
AT(minksum_read_options, column, 24);
static_assert(sizeof(minksum_offset_options) == 32);
AT(minksum_offset_options, cap, 4);
AT(minksum_offset_options, side, 8);
AT(minksum_offset_options, miter_limit, 16);
AT(minksum_offset_options, tolerance, 24);
static_assert(sizeof(minksum_depth) == 32);
AT(minksum_depth, overlapping, 4);
AT(minksum_depth, vector, 8);
AT(minksum_depth, distance, 24);
static_assert(sizeof(minksum_sum_check) == 32);
AT(minksum_sum_check, faults, 4);
AT(minksum_sum_check, points, 8);
AT(minksum_sum_check, disagreements, 16);
AT(minksum_sum_check, proved, 24);
static_assert(sizeof(minksum_space_options) == 32);
AT(minksum_space_options, workspace, 16);
AT(minksum_space_options, tolerance, 24);
static_assert(sizeof(minksum_configuration) == 24);
AT(minksum_reach, count, 4);
AT(minksum_reach, path, 8);
AT(minksum_reach, exact, 12);
static_assert(sizeof(minksum_statistics) == 128);
static_assert(sizeof(minksum_trace_counts) == 64);
AT(minksum_trace_counts, columns, 20);
AT(minksum_trace_counts, min_x, 32);
