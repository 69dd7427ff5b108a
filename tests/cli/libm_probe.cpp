// Says what the C library's own sin and pow give for many arguments, as one number: a program without
// flyrock's functions, to show whether the C library's depend on the processor (same_bytes_test.cpp).
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>

int main() {
  std::uint64_t sum = 0;
  for (int i = 1; i < 100'000; ++i) {
    sum = 31 * sum + std::bit_cast<std::uint64_t>(std::sin(i * 0.001));
    sum = 31 * sum + std::bit_cast<std::uint64_t>(std::pow(i * 0.001, 1.37));
  }
  std::printf("%016llx\n", static_cast<unsigned long long>(sum));
}
