// The program compiles this file once for double, and once for each instruction set.

#include <array>
#include <limits>
#include <stdexcept>

#include <fairlight/estimators/sobol.h>
#include <fairlight/validation/checks/numbers.h>
#include <fairlight/validation/checks/pairs.h>

namespace fairlight {
namespace {

// Pairs in double, made several at a time in packets of words. They equal those made one at a time.
class PairsAtOnce {
 public:
  explicit PairsAtOnce(const StreamKey& key) : key_(key) {}

  Vec2<double> operator()(std::uint64_t i) {
    if (made_ != i / n) make(i / n);
    return pairs_[i % n];
  }

 private:
  static constexpr std::size_t n = lanes<Packet>;

  void make(std::uint64_t number) {
    using W = Word<Packet>;
    const std::uint64_t first = number * n;
    const W samples = W(static_cast<std::uint32_t>(first)) + lane_numbers<W::arch_type>();
    const auto block = Philox<W>::draw({W(0u), samples, W(static_cast<std::uint32_t>(first >> 32)), W(0u)},
                                       {W(key_.words()[0]), W(key_.words()[1])});
    std::array<std::array<std::uint32_t, n>, 4> words;
    for (std::size_t k = 0; k < words.size(); ++k) block[k].store_unaligned(words[k].data());
    for (std::size_t i = 0; i < n; ++i) {
      pairs_[i] = {unit_number_of_halves(words[2][i], words[3][i]),
                   unit_number_of_halves(words[0][i], words[1][i])};
    }
    made_ = number;
  }

  StreamKey key_;
  std::array<Vec2<double>, n> pairs_;
  std::uint64_t made_ = std::numeric_limits<std::uint64_t>::max();
};

template <class Source>
auto pair_of(Source source) {
  const auto first = source.next();
  return Vec2<std::remove_const_t<decltype(first)>>(first, source.next());
}

}  // namespace

template <class Real>
Pairs<Real> independent_pairs(const StreamKey& key) {
  if constexpr (lanes<Real> == 1) {
    return PairsAtOnce(key);
  } else {
    return [key](std::uint64_t i) { return pair_of(PhiloxStream<Real>(key, 0, i)); };
  }
}

template <class Real>
Pairs<Real> point_pairs(const StreamKey& key, std::uint32_t n) {
  if (n % lanes<Real> != 0)
    throw std::invalid_argument("a replicate must fill whole packets (give a multiple of lanes)");
  return [key, n](std::uint64_t i) {
    const OwenSobol<Real> set(key, number_in_key(i / n, "replicates"), n);
    return pair_of(set.source(static_cast<std::uint32_t>(i % n)));
  };
}

template Pairs<Packet> independent_pairs(const StreamKey&);
template Pairs<Packet> point_pairs(const StreamKey&, std::uint32_t);
#if !defined(FAIRLIGHT_ENTRY)
template Pairs<double> independent_pairs(const StreamKey&);
template Pairs<double> point_pairs(const StreamKey&, std::uint32_t);
#endif

}  // namespace fairlight
