#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <fairlight/estimators/vec.h>
#include <fairlight/stats/expectation.h>

namespace fairlight {

/// A sampled direction, a unit vector, and its density [1/sr]; 0 for a single direction (delta).
struct DirectionSample {
  Vec3<double> direction;
  double pdf;
};

/// Anybody's sampler of directions, as the checks see it.
struct DirectionsUnderTest {
  std::size_t dimensions;  ///< the numbers in [0,1) that `sample` takes
  std::function<std::optional<DirectionSample>(const std::vector<double>& u)> sample;  ///< none: no direction
  std::function<double(const Vec3<double>& direction)> pdf;                            ///< [1/sr]
};

struct DirectionTerms {
  double margin = 0.05;    ///< of a cell's share of the draws, relative to an equal share
  double rounding = 1e-3;  ///< what the code's arithmetic may lose in an identity, relative
  bool whole = true;       ///< every draw has a direction with a density, which integrates to 1
};

/// The finding of one check of a component that has several.
struct PartFinding {
  std::string check;      ///< "edge numbers", "density", "law", ...
  std::string statement;  ///< what holds if it is certified
  Finding finding;
};

/// The cells of the sphere that a law of directions is tested over, with the integrals of its pdf,
/// and of three more functions, over each. A discarded pilot places them where the draws are: six by
/// six with about equally many draws, and a rim of them, which counts as one.
class CellsOfDirections {
 public:
  using Parts = Eigen::Array4d;  ///< the integrals of the pdf and of the three functions
  struct Quadrature {
    Parts value = Parts::Zero();
    double error = 0;
  };

  /// `beside(direction)` are three functions [1/sr] to integrate with the pdf.
  CellsOfDirections(const DirectionsUnderTest& law, Generator generator,
                    const std::function<Rgb<double>(const Vec3<double>&)>& beside);

  /// The integrals over the whole sphere.
  const Quadrature& all() const { return all_; }

  /// Tests that the pdf integrates to 1 (to at most 1, unless the terms say that it is whole), and that
  /// the shares of the draws in the cells are the integrals of the pdf; where it need not be whole,
  /// also the share of the draws without a density. The margin is relative to 1/36.
  /// Guarantee  exact, by betting; the error of the quadrature counts as rounding
  Finding test(const Trial& trial, const DirectionTerms& terms, Generator generator) const;

 private:
  static constexpr std::size_t cuts = 10;  // two of the rim on either side
  static constexpr std::size_t inner = 36;
  static constexpr std::size_t lost = inner + 1;
  static constexpr double equal_share = 1.0 / inner;
  using Ends = std::array<double, cuts + 1>;

  static Ends ends_for(std::vector<double> values);
  static std::size_t index(const Ends& ends, double x);
  Eigen::Vector2d place_of(const Vec3<double>& direction) const;
  Vec3<double> at(double s, double t) const;
  void place_cells(Generator& generator);
  static std::size_t cell_at(std::size_t row, std::size_t column);
  std::size_t cell_of(const std::optional<DirectionSample>& sample) const;
  std::string where(std::size_t cell) const;
  std::vector<Reference> references(bool whole) const;
  std::optional<Finding> without_draws(const Trial& trial, const DirectionTerms& terms) const;

  const DirectionsUnderTest& law_;
  double turn_ = 0;  // of the azimuths, in turns: the pilot's mean is then half a turn from the cut
  Ends heights_{};
  std::array<Ends, cuts> azimuths_{};
  std::array<Quadrature, inner + 1> cells_{};  // the last is the rim
  Quadrature all_;
};

/// A number in [0,1) from a generator.
inline double uniform(Generator& generator) { return static_cast<double>(generator() >> 11) * 0x1p-53; }

/// Tests that numbers at the edge of [0,1) give valid samples, that a sample comes with the pdf of
/// its direction, and, unless an identity is broken, the law of the draws. All share alpha. Throws
/// std::invalid_argument for terms outside their ranges.
std::vector<PartFinding> check_directions(const Trial& trial, const DirectionsUnderTest& law,
                                          const DirectionTerms& terms);

/// Throws std::invalid_argument unless there are 1 to 6 dimensions and the rounding is in (0,1).
void require_terms(std::size_t dimensions, double rounding);

/// Whether every one is certified.
bool all_certified(const std::vector<PartFinding>& findings);

/// The expectation of findings: what failed, what it says and where.
Expectation expectation_of(const Site& site, const Trial& trial, const std::vector<PartFinding>& findings);

}  // namespace fairlight
