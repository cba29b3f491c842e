// Tells JavaScript of progress: the module imports a function for it, whose address options take.
#include <minksum_c.h>

#include <cstddef>

extern "C" {

using Progress = decltype(minksum_options::progress);

__attribute__((import_module("env"), import_name("minksum_progress"))) int minksum_told(
    minksum_stage stage, std::size_t done, std::size_t parts);

Progress minksum_progress_address() {
  return [](void*, minksum_stage stage, std::size_t done, std::size_t parts) {
    return minksum_told(stage, done, parts);
  };
}

}  // extern "C"
