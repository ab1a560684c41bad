#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <stdexcept>
#include <string>

#include <boost/multiprecision/cpp_int.hpp>

#include <fairlight/stats/exact_moments.h>

namespace fairlight {
namespace {

using boost::multiprecision::cpp_int;
__extension__ using Uint128 = unsigned __int128;

constexpr int unit_exponent = ExactSums::finest;
constexpr std::size_t sum_begin = 1;
constexpr std::size_t squares_begin = 4;

// words += addend << (64 place). Returns true if the top word overflows.
bool add_at(std::span<std::uint64_t> words, std::size_t place, Uint128 addend) {
  while (addend != 0) {
    if (place == words.size()) return true;
    const Uint128 sum = Uint128{words[place]} + static_cast<std::uint64_t>(addend);
    words[place++] = static_cast<std::uint64_t>(sum);
    addend = (addend >> 64) + (sum >> 64);
  }
  return false;
}

// words += value << shift, for a value of at most 106 bits. Returns true on overflow.
bool add_shifted(std::span<std::uint64_t> words, Uint128 value, int shift) {
  const auto place = static_cast<std::size_t>(shift / 64);
  const int bits = shift % 64;
  const Uint128 low = Uint128{static_cast<std::uint64_t>(value)} << bits;
  const Uint128 high = Uint128{static_cast<std::uint64_t>(value >> 64)} << bits;
  const bool over = add_at(words, place, low);
  return add_at(words, place + 1, high) || over;
}

// x as significand * 2^exponent in units of 2^-96, exponent >= 0, rounded half to even.
struct Quantised {
  std::uint64_t significand;
  int exponent;
};

Quantised quantise(double x) {
  int exponent = 0;
  const double fraction = std::frexp(x, &exponent);
  const auto significand = static_cast<std::uint64_t>(std::ldexp(fraction, 53));
  const int shift = exponent - 53 - unit_exponent;
  if (shift >= 0) return {significand, shift};
  return {static_cast<std::uint64_t>(std::nearbyint(std::ldexp(x, -unit_exponent))), 0};
}

[[noreturn]] void refuse(double x) {
  throw std::domain_error("a draw is " + std::to_string(x) + " (it must be a number in [0, 2^64))");
}

[[noreturn]] void refuse_sum() {
  throw std::overflow_error("the sum of the draws exceeds 2^96 (merge fewer, or scale the scene down)");
}

cpp_int integer(std::span<const std::uint64_t> words) {
  cpp_int value;
  import_bits(value, words.begin(), words.end(), 64, false);
  return value;
}

}  // namespace

void ExactMoments::add(double x) {
  if (!(x >= 0 && x < 0x1p64)) refuse(x);
  ++words_[0];
  if (x == 0) return;
  const auto [significand, exponent] = quantise(x);
  const std::span<std::uint64_t> all(words_);
  const bool over = add_shifted(all.subspan(sum_begin, 3), significand, exponent) ||
                    add_shifted(all.subspan(squares_begin, 6), Uint128{significand} * significand, 2 * exponent);
  if (over) refuse_sum();
}

void ExactMoments::add(std::span<const double> draws) {
  for (double x : draws) {
    if (!(x >= 0 && x < 0x1p64)) refuse(x);
  }
  for (double x : draws) add(x);
}

void ExactMoments::add_in_parts(std::span<const float> draws) {
  for (float x : draws) {
    if (!(x >= 0 && x < 0x1p64F)) refuse(static_cast<double>(x));
  }
  for (; !draws.empty(); draws = draws.subspan(std::min(ExactSums::most, draws.size()))) {
    const std::span<const float> part = draws.first(std::min(ExactSums::most, draws.size()));
    if (const auto sums = ExactSums::of(part)) {
      add(*sums);
    } else {
      for (float x : part) add(static_cast<double>(x));
    }
  }
}

void ExactMoments::add(const ExactSums& draws) {
  const std::span<std::uint64_t> all(words_);
  const int shift = draws.unit() - unit_exponent;
  words_[0] += draws.count();
  const bool over = add_shifted(all.subspan(sum_begin, 3), static_cast<Uint128>(draws.sum()), shift) ||
                    add_shifted(all.subspan(squares_begin, 6), static_cast<Uint128>(draws.squares()), 2 * shift);
  if (over) refuse_sum();
}

void ExactMoments::merge(ExactMoments other) {  // by value, so that x.merge(x) works
  words_[0] += other.words_[0];
  bool over = false;
  const auto merge_words = [&](std::size_t begin, std::size_t size) {
    const std::span<std::uint64_t> mine = std::span(words_).subspan(begin, size);
    for (std::size_t i = 0; i < size; ++i) over = add_at(mine, i, other.words_[begin + i]) || over;
  };
  merge_words(sum_begin, 3);
  merge_words(squares_begin, 6);
  if (over) refuse_sum();
}

double ExactMoments::mean() const {
  if (count() == 0) return 0;
  const cpp_int sum = integer(std::span(words_).subspan(sum_begin, 3));
  return std::ldexp(sum.convert_to<double>(), unit_exponent) / static_cast<double>(count());
}

double ExactMoments::variance() const {
  if (count() < 2) return std::numeric_limits<double>::infinity();
  const cpp_int sum = integer(std::span(words_).subspan(sum_begin, 3));
  const cpp_int squares = integer(std::span(words_).subspan(squares_begin, 6));
  const cpp_int numerator = count() * squares - sum * sum;
  const auto n = static_cast<double>(count());
  return std::ldexp(numerator.convert_to<double>(), 2 * unit_exponent) / (n * (n - 1));
}

double ExactMoments::standard_error() const {
  if (count() < 2) return std::numeric_limits<double>::infinity();
  return std::sqrt(variance() / static_cast<double>(count()));
}

}  // namespace fairlight
