// Somebody else's estimator: a particle in a slab.
#include <cmath>
#include <random>

#include <fairlight/stats/rapidcheck.h>

namespace {

// A particle that enters a rod of optical thickness tau and scatters forwards or backwards with equal chance leaves
// at the far end with probability 1 / (1 + tau / 2), the solution of the two-stream equations (Schuster 1905).
double transmission(double tau) { return 1 / (1 + tau / 2); }

bool goes_through(double tau, fairlight::Generator& generator) {
  std::exponential_distribution<> free_path;
  std::bernoulli_distribution forwards(0.5);
  double x = free_path(generator);
  while (x > 0 && x < tau) x += forwards(generator) ? free_path(generator) : -free_path(generator);
  return x >= tau;
}

TEST(Slab, TransmitsWhatTheTwoStreamEquationsSay) {
  const auto particle = [](auto& generator) { return goes_through(2, generator); };
  EXPECT_UNBIASED(particle, fairlight::bounded(0.5, 0, 1), 0.01);
}

TEST(Slab, HasExponentialFreePaths) {
  const auto unit = [](auto& generator) { return std::exp(-std::exponential_distribution<>()(generator)); };
  EXPECT_FOLLOWS(
      unit, [](double) { return 1.0; }, fairlight::IntervalDomain{0, 1});
}

RC_GTEST_PROP(Slab, TransmitsAtAnyThickness, ()) {
  const double tau = *rc::gen::inRange(2, 40) * 0.25;
  const auto particle = [tau](auto& generator) { return goes_through(tau, generator); };
  RC_EXPECT_UNBIASED(particle, fairlight::bounded(transmission(tau), 0, 1), 0.2);
}

}  // namespace
