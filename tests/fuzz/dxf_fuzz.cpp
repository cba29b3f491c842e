// Fuzzes the reader of DXF.
#include "drawing_fuzz.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return minksum::io::fuzz_drawing("0\nSECTION\n2\nENTITIES\n", "0\nENDSEC\n0\nEOF\n", data, size);
}
