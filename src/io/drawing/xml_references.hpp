// Declares what stands for other text in the attributes of XML.
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace minksum::io {

/// The references of a document: to characters, and to entities that its type declares. Those to
/// characters that XML names, such as `&amp;`, and to characters beyond ASCII stay: they are no
/// part of what is read here.
class XmlReferences {
 public:
  /// Reads the declarations that stand before the root element.
  explicit XmlReferences(std::string_view prolog);

  /// Returns a value with its references replaced, as long as this lives. Those to what is not
  /// declared stay, and those in entities nested deeper than 8. After 2^24 characters, all stay.
  [[nodiscard]] std::string_view expanded(std::string_view value);

 private:
  void append(std::string_view value, int depth, std::string& to);
  [[nodiscard]] bool append_one(std::string_view name, int depth, std::string& to);

  using Index = std::map<std::string_view, std::size_t>;
  Index entities_;  ///< in `texts_`
  Index known_;     ///< in `expanded_`
  std::vector<std::string_view> texts_;
  std::vector<std::unique_ptr<std::string>> expanded_;
  std::size_t room_ = std::size_t{1} << 24;
};

}  // namespace minksum::io
