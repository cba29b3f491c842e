#include "options/typed_numbers.hpp"

#include <charconv>
#include <optional>
#include <string_view>

#include "output/numbers.hpp"
#include "process/failure.hpp"

namespace minksum::cli {
namespace {

// Adds the zeros that Rational requires, so that options take .5 and 5. as files do.
std::string completed(std::string_view text) {
  std::string number(text);
  const std::size_t point = number.find('.');
  if (point == std::string::npos) return number;
  const auto is_digit = [&number](std::size_t at) {
    return at < number.size() && number[at] >= '0' && number[at] <= '9';
  };
  const bool before = point > 0 && is_digit(point - 1);
  const std::size_t after = point + 1;
  if (!before && is_digit(after)) {
    number.insert(point, 1, '0');
  } else if (before && (after == number.size() || number[after] == 'e' || number[after] == 'E')) {
    number.erase(point, 1);
  }
  return number;
}

// Returns whether only the size of the exponent prevents the text from being a number.
bool has_too_large_exponent(std::string_view text) {
  const std::size_t e = text.find_first_of("eE");
  if (e == std::string_view::npos || !Rational::parse(completed(text.substr(0, e)))) return false;
  std::string_view digits = text.substr(e + 1);
  if (digits.starts_with('-') || digits.starts_with('+')) digits.remove_prefix(1);
  return !digits.empty() && digits.find_first_not_of("0123456789") == std::string_view::npos;
}

std::string in_quotes(std::string_view text) {
  constexpr std::size_t kMostShown = 60;
  std::string quoted = "'";
  quoted += text.substr(0, kMostShown);
  quoted += text.size() <= kMostShown ? "'" : "...'";
  return quoted;
}

// Returns the number, or nothing if the text is not a number.
std::optional<Rational> read(const std::string& option, std::string_view text) {
  std::optional<Rational> number = Rational::parse(completed(text));
  if (!number && has_too_large_exponent(text)) {
    throw Failure(kWrongUsage, option + " takes exponents up to ±" +
                                   std::to_string(Rational::kMaxExponent) + ", not " +
                                   in_quotes(text));
  }
  return number;
}

}  // namespace

Rational parse_number(const std::string& option, const std::string& text) {
  if (const auto number = read(option, text)) return *number;
  throw Failure(kWrongUsage, option + " takes a number as 1.5 or 2/3, not " + in_quotes(text));
}

std::vector<Rational> parse_numbers(const std::string& option, const std::string& text,
                                    std::size_t count, char between, const char* example) {
  std::vector<Rational> numbers;
  std::string_view rest = text;
  while (numbers.size() < count) {
    const bool last = numbers.size() + 1 == count;
    const std::size_t end = last ? rest.size() : rest.find(between);
    if (end == std::string_view::npos) break;
    const auto number = read(option, rest.substr(0, end));
    if (!number) break;
    numbers.push_back(*number);
    rest.remove_prefix(last ? end : end + 1);
  }
  if (numbers.size() == count) return numbers;
  const std::string many = count == 2 ? "two" : std::to_string(count);
  throw Failure(kWrongUsage,
                option + " takes " + many + " numbers as " + example + ", not " + in_quotes(text));
}

Point parse_point(const std::string& option, const std::string& text) {
  const auto numbers = parse_numbers(option, text, 2, ',', "1.5,-2/3");
  return {numbers[0], numbers[1]};
}

ValueCheck between(double low, double high) {
  const auto fault = [low, high](const std::string& text) -> std::string {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool number = error == std::errc() && end == text.data() + text.size();
    if (number && value >= low && value <= high) return {};
    return "takes a number from " + shortest(low) + " to " + shortest(high) + ", not " +
           in_quotes(text);
  };
  return {fault, shortest(low) + " to " + shortest(high)};
}

}  // namespace minksum::cli
