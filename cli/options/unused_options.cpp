#include "options/unused_options.hpp"

#include <atomic>
#include <string>

#include "process/telling.hpp"

namespace minksum::cli {
namespace {

// A run reads its operands in many places, and what it tells on standard error is the process's.
// Each option is a bit.
std::atomic<unsigned> taken_options;

unsigned bit_of(ReadingOption option) { return 1U << static_cast<unsigned>(option); }

void note_unless_taken(ReadingOption option, bool is_typed, const char* text) {
  if (is_typed && (taken_options & bit_of(option)) == 0) note(text);
}

}  // namespace

void mark_taken(ReadingOption option) { taken_options |= bit_of(option); }
void mark_all_taken() { taken_options = ~0U; }

void mark_taken_by(io::Format format) {
  using enum io::Format;
  if (format == kSvg || format == kDxf) {
    mark_taken(ReadingOption::kTolerance);
    mark_taken(ReadingOption::kSide);
  }
  if (format == kDxf) mark_taken(ReadingOption::kJoinEnds);
  if (format == kDxf || format == kGdal) mark_taken(ReadingOption::kLayer);
  if (format == kTable) mark_taken(ReadingOption::kColumn);
}

void note_unused(const io::ReadOptions& typed) {
  const io::DrawingOptions& drawing = typed.drawing;
  using enum ReadingOption;
  note_unless_taken(kTolerance, drawing.tolerance.has_value(),
                    "--tolerance has no effect: nothing that was read is a drawing (SVG, DXF), "
                    "disc:R or ngon:N:R");
  note_unless_taken(kSide, drawing.side != RoundingSide::kNearest,
                    "--side has no effect: nothing that was read is a drawing (SVG, DXF) or "
                    "disc:R");
  note_unless_taken(kLayer, !drawing.layer.empty(),
                    "--layer has no effect: nothing that was read is DXF, or a file that GDAL "
                    "opens");
  note_unless_taken(kJoinEnds, drawing.join_ends.sign() > 0,
                    "--join-ends has no effect: nothing that was read is DXF");
  note_unless_taken(kColumn, !typed.column.empty(), kColumnIsUnused);
}

}  // namespace minksum::cli
