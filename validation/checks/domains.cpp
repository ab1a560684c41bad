#include <numbers>

#include <fairlight/validation/checks/domains.h>

namespace fairlight {

namespace {

std::vector<ParameterDomain> joined(std::vector<ParameterDomain> rows, const std::vector<ParameterDomain>& more) {
  rows.insert(rows.end(), more.begin(), more.end());
  return rows;
}

}  // namespace

// One row for each parameter that claims draw, with the domain that docs/estimators.md states. Keep
// the components in alphabetical order. Lights and combinators have functions of their own.
const std::vector<ParameterDomain>& parameter_domains() {
  constexpr double turn = 2 * std::numbers::pi;
  const std::string integrand =
      "a number of the integrand, not of the component; other integrands are claimed at fixed numbers";
  static const std::vector<ParameterDomain> samplers{
      {"BlackmanHarrisFilter", "azimuth", "rad", 0, turn, ""},
      {"BlackmanHarrisFilter", "radius", "pixel", 1e-6, 1e6, ""},
      {"BoxFilter", "azimuth", "rad", 0, turn, ""},
      {"BoxFilter", "radius", "pixel", 1e-6, 1e6, ""},
      {"CircularAperture", "azimuth", "rad", 0, turn, ""},
      {"CircularAperture", "radius", "m", 1e-18, 1e18, ""},
      {"ConstantEnvironment", "azimuth", "rad", 0, turn, ""},
      {"ControlVariate", "constant", "1", -infinity<double>, infinity<double>, integrand},
      {"ControlVariate", "slope along x", "1", -infinity<double>, infinity<double>, integrand},
      {"ControlVariate", "slope along y", "1", -infinity<double>, infinity<double>, integrand},
      {"CosineHemisphere", "azimuth", "rad", 0, turn, ""},
      {"FresnelReflectance", "eta", "1", 0, 1e6, "not drawn yet: noble metals have an eta below 0.1"},
      {"FresnelReflectance", "k", "1", 0, 1e6, "not drawn yet: aluminium has a k above 4"},
      {"GaussianFilter", "azimuth", "rad", 0, turn, ""},
      {"GaussianFilter", "radius in deviations", "1", 1e-12, 5, "below 0.1 the filter is a box to 0.5 %"},
      {"GaussianFilter", "radius", "pixel", 1e-6, 1e6,
       "the deviation, a fifth to ten times the radius, must be in the domain too"},
      {"Importance", "constant", "1", -infinity<double>, infinity<double>, integrand},
      {"Importance", "slope along x", "1", -infinity<double>, infinity<double>, integrand},
      {"Importance", "slope along y", "1", -infinity<double>, infinity<double>, integrand},
      {"PolygonalAperture", "azimuth", "rad", 0, turn, ""},
      {"PolygonalAperture", "blades", "1", 3, 1e6, "with more than 1000 blades it is a circle to 1e-5"},
      {"PolygonalAperture", "radius", "m", 1e-18, 1e18, ""},
      {"PolygonalAperture", "rotation", "rad", -turn, turn, ""},
      {"PowerCosineLobe", "azimuth of the axis", "rad", 0, turn, ""},
      {"PowerCosineLobe", "azimuth", "rad", 0, turn, ""},
      {"PowerCosineLobe", "exponent", "1", 0, 1e8, ""},
      {"PowerCosineLobe", "height of the axis", "1", -1, 1, ""},
      {"RoughConductor", "azimuth of out", "rad", 0, turn, ""},
      {"RoughConductor", "height of out", "1", 1e-27, 1,
       "not drawn yet: nearer to the horizon floats magnify the rounding of directions"},
      {"RoughConductor", "roughness along x", "1", 1e-4, 1, ""},
      {"RoughConductor", "roughness along y", "1", 1e-4, 1, ""},
      {"Rouletted", "constant", "1", -infinity<double>, infinity<double>, integrand},
      {"Rouletted", "slope along x", "1", -infinity<double>, infinity<double>, integrand},
      {"Rouletted", "slope along y", "1", -infinity<double>, infinity<double>, integrand},
      {"SchlickReflectance", "reflectance", "1", 0, 1, ""},
      {"Splitting", "constant", "1", -infinity<double>, infinity<double>, integrand},
      {"Splitting", "slope along x", "1", -infinity<double>, infinity<double>, integrand},
      {"Splitting", "slope along y", "1", -infinity<double>, infinity<double>, integrand},
      {"StratifiedMean", "constant", "1", -infinity<double>, infinity<double>, integrand},
      {"StratifiedMean", "slope along x", "1", -infinity<double>, infinity<double>, integrand},
      {"StratifiedMean", "slope along y", "1", -infinity<double>, infinity<double>, integrand},
      {"TentFilter", "azimuth", "rad", 0, turn, ""},
      {"UniformCone", "1 - cos", "1", 0, 2, "narrower cones are drawn by sin^2"},
      {"UniformCone", "azimuth", "rad", 0, turn, ""},
      {"UniformCone", "sin^2", "1", 0, 1, "the domain is open at 0"},
      {"UniformHemisphere", "azimuth", "rad", 0, turn, ""},
      {"UniformSphere", "azimuth", "rad", 0, turn, ""},
      {"fresnel_conductor", "eta", "1", 0, 1e6, "the domain is open at 0"},
      {"fresnel_conductor", "k", "1", 0, 1e6, ""},
      {"fresnel_dielectric", "index", "1", 0.1, 10, "the rows from inside take the inverse of an index"},
  };
  static const std::vector<ParameterDomain> domains =
      joined(joined(samplers, domains_of_lights()), domains_of_combinators());
  return domains;
}

}  // namespace fairlight
