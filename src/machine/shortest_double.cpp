#include "machine/shortest_double.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <string>

namespace minksum {
namespace {

/// A positive number d.ddd · 10^exponent. The digits do not end with 0.
struct Digits {
  std::string digits;
  int exponent = 0;
};

std::string with_digits(double value, int count) {
  char text[kDoubleCharacters];
  const int size = std::snprintf(text, sizeof text, "%.*e", count - 1, value);
  return {text, static_cast<std::size_t>(size)};
}

bool is_read_as(const std::string& text, double value) {
  return std::strtod(text.c_str(), nullptr) == value;
}

Digits split(const std::string& text) {
  const std::size_t e = text.find('e');
  Digits result{text.substr(0, e), std::atoi(text.c_str() + e + 1)};
  std::erase(result.digits, '.');
  result.digits.resize(result.digits.find_last_not_of('0') + 1);
  return result;
}

/// Below a power of two, doubles are twice as dense as above. So the nearest number of so many
/// digits may be too low, while the next one above is read as the double.
bool next_above(std::string& text, double value) {
  int exponent = 0;
  if (std::frexp(value, &exponent) != 0.5) return false;
  for (std::size_t i = text.find('e'); i-- > 0;) {
    if (text[i] == '.') continue;
    if (text[i] != '9') {
      ++text[i];
      return is_read_as(text, value);
    }
    text[i] = '0';
  }
  return false;  // 9.99 becomes 10.0, which has fewer digits and was tried before
}

Digits shortest_digits(double value) {
  // 15 digits, and therefore fewer as well, are those of the only double that is read from them.
  const bool normal = value >= std::numeric_limits<double>::min();
  for (int count = normal ? std::numeric_limits<double>::digits10 : 1;; ++count) {
    std::string text = with_digits(value, count);
    if (is_read_as(text, value) || next_above(text, value)) return split(text);
  }
}

char* copy(const std::string& text, char* out) { return std::copy(text.begin(), text.end(), out); }

std::string scientific(const Digits& number) {
  std::string text = number.digits.substr(0, 1);
  if (number.digits.size() > 1) text += '.' + number.digits.substr(1);
  char exponent[16];
  std::snprintf(exponent, sizeof exponent, "e%c%02d", number.exponent < 0 ? '-' : '+',
                std::abs(number.exponent));
  return text + exponent;
}

/// Writes without an exponent. An integer gets its own digits, and no zeros in their place.
std::string fixed(const Digits& number, double value) {
  const int after = static_cast<int>(number.digits.size()) - 1 - number.exponent;
  if (after <= 0) {
    char text[kDoubleCharacters];
    const int size = std::snprintf(text, sizeof text, "%.0f", value);
    return {text, static_cast<std::size_t>(size)};
  }
  std::string text = number.digits;
  if (number.exponent < 0) text.insert(0, static_cast<std::size_t>(-number.exponent), '0');
  return text.insert(text.size() - static_cast<std::size_t>(after), 1, '.');
}

}  // namespace

char* write_shortest_by_search(char* out, double value) {
  if (std::signbit(value)) *out++ = '-';
  value = std::fabs(value);
  if (value == 0) return copy("0", out);
  if (std::isinf(value)) return copy("inf", out);
  const Digits number = shortest_digits(value);
  const std::string with_exponent = scientific(number);
  constexpr int kFar = 30;  // beyond this many places, an exponent is shorter
  if (std::abs(number.exponent) > kFar) return copy(with_exponent, out);
  const std::string plain = fixed(number, value);
  return copy(plain.size() <= with_exponent.size() ? plain : with_exponent, out);
}

}  // namespace minksum
