#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <stdexcept>
#include <string>

#include <fairlight/stats/betting_test.h>
#include <fairlight/stats/limits.h>
#include <fairlight/stats/text.h>

namespace fairlight {
namespace {

double resolved(double limit, const char* variable, double otherwise) {
  const char* text = limit == 0 ? std::getenv(variable) : nullptr;
  char* end = nullptr;
  if (text != nullptr) limit = std::strtod(text, &end);
  if (text != nullptr && (end == text || *end != '\0' || !(limit > 0)))
    throw std::invalid_argument(formatted("%s is \"%s\" (give a positive number)", variable, text));
  if (!(limit >= 0)) throw std::invalid_argument(formatted("a limit is %g (give a positive number)", limit));
  return limit == 0 ? otherwise : limit;
}

}  // namespace

Limits resolved(const Limits& limits) {
  return {resolved(limits.draws, "FAIRLIGHT_DRAWS", 1e10), resolved(limits.seconds, "FAIRLIGHT_SECONDS", 60)};
}

Meter::Meter(const Limits& limits) : limits_(resolved(limits)) {}

// Looks at the clock about once a millisecond, whatever a draw costs.
void Meter::look() {
  if (static_cast<double>(drawn_) > limits_.draws)
    throw NoMoreDraws(formatted("the cap of %g draws came first", limits_.draws));
  const Clock::time_point now = Clock::now();
  if (std::chrono::duration<double>(now - begin_).count() >= limits_.seconds)
    throw NoMoreDraws(formatted("the cap of %g s came first", limits_.seconds));
  const bool soon = now - last_ < std::chrono::milliseconds(1);
  stride_ = soon ? std::min<std::uint64_t>(2 * stride_, 1u << 20) : std::max<std::uint64_t>(stride_ / 2, 1);
  last_ = now;
  next_look_ = drawn_ + stride_;
  if (static_cast<double>(next_look_) > limits_.draws) next_look_ = static_cast<std::uint64_t>(limits_.draws) + 1;
}

}  // namespace fairlight
