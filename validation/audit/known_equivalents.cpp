#include <algorithm>
#include <array>

#include <fairlight/validation/audit/known_equivalents.h>

namespace fairlight {
namespace {

struct Known {
  const char* file;
  const char* before;
  const char* after;
  const char* why;
};

constexpr std::array known{
    Known{"render/sphere.h", "return max(Real(-at_start * at_end), min(at_start, min(line.depth, turns)));",
          "return max(Real(-at_start / at_end), min(at_start, min(line.depth, turns)));",
          "only the sign is asked for, which a quotient has in common with a product"},
    Known{"estimators/gaussian_filter.h",
          "const Real value = select(p < Real(0.5), Real(erf(y) - p), Real(q - erfc(y)));",
          "const Real value = select(p < Real(0.51), Real(erf(y) - p), Real(q - erfc(y)));",
          "both are the same number, and near 1/2 to as many digits"},
    Known{"estimators/ggx.h", "const Real apart = (lack - drop) * height / select(sum > Real(0), sum, Real(1));",
          "const Real apart = (lack - drop) * height / select(sum > Real(0), sum, Real(1.02));",
          "where it is divided by this, the dividend is zero"},
    Known{"estimators/ggx.h",
          "const Real forward = select(along * along + across * across > Real(0), Real(-along), Real(1));",
          "const Real forward = select(along * along + across * across > Real(0), Real(-along), Real(1.02));",
          "only the angle is asked for, which is zero here at any length"},
    Known{"estimators/glossy.h", "const Real z = select(above, out.z(), Real(1));",
          "const Real z = select(above, out.z(), Real(1.02));",
          "what is not above the surface reflects nothing, whatever this is"},
    Known{"estimators/inversion.h", "const Mask<Real> near = w < Real(5);",
          "const Mask<Real> near = w < Real(5.1);",
          "from 5 to 5.1 both polynomials are within 5e-7, and steps that triple its digits begin there"},
    Known{"estimators/sphere_from_point.h",
          "return select(far, sum, Real(abs(level()) / select(sum > Real(0), sum, Real(1))));",
          "return select(far, sum, Real(abs(level()) / select(sum > Real(0), sum, Real(1.02))));",
          "where it is divided by this, the point is on the sphere and the dividend is zero"},
};

}  // namespace

std::string known_equivalence(const Mutant& mutant) {
  const auto* found = std::ranges::find_if(known, [&](const Known& k) {
    return mutant.file == k.file && mutant.before == k.before && mutant.after == k.after;
  });
  return found == known.end() ? "" : found->why;
}

}  // namespace fairlight
