// minksum check: tells whether a file is the sum of two others.
#include "minksum/check.hpp"

#include <ostream>

#include "commands/commands.hpp"
#include "commands/subcommands.hpp"
#include "options/limits.hpp"
#include "options/sum_options.hpp"
#include "options/typed_numbers.hpp"
#include "output/faults.hpp"
#include "output/json.hpp"
#include "output/numbers.hpp"
#include "output/output_file.hpp"
#include "output/result_file.hpp"
#include "process/failure.hpp"

namespace minksum::cli {
namespace {

std::string shown(const Point& point) {
  return shortest(point.x.to_double()) + " " + shortest(point.y.to_double());
}

const char* to_string(Proof proof) {
  constexpr const char* kNames[] = {"holds", "refuted",
                                    "not tried: too large for the second method"};
  return kNames[static_cast<std::size_t>(proof)];
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

Command describe_check(CommandLine& line, CheckArguments& arguments, ProcessLimits& limits) {
  const Command check = line.add_command(
      "check", "Whether a result, of minksum or of any program, is the sum of two geometries");
  check.footer(
      "\nDecided by other methods than `sum` uses: validity; points near edges, in holes and at\n"
      "random; and, where it is small enough for the second method, the whole sum exactly.\n"
      "Rounded results need --within. Exit code 5 if an error is found.\n");
  add_operand(check, "RESULT", arguments.result, "What is said to be the sum");
  add_operand(check, "P", arguments.operands[0], "The first operand");
  add_operand(check, "Q", arguments.operands[1], "The second operand");
  add_fill_option(check, arguments.options.fill);
  add_regularize_option(check, arguments.options.regularize);
  check
      .add_option(
          "--within",
          [&arguments](const std::string& text) {
            arguments.how.within = parse_number("--within", text);
            if (arguments.how.within.sign() < 0) {
              throw Failure(kWrongUsage, "--within takes a number that is not negative");
            }
          },
          "How far, in x and in y, the result may be off; 0, the default: not at all")
      .type_name("D");
  CheckOptions& how = arguments.how;
  add_count(check, "--samples", how.samples,
            "Random points, beside those near edges; 1000 without it");
  add_count(check, "--edges", how.edges,
            "Edges of the result near which points are tested; 10000 without it");
  add_count(check, "--seed", how.seed, "Seed of the random points");
  add_count(check, "--proof-segments", how.proof.max_segments,
            "Largest signed convolution for which the whole sum is compared");
  check.add_flag("--json", arguments.json, "As JSON");
  add_limit_options(check, limits, false);
  return check;
}

int run_check(const CheckArguments& arguments) {
  const auto& [p, q] = arguments.operands;
  const auto read = [&arguments](const std::string& file) {
    return read_operand(file, arguments.limits, arguments.options.fill);
  };
  const io::Document result = read_operand(arguments.result, arguments.limits);
  const io::Document operands[2] = {read(p), read(q)};
  // Numbers of two reference systems do not fit together.
  static_cast<void>(in_system_of({}, {result.source, operands[0].source}, {arguments.result, p}));
  static_cast<void>(in_system_of({}, {result.source, operands[1].source}, {arguments.result, q}));
  static_cast<void>(in_system_of({}, {operands[0].source, operands[1].source}, {p, q}));
  SumCheck check;
  try {
    check = check_sum(result.geometry, operands[0].geometry, operands[1].geometry, arguments.how,
                      arguments.options);
  } catch (const Error& error) {
    fail_about(error, arguments.operands);
  }
  write_standard_output(
      [&](std::ostream& out) { arguments.json ? write_json(out, check) : write_text(out, check); });
  return check.ok() ? kFine : kWrongResult;
}

}  // namespace

void convert(const CheckArguments& arguments) {
  const auto& [p, q] = arguments.operands;
  if ((arguments.result == "-") + (p == "-") + (q == "-") > 1) {
    throw Failure(kWrongUsage, "only one file can be standard input");
  }
}

void add_check(Program& program) { program.add(describe_check, run_check); }

}  // namespace minksum::cli
