#pragma once

#include <fairlight/estimators/long_sum.h>
#include <fairlight/validation/checks/estimand.h>

namespace fairlight {

/// A sum of floats that has reached 2^24 ignores further numbers below 1: rounding drops each of
/// them. LongSum keeps what rounding drops, so it takes up 256 such numbers, to 2 ulp of the sum.
/// Their own sum is small and exact to a thousandth of that.
template <template <class> class Sum = LongSum>
Claim long_sum_claim() {
  const auto draw = [](std::type_identity<Packet>, auto& source) {
    const Packet before(0x1p24f);
    Sum<Packet> sum;
    sum.add(before);
    Packet late(0);
    for (int i = 0; i < 256; ++i) {
      const Packet x = source.next();
      sum.add(x);
      late += x;
    }
    return Packet(sum.value() / (before + late));
  };
  return constant_claim<Packet>(constant("long_sum.late", {"LongSum"},
                                         "a sum that is 2^24 takes up 256 numbers below 1", "Neumaier 1974", 1, 2,
                                         draw));
}

}  // namespace fairlight
