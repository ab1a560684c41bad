#pragma once

#include <functional>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include <fairlight/stats/law_cells.h>
#include <fairlight/stats/manifest.h>
#include <fairlight/stats/mean_test.h>

namespace fairlight {

/// Rosenblatt's transform of a density on the unit square: (s, t) to (P(S <= s), P(T <= t | S =
/// s)). The result is uniform on the square exactly when (s, t) has that density. The marginal and
/// its distribution function are tabulated at 256 knots, and at more where two Gauss rules differ,
/// with a cubic between them. In t, 8-point Gauss rules integrate the density, at eight values of s
/// between two knots, with a polynomial through these; where two rules differ, adaptive quadrature
/// does. Of a line, only s is transformed.
/// Source   Rosenblatt 1952
class Rosenblatt {
 public:
  /// Throws CannotIntegrate for a density whose integral is not known to 1e-6, and
  /// std::invalid_argument unless it integrates to 1 within 1e-6.
  explicit Rosenblatt(SquareDensity density, const Landmarks& landmarks = {});

  /// Throws std::out_of_range unless s and t are in [0,1].
  Eigen::Vector2d operator()(double s, double t) const;

  bool of_line() const { return line_; }

  static constexpr std::size_t nodes = 8;  ///< Gauss nodes in s, in a slab between two knots

 private:
  // At one s: the integrals of the density from t = 0 to the end of each piece.
  using Pieces = std::vector<double>;

  // A range of s between two knots: the distribution function at the first, the marginal just
  // inside both and the mass between them, and the integrals at the nodes.
  struct Slab {
    double low, width, before, first, last, mass;
    std::vector<Pieces> at_nodes;
    /// Whether the polynomial in s is accurate between the nodes. Always false in the first and
    /// last slab, where a density may behave like a square root.
    bool smooth;
    bool steep;  ///< whether two Gauss rules in t differ, so that only adaptive quadrature will do
  };

  double integral(double s, double low, double high, bool steep) const;
  Pieces pieces_at(double s, bool steep) const;
  bool rules_differ(double s) const;
  void choose_pieces(const Landmarks& landmarks);
  Slab slab_of(double low, double high, bool steep) const;
  void add_slabs(double low, double high);
  static double mass_below(const Slab& slab, double x);
  static double interpolated(const Slab& slab, double x, std::size_t piece);

  SquareDensity density_;
  bool line_;
  std::vector<double> ends_;  // of the pieces in t, from 0 to 1
  std::vector<Slab> slabs_;
  double error_ = 0;  // of the sum of all masses
};

/// Tests the law of a sampler exactly, by bounded moments. For the Rosenblatt transform (u, v) of a
/// draw, sqrt2 cos(j pi u), sqrt2 cos(k pi v) and 2 cos(j pi u) cos(k pi v), j, k = 1, 2, 3, all
/// have mean 0. They are orthonormal, so each mean is a component of the L2 distance between the
/// laws. The margin holds for each component, so laws that differ in all of them may be certified at
/// sqrt(15) margins. It cannot see differences in higher frequencies. On a line there are 3 moments.
/// `draw(i)` returns the coordinates (s, t) of draw i. With `replicate` > 1, that many consecutive
/// draws may depend on each other, as points of a set do, and the test uses their means; 0 throws
/// std::invalid_argument. A draw without coordinates is lost, and has all moments 0. Guarantee:
/// exact, up to the quadrature error of 1e-6; undecided for what cannot be integrated so.
Finding test_rosenblatt(const Trial& trial, const SquareDensity& density,
                        const std::function<std::optional<Eigen::Vector2d>(std::uint64_t)>& draw,
                        std::uint32_t replicate = 1, const Landmarks& landmarks = {});

/// The moments that test_rosenblatt uses, of a place in the unit square: 15, or 3 on a line.
std::vector<double> cosine_moments(const Eigen::Vector2d& place, bool line);

}  // namespace fairlight
