// Somebody else's estimator: a lambda that prices an option.
#include <cmath>
#include <random>

#include <fairlight/stats/googletest.h>

namespace {

// A European call by Black and Scholes (1973): spot 100, strike 105, rate 3 %, volatility 20 %, one year.
constexpr double spot = 100, strike = 105, rate = 0.03, volatility = 0.2;

double normal_cdf(double x) { return std::erfc(-x / std::sqrt(2.0)) / 2; }

double black_scholes() {
  const double d1 = (std::log(spot / strike) + rate + volatility * volatility / 2) / volatility;
  return spot * normal_cdf(d1) - strike * std::exp(-rate) * normal_cdf(d1 - volatility);
}

const auto call = [](auto& generator) {
  const double z = std::normal_distribution()(generator);
  const double price = spot * std::exp(rate - volatility * volatility / 2 + volatility * z);
  return std::exp(-rate) * std::max(price - strike, 0.0);
};

const auto antithetic_call = [](auto& generator) {
  const double z = std::normal_distribution()(generator);
  const auto payoff = [](double x) {
    return std::max(spot * std::exp(rate - volatility * volatility / 2 + volatility * x) - strike, 0.0);
  };
  return std::exp(-rate) * (payoff(z) + payoff(-z)) / 2;
};

TEST(Option, CostsWhatBlackAndScholesSay) { EXPECT_UNBIASED(call, black_scholes(), 0.01); }

TEST(Option, CostsTheSameByAntitheticDraws) { EXPECT_AGREE(antithetic_call, call, 0.01); }

}  // namespace
