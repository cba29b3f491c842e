// Declares a reader of XML that keeps the place of everything, and no copy of the text.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/drawing/xml_references.hpp"
#include "io/text_cursor.hpp"
#include "machine/cancellation.hpp"

namespace minksum::io {

/// Returns the length of a declaration, which begins with "<!", or npos if it has no end. A
/// document type may hold declarations of its own in brackets, and these may hold quotes.
[[nodiscard]] std::size_t length_of_declaration(std::string_view text);

/// An attribute. References in its value are replaced.
struct XmlAttribute {
  std::string_view name;  ///< with its prefix
  std::size_t position;   ///< of the value in the text
  std::string_view value;
};

/// An element: its tag, and where the elements end that it contains.
struct XmlElement {
  std::size_t position;  ///< of the name in the text
  std::size_t next;      ///< the index of the first element behind it that it does not contain
  std::size_t end;       ///< the position of its end tag, or of what follows an empty element
};

/// A document in the order of its text. An element's first child is the one behind it, if it is
/// before `next`. That child's `next` is the second child.
class XmlDocument {
 public:
  /// Reads all tags. Fails with line and column unless tags match.
  XmlDocument(std::string_view text, int max_depth, Cancellation& cancellation);

  [[nodiscard]] const std::vector<XmlElement>& elements() const { return elements_; }
  [[nodiscard]] const TextCursor& cursor() const { return cursor_; }
  /// Returns the name. Its prefix is dropped, unless the root declares that the prefix stands for
  /// another namespace than the root's.
  [[nodiscard]] std::string_view name(std::size_t element) const;
  [[nodiscard]] std::vector<XmlAttribute> attributes(std::size_t element) const;
  /// Returns a cursor on a value, which fails with its place in the text. Where references were
  /// replaced, it is valid until the next call.
  [[nodiscard]] TextCursor cursor_on(const XmlAttribute& attribute) const;
  /// Returns the text between the tags of an element, as it is written.
  [[nodiscard]] std::string_view content(std::size_t element) const;

 private:
  void read(int max_depth, Cancellation& cancellation);
  void find_foreign_prefixes();
  void skip_markup();
  void skip_past(std::string_view end, const char* what);
  /// Passes over a tag's attributes, and returns whether the tag ends with '/>'.
  static bool take_attributes(TextCursor& cursor, std::vector<XmlAttribute>* found);

  TextCursor cursor_;
  std::vector<XmlElement> elements_;
  std::vector<std::string_view> foreign_;  ///< prefixes that stand for other namespaces
  mutable std::optional<XmlReferences> references_;
  mutable std::string replaced_;  ///< the text with a value whose references are replaced
};

}  // namespace minksum::io
