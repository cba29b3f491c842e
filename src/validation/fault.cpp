#include "validation/fault.hpp"

#include "exact/shortest_double.hpp"
#include "minksum/error.hpp"

namespace minksum {
namespace {

/// A number for people to read, which is exact if that is short.
struct Readable {
  std::string text;
  bool exact = true;
};
Readable readable(const Rational& value) {
  constexpr std::size_t kDecimalBits = 50;   // about 15 digits
  constexpr std::size_t kFractionBits = 17;  // about 5 digits each
  for (int digits = 0; value.bits() <= kDecimalBits && digits <= 9; ++digits) {
    std::string text = value.to_decimal(digits);
    if (Rational::parse(text) == value) return {text};
  }
  if (value.bits() <= kFractionBits) return {value.to_string()};
  char buffer[kDoubleCharacters];
  return {{buffer, write_shortest(buffer, value.to_double())}, false};
}

}  // namespace

std::string to_string(const Fault& fault) {
  if (!fault.at) return fault.message;
  const Readable x = readable(fault.at->x);
  const Readable y = readable(fault.at->y);
  const char* const where = x.exact && y.exact ? " at (" : " near (";
  return fault.message + where + x.text + ", " + y.text + ")";
}

void refuse_operand(const std::string& what, int operand, Culprit place) {
  place.operand = operand;
  throw Error(ErrorCode::kBadInput, what, place);
}

void reject(const Fault& fault, int operand) {
  refuse_operand(to_string(fault), operand, fault.place);
}

void require_valid(const Region& region, int operand, const Options& options) {
  const std::vector<Fault> faults = validate(region, 1, options);
  if (!faults.empty()) reject(faults.front(), operand);
}

}  // namespace minksum
