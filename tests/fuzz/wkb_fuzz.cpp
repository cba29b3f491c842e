// Fuzzes the reader and the writer of WKB, as bytes and as hexadecimal digits.
#include "reader_fuzz.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace minksum::io;
  const std::string text(data, data + size);
  if (detect_format(text) != Format::kWkb) return 0;
  const auto geometry = try_to_read(text, [](const std::string& t) { return read_geometry(t); });
  if (geometry) require(read_geometry(to_wkb(*geometry)) == *geometry, "bytes come back equal");
  return fuzz_reader("", data, size);
}
