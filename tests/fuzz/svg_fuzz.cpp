// Fuzzes the reader of SVG.
#include "drawing_fuzz.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return minksum::io::fuzz_drawing("<svg>", "</svg>", data, size);
}
