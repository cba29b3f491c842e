#include "pictures/axes.hpp"

#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdlib>

namespace minksum::cli {
namespace {

// The number digit · 10^exponent. As a double, it would have no exact multiples.
struct Step {
  int digit;
  int exponent;

  // Returns the double nearest to the multiple, because that has the shortest label.
  [[nodiscard]] double times(std::int64_t factor) const {
    const std::string text = std::to_string(factor * digit) + "e" + std::to_string(exponent);
    double value = 0;
    std::from_chars(text.data(), text.data() + text.size(), value);
    return value;
  }
};

Step step_of_at_least(double apart) {
  const int exponent = static_cast<int>(std::floor(std::log10(apart)));
  for (const int digit : {1, 2, 5}) {
    const Step step{digit, exponent};
    if (step.times(1) >= apart) return step;
  }
  return {1, exponent + 1};
}

// Returns 2·10⁻⁷ for 2e-07.
std::string with_power(const std::string& number) {
  const std::size_t e = number.find('e');
  if (e == std::string::npos) return number;
  constexpr const char* kDigits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text = number.substr(0, e) == "1" ? "10" : number.substr(0, e) + "·10";
  const int power = std::stoi(number.substr(e + 1));
  if (power < 0) text += "⁻";
  for (const char digit : std::to_string(std::abs(power))) text += kDigits[digit - '0'];
  return text;
}

std::string label_of(double value) {
  constexpr double kSmall = 1e-4;
  constexpr double kLarge = 1e9;
  const double size = std::fabs(value);
  const bool plain = size == 0 || (size >= kSmall && size < kLarge);
  char buffer[64];
  const auto end =
      plain ? std::to_chars(buffer, buffer + sizeof buffer, size, std::chars_format::fixed)
            : std::to_chars(buffer, buffer + sizeof buffer, size);
  return (value < 0 ? "−" : "") + with_power(std::string(buffer, end.ptr));
}

}  // namespace

std::vector<Tick> ticks_between(double low, double high, double apart) {
  std::vector<Tick> ticks;
  if (!(apart > 0) || !std::isfinite(apart)) return ticks;
  const Step step = step_of_at_least(apart);
  const double length = step.times(1);
  const double first = std::ceil(low / length);
  const double last = std::floor(high / length);
  constexpr double kMost = 1e15;  // up to here multiples, and five times these, are exact
  if (!(length > 0) || !(std::fabs(first) < kMost) || !(std::fabs(last) < kMost)) return ticks;
  for (auto i = static_cast<std::int64_t>(first); i <= static_cast<std::int64_t>(last); ++i) {
    const double value = step.times(i);
    ticks.push_back({value, label_of(value)});
  }
  return ticks;
}

}  // namespace minksum::cli
