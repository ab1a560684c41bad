#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <fairlight/validation/checks/direction_checks.h>

namespace fairlight {

/// What a BSDF's `sample` returns. Directions are unit vectors in the local frame of the surface,
/// whose normal is +z; `out` points to the viewer, `in` to where the light comes from.
struct BsdfSample {
  Vec3<double> in;
  Rgb<double> weight;  ///< f |cos(in)| / pdf
  double pdf;          ///< of `in` [1/sr]; 0 for a single direction (mirror, glass)
};

/// Anybody's BSDF, as the checks see it.
struct BsdfUnderTest {
  std::size_t dimensions;  ///< the numbers in [0,1) that `sample` takes
  /// None where the light is absorbed, or the sample would be on a side that the surface has not.
  std::function<std::optional<BsdfSample>(const Vec3<double>& out, const std::vector<double>& u)> sample;
  std::function<Rgb<double>(const Vec3<double>& out, const Vec3<double>& in)>
      eval;                                                                    ///< f without the cosine [1/sr]
  std::function<double(const Vec3<double>& out, const Vec3<double>& in)> pdf;  ///< [1/sr]
};

/// What is claimed of a BSDF beyond that its three functions fit together.
struct BsdfTerms {
  double margin = 0.05;    ///< of a cell's share of the draws, relative to an equal share
  double rounding = 1e-3;  ///< what the code's arithmetic may lose, relative
  bool both_sides = true;  ///< whether `out` may be below the surface
  bool reciprocal = true;  ///< f(a, b) = f(b, a); not for refraction, which scales radiance
  bool passive = true;     ///< reflects no more than it gets; not where radiance is scaled
  /// The mean weight for a viewer at `out`, per channel, where it is known in closed form; needs
  /// `largest_weight`.
  std::function<Rgb<double>(const Vec3<double>& out)> albedo{};
  double largest_weight = 0;  ///< no weight is above it
};

/// Tests that the three functions of a BSDF fit together, over outgoing directions drawn anew:
/// identities at every draw (check_bsdf_identities), then for some directions the law of the draws
/// and the energy (check_bsdf_laws). All checks share alpha equally. The checks of laws are left out
/// where an identity is broken, as they would say the same less plainly. Throws
/// std::invalid_argument for terms outside their ranges.
std::vector<PartFinding> check_bsdf(const Trial& trial, const BsdfUnderTest& bsdf, const BsdfTerms& terms);

/// Identities: numbers at the edge of [0,1) give a valid sample; all values are finite and none is
/// negative; the pdf of a sample is `pdf`; its weight is f |cos| / pdf; a single direction has
/// neither f nor pdf; f is 0 where the pdf is; f is reciprocal.
/// Guarantee  exact: a violation in a share of the draws that the note gives would have been met,
///            but for the miss rate
std::vector<PartFinding> check_bsdf_identities(const Trial& trial, const BsdfUnderTest& bsdf,
                                               const BsdfTerms& terms);

/// Laws: for each of six directions, the shares of the draws in cells of directions, and of those
/// without a density, are the integrals of the pdf; f |cos| integrates to 1 at most; the mean weight
/// is the stated albedo.
/// Guarantee  exact, by betting; the pdf's integrals are by quadrature, whose error counts as
///            rounding
std::vector<PartFinding> check_bsdf_laws(const Trial& trial, const BsdfUnderTest& bsdf, const BsdfTerms& terms);

/// A random direction above the surface, or below it where `side` < 0. The logarithm of its height
/// is uniform from `lowest` to `highest`.
Vec3<double> drawn_direction(double lowest, double highest, double side, const std::function<double()>& next);

/// Six directions, three to a side: steep, oblique, grazing.
std::vector<Vec3<double>> directions_of_laws(const BsdfTerms& terms, const std::function<double()>& next);

}  // namespace fairlight
