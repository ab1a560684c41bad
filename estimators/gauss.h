#pragma once

#include <cstddef>

#include <boost/math/quadrature/gauss.hpp>

#include <fairlight/estimators/real.h>

namespace fairlight {

/// The integral of f over [0,1] by the Nodes points of Gauss and Legendre, the same for all lanes; f takes a Real, to a
/// number or a colour. Source: Boost.Math has the nodes, in double.
template <class Real, unsigned Nodes, class Function>
auto integrate_unit(const Function& f) {
  using Rule = boost::math::quadrature::gauss<double, Nodes>;
  static_assert(Nodes % 2 == 0, "the nodes of an odd rule are not all in pairs");
  const auto pair = [&](std::size_t i) {
    const double reach = Rule::abscissa()[i] / 2;
    using Value = decltype(f(Real(0)));
    return Value((f(rounded<Real>(0.5 - reach)) + f(rounded<Real>(0.5 + reach))) *
                 rounded<Real>(Rule::weights()[i] / 2));
  };
  auto sum = pair(0);
  for (std::size_t i = 1; i < Nodes / 2; ++i) sum += pair(i);
  return sum;
}

}  // namespace fairlight
