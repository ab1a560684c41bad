#include <numbers>

#include <fairlight/validation/checks/parameters.h>

namespace fairlight {

// One row for each parameter that claims draw, with the domain that docs/estimators.md states. Keep
// the components in alphabetical order.
const std::vector<ParameterDomain>& parameter_domains() {
  constexpr double turn = 2 * std::numbers::pi;
  static const std::vector<ParameterDomain> domains{
      {"BlackmanHarrisFilter", "azimuth", "rad", 0, turn, ""},
      {"BlackmanHarrisFilter", "radius", "pixel", 1e-6, 1e6, ""},
      {"BoxFilter", "azimuth", "rad", 0, turn, ""},
      {"BoxFilter", "radius", "pixel", 1e-6, 1e6, ""},
      {"CircularAperture", "azimuth", "rad", 0, turn, ""},
      {"CircularAperture", "radius", "m", 1e-18, 1e18, ""},
      {"ConstantEnvironment", "azimuth", "rad", 0, turn, ""},
      {"CosineHemisphere", "azimuth", "rad", 0, turn, ""},
      {"FresnelReflectance", "eta", "1", 0, 1e6, ""},
      {"FresnelReflectance", "k", "1", 0, 1e6, ""},
      {"GaussianFilter", "azimuth", "rad", 0, turn, ""},
      {"GaussianFilter", "radius", "pixel", 1e-6, 1e6, ""},
      {"GaussianFilter", "radius in deviations", "1", 1e-12, 5, ""},
      {"PolygonalAperture", "azimuth", "rad", 0, turn, ""},
      {"PolygonalAperture", "blades", "1", 3, 1e6, ""},
      {"PolygonalAperture", "radius", "m", 1e-18, 1e18, ""},
      {"PolygonalAperture", "rotation", "rad", -turn, turn, ""},
      {"PowerCosineLobe", "azimuth", "rad", 0, turn, ""},
      {"PowerCosineLobe", "azimuth of the axis", "rad", 0, turn, ""},
      {"PowerCosineLobe", "exponent", "1", 0, 1e8, ""},
      {"PowerCosineLobe", "height of the axis", "1", -1, 1, ""},
      {"RoughConductor", "azimuth of out", "rad", 0, turn, ""},
      {"RoughConductor", "height of out", "1", 1e-27, 1, ""},
      {"RoughConductor", "roughness along x", "1", 1e-4, 1, ""},
      {"RoughConductor", "roughness along y", "1", 1e-4, 1, ""},
      {"SchlickReflectance", "reflectance", "1", 0, 1, ""},
      {"TentFilter", "azimuth", "rad", 0, turn, ""},
      {"UniformCone", "1 - cos", "1", 0, 2, ""},
      {"UniformCone", "azimuth", "rad", 0, turn, ""},
      {"UniformCone", "half angle", "rad", 0, std::numbers::pi, ""},
      {"UniformCone", "sin^2", "1", 0, 1, ""},
      {"UniformHemisphere", "azimuth", "rad", 0, turn, ""},
      {"UniformSphere", "azimuth", "rad", 0, turn, ""},
  };
  return domains;
}

}  // namespace fairlight
