#include "exact/shortest_double.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <string>

#include "exact/big_integer.hpp"

namespace minksum {
namespace {

/// The number d.ddd · 10^exponent.
struct Digits {
  std::string digits;
  int exponent = 0;
};

/// The number value · 10^places as a fraction. All of it is exact.
class ScaledDouble {
 public:
  ScaledDouble(double value, int places) {
    int exponent = 0;
    const double fraction = std::frexp(value, &exponent);
    // A denormal has fewer digits, and the unit of the last one of the least normal number.
    exponent = std::max(exponent, std::numeric_limits<double>::min_exponent) -
               std::numeric_limits<double>::digits;
    const auto digits = static_cast<std::int64_t>(std::ldexp(value, -exponent));
    scale(unit_, denominator_, exponent, places);
    numerator_ = unit_ * BigInteger(digits);
    // A double that is read from a number half way between two is the one whose last digit is even.
    ends_belong_ = digits % 2 == 0;
    // Below a power of two, doubles are twice as dense as above.
    dense_below_ = fraction == 0.5 && value > std::numeric_limits<double>::min();
  }
  [[nodiscard]] BigInteger floor() const { return numerator_ / denominator_; }
  /// Tells whether number / 10^places is read as the double.
  [[nodiscard]] bool is_read_from(std::int64_t number) const {
    const BigInteger above = BigInteger(number) * denominator_ - numerator_;
    const int doublings = dense_below_ && above.sign() < 0 ? 2 : 1;
    const auto order = (abs(above) << doublings) <=> unit_;
    return order < 0 || (order == 0 && ends_belong_);
  }
  /// Returns the sign of number / 2 less value · 10^places.
  [[nodiscard]] int compare_half(std::int64_t number) const {
    return (BigInteger(number) * denominator_ - (numerator_ << 1)).sign();
  }

 private:
  BigInteger unit_ = 1;  ///< of the double's last binary digit, over the denominator
  BigInteger numerator_;
  BigInteger denominator_ = 1;
  bool ends_belong_;
  bool dense_below_;
};

Digits shortest_digits(double value) {
  constexpr int kMost = std::numeric_limits<double>::max_digits10;
  // Above log10(2) = 0.30102999..., so this is the decimal exponent or one less.
  const int least = static_cast<int>(std::floor(std::ilogb(value) * 0.30103));
  const ScaledDouble scaled(value, kMost - 1 - least);
  const auto floor = static_cast<std::int64_t>(scaled.floor());
  const auto first = static_cast<int>(std::to_string(floor).size());
  // 15 digits, and therefore fewer as well, are those of the only double that is read from them.
  const bool normal = value >= std::numeric_limits<double>::min();
  std::int64_t step = 1;
  for (int i = normal ? std::numeric_limits<double>::digits10 : 1; i < first; ++i) step *= 10;
  for (;; step /= 10) {
    const std::int64_t low = floor - floor % step;
    const int half = scaled.compare_half(2 * low + step);
    const bool up = half < 0 || (half == 0 && low / step % 2 != 0);
    // Above a power of two, a number farther off may be read as the double.
    const std::int64_t number = up || !scaled.is_read_from(low) ? low + step : low;
    if (!scaled.is_read_from(number)) continue;
    Digits result{std::to_string(number), 0};
    result.exponent = least + static_cast<int>(result.digits.size()) - kMost;
    result.digits.resize(result.digits.find_last_not_of('0') + 1);
    return result;
  }
}

char* copy(const std::string& text, char* out) { return std::copy(text.begin(), text.end(), out); }

std::string scientific(const Digits& number) {
  std::string text = number.digits.substr(0, 1);
  if (number.digits.size() > 1) text += '.' + number.digits.substr(1);
  const int exponent = std::abs(number.exponent);
  text += number.exponent < 0 ? "e-" : "e+";
  if (exponent < 10) text += '0';
  return text + std::to_string(exponent);
}

/// Writes without an exponent. An integer gets its own digits, and no zeros in their place.
std::string fixed(const Digits& number, double value) {
  const int after = static_cast<int>(number.digits.size()) - 1 - number.exponent;
  if (after <= 0) return ScaledDouble(value, 0).floor().to_string();
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
