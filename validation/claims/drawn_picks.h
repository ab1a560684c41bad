#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numeric>
#include <string>
#include <vector>

#include <fairlight/estimators/choose_light.h>
#include <fairlight/estimators/table.h>
#include <fairlight/validation/checks/parameters.h>

namespace fairlight {

/// Sums of terms of both signs, of which one is picked by unequal weights.

/// n terms and the weights of their choice. Weights are from a thousandth to 1, in an order that two
/// drawn phases decide. Every fifth is 0, as is its term, and every seventh is that of its
/// predecessor. The last is a twentieth of the sum, so that it counts.
struct WeighedTerms {
  std::vector<double> weights, terms;

  WeighedTerms(int n, double phase, double sign_phase) {
    constexpr double golden = 0.6180339887498949, root_of_two = 0.4142135623730951;
    const auto fraction = [](double x) { return x - std::floor(x); };
    for (int i = 0; i < n; ++i) {
      const bool black = i % 5 == 3, tie = i % 7 == 5;
      const double weight = std::pow(10, -3 * fraction(phase + i * golden));
      weights.push_back(black ? 0 : tie ? weights.back() : weight);
    }
    if (n > 1) weights.back() = 0.05 * std::accumulate(weights.begin(), weights.end() - 1, 0.0);
    for (int i = 0; i < n; ++i) {
      const double part = i + 1 == n ? 1.5 : 4 * fraction(sign_phase + i * root_of_two) - 2;
      terms.push_back(weights[static_cast<std::size_t>(i)] * part);
    }
  }

  /// One term of weight 1, and n of a millionth, which are as large together: two of three are
  /// positive.
  static WeighedTerms very_unequal(int n, double phase) {
    WeighedTerms all(1, 0, 0);
    all.weights = {1};
    all.terms = {0.5 + phase};
    for (int i = 0; i < n; ++i) {
      all.weights.push_back(1e-6);
      all.terms.push_back((i % 3 == 1 ? -1 : 1) * (0.5 + phase) / n);
    }
    return all;
  }

  double sum() const { return std::accumulate(terms.begin(), terms.end(), 0.0); }
  double sum_of_sizes() const {
    return std::accumulate(terms.begin(), terms.end(), 0.0, [](double s, double x) { return s + std::abs(x); });
  }
  double sum_of_weights() const { return std::accumulate(weights.begin(), weights.end(), 0.0); }
  /// No term over its probability is larger; nor is n times a term, if picks are uniform.
  double largest_by_weight() const {
    double most = 0;
    for (std::size_t i = 0; i < terms.size(); ++i) {
      if (weights[i] > 0) most = std::max(most, std::abs(terms[i]) / weights[i]);
    }
    return most * sum_of_weights();
  }
  double largest_of_n() const {
    double most = 0;
    for (const double term : terms) most = std::max(most, std::abs(term));
    return most * static_cast<double>(terms.size());
  }
};

/// The sums of several lists, one for each channel. `make(type_identity<Real>, list)` gives the
/// estimator of a sum in an arithmetic; it is made once for each list.
template <std::size_t n, class Make, class Largest>
auto sums_of_weighed_terms(const std::string& name, const std::vector<std::string>& subjects,
                           const std::array<WeighedTerms, n>& lists, const std::array<double, n>& scales,
                           double margin_factor, const Make& make, const Largest& largest) {
  const auto each = [&]<class Real>(std::type_identity<Real> real) {
    using Sum = decltype(make(real, lists[0]));
    struct Kept {
      Sum sum;
      Table<Real> terms;
      int size;
    };
    std::vector<Kept> kept;
    for (const WeighedTerms& list : lists)
      kept.push_back({make(real, list), Table<Real>(list.terms), static_cast<int>(list.terms.size())});
    return std::make_shared<const std::vector<Kept>>(std::move(kept));
  };
  const auto draw = [in_double = each(std::type_identity<double>{}),
                     in_packets = each(std::type_identity<Packet>{})]<class Real>(std::type_identity<Real>,
                                                                                  auto& source) {
    const auto sums = [&](const auto& kept) {
      Eigen::Array<Real, static_cast<int>(n), 1> drawn;
      for (std::size_t i = 0; i < n; ++i) {
        const auto& [sum, terms, size] = kept[i];
        auto own = source.take(2);
        const auto term = [&terms = terms](auto k, auto&) { return terms(Index<Real>(k)); };
        drawn[static_cast<int>(i)] = sum.template sum<Real>(size, own, term);
      }
      return drawn;
    };
    if constexpr (lanes<Real> == 1) {
      return sums(*in_double);
    } else {
      return sums(*in_packets);
    }
  };
  std::vector<Reference> references;
  for (std::size_t i = 0; i < n; ++i) {
    const double most = 2 * largest(lists[i]);
    references.push_back(
        {.mean = lists[i].sum(), .lower = -most, .upper = most, .scale = scales[i] * lists[i].sum_of_sizes()});
  }
  return estimand(name, subjects,
                  "one term over its probability sums terms of both signs, some with ties, some without weight",
                  "elementary; the paper, A.1", references, draw, margin_factor);
}

inline std::vector<ParameterRange> pick_ranges(const std::string& component) {
  return {{component, "phase of the weights", 0, 1}, {component, "phase of the signs", 0, 1}};
}

/// 1, 2, 3, 17 and 1000 terms.
inline std::array<WeighedTerms, 5> weighed_terms(const std::vector<double>& values) {
  const auto list = [&](int n) { return WeighedTerms(n, values[0], values[1]); };
  return {list(1), list(2), list(3), list(17), list(1000)};
}
inline constexpr std::array<double, 5> equal_scales{1, 1, 1, 1, 1};

template <template <class> class Choice>
auto picks_by_weight(const std::vector<double>& values) {
  return sums_of_weighed_terms(
      "pick.power.drawn", {"LightSampler", "PowerChoice"}, weighed_terms(values), equal_scales, 5,
      []<class Real>(std::type_identity<Real>, const WeighedTerms& list) {
        return LightSampler(Choice<Real>(list.weights));
      },
      [](const WeighedTerms& list) { return list.largest_by_weight(); });
}

inline auto picks_by_number(const std::vector<double>& values) {
  return sums_of_weighed_terms(
      "pick.one.drawn", {"UniformLightSampler", "UniformChoice"}, weighed_terms(values), equal_scales, 10,
      []<class Real>(std::type_identity<Real>, const WeighedTerms&) { return UniformLightSampler(); },
      [](const WeighedTerms& list) { return list.largest_of_n(); });
}

/// Its weights are those of a table.
template <class Real>
auto choice_by_contribution(const WeighedTerms& list) {
  const auto table = std::make_shared<const Table<Real>>(list.weights);
  const auto weight = [table](auto i) { return (*table)(Index<Real>(i)); };
  return ContributionChoice<Real, decltype(weight)>(static_cast<int>(list.weights.size()), weight);
}

inline auto picks_by_contribution(const std::vector<double>& values) {
  const auto list = [&](int n) { return WeighedTerms(n, values[0], values[1]); };
  return sums_of_weighed_terms<4>(
      "pick.contribution.drawn", {"LightSampler", "ContributionChoice"}, {list(1), list(2), list(3), list(17)},
      {1, 1, 1, 1}, 5,
      []<class Real>(std::type_identity<Real>, const WeighedTerms& terms) {
        return LightSampler(choice_by_contribution<Real>(terms));
      },
      [](const WeighedTerms& terms) { return terms.largest_by_weight(); });
}

/// A thousand lights of a millionth of the weight of one, and as bright together.
template <template <class> class Choice>
auto picks_of_faint_terms(const std::vector<double>& values) {
  return sums_of_weighed_terms<1>(
      "pick.power.faint", {"LightSampler", "PowerChoice"}, {WeighedTerms::very_unequal(1000, values[0])}, {1}, 60,
      []<class Real>(std::type_identity<Real>, const WeighedTerms& list) {
        return LightSampler(Choice<Real>(list.weights));
      },
      [](const WeighedTerms& list) { return list.largest_by_weight(); });
}

inline auto contributions_of_faint_terms(const std::vector<double>& values) {
  WeighedTerms list = WeighedTerms::very_unequal(12, values[0]);
  for (std::size_t i = 1; i < list.weights.size(); ++i) list.weights[i] = 1e-4;
  return sums_of_weighed_terms<1>(
      "pick.contribution.faint", {"LightSampler", "ContributionChoice"}, {list}, {1}, 60,
      []<class Real>(std::type_identity<Real>, const WeighedTerms& terms) {
        return LightSampler(choice_by_contribution<Real>(terms));
      },
      [](const WeighedTerms& terms) { return terms.largest_by_weight(); });
}

}  // namespace fairlight
