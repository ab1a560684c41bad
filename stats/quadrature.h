#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace fairlight {

/// An integral and the quadrature's estimate of its error, in the integrand's unit times the area.
struct Integral {
  double value;
  double error;
};

/// A part [low, high] of an interval, with the integral over it.
struct Leaf {
  double low, high;
  Integral integral;
};

/// When to stop dividing an interval.
struct Subdivision {
  double tolerance;        ///< of the sum of all errors, absolute
  double largest = 1e300;  ///< a leaf with a larger integral is divided too
  std::size_t most_leaves = 400;
};

/// Integrates f over [edges.front(), edges.back()]. Divides first at the edges, which are sorted,
/// then always the part with the largest error, so jumps and integrable poles take only a few tens
/// of parts each. f is never asked at an edge. The leaves are in order; their errors may sum to
/// more than the tolerance when there are `most_leaves` of them.
/// Source   Gauss-Kronrod (7, 15) with global subdivision: QUADPACK's QAG (Piessens et al. 1983)
std::vector<Leaf> integrate_in_leaves(const std::function<double(double x)>& f, const std::vector<double>& edges,
                                      const Subdivision& stop);

/// The sum over leaves.
Integral sum_of(const std::vector<Leaf>& leaves);

/// The integral of f(x, y) over [x0, x1] x [y0, y1], by adaptive quadrature with relative tolerance
/// 1e-9, which only a smooth enough f reaches.
/// Source   nested Gauss-Kronrod (7, 15); Boost.Math
Integral integrate_rectangle(const std::function<double(double x, double y)>& f, double x0, double x1, double y0,
                             double y1);

/// The integral of f over [a, b], whose derivatives may be infinite at the ends.
/// Source: double exponential (tanh-sinh); Boost.Math.
double integrate_with_steep_ends(const std::function<double(double x)>& f, double a, double b);

}  // namespace fairlight
