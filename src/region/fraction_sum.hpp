// Sums fractions with many different denominators.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "machine/cancellation.hpp"
#include "region/rational_access.hpp"

namespace minksum {

/// Divides |value| by a positive divisor. A value that is far longer than the divisor is divided
/// piece by piece, because Boost's division takes time quadratic in the value's length.
[[nodiscard]] Division divided(const BigInteger& value, const BigInteger& divisor,
                               Cancellation& cancellation);

/// Sums fractions whose denominators are products of known factors. Equal factors are counted once.
/// The sum is reduced to lowest terms by one factor after the other. The common divisor of the
/// whole numerator and denominator would take quadratic time, because they are as long as all
/// fractions together.
class FractionSum {
 public:
  /// `factors` are those of all denominators; each may be given several times. `cancellation` must
  /// live as long as this object.
  FractionSum(std::vector<BigInteger> factors, Cancellation& cancellation);

  /// A fraction, or the sum of some, not in lowest terms.
  struct Term {
    BigInteger numerator;
    BigInteger denominator = 1;
    /// Factors of the denominator: 2i is the i-th, and 2i + 1 the same once more, for its square.
    std::vector<std::uint32_t> factors;
  };
  /// Returns the fraction numerator / (a · b); a and b must be factors.
  [[nodiscard]] Term term(BigInteger numerator, const BigInteger& a, const BigInteger& b) const;
  /// Returns the sum, formed in a balanced tree, because a running sum would take quadratic time.
  [[nodiscard]] Term sum(const std::vector<Term>& terms) const;
  /// Returns half of a term, in lowest terms.
  [[nodiscard]] Rational half(Term term) const;

 private:
  [[nodiscard]] std::uint32_t index_of(const BigInteger& factor) const;
  [[nodiscard]] BigInteger product(const std::vector<std::uint32_t>& factors) const;
  /// Returns the product of some of a term's factors.
  [[nodiscard]] BigInteger rest(const Term& term, const std::vector<std::uint32_t>& kept) const;
  [[nodiscard]] Term sum(const Term& a, const Term& b) const;
  [[nodiscard]] Term sum(const std::vector<Term>& terms, std::size_t first, std::size_t last) const;

  Cancellation& cancellation_;
  std::vector<BigInteger> factors_;  ///< sorted, each once
};

}  // namespace minksum
