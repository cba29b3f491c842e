#include "output/trace_files.hpp"

#include <ostream>

#include "minksum/io.hpp"
#include "output/numbers.hpp"
#include "pictures/sum_picture.hpp"
#include "pictures/svg_picture.hpp"

namespace minksum::cli {
namespace {

constexpr double kTraceCaption = 52;
// Ticks on more segments would only blacken the picture, so they are left out; the caption tells.
constexpr std::size_t kMaxTicked = 30'000;

using Segment = Trace::Segment;
using Vertex = Trace::Vertex;

// The text is appended piece by piece, because g++ 12 warns of an impossible copy in `"[" + text`.
std::string position(const Vertex& v) {
  std::string text = "[";
  text.append(shortest(v.x)).append(",").append(shortest(v.y)).append("]");
  return text;
}

// Writes a GeoJSON FeatureCollection, feature by feature.
class Features {
 public:
  explicit Features(std::ostream& out) : out_(out) {
    out_ << "{\"type\":\"FeatureCollection\",\"features\":[";
  }
  void add(const std::string& properties, const char* type, const std::string& coordinates) {
    out_ << (first_ ? "\n" : ",\n") << "{\"type\":\"Feature\",\"properties\":{" << properties
         << "},\"geometry\":{\"type\":\"" << type << "\",\"coordinates\":" << coordinates << "}}";
    first_ = false;
  }
  void add(const Segment& segment) {
    std::string properties(segment.edge_of_first ? R"("edge_of":"P")" : R"("edge_of":"Q")");
    properties.append(segment.kept ? R"(,"kept":true)" : R"(,"kept":false)");
    add(properties, "LineString",
        std::string("[").append(position(segment.from)) + "," + position(segment.to) + "]");
  }
  void add(const Trace::Loop& loop) {
    std::string ring = "[[";
    for (const Vertex& v : loop.vertices) ring += position(v) + ",";
    if (!loop.vertices.empty()) ring += position(loop.vertices.front());
    static constexpr const char* kStates[] = {"accepted", "rejected by nesting",
                                              "rejected by collision"};
    add(std::string("\"positive\":") + (loop.positive ? "true" : "false") + ",\"state\":\"" +
            kStates[static_cast<std::size_t>(loop.state)] + "\"",
        "Polygon", ring + "]]");
  }
  void finish() { out_ << "\n]}\n"; }

 private:
  std::ostream& out_;
  bool first_ = true;
};

class TraceWriter {
 public:
  TraceWriter(OutputFiles& files, std::string folder, const Drawing& drawing, const Trace& trace)
      : files_(files), folder_(std::move(folder)), drawing_(drawing), trace_(trace) {
    extent_.include(drawing.sum);
    for (const Segment& s : trace.convolution) {
      extent_.include(s.from.x, s.from.y);
      extent_.include(s.to.x, s.to.y);
    }
    scale_ = fitting_scale(extent_, kPageWidth - 2 * kPageMargin, kPageHeight);
  }

  void write_all() {
    write_operands();
    write_convolution();
    write_cover();
    write_arrangement();
    write_loops();
    write_rejected();
    write_result();
  }

 private:
  void save(const std::string& name, const std::string& text) const {
    files_.write(folder_ + "/" + name, [&text](std::ostream& out) { out << text; });
  }
  template <typename Fill>
  void save_features(const std::string& name, Fill fill) const {
    files_.write(folder_ + "/" + name + ".geojson", [&fill](std::ostream& out) {
      Features features(out);
      fill(features);
      features.finish();
    });
  }
  // Saves a picture with the sum's extent: title and note at the top, and `paint` below.
  template <typename Paint>
  void save_picture(const std::string& name, const std::string& title, const std::string& note,
                    Paint paint) const {
    const double height = 2 * kPageMargin + kTraceCaption + extent_.height() * scale_;
    SvgPicture picture(kPageWidth, height, title);
    picture.text(kPageMargin, kPageMargin + 14, "title", title);
    picture.text(kPageMargin, kPageMargin + 34, "note", note);
    if (!extent_.empty) {
      paint(picture, PictureTransform(extent_, kPageMargin, kPageMargin + kTraceCaption, scale_));
    }
    save(name + ".svg", std::move(picture).finish());
  }

  void write_operands() const {
    save("1-operands.svg", operands_picture(drawing_));
    files_.write(folder_ + "/1-operands.geojson", [this](std::ostream& out) {
      out << "{\"type\":\"FeatureCollection\",\"features\":[";
      const char* separator = "\n";
      for (const Geometry* geometry : {&drawing_.p, &drawing_.q}) {
        out << separator << "{\"type\":\"Feature\",\"properties\":{\"operand\":\""
            << (geometry == &drawing_.p ? "P" : "Q") << "\"},\"geometry\":";
        io::write(out, *geometry, io::Format::kGeoJson);
        out << "}";
        separator = ",\n";
      }
      out << "\n]}\n";
    });
  }

  void write_convolution() const {
    const bool ticked = trace_.convolution.size() <= kMaxTicked;
    const std::string note =
        grouped(trace_.convolution.size()) + " segments: edges of P blue, edges of Q orange; " +
        (ticked ? "ticks point to the outer side" : "too many to mark their outer sides");
    const auto of_first = [](const Segment& s) { return s.edge_of_first; };
    const auto of_second = [](const Segment& s) { return !s.edge_of_first; };
    save_picture("2-convolution", "Convolution", note,
                 [&](SvgPicture& picture, const PictureTransform& placement) {
                   picture.segments(trace_.convolution, placement, "edge-first", of_first);
                   picture.segments(trace_.convolution, placement, "edge-second", of_second);
                   if (!ticked) return;
                   picture.ticks(trace_.convolution, placement, "edge-first", of_first);
                   picture.ticks(trace_.convolution, placement, "edge-second", of_second);
                 });
    save_features("2-convolution", [this](Features& features) {
      for (const Segment& s : trace_.convolution) features.add(s);
    });
  }

  void write_cover() const;

  void write_arrangement() const {
    const std::string note = grouped(trace_.pieces.size()) + " pieces, " +
                             grouped(trace_.nodes.size()) + " nodes outside the cover";
    const auto any = [](const Segment&) { return true; };
    save_picture("4-arrangement", "Arrangement outside the cover", note,
                 [&](SvgPicture& picture, const PictureTransform& placement) {
                   picture.segments(trace_.pieces, placement, "edge-first", any);
                   picture.dots(trace_.nodes, placement, trace_.nodes.size() > 5000 ? 0.6 : 1.2,
                                "node");
                 });
    save_features("4-arrangement", [this](Features& features) {
      for (const Segment& s : trace_.pieces) features.add(s);
      for (const Vertex& v : trace_.nodes) features.add("\"node\":true", "Point", position(v));
    });
  }

  void write_loops() const {
    save_picture("5-loops", "Orientable loops",
                 grouped(trace_.loops.size()) + (trace_.loops.size() == 1 ? " loop" : " loops") +
                     ", on the convolution's segments",
                 [this](SvgPicture& picture, const PictureTransform& placement) {
                   picture.segments(trace_.pieces, placement, "dropped",
                                    [](const Segment&) { return true; });
                   paint_loops(picture, placement, "accepted", "accepted", "accepted");
                 });
    save_features("5-loops", [this](Features& features) {
      for (const Trace::Loop& loop : trace_.loops) features.add(loop);
    });
  }

  void write_rejected() const {
    std::size_t by_nesting = 0;
    std::size_t by_collision = 0;
    for (const Trace::Loop& loop : trace_.loops) {
      by_nesting += loop.state == Trace::LoopState::kRejectedByNesting;
      by_collision += loop.state == Trace::LoopState::kRejectedByCollision;
    }
    save_picture("6-rejected", "Rejected loops",
                 grouped(by_nesting) + " by nesting (pink), " + grouped(by_collision) +
                     " by collision (yellow)",
                 [this](SvgPicture& picture, const PictureTransform& placement) {
                   picture.region(drawing_.sum.region, placement, "pale");
                   paint_loops(picture, placement, "", "nesting", "collision");
                 });
    save_features("6-rejected", [this](Features& features) {
      for (const Trace::Loop& loop : trace_.loops) {
        if (loop.state != Trace::LoopState::kAccepted) features.add(loop);
      }
    });
  }

  void write_result() const {
    save_picture("7-result", "Result: P ⊕ Q", summary(drawing_.sum),
                 [this](SvgPicture& picture, const PictureTransform& placement) {
                   picture.geometry(drawing_.sum, placement, "sum");
                   if (drawing_.tight != nullptr) {
                     picture.thin_parts(*drawing_.tight, placement, "tight");
                   }
                 });
    files_.write(folder_ + "/7-result.geojson", [this](std::ostream& out) {
      io::write(out, drawing_.sum, io::Format::kGeoJson);
      out << '\n';
    });
  }

  // Draws loops, each kind in its style. A kind with an empty style is left out.
  void paint_loops(SvgPicture& picture, const PictureTransform& placement, const char* accepted,
                   const char* nesting, const char* collision) const {
    const char* const styles[] = {accepted, nesting, collision};
    for (const Trace::Loop& loop : trace_.loops) {
      const char* const style = styles[static_cast<std::size_t>(loop.state)];
      if (*style != '\0') picture.ring(loop.vertices, placement, style);
    }
  }

  OutputFiles& files_;
  std::string folder_;
  const Drawing& drawing_;
  const Trace& trace_;
  Extent extent_;
  double scale_ = 1;
};

void TraceWriter::write_cover() const {
  const Trace::Grid& grid = trace_.cover;
  std::size_t covered = 0;
  for (const bool cell : grid.covered) covered += cell;
  const std::string note =
      grid.columns == 0
          ? "no cover was used: every segment counts"
          : grouped(covered) + " of " + grouped(std::uint64_t{grid.columns} * grid.rows) +
                " cells are certainly inside; segments that touch no other are grey";
  save_picture("3-cover", "Cover", note,
               [&](SvgPicture& picture, const PictureTransform& placement) {
                 picture.cells(grid, placement, "covered");
                 const auto kept = [](bool first) {
                   return [first](const Segment& s) { return s.kept && s.edge_of_first == first; };
                 };
                 picture.segments(trace_.convolution, placement, "dropped",
                                  [](const Segment& s) { return !s.kept; });
                 picture.segments(trace_.convolution, placement, "edge-first", kept(true));
                 picture.segments(trace_.convolution, placement, "edge-second", kept(false));
               });
  files_.write(folder_ + "/3-cover.json", [&grid](std::ostream& out) {
    out << "{\"min_x\":" << shortest(grid.min_x) << ",\"min_y\":" << shortest(grid.min_y)
        << ",\"cell_width\":" << shortest(grid.cell_width)
        << ",\"cell_height\":" << shortest(grid.cell_height) << ",\"columns\":" << grid.columns
        << ",\"rows\":" << grid.rows << ",\"covered\":[";
    // Each row is a string in which "1" means covered; the lowest row comes first.
    for (std::uint32_t row = 0; row < grid.rows; ++row) {
      out << (row == 0 ? "\n\"" : ",\n\"");
      for (std::uint32_t column = 0; column < grid.columns; ++column) {
        out << (grid.covered[std::size_t{row} * grid.columns + column] ? '1' : '0');
      }
      out << '"';
    }
    out << "\n]}\n";
  });
}

}  // namespace

void write_trace(OutputFiles& files, const std::string& folder, const Drawing& drawing,
                 const Trace& trace) {
  TraceWriter(files, folder, drawing, trace).write_all();
}

}  // namespace minksum::cli
