#include "region/fraction_sum.hpp"

#include <algorithm>
#include <iterator>
#include <span>
#include <utility>

#include "exact/gcd.hpp"
#include "machine/make_room.hpp"

namespace minksum {
namespace {

using Indices = std::vector<std::uint32_t>;

// Uses a balanced tree, so that both operands of most products are about equally long.
BigInteger product_of(std::span<const BigInteger> values) {
  if (values.size() < 2) return values.empty() ? 1 : values[0];
  const std::size_t half = values.size() / 2;
  return product_of(values.first(half)) * product_of(values.subspan(half));
}

// So many factors are reduced together. One by one, the divisions of the numerator took 20 to 100
// times as long.
constexpr std::size_t kFactorsAtOnce = 16;

/// Divides a numerator and factors of its denominator by what each factor has in common with the
/// numerator. The numerator is coprime to a factor then.
void reduce(std::span<BigInteger> factors, BigInteger& numerator, Cancellation& cancellation) {
  // Modulo the product of all factors, the numerator has the same divisors in common with them. It
  // stays congruent if both are divided by such a divisor.
  BigInteger rest = divided(numerator, product_of(factors), cancellation).rest;
  BigInteger common = 1;
  for (BigInteger& factor : factors) {
    cancellation.check(8 * work_of_product(bit_length(factor)));
    const BigInteger divisor = greatest_common_divisor(rest % factor, factor);
    if (divisor == 1) continue;
    rest /= divisor;
    factor /= divisor;
    common *= divisor;
  }
  if (common != 1) numerator = divided(numerator, common, cancellation).quotient;
}

Indices without(const Indices& all, const Indices& others) {
  Indices rest;
  std::ranges::set_difference(all, others, std::back_inserter(rest));
  return rest;
}

}  // namespace

Division divided(const BigInteger& value, const BigInteger& divisor, Cancellation& cancellation) {
  constexpr std::size_t kLimbBits = 64;
  const std::size_t bits = bit_length(divisor);
  const std::size_t step = bits / kLimbBits;
  std::vector<std::uint64_t> limbs;
  if (bits <= kLimbBits || append_limbs(value, limbs) < 3 * step) {
    return divided(abs(value), divisor);
  }
  Division result;
  std::vector<std::uint64_t> quotient;
  for (std::size_t end = limbs.size(); end > 0;) {
    const std::size_t begin = end > step ? end - step : 0;
    cancellation.check(4 * work_of_product(kLimbBits * step));
    result.rest <<= static_cast<std::int64_t>(kLimbBits * (end - begin));
    result.rest += BigInteger(std::span(limbs).subspan(begin, end - begin));
    result = divided(result.rest, divisor);
    // The quotient takes no more limbs than those just divided, and replaces them.
    quotient.clear();
    append_limbs(result.quotient, quotient);
    quotient.resize(end - begin);
    std::ranges::copy(quotient, limbs.begin() + static_cast<std::ptrdiff_t>(begin));
    end = begin;
  }
  result.quotient = BigInteger(limbs);
  return result;
}

FractionSum::FractionSum(std::vector<BigInteger> factors, Cancellation& cancellation)
    : cancellation_(cancellation), factors_(std::move(factors)) {
  sort_unique(factors_, cancellation);
}

std::uint32_t FractionSum::index_of(const BigInteger& factor) const {
  const auto found = std::ranges::lower_bound(factors_, factor);
  return static_cast<std::uint32_t>(2 * (found - factors_.begin()));
}

FractionSum::Term FractionSum::term(BigInteger numerator, const BigInteger& a,
                                    const BigInteger& b) const {
  Term result{std::move(numerator), a * b, {}};
  if (a != 1) result.factors.push_back(index_of(a));
  if (b != 1) result.factors.push_back(index_of(b) + (a == b ? 1 : 0));
  std::ranges::sort(result.factors);
  return result;
}

BigInteger FractionSum::product(const Indices& factors) const {
  std::vector<BigInteger> values;
  for (const std::uint32_t factor : factors) values.push_back(factors_[factor / 2]);
  return product_of(values);
}

// Multiplies the kept factors, because a long division takes longer.
BigInteger FractionSum::rest(const Term& term, const Indices& kept) const {
  return kept.size() == term.factors.size() ? term.denominator : product(kept);
}

FractionSum::Term FractionSum::sum(const Term& a, const Term& b) const {
  const auto bits = std::max(bit_length(a.denominator), bit_length(b.denominator));
  cancellation_.check(4 * work_of_product(bits));
  const BigInteger only_a = rest(a, without(a.factors, b.factors));
  const BigInteger only_b = rest(b, without(b.factors, a.factors));
  Term result{a.numerator * only_b + b.numerator * only_a, a.denominator * only_b, {}};
  std::ranges::set_union(a.factors, b.factors, std::back_inserter(result.factors));
  return result;
}

FractionSum::Term FractionSum::sum(const std::vector<Term>& terms, std::size_t first,
                                   std::size_t last) const {
  if (first == last) return {};
  if (last - first == 1) return terms[first];
  const std::size_t middle = first + (last - first) / 2;
  return sum(sum(terms, first, middle), sum(terms, middle, last));
}

FractionSum::Term FractionSum::sum(const std::vector<Term>& terms) const {
  return sum(terms, 0, terms.size());
}

Rational FractionSum::half(Term term) const {
  std::vector<BigInteger> factors{2};
  for (const std::uint32_t factor : term.factors) factors.push_back(factors_[factor / 2]);
  if (term.numerator.is_zero()) return {};
  const bool negative = term.numerator.sign() < 0;
  term.numerator = abs(std::move(term.numerator));
  const std::span<BigInteger> all = factors;
  for (std::size_t i = 0; i < all.size(); i += kFactorsAtOnce) {
    reduce(all.subspan(i, std::min(kFactorsAtOnce, all.size() - i)), term.numerator, cancellation_);
  }
  if (negative) term.numerator = -std::move(term.numerator);
  return RationalAccess::make_reduced(std::move(term.numerator), product_of(factors));
}

}  // namespace minksum
