#include <cstdio>
#include <minksum/minksum.hpp>

#if __has_include(<boost/multiprecision/cpp_int.hpp>) && defined(BOOST_VERSION)
#error "the public headers include Boost"
#endif

minksum::Region make_square(int side);  // other.cpp

int main() {
  const minksum::Region sum = minksum::minkowski_sum(make_square(1), make_square(2));
  const bool good = sum == make_square(3) && minksum::area(sum) == minksum::Rational(9);
  std::printf("%s\n", good ? "good" : "bad");
  return good ? 0 : 1;
}
