// Compares the sums of one pair by minksum and by CGAL exactly. If they differ, finds out which is
// wrong.
#pragma once

#include <optional>
#include <string>

#include "minksum/region.hpp"

namespace minksum::oracle {

enum class Verdict {
  kEqual,
  kCgalWrong,      ///< they differ, and every point of difference proves CGAL wrong
  kMinksumWrong,   ///< some point proves minksum wrong
  kUnexplained,    ///< they differ, but no point was found that tells
  kMinksumFailed,  ///< minksum threw
  kCgalFailed,     ///< CGAL threw, crashed, or gave no boundary
  kCgalTimeout,
};
[[nodiscard]] const char* to_string(Verdict verdict);
[[nodiscard]] std::optional<Verdict> parse_verdict(const std::string& text);

struct Comparison {
  Verdict verdict = Verdict::kUnexplained;
  std::string detail;  ///< one line; for a difference: points and their membership
  double minksum_seconds = 0;
  double cgal_seconds = 0;
  std::size_t vertices = 0;  ///< vertices of the sum
  std::size_t holes = 0;
};

/// Compares in a child process, so that a crash or a time limit ends only that process. CGAL is
/// stopped after `cgal_limit` seconds of processor time.
[[nodiscard]] Comparison compare_in_child(const Region& p, const Region& q, int cgal_limit);

/// Returns whether a comparison speaks against minksum.
[[nodiscard]] bool is_failure(Verdict verdict);

/// A child process that compares, and what it has reported so far.
class Child {
 public:
  Child(const Region& p, const Region& q, int cgal_limit);
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;
  ~Child();
  /// Waits until the child ends.
  [[nodiscard]] Comparison wait();

 private:
  int process_ = -1;
  int pipe_ = -1;
};

/// Decides which sum is wrong, by points near the rings that only one of them has.
[[nodiscard]] Comparison explain(const Region& p, const Region& q, const Region& ours,
                                 const Region& theirs);

}  // namespace minksum::oracle
