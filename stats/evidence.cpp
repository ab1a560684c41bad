#include <fairlight/stats/evidence.h>

namespace fairlight {

Evidence::Course::Course(const BettingTest& test)
    : sides_(test.sides()), refuting_(test.refuting()), certifying_(test.certifying()) {}

// The last step is the present state. It stays if its number is a multiple of `stride`; otherwise
// the next call replaces it. When there are too many steps, every second one is dropped.
void Evidence::Course::add(const BettingTest& test) {
  constexpr std::size_t most = 512;
  const std::uint64_t draws = test.moments().count();
  if (!steps_.empty() && steps_.back().draws == draws) return;
  if (!steps_.empty() && seen_ % stride_ != 0) steps_.pop_back();
  ++seen_;
  steps_.push_back({draws, test.moments().mean(), test.wealth()});
  if (steps_.size() <= most) return;
  std::vector<Step> kept;
  for (std::size_t i = 1; i < steps_.size(); i += 2) kept.push_back(steps_[i]);
  if (steps_.size() % 2 != 0) kept.push_back(steps_.back());
  steps_ = kept;
  stride_ *= 2;
}

}  // namespace fairlight
