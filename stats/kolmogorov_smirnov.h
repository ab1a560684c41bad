#pragma once

#include <span>

namespace fairlight {

/// The largest distance D between an empirical distribution function and the uniform one, with its
/// tails.
struct KolmogorovSmirnov {
  double distance;
  /// An upper bound of P(D >= distance) for every n (Dvoretzky, Kiefer, Wolfowitz, Massart).
  double too_far;
  double too_near;  ///< P(D <= distance), asymptotic
};

/// Tests numbers, at least one, for being uniform on [0,1]. Sorts them in place. Throws
/// std::invalid_argument for an empty span or for a number outside [0,1].
/// Source   Massart 1990 (the bound 2 exp(-2 n D^2), also the leading term of the law); Kolmogorov
/// 1933, second form of the limiting law, for the lower tail; Stephens 1970 for its correction to
/// finite n
KolmogorovSmirnov kolmogorov_smirnov(std::span<double> numbers);

}  // namespace fairlight
