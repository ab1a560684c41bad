#include <array>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <fairlight/estimators/packet_words.h>
#include <fairlight/estimators/sobol.h>

namespace fairlight {
namespace {

using Words = xsimd::batch<std::uint32_t>;

std::array<std::uint32_t, Words::size> any_words() {
  return *rc::gen::container<std::array<std::uint32_t, Words::size>>(rc::gen::arbitrary<std::uint32_t>());
}

RC_GTEST_PROP(PacketWords, AreMultipliedAsWideNumbersAre, ()) {
  const auto a = *rc::gen::arbitrary<std::uint32_t>();
  const auto b = any_words();
  const auto [high, low] = multiply_high_low(a, Words::load_unaligned(b.data()));
  for (std::size_t i = 0; i < Words::size; ++i) {
    const std::uint64_t product = std::uint64_t{a} * b[i];
    RC_ASSERT(high.get(i) == product >> 32);
    RC_ASSERT(low.get(i) == (product & 0xFFFFFFFFu));
  }
}

RC_GTEST_PROP(PacketWords, AreMultipliedModuloTheirLowerHalf, ()) {
  const auto a = any_words(), b = any_words();
  const Words products = multiply_halves(Words::load_unaligned(a.data()), Words::load_unaligned(b.data()));
  for (std::size_t i = 0; i < Words::size; ++i) {
    RC_ASSERT((products.get(i) & 0xFFFFu) == ((a[i] * b[i]) & 0xFFFFu));
    RC_ASSERT((multiply_halves(a[i], b[i]) & 0xFFFFu) == ((a[i] * b[i]) & 0xFFFFu));
  }
}

RC_GTEST_PROP(PacketWords, AreReversedAsOneWordIs, ()) {
  const auto words = any_words();
  const Words reversed = reverse_bits(Words::load_unaligned(words.data()));
  for (std::size_t i = 0; i < Words::size; ++i) RC_ASSERT(reversed.get(i) == reverse_bits(words[i]));
}

}  // namespace
}  // namespace fairlight
