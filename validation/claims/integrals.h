#pragma once

#include <fairlight/estimators/importance.h>
#include <fairlight/estimators/lambertian.h>
#include <fairlight/estimators/pick_one.h>
#include <fairlight/estimators/roulette.h>
#include <fairlight/validation/checks/estimand.h>

namespace fairlight {

/// Integrals over the hemisphere, in closed form. With z = cos(theta) and dw = dz dphi, the
/// integral of z^n is 2 pi / (n + 1).

/// The height z of a direction, to a power of at least 1.
template <class Real>
Real cosine_power(const Vec3<Real>& w, int power) {
  Real product = w.z();
  for (int i = 1; i < power; ++i) product *= w.z();
  return product;
}

/// The reference of an estimator that states the bound of its draws, widened by the rounding of
/// doubles.
inline Reference reference_of(double mean, const Bound& bound) {
  const double slack = 1e-12 * std::max(std::abs(bound.lower), std::abs(bound.upper));
  return {mean, bound.lower == 0 ? 0 : bound.lower - slack, bound.upper + slack};
}

/// The estimand of such an estimator, which `make(type_identity<Real>)` gives. It tests the bound
/// too: a draw outside it is a failure.
template <class Make>
auto bounded_experiment(const std::string& name, std::vector<std::string> subjects, const std::string& statement,
                        const std::string& source, double mean, const Make& make) {
  const auto draw = [make](auto real, auto& numbers) { return make(real).estimate(numbers); };
  const Bounded auto reference = make(std::type_identity<double>{});
  return estimand(name, std::move(subjects), statement, source, {reference_of(mean, reference.bound())}, draw);
}

/// Importance sampling of z^power by the law `Directions`. `largest` is the supremum of
/// z^power / p.
template <template <class> class Directions>
auto hemisphere_integral(const std::string& name, const std::string& subject, int power, double largest) {
  const auto make = [=]<class Real>(std::type_identity<Real>) {
    return Importance(Directions<Real>{}, [=](const Vec3<Real>& w) { return cosine_power(w, power); },
                      {0, largest});
  };
  return bounded_experiment(name, {"Importance", subject},
                            "the integral of cos^" + std::to_string(power) + " over the hemisphere is 2 pi / " +
                                std::to_string(power + 1),
                            "elementary", 2 * std::numbers::pi / (power + 1), make);
}

/// Roulette with the survival probability q keeps the mean of its inner estimator.
template <class Roulette>
auto roulette_integral(const std::string& name, double q) {
  const auto make = [=]<class Real>(std::type_identity<Real>) {
    const Importance inner(CosineHemisphere<Real>{}, [](const Vec3<Real>& w) { return cosine_power(w, 2); },
                           {0, std::numbers::pi});
    return Rouletted<decltype(inner), Roulette>(inner, q);
  };
  return bounded_experiment(
      name, {"RussianRoulette", "Rouletted"},
      "the integral of cos^2 over the hemisphere is 2 pi / 3, estimated with probability " + std::to_string(q),
      "elementary; Arvo and Kirk 1990", 2 * std::numbers::pi / 3, make);
}

/// The reflectance of a Lambertian surface: the weight f cos / p of a bounce has the albedo as its
/// mean. With uniform directions it is 2 albedo cos(theta), at most twice the albedo.
template <template <class> class Directions>
auto lambertian_albedo(const std::string& name, const std::string& subject) {
  constexpr double albedo = 0.75;
  const auto draw = []<class Real>(std::type_identity<Real>, auto& source) {
    const Lambertian<Real, Directions> surface(Rgb<Real>::Constant(Real(albedo)));
    return Real(surface.sample({Real(0), Real(0), Real(1)}, next_pair<Real>(source)).weight[0]);
  };
  return estimand(name, {"Lambertian", subject}, "the weight of a bounce has the albedo as its mean", "elementary",
                  {{albedo, 0, 2 * albedo * (1 + 1e-12)}}, draw);
}

/// The two dice of the paper (A.1). The sum of a loaded die, with face k of probability k/21, and a
/// fair one has the mean 91/21 + 7/2 = 47/6. `Terms` throws both, or throws one of them and doubles
/// it.
template <class Terms>
auto two_dice(const std::string& name, std::vector<std::string> subjects) {
  const auto draw = []<class Real>(std::type_identity<Real>, auto& source) {
    const auto die = [](auto i, auto& numbers) {
      const Real u = numbers.next();
      Real loaded(1);
      for (int below = 1, face = 1; face < 6; below += ++face) {
        loaded += select(u * Real(21) >= rounded<Real>(below), Real(1), Real(0));
      }
      Real fair(1);
      for (int face = 1; face < 6; ++face) {
        fair += select(u * Real(6) >= rounded<Real>(face), Real(1), Real(0));
      }
      return Real(select(same_index<Real>(Index<Real>(i), Index<Real>(0)), loaded, fair));
    };
    return Terms::template sum<Real>(2, source, die);
  };
  return estimand(name, std::move(subjects), "two unlike dice sum to 47/6 in the mean", "the paper, A.1",
                  {{47.0 / 6, 0, 12}}, draw);
}

}  // namespace fairlight
