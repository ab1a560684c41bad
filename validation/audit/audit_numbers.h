#pragma once

#include <fairlight/estimators/stream.h>
#include <fairlight/stats/manifest.h>

namespace fairlight {

/// The uniform random numbers of a trial: number `i` of stream `unit`, in [0,1).
class Numbers {
 public:
  explicit Numbers(const Trial& trial) : key_(trial.seed, trial.claim) {}
  double operator()(std::uint64_t i, std::uint32_t unit = 0) const {
    return PhiloxStream<double>(key_, unit, i).next();
  }

 private:
  StreamKey key_;
};

}  // namespace fairlight
