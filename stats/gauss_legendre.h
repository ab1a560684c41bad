#pragma once

#include <array>
#include <cstddef>

namespace fairlight {

/// The Gauss-Legendre rule on [0,1] with an even number of nodes. The nodes come in pairs 1/2 -
/// reach[i] and 1/2 + reach[i], both of weight weight[i]. The weights of one half sum to 1/2.
template <std::size_t Nodes>
struct GaussLegendre {
  static_assert(Nodes % 2 == 0, "the nodes of an odd rule are not all in pairs");
  std::array<double, Nodes / 2> reach, weight;
};

/// The rule with 16, 24 or 48 nodes, from Boost.Math.
template <std::size_t Nodes>
const GaussLegendre<Nodes>& gauss_legendre();

extern template const GaussLegendre<16>& gauss_legendre<16>();
extern template const GaussLegendre<24>& gauss_legendre<24>();
extern template const GaussLegendre<48>& gauss_legendre<48>();

}  // namespace fairlight
