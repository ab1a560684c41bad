#pragma once

#include <algorithm>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

#include <fairlight/stats/domains.h>
#include <fairlight/stats/law_cells.h>

namespace fairlight {

/// What a test may be told of a domain, beside its shape: where the density jumps or has poles, and
/// which share of the draws is lost.

/// A domain, cut where the density jumps or has an integrable pole. Quadrature integrates between
/// the cuts. Cuts are coordinates of the unit square, in (0,1).
template <class Domain>
struct CutDomain : Domain {
  std::vector<double> s_cuts, t_cuts;
};

/// A domain, and the share of the draws that a sampler loses: the density integrates to 1 - lost.
/// A draw is lost if it is an empty std::optional, or lies outside the domain.
template <class Domain>
struct LosingDomain : Domain {
  double lost;
};

/// Cuts a domain at coordinates of its unit square. Throws std::invalid_argument for one outside
/// (0,1).
template <class Domain>
CutDomain<Domain> cut_at(const Domain& domain, std::vector<double> s, std::vector<double> t = {}) {
  return {domain, checked_cuts(std::move(s)), checked_cuts(std::move(t))};
}

/// The domain of a sampler that loses a share of its draws, in (0,1), such as directions below the
/// horizon. Throws std::invalid_argument for another share.
template <class Domain>
LosingDomain<Domain> losing(double share, const Domain& domain) {
  return {domain, checked_share(share)};
}

namespace detail {

template <class Domain>
Landmarks landmarks_of(const Domain& domain) {
  Landmarks landmarks;
  if constexpr (requires { domain.s_cuts; }) {
    landmarks.s = domain.s_cuts;
    landmarks.t = domain.t_cuts;
  }
  landmarks.line = requires { Domain::is_line; };
  return landmarks;
}

/// The density on the unit square, of a density with respect to the domain's measure.
template <class Domain, class Pdf>
SquareDensity density_on_square(const Domain& domain, const Pdf& pdf) {
  return [&domain, &pdf](double s, double t) {
    if constexpr (requires { domain.jacobian(s, t); }) {
      return pdf(domain.at(s, t)) * domain.jacobian(s, t);
    } else {
      return pdf(domain.at(s, t)) * domain.size();
    }
  };
}

template <class Domain>
double lost_share(const Domain& domain) {
  if constexpr (requires { domain.lost; }) return domain.lost;
  return 0;
}

template <class T>
inline constexpr bool is_optional = false;
template <class T>
inline constexpr bool is_optional<std::optional<T>> = true;

}  // namespace detail

}  // namespace fairlight
