// Fuzzes the reader of what GDAL hands over. The first byte cuts the text; each line behind it is a
// feature: its id, properties and WKB in hexadecimal digits, with tabs between. An id that begins
// with '!' makes a length wrong.
#include <cstring>

#include "io/gdal/records.hpp"
#include "reader_fuzz.hpp"

namespace minksum::io {
namespace {

void append(std::string& text, const auto& value) {
  text.append(reinterpret_cast<const char*>(&value), sizeof value);
}

/// Takes the part of the text before the mark, and the mark.
std::string_view take(std::string_view& text, char mark) {
  const std::size_t end = std::min(text.find(mark), text.size());
  const std::string_view part = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return part;
}

int digit_of(char c) { return c >= 'a' ? c - 'a' + 10 : c - '0'; }

std::string bytes_of(std::string_view digits) {
  std::string bytes;
  for (std::size_t i = 0; i + 1 < digits.size(); i += 2) {
    bytes += static_cast<char>(16 * digit_of(digits[i]) + digit_of(digits[i + 1]));
  }
  return bytes;
}

std::string handed_over(std::string_view lines, std::uint8_t cut) {
  std::string text(gdal::kMark);
  const std::string_view code = cut % 3 == 0 ? "ESRI::102003" : "";
  append(text, gdal::System{cut % 2 == 0 ? 4326 : gdal::System::kUnnamed,
                            static_cast<std::uint32_t>(code.size())});
  text += code;
  while (!lines.empty()) {
    std::string_view line = take(lines, '\n');
    const std::string_view id = take(line, '\t');
    const std::string_view properties = take(line, '\t');
    const std::string wkb = bytes_of(line);
    gdal::Lengths lengths{id.size(), properties.size(), wkb.size()};
    if (id.starts_with('!')) lengths.wkb += std::uint64_t{1} << (id.size() * 7 % 64);
    append(text, lengths);
    text.append(id).append(properties).append(wkb);
  }
  text.resize(text.size() - std::min<std::size_t>(cut / 4, text.size()));
  return text;
}

}  // namespace
}  // namespace minksum::io

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string lines(data + 1, data + size);
  const std::string text = minksum::io::handed_over(lines, data[0]);
  return minksum::io::fuzz_reader(text, nullptr, 0);
}
