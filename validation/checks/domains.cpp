#include <numbers>

#include <fairlight/validation/checks/parameters.h>

namespace fairlight {

// One row for each parameter that claims draw, with the domain that docs/estimators.md states. Keep
// the components in alphabetical order.
const std::vector<ParameterDomain>& parameter_domains() {
  constexpr double turn = 2 * std::numbers::pi;
  const std::string far = "beyond 1e-3 to 1e4 m the geometry is only scaled, as the claims `relation` do";
  const std::string shapes = "other shapes, and lights around a point, are claimed at fixed sizes";
  static const std::vector<ParameterDomain> domains{
      {"BlackmanHarrisFilter", "azimuth", "rad", 0, turn, ""},
      {"BlackmanHarrisFilter", "radius", "pixel", 1e-6, 1e6, ""},
      {"BoxFilter", "azimuth", "rad", 0, turn, ""},
      {"BoxFilter", "radius", "pixel", 1e-6, 1e6, ""},
      {"CircularAperture", "azimuth", "rad", 0, turn, ""},
      {"CircularAperture", "radius", "m", 1e-18, 1e18, ""},
      {"ConstantEnvironment", "azimuth", "rad", 0, turn, ""},
      {"ControlVariate", "constant", "1", 0.5, 1, ""},
      {"ControlVariate", "slope along x", "1", 1, 2, ""},
      {"ControlVariate", "slope along y", "1", -2, -1, ""},
      {"CosineHemisphere", "azimuth", "rad", 0, turn, ""},
      {"FresnelReflectance", "eta", "1", 0, 1e6, "no metal lies beyond, and the formula has no other branch there"},
      {"FresnelReflectance", "k", "1", 0, 1e6,
       "no metal lies far beyond, and the formula has no other branch there"},
      {"GaussianFilter", "azimuth", "rad", 0, turn, ""},
      {"GaussianFilter", "radius in deviations", "1", 1e-12, 5, "below 0.1 the filter is a box to 0.5 %"},
      {"GaussianFilter", "radius", "pixel", 1e-6, 1e6,
       "the deviation, a fifth to ten times the radius, must be in the domain too"},
      {"Importance", "constant", "1", 0.5, 1, ""},
      {"Importance", "slope along x", "1", 1, 2, ""},
      {"Importance", "slope along y", "1", -2, -1, ""},
      {"PolygonalAperture", "azimuth", "rad", 0, turn, ""},
      {"PolygonalAperture", "blades", "1", 3, 1e6, "with more than 1000 blades it is a circle to 1e-5"},
      {"PolygonalAperture", "radius", "m", 1e-18, 1e18, ""},
      {"PolygonalAperture", "rotation", "rad", -turn, turn, ""},
      {"PowerCosineLobe", "azimuth of the axis", "rad", 0, turn, ""},
      {"PowerCosineLobe", "azimuth", "rad", 0, turn, ""},
      {"PowerCosineLobe", "exponent", "1", 0, 1e8, ""},
      {"PowerCosineLobe", "height of the axis", "1", -1, 1, ""},
      {"RectangleByArea", "distance", "m", 1e-10, 1e10, far},
      {"RectangleByArea", "size / distance", "1", 1e-20, 1e20, shapes},
      {"RectangleBySolidAngle", "distance", "m", 1e-10, 1e10, far},
      {"RectangleBySolidAngle", "size / distance", "1", 1e-20, 1e20, shapes},
      {"RoughConductor", "azimuth of out", "rad", 0, turn, ""},
      {"RoughConductor", "height of out", "1", 1e-27, 1,
       "nearer to the horizon the rounding of directions is magnified, as its page says"},
      {"RoughConductor", "roughness along x", "1", 1e-4, 1, ""},
      {"RoughConductor", "roughness along y", "1", 1e-4, 1, ""},
      {"Rouletted", "constant", "1", 0.5, 1, ""},
      {"Rouletted", "slope along x", "1", 1, 2, ""},
      {"Rouletted", "slope along y", "1", -2, -1, ""},
      {"SchlickReflectance", "reflectance", "1", 0, 1, ""},
      {"SphereByArea", "distance", "m", 1e-10, 1e10, far},
      {"SphereByArea", "size / distance", "1", 1e-20, 1e20, shapes},
      {"SphereByCone", "distance", "m", 1e-10, 1e10, far},
      {"SphereByCone", "size / distance", "1", 1e-20, 1e20, shapes},
      {"SphereByVisibleHemisphere", "distance", "m", 1e-10, 1e10, far},
      {"SphereByVisibleHemisphere", "size / distance", "1", 1e-20, 1e20, shapes},
      {"Splitting", "constant", "1", 0.5, 1, ""},
      {"Splitting", "slope along x", "1", 1, 2, ""},
      {"Splitting", "slope along y", "1", -2, -1, ""},
      {"StratifiedMean", "constant", "1", 0.5, 1, ""},
      {"StratifiedMean", "slope along x", "1", 1, 2, ""},
      {"StratifiedMean", "slope along y", "1", -2, -1, ""},
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
  return domains;
}

}  // namespace fairlight
