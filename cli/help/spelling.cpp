#include "help/spelling.hpp"

#include <algorithm>
#include <numeric>

namespace minksum::cli {
namespace {

// Returns how many letters must be inserted, removed, replaced, or swapped with the next one, to
// make one word of the other (the optimal string alignment distance).
std::size_t edits_between(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before_last;
  std::vector<std::size_t> last(b.size() + 1);
  std::iota(last.begin(), last.end(), 0);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::vector<std::size_t> row(b.size() + 1, i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, replaced});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) row[j] = std::min(row[j], before_last[j - 2] + 1);
    }
    before_last = std::move(last);
    last = std::move(row);
  }
  return last.back();
}

}  // namespace

std::string in_lower_case(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return lower;
}

std::optional<std::string> nearest_name(std::string_view word,
                                        const std::vector<std::string>& names) {
  constexpr std::size_t kLongest = 64;  // no name is as long, and time grows with the square
  if (word.empty() || word.size() > kLongest) return {};
  const std::string typed = in_lower_case(word);
  std::optional<std::string> nearest;
  std::size_t fewest = 0;
  for (const std::string& name : names) {
    // The beginning of a name counts as one edit, however much is left out.
    const bool begun = typed.size() > 1 && name.starts_with(typed);
    const std::size_t edits = begun ? 1 : edits_between(typed, name);
    // Beyond one edit in three letters, words have little in common.
    if (edits > std::max<std::size_t>(1, std::max(typed.size(), name.size()) / 3)) continue;
    if (edits >= name.size() || (nearest && edits >= fewest)) continue;
    nearest = name;
    fewest = edits;
  }
  return nearest;
}

std::string did_you_mean(std::string_view word, const std::vector<std::string>& names,
                         const char* before) {
  const auto name = nearest_name(word, names);
  return name ? " (did you mean '" + (before + *name) + "'?)" : "";
}

}  // namespace minksum::cli
