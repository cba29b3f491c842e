// Runs a fuzz target without libFuzzer: on each given seed, on every prefix of it, and on many
// small changes to it. The changes are always the same. Usage: PROGRAM ROUNDS SEED...
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include "support/random.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

void run(const std::string& text) {
  const std::vector<std::uint8_t> bytes(text.begin(), text.end());
  LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
}

// Bytes to which readers react, and some others.
constexpr std::string_view kBytes = "0123456789.-+eE/(),[]{}:\"\\ \n\t#POLYGNMTZutin\x01\x80\xFF";

std::string changed(std::string text, minksum::test::Random& random) {
  const int changes = random.between(1, 4);
  for (int i = 0; i < changes; ++i) {
    const auto place = static_cast<std::size_t>(random.below(static_cast<int>(text.size()) + 1));
    const char byte =
        kBytes[static_cast<std::size_t>(random.below(static_cast<int>(kBytes.size())))];
    switch (random.below(4)) {
      case 0:
        text.insert(place, 1, byte);
        break;
      case 1:
        text.erase(place, static_cast<std::size_t>(random.between(1, 5)));
        break;
      case 2:
        text.insert(place, text.substr(text.size() / 2, 12));
        break;
      default:
        if (place < text.size()) text[place] = byte;
    }
  }
  return text;
}

}  // namespace

int main(int argc, char** argv) {
  const int rounds = argc > 1 ? std::atoi(argv[1]) : 0;
  minksum::test::Random random(2011);
  for (int seed = 2; seed < argc; ++seed) {
    const std::string text = argv[seed];
    for (std::size_t length = 0; length <= text.size(); ++length) run(text.substr(0, length));
    for (int round = 0; round < rounds; ++round) run(changed(text, random));
  }
  return 0;
}
