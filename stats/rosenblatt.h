#pragma once

#include <array>
#include <functional>
#include <vector>

#include <Eigen/Core>

#include <fairlight/stats/manifest.h>
#include <fairlight/stats/mean_test.h>

namespace fairlight {

/// A density on the unit square [0,1]^2, dimensionless; for a domain, its pdf at at(s, t) times size().
using SquareDensity = std::function<double(double s, double t)>;

/// Rosenblatt's transform of a density on the unit square: (s, t) to (P(S <= s), P(T <= t | S = s)), which is
/// uniform on the square exactly when (s, t) has that density. The marginal and its distribution function are tabulated
/// at 256 knots, with a cubic between them; in t, eight-point Gauss rules integrate the density, at eight places between two knots, with a
/// polynomial through them. So it should be smooth but at multiples of 1/256 in s and 1/6 in t. Source: Rosenblatt 1952.
class Rosenblatt {
 public:
  /// Throws std::invalid_argument when the density does not integrate to one within 1e-6.
  explicit Rosenblatt(SquareDensity density);

  /// Throws std::out_of_range unless s and t are in [0,1].
  Eigen::Vector2d operator()(double s, double t) const;

  static constexpr std::size_t nodes = 8;   ///< of a slab between two knots
  static constexpr std::size_t pieces = 6;  ///< of the unit interval in t

 private:
  // At some s, the integrals of the density from 0 to the end of each piece.
  using Pieces = std::array<double, pieces>;

  // Between two knots: the distribution function at the first, the marginal just inside both, and what the nodes have.
  struct Slab {
    double before, first, last, mass;
    std::array<Pieces, nodes> at_nodes;
    bool
        smooth;  ///< whether a polynomial has what is between the nodes; at the ends, where a density may end like a root, nobody relies on it
  };

  double integral(double s, double low, double high) const;
  Pieces pieces_at(double s) const;
  static Pieces interpolated(const Slab& slab, double x);

  SquareDensity density_;
  std::vector<Slab> slabs_;
};

/// The law of a sampler by bounded moments, exactly: of the Rosenblatt transform (u, v) of its draws, the cosines
/// sqrt2 cos(j pi u), sqrt2 cos(k pi v) and 2 cos(j pi u) cos(k pi v) for j, k up to 3 all have mean 0. They are
/// orthonormal, so a mean of a is a part of that L2 distance between the laws, and the margin is an L2 distance.
/// `draw(i)` gives the coordinates (s, t) of draw i. Draws may depend on each other within replicates of so many of them, as points of a
/// set do, where each has the law: the means of replicates are tested. Throws std::invalid_argument for one of none. Guarantee: exact, up to the quadrature (1e-6). What it cannot
/// see: a law that differs only in finer waves.
Finding test_rosenblatt(const Trial& trial, const SquareDensity& density,
                        const std::function<Eigen::Vector2d(std::uint64_t)>& draw, std::uint32_t replicate = 1);

}  // namespace fairlight
