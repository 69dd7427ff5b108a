#include "random/gaussian_field.h"

#include <algorithm>
#include <cmath>
#include <complex>

namespace flyrock {

namespace {

constexpr double two_pi = 6.28318530717958647692;
using Complex = std::complex<double>;

/// The product; that of std::complex also looks for infinities.
Complex times(const Complex& a, const Complex& b) {
  return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}

/// Replaces values[begin + i stride] by their sums over i of value e^(2 pi sqrt(-1) i k / n), for a power of
/// two n = 2 roots.size() (n = 1: no roots). Cooley and Tukey, in place, in bit-reversed order first.
void transform(std::vector<Complex>& values, std::size_t begin, std::size_t stride, std::size_t n,
               const std::vector<Complex>& roots) {
  for (std::size_t i = 1, j = 0; i < n; ++i) {
    std::size_t bit = n >> 1;
    for (; j & bit; bit >>= 1) j ^= bit;
    j ^= bit;
    if (i < j) std::swap(values[begin + i * stride], values[begin + j * stride]);
  }
  for (std::size_t half = 1; half < n; half *= 2)
    for (std::size_t block = 0; block < n; block += 2 * half)
      for (std::size_t i = 0; i < half; ++i) {
        Complex& low = values[begin + (block + i) * stride];
        Complex& high = values[begin + (block + i + half) * stride];
        const Complex turned = times(high, roots[i * (n / (2 * half))]);
        high = low - turned;
        low += turned;
      }
}

std::vector<Complex> roots_of(std::size_t n) {
  std::vector<Complex> roots;
  for (std::size_t i = 0; i < n / 2; ++i) {
    const double angle = two_pi * static_cast<double>(i) / static_cast<double>(n);
    roots.emplace_back(std::cos(angle), std::sin(angle));
  }
  return roots;
}

/// The least power of two that holds `places` and four lengths more.
std::size_t period(int places, const RoughSpectrum& spectrum) {
  if (places == 1) return 1;
  const double least = places + 4 * spectrum.length / spectrum.cell;
  std::size_t n = 2;
  while (static_cast<double>(n) < least) n *= 2;
  return n;
}

/// The wave number of index i of n [rad/m]; the upper half stands for negative ones.
double wave_number(std::size_t i, std::size_t n, double cell) {
  const auto waves = static_cast<double>(std::min(i, n - i));
  return two_pi * waves / (static_cast<double>(n) * cell);
}

}  // namespace

std::vector<double> gaussian_field(int rows, int columns, const RoughSpectrum& spectrum, RandomStream& rng) {
  const std::size_t n = period(rows, spectrum), m = period(columns, spectrum);
  const double exponent = spectrum.hurst + (rows == 1 || columns == 1 ? 0.5 : 1);
  std::vector<Complex> waves(n * m);
  double total = 0;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < m; ++j) {
      const double across = wave_number(i, n, spectrum.cell), along = wave_number(j, m, spectrum.cell);
      const double k = spectrum.length * std::sqrt(across * across + along * along);
      const double power = std::pow(1 + k * k, -exponent);
      total += power;
      // A complex normal number: its real part at any place is normal with variance `power`.
      const double size = std::sqrt(-2 * power * std::log(rng.uniform()));
      const double phase = two_pi * rng.uniform();
      waves[i * m + j] = {size * std::cos(phase), size * std::sin(phase)};
    }
  const std::vector<Complex> row_roots = roots_of(n), column_roots = roots_of(m);
  for (std::size_t i = 0; i < n; ++i) transform(waves, i * m, 1, m, column_roots);
  for (std::size_t j = 0; j < static_cast<std::size_t>(columns); ++j) transform(waves, j, m, n, row_roots);
  std::vector<double> heights;
  heights.reserve(static_cast<std::size_t>(rows) * columns);
  const double scale = total > 0 ? 1 / std::sqrt(total) : 0;
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j) heights.push_back(scale * waves[i * m + j].real());
  return heights;
}

}  // namespace flyrock
