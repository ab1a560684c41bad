#pragma once

#include <optional>
#include <type_traits>
#include <vector>

#include <fairlight/stats/law_test.h>
#include <fairlight/stats/rosenblatt.h>

namespace fairlight {

namespace detail {

/// The trial of one of the two parts of test_follows: half of alpha each.
Trial half_of(const Trial& trial);

/// The finding of both parts.
Finding both(const Finding& cells, const Finding& moments);

/// The place of a draw in the unit square of a domain; none if it is lost.
template <class Domain, class Point>
std::optional<Eigen::Vector2d> place_or_lost(const Domain& domain, const Point& x) {
  if constexpr (is_optional<Point>) {
    return x ? place_or_lost(domain, *x) : std::nullopt;
  } else {
    const Eigen::Vector2d place = domain.coordinates(x);
    return lost_share(domain) > 0 && is_outside(place) ? std::nullopt : std::optional(place);
  }
}

}  // namespace detail

/// Tests that draws follow a law: first by chi-square on cells (test_law), then by bounded moments
/// of the Rosenblatt transform (test_rosenblatt), each at half of alpha. A law whose distance is the
/// margin, in cells or in one moment, is certified with probability at most beta.
/// `law` is a density, `LawTable` or a vector of probabilities. Tables and outcomes have no moments.
/// `draw(i)` returns draw i, or an empty std::optional if it is lost.
template <class Domain, class Law, class Draw>
Finding test_follows(const Trial& trial, const Domain& domain, const Law& law, Draw&& draw) {
  if constexpr (std::is_same_v<Law, std::vector<double>>) {
    const int n = static_cast<int>(law.size());
    return test_law(trial, domain, LawTable{n, 1, law}, draw);
  } else if constexpr (std::is_same_v<Law, LawTable> || std::is_base_of_v<DiscreteDomain, Domain>) {
    return test_law(trial, domain, law, draw);
  } else {
    const Trial half = detail::half_of(trial);
    const Finding cells = test_law(half, domain, law, draw);
    if (cells.verdict != Verdict::certified) return cells;
    return detail::both(cells, detail::guarded(half, [&] {
                          const auto places = pilot_places(domain, draw);
                          const Landmarks landmarks = with_pilot(detail::landmarks_of(domain), places);
                          const double kept = 1 - detail::lost_share(domain);
                          const SquareDensity density = detail::density_on_square(domain, law);
                          return test_rosenblatt(
                              half, [&](double s, double t) { return density(s, t) / kept; },
                              [&](std::uint64_t i) { return detail::place_or_lost(domain, draw(i + pilot_draws)); },
                              1, landmarks);
                        }));
  }
}

}  // namespace fairlight
