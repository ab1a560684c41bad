#pragma once

#include <fairlight/estimators/long_sum.h>
#include <fairlight/validation/checks/estimand.h>

namespace fairlight {

/// A sum of floats that has come to 2^24 takes no more numbers below 1: each is rounded off. One that keeps what is rounded off
/// takes 256 of them up, to 2 ulp of it; their own sum, which is small, is good to a thousandth of that.
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
