// Fuzzes the `.poly` reader, from the first chain on.
#include "reader_fuzz.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return minksum::io::fuzz_reader("1\n3 out\n", data, size);
}
