#include <boost/math/quadrature/gauss.hpp>

#include <fairlight/stats/gauss_legendre.h>

namespace fairlight {

template <std::size_t Nodes>
const GaussLegendre<Nodes>& gauss_legendre() {
  static const auto rule = [] {
    // On [-1,1]; lists the nodes above 0.
    using Boost = boost::math::quadrature::gauss<double, Nodes>;
    GaussLegendre<Nodes> unit;
    for (std::size_t i = 0; i < Nodes / 2; ++i) {
      unit.reach[i] = Boost::abscissa()[i] / 2;
      unit.weight[i] = Boost::weights()[i] / 2;
    }
    return unit;
  }();
  return rule;
}

template const GaussLegendre<16>& gauss_legendre<16>();
template const GaussLegendre<24>& gauss_legendre<24>();
template const GaussLegendre<48>& gauss_legendre<48>();

}  // namespace fairlight
