// Fuzzes the WKT reader, and the choice of the reader by content.
#include "reader_fuzz.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return minksum::io::fuzz_reader("", data, size);
}
