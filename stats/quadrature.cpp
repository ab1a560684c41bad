#include <algorithm>
#include <cmath>

#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/quadrature/tanh_sinh.hpp>

#include <fairlight/stats/quadrature.h>

namespace fairlight {
namespace {

// Both rules of one pair: the Gauss nodes are every second Kronrod node.
Leaf one_leaf(const std::function<double(double)>& f, double low, double high) {
  using Kronrod = boost::math::quadrature::gauss_kronrod<double, 15>;
  using Gauss = boost::math::quadrature::gauss<double, 7>;
  const double middle = low + (high - low) / 2, half = (high - low) / 2;
  const double centre = f(middle);
  double kronrod = centre * Kronrod::weights()[0], gauss = centre * Gauss::weights()[0];
  for (std::size_t i = 1; i < Kronrod::weights().size(); ++i) {
    const double reach = half * Kronrod::abscissa()[i];
    const double pair = f(middle - reach) + f(middle + reach);
    kronrod += pair * Kronrod::weights()[i];
    if (i % 2 == 0) gauss += pair * Gauss::weights()[i / 2];
  }
  return {low, high, {kronrod * half, std::abs(kronrod - gauss) * half}};
}

// Nodes stay apart from the ends of their leaf: near 0 numbers are dense, elsewhere they are not.
bool divisible(const Leaf& leaf) {
  return leaf.high - leaf.low > std::max(1e-12 * std::max(std::abs(leaf.low), std::abs(leaf.high)), 1e-100);
}

}  // namespace

std::vector<Leaf> integrate_in_leaves(const std::function<double(double x)>& f, const std::vector<double>& edges,
                                      const Subdivision& stop) {
  const auto urgency = [&](const Leaf& leaf) {
    return divisible(leaf) ? leaf.integral.error + (leaf.integral.value > stop.largest ? 1e300 : 0) : 0;
  };
  const auto less_urgent = [&](const Leaf& a, const Leaf& b) { return urgency(a) < urgency(b); };
  std::vector<Leaf> leaves;
  double error = 0;
  const auto add = [&](double low, double high) {
    leaves.push_back(one_leaf(f, low, high));
    error += leaves.back().integral.error;
    std::push_heap(leaves.begin(), leaves.end(), less_urgent);
  };
  for (std::size_t i = 1; i < edges.size(); ++i) {
    if (!(edges[i] > edges[i - 1])) continue;
    const Leaf leaf = one_leaf(f, edges[i - 1], edges[i]);
    error += leaf.integral.error;
    leaves.push_back(leaf);
  }
  std::make_heap(leaves.begin(), leaves.end(), less_urgent);
  while (!leaves.empty() && leaves.size() < stop.most_leaves) {
    const Leaf worst = leaves.front();
    if (urgency(worst) == 0 || (error <= stop.tolerance && urgency(worst) < 1e300)) break;
    std::pop_heap(leaves.begin(), leaves.end(), less_urgent);
    leaves.pop_back();
    error -= worst.integral.error;
    const double middle = worst.low + (worst.high - worst.low) / 2;
    add(worst.low, middle);
    add(middle, worst.high);
  }
  std::sort(leaves.begin(), leaves.end(), [](const Leaf& a, const Leaf& b) { return a.low < b.low; });
  return leaves;
}

Integral sum_of(const std::vector<Leaf>& leaves) {
  Integral sum{0, 0};
  for (const Leaf& leaf : leaves) {
    sum.value += leaf.integral.value;
    sum.error += leaf.integral.error;
  }
  return sum;
}

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
