// minksum info: what a file holds, and whether it is a legal operand.
#include <algorithm>
#include <iostream>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>

#include "commands.hpp"
#include "failure.hpp"
#include "minksum/measure.hpp"
#include "minksum/validity.hpp"
#include "output_file.hpp"

namespace minksum::cli {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMaxFaults = 100;
// A decimal is easier to read than a fraction, if it is short.
constexpr int kMaxReadableDigits = 40;

struct Findings {
  std::size_t parts = 0;
  std::size_t holes = 0;
  std::size_t vertices = 0;
  std::optional<Box> box;
  Rational area;
  std::size_t bits = 0;
  std::vector<Fault> faults;
};

Findings examine(const Region& region) {
  return {region.polygon_count(),      region.hole_count(), region.vertex_count(),
          bounding_box(region),        area(region),        coordinate_bits(region),
          validate(region, kMaxFaults)};
}

// The number exactly: as a decimal if it is one of few digits, else as a fraction and about.
std::string readable(const Rational& value) {
  if (value.is_integer()) return value.to_string();
  for (int digits = 1; digits <= kMaxReadableDigits; ++digits) {
    std::string text = value.to_decimal(digits);
    if (Rational::parse(text) == value) return text;
  }
  std::ostringstream text;
  text.exceptions(std::ios::badbit);  // else a stream out of memory is just a shorter text
  text.precision(17);
  text << value.to_string() << " (about " << value.to_double() << ")";
  return text.str();
}

std::string described(const Fault& fault) {
  std::ostringstream text;
  text.exceptions(std::ios::badbit);  // else a stream out of memory is just a shorter text
  text.precision(17);
  if (const std::string place = describe(fault.place); !place.empty()) text << place << ": ";
  text << fault.message << " (near " << fault.x << " " << fault.y << ")";
  return text.str();
}

void write_text(std::ostream& out, const Findings& findings) {
  out << "parts     " << findings.parts << "\nholes     " << findings.holes << "\nvertices  "
      << findings.vertices << '\n';
  if (findings.box) {
    const Box& box = *findings.box;
    out << "x         from " << readable(box.min.x) << " to " << readable(box.max.x)
        << "\ny         from " << readable(box.min.y) << " to " << readable(box.max.y) << '\n';
  } else {
    out << "box       none: the region is empty\n";
  }
  out << "area      " << readable(findings.area) << "\nbits      " << findings.bits << '\n';
  out << "valid     " << (findings.faults.empty() ? "yes" : "no") << '\n';
  for (const Fault& fault : findings.faults) out << "fault     " << described(fault) << '\n';
  if (findings.faults.size() == kMaxFaults) {
    out << "          (the first " << kMaxFaults << " faults; there may be more)\n";
  }
}

Json point_json(const Point& point) { return {point.x.to_string(), point.y.to_string()}; }

Json fault_json(const Fault& fault) {
  Json json;
  const auto add = [&json](const char* key, std::size_t index) {
    if (index != Culprit::kNone) json[key] = index + 1;
  };
  add("polygon", fault.place.polygon);
  add("ring", fault.place.ring);
  add("vertex", fault.place.vertex);
  json["near"] = {fault.x, fault.y};
  json["message"] = fault.message;
  return json;
}

void write_json(std::ostream& out, const std::string& file, const Findings& findings) {
  Json json;
  json["file"] = file;
  json["parts"] = findings.parts;
  json["holes"] = findings.holes;
  json["vertices"] = findings.vertices;
  json["box"] = nullptr;
  if (findings.box) {
    json["box"] = Json::object();
    json["box"]["min"] = point_json(findings.box->min);
    json["box"]["max"] = point_json(findings.box->max);
  }
  json["area"] = findings.area.to_double();
  json["area_exact"] = findings.area.to_string();
  json["coordinate_bits"] = findings.bits;
  json["valid"] = findings.faults.empty();
  json["faults"] = Json::array();
  for (const Fault& fault : findings.faults) json["faults"].push_back(fault_json(fault));
  // File names and messages may hold any bytes; JSON holds only UTF-8.
  out << json.dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
}

}  // namespace

int run_info(const InfoArguments& arguments) {
  const Region region = read_operand(arguments.file, arguments.limits);
  const Findings findings = examine(region);
  write_output("", [&](std::ostream& out) {
    if (arguments.json) {
      write_json(out, arguments.file, findings);
    } else {
      write_text(out, findings);
    }
  });
  if (findings.faults.empty()) return kFine;
  const std::string several = findings.faults.size() == 1 ? "" : ", the first of several faults";
  throw failure_of(Error(ErrorCode::kBadInput,
                         "not valid" + several + ": " + described(findings.faults.front())),
                   arguments.file);
}

}  // namespace minksum::cli
