#pragma once

#include <span>

namespace fairlight {

/// The greatest distance between an empirical distribution function and the uniform one, with its tails.
struct KolmogorovSmirnov {
  double distance;
  double
      too_far;  ///< at least P(D >= distance), for every n: the bound of Dvoretzky, Kiefer, Wolfowitz and Massart
  double too_near;  ///< P(D <= distance) in the limit of many draws
};

/// Numbers that should be uniform on [0,1]; at least one. Sorts them in place.
/// Throws std::invalid_argument for none, or for one outside [0,1].
/// Source: Massart 1990 (the bound 2 exp(-2 n D^2), which is also the law's leading term); Kolmogorov 1933, the
/// second form of the limiting law for the lower tail; Stephens 1970 for the correction to finite n there.
KolmogorovSmirnov kolmogorov_smirnov(std::span<double> numbers);

}  // namespace fairlight
