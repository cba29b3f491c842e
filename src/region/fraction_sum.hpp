// Sums of fractions with many different denominators.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "machine/cancellation.hpp"
#include "region/rational_access.hpp"

namespace minksum {

struct Division {
  BigInt quotient;
  BigInt rest;
};
/// |value| divided by a positive divisor; a value that is far longer than the divisor, piece by
/// piece: Boost's division takes time quadratic in the value's length.
[[nodiscard]] Division divided(const BigInt& value, const BigInt& divisor,
                               Cancellation& cancellation);

/// A sum of fractions whose denominators are products of numbers that are known: these are counted
/// once where they are equal, and the sum is brought to lowest terms by one of them after the
/// other. The greatest common divisor of numerator and denominator as they are would take time
/// quadratic in their length, which is that of all fractions together.
class FractionSum {
 public:
  /// What denominators are made of, each as often as it comes. `cancellation` must live as long.
  FractionSum(std::vector<BigInt> factors, Cancellation& cancellation);

  /// A fraction, or the sum of some. Not in lowest terms.
  struct Term {
    BigInt numerator;
    BigInt denominator = 1;
    /// Its denominator's factors: 2i is the i-th, 2i + 1 the same again, for its square.
    std::vector<std::uint32_t> factors;
  };
  /// numerator / (a · b), of which both are factors.
  [[nodiscard]] Term term(BigInt numerator, const BigInt& a, const BigInt& b) const;
  /// The sum, in a balanced tree: a running one would be quadratic.
  [[nodiscard]] Term sum(const std::vector<Term>& terms) const;
  /// Half of it, in lowest terms.
  [[nodiscard]] Rational half(Term term) const;

 private:
  [[nodiscard]] std::uint32_t index_of(const BigInt& factor) const;
  [[nodiscard]] BigInt product(const std::vector<std::uint32_t>& factors) const;
  /// The product of some of a term's factors.
  [[nodiscard]] BigInt rest(const Term& term, const std::vector<std::uint32_t>& kept) const;
  [[nodiscard]] Term sum(const Term& a, const Term& b) const;
  [[nodiscard]] Term sum(const std::vector<Term>& terms, std::size_t first, std::size_t last) const;

  Cancellation& cancellation_;
  std::vector<BigInt> factors_;  ///< sorted, each once
};

}  // namespace minksum
