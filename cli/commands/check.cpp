// minksum check: is a file the sum of two others?
#include "minksum/check.hpp"

#include <ostream>

#include "commands/commands.hpp"
#include "output/faults.hpp"
#include "output/json.hpp"
#include "output/numbers.hpp"
#include "output/output_file.hpp"
#include "process/failure.hpp"

namespace minksum::cli {
namespace {

std::string shown(const Point& point) {
  return shortest(point.x.to_double()) + " " + shortest(point.y.to_double());
}

const char* to_string(Proof proof) {
  switch (proof) {
    case Proof::kHolds: return "holds";
    case Proof::kRefuted: return "refuted";
    case Proof::kNotTried: return "not tried: too large for the second method";
  }
  return "";
}

void write_difference(std::ostream& out, const char* name, const std::optional<Difference>& part) {
  if (!part || !part->at) return;
  out << name << shortest(part->area);
  out << " (near " << shown(*part->at) << ")\n";
}

void write_text(std::ostream& out, const SumCheck& check) {
  out << "valid     " << (check.faults.empty() ? "yes" : "no") << '\n';
  for (const Fault& fault : check.faults) out << "fault     " << described(fault) << '\n';
  out << "points    " << check.points << " tested, " << check.disagreements << " wrong\n";
  for (const Disagreement& wrong : check.examples) {
    out << "wrong     " << shown(wrong.at)
        << (wrong.in_result ? " is in the result, not in the sum\n"
                            : " is in the sum, not in the result\n");
  }
  out << "area      " << shortest(check.result_area);
  if (check.sum_area) out << ", of the sum " << shortest(*check.sum_area);
  out << "\nproof     " << to_string(check.proof) << '\n';
  write_difference(out, "missing   ", check.missing);
  write_difference(out, "surplus   ", check.surplus);
  if (check.thin_parts_differ) out << "thin      polylines or points differ\n";
  out << "verdict   " << (check.ok() ? "no error found" : "not the sum") << '\n';
}

Json difference_json(const std::optional<Difference>& part) {
  if (!part) return nullptr;
  Json json{{"area", part->area}};
  if (part->at) json["near"] = {part->at->x.to_double(), part->at->y.to_double()};
  return json;
}

void write_json(std::ostream& out, const SumCheck& check) {
  Json json{{"ok", check.ok()}, {"valid", check.faults.empty()}};
  json["faults"] = Json::array();
  for (const Fault& fault : check.faults) json["faults"].push_back(fault_json(fault));
  json["points"] = check.points;
  json["disagreements"] = check.disagreements;
  json["examples"] = Json::array();
  for (const Disagreement& wrong : check.examples) {
    json["examples"].push_back({{"at", {wrong.at.x.to_string(), wrong.at.y.to_string()}},
                                {"near", {wrong.at.x.to_double(), wrong.at.y.to_double()}},
                                {"in_result", wrong.in_result}});
  }
  json["proof"] = check.proof == Proof::kNotTried ? "not tried" : to_string(check.proof);
  json["result_area"] = check.result_area;
  json["sum_area"] = check.sum_area ? Json(*check.sum_area) : Json(nullptr);
  json["missing"] = difference_json(check.missing);
  json["surplus"] = difference_json(check.surplus);
  json["thin_parts_differ"] = check.thin_parts_differ;
  out << json.dump(2) << '\n';
}

}  // namespace

int run_check(const CheckArguments& arguments) {
  const auto read = [&arguments](const std::string& file) {
    return read_operand(file, arguments.limits, arguments.options.fill).geometry;
  };
  const Geometry result = read_operand(arguments.result, arguments.limits).geometry;
  const Geometry operands[2] = {read(arguments.operands[0]), read(arguments.operands[1])};
  SumCheck check;
  try {
    check = check_sum(result, operands[0], operands[1], arguments.options);
  } catch (const Error& error) {
    fail_about(error, arguments.operands);
  }
  write_standard_output(
      [&](std::ostream& out) { arguments.json ? write_json(out, check) : write_text(out, check); });
  return check.ok() ? kFine : kWrongResult;
}

}  // namespace minksum::cli
