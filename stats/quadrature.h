#pragma once

#include <functional>

namespace fairlight {

/// An integral and the bound on its error that the quadrature states, in the integrand's unit times the area.
struct Integral {
  double value;
  double error;
};

/// The integral of f(x, y) over [x0, x1] x [y0, y1], adaptive, to relative tolerance 1e-9 where f allows it.
/// Source: Gauss-Kronrod (7, 15), nested; Boost.Math.
Integral integrate_rectangle(const std::function<double(double x, double y)>& f, double x0, double x1, double y0,
                             double y1);

}  // namespace fairlight
