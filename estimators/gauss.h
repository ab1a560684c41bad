#pragma once

#include <cstddef>

#include <fairlight/estimators/real.h>
#include <fairlight/stats/gauss_legendre.h>

namespace fairlight {

/// Integrates f over [0,1] with the Gauss-Legendre rule of `Nodes` points, the same points in all
/// lanes. f maps a Real to a number or a colour.
template <class Real, std::size_t Nodes, class Function>
auto integrate_unit(const Function& f) {
  const GaussLegendre<Nodes>& rule = gauss_legendre<Nodes>();
  const auto pair = [&](std::size_t i) {
    using Value = decltype(f(Real(0)));
    return Value((f(rounded<Real>(0.5 - rule.reach[i])) + f(rounded<Real>(0.5 + rule.reach[i]))) *
                 rounded<Real>(rule.weight[i]));
  };
  auto sum = pair(0);
  for (std::size_t i = 1; i < Nodes / 2; ++i) sum += pair(i);
  return sum;
}

}  // namespace fairlight
