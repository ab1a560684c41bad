#pragma once

#include <fairlight/estimators/long_sum.h>
#include <fairlight/validation/checks/estimand.h>

namespace fairlight {

/// A sum of floats that has reached 2^24 ignores further numbers below 1: rounding drops each of
/// them. LongSum keeps what rounding drops, so it takes up 256 such numbers, to 2 ulp of the sum.
/// Their own sum is small and exact to a thousandth of that.
template <template <class> class Sum = LongSum>
Claim long_sum_claim() {
  return {.name = "long_sum.late.packet",
          .kind = "constant",
          .subjects = {"LongSum"},
          .statement = "a sum that is 2^24 takes up 256 numbers below 1, to 2 ulp",
          .source = "Neumaier 1974",
          .margin_factor = 1,
          .check =
              [](const Trial& trial) {
                return check_constant<Packet>(trial, 1, 2, [](auto& source) {
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
                });
              },
          .real = "packet"};
}

}  // namespace fairlight
