#pragma once

#include <array>
#include <functional>
#include <vector>

#include <Eigen/Core>

#include <fairlight/stats/manifest.h>
#include <fairlight/stats/mean_test.h>

namespace fairlight {

/// A density on the unit square [0,1]^2, dimensionless. For a domain: its pdf at at(s, t), times
/// size().
using SquareDensity = std::function<double(double s, double t)>;

/// Rosenblatt's transform of a density on the unit square: (s, t) to (P(S <= s), P(T <= t | S =
/// s)). The result is uniform on the square exactly when (s, t) has that density. The marginal and
/// its distribution function are tabulated at 256 knots with a cubic between them. In t, 8-point
/// Gauss rules integrate the density, at eight values of s between two knots, with a polynomial
/// through these. So the density should be smooth except at multiples of 1/256 in s and of 1/6 in
/// t.
/// Source   Rosenblatt 1952
class Rosenblatt {
 public:
  /// Throws std::invalid_argument unless the density integrates to 1 within 1e-6.
  explicit Rosenblatt(SquareDensity density);

  /// Throws std::out_of_range unless s and t are in [0,1].
  Eigen::Vector2d operator()(double s, double t) const;

  static constexpr std::size_t nodes = 8;   ///< Gauss nodes in s, in a slab between two knots
  static constexpr std::size_t pieces = 6;  ///< parts of the unit interval in t

 private:
  // At one s: the integrals of the density from t = 0 to the end of each piece.
  using Pieces = std::array<double, pieces>;

  // The range of s between two knots: the distribution function at the first, the marginal just
  // inside both, the mass between them, and the integrals at the nodes.
  struct Slab {
    double before, first, last, mass;
    std::array<Pieces, nodes> at_nodes;
    /// Whether the polynomial in s is accurate between the nodes. Always false in the first and
    /// last slab, where a density may behave like a square root.
    bool smooth;
  };

  double integral(double s, double low, double high) const;
  Pieces pieces_at(double s) const;
  static Pieces interpolated(const Slab& slab, double x);

  SquareDensity density_;
  std::vector<Slab> slabs_;
};

/// Tests the law of a sampler exactly, by bounded moments. For the Rosenblatt transform (u, v) of a
/// draw, sqrt2 cos(j pi u), sqrt2 cos(k pi v) and 2 cos(j pi u) cos(k pi v), j, k = 1, 2, 3, all
/// have mean 0. They are orthonormal, so each mean is a component of the L2 distance between the
/// laws, and the margin is an L2 distance. It cannot see differences in higher frequencies.
/// `draw(i)` returns the coordinates (s, t) of draw i. With `replicate` > 1, that many consecutive
/// draws may depend on each other, as points of a set do, and the test uses their means; 0 throws
/// std::invalid_argument. Guarantee: exact, up to the quadrature error of 1e-6.
Finding test_rosenblatt(const Trial& trial, const SquareDensity& density,
                        const std::function<Eigen::Vector2d(std::uint64_t)>& draw, std::uint32_t replicate = 1);

}  // namespace fairlight
