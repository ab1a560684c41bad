#include <algorithm>

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/quadrature/tanh_sinh.hpp>

#include <fairlight/stats/quadrature.h>

namespace fairlight {

Integral integrate_rectangle(const std::function<double(double x, double y)>& f, double x0, double x1, double y0,
                             double y1) {
  using Rule = boost::math::quadrature::gauss_kronrod<double, 15>;
  constexpr unsigned depth = 12;
  constexpr double tolerance = 1e-9;
  double inner_error = 0;
  auto strip = [&](double x) {
    double error = 0;
    const double value = Rule::integrate([&](double y) { return f(x, y); }, y0, y1, depth, tolerance, &error);
    inner_error = std::max(inner_error, error);
    return value;
  };
  Integral result{};
  result.value = Rule::integrate(strip, x0, x1, depth, tolerance, &result.error);
  result.error += inner_error * (x1 - x0);
  return result;
}

double integrate_with_steep_ends(const std::function<double(double x)>& f, double a, double b) {
  return boost::math::quadrature::tanh_sinh<double>().integrate(f, a, b);
}

}  // namespace fairlight
