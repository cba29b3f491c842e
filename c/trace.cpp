// Implements the C interface for what the computation of a sum tells: statistics and the trace.
#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "handles.hpp"

using namespace minksum;     // NOLINT(google-build-using-namespace)
using namespace minksum::c;  // NOLINT(google-build-using-namespace)

namespace {

/// Counts are below 2^53, so that a double holds them.
minksum_statistics statistics_of(const Statistics& did) {
  const auto count = [](std::uint64_t value) { return static_cast<double>(value); };
  minksum_statistics result{count(did.convolution_segments),
                            count(did.segments_kept),
                            count(did.crossings),
                            count(did.loops),
                            count(did.rejected_by_nesting),
                            count(did.rejected_by_collision),
                            count(did.grid_cells),
                            count(did.covered_cells),
                            did.seconds,
                            {}};
  std::copy_n(did.stage_seconds, kSumStages, result.stage_seconds);
  return result;
}

void put(const Trace::Vertex& vertex, double*& xy) {
  *xy++ = vertex.x;
  *xy++ = vertex.y;
}

minksum_status get_segments(const minksum_trace* trace, std::vector<Trace::Segment> Trace::*list,
                            double* xy, unsigned char* flags, minksum_error* error) {
  return guarded(error, [&] {
    for (const Trace::Segment& segment : value_of(trace).*list) {
      if (xy != nullptr) put(segment.from, xy);
      if (xy != nullptr) put(segment.to, xy);
      if (flags != nullptr) {
        *flags++ =
            static_cast<unsigned char>((segment.edge_of_first ? 1 : 0) | (segment.kept ? 2 : 0));
      }
    }
  });
}

}  // namespace

minksum_status minksum_detailed_sum(const minksum_geometry* a, const minksum_geometry* b,
                                    const minksum_options* options, minksum_geometry** result,
                                    minksum_geometry** tight, minksum_statistics* statistics,
                                    minksum_trace** trace, minksum_error* error) {
  if (tight != nullptr) *tight = nullptr;
  if (trace != nullptr) *trace = nullptr;
  if (statistics != nullptr) *statistics = {};
  const minksum_status status = made(result, error, [&] {
    Options how = options_of(options);
    how.tight = tight != nullptr;
    DetailedSum sum = detailed_sum(value_of(a), value_of(b), how,
                                   trace != nullptr ? Detail::kTrace : Detail::kStatistics);
    if (statistics != nullptr) *statistics = statistics_of(sum.statistics);
    if (tight != nullptr) *tight = new minksum_geometry{std::move(sum.tight)};
    if (trace != nullptr) *trace = new minksum_trace{std::move(sum.trace)};
    return std::move(sum.sum);
  });
  if (status == MINKSUM_OK) return status;
  if (statistics != nullptr) *statistics = {};
  if (tight != nullptr) minksum_geometry_free(std::exchange(*tight, nullptr));
  if (trace != nullptr) minksum_trace_free(std::exchange(*trace, nullptr));
  return status;
}
void minksum_trace_free(minksum_trace* trace) { delete trace; }

minksum_trace_counts minksum_trace_get_counts(const minksum_trace* trace) {
  if (trace == nullptr) return {};
  const Trace& made = trace->value;
  std::size_t loop_vertices = 0;
  for (const Trace::Loop& loop : made.loops) loop_vertices += loop.vertices.size();
  return {made.convolution.size(), made.nodes.size(),     made.pieces.size(),    made.loops.size(),
          loop_vertices,           made.cover.columns,    made.cover.rows,       made.cover.min_x,
          made.cover.min_y,        made.cover.cell_width, made.cover.cell_height};
}
minksum_status minksum_trace_get_convolution(const minksum_trace* trace, double* xy,
                                             unsigned char* flags, minksum_error* error) {
  return get_segments(trace, &Trace::convolution, xy, flags, error);
}
minksum_status minksum_trace_get_pieces(const minksum_trace* trace, double* xy,
                                        unsigned char* flags, minksum_error* error) {
  return get_segments(trace, &Trace::pieces, xy, flags, error);
}
minksum_status minksum_trace_get_nodes(const minksum_trace* trace, double* xy,
                                       minksum_error* error) {
  return guarded(error, [&] {
    for (const Trace::Vertex& node : value_of(trace).nodes) {
      if (xy != nullptr) put(node, xy);
    }
  });
}
minksum_status minksum_trace_get_cover(const minksum_trace* trace, unsigned char* covered,
                                       minksum_error* error) {
  return guarded(error, [&] {
    for (const bool cell : value_of(trace).cover.covered) {
      if (covered != nullptr) *covered++ = cell ? 1 : 0;
    }
  });
}
minksum_status minksum_trace_get_loops(const minksum_trace* trace, double* xy, int64_t* offsets,
                                       unsigned char* states, minksum_error* error) {
  return guarded(error, [&] {
    std::int64_t end = 0;
    if (offsets != nullptr) *offsets++ = 0;
    for (const Trace::Loop& loop : value_of(trace).loops) {
      for (const Trace::Vertex& vertex : loop.vertices) {
        if (xy != nullptr) put(vertex, xy);
      }
      end += static_cast<std::int64_t>(loop.vertices.size());
      if (offsets != nullptr) *offsets++ = end;
      if (states != nullptr) {
        *states++ =
            static_cast<unsigned char>(static_cast<int>(loop.state) | (loop.positive ? 4 : 0));
      }
    }
  });
}
