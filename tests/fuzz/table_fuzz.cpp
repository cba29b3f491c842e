// Fuzzes the reader of tables.
#include "reader_fuzz.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return minksum::io::fuzz_reader("wkt,name\n", data, size);
}
