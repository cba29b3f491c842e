#include "machine.hpp"

#include <sys/utsname.h>
#include <unistd.h>

#include <cstdlib>
#include <ctime>
#include <fstream>
#include <string>

#include "minksum/version.hpp"
#include "peers/peers.hpp"

namespace minksum::bench {
namespace {

std::string processor() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  }
  return "unknown";
}

std::string now() {
  const std::time_t time = std::time(nullptr);
  std::tm utc{};
  gmtime_r(&time, &utc);
  char text[32];
  (void)std::strftime(text, sizeof text, "%Y-%m-%d %H:%M UTC", &utc);
  return text;
}

std::string compiler() {
#if defined(__clang__)
  return "clang " __clang_version__;
#else
  return "g++ " __VERSION__;
#endif
}

}  // namespace

Json describe_run() {
  utsname system{};
  (void)uname(&system);
  double load[1] = {-1};
  (void)getloadavg(load, 1);
  const double pages = static_cast<double>(sysconf(_SC_PHYS_PAGES));
  Json json;
  json["date"] = now();
  json["processor"] = processor();
  json["processors"] = sysconf(_SC_NPROCESSORS_ONLN);
  json["memory_bytes"] = pages * static_cast<double>(sysconf(_SC_PAGESIZE));
  json["load_at_start"] = load[0];
  json["system"] = std::string(system.sysname) + " " + system.machine;
  json["compiler"] = compiler();
  json["build_type"] = MINKSUM_BENCH_BUILD_TYPE;
  json["flags"] = MINKSUM_BENCH_FLAGS;
  json["minksum"] = MINKSUM_VERSION;
  json["peers"] = {{"cgal", cgal_name()}, {"clipper", clipper_name()}, {"geos", geos_name()}};
  return json;
}

}  // namespace minksum::bench
