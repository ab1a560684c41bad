#pragma once

#include <memory>
#include <numeric>

#include <fairlight/estimators/choose_light.h>
#include <fairlight/estimators/table.h>
#include <fairlight/validation/checks/estimand.h>

namespace fairlight {

/// n lights. Every third power is 0, the others are 1 to 7. A light brings to a point its power
/// times a factor between 1 - spread and 1 + spread, which the choice does not know.
struct ManyLights {
  std::vector<double> powers, terms;

  ManyLights(int n, double spread) {
    for (int i = 0; i < n; ++i) {
      powers.push_back(i % 3 == 2 ? 0 : i % 7 + 1);
      terms.push_back(powers.back() * (1 + spread * (i % 11 - 5) / 5));
    }
  }

  double sum() const { return std::accumulate(terms.begin(), terms.end(), 0.0); }
  double power() const { return std::accumulate(powers.begin(), powers.end(), 0.0); }

  /// The largest draws: n times a term, or a term over its probability by power.
  double largest_of_n() const { return UniformLightSampler::bound(bounds()).upper; }
  double largest_by_power() const {
    const double sum_of_powers = power();
    std::vector<double> probabilities;
    for (double x : powers) probabilities.push_back(x / sum_of_powers);
    return LightSampler<PowerChoice<double>>::bound(bounds(), probabilities).upper;
  }

 private:
  std::vector<Bound> bounds() const {
    std::vector<Bound> all;
    for (double term : terms) all.push_back({term, term});
    return all;
  }
};

/// The sum of the terms by an estimator from `make(type_identity<Real>)`, which is made once; `how`
/// describes it. The bound is twice the largest draw: with a single light the mean is the largest
/// draw, and must lie inside the range.
template <class Make>
auto sum_of_lights(const std::string& name, std::vector<std::string> subjects, const std::string& how,
                   const ManyLights& lights, const Make& make, double largest, double margin_factor = 1) {
  const auto each = [&]<class Real>(std::type_identity<Real> real) {
    return [sum = std::make_shared<const decltype(make(real))>(make(real)),
            terms = std::make_shared<const Table<Real>>(lights.terms),
            n = static_cast<int>(lights.terms.size())](auto& source) {
      const auto term = [&](auto i, auto&) { return (*terms)(Index<Real>(i)); };
      return sum->template sum<Real>(n, source, term);
    };
  };
  const auto draw = [in_double = each(std::type_identity<double>{}),
                     in_packets = each(std::type_identity<Packet>{})]<class Real>(std::type_identity<Real>,
                                                                                  auto& source) {
    if constexpr (lanes<Real> == 1) {
      return in_double(source);
    } else {
      return in_packets(source);
    }
  };
  return estimand(
      name, std::move(subjects),
      how + " of " + std::to_string(lights.terms.size()) + " unequal lights, a third of them black, sums them all",
      "elementary; the paper, A.1", {{lights.sum(), 0, 2 * largest}}, draw, margin_factor);
}

/// One light, picked by power.
template <template <class> class Choice>
auto sum_by_power(const std::string& name, const ManyLights& lights, double largest) {
  const auto make = [=]<class Real>(std::type_identity<Real>) { return LightSampler(Choice<Real>(lights.powers)); };
  return sum_of_lights(name, {"LightSampler", "PowerChoice"}, "one over its probability", lights, make, largest);
}

/// One light, picked by a contribution that differs from draw to draw, and so from lane to lane. At
/// a place x in [0,1), the power of every second light is multiplied by 1 + blur x.
struct OneByPlace {
  template <class Real, UniformSource<Real> Source, class Term>
  auto sum(int n, Source& source, const Term& term) const {
    const Real more = Real(1) + rounded<Real>(blur) * Real(source.next());
    const auto weight = [&](int i) {
      return Real(rounded<Real>(powers[static_cast<std::size_t>(i)]) * (i % 2 == 0 ? Real(1) : more));
    };
    return LightSampler(ContributionChoice<Real, decltype(weight)>(n, weight)).template sum<Real>(n, source, term);
  }
  std::vector<double> powers;
  double blur;
};

/// The same as an estimand.
/// Bound    the probability of a light is at least its power over (1 + blur) times the sum
inline auto sum_by_contribution(const std::string& name, const ManyLights& lights, double blur,
                                double margin_factor) {
  const auto make = [=]<class Real>(std::type_identity<Real>) { return OneByPlace{lights.powers, blur}; };
  return sum_of_lights(name, {"LightSampler", "ContributionChoice"}, "one over its probability", lights, make,
                       (1 + blur) * lights.largest_by_power(), margin_factor);
}

/// One light, picked uniformly.
inline auto sum_by_number(const std::string& name, const ManyLights& lights) {
  const auto make = []<class Real>(std::type_identity<Real>) { return UniformLightSampler(); };
  return sum_of_lights(name, {"UniformLightSampler", "UniformChoice"}, "one over its probability", lights, make,
                       lights.largest_of_n());
}

/// All lights, each with noise: a uniform draw between 0 and twice its term.
struct EachWithNoise {
  template <class Real, UniformSource<Real> Source, class Term>
  static auto sum(int n, Source& source, const Term& term) {
    const auto noisy = [&](auto i, Source& numbers) {
      return Real(Real(2) * Real(numbers.next()) * term(i, numbers));
    };
    return AllLights::sum<Real>(n, source, noisy);
  }
};

inline auto sum_of_all(const std::string& name, const ManyLights& lights) {
  const auto make = []<class Real>(std::type_identity<Real>) { return EachWithNoise(); };
  return sum_of_lights(name, {"AllLights"}, "an estimate of each", lights, make, lights.sum());
}

}  // namespace fairlight
