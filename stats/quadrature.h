#pragma once

#include <functional>

namespace fairlight {

/// An integral and the quadrature's estimate of its error, in the integrand's unit times the area.
struct Integral {
  double value;
  double error;
};

/// The integral of f(x, y) over [x0, x1] x [y0, y1], by adaptive quadrature with relative tolerance
/// 1e-9, which only a smooth enough f reaches.
/// Source   nested Gauss-Kronrod (7, 15); Boost.Math
Integral integrate_rectangle(const std::function<double(double x, double y)>& f, double x0, double x1, double y0,
                             double y1);

/// The integral of f over [a, b], whose derivatives may be infinite at the ends.
/// Source: double exponential (tanh-sinh); Boost.Math.
double integrate_with_steep_ends(const std::function<double(double x)>& f, double a, double b);

}  // namespace fairlight
