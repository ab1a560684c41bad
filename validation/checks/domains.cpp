#include <fairlight/validation/checks/parameters.h>

namespace fairlight {

// One row for each parameter that claims draw, with the domain that docs/estimators.md states. Keep
// the components in alphabetical order.
const std::vector<ParameterDomain>& parameter_domains() {
  const std::string far = "beyond 1e-3 to 1e4 m the geometry is only scaled, as the claims `relation` do";
  static const std::vector<ParameterDomain> domains{
      {"ControlVariate", "constant", "1", 0.5, 1, ""},
      {"ControlVariate", "slope along x", "1", 1, 2, ""},
      {"ControlVariate", "slope along y", "1", -2, -1, ""},
      {"Importance", "constant", "1", 0.5, 1, ""},
      {"Importance", "slope along x", "1", 1, 2, ""},
      {"Importance", "slope along y", "1", -2, -1, ""},
      {"RectangleByArea", "distance", "m", 1e-10, 10000000000.0, far},
      {"RectangleByArea", "size / distance", "1", 0.25, 1, ""},
      {"RectangleBySolidAngle", "distance", "m", 1e-10, 10000000000.0, far},
      {"RectangleBySolidAngle", "size / distance", "1", 0.25, 1, ""},
      {"Rouletted", "constant", "1", 0.5, 1, ""},
      {"Rouletted", "slope along x", "1", 1, 2, ""},
      {"Rouletted", "slope along y", "1", -2, -1, ""},
      {"SchlickReflectance", "reflectance", "1", 0, 1, ""},
      {"SphereByArea", "distance", "m", 1e-10, 10000000000.0, far},
      {"SphereByArea", "size / distance", "1", 0.25, 1, ""},
      {"SphereByCone", "distance", "m", 1e-10, 10000000000.0, far},
      {"SphereByCone", "size / distance", "1", 0.25, 1, ""},
      {"SphereByVisibleHemisphere", "distance", "m", 1e-10, 10000000000.0, far},
      {"SphereByVisibleHemisphere", "size / distance", "1", 0.25, 1, ""},
      {"Splitting", "constant", "1", 0.5, 1, ""},
      {"Splitting", "slope along x", "1", 1, 2, ""},
      {"Splitting", "slope along y", "1", -2, -1, ""},
      {"StratifiedMean", "constant", "1", 0.5, 1, ""},
      {"StratifiedMean", "slope along x", "1", 1, 2, ""},
      {"StratifiedMean", "slope along y", "1", -2, -1, ""},
  };
  return domains;
}

}  // namespace fairlight
